//! Parts of a closed surface, and which way each of them faces.
//!
//! A part is what hangs together: triangles at an edge of two belong to one part, and where more meet, those that only together pass the
//! edge as often one way as the other. Files draw some parts inside out. So a part that lies in no other is turned outwards, and with it
//! what lies in it: what faces the other way there is a hole. A part that only crosses others, or touches them from outside, is none.

use super::interior::Corner;
use glam::DVec3;
use std::collections::HashMap;

/// How far from a triangle it is asked on which side of other parts it lies, in steps of the lattice: a part that shares faces with the
/// one around it lies in it, too, where corners are off by the rounding of single precision.
const BESIDE: f64 = 256.0;

/// A side of a triangle: its ends in order, whether it runs from the first to the second, and the triangle.
pub(super) type TriangleSide = ([Corner; 2], bool, u32);

/// All sides of triangles, those of one edge in a row.
pub(super) fn sides(triangles: &[[Corner; 3]]) -> Vec<TriangleSide> {
    let mut sides: Vec<TriangleSide> = (triangles.iter().zip(0u32..))
        .flat_map(|([a, b, c], k)| [[*a, *b], [*b, *c], [*c, *a]].map(|[a, b]| ([a.min(b), a.max(b)], a < b, k)))
        .filter(|([a, b], ..)| a != b)
        .collect();
    sides.sort_unstable();
    sides
}

/// Which triangles are to be turned around, told all sides and which triangles a ray upwards from a place crosses: 1 from the back of each,
/// -1 from its front.
pub(super) fn to_turn(
    triangles: &[[Corner; 3]],
    sides: &[TriangleSide],
    crossed: impl Fn(Corner) -> Vec<(u32, i64)>,
) -> Vec<bool> {
    let (part, count) = parts(triangles.len(), sides);
    let mut volumes = vec![0i128; count];
    for (triangle, part) in triangles.iter().zip(&part) {
        volumes[*part] += six_volumes(triangle);
    }
    let mut all = Parts {
        triangles,
        members: vec![Vec::new(); count],
        part: &part,
        volumes: &volumes,
        crossed,
    };
    for (k, part) in part.iter().enumerate() {
        all.members[*part].push(k);
    }
    // what is around a part is larger
    let mut order: Vec<usize> = (0..count).collect();
    order.sort_by_key(|&k| (std::cmp::Reverse(volumes[k].abs()), k));
    let mut is_inwards = vec![false; count];
    for &k in &order {
        is_inwards[k] = match all.around(k) {
            Some(outer) => is_inwards[outer],
            None => volumes[k] < 0,
        };
    }
    part.into_iter().map(|part| is_inwards[part]).collect()
}

/// Part of every triangle, counted from 0, and the number of parts.
fn parts(count: usize, sides: &[TriangleSide]) -> (Vec<usize>, usize) {
    let mut above: Vec<usize> = (0..count).collect();
    let of_each = || sides.chunk_by(|a, b| a.0 == b.0);
    for same in of_each() {
        if let [(_, _, first), (_, _, second)] = same {
            join(&mut above, *first as usize, *second as usize);
        }
    }
    for same in of_each().filter(|same| same.len() > 2) {
        let mut passes: Vec<(usize, i64)> = Vec::new();
        for &(_, forward, triangle) in same {
            let part = root(&mut above, triangle as usize);
            add(&mut passes, part, if forward { 1 } else { -1 });
        }
        let mut torn = passes.iter().filter(|pass| pass.1 != 0);
        if let Some(first) = torn.next() {
            torn.for_each(|pass| join(&mut above, first.0, pass.0));
        }
    }
    let mut numbers: HashMap<usize, usize> = HashMap::new();
    let part = (0..count).map(|k| {
        let (root, next) = (root(&mut above, k), numbers.len());
        *numbers.entry(root).or_insert(next)
    });
    let part = part.collect();
    (part, numbers.len())
}

fn root(above: &mut [usize], mut k: usize) -> usize {
    while above[k] != k {
        above[k] = above[above[k]];
        k = above[k];
    }
    k
}

fn join(above: &mut [usize], one: usize, other: usize) {
    let (one, other) = (root(above, one), root(above, other));
    above[one.max(other)] = one.min(other);
}

fn add<K: PartialEq>(sums: &mut Vec<(K, i64)>, key: K, value: i64) {
    match sums.iter_mut().find(|sum| sum.0 == key) {
        Some(sum) => sum.1 += value,
        None => sums.push((key, value)),
    }
}

/// Six times the volume between the origin and a triangle; 2^29 triangles are too few for the sum to overflow.
fn six_volumes([a, b, c]: &[Corner; 3]) -> i128 {
    let [a, b, c] = [a, b, c].map(|corner| corner.map(i128::from));
    a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])
}

struct Parts<'a, F> {
    triangles: &'a [[Corner; 3]],
    /// Triangles of every part.
    members: Vec<Vec<usize>>,
    /// Part of every triangle.
    part: &'a [usize],
    /// Six times what each encloses, negative where it faces inwards.
    volumes: &'a [i128],
    crossed: F,
}

impl<F: Fn(Corner) -> Vec<(u32, i64)>> Parts<'_, F> {
    /// The smallest part that holds all of another; of two with the same volume the first counts as the larger.
    fn around(&self, inner: usize) -> Option<usize> {
        if self.members.len() == 1 || self.volumes[inner] == 0 {
            return None;
        }
        let size = |k: usize| (self.volumes[k].abs(), std::cmp::Reverse(k));
        let mut outer: Option<Vec<usize>> = None;
        for place in self.places_beside(inner, false) {
            let around = self.windings(place);
            let holds = |k: usize| around.iter().any(|(part, turns)| *part == k && *turns != 0);
            if !holds(inner) {
                continue;
            }
            match &mut outer {
                Some(outer) => outer.retain(|k| holds(*k)),
                None => {
                    let others = around.iter().map(|(part, _)| *part);
                    outer = Some(others.filter(|&k| holds(k) && size(k) > size(inner)).collect());
                }
            }
            if outer.as_ref().is_some_and(Vec::is_empty) {
                return None;
            }
        }
        let mut outer = outer?;
        outer.sort_by_key(|&k| size(k));
        outer.into_iter().find(|&k| !self.is_pierced(inner, k))
    }

    /// Whether a place beside the outer part, which does not hold it, lies in the inner one.
    fn is_pierced(&self, inner: usize, outer: usize) -> bool {
        let corners = || self.members[inner].iter().flat_map(|&k| self.triangles[k]);
        let bounds = [0, 1, 2].map(|axis| {
            let along = || corners().map(|corner| corner[axis]);
            (along().min().unwrap_or(0), along().max().unwrap_or(0))
        });
        let is_near = |place: &Corner| (0..3).all(|k| place[k] >= bounds[k].0 && place[k] <= bounds[k].1);
        self.places_beside(outer, true).filter(is_near).any(|place| {
            let around = self.windings(place);
            let holds = |k: usize| around.iter().any(|(part, turns)| *part == k && *turns != 0);
            holds(inner) && !holds(outer)
        })
    }

    /// Places beside the middle and the corners of every triangle of a part, outside of it or inside.
    fn places_beside(&self, part: usize, outside: bool) -> impl Iterator<Item = Corner> {
        let out = if (self.volumes[part] < 0) == outside {
            -BESIDE
        } else {
            BESIDE
        };
        self.members[part].iter().flat_map(move |&k| {
            let [a, b, c] = self.triangles[k].map(|corner| DVec3::from_array(corner.map(|x| x as f64)));
            let shift = (b - a).cross(c - a).normalize_or_zero() * out;
            let middle = (a + b + c) / 3.0;
            [middle, a.lerp(middle, 0.03), b.lerp(middle, 0.03), c.lerp(middle, 0.03)]
                .map(|place| (place + shift).round().to_array().map(|x| x as i64))
        })
    }

    /// How often each part winds around a place.
    fn windings(&self, place: Corner) -> Vec<(usize, i64)> {
        let mut windings = Vec::new();
        for (triangle, turn) in (self.crossed)(place) {
            add(&mut windings, self.part[triangle as usize], turn);
        }
        windings
    }
}
