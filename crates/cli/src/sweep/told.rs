//! What a sweep leaves and tells: tables, plots, and the runs that failed.

use super::needs::values;
use crate::answer::{Rows, aligned, answer, answer_json, note};
use crate::arguments::SweepArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::plot::default_name;
use crate::readable::{number, word};
use demeter::scenario::RunError;
use demeter::sweep::{
    Results, ResultsCell, Status, SweepError, SweepFolder, averages, gather, metrics, plot, title_of,
};
use serde_json::{Value, json};
use std::path::PathBuf;

/// Most rows of the table in the terminal.
const MOST_ROWS: usize = 60;
/// Most failures that are told.
const MOST_FAILURES: usize = 20;
/// What is shown when nothing is asked for.
const USUAL: [&str; 4] = [
    "coordination",
    "packing fraction",
    "max energy residual",
    "computing time",
];

/// What was written.
struct Written {
    results: Results,
    averages: Option<Results>,
    plots: Vec<PathBuf>,
}

/// Gathers, writes and tells the results; the exit code is told where runs were carried out, failed or are damaged, and given back.
pub fn results(
    folder: &SweepFolder,
    arguments: &SweepArguments,
    statuses: &[Status],
    exit: Option<Exit>,
) -> Result<Exit, Failure> {
    let written = write(folder, statuses)?;
    let damaged = !written.results.problems.is_empty();
    let failed = statuses.iter().any(|status| status.failure().is_some());
    let exit = match exit {
        None | Some(Exit::Finished) if damaged || failed => Some(Exit::Fault),
        exit => exit,
    };
    for problem in written.results.problems.iter().chain(&written.results.missing) {
        note(&format!("warning: {problem}"));
    }
    if arguments.json {
        answer_json(&to_json(folder, statuses, &written, exit))?;
        if damaged {
            note(&help_of_damaged(folder, &written));
        }
    } else {
        answer(&to_text(folder, statuses, &written))?;
    }
    Ok(exit.unwrap_or(Exit::Finished))
}

/// How many runs are damaged, and what to do with them.
fn help_of_damaged(folder: &SweepFolder, written: &Written) -> String {
    format!(
        "{} damaged: remove the folders of these, and `demeter sweep --resume {}` runs them anew",
        written.results.problems.len(),
        word(folder.root().display())
    )
}

fn write(folder: &SweepFolder, statuses: &[Status]) -> Result<Written, Failure> {
    let results = gather(folder, statuses)?;
    results.write(&folder.results())?;
    let averages = averages(folder, &results);
    if let Some(averages) = &averages {
        averages.write(&folder.averages())?;
    }
    let mut plots = Vec::new();
    if !folder.wishes.plots.is_empty() && statuses.iter().any(Status::is_finished) {
        let place = folder.plots();
        std::fs::create_dir_all(&place)
            .map_err(|error| Failure::io(format!("cannot make the folder `{}`: {error}", place.display())))?;
        let series = folder.plan.scenario(0).map_err(RunError::from)?.series_titles();
        for metric in metrics(&folder.wishes.plots)? {
            let title = title_of(&metric, &series).unwrap_or_else(|| metric.column.clone());
            let drawn = plot(folder, &results, &title)?;
            let path = place.join(default_name(&drawn.x_label, std::slice::from_ref(&drawn.y_label)));
            drawn.write_svg(&path).map_err(SweepError::from)?;
            plots.push(path);
        }
    }
    Ok(Written {
        results,
        averages,
        plots,
    })
}

fn to_text(folder: &SweepFolder, statuses: &[Status], written: &Written) -> String {
    let all = statuses.len();
    let damaged = written.results.problems.len();
    let finished = statuses.iter().filter(|status| status.is_finished()).count() - damaged;
    let mut text = format!("{finished} of {all} runs finished\n");
    text += &match &written.averages {
        Some(averages) => average_table(averages),
        None => run_table(&written.results),
    };
    text += &failures(folder, statuses);
    if damaged > 0 {
        text += &format!("{}\n", help_of_damaged(folder, written));
    }
    let mut rows = Rows::default();
    rows.add("results", folder.results().display().to_string());
    if written.averages.is_some() {
        rows.add("means", folder.averages().display().to_string());
    }
    for path in &written.plots {
        rows.add("plot", path.display().to_string());
    }
    text += &rows.lines();
    if statuses
        .iter()
        .any(|status| matches!(status, Status::Waiting | Status::Interrupted))
    {
        text += &format!(
            "go on with `demeter sweep --resume {}`\n",
            word(folder.root().display())
        );
    }
    text
}

/// The runs that failed, with what they told.
fn failures(folder: &SweepFolder, statuses: &[Status]) -> String {
    let failed: Vec<(usize, String)> = statuses
        .iter()
        .enumerate()
        .filter_map(|(index, status)| {
            let outcome = status.failure()?;
            Some((index, format!("{}: {}", outcome.end.name(), outcome.message)))
        })
        .collect();
    if failed.is_empty() {
        return String::new();
    }
    let mut text = "failed:\n".to_string();
    for (index, why) in failed.iter().take(MOST_FAILURES) {
        text += &format!("  {}: {why}\n", folder.plan.runs[*index].name);
    }
    if failed.len() > MOST_FAILURES {
        text += &format!("  and {} more, in results.csv\n", failed.len() - MOST_FAILURES);
    }
    text += &format!(
        "try them again with `demeter sweep --resume {} --retry-failed`\n",
        word(folder.root().display())
    );
    text
}

/// The columns that are shown: what is varied, then what is asked for.
fn shown(results: &Results) -> Vec<usize> {
    let usual = || USUAL.iter().filter_map(|name| results.find(name)).collect();
    if results.asked.is_empty() {
        usual()
    } else {
        results.asked.clone()
    }
}

fn short(cell: &ResultsCell) -> String {
    match cell {
        ResultsCell::Empty => "-".to_string(),
        ResultsCell::Number(value) => number(*value),
        ResultsCell::Word(word) => word.clone(),
    }
}

fn run_table(results: &Results) -> String {
    let end = results.varied.end;
    let columns: Vec<usize> = results.varied.clone().chain([end]).chain(shown(results)).collect();
    let row = |cells: &Vec<ResultsCell>| columns.iter().map(|&k| short(&cells[k])).collect();
    let titles = columns.iter().map(|&k| results.titles[k].clone()).collect();
    table(titles, results.rows.iter().map(row).collect())
}

/// Means with their deviations, which stand in the column behind.
fn average_table(averages: &Results) -> String {
    let count = averages.varied.end;
    let first: Vec<usize> = averages.varied.clone().chain([count]).collect();
    let told = shown(averages);
    let row = |cells: &Vec<ResultsCell>| {
        let with_deviation = |&k: &usize| match &cells[k + 1] {
            ResultsCell::Number(deviation) => format!("{} +- {}", short(&cells[k]), number(*deviation)),
            _ => short(&cells[k]),
        };
        let values = first.iter().map(|&k| short(&cells[k]));
        values.chain(told.iter().map(with_deviation)).collect()
    };
    let titles = first.iter().chain(&told).map(|&k| averages.titles[k].clone()).collect();
    table(titles, averages.rows.iter().map(row).collect())
}

fn table(titles: Vec<String>, rows: Vec<Vec<String>>) -> String {
    let more = rows.len().saturating_sub(MOST_ROWS);
    let shown: Vec<Vec<String>> = std::iter::once(titles)
        .chain(rows.into_iter().take(MOST_ROWS))
        .collect();
    let mut text = aligned(&shown);
    if more > 0 {
        text += &format!("  and {more} more\n");
    }
    text
}

fn to_json(folder: &SweepFolder, statuses: &[Status], written: &Written, exit: Option<Exit>) -> Value {
    let count = |is: &dyn Fn(&Status) -> bool| statuses.iter().filter(|status| is(status)).count();
    let results = &written.results;
    let one = |(index, status): (usize, &Status)| {
        let row = &results.rows[index];
        let (end, message) = (results.varied.end, results.varied.end + 1);
        // of a run that is damaged the table tells more than how it ended
        let is_whole = status.is_finished() && row[end].text() == status.name();
        let message = (matches!(status, Status::Ended(_)) && !is_whole).then(|| row[message].text());
        let cells = results.titles.iter().zip(row).skip(end + 2);
        let told: serde_json::Map<String, Value> = cells
            .filter_map(|(title, cell)| Some((title.clone(), json!(cell.number()?))))
            .collect();
        json!({
            "index": index, "name": folder.plan.runs[index].name, "folder": folder.run_folder(index).display().to_string(),
            "values": values(folder, index), "end": row[end].text(), "message": message, "results": told,
        })
    };
    let runs: Vec<Value> = statuses.iter().enumerate().map(one).collect();
    let plots: Vec<String> = written.plots.iter().map(|path| path.display().to_string()).collect();
    json!({
        "folder": folder.root().display().to_string(),
        "finished": count(&Status::is_finished) - results.problems.len(),
        "damaged": results.problems.len(),
        "failed": count(&|status| status.failure().is_some()),
        "left": count(&|status| !matches!(status, Status::Ended(_))),
        "runs": runs,
        "results": folder.results().display().to_string(),
        "averages": written.averages.as_ref().map(|_| folder.averages().display().to_string()),
        "plots": plots,
        "problems": results.problems,
        "missing": results.missing,
        "exit_code": exit.map(|exit| exit as u8),
    })
}
