//! The error of collisions falls with the square of the time step with velocity Verlet; with the predictor-corrector too
//! where the kinks at the ends of a contact are steps or ramps.

use crate::cases::{
    Case, Laws, advance, fitted_order, full, index, law, on_threads, one_material, report, run_until_parted,
};
use demeter::simulation::SAFE_SHARE;
use demeter_physics::DVec3;
use demeter_physics::integrator::Integrator;

const RADIUS: f64 = 2e-3;
const YOUNG_MODULUS: f64 = 1e8;
/// The automatic time step divided by these.
const DIVISORS: [f64; 4] = [0.25, 0.5, 1.0, 2.0];

/// Largest error of a trajectory through a collision at the automatic time step, in radii and impact speeds.
const AUTOMATIC: f64 = 5e-4;

/// Least order of collisions, where second order is expected of velocity Verlet.
///
/// The predictor-corrector takes the plain force from a few steps after the first touch on. A dashpot that rises as the
/// fourth root of the overlap has no derivative there, so that the order is 5/4, at a small error; so it is where sliding
/// turns.
fn least_order(integrator: Integrator, smooth: bool) -> f64 {
    match (integrator, smooth) {
        (Integrator::Gear, false) => 1.2,
        _ => 1.8,
    }
}

fn laws() -> [(&'static str, Laws, f64); 6] {
    [
        ("hertz-tsuji, e 0.9", Laws::hertz(0.9), 0.9),
        ("hertz-tsuji, e 0.5", Laws::hertz(0.5), 0.5),
        ("hertz-tsuji, e 0.2", Laws::hertz(0.2), 0.2),
        ("linear, e 0.9", Laws::linear(1e5, 0.9), 0.9),
        ("linear, e 0.5", Laws::linear(1e5, 0.5), 0.5),
        ("linear, e 0.2", Laws::linear(1e5, 0.2), 0.2),
    ]
}

/// Root mean square over the phase at which steps hit the contact of the error of the restitution.
fn restitution_error(integrator: Integrator, laws: &Laws, expected: f64, divisor: f64) -> f64 {
    let phases = if full() { 64 } else { 16 };
    let mut sum = 0.0;
    for phase in 0..phases {
        let mut case = Case::new(one_material(YOUNG_MODULUS, laws));
        case.integrator = integrator;
        case.share = SAFE_SHARE / divisor;
        let v = DVec3::X * 0.3;
        case.grain(RADIUS, -DVec3::X * 2.0 * RADIUS, v);
        case.grain(RADIUS, DVec3::ZERO, DVec3::ZERO);
        let mut setup = case.setup();
        setup.grains.position[0] -= v * setup.dt * (3.0 + f64::from(phase) / f64::from(phases));
        let mut sim = demeter::simulation::Simulation::new(setup);
        run_until_parted(&mut sim);
        let (a, b) = (index(&sim, 1), index(&sim, 2));
        let e = (sim.grains().velocity[b] - sim.grains().velocity[a]).x / 0.3;
        sum += (e - expected) * (e - expected);
    }
    (sum / f64::from(phases)).sqrt()
}

#[test]
fn restitution_converges_with_second_order() {
    restitution_converges(Integrator::VelocityVerlet);
}

#[test]
fn restitution_converges_with_gear() {
    restitution_converges(Integrator::Gear);
}

fn restitution_converges(integrator: Integrator) {
    on_threads(1, || {
        for (name, laws, e) in laws() {
            let errors: Vec<(f64, f64)> = (DIVISORS.iter())
                .map(|&d| (SAFE_SHARE / d, restitution_error(integrator, &laws, e, d)))
                .collect();
            for (share, error) in &errors {
                report(
                    &format!("{name}: error of e at {share} of the shortest time scale"),
                    *error,
                );
            }
            let order = fitted_order(&errors);
            report(&format!("{name}: order"), order);
            let least = least_order(integrator, name.starts_with("linear"));
            assert!(order > least, "{name}: order {order} from {errors:?}");
        }
    });
}

/// Position, velocity and spin of a grain that has met another obliquely, at one moment after they parted.
fn after_an_oblique_collision(integrator: Integrator, laws: &Laws, divisor: f64) -> [DVec3; 3] {
    let mut case = Case::new(one_material(YOUNG_MODULUS, laws));
    case.integrator = integrator;
    let v = DVec3::new(0.3, 0.0, 0.05);
    let n = DVec3::new(0.8, 0.6, 0.0);
    case.grain(RADIUS, -n * 2.0 * RADIUS - v * 1.234e-5, v);
    case.spinning_grain(1.5 * RADIUS, n * 0.5 * RADIUS, DVec3::ZERO, DVec3::new(5.0, 0.0, -30.0));
    let mut setup = case.setup();
    // whole numbers of steps to the same moment, whatever the divisor
    let duration = 600.0 * setup.dt;
    setup.dt /= divisor;
    let mut sim = demeter::simulation::Simulation::new(setup);
    advance(&mut sim, duration);
    assert_eq!(sim.contacts.pair_count(), 0, "the grains still touch");
    let k = index(&sim, 1);
    [
        sim.grains().position[k] / RADIUS,
        sim.grains().velocity[k] / 0.3,
        sim.grains().angular_velocity[k] * RADIUS / 0.3,
    ]
}

#[test]
fn trajectories_converge_with_second_order() {
    trajectories_converge(Integrator::VelocityVerlet);
}

#[test]
fn trajectories_converge_with_gear() {
    trajectories_converge(Integrator::Gear);
}

fn trajectories_converge(integrator: Integrator) {
    on_threads(1, || {
        let frictions = [
            ("frictionless", None, true),
            ("coulomb", Some(law("coulomb", &[("friction", 0.05)])), true),
            // sticks and slips: at every change the force has a kink somewhere in a step, so only the size is told
            (
                "mindlin-history",
                Some(law("mindlin-history", &[("friction", 0.3)])),
                false,
            ),
        ];
        for (name, laws, _) in laws() {
            for (friction, choice, known) in &frictions {
                let laws = match choice {
                    Some(choice) => laws.clone().friction(choice.clone()),
                    None => laws.clone(),
                };
                let reference = after_an_oblique_collision(integrator, &laws, 128.0);
                let errors: Vec<(f64, f64)> = (DIVISORS.iter())
                    .map(|&d| {
                        let found = after_an_oblique_collision(integrator, &laws, d);
                        let error = (0..3).map(|k| (found[k] - reference[k]).length()).fold(0.0, f64::max);
                        (1.0 / d, error)
                    })
                    .collect();
                let order = fitted_order(&errors);
                report(&format!("{name}, {friction}: error at the automatic step"), errors[2].1);
                report(&format!("{name}, {friction}: order"), order);
                let smooth = name.starts_with("linear") && choice.is_none();
                let least = if *known {
                    least_order(integrator, smooth)
                } else {
                    f64::NEG_INFINITY
                };
                assert!(order > least, "{name}, {friction}: order {order} from {errors:?}");
                assert!(errors[2].1 < AUTOMATIC, "{name}, {friction}: {errors:?}");
            }
        }
    });
}
