//! What can be wrong with a scenario beyond its text: memory, overlaps, motions.

use super::laws_of_stages::Bound;
use super::meshes::{MeshOrigin, doubt_unit_of};
use super::{Diagnostics, Scenario, estimates, stop_checks};
use crate::contacts::{SOLID_BEHIND, TWO_SIDES};
use crate::insertion::{Amount, Insertion, Region, SizeSampler, Source, first_overlap};
use crate::particles::{Domain, Grains, Outside};
use crate::simulation::{
    Misfit, ROOM_FOR_BULGES, TimeScale, TimeStepError, USABLE, WallPartner, largest_reach, with_free_wall,
};
use crate::walls::{INSTEAD_OF_LINKS, Motion, Motions, Wall, link, link_in_words};
use glam::DVec3;
use std::f64::consts::PI;

/// Refuses grains that cannot fit into memory before any is made.
pub(super) fn check_memory(scenario: &Scenario, walls: &[Wall], are_coupled: bool, faults: &mut Diagnostics) {
    let at_start: f64 = scenario.grains.iter().map(expected_count).sum();
    // where grains leave, how many are there at a time is not known
    let is_left = scenario.domain.outside == Outside::Remove || !scenario.removals.is_empty();
    // only what is told by numbers: how long stages take is not known yet
    let endless = vec![f64::INFINITY; scenario.stages.len()];
    let fed = if is_left {
        0.0
    } else {
        estimates::fed(scenario, &endless).grains
    };
    let expected = at_start + fed;
    let Some(available) = available_memory() else { return };
    let needed = estimates::memory(expected, walls, are_coupled);
    if needed > available {
        let largest = (0..scenario.grains.len())
            .max_by(|&a, &b| expected_count(&scenario.grains[a]).total_cmp(&expected_count(&scenario.grains[b])));
        faults.push(
            &format!("grains[{}]", largest.unwrap_or(0)),
            format!(
                "about {expected:.3e} grains need {:.1} GiB of memory, and {:.1} GiB are free",
                needed / GIBIBYTE,
                available / GIBIBYTE
            ),
            Some("insert fewer or larger grains, or use a machine with more memory".to_string()),
        );
    }
}

const GIBIBYTE: f64 = (1u64 << 30) as f64;

/// Number of grains that an insertion will make, as far as its description tells.
fn expected_count(insertion: &Insertion) -> f64 {
    match &insertion.source {
        Source::Random {
            amount: Amount::Count(count),
            ..
        } => f64::from(*count),
        Source::Random {
            region,
            diameter,
            amount: Amount::VolumeFraction(fraction),
        } => SizeSampler::new(diameter).map_or(0.0, |sizes| volume(region) * fraction / sizes.mean_volume()),
        Source::Lattice {
            spacing, region, count, ..
        } => {
            // no lattice holds more than sqrt(2) sites per cubed spacing
            let sites = 2f64.sqrt() * volume(region) / (spacing * spacing * spacing);
            count.map_or(sites, |c| sites.min(f64::from(c)))
        }
        Source::List { positions, .. } => positions.len() as f64,
        Source::File { .. } => 0.0,
    }
}

fn volume(region: &Region) -> f64 {
    match region {
        Region::Box { lower, upper } => {
            let size = *upper - *lower;
            size.x * size.y * size.z
        }
        Region::Cylinder { start, end, radius } => PI * radius * radius * (*end - *start).length(),
    }
}

/// Memory that is free, where the system tells it [bytes].
pub fn available_memory() -> Option<f64> {
    let text = std::fs::read_to_string("/proc/meminfo").ok()?;
    let line = text.lines().find_map(|l| l.strip_prefix("MemAvailable:"))?;
    let kibibytes: f64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    Some(1024.0 * kibibytes)
}

/// In a periodic direction a grain must not meet two images of one partner.
pub(super) fn check_periodic_size(
    grains: &Grains,
    domain: &Domain,
    skin: f64,
    laws: &[Bound<'_>],
    deforms: bool,
    faults: &mut Diagnostics,
) {
    let largest = grains.radii().fold(0.0, f64::max);
    let bulges = if laws.iter().any(|laws| laws.materials.are_coupled()) {
        ROOM_FOR_BULGES * largest
    } else {
        0.0
    };
    let reaches = laws.iter().map(|laws| largest_reach(grains, &[], &laws.materials));
    let reach = reaches.fold(0.0, f64::max);
    let share = if deforms { 2.0 * USABLE } else { 1.0 };
    let least = (4.0 * largest + 2.0 * (skin + reach) + bulges) / share;
    for axis in (0..3).filter(|&k| domain.periodic[k]) {
        let size = domain.size()[axis];
        if size <= least {
            faults.push(
                "domain",
                format!(
                    "the domain is {size} m long in the periodic direction {}; with grains of radius {largest} m it \
                     must be longer than {least} m, or a grain meets two images of one partner",
                    ["x", "y", "z"][axis]
                ),
                Some("widen the domain".to_string()),
            );
        }
    }
}

pub(super) fn check_overlaps(
    scenario: &Scenario,
    grains: &Grains,
    walls: &[Wall],
    domain: &Domain,
    faults: &mut Diagnostics,
    warnings: &mut Vec<String>,
) {
    let allowed = scenario.simulation.max_overlap;
    let places: Vec<(DVec3, f64)> = grains.position.iter().copied().zip(grains.radii()).collect();
    // fixed grains that overlap each other are one rough body
    let may_move = |i: usize, j: usize| !(grains.is_fixed(i) && grains.is_fixed(j));
    if let Some(pair) = first_overlap(&places, Some(domain), may_move) {
        let (i, j) = (pair.first, pair.second);
        let share = pair.relative;
        let words = format!(
            "grains {} at {} and {} at {} overlap at the start by {} of the smaller radius",
            grains.id[i],
            grains.position[i],
            grains.id[j],
            grains.position[j],
            of_radius(share)
        );
        if share > allowed {
            let advice = "move them apart, or raise `simulation.max_overlap` if the packing is meant to be loaded";
            faults.push(
                "grains",
                format!("{words}; {allowed} is allowed"),
                Some(advice.to_owned()),
            );
        } else if share > 1e-9 {
            warnings.push(format!("{words}: they start loaded"));
        }
    }
    if let Some((g, wall, share)) = deepest_in_wall(grains, walls) {
        let words = format!(
            "grain {} at {} overlaps wall `{}` at the start by {} of its radius",
            grains.id[g],
            grains.position[g],
            walls[wall].name,
            of_radius(share)
        );
        if share > allowed {
            let advice = if share > 1.0 {
                format!(
                    "{SOLID_BEHIND}: move it, let the grains come by a `[[feed]]`, which keeps them off walls, or {TWO_SIDES}"
                )
            } else {
                "move them apart, let the grains come by a `[[feed]]`, which keeps them off walls, or raise \
                 `simulation.max_overlap` if the packing is meant to be loaded"
                    .into()
            };
            faults.push("grains", format!("{words}; {allowed} is allowed"), Some(advice));
        } else if share > 1e-9 {
            warnings.push(format!("{words}: it starts loaded"));
        }
    }
}

/// An overlap as a share of a radius; one that three places would tell as nothing keeps its order of magnitude.
fn of_radius(share: f64) -> String {
    if share < 1e-3 {
        format!("{share:.1e}")
    } else {
        format!("{share:.3}")
    }
}

/// The deepest overlap of a grain with a wall: grain, wall, share of the radius.
fn deepest_in_wall(grains: &Grains, walls: &[Wall]) -> Option<(usize, usize, f64)> {
    let mut deepest: Option<(usize, usize, f64)> = None;
    for g in (0..grains.len()).filter(|&g| !grains.is_fixed(g)) {
        let (place, radius) = (grains.position[g], grains.radius(g));
        for (w, wall) in walls.iter().enumerate() {
            let share = wall.nearest(place, radius).map(|distance| (radius - distance) / radius);
            if let Some(share) = share.filter(|share| deepest.is_none_or(|(_, _, s)| *share > s)) {
                deepest = Some((g, w, share));
            }
        }
    }
    deepest
}

/// A wall may not move by more than this share of the smallest radius in one step.
const MOST_MOTION: f64 = 0.1;

/// A motion that comes and goes takes at least this many steps each time; with fewer the steps see another motion.
const LEAST_STEPS_OF_PERIOD: f64 = 20.0;

/// Tells motions that are too fast for the time step.
pub(super) fn check_wall_speeds(
    scenario: &Scenario,
    built: &[Wall],
    meshes: &[Option<MeshOrigin>],
    grains: &Grains,
    dt: f64,
    faults: &mut Diagnostics,
) {
    let walls = scenario
        .walls
        .iter()
        .enumerate()
        .map(|(k, wall)| (format!("wall[{k}].motion"), k, &wall.motion));
    let stages = scenario
        .stages
        .iter()
        .zip(&scenario.stage_paths)
        .flat_map(|(stage, path)| {
            stage.motions.iter().map(move |(wall, motion)| {
                let name = &scenario.walls[*wall].name;
                (format!("{path}.motion.{name}"), *wall, motion)
            })
        });
    let smallest = grains.radii().fold(f64::INFINITY, f64::min);
    for (path, index, motion) in walls.chain(stages) {
        let name = &scenario.walls[index].name;
        let bounds = built.get(index).and_then(Wall::bounds);
        let mesh = built.get(index).zip(meshes.get(index).and_then(Option::as_ref));
        if let Some(speed) = largest_speed(motion, bounds).filter(|speed| speed * dt > MOST_MOTION * smallest) {
            faults.push(
                &path,
                format!(
                    "wall `{name}` moves at up to {speed:.4e} m/s, {:.3} of the smallest radius in one time step of \
                     {dt:.3e} s; at most {MOST_MOTION} is allowed, or it jumps over grains",
                    speed * dt / smallest
                ),
                Some(
                    mesh.and_then(|(wall, origin)| doubt_unit_of(wall, origin, grains))
                        .unwrap_or_else(|| "slow it down or use a shorter time step".to_string()),
                ),
            );
        }
        let periods = motion.parts.iter().filter_map(|part| shortest_period(&part.motion));
        let shortest = periods.min_by(|a, b| a.1.total_cmp(&b.1));
        if let Some((does, period)) = shortest.filter(|(_, period)| *period < LEAST_STEPS_OF_PERIOD * dt) {
            faults.push(
                &path,
                format!(
                    "wall `{name}` {does} within {period:.4e} s, {:.3} time steps of {dt:.3e} s; at least {LEAST_STEPS_OF_PERIOD} are \
                     needed, or the steps see another motion than the one that is told",
                    period / dt
                ),
                Some(format!(
                    "let it take {:.3e} s or longer, or set `simulation.time_step` to {:.3e} s or less",
                    LEAST_STEPS_OF_PERIOD * dt,
                    period / LEAST_STEPS_OF_PERIOD
                )),
            );
        }
    }
}

/// Refuses grains at the start that come farther than their radius in a step, as each step does.
pub(super) fn check_start_speeds(grains: &Grains, dt: f64, faults: &mut Diagnostics) {
    let way = |g: usize| grains.velocity[g].length() * dt;
    let Some(g) = (0..grains.len()).find(|&g| way(g) > grains.radius(g)) else {
        return;
    };
    let what = format!("grain {} at {} starts", grains.id[g], grains.position[g]);
    let (speed, radius) = (grains.velocity[g].length(), grains.radius(g));
    refuse_jump("grains", &what, (speed, radius), dt, faults);
}

/// The same of grains that feeds bring, told two of each feed.
pub(super) fn check_feed_speeds(scenario: &Scenario, to_come: &Grains, dt: f64, faults: &mut Diagnostics) {
    for (k, feed) in scenario.feeds.iter().enumerate() {
        let speed = feed.stream.velocity.length();
        let radii = to_come.radii().skip(2 * k).take(2);
        let smallest = radii.fold(f64::INFINITY, f64::min);
        if speed * dt > smallest {
            let what = format!("a grain of feed `{}` starts", feed.name);
            refuse_jump(&format!("feed[{k}].velocity"), &what, (speed, smallest), dt, faults);
        }
    }
}

fn refuse_jump(path: &str, what: &str, (speed, radius): (f64, f64), dt: f64, faults: &mut Diagnostics) {
    faults.push(
        path,
        format!(
            "{what} with {speed:.4e} m/s, {:.4e} m in one time step of {dt:.3e} s and more than its radius of {radius:.4e} m: \
             it jumps over others",
            speed * dt
        ),
        Some(format!("let it be slower, or set `simulation.time_step` to less than {:.3e} s", radius / speed)),
    );
}

/// All motions that any wall is told in the run.
pub(super) fn told_motions(scenario: &Scenario) -> impl Iterator<Item = (usize, &Motions)> {
    let at_start = scenario.walls.iter().map(|wall| &wall.motion).enumerate();
    let in_stages = scenario.stages.iter().flat_map(|stage| &stage.motions);
    at_start.chain(in_stages.map(|(wall, motions)| (*wall, motions)))
}

/// The shorter of a time scale and those of all springs and dampers that hold a freely moving wall in the run.
pub(super) fn with_free_walls(scale: TimeScale, scenario: &Scenario) -> Result<TimeScale, TimeStepError> {
    told_motions(scenario).try_fold(scale, |scale, (wall, motions)| {
        // a free motion is always the first
        let Some(Motion::Free(free)) = motions.parts.first().map(|part| &part.motion) else {
            return Ok(scale);
        };
        let name = scenario.walls.get(wall).map_or("", |wall| wall.name.as_str());
        with_free_wall(scale, name, free)
    })
}

/// The walls as the time step sees them: with each mass that any of them gives way with in the run.
pub(super) fn wall_partners(scenario: &Scenario, walls: &[Wall]) -> Vec<WallPartner> {
    let told: Vec<(usize, &Motions)> = told_motions(scenario).collect();
    let mut partners: Vec<WallPartner> = walls.iter().map(WallPartner::of).collect();
    for (index, motions) in &told {
        if !motions.is_free() {
            continue;
        }
        // what moves with a free wall gives way as it does
        let follows = |k: usize| {
            told.iter()
                .any(|(wall, motions)| *wall == k && motions.leader() == Some(*index))
        };
        for (_, wall) in walls.iter().enumerate().filter(|(k, _)| k == index || follows(*k)) {
            // what is wrong with motions is told elsewhere
            let least = walls
                .get(*index)
                .map(|leader| leader.least_mass_with(motions, wall.bounds()));
            if let Some(Ok(mass)) = least {
                let material = wall.material;
                partners.push(WallPartner { material, mass });
            }
        }
    }
    partners
}

/// Refuses motions that a wall cannot make before any stage has run, walls that move with one that itself moves with another, and
/// stages that wait for what never comes.
pub(super) fn check_stage_motions(scenario: &Scenario, faults: &mut Diagnostics) {
    let mut told = std::collections::BTreeSet::new();
    let mut leaders: Vec<Option<usize>> = scenario.walls.iter().map(|wall| wall.motion.leader()).collect();
    let mut known = stop_checks::Known::at_start(scenario);
    let first = (0..leaders.len()).map(|wall| (wall, format!("wall[{wall}].motion")));
    check_leaders(scenario, &leaders, &first.collect::<Vec<_>>(), faults);
    for (stage, path) in scenario.stages.iter().zip(&scenario.stage_paths) {
        // repeats of a stage have one table
        let is_new = told.insert(path);
        let mut paths = Vec::new();
        for (wall, motions) in &stage.motions {
            let name = scenario.walls.get(*wall).map_or("", |w| w.name.as_str());
            let path = format!("{path}.motion.{name}");
            if let (Err(error), true) = (Wall::check_motion(motions), is_new) {
                faults.push(&path, format!("wall `{name}`: {error}"), None);
            }
            if let Some(leader) = leaders.get_mut(*wall) {
                *leader = motions.leader();
            }
            paths.push((*wall, path));
        }
        known.begin(stage);
        if is_new {
            check_leaders(scenario, &leaders, &paths, faults);
            known.check(stage, path, faults);
        }
    }
    check_stage_gravity(scenario, faults);
}

/// Refuses that a stage tells a gravity where not all follow it.
fn check_stage_gravity(scenario: &Scenario, faults: &mut Diagnostics) {
    let told = scenario.walls.iter().map(|wall| &wall.motion).enumerate();
    let later = scenario.stages.iter().flat_map(|stage| &stage.motions);
    let mut motions = told.chain(later.map(|(wall, motions)| (*wall, motions)));
    let free = motions.find(|(_, motions)| motions.is_free());
    let free = free.and_then(|(wall, _)| scenario.walls.get(wall));
    // repeats of a stage have one table
    let mut paths = std::collections::BTreeSet::new();
    for (stage, path) in scenario.stages.iter().zip(&scenario.stage_paths) {
        let Some(gravity) = stage.gravity.filter(|_| paths.insert(path)) else {
            continue;
        };
        let path = format!("{path}.gravity");
        if let Some(wall) = free {
            faults.push(
                &path,
                format!(
                    "the weight of wall `{}`, which moves freely, does not follow the gravity of a stage",
                    wall.name
                ),
                Some("let it move otherwise, or leave the gravity of `[simulation]` for the whole run".to_string()),
            );
        }
        if scenario.deforms() && gravity != DVec3::ZERO {
            faults.push(&path, Misfit::Gravity.to_string(), None);
        }
    }
}

fn check_leaders(scenario: &Scenario, leaders: &[Option<usize>], paths: &[(usize, String)], faults: &mut Diagnostics) {
    for (wall, path) in paths {
        let Some(between) = link(leaders, *wall) else { continue };
        let [follower, leader] = between.map(|w| scenario.walls[w].name.as_str());
        faults.push(
            path,
            link_in_words(follower, leader),
            Some(INSTEAD_OF_LINKS.to_string()),
        );
    }
}

/// What a motion does again and again, and the shortest time in which it does [s]; `None` where it does not.
fn shortest_period(motion: &Motion) -> Option<(&'static str, f64)> {
    let (does, frequency) = match motion {
        Motion::Oscillation {
            amplitude, frequency, ..
        } if *amplitude != DVec3::ZERO => ("oscillates once", *frequency),
        Motion::Rocking {
            amplitude, frequency, ..
        } if *amplitude != 0.0 => ("rocks once", *frequency),
        Motion::Rotation { angular_velocity, .. } => ("turns once", angular_velocity.abs() / (2.0 * PI)),
        Motion::Table(table) => return Some(("goes to and fro by its table", 2.0 * table.shortest_way()?)),
        _ => return None,
    };
    (frequency > 0.0).then(|| (does, 1.0 / frequency))
}

/// Upper bound of the speed of a wall by all motions that do not depend on forces, none where it rests [m/s]. Motions that turn
/// count as far as the wall lies from the point of their axis where it starts; a wall without bounds by its straight ones alone.
fn largest_speed(motions: &Motions, bounds: Option<(DVec3, DVec3)>) -> Option<f64> {
    let reach = |point: DVec3, axis: DVec3| {
        bounds.map_or(0.0, |(lower, upper)| {
            let corner = |k: usize| DVec3::select(glam::BVec3::new(k & 1 > 0, k & 2 > 0, k & 4 > 0), lower, upper);
            (0..8).fold(0.0, |far, k| f64::max(far, axis.cross(corner(k) - point).length()))
        })
    };
    let speed = |motion: &Motion| match motion {
        Motion::Velocity(velocity) | Motion::Belt(velocity) => velocity.length(),
        Motion::Oscillation {
            amplitude, frequency, ..
        } => 2.0 * PI * frequency * amplitude.length(),
        Motion::Table(table) => {
            let turn = table
                .axis()
                .map_or(0.0, |(point, axis)| table.largest_rate() * reach(point, axis));
            table.largest_speed() + turn
        }
        Motion::Servo { max_speed, .. } => *max_speed,
        Motion::Rotation {
            point,
            axis,
            angular_velocity,
        } => angular_velocity.abs() * reach(*point, *axis),
        Motion::Rocking {
            point,
            axis,
            amplitude,
            frequency,
            ..
        } => 2.0 * PI * frequency * amplitude.abs() * reach(*point, *axis),
        Motion::TorqueServo {
            point, axis, max_speed, ..
        } => max_speed * reach(*point, *axis),
        Motion::Body(body) => {
            let spin = body.angular_velocity.length();
            let reach = bounds.map_or(0.0, |(lower, upper)| (upper - lower).length());
            body.velocity.length() + spin * reach
        }
        Motion::Rest | Motion::Free(_) | Motion::With(_) | Motion::Driven { .. } => 0.0,
    };
    let sum: f64 = motions.parts.iter().map(|part| speed(&part.motion)).sum();
    (sum > 0.0).then_some(sum)
}

#[cfg(test)]
mod tests {
    use super::of_radius;

    #[test]
    fn an_overlap_is_never_told_as_nothing() {
        assert_eq!([0.5, 0.0123, 4e-6].map(of_radius), ["0.500", "0.012", "4.0e-6"]);
    }
}
