//! Serves the folder of a run to a browser on this machine: `demeter view`.
//!
//! The server listens on 127.0.0.1 only and answers `GET` only. A request names numbers, never files: steps, ids of grains,
//! indices of columns. What it reads is read by [`demeter::results`], which opens nothing outside the folder. Every path begins
//! with a random key, which only the address of the page tells; without it all is refused with the same words.
//!
//! | path behind `/KEY` | answer |
//! |---|---|
//! | `/`, `/viewer.js`, `/viewer.css`, `/licences.txt` | the page |
//! | `/api/state?moments=M` | the run, its moments from the `M`-th on, columns and stages of the series (JSON) |
//! | `/api/series?columns=A,B&from=N` | columns of the series from row `N` on ([packed](pack)) |
//! | `/api/frame/STEP` | grains of a step, with the key of its walls ([packed](pack)) |
//! | `/api/contacts/STEP` | contacts of a step, as force chains ([packed](pack)) |
//! | `/api/walls/STEP` | triangles of the walls at a step ([packed](pack)) |
//! | `/api/grain/STEP/ID` | a grain with its contacts at a step (JSON) |
//! | `/api/history/ID?moments=K,L` | the grain at moments, as many of them as are told quickly (JSON) |

mod api;
mod cache;
mod error;
mod frame;
mod grain;
mod key;
pub mod pack;
mod page;
mod request;
mod server;
mod watch;

pub use error::ViewerError;
pub use server::{Options, Viewer};
