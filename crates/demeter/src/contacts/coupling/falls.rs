//! Forces that fall as surfaces come nearer.
//!
//! Where a pull begins with a jump, it may draw back the very bulge that touched: with no force the surfaces overlap, with all of the
//! pull they do not. In between is a share of the pull that leaves them just touching, as a law that is a mean over the step knows it: the
//! contact acts for a share of the step. An iteration that goes from force to displacement and back never meets it, as the force changes
//! by all of the pull over next to no overlap. So such a contact gives way: while its force `F` is sought the surfaces are taken to move
//! by `give (F - F_tried)`, and `F = f(overlap + D + give (F - F_tried))` has one solution, however steeply `f` falls. Where the iteration
//! ends `F` is `F_tried`, whatever the give.

use super::displaced::{ChunkPlace, Scale};
use super::{Fall, Scratch};
use crate::contacts::{ContactChunk, Scene, Span};
use demeter_physics::contact::PairSize;
use demeter_physics::contact::normal::{Normal, NormalVisitor};
use demeter_physics::integrator::Integrator;
use std::ops::Range;

/// The give foreseen over that seen from one iteration to the next: others have not answered in full by then, and what they answer comes an
/// iteration late.
const CAUTION: f64 = 4.0;

/// A contact whose deviation is below this share of the one before comes closer to its solution as it is.
const SHRINKS: f64 = 0.5;

/// Halvings of the overlaps in which a force is sought: a pull may begin within an overlap that is that much smaller than what the
/// surfaces move by.
const HALVINGS: usize = 100;

/// How many contacts of a chunk give way from now on, and how many more than before.
#[derive(Default)]
pub(crate) struct Watched {
    pub(crate) found: u64,
    pub(crate) more: u64,
}

impl ContactChunk {
    /// Notes the pulls that become larger as the surfaces come nearer, if they come no closer to a solution as they are or it is `late`,
    /// and lets those noted before give way more where `once_more` tells so.
    pub(crate) fn watch_falls(&mut self, once_more: bool, late: bool) -> Watched {
        let Scratch {
            former,
            falls,
            answer,
            trial,
            overlap,
            ..
        } = &mut *self.coupling;
        let is_begun = former.len() == answer.len();
        former.resize(answer.len(), [0.0; 3]);
        let mut watched = Watched::default();
        for (k, before) in former.iter_mut().enumerate() {
            let deviation = (answer[k] - trial[k]).abs();
            let [rise, way] = [answer[k] - before[0], overlap[k] - before[1]];
            let pulls = answer[k].min(before[0]) < 0.0;
            let comes_closer = !late && deviation < SHRINKS * before[2];
            *before = [answer[k], overlap[k], deviation];
            if !(is_begun && pulls) || comes_closer {
                continue;
            }
            if rise * way < 0.0 && falls.get(k).is_none_or(|fall| fall.slope == 0.0) {
                falls.resize(answer.len(), Fall::default());
                falls[k] = Fall {
                    slope: (way / rise).abs(),
                    caution: CAUTION,
                    overlap: overlap[k],
                    plain: answer[k],
                };
                watched.found += 1;
            } else if once_more && let Some(fall) = falls.get_mut(k) {
                fall.caution *= 2.0;
                watched.more += 1;
            }
        }
        watched
    }

    /// Takes the answers of contacts that give way.
    pub(super) fn yield_at_falls(&mut self, run: Range<usize>, at: ChunkPlace, scene: &Scene, scale: Scale<'_>) {
        for k in run {
            let largest = self.largest_near(k, at, scale);
            let Scratch {
                falls,
                undisplaced,
                overlap,
                answer,
                trial,
                size,
                rate,
                memory,
                ..
            } = &mut *self.coupling;
            let (fall, overlap) = (&mut falls[k], overlap[k]);
            if fall.slope == 0.0 {
                continue;
            }
            (fall.plain, fall.overlap) = (answer[k], overlap);
            // a contact does not act on itself by way of others more than others act on it
            let by_others = (overlap - undisplaced[k]).abs() / largest;
            let give = fall.caution * fall.slope.min(by_others);
            if !(give > 0.0 && give.is_finite()) {
                continue;
            }
            let given = scene.materials.law(self.law).normal.visit(GivesWay {
                span: scene.span,
                integrator: scene.integrator,
                size: size[k],
                rate: rate[k],
                overlap,
                history: &self.now.history[k * scene.stride..(k + 1) * scene.stride],
                memory,
                give,
                tried: trial[k],
                answer: answer[k],
            });
            (answer[k], fall.overlap) = given;
        }
    }

    /// How far a contact that gives way is from its solution: not farther than it were if it did not, and else as far as the surfaces are from
    /// where the law is asked, as a share of what others displace them by.
    pub(super) fn share_at_fall(&self, k: usize, fall: &Fall, share: f64, largest: f64) -> f64 {
        let coupling = &self.coupling;
        let off = (fall.overlap - coupling.overlap[k]).abs();
        if off == 0.0 {
            return share;
        }
        let displaced = (coupling.overlap[k] - coupling.undisplaced[k]).abs();
        let without = (fall.plain - coupling.trial[k]).abs() / largest;
        without.min(share.max(off / displaced))
    }
}

impl Scratch {
    pub(super) fn forget_falls(&mut self) {
        self.former.clear();
        self.falls.clear();
    }
}

/// A contact that gives way, with the answer to its overlap if it did not.
struct GivesWay<'a> {
    span: Span,
    integrator: Integrator,
    size: PairSize,
    rate: f64,
    overlap: f64,
    history: &'a [f64],
    memory: &'a mut Vec<f64>,
    give: f64,
    tried: f64,
    answer: f64,
}

impl NormalVisitor for GivesWay<'_> {
    /// The force [N], and the overlap at which the law answers with it [m].
    type Output = (f64, f64);

    fn visit<L: Normal>(self, law: &L) -> (f64, f64) {
        let Self {
            overlap, give, tried, ..
        } = self;
        let remembered = law.history();
        self.memory.resize(remembered, 0.0);
        let mut force = |overlap: f64| {
            let input = (self.span).normal_input::<L, f64>(self.integrator, self.size, overlap, self.rate);
            self.memory.copy_from_slice(&self.history[..remembered]);
            law.respond(&input, self.memory).elastic
        };
        // the force that makes the surfaces give way so far
        let needed = |at: f64| tried + (at - overlap) / give;
        let lacks = |force: f64, at: f64| force - needed(at);
        let mut nearer = (overlap, self.answer);
        let end = overlap + give * (self.answer - tried);
        let mut farther = (end, force(end));
        if lacks(nearer.1, nearer.0) * lacks(farther.1, farther.0) > 0.0 {
            return (self.answer, overlap);
        }
        if nearer.0 < farther.0 {
            std::mem::swap(&mut nearer, &mut farther);
        }
        for _ in 0..HALVINGS {
            let middle = 0.5 * (nearer.0 + farther.0);
            let between = (middle, force(middle));
            if lacks(between.1, middle) > 0.0 {
                farther = between;
            } else {
                nearer = between;
            }
        }
        // the law is asked at one of the two, where none answers with the force itself at the one that comes closer
        let off = |(at, force): (f64, f64)| lacks(force, at).abs();
        let at = if off(nearer) < off(farther) {
            nearer.0
        } else {
            farther.0
        };
        (needed(at), at)
    }
}
