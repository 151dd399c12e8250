//! `demeter schema`, and the schema beside a new scenario.

use crate::answer::{answer, answer_json};
use crate::arguments::SchemaArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use demeter::checkpoint::{Durability, write_atomically};
use demeter::scenario::schema::{FileKind, schema as schema_of};
use std::fs;
use std::path::Path;

/// Tells the schema of a kind of file, or writes it.
pub fn schema(arguments: &SchemaArguments) -> Result<Exit, Failure> {
    let Some(of) = FileKind::ALL.into_iter().find(|kind| kind.name() == arguments.kind) else {
        return Err(Failure::wrong(format!("there is no kind of file `{}`", arguments.kind)));
    };
    let Some(file) = &arguments.out else {
        answer_json(&schema_of(of))?;
        return Ok(Exit::Finished);
    };
    write(of, file)?;
    let shown = file.display();
    answer(&format!(
        "wrote {shown}\nnext: write this as the first line of a file, with the way from there to the schema\n  #:schema {shown}\n"
    ))?;
    Ok(Exit::Finished)
}

/// Writes the schema of a kind of file into the folder of a file, in place of an earlier one.
pub fn beside(of: FileKind, file: &Path) -> Result<(), Failure> {
    write(of, &file.with_file_name(of.schema_file()))
}

fn write(of: FileKind, file: &Path) -> Result<(), Failure> {
    let shown = file.display();
    let text = format!("{:#}\n", schema_of(of));
    if let Ok(there) = fs::read_to_string(file) {
        if there == text {
            return Ok(());
        }
        if !there.contains("\"$schema\"") {
            return Err(Failure::wrong(format!(
                "`{shown}` exists and is no schema; it is not replaced: choose another name with --out"
            )));
        }
    }
    write_atomically(file, text.as_bytes(), Durability::Kill).map_err(|error| {
        Failure::io(format!(
            "cannot write `{shown}`: {error}; choose another place with --out"
        ))
    })
}
