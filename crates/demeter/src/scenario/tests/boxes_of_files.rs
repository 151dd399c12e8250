//! Files of grains in a domain that is periodic.

use super::super::*;

/// A file of two grains, whose box is told, in a domain of 10 m that is periodic along x and y.
fn prepared(bounds: &str, first: &str, more: &str) -> Prepared {
    let folder = tempfile::tempdir().unwrap();
    let dump = format!(
        "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS {bounds}\nITEM: ATOMS id x y z radius\n1 {first} 0.5\n2 7 4 5 0.5\n"
    );
    std::fs::write(folder.path().join("grains.dump"), dump).unwrap();
    let text = format!(
        r#"
[domain]
lower = "0 0 0 m"
upper = "10 10 10 m"
periodic = ["x", "y"]
[material.glass]
young_modulus = "5 MPa"
poisson_ratio = 0.25
density = "2500 kg/m^3"
[contact]
normal = {{ law = "hertz-tsuji", restitution = 0.5 }}
[[grains]]
material = "glass"
source = "file"
file = "grains.dump"
{more}
[[stage]]
duration = "0.1 s"
"#
    );
    let scenario = Scenario::parse(&text, "box.toml", folder.path(), &[]).unwrap();
    prepare(&scenario).unwrap()
}

#[test]
fn a_box_of_a_file_that_repeats_itself_otherwise_is_told() {
    let told = |bounds: &str, more: &str| prepared(bounds, "3 4 5", more).warnings.join("\n");
    let tilted = told("xy xz yz pp pp pp\n0 14 4\n0 10 0\n0 10 0", "");
    assert!(
        tilted.contains("insertion `grains 1`: the box of its file is tilted (xy = 4 m"),
        "{tilted}"
    );
    let shorter = told("pp pp pp\n0 10\n0 7\n0 7", "");
    assert!(shorter.contains("is 7 m along y, and the domain 10 m:"), "{shorter}");
    for (bounds, more) in [
        // elsewhere, open where it differs, or scaled to the domain
        ("pp pp pp\n-5 5\n0 10\n0 7", ""),
        ("pp ff ff\n0 10\n0 7\n0 7", ""),
        ("pp pp pp\n0 20\n0 20\n0 7", "scale = 0.5"),
    ] {
        let told = told(bounds, more);
        assert!(!told.contains("of its file"), "{bounds}: {told}");
    }
}

#[test]
fn grains_beyond_periodic_sides_are_put_back_from_however_far() {
    let place = |first: &str| prepared("pp pp ff\n0 10\n0 10\n0 10", first, "").setup.grains.position[0];
    assert_eq!(place("3 4 5").to_array(), [3.0, 4.0, 5.0]);
    assert_eq!(place("53 -46 5").to_array(), [3.0, 4.0, 5.0]);
    assert_eq!(place("10 -10 5").to_array(), [0.0, 0.0, 5.0]);
}
