//! The legend of a plot.

use super::axis::Axis;
use super::{BOTTOM, HEIGHT, LEFT, Look, Plot, RIGHT, Series, TOP, WIDTH, colour, escape, put};

/// Height of an entry [pixels].
const ENTRY: f64 = 22.0;

/// Draws the legend, in the corner where it hides least; none when fewer than two series have names.
pub(super) fn legend(plot: &Plot, svg: &mut String, x: &Axis, y: &Axis) {
    let named: Vec<(usize, &Series)> = plot
        .series
        .iter()
        .enumerate()
        .filter(|s| !s.1.name.is_empty())
        .collect();
    if named.len() < 2 {
        return;
    }
    let longest = named.iter().map(|(_, s)| s.name.chars().count()).max().unwrap_or(0);
    let width = 56.0 + 7.4 * longest as f64;
    let height = 12.0 + ENTRY * named.len() as f64;
    let Some((left, top)) = place(plot, x, y, (width, height)) else {
        return;
    };
    put(
        svg,
        format_args!(
            "<rect x=\"{left:.1}\" y=\"{top:.1}\" width=\"{width:.1}\" height=\"{height:.1}\" rx=\"3\" \
             fill=\"#ffffff\" fill-opacity=\"0.85\" stroke=\"#d5d9dd\"/>"
        ),
    );
    for (entry, (place, series)) in named.into_iter().enumerate() {
        let line = top + 17.0 + ENTRY * entry as f64;
        let (start, end, text, base) = (left + 10.0, left + 38.0, left + 46.0, line + 5.0);
        let (colour, look) = (colour(series, place), series.look.attributes());
        let sample = match series.look {
            Look::Circles => format!(
                "<circle fill=\"none\" cx=\"{:.1}\" cy=\"{line:.1}\" r=\"4\"",
                left + 24.0
            ),
            _ => format!("<path fill=\"none\" stroke-linecap=\"round\" d=\"M{start:.1} {line:.1}H{end:.1}\""),
        };
        let thick = if series.look == Look::Circles {
            ""
        } else {
            " stroke-width=\"2\""
        };
        put(svg, format_args!("{sample} stroke=\"{colour}\"{thick}{look}/>"));
        put(
            svg,
            format_args!("<text x=\"{text:.1}\" y=\"{base:.1}\">{}</text>", escape(&series.name)),
        );
    }
}

/// The corner in which a box of this size hides the least of the lines.
fn place(plot: &Plot, x: &Axis, y: &Axis, (width, height): (f64, f64)) -> Option<(f64, f64)> {
    let (right, bottom) = (WIDTH - RIGHT - width - 10.0, HEIGHT - BOTTOM - height - 10.0);
    let corners = [
        (LEFT + 12.0, TOP + 6.0),
        (right, TOP + 6.0),
        (right, bottom),
        (LEFT + 12.0, bottom),
    ];
    let hidden = |&(left, top): &(f64, f64)| {
        let inside = |px: f64, py: f64| px > left && px < left + width && py > top && py < top + height;
        plot.series
            .iter()
            .map(|s| hidden_points(s, x, y, inside))
            .sum::<usize>()
    };
    corners.into_iter().min_by_key(hidden)
}

/// Samples of a line between two of its points.
const SAMPLES: usize = 8;

/// Lines of more points than this are looked at by their points alone.
const MANY_POINTS: usize = 10_000;

fn hidden_points(series: &Series, x: &Axis, y: &Axis, inside: impl Fn(f64, f64) -> bool) -> usize {
    let pixels: Vec<(f64, f64)> = (series.points.iter())
        .filter(|p| x.shows(p.0) && y.shows(p.1))
        .map(|p| (x.pixel(p.0), y.pixel(p.1)))
        .collect();
    let at_points = pixels.iter().filter(|p| inside(p.0, p.1)).count();
    if series.look == Look::Circles || pixels.len() > MANY_POINTS {
        return at_points;
    }
    // a line hides between its points, too; short pieces weigh little
    let between = |pair: &[(f64, f64)]| {
        let (dx, dy) = (pair[1].0 - pair[0].0, pair[1].1 - pair[0].1);
        let count = (((dx * dx + dy * dy).sqrt() / 20.0) as usize).min(SAMPLES);
        (1..=count)
            .map(|k| k as f64 / (count + 1) as f64)
            .filter(|share| inside(pair[0].0 + share * dx, pair[0].1 + share * dy))
            .count()
    };
    at_points + pixels.windows(2).map(between).sum::<usize>()
}
