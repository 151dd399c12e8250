//! A periodic box that deforms, as columns of the series.

use super::{ToldColumn, Value};
use crate::simulation::Simulation;

/// Columns of a box that deforms; their names begin with `box`.
pub const BOX_COLUMNS: &[ToldColumn] = &[
    ToldColumn::new("length x", "m", "length of the box"),
    ToldColumn::new("length y", "m", "see box length x"),
    ToldColumn::new("length z", "m", "see box length x"),
    ToldColumn::new(
        "strain xx",
        "",
        "true strain since the start of the run, negative where the box has shrunk",
    ),
    ToldColumn::new("strain yy", "", "see box strain xx"),
    ToldColumn::new("strain zz", "", "see box strain xx"),
    ToldColumn::new("shear strain", "", "shear since the start of the run"),
    ToldColumn::new("strain rate xx", "1/s", "rate of true strain in the latest step"),
    ToldColumn::new("strain rate yy", "1/s", "see box strain rate xx"),
    ToldColumn::new("strain rate zz", "1/s", "see box strain rate xx"),
    ToldColumn::new("shear rate", "1/s", "rate of shear in the latest step"),
    ToldColumn::new(
        "stress xx",
        "Pa",
        "stress of the whole box: of its contacts and of the motion beyond the affine flow and the drift of all grains; compression positive",
    ),
    ToldColumn::new("stress yy", "Pa", "see box stress xx"),
    ToldColumn::new("stress zz", "Pa", "see box stress xx"),
    ToldColumn::new("stress xy", "Pa", "see box stress xx"),
    ToldColumn::new("stress xz", "Pa", "see box stress xx"),
    ToldColumn::new("stress yz", "Pa", "see box stress xx"),
    ToldColumn::new(
        "kinetic pressure",
        "Pa",
        "mean of the normal stresses of the motion beyond the affine flow and the drift of all grains",
    ),
    ToldColumn::new(
        "solid fraction",
        "",
        "solid volume over the volume of the box, overlaps not subtracted",
    ),
    ToldColumn::new(
        "boundary work",
        "J",
        "work done on the grains by the deformation of the box since the start",
    ),
];

/// Titles of the columns of a box that deforms.
pub(crate) fn box_titles() -> impl Iterator<Item = String> {
    BOX_COLUMNS.iter().map(|column| column.title("box"))
}

/// Their values; `boundary_work` is what the ledger tells [J].
pub(crate) fn box_values(sim: &Simulation, boundary_work: f64) -> Vec<Value> {
    let state = sim.box_state().unwrap_or_default();
    let [kx, ky, kz, ..] = state.kinetic_stress;
    (state.lengths.to_array().into_iter())
        .chain(state.strain.to_array())
        .chain([state.shear_strain])
        .chain(state.strain_rate.to_array())
        .chain([state.shear_rate])
        .chain(state.stress)
        .chain([(kx + ky + kz) / 3.0, state.solid_fraction, boundary_work])
        .map(Value::Number)
        .collect()
}
