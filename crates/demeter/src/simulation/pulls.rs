//! Whether grains can pull each other.

use super::time_step::{each_contact, pair_size, smaller_radius};
use crate::materials::Materials;
use crate::particles::Grains;
use demeter_physics::contact::PairSize;
use demeter_physics::contact::normal::{Normal, NormalInput, NormalVisitor};

/// Overlaps that are tried on the way in, and as many on the way out.
const PLACES: u32 = 100;
/// What rounding may leave of a force that is none, as a share of the largest.
const ROUNDING: f64 = 1e-9;

/// Whether two grains that were pressed together, up to an overlap of this share of the smaller radius, pull each other anywhere on the
/// way in or out; between all materials in use and grains of extreme sizes.
pub(crate) fn can_pull(grains: &Grains, materials: &Materials, share: f64) -> bool {
    let mut pulls = false;
    each_contact(grains, &[], materials, |(a, b), one, other| {
        let press = Press {
            size: pair_size(one, other),
            overlap: share * smaller_radius(one, other),
        };
        pulls = pulls || materials.law(materials.pair(a, b)).normal.visit(press);
    });
    pulls
}

/// Presses two bodies up to an overlap [m], and draws them apart.
struct Press {
    size: PairSize,
    overlap: f64,
}

impl NormalVisitor for Press {
    type Output = bool;

    fn visit<L: Normal>(self, law: &L) -> bool {
        let mut history = vec![0.0; L::HISTORY.len()];
        // most of them near the first touch, where weak pulls show
        let place = |k: u32| self.overlap * (f64::from(k) / f64::from(PLACES)).powi(4);
        let (mut least, mut most) = (0.0f64, 0.0f64);
        let mut press = |overlap: f64, rate: f64| {
            let force = law
                .respond(&NormalInput::at(self.size, overlap, rate), &mut history)
                .elastic;
            (least, most) = (least.min(force), most.max(force));
        };
        (1..=PLACES).for_each(|k| press(place(k), f64::MIN_POSITIVE));
        (1..PLACES).rev().for_each(|k| press(place(k), -f64::MIN_POSITIVE));
        least < -ROUNDING * most
    }
}
