//! Sum per grain over its contacts, in the order of the partner's id.

use super::{ContactChunk, Contacts, Load};
use crate::neighbours::Neighbours;
use glam::DVec3;

/// Force [N] and torque [N m] of all contacts on one grain.
pub type GrainLoad = (DVec3, DVec3);

/// Force and torque of all contacts on one grain.
pub fn contact_load(grain: usize, neighbours: &Neighbours, contacts: &Contacts) -> GrainLoad {
    sum_of(grain, neighbours, &contacts.pairs, 0, &contacts.walls)
}

/// Force and torque of all contacts on one grain; `pairs` are chunks from `first_chunk` on, all that the grain has contacts
/// in among them.
#[inline(always)]
fn sum_of(
    grain: usize,
    neighbours: &Neighbours,
    pairs: &[ContactChunk],
    first_chunk: usize,
    walls: &[ContactChunk],
) -> GrainLoad {
    let mut sum = Sum::default();
    for (chunk, slot, first) in neighbours.pairs_of(grain) {
        // whether a candidate is a contact cannot be foretold, so none is asked: no branch waits for memory here
        let chunk = &pairs[chunk - first_chunk];
        let place = chunk.load_place(slot);
        sum.add(&chunk.load[place], first);
        if let Some(&torque) = chunk.rolling.get(place) {
            sum.roll(torque, first);
        }
    }
    for (chunk, slot) in neighbours.wall_pairs_of(grain) {
        let chunk = &walls[chunk];
        for k in chunk.contacts_of(slot) {
            sum.add(&chunk.load[k + 1], true);
            if let Some(&torque) = chunk.rolling.get(k + 1) {
                sum.roll(torque, true);
            }
        }
    }
    sum.result()
}

/// A stretch of the table of contacts that one task works on, and the grains that are its own.
///
/// Grains lie in memory as their contacts do, so soon after its last contact a grain is summed up while the loads are still
/// in the cache. A grain with contacts in other stretches is left to the kick.
pub(crate) struct Stretch<'a> {
    pub(crate) chunks: &'a mut [ContactChunk],
    pub(crate) first_chunk: usize,
    /// Sums of its grains; none of those that are left.
    pub(crate) sums: &'a mut [Option<GrainLoad>],
    pub(crate) first_grain: usize,
}

impl<'a> Stretch<'a> {
    /// Works on the chunks, in parallel in `parts`: how the table is cut changes no sum.
    pub(crate) fn work(
        self,
        parts: usize,
        neighbours: &Neighbours,
        walls: &[ContactChunk],
        step: &(impl Fn(usize, &mut ContactChunk) + Sync),
    ) {
        if parts < 2 || self.chunks.len() < 2 {
            return self.work_alone(neighbours, walls, step);
        }
        let (one, other) = self.cut(parts, neighbours);
        rayon::join(
            || one.work(parts / 2, neighbours, walls, step),
            || other.work(parts - parts / 2, neighbours, walls, step),
        );
    }

    fn cut(self, parts: usize, neighbours: &Neighbours) -> (Self, Self) {
        let middle = (self.chunks.len() * (parts / 2) / parts).max(1);
        let (chunks, other_chunks) = self.chunks.split_at_mut(middle);
        let first = neighbours.chunk(self.first_chunk + middle).0.first();
        let grain = first.map_or(0, |pair| pair.i.min(pair.j) as usize);
        let grains = grain.saturating_sub(self.first_grain).min(self.sums.len());
        let (sums, other_sums) = self.sums.split_at_mut(grains);
        let one = Self {
            chunks,
            first_chunk: self.first_chunk,
            sums,
            first_grain: self.first_grain,
        };
        let other = Self {
            chunks: other_chunks,
            first_chunk: self.first_chunk + middle,
            sums: other_sums,
            first_grain: self.first_grain + grains,
        };
        (one, other)
    }

    fn work_alone(self, neighbours: &Neighbours, walls: &[ContactChunk], step: &impl Fn(usize, &mut ContactChunk)) {
        let mut next = 0;
        for c in 0..self.chunks.len() {
            step(self.first_chunk + c, &mut self.chunks[c]);
            let done = self.first_chunk + c;
            while next < self.sums.len() {
                let grain = self.first_grain + next;
                let (lowest, highest) = neighbours.span_of(grain);
                if highest > done {
                    break;
                }
                self.sums[next] = (lowest >= self.first_chunk)
                    .then(|| sum_of(grain, neighbours, self.chunks, self.first_chunk, walls));
                next += 1;
            }
        }
        self.sums[next..].fill(None);
    }
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
