//! Measures, removals and tags that mean grains which the run does not have.

use super::measures::MeasureKind;
use super::{Diagnostics, Scenario};
use crate::measure::Selection;
use crate::particles::{Grains, Origins};
use crate::walls::Wall;
use std::collections::{BTreeMap, BTreeSet};

/// Smallest and largest diameter of the grains of every material [m].
type Diameters = BTreeMap<u16, (f64, f64)>;

/// Tells them, told the grains of the start, and with them the extremes of all feeds.
pub(super) fn check(
    scenario: &Scenario,
    (at_start, origins, grains): (&Grains, &Origins, &Grains),
    walls: &[Wall],
    (faults, warnings): (&mut Diagnostics, &mut Vec<String>),
) {
    let mut there = Diameters::new();
    for (g, &material) in grains.material.iter().enumerate() {
        let diameter = 2.0 * grains.radius(g);
        let (least, most) = there.entry(material).or_insert((diameter, diameter));
        (*least, *most) = (least.min(diameter), most.max(diameter));
    }
    let numbers: BTreeSet<u32> = at_start.id.iter().copied().collect();
    let labels = tags_given(scenario, &numbers, origins);
    let name = |material: u16| scenario.materials[usize::from(material)].name.as_str();
    let measures = scenario.measures.iter().enumerate().filter_map(|(index, measure)| {
        let selection = measure.kind.selection()?;
        Some((
            format!("measure[{index}]"),
            format!("measure `{}`", measure.name),
            selection,
        ))
    });
    let removals = scenario.removals.iter().enumerate();
    let removals = removals.map(|(index, removal)| {
        let what = format!("removal `{}`", removal.name);
        (format!("removal[{index}]"), what, &removal.selection)
    });
    let tags = scenario.tags.iter().enumerate();
    let tags = tags.map(|(index, tag)| (format!("tag[{index}]"), format!("tag[{index}]"), &tag.selection));
    for (path, what, selection) in measures.chain(removals).chain(tags) {
        if !there
            .iter()
            .any(|(&material, &sizes)| may_hold(selection, material, sizes))
        {
            let all: Vec<String> = there
                .iter()
                .map(|(&material, (least, most))| {
                    format!("`{}`, {least:.4e} to {most:.4e} m in diameter", name(material))
                })
                .collect();
            warnings.push(format!(
                "{what} means grains{}, and there are none, at the start or from a feed. Grains are of {}",
                meant(selection, name),
                all.join("; ")
            ));
        }
        // ids of the own of a file may begin at 0, no others do
        if selection.ids.first() == Some(&0) && !numbers.contains(&0) {
            let help = "ids count from 1, in the order of the batches".to_string();
            faults.push(&format!("{path}.ids"), "no grain has the id 0", Some(help));
        } else {
            warnings.extend(missing_ids(scenario, &what, selection, &numbers));
        }
        if let Some(tag) = selection.tag.filter(|tag| !labels.contains(tag)) {
            let labels: Vec<String> = labels.iter().map(ToString::to_string).collect();
            warnings.push(format!(
                "{what} means grains with the tag {tag}, which none has and no [[tag]] gives. Grains have the tags {}; 0 is that of grains \
                 that get none",
                labels.join(", ")
            ));
        }
    }
    for measure in &scenario.measures {
        let (MeasureKind::Mixing(_) | MeasureKind::NeighbourMixing(_)) = &measure.kind else {
            continue;
        };
        let holds_all = |selection: &Selection| {
            there
                .iter()
                .all(|(&material, &sizes)| holds_every(selection, material, sizes))
        };
        if measure.kind.selection().is_some_and(holds_all) {
            warnings.push(format!(
                "measure `{}` looks at how grains{} are mixed with all others, and there are no others, at the start or from a feed: its \
                 index is NaN",
                measure.name,
                measure.kind.selection().map_or_else(String::new, |kind| meant(kind, name))
            ));
        }
    }
    for measure in &scenario.measures {
        let MeasureKind::Collisions(collisions) = &measure.kind else {
            continue;
        };
        let is_of = |material: u16| there.contains_key(&material) || walls.iter().any(|wall| wall.material == material);
        if let Some(partner) = collisions.partner.filter(|&partner| !is_of(partner)) {
            warnings.push(format!(
                "measure `{}` counts collisions with `{}`, of which no grain and no wall is",
                measure.name,
                name(partner)
            ));
        }
    }
}

/// Ids of a selection that no grain ever has: those that come from feeds have ids that nobody chooses.
fn missing_ids(scenario: &Scenario, what: &str, selection: &Selection, there: &BTreeSet<u32>) -> Option<String> {
    let missing = selection.ids.iter().filter(|id| !there.contains(id));
    let (first, last) = (there.first()?, there.last()?);
    let count = missing.clone().count();
    let one = missing.min().filter(|_| scenario.feeds.is_empty())?;
    let which = match count {
        1 => format!("a grain with the id {one}, which none has"),
        _ => format!("grains with {count} ids that none has, as {one}"),
    };
    Some(format!(
        "{what} means {which}: the {} grains have ids from {first} to {last}",
        there.len()
    ))
}

/// Tags that grains have, with these numbers at the start, or get.
fn tags_given(scenario: &Scenario, at_start: &BTreeSet<u32>, origins: &Origins) -> BTreeSet<i32> {
    let there = at_start.iter().map(|&id| origins.tag(id));
    let of_feeds = scenario.feeds.iter().map(|feed| feed.tag);
    let later = scenario.tags.iter().map(|tag| tag.value);
    there.chain(of_feeds).chain(later).chain([0]).collect()
}

/// Whether a grain of a material may be meant, of some diameter within bounds [m].
fn may_hold(selection: &Selection, material: u16, (least, most): (f64, f64)) -> bool {
    selection.material.is_none_or(|only| only == material)
        && selection.finer_than.is_none_or(|limit| least < limit)
        && selection.coarser_than.is_none_or(|limit| most >= limit)
}

/// Whether every grain of a material is meant, of all diameters within bounds [m].
fn holds_every(selection: &Selection, material: u16, (least, most): (f64, f64)) -> bool {
    selection.material.is_none_or(|only| only == material)
        && selection.finer_than.is_none_or(|limit| most < limit)
        && selection.coarser_than.is_none_or(|limit| least >= limit)
        && selection.ids.is_empty()
        && selection.source.is_none()
        && selection.tag.is_none()
}

/// Material and sizes of a selection in words.
fn meant<'a>(selection: &Selection, name: impl Fn(u16) -> &'a str) -> String {
    let material = selection.material.map(|material| format!(" of `{}`", name(material)));
    let finer = selection.finer_than.map(|limit| format!(" finer than {limit:.4e} m"));
    let coarser = selection
        .coarser_than
        .map(|limit| format!(" coarser than {limit:.4e} m"));
    [material, finer, coarser].into_iter().flatten().collect()
}
