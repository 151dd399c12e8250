//! The laws of all contacts of a chunk: those between grains, which meet now or whose geometry is known, and those with walls.

use super::bodies::{Bodies, Ends, Lists};
use super::impacts;
use super::kinematics::{Approach, Known, Source};
use super::respond::{Answers, Respond};
use super::sum::{Across, AddAtOnce, Adder, Sink};
use super::together::ask;
use super::{ContactChunk, Scene};
use glam::DVec3;

/// Contacts whose engagement one word tells.
pub(super) const WORD: usize = 64;

impl ContactChunk {
    /// Finds which contacts between grains act in this step, and evaluates their laws.
    pub(crate) fn meet_pairs(&mut self, scene: &Scene, adder: &mut Adder) {
        let mut engaged = std::mem::take(&mut self.engaged);
        engaged.resize(self.len().div_ceil(WORD), 0);
        let before = scene.tells_impacts.then(|| engaged.clone());
        let (i, j, shift) = self.take_bodies();
        let lists = (&i[..], &j[..], &shift[..]);
        let ends = Ends::of(lists);
        let approach = Approach::of(Bodies::of(lists, &ends), &mut engaged, scene);
        let too_deep = self.collect(adder, lists, scene, approach);
        if let Some(before) = before {
            let begun = impacts::begun(&before, &engaged);
            let approach = Approach::of(Bodies::of(lists, &ends), &mut engaged, scene);
            impacts::tell(approach, &begun, (&i, &j), false, scene, &mut self.impacts);
        }
        (self.i, self.j, self.shift) = (i, j, shift);
        self.engaged = engaged;
        if let Some((k, overlap)) = too_deep {
            self.note_overlap(k, overlap, scene);
        }
    }

    /// Evaluates the laws of all contacts between grains whose geometry is known.
    pub(crate) fn evaluate_pairs(&mut self, scene: &Scene, adder: &mut Adder) {
        let (i, j, shift) = self.take_bodies();
        let geometry = std::mem::take(&mut self.now.geometry);
        let lists = (&i[..], &j[..], &shift[..]);
        let ends = Ends::of(lists);
        let known = Known {
            contacts: &geometry,
            grains: scene.grains,
            bodies: Bodies::of(lists, &ends),
            shift_velocities: (scene.is_deforming()).then_some(scene.comm.shift_velocities()),
        };
        let begun = self.beginning(scene);
        impacts::tell(known, &begun, (&i, &j), false, scene, &mut self.impacts);
        self.collect(adder, lists, scene, known);
        (self.i, self.j, self.shift) = (i, j, shift);
        self.now.geometry = geometry;
    }

    /// The bodies of all contacts and the shifts between them, to be put back.
    pub(super) fn take_bodies(&mut self) -> (Vec<u32>, Vec<u32>, Vec<u8>) {
        let Self { i, j, shift, .. } = self;
        (std::mem::take(i), std::mem::take(j), std::mem::take(shift))
    }

    /// Evaluates the laws of all contacts and hands over what they do. Tells the first with too much overlap.
    fn collect(
        &mut self,
        adder: &mut Adder,
        (i, j, shift): Lists,
        scene: &Scene,
        source: impl Source,
    ) -> Option<(usize, f64)> {
        let across = scene.is_deforming().then_some(Across {
            shift,
            forces: [DVec3::ZERO; 3],
        });
        let mut sink = AddAtOnce { adder, i, j, across };
        let too_deep = self.evaluate(&mut sink, scene, source);
        if let Some(across) = sink.across {
            self.across = across.forces;
        }
        too_deep
    }

    /// Evaluates the laws of all contacts. Tells the first with too much overlap.
    pub(super) fn evaluate(
        &mut self,
        sink: &mut impl Sink,
        scene: &Scene,
        source: impl Source,
    ) -> Option<(usize, f64)> {
        let count = self.len();
        self.now.tangential.resize(count);
        if scene.resists_rolling {
            self.rolling.resize(count);
        }
        let mut elastic = std::mem::take(&mut self.elastic);
        if scene.is_coupled() {
            elastic.resize(count, 0.0);
        }
        let respond = Respond {
            source,
            sink,
            laws: (),
            law: scene.materials.law(self.law),
            span: scene.span,
            integrator: scene.integrator,
            answers: Answers {
                normal_force: &mut self.now.normal_force,
                tangential: &mut self.now.tangential,
                history: &mut self.now.history,
                stride: scene.stride,
                torques: &mut self.rolling,
                losses: &mut self.losses,
                elastic: &mut elastic,
            },
        };
        let (lost, too_deep) = ask(scene.instructions, respond);
        self.tally.add(&lost);
        if scene.is_coupled() {
            self.remember_coupling(&elastic, scene);
        }
        self.elastic = elastic;
        too_deep
    }
}
