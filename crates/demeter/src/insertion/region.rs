//! Regions that grains are put into.

use super::random::RandomNumbers;
use super::spec::Region;
use crate::particles::Domain;
use glam::DVec3;
use std::f64::consts::PI;
use thiserror::Error;

/// A grain counts as inside when it stands out by no more than this share of its radius, the room that rounding needs
/// where a region is an exact multiple of the diameter.
const ROUNDING: f64 = 1e-9;
/// Largest coordinate that makes sense [m].
pub(super) const LARGEST_LENGTH: f64 = 1e12;

/// Why a region cannot be used.
#[derive(Clone, Debug, PartialEq, Error)]
#[allow(missing_docs)]
pub enum RegionError {
    #[error("region: {what} is ({}, {}, {}); coordinates must be numbers within 1e12 m", value.x, value.y, value.z)]
    Coordinate { what: &'static str, value: DVec3 },
    #[error(
        "region: the lower corner ({}, {}, {}) must be below the upper ({}, {}, {}) in every direction",
        lower.x, lower.y, lower.z, upper.x, upper.y, upper.z
    )]
    Corners { lower: DVec3, upper: DVec3 },
    #[error("region: the radius of the cylinder is {radius} m; it must be positive")]
    Radius { radius: f64 },
    #[error("region: the axis of the cylinder has no length; move its end")]
    Axis,
}

/// A checked region with what grains need to know of it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Space<'a> {
    shape: Shape,
    /// Directions in which the region spans the periodic domain: it has no sides there.
    periodic: [bool; 3],
    domain: Option<&'a Domain>,
}

#[derive(Clone, Copy, Debug)]
enum Shape {
    Box { lower: DVec3, upper: DVec3 },
    Cylinder { frame: Frame, length: f64, radius: f64 },
}

/// Start of a cylinder, unit vector along its axis and two across.
#[derive(Clone, Copy, Debug)]
struct Frame {
    start: DVec3,
    axis: DVec3,
    across: [DVec3; 2],
}

impl Frame {
    fn new(start: DVec3, axis: DVec3) -> Self {
        // The coordinate direction most across the axis; the first of equals.
        let a = axis.abs();
        let helper = if a.x <= a.y && a.x <= a.z {
            DVec3::X
        } else if a.y <= a.z {
            DVec3::Y
        } else {
            DVec3::Z
        };
        let first = axis.cross(helper).normalize();
        Self {
            start,
            axis,
            across: [first, axis.cross(first)],
        }
    }
}

impl<'a> Space<'a> {
    pub(super) fn new(region: &Region, domain: Option<&'a Domain>) -> Result<Self, RegionError> {
        let check = |what, value: DVec3| match value.abs().max_element() <= LARGEST_LENGTH && value.is_finite() {
            true => Ok(()),
            false => Err(RegionError::Coordinate { what, value }),
        };
        let shape = match *region {
            Region::Box { lower, upper } => {
                check("the lower corner", lower)?;
                check("the upper corner", upper)?;
                if !lower.cmplt(upper).all() {
                    return Err(RegionError::Corners { lower, upper });
                }
                Shape::Box { lower, upper }
            }
            Region::Cylinder { start, end, radius } => {
                check("the start of the axis", start)?;
                check("the end of the axis", end)?;
                if !(radius > 0.0 && radius <= LARGEST_LENGTH) {
                    return Err(RegionError::Radius { radius });
                }
                let length = (end - start).length();
                let axis = (end - start) / length;
                if length <= 0.0 || !axis.is_finite() {
                    return Err(RegionError::Axis);
                }
                Shape::Cylinder {
                    frame: Frame::new(start, axis),
                    length,
                    radius,
                }
            }
        };
        let mut space = Self {
            shape,
            periodic: [false; 3],
            domain,
        };
        space.periodic = space.spanned();
        space.cut_to_domain();
        Ok(space)
    }

    /// Ends the region at the periodic sides that it spans, so that no place is in it twice.
    fn cut_to_domain(&mut self) {
        let Some(domain) = self.domain else {
            return;
        };
        for k in (0..3).filter(|k| self.periodic[*k]) {
            match &mut self.shape {
                Shape::Box { lower, upper } => (lower[k], upper[k]) = (domain.lower[k], domain.upper[k]),
                Shape::Cylinder { frame, length, .. } => {
                    let is_upward = frame.axis[k] > 0.0;
                    frame.start[k] = if is_upward { domain.lower[k] } else { domain.upper[k] };
                    *length = domain.size()[k];
                }
            }
        }
    }

    /// The image of a point across periodic sides that is nearest to the middle of the region.
    fn nearest_image(&self, point: DVec3) -> DVec3 {
        let Some(domain) = self.domain else {
            return point;
        };
        let (lower, upper) = self.bounds();
        let (middle, size) = (0.5 * (lower + upper), domain.size());
        DVec3::from_array(std::array::from_fn(|k| {
            let away = point[k] - middle[k];
            match domain.periodic[k] && !self.periodic[k] && away.abs() > 0.5 * size[k] {
                true => point[k] - size[k] * (away / size[k]).round(),
                false => point[k],
            }
        }))
    }

    /// Periodic directions that the region spans from side to side.
    fn spanned(&self) -> [bool; 3] {
        let Some(domain) = self.domain else {
            return [false; 3];
        };
        let (lower, upper) = self.bounds();
        std::array::from_fn(|k| {
            let tolerance = 1e-9 * domain.size()[k];
            let reaches = lower[k] <= domain.lower[k] + tolerance && upper[k] >= domain.upper[k] - tolerance;
            let has_flat_sides = match &self.shape {
                Shape::Box { .. } => true,
                Shape::Cylinder { frame, .. } => frame.axis[k].abs() > 1.0 - 1e-12,
            };
            domain.periodic[k] && reaches && has_flat_sides
        })
    }

    pub(super) fn domain(&self) -> Option<&'a Domain> {
        self.domain
    }

    /// Whether the region goes on across periodic sides in this direction.
    pub(super) fn is_periodic(&self, axis: usize) -> bool {
        self.periodic[axis]
    }

    pub(super) fn volume(&self) -> f64 {
        match self.shape {
            Shape::Box { lower, upper } => {
                let size = upper - lower;
                size.x * size.y * size.z
            }
            Shape::Cylinder { length, radius, .. } => PI * radius * radius * length,
        }
    }

    /// Smallest box along the axes around the region.
    pub(super) fn bounds(&self) -> (DVec3, DVec3) {
        match self.shape {
            Shape::Box { lower, upper } => (lower, upper),
            Shape::Cylinder { frame, length, radius } => {
                let axis = frame.axis;
                let reach =
                    DVec3::from_array(std::array::from_fn(|k| libm::sqrt((1.0 - axis[k] * axis[k]).max(0.0)))) * radius;
                let end = frame.start + axis * length;
                (frame.start.min(end) - reach, frame.start.max(end) + reach)
            }
        }
    }

    /// Diameter of the largest grain that fits.
    pub(super) fn largest_diameter(&self) -> f64 {
        let mut largest = match self.shape {
            Shape::Box { lower, upper } => (upper - lower).min_element(),
            Shape::Cylinder { length, radius, .. } => (2.0 * radius).min(length),
        };
        if let Some(domain) = self.domain {
            // A larger grain would touch its own image.
            for k in (0..3).filter(|k| domain.periodic[*k]) {
                largest = largest.min(domain.size()[k]);
            }
        }
        largest
    }

    /// Whether a grain lies inside, up to rounding.
    pub(super) fn holds(&self, center: DVec3, radius: f64) -> bool {
        self.excess(center, radius * (1.0 - ROUNDING)) <= 0.0
    }

    /// How far a grain stands out of the region, at most 0 when it is inside.
    fn excess(&self, center: DVec3, reach: f64) -> f64 {
        let mut excess = f64::NEG_INFINITY;
        self.each_side(center, |gap, _| excess = excess.max(reach - gap));
        excess
    }

    /// Sum of the vectors that push a grain out of the sides that it overlaps, each as long as the overlap.
    pub(super) fn push(&self, center: DVec3, reach: f64) -> DVec3 {
        let mut push = DVec3::ZERO;
        self.each_side(center, |gap, inward| {
            if gap < reach {
                push += inward * (reach - gap);
            }
        });
        push
    }

    /// Calls back with the distance to each side (negative outside) and its inward unit normal.
    fn each_side(&self, center: DVec3, mut side: impl FnMut(f64, DVec3)) {
        let center = self.nearest_image(center);
        match &self.shape {
            Shape::Box { lower, upper } => {
                for k in (0..3).filter(|k| !self.periodic[*k]) {
                    side(center[k] - lower[k], DVec3::AXES[k]);
                    side(upper[k] - center[k], -DVec3::AXES[k]);
                }
            }
            Shape::Cylinder { frame, length, radius } => {
                let from_start = center - frame.start;
                let along = from_start.dot(frame.axis);
                if !self.periodic.contains(&true) {
                    side(along, frame.axis);
                    side(length - along, -frame.axis);
                }
                let outward = from_start - frame.axis * along;
                let distance = outward.length();
                let inward = if distance > 0.0 {
                    -outward / distance
                } else {
                    frame.across[0]
                };
                side(radius - distance, inward);
            }
        }
    }

    /// A place of a grain of this radius, uniform over all that are inside.
    pub(super) fn random_place(&self, radius: f64, random: &mut RandomNumbers) -> DVec3 {
        match &self.shape {
            Shape::Box { lower, upper } => self.wrap(DVec3::from_array(std::array::from_fn(|k| {
                let margin = if self.periodic[k] { 0.0 } else { radius };
                let room = (upper[k] - lower[k] - 2.0 * margin).max(0.0);
                lower[k] + margin + random.uniform() * room
            }))),
            Shape::Cylinder {
                frame,
                length,
                radius: outer,
            } => {
                let margin = if self.periodic.contains(&true) { 0.0 } else { radius };
                let along = margin + random.uniform() * (length - 2.0 * margin).max(0.0);
                let distance = (outer - radius).max(0.0) * libm::sqrt(random.uniform());
                let (sine, cosine) = libm::sincos(2.0 * PI * random.uniform());
                let place = frame.start
                    + frame.axis * along
                    + frame.across[0] * (distance * cosine)
                    + frame.across[1] * (distance * sine);
                self.wrap(place)
            }
        }
    }

    /// Puts a point back into the periodic box.
    pub(super) fn wrap(&self, p: DVec3) -> DVec3 {
        self.domain.map_or(p, |domain| domain.brought_back(p))
    }

    /// Moves a grain that stands out by no more than rounding of its radius wholly inside, where sides are flat.
    pub(super) fn settle(&self, center: DVec3, radius: f64) -> DVec3 {
        match &self.shape {
            Shape::Box { lower, upper } => self.wrap(DVec3::from_array(std::array::from_fn(|k| {
                let center = self.nearest_image(center);
                let (least, most) = (lower[k] + radius, upper[k] - radius);
                if self.periodic[k] || least > most {
                    center[k]
                } else {
                    center[k].clamp(least, most)
                }
            }))),
            Shape::Cylinder { .. } => center,
        }
    }
}
