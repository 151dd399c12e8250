//! The search for candidates.

use super::cells::Cells;
use super::packed::{MOST_OF_A_SEGMENT, PackedPair};
use super::pairs::{PairTable, Sorter};
use super::surroundings::Surroundings;
use super::table::{LawOrder, NOWHERE, Segment, Table};
use super::vicinity::Vicinity;
use super::visit::Near;
use super::{Pair, WallPair};
use crate::comm::Single;
use crate::materials::Materials;
use crate::particles::Grains;
use crate::particles::spread::GRAINS_OF_A_SPREAD;
use crate::walls::Wall;
use glam::DVec3;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::ops::Range;
use std::sync::{Mutex, PoisonError};

/// Grains handled by one task; more where there are many pairs of materials, so that chunks are worth their while.
const LEAST_OF_A_SEGMENT: usize = GRAINS_OF_A_SPREAD;

/// Pairs of materials that a task of so many grains serves well.
const FEW_LAWS: usize = 4;

/// So many of the least segments make the longest one.
const MOST_SEGMENTS_IN_ONE: usize = 16;
const _: () = assert!(LEAST_OF_A_SEGMENT * MOST_SEGMENTS_IN_ONE <= MOST_OF_A_SEGMENT);

/// Neighbours in memory that are told together whether they are near a wall.
const GRAINS_PER_GROUP: usize = 64;

/// What the search found and tried.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct SearchEffort {
    /// Distances looked at in the filter of the search.
    pub tests: u64,
    /// Candidates whose grains lie in different tasks, which grows as grains that are close drift apart in memory.
    pub scattered: u64,
}

impl SearchEffort {
    fn join(self, other: Self) -> Self {
        Self {
            tests: self.tests + other.tests,
            scattered: self.scattered + other.scattered,
        }
    }
}

/// Memory that a search needs, kept from one to the next.
#[derive(Debug, Default)]
pub(super) struct Search {
    pub(super) cells: Cells,
    workers: Vec<Mutex<Worker>>,
}

/// Memory of one thread.
#[derive(Debug, Default)]
struct Worker {
    near: Near,
    /// Pairs whose later grain belongs to another task than the one that found them.
    strays: Vec<Pair>,
    sorter: Sorter,
    walls: Vec<WallPair>,
    laws: Vec<u32>,
    order: LawOrder,
}

impl Search {
    fn prepare(&mut self) {
        let threads = rayon::current_num_threads();
        self.workers
            .resize_with(threads.max(self.workers.len()).max(1), Mutex::default);
    }

    fn with_worker<T>(&self, work: impl FnOnce(&mut Worker) -> T) -> T {
        let thread = rayon::current_thread_index().unwrap_or(0) % self.workers.len();
        let mut worker = self.workers[thread].lock().unwrap_or_else(PoisonError::into_inner);
        work(&mut worker)
    }

    /// Finds all pairs of grains closer than `skin` to touching that one of the `own` grains is in. The effort is that of
    /// the own ones.
    pub(super) fn pairs(
        &mut self,
        table: &mut PairTable,
        grains: &Grains,
        (materials, comm): (&Materials, &Single),
        skin: f64,
        (own, vicinity): (&Range<usize>, Option<&Vicinity>),
    ) -> SearchEffort {
        self.prepare();
        self.cells.sort(grains, comm, skin, vicinity);
        let laws = materials.list().len().pow(2);
        let per_task = per_task(materials);
        let finder = Finder {
            grains,
            comm,
            skin,
            cells: &self.cells,
            own: own.clone(),
            surroundings: Surroundings::of(own, per_task, grains, skin),
        };
        let effort = (table.search(grains.len(), per_task).enumerate())
            .map(|(task, found)| {
                let of = task * per_task..((task + 1) * per_task).min(grains.len());
                if vicinity.is_some_and(|vicinity| !vicinity.knows(&of))
                    || !finder.surroundings.may_meet(&of, grains, comm)
                {
                    return SearchEffort::default();
                }
                self.with_worker(|worker| {
                    if finder.cells.is_periodic() {
                        finder.find::<true>(of, found, worker)
                    } else {
                        finder.find::<false>(of, found, worker)
                    }
                })
            })
            .reduce(SearchEffort::default, SearchEffort::join);
        // until the next search memory is worth more; that of the threads stays
        self.cells = Cells::default();
        let workers = self
            .workers
            .iter_mut()
            .map(|worker| worker.get_mut().unwrap_or_else(PoisonError::into_inner));
        let strays = workers.map(|worker| std::mem::take(&mut worker.strays)).collect();
        let law = |p: &Pair| {
            let material = |g: u32| grains.material[g as usize];
            if laws == 1 {
                0
            } else {
                materials.pair(material(p.i), material(p.j))
            }
        };
        table.sort(grains.len(), strays, law, |work| {
            self.with_worker(|worker| work(&mut worker.sorter))
        });
        effort
    }

    /// Finds all pairs of grain and wall closer than `skin` to touching, by the segments of the pairs of grains.
    pub(super) fn walls(
        &mut self,
        table: &mut Table<WallPair>,
        grains: &Grains,
        (walls, materials): (&[Wall], &Materials),
        skin: f64,
        own: &Range<usize>,
    ) {
        self.prepare();
        let per_task = per_task(materials);
        table
            .segments
            .resize_with(grains.len().div_ceil(per_task), Segment::default);
        let law = |p: &WallPair| materials.pair(grains.material[p.grain as usize], walls[p.wall as usize].material);
        let span = |span: (u32, u32), p: &WallPair| (span.0.min(p.grain), span.1.max(p.grain));
        (table.segments.par_iter_mut().enumerate()).for_each(|(s, segment)| {
            let of = common(&(s * per_task..(s + 1) * per_task), own);
            if of.is_empty() && segment.candidates.is_empty() {
                return;
            }
            self.with_worker(|worker| {
                let near = &mut worker.walls;
                near.clear();
                for first in of.clone().step_by(GRAINS_PER_GROUP) {
                    group_near_walls(first..(first + GRAINS_PER_GROUP).min(of.end), grains, walls, skin, near);
                }
                worker.laws.clear();
                worker.laws.extend(near.iter().map(law));
                segment.span = near.iter().fold(NOWHERE, span);
                segment.fill(near, &worker.laws, &mut worker.order);
            });
        });
        table.cut_by_grain();
    }
}

/// What a task finds pairs from.
struct Finder<'a> {
    grains: &'a Grains,
    comm: &'a Single,
    skin: f64,
    cells: &'a Cells,
    /// Grains whose pairs are wanted.
    own: Range<usize>,
    surroundings: Surroundings,
}

/// Grains handled by one task.
pub(super) fn per_task(materials: &Materials) -> usize {
    let laws = materials.list().len().pow(2);
    LEAST_OF_A_SEGMENT * laws.div_ceil(FEW_LAWS).clamp(1, MOST_SEGMENTS_IN_ONE)
}

/// What both ranges hold.
fn common(one: &Range<usize>, other: &Range<usize>) -> Range<usize> {
    let start = one.start.max(other.start);
    start..one.end.min(other.end).max(start)
}

impl Finder<'_> {
    /// Finds the pairs of some grains with others: those whose later grain is one of them, and strays.
    fn find<const PERIODIC: bool>(
        &self,
        of: Range<usize>,
        found: &mut Vec<PackedPair>,
        Worker { near, strays, .. }: &mut Worker,
    ) -> SearchEffort {
        let Self { grains, comm, .. } = *self;
        let rows = grains.position.rows();
        let half = 0.5 * comm.domain().size();
        let below = comm.slides().map(|axes| (axes.gradient, -comm.edge(axes.gradient)));
        let mut effort = SearchEffort::default();
        for g in of.clone() {
            let row = rows[g];
            let id = grains.id[g];
            near.clear();
            let mut tests = (self.cells).visit(g as u32, row.vector, row.scalar, near);
            if let Some(to_image) = below {
                tests += (self.cells).visit_below(row.vector, row.scalar, to_image, near);
            }
            let is_fixed = grains.is_fixed(g);
            let is_own = self.own.contains(&g);
            if is_own {
                effort.tests += tests;
            }
            for &h in near.grains() {
                let other = &rows[h as usize];
                if !is_own && !self.own.contains(&(h as usize)) {
                    continue;
                }
                if is_fixed && grains.is_fixed(h as usize) {
                    continue;
                }
                let mut separation = row.vector - other.vector;
                let mut shift = Single::UNSHIFTED;
                if PERIODIC && separation.abs().cmpgt(half).any() {
                    shift = comm.nearest_image(separation);
                    separation += comm.shift(shift);
                }
                let reach = row.scalar + other.scalar + self.skin;
                if separation.length_squared() < reach * reach {
                    let is_first = id < grains.id[h as usize];
                    let g = g as u32;
                    let pair = Pair {
                        i: if is_first { g } else { h },
                        j: if is_first { h } else { g },
                        shift: if is_first { shift } else { Single::opposite(shift) },
                    };
                    effort.scattered += u64::from(is_own && !of.contains(&(h as usize)));
                    if of.contains(&(pair.later() as usize)) {
                        found.push(PackedPair::new(&pair, of.start as u32));
                    } else {
                        strays.push(pair);
                    }
                }
            }
        }
        effort
    }
}

/// Pairs with walls of grains that are neighbours in memory: a wall that is not near the ball around all of them is near
/// none.
fn group_near_walls(of: Range<usize>, grains: &Grains, walls: &[Wall], skin: f64, near: &mut Vec<WallPair>) {
    let rows = &grains.position.rows()[of.clone()];
    let (mut lower, mut upper, mut largest) = (DVec3::INFINITY, DVec3::NEG_INFINITY, 0.0f64);
    for row in rows {
        lower = lower.min(row.vector);
        upper = upper.max(row.vector);
        largest = largest.max(row.scalar);
    }
    let centre = 0.5 * (lower + upper);
    let ball = (1.0 + 1e-9) * (0.5 * (upper - lower).length() + largest + skin) + 1e-9 * centre.abs().max_element();
    let first = near.len();
    for (w, wall) in walls.iter().enumerate() {
        if !wall.near(centre, ball) {
            continue;
        }
        for (g, row) in of.clone().zip(rows) {
            if !grains.is_fixed(g) && wall.near(row.vector, row.scalar + skin) {
                let (grain, wall) = (g as u32, w as u32);
                near.push(WallPair { grain, wall });
            }
        }
    }
    // by grain, then by wall: walls come in their order
    near[first..].sort_unstable_by_key(|p| (p.grain, p.wall));
}
