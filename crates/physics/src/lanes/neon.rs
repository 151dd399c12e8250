//! Two lanes of ARMv8, whose every processor has them.
//!
//! Unsafe because the instructions are reached through intrinsics.
#![allow(unsafe_code)]

use super::{Four, Lanes, MOST_LANES, Mask, Places, Two, Vector3, with_zero};
use std::arch::aarch64::*;
use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

/// Two lanes of NEON.
#[derive(Clone, Copy, Debug)]
#[repr(transparent)]
pub(super) struct F64x2(float64x2_t);

macro_rules! arithmetic {
    ($($operator:ident $method:ident $instruction:ident;)*) => {
        $(
            impl $operator for F64x2 {
                type Output = Self;
                #[inline(always)]
                fn $method(self, other: Self) -> Self {
                    // SAFETY: every ARMv8 processor has it
                    Self(unsafe { $instruction(self.0, other.0) })
                }
            }

            impl $operator<f64> for F64x2 {
                type Output = Self;
                #[inline(always)]
                fn $method(self, other: f64) -> Self {
                    self.$method(Self::splat(other))
                }
            }
        )*
    };
}

arithmetic! { Add add vaddq_f64; Sub sub vsubq_f64; Mul mul vmulq_f64; Div div vdivq_f64; }

impl Neg for F64x2 {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        // SAFETY: every ARMv8 processor has it
        Self(unsafe { vnegq_f64(self.0) })
    }
}

/// Answers of two lanes: all bits of a lane, or none.
#[derive(Clone, Copy)]
pub(super) struct Mask2(uint64x2_t);

impl Mask for Mask2 {
    #[inline(always)]
    fn bits(self) -> u32 {
        // SAFETY: every ARMv8 processor has it
        let lanes = unsafe { [vgetq_lane_u64::<0>(self.0), vgetq_lane_u64::<1>(self.0)] };
        (lanes[0] & 1) as u32 | ((lanes[1] & 1) << 1) as u32
    }

    #[inline(always)]
    fn of_bits(bits: u32) -> Self {
        let lanes = [
            0u64.wrapping_sub(u64::from(bits & 1)),
            0u64.wrapping_sub(u64::from(bits >> 1 & 1)),
        ];
        // SAFETY: every ARMv8 processor has it; two numbers are there
        Self(unsafe { vld1q_u64(lanes.as_ptr()) })
    }
}

impl BitAnd for Mask2 {
    type Output = Self;
    #[inline(always)]
    fn bitand(self, other: Self) -> Self {
        // SAFETY: every ARMv8 processor has it
        Self(unsafe { vandq_u64(self.0, other.0) })
    }
}

impl BitOr for Mask2 {
    type Output = Self;
    #[inline(always)]
    fn bitor(self, other: Self) -> Self {
        // SAFETY: every ARMv8 processor has it
        Self(unsafe { vorrq_u64(self.0, other.0) })
    }
}

impl Not for Mask2 {
    type Output = Self;
    #[inline(always)]
    fn not(self) -> Self {
        // SAFETY: every ARMv8 processor has it
        Self(unsafe { veorq_u64(self.0, vdupq_n_u64(u64::MAX)) })
    }
}

impl Lanes for F64x2 {
    const COUNT: usize = 2;
    type Mask = Mask2;
    type Vector = Vector3<Self>;
    type Rows = [[f64; 4]; 2];
    type Quad = Four;
    type Eight = Two<Four>;
    type Eights = [Two<Four>; 2];
    type Register = Self;

    #[inline(always)]
    fn register(self, _: usize) -> Self {
        self
    }

    #[inline(always)]
    fn splat(value: f64) -> Self {
        // SAFETY: every ARMv8 processor has it
        Self(unsafe { vdupq_n_f64(value) })
    }

    #[inline(always)]
    fn load(from: &[f64]) -> Self {
        let from = &from[..2];
        // SAFETY: two numbers are there
        Self(unsafe { vld1q_f64(from.as_ptr()) })
    }

    #[inline(always)]
    fn store(self, to: &mut [f64]) {
        let to = &mut to[..2];
        // SAFETY: there is room for two numbers
        unsafe { vst1q_f64(to.as_mut_ptr(), self.0) }
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
        // SAFETY: every ARMv8 processor has it
        Self(unsafe { vsqrtq_f64(self.0) })
    }

    #[inline(always)]
    fn abs(self) -> Self {
        // SAFETY: every ARMv8 processor has it
        Self(unsafe { vabsq_f64(self.0) })
    }

    #[inline(always)]
    fn gt(self, other: Self) -> Mask2 {
        // SAFETY: every ARMv8 processor has it
        Mask2(unsafe { vcgtq_f64(self.0, other.0) })
    }

    #[inline(always)]
    fn ge(self, other: Self) -> Mask2 {
        // SAFETY: every ARMv8 processor has it
        Mask2(unsafe { vcgeq_f64(self.0, other.0) })
    }

    #[inline(always)]
    fn select(mask: Mask2, yes: Self, no: Self) -> Self {
        // SAFETY: every ARMv8 processor has it
        Self(unsafe { vbslq_f64(mask.0, yes.0, no.0) })
    }

    #[inline(always)]
    fn gather(values: &[f64], places: &Places) -> Self {
        Self::load(&[values[places[0]], values[places[1]]])
    }

    #[inline(always)]
    fn columns(values: &[f64], starts: &Places) -> [Self; 4] {
        let first = &values[starts[0]..starts[0] + 4];
        let second = &values[starts[1]..starts[1] + 4];
        two_rows(first, second)
    }

    #[inline(always)]
    fn of_rows(rows: &[&[f64; 4]; MOST_LANES]) -> [Self; 4] {
        two_rows(rows[0], rows[1])
    }

    #[inline(always)]
    fn rows(columns: [Self; 4]) -> [[f64; 4]; 2] {
        let mut rows = [[0.0; 4]; 2];
        let mut column = 0;
        while column < 4 {
            let mut lanes = [0.0; 2];
            columns[column].store(&mut lanes);
            rows[0][column] = lanes[0];
            rows[1][column] = lanes[1];
            column += 1;
        }
        rows
    }

    #[inline(always)]
    fn side_by_side(first: Vector3<Self>, second: Vector3<Self>) -> [Two<Four>; 2] {
        let (first, second) = (Self::rows(with_zero(first)), Self::rows(with_zero(second)));
        [Two::of_rows(&first[0], &second[0]), Two::of_rows(&first[1], &second[1])]
    }
}

/// The columns of two rows.
#[inline(always)]
fn two_rows(first: &[f64], second: &[f64]) -> [F64x2; 4] {
    [
        F64x2::load(&[first[0], second[0]]),
        F64x2::load(&[first[1], second[1]]),
        F64x2::load(&[first[2], second[2]]),
        F64x2::load(&[first[3], second[3]]),
    ]
}
