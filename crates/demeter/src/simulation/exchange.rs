//! Grains that come and go between two steps.

use super::time_step::largest_reach;
use super::{Energies, Simulation, SkinTuner};
use crate::contacts::Coupling;
use crate::particles::{Grains, HigherDerivatives, NewGrain};
use crate::simulation::{Skin, WallPartner};
use crate::step::CouplingState;
use demeter_physics::integrator::Integrator;
use glam::DVec3;
use std::ops::Range;

/// Why grains cannot come.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
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
    /// Grains that leave are told by rising indices.
    #[error(
        "the grains that leave must be told by rising indices below the number of grains, {grains}; {index} is none"
    )]
    Leave {
        /// The index that is out of order, or of no grain.
        index: usize,
        /// Number of grains.
        grains: usize,
    },
    /// A grain that comes is impossible.
    #[error("grain {index} of those that are to come has {what} of {value}, which must be {allowed}")]
    Come {
        /// Its place among those that come.
        index: usize,
        /// What is wrong.
        what: &'static str,
        /// Its value.
        value: f64,
        /// What it must be.
        allowed: &'static str,
    },
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
        self.check_leaving(leave)?;
        self.check_coming(come)?;
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

    fn check_leaving(&self, leave: &[usize]) -> Result<(), ExchangeError> {
        let grains = self.grains.len();
        let out_of_order = leave.windows(2).find(|two| two[0] >= two[1]).map(|two| two[1]);
        let beyond = leave
            .last()
            .copied()
            .filter(|&last| !self.is_divided() && last >= grains);
        match out_of_order.or(beyond) {
            None => Ok(()),
            Some(index) => Err(ExchangeError::Leave { index, grains }),
        }
    }

    fn check_coming(&self, come: &[NewGrain]) -> Result<(), ExchangeError> {
        let materials = self.materials.list().len();
        for (index, grain) in come.iter().enumerate() {
            let vectors = [
                ("a place", grain.position),
                ("a velocity", grain.velocity),
                ("an angular velocity", grain.angular_velocity),
            ];
            let components = vectors
                .into_iter()
                .flat_map(|(what, v)| v.to_array().map(|value| (what, value)));
            let lost = components
                .filter(|(_, value)| !value.is_finite())
                .map(|(what, value)| (what, value, "finite"));
            let sizes = [("a radius", grain.radius), ("a density", grain.density)].into_iter();
            let sizes = sizes.filter(|(_, value)| !(*value > 0.0 && value.is_finite()));
            let sizes = sizes.map(|(what, value)| (what, value, "above 0 and finite"));
            let unknown = (usize::from(grain.material) >= materials)
                .then(|| ("a material", f64::from(grain.material), "below the number of materials"));
            if let Some((what, value, allowed)) = lost.chain(sizes).chain(unknown).next() {
                return Err(ExchangeError::Come {
                    index,
                    what,
                    value,
                    allowed,
                });
            }
        }
        Ok(())
    }

    /// Energies that grains which come or go bring or take: what is there at the start is booked then.
    pub(super) fn carried(&self, counts: impl Fn(usize) -> bool + Sync) -> Energies {
        if self.is_started() {
            self.energies_of(counts)
        } else {
            Energies::default()
        }
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
        let gained = self.carried(|g| ids.contains(&self.grains.id[g]));
        self.books.insert(come.len() as u64, &gained);
    }
}
