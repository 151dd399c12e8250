//! Where grains get out: containers that are tight, that leak through holes just larger than the grain, and not through
//! those just smaller; open tops, rims and orifices.

use demeter::particles::{Domain, Outside};
use demeter::walls::leak::{LeakReport, LeakTest, OpeningKind, Untested, find_openings};
use demeter::walls::{Motion, Shape, Side, Wall};
use glam::DVec3;

const DOWN: DVec3 = DVec3::new(0.0, 0.0, -9.81);

fn v(x: f64, y: f64, z: f64) -> DVec3 {
    DVec3::new(x, y, z)
}

fn wall(shape: Shape) -> Wall {
    Wall::new("wall", 0, shape, Motion::Rest).unwrap()
}

fn mesh(triangles: Vec<[DVec3; 3]>) -> Wall {
    wall(Shape::Mesh { triangles })
}

fn quad(a: DVec3, b: DVec3, c: DVec3, d: DVec3) -> [[DVec3; 3]; 2] {
    [[a, b, c], [a, c, d]]
}

/// A box on the floor z = 0, the faces -x, +x, -y, +y, -z, +z in turn, two triangles each.
fn cuboid(lower: DVec3, upper: DVec3) -> Vec<[DVec3; 3]> {
    let p = |x: u8, y: u8, z: u8| {
        let pick = |k: usize, high: u8| if high == 1 { upper[k] } else { lower[k] };
        v(pick(0, x), pick(1, y), pick(2, z))
    };
    [
        quad(p(0, 0, 0), p(0, 1, 0), p(0, 1, 1), p(0, 0, 1)),
        quad(p(1, 0, 0), p(1, 1, 0), p(1, 1, 1), p(1, 0, 1)),
        quad(p(0, 0, 0), p(1, 0, 0), p(1, 0, 1), p(0, 0, 1)),
        quad(p(0, 1, 0), p(1, 1, 0), p(1, 1, 1), p(0, 1, 1)),
        quad(p(0, 0, 0), p(1, 0, 0), p(1, 1, 0), p(0, 1, 0)),
        quad(p(0, 0, 1), p(1, 0, 1), p(1, 1, 1), p(0, 1, 1)),
    ]
    .concat()
}

/// The unit box, open at the top, whose side at x = 1 has a square hole of the given width in its middle.
fn box_with_hole(width: f64) -> Vec<[DVec3; 3]> {
    let mut triangles = cuboid(DVec3::ZERO, DVec3::ONE);
    triangles.truncate(10);
    triangles.drain(2..4);
    let (low, high) = (0.5 - 0.5 * width, 0.5 + 0.5 * width);
    let p = |y: f64, z: f64| v(1.0, y, z);
    triangles.extend(quad(p(0.0, 0.0), p(1.0, 0.0), p(1.0, low), p(0.0, low)));
    triangles.extend(quad(p(0.0, high), p(1.0, high), p(1.0, 1.0), p(0.0, 1.0)));
    triangles.extend(quad(p(0.0, low), p(low, low), p(low, high), p(0.0, high)));
    triangles.extend(quad(p(high, low), p(1.0, low), p(1.0, high), p(high, high)));
    triangles
}

fn test(walls: &[Wall], starts: &[DVec3], radius: f64) -> LeakReport {
    find_openings(&LeakTest {
        walls,
        starts,
        radius,
        gravity: DOWN,
        domain: None,
    })
    .unwrap()
}

/// The only opening, a leak.
fn leak(report: &LeakReport) -> (DVec3, f64) {
    let [opening] = report.openings[..] else {
        panic!("{report:?}")
    };
    assert_eq!(opening.kind, OpeningKind::Leak, "{report:?}");
    assert!(!report.more);
    (opening.place, opening.width)
}

#[test]
fn a_closed_box_is_tight_and_one_without_lid_is_open_at_the_top() {
    let start = [v(0.5, 0.5, 0.05)];
    let closed = cuboid(DVec3::ZERO, DVec3::ONE);
    for radius in [0.3f64, 0.05, 0.02] {
        let report = test(&[mesh(closed.clone())], &[v(0.5, 0.5, radius.max(0.3))], radius);
        assert!(
            report.is_tight() && report.openings.is_empty() && !report.open_at_top,
            "{radius}: {report:?}"
        );
        let report = test(&[mesh(closed[..10].to_vec())], &start, radius.min(0.05));
        assert!(
            report.is_tight() && report.openings.is_empty() && report.open_at_top,
            "{radius}: {report:?}"
        );
    }
    // the walls of the engine's own box go on for ever
    let faces = Shape::Box {
        lower: DVec3::ZERO,
        upper: DVec3::ONE,
        open: [false, false, false, false, false, true],
    };
    let report = test(&[wall(faces)], &start, 0.05);
    assert!(
        report.is_tight() && report.openings.is_empty() && report.open_at_top,
        "{report:?}"
    );
}

#[test]
fn a_missing_triangle_is_found_with_its_place_and_width() {
    for missing in 0..10 {
        let mut triangles = cuboid(DVec3::ZERO, DVec3::ONE);
        let gone = triangles.remove(missing);
        let report = test(&[mesh(triangles)], &[v(0.5, 0.5, 0.5)], 0.05);
        let (place, width) = leak(&report);
        let centroid = (gone[0] + gone[1] + gone[2]) / 3.0;
        // the largest circle in a right triangle of sides 1, 1: radius 1 - 1/sqrt 2, at that distance from both sides
        let inradius = 1.0 - 0.5f64.sqrt();
        assert!(place.distance(centroid) < 0.15, "{missing}: {place} {centroid}");
        assert!((width / (2.0 * inradius) - 1.0).abs() < 0.05, "{missing}: {width}");
        assert!(!report.open_at_top);
    }
}

#[test]
fn a_hole_leaks_when_it_is_wider_than_the_grain_and_only_then() {
    let start = [v(0.3, 0.5, 0.1), v(0.7, 0.2, 0.06)];
    for share in [0.5, 0.8, 0.95, 0.98, 1.02, 1.05, 1.3, 2.0] {
        let radius = 0.05;
        let report = test(&[mesh(box_with_hole(2.0 * radius * share))], &start, radius);
        assert!(report.open_at_top && !report.more, "{share}: {report:?}");
        if share < 1.0 {
            assert!(report.openings.is_empty(), "{share}: {report:?}");
        } else {
            let (place, width) = leak(&report);
            assert!(place.distance(v(1.0, 0.5, 0.5)) < 0.02, "{share}: {place}");
            assert!((width / (2.0 * radius * share) - 1.0).abs() < 0.03, "{share}: {width}");
        }
    }
    let report = test(&[mesh(box_with_hole(0.1))], &start, 0.05);
    assert_eq!(report.openings[0].kind, OpeningKind::AboutGrainSize, "{report:?}");
    assert!((report.openings[0].width / 0.1 - 1.0).abs() < 0.03 && !report.is_tight());
}

#[test]
fn every_hole_is_told_the_widest_first() {
    let mut triangles = box_with_hole(0.15);
    // a second hole: the floor without one of its triangles
    let floor = triangles
        .iter()
        .position(|t| t.iter().all(|corner| corner.z == 0.0))
        .unwrap();
    triangles.remove(floor);
    let report = test(&[mesh(triangles)], &[v(0.5, 0.5, 0.5)], 0.05);
    assert_eq!(report.openings.len(), 2, "{report:?}");
    assert!(
        report.openings[0].width > 0.5 && (report.openings[1].width - 0.15).abs() < 0.01,
        "{report:?}"
    );
    assert!(report.openings[0].place.z.abs() < 0.05 && report.openings[1].place.x > 0.95);
}

/// A box of 20 by 20 that is periodic along x and y.
fn periodic() -> Domain {
    Domain {
        lower: v(-10.0, -10.0, -5.0),
        upper: v(10.0, 10.0, 30.0),
        periodic: [true, true, false],
        outside: Outside::Stop,
    }
}

fn on_ground(walls: &[Wall], domain: Option<&Domain>) -> LeakReport {
    find_openings(&LeakTest {
        walls,
        starts: &[v(2.0, 2.0, 4.0), v(-4.0, -3.0, 4.0)],
        radius: 1.0,
        gravity: DOWN,
        domain,
    })
    .unwrap()
}

fn level_ground() -> Wall {
    wall(Shape::Plane {
        point: DVec3::ZERO,
        normal: DVec3::Z,
    })
}

#[test]
fn level_ground_holds_and_is_open_at_the_top() {
    for domain in [Some(periodic()), None] {
        let report = on_ground(&[level_ground()], domain.as_ref());
        assert!(report.is_tight() && report.open_at_top, "{report:?}");
        assert!(report.openings.is_empty(), "{report:?}");
    }
}

#[test]
fn a_plate_is_left_where_it_ends() {
    let plate = |half_x: f64| {
        wall(Shape::Rectangle {
            center: DVec3::ZERO,
            half_u: DVec3::X * half_x,
            half_v: DVec3::Y * 10.0,
        })
    };
    // a slot of 20 - 2 half_x at the periodic sides
    let report = on_ground(&[plate(8.0)], Some(&periodic()));
    assert!(!report.openings.is_empty() && !report.is_tight(), "{report:?}");
    for opening in &report.openings {
        assert_eq!(opening.kind, OpeningKind::Leak, "{report:?}");
        assert!(opening.place.x.abs() > 9.0 && opening.place.z.abs() < 0.5, "{report:?}");
        assert!((opening.width / 4.0 - 1.0).abs() < 0.1, "{report:?}");
    }
    let report = on_ground(&[plate(9.2)], Some(&periodic()));
    assert!(
        report.is_tight() && report.openings.is_empty() && report.open_at_top,
        "{report:?}"
    );
    let report = on_ground(&[plate(8.0)], None);
    assert!(!report.is_tight(), "{report:?}");
}

#[test]
fn places_of_an_open_side_are_no_narrower_than_the_grain() {
    // a grain on a plate gets away on all sides
    let plate = wall(Shape::Rectangle {
        center: DVec3::ZERO,
        half_u: DVec3::X * 10.0,
        half_v: DVec3::Y * 10.0,
    });
    let report = test(&[plate], &[v(0.0, 0.0, 2.5)], 2.0);
    assert!(!report.openings.is_empty() && report.more, "{report:?}");
    assert!(report.openings.iter().all(|o| o.width >= 4.0), "{report:?}");
}

/// A floor that hangs below the sides of a box open above: round its corners the way between both is wider than the gap.
#[test]
fn a_gap_along_a_floor_is_told_its_own_width() {
    for gap in [4.2, 5.0, 7.0] {
        for half_y in [20.0, 14.0] {
            let corners = [
                v(-20.0, -half_y, 0.0),
                v(20.0, -half_y, 0.0),
                v(20.0, half_y, 0.0),
                v(-20.0, half_y, 0.0),
            ];
            let up = DVec3::Z * 40.0;
            let below = DVec3::Z * -gap;
            let sides = (0..4).flat_map(|k| {
                let (a, b) = (corners[k], corners[(k + 1) % 4]);
                quad(a, b, b + up, a + up)
            });
            let floor = quad(
                corners[0] + below,
                corners[1] + below,
                corners[2] + below,
                corners[3] + below,
            );
            let walls = [mesh(sides.chain(floor).collect())];
            let report = test(&walls, &[v(5.0, 5.0, 10.0), v(-5.0, 5.0, 10.0)], 2.0);
            assert!(!report.openings.is_empty(), "{gap}: {report:?}");
            for opening in &report.openings {
                assert!((opening.width / gap - 1.0).abs() < 0.03, "{gap}: {report:?}");
            }
        }
    }
}

/// A box of 40 mm open at the top, from z = 0; its floor is of squares of 1 mm, without those whose middle is told [mm].
fn box_of_squares(is_open: impl Fn(f64, f64) -> bool) -> Wall {
    let mut triangles = cuboid(v(-20.0, -20.0, 0.0), v(20.0, 20.0, 40.0));
    triangles.truncate(10);
    triangles.retain(|triangle| triangle.iter().any(|corner| corner.z > 0.0));
    for x in -20..20 {
        for y in -20..20 {
            let (x, y) = (f64::from(x), f64::from(y));
            if !is_open(x + 0.5, y + 0.5) {
                triangles.extend(quad(
                    v(x, y, 0.0),
                    v(x + 1.0, y, 0.0),
                    v(x + 1.0, y + 1.0, 0.0),
                    v(x, y + 1.0, 0.0),
                ));
            }
        }
    }
    mesh(triangles)
}

#[test]
fn holes_beside_a_wider_one_are_told_and_each_once() {
    let hole = |x: f64, y: f64, half: f64, at: (f64, f64)| (x - at.0).abs() < half && (y - at.1).abs() < half;
    type Holes = &'static [(f64, f64, f64)];
    let cases: [Holes; 4] = [
        &[(0.0, 0.0, 3.0), (10.0, 10.0, 4.0)],
        &[(0.0, 0.0, 6.0), (-14.5, -14.5, 2.5)],
        &[(10.0, 0.0, 4.0), (-10.0, 0.0, 4.0)],
        &[(0.0, 0.0, 6.0)],
    ];
    for holes in cases {
        let walls = [box_of_squares(|x, y| {
            holes.iter().any(|&(a, b, half)| hole(x, y, half, (a, b)))
        })];
        // grains straight above the holes, too, which would fall out
        for starts in [
            vec![v(0.0, 0.0, 10.0)],
            vec![v(-5.0, 15.0, 5.0), v(0.0, 0.0, 30.0), v(10.0, 10.0, 10.0)],
        ] {
            let report = test(&walls, &starts, 2.0);
            assert_eq!(report.openings.len(), holes.len(), "{report:?}");
            assert!(!report.more && report.open_at_top, "{report:?}");
            for &(x, y, half) in holes {
                let found = report.openings.iter().find(|o| o.place.distance(v(x, y, 0.0)) < 1.0);
                let width = found.unwrap_or_else(|| panic!("{report:?}")).width;
                assert!((width / (2.0 * half) - 1.0).abs() < 0.02, "{report:?}");
            }
        }
    }
}

#[test]
fn a_slit_is_told_once() {
    let walls = [box_of_squares(|x, y| x.abs() < 3.0 && y.abs() < 15.0)];
    let report = test(&walls, &[v(0.0, 0.0, 10.0), v(-15.0, 0.0, 5.0)], 2.0);
    let (place, width) = leak(&report);
    assert!(
        (width / 6.0 - 1.0).abs() < 0.02 && place.z.abs() < 0.1 && place.x.abs() < 0.1,
        "{report:?}"
    );
}

#[test]
fn a_slit_all_around_leaks_when_it_is_wider_than_the_grain_and_only_then() {
    for share in [0.9, 0.95, 1.05] {
        let shell = wall(Shape::Cylinder {
            start: v(0.0, 0.0, 2.0 * share),
            end: v(0.0, 0.0, 40.0),
            radius: 30.0,
            side: Side::Inside,
        });
        let report = on_ground(&[level_ground(), shell], None);
        assert!(report.open_at_top, "{report:?}");
        if share < 1.0 {
            assert!(report.is_tight() && report.openings.is_empty(), "{share}: {report:?}");
        } else {
            assert!(
                report
                    .openings
                    .iter()
                    .all(|o| (o.width / (2.0 * share) - 1.0).abs() < 0.05),
                "{report:?}"
            );
            assert!(!report.openings.is_empty());
        }
    }
}

/// The cuboid from -10, -10, -25 to 10, 10, 25, tilted, without its lower end.
fn tilted_cup() -> Wall {
    let axes = [
        v(0.8, -0.6, 0.0),
        v(0.4, 0.533_333, -0.745_356),
        v(0.447_214, 0.596_285, 0.666_667),
    ];
    let turned = |p: DVec3| axes[0] * p.x + axes[1] * p.y + axes[2] * p.z;
    let mut triangles = cuboid(v(-10.0, -10.0, -25.0), v(10.0, 10.0, 25.0));
    triangles.drain(8..10);
    mesh(triangles.into_iter().map(|t| t.map(turned)).collect())
}

#[test]
fn a_wide_mouth_leaks_whatever_inclined_wall_the_grain_falls_on() {
    let tube = wall(Shape::Cylinder {
        start: v(-10.0, -20.0, -20.0),
        end: v(10.0, 20.0, 20.0),
        radius: 12.0,
        side: Side::Inside,
    });
    let end = |sign: f64| {
        wall(Shape::Disc {
            center: sign * v(10.0, 20.0, 20.0),
            normal: v(1.0, 2.0, 2.0) / 3.0,
            radius: 12.0,
        })
    };
    let slope = wall(Shape::Rectangle {
        center: DVec3::ZERO,
        half_u: v(20.0, 0.0, 11.547),
        half_v: v(0.0, 20.0, 0.0),
    });
    let room = |is_open: bool| {
        wall(Shape::Box {
            lower: v(-20.0, -20.0, -12.0),
            upper: v(20.0, 20.0, 40.0),
            open: [is_open, false, false, false, false, false],
        })
    };
    let above = [v(0.0, 0.0, 20.0)];
    for diameter in [2.0, 4.0, 8.0] {
        let radius = 0.5 * diameter;
        let report = test(&[slope.clone(), room(true)], &above, radius);
        assert!(
            !report.is_tight() && !report.openings.is_empty(),
            "{diameter}: {report:?}"
        );
        let report = test(&[slope.clone(), room(false)], &above, radius);
        assert!(report.is_tight(), "{diameter}: {report:?}");
        for walls in [vec![tube.clone(), end(1.0)], vec![tilted_cup()]] {
            let report = test(&walls, &[DVec3::ZERO], radius);
            assert!(!report.is_tight(), "{diameter}: {report:?}");
        }
        let report = test(&[tube.clone(), end(1.0), end(-1.0)], &[DVec3::ZERO], radius);
        assert!(
            report.is_tight() && report.openings.is_empty(),
            "{diameter}: {report:?}"
        );
    }
}

#[test]
fn a_hopper_is_told_its_orifice() {
    let hopper = |orifice: f64| {
        vec![
            wall(Shape::Cone {
                start: v(0.0, 0.0, 0.0),
                end: v(0.0, 0.0, 0.1),
                start_radius: orifice,
                end_radius: 0.1,
                side: Side::Inside,
            }),
            wall(Shape::Cylinder {
                start: v(0.0, 0.0, 0.1),
                end: v(0.0, 0.0, 0.3),
                radius: 0.1,
                side: Side::Inside,
            }),
        ]
    };
    let start = [v(0.0, 0.02, 0.15), v(0.05, 0.0, 0.2)];
    for orifice in [0.0085, 0.02, 0.04] {
        let report = test(&hopper(orifice), &start, 0.008);
        let (place, width) = leak(&report);
        assert!(
            place.truncate().length() < 0.003 && place.z.abs() < 0.01,
            "{orifice}: {place}"
        );
        assert!((width / (2.0 * orifice) - 1.0).abs() < 0.05, "{orifice}: {width}");
        assert!(report.open_at_top);
    }
    let report = test(&hopper(0.0075), &start, 0.008);
    assert!(report.is_tight() && report.openings.is_empty(), "{report:?}");
    // a disc closes it
    let mut closed = hopper(0.04);
    closed.push(wall(Shape::Disc {
        center: DVec3::ZERO,
        normal: DVec3::Z,
        radius: 0.04,
    }));
    assert!(test(&closed, &start, 0.008).openings.is_empty());
}

#[test]
fn a_rim_that_is_lower_than_other_walls_is_a_way_upwards_and_no_leak() {
    // a box without lid, with a post that stands out of it, on a floor that is larger than the box
    let mut triangles = cuboid(DVec3::ZERO, DVec3::ONE)[..10].to_vec();
    triangles.extend(cuboid(v(0.45, 0.45, 0.0), v(0.55, 0.55, 2.0)));
    let start = [v(0.2, 0.2, 0.1), v(0.2, 0.8, 1.5)];
    let report = test(&[mesh(triangles.clone())], &start, 0.06);
    assert!(report.open_at_top && report.is_tight(), "{report:?}");
    assert!(
        report
            .openings
            .iter()
            .all(|o| o.kind == OpeningKind::OverRim && o.place.z > 0.95),
        "{report:?}"
    );
    // and a hole below that rim is found all the same
    let mut holed = box_with_hole(0.15);
    holed.extend(cuboid(v(0.45, 0.45, 0.0), v(0.55, 0.55, 2.0)));
    let report = test(&[mesh(holed)], &start, 0.06);
    let leaks: Vec<_> = report.openings.iter().filter(|o| o.kind == OpeningKind::Leak).collect();
    assert_eq!(leaks.len(), 1, "{report:?}");
    assert!(leaks[0].place.distance(v(1.0, 0.5, 0.5)) < 0.03);
}

#[test]
fn a_turned_box_and_gravity_along_another_axis_give_the_same() {
    let turn = |triangles: Vec<[DVec3; 3]>| -> Vec<[DVec3; 3]> {
        let map = |p: DVec3| v(p.z, p.x, p.y);
        triangles.into_iter().map(|t| t.map(map)).collect()
    };
    let walls = [mesh(turn(box_with_hole(0.13)))];
    let report = find_openings(&LeakTest {
        walls: &walls,
        starts: &[v(0.2, 0.5, 0.5)],
        radius: 0.06,
        gravity: v(-9.81, 0.0, 0.0),
        domain: None,
    })
    .unwrap();
    let (place, width) = leak(&report);
    assert!(place.distance(v(0.5, 1.0, 0.5)) < 0.02 && (width / 0.13 - 1.0).abs() < 0.03 && report.open_at_top);
    // without gravity there is no top: an open box leaks
    let open = [mesh(cuboid(DVec3::ZERO, DVec3::ONE)[..10].to_vec())];
    let weightless = LeakTest {
        walls: &open,
        starts: &[v(0.5, 0.5, 0.5)],
        radius: 0.06,
        gravity: DVec3::ZERO,
        domain: None,
    };
    let report = find_openings(&weightless).unwrap();
    assert!(!report.is_tight() && !report.open_at_top, "{report:?}");
}

#[test]
fn a_periodic_channel_has_no_ends() {
    let mut triangles = cuboid(DVec3::ZERO, v(2.0, 1.0, 1.0));
    // without the two ends
    triangles.drain(0..4);
    let walls = [mesh(triangles)];
    let mut domain = Domain {
        lower: DVec3::ZERO,
        upper: v(2.0, 1.0, 1.0),
        periodic: [true, false, false],
        outside: Outside::Stop,
    };
    let ask = |domain: &Domain| {
        let starts = [v(1.0, 0.5, 0.2)];
        find_openings(&LeakTest {
            walls: &walls,
            starts: &starts,
            radius: 0.1,
            gravity: DOWN,
            domain: Some(domain),
        })
        .unwrap()
    };
    assert!(ask(&domain).is_tight());
    domain.periodic = [false; 3];
    let report = ask(&domain);
    assert!(!report.openings.is_empty() && !report.is_tight(), "{report:?}");
    assert!(
        report.openings.iter().all(|o| (o.width - 1.0).abs() < 0.1),
        "{report:?}"
    );
}

#[test]
fn what_cannot_be_tested_says_why_and_what_is_too_large_is_tried_with_a_larger_grain() {
    let ask = |walls: &[Wall], starts: &[DVec3], radius: f64| {
        find_openings(&LeakTest {
            walls,
            starts,
            radius,
            gravity: DOWN,
            domain: None,
        })
    };
    let closed = [mesh(cuboid(DVec3::ZERO, DVec3::ONE))];
    assert_eq!(ask(&[], &[DVec3::ZERO], 0.1), Err(Untested::NoWall));
    assert_eq!(ask(&closed, &[], 0.1), Err(Untested::NoStart));
    assert_eq!(ask(&closed, &[v(0.5, 0.5, 0.5)], 0.6), Err(Untested::NoRoom));
    // grains beside the box, or below it, never come into it
    for start in [v(2.0, 0.5, 3.0), v(0.5, 0.5, -2.0)] {
        let beside = ask(&closed, &[start], 0.1).unwrap_err();
        let (lower, upper) = (DVec3::ZERO, DVec3::ONE);
        assert_eq!(beside, Untested::Beside { lower, upper, start });
        assert!(beside.to_string().contains("`shift`"), "{beside}");
        // one above it does, and is out as long as the box is closed
        let above = ask(&closed, &[start, v(0.5, 0.5, 3.0)], 0.1);
        assert!(above.is_ok(), "{above:?}");
    }
    let too_large = [mesh(cuboid(DVec3::splat(-1e4), DVec3::splat(1e4)))];
    assert_eq!(ask(&too_large, &[v(1e4 - 0.5, 0.0, 0.0)], 0.1), Err(Untested::TooLarge));
    let report = ask(&closed, &[v(0.5, 0.5, 0.5)], 1e-5).unwrap();
    assert!(report.radius > 1e-4 && report.openings.is_empty(), "{report:?}");
}
