//! The engine against analytic and converged results, and published cases.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "helpers of tests may fail as tests do"
)]

mod adhesion;
mod belts;
#[path = "../cases/mod.rs"]
mod cases;
mod chung_ooi;
mod chung_ooi_oblique;
mod convergence;
mod coupling;
mod coupling_squeeze;
mod coupling_stability;
mod elastic_gas;
mod examples;
mod gear;
mod incline;
mod longer_steps;
mod multi_contact;
mod oblique;
mod plasticity;
mod requests;
mod rest;
mod restitution;
mod rotation;
mod seams;
mod sliding_to_rolling;
mod smooth_motion;
mod three_grain_block;
mod tomas;
