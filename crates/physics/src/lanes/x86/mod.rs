//! Four, eight, and sixteen lanes of x86-64.
//!
//! Unsafe because instructions are used that not every processor has. The types here are made by [`run_avx2`],
//! [`run_avx512`] and [`run_two_avx512`] alone, which [`super::run`] and [`super::run_on_two`] call only where the processor has them.
#![allow(unsafe_code)]

macro_rules! arithmetic {
    ($lanes:ident, $($operator:ident $method:ident $instruction:ident;)*) => {
        $(
            impl $operator for $lanes {
                type Output = Self;
                #[inline(always)]
                fn $method(self, other: Self) -> Self {
                    // SAFETY: see above
                    Self(unsafe { $instruction(self.0, other.0) })
                }
            }

            impl $operator<f64> for $lanes {
                type Output = Self;
                #[inline(always)]
                fn $method(self, other: f64) -> Self {
                    self.$method(Self::splat(other))
                }
            }
        )*

        impl Neg for $lanes {
            type Output = Self;
            #[inline(always)]
            fn neg(self) -> Self {
                self.flip_sign()
            }
        }
    };
}

mod avx2;
mod avx512;
mod two_avx512;

use super::{Kernel, MOST_LANES};
use avx2::F64x4;
use avx512::F64x8;
use std::arch::x86_64::*;
use std::ops::Range;
use two_avx512::F64x16;

/// Whether this processor has AVX-512 as all servers do: also for registers of 128 and 256 bits, for bits, bytes and words.
#[inline]
pub(super) fn has_avx512() -> bool {
    std::arch::is_x86_feature_detected!("avx512f")
        && std::arch::is_x86_feature_detected!("avx512vl")
        && std::arch::is_x86_feature_detected!("avx512dq")
        && std::arch::is_x86_feature_detected!("avx512bw")
        && std::arch::is_x86_feature_detected!("avx2")
}

/// Runs a kernel with AVX-512, which the processor must have.
#[inline]
pub(super) fn run_avx512<K: Kernel>(kernel: K) -> K::Output {
    #[target_feature(enable = "avx512f,avx512vl,avx512dq,avx512bw,avx2")]
    fn inner<K: Kernel>(kernel: K) -> K::Output {
        kernel.run::<F64x8>()
    }
    // SAFETY: the caller has asked the processor
    unsafe { inner(kernel) }
}

/// Runs a kernel with two registers of AVX-512 at a time, which the processor must have.
#[inline]
pub(super) fn run_two_avx512<K: Kernel>(kernel: K) -> K::Output {
    #[target_feature(enable = "avx512f,avx512vl,avx512dq,avx512bw,avx2")]
    fn inner<K: Kernel>(kernel: K) -> K::Output {
        kernel.run::<F64x16>()
    }
    // SAFETY: the caller has asked the processor
    unsafe { inner(kernel) }
}

/// Runs a kernel with AVX2, which the processor must have.
#[inline]
pub(super) fn run_avx2<K: Kernel>(kernel: K) -> K::Output {
    #[target_feature(enable = "avx2")]
    fn inner<K: Kernel>(kernel: K) -> K::Output {
        kernel.run::<F64x4>()
    }
    // SAFETY: the caller has asked the processor
    unsafe { inner(kernel) }
}

/// Asserts that `width` numbers are there from all of these places on.
#[inline(always)]
fn check<const N: usize>(values: &[f64], places: &[usize; N], width: usize) {
    let mut last = places[0];
    let mut lane = 1;
    while lane < N {
        last = if places[lane] > last { places[lane] } else { last };
        lane += 1;
    }
    assert!(values.len() >= width && last <= values.len() - width);
}

/// The numbers of rows of four at a distance, all of which must be among `count` numbers.
#[inline(always)]
fn stretch(count: usize, rows: usize, start: usize, stride: usize) -> Range<usize> {
    // a longer distance could come round to a place among them
    assert!(stride <= count);
    start..start + (rows - 1) * stride + 4
}

/// Has what lies at a place fetched into the caches.
#[inline(always)]
pub(super) fn fetch_ahead<T>(place: &T) {
    // SAFETY: nothing is read, and every x86-64 has the instruction
    unsafe { _mm_prefetch::<_MM_HINT_T0>(std::ptr::from_ref(place).cast()) }
}

/// Four numbers in a register.
///
/// # Safety
/// They must be there.
#[inline(always)]
unsafe fn row(values: &[f64], start: usize) -> __m256d {
    // SAFETY: as the caller promises
    unsafe { _mm256_loadu_pd(values.as_ptr().add(start)) }
}

/// Puts four numbers.
///
/// # Safety
/// There must be room for them.
#[inline(always)]
unsafe fn put_row(values: &mut [f64], start: usize, row: __m256d) {
    // SAFETY: as the caller promises
    unsafe { _mm256_storeu_pd(values.as_mut_ptr().add(start), row) }
}

/// One number.
///
/// # Safety
/// It must be there.
#[inline(always)]
unsafe fn one(values: &[f64], place: usize) -> f64 {
    // SAFETY: as the caller promises
    unsafe { *values.get_unchecked(place) }
}

/// Four numbers out of a register.
#[inline(always)]
fn put(row: __m256d) -> [f64; 4] {
    // SAFETY: both are 32 bytes of four numbers
    unsafe { std::mem::transmute(row) }
}

/// Asserts that every table has a row of this index.
#[inline(always)]
fn check_rows<const N: usize>(tables: &[&[[f64; 4]]; N], index: u32) {
    let mut table = 0;
    while table < N {
        assert!((index as usize) < tables[table].len());
        table += 1;
    }
}

/// The first of some indices, of which there must be as many.
#[inline(always)]
fn first<const N: usize>(index: &[u32]) -> &[u32; N] {
    &index.as_chunks().0[0]
}

/// Indices read one after the other: the compiler would read all at once, and each that is taken out of a register takes two turns
/// where registers are shuffled, which the kernels need most.
#[inline(always)]
fn one_by_one<const N: usize>(index: &[u32; N]) -> [u32; N] {
    let mut separate = [0; N];
    let mut lane = 0;
    while lane < N {
        // SAFETY: a reference can be read
        separate[lane] = unsafe { std::ptr::read_volatile(&raw const index[lane]) };
        lane += 1;
    }
    separate
}

/// A row of a table in a register.
///
/// # Safety
/// It must be there.
#[inline(always)]
unsafe fn at(table: &[[f64; 4]], index: u32) -> __m256d {
    // SAFETY: as the caller promises
    unsafe { _mm256_loadu_pd(table.as_ptr().add(index as usize).cast()) }
}

/// A row in a register.
#[inline(always)]
fn whole(row: &[f64; 4]) -> __m256d {
    // SAFETY: see above; four numbers are there
    unsafe { _mm256_loadu_pd(row.as_ptr()) }
}

/// What there is for as many lanes as there may be, by so many lanes at a time.
#[inline(always)]
fn by<const N: usize, T>(all: &[T; MOST_LANES]) -> &[[T; N]] {
    all.as_chunks().0
}
