//! Planes that cut away what lies beyond them: grains show their sections.

use super::camera::{Bounds, Camera};
use glam::DVec3;

/// What is cut away: everything on one side of a plane across an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cut {
    /// 0 for x, 1 for y, 2 for z.
    pub axis: usize,
    /// Whether what is above goes, else what is below.
    pub above: bool,
    /// Where [m].
    pub at: f64,
}

impl Cut {
    /// What is kept of a box.
    pub(super) fn of_box(&self, mut bounds: Bounds) -> Bounds {
        let (low, high) = (&mut bounds.lower[self.axis], &mut bounds.upper[self.axis]);
        if self.above {
            *high = high.min(self.at);
        } else {
            *low = low.max(self.at);
        }
        bounds
    }

    /// Whether some of a sphere is kept.
    pub(crate) fn keeps_some(&self, centre: DVec3, radius: f64) -> bool {
        match self.above {
            true => centre[self.axis] - radius <= self.at,
            false => centre[self.axis] + radius >= self.at,
        }
    }
}

/// The plane of a cut in the frame of the camera: `normal . x <= offset` is kept.
#[derive(Clone, Copy, Debug)]
struct Plane {
    normal: DVec3,
    offset: f64,
}

/// The planes of all cuts in the frame of the camera.
#[derive(Clone, Debug, Default)]
pub(super) struct Planes(Vec<Plane>);

/// Where a ray enters what is kept.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Entry {
    /// Its parameter there.
    pub at: f64,
    /// Normal of the plane, where a plane is entered through.
    pub section: Option<DVec3>,
}

impl Planes {
    pub fn new(cuts: &[Cut], camera: &Camera) -> Self {
        let plane = |cut: &Cut| {
            let normal = if cut.above {
                DVec3::AXES[cut.axis]
            } else {
                -DVec3::AXES[cut.axis]
            };
            let on_plane = camera.local(cut.at * DVec3::AXES[cut.axis]);
            let normal = camera.turn(normal);
            Plane {
                normal,
                offset: normal.dot(on_plane),
            }
        };
        Self(cuts.iter().map(plane).collect())
    }

    /// Whether a point is kept.
    pub fn keep(&self, point: DVec3) -> bool {
        self.0.iter().all(|plane| plane.normal.dot(point) <= plane.offset)
    }

    /// Where a ray enters the part of a body that is kept, if it meets any of it between two of its parameters.
    pub fn enter(&self, ray: DVec3, from: f64, to: f64) -> Option<Entry> {
        let (mut entry, mut end) = (
            Entry {
                at: from,
                section: None,
            },
            to,
        );
        for plane in &self.0 {
            let steep = plane.normal.dot(ray);
            let at = plane.offset / steep;
            if steep > 0.0 {
                end = end.min(at);
            } else if steep < 0.0 && at > entry.at {
                entry = Entry {
                    at,
                    section: Some(plane.normal),
                };
            } else if steep == 0.0 && plane.offset < 0.0 {
                return None;
            }
        }
        (entry.at <= end).then_some(entry)
    }

    /// The part of a line that is kept.
    pub fn clip(&self, line: [DVec3; 2]) -> Option<[DVec3; 2]> {
        let along = line[1] - line[0];
        let (mut from, mut to) = (0.0_f64, 1.0_f64);
        for plane in &self.0 {
            let (steep, gap) = (plane.normal.dot(along), plane.offset - plane.normal.dot(line[0]));
            if steep > 0.0 {
                to = to.min(gap / steep);
            } else if steep < 0.0 {
                from = from.max(gap / steep);
            } else if gap < 0.0 {
                return None;
            }
        }
        (from < to).then(|| [from, to].map(|t| line[0] + t * along))
    }
}
