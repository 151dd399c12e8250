//! Random numbers that are the same bits on every machine.

use libm::{log, sqrt};
use rand::Rng;
use rand_pcg::Pcg64;

/// What the numbers are for. Each purpose has its own generator, so that asking for velocities, say, does not move
/// the grains.
#[derive(Clone, Copy, Debug)]
pub(super) enum Purpose {
    Sizes = 1,
    Places = 2,
    Velocities = 3,
}

/// A generator for one purpose.
pub(super) struct RandomNumbers(Pcg64);

impl RandomNumbers {
    pub(super) fn new(seed: u64, purpose: Purpose) -> Self {
        // Neighbouring seeds give related PCG states; mixing them first makes the sequences unrelated.
        let high = mix(seed ^ mix(purpose as u64));
        let low = mix(high.wrapping_add(seed));
        Self(Pcg64::new(
            u128::from(high) << 64 | u128::from(low),
            0xa02_bdbf_7bb3_c0a7_ac28_fa16_a64a_bf96,
        ))
    }

    /// Uniform in [0, 1).
    pub(super) fn uniform(&mut self) -> f64 {
        (self.0.next_u64() >> 11) as f64 * (1.0 / 9_007_199_254_740_992.0)
    }

    /// Uniform in (0, 1).
    pub(super) fn uniform_open(&mut self) -> f64 {
        // Half a step off the lattice of 2^-52 so that neither end is reached.
        ((self.0.next_u64() >> 12) as f64 + 0.5) * (1.0 / 4_503_599_627_370_496.0)
    }

    /// Uniform in [-1, 1).
    pub(super) fn symmetric(&mut self) -> f64 {
        2.0 * self.uniform() - 1.0
    }

    /// Standard normal.
    pub(super) fn normal(&mut self) -> f64 {
        normal_quantile(self.uniform_open())
    }
}

/// The finaliser of SplitMix64 (Steele, Lea, Flood 2014, doi:10.1145/2660193.2660195).
pub(super) fn mix(value: u64) -> u64 {
    let mut z = value.wrapping_add(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

/// Share of the standard normal distribution below `z`.
pub(super) fn normal_below(z: f64) -> f64 {
    0.5 * libm::erfc(-z * std::f64::consts::FRAC_1_SQRT_2)
}

fn polynomial(coefficients: &[f64; 8], x: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, c| sum * x + c)
}

/// Inverse of [`normal_below`] for `0 < p < 1`: algorithm AS 241, PPND16, relative accuracy about 1e-16
/// (Wichura 1988, Appl. Stat. 37, 477, doi:10.2307/2347330).
#[allow(clippy::excessive_precision)]
pub(crate) fn normal_quantile(p: f64) -> f64 {
    const A: [f64; 8] = [
        3.387_132_872_796_366_608_0e0,
        1.331_416_678_917_843_774_5e2,
        1.971_590_950_306_551_442_7e3,
        1.373_169_376_550_946_112_5e4,
        4.592_195_393_154_987_145_7e4,
        6.726_577_092_700_870_085_3e4,
        3.343_057_558_358_812_810_5e4,
        2.509_080_928_730_122_672_7e3,
    ];
    const B: [f64; 8] = [
        1.0,
        4.231_333_070_160_091_125_2e1,
        6.871_870_074_920_579_082_9e2,
        5.394_196_021_424_751_107_7e3,
        2.121_379_430_158_659_586_7e4,
        3.930_789_580_009_271_061_0e4,
        2.872_908_573_572_194_267_4e4,
        5.226_495_278_852_854_561_0e3,
    ];
    const C: [f64; 8] = [
        1.423_437_110_749_683_577_34e0,
        4.630_337_846_156_545_295_90e0,
        5.769_497_221_460_691_405_50e0,
        3.647_848_324_763_204_605_04e0,
        1.270_458_252_452_368_382_58e0,
        2.417_807_251_774_506_117_70e-1,
        2.272_384_498_926_918_458_33e-2,
        7.745_450_142_783_414_076_40e-4,
    ];
    const D: [f64; 8] = [
        1.0,
        2.053_191_626_637_758_821_87e0,
        1.676_384_830_183_803_849_40e0,
        6.897_673_349_851_000_045_50e-1,
        1.481_039_764_274_800_745_90e-1,
        1.519_866_656_361_645_719_66e-2,
        5.475_938_084_995_344_946_00e-4,
        1.050_750_071_644_416_843_24e-9,
    ];
    const E: [f64; 8] = [
        6.657_904_643_501_103_777_20e0,
        5.463_784_911_164_114_369_90e0,
        1.784_826_539_917_291_335_80e0,
        2.965_605_718_285_048_912_30e-1,
        2.653_218_952_657_612_309_30e-2,
        1.242_660_947_388_078_438_60e-3,
        2.711_555_568_743_487_578_15e-5,
        2.010_334_399_292_288_132_65e-7,
    ];
    const F: [f64; 8] = [
        1.0,
        5.998_322_065_558_879_376_90e-1,
        1.369_298_809_227_358_053_10e-1,
        1.487_536_129_085_061_485_25e-2,
        7.868_691_311_456_132_591_00e-4,
        1.846_318_317_510_054_681_80e-5,
        1.421_511_758_316_445_888_70e-7,
        2.044_263_103_389_939_785_64e-15,
    ];
    let q = p - 0.5;
    if q.abs() <= 0.425 {
        let r = 0.425 * 0.425 - q * q;
        return q * polynomial(&A, r) / polynomial(&B, r);
    }
    let r = sqrt(-log(if q < 0.0 { p } else { 1.0 - p }));
    let tail = if r <= 5.0 {
        polynomial(&C, r - 1.6) / polynomial(&D, r - 1.6)
    } else {
        polynomial(&E, r - 5.0) / polynomial(&F, r - 5.0)
    };
    if q < 0.0 { -tail } else { tail }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantile_inverts_the_distribution() {
        for step in -160..=160 {
            let z = 0.05 * f64::from(step);
            // Above the median the share is near 1 and holds no more than 1e-16 absolute; ask the mirrored tail.
            let found = normal_quantile(normal_below(-z.abs()));
            assert!((found + z.abs()).abs() < 1e-12 * (1.0 + z.abs()), "{z}: {found}");
        }
        // Published test values of AS 241.
        assert!((normal_quantile(0.25) + 0.674_489_750_196_081_7).abs() < 1e-15);
        assert!((normal_quantile(0.001) + 3.090_232_306_167_814).abs() < 1e-14);
        assert!((normal_quantile(1e-20) + 9.262_340_089_798_408).abs() < 1e-14);
    }

    #[test]
    fn uniform_numbers_have_the_moments_of_a_uniform_distribution_for_neighbouring_seeds() {
        // 1e5 numbers: mean 1/2 with standard error 9.1e-4, covariance of two seeds 0 with 2.6e-4; 5 sigma allowed.
        let n = 100_000;
        let (mut a, mut b) = (
            RandomNumbers::new(7, Purpose::Places),
            RandomNumbers::new(8, Purpose::Places),
        );
        let (mut mean, mut covariance) = (0.0, 0.0);
        for _ in 0..n {
            let (x, y) = (a.uniform(), b.uniform());
            assert!((0.0..1.0).contains(&x));
            mean += x / f64::from(n);
            covariance += (x - 0.5) * (y - 0.5) / f64::from(n);
        }
        assert!((mean - 0.5).abs() < 4.6e-3, "{mean}");
        assert!(covariance.abs() < 1.4e-3, "{covariance}");
    }

    #[test]
    fn purposes_and_seeds_give_different_sequences_and_equal_ones_the_same() {
        let first = |seed, purpose| RandomNumbers::new(seed, purpose).uniform();
        assert_eq!(first(1, Purpose::Sizes).to_bits(), first(1, Purpose::Sizes).to_bits());
        assert_ne!(first(1, Purpose::Sizes), first(1, Purpose::Places));
        assert_ne!(first(1, Purpose::Sizes), first(2, Purpose::Sizes));
    }
}
