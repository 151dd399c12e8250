//! What is written: one file of one or many moments, or one file for each.

use super::Conversion;
use super::error::ConvertError;
use crate::checkpoint::{Durability, part_path, write_atomically_with};
use crate::grain_files::{Cell, Format, GrainTable, GrainWriter, WriteOptions};
use crate::output::vtk_file::NewPolyData;
use crate::output::vtp::{Array, Cells, PolyData, Values};
use crate::output::{FrameBox, box_fields};
use flate2::Compression;
use flate2::write::GzEncoder;
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

/// A format of the output.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Target {
    /// One of the formats of files of grains.
    Grains(Format),
    /// Points with arrays for ParaView and PyVista.
    Vtp,
}

impl Target {
    /// Its name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Grains(format) => format.name(),
            Self::Vtp => "vtp",
        }
    }
}

/// The format that the name of a file tells.
pub fn target_of(path: &Path) -> Result<Target, ConvertError> {
    let is_vtp = path
        .extension()
        .is_some_and(|ending| ending.eq_ignore_ascii_case("vtp"));
    if is_vtp {
        return Ok(Target::Vtp);
    }
    let format = Format::of_path(path).map(Target::Grains);
    format.ok_or_else(|| ConvertError::NoFormat { path: path.to_owned() })
}

/// Text on its way into a file, perhaps compressed.
enum Stream {
    Plain(BufWriter<File>),
    Compressed(GzEncoder<BufWriter<File>>),
}

impl Write for Stream {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self {
            Self::Plain(out) => out.write(bytes),
            Self::Compressed(out) => out.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match self {
            Self::Plain(out) => out.flush(),
            Self::Compressed(out) => out.flush(),
        }
    }
}

/// Whether the name of a file asks for tabs.
fn ends_with_tsv(path: &Path) -> bool {
    let name = path.to_string_lossy().to_lowercase();
    name.strip_suffix(".gz").unwrap_or(&name).ends_with(".tsv")
}

/// A file that gets its name when it is whole.
struct Pending {
    path: PathBuf,
    writer: GrainWriter<Stream>,
}

/// Where moments go.
pub(super) struct Sink<'c> {
    output: PathBuf,
    how: &'c Conversion,
    input: PathBuf,
    open: Option<Pending>,
    files: Vec<PathBuf>,
}

impl<'c> Sink<'c> {
    /// Checks the names; nothing is written yet.
    pub fn new(output: &Path, how: &'c Conversion, input: &Path) -> Result<Self, ConvertError> {
        let sink = Self {
            output: output.to_owned(),
            how,
            input: input.to_owned(),
            open: None,
            files: Vec::new(),
        };
        if let Target::Grains(format) = how.target {
            // what the format refuses is told before anything is read
            let fails = |problem| ConvertError::Write {
                path: output.to_owned(),
                problem,
            };
            GrainWriter::new(io::sink(), format, how.writing.clone()).map_err(fails)?;
        } else if how.writing.columns.is_some() {
            let example = "csv".to_owned();
            return Err(ConvertError::OneMoment {
                format: "vtp with chosen columns".to_owned(),
                example,
            });
        }
        if !sink.has_star() {
            sink.check(output)?;
        }
        Ok(sink)
    }

    /// Whether the output takes several moments.
    pub fn takes_many(&self) -> bool {
        self.has_star() || matches!(self.how.target, Target::Grains(format) if format.holds_many())
    }

    fn has_star(&self) -> bool {
        self.output
            .file_name()
            .is_some_and(|name| name.to_string_lossy().contains('*'))
    }

    /// Refuses a file that is there, or is read.
    fn check(&self, path: &Path) -> Result<(), ConvertError> {
        if let (Ok(a), Ok(b)) = (path.canonicalize(), self.input.canonicalize())
            && a == b
        {
            return Err(ConvertError::Same { path: path.to_owned() });
        }
        match path.exists() && !self.how.overwrite {
            true => Err(ConvertError::Exists { path: path.to_owned() }),
            false => Ok(()),
        }
    }

    /// Writes a moment.
    pub fn write(&mut self, number: usize, table: &GrainTable) -> Result<(), ConvertError> {
        let path = self.path(number, table);
        let begun = !self.files.is_empty() || self.open.is_some();
        if begun && !self.takes_many() {
            return Err(self.one_moment());
        }
        let Target::Grains(format) = self.how.target else {
            self.check(&path)?;
            let data = poly_data(table);
            let write = |file: &mut File| NewPolyData::from(&data).write(file);
            write_atomically_with(&path, Durability::Kill, write).map_err(ConvertError::io(&path))?;
            self.files.push(path);
            return Ok(());
        };
        if self.open.is_none() {
            self.check(&path)?;
            let options = WriteOptions {
                tabs: ends_with_tsv(&path),
                ..self.how.writing.clone()
            };
            let writer = GrainWriter::new(stream(&path)?, format, options);
            let writer = writer.map_err(|problem| ConvertError::Write {
                path: path.clone(),
                problem,
            })?;
            self.open = Some(Pending { path, writer });
        }
        if let Some(pending) = &mut self.open {
            let written = pending.writer.write(table);
            if let Err(problem) = written {
                let path = pending.path.clone();
                return Err(ConvertError::Write { path, problem });
            }
        }
        if self.has_star() {
            self.close()?;
        }
        Ok(())
    }

    /// The file of a moment.
    fn path(&self, number: usize, table: &GrainTable) -> PathBuf {
        let name = self.output.file_name().map(|name| name.to_string_lossy().into_owned());
        match name {
            Some(name) if name.contains('*') => {
                let step = table.step.map_or_else(|| number.to_string(), |step| step.to_string());
                self.output.with_file_name(name.replace('*', &step))
            }
            _ => self.output.clone(),
        }
    }

    fn one_moment(&self) -> ConvertError {
        let stem = self
            .output
            .file_stem()
            .unwrap_or_default()
            .to_string_lossy()
            .into_owned();
        let ending = self
            .output
            .extension()
            .map_or_else(String::new, |e| format!(".{}", e.to_string_lossy()));
        ConvertError::OneMoment {
            format: self.how.target.name().to_owned(),
            example: format!("{stem}-*{ending}"),
        }
    }

    /// Gives the open file its name.
    fn close(&mut self) -> Result<(), ConvertError> {
        let Some(Pending { path, writer }) = self.open.take() else {
            return Ok(());
        };
        let part = part_path(&path);
        let finished = writer.finish().and_then(|stream| match stream {
            Stream::Plain(mut out) => out.flush(),
            Stream::Compressed(out) => out.finish()?.flush(),
        });
        let named = finished.and_then(|()| fs::rename(&part, &path));
        if named.is_err() {
            let _ = fs::remove_file(&part);
        }
        named.map_err(ConvertError::io(&path))?;
        self.files.push(path);
        Ok(())
    }

    /// The files, whole.
    pub fn finish(mut self) -> Result<Vec<PathBuf>, ConvertError> {
        self.close()?;
        Ok(std::mem::take(&mut self.files))
    }
}

impl Drop for Sink<'_> {
    /// A file that is not whole goes.
    fn drop(&mut self) {
        if let Some(pending) = self.open.take() {
            let part = part_path(&pending.path);
            drop(pending);
            let _ = fs::remove_file(part);
        }
    }
}

fn stream(path: &Path) -> Result<Stream, ConvertError> {
    let file = File::create(part_path(path)).map_err(ConvertError::io(path))?;
    let out = BufWriter::with_capacity(1 << 18, file);
    let compressed = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("gz"));
    Ok(match compressed {
        true => Stream::Compressed(GzEncoder::new(out, Compression::default())),
        false => Stream::Plain(out),
    })
}

fn frame_box(cell: &Cell) -> FrameBox {
    FrameBox {
        corner: cell.lower,
        edges: cell.edges(),
        periodic: cell.periodic,
    }
}

/// The table as points, with the arrays of the frames of a run as far as it tells them.
fn poly_data(table: &GrainTable) -> PolyData {
    let count = table.len();
    let materials = table
        .type_numbers()
        .iter()
        .map(|kind| kind.saturating_sub(1) as i32)
        .collect();
    let mut point_data = vec![
        Array::new("id", 1, Values::UInt32((0..count).map(|k| table.id(k)).collect())),
        Array::new("material", 1, Values::Int32(materials)),
        Array::scalars("radius", table.diameters.iter().map(|d| 0.5 * d)),
        Array::scalars("diameter", table.diameters.iter().copied()),
    ];
    if table.densities.is_some() {
        point_data.push(Array::scalars("mass", (0..count).filter_map(|k| table.mass(k))));
    }
    for (name, values) in [
        ("velocity", &table.velocities),
        ("angular_velocity", &table.angular_velocities),
        ("force", &table.forces),
        ("torque", &table.torques),
    ] {
        if let Some(values) = values {
            point_data.push(Array::vectors(name, values));
        }
    }
    for extra in &table.extras {
        point_data.push(Array::new(extra.name.clone(), 1, Values::Float64(extra.values.clone())));
    }
    PolyData {
        step: table.step.unwrap_or(0),
        time: table.time.unwrap_or(0.0),
        texts: vec![("material_names".into(), table.type_names.clone())],
        fields: table
            .cell
            .iter()
            .flat_map(|cell| box_fields(&frame_box(cell)))
            .collect(),
        points: table.positions.clone(),
        cells: Cells::Vertices,
        point_data,
        cell_data: Vec::new(),
    }
}
