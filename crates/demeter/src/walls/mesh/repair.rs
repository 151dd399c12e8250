//! Harmless repairs of a mesh as it comes: what they change no grain can feel.

use super::orientation::orient;
use super::weld::weld;
use super::{Mesh, MeshError};
use demeter_physics::geometry::contact_sphere_triangle::Triangle;
use glam::DVec3;

/// Triangles that were left out.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LeftOut {
    /// How many.
    pub count: usize,
    /// The first of them, counted from 1 in the order of the file; 0 when there is none.
    pub first: usize,
    /// A corner of the first [m].
    pub place: DVec3,
}

impl LeftOut {
    fn add(&mut self, index: usize, place: DVec3) {
        if self.count == 0 {
            (self.first, self.place) = (index + 1, place);
        }
        self.count += 1;
    }
}

/// What was repaired.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Repair {
    /// Corners closer than this were joined [m].
    pub tolerance: f64,
    /// Corners that were moved, by more than nothing, onto another.
    pub moved: usize,
    /// Farthest move [m].
    pub farthest: f64,
    /// Triangles without area.
    pub flat: LeftOut,
    /// Triangles that came before with the same corners, in any order.
    pub twice: LeftOut,
    /// Those left that came with both fronts, as a face that two closed surfaces share does, counted from 0.
    pub both_fronts: Vec<u32>,
    /// Triangles that were turned around so that neighbours agree on their front.
    pub turned: usize,
}

impl Repair {
    /// Whether the mesh is as it came.
    pub fn is_nothing(&self) -> bool {
        self.moved == 0 && self.flat.count == 0 && self.twice.count == 0 && self.turned == 0
    }
}

impl Mesh {
    /// Joins corners within a tolerance [m], leaves out triangles without area and those that come twice, and turns
    /// triangles so that neighbours agree on their front. Without a tolerance corners are joined that differ by no more
    /// than the rounding of single precision. Gives the triangles that are left, in their order.
    pub fn repair(corners: &[[DVec3; 3]], tolerance: Option<f64>) -> Result<(Vec<[DVec3; 3]>, Repair), MeshError> {
        check_corners(corners)?;
        let mut repair = Repair::default();
        let mut indices = Vec::with_capacity(corners.len());
        let mut solid = Vec::with_capacity(corners.len());
        for (index, triangle) in corners.iter().enumerate() {
            if Triangle::new(*triangle).is_some() {
                indices.push(index);
                solid.push(*triangle);
            } else {
                repair.flat.add(index, triangle[0]);
            }
        }
        let welded = weld(&solid, tolerance);
        repair.tolerance = welded.tolerance;
        let place = |ids: [u32; 3]| ids.map(|id| welded.points[id as usize]);
        let mut seen = Vec::with_capacity(solid.len());
        for (k, ids) in welded.triangles.iter().enumerate() {
            for (from, to) in solid[k].iter().zip(place(*ids)) {
                let move_by = from.distance(to);
                repair.moved += usize::from(move_by > 0.0);
                repair.farthest = repair.farthest.max(move_by);
            }
            let mut sorted = *ids;
            sorted.sort_unstable();
            if Triangle::new(place(*ids)).is_some() {
                seen.push((sorted, k, is_even(ids)));
            } else {
                repair.flat.add(indices[k], solid[k][0]);
            }
        }
        seen.sort_unstable();
        let mut kept = Vec::with_capacity(seen.len());
        for same in seen.chunk_by(|a, b| a.0 == b.0) {
            for &(_, k, _) in &same[1..] {
                repair.twice.add(indices[k], solid[k][0]);
            }
            kept.push((same[0].1, same.iter().any(|one| one.2 != same[0].2)));
        }
        if kept.is_empty() {
            if !solid.is_empty() {
                return Err(all_joined(&solid, welded.tolerance));
            }
            let index = repair.flat.first - 1;
            return Err(MeshError::ZeroArea {
                triangle: index + 1,
                corners: corners[index],
            });
        }
        kept.sort_unstable();
        let mut triangles: Vec<[u32; 3]> = kept.iter().map(|&(k, _)| welded.triangles[k]).collect();
        let numbered = (0u32..).zip(&kept);
        repair.both_fronts = numbered.filter(|(_, (_, both))| *both).map(|(n, _)| n).collect();
        repair.turned = orient(&mut triangles);
        Ok((triangles.into_iter().map(place).collect(), repair))
    }
}

/// Whether three different numbers are in order after an even number of exchanges.
fn is_even([a, b, c]: &[u32; 3]) -> bool {
    (a < b) ^ (b < c) ^ (a < c)
}

/// Tells that corners were joined until no triangle was left.
fn all_joined(triangles: &[[DVec3; 3]], tolerance: f64) -> MeshError {
    let edges = triangles
        .iter()
        .flat_map(|[a, b, c]| [a.distance(*b), b.distance(*c), c.distance(*a)]);
    MeshError::AllJoined {
        tolerance,
        count: triangles.len(),
        shortest: edges.fold(f64::INFINITY, f64::min),
    }
}

/// Refuses what can be neither repaired nor computed with.
pub(super) fn check_corners(corners: &[[DVec3; 3]]) -> Result<(), MeshError> {
    if corners.is_empty() {
        return Err(MeshError::Empty);
    }
    if corners.len() > Mesh::MOST_TRIANGLES {
        return Err(MeshError::TooMany { count: corners.len() });
    }
    let usable = |corner: &DVec3| corner.is_finite() && corner.abs().max_element() <= Mesh::LARGEST;
    for (index, triangle) in corners.iter().enumerate() {
        if let Some(&corner) = triangle.iter().find(|corner| !usable(corner)) {
            return Err(MeshError::NotFinite {
                triangle: index + 1,
                corner,
            });
        }
    }
    Ok(())
}
