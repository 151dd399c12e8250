//! What a run will need: memory, time, and room for its frames and its series.

use super::run::labels;
use super::{FeedRate, Scenario};
use crate::insertion::SizeSampler;
use crate::simulation::{Stage, ends_within};
use crate::walls::Wall;

/// Memory of a grain with its contacts, candidates, and its share of a frame while that is written [bytes], and that of a run of few
/// grains: above the largest resident sizes (`/usr/bin/time -v`) of `examples/settle-20000`, 133 MB, and of the bed `w6-1m` of
/// `benches/peers` with frames, picture and report, 731 MB (768 MB where it is resumed), of which the steps take 400.
const BYTES_PER_GRAIN: f64 = 800.0;
const BYTES_OF_A_RUN: f64 = 120e6;

/// What contacts that feel each other add to that of a grain: above the largest resident size of 131,072 grains of a face-centred
/// lattice with `half-space`, each touched by twelve, 656 MB in all.
const BYTES_OF_COUPLING: f64 = 3300.0;

/// Memory of a triangle of a mesh, with what is needed while it is read and drawn [bytes]: above that of three grains beside a binary STL
/// file of 980,000 triangles, a square cut into 700 by 700 (`/usr/bin/time -v demeter run`): 378 MB in all.
const BYTES_PER_TRIANGLE: f64 = 300.0;

/// Particle-steps per second and thread, and those where contacts feel each other (`benches/README.md`).
const SPEED: f64 = 2e6;
const COUPLED_SPEED: f64 = 7e5;

/// Room in the files of a frame [bytes]: of next to nothing, of a grain with its contacts, above that of the bed `w6-1m` of `benches/peers`
/// at its start (348 MB), and of a triangle, above that of the mesh above, which is flat (13 MB).
const FRAME_BYTES: f64 = 8e3;
const FRAME_BYTES_PER_GRAIN: f64 = 500.0;
const FRAME_BYTES_PER_TRIANGLE: f64 = 21.0;
/// Time that they take to be written [s], as `demeter run --profile` told of these two: 5.7 and 0.5 s a frame.
const FRAME_TIME_PER_GRAIN: f64 = 5e-6;
const FRAME_TIME_PER_TRIANGLE: f64 = 5e-7;

/// Room of a value of the series [bytes], and the time until it is written [s]: of runs with 39 to 86 columns 10 to 14 bytes, and of 500 walls, of
/// which most values are 0, 4; 0.34 us.
const VALUE_BYTES: f64 = 12.0;
const VALUE_TIME: f64 = 3.5e-7;

/// What feeds let come when no condition ends a stage early.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Fed {
    /// Number of grains; of feeds that go on as there is room, without a number or a mass at which they end, none.
    pub grains: f64,
    /// Names of those feeds.
    pub unknown: Vec<String>,
}

/// What feeds let come in stages that take so long at most [s].
pub(super) fn fed(scenario: &Scenario, stages: &[f64]) -> Fed {
    let mut fed = Fed::default();
    for (index, feed) in scenario.feeds.iter().enumerate() {
        let grains = expected_of_feed(scenario, index, stages);
        if grains.is_finite() {
            fed.grains += grains;
        } else {
            fed.unknown.push(feed.name.clone());
        }
    }
    fed
}

/// For how long a feed may run [s].
pub(super) fn time_of_feed(scenario: &Scenario, feed: usize, stages: &[f64]) -> f64 {
    let (mut passed, mut runs, mut running) = (0.0, true, 0.0);
    let until = scenario.feeds[feed].end.until.unwrap_or(f64::INFINITY);
    for (stage, seconds) in scenario.stages.iter().zip(stages) {
        if let Some(feeds) = &stage.feeds {
            runs = feeds.contains(&feed);
        }
        let end = passed + seconds;
        if runs {
            running += (end.min(until) - passed).max(0.0);
        }
        passed = end;
    }
    running
}

/// Number of grains that a feed lets come in stages of these lengths [s]; infinite where neither its rate nor its ends tell.
pub(super) fn expected_of_feed(scenario: &Scenario, index: usize, stages: &[f64]) -> f64 {
    let feed = &scenario.feeds[index];
    let seconds = time_of_feed(scenario, index, stages);
    let density = (scenario.materials.get(usize::from(feed.stream.material))).map_or(f64::NAN, |m| m.density);
    let of_mass = |mass: f64| {
        let mean = SizeSampler::new(&feed.stream.diameter).map_or(f64::NAN, |sizes| density * sizes.mean_volume());
        if mean > 0.0 { mass / mean } else { 0.0 }
    };
    let by_rate = match feed.rate {
        FeedRate::Number(rate) => rate * seconds,
        FeedRate::Mass(rate) => of_mass(rate * seconds),
        FeedRate::AsRoomAllows => f64::INFINITY,
    };
    let by_count = feed.end.count.map_or(f64::INFINITY, |count| count as f64);
    by_rate.min(by_count).min(feed.end.mass.map_or(f64::INFINITY, of_mass))
}

/// Memory that a run with so many grains and such walls needs at most [bytes].
pub(super) fn memory(grains: f64, walls: &[Wall], are_coupled: bool) -> f64 {
    let felt: usize = walls.iter().map(Wall::felt_triangles).sum();
    let coupling = if are_coupled { BYTES_OF_COUPLING } else { 0.0 };
    BYTES_OF_A_RUN + grains * (BYTES_PER_GRAIN + coupling) + felt as f64 * BYTES_PER_TRIANGLE
}

/// Frames and rows of the series of a run when no condition ends a stage early, what they take, and the time of all of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Work {
    pub(super) frames: u64,
    /// Bytes of one frame.
    pub(super) frame_bytes: f64,
    pub(super) rows: u64,
    /// Bytes of one row.
    pub(super) row_bytes: f64,
    /// Seconds on one thread.
    pub(super) time: f64,
}

/// The work of a run of a scenario with so many grains at most, such walls and such steps.
pub(super) fn work(
    scenario: &Scenario,
    grains: f64,
    walls: &[Wall],
    are_coupled: bool,
    stage_steps: &[u64],
    dt: f64,
) -> Work {
    let speed = if are_coupled { COUPLED_SPEED } else { SPEED };
    let drawn: usize = walls
        .iter()
        .filter_map(Wall::mesh)
        .map(|mesh| mesh.triangles().len())
        .sum();
    let drawn = drawn as f64;
    let all = |interval: fn(&Stage) -> Option<f64>| {
        let stages = scenario.stages.iter().zip(stage_steps);
        // the last is at the end of its stage
        let of_stage =
            |(stage, steps): (&Stage, &u64)| interval(stage).map_or(1, |seconds: f64| ends_within(seconds, dt, *steps));
        stages.map(of_stage).fold(1, u64::saturating_add)
    };
    let frames = all(|stage| stage.cadence.frames);
    let rows = all(|stage| stage.cadence.series);
    let columns = labels(scenario).header().len() as f64;
    let steps = stage_steps.iter().copied().fold(0, u64::saturating_add);
    let per_frame = grains * FRAME_TIME_PER_GRAIN + drawn * FRAME_TIME_PER_TRIANGLE;
    Work {
        frames,
        frame_bytes: FRAME_BYTES + grains * FRAME_BYTES_PER_GRAIN + drawn * FRAME_BYTES_PER_TRIANGLE,
        rows,
        row_bytes: columns * VALUE_BYTES,
        time: grains * steps as f64 / speed + frames as f64 * per_frame + rows as f64 * columns * VALUE_TIME,
    }
}
