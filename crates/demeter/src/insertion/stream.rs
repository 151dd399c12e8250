//! Streams of grains that come while a run goes on, through a face or into a region.
//!
//! Grain number `k` of a stream has its own random numbers, made of the seed and `k`: its diameter and its velocity are the
//! same whenever it comes. A grain that finds no room waits, and no smaller one comes in its stead, so that the sizes that
//! came are always the first of the same sequence: waiting does not shift the distribution.

use super::mesh_places::{MeshInlet, MeshPlaces};
use super::place_grid::PlaceGrid;
use super::random::{Purpose, RandomNumbers, mix};
use super::region::{LARGEST_LENGTH, Space};
use super::spec::{Region, SizeDistribution};
use super::{InsertionProblem, RegionError, SizeSampler};
use crate::materials::Material;
use crate::particles::{Domain, NewGrain};
use glam::DVec3;
use std::f64::consts::PI;
use std::ops::ControlFlow;

/// Places tried for one grain before it waits for the next time.
const TRIES: u32 = 300;
/// Grains stay this much farther apart than they must, as a share of the distance of their centres: rounding.
const CLEARANCE: f64 = 1e-9;
/// Most grains that come at one time.
pub const MAX_AT_ONCE: u64 = 1_000_000;
/// Size classes that the grid of places is made for: radii within a factor of 2 each.
const CLASSES: usize = 24;

/// Where the grains of a stream come in.
#[derive(Clone, Debug, PartialEq)]
pub enum Inlet {
    /// Centres lie on a rectangle; in its plane a grain lies wholly inside.
    Rectangle {
        /// Centre [m].
        center: DVec3,
        /// From the centre to the middle of an edge [m].
        half_u: DVec3,
        /// From the centre to the middle of the next edge, perpendicular to `half_u` [m].
        half_v: DVec3,
    },
    /// Centres lie on a disc; in its plane a grain lies wholly inside.
    Disc {
        /// Centre [m].
        center: DVec3,
        /// Unit vector across the disc.
        normal: DVec3,
        /// Radius [m].
        radius: f64,
    },
    /// Grains lie wholly inside a region.
    Region(Region),
    /// Grains come in inside of a closed mesh, or on the triangles of any.
    Mesh(MeshInlet),
}

/// A stream of grains.
#[derive(Clone, Debug, PartialEq)]
pub struct Stream {
    /// Index of the material.
    pub material: u16,
    /// Distribution of diameters.
    pub diameter: SizeDistribution,
    /// Where the grains come in.
    pub inlet: Inlet,
    /// Velocity of every grain [m/s].
    pub velocity: DVec3,
    /// Standard deviation of a random velocity in each direction [m/s].
    pub velocity_deviation: f64,
    /// Angular velocity of every grain [1/s].
    pub angular_velocity: DVec3,
    /// Seed.
    pub seed: u64,
}

/// A checked stream, ready to let grains come.
#[derive(Clone, Debug)]
pub struct Streaming {
    stream: Stream,
    sizes: SizeSampler,
    density: f64,
    domain: Domain,
    mesh: Option<MeshPlaces>,
}

/// What is there already where grains come in.
pub struct Occupied<'a> {
    grid: PlaceGrid<'a>,
    gap: f64,
}

/// Where grains may be in the way of those that come.
#[derive(Clone, Copy, Debug)]
pub struct Vicinity<'a> {
    /// Around the places where centres may lie [m].
    lower: DVec3,
    upper: DVec3,
    /// Largest radius that may come [m].
    largest: f64,
    domain: &'a Domain,
}

impl<'a> Vicinity<'a> {
    /// That of grains with these centres and radii [m].
    pub fn around(grains: impl Iterator<Item = (DVec3, f64)>, domain: &'a Domain) -> Self {
        let none = Self {
            lower: DVec3::INFINITY,
            upper: DVec3::NEG_INFINITY,
            largest: 0.0,
            domain,
        };
        grains.fold(none, |so_far, (place, radius)| Self {
            lower: so_far.lower.min(place),
            upper: so_far.upper.max(place),
            largest: so_far.largest.max(radius),
            domain,
        })
    }

    /// Whether a grain with this centre and radius may be nearer than a gap to one that comes, across periodic sides as well [m].
    pub fn may_meet(&self, place: DVec3, radius: f64, gap: f64) -> bool {
        let reach = (radius + self.largest) * (1.0 + CLEARANCE) + gap;
        let (middle, half) = (0.5 * (self.lower + self.upper), 0.5 * (self.upper - self.lower));
        let size = self.domain.size();
        (0..3).all(|axis| {
            let mut apart = place[axis] - middle[axis];
            if self.domain.periodic[axis] {
                apart -= size[axis] * (apart / size[axis]).round();
            }
            apart.abs() <= (half[axis] + reach) * (1.0 + CLEARANCE)
        })
    }
}

impl Streaming {
    /// Checks a stream, or tells what is wrong with it.
    pub fn new(stream: &Stream, materials: &[Material], domain: &Domain) -> Result<Self, InsertionProblem> {
        let known = materials.len();
        let index = stream.material;
        let Some(material) = materials.get(usize::from(index)) else {
            return Err(InsertionProblem::MaterialIndex { index, known });
        };
        for (what, value) in [
            ("the velocity", stream.velocity),
            ("the angular velocity", stream.angular_velocity),
        ] {
            if !value.is_finite() {
                return Err(InsertionProblem::Velocity { what, value });
            }
        }
        let value = stream.velocity_deviation;
        if !(value.is_finite() && value >= 0.0) {
            return Err(InsertionProblem::VelocityDeviation { value });
        }
        let sizes = SizeSampler::new(&stream.diameter)?;
        let source = Self {
            stream: stream.clone(),
            sizes,
            density: material.density,
            domain: *domain,
            mesh: match &stream.inlet {
                Inlet::Mesh(inlet) => Some(MeshPlaces::new(inlet)?),
                _ => None,
            },
        };
        source.check_inlet()?;
        Ok(source)
    }

    fn check_inlet(&self) -> Result<(), InsertionProblem> {
        let room = match self.stream.inlet {
            Inlet::Rectangle { center, half_u, half_v } => {
                for (what, value) in [("the centre", center), ("an edge", half_u), ("an edge", half_v)] {
                    check_place(what, value)?;
                }
                2.0 * half_u.length().min(half_v.length())
            }
            Inlet::Disc { center, radius, .. } => {
                check_place("the centre", center)?;
                2.0 * radius
            }
            Inlet::Region(region) => Space::new(&region, Some(&self.domain))?.largest_diameter(),
            Inlet::Mesh(_) => self.mesh.as_ref().map_or(0.0, MeshPlaces::room),
        };
        let (lower, upper) = self.bounds();
        let inside = self.domain.contains(lower) && self.domain.contains(upper);
        if !inside {
            return Err(InsertionProblem::InletOutside { lower, upper });
        }
        let largest = self.sizes.bounds().1;
        match largest <= room {
            true => Ok(()),
            false => Err(InsertionProblem::InletTooSmall { room, largest }),
        }
    }

    /// Smallest box along the axes around the places where centres may lie [m].
    pub fn bounds(&self) -> (DVec3, DVec3) {
        match self.stream.inlet {
            Inlet::Rectangle { center, half_u, half_v } => {
                let reach = half_u.abs() + half_v.abs();
                (center - reach, center + reach)
            }
            Inlet::Disc { center, normal, radius } => {
                let across = |k: usize| libm::sqrt((1.0 - normal[k] * normal[k]).max(0.0));
                let reach = DVec3::new(across(0), across(1), across(2)) * radius;
                (center - reach, center + reach)
            }
            Inlet::Region(region) => match Space::new(&region, Some(&self.domain)) {
                Ok(space) => space.bounds(),
                Err(_) => (DVec3::NAN, DVec3::NAN),
            },
            Inlet::Mesh(_) => (self.mesh.as_ref()).map_or((DVec3::NAN, DVec3::NAN), MeshPlaces::bounds),
        }
    }

    /// Smallest and largest radius that may come [m].
    pub fn radii(&self) -> [f64; 2] {
        let (lower, upper) = self.sizes.bounds();
        [0.5 * lower, 0.5 * upper]
    }

    /// Mean mass of a grain by number [kg].
    pub fn mean_mass(&self) -> f64 {
        self.sizes.mean_volume() * self.density
    }

    /// How many of the smallest grains the inlet could hold at most, roughly.
    pub fn capacity(&self) -> f64 {
        let least = self.radii()[0];
        match self.stream.inlet {
            Inlet::Rectangle { half_u, half_v, .. } => half_u.length() * half_v.length() / (least * least),
            Inlet::Disc { radius, .. } => (radius / least) * (radius / least),
            Inlet::Region(region) => Space::new(&region, Some(&self.domain))
                .map_or(0.0, |space| space.volume() / (8.0 * least * least * least)),
            Inlet::Mesh(_) => self.mesh.as_ref().map_or(0.0, |mesh| mesh.capacity(least)),
        }
    }

    /// Radius of the grain of a number, from 0 [m].
    pub fn radius(&self, number: u64) -> f64 {
        0.5 * self.sizes.draw(&mut self.random(number, Purpose::Sizes))
    }

    /// Mass of a grain of a radius [kg]: the same bits as [`crate::particles::Grains::push`] gives it.
    pub fn mass(&self, radius: f64) -> f64 {
        self.density * (4.0 / 3.0 * PI) * radius * radius * radius
    }

    /// Where grains may be in the way of those that come.
    pub fn vicinity(&self) -> Vicinity<'_> {
        let (lower, upper) = self.bounds();
        Vicinity {
            lower,
            upper,
            largest: self.radii()[1],
            domain: &self.domain,
        }
    }

    /// What is there already: `grains` are centres and radii [m] of all grains, `gap` the distance that grains that come keep
    /// from all others [m], `expected` how many may come.
    pub fn occupied(&self, grains: impl Iterator<Item = (DVec3, f64)>, gap: f64, expected: u64) -> Occupied<'_> {
        let vicinity = self.vicinity();
        let Vicinity {
            lower, upper, largest, ..
        } = vicinity;
        let near: Vec<(DVec3, f64)> = grains
            .filter(|(place, radius)| vicinity.may_meet(*place, *radius, gap))
            .collect();
        let most = near.iter().map(|g| g.1).fold(largest, f64::max);
        // the grid must know how many grains of which sizes it will hold: a class by its largest radius
        let smallest = self.radii()[0];
        let classes = std::iter::successors(Some(most), |radius| Some(0.5 * radius))
            .take(CLASSES)
            .filter(|radius| 2.0 * radius >= smallest && 0.5 * radius <= largest);
        let number = usize::try_from(expected.min(MAX_AT_ONCE))
            .unwrap_or(1)
            .clamp(1, 100_000);
        let to_come = classes.flat_map(|radius| std::iter::repeat_n(radius, number));
        let radii = near.iter().map(|g| g.1).chain(to_come);
        let mut grid = PlaceGrid::new(Some(&self.domain), lower, upper, radii);
        for (place, radius) in &near {
            grid.add(*place, *radius);
        }
        Occupied { grid, gap }
    }

    /// Lets the grain of a number come at a time that is told by a number of its own, at the first random place that is free.
    /// `is_blocked` tells whether something else than grains is there.
    pub fn grain(
        &self,
        (number, time): (u64, u64),
        radius: f64,
        occupied: &mut Occupied<'_>,
        is_blocked: impl Fn(DVec3, f64) -> bool,
    ) -> Option<NewGrain> {
        let mut random = RandomNumbers::new(self.seed(number) ^ mix(time), Purpose::Places);
        let space = self.region();
        let place = (0..TRIES).find_map(|_| {
            let place = self.random_place(space.as_ref(), radius, &mut random)?;
            let is_free = occupied.is_free(place, radius) && !is_blocked(place, radius + occupied.gap);
            is_free.then_some(place)
        })?;
        occupied.grid.add(place, radius);
        let mut velocity = self.stream.velocity;
        if self.stream.velocity_deviation > 0.0 {
            let mut random = self.random(number, Purpose::Velocities);
            let normal = DVec3::new(random.normal(), random.normal(), random.normal());
            velocity += normal * self.stream.velocity_deviation;
        }
        Some(NewGrain {
            material: self.stream.material,
            radius,
            density: self.density,
            position: place,
            velocity,
            angular_velocity: self.stream.angular_velocity,
            fixed: false,
        })
    }

    /// Some places where a grain of a radius may come.
    pub fn places(&self, radius: f64, number: u64) -> Vec<DVec3> {
        let mut random = RandomNumbers::new(self.seed(0), Purpose::Places);
        let space = self.region();
        (0..number)
            .filter_map(|_| self.random_place(space.as_ref(), radius, &mut random))
            .collect()
    }

    fn region(&self) -> Option<Space<'_>> {
        match &self.stream.inlet {
            Inlet::Region(region) => Space::new(region, Some(&self.domain)).ok(),
            _ => None,
        }
    }

    /// A random place, where this draw gives one.
    fn random_place(&self, region: Option<&Space>, radius: f64, random: &mut RandomNumbers) -> Option<DVec3> {
        match (region, &self.mesh, &self.stream.inlet) {
            (_, Some(mesh), _) => mesh.random_place(radius, random),
            (Some(space), None, _) => {
                Some(space.random_place(radius, random)).filter(|place| space.holds(*place, radius))
            }
            (None, None, Inlet::Region(_)) => None,
            (None, None, _) => Some(self.on_face(radius, random)),
        }
    }

    /// A place of the centre on the face, uniform over all where the grain lies inside of its edges.
    fn on_face(&self, radius: f64, random: &mut RandomNumbers) -> DVec3 {
        match self.stream.inlet {
            Inlet::Rectangle { center, half_u, half_v } => {
                let mut along = |half: DVec3| {
                    let length = half.length();
                    half * (random.symmetric() * (length - radius).max(0.0) / length)
                };
                center + along(half_u) + along(half_v)
            }
            Inlet::Disc {
                center,
                normal,
                radius: outer,
            } => {
                let first = normal.any_orthonormal_vector();
                let distance = (outer - radius).max(0.0) * libm::sqrt(random.uniform());
                let (sine, cosine) = libm::sincos(2.0 * PI * random.uniform());
                center + first * (distance * cosine) + normal.cross(first) * (distance * sine)
            }
            Inlet::Region(_) | Inlet::Mesh(_) => DVec3::NAN,
        }
    }

    fn seed(&self, number: u64) -> u64 {
        mix(self.stream.seed ^ mix(number.wrapping_add(1)))
    }

    fn random(&self, number: u64, purpose: Purpose) -> RandomNumbers {
        RandomNumbers::new(self.seed(number), purpose)
    }
}

fn check_place(what: &'static str, value: DVec3) -> Result<(), RegionError> {
    match value.is_finite() && value.abs().max_element() <= LARGEST_LENGTH {
        true => Ok(()),
        false => Err(RegionError::Coordinate { what, value }),
    }
}

impl Occupied<'_> {
    fn is_free(&self, place: DVec3, radius: f64) -> bool {
        let blocked = self.grid.visit(place, radius + self.gap, |near| {
            let least = (radius + near.radius) * (1.0 + CLEARANCE) + self.gap;
            match near.difference.length_squared() < least * least {
                true => ControlFlow::Break(()),
                false => ControlFlow::Continue(()),
            }
        });
        blocked.is_none()
    }
}

#[cfg(test)]
#[path = "stream_tests.rs"]
mod tests;
