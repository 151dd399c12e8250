//! Order of the grains along a space-filling curve, so that neighbours in space are neighbours in memory.

use crate::particles::Grains;
use glam::DVec3;

/// Bits per direction of the Morton code.
const BITS: u32 = 10;

/// Indices of the grains along a Z-order (Morton) curve; ties keep the order of the ids.
pub fn space_filling_order(grains: &Grains) -> Vec<u32> {
    let (mut lower, mut upper) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    for &p in grains.position.iter() {
        lower = lower.min(p);
        upper = upper.max(p);
    }
    let edge = (upper - lower).max_element();
    let scale = if edge > 0.0 {
        f64::from((1 << BITS) - 1) / edge
    } else {
        0.0
    };
    let mut keyed: Vec<(u32, u32, u32)> = (0..grains.len())
        .map(|g| {
            let p = (grains.position[g] - lower) * scale;
            (
                spread(p.x as u32) | spread(p.y as u32) << 1 | spread(p.z as u32) << 2,
                grains.id[g],
                g as u32,
            )
        })
        .collect();
    keyed.sort_unstable();
    keyed.into_iter().map(|(_, _, g)| g).collect()
}

/// Spreads ten bits so that two free bits follow each.
fn spread(x: u32) -> u32 {
    let mut x = x & 0x3ff;
    x = (x | x << 16) & 0x0300_00ff;
    x = (x | x << 8) & 0x0300_f00f;
    x = (x | x << 4) & 0x030c_30c3;
    (x | x << 2) & 0x0924_9249
}
