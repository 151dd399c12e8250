//! Collisions of two bodies, integrated with error control instead of a fixed time step.
//!
//! * [`ode`]: an adaptive Runge-Kutta method of order 8 whose steps end on events.
//! * [`head_on`]: a head-on collision under any normal law: restitution, contact time, outcome, energies; and the
//!   motion of bodies that stick, beyond the moment at which that is decided.
//! * [`sticking`]: the speed below which two bodies stick.

mod dormand_prince;
pub mod head_on;
mod motion;
pub mod ode;
mod outcome;
mod record;
pub mod sticking;

#[cfg(test)]
mod adhesive_tests;
#[cfg(test)]
mod tests;
#[cfg(test)]
mod zero_force_tests;

pub use head_on::{HeadOn, restitution_of};
pub use outcome::{Collision, CollisionEnergy, CollisionError, Outcome, Start, Tolerance};
pub use record::Moment;
pub use sticking::{Sticking, sticking_speed, sticking_speed_of};
