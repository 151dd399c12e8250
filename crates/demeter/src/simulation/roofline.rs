//! How far a run is from what the machine could do: bytes that must move and operations that must be done, over what memory
//! and processor were measured to do.

use crate::contacts::Contacts;
use crate::materials::Materials;
use crate::neighbours::Neighbours;
use crate::particles::{Grains, HalfKick, HigherDerivatives, Load, Row};
use demeter_physics::contact::PairLaw;
use demeter_physics::geometry::contact_sphere_sphere::Contact;
use demeter_physics::lanes::{self, Instructions, Kernel, Lanes};
use glam::{DQuat, Vec3};
use rayon::prelude::*;
use serde::Serialize;
use std::hint::black_box;
use std::time::Instant;

/// Operations on `f64` of one grain in one step: body force and two half kicks (26), whether all is finite (15), drift and bounds
/// (42). Here and below sums, products, quotients, roots and comparisons count as one each.
const OPERATIONS_PER_GRAIN: f64 = 83.0;

/// Of one grain whose orientation is followed: the turn of a step.
const OPERATIONS_PER_TURN: f64 = 69.0;

/// Of one contact whatever its laws: geometry (16), motion of the two surfaces against each other (57), load (15), and what
/// both grains sum up (32).
const OPERATIONS_PER_CONTACT: f64 = 120.0;

/// Of a normal law: a stiffening spring and its dashpot over the window of a step, as `hertz-tsuji` has them.
const OPERATIONS_OF_NORMAL_LAW: f64 = 30.0;

/// Of a tangential law: a spring that is carried along, loaded, cut at the limit and booked, as `mindlin-history` is.
const OPERATIONS_OF_TANGENTIAL_LAW: f64 = 110.0;

/// Of a rolling law: the same spring, as `epsd` is, and how the bodies roll on each other.
const OPERATIONS_OF_ROLLING_LAW: f64 = 135.0;

/// Operations of one contact under the laws of a pair.
fn operations_per_contact(law: &PairLaw) -> f64 {
    let mut sum = OPERATIONS_PER_CONTACT + OPERATIONS_OF_NORMAL_LAW;
    if law.tangential.is_some() {
        sum += OPERATIONS_OF_TANGENTIAL_LAW;
    }
    if law.rolling.is_some() {
        sum += OPERATIONS_OF_ROLLING_LAW;
    }
    sum
}

/// What one step works on, or the sum of it over steps.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Work {
    /// Grains.
    pub grains: u64,
    /// Candidate pairs of grains.
    pub candidates: u64,
    /// Contacts between grains in the table, those without force counted.
    pub contacts: u64,
    /// Candidate pairs of grain and wall.
    pub wall_candidates: u64,
    /// Contacts with walls in the table.
    pub wall_contacts: u64,
    /// Operations that the contacts need.
    operations: f64,
}

impl Work {
    pub(super) fn of(grains: &Grains, contacts: &Contacts, neighbours: &Neighbours, materials: &Materials) -> Self {
        let mut work = Self {
            grains: grains.len() as u64,
            candidates: neighbours.pair_count() as u64,
            wall_candidates: neighbours.wall_pair_count() as u64,
            ..Self::default()
        };
        for (c, chunk) in contacts.pairs.iter().enumerate() {
            work.contacts += chunk.len() as u64;
            work.operations += chunk.len() as f64 * operations_per_contact(materials.law(neighbours.chunk(c).1));
        }
        for (c, chunk) in contacts.walls.iter().enumerate() {
            work.wall_contacts += chunk.len() as u64;
            work.operations += chunk.len() as f64 * operations_per_contact(materials.law(neighbours.wall_chunk(c).1));
        }
        work
    }

    pub(super) fn add(&mut self, other: &Self) {
        self.grains += other.grains;
        self.candidates += other.candidates;
        self.contacts += other.contacts;
        self.wall_candidates += other.wall_candidates;
        self.wall_contacts += other.wall_contacts;
        self.operations += other.operations;
    }

    /// What the work needs at least: every pass of a step reads and writes each row of its tables once, nothing stays in
    /// the cache from one pass to the next, and everything does from one use to the next within a pass. Searches for
    /// candidates and for contacts are left out.
    ///
    /// With `G` grains, `C` contacts (with grains and walls), `W` of them with walls, and `h` values of history, bytes are
    ///
    /// `G (motion + contacts) + C (2 (h + 1) 8 + bodies + tangential force) + W (element + geometry)`
    ///
    /// | term | bytes | of |
    /// |---|---|---|
    /// | motion: kick and drift in one pass | 312 | position, velocity, spin (32 each), half kick (24), read and written; mass, load (64) |
    /// | motion: in two, as with custom forces or in a box that deforms | 568 | in the drift all but mass, half kick written only; in the kick velocity, spin and load read and written, half kick, mass |
    /// | orientation, where it is followed | 64 | read and written |
    /// | contacts | 224 | rows of position, velocity, spin; the load (64, read and written) |
    /// | element, geometry | 4 + 48 | of the wall; written |
    /// | history, normal force | 16 h + 16 | read and written |
    /// | bodies | 8 | both grains |
    /// | tangential force | 12 | written; as much more where some law resists rolling |
    ///
    /// Steps after which something looks at the grains take two passes, too; they are counted as the others. Gear's corrector also reads
    /// and writes the derivatives in both passes, and place and orientation in the second.
    pub(super) fn needs(&self, stride: usize, rolls: bool, (passes, turns): (Passes, bool)) -> Needs {
        let (row, turn) = (size_of::<Row>(), if turns { size_of::<DQuat>() } else { 0 });
        let (load, half_kick, mass) = (size_of::<Load>(), size_of::<HalfKick>(), size_of::<f64>());
        let contacts = 3 * row + 2 * load;
        let drift = 2 * (3 * row + turn) + load + half_kick;
        let joined = drift + half_kick + mass;
        let apart = drift + 2 * (2 * row + load) + half_kick + mass;
        let motion = match passes {
            Passes::Joined => joined,
            Passes::Apart => apart,
            Passes::Gear => apart - 2 * half_kick + 4 * size_of::<HigherDerivatives>() + 2 * (row + turn),
        };
        let per_grain = motion + contacts;
        let at_wall = size_of::<u32>() + size_of::<Contact>();
        let rolling = if rolls { size_of::<Vec3>() } else { 0 };
        let history = 2 * (stride + 1) * size_of::<f64>();
        let per_contact = history + 2 * size_of::<u32>() + size_of::<Vec3>() + rolling;
        let product = |count: u64, each: usize| count as f64 * each as f64;
        Needs {
            bytes: product(self.grains, per_grain)
                + product(self.contacts + self.wall_contacts, per_contact)
                + product(self.wall_contacts, at_wall),
            operations: self.operations
                + self.grains as f64 * (OPERATIONS_PER_GRAIN + if turns { OPERATIONS_PER_TURN } else { 0.0 }),
        }
    }
}

/// In which passes grains move.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Passes {
    /// The kick that ends a step and the drift that begins the next in one.
    Joined,
    /// Each by itself.
    Apart,
    /// Gear's prediction and correction.
    Gear,
}

/// What work needs at least.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Needs {
    /// Bytes moved between memory and processor.
    pub(super) bytes: f64,
    /// Operations on `f64`.
    pub(super) operations: f64,
}

/// What the machine was measured to do on all threads of the pool.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Machine {
    /// Bytes per second between memory and processor: the triad `a = b + s c` over arrays beyond the caches [1/s].
    pub bandwidth: f64,
    /// Sums and products of `f64` per second, none of them fused, with the instructions of the run [1/s].
    pub operations: f64,
}

/// Numbers in each array of the triad: 32 MiB.
const TRIAD_LENGTH: usize = 4 << 20;
const TRIAD_TASK: usize = 1 << 16;
const ROUNDS: usize = 4;

impl Machine {
    /// Measures for some hundredths of a second, on the threads at hand; the best of some rounds counts.
    pub(super) fn measure(instructions: Instructions) -> Self {
        Self {
            bandwidth: triad(),
            operations: multiply_and_add(instructions),
        }
    }
}

/// The least time of some rounds [s].
fn fastest(mut round: impl FnMut()) -> f64 {
    let times = (0..ROUNDS).map(|_| {
        let begun = Instant::now();
        round();
        begun.elapsed().as_secs_f64()
    });
    times.fold(f64::INFINITY, f64::min).max(1e-9)
}

/// Bytes per second of the triad.
fn triad() -> f64 {
    let (mut a, b, c) = (
        vec![0.0; TRIAD_LENGTH],
        vec![1.0; TRIAD_LENGTH],
        vec![2.0; TRIAD_LENGTH],
    );
    let scale = black_box(0.5);
    let seconds = fastest(|| {
        let tasks = (
            a.par_chunks_mut(TRIAD_TASK),
            b.par_chunks(TRIAD_TASK),
            c.par_chunks(TRIAD_TASK),
        );
        tasks.into_par_iter().for_each(|(a, b, c)| {
            for ((a, b), c) in a.iter_mut().zip(b).zip(c) {
                *a = b + scale * c;
            }
        });
        black_box(&a);
    });
    (3 * TRIAD_LENGTH * size_of::<f64>()) as f64 / seconds
}

/// Chains of products and sums that do not wait for each other; as many as registers hold.
const CHAINS: usize = 12;
const LINKS: usize = 40_000;

struct MultiplyAndAdd;

impl Kernel for MultiplyAndAdd {
    /// Operations done.
    type Output = usize;

    #[inline(always)]
    fn run<L: Lanes>(self) -> usize {
        let (factor, term) = (L::splat(black_box(0.999)), L::splat(black_box(1e-3)));
        let mut chains = [L::splat(black_box(1.0)); CHAINS];
        for _ in 0..LINKS {
            let mut chain = 0;
            while chain < CHAINS {
                chains[chain] = chains[chain] * factor + term;
                chain += 1;
            }
        }
        let mut sum = chains[0];
        for chain in &chains[1..] {
            sum = sum + *chain;
        }
        black_box(sum);
        2 * LINKS * CHAINS * L::COUNT
    }
}

/// Operations per second.
fn multiply_and_add(instructions: Instructions) -> f64 {
    let mut operations = 0;
    let seconds = fastest(|| {
        let done = rayon::broadcast(|_| lanes::run(instructions, MultiplyAndAdd));
        operations = done.into_iter().sum();
    });
    operations as f64 / seconds
}

/// A run against what the machine could do. Per particle-step: over one grain and one step.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Roofline {
    /// What the machine can do.
    pub machine: Machine,
    /// Candidate pairs of grains, per grain, as the mean over the run.
    pub candidates_per_grain: f64,
    /// Contacts in the table, with grains and walls, per grain.
    pub contacts_per_grain: f64,
    /// Bytes that must move per particle-step.
    pub bytes: f64,
    /// Operations per particle-step.
    pub operations: f64,
    /// Time of the steps per particle-step, without output in ns.
    pub ns: f64,
    /// Time that moving the bytes takes alone in ns.
    pub memory_ns: f64,
    /// Time that the operations take alone in ns.
    pub operations_ns: f64,
    /// How many times the time that memory alone would need the steps took. Below 1 where the tables stay in the cache.
    pub times_memory: f64,
    /// How many times the time that the operations alone would need the steps took.
    pub times_operations: f64,
}

impl Roofline {
    pub(super) fn new(work: &Work, needs: Needs, machine: Machine, seconds: f64) -> Self {
        let grains = work.grains.max(1) as f64;
        let (bytes, operations) = (needs.bytes / grains, needs.operations / grains);
        let ns = seconds * 1e9 / grains;
        let (memory_ns, operations_ns) = (bytes / machine.bandwidth * 1e9, operations / machine.operations * 1e9);
        Self {
            machine,
            candidates_per_grain: work.candidates as f64 / grains,
            contacts_per_grain: (work.contacts + work.wall_contacts) as f64 / grains,
            bytes,
            operations,
            ns,
            memory_ns,
            operations_ns,
            times_memory: ns / memory_ns,
            times_operations: ns / operations_ns,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_of_bytes_is_that_of_the_documentation() {
        let of = |work: Work, stride| work.needs(stride, false, (Passes::Joined, false)).bytes;
        let one = |set: fn(&mut Work)| {
            let mut work = Work::default();
            set(&mut work);
            work
        };
        let grain = one(|w| w.grains = 1);
        assert_eq!(of(grain, 4), 312.0 + 224.0);
        assert_eq!(grain.needs(4, false, (Passes::Apart, true)).bytes, 568.0 + 64.0 + 224.0);
        let contact = one(|w| w.contacts = 1);
        assert_eq!(of(contact, 4), 16.0 * 4.0 + 16.0 + 8.0 + 12.0);
        assert_eq!(of(one(|w| w.wall_contacts = 1), 4), of(contact, 4) + 52.0);
        assert_eq!(
            contact.needs(4, true, (Passes::Joined, false)).bytes,
            of(contact, 4) + 12.0
        );
    }

    #[test]
    fn the_machine_does_something() {
        for instructions in Instructions::available() {
            let machine = Machine::measure(instructions);
            // slower than any machine that runs this, faster than none
            assert!((1e8..1e14).contains(&machine.bandwidth), "{machine:?}");
            assert!((1e7..1e15).contains(&machine.operations), "{machine:?}");
        }
    }
}
