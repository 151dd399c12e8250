//! Kernels of coarse graining: how the mass of a grain is spread over space.

use std::f64::consts::{PI, SQRT_2};

/// A Gaussian that is narrower than this many widths is no longer one.
pub const LEAST_CUT: f64 = 1.0;
/// Farther out a Gaussian is nothing, to `f64`.
pub const LARGEST_CUT: f64 = 8.0;

/// Shape of a kernel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum KernelShape {
    /// `exp(-r^2/(2 w^2))` with the width `w`, nothing beyond `cut` widths.
    Gaussian {
        /// Where it is cut, in widths.
        cut: f64,
    },
    /// Lucy's polynomial `(1 + 3 a)(1 - a)^3`, `a = r/w`, nothing beyond the width `w` (L. B. Lucy, Astron. J. 82 (1977) 1013).
    Lucy,
}

/// A kernel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Kernel {
    /// Its shape.
    pub shape: KernelShape,
    /// Standard deviation of a Gaussian, radius of the support of Lucy's polynomial [m].
    pub width: f64,
}

impl Kernel {
    /// Distance beyond which the kernel is nothing [m].
    pub fn reach(&self) -> f64 {
        match self.shape {
            KernelShape::Gaussian { cut } => cut * self.width,
            KernelShape::Lucy => self.width,
        }
    }

    /// The kernel in some dimensions, 0 to 3, with an integral of 1 over them.
    pub fn in_dimensions(&self, dimensions: usize) -> KernelIn {
        let w = self.width;
        let volume = [1.0, w, w * w, w * w * w][dimensions.min(3)];
        let whole = match self.shape {
            KernelShape::Gaussian { cut } => gaussian_integral(dimensions, cut),
            // integrals of (1 + 3 a)(1 - a)^3 over the line, the disc and the ball
            KernelShape::Lucy => [1.0, 4.0 / 5.0, PI / 5.0, 16.0 * PI / 105.0][dimensions.min(3)],
        };
        KernelIn {
            kernel: *self,
            factor: 1.0 / (whole * volume),
            is_constant: dimensions == 0,
        }
    }
}

/// Integral of `exp(-x^2/2)` over the ball of radius `cut` in so many dimensions.
fn gaussian_integral(dimensions: usize, cut: f64) -> f64 {
    let edge = libm::exp(-0.5 * cut * cut);
    let inside = libm::erf(cut / SQRT_2);
    match dimensions {
        0 => 1.0,
        1 => libm::sqrt(2.0 * PI) * inside,
        2 => 2.0 * PI * (1.0 - edge),
        _ => 2.0 * PI * libm::sqrt(2.0 * PI) * inside - 4.0 * PI * cut * edge,
    }
}

/// A normalised kernel in given dimensions.
#[derive(Clone, Copy, Debug)]
pub struct KernelIn {
    kernel: Kernel,
    factor: f64,
    is_constant: bool,
}

impl KernelIn {
    /// Distance beyond which it is nothing [m].
    pub fn reach(&self) -> f64 {
        if self.is_constant { 0.0 } else { self.kernel.reach() }
    }

    /// Its value at a squared distance [1/m^dimensions].
    pub fn at(&self, distance2: f64) -> f64 {
        if self.is_constant {
            return 1.0;
        }
        let (reach, w) = (self.kernel.reach(), self.kernel.width);
        if distance2 >= reach * reach {
            return 0.0;
        }
        match self.kernel.shape {
            KernelShape::Gaussian { .. } => self.factor * libm::exp(-0.5 * distance2 / (w * w)),
            KernelShape::Lucy => {
                let a = distance2.sqrt() / w;
                let b = 1.0 - a;
                self.factor * (1.0 + 3.0 * a) * b * b * b
            }
        }
    }

    /// Its integral along a straight line that passes at the squared distance `off2`, from `start` to `end`, both counted from
    /// the foot of the perpendicular [m]. It is exact, to rounding: of a Gaussian the difference of two error functions, of
    /// Lucy's polynomial the difference of two values of its antiderivative.
    pub fn along(&self, off2: f64, start: f64, end: f64) -> f64 {
        if self.is_constant {
            return end - start;
        }
        let (reach, w) = (self.kernel.reach(), self.kernel.width);
        let half2 = reach * reach - off2;
        if half2 <= 0.0 {
            return 0.0;
        }
        let half = half2.sqrt();
        let (start, end) = (start.clamp(-half, half), end.clamp(-half, half));
        if start >= end {
            return 0.0;
        }
        match self.kernel.shape {
            KernelShape::Gaussian { .. } => {
                let error = |t: f64| libm::erf(t / (SQRT_2 * w));
                let line = w * libm::sqrt(0.5 * PI) * (error(end) - error(start));
                self.factor * libm::exp(-0.5 * off2 / (w * w)) * line
            }
            KernelShape::Lucy => {
                let p2 = off2.max(0.0) / (w * w);
                self.factor * w * (lucy_antiderivative(p2, end / w) - lucy_antiderivative(p2, start / w))
            }
        }
    }
}

/// Antiderivative over `t` of `1 - 6 a^2 + 8 a^3 - 3 a^4` with `a^2 = p2 + t^2`.
fn lucy_antiderivative(p2: f64, t: f64) -> f64 {
    let t2 = t * t;
    let squares = t * (p2 + t2 / 3.0);
    let fourths = t * (p2 * p2 + 2.0 / 3.0 * p2 * t2 + t2 * t2 / 5.0);
    let mut cubes = 0.125 * t * (2.0 * t2 + 5.0 * p2) * (p2 + t2).sqrt();
    // where the line passes through the centre the term is nothing, though its factors are not
    if p2 > 1e-150 {
        cubes += 0.375 * p2 * p2 * libm::asinh(t / p2.sqrt());
    }
    t - 6.0 * squares + 8.0 * cubes - 3.0 * fourths
}

#[cfg(test)]
mod tests {
    use super::*;

    fn kernels() -> [Kernel; 3] {
        let gaussian = |cut| KernelShape::Gaussian { cut };
        [gaussian(3.0), gaussian(5.0), KernelShape::Lucy].map(|shape| Kernel { shape, width: 0.7 })
    }

    /// Midpoint rule.
    fn integral(from: f64, to: f64, f: impl Fn(f64) -> f64) -> f64 {
        let n = 200_000;
        let h = (to - from) / f64::from(n);
        (0..n).map(|k| f(from + (f64::from(k) + 0.5) * h)).sum::<f64>() * h
    }

    #[test]
    fn a_kernel_has_an_integral_of_one_in_every_number_of_dimensions() {
        for kernel in kernels() {
            let reach = kernel.reach();
            let sphere = |d: usize, r: f64| [0.0, 2.0, 2.0 * PI * r, 4.0 * PI * r * r][d];
            for d in 1..=3 {
                let k = kernel.in_dimensions(d);
                let whole = integral(0.0, reach, |r| sphere(d, r) * k.at(r * r));
                assert!((whole - 1.0).abs() < 1e-8, "{kernel:?} in {d}: {whole}");
                assert_eq!(k.at(reach * reach), 0.0);
            }
            assert_eq!(kernel.in_dimensions(0).at(7.0), 1.0);
        }
    }

    #[test]
    fn the_integral_along_a_line_is_that_of_the_values_on_it() {
        for kernel in kernels() {
            for d in 1..=3 {
                let k = kernel.in_dimensions(d);
                for (off, start, end) in [(0.0, -0.2, 0.5), (0.3, 0.1, 9.0), (1e-9, -0.6, 0.0), (0.69, -1.0, 1.0)] {
                    let told = integral(start, end, |t| k.at(off * off + t * t));
                    let exact = k.along(off * off, start, end);
                    assert!((told - exact).abs() < 2e-4 * (1.0 + exact), "{told} {exact}");
                    // away from the cut, where the midpoint rule meets a jump, it is far more exact
                    if end < kernel.reach() && off < 0.5 {
                        assert!((told - exact).abs() < 1e-9, "{kernel:?} {off}: {told} {exact}");
                    }
                }
                assert_eq!(k.along(kernel.reach() * kernel.reach(), -1.0, 1.0), 0.0);
                let (left, right) = (k.along(0.04, -1.0, 0.3), k.along(0.04, 0.3, 1.0));
                assert!((left + right - k.along(0.04, -1.0, 1.0)).abs() < 1e-14);
            }
        }
    }
}
