//! From a scenario to a simulation: everything that can be wrong before step 0 is told here.

use super::checks::{
    check_feed_speeds, check_memory, check_overlaps, check_periodic_size, check_stage_motions, check_start_speeds,
    check_wall_speeds, wall_partners, with_free_walls,
};
use super::estimates::Fed;
use super::laws_of_stages::{Bound, bind, materials};
use super::meshes::{self, MeshOrigin};
use super::traffic::sources;
use super::{Diagnostics, Scenario, TimeStep, WallSpec, estimates, in_vain, periodic_walls, stray_walls};
use crate::insertion::insert;
use crate::materials::Materials;
use crate::particles::{Domain, Grains, NewGrain, Origins, Outside};
use crate::simulation::{
    FastestImpact, Setup, Simulation, Skin, TimeScale, TimeStepError, Verdict, refusals, shortest_time_scale,
};
use crate::walls::Wall;
use glam::DVec3;
use std::borrow::Cow;

/// Grains whose memory is given back at once while tables take them: some megabytes.
const GIVEN_BACK_AT_ONCE: usize = 1 << 16;

/// Distance beyond touching at which bodies become candidates, as a share of the mean radius.
const SKIN_SHARE: f64 = 0.2;

/// A scenario made ready to run.
#[derive(Debug)]
pub struct Prepared {
    /// What the simulation is made of.
    pub setup: Setup,
    /// Materials with the laws of stages that tell others than the run begins with.
    pub later: Vec<Materials>,
    /// Which batch every grain is of.
    pub origins: Origins,
    /// Grains of the sizes and materials that feeds will let come, at their inlets.
    pub to_come: Grains,
    /// Shortest time scale of the laws in use.
    pub time_scale: TimeScale,
    /// The head-on impact that the softest contact bears; nothing where that cannot be told.
    pub fastest_impact: Option<FastestImpact>,
    /// The time step in words: its value, its share of the shortest time scale, and where that comes from.
    pub time_step_reason: String,
    /// What the user should know, though it is no fault.
    pub warnings: Vec<String>,
    /// Where the triangles of each wall come from and what was repaired; `None` for walls that are no meshes.
    pub meshes: Vec<Option<MeshOrigin>>,
    /// Steps of every stage when no condition ends it early.
    pub stage_steps: Vec<u64>,
    /// Steps of the whole protocol when no condition ends a stage early.
    pub steps: u64,
    /// What feeds let come.
    pub fed: Fed,
    /// Estimated memory, where no grain leaves [bytes].
    pub memory: u64,
    /// Estimated run time on one thread, with the writing of frames and rows [s].
    pub run_time: f64,
    /// Frames when no condition ends a stage early.
    pub frames: u64,
    /// Estimated size of the files of one frame [bytes].
    pub frame_bytes: u64,
    /// Rows of the series when no condition ends a stage early.
    pub rows: u64,
    /// Estimated size of one row [bytes].
    pub row_bytes: u64,
}

/// Makes a scenario ready to run, or tells everything that is wrong with it.
pub fn prepare(scenario: &Scenario) -> Result<Prepared, Diagnostics> {
    let mut faults = scenario.diagnostics();
    let mut warnings = Vec::new();
    super::plots::check(scenario, &mut faults);
    let laws = bind(scenario, &mut faults);
    let (walls, meshes) = walls(scenario, &mut faults);
    check_stage_motions(scenario, &mut faults);
    let first = laws.as_ref().and_then(|laws| laws.first());
    let are_coupled = first.is_some_and(|first| first.materials.are_coupled());
    check_memory(scenario, &walls, are_coupled, &mut faults);
    if !faults.is_empty() {
        return Err(faults);
    }
    let (grains, origins) = grains(scenario, &mut faults, &mut warnings);
    let to_come = to_come(scenario, &mut faults);
    let (Some(laws), true) = (laws, faults.is_empty()) else {
        return Err(faults);
    };
    let mut all = Cow::Borrowed(&grains);
    if !to_come.is_empty() {
        all.to_mut().append(&to_come);
    }
    let domain = domain(scenario, &all, &walls, &mut faults);
    check_feeds(scenario, &domain, &mut faults);
    super::deformation::check(scenario, &grains, None, &mut faults);
    meshes::check(scenario, &walls, &meshes, &grains, &all, &mut warnings);
    periodic_walls::check(&walls, &all, &domain, &mut warnings);
    super::deformation::check_tensions(scenario, &grains, &laws, &mut warnings);
    super::walls_in_one_place::check((&walls, are_coupled), &all, &domain, &mut warnings);
    super::field_measures::check_kernels(&scenario.measures, &domain, &mut warnings);
    super::region_measures::check_gates(&scenario.measures, &all, &domain, &mut warnings);
    super::region_measures::check_cells(&scenario.measures, &all, &mut warnings);
    super::selections::check(
        scenario,
        (&grains, &origins, &all),
        &walls,
        (&mut faults, &mut warnings),
    );
    super::doubtful_units::check(scenario, &mut warnings);
    super::stray_places::check(scenario, &mut warnings);
    super::stop_checks::check_leaving(scenario, &grains, &mut faults);
    warnings.extend(super::stop_checks::ended_at_once(scenario, &grains));
    check_overlaps(scenario, &grains, &walls, &domain, &mut faults, &mut warnings);
    super::solids::check(&grains, &walls, &mut warnings);
    if all.is_empty() {
        faults.push("grains", "there is no grain", Some("add a [[grains]] table".into()));
    }
    let skin = (scenario.simulation.skin).map_or_else(|| Skin::Tuned(SKIN_SHARE * mean_radius(&all)), Skin::Fixed);
    check_periodic_size(&all, &domain, skin.first(), &laws, scenario.deforms(), &mut faults);
    let Some(scale) = time_scale(scenario, &all, &walls, &laws, &mut faults) else {
        return Err(faults);
    };
    for laws in &laws {
        super::impact_speeds::check_stiffness(scenario, (&all, &walls), &laws.materials, &mut warnings);
    }
    let mut laws = laws.into_iter().map(|laws| laws.materials);
    let Some(materials) = laws.next() else {
        return Err(faults);
    };
    let (dt, reason) = time_step(scenario, &scale, &mut faults, &mut warnings);
    let fastest_impact = super::impact_speeds::check(scenario, (&all, &walls), &materials, &mut warnings);
    check_wall_speeds(scenario, &walls, &meshes, &all, dt, &mut faults);
    super::bodies::check(scenario, &walls, dt, &mut faults);
    super::bodies::check_parts(scenario, &walls, &mut warnings);
    if !scenario.deforms() {
        check_start_speeds(&grains, dt, &mut faults);
        check_feed_speeds(scenario, &to_come, dt, &mut faults);
    }
    stray_walls::check(scenario, &walls, (&all, &domain), dt, &mut warnings);
    super::deformation::check(scenario, &grains, Some(dt), &mut faults);
    if !faults.is_empty() {
        return Err(faults);
    }
    let longest = scenario.stages.iter().map(|s| super::run::longest(s, dt));
    let all_steps: f64 = longest.clone().sum();
    if all_steps >= u64::MAX as f64 {
        let message = format!(
            "the run takes {all_steps:.4e} steps, and at most {} are counted; the time step is {reason}",
            u64::MAX
        );
        let help = "make the stages shorter or the time step longer".to_string();
        faults.push("stage", message, Some(help));
        return Err(faults);
    }
    let stage_steps: Vec<u64> = longest.map(|steps| steps as u64).collect();
    let steps = stage_steps.iter().copied().fold(0, u64::saturating_add);
    let stages: Vec<f64> = stage_steps.iter().map(|&steps| steps as f64 * dt).collect();
    let lasting = (stages.as_slice(), steps as f64 * dt);
    warnings.extend(in_vain::check(scenario, (&walls, &domain), lasting, dt));
    let fed = estimates::fed(scenario, &stages);
    let most = grains.len() as f64 + fed.grains;
    let work = estimates::work(scenario, most, &walls, are_coupled, &stage_steps, dt);
    Ok(Prepared {
        fed,
        later: laws.collect(),
        memory: estimates::memory(most, &walls, are_coupled) as u64,
        run_time: work.time,
        frames: work.frames,
        frame_bytes: work.frame_bytes as u64,
        rows: work.rows,
        row_bytes: work.row_bytes as u64,
        origins,
        to_come,
        time_scale: scale,
        fastest_impact,
        time_step_reason: reason,
        warnings,
        meshes,
        stage_steps,
        steps,
        setup: Setup {
            grains,
            walls,
            materials,
            domain,
            gravity: scenario.simulation.gravity,
            integrator: scenario.simulation.integrator,
            coupling: scenario.simulation.coupling,
            dt,
            skin,
            max_overlap: scenario.simulation.max_overlap,
        },
    })
}

/// The shortest time scale of the laws of all stages between these bodies; nothing where something is wrong with these or was before.
pub(super) fn time_scale(
    scenario: &Scenario,
    grains: &Grains,
    walls: &[Wall],
    laws: &[Bound<'_>],
    faults: &mut Diagnostics,
) -> Option<TimeScale> {
    let partners = wall_partners(scenario, walls);
    for laws in laws {
        for (a, b, why) in refusals(grains, &partners, &laws.materials) {
            let path = laws.spec.path(a.into(), b.into());
            faults.push(&format!("{path}.normal"), why, None);
        }
    }
    let of_each = (laws.iter())
        .map(|laws| shortest_time_scale(grains, &partners, &laws.materials, scenario.simulation.max_overlap));
    let shortest = of_each.reduce(|one, other| Ok(one?.or_shorter(other?)));
    let scale = shortest.unwrap_or(Err(TimeStepError::NoGrains));
    match scale.and_then(|scale| with_free_walls(scale, scenario)) {
        Ok(scale) => faults.is_empty().then_some(scale),
        Err(error) => {
            if faults.is_empty() {
                faults.push("simulation.time_step", error.to_string(), None);
            }
            None
        }
    }
}

/// What a run needs to go on from a checkpoint in a stage: everything but the grains, the time step and the skin, which the
/// checkpoint holds.
pub(super) fn prepare_to_resume(scenario: &Scenario, stage: usize, domain: Domain) -> Result<Setup, Diagnostics> {
    let mut faults = scenario.diagnostics();
    let materials = materials(scenario, scenario.contact_in(stage), &mut faults);
    let (walls, _) = walls(scenario, &mut faults);
    let (Some(materials), true) = (materials, faults.is_empty()) else {
        return Err(faults);
    };
    Ok(Setup {
        grains: Grains::default(),
        walls,
        materials,
        domain,
        gravity: scenario.gravity_in(stage),
        integrator: scenario.simulation.integrator,
        coupling: scenario.simulation.coupling,
        dt: f64::NAN,
        skin: Skin::Fixed(f64::NAN),
        max_overlap: scenario.simulation.max_overlap,
    })
}

/// Refuses what a changed scenario tells and a run with these grains, of its own and to come, cannot do with its time step, as [`prepare`]
/// refuses it of a new one.
pub(super) fn check_to_go_on(
    scenario: &Scenario,
    laws: &[Bound<'_>],
    all: &Grains,
    sim: &Simulation,
    faults: &mut Diagnostics,
) {
    check_stage_motions(scenario, faults);
    let (walls, meshes) = walls(scenario, faults);
    let dt = sim.dt();
    check_wall_speeds(scenario, &walls, &meshes, all, dt, faults);
    super::bodies::check(scenario, &sim.walls, dt, faults);
    if !scenario.deforms() {
        check_periodic_size(all, sim.domain(), sim.skin(), laws, false, faults);
        check_feed_speeds(scenario, &to_come(scenario, faults), dt, faults);
    }
    super::deformation::check(scenario, sim.grains(), Some(dt), faults);
}

fn mean_radius(grains: &Grains) -> f64 {
    grains.radii().sum::<f64>() / grains.len().max(1) as f64
}

fn walls(scenario: &Scenario, faults: &mut Diagnostics) -> (Vec<Wall>, Vec<Option<MeshOrigin>>) {
    let (mut walls, mut origins) = (Vec::new(), Vec::new());
    for (k, spec) in scenario.walls.iter().enumerate() {
        match wall(spec) {
            Ok((mut wall, origin)) => {
                let absent = scenario.stages.first().and_then(|stage| stage.absent.as_ref());
                wall.record(scenario.walls[k].recording);
                wall.set_present(!absent.is_some_and(|absent| absent.contains(&k)));
                walls.push(wall);
                origins.push(origin);
            }
            Err((key, message)) => {
                faults.push(
                    &format!("wall[{k}]{key}"),
                    format!("wall `{}`: {message}", spec.name),
                    None,
                );
            }
        }
    }
    // numbers belong to the walls of the scenario where all of them were built
    if let (Some(domain), true) = (periodic_domain(scenario), walls.len() == scenario.walls.len()) {
        for (k, error) in periodic_walls::repeat(&mut walls, scenario, &domain) {
            let name = &scenario.walls[k].name;
            faults.push(
                &format!("wall[{k}]"),
                format!("wall `{name}`, repeated at periodic sides: {error}"),
                None,
            );
        }
    }
    (walls, origins)
}

/// Builds a wall, or tells the key at fault and why.
fn wall(spec: &WallSpec) -> Result<(Wall, Option<MeshOrigin>), (&'static str, String)> {
    let (made_of, origin) = meshes::made_of(spec)?;
    let wall = Wall::new(&spec.name, spec.material, made_of, spec.motion.clone());
    Ok((wall.map_err(|error| ("", error.to_string()))?, origin))
}

/// The grains of all batches, and which batch each is of.
fn grains(scenario: &Scenario, faults: &mut Diagnostics, warnings: &mut Vec<String>) -> (Grains, Origins) {
    let (mut grains, mut origins) = (Grains::default(), Origins::default());
    if scenario.simulation.orientations {
        grains.follow_orientations();
    }
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
        if let (Some(cell), Some(domain)) = (&inserted.cell, &periodic) {
            warnings.extend(super::box_of_file::check(&insertion.name, cell, domain));
        }
        let is_last = k + 1 == scenario.grains.len();
        // from the back, so that their memory is given back while the tables take it
        let mut coming = inserted.grains;
        coming.reverse();
        for n in 0.. {
            let Some(mut grain) = coming.pop() else { break };
            if let Some(domain) = &periodic {
                grain.position = domain.brought_back(grain.position);
            }
            if coming.len().is_multiple_of(GIVEN_BACK_AT_ONCE) {
                coming.shrink_to_fit();
            }
            let id = inserted.ids.as_ref().map_or(next_id, |ids| ids[n]);
            if !taken.insert(id) {
                faults.push(
                    &path,
                    format!("grain id {id} of `{}` is taken by an earlier batch", insertion.name),
                    Some("put the batch with ids of its own first, or renumber the file".to_string()),
                );
                return (grains, origins);
            }
            next_id = next_id.max(id.saturating_add(1));
            grains.push(id, &grain);
            origins.add(id, k as u16, 0);
            let of_file = || inserted.tags.as_ref().map(|tags| tags[n]);
            if let Some(tag) = insertion.tag.or_else(of_file) {
                origins.set_tag(id, tag);
            }
            if !is_last {
                occupied.push((grain.position, grain.radius));
            }
        }
    }
    (grains, origins)
}

/// Grains of the extreme sizes of every feed, at the ends of its inlet: they stand for those that will come.
pub(super) fn to_come(scenario: &Scenario, faults: &mut Diagnostics) -> Grains {
    let mut grains = Grains::default();
    let open = Domain {
        lower: DVec3::NEG_INFINITY,
        upper: DVec3::INFINITY,
        periodic: [false; 3],
        outside: Outside::Stop,
    };
    let sources = match sources(scenario, &periodic_domain(scenario).unwrap_or(open)) {
        Ok(sources) => sources,
        Err((feed, problem)) => {
            faults.push(&format!("feed[{feed}]"), problem.to_string(), None);
            return grains;
        }
    };
    for (feed, source) in scenario.feeds.iter().zip(sources) {
        let (lower, upper) = source.bounds();
        for (position, radius) in [lower, upper].into_iter().zip(source.radii()) {
            let grain = NewGrain {
                material: feed.stream.material,
                radius,
                density: scenario.materials[usize::from(feed.stream.material)].density,
                position,
                velocity: feed.stream.velocity,
                angular_velocity: DVec3::ZERO,
                fixed: false,
            };
            grains.push(u32::MAX, &grain);
        }
    }
    grains
}

/// Tells feeds that cannot serve in the domain.
fn check_feeds(scenario: &Scenario, domain: &Domain, faults: &mut Diagnostics) {
    if let Err((feed, problem)) = sources(scenario, domain) {
        faults.push(&format!("feed[{feed}]"), problem.to_string(), None);
    }
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
        let mut outside = (0..grains.len()).filter(|&g| !domain.contains(grains.position[g]));
        if let Some(first) = outside.next() {
            let (id, place) = (grains.id[first], grains.position[first]);
            let message = match outside.count() {
                0 => format!("grain {id} starts outside the domain, at {place}"),
                more => format!(
                    "{} grains start outside the domain, the first is grain {id} at {place}",
                    more + 1
                ),
            };
            faults.push(
                "domain",
                message,
                Some("widen the domain or move the grains".to_string()),
            );
        }
        return domain;
    }
    let bounds: Vec<(DVec3, DVec3)> = walls.iter().filter_map(Wall::bounds).collect();
    let (mut lower, mut upper) = (DVec3::NEG_INFINITY, DVec3::INFINITY);
    if !bounds.is_empty() {
        let places = grains.position.iter().zip(grains.radii()).map(|(&p, r)| (p - r, p + r));
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

/// The time step and its reason in words.
fn time_step(
    scenario: &Scenario,
    scale: &TimeScale,
    faults: &mut Diagnostics,
    warnings: &mut Vec<String>,
) -> (f64, String) {
    let integrator = scenario.simulation.integrator;
    let (safe, largest) = (scale.automatic(), scale.largest(integrator));
    let (dt, how) = match scenario.simulation.time_step {
        TimeStep::Auto => (safe, "automatic"),
        TimeStep::Longest => (largest, "longest that is accepted"),
        TimeStep::Share(share) => (share * scale.time, "given share"),
        TimeStep::Fixed(dt) => (dt, "given"),
    };
    match scale.judge(dt, integrator) {
        Verdict::Unsafe if !scenario.simulation.allow_unsafe_time_step => faults.push(
            "simulation.time_step",
            format!("the time step is unsafe: {}", scale.beside(dt)),
            Some(format!(
                "use \"auto\" ({safe:.3e} s), at most \"longest\" ({largest:.3e} s), or say \
                 `allow_unsafe_time_step = true` if you want it"
            )),
        ),
        Verdict::Unsafe | Verdict::Long => warnings.push(format!("the time step is {}", scale.cost(dt, integrator))),
        Verdict::Safe => {}
    }
    (dt, format!("{how}: {}", scale.beside(dt)))
}
