//! Walls that grains do not meet any more: those that lie outside of the domain, or have moved too far along a periodic one or to a side of
//! it across which they are not felt.

use super::AXES;
use super::Scenario;
use super::checks::told_motions;
use crate::particles::{Domain, Grains};
use crate::walls::{FARTHEST, Wall};
use glam::DVec3;

/// Moments of a stage at which it is foreseen where walls are.
const MOMENTS: u32 = 64;
/// Most stages that are foreseen.
const MOST_STAGES: usize = 100;

/// Why grains do not meet a wall, if they do not; `reach`: how far they reach beyond the sides of the domain [m].
fn astray(wall: &Wall, domain: &Domain, reach: f64) -> Option<String> {
    let moved = wall.pose().translation;
    let size = domain.size();
    if let Some(axis) = (0..3).find(|&k| wall.is_repeated(k) && moved[k].abs() > FARTHEST * size[k]) {
        let name = AXES[axis];
        return Some(format!(
            "has moved by {:.6} m along {name}, where the periodic box is {:.6} m long: it is felt across the sides only as long as it \
             has moved by less than {FARTHEST} of the box, and leaves a part of the box without a wall then. A `belt`, or a plane that moves in itself, \
             never leaves; so do tables that bring the wall back",
            moved[axis], size[axis]
        ));
    }
    if let Some(axis) = (0..3).find(|&k| domain.periodic[k] && is_cut_off(wall, domain, reach, k)) {
        return Some(format!(
            "comes within a grain's radius of the periodic sides along {}, across which it is not felt, as it turns: grains reach through it \
             there. Make the box longer, keep the body away from its sides, or let it slide alone, with `turns = []`",
            AXES[axis]
        ));
    }
    let (lower, upper) = wall.rough_bounds()?;
    let is_beyond =
        |k: usize| !wall.is_repeated(k) && (upper[k] < domain.lower[k] - reach || lower[k] > domain.upper[k] + reach);
    let axis = (0..3).find(|&k| is_beyond(k))?;
    Some(format!(
        "lies wholly outside of the domain, from {:.6} m to {:.6} m along {}, where the domain reaches from {:.6} m to {:.6} m: no \
         grain feels it there",
        lower[axis], upper[axis], AXES[axis], domain.lower[axis], domain.upper[axis]
    ))
}

/// Whether a rigid body reaches to a side of the domain across which grains do not feel it.
fn is_cut_off(wall: &Wall, domain: &Domain, reach: f64, axis: usize) -> bool {
    let is_near = |(lower, upper): (DVec3, DVec3)| {
        lower[axis] < domain.lower[axis] + reach || upper[axis] > domain.upper[axis] - reach
    };
    wall.is_body() && !wall.is_repeated(axis) && wall.bounds().is_some_and(is_near)
}

/// How far grains reach beyond the sides of the domain [m].
fn reach(grains: &Grains) -> f64 {
    grains.radii().fold(0.0, f64::max)
}

/// Tells walls that no grain meets where they stand, and those that will have gone astray by the motions that are told.
pub(super) fn check(
    scenario: &Scenario,
    walls: &[Wall],
    (grains, domain): (&Grains, &Domain),
    dt: f64,
    warnings: &mut Vec<String>,
) {
    let reach = reach(grains);
    for (index, wall) in walls.iter().enumerate() {
        let name = &wall.name;
        let moves = || told_motions(scenario).any(|(w, motions)| w == index && !motions.is_rest());
        match astray(wall, domain, reach) {
            // one that moves may come in later
            Some(why) if wall.is_present() && !moves() => {
                warnings.push(format!(
                    "wall `{name}` {why}. Is its place, or its `unit` or `shift`, right?"
                ));
            }
            Some(_) => {}
            None => {
                if let Some((time, why)) = foreseen(scenario, index, wall, (domain, reach), dt) {
                    warnings.push(format!("wall `{name}` goes astray: at {time:.4e} s it {why}"));
                }
            }
        }
    }
}

/// When a wall will have gone astray [s], and why; `None` if it does not, or nobody can foresee it.
fn foreseen(
    scenario: &Scenario,
    index: usize,
    wall: &Wall,
    (domain, reach): (&Domain, f64),
    dt: f64,
) -> Option<(f64, String)> {
    let mut wall = wall.clone();
    let mut rests = scenario.walls[index].motion.is_rest();
    let mut time = 0.0;
    for stage in scenario.stages.iter().take(MOST_STAGES) {
        for (_, motions) in stage.motions.iter().filter(|(w, _)| *w == index) {
            wall.set_motion(motions.clone()).ok()?;
            rests = motions.is_rest();
        }
        if let Some(absent) = &stage.absent {
            wall.set_present(!absent.contains(&index));
        }
        // a stage that a condition ends may be far shorter
        let ends_any_time = stage.stop.len() > 1;
        if !wall.is_foreseeable() || (ends_any_time && !rests) {
            return None;
        }
        let duration = super::run::longest(stage, dt) * dt;
        for _ in 0..MOMENTS {
            wall.advance(duration / f64::from(MOMENTS));
            time += duration / f64::from(MOMENTS);
            if let Some(why) = astray(&wall, domain, reach).filter(|_| wall.is_present()) {
                return Some((time, why));
            }
        }
    }
    None
}

/// Which walls of a run are known to be astray.
#[derive(Debug, Default)]
pub(super) struct StrayWalls {
    known: Vec<bool>,
}

impl StrayWalls {
    /// Those that are now.
    pub(super) fn of(walls: &[Wall], domain: &Domain, grains: &Grains) -> Self {
        let mut found = Self::default();
        found.news(walls, domain, grains);
        found
    }

    /// What to tell of those that went astray since it was asked last.
    pub(super) fn news(&mut self, walls: &[Wall], domain: &Domain, grains: &Grains) -> Vec<String> {
        self.known.resize(walls.len(), false);
        let reach = reach(grains);
        let mut news = Vec::new();
        for (wall, known) in walls.iter().zip(&mut self.known) {
            let why = astray(wall, domain, reach).filter(|_| wall.is_present());
            let was_known = std::mem::replace(known, why.is_some());
            if let (Some(why), false) = (why, was_known) {
                news.push(format!("warning: wall `{}` {why}", wall.name));
            }
        }
        news
    }
}
