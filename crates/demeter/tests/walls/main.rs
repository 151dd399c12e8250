//! Walls of every kind.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "helpers of tests may fail as tests do"
)]

#[path = "../cases/mod.rs"]
mod cases;
mod hollows;
mod leak;
mod mesh;
mod mesh_files;
mod mesh_repair;
mod motion;
mod one_or_two;
mod periodic;
mod refused;
mod stl;
mod wall;
mod wear;
