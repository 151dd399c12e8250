//! Four numbers of one thing side by side: a row of a table as it lies in memory.

use std::ops::{Add, Mul, Sub};

/// Four numbers on which one operation acts at once: a vector with a number that is used together with it. As with
/// [`super::Lanes`], every operation is that of IEEE 754.
pub trait Quad: Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> {
    /// From numbers.
    fn load(from: &[f64; 4]) -> Self;
    /// As numbers.
    fn store(self) -> [f64; 4];
    /// Two vectors of numbers of half the precision, each with 0 behind it.
    fn of_singles(from: &[f32; 6]) -> [Self; 2];
    /// Each rounded to the nearest number of half the precision, to the even one of two.
    fn rounded(self) -> Self;
    /// Puts the vectors in front of two, rounded.
    fn put_singles(first: Self, second: Self, to: &mut [f32; 6]);
    /// The same number four times.
    fn all(value: f64) -> Self;
    /// The larger number in each place; that of `self` where `other` is not a number.
    fn larger(self, other: Self) -> Self;
    /// Whether every number is at least `lower` and at most `upper`.
    fn lies_within(self, lower: Self, upper: Self) -> bool;
}

/// Eight numbers side by side, on which one operation acts at once: two vectors of one thing, each with a number beside it.
pub trait Eight: Copy + Add<Output = Self> + Sub<Output = Self> {
    /// From numbers.
    fn load(from: &[f64; 8]) -> Self;
    /// Puts the numbers.
    fn store(self, to: &mut [f64; 8]);
}

/// Eight numbers as two times four.
#[derive(Clone, Copy, Debug)]
pub struct Two<Q>(Q, Q);

impl<Q: Quad> Two<Q> {
    /// Of rows of four numbers each.
    #[inline(always)]
    pub(super) fn of_rows(first: &[f64; 4], second: &[f64; 4]) -> Self {
        Self(Q::load(first), Q::load(second))
    }
}

impl<Q: Quad> Add for Two<Q> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self(self.0 + other.0, self.1 + other.1)
    }
}

impl<Q: Quad> Sub for Two<Q> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self(self.0 - other.0, self.1 - other.1)
    }
}

impl<Q: Quad> Eight for Two<Q> {
    #[inline(always)]
    fn load(&[a, b, c, d, e, f, g, h]: &[f64; 8]) -> Self {
        Self(Q::load(&[a, b, c, d]), Q::load(&[e, f, g, h]))
    }

    #[inline(always)]
    fn store(self, to: &mut [f64; 8]) {
        let ([a, b, c, d], [e, f, g, h]) = (self.0.store(), self.1.store());
        *to = [a, b, c, d, e, f, g, h];
    }
}

/// Four numbers without instructions of their own.
#[derive(Clone, Copy, Debug)]
pub struct Four([f64; 4]);

macro_rules! by_place {
    ($($operator:ident $method:ident $sign:tt;)*) => {
        $(
            impl $operator for Four {
                type Output = Self;
                #[inline(always)]
                fn $method(self, Self([e, f, g, h]): Self) -> Self {
                    let Self([a, b, c, d]) = self;
                    Self([a $sign e, b $sign f, c $sign g, d $sign h])
                }
            }
        )*
    };
}

by_place! { Add add +; Sub sub -; Mul mul *; }

impl Quad for Four {
    #[inline(always)]
    fn load(from: &[f64; 4]) -> Self {
        Self(*from)
    }

    #[inline(always)]
    fn store(self) -> [f64; 4] {
        self.0
    }

    #[inline(always)]
    fn of_singles(from: &[f32; 6]) -> [Self; 2] {
        let [a, b, c, d, e, f] = from.map(f64::from);
        [Self([a, b, c, 0.0]), Self([d, e, f, 0.0])]
    }

    #[inline(always)]
    fn rounded(self) -> Self {
        Self(self.0.map(|x| f64::from(x as f32)))
    }

    #[inline(always)]
    fn put_singles(Self([a, b, c, _]): Self, Self([d, e, f, _]): Self, to: &mut [f32; 6]) {
        *to = [a, b, c, d, e, f].map(|x| x as f32);
    }

    #[inline(always)]
    fn all(value: f64) -> Self {
        Self([value; 4])
    }

    #[inline(always)]
    fn larger(self, other: Self) -> Self {
        let larger = |k: usize| {
            let (one, other) = (self.0[k], other.0[k]);
            if other > one { other } else { one }
        };
        Self([larger(0), larger(1), larger(2), larger(3)])
    }

    #[inline(always)]
    fn lies_within(self, lower: Self, upper: Self) -> bool {
        (0..4).all(|k| lower.0[k] <= self.0[k] && self.0[k] <= upper.0[k])
    }
}
