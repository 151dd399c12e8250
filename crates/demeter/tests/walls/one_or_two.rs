//! An elastic ball at two edges or round bars that are one contact close by and two farther away: neither the way in nor out makes energy.

use crate::cases::{Case, Laws, on_threads, one_material, report};
use demeter::simulation::{Setup, Simulation, SimulationState};
use demeter::walls::{Motion, Shape, Side};
use demeter_physics::DVec3;

const R: f64 = 2.4e-3;
/// Half of the side of a square hole, in a sheet of `SHEET` in half.
const HOLE: f64 = 2e-3;
const SHEET: f64 = 10e-3;

fn ball(walls: Vec<Shape>, young_modulus: f64, at: DVec3, velocity: DVec3) -> Setup {
    let mut case = Case::new(one_material(young_modulus, &Laws::hertz(1.0)));
    case.max_overlap = 0.2;
    for wall in walls {
        case.wall(0, wall, Motion::Rest);
    }
    case.grain(R, at, velocity);
    case.setup()
}

/// Ratio of the energies after and before the impact, and the largest residual of the books on the way.
pub fn kept(setup: Setup) -> (f64, f64) {
    let mut sim = Simulation::new(setup);
    let before = sim.energies().kinetic;
    let mut largest = 0.0f64;
    let mut touched = false;
    loop {
        sim.step().unwrap();
        largest = largest.max(sim.energies().residual.abs());
        let touches = sim.contacts.acting_walls() > 0;
        if touched && !touches {
            return (sim.energies().kinetic / before, largest);
        }
        touched |= touches;
    }
}

/// Four rectangles around a square hole; the same as triangles.
fn frame() -> Vec<Shape> {
    let (middle, half) = (0.5 * (SHEET + HOLE), 0.5 * (SHEET - HOLE));
    let side = |center: DVec3, u: f64, v: f64| Shape::Rectangle {
        center,
        half_u: DVec3::X * u,
        half_v: DVec3::Y * v,
    };
    vec![
        side(DVec3::X * middle, half, SHEET),
        side(-DVec3::X * middle, half, SHEET),
        side(DVec3::Y * middle, HOLE, half),
        side(-DVec3::Y * middle, HOLE, half),
    ]
}

fn sheet() -> Vec<Shape> {
    let places = [-SHEET, -HOLE, HOLE, SHEET];
    let corner = |i: usize, j: usize| DVec3::new(places[i], places[j], 0.0);
    let cells = (0..3).flat_map(|i| (0..3).map(move |j| (i, j)));
    let triangles = cells.filter(|cell| *cell != (1, 1)).flat_map(|(i, j)| {
        let [a, b, c, d] = [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)];
        [[a, b, c], [a, c, d]]
    });
    vec![Shape::Mesh {
        triangles: triangles.collect(),
    }]
}

#[test]
fn a_ball_on_the_corner_of_a_hole_keeps_its_energy() {
    on_threads(1, || {
        for (name, walls) in [("mesh", sheet as fn() -> Vec<Shape>), ("rectangles", frame)] {
            let (mut worst, mut residual) = (0.0f64, 0.0f64);
            for modulus in [20e6, 200e6] {
                for k in 0..24 {
                    // on both sides of the distance at which two edges are one contact, on the diagonal and beside it
                    let inwards = 0.5e-3 + 1e-5 * f64::from(k);
                    for (beside, across) in [(0.0, 0.0), (2e-5, 0.0), (1e-5, 0.15), (1e-5, -0.15)] {
                        let at = DVec3::new(-HOLE + inwards, -HOLE + inwards + beside, 3e-3);
                        let (ratio, largest) = kept(ball(walls(), modulus, at, DVec3::new(across, across, -0.5)));
                        worst = worst.max((ratio - 1.0).abs());
                        residual = residual.max(largest);
                        assert!(
                            (ratio - 1.0).abs() < 1e-3 && largest < 1e-3,
                            "{name} {modulus:e} {at}: {ratio} {largest}"
                        );
                    }
                }
            }
            report(&format!("energy of a ball on the corner of a hole, {name}"), worst);
            report(&format!("residual of a ball on the corner of a hole, {name}"), residual);
        }
    });
}

#[test]
fn a_ball_that_slides_along_bars_that_diverge_or_meet_keeps_its_energy() {
    on_threads(1, || {
        let bar = |side: f64, near: f64| Shape::Cylinder {
            start: DVec3::new(side * near, -0.8e-3, -0.3e-3),
            end: DVec3::new(side * (near + 0.2 * 10.8e-3), 10e-3, -0.3e-3),
            radius: 0.3e-3,
            side: Side::Outside,
        };
        let mut residual = 0.0f64;
        for along in [0.5, 0.0, -0.5] {
            for k in 0..20 {
                let near = 0.26e-3 + 6e-6 * f64::from(k);
                let at = DVec3::new(0.0, -0.2e-3 - along * 1.8e-3, 3.5e-3);
                let velocity = DVec3::new(0.0, along, -0.5);
                let (ratio, largest) = kept(ball(vec![bar(-1.0, near), bar(1.0, near)], 20e6, at, velocity));
                residual = residual.max(largest);
                assert!(
                    (ratio - 1.0).abs() < 1e-3 && largest < 1e-3,
                    "{along} {near:e}: {ratio} {largest}"
                );
            }
        }
        report("residual of a ball between bars", residual);
    });
}

#[test]
fn a_run_that_goes_on_in_the_middle_has_the_same_bits() {
    on_threads(1, || {
        for walls in [sheet as fn() -> Vec<Shape>, frame] {
            let at = DVec3::new(-HOLE + 0.63e-3, -HOLE + 0.635e-3, 2.6e-3);
            let setup = || ball(walls(), 20e6, at, DVec3::Z * -0.5);
            let mut sim = Simulation::new(setup());
            let mut states: Vec<Vec<u8>> = Vec::new();
            let last = 1500;
            for step in 1..=last {
                sim.step().unwrap();
                if step % 25 == 0 && sim.contacts.acting_walls() > 0 {
                    states.push(postcard::to_stdvec(&sim.state()).unwrap());
                }
            }
            assert!(states.len() > 3 && sim.contacts.acting_walls() == 0, "{}", states.len());
            for bytes in states {
                let state: SimulationState = postcard::from_bytes(&bytes).unwrap();
                let mut continued = Simulation::resume(setup(), state).unwrap();
                while continued.step < last {
                    continued.step().unwrap();
                }
                assert_eq!(continued.grains().position[0], sim.grains().position[0]);
            }
        }
    });
}
