//! Values as messages tell them.

use crate::output::ticks::si_prefix;

/// A number of six digits, as a value is told that came from another unit.
pub(super) fn rounded(value: f64) -> f64 {
    format!("{value:.5e}").parse().unwrap_or(value)
}

/// A value with its unit, in the prefix with which it reads best.
pub(super) fn quantity(value: f64, unit: &str) -> String {
    let (prefix, factor) = si_prefix(value.abs());
    format!("{} {prefix}{unit}", rounded(value / factor))
}

/// A mass [kg].
pub(super) fn mass(value: f64) -> String {
    match value.abs() < 1.0 {
        true => quantity(1e3 * value, "g"),
        false => format!("{} kg", rounded(value)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn masses_keep_their_digits_however_small_or_large_they_are() {
        let cases = [
            (0.0, "0 g"),
            (4.188_790_204_786e-10, "418.879 ng"),
            (8.377_580_4e-6, "8.37758 mg"),
            (0.1, "100 g"),
            (1.0, "1 kg"),
            (1_234_567.8, "1234570 kg"),
        ];
        for (value, text) in cases {
            assert_eq!(mass(value), text, "{value:e}");
        }
        assert_eq!(quantity(-2.5e-5, "m"), "-25 um");
    }
}
