//! The workloads: what every engine is asked to do.

use crate::agreement::{AT_REST, AT_REST_SMALL, COLLAPSING, FLOWING, SQUEEZED, Tolerance};
use crate::analysis::{Bearing, Scene, Spring};
use crate::grains::State;
use demeter_physics::DVec3;

/// Young's modulus of all but the chute [Pa].
const YOUNG: f64 = 5e7;
/// Poisson's ratio of all but the chute.
pub const POISSON: f64 = 0.3;
/// Density of all grains but those of the chute [kg/m^3].
pub const GLASS: f64 = 2500.0;
/// Density of the grains of the chute, whose mass and diameter are 1 [kg/m^3].
pub const UNIT: f64 = 6.0 / std::f64::consts::PI;
/// Grains of the base of the chute: those with ids up to this.
pub const FIXED_IN_CHUTE: u32 = 800;
/// Stiffness of the contacts of the chute [N/m].
const CHUTE_STIFFNESS: f64 = 2000.0;
/// Speed of the plate of W4 [m/s].
const PLATE_SPEED: f64 = 0.5;
/// Room between the bed and the plate at the start [m].
const PLATE_GAP: f64 = 1e-4;
/// Radius of the drum of W3 [m].
const DRUM_RADIUS: f64 = 0.1;
/// Its angular velocity [1/s], and the faces of the peers' drums.
const DRUM_SPEED: f64 = 3.0;
const DRUM_FACES: usize = 96;
/// Width of the boxes of W1 and W5 [m].
const BED_WIDTH: f64 = 0.13;
const SIZES_WIDTH: f64 = 0.0489;

/// What kind of thing happens; the inputs of an engine for it have this name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A bed in a box.
    Bed,
    /// A bed on a floor, periodic.
    Column,
    /// Flow down a slope over fixed grains.
    Chute,
    /// A turning drum.
    Drum,
    /// A bed that a plate squeezes.
    Plate,
    /// A bed of many sizes.
    Sizes,
}

/// Which laws contacts follow, beside those of their kind of workload.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Laws {
    /// No others; all peers have them.
    OfAll,
    /// Grains adhere; LAMMPS alone has the law.
    Jkr,
    /// Grains resist rolling; LIGGGHTS alone has the law.
    Epsd,
}

/// What is particular about the walls of an engine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EngineWalls {
    /// Stiffness of a contact over that of two bodies of one material, one of them flat.
    pub stiffness: f64,
    /// Whether the drum is made of facets.
    pub faceted: bool,
}

impl EngineWalls {
    /// Flat bodies of the material of the grains, and a round drum.
    pub const PLAIN: Self = Self {
        stiffness: 1.0,
        faceted: false,
    };
}

/// One workload.
#[derive(Clone, Debug)]
pub struct Workload {
    /// How it is asked for.
    pub key: &'static str,
    /// How it is called in the table.
    pub title: &'static str,
    /// What it is.
    pub kind: Kind,
    /// Which laws its contacts follow.
    pub laws: Laws,
    /// The state it starts from.
    pub state: &'static str,
    /// Steps before the loop, in which contacts come to have a history.
    pub relax: u64,
    /// Steps of the loop.
    pub steps: u64,
    /// Time step [s].
    pub dt: f64,
    /// Whether YADE runs so many grains: a million take it minutes and 6 GB before the first step.
    fits_yade: bool,
    /// How closely the others must agree with Demeter.
    pub tolerance: Tolerance,
}

const fn workload(key: &'static str, title: &'static str, kind: Kind, state: &'static str) -> Workload {
    Workload {
        key,
        title,
        kind,
        laws: Laws::OfAll,
        state,
        relax: 200,
        steps: 1000,
        dt: 1e-5,
        fits_yade: true,
        tolerance: AT_REST,
    }
}

/// All workloads.
pub const WORKLOADS: [Workload; 12] = [
    workload("w1set", "W1 settled, 20k", Kind::Bed, "w1set"),
    Workload {
        tolerance: COLLAPSING,
        ..workload("w1dyn", "W1 collapsing, 20k", Kind::Bed, "w1dyn")
    },
    Workload {
        dt: 1e-4,
        tolerance: FLOWING,
        ..workload("w2", "W2 chute, 32k", Kind::Chute, "w2")
    },
    Workload {
        tolerance: FLOWING,
        ..workload("w3", "W3 drum, 20k", Kind::Drum, "w3")
    },
    Workload {
        relax: 0,
        // a tenth of the height of the bed
        steps: 3760,
        tolerance: SQUEEZED,
        ..workload("w4", "W4 compaction, 20k", Kind::Plate, "w1set")
    },
    Workload {
        dt: 2e-6,
        tolerance: AT_REST_SMALL,
        ..workload("w5", "W5 sizes 1:10, 20k", Kind::Sizes, "w5")
    },
    Workload {
        relax: 20,
        steps: 1500,
        ..workload("w6-10k", "W6 static, 10k", Kind::Column, "w6-10k")
    },
    Workload {
        relax: 20,
        steps: 300,
        ..workload("w6-50k", "W6 static, 50k", Kind::Column, "w6-50k")
    },
    Workload {
        relax: 20,
        steps: 80,
        ..workload("w6-200k", "W6 static, 200k", Kind::Column, "w6-200k")
    },
    Workload {
        relax: 5,
        steps: 25,
        fits_yade: false,
        ..workload("w6-1m", "W6 static, 1M", Kind::Column, "w6-1m")
    },
    Workload {
        laws: Laws::Jkr,
        tolerance: COLLAPSING,
        ..workload("w7", "W7 cohesive, 20k", Kind::Bed, "w1dyn")
    },
    Workload {
        laws: Laws::Epsd,
        tolerance: COLLAPSING,
        ..workload("w8", "W8 rolling resistance, 20k", Kind::Bed, "w1dyn")
    },
];

/// What differs in the cohesive bed: grains adhere to each other, not to walls, since JKR at walls ends LAMMPS 2021 with numbers that are
/// none. Its surface energy is half of the work of adhesion; the coefficient of the dashpot is what the polynomial of Tsuji, Tanaka and
/// Ishida (1992) gives there for a restitution of 0.5.
const COHESIVE: [&str; 3] = [
    "material.wall={young_modulus=\"50 MPa\", poisson_ratio=0.3, density=\"2500 kg/m^3\"}",
    "wall[0].material=\"wall\"",
    "contact.pair=[{between=[\"glass\", \"glass\"], normal={law=\"jkr\", work_of_adhesion=\"0.05 J/m^2\", alpha=0.34074}, \
     tangential={law=\"mindlin-history\", friction=0.5, damping_ratio=0.3679}}]",
];

/// What differs where grains resist rolling. The largest torques are those of LIGGGHTS, the springs 1.5 times as stiff, as it takes the
/// secant of Hertz's law for its tangent.
const ROLLING: &str = "contact.rolling={law=\"epsd\", rolling_friction=0.1, damping_ratio=0.1}";

/// The workloads that any of some keys begins: `w6` asks for all sizes. All of them when there are no keys.
pub fn chosen(keys: &[String]) -> Result<Vec<Workload>, String> {
    for key in keys {
        if !WORKLOADS.iter().any(|w| w.key.starts_with(key.as_str())) {
            let known: Vec<&str> = WORKLOADS.iter().map(|w| w.key).collect();
            return Err(format!("there is no workload `{key}`; there are {}", known.join(", ")));
        }
    }
    let asked = |w: &Workload| keys.is_empty() || keys.iter().any(|k| w.key.starts_with(k.as_str()));
    Ok(WORKLOADS.into_iter().filter(asked).collect())
}

/// A number or text that an input asks for by its name.
pub type Variable = (&'static str, String);

impl Kind {
    /// Stem of the names of its inputs.
    pub fn input(self) -> &'static str {
        match self {
            // the peers run both with one input
            Self::Bed | Self::Column => "bed",
            Self::Chute => "chute",
            Self::Drum => "drum",
            Self::Plate => "plate",
            Self::Sizes => "sizes",
        }
    }

    /// The scenario of Demeter.
    pub const fn scenario(self) -> &'static str {
        match self {
            Self::Bed => include_str!("../../../peers/scenarios/bed.toml"),
            Self::Column => include_str!("../../../peers/scenarios/column.toml"),
            Self::Chute => include_str!("../../../peers/scenarios/chute.toml"),
            Self::Drum => include_str!("../../../peers/scenarios/drum.toml"),
            Self::Plate => include_str!("../../../peers/scenarios/plate.toml"),
            Self::Sizes => include_str!("../../../peers/scenarios/sizes.toml"),
        }
    }

    /// Distance beyond touching at which bodies become candidates, in the inputs of the peers [m].
    pub fn skin(self) -> f64 {
        match self {
            Self::Chute => 0.1,
            Self::Sizes => 2e-4,
            _ => 5e-4,
        }
    }
}

impl Laws {
    /// What changes in the scenario of Demeter.
    fn overrides(self) -> &'static [&'static str] {
        match self {
            Self::OfAll => &[],
            Self::Jkr => &COHESIVE,
            Self::Epsd => &[ROLLING],
        }
    }

    /// What asks LAMMPS and LIGGGHTS for them.
    fn variable(self) -> Option<Variable> {
        match self {
            Self::OfAll => None,
            Self::Jkr => Some(("law", "jkr".into())),
            Self::Epsd => Some(("rolling", "1".into())),
        }
    }
}

impl Workload {
    /// Styles of LAMMPS that have its laws: that of the same law and the faster one.
    pub fn lammps_styles(&self) -> &'static [&'static str] {
        match (self.laws, self.kind) {
            (Laws::OfAll, Kind::Chute) => &["granular", "hooke"],
            (Laws::OfAll, _) => &["granular", "hertz"],
            (Laws::Jkr, _) => &["granular"],
            (Laws::Epsd, _) => &[],
        }
    }

    /// Whether LIGGGHTS has its laws.
    pub fn liggghts(&self) -> bool {
        self.laws != Laws::Jkr
    }

    /// Whether YADE has its laws, and runs so many grains.
    pub fn yade(&self) -> bool {
        self.fits_yade && self.laws == Laws::OfAll
    }

    /// Grains with ids up to this are fixed.
    pub fn fixed(&self) -> u32 {
        if self.kind == Kind::Chute { FIXED_IN_CHUTE } else { 0 }
    }

    /// What changes in the scenario of Demeter.
    pub fn overrides(&self, state: &State) -> Vec<String> {
        let file = format!("grains[0].file=\"{}.data\"", self.state);
        let mut all = match self.kind {
            Kind::Bed | Kind::Drum | Kind::Sizes => vec![file],
            Kind::Plate => vec![file, format!("wall.plate.point=\"0 0 {} m\"", plate_start(state))],
            Kind::Column => vec![file, format!("domain.upper=\"{} m\"", corner(state))],
            Kind::Chute => vec![format!("domain.upper=\"{} m\"", corner(state))],
        };
        all.extend(self.laws.overrides().iter().map(|&text| text.into()));
        all
    }

    /// Variables of the inputs of LAMMPS and LIGGGHTS, beside those of every run.
    pub fn variables(&self, state: &State) -> Vec<Variable> {
        let of_kind = match self.kind {
            Kind::Bed => Some(("periodic", "0".into())),
            Kind::Column => Some(("periodic", "1".into())),
            Kind::Plate => Some(("plate", plate_start(state).to_string())),
            Kind::Chute | Kind::Drum | Kind::Sizes => None,
        };
        of_kind.into_iter().chain(self.laws.variable()).collect()
    }

    /// Arguments of the scripts for YADE, beside those of every run.
    pub fn yade_arguments(&self, state: &State) -> Vec<Variable> {
        let mut all = vec![("skin", self.kind.skin().to_string()), ("dt", self.dt.to_string())];
        let height = state.upper.z;
        all.extend(match self.kind {
            Kind::Bed => vec![("width", BED_WIDTH.to_string())],
            Kind::Sizes => vec![("width", SIZES_WIDTH.to_string())],
            Kind::Plate => vec![
                ("width", BED_WIDTH.to_string()),
                ("plate", plate_start(state).to_string()),
            ],
            Kind::Column => vec![
                ("periodic", "1".into()),
                ("lx", state.upper.x.to_string()),
                ("ly", state.upper.y.to_string()),
                ("height", height.to_string()),
            ],
            Kind::Chute => vec![("height", height.to_string())],
            Kind::Drum => Vec::new(),
        });
        all
    }

    /// How to judge the grains after a number of steps from the start, with the walls of an engine.
    pub fn scene(&self, state: &State, steps: u64, walls: EngineWalls) -> Scene {
        let floor = Bearing::Level { z: 0.0, up: 1.0 };
        let hertz = Spring::Hertz {
            plane_strain_modulus: YOUNG / (1.0 - POISSON * POISSON),
        };
        let size = state.upper - state.lower;
        let periodic = DVec3::new(size.x, size.y, f64::INFINITY);
        let (period, spring, bearing) = match self.kind {
            Kind::Bed | Kind::Sizes => (DVec3::INFINITY, hertz, floor),
            Kind::Column => (periodic, hertz, floor),
            Kind::Drum if walls.faceted => {
                let turned = DRUM_SPEED * steps as f64 * self.dt;
                let (apothem, faces) = (DRUM_RADIUS, DRUM_FACES);
                (DVec3::INFINITY, hertz, Bearing::PrismAboutY { apothem, faces, turned })
            }
            Kind::Drum => (DVec3::INFINITY, hertz, Bearing::CylinderAboutY { radius: DRUM_RADIUS }),
            Kind::Plate => {
                let z = plate_start(state) - PLATE_SPEED * steps as f64 * self.dt;
                (DVec3::INFINITY, hertz, Bearing::Level { z, up: -1.0 })
            }
            Kind::Chute => {
                let stiffness = CHUTE_STIFFNESS;
                (periodic, Spring::Linear { stiffness }, Bearing::FixedGrains)
            }
        };
        Scene {
            period,
            density: state.density,
            spring,
            bearing,
            wall_stiffness: walls.stiffness,
        }
    }
}

/// Where the plate starts: above the highest grain, in whole tenths of a millimetre, which every engine reads as told [m].
fn plate_start(state: &State) -> f64 {
    ((state.top() + PLATE_GAP) * 1e4).ceil() / 1e4
}

fn corner(state: &State) -> String {
    let u = state.upper;
    format!("{} {} {}", u.x, u.y, u.z)
}

/// Where the plate of LIGGGHTS, a mesh of two triangles a little wider than the box, lies [m].
pub fn plate_mesh(state: &State) -> Vec<[DVec3; 3]> {
    let (low, high, z) = (-0.002, BED_WIDTH + 0.002, plate_start(state));
    let corner = |x, y| DVec3::new(x, y, z);
    let [a, b, c, d] = [
        corner(low, low),
        corner(high, low),
        corner(high, high),
        corner(low, high),
    ];
    vec![[a, b, c], [a, c, d]]
}

/// The drum of LIGGGHTS: 96 facets round, 8 along, closed; its facets lie where the cylinder is, its edges beyond.
pub fn drum_mesh() -> Vec<[DVec3; 3]> {
    const ALONG: usize = 8;
    const LENGTH: f64 = 0.19;
    let radius = DRUM_RADIUS / (std::f64::consts::PI / DRUM_FACES as f64).cos();
    let rim = |i: usize, y: f64| {
        let angle = std::f64::consts::TAU * (i % DRUM_FACES) as f64 / DRUM_FACES as f64;
        DVec3::new(radius * angle.cos(), y, radius * angle.sin())
    };
    let mut triangles = Vec::new();
    for i in 0..DRUM_FACES {
        for j in 0..ALONG {
            let (near, far) = (LENGTH * j as f64 / ALONG as f64, LENGTH * (j + 1) as f64 / ALONG as f64);
            let [a, b, c, d] = [rim(i, near), rim(i + 1, near), rim(i + 1, far), rim(i, far)];
            triangles.extend([[a, b, c], [a, c, d]]);
        }
        for y in [0.0, LENGTH] {
            triangles.push([DVec3::Y * y, rim(i, y), rim(i + 1, y)]);
        }
    }
    triangles
}

/// Triangles as an ASCII STL file.
pub fn stl(triangles: &[[DVec3; 3]]) -> String {
    let mut text = String::from("solid wall\n");
    for [a, b, c] in triangles {
        let normal = (*b - *a).cross(*c - *a).normalize();
        let point = |p: DVec3| format!("{} {} {}", p.x, p.y, p.z);
        text += &format!("facet normal {}\nouter loop\n", point(normal));
        for corner in [a, b, c] {
            text += &format!("vertex {}\n", point(*corner));
        }
        text += "endloop\nendfacet\n";
    }
    text + "endsolid wall\n"
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grains::Grain;
    use demeter::scenario::Scenario;

    fn state() -> State {
        let grain = Grain {
            id: 1,
            kind: 1,
            diameter: 5e-3,
            position: DVec3::new(0.01, 0.01, 0.13881),
            velocity: DVec3::ZERO,
            spin: DVec3::ZERO,
        };
        State {
            lower: DVec3::ZERO,
            upper: DVec3::new(0.5, 0.4, 0.2),
            density: GLASS,
            grains: vec![grain],
        }
    }

    #[test]
    fn keys_choose_by_their_beginning() {
        let keys = |words: &[&str]| {
            let words: Vec<String> = words.iter().map(|w| (*w).to_owned()).collect();
            chosen(&words).map(|all| all.iter().map(|w| w.key).collect::<Vec<_>>())
        };
        assert_eq!(keys(&["w1", "w3"]).unwrap(), ["w1set", "w1dyn", "w3"]);
        assert_eq!(keys(&["w6"]).unwrap().len(), 4);
        assert_eq!(keys(&[]).unwrap().len(), WORKLOADS.len());
        assert!(keys(&["w1", "w99"]).unwrap_err().contains("`w99`"));
    }

    #[test]
    fn every_scenario_is_read_with_what_changes_in_it_and_has_the_time_step_of_the_peers() {
        let folder = tempfile::tempdir().unwrap();
        for workload in WORKLOADS {
            for name in [workload.state, "w2base", "w2flow"] {
                let text = state().data_file(name);
                std::fs::write(folder.path().join(format!("{name}.data")), text).unwrap();
            }
            let overrides = workload.overrides(&state());
            let read = Scenario::parse(workload.kind.scenario(), workload.key, folder.path(), &overrides);
            let scenario = read.unwrap_or_else(|faults| panic!("{}: {faults}", workload.key));
            let dt = demeter::scenario::TimeStep::Fixed(workload.dt);
            assert!(
                format!("{:?}", scenario.simulation.time_step) == format!("{dt:?}"),
                "{}",
                workload.key
            );
        }
    }

    #[test]
    fn the_plate_starts_above_the_bed_and_its_place_is_known() {
        let w4 = &WORKLOADS[4];
        assert!((plate_start(&state()) - 0.1415).abs() < 1e-12);
        let Bearing::Level { z, up } = w4.scene(&state(), 3760, EngineWalls::PLAIN).bearing else {
            panic!()
        };
        assert!((z - (0.1415 - 0.0188)).abs() < 1e-12 && up == -1.0);
        assert_eq!(plate_mesh(&state())[1][2].z, 0.1415);
    }

    #[test]
    fn the_drum_is_closed_and_lies_where_the_cylinder_is() {
        let triangles = drum_mesh();
        assert_eq!(triangles.len(), 1728);
        demeter::walls::Mesh::new(&triangles).unwrap().require_closed().unwrap();
        let lies = |t: &[DVec3; 3]| {
            let normal = (t[1] - t[0]).cross(t[2] - t[0]).normalize();
            (t[0].dot(normal).abs(), normal.y.abs())
        };
        let round = triangles.iter().map(lies).filter(|(_, along)| *along < 0.5);
        assert!(round.into_iter().all(|(distance, _)| (distance - 0.1).abs() < 1e-12));
        assert_eq!(stl(&triangles).matches("vertex").count(), 3 * 1728);
    }
}
