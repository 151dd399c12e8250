//! Files of rows that something else changes while the run goes on.

use super::exchange::{HEAD, parse};
use demeter::scenario::{Observer, Progress, RunOptions, run};
use std::fs;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// Does something to a file in the midst of the run.
struct Hand {
    file: PathBuf,
    does: Option<fn(&Path)>,
}

impl Observer for Hand {
    fn progress(&mut self, progress: &Progress) -> bool {
        if progress.step > 100
            && let Some(does) = self.does.take()
        {
            does(&self.file);
        }
        true
    }

    fn interval(&self) -> Duration {
        Duration::ZERO
    }

    fn message(&mut self, _: &str) {}
}

fn told(name: &str, does: fn(&Path)) -> String {
    let place = tempfile::tempdir().unwrap();
    let scenario = parse(&format!(
        r#"{HEAD}
[[grains]]
material = "seed"
source = "list"
positions = [["0 m", "0 m", "0 m"]]
diameter = "2 mm"
[[measure]]
name = "layers"
kind = "profile"
lower = "-10 -10 -100 mm"
upper = "10 10 10 mm"
axis = "z"
slices = 2
[[stage]]
duration = "20 ms"
"#
    ));
    let folder = place.path().join("run");
    let mut hand = Hand {
        file: folder.join(name),
        does: Some(does),
    };
    let ended = run(&scenario, &folder, RunOptions::default(), &mut hand);
    assert!(
        !folder.join("summary.json").exists(),
        "a run that lost rows passes as whole"
    );
    ended.unwrap_err().to_string()
}

#[test]
fn a_run_whose_rows_something_else_changed_does_not_end_as_whole() {
    for name in ["series.csv", "profiles/layers.csv"] {
        let cut = told(name, |file| fs::write(file, "").unwrap());
        assert!(
            cut.contains("bytes, and the run wrote") && cut.contains("Something else"),
            "{cut}"
        );
        let gone = told(name, |file| fs::remove_file(file).unwrap());
        assert!(gone.contains(&format!("{name}` is gone")), "{gone}");
    }
    if cfg!(unix) {
        // as editors do that save a file
        let another = told("series.csv", |file| {
            let text = fs::read(file).unwrap();
            fs::write(file.with_extension("new"), text).unwrap();
            fs::rename(file.with_extension("new"), file).unwrap();
        });
        assert!(another.contains("another file stands in the place of"), "{another}");
    }
}
