//! Where separate walls meet a grain rebounds as from one wall, and slides on as on one.

use crate::cases::{Case, G, Laws, advance, law, on_threads, one_material, report, run_until_parted};
use demeter::simulation::Simulation;
use demeter::walls::{Motion, Shape, Side};
use demeter_physics::DVec3;

const RADIUS: f64 = 1e-3;
const RESTITUTION: f64 = 0.8;

/// A plate from one place along two directions.
fn plate(corner: DVec3, along: DVec3, across: DVec3) -> Shape {
    let (half_u, half_v) = (0.5 * along, 0.5 * across);
    let center = corner + half_u + half_v;
    Shape::Rectangle { center, half_u, half_v }
}

/// The same as a mesh, whose corners are told in single precision, as STL files tell them.
fn mesh(corner: DVec3, along: DVec3, across: DVec3) -> Shape {
    let told = |point: DVec3| point.as_vec3().as_dvec3();
    let [a, b, c, d] = [corner, corner + along, corner + along + across, corner + across].map(told);
    let triangles = vec![[a, b, c], [a, c, d]];
    Shape::Mesh { triangles }
}

/// A cone that stands on the end of a tube, as a hopper on its outlet; around the z axis.
fn hopper() -> [Shape; 2] {
    let (start, side) = (DVec3::ZERO, Side::Inside);
    let cone = Shape::Cone {
        start,
        end: DVec3::Z * 0.02,
        start_radius: 0.008,
        end_radius: 0.02,
        side,
    };
    let tube = Shape::Cylinder {
        start: DVec3::Z * -0.02,
        end: start,
        radius: 0.008,
        side,
    };
    [cone, tube]
}

/// A bin of which a side is open, and a plate that closes it.
fn bin() -> [Shape; 2] {
    let (lower, upper) = (DVec3::new(-0.02, -0.01, 0.0), DVec3::new(0.0, 0.01, 0.01));
    let open = [false, true, false, false, false, true];
    let floor = plate(DVec3::new(0.0, -0.01, 0.0), DVec3::X * 0.01, DVec3::Y * 0.02);
    [Shape::Box { lower, upper, open }, floor]
}

/// Walls that meet: their names, a place on the seam, and the direction from there in which a grain is.
fn seams() -> Vec<(&'static str, Vec<Shape>, DVec3, DVec3)> {
    let (x, y, z) = (DVec3::X * 0.01, DVec3::Y * 0.01, DVec3::Z);
    let middle = 0.5 * y;
    let aside = DVec3::X * (0.3 * RADIUS);
    let coplanar = vec![plate(DVec3::ZERO, x, y), plate(DVec3::ZERO, -x, y)];
    let slope = DVec3::new(0.01, 0.0, -0.004);
    let mirrored = DVec3::new(-slope.x, 0.0, slope.z);
    let quarters = vec![
        plate(DVec3::ZERO, x, y),
        plate(DVec3::ZERO, -x, y),
        mesh(DVec3::ZERO, x, -y),
        plate(DVec3::ZERO, -x, -y),
    ];
    let shift = DVec3::new(0.1234567, 0.0, 0.7654321);
    let disc = Shape::Disc {
        center: DVec3::ZERO,
        normal: z,
        radius: 0.008,
    };
    // the outline of the tube stands on the cone
    let into_cone = DVec3::new(-0.02, 0.0, 0.012).normalize();
    let rim = DVec3::X * 0.008;
    let joint = rim + DVec3::new(0.012, 0.0, 0.02).normalize() * (0.2 * RADIUS);
    vec![
        ("plates", coplanar.clone(), middle, z),
        ("plates, to one side", coplanar.clone(), middle + aside, z),
        ("plates, to the other", coplanar, middle - aside, z),
        (
            "meshes in single precision",
            vec![mesh(shift, x, y), mesh(shift, -x, y)],
            shift + middle,
            z,
        ),
        ("four plates", quarters.clone(), DVec3::ZERO, z),
        ("four plates, beside", quarters, DVec3::new(0.1, -0.2, 0.0) * RADIUS, z),
        (
            "a plate and a mesh",
            vec![plate(DVec3::ZERO, x, y), mesh(DVec3::ZERO, -x, y)],
            middle,
            z,
        ),
        (
            "a ridge",
            vec![plate(DVec3::ZERO, slope, y), plate(DVec3::ZERO, mirrored, y)],
            middle,
            z,
        ),
        (
            "a step",
            vec![plate(DVec3::ZERO, -x, y), plate(DVec3::ZERO, DVec3::Z * -0.01, y)],
            middle,
            DVec3::new(0.6, 0.0, 0.8),
        ),
        (
            "a disc on a plate",
            vec![disc, plate(DVec3::new(-0.02, -0.02, 0.0), 4.0 * x, 4.0 * y)],
            rim,
            z,
        ),
        (
            "the rim of a hopper",
            hopper().to_vec(),
            rim,
            DVec3::new(-0.9, 0.0, 0.2).normalize(),
        ),
        ("a hopper above its rim", hopper().to_vec(), joint, into_cone),
        ("a floor that goes on", bin().to_vec(), DVec3::ZERO, z),
        ("a floor beside", bin().to_vec(), -aside, z),
    ]
}

/// Restitution of a grain that falls onto a place of walls along a direction, and how fast it is pushed aside.
fn rebound(laws: &Laws, shapes: &[Shape], place: DVec3, towards: DVec3, motion: &Motion) -> (f64, f64) {
    let mut case = Case::new(one_material(1e7, laws));
    let wall_velocity = match motion {
        Motion::Velocity(velocity) => *velocity,
        _ => DVec3::ZERO,
    };
    for shape in shapes {
        case.wall(0, shape.clone(), motion.clone());
    }
    let fall = towards * -0.3;
    case.grain(RADIUS, place + towards * (1.02 * RADIUS), fall + wall_velocity);
    let mut sim = case.simulation();
    run_until_parted(&mut sim);
    let after = sim.grains().velocity[0] - wall_velocity;
    let away = after.dot(towards);
    (away / 0.3, (after - towards * away).length())
}

#[test]
fn a_grain_on_a_seam_parts_with_the_requested_restitution() {
    on_threads(1, || {
        let alone = Laws::hertz(RESTITUTION);
        let coupled = Laws::hertz(RESTITUTION).multi_contact("half-space", &[]);
        let mut largest = 0.0f64;
        for (name, shapes, place, towards) in seams() {
            let backwards: Vec<Shape> = shapes.iter().rev().cloned().collect();
            for (order, shapes) in [("", shapes), ("the other way round", backwards)] {
                for motion in [Motion::Rest, Motion::Velocity(DVec3::new(0.4, 0.0, -0.2))] {
                    for (kind, laws) in [("independent", &alone), ("coupled", &coupled)] {
                        let (found, aside) = rebound(laws, &shapes, place, towards, &motion);
                        let label = format!("{name} {order} {kind} {motion:?}: {found}, aside {aside}");
                        assert!((found - RESTITUTION).abs() < 1e-4 && aside < 2e-3, "{label}");
                        largest = largest.max((found - RESTITUTION).abs());
                    }
                }
            }
        }
        report("largest error of restitution on seams", largest);
    });
}

/// A grain that slides over a floor, with friction or without, after 60 mm.
fn slide(floor: &[Shape], laws: &Laws) -> Simulation {
    let mut case = Case::new(one_material(1e7, laws));
    case.gravity = DVec3::Z * -G;
    for shape in floor {
        case.wall(0, shape.clone(), Motion::Rest);
    }
    case.grain(RADIUS, DVec3::new(-0.03, 0.0, RADIUS), DVec3::X);
    let mut sim = case.simulation();
    sim.start().unwrap();
    advance(&mut sim, 0.06);
    sim
}

#[test]
fn a_grain_slides_over_seams_as_over_one_plate() {
    on_threads(1, || {
        let (start, y) = (DVec3::new(-0.04, -0.01, 0.0), DVec3::Y * 0.02);
        let one = [plate(start, DVec3::X * 0.08, y)];
        let many: Vec<Shape> = (0..16)
            .map(|k| plate(start + DVec3::X * (0.005 * f64::from(k)), DVec3::X * 0.005, y))
            .collect();
        for (name, laws) in [
            ("smooth", Laws::hertz(0.5)),
            (
                "rough",
                Laws::hertz(0.5).friction(law("mindlin-history", &[("friction", 0.3)])),
            ),
        ] {
            let (expected, mut found) = (slide(&one, &laws), slide(&many, &laws));
            let off = (found.grains().position[0] - expected.grains().position[0]).abs() / RADIUS;
            report(&format!("{name}: off its path after 12 seams, radii, x"), off.x);
            report(&format!("{name}: off its path after 12 seams, radii, z"), off.z);
            let residual = found.energies().residual;
            assert!(off.z < 1e-9 && off.y == 0.0, "{name}: {off}");
            assert!(off.x < 1e-6 && residual.abs() < 1e-4, "{name}: {off} {residual}");
        }
    });
}

/// A contact with all that it remembers goes from wall to wall.
#[test]
fn contacts_that_remember_pass_seams_as_one_plate() {
    on_threads(1, || {
        let (start, y) = (DVec3::new(-0.04, -0.01, 0.0), DVec3::Y * 0.02);
        let one = [plate(start, DVec3::X * 0.08, y)];
        let mixed: Vec<Shape> = (0..16)
            .map(|k| {
                let corner = start + DVec3::X * (0.005 * f64::from(k));
                let make = if k % 3 == 0 { mesh } else { plate };
                make(corner, DVec3::X * 0.005, y)
            })
            .collect();
        let rough = || law("mindlin-history", &[("friction", 0.3)]);
        for (name, laws) in [
            (
                "walton-braun",
                Laws::of(law("walton-braun", &[("loading_stiffness", 2e3), ("restitution", 0.5)])).friction(rough()),
            ),
            (
                "jkr",
                Laws::of(law("jkr", &[("work_of_adhesion", 0.05), ("alpha", 0.3)])).friction(rough()),
            ),
        ] {
            let (mut expected, mut found) = (slide(&one, &laws), slide(&mixed, &laws));
            let off = (found.grains().position[0] - expected.grains().position[0]).abs() / RADIUS;
            let (whole, residual) = (expected.energies(), found.energies().residual);
            let lost = (found.energies().dissipated() - whole.dissipated()).abs() / whole.dissipated();
            report(&format!("{name}: off its path after 12 seams, radii, x"), off.x);
            report(&format!("{name}: loss beside that on one plate"), lost);
            assert!(off.z < 1e-6 && off.x < 1e-5, "{name}: {off}");
            assert!(lost < 1e-5 && residual.abs() < 1e-4, "{name}: {lost} {residual}");
        }
    });
}

/// In a hollow separate plates are what one mesh is.
#[test]
fn a_hollow_of_plates_is_one_of_a_mesh() {
    let sides = |angle: f64| {
        let (rise, y) = (libm::tan(angle.to_radians()), DVec3::Y * 0.04);
        [-0.03, 0.03].map(|x: f64| (DVec3::Y * -0.02, DVec3::new(x, 0.0, rise * x.abs()), y))
    };
    let end = |shapes: &[Shape], angle: f64, laws: &Laws| {
        let mut case = Case::new(one_material(1e6, laws));
        case.gravity = DVec3::Z * -G;
        for shape in shapes {
            case.wall(0, shape.clone(), Motion::Rest);
        }
        let (sin, cos) = (libm::sin(angle.to_radians()), libm::cos(angle.to_radians()));
        let start = DVec3::new(-8.0 * cos + 0.99 * sin, 0.0, 8.0 * sin + 0.99 * cos) * RADIUS;
        case.grain(RADIUS, start, DVec3::new(0.1, 0.013, -0.01));
        let mut sim = case.simulation();
        sim.start().unwrap();
        advance(&mut sim, 0.2);
        let residual = sim.energies().residual.abs();
        (sim.grains().position[0], residual)
    };
    on_threads(1, || {
        for (name, normal) in [
            ("hertz-tsuji", law("hertz-tsuji", &[("restitution", 0.9)])),
            ("jkr", law("jkr", &[("work_of_adhesion", 0.02), ("alpha", 0.1)])),
        ] {
            let laws = Laws::of(normal).friction(law("mindlin-history", &[("friction", 0.3)]));
            for angle in [2.0, 5.0, 8.0] {
                let plates = sides(angle).map(|(corner, along, across)| plate(corner, along, across));
                let faces = sides(angle).map(|(a, along, across)| {
                    [[a, a + along, a + along + across], [a, a + along + across, a + across]]
                });
                let triangles = faces.concat();
                let (of_plates, residual) = end(&plates, angle, &laws);
                let (of_mesh, _) = end(&[Shape::Mesh { triangles }], angle, &laws);
                let off = of_plates.distance(of_mesh) / RADIUS;
                report(&format!("{name}: off the path in a mesh, {angle} degrees, radii"), off);
                report(&format!("{name}: residual, {angle} degrees"), residual);
                assert!(off < 1e-6 && residual < 1e-3, "{name}, {angle}: {off} {residual}");
            }
        }
    });
}

/// Where one of two plates leaves their plane, no second contact comes from nowhere.
#[test]
fn plates_that_leave_their_plane_do_no_work_for_nothing() {
    on_threads(1, || {
        for speed in [1e-3, -1e-3] {
            let mut case = Case::new(one_material(1e7, &Laws::hertz(0.5)));
            let y = DVec3::Y * 0.02;
            let corner = |x: f64| DVec3::new(x, -0.01, 0.0);
            case.wall(0, plate(corner(0.0), DVec3::X * 0.02, y), Motion::Rest);
            case.wall(
                0,
                plate(corner(0.0), DVec3::X * -0.02, y),
                Motion::Velocity(DVec3::Z * speed),
            );
            // pressed by 0.04 of its radius, a little beside the seam
            case.wall(
                0,
                plate(DVec3::new(-0.02, -0.01, 1.92 * RADIUS), DVec3::X * 0.04, y),
                Motion::Rest,
            );
            case.grain(RADIUS, DVec3::new(0.02 * RADIUS, 0.0, 0.96 * RADIUS), DVec3::ZERO);
            let mut sim = case.simulation();
            sim.start().unwrap();
            let before = sim.energies();
            advance(&mut sim, 5e-3);
            let after = sim.energies();
            let gained = (after.elastic - before.elastic) / before.elastic;
            let residual = after.residual;
            report(
                &format!("elastic energy gained beside a plate that moves by 5e-3 radii at {speed} m/s"),
                gained,
            );
            assert!(gained.abs() < 0.25 && residual.abs() < 1e-3, "{gained} {residual}");
        }
    });
}
