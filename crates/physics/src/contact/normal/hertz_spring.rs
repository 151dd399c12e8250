//! The spring of Hertz, `F = K d^(3/2)`, which elastic and adhesive laws share.
//!
//! Everything follows from `F/d = K sqrt(d)`, which takes one root.

use super::NormalInput;
use super::window::mean_of_power;
use crate::contact::{MaterialPair, PairSize};
use crate::lanes::Lanes;

/// What the stiffness follows from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum HertzSpring {
    /// The materials: `K = 4/3 E sqrt(R)` with `4/3 E` [Pa].
    Materials(f64),
    /// An observed collision: stiffness per effective mass, `K/m` [1/(m^(1/2) s^2)].
    PerMass(f64),
}

impl HertzSpring {
    /// The spring of two materials.
    pub fn of(pair: &MaterialPair) -> Self {
        Self::Materials(4.0 / 3.0 * pair.effective_modulus())
    }

    /// `K` [N/m^(3/2)].
    pub fn stiffness(&self, size: PairSize) -> f64 {
        match self {
            Self::Materials(modulus) => modulus * size.radius.sqrt(),
            Self::PerMass(per_mass) => per_mass * size.mass,
        }
    }

    /// `K sqrt(d)` [N/m].
    #[inline(always)]
    fn secant<L: Lanes>(&self, size: PairSize<L>, overlap: L) -> L {
        match self {
            Self::Materials(modulus) => (size.radius * overlap).sqrt() * *modulus,
            Self::PerMass(per_mass) => size.mass * overlap.sqrt() * *per_mass,
        }
    }

    /// Mean of `K d^(3/2)` over the window [N].
    #[inline(always)]
    pub fn mean_force<L: Lanes>(&self, input: &NormalInput<L>) -> L {
        mean_of_power(input, 1.5, |d| self.secant(input.size, d) * d)
    }

    /// Mean of `K d^(1/2)` over the window [N/m].
    #[inline(always)]
    pub fn mean_secant<L: Lanes>(&self, input: &NormalInput<L>) -> L {
        mean_of_power(input, 0.5, |d| self.secant(input.size, d))
    }

    /// Mean of `sqrt(m K) d^(1/4)`, which dashpots are told in units of, over the window [N s/m].
    #[inline(always)]
    pub fn mean_damping<L: Lanes>(&self, input: &NormalInput<L>) -> L {
        mean_of_power(input, 0.25, |d| (input.size.mass * self.secant(input.size, d)).sqrt())
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
