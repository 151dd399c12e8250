//! `demeter figure`.

use crate::answer::{Rows, answer, answer_json, note};
use crate::arguments::FigureArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::suggestion::did_you_mean;
use crate::table::{Cell, write_csv};
use demeter::calibrate::figure::{FIGURES, Figure, FigureInfo, draw_figure, find_figure};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};

/// Stands for every figure.
const ALL: &str = "all";

/// Draws figures, or lists them.
pub fn figure(arguments: &FigureArguments) -> Result<Exit, Failure> {
    if arguments.list || arguments.names.is_empty() {
        list(arguments.json)?;
        return Ok(Exit::Finished);
    }
    let wanted = wanted(&arguments.names)?;
    let folder = &arguments.output;
    std::fs::create_dir_all(folder)
        .map_err(|error| Failure::io(format!("cannot make the folder `{}`: {error}", folder.display())))?;
    let mut told = Vec::new();
    for info in wanted {
        let figure = draw_figure(info)?;
        let files = write(&figure, folder)?;
        if arguments.json {
            told.push(to_json(&figure, &files));
        } else {
            answer(&to_text(&figure, &files))?;
        }
    }
    if arguments.json {
        answer_json(&json!({ "figures": told }))?;
    }
    Ok(Exit::Finished)
}

fn list(as_json: bool) -> Result<(), Failure> {
    if as_json {
        let all = FIGURES.iter().map(|f| json!({ "name": f.name, "title": f.title }));
        return answer_json(&json!({ "figures": all.collect::<Vec<Value>>() }));
    }
    let mut rows = Rows::default();
    for figure in FIGURES {
        rows.add(figure.name, figure.title);
    }
    answer(&rows.lines())?;
    note("draw one with `demeter figure NAME`, all with `demeter figure all`");
    Ok(())
}

fn wanted(names: &[String]) -> Result<Vec<&'static FigureInfo>, Failure> {
    if names.iter().any(|name| name == ALL) {
        return Ok(FIGURES.iter().collect());
    }
    let find = |name: &String| {
        find_figure(name).ok_or_else(|| {
            let hint = did_you_mean(name, FIGURES.iter().map(|f| f.name));
            Failure::wrong(format!(
                "there is no figure `{name}`.{hint} `demeter figure --list` tells them all"
            ))
        })
    };
    names.iter().map(find).collect()
}

/// Writes the picture and its numbers.
fn write(figure: &Figure, folder: &Path) -> Result<[PathBuf; 2], Failure> {
    let file = |ending: &str| folder.join(format!("{}.{ending}", figure.info.name));
    let files = [file("svg"), file("csv")];
    let [svg, csv] = &files;
    figure
        .sheet
        .write_svg(svg)
        .map_err(|error| Failure::io(error.to_string()))?;
    let mut titles = vec!["curve"];
    titles.extend(&figure.table.titles);
    let rows = figure.table.rows.iter().map(|(curve, numbers)| {
        let numbers = numbers.iter().map(|x| Cell::Number(*x));
        std::iter::once(Cell::Word(curve)).chain(numbers).collect()
    });
    write_csv(csv, &titles, rows)?;
    Ok(files)
}

fn to_text(figure: &Figure, files: &[PathBuf]) -> String {
    let mut rows = Rows::default();
    for check in &figure.checks {
        rows.add("check", check.to_string());
    }
    let files: Vec<String> = files.iter().map(|f| f.display().to_string()).collect();
    rows.add("written", files.join(", "));
    format!("{}: {}\n{}", figure.info.name, figure.info.title, rows.lines())
}

fn to_json(figure: &Figure, files: &[PathBuf]) -> Value {
    let checks = figure.checks.iter();
    let checks = checks.map(|c| json!({ "what": c.what, "largest_difference": c.largest }));
    json!({
        "name": figure.info.name,
        "title": figure.info.title,
        "files": files.iter().map(|f| f.display().to_string()).collect::<Vec<_>>(),
        "checks": checks.collect::<Vec<Value>>(),
    })
}
