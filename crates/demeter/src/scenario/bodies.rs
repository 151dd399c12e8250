//! Walls that move as rigid bodies: what is wrong with them before the run.

use super::{Diagnostics, Scenario};
use crate::walls::{Wall, meeting};

/// Refuses bodies whose mass is not known from their shape, and those that touch other walls from the start; a step takes `dt` [s].
pub(super) fn check(scenario: &Scenario, walls: &[Wall], dt: f64, faults: &mut Diagnostics) {
    let mut told = std::collections::BTreeSet::new();
    for (stage, path) in scenario.stages.iter().zip(&scenario.stage_paths) {
        // repeats of a stage have one table
        if !told.insert(path) {
            continue;
        }
        for (index, motions) in &stage.motions {
            let Some(wall) = walls.get(*index) else { continue };
            if let Err(error) = wall.least_mass_with(motions, None) {
                let message = format!("wall `{}`: {error}", wall.name);
                faults.push(&format!("{path}.motion.{}", wall.name), message, None);
            }
        }
    }
    if let Some(meeting) = meeting(walls, dt) {
        let [body, wall] = [meeting.body, meeting.wall].map(|k| &walls[k].name);
        let [x, y, z] = meeting.place.to_array();
        faults.push(
            &format!("wall[{}].motion", meeting.body),
            format!(
                "wall `{body}` is a body and touches wall `{wall}` at ({x:.6}, {y:.6}, {z:.6}) m. A body feels grains, not walls, and would \
                 go through it"
            ),
            Some("let it start away from all other walls".to_string()),
        );
    }
}
