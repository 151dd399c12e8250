//! What the runs of a study found, beside the law.

use super::studies::GRAIN;
use super::{BulkError, Kind, Line, Study, fit_line};
use crate::folder::told;
use demeter::output::{Look, Plot, Series};
use demeter::results::Columns;
use std::f64::consts::PI;
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

/// Gravity of all scenarios [m/s^2].
const GRAVITY: f64 = 9.81;
/// Beverloo's constant of the orifice, for spheres.
const EMPTY_RING: f64 = 1.4;
/// Time after opening from which the discharge counts as steady [s].
const STEADY_AFTER: f64 = 0.15;
/// Share of the mass after whose outflow the discharge no longer counts.
const STEADY_SHARE: f64 = 0.6;

/// What a study found.
#[derive(Clone, Debug, PartialEq)]
pub struct Findings {
    /// Titles of the columns.
    pub titles: Vec<&'static str>,
    /// A row per point, or per layer of a column.
    pub rows: Vec<Vec<f64>>,
    /// What follows from them, in words.
    pub words: Vec<String>,
    /// The numbers in the words, by name.
    pub numbers: Vec<(&'static str, f64)>,
    /// Rows and law, drawn.
    pub plot: Plot,
    /// Largest residual of the energy books of any run.
    pub residual: f64,
}

impl Findings {
    /// A number by its name; NaN when there is none.
    pub fn number(&self, name: &str) -> f64 {
        let found = self.numbers.iter().find(|(known, _)| *known == name);
        found.map_or(f64::NAN, |(_, value)| *value)
    }
}

/// Reads the runs of a study.
pub fn find(study: &Study, runs: &[(f64, PathBuf)]) -> Result<Findings, BulkError> {
    let mut findings = match study.kind {
        Kind::Beverloo => beverloo(runs),
        Kind::Janssen => janssen(runs),
        Kind::Repose => repose(runs),
    }?;
    let residual = |(_, folder): &(f64, PathBuf)| {
        let energies = told(&folder.join("summary.json"), "energies");
        energies
            .and_then(|e| e.get("max_residual")?.as_f64())
            .unwrap_or(f64::NAN)
    };
    findings.residual = runs.iter().map(residual).fold(0.0, f64::max);
    Ok(findings)
}

/// Discharge: `W = C rho sqrt(g) (D - k d)^(5/2)` (Beverloo, Leniger and van de Velde, Chem. Eng. Sci. 15, 260, 1961).
fn beverloo(runs: &[(f64, PathBuf)]) -> Result<Findings, BulkError> {
    let mut rows = Vec::new();
    let mut density = 0.0;
    for (ratio, folder) in runs {
        let series = Columns::series_of(folder)?;
        let (time, stage) = (series.numbers("time [s]")?, series.words("stage")?);
        let out = series.numbers("outlet mass forward [kg]")?;
        let too_short = |problem| BulkError::TooShort {
            folder: folder.clone(),
            problem,
        };
        let open = stage.iter().position(|s| *s == "flow");
        let open = open.ok_or_else(|| too_short("the orifice was not opened"))?;
        let begins = time[open.saturating_sub(1)];
        let whole = told(&folder.join("summary.json"), "grains").and_then(|n| n.as_f64());
        let bulk = series.numbers("bulk mass [kg]")?[open.saturating_sub(1)] / (PI * 30e-3f64.powi(2) * 50e-3);
        density += bulk / runs.len() as f64;
        let left = whole.unwrap_or(0.0) * 2500.0 * PI / 6.0 * GRAIN.powi(3);
        let last = out.last().copied().unwrap_or(0.0);
        let points: Vec<(f64, f64)> = (time.iter().zip(out))
            .filter(|(t, m)| **t > begins + STEADY_AFTER && **m < STEADY_SHARE * (last + left))
            .map(|(t, m)| (*t, *m))
            .collect();
        if points.len() < 10 {
            return Err(too_short("fewer than ten rows of steady discharge"));
        }
        let rate = fit_line(&points).slope;
        let scaled = rate / (bulk * GRAVITY.sqrt() * GRAIN.powf(2.5));
        rows.push(vec![*ratio, rate, bulk, scaled]);
    }
    let (exponent, law) = (free_exponent(&rows), beverloo_line(&rows));
    let constant = law.slope.powf(2.5);
    let ring = -law.offset / law.slope;
    let mut curve = Vec::new();
    for k in 0..=100 {
        let ratio = 1.0 + 0.08 * f64::from(k);
        if ratio > ring {
            curve.push((ratio, constant * (ratio - ring).powf(2.5)));
        }
    }
    Ok(Findings {
        words: vec![
            format!(
                "exponent {:.2} of (D - {EMPTY_RING} d), R^2 {:.4}; Beverloo: 2.5",
                exponent.slope, exponent.explained
            ),
            format!(
                "with the exponent 2.5: C = {constant:.3}, k = {ring:.2} (R^2 {:.5}); Beverloo: C 0.55 to 0.65, k 1 to 2, 1.4 \
                 for spheres",
                law.explained
            ),
            format!("bulk density {density:.0} kg/m^3"),
        ],
        numbers: vec![
            ("exponent", exponent.slope),
            ("constant", constant),
            ("ring", ring),
            ("explained", law.explained),
        ],
        plot: Plot {
            title: "Discharge of a silo: Beverloo's law".into(),
            x_label: "orifice over grain diameter".into(),
            y_label: "W / (rho sqrt(g) d^(5/2))".into(),
            series: vec![
                Series::line("simulated", pairs(&rows, 0, 3)).with(Look::Circles, 0),
                Series::line(format!("{constant:.3} (D/d - {ring:.2})^2.5"), curve).with(Look::Line, 1),
            ],
            ..Plot::default()
        },
        titles: vec![
            "orifice over grain diameter",
            "mass rate [kg/s]",
            "bulk density [kg/m^3]",
            "scaled rate",
        ],
        rows,
        residual: 0.0,
    })
}

/// Exponent of the orifice less Beverloo's ring.
fn free_exponent(rows: &[Vec<f64>]) -> Line {
    let logarithms: Vec<(f64, f64)> = (rows.iter())
        .map(|row| ((row[0] - EMPTY_RING).ln(), row[3].ln()))
        .collect();
    fit_line(&logarithms)
}

/// The rates to the power 2/5 lie on a straight line, which crosses zero at the ring.
fn beverloo_line(rows: &[Vec<f64>]) -> Line {
    let roots: Vec<(f64, f64)> = rows.iter().map(|row| (row[0], row[3].powf(0.4))).collect();
    fit_line(&roots)
}

fn pairs(rows: &[Vec<f64>], x: usize, y: usize) -> Vec<(f64, f64)> {
    rows.iter().map(|row| (row[x], row[y])).collect()
}

/// Radius of the column [m].
const COLUMN: f64 = 25e-3;

/// What the floor carries: `M_inf (1 - exp(-M/M_inf))` (Janssen, Z. Ver. dt. Ing. 39, 1045, 1895).
fn janssen(runs: &[(f64, PathBuf)]) -> Result<Findings, BulkError> {
    let mut rows = Vec::new();
    let mut words = Vec::new();
    let mut numbers = Vec::new();
    let mut plot = Plot {
        title: "What the floor of a column carries: Janssen's law".into(),
        x_label: "mass in the column [g]".into(),
        y_label: "mass that the floor carries [g]".into(),
        ..Plot::default()
    };
    for (k, (friction, folder)) in runs.iter().enumerate() {
        let series = Columns::series_of(folder)?;
        let (stage, mass) = (series.words("stage")?, series.numbers("column mass [kg]")?);
        let (force, bulk) = (
            series.numbers("wall floor force z [N]")?,
            series.numbers("bulk mass [kg]")?,
        );
        let mut layers: Vec<(f64, f64)> = Vec::new();
        for row in 0..stage.len() {
            let ends = stage.get(row + 1) != Some(&stage[row]);
            if stage[row].starts_with("sink") && ends {
                layers.push((mass[row], -force[row] / GRAVITY));
                rows.push(vec![*friction, mass[row], -force[row] / GRAVITY]);
            }
        }
        let [.., before, last] = layers.as_slice() else {
            return Err(BulkError::TooShort {
                folder: folder.clone(),
                problem: "fewer than two layers",
            });
        };
        let limit = saturation(&layers);
        let deviation = (misfit(&layers, limit) / layers.len() as f64).sqrt() / limit;
        let density = bulk.last().copied().unwrap_or(f64::NAN) / (PI * 18e-3f64.powi(2) * 40e-3);
        // M_inf = rho A D / (4 mu K)
        let ratio = density * PI * COLUMN.powi(3) / (2.0 * friction * limit);
        let passed = (last.1 - before.1) / (last.0 - before.0);
        words.push(format!(
            "friction {friction}: the floor carries {:.1} g at most, within {:.1} % of Janssen's law; of the last layer it \
             carries {:.1} %; pressure ratio K = {ratio:.2} with the bulk density {density:.0} kg/m^3",
            1e3 * limit,
            1e2 * deviation,
            1e2 * passed
        ));
        numbers.extend([
            ("saturation", limit),
            ("deviation", deviation),
            ("passed", passed),
            ("pressure ratio", ratio),
        ]);
        let grams = |(m, f): &(f64, f64)| (1e3 * m, 1e3 * f);
        let law = |m: f64| (1e3 * m, 1e3 * limit * (1.0 - (-m / limit).exp()));
        let curve = (0..=100).map(|n| law(last.0 * f64::from(n) / 100.0)).collect();
        let name = format!("friction {friction}");
        plot.series
            .push(Series::line(name, layers.iter().map(grams).collect()).with(Look::Circles, k));
        plot.series.push(Series::line("", curve).with(Look::Line, k));
        plot.series.push(
            Series::line(
                if k == 0 { "weight" } else { "" },
                vec![(0.0, 0.0), (1e3 * last.0, 1e3 * last.0)],
            )
            .with(Look::Dashed, 7),
        );
    }
    Ok(Findings {
        titles: vec!["friction", "mass in the column [kg]", "mass on the floor [kg]"],
        rows,
        words,
        numbers,
        plot,
        residual: 0.0,
    })
}

/// Sum of squares between layers and Janssen's law [kg^2].
fn misfit(layers: &[(f64, f64)], limit: f64) -> f64 {
    let square = |(mass, carried): &(f64, f64)| (limit * (1.0 - (-mass / limit).exp()) - carried).powi(2);
    layers.iter().map(square).sum()
}

/// The limit of the floor's load that fits best, by golden section over four decades.
fn saturation(layers: &[(f64, f64)]) -> f64 {
    let most = layers.iter().map(|l| l.1).fold(0.0, f64::max);
    let share = 0.5 * (5f64.sqrt() - 1.0);
    let (mut low, mut high) = ((0.1 * most).ln(), (1e3 * most).ln());
    for _ in 0..100 {
        let (a, b) = (high - share * (high - low), low + share * (high - low));
        if misfit(layers, a.exp()) < misfit(layers, b.exp()) {
            high = b;
        } else {
            low = a;
        }
    }
    (0.5 * (low + high)).exp()
}

/// Slope of the heap at the end of each run.
fn repose(runs: &[(f64, PathBuf)]) -> Result<Findings, BulkError> {
    let mut rows = Vec::new();
    for (friction, folder) in runs {
        let series = Columns::series_of(folder)?;
        let angle = series.numbers("slope angle [deg]")?;
        let deviation = series.numbers("slope deviation [m]")?;
        let last = |column: &[f64]| column.last().copied().unwrap_or(f64::NAN);
        rows.push(vec![*friction, last(angle), last(deviation)]);
    }
    let rises = rows.windows(2).all(|two| two[1][1] > two[0][1]);
    let told: Vec<String> = rows
        .iter()
        .map(|row| format!("{:.1} deg at {}", row[1], row[0]))
        .collect();
    Ok(Findings {
        words: vec![format!(
            "angle of repose by friction: {}: it {}",
            told.join(", "),
            if rises { "rises" } else { "does not rise throughout" }
        )],
        numbers: vec![("rises", f64::from(u8::from(rises)))],
        plot: Plot {
            title: "Angle of repose".into(),
            x_label: "friction".into(),
            y_label: "slope of the heap [deg]".into(),
            series: vec![
                Series::line("", pairs(&rows, 0, 1)).with(Look::Circles, 0),
                Series::line("", pairs(&rows, 0, 1)).with(Look::Line, 0),
            ],
            ..Plot::default()
        },
        titles: vec!["friction", "slope [deg]", "deviation of the surface [m]"],
        rows,
        residual: 0.0,
    })
}

/// Writes rows as CSV, the figure as SVG and the words as text; answers with the words.
pub fn write_findings(findings: &Findings, study: &Study, out: &Path) -> Result<String, BulkError> {
    fs::create_dir_all(out).map_err(BulkError::io("make the folder", out))?;
    let mut table = findings.titles.join(",");
    table.push('\n');
    for row in &findings.rows {
        let cells: Vec<String> = row.iter().map(f64::to_string).collect();
        // Writing to a String cannot fail.
        let _ = writeln!(table, "{}", cells.join(","));
    }
    let mut words = findings.words.join("\n");
    let _ = write!(words, "\nlargest energy residual {:.1e}", findings.residual);
    for (ending, text) in [("csv", &table), ("txt", &format!("{words}\n"))] {
        let path = out.join(format!("{}.{ending}", study.name));
        fs::write(&path, text).map_err(BulkError::io("write", &path))?;
    }
    findings.plot.write_svg(&out.join(format!("{}.svg", study.name)))?;
    Ok(words)
}
