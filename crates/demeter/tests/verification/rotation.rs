//! Spin: free, driven by turning walls, and gained in oblique impacts.

use crate::cases::{
    Case, G, Laws, advance, full, hertz_overlap, law, mass, on_threads, one_material, report, rough_and_smooth,
};
use demeter::simulation::Simulation;
use demeter::walls::{Motion, Shape, Side};
use demeter_physics::DVec3;
use demeter_physics::contact::LawChoice;

const RADIUS: f64 = 5e-3;
const YOUNG_MODULUS: f64 = 1e8;

/// Without torque the angular velocity keeps its bits, and the orientation is the exact rotation to rounding.
#[test]
fn free_spin_is_exact() {
    on_threads(1, || {
        let mut case = Case::new(one_material(YOUNG_MODULUS, &Laws::hertz(0.9)));
        let spin = DVec3::new(20.0, -70.0, 35.0);
        case.spinning_grain(RADIUS, DVec3::ZERO, DVec3::X * 1e-3, spin);
        let mut sim = case.simulation();
        let steps = if full() { 1_000_000 } else { 50_000 };
        for _ in 0..steps {
            sim.step().unwrap();
        }
        assert_eq!(sim.grains().angular_velocity[0], spin);
        let angle = spin.length() * sim.time();
        let axis = spin.normalize();
        // Rodrigues
        let turned = |v: DVec3| {
            let (sin, cos) = (libm::sin(angle), libm::cos(angle));
            v * cos + axis.cross(v) * sin + axis * (axis.dot(v) * (1.0 - cos))
        };
        let error = [DVec3::X, DVec3::Y, DVec3::Z]
            .map(|v| (sim.grains().orientation.as_ref().unwrap()[0] * v - turned(v)).length())
            .into_iter()
            .fold(0.0, f64::max);
        report("turns", angle / std::f64::consts::TAU);
        report("orientation error", error);
        // one rounding per step, all the same way at worst
        assert!(error < 4.0 * f64::EPSILON * f64::from(steps), "{error}");
    });
}

const FRICTION: f64 = 0.2;

fn friction(name: &str) -> LawChoice {
    match name {
        "linear-history" => law(name, &[("friction", FRICTION), ("stiffness", 1e5)]),
        _ => law(name, &[("friction", FRICTION)]),
    }
}

/// A grain resting on a wall that turns, kept in place by smooth guides: its spin grows as `5/2 mu g l/r^2 t` until its
/// surface keeps up with the wall, and stays there.
fn spin_up(shape: Shape, motion: Motion, law_name: &str, place: DVec3, surface_speed: f64) {
    let rough = Laws::hertz(0.5).friction(friction(law_name));
    let mut case = Case::new(rough_and_smooth(YOUNG_MODULUS, &rough, &Laws::hertz(0.5)));
    let overlap = hertz_overlap(YOUNG_MODULUS, RADIUS, mass(RADIUS) * G);
    let place = place - DVec3::Z * overlap;
    case.grain(RADIUS, place, DVec3::ZERO);
    case.wall(0, shape, motion);
    for side in [DVec3::X, -DVec3::X, DVec3::Y, -DVec3::Y] {
        case.plane(1, place - side * RADIUS, side);
    }
    case.gravity = DVec3::new(0.0, 0.0, -G);
    let mut sim = case.simulation();
    let l = RADIUS - overlap;
    let rate = 2.5 * FRICTION * G * l / (RADIUS * RADIUS);
    let expected = surface_speed / l;
    let duration = expected.abs() / rate;
    advance(&mut sim, 0.5 * duration);
    let half_way = sim.grains().angular_velocity[0].y;
    let slope = half_way / sim.time() / rate * expected.signum() - 1.0;
    advance(&mut sim, duration + 0.1);
    let spin = sim.grains().angular_velocity[0];
    let end = spin.y / expected - 1.0;
    let label = format!("{law_name} at {surface_speed} m/s");
    report(&format!("{label}: rate"), slope);
    report(&format!("{label}: final spin"), end);
    // the guides give way by their overlap, some 1e-5 of the radius of a cylinder or disc
    assert!(slope.abs() < 2e-3, "{label}: {slope}");
    assert!(end.abs() < 2e-3, "{label}: {end}");
}

#[test]
fn a_turning_cylinder_spins_a_grain_up_to_its_surface_speed() {
    on_threads(1, || {
        for law_name in ["mindlin-history", "linear-history", "coulomb"] {
            for (side, height) in [(Side::Outside, -0.1), (Side::Inside, 0.1)] {
                let shape = Shape::Cylinder {
                    start: DVec3::new(0.0, -0.05, height),
                    end: DVec3::new(0.0, 0.05, height),
                    radius: height.abs(),
                    side,
                };
                let motion = Motion::Rotation {
                    point: DVec3::Z * height,
                    axis: DVec3::Y,
                    angular_velocity: 4.0,
                };
                // the surface at the origin moves at w x arm along x; the grain's lowest point at -w l along x
                let surface_speed = 4.0 * height;
                spin_up(shape, motion, law_name, DVec3::Z * RADIUS, surface_speed);
            }
        }
    });
}

#[test]
fn a_turning_disc_spins_a_grain_up_to_its_surface_speed() {
    on_threads(1, || {
        for law_name in ["mindlin-history", "linear-history", "coulomb"] {
            let shape = Shape::Disc {
                center: DVec3::ZERO,
                normal: DVec3::Z,
                radius: 0.2,
            };
            let motion = Motion::Rotation {
                point: DVec3::ZERO,
                axis: DVec3::Z,
                angular_velocity: 3.0,
            };
            // at (0, d) the disc moves at -w d along x
            let place = DVec3::new(0.0, 0.1, RADIUS);
            spin_up(shape, motion, law_name, place, 0.3);
        }
    });
}

/// Impact on a plane at an angle to its normal: the state after it, and the impulse of the repulsive normal force.
fn impact(laws: &Laws, speed: f64, angle: f64) -> (Simulation, f64) {
    let mut case = Case::new(one_material(7e9, laws));
    let v = DVec3::new(libm::sin(angle), 0.0, -libm::cos(angle)) * speed;
    case.grain(RADIUS, DVec3::new(0.0, 0.0, RADIUS * 1.0001), v);
    case.plane(0, DVec3::ZERO, DVec3::Z);
    let mut sim = case.simulation();
    let (mut repulsion, mut touched) = (0.0, false);
    loop {
        sim.step().unwrap();
        let chunks = || sim.contacts.walls.iter();
        let forces = || chunks().flat_map(|chunk| (0..chunk.len()).map(|k| chunk.normal_force(k)));
        if touched && forces().count() == 0 {
            return (sim, repulsion);
        }
        touched |= forces().count() > 0;
        repulsion += forces().map(|f| f.max(0.0)).sum::<f64>() * sim.dt();
        assert!(sim.step < 1_000_000, "the collision never ended");
    }
}

/// Gross sliding (Walton 1993; Foerster et al., Phys. Fluids 6 (1994) 1108; Kharaz et al., Powder Technol. 120 (2001)
/// 281): while `tan(angle) > 7/2 mu (1 + e)`, the tangential impulse is `mu` times the normal one, `J_n = m (1 + e) v_n`,
/// and the rebound spin `5/2 mu (1 + e) v_n/r`.
///
/// A damped contact attracts a little before it parts (its normal force is negative there), and friction is limited by
/// the repulsive part only. So with `e < 1` the normal impulse that friction goes with is that of the repulsion, which is
/// larger than `J_n` by a few percent at `e = 0.5`.
#[test]
fn an_oblique_impact_in_gross_sliding() {
    on_threads(1, || {
        for law_name in ["mindlin-history", "linear-history", "coulomb"] {
            for e in [0.5, 0.9, 1.0] {
                for degrees in [70f64, 80.0, 85.0] {
                    let mut choice = friction(law_name);
                    if law_name == "linear-history" {
                        choice.parameters.insert("stiffness".into(), 5e6.into());
                    }
                    let angle = degrees.to_radians();
                    let (sim, repulsion) = impact(&Laws::hertz(e).friction(choice), 2.0, angle);
                    let (sin, cos) = (libm::sin(angle), libm::cos(angle));
                    let (v, spin) = (sim.grains().velocity[0], sim.grains().angular_velocity[0].y);
                    let normal = v.z + 2.0 * cos;
                    let tangential = 2.0 * sin - v.x;
                    let label = format!("{law_name}, e {e}, {degrees} degrees");
                    assert!(
                        (normal / (2.0 * cos * (1.0 + e)) - 1.0).abs() < 1e-4,
                        "{label}: {normal}"
                    );
                    let repulsive = repulsion / mass(RADIUS);
                    let attraction = repulsive / normal - 1.0;
                    report(&format!("{label}: share of the attraction"), attraction);
                    if e == 1.0 {
                        // forces are told in single precision
                        assert!(attraction.abs() < 1e-8, "{label}: {attraction}");
                    }
                    let share = tangential / (FRICTION * repulsive) - 1.0;
                    report(&format!("{label}: impulse"), share);
                    assert!(share.abs() < 1e-3, "{label}: {share}");
                    // the overlap, some 1e-3 of the radius, shortens the lever
                    let spin_error = spin / (2.5 * FRICTION * repulsive / RADIUS) - 1.0;
                    report(&format!("{label}: spin"), spin_error);
                    assert!(spin_error.abs() < 1e-2, "{label}: {spin_error}");
                }
            }
        }
    });
}

/// Sticking: below the limit, a grain whose contact rolls at the end leaves with `2/7` of its tangential velocity lost
/// (`coulomb`, which has no spring to give anything back).
#[test]
fn an_oblique_impact_that_ends_rolling() {
    on_threads(1, || {
        let laws = Laws::hertz(0.9).friction(law("coulomb", &[("friction", 0.8)]));
        let angle = 30f64.to_radians();
        let (sim, _) = impact(&laws, 2.0, angle);
        let lost = 1.0 - sim.grains().velocity[0].x / (2.0 * libm::sin(angle));
        report("tangential velocity lost over 2/7", lost * 3.5 - 1.0);
        assert!((lost * 3.5 - 1.0).abs() < 1e-2, "{lost}");
    });
}

/// A grain that spins on a floor like a top is slowed by `5/2 mu_t g/r` where its contact resists torsion, and comes to rest; where
/// it does not, it spins for ever.
#[test]
fn a_top_is_stopped_by_torsion() {
    on_threads(1, || {
        let (mu, start) = (0.02, 2.0);
        let deceleration = 2.5 * mu * G / RADIUS;
        for (name, torsion) in [("epsd-torsion", mu), ("epsd", 0.0)] {
            let mut laws = Laws::hertz(0.5).friction(friction("mindlin-history"));
            laws.0.rolling = Some(match name {
                "epsd" => law(name, &[("rolling_friction", 0.1)]),
                _ => law(name, &[("rolling_friction", 0.1), ("torsion_friction", torsion)]),
            });
            let mut case = Case::new(one_material(YOUNG_MODULUS, &laws));
            case.plane(0, DVec3::ZERO, DVec3::Z);
            let overlap = hertz_overlap(YOUNG_MODULUS, RADIUS, mass(RADIUS) * G);
            case.spinning_grain(RADIUS, DVec3::Z * (RADIUS - overlap), DVec3::ZERO, DVec3::Z * start);
            case.gravity = DVec3::NEG_Z * G;
            let mut sim = case.simulation();
            let stop = start / deceleration;
            let spin = |sim: &Simulation| sim.grains().angular_velocity[0].z;
            advance(&mut sim, 0.5 * stop);
            let expected = if torsion > 0.0 { 0.5 } else { 1.0 };
            report("spin half way, over that at first", spin(&sim) / start);
            assert!((spin(&sim) / start - expected).abs() < 1e-3, "{name}: {}", spin(&sim));
            // the spring swings back and forth meanwhile
            advance(&mut sim, 15.0 * stop);
            let energies = sim.energies();
            let first = 0.5 * 0.4 * mass(RADIUS) * RADIUS * RADIUS * start * start;
            report("spin in the end", spin(&sim));
            report("lost over the energy at first", energies.rolling_dissipated / first);
            if torsion > 0.0 {
                assert!(spin(&sim).abs() < 1e-3 * start, "{}", spin(&sim));
                assert!((energies.rolling_dissipated / first - 1.0).abs() < 1e-3, "{energies:?}");
            } else {
                assert_eq!(spin(&sim), start);
            }
            assert!(energies.residual.abs() < 1e-4, "{energies:?}");
        }
    });
}
