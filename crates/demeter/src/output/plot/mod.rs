//! Line plots as SVG or PNG: axes with round ticks, linear or logarithmic, labels, a legend; several in one picture.

mod axis;
mod canvas;
mod legend;
mod raster;
mod sheet;
mod svg;
mod thin;

pub use sheet::Sheet;

use super::error::OutputError;
use super::picture::Image;
use crate::checkpoint::{Durability, write_atomically};
use axis::{Axis, axes};
use canvas::{Anchor, Canvas, Label, Letters, Pen};
use legend::legend;
use raster::Raster;
use std::path::Path;
use svg::Svg;

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
/// Colour of letters.
const INK: [u8; 3] = [38, 44, 52];

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
    /// Width of the line [pixels].
    fn width(self) -> f64 {
        if self == Self::Circles { 1.4 } else { 1.8 }
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
        let mut svg = Svg::new(WIDTH, HEIGHT);
        self.draw(&mut svg);
        svg.finish()
    }

    /// The plot as a picture of 1260 by 840 pixels.
    pub fn to_image(&self) -> Image {
        Sheet {
            plots: vec![self.clone()],
            columns: 1,
        }
        .to_image()
    }

    /// Writes the plot as an SVG file, whole or not at all.
    pub fn write_svg(&self, path: &Path) -> Result<(), OutputError> {
        write_atomically(path, self.to_svg().as_bytes(), Durability::Kill).map_err(OutputError::io("write", path))
    }

    /// Writes the plot as a PNG file, whole or not at all.
    pub fn write_png(&self, path: &Path) -> Result<(), OutputError> {
        self.to_image().write_png(path)
    }

    /// The plot without the document around it.
    fn draw(&self, on: &mut dyn Canvas) {
        let (x, y) = axes(self, [LEFT, WIDTH - RIGHT, TOP, HEIGHT - BOTTOM]);
        let title = Letters {
            title: true,
            ..Letters::new(Anchor::Start)
        };
        on.text((LEFT, 32.0), &Label::plain(&*self.title), title);
        self.draw_axes(on, &x, &y);
        for (k, series) in self.series.iter().enumerate() {
            let pen = Pen {
                colour: colour(series, k),
                width: series.look.width(),
                look: series.look,
            };
            match series.look {
                Look::Circles => {
                    let shown = series.points.iter().filter(|p| x.shows(p.0) && y.shows(p.1));
                    let centres = thin::places(shown.map(|p| (x.pixel(p.0), y.pixel(p.1))));
                    on.circles(&centres, pen);
                }
                _ => on.lines(&lines(&series.points, &x, &y), pen),
            }
        }
        legend(self, on, &x, &y);
    }

    fn draw_axes(&self, on: &mut dyn Canvas, x: &Axis, y: &Axis) {
        const FAINT: &str = "#f1f3f5";
        const GRID: &str = "#e4e7ea";
        const FRAME: &str = "#262c34";
        let (right, bottom) = (WIDTH - RIGHT, HEIGHT - BOTTOM);
        for at in x.minor() {
            on.rule((at, TOP), (at, bottom), FAINT);
        }
        for at in y.minor() {
            on.rule((LEFT, at), (right, at), FAINT);
        }
        for (at, label) in x.ticks() {
            on.rule((at, TOP), (at, bottom), GRID);
            on.text((at, bottom + 20.0), label, Letters::new(Anchor::Middle));
        }
        for (at, label) in y.ticks() {
            on.rule((LEFT, at), (right, at), GRID);
            on.text((LEFT - 8.0, at + 5.0), label, Letters::new(Anchor::End));
        }
        if y.crosses_zero() {
            let zero = y.pixel(0.0);
            on.rule((LEFT, zero), (right, zero), "#9aa2ab");
        }
        on.rule((LEFT, TOP), (LEFT, bottom), FRAME);
        on.rule((LEFT, bottom), (right, bottom), FRAME);
        let (middle_x, middle_y) = (0.5 * (LEFT + right), 0.5 * (TOP + bottom));
        on.text(
            (middle_x, HEIGHT - 22.0),
            &x.label(&self.x_label),
            Letters::new(Anchor::Middle),
        );
        let upwards = Letters {
            upwards: true,
            ..Letters::new(Anchor::Middle)
        };
        on.text((26.0, middle_y), &y.label(&self.y_label), upwards);
    }
}

/// Colour of a series at its place.
fn colour(series: &Series, place: usize) -> &'static str {
    COLOURS[series.colour.unwrap_or(place) % COLOURS.len()]
}

/// The lines of a series, without points that nobody could see.
fn lines(points: &[(f64, f64)], x: &Axis, y: &Axis) -> Vec<Vec<(f64, f64)>> {
    let pieces = points.split(|p| !(x.shows(p.0) && y.shows(p.1)));
    let shown = pieces.filter(|piece| !piece.is_empty());
    let line = |piece: &[(f64, f64)]| {
        let places: Vec<(f64, f64)> = piece.iter().map(|p| (x.pixel(p.0), y.pixel(p.1))).collect();
        thin::line(&places)
    };
    shown.map(line).collect()
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
        // three pieces of lines, and a sample of each line in the legend
        assert_eq!(svg.matches("L").count(), 5);
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

    #[test]
    fn a_picture_shows_the_lines_and_letters() {
        let mut plot = plot(vec![(0.0, 0.0), (1e-6, 2.3e7)]);
        plot.series
            .push(Series::line("circles", vec![(0.5e-6, 1e7)]).with(Look::Circles, 1));
        plot.series
            .push(Series::line("dots", vec![(0.0, 2e7), (1e-6, 1e7)]).with(Look::Dotted, 2));
        let image = plot.to_image();
        assert_eq!((image.width(), image.height()), (1260, 840));
        let count = |of: [u8; 3]| image.pixels().iter().filter(|p| **p == of).count();
        // blue line, orange circle, green dots, ink of letters and axes
        for (colour, least) in [
            ([0, 0x72, 0xb2], 1000),
            ([0xd5, 0x5e, 0], 10),
            ([0, 0x9e, 0x73], 50),
            (INK, 300),
        ] {
            assert!(count(colour) > least, "{colour:?}: {}", count(colour));
        }
        assert!(image.to_png().unwrap().starts_with(b"\x89PNG"));
    }
}
