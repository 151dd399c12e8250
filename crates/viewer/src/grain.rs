//! One grain: its values and contacts at a step, and its way over the moments.

use crate::cache::{Cache, lock};
use crate::watch::modified;
use bytes::Bytes;
use demeter::output::vtp::{Array, Values};
use demeter::results::{Moment, ResultsError, Run, TableFile, TableKind};
use demeter_physics::DVec3;
use serde_json::{Value, json};
use std::sync::Mutex;
use std::time::{Duration, Instant};

/// How long moments are told about in one answer; one is told in any case. Whoever asks comes back for the others.
const QUICK: Duration = Duration::from_millis(200);

/// Finds the rows of grains. Columns of ids that were read are kept, so that the next grain is found sooner.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Finder<'a> {
    pub run: &'a Run,
    pub ids: &'a Mutex<Cache>,
}

impl Finder<'_> {
    /// The rows of a table in which a column of ids holds an id.
    fn rows(
        &self,
        (kind, step): (TableKind, u64),
        name: &'static str,
        id: u32,
        table: &mut TableFile,
    ) -> Result<Vec<usize>, ResultsError> {
        let key = (name, step, modified(self.run, self.run.table_path(kind, step)));
        let kept = lock(self.ids).get(&key);
        let column = match kept {
            Some(column) => column,
            None => {
                let ids = table.counts(name)?;
                let column: Bytes = ids.iter().flat_map(|id| id.to_le_bytes()).collect();
                lock(self.ids).put(key, column.clone());
                column
            }
        };
        let wanted = id.to_le_bytes();
        let rows = column.as_chunks().0.iter().enumerate();
        Ok(rows.filter(|(_, id)| **id == wanted).map(|(row, _)| row).collect())
    }

    /// The grains of a step, and the row of one; nothing when it is not there.
    fn grain(&self, step: u64, id: u32) -> Result<Option<(TableFile, usize)>, ResultsError> {
        let mut grains = self.run.open_table(TableKind::Grains, step)?;
        let row = self
            .rows((TableKind::Grains, step), "id", id, &mut grains)?
            .first()
            .copied();
        Ok(row.map(|row| (grains, row)))
    }

    /// The contacts of a step, and the rows of those of a grain.
    fn contacts(&self, step: u64, id: u32) -> Result<(TableFile, Vec<usize>), ResultsError> {
        let mut contacts = self.run.open_table(TableKind::Contacts, step)?;
        let mut rows = self.rows((TableKind::Contacts, step), "id_i", id, &mut contacts)?;
        // the second id is of no grain where the contact is with a wall
        let second = self.rows((TableKind::Contacts, step), "id_j", id, &mut contacts)?;
        let walls = contacts.rows_at("wall", &second)?;
        let is_of_grains = |k| walls.values.number(k).is_some_and(|wall| wall < 0.0);
        rows.extend(
            second
                .iter()
                .enumerate()
                .filter(|(k, _)| is_of_grains(*k))
                .map(|(_, row)| *row),
        );
        rows.sort_unstable();
        rows.dedup();
        Ok((contacts, rows))
    }
}

/// A grain with its contacts at a step; nothing when it is not there.
pub(crate) fn grain(finder: &Finder, step: u64, id: u32) -> Result<Option<Value>, ResultsError> {
    let Some((mut grains, row)) = finder.grain(step, id)? else {
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
    let contacts = contacts(finder, step, id)?;
    Ok(Some(
        json!({ "id": id, "step": step, "time": grains.time(), "values": values, "contacts": contacts }),
    ))
}

/// The contacts as the grain `id` feels them: normals away from its partners, forces on it.
fn contacts(finder: &Finder, step: u64, id: u32) -> Result<Vec<Value>, ResultsError> {
    let (mut table, rows) = finder.contacts(step, id)?;
    let mut column = |name: &str| table.rows_at(name, &rows);
    let [id_i, id_j, wall, element, overlap] = [
        column("id_i")?,
        column("id_j")?,
        column("wall")?,
        column("element")?,
        column("overlap")?,
    ];
    let [normal, normal_force, tangential_force] =
        [column("normal")?, column("normal_force")?, column("tangential_force")?];
    let contact = |k: usize| {
        let vector = |array: &Array| {
            let at = |c| array.values.number(3 * k + c).unwrap_or(f64::NAN);
            DVec3::new(at(0), at(1), at(2))
        };
        let first = id_i.values.number(k) == Some(f64::from(id));
        let sign = if first { 1.0 } else { -1.0 };
        json!({
            "partner": entry(if first { &id_j } else { &id_i }, k),
            "wall": entry(&wall, k),
            "element": entry(&element, k),
            "overlap": entry(&overlap, k),
            "normal": (sign * vector(&normal)).to_array(),
            // repulsion is positive
            "normal_force": vector(&normal).dot(vector(&normal_force)),
            "tangential_force": vector(&tangential_force).length(),
        })
    };
    Ok((0..id_i.values.len()).map(contact).collect())
}

/// The grain at the first of these moments, as many as are told quickly: position, speed, forces, coordination; null where it
/// is not there.
pub(crate) fn history(finder: &Finder, moments: &[Moment], id: u32) -> Value {
    let begun = Instant::now();
    let mut told = Vec::new();
    for moment in moments {
        if !told.is_empty() && begun.elapsed() > QUICK {
            break;
        }
        let values = at_moment(finder, moment.step, id);
        // a frame that is damaged, or was just removed, leaves a gap
        told.push(values.ok().flatten().unwrap_or(Value::Null));
    }
    Value::Array(told)
}

fn at_moment(finder: &Finder, step: u64, id: u32) -> Result<Option<Value>, ResultsError> {
    let Some((mut grains, row)) = finder.grain(step, id)? else {
        return Ok(None);
    };
    let mut length = |name: &str| -> Result<f64, ResultsError> {
        let array = grains.rows_of(name, row..row + 1)?;
        let square = (0..array.values.len())
            .filter_map(|k| array.values.number(k))
            .map(|x| x * x);
        Ok(square.sum::<f64>().sqrt())
    };
    let (speed, force) = (length("velocity")?, length("force")?);
    let mut value = |name: &str| Ok::<_, ResultsError>(numbers(&grains.rows_of(name, row..row + 1)?));
    let (coordination, contact_force) = (value("coordination")?, value("contact_force")?);
    let position = point(&mut grains, row)?;
    Ok(Some(json!({
        "position": position, "speed": speed, "force": force, "coordination": coordination, "contact_force": contact_force,
    })))
}

fn point(grains: &mut TableFile, row: usize) -> Result<Value, ResultsError> {
    Ok(numbers(&grains.points_of(row..row + 1)?))
}

/// One number, or a list of those of a row.
fn numbers(array: &Array) -> Value {
    match array.values.len() {
        1 => entry(array, 0),
        several => (0..several).map(|k| entry(array, k)).collect(),
    }
}

/// A number by its place; null where it is not finite, which JSON does not know.
fn entry(array: &Array, k: usize) -> Value {
    match &array.values {
        Values::Float64(values) => json!(values.get(k)),
        Values::Int32(values) => json!(values.get(k)),
        Values::UInt32(values) => json!(values.get(k)),
        Values::Int64(values) => json!(values.get(k)),
    }
}
