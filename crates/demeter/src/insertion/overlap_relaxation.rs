//! Dense random packings: grains of final size start at random places and push each other apart until none overlaps.
//!
//! Overlaps cost energy `1/2 overlap^2`; the energy is lowered by FIRE (Bitzek et al. 2006,
//! doi:10.1103/PhysRevLett.97.170201), which below random close packing finds places without overlap
//! (O'Hern et al. 2003, doi:10.1103/PhysRevE.68.011306). Grains push at radii a little above the true ones, so that
//! the true ones come free after finitely many steps: what is returned has no overlap at all, not a small one.
//! Grains push in one order on one thread, so the places are the same bits on every machine.

use super::place_grid::PlaceGrid;
use super::random::RandomNumbers;
use super::region::Space;
use glam::DVec3;
use std::ops::ControlFlow;

/// Grains are apart by at least this share of the sum of their radii, the room that rounding needs.
pub(super) const CLEARANCE: f64 = 3e-9;
/// Share by which the pushing radii exceed the true ones.
const INFLATION: f64 = 1e-3;
/// Gap up to which pairs are listed, over the mean radius.
const SKIN: f64 = 0.4;
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

/// Parameters of FIRE as published; the time step is in units of the oscillation of the smallest grain (mass 1,
/// stiffness 1 per contact).
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
    /// Shrunk by this share, the grains would be free of each other and inside the region.
    pub(super) shrink: f64,
}

/// Places for grains with these radii, from random ones.
pub(super) fn relax(
    space: &Space,
    radii: &[f64],
    occupied: &[(DVec3, f64)],
    random: &mut RandomNumbers,
) -> Result<Vec<DVec3>, Jammed> {
    let mut order: Vec<usize> = (0..radii.len()).collect();
    order.sort_by(|a, b| radii[*b].total_cmp(&radii[*a]));
    let mut places = vec![DVec3::ZERO; radii.len()];
    for index in order {
        places[index] = space.random_place(radii[index], random);
    }
    let mut packing = Packing::new(space, radii, places, occupied);
    let mut least_shrink = f64::INFINITY;
    let limits = Limits::of(radii.len());
    let (mut shakes, mut energy_before) = (0, f64::INFINITY);
    for step in 1..=limits.steps {
        let state = packing.push_apart();
        if state.pair_shrink <= -CLEARANCE && state.inside {
            return Ok(packing.into_places());
        }
        least_shrink = least_shrink.min(state.pair_shrink.max(state.side_shrink));
        if step % LOOK_EVERY == 0 {
            if state.energy > (1.0 - LEAST_PROGRESS) * energy_before {
                if shakes == limits.shakes {
                    break;
                }
                shakes += 1;
                packing.shake(random);
                energy_before = f64::INFINITY;
                continue;
            }
            energy_before = state.energy;
        }
        packing.descend();
    }
    Err(Jammed { shrink: least_shrink })
}

/// What one pass over all pairs found.
struct State {
    energy: f64,
    /// Largest overlap of true radii over their sum; negative when all are apart.
    pair_shrink: f64,
    /// Largest overlap with a side of the region over the radius.
    side_shrink: f64,
    /// Whether all true radii are inside the region.
    inside: bool,
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
    /// 1 over mass; a grain's mass is as its surface, as is the number of its contacts, so that all oscillate alike.
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
        let smallest = radii.iter().copied().fold(f64::INFINITY, f64::min);
        let mean = radii.iter().sum::<f64>() / radii.len() as f64;
        let largest = radii
            .iter()
            .copied()
            .chain(occupied.iter().map(|o| o.1))
            .fold(0.0, f64::max);
        let skin = SKIN * mean;
        let n = places.len();
        places.extend(occupied.iter().map(|o| space.wrap(o.0)));
        let mut packing = Self {
            space,
            radii,
            places,
            fixed: occupied.iter().map(|o| o.1).collect(),
            inverse_mass: radii.iter().map(|r| (smallest / r) * (smallest / r)).collect(),
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
        self.pairs.clear();
        for (i, (_, radius)) in grains.iter().enumerate() {
            grid.visit_partners::<()>(i, skin, |near| {
                let sum = radius + near.radius;
                let reach = sum + skin;
                let both_fixed = i >= n && near.index >= n;
                if near.difference.length_squared() < reach * reach && !both_fixed {
                    let (a, b) = (i as u32, near.index as u32);
                    self.pairs.push(Pair { a, b, sum });
                }
                ControlFlow::Continue(())
            });
        }
        self.listed_at.clear();
        self.listed_at.extend_from_slice(&self.places[..n]);
    }

    /// Computes the forces.
    fn push_apart(&mut self) -> State {
        let n = self.radii.len();
        let mut state = State {
            energy: 0.0,
            // No pair in reach means that all are apart by the inflation.
            pair_shrink: -INFLATION,
            side_shrink: 0.0,
            inside: true,
        };
        for (i, force) in self.forces.iter_mut().enumerate() {
            let (place, radius) = (self.places[i], self.radii[i]);
            *force = self.space.push(place, radius * (1.0 + INFLATION));
            if *force != DVec3::ZERO {
                state.energy += 0.5 * force.length_squared();
                state.inside &= self.space.holds(place, radius);
                state.side_shrink = state.side_shrink.max(self.space.excess(place, radius) / radius);
            }
        }
        let domain = self.space.domain();
        for pair in &self.pairs {
            let (a, b) = (pair.a as usize, pair.b as usize);
            let difference = match domain {
                Some(domain) => domain.difference(self.places[a], self.places[b]),
                None => self.places[a] - self.places[b],
            };
            let reach = pair.sum * (1.0 + INFLATION);
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
            state.pair_shrink = state.pair_shrink.max(1.0 - distance / pair.sum);
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
