use super::*;
use crate::insertion::first_overlap;
use crate::particles::{Interior, Outside};
use std::sync::Arc;

fn domain() -> Domain {
    Domain {
        lower: DVec3::splat(-1.0),
        upper: DVec3::splat(1.0),
        periodic: [false; 3],
        outside: Outside::Stop,
    }
}

fn materials() -> Vec<Material> {
    vec![Material {
        name: "glass".to_owned(),
        young_modulus: 1e7,
        poisson_ratio: 0.3,
        density: 2500.0,
    }]
}

fn stream(inlet: Inlet) -> Stream {
    Stream {
        material: 0,
        diameter: SizeDistribution::Uniform {
            lower: 0.01,
            upper: 0.08,
        },
        inlet,
        velocity: DVec3::NEG_Z,
        velocity_deviation: 0.1,
        angular_velocity: DVec3::ZERO,
        seed: 3,
    }
}

fn inlets() -> [Inlet; 5] {
    [
        Inlet::Disc {
            center: DVec3::new(0.1, 0.2, 0.3),
            normal: DVec3::new(0.6, 0.0, 0.8),
            radius: 0.3,
        },
        Inlet::Rectangle {
            center: DVec3::ZERO,
            half_u: DVec3::new(0.0, 0.3, 0.0),
            half_v: DVec3::new(0.2, 0.0, 0.2),
        },
        Inlet::Region(Region::Box {
            lower: DVec3::splat(-0.2),
            upper: DVec3::splat(0.2),
        }),
        Inlet::Mesh(MeshInlet {
            interior: Some(Arc::new(Interior::new(&cube()).unwrap())),
            triangles: Arc::new(cube()),
        }),
        Inlet::Mesh(MeshInlet {
            interior: None,
            triangles: Arc::new(cube()[2..4].to_vec()),
        }),
    ]
}

/// The triangles of a cube from -0.2 to 0.2; the third and fourth are its upper face.
fn cube() -> Vec<[DVec3; 3]> {
    crate::particles::boxed(DVec3::splat(-0.2), DVec3::splat(0.2))
}

/// Lets grains come until one finds no room.
fn fill(source: &Streaming, there: &[(DVec3, f64)], gap: f64) -> Vec<(DVec3, f64)> {
    let mut all = there.to_vec();
    let mut occupied = source.occupied(there.iter().copied(), gap, 1000);
    for number in 0.. {
        let radius = source.radius(number);
        match source.grain((number, 7), radius, &mut occupied, |_, _| false) {
            Some(grain) => all.push((grain.position, grain.radius)),
            None => break,
        }
    }
    all
}

#[test]
fn grains_that_come_lie_in_the_inlet_and_touch_nothing() {
    for inlet in inlets() {
        let source = Streaming::new(&stream(inlet.clone()), &materials(), &domain()).unwrap();
        // a big grain lies in the middle of every inlet
        let there = [(DVec3::new(0.1, 0.2, 0.3), 0.15), (DVec3::ZERO, 0.1)];
        let all = fill(&source, &there, 1e-3);
        assert!(all.len() > 10, "{inlet:?}: {}", all.len());
        assert_eq!(first_overlap(&all, None, |_, _| true), None);
        let grown: Vec<_> = all.iter().map(|g| (g.0, g.1 + 0.499e-3)).collect();
        assert_eq!(
            first_overlap(&grown, None, |_, _| true),
            None,
            "{inlet:?}: the gap is kept"
        );
        for &(place, radius) in &all[there.len()..] {
            let inside = match &inlet {
                Inlet::Disc {
                    center,
                    normal,
                    radius: outer,
                } => {
                    let away = place - *center;
                    away.dot(*normal).abs() < 1e-15 && away.length() + radius < outer * (1.0 + 1e-12)
                }
                Inlet::Rectangle { .. } => {
                    let diagonal = (place.x + place.z) * std::f64::consts::FRAC_1_SQRT_2;
                    let edge = 0.2 * std::f64::consts::SQRT_2;
                    (place.x - place.z).abs() < 1e-15
                        && place.y.abs() + radius < 0.3 + 1e-12
                        && diagonal.abs() + radius < edge + 1e-12
                }
                Inlet::Mesh(MeshInlet { interior: Some(_), .. }) => {
                    place.abs().max_element() + radius < 0.2 * (1.0 + 1e-9)
                }
                Inlet::Mesh(_) => {
                    let across = place.x.abs().max(place.y.abs()) + radius;
                    (place.z - 0.2).abs() < 1e-12 && across < 0.2 * (1.0 + 1e-9)
                }
                Inlet::Region(_) => place.abs().max_element() + radius < 0.2 * (1.0 + 1e-12),
            };
            assert!(inside, "{inlet:?}: {place}, {radius}");
        }
    }
}

#[test]
fn sizes_do_not_depend_on_when_grains_come() {
    let source = Streaming::new(&stream(inlets()[0].clone()), &materials(), &domain()).unwrap();
    let other = Streaming::new(&stream(inlets()[2].clone()), &materials(), &domain()).unwrap();
    let sizes: Vec<f64> = (0..2000).map(|k| source.radius(k)).collect();
    assert!((0..2000).all(|k| other.radius(k).to_bits() == sizes[k as usize].to_bits()));
    // uniform from 0.005 to 0.04: mean 0.0225, standard error 0.0101 / sqrt(2000)
    let mean = sizes.iter().sum::<f64>() / 2000.0;
    assert!((mean - 0.0225).abs() < 5.0 * 0.0101 / 2000f64.sqrt(), "{mean}");
    let mass: f64 = sizes.iter().map(|r| source.mass(*r)).sum::<f64>() / 2000.0;
    assert!((mass / source.mean_mass() - 1.0).abs() < 0.15, "{mass}");
}

#[test]
fn places_change_with_the_time_and_walls_are_in_the_way() {
    let source = Streaming::new(&stream(inlets()[0].clone()), &materials(), &domain()).unwrap();
    let radius = source.radius(0);
    let at = |time: u64| {
        let mut occupied = source.occupied(std::iter::empty(), 0.0, 1);
        let grain = source.grain((0, time), radius, &mut occupied, |p, _| p.y < 0.2);
        grain.unwrap()
    };
    assert_ne!(at(1).position, at(2).position);
    assert_eq!(at(1).position, at(1).position);
    assert_eq!(at(1).velocity, at(2).velocity);
    assert!((1..50).all(|time| at(time).position.y >= 0.2));
    let mut occupied = source.occupied(std::iter::empty(), 0.0, 1);
    assert!(source.grain((0, 1), radius, &mut occupied, |_, _| true).is_none());
}

#[test]
fn inlets_that_cannot_serve_are_refused() {
    let refused = |inlet| Streaming::new(&stream(inlet), &materials(), &domain()).unwrap_err();
    let disc = |center, radius| Inlet::Disc {
        center,
        normal: DVec3::Z,
        radius,
    };
    assert!(matches!(
        refused(disc(DVec3::ZERO, 0.03)),
        InsertionProblem::InletTooSmall { .. }
    ));
    assert!(matches!(
        refused(disc(DVec3::X, 0.3)),
        InsertionProblem::InletOutside { .. }
    ));
    assert!(matches!(refused(disc(DVec3::NAN, 0.3)), InsertionProblem::Region(_)));
}
