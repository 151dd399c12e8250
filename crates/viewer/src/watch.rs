//! The run as it is now: its moments and its series, which may grow while it is shown.

use demeter::results::{Columns, Moment, ResultsError, Run, Update};
use std::path::PathBuf;
use std::time::{Duration, Instant, SystemTime};

/// How long what was found is taken to be true.
const FRESH: Duration = Duration::from_millis(200);

/// What is known of a run.
#[derive(Debug)]
pub(crate) struct Watch {
    pub run: Run,
    pub moments: Vec<Moment>,
    pub series: Option<Columns>,
    /// Why the series cannot be read; what was read before is kept.
    pub fault: Option<String>,
    /// Grows when moments or rows went away: what a page has of them is then of no use.
    pub epoch: u64,
    begun: Option<SystemTime>,
    looked: Option<Instant>,
}

impl Watch {
    /// Begins to watch a run.
    pub fn new(run: Run) -> Result<Self, ResultsError> {
        let mut watch = Self {
            begun: None,
            run,
            moments: Vec::new(),
            series: None,
            fault: None,
            epoch: 0,
            looked: None,
        };
        watch.look()?;
        watch.epoch = 0;
        Ok(watch)
    }

    /// Looks at the folder again, unless that was done a moment ago.
    pub fn look(&mut self) -> Result<(), ResultsError> {
        if self.looked.is_some_and(|at| at.elapsed() < FRESH) {
            return Ok(());
        }
        let begun = modified(&self.run, self.run.folder().marker());
        let moments = self.run.moments()?;
        let goes_on = moments.starts_with(&self.moments) && begun == self.begun;
        if !goes_on {
            self.epoch += 1;
        }
        if begun != self.begun {
            self.series = None;
        }
        self.begun = begun;
        self.moments = moments;
        let read = self.read_series();
        self.fault = read.err().map(|error| error.to_string());
        self.looked = Some(Instant::now());
        Ok(())
    }

    fn read_series(&mut self) -> Result<(), ResultsError> {
        match &mut self.series {
            None => self.series = self.run.series()?,
            Some(series) => {
                let before = series.rows();
                if self.run.update(series)? == Update::Replaced && before > 0 {
                    self.epoch += 1;
                }
            }
        }
        Ok(())
    }
}

/// When a file of the run was written last.
pub(crate) fn modified(run: &Run, path: PathBuf) -> Option<SystemTime> {
    let file = run.file(&path).ok()??;
    file.metadata().ok()?.modified().ok()
}
