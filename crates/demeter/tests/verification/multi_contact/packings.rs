//! Disordered packings, and grains that move as told.

use demeter::simulation::Simulation;
use demeter_physics::DVec3;
use rand_pcg::Pcg64;
use rand_pcg::rand_core::{Rng, SeedableRng};

/// Numbers from 0 to 1.
pub struct Dice(Pcg64);

impl Dice {
    pub fn new(seed: u64) -> Self {
        Self(Pcg64::seed_from_u64(seed))
    }

    pub fn roll(&mut self) -> f64 {
        (self.0.next_u64() >> 11) as f64 * (1.0 / 9_007_199_254_740_992.0)
    }

    pub fn place(&mut self) -> DVec3 {
        DVec3::new(self.roll(), self.roll(), self.roll())
    }
}

/// Grains of radii from `1/ratio` to 1 in a cube from the origin, filled to `fill` of its volume: thrown in, and pushed apart
/// until the overlaps balance each other. Returns radii and places, and the edge.
pub fn disordered(count: usize, ratio: f64, fill: f64, seed: u64) -> (Vec<(f64, DVec3)>, f64) {
    let mut dice = Dice::new(seed);
    let radii: Vec<f64> = (0..count).map(|_| libm::pow(ratio, dice.roll() - 1.0)).collect();
    let volume: f64 = radii.iter().map(|r| 4.0 / 3.0 * std::f64::consts::PI * r * r * r).sum();
    let edge = libm::cbrt(volume / fill);
    let mut places: Vec<DVec3> = radii.iter().map(|_| dice.place() * edge).collect();
    for _ in 0..1500 {
        let mut push = vec![DVec3::ZERO; count];
        for i in 0..count {
            for j in 0..i {
                let (way, sum) = (places[i] - places[j], radii[i] + radii[j]);
                if way.length_squared() < sum * sum {
                    let force = way.normalize() * (sum - way.length());
                    push[i] += force;
                    push[j] -= force;
                }
            }
            push[i] += (DVec3::splat(radii[i]) - places[i]).max(DVec3::ZERO);
            push[i] -= (places[i] + radii[i] - edge).max(DVec3::ZERO);
        }
        for (place, push) in places.iter_mut().zip(push) {
            *place += 0.3 * push;
        }
    }
    (radii.into_iter().zip(places).collect(), edge)
}

/// Makes the grains too heavy to be moved by forces: they go on with their velocities, and a step takes one second.
pub fn make_unstoppable(sim: &mut Simulation) {
    let grains = sim.grains_mut();
    for g in 0..grains.len() {
        grains.set_size(g, grains.radius(g), 1e25 * grains.mass(g));
    }
    sim.set_dt(1.0).unwrap();
}
