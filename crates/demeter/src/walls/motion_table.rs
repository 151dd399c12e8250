//! A motion told by a table of times.
//!
//! Between two rows at `t0` and `t1 = t0 + h`, with `u = (t - t0)/h`:
//!
//! * *linear*: `x = x0 + u (x1 - x0)`; the velocity jumps at the rows
//! * *smooth*: the monotone cubic of M. Steffen, Astronomy and Astrophysics 239 (1990) 443, eqs. 2-11: continuous velocity,
//!   and no overshoot beyond the rows. The slope at a row is `(sign s0 + sign s1) min(|s0|, |s1|, |p|/2)` with the slopes
//!   `s` of the chords before and behind it and `p = (s0 h1 + s1 h0)/(h0 + h1)`. At the first and last row the wall rests;
//!   in a table that repeats both have the slope that follows from their neighbours; one that goes on does so with the slope
//!   of its last chord.
//! * *rates*: the rows tell velocities, which are linear in between; the place is their exact integral
//!
//! Places count from the first row, so a wall never jumps when a motion is told, nor when a table begins again.

use super::error::WallError;
use glam::DVec3;
use serde::{Deserialize, Serialize};

/// Most rows of a table.
pub const MAX_TABLE_ROWS: usize = 100_000;

/// What rows tell, and what happens between them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Interpolation {
    /// Places, joined by straight lines.
    Linear,
    /// Places, joined by monotone cubics.
    Smooth,
    /// Velocities, joined by straight lines.
    Rates,
}

/// What happens after the last row.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum AtEnd {
    /// The wall stays there.
    Hold,
    /// The table begins again from where the wall is.
    Repeat,
    /// The wall goes on with its last velocity.
    GoOn,
}

/// Rows of a table: displacement in x, y, z [m] and angle [rad], or their rates [m/s, 1/s].
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TableRows {
    /// Times since the start of the motion, rising [s].
    pub times: Vec<f64>,
    /// Values of every row.
    pub values: Vec<[f64; 4]>,
}

/// A motion told by a table: the wall turns by an angle about an axis, and then moves by a displacement.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct MotionTable {
    times: Vec<f64>,
    /// Displacement and angle at every row, from the first on.
    places: Vec<[f64; 4]>,
    /// Rates at every row; empty where the table is linear.
    rates: Vec<[f64; 4]>,
    interpolation: Interpolation,
    at_end: AtEnd,
    /// A point of the axis of the angle [m] and its direction.
    axis: Option<(DVec3, DVec3)>,
}

impl MotionTable {
    /// A table ready for use, or what is wrong with it. `axis`: a point of the axis of the angle and its direction.
    pub fn new(
        rows: TableRows,
        interpolation: Interpolation,
        at_end: AtEnd,
        axis: Option<(DVec3, DVec3)>,
    ) -> Result<Self, WallError> {
        let TableRows { times, values } = rows;
        let count = times.len();
        if !(2..=MAX_TABLE_ROWS).contains(&count) || values.len() != count {
            return Err(WallError::TableRows { rows: count });
        }
        let rises = times[0] >= 0.0 && times.windows(2).all(|t| t[0] < t[1]) && times[count - 1].is_finite();
        let finite = values.iter().flatten().all(|x| x.abs() <= super::limits::LARGEST);
        if !rises || !finite {
            return Err(WallError::TableOrder);
        }
        let (places, rates) = match interpolation {
            Interpolation::Rates => (integrals(&times, &values), values),
            Interpolation::Linear => (from_first(&values), Vec::new()),
            Interpolation::Smooth => {
                let places = from_first(&values);
                let slopes = smooth_slopes(&times, &places, at_end);
                (places, slopes)
            }
        };
        Ok(Self {
            times,
            places,
            rates,
            interpolation,
            at_end,
            axis,
        })
    }

    /// Whether its columns fit each other, as they do unless a file was tampered with.
    pub(super) fn is_whole(&self) -> bool {
        let rows = self.times.len();
        let rates = if self.interpolation == Interpolation::Linear {
            0
        } else {
            rows
        };
        rows >= 2 && self.places.len() == rows && self.rates.len() == rates
    }

    /// A point of the axis of the angle [m] and its direction.
    pub fn axis(&self) -> Option<(DVec3, DVec3)> {
        self.axis
    }

    /// Whether it displaces anything along a coordinate axis.
    pub fn is_shifted(&self, axis: usize) -> bool {
        self.places.iter().any(|place| place[axis] != 0.0)
    }

    /// Displacement and angle, and their rates, at a time since the start of the motion.
    pub fn at(&self, time: f64) -> ([f64; 4], [f64; 4]) {
        let last = self.times.len() - 1;
        let (first_time, last_time) = (self.times[0], self.times[last]);
        if time < first_time {
            return ([0.0; 4], [0.0; 4]);
        }
        if time < last_time {
            return self.within(time);
        }
        let end = self.places[last];
        match self.at_end {
            AtEnd::Hold => (end, [0.0; 4]),
            AtEnd::GoOn => {
                let rates = self.rates_behind(last - 1, self.times[last] - self.times[last - 1]);
                let ahead = time - last_time;
                (std::array::from_fn(|k| end[k] + rates[k] * ahead), rates)
            }
            AtEnd::Repeat => {
                let period = last_time - first_time;
                let rounds = ((time - first_time) / period).floor();
                let inside = (time - first_time - rounds * period).clamp(0.0, period);
                let (place, rates) = self.within(first_time + inside);
                (std::array::from_fn(|k| place[k] + rounds * end[k]), rates)
            }
        }
    }

    /// Whether nothing more happens behind the last row.
    pub fn comes_to_rest(&self) -> bool {
        self.at_end == AtEnd::Hold
    }

    /// Whether the last row is over and nothing more happens.
    pub fn is_over(&self, time: f64) -> bool {
        self.comes_to_rest() && self.times.last().is_some_and(|end| time >= *end)
    }

    /// Largest speed of the displacement [m/s].
    pub fn largest_speed(&self) -> f64 {
        self.steepest(length)
    }

    /// Largest angular velocity [1/s].
    pub fn largest_rate(&self) -> f64 {
        self.steepest(|rates| rates[3].abs())
    }

    /// The largest of what a measure makes of the rates at any time.
    fn steepest(&self, measure: impl Fn(&[f64; 4]) -> f64) -> f64 {
        let mut largest = 0.0f64;
        for row in 0..self.times.len() - 1 {
            let h = self.times[row + 1] - self.times[row];
            let chord: [f64; 4] = std::array::from_fn(|k| (self.places[row + 1][k] - self.places[row][k]) / h);
            // a cubic between slopes of one sign is nowhere steeper than this
            let factor = if self.interpolation == Interpolation::Smooth {
                1.5
            } else {
                1.0
            };
            largest = largest.max(factor * measure(&chord));
        }
        self.rates.iter().map(measure).fold(largest, f64::max)
    }

    /// Shortest time between two rows at which a displacement or the angle turns back [s]; `None` where none turns back twice.
    pub fn shortest_way(&self) -> Option<f64> {
        let last = self.times.len() - 1;
        let repeats = self.at_end == AtEnd::Repeat;
        let period = self.times[last] - self.times[0];
        let of_one = |k: usize| {
            let ways = self.places.windows(2).map(|rows| rows[1][k] - rows[0][k]);
            // a wall that waits turns back where it sets out again
            let ways: Vec<(f64, f64)> = ways
                .zip(self.times.iter().copied())
                .filter(|(way, _)| *way != 0.0)
                .collect();
            let turns = |pair: &[(f64, f64)]| (pair[0].0 * pair[1].0 < 0.0).then_some(pair[1].1);
            let mut at: Vec<f64> = ways.windows(2).filter_map(turns).collect();
            if let (true, Some(first), Some(end)) = (repeats, ways.first(), ways.last()) {
                at.extend((first.0 * end.0 < 0.0).then_some(first.1 + period));
                at.extend(at.first().map(|first| first + period));
            }
            at.windows(2).map(|times| times[1] - times[0]).reduce(f64::min)
        };
        (0..4).filter_map(of_one).reduce(f64::min)
    }

    /// At a time from the first row up to the last.
    fn within(&self, time: f64) -> ([f64; 4], [f64; 4]) {
        let behind = self.times.partition_point(|t| *t <= time);
        let row = behind.saturating_sub(1).min(self.times.len() - 2);
        let since = time - self.times[row];
        (self.place_behind(row, since), self.rates_behind(row, since))
    }

    fn place_behind(&self, row: usize, since: f64) -> [f64; 4] {
        let h = self.times[row + 1] - self.times[row];
        let u = since / h;
        std::array::from_fn(|k| {
            let (x0, x1) = (self.places[row][k], self.places[row + 1][k]);
            match self.interpolation {
                Interpolation::Linear => x0 + u * (x1 - x0),
                Interpolation::Rates => {
                    let (v0, v1) = (self.rates[row][k], self.rates[row + 1][k]);
                    x0 + since * (v0 + 0.5 * u * (v1 - v0))
                }
                Interpolation::Smooth => {
                    let (m0, m1) = (self.rates[row][k] * h, self.rates[row + 1][k] * h);
                    let rise = x1 - x0;
                    x0 + u * (m0 + u * (3.0 * rise - 2.0 * m0 - m1 + u * (m0 + m1 - 2.0 * rise)))
                }
            }
        })
    }

    fn rates_behind(&self, row: usize, since: f64) -> [f64; 4] {
        let h = self.times[row + 1] - self.times[row];
        let u = since / h;
        std::array::from_fn(|k| {
            let rise = self.places[row + 1][k] - self.places[row][k];
            match self.interpolation {
                Interpolation::Linear => rise / h,
                Interpolation::Rates => {
                    let (v0, v1) = (self.rates[row][k], self.rates[row + 1][k]);
                    v0 + u * (v1 - v0)
                }
                Interpolation::Smooth => {
                    let (m0, m1) = (self.rates[row][k] * h, self.rates[row + 1][k] * h);
                    (m0 + u * (2.0 * (3.0 * rise - 2.0 * m0 - m1) + 3.0 * u * (m0 + m1 - 2.0 * rise))) / h
                }
            }
        })
    }
}

fn length(rates: &[f64; 4]) -> f64 {
    DVec3::new(rates[0], rates[1], rates[2]).length()
}

fn from_first(values: &[[f64; 4]]) -> Vec<[f64; 4]> {
    let first = values[0];
    values
        .iter()
        .map(|v| std::array::from_fn(|k| v[k] - first[k]))
        .collect()
}

/// Places at the rows: the integrals of the velocities.
fn integrals(times: &[f64], rates: &[[f64; 4]]) -> Vec<[f64; 4]> {
    let mut place = [0.0; 4];
    let mut places = vec![place];
    for (t, v) in times.windows(2).zip(rates.windows(2)) {
        for (k, x) in place.iter_mut().enumerate() {
            *x += 0.5 * (v[0][k] + v[1][k]) * (t[1] - t[0]);
        }
        places.push(place);
    }
    places
}

/// Slopes of the monotone cubics at the rows.
fn smooth_slopes(times: &[f64], places: &[[f64; 4]], at_end: AtEnd) -> Vec<[f64; 4]> {
    let last = times.len() - 1;
    let width = |row: usize| times[row + 1] - times[row];
    let chord = |row: usize, k: usize| (places[row + 1][k] - places[row][k]) / width(row);
    let slope = |before: usize, behind: usize, k: usize| {
        let (s0, s1, h0, h1) = (chord(before, k), chord(behind, k), width(before), width(behind));
        if s0 * s1 <= 0.0 {
            return 0.0;
        }
        let p = (s0 * h1 + s1 * h0) / (h0 + h1);
        (s0.signum() + s1.signum()) * s0.abs().min(s1.abs()).min(0.5 * p.abs())
    };
    let row = |row: usize, k: usize| match (row, at_end) {
        (r, AtEnd::Repeat) if r == 0 || r == last => slope(last - 1, 0, k),
        (0, _) => 0.0,
        (r, AtEnd::GoOn) if r == last => chord(last - 1, k),
        (r, _) if r == last => 0.0,
        (r, _) => slope(r - 1, r, k),
    };
    (0..=last).map(|r| std::array::from_fn(|k| row(r, k))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rows() -> TableRows {
        TableRows {
            times: vec![0.0, 0.5, 1.25, 2.0, 2.5],
            values: vec![
                [1.0, 0.0, 0.0, 0.0],
                [1.5, 0.2, -0.1, 0.3],
                [3.0, 0.1, -0.4, 0.9],
                [3.0, 0.3, -0.5, 1.0],
                [2.0, 0.0, 0.0, 2.0],
            ],
        }
    }

    fn table(interpolation: Interpolation, at_end: AtEnd) -> MotionTable {
        MotionTable::new(rows(), interpolation, at_end, Some((DVec3::ZERO, DVec3::Z))).unwrap()
    }

    const ALL: [Interpolation; 3] = [Interpolation::Linear, Interpolation::Smooth, Interpolation::Rates];

    #[test]
    fn rates_are_derivatives_everywhere() {
        for interpolation in ALL {
            for at_end in [AtEnd::Hold, AtEnd::Repeat, AtEnd::GoOn] {
                let table = table(interpolation, at_end);
                for step in 1..700 {
                    // never within h of a row, where straight lines have a kink
                    let (t, h) = (0.01 * f64::from(step) + 0.003, 1e-6);
                    let (before, now, after) = (table.at(t - h).0, table.at(t), table.at(t + h).0);
                    for k in 0..4 {
                        let slope = (after[k] - before[k]) / (2.0 * h);
                        assert!(
                            (slope - now.1[k]).abs() < 1e-5 * (1.0 + slope.abs()),
                            "{interpolation:?} {at_end:?} {t}: {slope} {}",
                            now.1[k]
                        );
                    }
                }
            }
        }
    }

    #[test]
    fn smooth_motion_has_no_kink_and_no_overshoot() {
        for at_end in [AtEnd::Hold, AtEnd::Repeat, AtEnd::GoOn] {
            let table = table(Interpolation::Smooth, at_end);
            for t in [0.5, 1.25, 2.0, 2.5] {
                let (before, after) = (table.at(t - 1e-9).1, table.at(t + 1e-9).1);
                for k in 0..4 {
                    assert!((before[k] - after[k]).abs() < 1e-6, "{at_end:?} {t}");
                }
            }
            for step in 0..250 {
                let x = table.at(0.01 * f64::from(step)).0[0];
                assert!((-1e-12..=2.0 + 1e-12).contains(&x), "{x}");
            }
        }
    }

    #[test]
    fn rows_are_met_and_rounds_add_up() {
        for interpolation in [Interpolation::Linear, Interpolation::Smooth] {
            let hold = table(interpolation, AtEnd::Hold);
            for (t, row) in rows().times.iter().zip(rows().values) {
                assert!((hold.at(*t).0[0] - (row[0] - 1.0)).abs() < 1e-14);
            }
            assert_eq!(hold.at(99.0), ([1.0, 0.0, 0.0, 2.0], [0.0; 4]));
            assert!(hold.is_over(2.5) && !hold.is_over(2.4));
            let again = table(interpolation, AtEnd::Repeat);
            assert!((again.at(3.0 * 2.5 + 0.5).0[0] - 3.5).abs() < 1e-12);
            assert!(!again.is_over(1e9));
        }
        // x: trapezia 0.625 + 1.6875 + 2.25 + 1.25
        let place = table(Interpolation::Rates, AtEnd::Hold).at(2.5).0[0];
        assert!((place - 5.8125).abs() < 1e-14, "{place}");
    }

    #[test]
    fn wrong_tables_are_refused() {
        let wrong = |change: &dyn Fn(&mut TableRows)| {
            let mut rows = rows();
            change(&mut rows);
            MotionTable::new(rows, Interpolation::Linear, AtEnd::Hold, None).unwrap_err()
        };
        assert_eq!(wrong(&|r| r.times[2] = 0.5), WallError::TableOrder);
        assert_eq!(wrong(&|r| r.times[0] = -1.0), WallError::TableOrder);
        assert_eq!(wrong(&|r| r.values[1][2] = f64::NAN), WallError::TableOrder);
        assert_eq!(wrong(&|r| r.times.truncate(1)), WallError::TableRows { rows: 1 });
    }

    #[test]
    fn the_shortest_way_is_told_between_rows_where_it_turns_back() {
        let way = |times: &[f64], places: &[f64], at_end| {
            let rows = TableRows {
                times: times.to_vec(),
                values: places.iter().map(|&x| [0.0, 0.0, x, -2.0 * x]).collect(),
            };
            let table = MotionTable::new(rows, Interpolation::Linear, at_end, None).unwrap();
            table.shortest_way()
        };
        assert_eq!(way(&[0.0, 1.0, 3.0, 4.0], &[0.0, 1.0, 2.0, 5.0], AtEnd::Hold), None);
        assert_eq!(way(&[0.0, 1.0, 3.0], &[0.0, 1.0, 0.0], AtEnd::Hold), None);
        assert_eq!(
            way(&[0.0, 1.0, 3.0, 3.5], &[0.0, 1.0, 0.0, 4.0], AtEnd::Hold),
            Some(2.0)
        );
        // it turns back at its end, too, where it begins again
        assert_eq!(way(&[0.0, 1.0, 3.0], &[0.0, 1.0, 0.0], AtEnd::Repeat), Some(1.0));
        assert_eq!(way(&[0.5, 1.0, 3.0], &[0.0, 1.0, 2.0], AtEnd::Repeat), None);
        // it waits at the top from 1 to 2
        assert_eq!(
            way(&[0.0, 1.0, 2.0, 3.0, 3.5], &[0.0, 1.0, 1.0, 0.0, 1.0], AtEnd::Hold),
            Some(1.0)
        );
    }
}
