//! What is in a scenario.

use super::Info;
use crate::answer::Rows;
use crate::failure::Failure;
use crate::readable::{number, things};
use demeter::insertion::{Amount, Insertion, Source};
use demeter::materials::PairChoice;
use demeter::scenario::{Scenario, WallShape, WallSpec};
use demeter::walls::Shape;
use demeter_physics::parameters::Value;
use serde_json::json;
use std::path::Path;

/// Most stages that are told one by one.
const MOST_STAGES: usize = 20;

/// Tells what a scenario says; whether it can run is for `demeter check`.
pub fn scenario(path: &Path) -> Result<Info, Failure> {
    let scenario = Scenario::read(path, &[])?;
    let mut rows = Rows::default();
    rows.add("title", scenario.title.as_str());
    rows.add("seed", scenario.seed.to_string());
    for m in &scenario.materials {
        let (modulus, density) = (number(m.young_modulus), number(m.density));
        let text = format!(
            "E = {modulus} Pa, nu = {}, density {density} kg/m^3",
            number(m.poisson_ratio)
        );
        rows.add(format!("material {}", m.name), text);
    }
    rows.add("contact", laws(&scenario.contact.default));
    for (a, b, choice) in &scenario.contact.pairs {
        let name = |index: u16| {
            scenario
                .materials
                .get(usize::from(index))
                .map_or("", |m| m.name.as_str())
        };
        rows.add(format!("pair {}-{}", name(*a), name(*b)), laws(choice));
    }
    for batch in &scenario.grains {
        rows.add(format!("grains {}", batch.name), source(batch));
    }
    for wall in &scenario.walls {
        rows.add(format!("wall {}", wall.name), shape(wall));
    }
    for stage in scenario.stages.iter().take(MOST_STAGES) {
        let moved = things(stage.motions.len() as u64, "motion");
        let ends = things(stage.stop.len() as u64, "end condition");
        let laws = (stage.contact.and_then(|told| scenario.stage_contacts.get(told)))
            .map_or_else(String::new, |contact| format!(", contact {}", laws(&contact.default)));
        rows.add(
            format!("stage {}", stage.name),
            format!("{ends}, {moved} of walls set{laws}"),
        );
    }
    if let Some(more) = scenario.stages.len().checked_sub(MOST_STAGES).filter(|more| *more > 0) {
        rows.add("stages", format!("and {more} more"));
    }
    let names = |list: Vec<&String>| list.into_iter().cloned().collect::<Vec<String>>();
    let value = json!({
        "title": scenario.title,
        "seed": scenario.seed,
        "materials": names(scenario.materials.iter().map(|m| &m.name).collect()),
        "contact": scenario.contact.default,
        "grains": names(scenario.grains.iter().map(|g| &g.name).collect()),
        "walls": names(scenario.walls.iter().map(|w| &w.name).collect()),
        "stages": names(scenario.stages.iter().map(|s| &s.name).collect()),
    });
    Ok(Info {
        kind: "scenario",
        rows,
        value,
    })
}

fn laws(choice: &PairChoice) -> String {
    let chosen = [
        Some(&choice.normal),
        choice.tangential.as_ref(),
        choice.rolling.as_ref(),
    ];
    let words = chosen.into_iter().flatten().map(|law| {
        let values = law.parameters.iter().map(|(name, value)| match value {
            Value::Number(x) => format!("{name} {}", number(*x)),
            Value::Text(word) => format!("{name} {word}"),
            Value::Table(rows) => format!("{name} of {} rows", rows.len()),
        });
        let values: Vec<String> = values.collect();
        match values.is_empty() {
            true => law.law.clone(),
            false => format!("{} ({})", law.law, values.join(", ")),
        }
    });
    words.collect::<Vec<String>>().join(", ")
}

fn source(batch: &Insertion) -> String {
    match &batch.source {
        Source::File { path, .. } => format!("from `{}`", path.display()),
        Source::Lattice { spacing, .. } => format!("on a lattice of spacing {} m", number(*spacing)),
        Source::Random { amount, .. } => match amount {
            Amount::Count(count) => format!("{count} at random places"),
            Amount::VolumeFraction(share) => format!("at random places, volume fraction {}", number(*share)),
        },
        Source::List { positions, .. } => format!("{} told one by one", positions.len()),
    }
}

fn shape(wall: &WallSpec) -> String {
    match &wall.shape {
        WallShape::File(file) => format!("mesh from `{}`", file.path.display()),
        WallShape::Given(shape) => match shape {
            Shape::Plane { .. } => "plane",
            Shape::Box { .. } => "box",
            Shape::Cylinder { .. } => "cylinder",
            Shape::Cone { .. } => "cone",
            Shape::Sphere { .. } => "sphere",
            Shape::Rectangle { .. } => "rectangle",
            Shape::Disc { .. } => "disc",
            Shape::Mesh { .. } => "mesh",
        }
        .to_string(),
    }
}
