//! Closed meshes with grains around them: none comes inside of one, and none that was put there comes out.

use super::in_vain::PLACES;
use crate::insertion::Streaming;
use crate::particles::{Grains, Interior};
use crate::simulation::Simulation;
use crate::walls::Wall;
use glam::DVec3;

/// The inside of a closed mesh, where the mesh stands at the start.
#[derive(Clone, Debug)]
pub(super) struct Solid {
    wall: usize,
    interior: Interior,
}

impl Solid {
    fn of(wall: usize, built: &Wall) -> Option<Self> {
        // what is open has no inside
        let interior = Interior::new(&built.mesh()?.closed_triangles().ok()?).ok()?;
        Some(Self { wall, interior })
    }

    /// Those among walls.
    pub(super) fn all(walls: &[Wall]) -> Vec<Self> {
        let numbered = walls.iter().enumerate();
        numbered.filter_map(|(k, wall)| Self::of(k, wall)).collect()
    }

    /// Whether a place lies inside of the wall as it stands now.
    pub(super) fn holds(&self, walls: &[Wall], place: DVec3) -> bool {
        let holds = |wall: &Wall| wall.is_present() && self.interior.contains(wall.brought_back(place));
        walls.get(self.wall).is_some_and(holds)
    }

    /// Those that stand in the way of an inlet; one that holds half of it, or more, is the room that grains come into.
    pub(super) fn in_the_way<'s>(solids: &'s [Self], walls: &[Wall], source: &Streaming) -> Vec<&'s Self> {
        if solids.is_empty() {
            return Vec::new();
        }
        let places = source.places(source.radii()[0], PLACES);
        let held = |solid: &Self| places.iter().filter(|place| solid.holds(walls, **place)).count();
        solids.iter().filter(|solid| 2 * held(solid) < places.len()).collect()
    }
}

/// Tells closed meshes in which grains lie at the start, and fewer than outside: no containers.
pub(super) fn check(grains: &Grains, walls: &[Wall], warnings: &mut Vec<String>) {
    let free: Vec<usize> = (0..grains.len()).filter(|&g| !grains.is_fixed(g)).collect();
    for (k, wall) in walls.iter().enumerate() {
        let Some((lower, upper)) = wall.bounds().filter(|_| wall.is_present()) else {
            continue;
        };
        let may_hold = |g: &&usize| {
            let place = grains.position[**g];
            place.cmpge(lower).all() && place.cmple(upper).all()
        };
        // most walls have no grain within their bounds, and their inside need not be found
        let near: Vec<usize> = free.iter().filter(may_hold).copied().collect();
        let Some(solid) = Solid::of(k, wall).filter(|_| !near.is_empty()) else {
            continue;
        };
        let inside: Vec<(u32, DVec3)> = (near.into_iter())
            .filter(|&g| solid.holds(walls, grains.position[g]))
            .map(|g| (grains.id[g], grains.position[g]))
            .collect();
        warnings.extend(enclosed(&wall.name, &inside, free.len()));
    }
}

/// What to tell of a wall that has come back to where grains are. Each process looks at its own.
pub(super) fn enclosed_by(sim: &Simulation, wall: usize) -> Option<String> {
    let solid = Solid::of(wall, &sim.walls[wall])?;
    let (grains, walls) = (&sim.grains, &sim.walls);
    let is_free = |g: &usize| !grains.is_fixed(*g);
    let here = sim.own_grains().filter(is_free);
    let here = here.filter(|&g| solid.holds(walls, grains.position[g]));
    let inside = sim.of_all_segments(here.map(|g| (grains.id[g], grains.position[g])).collect());
    enclosed(&walls[wall].name, &inside, grains.len())
}

/// Grains inside of a wall in words, told their ids and places and how many grains there are.
fn enclosed(wall: &str, inside: &[(u32, DVec3)], all: usize) -> Option<String> {
    let (id, place) = inside.iter().min_by_key(|(id, _)| *id)?;
    (2 * inside.len() <= all).then(|| {
        format!(
            "{} of {all} grains lie inside of wall `{wall}`, a closed mesh, and the others outside: they cannot come out. The first is grain \
             {id} at {place}",
            inside.len()
        )
    })
}
