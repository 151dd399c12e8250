//! Meshes that are not what they should be: what is repaired, and what is told of the rest.

use demeter::walls::mesh::{Inspection, Repair};
use demeter::walls::{Mesh, MeshError};
use glam::DVec3;

type Corners = Vec<[DVec3; 3]>;

fn v(x: f64, y: f64, z: f64) -> DVec3 {
    DVec3::new(x, y, z)
}

/// The unit cube at a place; every triangle has its front outside.
fn cube(at: DVec3) -> Corners {
    let p = |k: usize| at + v((k & 1) as f64, ((k >> 1) & 1) as f64, ((k >> 2) & 1) as f64);
    let faces = [
        [0, 2, 3, 1],
        [4, 5, 7, 6],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 4, 6, 2],
        [1, 3, 7, 5],
    ];
    let cut = |[a, b, c, d]: [usize; 4]| [[p(a), p(b), p(c)], [p(a), p(c), p(d)]];
    faces.into_iter().flat_map(cut).collect()
}

fn repaired(corners: &[[DVec3; 3]]) -> (Corners, Repair) {
    Mesh::repair(corners, None).unwrap()
}

fn inspected(corners: &[[DVec3; 3]]) -> Inspection {
    Mesh::new(corners).unwrap().inspect()
}

#[test]
fn the_free_sides_of_a_plate_on_a_floor_are_one_open_end() {
    let p = [
        [-10, -10, 0],
        [0, -10, 0],
        [10, -10, 0],
        [10, 10, 0],
        [0, 10, 0],
        [-10, 10, 0],
        [0, -6, 0],
        [0, 6, 0],
        [0, -6, 8],
        [0, 6, 8],
    ]
    .map(|[x, y, z]| v(f64::from(x), f64::from(y), f64::from(z)));
    let floor = [
        [0, 1, 6],
        [0, 6, 7],
        [0, 7, 5],
        [5, 7, 4],
        [1, 2, 6],
        [6, 2, 3],
        [6, 3, 7],
        [7, 3, 4],
    ];
    let plate = [[6, 7, 9], [6, 9, 8]];
    // whichever edge is found first
    for shift in 0..10 {
        let mut faces = [&floor[..], &plate[..]].concat();
        faces.rotate_left(shift);
        let corners: Corners = faces.iter().map(|face| face.map(|k| p[k])).collect();
        let found = inspected(&corners);
        let rims: Vec<(f64, bool, bool)> = (found.rims.iter())
            .map(|rim| (rim.length.round(), rim.is_closed, rim.is_crack()))
            .collect();
        assert_eq!(rims, [(80.0, true, false), (28.0, false, false)], "{found:?}");
        assert!((found.rims[1].area - 96.0).abs() < 1e-9, "{found:?}");
    }
}

#[test]
fn a_good_mesh_is_left_as_it_is() {
    let (triangles, repair) = repaired(&cube(v(3.0, 0.1, 0.7)));
    assert_eq!(triangles, cube(v(3.0, 0.1, 0.7)));
    assert!(repair.is_nothing(), "{repair:?}");
    let found = inspected(&triangles);
    assert!(found.rims.is_empty());
    assert_eq!((found.crowded_edges.count, found.disagreeing_edges.count), (0, 0));
    assert_eq!((found.crossings.count, found.crossings.looked_at), (0, 12));
}

#[test]
fn triangles_without_area_doubles_and_turned_ones_are_repaired_and_told() {
    let mut corners = cube(DVec3::ZERO);
    let [a, b, c] = corners[5];
    corners.insert(2, [a, a, b]);
    corners.insert(4, [a, b, 0.5 * (a + b)]);
    corners.push([c, a, b]);
    corners.push([b, a, c]);
    corners[0].swap(0, 1);
    corners[10].swap(1, 2);
    let (triangles, repair) = repaired(&corners);
    assert_eq!((repair.flat.count, repair.flat.first, repair.flat.place), (2, 3, a));
    assert_eq!((repair.twice.count, repair.twice.first), (2, 15));
    assert_eq!((repair.turned, repair.moved), (2, 0));
    let found = inspected(&triangles);
    assert_eq!(
        (triangles.len(), found.rims.len(), found.disagreeing_edges.count),
        (12, 0, 0)
    );
    assert!(Mesh::new(&triangles).unwrap().require_closed().is_ok());
}

#[test]
fn torn_corners_are_joined_within_the_tolerance_that_is_told() {
    let mut corners = cube(DVec3::ZERO);
    for (k, triangle) in corners.iter_mut().enumerate() {
        triangle
            .iter_mut()
            .for_each(|corner| *corner += 1e-4 * v(k as f64, 1.0, 2.0).normalize());
    }
    let (torn, _) = repaired(&corners);
    assert!(!inspected(&torn).rims.is_empty());
    let (joined, repair) = Mesh::repair(&corners, Some(1e-3)).unwrap();
    assert!(inspected(&joined).rims.is_empty());
    assert!(
        repair.moved > 0 && repair.farthest < 3e-4 && repair.tolerance == 1e-3,
        "{repair:?}"
    );
}

#[test]
fn holes_are_told_with_place_and_size() {
    let mut corners = cube(DVec3::ZERO);
    // without the top, and without one triangle of the bottom
    corners.drain(2..4);
    corners.remove(0);
    let found = inspected(&corners);
    let [top, bottom] = found.rims[..] else {
        panic!("{found:?}")
    };
    assert_eq!((top.edges, bottom.edges), (4, 3));
    assert!((top.length - 4.0).abs() < 1e-12 && (top.area - 1.0).abs() < 1e-12);
    assert!(top.centre.distance(v(0.5, 0.5, 1.0)) < 1e-12 && !top.is_crack());
    assert!((bottom.length - 2.0 - 2f64.sqrt()).abs() < 1e-12 && (bottom.area - 0.5).abs() < 1e-12);
    assert!(bottom.centre.z.abs() < 1e-12);
}

#[test]
fn a_corner_on_an_edge_of_a_neighbour_is_a_crack_and_no_hole() {
    let corners = vec![
        [v(0.0, 0.0, 0.0), v(1.0, 0.0, 0.0), v(0.5, 1.0, 0.0)],
        [v(0.0, 0.0, 0.0), v(0.5, -1.0, 0.0), v(0.5, 0.0, 0.0)],
        [v(0.5, 0.0, 0.0), v(0.5, -1.0, 0.0), v(1.0, 0.0, 0.0)],
    ];
    let found = inspected(&corners);
    assert_eq!(found.crossings.count, 0);
    let cracks = found.rims.iter().filter(|rim| rim.is_crack()).count();
    let length: f64 = found.rims.iter().map(|rim| rim.length).sum();
    // the crack touches the outline at two corners, so it may be told as a part of it
    assert!(
        cracks <= 1 && (length - 2.0 - 4.0 * 1.25f64.sqrt()).abs() < 1e-12,
        "{found:?}"
    );
}

#[test]
fn edges_of_three_triangles_and_moebius_strips_are_told() {
    let mut corners = cube(DVec3::ZERO);
    corners.push([v(0.0, 0.0, 0.0), v(1.0, 0.0, 0.0), v(0.5, -1.0, -1.0)]);
    let found = inspected(&repaired(&corners).0);
    assert_eq!(
        (found.crowded_edges.count, found.crowded_edges.first),
        (1, v(0.5, 0.0, 0.0))
    );

    let n = 12;
    let at = |k: usize| {
        let angle = std::f64::consts::TAU * (k % n) as f64 / n as f64;
        let (out, half) = (v(angle.cos(), angle.sin(), 0.0), 0.5 * angle);
        let across = out * half.cos() + DVec3::Z * half.sin();
        let side = if k >= n { -0.3 } else { 0.3 };
        [out - across * side, out + across * side]
    };
    let strip: Corners = (0..n)
        .flat_map(|k| {
            let ([a, b], [c, d]) = (at(k), at(k + 1));
            [[a, b, c], [b, d, c]]
        })
        .collect();
    let found = inspected(&repaired(&strip).0);
    assert_eq!((found.disagreeing_edges.count, found.rims.len()), (1, 1), "{found:?}");
    assert_eq!(found.crossings.count, 0);
}

#[test]
fn parts_that_pass_through_one_another_are_told_and_those_that_touch_are_not() {
    let two = |shift: DVec3| [cube(DVec3::ZERO), cube(shift)].concat();
    assert_eq!(inspected(&two(v(1.0, 1.0, 0.0))).crossings.count, 0, "a common edge");
    assert_eq!(inspected(&two(v(1.0, 1.0, 1.0))).crossings.count, 0, "a common corner");
    assert_eq!(inspected(&two(v(3.0, 0.0, 0.0))).crossings.count, 0, "apart");
    let through = inspected(&two(v(0.5, 0.4, 0.3)));
    assert!(through.crossings.count >= 12, "{through:?}");
    assert!(through.crossings.place.cmpge(DVec3::ZERO).all() && through.crossings.place.cmple(v(1.5, 1.4, 1.3)).all());
    let faces = inspected(&two(v(1.0, 0.3, 0.2)));
    assert!(faces.crossings.count >= 2, "faces in one plane: {faces:?}");
}

#[test]
fn a_fine_sphere_crosses_itself_nowhere() {
    let (around, up) = (60, 30);
    let at = |i: usize, j: usize| {
        let (phi, theta) = (
            std::f64::consts::TAU * (i % around) as f64 / around as f64,
            std::f64::consts::PI * j as f64 / up as f64,
        );
        // as an STL file holds it
        let round = |x: f64| f64::from(x as f32);
        0.037
            * v(
                round(theta.sin() * phi.cos()),
                round(theta.sin() * phi.sin()),
                round(theta.cos()),
            )
    };
    let mut corners = Vec::new();
    for i in 0..around {
        for j in 0..up {
            corners.push([at(i, j), at(i, j + 1), at(i + 1, j + 1)]);
            corners.push([at(i, j), at(i + 1, j + 1), at(i + 1, j)]);
        }
    }
    let (triangles, repair) = repaired(&corners);
    // at the poles every second triangle has no area
    assert_eq!(
        (repair.flat.count, triangles.len()),
        (2 * around, 2 * around * (up - 1))
    );
    let found = inspected(&triangles);
    assert_eq!(
        (found.crossings.count, found.rims.len(), found.disagreeing_edges.count),
        (0, 0, 0),
        "{found:?}"
    );
}

#[test]
fn a_distance_of_joining_that_leaves_no_triangle_is_told() {
    let corners = [[v(0.0, 0.0, 0.0), v(0.3, 0.0, 0.0), v(0.0, 0.4, 0.0)]];
    let error = Mesh::repair(&corners, Some(2.0)).unwrap_err();
    let told = error.to_string();
    assert!(
        told.contains("none of the 1 triangles") && told.contains("within 2 m") && told.contains("0.3 m long"),
        "{told}"
    );
}

/// A brick between two corners, all fronts outwards.
fn brick(lower: DVec3, upper: DVec3) -> Corners {
    let size = upper - lower;
    cube(DVec3::ZERO)
        .iter()
        .map(|t| t.map(|corner| lower + corner * size))
        .collect()
}

#[test]
fn a_face_that_two_closed_parts_share_divides_the_inside_and_is_no_hole() {
    let next = brick(DVec3::X, v(2.0, 1.0, 1.0));
    let (triangles, repair) = repaired(&[cube(DVec3::ZERO), next].concat());
    // grains feel the face once
    assert_eq!(
        (repair.twice.count, triangles.len(), repair.both_fronts.len()),
        (2, 22, 2)
    );
    let mesh = Mesh::new(&triangles).unwrap();
    assert!(mesh.require_closed().is_err());
    let mesh = mesh.with_both_fronts(&repair.both_fronts);
    let closed = mesh.closed_triangles().unwrap();
    assert_eq!((closed.len(), mesh.triangles().len()), (20, 22));
    assert!(
        closed
            .iter()
            .all(|triangle| triangle.iter().any(|corner| corner.x != 1.0))
    );
    // a hole beside it is still a hole, and so is one where a part has no face
    let mut holed = [cube(DVec3::ZERO), brick(DVec3::X, v(2.0, 1.0, 1.0))].concat();
    let far = holed
        .iter()
        .position(|t| t.iter().all(|corner| corner.x == 2.0))
        .unwrap();
    holed.remove(far);
    let (triangles, repair) = repaired(&holed);
    let mesh = Mesh::new(&triangles).unwrap().with_both_fronts(&repair.both_fronts);
    assert!(matches!(
        mesh.require_closed(),
        Err(MeshError::Open { cracks: None, .. })
    ));
    // a closed surface that is drawn from both sides is one, and a file that holds it twice, too
    let turned: Corners = cube(DVec3::ZERO).iter().map(|&[a, b, c]| [a, c, b]).collect();
    for (again, both) in [(turned, 12), (cube(DVec3::ZERO), 0)] {
        let (triangles, repair) = repaired(&[cube(DVec3::ZERO), again].concat());
        let mesh = Mesh::new(&triangles).unwrap().with_both_fronts(&repair.both_fronts);
        assert_eq!(
            (repair.both_fronts.len(), mesh.closed_triangles().unwrap().len()),
            (both, 12)
        );
    }
}

#[test]
fn cracks_are_told_from_holes_where_a_mesh_should_be_closed() {
    let error = |corners: &Corners| Mesh::new(&repaired(corners).0).unwrap().require_closed().unwrap_err();
    // one side of an edge is cut in its middle
    let mut cut = cube(DVec3::ZERO);
    let [a, b, c] = cut.remove(0);
    let middle = 0.5 * (a + b);
    cut.extend([[a, middle, c], [middle, b, c]]);
    let told = error(&cut).to_string();
    assert!(
        told.contains("cracks of no width") && told.contains("corners lie on edges"),
        "{told}"
    );
    // a corner of one triangle is off by little
    let mut torn = cube(DVec3::ZERO);
    torn[0][0] += DVec3::splat(1e-4);
    let MeshError::Open {
        cracks: Some(width), ..
    } = error(&torn)
    else {
        panic!("{}", error(&torn))
    };
    assert!((5e-5..4e-4).contains(&width), "{width}");
    assert!(
        error(&torn).to_string().contains("`weld = \"3.5e-4 m\"`"),
        "{}",
        error(&torn)
    );
    torn[0][0] += DVec3::splat(0.1);
    assert!(matches!(error(&torn), MeshError::Open { cracks: None, .. }));
}

#[test]
fn triangles_that_nearly_meet_are_told_with_the_weld_that_joins_them() {
    let mut torn = cube(DVec3::ZERO);
    for (k, triangle) in torn.iter_mut().enumerate() {
        let angle = k as f64;
        let shift = 1e-4 * v(angle.sin(), angle.cos(), 0.3);
        triangle.iter_mut().for_each(|corner| *corner += shift);
    }
    let found = inspected(&torn);
    let told = found.torn.unwrap();
    assert_eq!((found.rims.len(), told.edges, told.left), (12, 36, 0));
    assert!((2e-4..=4.1e-4).contains(&told.weld), "{told:?}");
    let error = Mesh::new(&torn).unwrap().require_closed().unwrap_err().to_string();
    assert!(error.contains(&told.remedy()), "{error}");
    let (joined, _) = Mesh::repair(&torn, Some(told.weld)).unwrap();
    assert!(Mesh::new(&joined).unwrap().require_closed().is_ok());
    // a hole stays one
    torn.pop();
    let told = inspected(&torn).torn.unwrap();
    assert_eq!((told.edges, told.left), (30, 3));
    assert_eq!(inspected(&cube(DVec3::ZERO)[..11]).torn, None);
}

#[test]
fn corners_in_one_place_are_told_without_hundreds_of_zeros() {
    let denormal = [[v(-5e-313, 0.0, 0.0), v(5e-313, 0.0, 0.0), v(0.0, 1e-312, 2.0)]; 2];
    let told = Mesh::repair(&denormal, None).unwrap_err().to_string();
    assert!(told.contains("[-5e-313, 0, 0] [5e-313, 0, 0] [0, 1e-312, 2]"), "{told}");
}
