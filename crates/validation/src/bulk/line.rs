//! Straight lines through points.

/// The line `y = offset + slope x` of least squares.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// Slope.
    pub slope: f64,
    /// Value at 0.
    pub offset: f64,
    /// Share of the variance of `y` that the line explains, R^2; NaN where `y` does not vary.
    pub explained: f64,
}

/// Fits a line; NaN with fewer than two different places.
pub fn fit_line(points: &[(f64, f64)]) -> Line {
    let count = points.len() as f64;
    let mean = |of: &dyn Fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / count;
    let (x, y) = (mean(&|p| p.0), mean(&|p| p.1));
    let sum = |of: &dyn Fn(f64, f64) -> f64| points.iter().map(|p| of(p.0 - x, p.1 - y)).sum::<f64>();
    let (xx, xy, yy) = (sum(&|a, _| a * a), sum(&|a, b| a * b), sum(&|_, b| b * b));
    let slope = xy / xx;
    Line {
        slope,
        offset: y - slope * x,
        explained: xy * xy / (xx * yy),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_is_found_and_its_scatter_told() {
        let exact = fit_line(&[(1.0, 5.0), (2.0, 7.0), (4.0, 11.0)]);
        assert!((exact.slope - 2.0).abs() < 1e-14 && (exact.offset - 3.0).abs() < 1e-14);
        assert!((exact.explained - 1.0).abs() < 1e-14);
        // two points over each place: half of the variance is scatter
        let scattered = fit_line(&[(-1.0, -2.0), (-1.0, 0.0), (1.0, 0.0), (1.0, 2.0)]);
        assert_eq!(
            (scattered.slope, scattered.offset, scattered.explained),
            (1.0, 0.0, 0.5)
        );
        assert!(fit_line(&[(1.0, 1.0), (1.0, 2.0)]).slope.is_nan());
    }
}
