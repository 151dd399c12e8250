//! Conditions that cannot end the stage which waits for them, or end it before it has begun.

use super::feeds::FeedEnd;
use super::{Diagnostics, Scenario};
use crate::particles::{Grains, Outside};
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
            if matches!(condition, StopCondition::Column(_)) && stage.cadence.series.is_none() {
                let why = format!(
                    "stage `{}` has no rows of the series at which its columns would be looked at",
                    stage.name
                );
                let help = "tell `series = \"1 ms\"` in `output`, of the stage or of all".to_string();
                faults.push(&format!("{path}.stop.column"), why, Some(help));
            }
        }
    }

    /// Why a wall does not leave its place in the stage, if it does not.
    fn never_gets_there(&self, wall: usize) -> Option<String> {
        let motions = self.motions.get(wall)?;
        let name = &self.scenario.walls[wall].name;
        if motions.is_rest() {
            return Some(format!(
                "wall `{name}` has no motion in this stage, so that it never gets there"
            ));
        }
        motions.stays().then(|| {
            format!("the `belt` of wall `{name}` moves its surface alone: the wall stays, so that it never gets there")
        })
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
            StopCondition::WallTravel { wall, .. } => Some(("wall_travel", self.never_gets_there(*wall)?)),
            StopCondition::Strain { wall, .. } => Some(("strain", self.never_gets_there(*wall)?)),
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

/// Refuses to wait until grains have become fewer where none can leave.
pub(super) fn check_leaving(scenario: &Scenario, grains: &Grains, faults: &mut Diagnostics) {
    if !scenario.removals.is_empty() || scenario.domain.outside == Outside::Remove {
        return;
    }
    let mut told = std::collections::BTreeSet::new();
    for (stage, path) in scenario.stages.iter().zip(&scenario.stage_paths) {
        let least = stage.stop.iter().find_map(|condition| match condition {
            StopCondition::GrainsAtMost(least) => Some(*least),
            _ => None,
        });
        // repeats of a stage have one table
        if least.is_some_and(|least| grains.len() as u64 > least) && told.insert(path) {
            let why = format!(
                "none of the grains, {} at the start, can leave, so that there are never so few: the scenario has no \
                 [[removal]], and no domain with `outside = \"remove\"`",
                grains.len()
            );
            faults.push(&format!("{path}.stop.grains_at_most"), why, Some(REMEDY.to_string()));
        }
    }
}

/// Tells stages that end as soon as they have begun, since what they wait for has come by then.
pub(super) fn ended_at_once(scenario: &Scenario, grains: &Grains) -> Vec<String> {
    let mut told = Vec::new();
    for (index, feed) in scenario.feeds.iter().enumerate() {
        let waits = |stage: &&Stage| stage.stop.contains(&StopCondition::FeedDone(index));
        let mut waiting = scenario.stages.iter().filter(waits);
        if let (Some(first), Some(second)) = (waiting.next(), waiting.next()) {
            told.push(format!(
                "stage `{}` waits for feed `{}` to be done, as stage `{}` before it does: a feed ends once in a run, so that the later stage \
                 ends at once and no grain comes in it. Let a feed of its own fill each",
                second.name, feed.name, first.name
            ));
        }
    }
    let mut paths = std::collections::BTreeSet::new();
    for (stage, path) in scenario.stages.iter().zip(&scenario.stage_paths) {
        let enough = stage.stop.iter().find_map(|condition| match condition {
            StopCondition::GrainsAtMost(most) if grains.len() as u64 <= *most => Some(*most),
            _ => None,
        });
        // repeats of a stage have one table
        if let (Some(most), true) = (enough, scenario.feeds.is_empty())
            && paths.insert(path)
        {
            told.push(format!(
                "stage `{}` is to end when {most} grains are left, and there are {} at the start: it ends with its first step",
                stage.name,
                grains.len()
            ));
        }
    }
    told
}
