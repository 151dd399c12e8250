#![doc = include_str!("thornton_ning.md")]

use super::dashpot::Dashpot;
use super::jkr_curve::{JkrCurve, adhesion_length_root, of_mean_root};
use super::path::{Branched, KINKS, Point, follow};
use super::{Normal, NormalInput, NormalResponse};
use crate::contact::{MaterialPair, PairSize};
use crate::dimension::Dimension;
use crate::lanes::{Lanes, Mask};
use crate::parameters::{Alternatives, ParameterError, ParameterInfo, Range, Values};
use crate::params;
use std::f64::consts::PI;

params! {
    /// Parameters of the adhesive elastic-plastic contact of Thornton and Ning.
    pub struct ThorntonNingParameters {
        yield_pressure: PRESSURE, required 1e9, in Range::POSITIVE,
            "Largest pressure that the contact can carry, about 1.6 to 2.8 times the yield stress";
        work_of_adhesion: SURFACE_ENERGY, optional 0.05, in Range::NOT_NEGATIVE,
            "Energy per area that it takes to part the surfaces, twice the surface energy of equal ones; none without it";
        alpha: NONE, optional 0.1, in Range::NOT_NEGATIVE, "Coefficient of the dashpot; none without it";
        restitution: NONE, optional 0.3, in Range::POSITIVE_SHARE,
            "Coefficient of restitution of an impact at `impact_speed`, adhesion and yield included";
        impact_speed: VELOCITY, optional 1.0, in Range::POSITIVE, "Speed at which `restitution` is wanted";
    }
}

/// The contact of Thornton and Ning bound to a pair of materials.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ThorntonNing {
    /// Effective modulus [Pa].
    modulus: f64,
    yield_pressure: f64,
    work_of_adhesion: f64,
    /// `sqrt(2 pi w/E)` [m^(1/2)].
    adhesion: f64,
    pub(super) dashpot: Dashpot,
}

/// What a contact remembers, with what follows from it.
#[derive(Clone, Copy, Debug)]
pub struct ThorntonNingState<L: Lanes> {
    /// Curve of the undeformed sphere.
    virgin: JkrCurve<L>,
    /// Root of the contact radius at yield [m^(1/2)].
    yield_root: L,
    /// Root of the largest contact radius after yield; that at yield before [m^(1/2)].
    deepest: L,
    /// Overlap at `deepest` [m].
    top: L,
    /// Curve of unloading and reloading.
    curve: JkrCurve<L>,
    touched: L::Mask,
}

impl ThorntonNing {
    #[inline(always)]
    fn virgin<L: Lanes>(&self, size: PairSize<L>) -> JkrCurve<L> {
        JkrCurve::new(self.modulus, size.radius, self.adhesion, L::splat(0.0))
    }

    /// Root of the contact radius at which the pressure in the middle reaches the limit,
    /// `E/(pi R) (2 z^2 - 4 z_c^3/z) = p_y`: the root of `z^3 - z_0^2 z - 2 z_c^3`, which `sqrt(z_0^2 + 2^(2/3) z_c^2)` exceeds
    /// by at most 8 %; three of Halley's steps leave rounding.
    #[inline(always)]
    fn yield_root<L: Lanes>(&self, virgin: &JkrCurve<L>) -> L {
        let square = virgin.radius() * (0.5 * PI * self.yield_pressure / self.modulus);
        let least = virgin.least_root();
        let cube = least * least * least * 2.0;
        let mut z = (square + least * least * CUBE_ROOT_OF_FOUR).sqrt();
        for _ in 0..HALLEY_STEPS {
            let value = z * (z * z - square) - cube;
            let slope = z * z * 3.0 - square;
            z = z - value * slope / (slope * slope - value * z * 3.0);
        }
        z
    }

    /// Force on the plastic line [N]: the pressure is cut at the limit.
    #[inline(always)]
    fn plastic_force<L: Lanes>(&self, virgin: &JkrCurve<L>, yield_root: L, root: L) -> L {
        let square = yield_root * yield_root;
        let squares = root * root + square;
        let beyond = (root - yield_root) * (root + yield_root) * squares;
        virgin.force(yield_root) + beyond * (PI * self.yield_pressure)
            - square * (root - yield_root) * (2.0 * self.modulus * self.adhesion)
    }

    /// The state of contacts whose radius has grown to the square of `root`.
    #[inline(always)]
    fn yielded<L: Lanes>(&self, before: ThorntonNingState<L>, root: L) -> ThorntonNingState<L> {
        let ThorntonNingState { virgin, yield_root, .. } = before;
        let cube = root * root * root;
        let force = self.plastic_force(&virgin, yield_root, root);
        let elastic = force + cube * (2.0 * self.modulus * self.adhesion);
        let radius = (cube * cube * (4.0 / 3.0 * self.modulus) / elastic).max(virgin.radius());
        let origin = cube * root * (L::splat(1.0) / virgin.radius() - L::splat(1.0) / radius);
        ThorntonNingState {
            deepest: root,
            top: virgin.overlap(root),
            curve: JkrCurve::new(self.modulus, radius, self.adhesion, origin),
            ..before
        }
    }

    #[inline(always)]
    fn state<L: Lanes>(&self, size: PairSize<L>, history: &[L]) -> ThorntonNingState<L> {
        let zero = L::splat(0.0);
        let virgin = self.virgin(size);
        let yield_root = self.yield_root(&virgin);
        let fresh = ThorntonNingState {
            virgin,
            yield_root,
            deepest: yield_root,
            top: virgin.overlap(yield_root),
            curve: virgin,
            touched: history[1].gt(zero),
        };
        let has_yielded = history[0].gt(zero);
        if has_yielded.any() {
            let before = self.yielded(fresh, history[0].sqrt().max(yield_root));
            Self::select(has_yielded, before, fresh)
        } else {
            fresh
        }
    }

    fn with(&self, dashpot: Dashpot) -> Self {
        Self { dashpot, ..*self }
    }
}

impl<L: Lanes> ThorntonNingState<L> {
    /// Overlap at which the surfaces part; or, apart, touch: at the bottom of the dent, or where it would deepen [m].
    #[inline(always)]
    fn end(&self) -> L {
        let touch = self.curve.origin().min(self.top).keep(self.deepest.gt(self.yield_root));
        L::select(self.touched, self.curve.tear_off(), touch)
    }
}

/// `2^(2/3)`.
const CUBE_ROOT_OF_FOUR: f64 = 1.587_401_051_968_199_4;

/// Steps of Halley's method, each of which leaves the cube of the error.
const HALLEY_STEPS: usize = 3;

impl<L: Lanes> Branched<L> for ThorntonNing {
    type State = ThorntonNingState<L>;
    const PLACES: usize = 2;

    #[inline(always)]
    fn advance(&self, _size: PairSize<L>, state: ThorntonNingState<L>, to: L) -> ThorntonNingState<L> {
        let touched = to.ge(state.end());
        let state = ThorntonNingState { touched, ..state };
        let beyond = touched & to.gt(state.top);
        if beyond.any() {
            let root = state.virgin.root(to);
            let deeper = beyond & root.gt(state.deepest);
            Self::select(deeper, self.yielded(state, root), state)
        } else {
            state
        }
    }

    /// The damping is that of a coefficient 1, for an effective mass and a Hertzian stiffness of 1.
    #[inline(always)]
    fn point(&self, _size: PairSize<L>, state: ThorntonNingState<L>, overlap: L, _approaching: L::Mask) -> Point<L> {
        // on the plastic line the curve of unloading begins at this very place
        let root = state.curve.root(overlap);
        Point {
            elastic: state.curve.force(root).keep(state.touched),
            damping: root.keep(state.touched),
            adhesion: (state.curve.radius() * (3.0 * PI * self.work_of_adhesion)).keep(state.touched),
        }
    }

    /// On the plastic line the force is known without the curve of unloading.
    #[inline(always)]
    fn between(
        &self,
        size: PairSize<L>,
        (from, to): (ThorntonNingState<L>, ThorntonNingState<L>),
        overlap: L,
        approaching: L::Mask,
    ) -> Point<L> {
        let touched = overlap.ge(from.end());
        let state = ThorntonNingState { touched, ..from };
        let plain = self.point(size, state, overlap, approaching);
        let yields = touched & overlap.gt(from.top) & to.deepest.gt(from.deepest);
        if yields.any() {
            let root = from.virgin.root(overlap);
            let radius = (from.curve.radius() + to.curve.radius()) * 0.5;
            Point {
                elastic: L::select(
                    yields,
                    self.plastic_force(&from.virgin, from.yield_root, root),
                    plain.elastic,
                ),
                damping: L::select(yields, root, plain.damping),
                adhesion: L::select(yields, radius * (3.0 * PI * self.work_of_adhesion), plain.adhesion),
            }
        } else {
            plain
        }
    }

    #[inline(always)]
    fn stored(&self, _size: PairSize<L>, state: ThorntonNingState<L>, overlap: L) -> L {
        state.curve.energy(state.curve.root(overlap)).keep(state.touched)
    }

    #[inline(always)]
    fn kinks(&self, _size: PairSize<L>, state: ThorntonNingState<L>) -> [L; KINKS] {
        let (end, top) = (state.end(), state.top);
        [end, top, top, top]
    }

    #[inline(always)]
    fn select(mask: L::Mask, yes: ThorntonNingState<L>, no: ThorntonNingState<L>) -> ThorntonNingState<L> {
        ThorntonNingState {
            deepest: L::select(mask, yes.deepest, no.deepest),
            top: L::select(mask, yes.top, no.top),
            curve: JkrCurve::select(mask, yes.curve, no.curve),
            touched: (mask & yes.touched) | (!mask & no.touched),
            ..no
        }
    }

    #[inline(always)]
    fn differ(one: ThorntonNingState<L>, other: ThorntonNingState<L>) -> L::Mask {
        let touched = (one.touched & !other.touched) | (!one.touched & other.touched);
        touched | one.deepest.gt(other.deepest) | other.deepest.gt(one.deepest)
    }
}

impl Normal for ThorntonNing {
    const NAME: &'static str = "thornton-ning";
    const SUMMARY: &'static str = "adhesive elastic-plastic contact of Thornton and Ning: yield at a limiting pressure";
    const DOC: &'static str = include_str!("thornton_ning.md");
    const PARAMETERS: &'static [ParameterInfo] = ThorntonNingParameters::TABLE;
    const ALTERNATIVES: &'static [Alternatives] = &[Alternatives {
        of: &["restitution", "alpha"],
        with: &["impact_speed"],
    }];
    /// Largest contact radius after yield; 1 while the surfaces hold each other; the dashpot's own.
    const HISTORY: &'static [Dimension] = &[Dimension::LENGTH, Dimension::NONE, Dimension::NONE];
    const LASTING: usize = 2;
    const FOLLOWS_KINKS: bool = true;

    fn new(values: &Values, pair: &MaterialPair) -> Result<Self, Vec<ParameterError>> {
        let p = ThorntonNingParameters::from_values(values)?;
        let work_of_adhesion = p.work_of_adhesion.unwrap_or(0.0);
        let modulus = pair.effective_modulus();
        Ok(Self {
            modulus,
            yield_pressure: p.yield_pressure,
            work_of_adhesion,
            adhesion: adhesion_length_root(work_of_adhesion, modulus),
            dashpot: Dashpot::read("alpha", p.alpha, p.restitution, p.impact_speed)?,
        })
    }

    const WIDE: bool = true;

    #[inline(always)]
    fn respond(&self, input: &NormalInput, history: &mut [f64]) -> NormalResponse {
        self.respond_wide(input, history)
    }

    #[inline(always)]
    fn respond_wide<L: Lanes>(&self, input: &NormalInput<L>, history: &mut [L]) -> NormalResponse<L> {
        let state = self.state(input.size, history);
        let alpha = self
            .dashpot
            .coefficient(input.size, &mut history[2..], |d| self.with(d));
        let (response, next) = follow(self, input, state);
        let deeper = next.deepest.gt(state.deepest);
        history[0] = L::select(deeper, next.deepest * next.deepest, history[0]);
        history[1] = L::splat(1.0).keep(next.touched);
        of_mean_root(response, input.size, alpha, self.modulus)
    }

    fn energy(&self, size: PairSize, overlap: f64, history: &[f64]) -> f64 {
        self.stored(size, self.state(size, history), overlap)
    }

    fn stiffness(&self, size: PairSize, overlap: f64, history: &[f64]) -> f64 {
        self.stiffness_wide(size, overlap, history)
    }

    #[inline(always)]
    fn stiffness_wide<L: Lanes>(&self, size: PairSize<L>, overlap: L, history: &[L]) -> L {
        let state = self.advance(size, self.state(size, history), overlap);
        state.curve.stiffness(state.curve.root(overlap)).keep(state.touched)
    }

    fn collision_time(&self, size: PairSize, overlap: f64) -> f64 {
        // without yield, which makes a contact softer
        self.virgin(size).collision_time(overlap, size.mass)
    }

    #[inline(always)]
    fn history(&self) -> usize {
        2 + self.dashpot.history()
    }

    fn reach(&self, size: PairSize, history: &[f64]) -> f64 {
        -self.state(size, history).end()
    }

    fn largest_reach(&self, size: PairSize) -> f64 {
        // a dent moves the tear-off towards overlap by more than the flatter surface moves it away
        self.virgin(size).tear_off_distance()
    }

    fn check(&self, size: PairSize) -> Result<(), String> {
        self.dashpot.check(size, |d| self.with(d))
    }
}

#[cfg(test)]
mod tests;
