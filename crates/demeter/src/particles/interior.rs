//! The inside of a closed surface of triangles.
//!
//! Corners are put on a lattice of whole numbers, 2^-30 of the size of the mesh apart, and a point too: then all tests are
//! exact. A point is inside when the surface winds around it: when a ray upwards from it meets other numbers of fronts and of backs, once
//! the parts face outwards (`parts.rs`). So parts
//! that overlap are one body, and a part inside another that faces the other way is a hole in it. Where triangles do not agree on their
//! front, the ray must cross the surface an odd number of times. Where the ray would meet an
//! edge or a corner, or the point lies on the surface, the point counts as moved by an amount smaller than any other: first
//! upwards, then along x, then along y (simulation of simplicity, H. Edelsbrunner and E. P. Mücke, ACM Trans. Graph. 9 (1990)
//! 66). So every point is inside or outside, and interiors that share a face share no point.

use super::parts::{TriangleSide, sides, to_turn};
use glam::DVec3;
use thiserror::Error;

/// Steps of the lattice along the longest side of the mesh.
const STEPS: f64 = (1u64 << 30) as f64;
/// Most columns along x and along y.
const MOST_COLUMNS: usize = 1024;
/// Places along each axis at which is asked whether parts overlap, and at which their volume is counted out then.
const COARSE: usize = 24;
const FINE: usize = 128;

/// Why triangles enclose nothing.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum InteriorError {
    /// There is no triangle, or a corner is not finite, or all lie in one point.
    #[error("the mesh has no size: its corners reach from {lower} to {upper}")]
    NoSize {
        /// Lower corner of its bounds [m].
        lower: DVec3,
        /// Upper corner [m].
        upper: DVec3,
    },
    /// Edges with an odd number of triangles.
    #[error(
        "the mesh is not closed, so that it has no inside: {count} edges belong to an odd number of triangles, one of them \
         from {start} to {end}; close the hole in the program that drew it"
    )]
    Open {
        /// Their number.
        count: usize,
        /// Start of the first [m].
        start: DVec3,
        /// Its end [m].
        end: DVec3,
    },
}

/// A place on the lattice.
pub(super) type Corner = [i64; 3];

/// The inside of a closed mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct Interior {
    lower: DVec3,
    upper: DVec3,
    /// Lattice steps per metre.
    scale: f64,
    triangles: Vec<[Corner; 3]>,
    /// Which of them were turned around, so that parts face outwards.
    turned: Vec<bool>,
    /// Number of columns along x and y.
    columns: [usize; 2],
    /// Triangles over column `c`: `over[start[c]..start[c + 1]]`.
    start: Vec<u32>,
    over: Vec<u32>,
    /// Whether triangles agree on their front across every edge.
    is_oriented: bool,
    volume: f64,
    parts_overlap: bool,
}

impl Interior {
    /// The inside of triangles, told by their corners [m]; joined corners are the same point.
    pub fn new(triangles: &[[DVec3; 3]]) -> Result<Self, InteriorError> {
        let corners = || triangles.iter().flatten();
        let lower = corners().fold(DVec3::INFINITY, |low, c| low.min(*c));
        let upper = corners().fold(DVec3::NEG_INFINITY, |high, c| high.max(*c));
        let longest = (upper - lower).max_element();
        let scale = STEPS / longest;
        let is_finite = corners().all(|c| c.is_finite());
        if !(is_finite && longest > 0.0 && scale.is_finite()) {
            return Err(InteriorError::NoSize { lower, upper });
        }
        let mut interior = Self {
            lower,
            upper,
            scale,
            triangles: Vec::new(),
            turned: Vec::new(),
            columns: [1; 2],
            start: Vec::new(),
            over: Vec::new(),
            is_oriented: false,
            volume: 0.0,
            parts_overlap: false,
        };
        interior.triangles = triangles.iter().map(|t| t.map(|c| interior.on_lattice(c))).collect();
        let sides = sides(&interior.triangles);
        interior.is_oriented = interior.check_closed(&sides)?;
        interior.sort_into_columns();
        interior.turned = match interior.is_oriented {
            true => to_turn(&interior.triangles, &sides, |p| interior.crossed(p).collect()),
            false => vec![false; triangles.len()],
        };
        for (triangle, _) in interior
            .triangles
            .iter_mut()
            .zip(&interior.turned)
            .filter(|both| *both.1)
        {
            triangle.swap(1, 2);
        }
        interior.parts_overlap = interior.is_oriented && interior.has_overlaps();
        interior.volume = interior.volume_within(triangles);
        Ok(interior)
    }

    fn on_lattice(&self, p: DVec3) -> Corner {
        let steps = ((p - self.lower) * self.scale).round();
        [steps.x as i64, steps.y as i64, steps.z as i64]
    }

    /// Whether triangles agree on their front: whether each edge is passed as often one way as the other.
    fn check_closed(&self, sides: &[TriangleSide]) -> Result<bool, InteriorError> {
        let of_each = || sides.chunk_by(|a, b| a.0 == b.0);
        let odd: Vec<&[Corner; 2]> = of_each()
            .filter(|same| same.len() % 2 == 1)
            .filter_map(|same| Some(&same.first()?.0))
            .collect();
        let Some(first) = odd.first() else {
            let forwards = |same: &[TriangleSide]| same.iter().filter(|side| side.1).count();
            return Ok(of_each().all(|same| 2 * forwards(same) == same.len()));
        };
        let [start, end] = first.map(|c| self.lower + DVec3::from_array(c.map(|x| x as f64)) / self.scale);
        Err(InteriorError::Open {
            count: odd.len(),
            start,
            end,
        })
    }

    /// Sorts the triangles into columns, as many as keep the lists short.
    fn sort_into_columns(&mut self) {
        let mut side = (self.triangles.len() as f64).sqrt().ceil() as usize;
        side = side.clamp(1, MOST_COLUMNS);
        let most = 16 * self.triangles.len() + MOST_COLUMNS;
        let entries = |interior: &Self| -> usize {
            let count = |t: &[Corner; 3]| {
                let [x, y] = interior.columns_under(t);
                (x.1 - x.0) * (y.1 - y.0)
            };
            interior.triangles.iter().map(count).sum()
        };
        loop {
            self.columns = [side; 2];
            if side == 1 || entries(self) <= most {
                break;
            }
            side = side.div_ceil(2);
        }
        let mut lists: Vec<Vec<u32>> = vec![Vec::new(); side * side];
        for (k, triangle) in self.triangles.iter().enumerate() {
            let [x, y] = self.columns_under(triangle);
            for j in y.0..y.1 {
                for list in &mut lists[j * side + x.0..j * side + x.1] {
                    list.push(k as u32);
                }
            }
        }
        self.start = vec![0];
        for list in lists {
            self.over.extend(list);
            self.start.push(self.over.len() as u32);
        }
    }

    fn column(&self, axis: usize, x: i64) -> usize {
        // the lattice has STEPS + 1 places
        let width = (STEPS as i64 + 1).div_euclid(self.columns[axis] as i64) + 1;
        (x / width).clamp(0, self.columns[axis] as i64 - 1) as usize
    }

    fn columns_under(&self, triangle: &[Corner; 3]) -> [(usize, usize); 2] {
        [0, 1].map(|axis| {
            let x = triangle.map(|corner| corner[axis]);
            let (least, most) = (x[0].min(x[1]).min(x[2]), x[0].max(x[1]).max(x[2]));
            (self.column(axis, least), self.column(axis, most) + 1)
        })
    }

    /// Whether a point lies inside. A point that is not finite does not.
    pub fn contains(&self, p: DVec3) -> bool {
        if !(p.cmpge(self.lower).all() && p.cmple(self.upper).all()) {
            return false;
        }
        self.winding(p) != 0
    }

    /// How often the surface winds around a point within its bounds; 1 inside and 0 outside where triangles do not agree on their front.
    fn winding(&self, p: DVec3) -> i64 {
        let crossings = self.crossed(self.on_lattice(p)).map(|(_, turn)| turn);
        match self.is_oriented {
            true => crossings.sum(),
            false => crossings.count() as i64 % 2,
        }
    }

    /// Triangles that a ray upwards from a place crosses: 1 from the back of each, -1 from its front.
    fn crossed(&self, p: Corner) -> impl Iterator<Item = (u32, i64)> {
        let column = self.column(1, p[1]) * self.columns[0] + self.column(0, p[0]);
        let over = &self.over[self.start[column] as usize..self.start[column + 1] as usize];
        let crossings = over.iter().map(move |&t| (t, crossing(&self.triangles[t as usize], p)));
        crossings.filter(|(_, turn)| *turn != 0)
    }

    /// Volume inside [m^3]: exact where no parts overlap, else counted out.
    fn volume_within(&self, triangles: &[[DVec3; 3]]) -> f64 {
        if !self.parts_overlap {
            return enclosed(&self.outwards(triangles), 0.5 * (self.lower + self.upper));
        }
        let inside = self.places(FINE).filter(|p| self.winding(*p) != 0).count();
        (self.upper - self.lower).element_product() * inside as f64 / (FINE * FINE * FINE) as f64
    }

    /// Whether the surface winds by unlike numbers around places inside of it.
    fn has_overlaps(&self) -> bool {
        let windings = self.places(COARSE).map(|p| self.winding(p));
        let (least, most) = windings.fold((0, 0), |(least, most), turns| (turns.min(least), turns.max(most)));
        most - least > 1
    }

    /// Places spread over the box around it, so many along each axis [m].
    fn places(&self, count: usize) -> impl Iterator<Item = DVec3> {
        let (lower, size) = (self.lower, self.upper - self.lower);
        (0..count * count * count).map(move |k| {
            let at = [k % count, k / count % count, k / (count * count)].map(|k| (k as f64 + 0.5) / count as f64);
            lower + size * DVec3::from_array(at)
        })
    }

    /// The triangles that it was made of, turned so that their parts face outwards and holes into themselves; as they came where they do
    /// not agree on their front.
    pub fn outwards(&self, triangles: &[[DVec3; 3]]) -> Vec<[DVec3; 3]> {
        let turned = triangles.iter().zip(&self.turned);
        turned
            .map(|(&[a, b, c], turned)| if *turned { [a, c, b] } else { [a, b, c] })
            .collect()
    }

    /// Whether parts have places in common, beside those in which one is a hole.
    pub fn parts_overlap(&self) -> bool {
        self.parts_overlap
    }

    /// Smallest box along the axes around it [m].
    pub fn bounds(&self) -> (DVec3, DVec3) {
        (self.lower, self.upper)
    }

    /// Its volume, where the triangles agree on their front [m^3]; what parts overlap counts once.
    pub fn volume(&self) -> f64 {
        self.volume
    }
}

/// Volume that triangles enclose, what parts overlap counted for each [m^3].
fn enclosed(triangles: &[[DVec3; 3]], middle: DVec3) -> f64 {
    let six = |[a, b, c]: &[DVec3; 3]| (*a - middle).dot((*b - middle).cross(*c - middle));
    (triangles.iter().map(six).sum::<f64>() / 6.0).abs()
}

/// Whether the ray upwards from a point crosses a triangle: 1 from its back, -1 from its front, 0 if it does not.
fn crossing(triangle: &[Corner; 3], p: Corner) -> i64 {
    let [a, b, c] = triangle;
    let turns = [side(a, b, p), side(b, c, p), side(c, a, p)];
    if turns[0] == 0 || turns[1] != turns[0] || turns[2] != turns[0] {
        return 0;
    }
    let d = |u: &Corner, v: &Corner| [0, 1, 2].map(|k| i128::from(u[k] - v[k]));
    let (u, v, w) = (d(b, a), d(c, a), d(&p, a));
    let normal = [
        u[1] * v[2] - u[2] * v[1],
        u[2] * v[0] - u[0] * v[2],
        u[0] * v[1] - u[1] * v[0],
    ];
    let off = normal[0] * w[0] + normal[1] * w[1] + normal[2] * w[2];
    // on the surface a point is just above it
    if off.signum() * normal[2].signum() < 0 {
        turns[0]
    } else {
        0
    }
}

/// On which side of the line from `a` to `b`, seen from above, a point lies that is moved by nothing along x and by less along y;
/// 0 only when the line has no length.
fn side(a: &Corner, b: &Corner, p: Corner) -> i64 {
    let (x, y) = (b[0] - a[0], b[1] - a[1]);
    let turn = x * (p[1] - a[1]) - y * (p[0] - a[0]);
    match (turn.signum(), -y.signum(), x.signum()) {
        (0, 0, along) => along,
        (0, up, _) => up,
        (turn, ..) => turn,
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use glam::dvec3;

    /// Triangles of a box, each face cut along a diagonal.
    pub(crate) fn boxed(lower: DVec3, upper: DVec3) -> Vec<[DVec3; 3]> {
        let corner = |k: usize| {
            let pick = |bit: usize, axis: usize| if k >> bit & 1 == 1 { upper[axis] } else { lower[axis] };
            dvec3(pick(0, 0), pick(1, 1), pick(2, 2))
        };
        let faces = [
            [0, 2, 3, 1],
            [4, 5, 7, 6],
            [0, 1, 5, 4],
            [2, 6, 7, 3],
            [0, 4, 6, 2],
            [1, 3, 7, 5],
        ];
        let cut = |[a, b, c, d]: [usize; 4]| [[a, b, c], [a, c, d]];
        faces.into_iter().flat_map(cut).map(|t| t.map(corner)).collect()
    }

    fn random() -> impl FnMut() -> f64 {
        let mut x = 9u64;
        move || {
            x = x
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (x >> 11) as f64 / (1u64 << 53) as f64
        }
    }

    #[test]
    fn boxes_that_share_a_face_share_no_point_and_lose_none() {
        let cuts = [0.0, 0.25, 0.5, 1.0];
        let mut boxes = Vec::new();
        for x in 0..3 {
            for y in 0..3 {
                for z in 0..3 {
                    let at = |d: usize| dvec3(cuts[x + d], cuts[y + d], cuts[z + d]);
                    boxes.push(Interior::new(&boxed(at(0), at(1))).unwrap());
                }
            }
        }
        // centres, and points on faces, edges, corners and diagonals of the cuts
        let steps: Vec<f64> = (1..32).map(|k| f64::from(k) / 32.0).collect();
        for &x in &steps {
            for &y in &steps {
                for z in [0.125, 0.25, 0.5, 0.7] {
                    let holding = boxes.iter().filter(|b| b.contains(dvec3(x, y, z))).count();
                    assert_eq!(holding, 1, "{x} {y} {z}");
                }
            }
        }
        assert!((boxes[26].volume() - 0.125).abs() < 1e-15);
    }

    #[test]
    fn a_sphere_of_many_triangles_holds_what_is_nearer_than_its_radius() {
        // parallels and meridians, with poles
        let (n, mut triangles) = (60, Vec::new());
        let at = |i: usize, k: usize| {
            let (theta, phi) = (
                std::f64::consts::PI * i as f64 / n as f64,
                std::f64::consts::TAU * (k % n) as f64 / n as f64,
            );
            match i {
                0 => DVec3::Z,
                i if i == n => DVec3::NEG_Z,
                _ => dvec3(
                    libm::sin(theta) * libm::cos(phi),
                    libm::sin(theta) * libm::sin(phi),
                    libm::cos(theta),
                ),
            }
        };
        for i in 0..n {
            for k in 0..n {
                let [a, b, c, d] = [at(i, k), at(i + 1, k), at(i + 1, k + 1), at(i, k + 1)];
                if i + 1 < n {
                    triangles.push([a, b, c]);
                }
                if i > 0 {
                    triangles.push([a, c, d]);
                }
            }
        }
        let ball = Interior::new(&triangles).unwrap();
        assert!((ball.volume() / (4.0 / 3.0 * std::f64::consts::PI) - 1.0).abs() < 0.01);
        let mut next = random();
        let mut inside = 0;
        for _ in 0..20_000 {
            let p = dvec3(next(), next(), next()) * 2.4 - 1.2;
            let r = p.length();
            if !(0.995..=1.0).contains(&r) {
                assert_eq!(ball.contains(p), r < 1.0, "{p}");
                inside += usize::from(r < 1.0);
            }
        }
        assert!(inside > 4000);
        // the axis goes through both poles, where all meridians meet
        assert!(ball.contains(DVec3::ZERO) && ball.contains(dvec3(0.0, 0.0, -0.99)));
        assert!(!ball.contains(dvec3(0.0, 0.0, -1.01)) && !ball.contains(DVec3::NAN));
    }

    #[test]
    fn parts_that_overlap_are_one_and_one_that_faces_the_other_way_is_a_hole() {
        let all = |parts: &[Vec<[DVec3; 3]>]| Interior::new(&parts.concat()).unwrap();
        let cube = |from: f64, to: f64| boxed(DVec3::splat(from), DVec3::splat(to));
        let turned = |mut part: Vec<[DVec3; 3]>| {
            part.iter_mut().for_each(|triangle| triangle.swap(0, 1));
            part
        };
        let holds = |interior: &Interior, x: f64| interior.contains(DVec3::splat(x));
        // two cubes share an eighth of each, and one of them is inside out
        let two = all(&[cube(0.0, 1.0), turned(cube(0.5, 1.5))]);
        assert!([0.2, 0.7, 1.2].iter().all(|&x| holds(&two, x)) && !holds(&two, 1.49999 + 1e-4));
        assert!(!two.contains(dvec3(0.2, 0.2, 1.2)));
        assert!((two.volume() - 1.875).abs() < 0.02, "{}", two.volume());
        // drawn twice, one ever so little larger
        let twice = all(&[cube(0.0, 1.0), cube(-1e-7, 1.0 + 1e-7)]);
        assert!(
            holds(&twice, 0.5) && (twice.volume() - 1.0).abs() < 0.02,
            "{}",
            twice.volume()
        );
        let hollow = all(&[cube(0.0, 1.0), turned(cube(0.25, 0.75))]);
        assert!(holds(&hollow, 0.1) && !holds(&hollow, 0.5));
        assert!((hollow.volume() - 0.875).abs() < 1e-12, "{}", hollow.volume());
        // side by side they may face as they like
        let apart = all(&[cube(0.0, 1.0), turned(cube(2.0, 3.0))]);
        assert!(holds(&apart, 0.5) && holds(&apart, 2.5) && !holds(&apart, 1.5));
        assert!((apart.volume() - 2.0).abs() < 1e-12 && !apart.parts_overlap());
        // one that faces the other way and only crosses, a little or through and through, adds to the body, whichever is inside out
        let brick = |lower: [f64; 3], upper: [f64; 3]| boxed(DVec3::from_array(lower), DVec3::from_array(upper));
        for other in [
            brick([0.25, 0.25, 0.5], [0.75, 0.75, 1.001]),
            brick([0.25, 0.25, -1.0], [0.75, 0.75, 2.0]),
        ] {
            let crossing = all(&[turned(cube(0.0, 1.0)), other]);
            assert!(holds(&crossing, 0.6) && crossing.parts_overlap());
        }
        // a mesh that is all inside out has its holes, too, and an island in them; so has a hole that shares a face or an edge
        let island = all(&[turned(cube(0.0, 1.0)), cube(0.2, 0.8), turned(cube(0.4, 0.6))]);
        assert!(holds(&island, 0.1) && !holds(&island, 0.3) && holds(&island, 0.5) && !island.parts_overlap());
        for lower in [[0.25, 0.25, 0.0], [0.25, 0.0, 0.0], [0.0; 3]] {
            let hole = brick(lower, [0.75; 3]);
            let with_hole = all(&[cube(0.0, 1.0), turned(hole)]);
            assert!(!holds(&with_hole, 0.5) && holds(&with_hole, 0.9) && !with_hole.parts_overlap());
        }
        // cubes that touch along an edge are two parts
        let edge = all(&[cube(0.0, 1.0), turned(brick([1.0, 1.0, 0.0], [2.0, 2.0, 1.0]))]);
        assert!(holds(&edge, 0.5) && edge.contains(dvec3(1.5, 1.5, 0.5)) && (edge.volume() - 2.0).abs() < 1e-12);
        // triangles that do not agree tell by their number
        let mut torn = cube(0.0, 1.0);
        torn[3].swap(0, 1);
        let torn = all(&[torn]);
        assert!(holds(&torn, 0.5) && !torn.is_oriented && two.is_oriented);
    }

    #[test]
    fn a_surface_with_a_hole_has_no_inside() {
        let mut triangles = boxed(DVec3::ZERO, DVec3::ONE);
        triangles.pop();
        let error = Interior::new(&triangles).unwrap_err();
        assert!(matches!(error, InteriorError::Open { count: 3, .. }), "{error}");
        assert!(matches!(Interior::new(&[]), Err(InteriorError::NoSize { .. })));
        let broken = [[DVec3::NAN, DVec3::ZERO, DVec3::ONE]];
        assert!(matches!(Interior::new(&broken), Err(InteriorError::NoSize { .. })));
    }
}
