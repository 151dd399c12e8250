//! Closed meshes with grains around them, and tubes with grains inside: nothing comes where a wall is solid, and what is put there is
//! told.

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

/// A cylinder of radius 8 mm, or a cone of that mean radius, from z = -20 to 20 mm with its axis at some x, as a wall.
fn tube(name: &str, shape: &str, x: i32, side: &str) -> String {
    let size = match shape {
        "cone" => "start_radius = \"4 mm\"\nend_radius = \"12 mm\"",
        _ => "radius = \"8 mm\"",
    };
    format!(
        "[[wall]]\nname = \"{name}\"\nmaterial = \"seed\"\nshape = \"{shape}\"\nstart = \"{x} 0 -20 mm\"\nend = \"{x} 0 20 mm\"\n{size}\n\
         side = \"{side}\"\n"
    )
}

/// How many of 200 grains that a feed lets come between some x lie in a region.
fn fed_into(walls: &str, (from, to): (i32, i32), region: &str) -> f64 {
    let feed = format!(
        r#"
[[feed]]
name = "a"
material = "seed"
diameter = "1 mm"
from = {{ shape = "box", lower = "{from} -12 -4 mm", upper = "{to} 12 4 mm" }}
count = 200
[[measure]]
name = "in"
kind = "region-count"
region = {region}
[[stage]]
steps = 2
"#
    );
    let place = tempfile::tempdir().unwrap();
    run_in(
        &parse(&format!("{HEAD}\n{DOMAIN}\n{walls}{feed}")),
        place.path(),
        1,
        &mut watcher(),
    );
    let series = series(place.path());
    assert_eq!(last(&series, "feed a grains"), 200.0, "{walls}");
    last(&series, "in grains")
}

const OF_TUBE: &str = r#"{ shape = "cylinder", start = "0 0 -20 mm", end = "0 0 20 mm", radius = "9 mm" }"#;

#[test]
fn a_feed_keeps_off_the_back_of_tubes() {
    for shape in ["cylinder", "cone"] {
        let alone = tube("one", shape, 0, "inside");
        assert_eq!(fed_into(&alone, (-12, 12), OF_TUBE), 200.0, "{shape}");
        // on both sides, where the tube has both
        let both = tube("one", shape, 0, "both");
        assert!((1.0..200.0).contains(&fed_into(&both, (-12, 12), OF_TUBE)), "{shape}");
        // beside the tube alone
        assert_eq!(fed_into(&alone, (13, 24), OF_TUBE), 0.0, "{shape}");
    }
    let absent = format!(
        "{}[[stage]]\nname = \"first\"\nsteps = 2\nabsent = [\"one\"]\n",
        tube("one", "cylinder", 0, "inside")
    );
    assert!((1.0..200.0).contains(&fed_into(&absent, (-12, 12), OF_TUBE)));
}

#[test]
fn a_feed_fills_tubes_that_stand_side_by_side() {
    let two = tube("one", "cylinder", -9, "inside") + &tube("other", "cylinder", 9, "inside");
    let tubes = ["-9", "9"].map(|x| {
        let region =
            format!(r#"{{ shape = "cylinder", start = "{x} 0 -20 mm", end = "{x} 0 20 mm", radius = "8 mm" }}"#);
        fed_into(&two, (-17, 17), &region)
    });
    assert!(
        tubes.iter().all(|grains| *grains > 50.0) && tubes[0] + tubes[1] == 200.0,
        "{tubes:?}"
    );
    // into one alone
    assert_eq!(
        fed_into(&two, (-15, -5), OF_TUBE.replace("0 0", "-9 0").as_str()),
        200.0
    );
}

#[test]
fn grains_behind_the_side_of_a_tube_are_told() {
    let told = |walls: &str, positions: &str| {
        let text = format!(
            "{HEAD}\n{DOMAIN}\n{walls}[[grains]]\nmaterial = \"seed\"\nsource = \"list\"\ndiameter = \"2 mm\"\npositions = [{positions}]\n\
             [[stage]]\nsteps = 2\n"
        );
        prepare(&parse(&text)).unwrap().warnings.join("\n")
    };
    for shape in ["cylinder", "cone"] {
        let alone = tube("one", shape, 0, "inside");
        let text = told(&alone, "\"15 0 0 mm\", \"0 0 0 mm\"");
        assert!(
            text.contains("1 of 2 grains lie outside of wall `one`") && text.contains("grain 1 at"),
            "{text}"
        );
        // within, and beyond an end
        assert_eq!(told(&alone, "\"0 0 0 mm\", \"15 0 22 mm\""), "");
        assert_eq!(told(&tube("one", shape, 0, "both"), "\"15 0 0 mm\", \"0 0 0 mm\""), "");
        // in another one
        let two = alone + &tube("other", shape, 18, "inside");
        assert_eq!(told(&two, "\"18 0 0 mm\", \"0 0 0 mm\""), "");
    }
}
