//! Several contacts at a time: a formula that is written over [`Lanes`] runs on one `f64`, and on as many as the processor's
//! registers hold.
//!
//! Every operation is that of IEEE 754 in each lane: sums, products, quotients and roots are rounded once, products and sums
//! are never fused. So each lane holds the bits that the same formula gives for one `f64`, on any processor.
//!
//! [`run`] chooses the registers at run time. [`run_on_two`] takes two of them as one, if there are enough.

mod cube_root;
#[cfg(target_arch = "aarch64")]
mod neon;
mod quad;
mod scalar;
mod sums;
#[cfg(test)]
mod tests;
mod vector;
#[cfg(target_arch = "x86_64")]
mod x86;

pub use cube_root::{cube_root, rough_cube_root};
pub use quad::{Eight, Four, Quad, Two};
pub use sums::add_to_both;
pub use vector::{Vector, Vector3};

use std::fmt::Debug;
use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

/// Numbers side by side, on which one operation acts at once.
pub trait Lanes:
    Copy
    + Debug
    + Send
    + Sync
    + 'static
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + Add<f64, Output = Self>
    + Sub<f64, Output = Self>
    + Mul<f64, Output = Self>
    + Div<f64, Output = Self>
{
    /// How many numbers, at most [`MOST_LANES`].
    const COUNT: usize;
    /// One answer per lane.
    type Mask: Mask;
    /// Three of them: a vector per lane.
    type Vector: Vector<Self>;
    /// Four numbers per lane.
    type Rows: Copy + AsRef<[[f64; 4]]>;
    /// One row.
    type Quad: Quad;
    /// Two vectors of one lane, side by side.
    type Eight: Eight;
    /// These of every lane.
    type Eights: Copy + AsRef<[Self::Eight]>;
    /// As many of them as one register holds.
    type Register: Lanes;
    /// How many registers that are.
    const REGISTERS: usize = Self::COUNT / Self::Register::COUNT;

    /// One of the registers.
    fn register(self, which: usize) -> Self::Register;

    /// The same number in every lane.
    fn splat(value: f64) -> Self;
    /// The first [`Lanes::COUNT`] numbers of a slice, which must hold as many.
    fn load(from: &[f64]) -> Self;
    /// Puts the lanes at the front of a slice, which must hold as many.
    fn store(self, to: &mut [f64]);
    /// Puts the lanes at the front of a slice, which must hold as many, each rounded to the nearest number of half the precision, to the
    /// even one of two.
    #[inline(always)]
    fn store_singles(self, to: &mut [f32]) {
        let lanes = self.to_array();
        let mut lane = 0;
        while lane < Self::COUNT {
            to[lane] = lanes[lane] as f32;
            lane += 1;
        }
    }
    /// The first [`Lanes::COUNT`] numbers of a slice of numbers of half the precision, which must hold as many.
    #[inline(always)]
    fn load_singles(from: &[f32]) -> Self {
        Self::from_fn(|lane| f64::from(from[lane]))
    }
    /// The lanes as they lie in memory.
    fn as_slice(&self) -> &[f64];
    /// The lanes as they lie in memory, to be changed.
    fn as_mut_slice(&mut self) -> &mut [f64];
    /// Square root.
    fn sqrt(self) -> Self;
    /// Magnitude.
    fn abs(self) -> Self;
    /// `self > other`, `false` where one is not a number.
    fn gt(self, other: Self) -> Self::Mask;
    /// `self >= other`, `false` where one is not a number.
    fn ge(self, other: Self) -> Self::Mask;
    /// `yes` where the mask holds, `no` elsewhere.
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self;
    /// The columns of rows of four numbers, one row per lane: those of `values` from `starts` on.
    fn columns(values: &[f64], starts: &Places) -> [Self; 4];
    /// The columns of four numbers per lane, wherever they lie.
    fn of_rows(rows: &[&[f64; 4]; MOST_LANES]) -> [Self; 4];
    /// The rows of a table of four columns, one per lane.
    fn rows(columns: [Self; 4]) -> Self::Rows;
    /// Two vectors per lane as rows of eight numbers, with 0 behind each of them.
    fn side_by_side(first: Self::Vector, second: Self::Vector) -> Self::Eights;

    /// The columns of rows of some tables, one row per lane, the same in each: there must be as many indices as lanes.
    #[inline(always)]
    fn fetch<const N: usize>(tables: [&[[f64; 4]]; N], index: &[u32]) -> [[Self; 4]; N] {
        let mut columns = [[Self::splat(0.0); 4]; N];
        let mut table = 0;
        while table < N {
            let mut rows = [&[0.0; 4]; MOST_LANES];
            let mut lane = 0;
            while lane < Self::COUNT {
                rows[lane] = &tables[table][index[lane] as usize];
                lane += 1;
            }
            columns[table] = Self::of_rows(&rows);
            table += 1;
        }
        columns
    }

    /// The columns of rows that follow each other at a distance of `stride` numbers, one per lane.
    #[inline(always)]
    fn strided(values: &[f64], start: usize, stride: usize) -> [Self; 4] {
        let mut places = [0; MOST_LANES];
        let mut lane = 0;
        while lane < Self::COUNT {
            places[lane] = start + stride * lane;
            lane += 1;
        }
        Self::columns(values, &places)
    }

    /// Puts the rows of four columns at a distance of `stride` numbers, one per lane.
    #[inline(always)]
    fn put_strided(columns: [Self; 4], values: &mut [f64], start: usize, stride: usize) {
        let rows = Self::rows(columns);
        let mut lane = 0;
        while lane < Self::COUNT {
            let first = start + stride * lane;
            values[first..first + 4].copy_from_slice(&rows.as_ref()[lane]);
            lane += 1;
        }
    }

    /// One number of `values` per lane.
    fn gather(values: &[f64], places: &Places) -> Self;

    /// `self < other`, `false` where one is not a number.
    #[inline(always)]
    fn lt(self, other: Self) -> Self::Mask {
        other.gt(self)
    }

    /// The larger of two numbers; `other` where one is not a number or both are the same.
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        Self::select(self.gt(other), self, other)
    }

    /// The smaller of two numbers; `other` where one is not a number or both are the same.
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        Self::select(other.gt(self), self, other)
    }

    /// This where the mask holds, 0 elsewhere.
    #[inline(always)]
    fn keep(self, mask: Self::Mask) -> Self {
        Self::select(mask, self, Self::splat(0.0))
    }

    /// Lane by lane.
    #[inline(always)]
    fn from_fn(lane: impl FnMut(usize) -> f64) -> Self {
        let all: [f64; MOST_LANES] = first_lanes(Self::COUNT, lane);
        Self::load(&all)
    }

    /// The lanes as numbers; those beyond [`Lanes::COUNT`] are 0.
    #[inline(always)]
    fn to_array(self) -> [f64; MOST_LANES] {
        let mut all = [0.0; MOST_LANES];
        self.store(&mut all);
        all
    }
}

/// The first `count` values, 0 behind them.
#[inline(always)]
fn first_lanes(count: usize, mut lane: impl FnMut(usize) -> f64) -> [f64; MOST_LANES] {
    let mut all = [0.0; MOST_LANES];
    for (k, value) in all.iter_mut().enumerate().take(count) {
        *value = lane(k);
    }
    all
}

/// One answer per lane.
pub trait Mask: Copy + BitAnd<Output = Self> + BitOr<Output = Self> + Not<Output = Self> {
    /// The answers as bits: lane `k` is bit `k`.
    fn bits(self) -> u32;
    /// Answers out of bits; those beyond the lanes do not matter.
    fn of_bits(bits: u32) -> Self;

    /// Whether it holds in some lane.
    #[inline(always)]
    fn any(self) -> bool {
        self.bits() != 0
    }
}

/// Has what will be read soon fetched into the caches, on processors that can be told.
#[inline(always)]
pub fn fetch_ahead<T>(place: &T) {
    #[cfg(target_arch = "x86_64")]
    x86::fetch_ahead(place);
    #[cfg(not(target_arch = "x86_64"))]
    let _ = place;
}

/// Components of a vector per lane, and 0.
#[inline(always)]
pub fn with_zero<L: Lanes>(vector: L::Vector) -> [L; 4] {
    let [x, y, z] = vector.components();
    [x, y, z, L::splat(0.0)]
}

/// A place in a slice per lane.
pub type Places = [usize; MOST_LANES];

/// A row of a table per lane.
pub type Index = [u32; MOST_LANES];

/// The largest number of lanes.
pub const MOST_LANES: usize = 16;

/// Work that is written over [`Lanes`].
pub trait Kernel {
    /// What the work gives.
    type Output;
    /// Does the work; to be marked `#[inline(always)]`, as all that it calls, so that it is compiled for the registers.
    fn run<L: Lanes>(self) -> Self::Output;
}

/// Instructions of the processor that kernels are run with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Instructions {
    /// One lane; on every processor.
    Portable,
    /// Two lanes of ARMv8.
    Neon,
    /// Four lanes of x86-64.
    Avx2,
    /// Eight lanes of x86-64.
    Avx512,
}

impl Instructions {
    /// Those of this processor, widest first.
    pub fn available() -> Vec<Self> {
        let mut found = Vec::new();
        #[cfg(target_arch = "x86_64")]
        {
            if x86::has_avx512() {
                found.push(Self::Avx512);
            }
            if std::arch::is_x86_feature_detected!("avx2") {
                found.push(Self::Avx2);
            }
        }
        #[cfg(target_arch = "aarch64")]
        found.push(Self::Neon);
        found.push(Self::Portable);
        found
    }

    /// Those of a name, if this processor has them.
    pub fn named(name: &str) -> Result<Self, NoSuchInstructions> {
        let available = Self::available();
        match available.iter().find(|instructions| instructions.name() == name) {
            Some(found) => Ok(*found),
            None => Err(NoSuchInstructions {
                name: name.to_owned(),
                available,
            }),
        }
    }

    /// The widest of this processor.
    pub fn widest() -> Self {
        Self::available()[0]
    }

    /// Name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Portable => "portable",
            Self::Neon => "neon",
            Self::Avx2 => "avx2",
            Self::Avx512 => "avx512",
        }
    }
}

/// Instructions were asked for that this processor does not have, or that do not exist.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "this processor has no instructions `{name}`; it has {}, and the results are the same with all",
    listed(available)
)]
pub struct NoSuchInstructions {
    /// What was asked for.
    pub name: String,
    /// What there is, widest first.
    pub available: Vec<Instructions>,
}

fn listed(instructions: &[Instructions]) -> String {
    let names: Vec<String> = instructions.iter().map(|i| format!("`{}`", i.name())).collect();
    names.join(", ")
}

/// Runs a kernel with instructions that this processor has ([`Instructions::available`]); with others it runs portably.
#[inline]
pub fn run<K: Kernel>(instructions: Instructions, kernel: K) -> K::Output {
    match instructions {
        #[cfg(target_arch = "x86_64")]
        Instructions::Avx512 if x86::has_avx512() => x86::run_avx512(kernel),
        _ => run_on_narrower(instructions, kernel),
    }
}

/// The same with two registers at a time where the processor has enough of them: in long formulas one computes while the other waits
/// for roots, quotients, or memory, and the same bits come out.
#[inline]
pub fn run_on_two<K: Kernel>(instructions: Instructions, kernel: K) -> K::Output {
    match instructions {
        #[cfg(target_arch = "x86_64")]
        Instructions::Avx512 if x86::has_avx512() => x86::run_two_avx512(kernel),
        _ => run_on_narrower(instructions, kernel),
    }
}

/// The same on registers narrower than those of AVX-512.
#[inline]
fn run_on_narrower<K: Kernel>(instructions: Instructions, kernel: K) -> K::Output {
    match instructions {
        #[cfg(target_arch = "x86_64")]
        Instructions::Avx2 if std::arch::is_x86_feature_detected!("avx2") => x86::run_avx2(kernel),
        #[cfg(target_arch = "aarch64")]
        Instructions::Neon => kernel.run::<neon::F64x2>(),
        _ => kernel.run::<f64>(),
    }
}
