//! Exact maps between the coefficient of restitution and the damping of a contact (Antypov & Elliott 2011).
//!
//! Contact ends at zero overlap, as in the paper. With `L = -ln e`, `m` the effective mass and `m x'' = -F`:
//!
//! * linear spring-dashpot (eq 8): `F = k x + 2 gamma m v`, `gamma / sqrt(k/m) = L / sqrt(L^2 + pi^2)`
//! * Hertzian spring-dashpot (eq 17): `F = K x^(3/2) + alpha sqrt(m K) x^(1/4) v`,
//!   `alpha = sqrt(5) L / sqrt(L^2 + pi^2)`

use std::f64::consts::PI;

/// Damping ratio `gamma / omega0` of the linear spring-dashpot with restitution `e` (eq 8). `0 < e <= 1`.
pub fn damping_ratio(restitution: f64) -> f64 {
    let l = -libm::log(restitution);
    l / (l * l + PI * PI).sqrt()
}

/// Damping coefficient `alpha` (dimensionless) of the Hertzian spring-dashpot with restitution `e` (eq 17).
pub fn hertz_damping(restitution: f64) -> f64 {
    5f64.sqrt() * damping_ratio(restitution)
}

/// Contact time of the linear spring-dashpot, `pi / sqrt(k/m - gamma^2)` [s] (eq 7).
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
}
