//! A belt: a wall that stays and whose surface moves along itself.

use crate::cases::{Case, G, Laws, hertz_overlap, law, mass, on_threads, one_material, report};
use demeter::simulation::Simulation;
use demeter::walls::{Motion, MotionPart, Motions, Pace, Shape};
use demeter_physics::DVec3;

const RADIUS: f64 = 5e-3;
const YOUNG_MODULUS: f64 = 1e8;
const SPEED: f64 = 0.1;

fn laws() -> Laws {
    Laws::hertz(0.5).friction(law("mindlin-history", &[("friction", 0.3)]))
}

/// A sphere that lies on a floor.
fn lying_on(shape: Shape, motion: impl Into<Motions>) -> Simulation {
    let mut case = Case::new(one_material(YOUNG_MODULUS, &laws()));
    let overlap = hertz_overlap(YOUNG_MODULUS, RADIUS, mass(RADIUS) * G);
    case.grain(RADIUS, DVec3::Z * (RADIUS - overlap), DVec3::ZERO);
    case.wall(0, shape, motion);
    case.gravity = DVec3::Z * -G;
    case.simulation()
}

fn plane() -> Shape {
    Shape::Plane {
        point: DVec3::ZERO,
        normal: DVec3::Z,
    }
}

fn rectangle(half_length: f64) -> Shape {
    Shape::Rectangle {
        center: DVec3::ZERO,
        half_u: DVec3::X * half_length,
        half_v: DVec3::Y * 0.05,
    }
}

/// The same way as on a plane that moves, whatever of the belt's velocity points off its surface.
#[test]
fn a_sphere_ends_at_two_sevenths_of_the_speed_of_its_belt() {
    on_threads(1, || {
        let moving = DVec3::X * SPEED;
        let mut carried = lying_on(plane(), Motion::Velocity(moving));
        let corner = |x: f64, y: f64| DVec3::new(x, y, 0.0) * 0.5;
        let triangles = vec![
            [corner(-1.0, -0.9), corner(1.0, -1.0), corner(1.0, 1.0)],
            [corner(-1.0, -0.9), corner(1.0, 1.0), corner(-1.0, 1.0)],
        ];
        let mut belts = [
            lying_on(plane(), Motion::Belt(moving)),
            lying_on(Shape::Mesh { triangles }, Motion::Belt(moving)),
            lying_on(plane(), Motion::Belt(moving - DVec3::Z)),
            lying_on(rectangle(0.5), Motion::Belt(moving)),
        ];
        let mut unlike = 0.0f64;
        while carried.time() < 0.1 {
            carried.steps(50).unwrap();
            for sim in &mut belts {
                sim.steps(50).unwrap();
                let energies = sim.energies();
                unlike = unlike.max((energies.residual - carried.energies().residual).abs());
                let apart = sim.grains().position[0] - carried.grains().position[0];
                assert!(apart.length() < 1e-12, "{apart} at {} s", sim.time());
            }
        }
        let [found, _, _, finite] = belts.map(|mut sim| (sim.grains().velocity[0].x / SPEED, sim.energies().wall_work));
        let (_, work) = (carried.grains().velocity[0], carried.energies().wall_work);
        report(
            "speed of a sphere over 2/7 of that of its belt",
            found.0 / (2.0 / 7.0) - 1.0,
        );
        report("difference of the residuals", unlike);
        assert!((found.0 / (2.0 / 7.0) - 1.0).abs() < 1e-3, "{}", found.0);
        assert!((finite.1 / work - 1.0).abs() < 1e-6, "{} {work}", finite.1);
        assert!(unlike < 1e-6, "{unlike}");
    });
}

#[test]
fn a_belt_carries_grains_over_its_end_and_its_work_is_booked() {
    on_threads(1, || {
        // from rest to its speed, then a sphere that was set on it is thrown off the end, over the rim
        let pace = Pace {
            start_over: 0.02,
            ..Pace::FULL
        };
        let motion = MotionPart {
            motion: Motion::Belt(DVec3::X * 0.5),
            pace,
        };
        let mut sim = lying_on(rectangle(0.03), Motions { parts: vec![motion] });
        let (mut residual, mut highest) = (0.0f64, 0.0f64);
        while sim.grains().position[0].z > -0.02 {
            sim.steps(20).unwrap();
            residual = residual.max(sim.energies().residual.abs());
            highest = highest.max(sim.grains().position[0].z);
            assert!(sim.time() < 2.0, "it stays at {}", sim.grains().position[0]);
        }
        assert!(highest < 1.001 * RADIUS, "thrown up to {highest}");
        assert!(sim.grains().position[0].x > 0.03 && sim.grains().velocity[0].x > 0.1);
        report("residual of a sphere that a belt throws off", residual);
        assert!(sim.energies().wall_work > 0.0 && residual < 1e-4, "{residual}");
    });
}

#[test]
fn a_belt_along_a_periodic_direction_carries_a_sphere_across_the_side() {
    on_threads(1, || {
        let way = |periodic| {
            let mut case = Case::new(one_material(YOUNG_MODULUS, &laws()));
            if periodic {
                (case.domain.lower.x, case.domain.upper.x) = (-0.02, 0.02);
                case.domain.periodic = [true, false, false];
            }
            let overlap = hertz_overlap(YOUNG_MODULUS, RADIUS, mass(RADIUS) * G);
            case.grain(RADIUS, DVec3::new(0.015, 0.0, RADIUS - overlap), DVec3::ZERO);
            case.wall(0, plane(), Motion::Belt(DVec3::X * SPEED));
            case.gravity = DVec3::Z * -G;
            let mut sim = case.simulation();
            while sim.time() < 0.3 {
                sim.step().unwrap();
            }
            (sim.grains().position[0].x, sim.energies())
        };
        let ((open, _), (wrapped, energies)) = (way(false), way(true));
        assert!(open > 0.02, "it came to {open} only");
        assert!((open - 0.04 - wrapped).abs() < 1e-12, "{open} {wrapped}");
        assert!(
            energies.wall_work > 0.0 && energies.residual.abs() < 1e-4,
            "{}",
            energies.residual
        );
    });
}
