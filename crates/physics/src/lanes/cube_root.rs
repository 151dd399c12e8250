//! Cube roots, which no processor has an instruction for.

use super::Lanes;

/// A third of the upper bits of a number, and these, are those of its cube root within 3.3 %: a third of the exponent is that of
/// the root, and the bias of exponents has to be put back.
const BIAS: u64 = 0x2a9f_7893;

/// Steps of Halley's method, each of which leaves two thirds of the cube of the error.
const STEPS: usize = 3;

/// Cube root in every lane of numbers from 0 to 1e100, of which none but 0 is below 1e-100: within 3 units of the last digit. The same
/// bits in any lane.
#[inline(always)]
pub fn cube_root<L: Lanes>(x: L) -> L {
    let mut root = rough_cube_root(x);
    for _ in 0..STEPS {
        let cube = root * root * root;
        root = root * (cube + x * 2.0) / (cube * 2.0 + x);
    }
    root.keep(x.gt(L::splat(0.0)))
}

/// Cube root of the same numbers within 3.3 %, some small number for 0.
#[inline(always)]
pub fn rough_cube_root<L: Lanes>(x: L) -> L {
    let mut root = x;
    for one in root.as_mut_slice() {
        // the upper half is enough, and a third of it this product, which processors have for all lanes
        let third = ((one.to_bits() >> 32) * 0xaaaa_aaab) >> 33;
        *one = f64::from_bits((third + BIAS) << 32);
    }
    root
}

#[cfg(test)]
mod tests {
    use super::cube_root;
    use approx::assert_relative_eq;

    #[test]
    fn it_is_that_of_the_library() {
        assert_eq!(cube_root(0.0), 0.0);
        for k in -3000..3000 {
            let x = libm::pow(10.0, f64::from(k) / 30.0);
            assert_relative_eq!(cube_root(x), libm::cbrt(x), max_relative = 7e-16);
        }
    }
}
