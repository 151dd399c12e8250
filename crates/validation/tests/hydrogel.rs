//! The protocol of the hydrogel experiment on a small packing: the table and the figures are written, and a
//! model that couples the contacts of a grain makes the packing stiffer.

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test tells what it measured, and may panic"
)]

use demeter::scenario::{FitTask, Match};
use demeter_validation::JobError;
use demeter_validation::hydrogel::{
    Experiment, METRICS, Results, Standards, TOP_FORCE, ValidationError, find_models, ranks, run_models, write_figures,
    write_table,
};
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::time::SystemTime;

const CYCLES: usize = 2;
const PREFACTOR: f64 = 1.1;

/// The experiment with 60 grains in a box of a quarter of the floor; strokes are quicker, and the positions stay 60.
fn small() -> Experiment {
    let grains = "grains=[{ material = \"hydrogel\", source = \"random\", diameter = \"21.49 mm\", count = 60, \
                  region = { shape = \"box\", lower = \"0 0 0 mm\", upper = \"86 86 170 mm\" } }]";
    let set = [
        grains,
        "wall[0].upper=\"86 86 200 mm\"",
        "wall[1].center=\"43 43 177 mm\"",
        "wall[1].half_u=\"43 0 0 mm\"",
        "wall[1].half_v=\"0 43 0 mm\"",
        "stage[0].stop={ kinetic_over_elastic = 0.1 }",
        "stage[0].duration=\"0.6 s\"",
        "stage[1].motion.top={ velocity = \"0 0 -300 mm/s\" }",
        "stage[2].stage[0].duration=\"0.06 s\"",
        "stage[2].stage[0].motion.top={ velocity = \"0 0 -350 mm/s\" }",
        "stage[2].stage[1].duration=\"0.06 s\"",
        "stage[2].stage[1].motion.top={ velocity = \"0 0 350 mm/s\" }",
        "output.series=\"1 ms\"",
        "output.strain={ wall = \"top\", direction = \"-z\", from = \"96 mm\", length = \"81 mm\" }",
    ];
    Experiment {
        scenario: Path::new(env!("CARGO_MANIFEST_DIR")).join("../../validation/hydrogel/scenario.toml"),
        set: set.map(String::from).to_vec(),
        packing: None,
        cycles: CYCLES,
        prefactor: PREFACTOR,
        overwrite: false,
    }
}

#[test]
fn the_fit_of_the_prefactor_is_a_fit_of_this_experiment() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../validation/hydrogel/prefactor.toml");
    let Ok(FitTask::Packing(task)) = FitTask::read(&file, &[]) else {
        unreachable!("it is right and tells a packing")
    };
    assert_eq!(
        (task.matched, task.unknown.key.as_str()),
        (Match::Top, "contact.multi_contact.prefactor")
    );
    // the compression at which the force was measured is the end of the stroke, the force is the measured one
    let scenario = task.scenario_at(1.1).unwrap();
    let squeezes = scenario.stages.iter().filter(|s| s.name.starts_with("squeeze"));
    assert!(squeezes.count() > task.reading.discard);
    let [top] = task.measured.loading.as_slice() else {
        unreachable!("one force was measured")
    };
    assert!(
        (top.position - (0.3 * 0.10042 - 0.005021)).abs() < 1e-6,
        "{}",
        top.position
    );
    assert_eq!(top.force.unwrap().value, TOP_FORCE);
}

#[test]
fn a_small_packing_goes_through_the_whole_protocol() {
    let place = tempfile::tempdir().unwrap();
    let out = place.path();
    let models = find_models(&["independent".to_string(), "half-space".to_string()]).unwrap();
    let told = Mutex::new(Vec::new());
    let tell = |text: &str| told.lock().unwrap().push(text.to_string());
    let folders = run_models(&small(), &models, out, 2, &tell).unwrap();
    let standards = Standards {
        top_force: 2.0,
        discard: 1,
        measured: None,
    };
    let results = Results::read(&models, &folders, PREFACTOR, &standards).unwrap();
    assert_eq!(results.cycles(), (1, 1));
    for result in &results.models {
        // every one of the 60 positions has its row, and the one it starts from
        assert_eq!((result.strokes.loading.len(), result.strokes.unloading.len()), (61, 61));
        assert!((result.rtop.value - result.top.value / 2.0).abs() < 1e-12);
    }
    let [independent, half_space] = results.models.as_slice() else {
        unreachable!("two models were asked for")
    };
    println!("{} N, {} N", independent.top.value, half_space.top.value);
    assert!(independent.top.value > 0.2, "{}", independent.top.value);
    assert!(half_space.top.value > 1.2 * independent.top.value);
    // the last model stands in for the experiment: its own misfits are 0, those of the other are not
    let errf = |k: usize| results.models[k].stand_in.errf.as_ref().unwrap().value;
    let bhat = |k: usize| results.models[k].stand_in.bhat.as_ref().unwrap().value;
    assert!(errf(1) == 0.0 && errf(0) > 0.05 && bhat(1) < 1e-12 && bhat(0) > 1e-3);
    let (ours, published) = ranks(&results, &METRICS[1]);
    assert_eq!(ours, published);
    assert_eq!(
        ours.iter().map(|m| m.name).collect::<Vec<_>>(),
        ["half-space", "independent"]
    );

    writes_table_and_figures(&results, out);
    uses_finished_runs_again(&folders, out, &models);
}

fn writes_table_and_figures(results: &Results, out: &Path) {
    let text = write_table(results, "A small packing.", out).unwrap();
    assert_eq!(std::fs::read_to_string(out.join("table1.md")).unwrap(), text);
    assert!(
        text.contains("stand-in") && text.contains("| Elastic half-space |"),
        "{text}"
    );
    let mut table = csv::Reader::from_path(out.join("table1.csv")).unwrap();
    let titles = table.headers().unwrap().clone();
    let force = titles
        .iter()
        .position(|t| t == "plate force at full compression [N]")
        .unwrap();
    let rows: Vec<csv::StringRecord> = table.records().map(Result::unwrap).collect();
    let forces: Vec<f64> = rows.iter().map(|row| row[force].parse().unwrap()).collect();
    assert_eq!(forces, results.models.iter().map(|m| m.top.value).collect::<Vec<_>>());

    let checks = write_figures(results, out).unwrap();
    assert_eq!(checks.len(), 4);
    for check in &checks {
        println!("{check}");
        let svg = std::fs::read_to_string(out.join(format!("{}.svg", check.figure))).unwrap();
        assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>") && !svg.contains("NaN"));
        // a line of every model, with a legend
        assert!(
            svg.contains("stroke=\"#0072b2\" d=\"M") && svg.contains("stroke=\"#cc79a7\" d=\"M"),
            "{}",
            check.figure
        );
        assert!(svg.contains(">Elastic half-space<"));
    }
}

fn uses_finished_runs_again(folders: &[PathBuf], out: &Path, models: &[demeter_validation::hydrogel::Model]) {
    let written = || -> Vec<SystemTime> {
        let of = |folder: &PathBuf| folder.join("series.csv").metadata().unwrap().modified().unwrap();
        folders.iter().map(of).collect()
    };
    let before = written();
    let told = Mutex::new(Vec::new());
    let tell = |text: &str| told.lock().unwrap().push(text.to_string());
    assert_eq!(run_models(&small(), models, out, 1, &tell).unwrap(), folders);
    assert_eq!(written(), before);
    assert!(told.lock().unwrap().iter().all(|line| line.contains("taken from")));
    // runs of another scenario are left as they are
    let other = Experiment {
        cycles: CYCLES + 1,
        ..small()
    };
    let error = run_models(&other, models, out, 1, &tell).unwrap_err();
    assert!(
        matches!(error, ValidationError::Run(JobError::OtherRun { .. })),
        "{error}"
    );
    assert_eq!(written(), before);
}
