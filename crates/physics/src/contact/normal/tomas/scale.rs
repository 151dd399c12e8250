//! Forces and energies of the contact between bodies of one size.

use crate::lanes::{Lanes, Mask, rough_cube_root};
use crate::restitution::duration::UNDAMPED;
use std::f64::consts::PI;

/// What a contact remembers; all 0 before it first yields.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dent<L = f64> {
    /// Largest overlap since it first yielded, `h_U` [m].
    pub deepest: L,
    /// Overlap at which the dented surfaces part, `h_A` [m].
    pub foot: L,
}

impl<L: Lanes> Dent<L> {
    /// Of a contact that has never yielded.
    #[inline(always)]
    pub fn none() -> Self {
        let zero = L::splat(0.0);
        Self {
            deepest: zero,
            foot: zero,
        }
    }

    /// From the history of a contact.
    #[inline(always)]
    pub fn of(history: &[L]) -> Self {
        Self {
            deepest: history[0],
            foot: history[1],
        }
    }

    /// Into the history of a contact.
    #[inline(always)]
    pub fn keep(self, history: &mut [L]) {
        history[0] = self.deepest;
        history[1] = self.foot;
    }

    /// `yes` where the mask holds, `no` elsewhere.
    #[inline(always)]
    pub fn select(mask: L::Mask, yes: Self, no: Self) -> Self {
        Self {
            deepest: L::select(mask, yes.deepest, no.deepest),
            foot: L::select(mask, yes.foot, no.foot),
        }
    }
}

/// The law for one size per lane.
#[derive(Clone, Copy, Debug)]
pub struct Scale<L = f64> {
    /// `K` [N/m^(3/2)].
    pub hertz: L,
    /// Slope of the yield line, `k_pl` [N/m].
    pub line: L,
    /// Slope of the adhesion limit, `k_p` [N/m].
    pub limit: L,
    /// `|F_H0|` [N].
    pub pull: L,
    /// `a` [m].
    pub separation: f64,
    /// Gap at which the attraction ends [m].
    pub range: f64,
    /// Overlap at which the elastic curve meets the yield line, `(k_pl/K)^2` [m].
    pub level: L,
    /// Overlap at which a new contact yields [m].
    pub yields_at: L,
}

/// Steps of Halley's method, each of which leaves the cube of the error.
const HALLEY_STEPS: usize = 3;

/// The `s` of `s^3 + kappa s^2 = right`, both not negative.
#[inline(always)]
fn elastic_root<L: Lanes>(kappa: L, right: L) -> L {
    // s is below the cube root of the right side, so with that this is below s, by 7 % at most
    let mut s = (right / (kappa + rough_cube_root(right))).sqrt();
    for _ in 0..HALLEY_STEPS {
        let value = s * s * (s + kappa) - right;
        let slope = s * (s * 3.0 + kappa * 2.0);
        s = s - value * slope / (slope * slope - value * (s * 3.0 + kappa));
    }
    s
}

impl<L: Lanes> Scale<L> {
    /// Overlap beyond which a contact yields [m].
    #[inline(always)]
    pub fn limit_of(&self, dent: Dent<L>) -> L {
        L::select(dent.deepest.gt(L::splat(0.0)), dent.deepest, self.yields_at)
    }

    /// The dent after a straight move of the overlap.
    #[inline(always)]
    pub fn dented(&self, dent: Dent<L>, to: L) -> Dent<L> {
        let deeper = to.gt(self.limit_of(dent));
        if deeper.any() {
            let next = Dent {
                deepest: to,
                foot: self.foot(to),
            };
            Dent::select(deeper, next, dent)
        } else {
            dent
        }
    }

    /// `h_A` of a contact that has yielded to an overlap [m]: the elastic curve that ends on the adhesion limit passes
    /// through the yield line there, `K (h_U - h_A)^(3/2) = k_pl h_U + k_p h_A`.
    #[inline(always)]
    pub fn foot(&self, deepest: L) -> L {
        // with s^2 = (h_U - h_A)/h_Y: s^3 + kappa s^2 = (1 + kappa) h_U/h_Y
        let kappa = self.limit / self.line;
        let s = elastic_root(kappa, (kappa + 1.0) * deepest / self.level);
        (deepest - self.level * s * s).max(L::splat(0.0))
    }

    /// Pull of the surfaces in contact, `-F_A` [N].
    #[inline(always)]
    pub fn adhesion(&self, dent: Dent<L>) -> L {
        self.pull + self.limit * dent.foot
    }

    /// Force across a gap between the dented surfaces, not positive [N].
    #[inline(always)]
    pub fn attraction(&self, dent: Dent<L>, gap: L) -> L {
        let share = L::splat(self.separation) / (gap + self.separation);
        let force = -(self.pull + self.limit * dent.foot * share) * share * share;
        force.keep(L::splat(self.range).gt(gap))
    }

    /// Energy that is missing across a gap, compared with bodies out of reach [J].
    #[inline(always)]
    fn well(&self, dent: Dent<L>, gap: L) -> L {
        // differences of a/(a + gap) and of its square between the gap and the end of the attraction
        let (a, range) = (self.separation, L::splat(self.range));
        let (here, end) = (L::splat(a) / (gap + a), a / (a + self.range));
        let first = (range - gap) / (gap + a) * end;
        let second = first * (here + end);
        let well = (self.pull * first + self.limit * 0.5 * dent.foot * second) * a;
        well.keep(range.gt(gap))
    }

    /// Recoverable energy [J].
    #[inline(always)]
    pub fn stored(&self, dent: Dent<L>, overlap: L) -> L {
        let zero = L::splat(0.0);
        let elastic_part = overlap - dent.foot;
        let inside = elastic_part.max(zero);
        let hertz = self.hertz * inside * inside * inside.sqrt() * 0.4;
        hertz - self.adhesion(dent) * inside - self.well(dent, (-elastic_part).max(zero))
    }

    /// Slope of the force over the overlap [N/m].
    #[inline(always)]
    pub fn stiffness(&self, dent: Dent<L>, overlap: L) -> L {
        let elastic_part = overlap - dent.foot;
        let share = L::splat(self.separation) / (-elastic_part + self.separation);
        let slope = self.pull * 2.0 + self.limit * dent.foot * share * 3.0;
        let across = -slope * share * share * share / self.separation;
        let across = across.keep(elastic_part.gt(L::splat(-self.range)));
        let pressed = self.hertz * elastic_part.sqrt() * 1.5;
        let elastic = L::select(elastic_part.gt(L::splat(0.0)), pressed, across);
        L::select(overlap.gt(self.limit_of(dent)), self.line, elastic)
    }
}

impl Scale {
    /// Shortest time scale of contacts that reach an overlap [s]: of an elastic collision that is as deep as the
    /// elastic part ever is there, in impact or held by adhesion, and of the attraction across a gap.
    pub fn shortest_time(&self, mass: f64, overlap: f64) -> f64 {
        let dent = self.dented(Dent::none(), overlap);
        // pressed there, and as far as bodies swing that adhesion draws together from where they touch, or from afar
        let held = self.adhesion(dent) / self.hertz;
        let drawn = OVERSHOOT * libm::cbrt(held * held) + libm::pow(2.5 * self.well(dent, 0.0) / self.hertz, 0.4);
        let depth = (overlap - dent.foot).max(overlap.min(self.yields_at)).max(drawn);
        let ratio = mass / self.hertz;
        let speed = (0.8 / ratio * depth * depth * depth.sqrt()).sqrt();
        let collision = UNDAMPED * libm::pow(ratio, 0.4) * libm::pow(speed, -0.2);
        if self.range == 0.0 {
            return collision;
        }
        let slope = (2.0 * self.pull + 3.0 * self.limit * dent.foot) / self.separation;
        collision.min(PI * (mass / slope).sqrt())
    }
}

/// Largest elastic part of bodies that are let go where they touch, over that at rest: `(5/2)^(2/3)`.
const OVERSHOOT: f64 = 1.842_015_749_320_193_3;

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// By halving until nothing lies between.
    fn halved(kappa: f64, right: f64) -> f64 {
        let (mut low, mut high) = (0.0, 2.0 * libm::cbrt(right));
        loop {
            let middle = 0.5 * (low + high);
            if middle <= low || middle >= high {
                return middle;
            }
            if middle * middle * (middle + kappa) < right {
                low = middle;
            } else {
                high = middle;
            }
        }
    }

    #[test]
    fn the_elastic_root_is_that_of_halving() {
        let kappas = (-64..=64).map(|k| libm::pow(10.0, 0.25 * f64::from(k)));
        for kappa in kappas.chain([0.0, f64::MIN_POSITIVE]) {
            for k in -120..=360 {
                let right = (1.0 + kappa) * libm::pow(10.0, 0.1 * f64::from(k));
                assert_relative_eq!(elastic_root(kappa, right), halved(kappa, right), max_relative = 1e-15);
            }
        }
    }
}
