//! Tables and plots that a command writes when asked to.

use crate::failure::Failure;
use demeter::checkpoint::{Durability, write_atomically};
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
    write_atomically(path, text.as_bytes(), Durability::Kill)
        .map_err(|error| Failure::io(format!("cannot write `{}`: {error}", path.display())))
}

/// Refuses, before anything is computed, a table or a plot that would replace the input, or another file unless that is meant, or whose name
/// tells another kind of file.
pub fn check_outputs(input: &Path, csv: Option<&Path>, plot: Option<&Path>, overwrite: bool) -> Result<(), Failure> {
    for (flag, path, endings) in [("--csv", csv, &["csv"][..]), ("--plot", plot, &["svg", "png"])] {
        let Some(path) = path else { continue };
        let shown = path.display();
        let ending = path.extension().map(|ending| ending.to_string_lossy().to_lowercase());
        if !ending.is_some_and(|ending| endings.contains(&ending.as_str())) {
            let allowed = endings.join(" or .");
            return Err(Failure::wrong(format!(
                "{flag}: `{shown}` does not end with .{allowed}; name it so, that no other file is replaced by mistake"
            )));
        }
        if let (Ok(read), Ok(written)) = (input.canonicalize(), path.canonicalize())
            && read == written
        {
            return Err(Failure::wrong(format!(
                "{flag}: `{shown}` is input and output; name another file to write"
            )));
        }
        if !overwrite && path.exists() {
            return Err(Failure::wrong(format!(
                "{flag}: `{shown}` is there already; name another file, or give `--overwrite`"
            )));
        }
    }
    Ok(())
}

fn cell(cell: &Cell<'_>) -> String {
    match cell {
        Cell::Number(value) => format!("{value:e}"),
        Cell::Word(word) => (*word).to_string(),
    }
}
