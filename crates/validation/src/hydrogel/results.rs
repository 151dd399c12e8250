//! Runs of the models, averaged over cycles and compared.

use super::{Model, RESOLUTION, ValidationError};
use demeter::compare::{
    Bins, Comparison, LeftOut, Level, Mean, Metric, Phase, Position, Reading, Strokes, Thresholds, TopRatio, compare,
    measured_points, read_measured, read_run,
};
use std::path::{Path, PathBuf};

/// Columns of the series that figures show beside the force, and their places.
const ALSO: [&str; 7] = [
    "packing contacts",
    "packing coordination",
    "packing packing fraction",
    "packing centre distance",
    "packing mean force",
    "packing scaling",
    "wall work",
];

/// Share of a stroke by which a compression may lie before the first touch and still count: rounding.
const ROUNDING: f64 = 1e-6;

/// What runs are compared with.
#[derive(Clone, Debug, Default)]
pub struct Standards {
    /// Measured force on the plate at full compression [N].
    pub top_force: f64,
    /// Number of cycles that are left out.
    pub discard: usize,
    /// Measured curve, where there is one: a file as `demeter compare` reads it, compressions from the first touch.
    pub measured: Option<PathBuf>,
}

/// A model with its run and how that compares.
#[derive(Clone, Debug)]
pub struct ModelResult {
    /// The model.
    pub model: Model,
    /// Its run, averaged; positions are compressions from the first touch [m].
    pub strokes: Strokes,
    /// Force on the plate at full compression [N].
    pub top: Mean,
    /// That force over the measured one.
    pub rtop: TopRatio,
    /// Beside the stand-in, at its levels at which the plate touches.
    pub stand_in: Comparison,
    /// Beside the measured curve.
    pub measured: Option<Comparison>,
}

/// All models.
#[derive(Clone, Debug)]
pub struct Results {
    /// The models, in the order of Table I.
    pub models: Vec<ModelResult>,
    /// Name of the model that stands in for the measured curves.
    pub stand_in: Model,
    /// The measured curve.
    pub measured: Option<Strokes>,
    /// Prefactor of the fitted model.
    pub prefactor: f64,
    /// What the runs are compared with.
    pub standards: Standards,
}

impl Results {
    /// Reads the runs of the models. The last model, which is the fitted one when it is there, stands in for the experiment.
    pub fn read(
        models: &[Model],
        folders: &[PathBuf],
        prefactor: f64,
        standards: &Standards,
    ) -> Result<Self, ValidationError> {
        let reading = Reading {
            discard: standards.discard,
            also: ALSO.map(String::from).to_vec(),
            distribution: Some("forces".to_string()),
            ..Reading::default()
        };
        let read = |folder: &PathBuf| read_run(folder, &reading, Some(Position::Compression));
        let strokes = folders.iter().map(read).collect::<Result<Vec<_>, _>>()?;
        let (Some(stand_in), Some(last)) = (models.last(), strokes.last()) else {
            return Err(ValidationError::NoModel);
        };
        let reference = touching(last);
        let measured = standards.measured.as_deref().map(read_compressions).transpose()?;
        let results: Result<_, _> = (models.iter().zip(&strokes))
            .map(|(model, strokes)| result(model, strokes, &reference, measured.as_ref(), standards.top_force))
            .collect();
        Ok(Self {
            models: results?,
            stand_in: *stand_in,
            measured,
            prefactor,
            standards: standards.clone(),
        })
    }

    /// Cycles that were averaged and left out.
    pub fn cycles(&self) -> (usize, usize) {
        (self.models.first().and_then(|m| m.strokes.cycles)).unwrap_or((0, self.standards.discard))
    }
}

/// A measured curve, whose positions must be compressions.
fn read_compressions(path: &Path) -> Result<Strokes, ValidationError> {
    let strokes = read_measured(path)?;
    if strokes.position == Position::Compression {
        return Ok(strokes);
    }
    Err(demeter::compare::CompareError::Measured {
        name: path.display().to_string(),
        problem: "its positions must be told as `compression [m]`, counted from the first touch".to_string(),
    }
    .into())
}

/// The levels at which the plate touches: the paper compares 50 of 60 positions.
fn touching(strokes: &Strokes) -> Strokes {
    let mut touching = strokes.clone();
    let highest = strokes.loading.last().map_or(0.0, |level| level.position);
    for levels in [&mut touching.loading, &mut touching.unloading] {
        levels.retain(|level| level.position >= -ROUNDING * highest);
    }
    touching
}

fn result(
    model: &Model,
    strokes: &Strokes,
    reference: &Strokes,
    measured: Option<&Strokes>,
    top_force: f64,
) -> Result<ModelResult, ValidationError> {
    let left_out = |metric: &'static str| {
        move |LeftOut(reason): LeftOut| ValidationError::LeftOut {
            model: model.name,
            metric,
            reason,
        }
    };
    let highest = strokes.loading.last();
    let (at, top) = highest
        .and_then(|level| Some((level.position, level.force?)))
        .ok_or_else(|| left_out("Rtop")(LeftOut("the run tells no force at full compression".to_string())))?;
    let plate = measured_points(
        "force at full compression",
        Position::Compression,
        &[(at, top_force)],
        &[],
    )?;
    let rtop = compare(strokes, &plate, Thresholds::default())
        .rtop
        .map_err(left_out("Rtop"))?;
    let beside_run = Thresholds {
        run: Some(RESOLUTION),
        reference: RESOLUTION,
    };
    let beside_experiment = Thresholds {
        run: Some(RESOLUTION),
        reference: 0.0,
    };
    Ok(ModelResult {
        model: *model,
        strokes: strokes.clone(),
        top,
        rtop,
        stand_in: compare(strokes, reference, beside_run),
        measured: measured.map(|curve| compare(strokes, curve, beside_experiment)),
    })
}

/// A quantity of the series beside the force, averaged over cycles; in the order of [`ALSO`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Also {
    Contacts,
    Coordination,
    PackingFraction,
    CentreDistance,
    MeanForce,
    Scaling,
    WallWork,
}

impl Also {
    /// Its value at a level.
    pub fn at(self, level: &Level) -> f64 {
        level.also.get(self as usize).map_or(f64::NAN, |mean| mean.value)
    }

    /// `<Z> <phi> <b> <f>` [N m].
    pub fn product(level: &Level) -> f64 {
        let factors = [
            Self::Coordination,
            Self::PackingFraction,
            Self::CentreDistance,
            Self::MeanForce,
        ];
        factors.iter().map(|factor| factor.at(level)).product()
    }
}

impl ModelResult {
    /// Bins of the forces.
    pub(super) fn bins(&self) -> Option<&Bins> {
        self.strokes.bins.as_ref()
    }

    /// Work of the plate in a phase, the area under its force [N m].
    pub(super) fn work_of(&self, phase: Phase) -> f64 {
        let points: Vec<(f64, f64)> = (self.strokes.levels(phase).iter())
            .filter_map(|level| Some((level.position, level.force?.value)))
            .collect();
        let area = |w: &[(f64, f64)]| 0.5 * (w[0].1 + w[1].1) * (w[1].0 - w[0].0);
        points.windows(2).map(area).sum()
    }

    /// The same from the energy books of the run, which sum force times velocity over every step [J].
    pub(super) fn booked_work_of(&self, phase: Phase) -> Option<f64> {
        let levels = self.strokes.levels(phase);
        Some((Also::WallWork.at(levels.last()?) - Also::WallWork.at(levels.first()?)).abs())
    }

    /// Share of the work of loading that unloading does not give back.
    pub(super) fn lost(&self) -> f64 {
        1.0 - self.work_of(Phase::Unloading) / self.work_of(Phase::Loading)
    }
}

/// A metric, or nothing.
pub(super) fn known<T>(metric: &Metric<T>) -> Option<&T> {
    metric.as_ref().ok()
}
