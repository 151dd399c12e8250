//! The bodies of contacts, as many at a time as there are lanes.

use super::kinematics::last_listed;
use super::meetings::Lot;
use demeter_physics::lanes::{Index, Lanes, MOST_LANES};

/// What is listed for contacts, to be had for as many at a time as there are lanes; those beyond the end repeat the last.
#[derive(Clone, Copy)]
struct ByLanes<'a, T> {
    all: &'a [T],
    end: &'a [T; MOST_LANES],
}

/// The end of a list, from a multiple of the most lanes on.
fn end_of<T: Copy + Default>(all: &[T]) -> [T; MOST_LANES] {
    match all.len().checked_sub(1) {
        Some(last) => last_listed(all, last / MOST_LANES * MOST_LANES),
        None => [T::default(); MOST_LANES],
    }
}

impl<'a, T: Copy> ByLanes<'a, T> {
    /// Of a list and its end.
    fn of(all: &'a [T], end: &'a [T; MOST_LANES]) -> Self {
        Self { all, end }
    }

    /// Those of the lanes from contact `k` on, where they lie.
    #[inline(always)]
    fn from<L: Lanes>(self, k: usize) -> &'a [T] {
        match self.all.get(k..k + L::COUNT) {
            Some(all) => all,
            None => &self.end[k % MOST_LANES..][..L::COUNT],
        }
    }
}

/// Grains of contacts, and the codes of their shifts across periodic sides; no codes where there are none.
pub(super) type Lists<'a> = (&'a [u32], &'a [u32], &'a [u8]);

/// The ends of these lists.
pub(super) struct Ends {
    i: Index,
    j: Index,
    shift: [u8; MOST_LANES],
}

impl Ends {
    pub(super) fn of((i, j, shift): Lists) -> Self {
        Self {
            i: end_of(i),
            j: end_of(j),
            shift: end_of(shift),
        }
    }
}

/// The bodies of contacts between grains.
#[derive(Clone, Copy)]
pub(super) struct Bodies<'a> {
    i: ByLanes<'a, u32>,
    j: ByLanes<'a, u32>,
    shift: ByLanes<'a, u8>,
}

impl<'a> Bodies<'a> {
    /// Of lists and their ends, which lie apart: a place in them is not known when this is compiled, which would put all that holds them into
    /// memory for good.
    pub(super) fn of((i, j, shift): Lists<'a>, ends: &'a Ends) -> Self {
        Self {
            i: ByLanes::of(i, &ends.i),
            j: ByLanes::of(j, &ends.j),
            shift: ByLanes::of(shift, &ends.shift),
        }
    }

    /// Those of the lanes from contact `k` on.
    #[inline(always)]
    pub(super) fn lot<L: Lanes>(&self, k: usize) -> Lot<'a> {
        let has_shifts = !self.shift.all.is_empty();
        Lot {
            first: self.i.from::<L>(k),
            second: self.j.from::<L>(k),
            shift: if has_shifts { self.shift.from::<L>(k) } else { &[] },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use demeter_physics::lanes::{Instructions, Kernel, run, run_on_two};

    /// Reads a list lane by lane.
    struct Read<'a>(ByLanes<'a, u32>);

    impl Kernel for Read<'_> {
        type Output = Vec<u32>;

        #[inline(always)]
        fn run<L: Lanes>(self) -> Vec<u32> {
            let lots = (0..self.0.all.len()).step_by(L::COUNT);
            lots.flat_map(|k| self.0.from::<L>(k).to_vec()).collect()
        }
    }

    #[test]
    fn lanes_beyond_the_end_repeat_the_last() {
        for count in 0..70 {
            let list: Vec<u32> = (0..count).map(|k| 7 * k + 1).collect();
            let end = end_of(&list);
            for instructions in Instructions::available() {
                let by_lanes = ByLanes::of(&list, &end);
                for found in [
                    run(instructions, Read(by_lanes)),
                    run_on_two(instructions, Read(by_lanes)),
                ] {
                    assert_eq!(found[..list.len()], list[..]);
                    assert!(found[list.len()..].iter().all(|last| Some(last) == list.last()));
                }
            }
        }
    }
}
