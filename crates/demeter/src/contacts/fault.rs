//! What stops a run: a state that the model does not cover.

use glam::DVec3;
use serde::{Deserialize, Serialize};
use std::borrow::Cow;
use std::fmt;

/// Why a run stopped: what, where, since when, with whom, why, and what to change.
#[derive(Clone, Debug, PartialEq, thiserror::Error, Serialize, Deserialize)]
pub enum Fault {
    /// Two bodies overlap more than the scenario allows.
    #[error(
        "step {step}: grain {id} at {} overlaps {partner} by {:.5} of the smaller radius; the scenario allows {allowed}. {}",
        place(.position), overlap_share, why_so_deep(.partner, *.overlap_share)
    )]
    Overlap {
        /// Step.
        step: u64,
        /// Id of the grain.
        id: u32,
        /// Its centre [m].
        position: DVec3,
        /// The partner: `"grain 17"`, `"wall floor"`.
        partner: String,
        /// Overlap as share of the smaller radius.
        overlap_share: f64,
        /// Allowed share.
        allowed: f64,
    },
    /// A grain left the domain.
    #[error(
        "{departure}; the domain reaches from {} to {}. Cause: {WHY_OUTSIDE}. Remedy: close the gap, \
         widen `domain`, or set `domain.outside = \"remove\"` if grains may leave",
        place(.lower), place(.upper)
    )]
    Outside {
        /// Which, where and how.
        departure: Departure,
        /// Lower corner of the domain [m].
        lower: DVec3,
        /// Upper corner of the domain [m].
        upper: DVec3,
    },
    /// The contacts of a grain displace each other more than they can bear.
    #[error(
        "step {step}: the contact of grain {id} at {} with {partner} has no coupled force: at a strain of {:.4} (overlap over \
         the distance at touch) the other contacts of these bodies displace it by {}, and what it \
         pushes back displaces them in turn without end. Cause: the multi-contact model is one of small strain; its \
         equation has no solution beyond a fold, for a regular packing at a few per cent. With a normal law that is stiffer than \
         `young_modulus` tells, as one of a given stiffness may be, it has none at any strain. Remedy: compress less, lower \
         `prefactor`, raise `young_modulus`, lower the stiffness of the normal law, or take another `multi_contact` law",
        place(.position), strain, displaced_by(*displacement_share)
    )]
    BeyondFold {
        /// Step.
        step: u64,
        /// Id of the grain.
        id: u32,
        /// Its centre [m].
        position: DVec3,
        /// The partner: `"grain 17"`, `"wall floor"`.
        partner: String,
        /// Overlap of the undisplaced bodies over the distance of their centres at touch.
        strain: f64,
        /// What the other contacts displace it by, as share of the smaller radius.
        displacement_share: f64,
    },
    /// A periodic box shrank so far that a grain would meet two images of a partner.
    #[error(
        "step {step}: the periodic box is {size:.6} m long along {direction}; with grain {id}, the largest, it must be \
         longer than {least:.6} m, or a grain meets two images of one partner. Cause: compression beyond what the number of \
         grains allows, or a stress that the grains cannot bear at any volume. Remedy: take more grains or end the \
         compression earlier"
    )]
    BoxTooSmall {
        /// Step.
        step: u64,
        /// Id of the largest grain.
        id: u32,
        /// The direction.
        direction: Cow<'static, str>,
        /// Length of the box [m].
        size: f64,
        /// Length that it must have [m].
        least: f64,
    },
    /// A custom force or motion had no answer. The step was completed without it.
    #[error(
        "step {step}: the custom {what} failed: {reason}. The step was completed with its last answer (a force) or at rest (a \
         wall). Remedy: correct the function; the run may go on from here"
    )]
    Custom {
        /// Step.
        step: u64,
        /// What failed: `"force"`, ``"motion of wall `lid`"``.
        what: String,
        /// Why.
        reason: String,
    },
    /// A grain went round a periodic box more often than is counted.
    #[error(
        "step {step}: grain {id} at {} went round the periodic box in one direction more than {most} times, which is as far as \
         that is counted. Cause: a very long run of a short box. Remedy: make the box longer, or end the run earlier",
        place(.position)
    )]
    CrossedTooOften {
        /// Step.
        step: u64,
        /// Id of the grain.
        id: u32,
        /// Its centre [m].
        position: DVec3,
        /// Most crossings that are counted.
        most: i32,
    },
    /// A grain moves so far in one step that it may jump over others.
    #[error(
        "step {step}: grain {id} at {} moves at {speed:.4e} m/s, which is {way:.4e} m in one step and more than its radius of \
         {radius:.4e} m: it may come to the other side of a grain or a wall without touching it. Cause: a speed far beyond what \
         the time step was made for. Remedy: lower the speed or the time step",
        place(.position)
    )]
    Jump {
        /// Step.
        step: u64,
        /// Id of the grain.
        id: u32,
        /// Its centre [m].
        position: DVec3,
        /// Its speed [m/s].
        speed: f64,
        /// How far it moves in a step [m].
        way: f64,
        /// Its radius [m].
        radius: f64,
    },
    /// A value is not a finite number.
    #[error(
        "step {step}: the {quantity} of grain {id} (last seen near {}) is not a finite number. Cause: a time step far \
         above the safe one, or a parameter at the edge of its range. Remedy: use `time_step = \"auto\"`; look at the \
         snapshot of the last frame",
        place(.position)
    )]
    NotFinite {
        /// Step.
        step: u64,
        /// Id of the grain.
        id: u32,
        /// What is not finite: `"position"`, `"force"`.
        quantity: Cow<'static, str>,
        /// The last position known [m].
        position: DVec3,
    },
    /// What the scenario asks for at this moment cannot be done.
    #[error("step {step}: {reason}")]
    CannotGoOn {
        /// Step.
        step: u64,
        /// Id of the grain that is in the way; 0 where none is.
        id: u32,
        /// What cannot be done, why, and what to do.
        reason: String,
    },
    /// The place or velocity of a wall is not a finite number.
    #[error(
        "step {step}: the {quantity} of wall `{wall}` is not a finite number. Cause: a time step far above the safe one, or a \
         mass, spring, damper, speed or force at the edge of its range. Remedy: use `time_step = \"auto\"`; look at the motion of \
         the wall and at the rows before"
    )]
    WallNotFinite {
        /// Step.
        step: u64,
        /// Name of the wall.
        wall: String,
        /// What is not finite: `"place"`, `"velocity"`.
        quantity: Cow<'static, str>,
    },
    /// A wall that moves as a rigid body comes to another wall.
    #[error(
        "step {step}: the body `{body}` comes to wall `{wall}` at {}. A body feels grains, not walls, and would go through it. \
         Remedy: keep it away (more grains below it, `slides` or `turns` that hold it), or end the stage earlier with `stop`",
        place(.position)
    )]
    BodyAtWall {
        /// Step.
        step: u64,
        /// Name of the body, or of a wall that moves with it.
        body: String,
        /// Name of the wall.
        wall: String,
        /// Where [m].
        position: DVec3,
    },
}

/// A grain as it left the domain.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Departure {
    /// Step.
    pub step: u64,
    /// Id of the grain.
    pub id: u32,
    /// Its centre [m].
    pub position: DVec3,
    /// Its velocity [m/s].
    pub velocity: DVec3,
}

impl fmt::Display for Departure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (at, velocity) = (place(&self.position), place(&self.velocity));
        write!(
            f,
            "step {}: grain {} left the domain at {at}, moving at {velocity} m/s",
            self.step, self.id
        )
    }
}

/// Why grains leave the domain that should not.
pub(crate) const WHY_OUTSIDE: &str = "a gap in the walls, an open side, or a grain shot out by too large a time step";

fn place(p: &DVec3) -> String {
    format!("({:.6e}, {:.6e}, {:.6e})", p.x, p.y, p.z)
}

/// What other contacts displace one by: where there is no solution the last trial may be of any size.
fn displaced_by(share: f64) -> String {
    match share < 1.0 {
        true => format!("{share:.2e} of the smaller radius"),
        false => "more than a radius".to_owned(),
    }
}

impl Fault {
    /// Id of the grain at fault; 0 where it is no grain.
    pub fn grain(&self) -> u32 {
        match self {
            Self::Overlap { id, .. }
            | Self::BeyondFold { id, .. }
            | Self::BoxTooSmall { id, .. }
            | Self::CrossedTooOften { id, .. }
            | Self::Jump { id, .. }
            | Self::CannotGoOn { id, .. }
            | Self::NotFinite { id, .. } => *id,
            Self::Outside { departure, .. } => departure.id,
            Self::Custom { .. } | Self::WallNotFinite { .. } | Self::BodyAtWall { .. } => 0,
        }
    }
}

/// What it means that a grain overlaps a wall by more than its radius.
pub(crate) const SOLID_BEHIND: &str = "its centre is behind the wall, where planes, boxes and round walls are solid";

/// What is not solid behind its surface.
pub(crate) const TWO_SIDES: &str = "take rectangles, discs, a mesh or `side = \"both\"`, which have two sides";

fn why_so_deep(partner: &str, overlap_share: f64) -> String {
    if partner.starts_with("wall ") && overlap_share > 1.0 {
        return format!(
            "Cause: {SOLID_BEHIND}: it was there from the start, came round an open end, or passed through in one step. Remedy: \
             close the end, {TWO_SIDES}, or lower the speed"
        );
    }
    "Cause: the load is higher, the impact faster or the grain softer than foreseen, moving walls pinch it, or it passed \
     through a wall in one step. Remedy: raise `young_modulus` or `stiffness`, lower the speed, or raise `simulation.max_overlap` \
     (which makes the automatic time step smaller)"
        .into()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_contact_without_a_coupled_force_tells_no_number_without_meaning() {
        let told = |displacement_share| {
            let fault = Fault::BeyondFold {
                step: 0,
                id: 1,
                position: DVec3::ZERO,
                partner: "wall a".into(),
                strain: 0.02,
                displacement_share,
            };
            fault.to_string()
        };
        assert!(told(0.04).contains("displace it by 4.00e-2 of the smaller radius, and"));
        for share in [1.05e306, f64::INFINITY, f64::NAN] {
            let told = told(share);
            assert!(told.contains("displace it by more than a radius, and"), "{told}");
            assert!(told.contains("raise `young_modulus`, lower the stiffness"), "{told}");
        }
    }
}
