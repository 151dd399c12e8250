//! The legend of a plot.

use super::axis::Axis;
use super::canvas::{Anchor, Canvas, Label, Letters, Pen};
use super::{BOTTOM, HEIGHT, LEFT, Look, Plot, RIGHT, Series, TOP, WIDTH, colour};

/// Width of a letter [pixels].
const LETTER: f64 = 7.4;
/// Height of an entry [pixels].
const ENTRY: f64 = 22.0;

/// Most entries: more would cover the plot.
const MOST_ENTRIES: usize = 12;

/// Draws the legend, in the corner where it hides least; none when fewer than two series have names. Of very many it names the first ones
/// and the last.
pub(super) fn legend(plot: &Plot, on: &mut dyn Canvas, x: &Axis, y: &Axis) {
    let named: Vec<(usize, &Series)> = plot
        .series
        .iter()
        .enumerate()
        .filter(|s| !s.1.name.is_empty())
        .collect();
    if named.len() < 2 {
        return;
    }
    let left_out = named.len().saturating_sub(MOST_ENTRIES);
    let mut entries: Vec<(Option<usize>, &str)> = named.iter().map(|(k, s)| (Some(*k), &*s.name)).collect();
    let more = format!("and {left_out} between them");
    if left_out > 0 {
        let last = entries.len() - 1;
        entries.splice(last - left_out..last, [(None, &*more)]);
    }
    let longest = entries.iter().map(|(_, name)| name.chars().count()).max().unwrap_or(0);
    let width = 60.0 + LETTER * longest as f64;
    let height = 12.0 + ENTRY * entries.len() as f64;
    let Some((left, top)) = place(plot, x, y, (width, height)) else {
        return;
    };
    on.card([left, top, width, height]);
    for (entry, (series, name)) in entries.into_iter().enumerate() {
        let line = top + 17.0 + ENTRY * entry as f64;
        if let Some(place) = series {
            sample(&plot.series[place], place, (left, line), on);
        }
        on.text(
            (left + 46.0, line + 5.0),
            &Label::plain(name),
            Letters::new(Anchor::Start),
        );
    }
}

/// Draws a piece of a series beside its name.
fn sample(series: &Series, place: usize, (left, line): (f64, f64), on: &mut dyn Canvas) {
    let width = if series.look == Look::Circles {
        series.look.width()
    } else {
        2.0
    };
    let pen = Pen {
        colour: colour(series, place),
        width,
        look: series.look,
    };
    match series.look {
        Look::Circles => on.circles(&[(left + 24.0, line)], pen),
        _ => on.lines(&[vec![(left + 10.0, line), (left + 38.0, line)]], pen),
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
