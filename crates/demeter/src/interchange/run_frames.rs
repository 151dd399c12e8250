//! The grains of a frame of a run as a table.

use crate::grain_files::{Cell, Extra, GrainTable, TypeOfGrain, density_of};
use crate::output::vtp::Values;
use crate::output::{BOX, BOX_PERIODIC};
use crate::results::{ResultsError, Run, TableFile, TableKind};
use crate::scenario::Scenario;
use glam::DVec3;

/// Reads the grains of the frame of a step, with the box of that moment; where there is none, says why.
pub fn table_of_run(run: &Run, step: u64) -> Result<(GrainTable, Option<String>), ResultsError> {
    let mut file = run.open_table(TableKind::Grains, step)?;
    let cell = match file.field(BOX) {
        Some(_) => cell_of_frame(&file),
        None => cell_of_scenario(run),
    };
    let note = cell.as_ref().err().map(|why| format!("box: {why}"));
    Ok((table_of_grains(&mut file, cell.ok())?, note))
}

/// The table of a file of grains.
fn table_of_grains(file: &mut TableFile, cell: Option<Cell>) -> Result<GrainTable, ResultsError> {
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
    if file.names().any(|name| name == "orientation") {
        let turned = file.floats("orientation", 4)?;
        for (k, axis) in ["x", "y", "z", "w"].into_iter().enumerate() {
            extras.push(extra(
                &format!("orientation_{axis}"),
                turned.iter().skip(k).step_by(4).copied(),
            ));
        }
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
        cell,
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

/// The box that a frame tells, or why it cannot be had.
fn cell_of_frame(file: &TableFile) -> Result<Cell, &'static str> {
    let damaged = "the frame tells one that is no box; it is left out";
    let (Some(rows), Some(sides)) = (file.field(BOX), file.field(BOX_PERIODIC)) else {
        return Err(damaged);
    };
    let (Values::Float64(rows), Values::Int32(sides)) = (&rows.values, &sides.values) else {
        return Err(damaged);
    };
    let ([corner, edges @ ..], [x, y, z]) = (rows.as_chunks::<3>().0, sides.as_slice()) else {
        return Err(damaged);
    };
    let edges: [DVec3; 3] = match edges {
        [a, b, c] => [a, b, c].map(|edge| DVec3::from_array(*edge)),
        _ => return Err(damaged),
    };
    let corner = DVec3::from_array(*corner);
    if !(corner.is_finite() && edges.iter().all(|edge| edge.is_finite())) {
        return Err(damaged);
    }
    let cell = Cell::of_edges(edges, corner).ok_or(damaged)?;
    let periodic = [*x != 0, *y != 0, *z != 0];
    Ok(Cell { periodic, ..cell })
}

/// The box that the scenario of a run tells, for frames that tell none; or why there is none.
fn cell_of_scenario(run: &Run) -> Result<Cell, &'static str> {
    let scenario = Scenario::read_to_go_on(&run.folder().scenario())
        .map_err(|_| "the scenario of the run cannot be read any more (files that it names?)")?;
    if scenario.domain.deform.is_some() || scenario.stages.iter().any(|stage| stage.deformation.is_some()) {
        return Err("it deforms with time, and the frames of this run do not tell it; it is left out");
    }
    let (lower, upper) = scenario.domain.bounds.ok_or("the scenario tells no domain")?;
    Ok(Cell {
        lower,
        upper,
        tilt: [0.0; 3],
        rise: [0.0; 3],
        periodic: scenario.domain.periodic,
    })
}
