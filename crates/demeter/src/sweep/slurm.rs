//! A job array for Slurm: every run is a task that goes on with its part of the sweep.

use std::path::Path;

/// Folder for what the tasks say, below that of the sweep.
pub const LOGS: &str = "slurm";

/// What a script for Slurm needs to know.
#[derive(Clone, Debug)]
pub struct ArrayJob<'a> {
    /// Folder of the sweep, absolute.
    pub folder: &'a Path,
    /// The program, absolute.
    pub program: &'a Path,
    /// Number of runs.
    pub runs: usize,
    /// Most tasks at a time.
    pub jobs: Option<u32>,
    /// Threads of a run.
    pub threads: u32,
    /// Lines for `sbatch`, as [`option_line`] makes them.
    pub options: &'a [String],
    /// Whether runs that failed are tried again.
    pub retry: bool,
}

/// A word of a command, in the quotes of a shell.
pub fn quoted(text: &str) -> String {
    format!("'{}'", text.replace('\'', "'\\''"))
}

/// An option of `sbatch` as it stands behind `#SBATCH`: `time=2:00:00` and `--time=2:00:00` both give the latter. The error tells
/// what is wrong.
pub fn option_line(told: &str) -> Result<String, String> {
    let told = told.trim();
    let name: &str = told
        .trim_start_matches('-')
        .split(['=', ' '])
        .next()
        .unwrap_or_default();
    let is_name = |name: &str| {
        name.starts_with(|c: char| c.is_ascii_alphabetic())
            && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '-')
    };
    if !is_name(name) || told.chars().any(char::is_control) {
        return Err(format!(
            "--sbatch `{told}` is no option of sbatch; write `--sbatch time=2:00:00` or `--sbatch partition=short`"
        ));
    }
    if ["array", "a"].contains(&name) {
        return Err(format!(
            "--sbatch `{told}`: the array follows from the runs; --jobs limits how many go on at a time"
        ));
    }
    let value = told.trim_start_matches('-').get(name.len() + 1..).unwrap_or_default();
    if value.contains(char::is_whitespace) {
        return Err(format!(
            "--sbatch `{told}`: a value with blanks is cut by sbatch; write it without, as `a_b`"
        ));
    }
    Ok(match (told.starts_with('-'), name.len()) {
        (true, _) => told.to_string(),
        (false, 1) => format!("-{told}"),
        (false, _) => format!("--{told}"),
    })
}

/// Why there is no script for a folder.
fn refusal(folder: &str) -> Option<String> {
    let odd = folder.chars().find(|c| c.is_control() || "\\\"".contains(*c))?;
    Some(format!(
        "a job array cannot be written for `{folder}`: `sbatch` reads {odd:?} in the path of a log otherwise. Choose a folder without it \
         (`--out`)"
    ))
}

/// The script: a job array, and when it is started by hand, the submission of the array and of the gathering behind it.
/// The error tells a folder that it cannot be written for.
pub fn array_script(job: &ArrayJob<'_>) -> Result<String, String> {
    let folder = job.folder.display().to_string();
    if let Some(refusal) = refusal(&folder) {
        return Err(refusal);
    }
    // Slurm puts numbers in the place of `%a` and its kin
    let logs = format!("{}/{LOGS}", folder.replace('%', "%%"));
    let name = job
        .folder
        .file_name()
        .map_or_else(|| "sweep".into(), |name| name.to_string_lossy());
    let name: String = name
        .chars()
        .map(|c| {
            if c.is_ascii_alphanumeric() || "-_.".contains(c) {
                c
            } else {
                '-'
            }
        })
        .collect();
    let last = job.runs.saturating_sub(1);
    let limit = job.jobs.map_or(String::new(), |jobs| format!("%{jobs}"));
    let (folder_word, program) = (quoted(&folder), quoted(&job.program.display().to_string()));
    let log_of_gathering = quoted(&format!("{logs}/gather.log"));
    let retry = if job.retry { " --retry-failed" } else { "" };
    let told = |names: &[&str]| {
        let begins =
            |line: &String, name: &str| line.strip_prefix(name).is_some_and(|rest| rest.starts_with(['=', ' ']));
        job.options
            .iter()
            .any(|line| names.iter().any(|name| begins(line, name)))
    };
    let mut head = vec![format!("--job-name={name}"), format!("--array=0-{last}{limit}")];
    if !told(&["--cpus-per-task", "-c"]) {
        head.push(format!("--cpus-per-task={}", job.threads));
    }
    if !told(&["--output", "-o"]) {
        let output = format!("{logs}/%a.log");
        let quotes = if output.contains(char::is_whitespace) { "\"" } else { "" };
        head.push(format!("--output={quotes}{output}{quotes}"));
    }
    if !told(&["--signal"]) {
        // two minutes before the time is over: a checkpoint is written
        head.push("--signal=B:TERM@120".to_string());
    }
    head.extend(job.options.iter().cloned());
    let head: String = head.iter().map(|line| format!("#SBATCH {line}\n")).collect();
    let words = |line: &String| match line.split_once(' ') {
        Some((option, value)) => format!("{} {}", quoted(option), quoted(value.trim())),
        None => quoted(line),
    };
    let passed: Vec<String> = job.options.iter().map(words).collect();
    let passed = passed.join(" ");
    Ok(format!(
        r#"#!/usr/bin/env bash
{head}
# A sweep of {runs} runs. `bash job.sh` submits them as a job array, and behind it a job that gathers the results.
# Each task carries out one run, or goes on with it; finished ones are left as they are, so the array may be submitted again.
set -euo pipefail
sweep={folder_word}
demeter="${{DEMETER:-}}"
[ -n "$demeter" ] || demeter={program}

if [ -z "${{SLURM_ARRAY_TASK_ID:-}}" ]; then
    array=$(sbatch --parsable "$sweep/job.sh")
    array="${{array%%;*}}"
    gather=$(printf '%q sweep --gather %q' "$demeter" "$sweep")
    sbatch {passed} --job-name={name}-gather --dependency=afterany:"$array" --output={log_of_gathering} --ntasks=1 \
        --cpus-per-task=1 --wrap "$gather"
    echo "submitted job array $array; results will be in $sweep/results.csv"
    exit
fi

exec "$demeter" sweep --resume "$sweep" --only "$SLURM_ARRAY_TASK_ID" --threads "${{SLURM_CPUS_PER_TASK:-{threads}}}"{retry}
"#,
        runs = job.runs,
        threads = job.threads,
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn options_are_passed_on() {
        assert_eq!(option_line("time=2:00:00").unwrap(), "--time=2:00:00");
        assert_eq!(option_line("--partition=short").unwrap(), "--partition=short");
        assert_eq!(option_line("-p short").unwrap(), "-p short");
        assert_eq!(option_line("exclusive").unwrap(), "--exclusive");
        assert_eq!(option_line("A me").unwrap(), "-A me");
        for wrong in [
            "",
            "--",
            "; rm",
            "time=1\nrm",
            "array=0-3",
            "--array=1",
            "comment=a b",
            "-A a b",
        ] {
            assert!(option_line(wrong).is_err(), "{wrong:?}");
        }
    }

    #[test]
    fn the_script_holds_what_was_told() {
        let options = ["--time=2:00:00".to_string(), "-c 8".to_string()];
        let job = ArrayJob {
            folder: Path::new("/data/it's here/x-sweep"),
            program: Path::new("/opt/demeter"),
            runs: 12,
            jobs: Some(4),
            threads: 2,
            options: &options,
            retry: false,
        };
        let script = array_script(&job).unwrap();
        for line in [
            "#SBATCH --job-name=x-sweep\n",
            "#SBATCH --array=0-11%4\n",
            "#SBATCH --time=2:00:00\n",
            "#SBATCH -c 8\n",
            "sweep='/data/it'\\''s here/x-sweep'\n",
            "--only \"$SLURM_ARRAY_TASK_ID\" --threads \"${SLURM_CPUS_PER_TASK:-2}\"\n",
        ] {
            assert!(script.contains(line), "no `{line}`:\n{script}");
        }
        assert!(!script.contains("--cpus-per-task=2"), "{script}");
    }

    /// Slurm wrote the logs of a sweep in `100%a` into `1000`, `1001`, ...
    #[test]
    fn signs_of_slurm_in_the_folder_stand_for_themselves() {
        let job = |folder| ArrayJob {
            folder,
            program: Path::new("/opt/demeter"),
            runs: 2,
            jobs: None,
            threads: 1,
            options: &[],
            retry: false,
        };
        let script = array_script(&job(Path::new("/data/100%a"))).unwrap();
        for line in [
            "#SBATCH --output=/data/100%%a/slurm/%a.log\n",
            "sweep='/data/100%a'\n",
            " --output='/data/100%%a/slurm/gather.log' ",
        ] {
            assert!(script.contains(line), "no `{line}`:\n{script}");
        }
        for odd in ["/data/a\\b", "/data/a\"b", "/data/a\nb"] {
            let refused = array_script(&job(Path::new(odd))).unwrap_err();
            assert!(refused.contains("--out"), "{refused}");
        }
    }
}
