//! Table I: ours beside the published one.

use super::rank::{METRICS, ranks};
use super::results::{ModelResult, known};
use super::{Model, RESOLUTION, Results, ValidationError};
use demeter::compare::{Comparison, ContactMisfit, Metric};
use std::fmt::Write as _;
use std::path::Path;

/// Writes `table1.csv` and `table1.md` into a folder, and answers with the text of the latter. `made` tells what was run.
pub fn write_table(results: &Results, made: &str, out: &Path) -> Result<String, ValidationError> {
    std::fs::create_dir_all(out).map_err(ValidationError::io(out))?;
    let path = out.join("table1.csv");
    let mut writer = csv::Writer::from_writer(Vec::new());
    let rows = std::iter::once(titles(results)).chain(results.models.iter().map(|m| row(results, m)));
    for row in rows {
        writer
            .write_record(row)
            .map_err(|error| ValidationError::io(&path)(std::io::Error::other(error)))?;
    }
    let bytes = writer
        .into_inner()
        .map_err(|error| ValidationError::io(&path)(std::io::Error::other(error.to_string())))?;
    std::fs::write(&path, bytes).map_err(ValidationError::io(&path))?;
    let text = to_markdown(results, made);
    let path = out.join("table1.md");
    std::fs::write(&path, &text).map_err(ValidationError::io(&path))?;
    Ok(text)
}

fn titles(results: &Results) -> Vec<String> {
    let mut titles: Vec<String> = [
        "model",
        "prefactor",
        "cycles",
        "discarded",
        "plate force at full compression [N]",
        "plate force deviation [N]",
        "Rtop against the measured plate force",
        "errf against the stand-in [N]",
        "errZ against the stand-in",
        "tau against the stand-in [N]",
        "errZ at 4 mN against the stand-in",
        "bhat against the stand-in",
        "energy lost per cycle",
        "Rtop published",
        "errf published [N]",
        "errZ published",
        "tau published [N]",
        "bhat published",
    ]
    .map(String::from)
    .to_vec();
    if results.measured.is_some() {
        let beside = [
            "Rtop against the measured curve",
            "errf against the measured curve [N]",
            "errZ against the measured curve",
            "tau against the measured curve [N]",
        ];
        titles.extend(beside.map(String::from));
    }
    titles
}

/// A number that reads back to the same bits, or an empty cell.
fn told(value: Option<f64>) -> String {
    value.map_or(String::new(), |x| format!("{x:?}"))
}

fn row(results: &Results, result: &ModelResult) -> Vec<String> {
    let ModelResult { model, stand_in, .. } = result;
    let (cycles, discarded) = results.cycles();
    let value = |metric: &Option<Metric<ContactMisfit>>| {
        (metric.as_ref().and_then(|m| m.as_ref().ok())).map(|misfit: &ContactMisfit| misfit.misfit.value)
    };
    let published = model.published;
    let mut row = vec![
        model.name.to_string(),
        told(model.fitted.then_some(results.prefactor)),
        cycles.to_string(),
        discarded.to_string(),
        told(Some(result.top.value)),
        told(result.top.deviation),
        told(Some(result.rtop.value)),
        told(known(&stand_in.errf).map(|m| m.value)),
        told(known(&stand_in.errz).map(|m| m.misfit.value)),
        told(known(&stand_in.errz).map(|m| m.threshold)),
        told(value(&stand_in.errz_at)),
        told(known(&stand_in.bhat).map(|m| m.value)),
        told(Some(result.lost())),
        told(Some(published.rtop)),
        told(Some(published.errf)),
        told(Some(published.errz)),
        told(Some(published.tau)),
        told(Some(published.bhat)),
    ];
    if results.measured.is_some() {
        let measured = result.measured.as_ref();
        row.extend([
            told(measured.and_then(|m| known(&m.rtop)).map(|m| m.value)),
            told(measured.and_then(|m| known(&m.errf)).map(|m| m.value)),
            told(measured.and_then(|m| known(&m.errz)).map(|m| m.misfit.value)),
            told(measured.and_then(|m| known(&m.errz)).map(|m| m.threshold)),
        ]);
    }
    row
}

/// Writing to a String cannot fail.
fn put(text: &mut String, line: std::fmt::Arguments) {
    let _ = writeln!(text, "{line}");
}

fn to_markdown(results: &Results, made: &str) -> String {
    let mut text = String::new();
    let stand_in = results.stand_in.label(results.prefactor);
    let (cycles, discarded) = results.cycles();
    put(&mut text, format_args!("{made}\n"));
    put(
        &mut text,
        format_args!(
            "Means over {cycles} cycles after {discarded} that are left out. In every cell ours first, then what the paper \
             tells (Table I). `Rtop` is against the measured {} N. **`errf`, `errZ`, `tau` and `bhat` of ours are not against \
             the experiment**, whose curves are not published as numbers, but against a stand-in for it: our run of {stand_in}. \
             They tell how far a model is from that one, so that its own are 0 (`tau` is the threshold it is read with, {} mN).\n",
            results.standards.top_force,
            1e3 * RESOLUTION
        ),
    );
    text.push_str(
        "| model | plate force [N] | Rtop | errf [N], stand-in | errZ, stand-in | tau [mN], stand-in | bhat x 100, stand-in \
         | energy lost per cycle |\n|---|---|---|---|---|---|---|---|\n",
    );
    for result in &results.models {
        put(&mut text, format_args!("{}", markdown_row(results, result)));
    }
    orders(results, &mut text);
    measured(results, &mut text);
    for result in &results.models {
        for remark in &result.stand_in.remarks {
            put(&mut text, format_args!("\n{}: {remark}.", result.model.title));
        }
    }
    text
}

fn markdown_row(results: &Results, result: &ModelResult) -> String {
    let published = result.model.published;
    let stand_in = &result.stand_in;
    let cell = |value: Option<f64>, digits: usize, published: f64| match value {
        Some(value) => format!("{value:.digits$} / {published:.digits$}"),
        None => format!("- / {published:.digits$}"),
    };
    let force = match result.top.deviation {
        Some(deviation) => format!("{:.2} ± {deviation:.2}", result.top.value),
        None => format!("{:.2}", result.top.value),
    };
    format!(
        "| {} | {force} | {} | {} | {} | {} | {} | {:.0} % |",
        result.model.label(results.prefactor),
        cell(Some(result.rtop.value), 2, published.rtop),
        cell(known(&stand_in.errf).map(|m| m.value), 2, published.errf),
        cell(known(&stand_in.errz).map(|m| m.misfit.value), 2, published.errz),
        cell(known(&stand_in.errz).map(|m| 1e3 * m.threshold), 2, 1e3 * published.tau),
        cell(known(&stand_in.bhat).map(|m| 1e2 * m.value), 2, 1e2 * published.bhat),
        100.0 * result.lost(),
    )
}

/// The order of the models by every metric, ours and theirs.
fn orders(results: &Results, text: &mut String) {
    text.push_str("\nFrom the best to the worst:\n\n| metric | ours | published | |\n|---|---|---|---|\n");
    let names = |models: &[Model]| models.iter().map(|m| m.name).collect::<Vec<_>>().join(", ");
    for metric in &METRICS {
        let (ours, published) = ranks(results, metric);
        let same = if ours == published {
            "same order"
        } else {
            "**other order**"
        };
        let against = if metric.needs_curve { ", stand-in" } else { "" };
        put(
            text,
            format_args!(
                "| {}{against} | {} | {} | {same} |",
                metric.name,
                names(&ours),
                names(&published)
            ),
        );
    }
}

/// Metrics against a measured curve.
fn measured(results: &Results, text: &mut String) {
    let Some(curve) = &results.measured else {
        return;
    };
    put(
        text,
        format_args!(
            "\nAgainst the measured curve `{}`:\n\n| model | Rtop | errf [N] | errZ | tau [mN] |\n|---|---|---|---|---|",
            curve.name
        ),
    );
    let number = |value: Option<f64>| value.map_or("-".to_string(), |x| format!("{x:.2}"));
    let line = |result: &ModelResult, measured: &Comparison| {
        format!(
            "| {} | {} | {} | {} | {} |",
            result.model.label(results.prefactor),
            number(known(&measured.rtop).map(|m| m.value)),
            number(known(&measured.errf).map(|m| m.value)),
            number(known(&measured.errz).map(|m| m.misfit.value)),
            number(known(&measured.errz).map(|m| 1e3 * m.threshold)),
        )
    };
    for result in &results.models {
        if let Some(beside) = &result.measured {
            put(text, format_args!("{}", line(result, beside)));
        }
    }
}
