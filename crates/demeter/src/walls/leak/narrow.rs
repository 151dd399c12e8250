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

/// Times that a way is looked at, more and more finely where it is narrowest.
const LOOKS: u32 = 6;
/// Points before and behind that place which are looked at again.
const BESIDE: usize = 4;
/// How far points are apart at first where the way is narrow, in radii; half as far in each look.
const APART: f64 = 0.5;
/// Most halvings of the way between two points in one look.
const MOST_HALVINGS: u32 = 12;
/// Times that all points are moved.
const SWEEPS: u32 = 6;
/// Halvings of the step in each.
const FEW_HALVINGS: u32 = 4;

/// Directions that are tried for the way through.
const DIRECTIONS: u32 = 200;
/// Tilts of the best of them, each half of the one before, the first [rad].
const TILTS: u32 = 6;
const TILT: f64 = 0.15;
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

/// From a point near the narrowest place of a way that is not known, looks up and down the way, and at each place across it for the
/// widest point: of these the least is the saddle of the clearance. `reach` is how far off the point may be [m]. The way is looked for
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

/// The narrowest place of a way through these points, which is pulled to where it is widest before and round that place. The points go
/// across the way only, and not where it would be narrower between them: so none leaves the way for a wider one beside it, as there is
/// round a corner.
pub(super) fn narrowest_along(space: &Space<'_>, way: &[DVec3]) -> Option<Narrowest> {
    let mut way = way.to_vec();
    let mut apart = APART * space.radius;
    for look in 0..LOOKS {
        if look > 0 {
            let at = least(space, &way)?;
            let (from, to) = (at.saturating_sub(BESIDE), (at + BESIDE).min(way.len() - 1));
            way = way[from..=to].to_vec();
        }
        way = refined(space, way, apart);
        widen(space, &mut way, look == 0);
        apart *= 0.5;
    }
    let at = least(space, &way)?;
    let found = Narrowest {
        place: way[at],
        along: tangent(&way, at).unwrap_or(DVec3::Z),
        clearance: space.clearance(way[at]),
    };
    Some(Narrowest {
        along: widening(space, &found),
        ..found
    })
}

/// Where a way is narrowest; of equally narrow places the last.
fn least(space: &Space<'_>, way: &[DVec3]) -> Option<usize> {
    let width = |k: usize| width(space, way, k, way[k]);
    (0..way.len()).rev().min_by(|&a, &b| width(a).total_cmp(&width(b)))
}

/// Clearance at a place that a point of a way is moved to, or half of the way to its neighbours where that is less.
fn width(space: &Space<'_>, way: &[DVec3], point: usize, place: DVec3) -> f64 {
    let neighbours = [point.checked_sub(1), Some(point + 1)].into_iter().flatten();
    let between = neighbours
        .filter_map(|k| way.get(k))
        .map(|next| space.clearance(place.midpoint(*next)));
    between.fold(space.clearance(place), f64::min)
}

/// The way with more points where it might be narrower between two than at any, until those are this much apart [m].
fn refined(space: &Space<'_>, mut way: Vec<DVec3>, apart: f64) -> Vec<DVec3> {
    for _ in 0..MOST_HALVINGS {
        let clearances: Vec<f64> = way.iter().map(|&place| space.clearance(place)).collect();
        let least = clearances.iter().copied().fold(f64::INFINITY, f64::min);
        let mut finer = Vec::with_capacity(2 * way.len());
        for (ends, there) in way.windows(2).zip(clearances.windows(2)) {
            let length = ends[0].distance(ends[1]);
            finer.push(ends[0]);
            // the clearance changes by no more than the way between two points
            if length > apart && there[0] + there[1] - length < 2.0 * least {
                finer.push(ends[0].midpoint(ends[1]));
            }
        }
        finer.extend(way.last());
        let is_fine = finer.len() == way.len();
        way = finer;
        if is_fine {
            break;
        }
    }
    way
}

fn tangent(way: &[DVec3], at: usize) -> Option<DVec3> {
    let (before, behind) = (at.saturating_sub(1), (at + 1).min(way.len() - 1));
    (way[behind] - way[before]).try_normalize()
}

/// Moves every point across the way to where it is wider, and ends that are to move anywhere; again and again, by less than the points
/// are apart and never through a wall.
fn widen(space: &Space<'_>, way: &mut [DVec3], ends_too: bool) {
    for _ in 0..SWEEPS {
        for k in 0..way.len() {
            let is_end = k == 0 || k + 1 == way.len();
            let Some(along) = tangent(way, k).filter(|_| ends_too || !is_end) else {
                continue;
            };
            let u = perpendicular(along);
            let v = along.cross(u);
            let across = (0..AROUND).map(|side| {
                let angle = TAU * f64::from(side) / f64::from(AROUND);
                u * libm::cos(angle) + v * libm::sin(angle)
            });
            let out = [along, -along].into_iter().filter(|_| is_end);
            let directions: Vec<DVec3> = across.chain(out).collect();
            let (mut place, mut best) = (way[k], width(space, way, k, way[k]));
            let apart = way[k.saturating_sub(1)].distance(way[(k + 1).min(way.len() - 1)]);
            let mut step = space.clearance(place).min(0.25 * apart);
            for _ in 0..FEW_HALVINGS {
                let from = place;
                for direction in &directions {
                    let at = from + *direction * step;
                    let found = width(space, way, k, at);
                    if found > best {
                        (place, best) = (at, found);
                    }
                }
                step *= 0.5;
            }
            way[k] = place;
        }
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
    let mut best = rated.fold(
        (f64::MIN, at.along),
        |best, next| if next.0 > best.0 { next } else { best },
    );
    let mut tilt = TILT;
    for _ in 0..TILTS {
        let u = perpendicular(best.1);
        let v = best.1.cross(u);
        let from = best.1;
        for k in 0..AROUND {
            let angle = TAU * f64::from(k) / f64::from(AROUND);
            let direction = (from + (u * libm::cos(angle) + v * libm::sin(angle)) * tilt).normalize();
            let found = wide(direction);
            if found > best.0 {
                best = (found, direction);
            }
        }
        tilt *= 0.5;
    }
    best.1
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
