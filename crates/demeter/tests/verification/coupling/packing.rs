//! A small packing like that of the hydrogel experiment: soft light grains of several sizes in a stiff box, squeezed by a
//! plate.

use crate::cases::{Case, Laws, law};
use demeter::contacts::Coupling;
use demeter::insertion::{Amount, Insertion, Region, SizeDistribution, Source, insert};
use demeter::materials::{Material, Materials};
use demeter::particles::{Domain, Grains, Outside};
use demeter::simulation::Simulation;
use demeter::walls::{Motion, Shape};
use demeter_physics::DVec3;

/// Mean radius of the grains [m].
const RADIUS: f64 = 0.01;

/// Largest overlap for which the time scale is found.
pub const LARGEST_OVERLAP: f64 = 0.35;

/// Tolerance that stands for an exact solution.
pub const FINE: Coupling = Coupling::Converged { tolerance: 1e-10 };

/// Solved to a tolerance.
pub fn within(tolerance: f64) -> Coupling {
    Coupling::Converged { tolerance }
}

/// What a run of the packing is made with.
#[derive(Clone, Copy)]
pub struct Model {
    /// Law of the multi-contact family.
    pub law: &'static str,
    pub restitution: f64,
    pub coupling: Coupling,
    /// Time step as a share of the shortest time scale.
    pub share: f64,
    pub poisson_ratio: f64,
}

impl Model {
    pub fn half_space(coupling: Coupling) -> Self {
        Self {
            law: "half-space",
            restitution: 0.9,
            coupling,
            share: 0.005,
            poisson_ratio: 0.5,
        }
    }
}

/// Grains at rest under a plate.
#[derive(Clone)]
pub struct Packing {
    pub grains: Grains,
    /// Edge of the floor [m].
    edge: f64,
    /// Height of the plate [m].
    pub height: f64,
    /// Height at which it began to press [m].
    pub touch: f64,
}

fn materials(model: Model) -> Materials {
    let of = |name: &str, young_modulus, poisson_ratio| Material {
        name: name.into(),
        young_modulus,
        poisson_ratio,
        density: 11.5,
    };
    let mut laws = Laws::hertz(model.restitution);
    laws.0.multi_contact = Some(law(model.law, &[]));
    let list = vec![of("grains", 23.3e3, model.poisson_ratio), of("walls", 50e6, 0.5)];
    Materials::new(list, |_, _| laws.0.clone()).unwrap()
}

/// Loose grains in a box.
fn loose(count: u32) -> Packing {
    let model = Model::half_space(FINE);
    let edge = libm::cbrt(f64::from(count) * 4.0 / 3.0 * std::f64::consts::PI * 1.02 * RADIUS.powi(3) / 0.48);
    let region = Region::Box {
        lower: DVec3::ZERO,
        upper: DVec3::splat(edge),
    };
    let insertion = Insertion {
        name: "grains".into(),
        material: 0,
        types: vec![],
        source: Source::Random {
            region,
            diameter: SizeDistribution::Uniform {
                lower: 1.7 * RADIUS,
                upper: 2.3 * RADIUS,
            },
            amount: Amount::Count(count),
        },
        velocity: DVec3::ZERO,
        velocity_deviation: 0.0,
        angular_velocity: DVec3::ZERO,
        tag: None,
        fixed: false,
        seed: 11,
    };
    let mut grains = Grains::default();
    let inserted = insert(&insertion, materials(model).list(), &[], None).unwrap();
    for (k, grain) in inserted.grains.iter().enumerate() {
        grains.push(k as u32 + 1, grain);
    }
    Packing {
        grains,
        edge,
        height: edge,
        touch: edge,
    }
}

impl Packing {
    /// A packing of `count` grains, just touched by the plate.
    pub fn new(count: u32) -> Self {
        let mut packing = loose(count);
        let model = Model {
            law: "independent",
            restitution: 0.1,
            share: 0.05,
            ..Model::half_space(FINE)
        };
        // some thousandths of the force at the largest strain
        let gentle = 0.02;
        while packing.settle(model, 1000) < gentle {
            packing.press(model, packing.height * 0.99);
        }
        // squeezed once, it is dense
        packing.press(model, packing.height * 0.85);
        while packing.settle(model, 1000) > gentle {
            packing.press(model, packing.height * 1.01);
        }
        packing.touch = packing.height;
        packing
    }

    /// Squeezed to a strain and left to come to rest.
    pub fn squeezed(&self, model: Model, strain: f64) -> Self {
        let mut packing = self.clone();
        let model = Model {
            restitution: 0.3,
            share: 0.02,
            ..model
        };
        packing.press(model, self.touch * (1.0 - strain));
        packing.settle(model, 6000);
        packing
    }

    /// Moves the plate.
    fn press(&mut self, model: Model, to: f64) {
        let speed = 0.1 * (to - self.height).signum();
        let mut sim = self.simulation(model, Motion::Velocity(DVec3::Z * speed));
        let steps = ((to - self.height) / speed / sim.dt()).ceil();
        sim.set_dt((to - self.height) / speed / steps).unwrap();
        for _ in 0..steps as u64 {
            sim.step().unwrap();
        }
        self.take(&sim);
    }

    /// Takes the places of a run.
    pub fn take(&mut self, sim: &Simulation) {
        self.grains = sim.grains().clone();
        self.grains.velocity.fill(DVec3::ZERO);
        self.grains.angular_velocity.fill(DVec3::ZERO);
        self.grains.higher.clear();
        self.height += sim.walls[1].displacement().z;
    }

    /// Lets the grains come to rest; the force on the plate [N].
    fn settle(&mut self, model: Model, steps: u64) -> f64 {
        let mut sim = self.simulation(model, Motion::Rest);
        for _ in 0..steps {
            sim.step().unwrap();
        }
        self.take(&sim);
        pressing(&sim)
    }

    pub fn simulation(&self, model: Model, plate: Motion) -> Simulation {
        self.case(model, plate).simulation()
    }

    pub fn case(&self, model: Model, plate: Motion) -> Case {
        let mut case = Case::new(materials(model));
        case.grains = self.grains.clone();
        case.coupling = model.coupling;
        case.share = model.share;
        case.max_overlap = LARGEST_OVERLAP;
        case.skin = 0.1 * RADIUS;
        case.domain = Domain {
            lower: DVec3::splat(-self.edge),
            upper: DVec3::splat(2.0 * self.edge),
            periodic: [false; 3],
            outside: Outside::Stop,
        };
        let walls = Shape::Box {
            lower: DVec3::ZERO,
            upper: DVec3::splat(self.edge),
            open: [false, false, false, false, false, true],
        };
        case.wall(1, walls, Motion::Rest);
        let shape = Shape::Rectangle {
            center: DVec3::new(0.5 * self.edge, 0.5 * self.edge, self.height),
            half_u: DVec3::X * self.edge,
            half_v: DVec3::Y * self.edge,
        };
        case.wall(1, shape, plate);
        case
    }

    /// Moving at random, with a share of the energy stored.
    pub fn shaken(&self, model: Model, share: f64) -> Self {
        let mut packing = self.clone();
        let mut sim = self.simulation(model, Motion::Rest);
        sim.start().unwrap();
        packing.shake(share * sim.energies().elastic);
        packing
    }

    /// Random velocities that carry a given energy [J].
    fn shake(&mut self, energy: f64) {
        let mut x = 99u64;
        let mut next = || {
            x = x
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (x >> 11) as f64 * 2f64.powi(-53) - 0.5
        };
        let mut kinetic = 0.0;
        let masses: Vec<f64> = self.grains.masses().collect();
        for (velocity, mass) in self.grains.velocity.iter_mut().zip(masses) {
            *velocity = DVec3::new(next(), next(), next());
            kinetic += 0.5 * mass * velocity.length_squared();
        }
        let factor = (energy / kinetic).sqrt();
        self.grains.velocity.iter_mut().for_each(|v| *v *= factor);
    }
}

/// Force on the plate [N].
pub fn pressing(sim: &Simulation) -> f64 {
    sim.walls[1].load().0.z
}
