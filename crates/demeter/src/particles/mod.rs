//! Grains as a struct of arrays, and the domain that they live in.

mod by_id;
mod domain;
mod interior;
mod load;
mod origins;
mod parts;
mod rows;
pub(crate) mod spread;
mod written;
mod zone;

pub use by_id::ById;
pub use domain::{Domain, Outside};
#[cfg(test)]
pub(crate) use interior::tests::boxed;
pub use interior::{Interior, InteriorError};
pub(crate) use load::HalfKick;
use load::HalfKicks;
pub(crate) use load::can_be_counted;
pub use load::{Load, MOST_CROSSINGS};
pub use origins::Origins;
use rows::{Kept, copy_kept};
pub use rows::{Row, Rows};
pub use zone::{Zone, ZonePart, ZoneShape};

use bytemuck::{Pod, Zeroable};
use demeter_physics::integrator::gear::Derivatives;
use glam::{DQuat, DVec3, Vec3};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::ops::Range;

/// A grain to be added.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NewGrain {
    /// Index of its material.
    pub material: u16,
    /// Radius [m].
    pub radius: f64,
    /// Mass density [kg/m^3].
    pub density: f64,
    /// Centre [m].
    pub position: DVec3,
    /// Velocity [m/s].
    pub velocity: DVec3,
    /// Angular velocity in the world frame [1/s].
    pub angular_velocity: DVec3,
    /// Whether forces leave its velocity as it is.
    pub fixed: bool,
}

/// All grains. Index `i` of every array is the same grain; `id` never changes, the index may.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
pub struct Grains {
    /// Permanent identity, from 1.
    pub id: Vec<u32>,
    /// Index of the material.
    pub material: Vec<u16>,
    /// Centre [m], inside the periodic box when there is one; beside it the radius [m].
    pub position: Rows,
    /// Velocity [m/s]; beside it the inverse mass [1/kg], 0 for a fixed grain.
    pub velocity: Rows,
    /// Angular velocity in the world frame [1/s]; beside it the inverse moment of inertia [1/(kg m^2)], 0 for a fixed grain.
    pub angular_velocity: Rows,
    /// Orientation, where it is followed: nothing that a sphere does depends on it.
    pub orientation: Option<Vec<DQuat>>,
    /// Total force [N] and torque [N m] of the latest step; beside them the mass [kg] and the crossings of periodic sides.
    pub load: Rows<Load>,
    /// Masses and crossings while the table of loads is put aside ([`Grains::put_loads_aside`]); empty otherwise.
    #[serde(skip)]
    beside_loads: Vec<[f64; 2]>,
    /// What a step of velocity Verlet foresees, until it has ended; empty before the first.
    #[serde(skip)]
    pub(crate) half_kicks: HalfKicks,
    /// What the predictor-corrector remembers beyond forces and torques; empty with velocity Verlet.
    pub higher: Vec<HigherDerivatives>,
}

/// Numbers that never change of a grain.
pub(crate) const CONSTANTS: usize = 6;

/// Derivatives of the motion of one grain above the accelerations.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, Pod, Zeroable)]
#[repr(C)]
pub struct HigherDerivatives {
    /// Third to fifth derivative of place [m/s^3, m/s^4, m/s^5].
    pub translation: Derivatives,
    /// Second to fourth derivative of the angular velocity [1/s^3, 1/s^4, 1/s^5].
    pub rotation: Derivatives,
    /// Acceleration [m/s^2] and angular acceleration [1/s^2] that are foreseen for the end of a step, until it has ended.
    pub foreseen: [DVec3; 2],
}

impl Grains {
    /// Number of grains.
    pub fn len(&self) -> usize {
        self.id.len()
    }

    /// Whether there is no grain.
    pub fn is_empty(&self) -> bool {
        self.id.is_empty()
    }

    /// Radius of a grain [m].
    #[inline(always)]
    pub fn radius(&self, grain: usize) -> f64 {
        self.position.scalar(grain)
    }

    /// Total force on a grain in the latest step [N].
    #[inline(always)]
    pub fn force(&self, grain: usize) -> DVec3 {
        self.load.rows()[grain].force()
    }

    /// Total torque on a grain in the latest step [N m].
    #[inline(always)]
    pub fn torque(&self, grain: usize) -> DVec3 {
        self.load.rows()[grain].torque()
    }

    /// Mass of a grain [kg].
    #[inline(always)]
    pub fn mass(&self, grain: usize) -> f64 {
        self.load.rows()[grain].mass()
    }

    /// All masses [kg].
    pub fn masses(&self) -> impl ExactSizeIterator<Item = f64> + Clone + '_ {
        self.load.rows().iter().map(Load::mass)
    }

    /// How many periodic boxes a grain has crossed, by direction.
    #[inline]
    pub fn crossings(&self, grain: usize) -> [i32; 3] {
        self.load.rows()[grain].crossings()
    }

    /// All radii [m].
    pub fn radii(&self) -> impl ExactSizeIterator<Item = f64> + Clone + '_ {
        self.position.scalars()
    }

    /// Rows of positions, velocities and angular velocities.
    #[inline(always)]
    pub(crate) fn tables(&self) -> [&[[f64; 4]]; 3] {
        [
            self.position.table(),
            self.velocity.table(),
            self.angular_velocity.table(),
        ]
    }

    /// Moment of inertia of a grain, `2/5 m r^2` [kg m^2].
    #[inline(always)]
    pub fn inertia(&self, grain: usize) -> f64 {
        inertia(self.mass(grain), self.radius(grain))
    }

    /// Inverse mass of a grain, 0 where it is fixed [1/kg].
    #[inline(always)]
    pub fn inverse_mass(&self, grain: usize) -> f64 {
        self.velocity.scalar(grain)
    }

    /// Inverse moment of inertia of a grain, 0 where it is fixed [1/(kg m^2)].
    #[inline(always)]
    pub fn inverse_inertia(&self, grain: usize) -> f64 {
        self.angular_velocity.scalar(grain)
    }

    /// Whether forces leave the velocity of a grain as it is.
    #[inline(always)]
    pub fn is_fixed(&self, grain: usize) -> bool {
        self.inverse_mass(grain) == 0.0
    }

    /// Puts radius [m] and mass [kg] of a grain.
    pub fn set_size(&mut self, grain: usize, radius: f64, mass: f64) {
        self.load.rows_mut()[grain].set_mass(mass);
        self.position.set_scalar(grain, radius);
        if !self.is_fixed(grain) {
            self.velocity.set_scalar(grain, 1.0 / mass);
            self.angular_velocity.set_scalar(grain, 1.0 / inertia(mass, radius));
        }
    }

    /// Forgets forces and torques, and gives back the memory of their table, until [`Grains::bring_loads_back`]: for what takes much memory
    /// while nobody asks for them. Masses and crossings can not be looked at meanwhile.
    pub(crate) fn put_loads_aside(&mut self) {
        self.beside_loads = self.load.rows().iter().map(Load::beside).collect();
        self.load = Rows::default();
    }

    /// The table of loads again, where it was put aside, without forces and torques.
    pub(crate) fn bring_loads_back(&mut self) {
        if self.beside_loads.is_empty() {
            return;
        }
        self.load = Rows::zeros(self.len());
        let beside = std::mem::take(&mut self.beside_loads);
        (self.load.rows_mut().par_iter_mut().zip(beside))
            .for_each(|(load, beside)| *load = Load::without_force(beside));
    }

    /// Has room for the half kicks that a step foresees: zeros where none are foreseen yet, which take no memory until they are written.
    pub(crate) fn foresee_half_kicks(&mut self) {
        if self.half_kicks.0.len() != self.len() {
            self.half_kicks.0 = bytemuck::zeroed_vec(self.len());
        }
    }

    /// The largest half kick that is foreseen for the velocity of any of some grains [m/s].
    pub(crate) fn largest_half_kick(&self, some: Range<usize>) -> f64 {
        let foreseen = self.half_kicks.0.get(some).unwrap_or_default().iter();
        let size2 = |HalfKick([x, y, z, ..]): &HalfKick| Vec3::new(*x, *y, *z).as_dvec3().length_squared();
        foreseen.map(size2).fold(0.0, f64::max).sqrt() * (1.0 + f64::from(f32::EPSILON))
    }

    /// Adds a grain with the given id.
    pub fn push(&mut self, id: u32, grain: &NewGrain) {
        let r = grain.radius;
        let mass = grain.density * (4.0 / 3.0 * std::f64::consts::PI) * r * r * r;
        let (inverse_mass, inverse_inertia) = if grain.fixed {
            (0.0, 0.0)
        } else {
            (1.0 / mass, 1.0 / inertia(mass, r))
        };
        self.id.push(id);
        self.material.push(grain.material);
        self.position.push(grain.position, r);
        self.velocity.push(grain.velocity, inverse_mass);
        self.angular_velocity.push(grain.angular_velocity, inverse_inertia);
        if let Some(orientation) = &mut self.orientation {
            orientation.push(DQuat::IDENTITY);
        }
        let mut load = Load::default();
        load.set_mass(mass);
        self.load.push_row(load);
        if !self.half_kicks.0.is_empty() {
            self.half_kicks.0.push(HalfKick::default());
        }
        if !self.higher.is_empty() {
            self.higher.push(HigherDerivatives::default());
        }
    }

    /// From now on follows how the grains turn; those in the table have not turned yet.
    pub fn follow_orientations(&mut self) {
        self.orientation = Some(vec![DQuat::IDENTITY; self.len()]);
    }

    /// Adds copies of all grains of another table, with their ids.
    pub fn append(&mut self, other: &Self) {
        self.id.extend_from_slice(&other.id);
        self.material.extend_from_slice(&other.material);
        self.position.append(&other.position);
        self.velocity.append(&other.velocity);
        self.angular_velocity.append(&other.angular_velocity);
        if let Some(orientation) = &mut self.orientation {
            orientation.extend(other.orientation.iter().flatten());
            orientation.resize(self.id.len(), DQuat::IDENTITY);
        }
        self.load.append(&other.load);
        if !self.half_kicks.0.is_empty() {
            self.half_kicks.0.resize(self.id.len(), HalfKick::default());
        }
        if !self.higher.is_empty() {
            self.higher.resize(self.id.len(), HigherDerivatives::default());
        }
    }

    /// All of some grains, as bytes.
    pub(crate) fn pack(&self, some: impl Iterator<Item = usize> + Clone) -> Vec<u8> {
        fn put<T: Pod>(packed: &mut Vec<u8>, values: &[T], some: impl Iterator<Item = usize>) {
            some.for_each(|g| packed.extend_from_slice(bytemuck::bytes_of(&values[g])));
        }
        let mut packed: Vec<u8> = Vec::new();
        for rows in [&self.position, &self.velocity, &self.angular_velocity] {
            put(&mut packed, rows.rows(), some.clone());
        }
        put(&mut packed, self.load.rows(), some.clone());
        put(&mut packed, &self.id, some.clone());
        put(&mut packed, &self.material, some.clone());
        if let Some(orientation) = &self.orientation {
            put(&mut packed, orientation, some.clone());
        }
        if !self.half_kicks.0.is_empty() {
            put(&mut packed, &self.half_kicks.0, some.clone());
        }
        if !self.higher.is_empty() {
            put(&mut packed, &self.higher, some);
        }
        packed
    }

    /// Takes what [`Grains::pack`] made of so many grains; tells whether it fits.
    pub(crate) fn unpack(&mut self, some: impl Iterator<Item = usize> + Clone, packed: &[u8]) -> bool {
        fn take<T: Pod>(packed: &mut &[u8], values: &mut [T], mut some: impl Iterator<Item = usize>) -> bool {
            some.all(|g| {
                let Some((front, rest)) = packed.split_at_checked(size_of::<T>()) else {
                    return false;
                };
                bytemuck::bytes_of_mut(&mut values[g]).copy_from_slice(front);
                *packed = rest;
                true
            })
        }
        let mut rest = packed;
        let rows = [&mut self.position, &mut self.velocity, &mut self.angular_velocity];
        let fits = rows
            .into_iter()
            .all(|rows| take(&mut rest, rows.rows_mut(), some.clone()))
            && take(&mut rest, self.load.rows_mut(), some.clone())
            && take(&mut rest, &mut self.id, some.clone())
            && take(&mut rest, &mut self.material, some.clone())
            && (self.orientation.as_mut()).is_none_or(|of| take(&mut rest, of, some.clone()))
            && (self.half_kicks.0.is_empty() || take(&mut rest, &mut self.half_kicks.0, some.clone()))
            && (self.higher.is_empty() || take(&mut rest, &mut self.higher, some));
        fits && rest.is_empty()
    }

    /// What never changes of a grain, as numbers: id, material, mass, radius, inverse mass and inverse moment of inertia.
    pub(crate) fn constants(&self, grain: usize) -> [f64; CONSTANTS] {
        [
            f64::from(self.id[grain]),
            f64::from(self.material[grain]),
            self.mass(grain),
            self.radius(grain),
            self.inverse_mass(grain),
            self.inverse_inertia(grain),
        ]
    }

    /// Takes what [`Grains::constants`] told of a grain; nothing where nothing is told.
    pub(crate) fn set_constants(&mut self, grain: usize, told: &[f64]) {
        if let &[id, material, mass, radius, inverse_mass, inverse_inertia] = told {
            self.id[grain] = id as u32;
            self.material[grain] = material as u16;
            self.load.rows_mut()[grain].set_mass(mass);
            self.position.set_scalar(grain, radius);
            self.velocity.set_scalar(grain, inverse_mass);
            self.angular_velocity.set_scalar(grain, inverse_inertia);
        }
    }

    /// Bytes of so many grains in the tables.
    pub(crate) fn bytes_of(&self, count: usize) -> usize {
        let higher = if self.higher.is_empty() {
            0
        } else {
            size_of::<HigherDerivatives>()
        };
        let scalars = size_of::<u32>() + size_of::<u16>();
        let turned = self.orientation.as_ref().map_or(0, |_| size_of::<DQuat>());
        let rows = 3 * size_of::<Row>() + size_of::<Load>() + turned;
        count * (scalars + rows + size_of::<HalfKick>() + higher)
    }

    /// Puts the grains into a new order: the grain at `order[k]` goes to index `k`. Grains not named are dropped.
    pub fn reorder(&mut self, order: &[u32]) {
        let all = order.iter().enumerate().map(|(to, &from)| (to, from as usize));
        self.keep(order.len(), all);
    }

    /// Goes on with so many grains, of which some are known, told by their new and their old indices; all others are forgotten and take
    /// no memory.
    pub(crate) fn keep(&mut self, count: usize, some: impl Iterator<Item = Kept> + Clone) {
        fn keep<T: Pod>(values: &mut Vec<T>, count: usize, some: impl Iterator<Item = Kept>) {
            let mut kept = bytemuck::zeroed_vec(count);
            copy_kept(&mut kept, values, some);
            *values = kept;
        }
        keep(&mut self.id, count, some.clone());
        keep(&mut self.material, count, some.clone());
        self.position.keep(count, some.clone());
        self.velocity.keep(count, some.clone());
        self.angular_velocity.keep(count, some.clone());
        if let Some(orientation) = &mut self.orientation {
            keep(orientation, count, some.clone());
        }
        if self.beside_loads.is_empty() {
            self.load.keep(count, some.clone());
        } else {
            keep(&mut self.beside_loads, count, some.clone());
        }
        if !self.half_kicks.0.is_empty() {
            keep(&mut self.half_kicks.0, count, some.clone());
        }
        if !self.higher.is_empty() {
            keep(&mut self.higher, count, some);
        }
    }
}

/// Bytes that an empty list has in spare at least, when memory is set aside for it.
const SPARE: usize = 64;

/// What becomes of memory that an empty list has set aside beyond what it needs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Beyond {
    /// It stays.
    Kept,
    /// It is given back where it is much.
    GivenBack,
}

/// Sets memory aside for so many in an empty list, with little more: pushed one by one, a list takes up to twice as much. Sizes are
/// a few dozen for each factor of two, so that what one list leaves suits another.
pub(crate) fn make_room<T>(list: &mut Vec<T>, count: usize, beyond: Beyond) {
    assert!(list.is_empty());
    let step = (count.next_power_of_two() / 64).max(SPARE / size_of::<T>()).max(1);
    if beyond == Beyond::GivenBack && list.capacity() > count + 4 * step {
        *list = Vec::new();
    }
    if list.capacity() < count {
        list.reserve_exact((count + step).next_multiple_of(step));
    }
}

/// Bytes that a list has set aside, in use or not.
pub(crate) fn set_aside<T>(list: &Vec<T>) -> usize {
    list.capacity() * size_of::<T>()
}

/// Moment of inertia of a sphere about its centre [kg m^2].
#[inline(always)]
fn inertia(mass: f64, radius: f64) -> f64 {
    0.4 * mass * radius * radius
}
