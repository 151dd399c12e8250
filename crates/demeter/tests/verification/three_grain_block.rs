//! Three grains (a block) and four (a pyramid) settle under gravity to the contact forces of statics.

use crate::cases::{Case, G, Laws, full, index, law, mass, on_threads, one_material, report, rough_and_smooth};
use demeter::measure::contact_records;
use demeter::output::ContactRecord;
use demeter::simulation::Simulation;
use demeter_physics::DVec3;

const RADIUS: f64 = 5e-3;
const YOUNG_MODULUS: f64 = 1e8;
/// Share of the weight that may be missing when the block has come to rest.
const BALANCE: f64 = 1e-6;
/// The exact forces are those of rigid spheres; overlaps of some 1e-4 of the radius turn the lines of centres.
const RIGID: f64 = 2e-3;

/// Runs until the kinetic energy is nothing against the elastic one.
fn settle(sim: &mut Simulation) {
    let limit = if full() { 4_000_000 } else { 1_000_000 };
    for step in 0..limit {
        sim.step().unwrap();
        if step % 200 == 199 {
            let e = sim.energies();
            if e.kinetic + e.rotational < 1e-18 * e.elastic {
                return;
            }
        }
    }
    panic!("the grains did not come to rest: {:?}", sim.energies());
}

/// Every grain is in balance, and the floor (wall 0) carries the weight.
fn check_balance(sim: &Simulation) -> Vec<ContactRecord> {
    let records = contact_records(sim);
    let weight = mass(RADIUS) * G;
    for id in 1..=sim.grains().len() as u32 {
        let mut force = DVec3::new(0.0, 0.0, -weight);
        let mut torque = DVec3::ZERO;
        for c in &records {
            let on_i = c.normal * c.repulsion() + c.tangential_force();
            let sign = if c.id_i == id { 1.0 } else { -1.0 };
            if c.id_i == id || c.id_j == id {
                force += on_i * sign;
                let arm = c.position - sim.grains().position[index(sim, id)];
                torque += arm.cross(on_i * sign) + c.rolling_torque() * sign;
            }
        }
        report(&format!("grain {id}: unbalanced force"), force.length() / weight);
        assert!(force.length() < BALANCE * weight, "grain {id}: {force}");
        assert!(torque.length() < BALANCE * weight * RADIUS, "grain {id}: {torque}");
    }
    let floor = sim.walls[0].load().0;
    let expected = weight * sim.grains().len() as f64;
    report("floor force over weight - 1", -floor.z / expected - 1.0);
    assert!((-floor.z / expected - 1.0).abs() < BALANCE, "{floor}");
    records
}

/// Magnitudes of normal and tangential force of the contact of two grains, or of a grain and a wall.
fn forces(records: &[ContactRecord], grain: u32, partner: Partner) -> (f64, f64) {
    let fits = |c: &&ContactRecord| match partner {
        Partner::Grain(other) => c.wall < 0 && (c.id_i, c.id_j) == (grain, other),
        Partner::Wall(wall) => c.wall == wall && c.id_i == grain,
    };
    let c = records.iter().find(fits).unwrap();
    (c.repulsion().abs(), c.tangential_force().length())
}

#[derive(Clone, Copy)]
enum Partner {
    Grain(u32),
    Wall(i32),
}

fn close(what: &str, found: f64, expected: f64, tolerance: f64) {
    report(&format!("{what}: error"), found / expected - 1.0);
    assert!(
        (found / expected - 1.0).abs() < tolerance,
        "{what}: {found}, expected {expected}"
    );
}

/// Two grains at `x = -c` and `c`, one on top of both. The angle of the lines of centres with the vertical is `sin = c/2r`.
fn block(case: &mut Case, c: f64) -> f64 {
    case.grain(RADIUS, DVec3::new(-c, 0.0, RADIUS), DVec3::ZERO);
    case.grain(RADIUS, DVec3::new(c, 0.0, RADIUS), DVec3::ZERO);
    let angle = libm::asin(c / (2.0 * RADIUS));
    let top = RADIUS + 2.0 * RADIUS * libm::cos(angle);
    case.grain(RADIUS, DVec3::new(0.0, 0.0, top), DVec3::ZERO);
    case.plane(0, DVec3::ZERO, DVec3::Z);
    case.gravity = DVec3::new(0.0, 0.0, -G);
    angle
}

/// Frictionless, between two walls: `N = W / (2 cos a)` between grains, `N sin a` on each wall, `W + W/2` on the floor.
#[test]
fn frictionless_block_between_two_walls() {
    on_threads(1, || {
        for laws in [Laws::hertz(0.3), Laws::linear(2e5, 0.3)] {
            let mut case = Case::new(one_material(YOUNG_MODULUS, &laws));
            let c = 1.2 * RADIUS;
            let angle = block(&mut case, c);
            case.plane(0, DVec3::new(-c - RADIUS, 0.0, 0.0), DVec3::X);
            case.plane(0, DVec3::new(c + RADIUS, 0.0, 0.0), -DVec3::X);
            let mut sim = case.simulation();
            settle(&mut sim);
            let records = check_balance(&sim);
            let weight = mass(RADIUS) * G;
            let between = weight / (2.0 * libm::cos(angle));
            for grain in [1, 2] {
                close("N", forces(&records, grain, Partner::Grain(3)).0, between, RIGID);
                close(
                    "floor",
                    forces(&records, grain, Partner::Wall(0)).0,
                    1.5 * weight,
                    BALANCE,
                );
                let side = forces(&records, grain, Partner::Wall(grain as i32)).0;
                close("side", side, between * libm::sin(angle), RIGID);
            }
        }
    });
}

/// With friction and no walls. Moments about a lower grain make the frictions `T` at floor and top equal, its balance
/// along x gives `T = N tan(a/2)`, and that of the top `2 (N cos a + T sin a) = W`: `N = W/2`, `T = W/2 tan(a/2)`.
#[test]
fn block_held_by_friction() {
    on_threads(1, || {
        for friction in ["mindlin-history", "linear-history"] {
            let mut parameters = vec![("friction", 0.8)];
            if friction == "linear-history" {
                parameters.push(("stiffness", 1e5));
            }
            let laws = Laws::hertz(0.3).friction(law(friction, &parameters));
            let mut case = Case::new(one_material(YOUNG_MODULUS, &laws));
            let angle = block(&mut case, 1.05 * RADIUS);
            let mut sim = case.simulation();
            settle(&mut sim);
            let records = check_balance(&sim);
            let half = 0.5 * mass(RADIUS) * G;
            let slope = libm::tan(0.5 * angle);
            for grain in [1, 2] {
                let (normal, tangential) = forces(&records, grain, Partner::Grain(3));
                close("N", normal, half, RIGID);
                close("T", tangential, half * slope, RIGID);
                let (normal, tangential) = forces(&records, grain, Partner::Wall(0));
                close("floor N", normal, 3.0 * half, BALANCE);
                close("floor T", tangential, half * slope, RIGID);
            }
        }
    });
}

/// Three grains on the corners of a triangle and one on top, as for the block: `N = W/3`, `T = W/3 tan(a/2)`.
#[test]
fn pyramid_held_by_friction() {
    on_threads(1, || {
        let rough = Laws::hertz(0.3).friction(law("mindlin-history", &[("friction", 0.8)]));
        let mut case = Case::new(rough_and_smooth(YOUNG_MODULUS, &rough, &Laws::hertz(0.3)));
        // distance of the lower grains from the axis; at 2/sqrt(3) r they would touch
        let d = 1.25 * RADIUS;
        for k in 0..3 {
            let angle = std::f64::consts::TAU * f64::from(k) / 3.0;
            let place = DVec3::new(d * libm::cos(angle), d * libm::sin(angle), RADIUS);
            case.grain(RADIUS, place, DVec3::ZERO);
        }
        let angle = libm::asin(d / (2.0 * RADIUS));
        let top = RADIUS + 2.0 * RADIUS * libm::cos(angle);
        case.grain(RADIUS, DVec3::new(0.0, 0.0, top), DVec3::ZERO);
        case.plane(0, DVec3::ZERO, DVec3::Z);
        case.gravity = DVec3::new(0.0, 0.0, -G);
        let mut sim = case.simulation();
        settle(&mut sim);
        let records = check_balance(&sim);
        let third = mass(RADIUS) * G / 3.0;
        let slope = libm::tan(0.5 * angle);
        for grain in [1, 2, 3] {
            let (normal, tangential) = forces(&records, grain, Partner::Grain(4));
            close("N", normal, third, RIGID);
            close("T", tangential, third * slope, RIGID);
            let (normal, tangential) = forces(&records, grain, Partner::Wall(0));
            close("floor N", normal, 4.0 * third, 10.0 * BALANCE);
            close("floor T", tangential, third * slope, RIGID);
        }
    });
}
