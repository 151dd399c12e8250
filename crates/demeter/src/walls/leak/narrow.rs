//! The narrowest place on a way out, found between the cells.

use super::space::Space;
use demeter_physics::geometry::surface_point::perpendicular;
use glam::DVec3;
use std::f64::consts::TAU;

/// Places along the way that are looked at.
const PLACES: i32 = 24;
/// Directions across the way in which a wider place is looked for.
const AROUND: u32 = 8;
/// Moves and halvings of the step across the way.
const HALVINGS: u32 = 24;

/// Directions that are tried for the way through.
const DIRECTIONS: u32 = 200;
/// How far before and behind the narrowest place the way is looked for, in its clearance.
const AHEAD: f64 = 0.3;
/// Golden angle [rad]: directions by it cover a sphere evenly.
const GOLDEN: f64 = 2.399_963_229_728_653;

/// The narrowest place of a passage.
#[derive(Clone, Copy, Debug)]
pub(super) struct Narrowest {
    pub(super) place: DVec3,
    /// Unit vector along the way through.
    pub(super) along: DVec3,
    /// Radius of the largest grain that passes [m].
    pub(super) clearance: f64,
}

/// From a point near the narrowest place, looks up and down the way, and at each place across it for the widest point: of
/// these the least is the saddle of the clearance. `reach` is how far off the point may be [m]. The way is looked for
/// twice, the second time along the direction in which it widens most before and behind.
pub(super) fn narrowest(space: &Space<'_>, near: DVec3, along: DVec3, reach: f64) -> Narrowest {
    let first = saddle(space, near, along, reach);
    let along = widening(space, &first);
    let second = saddle(space, first.place, along, reach);
    Narrowest {
        along: widening(space, &second),
        ..second
    }
}

/// The direction in which the way widens most on both sides.
fn widening(space: &Space<'_>, at: &Narrowest) -> DVec3 {
    let ahead = AHEAD * at.clearance.max(0.1 * space.radius);
    let wide = |direction: DVec3| {
        let (before, behind) = (at.place - direction * ahead, at.place + direction * ahead);
        space.clearance(before).min(space.clearance(behind))
    };
    let directions = (0..DIRECTIONS).map(|k| {
        let z = (f64::from(k) + 0.5) / f64::from(DIRECTIONS);
        let (around, beside) = (GOLDEN * f64::from(k), (1.0 - z * z).sqrt());
        DVec3::new(beside * libm::cos(around), beside * libm::sin(around), z)
    });
    let all = [at.along, DVec3::X, DVec3::Y, DVec3::Z].into_iter().chain(directions);
    let rated = all.map(|direction| (wide(direction), direction));
    rated
        .fold(
            (f64::MIN, at.along),
            |best, next| if next.0 > best.0 { next } else { best },
        )
        .1
}

fn saddle(space: &Space<'_>, near: DVec3, along: DVec3, reach: f64) -> Narrowest {
    let u = perpendicular(along);
    let v = along.cross(u);
    let widest = |from: DVec3| {
        let (mut place, mut clearance) = (from, space.clearance(from));
        let mut step = reach;
        for _ in 0..HALVINGS {
            let mut best = (place, clearance);
            for k in 0..AROUND {
                let angle = TAU * f64::from(k) / f64::from(AROUND);
                let at = place + (u * libm::cos(angle) + v * libm::sin(angle)) * step;
                let wide = space.clearance(at);
                if wide > best.1 && at.distance(from) <= 2.0 * reach {
                    best = (at, wide);
                }
            }
            if best.1 > clearance {
                (place, clearance) = best;
            } else {
                step *= 0.5;
            }
        }
        Narrowest {
            place,
            along,
            clearance,
        }
    };
    let mut least = widest(near);
    for direction in [-1.0, 1.0] {
        let mut at = widest(near);
        for _ in 0..PLACES {
            at = widest(at.place + along * (direction * reach / f64::from(PLACES)));
            if at.clearance < least.clearance {
                least = at;
            }
        }
    }
    least
}
