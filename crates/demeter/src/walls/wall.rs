//! A wall of a run.

use super::elements;
use super::error::WallError;
use super::meeting::Corners;
use super::mesh::{Before, Mesh, TrianglePoint};
use super::motion::Motions;
use super::motion_checks::check_motions;
use super::motor::{Driven, FreeStep, Motor};
use super::outline;
use super::placed::{Closest, PlacedPart};
use super::pose::Pose;
use super::record::{ElementRecord, Mark, Record, Recording};
use super::repeated::{self, Drift, Repeated};
use super::shape::Made;
use super::surface::Surface;
use super::work::WallWork;
use crate::particles::Domain;
use demeter_physics::geometry::contact_sphere_triangle::ClosestPoints;
use demeter_physics::lanes::{Index, Lanes};
use glam::DVec3;
use serde::{Deserialize, Serialize};

/// One contact of a sphere and a wall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfaceContact {
    /// Unit vector from the wall to the grain, in the world frame.
    pub normal: DVec3,
    /// Distance of the centre from the surface [m]; negative behind a one-sided surface.
    pub distance: f64,
    /// Key of the touched part, stable while the grain stays on it. Faces of a box: 0 to 5. Meshes: the lowest triangle of
    /// the flat patch for a face, then keys of edges, then of vertices. Every other shape: 0.
    pub element: u32,
    /// Whether an edge, a rim or a corner is touched, not a face.
    pub is_at_edge: bool,
}

/// A wall: a surface of one material that moves as told and feels the grains.
#[derive(Clone, Debug)]
pub struct Wall {
    /// Name, unique in a run.
    pub name: String,
    /// Index of its material.
    pub material: u16,
    /// What grains feel.
    surface: Surface,
    /// The surface as it was described, where grains feel more of it.
    as_told: Option<Box<Surface>>,
    /// Axes along which it is repeated.
    repeated: [bool; 3],
    /// Corners of what is drawn of it.
    pub(super) corners: Corners,
    /// Centroid of the shape in the wall frame.
    pub(super) origin: DVec3,
    pub(super) motor: Motor,
    pub(super) force: DVec3,
    pub(super) torque: DVec3,
    pub(super) work: WallWork,
    is_present: bool,
    record: Option<Record>,
}

/// All that a restart needs to continue with the same bits, given a wall built from the same shape.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct WallState {
    motor: Motor,
    force: DVec3,
    torque: DVec3,
    work: WallWork,
    is_present: bool,
    record: Option<Record>,
}

impl Wall {
    /// Builds a wall at its start, or tells what is wrong with its description.
    pub fn new(name: &str, material: u16, of: impl Into<Made>, motion: impl Into<Motions>) -> Result<Self, WallError> {
        let surface = Surface::new(of)?;
        let origin = surface.centroid();
        let motor = Motor::begun(motion.into(), &surface, (Pose::START, Pose::START), origin)?;
        let (force, torque) = (DVec3::ZERO, DVec3::ZERO);
        Ok(Wall {
            name: name.to_owned(),
            material,
            surface,
            as_told: None,
            corners: Corners::default(),
            repeated: [false; 3],
            origin,
            motor,
            force,
            torque,
            work: WallWork::default(),
            is_present: true,
            record: None,
        })
    }

    /// Lengths of a wall and of a periodic box that differ by no more than this share are the same.
    pub const SAME_LENGTH: f64 = repeated::SAME_LENGTH;

    /// Has grains feel the wall across the periodic sides of a domain, too, along the axes in which it is no longer than the box, before it
    /// has moved; `drift` tells how it may move along each axis. What it is drawn as, its bounds and its elements stay as described.
    pub fn repeat(&mut self, domain: &Domain, drift: [Drift; 3]) -> Result<(), WallError> {
        if let Some(Repeated { surface, axes }) = repeated::repeated(self.described(), domain, drift)? {
            let told = std::mem::replace(&mut self.surface, surface);
            self.as_told.get_or_insert(Box::new(told));
            self.repeated = axes;
        }
        Ok(())
    }

    /// Whether the wall is repeated along an axis.
    pub fn is_repeated(&self, axis: usize) -> bool {
        self.repeated[axis]
    }

    /// The surface as it was described.
    pub(super) fn described(&self) -> &Surface {
        self.as_told.as_deref().unwrap_or(&self.surface)
    }

    /// Whether the wall is there. One that is absent touches nothing, but goes on moving as told, its servos aside.
    #[inline]
    pub fn is_present(&self) -> bool {
        self.is_present
    }

    /// Takes the wall away or puts it back, where its motion has carried it. Candidates must be found anew then.
    pub fn set_present(&mut self, is_present: bool) {
        self.is_present = is_present;
        self.set_load(DVec3::ZERO, DVec3::ZERO);
    }

    /// Appends to `out` all contacts of a sphere with `distance < radius + beyond` [m], the reach, in the world frame, sorted by element.
    /// No element comes twice. Behind a plane, a box face or a sphere the distance may be negative without limit; behind
    /// the side of a cylinder or cone, whose ends are open, a contact ends at `-reach`, when a grain of that radius has
    /// wholly passed. Asked of walls that are present only: those that are not are [`near`](Self::near) nothing.
    #[inline]
    pub fn contacts(&self, centre: DVec3, (radius, beyond): (f64, f64), out: &mut Vec<SurfaceContact>) {
        let first = out.len();
        (self.surface).contacts(self.motor.pose.unplace(self.origin, centre), (radius, beyond), out);
        self.turn(&mut out[first..]);
    }

    /// Distance [m] from a place to the nearest part of the wall within `reach`, the least of all [`contacts`](Self::contacts), which do not
    /// tell of grains that lie wholly in a shaft, a cylinder or cone that has grains outside: negative there, too. For grains that are put
    /// to a wall, or it to them.
    pub fn nearest(&self, place: DVec3, reach: f64) -> Option<f64> {
        let mut parts = Vec::new();
        if self.near(place, reach) {
            self.contacts(place, (reach, 0.0), &mut parts);
        }
        let depth = || self.surface.depth_in_shaft(self.motor.pose.unplace(self.origin, place));
        let in_shaft = self.is_present.then(depth).flatten().map(|depth| -depth);
        parts.iter().map(|part| part.distance).chain(in_shaft).reduce(f64::min)
    }

    /// The points of some triangles of a mesh, of which [`Wall::parts_near`] told, that are closest to some centres; nowhere for other
    /// shapes.
    #[inline(always)]
    pub(crate) fn closest_points<L: Lanes>(&self, triangles: &Index, centres: L::Vector) -> ClosestPoints<L> {
        let Surface::Mesh(mesh) = &self.surface else {
            return ClosestPoints::nowhere();
        };
        let pose = &self.motor.pose;
        let mut points = mesh.closest_points(triangles, pose.unplace_wide::<L>(self.origin, centres));
        points.normal = pose.turn_wide::<L>(points.normal);
        points
    }

    /// Has triangles of a mesh that are needed soon fetched into the caches.
    #[inline(always)]
    pub(crate) fn fetch_ahead(&self, triangles: &[u32]) {
        if let Surface::Mesh(mesh) = &self.surface {
            mesh.fetch_ahead(triangles);
        }
    }

    /// Appends the contacts of a sphere among the closest points of all triangles within reach, sorted by element.
    #[inline]
    pub(crate) fn contacts_of(
        &self,
        points: &mut [TrianglePoint],
        (centre, radius): (DVec3, f64),
        before: &Before,
        out: &mut Vec<SurfaceContact>,
    ) {
        if let Surface::Mesh(mesh) = &self.surface {
            let pose = &self.motor.pose;
            let frame = (
                |way| pose.unplace(self.origin, centre + way),
                |normal| pose.turn(normal),
            );
            mesh.contacts_of((points, radius), frame, before, out);
        }
    }

    /// The contact with an element, however far away, where a grain has no more than one with each: `None` of meshes, on which contacts
    /// pass from one to the next. What a grain has left behind (see [`Wall::contacts`]) is as far away as to do nothing. It has the bits that
    /// the [placed part](Self::placed_part) tells, where it does: which of the two is asked depends on when candidates were found.
    #[inline]
    pub(crate) fn contact_with(&self, element: u32, centre: DVec3, reach: f64) -> Option<SurfaceContact> {
        let placed = self.placed_part(element).map(|part| part.closest::<f64>(centre, reach));
        match placed {
            Some(Closest { normal, distance, told }) if told & 1 != 0 => Some(SurfaceContact {
                normal,
                distance,
                element,
                is_at_edge: false,
            }),
            _ => self.in_its_frame(element, centre, reach),
        }
    }

    /// The contact with an element, found in the frame of the wall.
    #[inline]
    pub(super) fn in_its_frame(&self, element: u32, centre: DVec3, reach: f64) -> Option<SurfaceContact> {
        let pose = &self.motor.pose;
        let mut contact = (self.surface).contact_with(element, pose.unplace(self.origin, centre), reach)?;
        contact.normal = pose.turn(contact.normal);
        Some(contact)
    }

    /// An element as it stands now, where several grains at a time can be held to it.
    pub(crate) fn placed_part(&self, element: u32) -> Option<PlacedPart> {
        PlacedPart::new(&self.surface, element, &self.motor.pose, self.origin)
    }

    /// Appends all parts of the surface within `reach` of a point [m]: triangles of a mesh that may be as near, else elements.
    pub(crate) fn parts_near(&self, centre: DVec3, reach: f64, out: &mut Vec<u32>) {
        (self.surface).parts_near(self.motor.pose.unplace(self.origin, centre), reach, out);
    }

    /// Turns contacts in the wall frame into the world frame.
    fn turn(&self, contacts: &mut [SurfaceContact]) {
        if !self.motor.pose.is_unrotated() {
            for contact in contacts {
                contact.normal = self.motor.pose.turn(contact.normal);
            }
        }
    }

    /// Whether any part of the surface is within `reach` [m] of a point, or the point behind a one-sided one and so in contact.
    #[inline]
    pub fn near(&self, centre: DVec3, reach: f64) -> bool {
        self.is_present && self.surface.near(self.motor.pose.unplace(self.origin, centre), reach)
    }

    /// Radius of the largest grain that, with its centre at a point, does not touch the wall, or `limit` when that is less
    /// [m]; negative behind a one-sided surface.
    pub fn clearance(&self, point: DVec3, limit: f64) -> f64 {
        if !self.is_present {
            return limit;
        }
        self.surface
            .clearance(self.motor.pose.unplace(self.origin, point), limit)
    }

    /// The mesh that the wall is made of, as it was described, in the wall frame; `None` when it is another shape.
    #[inline]
    pub fn mesh(&self) -> Option<&Mesh> {
        let Surface::Mesh(mesh) = &self.surface else {
            return None;
        };
        match self.as_told.as_deref() {
            Some(Surface::Mesh(told)) => Some(told),
            _ => Some(mesh),
        }
    }

    /// Triangles of a mesh that grains may feel, copies across periodic sides among them; 0 for other shapes.
    pub fn felt_triangles(&self) -> usize {
        match &self.surface {
            Surface::Mesh(mesh) => mesh.triangles().len(),
            _ => 0,
        }
    }

    /// The surface in the wall frame.
    pub(super) fn surface(&self) -> &Surface {
        &self.surface
    }

    /// Whether no point of the wall moves in this step.
    #[inline]
    pub(crate) fn is_at_rest(&self) -> bool {
        let motor = &self.motor;
        [motor.velocity, motor.angular_velocity, motor.belt] == [DVec3::ZERO; 3]
    }

    /// Velocity of its surface along itself [m/s].
    #[inline]
    pub(crate) fn belt(&self) -> DVec3 {
        self.motor.belt
    }

    /// Velocity of the [`origin`](Self::origin) [m/s].
    #[inline]
    pub(crate) fn velocity(&self) -> DVec3 {
        self.motor.velocity
    }

    /// Velocity of the wall, as a rigid body, at a point of the world [m/s].
    #[inline]
    pub fn velocity_at(&self, point: DVec3) -> DVec3 {
        if self.motor.angular_velocity == DVec3::ZERO {
            self.motor.velocity
        } else {
            self.motor.velocity + self.motor.angular_velocity.cross(point - self.origin())
        }
    }

    /// Upper bound of the speed of the wall within a box [m/s].
    pub(crate) fn largest_speed(&self, lower: DVec3, upper: DVec3) -> f64 {
        if !self.is_present {
            return 0.0;
        }
        // it changes along straight lines from place to place
        let speeds = outline::corners(lower, upper).map(|corner| self.velocity_at(corner).length());
        speeds.into_iter().fold(0.0, f64::max)
    }

    /// Angular velocity of the wall [1/s].
    #[inline]
    pub fn angular_velocity(&self) -> DVec3 {
        self.motor.angular_velocity
    }

    /// Which quantity of its motion is not a finite number, if any is.
    pub(crate) fn not_finite(&self) -> Option<&'static str> {
        let motor = &self.motor;
        if !motor.pose.is_finite() {
            Some("place")
        } else if !(motor.velocity + motor.belt).is_finite() || !motor.angular_velocity.is_finite() {
            Some("velocity")
        } else {
            None
        }
    }

    /// Tells what is wrong with motions, if anything, before a run needs them.
    pub fn check_motion<M: Clone + Into<Motions>>(motion: &M) -> Result<(), WallError> {
        check_motions(motion.clone().into()).map(drop)
    }

    /// Starts other motions from where the wall stands. On error the wall keeps those it has.
    pub fn set_motion(&mut self, motion: impl Into<Motions>) -> Result<(), WallError> {
        self.set_motion_behind(motion, Pose::START)
    }

    /// Starts other motions from where the wall stands; `leader` is where the wall stands that this one moves with, if any.
    pub fn set_motion_behind(&mut self, motion: impl Into<Motions>, leader: Pose) -> Result<(), WallError> {
        let load = self.motor.load();
        self.motor = Motor::begun(motion.into(), self.described(), (self.motor.pose, leader), self.origin)?;
        self.motor.bear(load);
        self.go_on_working();
        Ok(())
    }

    /// The wall that this one moves with as one body, if any; then [`follow`](Self::follow) moves it.
    #[inline]
    pub fn leader(&self) -> Option<usize> {
        self.motor.leader()
    }

    /// Tells a wall with the motion [`Motion::Driven`](super::Motion::Driven) where it stands at the end of the next step, and
    /// how fast it moves then. Not told before a step it rests. Nothing happens to a wall with other motions.
    pub fn drive(&mut self, next: Driven) {
        self.motor.drive(next);
    }

    /// Share of the steps in which a servo pressed that it spent at its largest speed, nothing where it never did; and that speed with
    /// its unit.
    pub(crate) fn limited(&self) -> Option<(Option<f64>, f64, &'static str)> {
        self.motor.limited()
    }

    /// Whether these are the motions that it has.
    pub(crate) fn has_motion(&self, motions: Motions) -> bool {
        check_motions(motions).is_ok_and(|motions| self.motor.has(&motions))
    }

    /// What a driven wall was told last; `None` for walls with other motions.
    pub fn driven(&self) -> Option<Driven> {
        self.motor.driven()
    }

    /// Whether the wall moves by its own motions alone, told as functions of time.
    pub fn is_foreseeable(&self) -> bool {
        self.motor.leader().is_none() && self.motor.is_clockwork()
    }

    /// Whether a servo is among its motions: then its velocity is another one from step to step.
    pub fn has_servo(&self) -> bool {
        self.motor.has_servo()
    }

    /// Gives servos the speeds with which they answer to the load of the last step; they rest where the wall does not press (`presses`),
    /// as neither it nor one that moves with it is there.
    pub fn answer(&mut self, presses: bool) {
        self.motor.answer(self.origin, presses);
    }

    /// Moves the wall by one step of `dt` [s]; servos before that [`answer`](Self::answer).
    pub fn advance(&mut self, dt: f64) {
        self.motor.advance(dt, self.origin);
    }

    /// Moves the wall to where the one stands that it moves with.
    pub fn follow(&mut self, leader: &Wall) {
        self.motor.follow(&leader.motor, leader.origin, self.origin);
    }

    /// Tells the wall the force [N] of the grains on it and their torque about its [`origin`](Self::origin) [N m].
    pub fn set_load(&mut self, force: DVec3, torque: DVec3) {
        (self.force, self.torque) = (force, torque);
        self.motor.bear((force, torque));
    }

    /// Adds the load of a wall that moves with this one: its force [N], and its torque [N m] about its origin, which is at
    /// `place` [m]. It counts for the motion alone, not in [`load`](Self::load).
    pub fn bear(&mut self, force: DVec3, torque: DVec3, place: DVec3) {
        let (own_force, own_torque) = self.motor.load();
        let moved = torque + (place - self.origin()).cross(force);
        self.motor.bear((own_force + force, own_torque + moved));
    }

    /// Completes a step when its load is known; tells what the wall did when it moves freely.
    pub fn settle(&mut self) -> Option<FreeStep> {
        self.motor.settle(self.origin)
    }

    /// Whether all motions of the wall have stopped for good, or tables have come to their ends.
    pub fn motion_is_done(&self) -> bool {
        self.motor.is_done()
    }

    /// Where a point that goes with the wall was at the start [m].
    pub fn brought_back(&self, point: DVec3) -> DVec3 {
        self.motor.pose.unplace(self.origin, point)
    }

    /// Where a point goes that was at a place at the start and goes with the wall [m].
    pub fn carried(&self, point: DVec3) -> DVec3 {
        self.motor.pose.place(self.origin, point)
    }

    /// Where the wall stands relative to its start.
    pub fn pose(&self) -> Pose {
        self.motor.pose
    }

    /// Place of the wall's origin in the world [m]: the centroid of its shape, for a plane the point it was described with.
    pub fn origin(&self) -> DVec3 {
        self.origin + self.motor.pose.translation
    }

    /// Displacement of the origin since the start of the run [m].
    pub fn displacement(&self) -> DVec3 {
        self.motor.pose.translation
    }

    /// Upper bound of how far the surface inside a box has moved since an earlier pose [m]. A surface of revolution that
    /// turns about its own axis stays where it is.
    pub fn surface_displacement(&self, since: &Pose, lower: DVec3, upper: DVec3) -> f64 {
        if !self.is_present {
            return 0.0;
        }
        outline::displacement(&self.surface, self.origin, since, &self.motor.pose, lower, upper)
    }

    /// Smallest box around the wall in the world [m]; `None` when it is infinite, as planes and boxes of planes are.
    pub fn bounds(&self) -> Option<(DVec3, DVec3)> {
        outline::bounds(self.described(), self.origin, &self.motor.pose)
    }

    /// Smallest box around a wall whose clearance is no less than the distance from that box [m]; `None` where it may be less: behind a
    /// one-sided surface, and near images.
    pub(crate) fn clearance_bounds(&self) -> Option<(DVec3, DVec3)> {
        match &self.surface {
            Surface::Cylinder(_) | Surface::Cone(_) | Surface::Rectangle(_) | Surface::Disc(_) => self.bounds(),
            Surface::Mesh(_) if self.as_told.is_none() => self.bounds(),
            _ => None,
        }
    }

    /// A box around the wall in the world that costs little to find [m], as large as the turned box of a mesh; `None` when the wall goes
    /// on beyond it.
    pub fn rough_bounds(&self) -> Option<(DVec3, DVec3)> {
        outline::enclosing(self.described(), self.origin, &self.motor.pose)
    }

    /// Triangles that draw the surface in the world frame [m]; an infinite plane is cut by the box given. None of a wall that
    /// is absent.
    pub fn triangles(&self, lower: DVec3, upper: DVec3) -> Vec<[DVec3; 3]> {
        if !self.is_present {
            return Vec::new();
        }
        outline::triangles(self.described(), self.origin, &self.motor.pose, lower, upper)
    }

    /// Where a mesh, as it stands, passes through another [m]; `None` of other shapes, and where they are apart or touch.
    pub fn meets(&self, other: &Wall) -> Option<DVec3> {
        let (own, others) = (self.mesh()?, other.mesh()?);
        let (pose, origin) = (self.pose(), self.origin());
        let here = |corner: DVec3| pose.unplace(origin, other.pose().place(other.origin(), corner));
        let place = own.meets(others.triangles().iter().map(|triangle| triangle.corners().map(here)))?;
        Some(pose.place(origin, place))
    }

    /// State for a checkpoint.
    pub fn state(&self) -> WallState {
        WallState {
            motor: self.motor.clone(),
            force: self.force,
            torque: self.torque,
            work: self.work,
            is_present: self.is_present,
            record: self.record.clone(),
        }
    }

    /// Continues from a checkpoint; tells whether its record fits this wall. What the scenario has recorded now may be something else: sums
    /// that were recorded go on, and others begin.
    pub fn restore(&mut self, state: &WallState) -> bool {
        if let (Some(record), Some(saved)) = (&mut self.record, &state.record)
            && !record.go_on_from(saved)
        {
            return false;
        }
        self.motor = state.motor.clone();
        (self.force, self.torque, self.work) = (state.force, state.torque, state.work);
        self.is_present = state.is_present;
        true
    }

    /// Has loads or wear recorded on every element, from now on.
    pub fn record(&mut self, recording: Recording) {
        let elements = elements::count(self.described());
        self.record = recording.is_on().then(|| Record::new(recording, elements));
    }

    /// What is recorded; nothing by default.
    #[inline]
    pub fn recording(&self) -> Recording {
        self.record.as_ref().map_or_else(Recording::default, |r| r.recording)
    }

    /// Whether anything is recorded.
    #[inline]
    pub(crate) fn is_recorded(&self) -> bool {
        self.record.is_some()
    }

    /// The element of a contact with a key at a point of the world; the point is on the surface but for `reach` [m].
    pub(crate) fn element_at(&self, key: u32, point: DVec3, reach: f64) -> u32 {
        let point = self.motor.pose.unplace(self.origin, point);
        elements::at(&self.surface, key, point, reach)
    }

    /// Records what a contact did in a step of `dt` [s].
    pub(crate) fn mark(&mut self, mark: &Mark, dt: f64) {
        let back = self.motor.pose.rotation.conjugate();
        let is_unrotated = self.motor.pose.is_unrotated();
        if let Some(record) = &mut self.record {
            record.add(mark, dt, |v| if is_unrotated { v } else { back * v });
        }
    }

    /// Notes that loads were recorded for `dt` [s] longer.
    pub(crate) fn pass_recorded(&mut self, dt: f64) {
        if let Some(record) = &mut self.record {
            record.pass(dt);
        }
    }

    /// Begins to average loads anew, as after a frame.
    pub fn begin_interval(&mut self) {
        if let Some(record) = &mut self.record {
            record.begin_interval();
        }
    }

    /// What was recorded on every element; nothing where nothing is recorded.
    pub fn element_records(&self) -> Vec<ElementRecord> {
        let Some(record) = &self.record else { return Vec::new() };
        let of = |k| record.of(k, elements::area(self.described(), k));
        (0..record.len()).map(of).collect()
    }

    /// The element of every one of so many triangles that draw the wall.
    pub fn elements_drawn(&self, triangles: usize) -> Vec<usize> {
        elements::drawn(self.described(), triangles)
    }

    /// Energies lost in impacts and by friction [J] and volume worn [m^3] since the start; 0 where nothing is recorded.
    pub fn wear(&self) -> [f64; 3] {
        self.record.as_ref().map_or([0.0; 3], Record::totals)
    }
}
