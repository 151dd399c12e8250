//! Conditions that cannot end the stage which waits for them, or end it before it has begun.

use super::feeds::FeedEnd;
use super::{Diagnostics, Scenario};
use crate::simulation::{Stage, StopCondition};
use crate::walls::Motions;

const REMEDY: &str = "end the stage by its `duration` or by another condition";

/// What a stage begins with.
pub(super) struct Known<'a> {
    scenario: &'a Scenario,
    motions: Vec<&'a Motions>,
    absent: &'a [usize],
    /// Whether each feed runs in the stage, and whether it has run in it or before.
    feeds: Vec<(bool, bool)>,
}

impl<'a> Known<'a> {
    /// Before the first stage.
    pub(super) fn at_start(scenario: &'a Scenario) -> Self {
        Self {
            scenario,
            motions: scenario.walls.iter().map(|wall| &wall.motion).collect(),
            absent: &[],
            feeds: vec![(true, false); scenario.feeds.len()],
        }
    }

    /// Takes what a stage tells.
    pub(super) fn begin(&mut self, stage: &'a Stage) {
        for (wall, motions) in &stage.motions {
            if let Some(current) = self.motions.get_mut(*wall) {
                *current = motions;
            }
        }
        if let Some(absent) = &stage.absent {
            self.absent = absent;
        }
        for (k, (runs, has_run)) in self.feeds.iter_mut().enumerate() {
            *runs = stage.feeds.as_ref().map_or(*runs, |running| running.contains(&k));
            *has_run |= *runs;
        }
    }

    /// Refuses conditions of the stage that never hold, or always.
    pub(super) fn check(&self, stage: &Stage, path: &str, faults: &mut Diagnostics) {
        for condition in &stage.stop {
            if let Some((key, why)) = self.fault_of(condition) {
                faults.push(&format!("{path}.stop.{key}"), why, Some(REMEDY.to_string()));
            }
        }
    }

    /// The key of a condition that never holds or always does, and why.
    fn fault_of(&self, condition: &StopCondition) -> Option<(&'static str, String)> {
        match condition {
            StopCondition::MotionDone(wall) => {
                let motions = self.motions.get(*wall)?;
                let name = &self.scenario.walls[*wall].name;
                if motions.is_rest() {
                    let why = format!("wall `{name}` has no motion in this stage, which would end with its first step");
                    return Some(("motion_done", why));
                }
                let why = motions.never_ends()?;
                Some(("motion_done", format!("the motion of wall `{name}` never ends: {why}")))
            }
            StopCondition::WallTravel { wall, .. } if self.motions.get(*wall)?.is_rest() => {
                let name = &self.scenario.walls[*wall].name;
                let why = format!("wall `{name}` has no motion in this stage, so that it never gets there");
                Some(("wall_travel", why))
            }
            StopCondition::FeedDone(feed) => {
                let spec = self.scenario.feeds.get(*feed)?;
                let why = match self.feeds[*feed] {
                    _ if spec.end == FeedEnd::default() => {
                        "it has a rate, and neither `count`, `mass`, `level` nor `until`"
                    }
                    (false, false) => "it runs neither in this stage nor in one before",
                    _ => return None,
                };
                Some(("feed_done", format!("feed `{}` never ends: {why}", spec.name)))
            }
            StopCondition::WallForce { walls, .. } if walls.iter().all(|wall| self.absent.contains(wall)) => {
                let name = &self.scenario.walls.get(*walls.first()?)?.name;
                Some(("wall_force", format!("no force acts on wall `{name}`: it is absent")))
            }
            _ => None,
        }
    }
}
