//! Which triangles meet at an edge or a vertex, and where the surface is flat.

use super::weld::Welded;
use demeter_physics::geometry::contact_sphere_triangle::Triangle;
use glam::DVec3;

/// Largest bend of an edge that counts as flat: length of the sum of the two unit vectors that point from the edge into
/// its triangles. Above the rounding of single precision on triangles of ordinary shape, far below any facet of a
/// curved surface.
const FLAT: f64 = 1e-5;

/// Neighbours of the triangles of a mesh.
#[derive(Clone, Debug)]
pub(super) struct Topology {
    /// Corners of every triangle.
    corners: Vec<[u32; 3]>,
    /// Edges of every triangle; edge `k` runs from corner `k` to corner `k + 1`.
    edges: Vec<[u32; 3]>,
    at_edge: Incidence,
    at_vertex: Incidence,
    /// Edges between two triangles of one patch.
    flat_edge: Vec<bool>,
    /// Vertices in the interior of a patch.
    flat_vertex: Vec<bool>,
    /// For every triangle the lowest triangle of its flat patch.
    patch: Vec<u32>,
}

/// A list of triangles for every edge or vertex.
#[derive(Clone, Debug)]
pub(super) struct Incidence {
    starts: Vec<u32>,
    triangles: Vec<u32>,
}

impl Incidence {
    pub(super) fn new(count: usize, of_triangles: &[[u32; 3]]) -> Self {
        let mut starts = vec![0u32; count + 1];
        for &id in of_triangles.iter().flatten() {
            starts[id as usize + 1] += 1;
        }
        for k in 0..count {
            starts[k + 1] += starts[k];
        }
        let mut fill = starts.clone();
        let mut triangles = vec![0; 3 * of_triangles.len()];
        for (triangle, ids) in of_triangles.iter().enumerate() {
            for &id in ids {
                triangles[fill[id as usize] as usize] = triangle as u32;
                fill[id as usize] += 1;
            }
        }
        Incidence { starts, triangles }
    }

    pub(super) fn of(&self, id: u32) -> &[u32] {
        let id = id as usize;
        &self.triangles[self.starts[id] as usize..self.starts[id + 1] as usize]
    }

    fn len(&self) -> usize {
        self.starts.len() - 1
    }
}

impl Topology {
    pub(super) fn new(welded: &Welded, triangles: &[Triangle]) -> Self {
        let corners = welded.triangles.clone();
        let (edges, edge_count) = number_edges(&corners);
        let at_edge = Incidence::new(edge_count, &edges);
        let at_vertex = Incidence::new(welded.points.len(), &corners);
        let flat_edge: Vec<bool> = (0..edge_count as u32)
            .map(|edge| match at_edge.of(edge) {
                &[first, second] => {
                    let inward = |triangle: u32| into_triangle(triangle, edge, &edges, triangles);
                    first != second && (inward(first) + inward(second)).length() < FLAT
                }
                _ => false,
            })
            .collect();
        let patch = find_patches(corners.len(), &flat_edge, &at_edge);
        let mut flat_vertex = vec![true; welded.points.len()];
        for (ids, sides) in corners.iter().zip(&edges) {
            for k in 0..3 {
                if !flat_edge[sides[k] as usize] {
                    flat_vertex[ids[k] as usize] = false;
                    flat_vertex[ids[(k + 1) % 3] as usize] = false;
                }
            }
        }
        Topology {
            corners,
            edges,
            at_edge,
            at_vertex,
            flat_edge,
            flat_vertex,
            patch,
        }
    }

    /// Lowest triangle of the flat patch of a triangle.
    pub(super) fn patch(&self, triangle: u32) -> u32 {
        self.patch[triangle as usize]
    }

    /// An edge of a triangle, with what is needed to judge a contact there.
    pub(super) fn edge(&self, triangle: u32, side: u8) -> Junction<'_> {
        let edge = self.edges[triangle as usize][usize::from(side)];
        Junction {
            triangles: self.at_edge.of(edge),
            flat: self.flat_edge[edge as usize],
            key: self.corners.len() as u32 + edge,
        }
    }

    /// A corner of a triangle, with what is needed to judge a contact there.
    pub(super) fn vertex(&self, triangle: u32, corner: u8) -> Junction<'_> {
        let vertex = self.corners[triangle as usize][usize::from(corner)];
        Junction {
            triangles: self.at_vertex.of(vertex),
            flat: self.flat_vertex[vertex as usize],
            key: (self.corners.len() + self.at_edge.len()) as u32 + vertex,
        }
    }

    /// Number of edges.
    pub(super) fn edge_count(&self) -> u32 {
        self.at_edge.len() as u32
    }

    /// Triangles at an edge, each with the side on which the edge lies.
    pub(super) fn sides_of(&self, edge: u32) -> Vec<(u32, usize)> {
        let side = |triangle: u32| self.edges[triangle as usize].iter().position(|&e| e == edge);
        (self.at_edge.of(edge).iter())
            .map(|&triangle| (triangle, side(triangle).unwrap_or(0)))
            .collect()
    }

    /// Corners of a triangle.
    pub(super) fn corners_of(&self, triangle: u32) -> &[u32; 3] {
        &self.corners[triangle as usize]
    }

    /// Edges with an odd number of triangles: the first triangle of each and the side on which the edge lies.
    pub(super) fn odd_edges(&self) -> Vec<(u32, u8)> {
        let mut odd = Vec::new();
        for edge in 0..self.at_edge.len() as u32 {
            let triangles = self.at_edge.of(edge);
            if triangles.len() % 2 == 1 {
                let sides = &self.edges[triangles[0] as usize];
                let side = sides.iter().position(|&e| e == edge).unwrap_or(0);
                odd.push((triangles[0], side as u8));
            }
        }
        odd
    }

    /// Whether no edge has an odd number of some triangles.
    pub(super) fn is_closed_with(&self, triangles: &[u32]) -> bool {
        let mut is_odd = vec![false; self.at_edge.len()];
        for &edge in triangles.iter().flat_map(|&triangle| &self.edges[triangle as usize]) {
            is_odd[edge as usize] ^= true;
        }
        !is_odd.contains(&true)
    }
}

/// An edge or a vertex.
pub(super) struct Junction<'a> {
    /// Triangles that meet there.
    pub(super) triangles: &'a [u32],
    /// Whether the surface is flat all around.
    pub(super) flat: bool,
    /// Key of a contact there: after all triangles come the edges, after these the vertices.
    pub(super) key: u32,
}

/// Numbers the edges in the order of their vertices.
pub(super) fn number_edges(corners: &[[u32; 3]]) -> (Vec<[u32; 3]>, usize) {
    let mut sides = Vec::with_capacity(3 * corners.len());
    for (triangle, ids) in corners.iter().enumerate() {
        for k in 0..3 {
            let (a, b) = (ids[k], ids[(k + 1) % 3]);
            sides.push((a.min(b), a.max(b), triangle as u32, k));
        }
    }
    sides.sort_unstable();
    let mut edges = vec![[0; 3]; corners.len()];
    let mut count = 0;
    for (index, &(a, b, triangle, side)) in sides.iter().enumerate() {
        let new = index == 0 || (sides[index - 1].0, sides[index - 1].1) != (a, b);
        count += usize::from(new);
        edges[triangle as usize][side] = count as u32 - 1;
    }
    (edges, count)
}

/// Unit vector in the plane of a triangle, at a right angle to one of its edges, into the triangle.
fn into_triangle(triangle: u32, edge: u32, edges: &[[u32; 3]], triangles: &[Triangle]) -> DVec3 {
    let side = edges[triangle as usize].iter().position(|&e| e == edge).unwrap_or(0);
    let corners = triangles[triangle as usize].corners();
    let (start, end) = (corners[side], corners[(side + 1) % 3]);
    let along = end - start;
    let inward = triangles[triangle as usize].normal().cross(along);
    inward / inward.length()
}

/// Lowest triangle that can be reached from each triangle across flat edges.
fn find_patches(count: usize, flat_edge: &[bool], at_edge: &Incidence) -> Vec<u32> {
    let mut parent: Vec<u32> = (0..count as u32).collect();
    for (edge, _) in flat_edge.iter().enumerate().filter(|&(_, &flat)| flat) {
        if let &[first, second] = at_edge.of(edge as u32) {
            let (a, b) = (root(&mut parent, first), root(&mut parent, second));
            parent[a.max(b) as usize] = a.min(b);
        }
    }
    (0..count as u32).map(|triangle| root(&mut parent, triangle)).collect()
}

fn root(parent: &mut [u32], mut triangle: u32) -> u32 {
    while parent[triangle as usize] != triangle {
        let above = parent[parent[triangle as usize] as usize];
        parent[triangle as usize] = above;
        triangle = above;
    }
    triangle
}
