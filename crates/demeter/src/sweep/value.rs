//! Values as they are written: numbers, quantities, words.

use crate::scenario::units;
use demeter_physics::dimension::Dimension;

/// What a value is.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// A number with its unit, which is empty for a pure number.
    Number {
        /// The number, in that unit.
        number: f64,
        /// The unit as written.
        unit: String,
    },
    /// All else.
    Word(String),
}

/// Reads a value as `--set` does: TOML, else a text.
pub fn value_of(written: &str) -> Value {
    let written = written.trim();
    match written.parse::<toml::Value>() {
        Ok(toml::Value::Integer(number)) => Value::Number {
            number: number as f64,
            unit: String::new(),
        },
        Ok(toml::Value::Float(number)) => Value::Number {
            number,
            unit: String::new(),
        },
        Ok(toml::Value::String(text)) => of_text(text.trim()),
        Ok(other) => Value::Word(other.to_string()),
        Err(_) => of_text(written),
    }
}

/// What a value means: the same for every way to write it.
pub fn meaning(written: &str) -> String {
    match value_of(written) {
        Value::Number { number, unit } if unit.is_empty() => format!("{number:e} {:?}", Dimension::NONE),
        Value::Number { number, unit } => match units::parse(&unquoted(written)) {
            Ok(quantity) => format!("{:e} {:?}", quantity.value, quantity.dimension),
            Err(_) => format!("{number} {unit}"),
        },
        Value::Word(word) => word,
    }
}

/// The value without the quotes of a text.
pub fn unquoted(written: &str) -> String {
    match written.trim().parse::<toml::Value>() {
        Ok(toml::Value::String(text)) => text,
        _ => written.trim().to_string(),
    }
}

fn of_text(text: &str) -> Value {
    let is_quantity = units::parse(text).is_ok_and(|quantity| quantity.has_unit);
    let parts = units::split_number(text).ok().filter(|_| is_quantity);
    let number = parts.and_then(|(number, unit)| Some((number.parse().ok()?, unit)));
    match number {
        Some((number, unit)) => Value::Number {
            number,
            unit: unit.to_string(),
        },
        None => Value::Word(text.to_string()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_numbers_quantities_or_words() {
        let number = |number, unit: &str| Value::Number {
            number,
            unit: unit.to_string(),
        };
        let word = |text: &str| Value::Word(text.to_string());
        let cases = [
            ("0.5", number(0.5, "")),
            (" 1_000 ", number(1000.0, "")),
            ("1.5 mm", number(1.5, "mm")),
            ("\"30 deg\"", number(30.0, "deg")),
            ("50 %", number(50.0, "%")),
            ("hertz-tsuji", word("hertz-tsuji")),
            ("\"0 0 -9.81 m/s^2\"", word("0 0 -9.81 m/s^2")),
            ("[0, 0, 1]", word("[0, 0, 1]")),
            ("true", word("true")),
            ("2 apples", word("2 apples")),
        ];
        for (written, expected) in cases {
            assert_eq!(value_of(written), expected, "{written}");
        }
        assert_eq!(unquoted(" \"30 deg\" "), "30 deg");
        for (one, other, is_same) in [
            ("0.2", " 0.20", true),
            ("4 mm", "\"4000 um\"", true),
            ("50 %", "0.5", true),
            ("1 m", "1 kg", false),
            ("1 m", "1", false),
            ("linear", "\"linear\"", true),
        ] {
            assert_eq!(meaning(one) == meaning(other), is_same, "{one}, {other}");
        }
    }
}
