//! The summary of a run: `summary.json`.

use super::error::OutputError;
use super::folder::RunFolder;
use crate::measure::{Energies, Measures};
use crate::simulation::ProfileReport;
use crate::walls::WallWork;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// What a run was and how it went. Times of the simulation in [s], energies in [J], SI throughout.
///
/// A value that is not finite is `null` in the file.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Summary {
    /// Version of Demeter.
    pub version: String,
    /// Title of the scenario.
    pub title: String,
    /// The scenario file.
    pub scenario: String,
    /// Seed of the random numbers.
    pub seed: u64,
    /// Whether the run came to the end of its last stage.
    pub finished: bool,
    /// What stopped it, as a sentence.
    pub stopped_by: String,
    /// Grains at the end.
    pub grains: u64,
    /// Contacts between grains at the end.
    pub contacts: u64,
    /// Steps done.
    pub steps: u64,
    /// Simulated time [s].
    pub simulated_time: f64,
    /// Time step [s].
    pub time_step: f64,
    /// Why the time step is what it is.
    pub time_step_reason: String,
    /// Wall-clock time of this process in the step loop [s].
    pub wall_clock_time: f64,
    /// Grains times steps over the wall-clock time [1/s].
    pub particle_steps_per_second: f64,
    /// Number of threads, of each process.
    pub threads: usize,
    /// Number of processes that shared the run.
    pub processes: usize,
    /// The stages that ran, in order.
    pub stages: Vec<StageSummary>,
    /// Energies at the end [J]. A fault leaves a step that is not complete: what was dissipated and worked in it is not counted.
    pub energies: EnergySummary,
    /// Loads on the walls at the end, by name.
    pub walls: BTreeMap<String, WallSummary>,
    /// What the user should know.
    pub warnings: Vec<String>,
    /// What files of rows lack, by their names, since they were not whole when the run went on.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub lost_rows: BTreeMap<String, String>,
    /// Where the time went, if that was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub profile: Option<ProfileReport>,
}

/// One stage that ran.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct StageSummary {
    /// Name.
    pub name: String,
    /// Step at its start.
    pub first_step: u64,
    /// Step at its end.
    pub last_step: u64,
    /// Time at its start [s].
    pub start: f64,
    /// Time at its end [s].
    pub end: f64,
    /// Which of its conditions ended it.
    pub ended_by: String,
    /// Walls at its end.
    pub walls: BTreeMap<String, WallSummary>,
}

/// The ledger at the end.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct EnergySummary {
    /// Energies and the residual at the end.
    #[serde(flatten)]
    pub ledger: Energies,
    /// The largest residual in any row of the series, and at the end.
    pub max_residual: f64,
}

/// A wall at the end of a stage or of the run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct WallSummary {
    /// Force of the grains on it [N].
    pub force: [f64; 3],
    /// Torque of the grains on it about the origin of its pose [N m].
    pub torque: [f64; 3],
    /// Displacement since the start of the run [m].
    pub displacement: [f64; 3],
    /// Contacts with grains.
    pub contacts: u32,
    /// Mean force of the grains on it over the stage or the run [N].
    pub mean_force: [f64; 3],
    /// Mean torque about the origin of its pose [N m].
    pub mean_torque: [f64; 3],
    /// Mean power of the wall on the grains [W].
    pub mean_power: f64,
    /// Work of the wall on the grains in that time [J].
    pub work: f64,
}

/// What a row of measures tells of every wall, and what passed between it and the grains in a time [s] before that.
pub fn wall_summaries(
    row: &Measures,
    wall_names: &[String],
    (works, seconds): (&[WallWork], f64),
) -> BTreeMap<String, WallSummary> {
    let walls = wall_names
        .iter()
        .zip(&row.walls)
        .zip(works)
        .map(|((name, load), done)| {
            let wall = WallSummary {
                force: load.force.to_array(),
                torque: load.torque.to_array(),
                displacement: load.displacement.to_array(),
                contacts: load.contacts,
                mean_force: (done.impulse / seconds).to_array(),
                mean_torque: (done.turning / seconds).to_array(),
                mean_power: done.work / seconds,
                work: done.work,
            };
            (name.clone(), wall)
        });
    walls.collect()
}

impl Summary {
    /// Takes over what is measured at the end, and what passed between walls and grains since the start.
    pub fn set_measures(&mut self, last: &Measures, max_residual: f64, wall_names: &[String], works: &[WallWork]) {
        self.grains = last.grains as u64;
        self.contacts = last.contacts as u64;
        self.steps = last.step;
        self.simulated_time = last.time;
        self.energies = EnergySummary {
            ledger: last.energies,
            max_residual,
        };
        self.walls = wall_summaries(last, wall_names, (works, last.time));
    }

    /// Writes the summary into the folder of the run, whole or not at all.
    pub fn write(&self, folder: &RunFolder) -> Result<(), OutputError> {
        let path = folder.summary();
        let mut text = serde_json::to_string_pretty(self).map_err(|e| OutputError::encode(&path, &e))?;
        text.push('\n');
        folder.write(&path, text.as_bytes())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure::WallLoad;
    use glam::DVec3;

    #[test]
    fn a_summary_reads_back() {
        let place = tempfile::tempdir().unwrap();
        let folder = RunFolder::create(place.path(), false).unwrap();
        let mut summary = Summary {
            version: crate::VERSION.to_owned(),
            title: "A \"box\"".to_owned(),
            seed: u64::MAX,
            time_step: 1.0 / 3.0,
            stages: vec![StageSummary {
                name: "settle".to_owned(),
                ..StageSummary::default()
            }],
            ..Summary::default()
        };
        let last = Measures {
            step: 12,
            time: 2.0,
            walls: vec![WallLoad {
                force: DVec3::new(0.0, 0.0, 6.7),
                ..WallLoad::default()
            }],
            energies: Energies {
                elastic: 0.1,
                residual: 1e-5,
                wall_work: f64::NAN,
                ..Energies::default()
            },
            ..Measures::default()
        };
        let mut done = WallWork::default();
        done.work = 3.0;
        summary.set_measures(&last, 2e-5, &["top".to_owned()], &[done]);
        summary.write(&folder).unwrap();
        let bytes = std::fs::read(folder.summary()).unwrap();
        let read: serde_json::Value = serde_json::from_slice(&bytes).unwrap();
        assert_eq!(read["title"], "A \"box\"");
        assert_eq!(read["seed"], u64::MAX);
        assert_eq!(read["steps"], 12);
        assert_eq!(read["time_step"], 1.0 / 3.0);
        assert_eq!(read["stages"][0]["name"], "settle");
        assert_eq!(read["walls"]["top"]["force"][2], 6.7);
        assert_eq!(read["walls"]["top"]["mean_power"], 1.5);
        assert_eq!(read["energies"]["elastic"], 0.1);
        assert_eq!(read["energies"]["max_residual"], 2e-5);
        assert!(read["energies"]["wall_work"].is_null());
        assert!(read.get("profile").is_none(), "nobody asked for a profile");
    }
}
