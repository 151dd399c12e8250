//! Shear of a box at a given shear stress.
//!
//! The box is driven as by a rheometer that is told its torque: a flywheel of inertia `J` per volume turns the faces through a brake
//! `D`: `rate = (F - f)/D + u`, `du/dt = (F - f)/J`, with the stress `F` that is wanted and `f` that is measured. A packing that bears the
//! stress comes to rest where `f = F`, one that flows does so with a mean of `f = F` at whatever rate that takes. `D` is so strong that
//! the whole stress gives a quarter of the largest rate, which has a flow's fluctuations move the rate little, and `J` so large that the
//! whole stress needs a shear of 4 to spin up to it. What overshoots by more than
//! [`WIDE`] within [`HASTE`] steps doubles `D`: then the stress, which is one step old, and the rate drive each other.

use serde::{Deserialize, Serialize};

/// Steps between two overshoots below which the loop is oscillating.
const HASTE: u32 = 8;
/// What such an overshoot is at least, as a share of the target; less comes and goes by itself where grains flow.
const WIDE: f64 = 0.1;
/// `D` at the start, as a multiple of the stress over the largest rate.
const BRAKE: f64 = 4.0;
/// `J` as a multiple of the stress over the square of the largest rate.
const INERTIA: f64 = 8.0;
/// Time over which the mean error is taken, in the inverse of the largest rate: half of what the whole stress needs to spin up to it.
const MEMORY: f64 = 4.0;
/// Mean error, as a share of the scale, up to which the stress is what it was told to be.
const COME: f64 = 0.1;

/// State of the controller.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct ShearDrive {
    target: f64,
    /// What errors are measured in: the target, or where that is 0 the largest stress so far.
    scale: f64,
    max_rate: f64,
    /// `D` as a multiple of `scale / max_rate`.
    brake: f64,
    /// Rate of the flywheel, as a multiple of `max_rate`.
    carried: f64,
    was_wanting: bool,
    since_crossing: u32,
    /// Largest error since the target was crossed last, as a share of the scale.
    peak: f64,
    /// Error in the mean over the last while, as a share of the scale.
    mean_error: f64,
    /// Steps since the start, and those of them at the largest rate.
    steps: [u64; 2],
}

impl ShearDrive {
    /// A flywheel that turns with a rate already [1/s].
    pub(super) fn new(target: f64, max_rate: f64, rate: f64) -> Self {
        Self {
            target,
            scale: target.abs(),
            max_rate,
            brake: BRAKE,
            carried: (rate / max_rate).clamp(-1.0, 1.0),
            was_wanting: true,
            since_crossing: u32::MAX,
            peak: 0.0,
            mean_error: 1.0,
            steps: [0; 2],
        }
    }

    /// The target [Pa], the share of all steps at the largest rate where the stress is the target in the mean, and that rate [1/s].
    pub(super) fn followed(&self) -> (f64, Option<f64>, f64) {
        let [steps, at_largest] = self.steps;
        let has_come = self.mean_error.abs() <= COME;
        let share = has_come.then(|| at_largest as f64 / steps.max(1) as f64);
        (self.target, share, self.max_rate)
    }

    /// Rate of shear for the next step of `dt` [s], from the shear stress of the last [1/s].
    pub(super) fn rate(&mut self, stress: f64, dt: f64) -> f64 {
        if self.target == 0.0 {
            self.scale = self.scale.max(stress.abs());
        }
        if self.scale == 0.0 {
            self.mean_error = 0.0;
            return self.max_rate * self.carried;
        }
        let error = (self.target - stress) / self.scale;
        self.since_crossing = self.since_crossing.saturating_add(1);
        if (error >= 0.0) != self.was_wanting {
            if self.since_crossing <= HASTE && self.peak > WIDE {
                self.brake *= 2.0;
            }
            self.was_wanting = !self.was_wanting;
            self.since_crossing = 0;
            self.peak = 0.0;
        }
        self.peak = self.peak.max(error.abs());
        let slip = error / self.brake;
        self.carried = (self.carried + error * dt * self.max_rate / INERTIA).clamp(-1.0, 1.0);
        self.mean_error += (error - self.mean_error) * (dt * self.max_rate / MEMORY).min(1.0);
        let rate = (slip + self.carried).clamp(-1.0, 1.0);
        self.steps[0] += 1;
        self.steps[1] += u64::from(rate.abs() == 1.0);
        self.max_rate * rate
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Mean stress over the target and mean rate, of the latter half of some steps, where the stress follows from rate and shear.
    fn drive(target: f64, rate: f64, steps: u32, mut stress: impl FnMut(f64, f64) -> f64) -> (f64, f64) {
        let (max_rate, dt) = (100.0, 1e-5);
        let mut drive = ShearDrive::new(target, max_rate, rate);
        let (mut shear, mut rate, mut sums) = (0.0, rate, (0.0, 0.0));
        for step in 0..steps {
            let found = stress(rate, shear);
            rate = drive.rate(found, dt);
            assert!(rate.abs() <= max_rate);
            shear += rate * dt;
            if 2 * step >= steps {
                sums = (sums.0 + found, sums.1 + rate);
            }
        }
        let half = f64::from(steps / 2);
        (sums.0 / half, sums.1 / half)
    }

    #[test]
    fn what_is_elastic_rests_under_the_stress() {
        for stiffness in [1e4, 1e6, 1e8] {
            for target in [100.0, -100.0] {
                let (mean, rate) = drive(target, 0.0, 200_000, |_, shear| stiffness * shear);
                assert!(
                    (mean / target - 1.0).abs() < 1e-2 && rate.abs() < 0.1,
                    "{stiffness}: {mean} {rate}"
                );
            }
        }
    }

    #[test]
    fn what_flows_does_so_at_the_rate_that_needs_the_stress() {
        // a stress of yield and a viscous one, with what fluctuates beside them
        for fluctuation in [0.0, 30.0] {
            for (target, expected) in [(100.0, 20.0), (-100.0, -20.0)] {
                let mut seed = 1u64;
                let mut noise = move || {
                    seed = seed
                        .wrapping_mul(6_364_136_223_846_793_005)
                        .wrapping_add(1_442_695_040_888_963_407);
                    (seed >> 11) as f64 / (1u64 << 52) as f64 - 1.0
                };
                let mut slow = 0.0;
                let (mean, rate) = drive(target, 0.0, 2_000_000, |rate, _| {
                    slow += 1e-2 * (10.0 * noise() - slow);
                    60.0 * (rate / 10.0).clamp(-1.0, 1.0) + 2.0 * rate + fluctuation * slow
                });
                assert!((mean / target - 1.0).abs() < 0.01, "{fluctuation}: {mean}");
                assert!((rate / expected - 1.0).abs() < 0.03, "{fluctuation}: {rate}");
            }
        }
    }

    #[test]
    fn a_flow_on_its_way_to_its_stress_is_known() {
        let mut drive = ShearDrive::new(100.0, 100.0, 0.0);
        let (mut rate, mut shares) = (0.0, Vec::new());
        for step in 0..200_000 {
            rate = drive.rate(2.0 * rate, 1e-5);
            if step == 5_000 || step == 199_999 {
                shares.push(drive.followed().1);
            }
        }
        assert_eq!(shares, [None, Some(0.0)]);
        // what needs more than the largest rate
        for _ in 0..200_000 {
            rate = drive.rate(0.95 * rate, 1e-5);
        }
        assert!(
            drive.followed().1.is_some_and(|share| share > 0.4),
            "{:?}",
            drive.followed()
        );
    }

    #[test]
    fn a_stress_of_nothing_lets_the_shear_go_back() {
        let mut drive = ShearDrive::new(0.0, 100.0, 0.0);
        let mut shear = 1e-3;
        for _ in 0..200_000 {
            shear += drive.rate(1e5 * shear, 1e-5) * 1e-5;
        }
        assert!(shear.abs() < 1e-6, "{shear}");
    }
}
