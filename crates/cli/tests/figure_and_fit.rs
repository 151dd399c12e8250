//! `demeter figure` and `demeter fit`.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests may fail as tests do")]

mod demeter;

use demeter::Place;
use std::fs;
use std::path::Path;

#[test]
fn figures_are_listed_drawn_and_checked() {
    let place = Place::new();
    let list = place.expect(0, &["figure", "--list"]).out;
    for name in ["antypov-1", "antypov-3", "jasevicius-4", "jasevicius-5-escape"] {
        assert!(list.contains(name), "{list}");
    }
    assert_eq!(place.expect(0, &["figure"]).out, list);
    assert!(place.names().is_empty());
    let told = place
        .expect(0, &["figure", "antypov-1", "antypov-3", "--output", "figures"])
        .out;
    assert!(
        told.matches("largest difference").count() == 4 && told.contains("antypov-3.csv"),
        "{told}"
    );
    let mut names: Vec<String> = fs::read_dir(place.path("figures"))
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    assert_eq!(
        names,
        ["antypov-1.csv", "antypov-1.svg", "antypov-3.csv", "antypov-3.svg"]
    );
    let csv = fs::read_to_string(place.path("figures/antypov-1.csv")).unwrap();
    let mut lines = csv.lines();
    assert_eq!(
        lines.next(),
        Some("curve,time [s],overlap [m],velocity [m/s],force [N]")
    );
    let last = lines.rfind(|line| line.starts_with("HSD integrated")).unwrap();
    let cells: Vec<f64> = last.split(',').skip(1).map(|cell| cell.parse().unwrap()).collect();
    assert!((cells[0] - 69.51247874e-6).abs() < 1e-13 && (cells[2] + 0.54).abs() < 1e-9);
    let answer = place.expect(0, &["figure", "jasevicius-4", "--json"]).json();
    let checks = answer["figures"][0]["checks"].as_array().unwrap();
    assert!(checks.iter().all(|c| c["largest_difference"].as_f64().unwrap() < 1e-6));
    assert!(place.path("jasevicius-4.svg").exists());
    let wrong = place.expect(2, &["figure", "antypov-7"]).err;
    assert!(
        wrong.contains("there is no figure `antypov-7`. Did you mean"),
        "{wrong}"
    );
}

#[test]
fn parameters_are_fitted_and_what_is_open_is_told() {
    let place = Place::new();
    let example = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/fit/mcc.toml");
    fs::copy(example, place.path("mcc.toml")).unwrap();
    let text = place.expect(0, &["fit", "mcc.toml"]).out;
    for part in [
        "restitution",
        "material.mcc.young_modulus",
        "normal = { law = \"hertz-tsuji\"",
    ] {
        assert!(text.contains(part), "{text}");
    }
    assert!(!text.contains("NOT") && !text.contains("another law"), "{text}");
    let answer = place.expect(0, &["fit", "mcc.toml", "--json"]).json();
    assert_eq!(
        (&answer["fits"], answer["parameters"].as_array().unwrap().len()),
        (&true.into(), 2)
    );
    let restitution = answer["parameters"][0]["value"].as_f64().unwrap();
    assert!((0.53..0.55).contains(&restitution));
    // without the contact times nothing is known of the modulus
    let open = [
        "fit",
        "mcc.toml",
        "--set",
        "observation=[{velocity = \"1 m/s\", restitution = 0.5}]",
    ];
    let text = place.expect(0, &open).out;
    assert!(
        text.contains("these observations do not fix material.mcc.young_modulus"),
        "{text}"
    );
    assert!(text.contains("measure contact_time at 1 m/s"), "{text}");
    let wrong = place.expect(2, &["fit", "mcc.toml", "--set", "fit.law=hertz"]).err;
    assert!(
        wrong.contains("unknown normal law `hertz`") && wrong.contains("1 error"),
        "{wrong}"
    );
}
