//! Where grains come from: files, lattices, random packings, size distributions.
//!
//! The same description gives the same grains, to the bit, on every machine: random numbers come from one PCG generator
//! per purpose, functions from `libm`, and everything runs in one order on one thread.

mod grain_file;
mod lattice;
mod mesh_places;
mod overlap;
mod overlap_relaxation;
mod place_grid;
mod random;
mod random_packing;
mod region;
mod rosin_rammler;
mod sequential_addition;
mod size_distribution;
mod spec;
mod stream;

pub use lattice::LatticeError;
pub use mesh_places::MeshInlet;
pub use overlap::{Overlap, first_overlap};
pub use random_packing::{MAX_FRACTION, PackingError};
pub use region::RegionError;
pub use size_distribution::{SizeError, SizeSampler};
pub use spec::{Amount, Basis, Insertion, LatticeKind, Region, SizeDistribution, Source};
pub use stream::{Inlet, MAX_AT_ONCE, Occupied, Stream, Streaming, Vicinity};

use crate::grain_files::{Cell, FileError};
use crate::materials::Material;
use crate::particles::{Domain, NewGrain};
use glam::DVec3;
use lattice::Lattice;
pub(crate) use random::normal_quantile;
use random::{Purpose, RandomNumbers};
use region::Space;
use thiserror::Error;

/// Most grains that one insertion may make.
pub const MAX_GRAINS: u32 = 20_000_000;

/// Centre and radius [m].
type SizedPlace = (DVec3, f64);

/// What an insertion made.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Inserted {
    /// The grains.
    pub grains: Vec<NewGrain>,
    /// Their ids, as many, when the file tells them.
    pub ids: Option<Vec<u32>>,
    /// Their tags, as many, when the file tells them.
    pub tags: Option<Vec<i32>>,
    /// The box of the file, scaled and shifted as they are, when it tells one.
    pub cell: Option<Cell>,
}

/// An insertion that cannot be made.
#[derive(Debug, Error)]
#[error("insertion `{insertion}`: {problem}")]
pub struct InsertionError {
    /// Name of the insertion.
    pub insertion: String,
    /// What is wrong.
    #[source]
    pub problem: InsertionProblem,
}

/// Why an insertion cannot be made.
#[derive(Debug, Error)]
#[allow(missing_docs)]
pub enum InsertionProblem {
    #[error(transparent)]
    Size(#[from] SizeError),
    #[error(transparent)]
    Region(#[from] RegionError),
    #[error(transparent)]
    Lattice(#[from] LatticeError),
    #[error(transparent)]
    Packing(#[from] PackingError),
    #[error(transparent)]
    File(Box<FileError>),
    #[error("material number {index} does not exist; there are {known}")]
    MaterialIndex { index: u16, known: usize },
    #[error("{what} is ({}, {}, {}); it must be finite numbers", value.x, value.y, value.z)]
    Velocity { what: &'static str, value: DVec3 },
    #[error("the velocity deviation is {value} m/s; it must be 0 or a positive number")]
    VelocityDeviation { value: f64 },
    #[error("there are {positions} positions but {diameters} diameters; give as many of both")]
    ListLengths { positions: usize, diameters: usize },
    #[error("the list of positions is empty; give at least one")]
    EmptyList,
    #[error("grain {number} of the list: {what} is {value:?}; {allowed}")]
    ListValue {
        number: usize,
        what: &'static str,
        value: f64,
        allowed: &'static str,
    },
    #[error(
        "the inlet reaches from ({}, {}, {}) to ({}, {}, {}), beyond the domain; widen the domain or move the inlet",
        lower.x, lower.y, lower.z, upper.x, upper.y, upper.z
    )]
    InletOutside { lower: DVec3, upper: DVec3 },
    #[error(
        "the inlet has room for grains of {room:.4e} m; the largest that comes has a diameter of {largest:.4e} m: widen what `from` tells"
    )]
    InletTooSmall { room: f64, largest: f64 },
    #[error(transparent)]
    Mesh(#[from] crate::walls::MeshError),
    #[error("{what} is {value:?}; {allowed}")]
    FileSetting {
        what: &'static str,
        value: f64,
        allowed: &'static str,
    },
}

impl From<FileError> for InsertionProblem {
    fn from(error: FileError) -> Self {
        Self::File(Box::new(error))
    }
}

/// Makes the grains of an insertion.
///
/// `occupied` are the grains already there (centre, radius [m]); random packings keep clear of them. `domain` tells
/// which sides are periodic. Grains of files, lists and lattices may overlap: see [`first_overlap`].
///
/// A random velocity is drawn for each grain from a normal distribution; the mean of what was drawn is not removed, so
/// the batch may drift by about `velocity_deviation / sqrt(number)`.
pub fn insert(
    insertion: &Insertion,
    materials: &[Material],
    occupied: &[(DVec3, f64)],
    domain: Option<&Domain>,
) -> Result<Inserted, InsertionError> {
    make(insertion, materials, occupied, domain).map_err(|problem| InsertionError {
        insertion: insertion.name.clone(),
        problem,
    })
}

fn make(
    insertion: &Insertion,
    materials: &[Material],
    occupied: &[(DVec3, f64)],
    domain: Option<&Domain>,
) -> Result<Inserted, InsertionProblem> {
    check_common(insertion, materials)?;
    let mut inserted = match &insertion.source {
        Source::File { .. } => grain_file::insert_file(insertion, materials)?,
        Source::Lattice {
            kind,
            spacing,
            jitter,
            region,
            diameter,
            count,
        } => {
            let lattice = Lattice {
                kind: *kind,
                spacing: *spacing,
                jitter: *jitter,
                count: *count,
            };
            let sizes = SizeSampler::new(diameter)?;
            let places = lattice.fill(&Space::new(region, domain)?, &sizes, insertion.seed)?;
            grains_at(insertion, materials, &places)
        }
        Source::Random {
            region,
            diameter,
            amount,
        } => {
            let sizes = SizeSampler::new(diameter)?;
            let space = Space::new(region, domain)?;
            let places = random_packing::pack(&space, &sizes, *amount, occupied, insertion.seed)?;
            grains_at(insertion, materials, &places)
        }
        Source::List { positions, diameters } => grains_at(insertion, materials, &listed(positions, diameters)?),
    };
    match insertion.fixed {
        true => fix(&mut inserted.grains),
        false => add_velocities(insertion, &mut inserted.grains),
    }
    Ok(inserted)
}

fn check_common(insertion: &Insertion, materials: &[Material]) -> Result<(), InsertionProblem> {
    let known = materials.len();
    for &index in insertion.types.iter().chain([&insertion.material]) {
        if usize::from(index) >= known {
            return Err(InsertionProblem::MaterialIndex { index, known });
        }
    }
    for (what, value) in [
        ("the velocity", insertion.velocity),
        ("the angular velocity", insertion.angular_velocity),
    ] {
        if !value.is_finite() {
            return Err(InsertionProblem::Velocity { what, value });
        }
    }
    let value = insertion.velocity_deviation;
    match value.is_finite() && value >= 0.0 {
        true => Ok(()),
        false => Err(InsertionProblem::VelocityDeviation { value }),
    }
}

/// Makes grains stay where they are.
fn fix(grains: &mut [NewGrain]) {
    for grain in grains {
        (grain.velocity, grain.angular_velocity) = (DVec3::ZERO, DVec3::ZERO);
        grain.fixed = true;
    }
}

/// Grains at rest of the material of the insertion.
fn grains_at(insertion: &Insertion, materials: &[Material], places: &[SizedPlace]) -> Inserted {
    let density = materials[usize::from(insertion.material)].density;
    let grains = places.iter().map(|&(position, radius)| NewGrain {
        fixed: false,
        material: insertion.material,
        radius,
        density,
        position,
        velocity: DVec3::ZERO,
        angular_velocity: DVec3::ZERO,
    });
    Inserted {
        grains: grains.collect(),
        ids: None,
        tags: None,
        cell: None,
    }
}

fn listed(positions: &[DVec3], diameters: &[f64]) -> Result<Vec<SizedPlace>, InsertionProblem> {
    if positions.len() != diameters.len() {
        return Err(InsertionProblem::ListLengths {
            positions: positions.len(),
            diameters: diameters.len(),
        });
    }
    if positions.is_empty() {
        return Err(InsertionProblem::EmptyList);
    }
    let mut places = Vec::with_capacity(positions.len());
    for (k, (&position, &diameter)) in positions.iter().zip(diameters).enumerate() {
        let number = k + 1;
        if !size_distribution::DIAMETERS.contains(&diameter) {
            return Err(InsertionProblem::ListValue {
                number,
                what: "the diameter",
                value: diameter,
                allowed: "allowed are 1e-12 m to 1e6 m",
            });
        }
        let outside = |value: &f64| !(0.0..=region::LARGEST_LENGTH).contains(&value.abs());
        if let Some(value) = position.to_array().into_iter().find(outside) {
            return Err(InsertionProblem::ListValue {
                number,
                what: "a coordinate",
                value,
                allowed: "coordinates must be numbers within 1e12 m",
            });
        }
        places.push((position, 0.5 * diameter));
    }
    Ok(places)
}

/// Adds the velocities of the insertion to what the grains have.
fn add_velocities(insertion: &Insertion, grains: &mut [NewGrain]) {
    let mut random = RandomNumbers::new(insertion.seed, Purpose::Velocities);
    for grain in grains {
        grain.velocity += insertion.velocity;
        grain.angular_velocity += insertion.angular_velocity;
        if insertion.velocity_deviation > 0.0 {
            let normal = DVec3::new(random.normal(), random.normal(), random.normal());
            grain.velocity += normal * insertion.velocity_deviation;
        }
    }
}

#[cfg(test)]
mod tests;
