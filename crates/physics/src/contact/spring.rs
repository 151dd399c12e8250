//! A spring that lies in the contact plane and remembers its load: shared by friction and rolling resistance.
//!
//! The load is kept at half steps. Over one step it changes by `-stiffness rate dt`; the law acts with its value in
//! the middle of the step, so that an elastic spring does exactly the work that it stores.

use glam::DVec3;

/// What drives the spring over one step.
#[derive(Clone, Copy, Debug)]
pub struct SpringInput {
    /// Unit normal of the contact.
    pub normal: DVec3,
    /// Rate of deformation, in the contact plane: a velocity for friction, an angular velocity for rolling.
    pub rate: DVec3,
    /// Mean angular velocity of the two bodies about the normal [1/s].
    pub spin: f64,
    /// Stiffness: force per length, or torque per angle.
    pub stiffness: f64,
    /// Coefficient of the dashpot beside the spring.
    pub damping: f64,
    /// Largest load that the contact can carry.
    pub limit: f64,
    /// Time step [s].
    pub dt: f64,
}

/// What the spring answers.
#[derive(Clone, Copy, Debug)]
pub struct SpringResponse {
    /// Load over this step: force or torque on the first body.
    pub load: DVec3,
    /// Energy dissipated in this step [J].
    pub dissipated: f64,
}

/// Number of remembered values: the load and the stiffness at which it was last seen.
pub const SPRING_HISTORY: usize = 4;

/// Energy stored by a spring with this history [J].
#[inline(always)]
pub fn spring_energy(history: &[f64]) -> f64 {
    let load = DVec3::new(history[0], history[1], history[2]);
    if history[3] > 0.0 {
        load.length_squared() / (2.0 * history[3])
    } else {
        0.0
    }
}

/// Turns a vector with the contact: into the new contact plane at unchanged length, and by the spin about the normal.
#[inline(always)]
pub fn carry_along(vector: DVec3, normal: DVec3, spin_angle: f64) -> DVec3 {
    let flat = vector - normal * vector.dot(normal);
    let turned = flat + normal.cross(flat) * spin_angle;
    let length2 = turned.length_squared();
    if length2 > 0.0 {
        turned * (vector.length_squared() / length2).sqrt()
    } else {
        turned
    }
}

/// A load cut back to the largest that the contact can carry.
#[inline(always)]
fn held(load: DVec3, limit: f64) -> DVec3 {
    let size = load.length();
    if size > limit { load * (limit / size) } else { load }
}

/// Advances the spring by one step.
///
/// When the stiffness falls (unloading), the load falls with it, so that no energy is made (Thornton 2015); when it
/// rises, the load stays: the force is continuous in both directions.
#[inline(always)]
pub fn advance_spring(input: &SpringInput, history: &mut [f64]) -> SpringResponse {
    let before = spring_energy(history);
    let old = DVec3::new(history[0], history[1], history[2]);
    let softening = if input.stiffness < history[3] {
        input.stiffness / history[3]
    } else {
        1.0
    };
    let kept = carry_along(old, input.normal, input.spin * input.dt) * softening;
    let half = input.rate * (0.5 * input.dt * input.stiffness);
    // The slider holds the spring at the limit at each of its times. The dashpot's share of the load is cut, too, but
    // it never loads the spring: that would store energy that nobody put in.
    let middle = held(kept - half, input.limit);
    let load = held(kept - half - input.rate * input.damping, input.limit);
    let next = held(middle - half, input.limit);
    history[0] = next.x;
    history[1] = next.y;
    history[2] = next.z;
    history[3] = input.stiffness;
    let work = -load.dot(input.rate) * input.dt;
    SpringResponse {
        load,
        dissipated: work - (spring_energy(history) - before),
    }
}
