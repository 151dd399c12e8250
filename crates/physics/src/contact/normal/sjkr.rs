#![doc = include_str!("sjkr.md")]

use super::dashpot::Dashpot;
use super::hertz_spring::{HertzSpring, Power};
use super::window::mean_overlap;
use super::{Normal, NormalInput, NormalResponse};
use crate::contact::{MaterialPair, PairSize};
use crate::dimension::Dimension;
use crate::lanes::Lanes;
use crate::parameters::{Alternatives, ParameterError, ParameterInfo, Range, Values};
use crate::params;
use crate::restitution::duration::UNDAMPED;

params! {
    /// Parameters of the simplified JKR contact.
    pub struct SjkrParameters {
        cohesion_energy_density: PRESSURE, required 1e3, in Range::NOT_NEGATIVE,
            "Pull per contact area [Pa], which is J/m^3";
        area: NONE, choice ["lens", "hertz", "double-lens"], "Which contact area the pull acts on";
        alpha: NONE, optional 0.1, in Range::NOT_NEGATIVE, "Coefficient of the dashpot; none without it";
        restitution: NONE, optional 0.5, in Range::POSITIVE_SHARE,
            "Coefficient of restitution of an impact at `impact_speed`, adhesion included";
        impact_speed: VELOCITY, optional 1.0, in Range::POSITIVE, "Speed at which `restitution` is wanted";
    }
}

/// Contact areas over `R d`, in the order of the choice.
const AREAS: [f64; 3] = [
    2.0 * std::f64::consts::PI,
    std::f64::consts::PI,
    4.0 * std::f64::consts::PI,
];

/// The simplified JKR contact bound to a pair of materials.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sjkr {
    spring: HertzSpring,
    /// Pull per `R d` [Pa].
    pull: f64,
    pub(super) dashpot: Dashpot,
}

impl Sjkr {
    /// Pull per overlap [N/m].
    #[inline(always)]
    fn pull<L: Lanes>(&self, size: PairSize<L>) -> L {
        size.radius * self.pull
    }

    fn with(&self, dashpot: Dashpot) -> Self {
        Self { dashpot, ..*self }
    }
}

impl Normal for Sjkr {
    const NAME: &'static str = "sjkr";
    const SUMMARY: &'static str = "simplified JKR: Hertz with a pull proportional to the contact area";
    const DOC: &'static str = include_str!("sjkr.md");
    const PARAMETERS: &'static [ParameterInfo] = SjkrParameters::TABLE;
    const ALTERNATIVES: &'static [Alternatives] = &[Alternatives {
        of: &["restitution", "alpha"],
        with: &["impact_speed"],
    }];
    /// The dashpot's own.
    const HISTORY: &'static [Dimension] = &[Dimension::NONE];
    const LASTING: usize = 0;

    fn new(values: &Values, pair: &MaterialPair) -> Result<Self, Vec<ParameterError>> {
        let p = SjkrParameters::from_values(values)?;
        Ok(Self {
            spring: HertzSpring::of(pair),
            pull: p.cohesion_energy_density * AREAS[p.area.min(AREAS.len() - 1)],
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
        let alpha = self.dashpot.coefficient(input.size, history, |d| self.with(d));
        let adhesion = self.pull(input.size) * mean_overlap(input);
        NormalResponse {
            adhesion,
            ..NormalResponse::spring_dashpot(
                input,
                self.spring.mean(Power::Force, input) - adhesion,
                self.spring.mean(Power::Damping, input) * alpha,
            )
        }
    }

    #[inline(always)]
    fn energy(&self, size: PairSize, overlap: f64, _history: &[f64]) -> f64 {
        let d = overlap.max(0.0);
        self.spring.energy(size, d) - 0.5 * self.pull(size) * d * d
    }

    #[inline(always)]
    fn stiffness(&self, size: PairSize, overlap: f64, history: &[f64]) -> f64 {
        self.stiffness_wide(size, overlap, history)
    }

    #[inline(always)]
    fn stiffness_wide<L: Lanes>(&self, size: PairSize<L>, overlap: L, _history: &[L]) -> L {
        (self.spring.tangent(size, overlap) - self.pull(size)).keep(overlap.gt(L::splat(0.0)))
    }

    fn collision_time(&self, size: PairSize, overlap: f64) -> f64 {
        // that of Hertz, at least as deep as where both forces are equal
        let share = self.pull(size) / self.spring.stiffness(size);
        let overlap = overlap.max(share * share);
        UNDAMPED * self.spring.unit_of_time(size, self.spring.impact_speed(size, overlap))
    }

    #[inline(always)]
    fn history(&self) -> usize {
        self.dashpot.history()
    }

    fn check(&self, size: PairSize) -> Result<(), String> {
        self.dashpot.check(size, |d| self.with(d))
    }
}

#[cfg(test)]
mod tests;
