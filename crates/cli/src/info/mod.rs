//! `demeter info`: what is in a file, told by its content.

mod grains;
mod run_folder;
mod scenario;
mod series;
mod surface;
mod sweep;

use crate::answer::{Rows, answer, answer_json};
use crate::arguments::InfoArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use demeter::checkpoint;
use demeter::grain_files::restart_of;
use demeter::sweep::SweepFolder;
use std::fs::File;
use std::io::Read;
use std::path::Path;

/// What can be told of a file.
struct Info {
    /// What it is.
    kind: &'static str,
    /// For people.
    rows: Rows,
    /// For programs, in SI.
    value: serde_json::Value,
}

/// What a file is.
#[derive(Debug, PartialEq)]
enum Kind {
    Run,
    Sweep,
    Checkpoint,
    Surface,
    Scenario,
    Series,
    Grains,
    Unknown,
}

/// Tells what is in a file.
pub fn info(arguments: &InfoArguments) -> Result<Exit, Failure> {
    let path = &arguments.file;
    let info = match kind(path)? {
        Kind::Sweep => sweep::sweep(path),
        Kind::Run => run_folder::run_folder(path),
        Kind::Checkpoint => run_folder::one_checkpoint(path),
        Kind::Surface => surface::surface(path),
        Kind::Scenario => scenario::scenario(path),
        Kind::Series => series::series(path),
        Kind::Grains => grains::grains(path),
        Kind::Unknown => Err(unknown(path)),
    }?;
    let shown = path.display();
    if arguments.json {
        let mut value = info.value;
        value["kind"] = info.kind.into();
        value["path"] = shown.to_string().into();
        answer_json(&value)?;
    } else {
        answer(&format!("{shown}: {}\n{}", info.kind, info.rows.lines()))?;
    }
    Ok(Exit::Finished)
}

/// Tells the kind of a file by its content, and by its name where the content could be anything.
fn kind(path: &Path) -> Result<Kind, Failure> {
    let refused = |error: std::io::Error| match error.kind() {
        std::io::ErrorKind::NotFound => Failure::wrong(format!("there is no file `{}`", path.display())),
        _ => Failure::io(format!("cannot read `{}`: {error}", path.display())),
    };
    let metadata = std::fs::metadata(path).map_err(refused)?;
    if metadata.is_dir() {
        let is_sweep = SweepFolder::is_one(path);
        return Ok(if is_sweep { Kind::Sweep } else { Kind::Run });
    }
    if !metadata.is_file() {
        return Ok(Kind::Unknown);
    }
    let mut start = Vec::new();
    let file = File::open(path).map_err(refused)?;
    file.take(4096).read_to_end(&mut start).map_err(refused)?;
    let extension_of = |path: &Path| path.extension().map(|e| e.to_string_lossy().to_lowercase());
    // what is packed is told by those who read what was packed
    let extension = match extension_of(path) {
        Some(packed) if packed == "gz" => extension_of(&path.with_extension("")).or(Some(packed)),
        other => other,
    };
    Ok(match extension.as_deref() {
        _ if checkpoint::looks_like_one(path) => Kind::Checkpoint,
        _ if series::looks_like_one(&start) => Kind::Series,
        Some("stl" | "obj" | "ply") => Kind::Surface,
        Some("toml") => Kind::Scenario,
        Some("csv" | "txt" | "dat") if surface::looks_like_list(&start) => Kind::Surface,
        Some(
            "csv" | "txt" | "dat" | "data" | "lammps" | "lmp" | "liggghts" | "dump" | "lammpstrj" | "xyz" | "extxyz"
            | "yade" | "spheres" | "gz",
        ) => Kind::Grains,
        _ if start.starts_with(b"solid ") || start.starts_with(b"ply\n") || start.starts_with(b"ply\r") => {
            Kind::Surface
        }
        // whoever reads grains tells what to do with a restart file
        _ if restart_of(&start).is_some() => Kind::Grains,
        _ if start.starts_with(b"ITEM:") || start.starts_with(b"#format ") => Kind::Grains,
        _ => Kind::Unknown,
    })
}

fn unknown(path: &Path) -> Failure {
    Failure::wrong(format!(
        "`{}` is none of the files that Demeter reads: a scenario (.toml), the folder of a run, a checkpoint, a file of \
         grains (.csv, .txt, .data, .dump, .xyz, .yade), a surface (.stl, .obj, .ply), or a series (series.csv of a run). Frames (.vtp, .pvd) open \
         in ParaView, PyVista and OVITO.",
        path.display()
    ))
}
