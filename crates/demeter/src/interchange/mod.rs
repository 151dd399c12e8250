//! Packings from one code to another: files of other codes and runs of this one in, any format of
//! [`crate::grain_files`] or a `.vtp` for ParaView out, one moment at a time.

mod error;
mod run_frames;
mod source;
mod target;

pub use error::ConvertError;
pub use run_frames::table_of_run;
pub use source::{Frames, Source};
pub use target::{Target, target_of};

use crate::grain_files::{Format, GrainTable, ReadOptions, TypeOfGrain, WriteOptions, losses};
use std::path::{Path, PathBuf};
use target::Sink;

/// How a conversion is done.
#[derive(Clone, Debug, PartialEq)]
pub struct Conversion {
    /// What the input does not tell itself.
    pub reading: ReadOptions,
    /// Which moments.
    pub frames: Frames,
    /// The format of the output.
    pub target: Target,
    /// How it is written.
    pub writing: WriteOptions,
    /// Density of all grains where the input tells none [kg/m^3].
    pub density: Option<f64>,
    /// Names of types 1, 2, ...
    pub type_names: Vec<String>,
    /// Whether files that are there are replaced.
    pub overwrite: bool,
}

/// What a conversion did.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Converted {
    /// What the input was.
    pub from: String,
    /// Moments written.
    pub moments: usize,
    /// Grains of that of them which has most.
    pub grains: usize,
    /// Files written.
    pub files: Vec<PathBuf>,
    /// What was taken for granted, and what could not be carried over.
    pub notes: Vec<String>,
}

/// Converts a file, or the frames of a run. `*` in the name of the output stands for the step, or the number of the
/// moment where there is none: each moment then gets a file of its own.
pub fn convert(input: &Path, output: &Path, how: &Conversion) -> Result<Converted, ConvertError> {
    let mut source = Source::open(input, &how.reading)?;
    let mut sink = Sink::new(output, how, input)?;
    let mut converted = Converted {
        from: source.kind(),
        ..Converted::default()
    };
    let mut numbers = source.numbers(how.frames, sink.takes_many())?;
    while let Some(number) = numbers.next(&mut source)? {
        let Some(mut table) = source.table(number)? else { break };
        let without = complete(&mut table, how)?;
        if table.step.is_none() && counts_steps(how.target) {
            table.step = Some(number as u64);
            let note = "step: none is told; the numbers of the moments are written, from 0";
            if number > 0 && !converted.notes.iter().any(|told| told == note) {
                converted.notes.push(note.to_owned());
            }
        }
        for note in without.into_iter().chain(losses_of(&table, how.target)) {
            if !converted.notes.contains(&note) {
                converted.notes.push(note);
            }
        }
        sink.write(number, &table)?;
        converted.moments += 1;
        converted.grains = converted.grains.max(table.len());
    }
    converted.files = sink.finish()?;
    let first = source.notes();
    converted.notes.splice(0..0, first);
    Ok(converted)
}

/// Adds what was told beside the input; tells where names and types do not match.
fn complete(table: &mut GrainTable, how: &Conversion) -> Result<Option<String>, ConvertError> {
    if let Some(density) = how.density {
        if table.densities.is_some() {
            return Err(ConvertError::NoEffect {
                option: "density",
                why: "the input tells the density of every grain",
            });
        }
        table.densities = Some(vec![density; table.len()]);
    }
    if how.type_names.is_empty() {
        return Ok(None);
    }
    let numbers = table.types.iter().flatten().filter_map(|kind| match kind {
        TypeOfGrain::Number(number) => Some(*number as usize),
        TypeOfGrain::Name(_) => None,
    });
    // without types all grains are of the first
    let most = if table.types.is_some() { numbers.max() } else { Some(1) };
    let Some(most) = most else {
        return Err(ConvertError::NoEffect {
            option: "types",
            why: "the input names its materials",
        });
    };
    table.name_types(&how.type_names);
    let names = how.type_names.len();
    Ok((most != names)
        .then(|| format!("`--types` gives names to types 1 to {names}, and the input has types 1 to {most}")))
}

/// Whether moments that are written have a step in any case.
fn counts_steps(target: Target) -> bool {
    matches!(
        target,
        Target::Grains(Format::LammpsDump | Format::LiggghtsDump) | Target::Vtp
    )
}

fn losses_of(table: &GrainTable, target: Target) -> Vec<String> {
    match target {
        Target::Grains(format) => losses(table, format),
        Target::Vtp => Vec::new(),
    }
}

#[cfg(test)]
mod tests;
