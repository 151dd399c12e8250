//! Contacts that feel each other.
//!
//! The force at one contact of a grain moves the grain's surface at the others (laws of the multi-contact family). With
//! `D_c` the sum of these displacements at contact `c` on both of its bodies, the elastic forces solve
//!
//! ```text
//! F_c = f(overlap_c + D_c),      D_c = sum over k of influence(k -> c) F_k
//! ```
//!
//! [`Coupling::Converged`] solves it in every step, [`Coupling::Lagged`] takes the `F_k` of the step before. In both the
//! laws then see `overlap + D` as the overlap, and levers that reach to the middle of the overlap of the displaced
//! surfaces. A contact across a gap that displacements may close is in the table with no force, so that contacts come and
//! go continuously.
//!
//! Work is shared out so that every sum has one owner and one order: `site_list` tells which the contacts of a grain are, in the
//! order of the partner's id; `sites` gathers what they push with, and finds how that displaces them; `displaced` goes by
//! contact from the displacements of both bodies to the force.

pub(crate) mod bulge;
pub(crate) mod displaced;
mod falls;
pub(crate) mod kernels;
pub(crate) mod mixing;
mod site_list;
pub(crate) mod sites;

use super::rare::begins_empty;
use demeter_physics::contact::PairSize;
use serde::{Deserialize, Serialize};
use sites::Source;
use std::sync::atomic::{AtomicU64, Ordering};

/// How the coupled equation is treated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Coupling {
    /// Solved in every step: no force is farther from `f(overlap + D)` than this share of the largest force on its grains.
    Converged {
        /// The share.
        tolerance: f64,
    },
    /// Displacements follow from the forces of the step before (Brodu et al.).
    Lagged,
}

impl Default for Coupling {
    fn default() -> Self {
        Self::Converged {
            tolerance: DEFAULT_TOLERANCE,
        }
    }
}

/// Tolerance of [`Coupling::Converged`] where none is told.
pub const DEFAULT_TOLERANCE: f64 = 1e-6;

/// What a contact remembers of the coupling.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Coupled {
    /// Elastic (rate-independent) normal force [N]: what displaces.
    pub elastic: f64,
    /// Its change in the latest step [N].
    pub trend: f64,
    /// The change of its change [N].
    pub curve: f64,
    /// Change of the lever by displacement in the latest step [m].
    pub lever_trend: f64,
    /// Outward displacement of the surfaces of both bodies by their other contacts [m].
    pub displacement: [f64; 2],
    /// Whether the displaced surfaces met, or felt each other across a gap, in the latest step.
    pub meets: bool,
}

impl Coupled {
    /// How much the displacements add to the overlap [m].
    #[inline(always)]
    pub fn sum(&self) -> f64 {
        self.displacement[0] + self.displacement[1]
    }

    #[inline(always)]
    fn lever_shift(&self) -> f64 {
        lever_shift(self.displacement)
    }

    /// Elastic force to start the solution from [N]: it goes on as in the latest steps, but no push turns into a pull.
    #[inline(always)]
    fn foreseen(&self) -> f64 {
        let forecast = self.elastic + self.trend + self.curve;
        if self.elastic >= 0.0 {
            forecast.max(0.0)
        } else {
            forecast
        }
    }

    /// Notes the force of this step, whose displacements are here already; one of the start came from nowhere and has no trend.
    #[inline(always)]
    fn go_on(&mut self, earlier: &Self, force: f64, starts: bool) {
        self.elastic = force;
        if starts {
            return;
        }
        self.trend = force - earlier.elastic;
        self.curve = self.trend - earlier.trend;
        self.lever_trend = self.lever_shift() - earlier.lever_shift();
    }
}

/// How much a contact point between grains moves away from the first one's centre [m]: to the middle of the displaced
/// surfaces.
#[inline(always)]
fn lever_shift(displacement: [f64; 2]) -> f64 {
    0.5 * (displacement[0] - displacement[1])
}

/// What a chunk needs of its contacts while their forces are found.
#[derive(Clone, Debug, Default)]
pub(crate) struct Scratch {
    /// Rate of approach [m/s].
    pub(crate) rate: Vec<f64>,
    /// Sizes, which stay as long as the contacts do; empty where they are to be found.
    pub(crate) size: Vec<PairSize>,
    /// What the sites of both bodies are gathered from.
    pub(crate) sources: Vec<Source>,
    /// Shifts of the levers in the sources by displacement [m].
    lever_shift: Vec<f64>,
    /// Displacements of both bodies' surfaces, as their sites find them.
    pub(crate) delivered: Vec<Delivered>,
    /// Forces that the displacements follow from [N].
    pub(crate) trial: Vec<f64>,
    /// Forces that the laws answer with [N].
    answer: Vec<f64>,
    /// How far the forces tried are from the answers, as shares of the largest force on the grains.
    share: Vec<f64>,
    /// Overlaps of the spheres, and of the displaced surfaces [m].
    undisplaced: Vec<f64>,
    overlap: Vec<f64>,
    /// Answers, overlaps and deviations of the iteration before, where falls are watched for.
    former: Vec<[f64; 3]>,
    /// Contacts whose force falls as their surfaces come nearer; empty where there are none.
    falls: Vec<Fall>,
    /// Whether the displaced surfaces do not meet.
    asleep: Vec<bool>,
    pub(crate) mixing: mixing::Memory,
    memory: Vec<f64>,
    /// The contact farthest from its solution.
    pub(crate) worst: Worst,
}

begins_empty!(Scratch);

impl Scratch {
    /// Notes how far the forces tried are from the answers.
    pub(crate) fn note(&mut self) -> mixing::Largest {
        self.mixing.note(&self.trial, &self.answer)
    }

    /// Goes on with mixed forces.
    pub(crate) fn advance(&mut self, weights: &mixing::Weights) {
        self.mixing.advance(weights, &mut self.trial);
    }
}

/// Displacements of the surfaces of a contact's bodies [m]. Each is put by the one task that its grain belongs to, in a pass
/// of its own, and read in the next: no order of access can change it.
#[derive(Debug, Default)]
pub(crate) struct Delivered([AtomicU64; 2]);

impl Delivered {
    #[inline(always)]
    pub(crate) fn put(&self, body: usize, displacement: f64) {
        self.0[body].store(displacement.to_bits(), Ordering::Relaxed);
    }

    #[inline(always)]
    pub(crate) fn get(&self, body: usize) -> f64 {
        f64::from_bits(self.0[body].load(Ordering::Relaxed))
    }

    /// Displacements of both; that of a wall, which nobody puts, is 0.
    #[inline(always)]
    fn of_both(&self) -> [f64; 2] {
        [self.get(0), self.get(1)]
    }
}

impl Clone for Delivered {
    fn clone(&self) -> Self {
        Self([0, 1].map(|body| AtomicU64::new(self.0[body].load(Ordering::Relaxed))))
    }
}

/// A contact whose force falls as its surfaces come nearer, as where a pull begins with a jump.
#[derive(Clone, Copy, Debug, Default)]
struct Fall {
    /// How far the surfaces parted per pull when it was found [m/N]; 0 where the force does not fall.
    slope: f64,
    /// They give way by so much more.
    caution: f64,
    /// Overlap at which the law is asked for its force [m].
    overlap: f64,
    /// Force at the overlap of the displaced surfaces [N].
    plain: f64,
}

/// How far a contact is from its solution.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Worst {
    /// Deviation of its force as a share of the largest force on its grains.
    pub(crate) share: f64,
    /// Index in its chunk.
    pub(crate) contact: usize,
}
