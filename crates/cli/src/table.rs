//! Tables and plots that a command writes when asked to.

use crate::failure::Failure;
use demeter::output::Plot;
use std::path::Path;

/// A value of a table.
pub enum Cell<'a> {
    /// A number, written so that it reads back to the same bits.
    Number(f64),
    /// A word.
    Word(&'a str),
}

/// Writes a table as CSV, titles with units first.
pub fn write_csv<'a>(path: &Path, titles: &[&str], rows: impl Iterator<Item = Vec<Cell<'a>>>) -> Result<(), Failure> {
    let mut text = titles.join(",");
    text.push('\n');
    for row in rows {
        let cells: Vec<String> = row.iter().map(cell).collect();
        text.push_str(&cells.join(","));
        text.push('\n');
    }
    std::fs::write(path, text).map_err(|error| Failure::io(format!("cannot write `{}`: {error}", path.display())))
}

fn cell(cell: &Cell<'_>) -> String {
    match cell {
        Cell::Number(value) => format!("{value:e}"),
        Cell::Word(word) => (*word).to_string(),
    }
}

/// Writes a plot as SVG.
pub fn write_plot(path: &Path, plot: &Plot) -> Result<(), Failure> {
    plot.write_svg(path).map_err(|error| Failure::io(error.to_string()))
}
