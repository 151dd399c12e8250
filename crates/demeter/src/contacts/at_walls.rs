//! What contacts with walls do, several contacts at a time: to the grains, and to the walls.

use super::impacts;
use super::kinematics::{Motion, Sight, Source, Turning, note_engaged, places_in_turn, put_listed, shift};
use super::meetings::next_lane;
use super::respond::Lost;
use super::sum::{Adder, Loads, Sink};
use super::{ContactChunk, Scene};
use crate::particles::Load;
use crate::walls::Wall;
use demeter_physics::contact::PairSize;
use demeter_physics::geometry::contact_sphere_sphere::Contact;
use demeter_physics::lanes::{Index, Lanes, MOST_LANES, Mask, Vector, with_zero};
use glam::DVec3;

/// How all walls move in a step, a row each with 0 behind it.
#[derive(Clone, Debug, Default)]
pub struct Surfaces {
    /// Velocities of the origins [m/s].
    velocity: Vec<[f64; 4]>,
    /// Angular velocities [1/s].
    spin: Vec<[f64; 4]>,
    /// Origins [m].
    origin: Vec<[f64; 4]>,
    /// The wall whose free motion each follows; empty where none moves freely.
    giving: Vec<u32>,
    /// Velocities of surfaces along themselves [m/s]; empty where there are none.
    belts: Vec<[f64; 4]>,
    /// Whether each moves with a servo, its own or that of the wall that it follows; empty where none does.
    answering: Vec<bool>,
    /// Whether no wall moves.
    is_at_rest: bool,
}

impl Surfaces {
    /// Looks at the walls.
    pub(crate) fn find(&mut self, walls: &[Wall]) {
        let row = |vector: DVec3| vector.extend(0.0).to_array();
        self.velocity.clear();
        self.velocity.extend(walls.iter().map(|wall| row(wall.velocity())));
        self.spin.clear();
        self.spin.extend(walls.iter().map(|wall| row(wall.angular_velocity())));
        self.origin.clear();
        self.origin.extend(walls.iter().map(|wall| row(wall.origin())));
        self.giving.clear();
        if walls.iter().any(Wall::is_free) {
            // what moves with a free wall gives way as that does
            let giving = |(k, wall): (usize, &Wall)| wall.leader().filter(|&leader| leader < walls.len()).unwrap_or(k);
            self.giving
                .extend(walls.iter().enumerate().map(giving).map(|k| k as u32));
        }
        self.answering.clear();
        if walls.iter().any(Wall::has_servo) {
            let leader = |wall: &Wall| wall.leader().and_then(|leader| walls.get(leader));
            let answers = |wall: &Wall| leader(wall).unwrap_or(wall).has_servo();
            self.answering.extend(walls.iter().map(answers));
        }
        self.is_at_rest = walls.iter().all(Wall::is_at_rest);
        self.belts.clear();
        if walls.iter().any(|wall| wall.belt() != DVec3::ZERO) {
            self.belts.extend(walls.iter().map(|wall| row(wall.belt())));
        }
    }

    /// Velocities of some walls at points [m/s].
    #[inline(always)]
    fn velocities<L: Lanes>(&self, walls: &Index, points: L::Vector) -> L::Vector {
        let [[ux, uy, uz, _], [wx, wy, wz, _], [ox, oy, oz, _]] =
            L::fetch([&self.velocity, &self.spin, &self.origin], walls);
        let arms = points - L::Vector::new(ox, oy, oz);
        L::Vector::new(ux, uy, uz) + L::Vector::new(wx, wy, wz).outer(arms)
    }
}

/// Contacts with walls, whose geometry is known.
struct AtWalls<'a> {
    scene: &'a Scene<'a>,
    law: u32,
    contacts: &'a [Contact],
    i: &'a [u32],
    j: &'a [u32],
    /// Which of them acted in the step before, a bit each, and then in this one; `None` where all act.
    engaged: Option<&'a mut [u64]>,
}

impl<'a> AtWalls<'a> {
    /// Of contacts with their grains and walls, and which of them acted.
    fn of(
        (contacts, i, j): (&'a [Contact], &'a [u32], &'a [u32]),
        engaged: Option<&'a mut [u64]>,
        law: u32,
        scene: &'a Scene<'a>,
    ) -> Self {
        Self {
            scene,
            law,
            contacts,
            i,
            j,
            engaged,
        }
    }
}

impl AtWalls<'_> {
    /// Inverse masses with which walls give way to pushes against their normals at some points [1/kg].
    #[inline(always)]
    fn inverse_masses<L: Lanes>(&self, walls: &Index, points: L::Vector, normals: L::Vector) -> L {
        let giving = &self.scene.surfaces.giving;
        let (points, normals) = (L::rows(with_zero::<L>(points)), L::rows(with_zero::<L>(normals)));
        let mut masses = [0.0; MOST_LANES];
        let mut lane = 0;
        while lane < L::COUNT {
            let [point, normal] =
                [points.as_ref()[lane], normals.as_ref()[lane]].map(|[x, y, z, _]| DVec3::new(x, y, z));
            let wall = &self.scene.walls[giving[walls[lane] as usize] as usize];
            masses[lane] = wall.inverse_mass_at(point, -normal);
            lane += 1;
        }
        L::load(&masses)
    }

    /// Of lanes that do not touch, those that a law attracts across the gap.
    #[cold]
    #[inline(never)]
    fn attracted(&self, grains: &Index, overlap: &[f64; MOST_LANES], rate: &[f64; MOST_LANES], mut apart: u32) -> u32 {
        let mut acts = 0;
        while let Some(lane) = next_lane(&mut apart) {
            let size = || self.scene.size_at_wall(grains[lane] as usize);
            acts |= u32::from(self.scene.acts(self.law, size, overlap[lane], rate[lane])) << lane;
        }
        acts
    }
}

impl Source for AtWalls<'_> {
    /// Few contacts are with walls, and each that is compiled as one takes long to compile.
    const TOGETHER: bool = false;

    #[inline(always)]
    fn look<L: Lanes>(&mut self, k: usize, here: u32) -> Sight<L> {
        let scene = self.scene;
        let contacts = Contact::numbers(self.contacts);
        let mut places = places_in_turn::<L>(self.contacts.len(), k, Contact::NUMBERS);
        let [mut grains, mut walls] = [[0; MOST_LANES]; 2];
        put_listed::<L>(self.i, k, &mut grains);
        put_listed::<L>(self.j, k, &mut walls);
        let [nx, ny, nz, overlap] = L::columns(contacts, &places);
        shift::<L>(&mut places, 2);
        let [_, _, lever, no_lever] = L::columns(contacts, &places);
        let [[x, y, z, radius], [vx, vy, vz, inverse_mass], spin] = L::fetch(scene.grains.tables(), &grains);
        let [of_wall] = L::fetch([&scene.surfaces.spin], &walls);
        let normal = L::Vector::new(nx, ny, nz);
        let mut velocity = L::Vector::new(vx, vy, vz);
        let own_mass = L::splat(1.0) / inverse_mass;
        let (mut along_normal, mut mass) = (inverse_mass, own_mass);
        if !scene.surfaces.is_at_rest || !scene.surfaces.giving.is_empty() {
            let points = L::Vector::new(x, y, z) - normal * lever;
            velocity = velocity - scene.surfaces.velocities::<L>(&walls, points);
            if !scene.surfaces.belts.is_empty() {
                let [[bx, by, bz, _]] = L::fetch([&scene.surfaces.belts], &walls);
                let belt = L::Vector::new(bx, by, bz);
                velocity = velocity - (belt - normal * belt.inner(normal));
            }
            if !scene.surfaces.giving.is_empty() {
                along_normal = along_normal + self.inverse_masses::<L>(&walls, points, normal);
                mass = L::splat(1.0) / along_normal;
            }
        }
        let rate = -velocity.inner(normal);
        let (mut acts, mut ended, mut too_deep) = (here, 0, 0);
        if self.engaged.is_some() {
            let half_window = rate.abs() * (0.5 * scene.dt);
            acts &= (overlap + half_window).gt(L::splat(0.0)).bits();
            if scene.max_reach > 0.0 && acts != here {
                acts |= self.attracted(&grains, &overlap.to_array(), &rate.to_array(), here & !acts);
            }
            too_deep = (!(radius * scene.max_overlap).ge(overlap)).bits() & acts;
        }
        if let Some(engaged) = &mut self.engaged {
            ended = note_engaged(engaged, k, here, acts);
        }
        Sight {
            motion: Motion {
                normal,
                overlap,
                velocity,
                rate,
                levers: [lever, no_lever],
                inverse_mass: along_normal,
                inverse_masses: [inverse_mass, L::splat(0.0)],
                size: PairSize {
                    radius,
                    mass,
                    spring_mass: own_mass,
                },
            },
            turning: Turning::of(spin, of_wall),
            acting: L::Mask::of_bits(acts),
            acts,
            ended,
            too_deep,
        }
    }
}

/// Adds up what contacts with walls do, as they come.
struct AddAtWalls<'s, 'a> {
    adder: &'s mut Adder<'a>,
    scene: &'s Scene<'s>,
    i: &'s [u32],
    j: &'s [u32],
    /// Force [N] on every wall, and torque about its origin [N m].
    felt: &'s mut [Load],
}

impl Sink for AddAtWalls<'_, '_> {
    #[inline(always)]
    fn put<L: Lanes>(&mut self, k: usize, loads: &Loads<L>) {
        let [mut grains, mut walls] = [[0; MOST_LANES]; 2];
        put_listed::<L>(self.i, k, &mut grains);
        put_listed::<L>(self.j, k, &mut walls);
        let [positions, ..] = self.scene.grains.tables();
        let [[x, y, z, _]] = L::fetch([positions], &grains);
        let [[ox, oy, oz, _]] = L::fetch([&self.scene.surfaces.origin], &walls);
        // the torque about the centre of the grain is that about the contact point and of the force there
        let arms = L::Vector::new(x - ox, y - oy, z - oz);
        let about_origin = arms.outer(loads.force) + loads.first_torque;
        let on_grains = L::side_by_side(loads.force, loads.first_torque);
        let on_walls = L::side_by_side(loads.force, about_origin);
        let mut lane = 0;
        while lane < L::COUNT && k + lane < self.i.len() {
            self.adder.add_own(grains[lane], on_grains.as_ref()[lane]);
            self.felt[walls[lane] as usize].add_side(on_walls.as_ref()[lane], 1);
            lane += 1;
        }
    }

    #[inline(always)]
    fn put_nothing<L: Lanes>(&mut self, _k: usize) {}
}

impl ContactChunk {
    /// Evaluates the laws of all contacts with walls, hands over what they do to the grains, and sums up what the walls feel.
    pub(crate) fn evaluate_walls(&mut self, scene: &Scene, adder: &mut Adder) {
        if self.is_empty() {
            return;
        }
        if scene.records_walls {
            self.losses.clear();
            self.losses.resize(self.len(), Lost::default());
        }
        let mut engaged = std::mem::take(&mut self.engaged);
        let before = (scene.tells_impacts && !scene.is_coupled()).then(|| engaged.clone());
        let mut begun = self.beginning(scene);
        let law = self.law;
        let mut felt = std::mem::take(&mut self.felt);
        let (i, j, shift) = self.take_bodies();
        let contacts = std::mem::take(&mut self.now.geometry);
        felt.clear();
        felt.resize(scene.walls.len(), Load::default());
        let mut sink = AddAtWalls {
            adder,
            scene,
            i: &i,
            j: &j,
            felt: &mut felt,
        };
        let known = (&contacts[..], &i[..], &j[..]);
        let noted = (!scene.is_coupled()).then_some(&mut engaged[..]);
        self.elastic.clear();
        if !scene.surfaces.answering.is_empty() {
            self.elastic.resize(contacts.len(), 0.0);
        }
        let too_deep = self.evaluate(&mut sink, scene, AtWalls::of(known, noted, law, scene));
        self.add_springs(scene, known);
        if let Some(before) = before {
            begun = impacts::begun(&before, &engaged);
        }
        if !begun.is_empty() {
            let noted = (!scene.is_coupled()).then_some(&mut engaged[..]);
            let source = AtWalls::of(known, noted, law, scene);
            impacts::tell(source, &begun, (&i, &j), true, scene, &mut self.impacts);
        }
        (self.i, self.j, self.shift) = (i, j, shift);
        self.now.geometry = contacts;
        self.engaged = engaged;
        for ((wall, load), felt) in scene.walls.iter().zip(&mut self.wall_load).zip(&felt) {
            *load = (felt.force(), felt.torque());
            if !wall.is_at_rest() {
                let power = load.0.dot(wall.velocity()) + load.1.dot(wall.angular_velocity());
                self.tally.wall_work -= scene.dt * power;
            }
        }
        self.felt = felt;
        if !scene.surfaces.belts.is_empty() {
            for (k, &wall) in self.j.iter().enumerate() {
                let on_grain = self.now.tangential.of(k);
                self.tally.wall_work += scene.dt * on_grain.dot(scene.walls[wall as usize].belt());
            }
        }
        if let Some((k, overlap)) = too_deep {
            self.note_overlap_at_wall(k, overlap, scene);
        }
        if scene.records_walls {
            self.mark_walls(scene);
        }
    }

    /// Sums up what the normal springs of contacts do to walls that move with servos.
    fn add_springs(&mut self, scene: &Scene, (contacts, i, j): (&[Contact], &[u32], &[u32])) {
        let answering = &scene.surfaces.answering;
        self.wall_springs.clear();
        if answering.is_empty() {
            return;
        }
        self.wall_springs.resize(answering.len(), (DVec3::ZERO, DVec3::ZERO));
        for (k, (&grain, &wall)) in i.iter().zip(j).enumerate() {
            if answering.get(wall as usize) == Some(&true) {
                let on_wall = contacts[k].normal * -self.elastic[k];
                let arm = scene.grains.position[grain as usize] - scene.walls[wall as usize].origin();
                let (force, torque) = &mut self.wall_springs[wall as usize];
                *force += on_wall;
                *torque += arm.cross(on_wall);
            }
        }
    }

    /// Notes that a contact with a wall has too much overlap.
    pub(super) fn note_overlap_at_wall(&mut self, contact: usize, overlap: f64, scene: &Scene) {
        let (g, wall) = (self.i[contact] as usize, self.j[contact] as usize);
        let partner = || format!("wall {}", scene.walls[wall].name);
        self.watch_overlap(scene, g, overlap / scene.grains.radius(g), partner);
    }
}
