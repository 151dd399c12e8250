//! Packings for the engine, the same packings for the reference, and the comparison of both.

use super::influence::{Ball, Model};
use super::reference::{Adhesion, Force, Packing, Solution, Touch, largest};
use crate::cases::{Case, Laws, law};
use demeter::contacts::Coupling;
use demeter::materials::{Material, Materials};
use demeter::particles::{Domain, NewGrain, Outside};
use demeter::simulation::Simulation;
use demeter_physics::DVec3;
use demeter_physics::contact::LawChoice;

pub const EXACT: Coupling = Coupling::Converged { tolerance: 1e-12 };

/// Material of the walls.
pub const WALLS: u16 = 1;

pub fn multi_contact(model: Model) -> LawChoice {
    match model {
        Model::HalfSpace(prefactor) => law(model.name(), &[("prefactor", prefactor)]),
        _ => law(model.name(), &[]),
    }
}

/// Grains of E = 1, walls a thousand million times stiffer, and a second kind of grain.
pub fn materials(model: Model, grains: (f64, f64), others: (f64, f64), laws: &Laws) -> Materials {
    let of = |name: &str, (young_modulus, poisson_ratio): (f64, f64)| Material {
        name: name.into(),
        young_modulus,
        poisson_ratio,
        density: 1.0,
    };
    let mut laws = laws.clone();
    laws.0.multi_contact = Some(multi_contact(model));
    let list = vec![of("grains", grains), of("walls", (1e15, 0.5)), of("others", others)];
    Materials::new(list, |_, _| laws.0.clone()).unwrap()
}

pub fn case_of(materials: Materials) -> Case {
    let mut case = Case::new(materials);
    case.coupling = EXACT;
    case.max_overlap = 0.5;
    case.skin = 0.2;
    case.domain = Domain {
        lower: DVec3::splat(-20.0),
        upper: DVec3::splat(20.0),
        periodic: [false; 3],
        outside: Outside::Stop,
    };
    case
}

pub fn case(model: Model, poisson_ratio: f64) -> Case {
    let material = (1.0, poisson_ratio);
    case_of(materials(model, material, material, &Laws::hertz(1.0)))
}

/// Adds a grain of any material.
pub fn add(case: &mut Case, material: u16, radius: f64, position: DVec3) {
    let id = case.grains.len() as u32 + 1;
    let grain = NewGrain {
        fixed: false,
        material,
        radius,
        density: 1.0,
        position,
        velocity: DVec3::ZERO,
        angular_velocity: DVec3::ZERO,
    };
    case.grains.push(id, &grain);
}

/// A periodic lattice of `cells` cells of edge `edge` along every side, with these places and radii in the cell.
pub fn lattice(mut case: Case, cells: u32, edge: DVec3, places: &[([f64; 3], f64)]) -> Case {
    case.domain.lower = DVec3::ZERO;
    case.domain.upper = edge * f64::from(cells);
    case.domain.periodic = [true; 3];
    for cell in 0..cells * cells * cells {
        let corner = [cell % cells, cell / cells % cells, cell / cells / cells].map(f64::from);
        for (place, radius) in places {
            let at = DVec3::from_array(std::array::from_fn(|k| corner[k] + place[k] + 0.1)) * edge;
            case.grain(*radius, at, DVec3::ZERO);
        }
    }
    case
}

pub const SIMPLE_CUBIC: [([f64; 3], f64); 1] = [([0.0; 3], 1.0)];
pub const BODY_CENTRED: [([f64; 3], f64); 2] = [([0.0; 3], 1.0), ([0.5; 3], 1.0)];
pub const FACE_CENTRED: [([f64; 3], f64); 4] = [
    ([0.0; 3], 1.0),
    ([0.0, 0.5, 0.5], 1.0),
    ([0.5, 0.0, 0.5], 1.0),
    ([0.5, 0.5, 0.0], 1.0),
];

pub fn started(case: Case) -> Simulation {
    let mut sim = case.simulation();
    match sim.start() {
        Ok(()) => sim,
        Err(fault) => panic!("{fault}"),
    }
}

/// Half of space as a wall: a point, and the normal towards the grains.
pub type Plane = (DVec3, DVec3);

/// The reference's view of a simulation: all pairs, and all grains with all planes, closer than `reach` to touching.
pub fn packing(sim: &Simulation, model: Model, planes: &[Plane], reach: f64, adhesion: Adhesion) -> Packing {
    let materials = sim.materials.list();
    let compliance = |e: f64, nu: f64| (1.0 - nu * nu) / e;
    let ball = |g: usize| {
        let material = &materials[sim.grains().material[g] as usize];
        Ball {
            centre: sim.grains().position[g],
            radius: sim.grains().radius(g),
            young_modulus: material.young_modulus,
            poisson_ratio: material.poisson_ratio,
        }
    };
    let balls: Vec<Ball> = (0..sim.grains().len()).map(ball).collect();
    let of = |b: &Ball| compliance(b.young_modulus, b.poisson_ratio);
    let stiff = compliance(materials[1].young_modulus, materials[1].poisson_ratio);
    let mut touches = Vec::new();
    let images = images(sim);
    for a in 0..balls.len() {
        for b in (0..balls.len()).filter(|&b| sim.grains().id[b] > sim.grains().id[a]) {
            let (first, second) = (&balls[a], &balls[b]);
            let sum = first.radius + second.radius;
            let ways = images.iter().map(|image| first.centre - second.centre + *image);
            for way in ways.filter(|way| way.length() < sum + reach) {
                let effective = first.radius * second.radius / sum;
                touches.push(Touch {
                    first: a,
                    second: Some(b),
                    normal: way.normalize(),
                    overlap: sum - way.length(),
                    distance: way.length(),
                    force: Force::new(1.0 / (of(first) + of(second)), effective, adhesion),
                    model,
                });
            }
        }
        for (point, normal) in planes {
            let distance = (balls[a].centre - *point).dot(*normal);
            if distance < balls[a].radius + reach {
                touches.push(Touch {
                    first: a,
                    second: None,
                    normal: *normal,
                    overlap: balls[a].radius - distance,
                    distance,
                    force: Force::new(1.0 / (of(&balls[a]) + stiff), balls[a].radius, adhesion),
                    model,
                });
            }
        }
    }
    Packing { balls, touches }
}

fn images(sim: &Simulation) -> Vec<DVec3> {
    let (edge, periodic) = (sim.domain().size(), sim.domain().periodic);
    let steps = |axis: usize| if periodic[axis] { -1..=1 } else { 0..=0 };
    let mut images = Vec::new();
    for x in steps(0) {
        for y in steps(1) {
            images.extend(steps(2).map(|z| edge * DVec3::new(f64::from(x), f64::from(y), f64::from(z))));
        }
    }
    images
}

/// A contact of the engine.
#[derive(Clone, Copy, Debug)]
pub struct Found {
    pub first: usize,
    /// Nothing at a wall.
    pub second: Option<usize>,
    pub normal: DVec3,
    /// Normal force, rounded to single precision.
    pub force: f64,
    /// The part of it that does not depend on the rate: not rounded where contacts feel each other.
    pub elastic: f64,
    /// By how much that may be rounded, as a share.
    pub rounding: f64,
    pub displacement: [f64; 2],
    pub levers: [f64; 2],
}

/// All contacts of the engine, acting or not.
pub fn found(sim: &Simulation) -> Vec<Found> {
    let contacts = &sim.contacts;
    let mut all = Vec::new();
    for (wall, chunks) in [(false, &contacts.pairs), (true, &contacts.walls)] {
        for chunk in chunks {
            for k in 0..chunk.len() {
                let geometry = sim.contact(chunk, k);
                let coupled = chunk.coupling().get(k).copied();
                all.push(Found {
                    first: chunk.i[k] as usize,
                    second: (!wall).then_some(chunk.j[k] as usize),
                    normal: geometry.normal,
                    force: chunk.normal_force(k),
                    elastic: coupled.map_or(chunk.normal_force(k), |c| c.elastic),
                    rounding: coupled.map_or(f64::from(f32::EPSILON), |_| 0.0),
                    displacement: coupled.map_or([0.0; 2], |c| c.displacement),
                    levers: [geometry.lever_i, geometry.lever_j],
                });
            }
        }
    }
    all
}

/// For every touch of the reference the engine's contact, if it has one; every acting contact must be among them.
pub fn matched(packing: &Packing, found: &[Found]) -> Vec<Option<Found>> {
    let mut by_first = vec![Vec::new(); packing.balls.len()];
    for (k, f) in found.iter().enumerate() {
        by_first[f.first].push(k);
    }
    let mut used = vec![false; found.len()];
    let matched = packing
        .touches
        .iter()
        .map(|t| {
            let same = |k: &&usize| found[**k].second == t.second && found[**k].normal.dot(t.normal) > 0.99;
            by_first[t.first].iter().find(same).map(|&k| {
                assert!(!used[k], "one contact for two touches: {t:?}");
                used[k] = true;
                found[k]
            })
        })
        .collect();
    for (f, used) in found.iter().zip(used) {
        assert!(used || f.force == 0.0, "a contact that no pair explains: {f:?}");
    }
    matched
}

/// Largest deviation of the engine from the reference: of forces (relative, with `1e-2` of the largest at least), and of
/// displacements and levers (over the radius 1).
pub fn deviation(sim: &Simulation, packing: &Packing, solution: &Solution) -> (f64, f64) {
    let scale = largest(solution.force.iter().copied());
    let (mut forces, mut lengths) = (0.0, 0.0);
    for (k, found) in matched(packing, &found(sim)).into_iter().enumerate() {
        let expected = solution.force[k];
        let Some(found) = found else {
            assert!(expected == 0.0, "missed: {:?}", packing.touches[k]);
            continue;
        };
        let rounded = found.rounding * expected.abs();
        forces = f64::max(
            forces,
            ((found.elastic - expected).abs() - rounded).max(0.0) / expected.abs().max(1e-2 * scale),
        );
        let sides = if found.second.is_some() { 2 } else { 1 };
        for side in 0..sides {
            let lever = packing.place(k, side, solution.shift[k]).1.lever;
            let shift = (found.displacement[side] - solution.shift[k][side]).abs();
            lengths = f64::max(lengths, shift.max((found.levers[side] - lever).abs()));
        }
    }
    (forces, lengths)
}

/// The engine's solution at its start is the reference's; tells how far off it is, and the largest displacement.
pub fn assert_solved(sim: &Simulation, model: Model, planes: &[Plane]) -> f64 {
    assert_solves(sim, &packing(sim, model, planes, 0.2, Adhesion::default()))
}

pub fn assert_solves(sim: &Simulation, packing: &Packing) -> f64 {
    let model = packing.touches[0].model;
    let Some(solution) = packing.solve() else {
        panic!("the reference finds no solution, {model:?}")
    };
    let (forces, lengths) = deviation(sim, packing, &solution);
    assert!(
        forces < 1e-9 && lengths < 1e-10,
        "{model:?}: forces {forces:e}, lengths {lengths:e}"
    );
    assert!(solution.force.iter().any(|f| *f != 0.0));
    forces
}
