//! How far grains reach: the measure `extent`.

use super::exchange::{HEAD, parse, run_in, series, watcher};

/// Told of four grains, of some of them, and of one that falls out of the region.
#[test]
fn an_extent_is_the_box_around_the_surfaces() {
    let grains = r#"
[[grains]]
material = "seed"
source = "list"
positions = ["1 2 3 mm", "5 -4 9 mm", "6 6 12 mm"]
diameter = "2 mm"
[[grains]]
material = "seed"
source = "list"
positions = ["-4 7 1 mm"]
diameter = "1 mm"
[[measure]]
name = "all"
kind = "extent"
[[measure]]
name = "low"
kind = "extent"
region = { shape = "box", upper = "10 10 10 mm" }
coarser_than = "1.5 mm"
[[measure]]
name = "high"
kind = "extent"
region = { shape = "half-space", point = "0 0 11.99 mm", normal = "z" }
[[stage]]
duration = "4 ms"
[domain]
lower = "-10 -10 -10 mm"
upper = "10 10 20 mm"
"#;
    for periodic in [false, true] {
        let place = tempfile::tempdir().unwrap();
        let sides = if periodic { "periodic = [\"y\"]" } else { "" };
        run_in(
            &parse(&format!("{HEAD}{grains}{sides}\n")),
            place.path(),
            1,
            &mut watcher(),
        );
        let series = series(place.path());
        let of = |measure: &str, row: usize| {
            let end = |end: &str| ["x", "y", "z"].map(|axis| series[&format!("{measure} {end} {axis} [m]")][row]);
            [end("lowest"), end("highest")].concat()
        };
        let assert_first = |measure: &str, mut expected: [f64; 6]| {
            if periodic {
                (expected[1], expected[4]) = (-10.0, 10.0);
            }
            for (told, expected) in of(measure, 0).iter().zip(expected) {
                assert!((told - 1e-3 * expected).abs() < 1e-12, "{measure}: {told} {expected}");
            }
        };
        assert_first("all", [-4.5, -5.0, 0.5, 7.0, 7.5, 13.0]);
        assert_first("low", [0.0, -5.0, 2.0, 6.0, 3.0, 10.0]);
        assert_first("high", [5.0, 5.0, 11.0, 7.0, 7.0, 13.0]);
        let rows = series["step"].len();
        assert!(of("high", rows - 1).iter().all(|end| end.is_nan()));
    }
}
