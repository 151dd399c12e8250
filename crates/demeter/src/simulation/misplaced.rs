//! Grains that left the domain, or whose places are no numbers.

use super::Simulation;
use crate::contacts::{Departure, Fault};
use crate::particles::{MOST_CROSSINGS, Outside};
use crate::step::Motion;
use glam::DVec3;
use serde::{Deserialize, Serialize};

/// Most grains that are told of those that leave the domain in a stage.
pub(crate) const MOST_TOLD: usize = 10;

/// What a process finds among its own grains.
#[derive(Default, Serialize, Deserialize)]
struct Misplaced {
    /// Indices, rising.
    grains: Vec<usize>,
    /// Their masses [kg].
    masses: Vec<f64>,
    /// The fault of the first that is nowhere.
    nowhere: Option<Fault>,
    /// Those with the lowest ids, rising.
    departures: Vec<Departure>,
}

/// A grain whose latest crossing of a periodic side could not be counted.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub(crate) struct Uncounted {
    pub(crate) id: u32,
    pub(crate) position: DVec3,
}

impl Uncounted {
    /// One of another process.
    pub(crate) const ELSEWHERE: Self = Self {
        id: u32::MAX,
        position: DVec3::NAN,
    };
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
        let masses: Vec<f64> = all.iter().flat_map(|of| &of.masses).copied().collect();
        let departures = all.into_iter().flat_map(|of| of.departures);
        let departures = first_by_id(departures.collect());
        let domain = self.comm.domain();
        if let (Outside::Stop, Some(&departure)) = (domain.outside, departures.first()) {
            return Err(Fault::Outside {
                departure,
                lower: domain.lower,
                upper: domain.upper,
            });
        }
        self.departures = departures;
        self.books.leave_the_domain(&masses);
        self.remove(&grains);
        // others are neighbours now
        self.exchange_borders(|_| ());
        Ok(())
    }

    /// Notes the grains that have just gone round a periodic box more often than is counted.
    pub(super) fn note_uncounted(&mut self, grains: &[usize]) {
        let tell = |&g: &usize| Uncounted {
            id: self.grains.id[g],
            position: self.grains.position[g],
        };
        let all = grains.iter().map(tell).chain(self.uncounted);
        self.uncounted = all.min_by_key(|uncounted| uncounted.id);
    }

    /// A grain that went round a periodic box more often than is counted ends the run.
    pub(crate) fn check_crossings(&mut self) -> Result<(), Fault> {
        // all know whether any has one, since candidates were counted
        let Some(mine) = self.uncounted.take() else {
            return Ok(());
        };
        let all = self.of_all_segments(vec![mine]);
        let first = all.into_iter().min_by_key(|uncounted| uncounted.id);
        first.map_or(Ok(()), |Uncounted { id, position }| {
            Err(Fault::CrossedTooOften {
                step: self.step,
                id,
                position,
                most: MOST_CROSSINGS,
            })
        })
    }

    fn misplaced(&self) -> Misplaced {
        let (domain, grains) = (self.comm.domain(), &self.grains);
        let outside = || self.own_grains().filter(|&g| !domain.contains(grains.position[g]));
        let nowhere = |g: usize| Fault::NotFinite {
            step: self.step,
            id: grains.id[g],
            quantity: "position".into(),
            position: self.neighbours.former.of_grain(g).unwrap_or(DVec3::NAN),
        };
        let departure = |g: usize| Departure {
            step: self.step,
            id: grains.id[g],
            position: grains.position[g],
            velocity: grains.velocity[g],
        };
        Misplaced {
            grains: outside().collect(),
            masses: outside().map(|g| grains.mass(g)).collect(),
            nowhere: outside().find(|&g| !grains.position[g].is_finite()).map(nowhere),
            departures: first_by_id(outside().map(departure).collect()),
        }
    }
}

/// As many of them as are told, by rising ids.
fn first_by_id(mut departures: Vec<Departure>) -> Vec<Departure> {
    departures.sort_unstable_by_key(|departure| departure.id);
    departures.truncate(MOST_TOLD);
    departures
}
