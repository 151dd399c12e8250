#![doc = include_str!("impact.md")]

use super::materials::{contact, material_index, materials};
use super::other_kind::refuse_other_kind;
use super::quantity::Kind;
use super::reader::{Context, Item, TableReader};
use super::schema::FileKind;
use super::{ContactSpec, Diagnostics, document::Value, lone_fault, read_text, tree};
use crate::materials::{Material, Materials, PairChoice};
use demeter_physics::collision::Start;
use demeter_physics::contact::normal::{Normal, NormalVisitor};
use demeter_physics::contact::{PairLaw, PairSize};
use demeter_physics::dimension::Dimension;
use demeter_physics::parameters::Range;
use glam::DVec3;
use std::f64::consts::{FRAC_PI_2, PI};
use std::path::Path;

/// All keys of such a file, with their meaning.
pub const IMPACT_REFERENCE: &str = include_str!("impact.md");

/// Most points of a curve.
pub const MAX_CURVE_POINTS: i64 = 100_000;

/// What stands in a file of two bodies.
#[derive(Clone, Debug)]
pub struct ImpactFile {
    /// Name of the file for messages.
    pub name: String,
    /// Materials.
    pub materials: Vec<Material>,
    /// Contact laws of every pair of materials.
    pub contact: ContactSpec,
    /// The body that moves.
    pub a: Body,
    /// Its partner.
    pub b: Partner,
    /// How they meet.
    pub impact: ImpactSpec,
    /// What a contact curve runs through.
    pub curve: CurveSpec,
    diagnostics: Diagnostics,
}

/// A sphere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Body {
    /// Index of its material.
    pub material: u16,
    /// Radius [m].
    pub radius: f64,
    /// Mass [kg].
    pub mass: f64,
}

impl Body {
    /// Moment of inertia of the solid sphere [kg m^2].
    pub fn inertia(&self) -> f64 {
        0.4 * self.mass * self.radius * self.radius
    }

    /// The same body in another size.
    pub fn scaled(&self, factor: f64) -> Self {
        Self {
            radius: self.radius * factor,
            mass: self.mass * (factor * factor * factor),
            ..*self
        }
    }
}

/// What the moving body meets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Partner {
    /// A flat wall of a material.
    Wall(u16),
    /// A sphere that is free to move.
    Free(Body),
    /// A sphere that is held.
    Fixed(Body),
}

impl Partner {
    /// Index of its material.
    pub fn material(&self) -> u16 {
        match self {
            Self::Wall(material) => *material,
            Self::Free(body) | Self::Fixed(body) => body.material,
        }
    }

    /// The sphere, if it is one.
    pub fn body(&self) -> Option<Body> {
        match self {
            Self::Wall(_) => None,
            Self::Free(body) | Self::Fixed(body) => Some(*body),
        }
    }

    /// Its mass when it is free to move [kg].
    pub fn free_mass(&self) -> Option<f64> {
        match self {
            Self::Free(body) => Some(body.mass),
            _ => None,
        }
    }

    fn scaled(&self, factor: f64) -> Self {
        match self {
            Self::Wall(material) => Self::Wall(*material),
            Self::Free(body) => Self::Free(body.scaled(factor)),
            Self::Fixed(body) => Self::Fixed(body.scaled(factor)),
        }
    }
}

/// Effective radius and mass of two bodies.
pub fn pair_size(a: &Body, b: &Partner) -> PairSize {
    PairSize::new(
        1.0 / (1.0 / a.radius + b.body().map_or(0.0, |b| 1.0 / b.radius)),
        1.0 / (1.0 / a.mass + b.free_mass().map_or(0.0, |m| 1.0 / m)),
    )
}

/// How two bodies meet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ImpactSpec {
    /// Relative speed [m/s]; absent where a command needs none.
    pub velocity: Option<f64>,
    /// Angle of the velocity from the normal [rad].
    pub angle: f64,
    /// Angular velocity of the first body [1/s].
    pub spin_a: DVec3,
    /// Angular velocity of the second body [1/s].
    pub spin_b: DVec3,
    /// Where the speed is given.
    pub start: Start,
}

/// What a contact curve runs through.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CurveSpec {
    /// How deep it loads.
    pub depth: CurveDepth,
    /// Whether it loads again before it pulls off.
    pub reload: bool,
    /// Overlap to which it unloads before it loads again [m]; when absent, to half of the largest force.
    pub unload_to: Option<f64>,
    /// Rows of every branch.
    pub points: usize,
}

/// How deep a contact curve loads.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CurveDepth {
    /// As far as the impact of the file goes, or to 1/100 of the effective radius when it tells no velocity.
    Automatic,
    /// To this overlap [m].
    Overlap(f64),
    /// To this force [N].
    Force(f64),
}

impl ImpactFile {
    /// Reads a file. Overrides are texts `key=value`, as `impact.velocity=2 m/s`.
    pub fn read(path: &Path, overrides: &[String]) -> Result<Self, Diagnostics> {
        let name = path.display().to_string();
        let text = read_text(path).map_err(|fault| lone_fault(&name, fault))?;
        Self::parse(&text, &name, overrides)
    }

    /// Reads a text.
    pub fn parse(text: &str, name: &str, overrides: &[String]) -> Result<Self, Diagnostics> {
        let document = tree(text, name, overrides)?;
        refuse_other_kind(name, &document, FileKind::TwoBodies)?;
        let diagnostics = Diagnostics::new(name, document.clone());
        let context = Context::new(diagnostics.clone());
        let read = walk(TableReader::root(&context, &document.root), name, diagnostics);
        let mut faults = context.faults.into_inner();
        if faults.is_empty() {
            read.check_laws(&mut faults);
        }
        if faults.is_empty() { Ok(read) } else { Err(faults) }
    }

    fn check_laws(&self, faults: &mut Diagnostics) {
        let (a, b) = (usize::from(self.a.material), usize::from(self.b.material()));
        let path = self.contact.path(a, b);
        let (first, second) = (&self.materials[a.min(b)], &self.materials[a.max(b)]);
        match self.choice().bind(first, second) {
            Err(error) => {
                let message = format!("between `{}` and `{}`: {error}", first.name, second.name);
                faults.push(&path, message, None);
            }
            Ok(law) => {
                if let Err(why) = law.normal.visit(Check(pair_size(&self.a, &self.b))) {
                    faults.push(&format!("{path}.normal"), why, None);
                }
            }
        }
    }

    /// The laws of the two bodies by name.
    pub fn choice(&self) -> PairChoice {
        self.contact.choice(self.a.material.into(), self.b.material().into())
    }

    /// The laws of the two bodies.
    pub fn law(&self) -> Result<PairLaw, Diagnostics> {
        let list = &self.materials;
        let bound = Materials::new(list.clone(), |a, b| self.contact.choice(a, b));
        let materials = bound.map_err(|error| self.refused("contact", error.to_string()))?;
        Ok(*materials.law(materials.pair(self.a.material, self.b.material())))
    }

    /// Whether the law can do for these sizes what its parameters ask.
    pub fn check_size(&self, law: &PairLaw, size: PairSize) -> Result<(), Diagnostics> {
        let path = self.contact.path(self.a.material.into(), self.b.material().into());
        let checked = law.normal.visit(Check(size));
        checked.map_err(|why| self.refused(&format!("{path}.normal"), why))
    }

    /// Effective radius and mass of the two bodies.
    pub fn size(&self) -> PairSize {
        pair_size(&self.a, &self.b)
    }

    /// The two bodies, both scaled so that their effective radius is this one [m].
    pub fn with_effective_radius(&self, radius: f64) -> Self {
        let factor = radius / self.size().radius;
        Self {
            a: self.a.scaled(factor),
            b: self.b.scaled(factor),
            ..self.clone()
        }
    }

    /// One fault at the value of a key.
    pub fn refused(&self, path: &str, message: impl Into<String>) -> Diagnostics {
        let mut faults = self.diagnostics.clone();
        faults.push(path, message, None);
        faults
    }
}

struct Check(PairSize);

impl NormalVisitor for Check {
    type Output = Result<(), String>;
    fn visit<L: Normal>(self, law: &L) -> Self::Output {
        law.check(self.0)
    }
}

pub(super) fn walk(table: TableReader<'_>, name: &str, diagnostics: Diagnostics) -> ImpactFile {
    if let Some(title) = table.optional("title") {
        title.label();
    }
    let materials = materials(&table);
    let contact = contact(&table, &materials);
    let a = body_a(&table, &materials);
    let b = body_b(&table, &materials);
    let impact = impact(&table);
    let curve = curve(&table);
    table.finish("a file of two bodies");
    ImpactFile {
        name: name.to_string(),
        materials,
        contact,
        a,
        b,
        impact,
        curve,
        diagnostics,
    }
}

/// A table that tells a body, and its material.
fn body_table<'a>(root: &TableReader<'a>, key: &str, materials: &[Material]) -> Option<(TableReader<'a>, u16)> {
    let example = format!("a table [{key}] with material and radius");
    let table = root.required(key, &example)?.table()?;
    let material = table
        .required("material", "the name of a table [material.NAME]")
        .map_or(0, |item| material_index(&item, materials));
    Some((table, material))
}

/// Mass of a sphere of a material [kg].
pub(super) fn sphere_mass(radius: f64, material: u16, materials: &[Material]) -> f64 {
    let density = materials.get(usize::from(material)).map_or(f64::NAN, |m| m.density);
    density * (4.0 / 3.0 * PI) * radius * radius * radius
}

fn sphere(table: &TableReader<'_>, material: u16, materials: &[Material]) -> Body {
    let radius = table.length("radius", "the radius of the sphere, as \"5 mm\"");
    let density = materials.get(usize::from(material)).map_or(f64::NAN, |m| m.density);
    let mass = sphere_mass(radius, material, materials);
    if radius.is_finite() && density.is_finite() && !(mass > 0.0 && mass.is_finite()) {
        table.fault_at("radius", format!("a sphere of this radius has a mass of {mass} kg"));
    }
    Body { material, radius, mass }
}

pub(super) fn body_a(root: &TableReader<'_>, materials: &[Material]) -> Body {
    let Some((table, material)) = body_table(root, "a", materials) else {
        return Body {
            material: 0,
            radius: f64::NAN,
            mass: f64::NAN,
        };
    };
    for key in ["wall", "fixed"] {
        if table.optional(key).is_some() {
            table.fault_at(key, format!("`{key}` belongs in [b]: [a] is the sphere that moves"));
        }
    }
    let body = sphere(&table, material, materials);
    table.finish("[a]");
    body
}

pub(super) fn body_b(root: &TableReader<'_>, materials: &[Material]) -> Partner {
    let Some((table, material)) = body_table(root, "b", materials) else {
        return Partner::Wall(0);
    };
    let wall = table.optional("wall").is_some_and(|item| item.boolean());
    let fixed = table.optional("fixed").is_some_and(|item| item.boolean());
    let partner = if wall {
        if table.optional("radius").is_some() {
            table.fault_at(
                "radius",
                "[b] has a radius and is a wall; it is one or the other: a flat wall has none",
            );
        }
        if fixed {
            table.fault_at("fixed", "a wall is always held; leave `fixed` out");
        }
        Partner::Wall(material)
    } else if table.has("radius") {
        let body = sphere(&table, material, materials);
        if fixed {
            Partner::Fixed(body)
        } else {
            Partner::Free(body)
        }
    } else {
        let help = "write radius = \"5 mm\" for a sphere, or wall = true for a flat wall";
        table.fault("[b] has neither a radius nor `wall = true`", Some(help.to_string()));
        Partner::Wall(material)
    };
    table.finish("[b]");
    partner
}

fn impact(root: &TableReader<'_>) -> ImpactSpec {
    let mut spec = ImpactSpec {
        velocity: None,
        angle: 0.0,
        spin_a: DVec3::ZERO,
        spin_b: DVec3::ZERO,
        start: Start::Far,
    };
    let Some(table) = root.optional("impact").and_then(|item| item.table()) else {
        return spec;
    };
    spec.velocity = table.optional_quantity("velocity", Kind::Physical(Dimension::VELOCITY), Range::POSITIVE);
    let below_grazing = Range::new(0.0, true, FRAC_PI_2, false);
    if let Some(angle) = table.optional("angle") {
        spec.angle = angle.quantity(Kind::Angle, Range::FINITE);
        if !below_grazing.contains(spec.angle) && spec.angle.is_finite() {
            angle.fault(
                "`angle` is from the normal, at least 0 and below 90 deg: at 90 deg the bodies pass each other",
                None,
            );
        }
    }
    spec.spin_a = table.optional("spin_a").map_or(DVec3::ZERO, |item| spin(&item));
    spec.spin_b = table.optional("spin_b").map_or(DVec3::ZERO, |item| spin(&item));
    if let Some(start) = table
        .optional("start")
        .and_then(|item| item.choice(&["contact", "far"]))
    {
        spec.start = [Start::Contact, Start::Far][start];
    }
    table.finish("[impact]");
    spec
}

/// A spin: a vector, or its component along y, the axis normal to the plane of impact.
fn spin(item: &Item<'_>) -> DVec3 {
    let numbers = |text: &str| text.split_whitespace().take_while(|w| w.parse::<f64>().is_ok()).count();
    match &item.node.value {
        Value::Array(_) => item.vector(Kind::AngularVelocity),
        Value::String(text) if numbers(text) > 1 => item.vector(Kind::AngularVelocity),
        _ => DVec3::Y * item.quantity(Kind::AngularVelocity, Range::FINITE),
    }
}

/// Rows of a branch when the file tells no number.
const CURVE_POINTS: usize = 200;

fn curve(root: &TableReader<'_>) -> CurveSpec {
    let mut spec = CurveSpec {
        depth: CurveDepth::Automatic,
        reload: true,
        unload_to: None,
        points: CURVE_POINTS,
    };
    let Some(table) = root.optional("curve").and_then(|item| item.table()) else {
        return spec;
    };
    let length = Kind::Physical(Dimension::LENGTH);
    let overlap = table.optional_quantity("max_overlap", length, Range::POSITIVE);
    let force = table.optional_quantity("max_force", Kind::Physical(Dimension::FORCE), Range::POSITIVE);
    spec.depth = match (overlap, force) {
        (Some(_), Some(_)) => {
            table.fault_at("max_force", "a curve loads to an overlap or to a force; both are given");
            CurveDepth::Automatic
        }
        (Some(overlap), None) => CurveDepth::Overlap(overlap),
        (None, Some(force)) => CurveDepth::Force(force),
        (None, None) => CurveDepth::Automatic,
    };
    spec.unload_to = table.optional_quantity("unload_to", length, Range::FINITE);
    spec.reload = table.optional("reload").is_none_or(|item| item.boolean());
    if spec.unload_to.is_some() && !spec.reload {
        let message = "`unload_to` is where the curve turns to load again, and with `reload = false` it never does; leave out one of \
                       the two";
        table.fault_at("unload_to", message);
    }
    if let Some(points) = table.optional("points") {
        spec.points = points.integer(2, MAX_CURVE_POINTS) as usize;
    }
    table.finish("[curve]");
    spec
}

#[cfg(test)]
mod tests {
    use super::*;

    const MCC: &str = r#"
[material.mcc]
young_modulus = "6 GPa"
poisson_ratio = 0.3
density = "1500 kg/m^3"
[a]
material = "mcc"
radius = "5 mm"
[b]
material = "mcc"
radius = "5 mm"
[contact]
normal = { law = "hertz-tsuji", restitution = 0.54 }
[impact]
velocity = "1 m/s"
"#;

    fn read(overrides: &[&str]) -> Result<ImpactFile, Diagnostics> {
        let overrides: Vec<String> = overrides.iter().map(ToString::to_string).collect();
        ImpactFile::parse(MCC, "mcc.toml", &overrides)
    }

    #[test]
    fn two_equal_grains_a_wall_and_a_held_grain() {
        let file = read(&[]).unwrap();
        let mass = 1500.0 * 4.0 / 3.0 * PI * 1.25e-7;
        assert_eq!(file.impact.velocity, Some(1.0));
        assert!((file.size().radius - 2.5e-3).abs() < 1e-15);
        assert!((file.size().mass - 0.5 * mass).abs() < 1e-12 * mass);
        let wall = read(&["b={material = \"mcc\", wall = true}"]).unwrap();
        assert!((wall.size().radius - 5e-3).abs() < 1e-15);
        assert!((wall.size().mass - mass).abs() < 1e-12 * mass);
        let fixed = read(&["b.fixed=true"]).unwrap();
        assert!((fixed.size().radius - 2.5e-3).abs() < 1e-15);
        assert!((fixed.size().mass - mass).abs() < 1e-12 * mass);
        let scaled = fixed.with_effective_radius(0.3e-6);
        assert!((scaled.size().radius - 0.3e-6).abs() < 1e-20);
        assert!((scaled.a.radius - 0.6e-6).abs() < 1e-20);
    }

    #[test]
    fn spins_are_numbers_or_vectors() {
        let file = read(&[
            "impact.spin_a=100 rad/s",
            "impact.spin_b=[\"1 rad/s\", \"60 rpm\", \"0 rad/s\"]",
        ])
        .unwrap();
        assert_eq!(file.impact.spin_a, DVec3::new(0.0, 100.0, 0.0));
        assert!((file.impact.spin_b - DVec3::new(1.0, 2.0 * PI, 0.0)).length() < 1e-14);
        assert_eq!(
            read(&["impact.spin_a=1 2 3 rad/s"]).unwrap().impact.spin_a,
            DVec3::new(1.0, 2.0, 3.0)
        );
        let angle = read(&["impact.angle=30 deg"]).unwrap().impact.angle;
        assert!((angle - PI / 6.0).abs() < 1e-15);
    }

    #[test]
    fn what_is_wrong_is_told_with_its_place() {
        let cases = [
            ("a.radius=-1 mm", "`radius` is -1 mm; it must be above 0"),
            ("a.radius=1 kg", "`radius` must be a length, found a mass"),
            ("a.wall=true", "`wall` belongs in [b]"),
            ("b.wall=true", "it is one or the other"),
            ("b={material = \"mcc\"}", "neither a radius nor `wall = true`"),
            (
                "b={material = \"mcc\", wall = true, fixed = true}",
                "a wall is always held",
            ),
            ("b.material=steel", "unknown material `steel`"),
            ("impact.angle=90 deg", "below 90 deg"),
            ("impact.angle=-1 deg", "below 90 deg"),
            ("impact.velocity=0 m/s", "`velocity` is 0 m/s; it must be above 0"),
            ("impact.velocity=1", "with a unit"),
            ("impact.speed=1 m/s", "unknown key `speed` in [impact]"),
            ("impact.start=near", "unknown value `near` of `start`"),
            ("impact.spin_a=3 Hz", "must be an angular velocity"),
            ("curve={max_overlap = \"1 um\", max_force = \"1 N\"}", "both are given"),
            ("curve={points = 1}", "it must be from 2"),
            (
                "curve={unload_to = \"1 um\", reload = false}",
                "leave out one of the two",
            ),
            (
                "contact.normal.restitution=0",
                "`restitution` is 0; it must be above 0 and at most 1",
            ),
            (
                "contact.normal.restitution=[[\"0 m/s\", 0.9], [\"1 m/s\", 0.8]]",
                "an impact speed of `restitution` is 0 m/s; it must be above 0",
            ),
            ("contact.normal.restitution=1 - v", "as `max(0.01, ...)` does"),
            ("domain={}", "unknown key `domain` in a file of two bodies"),
            ("contact.normal.restitution=1.2", "at most 1"),
        ];
        for (set, message) in cases {
            let faults = read(&[set]).unwrap_err();
            assert!(faults.to_string().contains(message), "{set}: {faults}");
            assert!(faults.list().iter().all(|f| f.line > 0), "{set}: {faults}");
        }
        for table in ["[material.mcc]", "[contact]", "[a]", "[b]"] {
            let text = MCC.replace(table, "[other]");
            let faults = ImpactFile::parse(&text, "x", &[]).unwrap_err().to_string();
            assert!(
                faults.contains("is missing") && faults.contains("unknown key `other`"),
                "{faults}"
            );
        }
        assert!(ImpactFile::parse("", "x", &[]).is_err());
    }
}
