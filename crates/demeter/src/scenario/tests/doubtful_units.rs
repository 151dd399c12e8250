//! Values that would be usual in another unit.

use super::super::*;
use super::{parse, settle};

/// What is doubted of a sound scenario with some values changed.
fn doubts(overrides: &[&str]) -> Vec<String> {
    let scenario = parse(settle(), overrides).unwrap();
    let mut warnings = Vec::new();
    doubtful_units::check(&scenario, &mut warnings);
    warnings
}

#[test]
fn slips_of_units_are_doubted() {
    for (told, doubt) in [
        (
            "material.glass.density=\"1500 g/cm^3\"",
            "`material.glass.density` is 1500 g/cm^3; all matter has 1 to 25,000 kg/m^3. \
             Are 1500 kg/m^3 meant?",
        ),
        (
            "material.glass.density=\"0.9 kg/m^3\"",
            "`material.glass.density` is 0.9 kg/m^3; all matter has 1 to 25,000 kg/m^3. \
             Are 0.9 g/cm^3 meant?",
        ),
        (
            "material.glass.density=\"7.8 g/mm^3\"",
            "`material.glass.density` is 7.8 g/mm^3; all matter has 1 to 25,000 kg/m^3. \
             Are 7.8 g/cm^3 meant?",
        ),
        (
            "simulation.gravity=\"0 0 -9810 m/s^2\"",
            "`simulation.gravity` is 0 0 -9810 m/s^2; that of the Earth is 9.81 m/s^2. Is it meant in mm/s^2?",
        ),
        (
            "simulation.gravity=\"0 0 -9.81 mm/s^2\"",
            "`simulation.gravity` is 0 0 -9.81 mm/s^2; that of the Earth is 9.81 m/s^2. Is it meant in m/s^2?",
        ),
    ] {
        assert_eq!(doubts(&[told]), [doubt], "{told}");
    }
    let friction = doubts(&["contact.tangential.friction=30"]);
    let [friction] = friction.as_slice() else {
        panic!("{friction:?}")
    };
    assert!(
        friction.starts_with("`contact.tangential.friction` is 30;")
            && friction.contains("a friction of 0.5774, or 30 %"),
        "{friction}"
    );
}

#[test]
fn what_is_meant_as_it_is_written_is_not_doubted() {
    for overrides in [
        &[][..],
        // scaled to save steps; of a scene in units of its own; without a unit
        &["material.glass.density=\"2.5e9 kg/m^3\""],
        &[
            "material.glass.density=\"1.9 kg/m^3\"",
            "simulation.gravity=\"0 0 -1 m/s^2\"",
        ],
        &[
            "plain_numbers=\"SI\"",
            "material.glass.density=0.24",
            "simulation.gravity=[0, 0, -0.009]",
        ],
        // an asteroid, a centrifuge, none
        &["simulation.gravity=\"0 0 -1e-4 m/s^2\""],
        &["simulation.gravity=\"0 0 -300 m/s^2\""],
        &["simulation.gravity=\"0 0 0 m/s^2\""],
        // no sliding at all
        &["contact.tangential.friction=1e6"],
        &["contact.tangential.friction=1.5"],
    ] {
        assert_eq!(doubts(overrides), Vec::<String>::new(), "{overrides:?}");
    }
}
