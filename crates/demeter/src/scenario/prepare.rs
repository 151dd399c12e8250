//! From a scenario to a simulation: everything that can be wrong before step 0 is told here.

use super::{Diagnostics, Scenario, TimeStep, WallShape, WallSpec};
use crate::insertion::{Amount, Insertion, Region, SizeSampler, Source, first_overlap, insert};
use crate::materials::Materials;
use crate::particles::{Domain, Grains};
use crate::simulation::{SAFE_SHARE, Setup, TimeScale, UNSAFE_SHARE, shortest_time_scale};
use crate::walls::{Mesh, Shape, SurfaceContact, Wall, read_stl};
use demeter_physics::contact::LawError;
use glam::DVec3;
use std::f64::consts::PI;

/// Memory of a grain with its contacts and candidates in a dense packing, measured on 20,000 settled grains [bytes].
const BYTES_PER_GRAIN: f64 = 3000.0;

/// Particle-steps per second and thread assumed for the estimate of the run time.
const ASSUMED_SPEED: f64 = 2e6;

/// Distance beyond touching at which bodies become candidates, as a share of the mean radius.
const SKIN_SHARE: f64 = 0.2;

/// A scenario made ready to run.
#[derive(Debug)]
pub struct Prepared {
    /// What the simulation is made of.
    pub setup: Setup,
    /// Shortest time scale of the laws in use.
    pub time_scale: TimeScale,
    /// The time step in words: its value, its share of the shortest time scale, and where that comes from.
    pub time_step_reason: String,
    /// What the user should know, though it is no fault.
    pub warnings: Vec<String>,
    /// Steps of every stage when no condition ends it early.
    pub stage_steps: Vec<u64>,
    /// Steps of the whole protocol when no condition ends a stage early.
    pub steps: u64,
    /// Estimated memory [bytes].
    pub memory: u64,
    /// Estimated run time on one thread [s].
    pub run_time: f64,
}

/// Makes a scenario ready to run, or tells everything that is wrong with it.
pub fn prepare(scenario: &Scenario) -> Result<Prepared, Diagnostics> {
    let mut faults = scenario.diagnostics();
    let mut warnings = Vec::new();
    super::plots::check(scenario, &mut faults);
    let materials = materials(scenario, &mut faults);
    let walls = walls(scenario, &mut faults);
    check_stage_motions(scenario, &mut faults);
    check_memory(scenario, &mut faults);
    if !faults.is_empty() {
        return Err(faults);
    }
    let grains = grains(scenario, &mut faults);
    let (Some(materials), true) = (materials, faults.is_empty()) else {
        return Err(faults);
    };
    let domain = domain(scenario, &grains, &walls, &mut faults);
    check_overlaps(scenario, &grains, &walls, &domain, &mut faults, &mut warnings);
    if grains.is_empty() {
        faults.push("grains", "there is no grain", Some("add a [[grains]] table".into()));
    }
    let skin = scenario
        .simulation
        .skin
        .unwrap_or_else(|| SKIN_SHARE * mean(&grains.radius));
    check_periodic_size(&grains, &domain, skin, &mut faults);
    let wall_materials: Vec<u16> = walls.iter().map(|w| w.material).collect();
    let max_overlap = scenario.simulation.max_overlap;
    let scale = shortest_time_scale(&grains, &wall_materials, &materials, max_overlap);
    let scale = match scale {
        Ok(scale) if faults.is_empty() => scale,
        Ok(_) => return Err(faults),
        Err(error) => {
            if faults.is_empty() {
                faults.push("simulation.time_step", error.to_string(), None);
            }
            return Err(faults);
        }
    };
    let (dt, reason) = time_step(scenario, &scale, &mut faults, &mut warnings);
    if !faults.is_empty() {
        return Err(faults);
    }
    let stage_steps: Vec<u64> = scenario.stages.iter().map(|s| super::run::longest(s, dt)).collect();
    let steps = stage_steps.iter().copied().fold(0, u64::saturating_add);
    Ok(Prepared {
        memory: (grains.len() as f64 * BYTES_PER_GRAIN) as u64,
        run_time: grains.len() as f64 * steps as f64 / ASSUMED_SPEED,
        time_scale: scale,
        time_step_reason: reason,
        warnings,
        stage_steps,
        steps,
        setup: Setup {
            grains,
            walls,
            materials,
            domain,
            gravity: scenario.simulation.gravity,
            dt,
            skin,
            max_overlap,
        },
    })
}

/// What a run needs to go on from a checkpoint: everything but the grains and the time step, which the checkpoint holds.
pub(super) fn prepare_to_resume(scenario: &Scenario, domain: Domain, skin: f64) -> Result<Setup, Diagnostics> {
    let mut faults = scenario.diagnostics();
    let materials = materials(scenario, &mut faults);
    let walls = walls(scenario, &mut faults);
    let (Some(materials), true) = (materials, faults.is_empty()) else {
        return Err(faults);
    };
    Ok(Setup {
        grains: Grains::default(),
        walls,
        materials,
        domain,
        gravity: scenario.simulation.gravity,
        dt: f64::NAN,
        skin,
        max_overlap: scenario.simulation.max_overlap,
    })
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len().max(1) as f64
}

fn materials(scenario: &Scenario, faults: &mut Diagnostics) -> Option<Materials> {
    match Materials::new(scenario.materials.clone(), |a, b| scenario.contact.choice(a, b)) {
        Ok(materials) => Some(materials),
        Err(error) => {
            let help = match &error {
                LawError::Unknown { .. } => Some("`demeter laws` lists all laws".to_string()),
                LawError::Parameters { law, .. } => Some(format!("`demeter laws {law}` tells its parameters")),
            };
            faults.push("contact", error.to_string(), help);
            None
        }
    }
}

fn walls(scenario: &Scenario, faults: &mut Diagnostics) -> Vec<Wall> {
    let mut walls = Vec::new();
    for (k, spec) in scenario.walls.iter().enumerate() {
        match wall(spec) {
            Ok(wall) => walls.push(wall),
            Err((key, message)) => {
                faults.push(
                    &format!("wall[{k}]{key}"),
                    format!("wall `{}`: {message}", spec.name),
                    None,
                );
            }
        }
    }
    walls
}

/// Refuses motions that a wall cannot make before any stage has run.
fn check_stage_motions(scenario: &Scenario, faults: &mut Diagnostics) {
    let mut told = std::collections::BTreeSet::new();
    for (stage, path) in scenario.stages.iter().zip(&scenario.stage_paths) {
        for (wall, motion) in &stage.motions {
            let Err(error) = Wall::check_motion(motion) else {
                continue;
            };
            let name = scenario.walls.get(*wall).map_or("", |w| w.name.as_str());
            // repeats of a stage have one table
            if told.insert((path, name)) {
                faults.push(
                    &format!("{path}.motion.{name}"),
                    format!("wall `{name}`: {error}"),
                    None,
                );
            }
        }
    }
}

/// Builds a wall, or tells the key at fault and why.
fn wall(spec: &WallSpec) -> Result<Wall, (&'static str, String)> {
    let shape = match &spec.shape {
        WallShape::Given(shape) => shape.clone(),
        WallShape::File(file) => {
            let triangles =
                read_stl(&file.path, file.scale, file.shift).map_err(|error| (".file", error.to_string()))?;
            Shape::Mesh { triangles }
        }
    };
    if let (Shape::Mesh { triangles }, true) = (&shape, spec.closed) {
        let mesh = Mesh::new(triangles).map_err(|error| ("", error.to_string()))?;
        mesh.require_closed().map_err(|error| (".closed", error.to_string()))?;
    }
    Wall::new(&spec.name, spec.material, shape, spec.motion.clone()).map_err(|error| ("", error.to_string()))
}

/// Refuses grains that cannot fit into memory before any is made.
fn check_memory(scenario: &Scenario, faults: &mut Diagnostics) {
    let expected: f64 = scenario.grains.iter().map(expected_count).sum();
    let Some(available) = available_memory() else { return };
    let needed = expected * BYTES_PER_GRAIN;
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
fn available_memory() -> Option<f64> {
    let text = std::fs::read_to_string("/proc/meminfo").ok()?;
    let line = text.lines().find_map(|l| l.strip_prefix("MemAvailable:"))?;
    let kibibytes: f64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    Some(1024.0 * kibibytes)
}

fn grains(scenario: &Scenario, faults: &mut Diagnostics) -> Grains {
    let mut grains = Grains::default();
    let mut occupied: Vec<(DVec3, f64)> = Vec::new();
    let periodic = periodic_domain(scenario);
    let mut next_id = 1u32;
    let mut taken = std::collections::BTreeSet::new();
    for (k, insertion) in scenario.grains.iter().enumerate() {
        let path = format!("grains[{k}]");
        let inserted = match insert(insertion, &scenario.materials, &occupied, periodic.as_ref()) {
            Ok(inserted) => inserted,
            Err(error) => {
                faults.push(&path, error.to_string(), None);
                continue;
            }
        };
        for (n, grain) in inserted.grains.iter().enumerate() {
            let id = inserted.ids.as_ref().map_or(next_id, |ids| ids[n]);
            if !taken.insert(id) {
                faults.push(
                    &path,
                    format!("grain id {id} of `{}` is taken by an earlier batch", insertion.name),
                    Some("put the batch with ids of its own first, or renumber the file".to_string()),
                );
                return grains;
            }
            next_id = next_id.max(id.saturating_add(1));
            grains.push(id, grain);
            occupied.push((grain.position, grain.radius));
        }
    }
    grains
}

/// The domain as far as it is periodic, before the grains are known.
fn periodic_domain(scenario: &Scenario) -> Option<Domain> {
    let (lower, upper) = scenario.domain.bounds?;
    let (periodic, outside) = (scenario.domain.periodic, scenario.domain.outside);
    Some(Domain {
        lower,
        upper,
        periodic,
        outside,
    })
}

/// The domain; when the scenario tells none, the bounds of the finite walls and the grains enlarged by half of their
/// size, and open space when every wall is infinite.
fn domain(scenario: &Scenario, grains: &Grains, walls: &[Wall], faults: &mut Diagnostics) -> Domain {
    if let Some(domain) = periodic_domain(scenario) {
        let outside = (0..grains.len())
            .filter(|&g| !domain.contains(grains.position[g]))
            .count();
        if outside > 0 {
            let first = (0..grains.len())
                .find(|&g| !domain.contains(grains.position[g]))
                .unwrap_or(0);
            faults.push(
                "domain",
                format!(
                    "{outside} grains start outside the domain, the first is grain {} at {}",
                    grains.id[first], grains.position[first]
                ),
                Some("widen the domain or move the grains".to_string()),
            );
        }
        return domain;
    }
    let bounds: Vec<(DVec3, DVec3)> = walls.iter().filter_map(Wall::bounds).collect();
    let (mut lower, mut upper) = (DVec3::NEG_INFINITY, DVec3::INFINITY);
    if !bounds.is_empty() {
        let places = grains
            .position
            .iter()
            .zip(&grains.radius)
            .map(|(&p, &r)| (p - r, p + r));
        let all = || bounds.iter().copied().chain(places.clone());
        lower = all().fold(DVec3::INFINITY, |low, (l, _)| low.min(l));
        upper = all().fold(DVec3::NEG_INFINITY, |high, (_, u)| high.max(u));
        let margin = DVec3::splat(0.5 * (upper - lower).max_element());
        (lower, upper) = (lower - margin, upper + margin);
    }
    Domain {
        lower,
        upper,
        periodic: [false; 3],
        outside: scenario.domain.outside,
    }
}

/// In a periodic direction a grain must not meet two images of one partner.
fn check_periodic_size(grains: &Grains, domain: &Domain, skin: f64, faults: &mut Diagnostics) {
    let largest = grains.radius.iter().copied().fold(0.0, f64::max);
    let least = 4.0 * largest + 2.0 * skin;
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

fn check_overlaps(
    scenario: &Scenario,
    grains: &Grains,
    walls: &[Wall],
    domain: &Domain,
    faults: &mut Diagnostics,
    warnings: &mut Vec<String>,
) {
    let allowed = scenario.simulation.max_overlap;
    let places: Vec<(DVec3, f64)> = grains
        .position
        .iter()
        .copied()
        .zip(grains.radius.iter().copied())
        .collect();
    let advice =
        || Some("move them apart, or raise `simulation.max_overlap` if the packing is meant to be loaded".into());
    if let Some(pair) = first_overlap(&places, Some(domain)) {
        let (i, j) = (pair.first, pair.second);
        let share = pair.relative;
        let words = format!(
            "grains {} at {} and {} at {} overlap at the start by {share:.3} of the smaller radius",
            grains.id[i], grains.position[i], grains.id[j], grains.position[j]
        );
        if share > allowed {
            faults.push("grains", format!("{words}; {allowed} is allowed"), advice());
        } else if share > 1e-9 {
            warnings.push(format!("{words}: they start loaded"));
        }
    }
    if let Some((g, wall, share)) = deepest_in_wall(grains, walls) {
        let words = format!(
            "grain {} at {} overlaps wall `{}` at the start by {share:.3} of its radius",
            grains.id[g], grains.position[g], walls[wall].name
        );
        if share > allowed {
            faults.push("grains", format!("{words}; {allowed} is allowed"), advice());
        } else if share > 1e-9 {
            warnings.push(format!("{words}: it starts loaded"));
        }
    }
}

/// The deepest overlap of a grain with a wall: grain, wall, share of the radius.
fn deepest_in_wall(grains: &Grains, walls: &[Wall]) -> Option<(usize, usize, f64)> {
    let mut deepest: Option<(usize, usize, f64)> = None;
    let mut touched: Vec<SurfaceContact> = Vec::new();
    for g in 0..grains.len() {
        for (w, wall) in walls.iter().enumerate() {
            touched.clear();
            if wall.near(grains.position[g], grains.radius[g]) {
                wall.contacts(grains.position[g], grains.radius[g], &mut touched);
            }
            for contact in &touched {
                let share = (grains.radius[g] - contact.distance) / grains.radius[g];
                if deepest.is_none_or(|(_, _, s)| share > s) {
                    deepest = Some((g, w, share));
                }
            }
        }
    }
    deepest
}

/// The time step and its reason in words.
fn time_step(
    scenario: &Scenario,
    scale: &TimeScale,
    faults: &mut Diagnostics,
    warnings: &mut Vec<String>,
) -> (f64, String) {
    let words = |dt: f64| {
        let share = scale.time / dt;
        format!(
            "{dt:.4e} s, 1/{share:.0} of the shortest time scale, {:.4e} s: {}",
            scale.time, scale.origin
        )
    };
    match scenario.simulation.time_step {
        TimeStep::Auto => {
            let dt = SAFE_SHARE * scale.time;
            (dt, format!("automatic: {}", words(dt)))
        }
        TimeStep::Fixed(dt) => {
            let (safe, largest) = (SAFE_SHARE * scale.time, UNSAFE_SHARE * scale.time);
            if dt > largest && !scenario.simulation.allow_unsafe_time_step {
                faults.push(
                    "simulation.time_step",
                    format!("the time step is unsafe: {}", words(dt)),
                    Some(format!(
                        "use \"auto\" ({safe:.3e} s), a value up to {largest:.3e} s, or say \
                         `allow_unsafe_time_step = true` if you want it"
                    )),
                );
            } else if dt > safe {
                warnings.push(format!(
                    "the time step is above the one that keeps restitution within 1e-4 ({safe:.3e} s): {}",
                    words(dt)
                ));
            }
            (dt, format!("given: {}", words(dt)))
        }
    }
}
