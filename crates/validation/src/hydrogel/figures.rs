//! Figures 3 to 6 of the paper, drawn anew, each with a check.

use super::results::{Also, ModelResult};
use super::{RESOLUTION, Results, ValidationError};
use demeter::compare::{Level, Phase, Strokes};
use demeter::output::{Look, Plot, Series, Sheet};
use std::fmt;
use std::path::Path;

/// Compression at which figure 4 shows the forces while unloading, counted from the first touch [m].
const FORCES_AT: f64 = 18e-3;
/// Share of the whole compression taken in its place where the stroke is another one: 18 of 25.1 mm.
const FORCES_AT_SHARE: f64 = 0.717;
/// Width of the bars of figure 4 [N].
const BAR: f64 = 10e-3;
/// Colour of what is told beside the models.
const GREY: usize = 7;

/// What was compared in a figure.
#[derive(Clone, Debug, PartialEq)]
pub struct Check {
    /// Name of the figure's file, without its ending.
    pub figure: &'static str,
    /// What was compared, and what came out.
    pub text: String,
}

impl fmt::Display for Check {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.figure, self.text)
    }
}

/// Draws the figures into a folder as SVG.
pub fn write_figures(results: &Results, out: &Path) -> Result<Vec<Check>, ValidationError> {
    std::fs::create_dir_all(out).map_err(ValidationError::io(out))?;
    let mut checks = Vec::new();
    for draw in [plate_force, force_distribution, contacts_per_grain, scaling] {
        let (check, sheet) = draw(results);
        sheet.write_svg(&out.join(format!("{}.svg", check.figure)))?;
        checks.push(check);
    }
    Ok(checks)
}

fn plot(title: &str, x_label: &str, y_label: &str) -> Plot {
    Plot {
        title: title.to_string(),
        x_label: x_label.to_string(),
        y_label: y_label.to_string(),
        ..Plot::default()
    }
}

/// An entry of the legend that explains a look.
fn explains(name: &str, look: Look) -> Series {
    Series::line(name, Vec::new()).with(look, GREY)
}

/// Loading as a line, unloading dashed, over the compression in mm.
fn both_phases(results: &Results, plot: &mut Plot, value: impl Fn(&ModelResult, &Level) -> Option<f64>) {
    for result in &results.models {
        for (phase, look) in [(Phase::Loading, Look::Line), (Phase::Unloading, Look::Dashed)] {
            let points = (result.strokes.levels(phase).iter())
                .filter_map(|level| Some((1e3 * level.position, value(result, level)?)))
                .collect();
            let name = match phase {
                Phase::Loading => result.model.label(results.prefactor),
                Phase::Unloading => String::new(),
            };
            plot.series
                .push(Series::line(name, points).with(look, result.model.place()));
        }
    }
    plot.series.push(explains("dashed: unloading", Look::Dashed));
}

/// What was measured, where there is a curve.
fn add_measured(results: &Results, plot: &mut Plot, value: impl Fn(&Level) -> Option<f64>) {
    let Some(curve) = &results.measured else {
        return;
    };
    let levels = Phase::ALL.into_iter().flat_map(|phase| curve.levels(phase));
    let points: Vec<(f64, f64)> = levels
        .filter_map(|level| Some((1e3 * level.position, value(level)?)))
        .collect();
    if !points.is_empty() {
        plot.series
            .push(Series::line("measured", points).with(Look::Circles, GREY));
    }
}

/// The largest of numbers that are not negative.
fn largest(values: impl Iterator<Item = f64>) -> f64 {
    values.fold(0.0, f64::max)
}

/// Difference of two numbers over the larger one.
fn difference(a: f64, b: f64) -> f64 {
    if a == b {
        0.0
    } else {
        (a - b).abs() / a.abs().max(b.abs())
    }
}

/// All levels of a run.
fn levels(strokes: &Strokes) -> impl Iterator<Item = &Level> {
    Phase::ALL.into_iter().flat_map(|phase| strokes.levels(phase))
}

/// Figure 3.
fn plate_force(results: &Results) -> (Check, Sheet) {
    let mut shown = plot(
        "Force on the plate (fig 3)",
        "compression from the first touch [mm]",
        "force on the plate [N]",
    );
    both_phases(results, &mut shown, |_, level| level.force.map(|force| force.value));
    add_measured(results, &mut shown, |level| level.force.map(|force| force.value));
    if let Some(top) = results.models.last().and_then(|m| m.strokes.loading.last()) {
        let point = vec![(1e3 * top.position, results.standards.top_force)];
        let name = format!("measured, {} N", results.standards.top_force);
        shown.series.push(Series::line(name, point).with(Look::Circles, GREY));
    }
    let work = results.models.iter().flat_map(|m| {
        let both = |phase| Some(difference(m.work_of(phase), m.booked_work_of(phase)?));
        Phase::ALL.into_iter().filter_map(both)
    });
    let lost: Vec<String> = (results.models.iter())
        .map(|m| format!("{} {:.1} %", m.model.name, 100.0 * m.lost()))
        .collect();
    let text = format!(
        "area under the curves against the work in the energy books, largest difference {:.1e}; work that is lost per cycle: {}",
        largest(work),
        lost.join(", ")
    );
    let sheet = Sheet {
        plots: vec![shown],
        columns: 1,
    };
    let figure = "figure3-plate-force";
    (Check { figure, text }, sheet)
}

/// Where figure 4 shows the forces: at 18 mm, or as far along another stroke.
fn forces_at(results: &Results) -> f64 {
    let end = results.models.last().and_then(|m| m.strokes.loading.last());
    let end = end.map_or(0.0, |level| level.position);
    if (FORCES_AT / end - FORCES_AT_SHARE).abs() < 1e-2 {
        FORCES_AT
    } else {
        FORCES_AT_SHARE * end
    }
}

/// Densities of the forces between grains in bars [mN, 1/N], and their sum.
fn densities(result: &ModelResult, level: &Level) -> Option<Vec<(f64, f64)>> {
    let (bins, contacts) = (result.bins()?, level.contacts.as_ref()?);
    let all: f64 = contacts.pairs.iter().sum();
    let (lowest, highest) = (*bins.edges().first()?, *bins.edges().last()?);
    let bars = ((highest - lowest) / BAR).ceil().max(1.0) as usize;
    let mut counts = vec![0.0; bars];
    for (edges, count) in bins.edges().windows(2).zip(&contacts.pairs) {
        let middle = 0.5 * (edges[0] + edges[1]);
        let bar = (((middle - lowest) / BAR) as usize).min(bars - 1);
        counts[bar] += count;
    }
    let last = counts.iter().rposition(|count| *count > 0.0)? + 1;
    let centre = |k: usize| 1e3 * (lowest + (k as f64 + 0.5) * BAR);
    let density = |count: &f64| count / (all * BAR);
    Some(
        counts
            .iter()
            .take(last)
            .enumerate()
            .map(|(k, count)| (centre(k), density(count)))
            .collect(),
    )
}

/// Figure 4.
fn force_distribution(results: &Results) -> (Check, Sheet) {
    let at = forces_at(results);
    let title = format!("Forces between grains, unloading at {:.1} mm (fig 4)", 1e3 * at);
    let mut plots = [
        plot(&title, "normal force [mN]", "density of contacts [1/N]"),
        plot(
            "the same, logarithmic",
            "normal force [mN]",
            "density of contacts [1/N]",
        ),
    ];
    plots[1].y.logarithmic = true;
    let (mut counted, mut shares) = (0.0, Vec::new());
    for result in &results.models {
        let Some(level) = result.strokes.at(Phase::Unloading, at) else {
            continue;
        };
        let Some(points) = densities(result, &level) else {
            continue;
        };
        for plot in &mut plots {
            let name = result.model.label(results.prefactor);
            plot.series
                .push(Series::line(name, points.clone()).with(Look::Line, result.model.place()));
        }
        counted = largest([counted, miscounted(result)].into_iter());
        if let Some(force) = level.force {
            shares.push(format!("{} {:.2}", result.model.name, force.value / result.top.value));
        }
    }
    let text = format!(
        "contacts at and above the threshold in the distribution, against those that the contact network counts, largest \
         difference at any level {counted:.1e}; force on the plate at {:.1} mm over that at full compression: {}",
        1e3 * at,
        shares.join(", ")
    );
    let sheet = Sheet {
        plots: plots.to_vec(),
        columns: 2,
    };
    let figure = "figure4-force-distributions";
    (Check { figure, text }, sheet)
}

/// Contacts between grains above [`RESOLUTION`] by two ways: the distribution and the network.
fn miscounted(result: &ModelResult) -> f64 {
    let Some(bins) = result.bins() else {
        return f64::NAN;
    };
    let first = bins.edges().partition_point(|edge| *edge < RESOLUTION * (1.0 - 1e-9));
    largest(levels(&result.strokes).filter_map(|level| {
        let above: f64 = level.contacts.as_ref()?.pairs.iter().skip(first).sum();
        Some(difference(above, Also::Contacts.at(level)))
    }))
}

/// Figure 5.
fn contacts_per_grain(results: &Results) -> (Check, Sheet) {
    let title = format!("Contacts per grain of {} mN and more (fig 5)", 1e3 * RESOLUTION);
    let mut shown = plot(&title, "compression from the first touch [mm]", "contacts per grain Z");
    let above = |result: &ModelResult, level: &Level| level.contacts.as_ref()?.coordination(result.bins()?, RESOLUTION);
    both_phases(results, &mut shown, above);
    add_measured(results, &mut shown, |level| level.coordination);
    let differences = results.models.iter().flat_map(|result| {
        levels(&result.strokes)
            .filter_map(move |level| Some(difference(above(result, level)?, Also::Coordination.at(level))))
    });
    let text = format!(
        "Z of the distribution against that of the contact network, largest difference {:.1e}",
        largest(differences)
    );
    let sheet = Sheet {
        plots: vec![shown],
        columns: 1,
    };
    let figure = "figure5-contacts";
    (Check { figure, text }, sheet)
}

/// A straight line through points, and the root mean square of what is left over the largest value.
fn line_through(points: &[(f64, f64)]) -> (f64, f64, f64) {
    let n = points.len() as f64;
    let mean = |of: fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / n;
    let (x, y) = (mean(|p| p.0), mean(|p| p.1));
    let sum = |of: &dyn Fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>();
    let slope = sum(&|p| (p.0 - x) * (p.1 - y)) / sum(&|p| (p.0 - x) * (p.0 - x));
    let left = (sum(&|p| (p.1 - y - slope * (p.0 - x)).powi(2)) / n).sqrt();
    (slope, y - slope * x, left / largest(points.iter().map(|p| p.1)))
}

/// Figure 6.
fn scaling(results: &Results) -> (Check, Sheet) {
    let mut shown = plot(
        "Scaling of the force on the plate (fig 6)",
        "⟨Z⟩⟨φ⟩⟨b⟩⟨f⟩ [mN m]",
        "force on the plate [N]",
    );
    let (mut told, mut means) = (Vec::new(), 0.0);
    for result in &results.models {
        let mut all: Vec<(f64, f64)> = Vec::new();
        for (phase, look) in [(Phase::Loading, Look::Line), (Phase::Unloading, Look::Dashed)] {
            let points: Vec<(f64, f64)> = (result.strokes.levels(phase).iter())
                .filter_map(|level| Some((1e3 * Also::product(level), level.force?.value)))
                .collect();
            all.extend(points.iter().filter(|point| point.0.is_finite()));
            let name = match phase {
                Phase::Loading => result.model.label(results.prefactor),
                Phase::Unloading => String::new(),
            };
            shown
                .series
                .push(Series::line(name, points).with(look, result.model.place()));
        }
        let (slope, _, left) = line_through(&all);
        told.push(format!(
            "{} {slope:.2} N/(mN m), {:.1} %",
            result.model.name,
            100.0 * left
        ));
        means = largest([means, mean_of_product(result)].into_iter());
    }
    shown.series.push(explains("dashed: unloading", Look::Dashed));
    let text = format!(
        "slope of the straight line through all levels, and root mean square distance from it over the largest force: {}; \
         product of the means against mean of the product, largest difference above a tenth of its largest value {means:.1e}",
        told.join("; ")
    );
    let sheet = Sheet {
        plots: vec![shown],
        columns: 1,
    };
    let figure = "figure6-scaling";
    (Check { figure, text }, sheet)
}

/// Largest difference between the product of the means and the mean of the product, where the latter is not small.
fn mean_of_product(result: &ModelResult) -> f64 {
    let highest = largest(levels(&result.strokes).map(|level| Also::Scaling.at(level)));
    let large = levels(&result.strokes).filter(|level| Also::Scaling.at(level) > 0.1 * highest);
    largest(large.map(|level| difference(Also::product(level), Also::Scaling.at(level))))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_goes_through_its_points() {
        let (slope, start, left) = line_through(&[(0.0, 1.0), (1.0, 3.0), (2.0, 5.0)]);
        assert!((slope - 2.0).abs() < 1e-15 && (start - 1.0).abs() < 1e-15 && left < 1e-15);
        let (slope, _, left) = line_through(&[(0.0, 1.0), (1.0, 0.0), (2.0, 1.0)]);
        assert!(slope.abs() < 1e-15 && (left - (2.0f64 / 9.0).sqrt()).abs() < 1e-15);
    }

    #[test]
    fn differences_are_relative() {
        assert_eq!(
            [difference(0.0, 0.0), difference(1.0, 2.0), difference(-4.0, 4.0)],
            [0.0, 0.5, 2.0]
        );
        assert!(largest([0.0, f64::NAN, 0.5].into_iter()) == 0.5);
    }
}
