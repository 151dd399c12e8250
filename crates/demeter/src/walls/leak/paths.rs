//! Which cells can be reached, and the best way through them.

use super::cells::{Beyond, Cells};
use std::cmp::Ordering;
use std::collections::BinaryHeap;

const NONE: u32 = u32::MAX;

/// Marks all cells that can be reached from some through allowed ones; the starts count as allowed.
pub(super) fn flood(cells: &Cells, starts: &[u32], allowed: impl Fn(u32) -> bool) -> Vec<bool> {
    let mut reached = vec![false; cells.len()];
    let mut waiting: Vec<u32> = Vec::new();
    for &start in starts {
        if !reached[start as usize] {
            reached[start as usize] = true;
            waiting.push(start);
        }
    }
    while let Some(index) = waiting.pop() {
        cells.neighbours(index, |beyond| {
            if let Beyond::Cell(next) = beyond
                && !reached[next as usize]
                && allowed(next)
            {
                reached[next as usize] = true;
                waiting.push(next);
            }
        });
    }
    reached
}

/// A cell and what the best way to it costs; the cheapest comes first, then the lowest index.
#[derive(PartialEq)]
struct Waiting {
    cost: f64,
    index: u32,
}

impl Eq for Waiting {}

impl Ord for Waiting {
    fn cmp(&self, other: &Self) -> Ordering {
        other.cost.total_cmp(&self.cost).then(other.index.cmp(&self.index))
    }
}

impl PartialOrd for Waiting {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

/// Cheapest ways from some cells to all others (E. W. Dijkstra, Numer. Math. 1 (1959) 269).
pub(super) struct Ways {
    /// Cost of the best way to each cell; infinite where there is none.
    pub(super) cost: Vec<f64>,
    before: Vec<u32>,
    /// The first target that was reached.
    pub(super) reached: Option<u32>,
}

impl Ways {
    /// `step` tells what a way costs with one more cell, from what it cost before; never less, and `None` where the cell is
    /// not allowed. It ends at the first target.
    pub(super) fn new(
        cells: &Cells,
        starts: &[u32],
        step: impl Fn(f64, u32) -> Option<f64>,
        is_target: impl Fn(u32) -> bool,
    ) -> Self {
        let mut ways = Ways {
            cost: vec![f64::INFINITY; cells.len()],
            before: vec![NONE; cells.len()],
            reached: None,
        };
        let mut waiting = BinaryHeap::new();
        for &index in starts {
            let Some(cost) = step(f64::NEG_INFINITY, index) else {
                continue;
            };
            if cost < ways.cost[index as usize] {
                ways.cost[index as usize] = cost;
                waiting.push(Waiting { cost, index });
            }
        }
        while let Some(Waiting { cost, index }) = waiting.pop() {
            if cost > ways.cost[index as usize] {
                continue;
            }
            if is_target(index) {
                ways.reached = Some(index);
                break;
            }
            cells.neighbours(index, |beyond| {
                let Beyond::Cell(next) = beyond else { return };
                if let Some(longer) = step(cost, next)
                    && longer < ways.cost[next as usize]
                {
                    ways.cost[next as usize] = longer;
                    ways.before[next as usize] = index;
                    waiting.push(Waiting {
                        cost: longer,
                        index: next,
                    });
                }
            });
        }
        ways
    }

    /// The way to the target that was reached, from its start.
    pub(super) fn path(&self) -> Vec<u32> {
        let mut path: Vec<u32> = Vec::new();
        let mut at = self.reached.unwrap_or(NONE);
        while at != NONE {
            path.push(at);
            at = self.before[at as usize];
        }
        path.reverse();
        path
    }
}
