//! Forces and energies of the contact between bodies of one size.

use crate::restitution::duration::UNDAMPED;
use std::f64::consts::PI;

/// What a contact remembers; all 0 before it first yields.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Dent {
    /// Largest overlap since it first yielded, `h_U` [m].
    pub deepest: f64,
    /// Overlap at which the dented surfaces part, `h_A` [m].
    pub foot: f64,
}

impl Dent {
    /// From the history of a contact.
    #[inline(always)]
    pub fn of(history: &[f64]) -> Self {
        Self {
            deepest: history[0],
            foot: history[1],
        }
    }

    /// Into the history of a contact.
    #[inline(always)]
    pub fn keep(self, history: &mut [f64]) {
        history[0] = self.deepest;
        history[1] = self.foot;
    }
}

/// The law for one size.
#[derive(Clone, Copy, Debug)]
pub struct Scale {
    /// `K` [N/m^(3/2)].
    pub hertz: f64,
    /// Slope of the yield line, `k_pl` [N/m].
    pub line: f64,
    /// Slope of the adhesion limit, `k_p` [N/m].
    pub limit: f64,
    /// `|F_H0|` [N].
    pub pull: f64,
    /// `a` [m].
    pub separation: f64,
    /// Gap at which the attraction ends [m].
    pub range: f64,
    /// Overlap at which the elastic curve meets the yield line, `(k_pl/K)^2` [m].
    pub level: f64,
    /// Overlap at which a new contact yields [m].
    pub yields_at: f64,
}

/// Newton's method from above converges in a few steps; this bounds it whatever the numbers.
const MOST_ITERATIONS: u32 = 60;

impl Scale {
    /// Overlap beyond which a contact yields [m].
    #[inline(always)]
    pub fn limit_of(&self, dent: Dent) -> f64 {
        if dent.deepest > 0.0 {
            dent.deepest
        } else {
            self.yields_at
        }
    }

    /// The dent after a straight move of the overlap.
    #[inline(always)]
    pub fn dented(&self, dent: Dent, to: f64) -> Dent {
        if to > self.limit_of(dent) {
            Dent {
                deepest: to,
                foot: self.foot(to),
            }
        } else {
            dent
        }
    }

    /// `h_A` of a contact that has yielded to an overlap [m]: the elastic curve that ends on the adhesion limit passes
    /// through the yield line there, `K (h_U - h_A)^(3/2) = k_pl h_U + k_p h_A`.
    pub fn foot(&self, deepest: f64) -> f64 {
        // with s^2 = (h_U - h_A)/h_Y: s^3 + kappa s^2 = (1 + kappa) h_U/h_Y
        let kappa = self.limit / self.line;
        let right = (1.0 + kappa) * deepest / self.level;
        // both terms alone give more than the root, from where Newton's method falls onto it
        let mut s = libm::cbrt(right).min((right / kappa).sqrt());
        for _ in 0..MOST_ITERATIONS {
            let next = s - (s * s * (s + kappa) - right) / (s * (3.0 * s + 2.0 * kappa));
            // a step up, or none, is rounding
            if next.is_nan() || next >= s {
                break;
            }
            s = next;
        }
        (deepest - self.level * s * s).max(0.0)
    }

    /// Pull of the surfaces in contact, `-F_A` [N].
    #[inline(always)]
    pub fn adhesion(&self, dent: Dent) -> f64 {
        self.pull + self.limit * dent.foot
    }

    /// Force across a gap between the dented surfaces, not positive [N].
    #[inline(always)]
    pub fn attraction(&self, dent: Dent, gap: f64) -> f64 {
        if gap >= self.range {
            return 0.0;
        }
        let share = self.separation / (self.separation + gap);
        -(self.pull + self.limit * dent.foot * share) * share * share
    }

    /// Energy that is missing across a gap, compared with bodies out of reach [J].
    #[inline(always)]
    fn well(&self, dent: Dent, gap: f64) -> f64 {
        if gap >= self.range {
            return 0.0;
        }
        // differences of a/(a + gap) and of its square between the gap and the end of the attraction
        let a = self.separation;
        let (here, end) = (a / (a + gap), a / (a + self.range));
        let first = (self.range - gap) / (a + gap) * end;
        let second = first * (here + end);
        a * (self.pull * first + 0.5 * self.limit * dent.foot * second)
    }

    /// Recoverable energy [J].
    #[inline(always)]
    pub fn stored(&self, dent: Dent, overlap: f64) -> f64 {
        let elastic_part = overlap - dent.foot;
        if elastic_part > 0.0 {
            let hertz = 0.4 * self.hertz * elastic_part * elastic_part * elastic_part.sqrt();
            hertz - self.adhesion(dent) * elastic_part - self.well(dent, 0.0)
        } else {
            -self.well(dent, -elastic_part)
        }
    }

    /// Slope of the force over the overlap [N/m].
    pub fn stiffness(&self, dent: Dent, overlap: f64) -> f64 {
        let elastic_part = overlap - dent.foot;
        if overlap > self.limit_of(dent) {
            self.line
        } else if elastic_part > 0.0 {
            1.5 * self.hertz * elastic_part.sqrt()
        } else if -elastic_part < self.range {
            let share = self.separation / (self.separation - elastic_part);
            let slope = 2.0 * self.pull + 3.0 * self.limit * dent.foot * share;
            -slope * share * share * share / self.separation
        } else {
            0.0
        }
    }

    /// Shortest time scale of contacts that reach an overlap [s]: of an elastic collision that is as deep as the
    /// elastic part ever is there, in impact or held by adhesion, and of the attraction across a gap.
    pub fn shortest_time(&self, mass: f64, overlap: f64) -> f64 {
        let dent = self.dented(Dent::default(), overlap);
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
