//! Head-on collisions in the engine's own scheme: velocity Verlet with the predicted velocity and `centred_force`.

use super::cases::{MOST_HISTORY, NormalCase, PAIRS, SIZES, calibrated, has_parameter, values};
use super::tested;
use crate::collision::{HeadOn, Start, Tolerance};
use crate::contact::normal::{Normal, NormalInput, NormalLaw, NormalVisitor, centred_force};
use crate::contact::{LawInfo, PairSize};
use crate::parameters::Value;

/// Steps per shortest collision time.
const STEPS_PER_COLLISION: f64 = 100.0;
const PHASES: u32 = 20;

/// Two bodies on a line; an infinite mass is a wall.
struct Encounter {
    case: NormalCase,
    mass_i: f64,
    mass_j: f64,
    speed: f64,
    dt: f64,
}

/// What an encounter came to.
struct Outcome {
    restitution: f64,
    kinetic_before: f64,
    kinetic_after: f64,
}

fn kinetic(mass: f64, velocity: f64) -> f64 {
    if mass.is_finite() {
        0.5 * mass * velocity * velocity
    } else {
        0.0
    }
}

impl Encounter {
    /// A collision of `mass_i` and `mass_j` that would reach `overlap` without damping.
    fn new(case: NormalCase, mass_i: f64, mass_j: f64, overlap: f64) -> Self {
        let case = NormalCase {
            size: PairSize::new(case.size.radius, 1.0 / (1.0 / mass_i + 1.0 / mass_j)),
            ..case
        };
        Self {
            speed: (2.0 * case.energy(overlap) / case.size.mass).sqrt(),
            dt: case.collision_time(overlap) / STEPS_PER_COLLISION,
            case,
            mass_i,
            mass_j,
        }
    }

    /// Runs the collision; `phase` is where within a step the surfaces first touch.
    fn run(&self, phase: f64) -> Outcome {
        let (dt, mass) = (self.dt, self.case.size.mass);
        // body i comes from the positive side, so that the normal from j to i is +1
        let share_i = mass / self.mass_i;
        let (mut v_i, mut v_j) = (-self.speed * share_i, self.speed * (1.0 - share_i));
        let kinetic_before = kinetic(self.mass_i, v_i) + kinetic(self.mass_j, v_j);
        let mut gap = self.speed * dt * (2.0 + phase);
        let mut force = 0.0;
        let mut history = [0.0; MOST_HISTORY];
        for _ in 0..100_000 {
            let (a_i, a_j) = (force / self.mass_i, -force / self.mass_j);
            let (half_i, half_j) = (v_i + 0.5 * a_i * dt, v_j + 0.5 * a_j * dt);
            gap += (half_i - half_j) * dt;
            let (star_i, star_j) = (half_i + 0.5 * a_i * dt, half_j + 0.5 * a_j * dt);
            let approach = star_j - star_i;
            let input = NormalInput {
                size: self.case.size,
                overlap: -gap,
                rate: approach,
                half_window: 0.5 * approach.abs() * dt,
            };
            let next = if input.overlap + input.half_window > 0.0 {
                let response = self.case.respond_with(&input, &mut history);
                centred_force(response, approach, force, 1.0 / mass, 0.5 * dt).0
            } else {
                0.0
            };
            v_i = star_i + 0.5 * (next / self.mass_i - a_i) * dt;
            v_j = star_j + 0.5 * (-next / self.mass_j - a_j) * dt;
            force = next;
            if force == 0.0 && v_i > v_j {
                return Outcome {
                    restitution: (v_i - v_j) / self.speed,
                    kinetic_before,
                    kinetic_after: kinetic(self.mass_i, v_i) + kinetic(self.mass_j, v_j),
                };
            }
        }
        panic!("{}: the bodies never parted", self.case.name());
    }
}

/// Every law with a parameter `restitution` that holds at every speed, for equal, unequal and infinite partners, weak and strong impacts.
fn each_collision(restitution: f64, check: impl Fn(&Encounter, &Outcome)) {
    let at_every_speed = |info: &&LawInfo| has_parameter(info, "restitution") && calibrated(info, 0.5).is_empty();
    for info in tested(crate::contact::normal::LAWS).filter(at_every_speed) {
        for pair in PAIRS {
            let law = NormalLaw::build(info.name, &values(info, &[("restitution", restitution)]), &pair).unwrap();
            for (radius, mass_i, mass_j) in [(5e-4, 1e-6, 1e-6), (1.8e-3, 3e-5, 4e-2), (2e-2, 0.1, f64::INFINITY)] {
                let size = PairSize::new(radius, mass_i);
                let case = NormalCase { info, law, pair, size };
                for overlap in [1e-5 * radius, 1e-2 * radius] {
                    let encounter = Encounter::new(case, mass_i, mass_j, overlap);
                    for phase in 0..PHASES {
                        check(&encounter, &encounter.run(f64::from(phase) / f64::from(PHASES)));
                    }
                }
            }
        }
    }
}

#[test]
fn collisions_give_the_requested_restitution() {
    for restitution in [0.05, 0.1, 0.3, 0.54, 0.8, 0.95, 1.0] {
        each_collision(restitution, |encounter, outcome| {
            let error = outcome.restitution - restitution;
            assert!(
                error.abs() < 1e-4,
                "{}: restitution {} instead of {restitution}",
                encounter.case.name(),
                outcome.restitution
            );
        });
    }
}

#[test]
fn elastic_collisions_keep_their_energy() {
    each_collision(1.0, |encounter, outcome| {
        let error = outcome.kinetic_after / outcome.kinetic_before - 1.0;
        assert!(
            error.abs() < 1e-6,
            "{}: kinetic energy changed by {error:e}",
            encounter.case.name()
        );
    });
}

/// What a law says of a size.
struct Check(PairSize);

impl NormalVisitor for Check {
    type Output = Result<(), String>;
    fn visit<L: Normal>(self, law: &L) -> Self::Output {
        law.check(self.0)
    }
}

#[test]
fn laws_that_depend_on_the_speed_give_the_requested_restitution_at_it() {
    for info in tested(crate::contact::normal::LAWS) {
        let (mut realised, mut refused) = (0, 0);
        for requested in [0.1, 0.5, 0.9] {
            for values in calibrated(info, requested) {
                let Some(Value::Number(speed)) = values.get("impact_speed") else {
                    panic!("{}: no impact speed", info.name);
                };
                for (pair, size) in PAIRS.iter().flat_map(|pair| SIZES.map(|size| (pair, size))) {
                    let law = NormalLaw::build(info.name, &values, pair).unwrap();
                    let label = format!("{} with {values:?} at {} m", info.name, size.radius);
                    if let Err(why) = law.visit(Check(size)) {
                        assert!(why.contains("restitution"), "{label}: {why}");
                        refused += 1;
                        continue;
                    }
                    for law in [law, law.for_many_sizes()] {
                        let impact = HeadOn {
                            law: &law,
                            size,
                            speed: *speed,
                            start: Start::Far,
                        };
                        let found = impact.run(&Tolerance::default()).unwrap().restitution;
                        assert!((found - requested).abs() < 1e-6, "{label}: {found}");
                    }
                    realised += 1;
                }
            }
        }
        assert!(
            realised > 0 || refused == 0,
            "{}: every one of {refused} requests was refused",
            info.name
        );
    }
}
