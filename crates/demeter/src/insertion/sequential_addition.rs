//! Random sequential addition: grains are put one after the other, the largest first, each at the first random place
//! where it overlaps nothing (Widom 1966, doi:10.1063/1.1726548). Equal grains jam at a fraction of 0.38.

use super::place_grid::PlaceGrid;
use super::random::RandomNumbers;
use super::region::Space;
use glam::DVec3;
use std::ops::ControlFlow;

/// Places tried for one grain before giving up.
const TRIES: u32 = 20_000;

/// Places the grains with these radii; `None` when a grain found no place.
pub(super) fn add_sequentially(
    space: &Space,
    radii: &[f64],
    occupied: &[(DVec3, f64)],
    random: &mut RandomNumbers,
) -> Option<Vec<DVec3>> {
    let (lower, upper) = space.bounds();
    let all = radii.iter().copied().chain(occupied.iter().map(|o| o.1));
    let mut grid = PlaceGrid::new(space.domain(), lower, upper, all);
    for (place, radius) in occupied {
        grid.add(*place, *radius);
    }
    let mut order: Vec<usize> = (0..radii.len()).collect();
    // Stable, so that equal grains keep their order.
    order.sort_by(|a, b| radii[*b].total_cmp(&radii[*a]));
    let mut places = vec![DVec3::ZERO; radii.len()];
    for index in order {
        let radius = radii[index];
        let place = (0..TRIES)
            .map(|_| space.random_place(radius, random))
            .find(|place| space.holds(*place, radius) && is_free(&grid, *place, radius))?;
        grid.add(place, radius);
        places[index] = place;
    }
    Some(places)
}

fn is_free(grid: &PlaceGrid, place: DVec3, radius: f64) -> bool {
    let blocked = grid.visit(place, radius, |near| {
        let sum = (radius + near.radius) * (1.0 + super::overlap_relaxation::CLEARANCE);
        match near.difference.length_squared() < sum * sum {
            true => ControlFlow::Break(()),
            false => ControlFlow::Continue(()),
        }
    });
    blocked.is_none()
}
