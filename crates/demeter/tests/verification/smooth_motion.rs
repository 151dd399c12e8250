//! Order of both integrators where forces are smooth: a grain pressed between two planes swings and never parts.

use crate::cases;

use crate::cases::{Case, Laws, fitted_order, on_threads, one_material, report};
use demeter::particles::HigherDerivatives;
use demeter::simulation::{SAFE_SHARE, Simulation};
use demeter_physics::DVec3;
use demeter_physics::integrator::Integrator;
use std::f64::consts::PI;

const RADIUS: f64 = 2e-3;
const YOUNG_MODULUS: f64 = 1e8;
const STIFFNESS: f64 = 1e5;
/// Overlap with each plane at rest [m].
const REST: f64 = 0.02 * RADIUS;
/// Start, in units of the overlap at rest and of that times the angular frequency: half of what would part the bodies.
const START: (f64, f64) = (0.3, 0.4);
/// The automatic time step divided by these.
const DIVISORS: [f64; 4] = [0.25, 0.5, 1.0, 2.0];

/// The exact equation of motion: the acceleration at place and velocity, and its derivatives along the motion.
#[derive(Clone, Copy)]
enum System {
    /// `a = -w^2 x - 2 g v`.
    Linear { restitution: f64 },
    /// `a = K/m ((h - x)^(3/2) - (h + x)^(3/2))`.
    Hertz,
}

impl System {
    fn laws(self) -> Laws {
        match self {
            Self::Linear { restitution } => Laws::linear(STIFFNESS, restitution),
            Self::Hertz => Laws::hertz(1.0),
        }
    }

    /// `K/m` of the Hertzian contact, `w^2` and `2 g` of the linear ones, with both planes.
    fn constants(self) -> (f64, f64) {
        let mass = cases::mass(RADIUS);
        match self {
            Self::Linear { restitution } => {
                let l = -libm::log(restitution);
                let ratio = l / (l * l + PI * PI).sqrt();
                (2.0 * STIFFNESS / mass, 4.0 * ratio * (STIFFNESS / mass).sqrt())
            }
            Self::Hertz => {
                let effective = YOUNG_MODULUS / (2.0 * (1.0 - 0.3 * 0.3));
                (4.0 / 3.0 * effective * RADIUS.sqrt() / mass, 0.0)
            }
        }
    }

    /// Angular frequency of a small swing [1/s].
    fn frequency(self) -> f64 {
        let (constant, _) = self.constants();
        match self {
            Self::Linear { .. } => constant.sqrt(),
            Self::Hertz => (3.0 * constant * REST.sqrt()).sqrt(),
        }
    }

    fn acceleration(self, x: f64, v: f64) -> f64 {
        let (constant, damping) = self.constants();
        match self {
            Self::Linear { .. } => -constant * x - damping * v,
            Self::Hertz => {
                let force = |d: f64| d * d.sqrt();
                constant * (force(REST - x) - force(REST + x))
            }
        }
    }

    /// Third to fifth derivative of the place.
    fn derivatives(self, x: f64, v: f64) -> [f64; 3] {
        let (constant, damping) = self.constants();
        let a = self.acceleration(x, v);
        match self {
            Self::Linear { .. } => {
                let third = -constant * v - damping * a;
                let fourth = -constant * a - damping * third;
                [third, fourth, -constant * third - damping * fourth]
            }
            Self::Hertz => {
                let (p, q) = (REST + x, REST - x);
                let slope = -1.5 * constant * (p.sqrt() + q.sqrt());
                let bend = -0.75 * constant * (1.0 / p.sqrt() - 1.0 / q.sqrt());
                let twist = 0.375 * constant * (1.0 / (p * p.sqrt()) + 1.0 / (q * q.sqrt()));
                let third = slope * v;
                [
                    third,
                    bend * v * v + slope * a,
                    twist * v * v * v + 3.0 * bend * v * a + slope * third,
                ]
            }
        }
    }

    /// Place and velocity after a time, by the classical Runge-Kutta method with steps that leave an error of 1e-12.
    fn exact(self, [x, v]: [f64; 2], time: f64) -> [f64; 2] {
        let steps = (time * self.frequency() * 1000.0).ceil();
        let dt = time / steps;
        let slope = |y: [f64; 2]| [y[1], self.acceleration(y[0], y[1])];
        let moved = |y: [f64; 2], k: [f64; 2], h: f64| [y[0] + h * k[0], y[1] + h * k[1]];
        (0..steps as u64).fold([x, v], |y, _| {
            let k1 = slope(y);
            let k2 = slope(moved(y, k1, 0.5 * dt));
            let k3 = slope(moved(y, k2, 0.5 * dt));
            let k4 = slope(moved(y, k3, dt));
            std::array::from_fn(|i| y[i] + dt / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]))
        })
    }
}

/// Error of place and velocity, in units of the swing, after some collision times; `informed`: the method starts with the
/// exact derivatives instead of none.
fn error(system: System, integrator: Integrator, informed: bool, divisor: f64) -> f64 {
    let mut case = Case::new(one_material(YOUNG_MODULUS, &system.laws()));
    case.integrator = integrator;
    let frequency = system.frequency();
    let start = [START.0 * REST, START.1 * REST * frequency];
    case.grain(RADIUS, DVec3::X * start[0], DVec3::X * start[1]);
    for side in [1.0, -1.0] {
        case.plane(0, DVec3::X * (side * (REST - RADIUS)), DVec3::X * side);
    }
    let mut setup = case.setup();
    let steps = (1000.0 * divisor) as u64;
    setup.dt /= divisor;
    if informed {
        let derivatives = system.derivatives(start[0], start[1]);
        let translation = derivatives.map(|d| DVec3::X * d);
        setup.grains.higher = vec![HigherDerivatives {
            translation,
            ..HigherDerivatives::default()
        }];
    }
    let mut sim = Simulation::new(setup);
    for _ in 0..steps {
        sim.step().unwrap();
        assert_eq!(sim.contacts.wall_count(), 2, "the grain parted from a plane");
    }
    let [x, v] = system.exact(start, sim.time());
    let dx = (sim.grains().position[0].x - x) / REST;
    let dv = (sim.grains().velocity[0].x - v) / (REST * frequency);
    dx.abs().max(dv.abs())
}

#[test]
fn orders_of_a_swing_without_kinks() {
    let systems = [
        ("linear, e 1", System::Linear { restitution: 1.0 }),
        ("linear, e 0.5", System::Linear { restitution: 0.5 }),
        ("hertz-tsuji, e 1", System::Hertz),
    ];
    let methods = [
        ("velocity Verlet", Integrator::VelocityVerlet, false, 1.9..2.3),
        ("gear", Integrator::Gear, true, 3.8..6.0),
        (
            "gear without derivatives at the start",
            Integrator::Gear,
            false,
            1.8..2.6,
        ),
    ];
    on_threads(1, || {
        for (name, system) in systems {
            for (method, integrator, informed, expected) in &methods {
                let errors: Vec<(f64, f64)> = (DIVISORS.iter())
                    .map(|&d| (SAFE_SHARE / d, error(system, *integrator, *informed, d)))
                    .collect();
                let order = fitted_order(&errors);
                for (share, error) in &errors {
                    report(&format!("{name}, {method}: error at {share}"), *error);
                }
                report(&format!("{name}, {method}: order"), order);
                assert!(expected.contains(&order), "{name}, {method}: order {order}, {errors:?}");
            }
        }
    });
}
