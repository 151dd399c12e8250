//! Sum per grain over its contacts, in the order of the partner's id.

use super::{Contacts, Load};
use crate::neighbours::Neighbours;
use glam::DVec3;

/// Force [N] and torque [N m] of all contacts on one grain.
#[inline(always)]
pub fn contact_load(grain: usize, neighbours: &Neighbours, contacts: &Contacts) -> (DVec3, DVec3) {
    let mut sum = Sum::default();
    for (chunk, slot, first) in neighbours.pairs_of(grain) {
        let chunk = &contacts.pairs[chunk];
        for k in chunk.contacts_of(slot) {
            sum.add(&chunk.load[k], first);
            if let Some(&torque) = chunk.rolling.get(k) {
                sum.roll(torque, first);
            }
        }
    }
    for (chunk, slot) in neighbours.wall_pairs_of(grain) {
        let chunk = &contacts.walls[chunk];
        for k in chunk.contacts_of(slot) {
            sum.add(&chunk.load[k], true);
            if let Some(&torque) = chunk.rolling.get(k) {
                sum.roll(torque, true);
            }
        }
    }
    sum.result()
}

/// Force and negative torque so far; the fourth numbers mean nothing.
#[derive(Default)]
struct Sum {
    force: [f64; 4],
    torque: [f64; 4],
}

impl Sum {
    #[inline(always)]
    fn add(&mut self, load: &Load, first: bool) {
        let (sign, lever) = if first {
            (1.0, load.force[3])
        } else {
            (-1.0, load.arm[3])
        };
        for axis in 0..4 {
            self.force[axis] += sign * load.force[axis];
            self.torque[axis] += lever * load.arm[axis];
        }
    }

    #[inline(always)]
    fn roll(&mut self, torque: DVec3, first: bool) {
        let sign = if first { -1.0 } else { 1.0 };
        for (sum, torque) in self.torque.iter_mut().zip(torque.to_array()) {
            *sum += sign * torque;
        }
    }

    #[inline(always)]
    fn result(self) -> (DVec3, DVec3) {
        let ([fx, fy, fz, _], [tx, ty, tz, _]) = (self.force, self.torque);
        // 0 - x, so that no torque has no sign
        (DVec3::new(fx, fy, fz), DVec3::ZERO - DVec3::new(tx, ty, tz))
    }
}
