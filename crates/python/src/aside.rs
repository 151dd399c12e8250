//! Work without the interpreter.

use crate::control::Messages;
use crate::errors::Error;
use engine::scenario::{Observer, Progress};
use pyo3::prelude::*;
use std::panic::resume_unwind;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::Duration;

/// Works on all cores while other Python threads run.
pub fn aside<T: Send>(py: Python<'_>, work: impl FnOnce() -> T + Send) -> PyResult<T> {
    // the threads of a pool that outlived its work would be missing in a process that is forked later
    let pool = rayon::ThreadPoolBuilder::new().build();
    let pool = pool.map_err(|error| Error::new_err(format!("no threads can be started: {error}")))?;
    let worked = py.detach(|| pool.install(work));
    // else a Ctrl-C comes in the middle of whatever asks Python next
    py.check_signals()?;
    Ok(worked)
}

/// So often a function whose runs go on looks for Ctrl-C, which only the thread that called it hears.
const LOOK_EVERY: Duration = Duration::from_millis(50);

/// Works with runs that belong to a function: Ctrl-C ends them.
pub fn listening<T: Send>(py: Python<'_>, work: impl FnOnce(&mut Listener<'_>) -> T + Send) -> PyResult<T> {
    let is_asked_to_stop = AtomicBool::new(false);
    thread::scope(|scope| {
        let mut listener = Listener {
            messages: Messages::default(),
            is_asked_to_stop: &is_asked_to_stop,
        };
        let worker = scope.spawn(move || work(&mut listener));
        let mut raised = None;
        while !worker.is_finished() {
            py.detach(|| thread::sleep(LOOK_EVERY));
            if let Err(error) = py.check_signals() {
                is_asked_to_stop.store(true, Ordering::Relaxed);
                raised.get_or_insert(error);
            }
        }
        let worked = py.detach(|| worker.join()).unwrap_or_else(|panic| resume_unwind(panic));
        raised.map_or(Ok(worked), Err)
    })
}

/// Tells the messages of runs to `logging` as they come.
pub struct Listener<'a> {
    messages: Messages,
    is_asked_to_stop: &'a AtomicBool,
}

impl Observer for Listener<'_> {
    fn progress(&mut self, _progress: &Progress) -> bool {
        !self.is_asked_to_stop.load(Ordering::Relaxed)
    }

    fn message(&mut self, text: &str) {
        let before = self.messages.list.len();
        self.messages.message(text);
        // what a handler of `logging` raises is none of the fit's
        let _ = Python::attach(|py| self.messages.tell(py, before));
    }
}
