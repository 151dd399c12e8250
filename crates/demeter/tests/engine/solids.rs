//! Closed meshes with grains around them: nothing comes inside of one, and what is put there is told.

use super::exchange::{HEAD, last, parse, run_in, series, watcher};
use demeter::scenario::prepare;

/// A cube about a place above the origin, all in millimetres, as a wall.
fn cube(name: &str, half: i32, height: i32) -> String {
    let corner = |k: usize| {
        let at = |bit: usize| if k >> bit & 1 == 1 { half } else { -half };
        format!("\"{} {} {} mm\"", at(0), at(1), at(2) + height)
    };
    let faces = [
        [0, 2, 3, 1],
        [4, 5, 7, 6],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 4, 6, 2],
        [1, 3, 7, 5],
    ];
    let triangles: Vec<String> = (faces.iter())
        .flat_map(|[a, b, c, d]| [[*a, *b, *c], [*a, *c, *d]])
        .map(|[a, b, c]| format!("[{}, {}, {}]", corner(a), corner(b), corner(c)))
        .collect();
    format!(
        "[[wall]]\nname = \"{name}\"\nmaterial = \"seed\"\nshape = \"mesh\"\ntriangles = [{}]\n",
        triangles.join(", ")
    )
}

const DOMAIN: &str = "[domain]\nlower = \"-30 -30 -30 mm\"\nupper = \"30 30 30 mm\"\n";

#[test]
fn a_feed_fills_the_room_around_a_tool_and_that_inside_a_drum() {
    let feed = r#"
[[feed]]
name = "a"
material = "seed"
diameter = "2 mm"
from = { shape = "box", lower = "-12 -12 -12 mm", upper = "12 12 12 mm" }
count = 200
[[measure]]
name = "in"
kind = "region-count"
region = { shape = "mesh", wall = "block" }
[[stage]]
steps = 2
"#;
    // the box of the feed is 24 mm wide
    for (half, inside) in [(8, 0.0), (13, 200.0)] {
        let text = format!("{HEAD}\n{DOMAIN}\n{}{feed}", cube("block", half, 0));
        let place = tempfile::tempdir().unwrap();
        run_in(&parse(&text), place.path(), 1, &mut watcher());
        let series = series(place.path());
        assert_eq!(last(&series, "feed a grains"), 200.0, "{half}");
        assert_eq!(last(&series, "in grains"), inside, "{half}");
    }
}

#[test]
fn grains_inside_of_a_tool_are_told_and_those_of_a_drum_are_not() {
    let grains = |positions: &str| {
        format!(
            "[[grains]]\nmaterial = \"seed\"\nsource = \"list\"\ndiameter = \"2 mm\"\npositions = [{positions}]\n[[stage]]\nsteps = 2\n"
        )
    };
    let told = |positions: &str| {
        let text = format!("{HEAD}\n{DOMAIN}\n{}{}", cube("block", 8, 0), grains(positions));
        prepare(&parse(&text)).unwrap().warnings.join("\n")
    };
    let two = told("\"0 0 2 mm\", \"0 0 20 mm\"");
    assert!(
        two.contains("1 of 2 grains lie inside of wall `block`, a closed mesh") && two.contains("grain 1 at"),
        "{two}"
    );
    assert_eq!(told("\"0 0 2 mm\", \"0 0 -4 mm\""), "");
    assert_eq!(told("\"0 0 2 mm\", \"0 0 -4 mm\", \"0 0 20 mm\""), "");
    assert_eq!(told("\"0 0 20 mm\""), "");
}

#[test]
fn a_tool_that_comes_back_around_grains_says_so() {
    let text = format!(
        "{HEAD}\n{DOMAIN}\n{}{}",
        cube("block", 8, 0),
        "[[grains]]\nmaterial = \"seed\"\nsource = \"list\"\ndiameter = \"2 mm\"\npositions = [\"0 0 2 mm\", \"0 0 20 mm\"]\n\
         [[stage]]\nname = \"away\"\nsteps = 2\nabsent = [\"block\"]\n[[stage]]\nname = \"back\"\nsteps = 2\nabsent = []\n"
    );
    let place = tempfile::tempdir().unwrap();
    let mut watcher = watcher();
    let report = run_in(&parse(&text), place.path(), 1, &mut watcher);
    let told = "1 of 2 grains lie inside of wall `block`";
    let count = |texts: &[String]| texts.iter().filter(|text| text.contains(told)).count();
    assert_eq!(count(&watcher.messages), 1, "{:?}", watcher.messages);
    assert_eq!(count(&report.summary.warnings), 1);
}
