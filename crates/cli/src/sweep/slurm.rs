//! Writes the script of a job array.

use crate::answer::{answer, answer_json, note};
use crate::arguments::SweepArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::readable::word;
use demeter::checkpoint::{Durability, write_atomically};
use demeter::sweep::{ArrayJob, LOGS, SweepFolder, array_script, option_line};
use serde_json::json;

/// Number of tasks that Slurm allows in an array unless its administrator says otherwise.
const USUAL_LIMIT: usize = 1000;

/// The text of `job.sh`; an error tells what is wrong with the options or the folder, before anything is written.
pub fn script(folder: &SweepFolder, arguments: &SweepArguments) -> Result<String, Failure> {
    let (mut options, mut problems) = (Vec::new(), Vec::new());
    for told in &arguments.sbatch {
        match option_line(told) {
            Ok(line) => options.push(line),
            Err(problem) => problems.push(problem),
        }
    }
    if !problems.is_empty() {
        return Err(Failure::wrong(problems.join("\n")));
    }
    let root = folder.root();
    let absolute = std::path::absolute(root).map_err(|error| failed(&format!("find `{}`", root.display()), error))?;
    let program = std::env::current_exe().map_err(|error| failed("find this program", error))?;
    array_script(&ArrayJob {
        folder: &absolute,
        program: &program,
        runs: folder.plan.runs.len(),
        jobs: arguments.jobs,
        threads: u32::from(arguments.threads),
        options: &options,
        retry: arguments.retry_failed,
    })
    .map_err(Failure::wrong)
}

fn failed(what: &str, error: std::io::Error) -> Failure {
    Failure::io(format!("cannot {what}: {error}"))
}

/// Writes `job.sh`.
pub fn write(folder: &SweepFolder, arguments: &SweepArguments, script: &str) -> Result<Exit, Failure> {
    let path = folder.job_script();
    let (root, shown) = (folder.root(), path.display().to_string());
    let write = || {
        std::fs::create_dir_all(root.join(LOGS))?;
        write_atomically(&path, script.as_bytes(), Durability::Kill)
    };
    write().map_err(|error| failed(&format!("write `{shown}`"), error))?;
    let runs = folder.plan.runs.len();
    if runs > USUAL_LIMIT {
        note(&format!(
            "warning: {runs} tasks are more than most clusters allow in an array (MaxArraySize); ask `scontrol show config`"
        ));
    }
    if arguments.json {
        answer_json(&json!({ "script": shown, "folder": root.display().to_string(), "runs": runs }))?;
    } else {
        answer(&format!(
            "wrote {shown}\nsubmit it with `bash {}`; the results will be gathered into {}\n",
            word(&shown),
            folder.results().display()
        ))?;
    }
    Ok(Exit::Finished)
}
