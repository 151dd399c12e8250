//! `report.html`: what it tells, that texts of a scenario cannot become script, and that it survives what runs leave.

use demeter::output::RunFolder;
use demeter::report::write;
use demeter::scenario::{Observer, Progress, RunEnd, RunOptions, Scenario, run};
use std::fs;
use std::path::PathBuf;

const EVIL: &str = "</script><script>alert(1)</script><img src=x onerror=alert(1)>";

/// Grains that fall onto a floor.
const FALL: &str = r#"
title = "TITLE"
[simulation]
gravity = "0 0 -9.81 m/s^2"
[material."MATERIAL"]
young_modulus = "1 MPa"
poisson_ratio = 0.3
density = "2500 kg/m^3"
[contact]
normal = { law = "hertz-tsuji", restitution = 0.5 }
tangential = { law = "coulomb", friction = 0.3 }
[[grains]]
material = "MATERIAL"
source = "list"
positions = ["0 0 1.1 mm", "0.1 0 3.2 mm"]
diameter = "2 mm"
[[wall]]
name = "WALL"
material = "MATERIAL"
shape = "rectangle"
center = "0 0 0 mm"
half_u = "5 0 0 mm"
half_v = "0 5 0 mm"
[[stage]]
name = "fall"
steps = 400
[output]
series = "0.1 ms"
frames = "1 ms"
picture = false
plots = [{ name = "height", x = "time", y = "gravitational energy" }]
"#;

struct Quiet;

impl Observer for Quiet {
    fn progress(&mut self, _: &Progress) -> bool {
        true
    }
    fn message(&mut self, _: &str) {}
}

fn plain() -> String {
    let named = FALL.replace("TITLE", "Two grains").replace("MATERIAL", "glass");
    named.replace("WALL", "floor")
}

/// Runs a scenario to its end and gives the page and the folder.
fn page_of(scenario: &str, overrides: &[&str]) -> (String, tempfile::TempDir, RunEnd) {
    let place = tempfile::tempdir().unwrap();
    let overrides: Vec<String> = overrides.iter().map(|text| (*text).to_string()).collect();
    let scenario = Scenario::parse(scenario, "test.toml", place.path(), &overrides).unwrap();
    let folder = place.path().join("run");
    let report = run(&scenario, &folder, RunOptions::default(), &mut Quiet).unwrap();
    let page = fs::read_to_string(folder.join("report.html")).unwrap();
    (page, place, report.end)
}

/// The data of a page.
fn data(page: &str) -> serde_json::Value {
    let start = "<script type=\"application/json\" id=\"report-data\">";
    let from = page.find(start).unwrap() + start.len();
    let to = from + page[from..].find("</script>").unwrap();
    serde_json::from_str(&page[from..to]).unwrap()
}

/// The page without its script, style and data.
fn shown(page: &str) -> &str {
    &page[page.find("<body>").unwrap()..page.find("<script type=\"application/json\"").unwrap()]
}

fn columns(page: &str) -> Vec<String> {
    let data = data(page);
    let columns = data["series"]["columns"].as_array().unwrap();
    columns
        .iter()
        .map(|c| c["name"].as_str().unwrap().to_string())
        .collect()
}

#[test]
fn every_run_ends_with_a_report() {
    let (page, _place, end) = page_of(&plain(), &[]);
    assert_eq!(end, RunEnd::Finished);
    let body = shown(&page);
    for text in [
        "<h1>Two grains</h1>",
        "Finished",
        "all stages are done",
        "automatic: ",
        "hertz-tsuji (restitution 0.5)",
        "<th scope=\"row\">floor</th>",
        "Energy ledger",
        "density = &quot;2500 kg/m^3&quot;",
    ] {
        assert!(body.contains(text), "no `{text}` in {body}");
    }
    let data = data(&page);
    assert_eq!(data["packing"]["grains"]["count"], 2);
    assert_eq!(data["packing"]["walls"][0]["name"], "floor");
    assert_eq!(data["series"]["groups"][0]["title"], "height");
    assert_eq!(data["series"]["stages"][0]["name"], "fall");
    assert!(columns(&page).iter().any(|name| name == "wall floor force z"));
}

/// The plots of a page: place, title and columns.
fn plots(page: &str) -> Vec<(String, String, Vec<String>)> {
    let text = |value: &serde_json::Value| value.as_str().unwrap().to_string();
    let data = data(page);
    let groups = data["series"]["groups"].as_array().unwrap().iter();
    let columns = |y: &serde_json::Value| y.as_array().unwrap().iter().map(text).collect();
    groups
        .map(|group| (text(&group["place"]), text(&group["title"]), columns(&group["y"])))
        .collect()
}

#[test]
fn what_is_measured_is_plotted_unit_by_unit() {
    let measures = r#"measure=[{name="hits",kind="collisions",lower="1e-12 J",upper="1e-3 J",bins=10},{name="one",kind="grain-trace",ids=[1]},{name="still",kind="region-count"}]"#;
    let (page, _place, _) = page_of(&plain(), &[measures, "stage[0].steps=2000"]);
    let plots = plots(&page);
    let of = |title: &str| {
        let found = plots.iter().find(|plot| plot.0 == "plots-series" && plot.1 == title);
        found.unwrap_or_else(|| panic!("no `{title}` in {plots:?}")).2.clone()
    };
    let energies = of("hits [J]");
    assert!(
        energies.contains(&"hits wall normal energy".to_string()),
        "{energies:?}"
    );
    assert_eq!(of("hits: numbers"), ["hits collisions", "hits wall collisions"]);
    let places = of("one [m]");
    assert!(places.iter().all(|name| name.starts_with("one ")), "{places:?}");
    // what does not change is left out
    assert!(!plots.iter().any(|plot| plot.1.starts_with("still")), "{plots:?}");
}

#[test]
fn many_lines_are_left_out_and_told() {
    let text = r#"measure=[{name="push",kind="walls-load",wall="WALL",axis="z"}]"#.replace("WALL", "floor");
    let (_, place, _) = page_of(&plain(), &[&text]);
    let folder = RunFolder::open(&place.path().join("run")).unwrap();
    let names: Vec<String> = (0..20).map(|k| format!("push part {k} [N]")).collect();
    let rows = (0..3).map(|row| {
        let values: Vec<String> = (0..20).map(|k| (row * k + 1).to_string()).collect();
        format!("{row},{row},fall,{}\n", values.join(","))
    });
    let head = format!("step,time [s],stage,{}\n", names.join(","));
    folder
        .write(&folder.series(), (head + &rows.collect::<String>()).as_bytes())
        .unwrap();
    let page = fs::read_to_string(write(folder.root()).unwrap().path).unwrap();
    assert_eq!(
        plots(&page).iter().find(|plot| plot.1 == "push [N]").unwrap().2.len(),
        12
    );
    assert!(
        shown(&page).contains("“push [N]” shows 12 of 19 columns"),
        "{}",
        shown(&page)
    );
}

#[test]
fn a_wall_that_only_turns_has_not_moved() {
    let turning = r#"stage[0].motion={floor={rotation={point="0 0 0 m",axis="z",angular_velocity="600 rpm"}}}"#;
    let (page, place, _) = page_of(&plain(), &[turning, "stage[0].steps=2000"]);
    let titles: Vec<String> = plots(&page)
        .into_iter()
        .filter(|plot| plot.0 == "plots-walls")
        .map(|plot| plot.1)
        .collect();
    assert_eq!(
        titles,
        [
            "Wall forces",
            "Wall torques",
            "Wall powers",
            "Wall angular velocities",
            "Wall turns"
        ]
    );
    // what rounding leaves of a centre about which a wall turns
    let folder = RunFolder::open(&place.path().join("run")).unwrap();
    let series = "step,time [s],stage,wall floor force x [N],wall floor displacement x [m],wall floor displacement y [m]\n\
                  0,0,fall,0,0,0\n1,1,fall,0,2.6e-19,1e-4\n";
    folder.write(&folder.series(), series.as_bytes()).unwrap();
    let page = fs::read_to_string(write(folder.root()).unwrap().path).unwrap();
    assert!(!shown(&page).contains("2.6e"), "{}", shown(&page));
    let moved: Vec<_> = plots(&page)
        .into_iter()
        .filter(|plot| plot.1 == "Wall displacements")
        .collect();
    assert_eq!(moved[0].2, ["wall floor displacement y"]);
}

#[test]
fn headings_are_in_order_and_places_are_named_once() {
    let (page, _place, _) = page_of(&plain(), &[]);
    let body = shown(&page);
    let levels: Vec<u32> = body
        .match_indices("<h")
        .filter_map(|(at, _)| body[at + 2..].chars().next()?.to_digit(10))
        .collect();
    assert_eq!(levels.iter().filter(|level| **level == 1).count(), 1);
    assert!(levels.windows(2).all(|pair| pair[1] <= pair[0] + 1), "{levels:?}");
    let mut names: Vec<&str> = body
        .split(" id=\"")
        .skip(1)
        .filter_map(|rest| rest.split('"').next())
        .collect();
    let all = names.len();
    names.sort_unstable();
    names.dedup();
    assert_eq!(names.len(), all, "{names:?}");
}

#[test]
fn nothing_is_fetched_and_only_the_own_script_runs() {
    let (page, _place, _) = page_of(&plain(), &[]);
    let policy = page.split("Content-Security-Policy\" content=\"").nth(1).unwrap();
    let policy = policy.split('"').next().unwrap();
    assert!(
        policy.starts_with("default-src 'none'; script-src 'sha256-"),
        "{policy}"
    );
    assert!(
        !policy.contains("unsafe") && !policy.contains('*') && !policy.contains("http"),
        "{policy}"
    );
    let body = shown(&page);
    for loading in ["src=", "url(", "@import", "<link", "<iframe", "style="] {
        assert!(!body.contains(loading), "`{loading}` in {body}");
    }
}

#[test]
fn texts_of_a_scenario_cannot_become_script() {
    let (title, wall) = (EVIL.replace('"', ""), "<b onclick=alert(1)>");
    let scenario = FALL
        .replace("TITLE", &title)
        .replace("MATERIAL", "<i>&'")
        .replace("WALL", wall);
    let (page, _place, _) = page_of(&scenario, &[]);
    assert_eq!(page.matches("<script").count(), 2, "data and the own script");
    assert_eq!(page.matches("</script>").count(), 2);
    for tag in ["<img", "<b ", "<i>", "<script>alert"] {
        assert!(!page.contains(tag), "{tag}");
    }
    let data = data(&page);
    assert_eq!(data["title"], EVIL);
    assert_eq!(data["packing"]["walls"][0]["name"], wall);
    assert_eq!(data["packing"]["grains"]["scalars"][7]["names"][0], "<i>&'");
}

#[test]
fn runs_without_walls_or_contacts_have_a_report() {
    let alone = ["wall=[]", "grains[0].positions=[\"0 0 0 mm\"]"];
    let (page, _place, _) = page_of(&plain(), &alone);
    let body = shown(&page);
    assert!(
        body.contains("There are no walls.") && body.contains("No contact carries a force"),
        "{body}"
    );
    let data = data(&page);
    assert!(data["distributions"].get("forces").is_none());
    assert!(data["packing"]["contacts"]["mean_force"].is_null());
    assert_eq!(data["distributions"]["coordination"]["lines"][0]["counts"][0], 1);
}

#[test]
fn a_report_can_be_left_out() {
    let place = tempfile::tempdir().unwrap();
    let scenario = Scenario::parse(
        &plain(),
        "test.toml",
        place.path(),
        &["output.report=false".to_string()],
    )
    .unwrap();
    let folder = place.path().join("run");
    run(&scenario, &folder, RunOptions::default(), &mut Quiet).unwrap();
    assert!(!folder.join("report.html").exists());
    assert_eq!(write(&folder).unwrap().path, folder.join("report.html"));
}

#[test]
fn a_fault_is_told() {
    let (page, _place, end) = page_of(
        &plain(),
        &[
            "grains[0].positions=[\"0 0 1.1 mm\", \"0 0 200 mm\"]",
            "simulation.max_overlap=1e-6",
        ],
    );
    assert!(matches!(end, RunEnd::Fault(_)), "{end:?}");
    let body = shown(&page);
    assert!(
        body.contains("Stopped on a fault") && body.contains("overlap"),
        "{body}"
    );
}

/// The folder of a run that was killed: no summary, and a series that ends within a row.
fn killed() -> (tempfile::TempDir, PathBuf) {
    let (_, place, _) = page_of(&plain(), &[]);
    let folder = place.path().join("run");
    for name in ["summary.json", "report.html"] {
        fs::remove_file(folder.join(name)).unwrap();
    }
    let series = fs::read(folder.join("series.csv")).unwrap();
    fs::write(folder.join("series.csv"), &series[..series.len() - 20]).unwrap();
    (place, folder)
}

#[test]
fn a_killed_run_has_a_report_of_what_there_is() {
    let (_place, folder) = killed();
    let written = write(&folder).unwrap();
    assert_eq!(written.problems, Vec::<String>::new());
    let page = fs::read_to_string(written.path).unwrap();
    let body = shown(&page);
    for text in [
        "Ended without a summary",
        "demeter resume",
        "automatic: ",
        "Stages in the series",
        "Two grains",
    ] {
        assert!(body.contains(text), "no `{text}` in {body}");
    }
    assert_eq!(data(&page)["packing"]["grains"]["count"], 2);
}

#[test]
fn what_is_gone_of_a_finished_run_is_told() {
    let (_, place, _) = page_of(&plain(), &[]);
    let folder = place.path().join("run");
    for entry in fs::read_dir(folder.join("frames")).unwrap() {
        fs::remove_file(entry.unwrap().path()).unwrap();
    }
    fs::remove_file(folder.join("series.csv")).unwrap();
    let problems = write(&folder).unwrap().problems;
    let [series, frames] = problems.as_slice() else {
        panic!("{problems:?}")
    };
    assert!(
        series.contains("`series.csv` is gone") && frames.contains("frames are not whole"),
        "{problems:?}"
    );
}

#[test]
fn a_run_that_goes_on_says_so() {
    let (_place, folder) = killed();
    let _lock = RunFolder::open(&folder).unwrap().lock().unwrap();
    let page = fs::read_to_string(write(&folder).unwrap().path).unwrap();
    assert!(shown(&page).contains("Still running"));
}

#[test]
fn damage_is_told_and_the_rest_is_there() {
    let (_place, folder) = killed();
    fs::write(folder.join("summary.json"), "{").unwrap();
    fs::write(folder.join("series.csv"), "time [s],x\n1,2,3\n").unwrap();
    fs::write(folder.join("scenario.toml"), "= \"<script>\"").unwrap();
    for entry in fs::read_dir(folder.join("frames")).unwrap() {
        fs::write(entry.unwrap().path(), "nothing").unwrap();
    }
    let written = write(&folder).unwrap();
    assert_eq!(written.problems.len(), 4, "{:?}", written.problems);
    let page = fs::read_to_string(written.path).unwrap();
    let body = shown(&page);
    assert!(body.contains("Not in this report") && body.contains("has written no frame") && body.contains("no series"));
    assert!(data(&page)["packing"].is_null() && data(&page)["series"].is_null());
}

#[test]
fn an_empty_folder_of_a_run_and_a_series_of_one_row_are_no_panic() {
    let place = tempfile::tempdir().unwrap();
    let folder = RunFolder::create(&place.path().join("run"), false).unwrap();
    let page = |folder: &RunFolder| fs::read_to_string(write(folder.root()).unwrap().path).unwrap();
    assert!(shown(&page(&folder)).contains("<h1>run</h1>"));
    folder
        .write(&folder.series(), b"step,time [s],stage,kinetic energy [J]\n")
        .unwrap();
    assert!(data(&page(&folder))["series"].is_null());
    folder
        .write(
            &folder.series(),
            b"step,time [s],stage,kinetic energy [J]\n0,0.0,a,NaN\n",
        )
        .unwrap();
    let one = page(&folder);
    assert_eq!(data(&one)["series"]["rows"], 1);
    assert!(shown(&one).contains("Energy ledger"));
}

#[test]
fn a_folder_of_something_else_is_refused() {
    let place = tempfile::tempdir().unwrap();
    let error = write(place.path()).unwrap_err();
    assert!(!error.is_io(), "{error}");
    assert!(!place.path().join("report.html").exists());
}

#[test]
fn long_series_are_thinned_and_the_page_says_so() {
    let place = tempfile::tempdir().unwrap();
    let folder = RunFolder::create(&place.path().join("run"), false).unwrap();
    let mut text = "step,time [s],stage,max speed [m/s],wall a force x [N]\n".to_string();
    for k in 0..30_000 {
        let peak = if k == 12_345 { 99.0 } else { f64::from(k % 7) };
        text.push_str(&format!(
            "{k},{},{},{peak},NaN\n",
            f64::from(k) * 1e-3,
            if k < 10_000 { "a" } else { "b" }
        ));
    }
    folder.write(&folder.series(), text.as_bytes()).unwrap();
    let page = fs::read_to_string(write(folder.root()).unwrap().path).unwrap();
    assert!(
        shown(&page).contains("The series has 30000 rows. 4000 are here"),
        "{}",
        shown(&page)
    );
    let data = data(&page);
    assert_eq!(data["series"]["rows"], 4000);
    assert_eq!(data["series"]["stages"][1]["row"], 2 * (10_000 * 2000 / 30_000));
    let speeds = data["series"]["columns"][2]["values"]["f32"].as_str().unwrap();
    let bytes = base64::Engine::decode(&base64::engine::general_purpose::STANDARD, speeds).unwrap();
    let speeds: Vec<f32> = bytes.as_chunks().0.iter().map(|b| f32::from_le_bytes(*b)).collect();
    assert_eq!((speeds.len(), speeds.iter().copied().fold(0.0, f32::max)), (4000, 99.0));
}
