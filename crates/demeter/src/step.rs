//! One time step, in the order in which things happen.

use crate::contacts::sum::contact_load;
use crate::contacts::{CHUNK, Fault, Scene};
use crate::particles::Outside;
use crate::simulation::Simulation;
use demeter_physics::integrator::rotate;
use glam::DVec3;
use rayon::prelude::*;

/// Grains handled by one task.
const GRAINS_PER_TASK: usize = 512;

impl Simulation {
    /// Advances the run by one time step (velocity Verlet, see [`demeter_physics::integrator`]).
    pub fn step(&mut self) -> Result<(), Fault> {
        self.start()?;
        self.step += 1;
        let motion = self.drift();
        self.move_walls();
        self.check_places(&motion)?;
        if self.candidates_are_stale(&motion) {
            self.find_candidates();
        }
        self.find_contacts(motion.max_speed);
        self.sum_and_kick(Kick::Second)?;
        self.load_walls();
        self.book_step();
        Ok(())
    }

    /// Forces at the very start, before any step.
    pub(crate) fn find_first_forces(&mut self) -> Result<(), Fault> {
        let max_speed = self.grains.velocity.iter().map(|v| v.length()).fold(0.0, f64::max);
        self.check_places(&Motion {
            max_speed,
            ..Motion::default()
        })?;
        self.find_candidates();
        self.find_contacts(max_speed);
        self.sum_and_kick(Kick::None)?;
        self.load_walls();
        Ok(())
    }

    /// Half kick, drift, and the predicted velocity; orientations turn.
    fn drift(&mut self) -> Motion {
        let dt = self.dt;
        let half = 0.5 * dt;
        let domain = *self.comm.domain();
        let grains = &mut self.grains;
        let n = GRAINS_PER_TASK;
        let moved: Vec<Motion> = (
            grains.position.par_chunks_mut(n),
            grains.velocity.par_chunks_mut(n),
            grains.angular_velocity.par_chunks_mut(n),
            grains.orientation.par_chunks_mut(n),
            (grains.force.par_chunks(n), grains.torque.par_chunks(n)),
            (grains.mass.par_chunks(n), grains.inertia.par_chunks(n)),
            self.neighbours.reference.par_chunks(n),
        )
            .into_par_iter()
            .enumerate()
            .map(
                |(task, (position, velocity, spin, orientation, (force, torque), (mass, inertia), reference))| {
                    let mut motion = Motion::default();
                    let (mut speed2, mut displacement2) = (0.0f64, 0.0f64);
                    for k in 0..position.len() {
                        let kick = force[k] * (half / mass[k]);
                        let middle = velocity[k] + kick;
                        position[k] += middle * dt;
                        velocity[k] = middle + kick;
                        let twist = torque[k] * (half / inertia[k]);
                        let middle_spin = spin[k] + twist;
                        orientation[k] = rotate(orientation[k], middle_spin, dt);
                        spin[k] = middle_spin + twist;
                        speed2 = speed2.max(velocity[k].length_squared());
                        displacement2 = displacement2.max((position[k] - reference[k]).length_squared());
                        if motion.misplaced.is_none() && !domain.contains(position[k]) {
                            motion.misplaced = Some(task * n + k);
                        }
                    }
                    motion.max_speed = speed2.sqrt();
                    motion.max_displacement = displacement2.sqrt();
                    motion
                },
            )
            .collect();
        moved.into_iter().fold(Motion::default(), Motion::merge)
    }

    fn move_walls(&mut self) {
        for wall in &mut self.walls {
            wall.advance(self.dt);
        }
    }

    /// A grain that left the domain, or whose place is not a number, ends the run or is removed.
    fn check_places(&mut self, motion: &Motion) -> Result<(), Fault> {
        if motion.misplaced.is_none() && self.step > 0 {
            return Ok(());
        }
        let domain = *self.comm.domain();
        let outside: Vec<usize> = (0..self.grains.len())
            .filter(|&g| !domain.contains(self.grains.position[g]))
            .collect();
        let Some(&g) = outside.iter().min_by_key(|&&g| self.grains.id[g]) else {
            return Ok(());
        };
        let (id, position, velocity) = (self.grains.id[g], self.grains.position[g], self.grains.velocity[g]);
        if let Some(&g) = outside.iter().find(|&&g| !self.grains.position[g].is_finite()) {
            let position = self.neighbours.reference.get(g).copied().unwrap_or(DVec3::NAN);
            return Err(Fault::NotFinite {
                step: self.step,
                id: self.grains.id[g],
                quantity: "position",
                position,
            });
        }
        if domain.outside == Outside::Stop {
            let (lower, upper) = (domain.lower, domain.upper);
            return Err(Fault::Outside {
                step: self.step,
                id,
                position,
                velocity,
                lower,
                upper,
            });
        }
        self.remove(&outside);
        Ok(())
    }

    /// Whether some grain may touch a partner that is not among its candidates.
    fn candidates_are_stale(&self, motion: &Motion) -> bool {
        // the narrow phase looks ahead by half a step
        let windows = if self.max_reach > 0.0 { 2.0 } else { 1.0 };
        let grain = motion.max_displacement + windows * motion.max_speed * self.dt;
        let wall = self.wall_displacement();
        self.neighbours.reference.len() != self.grains.len() || 2.0 * grain > self.skin || grain + wall > self.skin
    }

    /// Narrow phase and contact laws, chunk by chunk.
    fn find_contacts(&mut self, max_grain_speed: f64) {
        let max_speed = max_grain_speed.max(self.wall_speed());
        let scene = Scene {
            grains: &self.grains,
            walls: &self.walls,
            materials: &self.materials,
            comm: &self.comm,
            dt: self.dt,
            step: self.step,
            max_speed,
            max_reach: self.max_reach,
            max_overlap: self.max_overlap,
            stride: self.contacts.stride,
        };
        let (pairs, wall_pairs) = (&self.neighbours.pairs, &self.neighbours.wall_pairs);
        let between_grains = self
            .contacts
            .pairs
            .par_iter_mut()
            .zip(pairs.par_chunks(CHUNK))
            .map(|(chunk, pairs)| {
                chunk.find_pairs(pairs, &scene);
                chunk.evaluate_pairs(&scene);
                chunk.book_lost(&scene);
            });
        let with_walls = self
            .contacts
            .walls
            .par_iter_mut()
            .zip(wall_pairs.par_chunks(CHUNK))
            .map(|(chunk, pairs)| {
                chunk.find_walls(pairs, &scene);
                chunk.evaluate_walls(&scene);
                chunk.book_lost(&scene);
            });
        between_grains.chain(with_walls).for_each(|()| ());
    }

    /// Sum per grain, body force, and the kick that corrects the predicted velocity.
    fn sum_and_kick(&mut self, kick: Kick) -> Result<(), Fault> {
        if let Some(fault) = self.contacts.fault() {
            return Err(fault.clone());
        }
        let correction = match kick {
            Kick::None => 0.0,
            Kick::Second => 0.5 * self.dt,
        };
        let (neighbours, contacts, gravity) = (&self.neighbours, &self.contacts, self.gravity);
        let grains = &mut self.grains;
        let n = GRAINS_PER_TASK;
        let bad: Vec<Option<usize>> = (
            grains.velocity.par_chunks_mut(n),
            grains.angular_velocity.par_chunks_mut(n),
            grains.force.par_chunks_mut(n),
            grains.torque.par_chunks_mut(n),
            (grains.mass.par_chunks(n), grains.inertia.par_chunks(n)),
        )
            .into_par_iter()
            .enumerate()
            .map(|(task, (velocity, spin, force, torque, (mass, inertia)))| {
                let mut bad = None;
                for k in 0..velocity.len() {
                    let (contact_force, new_torque) = contact_load(task * n + k, neighbours, contacts);
                    let new_force = contact_force + gravity * mass[k];
                    velocity[k] += (new_force - force[k]) * (correction / mass[k]);
                    spin[k] += (new_torque - torque[k]) * (correction / inertia[k]);
                    force[k] = new_force;
                    torque[k] = new_torque;
                    if !(velocity[k].is_finite()
                        && spin[k].is_finite()
                        && new_force.is_finite()
                        && new_torque.is_finite())
                    {
                        bad = bad.or(Some(task * n + k));
                    }
                }
                bad
            })
            .collect();
        match bad.into_iter().flatten().min_by_key(|&g| self.grains.id[g]) {
            None => Ok(()),
            Some(g) => Err(Fault::NotFinite {
                step: self.step,
                id: self.grains.id[g],
                quantity: self.not_finite(g),
                position: self.grains.position[g],
            }),
        }
    }

    /// Which quantity of a grain is not finite: the cause before its effects.
    fn not_finite(&self, g: usize) -> &'static str {
        let grains = &self.grains;
        if !(grains.force[g].is_finite() && grains.torque[g].is_finite()) {
            "force"
        } else if !grains.velocity[g].is_finite() {
            "velocity"
        } else {
            "angular velocity"
        }
    }

    fn load_walls(&mut self) {
        let loads = self.contacts.wall_loads(self.walls.len());
        for (wall, (force, torque)) in self.walls.iter_mut().zip(loads) {
            wall.set_load(force, torque);
        }
    }
}

/// Which kick goes with a sum of forces.
#[derive(Clone, Copy)]
enum Kick {
    /// At the start of a run the velocities are those given.
    None,
    /// The second kick of a step.
    Second,
}

/// What the drift found.
#[derive(Clone, Debug, Default)]
struct Motion {
    max_speed: f64,
    max_displacement: f64,
    /// Some grain outside the domain or not at a finite place.
    misplaced: Option<usize>,
}

impl Motion {
    fn merge(self, other: Self) -> Self {
        Self {
            max_speed: self.max_speed.max(other.max_speed),
            max_displacement: self.max_displacement.max(other.max_displacement),
            misplaced: self.misplaced.or(other.misplaced),
        }
    }
}
