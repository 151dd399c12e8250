//! Where a grain would get out of the container that all walls make together.
//!
//! The centre of a grain may be where the clearance, the distance to the nearest wall, is no less than its radius. Cells
//! of the space (`cells`) are free, blocked or mixed, with proof; the mixed ones are halved until the question is decided:
//!
//! * no way from the grains to the outside through free and mixed cells: the container is tight;
//! * a way through free cells alone: a grain gets out, and the narrowest place of the widest way (`narrow`) is told;
//! * a way that needs mixed cells: its mixed part is looked at alone, more closely (`passage`), until it is one or the
//!   other, or its width is that of the grain to a hundredth.
//!
//! What was found is plugged, and the search goes on. Outside is beyond the box around the walls; above their highest
//! point nothing is looked for: a container may be open at the top. Where a lower rim is left upwards, the search goes on
//! below that rim. Where all grains lie on the highest point, as on a plate, a layer above them is looked at, and where they
//! get down from it. Walls stand as at the start of the run, and grains are hard.

mod cells;
mod narrow;
mod obstacles;
mod passage;
mod paths;
mod search;
mod space;

use super::Wall;
use crate::particles::Domain;
use cells::{Cells, State};
use glam::DVec3;
use narrow::{Narrowest, narrowest, narrowest_along};
use passage::{Verdict, passages};
use paths::{Ways, flood};
use search::{Coarse, Goal, Search};
use space::{Plug, Space};
use thiserror::Error;

/// Most openings that are told.
const MOST_OPENINGS: usize = 6;
/// Most rounds of finding and plugging.
const MOST_ROUNDS: usize = 24;
/// Most cells.
const MOST_CELLS: usize = 4_000_000;
/// Cells per area of the walls over the square of the radius that are surely needed; 4.5 layers of cells of 0.72 radii on
/// every wall would be 8.7.
const CELLS_PER_AREA: f64 = 6.0;
/// Side of the cells that tell the two sides of a wall apart, in radii: two neighbours on different sides cannot both be
/// mixed when the side is less than twice what the radius exceeds half of the diagonal by, 0.732.
const APART: f64 = 0.72;
/// Free space around the walls, in radii.
const MARGIN: f64 = 3.0;
/// How high above grains that lie on the highest wall is looked, in radii; less than `MARGIN` and two radii.
const ABOVE_GRAINS: f64 = 3.0;
/// How far a plug goes at most, in clearances of the opening: the corners of a triangle are that far from the middle.
const PLUG: f64 = 4.0;
/// What passes a grain is at least this share of its size; the rest is rounding.
const SURELY: f64 = 1.0 - 1e-6;
/// Cosine of the angle between two openings that may be parts of one.
const IN_ONE_PLANE: f64 = 0.9;
/// Most starting points.
const MOST_STARTS: usize = 4000;

/// What is asked.
#[derive(Clone, Copy, Debug)]
pub struct LeakTest<'a> {
    /// All walls, where they stand.
    pub walls: &'a [Wall],
    /// Where grains are, or are inserted [m].
    pub starts: &'a [DVec3],
    /// Radius of the smallest grain [m].
    pub radius: f64,
    /// Gravity [m/s^2]; zero when there is none.
    pub gravity: DVec3,
    /// The domain, when it is periodic.
    pub domain: Option<&'a Domain>,
}

/// How a grain gets out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OpeningKind {
    /// Through an opening wider than the grain.
    Leak,
    /// Through an opening as wide as the grain, to a hundredth of its radius, or one too intricate to tell.
    AboutGrainSize,
    /// Upwards over a rim.
    OverRim,
}

/// A place where a grain gets out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Opening {
    /// How.
    pub kind: OpeningKind,
    /// The narrowest place on the way out; for a rim, where the grain passes over it [m].
    pub place: DVec3,
    /// Diameter of the largest grain that passes, where the walls alone decide; for a rim 0 [m].
    pub width: f64,
}

/// What was found.
#[derive(Clone, Debug, PartialEq)]
pub struct LeakReport {
    /// Radius of the grain that was tried [m]: larger than the smallest when the walls are too large for it.
    pub radius: f64,
    /// Where it gets out, the widest first.
    pub openings: Vec<Opening>,
    /// Whether the search ended before all openings were found.
    pub more: bool,
    /// Whether the container is open at the top.
    pub open_at_top: bool,
}

impl LeakReport {
    /// Whether no grain gets out but upwards.
    pub fn is_tight(&self) -> bool {
        !self.more && self.openings.iter().all(|o| o.kind == OpeningKind::OverRim)
    }
}

/// Why the test could not be made.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum Untested {
    /// There is no wall.
    #[error("there is no wall")]
    NoWall,
    /// No grain is there at the start.
    #[error("no grain is there at the start, so there is no inside")]
    NoStart,
    /// Every grain at the start touches a wall on all sides.
    #[error("no grain has room to move at the start, so there is no way out to look for")]
    NoRoom,
    /// No grain is between the walls, nor falls between them.
    #[error(
        "no grain starts between the walls or above them: they reach from {lower} to {upper} m, and the first grain is at {start} m. \
         Is the place of the walls (`shift`, `unit`, `scale` of a mesh) right, and that of the grains?"
    )]
    Beside {
        /// Lower corner of the box around the walls [m].
        lower: DVec3,
        /// Upper corner [m].
        upper: DVec3,
        /// Where the first grain is [m].
        start: DVec3,
    },
    /// Walls that reach too far for their grains.
    #[error("the walls are too large against the grains")]
    TooLarge,
}

/// Looks for ways out of the container.
pub fn find_openings(test: &LeakTest<'_>) -> Result<LeakReport, Untested> {
    if test.walls.is_empty() {
        return Err(Untested::NoWall);
    }
    if test.starts.is_empty() {
        return Err(Untested::NoStart);
    }
    check_place(test)?;
    let area = Space::new(test.walls, test.radius, test.gravity).area;
    let mut radius = test.radius.max((CELLS_PER_AREA * area / MOST_CELLS as f64).sqrt());
    for attempt in 0..6u8 {
        match Hunt::new(test, radius).and_then(Hunt::run) {
            // it is the larger grain that has no room
            Err(Untested::NoRoom) if radius > test.radius => return Err(Untested::TooLarge),
            Err(Untested::TooLarge) => radius *= 1.25 + 0.25 * f64::from(attempt),
            decided => return decided,
        }
    }
    Err(Untested::TooLarge)
}

/// Refuses grains all of which are beside the box around the walls, and do not fall into it either.
fn check_place(test: &LeakTest<'_>) -> Result<(), Untested> {
    let mut boxes = Vec::with_capacity(test.walls.len());
    for wall in test.walls {
        // what goes on for ever has no beside
        let Some(bounds) = wall.bounds() else { return Ok(()) };
        boxes.push(bounds);
    }
    let mut around = boxes.into_iter();
    let Some(first) = around.next() else { return Ok(()) };
    let (lower, upper) = around.fold(first, |(l, u), (low, high)| (l.min(low), u.max(high)));
    let reach = DVec3::splat(test.radius);
    let down = test.gravity.normalize_or_zero();
    let periodic = test.domain.map_or([false; 3], |domain| domain.periodic);
    let meets = |start: &DVec3| {
        let (mut enters, mut leaves) = (0.0f64, f64::INFINITY);
        for k in (0..3).filter(|&k| !periodic[k]) {
            let [near, far] = [lower[k] - reach[k] - start[k], upper[k] + reach[k] - start[k]];
            if down[k] == 0.0 {
                if near > 0.0 || far < 0.0 {
                    return false;
                }
                continue;
            }
            let [a, b] = [near / down[k], far / down[k]];
            (enters, leaves) = (enters.max(a.min(b)), leaves.min(a.max(b)));
        }
        enters <= leaves
    };
    if test.starts.iter().any(meets) {
        return Ok(());
    }
    Err(Untested::Beside {
        lower,
        upper,
        start: test.starts[0],
    })
}

/// The search for all openings.
struct Hunt<'a> {
    search: Search<'a>,
    /// Where grains are; the search starts from where they come to rest [m].
    places: Vec<DVec3>,
    ends: (DVec3, DVec3),
    bounds: (DVec3, DVec3),
    /// Height of the highest point of the walls [m].
    top: Option<f64>,
    /// Whether all grains lie on that point, so that no rim keeps them.
    lie_on_top: bool,
    /// Unit vectors across the openings that were told.
    across: Vec<DVec3>,
    /// From a place to its images [m].
    images: Vec<DVec3>,
    report: LeakReport,
}

/// What one round gave.
enum Round {
    /// An opening, or a place that was none.
    Found,
    /// There is no way out.
    Closed,
    /// There is one that could not be followed.
    Lost,
}

impl<'a> Hunt<'a> {
    fn new(test: &LeakTest<'a>, radius: f64) -> Result<Self, Untested> {
        let mut space = Space::new(test.walls, radius, test.gravity);
        let top = space.top();
        space.cap = top.unwrap_or(f64::INFINITY);
        let some: Vec<DVec3> = {
            let every = test.starts.len().div_ceil(MOST_STARTS);
            test.starts.iter().copied().step_by(every).collect()
        };
        let (lower, upper) = space.bounds(&some).ok_or(Untested::NoWall)?;
        let margin = DVec3::splat(MARGIN * radius);
        let (mut from, mut to) = (lower - margin, upper + margin);
        let mut periodic = [false; 3];
        if let Some(domain) = test.domain {
            periodic = domain.periodic;
            for k in (0..3).filter(|&k| periodic[k]) {
                (from[k], to[k]) = (domain.lower[k], domain.upper[k]);
                space.periodic.push((k, from[k], to[k]));
            }
        }
        if space.is_endless() && top.is_some() {
            // level ground has no ends
            (0..3).for_each(|k| periodic[k] |= space.up[k] == 0.0);
        }
        let mut starts = settle(&space, &some, (from, to));
        let lie_on_top = starts.is_empty();
        if lie_on_top {
            space.cap = f64::INFINITY;
            let rest = settle(&space, &some, (from, to));
            let heights = rest.iter().map(|&place| space.height(place));
            let highest = heights.reduce(f64::max).ok_or(Untested::NoRoom)?;
            if top.is_some() {
                space.cap = highest + ABOVE_GRAINS * radius;
            }
            starts = rest;
        }
        let cells = Cells::new(&space, from, to, periodic, APART * radius);
        Ok(Hunt {
            search: Search {
                space,
                cells,
                starts,
                goal: Goal::Ends,
            },
            across: Vec::new(),
            images: images(from, to, periodic),
            places: some,
            ends: (from, to),
            bounds: (lower, upper),
            top,
            lie_on_top,
            report: LeakReport {
                radius,
                openings: Vec::new(),
                more: true,
                open_at_top: false,
            },
        })
    }

    fn run(mut self) -> Result<LeakReport, Untested> {
        for _ in 0..MOST_ROUNDS {
            if self.told() > MOST_OPENINGS {
                break;
            }
            match self.round()? {
                Round::Found => self.renew(),
                Round::Lost => break,
                Round::Closed => {
                    self.report.more = false;
                    break;
                }
            }
        }
        self.report.open_at_top |= self.is_open_at_top()?;
        let openings = &mut self.report.openings;
        openings.sort_by(|a, b| b.width.total_cmp(&a.width));
        self.report.more |= openings.len() > MOST_OPENINGS;
        openings.truncate(MOST_OPENINGS);
        Ok(self.report)
    }

    /// Looks at everything anew after plugs were added or the cap was changed.
    fn renew(&mut self) {
        self.search.cells.renew(&self.search.space);
        self.search.starts = settle(&self.search.space, &self.places, self.ends);
    }

    fn told(&self) -> usize {
        self.report.openings.len()
    }

    fn round(&mut self) -> Result<Round, Untested> {
        let coarsest = 0.5 * 3f64.sqrt() * APART * 1.02 * self.search.space.radius;
        match self.search.coarse(coarsest, MOST_CELLS) {
            Coarse::Closed => return Ok(Round::Closed),
            Coarse::TooMany => return Err(Untested::TooLarge),
            Coarse::Open => {}
        }
        let surely = self.search.surely_reached();
        let goal = self.search.goal_cells();
        if goal.iter().any(|&cell| surely[cell as usize]) {
            return Ok(self.wide_opening(&surely).map_or(Round::Lost, |()| Round::Found));
        }
        let mut found = false;
        for passage in passages(&self.search, &surely) {
            match passage.verdict {
                Verdict::Closed => passage.cells.iter().for_each(|&cell| self.search.cells.close(cell)),
                Verdict::Open(narrow) | Verdict::Undecided(narrow) => {
                    passage.cells.iter().for_each(|&cell| self.search.cells.close(cell));
                    if self.top.is_some() && self.search.space.is_above_walls(narrow.place) {
                        self.search.space.cap -= 0.5 * self.search.space.radius;
                        self.report.open_at_top = true;
                        found = true;
                        break;
                    }
                    let is_open = matches!(passage.verdict, Verdict::Open(_));
                    let kind = if is_open {
                        OpeningKind::Leak
                    } else {
                        OpeningKind::AboutGrainSize
                    };
                    self.tell(kind, &narrow);
                }
            }
            found = true;
            if self.told() > MOST_OPENINGS {
                break;
            }
        }
        Ok(if found { Round::Found } else { Round::Closed })
    }

    /// Closes an opening.
    fn plug(&mut self, narrow: &Narrowest) {
        let space = &self.search.space;
        let farthest = PLUG * narrow.clearance.max(0.0) + 2.0 * space.radius;
        let plug = Plug::over(space, narrow.place, narrow.along, farthest);
        let plugs = self.images.iter().map(|image| plug.shifted(*image));
        self.search.space.plugs.extend(plugs);
    }

    /// Tells an opening that was found, and closes it. A part of one that was told, in one plane with it, is not told again.
    fn tell(&mut self, kind: OpeningKind, found: &Narrowest) {
        let space = &self.search.space;
        let is_part = |(told, across): (&Opening, &DVec3)| {
            let between = told.place - found.place;
            told.kind == kind
                && across.dot(found.along).abs() > IN_ONE_PLANE
                && between.dot(*across).abs() < space.radius
                && space.is_clear(told.place, found.place)
        };
        if !self.report.openings.iter().zip(&self.across).any(is_part) {
            self.report.openings.push(Opening {
                kind,
                place: space.put_back(found.place),
                width: 2.0 * found.clearance,
            });
            self.across.push(found.along);
        }
        self.plug(found);
    }

    /// Tells an opening through which free cells lead: over a rim, or where the widest way is narrowest.
    fn wide_opening(&mut self, surely: &[bool]) -> Option<()> {
        let Search { space, cells, .. } = &self.search;
        let starts = self.search.start_cells();
        let goal = self.search.goal_marks();
        let is_goal = |cell: u32| goal[cell as usize];
        if self.top.is_some() && !self.lie_on_top {
            let climb =
                |so_far: f64, cell: u32| surely[cell as usize].then(|| so_far.max(cells.heights(cell, space).0));
            let lowest = Ways::new(cells, &starts, climb, is_goal);
            let path = lowest.path();
            let height = |cell: &u32| cells.heights(*cell, space).0;
            if let Some(crest) = path.iter().copied().max_by(|a, b| height(a).total_cmp(&height(b))) {
                let place = cells.center(crest);
                if space.is_above_walls(place) {
                    // the rim is one radius below the centre of a grain that passes over it
                    let cap = (height(&crest) - space.radius).min(space.cap - 0.25 * space.radius);
                    self.search.space.cap = cap;
                    self.report.open_at_top = true;
                    self.report.openings.push(Opening {
                        kind: OpeningKind::OverRim,
                        place,
                        width: 0.0,
                    });
                    self.across.push(self.search.space.up);
                    return Some(());
                }
            }
        }
        let deep = self.deepest(&starts, surely);
        let widen = |so_far: f64, cell: u32| surely[cell as usize].then(|| so_far.max(-cells.get(cell).clearance));
        let way = |from: &[u32]| Ways::new(cells, from, widen, is_goal).path();
        // the roomiest place may be in another compartment than the opening
        let found = match self.top.filter(|_| self.lie_on_top) {
            Some(top) => {
                let down = |from: &[u32]| way_down(&self.search, &way(from), top);
                down(&[deep]).or_else(|| down(&starts))?
            }
            None => narrow_on(&self.search, &way(&[deep])).or_else(|| narrow_on(&self.search, &way(&starts)))?,
        };
        if found.clearance < SURELY * self.search.space.radius {
            // the grain passes where the way leads, but this is not on it
            return None;
        }
        self.tell(OpeningKind::Leak, &found);
        Some(())
    }

    /// From some of the starts uphill in clearance, within the box of the walls: the roomiest place that is found. So the
    /// narrow place where a grain happens to lie is not taken for the narrowest on its way out.
    fn deepest(&self, starts: &[u32], surely: &[bool]) -> u32 {
        let cells = &self.search.cells;
        let clearance = |cell: u32| cells.get(cell).clearance;
        let inside = |cell: u32| {
            let center = cells.center(cell);
            center.cmpge(self.bounds.0).all() && center.cmple(self.bounds.1).all()
        };
        let uphill = |mut cell: u32| {
            loop {
                let mut best = cell;
                cells.neighbours(cell, |beyond| {
                    if let cells::Beyond::Cell(next) = beyond
                        && surely[next as usize]
                        && inside(next)
                        && clearance(next) > clearance(best)
                    {
                        best = next;
                    }
                });
                if best == cell {
                    return cell;
                }
                cell = best;
            }
        };
        let some = starts.iter().step_by(starts.len().div_ceil(64).max(1));
        let found = some.map(|&start| uphill(start));
        found
            .max_by(|&a, &b| clearance(a).total_cmp(&clearance(b)))
            .unwrap_or(0)
    }

    /// Whether a grain can rise above all walls, with all openings plugged.
    fn is_open_at_top(&mut self) -> Result<bool, Untested> {
        let Some(top) = self.top else { return Ok(false) };
        self.search.space.cap = f64::INFINITY;
        self.search.goal = Goal::Above(top + 1.2 * self.search.space.radius);
        self.renew();
        let coarsest = 0.5 * 3f64.sqrt() * APART * 1.02 * self.search.space.radius;
        match self.search.coarse(coarsest, 2 * MOST_CELLS) {
            Coarse::Closed | Coarse::TooMany => return Ok(false),
            Coarse::Open => {}
        }
        let surely = self.search.surely_reached();
        Ok(self.search.goal_cells().iter().any(|&cell| surely[cell as usize]))
    }
}

fn settle(space: &Space<'_>, places: &[DVec3], ends: (DVec3, DVec3)) -> Vec<DVec3> {
    let places = places.iter();
    places
        .filter_map(|&place| search::settled(space, place, ends))
        .collect()
}

/// The narrowest place of a way through cells; of no way, nowhere.
fn narrow_on(search: &Search<'_>, path: &[u32]) -> Option<Narrowest> {
    narrowest_along(&search.space, &search.cells.centers(path))
}

/// Where a way leads from above a height to below it; of one that stays above, where it ends.
fn way_down(search: &Search<'_>, path: &[u32], top: f64) -> Option<Narrowest> {
    let Search { space, cells, .. } = search;
    let is_above = |cell: &u32| space.height(cells.center(*cell)) > top;
    let at = *path.iter().rfind(|cell| is_above(cell))?;
    let near = cells.center(at);
    let level = near - space.up * (space.height(near) - top).max(0.0);
    Some(narrowest(space, level, -space.up, 1.5 * cells.side(at)))
}

/// From a place to itself and its images in the boxes around a periodic one [m].
fn images(lower: DVec3, upper: DVec3, periodic: [bool; 3]) -> Vec<DVec3> {
    let size = upper - lower;
    let mut images = vec![DVec3::ZERO];
    for axis in (0..3).filter(|&axis| periodic[axis]) {
        let shift = DVec3::AXES[axis] * size[axis];
        images = [-1.0, 0.0, 1.0]
            .iter()
            .flat_map(|share| {
                images
                    .iter()
                    .map(move |image| *image + shift * *share)
                    .collect::<Vec<_>>()
            })
            .collect();
    }
    images
}

/// Whether a cell may be part of a way out.
fn is_open(cells: &Cells, cell: u32) -> bool {
    cells.get(cell).state != State::Blocked
}

/// Marks the cells that are free and connected, through free cells, with some.
fn freely_reached(cells: &Cells, starts: &[u32]) -> Vec<bool> {
    flood(cells, starts, |cell| cells.get(cell).state == State::Free)
}
