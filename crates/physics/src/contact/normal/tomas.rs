#![doc = include_str!("tomas.md")]

mod scale;

#[cfg(test)]
mod tests;

use super::dashpot::Dashpot;
use super::path::{Branched, KINKS, Point, follow};
use super::{Normal, NormalInput, NormalResponse};
use crate::contact::{MaterialPair, PairSize};
use crate::dimension::Dimension;
use crate::lanes::Lanes;
use crate::parameters::{Alternatives, ParameterError, ParameterInfo, Range, Values};
use crate::params;
use scale::{Dent, Scale};
use std::f64::consts::PI;

params! {
    /// Parameters of the adhesive elastic-plastic contact.
    pub struct TomasParameters {
        adhesion_force: FORCE, required 2.64e-9, in Range::NOT_NEGATIVE,
            "Pull of two surfaces that touch without load, |F_H0|";
        adhesion_radius: LENGTH, optional 0.3e-6, in Range::POSITIVE,
            "Effective radius that `adhesion_force` belongs to: the force is proportional to the radius. Without it the \
             force is the same for every size";
        separation: LENGTH, required 0.336e-9, in Range::POSITIVE,
            "Distance of molecules that touch, which sets how fast the attraction fades with the gap";
        micro_yield_strength: PRESSURE, usual 300e6, in Range::POSITIVE,
            "Pressure at which the contact yields; needed unless `loading` is \"elastic\"";
        kappa_a: NONE, default 5.0 / 6.0, in Range::POSITIVE_SHARE,
            "Share of the contact area that yields, from 2/3 (elastic) to 1 (plastic)";
        kappa_p: NONE, usual 0.153, in Range::SHARE,
            "Van der Waals pressure of two plates over the yield strength: how much a dent adds to the adhesion; needed \
             unless `loading` is \"elastic\"";
        alpha: NONE, usual 0.2, in Range::NOT_NEGATIVE,
            "Damping coefficient of Tsuji; instead of `restitution` with `impact_speed`";
        restitution: NONE, optional 0.5, in Range::POSITIVE_SHARE,
            "Coefficient of restitution of an impact at `impact_speed`, with adhesion and yielding; instead of `alpha`";
        impact_speed: VELOCITY, optional 1.0, in Range::POSITIVE,
            "Impact speed at which `restitution` is realised, told where the bodies first feel each other";
        tail: NONE, choice ["full", "cut", "none"],
            "How far the attraction reaches across a gap: `range` separations, one, or not at all";
        range: NONE, default 100.0, in Range::POSITIVE,
            "End of the full tail, in separations: what the attraction would still do beyond is left out";
        loading: NONE, choice ["elastic-plastic", "elastic"], "Whether the contact yields";
        yield_overlap: NONE, choice ["continuous", "as-printed"],
            "Overlap at which it yields: where the force is continuous, or four times that, as eq 11 is printed";
        damping_overlap: NONE, choice ["elastic", "total"],
            "Overlap that the damping follows: its elastic part, or the whole, as eq 7 is printed";
    }
}

/// What the yield overlap as printed is over the one at which the force is continuous.
const AS_PRINTED: f64 = 4.0;

/// The pull of surfaces that touch without load.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Pull {
    /// The same for every size [N].
    Constant(f64),
    /// In proportion to the effective radius [N/m].
    PerRadius(f64),
}

/// The adhesive elastic-plastic contact bound to a pair of materials.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tomas {
    /// `4/3 E` [Pa].
    modulus: f64,
    pull: Pull,
    /// Where the force across a gap has halved, and more [m].
    separation: f64,
    /// Gap at which the attraction ends [m].
    range: f64,
    /// `pi p_f (kappa_a - kappa_p)`: slope of the yield line over the radius [Pa].
    yield_slope: f64,
    /// `pi p_f kappa_p`: slope of the adhesion limit over the radius [Pa].
    limit_slope: f64,
    /// Overlap at which a new contact yields, over that at which the force is continuous; infinite when it never does.
    yield_factor: f64,
    damps_total_overlap: bool,
    pub(super) dashpot: Dashpot,
}

impl Tomas {
    /// Slopes of the yield line and of the adhesion limit over the radius [Pa].
    fn slopes(p: &TomasParameters) -> Result<[f64; 2], Vec<ParameterError>> {
        let (Some(strength), Some(kappa_p)) = (p.micro_yield_strength, p.kappa_p) else {
            let (name, other) = if p.micro_yield_strength.is_none() {
                ("micro_yield_strength", "`kappa_p`")
            } else {
                ("kappa_p", "`micro_yield_strength`")
            };
            return match p.loading {
                ELASTIC => Ok([1.0, 0.0]),
                _ => Err(ParameterError::together(
                    name,
                    format!(
                        "`{name}` is missing; with {other} it tells how the contact yields. Or set `loading = \"elastic\"`"
                    ),
                )),
            };
        };
        if p.kappa_a <= kappa_p {
            let message = format!(
                "`kappa_a` is {} and `kappa_p` {kappa_p}; `kappa_a` must be larger, or a contact that yields does not resist",
                p.kappa_a
            );
            return Err(ParameterError::together("kappa_a", message));
        }
        Ok([PI * strength * (p.kappa_a - kappa_p), PI * strength * kappa_p])
    }

    fn dashpot(p: &TomasParameters) -> Result<Dashpot, Vec<ParameterError>> {
        if p.alpha.is_none() && p.restitution.is_none() && p.impact_speed.is_none() {
            let message = "the damping is missing: give `alpha` (0 for none), or `restitution` with `impact_speed`";
            return Err(ParameterError::together("alpha", message));
        }
        Dashpot::read("alpha", p.alpha, p.restitution, p.impact_speed)
    }

    /// Everything that depends on the size.
    #[inline(always)]
    fn scale<L: Lanes>(&self, size: PairSize<L>) -> Scale<L> {
        let hertz = size.radius.sqrt() * self.modulus;
        let line = size.radius * self.yield_slope;
        let root = line / hertz;
        let level = root * root;
        Scale {
            hertz,
            line,
            limit: size.radius * self.limit_slope,
            pull: match self.pull {
                Pull::Constant(force) => L::splat(force),
                Pull::PerRadius(slope) => size.radius * slope,
            },
            separation: self.separation,
            range: self.range,
            level,
            yields_at: level * self.yield_factor,
        }
    }

    /// Coefficient of the dashpot.
    #[inline(always)]
    fn alpha<L: Lanes>(&self, size: PairSize<L>, history: &mut [L]) -> L {
        let memory = history.get_mut(REMEMBERED..).unwrap_or_default();
        self.dashpot
            .coefficient(size, memory, |dashpot| Self { dashpot, ..*self })
    }
}

const FULL_TAIL: usize = 0;
const CUT: usize = 1;
const NO_TAIL: usize = 2;
const ELASTIC: usize = 1;

/// Values that are remembered beside the dashpot's coefficient.
const REMEMBERED: usize = 2;

impl Normal for Tomas {
    const NAME: &'static str = "tomas";
    const SUMMARY: &'static str = "adhesive elastic-plastic contact of fine powders, attraction across a gap";
    const DOC: &'static str = include_str!("tomas.md");
    const PARAMETERS: &'static [ParameterInfo] = TomasParameters::TABLE;
    const ALTERNATIVES: &'static [Alternatives] = &[Alternatives {
        of: &["alpha", "restitution"],
        with: &["impact_speed"],
    }];
    const HISTORY: &'static [Dimension] = &[Dimension::LENGTH, Dimension::LENGTH, Dimension::NONE];
    const LASTING: usize = REMEMBERED;
    const FOLLOWS_KINKS: bool = true;

    fn new(values: &Values, pair: &MaterialPair) -> Result<Self, Vec<ParameterError>> {
        let p = TomasParameters::from_values(values)?;
        if p.tail != FULL_TAIL && values.contains_key("range") {
            let message = "`range` tells where the full tail ends, and `tail` is another one: leave out one of the two";
            return Err(ParameterError::together("range", message));
        }
        if p.loading == ELASTIC && values.contains_key("yield_overlap") {
            let message = "`yield_overlap` tells where the contact yields, and `loading` is \"elastic\": leave out one of the two";
            return Err(ParameterError::together("yield_overlap", message));
        }
        let [yield_slope, limit_slope] = Self::slopes(&p)?;
        Ok(Self {
            modulus: 4.0 / 3.0 * pair.effective_modulus(),
            pull: match p.adhesion_radius {
                Some(radius) => Pull::PerRadius(p.adhesion_force / radius),
                None => Pull::Constant(p.adhesion_force),
            },
            separation: p.separation,
            range: match p.tail {
                NO_TAIL => 0.0,
                CUT => p.separation,
                _ => p.range * p.separation,
            },
            yield_slope,
            limit_slope,
            yield_factor: match (p.loading, p.yield_overlap) {
                (ELASTIC, _) => f64::INFINITY,
                (_, 0) => 1.0,
                _ => AS_PRINTED,
            },
            damps_total_overlap: p.damping_overlap == 1,
            dashpot: Self::dashpot(&p)?,
        })
    }

    #[inline(always)]
    fn history(&self) -> usize {
        REMEMBERED + self.dashpot.history()
    }

    const WIDE: bool = true;

    #[inline(always)]
    fn respond(&self, input: &NormalInput, history: &mut [f64]) -> NormalResponse {
        self.respond_wide(input, history)
    }

    #[inline(always)]
    fn respond_wide<L: Lanes>(&self, input: &NormalInput<L>, history: &mut [L]) -> NormalResponse<L> {
        let alpha = self.alpha(input.size, history);
        let (mut response, dent) = follow(self, input, Dent::of(history));
        response.damping = response.damping * alpha * input.size.mass.sqrt();
        dent.keep(history);
        response
    }

    #[inline]
    fn energy(&self, size: PairSize, overlap: f64, history: &[f64]) -> f64 {
        let dent = self.advance(size, Dent::of(history), overlap);
        self.stored(size, dent, overlap)
    }

    fn stiffness(&self, size: PairSize, overlap: f64, history: &[f64]) -> f64 {
        self.stiffness_wide(size, overlap, history)
    }

    #[inline(always)]
    fn stiffness_wide<L: Lanes>(&self, size: PairSize<L>, overlap: L, history: &[L]) -> L {
        self.scale(size).stiffness(Dent::of(history), overlap)
    }

    fn collision_time(&self, size: PairSize, overlap: f64) -> f64 {
        self.scale(size).shortest_time(size.mass, overlap)
    }

    #[inline]
    fn reach(&self, _size: PairSize, history: &[f64]) -> f64 {
        self.range - Dent::of(history).foot
    }

    #[inline]
    fn largest_reach(&self, _size: PairSize) -> f64 {
        self.range
    }

    fn check(&self, size: PairSize) -> Result<(), String> {
        self.dashpot.check(size, |dashpot| Self { dashpot, ..*self })
    }
}

impl<L: Lanes> Branched<L> for Tomas {
    type State = Dent<L>;
    const PLACES: usize = 3;

    #[inline(always)]
    fn advance(&self, size: PairSize<L>, dent: Dent<L>, to: L) -> Dent<L> {
        self.scale(size).dented(dent, to)
    }

    /// The damping is that of a coefficient 1 and a mass of 1 kg.
    #[inline(always)]
    fn point(&self, size: PairSize<L>, dent: Dent<L>, overlap: L, approaching: L::Mask) -> Point<L> {
        let scale = self.scale(size);
        let zero = L::splat(0.0);
        let elastic_part = overlap - dent.foot;
        let touching = elastic_part.gt(zero);
        let across = scale.attraction(dent, -elastic_part);
        let adhesion = scale.adhesion(dent);
        let yielding = approaching & dent.deepest.gt(zero) & overlap.ge(dent.deepest);
        let root = elastic_part.sqrt();
        let line = scale.line * overlap - scale.pull;
        let curve = scale.hertz * elastic_part * root - adhesion;
        let damped = if self.damps_total_overlap { overlap.sqrt() } else { root };
        let spring = L::select(yielding, scale.line, scale.hertz * damped);
        Point {
            elastic: L::select(touching, L::select(yielding, line, curve), across),
            damping: spring.sqrt().keep(touching),
            adhesion: adhesion.keep(touching),
        }
    }

    /// On the yield line the force asks for no foot, which takes long to find; for the adhesion there it lies on a straight line.
    #[inline(always)]
    fn between(&self, size: PairSize<L>, (from, to): (Dent<L>, Dent<L>), overlap: L, approaching: L::Mask) -> Point<L> {
        let limit = self.scale(size).limit_of(from);
        let yields = overlap.gt(limit);
        let dent = Dent {
            deepest: overlap,
            foot: from.foot + (to.foot - from.foot) * ((overlap - limit) / (to.deepest - limit)),
        };
        self.point(size, Dent::select(yields, dent, from), overlap, approaching)
    }

    #[inline(always)]
    fn stored(&self, size: PairSize<L>, dent: Dent<L>, overlap: L) -> L {
        self.scale(size).stored(dent, overlap)
    }

    #[inline(always)]
    fn kinks(&self, size: PairSize<L>, dent: Dent<L>) -> [L; KINKS] {
        let limit = self.scale(size).limit_of(dent);
        [dent.foot, limit, dent.foot - self.range, limit]
    }

    #[inline(always)]
    fn select(mask: L::Mask, yes: Dent<L>, no: Dent<L>) -> Dent<L> {
        Dent::select(mask, yes, no)
    }

    #[inline(always)]
    fn differ(one: Dent<L>, other: Dent<L>) -> L::Mask {
        one.deepest.gt(other.deepest) | other.deepest.gt(one.deepest)
    }
}
