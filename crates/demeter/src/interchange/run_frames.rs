//! The grains of a frame of a run as a table.

use crate::grain_files::{Cell, Extra, GrainTable, TypeOfGrain, density_of};
use crate::particles::Domain;
use crate::results::{ResultsError, Run, TableFile, TableKind};
use crate::scenario::Scenario;
use glam::DVec3;

/// Reads the grains of the frame of a step, with their box where the scenario tells one that does not deform.
pub fn table_of_run(run: &Run, step: u64, domain: Option<&Domain>) -> Result<GrainTable, ResultsError> {
    let mut file = run.open_table(TableKind::Grains, step)?;
    table_of_grains(&mut file, domain)
}

/// The table of a file of grains.
pub(super) fn table_of_grains(file: &mut TableFile, domain: Option<&Domain>) -> Result<GrainTable, ResultsError> {
    let type_names = file.texts("material_names").to_vec();
    let radii = file.floats("radius", 1)?;
    let masses = file.floats("mass", 1)?;
    let material = |index: i32| match usize::try_from(index) {
        Ok(at) if at < type_names.len() => TypeOfGrain::Name(at as u32),
        // an index of less than 2^31
        _ => TypeOfGrain::Number(index.unsigned_abs() + 1),
    };
    let types = file.integers("material")?.into_iter().map(material).collect();
    let vectors = |values: Vec<f64>| values.as_chunks().0.iter().map(|v| DVec3::from_array(*v)).collect();
    let mut extras = Vec::new();
    let turned = file.floats("orientation", 4)?;
    for (k, axis) in ["x", "y", "z", "w"].into_iter().enumerate() {
        extras.push(extra(
            &format!("orientation_{axis}"),
            turned.iter().skip(k).step_by(4).copied(),
        ));
    }
    extras.push(extra(
        "coordination",
        file.counts("coordination")?.into_iter().map(f64::from),
    ));
    if file.names().any(|name| name == "tag") {
        extras.push(extra("tag", file.integers("tag")?.into_iter().map(f64::from)));
    }
    Ok(GrainTable {
        ids: Some(file.counts("id")?),
        types: Some(types),
        positions: file.points()?,
        diameters: radii.iter().map(|r| 2.0 * r).collect(),
        densities: Some(masses.iter().zip(&radii).map(|(m, r)| density_of(*m, *r)).collect()),
        velocities: Some(vectors(file.floats("velocity", 3)?)),
        angular_velocities: Some(vectors(file.floats("angular_velocity", 3)?)),
        forces: Some(vectors(file.floats("force", 3)?)),
        torques: Some(vectors(file.floats("torque", 3)?)),
        extras,
        cell: domain.map(cell),
        step: Some(file.step()),
        time: Some(file.time()),
        type_names,
    })
}

fn extra(name: &str, values: impl Iterator<Item = f64>) -> Extra {
    Extra {
        name: name.to_owned(),
        unit: String::new(),
        values: values.collect(),
    }
}

fn cell(domain: &Domain) -> Cell {
    Cell {
        lower: domain.lower,
        upper: domain.upper,
        tilt: [0.0; 3],
        periodic: domain.periodic,
    }
}

/// The domain that the scenario of a run tells, or why there is none.
pub(super) fn domain_of(run: &Run) -> Result<Domain, String> {
    let path = run.folder().scenario();
    let scenario = Scenario::read(&path, &[])
        .map_err(|_| "box: the scenario of the run cannot be read any more (files that it names?)".to_owned())?;
    let stages = scenario.stages.iter().any(|stage| stage.deformation.is_some());
    if scenario.domain.deform.is_some() || stages {
        return Err("box: it deforms with time, and is left out".to_owned());
    }
    let (lower, upper) = scenario
        .domain
        .bounds
        .ok_or_else(|| "box: the scenario tells no domain".to_owned())?;
    Ok(Domain {
        lower,
        upper,
        periodic: scenario.domain.periodic,
        outside: scenario.domain.outside,
    })
}
