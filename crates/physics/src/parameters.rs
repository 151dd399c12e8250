//! Declaration of a law's parameters: one table gives the struct, its reader and its documentation.

use crate::dimension::Dimension;
use std::fmt;

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

/// What is known of one parameter of a law.
#[derive(Clone, Copy, Debug)]
pub struct ParameterInfo {
    /// Name, the same in the scenario, in Rust and in the documentation.
    pub name: &'static str,
    /// Dimension of the value.
    pub dimension: Dimension,
    /// A value that a user would typically give, in SI.
    pub typical: f64,
    /// Value taken when none is given; `None` when it must be given.
    pub default: Option<f64>,
    /// Allowed values.
    pub range: Range,
    /// One or two sentences.
    pub doc: &'static str,
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
}

impl ParameterError {
    /// Name of the parameter at fault.
    pub fn parameter(&self) -> &str {
        match self {
            Self::Missing { name, .. } | Self::OutOfRange { name, .. } => name,
            Self::Unknown { name, .. } => name,
        }
    }
}

/// Parameter values by name, in SI.
pub type Values = std::collections::BTreeMap<String, f64>;

/// Values in the order of `table`, or every fault found.
pub fn resolve(table: &[ParameterInfo], values: &Values) -> Result<Vec<f64>, Vec<ParameterError>> {
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
        match values.get(info.name).copied().or(info.default) {
            None => errors.push(ParameterError::Missing {
                name: info.name,
                doc: info.doc,
                typical: info.typical,
                unit: info.dimension.unit(),
            }),
            Some(value) if !info.range.contains(value) => errors.push(ParameterError::OutOfRange {
                name: info.name,
                value,
                unit: info.dimension.unit(),
                range: info.range,
            }),
            Some(value) => resolved.push(value),
        }
    }
    if errors.is_empty() { Ok(resolved) } else { Err(errors) }
}

/// Declares a law's parameters: struct, table and reader from one list.
///
/// ```
/// use demeter_physics::{dimension::Dimension, parameters::Range, params};
/// params! {
///     /// Parameters of a spring.
///     pub struct Spring {
///         stiffness: STIFFNESS, typical 1e4, default None, Range::POSITIVE, "Force per overlap";
///     }
/// }
/// let values = [("stiffness".to_string(), 250.0)].into();
/// assert_eq!(Spring::from_values(&values).unwrap().stiffness, 250.0);
/// assert_eq!(Spring::TABLE[0].dimension, Dimension::STIFFNESS);
/// ```
#[macro_export]
macro_rules! params {
    ($(#[$doc:meta])* pub struct $name:ident {
        $($field:ident: $dimension:ident, typical $typical:expr, default $default:expr, $range:expr, $text:literal;)*
    }) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct $name {
            $(#[doc = $text] pub $field: f64,)*
        }

        impl $name {
            /// Name, dimension, typical value, default, range and meaning of every parameter.
            pub const TABLE: &'static [$crate::parameters::ParameterInfo] = &[
                $($crate::parameters::ParameterInfo {
                    name: stringify!($field),
                    dimension: $crate::dimension::Dimension::$dimension,
                    typical: $typical,
                    default: $default,
                    range: $range,
                    doc: $text,
                },)*
            ];

            /// Reads the parameters from values in SI by name, or tells everything that is wrong with them.
            pub fn from_values(
                values: &$crate::parameters::Values,
            ) -> Result<Self, Vec<$crate::parameters::ParameterError>> {
                #[allow(unused_mut, unused_variables)]
                let mut resolved = $crate::parameters::resolve(Self::TABLE, values)?.into_iter();
                Ok(Self { $($field: resolved.next().unwrap_or(f64::NAN),)* })
            }
        }
    };
}

#[cfg(test)]
mod tests {
    use super::*;

    params! {
        /// For the tests below.
        pub struct Example {
            restitution: NONE, typical 0.9, default None, Range::POSITIVE_SHARE, "Coefficient of restitution";
            ratio: NONE, typical 0.3, default Some(0.5), Range::NOT_NEGATIVE, "A ratio";
        }
    }

    #[test]
    fn every_fault_is_told_at_once() {
        let values: Values = [("restitution".to_string(), 1.5), ("ratoi".to_string(), 1.0)].into();
        let errors = Example::from_values(&values).unwrap_err();
        let text: Vec<String> = errors.iter().map(ToString::to_string).collect();
        assert_eq!(
            text[0],
            "unknown parameter `ratoi`; the law takes `restitution`, `ratio`"
        );
        assert_eq!(text[1], "`restitution` is 1.5; it must be above 0 and at most 1");
    }

    #[test]
    fn a_default_stands_in_and_nan_is_refused() {
        let mut values: Values = [("restitution".to_string(), 0.5)].into();
        assert_eq!(
            Example::from_values(&values),
            Ok(Example {
                restitution: 0.5,
                ratio: 0.5
            })
        );
        values.insert("ratio".to_string(), f64::NAN);
        assert!(Example::from_values(&values).is_err());
    }
}
