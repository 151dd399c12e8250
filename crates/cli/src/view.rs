//! `demeter view`: the whole history of a run in the browser.

use crate::answer::{answer, note};
use crate::arguments::ViewArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use demeter::results::ResultsError;
use demeter_viewer::{Options, Viewer, ViewerError};

/// Serves a run until Ctrl-C.
pub fn view(arguments: &ViewArguments) -> Result<Exit, Failure> {
    let options = Options {
        port: arguments.port,
        compress: arguments.compress,
        ..Options::default()
    };
    let viewer = Viewer::open(&arguments.folder, options).map_err(failure)?;
    ended_by_user()?;
    answer(&format!("{}\n", viewer.url()))?;
    note(&format!(
        "showing `{}`; Ctrl-C ends it. Only this machine reaches the address, and only who knows all of it: from another one,\n\
         ssh -L {port}:127.0.0.1:{port} THIS-MACHINE",
        arguments.folder.display(),
        port = viewer.port()
    ));
    if !arguments.no_browser && open::that_detached(viewer.url_once()).is_err() {
        note("no browser could be opened: open the address in one");
    }
    match viewer.serve() {
        Ok(never) => match never {},
        Err(error) => Err(failure(error)),
    }
}

/// Ctrl-C and SIGTERM end the viewer as what it is: done.
fn ended_by_user() -> Result<(), Failure> {
    ctrlc::set_handler(end).map_err(|error| Failure::io(format!("cannot listen to Ctrl-C: {error}")))
}

#[allow(clippy::exit, reason = "the viewer writes nothing, so there is nothing to finish")]
fn end() {
    std::process::exit(Exit::Finished as i32);
}

fn failure(error: ViewerError) -> Failure {
    let message = error.to_string();
    match error {
        ViewerError::Listen { .. } => Failure::wrong(message),
        ViewerError::Results(error) if !error.is_io() && !matches!(error, ResultsError::Damaged { .. }) => {
            Failure::wrong(message)
        }
        ViewerError::Results(_) | ViewerError::Serve(_) | ViewerError::NoKey(_) => Failure::io(message),
    }
}
