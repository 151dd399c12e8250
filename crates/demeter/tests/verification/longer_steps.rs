//! What a time step above the automatic one costs, as a message before the run tells it.

use crate::cases::{Case, Laws, full, index, law, on_threads, one_material, report, run_until_parted};
use demeter::simulation::{RESTITUTION_ERROR, SAFE_SHARE, Simulation, unsafe_share};
use demeter_physics::DVec3;
use demeter_physics::integrator::Integrator;
use demeter_physics::parameters::Value;

const RADIUS: f64 = 2e-3;
const YOUNG_MODULUS: f64 = 1e8;
const SPEED: f64 = 1.0;

fn zero_force(mut laws: Laws) -> Laws {
    let end = Value::from("zero-force");
    laws.0.normal.parameters.insert("contact_end".to_string(), end);
    laws
}

fn collide(integrator: Integrator, share: f64, laws: &Laws, normal: DVec3, phase: f64) -> DVec3 {
    let mut case = Case::new(one_material(YOUNG_MODULUS, laws));
    case.integrator = integrator;
    case.share = share;
    let v = DVec3::X * SPEED;
    case.grain(RADIUS, -normal * 2.0 * RADIUS, v);
    case.grain(RADIUS, DVec3::ZERO, DVec3::ZERO);
    let mut setup = case.setup();
    setup.grains.position[0] -= v * setup.dt * (3.0 + phase);
    let mut sim = Simulation::new(setup);
    run_until_parted(&mut sim);
    let (a, b) = (index(&sim, 1), index(&sim, 2));
    sim.grains().velocity[b] - sim.grains().velocity[a]
}

/// Laws for a restitution.
type OfRestitution = fn(f64) -> Laws;

/// Largest error of the restitution at a step, over laws, restitutions and the phase of the step.
fn largest_error(integrator: Integrator, share: f64) -> f64 {
    let phases = if full() { 64 } else { 8 };
    let mut largest = 0.0f64;
    let laws: [(&str, OfRestitution); 3] = [
        ("hertz-tsuji", Laws::hertz),
        ("linear", |e| Laws::linear(1e5, e)),
        ("linear, zero-force", |e| zero_force(Laws::linear(1e5, e))),
    ];
    for (name, laws) in laws {
        let mut of_law = 0.0f64;
        for e in [0.02, 0.1, 0.3, 0.5, 0.7, 0.9, 0.99] {
            for phase in 0..phases {
                let phase = f64::from(phase) / f64::from(phases);
                let found = collide(integrator, share, &laws(e), DVec3::X, phase).x / SPEED;
                of_law = of_law.max((found - e).abs());
            }
        }
        report(&format!("{name}, share {share}: largest error of e"), of_law);
        largest = largest.max(of_law);
    }
    largest
}

#[test]
fn restitution_is_met_as_is_told_of_longer_steps() {
    on_threads(1, || {
        for integrator in [Integrator::VelocityVerlet, Integrator::Gear] {
            for share in [SAFE_SHARE, 2.0 * SAFE_SHARE, unsafe_share(integrator)] {
                let times = share / SAFE_SHARE;
                let told = RESTITUTION_ERROR * times * times;
                let largest = largest_error(integrator, share);
                assert!(largest < told, "{largest}");
            }
        }
    });
}

/// The energy of an elastic grain between two planes swings by a share that grows with the square of the step.
#[test]
fn the_error_of_energy_grows_with_the_square_of_the_step() {
    let error = |share: f64| {
        let mut case = Case::new(one_material(YOUNG_MODULUS, &Laws::linear(1e5, 1.0)));
        case.share = share;
        case.grain(RADIUS, DVec3::ZERO, DVec3::X * SPEED);
        for side in [-1.0, 1.0] {
            case.plane(0, DVec3::X * (side * 0.97 * RADIUS), DVec3::X * -side);
        }
        let mut sim = case.simulation();
        let mut books = Vec::new();
        for _ in 0..(20.0 / share) as usize {
            sim.step().unwrap();
            books.push(sim.energies().residual.abs());
        }
        books.into_iter().fold(0.0, f64::max)
    };
    on_threads(1, || {
        let shares = [1.0, 2.0, 4.0, 10.0].map(|times| times * SAFE_SHARE);
        let errors = shares.map(error);
        for (share, error) in shares.iter().zip(errors) {
            report(&format!("share {share}: largest residual"), error);
            let expected = errors[0] * (share / SAFE_SHARE) * (share / SAFE_SHARE);
            assert!((error / expected - 1.0).abs() < 0.2, "{error}, {expected}");
        }
    });
}

/// Where friction sticks and slips, the force has kinks within steps.
#[test]
fn friction_that_sticks_and_slips_is_met_as_is_told() {
    let angles = if full() { 200 } else { 12 };
    on_threads(1, || {
        for e in [0.3, 0.9] {
            let laws = Laws::hertz(e).friction(law("mindlin-history", &[("friction", 0.3)]));
            for (times, told) in [(1.0, 1e-3), (10.0, 1e-2)] {
                let mut largest = 0.0f64;
                for k in 1..angles {
                    let angle = 1.4 * f64::from(k) / f64::from(angles);
                    let normal = DVec3::new(libm::cos(angle), libm::sin(angle), 0.0);
                    let found = |share: f64| collide(Integrator::VelocityVerlet, share, &laws, normal, 0.37);
                    let difference = found(times * SAFE_SHARE) - found(0.1 * SAFE_SHARE);
                    largest = largest.max(difference.length() / SPEED);
                }
                report(&format!("e {e}, {times} times: largest difference"), largest);
                assert!(largest < told, "{largest}");
            }
        }
    });
}
