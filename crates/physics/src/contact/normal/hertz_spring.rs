//! The spring of Hertz, `F = K d^(3/2)`, which elastic and adhesive laws share.
//!
//! Everything follows from the radius of contact, `a = sqrt(R d)`, which takes one root.

use super::{NormalInput, mean_of_change, near_end, window};
use crate::contact::{MaterialPair, PairSize};
use crate::lanes::{Lanes, Mask};

/// What the stiffness follows from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum HertzSpring {
    /// The materials: `K = 4/3 E sqrt(R)`.
    Materials {
        /// `4/3 E` [Pa].
        modulus: f64,
        /// Its square root.
        root: f64,
    },
    /// An observed collision: stiffness per effective mass, `K/m` [1/(m^(1/2) s^2)].
    PerMass(f64),
}

/// Powers of the overlap that laws are made of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Power {
    /// `K d^(3/2)` [N].
    Force,
    /// `K d^(1/2)` [N/m].
    Secant,
    /// `sqrt(m K) d^(1/4)`, which dashpots are told in units of [N s/m].
    Damping,
}

impl Power {
    #[inline(always)]
    const fn exponent(self) -> f64 {
        match self {
            Self::Force => 1.5,
            Self::Secant => 0.5,
            Self::Damping => 0.25,
        }
    }
}

/// Radius of contact, `sqrt(R d)`, of an overlap that is not negative [m].
#[inline(always)]
fn contact_radius<L: Lanes>(size: PairSize<L>, overlap: L) -> L {
    (size.radius * overlap).sqrt()
}

impl HertzSpring {
    /// The spring of two materials.
    pub fn of(pair: &MaterialPair) -> Self {
        let modulus = 4.0 / 3.0 * pair.effective_modulus();
        Self::Materials {
            modulus,
            root: modulus.sqrt(),
        }
    }

    /// `K` [N/m^(3/2)].
    pub fn stiffness(&self, size: PairSize) -> f64 {
        match self {
            Self::Materials { modulus, .. } => modulus * size.radius.sqrt(),
            Self::PerMass(per_mass) => per_mass * size.spring_mass,
        }
    }

    /// `K/sqrt(R)` [Pa], and its square root.
    #[inline(always)]
    fn modulus<L: Lanes>(&self, size: PairSize<L>) -> (L, L) {
        match self {
            Self::Materials { modulus, root } => (L::splat(*modulus), L::splat(*root)),
            Self::PerMass(per_mass) => {
                let modulus = size.spring_mass * *per_mass / size.radius.sqrt();
                (modulus, modulus.sqrt())
            }
        }
    }

    /// `K sqrt(d)` [N/m].
    #[inline(always)]
    fn secant<L: Lanes>(&self, size: PairSize<L>, overlap: L) -> L {
        contact_radius(size, overlap) * self.modulus(size).0
    }

    /// A power of the overlap, and what it is to be multiplied by: the root, which takes long, and all else.
    #[inline(always)]
    fn power<L: Lanes>(&self, power: Power, size: PairSize<L>, overlap: L) -> (L, L) {
        let radius = contact_radius(size, overlap);
        let (modulus, root) = self.modulus(size);
        match power {
            Power::Force => (radius, modulus * overlap),
            Power::Secant => (radius, modulus),
            Power::Damping => ((size.mass * radius).sqrt(), root),
        }
    }

    /// A power of the overlap times the overlap.
    #[inline(always)]
    fn times_overlap<L: Lanes>(&self, power: Power, size: PairSize<L>, overlap: L) -> L {
        let (root, rest) = self.power(power, size, overlap);
        root * rest * overlap
    }

    /// Mean of a power of the overlap over the part of the window in which the bodies overlap.
    #[inline(always)]
    pub fn mean<L: Lanes>(&self, power: Power, input: &NormalInput<L>) -> L {
        self.mean_times(power, input, L::splat(1.0))
    }

    /// The same, times a factor.
    #[inline(always)]
    pub fn mean_times<L: Lanes>(&self, power: Power, input: &NormalInput<L>, factor: L) -> L {
        let overlap = input.overlap.max(L::splat(0.0));
        let share = input.half_window / overlap;
        let exponent = power.exponent();
        // f + f'' h^2/6
        let bend = exponent * (exponent - 1.0) / 6.0;
        let (root, rest) = self.power(power, input.size, overlap);
        let smooth = root * (rest * factor * (share * share * bend + 1.0));
        let smooth = smooth.keep(input.overlap.gt(L::splat(0.0)));
        let near_end = near_end(input);
        if near_end.any() {
            let [upper, lower] = window(input);
            let rise =
                (self.times_overlap(power, input.size, upper) - self.times_overlap(power, input.size, lower)) * factor;
            let change = rise * (1.0 / (exponent + 1.0));
            L::select(near_end, mean_of_change(input, change), smooth)
        } else {
            smooth
        }
    }

    /// Tangent stiffness, `3/2 K sqrt(d)` [N/m].
    #[inline(always)]
    pub fn tangent<L: Lanes>(&self, size: PairSize<L>, overlap: L) -> L {
        self.secant(size, overlap.max(L::splat(0.0))) * 1.5
    }

    /// Energy stored, `2/5 K d^(5/2)` [J].
    #[inline(always)]
    pub fn energy(&self, size: PairSize, overlap: f64) -> f64 {
        let d = overlap.max(0.0);
        0.4 * self.secant(size, d) * d * d
    }

    /// Speed of the undamped impact that reaches an overlap [m/s], from `1/2 m v^2 = 2/5 K d^(5/2)`.
    pub fn impact_speed(&self, size: PairSize, overlap: f64) -> f64 {
        (2.0 * self.energy(size, overlap) / size.mass).sqrt()
    }

    /// Unit of time of impacts at a speed, `(m/K)^(2/5) v^(-1/5)` [s].
    pub fn unit_of_time(&self, size: PairSize, speed: f64) -> f64 {
        libm::pow(size.mass / self.stiffness(size), 0.4) * libm::pow(speed, -0.2)
    }
}
