//! `demeter contact-curve`.

use crate::answer::{Rows, answer, answer_json};
use crate::arguments::CurveArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::plot::write as write_plot;
use crate::readable::number;
use crate::table::{Cell, check_outputs, write_csv};
use demeter::calibrate::{ContactCurve, CurvePoint, Extremes, contact_curve as trace};
use demeter::output::{Plot, Series};
use demeter::scenario::ImpactFile;
use serde_json::{Value, json};

/// Traces the quasi-static curve of the law of a file.
pub fn contact_curve(arguments: &CurveArguments) -> Result<Exit, Failure> {
    check_outputs(
        &arguments.file,
        arguments.csv.as_deref(),
        arguments.plot.as_deref(),
        arguments.overwrite,
    )?;
    let file = ImpactFile::read(&arguments.file, &arguments.set)?;
    let curve = trace(&file)?;
    if let Some(path) = &arguments.csv {
        let rows = curve.points.iter().map(|p| {
            let [overlap, force, stored] = [p.overlap, p.force, p.stored].map(Cell::Number);
            vec![Cell::Word(p.branch.name()), overlap, force, stored]
        });
        write_csv(path, &["branch", "overlap [m]", "force [N]", "stored energy [J]"], rows)?;
    }
    if let Some(path) = &arguments.plot {
        write_plot(&plot(&file, &curve.points), path)?;
    }
    if arguments.json {
        let rows: Vec<Value> = (curve.points.iter())
            .map(|p| json!({ "branch": p.branch.name(), "overlap": p.overlap, "force": p.force, "stored": p.stored }))
            .collect();
        answer_json(&json!({ "curve": rows, "extremes": extremes(&curve.extremes) }))?;
    } else {
        answer(&to_text(&file, &curve))?;
    }
    Ok(Exit::Finished)
}

/// Runs of rows of one branch.
fn branches(curve: &[CurvePoint]) -> impl Iterator<Item = &[CurvePoint]> {
    curve.chunk_by(|a, b| a.branch == b.branch)
}

fn plot(file: &ImpactFile, curve: &[CurvePoint]) -> Plot {
    let line = |rows: &[CurvePoint]| {
        let name = rows.first().map_or("", |p| p.branch.name());
        Series::line(name, rows.iter().map(|p| (p.overlap, p.force)).collect())
    };
    Plot {
        title: format!("{}: quasi-static contact", file.name),
        x_label: "overlap [m]".to_string(),
        y_label: "normal force [N]".to_string(),
        series: branches(curve).map(line).collect(),
        ..Plot::default()
    }
}

fn extremes(found: &Extremes) -> Value {
    let pull = found.largest_pull;
    json!({
        "max_overlap": found.max_overlap,
        "max_force": found.max_force,
        "largest_pull": pull.map_or(0.0, |(force, _)| force),
        "overlap_at_largest_pull": pull.map(|(_, overlap)| overlap),
        "end_of_contact": found.end_of_contact,
    })
}

fn to_text(file: &ImpactFile, curve: &ContactCurve) -> String {
    let mut rows = Rows::default();
    for branch in branches(&curve.points) {
        let (Some(first), Some(last)) = (branch.first(), branch.last()) else {
            continue;
        };
        rows.add(
            first.branch.name(),
            format!(
                "overlap {} m to {} m, force {} N to {} N",
                number(first.overlap),
                number(last.overlap),
                number(first.force),
                number(last.force)
            ),
        );
    }
    if let Some((pull, overlap)) = curve.extremes.largest_pull {
        let (pull, overlap) = (number(pull), number(overlap));
        rows.add("largest pull", format!("{pull} N at an overlap of {overlap} m"));
    }
    if let Some(cut) = curve.cut_at() {
        let (end, cut) = (number(curve.extremes.end_of_contact), number(cut));
        rows.add(
            "end of contact",
            format!("at an overlap of {end} m; the curve is drawn to {cut} m only"),
        );
    }
    let law = file.choice().normal.law;
    format!(
        "`{law}`, quasi-static\n{}`--csv FILE` writes all {} rows, `--plot FILE.svg` draws them.\n",
        rows.lines(),
        curve.points.len()
    )
}
