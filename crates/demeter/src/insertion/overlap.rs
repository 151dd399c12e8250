//! Finding grains that overlap.

use super::place_grid::PlaceGrid;
use crate::particles::Domain;
use glam::DVec3;
use std::ops::ControlFlow;

/// Two grains that overlap.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Overlap {
    /// Index of one grain, the lower.
    pub first: usize,
    /// Index of the other.
    pub second: usize,
    /// Overlap, sum of the radii less the distance [m].
    pub overlap: f64,
    /// Overlap over the smaller radius.
    pub relative: f64,
}

/// Finds the two grains (centre, radius) with the deepest overlap relative to the smaller radius, in linear time. An
/// overlap of a whole radius or more ends the search at once, as no start that is meant has one: the pair is then one
/// of the deepest kind, not the deepest. Distances are the shortest ones across the periodic sides of `domain`. Pairs that
/// do not count are passed over.
pub fn first_overlap(
    grains: &[(DVec3, f64)],
    domain: Option<&Domain>,
    counts: impl Fn(usize, usize) -> bool,
) -> Option<Overlap> {
    let grid = PlaceGrid::holding(domain, grains);
    let mut deepest: Option<Overlap> = None;
    for (i, (_, radius)) in grains.iter().enumerate() {
        let stop = grid.visit_partners(i, 0.0, |near| {
            let sum = radius + near.radius;
            let square = near.difference.length_squared();
            if square < sum * sum && counts(i, near.index) {
                let overlap = sum - square.sqrt();
                let relative = overlap / radius.min(near.radius);
                if overlap > 0.0 && deepest.is_none_or(|d| relative > d.relative) {
                    deepest = Some(Overlap {
                        first: i.min(near.index),
                        second: i.max(near.index),
                        overlap,
                        relative,
                    });
                }
                if relative >= 1.0 {
                    return ControlFlow::Break(());
                }
            }
            ControlFlow::Continue(())
        });
        if stop.is_some() {
            break;
        }
    }
    deepest
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::insertion::random::{Purpose, RandomNumbers};
    use crate::particles::Outside;

    fn any(_: usize, _: usize) -> bool {
        true
    }

    fn brute_force(grains: &[(DVec3, f64)], domain: Option<&Domain>) -> Option<(usize, usize, f64)> {
        let mut deepest: Option<(usize, usize, f64)> = None;
        for i in 0..grains.len() {
            for j in 0..i {
                let (a, b) = (grains[i], grains[j]);
                let d = domain.map_or(a.0 - b.0, |domain| domain.difference(a.0, b.0));
                let relative = (a.1 + b.1 - d.length()) / a.1.min(b.1);
                if relative > 0.0 && deepest.is_none_or(|(_, _, r)| relative > r) {
                    deepest = Some((j, i, relative));
                }
            }
        }
        deepest
    }

    #[test]
    fn finds_what_comparing_all_pairs_finds() {
        for seed in 0..60 {
            let mut random = RandomNumbers::new(seed, Purpose::Places);
            let periodic = [seed % 2 == 0, seed % 3 == 0, seed % 5 == 0];
            let domain = Domain {
                lower: DVec3::splat(-1.0),
                upper: DVec3::new(1.0, 2.0, 1.5),
                periodic,
                outside: Outside::Stop,
            };
            let grains: Vec<(DVec3, f64)> = (0..150)
                .map(|_| {
                    let u = DVec3::new(random.uniform(), random.uniform(), random.uniform());
                    let r = 0.004 + 0.1 * random.uniform() * random.uniform() * random.uniform() * random.uniform();
                    (domain.lower + u * domain.size(), r)
                })
                .collect();
            for domain in [None, Some(&domain)] {
                let expected = brute_force(&grains, domain);
                let found = first_overlap(&grains, domain, any);
                match (expected, found) {
                    // At a radius or more the search ends early.
                    (Some((_, _, relative)), Some(o)) if relative >= 1.0 => assert!(o.relative >= 1.0),
                    (expected, found) => {
                        assert_eq!(
                            expected.map(|e| (e.0, e.1)),
                            found.map(|o| (o.first, o.second)),
                            "seed {seed}"
                        );
                    }
                }
            }
        }
    }

    #[test]
    fn touching_grains_do_not_overlap_and_periodic_sides_count() {
        let domain = Domain {
            lower: DVec3::ZERO,
            upper: DVec3::splat(4.0),
            periodic: [true, false, false],
            outside: Outside::Stop,
        };
        let touching = [(DVec3::ZERO, 0.5), (DVec3::X, 0.5)];
        assert_eq!(first_overlap(&touching, None, any), None);
        let across = [(DVec3::new(0.1, 1.0, 1.0), 0.25), (DVec3::new(3.9, 1.0, 1.0), 0.15)];
        assert_eq!(first_overlap(&across, None, any), None);
        let found = first_overlap(&across, Some(&domain), any).unwrap();
        assert!((found.overlap - 0.2).abs() < 1e-12 && (found.relative - 0.2 / 0.15).abs() < 1e-12);
    }

    #[test]
    fn pairs_that_do_not_count_are_passed_over() {
        let grains = [(DVec3::ZERO, 0.5), (0.1 * DVec3::X, 0.5), (0.8 * DVec3::X, 0.5)];
        let found = first_overlap(&grains, None, |i, j| i.max(j) == 2).unwrap();
        assert_eq!((found.first, found.second), (1, 2));
        assert_eq!(first_overlap(&grains, None, |_, _| false), None);
    }

    #[test]
    fn many_grains_at_one_place_or_spread_over_the_world_do_not_take_long() {
        // A quadratic search would compare 2e10 pairs.
        let heap = vec![(DVec3::ONE, 0.1); 200_000];
        assert!(first_overlap(&heap, None, any).unwrap().relative >= 1.0);
        let far: Vec<_> = (0..200_000)
            .map(|k| (DVec3::new(1e9, 1e3, 1e-3) * f64::from(k), 1e-6))
            .collect();
        assert_eq!(first_overlap(&far, None, any), None);
    }
}
