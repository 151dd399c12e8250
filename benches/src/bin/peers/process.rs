//! Running another program: its output, its memory, and what else the machine was busy with.

use crate::grains::Fault;
use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// Time between two looks at a running program.
const LOOK: Duration = Duration::from_millis(20);

/// A program that has ended well.
#[derive(Clone, Debug)]
pub struct Ended {
    /// Its standard output and error.
    pub output: String,
    /// Largest resident memory [bytes], where the system tells it.
    pub peak: Option<u64>,
    /// How many cores were busy with other programs, on average, where the system tells it.
    pub others: Option<f64>,
}

/// Runs a program in a folder, with its output into a file, and waits for its end.
pub fn run(mut command: Command, folder: &Path, log: &Path, patience: Duration) -> Result<Ended, Fault> {
    let shown = format!("{command:?}");
    let (begun, before) = (Instant::now(), busy());
    let file = File::create(log).map_err(|e| format!("{}: {e}", log.display()))?;
    command
        .current_dir(folder)
        .stdin(Stdio::null())
        .stdout(file.try_clone()?)
        .stderr(file);
    let mut child = command.spawn().map_err(|e| format!("{shown}: {e}"))?;
    let (mut peak, mut own) = (None, 0.0);
    let status = loop {
        if let Some(status) = child.try_wait()? {
            break status;
        }
        let at = PathBuf::from(format!("/proc/{}", child.id()));
        peak = peak_memory(&at).max(peak);
        own = cpu_of(&at).unwrap_or(own);
        if begun.elapsed() > patience {
            child.kill()?;
            child.wait()?;
            return Err(format!("{shown}: not done after {} s", patience.as_secs()).into());
        }
        std::thread::sleep(LOOK);
    };
    let output = String::from_utf8_lossy(&fs::read(log)?).into_owned();
    if !status.success() {
        let tail: Vec<&str> = output.lines().rev().take(6).collect();
        let tail = tail.into_iter().rev().collect::<Vec<_>>().join("\n");
        return Err(format!("{shown} in {}: {status}\n{tail}", folder.display()).into());
    }
    let elapsed = begun.elapsed().as_secs_f64();
    let others = before
        .zip(busy())
        .map(|(before, after)| ((after - before - own) / elapsed).max(0.0));
    Ok(Ended { output, peak, others })
}

/// Largest resident memory of the process that a folder of `/proc` describes [bytes].
pub fn peak_memory(process: &Path) -> Option<u64> {
    let status = fs::read_to_string(process.join("status")).ok()?;
    let line = status.lines().find_map(|l| l.strip_prefix("VmHWM:"))?;
    let kibibytes: u64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    Some(kibibytes * 1024)
}

/// Ticks of the clock of `/proc` in a second, on every Linux machine.
const TICKS: f64 = 100.0;

/// Processor time of a process [s].
fn cpu_of(process: &Path) -> Option<f64> {
    let stat = fs::read_to_string(process.join("stat")).ok()?;
    // the name, in brackets, may hold anything; user and system time are the 12th and 13th word after it
    let words: Vec<&str> = stat.rsplit_once(')')?.1.split_whitespace().collect();
    let ticks = |k: usize| words.get(k)?.parse::<f64>().ok();
    Some((ticks(11)? + ticks(12)?) / TICKS)
}

/// Core seconds that the machine was busy since its start, niced work included.
fn busy() -> Option<f64> {
    let stat = fs::read_to_string("/proc/stat").ok()?;
    let words: Vec<f64> = stat
        .lines()
        .next()?
        .split_whitespace()
        .skip(1)
        .filter_map(|w| w.parse().ok())
        .collect();
    // user, nice, system, idle, iowait, irq, softirq, steal
    Some((words.first()? + words.get(1)? + words.get(2)? + words.get(5)? + words.get(6)? + words.get(7)?) / TICKS)
}

/// A program by its name, as the shell finds it.
pub fn find_program(name: &str) -> Option<PathBuf> {
    let paths = std::env::var_os("PATH")?;
    std::env::split_paths(&paths)
        .map(|folder| folder.join(name))
        .find(|path| path.is_file())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shell(text: &str, patience: Duration) -> Result<Ended, Fault> {
        let folder = tempfile::tempdir().unwrap();
        let mut command = Command::new("sh");
        command.args(["-c", text]);
        run(command, folder.path(), &folder.path().join("log"), patience)
    }

    #[test]
    fn output_and_failure_of_a_program_are_told() {
        let minute = Duration::from_secs(60);
        assert_eq!(shell("echo one; echo two >&2", minute).unwrap().output, "one\ntwo\n");
        let fault = shell("echo what was wrong; exit 3", minute).unwrap_err().to_string();
        assert!(fault.contains("what was wrong") && fault.contains('3'), "{fault}");
        let fault = shell("exec sleep 60", Duration::from_millis(50))
            .unwrap_err()
            .to_string();
        assert!(fault.contains("not done"), "{fault}");
        assert!(
            run(
                Command::new("/no/such/program"),
                Path::new("."),
                Path::new("/no/such/log"),
                minute
            )
            .is_err()
        );
    }

    #[test]
    #[cfg(target_os = "linux")]
    fn this_process_has_memory_and_time() {
        assert!(peak_memory(Path::new("/proc/self")).unwrap() > 1 << 20);
        assert!(cpu_of(Path::new("/proc/self")).is_some() && busy().unwrap() > 0.0);
        assert!(find_program("sh").is_some() && find_program("no-such-program").is_none());
    }
}
