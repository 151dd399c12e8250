//! A way from somewhere to somewhere, decided by halving cells.

use super::cells::{Cells, State};
use super::paths::flood;
use super::space::Space;
use super::{freely_reached, is_open};
use glam::DVec3;

/// Room that a grain which touches a wall is given, in radii.
const NUDGES: [f64; 2] = [0.25, 0.5];
/// How far below the cap grains start that are above it, in radii.
const BELOW_CAP: f64 = 0.5;
/// Least room to spare where a grain comes to rest, in radii: between two such places twice as far apart a grain has room, too.
const SPARE: f64 = 0.02;
/// Most steps of a fall.
const MOST_FALLS: usize = 10_000;
/// Room in which the cell that holds a start is free, in radii: one, and twice half of the diagonal of the cells that tell
/// the sides of a wall apart.
const ROOMY: f64 = 2.3;
/// Most steps to such a place.
const MOST_RISES: usize = 40;
/// Share of a step that the room grows by in a direction good enough to go on in.
const STEEP: f64 = 0.7;

/// Where a way may end.
pub(super) enum Goal {
    /// At the ends of the box.
    Ends,
    /// Above a height.
    Above(f64),
    /// At some points.
    Points(Vec<DVec3>),
}

/// What coarse cells tell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Coarse {
    /// There is no way.
    Closed,
    /// There may be one.
    Open,
    /// More cells are needed than allowed.
    TooMany,
}

pub(super) struct Search<'a> {
    pub(super) space: Space<'a>,
    pub(super) cells: Cells,
    pub(super) starts: Vec<DVec3>,
    pub(super) goal: Goal,
}

impl Search<'_> {
    /// Cells of the starts that are not blocked, each once.
    pub(super) fn start_cells(&self) -> Vec<u32> {
        let mut found: Vec<u32> = (self.starts.iter())
            .filter_map(|&start| self.cells.holding(start))
            .filter(|&cell| is_open(&self.cells, cell))
            .collect();
        found.sort_unstable();
        found.dedup();
        found
    }

    /// Cells of the goal that are not blocked, each once.
    pub(super) fn goal_cells(&self) -> Vec<u32> {
        let cells = &self.cells;
        let mut found: Vec<u32> = match &self.goal {
            Goal::Ends => cells.whole().filter(|&cell| cells.is_at_end(cell)).collect(),
            Goal::Above(height) => cells
                .whole()
                .filter(|&cell| cells.heights(cell, &self.space).1 >= *height)
                .collect(),
            Goal::Points(points) => points.iter().filter_map(|&point| cells.holding(point)).collect(),
        };
        found.retain(|&cell| is_open(cells, cell));
        found.sort_unstable();
        found.dedup();
        found
    }

    pub(super) fn goal_marks(&self) -> Vec<bool> {
        let mut marks = vec![false; self.cells.len()];
        for cell in self.goal_cells() {
            marks[cell as usize] = true;
        }
        marks
    }

    /// Halves mixed cells that can be reached until none is larger than told (half of its diagonal) [m].
    pub(super) fn coarse(&mut self, half_diagonal: f64, most_cells: usize) -> Coarse {
        loop {
            let cells = &self.cells;
            let reached = flood(cells, &self.start_cells(), |cell| is_open(cells, cell));
            if !self.goal_cells().iter().any(|&cell| reached[cell as usize]) {
                return Coarse::Closed;
            }
            let is_large = |cell: &u32| {
                let told = cells.get(*cell);
                reached[*cell as usize] && told.state == State::Mixed && cells.half_diagonal(told.level) > half_diagonal
            };
            let large: Vec<u32> = cells.whole().filter(is_large).collect();
            if large.is_empty() {
                return Coarse::Open;
            }
            if cells.len() + 8 * large.len() > most_cells {
                return Coarse::TooMany;
            }
            large.iter().for_each(|&cell| self.cells.halve(cell, &self.space));
        }
    }

    /// Marks the cells to which a grain surely gets from a start. The cell of a start counts even if it is mixed: a grain
    /// is there, and the cell is too small to hold both sides of a wall.
    pub(super) fn surely_reached(&self) -> Vec<bool> {
        freely_reached(&self.cells, &self.start_cells())
    }
}

/// Where a grain from a start comes to rest, and from there uphill to where it has room about it, so that its cell is free where it can be.
pub(super) fn settled(space: &Space<'_>, start: DVec3, ends: (DVec3, DVec3)) -> Option<DVec3> {
    fallen(space, start, ends).map(|rest| risen(space, rest))
}

/// Where a grain from a start comes to rest when it falls straight down: what is above the cap starts there, what touches a wall is given
/// some room, and what would fall out stays where it starts. `None` when there is no room.
fn fallen(space: &Space<'_>, start: DVec3, (lower, upper): (DVec3, DVec3)) -> Option<DVec3> {
    let above = if space.cap == f64::INFINITY {
        0.0
    } else {
        (space.height(start) - space.cap + BELOW_CAP * space.radius).max(0.0)
    };
    let first = with_room(space, start - space.up * above)?;
    let mut at = first;
    if space.up == DVec3::ZERO {
        return Some(at);
    }
    for _ in 0..MOST_FALLS {
        let inside = |next: &DVec3| next.cmpgt(lower).all() && next.cmplt(upper).all();
        let spare = (space.clearance(at) - space.radius).max(SPARE * space.radius);
        // near the end of the box in short steps
        let falls = [spare, spare.min(0.25 * space.radius)].map(|fall| at - space.up * fall);
        match falls.into_iter().find(inside) {
            Some(next) if has_room(space, next) => at = next,
            Some(_) => break,
            None => return Some(first),
        }
    }
    Some(at)
}

fn has_room(space: &Space<'_>, at: DVec3) -> bool {
    space.clearance(at) >= (1.0 + SPARE) * space.radius
}

/// Steps from where a grain has little room to where it has more, each where it has room all the way.
fn risen(space: &Space<'_>, mut at: DVec3) -> DVec3 {
    let room = |place: DVec3| space.below_cap(space.clearance(place), place) - space.radius;
    let (mut spare, mut direction) = (room(at), space.up);
    for _ in 0..MOST_RISES {
        if spare >= (ROOMY - 1.0) * space.radius || spare < SPARE * space.radius {
            break;
        }
        let step = spare.max(2.0 * SPARE * space.radius);
        let mut found = room(at + direction * step);
        if found < spare + STEEP * step {
            let rated = directions().map(|direction| (room(at + direction * step), direction));
            (found, direction) = rated.fold(
                (found, direction),
                |best, next| if next.0 > best.0 { next } else { best },
            );
        }
        if found <= spare {
            break;
        }
        (at, spare) = (at + direction * step, found);
    }
    space.put_back(at)
}

/// Unit vectors along the axes and between them.
fn directions() -> impl Iterator<Item = DVec3> {
    (0..27).filter(|&k| k != 13).map(|k| {
        let part = |digit: i32| f64::from(digit % 3 - 1);
        DVec3::new(part(k), part(k / 3), part(k / 9)).normalize()
    })
}

/// The point, or one near it where the grain touches nothing.
fn with_room(space: &Space<'_>, point: DVec3) -> Option<DVec3> {
    if has_room(space, point) {
        return Some(point);
    }
    let nudged = directions().flat_map(|direction| NUDGES.map(|share| point + direction * (share * space.radius)));
    let clearance = |at: &DVec3| space.clearance(*at);
    let best = nudged.max_by(|a, b| clearance(a).total_cmp(&clearance(b)));
    best.filter(|&at| has_room(space, at) && clearance(&point) > 0.0)
}
