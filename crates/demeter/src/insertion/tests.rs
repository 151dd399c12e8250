use super::*;
use crate::particles::Outside;
use std::f64::consts::PI;

fn materials() -> Vec<Material> {
    let material = |name: &str, density| Material {
        name: name.to_owned(),
        young_modulus: 1e7,
        poisson_ratio: 0.3,
        density,
    };
    vec![material("glass", 2500.0), material("steel", 7800.0)]
}

fn insertion(source: Source) -> Insertion {
    Insertion {
        name: "fill".to_owned(),
        material: 0,
        types: Vec::new(),
        source,
        velocity: DVec3::ZERO,
        velocity_deviation: 0.0,
        angular_velocity: DVec3::ZERO,
        seed: 42,
    }
}

fn random(region: Region, diameter: SizeDistribution, amount: Amount) -> Insertion {
    insertion(Source::Random {
        region,
        diameter,
        amount,
    })
}

fn make_grains(insertion: &Insertion, domain: Option<&Domain>) -> Vec<NewGrain> {
    insert(insertion, &materials(), &[], domain).unwrap().grains
}

fn cube(edge: f64) -> Region {
    Region::Box {
        lower: DVec3::ZERO,
        upper: DVec3::splat(edge),
    }
}

fn domain(edge: f64, periodic: [bool; 3]) -> Domain {
    Domain {
        lower: DVec3::ZERO,
        upper: DVec3::splat(edge),
        periodic,
        outside: Outside::Stop,
    }
}

fn spheres(grains: &[NewGrain]) -> Vec<SizedPlace> {
    grains.iter().map(|g| (g.position, g.radius)).collect()
}

fn volume(grains: &[NewGrain]) -> f64 {
    grains.iter().map(|g| 4.0 / 3.0 * PI * g.radius.powi(3)).sum()
}

fn assert_packed(grains: &[NewGrain], region: &Region, domain: Option<&Domain>) {
    assert_eq!(first_overlap(&spheres(grains), domain), None);
    let space = Space::new(region, domain).unwrap();
    for grain in grains {
        assert!(space.holds(grain.position, grain.radius), "{grain:?}");
        assert!(domain.is_none_or(|d| d.contains(grain.position)));
    }
}

/// FNV-1a over the bits of places and radii.
fn fingerprint(grains: &[NewGrain]) -> u64 {
    let mut hash = 0xcbf2_9ce4_8422_2325_u64;
    for grain in grains {
        for value in [grain.position.x, grain.position.y, grain.position.z, grain.radius] {
            for byte in value.to_bits().to_le_bytes() {
                hash = (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
            }
        }
    }
    hash
}

const HYDROGEL: SizeDistribution = SizeDistribution::Normal {
    mean: 0.0215,
    standard_deviation: 0.0012,
    lower: 0.018,
    upper: 0.025,
};

#[test]
fn loose_packing_in_a_box_reaches_its_fraction_without_overlap() {
    let region = cube(0.3);
    let grains = make_grains(&random(region, HYDROGEL, Amount::VolumeFraction(0.28)), None);
    assert_packed(&grains, &region, None);
    // To half a grain.
    assert!((volume(&grains) / 0.027 - 0.28).abs() < 0.5 * PI / 6.0 * 0.025_f64.powi(3) / 0.027);
}

#[test]
fn packing_of_the_hydrogel_example_reaches_high_densities() {
    let region = Region::Box {
        lower: DVec3::ZERO,
        upper: DVec3::new(0.16519, 0.16583, 0.18),
    };
    for fraction in [0.45, 0.55, 0.57] {
        let start = std::time::Instant::now();
        let result = insert(
            &random(region, HYDROGEL, Amount::VolumeFraction(fraction)),
            &materials(),
            &[],
            None,
        );
        eprintln!(
            "{fraction} {:?} {:?}",
            start.elapsed(),
            result.as_ref().map(|g| g.grains.len())
        );
        if let Ok(g) = result {
            assert_packed(&g.grains, &region, None);
        }
    }
}

#[test]
fn big() {
    let d = domain(1.0, [true, true, false]);
    let region = cube(1.0);
    for fraction in [0.50, 0.58, 0.60] {
        let start = std::time::Instant::now();
        let diameter = SizeDistribution::Uniform {
            lower: 0.03,
            upper: 0.04,
        };
        let result = insert(
            &random(region, diameter, Amount::VolumeFraction(fraction)),
            &materials(),
            &[],
            Some(&d),
        );
        eprintln!(
            "{fraction} {:?} {:?}",
            start.elapsed(),
            result.as_ref().map(|g| g.grains.len())
        );
        if let Ok(g) = result {
            assert_packed(&g.grains, &region, Some(&d));
        }
    }
}
