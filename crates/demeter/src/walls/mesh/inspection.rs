//! What is remarkable about a mesh: holes, edges of many triangles, fronts that do not agree, triangles that cross.

use super::Mesh;
use super::crossings::{Crossings, crossings, meeting};
use super::orientation::is_forward;
use super::topology::{Incidence, number_edges};
use super::weld::{SAFE_SHARE, weld};
use glam::DVec3;
use std::collections::VecDeque;

/// Area of a boundary over the square of its length below which it is a crack without width: a hundredth of a part in a
/// million; a rim as wide as a hundredth of its length has 4000 times more.
const CRACK: f64 = 1e-8;
/// Width of a gap over its length below which its sides were meant to be one.
const NARROW: f64 = 1e-3;

/// A closed line of edges that belong to one triangle only: the rim of a hole or the end of an open surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rim {
    /// Number of its edges.
    pub edges: usize,
    /// Length around [m].
    pub length: f64,
    /// Area of the hole, of the surface across it that is seen largest [m^2].
    pub area: f64,
    /// Its middle [m].
    pub centre: DVec3,
    /// A triangle at it, counted from 1.
    pub triangle: usize,
    /// Whether it ends where it begins: that of a plate that stands on another surface does not.
    pub is_closed: bool,
}

impl Rim {
    /// Whether it is a crack without width, as triangles without area leave when they are left out.
    pub fn is_crack(&self) -> bool {
        self.is_closed && self.area <= CRACK * self.length * self.length
    }

    /// How wide it is at most, if it is a triangle [m].
    fn width(&self) -> f64 {
        4.0 * self.area / self.length
    }
}

/// Open edges whose corners nearly meet those of others.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Torn {
    /// How many edges more belong to two triangles or more where such corners are joined.
    pub edges: usize,
    /// How many are open then, too.
    pub left: usize,
    /// Distance of corners that joins them [m].
    pub weld: f64,
}

impl Torn {
    /// What joins them.
    pub fn remedy(&self) -> String {
        format!(
            "corners nearly meet there: `weld = \"{:e} m\"` of the wall joins them",
            self.weld
        )
    }
}

/// How to close a mesh, told what is torn, and how wide the widest of its gaps is where all are cracks [m].
pub(super) fn closing(torn: Option<&Torn>, cracks: Option<f64>) -> String {
    if let Some(torn) = torn.filter(|torn| torn.left == 0) {
        return torn.remedy();
    }
    match cracks {
        None => "close the hole in the program that drew it".to_string(),
        Some(0.0) => "these are cracks of no width, corners lie on edges of neighbours there: give both sides the same corners in the program \
             that drew it"
            .to_string(),
        Some(width) => format!(
            "these are cracks, at most about {width:.1e} m wide: join their corners in the program that drew it, or with `weld` of a wall"
        ),
    }
}

/// A number of places and the first of them.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Places {
    /// How many.
    pub count: usize,
    /// The first [m].
    pub first: DVec3,
}

impl Places {
    fn add(&mut self, place: DVec3) {
        if self.count == 0 {
            self.first = place;
        }
        self.count += 1;
    }
}

/// What was found.
#[derive(Clone, Debug, PartialEq)]
pub struct Inspection {
    /// Rims of holes and of open ends, the longest first.
    pub rims: Vec<Rim>,
    /// What of them is torn.
    pub torn: Option<Torn>,
    /// Middles of edges that belong to more than two triangles.
    pub crowded_edges: Places,
    /// Middles of edges whose two triangles have their fronts on different sides.
    pub disagreeing_edges: Places,
    /// Triangles that pass through or lie on one another.
    pub crossings: Crossings,
}

impl Mesh {
    /// Looks for holes, edges of more than two triangles, disagreeing fronts and triangles that cross.
    pub fn inspect(&self) -> Inspection {
        let mut crowded_edges = Places::default();
        let mut disagreeing_edges = Places::default();
        for edge in 0..self.topology.edge_count() {
            let sides = self.topology.sides_of(edge);
            let (triangle, side) = sides[0];
            match sides.len() {
                1 => {}
                2 => {
                    let front = |(t, s): (u32, usize)| is_forward(self.topology.corners_of(t), s);
                    if front(sides[0]) == front(sides[1]) {
                        disagreeing_edges.add(self.middle(triangle, side));
                    }
                }
                _ => crowded_edges.add(self.middle(triangle, side)),
            }
        }
        Inspection {
            rims: self.rims(&self.open_sides()),
            torn: self.torn(),
            crowded_edges,
            disagreeing_edges,
            crossings: crossings(&self.triangles, &self.hierarchy),
        }
    }

    /// Sides of triangles that no other triangle has.
    fn open_sides(&self) -> Vec<(u32, usize)> {
        let all = (0..self.topology.edge_count()).map(|edge| self.topology.sides_of(edge));
        all.filter(|sides| sides.len() == 1).map(|sides| sides[0]).collect()
    }

    /// What joining corners that lie much closer than open edges are long would close.
    pub(super) fn torn(&self) -> Option<Torn> {
        let open = self.open_sides();
        let lengths = open.iter().map(|&(triangle, side)| {
            let [a, b] = self.ends(triangle, side);
            a.distance(b)
        });
        let tolerance = SAFE_SHARE * lengths.reduce(f64::min)?;
        let corners: Vec<[DVec3; 3]> = self.triangles.iter().map(|t| t.corners()).collect();
        let welded = weld(&corners, Some(tolerance));
        let has_area = |[a, b, c]: &[u32; 3]| a != b && b != c && c != a;
        let kept: Vec<[u32; 3]> = welded.triangles.iter().copied().filter(has_area).collect();
        let (edges, count) = number_edges(&kept);
        let at_edge = Incidence::new(count, &edges);
        let left = (0..count as u32).filter(|&edge| at_edge.of(edge).len() == 1).count();
        let moves = corners.as_flattened().iter().zip(welded.triangles.as_flattened());
        let farthest = moves
            .map(|(corner, id)| corner.distance(welded.points[*id as usize]))
            .fold(0.0, f64::max);
        (left < open.len()).then(|| Torn {
            edges: open.len() - left,
            left,
            // corners were joined within rounding before
            weld: rounded_up(tolerance.min(2.0 * farthest)),
        })
    }

    /// How wide the widest gap is where all gaps are cracks [m]; 0 without width.
    pub(super) fn cracks(&self) -> Option<f64> {
        let rims = self.rims(&self.open_sides());
        let is_narrow = |rim: &Rim| rim.is_closed && rim.width() <= NARROW * rim.length;
        let wide = rims.iter().filter(|rim| !rim.is_crack()).map(Rim::width);
        (!rims.is_empty() && rims.iter().all(is_narrow)).then(|| wide.fold(0.0, f64::max))
    }

    /// Where a triangle passes through one of others, told by their corners in the frame of this mesh [m].
    pub(crate) fn meets(&self, others: impl Iterator<Item = [DVec3; 3]>) -> Option<DVec3> {
        meeting(&self.triangles, &self.hierarchy, others)
    }

    pub(super) fn ends(&self, triangle: u32, side: usize) -> [DVec3; 2] {
        let corners = self.triangles[triangle as usize].corners();
        [corners[side], corners[(side + 1) % 3]]
    }

    fn middle(&self, triangle: u32, side: usize) -> DVec3 {
        let [a, b] = self.ends(triangle, side);
        0.5 * (a + b)
    }

    /// Joins open edges to rims. Where rims touch at a vertex it does not matter which of them goes on.
    fn rims(&self, open: &[(u32, usize)]) -> Vec<Rim> {
        let mut at_vertex: Vec<(u32, usize)> = Vec::with_capacity(2 * open.len());
        let vertices: Vec<[u32; 2]> = open
            .iter()
            .map(|&(triangle, side)| {
                let ids = self.topology.corners_of(triangle);
                [ids[side], ids[(side + 1) % 3]]
            })
            .collect();
        for (k, ids) in vertices.iter().enumerate() {
            at_vertex.extend(ids.map(|id| (id, k)));
        }
        at_vertex.sort_unstable();
        let mut used = vec![false; open.len()];
        let take_at = |used: &mut [bool], vertex: u32| {
            let from = at_vertex.partition_point(|&(id, _)| id < vertex);
            let here = at_vertex[from..].iter().take_while(|(id, _)| *id == vertex);
            let next = here.map(|&(_, k)| k).find(|&k| !used[k])?;
            used[next] = true;
            Some(next)
        };
        let mut rims = Vec::new();
        for start in 0..open.len() {
            if used[start] {
                continue;
            }
            used[start] = true;
            let mut line = VecDeque::from([(start, false)]);
            let [mut begin, mut end] = vertices[start];
            while end != begin {
                let Some(next) = take_at(&mut used, end) else { break };
                let reversed = vertices[next][0] != end;
                end = vertices[next][usize::from(!reversed)];
                line.push_back((next, reversed));
            }
            // one that does not close goes on before the edge that it was found by
            while end != begin {
                let Some(next) = take_at(&mut used, begin) else { break };
                let reversed = vertices[next][1] != begin;
                begin = vertices[next][usize::from(reversed)];
                line.push_front((next, reversed));
            }
            rims.push(self.rim(open, line.make_contiguous(), end == begin));
        }
        rims.sort_by(|a, b| b.length.total_cmp(&a.length).then(a.triangle.cmp(&b.triangle)));
        rims
    }

    fn rim(&self, open: &[(u32, usize)], line: &[(usize, bool)], is_closed: bool) -> Rim {
        let (first, is_reversed) = line[0];
        let origin = self.ends(open[first].0, open[first].1)[usize::from(is_reversed)];
        let (mut length, mut moment, mut area) = (0.0, DVec3::ZERO, DVec3::ZERO);
        for &(k, reversed) in line {
            let [a, b] = self.ends(open[k].0, open[k].1);
            let (a, b) = if reversed { (b, a) } else { (a, b) };
            let size = a.distance(b);
            length += size;
            moment += 0.5 * ((a - origin) + (b - origin)) * size;
            area += 0.5 * (a - origin).cross(b - origin);
        }
        Rim {
            edges: line.len(),
            length,
            area: area.length(),
            centre: origin + moment / length,
            triangle: open[first].0 as usize + 1,
            is_closed,
        }
    }
}

/// A length with two digits, not less than it is.
fn rounded_up(length: f64) -> f64 {
    let unit = 10f64.powi(length.log10().floor() as i32 - 1);
    let told = format!("{:.1e}", (length / unit).ceil() * unit);
    told.parse().unwrap_or(length)
}
