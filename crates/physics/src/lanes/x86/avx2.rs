//! Four lanes of AVX2.

use super::{at, by, check, check_rows, first, one, one_by_one, put, put_row, row, stretch, whole};
use crate::lanes::{Lanes, MOST_LANES, Mask, Places, Quad, Two, Vector3, with_zero};
use std::arch::x86_64::*;
use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

/// Four lanes of AVX2.
#[derive(Clone, Copy, Debug)]
#[repr(transparent)]
pub(in crate::lanes) struct F64x4(__m256d);

arithmetic! { F64x4, Add add _mm256_add_pd; Sub sub _mm256_sub_pd; Mul mul _mm256_mul_pd; Div div _mm256_div_pd; }

impl F64x4 {
    #[inline(always)]
    fn flip_sign(self) -> Self {
        // SAFETY: see the top of the module
        Self(unsafe { _mm256_xor_pd(self.0, _mm256_set1_pd(-0.0)) })
    }
}

/// Answers of four lanes: all bits of a lane, or none.
#[derive(Clone, Copy)]
pub(in crate::lanes) struct Mask4(__m256d);

impl Mask for Mask4 {
    #[inline(always)]
    fn bits(self) -> u32 {
        // SAFETY: see the top of the module
        (unsafe { _mm256_movemask_pd(self.0) }) as u32
    }

    #[inline(always)]
    fn of_bits(bits: u32) -> Self {
        // SAFETY: see the top of the module
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
        // SAFETY: see the top of the module
        Self(unsafe { _mm256_and_pd(self.0, other.0) })
    }
}

impl BitOr for Mask4 {
    type Output = Self;
    #[inline(always)]
    fn bitor(self, other: Self) -> Self {
        // SAFETY: see the top of the module
        Self(unsafe { _mm256_or_pd(self.0, other.0) })
    }
}

impl Not for Mask4 {
    type Output = Self;
    #[inline(always)]
    fn not(self) -> Self {
        // SAFETY: see the top of the module
        Self(unsafe { _mm256_xor_pd(self.0, _mm256_castsi256_pd(_mm256_set1_epi64x(-1))) })
    }
}

impl Lanes for F64x4 {
    const COUNT: usize = 4;
    type Mask = Mask4;
    type Vector = Vector3<Self>;
    type Rows = [[f64; 4]; 4];
    type Quad = F64x4;
    type Eight = Two<Self>;
    type Eights = [Two<Self>; 4];
    type Register = Self;

    #[inline(always)]
    fn register(self, _: usize) -> Self {
        self
    }

    #[inline(always)]
    fn splat(value: f64) -> Self {
        // SAFETY: see the top of the module
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
    fn store_singles(self, to: &mut [f32]) {
        let to = &mut to[..4];
        // SAFETY: there is room for four numbers
        unsafe { _mm_storeu_ps(to.as_mut_ptr(), _mm256_cvtpd_ps(self.0)) }
    }

    #[inline(always)]
    fn load_singles(from: &[f32]) -> Self {
        let from = &from[..4];
        // SAFETY: four numbers are there
        Self(unsafe { _mm256_cvtps_pd(_mm_loadu_ps(from.as_ptr())) })
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
        // SAFETY: see the top of the module
        Self(unsafe { _mm256_sqrt_pd(self.0) })
    }

    #[inline(always)]
    fn abs(self) -> Self {
        // SAFETY: see the top of the module
        Self(unsafe { _mm256_andnot_pd(_mm256_set1_pd(-0.0), self.0) })
    }

    #[inline(always)]
    fn gt(self, other: Self) -> Mask4 {
        // SAFETY: see the top of the module
        Mask4(unsafe { _mm256_cmp_pd::<_CMP_GT_OQ>(self.0, other.0) })
    }

    #[inline(always)]
    fn ge(self, other: Self) -> Mask4 {
        // SAFETY: see the top of the module
        Mask4(unsafe { _mm256_cmp_pd::<_CMP_GE_OQ>(self.0, other.0) })
    }

    #[inline(always)]
    fn select(mask: Mask4, yes: Self, no: Self) -> Self {
        // SAFETY: see the top of the module
        Self(unsafe { _mm256_blendv_pd(no.0, yes.0, mask.0) })
    }

    #[inline(always)]
    fn max(self, other: Self) -> Self {
        // SAFETY: see the top of the module
        Self(unsafe { _mm256_max_pd(self.0, other.0) })
    }

    #[inline(always)]
    fn min(self, other: Self) -> Self {
        // SAFETY: see the top of the module
        Self(unsafe { _mm256_min_pd(self.0, other.0) })
    }

    #[inline(always)]
    fn keep(self, mask: Mask4) -> Self {
        // SAFETY: see the top of the module
        Self(unsafe { _mm256_and_pd(self.0, mask.0) })
    }

    #[inline(always)]
    fn gather(values: &[f64], p: &Places) -> Self {
        let p = &by::<4, _>(p)[0];
        check(values, p, 1);
        // SAFETY: see the top of the module; the numbers are there
        unsafe {
            let [a, b] = [one(values, p[0]), one(values, p[1])];
            let [c, d] = [one(values, p[2]), one(values, p[3])];
            Self(_mm256_setr_pd(a, b, c, d))
        }
    }

    #[inline(always)]
    fn columns(values: &[f64], starts: &Places) -> [Self; 4] {
        let starts = &by::<4, _>(starts)[0];
        check(values, starts, 4);
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
    fn fetch<const N: usize>(tables: [&[[f64; 4]]; N], index: &[u32]) -> [[Self; 4]; N] {
        let index = one_by_one::<4>(first(index));
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
    fn strided(values: &[f64], start: usize, stride: usize) -> [Self; 4] {
        let values = &values[stretch(values.len(), 4, start, stride)];
        // SAFETY: all these rows are there
        let [a, b, c, d] = transposed(unsafe {
            [
                row(values, 0),
                row(values, stride),
                row(values, 2 * stride),
                row(values, 3 * stride),
            ]
        });
        [Self(a), Self(b), Self(c), Self(d)]
    }

    #[inline(always)]
    fn put_strided([a, b, c, d]: [Self; 4], values: &mut [f64], start: usize, stride: usize) {
        let stretch = stretch(values.len(), 4, start, stride);
        let values = &mut values[stretch];
        let rows = transposed([a.0, b.0, c.0, d.0]);
        // SAFETY: there is room for all these rows
        unsafe {
            put_row(values, 0, rows[0]);
            put_row(values, stride, rows[1]);
            put_row(values, 2 * stride, rows[2]);
            put_row(values, 3 * stride, rows[3]);
        }
    }

    #[inline(always)]
    fn rows([a, b, c, d]: [Self; 4]) -> [[f64; 4]; 4] {
        let [first, second, third, fourth] = transposed([a.0, b.0, c.0, d.0]);
        [put(first), put(second), put(third), put(fourth)]
    }

    #[inline(always)]
    fn side_by_side(first: Vector3<Self>, second: Vector3<Self>) -> [Two<Self>; 4] {
        let (first, second) = (Self::rows(with_zero(first)), Self::rows(with_zero(second)));
        [
            Two::of_rows(&first[0], &second[0]),
            Two::of_rows(&first[1], &second[1]),
            Two::of_rows(&first[2], &second[2]),
            Two::of_rows(&first[3], &second[3]),
        ]
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
    fn of_singles(from: &[f32; 6]) -> [Self; 2] {
        // SAFETY: see the top of the module; four numbers are there from the first and from the third on
        unsafe {
            let (first, behind) = (_mm_loadu_ps(from.as_ptr()), _mm_loadu_ps(from[2..].as_ptr()));
            let first = _mm_blend_ps::<0b1000>(first, _mm_setzero_ps());
            let second = _mm_castsi128_ps(_mm_srli_si128::<4>(_mm_castps_si128(behind)));
            [first, second].map(|singles| Self(_mm256_cvtps_pd(singles)))
        }
    }

    #[inline(always)]
    fn rounded(self) -> Self {
        // SAFETY: see the top of the module
        Self(unsafe { _mm256_cvtps_pd(_mm256_cvtpd_ps(self.0)) })
    }

    #[inline(always)]
    fn put_singles(first: Self, second: Self, to: &mut [f32; 6]) {
        // SAFETY: see the top of the module; there is room for four numbers, and for two from the fifth on
        unsafe {
            let (first, second) = (_mm256_cvtpd_ps(first.0), _mm256_cvtpd_ps(second.0));
            let behind = _mm_srli_si128::<4>(_mm_castps_si128(second));
            _mm_storeu_ps(to.as_mut_ptr(), _mm_insert_ps::<0b11_0000>(first, second));
            _mm_storeu_si64(to[4..].as_mut_ptr().cast(), behind);
        }
    }

    #[inline(always)]
    fn all(value: f64) -> Self {
        Self::splat(value)
    }

    #[inline(always)]
    fn larger(self, other: Self) -> Self {
        // SAFETY: see the top of the module
        Self(unsafe { _mm256_max_pd(other.0, self.0) })
    }

    #[inline(always)]
    fn lies_within(self, lower: Self, upper: Self) -> bool {
        (self.ge(lower) & upper.ge(self)).bits() == 0b1111
    }
}

/// Four rows of four, with rows and columns exchanged.
#[inline(always)]
fn transposed([a, b, c, d]: [__m256d; 4]) -> [__m256d; 4] {
    // SAFETY: see the top of the module
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
