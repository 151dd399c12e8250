use super::*;

/// A feed into a box with a removal at its floor and a wall, and two stages of 0.1 s.
struct Told {
    feed: &'static str,
    removal: &'static str,
    motion: &'static str,
    /// Of the first stage, then of the second.
    stages: [&'static str; 2],
}

const NOTHING_IN_VAIN: Told = Told {
    feed: "center = \"10 10 15 mm\"\nnumber_rate = \"100 1/s\"",
    removal: "region = { shape = \"box\", upper = \"20 20 3 mm\" }\n",
    motion: "{ oscillation = { amplitude = \"0 0 1 mm\", frequency = \"10 Hz\" } }",
    stages: ["", ""],
};

fn warnings(told: &Told) -> Vec<String> {
    let Told {
        feed,
        removal,
        motion,
        stages: [first, second],
    } = told;
    let (center, feed) = feed.split_once('\n').unwrap();
    let text = format!(
        r#"
[domain]
lower = "0 0 0 mm"
upper = "20 20 20 mm"
{ONE_GRAIN}
[[feed]]
name = "inlet"
material = "glass"
diameter = "1 mm"
from = {{ shape = "disc", {center}, normal = "z", radius = "3 mm" }}
{feed}
[[removal]]
name = "outlet"
{removal}
[[wall]]
name = "plate"
material = "glass"
shape = "rectangle"
center = "10 10 8 mm"
half_u = "3 0 0 mm"
half_v = "0 3 0 mm"
motion = {motion}

[[stage]]
name = "first"
duration = "0.1 s"
{first}
[[stage]]
name = "second"
duration = "0.1 s"
{second}
"#
    );
    prepare(&parse(&text, &[]).unwrap()).unwrap().warnings
}

#[test]
fn what_comes_to_nothing_is_told() {
    let low = "center = \"10 10 2 mm\"\nnumber_rate = \"100 1/s\"";
    let lifted = "[stage.motion]\nplate = { velocity = \"0 0 5 mm/s\" }\n";
    let gone = "absent = [\"plate\"]\n[stage.motion]\nplate = { velocity = \"0 0 5 mm/s\" }\n";
    let all_go = "all grains of feed `inlet` come in where removal `outlet` takes them";
    let cases: &[(Told, &[&str])] = &[
        (NOTHING_IN_VAIN, &[]),
        (
            Told {
                feed: "center = \"10 10 15 mm\"\nevery = \"0.3 s\"\ncount = 10",
                ..NOTHING_IN_VAIN
            },
            &["some come at the start, and none later"],
        ),
        (
            Told {
                feed: "center = \"10 10 15 mm\"\nevery = \"0.3 s\"\nnumber_rate = \"100 1/s\"",
                ..NOTHING_IN_VAIN
            },
            &["the stages end at 2.0000e-1 s at the latest: none comes"],
        ),
        (
            Told {
                feed: "center = \"10 10 15 mm\"\nevery = \"1 ns\"\ncount = 10",
                removal: "region = { shape = \"box\", upper = \"20 20 3 mm\" }\nevery = \"2 ns\"",
                stages: [
                    "",
                    "[[measure]]\nname = \"map\"\nkind = \"field\"\ncells = [2, 2, 2]\nwidth = \"15 mm\"\nsample_every = \"3 ns\"",
                ],
                ..NOTHING_IN_VAIN
            },
            &[
                "`sample_every` of measure `map` is 3.0000e-9 s, less than a time step of",
                "`every` of feed `inlet` is 1.0000e-9 s, less than a time step of",
                "`every` of removal `outlet` is 2.0000e-9 s, less than a time step of",
            ],
        ),
        (
            Told {
                feed: low,
                ..NOTHING_IN_VAIN
            },
            &[all_go],
        ),
        // the plate, 6 mm wide, is as wide as the disc, which it lies in
        (
            Told {
                feed: "center = \"10 10 8 mm\"\nnumber_rate = \"100 1/s\"",
                motion: "\"rest\"",
                ..NOTHING_IN_VAIN
            },
            &["feed `inlet` lets no grain come, or hardly any: walls, as `plate`"],
        ),
        // half of the disc is free, or the plate moves out of the way
        (
            Told {
                feed: "center = \"13 10 8 mm\"\nnumber_rate = \"100 1/s\"",
                motion: "\"rest\"",
                ..NOTHING_IN_VAIN
            },
            &[],
        ),
        (
            Told {
                feed: "center = \"10 10 8 mm\"\nnumber_rate = \"100 1/s\"",
                ..NOTHING_IN_VAIN
            },
            &[],
        ),
        // half of the disc
        (
            Told {
                feed: low,
                removal: "region = { shape = \"box\", upper = \"10 20 3 mm\" }\n",
                ..NOTHING_IN_VAIN
            },
            &[],
        ),
        // others than those that come
        (
            Told {
                feed: low,
                removal: "region = { shape = \"box\", upper = \"20 20 3 mm\" }\ntag = 4\n",
                ..NOTHING_IN_VAIN
            },
            &["removal `outlet` means grains with the tag 4"],
        ),
        // it acts when the feed is over
        (
            Told {
                feed: low,
                stages: ["removals = []\n", "feeds = []\nremovals = [\"outlet\"]\n"],
                ..NOTHING_IN_VAIN
            },
            &[],
        ),
        (
            Told {
                feed: low,
                stages: ["", "removals = []\n"],
                ..NOTHING_IN_VAIN
            },
            &[],
        ),
        (
            Told {
                removal: "region = { shape = \"box\", upper = \"20 20 3 mm\" }\nevery = \"0.3 s\"\n",
                ..NOTHING_IN_VAIN
            },
            &["removal `outlet` takes grains every 3.0000e-1 s, and the stages end at 2.0000e-1 s"],
        ),
        (
            Told {
                motion: "{ oscillation = { amplitude = \"0 0 0 mm\", frequency = \"10 Hz\" } }",
                ..NOTHING_IN_VAIN
            },
            &["wall `plate` swings with an amplitude of 0"],
        ),
        (
            Told {
                stages: ["", gone],
                ..NOTHING_IN_VAIN
            },
            &["stage `second` moves wall `plate`, which is absent from then on"],
        ),
        (
            Told {
                stages: ["absent = [\"plate\"]\n", lifted],
                ..NOTHING_IN_VAIN
            },
            &["wall `plate` is absent in every stage"],
        ),
        (
            Told {
                feed: "center = \"10 10 15 mm\"\ncount = 3",
                stages: ["feeds = []\n", ""],
                ..NOTHING_IN_VAIN
            },
            &["feed `inlet` runs in no stage"],
        ),
        (
            Told {
                stages: ["feeds = []\n", "feeds = [\"inlet\"]\n"],
                ..NOTHING_IN_VAIN
            },
            &[],
        ),
        (
            Told {
                stages: ["removals = []\n", "removals = []\n"],
                ..NOTHING_IN_VAIN
            },
            &["removal `outlet` acts in no stage"],
        ),
        (
            Told {
                motion: "{ belt = \"0 0 2 mm/s\" }",
                ..NOTHING_IN_VAIN
            },
            &["the `belt` of wall `plate` points along its normal"],
        ),
        (
            Told {
                motion: "{ belt = \"1 0 2 mm/s\" }",
                ..NOTHING_IN_VAIN
            },
            &[],
        ),
        (
            Told {
                feed: "center = \"10 10 15 mm\"\ncount = 3",
                stages: [
                    "stop = { feed_done = \"inlet\" }\n",
                    "stop = { feed_done = \"inlet\" }\n",
                ],
                ..NOTHING_IN_VAIN
            },
            &["stage `second` waits for feed `inlet` to be done, as stage `first` before it does"],
        ),
        // 20 grains come in both stages
        (
            Told {
                feed: "center = \"10 10 15 mm\"\nnumber_rate = \"100 1/s\"\nuntil = \"0.3 s\"",
                ..NOTHING_IN_VAIN
            },
            &["feed `inlet` does not end by its `until` of 0.3 s: the stages end at 2.0000e-1 s"],
        ),
        (
            Told {
                feed: "center = \"10 10 15 mm\"\nnumber_rate = \"100 1/s\"\nuntil = \"0.2 s\"\ncount = 20",
                ..NOTHING_IN_VAIN
            },
            &[],
        ),
        (
            Told {
                feed: "center = \"10 10 15 mm\"\nnumber_rate = \"100 1/s\"\ncount = 21",
                ..NOTHING_IN_VAIN
            },
            &[
                "feed `inlet` does not end by its `count`: in the 2.0000e-1 s that it runs at most, its rate lets 20 of 21 grains come",
            ],
        ),
        (
            Told {
                feed: "center = \"10 10 15 mm\"\nnumber_rate = \"100 1/s\"\nuntil = \"0.1 s\"\ncount = 11",
                ..NOTHING_IN_VAIN
            },
            &["in the 1.0000e-1 s that it runs at most, its rate lets 10 of 11 grains come"],
        ),
        (
            Told {
                feed: "center = \"10 10 15 mm\"\nnumber_rate = \"100 1/s\"\ncount = 11",
                stages: ["feeds = []", "feeds = [\"inlet\"]"],
                ..NOTHING_IN_VAIN
            },
            &["its rate lets 10 of 11 grains come"],
        ),
        // of 1.309 mg each
        (
            Told {
                feed: "center = \"10 10 15 mm\"\nnumber_rate = \"100 1/s\"\nmass = \"30 mg\"",
                ..NOTHING_IN_VAIN
            },
            &[
                "feed `inlet` does not end by its `mass`: in the 2.0000e-1 s that it runs at most, its rate lets 26.1799 mg of 30 mg come",
            ],
        ),
        (
            Told {
                feed: "center = \"10 10 15 mm\"\nmass_rate = \"1 g/s\"\nmass = \"0.2 g\"",
                ..NOTHING_IN_VAIN
            },
            &[],
        ),
        (
            Told {
                feed: "center = \"10 10 15 mm\"\nmass_rate = \"1 g/s\"\nmass = \"0.3 g\"\ncount = 200",
                ..NOTHING_IN_VAIN
            },
            &["its rate lets 153 of 200 grains", "of 300 mg come"],
        ),
        // one bounds the other, or how long it fills up to a level
        (
            Told {
                feed: "center = \"10 10 15 mm\"\nnumber_rate = \"100 1/s\"\ncount = 20\nmass = \"30 mg\"",
                ..NOTHING_IN_VAIN
            },
            &[],
        ),
        (
            Told {
                feed: "center = \"10 10 15 mm\"\nnumber_rate = \"100 1/s\"\ncount = 30\nlevel = { point = \"0 0 9 mm\", normal = \"z\" }",
                ..NOTHING_IN_VAIN
            },
            &[],
        ),
        // it is to go on
        (
            Told {
                feed: "center = \"10 10 15 mm\"\nuntil = \"0.3 s\"",
                ..NOTHING_IN_VAIN
            },
            &[],
        ),
        // it comes back
        (
            Told {
                stages: [gone, "absent = []\n"],
                ..NOTHING_IN_VAIN
            },
            &[],
        ),
    ];
    for (number, (told, words)) in cases.iter().enumerate() {
        let warnings = warnings(told);
        let all =
            warnings.len() == words.len() && warnings.iter().zip(*words).all(|(text, words)| text.contains(words));
        assert!(all, "case {number}: {warnings:?} in place of {words:?}");
    }
}
