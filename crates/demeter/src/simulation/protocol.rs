//! The protocol of a run: stages in order, each with its own wall motion, output cadence and end.

use super::deformation::Deformation;
use crate::walls::Motions;
use glam::DVec3;
use serde::{Deserialize, Serialize};

/// When a stage ends. A stage ends at the first of its conditions that holds.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum StopCondition {
    /// The stage has lasted this long [s].
    Duration(f64),
    /// The stage has run this many steps.
    Steps(u64),
    /// Kinetic over elastic energy of the grains is below this share (and some contact is loaded).
    KineticOverElastic(f64),
    /// The force on some walls together along a direction reaches a value [N].
    WallForce {
        /// Indices of the walls.
        walls: Vec<usize>,
        /// Unit vector along which the force is measured.
        direction: [f64; 3],
        /// The value to reach or exceed [N].
        above: f64,
    },
    /// A wall has moved by a distance from where it stood at the start of the stage [m].
    WallTravel {
        /// Index of the wall.
        wall: usize,
        /// Distance [m].
        distance: f64,
    },
    /// A wall has moved by this share of a reference length since the start of the stage.
    Strain {
        /// Index of the wall.
        wall: usize,
        /// Reference length [m].
        length: f64,
        /// The strain to reach, positive.
        strain: f64,
    },
    /// A normal stress of a box that deforms reaches a value [Pa].
    BoxStress {
        /// Which stress.
        of: StressOf,
        /// The value, compression positive [Pa].
        stress: f64,
        /// Whether it must fall below the value, not rise above it.
        falls: bool,
    },
    /// The true strain of a box that deforms since the start of the stage reaches a magnitude.
    BoxStrain {
        /// Number of the direction.
        axis: usize,
        /// Magnitude to reach.
        strain: f64,
    },
    /// The shear of a box since the start of the stage reaches a magnitude.
    ShearStrain(f64),
    /// All motions of a wall, told by its index, have stopped for good, or their tables have come to their ends.
    MotionDone(usize),
    /// A feed, told by its index, has come to its end.
    FeedDone(usize),
    /// So many grains are left, or fewer.
    GrainsAtMost(u64),
    /// A column of the series is within limits.
    Column(ColumnStop),
}

/// Limits of a column of the series, judged at its rows; a value that is not a number is within none.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ColumnStop {
    /// Title of the column, with its unit.
    pub column: String,
    /// The value to reach or exceed, in the unit of the column.
    pub above: Option<f64>,
    /// The value to fall to, in the same unit.
    pub below: Option<f64>,
    /// How long all rows must be within [s]; at 0 one is enough.
    pub lasting: f64,
}

impl ColumnStop {
    pub(crate) fn holds(&self, value: f64) -> bool {
        let holds =
            |limit: Option<f64>, is_within: fn(&f64, &f64) -> bool| limit.is_none_or(|limit| is_within(&value, &limit));
        !value.is_nan() && holds(self.above, f64::ge) && holds(self.below, f64::le)
    }
}

/// A stress of a box.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum StressOf {
    /// Along an axis, by its number.
    Axis(usize),
    /// Mean of the three.
    Mean,
    /// Shear stress that drives the shear of the box.
    Shear,
}

/// Whether an interval [s] ends at a step: whether it is the one nearest to a multiple of it, or any where steps are longer. Intervals that are
/// no whole number of steps keep their mean that way.
pub(crate) fn ends_at(interval: f64, dt: f64, step: u64) -> bool {
    let steps = interval / dt;
    if steps <= 1.0 {
        return step > 0;
    }
    let ended = (step as f64 / steps).round();
    ended >= 1.0 && (ended * steps).round() == step as f64
}

/// How many intervals [s] end before the last of so many steps, and that one, which ends the last.
pub(crate) fn ends_within(interval: f64, dt: f64, steps: u64) -> u64 {
    let ended = (steps as f64 - 0.5) / (interval / dt).max(1.0);
    ended.ceil().max(1.0) as u64
}

/// How often things are written, in seconds of simulated time. `None`: not in this stage.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Cadence {
    /// Rows of the series.
    pub series: Option<f64>,
    /// Frames: grains, contacts and walls.
    pub frames: Option<f64>,
    /// Checkpoints.
    pub checkpoints: Option<f64>,
}

/// One stage. Repeats are unrolled by whoever builds the list.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Stage {
    /// Name, unique when unrolled: `"squeeze 2"`.
    pub name: String,
    /// Ends of the stage; the first that holds ends it. At least one is a duration or a number of steps.
    pub stop: Vec<StopCondition>,
    /// Motions told to walls at the start of the stage; walls not named keep theirs.
    pub motions: Vec<(usize, Motions)>,
    /// Walls that are absent from the start of the stage on, by their indices; those of the stage before when absent itself.
    pub absent: Option<Vec<usize>>,
    /// Feeds that run from the start of the stage on, by their indices; those of the stage before when absent.
    pub feeds: Option<Vec<usize>>,
    /// Removals that act from the start of the stage on, by their indices; those of the stage before when absent.
    pub removals: Option<Vec<usize>>,
    /// How the periodic box deforms from the start of the stage on; as in the stage before when absent.
    pub deformation: Option<Deformation>,
    /// Acceleration of gravity from the start of the stage on [m/s^2]; that of the stage before when absent.
    pub gravity: Option<DVec3>,
    /// Number of the contact laws, among those that stages tell, from the start of the stage on; those of the stage before when absent.
    pub contact: Option<usize>,
    /// How often things are written.
    pub cadence: Cadence,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn intervals_end_at_the_nearest_step_and_do_not_drift() {
        let dt = 2.0212e-6;
        for interval in [1e-4, 3e-6, 2.0212e-6, 1e-6, 40.0 * 2.0212e-6] {
            let due: Vec<u64> = (0..20_001).filter(|step| ends_at(interval, dt, *step)).collect();
            for (k, step) in due.iter().enumerate() {
                let expected = f64::max(
                    (k + 1) as f64 * interval,
                    if interval <= dt { (k + 1) as f64 * dt } else { 0.0 },
                );
                assert!(
                    (*step as f64 * dt - expected).abs() <= 0.500_001 * dt,
                    "{interval} {k} {step}"
                );
            }
            // counted without asking, the last at the end
            let before_the_last = due.iter().filter(|step| **step < 20_000).count() as u64;
            assert_eq!(ends_within(interval, dt, 20_000), before_the_last + 1, "{interval}");
        }
    }
}
