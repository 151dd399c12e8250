use super::*;
use crate::particles::{Domain, NewGrain, Outside};

fn random_grains(count: u32, smallest: f64, domain: &Domain) -> Grains {
    let mut state = 12345u64;
    let mut uniform = move || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1u64 << 53) as f64
    };
    let mut grains = Grains::default();
    for id in 1..=count {
        let share = uniform();
        let position = domain.lower + DVec3::new(uniform(), uniform(), uniform()) * domain.size();
        let radius = smallest * libm::pow(0.1 / smallest, share * share);
        // ids run against the order of the indices, so that both orders are seen
        grains.push(
            count + 1 - id,
            &NewGrain {
                fixed: false,
                material: 0,
                radius,
                density: 1.0,
                position,
                velocity: DVec3::ZERO,
                angular_velocity: DVec3::ZERO,
            },
        );
    }
    grains
}

fn check_against_all_pairs(periodic: [bool; 3], smallest: f64) {
    let domain = Domain {
        lower: DVec3::splat(-0.5),
        upper: DVec3::splat(0.5),
        periodic,
        outside: Outside::Stop,
    };
    let comm = Single::new(domain);
    let grains = random_grains(900, smallest, &domain);
    let skin = 0.02;
    let found = Neighbours::find(&grains, &[], &comm, skin);
    let mut expected = Vec::new();
    for i in 0..grains.len() {
        for j in 0..grains.len() {
            let d = domain.difference(grains.position[i], grains.position[j]);
            if grains.id[i] < grains.id[j] && d.length() < grains.radius(i) + grains.radius(j) + skin {
                expected.push((i as u32, j as u32));
            }
        }
    }
    let mut got: Vec<_> = found.pairs.iter().map(|p| (p.i, p.j)).collect();
    got.sort_unstable();
    assert!(expected.len() > 200, "the case must hold many pairs");
    assert_eq!(got, expected);
    for p in &found.pairs {
        let (a, b) = (grains.position[p.i as usize], grains.position[p.j as usize]);
        assert!((a - b + comm.shift(p.shift) - domain.difference(a, b)).length() < 1e-15);
    }
    for g in 0..grains.len() {
        let partners: Vec<u32> = (found.pairs_of(g))
            .map(|(k, first)| grains.id[if first { found.pairs[k].j } else { found.pairs[k].i } as usize])
            .collect();
        assert!(partners.is_sorted());
    }
}

#[test]
fn the_grid_finds_what_all_pairs_find() {
    check_against_all_pairs([false; 3], 0.05);
    check_against_all_pairs([true, false, true], 0.05);
    check_against_all_pairs([true; 3], 0.002);
}
