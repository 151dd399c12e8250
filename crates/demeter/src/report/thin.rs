//! Long series, thinned to what a screen shows.

use crate::results::Columns;

/// Numbers of a column and how they are thinned.
///
/// The rows are cut into pieces of the same length. Of each piece a column keeps its least and its largest number, in the
/// order in which they come, so that no peak is lost; columns that grow thereby keep their first and last.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Thinning {
    rows: usize,
    pieces: usize,
}

impl Thinning {
    /// At most so many rows are left.
    pub fn new(rows: usize, most: usize) -> Self {
        Self {
            rows,
            pieces: (most / 2).max(1),
        }
    }

    /// Whether rows are left out.
    pub fn is_needed(&self) -> bool {
        self.rows > 2 * self.pieces
    }

    /// How many rows are left.
    pub fn rows(&self) -> usize {
        if self.is_needed() { 2 * self.pieces } else { self.rows }
    }

    /// A column, thinned.
    pub fn of(&self, values: &[f64]) -> Vec<f64> {
        if !self.is_needed() {
            return values.to_vec();
        }
        let piece = |k: usize| &values[k * self.rows / self.pieces..(k + 1) * self.rows / self.pieces];
        (0..self.pieces).flat_map(|k| ends(piece(k))).collect()
    }

    /// The row where a range of all rows begins after thinning.
    pub fn place_of(&self, row: usize) -> usize {
        if self.is_needed() {
            2 * (row * self.pieces / self.rows)
        } else {
            row
        }
    }
}

/// The least and the largest number of a piece, in the order in which they come.
fn ends(piece: &[f64]) -> [f64; 2] {
    let mut least = (f64::NAN, 0);
    let mut largest = (f64::NAN, 0);
    for (k, &value) in piece.iter().enumerate().filter(|(_, v)| !v.is_nan()) {
        if least.0.is_nan() || value < least.0 {
            least = (value, k);
        }
        // of equal ones the last, so that what grows ends with its end
        if largest.0.is_nan() || value >= largest.0 {
            largest = (value, k);
        }
    }
    if least.1 <= largest.1 {
        [least.0, largest.0]
    } else {
        [largest.0, least.0]
    }
}

/// How the series is thinned for a number of columns.
pub(super) fn thinning(series: &Columns, columns: usize) -> Thinning {
    /// A screen has no more pixels side by side.
    const MOST_ROWS: usize = 4000;
    /// Numbers of the whole series.
    const MOST_NUMBERS: usize = 400_000;
    Thinning::new(series.rows(), MOST_ROWS.min(MOST_NUMBERS / columns.max(1)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn peaks_survive() {
        let mut values: Vec<f64> = (0..100_003).map(|k| libm::sin(f64::from(k) * 0.01)).collect();
        values[77_777] = 50.0;
        values[31] = -40.0;
        values[500] = f64::NAN;
        let thinning = Thinning::new(values.len(), 4000);
        let thin = thinning.of(&values);
        assert!(thinning.is_needed() && thin.len() == thinning.rows() && thin.len() <= 4000);
        let largest = thin.iter().copied().fold(f64::MIN, f64::max);
        let least = thin.iter().copied().fold(f64::MAX, f64::min);
        assert_eq!((least, largest), (-40.0, 50.0));
        assert!(
            thin.iter().all(|v| !v.is_nan()),
            "a piece with other numbers shows these"
        );
    }

    #[test]
    fn time_keeps_its_ends_and_its_order() {
        let times: Vec<f64> = (0..10_000).map(|k| f64::from(k) * 0.5).collect();
        let thin = Thinning::new(times.len(), 500).of(&times);
        assert_eq!((thin[0], thin[thin.len() - 1]), (0.0, 4999.5));
        assert!(thin.is_sorted());
    }

    #[test]
    fn what_goes_down_goes_down_within_a_piece() {
        let values: Vec<f64> = (0..1000).map(|k| -f64::from(k)).collect();
        let thin = Thinning::new(values.len(), 100).of(&values);
        assert!(thin.windows(2).all(|pair| pair[0] > pair[1]));
    }

    #[test]
    fn short_series_stay_as_they_are() {
        let values = [3.0, f64::NAN, 1.0];
        let thinning = Thinning::new(3, 4000);
        assert!(!thinning.is_needed());
        assert_eq!(format!("{:?}", thinning.of(&values)), "[3.0, NaN, 1.0]");
        assert_eq!(Thinning::new(0, 4000).of(&[]), Vec::<f64>::new());
        let nothing = Thinning::new(10, 4).of(&[f64::NAN; 10]);
        assert!(nothing.len() == 4 && nothing.iter().all(|v| v.is_nan()));
    }
}
