//! Four and eight lanes of x86-64.
//!
//! Unsafe because instructions are used that not every processor has. The types here are made by [`run_avx2`] and
//! [`run_avx512`] alone, which [`super::run`] calls only where the processor has them.
#![allow(unsafe_code)]

use super::{Index, Kernel, Lanes, MOST_LANES, Mask, Places, Quad, Vector3};
use std::arch::x86_64::*;
use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

/// Eight lanes of AVX-512.
#[derive(Clone, Copy, Debug)]
#[repr(transparent)]
pub(super) struct F64x8(__m512d);

/// Four lanes of AVX2.
#[derive(Clone, Copy, Debug)]
#[repr(transparent)]
pub(super) struct F64x4(__m256d);

/// Runs a kernel with AVX-512, which the processor must have.
#[inline]
pub(super) fn run_avx512<K: Kernel>(kernel: K) -> K::Output {
    #[target_feature(enable = "avx512f,avx2")]
    fn inner<K: Kernel>(kernel: K) -> K::Output {
        kernel.run::<F64x8>()
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

/// Fetches a line of the cache.
#[inline(always)]
pub(super) fn prefetch<T>(soon: &T) {
    // SAFETY: every processor of this kind has it, and it changes nothing that a program can see
    unsafe { _mm_prefetch::<_MM_HINT_T0>(std::ptr::from_ref(soon).cast()) }
}

macro_rules! arithmetic {
    ($lanes:ident, $($operator:ident $method:ident $instruction:ident;)*) => {
        $(
            impl $operator for $lanes {
                type Output = Self;
                #[inline(always)]
                fn $method(self, other: Self) -> Self {
                    // SAFETY: see the top of this file
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

arithmetic! { F64x8, Add add _mm512_add_pd; Sub sub _mm512_sub_pd; Mul mul _mm512_mul_pd; Div div _mm512_div_pd; }
arithmetic! { F64x4, Add add _mm256_add_pd; Sub sub _mm256_sub_pd; Mul mul _mm256_mul_pd; Div div _mm256_div_pd; }

impl F64x8 {
    #[inline(always)]
    fn flip_sign(self) -> Self {
        // SAFETY: see the top of this file
        unsafe {
            let sign = _mm512_set1_epi64(i64::MIN);
            Self(_mm512_castsi512_pd(_mm512_xor_si512(_mm512_castpd_si512(self.0), sign)))
        }
    }
}

impl F64x4 {
    #[inline(always)]
    fn flip_sign(self) -> Self {
        // SAFETY: see the top of this file
        Self(unsafe { _mm256_xor_pd(self.0, _mm256_set1_pd(-0.0)) })
    }
}

/// Answers of eight lanes.
#[derive(Clone, Copy)]
pub(super) struct Mask8(__mmask8);

impl Mask for Mask8 {
    #[inline(always)]
    fn bits(self) -> u32 {
        u32::from(self.0)
    }

    #[inline(always)]
    fn of_bits(bits: u32) -> Self {
        Self(bits as u8)
    }
}

impl BitAnd for Mask8 {
    type Output = Self;
    #[inline(always)]
    fn bitand(self, other: Self) -> Self {
        Self(self.0 & other.0)
    }
}

impl BitOr for Mask8 {
    type Output = Self;
    #[inline(always)]
    fn bitor(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }
}

impl Not for Mask8 {
    type Output = Self;
    #[inline(always)]
    fn not(self) -> Self {
        Self(!self.0)
    }
}

/// Answers of four lanes: all bits of a lane, or none.
#[derive(Clone, Copy)]
pub(super) struct Mask4(__m256d);

impl Mask for Mask4 {
    #[inline(always)]
    fn bits(self) -> u32 {
        // SAFETY: see the top of this file
        (unsafe { _mm256_movemask_pd(self.0) }) as u32
    }

    #[inline(always)]
    fn of_bits(bits: u32) -> Self {
        // SAFETY: see the top of this file
        unsafe {
            let lanes = _mm256_setr_epi64x(1, 2, 4, 8);
            let chosen = _mm256_and_si256(_mm256_set1_epi64x(i64::from(bits)), lanes);
            Self(_mm256_castsi256_pd(_mm256_cmpeq_epi64(chosen, lanes)))
        }
    }
}

impl BitAnd for Mask4 {
    type Output = Self;
    #[inline(always)]
    fn bitand(self, other: Self) -> Self {
        // SAFETY: see the top of this file
        Self(unsafe { _mm256_and_pd(self.0, other.0) })
    }
}

impl BitOr for Mask4 {
    type Output = Self;
    #[inline(always)]
    fn bitor(self, other: Self) -> Self {
        // SAFETY: see the top of this file
        Self(unsafe { _mm256_or_pd(self.0, other.0) })
    }
}

impl Not for Mask4 {
    type Output = Self;
    #[inline(always)]
    fn not(self) -> Self {
        // SAFETY: see the top of this file
        Self(unsafe { _mm256_xor_pd(self.0, _mm256_castsi256_pd(_mm256_set1_epi64x(-1))) })
    }
}

/// Asserts that `width` numbers are there from all of the first places on.
#[inline(always)]
fn check(values: &[f64], places: &Places, lanes: usize, width: usize) {
    let mut last = places[0];
    let mut lane = 1;
    while lane < lanes {
        last = if places[lane] > last { places[lane] } else { last };
        lane += 1;
    }
    assert!(values.len() >= width && last <= values.len() - width);
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

impl Lanes for F64x8 {
    const COUNT: usize = 8;
    type Mask = Mask8;
    type Vector = Vector3<Self>;
    type Rows = [[f64; 4]; 8];
    type Quad = F64x4;

    #[inline(always)]
    fn splat(value: f64) -> Self {
        // SAFETY: see the top of this file
        Self(unsafe { _mm512_set1_pd(value) })
    }

    #[inline(always)]
    fn load(from: &[f64]) -> Self {
        let from = &from[..8];
        // SAFETY: eight numbers are there
        Self(unsafe { _mm512_loadu_pd(from.as_ptr()) })
    }

    #[inline(always)]
    fn store(self, to: &mut [f64]) {
        let to = &mut to[..8];
        // SAFETY: there is room for eight numbers
        unsafe { _mm512_storeu_pd(to.as_mut_ptr(), self.0) }
    }

    #[inline(always)]
    fn as_slice(&self) -> &[f64] {
        // SAFETY: a register is its lanes, and nothing else
        unsafe { std::slice::from_raw_parts(std::ptr::from_ref(self).cast(), Self::COUNT) }
    }

    #[inline(always)]
    fn as_mut_slice(&mut self) -> &mut [f64] {
        // SAFETY: a register is its lanes, and nothing else
        unsafe { std::slice::from_raw_parts_mut(std::ptr::from_mut(self).cast(), Self::COUNT) }
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        // SAFETY: see the top of this file
        Self(unsafe { _mm512_sqrt_pd(self.0) })
    }

    #[inline(always)]
    fn abs(self) -> Self {
        // SAFETY: see the top of this file
        Self(unsafe { _mm512_abs_pd(self.0) })
    }

    #[inline(always)]
    fn gt(self, other: Self) -> Mask8 {
        // SAFETY: see the top of this file
        Mask8(unsafe { _mm512_cmp_pd_mask::<_CMP_GT_OQ>(self.0, other.0) })
    }

    #[inline(always)]
    fn ge(self, other: Self) -> Mask8 {
        // SAFETY: see the top of this file
        Mask8(unsafe { _mm512_cmp_pd_mask::<_CMP_GE_OQ>(self.0, other.0) })
    }

    #[inline(always)]
    fn select(mask: Mask8, yes: Self, no: Self) -> Self {
        // SAFETY: see the top of this file
        Self(unsafe { _mm512_mask_blend_pd(mask.0, no.0, yes.0) })
    }

    #[inline(always)]
    fn gather(values: &[f64], p: &Places) -> Self {
        check(values, p, 8, 1);
        // SAFETY: see the top of this file; the numbers are there
        unsafe {
            let [a, b] = [one(values, p[0]), one(values, p[1])];
            let [c, d] = [one(values, p[2]), one(values, p[3])];
            let [e, f] = [one(values, p[4]), one(values, p[5])];
            let [g, h] = [one(values, p[6]), one(values, p[7])];
            Self(_mm512_setr_pd(a, b, c, d, e, f, g, h))
        }
    }

    #[inline(always)]
    fn columns(values: &[f64], starts: &Places) -> [Self; 4] {
        check(values, starts, 8, 4);
        // SAFETY: the numbers are there
        unsafe {
            eight_rows([
                row(values, starts[0]),
                row(values, starts[1]),
                row(values, starts[2]),
                row(values, starts[3]),
                row(values, starts[4]),
                row(values, starts[5]),
                row(values, starts[6]),
                row(values, starts[7]),
            ])
        }
    }

    #[inline(always)]
    fn of_rows(rows: &[&[f64; 4]; MOST_LANES]) -> [Self; 4] {
        eight_rows([
            whole(rows[0]),
            whole(rows[1]),
            whole(rows[2]),
            whole(rows[3]),
            whole(rows[4]),
            whole(rows[5]),
            whole(rows[6]),
            whole(rows[7]),
        ])
    }

    #[inline(always)]
    fn fetch<const N: usize>(tables: [&[[f64; 4]]; N], index: &Index) -> [[Self; 4]; N] {
        check_rows(&tables, largest_of_eight(index));
        let mut columns = [[Self::splat(0.0); 4]; N];
        let mut table = 0;
        while table < N {
            let rows = tables[table];
            // SAFETY: all these rows are there
            columns[table] = eight_rows(unsafe {
                [
                    at(rows, index[0]),
                    at(rows, index[1]),
                    at(rows, index[2]),
                    at(rows, index[3]),
                    at(rows, index[4]),
                    at(rows, index[5]),
                    at(rows, index[6]),
                    at(rows, index[7]),
                ]
            });
            table += 1;
        }
        columns
    }

    #[inline(always)]
    fn strided(values: &[f64], start: usize, stride: usize) -> [Self; 4] {
        let values = &values[start..start + 7 * stride + 4];
        // SAFETY: all these rows are there
        eight_rows(unsafe {
            [
                row(values, 0),
                row(values, stride),
                row(values, 2 * stride),
                row(values, 3 * stride),
                row(values, 4 * stride),
                row(values, 5 * stride),
                row(values, 6 * stride),
                row(values, 7 * stride),
            ]
        })
    }

    #[inline(always)]
    fn rows([a, b, c, d]: [Self; 4]) -> [[f64; 4]; 8] {
        // SAFETY: see the top of this file
        unsafe {
            let (low_ab, high_ab) = (_mm512_unpacklo_pd(a.0, b.0), _mm512_unpackhi_pd(a.0, b.0));
            let (low_cd, high_cd) = (_mm512_unpacklo_pd(c.0, d.0), _mm512_unpackhi_pd(c.0, d.0));
            let even = _mm512_setr_epi64(0, 1, 8, 9, 4, 5, 12, 13);
            let odd = _mm512_setr_epi64(2, 3, 10, 11, 6, 7, 14, 15);
            let r04 = _mm512_permutex2var_pd(low_ab, even, low_cd);
            let r26 = _mm512_permutex2var_pd(low_ab, odd, low_cd);
            let r15 = _mm512_permutex2var_pd(high_ab, even, high_cd);
            let r37 = _mm512_permutex2var_pd(high_ab, odd, high_cd);
            [
                put(_mm512_castpd512_pd256(r04)),
                put(_mm512_castpd512_pd256(r15)),
                put(_mm512_castpd512_pd256(r26)),
                put(_mm512_castpd512_pd256(r37)),
                put(_mm512_extractf64x4_pd::<1>(r04)),
                put(_mm512_extractf64x4_pd::<1>(r15)),
                put(_mm512_extractf64x4_pd::<1>(r26)),
                put(_mm512_extractf64x4_pd::<1>(r37)),
            ]
        }
    }
}

impl Lanes for F64x4 {
    const COUNT: usize = 4;
    type Mask = Mask4;
    type Vector = Vector3<Self>;
    type Rows = [[f64; 4]; 4];
    type Quad = F64x4;

    #[inline(always)]
    fn splat(value: f64) -> Self {
        // SAFETY: see the top of this file
        Self(unsafe { _mm256_set1_pd(value) })
    }

    #[inline(always)]
    fn load(from: &[f64]) -> Self {
        let from = &from[..4];
        // SAFETY: four numbers are there
        Self(unsafe { _mm256_loadu_pd(from.as_ptr()) })
    }

    #[inline(always)]
    fn store(self, to: &mut [f64]) {
        let to = &mut to[..4];
        // SAFETY: there is room for four numbers
        unsafe { _mm256_storeu_pd(to.as_mut_ptr(), self.0) }
    }

    #[inline(always)]
    fn as_slice(&self) -> &[f64] {
        // SAFETY: a register is its lanes, and nothing else
        unsafe { std::slice::from_raw_parts(std::ptr::from_ref(self).cast(), Self::COUNT) }
    }

    #[inline(always)]
    fn as_mut_slice(&mut self) -> &mut [f64] {
        // SAFETY: a register is its lanes, and nothing else
        unsafe { std::slice::from_raw_parts_mut(std::ptr::from_mut(self).cast(), Self::COUNT) }
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        // SAFETY: see the top of this file
        Self(unsafe { _mm256_sqrt_pd(self.0) })
    }

    #[inline(always)]
    fn abs(self) -> Self {
        // SAFETY: see the top of this file
        Self(unsafe { _mm256_andnot_pd(_mm256_set1_pd(-0.0), self.0) })
    }

    #[inline(always)]
    fn gt(self, other: Self) -> Mask4 {
        // SAFETY: see the top of this file
        Mask4(unsafe { _mm256_cmp_pd::<_CMP_GT_OQ>(self.0, other.0) })
    }

    #[inline(always)]
    fn ge(self, other: Self) -> Mask4 {
        // SAFETY: see the top of this file
        Mask4(unsafe { _mm256_cmp_pd::<_CMP_GE_OQ>(self.0, other.0) })
    }

    #[inline(always)]
    fn select(mask: Mask4, yes: Self, no: Self) -> Self {
        // SAFETY: see the top of this file
        Self(unsafe { _mm256_blendv_pd(no.0, yes.0, mask.0) })
    }

    #[inline(always)]
    fn gather(values: &[f64], p: &Places) -> Self {
        check(values, p, 4, 1);
        // SAFETY: see the top of this file; the numbers are there
        unsafe {
            let [a, b] = [one(values, p[0]), one(values, p[1])];
            let [c, d] = [one(values, p[2]), one(values, p[3])];
            Self(_mm256_setr_pd(a, b, c, d))
        }
    }

    #[inline(always)]
    fn columns(values: &[f64], starts: &Places) -> [Self; 4] {
        check(values, starts, 4, 4);
        // SAFETY: the numbers are there
        let rows = unsafe {
            [
                row(values, starts[0]),
                row(values, starts[1]),
                row(values, starts[2]),
                row(values, starts[3]),
            ]
        };
        let [a, b, c, d] = transposed(rows);
        [Self(a), Self(b), Self(c), Self(d)]
    }

    #[inline(always)]
    fn of_rows(rows: &[&[f64; 4]; MOST_LANES]) -> [Self; 4] {
        let [a, b, c, d] = transposed([whole(rows[0]), whole(rows[1]), whole(rows[2]), whole(rows[3])]);
        [Self(a), Self(b), Self(c), Self(d)]
    }

    #[inline(always)]
    fn fetch<const N: usize>(tables: [&[[f64; 4]]; N], index: &Index) -> [[Self; 4]; N] {
        let most = index[0].max(index[1]).max(index[2].max(index[3]));
        check_rows(&tables, most);
        let mut columns = [[Self::splat(0.0); 4]; N];
        let mut table = 0;
        while table < N {
            let rows = tables[table];
            // SAFETY: all these rows are there
            let rows = unsafe {
                [
                    at(rows, index[0]),
                    at(rows, index[1]),
                    at(rows, index[2]),
                    at(rows, index[3]),
                ]
            };
            let [a, b, c, d] = transposed(rows);
            columns[table] = [Self(a), Self(b), Self(c), Self(d)];
            table += 1;
        }
        columns
    }

    #[inline(always)]
    fn rows([a, b, c, d]: [Self; 4]) -> [[f64; 4]; 4] {
        let [first, second, third, fourth] = transposed([a.0, b.0, c.0, d.0]);
        [put(first), put(second), put(third), put(fourth)]
    }
}

impl Quad for F64x4 {
    #[inline(always)]
    fn load(from: &[f64; 4]) -> Self {
        Self(whole(from))
    }

    #[inline(always)]
    fn store(self) -> [f64; 4] {
        put(self.0)
    }

    #[inline(always)]
    fn all(value: f64) -> Self {
        Self::splat(value)
    }

    #[inline(always)]
    fn largest(self, other: Self) -> Self {
        // SAFETY: see the top of this file
        Self(unsafe { _mm256_max_pd(other.abs().0, self.abs().0) })
    }

    #[inline(always)]
    fn lies_within(self, lower: Self, upper: Self) -> bool {
        (self.ge(lower) & upper.ge(self)).bits() == 0b1111
    }
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

/// The largest of eight numbers.
#[inline(always)]
fn largest_of_eight(index: &Index) -> u32 {
    // SAFETY: see the top of this file; eight numbers are there
    unsafe {
        let all = _mm256_loadu_si256(index.as_ptr().cast());
        let four = _mm_max_epu32(_mm256_castsi256_si128(all), _mm256_extracti128_si256::<1>(all));
        let two = _mm_max_epu32(four, _mm_shuffle_epi32::<0b01_00_11_10>(four));
        let one = _mm_max_epu32(two, _mm_shuffle_epi32::<0b10_11_00_01>(two));
        _mm_cvtsi128_si32(one) as u32
    }
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
    // SAFETY: see the top of this file; four numbers are there
    unsafe { _mm256_loadu_pd(row.as_ptr()) }
}

/// Columns of eight rows of four.
#[inline(always)]
fn eight_rows(rows: [__m256d; 8]) -> [F64x8; 4] {
    // no closures here: they would be compiled without the instructions
    // SAFETY: see the top of this file
    unsafe {
        let r04 = _mm512_insertf64x4::<1>(_mm512_castpd256_pd512(rows[0]), rows[4]);
        let r15 = _mm512_insertf64x4::<1>(_mm512_castpd256_pd512(rows[1]), rows[5]);
        let r26 = _mm512_insertf64x4::<1>(_mm512_castpd256_pd512(rows[2]), rows[6]);
        let r37 = _mm512_insertf64x4::<1>(_mm512_castpd256_pd512(rows[3]), rows[7]);
        let (low01, high01) = (_mm512_unpacklo_pd(r04, r15), _mm512_unpackhi_pd(r04, r15));
        let (low23, high23) = (_mm512_unpacklo_pd(r26, r37), _mm512_unpackhi_pd(r26, r37));
        let even = _mm512_setr_epi64(0, 1, 8, 9, 4, 5, 12, 13);
        let odd = _mm512_setr_epi64(2, 3, 10, 11, 6, 7, 14, 15);
        [
            F64x8(_mm512_permutex2var_pd(low01, even, low23)),
            F64x8(_mm512_permutex2var_pd(high01, even, high23)),
            F64x8(_mm512_permutex2var_pd(low01, odd, low23)),
            F64x8(_mm512_permutex2var_pd(high01, odd, high23)),
        ]
    }
}

/// Four rows of four, with rows and columns exchanged.
#[inline(always)]
fn transposed([a, b, c, d]: [__m256d; 4]) -> [__m256d; 4] {
    // SAFETY: see the top of this file
    unsafe {
        let (low_ab, high_ab) = (_mm256_unpacklo_pd(a, b), _mm256_unpackhi_pd(a, b));
        let (low_cd, high_cd) = (_mm256_unpacklo_pd(c, d), _mm256_unpackhi_pd(c, d));
        [
            _mm256_permute2f128_pd::<0x20>(low_ab, low_cd),
            _mm256_permute2f128_pd::<0x20>(high_ab, high_cd),
            _mm256_permute2f128_pd::<0x31>(low_ab, low_cd),
            _mm256_permute2f128_pd::<0x31>(high_ab, high_cd),
        ]
    }
}
