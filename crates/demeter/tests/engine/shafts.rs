//! Shafts: cylinders and cones that have grains outside.

use super::exchange::{HEAD, last, parse, run_in, series, watcher};

/// A contact with the side of a cylinder or a cone ends where a grain has wholly passed, so one that lies wholly within is touched by nothing.
#[test]
fn no_grain_comes_within_a_shaft() {
    for shape in [
        "shape = \"cylinder\"\nradius = \"6 mm\"",
        "shape = \"cone\"\nstart_radius = \"7 mm\"\nend_radius = \"5 mm\"",
    ] {
        let place = tempfile::tempdir().unwrap();
        let text = format!(
            r#"{HEAD}
[[feed]]
name = "rain"
material = "seed"
diameter = "2 mm"
number_rate = "20000 1/s"
velocity = "0 0 -0.2 m/s"
from = {{ shape = "box", lower = "-10 -10 10 mm", upper = "10 10 20 mm" }}
[[wall]]
name = "shaft"
material = "seed"
{shape}
start = "0 0 -20 mm"
end = "0 0 40 mm"
side = "outside"
[[measure]]
name = "within"
kind = "region-count"
region = {{ shape = "cylinder", start = "0 0 -30 mm", end = "0 0 40 mm", radius = "4.5 mm" }}
[[stage]]
duration = "10 ms"
"#
        );
        run_in(&parse(&text), place.path(), 1, &mut watcher());
        let series = series(place.path());
        assert!(last(&series, "grains") > 50.0);
        assert_eq!(
            series["within grains"].iter().copied().fold(0.0, f64::max),
            0.0,
            "{shape}"
        );
    }
}
