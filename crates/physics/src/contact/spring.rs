//! A spring that lies in the contact plane and remembers its load: shared by friction, rolling resistance and, along the normal, torsion.
//!
//! The load is kept at half steps. Over one step it changes by `-stiffness rate dt`; the law acts with its value in
//! the middle of the step, so that an elastic spring does exactly the work that it stores.

use crate::lanes::{Lanes, Mask, Vector};

/// What drives the spring over one step.
#[derive(Clone, Copy, Debug)]
pub struct SpringInput<L: Lanes = f64> {
    /// Unit normal of the contact.
    pub normal: L::Vector,
    /// Rate of deformation, in the contact plane: a velocity for friction, an angular velocity for rolling.
    pub rate: L::Vector,
    /// Mean angular velocity of the two bodies about the normal [1/s].
    pub spin: L,
    /// Stiffness: force per length, or torque per angle.
    pub stiffness: L,
    /// Its inverse; 0 of no spring.
    pub compliance: L,
    /// Coefficient of the dashpot beside the spring.
    pub damping: L,
    /// Largest load that the contact can carry.
    pub limit: L,
    /// Time step [s].
    pub dt: f64,
}

/// Coefficient of a dashpot with a share of critical damping beside a spring: `2 ratio sqrt(inertia stiffness)`.
#[inline(always)]
pub fn dashpot<L: Lanes>(damping_ratio: f64, stiffness: L, inertia: L) -> L {
    (stiffness * inertia).sqrt() * (2.0 * damping_ratio)
}

/// What the spring answers.
#[derive(Clone, Copy, Debug)]
pub struct SpringResponse<L: Lanes = f64> {
    /// Load over this step: force or torque on the first body.
    pub load: L::Vector,
    /// Energy dissipated in this step [J].
    pub dissipated: L,
}

/// Number of remembered values: the load and the compliance at which it was last seen, 0 of a spring that is new.
pub const SPRING_HISTORY: usize = 4;

/// Energy stored by a spring with this history [J].
#[inline(always)]
pub fn spring_energy<L: Lanes>(history: &[L]) -> L {
    energy_of(L::Vector::new(history[0], history[1], history[2]), history[3])
}

/// Deformation per load; 0 of no spring.
#[inline(always)]
pub fn compliance<L: Lanes>(stiffness: L) -> L {
    (L::splat(1.0) / stiffness).keep(stiffness.gt(L::splat(0.0)))
}

/// Energy stored by a spring under a load [J].
#[inline(always)]
fn energy_of<L: Lanes>(load: L::Vector, compliance: L) -> L {
    load.square() * compliance * 0.5
}

/// A remembered load that turned with the contact; times `factor` it has the length that it had.
#[derive(Clone, Copy, Debug)]
pub struct Carried<L: Lanes = f64> {
    turned: L::Vector,
    factor: L,
}

impl<L: Lanes> Carried<L> {
    /// A load that was turned already.
    #[inline(always)]
    pub fn turned(load: L::Vector) -> Self {
        Self {
            turned: load,
            factor: L::splat(1.0),
        }
    }
}

/// Turns the load of a history with the contact: into the new contact plane, and by the spin about the normal.
#[inline(always)]
pub fn carry_along<L: Lanes>(history: &[L], normal: L::Vector, spin_angle: L) -> Carried<L> {
    let vector = L::Vector::new(history[0], history[1], history[2]);
    let (along, square) = (vector.inner(normal), vector.square());
    let flat = vector - normal * along;
    let turned = flat + normal.outer(flat) * spin_angle;
    // that of the turned vector, which it need not wait for: its two parts are perpendicular, and in the contact plane
    let length2 = (square - along * along) * (spin_angle * spin_angle + 1.0);
    let factor = (square / length2).sqrt();
    Carried {
        turned,
        factor: L::select(length2.gt(L::splat(0.0)), factor, L::splat(1.0)),
    }
}

/// Whether a load is larger than the contact can carry.
#[inline(always)]
fn slides<L: Lanes>(load: L::Vector, limit: L) -> L::Mask {
    load.square().gt(limit * limit)
}

/// A load cut back to the largest that the contact can carry.
#[inline(always)]
fn held<L: Lanes>(load: L::Vector, limit: L) -> L::Vector {
    (load * (limit / load.square().sqrt())).or(slides(load, limit), load)
}

/// Advances the spring by one step, told how its load is carried along where that is known already.
///
/// When the stiffness falls (unloading), the load falls with it, so that no energy is made (Thornton 2015); when it
/// rises, the load stays: the force is continuous in both directions.
#[inline(always)]
pub fn advance_spring<L: Lanes>(
    input: &SpringInput<L>,
    history: &mut [L],
    carried: Option<Carried<L>>,
) -> SpringResponse<L> {
    let carried = match carried {
        Some(known) => known,
        None => carry_along(history, input.normal, input.spin * input.dt),
    };
    let old = L::Vector::new(history[0], history[1], history[2]);
    let old_compliance = history[3];
    let before = energy_of(old, old_compliance);
    let ratio = input.stiffness * old_compliance;
    let softens = ratio.lt(L::splat(1.0)) & old_compliance.gt(L::splat(0.0));
    let softening = L::select(softens, ratio, L::splat(1.0));
    let kept = carried.turned * (carried.factor * softening);
    let half = input.rate * (input.stiffness * (0.5 * input.dt));
    // The slider holds the spring at the limit at each of its times. The dashpot's share of the load is cut, too, but
    // it never loads the spring: that would store energy that nobody put in.
    let limit = input.limit;
    let middle = kept - half;
    let mut load = middle - input.rate * input.damping;
    let mut next = middle - half;
    // one question for all three: what is rare is asked once
    if (slides(middle, limit) | slides(load, limit) | slides(next, limit)).any() {
        load = held(load, limit);
        next = held(held(middle, limit) - half, limit);
    }
    history[..3].copy_from_slice(&next.components());
    history[3] = input.compliance;
    let work = -load.inner(input.rate) * input.dt;
    SpringResponse {
        load,
        dissipated: work - (energy_of(next, input.compliance) - before),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use glam::DVec3;

    #[test]
    fn a_load_that_turns_keeps_its_length_and_lies_in_the_plane() {
        let normal = DVec3::new(2.0, -1.0, 2.0) / 3.0;
        for (load, spin_angle) in [(DVec3::new(1.0, 2.0, 0.1), 0.02), (DVec3::new(-3.0, 1.0, 2.0), -0.4)] {
            let carried = carry_along::<f64>(&[load.x, load.y, load.z, 1.0], normal, spin_angle);
            let now = carried.turned * carried.factor;
            assert_relative_eq!(now.length(), load.length(), max_relative = 1e-14);
            assert_relative_eq!(now.dot(normal), 0.0, epsilon = 1e-14);
        }
        assert_eq!(carry_along::<f64>(&[0.0; 4], normal, 0.1).factor, 1.0);
    }
}
