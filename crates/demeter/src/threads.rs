//! Threads that stay awake from one phase of a step to the next.
//!
//! A worker of rayon that runs out of work sleeps after some ten microseconds, and to wake it takes tens of microseconds: as long as a
//! small phase. Several times in a step that costs a tenth of it. While steps follow each other, each worker is therefore given a
//! job that looks for work for a while longer, yields its core to whoever wants it, and ends when nothing comes.

use rayon::Yield;
use std::ops::Range;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// For so long a worker looks for work before it may sleep: longer than what is done on one thread within a step.
const PATIENCE: Duration = Duration::from_micros(200);

/// Looks in vain before the core is offered to others.
const LOOKS: u32 = 20;

/// Keeps workers awake.
#[derive(Debug, Default)]
pub(crate) struct Awake {
    /// Whether the worker of this number is kept awake.
    kept: Arc<[AtomicBool]>,
}

impl Awake {
    /// Keeps all other workers of the pool awake that this thread belongs to.
    pub(crate) fn keep(&mut self) {
        let Some(here) = rayon::current_thread_index() else {
            return;
        };
        let threads = rayon::current_num_threads();
        if self.kept.len() != threads {
            // more threads than cores take them from each other
            let cores = std::thread::available_parallelism().map_or(1, usize::from);
            let keeps = |thread| AtomicBool::new(thread == here || threads > cores);
            self.kept = (0..threads).map(keeps).collect();
        }
        if self.kept.iter().all(|kept| kept.load(Ordering::Relaxed)) {
            return;
        }
        let kept = Arc::clone(&self.kept);
        rayon::spawn_broadcast(move |worker| {
            let kept = &kept[worker.index()];
            if !kept.swap(true, Ordering::Relaxed) {
                work_until(|| false);
                kept.store(false, Ordering::Relaxed);
            }
        });
    }
}

/// Does what work there is for the pool until something has come true, or nothing was to be done for a while.
fn work_until(is_done: impl Fn() -> bool) {
    let mut idle: Option<Instant> = None;
    let mut looks = 0;
    while !is_done() {
        if let Some(Yield::Executed) = rayon::yield_now() {
            idle = None;
            continue;
        }
        let since = *idle.get_or_insert_with(Instant::now);
        if since.elapsed() > PATIENCE {
            return;
        }
        looks += 1;
        if looks % LOOKS == 0 {
            std::thread::yield_now();
        }
        std::hint::spin_loop();
    }
}

/// Like [`rayon::join`], but does not sleep at once while the other thread ends its half.
fn join<A, B>(one: impl FnOnce() -> A + Send, other: impl FnOnce() -> B + Send) -> (A, B)
where
    A: Send,
    B: Send,
{
    let is_done = AtomicBool::new(false);
    rayon::join(
        || {
            let found = one();
            work_until(|| is_done.load(Ordering::Acquire));
            found
        },
        || {
            let found = other();
            is_done.store(true, Ordering::Release);
            found
        },
    )
}

/// Cuts work into parts and does every part, told its number: the first on the first thread, the second on the second, if these come in
/// time, for what a thread worked on in the pass before is in its cache. Parts of threads that come late are done by others. The first
/// thing has a number, and so have those with which the other parts begin. What is found is merged in the order of the parts.
pub(crate) fn at_home<W: Divisible, R: Send + Default>(
    (first, cuts): (usize, &[usize]),
    work: W,
    does: &(impl Fn(usize, W) -> R + Sync),
    merge: &(impl Fn(R, R) -> R + Sync),
) -> R {
    if cuts.is_empty() {
        return does(0, work);
    }
    part_by_part(None, (first, cuts), work, does, merge)
}

/// The same, told the parts that were cut already. Each stands in the frame of a call, so that none takes memory of the heap.
fn part_by_part<W: Divisible, R: Send + Default>(
    before: Option<&Part<'_, W, R>>,
    (begin, cuts): (usize, &[usize]),
    work: W,
    does: &(impl Fn(usize, W) -> R + Sync),
    merge: &(impl Fn(R, R) -> R + Sync),
) -> R {
    let number = before.map_or(0, |last| last.number + 1);
    let new = |work| Part {
        number,
        state: Mutex::new(State::Open(work)),
        before,
    };
    if let Some((&cut, cuts)) = cuts.split_first() {
        let (work, others) = work.split(cut - begin);
        return part_by_part(Some(&new(work)), (cut, cuts), others, does, merge);
    }
    let last = new(work);
    let count = number + 1;
    let next = || {
        let home = rayon::current_thread_index().unwrap_or(0);
        let mut from_home = (0..count).map(|k| (home + k) % count);
        // this is called once for each part, so one is left
        let open = |number| {
            let part = last.and_before().nth(count - 1 - number)?;
            Some((part, locked(&part.state).take()?))
        };
        if let Some((part, work)) = from_home.find_map(open) {
            let found = does(part.number, work);
            *locked(&part.state) = State::Done(found);
        }
    };
    times(count, &next);
    let from_behind = last.and_before().filter_map(|part| locked(&part.state).done());
    from_behind
        .reduce(|behind, found| merge(found, behind))
        .unwrap_or_default()
}

/// A part of some work, and those before it.
struct Part<'a, W, R> {
    number: usize,
    state: Mutex<State<W, R>>,
    before: Option<&'a Self>,
}

impl<W, R> Part<'_, W, R> {
    /// This one and those before it, from the last to the first.
    fn and_before(&self) -> impl Iterator<Item = &Self> {
        std::iter::successors(Some(self), |part| part.before)
    }
}

/// What is to be done of a part, and then what was found.
enum State<W, R> {
    Open(W),
    Taken,
    Done(R),
}

impl<W, R> State<W, R> {
    fn take(&mut self) -> Option<W> {
        match std::mem::replace(self, Self::Taken) {
            Self::Open(work) => Some(work),
            other => {
                *self = other;
                None
            }
        }
    }

    fn done(&mut self) -> Option<R> {
        match std::mem::replace(self, Self::Taken) {
            Self::Done(found) => Some(found),
            Self::Open(_) | Self::Taken => None,
        }
    }
}

/// No lock is held while anything may panic.
fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Does the same so many times, in parallel.
fn times(count: usize, does: &(impl Fn() + Sync)) {
    match count {
        0 => (),
        1 => does(),
        _ => {
            join(|| times(count / 2, does), || times(count - count / 2, does));
        }
    }
}

/// Work on things that lie behind each other.
pub(crate) trait Divisible: Sized + Send {
    /// Number of things.
    fn len(&self) -> usize;
    /// The work on the first so many of them, and that on the others.
    fn split(self, first: usize) -> (Self, Self);
}

/// Does work in parallel, in pieces of at most so many things each, and merges what is found in their order.
pub(crate) fn divide<W: Divisible, R: Send + Default>(
    work: W,
    most: usize,
    does: &(impl Fn(W) -> R + Sync),
    merge: &(impl Fn(R, R) -> R + Sync),
) -> R {
    let (threads, pieces) = (rayon::current_num_threads(), work.len().div_ceil(most));
    let mut cuts: Vec<usize> = (1..threads).map(|t| t * pieces / threads * most).collect();
    cuts.dedup();
    divide_at((0, inside(&cuts, &(0..work.len()))), work, most, does, merge)
}

/// Those of some ascending cuts that lie inside a range.
pub(crate) fn inside<'a>(cuts: &'a [usize], range: &Range<usize>) -> &'a [usize] {
    let first = cuts.partition_point(|&cut| cut <= range.start);
    let end = cuts.partition_point(|&cut| cut < range.end);
    &cuts[first..end.max(first)]
}

/// The same where each thread has a part of its own, as told to [`at_home`]. What it does it does from the end to the beginning: a
/// pass that goes the other way before it left the end in the caches, and one after it finds the beginning there. No other helps it
/// with the rest: where cores share no cache, to fetch rows that another one wrote takes ten times as long as to work on them.
pub(crate) fn divide_at<W: Divisible, R: Send + Default>(
    at: (usize, &[usize]),
    work: W,
    most: usize,
    does: &(impl Fn(W) -> R + Sync),
    merge: &(impl Fn(R, R) -> R + Sync),
) -> R {
    at_home(at, work, &|_, part| backwards(part, most, does, merge), merge)
}

/// Does work in pieces from the end to the beginning.
fn backwards<W: Divisible, R>(work: W, most: usize, does: &impl Fn(W) -> R, merge: &impl Fn(R, R) -> R) -> R {
    let (mut rest, mut behind) = (work, None);
    let and_behind = |found: R, behind: Option<R>| match behind {
        Some(behind) => merge(found, behind),
        None => found,
    };
    while rest.len() > most {
        let last = (rest.len() - 1) / most * most;
        let (others, piece) = rest.split(last);
        behind = Some(and_behind(does(piece), behind));
        rest = others;
    }
    and_behind(does(rest), behind)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::Barrier;
    use std::sync::atomic::AtomicUsize;

    struct Numbers<'a>(&'a mut [usize]);

    impl Divisible for Numbers<'_> {
        fn len(&self) -> usize {
            self.0.len()
        }

        fn split(self, first: usize) -> (Self, Self) {
            let (some, others) = self.0.split_at_mut(first);
            (Numbers(some), Numbers(others))
        }
    }

    fn on_threads<T: Send>(threads: usize, work: impl FnOnce() -> T + Send) -> T {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(work)
    }

    #[test]
    fn all_is_done_once_and_merged_in_its_order() {
        for threads in [1, 2, 5] {
            for count in [0, 1, 9, 10, 11, 997] {
                let mut all: Vec<usize> = (0..count).collect();
                let does = |some: Numbers| {
                    assert!(some.0.len() <= 10);
                    some.0.iter_mut().for_each(|n| *n += 1);
                    some.0.to_vec()
                };
                let merge = |one: Vec<usize>, other: Vec<usize>| [one, other].concat();
                let found = on_threads(threads, || divide(Numbers(&mut all), 10, &does, &merge));
                assert_eq!(found, (1..=count).collect::<Vec<_>>());
                assert_eq!(all, found);
            }
        }
    }

    #[test]
    fn threads_begin_where_they_are_told() {
        let starts = |first: usize, cuts: &[usize], threads| {
            let mut all: Vec<usize> = (first..first + 100).collect();
            let does = |some: Numbers| vec![some.0[0]];
            let merge = |one: Vec<usize>, other: Vec<usize>| [one, other].concat();
            let at = (first, inside(cuts, &(first..first + 100)));
            on_threads(threads, || divide_at(at, Numbers(&mut all), 40, &does, &merge))
        };
        for threads in [1, 3] {
            assert_eq!(starts(0, &[], threads), [0, 40, 80]);
            assert_eq!(starts(7, &[37, 47], threads), [7, 37, 47, 87]);
            // what lies outside is the work of others
            assert_eq!(starts(7, &[0, 7, 27, 107, 200], threads), [7, 27, 67]);
        }
    }

    #[test]
    fn each_thread_does_its_own_part() {
        let mut all: Vec<usize> = (0..100).collect();
        let all_have_begun = Barrier::new(4);
        let does = |part, some: Numbers| {
            all_have_begun.wait();
            vec![(part, some.0[0], rayon::current_thread_index())]
        };
        let merge = |one: Vec<_>, other: Vec<_>| [one, other].concat();
        let found = on_threads(4, || at_home((0, &[10, 20, 90]), Numbers(&mut all), &does, &merge));
        assert_eq!(
            found,
            [(0, 0, Some(0)), (1, 10, Some(1)), (2, 20, Some(2)), (3, 90, Some(3))]
        );
    }

    #[test]
    fn parts_of_threads_that_do_not_come_are_done() {
        let mut all: Vec<usize> = (0..100).collect();
        let does = |part, some: Numbers| some.0.iter_mut().map(|n| std::mem::replace(n, part)).sum();
        let merge = |one: usize, other: usize| one + other;
        let cuts: Vec<usize> = (1..50).collect();
        let sum = on_threads(2, || at_home((0, &cuts), Numbers(&mut all), &does, &merge));
        assert_eq!(sum, 99 * 100 / 2);
        assert_eq!(all[..50], (0..50).collect::<Vec<_>>());
        assert!(all[50..].iter().all(|&part| part == 49));
    }

    #[test]
    fn both_halves_are_done_and_a_panic_of_either_arrives() {
        for threads in [1, 2] {
            on_threads(threads, || {
                assert_eq!(join(|| 1, || 2), (1, 2));
                let one = std::panic::catch_unwind(|| join(|| panic!("one"), || 2));
                let other = std::panic::catch_unwind(|| join(|| 1, || panic!("other")));
                assert!(one.is_err() && other.is_err());
                assert_eq!(join(|| 3, || 4), (3, 4));
            });
        }
    }

    #[test]
    fn threads_that_are_kept_awake_work_and_end() {
        for threads in [1, 2, 3] {
            let done = AtomicUsize::new(0);
            on_threads(threads, || {
                let mut awake = Awake::default();
                for _ in 0..200 {
                    awake.keep();
                    join(
                        || done.fetch_add(1, Ordering::Relaxed),
                        || done.fetch_add(1, Ordering::Relaxed),
                    );
                }
                // once they have ended, they are kept awake again
                std::thread::sleep(20 * PATIENCE);
                awake.keep();
                join(|| (), || done.fetch_add(1, Ordering::Relaxed));
            });
            assert_eq!(done.into_inner(), 401);
        }
        // outside of a pool nobody is kept
        Awake::default().keep();
    }
}
