//! What holds for every run: the same bits, closed books, one message where something is wrong.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "helpers of tests may fail as tests do"
)]

#[path = "../cases/mod.rs"]
mod cases;
mod far_ranks;
mod instructions;
mod ledger;
mod order;
mod ranks;
mod restart;
mod threads;
mod watch;
