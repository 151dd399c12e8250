//! A run that goes on with a scenario that was changed.

use super::{Observer, RunState, Runner};
use crate::materials::Materials;
use crate::scenario::Scenario;
use crate::scenario::laws_of_stages::{Bound, OtherMemory, bind, other_memory};
use crate::scenario::prepare::{check_to_go_on, prepare_to_resume, time_scale, to_come};
use crate::scenario::run_error::RunError;
use crate::simulation::{Deformation, Simulation, Stage, Verdict};
use crate::walls::Motions;
use glam::DVec3;
use std::path::Path;

/// The scenario that a run followed until it was changed.
pub(in crate::scenario) struct Former {
    scenario: Scenario,
    /// The stage of it that the run is in, or their number behind the last.
    stage: usize,
    /// What acted.
    materials: Materials,
    /// Laws of all its stages.
    laws: Vec<Materials>,
    /// Acceleration of gravity [m/s^2].
    gravity: DVec3,
    /// What was there under its laws, its gravity and with its walls [J].
    present: f64,
}

impl Former {
    /// That of a state which is to go on with `is`; refused where contacts would have to remember something else.
    pub(in crate::scenario) fn of(scenario: Scenario, state: &RunState<'_>, is: &Scenario) -> Result<Self, RunError> {
        let setup = prepare_to_resume(&scenario, state.place.stage, state.domain)?;
        let (materials, gravity) = (setup.materials.clone(), setup.gravity);
        let told = laws_of(is)?;
        // those of later stages remember the same
        if let Some(OtherMemory { pair, is, was }) =
            told.first().and_then(|told| other_memory(&told.materials, &materials))
        {
            return Err(RunError::OtherLaws { pair, is, was });
        }
        let laws = laws_of(&scenario)?.into_iter().map(|laws| laws.materials).collect();
        let present = Simulation::resume(setup, state.simulation.clone())?.present_energy();
        Ok(Self {
            scenario,
            stage: state.place.stage,
            materials,
            laws,
            gravity,
            present,
        })
    }

    /// Where the run is in the stages of the changed scenario: in that of the same name, or, behind its last one, behind that.
    pub(in crate::scenario) fn stage_in(&self, is: &Scenario, file: &Path) -> Result<usize, RunError> {
        let was = &self.scenario.stages;
        let is_over = self.stage >= was.len();
        let Some(there) = was.get(self.stage).or(was.last()) else {
            return Ok(self.stage);
        };
        let Some(found) = is.stages.iter().position(|stage| stage.name == there.name) else {
            let stages: Vec<String> = is.stages.iter().map(|stage| format!("`{}`", stage.name)).collect();
            return Err(RunError::OtherStages {
                file: file.to_owned(),
                stage: there.name.clone(),
                is_over,
                stages: stages.join(", "),
            });
        };
        Ok(found + usize::from(is_over))
    }
}

/// Laws of all stages of a scenario.
fn laws_of(scenario: &Scenario) -> Result<Vec<Bound<'_>>, RunError> {
    let mut faults = scenario.diagnostics();
    bind(scenario, &mut faults).ok_or_else(|| faults.into())
}

/// What a scenario tells of walls, feeds, removals and the box until a stage, and what so holds in it.
struct InForce<'s> {
    motions: Vec<&'s Motions>,
    absent: Vec<usize>,
    feeds: Vec<usize>,
    removals: Vec<usize>,
    deformation: Deformation,
}

impl<'s> InForce<'s> {
    fn in_stage(scenario: &'s Scenario, stage: usize) -> Self {
        let mut told = Self {
            motions: scenario.walls.iter().map(|wall| &wall.motion).collect(),
            absent: Vec::new(),
            feeds: (0..scenario.feeds.len()).collect(),
            removals: (0..scenario.removals.len()).collect(),
            deformation: scenario.domain.deform.unwrap_or_default(),
        };
        for stage in scenario.stages.iter().take(stage + 1) {
            for (wall, motions) in &stage.motions {
                told.motions[*wall] = motions;
            }
            let lists = [
                (&stage.absent, &mut told.absent),
                (&stage.feeds, &mut told.feeds),
                (&stage.removals, &mut told.removals),
            ];
            for (list, told) in lists {
                if let Some(list) = list {
                    told.clone_from(list);
                }
            }
            told.deformation = stage.deformation.unwrap_or(told.deformation);
        }
        told
    }

    /// What a stage is to tell a run in which something else held.
    fn instead_of(self, was: &Self, stage: &Stage) -> Stage {
        let changed = |is: Vec<usize>, was: &Vec<usize>| (is != *was).then_some(is);
        let motions = self.motions.into_iter().enumerate();
        let moves_otherwise = |(wall, motions): &(usize, &Motions)| was.motions.get(*wall) != Some(motions);
        Stage {
            motions: motions
                .filter(moves_otherwise)
                .map(|(wall, motions)| (wall, motions.clone()))
                .collect(),
            absent: changed(self.absent, &was.absent),
            feeds: changed(self.feeds, &was.feeds),
            removals: changed(self.removals, &was.removals),
            deformation: (self.deformation != was.deformation).then_some(self.deformation),
            // acts already
            gravity: None,
            contact: None,
            ..stage.clone()
        }
    }
}

impl Runner<'_> {
    /// Lets hold what the scenario tells otherwise than a former one, from which the run came until here, and begins the stage that was added
    /// behind its last.
    pub(in crate::scenario) fn go_on_otherwise(
        &mut self,
        former: &Former,
        observer: &mut dyn Observer,
    ) -> Result<(), RunError> {
        let (sim, was) = (&mut self.sim, &former.scenario);
        let laws = laws_of(self.scenario)?;
        let acts_otherwise = sim.materials.laws() != former.materials.laws() || sim.gravity != former.gravity;
        let has_other_laws = acts_otherwise || laws.iter().map(|laws| &laws.materials).ne(&former.laws);
        let mut warnings = check(self.scenario, &laws, sim, was, has_other_laws)?;
        if has_other_laws {
            sim.reach_as_far_as(laws.iter().map(|laws| &laws.materials));
            let found = self.sim.find_forces_of_other_laws(&former.materials);
            found.map_err(|fault| RunError::BeyondLaws(Box::new(fault)))?;
        }
        warnings.extend(in_the_past(self.scenario, was, self.place.stage, &self.sim));
        for warning in warnings {
            observer.message(&format!("warning: {warning}"));
            self.place.warnings.push(warning);
        }
        self.sim.book_change_since(former.present);
        self.traffic.go_on_otherwise(&was.feeds, (self.sim.step, self.sim.dt));
        let is_over = former.stage >= was.stages.len();
        let [stage, was_stage] = [self.place.stage, former.stage].map(|stage| stage.saturating_sub(is_over.into()));
        if let Some(told) = self.scenario.stages.get(stage) {
            if was.stages.get(was_stage).is_none_or(|was| was.stop != told.stop) {
                self.place.columns_held.clear();
            }
            let was = InForce::in_stage(was, was_stage);
            self.set_up(
                &InForce::in_stage(self.scenario, stage).instead_of(&was, told),
                observer,
            )?;
        }
        if is_over { self.begin_stage(observer) } else { Ok(()) }
    }
}

/// Refuses what the scenario tells now and the run cannot do with its time step; what is to be told of it.
fn check(
    scenario: &Scenario,
    laws: &[Bound<'_>],
    sim: &Simulation,
    was: &Scenario,
    has_other_laws: bool,
) -> Result<Vec<String>, RunError> {
    let mut faults = scenario.diagnostics();
    let mut all = sim.grains().clone();
    all.append(&to_come(scenario, &mut faults));
    check_to_go_on(scenario, laws, &all, sim, &mut faults);
    if !faults.is_empty() {
        return Err(faults.into());
    }
    let motions = |scenario: &Scenario| {
        scenario
            .stages
            .iter()
            .map(|stage| stage.motions.clone())
            .collect::<Vec<_>>()
    };
    let has_other_bodies =
        scenario.feeds != was.feeds || scenario.walls != was.walls || motions(scenario) != motions(was);
    if !has_other_laws && !has_other_bodies {
        return Ok(Vec::new());
    }
    let scale = time_scale(scenario, &all, &sim.walls, laws, &mut faults);
    let Some(scale) = scale else {
        return Err(faults.into());
    };
    let words = scale.beside(sim.dt());
    let (path, what) = if has_other_laws {
        ("contact", "the laws that are told now")
    } else {
        ("simulation.time_step", "the feeds and walls that are told now")
    };
    match scale.judge(sim.dt(), scenario.simulation.integrator) {
        Verdict::Unsafe if !scenario.simulation.allow_unsafe_time_step => {
            faults.push(
                path,
                format!("the time step of the run is unsafe for {what}: {words}"),
                Some(
                    "begin a new run with the grains of this one (`source = \"file\"`), or say `allow_unsafe_time_step = true` if you want it"
                        .to_string(),
                ),
            );
            Err(faults.into())
        }
        Verdict::Unsafe | Verdict::Long => Ok(vec![format!(
            "with {what} the time step of the run is {}",
            scale.cost(sim.dt(), scenario.simulation.integrator)
        )]),
        Verdict::Safe => Ok(Vec::new()),
    }
}

/// What is told otherwise of times that are over, so that nothing comes of it; the run is in a stage, told by its number.
fn in_the_past(scenario: &Scenario, was: &Scenario, stage: usize, sim: &Simulation) -> Vec<String> {
    let mut told = Vec::new();
    for (index, tag) in scenario.tags.iter().enumerate() {
        if !was.tags.contains(tag) && tag.every.is_none() && tag.is_over(sim) {
            told.push(format!(
                "tag[{index}] is given at {} s, and the run goes on from {:.4e} s: no grain gets it; `at` that time or later gives it",
                tag.at,
                sim.time()
            ));
        }
    }
    for done in scenario.stages.iter().take(stage) {
        let before = was.stages.iter().find(|stage| stage.name == done.name);
        if before.is_some_and(|before| before.stop != done.stop) {
            told.push(format!(
                "stage `{}` is over: what is told otherwise of its end has no effect",
                done.name
            ));
        }
    }
    told
}
