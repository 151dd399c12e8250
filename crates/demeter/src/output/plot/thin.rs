//! Points of long series, without those that nobody could see.

use super::CLOSE;
use std::collections::HashSet;

/// A place on the canvas [pixels].
type Place = (f64, f64);

/// The points of a line that show: where many follow each other in one column of the raster, the first, the last, the lowest and
/// the highest, in their order, as no more of them can be told apart; the same in every row; and none that is close to
/// the last one drawn, but for the end of the line.
pub(super) fn line(points: &[Place]) -> Vec<Place> {
    let in_columns = ends_of_runs(points, |p| p.0, |p| p.1);
    let in_rows = ends_of_runs(&in_columns, |p| p.1, |p| p.0);
    let is_close = |a: &Place, b: &Place| (a.0 - b.0).abs() < CLOSE && (a.1 - b.1).abs() < CLOSE;
    let mut line: Vec<Place> = Vec::new();
    let mut left_out = None;
    for at in in_rows {
        if line.last().is_some_and(|last| is_close(last, &at)) {
            left_out = Some(at);
        } else {
            line.push(at);
            left_out = None;
        }
    }
    line.extend(left_out);
    line
}

/// Points of which each begins another cell of the raster.
pub(super) fn places(points: impl Iterator<Item = Place>) -> Vec<Place> {
    let mut taken = HashSet::new();
    points.filter(|p| taken.insert((cell(p.0), cell(p.1)))).collect()
}

/// Place in the raster, whose cells are finer than the pixels of a picture.
fn cell(at: f64) -> i64 {
    (at / CLOSE).floor() as i64
}

/// Of points that follow each other in one cell along an axis, the first, the last, and those that lie farthest across.
fn ends_of_runs(points: &[Place], along: impl Fn(&Place) -> f64, across: impl Fn(&Place) -> f64) -> Vec<Place> {
    let runs = points.chunk_by(|a, b| cell(along(a)) == cell(along(b)));
    let mut kept = Vec::new();
    for run in runs {
        let (mut least, mut largest) = (0, 0);
        for (k, point) in run.iter().enumerate() {
            if across(point) < across(&run[least]) {
                least = k;
            }
            if across(point) > across(&run[largest]) {
                largest = k;
            }
        }
        let mut ends = [0, least.min(largest), least.max(largest), run.len() - 1].to_vec();
        ends.dedup();
        kept.extend(ends.into_iter().map(|k| run[k]));
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ends_and_peaks_of_every_column_stay_in_their_order() {
        let mut noise: Vec<Place> = (0..100_000)
            .map(|k| (f64::from(k) * 1e-3, 50.0 + f64::from(k * 7919 % 1000) * 0.01))
            .collect();
        (noise[55_555].1, noise[20_001].1) = (99.0, 1.0);
        let thin = line(&noise);
        assert!(thin.len() <= 4 * 200 + 4, "{}", thin.len());
        let mut rest = noise.iter();
        assert!(
            thin.iter().all(|p| rest.any(|known| known == p)),
            "others, or in another order"
        );
        assert_eq!((thin[0], thin[thin.len() - 1]), (noise[0], noise[99_999]));
        for peak in [55_555, 20_001] {
            assert!(thin.contains(&noise[peak]), "{peak}");
        }
        // the same where the axes are exchanged
        let turned: Vec<Place> = noise.iter().map(|p| (p.1, p.0)).collect();
        assert_eq!(line(&turned), thin.iter().map(|p| (p.1, p.0)).collect::<Vec<_>>());
    }

    #[test]
    fn short_lines_stay_as_they_are() {
        for points in [
            vec![],
            vec![(1.0, 2.0)],
            vec![(0.0, 0.0), (0.1, 3.0), (0.2, 1.0), (9.0, 1.0)],
        ] {
            assert_eq!(line(&points), points);
        }
        assert_eq!(line(&[(0.0, 0.0), (0.1, 0.1), (0.2, 0.2)]), [(0.0, 0.0), (0.2, 0.2)]);
        assert_eq!(line(&[(1.0, 1.0); 3]), [(1.0, 1.0); 2], "a dot");
    }

    #[test]
    fn of_points_in_one_place_one_is_drawn() {
        let cloud = (0..10_000).map(|k| (f64::from(k % 3), f64::from(k % 2) + 1e-6 * f64::from(k)));
        assert_eq!(places(cloud).len(), 6);
    }
}
