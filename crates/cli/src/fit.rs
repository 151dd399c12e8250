//! `demeter fit`.

use crate::answer::{Rows, answer, answer_json};
use crate::arguments::FitArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::fit_packing::fit_packing;
use crate::readable::number;
use demeter::calibrate::fit::{Combination, FitReport, FittedParameter, Residual, fit as find};
use demeter::scenario::{FitFile, FitTask};
use demeter_physics::collision::Start;
use demeter_physics::dimension::Dimension;

/// Finds the parameters of a law from observations, or a number of a scenario from a measured curve.
pub fn fit(arguments: &FitArguments) -> Result<Exit, Failure> {
    match FitTask::read(&arguments.file, &arguments.set)? {
        FitTask::Packing(file) => fit_packing(&file, arguments),
        FitTask::Collisions(file) => fit_law(&file, arguments),
    }
}

fn fit_law(file: &FitFile, arguments: &FitArguments) -> Result<Exit, Failure> {
    if arguments.out.is_some() || arguments.output.threads.is_some() {
        let message = "--out and --threads belong to a file with a table [packing], whose trials are runs; this one tells \
                       collisions, and needs none";
        return Err(Failure::wrong(message));
    }
    let report = find(file)?;
    if arguments.output.json {
        answer_json(&report.to_json())?;
    } else {
        answer(&to_text(&report))?;
    }
    Ok(Exit::Finished)
}

/// A value with its SI unit.
fn with_unit(value: f64, dimension: Dimension) -> String {
    format!("{} {}", number(value), dimension.unit()).trim_end().to_string()
}

fn standing(parameter: &FittedParameter) -> String {
    let bound = if parameter.at_bound { "; at its bound" } else { "" };
    match parameter.error {
        Some(error) if !parameter.identified => format!("error {:.0} %, NOT identified{bound}", 100.0 * error),
        Some(error) => format!("error {:.2} %{bound}", 100.0 * error),
        None => format!("NOT identifiable, one of many{bound}"),
    }
}

/// `stiffness restitution^0.61`.
fn product(combination: &Combination) -> String {
    let factor = |(name, power): &(String, f64)| match *power {
        1.0 => name.clone(),
        power => format!("{name}^{}", number(power)),
    };
    let factors: Vec<String> = combination.powers.iter().map(factor).collect();
    factors.join(" ")
}

fn residual(residual: &Residual) -> String {
    let dimension = residual.observable.dimension();
    format!(
        "measured {}, law {}, {:+.2} errors",
        with_unit(residual.measured, dimension),
        with_unit(residual.found, dimension),
        residual.deviation
    )
}

fn to_text(report: &FitReport) -> String {
    let mut text = format!("{}\n", report.method);
    let mut rows = Rows::default();
    for p in &report.parameters {
        rows.add(
            &p.name,
            format!("{}   {}", with_unit(p.value, p.dimension), standing(p)),
        );
    }
    text += &rows.lines();
    text += "observations\n";
    let mut rows = Rows::default();
    for r in &report.residuals {
        rows.add(format!("[{}] {}", r.observation, r.observable.name()), residual(r));
    }
    text += &rows.lines();
    if !report.fits() {
        text += &format!(
            "the law does not show these observations within their errors (chi-square {} with {} degrees of freedom, largest deviation {} \
             errors): another law, a `restitution` that depends on the speed (a table), or larger errors\n",
            number(report.chi_square()),
            report.degrees_of_freedom(),
            number(report.worst())
        );
    }
    if let Some(other) = &report.ambiguous {
        let values: Vec<String> = (report.parameters.iter().zip(other))
            .map(|(p, value)| format!("{} = {}", p.name, with_unit(*value, p.dimension)))
            .collect();
        text += &format!("other parameters fit as well: {}\n", values.join(", "));
    }
    text += &identifiability(report);
    let values: Vec<String> = report.singular_values.iter().map(|s| format!("{s:.2e}")).collect();
    text += &format!(
        "singular values of d ln(observation)/d ln(parameter): {}\n",
        values.join(", ")
    );
    text += "for a scenario\n";
    for line in &report.material {
        text += &format!("  {line}\n");
    }
    text += &format!("  [contact]\n  {}\n", report.contact);
    if let Some(start) = report.start {
        text += &format!(
            "velocities were taken to be those {}; for a file of two bodies\n  [impact]\n  start = \"{}\"\n",
            match start {
                Start::Contact => "at first touch",
                Start::Far => "where the attraction is first felt",
            },
            start.name()
        );
    }
    text
}

fn identifiability(report: &FitReport) -> String {
    let open: Vec<&str> = report.not_identified().collect();
    if open.is_empty() {
        return String::new();
    }
    if !report.fits() {
        return format!(
            "no values that were found fit, so that nothing tells whether these observations fix {}: look at the observations, or tell bounds\n",
            open.join(", ")
        );
    }
    let mut text = format!("these observations do not fix {}\n", open.join(", "));
    if report.parameters.iter().all(|p| p.error.is_some()) {
        return text
            + "  they change with it by less than their errors: measure more exactly, or at other velocities\n";
    }
    let products = report.fixed.iter().filter(|c| c.powers.len() > 1);
    for combination in products {
        text += &format!("  they fix the product {} (near these values)\n", product(combination));
    }
    if report.advice.is_empty() {
        text += "  no head-on impact of these bodies tells more: move one of them from `unknown` to `known`\n";
    }
    for advice in &report.advice {
        let at = advice
            .velocity
            .map_or(String::new(), |v| format!(" at {} m/s", number(v)));
        text += &format!("  measure {}{at}\n", advice.observable.name());
    }
    text
}
