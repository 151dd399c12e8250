//! Places of grains that come in through a mesh: inside of a closed one, or on its triangles.

use super::random::RandomNumbers;
use crate::particles::Interior;
use crate::walls::{Mesh, MeshError};
use glam::DVec3;
use std::sync::Arc;

/// Points that are drawn for one place, of which the first inside counts.
const DRAWS: u32 = 50;
/// A grain counts as inside when it stands out by no more than this share of its radius.
const ROUNDING: f64 = 1e-9;

/// The mesh of an inlet.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshInlet {
    /// Its triangles [m].
    pub triangles: Arc<Vec<[DVec3; 3]>>,
    /// Grains lie wholly inside; without it centres lie on the triangles.
    pub interior: Option<Arc<Interior>>,
}

/// A mesh inlet with what places need.
#[derive(Clone, Debug)]
pub(super) struct MeshPlaces {
    inlet: MeshInlet,
    surface: Arc<Mesh>,
    /// Areas of the triangles up to each, summed up [m^2].
    areas: Vec<f64>,
    /// Edges of one triangle.
    rim: Vec<[DVec3; 2]>,
}

impl MeshPlaces {
    pub fn new(inlet: &MeshInlet) -> Result<Self, MeshError> {
        let surface = Arc::new(Mesh::new(&inlet.triangles)?);
        let triangles = || surface.triangles().iter().map(|t| t.corners());
        let mut whole = 0.0;
        let areas = triangles().map(|[a, b, c]| {
            whole += 0.5 * (b - a).cross(c - a).length();
            whole
        });
        let areas = areas.collect();
        // corners were joined by the mesh, so shared edges have the same ends
        let key = |p: DVec3| p.to_array().map(f64::to_bits);
        let mut edges: Vec<[[u64; 3]; 2]> = triangles()
            .flat_map(|[a, b, c]| [[a, b], [b, c], [c, a]])
            .map(|[a, b]| [key(a).min(key(b)), key(a).max(key(b))])
            .collect();
        edges.sort_unstable();
        let point = |p: [u64; 3]| DVec3::from_array(p.map(f64::from_bits));
        let rim = (edges.chunk_by(|a, b| a == b))
            .filter(|same| same.len() == 1)
            .map(|same| same[0].map(point))
            .collect();
        Ok(Self {
            inlet: inlet.clone(),
            areas,
            rim,
            surface,
        })
    }

    /// Smallest box along the axes around the mesh [m].
    pub fn bounds(&self) -> (DVec3, DVec3) {
        self.surface.bounds()
    }

    /// Upper bound of the diameter of a grain that fits [m].
    pub fn room(&self) -> f64 {
        let (lower, upper) = self.bounds();
        let mut size = (upper - lower).to_array();
        size.sort_by(f64::total_cmp);
        // a face has no thickness, and a grain fits when it does along both others
        if self.inlet.interior.is_some() {
            size[0]
        } else {
            size[1]
        }
    }

    /// How many grains of a radius find room at most, roughly.
    pub fn capacity(&self, radius: f64) -> f64 {
        match &self.inlet.interior {
            Some(interior) => interior.volume() / (8.0 * radius * radius * radius),
            None => self.areas.last().copied().unwrap_or(0.0) / (4.0 * radius * radius),
        }
    }

    /// A random place where a grain lies wholly inside; nothing when none was found.
    pub fn random_place(&self, radius: f64, random: &mut RandomNumbers) -> Option<DVec3> {
        (0..DRAWS).find_map(|_| {
            let place = match &self.inlet.interior {
                Some(_) => self.in_bounds(radius, random),
                None => self.on_face(random),
            };
            self.holds(place, radius).then_some(place)
        })
    }

    fn holds(&self, place: DVec3, radius: f64) -> bool {
        let least = radius * (1.0 - ROUNDING);
        match &self.inlet.interior {
            Some(interior) => interior.contains(place) && self.surface.distance(place, radius) >= least,
            None => (self.rim.iter()).all(|edge| to_edge(place, edge).length_squared() >= least * least),
        }
    }

    fn in_bounds(&self, radius: f64, random: &mut RandomNumbers) -> DVec3 {
        let (lower, upper) = self.bounds();
        DVec3::from_array(std::array::from_fn(|k| {
            let room = (upper[k] - lower[k] - 2.0 * radius).max(0.0);
            lower[k] + radius + random.uniform() * room
        }))
    }

    /// A point of a triangle, uniform over the surface.
    fn on_face(&self, random: &mut RandomNumbers) -> DVec3 {
        let whole = self.areas.last().copied().unwrap_or(0.0);
        let drawn = random.uniform() * whole;
        let at = self
            .areas
            .partition_point(|area| *area <= drawn)
            .min(self.areas.len() - 1);
        let [a, b, c] = self.surface.triangles()[at].corners();
        let (mut u, mut v) = (random.uniform(), random.uniform());
        if u + v > 1.0 {
            (u, v) = (1.0 - u, 1.0 - v);
        }
        a + (b - a) * u + (c - a) * v
    }
}

/// From the nearest point of an edge to a place.
fn to_edge(place: DVec3, [a, b]: &[DVec3; 2]) -> DVec3 {
    let (along, from) = (*b - *a, place - *a);
    from - along * (from.dot(along) / along.length_squared()).clamp(0.0, 1.0)
}
