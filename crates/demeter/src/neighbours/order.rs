//! Order of the grains along a space-filling curve, so that neighbours in space are neighbours in memory.

use super::moves::{Moves, NewPlaces};
use super::vicinity::Bounds;
use crate::particles::{Grains, Row};
use glam::DVec3;
use rayon::prelude::*;

/// Most bits per direction.
const MOST_BITS: u32 = 21;

/// Grains whose places on the curve are found by one task.
const GRAINS_PER_TASK: usize = 4096;

/// Place of a grain on the curve, its id, which orders those in the same cell, and its index.
pub(crate) type Keyed = (u64, u32, u32);

/// Puts grains into the order of the curve, which depends on nothing but places and ids; tells where they went.
pub fn put_in_order(grains: &mut Grains) -> Moves {
    let rows = grains.position.rows();
    let curve = Curve::new(bounds(rows), rows.len());
    let mut places = NewPlaces::unknown(rows.len());
    let sorted = curve.sorted(rows, &grains.id);
    (0..).zip(sorted).for_each(|(to, (.., grain))| places.note(grain, to));
    let moves = Moves::Reordered(places);
    moves.apply(grains);
    moves
}

/// Around the centres of grains.
fn bounds(rows: &[Row]) -> Bounds {
    (rows.par_chunks(GRAINS_PER_TASK))
        .map(Bounds::of_centres)
        .reduce(|| Bounds::NOTHING, Bounds::join)
}

/// A curve whose cells hold less than one grain in the mean.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Curve {
    lower: DVec3,
    /// Cells per metre.
    scale: f64,
    bits: u32,
}

impl Curve {
    /// For so many grains with these bounds around their centres.
    pub(crate) fn new(Bounds { lower, upper }: Bounds, grains: usize) -> Self {
        let size = upper - lower;
        let longest = size.max_element();
        if longest.is_nan() || longest <= 0.0 {
            return Self {
                lower,
                scale: 0.0,
                bits: 1,
            };
        }
        // a cube has the finest cells per grain; flat and long beds need more bits along their length
        let volume = (size / longest).max(DVec3::splat(1e-6)).element_product() / grains as f64;
        let mut bits = 1;
        while bits < MOST_BITS && volume * f64::from(1u32 << bits).powi(3) < 4.0 {
            bits += 1;
        }
        let scale = f64::from((1u32 << bits) - 1) / longest;
        Self { lower, scale, bits }
    }

    /// Place on the curve of a place in space.
    pub(crate) fn place(&self, place: DVec3) -> u64 {
        let cell = ((place - self.lower) * self.scale).to_array().map(|x| x as u32);
        hilbert(cell, self.bits)
    }

    /// Grains in their order on the curve, with their indices among those that are told.
    pub(crate) fn sorted(&self, rows: &[Row], ids: &[u32]) -> Vec<Keyed> {
        let mut sorted = vec![(0, 0, 0); rows.len()];
        (sorted.par_chunks_mut(GRAINS_PER_TASK).enumerate()).for_each(|(task, sorted)| {
            for (grain, sorted) in (task * GRAINS_PER_TASK..).zip(sorted) {
                *sorted = (self.place(rows[grain].vector), ids[grain], grain as u32);
            }
        });
        sorted.par_sort_unstable();
        sorted
    }
}

/// Place on a Hilbert curve of a cell, by J. Skilling, Programming the Hilbert curve, AIP Conference Proceedings 707
/// (2004) 381.
fn hilbert(mut x: [u32; 3], bits: u32) -> u64 {
    let top = 1u32 << (bits - 1);
    let mut q = top;
    while q > 1 {
        let p = q - 1;
        for axis in 0..3 {
            if x[axis] & q != 0 {
                x[0] ^= p;
            } else {
                let t = (x[0] ^ x[axis]) & p;
                x[0] ^= t;
                x[axis] ^= t;
            }
        }
        q >>= 1;
    }
    x[1] ^= x[0];
    x[2] ^= x[1];
    let mut t = 0;
    q = top;
    while q > 1 {
        if x[2] & q != 0 {
            t ^= q - 1;
        }
        q >>= 1;
    }
    spread(x[0] ^ t) << 2 | spread(x[1] ^ t) << 1 | spread(x[2] ^ t)
}

/// Spreads 21 bits so that two free bits follow each.
fn spread(x: u32) -> u64 {
    let mut x = u64::from(x) & 0x1f_ffff;
    x = (x | x << 32) & 0x001f_0000_0000_ffff;
    x = (x | x << 16) & 0x001f_0000_ff00_00ff;
    x = (x | x << 8) & 0x100f_00f0_0f00_f00f;
    x = (x | x << 4) & 0x10c3_0c30_c30c_30c3;
    (x | x << 2) & 0x1249_2492_4924_9249
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_curve_visits_every_cell_once_and_steps_to_a_neighbour() {
        let bits = 3;
        let mut cells = vec![None; 512];
        for x in 0..8 {
            for y in 0..8 {
                for z in 0..8 {
                    let place = &mut cells[hilbert([x, y, z], bits) as usize];
                    assert!(place.is_none(), "two cells at one place");
                    *place = Some([x, y, z]);
                }
            }
        }
        for pair in cells.windows(2) {
            let [Some(a), Some(b)] = [pair[0], pair[1]] else {
                panic!("a gap in the curve")
            };
            let steps: u32 = (0..3).map(|k| a[k].abs_diff(b[k])).sum();
            assert_eq!(steps, 1, "{a:?} to {b:?}");
        }
    }
}
