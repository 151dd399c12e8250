//! No contact is missed: displacements at every pair, whether the engine looks at it or not.

use super::influence::{MODELS, Model};
use super::packings::{Dice, disordered, make_unstoppable};
use super::reference::{Adhesion, Packing, Shift, largest};
use super::scenes::*;
use crate::cases::{Laws, law, on_threads, report};
use demeter::contacts::Coupling;
use demeter::simulation::Simulation;
use demeter::walls::{Motion, Shape};
use demeter_physics::DVec3;

const TIGHT: Coupling = Coupling::Converged { tolerance: 1e-11 };

/// A dense packing of sizes 1:5 on a mesh, in a box of planes.
struct Bed {
    sim: Simulation,
    /// One for every wall.
    planes: Vec<Plane>,
}

impl Bed {
    fn new(model: Model, coupling: Coupling, adhesion: Adhesion, count: usize) -> Self {
        let (grains, edge) = disordered(count, 5.0, FILL, 5);
        let laws = if adhesion.work > 0.0 {
            let parameters = [
                ("work_of_adhesion", adhesion.work),
                ("separation", adhesion.separation),
                ("cutoff", adhesion.cutoff),
            ];
            Laws::of(law("dmt", &parameters))
        } else {
            Laws::hertz(1.0)
        };
        let mut case = case_of(materials(model, (1.0, 0.4), (1.0, 0.4), &laws));
        case.coupling = coupling;
        case.skin = 0.01;
        case.max_overlap = 1.0;
        for (radius, at) in grains {
            case.grain(radius, at, DVec3::ZERO);
        }
        case.wall(WALLS, floor(edge), Motion::Rest);
        let far = DVec3::splat(edge);
        let near = [DVec3::Z, DVec3::X, DVec3::Y].map(|n| (DVec3::ZERO, n));
        let planes: Vec<Plane> = near
            .into_iter()
            .chain([DVec3::X, DVec3::Y, DVec3::Z].map(|n| (far, -n)))
            .collect();
        for (point, normal) in &planes[1..] {
            case.plane(WALLS, *point, *normal);
        }
        let sim = case.simulation();
        Self { sim, planes }
    }

    fn all_pairs(&self, model: Model, adhesion: Adhesion) -> Packing {
        packing(&self.sim, model, &self.planes, 0.3, adhesion)
    }

    /// Sends grains and walls on their way: all drift, the lid comes down, and every grain strays.
    fn stir(&mut self, steps: f64) {
        let (strain, stray, drift) = (0.03, 0.05, DVec3::new(0.5, 0.3, 4.0));
        make_unstoppable(&mut self.sim);
        let mut dice = Dice::new(3);
        let grains = self.sim.grains_mut();
        for (velocity, at) in grains.velocity.iter_mut().zip(grains.position.iter()) {
            let way = (dice.place() - 0.5) * (2.0 * stray);
            *velocity = (drift + way - DVec3::Z * (strain * at.z)) / steps;
        }
        let edge = self.planes[5].0.z;
        for (k, wall) in self.sim.walls.iter_mut().enumerate() {
            let down = if k == 5 { strain * edge } else { 0.0 };
            wall.set_motion(Motion::Velocity((drift - DVec3::Z * down) / steps))
                .unwrap();
        }
    }

    fn step(&mut self) {
        self.sim.step().unwrap();
        for (plane, wall) in self.planes.iter_mut().zip(&self.sim.walls) {
            plane.0 += wall.velocity_at(DVec3::ZERO) * self.sim.dt();
        }
    }

    /// Half of the path of the overlap in this step [m].
    fn half_window(&self, packing: &Packing, touch: usize) -> f64 {
        let t = &packing.touches[touch];
        let wall = self.planes.iter().position(|p| p.1 == t.normal);
        let other = match (t.second, wall) {
            (Some(second), _) => self.sim.grains().velocity[second],
            (None, wall) => self.sim.walls[wall.unwrap()].velocity_at(DVec3::ZERO),
        };
        0.5 * self.sim.dt() * (other - self.sim.grains().velocity[t.first]).dot(t.normal).abs()
    }
}

/// What the packing fills of the box: some 0.65 would just touch.
const FILL: f64 = 0.72;

/// A floor of many triangles, wider than the box.
fn floor(edge: f64) -> Shape {
    let cell = edge / 6.0;
    let mut triangles = Vec::new();
    for k in 0..100 {
        let corner = DVec3::new(f64::from(k % 10) - 2.0, f64::from(k / 10) - 2.0, 0.0) * cell;
        let (u, v) = (DVec3::X * cell, DVec3::Y * cell);
        triangles.extend([
            [corner, corner + u, corner + u + v],
            [corner, corner + u + v, corner + v],
        ]);
    }
    Shape::Mesh { triangles }
}

/// Least and largest force while the overlap goes from `y - h` to `y + h`.
fn range(packing: &Packing, touch: usize, y: f64, h: f64) -> (f64, f64) {
    let force = packing.touches[touch].force;
    let mut places = vec![y - h, y, y + h];
    places.extend(
        [-0.0, 1e-300, -force.cutoff * (1.0 - 1e-12), -force.cutoff]
            .into_iter()
            .filter(|p| (p - y).abs() <= h + 1e-12),
    );
    let forces = places.into_iter().map(|p| force.at(p).0);
    forces.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), f| {
        (low.min(f), high.max(f))
    })
}

/// Counts of what was looked at.
#[derive(Default, Debug)]
struct Looked {
    acting: usize,
    /// Of these, such as the undisplaced grains do not reach.
    bulged: usize,
    idle: usize,
}

/// Every pair acts as its displaced surfaces tell, and no other does.
fn check(bed: &Bed, packing: &Packing, contacts: &[Option<Found>], shift: &[Shift], looked: &mut Looked) {
    let adhesive = packing.touches.iter().any(|t| t.force.pull > 0.0);
    let scale = largest(contacts.iter().flatten().map(|f| f.elastic));
    for (k, contact) in contacts.iter().enumerate() {
        let y = packing.touches[k].overlap + shift[k][0] + shift[k][1];
        let h = bed.half_window(packing, k);
        let elastic = contact.map_or(0.0, |f| f.elastic);
        let tolerance = (1e-8 + contact.map_or(0.0, |f| f.rounding)) * scale;
        if adhesive {
            let (low, high) = range(packing, k, y, h);
            assert!(
                low - tolerance <= elastic && elastic <= high + tolerance,
                "{k}: {low:e} {elastic:e} {high:e}, y {y:e}"
            );
        } else {
            let expected = packing.touches[k].force.hertz_mean(y, h);
            assert!(
                (elastic - expected).abs() < tolerance,
                "{k}: {elastic:e} {expected:e}, y {y:e}, h {h:e}"
            );
            assert!(
                y <= h + 1e-9 || elastic > 0.0,
                "missed {:?}, y {y:e}",
                packing.touches[k]
            );
        }
        looked.acting += usize::from(elastic != 0.0);
        looked.bulged += usize::from(elastic > 0.0 && packing.touches[k].overlap < 0.0);
        looked.idle += usize::from(elastic == 0.0);
    }
}

/// Forces of the engine, and the displacements that they make at all pairs.
fn check_converged(bed: &Bed, model: Model, adhesion: Adhesion, looked: &mut Looked) {
    let packing = bed.all_pairs(model, adhesion);
    let contacts = matched(&packing, &found(&bed.sim));
    let forces: Vec<f64> = contacts.iter().map(|c| c.map_or(0.0, |f| f.elastic)).collect();
    let shift = packing.consistent_displacements(&forces);
    check(bed, &packing, &contacts, &shift, looked);
}

#[test]
fn a_dense_packing_misses_no_contact() {
    let mut looked = Looked::default();
    for model in MODELS {
        let mut bed = Bed::new(model, TIGHT, Adhesion::default(), 250);
        bed.sim.start().unwrap();
        check_converged(&bed, model, Adhesion::default(), &mut looked);
    }
    report("bulged contacts", looked.bulged as f64);
    assert!(looked.bulged > 20 && looked.idle > 2000, "{looked:?}");
}

#[test]
fn adhesive_grains_miss_no_contact() {
    let adhesion = Adhesion {
        work: 2e-4,
        separation: 0.01,
        cutoff: 0.05,
    };
    let mut looked = Looked::default();
    for model in MODELS {
        let mut bed = Bed::new(model, TIGHT, adhesion, 120);
        bed.sim.start().unwrap();
        check_converged(&bed, model, adhesion, &mut looked);
    }
    move_and_check(Model::HalfSpace(1.0), adhesion, &mut looked);
    assert!(looked.acting > 10_000, "{looked:?}");
}

/// Moves grains and walls through many searches for candidates.
fn move_and_check(model: Model, adhesion: Adhesion, looked: &mut Looked) {
    let mut bed = Bed::new(model, TIGHT, adhesion, 120);
    bed.stir(STEPS);
    for step in 0..STEPS as usize {
        bed.step();
        if step % 5 == 0 {
            check_converged(&bed, model, adhesion, looked);
        }
    }
    assert!(bed.sim.rebuilds() > 16, "{}", bed.sim.rebuilds());
}

const STEPS: f64 = 300.0;

#[test]
fn moving_grains_miss_no_contact_converged() {
    for model in [Model::HalfSpace(1.0), Model::SphereToSphere] {
        let mut looked = Looked::default();
        on_threads(1, || move_and_check(model, Adhesion::default(), &mut looked));
        assert!(looked.bulged > 1000, "{looked:?}");
    }
}

/// Contacts of a moment, by the ids of their grains.
fn by_id(sim: &Simulation) -> Vec<Found> {
    let id = |g: usize| sim.grains().id[g] as usize;
    let all = found(sim).into_iter();
    all.map(|f| Found {
        first: id(f.first),
        second: f.second.map(id),
        ..f
    })
    .collect()
}

#[test]
fn moving_grains_miss_no_contact_lagged() {
    for model in [Model::HalfSpace(1.0), Model::SphereToSphere] {
        let mut bed = Bed::new(model, Coupling::Lagged, Adhesion::default(), 120);
        bed.stir(STEPS);
        bed.sim.start().unwrap();
        let mut looked = Looked::default();
        for _ in 0..STEPS as usize {
            let mut earlier = by_id(&bed.sim);
            bed.step();
            let mut index = vec![0; bed.sim.grains().len() + 1];
            for (g, id) in bed.sim.grains().id.iter().enumerate() {
                index[*id as usize] = g;
            }
            for f in &mut earlier {
                (f.first, f.second) = (index[f.first], f.second.map(|g| index[g]));
            }
            let packing = bed.all_pairs(model, Adhesion::default());
            let contacts = matched(&packing, &found(&bed.sim));
            let earlier = matched(&packing, &earlier);
            let forces: Vec<f64> = earlier.iter().map(|c| c.map_or(0.0, |f| f.elastic)).collect();
            let places: Vec<Shift> = earlier.iter().map(|c| c.map_or([0.0; 2], |f| f.displacement)).collect();
            let shift = packing.displacements(&forces, &places);
            check(&bed, &packing, &contacts, &shift, &mut looked);
        }
        assert!(
            bed.sim.rebuilds() > 16 && looked.bulged > 100,
            "{} {looked:?}",
            bed.sim.rebuilds()
        );
    }
}
