//! Data files of LAMMPS and LIGGGHTS.

use super::super::format::Format;
use super::super::table::{Cell, GrainTable};
use super::{WriteError, cell_of};
use glam::DVec3;
use std::io::{self, Write};

pub(super) fn write(out: &mut impl Write, table: &GrainTable, format: Format) -> Result<(), WriteError> {
    let Some(densities) = &table.densities else {
        return Err(WriteError::NoDensities { format });
    };
    let (cell, types) = (cell_of(table, format), table.type_numbers());
    let (program, comment) = match format {
        Format::LiggghtsData => ("LIGGGHTS", ""),
        _ => ("LAMMPS", " # sphere"),
    };
    let step = table
        .step
        .map_or_else(String::new, |step| format!(", timestep = {step}"));
    writeln!(
        out,
        "{program} data file of Demeter {}{step}, units = si\n",
        crate::VERSION
    )?;
    writeln!(out, "{} atoms", table.len())?;
    writeln!(out, "{} atom types\n", table.number_of_types())?;
    write_box(out, &cell)?;
    writeln!(out, "\nAtoms{comment}\n")?;
    for (k, position) in table.positions.iter().enumerate() {
        let DVec3 { x, y, z } = position;
        let (id, kind, diameter, density) = (table.id(k), types[k], table.diameters[k], densities[k]);
        writeln!(out, "{id} {kind} {diameter:?} {density:?} {x:?} {y:?} {z:?}")?;
    }
    if table.velocities.is_none() && table.angular_velocities.is_none() {
        return Ok(());
    }
    writeln!(out, "\nVelocities\n")?;
    for k in 0..table.len() {
        let of = |values: &Option<Vec<DVec3>>| values.as_ref().map_or(DVec3::ZERO, |values| values[k]);
        let (v, w) = (of(&table.velocities), of(&table.angular_velocities));
        let id = table.id(k);
        writeln!(out, "{id} {:?} {:?} {:?} {:?} {:?} {:?}", v.x, v.y, v.z, w.x, w.y, w.z)?;
    }
    Ok(())
}

fn write_box(out: &mut impl Write, cell: &Cell) -> io::Result<()> {
    if cell.is_general() {
        let (corner, edges) = cell.right_handed();
        for (name, v) in ["avec", "bvec", "cvec", "abc origin"]
            .iter()
            .zip(edges.into_iter().chain([corner]))
        {
            writeln!(out, "{:?} {:?} {:?} {name}", v.x, v.y, v.z)?;
        }
        return Ok(());
    }
    for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
        writeln!(out, "{:?} {:?} {name}lo {name}hi", cell.lower[axis], cell.upper[axis])?;
    }
    if cell.is_tilted() {
        let [xy, xz, yz] = cell.tilt;
        writeln!(out, "{xy:?} {xz:?} {yz:?} xy xz yz")?;
    }
    Ok(())
}
