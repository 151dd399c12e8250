//! How well two kinds of grains are mixed, told by their neighbours: no cells are needed.
//!
//! Of all contacts between grains in the region, a share `u` joins two kinds. With the share `q` of contact ends at the kind,
//! chance gives `2 q (1 - q)`, whatever the sizes of the kinds, and
//!
//! ```text
//! contact index = u / (2 q (1 - q))
//! ```
//!
//! In the same way each of the `N` grains has its `k` nearest neighbours (distances of centres); with the share `p` of the kind by
//! number, chance gives unlike ones a share `2 p (1 - p) N/(N - 1)`. Across periodic sides a grain counts once, with its nearest image,
//! and is no neighbour of itself: the chance above is that of `N - 1` others. Both indices are 0 when the kinds are apart, up to their
//! border, 1 in the mean when chance alone mixed them, and larger where the kinds seek each other.

use super::told_first::{counting, each_in_order, own_pairs};
use super::{Selection, ToldColumn, Value};
use crate::particles::{Origins, Zone};
use crate::simulation::Simulation;
use glam::DVec3;
use rayon::prelude::*;

/// Most neighbours of a grain.
pub const MAX_NEAREST: u32 = 100;

/// Columns of neighbours.
pub const NEIGHBOUR_COLUMNS: &[ToldColumn] = &[
    ToldColumn::new("grain contacts", "", "contacts between two grains in the region"),
    ToldColumn::new("unlike contacts", "", "share of them that joins the kind with another"),
    ToldColumn::new(
        "contact index",
        "",
        "0 when the kinds are apart, 1 in the mean when chance alone mixed them; NaN without both",
    ),
    ToldColumn::new(
        "unlike neighbours",
        "",
        "share of the nearest neighbours that are of the other kind",
    ),
    ToldColumn::new("nearest index", "", "the same index of the nearest neighbours"),
];

/// How well a kind of grains is mixed with all others, told by neighbours.
#[derive(Clone, Debug, PartialEq)]
pub struct NeighbourMixing {
    /// Grains elsewhere do not count.
    pub zone: Zone,
    /// The kind.
    pub selection: Selection,
    /// Neighbours of each grain that are looked at.
    pub nearest: u32,
}

impl NeighbourMixing {
    /// Titles of its columns.
    pub fn titles(&self, name: &str) -> Vec<String> {
        NEIGHBOUR_COLUMNS.iter().map(|c| c.title(name)).collect()
    }

    /// Its values now, in the order of [`NEIGHBOUR_COLUMNS`].
    pub fn measure(&self, sim: &Simulation, origins: &Origins) -> Vec<Value> {
        let grains = &sim.grains;
        let is_in = counting(sim, &self.zone, &Selection::default(), origins);
        let is_kind = |g: usize| self.selection.holds(grains, origins, g);
        let (mut contacts, mut unlike, mut ends) = (0u64, 0u64, 0u64);
        for contact in own_pairs(sim) {
            let [Some(i), Some(j)] = contact.grains() else { continue };
            if is_in[i] && is_in[j] {
                let kinds = [i, j].map(is_kind);
                contacts += 1;
                unlike += u64::from(kinds[0] != kinds[1]);
                ends += u64::from(kinds[0]) + u64::from(kinds[1]);
            }
        }
        let [contacts, unlike, ends] = sim.together().counts([contacts, unlike, ends]);
        let share = unlike as f64 / contacts as f64;
        let q = ends as f64 / (2 * contacts) as f64;
        let mut places: Vec<(DVec3, bool)> = Vec::new();
        let tell = |g: usize| is_in[g].then(|| (sim.comm.wrapped(grains.position[g]), is_kind(g)));
        each_in_order(sim, tell, |place| places.push(place));
        let (near, near_index) = self.of_nearest(&places, &images(sim));
        vec![
            Value::Count(contacts),
            Value::Number(share),
            Value::Number(index(share, 2.0 * q * (1.0 - q))),
            Value::Number(near),
            Value::Number(near_index),
        ]
    }

    /// Share of unlike nearest neighbours, and the index of it.
    fn of_nearest(&self, places: &[(DVec3, bool)], images: &[DVec3]) -> (f64, f64) {
        let count = places.len();
        let nearest = (self.nearest as usize).min(count.saturating_sub(1));
        if nearest == 0 {
            return (f64::NAN, f64::NAN);
        }
        let tree = Tree::new(places.iter().map(|place| place.0).collect());
        let unlike: u64 = (0..count)
            .into_par_iter()
            .map(|g| {
                let near = tree.nearest(g, nearest, images);
                near.iter().filter(|other| places[**other].1 != places[g].1).count() as u64
            })
            .sum();
        let share = unlike as f64 / (count * nearest) as f64;
        let p = places.iter().filter(|place| place.1).count() as f64 / count as f64;
        let by_chance = 2.0 * p * (1.0 - p) * count as f64 / (count as f64 - 1.0);
        (share, index(share, by_chance))
    }
}

fn index(share: f64, by_chance: f64) -> f64 {
    if by_chance > 0.0 { share / by_chance } else { f64::NAN }
}

/// Shifts to the box and all images that touch it.
fn images(sim: &Simulation) -> Vec<DVec3> {
    let mut images = vec![DVec3::ZERO];
    for axis in 0..3 {
        if let Some(edge) = super::field::period(sim, axis) {
            let more: Vec<DVec3> = images.iter().flat_map(|shift| [*shift - edge, *shift + edge]).collect();
            images.extend(more);
        }
    }
    images
}

/// Points in a balanced tree of halves: the middle of every range divides it.
struct Tree {
    places: Vec<DVec3>,
    order: Vec<u32>,
    lower: DVec3,
    upper: DVec3,
}

impl Tree {
    fn new(places: Vec<DVec3>) -> Self {
        let mut order: Vec<u32> = (0..places.len() as u32).collect();
        sort_halves(&places, &mut order, 0);
        Self {
            lower: places.iter().fold(DVec3::INFINITY, |low, p| low.min(*p)),
            upper: places.iter().fold(DVec3::NEG_INFINITY, |high, p| high.max(*p)),
            places,
            order,
        }
    }

    /// The nearest other points, each by that of its images which is nearest, nearest first; of equals the one with the lower index.
    fn nearest(&self, point: usize, count: usize, images: &[DVec3]) -> Vec<usize> {
        let mut found: Vec<(f64, usize)> = Vec::with_capacity(count + 1);
        for shift in images {
            let place = self.places[point] + *shift;
            let outside = (self.lower - place).max(place - self.upper).max(DVec3::ZERO);
            if found.len() < count || outside.length_squared() <= found[count - 1].0 {
                self.visit(&self.order, 0, place, point, count, &mut found);
            }
        }
        found.into_iter().map(|near| near.1).collect()
    }

    fn visit(&self, range: &[u32], axis: usize, place: DVec3, own: usize, count: usize, found: &mut Vec<(f64, usize)>) {
        let Some((before, rest)) = range.split_at_checked(range.len() / 2) else {
            return;
        };
        let Some((&middle, behind)) = rest.split_first() else {
            return;
        };
        let middle = middle as usize;
        if own != middle {
            let entry = ((self.places[middle] - place).length_squared(), middle);
            let at = found.partition_point(|near| (near.0, near.1) < entry);
            let image = found.iter().position(|near| near.1 == middle);
            if at < count && image.is_none_or(|image| at <= image) {
                // the farther image makes room, or else the farthest neighbour
                if let Some(image) = image {
                    found.remove(image);
                }
                found.insert(at, entry);
                found.truncate(count);
            }
        }
        let away = place[axis] - self.places[middle][axis];
        let (first, second) = if away <= 0.0 {
            (before, behind)
        } else {
            (behind, before)
        };
        let next = (axis + 1) % 3;
        self.visit(first, next, place, own, count, found);
        if found.len() < count || away * away <= found[count - 1].0 {
            self.visit(second, next, place, own, count, found);
        }
    }
}

fn sort_halves(places: &[DVec3], order: &mut [u32], axis: usize) {
    if order.len() < 2 {
        return;
    }
    let middle = order.len() / 2;
    let key = |k: &u32| (places[*k as usize][axis], *k);
    order.select_nth_unstable_by(middle, |a, b| {
        let (a, b) = (key(a), key(b));
        a.0.total_cmp(&b.0).then(a.1.cmp(&b.1))
    });
    let (before, rest) = order.split_at_mut(middle);
    sort_halves(places, before, (axis + 1) % 3);
    sort_halves(places, &mut rest[1..], (axis + 1) % 3);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn numbers() -> impl FnMut() -> f64 {
        let mut x = 77u64;
        move || {
            x = x
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (x >> 11) as f64 / (1u64 << 53) as f64
        }
    }

    #[test]
    fn the_tree_finds_the_same_neighbours_as_a_look_at_all() {
        let mut next = numbers();
        let places: Vec<DVec3> = (0..200).map(|_| DVec3::new(next(), next(), next())).collect();
        let tree = Tree::new(places.clone());
        let images = [DVec3::ZERO, DVec3::X, DVec3::NEG_X];
        for point in 0..places.len() {
            let nearest_image = |k: usize| {
                let squares = images.map(|shift| (places[k] - places[point] - shift).length_squared());
                (squares.into_iter().fold(f64::INFINITY, f64::min), k)
            };
            let others = (0..places.len()).filter(|k| *k != point);
            let mut all: Vec<(f64, usize)> = others.map(nearest_image).collect();
            all.sort_by(|a, b| a.0.total_cmp(&b.0));
            let expected: Vec<usize> = all[..8].iter().map(|near| near.1).collect();
            assert_eq!(tree.nearest(point, 8, &images), expected);
        }
    }

    #[test]
    fn a_grain_is_no_neighbour_of_itself_and_another_counts_once() {
        let images: Vec<DVec3> = (-1..=1)
            .flat_map(|x| (-1..=1).map(move |y| DVec3::new(f64::from(x), f64::from(y), 0.0)))
            .collect();
        let of = |nearest: u32, places: &[(DVec3, bool)]| {
            let mixing = NeighbourMixing {
                zone: Zone::default(),
                selection: Selection::default(),
                nearest,
            };
            mixing.of_nearest(places, &images)
        };
        // across a box whose sides are shorter than the way to the other grain
        let two = [(DVec3::ZERO, true), (DVec3::new(0.5, 0.5, 2.0), false)];
        assert_eq!(of(1, &two), (1.0, 1.0));
        assert_eq!(of(6, &two), (1.0, 1.0));
        // more neighbours are asked for than there are: each of the others counts
        let three = [two[0], two[1], (DVec3::new(0.5, 0.0, 0.0), false)];
        let (share, index) = of(2, &three);
        assert!(
            (share - 2.0 / 3.0).abs() < 1e-15 && (index - 1.0).abs() < 1e-15,
            "{share} {index}"
        );
    }

    #[test]
    fn chance_gives_one_and_halves_apart_nearly_nothing() {
        let mut next = numbers();
        let mixing = NeighbourMixing {
            zone: Zone::default(),
            selection: Selection::default(),
            nearest: 6,
        };
        let places: Vec<DVec3> = (0..8000).map(|_| DVec3::new(next(), next(), next())).collect();
        let apart: Vec<(DVec3, bool)> = places.iter().map(|p| (*p, p.x < 0.3)).collect();
        let (_, index) = mixing.of_nearest(&apart, &[DVec3::ZERO]);
        assert!(index < 0.15, "{index}");
        let mixed: Vec<(DVec3, bool)> = places.iter().map(|p| (*p, next() < 0.3)).collect();
        let (_, index) = mixing.of_nearest(&mixed, &[DVec3::ZERO]);
        // one run scatters by about 1/sqrt(N k/2)/sqrt(2 p q)
        assert!((index - 1.0).abs() < 0.04, "{index}");
        assert!(mixing.of_nearest(&mixed[..1], &[DVec3::ZERO]).1.is_nan());
    }
}
