use super::*;
use crate::insertion::random::Purpose;
use proptest::prelude::*;

const DRAWS: usize = 100_000;
/// Allowed deviation in standard errors: by chance one of 1.7 million comparisons is beyond.
const SIGMAS: f64 = 5.0;

fn draw(distribution: &SizeDistribution) -> Vec<f64> {
    let sampler = SizeSampler::new(distribution).unwrap();
    let mut random = RandomNumbers::new(3, Purpose::Sizes);
    (0..DRAWS).map(|_| sampler.draw(&mut random)).collect()
}

/// Compares the cumulative curve of drawn diameters with a formula, at given diameters. Each grain weighs 1 or its
/// volume; the standard error of the weighted share is `sqrt(sum (w (below - share))^2) / sum w`.
fn assert_cumulative(drawn: &[f64], basis: Basis, at: &[f64], finer: impl Fn(f64) -> f64) {
    let weight = |d: f64| match basis {
        Basis::Number => 1.0,
        Basis::Mass => d * d * d,
    };
    let total: f64 = drawn.iter().map(|d| weight(*d)).sum();
    for &limit in at {
        let expected = finer(limit);
        let below = |d: f64| if d <= limit { 1.0 } else { 0.0 };
        let found = drawn.iter().map(|d| weight(*d) * below(*d)).sum::<f64>() / total;
        let variance: f64 = drawn
            .iter()
            .map(|d| (weight(*d) * (below(*d) - expected)).powi(2))
            .sum();
        let error = variance.sqrt() / total;
        assert!(
            (found - expected).abs() <= SIGMAS * error + 1e-12,
            "{limit}: {found} {expected} +- {error}"
        );
        assert!(error < 0.02, "the comparison at {limit} says nothing: +- {error}");
    }
}

fn assert_moments(distribution: &SizeDistribution) {
    let sampler = SizeSampler::new(distribution).unwrap();
    let drawn = draw(distribution);
    let (lower, upper) = sampler.bounds();
    assert!(drawn.iter().all(|d| (lower..=upper).contains(d)));
    let compare = |expected: f64, value: &dyn Fn(f64) -> f64| {
        let n = drawn.len() as f64;
        let mean = drawn.iter().map(|d| value(*d)).sum::<f64>() / n;
        let variance = drawn.iter().map(|d| (value(*d) - mean).powi(2)).sum::<f64>() / n;
        let error = (variance / n).sqrt();
        assert!(
            (mean - expected).abs() <= SIGMAS * error + 1e-10 * expected,
            "{mean} {expected} +- {error}"
        );
    };
    compare(sampler.mean_diameter(), &|d| d);
    compare(sampler.mean_volume(), &|d| PI / 6.0 * d * d * d);
}

fn rosin_rammler(exponent: f64) -> SizeDistribution {
    SizeDistribution::RosinRammler {
        scale: 1e-3,
        exponent,
        lower: 2e-4,
        upper: 3e-3,
    }
}

fn table(basis: Basis) -> SizeDistribution {
    SizeDistribution::Table {
        diameters: vec![1e-3, 2e-3, 3e-3, 5e-3],
        finer: vec![0.0, 0.3, 0.3, 1.0],
        basis,
    }
}

fn list(basis: Basis) -> SizeDistribution {
    SizeDistribution::List {
        diameters: vec![2e-3, 1e-3, 4e-3, 9e-3],
        shares: vec![3.0, 1.0, 4.0, 0.0],
        basis,
    }
}

const NORMAL: SizeDistribution = SizeDistribution::Normal {
    mean: 2e-3,
    standard_deviation: 5e-4,
    lower: 1.2e-3,
    upper: 4e-3,
};

const LOGNORMAL: SizeDistribution = SizeDistribution::Lognormal {
    median: 1e-3,
    geometric_deviation: 1.6,
    lower: 4e-4,
    upper: 5e-3,
};

#[test]
fn means_are_those_of_what_is_drawn() {
    let uniform = SizeDistribution::Uniform { lower: 1.0, upper: 3.0 };
    for distribution in [
        SizeDistribution::Single(0.01),
        uniform,
        NORMAL,
        LOGNORMAL,
        rosin_rammler(1.3),
        rosin_rammler(4.0),
        table(Basis::Number),
        table(Basis::Mass),
        list(Basis::Number),
        list(Basis::Mass),
    ] {
        assert_moments(&distribution);
    }
}

#[test]
fn means_are_those_of_the_formulas() {
    let close = |found: f64, expected: f64| assert!((found / expected - 1.0).abs() < 1e-9, "{found} {expected}");
    let uniform = SizeSampler::new(&SizeDistribution::Uniform { lower: 1.0, upper: 3.0 }).unwrap();
    close(uniform.mean_diameter(), 2.0);
    close(uniform.mean_volume(), PI / 6.0 * 10.0);
    // Wide bounds: the uncut moments, d50 exp(s^2/2) and d50^3 exp(9 s^2/2).
    let s = 1.6_f64.ln();
    let wide = SizeSampler::new(&SizeDistribution::Lognormal {
        median: 1e-3,
        geometric_deviation: 1.6,
        lower: 1e-8,
        upper: 1e2,
    });
    let wide = wide.unwrap();
    close(wide.mean_diameter(), 1e-3 * (0.5 * s * s).exp());
    close(wide.mean_volume(), PI / 6.0 * 1e-9 * (4.5 * s * s).exp());
    // Rosin-Rammler with exponent 6, wide bounds: the mean of d^-3 by mass is Gamma(1 - 3/6) / scale^3.
    let wide = SizeSampler::new(&SizeDistribution::RosinRammler {
        scale: 1e-3,
        exponent: 6.0,
        lower: 1e-7,
        upper: 1e-2,
    });
    close(wide.unwrap().mean_volume(), PI / 6.0 * 1e-9 / PI.sqrt());
}

#[test]
fn rosin_rammler_gives_the_mass_curve_that_was_asked_for() {
    for exponent in [0.8, 1.5, 3.0, 5.0] {
        let uncut = |d: f64| 1.0 - (-(d / 1e-3).powf(exponent)).exp();
        let cut = |d: f64| (uncut(d) - uncut(2e-4)) / (uncut(3e-3) - uncut(2e-4));
        let drawn = draw(&rosin_rammler(exponent));
        assert_cumulative(&drawn, Basis::Mass, &[3e-4, 5e-4, 7e-4, 1e-3, 1.4e-3, 2e-3], cut);
    }
}

#[test]
fn tables_and_lists_give_the_curve_that_was_asked_for() {
    for basis in [Basis::Number, Basis::Mass] {
        let at = [1.2e-3, 1.9e-3, 2.5e-3, 3.1e-3, 4e-3, 4.9e-3];
        assert_cumulative(&draw(&table(basis)), basis, &at, |d| match d {
            d if d < 2e-3 => 0.3 * (d - 1e-3) / 1e-3,
            d if d < 3e-3 => 0.3,
            d => 0.3 + 0.7 * (d - 3e-3) / 2e-3,
        });
        assert_cumulative(&draw(&list(basis)), basis, &[1e-3, 2e-3, 3e-3], |d| match d {
            d if d < 2e-3 => 0.125,
            _ => 0.5,
        });
    }
}

#[test]
fn normal_and_lognormal_give_the_cut_curve() {
    let cut =
        |z: f64, low: f64, high: f64| (normal_below(z) - normal_below(low)) / (normal_below(high) - normal_below(low));
    assert_cumulative(
        &draw(&NORMAL),
        Basis::Number,
        &[1.3e-3, 1.7e-3, 2e-3, 2.5e-3, 3e-3],
        |d| cut((d - 2e-3) / 5e-4, -1.6, 4.0),
    );
    let log = |d: f64| (d / 1e-3).ln() / 1.6_f64.ln();
    assert_cumulative(&draw(&LOGNORMAL), Basis::Number, &[5e-4, 8e-4, 1e-3, 2e-3, 3e-3], |d| {
        cut(log(d), log(4e-4), log(5e-3))
    });
    // Far in the upper tail, where the share below is 1 up to rounding.
    let tail = SizeDistribution::Normal {
        mean: 1.0,
        standard_deviation: 0.1,
        lower: 1.5,
        upper: 2.0,
    };
    let drawn = draw(&tail);
    // Above 5 deviations a normal distribution falls nearly as exp(-5 x): P(z > 5.2 | z > 5) from erfc.
    assert_cumulative(&drawn, Basis::Number, &[1.52], |_| {
        1.0 - normal_below(-5.2) / normal_below(-5.0)
    });
}

#[test]
fn draws_are_the_same_bits_everywhere() {
    // Golden bits: a scenario with a seed must give the same grains on any machine and with any version. They may
    // change only with a stated reason, as every packing made before changes with them.
    let sum = |distribution: &SizeDistribution| {
        draw(distribution)
            .iter()
            .fold(0u64, |hash, d| hash.rotate_left(5) ^ d.to_bits())
    };
    let found = [NORMAL, LOGNORMAL, rosin_rammler(1.3), table(Basis::Mass)].map(|d| sum(&d));
    assert_eq!(
        found,
        [
            15_234_301_247_759_628_894,
            9_329_782_347_828_956_524,
            7_247_929_297_686_202_663,
            16_561_957_438_296_088_749
        ]
    );
}

#[test]
fn wrong_distributions_are_refused_with_their_values() {
    let message = |distribution: SizeDistribution| SizeSampler::new(&distribution).unwrap_err().to_string();
    let normal = |mean, standard_deviation, lower, upper| SizeDistribution::Normal {
        mean,
        standard_deviation,
        lower,
        upper,
    };
    let listed = |diameters: &[f64], shares: &[f64]| SizeDistribution::List {
        diameters: diameters.to_vec(),
        shares: shares.to_vec(),
        basis: Basis::Mass,
    };
    let tabled = |diameters: &[f64], finer: &[f64]| SizeDistribution::Table {
        diameters: diameters.to_vec(),
        finer: finer.to_vec(),
        basis: Basis::Number,
    };
    let lognormal = |geometric_deviation| SizeDistribution::Lognormal {
        median: 1.0,
        geometric_deviation,
        lower: 0.5,
        upper: 2.0,
    };
    for (distribution, part) in [
        (SizeDistribution::Single(-1.0), "the diameter is -1"),
        (SizeDistribution::Single(f64::NAN), "is NaN"),
        (
            SizeDistribution::Uniform { lower: 2.0, upper: 1.0 },
            "2 m, must not be above the largest, 1 m",
        ),
        (
            SizeDistribution::Uniform { lower: 0.0, upper: 1.0 },
            "the smallest diameter is 0",
        ),
        (
            normal(1.0, 0.0, 0.5, 2.0),
            "standard deviation is 0; it must be a finite number above 0",
        ),
        (normal(1.0, 0.1, 0.5, f64::INFINITY), "the largest diameter is inf"),
        (normal(1.0, 0.1, 3.0, 4.0), "widen the bounds"),
        (
            lognormal(1.0),
            "geometric standard deviation is 1; it must be a finite number above 1",
        ),
        (listed(&[], &[]), "no diameters"),
        (listed(&[1.0], &[1.0, 2.0]), "1 diameters but 2 shares"),
        (listed(&[1.0, 2.0], &[1.0, -2.0]), "share 2 is -2"),
        (listed(&[1.0], &[0.0]), "all shares are 0"),
        (
            tabled(&[1.0, 1.0], &[0.0, 1.0]),
            "diameter 2 is 1 but the one before it is 1",
        ),
        (tabled(&[1.0, 2.0, 3.0], &[0.0, 0.5, 0.4]), "cumulative share 3 is 0.4"),
        (tabled(&[1.0, 2.0], &[0.1, 1.0]), "run from 0.1 to 1"),
        (tabled(&[1.0, 2.0], &[0.0, 0.9]), "run from 0 to 0.9"),
        (tabled(&[1.0, 2.0], &[0.0, f64::NAN]), "NaN"),
        (tabled(&[1.0], &[0.0]), "give at least 2"),
    ] {
        let found = message(distribution.clone());
        assert!(found.contains(part), "{distribution:?}: {found}");
    }
    let fine = SizeDistribution::RosinRammler {
        scale: 1.0,
        exponent: 50.0,
        lower: 1e-3,
        upper: 1e-2,
    };
    assert!(message(fine).contains("only a share of"));
}

#[test]
fn equal_bounds_are_one_size() {
    let (lower, upper) = (2.0, 2.0);
    for distribution in [
        SizeDistribution::Uniform { lower, upper },
        SizeDistribution::Normal {
            mean: 2.0,
            standard_deviation: 0.1,
            lower,
            upper,
        },
        SizeDistribution::Lognormal {
            median: 2.0,
            geometric_deviation: 1.2,
            lower,
            upper,
        },
        SizeDistribution::RosinRammler {
            scale: 1.0,
            exponent: 3.0,
            lower,
            upper,
        },
    ] {
        let sampler = SizeSampler::new(&distribution).unwrap();
        assert_eq!(
            (sampler.bounds(), sampler.mean_diameter()),
            ((2.0, 2.0), 2.0),
            "{distribution:?}"
        );
        assert!((sampler.mean_volume() / (PI * 8.0 / 6.0) - 1.0).abs() < 1e-15);
        let mut random = RandomNumbers::new(1, Purpose::Sizes);
        assert!((0..10).all(|_| sampler.draw(&mut random) == 2.0), "{distribution:?}");
    }
}

fn any_number() -> impl Strategy<Value = f64> {
    prop_oneof![any::<f64>(), 1e-6..1.0f64, 1e-2..10.0f64, Just(0.0), Just(1.0)]
}

proptest! {
    #[test]
    fn any_numbers_give_an_error_or_diameters_within_the_bounds(
        kind in 0..7, a in any_number(), b in any_number(), lower in any_number(), upper in any_number(),
        mass in any::<bool>(),
    ) {
        let basis = if mass { Basis::Mass } else { Basis::Number };
        let distribution = match kind {
            0 => SizeDistribution::Single(a),
            1 => SizeDistribution::Uniform { lower, upper },
            2 => SizeDistribution::Normal { mean: a, standard_deviation: b, lower, upper },
            3 => SizeDistribution::Lognormal { median: a, geometric_deviation: b, lower, upper },
            4 => SizeDistribution::RosinRammler { scale: a, exponent: b, lower, upper },
            5 => SizeDistribution::List { diameters: vec![lower, upper], shares: vec![a, b], basis },
            _ => SizeDistribution::Table { diameters: vec![lower, a, upper], finer: vec![0.0, b, 1.0], basis },
        };
        if let Ok(sampler) = SizeSampler::new(&distribution) {
            let (lowest, highest) = sampler.bounds();
            prop_assert!(lowest > 0.0 && lowest <= highest && highest.is_finite());
            let mut random = RandomNumbers::new(1, Purpose::Sizes);
            for _ in 0..50 {
                let d = sampler.draw(&mut random);
                prop_assert!((lowest..=highest).contains(&d), "{d}");
            }
            let mean = sampler.mean_diameter();
            prop_assert!((lowest * (1.0 - 1e-9)..=highest * (1.0 + 1e-9)).contains(&mean), "{mean}");
            prop_assert!(sampler.mean_volume() > 0.0);
        }
    }
}
