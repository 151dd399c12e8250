//! Zones: parts of space in which grains are counted, or removed.

use super::{Domain, Interior};
use glam::DVec3;
use std::sync::Arc;

/// Shape of a part of a zone. Sides may lie at infinity.
#[derive(Clone, Debug, PartialEq)]
pub enum ZoneShape {
    /// `lower <= p < upper` in every direction, so that zones side by side share no grain.
    Box {
        /// Lower corner [m].
        lower: DVec3,
        /// Upper corner [m].
        upper: DVec3,
    },
    /// Between the ends (the start belongs to it) and nearer to the axis than the radius.
    Cylinder {
        /// Start of the axis [m].
        start: DVec3,
        /// End of the axis [m].
        end: DVec3,
        /// Radius [m].
        radius: f64,
    },
    /// Nearer to the centre than the radius.
    Sphere {
        /// Centre [m].
        center: DVec3,
        /// Radius [m].
        radius: f64,
    },
    /// Beyond a plane, on the side of its normal; not the plane itself.
    HalfSpace {
        /// A point of the plane [m].
        point: DVec3,
        /// Unit vector into the half-space.
        normal: DVec3,
    },
    /// Between the ends (the start belongs to it) of a cone, whole or cut, and nearer to the axis than the radius there.
    Cone {
        /// Start of the axis [m].
        start: DVec3,
        /// End of the axis [m].
        end: DVec3,
        /// Radius at the start [m].
        start_radius: f64,
        /// Radius at the end [m].
        end_radius: f64,
    },
    /// Inside of a closed mesh.
    Mesh(Arc<Interior>),
}

impl ZoneShape {
    /// Whether a point lies in it. A point that is not finite lies nowhere.
    pub fn contains(&self, p: DVec3) -> bool {
        match self {
            &Self::Box { lower, upper } => p.cmpge(lower).all() && p.cmplt(upper).all(),
            &Self::Cylinder { start, end, radius } => in_cone(p, [start, end], [radius; 2]),
            &Self::Sphere { center, radius } => (p - center).length_squared() < radius * radius,
            &Self::HalfSpace { point, normal } => (p - point).dot(normal) > 0.0,
            &Self::Cone {
                start,
                end,
                start_radius,
                end_radius,
            } => in_cone(p, [start, end], [start_radius, end_radius]),
            Self::Mesh(interior) => interior.contains(p),
        }
    }
}

/// Whether a point lies between two ends of an axis and nearer to it than the radius there.
fn in_cone(p: DVec3, [start, end]: [DVec3; 2], [at_start, at_end]: [f64; 2]) -> bool {
    let (axis, from) = (end - start, p - start);
    let (along, whole) = (from.dot(axis), axis.length_squared());
    let share = along / whole;
    let radius = at_start + share * (at_end - at_start);
    along >= 0.0 && along < whole && (from - axis * share).length_squared() < radius * radius
}

/// A part of a zone: what lies in a shape, or what lies outside of it.
#[derive(Clone, Debug, PartialEq)]
pub struct ZonePart {
    /// The shape.
    pub shape: ZoneShape,
    /// Whether the part is all but the shape.
    pub outside: bool,
    /// Index of the wall that carries the part; told where the wall stands at the start.
    pub wall: Option<usize>,
}

/// Where all parts are at once; everywhere, when there is none.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Zone {
    /// The parts.
    pub parts: Vec<ZonePart>,
}

impl Zone {
    /// Whether the centre of a grain lies in the zone. Across periodic sides, a centre counts where it is in the box.
    /// `brought_back` tells where a point that goes with a wall would be if the wall stood where it was at the start.
    pub fn holds(&self, domain: &Domain, centre: DVec3, brought_back: impl Fn(usize, DVec3) -> DVec3) -> bool {
        let here = domain.wrapped(centre);
        let is_in = |part: &ZonePart| {
            let p = part.wall.map_or(here, |wall| brought_back(wall, here));
            part.shape.contains(p) != part.outside
        };
        here.is_finite() && self.parts.iter().all(is_in)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::particles::Outside;
    use glam::dvec3;

    fn open_space() -> Domain {
        Domain {
            lower: DVec3::NEG_INFINITY,
            upper: DVec3::INFINITY,
            periodic: [false; 3],
            outside: Outside::Stop,
        }
    }

    fn at_rest(_: usize, p: DVec3) -> DVec3 {
        p
    }

    fn zone(shapes: &[ZoneShape]) -> Zone {
        let part = |shape: &ZoneShape| ZonePart {
            shape: shape.clone(),
            outside: false,
            wall: None,
        };
        Zone {
            parts: shapes.iter().map(part).collect(),
        }
    }

    #[test]
    fn boxes_side_by_side_share_no_point_and_leave_none_out() {
        let cut = |from: f64, to: f64| {
            zone(&[ZoneShape::Box {
                lower: dvec3(from, f64::NEG_INFINITY, 0.0),
                upper: dvec3(to, f64::INFINITY, 1.0),
            }])
        };
        let zones = [cut(f64::NEG_INFINITY, 0.0), cut(0.0, 0.5), cut(0.5, f64::INFINITY)];
        for x in [-7.0, -1e-300, 0.0, 0.25, 0.5, 9.0] {
            let holding = zones
                .iter()
                .filter(|z| z.holds(&open_space(), dvec3(x, 1e9, 0.5), at_rest));
            assert_eq!(holding.count(), 1, "{x}");
        }
        assert!(!zones[0].holds(&open_space(), dvec3(f64::NAN, 0.0, 0.5), at_rest));
    }

    #[test]
    fn a_quarter_is_two_half_spaces_and_what_is_left_is_its_outside() {
        let half = |normal| ZoneShape::HalfSpace {
            point: DVec3::ZERO,
            normal,
        };
        let quarter = zone(&[half(DVec3::X), half(DVec3::Z)]);
        assert!(quarter.holds(&open_space(), dvec3(0.1, -5.0, 0.1), at_rest));
        assert!(!quarter.holds(&open_space(), dvec3(0.1, -5.0, -0.1), at_rest));
        assert!(
            !quarter.holds(&open_space(), dvec3(0.0, 0.0, 1.0), at_rest),
            "the plane itself"
        );
        let mut ring = zone(&[ZoneShape::Cylinder {
            start: DVec3::ZERO,
            end: dvec3(0.0, 0.0, 2.0),
            radius: 1.0,
        }]);
        ring.parts.push(ZonePart {
            shape: ZoneShape::Sphere {
                center: dvec3(0.0, 0.0, 1.0),
                radius: 0.5,
            },
            outside: true,
            wall: None,
        });
        assert!(ring.holds(&open_space(), dvec3(0.7, 0.0, 1.0), at_rest));
        assert!(!ring.holds(&open_space(), dvec3(0.3, 0.0, 1.0), at_rest));
        assert!(!ring.holds(&open_space(), dvec3(0.7, 0.0, 2.0), at_rest));
        assert!(ring.holds(&open_space(), dvec3(0.7, 0.0, 0.0), at_rest));
        assert!(!ring.holds(&open_space(), dvec3(0.8, 0.8, 1.0), at_rest));
        assert!(Zone::default().holds(&open_space(), dvec3(1e9, 0.0, 0.0), at_rest));
    }

    #[test]
    fn a_centre_beyond_a_periodic_side_counts_where_it_is_in_the_box() {
        let domain = Domain {
            lower: DVec3::ZERO,
            upper: DVec3::ONE,
            periodic: [true, false, false],
            outside: Outside::Stop,
        };
        let left = zone(&[ZoneShape::Box {
            lower: DVec3::NEG_INFINITY,
            upper: dvec3(0.5, 1.0, 1.0),
        }]);
        assert!(left.holds(&domain, dvec3(1.1, 0.5, 0.5), at_rest));
        assert!(!left.holds(&domain, dvec3(-0.1, 0.5, 0.5), at_rest));
    }

    #[test]
    fn a_cone_is_as_wide_as_told_and_a_part_goes_with_its_wall() {
        let mut hopper = zone(&[ZoneShape::Cone {
            start: DVec3::ZERO,
            end: dvec3(0.0, 0.0, 2.0),
            start_radius: 0.5,
            end_radius: 1.5,
        }]);
        for (r, z, inside) in [
            (0.49, 0.0, true),
            (0.51, 0.0, false),
            (0.99, 1.0, true),
            (1.01, 1.0, false),
        ] {
            assert_eq!(hopper.holds(&open_space(), dvec3(0.0, r, z), at_rest), inside);
        }
        assert!(!hopper.holds(&open_space(), dvec3(0.0, 0.0, 2.0), at_rest), "the end");
        hopper.parts[0].wall = Some(3);
        let moved = |wall: usize, p: DVec3| p - DVec3::X * wall as f64;
        assert!(hopper.holds(&open_space(), dvec3(3.2, 0.0, 1.0), moved));
        assert!(!hopper.holds(&open_space(), dvec3(0.2, 0.0, 1.0), moved));
    }
}
