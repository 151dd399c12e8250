//! `mpirun demeter run`: the bits of one process, and what goes wrong among several.
#![cfg(feature = "mpi")]
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests may fail as tests do")]

mod demeter;

use demeter::{Place, Said, assert_same, signal};
use std::process::{Child, Command, Output, Stdio};
use std::sync::mpsc;
use std::time::{Duration, Instant};

/// Grains for several processes, a feed, a drain, walls of all drives.
const MIXER: &str = include_str!("../../demeter/tests/engine/shared_runs/mixer.toml");

const RUN: [&str; 3] = ["run", "mixer.toml", "--threads=1"];

/// What is long enough to be stopped, most of the time while a frame is gathered.
const LONG: [&str; 6] = [
    "--set",
    "stage.mix.duration=\"1 s\"",
    "--set",
    "output.frames=\"0.01 ms\"",
    "--set",
    "output.checkpoints=\"0.2 ms\"",
];

/// Time after which a job no longer ends by itself.
const TO_END: Duration = Duration::from_secs(300);

/// `mpirun`, or another that `MPIRUN` names.
fn launcher() -> String {
    std::env::var("MPIRUN").unwrap_or_else(|_| "mpirun".to_owned())
}

/// Under the launcher, also where root runs it on a machine with fewer cores.
fn mpirun(place: &Place, processes: &[&[&str]]) -> Command {
    let mut command = Command::new(launcher());
    for (k, arguments) in processes.iter().enumerate() {
        if k > 0 {
            command.arg(":");
        }
        command
            .args(["-n", "1", env!("CARGO_BIN_EXE_demeter")])
            .args(*arguments);
    }
    let set = [
        "OMPI_ALLOW_RUN_AS_ROOT",
        "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM",
        "OMPI_MCA_rmaps_base_oversubscribe",
        "OMPI_MCA_mpi_yield_when_idle",
    ];
    command.envs(set.map(|name| (name, "1")));
    command.current_dir(place.path("")).stdin(Stdio::null());
    command
}

/// What a job said. The launcher of Open MPI 4 now and then misses that a process has ended with an error, and waits for ever (its issue
/// 3380): where none of ours is left, the job is begun again.
fn said(mut command: Command) -> Said {
    command.stdout(Stdio::piped()).stderr(Stdio::piped());
    for _ in 0..3 {
        match end_of(command.spawn().unwrap()) {
            Ok(output) => {
                return Said {
                    code: output.status.code().unwrap_or(-1),
                    out: String::from_utf8_lossy(&output.stdout).into_owned(),
                    err: String::from_utf8_lossy(&output.stderr).into_owned(),
                };
            }
            Err(left) => assert!(left.is_empty(), "processes that do not end: {left:?}"),
        }
    }
    panic!("the launcher has not ended three times");
}

/// What a job has written once it has ended, or what its processes do where it does not end.
fn end_of(job: Child) -> Result<Output, Vec<String>> {
    let launcher = job.id();
    let (sender, receiver) = mpsc::channel();
    std::thread::spawn(move || sender.send(job.wait_with_output().unwrap()));
    receiver.recv_timeout(TO_END).map_err(|_| {
        let ranks = children_of(launcher);
        let state = |rank: &String| {
            let read = |file: &str| std::fs::read_to_string(format!("/proc/{rank}/{file}")).unwrap_or_default();
            format!("{}waits in {}", read("status"), read("wchan"))
        };
        let states = ranks.iter().map(state).collect();
        let all = ranks.into_iter().chain([launcher.to_string()]);
        let _ = Command::new("kill").arg("-KILL").args(all).status();
        states
    })
}

impl Place {
    fn summary(&self, folder: &str) -> serde_json::Value {
        serde_json::from_slice(&std::fs::read(self.path(folder).join("summary.json")).unwrap()).unwrap()
    }
}

fn mixer() -> Place {
    let place = Place::new();
    place.write("mixer.toml", MIXER);
    place
}

fn run(out: &'static str) -> Vec<&'static str> {
    [&RUN[..], &["--out", out]].concat()
}

fn long_run(out: &'static str) -> Vec<&'static str> {
    [&run(out)[..], &LONG].concat()
}

#[test]
fn two_and_three_processes_give_the_bits_of_one() {
    let place = mixer();
    place.expect(0, &run("one"));
    let one = place.results("one");
    assert!(place.summary("one")["contacts"].as_u64().unwrap() > 200);
    for (out, count) in [("two", 2), ("three", 3)] {
        let said = said(mpirun(&place, &vec![&run(out)[..]; count]));
        assert_eq!(said.code, 0, "{}\n{}", said.out, said.err);
        assert_eq!(said.out.matches("energy residual").count(), 1, "{}", said.out);
        assert_eq!(place.summary(out)["processes"], count);
        let workers = format!("on 1 thread of each of {count} processes");
        assert!(said.out.contains(&workers), "{}", said.out);
        assert!(
            said.err.contains(&format!("shared by {count} processes")),
            "{}",
            said.err
        );
        assert_same(&one, &place.results(out));
    }
}

#[test]
fn a_run_that_is_asked_to_end_goes_on_with_other_processes() {
    let place = mixer();
    place.expect(0, &run("one"));
    let mut command = mpirun(&place, &[&run("parts")[..]; 2]);
    command.env("OMPI_MCA_odls_base_sigkill_timeout", "4");
    let shared = started(command, &place, "parts/frames");
    let version = Command::new(launcher()).arg("--version").output().unwrap();
    let asked = if String::from_utf8_lossy(&version.stdout).contains("Open MPI") {
        // what Ctrl-C does: the launcher ends its processes, and gives them so many seconds
        shared.id().to_string()
    } else {
        // that of MPICH kills them at once: one process is asked, and all end
        children_of(shared.id()).remove(1)
    };
    assert!(Command::new("kill").args(["-INT", &asked]).status().unwrap().success());
    let told = end_of(shared).unwrap();
    let told = String::from_utf8_lossy(&told.stderr);
    // not at all where the launcher was gone by then
    assert!(told.matches("interrupt again").count() <= 1, "{told}");
    assert!(place.path("parts/checkpoint.latest").exists());
    place.expect(0, &["resume", "parts", "--threads", "1"]);
    assert_same(&place.results("one"), &place.results("parts"));
    let said = said(mpirun(&place, &[&["resume", "parts"][..]; 2]));
    assert_eq!(
        (said.code, said.out.matches("finished").count()),
        (0, 1),
        "{}",
        said.err
    );
}

/// A job that has written a file or folder.
fn started(mut command: Command, place: &Place, file: &str) -> Child {
    let child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    let deadline = Instant::now() + Duration::from_secs(120);
    while !place.path(file).exists() {
        assert!(Instant::now() < deadline, "`{file}` was not written");
        std::thread::sleep(Duration::from_millis(2));
    }
    child
}

#[test]
fn a_process_that_is_killed_ends_the_job_and_leaves_a_checkpoint() {
    let place = mixer();
    let long = long_run("long");
    let job = started(mpirun(&place, &[&long[..]; 2]), &place, "long/checkpoint.previous");
    let ranks = children_of(job.id());
    assert_eq!(ranks.len(), 2);
    let killed = Command::new("kill").args(["-KILL", &ranks[1]]).status().unwrap();
    assert!(killed.success());
    let output = end_of(job).unwrap();
    let said = [output.stdout, output.stderr].concat();
    let said = String::from_utf8_lossy(&said);
    // another process may notice and abort before the launcher tells of the first
    let is_told = ["signal 9", "KILLED BY SIGNAL", "No such process"]
        .iter()
        .any(|text| said.contains(text));
    assert!(!output.status.success() && is_told, "{said}");
    expect_to_go_on(&place);
}

/// Goes on from the latest checkpoint for a while.
fn expect_to_go_on(place: &Place) {
    let mut resumed = place.command(&["resume", "long", "--json"]);
    let mut resumed = resumed.stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap();
    std::thread::sleep(Duration::from_millis(500));
    assert_eq!(signal(&mut resumed, "INT").code(), Some(130), "it did not go on");
}

#[test]
fn a_disk_that_takes_no_more_ends_the_job_and_leaves_a_checkpoint() {
    let place = mixer();
    let long = long_run("long");
    let mut job = started(mpirun(&place, &[&long[..]; 2]), &place, "long/checkpoint.previous");
    // a folder in the way: no more checkpoints can be written
    let part = place.path("long/checkpoint.latest.part");
    let deadline = Instant::now() + Duration::from_secs(60);
    while std::fs::create_dir(&part).is_err() {
        assert!(Instant::now() < deadline, "{:?}", job.try_wait());
    }
    let output = end_of(job).unwrap();
    let err = String::from_utf8_lossy(&output.stderr);
    assert!(!output.status.success(), "{err}");
    assert_eq!(err.matches("cannot write checkpoint").count(), 1, "{err}");
    std::fs::remove_dir(&part).unwrap();
    expect_to_go_on(&place);
}

#[test]
fn a_process_that_says_nothing_is_given_up() {
    let place = mixer();
    let long = long_run("long");
    let mut command = mpirun(&place, &[&long[..]; 2]);
    command.env("DEMETER_PATIENCE", "2");
    let job = started(command, &place, "long/checkpoint.latest");
    let ranks = children_of(job.id());
    let stopped = Command::new("kill").args(["-STOP", &ranks[1]]).status().unwrap();
    assert!(stopped.success());
    let output = end_of(job).unwrap();
    let err = String::from_utf8_lossy(&output.stderr);
    assert!(!output.status.success() && err.contains("has waited for"), "{err}");
    assert!(err.contains("demeter resume"), "{err}");
}

/// Processes of Demeter that a launcher has started, itself or through a helper of its own, as that of MPICH does.
fn children_of(launcher: u32) -> Vec<String> {
    let children = |of: &str| -> Vec<String> {
        let found = Command::new("pgrep").args(["-P", of]).output().unwrap();
        let found = String::from_utf8(found.stdout).unwrap();
        found.lines().map(str::to_string).collect()
    };
    let is_ours = |process: &String| {
        let name = std::fs::read_to_string(format!("/proc/{process}/comm"));
        name.is_ok_and(|name| name.trim() == "demeter")
    };
    let first = children(&launcher.to_string());
    let second = first
        .iter()
        .filter(|child| !is_ours(child))
        .flat_map(|child| children(child));
    let all: Vec<String> = second.collect();
    first.into_iter().chain(all).filter(is_ours).collect()
}

#[test]
fn processes_with_other_inputs_do_not_begin() {
    let place = mixer();
    let other = [&run("out")[..], &["--set", "contact.tangential.friction=0.3"]].concat();
    let said = said(mpirun(&place, &[&run("out"), &other]));
    assert_eq!(said.code, 2, "{}", said.err);
    assert!(
        said.err
            .contains("process 1 differs from process 0: it has another scenario"),
        "{}",
        said.err
    );
    assert!(!place.path("out").exists());
}

#[test]
fn what_is_wrong_is_told_once() {
    let place = mixer();
    let wrong = ["run", "mixer.toml", "--set", "stage.mix.duration=\"6 kg\""];
    let wrong_here = said(mpirun(&place, &[&wrong[..]; 3]));
    assert_eq!(wrong_here.code, 2, "{}", wrong_here.err);
    assert_eq!(
        wrong_here.err.matches("nothing was written").count(),
        1,
        "{}",
        wrong_here.err
    );
    for (unknown, told) in [
        (["run", "mixer.toml", "--tread", "2"], "unexpected argument"),
        (["sweep", "mixer.toml", "--repeat", "2"], "share their work"),
    ] {
        let said = said(mpirun(&place, &[&unknown[..]; 3]));
        assert_eq!((said.code, said.err.matches(told).count()), (2, 1), "{}", said.err);
    }
    let elsewhere = said(mpirun(&place, &[&run("out"), &["run", "missing.toml"]]));
    assert_ne!(elsewhere.code, 0);
    assert!(elsewhere.err.contains("missing.toml"), "{}", elsewhere.err);
    assert!(!place.path("out").exists());
}

#[test]
fn what_is_not_shared_is_refused_to_several() {
    let place = mixer();
    for command in [&["sweep", "mixer.toml", "--repeat", "2"][..], &["check", "mixer.toml"]] {
        let said = said(mpirun(&place, &[command; 2]));
        assert_ne!(said.code, 0, "{}", said.out);
        assert!(
            said.err.contains("only `demeter run` and `demeter resume`"),
            "{}",
            said.err
        );
    }
    assert!(!place.path("runs").exists());
    let alone = said(mpirun(&place, &[&["check", "mixer.toml"]]));
    assert_eq!(alone.code, 0, "{}", alone.err);
}

#[test]
fn contacts_that_feel_each_other_keep_their_bits() {
    let place = mixer();
    let coupled = |out: &'static str| {
        let law = "contact.multi_contact={ law = \"half-space\", prefactor = 0.5 }";
        [&run(out)[..], &["--set", law, "--set", "stage.mix.duration=\"0.2 ms\""]].concat()
    };
    place.expect(0, &coupled("one"));
    let said = said(mpirun(&place, &[&coupled("two")[..]; 2]));
    assert_eq!(said.code, 0, "{}", said.err);
    assert!(!said.err.contains("nothing is gained"), "{}", said.err);
    assert_same(&place.results("one"), &place.results("two"));
}
