//! A frame as the page draws it.

use crate::pack::Pack;
use demeter::output::MEAN_NORMAL_FORCE;
use demeter::results::{PackedWall, Packing, ResultsError, Run, TableKind};
use serde_json::{Value, json};
use std::hash::{DefaultHasher, Hash, Hasher};

/// Grains of a step, and how many contacts push them how much.
pub(crate) fn frame(run: &Run, step: u64) -> Result<Vec<u8>, ResultsError> {
    let packing = Packing::read_grains(run, step)?;
    let mut pack = Pack::default();
    pack.tell("step", json!(packing.step));
    pack.tell("time", json!(packing.time));
    pack.tell("walls", json!(key_of_walls(&packing.walls)));
    let contacts = run.open_table(TableKind::Contacts, step)?;
    let mean = contacts.field(MEAN_NORMAL_FORCE).and_then(|mean| mean.values.number(0));
    pack.tell("contacts", json!({ "count": contacts.rows(), "mean_force": mean }));
    let g = &packing.grains;
    pack.u32s("id", g.id.iter().copied());
    pack.f32s("position", g.position.iter().flat_map(|p| p.to_array()));
    pack.f32s("radius", g.radius.iter().copied());
    let mut told = Vec::new();
    for scalar in packing.scalars() {
        told.push(json!({
            "name": scalar.name, "unit": scalar.unit, "meaning": scalar.meaning, "names": scalar.names, "label": scalar.is_label,
        }));
        pack.f32s(scalar.name, scalar.values);
    }
    pack.tell("scalars", Value::Array(told));
    Ok(pack.encode())
}

/// Contacts of a step, from where to where their forces go.
pub(crate) fn contacts(run: &Run, step: u64) -> Result<Vec<u8>, ResultsError> {
    let packing = Packing::read(run, step)?;
    let mut pack = Pack::default();
    pack.f32s("normal_force", packing.contacts.normal.iter().copied());
    pack.f32s("ends", packing.ends().iter().flatten().flat_map(|end| end.to_array()));
    Ok(pack.encode())
}

/// Triangles of the walls at a step: for each wall its name, index, and where its triangles begin and end.
pub(crate) fn walls(run: &Run, step: u64) -> Result<Vec<u8>, ResultsError> {
    let walls = Packing::walls_at(run, step)?;
    let mut pack = Pack::default();
    pack.tell("walls", json!(key_of_walls(&walls)));
    let mut list = Vec::new();
    let mut start = 0;
    for wall in &walls {
        let end = start + wall.triangles.len();
        list.push(json!({ "name": wall.name, "index": wall.index, "start": start, "end": end }));
        start = end;
    }
    pack.tell("list", Value::Array(list));
    let corners = walls.iter().flat_map(|wall| wall.triangles.iter().flatten());
    pack.f32s("triangles", corners.flat_map(|p| p.to_array()));
    Ok(pack.encode())
}

/// By this the page knows walls that it has already.
fn key_of_walls(walls: &[PackedWall]) -> String {
    let mut hasher = DefaultHasher::new();
    for wall in walls {
        (&wall.name, wall.index, wall.triangles.len()).hash(&mut hasher);
        for number in wall.triangles.iter().flatten().flat_map(|p| p.to_array()) {
            // what is drawn has 32 bits
            (number as f32).to_bits().hash(&mut hasher);
        }
    }
    format!("{:016x}", hasher.finish())
}
