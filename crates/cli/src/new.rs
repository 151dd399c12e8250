//! `demeter new`.

use crate::answer::{Rows, answer};
use crate::arguments::NewArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::schema;
use crate::suggestion::did_you_mean;
use demeter::scenario::schema::FileKind;
use demeter::scenario::{TEMPLATES, template};
use std::fs::OpenOptions;
use std::io::{ErrorKind, Write};
use std::path::Path;

/// Writes a template, or lists all.
pub fn new(arguments: &NewArguments) -> Result<Exit, Failure> {
    let Some(name) = &arguments.template else {
        answer(&list())?;
        return Ok(Exit::Finished);
    };
    let Some(text) = template(name) else {
        let hint = did_you_mean(name, TEMPLATES.iter().map(|t| t.0));
        let message = format!("there is no template `{name}`.{hint} `demeter new` lists all.");
        return Err(Failure::wrong(message));
    };
    let file = arguments.out.clone().unwrap_or_else(|| format!("{name}.toml").into());
    write(
        &file,
        &format!("#:schema ./{}\n{text}", FileKind::Scenario.schema_file()),
    )?;
    schema::beside(FileKind::Scenario, &file)?;
    let shown = file.display();
    answer(&format!(
        "wrote {shown}, and {} for editors\nnext:\n  demeter check {shown}    what is wrong with it, or how it would run\n  demeter run {shown}      \
         the run\n",
        FileKind::Scenario.schema_file()
    ))?;
    Ok(Exit::Finished)
}

fn list() -> String {
    let mut rows = Rows::default();
    for (name, summary, _) in TEMPLATES {
        rows.add(*name, *summary);
    }
    format!(
        "templates\n{}write one with `demeter new {}`\n",
        rows.lines(),
        TEMPLATES[0].0
    )
}

/// Writes a file that must not exist yet.
fn write(file: &Path, text: &str) -> Result<(), Failure> {
    let shown = file.display();
    let opened = OpenOptions::new().write(true).create_new(true).open(file);
    let written = opened.and_then(|mut opened| opened.write_all(text.as_bytes()));
    written.map_err(|error| match error.kind() {
        ErrorKind::AlreadyExists => Failure::wrong(format!(
            "`{shown}` exists and is not replaced; choose another name with --out"
        )),
        _ => Failure::io(format!(
            "cannot write `{shown}`: {error}; choose another place with --out"
        )),
    })
}
