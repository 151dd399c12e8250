//! Grains that left the domain, or whose places are no numbers.

use super::Simulation;
use crate::contacts::Fault;
use crate::particles::{MOST_CROSSINGS, Outside};
use crate::step::Motion;
use serde::{Deserialize, Serialize};

/// What a process finds among its own grains.
#[derive(Default, Serialize, Deserialize)]
struct Misplaced {
    /// Indices, rising.
    grains: Vec<usize>,
    /// The fault of the first that is nowhere, or that has gone round the box more often than is counted.
    nowhere: Option<Fault>,
    /// The fault of the one with the lowest id.
    outside: Option<Fault>,
}

impl Simulation {
    /// A grain that left the domain, or whose place is not a number, ends the run or is removed.
    pub(crate) fn check_places(&mut self, motion: &Motion) -> Result<(), Fault> {
        if motion.misplaced.is_none() && self.step > 0 {
            return Ok(());
        }
        let all = self.of_all_segments(vec![self.misplaced()]);
        let grains: Vec<usize> = all.iter().flat_map(|of| &of.grains).copied().collect();
        if grains.is_empty() {
            return Ok(());
        }
        if let Some(fault) = all.iter().find_map(|of| of.nowhere.clone()) {
            return Err(fault);
        }
        let outside = all.into_iter().filter_map(|of| of.outside).min_by_key(Fault::grain);
        if let Some(fault) = outside.filter(|_| self.comm.domain().outside == Outside::Stop) {
            return Err(fault);
        }
        self.remove(&grains);
        // others are neighbours now
        self.exchange_borders(|_| ());
        Ok(())
    }

    fn misplaced(&self) -> Misplaced {
        let (domain, grains) = (self.comm.domain(), &self.grains);
        let outside = || self.own_grains().filter(|&g| !domain.contains(grains.position[g]));
        let nowhere = |g: usize| Fault::NotFinite {
            step: self.step,
            id: grains.id[g],
            quantity: "position".into(),
            position: self.neighbours.former.of_grain(g).unwrap_or(glam::DVec3::NAN),
        };
        let too_often = |g: usize| Fault::CrossedTooOften {
            step: self.step,
            id: grains.id[g],
            position: grains.position[g],
            most: MOST_CROSSINGS,
        };
        let lost = |g: usize| match grains.position[g].is_finite() {
            true => grains
                .crossings(g)
                .iter()
                .any(|n| n.abs() == MOST_CROSSINGS)
                .then(|| too_often(g)),
            false => Some(nowhere(g)),
        };
        let fault = |g: usize| Fault::Outside {
            step: self.step,
            id: grains.id[g],
            position: grains.position[g],
            velocity: grains.velocity[g],
            lower: domain.lower,
            upper: domain.upper,
        };
        Misplaced {
            grains: outside().collect(),
            nowhere: outside().find_map(lost),
            outside: outside().min_by_key(|&g| grains.id[g]).map(fault),
        }
    }
}
