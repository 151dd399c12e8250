//! Vectors of lanes.

use super::Lanes;
use glam::DVec3;
use std::ops::{Add, Mul, Neg, Sub};

/// A vector in each lane. What it can do is written out by component here, so that one lane gives the same bits as many.
pub trait Vector<L: Lanes>:
    Copy
    + std::fmt::Debug
    + Add<Output = Self>
    + Sub<Output = Self>
    + Neg<Output = Self>
    + Mul<L, Output = Self>
    + Send
    + Sync
{
    /// From its components.
    fn new(x: L, y: L, z: L) -> Self;
    /// Its components.
    fn components(self) -> [L; 3];

    /// The null vector.
    #[inline(always)]
    fn null() -> Self {
        let zero = L::splat(0.0);
        Self::new(zero, zero, zero)
    }

    /// Scalar product.
    #[inline(always)]
    fn inner(self, other: Self) -> L {
        let ([ax, ay, az], [bx, by, bz]) = (self.components(), other.components());
        ax * bx + ay * by + az * bz
    }

    /// Square of the length.
    #[inline(always)]
    fn square(self) -> L {
        self.inner(self)
    }

    /// Vector product.
    #[inline(always)]
    fn outer(self, other: Self) -> Self {
        let ([ax, ay, az], [bx, by, bz]) = (self.components(), other.components());
        Self::new(ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx)
    }

    /// This where the mask holds, `no` elsewhere.
    #[inline(always)]
    fn or(self, mask: L::Mask, no: Self) -> Self {
        let ([ax, ay, az], [bx, by, bz]) = (self.components(), no.components());
        Self::new(
            L::select(mask, ax, bx),
            L::select(mask, ay, by),
            L::select(mask, az, bz),
        )
    }
}

impl Vector<f64> for DVec3 {
    #[inline(always)]
    fn new(x: f64, y: f64, z: f64) -> Self {
        DVec3 { x, y, z }
    }

    #[inline(always)]
    fn components(self) -> [f64; 3] {
        [self.x, self.y, self.z]
    }
}

/// A vector in each of several lanes.
#[derive(Clone, Copy, Debug)]
pub struct Vector3<L> {
    x: L,
    y: L,
    z: L,
}

impl<L: Lanes> Add for Vector3<L> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self {
            x: self.x + other.x,
            y: self.y + other.y,
            z: self.z + other.z,
        }
    }
}

impl<L: Lanes> Sub for Vector3<L> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self {
            x: self.x - other.x,
            y: self.y - other.y,
            z: self.z - other.z,
        }
    }
}

impl<L: Lanes> Neg for Vector3<L> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self {
            x: -self.x,
            y: -self.y,
            z: -self.z,
        }
    }
}

impl<L: Lanes> Mul<L> for Vector3<L> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, factor: L) -> Self {
        Self {
            x: self.x * factor,
            y: self.y * factor,
            z: self.z * factor,
        }
    }
}

impl<L: Lanes> Vector<L> for Vector3<L> {
    #[inline(always)]
    fn new(x: L, y: L, z: L) -> Self {
        Self { x, y, z }
    }

    #[inline(always)]
    fn components(self) -> [L; 3] {
        [self.x, self.y, self.z]
    }
}
