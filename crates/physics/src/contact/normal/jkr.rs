#![doc = include_str!("jkr.md")]

use super::dashpot::Dashpot;
use super::jkr_curve::{JkrCurve, adhesion_length_root};
use super::path::{Branched, KINKS, Point, follow};
use super::{Normal, NormalInput, NormalResponse};
use crate::contact::{MaterialPair, PairSize};
use crate::dimension::Dimension;
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
    dashpot: Dashpot,
}

/// Whether the surfaces hold each other, and the curve on which they do.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JkrState {
    curve: JkrCurve,
    touched: bool,
}

impl Jkr {
    fn curve(&self, size: PairSize) -> JkrCurve {
        JkrCurve::new(self.modulus, size.radius, self.adhesion, 0.0)
    }

    fn state(&self, size: PairSize, history: &[f64]) -> JkrState {
        JkrState {
            curve: self.curve(size),
            touched: history[0] != 0.0,
        }
    }

    /// `alpha`, 0 where it is still to be found.
    fn alpha(&self) -> f64 {
        match self.dashpot {
            Dashpot::Coefficient(alpha) => alpha,
            Dashpot::Realised { .. } => 0.0,
        }
    }

    fn with(&self, dashpot: Dashpot) -> Self {
        Self { dashpot, ..*self }
    }
}

impl Branched for Jkr {
    type State = JkrState;

    fn advance(&self, _size: PairSize, state: JkrState, to: f64) -> JkrState {
        let touched = if state.touched {
            to >= state.curve.tear_off()
        } else {
            to >= 0.0
        };
        JkrState { touched, ..state }
    }

    fn point(&self, size: PairSize, state: JkrState, overlap: f64, _approaching: bool) -> Point {
        if !state.touched {
            return Point::default();
        }
        let root = state.curve.root(overlap);
        Point {
            elastic: state.curve.force(root),
            damping: self.alpha() * (4.0 / 3.0 * self.modulus * size.mass).sqrt() * root,
            adhesion: 3.0 * std::f64::consts::PI * self.work_of_adhesion * size.radius,
        }
    }

    fn stored(&self, _size: PairSize, state: JkrState, overlap: f64) -> f64 {
        if state.touched {
            state.curve.energy(state.curve.root(overlap))
        } else {
            0.0
        }
    }

    fn kinks(&self, _size: PairSize, state: JkrState) -> [f64; KINKS] {
        let end = if state.touched { state.curve.tear_off() } else { 0.0 };
        [end, f64::NAN, f64::NAN, f64::NAN]
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

    fn respond(&self, input: &NormalInput, history: &mut [f64]) -> NormalResponse {
        let state = self.state(input.size, history);
        let alpha = self
            .dashpot
            .coefficient(input.size, &mut history[1..], |d| self.with(d));
        let law = self.with(Dashpot::Coefficient(alpha));
        let (response, next) = follow(&law, input, state);
        history[0] = f64::from(u8::from(next.touched));
        response
    }

    fn energy(&self, size: PairSize, overlap: f64, history: &[f64]) -> f64 {
        self.stored(size, self.state(size, history), overlap)
    }

    fn stiffness(&self, size: PairSize, overlap: f64, history: &[f64]) -> f64 {
        let state = self.advance(size, self.state(size, history), overlap);
        if state.touched {
            state.curve.stiffness(state.curve.root(overlap))
        } else {
            0.0
        }
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

    fn bearing_overlap(&self, size: PairSize, overlap: f64, history: &[f64]) -> f64 {
        let state = self.state(size, history);
        if !state.touched {
            return 0.0;
        }
        let root = state.curve.root(overlap);
        let contact_radius = root * root;
        contact_radius * contact_radius / size.radius
    }

    fn largest_reach(&self, size: PairSize) -> f64 {
        self.curve(size).tear_off_distance()
    }

    fn check(&self, size: PairSize) -> Result<(), String> {
        self.dashpot.check(size, |d| self.with(d))
    }
}

#[cfg(test)]
mod tests;
