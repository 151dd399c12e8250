//! Units of the scenario: `"23.3 kPa"`, `"2 mm/min"`, `"9.81 m/s^2"`, `"60 rpm"`.
//!
//! A quantity is a number, a space and a unit; a unit is a product or quotient of symbols with SI prefixes and powers, whole ones or
//! halves. Decimal prefixes are put into the exponent of the number before it is read, so that `"9.3 mm"` has the bits
//! of `9.3e-3`.

use demeter_physics::dimension::Dimension;
use std::f64::consts::PI;

/// One row of the table of units.
#[derive(Clone, Copy, Debug)]
pub struct Unit {
    /// Symbol as written.
    pub symbol: &'static str,
    /// The SI value is `factor 10^tens`.
    pub factor: f64,
    /// Power of ten of the SI value.
    pub tens: i32,
    /// Dimension.
    pub dimension: Dimension,
    /// Power of the angle: 1 for `deg` and `rpm`, 0 for all that is no angle.
    pub angle: i8,
    /// Whether SI prefixes may stand before it.
    pub prefixes: bool,
    /// Name in words.
    pub name: &'static str,
}

const fn unit(symbol: &'static str, tens: i32, dimension: Dimension, name: &'static str) -> Unit {
    Unit {
        symbol,
        factor: 1.0,
        tens,
        dimension,
        angle: 0,
        prefixes: true,
        name,
    }
}

const fn plain(symbol: &'static str, factor: f64, tens: i32, dimension: Dimension, name: &'static str) -> Unit {
    Unit {
        symbol,
        factor,
        tens,
        dimension,
        angle: 0,
        prefixes: false,
        name,
    }
}

const fn angular(symbol: &'static str, factor: f64, dimension: Dimension, name: &'static str) -> Unit {
    Unit {
        symbol,
        factor,
        tens: 0,
        dimension,
        angle: 1,
        prefixes: false,
        name,
    }
}

const POWER: Dimension = Dimension::new(1, 2, -3);

/// All units.
pub const UNITS: &[Unit] = &[
    unit("m", 0, Dimension::LENGTH, "metre"),
    unit("g", -3, Dimension::MASS, "gram"),
    unit("s", 0, Dimension::TIME, "second"),
    unit("N", 0, Dimension::FORCE, "newton"),
    unit("Pa", 0, Dimension::PRESSURE, "pascal"),
    unit("bar", 5, Dimension::PRESSURE, "bar"),
    unit("J", 0, Dimension::ENERGY, "joule"),
    unit("W", 0, POWER, "watt"),
    unit("Hz", 0, Dimension::FREQUENCY, "hertz, cycles per second"),
    unit("L", -3, Dimension::VOLUME, "litre"),
    plain("t", 1.0, 3, Dimension::MASS, "tonne"),
    plain("min", 60.0, 0, Dimension::TIME, "minute"),
    plain("h", 3600.0, 0, Dimension::TIME, "hour"),
    plain("day", 86400.0, 0, Dimension::TIME, "day"),
    plain("in", 254.0, -4, Dimension::LENGTH, "inch"),
    plain("ft", 3048.0, -4, Dimension::LENGTH, "foot"),
    plain("lb", 0.453_592_37, 0, Dimension::MASS, "pound"),
    plain(
        "psi",
        6_894.757_293_168_361,
        0,
        Dimension::PRESSURE,
        "pound-force per square inch",
    ),
    angular("rad", 1.0, Dimension::NONE, "radian"),
    angular("deg", PI / 180.0, Dimension::NONE, "degree"),
    angular("rev", 2.0 * PI, Dimension::NONE, "revolution"),
    angular("rpm", 2.0 * PI / 60.0, Dimension::FREQUENCY, "revolutions per minute"),
];

/// SI prefixes and their powers of ten.
pub const PREFIXES: &[(&str, i32)] = &[
    ("f", -15),
    ("p", -12),
    ("n", -9),
    ("u", -6),
    ("µ", -6),
    ("μ", -6),
    ("m", -3),
    ("c", -2),
    ("d", -1),
    ("h", 2),
    ("k", 3),
    ("M", 6),
    ("G", 9),
    ("T", 12),
];

/// A number with its unit, in SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quantity {
    /// Value in SI; angles in radian.
    pub value: f64,
    /// Dimension.
    pub dimension: Dimension,
    /// Power of the angle in the unit: 1 for an angle or an angular velocity.
    pub angle: i8,
    /// Whether the text gave a unit (or `%`).
    pub has_unit: bool,
}

/// Why a quantity could not be read.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum UnitError {
    /// There is no number at the start.
    #[error("`{0}` does not begin with a number")]
    Number(String),
    /// The number is infinite, not a number, or beyond what a double holds.
    #[error("`{0}` is not a finite number")]
    NotFinite(String),
    /// A symbol is not in the table.
    #[error("unknown unit `{symbol}`")]
    Unknown {
        /// The symbol.
        symbol: String,
        /// A symbol that is close to it.
        suggestion: Option<String>,
    },
    /// The unit is not well formed.
    #[error("the unit `{unit}` cannot be read: {why}")]
    Form {
        /// The unit as written.
        unit: String,
        /// What is wrong with it.
        why: &'static str,
    },
}

/// Product of powers of units, as read.
#[derive(Clone, Copy, Debug)]
struct Product {
    multiplier: f64,
    divisor: f64,
    /// Twice the power of ten.
    half_tens: i32,
    /// Twice the exponents of kilogram, metre, second and angle.
    halves: [i32; 4],
}

impl Product {
    const ONE: Self = Self {
        multiplier: 1.0,
        divisor: 1.0,
        half_tens: 0,
        halves: [0; 4],
    };

    /// Times a unit to the power of half of `halves`.
    fn times(mut self, unit: &Unit, prefix: i32, halves: i32) -> Self {
        let side = if halves > 0 {
            &mut self.multiplier
        } else {
            &mut self.divisor
        };
        for _ in 0..halves.unsigned_abs() / 2 {
            *side *= unit.factor;
        }
        if halves % 2 != 0 {
            *side *= unit.factor.sqrt();
        }
        self.half_tens += (unit.tens + prefix) * halves;
        let [mass, length, time] = unit.dimension.halves();
        for (sum, of_one) in self.halves.iter_mut().zip([mass, length, time, 2 * unit.angle]) {
            // those of a unit are whole
            *sum += i32::from(of_one / 2) * halves;
        }
        self
    }

    /// The power of ten, and the root of ten where half of one is left.
    fn tens(&self) -> (i32, f64) {
        let root = if self.half_tens % 2 == 0 { 1.0 } else { 10.0_f64.sqrt() };
        (self.half_tens.div_euclid(2), root)
    }
}

/// Reads `"-2.64 nN"`: a number, then a unit or nothing or `%`.
pub fn parse(text: &str) -> Result<Quantity, UnitError> {
    let text = text.trim();
    let (number, unit) = split_number(text)?;
    let product = match unit {
        "" => Product::ONE,
        "%" => Product {
            half_tens: -4,
            ..Product::ONE
        },
        _ => parse_unit(unit)?,
    };
    let (tens, root) = product.tens();
    let value = decimal(number, tens)? * product.multiplier / product.divisor * root;
    if !value.is_finite() {
        return Err(UnitError::NotFinite(text.to_string()));
    }
    let form = |why| UnitError::Form {
        unit: unit.to_string(),
        why,
    };
    let [mass, length, time, angle] = product.halves;
    if angle % 2 != 0 {
        return Err(form("an angle has whole powers"));
    }
    let part = |halves: i32| i8::try_from(halves).map_err(|_| form("its powers are too high"));
    Ok(Quantity {
        value,
        dimension: Dimension::of_halves([part(mass)?, part(length)?, part(time)?]),
        angle: part(angle / 2)?,
        has_unit: !unit.is_empty(),
    })
}

/// Splits `"1e-5 s"` into the number and the rest.
pub(crate) fn split_number(text: &str) -> Result<(&str, &str), UnitError> {
    let first = text.split([' ', '\t']).next().unwrap_or("");
    let word = first.trim_start_matches(['+', '-']).to_ascii_lowercase();
    if ["nan", "inf", "infinity"].contains(&word.as_str()) {
        return Err(UnitError::NotFinite(first.to_string()));
    }
    // the longest start that reads as a number; a number is short, which bounds the work on a hostile text
    let candidates = text
        .char_indices()
        .take_while(|(_, c)| c.is_ascii_digit() || "+-.eE".contains(*c))
        .map(|(at, c)| at + c.len_utf8());
    let end = candidates
        .filter(|&end| text[..end].ends_with(|c: char| c.is_ascii_digit() || c == '.'))
        .take(MAX_DIGITS)
        .filter(|&end| text[..end].parse::<f64>().is_ok())
        .last()
        .ok_or_else(|| UnitError::Number(text.chars().take(MAX_DIGITS).collect()))?;
    Ok((&text[..end], text[end..].trim_start()))
}

/// Longest number that is read.
const MAX_DIGITS: usize = 64;

/// The number times a power of ten, rounded once.
fn decimal(number: &str, tens: i32) -> Result<f64, UnitError> {
    let not_finite = || UnitError::NotFinite(number.to_string());
    let (mantissa, exponent) = match number.find(['e', 'E']) {
        None => (number, 0),
        Some(at) => (
            &number[..at],
            number[at + 1..].parse::<i32>().map_err(|_| not_finite())?,
        ),
    };
    let exponent = i64::from(exponent) + i64::from(tens);
    let value: f64 = format!("{mantissa}e{exponent}").parse().map_err(|_| not_finite())?;
    if value.is_finite() {
        Ok(value)
    } else {
        Err(not_finite())
    }
}

/// Reads a unit expression: symbols joined by spaces, `*`, `·` or `/`, with powers and one level of brackets.
fn parse_unit(text: &str) -> Result<Product, UnitError> {
    let fail = |why| {
        Err(UnitError::Form {
            unit: text.to_string(),
            why,
        })
    };
    if text.len() > 100 {
        return fail("it is too long");
    }
    let mut product = Product::ONE;
    let mut rest = text;
    let mut sign = 1;
    let mut in_brackets = false;
    let mut divided = false;
    let mut expect_factor = true;
    while let Some(c) = rest.chars().next() {
        match c {
            ' ' | '*' | '·' => {
                // a product after a quotient is read differently by different people
                let trimmed = rest.trim_start_matches([' ', '*', '·']);
                if divided && !expect_factor && !in_brackets && !trimmed.starts_with(['/', ')']) && !trimmed.is_empty()
                {
                    return fail("a product after `/` is ambiguous, use brackets as in `N/(m s)`");
                }
                rest = trimmed;
                continue;
            }
            '/' if in_brackets || expect_factor => return fail("`/` is out of place"),
            '/' => {
                sign = -1;
                divided = true;
                expect_factor = true;
            }
            '(' if sign < 0 && expect_factor && !in_brackets => in_brackets = true,
            ')' if in_brackets && !expect_factor => {
                in_brackets = false;
                expect_factor = false;
            }
            '(' | ')' => return fail("brackets stand only around what follows a `/`"),
            _ => {
                let (factor, after) = parse_factor(rest, text)?;
                if let Some((unit, prefix, halves)) = factor {
                    product = product.times(unit, prefix, sign * halves);
                }
                expect_factor = false;
                rest = after;
                continue;
            }
        }
        rest = &rest[c.len_utf8()..];
    }
    if in_brackets || expect_factor {
        return fail("it ends too early");
    }
    Ok(product)
}

/// A unit with its power of ten from the prefix and twice its power.
type Factor = Option<(&'static Unit, i32, i32)>;

/// Reads one symbol with its power: `"s^2 ..."`; `1` is the numerator of `1/s`.
fn parse_factor<'t>(rest: &'t str, whole: &str) -> Result<(Factor, &'t str), UnitError> {
    let fail = |why| UnitError::Form {
        unit: whole.to_string(),
        why,
    };
    if let Some(after) = rest.strip_prefix('1') {
        if rest.len() == whole.len() && after.trim_start().starts_with('/') {
            return Ok((None, after));
        }
        return Err(fail("a `1` stands only at the start and right before `/`, as in `1/s`"));
    }
    let end = rest
        .find(|c: char| !(c.is_alphabetic() || c == '°'))
        .unwrap_or(rest.len());
    let (symbol, mut after) = rest.split_at(end);
    if symbol.is_empty() {
        return Err(fail("a unit symbol is expected"));
    }
    let (unit, prefix) = find(symbol).ok_or_else(|| UnitError::Unknown {
        symbol: symbol.to_string(),
        suggestion: suggest(symbol),
    })?;
    let mut halves = 2;
    if let Some((_, value)) = [('²', 4), ('³', 6)].into_iter().find(|(c, _)| after.starts_with(*c)) {
        halves = value;
        after = &after['²'.len_utf8()..];
    } else if let Some(exponent) = after.strip_prefix('^') {
        let end = exponent
            .char_indices()
            .find(|&(at, c)| !(c.is_ascii_digit() || c == '.' || (at == 0 && c == '-')))
            .map_or(exponent.len(), |(at, _)| at);
        let power: Option<f64> = exponent[..end].parse().ok().filter(|_| !exponent[..end].ends_with('.'));
        halves = (power.map(|power| 2.0 * power))
            .filter(|halves| (1.0..=18.0).contains(&halves.abs()) && halves.fract() == 0.0)
            .ok_or_else(|| fail("a power is a whole number or a half from -9 to 9, as in `m^3` or `m^1.5`"))?
            as i32;
        after = &exponent[end..];
    } else if after.starts_with(|c: char| c.is_ascii_digit()) {
        return Err(fail("write powers with `^`, as in `m^3`"));
    }
    Ok((Some((unit, prefix, halves)), after))
}

/// The unit of a symbol and the power of ten of its prefix.
fn find(symbol: &str) -> Option<(&'static Unit, i32)> {
    let symbol = if symbol == "°" { "deg" } else { symbol };
    if let Some(unit) = UNITS.iter().find(|u| u.symbol == symbol) {
        return Some((unit, 0));
    }
    PREFIXES.iter().find_map(|&(prefix, tens)| {
        let base = symbol.strip_prefix(prefix)?;
        let unit = UNITS.iter().find(|u| u.prefixes && u.symbol == base)?;
        Some((unit, tens))
    })
}

/// Names that people write in place of a symbol.
const WORDS: &[(&str, &str)] = &[
    ("sec", "s"),
    ("second", "s"),
    ("seconds", "s"),
    ("meter", "m"),
    ("metre", "m"),
    ("meters", "m"),
    ("metres", "m"),
    ("micron", "um"),
    ("microns", "um"),
    ("gram", "g"),
    ("grams", "g"),
    ("gr", "g"),
    ("newton", "N"),
    ("newtons", "N"),
    ("pascal", "Pa"),
    ("degree", "deg"),
    ("degrees", "deg"),
    ("hr", "h"),
    ("hour", "h"),
    ("hours", "h"),
    ("minute", "min"),
    ("minutes", "min"),
    ("inch", "in"),
    ("l", "L"),
    ("ml", "mL"),
];

/// A known symbol close to an unknown one.
fn suggest(symbol: &str) -> Option<String> {
    let lower = symbol.to_lowercase();
    if let Some((_, unit)) = WORDS.iter().find(|(word, _)| *word == lower) {
        return Some((*unit).to_string());
    }
    let joined = |at: usize| symbol.is_char_boundary(at) && find(&symbol[..at]).and(find(&symbol[at..])).is_some();
    if let Some(at) = (1..symbol.len()).find(|&at| joined(at)) {
        return Some(format!("{} {}", &symbol[..at], &symbol[at..]));
    }
    let common = ["k", "M", "m", "u", "n", "c", "G"];
    let prefixed = UNITS
        .iter()
        .filter(|u| u.prefixes)
        .flat_map(|u| common.iter().map(move |p| format!("{p}{}", u.symbol)));
    let all: Vec<String> = UNITS.iter().map(|u| u.symbol.to_string()).chain(prefixed).collect();
    if let Some(same) = all.iter().find(|s| s.to_lowercase() == lower) {
        return Some(same.clone());
    }
    (all.into_iter()
        .filter(|s| s.len() > 1 && strsim::osa_distance(s, symbol) == 1))
    .min_by_key(|s| s.len())
}

#[cfg(test)]
mod tests;
