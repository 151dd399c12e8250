//! The engine as its users have it: set-ups, runs, what they measure and write.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "helpers of tests may fail as tests do"
)]

mod book;
#[path = "../cases/mod.rs"]
mod cases;
mod changed;
mod changed_rows;
mod collisions;
mod column_stops;
mod custom;
mod deforming_boxes;
mod departures;
mod endings;
mod exchange;
mod extent;
mod feeds;
mod fields;
mod impact_speeds;
mod measures;
mod polydisperse;
mod profile;
mod report;
mod restart;
mod rubbing;
mod scenarios;
mod shafts;
mod shared_runs;
mod silent;
mod slices;
mod solids;
mod stage_changes;
mod wall_work;
mod walls_load;
mod work_counters;
