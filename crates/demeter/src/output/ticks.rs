//! Round numbers for axes.

/// Round numbers that cover a range.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Ticks {
    /// The numbers, ascending, all inside the range.
    pub values: Vec<f64>,
    /// How they are written.
    pub labels: Vec<String>,
}

/// Distance between ticks: 1, 2 or 5 times a power of ten, for about `count` ticks.
fn step(span: f64, count: f64) -> (f64, i32) {
    let raw = span / count;
    let exponent = libm::floor(libm::log10(raw));
    let power = libm::pow(10.0, exponent);
    let mantissa = raw / power;
    let (factor, carry) = match mantissa {
        m if m <= 1.0 => (1.0, 0),
        m if m <= 2.0 => (2.0, 0),
        m if m <= 5.0 => (5.0, 0),
        _ => (1.0, 1),
    };
    // The exponent of an f64 fits an i32.
    let exponent = exponent as i32 + carry;
    (factor * libm::pow(10.0, f64::from(exponent)), exponent)
}

impl Ticks {
    /// About `count` round numbers inside a range.
    pub fn inside(low: f64, high: f64, count: f64) -> Self {
        let (step, exponent) = step(high - low, count);
        let first = libm::ceil(low / step - 1e-9);
        let last = libm::floor(high / step + 1e-9);
        let decimals = usize::try_from(-exponent).unwrap_or(0).min(12);
        let mut ticks = Self {
            values: Vec::new(),
            labels: Vec::new(),
        };
        let mut k = first;
        // A range so narrow that its ticks are the same number would go on for ever.
        while k <= last && ticks.values.len() < 100 {
            // Adding 0 turns -0 into 0.
            let value = k * step + 0.0;
            ticks.values.push(value);
            ticks.labels.push(format!("{value:.decimals$}"));
            k += 1.0;
        }
        ticks
    }
}

/// The next round number at or above a positive number.
pub(super) fn round_up(value: f64) -> f64 {
    let power = libm::pow(10.0, libm::floor(libm::log10(value)));
    let round = [1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0];
    let factor = round.into_iter().find(|f| f * power >= value * (1.0 - 1e-12));
    factor.unwrap_or(10.0) * power
}

/// Round numbers around a range that is no point.
pub(super) fn round_range(low: f64, high: f64) -> (f64, f64) {
    let (step, _) = step(high - low, 10.0);
    let (below, above) = (libm::floor(low / step + 1e-9), libm::ceil(high / step - 1e-9));
    (below * step, above * step)
}

/// The SI prefix with which a number of this magnitude is best written, and its value.
pub(crate) fn si_prefix(magnitude: f64) -> (&'static str, f64) {
    const PREFIXES: [(&str, f64); 9] = [
        ("G", 1e9),
        ("M", 1e6),
        ("k", 1e3),
        ("", 1.0),
        ("m", 1e-3),
        ("u", 1e-6),
        ("n", 1e-9),
        ("p", 1e-12),
        ("f", 1e-15),
    ];
    let fitting = PREFIXES.into_iter().find(|&(_, value)| magnitude >= 0.9999 * value);
    match fitting {
        Some(prefix) => prefix,
        None if magnitude > 0.0 => PREFIXES[8],
        None => PREFIXES[3],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_round_and_inside() {
        let ticks = Ticks::inside(0.0, 6.7, 5.0);
        assert_eq!(ticks.labels, ["0", "2", "4", "6"]);
        let ticks = Ticks::inside(-0.12, 0.31, 5.0);
        assert_eq!(ticks.labels, ["-0.1", "0.0", "0.1", "0.2", "0.3"]);
        let ticks = Ticks::inside(1e6, 1e6 + 1e-9, 5.0);
        assert!(ticks.values.len() <= 100);
    }

    #[test]
    fn prefixes_keep_numbers_readable() {
        assert_eq!(si_prefix(6.7).0, "");
        assert_eq!(si_prefix(0.02).0, "m");
        assert_eq!(si_prefix(23300.0).0, "k");
        assert_eq!(si_prefix(0.0).0, "");
        assert_eq!(si_prefix(1e-30).0, "f");
    }

    #[test]
    fn rounding_goes_up() {
        assert_eq!(round_up(6.7), 8.0);
        assert_eq!(round_up(8.0), 8.0);
        assert_eq!(round_up(0.011), 0.012);
        assert_eq!(round_up(98.0), 100.0);
        assert_eq!(round_range(2.3, 5.0), (2.0, 5.0));
        assert_eq!(round_range(4.0, 4.2), (4.0, 4.2));
    }
}
