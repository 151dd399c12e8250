//! The last state: what is drawn of it, and what grains and contacts are like.

use super::arrays::{f32s, u32s};
use crate::results::{ResultsError, Run, TableKind};
use glam::DVec3;
use serde_json::{Value, json};
use std::f64::consts::PI;

/// Most grains that are drawn.
pub(super) const MOST_GRAINS: usize = 100_000;
/// Most contacts that are drawn.
pub(super) const MOST_CONTACTS: usize = 150_000;
/// Most triangles of walls that are drawn.
pub(super) const MOST_TRIANGLES: usize = 100_000;

/// A frame, as columns.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Packing {
    pub step: u64,
    pub time: f64,
    pub grains: Grains,
    pub contacts: Contacts,
    pub walls: Vec<Wall>,
}

#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Grains {
    pub id: Vec<u32>,
    pub position: Vec<DVec3>,
    pub radius: Vec<f64>,
    pub speed: Vec<f64>,
    pub material: Vec<i32>,
    pub materials: Vec<String>,
    pub coordination: Vec<u32>,
    /// Nothing where no grain has a tag.
    pub tag: Option<Vec<i32>>,
    /// Sum of the magnitudes of the normal forces on the grain [N].
    pub force: Vec<f64>,
    /// Mean normal stress [Pa].
    pub pressure: Vec<f64>,
}

#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Contacts {
    pub id_i: Vec<u32>,
    /// 0 where it is a wall.
    pub id_j: Vec<u32>,
    pub wall: Vec<i32>,
    pub point: Vec<DVec3>,
    pub overlap: Vec<f64>,
    /// Normal force, repulsion positive [N].
    pub normal: Vec<f64>,
    /// Magnitude of the force [N].
    pub total: Vec<f64>,
}

#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Wall {
    pub index: i32,
    pub name: String,
    pub triangles: Vec<[DVec3; 3]>,
}

impl Packing {
    /// Reads the latest frame that is whole; nothing where there is none.
    pub fn latest(run: &Run) -> Result<Option<Self>, ResultsError> {
        let Some(moment) = run.moments()?.last().copied() else {
            return Ok(None);
        };
        let mut packing = Self {
            step: moment.step,
            time: moment.time,
            grains: read_grains(run, moment.step)?,
            contacts: read_contacts(run, moment.step)?,
            walls: read_walls(run, moment.step)?,
        };
        packing.sum_over_contacts();
        Ok(Some(packing))
    }

    /// Forces and stresses of grains.
    ///
    /// The mean normal stress of a grain of volume `V` is `sum(f_n l) / (3 V)` over its contacts, with the normal force
    /// `f_n` (repulsion positive) and the distance `l` from the centre to the contact: `r - overlap / 2` between grains,
    /// `r - overlap` at a wall. It is the mean over the grain's volume of a third of the trace of the stress (J. Weber,
    /// Bulletin de Liaison des Ponts et Chaussees 20, 1966); friction, which is perpendicular to `l`, gives nothing to it.
    fn sum_over_contacts(&mut self) {
        let by_id = ById::new(&self.grains.id);
        let n = self.grains.id.len();
        let (mut force, mut virial) = (vec![0.0; n], vec![0.0; n]);
        let c = &self.contacts;
        for k in 0..c.id_i.len() {
            let (ids, depth): (&[u32], f64) = match c.wall[k] < 0 {
                true => (&[c.id_i[k], c.id_j[k]], 0.5 * c.overlap[k]),
                false => (&[c.id_i[k]], c.overlap[k]),
            };
            for at in ids.iter().filter_map(|id| by_id.find(*id)) {
                force[at] += c.normal[k].abs();
                virial[at] += c.normal[k] * (self.grains.radius[at] - depth);
            }
        }
        let volume = |r: f64| 4.0 / 3.0 * PI * r * r * r;
        let radii = self.grains.radius.iter();
        self.grains.pressure = virial
            .iter()
            .zip(radii)
            .map(|(sum, r)| sum / (3.0 * volume(*r)))
            .collect();
        self.grains.force = force;
    }

    /// The overlap of every contact as a share of the smaller radius.
    pub fn relative_overlaps(&self) -> Vec<f64> {
        let by_id = ById::new(&self.grains.id);
        let c = &self.contacts;
        let radius = |id: u32| by_id.find(id).map_or(f64::NAN, |at| self.grains.radius[at]);
        let smaller = |k: usize| match c.wall[k] < 0 {
            true => radius(c.id_i[k]).min(radius(c.id_j[k])),
            false => radius(c.id_i[k]),
        };
        (0..c.id_i.len()).map(|k| c.overlap[k] / smaller(k)).collect()
    }

    /// What is left out of the drawing, as sentences.
    pub fn left_out(&self) -> Vec<String> {
        let mut told = Vec::new();
        let triangles: usize = self.walls.iter().map(|wall| wall.triangles.len()).sum();
        for (all, most, what, which) in [
            (
                self.grains.id.len(),
                MOST_GRAINS,
                "grains",
                "spread evenly over the packing",
            ),
            (
                self.contacts.id_i.len(),
                MOST_CONTACTS,
                "contacts",
                "those with the largest normal forces",
            ),
            (triangles, MOST_TRIANGLES, "triangles of walls", "the largest"),
        ] {
            if all > most {
                told.push(format!("Of {all} {what}, {most} are drawn: {which}."));
            }
        }
        told
    }

    /// What the page draws.
    pub fn data(&self) -> Value {
        json!({
            "step": self.step,
            "time": self.time,
            "grains": self.grain_data(),
            "contacts": self.contact_data(),
            "walls": self.wall_data(),
        })
    }

    fn grain_data(&self) -> Value {
        let g = &self.grains;
        let kept = spread(g.id.len(), MOST_GRAINS);
        let some = |values: &[f64]| f32s(kept.iter().map(|&k| values[k]));
        let whole = |values: &[i32]| f32s(kept.iter().map(|&k| f64::from(values[k])));
        let mut scalars = vec![
            json!({ "name": "contact force", "unit": "N", "values": some(&g.force), "meaning": "sum of the magnitudes of the normal forces on the grain" }),
            json!({ "name": "speed", "unit": "m/s", "values": some(&g.speed), "meaning": "" }),
            json!({ "name": "mean normal stress", "unit": "Pa", "values": some(&g.pressure), "meaning": "of the grain, from its contacts; compression positive" }),
            json!({ "name": "coordination", "unit": "", "values": f32s(kept.iter().map(|&k| f64::from(g.coordination[k]))), "meaning": "contacts that act, walls counted" }),
            json!({ "name": "radius", "unit": "m", "values": some(&g.radius), "meaning": "" }),
            json!({ "name": "material", "unit": "", "values": whole(&g.material), "names": g.materials, "meaning": "" }),
        ];
        if let Some(tag) = &g.tag {
            scalars.push(json!({ "name": "tag", "unit": "", "values": whole(tag), "meaning": "", "whole": true }));
        }
        json!({
            "count": g.id.len(),
            "id": u32s(kept.iter().map(|&k| g.id[k])),
            "position": f32s(kept.iter().flat_map(|&k| g.position[k].to_array())),
            "radius": some(&g.radius),
            "scalars": scalars,
        })
    }

    fn contact_data(&self) -> Value {
        let c = &self.contacts;
        let kept = largest(&c.normal, MOST_CONTACTS);
        let some = |values: &[f64]| f32s(kept.iter().map(|&k| values[k]));
        json!({
            "count": c.id_i.len(),
            "id_i": u32s(kept.iter().map(|&k| c.id_i[k])),
            "id_j": u32s(kept.iter().map(|&k| if c.wall[k] < 0 { c.id_j[k] } else { 0 })),
            "wall": f32s(kept.iter().map(|&k| f64::from(c.wall[k]))),
            "point": f32s(kept.iter().flat_map(|&k| c.point[k].to_array())),
            "normal_force": some(&c.normal),
            "total_force": some(&c.total),
            "mean_force": mean(c.normal.iter().map(|f| f.abs())),
        })
    }

    fn wall_data(&self) -> Value {
        let areas: Vec<f64> = (self.walls.iter().flat_map(|wall| &wall.triangles))
            .map(|[a, b, c]| (*b - *a).cross(*c - *a).length())
            .collect();
        let mut kept = largest(&areas, MOST_TRIANGLES).into_iter().peekable();
        let mut start = 0;
        let mut walls = Vec::new();
        for wall in &self.walls {
            let mut numbers = Vec::new();
            while let Some(k) = kept.next_if(|k| *k < start + wall.triangles.len()) {
                numbers.extend(wall.triangles[k - start].iter().flat_map(|p| p.to_array()));
            }
            start += wall.triangles.len();
            walls.push(json!({ "name": wall.name, "index": wall.index, "triangles": f32s(numbers) }));
        }
        json!(walls)
    }
}

/// The mean of numbers; `None` where there are none.
pub(super) fn mean(values: impl Iterator<Item = f64>) -> Option<f64> {
    let (sum, count) = values
        .filter(|v| v.is_finite())
        .fold((0.0, 0.0), |(sum, count), v| (sum + v, count + 1.0));
    (count > 0.0).then(|| sum / count)
}

/// At most so many indices, spread evenly. Grains lie along a curve through the packing, so that these lie evenly in space.
fn spread(all: usize, most: usize) -> Vec<usize> {
    if all <= most {
        return (0..all).collect();
    }
    (0..most)
        .map(|k| (k as u128 * all as u128 / most as u128) as usize)
        .collect()
}

/// The indices of the largest magnitudes, at most so many, in their order.
fn largest(values: &[f64], most: usize) -> Vec<usize> {
    let mut kept: Vec<usize> = (0..values.len()).collect();
    if kept.len() > most {
        let size = |k: &usize| values[*k].abs();
        kept.select_nth_unstable_by(most, |a, b| size(b).total_cmp(&size(a)));
        kept.truncate(most);
        kept.sort_unstable();
    }
    kept
}

/// Finds grains by their ids.
struct ById(Vec<(u32, usize)>);

impl ById {
    fn new(ids: &[u32]) -> Self {
        let mut by_id: Vec<(u32, usize)> = ids.iter().copied().zip(0..).collect();
        by_id.sort_unstable();
        Self(by_id)
    }

    fn find(&self, id: u32) -> Option<usize> {
        let at = self.0.binary_search_by_key(&id, |&(id, _)| id);
        at.ok().map(|at| self.0[at].1)
    }
}

fn vectors(numbers: &[f64]) -> impl Iterator<Item = DVec3> {
    numbers.as_chunks().0.iter().map(|v| DVec3::from_array(*v))
}

fn read_grains(run: &Run, step: u64) -> Result<Grains, ResultsError> {
    let mut table = run.open_table(TableKind::Grains, step)?;
    let velocity = table.floats("velocity", 3)?;
    let has_tags = table.names().any(|name| name == "tag");
    Ok(Grains {
        id: table.counts("id")?,
        position: table.points()?,
        radius: table.floats("radius", 1)?,
        speed: vectors(&velocity).map(|v| v.length()).collect(),
        material: table.integers("material")?,
        materials: table.texts("material_names").to_vec(),
        coordination: table.counts("coordination")?,
        tag: has_tags.then(|| table.integers("tag")).transpose()?,
        ..Grains::default()
    })
}

fn read_contacts(run: &Run, step: u64) -> Result<Contacts, ResultsError> {
    let mut table = run.open_table(TableKind::Contacts, step)?;
    let normal = table.floats("normal", 3)?;
    let force = table.floats("normal_force", 3)?;
    Ok(Contacts {
        id_i: table.counts("id_i")?,
        id_j: table.counts("id_j")?,
        wall: table.integers("wall")?,
        point: table.points()?,
        overlap: table.floats("overlap", 1)?,
        normal: vectors(&normal).zip(vectors(&force)).map(|(n, f)| n.dot(f)).collect(),
        total: table.floats("force_magnitude", 1)?,
    })
}

fn read_walls(run: &Run, step: u64) -> Result<Vec<Wall>, ResultsError> {
    let mut table = run.open_table(TableKind::Walls, step)?;
    let (points, index) = (table.points()?, table.integers("wall")?);
    let names = table.texts("wall_names");
    let mut walls: Vec<Wall> = Vec::new();
    for (triangle, index) in points.as_chunks::<3>().0.iter().zip(index) {
        if walls.last().is_none_or(|wall| wall.index != index) {
            let name = usize::try_from(index).ok().and_then(|k| names.get(k));
            walls.push(Wall {
                index,
                name: name.cloned().unwrap_or_else(|| format!("wall {index}")),
                triangles: Vec::new(),
            });
        }
        if let Some(wall) = walls.last_mut() {
            wall.triangles.push(*triangle);
        }
    }
    Ok(walls)
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Grain 7 (r = 2) rests on wall 0 and carries grain 3 (r = 1).
    fn two_grains() -> Packing {
        let mut packing = Packing {
            grains: Grains {
                id: vec![7, 3],
                radius: vec![2.0, 1.0],
                ..Grains::default()
            },
            contacts: Contacts {
                id_i: vec![3, 7],
                id_j: vec![7, 0],
                wall: vec![-1, 0],
                overlap: vec![0.2, 0.1],
                normal: vec![10.0, 30.0],
                ..Contacts::default()
            },
            ..Packing::default()
        };
        packing.sum_over_contacts();
        packing
    }

    #[test]
    fn stress_and_force_count_every_contact_of_a_grain() {
        let packing = two_grains();
        assert_eq!(packing.grains.force, [40.0, 10.0]);
        let volume = |r: f64| 4.0 / 3.0 * PI * r.powi(3);
        let expected = (10.0 * 1.9 + 30.0 * 1.9) / (3.0 * volume(2.0));
        assert_relative_eq!(packing.grains.pressure[0], expected, max_relative = 1e-14);
        assert_relative_eq!(
            packing.grains.pressure[1],
            10.0 * 0.9 / (3.0 * volume(1.0)),
            max_relative = 1e-14
        );
    }

    #[test]
    fn overlaps_are_shares_of_the_smaller_radius() {
        assert_eq!(two_grains().relative_overlaps(), [0.2, 0.05]);
    }

    #[test]
    fn a_stated_part_is_drawn_of_what_is_too_much() {
        assert_eq!(spread(10, 4), [0, 2, 5, 7]);
        assert_eq!(spread(3, 4), [0, 1, 2]);
        assert_eq!(largest(&[1.0, -9.0, 3.0, 0.5], 2), [1, 2]);
        assert_eq!(largest(&[f64::NAN, 1.0], 5), [0, 1]);
        let mut packing = two_grains();
        assert!(packing.left_out().is_empty());
        packing.grains.id = vec![0; MOST_GRAINS + 5];
        assert_eq!(
            packing.left_out(),
            ["Of 100005 grains, 100000 are drawn: spread evenly over the packing."]
        );
    }

    #[test]
    fn a_state_without_anything_is_drawn_as_such() {
        let data = Packing::default().data();
        assert_eq!(data["grains"]["count"], 0);
        assert!(data["contacts"]["mean_force"].is_null() && data["walls"] == json!([]));
    }
}
