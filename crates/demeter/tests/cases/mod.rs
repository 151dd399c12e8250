//! Set-ups shared by the verification cases and the invariants.
#![allow(dead_code, reason = "every test file uses its own part")]
#![allow(clippy::unwrap_used, clippy::panic, reason = "a set-up that fails is a failed test")]

pub mod beds;
pub mod ranks;

use demeter::contacts::Coupling;
use demeter::materials::{Material, Materials, PairChoice};
use demeter::particles::{Domain, Grains, NewGrain, Outside};
use demeter::simulation::{SAFE_SHARE, Setup, Simulation, Skin, WallPartner, shortest_time_scale};
use demeter::walls::{Motion, Motions, Shape, Wall};
use demeter_physics::DVec3;
use demeter_physics::contact::LawChoice;
use demeter_physics::integrator::Integrator;

/// Largest overlap for which the automatic time step is made, as share of the radius.
pub const MAX_OVERLAP: f64 = 0.05;

/// Standard gravity [m/s^2].
pub const G: f64 = 9.80665;

/// Whether the cases run at full size, as `cargo xtask verify` asks.
pub fn full() -> bool {
    std::env::var("DEMETER_FULL").is_ok_and(|v| v == "1")
}

/// Shows a measured number under `--no-capture`.
#[allow(
    clippy::print_stderr,
    reason = "the numbers of a verification case are wanted by whoever runs it"
)]
pub fn report(what: &str, value: f64) {
    eprintln!("{what}: {value:.4e}");
}

/// Slope of a straight line through `(ln x, ln y)`.
pub fn fitted_order(points: &[(f64, f64)]) -> f64 {
    let logs: Vec<(f64, f64)> = points.iter().map(|(x, y)| (libm::log(*x), libm::log(*y))).collect();
    let n = logs.len() as f64;
    let (mx, my) = (
        logs.iter().map(|p| p.0).sum::<f64>() / n,
        logs.iter().map(|p| p.1).sum::<f64>() / n,
    );
    let covariance: f64 = logs.iter().map(|p| (p.0 - mx) * (p.1 - my)).sum();
    let variance: f64 = logs.iter().map(|p| (p.0 - mx) * (p.0 - mx)).sum();
    covariance / variance
}

/// A law with its parameters.
pub fn law(name: &str, parameters: &[(&str, f64)]) -> LawChoice {
    LawChoice {
        law: name.into(),
        parameters: demeter_physics::parameters::values(parameters),
    }
}

/// Laws of a contact, told one after the other: `hertz(0.5).with_friction(...)`.
#[derive(Clone)]
pub struct Laws(pub PairChoice);

impl Laws {
    pub fn hertz(restitution: f64) -> Self {
        Self::of(law("hertz-tsuji", &[("restitution", restitution)]))
    }

    pub fn linear(stiffness: f64, restitution: f64) -> Self {
        Self::of(law("linear", &[("stiffness", stiffness), ("restitution", restitution)]))
    }

    pub fn of(normal: LawChoice) -> Self {
        Self(PairChoice {
            normal,
            tangential: None,
            rolling: None,
            multi_contact: None,
        })
    }

    pub fn friction(mut self, choice: LawChoice) -> Self {
        self.0.tangential = Some(choice);
        self
    }

    pub fn multi_contact(mut self, name: &str, parameters: &[(&str, f64)]) -> Self {
        self.0.multi_contact = Some(law(name, parameters));
        self
    }

    pub fn rolling(mut self, name: &str, rolling_friction: f64) -> Self {
        self.0.rolling = Some(law(name, &[("rolling_friction", rolling_friction)]));
        self
    }
}

/// Triangles of a brick, told by its centre and half of its edges.
pub fn brick(center: DVec3, half: DVec3) -> Vec<[DVec3; 3]> {
    let side = |bit: usize| if bit > 0 { 1.0 } else { -1.0 };
    let corner = |k: usize| center + half * DVec3::new(side(k & 1), side(k & 2), side(k & 4));
    let faces = [
        [0, 2, 3, 1],
        [4, 5, 7, 6],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 4, 6, 2],
        [1, 3, 7, 5],
    ];
    let halves = faces.into_iter().flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]]);
    halves.map(|corners| corners.map(corner)).collect()
}

pub fn material(young_modulus: f64) -> Material {
    Material {
        name: format!("material of {young_modulus} Pa"),
        young_modulus,
        poisson_ratio: 0.3,
        density: 2500.0,
    }
}

/// One material, the same laws everywhere.
pub fn one_material(young_modulus: f64, laws: &Laws) -> Materials {
    Materials::new(vec![material(young_modulus)], |_, _| laws.0.clone()).unwrap()
}

/// Material 0 for grains and rough walls, material 1 for walls without friction.
pub fn rough_and_smooth(young_modulus: f64, rough: &Laws, smooth: &Laws) -> Materials {
    let list = vec![material(young_modulus), material(young_modulus)];
    Materials::new(list, |_, b| if b == 1 { smooth.0.clone() } else { rough.0.clone() }).unwrap()
}

/// A case under construction.
pub struct Case {
    pub grains: Grains,
    pub walls: Vec<Wall>,
    pub materials: Materials,
    pub domain: Domain,
    pub gravity: DVec3,
    pub integrator: Integrator,
    pub coupling: Coupling,
    pub skin: f64,
    pub max_overlap: f64,
    /// The time step as share of the shortest time scale.
    pub share: f64,
}

impl Case {
    pub fn new(materials: Materials) -> Self {
        let mut grains = Grains::default();
        grains.follow_orientations();
        Self {
            grains,
            walls: vec![],
            materials,
            domain: Domain {
                lower: DVec3::splat(-1.0),
                upper: DVec3::splat(1.0),
                periodic: [false; 3],
                outside: Outside::Stop,
            },
            gravity: DVec3::ZERO,
            integrator: Integrator::VelocityVerlet,
            coupling: Coupling::default(),
            skin: 1e-4,
            max_overlap: MAX_OVERLAP,
            share: SAFE_SHARE,
        }
    }

    /// Adds a grain of material 0 and returns its id.
    pub fn grain(&mut self, radius: f64, position: DVec3, velocity: DVec3) -> u32 {
        self.spinning_grain(radius, position, velocity, DVec3::ZERO)
    }

    pub fn spinning_grain(&mut self, radius: f64, position: DVec3, velocity: DVec3, spin: DVec3) -> u32 {
        let id = self.grains.len() as u32 + 1;
        let grain = NewGrain {
            fixed: false,
            material: 0,
            radius,
            density: self.materials.list()[0].density,
            position,
            velocity,
            angular_velocity: spin,
        };
        self.grains.push(id, &grain);
        id
    }

    pub fn wall(&mut self, material: u16, shape: Shape, motion: impl Into<Motions>) {
        let name = format!("wall {}", self.walls.len());
        self.walls.push(Wall::new(&name, material, shape, motion).unwrap());
    }

    /// A plane through a point.
    pub fn plane(&mut self, material: u16, point: DVec3, normal: DVec3) {
        self.wall(material, Shape::Plane { point, normal }, Motion::Rest);
    }

    pub fn setup(self) -> Setup {
        let walls: Vec<WallPartner> = self.walls.iter().map(WallPartner::of).collect();
        let scale = shortest_time_scale(&self.grains, &walls, &self.materials, self.max_overlap).unwrap();
        Setup {
            grains: self.grains,
            walls: self.walls,
            materials: self.materials,
            domain: self.domain,
            gravity: self.gravity,
            integrator: self.integrator,
            coupling: self.coupling,
            dt: self.share * scale.time,
            skin: Skin::Fixed(self.skin),
            max_overlap: self.max_overlap,
        }
    }

    pub fn simulation(self) -> Simulation {
        Simulation::new(self.setup())
    }
}

/// Index of the grain with an id.
pub fn index(sim: &Simulation, id: u32) -> usize {
    sim.grains().id.iter().position(|&i| i == id).unwrap()
}

/// Runs small cases without the cost of waking other threads.
pub fn on_threads<T: Send>(threads: usize, work: impl FnOnce() -> T + Send) -> T {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    pool.install(work)
}

/// Steps until a time [s] from now.
pub fn advance(sim: &mut Simulation, duration: f64) {
    let steps = (duration / sim.dt()).round() as u64;
    for _ in 0..steps {
        sim.step().unwrap();
    }
}

/// Steps until the first contact has come and gone, and until the integrator no longer remembers its forces.
pub fn run_until_parted(sim: &mut Simulation) {
    // the predictor-corrector hands the impulse of a force over to the velocity within four steps
    let remembered = if sim.grains().higher.is_empty() { 0 } else { 4 };
    let mut touched = false;
    for _ in 0..1_000_000 {
        sim.step().unwrap();
        let contacts = sim.contacts.pair_count() + sim.contacts.wall_count();
        touched |= contacts > 0;
        if touched && contacts == 0 {
            for _ in 0..remembered {
                sim.step().unwrap();
            }
            return;
        }
    }
    panic!("the collision never ended");
}

/// Overlap at which a Hertzian contact of a grain and a wall of the same material carries a force [m].
pub fn hertz_overlap(young_modulus: f64, radius: f64, force: f64) -> f64 {
    let effective = young_modulus / (2.0 * (1.0 - 0.3 * 0.3));
    let x = force / (4.0 / 3.0 * effective * radius.sqrt());
    libm::pow(x, 2.0 / 3.0)
}

/// Mass of a grain of the default density [kg].
pub fn mass(radius: f64) -> f64 {
    2500.0 * 4.0 / 3.0 * std::f64::consts::PI * radius * radius * radius
}
