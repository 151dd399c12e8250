//! One grain: its values and contacts at a step, and its way over the moments.

use demeter::output::vtp::{Array, Values};
use demeter::results::{Moment, ResultsError, Run, TableFile, TableKind};
use demeter_physics::DVec3;
use serde_json::{Value, json};

/// A grain with its contacts at a step; nothing when it is not there.
pub(crate) fn grain(run: &Run, step: u64, id: u32) -> Result<Option<Value>, ResultsError> {
    let mut grains = run.open_table(TableKind::Grains, step)?;
    let Some(row) = find(&mut grains, id)? else {
        return Ok(None);
    };
    let mut values = serde_json::Map::new();
    values.insert("position".into(), point(&mut grains, row)?);
    let names: Vec<String> = grains.names().map(str::to_owned).collect();
    for name in names {
        let array = grains.rows_of(&name, row..row + 1)?;
        values.insert(name, numbers(&array));
    }
    let materials = grains.texts(demeter::output::MATERIAL_NAMES).to_vec();
    if let Some(name) = values
        .get("material")
        .and_then(Value::as_u64)
        .and_then(|k| materials.get(k as usize))
    {
        values.insert("material".into(), json!(name));
    }
    let mut contacts = run.open_table(TableKind::Contacts, step)?;
    let told: Result<Vec<Value>, ResultsError> = contacts_of(&mut contacts, id)?
        .into_iter()
        .map(|row| contact(&mut contacts, row, id))
        .collect();
    Ok(Some(
        json!({ "id": id, "step": step, "time": grains.time(), "values": values, "contacts": told? }),
    ))
}

/// A contact as the grain `id` feels it: normal away from its partner, forces on it.
fn contact(table: &mut TableFile, row: usize, id: u32) -> Result<Value, ResultsError> {
    let mut vector = |name: &str| -> Result<DVec3, ResultsError> {
        let array = table.rows_of(name, row..row + 1)?;
        let at = |k| array.values.number(k).unwrap_or(f64::NAN);
        Ok(DVec3::new(at(0), at(1), at(2)))
    };
    let (normal, normal_force, tangential_force) =
        (vector("normal")?, vector("normal_force")?, vector("tangential_force")?);
    let mut scalar = |name: &str| -> Result<Value, ResultsError> { Ok(numbers(&table.rows_of(name, row..row + 1)?)) };
    let (id_i, id_j, wall) = (scalar("id_i")?, scalar("id_j")?, scalar("wall")?);
    let (overlap, element) = (scalar("overlap")?, scalar("element")?);
    let first = id_i == json!(id);
    let sign = if first { 1.0 } else { -1.0 };
    Ok(json!({
        "partner": if first { id_j } else { id_i },
        "wall": wall,
        "element": element,
        "overlap": overlap,
        "normal": (sign * normal).to_array(),
        // repulsion is positive
        "normal_force": number(normal.dot(normal_force)),
        "tangential_force": number(tangential_force.length()),
    }))
}

/// The grain at moments: time, position, speed, contact force, force, coordination; null where it is not there.
pub(crate) fn history(run: &Run, moments: &[Moment], id: u32) -> Value {
    let told = moments.iter().map(|moment| {
        // a frame that is damaged, or was just removed, leaves a gap
        let values = at_moment(run, moment.step, id).ok().flatten();
        values.unwrap_or(Value::Null)
    });
    Value::Array(told.collect())
}

fn at_moment(run: &Run, step: u64, id: u32) -> Result<Option<Value>, ResultsError> {
    let mut grains = run.open_table(TableKind::Grains, step)?;
    let Some(row) = find(&mut grains, id)? else {
        return Ok(None);
    };
    let mut length = |name: &str| -> Result<Value, ResultsError> {
        let array = grains.rows_of(name, row..row + 1)?;
        let square = (0..array.values.len())
            .filter_map(|k| array.values.number(k))
            .map(|x| x * x);
        Ok(number(square.sum::<f64>().sqrt()))
    };
    let (speed, force) = (length("velocity")?, length("force")?);
    let coordination = numbers(&grains.rows_of("coordination", row..row + 1)?);
    let position = point(&mut grains, row)?;
    let mut contacts = run.open_table(TableKind::Contacts, step)?;
    let mut sum = 0.0;
    for row in contacts_of(&mut contacts, id)? {
        let magnitude = contacts.rows_of("normal_force_magnitude", row..row + 1)?;
        sum += magnitude.values.number(0).unwrap_or(f64::NAN);
    }
    Ok(Some(json!({
        "position": position, "speed": speed, "force": force, "contact_force": number(sum), "coordination": coordination,
    })))
}

/// The row of a grain.
fn find(grains: &mut TableFile, id: u32) -> Result<Option<usize>, ResultsError> {
    Ok(grains.counts("id")?.iter().position(|other| *other == id))
}

/// The rows of the contacts of a grain.
fn contacts_of(contacts: &mut TableFile, id: u32) -> Result<Vec<usize>, ResultsError> {
    let (first, second, walls) = (
        contacts.counts("id_i")?,
        contacts.counts("id_j")?,
        contacts.integers("wall")?,
    );
    let touches = |row: &usize| first[*row] == id || (second[*row] == id && walls[*row] < 0);
    Ok((0..first.len()).filter(touches).collect())
}

fn point(grains: &mut TableFile, row: usize) -> Result<Value, ResultsError> {
    Ok(numbers(&grains.points_of(row..row + 1)?))
}

/// One number, or a list of those of a row.
fn numbers(array: &Array) -> Value {
    let one = |k: usize| match &array.values {
        Values::Float64(values) => number(values[k]),
        Values::Int32(values) => json!(values[k]),
        Values::UInt32(values) => json!(values[k]),
        Values::Int64(values) => json!(values[k]),
    };
    match array.values.len() {
        1 => one(0),
        several => (0..several).map(one).collect(),
    }
}

/// A number; null where it is not finite, which JSON does not know.
fn number(value: f64) -> Value {
    json!(value)
}
