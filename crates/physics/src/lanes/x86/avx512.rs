//! Eight lanes of AVX-512.

use super::avx2::F64x4;
use super::{at, by, check, check_rows, first, one, one_by_one, put, row, stretch, whole};
use crate::lanes::{Eight, Lanes, MOST_LANES, Mask, Places, Vector3, with_zero};
use std::arch::x86_64::*;
use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

/// Eight lanes of AVX-512.
#[derive(Clone, Copy, Debug)]
#[repr(transparent)]
pub(in crate::lanes) struct F64x8(__m512d);

arithmetic! { F64x8, Add add _mm512_add_pd; Sub sub _mm512_sub_pd; Mul mul _mm512_mul_pd; Div div _mm512_div_pd; }

impl F64x8 {
    #[inline(always)]
    fn flip_sign(self) -> Self {
        // SAFETY: see the top of the module
        unsafe {
            let sign = _mm512_set1_epi64(i64::MIN);
            Self(_mm512_castsi512_pd(_mm512_xor_si512(_mm512_castpd_si512(self.0), sign)))
        }
    }
}

/// Answers of eight lanes.
#[derive(Clone, Copy)]
pub(in crate::lanes) struct Mask8(__mmask8);

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

impl Lanes for F64x8 {
    const COUNT: usize = 8;
    type Mask = Mask8;
    type Vector = Vector3<Self>;
    type Rows = [[f64; 4]; 8];
    type Quad = F64x4;
    type Eight = Self;
    type Eights = [Self; 8];
    type Register = Self;

    #[inline(always)]
    fn register(self, _: usize) -> Self {
        self
    }

    #[inline(always)]
    fn splat(value: f64) -> Self {
        // SAFETY: see the top of the module
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
    fn store_singles(self, to: &mut [f32]) {
        let to = &mut to[..8];
        // SAFETY: there is room for eight numbers
        unsafe { _mm256_storeu_ps(to.as_mut_ptr(), _mm512_cvtpd_ps(self.0)) }
    }

    #[inline(always)]
    fn load_singles(from: &[f32]) -> Self {
        let from = &from[..8];
        // SAFETY: eight numbers are there
        Self(unsafe { _mm512_cvtps_pd(_mm256_loadu_ps(from.as_ptr())) })
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
        Self(unsafe { _mm512_sqrt_pd(self.0) })
    }

    #[inline(always)]
    fn abs(self) -> Self {
        // SAFETY: see the top of the module
        Self(unsafe { _mm512_abs_pd(self.0) })
    }

    #[inline(always)]
    fn gt(self, other: Self) -> Mask8 {
        // SAFETY: see the top of the module
        Mask8(unsafe { _mm512_cmp_pd_mask::<_CMP_GT_OQ>(self.0, other.0) })
    }

    #[inline(always)]
    fn ge(self, other: Self) -> Mask8 {
        // SAFETY: see the top of the module
        Mask8(unsafe { _mm512_cmp_pd_mask::<_CMP_GE_OQ>(self.0, other.0) })
    }

    #[inline(always)]
    fn select(mask: Mask8, yes: Self, no: Self) -> Self {
        // SAFETY: see the top of the module
        Self(unsafe { _mm512_mask_blend_pd(mask.0, no.0, yes.0) })
    }

    #[inline(always)]
    fn gather(values: &[f64], places: &Places) -> Self {
        gathered(values, &by(places)[0])
    }

    #[inline(always)]
    fn columns(values: &[f64], starts: &Places) -> [Self; 4] {
        columns_from(values, &by(starts)[0])
    }

    #[inline(always)]
    fn of_rows(rows: &[&[f64; 4]; MOST_LANES]) -> [Self; 4] {
        columns_of(&by(rows)[0])
    }

    #[inline(always)]
    fn fetch<const N: usize>(tables: [&[[f64; 4]]; N], index: &[u32]) -> [[Self; 4]; N] {
        let index = first(index);
        check_rows(&tables, largest_of_eight(index));
        // SAFETY: all these rows are there
        unsafe { fetched(tables, index) }
    }

    #[inline(always)]
    fn strided(values: &[f64], start: usize, stride: usize) -> [Self; 4] {
        let values = &values[stretch(values.len(), 8, start, stride)];
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
    fn rows(columns: [Self; 4]) -> [[f64; 4]; 8] {
        let [r04, r15, r26, r37] = rows_by_two(columns);
        // SAFETY: see the top of the module
        unsafe {
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

    #[inline(always)]
    fn side_by_side(first: Vector3<Self>, second: Vector3<Self>) -> [Self; 8] {
        let [a04, a15, a26, a37] = rows_by_two(with_zero(first));
        let [b04, b15, b26, b37] = rows_by_two(with_zero(second));
        // SAFETY: see the top of the module
        unsafe {
            [
                Self(_mm512_shuffle_f64x2::<0b01_00_01_00>(a04, b04)),
                Self(_mm512_shuffle_f64x2::<0b01_00_01_00>(a15, b15)),
                Self(_mm512_shuffle_f64x2::<0b01_00_01_00>(a26, b26)),
                Self(_mm512_shuffle_f64x2::<0b01_00_01_00>(a37, b37)),
                Self(_mm512_shuffle_f64x2::<0b11_10_11_10>(a04, b04)),
                Self(_mm512_shuffle_f64x2::<0b11_10_11_10>(a15, b15)),
                Self(_mm512_shuffle_f64x2::<0b11_10_11_10>(a26, b26)),
                Self(_mm512_shuffle_f64x2::<0b11_10_11_10>(a37, b37)),
            ]
        }
    }
}

impl Eight for F64x8 {
    #[inline(always)]
    fn load(from: &[f64; 8]) -> Self {
        <Self as Lanes>::load(from)
    }

    #[inline(always)]
    fn store(self, to: &mut [f64; 8]) {
        <Self as Lanes>::store(self, to);
    }
}

/// Rows of four columns, two in a register: 0 and 4, 1 and 5, 2 and 6, 3 and 7.
#[inline(always)]
fn rows_by_two([a, b, c, d]: [F64x8; 4]) -> [__m512d; 4] {
    // SAFETY: see the top of the module
    unsafe {
        let (low_ab, high_ab) = (_mm512_unpacklo_pd(a.0, b.0), _mm512_unpackhi_pd(a.0, b.0));
        let (low_cd, high_cd) = (_mm512_unpacklo_pd(c.0, d.0), _mm512_unpackhi_pd(c.0, d.0));
        let even = _mm512_setr_epi64(0, 1, 8, 9, 4, 5, 12, 13);
        let odd = _mm512_setr_epi64(2, 3, 10, 11, 6, 7, 14, 15);
        [
            _mm512_permutex2var_pd(low_ab, even, low_cd),
            _mm512_permutex2var_pd(high_ab, even, high_cd),
            _mm512_permutex2var_pd(low_ab, odd, low_cd),
            _mm512_permutex2var_pd(high_ab, odd, high_cd),
        ]
    }
}

/// One number of `values` per lane.
#[inline(always)]
pub(super) fn gathered(values: &[f64], p: &[usize; 8]) -> F64x8 {
    check(values, p, 1);
    // SAFETY: see the top of the module; the numbers are there
    unsafe {
        let [a, b] = [one(values, p[0]), one(values, p[1])];
        let [c, d] = [one(values, p[2]), one(values, p[3])];
        let [e, f] = [one(values, p[4]), one(values, p[5])];
        let [g, h] = [one(values, p[6]), one(values, p[7])];
        F64x8(_mm512_setr_pd(a, b, c, d, e, f, g, h))
    }
}

/// The columns of rows of `values`.
#[inline(always)]
pub(super) fn columns_from(values: &[f64], starts: &[usize; 8]) -> [F64x8; 4] {
    check(values, starts, 4);
    // SAFETY: the numbers are there
    eight_rows(unsafe {
        [
            row(values, starts[0]),
            row(values, starts[1]),
            row(values, starts[2]),
            row(values, starts[3]),
            row(values, starts[4]),
            row(values, starts[5]),
            row(values, starts[6]),
            row(values, starts[7]),
        ]
    })
}

/// The columns of rows, wherever they lie.
#[inline(always)]
pub(super) fn columns_of(rows: &[&[f64; 4]; 8]) -> [F64x8; 4] {
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

/// The columns of rows of some tables.
///
/// # Safety
/// They must be there.
#[inline(always)]
pub(super) unsafe fn fetched<const N: usize>(tables: [&[[f64; 4]]; N], index: &[u32; 8]) -> [[F64x8; 4]; N] {
    let index = one_by_one(index);
    let mut columns = [[F64x8::splat(0.0); 4]; N];
    let mut table = 0;
    while table < N {
        let rows = tables[table];
        // SAFETY: as the caller promises
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

/// The largest of eight numbers.
#[inline(always)]
pub(super) fn largest_of_eight(index: &[u32; 8]) -> u32 {
    // SAFETY: see the top of the module; eight numbers are there
    unsafe {
        let all = _mm256_loadu_si256(index.as_ptr().cast());
        let four = _mm_max_epu32(_mm256_castsi256_si128(all), _mm256_extracti128_si256::<1>(all));
        let two = _mm_max_epu32(four, _mm_shuffle_epi32::<0b01_00_11_10>(four));
        let one = _mm_max_epu32(two, _mm_shuffle_epi32::<0b10_11_00_01>(two));
        _mm_cvtsi128_si32(one) as u32
    }
}

/// Columns of eight rows of four.
#[inline(always)]
fn eight_rows(rows: [__m256d; 8]) -> [F64x8; 4] {
    // no closures here: they would be compiled without the instructions
    // SAFETY: see the top of the module
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
