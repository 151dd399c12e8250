//! A step takes no memory once everything has its size, and little where candidates are found anew.
#![allow(unsafe_code, reason = "an allocator that counts is made of unsafe calls")]
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests")]

mod cases;

use cases::beds::{BEDS, bed};
use cases::on_threads;
use demeter::simulation::Simulation;
use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};

struct Counting;

static ALLOCATIONS: AtomicU64 = AtomicU64::new(0);

/// Bytes that are held, and the most that were.
static HELD: AtomicU64 = AtomicU64::new(0);
static MOST: AtomicU64 = AtomicU64::new(0);

fn take(bytes: usize) {
    let held = HELD.fetch_add(bytes as u64, Ordering::Relaxed) + bytes as u64;
    MOST.fetch_max(held, Ordering::Relaxed);
}

fn give(bytes: usize) {
    HELD.fetch_sub(bytes as u64, Ordering::Relaxed);
}

/// All tests count into the same numbers.
static ONE_AT_A_TIME: Mutex<()> = Mutex::new(());

// SAFETY: every call is handed to the allocator of the system.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        ALLOCATIONS.fetch_add(1, Ordering::Relaxed);
        take(layout.size());
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, block: *mut u8, layout: Layout) {
        give(layout.size());
        unsafe { System.dealloc(block, layout) }
    }

    unsafe fn realloc(&self, block: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        ALLOCATIONS.fetch_add(1, Ordering::Relaxed);
        give(layout.size());
        take(size);
        unsafe { System.realloc(block, layout, size) }
    }
}

#[global_allocator]
static COUNTING: Counting = Counting;

/// Steps that allocate among those that keep their candidates, of the last half of a run.
fn allocating_steps(name: &str, grains: u32) -> (u32, u32) {
    let mut sim = Simulation::new(bed(name, grains));
    let (mut counted, mut allocating) = (0, 0);
    for step in 0..1200 {
        let (rebuilds, before) = (sim.rebuilds(), ALLOCATIONS.load(Ordering::Relaxed));
        sim.step().unwrap();
        let allocated = ALLOCATIONS.load(Ordering::Relaxed) - before;
        if step >= 600 && sim.rebuilds() == rebuilds {
            counted += 1;
            allocating += u32::from(allocated > 0);
        }
    }
    (counted, allocating)
}

/// Now and then a table grows by a contact beyond what it has held before, and a thread's workspace when it gets another chunk.
#[test]
fn steps_take_no_memory() {
    let _alone = ONE_AT_A_TIME.lock();
    // of more threads than cores none is kept awake, for which memory is taken when one has fallen asleep
    let several = std::thread::available_parallelism().unwrap().get() + 1;
    // as many as are divided among threads
    let many = 900;
    for ((threads, grains, one_in), name) in itertools::iproduct!([(1, 120, 50), (several, many, 10)], BEDS) {
        let (counted, allocating) = on_threads(threads, || allocating_steps(name, grains));
        assert!(counted > 100, "{name}: {counted} steps kept their candidates");
        assert!(
            one_in * allocating <= counted,
            "{name} on {threads} threads: {allocating} of {counted} steps allocate"
        );
    }
}

/// What a search needs beside the tables fits where loads and former places were, which nobody asks for meanwhile.
#[test]
fn candidates_are_found_in_the_memory_of_steps() {
    let _alone = ONE_AT_A_TIME.lock();
    let grains = 8000;
    let mut sim = Simulation::new(bed("settling", grains));
    sim.start().unwrap();
    let mut beyond: Vec<f64> = Vec::new();
    while beyond.len() < 12 {
        let (rebuilds, before) = (sim.rebuilds(), HELD.load(Ordering::Relaxed));
        MOST.store(before, Ordering::Relaxed);
        sim.step().unwrap();
        if sim.rebuilds() > rebuilds {
            let steps = before.max(HELD.load(Ordering::Relaxed));
            beyond.push((MOST.load(Ordering::Relaxed) - steps) as f64 / f64::from(grains));
        }
    }
    assert!(beyond.iter().all(|&bytes| bytes < 8.0), "bytes per grain: {beyond:?}");
}
