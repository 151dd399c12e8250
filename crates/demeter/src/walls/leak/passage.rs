//! Narrow passages: places where coarse cells cannot tell whether a grain passes, looked at one by one with finer cells.

use super::cells::{Beyond, Cells, State};
use super::narrow::Narrowest;
use super::paths::Ways;
use super::search::{Goal, Search};
use super::{freely_reached, is_open, narrow_on};
use glam::DVec3;

/// Half of the diagonal of the smallest cells, in radii: the width of a passage is told to twice that.
const FINEST: f64 = 0.01;
/// Most cells of one passage.
const MOST_CELLS: usize = 300_000;
/// A passage with more cells than that is cut in two as long as it is longer, in radii.
const LEAST_LENGTH: f64 = 6.0;
/// Most passages that are looked at in one round.
const MOST_PASSAGES: usize = 200;
/// Way in mixed cells that is looked at beside the shortest, as a share of the shortest.
const BESIDE: f64 = 0.3;

/// What became of a passage.
pub(super) enum Verdict {
    /// No grain passes.
    Closed,
    /// A grain passes.
    Open(Narrowest),
    /// It is as wide as the grain, or too intricate.
    Undecided(Narrowest),
}

/// A passage: cells that are mixed, and whether a grain passes.
pub(super) struct Passage {
    pub(super) cells: Vec<u32>,
    pub(super) verdict: Verdict,
}

/// Ways in mixed cells between what is surely reached from the starts and what is surely connected with the goal.
struct Between {
    there: Ways,
    back: Ways,
    /// The shortest [m]; infinite when there is none.
    least: f64,
}

impl Between {
    /// Ways from the starts end where they meet what is connected with the goal, and the other way round: so a cell far
    /// from the passage is not taken for a detour through it.
    fn new(search: &Search<'_>, surely: &[bool], from_goal: &[bool]) -> Self {
        let cells = &search.cells;
        let ways = |starts: Vec<u32>, marks: &[bool], forbidden: &[bool]| {
            let marked = cells.whole().filter(|&cell| marks[cell as usize]);
            let starts: Vec<u32> = starts.into_iter().chain(marked).collect();
            let step = |so_far: f64, cell: u32| {
                let allowed = is_open(cells, cell) && !forbidden[cell as usize];
                allowed.then(|| so_far.max(0.0) + mixed_way(cells, cell))
            };
            Ways::new(cells, &starts, step, |_| false)
        };
        let there = ways(search.start_cells(), surely, from_goal);
        let back = ways(search.goal_cells(), from_goal, surely);
        let between = Between {
            there,
            back,
            least: f64::INFINITY,
        };
        let through = cells.whole().map(|cell| between.through(cells, cell));
        Between {
            least: through.fold(f64::INFINITY, f64::min),
            ..between
        }
    }

    /// Way in mixed cells from the starts to the goal through a cell [m].
    fn through(&self, cells: &Cells, cell: u32) -> f64 {
        self.there.cost[cell as usize] + self.back.cost[cell as usize] - mixed_way(cells, cell)
    }

    /// Mixed cells on ways that have not much more of them than the shortest.
    fn on_short_ways(&self, cells: &Cells) -> Vec<u32> {
        let most = self.least * (1.0 + BESIDE);
        let is_near = |&cell: &u32| cells.get(cell).state == State::Mixed && self.through(cells, cell) <= most;
        cells.whole().filter(is_near).collect()
    }
}

fn mixed_way(cells: &Cells, cell: u32) -> f64 {
    match cells.get(cell).state {
        State::Mixed => cells.side(cell),
        State::Free | State::Blocked => 0.0,
    }
}

/// All passages that are not much longer than the shortest.
pub(super) fn passages(search: &Search<'_>, surely: &[bool]) -> Vec<Passage> {
    let from_goal = freely_reached(&search.cells, &free(search, &search.goal_cells()));
    let between = Between::new(search, surely, &from_goal);
    if between.least == f64::INFINITY {
        return Vec::new();
    }
    let near = between.on_short_ways(&search.cells);
    let mut groups = connected(&search.cells, &near);
    groups.reverse();
    let mut passages = Vec::new();
    while let Some(group) = groups.pop().filter(|_| passages.len() < MOST_PASSAGES) {
        let halves = halves(search, &group);
        match (decide(search, &group, surely, &from_goal), halves) {
            (Decision::TooMany(_), Some(halves)) => groups.extend(halves),
            (Decision::TooMany(verdict) | Decision::Made(verdict), _) => {
                passages.push(Passage { cells: group, verdict })
            }
        }
    }
    passages
}

/// What looking at a passage gave.
enum Decision {
    Made(Verdict),
    /// More cells would be needed than are allowed; the verdict is that of those that are.
    TooMany(Verdict),
}

/// Both halves of a passage along the axis of its longest extent; of a short one none.
fn halves(search: &Search<'_>, group: &[u32]) -> Option<[Vec<u32>; 2]> {
    let centers = || group.iter().map(|&cell| search.cells.center(cell));
    let (lower, upper) = (centers().reduce(DVec3::min)?, centers().reduce(DVec3::max)?);
    let extent = upper - lower;
    let (axis, length) = (extent.max_position(), extent.max_element());
    let middle = 0.5 * (lower + upper)[axis];
    let parts = group
        .iter()
        .partition(|&&cell| search.cells.center(cell)[axis] < middle);
    (length > LEAST_LENGTH * search.space.radius)
        .then_some(parts)
        .map(<[Vec<u32>; 2]>::from)
}

fn free(search: &Search<'_>, some: &[u32]) -> Vec<u32> {
    let is_free = |cell: &u32| search.cells.get(*cell).state == State::Free;
    some.iter().copied().filter(is_free).collect()
}

/// Groups of cells that touch.
fn connected(cells: &Cells, some: &[u32]) -> Vec<Vec<u32>> {
    let mut is_left = vec![false; cells.len()];
    some.iter().for_each(|&cell| is_left[cell as usize] = true);
    let mut groups = Vec::new();
    for &start in some {
        if !is_left[start as usize] {
            continue;
        }
        is_left[start as usize] = false;
        let mut group = vec![start];
        let mut next = 0;
        while let Some(&cell) = group.get(next) {
            next += 1;
            cells.neighbours(cell, |beyond| {
                if let Beyond::Cell(other) = beyond
                    && is_left[other as usize]
                {
                    is_left[other as usize] = false;
                    group.push(other);
                }
            });
        }
        groups.push(group);
    }
    groups
}

/// Looks at the surroundings of some cells with finer ones.
fn decide(outer: &Search<'_>, group: &[u32], surely: &[bool], from_goal: &[bool]) -> Decision {
    let radius = outer.space.radius;
    let around = |cell: u32| {
        let reach = DVec3::splat(0.5 * outer.cells.side(cell));
        (outer.cells.center(cell) - reach, outer.cells.center(cell) + reach)
    };
    let (mut lower, mut upper) = (DVec3::MAX, DVec3::MIN);
    for &cell in group {
        let (l, u) = around(cell);
        (lower, upper) = (lower.min(l), upper.max(u));
    }
    (lower, upper) = (lower - radius, upper + radius);
    // a point of every free cell of the outer search that reaches into the box
    let inset = DVec3::splat(1e-6 * radius);
    let points = |marks: &[bool]| -> Vec<DVec3> {
        let inner = outer.cells.whole().filter(|&cell| marks[cell as usize]);
        free(outer, &inner.collect::<Vec<u32>>())
            .into_iter()
            .filter(|&cell| {
                let (l, u) = around(cell);
                l.cmplt(upper - inset).all() && u.cmpgt(lower + inset).all()
            })
            .map(|cell| outer.cells.center(cell).clamp(lower + inset, upper - inset))
            .collect()
    };
    // a grain in a mixed cell is not where that is blocked, as its middle may be
    let is_within = |start: &DVec3| start.cmpgt(lower).all() && start.cmplt(upper).all();
    let starts = outer.starts.iter().copied().filter(is_within);
    let mut search = Search {
        space: outer.space.again(),
        cells: Cells::new(&outer.space, lower, upper, [false; 3], 0.25 * radius),
        starts: points(surely).into_iter().chain(starts).collect(),
        goal: Goal::Points(points(from_goal)),
    };
    decide_closely(&mut search)
}

fn decide_closely(search: &mut Search<'_>) -> Decision {
    let finest = FINEST * search.space.radius;
    loop {
        let starts = search.start_cells();
        // a cell that is small enough to hold one side of a wall only, or free
        let is_sure = |cell: &u32| {
            let told = search.cells.get(*cell);
            told.state == State::Free || search.cells.half_diagonal(told.level) < 0.6 * search.space.radius
        };
        let sure: Vec<u32> = starts.iter().copied().filter(is_sure).collect();
        let reached = freely_reached(&search.cells, &sure);
        let goal = search.goal_cells();
        if goal.iter().any(|&cell| reached[cell as usize]) {
            return Decision::Made(narrowest_way(search, &starts).map_or(Verdict::Closed, Verdict::Open));
        }
        let from_goal = freely_reached(&search.cells, &free(search, &goal));
        let between = Between::new(search, &reached, &from_goal);
        if between.least == f64::INFINITY {
            return Decision::Made(Verdict::Closed);
        }
        let cells = &search.cells;
        let mut near = between.on_short_ways(cells);
        near.retain(|&cell| cells.half_diagonal(cells.get(cell).level) > finest);
        let undecided = || narrowest_way(search, &starts).map_or(Verdict::Closed, Verdict::Undecided);
        if near.is_empty() {
            return Decision::Made(undecided());
        }
        if cells.len() + 8 * near.len() > MOST_CELLS {
            return Decision::TooMany(undecided());
        }
        near.iter().for_each(|&cell| search.cells.halve(cell, &search.space));
    }
}

/// The narrowest place of the widest way. It begins and ends anywhere in the box, so that its ends are not narrower.
fn narrowest_way(search: &Search<'_>, starts: &[u32]) -> Option<Narrowest> {
    let cells = &search.cells;
    let goal = search.goal_marks();
    let widen = |so_far: f64, cell: u32| is_open(cells, cell).then(|| so_far.max(-cells.get(cell).clearance));
    let path = Ways::new(cells, starts, widen, |cell| goal[cell as usize]).path();
    narrow_on(search, &path)
}
