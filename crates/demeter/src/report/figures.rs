//! Numbers as people write them.

use crate::output::ticks::si_prefix;

/// A number with four digits: `0.3507`, `1.862e6`; `–` for what is not a number.
pub(super) fn number(value: f64) -> String {
    if value.is_nan() {
        return "–".to_string();
    }
    if value.is_infinite() {
        return if value > 0.0 { "∞" } else { "−∞" }.to_string();
    }
    let size = value.abs();
    let text = if size == 0.0 {
        "0".to_string()
    } else if (1e-3..99_999.5).contains(&size) {
        let before = libm::floor(libm::log10(size)) as i32;
        let decimals = usize::try_from(3 - before).unwrap_or(0);
        let text = format!("{value:.decimals$}");
        if text.contains('.') {
            text.trim_end_matches('0').trim_end_matches('.').to_string()
        } else {
            text
        }
    } else {
        let text = format!("{value:.3e}");
        match text.split_once('e') {
            Some((digits, power)) if digits.contains('.') => {
                let digits = digits.trim_end_matches('0').trim_end_matches('.');
                format!("{digits}e{power}")
            }
            _ => text,
        }
    };
    text.replace('-', "−")
}

/// A whole number with its thousands parted.
pub(super) fn count(value: u64) -> String {
    let digits = value.to_string();
    let mut out = String::new();
    for (k, digit) in digits.chars().enumerate() {
        if k > 0 && (digits.len() - k).is_multiple_of(3) {
            out.push('\u{202f}');
        }
        out.push(digit);
    }
    out
}

/// The prefix with which numbers up to a size read best, and what it stands for.
pub(super) fn prefix(size: f64) -> (&'static str, f64) {
    match si_prefix(if size.is_finite() { size } else { 0.0 }) {
        ("u", factor) => ("µ", factor),
        other => other,
    }
}

/// A value with its SI unit, in the prefix with which it reads best.
pub(super) fn quantity(value: f64, unit: &str) -> String {
    let (prefix, factor) = prefix(value.abs());
    format!("{} {prefix}{unit}", number(value / factor))
}

/// A span of real time.
pub(super) fn wait(seconds: f64) -> String {
    if seconds < 60.0 {
        return quantity(seconds, "s");
    }
    // a run lasts for less than 2^53 seconds
    let whole = seconds.round() as u64;
    let (hours, minutes) = (whole / 3600, whole / 60 % 60);
    if hours == 0 {
        format!("{minutes} min {} s", whole % 60)
    } else {
        format!("{} h {minutes} min", count(hours))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_four_digits() {
        for (value, text) in [
            (0.0, "0"),
            (0.35071234, "0.3507"),
            (-8.034, "−8.034"),
            (12345.6, "12346"),
            (100.0, "100"),
            (1.8621e6, "1.862e6"),
            (-2e-5, "−2e−5"),
            (f64::NAN, "–"),
            (f64::INFINITY, "∞"),
        ] {
            assert_eq!(number(value), text);
        }
    }

    #[test]
    fn quantities_take_the_prefix_with_which_they_read_best() {
        assert_eq!(quantity(6.1246e-6, "s"), "6.125 µs");
        assert_eq!(quantity(0.0, "N"), "0 N");
        assert_eq!(quantity(-0.00441, "N"), "−4.41 mN");
        assert_eq!(quantity(23_300.0, "Pa"), "23.3 kPa");
        assert_eq!(quantity(1e-20, "J"), "1e−5 fJ");
        assert_eq!(quantity(f64::NAN, "J"), "– J");
        assert_eq!(quantity(0.99999, "m"), "1 m");
    }

    #[test]
    fn counts_and_waits() {
        assert_eq!(count(1_862_091), "1\u{202f}862\u{202f}091");
        assert_eq!(count(514), "514");
        assert_eq!(wait(85.8), "1 min 26 s");
        assert_eq!(wait(0.25), "250 ms");
        assert_eq!(wait(7_325.0), "2 h 2 min");
    }
}
