//! Undamped springs `F = K x^p` of any exponent, and the units of a collision.
//!
//! Energy, `m v0^2/2 = K x^(p+1)/(p+1) + m v^2/2`, gives the largest overlap; `dt = dx/v` over both halves, with
//! `y = (x/x_max)^(p+1)`, gives the contact time as a Beta function:
//!
//! ```text
//! x_max = ((p+1) m v0^2/(2 K))^(1/(p+1))
//! T     = (2/(p+1)) B(1/(p+1), 1/2) x_max/v0 = 2 sqrt(pi) Gamma(1 + 1/(p+1)) / Gamma(1/2 + 1/(p+1)) x_max/v0
//! ```
//!
//! Hooke's spring (`p = 1`): `T = pi/w0`. Hertz (`p = 3/2`): `T = 3.2180654597 (m/K)^(2/5) v0^(-1/5)`, which for two equal
//! spheres of diameter `d` is eq 23 of Antypov & Elliott (2011), `2.2142101041 d (rho/E_eff)^(2/5) v0^(-1/5)`.

use std::f64::consts::PI;

use super::{RestitutionError, positive};

/// Units in which a collision with the elastic force `K x^p` has no mass, stiffness or impact speed left.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PowerScale {
    /// Exponent `p` of the overlap: 1 linear, 3/2 Hertz.
    pub exponent: f64,
    /// Effective mass `m` [kg].
    pub mass: f64,
    /// `K` [N/m^p].
    pub stiffness: f64,
    /// Impact speed `v0` [m/s].
    pub speed: f64,
}

impl PowerScale {
    /// Unit of overlap, `(m v0^2/K)^(1/(p+1))` [m].
    pub fn length(&self) -> f64 {
        libm::pow(
            self.mass * self.speed * self.speed / self.stiffness,
            1.0 / (self.exponent + 1.0),
        )
    }

    /// Unit of time, the unit of overlap by the impact speed [s]: `(m/K)^(2/5) v0^(-1/5)` for Hertz.
    pub fn time(&self) -> f64 {
        self.length() / self.speed
    }

    /// Unit of force, `m v0^2` by the unit of overlap [N].
    pub fn force(&self) -> f64 {
        self.mass * self.speed * self.speed / self.length()
    }
}

/// One undamped collision with the elastic force `K x^p`, in units of [`PowerScale`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UndampedCollision {
    exponent: f64,
}

impl UndampedCollision {
    /// The collision with the exponent `p > 0`.
    pub fn new(exponent: f64) -> Result<Self, RestitutionError> {
        positive("exponent of the overlap", exponent).map(|exponent| Self { exponent })
    }

    /// Largest overlap, `((p+1)/2)^(1/(p+1))`.
    pub fn max_overlap(&self) -> f64 {
        let order = self.exponent + 1.0;
        libm::pow(0.5 * order, 1.0 / order)
    }

    /// Contact time, `2 sqrt(pi) Gamma(1 + 1/(p+1)) / Gamma(1/2 + 1/(p+1))` largest overlaps by the impact speed.
    pub fn contact_time(&self) -> f64 {
        let part = 1.0 / (self.exponent + 1.0);
        2.0 * PI.sqrt() * (libm::tgamma(1.0 + part) / libm::tgamma(0.5 + part)) * self.max_overlap()
    }

    /// Largest force, `x_max^p`.
    pub fn max_force(&self) -> f64 {
        libm::pow(self.max_overlap(), self.exponent)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::restitution::ContactEnd;
    use crate::restitution::brute_force::{Law, brute_force};
    use approx::assert_relative_eq;

    #[test]
    fn contact_time_and_overlap_of_several_exponents() {
        // 18-digit evaluation of the closed forms
        for (exponent, time, overlap) in [
            (0.5, 2.847_482_516_498_870_6, 0.825_481_812_223_656_7),
            (1.0, PI, 1.0),
            (1.5, 3.218_065_459_719_043, 1.093_362_073_943_278_1),
            (2.0, 3.210_195_653_238_927, 1.144_714_242_553_331_9),
            (3.0, 3.118_169_499_510_822_5, 1.189_207_115_002_721),
        ] {
            let collision = UndampedCollision::new(exponent).unwrap();
            assert_relative_eq!(collision.contact_time(), time, max_relative = 2e-15);
            assert_relative_eq!(collision.max_overlap(), overlap, max_relative = 1e-15);
            let found = brute_force(Law::Power { exponent }, ContactEnd::ZeroOverlap);
            assert_relative_eq!(found.contact_time, time, max_relative = 1e-10);
            assert_relative_eq!(found.max_overlap, overlap, max_relative = 1e-10);
            assert_relative_eq!(found.max_force, collision.max_force(), max_relative = 1e-5);
            assert_relative_eq!(found.restitution, 1.0, max_relative = 1e-10);
        }
        assert!(UndampedCollision::new(0.0).is_err());
        assert!(UndampedCollision::new(f64::INFINITY).is_err());
    }

    #[test]
    fn two_equal_spheres_of_eq_23() {
        let (density, modulus, diameter, speed) = (2500.0, 1e9, 2e-3, 0.7);
        let scale = PowerScale {
            exponent: 1.5,
            mass: 0.5 * density * PI / 6.0 * diameter * diameter * diameter,
            stiffness: 4.0 / 3.0 * modulus * (0.25f64 * diameter).sqrt(),
            speed,
        };
        let time = UndampedCollision::new(1.5).unwrap().contact_time() * scale.time();
        let eq_23 = 2.214_210_104_143_494_3 * diameter * libm::pow(density / modulus, 0.4) * libm::pow(speed, -0.2);
        assert_relative_eq!(time, eq_23, max_relative = 1e-14);
        assert_relative_eq!(scale.force() * scale.time(), scale.mass * speed, max_relative = 1e-15);
    }

    #[test]
    fn units_of_the_linear_spring() {
        let scale = PowerScale {
            exponent: 1.0,
            mass: 0.02,
            stiffness: 5e4,
            speed: 3.0,
        };
        let frequency = (5e4f64 / 0.02).sqrt();
        assert_relative_eq!(scale.length(), 3.0 / frequency, max_relative = 1e-15);
        assert_relative_eq!(scale.time(), 1.0 / frequency, max_relative = 1e-15);
        assert_relative_eq!(scale.force(), 0.02 * frequency * 3.0, max_relative = 1e-15);
    }
}
