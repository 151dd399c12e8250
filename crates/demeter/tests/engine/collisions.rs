//! Contacts that begin, counted with their energies.

use super::silent::{Silent, parsed};
use demeter::results::Columns;
use demeter::scenario::{RunOptions, Scenario, run};
use std::f64::consts::PI;
use std::path::Path;

/// Runs a scenario and looks at what it left.
fn after<T>(text: &str, look: impl FnOnce(&Path) -> T) -> T {
    let place = tempfile::tempdir().unwrap();
    std::fs::write(place.path().join("floor.stl"), floor()).unwrap();
    let folder = place.path().join("run");
    run(&parsed(text, place.path()), &folder, RunOptions::default(), &mut Silent).unwrap();
    look(&folder)
}

/// The values of columns of a table in its last row.
fn last<const N: usize>(file: &Path, columns: [&str; N]) -> [f64; N] {
    before_last(file, 0, columns)
}

/// The same so many rows before the last.
fn before_last<const N: usize>(file: &Path, rows: usize, columns: [&str; N]) -> [f64; N] {
    let table = Columns::read(file).unwrap();
    columns.map(|title| *table.numbers(title).unwrap().iter().nth_back(rows).unwrap())
}

/// Rows of triangles from x = -10 to 30 and y = 20 to 40.
fn floor() -> String {
    let triangles = (-1..3).flat_map(|k| {
        let (left, right) = (10 * k, 10 * k + 10);
        [
            [(left, 20), (right, 20), (right, 40)],
            [(left, 20), (right, 40), (left, 40)],
        ]
    });
    let mut text = "solid floor\n".to_string();
    for corners in triangles {
        let vertices = corners.map(|(x, y)| format!("vertex {x} {y} 0\n"));
        text += &format!(
            "facet normal 0 0 1\nouter loop\n{}endloop\nendfacet\n",
            vertices.concat()
        );
    }
    text + "endsolid floor\n"
}

fn assert_near(found: f64, expected: f64, share: f64, what: &str) {
    assert!(
        (found / expected - 1.0).abs() < share,
        "{what}: {found:e} in place of {expected:e}"
    );
}

const STEEL_AND_CLAY: &str = r#"
title = "collisions"
[material.steel]
young_modulus = "1 GPa"
poisson_ratio = 0.3
density = "7800 kg/m^3"
[material.clay]
young_modulus = "1 GPa"
poisson_ratio = 0.3
density = "2000 kg/m^3"
[contact]
normal = { law = "hertz-tsuji", restitution = 0.5 }
tangential = { law = "mindlin-history", friction = 0.3 }
"#;

const HALF_SPACE: &str = "multi_contact = { law = \"half-space\" }\n";

#[test]
fn a_collision_has_the_energies_of_the_approach() {
    let pair = r#"
[[grains]]
material = "steel"
source = "list"
positions = ["-5 0 0 mm"]
diameter = "4 mm"
velocity = "1 0 0 m/s"
[[grains]]
material = "clay"
source = "list"
positions = ["5 2 0 mm"]
diameter = "6 mm"
[[measure]]
name = "all"
kind = "collisions"
[[measure]]
name = "steel-on-clay"
kind = "collisions"
material = "steel"
partner = "clay"
[[measure]]
name = "small-on-clay"
kind = "collisions"
finer_than = "5 mm"
partner = "clay"
[[measure]]
name = "clay-on-clay"
kind = "collisions"
material = "clay"
partner = "clay"
[[measure]]
name = "elsewhere"
kind = "collisions"
region = { shape = "sphere", center = "0 0 0 mm", radius = "1 mm" }
[[measure]]
name = "there"
kind = "collisions"
region = { shape = "sphere", center = "2.3 0.8 0 mm", radius = "0.3 mm" }
[[stage]]
name = "meet"
duration = "8 ms"
"#;
    let mass = |density: f64, diameter: f64| density * PI / 6.0 * diameter.powi(3);
    let (steel, clay) = (mass(7800.0, 4e-3), mass(2000.0, 6e-3));
    let half = 0.5 * steel * clay / (steel + clay);
    for coupling in ["", HALF_SPACE] {
        after(&format!("{STEEL_AND_CLAY}{coupling}{pair}"), |folder| {
            let series = folder.join("series.csv");
            let [count, normal, tangential, walls] = last(
                &series,
                [
                    "all collisions",
                    "all normal energy",
                    "all tangential energy",
                    "all wall collisions",
                ],
            );
            assert_eq!([count, walls], [1.0, 0.0]);
            // centres 2 mm beside each other, 5 mm apart
            assert_near(normal, half * 21.0 / 25.0, 1e-3, "normal");
            assert_near(tangential, half * 4.0 / 25.0, 1e-3, "tangential");
            let of_some = ["steel-on-clay", "small-on-clay", "clay-on-clay", "elsewhere", "there"];
            let counts = last(
                &series,
                of_some
                    .map(|name| format!("{name} collisions"))
                    .each_ref()
                    .map(String::as_str),
            );
            assert_eq!(counts, [1.0, 1.0, 0.0, 0.0, 1.0]);
        });
    }
}

/// A grain between two plates bulges against its neighbour.
#[test]
fn contacts_that_feel_each_other_begin_where_displaced_surfaces_meet() {
    let squeezed = r#"
[simulation]
max_overlap = 0.1
[[grains]]
material = "steel"
source = "list"
positions = ["0 0 0 mm", "10.002 0 0 mm"]
diameter = "10 mm"
[[wall]]
name = "bottom"
material = "steel"
shape = "plane"
point = "0 0 -5.001 mm"
normal = "z"
motion = { velocity = "0 0 0.1 m/s" }
[[wall]]
name = "top"
material = "steel"
shape = "plane"
point = "0 0 5.001 mm"
normal = "0 0 -2"
motion = { velocity = "0 0 -0.1 m/s" }
[[measure]]
name = "all"
kind = "collisions"
[[stage]]
name = "squeeze"
duration = "3 ms"
[output]
series = "0.1 ms"
"#;
    let mass = 7800.0 * PI / 6.0 * 10e-3_f64.powi(3);
    for (coupling, expected) in [("", 0.0), (HALF_SPACE, 1.0)] {
        after(&format!("{STEEL_AND_CLAY}{coupling}{squeezed}"), |folder| {
            let series = folder.join("series.csv");
            let titles = ["all collisions", "all wall collisions", "all wall normal energy"];
            let [between, walls, energy] = last(&series, titles);
            assert_eq!([between, walls], [expected, 4.0]);
            // of plates that come at their speed
            assert_near(energy, walls * 0.5 * mass * 0.01, 1e-3, "normal energy");
        });
    }
}

#[test]
fn every_bounce_is_a_collision_and_what_rolls_has_none() {
    let time_to_fall = (2.0 * 10e-3_f64 / 9.81).sqrt();
    let bouncing = format!(
        r#"
[simulation]
gravity = "0 0 -9.81 m/s^2"
[[grains]]
name = "bouncing"
material = "steel"
source = "list"
positions = ["0 0 11 mm"]
diameter = "2 mm"
# overlapped as much as their weight asks for, and on their way from one rectangle and one triangle to the next
[[grains]]
name = "rolling"
material = "steel"
source = "list"
positions = ["5 0 0.99994 mm", "5 30 0.99994 mm"]
diameter = "2 mm"
velocity = "0.1 0 0 m/s"
angular_velocity = "0 100 0 rad/s"
[[wall]]
name = "left"
material = "clay"
shape = "rectangle"
center = "0 0 0 mm"
half_u = "10 0 0 mm"
half_v = "0 10 0 mm"
[[wall]]
name = "right"
material = "clay"
shape = "rectangle"
center = "20 0 0 mm"
half_u = "10 0 0 mm"
half_v = "0 10 0 mm"
[[wall]]
name = "mesh"
material = "clay"
shape = "mesh"
file = "floor.stl"
unit = "mm"
[[measure]]
name = "bounces"
kind = "collisions"
batch = "bouncing"
partner = "clay"
lower = "1 nJ"
upper = "10 uJ"
bins = 4
[[measure]]
name = "rolls"
kind = "collisions"
batch = "rolling"
[[stage]]
name = "bounce"
duration = "{} s"
"#,
        // impacts at 1, 2, 2.5 and 2.75 of that time, the next at 2.875
        2.8 * time_to_fall
    );
    let dropped = 7800.0 * PI / 6.0 * 2e-3_f64.powi(3) * 9.81 * 10e-3;
    after(&format!("{STEEL_AND_CLAY}{bouncing}"), |folder| {
        let [count, energy, rolls, end] = last(
            &folder.join("series.csv"),
            [
                "bounces wall collisions",
                "bounces wall normal energy",
                "rolls wall collisions",
                "time",
            ],
        );
        assert_near(end, 2.8 * time_to_fall, 1e-3, "end");
        assert_eq!([count, rolls], [4.0, 0.0]);
        let quarter = 0.25_f64;
        let expected = dropped * (1.0 + quarter + quarter.powi(2) + quarter.powi(3));
        assert_near(energy, expected, 3e-3, "energies");
        // 3.2, 0.8, 0.2 and 0.05 uJ in bins from 1e-9, 1e-8, 1e-7 and 1e-6 J on
        let bins = last(
            &folder.join("distributions/bounces.csv"),
            [
                "below",
                "1e-9 [J]",
                "1e-8 [J]",
                "1e-7 [J]",
                "1e-6 [J]",
                "above",
                "collisions",
                "normal energy",
            ],
        );
        assert_eq!(bins[..7], [0.0, 0.0, 1.0, 2.0, 1.0, 0.0, 4.0]);
        assert_eq!(bins[7], energy);
    });
}

/// In a gas of elastic spheres of one size grains collide `4 n d^2 g sqrt(pi T / m)` times per time, with `g` of Carnahan and Starling, and
/// the energies of approach are distributed as `exp(-E/T)/T`, so their mean is `T`, the temperature per degree of freedom; that of the two
/// directions in the plane, which do not matter for whether they meet, is the same (Chapman and Cowling, The Mathematical Theory of
/// Non-Uniform Gases, chapter 5).
#[test]
fn an_elastic_gas_collides_as_kinetic_theory_tells() {
    let gas = r#"
title = "gas"
seed = 3
[simulation]
gravity = "0 0 0 m/s^2"
[domain]
lower = "0 0 0 mm"
upper = "20 20 20 mm"
periodic = ["x", "y", "z"]
[material.glass]
young_modulus = "1 GPa"
poisson_ratio = 0.3
density = "2500 kg/m^3"
[contact]
normal = { law = "hertz-tsuji", restitution = 1.0 }
[[grains]]
material = "glass"
source = "random"
region = { shape = "box", lower = "0 0 0 mm", upper = "20 20 20 mm" }
diameter = "1 mm"
velocity_deviation = "1 m/s"
count = 1000
[[measure]]
name = "all"
kind = "collisions"
lower = "1.25 uJ"
upper = "2.5 uJ"
bins = 1
[[stage]]
name = "fly"
duration = "6 ms"
[output]
series = "1 ms"
frames = "never"
"#;
    after(gas, |folder| {
        let [count, normal, tangential, kinetic] = last(
            &folder.join("series.csv"),
            [
                "all collisions",
                "all normal energy",
                "all tangential energy",
                "kinetic energy",
            ],
        );
        let (grains, diameter, volume) = (1000.0, 1e-3_f64, 20e-3_f64.powi(3));
        let mass = 2500.0 * PI / 6.0 * diameter.powi(3);
        let temperature = 2.0 * kinetic / (3.0 * grains);
        let filled = grains * PI / 6.0 * diameter.powi(3) / volume;
        let pair_correlation = (1.0 - 0.5 * filled) / (1.0 - filled).powi(3);
        let speed = (PI * temperature / mass).sqrt();
        let rate = 4.0 * grains / volume * diameter.powi(2) * pair_correlation * speed;
        // while two grains touch, 1.6 % of the time between two collisions, neither is on its way to others
        assert_near(count, 0.5 * grains * rate * 6e-3, 0.06, "collisions");
        assert_near(normal / count, temperature, 0.06, "normal energy");
        assert_near(tangential / count, temperature, 0.06, "tangential energy");
        // the row of those between grains comes before that of those with walls
        let bins = folder.join("distributions/all.csv");
        let [below, between, above] = before_last(&bins, 1, ["below", "1.25e-6", "above"]);
        let shares = [1.25e-6, 2.5e-6].map(|energy| (-energy / temperature).exp());
        let expected = [1.0 - shares[0], shares[0] - shares[1], shares[1]];
        for (found, expected) in [below, between, above].into_iter().zip(expected) {
            assert!(
                (found / count - expected).abs() < 0.025,
                "{} in place of {expected}",
                found / count
            );
        }
    });
}

#[test]
fn bins_are_whole_and_partners_known() {
    let refused = |more: &str| {
        let text = format!(
            "{STEEL_AND_CLAY}{more}\n[[grains]]\nmaterial = \"clay\"\nsource = \"list\"\npositions = [\"0 0 0 mm\"]\ndiameter = \"1 mm\"\n\
             [[stage]]\nname = \"a\"\nduration = \"1 ms\"\n"
        );
        match Scenario::parse(&text, "case", Path::new(""), &[]) {
            Err(faults) => faults.render(false),
            Ok(scenario) => demeter::scenario::prepare(&scenario).err().unwrap().render(false),
        }
    };
    let measure = "[[measure]]\nname = \"hits\"\nkind = \"collisions\"\n";
    let text = refused(&format!("{measure}lower = \"1 nJ\"\n"));
    assert!(text.contains("bins of energies lack `upper` and `bins`"), "{text}");
    let text = refused(&format!("{measure}lower = \"1 J\"\nupper = \"1 mJ\"\nbins = 3\n"));
    assert!(text.contains("must end above their beginning"), "{text}");
    let text = refused(&format!("{measure}partner = \"steal\"\n"));
    assert!(
        text.contains("unknown material `steal`") && text.contains("steel"),
        "{text}"
    );
}
