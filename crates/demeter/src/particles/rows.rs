//! Rows of numbers of all grains: a vector with a number beside it, which one load of 32 bytes fetches, or what acts on a grain.

use bytemuck::{Pod, Zeroable};
use glam::DVec3;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::fmt::{Debug, Formatter};
use std::marker::PhantomData;
use std::ops::{Index, IndexMut};

/// A vector and a number that is used together with it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, Pod, Zeroable)]
#[repr(C)]
pub struct Row {
    /// The vector.
    pub vector: DVec3,
    /// The number.
    pub scalar: f64,
}

/// A row that is kept: its new index, and the one before.
pub(super) type Kept = (usize, usize);

/// Copies what is kept of a table into a new one.
pub(super) fn copy_kept<T: Pod>(to: &mut [T], from: &[T], some: impl Iterator<Item = Kept>) {
    if cfg!(test) {
        // whoever looks at what is forgotten finds no number, not zeros that may pass
        bytemuck::cast_slice_mut::<T, u8>(to).fill(u8::MAX);
    }
    some.for_each(|(new, old)| to[new] = from[old]);
}

/// A row of numbers per grain, none of which lies in two lines of the cache; indexing rows of vectors gives the vector.
///
/// Rows begin at multiples of their size. The memory is that of plain numbers, as the allocator hands out zeros that take no memory until
/// they are written only where it is not asked for more than its own alignment.
pub struct Rows<T = Row> {
    numbers: Vec<f64>,
    /// Numbers before the first row.
    first: usize,
    of: PhantomData<T>,
}

impl<T> Default for Rows<T> {
    fn default() -> Self {
        Self {
            numbers: Vec::new(),
            first: 0,
            of: PhantomData,
        }
    }
}

impl<T: Pod> Rows<T> {
    /// Numbers of a row.
    const WIDTH: usize = size_of::<T>() / size_of::<f64>();

    /// So many rows, all zero; they take no memory until they are written.
    pub(crate) fn zeros(count: usize) -> Self {
        let numbers = vec![0.0; Self::WIDTH * count + Self::WIDTH - 1];
        let first = numbers_to_skip::<T>(&numbers);
        let mut rows = Self {
            numbers,
            first,
            of: PhantomData,
        };
        rows.numbers.truncate(first + Self::WIDTH * count);
        rows
    }

    /// Number of rows.
    pub fn len(&self) -> usize {
        (self.numbers.len() - self.first) / Self::WIDTH
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Adds a row as it is.
    pub(crate) fn push_row(&mut self, row: T) {
        self.extend(std::iter::once(row));
    }

    /// Adds copies of all rows of another table.
    pub(super) fn append(&mut self, other: &Self) {
        self.extend(other.rows().iter().copied());
    }

    fn extend(&mut self, rows: impl ExactSizeIterator<Item = T>) {
        let more = Self::WIDTH * rows.len();
        if self.numbers.len() + more > self.numbers.capacity() {
            self.numbers.reserve(more + Self::WIDTH - 1);
            let (from, to) = (self.first, numbers_to_skip::<T>(&self.numbers));
            let end = self.numbers.len();
            self.numbers.resize(end.max(end - from + to), 0.0);
            self.numbers.copy_within(from..end, to);
            self.numbers.truncate(end - from + to);
            self.first = to;
        }
        for row in rows {
            self.numbers.extend_from_slice(bytemuck::cast_slice(&[row]));
        }
    }

    /// The rows.
    #[inline(always)]
    pub fn rows(&self) -> &[T] {
        match self.numbers() {
            // an empty list begins anywhere
            [] => &[],
            numbers => bytemuck::cast_slice(numbers),
        }
    }

    /// The rows, to be changed.
    #[inline(always)]
    pub fn rows_mut(&mut self) -> &mut [T] {
        match &mut self.numbers[self.first..] {
            [] => &mut [],
            numbers => bytemuck::cast_slice_mut(numbers),
        }
    }

    /// All numbers, row by row.
    pub fn numbers(&self) -> &[f64] {
        &self.numbers[self.first..]
    }

    /// Takes the rows of another table, in memory that is here already where it is enough.
    pub(crate) fn copy(&mut self, other: &Self) {
        if self.len() != other.len() {
            *self = Self::zeros(other.len());
        }
        self.rows_mut().copy_from_slice(other.rows());
    }

    /// So many rows, some of them those of this table; all others are forgotten and take no memory.
    pub(super) fn keep(&mut self, count: usize, some: impl Iterator<Item = Kept>) {
        let mut kept = Self::zeros(count);
        copy_kept(kept.rows_mut(), self.rows(), some);
        *self = kept;
    }
}

impl Rows {
    /// Adds a row.
    pub fn push(&mut self, vector: DVec3, scalar: f64) {
        self.push_row(Row { vector, scalar });
    }

    /// The number of a row.
    #[inline(always)]
    pub fn scalar(&self, index: usize) -> f64 {
        self.rows()[index].scalar
    }

    /// Puts the number of a row.
    pub fn set_scalar(&mut self, index: usize, scalar: f64) {
        self.rows_mut()[index].scalar = scalar;
    }

    /// The vectors.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = &DVec3> + Clone {
        self.rows().iter().map(|row| &row.vector)
    }

    /// The vectors, to be changed.
    pub fn iter_mut(&mut self) -> impl ExactSizeIterator<Item = &mut DVec3> {
        self.rows_mut().iter_mut().map(|row| &mut row.vector)
    }

    /// The numbers.
    pub fn scalars(&self) -> impl ExactSizeIterator<Item = f64> + Clone + '_ {
        self.rows().iter().map(|row| row.scalar)
    }

    /// Puts the same vector everywhere.
    pub fn fill(&mut self, vector: DVec3) {
        self.iter_mut().for_each(|v| *v = vector);
    }

    /// The rows as plain numbers.
    #[inline(always)]
    pub fn table(&self) -> &[[f64; 4]] {
        bytemuck::cast_slice(self.numbers())
    }

    /// The rows as plain numbers, to be changed.
    #[inline(always)]
    pub fn table_mut(&mut self) -> &mut [[f64; 4]] {
        bytemuck::cast_slice_mut(&mut self.numbers[self.first..])
    }
}

/// Numbers to leave out at the beginning of some memory so that what follows begins at a multiple of the size of a row.
fn numbers_to_skip<T>(numbers: &[f64]) -> usize {
    let address = numbers.as_ptr().addr();
    (address.next_multiple_of(size_of::<T>()) - address) / size_of::<f64>()
}

impl<T: Pod + Debug> Debug for Rows<T> {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> std::fmt::Result {
        self.rows().fmt(formatter)
    }
}

impl<T: Pod> Clone for Rows<T> {
    fn clone(&self) -> Self {
        let mut rows = Self::default();
        rows.copy(self);
        rows
    }
}

impl<T: Pod + PartialEq> PartialEq for Rows<T> {
    fn eq(&self, other: &Self) -> bool {
        self.rows() == other.rows()
    }
}

impl<T: Pod + Serialize> Serialize for Rows<T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.rows().serialize(serializer)
    }
}

impl<'a, T: Pod + Deserialize<'a>> Deserialize<'a> for Rows<T> {
    fn deserialize<D: Deserializer<'a>>(deserializer: D) -> Result<Self, D::Error> {
        let mut rows = Self::default();
        rows.extend(Vec::<T>::deserialize(deserializer)?.into_iter());
        Ok(rows)
    }
}

impl Index<usize> for Rows {
    type Output = DVec3;

    #[inline(always)]
    fn index(&self, index: usize) -> &DVec3 {
        &self.rows()[index].vector
    }
}

impl IndexMut<usize> for Rows {
    #[inline(always)]
    fn index_mut(&mut self, index: usize) -> &mut DVec3 {
        &mut self.rows_mut()[index].vector
    }
}
