//! Arguments of `demeter sweep`.

use clap::Args;
use demeter::scenario::MOST_THREADS;
use std::path::PathBuf;

/// Of `demeter sweep`.
#[derive(Debug, Args)]
pub struct SweepArguments {
    /// The scenario
    #[arg(required_unless_present_any = ["resume", "gather"])]
    pub file: Option<PathBuf>,
    /// Vary a value, as `material.glass.restitution=0.5,0.7,0.9`; given again, all values go with all others
    ///
    /// The key is told as for --set. Values are put between commas; commas in quotes and brackets separate none. A range is
    /// `0.1..0.9:5`, five values with equal differences, or `0.001..1:4:log`, four with equal ratios; `1..3 mm:5` has a unit.
    #[arg(long, value_name = "KEY=VALUES")]
    pub vary: Vec<String>,
    /// Vary a value together with those of the other --zip: first with first, second with second
    #[arg(long, value_name = "KEY=VALUES")]
    pub zip: Vec<String>,
    /// Vary by a design of experiments: a CSV file with a column for every key and a row for every run
    ///
    /// Units stand in the cells, or once in the title, as `grains[0].diameter [mm]`.
    #[arg(long, value_name = "FILE.csv")]
    pub table: Option<PathBuf>,
    /// Run every combination with N seeds, counted from that of the scenario; means and deviations go to `averages.csv`
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=10_000))]
    pub repeat: Option<u32>,
    /// Change a value of all runs, as `grains[0].count=200`; may be given many times
    #[arg(long, value_name = "KEY=VALUE")]
    pub set: Vec<String>,
    /// Folder of the sweep
    ///
    /// Without it `runs/NAME-sweep` in the present folder. If the same sweep is there already, it goes on: finished runs are
    /// not repeated, interrupted ones go on from their checkpoints.
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Add runs to the sweep that is in the folder: tell all values, those that are there and new ones
    #[arg(long, conflicts_with_all = ["resume", "gather"])]
    pub extend: bool,
    /// Go on with the sweep in a folder
    #[arg(long, value_name = "DIR", conflicts_with_all = ["file", "vary", "zip", "table", "repeat", "set", "out", "gather"])]
    pub resume: Option<PathBuf>,
    /// Carry out one run of the sweep, told by its number from 0; others may do the same with other runs at the same time
    #[arg(long, value_name = "INDEX", requires = "resume", conflicts_with_all = ["jobs", "dry_run"])]
    pub only: Option<usize>,
    /// Only gather the results that the runs in a folder have left until now
    #[arg(long, value_name = "DIR", conflicts_with_all = [
        "file", "vary", "zip", "table", "repeat", "set", "out", "slurm", "jobs", "threads", "retry_failed", "dry_run",
    ])]
    pub gather: Option<PathBuf>,
    /// Try runs that failed earlier again
    #[arg(long)]
    pub retry_failed: bool,
    /// Number of runs at a time; as many as there are cores for, as far as memory allows, when absent
    #[arg(long, value_name = "J", value_parser = clap::value_parser!(u32).range(1..=4096))]
    pub jobs: Option<u32>,
    /// Number of threads of every run. The results are the same for any number
    #[arg(long, value_name = "T", value_parser = clap::value_parser!(u16).range(1..=i64::from(MOST_THREADS)), default_value_t = 1)]
    pub threads: u16,
    /// List the runs with what they will need; writes nothing
    #[arg(long)]
    pub dry_run: bool,
    /// Result for the table, as `mean:coordination@settle`; may be given many times
    ///
    /// WHAT:COLUMN@STAGE, where WHAT is first, last, mean, deviation (both over time), min or max of a column of the series, or rate, what it
    /// gains per time, in the rows of a stage or between two times (`@0.1 s..0.5 s`). WHAT: and @STAGE may be left out: the last row counts. The last row of all
    /// columns is in `results.csv` in any case.
    #[arg(long, value_name = "RESULT")]
    pub result: Vec<String>,
    /// Draw a result, told as for --result, against a varied key, as SVG into `plots`; may be given many times
    #[arg(long, value_name = "RESULT")]
    pub plot: Vec<String>,
    /// Key of the horizontal axis of plots; the first one that has numbers when absent
    #[arg(long, value_name = "KEY")]
    pub against: Option<String>,
    /// Write `job.sh`, a job array for Slurm, in place of running
    #[arg(long, conflicts_with = "dry_run")]
    pub slurm: bool,
    /// Option of sbatch, passed on as it is, as `time=2:00:00`, `partition=short`, `mem=2G`; may be given many times
    #[arg(long, value_name = "OPTION", requires = "slurm", allow_hyphen_values = true)]
    pub sbatch: Vec<String>,
    /// Write one JSON object to standard output at the end; everything else goes to standard error
    #[arg(long)]
    pub json: bool,
    /// Tell progress as lines of JSON, and end with a checkpoint when standard input ends: `demeter sweep` starts its runs so.
    #[arg(long, hide = true, requires = "only")]
    pub as_part: bool,
}
