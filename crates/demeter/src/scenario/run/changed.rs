//! A run that goes on with a scenario that was changed.

use super::Runner;
use crate::scenario::Scenario;
use crate::scenario::run_error::RunError;
use crate::simulation::{Deformation, Stage};
use crate::walls::Motions;

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
            ..stage.clone()
        }
    }
}

impl Runner<'_> {
    /// Lets hold what the scenario tells otherwise than a former one, from which the run came until here, and begins the stage that was added
    /// behind its last.
    pub(in crate::scenario) fn go_on_otherwise(&mut self, former: &Scenario) -> Result<(), RunError> {
        let is_over = self.place.stage >= former.stages.len();
        let stage = self.place.stage.min(former.stages.len().saturating_sub(1));
        if let Some(told) = self.scenario.stages.get(stage) {
            let was = InForce::in_stage(former, stage);
            self.set_up(&InForce::in_stage(self.scenario, stage).instead_of(&was, told))?;
        }
        if is_over { self.begin_stage() } else { Ok(()) }
    }
}
