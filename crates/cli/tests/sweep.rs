//! `demeter sweep`: runs as processes, tables, restarts, refusals.
#![cfg(unix)]
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests may fail as tests do")]

mod demeter;

use demeter::{FALL, Place, Said, assert_same, signal};
use serde_json::Value;
use std::collections::BTreeMap;
use std::fs;
use std::process::{Child, Stdio};
use std::time::{Duration, Instant};

/// Two stages of 300 steps.
const SHORT: [&str; 4] = ["--set", "stage[0].steps=300", "--set", "stage[1].steps=300"];

fn place() -> Place {
    let place = Place::new();
    place.write("fall.toml", FALL);
    place
}

/// The rows of a CSV file by the titles.
fn table(place: &Place, path: &str) -> Vec<BTreeMap<String, String>> {
    let mut reader = csv::Reader::from_path(place.path(path)).unwrap();
    reader.deserialize().map(Result::unwrap).collect()
}

fn ends(said: &Said) -> Vec<String> {
    let answer = said.json();
    let runs = answer["runs"].as_array().unwrap();
    runs.iter()
        .map(|run| run["end"].as_str().unwrap().to_string())
        .collect()
}

#[test]
fn a_grid_runs_and_gives_the_bits_of_single_runs() {
    let place = place();
    let vary = [
        "--vary",
        "contact.tangential.friction=0.1,0.6",
        "--vary",
        "grains[0].count=40,80",
    ];
    let told = [
        "--result",
        "mean:coordination@shake",
        "--plot",
        "packing fraction",
        "--jobs",
        "2",
    ];
    let said = place.expect(0, &[&["sweep", "fall.toml"], &SHORT[..], &vary, &told].concat());
    assert!(said.out.contains("4 of 4 runs finished"), "{}", said.out);
    assert!(said.out.contains("mean coordination in shake"), "{}", said.out);
    assert!(said.err.contains("[4/4]"), "{}", said.err);
    let rows = table(&place, "runs/fall-sweep/results.csv");
    assert_eq!(rows.len(), 4);
    assert_eq!(rows[1]["run"], "friction=0.1_count=80");
    assert_eq!(
        (rows[1]["grains"].as_str(), rows[1]["end"].as_str()),
        ("80", "finished")
    );
    assert!(
        rows.iter()
            .all(|row| row["mean coordination in shake"].parse::<f64>().unwrap() >= 0.0)
    );
    let svg =
        fs::read_to_string(place.path("runs/fall-sweep/plots/packing-fraction-over-contact-tangential-friction.svg"));
    assert!(svg.unwrap().contains("count = 80"));
    // each is the run that `demeter run` makes
    let one = [
        "--set",
        "contact.tangential.friction=0.6",
        "--set",
        "grains[0].count=40",
        "--out",
        "one",
    ];
    place.expect(0, &[&["run", "fall.toml"], &SHORT[..], &one].concat());
    assert_same(
        &place.results("one"),
        &place.results("runs/fall-sweep/friction=0.6_count=40"),
    );
    // `demeter plot` and the viewer of one run read what is there
    place.expect(
        0,
        &[
            "plot",
            "runs/fall-sweep/results.csv",
            "contact.tangential.friction",
            "coordination",
            "--out",
            "p.svg",
        ],
    );
    place.expect(0, &["info", "runs/fall-sweep/friction=0.1_count=40"]);
    let said = place.expect(0, &["info", "runs/fall-sweep"]);
    assert!(said.out.contains("4 of 4 finished"), "{}", said.out);
}

#[test]
fn nothing_runs_when_any_run_is_wrong() {
    let place = place();
    let base = [
        "sweep",
        "fall.toml",
        "--vary",
        "contact.normal.restitution=0.5,1.5",
        "--vary",
        "grains[0].count=5,x",
    ];
    let said = place.expect(2, &base);
    assert!(
        said.err
            .contains("restitution = 1.5, count = 5; restitution = 1.5, count = x"),
        "{}",
        said.err
    );
    assert!(
        said.err
            .contains("2 errors; nothing was written and no run was started"),
        "{}",
        said.err
    );
    assert!(said.err.contains("--vary:1:"), "{}", said.err);
    let error = &place.expect(2, &[&base[..], &["--json"]].concat()).json()["error"];
    assert_eq!(error["diagnostics"].as_array().unwrap().len(), 2);
    assert_eq!(error["diagnostics"][0]["runs"].as_array().unwrap().len(), 2);
    for (arguments, expected) in [
        (&["--vary", "grains[0].cuont=5"][..], "did you mean `count`?"),
        (&["--vary", "grains[7].count=5"], "the only element is number 0"),
        (&["--vary", "seed=1..5"], "the number of values is missing"),
        (&["--vary", "seed=1,2", "--repeat", "3"], "tell the same key"),
        (&[], "nothing is varied"),
        (
            &["--repeat", "2", "--result", "cordination"],
            "did you mean `coordination`?",
        ),
        (
            &["--repeat", "2", "--plot", "coordination", "--against", "friction"],
            "`friction` is not varied",
        ),
        (
            &["--repeat", "2", "--against", "seed"],
            "--against tells the horizontal axis of plots, and there is none",
        ),
        (&["--table", "none.csv"], "none.csv"),
        (&["--resume", "runs"], "cannot be used with"),
        (&["--repeat", "2", "--sbatch", "time=1"], "--slurm"),
        (&["--repeat", "2", "--slurm", "--sbatch", "comment=a b"], "blanks"),
        (&["--repeat", "2", "--slurm", "--out", "a\"b"], "path of a log"),
    ] {
        let said = place.expect(2, &[&["sweep", "fall.toml"], arguments].concat());
        assert!(said.err.contains(expected), "{arguments:?}: {}", said.err);
    }
    let absent = place.expect(2, &["sweep", "absent.toml", "--repeat", "2"]).err;
    assert!(absent.contains("no such file"), "{absent}");
    let none = place.expect(2, &["sweep", "--resume", "none"]).err;
    assert!(none.contains("holds no sweep"), "{none}");
    assert_eq!(place.names(), ["fall.toml"]);
}

#[test]
fn a_design_is_listed_and_repeated_with_seeds() {
    let place = place();
    place.write(
        "design.csv",
        "contact.normal.restitution,grains[0].diameter [mm]\n0.5,1.6\n0.9,2\n",
    );
    let base = ["sweep", "fall.toml", "--table", "design.csv", "--repeat", "2"];
    let base = [&base[..], &SHORT].concat();
    let said = place.expect(0, &[&base[..], &["--dry-run"]].concat());
    assert!(said.out.contains("4 runs, nothing was written"), "{}", said.out);
    assert!(said.out.contains("restitution=0.9_diameter=2mm_seed=2"), "{}", said.out);
    let listed = place.expect(0, &[&base[..], &["--dry-run", "--json"]].concat()).json();
    assert_eq!(listed["runs"][0]["steps"], 600);
    assert!(listed["runs"][0]["run_time"].as_f64().unwrap() > 0.0 && listed["memory"].as_u64().unwrap() > 0);
    assert_eq!(place.names(), ["design.csv", "fall.toml"]);
    let said = place.expect(0, &[&base[..], &["--json"]].concat());
    let answer = said.json();
    assert_eq!((&answer["finished"], &answer["exit_code"]), (&4.into(), &0.into()));
    assert_eq!(answer["runs"][2]["values"]["grains[0].diameter"], "2 mm");
    assert!(answer["runs"][2]["results"]["kinetic energy [J]"].as_f64().unwrap() > 0.0);
    let means = table(&place, "runs/fall-sweep/averages.csv");
    assert_eq!((means.len(), means[1]["grains[0].diameter [mm]"].as_str()), (2, "2"));
    assert!(means[1]["kinetic energy deviation [J]"].parse::<f64>().unwrap() > 0.0);
    let results = table(&place, "runs/fall-sweep/results.csv");
    assert_ne!(
        results[2]["kinetic energy [J]"], results[3]["kinetic energy [J]"],
        "the seed changes nothing"
    );
}

#[test]
fn another_sweep_in_the_folder_is_refused_and_the_same_goes_on() {
    let place = place();
    let base = [&["sweep", "fall.toml", "--vary", "grains[0].count=20,30"][..], &SHORT].concat();
    place.expect(0, &base);
    let folder = "runs/fall-sweep/count=20/";
    let first = fs::metadata(place.path(folder).join("summary.json"))
        .unwrap()
        .modified()
        .unwrap();
    let said = place.expect(0, &base);
    assert!(said.out.contains("2 of 2 runs finished"), "{}", said.out);
    assert_eq!(
        fs::metadata(place.path(folder).join("summary.json"))
            .unwrap()
            .modified()
            .unwrap(),
        first
    );
    let other = [&["sweep", "fall.toml", "--vary", "grains[0].count=20,40"][..], &SHORT].concat();
    let said = place.expect(2, &other);
    assert!(
        said.err.contains("the values 40 are new, 30 are left out"),
        "{}",
        said.err
    );
    let longer = [
        &["sweep", "fall.toml", "--vary", "grains[0].count=30,40,20"][..],
        &SHORT,
    ]
    .concat();
    let said = place.expect(2, &longer);
    assert!(said.err.contains("--extend adds the others"), "{}", said.err);
    let said = place.expect(2, &[&other[..], &["--extend"]].concat());
    assert!(said.err.contains("only adds runs"), "{}", said.err);
    let said = place.expect(0, &[&longer[..], &["--extend", "--json"]].concat());
    assert_eq!(ends(&said), ["finished"; 3]);
    let counts: Vec<String> = (table(&place, "runs/fall-sweep/results.csv").into_iter())
        .map(|mut row| row.remove("grains").unwrap())
        .collect();
    assert_eq!(counts, ["30", "40", "20"]);
    let modified = fs::metadata(place.path(folder).join("summary.json"))
        .unwrap()
        .modified();
    assert_eq!(modified.unwrap(), first, "a run that was there was repeated");
    let base = longer;
    place.write("fall.toml", &FALL.replace("0.7", "0.8"));
    let said = place.expect(2, &base);
    assert!(
        said.err.contains("restitution = 0.8") && said.err.contains("--out"),
        "{}",
        said.err
    );
    // gathering needs no scenario, and takes other results
    let said = place.expect(
        0,
        &[
            "sweep",
            "--gather",
            "runs/fall-sweep",
            "--result",
            "min:packing fraction",
        ],
    );
    assert!(said.out.contains("min packing fraction"), "{}", said.out);
    let said = place.expect(0, &["sweep", "--resume", "runs/fall-sweep"]);
    assert!(
        said.out.contains("min packing fraction"),
        "what was asked for was lost: {}",
        said.out
    );
}

#[test]
fn a_sweep_does_not_go_on_with_other_files() {
    let place = place();
    let listed = FALL.find("[[grains]]").unwrap()..FALL.find("[[wall]]").unwrap();
    let mut text = FALL.to_owned();
    text.replace_range(
        listed,
        "[[grains]]\nmaterial = \"glass\"\nsource = \"file\"\nfile = \"one.csv\"\n\n",
    );
    place.write("fall.toml", &text);
    place.write("one.csv", "x y z diameter\n0.004 0.004 0.004 0.002\n");
    let sweep = [
        &["sweep", "fall.toml", "--vary", "contact.normal.restitution=0.5,0.6"][..],
        &SHORT,
    ]
    .concat();
    place.expect(0, &sweep);
    place.expect(0, &sweep);
    place.write("one.csv", "x y z diameter\n0.004 0.004 0.0045 0.002\n");
    let more = [
        &[
            "sweep",
            "fall.toml",
            "--vary",
            "contact.normal.restitution=0.5,0.6,0.7",
            "--extend",
        ][..],
        &SHORT,
    ]
    .concat();
    for again in [&sweep[..], &more, &["sweep", "--resume", "runs/fall-sweep"]] {
        let said = place.expect(2, again);
        assert!(
            said.err.contains("one.csv` had 39 bytes and now has 40"),
            "{}",
            said.err
        );
    }
    place.expect(0, &["sweep", "--gather", "runs/fall-sweep"]);
}

/// Grains that fly out of a box stop a run; removed ones do not.
#[test]
fn a_run_that_fails_stops_no_other_and_is_told() {
    let place = place();
    let open = FALL.replace("upper = \"12 12 14 mm\"", "upper = \"12 12 14 mm\"\nopen = [\"+x\"]");
    let domain = "[domain]\nlower = \"-5 -5 -5 mm\"\nupper = \"15 20 20 mm\"\noutside = \"stop\"\n\n[material.glass]";
    let text = open
        .replace("0.3 0.1 -0.2 m/s", "3 0 0 m/s")
        .replace("[material.glass]", domain);
    place.write("leak.toml", &text);
    let base = [
        "sweep",
        "leak.toml",
        "--vary",
        "domain.outside=stop,remove",
        "--jobs",
        "1",
    ];
    let said = place.expect(3, &base);
    assert!(said.out.contains("1 of 2 runs finished"), "{}", said.out);
    assert!(
        said.out.contains("outside=stop: fault: step") && said.out.contains("left the domain"),
        "{}",
        said.out
    );
    assert!(said.out.contains("--retry-failed"), "{}", said.out);
    let gathered = place.expect(3, &["sweep", "--gather", "runs/leak-sweep", "--json"]);
    assert_eq!(gathered.json()["exit_code"], 3);
    let rows = table(&place, "runs/leak-sweep/results.csv");
    assert_eq!(
        (rows[0]["end"].as_str(), rows[1]["end"].as_str()),
        ("fault", "finished")
    );
    assert_eq!(rows[0]["coordination"], "");
    // it stays failed until it is asked to be tried again
    let log = || {
        fs::metadata(place.path("runs/leak-sweep/outside=stop/log.txt"))
            .unwrap()
            .len()
    };
    let before = log();
    let said = place.expect(3, &["sweep", "--resume", "runs/leak-sweep"]);
    assert!(!said.err.contains("outside=stop:"), "{}", said.err);
    assert_eq!(log(), before);
    let said = place.expect(3, &[&base[..], &["--retry-failed", "--json"]].concat());
    assert_eq!(ends(&said), ["fault", "finished"]);
    assert!(log() > before);
}

/// Starts a sweep and waits until some runs have checkpoints behind their beginning.
fn start(place: &Place, arguments: &[&str], checkpoints: &[&str]) -> Child {
    let mut child = place
        .command(arguments)
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let deadline = Instant::now() + Duration::from_secs(120);
    while !checkpoints
        .iter()
        .all(|run| place.path(run).join("checkpoint.previous").exists())
    {
        assert!(Instant::now() < deadline, "no checkpoints were written");
        assert!(child.try_wait().unwrap().is_none(), "the sweep ended early");
        std::thread::sleep(Duration::from_millis(2));
    }
    child
}

const LONG: [&str; 8] = [
    "sweep",
    "fall.toml",
    "--vary",
    "contact.tangential.friction=0.1,0.4,0.6",
    "--jobs",
    "2",
    "--set",
    "stage[0].steps=20000",
];
const RUNS: [&str; 3] = [
    "runs/fall-sweep/friction=0.1",
    "runs/fall-sweep/friction=0.4",
    "runs/fall-sweep/friction=0.6",
];

/// The same runs, never stopped.
fn whole(place: &Place) {
    place.expect(0, &[&LONG[..], &["--out", "whole"]].concat());
}

fn assert_same_as_whole(place: &Place) {
    for run in ["friction=0.1", "friction=0.4", "friction=0.6"] {
        assert_same(
            &place.results(&format!("whole/{run}")),
            &place.results(&format!("runs/fall-sweep/{run}")),
        );
    }
}

#[test]
fn a_killed_sweep_leaves_no_process_and_goes_on_to_the_same_bits() {
    let place = place();
    whole(&place);
    let mut child = start(&place, &LONG, &RUNS[..2]);
    let children = children(child.id());
    if cfg!(target_os = "linux") {
        assert_eq!(children.len(), 2);
    }
    assert_eq!(signal(&mut child, "KILL").code(), None);
    // at once, while the orphans may still be writing their checkpoints
    let said = place.expect(0, &["sweep", "--resume", "runs/fall-sweep", "--json"]);
    assert_eq!(ends(&said), ["finished"; 3]);
    let log = fs::read_to_string(place.path(RUNS[0]).join("log.txt")).unwrap();
    assert!(log.contains("going on from step"), "{log}");
    assert_same_as_whole(&place);
    for child in children {
        assert!(!is_alive(child), "process {child} was left behind");
    }
}

#[test]
fn an_interrupted_sweep_writes_checkpoints_and_goes_on() {
    let place = place();
    whole(&place);
    for name in ["INT", "TERM"] {
        let mut child = start(&place, &LONG, &RUNS[..1]);
        assert_eq!(signal(&mut child, name).code(), Some(130));
        let state: Value =
            serde_json::from_slice(&fs::read(place.path("runs/fall-sweep/sweep.json")).unwrap()).unwrap();
        assert_eq!(state["state"][0], "interrupted", "{}", state["state"]);
        let summary: Value =
            serde_json::from_slice(&fs::read(place.path(RUNS[0]).join("summary.json")).unwrap()).unwrap();
        assert_eq!(summary["finished"], false);
        if name == "INT" {
            for run in RUNS {
                let _ = fs::remove_file(place.path(run).join("checkpoint.previous"));
            }
        }
    }
    // the same command goes on, on other threads
    let said = place.expect(0, &[&LONG[..], &["--threads", "2", "--json"]].concat());
    assert_eq!(ends(&said), ["finished"; 3]);
    assert_same_as_whole(&place);
}

#[test]
fn two_sweeps_never_work_in_one_folder() {
    let place = place();
    let mut child = start(&place, &LONG, &RUNS[..1]);
    for refused in [
        &LONG[..],
        &["sweep", "--resume", "runs/fall-sweep"],
        &["sweep", "--resume", "runs/fall-sweep", "--only", "2"],
    ] {
        let said = place.expect(2, refused);
        assert!(said.err.contains("another `demeter sweep` works on"), "{}", said.err);
    }
    let said = place.expect(0, &["sweep", "--gather", "runs/fall-sweep"]);
    assert!(said.out.contains("running"), "{}", said.out);
    signal(&mut child, "TERM");
}

/// A process that is killed fails its run alone.
#[test]
#[cfg(target_os = "linux")]
fn a_process_that_dies_fails_one_run() {
    let place = place();
    let mut child = start(&place, &LONG, &RUNS[..2]);
    let victim = children(child.id())[0];
    assert!(
        std::process::Command::new("kill")
            .args(["-KILL", &victim.to_string()])
            .status()
            .unwrap()
            .success()
    );
    assert_eq!(child.wait().unwrap().code(), Some(3));
    let said = place.expect(3, &["sweep", "--resume", "runs/fall-sweep", "--json"]);
    let mut found = ends(&said);
    found.sort();
    assert_eq!(found, ["crash", "finished", "finished"]);
    assert!(said.out.contains("its process died (signal: 9"), "{}", said.out);
    // tried again, it goes on from its checkpoint
    let said = place.expect(0, &["sweep", "--resume", "runs/fall-sweep", "--retry-failed", "--json"]);
    assert_eq!(ends(&said), ["finished"; 3]);
    whole(&place);
    assert_same_as_whole(&place);
}

#[test]
fn a_job_array_is_submitted_and_its_tasks_run() {
    let place = place();
    let base = [
        "sweep",
        "fall.toml",
        "--vary",
        "grains[0].count=20,30",
        "--out",
        "it's here/x",
    ];
    let options = [
        "--slurm",
        "--jobs",
        "3",
        "--threads",
        "2",
        "--sbatch",
        "time=2:00:00",
        "--sbatch=--partition=short",
    ];
    let said = place.expect(0, &[&base[..], &SHORT, &options].concat());
    assert!(said.out.contains("job.sh"), "{}", said.out);
    let script = place.path("it's here/x/job.sh");
    let text = fs::read_to_string(&script).unwrap();
    for line in [
        "#SBATCH --array=0-1%3",
        "#SBATCH --cpus-per-task=2",
        "#SBATCH --time=2:00:00",
        "#SBATCH --partition=short",
    ] {
        assert!(text.lines().any(|l| l == line), "no `{line}`:\n{text}");
    }
    let bash = |arguments: &[&str], task: Option<&str>| {
        let mut command = std::process::Command::new("bash");
        command.args(arguments).arg(&script).current_dir(place.path(""));
        let bin = format!("{}:{}", place.path("bin").display(), std::env::var("PATH").unwrap());
        command.env("PATH", bin).env_remove("SLURM_ARRAY_TASK_ID");
        if let Some(task) = task {
            command.env("SLURM_ARRAY_TASK_ID", task);
        }
        command.output().unwrap()
    };
    assert!(bash(&["-n"], None).status.success());
    // by hand it submits itself, and the gathering behind it
    fs::create_dir(place.path("bin")).unwrap();
    place.write(
        "bin/sbatch",
        "#!/bin/bash\nprintf '<%s>' \"$@\" >> submitted; echo >> submitted\n\
        while [ $# -gt 0 ]; do [ \"$1\" = --wrap ] && echo \"$2\" > gather.sh; shift; done; echo '42;cluster'\n",
    );
    let mut permissions = fs::metadata(place.path("bin/sbatch")).unwrap().permissions();
    std::os::unix::fs::PermissionsExt::set_mode(&mut permissions, 0o755);
    fs::set_permissions(place.path("bin/sbatch"), permissions).unwrap();
    let output = bash(&[], None);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let submitted = fs::read_to_string(place.path("submitted")).unwrap();
    assert!(
        submitted.contains("<--parsable>") && submitted.contains("<--dependency=afterany:42>"),
        "{submitted}"
    );
    assert!(submitted.contains("<--partition=short>"), "{submitted}");

    let output = bash(&[], Some("1"));
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    assert!(String::from_utf8_lossy(&output.stdout).contains("finished"));
    let gathered = place.expect(0, &["sweep", "--gather", "it's here/x", "--json"]);
    assert_eq!(ends(&gathered), ["waiting", "finished"]);
    assert!(bash(&[], Some("0")).status.success());
    // a task that is done does nothing more
    assert!(bash(&[], Some("0")).status.success());
    assert_eq!(bash(&[], Some("2")).status.code(), Some(2));
    let gather = std::process::Command::new("bash")
        .arg("gather.sh")
        .current_dir(place.path(""))
        .output()
        .unwrap();
    assert!(gather.status.success(), "{}", String::from_utf8_lossy(&gather.stderr));
    let rows = table(&place, "it's here/x/results.csv");
    let grains: Vec<&str> = rows.iter().map(|row| row["grains"].as_str()).collect();
    assert_eq!(grains, ["20", "30"]);
}

/// The processes that a process started.
fn children(parent: u32) -> Vec<u32> {
    let tasks = fs::read_dir(format!("/proc/{parent}/task")).into_iter().flatten();
    let told: Vec<String> = tasks
        .flatten()
        .flat_map(|task| fs::read_to_string(task.path().join("children")))
        .collect();
    told.join(" ")
        .split_whitespace()
        .map(|id| id.parse().unwrap())
        .collect()
}

/// Whether a process is there and no zombie.
fn is_alive(process: u32) -> bool {
    let status = fs::read_to_string(format!("/proc/{process}/stat")).unwrap_or_default();
    let rest = status.rsplit(')').next().unwrap_or_default().trim();
    !rest.is_empty() && !rest.starts_with('Z')
}
