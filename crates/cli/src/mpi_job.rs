//! Ranks that are processes of an MPI job.

use demeter::comm::{Message, Ranks, Traffic};
use mpi::datatype::PartitionMut;
use mpi::environment::Universe;
use mpi::request::{Request, Scope, scope};
use mpi::topology::SimpleCommunicator;
use mpi::traits::{Communicator, CommunicatorCollectives, Destination, Source};
use mpi::{Count, Threading};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

/// Most bytes that all ranks together tell each other at once: MPI counts them with 31 bits.
const AT_ONCE: usize = 1 << 30;

/// Bytes that two processes swap in one message; what is beyond follows in others.
const IN_ONE: usize = 4096;

/// Looks in vain before the core is offered to others, and between two looks at the clock.
const LOOKS: u32 = 100;

/// Time that the launcher has to pass on what a process said last: that of MPICH drops what it has not read when one aborts.
const TO_BE_HEARD: Duration = Duration::from_millis(300);

/// Exit code of a job that was given up: what it could not read or write was another process.
const GIVEN_UP: i32 = 1;

/// Why an MPI job cannot begin.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum MpiError {
    /// MPI was begun before in this process.
    #[error("MPI was begun before in this process")]
    BegunBefore,
    /// The MPI of this machine does not let another thread than the first speak.
    #[error(
        "this MPI lets only the first thread of a process speak ({0}), and Demeter's threads take turns: use an Open MPI or \
         MPICH that was built with threads"
    )]
    Threads(String),
}

/// An MPI job that goes on until this is dropped.
pub struct MpiJob {
    _universe: Universe,
}

impl std::fmt::Debug for MpiJob {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "an MPI job")
    }
}

impl MpiJob {
    /// Begins.
    pub fn begin() -> Result<Self, MpiError> {
        let (universe, threading) =
            mpi::initialize_with_threading(Threading::Serialized).ok_or(MpiError::BegunBefore)?;
        if threading < Threading::Serialized {
            return Err(MpiError::Threads(format!("{threading:?}")));
        }
        Ok(Self { _universe: universe })
    }

    /// All processes of the job, which give up when one of them says nothing for so long; `tell` is told why before the job ends.
    pub fn ranks(&self, patience: Duration, tell: fn(&str)) -> MpiRanks {
        MpiRanks {
            patience,
            is_patient: AtomicBool::new(false),
            tell,
            traffic: Mutex::default(),
        }
    }

    /// Ends all processes of the job at once, with this exit code.
    pub fn abort(&self, code: i32) -> ! {
        abort(code)
    }
}

/// Ends all processes of the job, after the launcher has heard what this one said last.
fn abort(code: i32) -> ! {
    std::thread::sleep(TO_BE_HEARD);
    SimpleCommunicator::world().abort(code)
}

/// All processes of an MPI job.
#[derive(Debug)]
pub struct MpiRanks {
    patience: Duration,
    is_patient: AtomicBool,
    tell: fn(&str),
    traffic: Mutex<Traffic>,
}

impl MpiRanks {
    /// Waits for a request; gives up when nothing comes for too long.
    fn wait<'a, T: ?Sized, S: Scope<'a>>(&self, mut request: Request<'a, T, S>, what: &str) {
        let begun = Instant::now();
        let mut looks = 0u32;
        while let Err(again) = request.test() {
            request = again;
            looks += 1;
            if looks.is_multiple_of(LOOKS) {
                std::thread::yield_now();
                if begun.elapsed() > self.patience && !self.is_patient.load(Ordering::Relaxed) {
                    self.give_up(&format!(
                        "process {} has waited for {what} for {} s: another process is gone, stopped or lost its network. The \
                         latest checkpoint is whole; go on from it with `demeter resume`. Where processes are slow, let \
                         DEMETER_PATIENCE be more seconds",
                        self.rank(),
                        self.patience.as_secs()
                    ));
                }
            }
        }
    }

    fn note(&self, begun: Instant, note: impl FnOnce(&mut Traffic)) {
        let mut traffic = self.traffic.lock().unwrap_or_else(PoisonError::into_inner);
        note(&mut traffic);
        traffic.seconds += begun.elapsed().as_secs_f64();
    }
}

impl Ranks for MpiRanks {
    fn rank(&self) -> usize {
        SimpleCommunicator::world().rank() as usize
    }

    fn count(&self) -> usize {
        SimpleCommunicator::world().size() as usize
    }

    fn gather_even(&self, mine: &[u8]) -> Vec<u8> {
        let begun = Instant::now();
        let world = SimpleCommunicator::world();
        let mut all = vec![0u8; mine.len() * self.count()];
        scope(|scope| {
            let request = world.immediate_all_gather_into(scope, mine, &mut all[..]);
            self.wait(request, "all others");
        });
        self.note(begun, |traffic| {
            traffic.rounds += 1;
            traffic.round_bytes += mine.len() as u64;
        });
        all
    }

    fn gather(&self, mine: &[u8]) -> Vec<Vec<u8>> {
        let lengths = self.gather_even(&(mine.len() as u64).to_ne_bytes());
        let (lengths, _) = lengths.as_chunks::<8>();
        let lengths: Vec<usize> = lengths
            .iter()
            .map(|&bytes| u64::from_ne_bytes(bytes) as usize)
            .collect();
        let begun = Instant::now();
        let world = SimpleCommunicator::world();
        let mut all: Vec<Vec<u8>> = lengths.iter().map(|&length| Vec::with_capacity(length)).collect();
        let most = AT_ONCE / lengths.len();
        let longest = lengths.iter().copied().max().unwrap_or(0);
        for first in (0..longest).step_by(most) {
            let part = |length: usize| length.saturating_sub(first).min(most);
            let counts: Vec<Count> = lengths.iter().map(|&length| part(length) as Count).collect();
            let places: Vec<Count> = (counts.iter())
                .scan(0, |place, count| {
                    let here = *place;
                    *place += count;
                    Some(here)
                })
                .collect();
            let mut heard = vec![0u8; lengths.iter().map(|&length| part(length)).sum()];
            let told = &mine[first.min(mine.len())..(first + part(mine.len())).min(mine.len())];
            {
                let mut parts = PartitionMut::new(&mut heard[..], &counts[..], &places[..]);
                scope(|scope| {
                    let request = world.immediate_all_gather_varcount_into(scope, told, &mut parts);
                    self.wait(request, "all others");
                });
            }
            for ((all, &count), &place) in all.iter_mut().zip(&counts).zip(&places) {
                all.extend_from_slice(&heard[place as usize..(place + count) as usize]);
            }
        }
        self.note(begun, |traffic| {
            traffic.rounds += 1;
            traffic.round_bytes += mine.len() as u64;
        });
        all
    }

    fn tell(&self, rank: usize, mine: &[u8]) {
        let begun = Instant::now();
        let world = SimpleCommunicator::world();
        let other = world.process_at_rank(rank as i32);
        let what = format!("process {rank} to listen");
        let length = [mine.len() as u64];
        scope(|scope| self.wait(other.immediate_send(scope, &length[..]), &what));
        for part in mine.chunks(AT_ONCE) {
            scope(|scope| self.wait(other.immediate_send(scope, part), &what));
        }
        self.note(begun, |traffic| traffic.gathered_bytes += mine.len() as u64);
    }

    fn hear(&self, rank: usize) -> Vec<u8> {
        let begun = Instant::now();
        let world = SimpleCommunicator::world();
        let other = world.process_at_rank(rank as i32);
        let what = format!("process {rank}");
        let mut length = [0u64];
        scope(|scope| self.wait(other.immediate_receive_into(scope, &mut length[..]), &what));
        let mut heard = vec![0u8; length[0] as usize];
        for part in heard.chunks_mut(AT_ONCE) {
            scope(|scope| self.wait(other.immediate_receive_into(scope, part), &what));
        }
        self.note(begun, |_| ());
        heard
    }

    fn swap(&self, rank: usize, mine: &[u8]) -> Vec<u8> {
        let begun = Instant::now();
        let world = SimpleCommunicator::world();
        let other = world.process_at_rank(rank as i32);
        let what = format!("process {rank}");
        // a message may be shorter than the room for it: both tell how much they have, and its beginning
        let front = mine.len().min(IN_ONE);
        let told = [&(mine.len() as u64).to_ne_bytes(), &mine[..front]].concat();
        let mut first = [0u8; size_of::<u64>() + IN_ONE];
        scope(|scope| {
            let hears = other.immediate_receive_into(scope, &mut first[..]);
            let tells = other.immediate_send(scope, &told[..]);
            self.wait(hears, &what);
            self.wait(tells, &what);
        });
        let (length, bytes) = first.split_at(size_of::<u64>());
        let length = u64::from_ne_bytes(std::array::from_fn(|k| length[k])) as usize;
        let mut heard = vec![0u8; length];
        let (begin, rest) = heard.split_at_mut(length.min(IN_ONE));
        begin.copy_from_slice(&bytes[..begin.len()]);
        scope(|scope| {
            let parts = rest.chunks_mut(AT_ONCE);
            let hears: Vec<_> = parts.map(|part| other.immediate_receive_into(scope, part)).collect();
            let parts = mine[front..].chunks(AT_ONCE);
            let tells: Vec<_> = parts.map(|part| other.immediate_send(scope, part)).collect();
            hears.into_iter().for_each(|request| self.wait(request, &what));
            tells.into_iter().for_each(|request| self.wait(request, &what));
        });
        self.note(begun, |traffic| traffic.joined_bytes += mine.len() as u64);
        heard
    }

    fn begin_round(&self) {
        self.note(Instant::now(), |traffic| traffic.rounds += 1);
    }

    fn exchange(&self, messages: &mut [Message], meanwhile: &mut dyn FnMut()) {
        let mut begun = Instant::now();
        let world = SimpleCommunicator::world();
        let (mut count, mut bytes) = (0, 0);
        scope(|scope| {
            let mut requests = Vec::with_capacity(messages.len());
            let mut sent = Vec::with_capacity(messages.len());
            for message in messages {
                let other = world.process_at_rank(message.rank as i32);
                requests.push((message.rank, other.immediate_receive_into(scope, &mut message.hear[..])));
                sent.push((message.rank, other.immediate_send(scope, &message.tell[..])));
                count += 1;
                bytes += 8 * message.tell.len() as u64;
            }
            let worked = Instant::now();
            meanwhile();
            begun += worked.elapsed();
            for (rank, request) in requests {
                self.wait(request, &format!("process {rank}"));
            }
            for (rank, request) in sent {
                self.wait(request, &format!("process {rank} to listen"));
            }
        });
        self.note(begun, |traffic| {
            traffic.messages += count;
            traffic.bytes += bytes;
        });
    }

    fn be_patient(&self, is_patient: bool) {
        self.is_patient.store(is_patient, Ordering::Relaxed);
    }

    fn traffic(&self) -> Traffic {
        *self.traffic.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn give_up(&self, reason: &str) -> ! {
        (self.tell)(reason);
        abort(GIVEN_UP)
    }
}
