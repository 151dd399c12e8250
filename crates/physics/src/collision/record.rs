//! The steps of a collision, from which every moment between them can be had.

use super::head_on::Pair;
use super::ode;
use super::outcome::{CollisionError, MOST_MOMENTS};
use crate::contact::normal::Normal;

/// Components of the state: overlap [m], rate of approach [m/s], energy lost in the dashpot [J].
pub(super) type State = [f64; 3];

/// Most values that a law may remember of a contact here.
pub(super) const MAX_HISTORY: usize = 24;

/// What does not change within a step.
#[derive(Clone, Copy, Debug)]
pub(super) struct Held {
    /// What the law remembers at the start of the step.
    pub history: [f64; MAX_HISTORY],
    /// Overlap below which no force acts [m].
    pub end: f64,
    /// The least overlap handed to the law: just inside the contact, so that the force goes on smoothly beyond an end
    /// that a trial step passes.
    pub floor: f64,
    /// Least total force [N].
    pub least: f64,
}

/// A step of a collision.
#[derive(Clone, Copy, Debug)]
pub(super) struct Record {
    /// Time at its start [s].
    pub time: f64,
    /// Its length [s].
    pub length: f64,
    /// State at its start.
    pub state: State,
    /// What the law holds at its start.
    pub held: Held,
    /// Total force at its start [N].
    pub force: f64,
}

/// A moment of a collision.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moment {
    /// Time since the start [s].
    pub time: f64,
    /// Overlap [m].
    pub overlap: f64,
    /// Rate of approach [m/s]; negative while separating.
    pub rate: f64,
    /// Total normal force [N]; repulsion is positive.
    pub force: f64,
}

/// Evaluations of a search for the largest force inside a step: golden section, whose place is then known to 1e-6 of
/// the step and the force, being flat there, to its square.
const GOLDEN_STEPS: usize = 30;

impl Record {
    /// State at a time after the start of the step.
    fn state_after<L: Normal>(&self, pair: &Pair<'_, L>, time: f64) -> State {
        let rates = |y: &State| pair.rates(&self.held, y);
        ode::step(rates, &self.state, time, &[1.0; 3]).end
    }

    /// The moment at a time after the start of the step.
    pub fn moment<L: Normal>(&self, pair: &Pair<'_, L>, after: f64) -> Moment {
        let [overlap, rate, _] = if after > 0.0 {
            self.state_after(pair, after)
        } else {
            self.state
        };
        Moment {
            time: self.time + after,
            overlap,
            rate,
            force: pair.total(&self.held, overlap, rate),
        }
    }

    /// Largest force within the step [N], where it has one maximum.
    fn largest_force<L: Normal>(&self, pair: &Pair<'_, L>) -> f64 {
        let ratio = 0.5 * (5f64.sqrt() - 1.0);
        let force = |share: f64| self.moment(pair, share * self.length).force;
        let (mut lower, mut upper) = (0.0, 1.0);
        let (mut c, mut d) = (1.0 - ratio, ratio);
        let (mut fc, mut fd) = (force(c), force(d));
        for _ in 0..GOLDEN_STEPS {
            if fc > fd {
                (upper, d, fd) = (d, c, fc);
                c = upper - ratio * (upper - lower);
                fc = force(c);
            } else {
                (lower, c, fc) = (c, d, fd);
                d = lower + ratio * (upper - lower);
                fd = force(d);
            }
        }
        fc.max(fd)
    }
}

/// Largest force of a collision [N]: the largest at the ends of steps, and within the two steps beside it.
pub(super) fn largest_force<L: Normal>(records: &[Record], pair: &Pair<'_, L>) -> f64 {
    let largest = (0..records.len()).max_by(|&a, &b| records[a].force.total_cmp(&records[b].force));
    let Some(k) = largest else {
        return 0.0;
    };
    let beside = &records[k.saturating_sub(1)..=k];
    let inside = beside.iter().map(|r| r.largest_force(pair));
    inside.fold(records[k].force, f64::max)
}

/// Refuses more moments than are kept.
pub(super) fn check_moments(count: usize) -> Result<(), CollisionError> {
    match count <= MOST_MOMENTS {
        true => Ok(()),
        false => Err(CollisionError::Moments { count }),
    }
}

/// Moments at equal distances in time, the first and the last included; at least two.
pub(super) fn moments<L: Normal>(records: &[Record], pair: &Pair<'_, L>, count: usize) -> Vec<Moment> {
    let (Some(first), Some(last)) = (records.first(), records.last()) else {
        return Vec::new();
    };
    let count = count.max(2);
    let duration = last.time + last.length - first.time;
    let mut at = 0;
    (0..count)
        .map(|k| {
            let time = first.time + duration * (k as f64 / (count - 1) as f64);
            while at + 1 < records.len() && records[at + 1].time <= time {
                at += 1;
            }
            let record = &records[at];
            record.moment(pair, (time - record.time).clamp(0.0, record.length))
        })
        .collect()
}
