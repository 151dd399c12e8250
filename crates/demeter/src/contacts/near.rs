//! Candidates that may touch within the next steps.
//!
//! The table of contacts holds those candidates that are nearer than a reach beyond touching. They are looked for anew when
//! grains have moved so far that a candidate which is not in the table might act; until then nothing but the table is read.

use super::Scene;
use super::meetings::{Lot, Meeting, lanes_below};
use crate::neighbours::Pair;
use demeter_physics::lanes::{Kernel, Lanes, Mask, Vector};
use serde::{Deserialize, Serialize};

/// The table shall serve for so many steps.
const STEPS: f64 = 8.0;

/// Looking for contacts costs as much as this share of the pairs that come into the table with a reach of the mean radius.
const SEARCH: f64 = 0.1;

/// The least and the most that the reach goes beyond what acts in one step, as shares of the mean radius.
const ROOM: (f64, f64) = (1e-5, 0.1);

/// How far the table of contacts reaches.
#[derive(Clone, Copy, Debug, Default, Serialize, Deserialize)]
pub struct NearTable {
    /// Distance beyond touching of the candidates in the table [m].
    reach: f64,
    /// How much nearer two grains can have come since [m].
    approached: f64,
    /// Mean radius of the grains [m].
    mean_radius: f64,
}

impl NearTable {
    /// Notes a step in which no grain moved farther than `moved`. Tells the reach to look for contacts with where the table
    /// does not serve any more: some candidate outside of it may be as near as `window`.
    pub(crate) fn advance(&mut self, moved: f64, window: f64) -> Option<f64> {
        self.approached += 2.0 * moved;
        // not a number serves no more
        if self.approached + window <= self.reach {
            return None;
        }
        // a step costs `SEARCH nearer/room + room/mean_radius`: least where both are the same
        let nearer = 2.0 * moved;
        let best = (STEPS * nearer).min((SEARCH * nearer * self.mean_radius).sqrt());
        // where motion is not bounded, the table serves for one step
        let room = if best.is_finite() { best } else { 0.0 };
        self.reach = window + room.clamp(ROOM.0 * self.mean_radius, ROOM.1 * self.mean_radius);
        self.approached = 0.0;
        Some(self.reach)
    }

    /// Has the contacts looked for in the next step, among new candidates.
    pub(crate) fn forget(&mut self, mean_radius: f64) {
        *self = Self {
            reach: 0.0,
            approached: f64::INFINITY,
            mean_radius,
        };
    }

    /// Whether its numbers are possible, as they are unless a file was tampered with.
    pub(crate) fn is_sound(&self) -> bool {
        self.reach >= 0.0 && self.approached >= 0.0 && self.mean_radius >= 0.0
    }
}

/// Finds the candidates of a chunk that are nearer than a reach beyond touching.
pub(super) struct FindNear<'a> {
    pub(super) pairs: &'a [Pair],
    pub(super) scene: &'a Scene<'a>,
    /// Distance beyond touching, and beyond what the surfaces may bulge [m].
    pub(super) reach: f64,
    pub(super) near: &'a mut Vec<u32>,
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
                near[found] = (c + lane) as u32;
                found += (bits >> lane & 1) as usize;
                lane += 1;
            }
        }
        near.truncate(found);
    }
}
