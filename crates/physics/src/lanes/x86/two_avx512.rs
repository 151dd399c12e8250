//! Sixteen lanes: two registers of AVX-512, of which one computes while the other waits for a result.

use super::avx2::F64x4;
use super::avx512::{F64x8, Mask8, columns_from, columns_of, fetched, gathered, largest_of_eight};
use super::{by, check_rows, first};
use crate::lanes::{Lanes, MOST_LANES, Mask, Places, Vector, Vector3};
use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

/// Sixteen lanes of AVX-512.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub(in crate::lanes) struct F64x16(F64x8, F64x8);

macro_rules! by_register {
    ($($operator:ident $method:ident;)*) => {
        $(
            impl $operator for F64x16 {
                type Output = Self;
                #[inline(always)]
                fn $method(self, other: Self) -> Self {
                    Self(self.0.$method(other.0), self.1.$method(other.1))
                }
            }

            impl $operator<f64> for F64x16 {
                type Output = Self;
                #[inline(always)]
                fn $method(self, other: f64) -> Self {
                    self.$method(Self::splat(other))
                }
            }
        )*
    };
}

by_register! { Add add; Sub sub; Mul mul; Div div; }

impl Neg for F64x16 {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0, -self.1)
    }
}

/// Answers of sixteen lanes.
#[derive(Clone, Copy)]
pub(in crate::lanes) struct Mask16(Mask8, Mask8);

impl Mask for Mask16 {
    #[inline(always)]
    fn bits(self) -> u32 {
        self.0.bits() | self.1.bits() << 8
    }

    #[inline(always)]
    fn of_bits(bits: u32) -> Self {
        Self(Mask8::of_bits(bits), Mask8::of_bits(bits >> 8))
    }
}

impl BitAnd for Mask16 {
    type Output = Self;
    #[inline(always)]
    fn bitand(self, other: Self) -> Self {
        Self(self.0 & other.0, self.1 & other.1)
    }
}

impl BitOr for Mask16 {
    type Output = Self;
    #[inline(always)]
    fn bitor(self, other: Self) -> Self {
        Self(self.0 | other.0, self.1 | other.1)
    }
}

impl Not for Mask16 {
    type Output = Self;
    #[inline(always)]
    fn not(self) -> Self {
        Self(!self.0, !self.1)
    }
}

impl Lanes for F64x16 {
    const COUNT: usize = 16;
    type Mask = Mask16;
    type Vector = Vector3<Self>;
    type Rows = [[f64; 4]; 16];
    type Quad = F64x4;
    type Eight = F64x8;
    type Eights = [F64x8; 16];
    type Register = F64x8;

    #[inline(always)]
    fn register(self, which: usize) -> F64x8 {
        if which == 0 { self.0 } else { self.1 }
    }

    #[inline(always)]
    fn splat(value: f64) -> Self {
        let one = F64x8::splat(value);
        Self(one, one)
    }

    #[inline(always)]
    fn load(from: &[f64]) -> Self {
        let from = &from[..16];
        Self(<F64x8 as Lanes>::load(from), <F64x8 as Lanes>::load(&from[8..]))
    }

    #[inline(always)]
    fn store(self, to: &mut [f64]) {
        let to = &mut to[..16];
        <F64x8 as Lanes>::store(self.0, to);
        <F64x8 as Lanes>::store(self.1, &mut to[8..]);
    }

    #[inline(always)]
    fn store_singles(self, to: &mut [f32]) {
        let to = &mut to[..16];
        self.0.store_singles(to);
        self.1.store_singles(&mut to[8..]);
    }

    #[inline(always)]
    fn load_singles(from: &[f32]) -> Self {
        let from = &from[..16];
        Self(F64x8::load_singles(from), F64x8::load_singles(&from[8..]))
    }

    #[inline(always)]
    fn as_slice(&self) -> &[f64] {
        // SAFETY: two registers that follow each other are their lanes, and nothing else
        unsafe { std::slice::from_raw_parts(std::ptr::from_ref(self).cast(), Self::COUNT) }
    }

    #[inline(always)]
    fn as_mut_slice(&mut self) -> &mut [f64] {
        // SAFETY: two registers that follow each other are their lanes, and nothing else
        unsafe { std::slice::from_raw_parts_mut(std::ptr::from_mut(self).cast(), Self::COUNT) }
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(self.0.sqrt(), self.1.sqrt())
    }

    #[inline(always)]
    fn abs(self) -> Self {
        Self(self.0.abs(), self.1.abs())
    }

    #[inline(always)]
    fn gt(self, other: Self) -> Mask16 {
        Mask16(self.0.gt(other.0), self.1.gt(other.1))
    }

    #[inline(always)]
    fn ge(self, other: Self) -> Mask16 {
        Mask16(self.0.ge(other.0), self.1.ge(other.1))
    }

    #[inline(always)]
    fn select(mask: Mask16, yes: Self, no: Self) -> Self {
        Self(F64x8::select(mask.0, yes.0, no.0), F64x8::select(mask.1, yes.1, no.1))
    }

    #[inline(always)]
    fn gather(values: &[f64], places: &Places) -> Self {
        let places = by(places);
        Self(gathered(values, &places[0]), gathered(values, &places[1]))
    }

    #[inline(always)]
    fn columns(values: &[f64], starts: &Places) -> [Self; 4] {
        let starts = by(starts);
        side_by_side(columns_from(values, &starts[0]), columns_from(values, &starts[1]))
    }

    #[inline(always)]
    fn of_rows(rows: &[&[f64; 4]; MOST_LANES]) -> [Self; 4] {
        let rows = by(rows);
        side_by_side(columns_of(&rows[0]), columns_of(&rows[1]))
    }

    #[inline(always)]
    fn fetch<const N: usize>(tables: [&[[f64; 4]]; N], index: &[u32]) -> [[Self; 4]; N] {
        let (lower, upper) = (first(index), first(&index[8..]));
        let most = largest_of_eight(lower).max(largest_of_eight(upper));
        check_rows(&tables, most);
        // SAFETY: all these rows are there
        let (one, other) = unsafe { (fetched(tables, lower), fetched(tables, upper)) };
        let mut columns = [[Self::splat(0.0); 4]; N];
        let mut table = 0;
        while table < N {
            columns[table] = side_by_side(one[table], other[table]);
            table += 1;
        }
        columns
    }

    #[inline(always)]
    fn strided(values: &[f64], start: usize, stride: usize) -> [Self; 4] {
        side_by_side(
            F64x8::strided(values, start, stride),
            F64x8::strided(values, start + 8 * stride, stride),
        )
    }

    #[inline(always)]
    fn put_strided([a, b, c, d]: [Self; 4], values: &mut [f64], start: usize, stride: usize) {
        F64x8::put_strided([a.0, b.0, c.0, d.0], values, start, stride);
        F64x8::put_strided([a.1, b.1, c.1, d.1], values, start + 8 * stride, stride);
    }

    #[inline(always)]
    fn rows([a, b, c, d]: [Self; 4]) -> [[f64; 4]; 16] {
        let mut rows = [[0.0; 4]; 16];
        rows[..8].copy_from_slice(&F64x8::rows([a.0, b.0, c.0, d.0]));
        rows[8..].copy_from_slice(&F64x8::rows([a.1, b.1, c.1, d.1]));
        rows
    }

    #[inline(always)]
    fn side_by_side(first: Vector3<Self>, second: Vector3<Self>) -> [F64x8; 16] {
        let ([a, b, c], [d, e, f]) = (first.components(), second.components());
        let one = F64x8::side_by_side(Vector3::new(a.0, b.0, c.0), Vector3::new(d.0, e.0, f.0));
        let other = F64x8::side_by_side(Vector3::new(a.1, b.1, c.1), Vector3::new(d.1, e.1, f.1));
        let mut all = [one[0]; 16];
        all[..8].copy_from_slice(&one);
        all[8..].copy_from_slice(&other);
        all
    }
}

/// Columns of eight rows beside those of eight others.
#[inline(always)]
fn side_by_side([a, b, c, d]: [F64x8; 4], [e, f, g, h]: [F64x8; 4]) -> [F64x16; 4] {
    [F64x16(a, e), F64x16(b, f), F64x16(c, g), F64x16(d, h)]
}
