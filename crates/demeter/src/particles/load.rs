//! What acts on a grain.

use bytemuck::{Pod, Zeroable};
use glam::DVec3;
use serde::{Deserialize, Serialize};

/// Force [N] and torque [N m], each with 0 behind it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, Pod, Zeroable)]
#[repr(C, align(64))]
pub struct Load(pub(crate) [f64; 8]);

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

    /// Adds another load.
    pub(crate) fn add(&mut self, other: &Self) {
        self.0.iter_mut().zip(other.0).for_each(|(sum, more)| *sum += more);
    }

    /// Force and torque, each with 0 behind it.
    #[inline(always)]
    pub(crate) fn parts(&self) -> [&[f64; 4]; 2] {
        let [force, torque] = self.0.as_chunks().0 else {
            return [&[0.0; 4]; 2];
        };
        [force, torque]
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
