//! Vectors of all grains, each with a number beside it, in rows that one load of 32 bytes fetches.

use bytemuck::{Pod, Zeroable};
use glam::DVec3;
use serde::{Deserialize, Serialize};
use std::ops::{Index, IndexMut};

/// A vector and a number that is used together with it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, Pod, Zeroable)]
#[repr(C, align(32))]
pub struct Row {
    /// The vector.
    pub vector: DVec3,
    /// The number.
    pub scalar: f64,
}

/// One [`Row`] per grain; indexing gives the vector.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Rows(Vec<Row>);

impl Rows {
    /// Number of rows.
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Adds a row.
    pub fn push(&mut self, vector: DVec3, scalar: f64) {
        self.0.push(Row { vector, scalar });
    }

    /// Adds copies of all rows of another table.
    pub(super) fn append(&mut self, other: &Self) {
        self.0.extend_from_slice(&other.0);
    }

    /// Has so many rows; new ones are zero.
    pub(crate) fn resize(&mut self, count: usize) {
        self.0.resize(count, Row::default());
    }

    /// The number of a row.
    #[inline(always)]
    pub fn scalar(&self, index: usize) -> f64 {
        self.0[index].scalar
    }

    /// Puts the number of a row.
    pub fn set_scalar(&mut self, index: usize, scalar: f64) {
        self.0[index].scalar = scalar;
    }

    /// The vectors.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = &DVec3> + Clone {
        self.0.iter().map(|row| &row.vector)
    }

    /// The vectors, to be changed.
    pub fn iter_mut(&mut self) -> impl ExactSizeIterator<Item = &mut DVec3> {
        self.0.iter_mut().map(|row| &mut row.vector)
    }

    /// The numbers.
    pub fn scalars(&self) -> impl ExactSizeIterator<Item = f64> + Clone + '_ {
        self.0.iter().map(|row| row.scalar)
    }

    /// Puts the same vector everywhere.
    pub fn fill(&mut self, vector: DVec3) {
        self.iter_mut().for_each(|v| *v = vector);
    }

    /// The rows as plain numbers.
    #[inline(always)]
    pub fn table(&self) -> &[[f64; 4]] {
        bytemuck::cast_slice(&self.0)
    }

    /// The rows.
    #[inline(always)]
    pub fn rows(&self) -> &[Row] {
        &self.0
    }

    /// The rows as plain numbers, to be changed.
    #[inline(always)]
    pub fn table_mut(&mut self) -> &mut [[f64; 4]] {
        bytemuck::cast_slice_mut(&mut self.0)
    }

    /// The rows, to be changed.
    #[inline(always)]
    pub fn rows_mut(&mut self) -> &mut [Row] {
        &mut self.0
    }

    /// Takes the rows of another table, in memory that is here already where it is enough.
    pub(crate) fn copy(&mut self, other: &Self) {
        self.0.clone_from(&other.0);
    }

    /// Bytes in use.
    pub(crate) fn bytes(&self) -> usize {
        self.0.capacity() * size_of::<Row>()
    }

    pub(super) fn pick(&mut self, order: &[u32]) {
        self.0 = order.iter().map(|&i| self.0[i as usize]).collect();
    }
}

impl Index<usize> for Rows {
    type Output = DVec3;

    #[inline(always)]
    fn index(&self, index: usize) -> &DVec3 {
        &self.0[index].vector
    }
}

impl IndexMut<usize> for Rows {
    #[inline(always)]
    fn index_mut(&mut self, index: usize) -> &mut DVec3 {
        &mut self.0[index].vector
    }
}
