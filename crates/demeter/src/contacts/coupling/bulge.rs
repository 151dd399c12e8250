//! How far a grain's surface may bulge: what the search for contacts must look beyond touching.

use super::sites::ContactPlace;
use crate::contacts::{CHUNK, Contacts};
use crate::materials::Materials;
use crate::neighbours::Neighbours;
use crate::particles::Grains;
use demeter_physics::contact::multi_contact::{Body, MultiContact, MultiContactVisitor, clearance};
use serde::{Deserialize, Serialize};

/// Forces may grow by this factor over a step before the search has to be repeated.
pub(crate) const ALLOWANCE: f64 = 1.25;

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
        (
            law.largest_bulge(Body::First, 1.0, 1.0),
            law.largest_pull(Body::First, 1.0, self.least_distance),
        )
    }
}

impl Bounds {
    pub(crate) fn new(grains: &Grains, materials: &Materials) -> Self {
        let smallest = grains.radius.iter().copied().fold(f64::INFINITY, f64::min);
        let largest = grains.radius.iter().copied().fold(0.0, f64::max);
        // where two of the smallest grains sit side by side on the largest, as a share of its radius
        let side_by_side = smallest / (smallest + largest);
        let least_distance = side_by_side.min(clearance(1.0, None));
        let count = materials.list().len() as u16;
        let (bulge, pull) = (0..count)
            .map(|a| {
                let of_pairs = (0..count).map(|b| {
                    let law = materials.law(materials.pair(a, b)).multi_contact;
                    law.visit(Unit { least_distance })
                });
                of_pairs.fold((0.0, 0.0), |(b, p), (bulge, pull)| {
                    (f64::max(b, bulge), f64::max(p, pull))
                })
            })
            .unzip();
        Self { bulge, pull }
    }

    /// Largest outward displacement of a grain's surface [m] by the forces `force` of its contacts.
    pub(crate) fn of_grain(
        &self,
        grain: usize,
        grains: &Grains,
        neighbours: &Neighbours,
        contacts: &Contacts,
        force: impl Fn(&Contacts, ContactPlace) -> f64,
    ) -> f64 {
        let (mut push, mut pull) = (0.0, 0.0);
        let mut least_lever = grains.radius[grain];
        let mut add = |place: ContactPlace, first: bool| {
            let force = force(contacts, place);
            if force > 0.0 {
                push += force;
            } else {
                pull -= force;
            }
            let contact = &place.chunk(contacts).now.geometry[place.contact as usize];
            least_lever = least_lever.min(if first { contact.lever_i } else { contact.lever_j });
        };
        let mut each = |wall: bool, pair: usize, first: bool| {
            let chunk = if wall { &contacts.walls } else { &contacts.pairs };
            for k in chunk[pair / CHUNK].contacts_of(pair % CHUNK) {
                let place = ContactPlace {
                    wall,
                    chunk: (pair / CHUNK) as u32,
                    contact: k as u32,
                };
                add(place, first);
            }
        };
        neighbours
            .pairs_of(grain)
            .for_each(|(pair, first)| each(false, pair, first));
        neighbours.wall_pairs_of(grain).for_each(|pair| each(true, pair, true));
        let material = grains.material[grain] as usize;
        push * self.bulge[material] / least_lever + pull * self.pull[material] / grains.radius[grain]
    }
}
