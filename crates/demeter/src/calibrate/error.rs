//! What can go wrong with two bodies.

use crate::contacts::Fault;
use crate::scenario::Diagnostics;
use crate::simulation::TimeStepError;
use demeter_physics::collision::CollisionError;
use demeter_physics::contact::LawError;
use demeter_physics::restitution::RestitutionError;

/// Why something about two bodies could not be computed.
#[derive(Debug, thiserror::Error)]
pub enum CalibrateError {
    /// The file is wrong for what is asked.
    #[error("{0}")]
    File(Box<Diagnostics>),
    /// A head-on collision has no result.
    #[error("{0}")]
    Collision(#[from] CollisionError),
    /// The engine stopped.
    #[error("the engine stopped: {0}")]
    Fault(Box<Fault>),
    /// The bodies overlap more than a run allows.
    #[error(
        "the engine stopped at step {step}: the bodies overlap by {share:.5} of the smaller radius, and a run allows {allowed} \
         unless it is told otherwise. Without `--engine` the impact is computed however deep it goes; a scenario with such \
         impacts needs `simulation.max_overlap`, and stiffer bodies or a lower `impact.velocity` stay below it"
    )]
    Overlap {
        /// Step.
        step: u64,
        /// Overlap as share of the smaller radius.
        share: f64,
        /// Allowed share.
        allowed: f64,
    },
    /// There is no usable time step.
    #[error("{0}")]
    TimeStep(#[from] TimeStepError),
    /// The bodies overlap by so little that the engine computes little else than rounding.
    #[error(
        "the bodies overlap by {overlap:.3e} m at most, and the engine rounds their places to {rounding:.1e} m: it cannot tell what \
         becomes of them; use a higher velocity, or leave out `--engine` where the impact is head-on"
    )]
    Rounding {
        /// Largest overlap [m].
        overlap: f64,
        /// Rounding of places [m].
        rounding: f64,
    },
    /// The engine needs too many steps.
    #[error(
        "the bodies did not part within {steps} steps of {dt:.3e} s ({time:.3e} s): {}",
        if *across_a_gap {
            "they come from too far or too slowly for the engine's step; tell `start = \"contact\"`, or use a higher velocity"
        } else {
            "they come apart too slowly for the engine's step; ask for a higher restitution or less damping, or leave out `--engine`"
        }
    )]
    Steps {
        /// Steps done.
        steps: u64,
        /// Time step [s].
        dt: f64,
        /// Simulated time [s].
        time: f64,
        /// Whether they began where an attraction is first felt.
        across_a_gap: bool,
    },
    /// A law refused its parameters.
    #[error("{0}")]
    Law(#[from] LawError),
    /// A closed form of the damped springs does not hold.
    #[error("{0}")]
    Restitution(#[from] RestitutionError),
    /// Bodies that were expected to stick at low speeds and to part at high ones do not.
    #[error("there is no critical sticking velocity at an effective radius of {radius} m")]
    NoStickingSpeed {
        /// Effective radius [m].
        radius: f64,
    },
    /// A law cannot do for these bodies what its parameters ask.
    #[error("{0}")]
    Refused(String),
    /// A curve was asked for that the law does not reach.
    #[error("{0}")]
    Curve(String),
}

impl From<Diagnostics> for CalibrateError {
    fn from(faults: Diagnostics) -> Self {
        Self::File(Box::new(faults))
    }
}

impl From<Fault> for CalibrateError {
    fn from(fault: Fault) -> Self {
        match fault {
            // a file of two bodies has no key for it
            Fault::Overlap {
                step,
                overlap_share,
                allowed,
                ..
            } => Self::Overlap {
                step,
                share: overlap_share,
                allowed,
            },
            fault => Self::Fault(Box::new(fault)),
        }
    }
}
