//! What processes that share a run tell each other in a step.

use super::{Division, NUMBERS};
use crate::contacts::Fault;
use crate::contacts::step_work::WorkShare;
use crate::particles::spread::{NUMBERS_OF_A_SPREAD, Spread};
use crate::simulation::Simulation;
use crate::step::Motion;
use demeter_physics::integrator::Integrator;
use glam::DVec3;
use serde::{Deserialize, Serialize};
use std::ops::Range;
use std::sync::Arc;

impl Simulation {
    /// What the motion of the grains of all processes came to. Of the faults of grains that processes found before they moved them, that
    /// of the lowest id ends the step of all.
    pub(crate) fn motion_of_all(&mut self, motion: Motion, found: Option<Fault>) -> Result<Motion, Fault> {
        let Some(division) = self.division.as_mut().filter(|division| !division.is_whole) else {
            return found.map_or(Ok(motion), Err);
        };
        let [max_speed, max_step, misplaced, fault, end] = division.largest([
            motion.max_speed,
            motion.max_step,
            flag(motion.misplaced.is_some()),
            flag(found.is_some()),
            flag(division.wants_to_end),
        ]);
        division.is_asked_to_end = end > 0.0;
        if fault > 0.0 {
            return Err(division.first_fault(found));
        }
        Ok(Motion {
            max_speed,
            max_step,
            by_box: motion.by_box,
            misplaced: (misplaced > 0.0).then_some(0),
            bad: None,
        })
    }

    /// The largest numbers of all processes; not a number where any is none.
    pub(crate) fn largest_of_all<const N: usize>(&self, mine: [f64; N]) -> [f64; N] {
        match self.division.as_ref().filter(|division| !division.is_whole) {
            Some(division) => division.largest(mine),
            None => mine,
        }
    }

    /// Whether it is so for any process.
    pub(crate) fn any_of_all(&self, mine: bool) -> bool {
        let [any] = self.largest_of_all([flag(mine)]);
        any > 0.0
    }

    /// The sum of what all processes count.
    pub(crate) fn count_of_all(&self, mine: u64) -> u64 {
        match self.division.as_ref().filter(|division| !division.is_whole) {
            Some(division) => division.counts([mine]).0[0],
            None => mine,
        }
    }

    /// Moves the own grains, told by their range; tells the neighbours how those near the borders move, and hears it of theirs while the
    /// others move.
    pub(crate) fn move_and_exchange(&mut self, mut moves: impl FnMut(&mut Self, Range<usize>) -> Motion) -> Motion {
        if !self.is_divided() {
            return moves(self, 0..self.grains.len());
        }
        let mut motion = Motion::default();
        for near in self.parts_at_borders(true) {
            let moved = moves(self, near);
            motion = motion.merge(moved, &self.grains.id);
        }
        self.exchange_borders(|sim| {
            for other in sim.parts_at_borders(false) {
                let moved = moves(sim, other);
                motion = std::mem::take(&mut motion).merge(moved, &sim.grains.id);
            }
        });
        motion
    }

    /// Stretches of own segments with grains that others hear of, or those without.
    fn parts_at_borders(&self, at_borders: bool) -> Vec<Range<usize>> {
        let Some(division) = &self.division else {
            return Vec::new();
        };
        let mut parts: Vec<Range<usize>> = Vec::new();
        for segment in division.segments() {
            if division.tells_of[segment - division.segments().start] != at_borders {
                continue;
            }
            let grains = self.neighbours.grains_of_segment(segment);
            match parts.last_mut().filter(|before| before.end == grains.start) {
                Some(before) => before.end = grains.end,
                None => parts.push(grains),
            }
        }
        parts
    }

    /// Tells the neighbours how the grains near the borders move, works, and hears it of theirs.
    pub(crate) fn exchange_borders(&mut self, mut meanwhile: impl FnMut(&mut Self)) {
        let Some(mut division) = self.division.take_if(|division| !division.is_whole) else {
            return;
        };
        for (border, message) in division.borders.iter().zip(&mut division.messages) {
            message.tell.clear();
            for &g in &border.tell {
                let (g, grains) = (g as usize, &self.grains);
                for vector in [grains.position[g], grains.velocity[g], grains.angular_velocity[g]] {
                    message.tell.extend(vector.to_array());
                }
            }
            for &segment in &border.tell_segments {
                let spread = self.neighbours.spread_of(segment as usize, &self.spreads);
                message.tell.extend(spread.numbers());
            }
        }
        let ranks = Arc::clone(&division.ranks);
        let mut messages = std::mem::take(&mut division.messages);
        self.division = Some(division);
        ranks.exchange(&mut messages, &mut || meanwhile(self));
        let Some(division) = &mut self.division else { return };
        division.messages = messages;
        for (border, message) in division.borders.iter().zip(&division.messages) {
            let grains = &mut self.grains;
            let (of_grains, of_segments) = message.hear.split_at(NUMBERS * border.hear.len());
            for (&g, numbers) in border.hear.iter().zip(of_grains.chunks_exact(NUMBERS)) {
                let g = g as usize;
                grains.position[g] = DVec3::from_slice(&numbers[0..3]);
                grains.velocity[g] = DVec3::from_slice(&numbers[3..6]);
                grains.angular_velocity[g] = DVec3::from_slice(&numbers[6..9]);
            }
            let of_segments = of_segments.chunks_exact(NUMBERS_OF_A_SPREAD);
            for (&segment, numbers) in border.hear_segments.iter().zip(of_segments) {
                let spreads = self.neighbours.spreads_of_segment(segment as usize);
                self.spreads[spreads].fill(Spread::of_numbers(numbers));
            }
        }
    }

    /// After a step: hears where the grains near the borders are, where they were moved once more when their forces were known.
    pub(crate) fn hear_corrected_places(&mut self) {
        if self.integrator == Integrator::Gear {
            self.exchange_borders(|_| ());
        }
    }

    /// Sums up what the contacts of all processes did in this step. The first fault of any ends the step of all.
    pub(crate) fn sum_up_work(&mut self) -> Result<(), Fault> {
        let (contacts, neighbours, walls) = (&self.contacts, &self.neighbours, self.walls.len());
        let Some(division) = self.division.as_ref().filter(|division| !division.is_whole) else {
            return self.work.of_all(contacts, neighbours, walls);
        };
        let mine = self.work.share(contacts, neighbours, division.segments());
        let join = |before: WorkShare, behind| before.with(behind, neighbours.segments());
        self.work.of_share(division.fold(mine, join), walls)
    }

    /// What all processes have of their own segments, in the order of the segments.
    pub(crate) fn of_all_segments<T: Serialize + for<'a> Deserialize<'a>>(&self, here: Vec<T>) -> Vec<T> {
        let Some(division) = self.division.as_ref().filter(|division| !division.is_whole) else {
            return here;
        };
        division.told_by_all(&here).into_iter().flatten().collect()
    }

    /// The fault of the grain with the lowest id, where any process has found one.
    pub(crate) fn fault_of_any(&mut self, found: Option<Fault>) -> Result<(), Fault> {
        let Some(division) = self.division.as_mut() else {
            return found.map_or(Ok(()), Err);
        };
        let [fault, end] = division.largest([flag(found.is_some()), flag(division.wants_to_end)]);
        division.is_asked_to_end = end > 0.0;
        if fault > 0.0 {
            return Err(division.first_fault(found));
        }
        Ok(())
    }
}

impl Division {
    /// The fault of the grain with the lowest id, where at least one process has found one.
    fn first_fault(&self, found: Option<Fault>) -> Fault {
        let faults = self.fold(Vec::from_iter(found), |a, b| [a, b].concat());
        let first = faults.into_iter().min_by_key(Fault::grain);
        first.unwrap_or_else(|| self.ranks.give_up("another process told of a fault and then of none"))
    }
}

fn flag(is: bool) -> f64 {
    if is { 1.0 } else { 0.0 }
}
