//! Contacts that are born from bulging begin at zero force, continuously, and end the same way.

use super::influence::Model;
use super::packings::{disordered, make_unstoppable};
use super::reference::largest;
use super::scenes::*;
use crate::cases::{full, on_threads, report};
use demeter::contacts::Coupling;
use demeter::simulation::Simulation;
use demeter::walls::Motion;
use demeter_physics::DVec3;

const HALF_SPACE: Model = Model::HalfSpace(1.0);

/// Two grains side by side with a gap of 0.01 between plates that press them by `q`.
fn side_by_side(model: Model, q: f64) -> (Simulation, Vec<Plane>) {
    let mut case = case(model, 0.5);
    case.grain(1.0, DVec3::ZERO, DVec3::ZERO);
    case.grain(1.0, DVec3::X * 2.01, DVec3::ZERO);
    let planes = vec![(DVec3::Z * (q - 1.0), DVec3::Z), (DVec3::Z * (1.0 - q), -DVec3::Z)];
    for (point, normal) in &planes {
        case.plane(WALLS, *point, *normal);
    }
    (started(case), planes)
}

#[test]
fn bulges_touch_where_they_must() {
    let side = |q: f64| {
        let (sim, _) = side_by_side(HALF_SPACE, q);
        let contacts = found(&sim);
        contacts.iter().find(|f| f.second.is_some()).map_or(0.0, |f| f.force)
    };
    let touch = 0.056_885_741_3;
    assert!(side(touch - 2e-10) == 0.0 && side(touch + 2e-10) > 0.0);
    // a contact at the gap is known before it acts
    let (sim, _) = side_by_side(HALF_SPACE, touch - 1e-3);
    assert_eq!(found(&sim).len(), 5);
    for model in [
        HALF_SPACE,
        Model::HalfSpace(1.125),
        Model::SphereToSphere,
        Model::PointOnSphere,
    ] {
        for q in [0.05, 0.0569, 0.06, 0.08] {
            let (sim, planes) = side_by_side(model, q);
            assert_solved(&sim, model, &planes);
        }
    }
}

/// Forces of all pairs, and of all grains with all walls, by id.
fn forces(sim: &Simulation) -> Vec<f64> {
    let (count, walls) = (sim.grains().len(), sim.walls.len());
    let mut all = vec![0.0; count * (count + walls)];
    for (wall, chunks) in [(false, &sim.contacts.pairs), (true, &sim.contacts.walls)] {
        for chunk in chunks {
            for k in 0..chunk.len() {
                let id = |grain: u32| sim.grains().id[grain as usize] as usize - 1;
                let partner = if wall {
                    count + chunk.j[k] as usize
                } else {
                    id(chunk.j[k])
                };
                all[id(chunk.i[k]) * (count + walls) + partner] =
                    chunk.coupling().get(k).map_or(chunk.normal_force(k), |c| c.elastic);
            }
        }
    }
    all
}

/// What a sweep came to.
#[derive(Default)]
struct Sweep {
    /// Forces at some places, on the way there.
    there: Vec<Vec<f64>>,
    /// At the same places, on the way back.
    back: Vec<Vec<f64>>,
    /// Largest second difference of any force from step to step: not less than any jump.
    roughness: f64,
    largest: f64,
    /// Contacts that began and ended.
    births: usize,
    deaths: usize,
}

/// Places at which forces are kept.
const KEPT: usize = 50;

/// Goes there in so many steps, and back if told; the first `settle` steps are not looked at.
fn sweep(sim: &mut Simulation, steps: usize, settle: usize, and_back: bool) -> Sweep {
    make_unstoppable(sim);
    sim.start().unwrap();
    let mut sweep = Sweep::default();
    sweep.there.push(forces(sim));
    let mut walk = |sim: &mut Simulation, there: bool| {
        let (mut before, mut now) = (forces(sim), forces(sim));
        for step in 1..=steps {
            sim.step().unwrap();
            let next = forces(sim);
            for k in 0..next.len() {
                let second = if step > settle {
                    next[k] - 2.0 * now[k] + before[k]
                } else {
                    0.0
                };
                sweep.roughness = sweep.roughness.max(second.abs());
                sweep.births += usize::from(now[k] == 0.0 && next[k] != 0.0);
                sweep.deaths += usize::from(now[k] != 0.0 && next[k] == 0.0);
            }
            if step % (steps / KEPT) == 0 {
                let kept = if there { &mut sweep.there } else { &mut sweep.back };
                kept.push(next.clone());
            }
            before = std::mem::replace(&mut now, next);
        }
    };
    walk(sim, true);
    if and_back {
        sim.grains_mut().velocity.iter_mut().for_each(|v| *v = -*v);
        for wall in &mut sim.walls {
            let back = wall.velocity_at(DVec3::ZERO) * -1.0;
            wall.set_motion(Motion::Velocity(back)).unwrap();
        }
        walk(sim, false);
    }
    sweep.largest = sweep
        .there
        .iter()
        .map(|f| largest(f.iter().copied()))
        .fold(0.0, f64::max);
    sweep
}

/// Sweeps with 10^4 steps and with a quarter of them. Forces begin as overlaps to the power 3/2, so their second differences
/// fall to an eighth; a jump would stay as large as it is.
fn assert_continuous(what: &str, coupling: Coupling, births: usize, build: fn(Coupling, usize) -> Simulation) {
    let fine_steps = if full() { 40_000 } else { 10_000 };
    let settle = if coupling == Coupling::Lagged { 100 } else { 2 };
    let run = |steps: usize, back: bool| on_threads(1, || sweep(&mut build(coupling, steps), steps, settle, back));
    let (coarse, fine) = (run(fine_steps / 4, false), run(fine_steps, true));
    let tolerance = match coupling {
        Coupling::Converged { tolerance } => tolerance,
        Coupling::Lagged => 0.0,
    };
    let noise = 20.0 * tolerance * fine.largest;
    report(&format!("{what}: births"), fine.births as f64);
    report(
        &format!("{what}: no jump above, over the largest force"),
        fine.roughness / fine.largest,
    );
    assert!(
        fine.births >= births && fine.births == fine.deaths,
        "{what}: {} {}",
        fine.births,
        fine.deaths
    );
    assert!(
        fine.roughness < 0.16 * coarse.roughness + noise,
        "{what}: {:e} {:e}",
        fine.roughness,
        coarse.roughness
    );
    // places on the way back, from the turning point on
    let hysteresis = fine.there.iter().rev().skip(1).zip(&fine.back);
    let hysteresis = hysteresis.map(|(there, back)| largest(there.iter().zip(back).map(|(a, b)| a - b)));
    let hysteresis = hysteresis.fold(0.0, f64::max) / fine.largest;
    report(&format!("{what}: there and back"), hysteresis);
    // what the lagged scheme is behind is of the order of a step
    let allowed = if coupling == Coupling::Lagged {
        20.0 / fine_steps as f64
    } else {
        20.0 * tolerance
    };
    assert!(hysteresis < allowed, "{what}: {hysteresis:e}");
}

/// A block of a simple cubic lattice with gaps along x and y, between plates that close along z.
fn block(coupling: Coupling, steps: usize) -> Simulation {
    let (start, end, tall) = (0.002, 0.07, 3.0);
    let speed = (end - start) / steps as f64;
    let mut case = case(HALF_SPACE, 0.5);
    case.coupling = coupling;
    for k in 0..18u32 {
        let (x, y, z) = (f64::from(k % 3), f64::from(k / 3 % 2), f64::from(k / 6));
        // gaps that differ
        let at = DVec3::new(2.004 * x + 0.002 * x * x, 2.007 * y, 2.0 * z);
        case.grain(1.0, at * DVec3::new(1.0, 1.0, 1.0 - start), DVec3::Z * (-speed * at.z));
    }
    for (z, normal) in [(-1.0, DVec3::Z), (2.0 * tall - 1.0, -DVec3::Z)] {
        case.plane(WALLS, DVec3::Z * z * (1.0 - start), normal);
        let wall = case.walls.last_mut().unwrap();
        wall.set_motion(Motion::Velocity(DVec3::Z * (-speed * z))).unwrap();
    }
    case.simulation()
}

/// A disordered packing in a box whose lid comes down.
fn boxed(coupling: Coupling, steps: usize) -> Simulation {
    let (grains, edge) = disordered(50, 2.0, 0.58, 11);
    let speed = 0.1 / steps as f64;
    let mut case = case(HALF_SPACE, 0.5);
    case.coupling = coupling;
    for (radius, at) in grains {
        case.grain(radius, at, DVec3::Z * (-speed * at.z));
    }
    for normal in [DVec3::X, DVec3::Y, DVec3::Z, -DVec3::X, -DVec3::Y, -DVec3::Z] {
        case.plane(
            WALLS,
            if normal.min_element() < 0.0 {
                DVec3::splat(edge)
            } else {
                DVec3::ZERO
            },
            normal,
        );
    }
    let lid = case.walls.last_mut().unwrap();
    lid.set_motion(Motion::Velocity(DVec3::Z * (-speed * edge))).unwrap();
    case.simulation()
}

const TIGHT: Coupling = Coupling::Converged { tolerance: 1e-10 };

#[test]
fn side_contacts_of_a_lattice_come_and_go_continuously() {
    assert_continuous("simple cubic, converged", TIGHT, 10, block);
    assert_continuous("simple cubic, lagged", Coupling::Lagged, 10, block);
}

#[test]
fn contacts_of_a_disordered_packing_come_and_go_continuously() {
    assert_continuous(
        "disordered, converged",
        Coupling::Converged { tolerance: 1e-9 },
        10,
        boxed,
    );
    assert_continuous("disordered, lagged", Coupling::Lagged, 10, boxed);
}

#[test]
fn the_swept_packing_is_solved_right() {
    // as good as at rest
    let mut sim = boxed(EXACT, 1_000_000_000);
    sim.start().unwrap();
    let edge = sim.walls[5].origin();
    let planes: Vec<Plane> = [DVec3::X, DVec3::Y, DVec3::Z]
        .into_iter()
        .flat_map(|n| [(DVec3::ZERO, n), (edge, -n)])
        .collect();
    assert_solved(&sim, HALF_SPACE, &planes);
}
