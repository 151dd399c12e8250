//! What `demeter check` tells of the walls: what is remarkable about every mesh, and where grains would get out.

use super::{Prepared, Scenario};
use crate::walls::leak::{LeakReport, LeakTest, Untested, find_openings};
use crate::walls::mesh::Inspection;

/// What was found about the walls of a scenario.
#[derive(Clone, Debug)]
pub struct WallReport {
    /// What is remarkable about each wall; `None` for walls that are no meshes.
    pub meshes: Vec<Option<Inspection>>,
    /// Where the smallest grain gets out, with the walls as they stand at the start.
    pub leaks: Result<LeakReport, Untested>,
    /// Radius of the smallest grain at the start or of a feed [m]; infinite without grains.
    pub smallest: f64,
}

/// Looks at the walls of a scenario that is ready to run. It may take seconds.
pub fn inspect_walls(scenario: &Scenario, prepared: &Prepared) -> WallReport {
    let setup = &prepared.setup;
    let all = [&setup.grains, &prepared.to_come];
    let starts: Vec<_> = all.iter().flat_map(|grains| grains.position.iter().copied()).collect();
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
