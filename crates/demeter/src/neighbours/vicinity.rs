//! What a process knows of the grains of others: boxes around all of them, and the places of those near its own.
//!
//! A search of own grains must find in the cells that it looks at all that one process finds there: then it finds the same
//! candidates, and tries as many. So others are told of that may be in such a cell, though they may be too far to touch.

use super::cells::{Frame, Grid, grids};
use super::classes::SizeClasses;
use super::crowd::Extent;
use crate::comm::Single;
use crate::particles::Row;
use glam::DVec3;
use serde::{Deserialize, Serialize};
use std::ops::Range;

/// Numbers of a box.
pub(crate) const CORNERS: usize = 6;

/// A box around places, in numbers that round to the outside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct SmallBox {
    lower: [f32; 3],
    upper: [f32; 3],
}

impl SmallBox {
    const NOTHING: Self = Self {
        lower: [f32::INFINITY; 3],
        upper: [f32::NEG_INFINITY; 3],
    };

    pub(crate) fn of_numbers(numbers: &[f32; CORNERS]) -> Self {
        let [a, b, c, d, e, f] = *numbers;
        Self {
            lower: [a, b, c],
            upper: [d, e, f],
        }
    }

    pub(crate) fn numbers(&self) -> impl Iterator<Item = f32> {
        self.lower.into_iter().chain(self.upper)
    }

    fn add(&mut self, place: DVec3) {
        for axis in 0..3 {
            let x = place[axis] as f32;
            self.lower[axis] = self.lower[axis].min(x.next_down());
            self.upper[axis] = self.upper[axis].max(x.next_up());
        }
    }

    fn join(&mut self, other: &Self) {
        for axis in 0..3 {
            self.lower[axis] = self.lower[axis].min(other.lower[axis]);
            self.upper[axis] = self.upper[axis].max(other.upper[axis]);
        }
    }
}

/// The smallest box around places [m].
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
#[repr(C)]
pub(crate) struct Bounds {
    pub(crate) lower: DVec3,
    pub(crate) upper: DVec3,
}

impl Bounds {
    pub(crate) const NOTHING: Self = Self {
        lower: DVec3::INFINITY,
        upper: DVec3::NEG_INFINITY,
    };

    /// Around the centres of grains.
    pub(crate) fn of_centres(rows: &[Row]) -> Self {
        rows.iter().fold(Self::NOTHING, |all, row| {
            all.join(Self {
                lower: row.vector,
                upper: row.vector,
            })
        })
    }

    /// Around whole grains.
    pub(crate) fn of_grains(rows: &[Row]) -> Self {
        rows.iter().fold(Self::NOTHING, |all, row| {
            all.join(Self {
                lower: row.vector - row.scalar,
                upper: row.vector + row.scalar,
            })
        })
    }

    pub(crate) fn join(self, other: Self) -> Self {
        Self {
            lower: self.lower.min(other.lower),
            upper: self.upper.max(other.upper),
        }
    }
}

/// Boxes around the grains of a segment, or of several: one of each size class that is among them.
#[derive(Clone, Debug, Default)]
pub(crate) struct BoxesOfClasses(Vec<(u8, SmallBox)>);

impl BoxesOfClasses {
    /// Around grains, some of each class that has a bit in `among`.
    pub(crate) fn around(rows: &[Row], among: u32, classes: &SizeClasses) -> Self {
        let mut boxes = Self::of_numbers(among, &[]);
        for row in rows {
            let class = classes.of(row.scalar) as u8;
            if let Some((_, around)) = boxes.0.iter_mut().find(|(of, _)| *of == class) {
                around.add(row.vector);
            }
        }
        boxes
    }

    /// Those that were told as numbers, by rising classes.
    pub(crate) fn of_numbers(among: u32, numbers: &[[f32; CORNERS]]) -> Self {
        let classes = (0..u32::BITS as u8).filter(|class| among >> class & 1 == 1);
        let mut numbers = numbers.iter().map(SmallBox::of_numbers);
        Self(
            classes
                .map(|class| (class, numbers.next().unwrap_or(SmallBox::NOTHING)))
                .collect(),
        )
    }

    pub(crate) fn numbers(&self) -> impl Iterator<Item = f32> + '_ {
        self.0.iter().flat_map(|(_, around)| around.numbers())
    }

    /// Grows to hold others.
    pub(crate) fn join(&mut self, others: &Self) {
        for (class, around) in &others.0 {
            match self.0.iter_mut().find(|(of, _)| of == class) {
                Some((_, own)) => own.join(around),
                None => self.0.push((*class, *around)),
            }
        }
    }
}

/// Who is in cells that the search of another looks at.
#[derive(Debug)]
pub(crate) struct Reach {
    frame: Frame,
    grids: Vec<Grid>,
    skin: f64,
    /// What leads to images that slide, besides none.
    slides: Option<DVec3>,
}

impl Reach {
    /// For all grains, told by their classes and where they are, and a search of all pairs closer than `skin` to touching.
    pub(crate) fn new(classes: &SizeClasses, extent: Extent, comm: &Single, skin: f64) -> Self {
        let frame = Frame::of(extent, comm);
        Self {
            grids: grids(classes, &frame, skin),
            frame,
            skin,
            slides: comm.slides().map(|axes| comm.edge(axes.gradient)),
        }
    }

    /// Whether a grain in one of these boxes may look at a cell with one in those: the same from both sides.
    pub(crate) fn joins(&self, these: &BoxesOfClasses, those: &BoxesOfClasses) -> bool {
        these.0.iter().any(|a| those.0.iter().any(|b| self.joins_classes(a, b)))
    }

    fn joins_classes(&self, (class, a): &(u8, SmallBox), (other, b): &(u8, SmallBox)) -> bool {
        let (own, others) = (&self.grids[usize::from(*class)], &self.grids[usize::from(*other)]);
        // grains of a class look one cell far; into other grids as far as they reach, and to the ends of the cells there
        let margin = if class == other {
            2.0 * own.edge
        } else {
            DVec3::splat(own.largest + others.largest + self.skin) + own.edge.max(others.edge)
        };
        let corners = |corner: [f32; 3]| self.frame.drawn_in(DVec3::from_array(corner.map(f64::from)));
        let (a_lower, a_upper) = (corners(a.lower), corners(a.upper));
        let (b_lower, b_upper) = (corners(b.lower), corners(b.upper));
        let apart = 0.5 * ((a_lower + a_upper) - (b_lower + b_upper));
        let reach = 0.5 * ((a_upper - a_lower) + (b_upper - b_lower)) + margin;
        // room for what rounding leaves out
        let reach = reach * (1.0 + 1e-6) + 2.0 * self.frame.slack;
        let joins = |apart: DVec3| {
            (0..3).all(|axis| {
                let mut apart = apart[axis];
                if self.frame.periodic[axis] {
                    apart -= self.frame.size[axis] * (apart / self.frame.size[axis]).round();
                }
                apart.abs() <= reach[axis]
            })
        };
        joins(apart)
            || self
                .slides
                .is_some_and(|edge| joins(apart + edge) || joins(apart - edge))
    }
}

/// What a process knows of all grains, when it looks for the candidates of its own.
#[derive(Debug)]
pub(crate) struct Vicinity {
    pub(crate) classes: SizeClasses,
    /// Where all grains are.
    pub(crate) extent: Extent,
    /// Around all grains.
    pub(crate) surfaces: Bounds,
    /// Stretches of grains whose places are known, own ones among them, by rising indices.
    pub(crate) known: Vec<Range<usize>>,
}

impl Vicinity {
    /// Whether the places of all of these grains are known.
    pub(super) fn knows(&self, grains: &Range<usize>) -> bool {
        let at = self.known.partition_point(|known| known.end < grains.end);
        self.known.get(at).is_some_and(|known| known.start <= grains.start)
    }
}
