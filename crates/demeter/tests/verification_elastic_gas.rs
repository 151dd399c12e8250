//! An elastic gas without friction keeps its energy and, in a periodic box, its momentum.

mod cases;

use cases::beds::fill;
use cases::{Case, Laws, full, on_threads, one_material, report};
use demeter::particles::Domain;
use demeter::simulation::{Setup, Simulation};
use demeter::walls::{Motion, Shape};
use demeter_physics::DVec3;
use std::f64::consts::PI;

/// What the issue asks of 1000 grains over 1e5 steps.
const ENERGY_TOLERANCE: f64 = 1e-6;
/// Momentum changes by the rounding of one addition per contact and step.
const MOMENTUM_TOLERANCE: f64 = 1e-13;

const YOUNG_MODULUS: f64 = 7e10;

/// Standard deviation of the velocity in each direction [m/s].
///
/// Velocity Verlet keeps `E - dt^2/8 sum F^2/m`, so the energy of the moment swings with the contacts that are loaded.
/// At this speed few are at a time.
const SPEED: f64 = 0.05;

fn gas(laws: &Laws, fraction: f64, periodic: bool) -> Setup {
    let count = if full() { 1000 } else { 500 };
    let mut case = Case::new(one_material(YOUNG_MODULUS, laws));
    let r = cases::beds::RADIUS;
    let a = libm::cbrt(f64::from(count) * 4.0 / 3.0 * PI * r * r * r * 1.0625 / fraction);
    case.domain = Domain {
        lower: DVec3::ZERO,
        upper: DVec3::splat(a),
        periodic: [periodic; 3],
        ..case.domain
    };
    fill(&mut case, DVec3::ZERO, DVec3::splat(a), count, SPEED);
    if !periodic {
        let shape = Shape::Box {
            lower: DVec3::ZERO,
            upper: DVec3::splat(a),
            open: [false; 6],
        };
        case.wall(0, shape, Motion::Rest);
        case.domain.lower -= 0.1 * a;
        case.domain.upper += 0.1 * a;
    }
    case.skin = 0.3 * r;
    case.setup()
}

fn momentum(sim: &Simulation) -> (DVec3, f64) {
    let each = || sim.grains.velocity.iter().zip(&sim.grains.mass).map(|(v, m)| *v * *m);
    (each().sum(), each().map(|p| p.length()).sum())
}

/// Largest relative change of the energy, number of contacts seen at the looks, largest relative change of the momentum.
fn run(setup: Setup, steps: u64) -> (f64, usize, f64) {
    let mut sim = Simulation::new(setup);
    sim.start().unwrap();
    let first = sim.energies();
    assert_eq!(first.elastic, 0.0, "the gas starts without contacts");
    let (start, scale) = momentum(&sim);
    let (mut energy, mut contacts, mut drift) = (0.0f64, 0, 0.0f64);
    for step in 0..steps {
        sim.step().unwrap();
        if step % 50 == 0 {
            let now = sim.energies();
            energy = energy.max((now.present() / first.present() - 1.0).abs());
            contacts += sim.contacts.pair_count() + sim.contacts.wall_count();
            drift = drift.max((momentum(&sim).0 - start).length() / scale);
        }
    }
    (energy, contacts, drift)
}

fn keeps_energy(name: &str, laws: &Laws) {
    let steps = if full() { 100_000 } else { 10_000 };
    for fraction in [0.1, 0.4] {
        for periodic in [true, false] {
            let (energy, contacts, drift) = on_threads(2, || run(gas(laws, fraction, periodic), steps));
            let label = format!("{name}, fraction {fraction}, periodic {periodic}");
            report(&format!("{label}: energy"), energy);
            report(&format!("{label}: contacts seen"), contacts as f64);
            report(&format!("{label}: momentum"), drift);
            assert!(contacts > 20, "{label}: {contacts} contacts, so nothing was tested");
            assert!(energy < ENERGY_TOLERANCE, "{label}: {energy}");
            assert!(!periodic || drift < MOMENTUM_TOLERANCE, "{label}: {drift}");
        }
    }
}

#[test]
fn hertzian_gas() {
    keeps_energy("hertz-tsuji", &Laws::hertz(1.0));
}

#[test]
fn linear_gas() {
    keeps_energy("linear", &Laws::linear(1e7, 1.0));
}
