//! Walls in a domain with periodic sides: which are felt across them, and what to tell of those that are not.

use super::AXES;
use super::Scenario;
use super::checks::told_motions;
use crate::particles::{Domain, Grains};
use crate::walls::{Drift, Wall, WallError};

/// How every wall may move along the axes in the whole run.
pub(super) fn drifts(scenario: &Scenario) -> Vec<[Drift; 3]> {
    let mut drifts = vec![[Drift::None; 3]; scenario.walls.len()];
    for (wall, motions) in told_motions(scenario) {
        if let Some(drift) = drifts.get_mut(wall) {
            *drift = [0, 1, 2].map(|axis| drift[axis].max(motions.drift(axis)));
        }
    }
    let own = drifts.clone();
    for (wall, motions) in told_motions(scenario) {
        let leader = motions.leader().and_then(|leader| own.get(leader));
        if let (Some(drift), Some(leader)) = (drifts.get_mut(wall), leader) {
            *drift = [0, 1, 2].map(|axis| drift[axis].max(leader[axis]));
        }
    }
    drifts
}

/// Has walls be felt across the periodic sides of a domain; tells those of which that cannot be made.
pub(super) fn repeat(walls: &mut [Wall], scenario: &Scenario, domain: &Domain) -> Vec<(usize, WallError)> {
    if domain.periodic == [false; 3] {
        return Vec::new();
    }
    let drifts = drifts(scenario);
    let walls = walls.iter_mut().enumerate();
    walls
        .filter_map(|(k, wall)| Some((k, wall.repeat(domain, drifts[k]).err()?)))
        .collect()
}

/// Tells walls of which grains feel a rim at a periodic side, or nothing where they reach across it.
pub(super) fn check(walls: &[Wall], grains: &Grains, domain: &Domain, warnings: &mut Vec<String>) {
    let largest = grains.radii().fold(0.0, f64::max);
    let finite = walls.iter().filter_map(|wall| Some((wall, wall.bounds()?)));
    for (wall, (lower, upper)) in finite.filter(|(wall, _)| wall.is_present()) {
        for axis in (0..3).filter(|&axis| domain.periodic[axis]) {
            let (below, above) = (domain.lower[axis], domain.upper[axis]);
            let (name, axis_name) = (&wall.name, AXES[axis]);
            let (from, to) = (lower[axis], upper[axis]);
            let is_aside = to < below - largest || from > above + largest;
            if wall.is_repeated(axis) {
                let gap = (above - below) - (to - from);
                if gap > Wall::SAME_LENGTH * (above - below) && gap < largest {
                    warnings.push(format!(
                        "wall `{name}` is {:.9} m long along {axis_name} and the periodic box {:.9} m: between it and its image behind the \
                         side there is a gap of {gap:.3e} m, whose rims grains feel. Make it as long as the box",
                        to - from,
                        above - below
                    ));
                }
                continue;
            }
            let (reaches_lower, reaches_upper) = (from < below + largest, to > above - largest);
            if is_aside || !(reaches_lower || reaches_upper) {
                continue;
            }
            let why = if to - from > above - below {
                "it is longer than the box"
            } else {
                "it turns about another axis, or bounds what lies behind it without end"
            };
            if reaches_lower != reaches_upper {
                let side = if reaches_lower { "-" } else { "+" };
                warnings.push(format!(
                    "wall `{name}` comes within a grain's radius of the periodic side {side}{axis_name} and not of the opposite one, and is \
                     not repeated there, as {why}: grains that reach across that side do not feel it. Keep it away from the side, or let \
                     it go through the domain"
                ));
            } else if from > below - largest || to < above + largest {
                warnings.push(format!(
                    "wall `{name}` reaches from {from:.6} m to {to:.6} m along {axis_name}, where periodic sides are at {below:.6} m and \
                     {above:.6} m, and is not repeated there, as {why}: grains feel its rim before they are put back from behind a side. \
                     Let it reach beyond both sides by the radius of the largest grain, from {:.6} m or less to {:.6} m or more, or make \
                     it as long as the box",
                    below - largest,
                    above + largest
                ));
            }
        }
    }
}
