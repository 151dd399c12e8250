//! Grains that come and go between two steps.

use super::time_step::largest_reach;
use super::{Simulation, SkinTuner};
use crate::contacts::Coupling;
use crate::particles::{Grains, HigherDerivatives, NewGrain};
use crate::simulation::{Skin, WallPartner};
use crate::step::CouplingState;
use demeter_physics::integrator::Integrator;
use glam::DVec3;
use std::ops::Range;

/// Why grains cannot come.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ExchangeError {
    /// No id is left.
    #[error(
        "{asked} grains cannot come: ids end at {}, and the latest is {latest}; number the grains of files from 1",
        u32::MAX
    )]
    IdsUsedUp {
        /// Number of grains that were to come.
        asked: usize,
        /// The highest id given so far.
        latest: u32,
    },
    /// The box deforms.
    #[error("no grains can come or go while the periodic box deforms")]
    Deforms,
}

impl Simulation {
    /// Prepares a run that has not started for grains of other sizes and materials than those of its start, as `to_come`
    /// shows them: how far laws reach, how wide the skin may be, how far surfaces may bulge.
    pub fn expect_grains(&mut self, to_come: &Grains, skin: Skin, scheme: Coupling) {
        let mut all = self.grains.clone();
        all.append(to_come);
        let walls: Vec<WallPartner> = self.walls.iter().map(WallPartner::of).collect();
        self.max_reach = largest_reach(&all, &walls, &self.materials);
        self.coupling = CouplingState::new(scheme, &all, &self.materials);
        let beyond_touch = (self.max_reach, self.coupling.is_some());
        self.tuner = SkinTuner::new(skin, &all, self.comm.domain(), beyond_touch);
    }

    /// Largest gap across which any law acts [m]: a grain that comes farther away from all others changes no energy.
    pub fn largest_reach(&self) -> f64 {
        self.max_reach
    }

    /// Between two steps: takes grains, told by rising indices, out of the run and lets others come. What they carry is
    /// booked. Contacts of those that stay keep what they remember; the grains that come must touch nothing. Answers with
    /// the ids of those that came. Where processes share the run each calls this with the same.
    pub fn exchange(&mut self, leave: &[usize], come: &[NewGrain]) -> Result<Range<u32>, ExchangeError> {
        if self.deforms() && !(leave.is_empty() && come.is_empty()) {
            return Err(ExchangeError::Deforms);
        }
        let first = self.next_id();
        let end = u32::try_from(come.len())
            .ok()
            .and_then(|count| first.checked_add(count));
        let Some(end) = end else {
            return Err(ExchangeError::IdsUsedUp {
                asked: come.len(),
                latest: self.latest_id,
            });
        };
        self.hear_corrected_places();
        if !leave.is_empty() {
            self.remove(leave);
        }
        if !come.is_empty() {
            self.insert(first, come);
            self.latest_id = end - 1;
        }
        Ok(first..end)
    }

    /// Indices, rising, of all grains for which something holds. Where processes share the run each calls this, and looks at its own.
    pub fn grains_where(&self, holds: impl Fn(usize) -> bool) -> Vec<usize> {
        self.of_all_segments(self.own_grains().filter(|&grain| holds(grain)).collect())
    }

    /// The id that the next grain gets: above all that were ever given.
    fn next_id(&self) -> u32 {
        self.latest_id.saturating_add(1)
    }

    fn insert(&mut self, first_id: u32, come: &[NewGrain]) {
        let before = self.grains.len();
        for (id, grain) in (first_id..).zip(come) {
            self.grains.push(id, grain);
        }
        if self.integrator == Integrator::Gear {
            self.grains
                .higher
                .resize(self.grains.len(), HigherDerivatives::default());
        }
        for g in before..self.grains.len() {
            // the first half kick is that of gravity alone
            let load = &mut self.grains.load.rows_mut()[g];
            load.put(self.gravity * load.mass(), DVec3::ZERO);
        }
        // how fast those are that came is found in the next step
        self.forget_spreads(before);
        self.lengthen_division();
        self.find_candidates();
        self.foresee_bulges();
        let ids = first_id..;
        let gained = self.energies_of(|g| ids.contains(&self.grains.id[g]));
        self.books.insert(come.len() as u64, &gained);
    }
}
