//! `demeter sticking`.

use crate::answer::{answer, answer_json, note};
use crate::arguments::StickingArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::plot::write as write_plot;
use crate::readable::number;
use crate::table::{Cell, check_outputs, write_csv};
use demeter::calibrate::{StickingPoint, log_spaced, sticking as search};
use demeter::output::{AxisSpec, Plot, Series};
use demeter::scenario::{ImpactFile, units};
use demeter_physics::DVec3;
use demeter_physics::collision::Sticking;
use demeter_physics::dimension::Dimension;
use serde_json::{Value, json};

/// Radii when no number is told.
const POINTS: usize = 20;

/// Both are powers of each other over much of their range.
const LOGARITHMIC: AxisSpec = AxisSpec {
    logarithmic: true,
    range: None,
};

/// Finds the critical sticking speed against the effective radius.
pub fn sticking(arguments: &StickingArguments) -> Result<Exit, Failure> {
    check_outputs(
        &arguments.file,
        arguments.csv.as_deref(),
        arguments.plot.as_deref(),
        arguments.overwrite,
    )?;
    let file = ImpactFile::read(&arguments.file, &arguments.set)?;
    let (first, last) = radii(&arguments.radius)?;
    let count = match (first == last, arguments.points) {
        (true, None) => 1,
        (true, Some(points)) => {
            return Err(Failure::wrong(format!(
                "--points: `--radius {}` is one radius, and {points} are asked for; leave it out, or tell the first and the last radius, as \
                 0.1um..1um",
                arguments.radius
            )));
        }
        (false, points) => points.map_or(POINTS, usize::from),
    };
    let impact = &file.impact;
    if impact.angle != 0.0 || impact.spin_a != DVec3::ZERO || impact.spin_b != DVec3::ZERO {
        note("warning: the angle and the spins in [impact] are left out: bodies are tried head-on, without spin");
    }
    let found = search(&file, &log_spaced(first, last, count))?;
    let known: Vec<(f64, f64)> = found.iter().filter_map(speed).collect();
    if known.is_empty() {
        return Err(Failure::wrong(never_or_always(&found)));
    }
    for point in found.iter().filter(|p| speed(p).is_none()) {
        note(&format!("warning: {}", without_speed(point)));
    }
    let titles = ["effective radius [m]", "critical sticking velocity [m/s]"];
    if let Some(path) = &arguments.csv {
        let rows = known.iter().map(|p| vec![Cell::Number(p.0), Cell::Number(p.1)]);
        write_csv(path, &titles, rows)?;
    }
    if let Some(path) = &arguments.plot {
        let plot = Plot {
            title: format!("{}: bodies stick below", file.name),
            x_label: titles[0].to_string(),
            y_label: titles[1].to_string(),
            x: LOGARITHMIC,
            y: LOGARITHMIC,
            series: vec![Series::line(file.choice().normal.law, known.clone())],
        };
        write_plot(&plot, path)?;
    }
    if arguments.json {
        let rows: Vec<Value> = found
            .iter()
            .map(|p| json!({ "effective_radius": p.effective_radius, "velocity": speed(p).map(|p| p.1) }))
            .collect();
        answer_json(&Value::Array(rows))?;
    } else {
        let rows = known
            .iter()
            .map(|(r, v)| format!("  {:>12}  {:>12}\n", number(*r), number(*v)));
        let rows: String = rows.collect();
        answer(&format!(
            "bodies stick below\n  {:>12}  {:>12}\n{rows}",
            "R_eff [m]", "v [m/s]"
        ))?;
    }
    Ok(Exit::Finished)
}

/// Effective radius and critical speed, where there is one.
fn speed(point: &StickingPoint) -> Option<(f64, f64)> {
    match point.sticking {
        Sticking::Below(speed) => Some((point.effective_radius, speed)),
        Sticking::Never(_) | Sticking::From { .. } | Sticking::Always(_) => None,
    }
}

fn without_speed(point: &StickingPoint) -> String {
    let radius = number(point.effective_radius);
    match point.sticking {
        Sticking::Below(speed) => format!("at R_eff = {radius} m they stick below {} m/s", number(speed)),
        Sticking::Never(down_to) => format!(
            "at R_eff = {radius} m the bodies part at every speed, from {} m/s to that at which the overlap is larger than R_eff",
            number(down_to)
        ),
        Sticking::From { speed, .. } => format!(
            "at R_eff = {radius} m the bodies part below {} m/s and stick above it, up to some other speed (`demeter collide` tells \
             what becomes of one)",
            number(speed)
        ),
        Sticking::Always(up_to) => format!(
            "at R_eff = {radius} m the bodies stick at every speed, up to {} m/s, at which the overlap is larger than \
             R_eff",
            number(up_to)
        ),
    }
}

fn never_or_always(found: &[StickingPoint]) -> String {
    let told = found.first().map(without_speed).unwrap_or_default();
    let reason = match found.first().map(|p| p.sticking) {
        Some(Sticking::Never(_)) => {
            "a law without adhesion never sticks; with `start = \"contact\"` neither does one that loses no energy"
        }
        Some(Sticking::From { .. }) => "its adhesion grows with the dent, and slow bodies leave none",
        _ => "its damping or its adhesion is too large for any rebound",
    };
    format!("there is no critical sticking velocity: {told}; {reason}")
}

/// `0.1um..1um`, or one radius.
fn radii(text: &str) -> Result<(f64, f64), Failure> {
    let (first, last) = text.split_once("..").unwrap_or((text, text));
    let one = |part: &str| -> Result<f64, Failure> {
        let wrong = |why: String| Failure::wrong(format!("`--radius {text}`: {why}; write it as 0.1um..1um"));
        let quantity = units::parse(part.trim()).map_err(|error| wrong(error.to_string()))?;
        if quantity.dimension != Dimension::LENGTH {
            return Err(wrong(format!("`{part}` is not a length")));
        }
        if quantity.value > 0.0 {
            Ok(quantity.value)
        } else {
            Err(wrong(format!("`{part}` must be above 0")))
        }
    };
    let (first, last) = (one(first)?, one(last)?);
    if last < first {
        return Err(Failure::wrong(format!(
            "`--radius {text}`: the first radius is larger than the last; write the smaller one first"
        )));
    }
    Ok((first, last))
}
