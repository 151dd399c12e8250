//! Ctrl-C and SIGTERM: the first asks a run to end with a checkpoint, the second ends the process at once. A file that grows beyond a
//! limit ends none.

use crate::answer::note;
use crate::exit::Exit;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, OnceLock};
use std::time::{Duration, Instant};

/// Signals this soon after the first are the same wish: `timeout` and others tell a process and its whole group.
const ECHO: Duration = Duration::from_millis(300);

/// Time between two reports of how far a run is.
const REPORTS: Duration = Duration::from_millis(250);

/// Whether and how the run was asked to end.
#[derive(Clone, Default)]
pub struct Interrupt {
    asked: Arc<AtomicBool>,
    steps_run: Arc<AtomicBool>,
    first: Arc<OnceLock<Instant>>,
}

impl Interrupt {
    /// Listens from now on. Where that is impossible, Ctrl-C ends the process at once, as it does without Demeter.
    pub fn listen() -> Self {
        let interrupt = Self::default();
        let heard = interrupt.clone();
        let listening = ctrlc::set_handler(move || heard.receive());
        if let Err(error) = listening {
            note(&format!(
                "warning: Ctrl-C will end the run without a checkpoint: {error}"
            ));
        }
        interrupt
    }

    /// Whether the run was asked to end.
    pub fn is_asked(&self) -> bool {
        self.asked.load(Ordering::SeqCst)
    }

    /// Time until the run is to ask again: none once it is to end.
    pub fn interval(&self) -> Duration {
        if self.is_asked() { Duration::ZERO } else { REPORTS }
    }

    /// Asks the run to end, as Ctrl-C does.
    pub fn ask(&self) {
        self.asked.store(true, Ordering::SeqCst);
    }

    /// Steps are run from now on: there is something that is worth a checkpoint.
    pub fn steps_begin(&self) {
        self.steps_run.store(true, Ordering::SeqCst);
    }

    fn receive(&self) {
        let first = *self.first.get_or_init(Instant::now);
        let again = self.asked.swap(true, Ordering::SeqCst) && first.elapsed() > ECHO;
        if again || !self.steps_run.load(Ordering::SeqCst) {
            note(if again {
                "ended at once"
            } else {
                "interrupted before the first step"
            });
            end_at_once();
        }
    }
}

/// Lets what writes into a file hear that it may not become larger (`ulimit -f`), as of a full disk. Unless this is called the system
/// ends the process without a word.
#[cfg(unix)]
#[allow(unsafe_code, reason = "the standard library does this for broken pipes alone")]
pub fn hear_of_limits() {
    // SAFETY: to ignore a signal installs no code that could run between other code
    unsafe { libc::signal(libc::SIGXFSZ, libc::SIG_IGN) };
}

#[allow(clippy::exit, reason = "the user asked not to wait for the run")]
fn end_at_once() {
    std::process::exit(Exit::Interrupted as i32);
}
