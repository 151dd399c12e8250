//! Hand-made runs with known answers.

mod broken;
mod metrics;

use super::*;
use crate::output::RunFolder;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use tempfile::TempDir;

/// Largest strain of the hand-made runs.
const TOP: f64 = 0.2;
/// Length of the packing [m].
const LENGTH: f64 = 0.5;
/// Edges of their bins of force [N].
const EDGES: [f64; 5] = [0.0, 0.001, 0.002, 0.003, 0.004];

/// A moment of a hand-made run.
#[derive(Clone, Copy)]
struct Moment {
    cycle: usize,
    loading: bool,
    strain: f64,
}

/// Contacts between grains and with walls in the bins, and above them.
type Counts = ([u32; 5], [u32; 5]);

/// How a hand-made run goes.
struct Made {
    cycles: usize,
    /// Rows of a stroke in a cycle.
    rows: fn(usize) -> usize,
    force: fn(Moment) -> f64,
    contacts: Option<fn(Moment) -> Counts>,
}

impl Default for Made {
    fn default() -> Self {
        Self {
            cycles: 3,
            rows: |_| 4,
            force: |m| 10.0 * m.strain,
            contacts: None,
        }
    }
}

const SERIES: &str =
    "step,time [s],stage,stage time [s],strain,wall top force z [N],wall top displacement z [m],mean force [N]\n";

impl Made {
    /// Series and distributions, as a run writes them: a plate that is lowered, then cycles; 10 grains.
    fn texts(&self) -> (String, String) {
        let mut series = SERIES.to_string();
        let mut forces =
            "step,time [s],stage,stage time [s],strain,grains,between,contacts,sum [N],0 [N],0.001 [N],0.002 [N],0.003 [N],above\n"
                .to_string();
        let mut step = 0;
        let mut add = |stage: &str, stage_time: f64, m: Moment| {
            let time = 0.1 * f64::from(step);
            let (strain, force) = (m.strain, (self.force)(m));
            let displacement = -0.03 - LENGTH * strain;
            let also = 2.0 * force;
            let _ = writeln!(
                series,
                "{step},{time:?},{stage},{stage_time:?},{strain:?},{force:?},{displacement:?},{also:?}"
            );
            if let Some(contacts) = self.contacts {
                let (pairs, walls) = contacts(m);
                for (between, counts) in [("grains", pairs), ("walls", walls)] {
                    let cells = counts.map(|c| c.to_string()).join(",");
                    let sum: u32 = counts.iter().sum();
                    let _ = writeln!(
                        forces,
                        "{step},{time:?},{stage},{stage_time:?},{strain:?},10,{between},{sum},1.0,{cells}"
                    );
                }
            }
            step += 1;
        };
        let moment = |cycle, loading, strain| Moment { cycle, loading, strain };
        add("lower", 0.0, moment(0, true, -0.06));
        add("lower", 0.1, moment(0, true, 0.0));
        for cycle in 0..self.cycles {
            let rows = (self.rows)(cycle);
            for (stage, loading) in [("squeeze", true), ("release", false)] {
                for row in 1..=rows {
                    let way = row as f64 / rows as f64;
                    let strain = if loading { TOP * way } else { TOP * (1.0 - way) };
                    let m = moment(cycle, loading, strain);
                    add(&format!("{stage} {}", cycle + 1), 0.1 * row as f64, m);
                }
            }
        }
        (series, forces)
    }

    fn write(&self, place: &TempDir, name: &str) -> PathBuf {
        let (series, forces) = self.texts();
        let folder = folder(place, name, &series);
        if self.contacts.is_some() {
            std::fs::create_dir(folder.join("distributions")).unwrap();
            std::fs::write(folder.join("distributions/forces.csv"), forces).unwrap();
        }
        folder
    }

    fn read(&self, reading: &Reading) -> Strokes {
        let place = tempfile::tempdir().unwrap();
        read_run(&self.write(&place, "run"), reading, None).unwrap()
    }
}

/// A run folder with a series.
fn folder(place: &TempDir, name: &str, series: &str) -> PathBuf {
    let folder = place.path().join(name);
    RunFolder::create(&folder, false).unwrap();
    std::fs::write(folder.join("series.csv"), series).unwrap();
    folder
}

fn discarding(discard: usize) -> Reading {
    Reading {
        discard,
        ..Reading::default()
    }
}

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-12 * b.abs().max(1.0)
}

#[test]
fn cycles_are_averaged_at_the_same_strain() {
    let made = Made {
        force: |m| (10.0 + m.cycle as f64) * m.strain + if m.loading { 0.0 } else { -0.5 * m.strain },
        ..Made::default()
    };
    let strokes = made.read(&discarding(1));
    assert_eq!((strokes.position, strokes.cycles), (Position::Strain, Some((2, 1))));
    let strains: Vec<f64> = strokes.loading.iter().map(|l| l.position).collect();
    assert!(
        strains
            .iter()
            .zip([0.0, 0.05, 0.1, 0.15, 0.2])
            .all(|(a, b)| near(*a, b)),
        "{strains:?}"
    );
    // cycles 1 and 2 of 0, 1, 2: factors 11 and 12
    let middle = strokes.loading[2].force.unwrap();
    assert!(near(middle.value, 1.15) && near(middle.deviation.unwrap(), 0.1 / 2f64.sqrt()));
    assert_eq!(middle.cycles, 2);
    assert!(near(middle.error().unwrap(), 0.05));
    // unloading begins with the last row of loading
    let unloading: Vec<f64> = strokes.unloading.iter().map(|l| l.force.unwrap().value).collect();
    let expected = [0.0, 11.0 * 0.05, 11.0 * 0.1, 11.0 * 0.15, 11.5 * 0.2];
    assert!(
        unloading.iter().zip(expected).all(|(a, b)| near(*a, b)),
        "{unloading:?}"
    );
}

#[test]
fn other_columns_are_averaged_and_signs_turned() {
    let reading = Reading {
        force: "-wall top force z [N]".to_string(),
        also: vec!["mean force".to_string()],
        unload: None,
        ..Reading::default()
    };
    let strokes = Made::default().read(&reading);
    let top = strokes.loading.last().unwrap();
    assert!(near(top.force.unwrap().value, -2.0) && near(top.also[0].value, 4.0));
    assert_eq!(
        (strokes.also.as_slice(), strokes.unloading.len()),
        (["mean force [N]".to_string()].as_slice(), 0)
    );
}

#[test]
fn rows_at_other_strains_are_interpolated() {
    let made = Made {
        rows: |cycle| 4 + cycle,
        ..Made::default()
    };
    for phase in Phase::ALL {
        let strokes = made.read(&Reading::default());
        assert_eq!(strokes.levels(phase).len(), 5);
        for level in strokes.levels(phase) {
            let force = level.force.unwrap();
            assert!(near(force.value, 10.0 * level.position) && force.deviation.unwrap() < 1e-12);
            assert_eq!(force.cycles, 3);
        }
    }
}

#[test]
fn without_a_strain_the_stage_time_tells_the_place() {
    let (series, _) = Made::default().texts();
    let place = tempfile::tempdir().unwrap();
    let folder = folder(&place, "run", &series.replace(",strain,", ",other,"));
    assert!(!tells_strain(&folder).unwrap());
    let strokes = read_run(&folder, &Reading::default(), None).unwrap();
    assert_eq!(strokes.position, Position::StageTime);
    let told = |levels: &[Level]| {
        levels
            .iter()
            .map(|l| (l.position, l.force.unwrap().value))
            .collect::<Vec<_>>()
    };
    assert!(told(&strokes.loading).iter().all(|(t, f)| near(*f, 5.0 * t)));
    assert!(told(&strokes.unloading).iter().all(|(t, f)| near(*f, 2.0 - 5.0 * t)));
    let itself = compare(&strokes, &strokes, Thresholds::default());
    let top = itself.rtop.unwrap();
    assert!(near(top.value, 1.0) && near(top.reference, 2.0) && itself.errf.unwrap().value == 0.0);
}

#[test]
fn compressions_are_those_of_the_plate() {
    let place = tempfile::tempdir().unwrap();
    let folder = Made::default().write(&place, "run");
    let strokes = read_run(&folder, &Reading::default(), Some(Position::Compression)).unwrap();
    let told = |strokes: &Strokes| strokes.loading.iter().map(|l| l.position).collect::<Vec<_>>();
    let expected = [0.0, 0.025, 0.05, 0.075, 0.1];
    assert!(told(&strokes).iter().zip(expected).all(|(a, b)| near(*a, b)));
    // without a strain they begin with each loading
    let (series, _) = Made::default().texts();
    let folder = super::tests::folder(&place, "other", &series.replace(",strain,", ",other,"));
    let strokes = read_run(&folder, &Reading::default(), Some(Position::Compression)).unwrap();
    assert!(told(&strokes).iter().zip(expected).all(|(a, b)| near(*a, b)));
}

#[test]
fn a_cycle_that_was_cut_counts_as_far_as_it_goes() {
    let (series, _) = Made::default().texts();
    // the header, 2 rows before, 2 cycles of 8 rows, 2 rows of the third loading, and half of a row
    let whole: Vec<&str> = series.lines().take(1 + 2 + 16 + 2).collect();
    let place = tempfile::tempdir().unwrap();
    let text = format!("{}\n21,2.1,squeeze 3,0.3,0.15,1", whole.join("\n"));
    let strokes = read_run(&folder(&place, "run", &text), &Reading::default(), None).unwrap();
    let cycles: Vec<usize> = strokes.loading.iter().map(|l| l.force.unwrap().cycles).collect();
    assert_eq!(cycles, [3, 3, 3, 2, 2]);
    assert!(strokes.unloading.iter().all(|l| l.force.unwrap().cycles == 2));
}

#[test]
fn repeats_are_known_by_their_numbers() {
    for (stage, name, is) in [
        ("squeeze", "squeeze", true),
        ("squeeze 12", "squeeze", true),
        ("squeeze 2.1", "squeeze", true),
        ("squeeze 2", "squeeze 2", true),
        ("squeeze 2", "squeeze 1", false),
        ("squeeze hard", "squeeze", false),
        ("squeeze 2.", "squeeze", false),
    ] {
        assert_eq!(is_repeat(stage, name), is, "{stage} {name}");
    }
}

/// A measured curve from a text.
fn measured(text: &str) -> Result<Strokes, CompareError> {
    let place = tempfile::tempdir().unwrap();
    let path = place.path().join("measured.csv");
    std::fs::write(&path, text).unwrap();
    read_measured(Path::new(&path))
}
