//! One impact in the engine: of a sphere on a wall, or of two spheres, with any velocities and spins.

use crate::cases::{Case, Laws};
use demeter::materials::{Material, Materials};
use demeter::simulation::Simulation;
use demeter_physics::DVec3;

/// A body before or after the impact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Body {
    pub radius: f64,
    pub velocity: DVec3,
    pub spin: DVec3,
}

/// Overlap for which the time step is chosen, as share of the radius; the impacts stay below it.
const MAX_OVERLAP: f64 = 1e-2;

fn case(materials: Materials) -> Case {
    let mut case = Case::new(materials);
    case.max_overlap = MAX_OVERLAP;
    case
}

/// Impact on a plane whose normal is z. The plane is of material 1.
pub fn on_wall(sphere: Material, wall: Material, laws: &Laws, body: Body) -> Body {
    let mut case = case(Materials::new(vec![sphere, wall], |_, _| laws.0.clone()).unwrap());
    case.skin = 0.01 * body.radius;
    case.spinning_grain(
        body.radius,
        DVec3::Z * body.radius * (1.0 + 1e-6),
        body.velocity,
        body.spin,
    );
    case.plane(1, DVec3::ZERO, DVec3::Z);
    let sim = run(case);
    after(&sim, 1, body.radius)
}

/// Impact of two spheres on the z axis, the first above; both of one material.
pub fn of_spheres(material: Material, laws: &Laws, bodies: [Body; 2]) -> [Body; 2] {
    let mut case = case(Materials::new(vec![material], |_, _| laws.0.clone()).unwrap());
    let [above, below] = bodies;
    case.skin = 0.01 * above.radius.min(below.radius);
    let gap = 1e-6 * above.radius.min(below.radius);
    case.spinning_grain(
        above.radius,
        DVec3::Z * (above.radius + gap),
        above.velocity,
        above.spin,
    );
    case.spinning_grain(below.radius, -DVec3::Z * below.radius, below.velocity, below.spin);
    let sim = run(case);
    [after(&sim, 1, above.radius), after(&sim, 2, below.radius)]
}

fn run(case: Case) -> Simulation {
    let mut sim = case.simulation();
    crate::cases::run_until_parted(&mut sim);
    sim
}

fn after(sim: &Simulation, id: u32, radius: f64) -> Body {
    let k = crate::cases::index(sim, id);
    Body {
        radius,
        velocity: sim.grains().velocity[k],
        spin: sim.grains().angular_velocity[k],
    }
}

/// An elastic impact along the normal.
pub struct Approach {
    /// Effective mass [kg].
    pub mass: f64,
    /// Effective radius [m].
    pub radius: f64,
    /// Effective Young's modulus [Pa].
    pub modulus: f64,
    /// Speed [m/s].
    pub speed: f64,
}

impl Approach {
    /// Stiffness of the linear spring whose contact lasts as long as that of Hertz [N/m].
    pub fn matched_stiffness(&self) -> f64 {
        let energy = 15.0 / 16.0 * self.mass * self.speed * self.speed;
        let deepest = libm::pow(energy / (self.modulus * self.radius.sqrt()), 0.4);
        let rate = std::f64::consts::PI * self.speed / (2.943_275 * deepest);
        self.mass * rate * rate
    }
}

impl Body {
    /// Velocity of its surface at the point in a direction from its centre.
    pub fn surface_velocity(&self, direction: DVec3) -> DVec3 {
        self.velocity + self.spin.cross(direction * self.radius)
    }
}
