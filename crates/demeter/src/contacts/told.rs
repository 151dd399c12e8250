//! Vectors of contacts that are told, and that no step reads.

use super::EIGHT;
use crate::particles::{Beyond, make_room, set_aside};
use demeter_physics::lanes::{Lanes, Vector};
use glam::{DVec3, Vec3};
use serde::{Deserialize, Serialize};
use std::ops::Range;

/// Vectors of eight contacts, component by component.
type EightVectors = [[f32; EIGHT]; 3];

/// A vector of every contact, rounded to single precision.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(crate) struct Told(Vec<EightVectors>);

impl Told {
    pub(super) fn clear(&mut self) {
        self.0.clear();
    }

    pub(super) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Has those of so many contacts; new ones are zero.
    #[inline(always)]
    pub(super) fn resize(&mut self, contacts: usize) {
        self.0.resize(contacts.div_ceil(EIGHT), EightVectors::default());
    }

    /// That of a contact; zero where none is told.
    #[inline(always)]
    pub(super) fn of(&self, contact: usize) -> DVec3 {
        let lane = contact % EIGHT;
        let eight = self.0.get(contact / EIGHT);
        eight.map_or(DVec3::ZERO, |[x, y, z]| Vec3::new(x[lane], y[lane], z[lane]).as_dvec3())
    }

    /// Those of so many contacts, in the singles that they are.
    pub(super) fn singles(&self, contacts: usize) -> Vec<[f32; 3]> {
        (0..contacts)
            .map(|contact| self.of(contact).as_vec3().to_array())
            .collect()
    }

    /// Of contacts, as [`Told::singles`] told them.
    pub(super) fn of_singles(singles: &[[f32; 3]]) -> Self {
        let mut told = Self::default();
        told.resize(singles.len());
        for (contact, &single) in singles.iter().enumerate() {
            told.put(contact, Vec3::from_array(single).as_dvec3());
        }
        told
    }

    /// Puts that of a contact.
    #[inline(always)]
    pub(super) fn put(&mut self, contact: usize, vector: DVec3) {
        let singles = vector.as_vec3().to_array();
        for (components, single) in self.0[contact / EIGHT].iter_mut().zip(singles) {
            components[contact % EIGHT] = single;
        }
    }

    /// Puts those of the contacts from `k` on; there may be fewer than there are lanes.
    #[inline(always)]
    pub(super) fn put_lanes<L: Lanes>(&mut self, k: usize, vectors: L::Vector) {
        let components = vectors.components();
        let mut which = 0;
        while which < L::REGISTERS {
            let place = k + which * L::Register::COUNT;
            // the last registers may lie beyond the end
            if let Some([x, y, z]) = self.0.get_mut(place / EIGHT) {
                components[0].register(which).store_singles(&mut x[place % EIGHT..]);
                components[1].register(which).store_singles(&mut y[place % EIGHT..]);
                components[2].register(which).store_singles(&mut z[place % EIGHT..]);
            }
            which += 1;
        }
    }

    /// Puts those of contacts of another table from a place on.
    pub(super) fn take_over(&mut self, first: usize, other: &Self, contacts: Range<usize>) {
        self.resize(first + contacts.len());
        for (place, contact) in (first..).zip(contacts) {
            self.put(place, other.of(contact));
        }
    }

    /// Takes all of another table, in memory that is here wherever that is enough.
    pub(super) fn copy(&mut self, other: &Self) {
        self.0.clone_from(&other.0);
    }

    /// Sets memory aside for so many contacts where there is none.
    pub(super) fn make_room(&mut self, contacts: usize, beyond: Beyond) {
        make_room(&mut self.0, contacts.div_ceil(EIGHT), beyond);
    }

    /// Bytes set aside.
    pub(super) fn bytes(&self) -> usize {
        set_aside(&self.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn vectors_are_found_where_they_were_put() {
        let vector = |k: usize| DVec3::new(k as f64, -0.5 * k as f64, 0.25);
        let mut told = Told::default();
        assert_eq!(told.of(3), DVec3::ZERO);
        told.resize(11);
        (0..11).for_each(|k| told.put(k, vector(k)));
        assert!((0..11).all(|k| told.of(k) == vector(k)));
        let mut others = Told::default();
        others.take_over(5, &told, 2..11);
        assert!((0..5).all(|k| others.of(k) == DVec3::ZERO));
        assert!((5..14).all(|k| others.of(k) == vector(k - 3)));
        let tenth = DVec3::splat(0.1);
        told.put(10, tenth);
        assert!((told.of(10) - tenth).length() < 1e-8 && told.of(10) != tenth);
        others.take_over(0, &Told::default(), 0..11);
        assert!((0..11).all(|k| others.of(k) == DVec3::ZERO));
        others.copy(&told);
        assert_eq!(others.of(9), vector(9));
    }
}
