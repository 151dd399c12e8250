#![doc = include_str!("jkr.md")]

use super::dashpot::Dashpot;
use super::jkr_curve::{JkrCurve, adhesion_length_root, of_mean_root};
use super::path::{Branched, KINKS, Point, follow};
use super::{Normal, NormalInput, NormalResponse};
use crate::contact::{MaterialPair, PairSize};
use crate::dimension::Dimension;
use crate::lanes::Lanes;
use crate::parameters::{Alternatives, ParameterError, ParameterInfo, Range, Values};
use crate::params;

params! {
    /// Parameters of the adhesive elastic contact of Johnson, Kendall and Roberts.
    pub struct JkrParameters {
        work_of_adhesion: SURFACE_ENERGY, required 0.05, in Range::NOT_NEGATIVE,
            "Energy per area that it takes to part the surfaces, twice the surface energy of equal ones";
        alpha: NONE, optional 0.1, in Range::NOT_NEGATIVE, "Coefficient of the dashpot; none without it";
        restitution: NONE, optional 0.5, in Range::POSITIVE_SHARE,
            "Coefficient of restitution of an impact at `impact_speed`, adhesion included";
        impact_speed: VELOCITY, optional 1.0, in Range::POSITIVE, "Speed at which `restitution` is wanted";
    }
}

/// The contact of Johnson, Kendall and Roberts bound to a pair of materials.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jkr {
    /// Effective modulus [Pa].
    modulus: f64,
    work_of_adhesion: f64,
    /// `sqrt(2 pi w/E)` [m^(1/2)].
    adhesion: f64,
    pub(super) dashpot: Dashpot,
}

/// Whether the surfaces hold each other, and the curve on which they do.
#[derive(Clone, Copy, Debug)]
pub struct JkrState<L: Lanes> {
    curve: JkrCurve<L>,
    touched: L::Mask,
}

impl Jkr {
    #[inline(always)]
    fn curve<L: Lanes>(&self, size: PairSize<L>) -> JkrCurve<L> {
        JkrCurve::new(self.modulus, size.radius, self.adhesion, L::splat(0.0))
    }

    #[inline(always)]
    fn state<L: Lanes>(&self, size: PairSize<L>, history: &[L]) -> JkrState<L> {
        JkrState {
            curve: self.curve(size),
            touched: history[0].gt(L::splat(0.0)),
        }
    }

    fn with(&self, dashpot: Dashpot) -> Self {
        Self { dashpot, ..*self }
    }
}

impl<L: Lanes> Branched<L> for Jkr {
    type State = JkrState<L>;
    const PLACES: usize = 1;

    #[inline(always)]
    fn advance(&self, _size: PairSize<L>, state: JkrState<L>, to: L) -> JkrState<L> {
        JkrState {
            touched: to.ge(state.end()),
            ..state
        }
    }

    /// The damping is that of a coefficient 1, for an effective mass and a Hertzian stiffness of 1.
    #[inline(always)]
    fn point(&self, size: PairSize<L>, state: JkrState<L>, overlap: L, _approaching: L::Mask) -> Point<L> {
        let root = state.curve.root(overlap);
        Point {
            elastic: state.curve.force(root).keep(state.touched),
            damping: root.keep(state.touched),
            adhesion: (size.radius * (3.0 * std::f64::consts::PI * self.work_of_adhesion)).keep(state.touched),
        }
    }

    #[inline(always)]
    fn stored(&self, _size: PairSize<L>, state: JkrState<L>, overlap: L) -> L {
        state.curve.energy(state.curve.root(overlap)).keep(state.touched)
    }

    #[inline(always)]
    fn kinks(&self, _size: PairSize<L>, state: JkrState<L>) -> [L; KINKS] {
        [state.end(); KINKS]
    }

    #[inline(always)]
    fn select(mask: L::Mask, yes: JkrState<L>, no: JkrState<L>) -> JkrState<L> {
        JkrState {
            touched: (mask & yes.touched) | (!mask & no.touched),
            ..no
        }
    }

    #[inline(always)]
    fn differ(one: JkrState<L>, other: JkrState<L>) -> L::Mask {
        (one.touched & !other.touched) | (!one.touched & other.touched)
    }
}

impl<L: Lanes> JkrState<L> {
    /// Overlap at which the surfaces part, or touch [m].
    #[inline(always)]
    fn end(&self) -> L {
        self.curve.tear_off().keep(self.touched)
    }
}

impl Normal for Jkr {
    const NAME: &'static str = "jkr";
    const SUMMARY: &'static str =
        "adhesive elastic contact of Johnson, Kendall and Roberts (soft, sticky, large grains)";
    const DOC: &'static str = include_str!("jkr.md");
    const PARAMETERS: &'static [ParameterInfo] = JkrParameters::TABLE;
    const ALTERNATIVES: &'static [Alternatives] = &[Alternatives {
        of: &["restitution", "alpha"],
        with: &["impact_speed"],
    }];
    /// 1 while the surfaces hold each other; the dashpot's own.
    const HISTORY: &'static [Dimension] = &[Dimension::NONE, Dimension::NONE];
    const LASTING: usize = 1;
    const FOLLOWS_KINKS: bool = true;

    fn new(values: &Values, pair: &MaterialPair) -> Result<Self, Vec<ParameterError>> {
        let p = JkrParameters::from_values(values)?;
        let modulus = pair.effective_modulus();
        Ok(Self {
            modulus,
            work_of_adhesion: p.work_of_adhesion,
            adhesion: adhesion_length_root(p.work_of_adhesion, modulus),
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
            .coefficient(input.size, &mut history[1..], |d| self.with(d));
        let (response, next) = follow(self, input, state);
        history[0] = L::splat(1.0).keep(next.touched);
        of_mean_root(response, input.size, alpha, self.modulus)
    }

    #[inline(always)]
    fn energy(&self, size: PairSize, overlap: f64, history: &[f64]) -> f64 {
        self.stored(size, self.state(size, history), overlap)
    }

    #[inline(always)]
    fn stiffness(&self, size: PairSize, overlap: f64, history: &[f64]) -> f64 {
        self.stiffness_wide(size, overlap, history)
    }

    #[inline(always)]
    fn stiffness_wide<L: Lanes>(&self, size: PairSize<L>, overlap: L, history: &[L]) -> L {
        let state = self.advance(size, self.state(size, history), overlap);
        state.curve.stiffness(state.curve.root(overlap)).keep(state.touched)
    }

    fn collision_time(&self, size: PairSize, overlap: f64) -> f64 {
        self.curve(size).collision_time(overlap, size.mass)
    }

    #[inline(always)]
    fn history(&self) -> usize {
        1 + self.dashpot.history()
    }

    fn reach(&self, size: PairSize, history: &[f64]) -> f64 {
        if history[0] == 0.0 {
            0.0
        } else {
            self.curve(size).tear_off_distance()
        }
    }

    #[inline(always)]
    fn largest_reach(&self, size: PairSize) -> f64 {
        self.curve(size).tear_off_distance()
    }

    fn check(&self, size: PairSize) -> Result<(), String> {
        self.dashpot.check(size, |d| self.with(d))
    }
}

#[cfg(test)]
mod tests;
