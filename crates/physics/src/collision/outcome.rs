//! What is asked of a collision, what it gives, and why it may give nothing.

use crate::contact::PairSize;

/// Where the impact speed is given.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Start {
    /// At first touch, where the overlap is zero.
    Contact,
    /// Where the law first reaches across the gap: an attraction then pulls the bodies together before they touch.
    #[default]
    Far,
}

impl Start {
    /// As a file tells it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Contact => "contact",
            Self::Far => "far",
        }
    }
}

/// How exactly a collision is integrated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerance {
    /// Error allowed in a step, over the largest speed so far and the overlap, that now or the largest so far.
    pub relative: f64,
    /// Most steps that are tried.
    pub max_steps: usize,
}

impl Tolerance {
    /// Itself, where steps can be judged by it.
    pub(super) fn checked(self) -> Result<Self, CollisionError> {
        match self.relative > 0.0 && self.relative < 1.0 {
            true => Ok(self),
            false => Err(CollisionError::Tolerance { value: self.relative }),
        }
    }
}

impl Default for Tolerance {
    /// Restitution and contact time then meet the closed forms to 1e-11.
    fn default() -> Self {
        Self {
            relative: 1e-13,
            max_steps: 100_000,
        }
    }
}

/// How a collision ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// The bodies parted.
    Rebound,
    /// They turned round within reach of each other, or came to rest: what dissipates never lets them part later.
    Stick,
}

impl Outcome {
    /// The outcome in one word.
    pub fn name(self) -> &'static str {
        match self {
            Self::Rebound => "rebound",
            Self::Stick => "stick",
        }
    }
}

/// Energies of a collision [J].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CollisionEnergy {
    /// Kinetic energy of the relative motion at the start.
    pub kinetic_before: f64,
    /// Kinetic energy at the end.
    pub kinetic_after: f64,
    /// Lost in the dashpot.
    pub viscous: f64,
    /// Lost otherwise: plastic work, tear-off; what the other entries leave.
    pub lost: f64,
    /// Stored at the start; negative where an attraction acts.
    pub stored_before: f64,
    /// Stored at the end.
    pub stored_after: f64,
}

/// What a collision gave. After sticking everything is told of the moment at which the bodies turned round the second
/// time, or came to rest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Collision {
    /// Rebound or stick.
    pub outcome: Outcome,
    /// Speed at the end over that at the start; 0 after sticking.
    pub restitution: f64,
    /// Time from the start to the end, or to the decision that they stick [s].
    pub duration: f64,
    /// Largest overlap [m].
    pub max_overlap: f64,
    /// Largest total force [N].
    pub max_force: f64,
    /// Largest speed at the ends of the steps [m/s]: much more than at the start where attraction is what moves the bodies.
    pub(crate) max_speed: f64,
    /// Overlap at the end [m].
    pub final_overlap: f64,
    /// Energies.
    pub energy: CollisionEnergy,
    /// Steps that were tried.
    pub steps: usize,
}

impl Collision {
    /// How long the bodies felt each other [s]; without end after sticking.
    pub fn contact_time(&self) -> Option<f64> {
        (self.outcome == Outcome::Rebound).then_some(self.duration)
    }
}

/// Most moments of a collision that are kept.
pub(super) const MOST_MOMENTS: usize = 10_000_000;

/// Why a collision could not be computed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum CollisionError {
    /// A value that must be positive and finite is not.
    #[error("the {quantity} of the collision is {value}; it must be positive and finite")]
    Input {
        /// Which value.
        quantity: &'static str,
        /// The value.
        value: f64,
    },
    /// An error that no step can be held to, or that tells nothing.
    #[error("the relative tolerance of the collision is {value}; it must be above 0 and below 1, and 1e-13 is usual")]
    Tolerance {
        /// The value.
        value: f64,
    },
    /// More moments are asked for than are kept.
    #[error("{count} moments of a collision are too many; ask for at most {MOST_MOMENTS}")]
    Moments {
        /// How many.
        count: usize,
    },
    /// So slow that its energy cannot be told from that of the first touch, or from nothing.
    #[error(
        "an impact at {speed:e} m/s is too slow to be computed: its energy, {energy:e} J, is below what can be told from \
         nothing; use a higher speed"
    )]
    TooSlow {
        /// Impact speed [m/s].
        speed: f64,
        /// Its kinetic energy [J].
        energy: f64,
    },
    /// The law attracts from any distance, so that there is no place to start from.
    #[error("the law reaches {reach} m far; a collision that starts where the attraction is first felt needs an end")]
    Endless {
        /// The reach [m].
        reach: f64,
    },
    /// The law gave a value that is not a number.
    #[error(
        "the force is not finite at an overlap of {overlap} m and a rate of {rate} m/s; check the moduli and sizes"
    )]
    NotFinite {
        /// Overlap [m].
        overlap: f64,
        /// Rate of approach [m/s].
        rate: f64,
    },
    /// The end was not reached.
    #[error(
        "no end after {steps} steps, {time} s after the start, at an overlap of {overlap} m and a rate of {rate} m/s: \
         the contact is over-damped by far, or the tolerance too small"
    )]
    Steps {
        /// Steps that were tried.
        steps: usize,
        /// Time [s].
        time: f64,
        /// Overlap [m].
        overlap: f64,
        /// Rate of approach [m/s].
        rate: f64,
    },
}

/// The value, if it is positive and finite.
pub(super) fn positive(quantity: &'static str, value: f64) -> Result<f64, CollisionError> {
    match value > 0.0 && value.is_finite() {
        true => Ok(value),
        false => Err(CollisionError::Input { quantity, value }),
    }
}

/// Refuses bodies that cannot be.
pub(super) fn check_size(size: PairSize) -> Result<(), CollisionError> {
    positive("effective radius", size.radius)?;
    positive("effective mass", size.mass)?;
    Ok(())
}
