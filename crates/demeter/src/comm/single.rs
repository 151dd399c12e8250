//! One process: a border is a periodic side.

use crate::particles::{Domain, Grains, Row};
use glam::DVec3;

/// Periodic sides of one process.
#[derive(Clone, Debug)]
pub struct Single {
    domain: Domain,
    shifts: [Row; 27],
}

impl Single {
    /// The borders of a domain.
    pub fn new(domain: Domain) -> Self {
        let size = domain.size();
        let mut shifts = [Row::default(); 27];
        for (code, shift) in shifts.iter_mut().enumerate() {
            for (axis, digit) in [code / 9, code / 3 % 3, code % 3].into_iter().enumerate() {
                if domain.periodic[axis] && digit != 1 {
                    shift.vector[axis] = if digit == 2 { size[axis] } else { -size[axis] };
                }
            }
        }
        Self { domain, shifts }
    }

    /// Shift to add to a difference of positions, by its code.
    #[inline(always)]
    pub fn shift(&self, code: u8) -> DVec3 {
        self.shifts[code as usize].vector
    }

    /// All shifts by their codes; none where no side is periodic.
    #[inline(always)]
    pub fn shifts(&self) -> &[[f64; 4]] {
        if self.domain.periodic.contains(&true) {
            bytemuck::cast_slice(&self.shifts)
        } else {
            &[]
        }
    }

    /// Code of the shift that makes the difference of two positions the shortest.
    #[inline]
    pub fn nearest_image(&self, difference: DVec3) -> u8 {
        let size = self.domain.size();
        let digit = |axis: usize| {
            if !self.domain.periodic[axis] {
                1
            } else if difference[axis] > 0.5 * size[axis] {
                0
            } else if difference[axis] < -0.5 * size[axis] {
                2
            } else {
                1
            }
        };
        digit(0) * 9 + digit(1) * 3 + digit(2)
    }

    /// Code of no shift.
    pub const UNSHIFTED: u8 = 13;

    /// Code of the opposite shift.
    #[inline(always)]
    pub fn opposite(code: u8) -> u8 {
        26 - code
    }

    /// Puts every grain back into the periodic box and counts its crossings.
    pub fn wrap(&self, grains: &mut Grains) {
        let size = self.domain.size();
        for axis in (0..3).filter(|&k| self.domain.periodic[k]) {
            for (position, image) in grains.position.iter_mut().zip(&mut grains.image) {
                // one crossing at a time keeps the bits of the ordinary case simple; a lost grain is caught by the watch
                if position[axis] >= self.domain.upper[axis] {
                    position[axis] -= size[axis];
                    image[axis] += 1;
                } else if position[axis] < self.domain.lower[axis] {
                    position[axis] += size[axis];
                    image[axis] -= 1;
                }
            }
        }
    }

    /// Position without the wrapping: where the grain would be in open space.
    #[inline]
    pub fn unwrapped(&self, position: DVec3, image: [i32; 3]) -> DVec3 {
        let size = self.domain.size();
        let mut p = position;
        for axis in 0..3 {
            if image[axis] != 0 {
                p[axis] += f64::from(image[axis]) * size[axis];
            }
        }
        p
    }

    /// The domain.
    pub fn domain(&self) -> &Domain {
        &self.domain
    }
}
