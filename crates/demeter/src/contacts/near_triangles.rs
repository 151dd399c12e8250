//! Which triangles of meshes are near grains, several triangles at a time.

use super::Scene;
use super::kinematics::put_listed;
use super::meetings::{lanes_below, next_lane};
use crate::neighbours::WallPair;
use crate::walls::TrianglePoint;
use demeter_physics::geometry::contact_sphere_triangle::ClosestPoints;
use demeter_physics::lanes::{self, Index, Kernel, Lanes, MOST_LANES, Mask, Vector};
use glam::DVec3;

/// How many triangles ahead of those at hand are fetched into the caches.
const AHEAD: usize = 32;

/// Triangles that grains may touch within the next steps, those of one candidate behind those of the other.
#[derive(Clone, Debug, Default)]
pub(super) struct NearTriangles {
    candidates: Vec<u32>,
    grains: Vec<u32>,
    walls: Vec<u32>,
    triangles: Vec<u32>,
    /// Whether they are of several meshes.
    are_mixed: bool,
}

impl NearTriangles {
    pub(super) fn clear(&mut self) {
        self.are_mixed = false;
        self.candidates.clear();
        self.grains.clear();
        self.walls.clear();
        self.triangles.clear();
    }

    /// Appends those that `find` appends, of a candidate.
    pub(super) fn extend(&mut self, candidate: usize, pair: &WallPair, find: impl FnOnce(&mut Vec<u32>)) {
        find(&mut self.triangles);
        self.are_mixed |= self.walls.first().is_some_and(|&wall| wall != pair.wall);
        let count = self.triangles.len();
        self.candidates.resize(count, candidate as u32);
        self.grains.resize(count, pair.grain);
        self.walls.resize(count, pair.wall);
    }

    /// Finds those within a reach: a distance beyond touching [m], and by which factor the distance of a centre may be larger still.
    pub(super) fn find(&self, reach: (f64, f64), scene: &Scene, within: &mut Within) {
        let meet = MeetTriangles {
            scene,
            near: self,
            reach,
            within,
        };
        lanes::run(scene.instructions, meet);
    }

    /// Keeps those that are within a reach, which were `found`.
    pub(super) fn keep(&mut self, found: &Within, pairs: &[WallPair]) {
        let are_mixed = self.are_mixed;
        self.clear();
        self.are_mixed = are_mixed;
        for (&candidate, point) in found.candidates.iter().zip(&found.points) {
            let pair = &pairs[candidate as usize];
            self.candidates.push(candidate);
            self.grains.push(pair.grain);
            self.walls.push(pair.wall);
            self.triangles.push(point.triangle);
        }
    }
}

/// Closest points of the triangles that are within a reach.
#[derive(Clone, Debug, Default)]
pub(super) struct Within {
    candidates: Vec<u32>,
    points: Vec<TrianglePoint>,
    /// How many were given away.
    given: usize,
}

impl Within {
    /// Those of a candidate, which is behind all that were asked before.
    pub(super) fn next_of(&mut self, candidate: usize) -> &mut [TrianglePoint] {
        let first = self.given;
        while self.candidates.get(self.given) == Some(&(candidate as u32)) {
            self.given += 1;
        }
        &mut self.points[first..self.given]
    }
}

/// Finds which triangles are within a reach.
struct MeetTriangles<'a> {
    scene: &'a Scene<'a>,
    near: &'a NearTriangles,
    reach: (f64, f64),
    within: &'a mut Within,
}

impl MeetTriangles<'_> {
    /// The closest points of triangles of one or several meshes.
    #[inline(always)]
    fn closest<L: Lanes>(&self, walls: &Index, triangles: &Index, centres: L::Vector) -> ClosestPoints<L> {
        if !self.near.are_mixed {
            return self.scene.walls[walls[0] as usize].closest_points::<L>(triangles, centres);
        }
        let mut closest = ClosestPoints::nowhere();
        let mut left = lanes_below(L::COUNT);
        while left != 0 {
            let one = left.trailing_zeros() as usize;
            let mut of_one = [triangles[one]; MOST_LANES];
            let (mut same, mut lane) = (0, one);
            while lane < L::COUNT {
                if walls[lane] == walls[one] {
                    same |= 1 << lane;
                    of_one[lane] = triangles[lane];
                }
                lane += 1;
            }
            left &= !same;
            let points = self.scene.walls[walls[one] as usize].closest_points::<L>(&of_one, centres);
            closest = points.or(L::Mask::of_bits(same), closest);
        }
        closest
    }
}

impl Kernel for MeetTriangles<'_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self) {
        self.within.candidates.clear();
        self.within.points.clear();
        self.within.given = 0;
        let (near, (beyond, factor)) = (self.near, self.reach);
        let count = near.triangles.len();
        let [positions, ..] = self.scene.grains.tables();
        for k in (0..count).step_by(L::COUNT) {
            let [mut grains, mut walls, mut triangles] = [[0; MOST_LANES]; 3];
            put_listed::<L>(&near.grains, k, &mut grains);
            put_listed::<L>(&near.walls, k, &mut walls);
            put_listed::<L>(&near.triangles, k, &mut triangles);
            let soon = (k + AHEAD).min(count)..(k + AHEAD + L::COUNT).min(count);
            // where meshes are mixed, those of others are left out
            self.scene.walls[walls[0] as usize].fetch_ahead(&near.triangles[soon]);
            let [[x, y, z, radius]] = L::fetch([positions], &grains);
            let found = self.closest::<L>(&walls, &triangles, L::Vector::new(x, y, z));
            let here = lanes_below((count - k).min(L::COUNT));
            let mut is_within = ((radius + beyond) * factor).gt(found.distance).bits() & here;
            if is_within == 0 {
                continue;
            }
            let [nx, ny, nz] = found.normal.components();
            let rows = L::rows([nx, ny, nz, found.distance]);
            let features = found.features();
            while let Some(lane) = next_lane(&mut is_within) {
                let [x, y, z, distance] = rows.as_ref()[lane];
                self.within.candidates.push(near.candidates[k + lane]);
                self.within.points.push(TrianglePoint {
                    triangle: triangles[lane],
                    feature: features.of(lane),
                    normal: DVec3::new(x, y, z),
                    distance,
                });
            }
        }
    }
}
