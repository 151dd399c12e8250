//! How grains are described before they exist.

use crate::grain_files::{ReadOptions, Which};
use glam::DVec3;
use serde::{Deserialize, Serialize};
use std::path::PathBuf;

/// Whether the shares of a distribution count grains or weigh them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Basis {
    /// By number.
    Number,
    /// By mass.
    Mass,
}

/// Distribution of grain diameters. All lengths [m].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum SizeDistribution {
    /// One diameter.
    Single(f64),
    /// These diameters with these shares (normalised on use).
    List {
        /// Diameters.
        diameters: Vec<f64>,
        /// Shares, as many.
        shares: Vec<f64>,
        /// What the shares count.
        basis: Basis,
    },
    /// Uniform by number.
    Uniform {
        /// Smallest diameter.
        lower: f64,
        /// Largest diameter.
        upper: f64,
    },
    /// Normal by number, cut at the bounds (redrawn).
    Normal {
        /// Mean of the uncut distribution.
        mean: f64,
        /// Standard deviation of the uncut distribution.
        standard_deviation: f64,
        /// Smallest diameter.
        lower: f64,
        /// Largest diameter.
        upper: f64,
    },
    /// Lognormal by number: ln(d) is normal; cut at the bounds (redrawn).
    Lognormal {
        /// Median diameter.
        median: f64,
        /// Geometric standard deviation, above 1.
        geometric_deviation: f64,
        /// Smallest diameter.
        lower: f64,
        /// Largest diameter.
        upper: f64,
    },
    /// Rosin-Rammler by mass: undersize share `Q3(d) = 1 - exp(-(d/scale)^exponent)`; cut at the bounds.
    RosinRammler {
        /// Diameter at which 63.2 % of the mass is finer.
        scale: f64,
        /// Spread, positive.
        exponent: f64,
        /// Smallest diameter.
        lower: f64,
        /// Largest diameter.
        upper: f64,
    },
    /// Cumulative table: share of grains (or mass) finer than each diameter, piecewise linear, from 0 to 1.
    Table {
        /// Diameters, rising.
        diameters: Vec<f64>,
        /// Cumulative shares, rising from 0 to 1.
        finer: Vec<f64>,
        /// What the shares count.
        basis: Basis,
    },
}

/// Region that grains are put into; a grain lies wholly inside.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Region {
    /// Box.
    Box {
        /// Lower corner [m].
        lower: DVec3,
        /// Upper corner [m].
        upper: DVec3,
    },
    /// Cylinder.
    Cylinder {
        /// Start of the axis [m].
        start: DVec3,
        /// End of the axis [m].
        end: DVec3,
        /// Radius [m].
        radius: f64,
    },
}

/// How many grains.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Amount {
    /// This number.
    Count(u32),
    /// Until the grains fill this share of the region.
    VolumeFraction(f64),
}

/// Lattice type.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum LatticeKind {
    /// Simple cubic.
    SimpleCubic,
    /// Body-centred cubic.
    Bcc,
    /// Face-centred cubic.
    Fcc,
    /// Hexagonal close packing, layers along z.
    Hcp,
}

/// Where grains come from.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Source {
    /// A file of grains, of any format of [`crate::grain_files`].
    File {
        /// The file.
        path: PathBuf,
        /// Keep the velocities of the file.
        keep_velocities: bool,
        /// Use this density instead of the file's [kg/m^3].
        density: Option<f64>,
        /// Factor on all lengths of the file.
        scale: f64,
        /// Shift after scaling [m].
        shift: DVec3,
        /// What the file does not tell itself.
        reading: ReadOptions,
        /// Which moment of the file.
        which: Which,
    },
    /// A lattice inside a region, all sites inside it up to `count`.
    Lattice {
        /// Type.
        kind: LatticeKind,
        /// Distance of nearest neighbours [m].
        spacing: f64,
        /// Largest random shift of a site in each direction, as share of the spacing.
        jitter: f64,
        /// Where.
        region: Region,
        /// Distribution of diameters.
        diameter: SizeDistribution,
        /// At most this many, lowest layers first; all sites when absent.
        count: Option<u32>,
    },
    /// Random places without overlap inside a region.
    Random {
        /// Where.
        region: Region,
        /// Distribution of diameters.
        diameter: SizeDistribution,
        /// How many.
        amount: Amount,
    },
    /// Grains one by one.
    List {
        /// Centres [m].
        positions: Vec<DVec3>,
        /// Diameters [m], as many.
        diameters: Vec<f64>,
    },
}

/// One batch of grains.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Insertion {
    /// Name, for messages.
    pub name: String,
    /// Index of the material; of the material of type 1 when the source is a file with types.
    pub material: u16,
    /// Index of the material of each type 1, 2, ... of a file; empty: all grains are of `material`.
    pub types: Vec<u16>,
    /// Where the grains come from.
    pub source: Source,
    /// Velocity of every grain [m/s] (added to the file's when these are kept).
    pub velocity: DVec3,
    /// Standard deviation of a random velocity in each direction [m/s].
    pub velocity_deviation: f64,
    /// Angular velocity of every grain [1/s].
    pub angular_velocity: DVec3,
    /// Tag of every grain; when absent that which the file tells, else 0.
    pub tag: Option<i32>,
    /// Whether the grains stay where they are, whatever acts on them: a rough floor. They start at rest.
    pub fixed: bool,
    /// Seed of this batch.
    pub seed: u64,
}
