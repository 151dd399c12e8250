//! Random packings without overlap.

use super::overlap_relaxation::{Jammed, relax};
use super::random::{Purpose, RandomNumbers};
use super::region::Space;
use super::sequential_addition::add_sequentially;
use super::size_distribution::SizeSampler;
use super::spec::Amount;
use super::{MAX_GRAINS, SizedPlace};
use glam::DVec3;
use std::f64::consts::PI;
use thiserror::Error;

/// Largest share of the region that grains may fill: a random packing of equal grains jams at 0.64, and at hard sides
/// before.
pub const MAX_FRACTION: f64 = 0.60;
/// Up to this share grains are put one after the other; above, they push each other apart.
const SEQUENTIAL_FRACTION: f64 = 0.30;

/// Why a random packing is not possible.
#[derive(Clone, Debug, PartialEq, Error)]
#[allow(missing_docs)]
pub enum PackingError {
    #[error("random packing: the volume fraction is {value}; allowed are fractions above 0 up to 0.60")]
    Fraction { value: f64 },
    #[error("random packing: the count is 0; at least 1 grain is needed")]
    NoGrains,
    #[error("random packing: about {wanted:.0} grains are asked for; at most {MAX_GRAINS} are possible")]
    TooMany { wanted: f64 },
    #[error(
        "random packing: a grain of diameter {diameter:?} m does not fit into the region, in which at most {largest:?} m fit; \
         enlarge the region or cut the size distribution"
    )]
    GrainTooLarge { diameter: f64, largest: f64 },
    #[error(
        "random packing: the grains would fill {fraction:.3} of the region (grains already there included); a random \
         packing without overlap is possible up to 0.60; ask for fewer or smaller grains, or a larger region"
    )]
    TooDense { fraction: f64 },
    #[error(
        "random packing: the grains jammed; {wanted:.3} of the region was asked for{}, and about {reached:.3} was reached \
         without overlap; ask for less, or enlarge the region (hard sides of a narrow region lower what is possible)",
        beside(*taken)
    )]
    Jammed { wanted: f64, taken: f64, reached: f64 },
}

/// What grains that were there before fill, in words.
fn beside(taken: f64) -> String {
    match taken > 0.0 {
        true => format!(" beside {taken:.3} that the grains of other batches fill and do not make way"),
        false => String::new(),
    }
}

fn sphere_volume(diameter: f64) -> f64 {
    PI / 6.0 * diameter * diameter * diameter
}

/// Grains at random places in a region, free of each other and of the grains already there.
pub(super) fn pack(
    space: &Space,
    sizes: &SizeSampler,
    amount: Amount,
    occupied: &[(DVec3, f64)],
    seed: u64,
) -> Result<Vec<SizedPlace>, PackingError> {
    let diameters = draw_diameters(space, sizes, amount, seed)?;
    let largest = space.largest_diameter();
    if let Some(&diameter) = diameters.iter().find(|d| **d > largest) {
        return Err(PackingError::GrainTooLarge { diameter, largest });
    }
    let occupied = nearby(space, occupied, diameters.iter().copied().fold(0.0, f64::max));
    let volume: f64 = diameters.iter().map(|d| sphere_volume(*d)).sum();
    let own_fraction = volume / space.volume();
    let taken: f64 = (occupied.iter().filter(|o| space.holds(o.0, 0.0)))
        .map(|o| sphere_volume(2.0 * o.1))
        .sum();
    let taken = taken / space.volume();
    let fraction = own_fraction + taken;
    if fraction > MAX_FRACTION * (1.0 + 1e-6) + largest_rounding(&diameters, amount) / space.volume() {
        return Err(PackingError::TooDense { fraction });
    }
    let radii: Vec<f64> = diameters.iter().map(|d| 0.5 * d).collect();
    let mut random = RandomNumbers::new(seed, Purpose::Places);
    let sequential = match fraction <= SEQUENTIAL_FRACTION {
        true => add_sequentially(space, &radii, &occupied, &mut random),
        false => None,
    };
    let places = match sequential {
        Some(places) => places,
        None => relax(space, &radii, &occupied, &mut random).map_err(|Jammed { scale }| PackingError::Jammed {
            wanted: own_fraction,
            taken,
            reached: own_fraction * scale * scale * scale,
        })?,
    };
    Ok(places.into_iter().zip(radii).collect())
}

/// A fraction is met to half a grain only, so that much may be above the limit.
fn largest_rounding(diameters: &[f64], amount: Amount) -> f64 {
    match amount {
        Amount::VolumeFraction(_) => 0.5 * diameters.iter().map(|d| sphere_volume(*d)).fold(0.0, f64::max),
        Amount::Count(_) => 0.0,
    }
}

/// Grains already there that may touch a grain of the region.
fn nearby(space: &Space, occupied: &[(DVec3, f64)], largest: f64) -> Vec<(DVec3, f64)> {
    let (lower, upper) = space.bounds();
    let middle = 0.5 * (lower + upper);
    let half = 0.5 * (upper - lower);
    (occupied.iter().copied())
        .filter(|(place, radius)| {
            let away = match space.domain() {
                Some(domain) => domain.difference(*place, middle),
                None => *place - middle,
            };
            (0..3).all(|k| away[k].abs() <= half[k] + radius + largest)
        })
        .collect()
}

fn draw_diameters(space: &Space, sizes: &SizeSampler, amount: Amount, seed: u64) -> Result<Vec<f64>, PackingError> {
    let mut random = RandomNumbers::new(seed, Purpose::Sizes);
    let volume = space.volume();
    match amount {
        Amount::Count(0) => Err(PackingError::NoGrains),
        Amount::Count(count) => {
            if count > MAX_GRAINS {
                return Err(PackingError::TooMany {
                    wanted: f64::from(count),
                });
            }
            let smallest = f64::from(count) * sphere_volume(sizes.bounds().0) / volume;
            if smallest > MAX_FRACTION {
                let fraction = f64::from(count) * sizes.mean_volume() / volume;
                return Err(PackingError::TooDense { fraction });
            }
            Ok((0..count).map(|_| sizes.draw(&mut random)).collect())
        }
        Amount::VolumeFraction(value) => {
            if !(value > 0.0 && value <= MAX_FRACTION) {
                return Err(PackingError::Fraction { value });
            }
            let target = value * volume;
            let wanted = target / sizes.mean_volume();
            if wanted > f64::from(MAX_GRAINS) {
                return Err(PackingError::TooMany { wanted });
            }
            Ok(draw_volume(sizes, target, &mut random))
        }
    }
}

/// Draws until the volume is as near to the target as a last grain can bring it, but at least one grain.
fn draw_volume(sizes: &SizeSampler, target: f64, random: &mut RandomNumbers) -> Vec<f64> {
    let mut diameters = Vec::new();
    let mut sum = 0.0;
    loop {
        let d = sizes.draw(random);
        let next = sum + sphere_volume(d);
        if next > target && next - target > target - sum && !diameters.is_empty() {
            return diameters;
        }
        diameters.push(d);
        sum = next;
        if sum >= target || diameters.len() >= MAX_GRAINS as usize {
            return diameters;
        }
    }
}
