//! Sum per grain over its contacts, in the order of the partner's id.

use super::{Contacts, Load};
use crate::neighbours::Neighbours;
use glam::DVec3;

/// Force [N] and torque [N m] of all contacts on one grain.
#[inline(always)]
pub fn contact_load(grain: usize, neighbours: &Neighbours, contacts: &Contacts) -> (DVec3, DVec3) {
    let mut sum = Sum::default();
    for (chunk, slot, first) in neighbours.pairs_of(grain) {
        // whether a candidate is a contact cannot be foretold, so none is asked: no branch waits for memory here
        let chunk = &contacts.pairs[chunk];
        let place = chunk.load_place(slot);
        sum.add(&chunk.load[place], first);
        if let Some(&torque) = chunk.rolling.get(place) {
            sum.roll(torque, first);
        }
    }
    for (chunk, slot) in neighbours.wall_pairs_of(grain) {
        let chunk = &contacts.walls[chunk];
        for k in chunk.contacts_of(slot) {
            sum.add(&chunk.load[k + 1], true);
            if let Some(&torque) = chunk.rolling.get(k + 1) {
                sum.roll(torque, true);
            }
        }
    }
    sum.result()
}

/// Force and negative torque so far.
#[derive(Default)]
struct Sum {
    fx: f64,
    fy: f64,
    fz: f64,
    tx: f64,
    ty: f64,
    tz: f64,
}

impl Sum {
    #[inline(always)]
    fn add(&mut self, load: &Load, first: bool) {
        let [fx, fy, fz, lever_i] = load.force;
        let [ax, ay, az, lever_j] = load.arm;
        let (sign, lever) = if first { (1.0, lever_i) } else { (-1.0, lever_j) };
        self.fx += sign * fx;
        self.fy += sign * fy;
        self.fz += sign * fz;
        self.tx += lever * ax;
        self.ty += lever * ay;
        self.tz += lever * az;
    }

    #[inline(always)]
    fn roll(&mut self, torque: DVec3, first: bool) {
        let sign = if first { -1.0 } else { 1.0 };
        self.tx += sign * torque.x;
        self.ty += sign * torque.y;
        self.tz += sign * torque.z;
    }

    #[inline(always)]
    fn result(self) -> (DVec3, DVec3) {
        // 0 - x, so that no torque has no sign
        (
            DVec3::new(self.fx, self.fy, self.fz),
            DVec3::new(0.0 - self.tx, 0.0 - self.ty, 0.0 - self.tz),
        )
    }
}
