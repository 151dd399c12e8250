//! One lane.

use super::{Four, Lanes, MOST_LANES, Mask, Places, Two, with_zero};
use glam::DVec3;

impl Mask for bool {
    #[inline(always)]
    fn bits(self) -> u32 {
        u32::from(self)
    }

    #[inline(always)]
    fn of_bits(bits: u32) -> Self {
        bits & 1 != 0
    }
}

impl Lanes for f64 {
    const COUNT: usize = 1;
    type Mask = bool;
    type Vector = DVec3;
    type Rows = [[f64; 4]; 1];
    type Quad = Four;
    type Eight = Two<Four>;
    type Eights = [Two<Four>; 1];
    type Register = Self;

    #[inline(always)]
    fn register(self, _: usize) -> Self {
        self
    }

    #[inline(always)]
    fn splat(value: f64) -> Self {
        value
    }

    #[inline(always)]
    fn load(from: &[f64]) -> Self {
        from[0]
    }

    #[inline(always)]
    fn store(self, to: &mut [f64]) {
        to[0] = self;
    }

    #[inline(always)]
    fn as_slice(&self) -> &[f64] {
        std::slice::from_ref(self)
    }

    #[inline(always)]
    fn as_mut_slice(&mut self) -> &mut [f64] {
        std::slice::from_mut(self)
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        f64::sqrt(self)
    }

    #[inline(always)]
    fn abs(self) -> Self {
        f64::abs(self)
    }

    #[inline(always)]
    fn gt(self, other: Self) -> bool {
        self > other
    }

    #[inline(always)]
    fn ge(self, other: Self) -> bool {
        self >= other
    }

    #[inline(always)]
    fn select(mask: bool, yes: Self, no: Self) -> Self {
        if mask { yes } else { no }
    }

    #[inline(always)]
    fn columns(values: &[f64], starts: &Places) -> [Self; 4] {
        let start = starts[0];
        [values[start], values[start + 1], values[start + 2], values[start + 3]]
    }

    #[inline(always)]
    fn of_rows(rows: &[&[f64; 4]; MOST_LANES]) -> [Self; 4] {
        *rows[0]
    }

    #[inline(always)]
    fn rows(columns: [Self; 4]) -> [[f64; 4]; 1] {
        [columns]
    }

    #[inline(always)]
    fn side_by_side(first: DVec3, second: DVec3) -> [Two<Four>; 1] {
        [Two::of_rows(&with_zero::<Self>(first), &with_zero::<Self>(second))]
    }

    #[inline(always)]
    fn gather(values: &[f64], places: &Places) -> Self {
        values[places[0]]
    }
}
