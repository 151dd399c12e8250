//! The region in which grains may be.

use glam::DVec3;
use serde::{Deserialize, Serialize};

/// What happens to a grain that leaves the domain.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Outside {
    /// The run stops and names the grain.
    Stop,
    /// The grain is removed and booked.
    Remove,
}

/// The domain: a box, periodic in some directions.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Domain {
    /// Lower corner [m].
    pub lower: DVec3,
    /// Upper corner [m].
    pub upper: DVec3,
    /// Periodic directions.
    pub periodic: [bool; 3],
    /// What happens to a grain that leaves through a side that is not periodic.
    pub outside: Outside,
}

impl Domain {
    /// Edge lengths [m].
    pub fn size(&self) -> DVec3 {
        self.upper - self.lower
    }

    /// Shortest difference vector of two points, `a - b`, across periodic sides. The shift is applied to the
    /// difference, so that it is the same bits for both partners up to the sign.
    #[inline(always)]
    pub fn difference(&self, a: DVec3, b: DVec3) -> DVec3 {
        let mut d = a - b;
        let size = self.size();
        for axis in 0..3 {
            if self.periodic[axis] {
                if d[axis] > 0.5 * size[axis] {
                    d[axis] -= size[axis];
                } else if d[axis] < -0.5 * size[axis] {
                    d[axis] += size[axis];
                }
            }
        }
        d
    }

    /// A point with its coordinates in periodic directions put back into the box, across one side at most.
    pub fn wrapped(&self, p: DVec3) -> DVec3 {
        let (mut p, size) = (p, self.size());
        for axis in (0..3).filter(|&k| self.periodic[k]) {
            if p[axis] >= self.upper[axis] {
                p[axis] -= size[axis];
            } else if p[axis] < self.lower[axis] {
                p[axis] += size[axis];
            }
        }
        p
    }

    /// A point with its coordinates in periodic directions put back into the box, from however far away.
    pub fn brought_back(&self, p: DVec3) -> DVec3 {
        DVec3::from_array([0, 1, 2].map(|k| match self.periodic[k] {
            true => wrap_coordinate(p[k], self.lower[k], self.upper[k]),
            false => p[k],
        }))
    }

    /// Whether a point lies inside. Beyond a periodic side it does, too, up to one box: a grain is put back whenever the
    /// candidates are found, so farther away it was thrown by one step over more than a box. A point that is not finite
    /// lies nowhere.
    pub fn contains(&self, p: DVec3) -> bool {
        let (lower, upper) = self.allowed();
        (0..3).all(|k| p[k] >= lower[k] && p[k] <= upper[k])
    }

    /// Lowest and highest places that [`Domain::contains`] allows.
    pub fn allowed(&self) -> (DVec3, DVec3) {
        let size = self.size();
        let slack = DVec3::from_array([0, 1, 2].map(|k| if self.periodic[k] { size[k] } else { 0.0 }));
        (self.lower - slack, self.upper + slack)
    }
}

/// Puts a coordinate into `[lower, upper)` by whole lengths.
fn wrap_coordinate(x: f64, lower: f64, upper: f64) -> f64 {
    if x >= lower && x < upper {
        return x;
    }
    let size = upper - lower;
    let wrapped = x - size * ((x - lower) / size).floor();
    if wrapped >= lower && wrapped < upper {
        wrapped
    } else {
        lower
    }
}
