//! The studies and their runs.

use super::BulkError;
use super::floor::floor;
use crate::folder::absolute;
use crate::runs::{Job, JobError, Tell, carry_out_all};
use demeter::scenario::Scenario;
use std::fs;
use std::path::{Path, PathBuf};

/// What is studied.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// The mass that flows out of a silo per time, by the orifice.
    Beverloo,
    /// What the floor of a column carries, by what is in it.
    Janssen,
    /// The slope of a heap, by friction.
    Repose,
}

/// A study: a scenario that is run at some points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Study {
    /// Name.
    pub name: &'static str,
    /// What is studied.
    pub kind: Kind,
    /// Scenario in `validation/bulk`.
    pub scenario: &'static str,
    /// What the points are.
    pub meaning: &'static str,
    /// The points; one run each.
    pub points: &'static [f64],
}

/// All studies.
pub const STUDIES: [Study; 3] = [
    Study {
        name: "beverloo",
        kind: Kind::Beverloo,
        scenario: "silo.toml",
        meaning: "diameter of the orifice over that of the grains",
        points: &[4.0, 5.0, 6.0, 7.0],
    },
    Study {
        name: "janssen",
        kind: Kind::Janssen,
        scenario: "column.toml",
        meaning: "friction",
        points: &[0.5],
    },
    Study {
        name: "repose",
        kind: Kind::Repose,
        scenario: "heap.toml",
        meaning: "friction",
        points: &[0.05, 0.1, 0.2, 0.4, 0.8],
    },
];

/// The study of a name.
pub fn find_study(name: &str) -> Result<&'static Study, BulkError> {
    let unknown = || BulkError::UnknownStudy { name: name.to_owned() };
    STUDIES.iter().find(|study| study.name == name).ok_or_else(unknown)
}

/// Mean diameter of the grains of all studies [m].
pub(super) const GRAIN: f64 = 5e-3;
/// Radius of the floor of the silo, a little beyond its wall [m].
const FLOOR: f64 = 42e-3;
/// Largest orifice over the grains: the plug of the scenario closes no larger one.
const LARGEST_ORIFICE: f64 = 9.9;

/// What is run.
#[derive(Clone, Debug)]
pub struct Experiment {
    /// Folder of the scenarios.
    pub scenarios: PathBuf,
    /// Points in place of those of the study; none for those.
    pub points: Vec<f64>,
    /// Changes of the scenario, as `demeter run --set`.
    pub set: Vec<String>,
    /// Runs at a time, with one thread each.
    pub jobs: usize,
    /// Whether other runs in the folders may be replaced.
    pub overwrite: bool,
}

impl Experiment {
    /// The points of a study.
    pub fn points_of(&self, study: &Study) -> Vec<f64> {
        match self.points.is_empty() {
            true => study.points.to_vec(),
            false => self.points.clone(),
        }
    }

    /// The scenario of a study at a point; files that it names are written into a folder.
    fn scenario_of(&self, study: &Study, point: f64, folder: &Path) -> Result<Scenario, BulkError> {
        let refused = |allowed| BulkError::Point {
            study: study.name,
            value: point,
            meaning: study.meaning,
            allowed,
        };
        let mut set = match study.kind {
            Kind::Beverloo => {
                if !(point > 0.0 && point < LARGEST_ORIFICE) {
                    return Err(refused("it must be above 0 and below 9.9"));
                }
                fs::create_dir_all(folder).map_err(BulkError::io("make the folder", folder))?;
                let path = folder.join("floor.stl");
                fs::write(&path, floor(0.5 * point * GRAIN, FLOOR)).map_err(BulkError::io("write", &path))?;
                Vec::new()
            }
            Kind::Janssen | Kind::Repose => {
                if !(point >= 0.0 && point.is_finite()) {
                    return Err(refused("it must be 0 or more"));
                }
                vec![format!("contact.tangential.friction={point}")]
            }
        };
        set.extend(self.set.iter().cloned());
        let path = self.scenarios.join(study.scenario);
        let text = fs::read_to_string(&path).map_err(BulkError::io("read", &path))?;
        let (name, base) = (path.display().to_string(), absolute(folder));
        let scenario = Scenario::parse(&text, &name, &base, &set);
        scenario.map_err(|faults| JobError::Scenario(Box::new(faults)).into())
    }
}

/// Carries out the runs of a study; answers with the points and the folders of their runs.
pub fn run_study(
    experiment: &Experiment,
    study: &Study,
    out: &Path,
    tell: Tell<'_>,
) -> Result<Vec<(f64, PathBuf)>, BulkError> {
    let points = experiment.points_of(study);
    let job = |point: &f64| {
        let name = format!("{}-{point}", study.name);
        Ok(Job {
            scenario: experiment.scenario_of(study, *point, &out.join("input").join(&name))?,
            folder: out.join(&name),
            name,
            threads: Some(1),
            overwrite: experiment.overwrite,
        })
    };
    let jobs: Vec<Job> = points.iter().map(job).collect::<Result<_, BulkError>>()?;
    carry_out_all(&jobs, experiment.jobs, tell)?;
    Ok(points.into_iter().zip(jobs.into_iter().map(|job| job.folder)).collect())
}
