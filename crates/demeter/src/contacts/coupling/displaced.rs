//! Contacts between displaced surfaces: their overlaps, the forces that follow, and what the laws see.

use super::sites::Changes;
use super::{Delivered, Scratch, Worst, lever_shift};
use crate::contacts::Span;
use crate::contacts::{ContactChunk, Fault, Kept, Scene};
use demeter_physics::contact::PairSize;
use demeter_physics::contact::normal::{Normal, NormalVisitor};
use demeter_physics::integrator::Integrator;
use std::ops::Range;

/// A displaced overlap beyond this multiple of the largest overlap allowed tells that the coupled equation has no
/// solution: at the fold of a regular packing the displacements add twice the overlap.
const LARGEST_DISPLACED: f64 = 3.0;

/// Forces closer to their solution than this share of the tolerance are not changed any more.
const GOOD_ENOUGH: f64 = 0.1;

/// Forces below this share of the largest anywhere are not told from none.
const LEAST_SHARE: f64 = 1e-2;

/// Where a chunk stands among the others.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ChunkPlace {
    pub(crate) wall: bool,
}

/// Largest forces, which deviations are told from [N].
#[derive(Clone, Copy)]
pub(crate) struct Scale<'a> {
    /// On every grain.
    pub(crate) of_grains: &'a [f64],
    /// Anywhere, when the solution begins.
    pub(crate) of_all: f64,
}

/// Elastic forces of a run of contacts of one material pair, at the displaced overlaps.
struct Elastic<'a> {
    span: Span,
    integrator: Integrator,
    stride: usize,
    overlap: &'a [f64],
    rate: &'a [f64],
    size: &'a [PairSize],
    history: &'a [f64],
    memory: &'a mut Vec<f64>,
    answer: &'a mut [f64],
}

impl NormalVisitor for Elastic<'_> {
    type Output = ();

    fn visit<L: Normal>(self, law: &L) {
        let remembered = law.history();
        self.memory.resize(remembered, 0.0);
        for (k, answer) in self.answer.iter_mut().enumerate() {
            let (size, overlap, rate) = (self.size[k], self.overlap[k], self.rate[k]);
            let input = self.span.normal_input::<L, f64>(self.integrator, size, overlap, rate);
            self.memory
                .copy_from_slice(&self.history[k * self.stride..][..remembered]);
            *answer = law.respond(&input, self.memory).elastic;
        }
    }
}

impl ContactChunk {
    /// Takes the forces and levers to begin with: those of the step before, or those foreseen where the coupled equation is solved.
    pub(crate) fn begin_coupling(&mut self, at: ChunkPlace, converge: bool) {
        let Scratch {
            sources,
            trial,
            lever_shift,
            ..
        } = &mut *self.coupling;
        sources.clear();
        trial.clear();
        lever_shift.clear();
        for (contact, earlier) in self.now.geometry.iter().zip(&self.now.coupling) {
            let (force, shift) = if converge {
                (earlier.foreseen(), earlier.lever_shift() + earlier.lever_trend)
            } else {
                (earlier.elastic, earlier.lever_shift())
            };
            // at a wall the contact point is the foot of the perpendicular
            let shift = if at.wall { 0.0 } else { shift };
            let [x, y, z] = contact.normal.to_array();
            sources.push([
                [x, y, z, contact.lever_i + shift],
                [-x, -y, -z, contact.lever_j - shift],
            ]);
            trial.push(force);
            lever_shift.push(shift);
        }
        let count = self.len().max(self.coupling.delivered.len());
        self.coupling.delivered.resize_with(count, Delivered::default);
        self.coupling.forget_falls();
        if converge {
            let Scratch {
                undisplaced, mixing, ..
            } = &mut *self.coupling;
            undisplaced.clear();
            undisplaced.extend(self.now.geometry.iter().map(|contact| contact.overlap));
            mixing.forget();
        }
    }

    /// Takes the displacements of the sites, finds the elastic forces that the laws answer with, and how far they are from
    /// those tried: of contacts whose displacement may have changed.
    pub(crate) fn answer(&mut self, at: ChunkPlace, scene: &Scene, scale: Scale<'_>, changes: &Changes) {
        let count = self.len();
        self.coupling.overlap.resize(count, 0.0);
        self.coupling.answer.resize(count, 0.0);
        self.coupling.share.resize(count, 0.0);
        let concerned = |chunk: &Self, k: usize| changes.any(chunk.i[k]) || (!at.wall && changes.any(chunk.j[k]));
        let mut k = 0;
        while k < count {
            if !concerned(self, k) {
                k += 1;
                continue;
            }
            let first = k;
            while k < count && concerned(self, k) {
                let [one, other] = self.coupling.delivered[k].of_both();
                self.coupling.overlap[k] = self.coupling.undisplaced[k] + (one + other);
                k += 1;
            }
            self.coupling.find_forces(first..k, &self.now, self.law, scene);
            if !self.coupling.falls.is_empty() {
                self.yield_at_falls(first..k, at, scene, scale);
            }
            for k in first..k {
                self.coupling.share[k] = self.deviation_share(k, at, scale);
            }
        }
        let Scratch { share, worst, .. } = &mut *self.coupling;
        *worst = Worst::default();
        for (contact, &share) in share.iter().enumerate() {
            if share.is_nan() || share > worst.share {
                *worst = Worst { share, contact };
            }
        }
    }

    /// How far a contact's force is from the one tried, as a share of the largest force on its grains.
    fn deviation_share(&self, k: usize, at: ChunkPlace, scale: Scale<'_>) -> f64 {
        let coupling = &self.coupling;
        let deviation = (coupling.answer[k] - coupling.trial[k]).abs();
        if deviation == 0.0 {
            return 0.0;
        }
        // where all forces were 0 so far, nothing is known yet
        let largest = self.largest_near(k, at, scale).max(coupling.answer[k].abs());
        let share = deviation / largest;
        match coupling.falls.get(k) {
            Some(fall) if fall.slope > 0.0 => self.share_at_fall(k, fall, share, largest),
            _ => share,
        }
    }

    /// Largest force on the bodies of a contact, or a share of the largest anywhere [N].
    pub(super) fn largest_near(&self, k: usize, at: ChunkPlace, scale: Scale<'_>) -> f64 {
        let mut largest = scale.of_grains[self.i[k] as usize].max(LEAST_SHARE * scale.of_all);
        if !at.wall {
            largest = largest.max(scale.of_grains[self.j[k] as usize]);
        }
        largest
    }

    /// Goes on with the forces that the laws answered with, where they are not good enough.
    pub(crate) fn iterate(&mut self, at: ChunkPlace, changes: &Changes, tolerance: f64) {
        for k in 0..self.len() {
            if self.coupling.share[k] > GOOD_ENOUGH * tolerance {
                self.coupling.trial[k] = self.coupling.answer[k];
                self.note_change(k, at, changes);
            }
        }
    }

    /// Notes that the force tried at a contact has changed.
    #[inline(always)]
    fn note_change(&self, k: usize, at: ChunkPlace, changes: &Changes) {
        changes.note_force(self.i[k]);
        if !at.wall {
            changes.note_force(self.j[k]);
        }
    }

    /// Moves the levers that displacements have changed by more than a share of the smaller radius.
    pub(crate) fn move_levers(&mut self, at: ChunkPlace, scene: &Scene, changes: &Changes, tolerance: f64) {
        if at.wall {
            return;
        }
        for k in 0..self.len() {
            let shift = lever_shift(self.coupling.delivered[k].of_both());
            let change = shift - self.coupling.lever_shift[k];
            let (i, j) = (self.i[k], self.j[k]);
            if change.abs() > tolerance * scene.smaller_radius(i, Some(j)) {
                self.coupling.lever_shift[k] = shift;
                let [first, second] = &mut self.coupling.sources[k];
                first[3] += change;
                second[3] -= change;
                changes.note_lever(i);
                changes.note_lever(j);
            }
        }
    }

    /// Puts the displacements into the geometry that the laws see, and watches that they stay within reason.
    pub(crate) fn deform(&mut self, at: ChunkPlace, scene: &Scene) {
        self.coupling.asleep.clear();
        for k in 0..self.len() {
            let displacement = self.coupling.delivered[k].of_both();
            let contact = &mut self.now.geometry[k];
            let undisplaced = contact.overlap;
            contact.overlap = match self.coupling.falls.get(k) {
                Some(fall) if fall.slope > 0.0 => fall.overlap,
                _ => undisplaced + (displacement[0] + displacement[1]),
            };
            if !at.wall {
                let shift = lever_shift(displacement);
                contact.lever_i += shift;
                contact.lever_j -= shift;
            }
            let overlap = contact.overlap;
            let (size, rate) = (self.coupling.size[k], self.coupling.rate[k]);
            let acts = overlap > 0.0 || scene.acts(self.law, || size, overlap, rate);
            self.coupling.asleep.push(!acts);
            let allowed = LARGEST_DISPLACED * scene.max_overlap;
            // no radius is smaller than the effective one
            if overlap.is_nan() || overlap > allowed * size.radius {
                let radius = scene.smaller_radius(self.i[k], (!at.wall).then_some(self.j[k]));
                if (overlap.is_nan() || overlap > allowed * radius) && self.fault.is_none() {
                    self.fault = Some(Box::new(self.beyond_fold(k, at, scene, undisplaced)));
                }
            }
        }
    }

    /// The fault of a contact whose coupled equation has no solution; `overlap` is that of the undisplaced spheres [m].
    pub(crate) fn beyond_fold(&self, k: usize, at: ChunkPlace, scene: &Scene, overlap: f64) -> Fault {
        let (grain, other) = (self.i[k] as usize, self.j[k] as usize);
        let [first, second] = self.coupling.delivered[k].of_both();
        let radius = scene.smaller_radius(self.i[k], (!at.wall).then_some(self.j[k]));
        let (across, partner) = if at.wall {
            let name = &scene.walls[other].name;
            (scene.grains.radius(grain), format!("wall {name}"))
        } else {
            let across = scene.grains.radius(grain) + scene.grains.radius(other);
            (across, format!("grain {}", scene.grains.id[other]))
        };
        Fault::BeyondFold {
            step: scene.step,
            id: scene.grains.id[grain],
            position: scene.grains.position[grain],
            partner,
            strain: overlap / across,
            displacement_share: (first + second) / radius,
        }
    }

    /// Contacts whose displaced surfaces meet now and did not in the step before, where somebody asks.
    pub(crate) fn beginning(&self, scene: &Scene) -> Vec<usize> {
        if !(scene.tells_impacts && scene.is_coupled()) {
            return Vec::new();
        }
        let (before, asleep) = (&self.now.coupling, &self.coupling.asleep);
        let begins = |&k: &usize| !asleep[k] && !before[k].meets;
        (0..self.len()).filter(begins).collect()
    }

    /// Remembers the elastic forces for the displacements to come, and books what the displacements put into the stored
    /// energy.
    ///
    /// Stored are `U = sum Phi(overlap + D) - F D / 2`. From one step to the next it grows by the work `F d(overlap)` and by
    /// `(F_0 D_1 - F_1 D_0)/2`: nothing, where influences are mutual and do not change.
    pub(crate) fn remember_coupling(&mut self, elastic: &[f64], scene: &Scene) {
        for (k, &force) in elastic.iter().enumerate() {
            let coupled = &mut self.now.coupling[k];
            let earlier = *coupled;
            coupled.displacement = self.coupling.delivered[k].of_both();
            self.tally.multi_contact += 0.5 * (earlier.elastic * coupled.sum() - force * earlier.sum());
            coupled.go_on(&earlier, force, scene.step == 0);
            coupled.meets = !self.coupling.asleep[k];
            if self.coupling.asleep[k] {
                self.forget_contact(k, scene);
            }
        }
    }

    /// Surfaces that do not meet yet, or no longer, remember nothing of a contact.
    fn forget_contact(&mut self, k: usize, scene: &Scene) {
        let history = &mut self.now.history[k * scene.stride..(k + 1) * scene.stride];
        if scene.stride > 0 {
            let law = scene.materials.law(self.law);
            let (tangential, rolling) = crate::contacts::laws::spring_energies(law, history);
            self.tally.friction += tangential;
            self.tally.rolling += rolling;
            history.fill(0.0);
        }
    }
}

impl Scratch {
    /// Elastic forces of contacts of one material pair at the displaced overlaps, with what they remember from the step
    /// before.
    fn find_forces(&mut self, run: Range<usize>, now: &Kept, law: u32, scene: &Scene) {
        let law = scene.materials.law(law);
        law.normal.visit(Elastic {
            span: scene.span,
            integrator: scene.integrator,
            stride: scene.stride,
            overlap: &self.overlap[run.clone()],
            rate: &self.rate[run.clone()],
            size: &self.size[run.clone()],
            history: &now.history[run.start * scene.stride..run.end * scene.stride],
            memory: &mut self.memory,
            answer: &mut self.answer[run],
        });
    }
}
