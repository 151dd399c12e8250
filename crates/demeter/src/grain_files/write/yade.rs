//! YADE's text packings, as `yade.ymport.text` reads them.

use super::super::table::GrainTable;
use super::WriteError;
use glam::DVec3;
use std::io::Write;

pub(super) fn write(out: &mut impl Write, table: &GrainTable) -> Result<(), WriteError> {
    let types = table.type_numbers();
    let several = types.iter().any(|kind| *kind != types[0]);
    writeln!(out, "#format {}", if several { "x_y_z_r_matId" } else { "x_y_z_r" })?;
    writeln!(out, "# of Demeter {}, in m", crate::VERSION)?;
    for (k, position) in table.positions.iter().enumerate() {
        let DVec3 { x, y, z } = position;
        write!(out, "{x:?}\t{y:?}\t{z:?}\t{:?}", 0.5 * table.diameters[k])?;
        match several {
            true => writeln!(out, "\t{}", types[k].saturating_sub(1))?,
            false => writeln!(out)?,
        }
    }
    Ok(())
}
