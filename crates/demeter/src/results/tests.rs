use super::*;
use crate::output::vtk_file::BLOCK;
use crate::output::vtp::{Array, Cells as VtpCells, PolyData, Values};
use crate::output::{RunFolder, vtk};
use glam::DVec3;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

/// A table with arrays of every type, one of them longer than a block.
fn table(points: usize) -> PolyData {
    let number = |k: usize| (k as f64 * 0.7).sin() * 10f64.powi(k as i32 % 300 - 150);
    PolyData {
        step: 12,
        time: 1.0 / 3.0,
        texts: vec![
            ("material_names".into(), vec!["glass".into(), "Stärke <&\">".into()]),
            ("none".into(), Vec::new()),
        ],
        fields: vec![Array::vectors("box", [&DVec3::NEG_ONE, &DVec3::new(0.1, 2e-300, 0.0)])],
        points: (0..points)
            .map(|k| DVec3::new(number(k), number(k + 1), -0.0))
            .collect(),
        cells: VtpCells::Vertices,
        point_data: vec![
            Array::new("id", 1, Values::UInt32((0..points as u32).rev().collect())),
            Array::new(
                "material",
                1,
                Values::Int32((0..points as i32).map(|k| k - 7).collect()),
            ),
            Array::new("long", 1, Values::Int64((0..points as i64).map(|k| k << 40).collect())),
            Array::new("orientation", 4, Values::Float64((0..4 * points).map(number).collect())),
        ],
        cell_data: vec![Array::scalars("of_cells", (0..points).map(number))],
    }
}

fn lines() -> PolyData {
    PolyData {
        points: vec![DVec3::X; 7],
        cells: VtpCells::Lines(vec![2, 0, 5]),
        point_data: vec![Array::scalars("time", [1.0; 7])],
        cell_data: vec![Array::scalars("length", [1.0; 3])],
        ..table(0)
    }
}

struct RunAtWork {
    _place: tempfile::TempDir,
    folder: RunFolder,
    run: Run,
}

/// The folder of a run with a frame at step 12.
fn run(tables: [&PolyData; 3]) -> RunAtWork {
    let place = tempfile::tempdir().unwrap();
    let folder = RunFolder::create(&place.path().join("run"), false).unwrap();
    for (kind, table) in TableKind::ALL.into_iter().zip(tables) {
        let name = kind.name();
        folder
            .write(&frame_path(&folder, kind), &table.encode().unwrap())
            .unwrap();
        let line = format!("<DataSet timestep=\"0.5\" part=\"0\" file=\"frames/{name}_0000000012.vtp\"/>\n");
        fs::write(folder.root().join(format!("{name}.pvd")), line).unwrap();
    }
    let run = Run::open(folder.root()).unwrap();
    RunAtWork {
        _place: place,
        folder,
        run,
    }
}

fn frame_path(folder: &RunFolder, kind: TableKind) -> PathBuf {
    folder.frames().join(format!("{}_0000000012.vtp", kind.name()))
}

#[test]
fn a_written_table_reads_back_to_the_bit() {
    let many = table(BLOCK / 8 + 3);
    let triangles = PolyData {
        cells: VtpCells::Triangles,
        points: vec![DVec3::Y; 6],
        point_data: Vec::new(),
        cell_data: vec![Array::scalars("pressure", [1.5, f64::INFINITY])],
        ..table(0)
    };
    let at_work = run([&many, &lines(), &triangles]);
    let frame = at_work.run.frame(12).unwrap();
    assert!(frame.grains == many);
    assert_eq!(frame.contacts, lines());
    assert_eq!(frame.walls, triangles);
    for points in [0, 1, BLOCK / 8, BLOCK / 4] {
        let table = table(points);
        assert!(
            run([&table; 3]).run.table(TableKind::Grains, 12).unwrap() == table,
            "{points}"
        );
    }
}

#[test]
fn arrays_are_read_one_by_one() {
    let at_work = run([&table(5), &table(0), &table(0)]);
    let mut file = at_work.run.open_table(TableKind::Grains, 12).unwrap();
    assert_eq!((file.step(), file.time(), file.rows()), (12, 1.0 / 3.0, 5));
    assert_eq!(file.texts("material_names"), ["glass", "Stärke <&\">"]);
    assert_eq!(
        file.names().collect::<Vec<_>>(),
        ["id", "material", "long", "orientation", "of_cells"]
    );
    assert_eq!(file.counts("id").unwrap(), [4, 3, 2, 1, 0]);
    assert_eq!(file.integers("material").unwrap()[0], -7);
    assert_eq!(file.floats("orientation", 4).unwrap().len(), 20);
    assert_eq!(file.points().unwrap(), table(5).points);
    let error = file.array("speed").unwrap_err().to_string();
    assert!(
        error.contains("no array `speed`; there are `id`, `material`"),
        "{error}"
    );
    let error = file.floats("id", 1).unwrap_err().to_string();
    assert!(error.contains("`id` does not hold 64-bit numbers"), "{error}");
}

#[test]
fn some_rows_are_those_of_the_whole() {
    let block = BLOCK / 8;
    let at_work = run([&table(2 * block + 5), &table(0), &table(0)]);
    let mut file = at_work.run.open_table(TableKind::Grains, 12).unwrap();
    let whole = file.floats("of_cells", 1).unwrap();
    for rows in [
        0..1,
        7..9,
        block - 1..block + 1,
        block..block,
        2 * block..2 * block + 5,
        0..whole.len(),
    ] {
        let some = file.rows_of("of_cells", rows.clone()).unwrap();
        assert!(some.values == Values::Float64(whole[rows.clone()].to_vec()), "{rows:?}");
    }
    assert_eq!(
        file.points_of(3..4).unwrap().values,
        Values::Float64(table(5).points[3].to_array().to_vec())
    );
    assert!(
        file.rows_of("id", usize::MAX - 1..usize::MAX)
            .unwrap()
            .values
            .is_empty()
    );
    let single = [
        0,
        3,
        block - 1,
        block,
        block + 7,
        2 * block + 4,
        whole.len(),
        usize::MAX,
    ];
    let there: Vec<f64> = single.iter().filter_map(|row| whole.get(*row).copied()).collect();
    let rows = file.rows_at("of_cells", &single).unwrap();
    assert!(there.len() == 6 && rows.values == Values::Float64(there));
    let vectors = file.array("orientation").unwrap();
    let numbers = |row: usize| (4 * row..4 * row + 4).map(|k| vectors.values.number(k).unwrap());
    let some = file.rows_at("orientation", &single[1..5]).unwrap();
    assert_eq!(some.components, 4);
    assert_eq!(
        some.values,
        Values::Float64(single[1..5].iter().flat_map(|row| numbers(*row)).collect())
    );
    assert!(file.rows_at("of_cells", &[]).unwrap().values.is_empty());
}

#[test]
fn damage_anywhere_is_an_error_or_leaves_the_table_as_it_was() {
    let whole = table(40);
    let bytes = whole.encode().unwrap();
    let at_work = run([&whole; 3]);
    let path = frame_path(&at_work.folder, TableKind::Grains);
    for length in (0..bytes.len()).step_by(7).chain([bytes.len() - 1]) {
        fs::write(&path, &bytes[..length]).unwrap();
        let error = at_work.run.table(TableKind::Grains, 12).unwrap_err();
        assert!(matches!(error, ResultsError::Damaged { .. }), "{length}: {error}");
    }
    for at in (0..bytes.len()).step_by(3) {
        for flip in [1, 0x80] {
            let mut damaged = bytes.clone();
            damaged[at] ^= flip;
            fs::write(&path, &damaged).unwrap();
            // a name or a time in the head may read as another one; the data are guarded by the sums of zlib
            let _ = at_work.run.table(TableKind::Grains, 12);
        }
    }
}

#[test]
fn a_file_that_lies_about_its_length_takes_no_memory() {
    let text = |bytes: Vec<u8>| bytes.iter().map(|b| char::from(*b)).collect::<String>();
    let back = |text: String| text.chars().map(|c| c as u8).collect::<Vec<u8>>();
    let at_work = run([&table(40); 3]);
    let path = frame_path(&at_work.folder, TableKind::Grains);
    let honest = text(table(40).encode().unwrap());
    for (from, to) in [
        (
            "NumberOfPoints=\"40\" NumberOfVerts=\"40\"",
            "NumberOfPoints=\"4000000000\" NumberOfVerts=\"4000000000\"",
        ),
        (
            "NumberOfPoints=\"40\" NumberOfVerts=\"40\"",
            "NumberOfPoints=\"100000000\" NumberOfVerts=\"100000000\"",
        ),
        ("NumberOfPoints=\"40\"", "NumberOfPoints=\"18446744073709551615\""),
        ("NumberOfComponents=\"4\"", "NumberOfComponents=\"4000000\""),
        ("offset=\"0\"", "offset=\"18446744073709551615\""),
        ("type=\"UInt32\"", "type=\"Float32\""),
        ("<PointData>", "<!DOCTYPE x [<!ENTITY a \"b\">]><PointData>"),
    ] {
        let lie = honest.replacen(from, to, 1);
        assert_ne!(lie, honest, "{from}");
        fs::write(&path, back(lie)).unwrap();
        let error = at_work.run.table(TableKind::Grains, 12).unwrap_err();
        assert!(matches!(error, ResultsError::Damaged { .. }), "{from}: {error}");
    }
    fs::write(&path, [b'<'; 1 << 16]).unwrap();
    assert!(at_work.run.table(TableKind::Grains, 12).is_err());
}

#[test]
fn moments_are_those_of_which_every_table_is_there() {
    let at_work = run([&table(1); 3]);
    let moments = at_work.run.moments().unwrap();
    assert_eq!(moments, [Moment { step: 12, time: 0.5 }]);
    fs::remove_file(frame_path(&at_work.folder, TableKind::Walls)).unwrap();
    assert_eq!(at_work.run.moments().unwrap(), []);
    let error = at_work.run.frame(12).unwrap_err().to_string();
    assert!(error.contains("no frame of step 12"), "{error}");
    let empty = tempfile::tempdir().unwrap();
    assert!(matches!(Run::open(empty.path()), Err(ResultsError::Folder(_))));
}

#[cfg(unix)]
#[test]
fn nothing_outside_the_folder_is_read() {
    let at_work = run([&table(1); 3]);
    let outside = at_work.folder.root().with_file_name("secret.csv");
    fs::write(&outside, "step,time [s]\n1,2\n").unwrap();
    let link = |from: &Path, to: &Path| std::os::unix::fs::symlink(from, to).unwrap();
    link(&outside, &at_work.folder.series());
    let error = at_work.run.series().unwrap_err();
    assert!(matches!(error, ResultsError::NotInside { .. }), "{error}");
    let frames = at_work.folder.frames();
    let moved = frames.parent().unwrap().with_file_name("frames");
    fs::rename(&frames, &moved).unwrap();
    link(&moved, &frames);
    assert!(matches!(
        at_work.run.table(TableKind::Grains, 12),
        Err(ResultsError::NotInside { .. })
    ));
    link(&outside, &at_work.folder.summary());
    assert!(at_work.run.summary().is_err() && !at_work.run.is_going_on());
    // a folder that is itself reached through a link is no way out
    let shortcut = at_work.folder.root().with_file_name("shortcut");
    link(at_work.folder.root(), &shortcut);
    assert_eq!(Run::open(&shortcut).unwrap().scenario().unwrap(), None);
}

fn series(text: &str) -> (tempfile::TempDir, PathBuf) {
    let place = tempfile::tempdir().unwrap();
    let path = place.path().join("series.csv");
    fs::write(&path, text).unwrap();
    (place, path)
}

fn add(path: &Path, text: &str) {
    fs::OpenOptions::new()
        .append(true)
        .open(path)
        .unwrap()
        .write_all(text.as_bytes())
        .unwrap();
}

#[test]
fn columns_have_names_units_numbers_and_words() {
    let (_place, path) = series("step,time [s],stage,x [m/s]\n0,0.0,1,NaN\n5,0.5,1,\n7,0.75,\"a, b\",inf\n");
    let table = Columns::read(&path).unwrap();
    assert_eq!((table.rows(), table.all().len()), (3, 4));
    assert_eq!(table.numbers("time").unwrap(), [0.0, 0.5, 0.75]);
    assert_eq!(
        (table.find("x").unwrap().name(), table.find("x [m/s]").unwrap().unit()),
        ("x", "m/s")
    );
    let x = table.numbers("x").unwrap();
    assert!(x[0].is_nan() && x[1].is_nan() && x[2] == f64::INFINITY);
    assert_eq!(table.words("stage").unwrap(), ["1", "1", "a, b"]);
    assert_eq!(
        table.spans("stage"),
        [("1".to_string(), 0..2), ("a, b".to_string(), 2..3)]
    );
    let error = table.numbers("tme").unwrap_err().to_string();
    assert!(error.contains("did you mean `time`?"), "{error}");
    assert!(table.numbers("stage").is_err() && table.words("time").is_err());
}

#[test]
fn a_growing_series_is_followed_row_by_row() {
    let (_place, path) = series("step,stage");
    let mut table = Columns::read(&path).unwrap();
    assert_eq!((table.rows(), table.all().len()), (0, 0));
    assert_eq!(table.update().unwrap(), Update::Unchanged);
    add(&path, "\n0,fill\n1,fi");
    assert_eq!(table.update().unwrap(), Update::Replaced);
    assert_eq!(table.rows(), 1);
    // half of a letter is not yet there
    add(&path, "ll\n2,pr\u{fc}fen\n3,p");
    assert_eq!(table.update().unwrap(), Update::Grown);
    add(&path, "r\n");
    assert_eq!(table.update().unwrap(), Update::Grown);
    assert_eq!(table.update().unwrap(), Update::Unchanged);
    assert_eq!(table.numbers("step").unwrap(), [0.0, 1.0, 2.0, 3.0]);
    assert_eq!(table.words("stage").unwrap(), ["fill", "fill", "pr\u{fc}fen", "pr"]);
    // a restart goes back to an earlier row
    fs::write(&path, "step,stage\n0,fill\n1,other\n2,other\n3,other\n4,other\n").unwrap();
    assert_eq!(table.update().unwrap(), Update::Replaced);
    assert_eq!(table.words("stage").unwrap()[1..], ["other"; 4]);
}

#[test]
fn a_row_that_does_not_fit_is_told_with_its_line() {
    let (_place, path) = series("step,time [s]\n0,0.0\n1,0.5\n");
    let mut table = Columns::read(&path).unwrap();
    add(&path, "2,soon\n");
    for _ in 0..2 {
        let error = table.update().unwrap_err().to_string();
        assert!(
            error.contains("line 4, column `time [s]`: `soon` is not a number"),
            "{error}"
        );
        assert_eq!((table.rows(), table.numbers("step").unwrap().len()), (2, 2));
    }
    add(&path, "3\n");
    let (_place, path) = series("a,b\n1\n");
    assert!(
        Columns::read(&path)
            .unwrap_err()
            .to_string()
            .contains("line 2 has 1 cells")
    );
}

#[test]
fn names_of_kinds_are_those_of_the_files() {
    assert_eq!(TableKind::ALL.map(TableKind::name), vtk::KINDS);
}
