//! What is drawn of the last state.

use super::arrays::{f32s, u32s};
use crate::results::Packing;
use serde_json::{Value, json};

/// Most grains that are drawn.
pub(super) const MOST_GRAINS: usize = 100_000;
/// Most contacts that are drawn.
pub(super) const MOST_CONTACTS: usize = 150_000;
/// Most triangles of walls that are drawn.
pub(super) const MOST_TRIANGLES: usize = 100_000;

/// Share of the size of a scene below which places differ by rounding alone.
const ROUNDING: f64 = 1e-12;

impl Packing {
    /// The length below which walls only seem to move [m].
    pub fn rounding(&self) -> f64 {
        let corners = self.walls.iter().flat_map(|wall| wall.triangles.iter().flatten());
        let places = self.grains.position.iter().chain(corners);
        ROUNDING * places.map(|place| place.abs().max_element()).fold(0.0, f64::max)
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
        let scalars: Vec<Value> = (self.scalars().iter())
            .map(|scalar| {
                json!({
                    "name": scalar.name, "unit": scalar.unit, "meaning": scalar.meaning, "values": some(&scalar.values),
                    "names": scalar.names, "whole": scalar.is_label,
                })
            })
            .collect();
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stated_part_is_drawn_of_what_is_too_much() {
        assert_eq!(spread(10, 4), [0, 2, 5, 7]);
        assert_eq!(spread(3, 4), [0, 1, 2]);
        assert_eq!(largest(&[1.0, -9.0, 3.0, 0.5], 2), [1, 2]);
        assert_eq!(largest(&[f64::NAN, 1.0], 5), [0, 1]);
        let mut packing = Packing::default();
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
