//! Balls that nearly fill a hollow of facets, each in nearly the direction of the next, the first and the last in others: one contact, as in
//! a round wall.

use super::one_or_two::kept;
use crate::cases::{Case, Laws, on_threads, one_material, report};
use demeter::simulation::Setup;
use demeter::walls::{Motion, Shape};
use demeter_physics::DVec3;
use std::f64::consts::TAU;

/// Radius of the hollows [m].
const ROUND: f64 = 5e-3;

/// Radius of the hole in a sheet [m].
const HOLE: f64 = 2e-3;

/// Rings of corners, each told by its radius and height, joined by `count` facets around.
fn turned(rings: &[(f64, f64)], count: u32) -> Shape {
    let corner = |(radius, height): (f64, f64), k: u32| {
        let angle = TAU * f64::from(k % count) / f64::from(count);
        DVec3::new(radius * libm::cos(angle), radius * libm::sin(angle), height)
    };
    let mut triangles = Vec::new();
    for pair in rings.windows(2) {
        for k in 0..count {
            let [a, b, c, d] = [
                corner(pair[0], k),
                corner(pair[0], k + 1),
                corner(pair[1], k + 1),
                corner(pair[1], k),
            ];
            triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    // at an apex, two corners are one
    triangles.retain(|[a, b, c]| a != b && b != c && c != a);
    Shape::Mesh { triangles }
}

/// Half a sphere and a tube above it; its lowest point is the origin.
fn cup(count: u32) -> Shape {
    let ring = |k: u32| {
        let angle = TAU * f64::from(k) / f64::from(count);
        let radius = if k == 0 { 0.0 } else { ROUND * libm::sin(angle) };
        (radius, ROUND * (1.0 - libm::cos(angle)))
    };
    let mut rings: Vec<(f64, f64)> = (0..=count / 4).map(ring).collect();
    rings.push((ROUND, 6.0 * ROUND));
    turned(&rings, count)
}

/// A tube along z, in the middle of which a ball flies across to the side of the first facet.
fn tube(count: u32) -> Shape {
    turned(&[(ROUND, -4.0 * ROUND), (ROUND, 4.0 * ROUND)], count)
}

/// A cone about z, from one radius up to 20 mm.
fn cone(least: f64, count: u32) -> Shape {
    turned(&[(least, 0.0), (20e-3, 40e-3)], count)
}

/// A floor and a wall that meet in a quarter of a tube of radius 2 mm, by `count` facets.
fn rounded_corner(count: u32) -> Shape {
    const LESS: f64 = 2e-3;
    let mut profile = vec![(20e-3, 0.0)];
    profile.extend((0..=count).map(|k| {
        let angle = 0.25 * TAU * f64::from(k) / f64::from(count);
        (LESS * (1.0 - libm::sin(angle)), LESS * (1.0 - libm::cos(angle)))
    }));
    profile.push((0.0, 20e-3));
    let strip = |pair: &[(f64, f64)]| {
        let corner = |(x, z): (f64, f64), y: f64| DVec3::new(x, y, z);
        let [a, b] = [pair[0], pair[1]];
        let [a, b, c, d] = [corner(a, -20e-3), corner(b, -20e-3), corner(b, 20e-3), corner(a, 20e-3)];
        [[a, b, c], [a, c, d]]
    };
    Shape::Mesh {
        triangles: profile.windows(2).flat_map(strip).collect(),
    }
}

/// A sheet with a hole of `count` edges.
fn holed(count: u32) -> Shape {
    turned(&[(HOLE, 0.0), (6.0 * HOLE, 0.0)], count)
}

fn ball(wall: Shape, restitution: f64, radius: f64, at: DVec3, velocity: DVec3) -> Setup {
    let mut case = Case::new(one_material(20e6, &Laws::hertz(restitution)));
    case.max_overlap = 0.2;
    case.wall(0, wall, Motion::Rest);
    case.grain(radius, at, velocity);
    case.setup()
}

#[test]
fn a_ball_has_the_restitution_that_was_asked_for() {
    on_threads(1, || {
        let mut worst = 0.0f64;
        for share in [0.6, 0.8, 0.92, 0.97] {
            let radius = share * ROUND;
            for count in [24, 48] {
                // against the middle of a facet, and the middle of the ring of facets at the apex
                let half = 0.5 * TAU / f64::from(count);
                let outwards = DVec3::new(libm::cos(half), libm::sin(half), 0.0);
                for (name, wall, at, velocity) in [
                    ("tube", tube(count), DVec3::ZERO, 0.6 * outwards),
                    ("cup", cup(count), DVec3::Z * (ROUND + 0.3e-3), -0.6 * DVec3::Z),
                ] {
                    let (ratio, residual) = kept(ball(wall, 0.5, radius, at, velocity));
                    let restitution = ratio.sqrt();
                    worst = worst.max((restitution - 0.5).abs());
                    assert!(
                        (restitution - 0.5).abs() < 2e-4 && residual < 1e-3,
                        "{name} of {count}, {share}: {restitution} {residual}"
                    );
                }
            }
        }
        report("restitution 0.5 of balls that nearly fill hollows of facets", worst);
    });
}

#[test]
fn a_ball_too_large_for_a_rounded_corner_is_held_by_both_sides() {
    on_threads(1, || {
        let mut worst = 0.0f64;
        for count in [5, 6, 9] {
            for k in 0..10 {
                // both sides are overlapped first, and then what leads from the one to the other
                let at = DVec3::new(3e-3 + 2e-5 * f64::from(k), 0.0, 3e-3);
                let (ratio, residual) = kept(ball(
                    rounded_corner(count),
                    1.0,
                    2.4e-3,
                    at,
                    DVec3::new(-0.6, 0.0, -0.6),
                ));
                let off = (ratio - 1.0).abs().max(residual);
                worst = worst.max(off);
                // what leads from one side to the other counts to the one or the other as it begins to hold
                assert!(off < 1e-2, "{count}, {k}: {ratio} {residual}");
            }
        }
        report("energy of balls too large for rounded corners", worst);
    });
}

#[test]
fn a_ball_keeps_its_energy_wherever_it_goes() {
    on_threads(1, || {
        let mut worst = 0.0f64;
        for count in [16, 24, 32, 48] {
            for (name, wall, radius) in [
                ("tube", tube(count), 0.92 * ROUND),
                ("tube", tube(count), 0.8 * ROUND),
                ("cone", cone(0.0, count), 2e-3),
                ("blunt cone", cone(3e-3, count), 4e-3),
                ("cup", cup(count), 0.92 * ROUND),
                ("cup", cup(count), 0.8 * ROUND),
            ] {
                for k in 0..12 {
                    let along = f64::from(k) - 5.5;
                    let (at, velocity) = match name {
                        "tube" => (DVec3::new(1e-5 * along, 5e-5, 0.0), DVec3::new(0.1 * along, 0.4, 0.02)),
                        "cup" => (
                            DVec3::new(2e-5 * along, 5e-5, ROUND + 0.3e-3),
                            DVec3::new(0.01 * along, 0.03, -0.6),
                        ),
                        _ => (
                            DVec3::new(1.5e-4 * along, 7e-4, 18e-3),
                            DVec3::new(0.01 * along, 0.0, -0.6),
                        ),
                    };
                    let (ratio, residual) = kept(ball(wall.clone(), 1.0, radius, at, velocity));
                    let off = (ratio - 1.0).abs().max(residual);
                    worst = worst.max(off);
                    assert!(off < 1e-3, "{name} of {count}, {k}: {ratio} {residual}");
                }
            }
        }
        report("energy of balls that nearly fill hollows of facets", worst);
    });
}

#[test]
fn a_ball_on_the_rim_of_a_hole_touches_it_once() {
    on_threads(1, || {
        let (mut worst, mut elastic) = (0.0f64, 0.0f64);
        for count in [8, 12, 16, 24, 48] {
            for radius in [2.3e-3, 2.75e-3, 4e-3] {
                // edges further apart are contacts of their own
                if HOLE * libm::sin(TAU / f64::from(count)) > 0.37 * radius {
                    continue;
                }
                let above = DVec3::Z * (radius + 0.3e-3);
                let (ratio, residual) = kept(ball(holed(count), 0.5, radius, above, -0.5 * DVec3::Z));
                let off = (ratio.sqrt() - 0.5).abs().max(residual);
                worst = worst.max(off);
                assert!(off < 1e-3, "{count}, {radius}: {ratio} {residual}");
                for k in 0..8 {
                    let beside = f64::from(k) * DVec3::new(3e-5, 1e-5, 0.0);
                    let velocity = DVec3::new(0.02 * f64::from(k), -0.05, -0.5);
                    let (ratio, residual) = kept(ball(holed(count), 1.0, radius, above + beside, velocity));
                    let off = (ratio - 1.0).abs().max(residual);
                    elastic = elastic.max(off);
                    assert!(off < 1e-3, "{count}, {radius}, {k}: {ratio} {residual}");
                }
            }
        }
        report("restitution 0.5 of balls on the rim of a round hole", worst);
        report("energy of balls on the rim of a round hole", elastic);
    });
}
