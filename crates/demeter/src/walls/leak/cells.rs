//! Cells of the space around the walls, halved where it matters.
//!
//! The clearance changes by no more than the way between two points. So a cell whose centre has a clearance of the grain's
//! radius and half of its own diagonal is free as a whole, and one whose centre lacks as much is blocked as a whole.

use super::space::Space;
use glam::DVec3;

/// Cells along the longest side before any is halved, about.
const ROOTS: f64 = 24.0;
/// Most halvings: coordinates stay below 2^26.
const DEEPEST: u8 = 20;

/// Whether the centre of the grain may be in a cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum State {
    /// Everywhere.
    Free,
    /// Perhaps in a part of it.
    Mixed,
    /// Nowhere.
    Blocked,
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Cell {
    at: [u32; 3],
    pub(super) level: u8,
    pub(super) state: State,
    /// Whether it is known that no grain passes, though it is mixed.
    closed: bool,
    /// First of its eight parts; 0 for a cell that is not halved.
    parts: u32,
    /// Clearance of its centre from walls and plugs [m].
    pub(super) clearance: f64,
}

/// What lies behind a side of a cell.
pub(super) enum Beyond {
    Cell(u32),
    /// The end of the box.
    Outside,
}

pub(super) struct Cells {
    lower: DVec3,
    /// Size of a cell that was not halved [m].
    size: DVec3,
    roots: [u32; 3],
    periodic: [bool; 3],
    cells: Vec<Cell>,
}

impl Cells {
    /// Cells of a box whose sides are about `finest` times a power of two.
    pub(super) fn new(space: &Space<'_>, lower: DVec3, upper: DVec3, periodic: [bool; 3], finest: f64) -> Self {
        let extent = upper - lower;
        let mut size = finest;
        while size * ROOTS * 2.0 < extent.max_element() {
            size *= 2.0;
        }
        let roots = extent
            .to_array()
            .map(|e| (e / size).ceil().clamp(1.0, 4.0 * ROOTS) as u32);
        let counts = DVec3::from_array(roots.map(f64::from));
        let mut cells = Cells {
            lower,
            size: extent / counts,
            roots,
            periodic,
            cells: Vec::new(),
        };
        for z in 0..roots[2] {
            for y in 0..roots[1] {
                for x in 0..roots[0] {
                    cells.add(space, [x, y, z], 0);
                }
            }
        }
        cells
    }

    fn add(&mut self, space: &Space<'_>, at: [u32; 3], level: u8) {
        let cell = Cell {
            at,
            level,
            state: State::Mixed,
            closed: false,
            parts: 0,
            clearance: 0.0,
        };
        let center = self.center_of(&cell);
        let clearance = space.clearance(center);
        let state = self.judge(space, clearance, center, level);
        self.cells.push(Cell {
            clearance,
            state,
            ..cell
        });
    }

    /// Centres of neighbouring cells one after the other; across a periodic side they go on beyond it.
    pub(super) fn centers(&self, path: &[u32]) -> Vec<DVec3> {
        let extent = self.size * DVec3::from_array(self.roots.map(f64::from));
        let mut last: Option<DVec3> = None;
        let follow = path.iter().map(|&cell| {
            let mut center = self.center(cell);
            for axis in (0..3).filter(|&axis| self.periodic[axis]) {
                let ahead = last.map_or(0.0, |last| center[axis] - last[axis]);
                center[axis] -= (ahead / extent[axis]).round() * extent[axis];
            }
            last = Some(center);
            center
        });
        follow.collect()
    }

    fn judge(&self, space: &Space<'_>, clearance: f64, center: DVec3, level: u8) -> State {
        let (left, half) = (space.below_cap(clearance, center), self.half_diagonal(level));
        if left >= space.radius + half {
            State::Free
        } else if left < space.radius - half {
            State::Blocked
        } else {
            State::Mixed
        }
    }

    /// Looks at all cells anew after the space has changed; walls stay where they are.
    pub(super) fn renew(&mut self, space: &Space<'_>) {
        for index in 0..self.cells.len() {
            let cell = self.cells[index];
            let center = self.center_of(&cell);
            let clearance = (space.plugs.iter()).fold(cell.clearance, |least, plug| plug.distance(center, least));
            self.cells[index].clearance = clearance;
            self.cells[index].state = match cell.closed {
                true => State::Blocked,
                false => self.judge(space, clearance, center, cell.level),
            };
        }
    }

    /// Blocks a cell for good.
    pub(super) fn close(&mut self, index: u32) {
        let cell = &mut self.cells[index as usize];
        (cell.closed, cell.state) = (true, State::Blocked);
    }

    pub(super) fn len(&self) -> usize {
        self.cells.len()
    }

    pub(super) fn get(&self, index: u32) -> &Cell {
        &self.cells[index as usize]
    }

    /// Cells that are not halved.
    pub(super) fn whole(&self) -> impl Iterator<Item = u32> + '_ {
        (0..self.cells.len() as u32).filter(|&index| self.cells[index as usize].parts == 0)
    }

    fn size_at(&self, level: u8) -> DVec3 {
        self.size / f64::from(1u32 << level)
    }

    /// Half of the diagonal of a cell [m].
    pub(super) fn half_diagonal(&self, level: u8) -> f64 {
        0.5 * self.size_at(level).length()
    }

    /// Longest side of a cell [m].
    pub(super) fn side(&self, index: u32) -> f64 {
        self.size_at(self.get(index).level).max_element()
    }

    fn center_of(&self, cell: &Cell) -> DVec3 {
        let at = DVec3::from_array(cell.at.map(|k| f64::from(k) + 0.5));
        self.lower + at * self.size_at(cell.level)
    }

    pub(super) fn center(&self, index: u32) -> DVec3 {
        self.center_of(self.get(index))
    }

    /// Heights of the lowest and of the highest point of a cell [m].
    pub(super) fn heights(&self, index: u32, space: &Space<'_>) -> (f64, f64) {
        let middle = space.height(self.center(index));
        let half = 0.5 * self.size_at(self.get(index).level).dot(space.up.abs());
        (middle - half, middle + half)
    }

    /// Halves a cell along all three axes; cells that are halved already stay as they are.
    pub(super) fn halve(&mut self, index: u32, space: &Space<'_>) {
        let cell = *self.get(index);
        if cell.parts != 0 || cell.level >= DEEPEST {
            return;
        }
        self.cells[index as usize].parts = self.cells.len() as u32;
        for part in 0..8 {
            let at = std::array::from_fn(|k| 2 * cell.at[k] + ((part >> k) & 1));
            self.add(space, at, cell.level + 1);
        }
    }

    /// The cell that holds a point; `None` outside of the box.
    pub(super) fn holding(&self, point: DVec3) -> Option<u32> {
        let relative = (point - self.lower) / self.size_at(DEEPEST);
        let mut at = [0; 3];
        for k in 0..3 {
            let most = f64::from(self.roots[k]) * f64::from(1u32 << DEEPEST);
            if !(relative[k] >= 0.0 && relative[k] < most) {
                return None;
            }
            at[k] = relative[k] as u32;
        }
        Some(self.find(at, DEEPEST))
    }

    /// The cell at given coordinates of a level, or the larger one that was not halved so far.
    fn find(&self, at: [u32; 3], level: u8) -> u32 {
        let root = at.map(|k| k >> level);
        let mut index = root[0] + self.roots[0] * (root[1] + self.roots[1] * root[2]);
        for depth in 1..=level {
            let parts = self.get(index).parts;
            if parts == 0 {
                break;
            }
            let bit = |k: usize| (at[k] >> (level - depth)) & 1;
            index = parts + bit(0) + 2 * bit(1) + 4 * bit(2);
        }
        index
    }

    /// Whether a cell lies at an end of the box that is not periodic.
    pub(super) fn is_at_end(&self, index: u32) -> bool {
        let cell = self.get(index);
        (0..3).any(|k| !self.periodic[k] && (cell.at[k] == 0 || cell.at[k] + 1 == self.roots[k] << cell.level))
    }

    /// Calls `visit` with all that lies behind the six sides of a cell.
    pub(super) fn neighbours(&self, index: u32, mut visit: impl FnMut(Beyond)) {
        let cell = *self.get(index);
        for axis in 0..3 {
            let count = self.roots[axis] << cell.level;
            for ahead in [false, true] {
                let mut at = cell.at;
                let is_last = if ahead { at[axis] + 1 == count } else { at[axis] == 0 };
                at[axis] = match (is_last, ahead) {
                    (true, _) if !self.periodic[axis] => {
                        visit(Beyond::Outside);
                        continue;
                    }
                    (true, true) => 0,
                    (true, false) => count - 1,
                    (false, true) => at[axis] + 1,
                    (false, false) => at[axis] - 1,
                };
                self.visit_side(self.find(at, cell.level), axis, !ahead, &mut visit);
            }
        }
    }

    /// Visits the smallest parts of a cell that lie at one of its sides.
    fn visit_side(&self, index: u32, axis: usize, upper_side: bool, visit: &mut impl FnMut(Beyond)) {
        let parts = self.get(index).parts;
        if parts == 0 {
            visit(Beyond::Cell(index));
            return;
        }
        for part in 0..8u32 {
            if ((part >> axis) & 1 == 1) == upper_side {
                self.visit_side(parts + part, axis, upper_side, visit);
            }
        }
    }
}
