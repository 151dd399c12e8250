#![doc = include_str!("dmt.md")]

use super::dashpot::Dashpot;
use super::hertz_spring::{HertzSpring, Power};
use super::window::contact_share;
use super::{Normal, NormalInput, NormalResponse};
use crate::contact::{MaterialPair, PairSize};
use crate::dimension::Dimension;
use crate::lanes::{Lanes, Mask};
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

/// Time scale of a pull `F` that begins with a jump, over `sqrt(e) m v/F`: a step of a two-hundredth of it changes `v` by a share of
/// `0.0125 sqrt(e)`, so that the books are not off by more than 1e-3 at touch either.
const JUMP: f64 = 2.5;

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
    #[inline(always)]
    fn depth<L: Lanes>(&self, gap: L) -> L {
        let gap = gap.max(L::splat(0.0)).min(L::splat(self.cutoff));
        gap * self.separation / (gap + self.separation)
    }

    /// Mean over the window of the force in the gap, as share of that in contact.
    #[inline(always)]
    fn mean<L: Lanes>(&self, input: &NormalInput<L>) -> L {
        let (gap, h, zero) = (-input.overlap, input.half_window, L::splat(0.0));
        if !(gap + h).ge(zero).any() {
            return zero;
        }
        let inverse = L::splat(1.0) / (gap + self.separation);
        let (share, width) = (inverse * self.separation, inverse * h);
        // f + f'' h^2/6 with f = (z/(z + g))^2
        let smooth = share * share * (width * width + 1.0);
        // surfaces that just touch attract as those do that are ever so little apart
        let across = gap.ge(zero);
        let smooth = smooth.keep(across & (L::splat(self.cutoff)).gt(gap));
        let near_an_end = h.ge(gap.abs()) | h.ge((gap - self.cutoff).abs());
        let wide = (near_an_end | (across & width.gt(L::splat(WIDE)))) & h.gt(zero);
        if wide.any() {
            let exact = (self.depth(gap + h) - self.depth(gap - h)) / (h * 2.0);
            L::select(wide, exact, smooth)
        } else {
            smooth
        }
    }
}

/// The contact of Derjaguin, Muller and Toporov bound to a pair of materials.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dmt {
    spring: HertzSpring,
    work_of_adhesion: f64,
    tail: Option<Tail>,
    pub(super) dashpot: Dashpot,
}

impl Dmt {
    /// `2 pi w R` [N].
    #[inline(always)]
    fn pull_off<L: Lanes>(&self, size: PairSize<L>) -> L {
        size.radius * (2.0 * std::f64::consts::PI * self.work_of_adhesion)
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
    const LASTING: usize = 0;

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
            spring: HertzSpring::of(pair),
            work_of_adhesion: p.work_of_adhesion,
            tail,
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
        let pull_off = self.pull_off(input.size);
        let alpha = self.dashpot.coefficient(input.size, history, |d| self.with(d));
        let adhesion = pull_off * contact_share(input);
        let across = match self.tail {
            Some(tail) => pull_off * tail.mean(input),
            None => L::splat(0.0),
        };
        NormalResponse {
            adhesion,
            ..NormalResponse::spring_dashpot(
                input,
                self.spring.mean(Power::Force, input) - adhesion - across,
                self.spring.mean(Power::Damping, input) * alpha,
            )
        }
    }

    #[inline(always)]
    fn energy(&self, size: PairSize, overlap: f64, _history: &[f64]) -> f64 {
        let d = overlap.max(0.0);
        let across = self
            .tail
            .map_or(0.0, |tail| tail.depth(tail.cutoff) - tail.depth(-overlap));
        self.spring.energy(size, d) - self.pull_off(size) * (d + across)
    }

    #[inline(always)]
    fn stiffness(&self, size: PairSize, overlap: f64, history: &[f64]) -> f64 {
        self.stiffness_wide(size, overlap, history)
    }

    #[inline(always)]
    fn stiffness_wide<L: Lanes>(&self, size: PairSize<L>, overlap: L, _history: &[L]) -> L {
        let spring = self.spring.tangent(size, overlap);
        let Some(tail) = self.tail else { return spring };
        let distance = L::splat(tail.separation) - overlap;
        let share = L::splat(tail.separation) / distance;
        let slope = self.pull_off(size) * -2.0 * share * share / distance;
        let across = L::splat(0.0).ge(overlap) & overlap.gt(L::splat(-tail.cutoff));
        L::select(across, slope, spring)
    }

    fn collision_time(&self, size: PairSize, overlap: f64) -> f64 {
        // that of Hertz, at least as deep as where both forces are equal; and the fall through the tail
        let pull_off = self.pull_off(size);
        let share = libm::cbrt(pull_off / self.spring.stiffness(size));
        let overlap = overlap.max(share * share);
        let hertz = UNDAMPED * self.spring.unit_of_time(size, self.spring.impact_speed(size, overlap));
        if pull_off == 0.0 {
            return hertz;
        }
        hertz.min(match (self.tail, self.dashpot) {
            (Some(tail), _) => (size.mass * tail.separation / pull_off).sqrt(),
            // Where the pull begins and ends with a jump, a step changes a speed v by q v, q = F dt/(m v), of which the one before knows
            // nothing: the square of the restitution is off by some q^2/3, and so the restitution by less than 1e-4 up to q = 0.02 sqrt(e)
            (None, Dashpot::Realised { restitution, speed, .. }) => {
                JUMP * restitution.sqrt() * size.mass * speed / pull_off
            }
            (None, Dashpot::Coefficient(_)) => f64::INFINITY,
        })
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
