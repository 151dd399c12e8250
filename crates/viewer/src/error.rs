//! What can go wrong with the viewer.

use demeter::results::ResultsError;
use std::io;

/// Why a run cannot be shown.
#[derive(Debug, thiserror::Error)]
pub enum ViewerError {
    /// The folder is no run.
    #[error(transparent)]
    Results(#[from] ResultsError),
    /// The address is taken, or may not be used.
    #[error(
        "cannot listen on 127.0.0.1:{port}: {source}. Choose another port (`--port`), or leave it out: then a free one is taken"
    )]
    Listen {
        /// The port.
        port: u16,
        /// What the system said.
        source: io::Error,
    },
    /// The system has no random numbers for the key of the address.
    #[error("cannot make the key of the address: {0}")]
    NoKey(String),
    /// The system refused threads or timers.
    #[error("cannot serve: {0}")]
    Serve(#[from] io::Error),
}
