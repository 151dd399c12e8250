//! What motions are refused.

use super::body::BodyMotion;
use super::error::WallError;
use super::limits::{finite, in_range, not_negative, positive, unit};
use super::mass::BodyMass;
use super::motion::{FreeMotion, Freedom, Motion, MotionPart, Motions};
use super::pace::Pace;

/// Most motions of one wall that add up.
pub const MAX_PARTS: usize = 16;

/// What to do where walls are linked.
pub(crate) const INSTEAD_OF_LINKS: &str = "let all of them move with the one that has a motion of its own";

/// A wall that moves with another one, and that other, which does not move by itself either: one of the two is the wall that is told. Given
/// is the one that each wall moves with.
pub(crate) fn link(leaders: &[Option<usize>], wall: usize) -> Option<[usize; 2]> {
    let leader_of = |wall: usize| leaders.get(wall).copied().flatten();
    let leader = leader_of(wall)?;
    if leader_of(leader).is_some() {
        return Some([wall, leader]);
    }
    let follower = (0..leaders.len()).find(|&other| leader_of(other) == Some(wall))?;
    Some([follower, wall])
}

/// Such a link.
pub(crate) fn link_in_words(follower: &str, leader: &str) -> String {
    match follower == leader {
        true => format!("wall `{follower}` moves with itself"),
        false => format!("wall `{follower}` moves with `{leader}`, which itself moves with another wall"),
    }
}

/// Checks the motions of a wall, and makes their directions exact unit vectors.
pub(super) fn check_motions(motions: Motions) -> Result<Motions, WallError> {
    let count = motions.parts.len();
    if count > MAX_PARTS {
        return Err(WallError::Parts { count });
    }
    for (place, part) in motions.parts.iter().enumerate() {
        if matches!(part.motion, Motion::Free(_) | Motion::Body(_)) && place > 0 {
            return Err(WallError::FreeNotFirst);
        }
        if matches!(part.motion, Motion::With(_)) && count > 1 {
            return Err(WallError::WithOthers);
        }
    }
    let parts = motions.parts.into_iter().map(|part| {
        Ok(MotionPart {
            pace: check_pace(part.pace, &part.motion)?,
            motion: check_motion(part.motion)?,
        })
    });
    Ok(Motions {
        parts: parts.collect::<Result<_, WallError>>()?,
    })
}

fn check_pace(pace: Pace, motion: &Motion) -> Result<Pace, WallError> {
    if pace == Pace::FULL {
        return Ok(pace);
    }
    let is_prescribed = !matches!(
        motion,
        Motion::Servo { .. }
            | Motion::TorqueServo { .. }
            | Motion::Free(_)
            | Motion::Body(_)
            | Motion::With(_)
            | Motion::Driven { .. }
    );
    if !is_prescribed {
        return Err(WallError::PaceOfForce);
    }
    not_negative("start_over", pace.start_over)?;
    not_negative("stop_over", pace.stop_over)?;
    if pace.stop_after < pace.start_over || pace.stop_after.is_nan() {
        return Err(WallError::StopsBeforeStart {
            stop_after: pace.stop_after,
            start_over: pace.start_over,
        });
    }
    Ok(pace)
}

fn check_motion(motion: Motion) -> Result<Motion, WallError> {
    let any = |_: f64| true;
    Ok(match motion {
        Motion::Rest | Motion::Table(_) | Motion::With(_) | Motion::Driven { axis: None } => motion,
        Motion::Driven {
            axis: Some((point, axis)),
        } => Motion::Driven {
            axis: Some((
                finite("the point of the axis of rotation", point)?,
                unit("the axis of rotation", axis)?,
            )),
        },
        Motion::Velocity(velocity) => Motion::Velocity(finite("the velocity", velocity)?),
        Motion::Belt(velocity) => Motion::Belt(finite("the velocity of the belt", velocity)?),
        Motion::Rotation {
            point,
            axis,
            angular_velocity,
        } => Motion::Rotation {
            point: finite("the point of the axis of rotation", point)?,
            axis: unit("the axis of rotation", axis)?,
            angular_velocity: in_range("the angular velocity", angular_velocity, "at most 1e100", any)?,
        },
        Motion::Oscillation {
            amplitude,
            frequency,
            phase,
        } => Motion::Oscillation {
            amplitude: finite("the amplitude", amplitude)?,
            frequency: not_negative("the frequency", frequency)?,
            phase: in_range("the phase", phase, "at most 1e100", any)?,
        },
        Motion::Rocking {
            point,
            axis,
            amplitude,
            frequency,
            phase,
        } => Motion::Rocking {
            point: finite("the point of the axis of rocking", point)?,
            axis: unit("the axis of rocking", axis)?,
            amplitude: in_range("the amplitude", amplitude, "at most 1e100", any)?,
            frequency: not_negative("the frequency", frequency)?,
            phase: in_range("the phase", phase, "at most 1e100", any)?,
        },
        Motion::Servo { axis, force, max_speed } => Motion::Servo {
            axis: unit("the axis of the servo", axis)?,
            force: positive("the force of the servo", force)?,
            max_speed: positive("max_speed of the servo", max_speed)?,
        },
        Motion::TorqueServo {
            point,
            axis,
            torque,
            max_speed,
        } => Motion::TorqueServo {
            point: finite("the point of the axis of the servo", point)?,
            axis: unit("the axis of the servo", axis)?,
            torque: positive("the torque of the servo", torque)?,
            max_speed: positive("max_speed of the servo", max_speed)?,
        },
        Motion::Free(free) => Motion::Free(check_free(free)?),
        Motion::Body(body) => Motion::Body(check_body(body)?),
    })
}

fn check_body(body: BodyMotion) -> Result<BodyMotion, WallError> {
    let turns = body.turns.contains(&true);
    if !turns && !body.slides.contains(&true) {
        return Err(WallError::BodyHeld);
    }
    match body.mass {
        BodyMass::Density(density) => drop(positive("the density", density)?),
        BodyMass::Told(told) => {
            positive("the mass", told.mass)?;
            finite("the centre of mass", told.center)?;
            for moments in [told.inertia.x_axis, told.inertia.y_axis, told.inertia.z_axis] {
                finite("the inertia", moments)?;
            }
            if turns && !told.are_possible() {
                return Err(WallError::Inertia);
            }
        }
    }
    finite("the acceleration of gravity", body.gravity)?;
    finite("the velocity at the start", body.velocity)?;
    finite("the angular velocity at the start", body.angular_velocity)?;
    Ok(body)
}

fn check_free(free: FreeMotion) -> Result<FreeMotion, WallError> {
    let freedom = match free.freedom {
        Freedom::Slide { axis } => Freedom::Slide {
            axis: unit("the axis of the slide", axis)?,
        },
        Freedom::Hinge {
            point,
            axis,
            center_of_mass,
        } => Freedom::Hinge {
            point: finite("the point of the hinge", point)?,
            axis: unit("the axis of the hinge", axis)?,
            center_of_mass: finite("the centre of mass", center_of_mass)?,
        },
    };
    let [lower, upper] = free.stops;
    if !(lower <= 0.0 && 0.0 <= upper && lower < upper) {
        return Err(WallError::Stops { lower, upper });
    }
    Ok(FreeMotion {
        freedom,
        inertia: positive("the mass or inertia", free.inertia)?,
        weight: finite("the weight", free.weight)?,
        stiffness: not_negative("the stiffness", free.stiffness)?,
        damping: not_negative("the damping", free.damping)?,
        speed: in_range("the speed at the start", free.speed, "at most 1e100", |_| true)?,
        stops: free.stops,
    })
}
