//! Counting sorts in parallel: every task owns a range of the keys and looks at all items, so that the result is the same
//! for any number of tasks.

/// Items that a range of keys should be worth.
const LEAST: usize = 8192;

/// Number of tasks worth having.
fn tasks(items: usize) -> usize {
    (items / LEAST).clamp(1, rayon::current_num_threads())
}

/// Calls `work` with ranges of `values` and their first index, in parallel.
pub(super) fn for_ranges<T: Send>(
    first: usize,
    values: &mut [T],
    items: usize,
    work: &(impl Fn(usize, &mut [T]) + Sync),
) {
    split(first, values, tasks(items), work);
}

fn split<T: Send>(first: usize, values: &mut [T], parts: usize, work: &(impl Fn(usize, &mut [T]) + Sync)) {
    if parts < 2 || values.len() < 2 {
        work(first, values);
        return;
    }
    let middle = values.len() * (parts / 2) / parts;
    let (low, high) = values.split_at_mut(middle);
    rayon::join(
        || split(first, low, parts / 2, work),
        || split(first + middle, high, parts - parts / 2, work),
    );
}

/// Turns numbers at `1..` into sums of all numbers before: `values[k + 1]` becomes the start of `k`.
pub(super) fn sums(values: &mut [u32]) {
    let mut sum = 0;
    for value in &mut values[1..] {
        sum += std::mem::replace(value, sum);
    }
}

/// Calls `work` with ranges of keys, told by their starts, and the places that belong to them: first key, starts, first
/// place, places.
pub(super) fn scatter<T: Send>(
    first: usize,
    starts: &mut [u32],
    base: usize,
    places: &mut [T],
    work: &(impl Fn(usize, &mut [u32], usize, &mut [T]) + Sync),
) {
    let parts = tasks(places.len());
    split_places((first, starts), (base, places), parts, work);
}

fn split_places<T: Send>(
    (first, starts): (usize, &mut [u32]),
    (base, places): (usize, &mut [T]),
    parts: usize,
    work: &(impl Fn(usize, &mut [u32], usize, &mut [T]) + Sync),
) {
    if parts < 2 || starts.len() < 2 {
        work(first, starts, base, places);
        return;
    }
    // halves with as many places as the tasks that they get
    let wanted = base + places.len() * (parts / 2) / parts;
    let middle = starts
        .partition_point(|&start| (start as usize) < wanted)
        .clamp(1, starts.len() - 1);
    let cut = starts[middle] as usize;
    let (low, high) = starts.split_at_mut(middle);
    let (below, above) = places.split_at_mut(cut - base);
    rayon::join(
        || split_places((first, low), (base, below), parts / 2, work),
        || split_places((first + middle, high), (cut, above), parts - parts / 2, work),
    );
}
