//! Which other grains may be candidates of those of one process.

use crate::comm::Single;
use crate::particles::{Grains, Row};
use glam::DVec3;
use std::ops::Range;

/// A box around grains that lie behind each other in memory, and so near each other.
#[derive(Clone, Copy, Debug)]
struct Surround {
    centre: DVec3,
    /// Half of its size, with the largest radius.
    half: DVec3,
}

impl Surround {
    fn of(rows: &[Row]) -> Self {
        let nothing = (DVec3::INFINITY, DVec3::NEG_INFINITY, 0.0f64);
        let (lower, upper, largest) = rows.iter().fold(nothing, |(lower, upper, largest), row| {
            (lower.min(row.vector), upper.max(row.vector), largest.max(row.scalar))
        });
        Self {
            centre: 0.5 * (lower + upper),
            half: 0.5 * (upper - lower) + largest,
        }
    }
}

/// Boxes around the own grains of a process; nothing where all grains are its own.
#[derive(Clone, Debug)]
pub(super) struct Surroundings {
    own: Range<usize>,
    boxes: Option<Vec<Surround>>,
    skin: f64,
}

impl Surroundings {
    /// Those of grains that lie behind each other, in boxes around so many each.
    pub(super) fn of(own: &Range<usize>, per_box: usize, grains: &Grains, skin: f64) -> Self {
        let rows = grains.position.rows();
        let is_all = own.len() == rows.len();
        let boxes = || rows[own.clone()].chunks(per_box).map(Surround::of).collect();
        Self {
            own: own.clone(),
            boxes: (!is_all).then(boxes),
            skin,
        }
    }

    /// Whether some of these grains may come nearer to touching an own one than the skin.
    pub(super) fn may_meet(&self, some: &Range<usize>, grains: &Grains, comm: &Single) -> bool {
        let Some(boxes) = &self.boxes else { return true };
        if some.start < self.own.end && self.own.start < some.end {
            return true;
        }
        let here = Surround::of(&grains.position.rows()[some.clone()]);
        let (size, periodic) = (comm.domain().size(), comm.domain().periodic);
        let slides = comm.slides();
        boxes.iter().any(|there| {
            (0..3).all(|axis| {
                let mut apart = (here.centre[axis] - there.centre[axis]).abs();
                // an image that slides may be anywhere along the flow
                if slides.is_some_and(|axes| axes.flow == axis) {
                    return true;
                }
                if periodic[axis] {
                    apart = apart.min((size[axis] - apart).abs());
                }
                // room for what rounding leaves out
                apart <= (here.half[axis] + there.half[axis] + self.skin) * (1.0 + 1e-9)
            })
        })
    }
}
