//! What `demeter check` tells of the walls: what is remarkable about every mesh, and where grains would get out.

use super::solids::{InTheWay, Solid};
use super::traffic::sources;
use super::{Prepared, Scenario};
use crate::insertion::Streaming;
use crate::walls::leak::{LeakReport, LeakTest, Untested, find_openings};
use crate::walls::mesh::Inspection;
use glam::DVec3;

/// Places where grains of a feed may come that the leak test starts from.
const PLACES_OF_A_FEED: u64 = 64;

/// What was found about the walls of a scenario.
#[derive(Clone, Debug)]
pub struct WallReport {
    /// What is remarkable about each wall; `None` for walls that are no meshes.
    pub meshes: Vec<Option<Inspection>>,
    /// Meshes that move against each other and pass through one another at the start: their indices, and where [m].
    pub meetings: Vec<([usize; 2], DVec3)>,
    /// Where the smallest grain gets out, with the walls as they stand at the start.
    pub leaks: Result<LeakReport, Untested>,
    /// Radius of the smallest grain at the start or of a feed [m]; infinite without grains.
    pub smallest: f64,
}

/// Looks at the walls of a scenario that is ready to run. It may take seconds.
pub fn inspect_walls(scenario: &Scenario, prepared: &Prepared) -> WallReport {
    let setup = &prepared.setup;
    let all = [&setup.grains, &prepared.to_come];
    let mut starts: Vec<_> = setup.grains.position.iter().copied().collect();
    starts.extend(places_of_feeds(scenario, prepared));
    let smallest = all
        .iter()
        .flat_map(|grains| grains.radii())
        .fold(f64::INFINITY, f64::min);
    let present: Vec<_> = setup.walls.iter().filter(|wall| wall.is_present()).cloned().collect();
    WallReport {
        meshes: setup
            .walls
            .iter()
            .map(|wall| wall.mesh().map(|m| m.inspect()))
            .collect(),
        meetings: meetings(scenario, prepared),
        leaks: find_openings(&LeakTest {
            walls: &present,
            starts: &starts,
            radius: smallest,
            gravity: scenario.simulation.gravity,
            domain: Some(&setup.domain),
        }),
        smallest,
    }
}

/// Where grains of feeds may come, as the walls stand at the start.
fn places_of_feeds(scenario: &Scenario, prepared: &Prepared) -> Vec<DVec3> {
    let walls = &prepared.setup.walls;
    let sources = sources(scenario, &prepared.setup.domain).unwrap_or_default();
    let solids = match sources.is_empty() {
        true => Vec::new(),
        false => Solid::all(walls),
    };
    let free_places = |source: &Streaming| {
        let radius = source.radii()[0];
        let in_the_way = InTheWay::of(source, &solids, walls);
        let mut places = source.places(radius, PLACES_OF_A_FEED);
        places.retain(|&place| !in_the_way.meets(place, radius));
        places
    };
    sources.iter().flat_map(free_places).collect()
}

fn meetings(scenario: &Scenario, prepared: &Prepared) -> Vec<([usize; 2], DVec3)> {
    let walls = &prepared.setup.walls;
    let boxes: Vec<_> = walls
        .iter()
        .map(|wall| wall.mesh().and_then(|_| wall.bounds()))
        .collect();
    // what is told holds until another motion is
    let told = |wall: usize, stages: usize| {
        let mut latest = scenario.stages[..stages].iter().rev().flat_map(|stage| &stage.motions);
        (latest.find(|(index, _)| *index == wall)).map_or(&scenario.walls[wall].motion, |(_, motions)| motions)
    };
    let motions = |wall: usize| -> Vec<_> {
        let body = |stages| told(wall, stages).leader().unwrap_or(wall);
        (0..=scenario.stages.len())
            .map(|stages| told(body(stages), stages))
            .collect()
    };
    let mut found = Vec::new();
    for (a, first) in boxes.iter().enumerate() {
        let Some((lower, upper)) = first else { continue };
        for (b, second) in boxes.iter().enumerate().skip(a + 1) {
            let is_near = second.is_some_and(|(l, u)| lower.cmple(u).all() && l.cmple(*upper).all());
            if is_near
                && motions(a) != motions(b)
                && let Some(place) = walls[a].meets(&walls[b])
            {
                found.push(([a, b], place));
            }
        }
    }
    found
}
