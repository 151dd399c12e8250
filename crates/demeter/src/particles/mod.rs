//! Grains as a struct of arrays, and the domain that they live in.

mod domain;

pub use domain::{Domain, Outside};

use demeter_physics::integrator::gear::Derivatives;
use glam::{DQuat, DVec3};
use serde::{Deserialize, Serialize};

/// A grain to be added.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NewGrain {
    /// Index of its material.
    pub material: u16,
    /// Radius [m].
    pub radius: f64,
    /// Mass density [kg/m^3].
    pub density: f64,
    /// Centre [m].
    pub position: DVec3,
    /// Velocity [m/s].
    pub velocity: DVec3,
    /// Angular velocity in the world frame [1/s].
    pub angular_velocity: DVec3,
}

/// All grains. Index `i` of every array is the same grain; `id` never changes, the index may.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Grains {
    /// Permanent identity, from 1.
    pub id: Vec<u32>,
    /// Index of the material.
    pub material: Vec<u16>,
    /// Radius [m].
    pub radius: Vec<f64>,
    /// Mass [kg].
    pub mass: Vec<f64>,
    /// Moment of inertia, `2/5 m r^2` [kg m^2].
    pub inertia: Vec<f64>,
    /// Centre [m], inside the periodic box when there is one.
    pub position: Vec<DVec3>,
    /// How many periodic boxes the grain has crossed, by direction.
    pub image: Vec<[i32; 3]>,
    /// Velocity [m/s].
    pub velocity: Vec<DVec3>,
    /// Angular velocity in the world frame [1/s].
    pub angular_velocity: Vec<DVec3>,
    /// Orientation.
    pub orientation: Vec<DQuat>,
    /// Total force of the latest step [N].
    pub force: Vec<DVec3>,
    /// Total torque of the latest step [N m].
    pub torque: Vec<DVec3>,
    /// What the predictor-corrector remembers beyond forces and torques; empty with velocity Verlet.
    pub higher: Vec<HigherDerivatives>,
}

/// Derivatives of the motion of one grain above the accelerations.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct HigherDerivatives {
    /// Third to fifth derivative of place [m/s^3, m/s^4, m/s^5].
    pub translation: Derivatives,
    /// Second to fourth derivative of the angular velocity [1/s^3, 1/s^4, 1/s^5].
    pub rotation: Derivatives,
}

impl Grains {
    /// Number of grains.
    pub fn len(&self) -> usize {
        self.id.len()
    }

    /// Whether there is no grain.
    pub fn is_empty(&self) -> bool {
        self.id.is_empty()
    }

    /// Adds a grain with the given id.
    pub fn push(&mut self, id: u32, grain: &NewGrain) {
        let r = grain.radius;
        let mass = grain.density * (4.0 / 3.0 * std::f64::consts::PI) * r * r * r;
        self.id.push(id);
        self.material.push(grain.material);
        self.radius.push(r);
        self.mass.push(mass);
        self.inertia.push(0.4 * mass * r * r);
        self.position.push(grain.position);
        self.image.push([0; 3]);
        self.velocity.push(grain.velocity);
        self.angular_velocity.push(grain.angular_velocity);
        self.orientation.push(DQuat::IDENTITY);
        self.force.push(DVec3::ZERO);
        self.torque.push(DVec3::ZERO);
        if !self.higher.is_empty() {
            self.higher.push(HigherDerivatives::default());
        }
    }

    /// Puts the grains into a new order: the grain at `order[k]` goes to index `k`. Grains not named are dropped.
    pub fn reorder(&mut self, order: &[u32]) {
        fn pick<T: Copy>(values: &mut Vec<T>, order: &[u32]) {
            *values = order.iter().map(|&i| values[i as usize]).collect();
        }
        pick(&mut self.id, order);
        pick(&mut self.material, order);
        pick(&mut self.radius, order);
        pick(&mut self.mass, order);
        pick(&mut self.inertia, order);
        pick(&mut self.position, order);
        pick(&mut self.image, order);
        pick(&mut self.velocity, order);
        pick(&mut self.angular_velocity, order);
        pick(&mut self.orientation, order);
        pick(&mut self.force, order);
        pick(&mut self.torque, order);
        if !self.higher.is_empty() {
            pick(&mut self.higher, order);
        }
    }
}
