//! Four and eight lanes of x86-64.
//!
//! Unsafe because instructions are used that not every processor has. The types here are made by [`run_avx2`] and
//! [`run_avx512`] alone, which [`super::run`] calls only where the processor has them.
#![allow(unsafe_code)]

use super::{Kernel, Lanes, MOST_LANES, Mask, Places, Vector3};
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

/// Four numbers in a register.
#[inline(always)]
fn row(values: &[f64], start: usize) -> __m256d {
    let values = &values[start..start + 4];
    // SAFETY: four numbers are there
    unsafe { _mm256_loadu_pd(values.as_ptr()) }
}

/// Four numbers out of a register.
#[inline(always)]
fn put(row: __m256d, values: &mut [f64; 4]) {
    // SAFETY: there is room for four numbers
    unsafe { _mm256_storeu_pd(values.as_mut_ptr(), row) }
}

impl Lanes for F64x8 {
    const COUNT: usize = 8;
    type Mask = Mask8;
    type Vector = Vector3<Self>;

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
    fn columns(values: &[f64], starts: &Places) -> [Self; 4] {
        // no closures here: they would be compiled without the instructions
        // SAFETY: see the top of this file
        unsafe {
            let r04 = _mm512_castpd256_pd512(row(values, starts[0]));
            let r04 = _mm512_insertf64x4::<1>(r04, row(values, starts[4]));
            let r15 = _mm512_castpd256_pd512(row(values, starts[1]));
            let r15 = _mm512_insertf64x4::<1>(r15, row(values, starts[5]));
            let r26 = _mm512_castpd256_pd512(row(values, starts[2]));
            let r26 = _mm512_insertf64x4::<1>(r26, row(values, starts[6]));
            let r37 = _mm512_castpd256_pd512(row(values, starts[3]));
            let r37 = _mm512_insertf64x4::<1>(r37, row(values, starts[7]));
            let (low01, high01) = (_mm512_unpacklo_pd(r04, r15), _mm512_unpackhi_pd(r04, r15));
            let (low23, high23) = (_mm512_unpacklo_pd(r26, r37), _mm512_unpackhi_pd(r26, r37));
            let even = _mm512_setr_epi64(0, 1, 8, 9, 4, 5, 12, 13);
            let odd = _mm512_setr_epi64(2, 3, 10, 11, 6, 7, 14, 15);
            [
                Self(_mm512_permutex2var_pd(low01, even, low23)),
                Self(_mm512_permutex2var_pd(high01, even, high23)),
                Self(_mm512_permutex2var_pd(low01, odd, low23)),
                Self(_mm512_permutex2var_pd(high01, odd, high23)),
            ]
        }
    }

    #[inline(always)]
    fn rows([a, b, c, d]: [Self; 4]) -> [[f64; 4]; MOST_LANES] {
        let mut rows = [[0.0; 4]; MOST_LANES];
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
            put(_mm512_castpd512_pd256(r04), &mut rows[0]);
            put(_mm512_castpd512_pd256(r15), &mut rows[1]);
            put(_mm512_castpd512_pd256(r26), &mut rows[2]);
            put(_mm512_castpd512_pd256(r37), &mut rows[3]);
            put(_mm512_extractf64x4_pd::<1>(r04), &mut rows[4]);
            put(_mm512_extractf64x4_pd::<1>(r15), &mut rows[5]);
            put(_mm512_extractf64x4_pd::<1>(r26), &mut rows[6]);
            put(_mm512_extractf64x4_pd::<1>(r37), &mut rows[7]);
        }
        rows
    }
}

impl Lanes for F64x4 {
    const COUNT: usize = 4;
    type Mask = Mask4;
    type Vector = Vector3<Self>;

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
    fn columns(values: &[f64], starts: &Places) -> [Self; 4] {
        let rows = [
            row(values, starts[0]),
            row(values, starts[1]),
            row(values, starts[2]),
            row(values, starts[3]),
        ];
        let [a, b, c, d] = transposed(rows);
        [Self(a), Self(b), Self(c), Self(d)]
    }

    #[inline(always)]
    fn rows([a, b, c, d]: [Self; 4]) -> [[f64; 4]; MOST_LANES] {
        let mut rows = [[0.0; 4]; MOST_LANES];
        let [first, second, third, fourth] = transposed([a.0, b.0, c.0, d.0]);
        put(first, &mut rows[0]);
        put(second, &mut rows[1]);
        put(third, &mut rows[2]);
        put(fourth, &mut rows[3]);
        rows
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
