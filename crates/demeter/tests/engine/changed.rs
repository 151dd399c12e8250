//! Runs that go on with a scenario that was changed: what counts from there on, what is refused, and what is told to have no effect.

use super::exchange::{HEAD, last, parse, run_in, series, watcher};
use demeter::scenario::{RunError, RunOptions, resume};
use std::fs;
use std::path::Path;

/// Steps at which grains may come follow each other closely, and they fly away from the inlet.
fn fed(told: &str, rest: &str) -> String {
    format!(
        r#"{HEAD}
[domain]
lower = "-20 -20 -20 mm"
upper = "20 20 100 mm"
[[wall]]
name = "lid"
material = "seed"
shape = "disc"
center = "0 0 90 mm"
normal = "-z"
radius = "5 mm"
[[feed]]
name = "a"
material = "seed"
from = {{ shape = "rectangle", center = "0 0 0 mm", half_u = "18 0 0 mm", half_v = "0 18 0 mm" }}
velocity = "0 0 1 m/s"
every = "0.5 ms"
{told}
[[stage]]
name = "one"
duration = "20 ms"
{rest}
"#
    )
}

const SECOND: &str = "[[stage]]\nname = \"two\"\nduration = \"20 ms\"";

/// Lets the run in a folder go on with another text, and tells what is said.
fn go_on(folder: &Path, text: &str) -> Result<Vec<String>, RunError> {
    fs::write(folder.join("scenario.toml"), text).unwrap();
    let options = RunOptions {
        threads: Some(1),
        changed: true,
        ..RunOptions::default()
    };
    let mut watcher = watcher();
    resume(folder, options, &mut watcher)?;
    Ok(watcher.messages)
}

/// Grains that came after 20 ms, after 22 ms and at the end of a run whose feed is changed after 20 ms.
fn grains(before: &str, after: &str) -> [f64; 3] {
    let place = tempfile::tempdir().unwrap();
    run_in(&parse(&fed(before, "")), place.path(), 1, &mut watcher());
    go_on(place.path(), &fed(after, SECOND)).unwrap();
    let series = series(place.path());
    let came = &series["feed a grains"];
    let at = |time: f64| {
        let row = series["time [s]"].iter().rposition(|t| *t < time + 1e-4).unwrap();
        came[row]
    };
    [at(0.02), at(0.022), last(&series, "feed a grains")]
}

/// What came due since grains came last may lack.
fn assert_came(told: &str, came: [f64; 3], expected: [f64; 3]) {
    let near = came
        .iter()
        .zip(expected)
        .all(|(came, expected)| (-6.0..=1.0).contains(&(came - expected)));
    assert!(near, "{told}: {came:?}, not {expected:?}");
}

#[test]
fn another_rate_counts_from_where_it_is_told() {
    let rate = |told: &str| format!("diameter = \"1 mm\"\n{told}");
    let slow = rate("number_rate = \"5000 1/s\"");
    for (after, expected) in [
        ("number_rate = \"10000 1/s\"", [100.0, 120.0, 300.0]),
        ("number_rate = \"2500 1/s\"", [100.0, 105.0, 150.0]),
        // a grain weighs 0.5236 mg
        ("mass_rate = \"5.236 g/s\"", [100.0, 120.0, 300.0]),
    ] {
        assert_came(after, grains(&slow, &rate(after)), expected);
    }
}

#[test]
fn a_feed_that_was_done_goes_on_to_another_end() {
    let until = |end: &str| format!("diameter = \"1 mm\"\nnumber_rate = \"5000 1/s\"\n{end}");
    let (fifty, eighty) = (until("count = 50"), until("count = 80"));
    assert_came("more", grains(&fifty, &eighty), [50.0, 60.0, 80.0]);
    assert_eq!(grains(&eighty, &fifty), [80.0; 3]);
    let [before, after] = ["10 ms", "30 ms"].map(|end| until(&format!("until = \"{end}\"")));
    assert_came("later", grains(&before, &after), [50.0, 60.0, 100.0]);
}

#[test]
fn what_a_new_run_cannot_do_is_refused_where_a_run_goes_on() {
    let place = tempfile::tempdir().unwrap();
    let coarse = "diameter = \"1 mm\"\nnumber_rate = \"500 1/s\"";
    run_in(&parse(&fed(coarse, "")), place.path(), 1, &mut watcher());
    let refused = |text: &str, part: &str| {
        let error = go_on(place.path(), text).unwrap_err();
        let told = format!("{error} {error:?}");
        assert!(told.contains(part), "{part}: {told}");
    };
    refused(
        &fed(&coarse.replace("1 mm", "0.005 mm"), SECOND),
        "the time step of the run is unsafe for the feeds and walls that are told now",
    );
    refused(
        &fed(
            coarse,
            &format!("{SECOND}\nmotion.lid = {{ velocity = \"0 0 200 m/s\" }}"),
        ),
        "wall `lid` moves at up to 2.0000e2 m/s",
    );
    refused(
        &fed(coarse, &format!("{SECOND}\nstop = {{ motion_done = \"lid\" }}")),
        "wall `lid` has no motion in this stage",
    );
}

#[test]
fn what_is_told_of_the_past_has_no_effect_and_says_so() {
    let place = tempfile::tempdir().unwrap();
    let coarse = "diameter = \"1 mm\"\nnumber_rate = \"500 1/s\"";
    run_in(&parse(&fed(coarse, "")), place.path(), 1, &mut watcher());
    let tags = "[[tag]]\nvalue = 1\nat = \"10 ms\"\n[[tag]]\nvalue = 2\nat = \"30 ms\"";
    let later = fed(coarse, &format!("{SECOND}\n{tags}")).replacen("duration = \"20 ms\"", "duration = \"25 ms\"", 1);
    let said = go_on(place.path(), &later).unwrap().join("\n");
    let told = |part: &str| said.contains(part);
    assert!(
        told("tag[0] is given at 0.01 s, and the run goes on from 2.0"),
        "{said}"
    );
    assert!(!told("tag[1]"), "{said}");
    assert!(
        told("stage `one` is over: what is told otherwise of its end has no effect"),
        "{said}"
    );
}
