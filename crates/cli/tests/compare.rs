//! `demeter compare`, and `demeter fit` of a packing.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests may fail as tests do")]

mod demeter;

use demeter::Place;
use std::fs;

/// A few soft grains, squeezed and released three times.
const SQUEEZE: &str = include_str!("../../demeter/src/calibrate/packing/squeeze.toml");

/// A place with a run of the scenario, and one of softer grains.
fn place() -> Place {
    let place = Place::new();
    place.write("squeeze.toml", SQUEEZE);
    place.expect(0, &["run", "squeeze.toml", "--out", "stiff"]);
    let softer = "material.gel.young_modulus=\"25 kPa\"";
    place.expect(0, &["run", "squeeze.toml", "--out", "soft", "--set", softer]);
    place
}

/// Distributions of two bins beside a series, all contacts of a row alike.
fn write_forces(place: &Place, run: &str, counts: &str) {
    let series = fs::read_to_string(place.path(run).join("series.csv")).unwrap();
    let mut text =
        "step,time [s],stage,stage time [s],strain,grains,between,contacts,sum [N],0,0.005,above\n".to_string();
    for line in series.lines().skip(1) {
        let cells: Vec<&str> = line.split(',').take(4).collect();
        for between in ["grains", "walls"] {
            text += &format!("{},0.0,27,{between},30,1.0,{counts}\n", cells.join(","));
        }
    }
    fs::create_dir_all(place.path(run).join("distributions")).unwrap();
    fs::write(place.path(run).join("distributions/forces.csv"), text).unwrap();
}

#[test]
fn runs_are_compared_with_a_run() {
    let place = place();
    let told = place
        .expect(0, &["compare", "stiff", "soft", "--reference", "stiff"])
        .out;
    assert!(told.starts_with("reference stiff, by strain\n"), "{told}");
    assert!(
        told.contains("soft: bhat is left out: the run has no force distribution"),
        "{told}"
    );
    write_forces(&place, "stiff", "15,15,0");
    write_forces(&place, "soft", "24,6,0");
    let arguments = [
        "compare",
        "stiff",
        "soft",
        "--reference",
        "stiff",
        "--discard",
        "1",
        "--threshold",
        "5 mN",
        "--also",
        "coordination",
        "--out",
        "table",
        "--json",
    ];
    let answer = place.expect(0, &arguments).json();
    let (itself, soft) = (&answer["runs"][0], &answer["runs"][1]);
    assert_eq!((&itself["cycles"], &itself["discarded"]), (&2.into(), &1.into()));
    for (metric, value) in [("rtop", 1.0), ("errf", 0.0), ("errz", 0.0), ("bhat", 0.0)] {
        let found = itself[metric]["value"].as_f64().unwrap();
        assert!((found - value).abs() < 1e-12, "{metric} {found}");
    }
    let of = |metric: &str, value: &str| soft[metric][value].as_f64().unwrap();
    assert!((0.4..0.7).contains(&of("rtop", "value")) && of("rtop", "deviation") > 0.0);
    assert!(of("errf", "value") > 0.01);
    // 30 contacts between grains and 30 with walls, a fifth of them above the threshold
    let z = (2.0 * 30.0 + 30.0) / 27.0;
    assert!((of("errz_at_threshold", "value") - 0.8 * z).abs() < 1e-12);
    assert!(of("errz", "threshold") == 0.0 && of("errz", "value") < 1e-12);
    let bhat = -(0.4f64.sqrt() + 0.1f64.sqrt()).ln();
    assert!((of("bhat", "value") - bhat).abs() < 1e-12);

    let metrics = fs::read_to_string(place.path("table/metrics.csv")).unwrap();
    assert!(metrics.starts_with("run,cycles,discarded,Rtop,Rtop deviation,errf [N],errZ,tau [N],errZ at threshold"));
    assert_eq!(metrics.lines().count(), 3);
    let cycles = fs::read_to_string(place.path("table/soft/cycles.csv")).unwrap();
    let titles = "phase,strain,cycles,force [N],force deviation [N],contacts per grain,contacts per grain above 0 N,\
                  contacts per grain above 0.005 N,coordination,coordination deviation";
    assert_eq!(cycles.lines().next(), Some(titles));
    // 20 rows and the state before, in both phases
    assert_eq!(cycles.lines().count(), 1 + 2 * 21);
    assert!(place.path("table/stiff-2/cycles.csv").is_file());
}

#[test]
fn a_run_is_compared_with_a_measured_curve() {
    let place = place();
    place.write(
        "measured.csv",
        "compression [m],loading force [N]\n0.001,0.1\n0.0029,0.3\n",
    );
    let arguments = [
        "compare",
        "stiff",
        "--reference",
        "measured.csv",
        "--loading-only",
        "--json",
    ];
    let answer = place.expect(0, &arguments).json();
    assert_eq!(answer["position"], "compression");
    let run = &answer["runs"][0];
    assert!((0.8..1.2).contains(&run["rtop"]["value"].as_f64().unwrap()), "{run}");
    assert!(
        run["errz"].is_null()
            && run["left_out"]["errZ"]
                .as_str()
                .unwrap()
                .contains("no force distribution")
    );

    for (arguments, expected) in [
        (["--load", "press"], "no stage `press`"),
        (["--force", "wall lid force z"], "no column `wall lid"),
        (["--discard", "3"], "holds 3 cycles"),
        (["--threshold", "4 mm"], "--threshold `4 mm`: this is no force"),
        (["--distribution", "forces"], "holds no force distribution `forces`"),
    ] {
        let all = [&["compare", "stiff", "--reference", "measured.csv"], &arguments[..]].concat();
        let wrong = place.expect(2, &all).err;
        assert!(wrong.contains(expected), "{wrong}\n{expected}");
    }
    let wrong = place
        .expect(2, &["compare", "nothing", "--reference", "measured.csv"])
        .err;
    assert!(
        wrong.contains("`nothing` is not the folder of a Demeter run"),
        "{wrong}"
    );
    let measured = ["compare", "stiff", "--reference", "measured.csv", "--loading-only"];
    let wrong = place
        .expect(2, &[&measured[..], &["--reference-threshold", "1 mN"]].concat())
        .err;
    assert!(
        wrong.contains("--reference-threshold leaves out contacts of a run"),
        "{wrong}"
    );
    let wrong = place.expect(2, &["compare", "stiff", "--reference", "nothing.csv"]).err;
    assert!(wrong.contains("no run and no file `nothing.csv`"), "{wrong}");
}

#[test]
fn a_modulus_is_fitted_to_a_force() {
    let place = Place::new();
    place.write("squeeze.toml", SQUEEZE);
    let fit = r#"
[packing]
scenario = "squeeze.toml"
unknown = { key = "material.gel.young_modulus", from = "20 kPa", to = "90 kPa" }
match = "top"
tolerance = "5 kPa"
[packing.measured]
loading = [[0.0967, "0.3 N"]]
"#;
    place.write("fit.toml", fit);
    let text = place.expect(0, &["fit", "fit.toml"]).out;
    for part in [
        "material.gel.young_modulus = ",
        "(Rtop = 1)",
        "last interval",
        "scatter over cycles",
        "20000 Pa",
    ] {
        assert!(text.contains(part), "{text}");
    }
    let answer = place.expect(0, &["fit", "fit.toml", "--json"]).json();
    assert_eq!((&answer["found"], &answer["unit"]), (&true.into(), &"Pa".into()));
    assert!((40e3..60e3).contains(&answer["value"].as_f64().unwrap()), "{answer}");
    let trials = answer["trials"].as_array().unwrap();
    assert!(trials.iter().all(|t| t["reused"] == true) && place.path("runs/fit-fit/20000_Pa/summary.json").is_file());

    let more = "packing.measured.loading=[[0.0967, \"9 N\"]]";
    let text = place.expect(3, &["fit", "fit.toml", "--set", more]).out;
    assert!(
        text.starts_with("NOT found") && text.contains("at the upper end"),
        "{text}"
    );
    let overlap = [
        "fit",
        "fit.toml",
        "--set",
        "packing.set=[\"simulation.max_overlap=0.1\"]",
        "--out",
        "other",
    ];
    let fault = place.expect(3, &overlap).err;
    assert!(
        fault.contains("the trial with material.gel.young_modulus = 20000 Pa stopped on a fault"),
        "{fault}"
    );
    let sought = "packing.set=['material.gel.young_modulus=\"100 kPa\"']";
    let wrong = place.expect(2, &["fit", "fit.toml", "--set", sought]).err;
    assert!(wrong.contains("would have no effect: it is what is sought"), "{wrong}");
    let wrong = place.expect(2, &["fit", "fit.toml", "--set", "packing.match=tops"]).err;
    assert!(
        wrong.contains("did you mean `top`?") && wrong.contains("1 error"),
        "{wrong}"
    );
}
