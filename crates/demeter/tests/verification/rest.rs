//! Grains that walls or many others hold come to rest, and lose no more than they had.

use crate::cases::{Case, G, Laws, hertz_overlap, law, mass, on_threads, one_material, report};
use demeter::particles::Outside;
use demeter::simulation::Simulation;
use demeter::walls::{Motion, Shape};
use demeter_physics::DVec3;

const RADIUS: f64 = 1e-3;

/// Steps until a moment; the largest residual of some of them.
fn largest_residual(sim: &mut Simulation, until: f64) -> f64 {
    let mut largest = 0.0f64;
    while sim.time() < until {
        sim.steps(50).unwrap();
        largest = largest.max(sim.energies().residual.abs());
    }
    largest
}

#[test]
fn a_grain_that_spins_between_two_plates_loses_its_spin() {
    on_threads(1, || {
        let laws = Laws::hertz(0.5).rolling("constant-torque", 0.1);
        let mut case = Case::new(one_material(1e7, &laws));
        case.spinning_grain(1.01 * RADIUS, DVec3::ZERO, DVec3::ZERO, DVec3::X * 10.0);
        for side in [-1.0, 1.0] {
            case.plane(0, DVec3::Z * (side * RADIUS), DVec3::Z * -side);
        }
        let mut sim = case.simulation();
        sim.start().unwrap();
        let had = sim.energies().rotational;
        let residual = largest_residual(&mut sim, 0.02);
        let lost = sim.energies().rolling_dissipated / had;
        report("rolling loss of a spin between two plates", lost);
        assert!((lost - 1.0).abs() < 1e-3 && residual < 1e-5, "{lost} {residual}");
        assert!(sim.grains().angular_velocity[0].length() < 1e-6);
    });
}

/// Grains of a face-centred cubic packing that all turn alike.
fn turning_packing(laws: &Laws) -> Simulation {
    let mut case = Case::new(one_material(1e7, laws));
    let edge = 0.98 * 2.0 * RADIUS * std::f64::consts::SQRT_2;
    let cells = 3;
    case.domain.lower = DVec3::ZERO;
    case.domain.upper = DVec3::splat(edge * f64::from(cells));
    case.domain.periodic = [true; 3];
    case.domain.outside = Outside::Stop;
    for k in 0..cells * cells * cells {
        let cell = DVec3::new(
            f64::from(k % cells),
            f64::from(k / cells % cells),
            f64::from(k / cells / cells),
        );
        for (x, y, z) in [
            (0.25, 0.25, 0.25),
            (0.75, 0.75, 0.25),
            (0.75, 0.25, 0.75),
            (0.25, 0.75, 0.75),
        ] {
            let place = (cell + DVec3::new(x, y, z)) * edge;
            case.spinning_grain(RADIUS, place, DVec3::ZERO, DVec3::new(7.0, -4.0, 5.0));
        }
    }
    case.simulation()
}

#[test]
fn grains_with_twelve_neighbours_come_to_rest() {
    on_threads(1, || {
        let coulomb = law("coulomb", &[("friction", 0.3)]);
        for (name, laws) in [
            ("coulomb", Laws::hertz(0.5).friction(coulomb.clone())),
            (
                "coulomb, constant-torque",
                Laws::hertz(0.5).friction(coulomb).rolling("constant-torque", 0.1),
            ),
        ] {
            let mut sim = turning_packing(&laws);
            sim.start().unwrap();
            let had = sim.energies().rotational;
            let residual = largest_residual(&mut sim, 1e-3);
            let energies = sim.energies();
            assert!(
                energies.rotational < 1e-9 * had,
                "{name}: {} of {had}",
                energies.rotational
            );
            // what is booked of decays as fast as these is not exact
            let lost = (energies.friction_dissipated + energies.rolling_dissipated) / had;
            report(&format!("{name}: loss of a packing that turns"), lost);
            assert!(
                (0.9..1.5).contains(&lost) && residual < 1e-4,
                "{name}: {lost} {residual}"
            );
        }
    });
}

/// A grain that hangs in a mesh of two sides that fall by 10 degrees towards the y axis, so far beside the middle.
fn in_a_bend(aside: f64) -> Simulation {
    let slope = 10f64.to_radians();
    let mut case = Case::new(one_material(1e7, &Laws::hertz(0.5)));
    let across = DVec3::new(10.0 * RADIUS, 0.0, 10.0 * RADIUS * libm::tan(slope));
    let along = DVec3::Y * (20.0 * RADIUS);
    let mut triangles = vec![];
    for side in [DVec3::new(-1.0, 1.0, 1.0), DVec3::ONE] {
        let (near, far) = (-0.5 * along, across * side - 0.5 * along);
        triangles.extend([[near, far, far + along], [near, far + along, near + along]]);
    }
    case.wall(0, Shape::Mesh { triangles }, Motion::Rest);
    case.gravity = DVec3::Z * -G;
    let overlap = hertz_overlap(1e7, RADIUS, mass(RADIUS) * G);
    case.grain(
        RADIUS,
        DVec3::new(aside, 0.0, RADIUS / libm::cos(slope) - overlap),
        DVec3::ZERO,
    );
    case.simulation()
}

#[test]
fn a_grain_in_a_shallow_bend_of_a_mesh_is_held_from_both_sides() {
    on_threads(1, || {
        let mut sim = in_a_bend(0.0);
        let residual = largest_residual(&mut sim, 0.2);
        let ((force, _), weight) = (sim.walls[0].load(), mass(RADIUS) * G);
        assert!(force.x.abs() < 1e-9 * weight, "{force}");
        assert!((force.z / weight + 1.0).abs() < 1e-3, "{force} {weight}");
        // beside the middle it swings from side to side
        let swinging = largest_residual(&mut in_a_bend(0.01 * RADIUS), 0.2);
        report("residual of a grain that swings in a bend", swinging);
        assert!(residual < 1e-4 && swinging < 1e-4, "{residual} {swinging}");
    });
}
