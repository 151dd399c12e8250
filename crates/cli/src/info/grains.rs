//! What is in a file of grains.

use super::Info;
use crate::answer::Rows;
use crate::failure::Failure;
use crate::readable::{count, number, vector};
use demeter::grain_files::{GrainTable, ReadOptions, Which, read_grain_file};
use demeter_physics::DVec3;
use serde_json::json;
use std::path::Path;

/// Tells what is in a file of grains.
pub fn grains(path: &Path) -> Result<Info, Failure> {
    let table = read_grain_file(path, &ReadOptions::default(), Which::Last)
        .map_err(|error| Failure::wrong(error.to_string()))?;
    let number_of_grains = table.positions.len();
    let smallest = table.diameters.iter().copied().fold(f64::INFINITY, f64::min);
    let largest = table.diameters.iter().copied().fold(0.0, f64::max);
    let mean = table.diameters.iter().sum::<f64>() / table.diameters.len().max(1) as f64;
    let grains = || table.positions.iter().zip(&table.diameters);
    let lower = grains().fold(DVec3::INFINITY, |low, (p, d)| low.min(*p - 0.5 * *d));
    let upper = grains().fold(DVec3::NEG_INFINITY, |high, (p, d)| high.max(*p + 0.5 * *d));
    let columns = columns(&table);
    let mut rows = Rows::default();
    rows.add("grains", count(number_of_grains as u64));
    rows.add(
        "diameters",
        format!(
            "{} m to {} m, mean {} m",
            number(smallest),
            number(largest),
            number(mean)
        ),
    );
    rows.add(
        "lower corner",
        format!("{} m, surfaces counted", vector(lower.to_array())),
    );
    rows.add("upper corner", format!("{} m", vector(upper.to_array())));
    if let Some(cell) = table.cell {
        let (lower, upper) = (vector(cell.lower.to_array()), vector(cell.upper.to_array()));
        let tilt = match cell.is_tilted() {
            true => format!(", tilted by xy, xz, yz = {} m", vector(cell.tilt)),
            false => String::new(),
        };
        rows.add("box of the file", format!("{lower} m to {upper} m{tilt}"));
    }
    rows.add("columns", columns.join(", "));
    if !table.type_names.is_empty() {
        rows.add("materials", table.type_names.join(", "));
    }
    let value = json!({
        "grains": number_of_grains,
        "diameter": { "minimum": smallest, "mean": mean, "maximum": largest },
        "lower": lower.to_array(),
        "upper": upper.to_array(),
        "columns": columns,
        "materials": table.type_names,
        "box": table.cell.map(|cell| [cell.lower.to_array(), cell.upper.to_array()]),
        "tilt": table.cell.map(|cell| cell.tilt),
    });
    Ok(Info {
        kind: "grains",
        rows,
        value,
    })
}

fn columns(table: &GrainTable) -> Vec<&'static str> {
    let optional = [
        ("ids", table.ids.is_some()),
        ("types", table.types.is_some()),
        ("positions", true),
        ("diameters", true),
        ("densities", table.densities.is_some()),
        ("velocities", table.velocities.is_some()),
        ("angular velocities", table.angular_velocities.is_some()),
    ];
    optional
        .into_iter()
        .filter(|(_, there)| *there)
        .map(|(name, _)| name)
        .collect()
}
