//! Runs the parts of a sweep as processes, so many at a time.

use super::needs;
use super::watch::Watch;
use crate::arguments::SweepArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::interrupt::Interrupt;
use demeter::sweep::{End, Outcome, Status, SweepFolder};
use std::collections::{BTreeMap, VecDeque};
use std::io::{BufRead, BufReader, Read};
use std::process::{Child, ChildStdin, Command, ExitStatus, Stdio};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError, Sender};
use std::time::{Duration, Instant};

/// Time between two looks at whether the user asks to end.
const LOOK: Duration = Duration::from_millis(50);
/// Least time between two writings of the state.
const STATE_INTERVAL: Duration = Duration::from_secs(2);
/// Last lines of a process that are kept.
const LAST_LINES: usize = 30;
/// Longest line of them [bytes].
const LONGEST_LINE: u64 = 4096;

/// What a process tells.
enum Event {
    Progress { index: usize, share: f64 },
    Ended(usize, Box<Ending>),
}

/// How a process ended.
struct Ending {
    status: std::io::Result<ExitStatus>,
    last_lines: Vec<String>,
}

/// A sweep when nothing more goes on.
pub struct Ended {
    /// How far each run is.
    pub statuses: Vec<Status>,
    interrupted: bool,
}

impl Ended {
    /// The exit code that tells it.
    pub fn exit(&self) -> Exit {
        let has_failed = self.statuses.iter().any(|status| status.failure().is_some());
        match (self.interrupted, has_failed) {
            (true, _) => Exit::Interrupted,
            (_, true) => Exit::Fault,
            _ if self.statuses.iter().all(Status::is_finished) => Exit::Finished,
            _ => Exit::InputOutput,
        }
    }
}

/// The processes of a sweep.
pub struct Team<'a> {
    folder: &'a SweepFolder,
    arguments: &'a SweepArguments,
    jobs: usize,
    memory: u64,
    statuses: Vec<Status>,
    waiting: VecDeque<usize>,
    /// Standard inputs of the processes: to let go of one asks its process to end.
    running: BTreeMap<usize, Option<ChildStdin>>,
    watch: Watch<'a>,
    state_written: Instant,
    events: (Sender<Event>, Receiver<Event>),
}

impl<'a> Team<'a> {
    /// Finds out what is left to do.
    pub fn new(folder: &'a SweepFolder, arguments: &'a SweepArguments) -> Self {
        let statuses = folder.statuses();
        let is_left = |status: &Status| match status {
            Status::Ended(_) if status.is_finished() => false,
            Status::Ended(_) => arguments.retry_failed,
            Status::Waiting | Status::Running | Status::Interrupted => true,
        };
        let waiting: VecDeque<usize> = (0..statuses.len()).filter(|&index| is_left(&statuses[index])).collect();
        Self {
            jobs: needs::jobs(arguments, waiting.len()),
            memory: needs::memory(),
            watch: Watch::new(folder, &statuses, &waiting),
            folder,
            arguments,
            statuses,
            waiting,
            running: BTreeMap::new(),
            state_written: Instant::now(),
            events: mpsc::channel(),
        }
    }

    /// Runs all that is left, until it is done or the user asks to end.
    pub fn run(mut self, interrupt: Interrupt) -> Result<Ended, Failure> {
        let mut interrupted = false;
        interrupt.steps_begin();
        self.watch.begin(self.waiting.len(), self.jobs);
        let ended = loop {
            while !interrupted && self.has_room() {
                if let Some(index) = self.waiting.pop_front() {
                    self.start(index);
                }
            }
            if self.running.is_empty() {
                break self.folder.write_state(&self.statuses);
            }
            match self.events.1.recv_timeout(LOOK) {
                Ok(Event::Progress { index, share }) => self.watch.progress(index, share),
                Ok(Event::Ended(index, ending)) => self.end(index, &ending),
                Err(RecvTimeoutError::Timeout | RecvTimeoutError::Disconnected) => {}
            }
            if interrupt.is_asked() && !interrupted {
                interrupted = true;
                self.watch
                    .say("interrupted: the runs write checkpoints; interrupt again to end at once");
                self.running.values_mut().for_each(|input| *input = None);
            }
            self.watch.tell(self.running.len());
            if self.state_written.elapsed() > STATE_INTERVAL {
                self.state_written = Instant::now();
                if let Err(error) = self.folder.write_state(&self.statuses) {
                    // what matters is in the folders of the runs
                    self.watch.say(&format!("warning: {error}"));
                }
            }
        };
        self.watch.end();
        ended?;
        let statuses = self.statuses;
        Ok(Ended { statuses, interrupted })
    }

    /// Whether the next run may start: one always may.
    fn has_room(&self) -> bool {
        let need = |index: &usize| self.folder.plan.runs[*index].estimate.memory;
        let Some(next) = self.waiting.front() else {
            return false;
        };
        let taken: u64 = self.running.keys().map(need).fold(0, u64::saturating_add);
        let fits = taken.saturating_add(need(next)) <= self.memory;
        self.running.is_empty() || (self.running.len() < self.jobs && fits)
    }

    fn start(&mut self, index: usize) {
        match self.spawn(index) {
            Ok(mut child) => {
                let input = child.stdin.take();
                let events = self.events.0.clone();
                std::thread::spawn(move || follow(index, child, &events));
                self.running.insert(index, input);
                self.watch.started(index);
                self.statuses[index] = Status::Running;
            }
            Err(error) => self.fail(index, End::Error, format!("its process could not be started: {error}")),
        }
    }

    fn spawn(&self, index: usize) -> std::io::Result<Child> {
        let mut command = Command::new(std::env::current_exe()?);
        command.args(["sweep", "--as-part", "--resume"]).arg(self.folder.root());
        command.args([
            "--only",
            &index.to_string(),
            "--threads",
            &self.arguments.threads.to_string(),
        ]);
        if self.arguments.retry_failed {
            command.arg("--retry-failed");
        }
        command
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped());
        command.spawn()
    }

    fn end(&mut self, index: usize, ending: &Ending) {
        self.running.remove(&index);
        let status = self.folder.status(index);
        if let Status::Ended(_) = status {
            self.statuses[index] = status;
            self.watch.ended(index, &self.statuses[index]);
            return;
        }
        let last = ending.last_lines.last().map_or("", String::as_str);
        let (code, how) = match &ending.status {
            Ok(status) => (status.code(), status.to_string()),
            Err(error) => (None, error.to_string()),
        };
        match code {
            Some(code) if code == Exit::Interrupted as i32 => {
                self.statuses[index] = Status::Interrupted;
                self.watch.ended(index, &Status::Interrupted);
            }
            // it told why; nothing is noted in the folder of the run, so that it is tried again the next time
            Some(code) if code == Exit::Wrong as i32 || code == Exit::InputOutput as i32 => {
                let message = last.trim_start_matches("error: ").to_string();
                self.statuses[index] = Status::Ended(Outcome {
                    end: End::Error,
                    message,
                });
                self.watch.ended(index, &self.statuses[index]);
            }
            _ => {
                let why = cause(&ending.last_lines);
                self.fail(index, End::Crash, format!("its process died ({how}){why}"));
            }
        }
    }

    /// Notes that a run failed.
    fn fail(&mut self, index: usize, end: End, message: String) {
        let outcome = Outcome { end, message };
        if let Err(error) = self.folder.record(index, &outcome) {
            self.watch.say(&format!("warning: {error}"));
        }
        self.statuses[index] = Status::Ended(outcome);
        self.watch.ended(index, &self.statuses[index]);
    }
}

/// What a dead process said of the reason.
fn cause(last_lines: &[String]) -> String {
    let panicked = last_lines.iter().position(|line| line.contains("panicked at"));
    match panicked {
        Some(at) => {
            let told: Vec<&str> = last_lines[at..].iter().take(2).map(|line| line.trim()).collect();
            format!(": {}", told.join(" "))
        }
        None => ": killed from outside, perhaps for lack of memory".to_string(),
    }
}

/// Passes on what a process tells, until it ends.
fn follow(index: usize, mut child: Child, events: &Sender<Event>) {
    let errors = child.stderr.take();
    let last_lines = std::thread::spawn(move || errors.map(last_lines).unwrap_or_default());
    if let Some(output) = child.stdout.take() {
        for line in BufReader::new(output).lines().map_while(Result::ok) {
            let Ok(told) = serde_json::from_str::<serde_json::Value>(&line) else {
                continue;
            };
            if let (Some(step), Some(steps)) = (told["step"].as_f64(), told["steps"].as_f64()) {
                let share = (step / steps.max(1.0)).min(1.0);
                // nobody listens any more when the sweep is ended at once
                let _ = events.send(Event::Progress { index, share });
            }
        }
    }
    let status = child.wait();
    let last_lines = last_lines.join().unwrap_or_default();
    let _ = events.send(Event::Ended(index, Box::new(Ending { status, last_lines })));
}

/// The last lines that a process says.
fn last_lines(errors: impl Read) -> Vec<String> {
    let mut reader = BufReader::new(errors);
    let mut lines = VecDeque::new();
    let mut line = Vec::new();
    while matches!(reader.by_ref().take(LONGEST_LINE).read_until(b'\n', &mut line), Ok(1..)) {
        let text = String::from_utf8_lossy(&line).trim_end().to_string();
        line.clear();
        if !text.is_empty() {
            lines.push_back(text);
        }
        if lines.len() > LAST_LINES {
            lines.pop_front();
        }
    }
    lines.into()
}
