//! Walls that move as rigid bodies: what is wrong with them before the run.

use super::checks::told_motions;
use super::{Diagnostics, Scenario};
use crate::particles::Interior;
use crate::walls::{BodyMass, Motion, Wall, meeting};

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

/// Tells bodies of a density whose mass and moments count what parts of the mesh have in common for each part.
pub(super) fn check_parts(scenario: &Scenario, walls: &[Wall], warnings: &mut Vec<String>) {
    let mut told = std::collections::BTreeSet::new();
    for (index, motions) in told_motions(scenario) {
        let density = motions.parts.iter().find_map(|part| match &part.motion {
            Motion::Body(body) => match body.mass {
                BodyMass::Density(density) => Some(density),
                BodyMass::Told(_) => None,
            },
            _ => None,
        });
        let Some((wall, density)) = walls.get(index).zip(density) else {
            continue;
        };
        let Some(mesh) = wall.mesh().filter(|_| told.insert(index)) else {
            continue;
        };
        // what is not closed is refused elsewhere
        if let Ok(triangles) = mesh.closed_triangles()
            && let Ok(inside) = Interior::new(&triangles)
            && inside.parts_overlap()
        {
            warnings.push(format!(
                "wall `{}` has a mesh of parts that overlap: its mass and moments of inertia, which follow from `density`, count what they share \
                 for each part; all of it together would weigh about {:.2e} kg. Join the parts in the program that drew them, or tell `mass`, \
                 `center_of_mass` and `inertia`",
                wall.name,
                density * inside.volume()
            ));
        }
    }
}
