//! Walls in a step: they move, and then take the load of the grains.

use crate::contacts::Fault;
use crate::simulation::Simulation;
use crate::walls::{FreeStep, STEPS_BETWEEN_LOOKS, Wall, meeting};

impl Simulation {
    /// Moves all walls by one step; those that move with others after these.
    pub(super) fn move_walls(&mut self) {
        if self.walls.iter().any(Wall::has_servo) {
            self.let_servos_answer();
        }
        for wall in &mut self.walls {
            wall.advance(self.dt);
        }
        self.let_walls_follow();
    }

    /// Gives servos the speeds of this step. Springs of contacts act with these from the moment of their force on, and acted with the
    /// former ones until then. All else a law has asked about the motion at that moment, and so are dashpots and friction booked.
    fn let_servos_answer(&mut self) {
        let half = 0.5 * self.dt;
        let booked: f64 = self.walls.iter_mut().map(|wall| wall.add_work_of_springs(-half)).sum();
        for wall in 0..self.walls.len() {
            if self.walls[wall].has_servo() {
                let presses = self.may_press(wall);
                self.walls[wall].answer(presses);
            }
        }
        self.let_walls_follow();
        let done: f64 = self.walls.iter_mut().map(|wall| wall.add_work_of_springs(half)).sum();
        self.books.drive_walls(booked + done);
    }

    /// Whether grains may feel a wall, or one that moves with it.
    fn may_press(&self, wall: usize) -> bool {
        let moves_with = |other: &&Wall| other.leader() == Some(wall);
        let mut together = self.walls.iter().filter(moves_with).chain(self.walls.get(wall));
        together.any(Wall::is_present)
    }

    fn let_walls_follow(&mut self) {
        for follower in 0..self.walls.len() {
            let Some(leader) = self.walls[follower].leader() else {
                continue;
            };
            if let Ok([follower, leader]) = self.walls.get_disjoint_mut([follower, leader]) {
                follower.follow(leader);
            }
        }
    }

    /// A wall whose place or velocity is not a number ends the run.
    pub(super) fn check_walls(&self) -> Result<(), Fault> {
        match self.walls.iter().find_map(|wall| Some((wall, wall.not_finite()?))) {
            None => Ok(()),
            Some((wall, quantity)) => Err(Fault::WallNotFinite {
                step: self.step,
                wall: wall.name.clone(),
                quantity: quantity.into(),
            }),
        }
    }

    /// A rigid body that comes to another wall ends the run.
    pub(super) fn check_bodies(&self) -> Result<(), Fault> {
        if !self.step.is_multiple_of(STEPS_BETWEEN_LOOKS) {
            return Ok(());
        }
        let name = |wall: usize| self.walls[wall].name.clone();
        match meeting(&self.walls, self.dt) {
            None => Ok(()),
            Some(meeting) => Err(Fault::BodyAtWall {
                step: self.step,
                body: name(meeting.body),
                wall: name(meeting.wall),
                position: meeting.place,
            }),
        }
    }

    /// Tells all walls their loads; freely moving ones complete their step. What they do and what is recorded counts for `dt` [s].
    pub(super) fn load_walls(&mut self, dt: f64) {
        for (index, wall) in self.walls.iter_mut().enumerate() {
            let (force, torque) = self.work.walls[index];
            wall.set_load(force, torque);
            wall.set_springs(self.work.springs[index]);
        }
        for follower in 0..self.walls.len() {
            let Some(leader) = self.walls[follower].leader() else {
                continue;
            };
            let (force, torque) = self.walls[follower].load();
            let place = self.walls[follower].origin();
            if let Some(leader) = self.walls.get_mut(leader) {
                leader.bear(force, torque, place);
            }
        }
        if self.records_walls {
            self.record_walls(dt);
        }
        self.free_walls = FreeStep::default();
        for wall in &mut self.walls {
            if let Some(step) = wall.settle() {
                self.free_walls.power += step.power;
                self.free_walls.dissipated += step.dissipated;
                self.free_walls.kinetic += step.kinetic;
            }
            wall.add_work(dt);
        }
    }

    fn record_walls(&mut self, dt: f64) {
        if dt == 0.0 {
            return;
        }
        let is_divided = self.is_divided();
        let here = self.contacts.walls.iter().flat_map(|chunk| &chunk.marks);
        for mark in (self.work.marks.iter()).chain(here.filter(|_| !is_divided)) {
            self.walls[mark.wall as usize].mark(mark, dt);
        }
        self.walls.iter_mut().for_each(|wall| wall.pass_recorded(dt));
    }
}
