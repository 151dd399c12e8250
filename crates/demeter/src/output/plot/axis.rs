//! Axes: values to pixels, ticks.

use super::super::ticks::Ticks;
use super::canvas::Label;
use super::{AxisSpec, Plot};

/// One axis.
pub(super) struct Axis {
    pub low: f64,
    pub high: f64,
    /// Pixels at the two ends.
    from: f64,
    to: f64,
    logarithmic: bool,
    ticks: Vec<(f64, Label)>,
    /// Values of grid lines without a number.
    minor: Vec<f64>,
    /// Power of ten by which the numbers at the ticks are multiplied.
    exponent: i32,
}

/// From so many decades on only powers of ten get a number.
const MANY_DECADES: f64 = 2.5;
/// No axis has more numbers than about this.
const MOST_NUMBERS: f64 = 10.0;

impl Axis {
    /// The axis of these values, between two pixels, with about `count` ticks.
    pub fn new(values: impl Iterator<Item = f64>, spec: AxisSpec, (from, to): (f64, f64), count: f64) -> Self {
        if spec.logarithmic {
            return Self::logarithmic(values, spec, (from, to));
        }
        let (low, high) = spec.range.unwrap_or_else(|| linear_range(values));
        let largest = low.abs().max(high.abs());
        // The exponent of an f64 fits an i32.
        let third = libm::floor(libm::log10(largest) / 3.0) as i32;
        let exponent = if (1e-2..1e4).contains(&largest) { 0 } else { 3 * third };
        let power = libm::pow(10.0, f64::from(exponent));
        Self {
            low,
            high,
            from,
            to,
            logarithmic: false,
            ticks: plain(Ticks::inside(low / power, high / power, count)),
            minor: Vec::new(),
            exponent,
        }
    }

    fn logarithmic(values: impl Iterator<Item = f64>, spec: AxisSpec, (from, to): (f64, f64)) -> Self {
        let (low, high) = spec.range.unwrap_or_else(|| logarithmic_range(values));
        let mut ticks = Vec::new();
        let mut minor = Vec::new();
        let decades = libm::log10(high / low);
        let few = decades < MANY_DECADES;
        // Whole decades between numbers, 1 to 28.
        let stride = libm::ceil(decades / MOST_NUMBERS).max(1.0) as i32;
        // The logarithm of an f64 fits an i32.
        let (first, last) = (
            libm::floor(libm::log10(low)) as i32,
            libm::ceil(libm::log10(high)) as i32,
        );
        for exponent in first..=last {
            for factor in 1..10 {
                let value = f64::from(factor) * libm::pow(10.0, f64::from(exponent));
                if !(low * (1.0 - 1e-9)..=high * (1.0 + 1e-9)).contains(&value) {
                    continue;
                }
                if stride > 1 && (factor > 1 || exponent % stride != 0) {
                    continue;
                }
                if factor == 1 || (few && (factor == 2 || factor == 5)) {
                    ticks.push((value, logarithmic_label(factor, exponent)));
                } else {
                    minor.push(value);
                }
            }
        }
        Self {
            low,
            high,
            from,
            to,
            logarithmic: true,
            ticks,
            minor,
            exponent: 0,
        }
    }

    /// Whether a value can be shown.
    pub fn shows(&self, value: f64) -> bool {
        value.is_finite() && (value > 0.0 || !self.logarithmic)
    }

    /// Pixel of a value; those beyond the ends are drawn at the ends.
    pub fn pixel(&self, value: f64) -> f64 {
        let value = value.clamp(self.low, self.high);
        let share = if self.logarithmic {
            libm::log(value / self.low) / libm::log(self.high / self.low)
        } else {
            (value - self.low) / (self.high - self.low)
        };
        self.from + share * (self.to - self.from)
    }

    /// Pixels and labels of the ticks.
    pub fn ticks(&self) -> impl Iterator<Item = (f64, &Label)> {
        let power = libm::pow(10.0, f64::from(self.exponent));
        self.ticks
            .iter()
            .map(move |(value, label)| (self.pixel(value * power), label))
    }

    /// Pixels of grid lines without a number.
    pub fn minor(&self) -> impl Iterator<Item = f64> {
        self.minor.iter().map(|v| self.pixel(*v))
    }

    /// Whether zero lies inside.
    pub fn crosses_zero(&self) -> bool {
        !self.logarithmic && self.low < 0.0 && self.high > 0.0
    }

    /// The label of the axis with the power of ten that its numbers leave out.
    pub fn label(&self, label: &str) -> Label {
        match self.exponent {
            0 => Label::plain(label),
            n => Label {
                text: format!("{label} × 10"),
                power: Some(n.to_string()),
            },
        }
    }
}

/// Both axes of a plot with these pixels at the ends: left, right, top, bottom.
pub(super) fn axes(plot: &Plot, [left, right, top, bottom]: [f64; 4]) -> (Axis, Axis) {
    let points = || {
        let all = plot.series.iter().flat_map(|series| &series.points);
        all.filter(|p| p.0.is_finite() && p.1.is_finite())
    };
    let x = Axis::new(points().map(|p| p.0), plot.x, (left, right), 7.0);
    let y = Axis::new(points().map(|p| p.1), plot.y, (bottom, top), 6.0);
    (x, y)
}

/// Ticks with plain numbers.
fn plain(ticks: Ticks) -> Vec<(f64, Label)> {
    ticks
        .values
        .into_iter()
        .zip(ticks.labels.into_iter().map(Label::plain))
        .collect()
}

fn ends(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(v), b.max(v)))
}

fn linear_range(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let (mut low, mut high) = ends(values);
    if low > high {
        (low, high) = (0.0, 1.0);
    }
    // Zero is shown when it is near; a line must not lie on the frame.
    if low > 0.0 && low < 0.4 * high {
        low = 0.0;
    } else if high < 0.0 && high > 0.4 * low {
        high = 0.0;
    }
    let span = high - low;
    let largest = low.abs().max(high.abs());
    let margin = if span > 1e-9 * largest {
        0.04 * span
    } else if largest > f64::MIN_POSITIVE * 1e10 {
        0.5 * largest
    } else {
        1.0
    };
    low -= if low == 0.0 && span > 0.0 { 0.0 } else { margin };
    high += if high == 0.0 && span > 0.0 { 0.0 } else { margin };
    // Values near the largest f64 would overflow in what follows.
    (low.max(-1e300), high.min(1e300))
}

fn logarithmic_range(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let (low, high) = ends(values.filter(|v| *v > 0.0));
    if low > high {
        return (0.1, 1.0);
    }
    // The ratio of the two must not overflow.
    let (low, high) = (low.clamp(1e-140, 1e140), high.clamp(1e-140, 1e140));
    let margin = libm::pow(high / low, 0.04).max(1.2);
    (low / margin, high * margin)
}

/// The number at a tick of a logarithmic axis.
fn logarithmic_label(factor: i32, exponent: i32) -> Label {
    match exponent {
        0..=3 => Label::plain(format!("{}", i64::from(factor) * 10_i64.pow(exponent.unsigned_abs()))),
        -3..0 => {
            let decimals = exponent.unsigned_abs() as usize;
            let value = f64::from(factor) * libm::pow(10.0, f64::from(exponent));
            Label::plain(format!("{value:.decimals$}"))
        }
        _ => {
            let times = if factor == 1 {
                String::new()
            } else {
                format!("{factor}·")
            };
            Label {
                text: format!("{times}10"),
                power: Some(exponent.to_string()),
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_logarithmic_axis_has_equal_decades_and_readable_numbers() {
        let spec = AxisSpec {
            logarithmic: true,
            range: Some((1e-5, 1e2)),
        };
        let axis = Axis::new([].into_iter(), spec, (0.0, 700.0), 6.0);
        for (k, value) in [1e-5, 1e-4, 1e-1, 1.0, 1e2]
            .into_iter()
            .zip([0.0, 100.0, 400.0, 500.0, 700.0])
        {
            assert!((axis.pixel(k) - value).abs() < 1e-9, "{k}");
        }
        let labels: Vec<&str> = axis.ticks().map(|(_, label)| label.text.as_str()).collect();
        assert_eq!(labels[2..], ["0.001", "0.01", "0.1", "1", "10", "100"]);
        assert!(axis.ticks().next().unwrap().1.power.as_deref() == Some("-5") && axis.minor().count() == 7 * 8);
        assert!(!axis.shows(0.0) && !axis.shows(-1.0) && axis.shows(1.0));
    }

    #[test]
    fn values_that_are_all_zero_lie_between_minus_one_and_one() {
        let axis = Axis::new([0.0, 0.0].into_iter(), AxisSpec::default(), (0.0, 1.0), 6.0);
        let labels: Vec<&str> = axis.ticks().map(|(_, label)| label.text.as_str()).collect();
        assert_eq!(labels, ["-1.0", "-0.5", "0.0", "0.5", "1.0"]);
    }

    #[test]
    fn a_short_logarithmic_axis_has_numbers_between_the_powers() {
        let spec = AxisSpec {
            logarithmic: true,
            range: None,
        };
        let axis = Axis::new([0.1, 1.0].into_iter(), spec, (0.0, 1.0), 6.0);
        let labels: Vec<&str> = axis.ticks().map(|(_, label)| label.text.as_str()).collect();
        assert_eq!(labels, ["0.1", "0.2", "0.5", "1"]);
        // nothing to show, one value, the whole range of numbers
        for values in [vec![], vec![-1.0], vec![3.0], vec![5e-324, f64::MAX]] {
            let axis = Axis::new(values.into_iter(), spec, (0.0, 1.0), 6.0);
            assert!(axis.low > 0.0 && axis.high > axis.low && axis.high.is_finite());
            assert!(axis.ticks().count() <= 12 && axis.minor().count() < 100);
        }
    }
}
