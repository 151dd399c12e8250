//! Whether deviations are those of a law that is right.
//!
//! With Gaussian errors the squares of the deviations sum up to chi-square, and the largest of them grows with their
//! number. Each is held to the value that it exceeds with half of the chance [`FALSE_ALARM`].

use crate::insertion::normal_quantile;

/// Chance that a law that is right is said not to fit.
const FALSE_ALARM: f64 = 0.01;

/// Deviation [errors] that a single observation may show whatever their number.
const ALWAYS: f64 = 3.0;

/// Whether the deviations of observations that fix so many numbers are those of a law that is right.
pub(super) fn fits(deviations: impl Iterator<Item = f64>, fixed: usize) -> bool {
    let (mut count, mut sum, mut largest) = (0_usize, 0.0, 0.0_f64);
    for deviation in deviations {
        (count, sum) = (count + 1, sum + deviation * deviation);
        largest = largest.max(deviation.abs());
    }
    largest <= largest_deviation(count) && sum <= largest_sum(count, fixed)
}

/// The largest deviation [errors] of so many: that which all stay below with the chance wanted (Sidak 1967,
/// doi:10.1080/01621459.1967.10482935).
fn largest_deviation(count: usize) -> f64 {
    let beyond = -libm::expm1(libm::log1p(-0.5 * FALSE_ALARM) / count.max(1) as f64);
    (-normal_quantile(0.5 * beyond)).max(ALWAYS)
}

/// The largest sum of squares of the deviations: the quantile of chi-square (Wilson and Hilferty 1931,
/// doi:10.1073/pnas.17.12.684); no bound of its own where the observations fix as many numbers as they are.
pub(super) fn largest_sum(count: usize, fixed: usize) -> f64 {
    if count <= fixed {
        return count as f64 * ALWAYS * ALWAYS;
    }
    let freedom = (count - fixed) as f64;
    let spread = 2.0 / (9.0 * freedom);
    let root = 1.0 - spread - normal_quantile(0.5 * FALSE_ALARM) * spread.sqrt();
    freedom * root * root * root
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use rand::Rng;
    use rand_pcg::Pcg64;

    /// Errors of so many observations.
    pub fn noise(seed: u64, count: usize) -> Vec<f64> {
        let mut random = Pcg64::new(u128::from(seed), 7);
        let mut uniform = || ((random.next_u64() >> 12) as f64 + 0.5) / 4_503_599_627_370_496.0;
        (0..count).map(|_| normal_quantile(uniform())).collect()
    }

    #[test]
    fn a_law_that_is_right_fits_whatever_the_number_of_observations() {
        for count in [1, 2, 3, 5, 60, 200, 1000] {
            let seeds = 2000;
            let refused = (0..seeds)
                .filter(|seed| {
                    // the mean is what is sought
                    let noise = noise(*seed, count);
                    let mean = noise.iter().sum::<f64>() / count as f64;
                    !fits(noise.iter().map(|x| x - mean), 1)
                })
                .count();
            // 1 %, with three of its standard errors
            assert!(refused <= 33, "{refused} of {seeds} with {count} observations");
        }
    }

    #[test]
    fn what_is_wrong_does_not_fit() {
        let all = |deviation: f64, count: usize, fixed: usize| fits((0..count).map(|_| deviation), fixed);
        assert!(all(2.9, 1, 1) && !all(3.1, 1, 1), "one observation");
        assert!(all(2.9, 2, 2) && !all(3.1, 2, 2) && !all(2.5, 2, 1), "two observations");
        // none is far off, yet all are somewhat
        for count in [60, 200, 1000] {
            let slanted = |by: f64| {
                (noise(3, count).into_iter().enumerate()).map(move |(k, x)| x + by * (k as f64 / count as f64 - 0.5))
            };
            assert!(fits(slanted(0.0), 1) && !fits(slanted(3.0), 1), "{count}");
            // one is an outlier among many that are right
            let outlier = noise(3, count).into_iter().chain([6.0]);
            assert!(!fits(outlier, 1), "{count}");
        }
    }

    #[test]
    fn bounds_are_those_of_tables() {
        // chi-square at 99.5 %
        for (freedom, expected) in [(1, 7.879), (2, 10.597), (10, 25.188), (100, 140.169)] {
            assert!((largest_sum(freedom + 1, 1) / expected - 1.0).abs() < 1e-2, "{freedom}");
        }
        assert!((largest_deviation(1) - 3.0).abs() < 1e-12);
        assert!(
            (largest_deviation(1000) - 4.564_263).abs() < 1e-3,
            "{}",
            largest_deviation(1000)
        );
    }
}
