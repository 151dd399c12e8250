//! Demeter: a discrete element method engine for powders and soft grains.
//!
//! The crate is the engine as a library; the binary `demeter` is in `demeter-cli`. Modules import in one direction:
//!
//! ```text
//! particles, materials, comm, grain_files <- neighbours, walls <- contacts <- insertion <- step, simulation, checkpoint
//!     <- measure, output <- results <- report <- compare <- scenario <- calibrate, interchange, render, sweep
//! ```
//!
//! A program that uses it reads a [`scenario::Scenario`] and goes on with a [`scenario::LiveRun`]; `book/src/from-rust.md` holds one.
//!
//! The book (`book/src`; `cargo xtask book` makes it) begins with a first run, lists all keys of a scenario, and tells how this works:
//! contacts over the window of a step (`time-centred.md`), the energy books (`ledger.md`), the same bits everywhere
//! (`same-bits.md`).
//!
//! Every quantity is SI `f64`; units exist in [`scenario`] only.

pub mod calibrate;
pub mod checkpoint;
pub mod comm;
pub mod compare;
pub mod contacts;
pub mod grain_files;
pub mod insertion;
pub mod interchange;
pub mod materials;
pub mod measure;
pub mod neighbours;
pub mod output;
pub mod particles;
pub mod render;
pub mod report;
pub mod results;
pub mod scenario;
pub mod simulation;
mod step;
pub mod sweep;
mod threads;
pub mod walls;

pub use demeter_physics::{self as physics, DQuat, DVec3};

/// Version of the engine.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");
