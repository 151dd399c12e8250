//! Candidates that may touch within the next steps.
//!
//! The table of contacts holds those candidates that are nearer than a reach beyond touching. They are looked for anew when
//! grains have moved so far that a candidate which is not in the table might act; until then nothing but the table is read.

use super::Scene;
use super::meetings::{Lot, Meeting, lanes_below};
use crate::comm::parts::{InParts, Listed, Part};
use crate::neighbours::Pair;
use demeter_physics::lanes::{Kernel, Lanes, Mask, Vector};
use serde::{Deserialize, Serialize};
use std::ops::Range;

/// The table shall serve for so many steps.
const STEPS: f64 = 24.0;

/// Looking for contacts costs as much as this share of those that come into the table with a reach of the mean radius: between grains,
/// and with walls, of which each part is looked at alone.
const SEARCH: [f64; 2] = [0.05, 2.0];

/// The least and the most that the reach goes beyond what acts in one step, as shares of the mean radius.
const ROOM: (f64, f64) = (1e-5, 0.1);

/// Rounding of places may bring two grains nearer by this share of the mean radius in a step.
const ROUNDING: f64 = 1e-12;

/// How far the table of contacts of a segment reaches.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
struct NearTable {
    /// Distance beyond touching of the candidates in the table [m].
    reach: f64,
    /// How much nearer two grains can have come since [m].
    approached: f64,
}

impl NearTable {
    /// A table that does not serve.
    const NONE: Self = Self {
        reach: 0.0,
        approached: f64::INFINITY,
    };

    /// Notes a step in which no two grains came `nearer` than by this. Tells the reach to look for contacts with where the table
    /// does not serve any more: some candidate outside of it may be as near as `window`.
    fn advance(&mut self, (nearer, window): (f64, f64), search: f64, mean_radius: f64) -> Option<f64> {
        let nearer = nearer + ROUNDING * mean_radius;
        self.approached += nearer;
        // not a number serves no more
        if self.approached + window <= self.reach {
            return None;
        }
        // a step costs `search nearer/room + room/mean_radius`: least where both are the same
        let best = (STEPS * nearer).min((search * nearer * mean_radius).sqrt());
        // where motion is not bounded, the table serves for one step
        let room = if best.is_finite() { best } else { 0.0 };
        self.reach = window + room.clamp(ROOM.0 * mean_radius, ROOM.1 * mean_radius);
        self.approached = 0.0;
        Some(self.reach)
    }
}

/// The tables of contacts of a segment: between grains, and with walls.
type TwoTables = [NearTable; 2];

/// How far the tables of contacts reach in every segment: where grains move together they need not reach as far as where they meet.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct NearTables {
    of_segments: Vec<TwoTables>,
    /// Mean radius of the grains [m].
    mean_radius: f64,
    /// How they serve in this step.
    #[serde(skip)]
    in_step: Vec<[InStep; 2]>,
}

/// How a table serves in a step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct InStep {
    /// The reach to look for contacts with [m]; none where the table serves.
    reach: Option<f64>,
    /// Distance beyond touching at which bodies may act [m].
    window: f64,
}

/// How far a table of contacts with walls reaches.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Reach {
    /// Distance beyond touching [m].
    pub(crate) distance: f64,
    /// Whether it reaches so far from this step on.
    pub(crate) is_new: bool,
    /// Distance beyond touching at which bodies may act in this step [m].
    pub(crate) window: f64,
}

/// What is saved of [`NearTables`].
#[derive(Serialize)]
#[serde(rename = "NearTables")]
struct Written<'a, 'b> {
    of_segments: Listed<'a, 'b, TwoTables>,
    mean_radius: f64,
}

impl InParts for NearTables {
    fn in_parts<'a>(&'a self, part: &'a Part<'_>) -> impl Serialize + 'a {
        Written {
            of_segments: part.of_segments(&self.of_segments),
            mean_radius: self.mean_radius,
        }
    }
}

impl NearTables {
    /// Notes a step. `approach` tells of a segment how much nearer two grains came at most, and within which window they may act [m],
    /// and the same of a grain and a wall. The others have no tables here.
    pub(crate) fn advance(&mut self, segments: Range<usize>, approach: impl Fn(usize) -> [(f64, f64); 2]) {
        (self.in_step).resize(self.of_segments.len(), Default::default());
        for segment in segments {
            let approach = approach(segment);
            for (kind, (&approach, search)) in approach.iter().zip(SEARCH).enumerate() {
                self.in_step[segment][kind] = InStep {
                    reach: self.of_segments[segment][kind].advance(approach, search, self.mean_radius),
                    window: approach.1,
                };
            }
        }
    }

    /// The tables that a restart needs.
    pub(crate) fn saved(&self) -> Self {
        self.of_segments(0..self.of_segments.len())
    }

    /// The tables of some segments.
    pub(crate) fn of_segments(&self, segments: Range<usize>) -> Self {
        Self {
            of_segments: self.of_segments[segments].to_vec(),
            mean_radius: self.mean_radius,
            in_step: Vec::new(),
        }
    }

    /// The tables of segments that follow each other.
    pub(crate) fn joined(parts: Vec<Self>) -> Self {
        Self {
            mean_radius: parts.first().map_or(0.0, |part| part.mean_radius),
            of_segments: parts.into_iter().flat_map(|part| part.of_segments).collect(),
            in_step: Vec::new(),
        }
    }

    /// The reach to look for the contacts of a segment with in this step; none where its table serves.
    #[inline(always)]
    pub(crate) fn reach(&self, segment: usize) -> Option<f64> {
        self.in_step[segment][0].reach
    }

    /// How far the contacts of a segment with walls reach.
    #[inline(always)]
    pub(crate) fn at_walls(&self, segment: usize) -> Reach {
        let InStep { reach, window } = self.in_step[segment][1];
        Reach {
            distance: self.of_segments[segment][1].reach,
            is_new: reach.is_some(),
            window,
        }
    }

    /// Has the contacts looked for in the next step, among new candidates.
    pub(crate) fn forget(&mut self, segments: usize, mean_radius: f64) {
        self.of_segments.clear();
        self.of_segments.resize(segments, [NearTable::NONE; 2]);
        self.mean_radius = mean_radius;
    }

    /// Whether there are as many as segments, and the numbers are possible, as they are unless a file was tampered with.
    pub(crate) fn are_sound(&self, segments: usize) -> bool {
        let is_sound = |table: &NearTable| table.reach >= 0.0 && table.approached >= 0.0;
        self.of_segments.len() == segments && self.mean_radius >= 0.0 && self.of_segments.iter().flatten().all(is_sound)
    }
}

/// Finds the candidates of a chunk that are nearer than a reach beyond touching.
pub(super) struct FindNear<'a> {
    pub(super) pairs: &'a [Pair],
    pub(super) scene: &'a Scene<'a>,
    /// Distance beyond touching, and beyond what the surfaces may bulge [m].
    pub(super) reach: f64,
    pub(super) near: &'a mut Vec<u16>,
}

impl Kernel for FindNear<'_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self) {
        let Self { pairs, near, .. } = self;
        let meeting = Meeting::new(self.scene);
        let count = pairs.len();
        near.resize(count + L::COUNT, 0);
        let mut found = 0;
        let mut lot = Lot::empty();
        for c in (0..count).step_by(L::COUNT) {
            let mut lane = 0;
            while lane < L::COUNT {
                lot.put(lane, &pairs[(c + lane).min(count - 1)]);
                lane += 1;
            }
            let (apart, ri, rj) = meeting.apart::<L>(&lot);
            let reach = ri + rj + meeting.bulges::<L>(&lot) + self.reach;
            let bits = apart.square().lt(reach * reach).bits() & lanes_below(count - c);
            // every lane is written, and counted only where it is near: which are cannot be foretold
            let mut lane = 0;
            while lane < L::COUNT {
                near[found] = (c + lane) as u16;
                found += (bits >> lane & 1) as usize;
                lane += 1;
            }
        }
        near.truncate(found);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_of_grains_that_move_together_are_narrow_and_serve_long() {
        let mut tables = NearTables::default();
        tables.forget(3, 1.0);
        // segments whose grains come nearer by so much in a step
        let nearer = [1e-3, 1e-6, 0.0];
        let mut looked = [0u32; 3];
        for step in 0..1000 {
            let before = tables.clone();
            tables.advance(0..3, |segment| [(nearer[segment], 0.5 * nearer[segment]); 2]);
            for segment in 0..3 {
                let Some(reach) = tables.reach(segment) else {
                    // nobody outside has come as near as to act
                    let (table, was) = (&tables.of_segments[segment][0], &before.of_segments[segment][0]);
                    assert!(table.reach == was.reach && table.approached + 0.5 * nearer[segment] <= table.reach);
                    continue;
                };
                assert!(
                    reach > 0.5 * nearer[segment],
                    "{reach} of segment {segment} in step {step}"
                );
                looked[segment] += 1;
            }
        }
        // fast ones as often as looking is worth it, others after so many steps
        assert!(
            (80..130).contains(&looked[0]) && (35..50).contains(&looked[1]) && looked[2] == 1,
            "{looked:?}"
        );
        let reach = |segment: usize| tables.of_segments[segment][0].reach;
        assert!(reach(1) < 0.1 * reach(0) && reach(2) < reach(1));
        // motion that is not bounded
        tables.advance(1..2, |_| [(f64::INFINITY, 0.1); 2]);
        tables.advance(1..2, |_| [(f64::NAN, 0.1); 2]);
        assert!(tables.reach(1).is_some_and(|reach| reach > 0.1) && tables.are_sound(3) && !tables.are_sound(2));
    }
}
