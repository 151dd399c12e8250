//! What processes that share a run tell each other.

use std::fmt::Debug;

/// The processes (ranks) of a run, as one of them sees them.
///
/// Every rank calls the same methods in the same order, but for [`Ranks::tell`] and [`Ranks::hear`]: each call waits for all others. What is told is bytes, so that nothing
/// is rounded or added up on the way: all sums are made by the engine, in an order that does not depend on the ranks.
pub trait Ranks: Debug + Send + Sync {
    /// Number of this process, from 0.
    fn rank(&self) -> usize;

    /// Number of processes.
    fn count(&self) -> usize;

    /// Tells all others some bytes; answers with those of all, by rank, the own ones included.
    fn gather(&self, mine: &[u8]) -> Vec<Vec<u8>>;

    /// The same where all tell equally many bytes, one rank behind the other.
    fn gather_even(&self, mine: &[u8]) -> Vec<u8> {
        self.gather(mine).concat()
    }

    /// Tells some others some numbers, and hears from each of them as many as the message has room for; works while they are
    /// on their way. Whoever is told here hears on the other side.
    fn exchange(&self, messages: &mut [Message], meanwhile: &mut dyn FnMut());

    /// Tells one other rank some bytes, which hears them with [`Ranks::hear`]; what is told to it comes in that order.
    fn tell(&self, rank: usize, mine: &[u8]);

    /// Hears what another rank tells this one.
    fn hear(&self, rank: usize) -> Vec<u8>;

    /// The largest of what all ranks have, place by place; not a number where any is none.
    fn largest(&self, values: &mut [f64]) {
        let all = self.gather_even(bytemuck::cast_slice(values));
        let values_len = values.len();
        for (k, value) in values.iter_mut().enumerate() {
            let of_all = all.chunks_exact(8).skip(k).step_by(values_len);
            *value = of_all.map(bytemuck::pod_read_unaligned).fold(f64::NEG_INFINITY, larger);
        }
    }

    /// What this process has told others so far.
    fn traffic(&self) -> Traffic;

    /// Ends the job on all ranks, as what happened must not happen.
    fn give_up(&self, reason: &str) -> !;
}

/// What is told to another rank, and heard of it.
#[derive(Clone, Debug, Default)]
pub struct Message {
    /// The other rank.
    pub rank: usize,
    /// What it is told.
    pub tell: Vec<f64>,
    /// What it tells.
    pub hear: Vec<f64>,
}

/// What a process has told others so far.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Traffic {
    /// Messages to one other process.
    pub messages: u64,
    /// Bytes in them.
    pub bytes: u64,
    /// Times that something was told to all.
    pub rounds: u64,
    /// Bytes of that.
    pub round_bytes: u64,
    /// Bytes told to one other process that gathers what all have.
    pub gathered_bytes: u64,
    /// Time spent on sending, receiving and waiting for others [s].
    pub seconds: f64,
}

/// The larger of two numbers; not a number where one is none.
fn larger(one: f64, other: f64) -> f64 {
    if one.is_nan() || one > other { one } else { other }
}
