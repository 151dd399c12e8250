//! Closed meshes with grains around them, and tubes with grains inside: none comes where a wall is solid, and those that were put there are
//! told.

use super::in_vain::PLACES;
use crate::insertion::Streaming;
use crate::particles::{Grains, Interior};
use crate::simulation::Simulation;
use crate::walls::{Tubes, Wall};
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
}

/// What is solid where grains of a feed may come.
pub(super) struct InTheWay<'a> {
    walls: &'a [Wall],
    solids: Vec<&'a Solid>,
    tubes: Tubes<'a>,
}

impl<'a> InTheWay<'a> {
    /// A closed mesh that holds half of the inlet, or more, is the room that grains come into; a tube that holds nothing of it is beside
    /// that room.
    pub(super) fn of(source: &Streaming, solids: &'a [Solid], walls: &'a [Wall]) -> Self {
        let tubes = Tubes::among(walls);
        let places = match solids.is_empty() && tubes.is_empty() {
            true => Vec::new(),
            false => source.places(source.radii()[0], PLACES),
        };
        let held = |solid: &Solid| places.iter().filter(|place| solid.holds(walls, **place)).count();
        Self {
            walls,
            solids: solids.iter().filter(|solid| 2 * held(solid) < places.len()).collect(),
            tubes: tubes.that_hold_some(&places),
        }
    }

    /// Whether a grain with this centre would meet a wall, or be where something is solid.
    pub(super) fn meets(&self, place: DVec3, radius: f64) -> bool {
        self.walls.iter().any(|wall| wall.nearest(place, radius).is_some()) || self.holds(place)
    }

    fn holds(&self, place: DVec3) -> bool {
        self.solids.iter().any(|solid| solid.holds(self.walls, place)) || self.tubes.are_behind(place)
    }
}

/// Tells walls that are solid where grains lie at the start.
pub(super) fn check(grains: &Grains, walls: &[Wall], warnings: &mut Vec<String>) {
    let free: Vec<usize> = (0..grains.len()).filter(|&g| !grains.is_fixed(g)).collect();
    check_meshes(grains, &free, walls, warnings);
    let tubes = Tubes::among(walls);
    for tube in tubes.iter() {
        let places = free.iter().map(|&g| (grains.id[g], grains.position[g]));
        let behind: Vec<_> = places
            .filter(|&(_, place)| tube.beyond_side(place).is_some() && tubes.are_behind(place))
            .collect();
        warnings.extend(behind_side(&tube.name, &behind, free.len()));
    }
}

/// Tells closed meshes in which grains lie, and fewer than outside: no containers.
fn check_meshes(grains: &Grains, free: &[usize], walls: &[Wall], warnings: &mut Vec<String>) {
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

/// Grains behind the side of a tube in words.
fn behind_side(tube: &str, behind: &[(u32, DVec3)], all: usize) -> Option<String> {
    let (id, place) = behind.iter().min_by_key(|(id, _)| *id)?;
    Some(format!(
        "{} of {all} grains lie outside of wall `{tube}`, beside it, where it is solid: the run stops when one of them comes to its side. The \
         first is grain {id} at {place}. Move them into it, or give it `side = \"both\"`",
        behind.len()
    ))
}
