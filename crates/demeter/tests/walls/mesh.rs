//! Contacts of spheres and triangle meshes: seams are not felt, edges and corners count once.

use demeter::walls::{Mesh, MeshError, SurfaceContact};
use glam::{DQuat, DVec3};
use proptest::prelude::*;
use rand_pcg::Pcg64;
use rand_pcg::rand_core::Rng;

type Corners = Vec<[DVec3; 3]>;

struct Dice(Pcg64);

impl Dice {
    fn new(seed: u128) -> Self {
        Dice(Pcg64::new(seed, 0))
    }

    fn between(&mut self, lower: f64, upper: f64) -> f64 {
        lower + (upper - lower) * ((self.0.next_u64() >> 11) as f64 * 2f64.powi(-53))
    }

    fn point(&mut self, half: f64) -> DVec3 {
        DVec3::new(
            self.between(-half, half),
            self.between(-half, half),
            self.between(-half, half),
        )
    }
}

fn v(x: f64, y: f64, z: f64) -> DVec3 {
    DVec3::new(x, y, z)
}

fn contacts(mesh: &Mesh, centre: DVec3, reach: f64) -> Vec<SurfaceContact> {
    let mut out = Vec::new();
    mesh.contacts(centre, (reach, 0.0), &mut out);
    assert!(
        out.windows(2).all(|pair| pair[0].element < pair[1].element),
        "sorted and unique: {out:?}"
    );
    for contact in &out {
        assert!(
            (contact.normal.length() - 1.0).abs() < 1e-12 && contact.distance < reach,
            "{contact:?}"
        );
    }
    out
}

fn quad(a: DVec3, b: DVec3, c: DVec3, d: DVec3) -> [[DVec3; 3]; 2] {
    [[a, b, c], [a, c, d]]
}

/// A plane of `cells` x `cells` squares on `[0, 1]^2`, inner points shifted within the plane, diagonals and windings by
/// chance; then mapped by `place`.
fn plane(cells: usize, jitter: f64, dice: &mut Dice, place: impl Fn(DVec3) -> DVec3) -> Corners {
    let step = 1.0 / cells as f64;
    let mut points = Vec::new();
    for i in 0..=cells {
        for j in 0..=cells {
            let inner = i > 0 && j > 0 && i < cells && j < cells;
            let share = if inner { jitter * step } else { 0.0 };
            let shift = v(dice.between(-share, share), dice.between(-share, share), 0.0);
            points.push(place(v(i as f64 * step, j as f64 * step, 0.0) + shift));
        }
    }
    let at = |i: usize, j: usize| points[i * (cells + 1) + j];
    let mut out = Vec::new();
    for i in 0..cells {
        for j in 0..cells {
            let (a, b, c, d) = (at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
            let pair = if dice.between(0.0, 1.0) < 0.5 {
                quad(a, b, c, d)
            } else {
                quad(b, c, d, a)
            };
            for [p, q, r] in pair {
                out.push(if dice.between(0.0, 1.0) < 0.5 {
                    [p, q, r]
                } else {
                    [p, r, q]
                });
            }
        }
    }
    out
}

fn cuboid(half: DVec3) -> Corners {
    let p = |x: f64, y: f64, z: f64| half * v(x, y, z);
    let mut out = Vec::new();
    for s in [-1.0, 1.0] {
        out.extend(quad(p(s, -1.0, -1.0), p(s, 1.0, -1.0), p(s, 1.0, 1.0), p(s, -1.0, 1.0)));
        out.extend(quad(p(-1.0, s, -1.0), p(1.0, s, -1.0), p(1.0, s, 1.0), p(-1.0, s, 1.0)));
        out.extend(quad(p(-1.0, -1.0, s), p(1.0, -1.0, s), p(1.0, 1.0, s), p(-1.0, 1.0, s)));
    }
    out
}

/// Lateral surface of a cylinder about z, of radius 1, made of facets that are cut in length too.
fn faceted_cylinder(facets: usize) -> Corners {
    let ring = |k: usize, z: f64| {
        let angle = std::f64::consts::TAU * (k % facets) as f64 / facets as f64;
        v(angle.cos(), angle.sin(), z)
    };
    let levels = [-1.0, -0.3, 0.2, 1.0];
    let mut out = Vec::new();
    for k in 0..facets {
        for z in levels.windows(2) {
            out.extend(quad(ring(k, z[0]), ring(k + 1, z[0]), ring(k + 1, z[1]), ring(k, z[1])));
        }
    }
    out
}

#[test]
fn rolling_over_coplanar_seams_is_one_contact_with_one_normal() {
    let turns = [
        DQuat::IDENTITY,
        DQuat::from_xyzw(0.1, 0.7, -0.2, 0.4).normalize(),
        DQuat::from_xyzw(-0.6, 0.2, 0.3, 0.9).normalize(),
    ];
    for (seed, (turn, jitter)) in turns
        .into_iter()
        .flat_map(|t| [(t, 0.0), (t, 0.2), (t, 0.35)])
        .enumerate()
    {
        let mut dice = Dice::new(seed as u128);
        let place = |p: DVec3| turn * p + v(3.0, -2.0, 1.0);
        let mesh = Mesh::new(&plane(11, jitter, &mut dice, place)).unwrap();
        let (radius, height) = (0.2, 0.17);
        let normal = turn * DVec3::Z;
        let steps = 2000;
        for step in 0..=steps {
            let s = f64::from(step) / f64::from(steps);
            // Along seams, along a line of vertices, along a diagonal, and askew.
            for (from, to) in [
                (v(0.3, 5.0 / 11.0, height), v(0.7, 5.0 / 11.0, height)),
                (v(0.25, 0.25, height), v(0.75, 0.75, height)),
                (v(0.22, 0.41, height), v(0.78, 0.63, height)),
            ] {
                let found = contacts(&mesh, place(from.lerp(to, s)), radius);
                assert_eq!(found.len(), 1, "step {step}: {found:?}");
                assert!((found[0].normal - normal).length() < 1e-12, "step {step}: {found:?}");
                assert!((found[0].distance - height).abs() < 1e-12);
                assert_eq!(found[0].element, 0, "the key stays that of the flat patch");
            }
        }
    }
}

#[test]
fn parts_of_one_plane_that_share_no_corners_are_one_plane() {
    let turn = DQuat::from_xyzw(0.1, 0.7, -0.2, 0.4).normalize();
    let place = |shift: DVec3| move |p: DVec3| turn * (p + shift) + v(3.0, -2.0, 1.0);
    // the second abuts on the first, or overlaps it by a third
    for (cells, shift) in [((4, 3), 1.0), ((5, 4), 0.66), ((2, 7), 1.0)] {
        let mut dice = Dice::new(3);
        let mut corners = plane(cells.0, 0.2, &mut dice, place(DVec3::ZERO));
        corners.extend(plane(cells.1, 0.2, &mut dice, place(v(shift, 0.0, 0.0))));
        let mesh = Mesh::new(&corners).unwrap();
        let (radius, mut asked) = (0.2, 0);
        for _ in 0..4000 {
            let deep = dice.between(0.0, 0.5);
            let (x, y) = (dice.between(0.4, 1.3), dice.between(0.3, 0.7));
            let height = radius * (1.0 - deep);
            let found = contacts(&mesh, place(DVec3::ZERO)(v(x, y, height)), radius);
            assert_eq!(found.len(), 1, "{x} {y}, {deep} of the radius deep: {found:?}");
            assert!((found[0].normal - turn * DVec3::Z).length() < 1e-11, "{found:?}");
            assert!((found[0].distance - height).abs() < 1e-12, "{found:?}");
            asked += usize::from(deep > 0.1 && (x - 1.0).abs() < 0.5 * radius);
        }
        assert!(asked > 300, "{asked}");
    }
    // across a slot the rim on the other side is felt
    let mut dice = Dice::new(4);
    let mut corners = plane(4, 0.0, &mut dice, |p| p);
    corners.extend(plane(3, 0.0, &mut dice, |p| p + v(1.05, 0.0, 0.0)));
    let slotted = Mesh::new(&corners).unwrap();
    assert_eq!(contacts(&slotted, v(0.96, 0.5, 0.17), 0.2).len(), 2);
}

#[test]
fn the_edges_of_a_slit_are_one_contact_or_two_however_deep_a_sphere_sinks() {
    let (radius, mut counts) = (1.0, Vec::new());
    for width in [0.25, 0.34, 0.36, 0.37, 0.373, 0.376, 0.38, 0.45] {
        let bar = |from: f64, to: f64| quad(v(from, -5.0, 0.0), v(to, -5.0, 0.0), v(to, 5.0, 0.0), v(from, 5.0, 0.0));
        let slit = Mesh::new(&[bar(-9.0, -0.5 * width), bar(0.5 * width, 9.0)].concat()).unwrap();
        let height = |overlap: f64| ((radius - overlap) * (radius - overlap) - 0.25 * width * width).sqrt();
        let count = |overlap: f64| contacts(&slit, v(0.0, 0.2, height(overlap)), radius).len();
        let touching = count(1e-6);
        for step in 1..=200 {
            assert_eq!(count(5e-4 * f64::from(step)), touching, "{width}: step {step}");
        }
        counts.push(touching);
    }
    assert_eq!(counts, [1, 1, 1, 1, 1, 2, 2, 2]);
}

#[test]
fn the_other_side_of_a_bend_is_met_with_little_overlap() {
    let radius = 1.0;
    for degrees in [22.0, 24.0, 30.0, 38.0, 45.0, 55.0] {
        let bend = f64::to_radians(degrees);
        let rising = v(bend.cos(), 0.0, bend.sin());
        let mut corners: Corners = quad(
            v(-9.0, -9.0, 0.0),
            v(0.0, -9.0, 0.0),
            v(0.0, 9.0, 0.0),
            v(-9.0, 9.0, 0.0),
        )
        .to_vec();
        let end = 9.0 * rising;
        corners.extend(quad(
            v(0.0, -9.0, 0.0),
            end + v(0.0, -9.0, 0.0),
            end + v(0.0, 9.0, 0.0),
            v(0.0, 9.0, 0.0),
        ));
        let trough = Mesh::new(&corners).unwrap();
        for deep in [0.02, 0.1, 0.15, 0.2] {
            let mut before = 0.0;
            for step in 0..20_000 {
                let x = -1.5 + f64::from(step) / 10_000.0;
                let found = contacts(&trough, v(x, 0.3, radius * (1.0 - deep)), radius);
                let slope = v(-bend.sin(), 0.0, bend.cos());
                let overlap = found.iter().find(|contact| contact.normal.distance(slope) < 1e-9);
                let overlap = overlap.map_or(0.0, |contact| radius - contact.distance);
                assert!(
                    overlap - before < 0.04 * radius,
                    "{degrees} deg, {deep}: from {before} to {overlap} at {x}"
                );
                // as the plane of the far side tells it, once that is met
                let plane = radius - v(x, 0.3, radius * (1.0 - deep)).dot(slope);
                assert!(
                    overlap == 0.0 || (overlap - plane).abs() < 1e-12,
                    "{degrees} deg, {deep}: {overlap} {plane}"
                );
                before = overlap;
            }
            assert!(before > 0.0);
        }
    }
}

#[test]
fn a_convex_body_touches_once_in_the_direction_of_its_closest_point() {
    let half = v(0.5, 0.3, 0.8);
    let mesh = Mesh::new(&cuboid(half)).unwrap();
    mesh.require_closed().unwrap();
    let mut dice = Dice::new(5);
    let ticks = [-1.0, -0.8, -0.5, -0.3, 0.0, 0.3, 0.5, 0.8, 1.0];
    let mut centres: Vec<DVec3> = (0..20_000).map(|_| dice.point(1.3)).collect();
    for x in ticks {
        for y in ticks {
            centres.extend(ticks.map(|z| v(x, y, z)));
        }
    }
    let mut outside = 0;
    for centre in centres {
        let foot = centre.clamp(-half, half);
        let gap = centre.distance(foot);
        if gap < 1e-9 {
            continue;
        }
        outside += 1;
        // Not so far that the back faces are in reach too: these are contacts in other directions.
        let found = contacts(&mesh, centre, gap + 0.05);
        let deepest = found.iter().min_by(|a, b| a.distance.total_cmp(&b.distance)).unwrap();
        assert!((deepest.distance - gap).abs() < 1e-12, "{centre} {found:?}");
        assert!(
            (deepest.normal - (centre - foot) / gap).length() < 1e-7,
            "{centre} {found:?}"
        );
        assert_eq!(found.len(), 1, "{centre}: {found:?}");
    }
    assert!(outside > 10_000);
}

#[test]
fn concave_corners_touch_once_per_face() {
    let floor = quad(v(0.0, 0.0, 0.0), v(1.0, 0.0, 0.0), v(1.0, 1.0, 0.0), v(0.0, 1.0, 0.0));
    let west = quad(v(0.0, 0.0, 0.0), v(0.0, 1.0, 0.0), v(0.0, 1.0, 1.0), v(0.0, 0.0, 1.0));
    let south = quad(v(0.0, 0.0, 0.0), v(1.0, 0.0, 0.0), v(1.0, 0.0, 1.0), v(0.0, 0.0, 1.0));
    let two = Mesh::new(&[floor, west].concat()).unwrap();
    let three = Mesh::new(&[floor, west, south].concat()).unwrap();
    let mut normals = contacts(&two, v(0.09, 0.5, 0.08), 0.1);
    assert_eq!(normals.len(), 2, "{normals:?}");
    normals.sort_by(|a, b| a.distance.total_cmp(&b.distance));
    assert_eq!((normals[0].normal, normals[1].normal), (DVec3::Z, DVec3::X));
    assert!((normals[0].distance - 0.08).abs() < 1e-15 && (normals[1].distance - 0.09).abs() < 1e-15);
    assert_eq!(contacts(&three, v(0.09, 0.07, 0.08), 0.1).len(), 3);
    assert_eq!(contacts(&three, v(0.09, 0.07, 0.08), 0.075).len(), 1);
    // From behind, the same corner is convex and touches once.
    assert_eq!(contacts(&three, v(-0.03, -0.04, -0.05), 0.1).len(), 1);
}

#[test]
fn a_faceted_cylinder_is_one_smooth_contact_from_both_sides() {
    for facets in [18, 32, 64, 200] {
        let mesh = Mesh::new(&faceted_cylinder(facets)).unwrap();
        let sagitta = 1.0 - (std::f64::consts::PI / facets as f64).cos();
        for (distance_from_axis, radius) in [(0.75, 0.3), (1.24, 0.3)] {
            let mut last: Option<SurfaceContact> = None;
            let steps = 5000;
            for step in 0..steps {
                let angle = std::f64::consts::TAU * f64::from(step) / f64::from(steps);
                let centre = v(
                    angle.cos() * distance_from_axis,
                    angle.sin() * distance_from_axis,
                    0.21 * angle.sin(),
                );
                let found = contacts(&mesh, centre, radius);
                assert_eq!(found.len(), 1, "{facets} {step}: {found:?}");
                let expected = (distance_from_axis - 1.0f64).abs();
                assert!(
                    (found[0].distance - expected).abs() <= sagitta + 1e-12,
                    "{facets} {step}: {found:?}"
                );
                if let Some(last) = last {
                    let moved = std::f64::consts::TAU / f64::from(steps) * (distance_from_axis + 0.21);
                    assert!(
                        (last.distance - found[0].distance).abs() <= moved,
                        "{facets} {step}: a jump"
                    );
                }
                last = Some(found[0]);
            }
        }
    }
}

#[test]
fn layers_given_twice_and_thin_sheets_touch_once() {
    let mut dice = Dice::new(3);
    let top = plane(3, 0.2, &mut dice, |p| p);
    let twice = [top.clone(), top.clone()].concat();
    let sheet = [
        top.clone(),
        top.iter().map(|t| t.map(|p| p - DVec3::Z * 0.01)).collect(),
    ]
    .concat();
    for corners in [twice, sheet] {
        let mesh = Mesh::new(&corners).unwrap();
        for step in 0..500 {
            let s = 0.2 + 0.6 * f64::from(step) / 500.0;
            let found = contacts(&mesh, v(s, 0.3 + 0.4 * s, 0.08), 0.1);
            assert_eq!(found.len(), 1, "{found:?}");
            assert!((found[0].distance - 0.08).abs() < 1e-14);
        }
    }
}

#[test]
fn an_edge_of_three_triangles_counts_once() {
    let (a, b) = (v(0.0, 0.0, 0.0), v(0.0, 1.0, 0.0));
    let mesh = Mesh::new(&[
        [a, b, v(1.0, 0.5, 0.2)],
        [a, b, v(1.0, 0.5, 0.0)],
        [a, b, v(1.0, 0.5, -0.2)],
    ])
    .unwrap();
    let found = contacts(&mesh, v(-0.05, 0.5, 0.0), 0.1);
    assert_eq!(found.len(), 1, "{found:?}");
    assert!((found[0].normal + DVec3::X).length() < 1e-12);
}

#[test]
fn the_rim_of_an_open_surface_touches() {
    let mesh = Mesh::new(&plane(4, 0.2, &mut Dice::new(1), |p| p)).unwrap();
    for y in [0.1, 0.25, 0.5, 0.77] {
        let found = contacts(&mesh, v(-0.03, y, 0.04), 0.1);
        assert_eq!(found.len(), 1);
        assert!((found[0].normal - v(-0.6, 0.0, 0.8)).length() < 1e-12);
    }
    let corner = contacts(&mesh, v(-0.03, -0.04, 0.0), 0.1);
    assert!(corner.len() == 1 && (corner[0].distance - 0.05).abs() < 1e-15);
}

#[test]
fn bad_meshes_are_refused_with_the_reason() {
    let good = [v(0.0, 0.0, 0.0), v(1.0, 0.0, 0.0), v(0.0, 1.0, 0.0)];
    assert_eq!(Mesh::new(&[]).unwrap_err(), MeshError::Empty);
    let line = [DVec3::ZERO, DVec3::X, DVec3::X * 2.0];
    let error = Mesh::new(&[good, line]).unwrap_err();
    assert!(
        error.to_string().contains("triangle 2") && error.to_string().contains("zero area"),
        "{error}"
    );
    for bad in [f64::NAN, f64::INFINITY, 1e200] {
        let error = Mesh::new(&[good, [DVec3::ZERO, DVec3::X, v(0.0, bad, 0.0)]]).unwrap_err();
        assert!(matches!(error, MeshError::NotFinite { triangle: 2, .. }), "{error}");
    }
    let mut holed = cuboid(DVec3::ONE);
    holed.remove(4);
    let error = Mesh::new(&holed).unwrap().require_closed().unwrap_err();
    assert!(matches!(error, MeshError::Open { count: 3, .. }), "{error}");
}

#[test]
fn single_precision_leaves_no_holes_and_no_seams() {
    let mut dice = Dice::new(9);
    let round = |p: DVec3| v(f64::from(p.x as f32), f64::from(p.y as f32), f64::from(p.z as f32));
    let turn = DQuat::from_xyzw(0.3, -0.4, 0.2, 0.8).normalize();
    let corners: Corners = cuboid(v(0.5, 0.3, 0.8))
        .into_iter()
        .map(|t| t.map(|p| round(turn * p)))
        .collect();
    Mesh::new(&corners).unwrap().require_closed().unwrap();
    let flat: Corners = plane(9, 0.3, &mut dice, |p| p)
        .into_iter()
        .map(|t| t.map(|p| round(turn * p)))
        .collect();
    let mesh = Mesh::new(&flat).unwrap();
    for step in 0..2000 {
        let s = 0.25 + 0.5 * f64::from(step) / 2000.0;
        let found = contacts(&mesh, turn * v(s, 0.3 + 0.4 * s, 0.17), 0.2);
        assert!(found.len() == 1 && found[0].element == 0, "{found:?}");
        assert!((found[0].normal - turn * DVec3::Z).length() < 1e-5);
    }
}

/// A frictionless elastic sphere slides around in a faceted drum: the contact force has a potential, so the facets give
/// and take no energy. Returns the largest change of energy as a share of the height of fall.
fn energy_drift(facets: usize, overlap: f64) -> f64 {
    let mesh = Mesh::new(&faceted_cylinder(facets)).unwrap();
    let (radius, gravity, dt) = (0.2, v(-9.81, 0.0, 0.0), 2e-5);
    let stiffness = 3.0 * 9.81 / (overlap * radius);
    let elastic = |x: DVec3| {
        let touching = contacts(&mesh, x, radius);
        let force = |c: &SurfaceContact| c.normal * (stiffness * (radius - c.distance));
        let energy = |c: &SurfaceContact| 0.5 * stiffness * (radius - c.distance).powi(2);
        (
            touching.iter().map(force).sum::<DVec3>(),
            touching.iter().map(energy).sum::<f64>(),
        )
    };
    let (mut x, mut velocity) = (v(0.0, 0.79, 0.05), v(0.0, 0.0, 0.1));
    let (mut force, stored) = elastic(x);
    let start = stored - gravity.dot(x) + 0.5 * velocity.length_squared();
    let mut worst = 0.0f64;
    for _ in 0..100_000 {
        velocity += (force + gravity) * (0.5 * dt);
        x += velocity * dt;
        let (now, stored) = elastic(x);
        force = now;
        velocity += (force + gravity) * (0.5 * dt);
        let energy = stored - gravity.dot(x) + 0.5 * velocity.length_squared();
        worst = worst.max((energy - start).abs() / (9.81 * 0.8));
    }
    worst
}

#[test]
fn sliding_over_facets_keeps_the_energy() {
    for (facets, overlap) in [(20, 0.05), (20, 0.005), (64, 0.01), (150, 0.02)] {
        let drift = energy_drift(facets, overlap);
        // A velocity Verlet step across a kink of the potential errs by about acceleration times step times speed.
        assert!(drift < 2e-3, "{facets} facets, overlap {overlap}: {drift:e}");
    }
}

/// Cosine of the largest angle between normals of contacts that are one, as `walls/mesh/contacts.rs` has it.
const WIDEST: f64 = 0.85;

proptest! {
    #[test]
    fn the_deepest_contact_is_the_closest_point(seed in 0u64..1000, n in 1usize..40, at in prop::array::uniform3(-2.0f64..2.0)) {
        let mut dice = Dice::new(u128::from(seed));
        let corners: Corners = (0..n).map(|_| {
            let centre = dice.point(1.5);
            [centre + dice.point(0.6), centre + dice.point(0.6), centre + dice.point(0.6)]
        }).collect();
        let Ok(mesh) = Mesh::new(&corners) else { return Ok(()) };
        let centre = DVec3::from_array(at);
        let distance = |t: &demeter_physics::geometry::contact_sphere_triangle::Triangle| {
            demeter_physics::geometry::contact_sphere_triangle::contact_sphere_triangle(t, centre).distance
        };
        let least = mesh.triangles().iter().map(distance).fold(f64::MAX, f64::min);
        let found = contacts(&mesh, centre, 0.7);
        prop_assert_eq!(found.is_empty(), least >= 0.7);
        prop_assert_eq!(mesh.near(centre, 0.7), least <= 0.7);
        if let Some(deepest) = found.iter().map(|c| c.distance).reduce(f64::min) {
            // where several of nearly the same direction are one contact, the way out of all of them may be a little longer
            let (overlap, longest) = (0.7 - deepest, (0.7 - least) / WIDEST);
            prop_assert!(deepest <= least + 1e-12 && overlap <= longest + 1e-12, "{} and {}", deepest, least);
        }
    }
}
