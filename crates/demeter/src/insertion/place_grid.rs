//! Which grains are near a place: one cell grid per size class, so that any width of sizes stays linear.

use crate::neighbours::{Bounds, Counts, are_scattered, crowd};
use crate::particles::Domain;
use glam::DVec3;
use std::ops::ControlFlow;

/// End of a list of grains.
const NONE: u32 = u32::MAX;
/// Size classes; each holds radii within a factor of 2, the last all smaller ones.
const CLASSES: usize = 24;

/// A grain found near a place.
#[derive(Clone, Copy, Debug)]
pub(super) struct Near {
    /// Index of the grain.
    pub(super) index: usize,
    /// From the grain to the place.
    pub(super) difference: DVec3,
    /// Its radius.
    pub(super) radius: f64,
}

/// Cells of grains of one size class.
struct Class {
    largest_radius: f64,
    cell: DVec3,
    counts: [usize; 3],
    heads: Vec<u32>,
}

/// Grains in cells. Grains are visited in an order that depends on the order of adding only.
pub(super) struct PlaceGrid<'a> {
    domain: Option<&'a Domain>,
    lower: DVec3,
    classes: Vec<Class>,
    class_of: Vec<u8>,
    next: Vec<u32>,
    places: Vec<DVec3>,
    radii: Vec<f64>,
}

fn class_of(radius: f64, largest: f64) -> usize {
    let mut class = 0;
    let mut limit = 0.5 * largest;
    while radius <= limit && class + 1 < CLASSES {
        limit *= 0.5;
        class += 1;
    }
    class
}

impl<'a> PlaceGrid<'a> {
    /// A grid for grains with these radii (in any order) in the box from `lower` to `upper`; in periodic directions
    /// the domain's box counts. Grains outside the box are found too.
    pub(super) fn new(
        domain: Option<&'a Domain>,
        lower: DVec3,
        upper: DVec3,
        radii: impl Iterator<Item = f64> + Clone,
    ) -> Self {
        let (mut lower, mut upper) = (lower, upper);
        if let Some(domain) = domain {
            for k in (0..3).filter(|k| domain.periodic[*k]) {
                (lower[k], upper[k]) = (domain.lower[k], domain.upper[k]);
            }
        }
        let largest = radii.clone().fold(0.0, f64::max);
        let mut numbers = [0usize; CLASSES];
        let mut largest_of = [0.0f64; CLASSES];
        for radius in radii {
            let class = class_of(radius, largest);
            numbers[class] += 1;
            largest_of[class] = largest_of[class].max(radius);
        }
        let used = numbers.iter().rposition(|n| *n > 0).map_or(0, |k| k + 1);
        let total: usize = numbers.iter().sum();
        let classes = (0..used)
            .map(|k| Class::new(upper - lower, largest_of[k], numbers[k]))
            .collect();
        Self {
            domain,
            lower,
            classes,
            class_of: Vec::with_capacity(total),
            next: Vec::with_capacity(total),
            places: Vec::with_capacity(total),
            radii: Vec::with_capacity(total),
        }
    }

    /// A grid that holds these grains; its box is the smallest around nearly all of them.
    pub(super) fn holding(domain: Option<&'a Domain>, grains: &[(DVec3, f64)]) -> Self {
        let (mut lower, mut upper) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        for (place, _) in grains {
            (lower, upper) = (lower.min(*place), upper.max(*place));
        }
        if grains.is_empty() {
            (lower, upper) = (DVec3::ZERO, DVec3::ZERO);
        }
        let mean = 2.0 * grains.iter().map(|(_, radius)| radius).sum::<f64>() / grains.len() as f64;
        if are_scattered(upper - lower, mean, grains.len()) {
            let counts = |within| Counts::of(grains.iter().map(|(place, _)| *place), within);
            Bounds { lower, upper } = crowd(Bounds { lower, upper }, grains.len(), counts);
        }
        let mut grid = Self::new(domain, lower, upper, grains.iter().map(|g| g.1));
        for (place, radius) in grains {
            grid.add(*place, *radius);
        }
        grid
    }

    /// Adds a grain; its radius must be among those told to [`PlaceGrid::new`].
    pub(super) fn add(&mut self, place: DVec3, radius: f64) {
        let place = self.wrap(place);
        let largest = self.classes.first().map_or(0.0, |c| c.largest_radius);
        let k = class_of(radius, largest).min(self.classes.len().saturating_sub(1));
        let Some(class) = self.classes.get_mut(k) else {
            return;
        };
        let index = self.places.len() as u32;
        let cell = class.flat(class.cell_of(place - self.lower));
        self.next.push(std::mem::replace(&mut class.heads[cell], index));
        self.class_of.push(k as u8);
        self.places.push(place);
        self.radii.push(radius);
    }

    fn wrap(&self, place: DVec3) -> DVec3 {
        self.domain.map_or(place, |domain| domain.brought_back(place))
    }

    /// Visits every grain whose surface may be closer than `reach` to the place. Some are farther away.
    pub(super) fn visit<B>(&self, place: DVec3, reach: f64, mut near: impl FnMut(Near) -> ControlFlow<B>) -> Option<B> {
        let place = self.wrap(place);
        for class in &self.classes {
            if let ControlFlow::Break(b) = self.visit_class(class, place, reach, &mut near) {
                return Some(b);
            }
        }
        None
    }

    /// Visits the partners of a grain of the grid whose surface may be closer than `skin`: every pair is visited from
    /// one side only.
    pub(super) fn visit_partners<B>(
        &self,
        index: usize,
        skin: f64,
        mut near: impl FnMut(Near) -> ControlFlow<B>,
    ) -> Option<B> {
        let own = usize::from(self.class_of[index]);
        let reach = self.radii[index] + skin;
        for (k, class) in self.classes.iter().enumerate().take(own + 1) {
            let visited = self.visit_class(class, self.places[index], reach, &mut |found: Near| match k < own
                || found.index < index
            {
                true => near(found),
                false => ControlFlow::Continue(()),
            });
            if let ControlFlow::Break(b) = visited {
                return Some(b);
            }
        }
        None
    }

    fn visit_class<B>(
        &self,
        class: &Class,
        place: DVec3,
        reach: f64,
        near: &mut impl FnMut(Near) -> ControlFlow<B>,
    ) -> ControlFlow<B> {
        let [xs, ys, zs] = self.ranges(class, place, reach + class.largest_radius);
        // ranges go on from the first cell at most once
        let within = |x: usize, n: usize| if x < n { x } else { x - n };
        let [nx, ny, nz] = class.counts;
        for z in zs {
            for y in ys.clone() {
                let row = (within(z, nz) * ny + within(y, ny)) * nx;
                for x in xs.clone() {
                    let mut index = class.heads[row + within(x, nx)];
                    while index != NONE {
                        let i = index as usize;
                        let difference = match self.domain {
                            Some(domain) => domain.difference(place, self.places[i]),
                            None => place - self.places[i],
                        };
                        near(Near {
                            index: i,
                            difference,
                            radius: self.radii[i],
                        })?;
                        index = self.next[i];
                    }
                }
            }
        }
        ControlFlow::Continue(())
    }

    /// Cells within a distance in each direction; beyond the last cell they go on from the first.
    fn ranges(&self, class: &Class, place: DVec3, distance: f64) -> [std::ops::RangeInclusive<usize>; 3] {
        let p = place - self.lower;
        std::array::from_fn(|k| {
            let n = class.counts[k];
            let periodic = self.domain.is_some_and(|d| d.periodic[k]);
            if !periodic {
                return class.index(p[k] - distance, k)..=class.index(p[k] + distance, k);
            }
            let low = ((p[k] - distance) / class.cell[k]).floor();
            let high = ((p[k] + distance) / class.cell[k]).floor();
            if high - low + 1.0 >= n as f64 {
                return 0..=n - 1;
            }
            // At most one turn below zero, since the distance is less than the box here.
            let first = if low < 0.0 { low + n as f64 } else { low } as usize;
            first..=first + (high - low) as usize
        })
    }
}

impl Class {
    fn new(size: DVec3, largest_radius: f64, number: usize) -> Self {
        // No more than about two cells per grain, however sparse.
        let most = 2.0 * number as f64 + 27.0;
        let counts_for = |edge: f64| -> [f64; 3] { std::array::from_fn(|k| (size[k] / edge).floor().clamp(1.0, 1e9)) };
        let mut edge = 2.0 * largest_radius;
        let mut counts = [1.0; 3];
        if edge > 0.0 && number > 0 {
            counts = counts_for(edge);
            while counts[0] * counts[1] * counts[2] > most {
                edge *= 1.25;
                counts = counts_for(edge);
            }
        }
        let cell = DVec3::from_array(std::array::from_fn(|k| (size[k] / counts[k]).max(f64::MIN_POSITIVE)));
        let counts = counts.map(|n| n as usize);
        Self {
            largest_radius,
            cell,
            counts,
            heads: vec![NONE; counts[0] * counts[1] * counts[2]],
        }
    }

    /// Cell of a coordinate relative to the lower corner; the border cells take what is outside.
    fn index(&self, x: f64, k: usize) -> usize {
        // `as` saturates, so that negative values give 0.
        ((x / self.cell[k]) as usize).min(self.counts[k] - 1)
    }

    fn cell_of(&self, p: DVec3) -> [usize; 3] {
        std::array::from_fn(|k| self.index(p[k], k))
    }

    fn flat(&self, cell: [usize; 3]) -> usize {
        (cell[2] * self.counts[1] + cell[1]) * self.counts[0] + cell[0]
    }
}
