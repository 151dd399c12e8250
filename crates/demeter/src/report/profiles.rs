//! Profiles as pictures, of some of their moments.

use super::figures::quantity;
use super::html::{Html, escaped};
use crate::output::{Plot, Series};
use crate::results::{Column, Columns};
use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use std::ops::Range;

/// Most profiles of a page; `demeter plot` draws the others.
pub(super) const MOST: usize = 12;
/// Most moments in a picture.
const MOMENTS: usize = 4;
/// What is drawn over the place.
const SHOWN: [&str; 5] = [
    "packing fraction",
    "velocity x",
    "velocity y",
    "velocity z",
    "fluctuation",
];

/// The pictures of a profile: those of quantities that some moment has.
pub(super) struct Profile {
    pub name: String,
    plots: Vec<Plot>,
}

impl Profile {
    pub fn new(name: &str, table: &Columns) -> Self {
        let numbers = |title: &str| table.find(title).and_then(Column::numbers);
        let (Some(steps), Some(times), Some(place)) = (numbers("step"), numbers("time"), table.find("place")) else {
            return Self {
                name: name.to_string(),
                plots: Vec::new(),
            };
        };
        let places = place.numbers().unwrap_or_default();
        let moments = some_moments(steps);
        let plot = |shown: &str| {
            let column = table.find(shown)?;
            let values = column.numbers()?;
            let is_told = |row: usize| values[row].is_finite() && values[row] != 0.0;
            if !moments.iter().any(|rows| rows.clone().any(is_told)) {
                return None;
            }
            let line = |rows: &Range<usize>| {
                let points = rows.clone().map(|row| (places[row], values[row])).collect();
                Series::line(quantity(times[rows.start], "s"), points)
            };
            Some(Plot {
                title: format!("{name}: {shown}"),
                x_label: place.title.clone(),
                y_label: column.title.clone(),
                series: moments.iter().map(line).collect(),
                ..Plot::default()
            })
        };
        Self {
            name: name.to_string(),
            plots: SHOWN.into_iter().filter_map(plot).collect(),
        }
    }

    pub fn write(&self, html: &mut Html) {
        html.element("h3", &format!("Profile {}", self.name));
        if self.plots.is_empty() {
            html.element("p", "No grain was in it at the moments that would be shown.");
        }
        html.raw("<div class=\"plot-grid\">");
        for plot in &self.plots {
            html.raw(&format!(
                "<img width=\"100%\" alt=\"{}\" src=\"data:image/svg+xml;base64,{}\">",
                escaped(&plot.title),
                STANDARD.encode(plot.to_svg())
            ));
        }
        html.raw("</div>");
    }
}

/// The rows of some moments, as far apart as each other, the last among them.
fn some_moments(steps: &[f64]) -> Vec<Range<usize>> {
    let mut all: Vec<Range<usize>> = Vec::new();
    for (row, step) in steps.iter().enumerate() {
        match all.last_mut() {
            Some(rows) if steps[rows.start] == *step => rows.end = row + 1,
            _ => all.push(row..row + 1),
        }
    }
    let count = all.len().min(MOMENTS);
    (1..=count)
        .map(|k| all[(k * all.len()).div_ceil(count) - 1].clone())
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_moment_and_some_before_are_drawn() {
        assert!(some_moments(&[]).is_empty());
        assert_eq!(some_moments(&[7.0, 7.0, 8.0]), [0..2, 2..3]);
        let steps: Vec<f64> = (0..9).flat_map(|step| [f64::from(step); 2]).collect();
        assert_eq!(some_moments(&steps), [4..6, 8..10, 12..14, 16..18]);
    }

    #[test]
    fn what_no_grain_has_is_not_drawn() {
        let place = tempfile::tempdir().unwrap();
        let file = place.path().join("layers.csv");
        let text = "step,time [s],place [m],packing fraction,velocity x [m/s],velocity y [m/s]\n\
                    0,0,0.1,0,,0\n0,0,0.2,0,,0\n5,0.5,0.1,0.6,0.25,0\n5,0.5,0.2,0.5,0.75,0\n";
        std::fs::write(&file, text).unwrap();
        let profile = Profile::new("<layers>", &Columns::read(&file).unwrap());
        let titles: Vec<&str> = profile.plots.iter().map(|plot| plot.title.as_str()).collect();
        assert_eq!(titles, ["<layers>: packing fraction", "<layers>: velocity x"]);
        assert_eq!(profile.plots[1].series[1].points, [(0.1, 0.25), (0.2, 0.75)]);
        assert_eq!(profile.plots[1].series[1].name, "500 ms");
        let mut html = Html::default();
        profile.write(&mut html);
        let page = html.as_str();
        assert!(
            page.contains("<h3>Profile &lt;layers&gt;</h3>") && !page.contains("<layers>"),
            "{page}"
        );
        assert_eq!(page.matches("src=\"data:image/svg+xml;base64,").count(), 2);
    }
}
