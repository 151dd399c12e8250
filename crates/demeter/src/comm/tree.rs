//! The order in which processes tell each other what they know, until all know what it comes to in all: two by two, then four by four,
//! and so on. What a process knows on the way is always that of ranks that follow each other.

/// What a process does with what another one tells it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Then {
    /// It hears nothing.
    Nothing,
    /// It joins it behind what it knows.
    Behind,
    /// It joins it before what it knows.
    Before,
    /// It knows that then.
    Instead,
}

/// One of the times that two processes speak to each other, as one of them sees it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Turn {
    /// The other one.
    pub(crate) other: usize,
    /// Whether this one tells what it knows.
    pub(crate) tells: bool,
    pub(crate) then: Then,
}

/// The turns of one of so many ranks.
pub(crate) fn turns(rank: usize, count: usize) -> Vec<Turn> {
    // as many as a power of two take part; of the first of the others each stands for its neighbour, too
    let most = 1 << count.max(1).ilog2();
    let doubled = 2 * (count - most);
    let turn = |other, tells, then| Turn { other, tells, then };
    if rank < doubled && rank % 2 == 1 {
        return vec![
            turn(rank - 1, true, Then::Nothing),
            turn(rank - 1, false, Then::Instead),
        ];
    }
    let mut turns = Vec::new();
    if rank < doubled {
        turns.push(turn(rank + 1, false, Then::Behind));
    }
    let place = if rank < doubled { rank / 2 } else { rank - doubled / 2 };
    let mut apart = 1;
    while apart < most {
        let other = place ^ apart;
        let then = if other < place { Then::Before } else { Then::Behind };
        let other = if 2 * other < doubled {
            2 * other
        } else {
            other + doubled / 2
        };
        turns.push(turn(other, true, then));
        apart *= 2;
    }
    if rank < doubled {
        turns.push(turn(rank + 1, true, Then::Nothing));
    }
    turns
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What all ranks know after all turns, when each begins with its own number; panics where two do not speak at the same time.
    fn told(count: usize) -> Vec<Vec<usize>> {
        let mut known: Vec<Vec<usize>> = (0..count).map(|rank| vec![rank]).collect();
        let mut turns: Vec<Vec<Turn>> = (0..count).map(|rank| turns(rank, count)).collect();
        while let Some(rank) = (0..count).find(|&rank| {
            let next = |rank: usize| turns[rank].first().map(|turn| turn.other);
            next(rank).is_some_and(|other| next(other) == Some(rank))
        }) {
            let mine = turns[rank].remove(0);
            let theirs = turns[mine.other].remove(0);
            let before = [known[rank].clone(), known[mine.other].clone()];
            for (here, turn, other, heard) in [(rank, mine, theirs, &before[1]), (mine.other, theirs, mine, &before[0])]
            {
                assert_eq!(other.tells, turn.then != Then::Nothing);
                let knows = std::mem::take(&mut known[here]);
                known[here] = match turn.then {
                    Then::Nothing => knows,
                    Then::Behind => [knows, heard.clone()].concat(),
                    Then::Before => [heard.clone(), knows].concat(),
                    Then::Instead => heard.clone(),
                };
            }
        }
        assert!(turns.iter().all(Vec::is_empty), "{count} ranks wait for each other");
        known
    }

    #[test]
    fn all_come_to_know_all_in_the_order_of_the_ranks() {
        for count in 1..=40 {
            let all: Vec<usize> = (0..count).collect();
            assert!(told(count).iter().all(|known| *known == all), "{count} ranks");
            let most = (0..count).map(|rank| turns(rank, count).len()).max().unwrap_or(0);
            assert!(most <= count.ilog2() as usize + 2, "{most} turns of {count} ranks");
        }
    }
}
