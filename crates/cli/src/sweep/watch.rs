//! What a user sees while a sweep goes on: a bar on a terminal, lines elsewhere.

use crate::answer::note;
use crate::progress::bar;
use crate::readable::{things, wait};
use demeter::sweep::{Status, SweepFolder};
use indicatif::ProgressBar;
use std::collections::{BTreeMap, VecDeque};
use std::io::IsTerminal;
use std::time::{Duration, Instant};

/// Time between two lines where there is no terminal.
const LINE_INTERVAL: Duration = Duration::from_secs(15);
/// Steps of the bar.
const LENGTH: f64 = 1000.0;

/// How far a run is.
struct Share {
    /// When it was first heard of, once it was.
    first: Option<f64>,
    /// Now.
    last: f64,
    began: Instant,
}

/// Watches a sweep.
pub struct Watch<'a> {
    folder: &'a SweepFolder,
    bar: Option<ProgressBar>,
    began: Instant,
    next_line: Instant,
    /// Estimated work of the runs that this process carries out.
    work: BTreeMap<usize, f64>,
    shares: BTreeMap<usize, Share>,
    finished: usize,
    failed: usize,
}

impl<'a> Watch<'a> {
    /// Watches the runs that are left.
    pub fn new(folder: &'a SweepFolder, statuses: &[Status], left: &VecDeque<usize>) -> Self {
        let work = |&index: &usize| (index, folder.plan.runs[index].estimate.run_time.max(1e-9));
        let is_left = |index: &usize| left.contains(index);
        let failed = statuses
            .iter()
            .enumerate()
            .filter(|(k, status)| status.failure().is_some() && !is_left(k));
        Self {
            folder,
            bar: std::io::stderr().is_terminal().then(bar),
            began: Instant::now(),
            next_line: Instant::now() + LINE_INTERVAL,
            work: left.iter().map(work).collect(),
            shares: BTreeMap::new(),
            finished: statuses.iter().filter(|status| status.is_finished()).count(),
            failed: failed.count(),
        }
    }

    /// Tells what is begun.
    pub fn begin(&self, left: usize, jobs: usize) {
        let root = self.folder.root().display();
        let all = things(self.folder.plan.runs.len() as u64, "run");
        if left == 0 {
            return;
        }
        let before = match self.finished {
            0 => String::new(),
            finished => format!(", {finished} finished earlier"),
        };
        self.say(&format!("{all} in {root}{before}; {jobs} at a time"));
    }

    /// A run begins.
    pub fn started(&mut self, index: usize) {
        let share = Share {
            first: None,
            last: 0.0,
            began: Instant::now(),
        };
        self.shares.insert(index, share);
    }

    /// A run tells how far it is.
    pub fn progress(&mut self, index: usize, share: f64) {
        if let Some(known) = self.shares.get_mut(&index) {
            known.first = known.first.or(Some(share));
            known.last = share;
        }
    }

    /// A run ended.
    pub fn ended(&mut self, index: usize, status: &Status) {
        let took = self
            .shares
            .get(&index)
            .map_or(Duration::ZERO, |share| share.began.elapsed());
        let name = &self.folder.plan.runs[index].name;
        let text = match (status.failure(), status.is_finished()) {
            (Some(outcome), _) => {
                self.failed += 1;
                format!("{}: {}", outcome.end.name(), outcome.message)
            }
            (None, true) => {
                self.finished += 1;
                format!("finished in {}", wait(took.as_secs_f64()))
            }
            (None, false) => status.name().to_string(),
        };
        if status.is_finished() {
            if let Some(share) = self.shares.get_mut(&index) {
                share.last = 1.0;
            }
        } else {
            // what it would still have to do is not done here
            self.work.remove(&index);
        }
        let (done, all) = (self.finished + self.failed, self.folder.plan.runs.len());
        self.say(&format!("[{done}/{all}] {name}: {text}"));
    }

    /// Tells how far the sweep is, now and then.
    pub fn tell(&mut self, running: usize) {
        let text = || {
            let left = self
                .time_left()
                .map_or(String::new(), |left| format!(", about {} left", wait(left)));
            let all = self.folder.plan.runs.len();
            format!(
                "{} of {all} finished, {running} running, {} failed{left}",
                self.finished, self.failed
            )
        };
        match &self.bar {
            Some(bar) => {
                bar.set_length(LENGTH as u64);
                bar.set_position((LENGTH * self.share()) as u64);
                bar.set_message(text());
            }
            None if Instant::now() >= self.next_line => {
                note(&format!("{:3.0} % of what was left; {}", 100.0 * self.share(), text()));
                self.next_line = Instant::now() + LINE_INTERVAL;
            }
            None => {}
        }
    }

    /// Tells something.
    pub fn say(&self, text: &str) {
        match &self.bar {
            Some(bar) => bar.suspend(|| note(text)),
            None => note(text),
        }
    }

    /// Removes the bar.
    pub fn end(&self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }

    /// Work done of all runs that are carried out here, and the part of it that was done here.
    fn done(&self) -> (f64, f64) {
        let parts = self
            .shares
            .iter()
            .filter_map(|(index, share)| Some((self.work.get(index)?, share)));
        parts.fold((0.0, 0.0), |(all, here), (work, share)| {
            (
                all + work * share.last,
                here + work * (share.last - share.first.unwrap_or(0.0)),
            )
        })
    }

    fn share(&self) -> f64 {
        let all: f64 = self.work.values().sum();
        if all > 0.0 { (self.done().0 / all).min(1.0) } else { 1.0 }
    }

    /// Seconds until all is done at the present pace.
    fn time_left(&self) -> Option<f64> {
        let (done, here) = self.done();
        let left = self.work.values().sum::<f64>() - done;
        (here > 0.0).then(|| left * self.began.elapsed().as_secs_f64() / here)
    }
}
