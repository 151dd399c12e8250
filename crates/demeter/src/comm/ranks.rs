//! What processes that share a run tell each other.

use std::fmt::Debug;

/// The processes (ranks) of a run, as one of them sees them.
///
/// Every rank calls the same methods in the same order, but for [`Ranks::tell`], [`Ranks::hear`] and [`Ranks::swap`]: each call waits for all
/// others. What is told is bytes, so that nothing is rounded or added up on the way: all sums are made by the engine, in an order that
/// does not depend on the ranks.
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

    /// Tells one other rank some bytes, and hears what it tells at the same time.
    fn swap(&self, rank: usize, mine: &[u8]) -> Vec<u8>;

    /// Notes that ranks begin to tell each other two by two what all come to know.
    fn begin_round(&self);

    /// From now on waits for others as long as it takes, or no longer than it would otherwise.
    fn be_patient(&self, _is_patient: bool) {}

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
    /// Times that something was told to all, or that all came to know something two by two.
    pub rounds: u64,
    /// Bytes told to all.
    pub round_bytes: u64,
    /// Bytes told two by two, so that all come to know something.
    pub joined_bytes: u64,
    /// Bytes told to one other process that gathers what all have.
    pub gathered_bytes: u64,
    /// Time spent on sending, receiving and waiting for others [s].
    pub seconds: f64,
}
