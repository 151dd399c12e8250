//! Dense random packings: grains of final size start at random places and push each other apart until none overlaps.
//!
//! Overlaps cost energy `1/2 overlap^2`; the energy is lowered by FIRE (Bitzek et al. 2006,
//! doi:10.1103/PhysRevLett.97.170201), which below random close packing finds places without overlap
//! (O'Hern et al. 2003, doi:10.1103/PhysRevE.68.011306). Grains push at radii a little above the true ones, so that
//! the true ones come free after finitely many steps: what is returned has no overlap at all, not a small one.
//! Pairs are listed on all threads, in one order; grains push in that order on one thread, so the places are the same bits on every
//! machine.

use super::place_grid::PlaceGrid;
use super::random::RandomNumbers;
use super::region::Space;
use glam::DVec3;
use rayon::prelude::*;
use std::ops::ControlFlow;

/// Grains are apart by at least this share of the sum of their radii, the room that rounding needs.
pub(super) const CLEARANCE: f64 = 3e-9;
/// Share by which the pushing radii exceed the true ones.
const INFLATION: f64 = 1e-3;
/// Gap up to which pairs are listed, over the mean radius.
const SKIN: f64 = 0.4;
/// Radius over that of a grain from which on another is much larger, and places that are tried for a grain so that it is beside such ones.
const MUCH_LARGER: f64 = 3.0;
const TRIES: u32 = 100;
/// Grains whose pairs one task lists.
const GRAINS_PER_TASK: usize = 512;
/// Limits before giving up: steps and shakes of a jammed packing. Few grains get more of both, as their packings jam by
/// bad luck more often, and trying again is cheap.
const LEAST_LIMITS: Limits = Limits {
    steps: 30_000,
    shakes: 6,
};
const MOST_LIMITS: Limits = Limits {
    steps: 300_000,
    shakes: 200,
};
/// Grains up to which there is more than the least limits.
const FEW: usize = 1_000;
/// Steps between two looks whether the packing is jammed.
const LOOK_EVERY: u32 = 500;
/// A look that finds the energy lowered by less than this share calls the packing jammed.
const LEAST_PROGRESS: f64 = 0.1;

/// Neighbours up to which a grain has mass 1.
const FEW_NEIGHBOURS: f64 = 14.0;
/// Steps by which the radii shrink to find what a jammed packing reached.
const SHRINK: f64 = 0.0025;

/// Parameters of FIRE as published; the time step is in units of the oscillation of a grain of mass 1 at a contact of
/// stiffness 1.
mod fire {
    pub(super) const FIRST_STEP: f64 = 0.1;
    pub(super) const LONGEST_STEP: f64 = 0.35;
    pub(super) const LEAST_DOWNHILL: u32 = 5;
    pub(super) const STEP_GROWTH: f64 = 1.1;
    pub(super) const STEP_CUT: f64 = 0.5;
    pub(super) const FIRST_MIXING: f64 = 0.1;
    pub(super) const MIXING_DECAY: f64 = 0.99;
}

struct Limits {
    steps: u32,
    shakes: u32,
}

impl Limits {
    fn of(grains: usize) -> Self {
        let times = |least: u32, most: u32| {
            let scaled = u64::from(least) * FEW as u64 / grains.max(1) as u64;
            scaled.clamp(u64::from(least), u64::from(most)) as u32
        };
        Self {
            steps: times(LEAST_LIMITS.steps, MOST_LIMITS.steps),
            shakes: times(LEAST_LIMITS.shakes, MOST_LIMITS.shakes),
        }
    }
}

/// A packing that jammed before its grains came free of each other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Jammed {
    /// With their radii times this, the grains came free.
    pub(super) scale: f64,
}

/// Places for grains with these radii, from random ones.
pub(super) fn relax(
    space: &Space,
    radii: &[f64],
    occupied: &[(DVec3, f64)],
    random: &mut RandomNumbers,
) -> Result<Vec<DVec3>, Jammed> {
    let places = random_places(space, radii, occupied, random);
    // Neighbours in space are made neighbours in memory.
    let order = slices(space, &places, radii);
    let sorted_radii: Vec<f64> = order.iter().map(|i| radii[*i]).collect();
    let sorted_places = order.iter().map(|i| places[*i]).collect();
    let mut packing = Packing::new(space, &sorted_radii, sorted_places, occupied);
    packing.free_all(random)?;
    let mut places = places;
    for (index, place) in order.into_iter().zip(packing.into_places()) {
        places[index] = place;
    }
    Ok(places)
}

/// Random places; those of sizes far apart from the largest grain on, each beside the much larger ones that came before, where it has
/// room: from the middle of a large grain a small one has a long way out, and is in the way of all others.
fn random_places(space: &Space, radii: &[f64], occupied: &[(DVec3, f64)], random: &mut RandomNumbers) -> Vec<DVec3> {
    let of_all = || radii.iter().copied().chain(occupied.iter().map(|o| o.1));
    let (smallest, largest) = of_all().fold((f64::INFINITY, 0.0f64), |(s, l), r| (s.min(r), l.max(r)));
    if largest < MUCH_LARGER * smallest {
        return radii.iter().map(|r| space.random_place(*r, random)).collect();
    }
    let (lower, upper) = space.bounds();
    let mut grid = PlaceGrid::new(space.domain(), lower, upper, of_all());
    occupied.iter().for_each(|(place, radius)| grid.add(*place, *radius));
    let mut order: Vec<usize> = (0..radii.len()).collect();
    order.sort_by(|a, b| radii[*b].total_cmp(&radii[*a]));
    let mut places = vec![DVec3::ZERO; radii.len()];
    for index in order {
        let radius = radii[index];
        let is_beside = |place: &DVec3| {
            let inside = grid.visit(*place, radius, |near| {
                let is_inside = near.radius >= MUCH_LARGER * radius
                    && near.difference.length_squared() < (near.radius + radius) * (near.radius + radius);
                if is_inside {
                    ControlFlow::Break(())
                } else {
                    ControlFlow::Continue(())
                }
            });
            inside.is_none()
        };
        let mut place = space.random_place(radius, random);
        for _ in 0..TRIES {
            if is_beside(&place) {
                break;
            }
            place = space.random_place(radius, random);
        }
        grid.add(place, radius);
        places[index] = place;
    }
    places
}

/// Order of grains by slices along z, rows along y, and x.
fn slices(space: &Space, places: &[DVec3], radii: &[f64]) -> Vec<usize> {
    let edge = 4.0 * radii.iter().sum::<f64>() / radii.len() as f64;
    let lower = space.bounds().0;
    let cell = |i: usize| {
        let p = (places[i] - lower) / edge;
        [p.z as i64, p.y as i64, p.x as i64]
    };
    let mut order: Vec<usize> = (0..places.len()).collect();
    order.sort_by_key(|i| cell(*i));
    order
}

impl Packing<'_> {
    /// Pushes and shakes until all grains are free.
    fn free_all(&mut self, random: &mut RandomNumbers) -> Result<(), Jammed> {
        let limits = Limits::of(self.radii.len());
        let (mut shakes, mut energy_before) = (0, f64::INFINITY);
        for step in 1..=limits.steps {
            let state = self.push_apart();
            if state.is_free() {
                return Ok(());
            }
            if step % LOOK_EVERY == 0 {
                if state.energy > (1.0 - LEAST_PROGRESS) * energy_before {
                    if shakes == limits.shakes {
                        break;
                    }
                    shakes += 1;
                    self.shake(random);
                    energy_before = f64::INFINITY;
                    continue;
                }
                energy_before = state.energy;
            }
            self.descend();
        }
        Err(self.shrink_until_free())
    }

    /// Finds by how much the radii must shrink so that the grains come free of each other soon.
    fn shrink_until_free(&mut self) -> Jammed {
        while self.scale > SHRINK {
            self.scale -= SHRINK;
            self.rest();
            for _ in 0..LOOK_EVERY {
                if self.push_apart().is_free() {
                    return Jammed { scale: self.scale };
                }
                self.descend();
            }
        }
        Jammed { scale: 0.0 }
    }
}

/// What one pass over all pairs found.
struct State {
    energy: f64,
    /// Least distance over the sum of the true radii, at most what the inflation makes of it.
    closest: f64,
    /// Whether all true radii are inside the region.
    inside: bool,
}

impl State {
    fn is_free(&self) -> bool {
        self.inside && self.closest >= 1.0 + CLEARANCE
    }
}

#[derive(Clone, Copy)]
struct Pair {
    a: u32,
    b: u32,
    /// Sum of the true radii.
    sum: f64,
}

struct Packing<'a> {
    space: &'a Space<'a>,
    radii: &'a [f64],
    /// Own grains first, then the fixed ones.
    places: Vec<DVec3>,
    fixed: Vec<f64>,
    /// Factor on all radii, 1 unless the packing jammed.
    scale: f64,
    /// 1 over mass; the mass is as the number of neighbours, so that large and small grains oscillate alike.
    inverse_mass: Vec<f64>,
    velocities: Vec<DVec3>,
    forces: Vec<DVec3>,
    pairs: Vec<Pair>,
    /// Pairs are listed when their surfaces are closer than this.
    skin: f64,
    /// How much closer two grains may come before an unlisted pair can push: the skin without the inflation.
    slack: f64,
    listed_at: Vec<DVec3>,
    time_step: f64,
    mixing: f64,
    downhill: u32,
}

impl<'a> Packing<'a> {
    fn new(space: &'a Space<'a>, radii: &'a [f64], mut places: Vec<DVec3>, occupied: &[(DVec3, f64)]) -> Self {
        let mean = radii.iter().sum::<f64>() / radii.len() as f64;
        let largest = radii
            .iter()
            .copied()
            .chain(occupied.iter().map(|o| o.1))
            .fold(0.0, f64::max);
        // of grains many times as large as most the inflation alone would use up a skin of the others
        let skin = (SKIN * mean).max(4.0 * INFLATION * largest);
        let n = places.len();
        places.extend(occupied.iter().map(|o| space.wrap(o.0)));
        let mut packing = Self {
            space,
            radii,
            places,
            fixed: occupied.iter().map(|o| o.1).collect(),
            scale: 1.0,
            inverse_mass: vec![1.0; n],
            velocities: vec![DVec3::ZERO; n],
            forces: vec![DVec3::ZERO; n],
            pairs: Vec::new(),
            skin,
            slack: (skin - 2.0 * INFLATION * largest).max(0.0),
            listed_at: Vec::new(),
            time_step: fire::FIRST_STEP,
            mixing: fire::FIRST_MIXING,
            downhill: 0,
        };
        packing.list_pairs();
        packing
    }

    fn list_pairs(&mut self) {
        let n = self.radii.len();
        for place in &mut self.places[..n] {
            *place = self.space.wrap(*place);
        }
        let radii = self.radii.iter().chain(&self.fixed).copied();
        let grains: Vec<(DVec3, f64)> = self.places.iter().copied().zip(radii).collect();
        let grid = PlaceGrid::holding(self.space.domain(), &grains);
        let skin = self.skin;
        let pairs_of = |(task, some): (usize, &[(DVec3, f64)])| {
            let mut pairs = Vec::new();
            for (i, (_, radius)) in (task * GRAINS_PER_TASK..).zip(some) {
                grid.visit_partners::<()>(i, skin, |near| {
                    let sum = radius + near.radius;
                    let reach = sum + skin;
                    let both_fixed = i >= n && near.index >= n;
                    if near.difference.length_squared() < reach * reach && !both_fixed {
                        let (a, b) = (i as u32, near.index as u32);
                        pairs.push(Pair { a, b, sum });
                    }
                    ControlFlow::Continue(())
                });
            }
            pairs
        };
        let tasks = grains.par_chunks(GRAINS_PER_TASK).enumerate();
        let of_tasks: Vec<Vec<Pair>> = tasks.map(pairs_of).collect();
        self.pairs.clear();
        of_tasks.iter().for_each(|pairs| self.pairs.extend_from_slice(pairs));
        let mut neighbours = vec![0u32; grains.len()];
        for pair in &self.pairs {
            neighbours[pair.a as usize] += 1;
            neighbours[pair.b as usize] += 1;
        }
        for (inverse, number) in self.inverse_mass.iter_mut().zip(neighbours) {
            *inverse = (FEW_NEIGHBOURS / f64::from(number)).min(1.0);
        }
        self.listed_at.clear();
        self.listed_at.extend_from_slice(&self.places[..n]);
    }

    /// Computes the forces.
    fn push_apart(&mut self) -> State {
        let n = self.radii.len();
        let mut state = State {
            energy: 0.0,
            closest: 1.0 + INFLATION,
            inside: true,
        };
        for (i, force) in self.forces.iter_mut().enumerate() {
            let (place, radius) = (self.places[i], self.scale * self.radii[i]);
            *force = self.space.push(place, radius * (1.0 + INFLATION));
            if *force != DVec3::ZERO {
                state.energy += 0.5 * force.length_squared();
                state.inside &= self.space.holds(place, radius);
            }
        }
        let domain = self.space.domain();
        for pair in &self.pairs {
            let (a, b) = (pair.a as usize, pair.b as usize);
            let difference = match domain {
                Some(domain) => domain.difference(self.places[a], self.places[b]),
                None => self.places[a] - self.places[b],
            };
            let reach = self.scale * pair.sum * (1.0 + INFLATION);
            let square = difference.length_squared();
            if square >= reach * reach {
                continue;
            }
            let distance = square.sqrt();
            let overlap = reach - distance;
            // Grains at one place part along x.
            let normal = if distance > 0.0 {
                difference / distance
            } else {
                DVec3::X
            };
            state.energy += 0.5 * overlap * overlap;
            state.closest = state.closest.min(distance / (self.scale * pair.sum));
            if a < n {
                self.forces[a] += normal * overlap;
            }
            if b < n {
                self.forces[b] -= normal * overlap;
            }
        }
        state
    }

    /// One step of FIRE with the forces of the last pass.
    fn descend(&mut self) {
        let (mut power, mut speed, mut strength) = (0.0, 0.0, 0.0);
        for (v, f) in self.velocities.iter().zip(&self.forces) {
            power += v.dot(*f);
            speed += v.length_squared();
            strength += f.length_squared();
        }
        if power > 0.0 {
            self.downhill += 1;
            let turn = if strength > 0.0 {
                self.mixing * (speed / strength).sqrt()
            } else {
                0.0
            };
            for (v, f) in self.velocities.iter_mut().zip(&self.forces) {
                *v = *v * (1.0 - self.mixing) + *f * turn;
            }
            if self.downhill > fire::LEAST_DOWNHILL {
                self.time_step = (self.time_step * fire::STEP_GROWTH).min(fire::LONGEST_STEP);
                self.mixing *= fire::MIXING_DECAY;
            }
        } else {
            self.rest();
            self.time_step = (self.time_step * fire::STEP_CUT).max(0.1 * fire::FIRST_STEP);
        }
        let mut farthest: f64 = 0.0;
        for i in 0..self.velocities.len() {
            self.velocities[i] += self.forces[i] * (self.inverse_mass[i] * self.time_step);
            self.places[i] += self.velocities[i] * self.time_step;
            farthest = farthest.max((self.places[i] - self.listed_at[i]).length_squared());
        }
        // Two grains may have come closer by twice the farthest move.
        if 4.0 * farthest > self.slack * self.slack {
            self.list_pairs();
        }
    }

    fn rest(&mut self) {
        self.velocities.fill(DVec3::ZERO);
        self.mixing = fire::FIRST_MIXING;
        self.downhill = 0;
    }

    /// Moves every grain by up to a third of its radius in each direction.
    fn shake(&mut self, random: &mut RandomNumbers) {
        for (place, radius) in self.places.iter_mut().zip(self.radii) {
            let shift = DVec3::new(random.symmetric(), random.symmetric(), random.symmetric());
            *place += shift * (radius / 3.0);
        }
        self.rest();
        self.time_step = fire::FIRST_STEP;
        self.list_pairs();
    }

    fn into_places(self) -> Vec<DVec3> {
        (self.places.iter().zip(self.radii))
            .map(|(place, radius)| self.space.settle(self.space.wrap(*place), *radius))
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::super::random::Purpose;
    use super::*;
    use crate::insertion::Region;

    #[test]
    fn small_grains_start_beside_much_larger_ones() {
        let region = Region::Box {
            lower: DVec3::ZERO,
            upper: DVec3::splat(1.0),
        };
        let space = Space::new(&region, None).unwrap();
        // two sevenths of the room are in large grains, one of which is fixed
        let mut radii = vec![0.01; 2000];
        radii.extend([0.2; 8]);
        let occupied = [(DVec3::splat(0.5), 0.2)];
        let mut random = RandomNumbers::new(1, Purpose::Places);
        let places = random_places(&space, &radii, &occupied, &mut random);
        let large = places[2000..].iter().copied().chain([occupied[0].0]);
        let large: Vec<DVec3> = large.collect();
        for place in &places[..2000] {
            assert!(large.iter().all(|middle| middle.distance(*place) >= 0.21));
        }
        // equal ones are where they always were
        let drawn = |random: &mut RandomNumbers| random_places(&space, &radii[..9], &[], random);
        let mut again = RandomNumbers::new(7, Purpose::Places);
        let one_by_one: Vec<DVec3> = (0..9).map(|_| space.random_place(0.01, &mut again)).collect();
        assert_eq!(drawn(&mut RandomNumbers::new(7, Purpose::Places)), one_by_one);
    }
}
