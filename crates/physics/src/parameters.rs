//! Declaration of a law's parameters: one table gives the struct, its reader and its documentation.

use crate::dimension::Dimension;
use crate::restitution::{ProfileError, RestitutionProfile};
use std::fmt;
use std::sync::{Mutex, PoisonError};

/// Interval of allowed values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// Lower end.
    pub lower: f64,
    /// Whether the lower end itself is allowed.
    pub lower_allowed: bool,
    /// Upper end.
    pub upper: f64,
    /// Whether the upper end itself is allowed.
    pub upper_allowed: bool,
}

impl Range {
    /// Any value above zero.
    pub const POSITIVE: Self = Self::new(0.0, false, f64::INFINITY, false);
    /// Zero and any value above it.
    pub const NOT_NEGATIVE: Self = Self::new(0.0, true, f64::INFINITY, false);
    /// Any finite value.
    pub const FINITE: Self = Self::new(f64::NEG_INFINITY, false, f64::INFINITY, false);
    /// `0 < x <= 1`.
    pub const POSITIVE_SHARE: Self = Self::new(0.0, false, 1.0, true);
    /// `0 <= x <= 1`.
    pub const SHARE: Self = Self::new(0.0, true, 1.0, true);

    /// Interval between two ends, each allowed or not.
    pub const fn new(lower: f64, lower_allowed: bool, upper: f64, upper_allowed: bool) -> Self {
        Self {
            lower,
            lower_allowed,
            upper,
            upper_allowed,
        }
    }

    /// Whether a value lies inside. A value that is not a number never does.
    pub fn contains(&self, value: f64) -> bool {
        value.is_finite()
            && (value > self.lower || (self.lower_allowed && value == self.lower))
            && (value < self.upper || (self.upper_allowed && value == self.upper))
    }
}

impl fmt::Display for Range {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let lower = (self.lower > f64::NEG_INFINITY).then(|| {
            format!(
                "{} {}",
                if self.lower_allowed { "at least" } else { "above" },
                self.lower
            )
        });
        let upper = (self.upper < f64::INFINITY).then(|| {
            format!(
                "{} {}",
                if self.upper_allowed { "at most" } else { "below" },
                self.upper
            )
        });
        match (lower, upper) {
            (Some(l), Some(u)) => write!(f, "{l} and {u}"),
            (Some(x), None) | (None, Some(x)) => f.write_str(&x),
            (None, None) => f.write_str("any finite number"),
        }
    }
}

/// What a parameter's value is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ParameterKind {
    /// A number with the parameter's dimension.
    Number,
    /// One of these words; the first is taken when none is given.
    Choice(&'static [&'static str]),
    /// A coefficient of restitution, constant or depending on the impact speed: a number, a table of rows
    /// `[speed, restitution]`, or a formula in `v`, the impact speed in m/s.
    Restitution,
}

/// A requested restitution.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Restitution {
    /// The same at every speed.
    Constant(f64),
    /// Depending on the impact speed.
    Profile(&'static RestitutionProfile),
}

/// Impact speeds between which a formula must give a coefficient of restitution [m/s].
const PROFILE_SPEEDS: (f64, f64) = (1e-6, 1e3);

impl Restitution {
    /// From the value of a parameter.
    fn read(value: &Value) -> Result<Self, ProfileError> {
        let profile = match value {
            Value::Number(e) => RestitutionProfile::constant(*e)?,
            Value::Table(rows) => RestitutionProfile::table(rows)?,
            Value::Text(formula) => RestitutionProfile::formula(formula)?,
        };
        profile.check(PROFILE_SPEEDS.0, PROFILE_SPEEDS.1)?;
        Ok(match profile.as_constant() {
            Some(e) => Self::Constant(e),
            None => Self::Profile(kept(profile)),
        })
    }

    /// The value of a parameter that [`resolve`] has accepted.
    pub fn of(values: &Values, name: &str) -> Option<Self> {
        Self::read(values.get(name)?).ok()
    }

    /// Restitution at an impact speed [m/s].
    pub fn at(&self, speed: f64) -> f64 {
        match self {
            Self::Constant(e) => *e,
            // beyond the speeds that were checked a formula may leave the range
            Self::Profile(profile) => profile.at(speed.clamp(PROFILE_SPEEDS.0, PROFILE_SPEEDS.1)),
        }
    }
}

/// One lasting copy of each profile in use, so that laws stay plain values.
fn kept(profile: RestitutionProfile) -> &'static RestitutionProfile {
    static KEPT: Mutex<Vec<&'static RestitutionProfile>> = Mutex::new(Vec::new());
    let mut all = KEPT.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(known) = all.iter().find(|known| ***known == profile) {
        return known;
    }
    let lasting: &'static RestitutionProfile = Box::leak(Box::new(profile));
    all.push(lasting);
    lasting
}

/// Whether a parameter must be given.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Presence {
    /// It must be given.
    Required,
    /// One of several alternatives, the one that most users give.
    Usual,
    /// One of several alternatives, or an extra.
    Optional,
    /// This value is taken when none is given (of a choice, its first word).
    Default(f64),
}

/// Parameters of which one tells the same thing as another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Alternatives {
    /// Those that exclude each other.
    pub of: &'static [&'static str],
    /// Those that only make sense beside some of them.
    pub with: &'static [&'static str],
}

/// What is known of one parameter of a law.
#[derive(Clone, Copy, Debug)]
pub struct ParameterInfo {
    /// Name, the same in the scenario, in Rust and in the documentation.
    pub name: &'static str,
    /// What its value is.
    pub kind: ParameterKind,
    /// Dimension of the value.
    pub dimension: Dimension,
    /// Whether it must be given.
    pub presence: Presence,
    /// A value that a user would typically give, in SI.
    pub typical: f64,
    /// Allowed values.
    pub range: Range,
    /// One or two sentences.
    pub doc: &'static str,
}

impl ParameterInfo {
    /// Whether an example of the law gives this parameter.
    pub fn in_example(&self) -> bool {
        matches!(self.presence, Presence::Required | Presence::Usual)
    }

    /// The number taken when none is given.
    pub fn default(&self) -> Option<f64> {
        match (self.kind, self.presence) {
            (ParameterKind::Number, Presence::Default(value)) => Some(value),
            _ => None,
        }
    }
}

/// Why the parameters of a law were refused.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ParameterError {
    /// A required parameter is not there.
    #[error("parameter `{name}` is missing: {doc}; a typical value is {typical} {unit}")]
    Missing {
        /// The parameter.
        name: &'static str,
        /// What it means.
        doc: &'static str,
        /// A typical value in SI.
        typical: f64,
        /// Its SI unit.
        unit: String,
    },
    /// The law has no parameter of this name.
    #[error("unknown parameter `{name}`; the law takes {known}")]
    Unknown {
        /// The name as given.
        name: String,
        /// Comma-separated known names.
        known: String,
    },
    /// The value is outside the allowed range.
    #[error("`{name}` is {value}{}{unit}; it must be {range}", if unit.is_empty() { "" } else { " " })]
    OutOfRange {
        /// The parameter.
        name: &'static str,
        /// The value as given, in SI.
        value: f64,
        /// Its SI unit.
        unit: String,
        /// The allowed range.
        range: Range,
    },
    /// The value is of the wrong kind, or no word of the choice.
    #[error("`{name}` must be {expected}, found {found}")]
    Kind {
        /// The parameter.
        name: &'static str,
        /// What is expected.
        expected: String,
        /// What was given.
        found: String,
    },
    /// A requested restitution that is none.
    #[error("`{name}`: {cause}")]
    Profile {
        /// The parameter.
        name: &'static str,
        /// What is wrong.
        cause: ProfileError,
    },
    /// Parameters that do not go together, or one of several alternatives that is missing.
    #[error("{message}")]
    Together {
        /// The first of them.
        name: &'static str,
        /// What is wrong and what to do.
        message: String,
    },
}

impl ParameterError {
    /// Name of the parameter at fault.
    pub fn parameter(&self) -> &str {
        match self {
            Self::Missing { name, .. }
            | Self::OutOfRange { name, .. }
            | Self::Kind { name, .. }
            | Self::Profile { name, .. }
            | Self::Together { name, .. } => name,
            Self::Unknown { name, .. } => name,
        }
    }

    /// Several parameters that do not go together; `name` is the first of them.
    pub fn together(name: &'static str, message: impl Into<String>) -> Vec<Self> {
        vec![Self::Together {
            name,
            message: message.into(),
        }]
    }
}

/// Value of a parameter.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub enum Value {
    /// A number in SI.
    Number(f64),
    /// A word of a choice, or a formula.
    Text(String),
    /// Rows of two numbers in SI.
    Table(Vec<[f64; 2]>),
}

impl From<f64> for Value {
    fn from(value: f64) -> Self {
        Self::Number(value)
    }
}

impl From<&str> for Value {
    fn from(text: &str) -> Self {
        Self::Text(text.to_string())
    }
}

/// Parameter values by name, in SI.
pub type Values = std::collections::BTreeMap<String, Value>;

/// Values from pairs of name and number.
pub fn values(pairs: &[(&str, f64)]) -> Values {
    pairs
        .iter()
        .map(|(name, x)| ((*name).to_string(), (*x).into()))
        .collect()
}

/// Values in the order of `table` (`None` where an alternative is not given), or every fault found.
pub fn resolve(table: &[ParameterInfo], values: &Values) -> Result<Vec<Option<f64>>, Vec<ParameterError>> {
    let mut errors: Vec<ParameterError> = values
        .keys()
        .filter(|name| table.iter().all(|p| p.name != name.as_str()))
        .map(|name| ParameterError::Unknown {
            name: name.clone(),
            known: if table.is_empty() {
                "none".to_string()
            } else {
                table
                    .iter()
                    .map(|p| format!("`{}`", p.name))
                    .collect::<Vec<_>>()
                    .join(", ")
            },
        })
        .collect();
    let mut resolved = Vec::with_capacity(table.len());
    for info in table {
        match one(info, values.get(info.name)) {
            Ok(value) => resolved.push(value),
            Err(error) => errors.push(error),
        }
    }
    if errors.is_empty() { Ok(resolved) } else { Err(errors) }
}

/// The value of one parameter; of a choice, the place of its word.
fn one(info: &ParameterInfo, given: Option<&Value>) -> Result<Option<f64>, ParameterError> {
    let name = info.name;
    match (info.kind, given) {
        (ParameterKind::Choice(words), given) => {
            let found = match given {
                None => return Ok(Some(0.0)),
                Some(Value::Text(word)) => match words.iter().position(|w| w == word) {
                    Some(place) => return Ok(Some(place as f64)),
                    None => format!("`{word}`"),
                },
                Some(Value::Number(x)) => x.to_string(),
                Some(Value::Table(_)) => "a table".to_string(),
            };
            let known: Vec<String> = words.iter().map(|w| format!("\"{w}\"")).collect();
            let expected = known.join(" or ");
            Err(ParameterError::Kind { name, expected, found })
        }
        (ParameterKind::Number, Some(Value::Number(value))) => {
            if info.range.contains(*value) {
                Ok(Some(*value))
            } else {
                Err(ParameterError::OutOfRange {
                    name,
                    value: *value,
                    unit: info.dimension.unit(),
                    range: info.range,
                })
            }
        }
        (ParameterKind::Number, Some(other)) => Err(ParameterError::Kind {
            name,
            expected: "a number".to_string(),
            found: match other {
                Value::Text(text) => format!("`{text}`"),
                _ => "a table".to_string(),
            },
        }),
        (ParameterKind::Restitution, Some(Value::Number(e))) if !info.range.contains(*e) => {
            Err(ParameterError::OutOfRange {
                name,
                value: *e,
                unit: String::new(),
                range: info.range,
            })
        }
        (ParameterKind::Restitution, Some(value)) => match Restitution::read(value) {
            Ok(_) => Ok(None),
            Err(cause) => Err(ParameterError::Profile { name, cause }),
        },
        (ParameterKind::Restitution, None) => Ok(None),
        (ParameterKind::Number, None) => match info.presence {
            Presence::Default(value) => Ok(Some(value)),
            Presence::Usual | Presence::Optional => Ok(None),
            Presence::Required => Err(ParameterError::Missing {
                name,
                doc: info.doc,
                typical: info.typical,
                unit: info.dimension.unit(),
            }),
        },
    }
}

/// Declares a law's parameters: struct, table and reader from one list.
///
/// Every line is `name: DIMENSION, presence value, in range, "meaning";`. The presence is `required`, `usual` or
/// `optional` with a typical value, or `default` with the default. A choice between words is
/// `name: NONE, choice ["first", "second"], "meaning";` and gives the place of the word. With `profile` and a typical
/// number it is a [`Restitution`], one of several alternatives.
///
/// ```
/// use demeter_physics::{dimension::Dimension, parameters::{Range, values}, params};
/// params! {
///     /// Parameters of a spring.
///     pub struct Spring {
///         stiffness: STIFFNESS, required 1e4, in Range::POSITIVE, "Force per overlap";
///         restitution: NONE, optional 0.9, in Range::POSITIVE_SHARE, "Coefficient of restitution";
///         end: NONE, choice ["zero-overlap", "zero-force"], "Where contact ends";
///     }
/// }
/// let spring = Spring::from_values(&values(&[("stiffness", 250.0)])).unwrap();
/// assert_eq!((spring.stiffness, spring.restitution, spring.end), (250.0, None, 0));
/// assert_eq!(Spring::TABLE[0].dimension, Dimension::STIFFNESS);
/// ```
#[macro_export]
macro_rules! params {
    ($(#[$doc:meta])* pub struct $name:ident {
        $($field:ident: $dimension:ident, $presence:ident $value:expr $(, in $range:expr)?, $text:literal;)*
    }) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct $name {
            $(#[doc = $text] pub $field: $crate::params!(@type $presence),)*
        }

        impl $name {
            /// Name, kind, dimension, presence, range and meaning of every parameter.
            pub const TABLE: &'static [$crate::parameters::ParameterInfo] = &[
                $($crate::params!(@info $presence, stringify!($field), $crate::dimension::Dimension::$dimension,
                    $value, [$($range)?], $text),)*
            ];

            /// Reads the parameters from values in SI by name, or tells everything that is wrong with them.
            pub fn from_values(
                values: &$crate::parameters::Values,
            ) -> Result<Self, Vec<$crate::parameters::ParameterError>> {
                #[allow(unused_mut, unused_variables)]
                let mut resolved = $crate::parameters::resolve(Self::TABLE, values)?.into_iter().map(Some);
                Ok(Self {
                    $($field: $crate::params!(@read $presence, resolved.next().flatten().flatten(), values,
                        stringify!($field)),)*
                })
            }
        }
    };
    (@type required) => { f64 };
    (@type default) => { f64 };
    (@type usual) => { Option<f64> };
    (@type optional) => { Option<f64> };
    (@type choice) => { usize };
    (@type profile) => { Option<$crate::parameters::Restitution> };
    (@read required, $value:expr, $values:expr, $name:expr) => { $value.unwrap_or(f64::NAN) };
    (@read default, $value:expr, $values:expr, $name:expr) => { $value.unwrap_or(f64::NAN) };
    (@read usual, $value:expr, $values:expr, $name:expr) => { $value };
    (@read optional, $value:expr, $values:expr, $name:expr) => { $value };
    (@read choice, $value:expr, $values:expr, $name:expr) => { $value.unwrap_or(0.0) as usize };
    (@read profile, $value:expr, $values:expr, $name:expr) => {{
        let _ = $value;
        $crate::parameters::Restitution::of($values, $name)
    }};
    (@info choice, $name:expr, $dimension:expr, $words:expr, [], $text:expr) => {
        $crate::parameters::ParameterInfo {
            name: $name,
            kind: $crate::parameters::ParameterKind::Choice(&$words),
            dimension: $dimension,
            presence: $crate::parameters::Presence::Default(0.0),
            typical: 0.0,
            range: $crate::parameters::Range::NOT_NEGATIVE,
            doc: $text,
        }
    };
    (@info $presence:ident, $name:expr, $dimension:expr, $typical:expr, [$range:expr], $text:expr) => {
        $crate::parameters::ParameterInfo {
            name: $name,
            kind: $crate::params!(@kind $presence),
            dimension: $dimension,
            presence: $crate::params!(@presence $presence, $typical),
            typical: $typical,
            range: $range,
            doc: $text,
        }
    };
    (@kind profile) => { $crate::parameters::ParameterKind::Restitution };
    (@kind $other:ident) => { $crate::parameters::ParameterKind::Number };
    (@presence profile, $value:expr) => { $crate::parameters::Presence::Usual };
    (@presence required, $value:expr) => { $crate::parameters::Presence::Required };
    (@presence usual, $value:expr) => { $crate::parameters::Presence::Usual };
    (@presence optional, $value:expr) => { $crate::parameters::Presence::Optional };
    (@presence default, $value:expr) => { $crate::parameters::Presence::Default($value) };
}

#[cfg(test)]
mod tests {
    use super::*;

    params! {
        /// For the tests below.
        pub struct Example {
            restitution: NONE, required 0.9, in Range::POSITIVE_SHARE, "Coefficient of restitution";
            ratio: NONE, default 0.5, in Range::NOT_NEGATIVE, "A ratio";
            speed: VELOCITY, usual 1.0, in Range::POSITIVE, "A speed";
            end: NONE, choice ["hard", "soft"], "An end";
        }
    }

    #[test]
    fn every_fault_is_told_at_once() {
        let mut wrong = values(&[("restitution", 1.5), ("ratoi", 1.0)]);
        wrong.insert("end".to_string(), "medium".into());
        wrong.insert("speed".to_string(), "quick".into());
        let errors = Example::from_values(&wrong).unwrap_err();
        let text: Vec<String> = errors.iter().map(ToString::to_string).collect();
        assert_eq!(
            text,
            [
                "unknown parameter `ratoi`; the law takes `restitution`, `ratio`, `speed`, `end`",
                "`restitution` is 1.5; it must be above 0 and at most 1",
                "`speed` must be a number, found `quick`",
                "`end` must be \"hard\" or \"soft\", found `medium`",
            ]
        );
    }

    #[test]
    fn a_default_stands_in_and_nan_is_refused() {
        let mut given = values(&[("restitution", 0.5)]);
        let expected = Example {
            restitution: 0.5,
            ratio: 0.5,
            speed: None,
            end: 0,
        };
        assert_eq!(Example::from_values(&given), Ok(expected));
        given.insert("end".to_string(), "soft".into());
        assert_eq!(Example::from_values(&given), Ok(Example { end: 1, ..expected }));
        given.insert("ratio".to_string(), f64::NAN.into());
        assert!(Example::from_values(&given).is_err());
    }
}
