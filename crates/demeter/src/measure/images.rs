//! Images of what is measured, across periodic sides.

use crate::simulation::Simulation;
use glam::DVec3;

/// Most periods that an image is looked for beyond what is measured.
const MOST_PERIODS: f64 = 100.0;

/// How the world repeats itself: what leads to the next image along each direction [m], and how fast that changes [m/s].
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Periods {
    pub edges: [Option<DVec3>; 3],
    pub velocities: [DVec3; 3],
}

/// A box, by its lower and its upper corner [m].
pub(super) type Corners = (DVec3, DVec3);

/// The box around a sphere.
pub(super) fn around(centre: DVec3, radius: f64) -> Corners {
    (centre - radius, centre + radius)
}

/// A box around a cylinder.
pub(super) fn around_cylinder(start: DVec3, end: DVec3, radius: f64) -> Corners {
    (start.min(end) - radius, start.max(end) + radius)
}

impl Periods {
    /// How the world of a simulation repeats itself.
    pub fn of(sim: &Simulation) -> Self {
        Periods {
            edges: [0, 1, 2].map(|axis| sim.domain().periodic[axis].then(|| sim.comm.edge(axis))),
            velocities: [0, 1, 2].map(|axis| sim.comm.edge_velocity(axis)),
        }
    }

    /// Whether an image of a box meets another one.
    pub fn any_meets(&self, one: Corners, other: Corners) -> bool {
        let mut meets = false;
        self.each_image(one, other, &mut |_, _| meets = true);
        meets
    }

    /// Visits all images of a box that meet another one: the shift to each [m], and how much faster it moves [m/s].
    pub fn each_image(&self, one: Corners, other: Corners, visit: &mut dyn FnMut(DVec3, DVec3)) {
        // an edge that is not along its axis moves images along others, so it comes first
        let is_oblique = |axis: usize| self.edges[axis].is_some_and(|edge| edge[axis].abs() < edge.length());
        let mut order = [0, 1, 2];
        order.sort_by_key(|&axis| !is_oblique(axis));
        self.along(&order, (DVec3::ZERO, DVec3::ZERO), (one, other), visit);
    }

    fn along(
        &self,
        axes: &[usize],
        (shift, velocity): (DVec3, DVec3),
        (one, other): (Corners, Corners),
        visit: &mut dyn FnMut(DVec3, DVec3),
    ) {
        let Some((&axis, rest)) = axes.split_first() else {
            return visit(shift, velocity);
        };
        let (low, high) = (one.0[axis] + shift[axis], one.1[axis] + shift[axis]);
        let Some(edge) = self.edges[axis] else {
            if low <= other.1[axis] && high >= other.0[axis] {
                self.along(rest, (shift, velocity), (one, other), visit);
            }
            return;
        };
        let first = ((other.0[axis] - high) / edge[axis]).ceil();
        let last = ((other.1[axis] - low) / edge[axis]).floor();
        let mut n = first.max(-MOST_PERIODS);
        while n <= last.min(MOST_PERIODS) {
            let image = (shift + edge * n, velocity + self.velocities[axis] * n);
            self.along(rest, image, (one, other), visit);
            n += 1.0;
        }
    }
}
