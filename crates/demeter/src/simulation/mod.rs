//! The state of a run and its protocol.

mod protocol;

pub use protocol::{Cadence, Stage, StopCondition};
