//! What acts on a grain.

use bytemuck::{Pod, Zeroable};
use glam::DVec3;
use serde::{Deserialize, Serialize};

/// Force [N] and torque [N m], each with a number beside it. In the table of the grains these are the mass [kg] and the crossings of
/// periodic sides; elsewhere they are 0, so that sums leave those of a grain as they are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, Pod, Zeroable)]
#[repr(C, align(64))]
pub struct Load(pub(crate) [f64; 8]);

const MASS: usize = 3;
const CROSSINGS: usize = 7;

/// Most crossings of periodic sides that are counted in any direction.
pub const MOST_CROSSINGS: i32 = (1 << 17) - 1;

/// Whether so many crossings can be counted.
pub(crate) fn can_be_counted(crossings: &[i32; 3]) -> bool {
    crossings.iter().all(|n| (-MOST_CROSSINGS..=MOST_CROSSINGS).contains(n))
}

/// By how much a crossing counts more in the next direction: all three together are a whole number of no more than 53 bits.
const NEXT: i64 = 1 << 18;

impl Load {
    /// That of a force [N] and a torque [N m].
    pub fn new(force: DVec3, torque: DVec3) -> Self {
        Self([force.x, force.y, force.z, 0.0, torque.x, torque.y, torque.z, 0.0])
    }

    /// The force [N].
    #[inline(always)]
    pub fn force(&self) -> DVec3 {
        DVec3::from_slice(&self.0[..3])
    }

    /// The torque [N m].
    #[inline(always)]
    pub fn torque(&self) -> DVec3 {
        DVec3::from_slice(&self.0[4..7])
    }

    /// The mass of a grain [kg].
    #[inline(always)]
    pub(crate) fn mass(&self) -> f64 {
        self.0[MASS]
    }

    pub(super) fn set_mass(&mut self, mass: f64) {
        self.0[MASS] = mass;
    }

    /// How many periodic boxes a grain has crossed, by direction.
    #[inline]
    pub(crate) fn crossings(&self) -> [i32; 3] {
        let mut rest = self.0[CROSSINGS] as i64;
        [0; 3].map(|_| {
            let digit = (rest.wrapping_add(NEXT / 2) & (NEXT - 1)) - NEXT / 2;
            rest = rest.wrapping_sub(digit) / NEXT;
            digit as i32
        })
    }

    /// Notes how many periodic boxes a grain has crossed; tells whether that can be counted ([`MOST_CROSSINGS`]).
    #[must_use]
    pub(crate) fn set_crossings(&mut self, crossings: [i32; 3]) -> bool {
        let fits = can_be_counted(&crossings);
        if fits {
            let [x, y, z] = crossings.map(i64::from);
            self.0[CROSSINGS] = (x + NEXT * (y + NEXT * z)) as f64;
        }
        fits
    }

    /// Mass [kg] and crossings of a grain.
    pub(super) fn beside(&self) -> [f64; 2] {
        [self.0[MASS], self.0[CROSSINGS]]
    }

    /// That of a grain whose force is not known yet.
    pub(super) fn without_force([mass, crossings]: [f64; 2]) -> Self {
        // whoever looks at it nevertheless finds no number in tests
        let unknown = if cfg!(test) { f64::NAN } else { 0.0 };
        let mut load = Self([unknown; 8]);
        (load.0[MASS], load.0[CROSSINGS]) = (mass, crossings);
        load
    }

    /// Takes another force [N] and torque [N m].
    pub(crate) fn put(&mut self, force: DVec3, torque: DVec3) {
        let [_, _, _, mass, _, _, _, crossings] = self.0;
        self.0 = [force.x, force.y, force.z, mass, torque.x, torque.y, torque.z, crossings];
    }

    /// Forgets force and torque.
    #[inline(always)]
    pub(crate) fn clear(&mut self) {
        self.put(DVec3::ZERO, DVec3::ZERO);
    }

    /// Adds another load.
    pub(crate) fn add(&mut self, other: &Self) {
        self.0.iter_mut().zip(other.0).for_each(|(sum, more)| *sum += more);
    }

    /// Force and torque, each with what is beside it.
    #[inline(always)]
    pub(crate) fn parts(&self) -> [&[f64; 4]; 2] {
        let [force, torque] = self.0.as_chunks().0 else {
            return [&[0.0; 4]; 2];
        };
        [force, torque]
    }
}

impl AsMut<[f64; 8]> for Load {
    #[inline(always)]
    fn as_mut(&mut self) -> &mut [f64; 8] {
        &mut self.0
    }
}

/// By how much a half kick that a step foresees changes velocity [m/s] and, behind it, angular velocity [1/s].
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub(crate) struct HalfKick(pub(crate) [f32; 6]);

/// The half kicks that a step foresees: what is left of them when it has ended says nothing about the grains, so that no two tables
/// differ.
#[derive(Clone, Debug, Default)]
pub(crate) struct HalfKicks(pub(crate) Vec<HalfKick>);

impl PartialEq for HalfKicks {
    fn eq(&self, _other: &Self) -> bool {
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn crossings_are_counted_beside_forces() {
        let most = MOST_CROSSINGS;
        for crossings in [
            [0; 3],
            [1, -1, 2],
            [-7, 0, 131_000],
            [most; 3],
            [-most; 3],
            [most, -most, most],
        ] {
            let mut load = Load::new(DVec3::X, DVec3::Y);
            load.set_mass(3.0);
            assert!(load.set_crossings(crossings));
            load.add(&Load::new(DVec3::Z, DVec3::Z));
            assert_eq!((load.crossings(), load.mass()), (crossings, 3.0));
            load.clear();
            assert_eq!((load.crossings(), load.mass()), (crossings, 3.0));
            assert_eq!((load.force(), load.torque()), (DVec3::ZERO, DVec3::ZERO));
            assert!(!load.set_crossings([0, most + 1, 0]));
            assert_eq!(load.crossings(), crossings);
        }
    }

    #[test]
    fn what_is_no_count_gives_some() {
        for number in [f64::NAN, f64::INFINITY, -1e300, 0.5, 9e15] {
            let counted = Load([0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, number]).crossings();
            assert!(counted.iter().all(|n| n.abs() <= MOST_CROSSINGS + 1));
        }
    }
}
