//! Walls across the periodic sides of a domain: one that is no longer than the box is repeated as the grains are.
//!
//! * What goes straight from side to side (a plate, a cylinder, a box open there) is lengthened: it has no seam.
//! * A mesh gets copies of its triangles. Those on both sides of a seam share their corners, so a seam is one edge among others.
//! * Of all other shapes there are images, which are asked as the shape itself.
//!
//! Grains are put back behind a periodic side only now and then, so they look for walls some way beyond it.

use super::error::WallError;
use super::mesh::Mesh;
use super::motion::{Freedom, Motion, Motions};
use super::outline;
use super::pose::Pose;
use super::shape::Side;
use super::surface::Surface;
use crate::particles::Domain;
use glam::DVec3;

/// Lengths that differ by no more than this share are the same: some roundings of single precision, in which meshes are written.
pub(super) const SAME_LENGTH: f64 = 1e-6;
/// Largest deviation of a direction from an axis along which it lies, as a cosine or a share.
const ALONG_AXIS: f64 = 1e-9;
/// How far beyond a periodic side a grain may touch a wall, as a share of the box, which is longer than four radii and two skins.
const BEYOND: f64 = 0.25;
/// How far along a periodic direction a wall may move before it lacks what it was repeated by, as a share of the box.
pub const FARTHEST: f64 = 1.0 - BEYOND;

/// How a motion changes where a wall lies along an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Drift {
    /// Not at all.
    None,
    /// It shifts the wall.
    Along,
    /// It turns the wall out of the axis, so that its images would turn about other places than their own.
    Turns,
}

impl Motions {
    /// How the motions change where a wall lies along a coordinate axis.
    pub fn drift(&self, axis: usize) -> Drift {
        let parts = self.parts.iter().map(|part| part.motion.drift(axis));
        parts.max().unwrap_or(Drift::None)
    }
}

impl Motion {
    fn drift(&self, axis: usize) -> Drift {
        let shifted = |way: &DVec3| if way[axis] == 0.0 { Drift::None } else { Drift::Along };
        let turned = |about: &DVec3| {
            if is_along(*about, axis) {
                Drift::None
            } else {
                Drift::Turns
            }
        };
        match self {
            Motion::Rest | Motion::Belt(_) | Motion::With(_) => Drift::None,
            Motion::Velocity(way) | Motion::Oscillation { amplitude: way, .. } | Motion::Servo { axis: way, .. } => {
                shifted(way)
            }
            Motion::Rotation { axis: about, .. }
            | Motion::Rocking { axis: about, .. }
            | Motion::TorqueServo { axis: about, .. } => turned(about),
            Motion::Table(table) => {
                let turn = table.axis().map_or(Drift::None, |(_, about)| turned(&about));
                let shift = if table.is_shifted(axis) {
                    Drift::Along
                } else {
                    Drift::None
                };
                turn.max(shift)
            }
            Motion::Free(free) => match &free.freedom {
                Freedom::Slide { axis: way } => shifted(way),
                Freedom::Hinge { axis: about, .. } => turned(about),
            },
            Motion::Body(body) => {
                let others = [0, 1, 2].into_iter().filter(|&other| other != axis);
                match (body.slides[axis], others.into_iter().any(|other| body.turns[other])) {
                    (_, true) => Drift::Turns,
                    (true, false) => Drift::Along,
                    (false, false) => Drift::None,
                }
            }
            Motion::Driven { axis: None } => Drift::Along,
            Motion::Driven { axis: Some((_, about)) } => turned(about),
        }
    }
}

fn is_along(direction: DVec3, axis: usize) -> bool {
    direction[axis].abs() > 1.0 - ALONG_AXIS
}

/// A surface and the axes along which it is repeated.
pub(super) struct Repeated {
    pub(super) surface: Surface,
    pub(super) axes: [bool; 3],
}

/// What grains feel of a surface in a domain, where the wall moves as told along each axis; `None` where it is as it was described.
pub(super) fn repeated(told: &Surface, domain: &Domain, drift: [Drift; 3]) -> Result<Option<Repeated>, WallError> {
    let Some((lower, upper)) = outline::bounds(told, DVec3::ZERO, &Pose::START) else {
        return Ok(None);
    };
    let (size, length) = (domain.size(), upper - lower);
    let axes = [0, 1, 2].map(|k| {
        domain.periodic[k]
            && drift[k] != Drift::Turns
            && length[k] <= size[k] * (1.0 + SAME_LENGTH)
            && lower[k] < domain.upper[k]
            && upper[k] > domain.lower[k]
            && told.ends_along(k)
    });
    if axes == [false; 3] {
        return Ok(None);
    }
    let mut surface = told.clone();
    let mut steps = axes;
    for k in (0..3).filter(|&k| axes[k] && length[k] >= size[k] * (1.0 - SAME_LENGTH)) {
        steps[k] = !surface.lengthen(k, size[k]);
    }
    let beyond = [0, 1, 2].map(|k| size[k] * if drift[k] == Drift::None { BEYOND } else { 1.0 });
    let beyond = DVec3::from_array(beyond);
    let reach = (domain.lower - beyond, domain.upper + beyond);
    let is_felt =
        |(lower, upper): (DVec3, DVec3)| (0..3).all(|k| !steps[k] || (lower[k] < reach.1[k] && upper[k] > reach.0[k]));
    let shifts = shifts(steps, size);
    let surface = match surface {
        Surface::Mesh(mesh) => {
            let mut corners: Vec<[DVec3; 3]> = mesh.triangles().iter().map(|t| t.corners()).collect();
            let own = corners.len();
            let mut copies = Vec::new();
            for &shift in &shifts {
                for triangle in 0..own {
                    let copy @ [a, b, c] = corners[triangle].map(|corner| corner + shift);
                    if is_felt((a.min(b).min(c), a.max(b).max(c))) {
                        corners.push(copy);
                        copies.push(triangle as u32);
                    }
                }
            }
            if copies.is_empty() {
                Surface::Mesh(mesh)
            } else {
                Surface::Mesh(Box::new(Mesh::with_copies(&corners, copies)?))
            }
        }
        one => {
            let images = shifts
                .into_iter()
                .filter(|&shift| is_felt((lower + shift, upper + shift)));
            let images: Vec<DVec3> = std::iter::once(DVec3::ZERO).chain(images).collect();
            if images.len() == 1 {
                one
            } else {
                Surface::Images(Box::new(one), images)
            }
        }
    };
    Ok(Some(Repeated { surface, axes }))
}

/// All steps by one box, forwards or backwards, along some axes, without the one that stays.
fn shifts(axes: [bool; 3], size: DVec3) -> Vec<DVec3> {
    let along = |k: usize| if axes[k] { &[0.0, -1.0, 1.0][..] } else { &[0.0] };
    let mut out = Vec::new();
    for x in along(0) {
        for y in along(1) {
            out.extend(along(2).iter().map(|z| DVec3::new(*x, *y, *z) * size));
        }
    }
    out.remove(0);
    out
}

impl Surface {
    /// Whether the surface ends along an axis, so that another of its kind may stand behind it: the inside of a sphere and what a closed
    /// face bounds go on for ever.
    fn ends_along(&self, axis: usize) -> bool {
        match self {
            Surface::Plane(_) => false,
            Surface::Box { faces, .. } => faces.iter().all(|(face, _)| *face as usize / 2 != axis),
            Surface::Shell(shell) => shell.side != Side::Inside,
            _ => true,
        }
    }

    /// Makes a surface longer at both of its ends along an axis, if it goes straight from one to the other.
    fn lengthen(&mut self, axis: usize, by: f64) -> bool {
        match self {
            Surface::Rectangle(plate) => {
                let Some(side) = (0..2).find(|&side| is_along(plate.axes[side], axis)) else {
                    return false;
                };
                plate.half[side] += by;
            }
            Surface::Cylinder(cylinder) if is_along(cylinder.axis, axis) => {
                cylinder.start -= cylinder.axis * by;
                cylinder.length += 2.0 * by;
            }
            Surface::Box {
                lower, upper, reach, ..
            } => {
                for low in [lower, &mut reach.0] {
                    low[axis] -= by;
                }
                for high in [upper, &mut reach.1] {
                    high[axis] += by;
                }
            }
            _ => return false,
        }
        true
    }
}
