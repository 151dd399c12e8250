//! Lists and ranges of values: `0.5,0.7,0.9`, `1 mm..3 mm:5`, `1e-3..1:4:log`.

use super::plan::MAX_RUNS;
use crate::scenario::units;

/// Digits of the values of a range.
const DIGITS: usize = 12;

/// Values of a list, and whether a range with equal ratios is in it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct List {
    /// The values as written, one by one.
    pub values: Vec<String>,
    /// Whether their ratios are equal, rather than their differences.
    pub logarithmic: bool,
}

/// Reads values between commas; commas in quotes and brackets separate none. The error tells what is wrong.
pub fn read_list(text: &str) -> Result<List, String> {
    let mut list = List::default();
    for item in split(text)? {
        let item = item.trim();
        if item.is_empty() {
            return Err("a value is missing: there is nothing before, between or behind commas".to_string());
        }
        match range(item)? {
            Some(range) => {
                list.values.extend(range.values);
                list.logarithmic |= range.logarithmic;
            }
            None => list.values.push(item.to_string()),
        }
        if list.values.len() > MAX_RUNS {
            return Err(format!("these are more than {MAX_RUNS} values"));
        }
    }
    Ok(list)
}

/// The items between commas.
fn split(text: &str) -> Result<Vec<&str>, String> {
    let (mut items, mut start) = (Vec::new(), 0);
    let (mut quote, mut escaped, mut open) = (None, false, Vec::new());
    for (at, c) in text.char_indices() {
        match (quote, c) {
            (Some('"'), _) if escaped => escaped = false,
            (Some('"'), '\\') => escaped = true,
            (Some(opening), _) if c == opening => quote = None,
            (Some(_), _) => {}
            // elsewhere a quotation mark is a letter
            (None, '"' | '\'') if !open.is_empty() || text[start..at].trim().is_empty() => quote = Some(c),
            (None, '[' | '{') => open.push(if c == '[' { ']' } else { '}' }),
            (None, ']' | '}') if open.last() == Some(&c) => {
                open.pop();
            }
            (None, ',') if open.is_empty() => {
                items.push(&text[start..at]);
                start = at + 1;
            }
            _ => {}
        }
    }
    if let Some(mark) = quote {
        return Err(format!("a quotation mark {mark} is not closed"));
    }
    if let Some(bracket) = open.last() {
        return Err(format!("a bracket is not closed: `{bracket}` is missing"));
    }
    items.push(&text[start..]);
    Ok(items)
}

/// The values of `FROM..TO:COUNT` or `FROM..TO:COUNT:log`; nothing where the item is no range.
fn range(item: &str) -> Result<Option<List>, String> {
    let Some((from, rest)) = item.split_once("..") else {
        return Ok(None);
    };
    // `../packing.csv` begins with no number
    if units::split_number(from.trim()).is_err() {
        return Ok(None);
    }
    let help = "a range is written `0.1..0.9:5` (five values, equal differences) or `0.001..1:4:log` (equal ratios); \
                put quotes around what is none";
    let mut parts = rest.split(':').map(str::trim);
    let (to, count, how) = (parts.next(), parts.next(), parts.next());
    let (Some(to), Some(count), None) = (to, count, parts.next()) else {
        return Err(format!("`{item}`: the number of values is missing; {help}"));
    };
    let logarithmic = match how {
        None => false,
        Some("log") => true,
        Some(other) => return Err(format!("`{item}`: `{other}` is not `log`; {help}")),
    };
    let count = count.parse().ok().filter(|n| (2..=MAX_RUNS).contains(n));
    let Some(count) = count else {
        return Err(format!(
            "`{item}`: the number of values must be from 2 to {MAX_RUNS}; {help}"
        ));
    };
    let ends = Ends::read(from.trim(), to).map_err(|why| format!("`{item}`: {why}"))?;
    if logarithmic && ends.from * ends.to <= 0.0 {
        return Err(format!(
            "`{item}`: equal ratios need two ends that are both above 0, or both below"
        ));
    }
    let values = (0..count).map(|k| ends.value(k, count, logarithmic)).collect();
    Ok(Some(List { values, logarithmic }))
}

/// The ends of a range, in one unit.
struct Ends {
    from: f64,
    to: f64,
    unit: String,
}

impl Ends {
    fn read(from: &str, to: &str) -> Result<Self, String> {
        let told = |error: units::UnitError| error.to_string();
        let (from_number, from_unit) = units::split_number(from).map_err(told)?;
        let (to_number, to_unit) = units::split_number(to).map_err(told)?;
        let number = |text: &str| text.parse::<f64>().map_err(|_| format!("`{text}` is no number"));
        let (mut start, end) = (number(from_number)?, number(to_number)?);
        let last = units::parse(to).map_err(told)?;
        if from_unit != to_unit && !from_unit.is_empty() {
            let first = units::parse(from).map_err(told)?;
            if (first.dimension, first.angle) != (last.dimension, last.angle) {
                return Err("its ends have different dimensions".to_string());
            }
            start = first.value / units::parse(&format!("1 {to_unit}")).map_err(told)?.value;
        }
        if !(start.is_finite() && end.is_finite()) || start == end {
            return Err("its ends must be two different numbers".to_string());
        }
        Ok(Self {
            from: start,
            to: end,
            unit: to_unit.to_string(),
        })
    }

    fn value(&self, k: usize, count: usize, logarithmic: bool) -> String {
        let share = k as f64 / (count - 1) as f64;
        let value = match (k, logarithmic) {
            (0, _) => self.from,
            (k, _) if k + 1 == count => self.to,
            (_, true) => self.from * libm::exp(share * libm::log(self.to / self.from)),
            (_, false) => self.from + share * (self.to - self.from),
        };
        format!("{} {}", written(value), self.unit).trim_end().to_string()
    }
}

/// A number without the last digits, in which `0.1 + 0.2` is not `0.3`.
fn written(value: f64) -> String {
    let rounded: f64 = format!("{value:.*e}", DIGITS - 1).parse().unwrap_or(value);
    if rounded == 0.0 {
        "0".to_string()
    } else if rounded.fract() == 0.0 && rounded.abs() < 1e15 {
        format!("{rounded:.0}")
    } else {
        format!("{rounded:?}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn values(text: &str) -> Vec<String> {
        read_list(text).unwrap_or_else(|fault| panic!("{text}: {fault}")).values
    }

    #[test]
    fn commas_in_quotes_and_brackets_separate_nothing() {
        assert_eq!(values("0.5, 0.7,0.9"), ["0.5", "0.7", "0.9"]);
        assert_eq!(values("\"a, b\",'c, d', e"), ["\"a, b\"", "'c, d'", "e"]);
        assert_eq!(values(r#""a\", b",c"#), [r#""a\", b""#, "c"]);
        assert_eq!(values("[0, 0, 1],[1, 0, 0]"), ["[0, 0, 1]", "[1, 0, 0]"]);
        assert_eq!(
            values("{ law = \"jkr\", x = [1, 2] },5"),
            ["{ law = \"jkr\", x = [1, 2] }", "5"]
        );
        assert_eq!(values("grain's,b"), ["grain's", "b"]);
        assert_eq!(values("../a.csv,../b.csv"), ["../a.csv", "../b.csv"]);
        assert_eq!(values("\"1..2:3\""), ["\"1..2:3\""]);
    }

    #[test]
    fn ranges_have_equal_differences_or_ratios() {
        assert_eq!(values("0.1..0.9:5"), ["0.1", "0.3", "0.5", "0.7", "0.9"]);
        assert_eq!(values("0..3:4,10"), ["0", "1", "2", "3", "10"]);
        assert_eq!(values("2..-2:5"), ["2", "1", "0", "-1", "-2"]);
        assert_eq!(values("1..2:4"), ["1", "1.33333333333", "1.66666666667", "2"]);
        assert_eq!(values("1e-3..1:4:log"), ["0.001", "0.01", "0.1", "1"]);
        assert_eq!(values("-1..-100:3:log"), ["-1", "-10", "-100"]);
        assert_eq!(values("1..2 mm:3"), ["1 mm", "1.5 mm", "2 mm"]);
        assert_eq!(values("500 um .. 2 mm:4"), ["0.5 mm", "1 mm", "1.5 mm", "2 mm"]);
        assert_eq!(values("1 MPa..100 MPa:3:log"), ["1 MPa", "10 MPa", "100 MPa"]);
        assert!(read_list("1..10:3:log").unwrap().logarithmic && !read_list("1..10:3").unwrap().logarithmic);
    }

    #[test]
    fn what_is_no_list_is_told() {
        let cases = [
            ("1,,2", "a value is missing"),
            ("", "a value is missing"),
            ("1,", "a value is missing"),
            ("\"a,b", "quotation mark \" is not closed"),
            ("[1,2", "`]` is missing"),
            (
                "0.1..0.9",
                "the number of values is missing; a range is written `0.1..0.9:5`",
            ),
            ("0.1..0.9:1", "must be from 2"),
            ("0.1..0.9:99999999", "must be from 2"),
            ("0.1..0.9:5:lin", "`lin` is not `log`"),
            ("0..1:5:log", "both above 0"),
            ("1 mm..2 s:3", "different dimensions"),
            ("1 mm..2:3", "different dimensions"),
            ("1..2 mn:3", "unknown unit `mn`"),
            ("3..3:2", "two different numbers"),
            ("1..x:2", "does not begin with a number"),
        ];
        for (text, expected) in cases {
            let fault = read_list(text).unwrap_err();
            assert!(fault.contains(expected), "{text}: {fault}");
        }
    }
}
