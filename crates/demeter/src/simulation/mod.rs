//! The state of a run and its protocol.

mod custom;
mod deformation;
mod deforming_box;
pub(crate) mod division;
mod equipment;
mod exchange;
mod fastest_impact;
mod impacts;
mod intervention;
mod jumps;
mod ledger;
pub(crate) mod memory;
mod misplaced;
pub(crate) mod profile;
mod protocol;
mod pulls;
mod roofline;
mod shear_drive;
mod skin;
mod spring_work;
mod state;
#[cfg(test)]
mod tests;
mod time_step;
mod too_stiff;

pub use crate::step::Effort;
pub use custom::{CustomForce, CustomMotion, CustomMotionError, ForceMoment, GrainLoads, NumberCourse, VectorCourse};
pub(crate) use deformation::FollowedStress;
pub use deformation::{Deformation, DeformationError, Drive, Misfit, Shear};
pub use deforming_box::BoxState;
pub(crate) use division::Segment;
pub use division::{Sharing, SharingReport};
pub use equipment::WallInTheWay;
pub use exchange::ExchangeError;
pub use fastest_impact::{FastestImpact, fastest_impact};
pub use intervention::ChangeError;
pub use ledger::{Books, Energies};
pub use memory::MemoryPart;
pub use profile::{Phase, PhaseTime, ProfileReport};
pub use protocol::{Cadence, ColumnStop, Stage, StopCondition, StressOf};
pub(crate) use protocol::{ends_at, ends_within};
pub(crate) use pulls::can_pull;
pub use roofline::{Machine, Roofline, Work};
pub use skin::Skin;
pub use state::{SimulationState, StateError};
pub use time_step::{
    Bearable, RESTITUTION_ERROR, SAFE_SHARE, TimeScale, TimeStepError, Verdict, WallPartner, refusals,
    shortest_time_scale, unsafe_share, with_free_wall,
};
pub(crate) use too_stiff::too_stiff;

use deforming_box::DeformingBox;
pub(crate) use deforming_box::USABLE;
use division::Division;
pub(crate) use misplaced::MOST_TOLD;
use misplaced::Uncounted;
use skin::SkinTuner;
pub(crate) use skin::{Counts, ROOM_FOR_BULGES};
pub(crate) use time_step::largest_reach;

use crate::comm::Single;
use crate::contacts::step_work::StepWork;
use crate::contacts::sum::Sums;
use crate::contacts::{ContactChunk, Contacts, Coupling, Departure, Fault, Impact, NearTables, Span, Surfaces, laws};
use crate::materials::Materials;
use crate::neighbours::{Bounds, FormerPlaces, Moves, Neighbours, put_in_order};
use crate::particles::spread::{GRAINS_OF_A_SPREAD, Spread};
use crate::particles::{Domain, Grains, HigherDerivatives};
use crate::step::{CouplingState, Motion};
use crate::threads::Awake;
use crate::walls::{FreeStep, Pose, Wall};
use demeter_physics::geometry::contact_sphere_sphere::{Contact, contact_sphere_sphere};
use demeter_physics::integrator::Integrator;
use demeter_physics::lanes::Instructions;
use glam::DVec3;

/// Grains are put in order again when so much more of the candidates, as a share of all, are scattered in memory than right
/// after the last time.
const DECAY: f64 = 0.05;

/// Where grains are in memory when candidates are found.
#[derive(Debug)]
enum Places {
    /// Where they were.
    Kept,
    /// Where they were, but some contacts come from other processes.
    HandedOver,
    /// Elsewhere.
    New(Moves),
}

/// What becomes of forces and torques when candidates are found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Loads {
    /// They stay.
    Kept,
    /// They are found anew afterwards, and take no memory meanwhile where no other process shares the run.
    Forgotten,
}

/// What a simulation is made of.
#[derive(Clone, Debug)]
pub struct Setup {
    /// Grains at the start.
    pub grains: Grains,
    /// Walls at the start; in a periodic domain grains feel them across its sides once they are told to by [`Wall::repeat`].
    pub walls: Vec<Wall>,
    /// Materials and their laws.
    pub materials: Materials,
    /// The domain.
    pub domain: Domain,
    /// Acceleration of gravity [m/s^2].
    pub gravity: DVec3,
    /// How the equations of motion are integrated.
    pub integrator: Integrator,
    /// Time step [s].
    pub dt: f64,
    /// Distance beyond touching at which bodies become candidates.
    pub skin: Skin,
    /// Largest overlap allowed, as share of the smaller radius.
    pub max_overlap: f64,
    /// How contacts that feel each other are treated; nothing where all are independent.
    pub coupling: Coupling,
}

/// A run: grains, walls, contacts and books at one moment.
#[derive(Debug)]
pub struct Simulation {
    /// Grains.
    pub(crate) grains: Grains,
    /// Walls.
    pub walls: Vec<Wall>,
    /// Materials and their laws.
    pub materials: Materials,
    /// Steps done.
    pub step: u64,
    /// Time step [s].
    pub(crate) dt: f64,
    /// When the latest forces act.
    pub(crate) span: Span,
    /// Acceleration of gravity [m/s^2]. What a change does to the energy is not booked, as [`set_gravity`](Self::set_gravity) does.
    pub gravity: DVec3,
    /// Active contacts.
    pub contacts: Contacts,
    /// Energy books.
    pub books: Books,
    pub(crate) integrator: Integrator,
    pub(crate) comm: Single,
    pub(crate) neighbours: Neighbours,
    pub(crate) skin: f64,
    /// Radius of the smallest grain of all processes when candidates were last found [m]; 0 before.
    least_radius: f64,
    pub(crate) tuner: SkinTuner,
    pub(crate) near: NearTables,
    /// How the grains move, by stretches of [`GRAINS_OF_A_SPREAD`] behind each other.
    pub(crate) spreads: Vec<Spread>,
    /// The farthest that any grain can have come since the candidates were found [m]; infinite as long as nothing was measured.
    pub(crate) travel: f64,
    /// Largest gap across which any law acts [m]; candidates are found that much farther away.
    pub(crate) max_reach: f64,
    pub(crate) max_overlap: f64,
    /// `None` where all contacts are independent.
    pub(crate) coupling: Option<CouplingState>,
    pub(crate) sums: Sums,
    /// What the contacts did in the latest step.
    pub(crate) work: StepWork,
    /// `None` where this process has the run for itself.
    pub(crate) division: Option<Box<Division>>,
    /// How often the tables of candidates were found.
    tables: u64,
    /// `None` where the box keeps its shape.
    pub(crate) deforming: Option<Box<DeformingBox>>,
    pub(crate) resists_rolling: bool,
    /// Whether some wall records what contacts do to it.
    pub(crate) records_walls: bool,
    /// Contacts that began and were not asked for yet; `None` where nobody asks.
    impacts: Option<Vec<Impact>>,
    pub(crate) instructions: Instructions,
    /// `None` where no force and no motion is custom.
    customs: Option<Box<custom::Customs>>,
    /// `None` where nobody asked where the time goes.
    pub(crate) profile: Option<Box<profile::Profile>>,
    /// The highest id that was ever given.
    latest_id: u32,
    /// Whether grains that have become scattered in memory are put in order again.
    puts_in_order: bool,
    /// Share of the candidates that were scattered in memory when the grains were put in order.
    scattered_in_order: f64,
    rebuilds: u64,
    /// Bounds of the grains when the candidates were found.
    bounds: (DVec3, DVec3),
    /// Places of the walls one step before.
    walls_before: Vec<Pose>,
    /// What all freely moving walls did in the latest step.
    pub(crate) free_walls: FreeStep,
    /// How the walls move in this step.
    pub(crate) surfaces: Surfaces,
    /// Keeps the other threads from sleeping within a step.
    pub(crate) awake: Awake,
    started: bool,
    /// The grain with the lowest id that went round a periodic box more often than is counted, until that is told.
    uncounted: Option<Uncounted>,
    /// The first by their ids of the grains that left the domain and were removed, until they are told.
    pub(crate) departures: Vec<Departure>,
    /// Whether what the contacts did in the latest step is still to be summed up per grain and to correct its velocity.
    pub(crate) awaits_kick: bool,
}

impl Simulation {
    /// A simulation before its start; the first step, or [`Simulation::start`], finds the first forces. The setup is taken as it is; that of a
    /// scenario was looked at before.
    ///
    /// # Panics
    ///
    /// This, or a later step, may panic or compute nonsense unless
    ///
    /// * every array of the grains has one value for each, ids differ, and radii, masses, places and velocities are finite, the former two above 0,
    /// * materials of grains and walls are below the number of materials, and walls move with walls that exist,
    /// * `dt` and `max_overlap` are finite and above 0, `gravity` is finite, and the skin is finite and not negative,
    /// * the domain has a size above 0 in each direction, and is so long where it is periodic that no grain meets itself, or a partner twice.
    pub fn new(mut setup: Setup) -> Self {
        memory::have_tables_from_the_system();
        let stride = laws::stride(&setup.materials);
        let resists_rolling = laws::resists_rolling(&setup.materials);
        let records_walls = setup.walls.iter().any(Wall::is_recorded);
        let remembered = match setup.integrator {
            Integrator::VelocityVerlet => 0,
            Integrator::Gear => setup.grains.len(),
        };
        setup.grains.higher.resize(remembered, HigherDerivatives::default());
        if setup.integrator == Integrator::Gear && setup.grains.orientation.is_none() {
            setup.grains.follow_orientations();
        }
        let walls: Vec<WallPartner> = setup.walls.iter().map(WallPartner::of).collect();
        let max_reach = largest_reach(&setup.grains, &walls, &setup.materials);
        let coupling = CouplingState::new(setup.coupling, &setup.grains, &setup.materials);
        let tuner = SkinTuner::new(
            setup.skin,
            &setup.grains,
            &setup.domain,
            (max_reach, coupling.is_some()),
        );
        let mut neighbours = Neighbours::default();
        if coupling.is_some() {
            neighbours.tell_pairs_of_grains();
        }
        Self {
            tuner,
            integrator: setup.integrator,
            comm: Single::new(setup.domain),
            latest_id: setup.grains.id.iter().copied().max().unwrap_or(0),
            walls_before: setup.walls.iter().map(Wall::pose).collect(),
            grains: setup.grains,
            walls: setup.walls,
            materials: setup.materials,
            step: 0,
            dt: setup.dt,
            span: Span::of_step(setup.dt),
            gravity: setup.gravity,
            contacts: Contacts {
                stride,
                ..Contacts::default()
            },
            books: Books::default(),
            neighbours,
            skin: setup.skin.first(),
            least_radius: 0.0,
            near: NearTables::default(),
            spreads: Vec::new(),
            travel: f64::INFINITY,
            max_reach,
            max_overlap: setup.max_overlap,
            coupling,
            sums: Sums::default(),
            work: StepWork::default(),
            division: None,
            tables: 0,
            deforming: None,
            resists_rolling,
            records_walls,
            impacts: None,
            instructions: Instructions::widest(),
            customs: None,
            profile: None,
            puts_in_order: true,
            scattered_in_order: 0.0,
            rebuilds: 0,
            bounds: (DVec3::ZERO, DVec3::ZERO),
            free_walls: FreeStep::default(),
            surfaces: Surfaces::default(),
            awake: Awake::default(),
            started: false,
            uncounted: None,
            departures: Vec::new(),
            awaits_kick: false,
        }
    }

    /// Grains.
    pub fn grains(&self) -> &Grains {
        &self.grains
    }

    /// Grains that may be changed: contacts are looked for anew in the next step, as nothing is known of how they move. What that does to
    /// their energy is not booked, as [`set_velocities`](Self::set_velocities), [`set_angular_velocities`](Self::set_angular_velocities) and
    /// [`set_positions`](Self::set_positions) do.
    pub fn grains_mut(&mut self) -> &mut Grains {
        self.near.look_anew();
        self.travel = f64::INFINITY;
        if let Some(coupling) = &self.coupling {
            coupling.outdate();
            self.contacts
                .pairs
                .iter_mut()
                .for_each(|chunk| chunk.coupling.size.clear());
        }
        &mut self.grains
    }

    /// Time step [s].
    pub fn dt(&self) -> f64 {
        self.dt
    }

    /// Takes steps of another length [s] from now on. Time is counted in steps: that of those done changes, too. How long a step may be is not
    /// looked at, as it is for a scenario: [`shortest_time_scale`] and [`TimeScale::judge`] tell.
    pub fn set_dt(&mut self, dt: f64) -> Result<(), TimeStepError> {
        if !(dt > 0.0 && dt.is_finite()) {
            return Err(TimeStepError::NotPositive { dt });
        }
        self.near.look_anew();
        self.dt = dt;
        Ok(())
    }

    /// Simulated time [s].
    pub fn time(&self) -> f64 {
        self.step as f64 * self.dt
    }

    /// Finds the forces of the first moment and opens the books. Nothing happens when that was done.
    pub fn start(&mut self) -> Result<(), Fault> {
        if !self.started {
            self.find_first_forces()?;
            let tally = self.step_tally();
            let energies = self.energies_now(tally);
            self.books.open(&energies, tally);
            self.started = true;
            memory::give_back();
        }
        Ok(())
    }

    /// Uses other instructions of the processor than the widest; the bits of the results are the same.
    pub fn set_instructions(&mut self, instructions: Instructions) {
        self.instructions = instructions;
    }

    /// Leaves the grains in the order that they have in memory, however scattered they become. Every grain is summed up in that
    /// order, so the bits of a run do not depend on how often candidates are found anew then. A checkpoint does not hold this
    /// choice: it is for comparisons, such as that rebuilds lose no contact.
    pub fn leave_order(&mut self) {
        self.puts_in_order = false;
    }

    /// Whether the forces of the first moment were found.
    pub fn is_started(&self) -> bool {
        self.started
    }

    /// Geometry of a contact at this moment: as its laws saw it.
    pub fn contact(&self, chunk: &ContactChunk, contact: usize) -> Contact {
        if let Some(contact) = chunk.now.geometry.get(contact) {
            return *contact;
        }
        let (i, j) = (chunk.i[contact] as usize, chunk.j[contact] as usize);
        let apart = self.comm.difference(self.grains.position[i], self.grains.position[j]);
        contact_sphere_sphere(apart, self.grains.radius(i), self.grains.radius(j))
    }

    /// Distance beyond touching at which bodies become candidates [m].
    pub fn skin(&self) -> f64 {
        self.skin
    }

    /// The domain.
    pub fn domain(&self) -> &Domain {
        self.comm.domain()
    }

    /// The edges of the domain: what leads from its lower corner along its sides; across a periodic side, from a grain to its image [m].
    pub fn box_edges(&self) -> [DVec3; 3] {
        let domain = self.domain();
        let size = domain.size();
        std::array::from_fn(|axis| match domain.periodic[axis] {
            true => self.comm.edge(axis),
            false => DVec3::AXES[axis] * size[axis],
        })
    }

    /// Place of a grain's centre, counted on across periodic sides [m].
    pub fn unwrapped(&self, grain: usize) -> DVec3 {
        self.comm
            .unwrapped(self.grains.position[grain], self.grains.crossings(grain))
    }

    /// How often the candidates were found anew.
    pub fn rebuilds(&self) -> u64 {
        self.rebuilds
    }

    /// Finds all candidates anew; contacts keep what they remember.
    pub fn find_candidates(&mut self) {
        self.find_candidates_with(Loads::Kept);
    }

    /// The same; what acts on grains stays or is forgotten, as is where they were when candidates were found before.
    pub(crate) fn find_candidates_with(&mut self, loads: Loads) {
        if self.rebuilds == 0 {
            self.divide();
        }
        self.note_least_radius();
        if self.is_divided() {
            return self.find_candidates_together();
        }
        self.wrap_grains();
        if loads == Loads::Forgotten {
            self.neighbours.former = FormerPlaces::default();
            self.grains.put_loads_aside();
        }
        let moves = self.is_out_of_order().then(|| put_in_order(&mut self.grains));
        self.rebuilds += 1;
        let is_moved = moves.is_some();
        self.continue_with_candidates(moves.map_or(Places::Kept, Places::New));
        if is_moved {
            self.scattered_in_order = self.neighbours.scattered();
        }
    }

    /// Whether the grains are to be put in order again before candidates are found.
    fn is_out_of_order(&self) -> bool {
        let is_scattered = || self.neighbours.scattered() > self.scattered_in_order + DECAY;
        self.rebuilds == 0 || self.puts_in_order && is_scattered()
    }

    /// Puts own grains back into the periodic box, within a step or before the first.
    fn wrap_grains(&mut self) {
        let mut uncounted = Vec::new();
        if self.deforming.is_none() {
            let own = self.own_grains();
            self.comm.wrap_some(&mut self.grains, own, &mut uncounted);
            return self.note_uncounted(&uncounted);
        }
        // within a step velocities are those predicted for its end
        let ahead = if self.step > 0 { 0.5 * self.dt } else { 0.0 };
        self.comm.follow_motion();
        let mut gained = Vec::new();
        for some in self.own_pieces() {
            gained.push((self.comm).wrap_moving(&mut self.grains, some, ahead, &mut uncounted));
        }
        self.note_uncounted(&uncounted);
        let gained = self.of_all_segments(gained).iter().sum();
        self.books.carry_along(gained, gained);
    }

    /// Finds the candidates of the grains as they are, and hands them the contacts.
    fn continue_with_candidates(&mut self, places: Places) {
        if let Some(coupling) = &mut self.coupling {
            coupling.take_margin(self.skin);
        }
        let beyond_touch = self.skin + self.beyond_touch();
        let vicinity = self.share_places(beyond_touch);
        let own = self.own_grains();
        let with = (&self.walls[..], &self.materials, &self.comm);
        (self.neighbours).find_of((&own, vicinity.as_ref()), &self.grains, with, beyond_touch);
        self.grains.bring_loads_back();
        self.neighbours.note_places(&own, &self.grains);
        // by how much these places are rounded counts, too
        self.measure_travel(&Motion::default());
        self.tables += 1;
        self.count_candidates();
        let is_new = matches!(places, Places::New(_));
        let moves = match places {
            Places::Kept => None,
            Places::HandedOver => Some(Moves::none(self.grains.len())),
            Places::New(moves) => Some(moves),
        };
        self.contacts.hand_over(&self.neighbours, moves.as_ref());
        drop(moves);
        self.tuner.note_rebuild(self.step);
        let mean_radius = self.mean_radius();
        self.near.forget(self.neighbours.segments(), mean_radius);
        if is_new {
            let own = self.own_grains();
            self.forget_spreads(0);
            for first in own.clone().step_by(GRAINS_OF_A_SPREAD) {
                let stretch = first..(first + GRAINS_OF_A_SPREAD).min(own.end);
                let kick = self.grains.largest_half_kick(stretch.clone());
                self.spreads[first / GRAINS_OF_A_SPREAD] = Spread::of(&self.grains.velocity.rows()[stretch], kick);
            }
        }
        self.note_candidates_of_box();
        let around = vicinity.map_or_else(|| Bounds::of_grains(self.grains.position.rows()), |v| v.surfaces);
        let margin = self.skin + self.beyond_touch();
        self.bounds = (around.lower - margin, around.upper + margin);
    }

    /// Forgets how the grains from one on move.
    fn forget_spreads(&mut self, first: usize) {
        self.spreads.truncate(first / GRAINS_OF_A_SPREAD);
        self.spreads
            .resize(self.grains.len().div_ceil(GRAINS_OF_A_SPREAD), Spread::ANY);
    }

    /// Gap across which bodies may act on each other: the reach of the laws, and the bulges of both [m].
    pub(crate) fn beyond_touch(&self) -> f64 {
        self.max_reach + self.coupling.as_ref().map_or(0.0, |c| c.memory.margin)
    }

    /// Number of candidate pairs of grains.
    pub fn candidates(&self) -> usize {
        self.neighbours.total()
    }

    /// What solving the coupled equation of the contacts took so far.
    pub fn coupling_effort(&self) -> Effort {
        self.coupling.as_ref().map_or_else(Effort::default, |c| c.memory.effort)
    }

    /// Largest displacement of any wall surface near the grains since the candidates were found [m].
    pub(crate) fn wall_displacement(&self) -> f64 {
        self.surface_displacement(&self.neighbours.wall_reference)
    }

    /// Largest speed of any wall surface near the grains in the latest step [m/s]; notes the places of the walls.
    pub(crate) fn wall_speed(&mut self) -> f64 {
        let speed = self.surface_displacement(&self.walls_before) / self.dt;
        for (before, wall) in self.walls_before.iter_mut().zip(&self.walls) {
            *before = wall.pose();
        }
        speed
    }

    /// Upper bound of the speed of any wall near the grains at this moment [m/s].
    pub(crate) fn wall_speed_now(&self) -> f64 {
        let (lower, upper) = self.bounds;
        let speeds = self.walls.iter().map(|wall| wall.largest_speed(lower, upper));
        speeds.fold(0.0, f64::max)
    }

    fn surface_displacement(&self, since: &[Pose]) -> f64 {
        let (lower, upper) = self.bounds;
        let moved = |(wall, pose): (&Wall, &Pose)| wall.surface_displacement(pose, lower, upper);
        self.walls.iter().zip(since).map(moved).fold(0.0, f64::max)
    }

    /// Takes grains, told by rising indices, out of the run and books what they carried. Where processes share the run each calls
    /// this.
    pub(crate) fn remove(&mut self, indices: &[usize]) {
        let leaves = |g: usize| indices.binary_search(&g).is_ok();
        let gone = self.carried(leaves);
        self.books.remove(indices.len() as u64, &gone);
        if self.is_divided() {
            self.leave_out_together(indices);
        } else {
            let moves = Moves::without(indices, self.grains.len());
            moves.apply(&mut self.grains);
            self.wrap_grains();
            self.continue_with_candidates(Places::New(moves));
        }
        self.foresee_bulges();
    }
}
