//! `demeter completions` and `demeter man`: what shells and `man` know of the commands.

use crate::answer::answer;
use crate::arguments::{Arguments, CompletionsArguments, ManArguments};
use crate::exit::Exit;
use crate::failure::Failure;
use clap::CommandFactory;

/// Writes the completions of a shell to standard output.
pub fn completions(arguments: &CompletionsArguments) -> Result<Exit, Failure> {
    let mut text = Vec::new();
    clap_complete::generate(arguments.shell, &mut Arguments::command(), "demeter", &mut text);
    answer(&String::from_utf8_lossy(&text))?;
    Ok(Exit::Finished)
}

/// Writes one page of the manual for the program and one for every command.
pub fn man(arguments: &ManArguments) -> Result<Exit, Failure> {
    let folder = &arguments.folder;
    let fails = |error: std::io::Error| Failure::io(format!("cannot write pages into `{}`: {error}", folder.display()));
    std::fs::create_dir_all(folder).map_err(fails)?;
    clap_mangen::generate_to(Arguments::command(), folder).map_err(fails)?;
    let pages = std::fs::read_dir(folder).map_err(fails)?.flatten();
    let ours = pages
        .filter(|page| page.file_name().to_string_lossy().starts_with("demeter"))
        .count();
    answer(&format!(
        "wrote {ours} pages into {}; read one with `man -l {}/demeter-run.1`\n",
        folder.display(),
        folder.display()
    ))?;
    Ok(Exit::Finished)
}
