//! Line plots as SVG: axes with round ticks, labels, a legend.

use super::error::OutputError;
use super::ticks::Ticks;
use crate::checkpoint::{Durability, write_atomically};
use std::fmt::Write as _;
use std::path::Path;

/// Colours of the lines (Okabe and Ito, 2008).
const COLOURS: [&str; 8] = [
    "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#5d3a9b", "#555555",
];

const WIDTH: f64 = 840.0;
const HEIGHT: f64 = 560.0;
const LEFT: f64 = 92.0;
const TOP: f64 = 56.0;
const BOTTOM: f64 = 72.0;
const RIGHT: f64 = 28.0;
/// Points of a line nearer than this to the last one drawn are left out [pixels].
const CLOSE: f64 = 0.5;

/// A line plot.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Plot {
    /// Text over the plot.
    pub title: String,
    /// Quantity and unit of the horizontal axis.
    pub x_label: String,
    /// Quantity and unit of the vertical axis.
    pub y_label: String,
    /// Lines: name and points. A point that is not finite breaks its line.
    pub series: Vec<(String, Vec<(f64, f64)>)>,
}

/// One axis: values to pixels.
struct Axis {
    low: f64,
    high: f64,
    /// Pixels at the two ends.
    from: f64,
    to: f64,
    ticks: Ticks,
    /// Power of ten by which the numbers at the ticks are multiplied.
    exponent: i32,
}

impl Axis {
    fn new(values: impl Iterator<Item = f64>, from: f64, to: f64, count: f64) -> Self {
        let (mut low, mut high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(v), b.max(v)));
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
        } else {
            0.5 * largest.max(f64::MIN_POSITIVE * 1e10)
        };
        low -= if low == 0.0 && span > 0.0 { 0.0 } else { margin };
        high += if high == 0.0 && span > 0.0 { 0.0 } else { margin };
        // Values near the largest f64 would overflow in what follows.
        (low, high) = (low.max(-1e300), high.min(1e300));
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
            ticks: Ticks::inside(low / power, high / power, count),
            exponent,
        }
    }

    fn pixel(&self, value: f64) -> f64 {
        self.from + (value.clamp(self.low, self.high) - self.low) / (self.high - self.low) * (self.to - self.from)
    }

    fn ticks(&self) -> impl Iterator<Item = (f64, &String)> {
        let power = libm::pow(10.0, f64::from(self.exponent));
        let values = self.ticks.values.iter().map(move |v| self.pixel(v * power));
        values.zip(&self.ticks.labels)
    }

    /// The label of the axis with the power of ten that its numbers leave out.
    fn label(&self, label: &str) -> String {
        let label = escape(label);
        match self.exponent {
            0 => label,
            n => format!("{label} × 10<tspan dy=\"-6\" font-size=\"11\">{n}</tspan>"),
        }
    }
}

impl Plot {
    /// The plot as an SVG document.
    pub fn to_svg(&self) -> String {
        let points = || {
            let all = self.series.iter().flat_map(|(_, points)| points);
            all.filter(|p| p.0.is_finite() && p.1.is_finite())
        };
        let x = Axis::new(points().map(|p| p.0), LEFT, WIDTH - RIGHT, 7.0);
        let y = Axis::new(points().map(|p| p.1), HEIGHT - BOTTOM, TOP, 6.0);
        let mut svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{WIDTH}\" height=\"{HEIGHT}\" \
             viewBox=\"0 0 {WIDTH} {HEIGHT}\" font-family=\"Helvetica, Arial, sans-serif\" font-size=\"14\" \
             fill=\"#262c34\">\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n\
             <text x=\"{LEFT}\" y=\"32\" font-size=\"18\" font-weight=\"bold\">{}</text>\n",
            escape(&self.title)
        );
        self.write_axes(&mut svg, &x, &y);
        svg.push_str("<g fill=\"none\" stroke-width=\"1.8\" stroke-linejoin=\"round\" stroke-linecap=\"round\">\n");
        for (k, (_, points)) in self.series.iter().enumerate() {
            let path = path(points, &x, &y);
            put(&mut svg, format_args!("<path stroke=\"{}\" d=\"{path}\"/>", colour(k)));
        }
        svg.push_str("</g>\n");
        if self.series.len() > 1 {
            self.write_legend(&mut svg, &x, &y);
        }
        svg.push_str("</svg>\n");
        svg
    }

    /// Writes the plot as an SVG file, whole or not at all.
    pub fn write_svg(&self, path: &Path) -> Result<(), OutputError> {
        write_atomically(path, self.to_svg().as_bytes(), Durability::Kill).map_err(OutputError::io("write", path))
    }

    fn write_axes(&self, svg: &mut String, x: &Axis, y: &Axis) {
        let (right, bottom) = (WIDTH - RIGHT, HEIGHT - BOTTOM);
        for (at, label) in x.ticks() {
            put(
                svg,
                format_args!("<path stroke=\"#e4e7ea\" d=\"M{at:.1} {TOP}V{bottom}\"/>"),
            );
            let below = bottom + 20.0;
            put(
                svg,
                format_args!("<text x=\"{at:.1}\" y=\"{below}\" text-anchor=\"middle\">{label}</text>"),
            );
        }
        for (at, label) in y.ticks() {
            put(
                svg,
                format_args!("<path stroke=\"#e4e7ea\" d=\"M{LEFT} {at:.1}H{right}\"/>"),
            );
            let (beside, base) = (LEFT - 8.0, at + 5.0);
            put(
                svg,
                format_args!("<text x=\"{beside}\" y=\"{base:.1}\" text-anchor=\"end\">{label}</text>"),
            );
        }
        if y.low < 0.0 && y.high > 0.0 {
            let zero = y.pixel(0.0);
            put(
                svg,
                format_args!("<path stroke=\"#9aa2ab\" d=\"M{LEFT} {zero:.1}H{right}\"/>"),
            );
        }
        put(
            svg,
            format_args!("<path stroke=\"#262c34\" fill=\"none\" d=\"M{LEFT} {TOP}V{bottom}H{right}\"/>"),
        );
        let (middle_x, middle_y) = (0.5 * (LEFT + right), 0.5 * (TOP + bottom));
        let base = HEIGHT - 22.0;
        let label = x.label(&self.x_label);
        put(
            svg,
            format_args!("<text x=\"{middle_x}\" y=\"{base}\" text-anchor=\"middle\">{label}</text>"),
        );
        let label = y.label(&self.y_label);
        let turn = format!("translate(26 {middle_y}) rotate(-90)");
        put(
            svg,
            format_args!("<text transform=\"{turn}\" text-anchor=\"middle\">{label}</text>"),
        );
    }

    /// The legend, in the corner where fewest points are.
    fn write_legend(&self, svg: &mut String, x: &Axis, y: &Axis) {
        let longest = self
            .series
            .iter()
            .map(|(name, _)| name.chars().count())
            .max()
            .unwrap_or(0);
        let width = 52.0 + 7.6 * longest as f64;
        let height = 12.0 + 22.0 * self.series.len() as f64;
        let (right, bottom) = (WIDTH - RIGHT - width - 10.0, HEIGHT - BOTTOM - height - 10.0);
        let corners = [
            (LEFT + 12.0, TOP + 6.0),
            (right, TOP + 6.0),
            (right, bottom),
            (LEFT + 12.0, bottom),
        ];
        let hidden = |&(left, top): &(f64, f64)| {
            let all = self.series.iter().flat_map(|(_, points)| points);
            let pixels = all.map(|p| (x.pixel(p.0) - left, y.pixel(p.1) - top));
            pixels
                .filter(|p| p.0 > 0.0 && p.0 < width && p.1 > 0.0 && p.1 < height)
                .count()
        };
        let Some((left, top)) = corners.into_iter().min_by_key(hidden) else {
            return;
        };
        put(
            svg,
            format_args!(
                "<rect x=\"{left:.1}\" y=\"{top:.1}\" width=\"{width:.1}\" height=\"{height:.1}\" rx=\"3\" \
                 fill=\"#ffffff\" fill-opacity=\"0.85\" stroke=\"#d5d9dd\"/>"
            ),
        );
        for (k, (name, _)) in self.series.iter().enumerate() {
            let line = top + 17.0 + 22.0 * k as f64;
            let (start, end, text, base) = (left + 10.0, left + 34.0, left + 42.0, line + 5.0);
            let colour = colour(k);
            put(
                svg,
                format_args!("<path stroke=\"{colour}\" stroke-width=\"2\" d=\"M{start:.1} {line:.1}H{end:.1}\"/>"),
            );
            put(
                svg,
                format_args!("<text x=\"{text:.1}\" y=\"{base:.1}\">{}</text>", escape(name)),
            );
        }
    }
}

/// Adds a line of text. Writing to a String cannot fail.
fn put(svg: &mut String, line: std::fmt::Arguments) {
    let _ = writeln!(svg, "{line}");
}

fn colour(k: usize) -> &'static str {
    COLOURS[k % COLOURS.len()]
}

/// The path of a line, without points that nobody could see.
fn path(points: &[(f64, f64)], x: &Axis, y: &Axis) -> String {
    let mut path = String::new();
    // The last point drawn, and the last one left out after it.
    let mut pen: Option<(f64, f64)> = None;
    let mut skipped: Option<(f64, f64)> = None;
    let mut draw = |command: char, at: (f64, f64)| {
        // Writing to a String cannot fail.
        let _ = write!(path, "{command}{:.2} {:.2}", at.0, at.1);
    };
    for &(px, py) in points.iter().chain([&(f64::NAN, f64::NAN)]) {
        if !(px.is_finite() && py.is_finite()) {
            // The end of a line is always drawn.
            if let Some(at) = skipped.take() {
                draw('L', at);
            }
            pen = None;
            continue;
        }
        let at = (x.pixel(px), y.pixel(py));
        match pen {
            Some(last) if (at.0 - last.0).abs() < CLOSE && (at.1 - last.1).abs() < CLOSE => skipped = Some(at),
            _ => {
                draw(if pen.is_some() { 'L' } else { 'M' }, at);
                (pen, skipped) = (Some(at), None);
            }
        }
    }
    path
}

/// A text as XML.
fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            // XML knows no other control characters.
            c if c.is_control() && !matches!(c, '\t' | '\n') => out.push(' '),
            c => out.push(c),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plot(points: Vec<(f64, f64)>) -> Plot {
        Plot {
            title: "Force & strain".to_owned(),
            x_label: "strain".to_owned(),
            y_label: "force [N]".to_owned(),
            series: vec![("squeeze <1>".to_owned(), points)],
        }
    }

    #[test]
    fn a_plot_names_everything_and_draws_every_point() {
        let mut plot = plot(vec![(0.0, 0.0), (0.1, 2.0), (0.2, 6.7)]);
        plot.series.push(("release".to_owned(), vec![(0.2, 6.7), (0.0, 0.0)]));
        let svg = plot.to_svg();
        for text in [
            "Force &amp; strain",
            ">strain<",
            ">force [N]<",
            ">squeeze &lt;1&gt;<",
            ">0.10<",
            ">6<",
        ] {
            assert!(svg.contains(text), "{text}");
        }
        // Both axes start at 0, at the lower left corner.
        let start = format!("d=\"M{LEFT:.2} {:.2}L", HEIGHT - BOTTOM);
        assert!(svg.contains(&start), "{svg}");
        assert_eq!(svg.matches("L").count(), 3);
    }

    #[test]
    fn large_and_small_numbers_get_a_power_of_ten() {
        let svg = plot(vec![(0.0, 0.0), (1e-6, 2.3e7)]).to_svg();
        assert!(svg.contains(">-6</tspan>") && svg.contains(">6</tspan>"), "{svg}");
    }

    #[test]
    fn what_is_not_finite_breaks_the_line() {
        let svg = plot(vec![
            (0.0, 1.0),
            (1.0, f64::NAN),
            (2.0, 1.5),
            (3.0, 2.0),
            (f64::INFINITY, 0.0),
        ])
        .to_svg();
        assert!(!svg.contains("NaN") && !svg.contains("inf"));
        let line = svg.lines().find(|line| line.contains("stroke=\"#0072b2\"")).unwrap();
        assert_eq!((line.matches('M').count(), line.matches('L').count()), (2, 1));
    }

    #[test]
    fn degenerate_data_still_make_a_plot() {
        let cases = [
            vec![],
            vec![(1.0, 1.0)],
            vec![(0.0, 0.0); 3],
            vec![(5.0, -2.0), (5.0, -2.0)],
            vec![(0.0, f64::MAX), (1.0, -f64::MAX)],
            vec![(f64::MIN_POSITIVE, 5e-324)],
        ];
        for points in cases {
            let svg = plot(points.clone()).to_svg();
            assert!(!svg.contains("NaN") && !svg.contains("inf"), "{points:?}: {svg}");
            assert!(svg.len() < 20_000);
        }
    }

    #[test]
    fn a_million_points_stay_small() {
        let wave = (0..1_000_000)
            .map(|k| f64::from(k) * 1e-6)
            .map(|t| (t, libm::sin(20.0 * t)));
        let svg = plot(wave.collect()).to_svg();
        assert!(svg.len() < 150_000, "{}", svg.len());
    }
}
