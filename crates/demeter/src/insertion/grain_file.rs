//! Grains of a file with the settings of the insertion.

use super::spec::{Insertion, Source};
use super::{Inserted, InsertionProblem};
use crate::grain_files::{
    FileError, FileProblem, GrainTable, LARGEST, Location, ReadOptions, TypeOfGrain, diameter, not_allowed,
    read_grain_file, shown,
};
use crate::materials::Material;
use crate::particles::NewGrain;
use glam::DVec3;

/// Grains of a file with the settings of the insertion. The scale acts on every length, and so on velocities too.
pub(super) fn insert_file(insertion: &Insertion, materials: &[Material]) -> Result<Inserted, InsertionProblem> {
    let Source::File {
        path,
        keep_velocities,
        density,
        scale,
        shift,
        reading,
        which,
    } = &insertion.source
    else {
        return Ok(Inserted::default());
    };
    check_settings(*density, *scale, *shift)?;
    let reading = ReadOptions {
        scaled: *scale != 1.0,
        types_told: !insertion.types.is_empty(),
        ..reading.clone()
    };
    let table = read_grain_file(path, &reading, *which)?;
    let located = |problem| FileError {
        path: path.clone(),
        location: Location::default(),
        problem: Box::new(problem),
    };
    let kinds = materials_of(&table, insertion, materials).map_err(located)?;
    let mut grains = Vec::with_capacity(table.positions.len());
    for (k, &material) in kinds.iter().enumerate() {
        let moving = |values: &Option<Vec<DVec3>>| match values {
            Some(values) if *keep_velocities => values[k],
            _ => DVec3::ZERO,
        };
        let own_density = table.densities.as_ref().map(|values| values[k]);
        let diameter_value = table.diameters[k] * scale;
        diameter(
            diameter_value,
            &format!("{diameter_value:e} m (grain {}, scaled)", k + 1),
        )
        .map_err(located)?;
        let position = table.positions[k] * *scale + *shift;
        if position.abs().max_element() > LARGEST {
            let text = format!("position of grain {} after scale and shift", k + 1);
            return Err(located(not_allowed(&text, "coordinates must be within 1e12 m")).into());
        }
        grains.push(NewGrain {
            fixed: false,
            material,
            radius: 0.5 * diameter_value,
            density: (density.or(own_density)).unwrap_or(materials[usize::from(material)].density),
            position,
            velocity: moving(&table.velocities) * *scale,
            angular_velocity: moving(&table.angular_velocities),
        });
    }
    Ok(Inserted {
        grains,
        tags: table.tags(),
        cell: table.cell.map(|cell| cell.placed(*scale, *shift)),
        ids: table.ids,
    })
}

fn check_settings(density: Option<f64>, scale: f64, shift: DVec3) -> Result<(), InsertionProblem> {
    let setting = |what, value, allowed| Err(InsertionProblem::FileSetting { what, value, allowed });
    if let Some(value) = density
        && !(1e-12..=LARGEST).contains(&value)
    {
        return setting("the density", value, "allowed are 1e-12 to 1e12 kg/m^3");
    }
    if !(1e-12..=LARGEST).contains(&scale) {
        return setting("the scale", scale, "allowed are factors from 1e-12 to 1e12");
    }
    let outside = |value: &f64| !(0.0..=LARGEST).contains(&value.abs());
    match shift.to_array().into_iter().find(outside) {
        Some(value) => setting("a component of the shift", value, "it must be a number within 1e12 m"),
        None => Ok(()),
    }
}

/// Material of every grain. Names are those of materials; numbers are types of the insertion, and when it has no types those of
/// materials that have such a name, or nothing.
fn materials_of(table: &GrainTable, insertion: &Insertion, materials: &[Material]) -> Result<Vec<u16>, FileProblem> {
    let place_of = |name: &String| materials.iter().position(|m| m.name == *name);
    let named: Vec<Option<usize>> = table.type_names.iter().map(place_of).collect();
    let Some(types) = &table.types else {
        return Ok(vec![insertion.material; table.positions.len()]);
    };
    if !insertion.types.is_empty() && types.iter().all(|kind| matches!(kind, TypeOfGrain::Name(_))) {
        return Err(FileProblem::NoEffect {
            option: "types",
            why: "the file names its materials",
        });
    }
    let material_of = |(k, kind): (usize, &TypeOfGrain)| match *kind {
        TypeOfGrain::Name(index) => (named[index as usize].map(|place| place as u16)).ok_or_else(|| {
            let known: Vec<&str> = materials.iter().map(|m| m.name.as_str()).collect();
            FileProblem::UnknownMaterial {
                name: shown(&table.type_names[index as usize]),
                known: known.join(", "),
            }
        }),
        TypeOfGrain::Number(found) if insertion.types.is_empty() => {
            let number = found.to_string();
            let named = materials.iter().position(|m| m.name == number);
            Ok(named.map_or(insertion.material, |place| place as u16))
        }
        TypeOfGrain::Number(found) => {
            (insertion.types.get(found as usize - 1).copied()).ok_or(FileProblem::TypeWithoutMaterial {
                number: k + 1,
                found,
                known: insertion.types.len(),
            })
        }
    };
    types.iter().enumerate().map(material_of).collect()
}

#[cfg(test)]
#[path = "grain_file_tests.rs"]
mod tests;
