//! Rows of cells in use: where grains are sorted that are some of all, only rows with any of them have cells, so that sorting takes
//! as long as their share.

use super::cells::Grid;

/// Where the rows of cells of all grids begin.
#[derive(Debug, Default)]
pub(super) struct RowsOfCells {
    /// By the number of the row; nothing where all are in use, one behind the other.
    starts: Vec<u32>,
    cells: usize,
}

impl RowsOfCells {
    /// Finds where rows begin, of which all are in use or those told. All that are not in use are one that is empty.
    pub(super) fn find(&mut self, grids: &[Grid], in_use: Option<impl Iterator<Item = usize>>) {
        self.starts.clear();
        let Some(in_use) = in_use else {
            self.cells = grids.iter().map(|grid| (grid.rows() * grid.stride()) as usize).sum();
            return;
        };
        let rows = grids.iter().map(|grid| grid.rows() as usize).sum();
        self.starts.resize(rows, 0);
        in_use.for_each(|row| self.starts[row] = 1);
        let mut next = grids.iter().map(Grid::stride).max().unwrap_or(0);
        let strides = grids
            .iter()
            .flat_map(|grid| std::iter::repeat_n(grid.stride(), grid.rows() as usize));
        for (start, stride) in self.starts.iter_mut().zip(strides).filter(|(start, _)| **start > 0) {
            *start = next;
            next += stride;
        }
        self.cells = next as usize;
    }

    /// Whether all rows are in use.
    #[inline(always)]
    pub(super) fn are_all(&self) -> bool {
        self.starts.is_empty()
    }

    /// Where a row begins.
    #[inline(always)]
    pub(super) fn start(&self, grid: &Grid, x: i32, y: i32) -> usize {
        if self.are_all() {
            grid.start_of_row(x, y)
        } else {
            self.starts[grid.row(x, y)] as usize
        }
    }

    /// Cells of all rows in use.
    pub(super) fn cells(&self) -> usize {
        self.cells
    }
}
