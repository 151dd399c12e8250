//! Forces on grains and motions of walls that whoever runs a simulation works out, as a function of their own.
//!
//! A custom force is asked once in every step, when the grains are where the step has brought them and velocities are those
//! predicted; its work is booked in the ledger. A custom motion is asked for the places of a wall. Neither is part of a
//! checkpoint: a run that goes on from one has them when they are given again, and until then the force is absent and the wall
//! rests where it stood. A motion that is given again before the next step goes on where it was, to the same bits.
//!
//! When one of them cannot answer, the step is completed, with the loads of the step before or the wall at rest, and told as
//! [`Fault::Custom`]: the simulation is whole, and the next step asks again.

use super::Simulation;
use crate::contacts::Fault;
use crate::particles::{Grains, Load};
use crate::walls::{Driven, Motion, Motions, WallError};
use glam::DVec3;
use std::collections::BTreeMap;
use std::fmt;

/// The moment at which a custom force acts.
#[derive(Clone, Copy, Debug)]
pub struct ForceMoment<'a> {
    /// Steps done, with the present one.
    pub step: u64,
    /// Simulated time at the end of the step [s].
    pub time: f64,
    /// Time step [s].
    pub dt: f64,
    /// The grains; their forces and torques are those of the step before.
    pub grains: &'a Grains,
}

/// Loads on all grains, by index.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct GrainLoads {
    /// Forces [N].
    pub force: Vec<DVec3>,
    /// Torques [N m].
    pub torque: Vec<DVec3>,
}

/// A force on grains beside those of contacts and gravity.
pub trait CustomForce: Send + Sync {
    /// Tells the loads on all grains, which are 0 before. An answer may depend on the state of the moment only, or a run is not
    /// the same after a restart. On error the message says why there is none.
    fn loads(&mut self, moment: &ForceMoment, loads: &mut GrainLoads) -> Result<(), String>;
}

/// A vector over simulated time [s].
pub type VectorCourse = Box<dyn FnMut(f64) -> Result<DVec3, String> + Send + Sync>;

/// A number over simulated time [s].
pub type NumberCourse = Box<dyn FnMut(f64) -> Result<f64, String> + Send + Sync>;

/// A motion of a wall as a function of simulated time. Places count from where the wall stands when the motion is told.
pub enum CustomMotion {
    /// Place [m]: the wall is displaced by `f(t) - f(t0)`. Its velocity is the central difference over two steps.
    Place(VectorCourse),
    /// Velocity [m/s]; the displacement is its integral by the trapezoidal rule.
    Velocity(VectorCourse),
    /// Angle about an axis [rad], right-handed: the wall is turned by `f(t) - f(t0)`.
    Angle {
        /// A point of the axis [m].
        point: DVec3,
        /// Direction of the axis.
        axis: DVec3,
        /// The angle.
        angle: NumberCourse,
    },
    /// Angular velocity about an axis [1/s], right-handed.
    AngularVelocity {
        /// A point of the axis [m].
        point: DVec3,
        /// Direction of the axis.
        axis: DVec3,
        /// The angular velocity.
        rate: NumberCourse,
    },
}

/// Everything custom of a simulation.
#[derive(Default)]
pub(crate) struct Customs {
    forces: Vec<Box<dyn CustomForce>>,
    /// Loads of all forces in the latest step, of the grains with these ids; and those of one.
    loads: GrainLoads,
    ids: Vec<u32>,
    one: GrainLoads,
    /// Memory for those of the present step.
    next: GrainLoads,
    drivers: Vec<(usize, Driver)>,
    failure: Option<Fault>,
}

impl fmt::Debug for Customs {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{} custom forces, {} custom motions",
            self.forces.len(),
            self.drivers.len()
        )
    }
}

/// Asks a course for the places of a wall, step by step.
struct Driver {
    course: VectorCourse,
    is_rate: bool,
    told: Driven,
    /// Of a course of places: its value now and one step ahead.
    now: DVec3,
    ahead: DVec3,
}

impl Driver {
    /// A driver that begins now, or goes on with what an earlier one has told last, where the course has come to that.
    fn new(
        (mut course, is_rate): (VectorCourse, bool),
        (step, dt): (u64, f64),
        earlier: Option<Driven>,
    ) -> Result<Self, String> {
        let now = finite(course(end_of(step, dt))?)?;
        let ahead = if is_rate {
            now
        } else {
            finite(course(end_of(step + 1, dt))?)?
        };
        let has_come_to = |told: &Driven| match is_rate {
            true => told.counted_from == DVec3::ZERO && told.rate == now,
            false => told.place == now - told.counted_from,
        };
        let anew = Driven {
            place: DVec3::ZERO,
            rate: if is_rate { now } else { (ahead - now) / dt },
            counted_from: if is_rate { DVec3::ZERO } else { now },
        };
        Ok(Self {
            course,
            is_rate,
            told: earlier.filter(has_come_to).unwrap_or(anew),
            now,
            ahead,
        })
    }

    /// Where the wall stands at the end of a step.
    fn next(&mut self, step: u64, dt: f64) -> Result<Driven, String> {
        if self.is_rate {
            let rate = finite((self.course)(end_of(step, dt))?)?;
            self.told.place += (self.told.rate + rate) * (0.5 * dt);
            self.told.rate = rate;
        } else {
            let beyond = finite((self.course)(end_of(step + 1, dt))?)?;
            self.told.place = self.ahead - self.told.counted_from;
            self.told.rate = (beyond - self.now) / (2.0 * dt);
            (self.now, self.ahead) = (self.ahead, beyond);
        }
        Ok(self.told)
    }
}

/// When a step ends [s], as [`Simulation::time`] tells it: a course that is asked anew after a restart is asked for the same moments.
fn end_of(step: u64, dt: f64) -> f64 {
    step as f64 * dt
}

fn finite(value: DVec3) -> Result<DVec3, String> {
    if value.is_finite() {
        Ok(value)
    } else {
        Err(format!("its answer {value} is not finite"))
    }
}

impl CustomMotion {
    /// The course of a vector, with the angle or its rate in the first component; whether it is a rate; and the axis.
    fn course(self) -> (VectorCourse, bool, Option<(DVec3, DVec3)>) {
        let lift = |mut f: NumberCourse| -> VectorCourse { Box::new(move |t| Ok(DVec3::new(f(t)?, 0.0, 0.0))) };
        match self {
            Self::Place(course) => (course, false, None),
            Self::Velocity(course) => (course, true, None),
            Self::Angle { point, axis, angle } => (lift(angle), false, Some((point, axis))),
            Self::AngularVelocity { point, axis, rate } => (lift(rate), true, Some((point, axis))),
        }
    }
}

/// Why a wall cannot get a custom motion.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum CustomMotionError {
    /// The wall refuses it.
    #[error(transparent)]
    Wall(#[from] WallError),
    /// The function has no answer at the start.
    #[error("the motion of wall `{wall}`: {reason}")]
    NoAnswer {
        /// Name of the wall.
        wall: String,
        /// Why.
        reason: String,
    },
}

impl Simulation {
    /// Adds a force that acts from the next step on; before the first step, from the start.
    pub fn add_force(&mut self, force: Box<dyn CustomForce>) {
        self.customs().forces.push(force);
    }

    /// Takes all custom forces away.
    pub fn clear_forces(&mut self) {
        if let Some(customs) = &mut self.customs {
            customs.forces.clear();
        }
    }

    /// Whether any force or motion is custom.
    pub(crate) fn has_customs(&self) -> bool {
        self.customs.is_some()
    }

    /// Whether a custom force acts.
    pub fn has_custom_force(&self) -> bool {
        self.customs.as_ref().is_some_and(|customs| !customs.forces.is_empty())
    }

    /// Moves a wall as a function tells, from where it stands, in place of its motions so far. A motion that it is told later
    /// (by [`set_wall_motion`](Self::set_wall_motion), as at the start of a stage) replaces this one.
    pub fn drive_wall(&mut self, wall: usize, motion: CustomMotion) -> Result<(), CustomMotionError> {
        self.check_wall(wall)?;
        let (course, is_rate, axis) = motion.course();
        let motion = Motions::from(Motion::Driven { axis });
        let earlier = self.walls[wall].driven();
        let earlier = earlier.filter(|_| !self.is_driven(wall) && self.walls[wall].has_motion(motion.clone()));
        let driver = Driver::new((course, is_rate), (self.step, self.dt), earlier);
        let driver = driver.map_err(|reason| CustomMotionError::NoAnswer {
            wall: self.walls[wall].name.clone(),
            reason,
        })?;
        if earlier != Some(driver.told) {
            self.set_wall_motion(wall, motion)?;
        }
        self.customs().drivers.push((wall, driver));
        Ok(())
    }

    /// Names of the walls that are to be driven and that nobody drives, as after a restart.
    pub fn undriven_walls(&self) -> Vec<&str> {
        let walls = self.walls.iter().enumerate();
        walls
            .filter(|(w, wall)| wall.driven().is_some() && !self.is_driven(*w))
            .map(|(_, wall)| wall.name.as_str())
            .collect()
    }

    /// Whether somebody drives a wall.
    fn is_driven(&self, wall: usize) -> bool {
        let mut drivers = self.customs.iter().flat_map(|customs| &customs.drivers);
        drivers.any(|(driven, _)| *driven == wall)
    }

    fn customs(&mut self) -> &mut Customs {
        self.customs.get_or_insert_default()
    }

    /// Forgets who drives a wall.
    pub(super) fn forget_driver(&mut self, wall: usize) {
        if let Some(customs) = &mut self.customs {
            customs.drivers.retain(|(w, _)| *w != wall);
        }
    }

    /// Tells the walls with custom motions where they stand at the end of this step.
    pub(crate) fn drive_walls(&mut self) {
        let Some(customs) = &mut self.customs else { return };
        for (wall, driver) in &mut customs.drivers {
            match driver.next(self.step, self.dt) {
                Ok(next) => self.walls[*wall].drive(next),
                Err(reason) => {
                    let what = format!("motion of wall `{}`", self.walls[*wall].name);
                    customs.failure.get_or_insert(Fault::Custom {
                        step: self.step,
                        what,
                        reason,
                    });
                }
            }
        }
    }

    /// Asks the custom forces and adds their loads to the sums of the contacts.
    pub(crate) fn add_custom_loads(&mut self) {
        let own = self.own_grains();
        let Some(customs) = self.customs.as_mut().filter(|c| !c.forces.is_empty()) else {
            return;
        };
        let moment = ForceMoment {
            step: self.step,
            time: self.step as f64 * self.dt,
            dt: self.dt,
            grains: &self.grains,
        };
        match customs.ask(&moment) {
            Ok(()) => {}
            Err(reason) => {
                customs.keep_loads(&self.grains);
                customs.failure.get_or_insert(Fault::Custom {
                    step: self.step,
                    what: "force".to_string(),
                    reason,
                });
            }
        }
        let loads = self.grains.load.rows_mut()[own.clone()].iter_mut();
        let told = customs.loads.force[own.clone()].iter().zip(&customs.loads.torque[own]);
        for (load, (force, torque)) in loads.zip(told) {
            load.add(&Load::new(*force, *torque));
        }
    }

    /// Books what the custom forces did in a step; without one their power is noted alone.
    pub(crate) fn book_custom(&mut self, dt: f64) {
        let Some(customs) = self.customs.as_ref().filter(|c| !c.forces.is_empty()) else {
            // those that were taken away act in the first half of the next step
            return self.books.book_custom(0.0, dt);
        };
        let grains = &self.grains;
        if customs.ids != grains.id {
            return;
        }
        let mut power = 0.0;
        for g in (0..grains.len()).filter(|&g| !grains.is_fixed(g)) {
            power += customs.loads.force[g].dot(grains.velocity[g]);
            power += customs.loads.torque[g].dot(grains.angular_velocity[g]);
        }
        self.books.book_custom(power, dt);
    }

    /// What went wrong with something custom in this step.
    pub(crate) fn custom_failure(&mut self) -> Result<(), Fault> {
        let failure = self.customs.as_mut().and_then(|customs| customs.failure.take());
        failure.map_or(Ok(()), Err)
    }
}

impl Customs {
    /// The loads of all forces; on error they are those of the step before.
    fn ask(&mut self, moment: &ForceMoment) -> Result<(), String> {
        let grains = moment.grains.len();
        let all = &mut self.next;
        all.clear(grains);
        for force in &mut self.forces {
            self.one.clear(grains);
            force.loads(moment, &mut self.one)?;
            self.one.check(moment)?;
            for (sum, one) in all.force.iter_mut().zip(&self.one.force) {
                *sum += *one;
            }
            for (sum, one) in all.torque.iter_mut().zip(&self.one.torque) {
                *sum += *one;
            }
        }
        std::mem::swap(&mut self.loads, &mut self.next);
        self.ids.clone_from(&moment.grains.id);
        Ok(())
    }

    /// Keeps the loads of the step before, for grains that may lie in another order now.
    fn keep_loads(&mut self, grains: &Grains) {
        let ids = self.ids.iter().copied();
        let loads = self.loads.force.iter().copied().zip(self.loads.torque.iter().copied());
        let known: BTreeMap<u32, (DVec3, DVec3)> = ids.zip(loads).collect();
        let of = |id: &u32| known.get(id).copied().unwrap_or_default();
        (self.loads.force, self.loads.torque) = grains.id.iter().map(of).unzip();
        self.ids.clone_from(&grains.id);
    }
}

impl GrainLoads {
    fn resize(&mut self, grains: usize) {
        self.force.resize(grains, DVec3::ZERO);
        self.torque.resize(grains, DVec3::ZERO);
    }

    fn clear(&mut self, grains: usize) {
        self.force.clear();
        self.torque.clear();
        self.resize(grains);
    }

    fn check(&self, moment: &ForceMoment) -> Result<(), String> {
        let grains = moment.grains.len();
        if self.force.len() != grains || self.torque.len() != grains {
            let (forces, torques) = (self.force.len(), self.torque.len());
            return Err(format!(
                "it told {forces} forces and {torques} torques for {grains} grains"
            ));
        }
        let is_bad = |g: &usize| !(self.force[*g].is_finite() && self.torque[*g].is_finite());
        match (0..grains).find(is_bad) {
            None => Ok(()),
            Some(g) => Err(format!(
                "its load on grain {} is not finite: force {}, torque {}",
                moment.grains.id[g], self.force[g], self.torque[g]
            )),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn courses_go_on_from_any_step() {
        let course = |is_rate| -> (VectorCourse, bool) {
            let course = |t: f64| Ok(DVec3::new(libm::sin(300.0 * t), t * t, 0.0));
            (Box::new(course), is_rate)
        };
        // of this step many multiples differ from the one before and a step more
        let dt = 7e-6;
        for is_rate in [false, true] {
            let mut whole = Driver::new(course(is_rate), (0, dt), None).unwrap();
            let mut resumed: Option<Driver> = None;
            for step in 1..500 {
                let told = whole.next(step, dt).unwrap();
                if let Some(mut resumed) = resumed {
                    assert_eq!(resumed.next(step, dt).unwrap(), told, "step {step}");
                }
                let anew = Driver::new(course(is_rate), (step, dt), Some(told)).unwrap();
                assert_eq!(anew.told, told, "step {step}");
                resumed = Some(anew);
            }
        }
    }
}
