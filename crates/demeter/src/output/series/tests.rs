use super::*;
use crate::measure::Energies;
use glam::DVec3;
use std::collections::BTreeSet;
use std::fs;

fn labels() -> SeriesLabels {
    SeriesLabels {
        stages: vec!["settle".to_owned(), "squeeze, slowly".to_owned()],
        walls: vec!["top".to_owned(), "the \"lid\"".to_owned()],
        strain: true,
        networks: vec!["packing".to_owned()],
        told: vec!["left mass [kg]".to_owned(), "left grains".to_owned()],
    }
}

fn row(step: u64) -> Measures {
    let x = step as f64 / 3.0;
    Measures {
        step,
        time: 1e-7 * x,
        stage: usize::from(step > 2),
        energies: Energies {
            kinetic: f64::MIN_POSITIVE,
            elastic: -0.0,
            residual: f64::NAN,
            wall_work: f64::MAX,
            ..Energies::default()
        },
        momentum: DVec3::new(0.1 + 0.2, f64::INFINITY, 5e-324),
        walls: vec![
            WallLoad::default(),
            WallLoad {
                force: DVec3::new(0.0, 0.0, x),
                ..WallLoad::default()
            },
        ],
        networks: vec![NetworkMeasures {
            contacts: 7,
            coordination: 2.0 * x,
            mean_force: 0.5,
            centre_distance: 0.25,
            packing_fraction: 0.5,
        }],
        told: vec![Value::Number(0.1 + 0.2), Value::Count(7)],
        ..Measures::default()
    }
}

/// Every cell by the name of its column.
fn cell(path: &Path, line: usize, title: &str) -> String {
    let mut reader = csv::Reader::from_path(path).unwrap();
    let at = reader.headers().unwrap().iter().position(|name| name == title).unwrap();
    reader.records().nth(line).unwrap().unwrap()[at].to_owned()
}

#[test]
fn numbers_read_back_to_the_same_bits() {
    let place = tempfile::tempdir().unwrap();
    let path = place.path().join("series.csv");
    let mut series = SeriesWriter::create(&path, labels()).unwrap();
    series.write(&row(1)).unwrap();
    series.write(&row(4)).unwrap();
    let number = |title: &str| -> f64 { cell(&path, 1, title).parse().unwrap() };
    let expected = row(4);
    assert_eq!(number("time [s]").to_bits(), expected.time.to_bits());
    assert_eq!(number("kinetic energy [J]").to_bits(), f64::MIN_POSITIVE.to_bits());
    assert_eq!(number("elastic energy [J]").to_bits(), (-0.0_f64).to_bits());
    assert_eq!(number("momentum x [kg m/s]").to_bits(), (0.1_f64 + 0.2).to_bits());
    assert_eq!(number("momentum z [kg m/s]").to_bits(), 1);
    assert_eq!(number("wall work [J]"), f64::MAX);
    assert_eq!(number("momentum y [kg m/s]"), f64::INFINITY);
    assert!(number("energy residual").is_nan());
    assert_eq!(
        number("wall the \"lid\" force z [N]").to_bits(),
        (4.0_f64 / 3.0).to_bits()
    );
    assert_eq!(number("packing coordination"), 2.0 * (4.0 / 3.0));
    assert_eq!(number("packing scaling [N m]"), 2.0 * (4.0 / 3.0) * 0.5 * 0.25 * 0.5);
    assert_eq!(number("left mass [kg]").to_bits(), (0.1_f64 + 0.2).to_bits());
    assert_eq!(cell(&path, 1, "left grains"), "7");
    assert_eq!(cell(&path, 0, "stage"), "settle");
    assert_eq!(cell(&path, 1, "stage"), "squeeze, slowly");
}

#[test]
fn a_resumed_series_is_the_same_file() {
    let place = tempfile::tempdir().unwrap();
    let (path, other) = (place.path().join("a.csv"), place.path().join("b.csv"));
    let mut straight = SeriesWriter::create(&path, labels()).unwrap();
    (0..8).for_each(|step| straight.write(&row(step)).unwrap());
    let whole = fs::read(&path).unwrap();
    // Whatever the place of the kill, and whichever step the checkpoint is from.
    for length in (0..=whole.len()).step_by(5) {
        fs::write(&other, &whole[..length]).unwrap();
        let mut rows = whole[..length].iter().filter(|&&b| b == b'\n').count();
        rows = rows.saturating_sub(1);
        let last = (rows as u64).saturating_sub(1);
        let mut resumed = SeriesWriter::resume(&other, labels(), last).unwrap();
        let next = if rows == 0 { 0 } else { last + 1 };
        (next..8).for_each(|step| resumed.write(&row(step)).unwrap());
        assert!(fs::read(&other).unwrap() == whole, "cut at {length}");
    }
    let mut resumed = SeriesWriter::resume(&path, labels(), 2).unwrap();
    assert_eq!(fs::read_to_string(&path).unwrap().lines().count(), 4);
    (3..8).for_each(|step| resumed.write(&row(step)).unwrap());
    assert!(fs::read(&path).unwrap() == whole);
}

#[test]
fn a_series_of_other_walls_is_refused() {
    let place = tempfile::tempdir().unwrap();
    let path = place.path().join("series.csv");
    SeriesWriter::create(&path, labels()).unwrap();
    let mut other = labels();
    other.walls[0] = "bottom".to_owned();
    let error = SeriesWriter::resume(&path, other, 0).unwrap_err();
    assert!(matches!(error, OutputError::OtherColumns { .. }));
    let mut series = SeriesWriter::resume(&path, labels(), 0).unwrap();
    let error = series.write(&Measures::default()).unwrap_err();
    assert!(matches!(
        error,
        OutputError::RowDoesNotFit {
            what: "walls",
            expected: 2,
            found: 0,
            ..
        }
    ));
    let mut without = row(1);
    without.networks.clear();
    let text = series.write(&without).unwrap_err().to_string();
    assert!(text.contains("has 0 contact networks, its header has 1"), "{text}");
}

#[test]
fn a_row_that_is_no_row_is_named() {
    let place = tempfile::tempdir().unwrap();
    let path = place.path().join("series.csv");
    SeriesWriter::create(&path, labels()).unwrap().write(&row(0)).unwrap();
    let mut text = fs::read_to_string(&path).unwrap();
    text.push_str("nonsense,1,2\n");
    fs::write(&path, text).unwrap();
    let text = SeriesWriter::resume(&path, labels(), 5).unwrap_err().to_string();
    assert!(text.contains("row 3 does not begin with a step"), "{text}");
}

#[test]
fn the_table_names_every_column_once() {
    let names = SeriesLabels {
        stages: Vec::new(),
        walls: vec!["NAME".to_owned()],
        strain: true,
        networks: vec!["MEASURE".to_owned()],
        told: (TOLD.iter())
            .flat_map(|(name, columns)| columns.iter().map(|c| c.title(name)))
            .collect(),
    }
    .header();
    let table = columns_table();
    assert!(names.iter().all(|name| table.contains(&format!("| `{name}` |"))));
    assert_eq!(table.lines().count(), 2 + names.len());
    // measures of two kinds may tell columns of one name
    let told: usize = TOLD.iter().map(|(_, columns)| columns.len()).sum();
    let (before, told) = names.split_at(names.len() - told);
    let are_different = |names: &[String]| names.iter().collect::<BTreeSet<_>>().len() == names.len();
    assert!(are_different(before), "{before:?}");
    assert_eq!(
        before.len(),
        COLUMNS.len() + 1 + WALL_COLUMNS.len() + NETWORK_COLUMNS.len()
    );
    let mut rest = told;
    for (_, columns) in TOLD {
        let (of_kind, others) = rest.split_at(columns.len());
        assert!(are_different(of_kind), "{of_kind:?}");
        rest = others;
    }
}
