//! How fast bodies may meet.

use super::time_step::{WallPartner, each_contact, in_words, pair_size, smaller_radius};
use crate::materials::Materials;
use crate::particles::Grains;
use demeter_physics::collision::{HeadOn, Start, Tolerance};
use demeter_physics::contact::PairSize;
use demeter_physics::contact::normal::{Normal, NormalVisitor};

/// The speed at which the first two bodies of a run overlap by more than it allows.
#[derive(Clone, Debug, PartialEq)]
pub struct FastestImpact {
    /// Speed of a head-on impact [m/s].
    pub speed: f64,
    /// Which bodies, in words: `"two grains of glass"`.
    pub bodies: String,
}

impl FastestImpact {
    /// The height from which a body falls that is so fast, under gravity [m]; infinite without.
    pub fn height(&self, gravity: f64) -> f64 {
        self.speed * self.speed / (2.0 * gravity)
    }
}

/// The slowest of the head-on impacts that overlap bodies by `max_overlap` of the smaller radius, between all materials in use, of grains of
/// extreme sizes and masses, and with the walls. Nothing where there is no impact, or where the laws tell none. Neighbours that push from
/// behind add to the overlap, grazing impacts have less.
pub fn fastest_impact(
    grains: &Grains,
    walls: &[WallPartner],
    materials: &Materials,
    max_overlap: f64,
) -> Option<FastestImpact> {
    let mut slowest: Option<FastestImpact> = None;
    let mut seen: Vec<(u32, PairSize)> = Vec::new();
    each_contact(grains, walls, materials, |(a, b), one, other| {
        let (pair, size) = (materials.pair(a, b), pair_size(one, other));
        if seen.contains(&(pair, size)) {
            return;
        }
        seen.push((pair, size));
        let search = Search {
            size,
            overlap: max_overlap * smaller_radius(one, other),
        };
        let speed = materials.law(pair).normal.visit(search);
        if let Some(speed) = speed.filter(|&speed| slowest.as_ref().is_none_or(|slowest| speed < slowest.speed)) {
            let bodies = in_words(materials, (a, b), other);
            slowest = Some(FastestImpact { speed, bodies });
        }
    });
    slowest
}

/// Seeks the speed that leads to an overlap [m].
struct Search {
    size: PairSize,
    overlap: f64,
}

/// Most collisions that are tried.
const MOST_TRIALS: usize = 40;
/// How near the overlap must come to the one sought.
const CLOSE: f64 = 1e-4;

impl NormalVisitor for Search {
    type Output = Option<f64>;

    fn visit<L: Normal>(self, law: &L) -> Option<f64> {
        let tolerance = Tolerance {
            relative: 1e-8,
            ..Tolerance::default()
        };
        let mut speed = 1.0;
        for _ in 0..MOST_TRIALS {
            let impact = HeadOn {
                law,
                size: self.size,
                speed,
                start: Start::Contact,
            };
            let over = impact.run(&tolerance).ok()?.max_overlap / self.overlap;
            if (over - 1.0).abs() < CLOSE {
                return Some(speed);
            }
            // overlaps grow about as the speed to the power 0.8 (Hertz) to 1 (linear springs)
            speed /= over.powf(1.1);
        }
        None
    }
}
