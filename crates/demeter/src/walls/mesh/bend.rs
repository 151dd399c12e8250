//! One contact in place of several that have nearly the same direction.
//!
//! A sphere of radius `r` that overlaps by `d_i` at points with normals `n_i` is free of all of them at places `x + p` with `n_i . p >= d_i`. The
//! shortest such `p` tells the contact: its length is the overlap, its direction the normal. Where one point alone is overlapped so deeply that
//! all others are left with it, it is that of this point. In a concave bend it turns from the normal of one side to that of the other without a
//! jump, and as `p` leads to the nearest point of a convex set, forces along it that follow from its length have a potential: a grain
//! comes to rest in the bend, and gains no energy on a way around.
//!
//! At edges and on round walls `n_i` turns on the way, and that holds for the nearest place only where nothing is overlapped any more. Newton's
//! method finds it: the same again with the overlaps that are seen from where the way led.

use crate::walls::SurfaceContact;
use glam::DVec3;

/// Sines below this are none: of normals so close to each other one is asked.
const PARALLEL: f64 = 1e-6;
/// Times that a way out of what is not flat is looked for anew, and the share of it by which the last may change it.
const MOST_TURNS: usize = 8;
const FOUND: f64 = 1e-11;
/// Share of an overlap that rounding may leave.
const ROUNDING: f64 = 1e-12;
/// The same of a way that is out.
const LEFT: f64 = 1e-7;
/// Sine up to which of two overlaps the deeper alone counts: files round, so that triangles of one plane lie in several.
const SAME_PLANE: f64 = 1e-4;

/// The shortest way out of several overlaps.
pub(super) struct WayOut {
    /// The way [m].
    pub(super) way: DVec3,
    /// Which overlaps hold it, by their numbers; those behind the first `count` mean nothing.
    holding: [usize; 3],
    count: usize,
}

/// How deep a sphere overlaps at a point [m], the unit normal there, and the element of the surface.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Overlap {
    pub(super) depth: f64,
    pub(super) normal: DVec3,
    pub(super) element: u32,
}

impl Overlap {
    /// That of a sphere of some radius [m] at a contact.
    pub(super) fn of(contact: &SurfaceContact, radius: f64) -> Self {
        Self {
            depth: radius - contact.distance,
            normal: contact.normal,
            element: contact.element,
        }
    }

    /// What is left of it on a way [m].
    fn left_on(&self, way: DVec3) -> f64 {
        self.depth - self.normal.dot(way)
    }
}

impl WayOut {
    /// Out of several overlaps, the largest first.
    pub(super) fn of(overlaps: &[Overlap]) -> Self {
        let mut out = Self {
            way: overlaps.first().map_or(DVec3::ZERO, |first| first.depth * first.normal),
            holding: [0; 3],
            count: overlaps.len().min(1),
        };
        // each turn makes the way longer, so no set of overlaps holds it twice
        for _ in 0..4 * overlaps.len() {
            let length = out.way.length();
            let worst = out
                .left(overlaps, ROUNDING * length)
                .max_by(|a, b| a.1.total_cmp(&b.1).then(b.0.cmp(&a.0)));
            let Some(next) = worst.and_then(|(worst, _)| out.with(worst, overlaps)) else {
                break;
            };
            out = next;
        }
        out
    }

    /// Out of several overlaps, the largest first, of which `seen` tells how deep one is, by its number, and its normal where a way has led; nothing of
    /// one that is flat.
    pub(super) fn curved(overlaps: &mut [Overlap], seen: impl Fn(usize, DVec3) -> Option<(f64, DVec3)>) -> Self {
        let mut out = Self::of(overlaps);
        for _ in 0..MOST_TURNS {
            let way = out.way;
            for (k, overlap) in overlaps.iter_mut().enumerate() {
                if let Some((depth, normal)) = seen(k, way) {
                    (overlap.depth, overlap.normal) = (depth + normal.dot(way), normal);
                }
            }
            out = Self::of(overlaps);
            if (out.way - way).length() <= FOUND * way.length() {
                break;
            }
        }
        out
    }

    /// The numbers of overlaps of which it leaves more than some length [m], with that.
    fn left(&self, overlaps: &[Overlap], most: f64) -> impl Iterator<Item = (usize, f64)> {
        let left = overlaps.iter().map(|overlap| overlap.left_on(self.way)).enumerate();
        left.filter(move |&(k, left)| left > most && !is_behind(k, overlaps))
    }

    /// Whether it leads out of all, the deepest first, and is no longer than so many times the depth of that.
    pub(super) fn leads_out_of(&self, overlaps: &[Overlap], most: f64) -> bool {
        let length = self.way.length();
        let is_short = overlaps.first().is_none_or(|first| length <= most * first.depth);
        is_short && self.left(overlaps, LEFT * length).next().is_none()
    }

    /// Which overlaps hold it.
    pub(super) fn holding(&self) -> &[usize] {
        &self.holding[..self.count]
    }

    /// The shortest way out of those that held it and of a new one.
    fn with(&self, new: usize, overlaps: &[Overlap]) -> Option<Self> {
        let old = self.holding();
        let mut best: Option<Self> = None;
        for pick in 0..1 << old.len() {
            let mut out = Self {
                way: DVec3::ZERO,
                holding: [new; 3],
                count: 1,
            };
            for k in (0..old.len()).filter(|k| pick >> k & 1 != 0) {
                if out.count < 3 {
                    out.holding[out.count] = old[k];
                    out.count += 1;
                }
            }
            let Some(way) = held(out.holding().iter().map(|&k| overlaps[k])) else {
                continue;
            };
            out.way = way;
            let is_out = |k: &usize| out.holding().contains(k) || overlaps[*k].left_on(way) <= ROUNDING * way.length();
            let is_shorter = best.as_ref().is_none_or(|best| way.length() < best.way.length());
            if is_shorter && old.iter().all(is_out) {
                best = Some(out);
            }
        }
        best
    }
}

/// Whether another overlap of the same plane is deeper, or as deep and comes first.
fn is_behind(k: usize, overlaps: &[Overlap]) -> bool {
    let one = overlaps[k];
    let is_before = |(j, other): (usize, &Overlap)| {
        let is_deeper = other.depth > one.depth || other.depth == one.depth && j < k;
        is_deeper
            && other.normal.dot(one.normal) > 0.0
            && other.normal.cross(one.normal).length_squared() < SAME_PLANE * SAME_PLANE
    };
    overlaps.iter().enumerate().any(is_before)
}

/// The shortest way with `n . p = d` for up to three overlaps; nothing where one of them would have to pull.
///
/// One after the other adds what the way so far leaves of it, at right angles to those before. So an error of rounding grows with one over the sine
/// between them, where the products of normals have that of its square.
fn held(overlaps: impl Iterator<Item = Overlap>) -> Option<DVec3> {
    let mut way = DVec3::ZERO;
    // normals, each with its part at right angles to those before and the square of the length of that
    let mut held = [(DVec3::ZERO, DVec3::ZERO, 1.0); 3];
    let mut count = 0;
    for overlap in overlaps {
        let across = |rest: DVec3, &(_, own, square): &(DVec3, DVec3, f64)| rest - rest.dot(own) / square * own;
        let own = held[..count].iter().fold(overlap.normal, across);
        let square = own.length_squared();
        if square <= PARALLEL * PARALLEL {
            return None;
        }
        way += overlap.left_on(way) / square * own;
        held[count] = (overlap.normal, own, square);
        count += 1;
    }
    // the last pushes alone along its own part, the one before along its own with what is left then
    let mut rest = way;
    held[..count]
        .iter()
        .rev()
        .all(|(normal, own, square)| {
            let push = rest.dot(*own) / square;
            rest -= push * normal;
            push >= 0.0
        })
        .then_some(way)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn turned(degrees: f64) -> DVec3 {
        let angle = degrees.to_radians();
        DVec3::new(libm::sin(angle), 0.0, libm::cos(angle))
    }

    fn overlaps<const N: usize>(of: [(f64, DVec3); N]) -> [Overlap; N] {
        of.map(|(depth, normal)| Overlap {
            depth,
            normal,
            element: 0,
        })
    }

    #[test]
    fn alone_the_deepest_counts() {
        let (a, b) = (turned(0.0), turned(20.0));
        let out = WayOut::of(&overlaps([(1.0, a), (0.93, b)]));
        assert_eq!(out.way, a);
        assert_eq!(out.holding(), [0]);
    }

    #[test]
    fn in_the_middle_of_a_bend_the_way_leads_between_the_sides() {
        let out = WayOut::of(&overlaps([(1.0, turned(-10.0)), (1.0, turned(10.0))]));
        let middle = DVec3::Z / libm::cos(10f64.to_radians());
        assert!((out.way - middle).length() < 1e-12, "{}", out.way);
        assert_eq!(out.holding().len(), 2);
    }

    #[test]
    fn facets_of_a_pole_are_all_left() {
        // the tip of a ball of 32 and of 96 facets around, and places beside the planes where two are as deep
        for count in [32, 96] {
            let turn = std::f64::consts::TAU / f64::from(count);
            let normal = |k: u32| {
                let angle = f64::from(k) * turn;
                let (sine, cosine) = (libm::sin(0.5 * turn), libm::cos(0.5 * turn));
                DVec3::new(sine * libm::cos(angle), sine * libm::sin(angle), cosine)
            };
            for n in 0..200 {
                let angle = (f64::from(n % 20) + 0.5) * turn + 1e-6 * f64::from(n / 20);
                let place = 1e-3 * f64::from(1 + n % 7) * DVec3::new(libm::cos(angle), libm::sin(angle), 0.0);
                let mut all: Vec<Overlap> = (0..count)
                    .map(|k| Overlap {
                        depth: 0.02 - normal(k).dot(place),
                        normal: normal(k),
                        element: k,
                    })
                    .collect();
                all.sort_by(|a, b| b.depth.total_cmp(&a.depth));
                let out = WayOut::of(&all);
                let most = all.iter().map(|one| one.left_on(out.way)).fold(0.0, f64::max);
                assert!(
                    most <= 1e-12 * out.way.length(),
                    "{count} {n}: {most:e} of {:?}",
                    out.holding()
                );
            }
        }
    }

    #[test]
    fn the_way_is_the_shortest_out_of_all() {
        // a shallow pyramid of eight sides, upside down, and a grain anywhere near its tip
        let sides = [0, 1, 2, 3, 4, 5, 6, 7].map(|k| {
            let angle = f64::from(k) * std::f64::consts::FRAC_PI_4;
            DVec3::new(0.15 * libm::cos(angle), 0.15 * libm::sin(angle), 1.0).normalize()
        });
        let mut held_by = [0; 4];
        for (x, y) in [(0.0, 0.0), (0.01, 0.003), (-0.05, 0.02), (0.2, -0.3), (0.0, 1.0)] {
            let place = DVec3::new(x, y, 0.9);
            let mut all = overlaps(sides.map(|n| (1.0 - n.dot(place), n)));
            all.sort_by(|a, b| b.depth.total_cmp(&a.depth));
            let out = WayOut::of(&all);
            held_by[out.holding().len()] += 1;
            for one in &all {
                assert!(one.left_on(out.way) <= 1e-12, "{place}: {}", out.way);
            }
            // Hildreth's iteration comes to the same
            let mut pushes = [0.0; 8];
            let way = |pushes: &[f64; 8]| {
                all.iter()
                    .zip(pushes)
                    .map(|(one, push)| *push * one.normal)
                    .sum::<DVec3>()
            };
            for _ in 0..20_000 {
                for k in 0..8 {
                    pushes[k] = f64::max(0.0, pushes[k] + all[k].left_on(way(&pushes)));
                }
            }
            assert!((out.way - way(&pushes)).length() < 1e-7, "{place}: {}", out.way);
        }
        assert!(held_by[1] > 0 && held_by[2] + held_by[3] > 1, "{held_by:?}");
    }
}
