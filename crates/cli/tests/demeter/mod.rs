//! Calls the binary in a folder of its own.
#![allow(dead_code, reason = "every test file uses a part of it")]

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::time::{Duration, Instant};
use tempfile::TempDir;

/// What a call said.
pub struct Said {
    pub code: i32,
    pub out: String,
    pub err: String,
}

impl Said {
    /// Standard output as JSON; nothing else may be there.
    pub fn json(&self) -> serde_json::Value {
        serde_json::from_str(&self.out).unwrap_or_else(|error| panic!("{error}: {}\n{}", self.out, self.err))
    }
}

/// A folder to work in.
pub struct Place(TempDir);

impl Place {
    pub fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    pub fn write(&self, name: &str, text: &str) {
        fs::write(self.path(name), text).unwrap();
    }

    pub fn command(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_demeter"));
        command.args(arguments).current_dir(self.0.path()).stdin(Stdio::null());
        command
    }

    pub fn call(&self, arguments: &[&str]) -> Said {
        let output = self.command(arguments).output().unwrap();
        Said {
            code: output.status.code().unwrap_or(-1),
            out: String::from_utf8(output.stdout).unwrap(),
            err: String::from_utf8(output.stderr).unwrap(),
        }
    }

    /// Calls and expects an exit code.
    pub fn expect(&self, code: i32, arguments: &[&str]) -> Said {
        let said = self.call(arguments);
        assert_eq!(said.code, code, "{arguments:?}\n{}\n{}", said.out, said.err);
        said
    }

    /// Starts a run and waits until a file of it has been written.
    pub fn start_until(&self, arguments: &[&str], file: &str) -> Child {
        let mut child = self
            .command(arguments)
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        let deadline = Instant::now() + Duration::from_secs(120);
        while !self.path(file).exists() {
            assert!(Instant::now() < deadline, "`{file}` was not written");
            assert!(
                child.try_wait().unwrap().is_none(),
                "the run ended before `{file}` was written"
            );
            std::thread::sleep(Duration::from_millis(2));
        }
        child
    }

    /// Names of everything in the folder.
    pub fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(self.0.path()).unwrap();
        let mut names: Vec<String> = entries.map(|e| e.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }

    /// The results of a run that must not depend on threads and restarts: the series and all frames.
    pub fn results(&self, folder: &str) -> BTreeMap<String, Vec<u8>> {
        let root = self.path(folder);
        let mut results = BTreeMap::new();
        let mut take = |path: &Path| {
            let name = path.strip_prefix(&root).unwrap().display().to_string();
            results.insert(name, fs::read(path).unwrap());
        };
        for name in ["series.csv", "grains.pvd", "contacts.pvd", "walls.pvd"] {
            take(&root.join(name));
        }
        for entry in fs::read_dir(root.join("frames")).unwrap() {
            take(&entry.unwrap().path());
        }
        results
    }
}

/// Compares results without printing megabytes.
pub fn assert_same(a: &BTreeMap<String, Vec<u8>>, b: &BTreeMap<String, Vec<u8>>) {
    assert!(a.len() > 8, "there is little to compare: {:?}", a.keys());
    assert_eq!(a.keys().collect::<Vec<_>>(), b.keys().collect::<Vec<_>>());
    for (name, bytes) in a {
        assert!(bytes == &b[name], "`{name}` differs");
    }
}

/// Sends a signal to a process and waits for its end.
pub fn signal(child: &mut Child, name: &str) -> ExitStatus {
    let sent = Command::new("kill")
        .args([&format!("-{name}"), &child.id().to_string()])
        .status();
    assert!(sent.unwrap().success());
    child.wait().unwrap()
}

/// Interrupts a run behind its first checkpoint. A signal is heard at the next step; when the run was over by then,
/// it is tried again.
pub fn interrupt(place: &Place, run: &[&str], folder: &str, name: &str) {
    for _ in 0..10 {
        let _ = fs::remove_file(place.path(folder).join("checkpoint.latest"));
        let mut child = place.start_until(run, &format!("{folder}/checkpoint.latest"));
        match signal(&mut child, name).code() {
            Some(0) => continue,
            code => return assert_eq!(code, Some(130)),
        }
    }
    panic!("no run was long enough to be interrupted");
}

/// A run of `fall.toml` in `cut` that was interrupted.
pub fn interrupted() -> Place {
    let place = Place::new();
    place.write("fall.toml", FALL);
    interrupt(
        &place,
        &["run", "fall.toml", "--out", "cut", "--overwrite"],
        "cut",
        "INT",
    );
    place
}

/// Grains that fall into a box: friction, rolling and walls, some ten thousand steps.
pub const FALL: &str = r#"
title = "Grains fall into a box"

[simulation]
gravity = "0 0 -9.81 m/s^2"
max_overlap = 0.3

[material.glass]
young_modulus = "2 MPa"
poisson_ratio = 0.25
density = "2500 kg/m^3"

[contact]
normal = { law = "hertz-tsuji", restitution = 0.7 }
tangential = { law = "mindlin-history", friction = 0.4 }
rolling = { law = "epsd", rolling_friction = 0.02 }

[[grains]]
material = "glass"
source = "random"
region = { shape = "box", lower = "0 0 0 mm", upper = "12 12 12 mm" }
diameter = { distribution = "uniform", lower = "1.6 mm", upper = "2.4 mm" }
count = 120
velocity = "0.3 0.1 -0.2 m/s"

[[wall]]
name = "box"
material = "glass"
shape = "box"
lower = "0 0 0 mm"
upper = "12 12 14 mm"

[[stage]]
name = "fall"
steps = 6000

[[stage]]
name = "shake"
steps = 6000
motion.box = { oscillation = { amplitude = ["0.2 mm", "0 mm", "0 mm"], frequency = "50 Hz" } }

[output]
series = "1 ms"
frames = "4 ms"
checkpoints = "1 ms"
"#;
