//! How much work runs take, in numbers that no clock and no processor changes: a step that looks at more candidates, or
//! searches more often, shows here. Where that is meant to be, the numbers are changed, and the commit tells why.

use crate::cases::beds::bed;
use crate::cases::on_threads;
use demeter::simulation::Simulation;

const STEPS: u64 = 2000;

/// What the steps of a run took in all.
#[derive(Default)]
struct Count {
    rebuilds: u64,
    distance_tests: u64,
    candidates: u64,
    contacts: u64,
    wall_candidates: u64,
    wall_contacts: u64,
}

impl Count {
    fn to_array(&self) -> [u64; 6] {
        [
            self.rebuilds,
            self.distance_tests,
            self.candidates,
            self.contacts,
            self.wall_candidates,
            self.wall_contacts,
        ]
    }
}

fn count(name: &str) -> Count {
    let mut sim = Simulation::new(bed(name, 300));
    sim.start().unwrap();
    let begun = sim.rebuilds();
    let mut count = Count::default();
    for _ in 0..STEPS {
        let rebuilds = sim.rebuilds();
        sim.step().unwrap();
        if sim.rebuilds() > rebuilds {
            count.distance_tests += sim.distance_tests();
        }
        let work = sim.work();
        count.candidates += work.candidates;
        count.contacts += work.contacts;
        count.wall_candidates += work.wall_candidates;
        count.wall_contacts += work.wall_contacts;
    }
    count.rebuilds = sim.rebuilds() - begun;
    count
}

/// Rebuilds, distance tests, candidates, contacts, candidates with walls, contacts with walls.
const EXPECTED: [(&str, [u64; 6]); 4] = [
    ("settling", [4, 22547, 341655, 33997, 75429, 12049]),
    ("drum", [5, 18012, 235054, 16366, 22256, 3875]),
    ("shear", [8, 79388, 1398226, 387684, 67940, 34484]),
    ("squeezed", [35, 365549, 1886092, 1339748, 281769, 245745]),
];

#[test]
fn runs_take_the_work_that_they_took() {
    for threads in [1, 3] {
        let found = EXPECTED.map(|(name, _)| (name, on_threads(threads, || count(name)).to_array()));
        assert!(
            found == EXPECTED,
            "on {threads} threads, over {STEPS} steps:\n{found:#?}\nand not\n{EXPECTED:#?}"
        );
    }
}
