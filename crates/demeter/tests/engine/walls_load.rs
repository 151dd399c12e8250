//! What several walls bear together: the measure `walls-load`.

use super::exchange::{HEAD, last, parse, run_in, series, watcher};

/// The power of walls that turn about an axis is the torque about it times the angular velocity, whatever their shapes and forces.
#[test]
fn blades_turn_with_the_torque_about_their_axis() {
    let place = tempfile::tempdir().unwrap();
    let text = format!(
        r#"{HEAD}
[[grains]]
material = "seed"
source = "random"
region = {{ shape = "cylinder", start = "3 0 6 mm", end = "3 0 26 mm", radius = "12 mm" }}
diameter = "2 mm"
count = 400
[[wall]]
name = "vessel"
material = "seed"
shape = "cylinder"
start = "3 0 0 mm"
end = "3 0 30 mm"
radius = "13 mm"
[[wall]]
name = "floor"
material = "seed"
shape = "plane"
point = "0 0 0 mm"
normal = "z"
[[wall]]
name = "right"
material = "seed"
shape = "rectangle"
center = "9 0 3 mm"
half_u = "5 0 0 mm"
half_v = "0 -2 2 mm"
[[wall]]
name = "left"
material = "seed"
shape = "rectangle"
center = "-3 0 3 mm"
half_u = "-5 0 0 mm"
half_v = "0 2 2 mm"
[[measure]]
name = "shaft"
kind = "walls-load"
wall = ["right", "left"]
point = "3 0 20 mm"
axis = "-z"
[[measure]]
name = "floor"
kind = "walls-load"
wall = "floor"
[[stage]]
duration = "40 ms"
[[stage]]
duration = "40 ms"
motion.right = {{ rotation = {{ point = "3 0 0 mm", axis = "z", angular_velocity = "8 rad/s" }} }}
motion.left = {{ with = "right" }}
"#
    );
    run_in(&parse(&text), place.path(), 1, &mut watcher());
    let series = series(place.path());
    let (power, torque) = (&series["shaft power [W]"], &series["shaft axial torque [N m]"]);
    let largest = power.iter().copied().fold(0.0, f64::max);
    let mut turned = 0;
    for row in 0..power.len() {
        let sum = |of: &str| series[&format!("wall right {of}")][row] + series[&format!("wall left {of}")][row];
        let about = |of: &str, expected: f64, largest: f64| {
            let told = series[&format!("shaft {of}")][row];
            assert!(
                (told - expected).abs() <= 1e-9 * largest,
                "{row}: {of} {told} {expected}"
            );
        };
        about("power [W]", sum("power [W]"), largest);
        about("work [J]", sum("work [J]"), sum("work [J]"));
        for axis in ["x", "y", "z"] {
            let of = format!("force {axis} [N]");
            about(&of, sum(&of), 1.0);
        }
        about("axial force [N]", -sum("force z [N]"), 1.0);
        about("torque z [N m]", -torque[row], 1.0);
        if power[row] != 0.0 {
            // the axis points down: grains hold the blades back right-handed about it
            assert!(
                (torque[row] * 8.0 / power[row] - 1.0).abs() < 1e-9,
                "{row}: {}",
                torque[row]
            );
            turned += 1;
        }
    }
    assert!(turned >= 18 && largest > 1e-5, "{turned} {largest}");
}

/// The force on a floor acts where the grain touches it.
#[test]
fn a_torque_is_about_the_point() {
    let place = tempfile::tempdir().unwrap();
    let text = format!(
        r#"{HEAD}
[[grains]]
material = "seed"
source = "list"
positions = ["4 1 0.999 mm"]
diameter = "2 mm"
[[wall]]
name = "floor"
material = "seed"
shape = "plane"
point = "50 60 0 mm"
normal = "z"
[[measure]]
name = "floor"
kind = "walls-load"
wall = "floor"
[[measure]]
name = "beside"
kind = "walls-load"
wall = ["floor"]
point = "1 1 5 mm"
[[stage]]
duration = "1 ms"
"#
    );
    run_in(&parse(&text), place.path(), 1, &mut watcher());
    let series = series(place.path());
    let force = last(&series, "floor force z [N]");
    assert!(force < 0.0);
    for (title, arm) in [
        ("floor torque x [N m]", 1e-3),
        ("floor torque y [N m]", -4e-3),
        ("beside torque x [N m]", 0.0),
        ("beside torque y [N m]", -3e-3),
        ("beside torque z [N m]", 0.0),
    ] {
        let told = last(&series, title);
        assert!(
            (told - arm * force).abs() < 1e-12 * force.abs(),
            "{title}: {told} {force}"
        );
    }
    assert!(!series.contains_key("floor axial torque [N m]"));
}
