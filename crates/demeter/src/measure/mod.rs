//! What is measured of a state: energies, contact statistics, stress, wall loads, and what a scenario asks for beside:
//! networks of contacts, distributions of forces, grains in regions, their ways, and flows through gates.
//!
//! Where processes share the run each calls what measures, all in the same order; what it answers holds for all grains at the first process,
//! and for nothing at others.
//!
//! A contact counts when it acts, that is, when its normal force is not zero: [`ContactChunk::acts`](crate::contacts::ContactChunk::acts).

mod angles;
mod chains;
mod collisions;
mod contacts_at;
mod cylinder_profile;
mod deforming_box;
mod displacement;
mod extent;
mod fabric;
mod field;
mod flow;
mod forces;
mod images;
mod mixing;
mod neighbour_mixing;
mod network;
mod paths;
mod profile;
mod records;
mod region;
mod residence;
mod row_sums;
mod selection;
mod slope;
mod sphere_in_box;
mod told;
mod told_first;
mod trace;
mod wall_motion;
mod walls_load;
mod wear;

pub use crate::simulation::Energies;
pub use angles::{ContactAngles, MAX_ANGLES, Preference, Rose};
pub use chains::{ChainLink, ChainLinks, ForceChains};
pub(crate) use collisions::hear_impacts;
pub use collisions::{COLLISION_COLUMNS, CollisionState, Collisions, Counted, EnergyBins, MAX_ENERGY_BINS};
pub(crate) use contacts_at::{ContactAt, SomeContacts};
pub use contacts_at::{ContactsAt, contact_records};
pub use cylinder_profile::{Along, CylinderProfile, Ring};
pub use deforming_box::BOX_COLUMNS;
pub(crate) use deforming_box::{box_titles, box_values};
pub use displacement::{DISPLACEMENT_COLUMNS, Displacement, DisplacementState};
pub use extent::{EXTENT_COLUMNS, Extent};
pub use fabric::{FABRIC_COLUMNS, Fabric};
pub use field::{
    CellValues, Field, FieldSums, FieldValues, Kernel, KernelIn, KernelShape, LARGEST_CUT, LEAST_CUT, MAX_FIELD_CELLS,
    SUMS,
};
pub use flow::{FLOW_COLUMNS, FlowState, Gate, LOOK_EVERY, MassFlow};
pub use forces::{BinsError, ForceDistribution, ForceHistogram, MAX_BINS};
pub use mixing::{MAX_CELLS, MIXING_COLUMNS, Mixing, MixingSpace};
pub use neighbour_mixing::{MAX_NEAREST, NEIGHBOUR_COLUMNS, NeighbourMixing};
pub use network::{ContactNetwork, NetworkMeasures};
pub use paths::{MAX_PATHS, PathPoint, Paths};
pub use profile::{MAX_SLICES, Profile, Slice};
pub use records::{ContactColumns, wall_surfaces};
pub use region::{OF_MATERIAL_COLUMNS, REGION_COLUMNS, RegionCount};
pub use residence::{MAX_RESIDENCE_BINS, RESIDENCE_COLUMNS, Residence, ResidenceState};
pub use selection::Selection;
pub use slope::{SLOPE_COLUMNS, Slope};
pub use sphere_in_box::sphere_in_box;
pub use told::{DOMAIN_COLUMNS, FEED_COLUMNS, REMOVAL_COLUMNS, ToldColumn, Value};
pub use trace::{GrainTrace, TRACE_COLUMNS};
pub use wall_motion::WALL_MOTION_COLUMNS;
pub(crate) use wall_motion::wall_motion_values;
pub use walls_load::{AXIAL_COLUMNS, WALLS_LOAD_COLUMNS, WallsLoad};
pub use wear::{WEAR_COLUMNS, wear_values};

use crate::particles::Zone;
use crate::simulation::Simulation;
use crate::walls::Wall;
use glam::DVec3;
use row_sums::RowSums;
use told_first::acting;

/// Whether a grain lies in a zone, whose parts go with walls.
pub(crate) fn holds(sim: &Simulation, zone: &Zone, grain: usize) -> bool {
    holds_place(sim, zone, sim.grains.position[grain])
}

/// Whether a place lies in a zone, whose parts go with walls.
fn holds_place(sim: &Simulation, zone: &Zone, place: DVec3) -> bool {
    let brought_back = |wall: usize, p: DVec3| sim.walls.get(wall).map_or(p, |wall| wall.brought_back(p));
    zone.holds(sim.domain(), place, brought_back)
}

/// Number of contacts of every grain that act, those with walls counted; of own grains alone, where processes share the run.
pub(crate) fn contact_counts(sim: &Simulation) -> Vec<u32> {
    let mut counts = vec![0; sim.grains.len()];
    let all = acting(&sim.contacts.pairs, false).chain(acting(&sim.contacts.walls, true));
    for grain in all.flat_map(|contact| contact.grains()).flatten() {
        counts[grain] += 1;
    }
    counts
}

/// What a wall feels.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct WallLoad {
    /// Force of the grains on the wall [N].
    pub force: DVec3,
    /// Torque of the grains on the wall about the origin of its pose [N m].
    pub torque: DVec3,
    /// Rate of the work of the wall on the grains [W].
    pub power: f64,
    /// Work of the wall on the grains since the start of the run [J].
    pub work: f64,
    /// Displacement of the wall since the start of the run [m].
    pub displacement: DVec3,
    /// Number of contacts with grains that act.
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
    /// Number of contacts between grains that act.
    pub contacts: usize,
    /// Mean number of contacts that act per grain, those with walls counted.
    pub coordination: f64,
    /// Largest overlap as a share of the smaller radius.
    pub max_overlap: f64,
    /// Largest speed [m/s]; beyond the affine flow and the drift of all grains where the box deforms.
    pub max_speed: f64,
    /// Kinetic over elastic energy; of the motion beyond the affine flow and the drift of all grains where the box deforms.
    pub kinetic_over_elastic: f64,
    /// Energies.
    pub energies: Energies,
    /// Stress tensor of all contacts over the volume of the box around the grains, compression positive:
    /// xx, yy, zz, xy, xz, yz [Pa].
    pub stress: [f64; 6],
    /// Solid volume over the volume of the box around the grains' surfaces (the whole box in periodic directions),
    /// overlaps not subtracted.
    pub packing_fraction: f64,
    /// Strain told by the plate of a [`StrainGauge`]; `None` without one.
    pub strain: Option<f64>,
    /// Total momentum [kg m/s].
    pub momentum: DVec3,
    /// One entry per wall.
    pub walls: Vec<WallLoad>,
    /// One entry per [`ContactNetwork`] that was asked for; [`measure`] leaves it empty.
    pub networks: Vec<NetworkMeasures>,
    /// Values of the columns of all other measures that were asked for, and of feeds and removals; [`measure`] leaves it
    /// empty.
    pub told: Vec<Value>,
}

/// A wall whose displacement tells the strain of the packing: `strain = (displacement . direction - from) / length`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StrainGauge {
    /// Index of the wall; no strain is told where there is none.
    pub wall: usize,
    /// Unit vector along which the wall compresses the packing.
    pub direction: DVec3,
    /// Displacement at which the strain is 0 [m].
    pub from: f64,
    /// Length of the packing at strain 0 [m].
    pub length: f64,
}

impl StrainGauge {
    fn strain(&self, sim: &Simulation) -> Option<f64> {
        let way = sim.walls.get(self.wall)?.displacement().dot(self.direction);
        Some((way - self.from) / self.length)
    }
}

/// Where a measurement stands in the protocol.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Moment {
    /// Index of the stage.
    pub stage: usize,
    /// Time since the start of the stage [s].
    pub stage_time: f64,
}

/// Measures everything that one row of the series tells. Where processes share the run each calls this.
pub fn measure(sim: &mut Simulation, moment: Moment, gauge: Option<&StrainGauge>) -> Measures {
    let energies = sim.energies();
    let sums = RowSums::of_all(sim);
    let grains = sim.grains.len();
    let (contacts, wall_contacts) = (sums.contacts as usize, sums.wall_contacts as usize);
    let volume = sums.volume(sim);
    let per_volume = |sum: f64| if volume > 0.0 { sum / volume } else { 0.0 };
    Measures {
        step: sim.step,
        time: sim.time(),
        stage: moment.stage,
        stage_time: moment.stage_time,
        grains,
        contacts,
        coordination: (2 * contacts + wall_contacts) as f64 / grains.max(1) as f64,
        max_overlap: sums.max_overlap,
        max_speed: sim.beyond_flow().map_or(sums.speed2.sqrt(), |(_, speed)| speed),
        kinetic_over_elastic: kinetic_over_elastic(sim, &energies),
        stress: sums.stress.map(per_volume),
        packing_fraction: per_volume(sums.solid),
        strain: gauge.and_then(|gauge| gauge.strain(sim)),
        momentum: sums.momentum,
        walls: wall_loads(sim, &sums.of_walls),
        networks: Vec::new(),
        told: Vec::new(),
        energies,
    }
}

/// Kinetic over elastic energy; infinite without elastic energy, 0 for grains at rest without contact. Where contacts are stuck in attraction,
/// whose energy is below that of grains far apart, it counts by its amount. Where the box deforms, the flow of the box does not count.
pub fn kinetic_over_elastic(sim: &Simulation, energies: &Energies) -> f64 {
    let kinetic = sim.beyond_flow().map_or(energies.kinetic, |(kinetic, _)| kinetic) + energies.rotational;
    if kinetic > 0.0 {
        kinetic / energies.elastic.abs()
    } else {
        0.0
    }
}

/// Corners of the box around the surfaces of the grains that count [m]; infinite, the lower above the upper, without any.
///
/// Where processes share the run each calls this.
fn bounds_of(sim: &Simulation, counts: impl Fn(usize) -> bool) -> (DVec3, DVec3) {
    let (mut lower, mut upper) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    for grain in sim.own_grains().filter(|&grain| counts(grain)) {
        let (p, r) = (sim.grains.position[grain], sim.grains.radius(grain));
        lower = lower.min(p - r);
        upper = upper.max(p + r);
    }
    let [x, y, z, upper @ ..] = sim.largest_of_all([-lower.x, -lower.y, -lower.z, upper.x, upper.y, upper.z]);
    (-DVec3::new(x, y, z), DVec3::from_array(upper))
}

fn wall_loads(sim: &Simulation, contacts: &[u32]) -> Vec<WallLoad> {
    let load = |(k, wall): (usize, &Wall)| {
        let (force, torque) = wall.load();
        WallLoad {
            force,
            torque,
            power: wall.power(),
            work: wall.work().work,
            displacement: wall.displacement(),
            contacts: contacts.get(k).copied().unwrap_or(0),
        }
    };
    sim.walls.iter().enumerate().map(load).collect()
}
