//! Adhesive contacts in the engine: pull-off forces under a slowly moving wall, the speed below which grains stick, the
//! restitution above it, and the books of what touch and tear-off lose.

use crate::cases;

use crate::cases::{Case, Laws, law, material, on_threads, one_material, report};
use demeter::materials::Materials;
use demeter::simulation::Simulation;
use demeter::walls::{Motion, Shape};
use demeter_physics::DVec3;
use std::f64::consts::PI;

const MODULUS: f64 = 2e6;
const RADIUS: f64 = 1e-3;
const DENSITY: f64 = 2500.0;
const WORK: f64 = 0.05;

/// Effective modulus of two bodies of the material [Pa].
fn effective() -> f64 {
    MODULUS / (2.0 * (1.0 - 0.3 * 0.3))
}

/// Energy to part the surfaces from first touch, `7.09 (w^5 R^4/E^2)^(1/3)` [J].
fn separation(radius: f64) -> f64 {
    7.092195972 * libm::cbrt(libm::pow(WORK, 5.0) * libm::pow(radius, 4.0) / (effective() * effective()))
}

/// Effective radius and mass of what meets.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Partner {
    Plane,
    Mesh,
    Grain,
}

const PARTNERS: [Partner; 3] = [Partner::Plane, Partner::Mesh, Partner::Grain];

impl Partner {
    /// Effective radius [m] and mass [kg] with a grain.
    fn size(self) -> (f64, f64) {
        let mass = DENSITY * 4.0 / 3.0 * PI * RADIUS * RADIUS * RADIUS;
        match self {
            Self::Plane | Self::Mesh => (RADIUS, mass),
            Self::Grain => (0.5 * RADIUS, 0.5 * mass),
        }
    }
}

fn plane(height: f64, up: f64) -> Shape {
    Shape::Plane {
        point: DVec3::Z * height,
        normal: DVec3::Z * up,
    }
}

/// A grain that flies at a partner with a speed, just before it touches.
fn impact(normal: &[(&str, f64)], name: &str, partner: Partner, speed: f64) -> Simulation {
    let mut case = Case::new(one_material(MODULUS, &Laws::of(law(name, normal))));
    let gap = 1e-6;
    let velocity = -DVec3::Z * speed;
    match partner {
        Partner::Plane => case.wall(0, plane(0.0, 1.0), Motion::Rest),
        Partner::Mesh => {
            let corners = [(-0.1, -0.1), (0.1, -0.1), (0.0, 0.1)].map(|(x, y)| DVec3::new(x, y, 0.0));
            let triangles = vec![corners];
            case.wall(0, Shape::Mesh { triangles }, Motion::Rest);
        }
        Partner::Grain => {
            case.grain(RADIUS, -DVec3::Z * RADIUS, DVec3::ZERO);
        }
    }
    case.grain(RADIUS, DVec3::Z * (RADIUS + gap), velocity);
    case.simulation()
}

/// Gap between the grain and its partner [m], and the rate at which it grows [m/s].
fn gap(sim: &Simulation) -> (f64, f64) {
    let last = sim.grains().len() - 1;
    let (mut height, mut rate) = (sim.grains().position[last].z, sim.grains().velocity[last].z);
    if last > 0 {
        height -= sim.grains().position[0].z + RADIUS;
        rate -= sim.grains().velocity[0].z;
    }
    (height - RADIUS, rate)
}

/// Runs until the grain is far from its partner again, and gives the restitution; nothing when it has turned back
/// twice, and so sticks.
fn outcome(sim: &mut Simulation, speed: f64) -> Option<f64> {
    let (mut turns, mut direction) = (0, -1.0);
    for _ in 0..1_000_000 {
        sim.step().unwrap();
        let (gap, rate) = gap(sim);
        if rate * direction < 0.0 {
            (turns, direction) = (turns + 1, -direction);
        }
        if turns > 1 {
            return None;
        }
        // farther than the tear-off distance by far
        if turns == 1 && gap > 1e-5 {
            return Some(rate / speed);
        }
    }
    panic!("neither stuck nor parted");
}

#[test]
fn grains_stick_below_the_speed_of_thornton_and_ning() {
    on_threads(1, || {
        for name in ["jkr", "thornton-ning"] {
            let normal = [("work_of_adhesion", WORK), ("yield_pressure", 1e9)];
            let normal = &normal[..if name == "jkr" { 1 } else { 2 }];
            for partner in PARTNERS {
                let (radius, mass) = partner.size();
                let critical = (2.0 * separation(radius) / mass).sqrt();
                let formula = if partner == Partner::Grain {
                    // the mass of one of two equal grains is four times that of their effective radius in their density
                    1.84 / 4f64.sqrt()
                } else {
                    1.84
                };
                let strength = libm::pow(WORK / radius, 5.0) / libm::pow(DENSITY, 3.0);
                let paper = formula * libm::pow(strength / (effective() * effective()), 1.0 / 6.0);
                assert!((critical / paper - 1.0).abs() < 2e-4, "{critical} {paper}");
                for (ratio, sticks) in [(0.5, true), (0.999, true), (1.001, false)] {
                    let mut sim = impact(normal, name, partner, ratio * critical);
                    let found = outcome(&mut sim, ratio * critical);
                    assert_eq!(found.is_none(), sticks, "{name}, {partner:?}, {ratio}: {found:?}");
                }
            }
        }
    });
}

#[test]
fn above_it_the_tear_off_is_lost_and_booked() {
    on_threads(1, || {
        let (mut largest, mut residual) = (0.0f64, 0.0f64);
        for partner in PARTNERS {
            let (radius, mass) = partner.size();
            let critical = (2.0 * separation(radius) / mass).sqrt();
            for ratio in [1.1, 2.0, 5.0] {
                let mut sim = impact(&[("work_of_adhesion", WORK)], "jkr", partner, ratio * critical);
                let found = outcome(&mut sim, ratio * critical).unwrap();
                let expected = (1.0 - 1.0 / (ratio * ratio)).sqrt();
                largest = largest.max((found - expected).abs());
                assert!(
                    (found - expected).abs() < 1e-4,
                    "{partner:?}, {ratio}: {found} not {expected}"
                );
                let energies = sim.energies();
                let lost = energies.plastic_dissipated / separation(radius);
                assert!((lost - 1.0).abs() < 1e-4, "{partner:?}, {ratio}: {lost}");
                assert!(
                    energies.elastic == 0.0 && energies.viscous_dissipated == 0.0,
                    "{energies:?}"
                );
                residual = residual.max(energies.residual.abs());
            }
        }
        report("largest error of the restitution of jkr", largest);
        report("largest residual", residual);
        assert!(residual < 1e-4, "{residual}");
    });
}

#[test]
fn a_stuck_grain_comes_to_rest_in_debt() {
    on_threads(1, || {
        for partner in PARTNERS {
            let (radius, mass) = partner.size();
            let speed = 0.5 * (2.0 * separation(radius) / mass).sqrt();
            let normal = [("work_of_adhesion", WORK), ("alpha", 0.3)];
            let mut sim = impact(&normal, "jkr", partner, speed);
            for _ in 0..200_000 {
                sim.step().unwrap();
            }
            let energies = sim.energies();
            // the well at rest, from the energy of JKR at a^3 = 9 pi w R^2/(2 E): (16 E/3 R^2) z_c^10 (0.6 - ...)
            let least = libm::pow(PI * WORK * radius * radius / (8.0 * effective()), 1.0 / 6.0);
            let rest = libm::cbrt(6.0) * least;
            let inside = |z: f64| {
                let (cube, least3) = (z * z * z, least * least * least);
                cube * z * (0.1 * cube * cube - least3 * cube + 1.5 * least3 * least3)
            };
            let well = 16.0 / 3.0 * effective() / (radius * radius) * (inside(rest) - inside(least));
            let relative = energies.elastic / well;
            assert!((relative - 1.0).abs() < 1e-4, "{partner:?}: {relative}");
            assert!(energies.residual.abs() < 1e-4, "{partner:?}: {}", energies.residual);
        }
    });
}

/// Largest pull on a wall that slowly lifts a grain off what it lies on; `strong` holds the grain to the lifting wall,
/// and, with a second grain, that to the floor.
fn largest_pull(weak: &Laws, grains: usize, weak_dent: f64) -> f64 {
    let strong = Laws::of(law("jkr", &[("work_of_adhesion", 4.0 * WORK), ("alpha", 0.5)]));
    let list = [material(MODULUS), material(MODULUS), material(MODULUS)];
    // material 0: grains; 1: what holds strongly; 2: a floor that holds weakly
    let materials = Materials::new(list.to_vec(), |a, b| {
        if a.max(b) == 1 {
            strong.0.clone()
        } else {
            weak.0.clone()
        }
    });
    let mut case = Case::new(materials.unwrap());
    let floor = if grains == 1 { 2 } else { 1 };
    case.wall(floor, plane(0.0, 1.0), Motion::Rest);
    // all contacts at about their rest
    let dent = libm::pow(4.5 * PI * 4.0 * WORK * RADIUS * RADIUS / effective(), 2.0 / 3.0) / (3.0 * RADIUS);
    let bottom = if grains == 1 { weak_dent } else { dent };
    let mut height = RADIUS - bottom;
    for _ in 0..grains {
        case.grain(RADIUS, DVec3::Z * height, DVec3::ZERO);
        height += 2.0 * RADIUS - weak_dent;
    }
    let top = height - RADIUS + weak_dent - dent;
    let speed = 1e-5;
    case.wall(1, plane(top, -1.0), Motion::Velocity(DVec3::Z * speed));
    let mut sim = case.simulation();
    let mut largest = 0.0f64;
    let mut quiet = 0;
    let steps = (8.0 * dent / speed / sim.dt()) as u64;
    for _ in 0..steps {
        sim.step().unwrap();
        // the grain's pull on the wall is downwards
        let pull = -sim.walls[1].load().0.z;
        largest = largest.max(pull);
        quiet = if pull < 0.2 * largest { quiet + 1 } else { 0 };
        if quiet > 2000 {
            return largest;
        }
    }
    panic!("the grain was not pulled off");
}

#[test]
fn pull_off_forces_under_a_slowly_moving_wall() {
    let adhesion = ("work_of_adhesion", WORK);
    let damped = |name: &str| Laws::of(law(name, &[adhesion, ("alpha", 0.5)]));
    let stiffness = 4.0 / 3.0 * effective();
    on_threads(1, || {
        for grains in [1, 2] {
            let radius = if grains == 1 { RADIUS } else { 0.5 * RADIUS };
            let unit = PI * WORK * radius;
            let pull = 2.0 * PI * 2e4 * radius;
            let k = stiffness * radius.sqrt();
            let cohesive = [("cohesion_energy_density", 2e4), ("alpha", 0.5)];
            let jkr_dent = libm::pow(4.5 * unit * radius / effective(), 2.0 / 3.0) / (3.0 * radius);
            let dmt_dent = libm::pow(2.0 * unit / k, 2.0 / 3.0);
            for (name, laws, dent, expected) in [
                ("jkr", damped("jkr"), jkr_dent, 1.5 * unit),
                ("dmt", damped("dmt"), dmt_dent, 2.0 * unit),
                (
                    "sjkr",
                    Laws::of(law("sjkr", &cohesive)),
                    pull * pull / (k * k),
                    4.0 * pull * pull * pull / (27.0 * k * k),
                ),
            ] {
                let found = largest_pull(&laws, grains, dent);
                report(
                    &format!("pull-off of {name}, {grains} grains, over its closed form"),
                    found / expected,
                );
                assert!(
                    (found / expected - 1.0).abs() < 3e-3,
                    "{name}, {grains}: {found} not {expected}"
                );
            }
        }
    });
}

#[test]
fn plastic_grains_return_the_closed_form() {
    on_threads(1, || {
        let limit = 3e4;
        let mut largest = 0.0f64;
        for partner in PARTNERS {
            let (radius, mass) = partner.size();
            let e4 = libm::pow(effective(), 4.0);
            let share = 16.0 / 15.0 * libm::pow(0.5 * PI, 5.0);
            let yields = (share * libm::pow(limit, 5.0) * libm::pow(radius, 3.0) / (e4 * mass)).sqrt();
            for ratio in [1.2, 2.0, 4.0] {
                let speed = ratio * yields;
                let mut sim = impact(&[("yield_pressure", limit)], "thornton-ning", partner, speed);
                let found = outcome(&mut sim, speed).unwrap();
                let x: f64 = 1.0 / ratio;
                let expected = (6.0 * 3f64.sqrt() / 5.0).sqrt()
                    * (1.0 - x * x / 6.0).sqrt()
                    * libm::pow(x / (x + 2.0 * (1.2 - 0.2 * x * x).sqrt()), 0.25);
                largest = largest.max((found - expected).abs());
                assert!(
                    (found - expected).abs() < 1e-4,
                    "{partner:?}, {ratio}: {found} not {expected}"
                );
                assert!(sim.energies().residual.abs() < 1e-4);
            }
        }
        report("largest error of the restitution of thornton-ning", largest);
    });
}

#[test]
fn a_requested_restitution_is_met_beside_adhesion() {
    on_threads(1, || {
        let mut largest = 0.0f64;
        for (name, parameter, value, asked, speed) in [
            ("jkr", "work_of_adhesion", WORK, 0.6, 0.05),
            ("dmt", "work_of_adhesion", WORK, 0.6, 0.05),
            // the pull stops it at once
            ("dmt", "work_of_adhesion", WORK, 0.1, 0.002),
            ("sjkr", "cohesion_energy_density", 1e3, 0.6, 0.05),
            ("thornton-ning", "yield_pressure", 1e6, 0.6, 0.05),
        ] {
            let normal = [(parameter, value), ("restitution", asked), ("impact_speed", speed)];
            for partner in PARTNERS {
                let found = outcome(&mut impact(&normal, name, partner, speed), speed).unwrap();
                largest = largest.max((found - asked).abs());
                assert!((found - asked).abs() < 1e-4, "{name}, {partner:?}: {found}");
            }
        }
        report("largest error of the requested restitution", largest);
    });
}

#[test]
fn a_contact_held_across_a_gap_has_friction_with_a_spring() {
    // a grain hangs from a ceiling at 0.95 of its pull-off force, where the surfaces of the undeformed bodies are apart
    // already; a push along the ceiling makes it roll, at 5/7 of what it would slide with
    let normal = law("jkr", &[("work_of_adhesion", WORK), ("alpha", 0.5)]);
    let laws = Laws::of(normal).friction(law("mindlin-history", &[("friction", 0.5)]));
    let mut case = Case::new(one_material(MODULUS, &laws));
    case.plane(0, DVec3::ZERO, -DVec3::Z);
    case.grain(RADIUS, -DVec3::Z * (RADIUS - 1e-8), DVec3::ZERO);
    let mass = case.grains.mass(0);
    let pull = 0.95 * 1.5 * PI * WORK * RADIUS / mass;
    let along = 0.02 * pull;
    let mut sim = case.simulation();
    let dt = sim.dt();
    on_threads(1, || {
        const RAMP: u32 = 40_000;
        for step in 0..RAMP {
            let share = f64::from(step) / f64::from(RAMP);
            sim.gravity = DVec3::new(0.0, 0.0, -pull * share);
            sim.step().unwrap();
        }
        cases::advance(&mut sim, 2000.0 * dt);
        let gap = -sim.contact(&sim.contacts.walls[0], 0).overlap;
        assert!(gap > 0.0, "the contact is not stretched: gap {gap:e} m");
        sim.gravity.x = along;
        cases::advance(&mut sim, 2000.0 * dt);
        let (start, before) = (sim.time(), sim.grains().velocity[0].x);
        cases::advance(&mut sim, 20_000.0 * dt);
        let found = (sim.grains().velocity[0].x - before) / (sim.time() - start);
        report("acceleration over 5/7 of the push", found / (5.0 / 7.0 * along) - 1.0);
        assert!(
            (found / (5.0 / 7.0 * along) - 1.0).abs() < 0.01,
            "{found} m/s^2 of {along}"
        );
    });
}
