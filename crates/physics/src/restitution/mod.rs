//! Exact maps between what a collision shows (restitution, contact time, overlap, force) and what a contact law needs
//! (stiffness, damping), for one head-on collision of two bodies (Antypov & Elliott 2011, numbered equations below).
//!
//! With `L = -ln e`, `m` the effective mass and `m x'' = -F`:
//!
//! * [`linear`]: linear spring-dashpot, `F = k x + 2 gamma m v`, `gamma / sqrt(k/m) = L / sqrt(L^2 + pi^2)` (eq 8)
//! * [`hertz`]: Hertzian spring-dashpot, `F = K x^(3/2) + alpha sqrt(m K) x^(1/4) v`,
//!   `alpha = sqrt(5) L / sqrt(L^2 + pi^2)` (eq 17); [`duration`] holds its contact times
//! * [`viscoelastic`]: `F = K x^(3/2) + (3/2) A K x^(1/2) v`, restitution falls with the impact speed
//! * [`power`]: undamped springs of any exponent, and the units in which a collision has no parameter left
//! * [`inverse`]: from measured quantities in SI to stiffness and damping, and back
//! * [`profile`]: a requested restitution that depends on the impact speed
//!
//! The formulas above are for contact that ends at zero overlap, as in most of the paper. Where it ends as soon as the
//! force is zero, no attraction is left and the maps differ: see [`ContactEnd`].

pub mod duration;
mod formula;
pub mod hertz;
pub mod inverse;
pub mod linear;
pub mod power;
pub mod profile;
mod quadrature;
mod taylor;
pub mod viscoelastic;

#[cfg(test)]
mod brute_force;

use std::f64::consts::PI;

use crate::root::bracketed;

pub use profile::{ProfileError, RestitutionProfile};

/// When two bodies in rebound are taken to have parted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ContactEnd {
    /// When the overlap is back at zero. The dashpot pulls at the end of the rebound.
    ZeroOverlap,
    /// When the total force is back at zero: nothing pulls (Schwager & Poeschel 2007). The overlap left over is dropped.
    ZeroForce,
}

/// Why a collision cannot be computed as asked.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum RestitutionError {
    /// A coefficient of restitution outside (0, 1].
    #[error("restitution is {value}; a coefficient of restitution must lie in (0, 1]")]
    Restitution {
        /// The value given.
        value: f64,
    },
    /// A quantity outside its range.
    #[error("{quantity} is {value}; it must be {allowed}")]
    Quantity {
        /// What the value is.
        quantity: &'static str,
        /// The value given.
        value: f64,
        /// The range, in words.
        allowed: &'static str,
    },
    /// What was observed fits more than one restitution.
    #[error(
        "largest overlap by impact speed and contact time is {ratio}, which restitution {low} gives and {high} gives too: \
         give the restitution"
    )]
    Ambiguous {
        /// What was observed.
        ratio: f64,
        /// The smaller restitution.
        low: f64,
        /// The larger restitution.
        high: f64,
    },
    /// The dashpot is so strong that the overlap never comes back to zero.
    #[error(
        "{quantity} is {value}, but the overlap only returns to zero below the critical {limit}: \
         give less damping, or let contact end at zero force"
    )]
    Overdamped {
        /// Which damping coefficient.
        quantity: &'static str,
        /// The value given.
        value: f64,
        /// Contact that ends at zero overlap needs a smaller value than this.
        limit: f64,
    },
}

/// The value, if it is finite and above zero.
fn positive(quantity: &'static str, value: f64) -> Result<f64, RestitutionError> {
    if value > 0.0 && value.is_finite() {
        Ok(value)
    } else {
        Err(RestitutionError::Quantity {
            quantity,
            value,
            allowed: "a finite number above 0",
        })
    }
}

/// The value, if it is finite and not negative.
fn not_negative(quantity: &'static str, value: f64) -> Result<f64, RestitutionError> {
    if value >= 0.0 && value.is_finite() {
        Ok(value)
    } else {
        Err(RestitutionError::Quantity {
            quantity,
            value,
            allowed: "a finite number, 0 or above",
        })
    }
}

/// The value, if it is a coefficient of restitution: in (0, 1].
fn share(value: f64) -> Result<f64, RestitutionError> {
    if value > 0.0 && value <= 1.0 {
        Ok(value)
    } else {
        Err(RestitutionError::Restitution { value })
    }
}

/// Damping ratio `gamma / omega0` of the linear spring-dashpot with restitution `e` (eq 8). `0 < e <= 1`.
///
/// Contact ends at zero overlap; [`linear::LinearCollision`] knows both ends.
pub fn damping_ratio(restitution: f64) -> f64 {
    let l = -libm::log(restitution);
    l / (l * l + PI * PI).sqrt()
}

/// Damping coefficient `alpha` (dimensionless) of the Hertzian spring-dashpot with restitution `e` (eq 17). `0 < e <= 1`.
///
/// Contact ends at zero overlap; [`hertz::HertzCollision`] knows both ends.
pub fn hertz_damping(restitution: f64) -> f64 {
    5f64.sqrt() * damping_ratio(restitution)
}

/// Contact time of the linear spring-dashpot, `pi / sqrt(k/m - gamma^2)` [s] (eq 7).
///
/// Contact ends at zero overlap; [`linear::LinearCollision`] knows both ends.
pub fn linear_contact_time(stiffness: f64, mass: f64, restitution: f64) -> f64 {
    let ratio = damping_ratio(restitution);
    PI / (stiffness / mass * (1.0 - ratio * ratio)).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn reference_values_of_alpha() {
        for (e, alpha) in [(0.1, 1.3218628408), (0.54, 0.4303779787), (0.9, 0.0749495307)] {
            assert_relative_eq!(hertz_damping(e), alpha, max_relative = 1e-9);
        }
        assert_eq!(hertz_damping(1.0), 0.0);
    }

    #[test]
    fn an_error_tells_value_limit_and_remedy() {
        let text = linear::LinearCollision::new(1.5)
            .and_then(|c| c.restitution(ContactEnd::ZeroOverlap))
            .unwrap_err()
            .to_string();
        assert!(
            text.contains("1.5") && text.contains("critical 1") && text.contains("zero force"),
            "{text}"
        );
        for wrong in [0.0, -0.1, 1.0 + 1e-12, f64::NAN] {
            assert!(matches!(share(wrong), Err(RestitutionError::Restitution { .. })));
        }
    }
}
