//! Grains that come and go between two steps.

use super::time_step::largest_reach;
use super::{Energies, Simulation, SkinTuner};
use crate::contacts::Coupling;
use crate::insertion::{Vicinity, first_overlap};
use crate::materials::Materials;
use crate::particles::{Grains, HigherDerivatives, NewGrain};
use crate::simulation::{Skin, WallPartner};
use crate::step::CouplingState;
use crate::walls::Wall;
use demeter_physics::integrator::Integrator;
use glam::DVec3;
use std::ops::Range;

/// A touch by so small a share of the radius is rounding.
const ROUNDING: f64 = 1e-9;

/// Why grains cannot come.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
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
    /// A grain would come outside of the domain.
    #[error(
        "grain {index} of those that are to come lies at {position}, outside of the domain, which reaches from {lower} to {upper}; let it \
         come inside, or widen the domain"
    )]
    Outside {
        /// Its place among those that come.
        index: usize,
        /// Its place [m].
        position: DVec3,
        /// Lower corner of the domain [m].
        lower: DVec3,
        /// Upper corner of the domain [m].
        upper: DVec3,
    },
    /// A grain would come where another one or a wall is.
    #[error(
        "grain {index} of those that are to come lies at {position} and reaches into {partner}, by {share:.3} of the smaller radius; \
         grains that come must touch nothing, so let it come elsewhere"
    )]
    InTheWay {
        /// Its place among those that come.
        index: usize,
        /// Its place [m].
        position: DVec3,
        /// What is there: `"grain 17"`, `"wall floor"`.
        partner: String,
        /// Overlap, or what is missing of the reach of an attraction, as a share of the smaller radius.
        share: f64,
    },
}

impl Simulation {
    /// Prepares a run that has not started for grains of other sizes and materials than those of its start, as `to_come`
    /// shows them, and for other laws: how far these reach, how wide the skin may be, how far surfaces may bulge.
    pub fn expect(&mut self, to_come: &Grains, later: &[Materials], skin: Skin, scheme: Coupling) {
        let mut all = self.grains.clone();
        all.append(to_come);
        let walls: Vec<WallPartner> = self.walls.iter().map(WallPartner::of).collect();
        let laws = std::iter::once(&self.materials).chain(later);
        let reaches = laws.map(|laws| largest_reach(&all, &walls, laws));
        self.max_reach = reaches.fold(0.0, f64::max);
        self.coupling = CouplingState::new(scheme, &all, &self.materials);
        let beyond_touch = (self.max_reach, self.coupling.is_some());
        self.tuner = SkinTuner::new(skin, &all, self.comm.domain(), beyond_touch);
    }

    /// Largest gap across which any law acts [m]: a grain that comes farther away from all others changes no energy.
    pub fn largest_reach(&self) -> f64 {
        self.max_reach
    }

    /// Between two steps: takes grains, told by rising indices, out of the run and lets others come. What they carry is
    /// booked. Contacts of those that stay keep what they remember; the grains that come must lie in the domain and touch or
    /// attract nothing, but fixed ones may meet walls and each other. Either all of that happens or nothing. Answers with the
    /// ids of those that came. Where processes share the run each calls this with the same.
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
        if !come.is_empty() {
            self.check_room(leave, come)?;
        }
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

    /// Refuses grains that come outside of the domain or where something is. Each process looks among its own grains.
    fn check_room(&self, leave: &[usize], come: &[NewGrain]) -> Result<(), ExchangeError> {
        let (domain, grains) = (self.comm.domain(), &self.grains);
        if let Some(index) = come.iter().position(|grain| !domain.contains(grain.position)) {
            return Err(ExchangeError::Outside {
                index,
                position: come[index].position,
                lower: domain.lower,
                upper: domain.upper,
            });
        }
        let to_come = || come.iter().map(|grain| (grain.position, grain.radius));
        let vicinity = Vicinity::around(to_come(), domain);
        let there: Vec<usize> = (self.own_grains())
            .filter(|g| leave.binary_search(g).is_err())
            .filter(|&g| vicinity.may_meet(grains.position[g], grains.radius(g), self.max_reach))
            .collect();
        let all: Vec<(DVec3, f64)> = (there.iter().map(|&g| (grains.position[g], grains.radius(g))))
            .chain(to_come())
            .collect();
        let is_fixed = |k: usize| match there.get(k) {
            Some(&g) => grains.is_fixed(g),
            None => come[k - there.len()].fixed,
        };
        let counts = |i: usize, j: usize| i.max(j) >= there.len() && !(is_fixed(i) && is_fixed(j));
        let reach = |radius: f64| radius * (1.0 - ROUNDING) + 0.5 * self.max_reach;
        let reaches: Vec<(DVec3, f64)> = all.iter().map(|&(place, radius)| (place, reach(radius))).collect();
        let with_grain = first_overlap(&reaches, Some(domain), counts).map(|found| {
            let partner = match there.get(found.first) {
                Some(&g) => format!("grain {}", grains.id[g]),
                None => format!("grain {} of them", found.first - there.len()),
            };
            let smaller = all[found.first].1.min(all[found.second].1);
            (found.second - there.len(), partner, found.overlap / smaller)
        });
        let at_walls = come
            .iter()
            .enumerate()
            .filter(|(_, grain)| !grain.fixed)
            .flat_map(|(index, grain)| {
                let place = domain.brought_back(grain.position);
                let reach = grain.radius * (1.0 - ROUNDING) + self.max_reach;
                let share = move |wall: &Wall| Some((reach - wall.nearest(place, reach)?) / grain.radius);
                (self.walls.iter()).filter_map(move |wall| Some((index, format!("wall {}", wall.name), share(wall)?)))
            });
        let all = self.of_all_segments(with_grain.into_iter().chain(at_walls).collect());
        match all.into_iter().max_by(|one, other| one.2.total_cmp(&other.2)) {
            None => Ok(()),
            Some((index, partner, share)) => Err(ExchangeError::InTheWay {
                index,
                position: come[index].position,
                partner,
                share,
            }),
        }
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
