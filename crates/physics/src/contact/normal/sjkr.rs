#![doc = include_str!("sjkr.md")]

use super::dashpot::Dashpot;
use super::window::{mean_overlap, mean_quarter, mean_three_halves};
use super::{Normal, NormalInput, NormalResponse};
use crate::contact::{MaterialPair, PairSize};
use crate::dimension::Dimension;
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
    /// `4/3 E` [Pa].
    modulus: f64,
    /// Pull per `R d` [Pa].
    pull: f64,
    dashpot: Dashpot,
}

impl Sjkr {
    /// `K = 4/3 E sqrt(R)` [N/m^(3/2)].
    #[inline(always)]
    fn hertz_stiffness(&self, size: PairSize) -> f64 {
        self.modulus * size.radius.sqrt()
    }

    /// Pull per overlap [N/m].
    #[inline(always)]
    fn pull(&self, size: PairSize) -> f64 {
        self.pull * size.radius
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

    fn new(values: &Values, pair: &MaterialPair) -> Result<Self, Vec<ParameterError>> {
        let p = SjkrParameters::from_values(values)?;
        Ok(Self {
            modulus: 4.0 / 3.0 * pair.effective_modulus(),
            pull: p.cohesion_energy_density * AREAS[p.area.min(AREAS.len() - 1)],
            dashpot: Dashpot::read("alpha", p.alpha, p.restitution, p.impact_speed)?,
        })
    }

    #[inline(always)]
    fn respond(&self, input: &NormalInput, history: &mut [f64]) -> NormalResponse {
        let k = self.hertz_stiffness(input.size);
        let alpha = self.dashpot.coefficient(input.size, history, |d| self.with(d));
        let adhesion = self.pull(input.size) * mean_overlap(input);
        let mut response = NormalResponse::viscoelastic(
            k * mean_three_halves(input) - adhesion,
            alpha * (input.size.mass * k).sqrt() * mean_quarter(input),
        );
        response.adhesion = adhesion;
        response
    }

    #[inline(always)]
    fn energy(&self, size: PairSize, overlap: f64, _history: &[f64]) -> f64 {
        let d = overlap.max(0.0);
        d * d * (0.4 * self.hertz_stiffness(size) * d.sqrt() - 0.5 * self.pull(size))
    }

    #[inline(always)]
    fn stiffness(&self, size: PairSize, overlap: f64, _history: &[f64]) -> f64 {
        if overlap > 0.0 {
            1.5 * self.hertz_stiffness(size) * overlap.sqrt() - self.pull(size)
        } else {
            0.0
        }
    }

    fn collision_time(&self, size: PairSize, overlap: f64) -> f64 {
        // that of Hertz, at least as deep as where both forces are equal
        let k = self.hertz_stiffness(size);
        let ratio = size.mass / k;
        let share = self.pull(size) / k;
        let overlap = overlap.max(share * share);
        let v0 = (0.8 / ratio * overlap * overlap * overlap.sqrt()).sqrt();
        UNDAMPED * libm::pow(ratio, 0.4) * libm::pow(v0, -0.2)
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
