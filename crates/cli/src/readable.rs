//! Numbers as people read them.

use demeter::sweep::quoted;
use std::fmt::Display;
use std::time::Duration;

/// A word of a command to copy: in quotes where a shell would take it apart.
pub fn word(text: impl Display) -> String {
    let text = text.to_string();
    let is_plain = |c: char| c.is_alphanumeric() || "_-./=:,+@%".contains(c);
    match !text.is_empty() && text.chars().all(is_plain) {
        true => text,
        false => quoted(&text),
    }
}

/// A number with four significant digits, without trailing zeros.
pub fn number(value: f64) -> String {
    if value == 0.0 {
        return "0".to_string();
    }
    let scientific = format!("{value:.3e}");
    let exponent: Option<i32> = scientific
        .split_once('e')
        .and_then(|(_, exponent)| exponent.parse().ok());
    let Some(exponent @ -3..6) = exponent else {
        return scientific;
    };
    let decimals = (3 - exponent).max(0) as usize;
    let text = format!("{value:.decimals$}");
    match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_string(),
        false => text,
    }
}

/// Three numbers in brackets.
pub fn vector(values: [f64; 3]) -> String {
    let [x, y, z] = values.map(number);
    format!("({x}, {y}, {z})")
}

/// A whole number in groups of three digits.
pub fn count(value: u64) -> String {
    let digits = value.to_string();
    let mut text = String::new();
    for (index, digit) in digits.chars().enumerate() {
        if index > 0 && (digits.len() - index).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

/// A number of things: `1 grain`, `2 grains`.
pub fn things(value: u64, one: &str) -> String {
    format!("{} {one}{}", count(value), if value == 1 { "" } else { "s" })
}

/// A time that people wait, from seconds.
pub fn wait(seconds: f64) -> String {
    let Ok(duration) = Duration::try_from_secs_f64(seconds) else {
        return "very long".to_string();
    };
    let whole = duration.as_secs();
    match whole {
        0 => format!("{seconds:.2} s"),
        1..60 => format!("{seconds:.1} s"),
        60..3600 => format!("{} min {} s", whole / 60, whole % 60),
        3600..86_400 => format!("{} h {} min", whole / 3600, whole % 3600 / 60),
        _ => format!("{} d {} h", whole / 86_400, whole % 86_400 / 3600),
    }
}

/// A size of memory.
pub fn bytes(value: u64) -> String {
    let value = value as f64;
    match value {
        v if v < 1024.0 => format!("{v} bytes"),
        v if v < 1024.0 * 1024.0 => format!("{:.1} KiB", v / 1024.0),
        v if v < 1024.0 * 1024.0 * 1024.0 => format!("{:.1} MiB", v / (1024.0 * 1024.0)),
        v => format!("{:.1} GiB", v / (1024.0 * 1024.0 * 1024.0)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_of_commands_are_quoted_where_a_shell_takes_them_apart() {
        for (text, expected) in [
            ("runs/fall-sweep", "runs/fall-sweep"),
            ("slürm", "slürm"),
            ("kinetic energy", "'kinetic energy'"),
            ("it's", "'it'\\''s'"),
            ("", "''"),
        ] {
            assert_eq!(word(text), expected);
        }
    }

    #[test]
    fn numbers_keep_four_digits() {
        let cases = [
            (0.0, "0"),
            (1.0, "1"),
            (-9.81, "-9.81"),
            (123.456, "123.5"),
            (123_456.0, "123456"),
            (1e6, "1.000e6"),
            (0.123_456, "0.1235"),
            (0.012_346, "0.01235"),
            (0.001_234_6, "0.001235"),
            (1.2e-5, "1.200e-5"),
            (f64::NAN, "NaN"),
        ];
        for (value, text) in cases {
            assert_eq!(number(value), text, "{value:e}");
        }
    }

    #[test]
    fn waits_counts_and_sizes_read_well() {
        assert_eq!(
            [0.5, 59.9, 61.0, 3700.0, 90_000.0].map(wait),
            ["0.50 s", "59.9 s", "1 min 1 s", "1 h 1 min", "1 d 1 h"]
        );
        assert_eq!(wait(f64::INFINITY), "very long");
        assert_eq!([7, 999, 1000, 1_234_567].map(count), ["7", "999", "1,000", "1,234,567"]);
        assert_eq!(things(1, "grain"), "1 grain");
        assert_eq!(bytes(3 << 29), "1.5 GiB");
    }
}
