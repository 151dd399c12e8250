//! The stages of a run: how they begin, what ends them, what is told at their ends.

use super::{ENERGY_INTERVAL, Observer, Runner, labels, steps_in};
use crate::measure::kinetic_over_elastic;
use crate::output::{StageSummary, wall_summaries};
use crate::scenario::column_stops;
use crate::scenario::deformation::reached;
use crate::scenario::laws_of_stages::materials;
use crate::scenario::run_error::RunError;
use crate::scenario::solids::enclosed_by;
use crate::scenario::words::{quantity, rounded};
use crate::simulation::{FollowedStress, Stage, StopCondition, StressOf};
use crate::walls::{Wall, WallWork};
use glam::DVec3;

/// Share of its steps that a servo may be at its largest speed, or a box at its largest rate.
const MOST_LIMITED: f64 = 0.05;

impl<'a> Runner<'a> {
    pub(super) fn begin_stage(&mut self, observer: &mut dyn Observer) -> Result<(), RunError> {
        self.place.stage_step = self.sim.step;
        self.place.departures_told = 0;
        self.place.columns_held.clear();
        self.place.stage_displacement = self.sim.walls.iter().map(|w| w.displacement()).collect();
        self.place.stage_work = self.works();
        let Some(stage) = self.scenario.stages.get(self.place.stage) else {
            return Ok(());
        };
        if stage.contact.is_some() {
            self.follow_laws_of(stage)?;
        }
        self.set_up(stage, observer)?;
        self.sim.mark_strain();
        Ok(())
    }

    /// Lets the contact laws act that hold from this stage on.
    fn follow_laws_of(&mut self, stage: &Stage) -> Result<(), RunError> {
        let mut faults = self.scenario.diagnostics();
        let told = self.scenario.contact_in(self.place.stage);
        let Some(materials) = materials(self.scenario, told, &mut faults) else {
            return Err(faults.into());
        };
        let followed = self.sim.follow_other_laws(materials);
        followed.map_err(|source| RunError::Laws {
            stage: stage.name.clone(),
            source: Box::new(source),
        })
    }

    /// Tells feeds, removals, the box and walls what a stage has them do.
    pub(super) fn set_up(&mut self, stage: &Stage, observer: &mut dyn Observer) -> Result<(), RunError> {
        self.traffic.begin_stage(stage, (self.sim.step, self.sim.dt));
        if let Some(gravity) = stage.gravity {
            self.sim.set_gravity(gravity).map_err(|source| RunError::Gravity {
                stage: stage.name.clone(),
                source: Box::new(source),
            })?;
        }
        if let Some(plan) = stage.deformation {
            self.sim.deform(plan).map_err(|source| RunError::Deformation {
                stage: stage.name.clone(),
                source,
            })?;
        }
        for (wall, motion) in &stage.motions {
            (self.sim)
                .begin_wall_motion(*wall, motion.clone())
                .map_err(|source| RunError::Motion {
                    stage: stage.name.clone(),
                    source,
                })?;
        }
        let Some(absent) = &stage.absent else { return Ok(()) };
        let walls = self.sim.walls.iter().enumerate();
        let back: Vec<usize> = (walls.filter(|(wall, built)| !built.is_present() && !absent.contains(wall)))
            .map(|(wall, _)| wall)
            .collect();
        let come_and_go = self.sim.set_absent(|wall| absent.contains(&wall));
        come_and_go.map_err(|source| RunError::WallInTheWay {
            stage: stage.name.clone(),
            source: Box::new(source),
        })?;
        let told: Vec<String> = back
            .into_iter()
            .filter_map(|wall| enclosed_by(&self.sim, wall))
            .collect();
        told.iter()
            .try_for_each(|text| self.say(&format!("warning: {text}"), observer))
    }

    /// Ends the stage by one of its conditions.
    pub(super) fn end_stage(
        &mut self,
        (stop, reason): (&StopCondition, &str),
        observer: &mut dyn Observer,
    ) -> Result<(), RunError> {
        self.write_row()?;
        self.tell_stray_walls(observer)?;
        self.write_frame()?;
        self.draw_stage()?;
        let stage = self.stage();
        let (start, dt) = (self.place.stage_step, self.sim.dt);
        let name = &stage.name;
        let text = format!("stage `{name}` ended at {:.4e} s: {reason}", self.sim.time());
        self.say(&text, observer)?;
        for text in self.traffic.end_stage(self.place.stage, dt) {
            self.say(&text, observer)?;
        }
        let warnings = (self.limited_servos(stop).into_iter())
            .chain(self.limited_lengths(stop))
            .chain(self.walls_in_fixed_grains());
        for text in warnings {
            self.say(&text, observer)?;
        }
        let works: Vec<WallWork> = (self.works().iter().zip(&self.place.stage_work))
            .map(|(now, before)| now.since(before))
            .collect();
        let seconds = (self.sim.step - start) as f64 * dt;
        self.place.stages_done.push(StageSummary {
            name: name.clone(),
            first_step: start,
            last_step: self.sim.step,
            start: start as f64 * dt,
            end: self.sim.time(),
            ended_by: reason.to_string(),
            walls: self
                .latest
                .as_ref()
                .map(|row| wall_summaries(row, &labels(self.scenario).walls, (&works, seconds)))
                .unwrap_or_default(),
        });
        self.place.stage += 1;
        self.begin_stage(observer)
    }

    /// What every wall has done since the start of the run.
    pub(in crate::scenario) fn works(&self) -> Vec<WallWork> {
        self.sim.walls.iter().map(|wall| *wall.work()).collect()
    }

    /// Servos that do not hold what they are told, in words; the stage was ended by `stop`.
    fn limited_servos(&self, stop: &StopCondition) -> Vec<String> {
        let was_awaited = |wall: usize| matches!(stop, StopCondition::WallForce { walls, .. } if walls.contains(&wall));
        let in_words = |(index, wall): (usize, &Wall)| match wall.limited()? {
            (None, ..) if was_awaited(index) => None,
            (None, speed, unit @ "1/s") => Some(format!(
                "warning: the servo of wall `{}` has not met yet the torque that it is told: it turns at {} {unit} at most, and grains \
                 that are still away, or that flow, bear less; tell less, let the stage last longer, or raise `max_speed`",
                wall.name,
                rounded(speed)
            )),
            (None, speed, unit) => Some(format!(
                "warning: the servo of wall `{}` has not pressed yet with what it is told: it is on its way, at \
                 {} {unit} at most; end the stage by `stop.wall_force`, let it last longer, or raise `max_speed`",
                wall.name,
                rounded(speed)
            )),
            (Some(share), speed, unit) => (share > MOST_LIMITED).then(|| {
                format!(
                    "warning: the servo of wall `{}` was at its largest speed, {} {unit}, in {:.0} % of the \
                     steps since it first pressed: it does not hold what it is told there; raise its `max_speed`",
                    wall.name,
                    rounded(speed),
                    100.0 * share
                )
            }),
        };
        let walls = self.sim.walls.iter().enumerate();
        let there = walls.filter(|(_, wall)| wall.is_present());
        there.filter_map(in_words).collect()
    }

    /// Lengths of the box that do not have the stress that they are told, in words; the stage was ended by `stop`.
    fn limited_lengths(&self, stop: &StopCondition) -> Vec<String> {
        let was_awaited = |stress| matches!(stop, StopCondition::BoxStress { of, .. } if *of == stress);
        let in_words = |followed: FollowedStress| {
            let FollowedStress {
                of, target, max_rate, ..
            } = followed;
            let name = match of {
                StressOf::Axis(axis) => ["along x", "along y", "along z"][axis.min(2)],
                StressOf::Mean => "in the mean",
                StressOf::Shear => "in shear",
            };
            match followed.limited {
                None if was_awaited(of) => None,
                None => Some(format!(
                    "warning: the stress of the box {name} has not come yet to what it is told, {target:e} Pa: it is on its way, at \
                     {max_rate} 1/s at most; end the stage by `stop.box_stress`, let it last longer, or raise `max_rate`"
                )),
                Some(share) => (share > MOST_LIMITED).then(|| {
                    format!(
                        "warning: the box strained at its largest rate, {max_rate} 1/s, in {:.0} % of the steps since its stress {name} \
                         first came to what it is told, {target:e} Pa: it does not hold it there; raise its `max_rate`",
                        100.0 * share
                    )
                }),
            }
        };
        self.sim.followed_stresses().into_iter().filter_map(in_words).collect()
    }

    /// Walls that went into fixed grains, in words.
    fn walls_in_fixed_grains(&self) -> Vec<String> {
        let in_words = |(wall, (id, count)): (usize, (u32, u64))| {
            let name = &self.sim.walls[wall].name;
            format!(
                "warning: wall `{name}` has moved into {count} fixed grains, one of them grain {id}: walls and fixed \
                 grains feel nothing of each other; let walls or free grains stand there"
            )
        };
        self.sim.walls_in_fixed_grains().into_iter().map(in_words).collect()
    }

    /// What ends the stage at this step, and in words.
    pub(super) fn stage_is_over(&mut self) -> Option<(&'a StopCondition, String)> {
        let mut stops = self.stage().stop.iter().enumerate();
        stops.find_map(|(place, stop)| Some((stop, self.reached(stop, place)?)))
    }

    /// What a condition has come to, in words, when it holds; it has its place among those of the stage.
    fn reached(&mut self, stop: &StopCondition, place: usize) -> Option<String> {
        let elapsed = self.sim.step - self.place.stage_step;
        let dt = self.sim.dt;
        match stop {
            StopCondition::Duration(seconds) => {
                (elapsed >= steps_in(*seconds, dt)).then(|| format!("its duration of {seconds} s is over"))
            }
            StopCondition::Steps(steps) => (elapsed >= *steps).then(|| match steps {
                1 => "its one step is done".to_owned(),
                _ => format!("its {steps} steps are done"),
            }),
            StopCondition::KineticOverElastic(share) => {
                let looks = elapsed > 0 && elapsed.is_multiple_of(ENERGY_INTERVAL);
                let energies = looks.then(|| self.sim.energies()).filter(|e| e.elastic != 0.0)?;
                let ratio = kinetic_over_elastic(&self.sim, &energies);
                (ratio < *share).then(|| format!("kinetic over elastic energy is {ratio:.3e}, below {share:e}"))
            }
            StopCondition::WallForce {
                walls,
                direction,
                above,
            } => {
                let walls = || walls.iter().map(|&wall| &self.sim.walls[wall]);
                let force: f64 = walls().map(|w| w.load().0.dot(DVec3::from_array(*direction))).sum();
                (elapsed > 0 && force >= *above).then(|| {
                    let names: Vec<String> = walls().map(|wall| format!("`{}`", wall.name)).collect();
                    let names = names.join(" and ");
                    format!(
                        "the force on wall {names} is {}, {} was asked",
                        quantity(force, "N"),
                        quantity(*above, "N")
                    )
                })
            }
            StopCondition::WallTravel { wall, distance } => {
                let travel = self.travel(*wall);
                (travel >= *distance * (1.0 - 1e-12)).then(|| {
                    format!(
                        "wall `{}` has moved by {}",
                        self.sim.walls[*wall].name,
                        quantity(travel, "m")
                    )
                })
            }
            StopCondition::Strain { wall, length, strain } => {
                let reached = self.travel(*wall) / length;
                (reached >= *strain * (1.0 - 1e-12)).then(|| format!("the strain is {reached:.6}"))
            }
            StopCondition::BoxStress { .. } | StopCondition::BoxStrain { .. } | StopCondition::ShearStrain(_) => {
                let looks = elapsed > 0 && elapsed.is_multiple_of(ENERGY_INTERVAL);
                reached(stop, &self.sim, looks)
            }
            StopCondition::MotionDone(wall) => {
                let wall = &self.sim.walls[*wall];
                (elapsed > 0 && wall.motion_is_done()).then(|| format!("the motion of wall `{}` is done", wall.name))
            }
            StopCondition::FeedDone(feed) => {
                let name = self.scenario.feeds.get(*feed).map_or("", |f| f.name.as_str());
                self.traffic.is_done(*feed).then(|| format!("feed `{name}` is done"))
            }
            StopCondition::GrainsAtMost(count) => {
                let left = self.sim.grains.len();
                (elapsed > 0 && left as u64 <= *count).then(|| format!("{left} grains are left"))
            }
            StopCondition::Column(stop) => {
                column_stops::reached(stop, self.place.columns_held.get(place).copied().flatten(), dt)
            }
        }
    }

    /// Distance of a wall from where it stood at the start of the stage [m].
    fn travel(&self, wall: usize) -> f64 {
        (self.sim.walls[wall].displacement() - self.place.stage_displacement[wall]).length()
    }
}
