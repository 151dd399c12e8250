//! `demeter convert`.

use crate::answer::{Rows, answer, answer_json};
use crate::arguments::ConvertArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::readable::{count, things};
use crate::suggestion::did_you_mean;
use demeter::grain_files::{FileUnits, Format, ReadOptions, WriteOptions};
use demeter::interchange::{Conversion, ConvertError, Converted, Frames, Target, convert as convert_files, target_of};
use demeter::scenario::units;
use demeter_physics::dimension::Dimension;
use serde_json::json;

/// Converts a file of grains or the frames of a run.
pub fn convert(arguments: &ConvertArguments) -> Result<Exit, Failure> {
    let how = conversion(arguments)?;
    let done = convert_files(&arguments.input, &arguments.output, &how)?;
    if arguments.json {
        answer_json(&json!({
            "from": done.from,
            "to": how.target.name(),
            "moments": done.moments,
            "grains": done.grains,
            "files": done.files.iter().map(|f| f.display().to_string()).collect::<Vec<_>>(),
            "notes": done.notes,
        }))?;
    } else {
        answer(&to_text(&done, how.target))?;
    }
    Ok(Exit::Finished)
}

fn to_text(done: &Converted, target: Target) -> String {
    let mut rows = Rows::default();
    let (moments, grains) = (
        things(done.moments as u64, "moment"),
        things(done.grains as u64, "grain"),
    );
    rows.add("read", format!("{}, {moments}, {grains}", done.from));
    let files = match &done.files[..] {
        [only] => only.display().to_string(),
        [first, .., last] => {
            format!(
                "{} files, {} to {}",
                count(done.files.len() as u64),
                first.display(),
                last.display()
            )
        }
        [] => "nothing".to_owned(),
    };
    rows.add("wrote", format!("{files} ({})", target.name()));
    for note in &done.notes {
        rows.add("note", note.as_str());
    }
    rows.lines()
}

fn conversion(arguments: &ConvertArguments) -> Result<Conversion, Failure> {
    let refuse = |flag: &str, error: String| Failure::wrong(format!("{flag}: {error}"));
    let from = arguments.from.as_deref().filter(|name| *name != "demeter");
    let from = from.map(|name| format("--from", name)).transpose()?;
    let target = match arguments.to.as_deref() {
        Some("vtp") => Target::Vtp,
        Some(name) => Target::Grains(format("--to", name)?),
        None => target_of(&arguments.output)?,
    };
    let units = arguments.units.as_deref().map(|text| {
        text.parse::<FileUnits>()
            .map_err(|error| refuse("--units", error.to_string()))
    });
    let quantity = |flag: &str, text: &Option<String>, dimension: Dimension| {
        let read = |text: &String| match units::parse(text) {
            Ok(read) if read.dimension != dimension => {
                Err(refuse(flag, format!("`{text}` has another unit than is needed")))
            }
            Ok(read) if read.value > 0.0 => Ok(read.value),
            Ok(_) => Err(refuse(flag, format!("`{text}` is not above 0"))),
            Err(error) => Err(refuse(flag, error.to_string())),
        };
        text.as_ref().map(read).transpose()
    };
    Ok(Conversion {
        reading: ReadOptions {
            format: from,
            units: units.transpose()?,
            diameter: quantity("--diameter", &arguments.diameter, Dimension::LENGTH)?,
            style: arguments.atom_style.clone(),
            scaled: false,
            types_told: !arguments.types.is_empty(),
            extra_columns: true,
        },
        frames: frames(arguments.frame.as_deref())?,
        target,
        writing: WriteOptions {
            columns: arguments.columns.clone(),
            ..WriteOptions::default()
        },
        density: quantity("--density", &arguments.density, Dimension::DENSITY)?,
        type_names: arguments.types.clone(),
        overwrite: arguments.overwrite,
    })
}

fn format(flag: &str, name: &str) -> Result<Format, Failure> {
    let unknown = |error: demeter::grain_files::UnknownFormat| {
        Failure::wrong(format!("{flag}: {error}.{}", did_you_mean(name, Format::names())))
    };
    name.parse().map_err(unknown)
}

fn frames(told: Option<&str>) -> Result<Frames, Failure> {
    match told {
        None => Ok(Frames::Automatic),
        Some("all") => Ok(Frames::All),
        Some("last") => Ok(Frames::Last),
        Some(text) => text.parse().map(Frames::Number).map_err(|_| {
            Failure::wrong(format!(
                "--frame: `{text}` is neither `all` nor `last` nor a number from 0"
            ))
        }),
    }
}

impl From<ConvertError> for Failure {
    fn from(error: ConvertError) -> Self {
        let message = error.to_string();
        if error.is_io() {
            Self::io(message)
        } else {
            Self::wrong(message)
        }
    }
}
