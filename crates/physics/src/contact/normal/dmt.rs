#![doc = include_str!("dmt.md")]

use super::dashpot::Dashpot;
use super::window::{contact_share, mean_quarter, mean_three_halves};
use super::{Normal, NormalInput, NormalResponse};
use crate::contact::{MaterialPair, PairSize};
use crate::dimension::Dimension;
use crate::parameters::{Alternatives, ParameterError, ParameterInfo, Range, Values};
use crate::params;
use crate::restitution::duration::UNDAMPED;

params! {
    /// Parameters of the adhesive elastic contact of Derjaguin, Muller and Toporov.
    pub struct DmtParameters {
        work_of_adhesion: SURFACE_ENERGY, required 0.05, in Range::NOT_NEGATIVE,
            "Energy per area that it takes to part the surfaces, twice the surface energy of equal ones";
        separation: LENGTH, optional 0.165e-9, in Range::POSITIVE,
            "Distance of surfaces in contact; with it they attract by van der Waals across a gap, too";
        cutoff: LENGTH, optional 16.5e-9, in Range::POSITIVE,
            "Gap at which the tail is cut off; 100 separations unless told";
        alpha: NONE, optional 0.1, in Range::NOT_NEGATIVE, "Coefficient of the dashpot; none without it";
        restitution: NONE, optional 0.5, in Range::POSITIVE_SHARE,
            "Coefficient of restitution of an impact at `impact_speed`, adhesion included";
        impact_speed: VELOCITY, optional 1.0, in Range::POSITIVE, "Speed at which `restitution` is wanted";
    }
}

/// Gap at which the tail is cut off unless told, in separations.
const CUTOFF: f64 = 100.0;

/// Attraction across a gap: `F_c (z/(z + g))^2` to the cut-off.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Tail {
    /// Distance of surfaces in contact [m].
    separation: f64,
    /// Gap beyond which nothing acts [m].
    cutoff: f64,
}

/// The window is wide where it reaches this share of the distance of the surfaces.
const WIDE: f64 = 0.01;

impl Tail {
    /// Energy that the tail gives on the way from a gap to contact, as share of the force in contact [m].
    fn depth(&self, gap: f64) -> f64 {
        let gap = gap.clamp(0.0, self.cutoff);
        self.separation * gap / (self.separation + gap)
    }

    /// Mean over the window of the force in the gap, as share of that in contact.
    fn mean(&self, input: &NormalInput) -> f64 {
        let (gap, h) = (-input.overlap, input.half_window);
        let distance = self.separation + gap;
        let near_an_end = gap.abs() <= h || (gap - self.cutoff).abs() <= h;
        let wide = near_an_end || (h > WIDE * distance && gap > 0.0);
        if wide && h > 0.0 {
            return (self.depth(gap + h) - self.depth(gap - h)) / (2.0 * h);
        }
        if gap > 0.0 && gap < self.cutoff {
            let (share, width) = (self.separation / distance, h / distance);
            // f + f'' h^2/6 with f = (z/(z + g))^2
            share * share * (1.0 + width * width)
        } else {
            0.0
        }
    }
}

/// The contact of Derjaguin, Muller and Toporov bound to a pair of materials.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dmt {
    /// `4/3 E` [Pa].
    modulus: f64,
    work_of_adhesion: f64,
    tail: Option<Tail>,
    dashpot: Dashpot,
}

impl Dmt {
    /// `K = 4/3 E sqrt(R)` [N/m^(3/2)].
    #[inline(always)]
    fn hertz_stiffness(&self, size: PairSize) -> f64 {
        self.modulus * size.radius.sqrt()
    }

    /// `2 pi w R` [N].
    #[inline(always)]
    fn pull_off(&self, size: PairSize) -> f64 {
        2.0 * std::f64::consts::PI * self.work_of_adhesion * size.radius
    }

    fn with(&self, dashpot: Dashpot) -> Self {
        Self { dashpot, ..*self }
    }
}

impl Normal for Dmt {
    const NAME: &'static str = "dmt";
    const SUMMARY: &'static str = "adhesive elastic contact of Derjaguin, Muller and Toporov (hard, small grains)";
    const DOC: &'static str = include_str!("dmt.md");
    const PARAMETERS: &'static [ParameterInfo] = DmtParameters::TABLE;
    const ALTERNATIVES: &'static [Alternatives] = &[Alternatives {
        of: &["restitution", "alpha"],
        with: &["impact_speed"],
    }];
    /// The dashpot's own.
    const HISTORY: &'static [Dimension] = &[Dimension::NONE];

    fn new(values: &Values, pair: &MaterialPair) -> Result<Self, Vec<ParameterError>> {
        let p = DmtParameters::from_values(values)?;
        if p.cutoff.is_some() && p.separation.is_none() {
            let message =
                "`cutoff` goes with `separation`, which is missing: without it there is no attraction across a gap";
            return Err(ParameterError::together("cutoff", message));
        }
        let tail = p.separation.map(|separation| Tail {
            separation,
            cutoff: p.cutoff.unwrap_or(CUTOFF * separation),
        });
        Ok(Self {
            modulus: 4.0 / 3.0 * pair.effective_modulus(),
            work_of_adhesion: p.work_of_adhesion,
            tail,
            dashpot: Dashpot::read("alpha", p.alpha, p.restitution, p.impact_speed)?,
        })
    }

    #[inline(always)]
    fn respond(&self, input: &NormalInput, history: &mut [f64]) -> NormalResponse {
        let (k, pull_off) = (self.hertz_stiffness(input.size), self.pull_off(input.size));
        let alpha = self.dashpot.coefficient(input.size, history, |d| self.with(d));
        let adhesion = pull_off * contact_share(input);
        let across = self.tail.map_or(0.0, |tail| pull_off * tail.mean(input));
        let mut response = NormalResponse::viscoelastic(
            k * mean_three_halves(input) - adhesion - across,
            alpha * (input.size.mass * k).sqrt() * mean_quarter(input),
        );
        response.adhesion = adhesion;
        response
    }

    #[inline(always)]
    fn energy(&self, size: PairSize, overlap: f64, _history: &[f64]) -> f64 {
        let d = overlap.max(0.0);
        let across = self
            .tail
            .map_or(0.0, |tail| tail.depth(tail.cutoff) - tail.depth(-overlap));
        0.4 * self.hertz_stiffness(size) * d * d * d.sqrt() - self.pull_off(size) * (d + across)
    }

    #[inline(always)]
    fn stiffness(&self, size: PairSize, overlap: f64, _history: &[f64]) -> f64 {
        match self.tail {
            Some(tail) if overlap < 0.0 && -overlap < tail.cutoff => {
                let distance = tail.separation - overlap;
                let share = tail.separation / distance;
                -2.0 * self.pull_off(size) * share * share / distance
            }
            _ => 1.5 * self.hertz_stiffness(size) * overlap.max(0.0).sqrt(),
        }
    }

    fn collision_time(&self, size: PairSize, overlap: f64) -> f64 {
        // that of Hertz, at least as deep as where both forces are equal; and the fall through the tail
        let ratio = size.mass / self.hertz_stiffness(size);
        let pull_off = self.pull_off(size);
        let share = libm::cbrt(pull_off / self.hertz_stiffness(size));
        let overlap = overlap.max(share * share);
        let v0 = (0.8 / ratio * overlap * overlap * overlap.sqrt()).sqrt();
        let hertz = UNDAMPED * libm::pow(ratio, 0.4) * libm::pow(v0, -0.2);
        match self.tail {
            Some(tail) if pull_off > 0.0 => hertz.min((size.mass * tail.separation / pull_off).sqrt()),
            _ => hertz,
        }
    }

    #[inline(always)]
    fn history(&self) -> usize {
        self.dashpot.history()
    }

    #[inline(always)]
    fn reach(&self, _size: PairSize, _history: &[f64]) -> f64 {
        self.tail.map_or(0.0, |tail| tail.cutoff)
    }

    #[inline(always)]
    fn largest_reach(&self, _size: PairSize) -> f64 {
        self.tail.map_or(0.0, |tail| tail.cutoff)
    }

    fn check(&self, size: PairSize) -> Result<(), String> {
        self.dashpot.check(size, |d| self.with(d))
    }
}

#[cfg(test)]
mod tests;
