//! Force control of a wall.
//!
//! The wall is driven as a massless plate with a viscous brake: `D v = F - f`, with the target `F`, the measured force
//! `f` and the speed `v` clamped to the largest allowed. Such a plate only takes energy out of the bed, so whatever the
//! bed's stiffness it cannot excite it, and it rests only where `f = F`: there is no steady error. `D` starts at
//! `F / max_speed`, so that an unloaded plate approaches at the largest speed.
//!
//! A bed that goes away, as another wall drives it, or flows round the plate, would be followed with the error `D v`. So the plate is
//! borne by a carriage, which takes on the plate's speed over a time `T`: `v = (F - f)/D + u`, `du/dt = (F - f)/(D T)`, as if the brake
//! joined it to a mass `D T`. That takes only energy, too, and the mean of `f` is `F` wherever the bed lets the plate go on. A bed that
//! bears the plate is approached without the carriage: it gains speed only while the plate does not close the error by itself, by a tenth
//! in [`PATIENCE`] steps. [`LONG`] steps after the target was reached first it follows every error, so that the mean is held where bed and
//! plate swing, too; a plate that leaves the bed again and again begins anew each time, and presses as it happens to.
//!
//! A target below 0 is held as its mirror image is; where the target is 0, the largest force that was measured is the measure of errors.
//!
//! What can still make it oscillate is that the force is one step old. A loop that is too fast for that overshoots the
//! target again after less than [`HASTE`] steps; then `D` doubles. When a pressing plate has closed less than a tenth of
//! the error in [`PATIENCE`] steps, `D` halves, down to a share of its start, so that a brake that was once needed never
//! stays for good, and a slow plate does not creep to its target.

use serde::{Deserialize, Serialize};

/// Steps between two overshoots below which the loop, not the bed, is oscillating.
const HASTE: u32 = 8;
/// Steps of slow approach before the brake is loosened.
const PATIENCE: u32 = 100;
/// Share of the target up to which an error is told as none.
const NEAR: f64 = 0.01;
/// `T` in steps.
const CARRY: f64 = 500.0;
/// Steps for which a plate that reached its target is approaching it still.
const LONG: u32 = 30_000;
/// Largest and smallest brake, as multiples of its start.
const STRONGEST: f64 = 1e12;
const WEAKEST: f64 = 1.0 / 32.0;

/// State of the controller.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Servo {
    /// Never negative.
    target: f64,
    /// -1 where the target is below 0.
    side: f64,
    /// What errors are measured in: the target, or where that is 0 the largest force so far.
    scale: f64,
    max_speed: f64,
    /// `D` as a multiple of `scale / max_speed`.
    brake: f64,
    /// Speed of the carriage, as a multiple of `max_speed`.
    carried: f64,
    /// Whether the carriage gains speed.
    follows: bool,
    /// Steps since the target was reached first in this touch; 0 before.
    held: u32,
    /// Steps since it touched the bed last.
    apart: u32,
    /// Whether the wall pressed too little in the last step; nothing before the first, and more than 0 is too much anyway.
    wanting: Option<bool>,
    since_crossing: u32,
    since_review: u32,
    error_at_review: f64,
    /// Steps since the target was reached, in all touches, and those of them at the largest speed.
    pressed: u64,
    at_limit: u64,
}

impl Servo {
    pub(crate) fn new(target: f64, max_speed: f64) -> Self {
        Servo {
            target: target.abs(),
            side: if target < 0.0 { -1.0 } else { 1.0 },
            scale: target.abs(),
            max_speed,
            brake: 1.0,
            carried: 0.0,
            follows: true,
            held: 0,
            apart: u32::MAX,
            wanting: (target == 0.0).then_some(true),
            since_crossing: u32::MAX,
            since_review: 0,
            error_at_review: f64::MAX,
            pressed: 0,
            at_limit: 0,
        }
    }

    /// Share of the steps in which it pressed that it spent at its largest speed, so that it did not hold its target; nothing where
    /// it has never pressed with what it is told, nor nearly. And that speed.
    pub(crate) fn limited(&self) -> (Option<f64>, f64) {
        let share = self.at_limit as f64 / self.pressed.max(1) as f64;
        let never = self.pressed == 0 && self.target > 0.0 && self.error_at_review > NEAR * self.scale;
        ((!never).then_some(share), self.max_speed)
    }

    /// Speed along the axis for the next step, from the force with which the wall pressed in the last [m/s].
    pub(crate) fn speed(&mut self, pressing: f64) -> f64 {
        let pressing = self.side * pressing;
        if self.target == 0.0 {
            self.scale = self.scale.max(pressing.abs());
        }
        if self.scale == 0.0 {
            return 0.0;
        }
        let error = self.target - pressing;
        self.review(error);
        let slip = error / (self.scale * self.brake);
        let speed = (slip + self.carried).clamp(-1.0, 1.0);
        self.apart = if pressing > 0.0 {
            0
        } else {
            self.apart.saturating_add(1)
        };
        // at its largest speed the plate does not follow, whatever the carriage does
        let is_led = self.follows && speed.abs() < 1.0;
        if self.apart > PATIENCE {
            (self.carried, self.held) = (0.0, 0);
        } else if is_led || self.held > LONG {
            self.carried = (self.carried + slip.clamp(-1.0, 1.0) / CARRY).clamp(-1.0, 1.0);
        }
        if self.held > 0 {
            self.held = self.held.saturating_add(1);
            self.pressed += 1;
            self.at_limit += u64::from(speed.abs() >= 1.0);
        }
        self.side * self.max_speed * speed
    }

    fn review(&mut self, error: f64) {
        let wanting = error >= 0.0;
        self.since_crossing = self.since_crossing.saturating_add(1);
        if wanting != self.wanting.replace(wanting).unwrap_or(wanting) {
            if self.since_crossing <= HASTE {
                self.brake = (2.0 * self.brake).min(STRONGEST);
            }
            self.since_crossing = 0;
            self.since_review = 0;
            self.follows = true;
            self.held = self.held.max(1);
            self.error_at_review = error.abs();
            return;
        }
        self.since_review += 1;
        if self.since_review >= PATIENCE {
            let weakest = if error < self.scale { WEAKEST } else { 1.0 };
            self.follows = error.abs() > 0.9 * self.error_at_review;
            if self.follows && self.brake > weakest {
                self.brake *= 0.5;
            }
            self.since_review = 0;
            self.error_at_review = error.abs();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A mass on a spring and dashpot above the floor, met by the plate through a contact spring and dashpot.
    struct Bed {
        stiffness: f64,
        damping: f64,
        mass: f64,
        contact: f64,
        contact_damping: f64,
        /// Speed of the floor away from the plate.
        sinks: f64,
        /// Speed with which it yields, per force on it.
        yields: f64,
    }

    struct Outcome {
        force: f64,
        /// Largest error in the last tenth of the run, as a share of the target.
        ripple: f64,
        largest: f64,
    }

    /// Force of a contact with this stiffness and damping.
    fn pressed([stiffness, damping]: [f64; 2], overlap: f64, closing: f64) -> f64 {
        if overlap > 0.0 {
            (stiffness * overlap + damping * closing).max(0.0)
        } else {
            0.0
        }
    }

    fn press(bed: &Bed, target: f64, max_speed: f64, dt: f64, steps: u32) -> Outcome {
        let mut servo = Servo::new(target, max_speed);
        let (mut plate, mut x, mut v, mut floor) = (-1e-3, 0.0, 0.0, 0.0);
        let mut out = Outcome {
            force: 0.0,
            ripple: 0.0,
            largest: 0.0,
        };
        for step in 0..steps {
            let speed = servo.speed(out.force);
            assert!(speed.abs() <= max_speed);
            plate += speed * dt;
            let overlap: f64 = plate - x;
            out.force = pressed([bed.contact, bed.contact_damping], overlap, speed - v);
            let sinks = bed.sinks + bed.yields * bed.stiffness * (x - floor);
            v += (out.force - bed.stiffness * (x - floor) - bed.damping * (v - sinks)) / bed.mass * dt;
            x += v * dt;
            floor += sinks * dt;
            out.largest = out.largest.max(out.force);
            if step > steps / 10 * 9 {
                out.ripple = out.ripple.max((out.force - target).abs() / target);
            }
        }
        out
    }

    /// Time step a twentieth of the shortest period of the bed.
    fn safe_step(bed: &Bed) -> f64 {
        0.3 * (bed.mass / (bed.stiffness + bed.contact)).sqrt()
    }

    #[test]
    fn reaches_the_target_on_soft_and_stiff_beds_without_ripple() {
        for stiffness in [1e2f64, 1e4, 1e6] {
            for share in [0.02, 0.3] {
                for contact in [1.0f64, 30.0] {
                    let contact = contact * stiffness;
                    let mass = 0.1f64;
                    let damping = share * 2.0 * (stiffness * mass).sqrt();
                    let contact_damping = share * 2.0 * (contact * mass).sqrt();
                    let bed = Bed {
                        stiffness,
                        damping,
                        mass,
                        contact,
                        contact_damping,
                        sinks: 0.0,
                        yields: 0.0,
                    };
                    let dt = safe_step(&bed);
                    // At full speed the force of the contact rises by this share of the target in one step.
                    for fraction in [1e-4, 1e-2, 1.0] {
                        let max_speed = fraction * 10.0 / (contact * dt);
                        let travel = 1e-3 + 10.0 / stiffness + 10.0 / contact;
                        let steps = (2.0 * travel / (max_speed * dt) + 2e5) as u32;
                        let out = press(&bed, 10.0, max_speed, dt, steps);
                        assert!(
                            out.ripple < 1e-3,
                            "k {stiffness} c {contact} {share} speed {fraction}: {}",
                            out.ripple
                        );
                    }
                }
            }
        }
    }

    #[test]
    fn tames_a_plate_that_is_far_too_fast() {
        let bed = Bed {
            stiffness: 1e5,
            damping: 60.0,
            mass: 0.1,
            contact: 1e6,
            contact_damping: 100.0,
            sinks: 0.0,
            yields: 0.0,
        };
        let dt = safe_step(&bed);
        // In one step at full speed the force rises by a hundred times the target.
        let out = press(&bed, 10.0, 100.0 * 10.0 / (bed.contact * dt), dt, 400_000);
        assert!(out.ripple < 1e-2, "{} {}", out.ripple, out.force);
    }

    #[test]
    fn a_slow_plate_does_not_overshoot() {
        let bed = Bed {
            stiffness: 1e4,
            damping: 30.0,
            mass: 0.1,
            contact: 1e5,
            contact_damping: 40.0,
            sinks: 0.0,
            yields: 0.0,
        };
        let dt = safe_step(&bed);
        let out = press(&bed, 10.0, 1e-3 * 10.0 / (bed.contact * dt), dt, 200_000);
        assert!(out.largest < 10.0 * 1.02, "{}", out.largest);
        assert!((out.force - 10.0).abs() < 1e-3);
    }

    /// A bed of some stiffness, and a time step that is safe for it.
    fn bed_and_step(stiffness: f64) -> (Bed, f64) {
        let (contact, mass) = (10.0 * stiffness, 0.1f64);
        let bed = Bed {
            stiffness,
            damping: 0.3 * 2.0 * (stiffness * mass).sqrt(),
            mass,
            contact,
            contact_damping: 0.3 * 2.0 * (contact * mass).sqrt(),
            sinks: 0.0,
            yields: 0.0,
        };
        let dt = safe_step(&bed);
        (bed, dt)
    }

    #[test]
    fn follows_a_bed_that_moves_away_or_comes() {
        for stiffness in [1e3f64, 1e5] {
            for (fraction, share) in [(1e-3, 0.5), (1e-2, -0.5), (1e-2, 0.9), (0.1, 0.2), (1.0, -0.05)] {
                let (mut bed, dt) = bed_and_step(stiffness);
                let max_speed = fraction * 10.0 / (bed.contact * dt);
                bed.sinks = share * max_speed;
                let travel = 1e-3 + 10.0 / stiffness + 10.0 / bed.contact;
                let steps = (2.0 * travel / ((1.0 - share) * max_speed * dt) + 2e5) as u32;
                let out = press(&bed, 10.0, max_speed, dt, steps);
                let label = format!("k {stiffness} speed {fraction} sinks {share}: {}", out.ripple);
                assert!(out.ripple < 2e-3, "{label}");
            }
        }
    }

    #[test]
    fn presses_as_told_on_a_bed_that_yields() {
        for stiffness in [1e3f64, 1e5] {
            for (fraction, share) in [(1e-3, 0.5), (1e-2, 0.1), (0.1, 0.2), (1.0, 0.1)] {
                let (mut bed, dt) = bed_and_step(stiffness);
                let max_speed = fraction * 10.0 / (bed.contact * dt);
                bed.yields = share * max_speed / 10.0;
                let travel = 1e-3 + 10.0 / stiffness + 10.0 / bed.contact;
                let steps = (2.0 * travel / ((1.0 - share) * max_speed * dt) + 2e5) as u32;
                let out = press(&bed, 10.0, max_speed, dt, steps);
                let label = format!("k {stiffness} speed {fraction} yields {share}: {}", out.ripple);
                assert!(out.ripple < 2e-3, "{label}");
            }
        }
    }

    /// Mean force over the target and mean speed, of the latter half of some steps in a bed that flows round the plate: grains between
    /// both are dragged along against a resistance that grows with their speed and changes from moment to moment.
    fn flow(max_speed: f64, fluctuation: f64, steps: u32) -> (f64, f64) {
        let (target, mass, contact, resistance) = (10.0, 0.1f64, 1e6, 20.0);
        let contact_damping = 0.5 * 2.0 * (contact * mass).sqrt();
        let dt = 0.1 * (mass / contact).sqrt();
        let mut servo = Servo::new(target, max_speed);
        let (mut plate, mut x, mut v, mut force, mut slow) = (0.0, 0.0, 0.0, 0.0, 0.0);
        let (mut seed, mut sums) = (1u64, (0.0, 0.0));
        for step in 0..steps {
            let speed = servo.speed(force);
            assert!(speed.abs() <= max_speed);
            plate += speed * dt;
            let overlap: f64 = plate - x;
            force = pressed([contact, contact_damping], overlap, speed - v);
            seed = seed
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            let noise = (seed >> 11) as f64 / (1u64 << 52) as f64 - 1.0;
            slow += 1e-2 * (10.0 * noise - slow);
            let against = 5.0 * (v / 0.01).clamp(-1.0, 1.0) + resistance * v + fluctuation * slow;
            v += (force - against) / mass * dt;
            x += v * dt;
            if 2 * step >= steps {
                sums = (sums.0 + force, sums.1 + speed);
            }
        }
        let half = f64::from(steps / 2);
        (sums.0 / half / target, sums.1 / half)
    }

    #[test]
    fn presses_on_the_mean_in_a_bed_that_flows() {
        for max_speed in [0.5, 2.0, 10.0] {
            for fluctuation in [0.0, 2.0, 5.0] {
                let (mean, speed) = flow(max_speed, fluctuation, 400_000);
                let label = format!("at most {max_speed} m/s, fluctuation {fluctuation}: {mean} at {speed} m/s");
                assert!((mean - 1.0).abs() < 5e-3, "{label}");
                assert!((speed / 0.25 - 1.0).abs() < 0.03, "{label}");
            }
        }
    }

    #[test]
    fn presses_on_the_mean_on_a_bed_that_shakes() {
        let target = 1.0;
        for max_speed in [0.3, 1.0, 5.0] {
            let (stiffness, contact, mass, dt) = (2e4, 1e5, 5e-3f64, 1e-6);
            let (damping, contact_damping) = (0.6 * (stiffness * mass).sqrt(), (contact * mass).sqrt());
            let mut servo = Servo::new(target, max_speed);
            let (mut plate, mut x, mut v, mut force, mut sum) = (-1e-5, 0.0, 0.0, 0.0f64, 0.0);
            let (steps, cycle) = (1_000_000, 20_000u32);
            for step in 0..steps {
                let speed = servo.speed(force);
                plate += speed * dt;
                let overlap: f64 = plate - x;
                force = pressed([contact, contact_damping], overlap, speed - v);
                let phase = std::f64::consts::TAU * f64::from(step) / f64::from(cycle);
                let (floor, floor_speed) = (
                    -1e-4 * phase.sin(),
                    -1e-4 * phase.cos() * std::f64::consts::TAU / (f64::from(cycle) * dt),
                );
                v += (force - stiffness * (x - floor) - damping * (v - floor_speed)) / mass * dt;
                x += v * dt;
                if step >= steps / 2 {
                    sum += force;
                }
            }
            let mean = sum / f64::from(steps / 2);
            assert!((mean / target - 1.0).abs() < 1e-3, "at most {max_speed} m/s: {mean}");
        }
    }

    #[test]
    fn a_plate_that_presses_too_much_at_first_has_not_come_to_its_target() {
        let mut servo = Servo::new(1.0, 0.1);
        (0..500).for_each(|_| assert_eq!(servo.speed(9.0), -0.1));
        assert_eq!(servo.limited(), (None, 0.1));
        (0..80).for_each(|_| _ = servo.speed(0.99));
        assert_eq!(servo.limited(), (Some(0.0), 0.1));
    }

    #[test]
    fn a_plate_that_creeps_to_its_target_has_come_to_it() {
        let mut servo = Servo::new(1.0, 0.1);
        for (pressing, told) in [(0.9, None), (0.995, Some(0.0))] {
            (0..2 * PATIENCE).for_each(|_| _ = servo.speed(pressing));
            assert_eq!(servo.limited().0, told, "{pressing}");
        }
    }

    #[test]
    fn steps_at_the_largest_speed_are_told() {
        let mut servo = Servo::new(1.0, 0.1);
        // on its way to the bed it may be as fast as it can
        (0..500).for_each(|_| assert_eq!(servo.speed(0.0), 0.1));
        assert_eq!(servo.limited(), (None, 0.1));
        (0..80).for_each(|_| _ = servo.speed(1.05));
        assert_eq!(servo.limited(), (Some(0.0), 0.1));
        (0..80).for_each(|_| assert_eq!(servo.speed(3.0), -0.1));
        assert_eq!(servo.limited(), (Some(0.5), 0.1));
    }
}
