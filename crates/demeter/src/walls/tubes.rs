//! Cylinders and cones that hold grains: between its ends each is solid behind its side.

use super::surface::Surface;
use super::{Side, Wall};
use glam::DVec3;

/// Tubes among walls, those that are present.
pub(crate) struct Tubes<'w>(Vec<&'w Wall>);

impl<'w> Tubes<'w> {
    pub(crate) fn among(walls: &'w [Wall]) -> Self {
        let tubes = walls
            .iter()
            .filter(|wall| wall.is_present() && wall.surface().is_tube());
        Self(tubes.collect())
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Those in which one of some places is.
    pub(crate) fn that_hold_some(mut self, places: &[DVec3]) -> Self {
        let holds = |tube: &&Wall| {
            places
                .iter()
                .any(|&place| tube.beyond_side(place).is_some_and(|way| way <= 0.0))
        };
        self.0.retain(holds);
        self
    }

    /// Whether a place is behind the side of one, and within none: tubes may stand side by side.
    pub(crate) fn are_behind(&self, place: DVec3) -> bool {
        let mut beyond = self.0.iter().filter_map(|tube| tube.beyond_side(place)).peekable();
        beyond.peek().is_some() && beyond.all(|way| way > 0.0)
    }

    pub(crate) fn iter(&self) -> impl Iterator<Item = &'w Wall> {
        self.0.iter().copied()
    }
}

impl Wall {
    /// How far a place is beyond the side of a tube, between its ends; negative within [m].
    pub(crate) fn beyond_side(&self, place: DVec3) -> Option<f64> {
        self.surface().beyond_side(self.brought_back(place))
    }
}

impl Surface {
    fn is_tube(&self) -> bool {
        match self {
            Self::Images(one, _) => one.is_tube(),
            Self::Cylinder(cylinder) => cylinder.side == Side::Inside,
            Self::Cone(cone) => cone.side == Side::Inside,
            _ => false,
        }
    }

    fn beyond_side(&self, point: DVec3) -> Option<f64> {
        let (start, axis, length, radii) = match self {
            Self::Images(one, shifts) => {
                let of_images = shifts.iter().filter_map(|&shift| one.beyond_side(point - shift));
                return of_images.reduce(f64::min);
            }
            Self::Cylinder(cylinder) => (cylinder.start, cylinder.axis, cylinder.length, [cylinder.radius; 2]),
            Self::Cone(cone) => (cone.start, cone.axis, cone.length, [cone.start_radius, cone.end_radius]),
            _ => return None,
        };
        let arm = point - start;
        let height = arm.dot(axis);
        let radius = radii[0] + (radii[1] - radii[0]) * (height / length);
        let is_between_ends = (0.0..=length).contains(&height);
        is_between_ends.then(|| (arm - axis * height).length() - radius)
    }
}
