//! Narrow phase: which candidates touch during this step.
//!
//! A step acts over the time from `t - dt/2` to `t + dt/2`. A contact is active when the bodies touch at any moment of
//! it, assuming the present rate of approach: `overlap + |rate| dt/2 > 0`. A law that attracts across a gap is asked
//! as far as it reaches, and one window farther, so that it sees itself let go and books what that loses.

use super::asking::Span;
use super::coupling::Coupled;
use super::evaluate::WORD;
use super::laws::largest_reach;
use super::meetings::{FindPairs, Found};
use super::near::{FindNear, Sought};
use super::sum::Adder;
use super::{ContactChunk, Fault, Kept, Surfaces, Tally, is_set};
use crate::comm::Single;
use crate::materials::Materials;
use crate::neighbours::Pairs;
use crate::particles::{Beyond, Grains, make_room};
use crate::walls::Wall;
use demeter_physics::contact::{PairLaw, PairSize};
use demeter_physics::integrator::Integrator;
use demeter_physics::lanes::{self, Instructions};
use glam::DVec3;
use itertools::{EitherOrBoth, Itertools};
use std::cell::RefCell;

/// Everything that contacts are made of.
#[derive(Clone, Copy)]
pub struct Scene<'a> {
    /// Grains, with predicted velocities.
    pub grains: &'a Grains,
    /// Walls, at their place of this step.
    pub walls: &'a [Wall],
    /// Materials and their laws.
    pub materials: &'a Materials,
    /// Periodic sides.
    pub comm: &'a Single,
    /// Time step [s].
    pub dt: f64,
    /// How long the forces act.
    pub(crate) span: Span,
    /// How the equations of motion are integrated.
    pub integrator: Integrator,
    /// Number of this step.
    pub step: u64,
    /// Largest speed of any grain or wall surface [m/s].
    pub max_speed: f64,
    /// How the walls move.
    pub surfaces: &'a Surfaces,
    /// Largest gap across which any law acts [m].
    pub max_reach: f64,
    /// Largest overlap allowed, as share of the smaller radius.
    pub max_overlap: f64,
    /// History values per contact.
    pub stride: usize,
    /// Whether some law resists rolling.
    pub resists_rolling: bool,
    /// Whether some wall records what contacts do to it.
    pub records_walls: bool,
    /// Whether contacts that begin are told.
    pub(crate) tells_impacts: bool,
    /// Instructions to use.
    pub instructions: Instructions,
    /// How far the surface of every grain may bulge towards others [m]; empty where contacts are independent.
    pub bulge: &'a [f64],
}

impl Scene<'_> {
    /// Distance beyond touching at which bodies may act on each other in this step [m].
    pub(crate) fn widest_window(&self) -> f64 {
        self.window(self.max_speed * self.dt)
    }

    /// The same, told by how much nearer two bodies come in half of a step [m].
    pub(crate) fn window(&self, window: f64) -> f64 {
        if self.max_reach > 0.0 {
            self.max_reach + 2.0 * window
        } else {
            window
        }
    }

    /// Whether contacts feel each other.
    #[inline(always)]
    pub(crate) fn is_coupled(&self) -> bool {
        !self.bulge.is_empty()
    }

    /// Whether images across periodic sides move.
    pub(crate) fn is_deforming(&self) -> bool {
        !self.comm.shift_velocities().is_empty()
    }

    /// How far the surface of a grain may bulge [m].
    #[inline(always)]
    pub(super) fn bulge(&self, grain: usize) -> f64 {
        self.bulge.get(grain).copied().unwrap_or(0.0)
    }

    /// The smaller radius of two grains, or that of a grain at a wall [m].
    pub(crate) fn smaller_radius(&self, i: u32, j: Option<u32>) -> f64 {
        let radius = self.grains.radius(i as usize);
        j.map_or(radius, |j| radius.min(self.grains.radius(j as usize)))
    }

    /// Effective radius and mass of two grains.
    pub(super) fn size_of_pair(&self, i: usize, j: usize) -> PairSize {
        let grains = self.grains;
        PairSize::new(
            1.0 / (1.0 / grains.radius(i) + 1.0 / grains.radius(j)),
            1.0 / (grains.inverse_mass(i) + grains.inverse_mass(j)),
        )
    }

    /// Whether two bodies act on each other at any moment of this step; `overlap` with all that they may bulge.
    #[inline(always)]
    pub(crate) fn acts(&self, pair: u32, size: impl Fn() -> PairSize, overlap: f64, rate: f64) -> bool {
        let half_window = 0.5 * self.dt * rate.abs();
        if overlap + half_window > 0.0 {
            return true;
        }
        if self.max_reach == 0.0 {
            return false;
        }
        let reach = largest_reach(self.materials.law(pair), size());
        reach > 0.0 && overlap + reach + 2.0 * half_window > 0.0
    }
}

thread_local! {
    /// What a thread needs while it looks for the contacts of a chunk.
    static WORKSPACE: RefCell<(Found, Kept)> = RefCell::default();
}

impl ContactChunk {
    /// Finds the forces between grains of the pairs of a chunk that do not feel each other; those that may act are looked for
    /// where they are told with which distances. What they do is handed over.
    /// `found_all` is called when contacts are known.
    pub(crate) fn step_pairs(
        &mut self,
        (pairs, law): (Pairs<'_>, u32),
        sought: Option<Sought>,
        scene: &Scene,
        adder: &mut Adder,
        found_all: impl FnOnce(),
    ) {
        self.begin(0, law);
        if let Some(sought) = sought {
            // what is needed in between lies in memory of the thread, which stays in its caches from chunk to chunk
            WORKSPACE.with_borrow_mut(|(found, before)| {
                std::mem::swap(before, &mut self.before);
                let near = &mut found.candidates;
                lanes::run(
                    scene.instructions,
                    FindNear {
                        pairs,
                        scene,
                        sought,
                        near,
                    },
                );
                if found.candidates != self.now.candidate {
                    self.renew(pairs, found, scene);
                    // the memory of the thread is as large as its largest chunk needed
                    self.before.copy(&self.now, scene.stride);
                    std::mem::swap(&mut self.now, &mut *self.before);
                }
                std::mem::swap(before, &mut self.before);
            });
        }
        if !scene.comm.shifts().is_empty() && self.shift.len() != self.len() {
            self.note_shifts(pairs);
        }
        found_all();
        self.meet_pairs(scene, adder);
    }

    /// Takes the codes of the shifts of all contacts from their candidates.
    fn note_shifts(&mut self, pairs: Pairs<'_>) {
        self.shift.clear();
        let candidates = self.now.candidate.iter();
        make_room(&mut self.shift, candidates.len(), Beyond::Kept);
        self.shift
            .extend(candidates.map(|&candidate| pairs.get(usize::from(candidate)).shift));
    }

    /// Finds the contacts of a chunk of pairs of grains that feel each other.
    pub(crate) fn find_pairs(&mut self, (pairs, law): (Pairs<'_>, u32), scene: &Scene) {
        self.begin(0, law);
        WORKSPACE.with_borrow_mut(|(found, _)| {
            lanes::run(scene.instructions, FindPairs { pairs, scene, found });
            self.is_renewed = found.candidates != self.now.candidate;
            if self.is_renewed {
                self.renew(pairs, found, scene);
            }
            self.now.geometry.clear();
            self.now.geometry.extend_from_slice(&found.geometry);
            self.coupling.rate.clear();
            self.coupling.rate.extend_from_slice(&found.rate);
            if let Some(k) = found.too_deep {
                self.note_overlap(k, found.geometry[k].overlap, scene);
            }
        });
        if self.now.place.len() != pairs.len() {
            self.now.note_places(pairs.len());
        }
        if scene.is_deforming() && self.shift.len() != self.len() {
            self.note_shifts(pairs);
        }
        if self.coupling.size.len() != self.len() {
            self.note_sizes(scene);
        }
        self.now.coupling.resize(self.len(), Coupled::default());
    }

    /// Notes that a contact between grains has too much overlap.
    pub(super) fn note_overlap(&mut self, contact: usize, overlap: f64, scene: &Scene) {
        let (i, j) = (self.i[contact] as usize, self.j[contact] as usize);
        let smaller = scene.grains.radius(i).min(scene.grains.radius(j));
        self.watch_overlap(scene, i, overlap / smaller, || format!("grain {}", scene.grains.id[j]));
    }

    /// Takes over what the contacts of the step before remember, where not all of them are still the same.
    fn renew(&mut self, pairs: Pairs<'_>, found: &mut Found, scene: &Scene) {
        let stride = scene.stride;
        std::mem::swap(&mut self.now, &mut *self.before);
        found.acted.clone_from(&self.engaged);
        self.now.clear();
        self.i.clear();
        self.j.clear();
        self.shift.clear();
        self.engaged.clear();
        self.make_room(found.candidates.len(), stride, Beyond::Kept);
        self.engaged.resize(found.candidates.len().div_ceil(WORD), 0);
        let mut old = 0;
        // contacts that go on one behind the other are taken over together
        let mut going_on = 0..0;
        for (k, &candidate) in found.candidates.iter().enumerate() {
            while self.before.candidate.get(old).is_some_and(|&c| c < candidate) {
                self.book_end(old, scene);
                old += 1;
            }
            let goes_on = self.before.candidate.get(old) == Some(&candidate);
            let pair = pairs.get(usize::from(candidate));
            self.i.push(pair.i);
            self.j.push(pair.j);
            if goes_on && going_on.end == old {
                going_on.end += 1;
            } else {
                self.now.take_on(&self.before, going_on, stride);
                going_on = old..old + usize::from(goes_on);
            }
            if !goes_on {
                self.now.begin_contact(stride, scene.is_coupled());
            }
            // so that those which do not act any more are ended, and those which were merely near begin
            let acted = goes_on && is_set(&found.acted, old);
            self.engaged[k / WORD] |= u64::from(acted) << (k % WORD);
            old += usize::from(goes_on);
        }
        self.now.take_on(&self.before, going_on, stride);
        for old in old..self.before.candidate.len() {
            self.book_end(old, scene);
        }
        self.now.clear_tangential();
        self.now.candidate.extend_from_slice(&found.candidates);
        if scene.is_coupled() {
            self.coupling.size.clear();
            self.engaged.clear();
        }
    }

    /// Candidates between grains whose contacts began or ended in this step, where contacts feel each other and some did.
    pub(crate) fn coming_or_going(&self) -> impl Iterator<Item = u16> + '_ {
        let (before, now) = (self.before.candidate.iter(), self.now.candidate.iter());
        before.merge_join_by(now, Ord::cmp).filter_map(|which| match which {
            EitherOrBoth::Both(..) => None,
            EitherOrBoth::Left(&candidate) | EitherOrBoth::Right(&candidate) => Some(candidate),
        })
    }

    /// Notes the sizes of all contacts between grains.
    fn note_sizes(&mut self, scene: &Scene) {
        let size = |(&i, &j): (&u32, &u32)| scene.size_of_pair(i as usize, j as usize);
        self.coupling.size.clear();
        self.coupling.size.extend(self.i.iter().zip(&self.j).map(size));
    }

    pub(super) fn begin(&mut self, walls: usize, law: u32) {
        self.law = law;
        self.fault = None;
        self.tally = Tally::default();
        self.marks.clear();
        self.impacts.clear();
        self.wall_load.clear();
        self.wall_springs.clear();
        self.wall_load.resize(walls, (DVec3::ZERO, DVec3::ZERO));
    }

    /// Goes back to the contacts of the step before, as if those of this step had not been looked for. `bodies` tells the
    /// bodies of a candidate.
    pub(crate) fn take_back(&mut self, candidates: usize, bodies: impl Fn(usize) -> (u32, u32)) {
        if !std::mem::take(&mut self.is_renewed) {
            return;
        }
        std::mem::swap(&mut self.now, &mut *self.before);
        self.coupling.size.clear();
        self.shift.clear();
        self.i.clear();
        self.j.clear();
        for c in 0..candidates {
            let (i, j) = bodies(c);
            for _ in self.now.range(c) {
                self.i.push(i);
                self.j.push(j);
            }
        }
    }

    pub(super) fn watch_overlap(&mut self, scene: &Scene, grain: usize, share: f64, partner: impl Fn() -> String) {
        if (share.is_nan() || share > scene.max_overlap) && self.fault.is_none() {
            self.fault = Some(Box::new(Fault::Overlap {
                step: scene.step,
                id: scene.grains.id[grain],
                position: scene.grains.position[grain],
                partner: partner(),
                overlap_share: share,
                allowed: scene.max_overlap,
            }));
        }
    }

    /// Books the energy that the springs of a contact of the step before still held when it ended.
    pub(super) fn book_end(&mut self, old: usize, scene: &Scene) {
        let history = self.before.history_of(old, scene.stride);
        self.tally.book_end(history, scene.materials.law(self.law));
    }
}

impl Tally {
    /// Books the energy that the springs of a contact still held when it ended.
    pub(super) fn book_end(&mut self, history: &[f64], law: &PairLaw) {
        if !history.is_empty() {
            let (tangential, rolling) = super::laws::spring_energies(law, history);
            self.friction += tangential;
            self.rolling += rolling;
        }
    }
}
