//! Sums of what lanes have for rows of a table, in the order of the lanes.
#![allow(unsafe_code)]

use super::{Eight, Lanes};

/// Adds what each lane has for its first body to the row of that, and takes what it has for its second body from the row of that one: lane
/// after lane, so that rows which several lanes name are summed up in their order. The first row is that of the body `from`. Tells
/// whether there are as many bodies as lanes and all of their rows; else nothing is done.
#[must_use]
#[inline(always)]
pub fn add_to_both<L: Lanes, R: AsMut<[f64; 8]>>(
    rows: &mut [R],
    from: u32,
    [first, second]: [&[u32]; 2],
    [added, taken]: [&L::Eights; 2],
) -> bool {
    if first.len() != L::COUNT || second.len() != L::COUNT {
        return false;
    }
    let (mut furthest, mut lane) = (0, 0);
    while lane < L::COUNT {
        let both = [first[lane], second[lane]].map(|body| body.wrapping_sub(from));
        furthest = both[0].max(both[1]).max(furthest);
        lane += 1;
    }
    if furthest as usize >= rows.len() {
        return false;
    }
    let mut lane = 0;
    while lane < L::COUNT {
        let [first, second] = [first[lane], second[lane]].map(|body| body.wrapping_sub(from) as usize);
        // SAFETY: no row is further behind than the furthest, which is there
        let row = unsafe { rows.get_unchecked_mut(first) }.as_mut();
        (L::Eight::load(row) + added.as_ref()[lane]).store(row);
        // SAFETY: the same
        let row = unsafe { rows.get_unchecked_mut(second) }.as_mut();
        (L::Eight::load(row) - taken.as_ref()[lane]).store(row);
        lane += 1;
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lanes::{Instructions, Kernel, Vector, run};

    #[derive(Clone, Copy, Debug, PartialEq)]
    struct Row([f64; 8]);

    impl AsMut<[f64; 8]> for Row {
        fn as_mut(&mut self) -> &mut [f64; 8] {
            &mut self.0
        }
    }

    /// Adds what every lane has to rows from that of body 3 on; bodies occur several times, once both of a lane are the same.
    struct Add {
        bodies: [Vec<u32>; 2],
    }

    impl Kernel for Add {
        /// Whether it was done, the rows, and those that are summed up one by one.
        type Output = (bool, [Row; 5], [Row; 5]);

        #[inline(always)]
        fn run<L: Lanes>(self) -> Self::Output {
            let vector = |by: f64| {
                let x = L::from_fn(|lane| by / (1.0 + lane as f64));
                L::Vector::new(x, x * 3.0, x - 0.1)
            };
            let added = L::side_by_side(vector(0.7), vector(1.3));
            let taken = L::side_by_side(vector(-0.2), vector(1e5));
            let [first, second] = self
                .bodies
                .map(|bodies| bodies.into_iter().take(L::COUNT).collect::<Vec<_>>());
            let before = [0.1, 1e9, -3.0, 0.0, 7.7].map(|value| Row([value; 8]));
            let (mut rows, mut expected) = (before, before);
            let is_done = add_to_both::<L, _>(&mut rows, 3, [&first, &second], [&added, &taken]);
            for lane in 0..first.len().min(second.len()) {
                for (bodies, loads, sign) in [(&first, &added, 1.0), (&second, &taken, -1.0)] {
                    let mut load = [0.0; 8];
                    loads.as_ref()[lane].store(&mut load);
                    let row = bodies[lane].wrapping_sub(3) as usize;
                    if let Some(row) = expected.get_mut(row) {
                        row.0.iter_mut().zip(load).for_each(|(sum, more)| *sum += sign * more);
                    }
                }
            }
            (is_done, rows, expected)
        }
    }

    #[test]
    fn rows_are_summed_up_lane_by_lane_and_only_where_all_are_there() {
        let first: Vec<u32> = (0..16).map(|lane| 3 + [0, 0, 4, 0, 2, 2][lane % 6]).collect();
        let second: Vec<u32> = (0..16).map(|lane| 3 + [1, 0, 3, 2, 1][lane % 5]).collect();
        for instructions in Instructions::available() {
            let bodies = [first.clone(), second.clone()];
            let (is_done, rows, expected) = run(instructions, Add { bodies });
            assert!(is_done);
            assert_eq!(rows, expected, "{instructions:?}");
            let untouched = run(
                instructions,
                Add {
                    bodies: [vec![], vec![]],
                },
            );
            for absent in [2, 8, u32::MAX] {
                for side in 0..2 {
                    let mut bodies = [first.clone(), second.clone()];
                    bodies[side][0] = absent;
                    let (is_done, rows, _) = run(instructions, Add { bodies });
                    assert!(!is_done);
                    assert_eq!(rows, untouched.1, "{instructions:?}");
                }
            }
            assert!(!untouched.0);
        }
    }
}
