//! Line plots as SVG: axes with round ticks, linear or logarithmic, labels, a legend; several in one picture.

mod axis;
mod legend;
mod sheet;

pub use sheet::Sheet;

use super::error::OutputError;
use crate::checkpoint::{Durability, write_atomically};
use axis::{Axis, axes};
use legend::legend;
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
/// Radius of a circle [pixels].
const CIRCLE: f64 = 4.0;

/// A line plot.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Plot {
    /// Text over the plot.
    pub title: String,
    /// Quantity and unit of the horizontal axis.
    pub x_label: String,
    /// Quantity and unit of the vertical axis.
    pub y_label: String,
    /// How values lie on the horizontal axis.
    pub x: AxisSpec,
    /// How values lie on the vertical axis.
    pub y: AxisSpec,
    /// What is drawn.
    pub series: Vec<Series>,
}

/// How values lie on an axis.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct AxisSpec {
    /// Equal ratios have equal lengths; values that are not positive are left out.
    pub logarithmic: bool,
    /// First and last value; chosen to show all points when absent. Values beyond are drawn at the ends.
    pub range: Option<(f64, f64)>,
}

/// How points are drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Look {
    /// A line through them.
    #[default]
    Line,
    /// A dashed line.
    Dashed,
    /// A dotted line.
    Dotted,
    /// A circle at each.
    Circles,
}

impl Look {
    /// Attributes of the path.
    fn attributes(self) -> &'static str {
        match self {
            Self::Line => "",
            Self::Dashed => " stroke-dasharray=\"9 6\"",
            Self::Dotted => " stroke-dasharray=\"1 5\"",
            Self::Circles => " stroke-width=\"1.4\"",
        }
    }
}

/// Points with a name.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Series {
    /// Name in the legend; not listed there when empty.
    pub name: String,
    /// The points. One that is not finite breaks its line.
    pub points: Vec<(f64, f64)>,
    /// How they are drawn.
    pub look: Look,
    /// Which colour; that of its place among the series when absent.
    pub colour: Option<usize>,
}

impl Series {
    /// A line in the colour of its place.
    pub fn line(name: impl Into<String>, points: Vec<(f64, f64)>) -> Self {
        Self {
            name: name.into(),
            points,
            ..Self::default()
        }
    }

    /// The same in another look and colour.
    pub fn with(mut self, look: Look, colour: usize) -> Self {
        (self.look, self.colour) = (look, Some(colour));
        self
    }
}

impl Plot {
    /// The plot as an SVG document.
    pub fn to_svg(&self) -> String {
        let mut svg = document(WIDTH, HEIGHT);
        self.draw(&mut svg);
        svg.push_str("</svg>\n");
        svg
    }

    /// The plot without the document around it.
    fn draw(&self, svg: &mut String) {
        let (x, y) = axes(self, [LEFT, WIDTH - RIGHT, TOP, HEIGHT - BOTTOM]);
        put(
            svg,
            format_args!(
                "<text x=\"{LEFT}\" y=\"32\" font-size=\"18\" font-weight=\"bold\">{}</text>",
                escape(&self.title)
            ),
        );
        self.write_axes(svg, &x, &y);
        svg.push_str("<g fill=\"none\" stroke-width=\"1.8\" stroke-linejoin=\"round\" stroke-linecap=\"round\">\n");
        for (k, series) in self.series.iter().enumerate() {
            let path = match series.look {
                Look::Circles => circles(&series.points, &x, &y),
                _ => path(&series.points, &x, &y),
            };
            let (colour, look) = (colour(series, k), series.look.attributes());
            put(svg, format_args!("<path stroke=\"{colour}\"{look} d=\"{path}\"/>"));
        }
        svg.push_str("</g>\n");
        legend(self, svg, &x, &y);
    }

    /// Writes the plot as an SVG file, whole or not at all.
    pub fn write_svg(&self, path: &Path) -> Result<(), OutputError> {
        write_atomically(path, self.to_svg().as_bytes(), Durability::Kill).map_err(OutputError::io("write", path))
    }

    fn write_axes(&self, svg: &mut String, x: &Axis, y: &Axis) {
        let (right, bottom) = (WIDTH - RIGHT, HEIGHT - BOTTOM);
        for at in x.minor() {
            put(
                svg,
                format_args!("<path stroke=\"#f1f3f5\" d=\"M{at:.1} {TOP}V{bottom}\"/>"),
            );
        }
        for at in y.minor() {
            put(
                svg,
                format_args!("<path stroke=\"#f1f3f5\" d=\"M{LEFT} {at:.1}H{right}\"/>"),
            );
        }
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
        if y.crosses_zero() {
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
}

/// The start of a document of this size.
fn document(width: f64, height: f64) -> String {
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
         viewBox=\"0 0 {width} {height}\" font-family=\"Helvetica, Arial, sans-serif\" font-size=\"14\" \
         fill=\"#262c34\">\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n"
    )
}

/// Adds a line of text. Writing to a String cannot fail.
fn put(svg: &mut String, line: std::fmt::Arguments) {
    let _ = writeln!(svg, "{line}");
}

/// Colour of a series at its place.
fn colour(series: &Series, place: usize) -> &'static str {
    COLOURS[series.colour.unwrap_or(place) % COLOURS.len()]
}

/// The path of circles around points.
fn circles(points: &[(f64, f64)], x: &Axis, y: &Axis) -> String {
    let mut path = String::new();
    for &(px, py) in points.iter().filter(|p| x.shows(p.0) && y.shows(p.1)) {
        let (left, middle) = (x.pixel(px) - CIRCLE, y.pixel(py));
        // Writing to a String cannot fail.
        let _ = write!(path, "M{left:.2} {middle:.2}");
        for turn in [2.0 * CIRCLE, -2.0 * CIRCLE] {
            let _ = write!(path, "a{CIRCLE} {CIRCLE} 0 1 0 {turn} 0");
        }
    }
    path
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
        if !(x.shows(px) && y.shows(py)) {
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
            series: vec![Series::line("squeeze <1>", points)],
            ..Plot::default()
        }
    }

    #[test]
    fn a_plot_names_everything_and_draws_every_point() {
        let mut plot = plot(vec![(0.0, 0.0), (0.1, 2.0), (0.2, 6.7)]);
        plot.series.push(Series::line("release", vec![(0.2, 6.7), (0.0, 0.0)]));
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

    #[test]
    fn looks_colours_and_logarithmic_axes_are_drawn() {
        let mut plot = plot(vec![(1e-6, 1.0), (1e-3, 10.0), (0.0, 5.0), (1.0, 1e3)]);
        plot.x.logarithmic = true;
        plot.y.logarithmic = true;
        plot.series[0] = plot.series[0].clone().with(Look::Dashed, 2);
        plot.series
            .push(Series::line("", vec![(1e-3, 3.0), (-1.0, 2.0), (0.1, 30.0)]).with(Look::Circles, 0));
        let svg = plot.to_svg();
        assert!(svg.contains("stroke=\"#009e73\" stroke-dasharray"), "{svg}");
        // a value that is not positive breaks the line and has no circle
        let line = svg.lines().find(|l| l.contains("#009e73\" stroke-dasharray")).unwrap();
        assert_eq!((line.matches('M').count(), line.matches('L').count()), (2, 1));
        assert_eq!(svg.matches("a4 4 0 1 0 8 0").count(), 2);
        assert!(!svg.contains("NaN") && !svg.contains("inf"));
        // one name: no legend
        assert!(!svg.contains("fill-opacity"));
    }
}
