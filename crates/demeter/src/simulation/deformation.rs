//! What a user may ask of a box that deforms, and what is refused.

use super::{Simulation, StressOf};
use crate::comm::ShearAxes;
use demeter_physics::integrator::Integrator;
use glam::DVec3;
use serde::{Deserialize, Serialize};

/// Names of the directions.
const NAMES: [&str; 3] = ["x", "y", "z"];

/// Most true strain of the box in one step: beyond it a step is no small change.
const MOST_STRAIN: f64 = 1e-2;

/// How the length of a box changes in one direction, or in all of them together; or its shear.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub enum Drive {
    /// The length stays.
    #[default]
    Fixed,
    /// A constant rate of true strain `(dL/dt)/L`, negative where the box shrinks [1/s]: `L = L0 exp(rate t)`. Of a shear its rate.
    StrainRate(f64),
    /// The length follows a stress.
    Stress {
        /// Stress that is wanted, compression positive, tension negative [Pa]. Of a shear the shear stress.
        target: f64,
        /// Largest rate of true strain, or of shear [1/s].
        max_rate: f64,
    },
}

/// How many drives a box has: of each direction, of all together, and of the shear.
pub(super) const DRIVES: usize = 5;

/// A simple shear of a periodic box (Lees and Edwards 1972).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Shear {
    /// Directions of flow and gradient.
    pub axes: ShearAxes,
    /// What drives it: a rate of shear, the change of the velocity along the gradient direction [1/s]; or the shear stress [Pa] that
    /// draws a face of the gradient direction along the flow, positive where it drives a positive rate.
    pub drive: Drive,
}

/// How a periodic box deforms.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Deformation {
    /// Each direction by itself.
    pub directions: [Drive; 3],
    /// All directions at one rate, which follows the mean stress; the single directions are then fixed.
    pub isotropic: Drive,
    /// Shear, if any.
    pub shear: Option<Shear>,
    /// Whether all grains follow the deformation as a body, or only feel it from the sides.
    pub affine: bool,
}

impl Default for Deformation {
    fn default() -> Self {
        Self {
            directions: [Drive::Fixed; 3],
            isotropic: Drive::Fixed,
            shear: None,
            affine: true,
        }
    }
}

/// Why a box cannot deform as it was told.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum DeformationError {
    /// A direction is not periodic.
    #[error("the box cannot deform along {direction}, which is not periodic; name it in `domain.periodic`")]
    NotPeriodic {
        /// Its name.
        direction: &'static str,
    },
    /// Flow and gradient are the same.
    #[error("flow and gradient of a shear are both {direction}; they must be two directions")]
    NoPlane {
        /// Its name.
        direction: &'static str,
    },
    /// The shear has other directions than before.
    #[error(
        "the box is sheared along {flow} over {gradient} already; its shear cannot turn to other directions in a run"
    )]
    OtherShear {
        /// Direction of the flow.
        flow: &'static str,
        /// Direction of the gradient.
        gradient: &'static str,
    },
    /// All directions together, and one of them by itself.
    #[error("`isotropic` drives all directions together; none of x, y and z can be driven by itself beside it")]
    Twice,
    /// A value that is not possible.
    #[error("the {what} must be {allowed}, found {value}")]
    Value {
        /// What it is.
        what: &'static str,
        /// What is allowed.
        allowed: &'static str,
        /// What was told.
        value: f64,
    },
    /// The box would change too much in one step.
    #[error(
        "at a rate of {rate} 1/s the box changes by {:.3} of its length in one time step of {dt:.3e} s; at most {MOST_STRAIN} \
         is allowed. Lower the rate, or use a shorter time step", rate.abs() * dt
    )]
    TooFast {
        /// Rate [1/s].
        rate: f64,
        /// Time step [s].
        dt: f64,
    },
    /// There is something that does not go with a box that deforms.
    #[error("{0}")]
    With(Misfit),
}

/// What does not go with a box that deforms.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Misfit {
    /// Walls.
    #[error(
        "a box that deforms cannot hold walls: the images of a grain move against it, and a wall would not move with them; \
         move walls, or deform a box without"
    )]
    Walls,
    /// Grains whose velocity forces do not change.
    #[error("a box that deforms cannot hold fixed grains: the images of a grain move against it")]
    FixedGrains,
    /// Gravity.
    #[error("there is no gravity in a box that deforms: without walls everything falls; leave `gravity` out")]
    Gravity,
    /// The predictor-corrector.
    #[error(
        "a box that deforms needs `integrator = \"velocity-verlet\"`: a grain that passes a side changes its velocity at once"
    )]
    Gear,
    /// Feeds.
    #[error("no grains can come or go while the box deforms: leave `feed` and `removal` out")]
    Traffic,
}

impl Drive {
    /// The rate that it may reach [1/s].
    pub fn largest_rate(&self) -> f64 {
        match *self {
            Self::Fixed => 0.0,
            Self::StrainRate(rate) => rate,
            Self::Stress { max_rate, .. } => max_rate,
        }
    }

    fn check(&self) -> Result<(), DeformationError> {
        let value = |what, allowed, value| Err(DeformationError::Value { what, allowed, value });
        match *self {
            Self::StrainRate(rate) if !rate.is_finite() => value("strain rate", "finite", rate),
            Self::Stress { target, .. } if !target.is_finite() => value("stress", "finite", target),
            Self::Stress { max_rate, .. } if !(max_rate > 0.0 && max_rate.is_finite()) => {
                value("largest strain rate", "positive", max_rate)
            }
            _ => Ok(()),
        }
    }
}

impl Deformation {
    /// Whether some length follows a stress.
    pub fn follows_stress(&self) -> bool {
        self.drives().iter().any(|drive| matches!(drive, Drive::Stress { .. }))
    }

    /// What drives each direction, all of them together, and the shear.
    pub(super) fn drives(&self) -> [Drive; DRIVES] {
        let [x, y, z] = self.directions;
        let shear = self.shear.map_or(Drive::Fixed, |shear| shear.drive);
        [x, y, z, self.isotropic, shear]
    }

    /// Whether it is possible in a domain with these periodic directions, with time steps `dt` [s].
    pub fn check(&self, periodic: [bool; 3], dt: f64) -> Result<(), DeformationError> {
        let named = |direction: usize| NAMES[direction.min(2)];
        let is_driven = |axis: usize| self.directions[axis] != Drive::Fixed;
        if self.isotropic != Drive::Fixed && (0..3).any(is_driven) {
            return Err(DeformationError::Twice);
        }
        let sheared = |axis: usize| {
            self.shear
                .is_some_and(|shear| shear.axes.flow == axis || shear.axes.gradient == axis)
        };
        for (axis, is_periodic) in periodic.into_iter().enumerate() {
            if !is_periodic && (is_driven(axis) || self.isotropic != Drive::Fixed || sheared(axis)) {
                return Err(DeformationError::NotPeriodic { direction: named(axis) });
            }
        }
        self.drives().iter().try_for_each(Drive::check)?;
        if let Some(shear) = self.shear.filter(|shear| shear.axes.flow == shear.axes.gradient) {
            let direction = named(shear.axes.flow);
            return Err(DeformationError::NoPlane { direction });
        }
        for rate in self.drives().map(|drive| drive.largest_rate()) {
            if rate.abs() * dt > MOST_STRAIN {
                return Err(DeformationError::TooFast { rate, dt });
            }
        }
        Ok(())
    }
}

/// How a length of a box, or its shear, comes by the stress that it is told.
pub(crate) struct FollowedStress {
    /// Which stress.
    pub of: StressOf,
    /// Stress that it is told [Pa].
    pub target: f64,
    /// Share of the steps since it first had that stress that it strained at its largest rate; nothing where it never had. Of shear, where the
    /// stress swings, the share of all steps; nothing where the stress is another in the mean.
    pub limited: Option<f64>,
    /// That rate [1/s].
    pub max_rate: f64,
}

impl Simulation {
    /// The lengths of the box that follow a stress, and its shear if it does.
    pub(crate) fn followed_stresses(&self) -> Vec<FollowedStress> {
        let Some(state) = self.deforming.as_deref() else {
            return Vec::new();
        };
        let stresses = [0, 1, 2].map(StressOf::Axis).into_iter().chain([StressOf::Mean]);
        let all = stresses.zip(&state.servos).zip(state.plan.drives());
        let followed = all.filter_map(|((of, servo), drive)| match (servo, drive) {
            (Some(servo), Drive::Stress { target, .. }) => {
                let (limited, max_rate) = servo.limited();
                Some(FollowedStress {
                    of,
                    target,
                    limited,
                    max_rate,
                })
            }
            _ => None,
        });
        let sheared = state.shear_drive.as_ref().map(|drive| {
            let (target, limited, max_rate) = drive.followed();
            FollowedStress {
                of: StressOf::Shear,
                target,
                limited,
                max_rate,
            }
        });
        followed.chain(sheared).collect()
    }

    /// Whether the box may deform as told. Where processes share the run each calls this.
    pub(super) fn check_deformation(&self, plan: &Deformation) -> Result<(), DeformationError> {
        let misfits = [
            (!self.walls.is_empty(), Misfit::Walls),
            (self.gravity != DVec3::ZERO, Misfit::Gravity),
            (self.integrator == Integrator::Gear, Misfit::Gear),
            (
                self.any_of_all(self.own_grains().any(|g| self.grains.is_fixed(g))),
                Misfit::FixedGrains,
            ),
        ];
        if let Some((_, misfit)) = misfits.into_iter().find(|(is_there, _)| *is_there) {
            return Err(DeformationError::With(misfit));
        }
        plan.check(self.domain().periodic, self.dt)?;
        if let (Some(old), Some(new)) = (self.comm.slides(), plan.shear)
            && old != new.axes
        {
            return Err(DeformationError::OtherShear {
                flow: NAMES[old.flow],
                gradient: NAMES[old.gradient],
            });
        }
        Ok(())
    }
}
