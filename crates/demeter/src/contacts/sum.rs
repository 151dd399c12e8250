//! Sum per grain over its contacts, in the order of the partner's id.

use super::{CHUNK, ContactChunk, Contacts, Load};
use crate::neighbours::Neighbours;
use demeter_physics::lanes::{self, Four, Instructions, Kernel, Lanes, Quad};
use glam::DVec3;

/// Force [N] and torque [N m] of all contacts on one grain, with nothing beside them.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub(crate) struct GrainLoad {
    pub(crate) force: [f64; 4],
    pub(crate) torque: [f64; 4],
}

impl GrainLoad {
    /// Of a grain that was not summed up; one whose force is not a number is summed up again in vain.
    const UNKNOWN: Self = Self {
        force: [f64::NAN, 0.0, 0.0, 0.0],
        torque: [0.0; 4],
    };

    /// Force and torque.
    pub(crate) fn vectors(&self) -> (DVec3, DVec3) {
        let ([fx, fy, fz, _], [tx, ty, tz, _]) = (self.force, self.torque);
        (DVec3::new(fx, fy, fz), DVec3::new(tx, ty, tz))
    }

    /// Whether it was summed up.
    #[inline(always)]
    pub(crate) fn is_known(&self) -> bool {
        !self.force[0].is_nan()
    }
}

/// Where a contact of a grain lies, and on which side of it the grain is.
#[derive(Clone, Copy, Debug, Default)]
struct Place(u32);

const PLACE_BITS: u32 = (CHUNK + 1).next_power_of_two().trailing_zeros();

impl Place {
    #[inline(always)]
    fn new(chunk: usize, load: usize, is_first: bool) -> Self {
        Self((chunk << (PLACE_BITS + 1) | load << 1) as u32 | u32::from(!is_first))
    }

    #[inline(always)]
    fn chunk(self) -> usize {
        (self.0 >> (PLACE_BITS + 1)) as usize
    }

    #[inline(always)]
    fn load(self) -> usize {
        (self.0 >> 1) as usize & ((1 << PLACE_BITS) - 1)
    }

    /// 0 where the grain is the first, 1 where it is the second.
    #[inline(always)]
    fn side(self) -> usize {
        (self.0 & 1) as usize
    }
}

/// Sums of the contact loads of this step.
#[derive(Debug, Default)]
pub(crate) struct Sums {
    loads: Vec<GrainLoad>,
    /// Contacts of every grain, in the order of the partner's id, where its candidates stand in their list; and how many.
    places: Vec<Place>,
    counts: Vec<u32>,
}

impl Sums {
    /// Everything that is summed up; `is_new` tells that the contacts are found anew. Their places are not part of a checkpoint.
    pub(crate) fn all<'a>(
        &'a mut self,
        chunks: &'a mut [ContactChunk],
        neighbours: &Neighbours,
        is_new: bool,
    ) -> Stretch<'a> {
        self.loads.resize(neighbours.reference.len(), GrainLoad::UNKNOWN);
        let is_new = is_new || self.places.len() != neighbours.entries();
        self.places.resize(neighbours.entries(), Place::default());
        self.counts.resize(neighbours.reference.len(), 0);
        Stretch {
            chunks,
            first_chunk: 0,
            sums: &mut self.loads,
            places: &mut self.places,
            counts: &mut self.counts,
            first_grain: 0,
            is_new,
        }
    }

    /// The sums of grains from `first` on; none where none were made.
    pub(crate) fn from(&self, first: usize) -> &[GrainLoad] {
        self.loads.get(first..).unwrap_or_default()
    }
}

/// Contacts that grains are summed up over.
#[derive(Clone, Copy)]
struct Loads<'a> {
    neighbours: &'a Neighbours,
    /// Chunks of pairs from `first_chunk` on.
    pairs: &'a [ContactChunk],
    first_chunk: usize,
    walls: &'a [ContactChunk],
}

/// Force and torque of all contacts on one grain.
pub(crate) fn contact_load(grain: usize, neighbours: &Neighbours, contacts: &Contacts) -> GrainLoad {
    let loads = Loads {
        neighbours,
        pairs: &contacts.pairs,
        first_chunk: 0,
        walls: &contacts.walls,
    };
    let mut sum = Sum::<Four>::default();
    for (chunk, slot, is_first) in neighbours.pairs_of(grain) {
        let chunk = &contacts.pairs[chunk];
        let place = chunk.load_place(slot);
        sum.add(&chunk.load[place], usize::from(!is_first));
        if let Some(torque) = chunk.rolling.get(place) {
            sum.roll(torque, usize::from(!is_first));
        }
    }
    loads.add_walls(grain, &mut sum);
    sum.result()
}

/// Entries ahead of which loads are fetched, as memory is slow.
const AHEAD: usize = 24;

/// Sums up grains that lie behind each other; those with contacts in chunks before the first are left.
struct SumUp<'a> {
    from: Loads<'a>,
    first_grain: usize,
    sums: &'a mut [GrainLoad],
    /// The places of their contacts, how many there are, and whether they have to be found.
    places: &'a mut [Place],
    counts: &'a mut [u32],
    are_new: bool,
}

impl Kernel for SumUp<'_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self) {
        let Self {
            from,
            first_grain,
            sums,
            places,
            counts,
            are_new,
        } = self;
        let (neighbours, first_chunk) = (from.neighbours, from.first_chunk);
        let rolls = from.pairs.first().is_some_and(|chunk| !chunk.rolling.is_empty());
        let mut begin = 0;
        for (k, (load, held)) in sums.iter_mut().zip(counts).enumerate() {
            let grain = first_grain + k;
            let entries = neighbours.entries_of(grain);
            let end = begin + entries.len();
            if neighbours.span_of(grain).0 < first_chunk {
                *load = GrainLoad::UNKNOWN;
                begin = end;
                continue;
            }
            if are_new {
                let mut found = begin;
                for entry in entries {
                    let (chunk, slot, is_first) = neighbours.entry(entry);
                    let load = from.pairs[chunk - first_chunk].load_place(slot);
                    // put in any case, and kept where it is a contact: which are cannot be foretold
                    places[found] = Place::new(chunk, load, is_first);
                    found += usize::from(load > 0);
                }
                *held = (found - begin) as u32;
            }
            let mut sum = Sum::<L::Quad>::default();
            for n in begin..begin + *held as usize {
                if let Some(soon) = places.get(n + AHEAD)
                    && let Some(chunk) = from.pairs.get(soon.chunk().wrapping_sub(first_chunk))
                    && let Some(load) = chunk.load.get(soon.load())
                {
                    lanes::prefetch(load);
                }
                let place = places[n];
                let chunk = &from.pairs[place.chunk() - first_chunk];
                sum.add(&chunk.load[place.load()], place.side());
                if rolls {
                    sum.roll(&chunk.rolling[place.load()], place.side());
                }
            }
            if neighbours.wall_pairs_of(grain).len() > 0 {
                from.add_walls(grain, &mut sum);
            }
            *load = sum.result();
            begin = end;
        }
    }
}

impl Loads<'_> {
    /// Adds the contacts with walls to those between grains.
    #[inline(always)]
    fn add_walls<Q: Quad>(&self, grain: usize, sum: &mut Sum<Q>) {
        for (chunk, slot) in self.neighbours.wall_pairs_of(grain) {
            let chunk = &self.walls[chunk];
            for k in chunk.contacts_of(slot) {
                sum.add(&chunk.load[k + 1], 0);
                if let Some(torque) = chunk.rolling.get(k + 1) {
                    sum.roll(torque, 0);
                }
            }
        }
    }
}

/// Force and negative torque so far.
struct Sum<Q> {
    force: Q,
    arms: Q,
}

impl<Q: Quad> Default for Sum<Q> {
    #[inline(always)]
    fn default() -> Self {
        Self {
            force: Q::all(0.0),
            arms: Q::all(0.0),
        }
    }
}

impl<Q: Quad> Sum<Q> {
    /// Adds what a contact does to its first body (0) or its second (1).
    #[inline(always)]
    fn add(&mut self, load: &Load, side: usize) {
        let (sign, lever) = ([1.0, -1.0][side], load.lever(side));
        self.force = self.force + Q::load(&load.force) * Q::all(sign);
        self.arms = self.arms + Q::load(&load.arm) * Q::all(lever);
    }

    /// Adds the torque of a rolling law on the first body.
    #[inline(always)]
    fn roll(&mut self, torque: &[f64; 4], side: usize) {
        self.arms = self.arms + Q::load(torque) * Q::all([-1.0, 1.0][side]);
    }

    #[inline(always)]
    fn result(self) -> GrainLoad {
        let vectors = Q::load(&[1.0, 1.0, 1.0, 0.0]);
        GrainLoad {
            force: (self.force * vectors).store(),
            // 0 - x, so that no torque has no sign
            torque: (Q::all(0.0) - self.arms * vectors).store(),
        }
    }
}

/// A stretch of the table of contacts that one task works on, and the grains that are its own.
///
/// Grains lie in memory as their contacts do, so soon after its last contact a grain is summed up while the loads are still
/// in the cache. A grain with contacts in other stretches is left to the kick.
pub(crate) struct Stretch<'a> {
    chunks: &'a mut [ContactChunk],
    first_chunk: usize,
    /// Sums of its grains; not known of those that are left.
    sums: &'a mut [GrainLoad],
    places: &'a mut [Place],
    counts: &'a mut [u32],
    first_grain: usize,
    is_new: bool,
}

impl<'a> Stretch<'a> {
    /// Works on the chunks, in parallel in `parts`: how the table is cut changes no sum.
    pub(crate) fn work(
        self,
        parts: usize,
        neighbours: &Neighbours,
        walls: &[ContactChunk],
        instructions: Instructions,
        step: &(impl Fn(usize, &mut ContactChunk) + Sync),
    ) {
        if parts < 2 || self.chunks.len() < 2 {
            return self.work_alone(neighbours, walls, instructions, step);
        }
        let (one, other) = self.cut(parts, neighbours);
        rayon::join(
            || one.work(parts / 2, neighbours, walls, instructions, step),
            || other.work(parts - parts / 2, neighbours, walls, instructions, step),
        );
    }

    fn cut(self, parts: usize, neighbours: &Neighbours) -> (Self, Self) {
        let middle = (self.chunks.len() * (parts / 2) / parts).max(1);
        let (chunks, other_chunks) = self.chunks.split_at_mut(middle);
        let first = neighbours.chunk(self.first_chunk + middle).0.first();
        let grain = first.map_or(0, |pair| pair.i.min(pair.j) as usize);
        let grains = grain.saturating_sub(self.first_grain).min(self.sums.len());
        let (sums, other_sums) = self.sums.split_at_mut(grains);
        let entries: usize = (self.first_grain..self.first_grain + grains)
            .next_back()
            .map_or(0, |last| {
                neighbours.entries_of(last).end - neighbours.entries_of(self.first_grain).start
            });
        let (places, other_places) = self.places.split_at_mut(entries);
        let (counts, other_counts) = self.counts.split_at_mut(grains);
        let one = Self {
            chunks,
            sums,
            places,
            counts,
            ..self
        };
        let other = Self {
            chunks: other_chunks,
            first_chunk: self.first_chunk + middle,
            sums: other_sums,
            places: other_places,
            counts: other_counts,
            first_grain: self.first_grain + grains,
            is_new: self.is_new,
        };
        (one, other)
    }

    fn work_alone(
        self,
        neighbours: &Neighbours,
        walls: &[ContactChunk],
        instructions: Instructions,
        step: &impl Fn(usize, &mut ContactChunk),
    ) {
        let Self {
            chunks,
            first_chunk,
            sums,
            mut places,
            counts,
            first_grain,
            is_new,
        } = self;
        let mut next = 0;
        for c in 0..chunks.len() {
            step(first_chunk + c, &mut chunks[c]);
            let (begin, mut entries) = (next, 0);
            while next < sums.len() && neighbours.span_of(first_grain + next).1 <= first_chunk + c {
                entries += neighbours.entries_of(first_grain + next).len();
                next += 1;
            }
            let from = Loads {
                neighbours,
                pairs: chunks,
                first_chunk,
                walls,
            };
            let (these, others) = places.split_at_mut(entries);
            let sum_up = SumUp {
                from,
                first_grain: first_grain + begin,
                sums: &mut sums[begin..next],
                places: these,
                counts: &mut counts[begin..next],
                are_new: is_new,
            };
            lanes::run(instructions, sum_up);
            places = others;
        }
        sums[next..].fill(GrainLoad::UNKNOWN);
    }
}
