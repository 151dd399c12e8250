//! What a scenario tells and nothing comes of: no fault, but the user should know before the run.

use super::checks::told_motions;
use super::feeds::{FeedRate, FeedSpec, RemovalSpec};
use super::measures::MeasureKind;
use super::traffic::sources;
use super::walls::WallShape;
use super::{Scenario, estimates, words};
use crate::insertion::{SizeSampler, Streaming};
use crate::measure::Displacement;
use crate::particles::{Domain, Zone};
use crate::simulation::{Stage, StopCondition};
use crate::walls::{Motion, Motions, Shape, Wall};
use glam::DVec3;
use std::collections::BTreeSet;
use std::f64::consts::PI;

/// Places of an inlet that are tried.
pub(super) const PLACES: u64 = 200;

/// Tells all of it, told how long each stage and all of them last at most, and the time step [s].
pub(super) fn check(
    scenario: &Scenario,
    (walls, domain): (&[Wall], &Domain),
    (stages, end): (&[f64], f64),
    dt: f64,
) -> Vec<String> {
    let mut told: Vec<String> = (scenario.stages.iter())
        .filter_map(|stage| shorter_than_a_step(stage, dt))
        .collect();
    told.extend(intervals_below_a_step(scenario, dt));
    for (index, tag) in scenario.tags.iter().enumerate().filter(|(_, tag)| tag.at > end) {
        told.push(format!(
            "tag[{index}] is given from {} s on, and the stages end at {end:.4e} s at the latest: no grain gets it",
            tag.at
        ));
    }
    for measure in &scenario.measures {
        if let MeasureKind::Displacement(Displacement { from, .. }) = measure.kind
            && from > end
        {
            told.push(format!(
                "measure `{}` counts displacements from {from} s on, and the stages end at {end:.4e} s at the latest: it counts none",
                measure.name
            ));
        }
    }
    for feed in 0..scenario.feeds.len() {
        match empty_feed(scenario, feed, stages, end) {
            Some(text) => told.push(text),
            None => told.extend(unreached_ends(scenario, feed, stages, (end, dt))),
        }
    }
    let sources = sources(scenario, domain).unwrap_or_default();
    told.extend(blocked(scenario, &sources, walls));
    told.extend(removed_at_once(scenario, &sources, domain));
    for (index, removal) in scenario.removals.iter().enumerate() {
        if !is_ever(scenario, index, |stage| stage.removals.as_deref()) {
            told.push(format!(
                "removal `{}` acts in no stage: no grain goes by it. Name it in the `removals` of a stage",
                removal.name
            ));
        } else if let Some(every) = removal.every.filter(|every| *every > end) {
            told.push(format!(
                "removal `{}` takes grains every {every:.4e} s, and the stages end at {end:.4e} s at the latest: it takes those \
                 that lie there at the start, and none later",
                removal.name
            ));
        }
    }
    told.extend((0..scenario.walls.len()).filter_map(|wall| unmoved(scenario, wall)));
    told.extend((0..scenario.walls.len()).filter_map(|wall| never_there(scenario, wall)));
    told.extend(belts_across(scenario));
    told.extend(moved_while_absent(scenario));
    told
}

/// Whether a time is shorter than a step by more than rounding.
fn is_below_a_step(seconds: f64, dt: f64) -> bool {
    seconds < 0.999 * dt
}

/// Intervals of measures, feeds and removals that are shorter than a step.
fn intervals_below_a_step(scenario: &Scenario, dt: f64) -> Vec<String> {
    let sampled = scenario.measures.iter().filter_map(|measure| match &measure.kind {
        MeasureKind::Field(field) => Some((
            format!("`sample_every` of measure `{}`", measure.name),
            field.sample_every?,
        )),
        _ => None,
    });
    let fed =
        (scenario.feeds.iter()).filter_map(|feed| Some((format!("`every` of feed `{}`", feed.name), feed.every?)));
    let removed = (scenario.removals.iter())
        .filter_map(|removal| Some((format!("`every` of removal `{}`", removal.name), removal.every?)));
    let all = sampled.chain(fed).chain(removed);
    all.filter(|(_, seconds)| is_below_a_step(*seconds, dt))
        .map(|(what, seconds)| {
            format!(
                "{what} is {seconds:.4e} s, less than a time step of {dt:.4e} s: it is done in every step. Is its unit right?"
            )
        })
        .collect()
}

/// A stage that is to last for less than a step.
fn shorter_than_a_step(stage: &Stage, dt: f64) -> Option<String> {
    let duration = |condition: &StopCondition| match condition {
        StopCondition::Duration(seconds) if is_below_a_step(*seconds, dt) => Some(*seconds),
        _ => None,
    };
    let seconds = stage.stop.iter().find_map(duration)?;
    Some(format!(
        "stage `{}` is to last {seconds:.4e} s, less than a time step of {dt:.4e} s: it takes one step; a smaller `simulation.time_step` \
         ends it in time",
        stage.name
    ))
}

/// Whether a feed or removal runs in any stage, told the list of a stage of what runs from its start on.
fn is_ever(scenario: &Scenario, index: usize, list: impl Fn(&Stage) -> Option<&[usize]>) -> bool {
    let mut runs = true;
    scenario.stages.iter().any(|stage| {
        runs = list(stage).map_or(runs, |running| running.contains(&index));
        runs
    })
}

/// A feed that lets no grain come, or only some at the start.
fn empty_feed(scenario: &Scenario, index: usize, stages: &[f64], end: f64) -> Option<String> {
    let feed = &scenario.feeds[index];
    if !is_ever(scenario, index, |stage| stage.feeds.as_deref()) {
        return Some(format!(
            "feed `{}` runs in no stage: no grain comes. Name it in the `feeds` of a stage",
            feed.name
        ));
    }
    let expected = estimates::expected_of_feed(scenario, index, stages);
    if expected < 0.5 {
        return Some(format!(
            "feed `{}` lets {expected:.2} grains come by its rate, its ends and the time that it runs: mostly none",
            feed.name
        ));
    }
    let every = feed.every.filter(|every| *every > end)?;
    let outcome = match feed.rate {
        FeedRate::AsRoomAllows => "some come at the start, and none later",
        FeedRate::Mass(_) | FeedRate::Number(_) => "none comes",
    };
    Some(format!(
        "feed `{}` lets grains come every {every:.4e} s, and the stages end at {end:.4e} s at the latest: {outcome}",
        feed.name
    ))
}

/// Ends of a feed that it does not come to: behind the end of all stages, or more than its rate lets come in the time that it runs. One of
/// `count` and `mass` that bounds the other, or a `level`, may be all that is to be reached.
fn unreached_ends(scenario: &Scenario, index: usize, stages: &[f64], (end, dt): (f64, f64)) -> Vec<String> {
    let feed = &scenario.feeds[index];
    let (name, ends) = (&feed.name, &feed.end);
    let has_rate = feed.rate != FeedRate::AsRoomAllows;
    let has_other_end = ends.count.is_some() || ends.mass.is_some() || ends.level.is_some();
    let mut told = Vec::new();
    // a feed without a rate has to tell an end, also where none is meant
    if let Some(until) = ends.until.filter(|until| *until > end + dt)
        && (has_rate || has_other_end)
    {
        told.push(format!(
            "feed `{name}` does not end by its `until` of {until} s: the stages end at {end:.4e} s at the latest"
        ));
    }
    let (Ok(sizes), Some(material)) = (
        SizeSampler::new(&feed.stream.diameter),
        scenario.materials.get(usize::from(feed.stream.material)),
    ) else {
        return told;
    };
    let of_one = |diameter: f64| material.density * PI / 6.0 * diameter * diameter * diameter;
    let (smallest, largest) = sizes.bounds();
    let seconds = estimates::time_of_feed(scenario, index, stages);
    // the time is a whole number of steps, which may lack a part of the last grain
    let (grains, mass) = match feed.rate {
        FeedRate::Number(rate) => {
            let grains = (rate * seconds + 0.5).floor();
            (grains, grains * of_one(largest))
        }
        FeedRate::Mass(rate) => ((rate * seconds / of_one(smallest) + 0.5).floor(), rate * seconds),
        FeedRate::AsRoomAllows => return told,
    };
    let count = ends.count.map(|count| {
        let missed =
            format!("`count`: in the {seconds:.4e} s that it runs at most, its rate lets {grains} of {count} grains");
        (grains < count as f64).then_some(missed)
    });
    let mass = ends.mass.map(|most| {
        let [came, of] = [mass, most].map(words::mass);
        let missed = format!("`mass`: in the {seconds:.4e} s that it runs at most, its rate lets {came} of {of}");
        (mass + 0.5 * of_one(largest) < most).then_some(missed)
    });
    let missed: Option<Vec<String>> = [count, mass].into_iter().flatten().collect();
    if ends.level.is_none() {
        told.extend(missed.into_iter().flatten().map(|missed| {
            format!("feed `{name}` does not end by its {missed} come. Raise the rate, or let the feed run longer")
        }));
    }
    told
}

/// Feeds hardly any of whose grains finds room, as walls that rest throughout the run are in the way.
fn blocked(scenario: &Scenario, sources: &[Streaming], walls: &[Wall]) -> Vec<String> {
    let moves = |index: usize| told_motions(scenario).any(|(wall, motions)| wall == index && !motions.is_rest());
    let may_go = |index: usize| {
        let mut absent = scenario.stages.iter().filter_map(|stage| stage.absent.as_ref());
        absent.any(|absent| absent.contains(&index))
    };
    let stay: Vec<&Wall> = (walls.iter().enumerate())
        .filter(|(index, wall)| wall.is_present() && !moves(*index) && !may_go(*index))
        .map(|(_, wall)| wall)
        .collect();
    let mut told = Vec::new();
    for (feed, source) in scenario.feeds.iter().zip(sources) {
        let smallest = source.radii()[0];
        let places = source.places(smallest, PLACES);
        let in_the_way = |place: &DVec3| stay.iter().find(|wall| wall.nearest(*place, smallest).is_some());
        let walls: Option<Vec<_>> = places.iter().map(in_the_way).collect();
        if let Some(first) = walls.as_ref().and_then(|walls| walls.first()) {
            told.push(format!(
                "feed `{}` lets no grain come, or hardly any: walls, as `{}`, are in the way at all {} places of its inlet that were tried",
                feed.name,
                first.name,
                places.len()
            ));
        }
    }
    told
}

/// Feeds whose grains come in where a removal takes them.
fn removed_at_once(scenario: &Scenario, sources: &[Streaming], domain: &Domain) -> Vec<String> {
    let mut told = Vec::new();
    for ((feed, spec), source) in scenario.feeds.iter().enumerate().zip(sources) {
        let places = source.places(source.radii()[0], PLACES);
        for (removal, taking) in scenario.removals.iter().enumerate() {
            let batches = scenario.grains.len();
            if !places.is_empty()
                && takes_all(taking, spec, batches + feed)
                && places.iter().all(|place| lies_in(&taking.zone, domain, *place))
                && acts_whenever(scenario, feed, removal)
            {
                told.push(format!(
                    "all grains of feed `{}` come in where removal `{}` takes them: they go when it looks next. Is its `region` right?",
                    spec.name, taking.name
                ));
            }
        }
    }
    told
}

/// Whether a removal means all grains of a feed, told the number of this source, whatever their sizes and ids are.
fn takes_all(removal: &RemovalSpec, feed: &FeedSpec, source: usize) -> bool {
    let selection = &removal.selection;
    selection
        .material
        .is_none_or(|material| material == feed.stream.material)
        && selection.source.is_none_or(|only| usize::from(only) == source)
        && selection.tag.is_none_or(|tag| tag == feed.tag)
        && selection.ids.is_empty()
        && selection.finer_than.is_none()
        && selection.coarser_than.is_none()
}

/// Whether a place lies in a zone for good: not in one that a wall carries.
fn lies_in(zone: &Zone, domain: &Domain, place: DVec3) -> bool {
    zone.parts.iter().all(|part| part.wall.is_none()) && zone.holds(domain, place, |_, place| place)
}

/// Whether a removal acts in every stage in which a feed runs.
fn acts_whenever(scenario: &Scenario, feed: usize, removal: usize) -> bool {
    let (mut runs, mut acts) = (true, true);
    scenario.stages.iter().all(|stage| {
        runs = stage.feeds.as_ref().map_or(runs, |running| running.contains(&feed));
        acts = stage.removals.as_ref().map_or(acts, |acting| acting.contains(&removal));
        acts || !runs
    })
}

/// A wall that is to swing by nothing.
fn unmoved(scenario: &Scenario, wall: usize) -> Option<String> {
    let is_still = |motion: &Motion| match motion {
        Motion::Oscillation { amplitude, .. } => *amplitude == DVec3::ZERO,
        Motion::Rocking { amplitude, .. } => *amplitude == 0.0,
        _ => false,
    };
    let swings_by_nothing = |motions: &Motions| motions.parts.iter().any(|part| is_still(&part.motion));
    let mut motions = told_motions(scenario).filter(|(of, _)| *of == wall);
    motions.any(|(_, motions)| swings_by_nothing(motions)).then(|| {
        format!(
            "wall `{}` swings with an amplitude of 0, which moves nothing",
            scenario.walls[wall].name
        )
    })
}

/// Whether any wall moves with another.
fn leads(scenario: &Scenario, wall: usize) -> bool {
    told_motions(scenario).any(|(_, motions)| motions.leader() == Some(wall))
}

/// A wall that is absent all the time, unless others go with it.
fn never_there(scenario: &Scenario, wall: usize) -> Option<String> {
    let mut absent = false;
    let is_absent = |stage: &Stage| {
        absent = stage.absent.as_ref().map_or(absent, |walls| walls.contains(&wall));
        absent
    };
    let always = !scenario.stages.is_empty() && scenario.stages.iter().all(is_absent);
    (always && !leads(scenario, wall)).then(|| {
        format!(
            "wall `{}` is absent in every stage: no grain feels it",
            scenario.walls[wall].name
        )
    })
}

/// Belts of flat walls that point along the normal alone.
fn belts_across(scenario: &Scenario) -> BTreeSet<String> {
    let mut told = BTreeSet::new();
    for (index, motions) in told_motions(scenario) {
        let wall = &scenario.walls[index];
        let normal = match &wall.shape {
            WallShape::Given(Shape::Plane { normal, .. } | Shape::Disc { normal, .. }) => *normal,
            WallShape::Given(Shape::Rectangle { half_u, half_v, .. }) => half_u.cross(*half_v).normalize_or_zero(),
            _ => continue,
        };
        for part in &motions.parts {
            let Motion::Belt(velocity) = part.motion else { continue };
            if velocity != DVec3::ZERO && velocity.cross(normal).length() < 1e-9 * velocity.length() {
                told.insert(format!(
                    "the `belt` of wall `{}` points along its normal: what points into a surface moves nothing along it",
                    wall.name
                ));
            }
        }
    }
    told
}

/// Motions that stages tell walls that are absent and do not come back, unless others go with them.
fn moved_while_absent(scenario: &Scenario) -> Vec<String> {
    let mut absent: &[usize] = &[];
    let mut told = Vec::new();
    for (number, stage) in scenario.stages.iter().enumerate() {
        absent = stage.absent.as_deref().unwrap_or(absent);
        let comes_back = |wall: usize| {
            let later = scenario.stages[number + 1..].iter();
            later
                .filter_map(|stage| stage.absent.as_ref())
                .any(|absent| !absent.contains(&wall))
        };
        for &(wall, ref motions) in &stage.motions {
            if absent.contains(&wall)
                && !motions.is_rest()
                && !comes_back(wall)
                && !leads(scenario, wall)
                && never_there(scenario, wall).is_none()
            {
                told.push(format!(
                    "stage `{}` moves wall `{}`, which is absent from then on: no grain feels it",
                    stage.name, scenario.walls[wall].name
                ));
            }
        }
    }
    told
}
