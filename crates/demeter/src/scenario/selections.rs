//! Measures, removals and tags that mean grains which the run does not have.

use super::Scenario;
use super::measures::MeasureKind;
use crate::measure::Selection;
use crate::particles::Grains;
use crate::walls::Wall;
use std::collections::BTreeMap;

/// Smallest and largest diameter of the grains of every material [m].
type Diameters = BTreeMap<u16, (f64, f64)>;

/// Tells them; `grains` are those of the start and the extremes of all feeds.
pub(super) fn check(scenario: &Scenario, grains: &Grains, walls: &[Wall], warnings: &mut Vec<String>) {
    let mut there = Diameters::new();
    for (g, &material) in grains.material.iter().enumerate() {
        let diameter = 2.0 * grains.radius(g);
        let (least, most) = there.entry(material).or_insert((diameter, diameter));
        (*least, *most) = (least.min(diameter), most.max(diameter));
    }
    let name = |material: u16| scenario.materials[usize::from(material)].name.as_str();
    let measures = scenario.measures.iter().filter_map(|measure| {
        let selection = measure.kind.selection()?;
        Some((format!("measure `{}`", measure.name), selection))
    });
    let removals = scenario.removals.iter();
    let removals = removals.map(|removal| (format!("removal `{}`", removal.name), &removal.selection));
    let tags = scenario.tags.iter().enumerate();
    let tags = tags.map(|(index, tag)| (format!("tag[{index}]"), &tag.selection));
    for (what, selection) in measures.chain(removals).chain(tags) {
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

/// Whether a grain of a material may be meant, of some diameter within bounds [m].
fn may_hold(selection: &Selection, material: u16, (least, most): (f64, f64)) -> bool {
    selection.material.is_none_or(|only| only == material)
        && selection.finer_than.is_none_or(|limit| least < limit)
        && selection.coarser_than.is_none_or(|limit| most >= limit)
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
