//! What is measured of a state: energies, contact statistics, stress, wall loads.

use glam::DVec3;

/// Energies of the ledger [J]. Residual: what is there and what was dissipated, less what came in.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Energies {
    /// Kinetic energy of translation.
    pub kinetic: f64,
    /// Kinetic energy of rotation.
    pub rotational: f64,
    /// Potential energy in the field of gravity.
    pub gravitational: f64,
    /// Stored by normal laws.
    pub elastic: f64,
    /// Stored by tangential springs.
    pub tangential: f64,
    /// Stored by rolling springs.
    pub rolling: f64,
    /// Dissipated by normal dashpots since the start.
    pub viscous_dissipated: f64,
    /// Dissipated by friction since the start.
    pub friction_dissipated: f64,
    /// Dissipated by rolling resistance since the start.
    pub rolling_dissipated: f64,
    /// Work done on the grains by moving walls since the start.
    pub wall_work: f64,
    /// Energy of grains inserted since the start.
    pub inserted: f64,
    /// Energy of grains removed since the start.
    pub removed: f64,
    /// Share of the energy that passed through the system which the books do not explain.
    pub residual: f64,
}

/// What a wall feels.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct WallLoad {
    /// Force of the grains on the wall [N].
    pub force: DVec3,
    /// Torque of the grains on the wall about the origin of its pose [N m].
    pub torque: DVec3,
    /// Displacement of the wall since the start of the run [m].
    pub displacement: DVec3,
    /// Number of contacts with grains.
    pub contacts: u32,
}

/// Everything that one row of the series tells.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Measures {
    /// Steps done.
    pub step: u64,
    /// Simulated time [s].
    pub time: f64,
    /// Index of the stage.
    pub stage: usize,
    /// Time since the start of the stage [s].
    pub stage_time: f64,
    /// Number of grains.
    pub grains: usize,
    /// Number of contacts between grains.
    pub contacts: usize,
    /// Mean number of contacts per grain, those with walls counted.
    pub coordination: f64,
    /// Largest overlap as a share of the smaller radius.
    pub max_overlap: f64,
    /// Largest speed [m/s].
    pub max_speed: f64,
    /// Kinetic over elastic energy.
    pub kinetic_over_elastic: f64,
    /// Energies.
    pub energies: Energies,
    /// Stress tensor, compression positive, of contacts between grains over the volume: xx, yy, zz, xy, xz, yz [Pa].
    pub stress: [f64; 6],
    /// Solid volume over the volume that is open to the grains (see the book), overlaps not subtracted.
    pub packing_fraction: f64,
    /// Total momentum [kg m/s].
    pub momentum: DVec3,
    /// One entry per wall.
    pub walls: Vec<WallLoad>,
}
