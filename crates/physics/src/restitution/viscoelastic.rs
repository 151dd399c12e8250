//! One collision of viscoelastic spheres (Kuwabara & Kono 1987; Brilliantov, Spahn, Hertzsch & Poeschel 1996).
//!
//! `m x'' + (3/2) A K sqrt(x) x' + K x^(3/2) = 0`, `x(0) = 0`, `x'(0) = v0`, with the dissipative time `A` [s]. In units of
//! the collision ([`PowerScale`](super::power::PowerScale), exponent 3/2) one number is left,
//!
//! ```text
//! x'' + beta sqrt(x) x' + x^(3/2) = 0,      beta = (3/2) A (K/m)^(2/5) v0^(1/5)
//! ```
//!
//! so the restitution falls as the impact speed grows. There is no closed form. The equation is integrated by Taylor series of
//! order 24 in a variable in which it is polynomial (module `taylor`), to some 1e-15 per step, and:
//!
//! * **small `beta`**: the series of `e` in `beta` (zero overlap) or `sqrt(beta)` (zero force; the first term that differs is
//!   `+ (4/15) beta^(5/2)`), so that `1 - e` keeps all its digits. Coefficients: discrete Fourier transform of 40-digit
//!   integrations on a circle of complex `beta`. `C1 = (2/5) (5/4)^(3/5) sqrt(pi) Gamma(3/5)/Gamma(21/10)` (energy lost to first order),
//!   `C2 = 3/5 C1^2` (Ramirez, Poeschel, Brilliantov & Schwager 1999).
//! * **large `beta`**, zero overlap: the bodies creep apart on a path that no longer depends on how they met, and
//!   `e = 5.1583817043 beta^(-5)`, up to a share of about `exp(-2 beta^(5/3))`: exact to rounding from `beta = 7` on.

use super::taylor::{self, Outcome};
use super::{ContactEnd, RestitutionError, bracketed, share};

/// Coefficients of `e` in powers of `beta`, end at zero overlap (radius of convergence about 1.4).
const ZERO_OVERLAP: [f64; 17] = [
    1.0,
    -1.153_448_858_095_288_8,
    0.798_266_560_944_795_4,
    -0.522_882_568_088_414_9,
    0.348_742_675_260_385_03,
    -0.233_098_132_019_244_4,
    0.156_682_152_387_907_1,
    -0.105_818_786_079_435_53,
    0.071_765_284_924_141_07,
    -0.048_857_174_219_906_05,
    0.033_373_473_385_032_68,
    -0.022_865_945_607_469_29,
    0.015_709_195_682_481_18,
    -0.010_818_820_620_956_57,
    0.007_467_340_093_109_75,
    -0.005_164_447_062_222_14,
    0.003_578_300_037_252_5,
];

/// Coefficients of `e` in powers of `sqrt(beta)`, end at zero force (radius of convergence about 1).
const ZERO_FORCE: [f64; 26] = [
    1.0,
    0.0,
    -1.153_448_858_095_288_8,
    0.0,
    0.798_266_560_944_795_4,
    4.0 / 15.0,
    -0.522_882_568_088_414_9,
    -0.461_379_543_238_115_52,
    0.348_742_675_260_385_03,
    0.452_351_051_202_050_7,
    -0.146_431_465_352_577_73,
    -0.367_728_300_838_145_2,
    -0.043_248_983_015_276_3,
    0.281_804_234_218_535_3,
    0.147_852_587_731_910_6,
    -0.179_442_060_169_308,
    -0.178_466_033_428_604_87,
    0.065_933_589_474_841_27,
    0.171_358_618_470_971_04,
    0.025_249_822_049_520_5,
    -0.137_923_499_376_517_3,
    -0.079_246_569_618_703_1,
    0.084_156_870_983_886_1,
    0.102_427_377_396_311_4,
    -0.026_418_714_116_974_4,
    -0.101_683_600_602_654_5,
];

/// `e beta^5` of very strong damping, end at zero overlap.
const CREEP: f64 = 5.158_381_704_267_685;

/// From this `beta` on [`CREEP`] holds to rounding.
const CREEPS_FROM: f64 = 7.0;

/// Largest `beta` for which collisions are integrated: `e` is 5e-15 at zero overlap, 1e-5 at zero force.
pub const LARGEST_BETA: f64 = 1000.0;

/// A viscoelastic collision with a given damping number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ViscoelasticCollision {
    beta: f64,
}

impl ViscoelasticCollision {
    /// The collision with `beta = (3/2) A (K/m)^(2/5) v0^(1/5)`, from 0 to [`LARGEST_BETA`].
    pub fn new(beta: f64) -> Result<Self, RestitutionError> {
        if (0.0..=LARGEST_BETA).contains(&beta) {
            Ok(Self { beta })
        } else {
            Err(RestitutionError::Quantity {
                quantity: "damping number beta of a viscoelastic collision",
                value: beta,
                allowed: "0 to 1000",
            })
        }
    }

    /// The collision with the restitution `e` at the given end of contact, the inverse of [`Self::restitution`].
    ///
    /// Solved for `1 - e` where the series holds, else for `ln e`. Refused below the restitution of [`LARGEST_BETA`].
    pub fn from_restitution(restitution: f64, end: ContactEnd) -> Result<Self, RestitutionError> {
        let loss = 1.0 - share(restitution)?;
        let last = series_until(end);
        if loss <= series_loss(last, end) {
            let beta = if loss > 0.0 {
                bracketed(|beta| series_loss(beta, end) - loss, 0.0, last)
            } else {
                0.0
            };
            return Ok(Self { beta });
        }
        // strong damping takes long to integrate: it is not looked at for a restitution that beta = 10 undercuts
        let most = if restitution > 0.05 { 10.0 } else { LARGEST_BETA };
        if restitution < (Self { beta: most }).restitution(end)? {
            return Err(RestitutionError::Quantity {
                quantity: "restitution of a viscoelastic collision",
                value: restitution,
                allowed: match end {
                    ContactEnd::ZeroOverlap => "at least 5.2e-15",
                    ContactEnd::ZeroForce => "at least 1.32e-5 where contact ends at zero force",
                },
            });
        }
        let wanted = libm::log(restitution);
        let misfit = |log_beta: f64| {
            let collision = Self {
                beta: libm::exp(log_beta),
            };
            collision.restitution(end).map_or(f64::NAN, |e| libm::log(e) - wanted)
        };
        let log_beta = bracketed(misfit, libm::log(last), libm::log(most));
        Ok(Self {
            beta: libm::exp(log_beta),
        })
    }

    /// Damping number `beta`.
    pub fn beta(&self) -> f64 {
        self.beta
    }

    /// Coefficient of restitution.
    pub fn restitution(&self, end: ContactEnd) -> Result<f64, RestitutionError> {
        if self.beta <= series_until(end) {
            Ok(1.0 - series_loss(self.beta, end))
        } else if end == ContactEnd::ZeroOverlap && self.beta >= CREEPS_FROM {
            let square = self.beta * self.beta;
            Ok(CREEP / (square * square * self.beta))
        } else {
            self.to_end(end).map(|last| -last.speed)
        }
    }

    /// Contact time in `(m/K)^(2/5) v0^(-1/5)`.
    pub fn contact_time(&self, end: ContactEnd) -> Result<f64, RestitutionError> {
        self.to_end(end).map(|last| last.time)
    }

    /// Largest overlap in `(m v0^2/K)^(2/5)`.
    pub fn max_overlap(&self) -> Result<f64, RestitutionError> {
        self.integrated(taylor::to_largest_overlap(self.beta))
            .map(|peak| peak.overlap)
    }

    fn to_end(self, end: ContactEnd) -> Result<Outcome, RestitutionError> {
        self.integrated(taylor::to_end(self.beta, end))
    }

    fn integrated(&self, outcome: Option<Outcome>) -> Result<Outcome, RestitutionError> {
        outcome.ok_or(RestitutionError::Quantity {
            quantity: "damping number beta of a viscoelastic collision",
            value: self.beta,
            allowed: "0 to 1000",
        })
    }
}

/// `C1` and on of the series of the end at zero overlap: `e = 1 - C1 beta + C2 beta^2 - ...`, good to 1e-3 up to `beta = 0.3`.
pub fn first_coefficients() -> [f64; 4] {
    std::array::from_fn(|i| ZERO_OVERLAP[i + 1].abs())
}

/// Up to this `beta` the series is exact to rounding.
fn series_until(end: ContactEnd) -> f64 {
    match end {
        ContactEnd::ZeroOverlap => 0.1,
        ContactEnd::ZeroForce => 0.04,
    }
}

/// `1 - e` by the series.
fn series_loss(beta: f64, end: ContactEnd) -> f64 {
    let horner = |coefficients: &[f64], z: f64| coefficients.iter().rev().fold(0.0, |sum, c| sum * z + c);
    match end {
        ContactEnd::ZeroOverlap => -beta * horner(&ZERO_OVERLAP[1..], beta),
        ContactEnd::ZeroForce => -beta * horner(&ZERO_FORCE[2..], beta.sqrt()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::restitution::brute_force::{Law, brute_force};
    use crate::restitution::power::UndampedCollision;
    use ContactEnd::{ZeroForce, ZeroOverlap};
    use approx::assert_relative_eq;
    use std::f64::consts::PI;

    fn collision(beta: f64) -> ViscoelasticCollision {
        ViscoelasticCollision::new(beta).unwrap()
    }

    #[test]
    fn the_reference_coefficients() {
        let [c1, c2, c3, c4] = first_coefficients();
        for (found, reference) in [
            (c1, 1.1534488581),
            (c2, 0.7982665609),
            (c3, 0.5228825681),
            (c4, 0.348742675),
        ] {
            assert_relative_eq!(found, reference, max_relative = 1e-9);
        }
        let exact = 0.4 * libm::pow(1.25, 0.6) * PI.sqrt() * libm::tgamma(0.6) / (libm::tgamma(2.1));
        assert_relative_eq!(c1, exact, max_relative = 1e-15);
        assert_relative_eq!(c2, 0.6 * c1 * c1, max_relative = 1e-15);
        // "direct integration beyond beta 0.3": what four terms miss there
        let four = 1.0 - 0.3 * (c1 - 0.3 * (c2 - 0.3 * (c3 - 0.3 * c4)));
        assert!((four - collision(0.3).restitution(ZeroOverlap).unwrap()).abs() < 1e-3);
    }

    #[test]
    fn restitution_agrees_with_twenty_digits() {
        for (beta, zero_overlap, zero_force) in [
            (0.01, 0.988_544_818_656_846_1, 0.988_547_439_642_729_4),
            (0.05, 0.944_259_972_343_339_4, 0.944_396_779_177_630_3),
            (0.1, 0.892_147_587_290_229_4, 0.892_858_875_506_553_3),
            (0.3, 0.714_044_879_992_152_5, 0.722_085_439_653_504_9),
            (1.0, 0.331_164_810_466_640_9, 0.393_930_603_229_873_17),
        ] {
            let made = collision(beta);
            assert_relative_eq!(
                made.restitution(ZeroOverlap).unwrap(),
                zero_overlap,
                max_relative = 2e-15
            );
            assert_relative_eq!(made.restitution(ZeroForce).unwrap(), zero_force, max_relative = 2e-15);
        }
        for (beta, zero_force) in [(3.0, 0.133_716_622_407_532_02), (30.0, 0.004_395_127_976_402_98)] {
            let strong = collision(beta).restitution(ZeroForce).unwrap();
            assert_relative_eq!(strong, zero_force, max_relative = 4e-15);
        }
        let strong = collision(3.0).restitution(ZeroOverlap).unwrap();
        assert_relative_eq!(strong, 0.020_682_506_960_711_01, max_relative = 1e-13);
    }

    #[test]
    fn every_damping_agrees_with_integration() {
        for beta in [0.0, 0.02, 0.3, 1.0, 2.5] {
            let made = collision(beta);
            for end in [ZeroOverlap, ZeroForce] {
                let found = brute_force(Law::Viscoelastic { beta }, end);
                assert_relative_eq!(made.restitution(end).unwrap(), found.restitution, max_relative = 1e-10);
                assert_relative_eq!(
                    made.contact_time(end).unwrap(),
                    found.contact_time,
                    max_relative = 1e-10
                );
                assert_relative_eq!(made.max_overlap().unwrap(), found.max_overlap, max_relative = 1e-10);
            }
        }
        let undamped = UndampedCollision::new(1.5).unwrap();
        assert_relative_eq!(
            collision(0.0).max_overlap().unwrap(),
            undamped.max_overlap(),
            max_relative = 1e-15
        );
        for end in [ZeroOverlap, ZeroForce] {
            let time = collision(0.0).contact_time(end).unwrap();
            assert_relative_eq!(time, undamped.contact_time(), max_relative = 1e-14);
            assert_eq!(collision(0.0).restitution(end).unwrap(), 1.0);
        }
    }

    #[test]
    fn series_integration_and_creep_meet() {
        for end in [ZeroOverlap, ZeroForce] {
            for share in [1e-6, 0.01, 0.3, 1.0] {
                let made = collision(share * series_until(end));
                let direct = -made.to_end(end).unwrap().speed;
                assert_relative_eq!(made.restitution(end).unwrap(), direct, max_relative = 4e-15);
            }
        }
        for beta in [7.0, 12.0, 100.0, LARGEST_BETA] {
            let made = collision(beta);
            let direct = -made.to_end(ZeroOverlap).unwrap().speed;
            assert_relative_eq!(made.restitution(ZeroOverlap).unwrap(), direct, max_relative = 1e-12);
            // late in a strongly damped collision v ~ -x/beta, since early in it x ~ (3/(2 beta))^(2/3)
            let overlap = made.max_overlap().unwrap();
            assert_relative_eq!(overlap, libm::pow(1.5 / beta, 2.0 / 3.0), max_relative = 0.1);
            let ratio = made.restitution(ZeroForce).unwrap() * beta / overlap;
            assert!(ratio > 0.7 && ratio < 1.0, "{ratio}");
        }
    }

    #[test]
    fn the_inverse_closes_for_every_restitution_at_both_ends() {
        let wanted = [
            1.0 - 1e-15,
            1.0 - 1e-9,
            0.999,
            0.96,
            0.9,
            0.887,
            0.54,
            0.3,
            0.1,
            0.0501,
            0.05,
            1e-3,
            2e-5,
            1e-12,
        ];
        for e in wanted {
            for end in [ZeroOverlap, ZeroForce] {
                if e < 1e-3 && end == ZeroForce {
                    continue;
                }
                let made = ViscoelasticCollision::from_restitution(e, end).unwrap();
                assert_relative_eq!(made.restitution(end).unwrap(), e, max_relative = 2e-14);
                if e > 0.999 {
                    assert_relative_eq!(series_loss(made.beta(), end), 1.0 - e, max_relative = 1e-15);
                }
            }
        }
        assert_eq!(
            ViscoelasticCollision::from_restitution(1.0, ZeroForce).unwrap().beta(),
            0.0
        );
        let refused = ViscoelasticCollision::from_restitution(1e-6, ZeroForce)
            .unwrap_err()
            .to_string();
        assert!(refused.contains("1.32e-5"), "{refused}");
        assert!(ViscoelasticCollision::from_restitution(1e-16, ZeroOverlap).is_err());
        for beta in [-1e-9, 1000.1, f64::NAN] {
            assert!(ViscoelasticCollision::new(beta).is_err());
        }
    }

    #[test]
    fn restitution_falls_as_damping_grows() {
        for end in [ZeroOverlap, ZeroForce] {
            let all: Vec<f64> = (0..=400)
                .map(|i| collision(0.025 * f64::from(i)).restitution(end).unwrap())
                .collect();
            assert!(all.windows(2).all(|pair| pair[1] < pair[0]));
        }
    }
}
