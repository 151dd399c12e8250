//! Zones: parts of space in which grains are counted, or removed.

use super::Domain;
use glam::DVec3;
use serde::{Deserialize, Serialize};

/// Shape of a part of a zone. Sides may lie at infinity.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
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
}

impl ZoneShape {
    /// Whether a point lies in it. A point that is not finite lies nowhere.
    pub fn contains(&self, p: DVec3) -> bool {
        match *self {
            Self::Box { lower, upper } => p.cmpge(lower).all() && p.cmplt(upper).all(),
            Self::Cylinder { start, end, radius } => {
                let (axis, from) = (end - start, p - start);
                let (along, whole) = (from.dot(axis), axis.length_squared());
                along >= 0.0 && along < whole && (from - axis * (along / whole)).length_squared() < radius * radius
            }
            Self::Sphere { center, radius } => (p - center).length_squared() < radius * radius,
            Self::HalfSpace { point, normal } => (p - point).dot(normal) > 0.0,
        }
    }
}

/// A part of a zone: what lies in a shape, or what lies outside of it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct ZonePart {
    /// The shape.
    pub shape: ZoneShape,
    /// Whether the part is all but the shape.
    pub outside: bool,
}

/// Where all parts are at once; everywhere, when there is none.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Zone {
    /// The parts.
    pub parts: Vec<ZonePart>,
}

impl Zone {
    /// Whether the centre of a grain lies in the zone. Across periodic sides, a centre counts where it is in the box.
    pub fn holds(&self, domain: &Domain, centre: DVec3) -> bool {
        let p = domain.wrapped(centre);
        p.is_finite() && self.parts.iter().all(|part| part.shape.contains(p) != part.outside)
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

    fn zone(shapes: &[ZoneShape]) -> Zone {
        let part = |&shape| ZonePart { shape, outside: false };
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
            let holding = zones.iter().filter(|z| z.holds(&open_space(), dvec3(x, 1e9, 0.5)));
            assert_eq!(holding.count(), 1, "{x}");
        }
        assert!(!zones[0].holds(&open_space(), dvec3(f64::NAN, 0.0, 0.5)));
    }

    #[test]
    fn a_quarter_is_two_half_spaces_and_what_is_left_is_its_outside() {
        let half = |normal| ZoneShape::HalfSpace {
            point: DVec3::ZERO,
            normal,
        };
        let quarter = zone(&[half(DVec3::X), half(DVec3::Z)]);
        assert!(quarter.holds(&open_space(), dvec3(0.1, -5.0, 0.1)));
        assert!(!quarter.holds(&open_space(), dvec3(0.1, -5.0, -0.1)));
        assert!(!quarter.holds(&open_space(), dvec3(0.0, 0.0, 1.0)), "the plane itself");
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
        });
        assert!(ring.holds(&open_space(), dvec3(0.7, 0.0, 1.0)));
        assert!(!ring.holds(&open_space(), dvec3(0.3, 0.0, 1.0)));
        assert!(!ring.holds(&open_space(), dvec3(0.7, 0.0, 2.0)));
        assert!(ring.holds(&open_space(), dvec3(0.7, 0.0, 0.0)));
        assert!(!ring.holds(&open_space(), dvec3(0.8, 0.8, 1.0)));
        assert!(Zone::default().holds(&open_space(), dvec3(1e9, 0.0, 0.0)));
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
        assert!(left.holds(&domain, dvec3(1.1, 0.5, 0.5)));
        assert!(!left.holds(&domain, dvec3(-0.1, 0.5, 0.5)));
    }
}
