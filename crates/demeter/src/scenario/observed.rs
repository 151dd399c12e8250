//! What is sought and what was seen, in a file of observations.

use super::{Body, Partner};
use demeter_physics::dimension::Dimension;
use demeter_physics::parameters::Range;

/// A number that is sought.
#[derive(Clone, Debug, PartialEq)]
pub struct Unknown {
    /// As written: `restitution`, `material.mcc.young_modulus`.
    pub name: String,
    /// What it stands for.
    pub target: Target,
    /// Its dimension.
    pub dimension: Dimension,
    /// Where the search begins, least and largest.
    pub first: (f64, f64),
    /// Where it ends.
    pub last: (f64, f64),
}

/// What an unknown stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Target {
    /// A parameter of the law.
    Parameter(&'static str),
    /// Young's modulus of a material by its index.
    YoungModulus(usize),
    /// Poisson's ratio of a material by its index.
    PoissonRatio(usize),
}

/// What was seen of two bodies.
#[derive(Clone, Debug, PartialEq)]
pub struct Observation {
    /// The body that moves.
    pub a: Body,
    /// Its partner.
    pub b: Partner,
    /// Relative speed [m/s], when they collide.
    pub velocity: Option<f64>,
    /// Load before they are pulled apart [N]; absent: none.
    pub preload: Option<f64>,
    /// What was measured.
    pub measured: Vec<Measured>,
}

/// A measured quantity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// Which.
    pub observable: Observable,
    /// Its value in SI, positive.
    pub value: f64,
    /// Its standard error.
    pub error: StandardError,
}

/// The standard error of a measured quantity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum StandardError {
    /// As a share of the quantity, of which logarithms are compared.
    Relative(f64),
    /// In SI, whatever the quantity is.
    Absolute(f64),
}

impl Measured {
    /// How far off a value is that a law shows, told by its logarithm, in errors: `ln(x / measured) / relative` or `(x - measured) / absolute`.
    pub fn deviation(&self, logarithm: f64) -> f64 {
        match self.error {
            StandardError::Relative(error) => (logarithm - libm::log(self.value)) / error,
            StandardError::Absolute(error) => (libm::exp(logarithm) - self.value) / error,
        }
    }

    /// Its slope against the logarithm of the value.
    pub fn weight(&self, logarithm: f64) -> f64 {
        match self.error {
            StandardError::Relative(error) => 1.0 / error,
            StandardError::Absolute(error) => libm::exp(logarithm) / error,
        }
    }

    /// The same with a relative error, near what was measured.
    pub fn as_relative(&self) -> Self {
        let error = match self.error {
            StandardError::Relative(error) => error,
            StandardError::Absolute(error) => error / self.value,
        };
        Self {
            error: StandardError::Relative(error),
            ..*self
        }
    }
}

/// What can be measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Observable {
    /// Coefficient of restitution.
    Restitution,
    /// Contact time [s].
    ContactTime,
    /// Largest overlap [m].
    MaxOverlap,
    /// Largest force [N].
    MaxForce,
    /// Critical sticking velocity [m/s].
    StickingVelocity,
    /// Largest pull while bodies are slowly pulled apart [N].
    PullOffForce,
}

impl Observable {
    /// All of them.
    pub const ALL: [Self; 6] = [
        Self::Restitution,
        Self::ContactTime,
        Self::MaxOverlap,
        Self::MaxForce,
        Self::StickingVelocity,
        Self::PullOffForce,
    ];

    /// Its key.
    pub fn name(self) -> &'static str {
        match self {
            Self::Restitution => "restitution",
            Self::ContactTime => "contact_time",
            Self::MaxOverlap => "max_overlap",
            Self::MaxForce => "max_force",
            Self::StickingVelocity => "sticking_velocity",
            Self::PullOffForce => "pull_off_force",
        }
    }

    /// Its dimension.
    pub fn dimension(self) -> Dimension {
        match self {
            Self::Restitution => Dimension::NONE,
            Self::ContactTime => Dimension::TIME,
            Self::MaxOverlap => Dimension::LENGTH,
            Self::MaxForce | Self::PullOffForce => Dimension::FORCE,
            Self::StickingVelocity => Dimension::VELOCITY,
        }
    }

    /// Whether it is seen in a collision of a given velocity.
    pub fn of_impact(self) -> bool {
        !matches!(self, Self::StickingVelocity | Self::PullOffForce)
    }

    pub(super) fn range(self) -> Range {
        match self {
            Self::Restitution => Range::POSITIVE_SHARE,
            _ => Range::POSITIVE,
        }
    }
}
