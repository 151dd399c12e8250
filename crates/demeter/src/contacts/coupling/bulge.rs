//! How far a grain's surface may bulge: what the search for contacts must look beyond touching.

use super::sites::Load;
use crate::contacts::{ContactChunk, Contacts};
use crate::materials::Materials;
use crate::neighbours::Neighbours;
use crate::particles::Grains;
use demeter_physics::contact::multi_contact::{MultiContact, MultiContactVisitor, clearance};
use serde::{Deserialize, Serialize};

/// Forces may grow by this factor over a step before the search has to be repeated.
pub(crate) const ALLOWANCE: f64 = 1.1;

/// A surface may bulge from nothing by this share of its radius before the search has to be repeated.
pub(crate) const FIRST_BULGE: f64 = 1e-3;

/// Bounds of the displacement on grains of every material.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct Bounds {
    /// Largest outward displacement per push, times the least lever [m^2/N].
    bulge: Vec<f64>,
    /// Largest outward displacement per pull, times the radius [m^2/N].
    pull: Vec<f64>,
}

struct Unit {
    least_distance: f64,
}

impl MultiContactVisitor for Unit {
    type Output = (f64, f64);

    /// Bounds of a grain of radius 1: both are inverse to lengths.
    fn visit<L: MultiContact>(self, law: &L) -> (f64, f64) {
        (law.largest_bulge(1.0, 1.0), law.largest_pull(1.0, self.least_distance))
    }
}

impl Bounds {
    pub(crate) fn new(grains: &Grains, materials: &Materials) -> Self {
        let smallest = grains.radii().fold(f64::INFINITY, f64::min);
        let largest = grains.radii().fold(0.0, f64::max);
        // where two of the smallest grains sit side by side on the largest, as a share of its radius
        let side_by_side = smallest / (smallest + largest);
        let least_distance = side_by_side.min(clearance(1.0, None));
        let count = materials.list().len() as u16;
        let (bulge, pull) = (0..count)
            .map(|a| {
                let of_pairs = (0..count).map(|b| {
                    let law = materials.law(materials.pair(a, b)).multi_contact;
                    law[0].visit(Unit { least_distance })
                });
                of_pairs.fold((0.0, 0.0), |(b, p), (bulge, pull)| {
                    (f64::max(b, bulge), f64::max(p, pull))
                })
            })
            .unzip();
        Self { bulge, pull }
    }

    /// Largest outward displacement of a grain's surface under a load [m].
    #[inline(always)]
    pub(crate) fn bulge(&self, material: u16, radius: f64, load: &Load) -> f64 {
        let material = usize::from(material);
        load.push * self.bulge[material] / load.least_lever + load.pull * self.pull[material] / radius
    }

    /// The same by the forces of the step before.
    pub(crate) fn of_grain(&self, grain: usize, grains: &Grains, neighbours: &Neighbours, contacts: &Contacts) -> f64 {
        let mut load = Load::on(grains.radius(grain));
        let mut add = |chunk: &ContactChunk, slot: usize, first: bool| {
            for k in chunk.contacts_of(slot) {
                let contact = &chunk.now.geometry[k];
                let lever = if first { contact.lever_i } else { contact.lever_j };
                load.add(chunk.now.coupling[k].elastic, lever);
            }
        };
        for (chunk, slot, first) in neighbours.pairs_of(grain) {
            add(&contacts.pairs[chunk], slot, first);
        }
        for (chunk, slot) in neighbours.wall_pairs_of(grain) {
            add(&contacts.walls[chunk], slot, true);
        }
        self.bulge(grains.material[grain], grains.radius(grain), &load)
    }
}
