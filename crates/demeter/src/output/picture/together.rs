//! Pictures of grains that several processes have: each draws its own, and the first puts the pictures together.
//!
//! The first needs to know no other grains than those that are seen, and those around them that hold light back.

use super::shading::{Grid, Rgb};
use super::spheres::{Seen, Sight, Sphere};
use crate::comm::together::Together;
use serde::{Deserialize, Serialize};

/// Spheres with their colours, and which of them every pixel sees.
pub(super) struct Drawn {
    pub spheres: Vec<Sphere>,
    pub albedo: Vec<Rgb>,
    pub seen: Vec<Seen>,
}

/// A sphere that the first process must know: its number among all, and its colour.
#[derive(Clone, Copy, Serialize, Deserialize)]
struct Known {
    number: u32,
    sphere: Sphere,
    albedo: Rgb,
}

impl Drawn {
    /// What the first process needs for the picture of all; of others nothing is left. `first` is the number of the first own sphere.
    pub fn together(self, all: Together, first: u32, sight: Sight) -> Self {
        if all.is_alone() {
            return self;
        }
        let seen = self.nearest(all, first);
        let mut shown: Vec<u32> = seen.iter().filter(|p| p.is_covered()).map(|p| p.sphere).collect();
        shown.sort_unstable();
        shown.dedup();
        let shown = all.told_by_first(&shown);
        let own = || {
            let both = self.spheres.iter().zip(&self.albedo);
            (first..)
                .zip(both)
                .map(|(number, (&sphere, &albedo))| Known { number, sphere, albedo })
        };
        let is_shown = |known: &Known| shown.binary_search(&known.number).is_ok();
        let mut known: Vec<Known> = all.joined(own().filter(is_shown)).collect();
        let spheres: Vec<Sphere> = all.told_by_first(&known.iter().map(|k| k.sphere).collect::<Vec<_>>());
        let grid = Grid::new(&spheres, |_| true);
        let holds_light_back = |k: &Known| !is_shown(k) && grid.is_darkened_by(&k.sphere, sight);
        known.extend(all.joined(own().filter(holds_light_back)));
        known.sort_unstable_by_key(|k| k.number);
        let place = |number: u32| known.partition_point(|k| k.number < number) as u32;
        let covered = |pixel: Seen| match pixel.is_covered() {
            true => Seen {
                sphere: place(pixel.sphere),
                ..pixel
            },
            false => pixel,
        };
        Self {
            seen: seen.into_iter().map(covered).collect(),
            spheres: known.iter().map(|k| k.sphere).collect(),
            albedo: known.iter().map(|k| k.albedo).collect(),
        }
    }

    /// What every pixel sees of all, by the numbers of the spheres; nothing at others than the first.
    fn nearest(&self, all: Together, first: u32) -> Vec<Seen> {
        let numbered = (0u32..).zip(&self.seen).filter(|(_, pixel)| pixel.is_covered());
        let told = all.joined(numbered.map(|(at, pixel)| (at, pixel.depth, first + pixel.sphere)));
        let mut nearest = vec![Seen::NOTHING; self.seen.len()];
        for (at, depth, sphere) in told.filter(|_| all.is_first()) {
            // those of the same depth come by rising numbers
            if let Some(pixel) = nearest.get_mut(at as usize).filter(|pixel| depth < pixel.depth) {
                *pixel = Seen { depth, sphere };
            }
        }
        nearest
    }
}
