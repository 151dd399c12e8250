//! A coefficient of restitution as a function of the impact speed, as requested by a user.
//!
//! The law that is to meet it solves its damping for `e(v)` at the speed of each impact: the generalisation to "more complex
//! predefined profiles" that the last sentence of Antypov & Elliott (2011) asks for.

use std::sync::Arc;

use super::formula::Formula;

/// Most rows of a table.
pub const MOST_ROWS: usize = 1000;

/// Why a profile cannot be used.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ProfileError {
    /// A restitution outside (0, 1], constant or in a table.
    #[error("restitution{} is {value}; a coefficient of restitution must lie in (0, 1]", of_row(*.row))]
    Restitution {
        /// Row of the table, from 1; none for a constant.
        row: Option<usize>,
        /// The value given.
        value: f64,
    },
    /// A speed of a table that is not a positive number.
    #[error("speed of row {row} is {value} m/s; it must be a finite number above 0")]
    Speed {
        /// Row of the table, from 1.
        row: usize,
        /// The value given [m/s].
        value: f64,
    },
    /// A speed of a table that does not rise.
    #[error(
        "speed of row {row} is {value} m/s, but that of the row before is {before} m/s; speeds must rise from row to row"
    )]
    Order {
        /// Row of the table, from 1.
        row: usize,
        /// Speed of the row [m/s].
        value: f64,
        /// Speed of the row before [m/s].
        before: f64,
    },
    /// A table without rows, or with too many.
    #[error("the table has {rows} rows; it must have 1 to {MOST_ROWS}")]
    Rows {
        /// How many there are.
        rows: usize,
    },
    /// A formula that cannot be read.
    #[error("formula `{text}`, column {column}: {what}")]
    Formula {
        /// The formula.
        text: String,
        /// Where, in bytes from 1.
        column: usize,
        /// What is wrong there.
        what: String,
    },
    /// A profile that leaves (0, 1].
    #[error("restitution is {value} at an impact speed of {speed} m/s; it must stay in (0, 1] from {from} to {to} m/s{}", cut_at(*.value))]
    OutOfRange {
        /// Where [m/s].
        speed: f64,
        /// What the profile gives there.
        value: f64,
        /// Start of the range asked for [m/s].
        from: f64,
        /// End of the range asked for [m/s].
        to: f64,
    },
    /// A range of speeds that is none.
    #[error("the range of impact speeds is {from} to {to} m/s; it must rise from a number above 0 to a finite one")]
    Range {
        /// Start [m/s].
        from: f64,
        /// End [m/s].
        to: f64,
    },
}

/// How a formula is kept where it may be.
fn cut_at(value: f64) -> &'static str {
    if value > 1.0 {
        ", as `min(1, ...)` does"
    } else if value <= 0.0 {
        ", as `max(0.01, ...)` does"
    } else {
        ""
    }
}

fn of_row(row: Option<usize>) -> String {
    row.map_or(String::new(), |row| format!(" of row {row}"))
}

/// A requested coefficient of restitution at every impact speed. Cheap to clone.
#[derive(Clone, Debug, PartialEq)]
pub struct RestitutionProfile(Kind);

#[derive(Clone, Debug, PartialEq)]
enum Kind {
    Constant(f64),
    Table(Arc<[Knot]>),
    Formula(Arc<Formula>),
}

/// A row of a table: `e` and its slope over `ln v`.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Knot {
    speed: f64,
    log: f64,
    value: f64,
    slope: f64,
}

impl RestitutionProfile {
    /// The same restitution in (0, 1] at every speed.
    pub fn constant(restitution: f64) -> Result<Self, ProfileError> {
        check_share(None, restitution).map(|e| Self(Kind::Constant(e)))
    }

    /// Rows of impact speed [m/s], positive and rising, and restitution in (0, 1]; 1 to [`MOST_ROWS`] of them.
    ///
    /// Between the rows: the monotone cubic (PCHIP, Fritsch & Butland 1984) in `ln v`, since measured profiles are straight
    /// over decades of speed. It goes through every row, has a continuous slope and never leaves the range of the two rows
    /// it is between. Below the first row and above the last: constant.
    pub fn table(rows: &[[f64; 2]]) -> Result<Self, ProfileError> {
        if rows.is_empty() || rows.len() > MOST_ROWS {
            return Err(ProfileError::Rows { rows: rows.len() });
        }
        let mut knots: Vec<Knot> = Vec::with_capacity(rows.len());
        for (i, &[speed, value]) in rows.iter().enumerate() {
            let row = i + 1;
            if !(speed > 0.0 && speed.is_finite()) {
                return Err(ProfileError::Speed { row, value: speed });
            }
            let log = libm::log(speed);
            if let Some(before) = knots.last().filter(|before| log <= before.log) {
                return Err(ProfileError::Order {
                    row,
                    value: speed,
                    before: before.speed,
                });
            }
            knots.push(Knot {
                speed,
                log,
                value: check_share(Some(row), value)?,
                slope: 0.0,
            });
        }
        set_slopes(&mut knots);
        Ok(Self(Kind::Table(knots.into())))
    }

    /// A formula in the impact speed `v` [m/s]: numbers, `+ - * / ^`, parentheses, `exp`, `ln`, `sqrt`, `abs`, and `min` and
    /// `max` of two or more. `^` binds to the right and tighter than a sign before it: `-v^2 = -(v^2)`.
    ///
    /// Whether its values are restitutions is for [`Self::check`] to tell.
    pub fn formula(text: &str) -> Result<Self, ProfileError> {
        Formula::parse(text).map(|formula| Self(Kind::Formula(Arc::new(formula))))
    }

    /// The restitution at an impact speed [m/s].
    ///
    /// A formula gives what it gives, outside (0, 1] or not a number too: [`Self::check`] it before.
    pub fn at(&self, speed: f64) -> f64 {
        match &self.0 {
            Kind::Constant(e) => *e,
            Kind::Table(knots) => interpolate(knots, speed),
            Kind::Formula(formula) => formula.at(speed),
        }
    }

    /// The restitution if it is the same at every speed.
    pub fn as_constant(&self) -> Option<f64> {
        match &self.0 {
            Kind::Constant(e) => Some(*e),
            _ => None,
        }
    }

    /// The text of a formula.
    pub fn text(&self) -> Option<&str> {
        match &self.0 {
            Kind::Formula(formula) => Some(formula.text()),
            _ => None,
        }
    }

    /// Whether the restitution stays in (0, 1] over a range of impact speeds [m/s].
    ///
    /// Constants and tables do by construction. A formula is tried at [`SAMPLES`] speeds of equal ratio, and between the
    /// neighbours of its largest and smallest value among them: a spike narrower than the samples may be missed.
    pub fn check(&self, from: f64, to: f64) -> Result<(), ProfileError> {
        if !(from > 0.0 && from <= to && to.is_finite()) {
            return Err(ProfileError::Range { from, to });
        }
        let Kind::Formula(formula) = &self.0 else {
            return Ok(());
        };
        let good_at = |speed: f64| {
            let value = formula.at(speed);
            if value > 0.0 && value <= 1.0 {
                Ok(value)
            } else {
                Err(ProfileError::OutOfRange { speed, value, from, to })
            }
        };
        let (start, span) = (libm::log(from), libm::log(to) - libm::log(from));
        let speed_of = |place: f64| match place {
            first if first <= 0.0 => from,
            last if last >= f64::from(SAMPLES) => to,
            _ => libm::exp(start + span * place / f64::from(SAMPLES)),
        };
        let (mut least, mut most) = ([f64::INFINITY, 0.0], [f64::NEG_INFINITY, 0.0]);
        for i in 0..=SAMPLES {
            let value = good_at(speed_of(f64::from(i)))?;
            if value < least[0] {
                least = [value, f64::from(i)];
            }
            if value > most[0] {
                most = [value, f64::from(i)];
            }
        }
        for (sign, [_, place]) in [(1.0, least), (-1.0, most)] {
            let (mut low, mut high) = (place - 1.0, place + 1.0);
            for _ in 0..60 {
                let (left, right) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
                if sign * good_at(speed_of(left))? < sign * good_at(speed_of(right))? {
                    high = right;
                } else {
                    low = left;
                }
            }
        }
        Ok(())
    }
}

/// Intervals between the speeds at which [`RestitutionProfile::check`] tries a formula.
pub const SAMPLES: u32 = 4096;

fn check_share(row: Option<usize>, value: f64) -> Result<f64, ProfileError> {
    if value > 0.0 && value <= 1.0 {
        Ok(value)
    } else {
        Err(ProfileError::Restitution { row, value })
    }
}

/// Slopes of the monotone cubic: zero at an extreme row, else the weighted harmonic mean of the secants at both sides.
fn set_slopes(knots: &mut [Knot]) {
    let last = knots.len() - 1;
    if last == 0 {
        return;
    }
    let width: Vec<f64> = knots.windows(2).map(|w| w[1].log - w[0].log).collect();
    let secant: Vec<f64> = knots
        .windows(2)
        .map(|w| (w[1].value - w[0].value) / (w[1].log - w[0].log))
        .collect();
    for i in 1..last {
        let (before, after) = (secant[i - 1], secant[i]);
        if before * after > 0.0 {
            let (w1, w2) = (2.0 * width[i] + width[i - 1], width[i] + 2.0 * width[i - 1]);
            knots[i].slope = (w1 + w2) / (w1 / before + w2 / after);
        }
    }
    if last == 1 {
        knots[0].slope = secant[0];
        knots[1].slope = secant[0];
    } else {
        knots[0].slope = end_slope([width[0], width[1]], [secant[0], secant[1]]);
        knots[last].slope = end_slope([width[last - 1], width[last - 2]], [secant[last - 1], secant[last - 2]]);
    }
}

/// Slope at an end: the three-point formula, limited so that the cubic stays monotone.
fn end_slope(width: [f64; 2], secant: [f64; 2]) -> f64 {
    let slope = ((2.0 * width[0] + width[1]) * secant[0] - width[0] * secant[1]) / (width[0] + width[1]);
    if slope * secant[0] <= 0.0 {
        0.0
    } else if secant[0] * secant[1] <= 0.0 && slope.abs() > 3.0 * secant[0].abs() {
        3.0 * secant[0]
    } else {
        slope
    }
}

fn interpolate(knots: &[Knot], speed: f64) -> f64 {
    let after = knots.partition_point(|knot| knot.speed <= speed);
    let (Some(low), Some(high)) = (knots.get(after.wrapping_sub(1)), knots.get(after)) else {
        let end = if after == 0 { knots.first() } else { knots.last() };
        return end.map_or(f64::NAN, |knot| knot.value);
    };
    let width = high.log - low.log;
    let s = (libm::log(speed) - low.log) / width;
    let rest = 1.0 - s;
    let cubic = low.value * (1.0 + 2.0 * s) * rest * rest
        + high.value * (3.0 - 2.0 * s) * s * s
        + width * s * rest * (low.slope * rest - high.slope * s);
    cubic.clamp(low.value.min(high.value), low.value.max(high.value))
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use std::mem::size_of;

    #[test]
    fn a_table_goes_through_its_rows_and_is_constant_beyond() {
        let rows = [
            [0.01, 0.97],
            [0.1, 0.9],
            [0.5, 0.9],
            [2.0, 0.6],
            [9.0, 0.62],
            [10.0, 0.3],
        ];
        let profile = RestitutionProfile::table(&rows).unwrap();
        for [v, e] in rows {
            assert_eq!(profile.at(v), e);
        }
        assert_eq!((profile.at(0.0), profile.at(1e-9), profile.at(1e9)), (0.97, 0.97, 0.3));
        for pair in rows.windows(2) {
            let ([v0, e0], [v1, e1]) = (pair[0], pair[1]);
            let inside: Vec<f64> = (0..=200)
                .map(|i| profile.at(v0 * libm::pow(v1 / v0, f64::from(i) / 200.0)))
                .collect();
            let direction = e1 - e0;
            assert!(
                inside.windows(2).all(|w| (w[1] - w[0]) * direction >= -1e-15),
                "{v0} to {v1}"
            );
            assert!(inside.iter().all(|e| *e >= e0.min(e1) && *e <= e0.max(e1)));
        }
        // the slope is continuous at a row
        let slope = |v: f64| (profile.at(v * (1.0 + 1e-7)) - profile.at(v * (1.0 - 1e-7))) / 2e-7;
        assert_relative_eq!(slope(2.0 * (1.0 - 3e-7)), slope(2.0 * (1.0 + 3e-7)), epsilon = 1e-5);
        profile.check(1e-6, 1e6).unwrap();
    }

    #[test]
    fn a_line_in_the_logarithm_stays_a_line() {
        let line = |v: f64| 0.8 - 0.05 * libm::log(v);
        let rows: Vec<[f64; 2]> = [0.05, 0.3, 0.4, 7.0, 20.0].map(|v| [v, line(v)]).to_vec();
        let profile = RestitutionProfile::table(&rows).unwrap();
        for v in [0.051, 0.1, 0.35, 1.0, 19.0] {
            assert_relative_eq!(profile.at(v), line(v), max_relative = 1e-14);
        }
        let two = RestitutionProfile::table(&rows[..2]).unwrap();
        assert_relative_eq!(two.at(0.2), line(0.2), max_relative = 1e-14);
        assert_eq!(RestitutionProfile::table(&[[1.0, 0.5]]).unwrap().at(3.0), 0.5);
    }

    #[test]
    fn senseless_tables_are_refused_with_their_row() {
        let told = |rows: &[[f64; 2]]| RestitutionProfile::table(rows).unwrap_err().to_string();
        assert!(told(&[]).contains("0 rows"));
        assert!(told(&vec![[1.0, 0.5]; 1001]).contains("1001 rows"));
        assert!(told(&[[1.0, 0.5], [1.0, 0.4]]).contains("row 2"));
        assert!(told(&[[1.0, 0.5], [0.5, 0.4]]).contains("must rise"));
        assert!(told(&[[0.0, 0.5]]).contains("speed of row 1 is 0"));
        assert!(told(&[[f64::INFINITY, 0.5]]).contains("finite"));
        assert!(told(&[[1.0, 0.5], [2.0, 1.2]]).contains("restitution of row 2 is 1.2"));
        assert!(told(&[[1.0, f64::NAN]]).contains("(0, 1]"));
        let most: Vec<[f64; 2]> = (1..=1000).map(|i| [f64::from(i), 0.5]).collect();
        assert!(RestitutionProfile::table(&most).is_ok());
        assert!(
            RestitutionProfile::constant(0.0)
                .unwrap_err()
                .to_string()
                .contains("restitution is 0")
        );
    }

    #[test]
    fn a_formula_is_checked_over_a_range_of_speeds() {
        let falling = RestitutionProfile::formula("min(1, 0.9*(v/0.1)^(-1/5))").unwrap();
        assert_relative_eq!(falling.at(3.2), 0.45, max_relative = 1e-14);
        falling.check(1e-6, 1e3).unwrap();
        let negative = RestitutionProfile::formula("0.9 - 0.3*v").unwrap();
        negative.check(0.01, 2.9).unwrap();
        match negative.check(0.01, 10.0) {
            Err(ProfileError::OutOfRange { speed, value, .. }) => {
                assert!((3.0..3.01).contains(&speed) && value <= 0.0);
            }
            other => panic!("{other:?}"),
        }
        assert!(
            RestitutionProfile::formula("ln(v - 1)")
                .unwrap()
                .check(0.5, 2.0)
                .is_err()
        );
        // a top between two samples, a millionth of the range above 1
        let top = RestitutionProfile::formula("1 + 1e-9 - 1e-3*(v - 1.234567)^2").unwrap();
        assert!(top.check(0.5, 2.0).is_err());
        for (from, to) in [(0.0, 1.0), (2.0, 1.0), (1.0, f64::INFINITY), (f64::NAN, 1.0)] {
            assert!(matches!(falling.check(from, to), Err(ProfileError::Range { .. })));
        }
    }

    #[test]
    fn profiles_compare_by_content_and_travel_between_threads() {
        fn shared<T: Send + Sync + Clone>(value: T) -> T {
            value
        }
        let profile = shared(RestitutionProfile::formula("0.5 + 0*v").unwrap());
        assert_eq!(profile, RestitutionProfile::formula("0.5 + 0*v").unwrap());
        assert_ne!(profile, RestitutionProfile::constant(0.5).unwrap());
        assert_eq!(profile.text(), Some("0.5 + 0*v"));
        assert_eq!(RestitutionProfile::constant(0.5).unwrap().as_constant(), Some(0.5));
        assert!(size_of::<RestitutionProfile>() <= 24);
    }
}
