use crate::grain_files::read::parse;
use crate::grain_files::{GrainFile, ReadOptions, TypeOfGrain, Which, read_grain_file};
use glam::DVec3;

const TWO: &str = "ITEM: UNITS\ncgs\nITEM: TIME\n0.5\nITEM: TIMESTEP\n100\nITEM: NUMBER OF ATOMS\n2\n\
    ITEM: BOX BOUNDS pp ff fs\n0 10\n0 20\n-5 5\n\
    ITEM: ATOMS id type xs ys z radius mass vx vy vz c_stress ix element\n\
    2 1 0.5 0.25 1 0.5 2 10 0 0 7.5 -1 H\n1 2 0 0 0 0.25 1 0 0 0 8 0 He\n\
    ITEM: TIMESTEP\n200\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS pp ff ff\n0 10\n0 20\n-5 5\n\
    ITEM: ATOMS id x y z diameter\n1 1 2 3 1\n";

#[test]
fn moments_columns_units_and_boxes_are_read() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("two.dump");
    std::fs::write(&path, TWO).unwrap();
    let mut file = GrainFile::open(&path, &ReadOptions::default()).unwrap();
    let first = file.next_frame().unwrap().unwrap();
    assert_eq!((first.step, first.time), (Some(100), Some(0.5)));
    assert_eq!(first.ids, Some(vec![2, 1]));
    assert_eq!(first.types, Some(vec![TypeOfGrain::Number(1), TypeOfGrain::Number(2)]));
    assert_eq!(first.positions[0], DVec3::new(0.05, 0.05, 0.01));
    assert_eq!(first.diameters, [0.01, 0.005]);
    assert_eq!(first.velocities.as_ref().unwrap()[0], DVec3::new(0.1, 0.0, 0.0));
    let volume = 4.0 / 3.0 * std::f64::consts::PI * 0.005f64.powi(3);
    assert!((first.densities.as_ref().unwrap()[0] * volume - 2e-3).abs() < 1e-15);
    assert_eq!(
        (first.extras[0].name.as_str(), first.extras[0].values[0]),
        ("c_stress", 7.5)
    );
    let cell = first.cell.unwrap();
    assert_eq!(
        (cell.upper, cell.periodic),
        (DVec3::new(0.1, 0.2, 0.05), [true, false, false])
    );
    // units are named once
    let second = file.next_frame().unwrap().unwrap();
    assert_eq!(
        (second.positions[0], second.diameters[0]),
        (DVec3::new(0.01, 0.02, 0.03), 0.01)
    );
    assert!(file.next_frame().unwrap().is_none());
    assert!(
        file.notes().iter().any(|note| note.contains("c_stress")),
        "{:?}",
        file.notes()
    );

    let options = ReadOptions::default();
    assert_eq!(read_grain_file(&path, &options, Which::Last).unwrap(), second);
    assert_eq!(read_grain_file(&path, &options, Which::Number(0)).unwrap(), first);
    let found = read_grain_file(&path, &options, Which::Number(2))
        .unwrap_err()
        .to_string();
    assert!(found.contains("there is no moment number 2; there are 2"), "{found}");
}

#[test]
fn labels_of_types_are_their_names() {
    let dump = |columns: &str, rows: &str| {
        format!(
            "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\nITEM: ATOMS {columns}\n{rows}"
        )
    };
    let alone = parse(&dump("typelabel x y z radius", "steel 0 0 0 1\nglass 3 0 0 1\n")).unwrap();
    assert_eq!(alone.type_names, ["steel", "glass"]);
    // beside numbers these stay as they are
    for columns in ["type typelabel x y z radius", "typelabel type x y z radius"] {
        let row = |number, label: &str| match columns.starts_with("typelabel") {
            true => format!("{label} {number}"),
            false => format!("{number} {label}"),
        };
        let rows = format!("{} 0 0 0 1\n{} 3 0 0 1\n", row(3, "steel"), row(1, "glass"));
        let table = parse(&dump(columns, &rows)).unwrap();
        assert_eq!(table.types, Some(vec![TypeOfGrain::Name(2), TypeOfGrain::Name(0)]));
        assert_eq!(table.type_names, ["glass", "2", "steel"]);
        assert_eq!(table.type_numbers(), [3, 1]);
    }
    for (rows, part) in [
        (
            "1 steel 0 0 0 1\n1 glass 3 0 0 1\n",
            "type 1 has two labels, `steel` and `glass`",
        ),
        (
            "4000000000 steel 0 0 0 1\n1 glass 3 0 0 1\n",
            "labels are read of types 1 to 65536",
        ),
    ] {
        let found = parse(&dump("type typelabel x y z radius", rows))
            .unwrap_err()
            .problem
            .to_string();
        assert!(found.contains(part), "{found}");
    }
}

#[test]
fn a_tilted_box_is_told_by_what_lies_around_it() {
    let text = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS xy xz yz pp pp pp\n-1 14 3\n0 12 -1\n0 10 2\n\
        ITEM: ATOMS xs ys zs radius\n0.5 0.5 0.5 1\n";
    let table = parse(text).unwrap();
    let cell = table.cell.unwrap();
    assert_eq!((cell.lower, cell.upper), (DVec3::ZERO, DVec3::new(11.0, 10.0, 10.0)));
    assert_eq!(cell.tilt, [3.0, -1.0, 2.0]);
    assert_eq!(table.positions[0], DVec3::new(6.5, 6.0, 5.0));
}

#[test]
fn a_box_of_three_edges_is_read_as_ovito_writes_it() {
    let text = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS abc origin pp ff pp\n11 0 0 -1\n3 10 0 -2\n-1 2 9 -3\n\
        ITEM: ATOMS x y z radius\n0 0 0 1\n";
    let cell = parse(text).unwrap().cell.unwrap();
    assert_eq!(
        (cell.lower, cell.upper),
        (DVec3::new(-1.0, -2.0, -3.0), DVec3::new(10.0, 8.0, 6.0))
    );
    assert_eq!((cell.tilt, cell.periodic), ([3.0, -1.0, 2.0], [true, false, true]));
}

#[test]
fn shares_of_a_box_of_any_edges_become_places() {
    let text = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS abc origin pp pp pp\n0 2 0 1\n-4 0 0 1\n0 1 8 1\n\
        ITEM: ATOMS xs ys zs radius\n0.5 0.25 0.5 1\n";
    let table = parse(text).unwrap();
    assert_eq!(table.positions[0], DVec3::new(0.0, 2.5, 5.0));
    assert!(table.cell.unwrap().is_general());
}

#[test]
fn places_may_be_told_in_several_ways_and_types_twice() {
    let text = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS pp pp pp\n0 10\n0 10\n0 10\n\
        ITEM: ATOMS type type x y z xu yu zu xs radius\n2 2 1 2 3 11 2 3 0.1 1\n";
    let table = parse(text).unwrap();
    assert_eq!(table.positions, [DVec3::new(1.0, 2.0, 3.0)]);
    assert_eq!(table.types, Some(vec![TypeOfGrain::Number(2)]));
}

#[test]
fn molecules_and_images_are_kept_and_words_are_told() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("two.dump");
    std::fs::write(&path, TWO.replace("c_stress", "mol")).unwrap();
    let mut file = GrainFile::open(&path, &ReadOptions::default()).unwrap();
    let extras = file.next_frame().unwrap().unwrap().extras;
    let told: Vec<_> = (extras.iter().map(|e| (e.name.as_str(), e.values.as_slice()))).collect();
    assert_eq!(told, [("mol", [7.5, 8.0].as_slice()), ("ix", [-1.0, 0.0].as_slice())]);
    assert!(file.notes().contains(&"columns are left out: element".to_owned()));
    let found = parse(&TWO.replace("7.5 -1 H", "7.5 0.5 H")).unwrap_err().to_string();
    assert!(
        found.contains("column `ix`: `0.5` is not allowed; image flags"),
        "{found}"
    );
}

#[test]
fn wrong_dumps_are_refused_with_place_and_remedy() {
    let head = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\n";
    for (text, part) in [
        (
            format!("{head}ITEM: ATOMS id x y z radius\n1 0 0 0 1\n"),
            "line 9: 1 rows where 2 are told",
        ),
        (
            format!("{head}ITEM: ATOMS id x y z radius\n1 0 0 0 1\nITEM: TIMESTEP\n"),
            "line 11: 1 rows where 2 are told",
        ),
        (
            format!("{head}ITEM: ATOMS id x y z radius\n1 0 0 0 1\n1 0 0 0 1\n"),
            "line 11: id 1 is there twice",
        ),
        (
            format!("{head}ITEM: ATOMS id x y z radius\n1 0 b 0 1\n"),
            "line 10, column `y`: `b` is not a number",
        ),
        (
            format!("{head}ITEM: ATOMS id x y z radius\n1 0 0 0 1 5\n"),
            "line 10: 6 values where 5 are needed",
        ),
        (
            format!("{head}ITEM: ATOMS id x y z radius\n1 0 0 0 -1\n"),
            "column `radius`: `-1` is not allowed",
        ),
        (
            format!("{head}ITEM: ATOMS id x y radius\n1 0 0 1\n"),
            "line 9: column `z` is missing",
        ),
        (
            format!("{head}ITEM: ATOMS id x y z radius vx q vz\n"),
            "line 9: column `vy` is missing",
        ),
        (
            format!("{head}ITEM: ATOMS id x y z radius omegax omegaz\n"),
            "line 9: column `omegay` is missing",
        ),
        (
            format!("{head}ITEM: ATOMS id x y z radius vx vx vz\n"),
            "line 9: `vx` is told twice",
        ),
        (
            format!("{head}ITEM: ATOMS id x x y z radius\n"),
            "line 9: `x` is told twice",
        ),
        (
            format!("{head}ITEM: ATOMS id x y z diameter radius\n"),
            "line 9: `radius` is told twice (also as `diameter`)",
        ),
        (
            format!("{head}ITEM: ATOMS id x y z\n1 0 0 0\n2 0 0 0\n"),
            "tells no sizes",
        ),
        (
            head.replace("0 1\n0 1\n0 1", "0 1\n1 0\n0 1"),
            "line 7: `1 0` is not allowed; the lower side",
        ),
        (
            head.replace("0 1\n0 1\n0 1", "0 1\n0 1 2\n0 1"),
            "line 7: 3 values where 2 are needed",
        ),
        (
            head.replace(
                "ff ff ff\n0 1\n0 1\n0 1",
                "abc origin ff ff ff\n0 1 0 0\n0 1 0 0\n0 0 1 0",
            ) + "ITEM: ATOMS x y z radius\n",
            "a flat box, whose edges lie in a plane, is not read; tell three edges",
        ),
        (head.replace("\n2\n", "\n-2\n"), "line 4: `-2` is not allowed"),
        (
            "ITEM: TIMESTEP\n".to_owned(),
            "line 2: the file ends where the number of steps is needed",
        ),
        (
            "ITEM: TIMESTEP\n0\nhello\n".to_owned(),
            "line 3: `hello` stands where a line such as `ITEM: TIMESTEP`",
        ),
        (
            format!("ITEM: UNITS\nlj\n{head}ITEM: ATOMS id x y z radius\n"),
            "in `lj` units of LAMMPS; tell",
        ),
        (
            "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ENTRIES\n3\nITEM: ENTRIES c_1\n".to_owned(),
            "a dump of contacts",
        ),
    ] {
        match parse(&text) {
            Ok(table) => panic!("{text} is read as {table:?}"),
            Err(found) => assert!(found.to_string().contains(part), "expected {part}, found {found}"),
        }
    }
}

#[test]
fn units_that_contradict_those_of_the_file_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("two.dump");
    let read = |text: &str, units: &str| {
        std::fs::write(&path, text).unwrap();
        let options = ReadOptions {
            units: Some(units.parse().unwrap()),
            ..ReadOptions::default()
        };
        read_grain_file(&path, &options, Which::Last).map_err(|error| error.to_string())
    };
    let found = read(TWO, "si").unwrap_err();
    assert!(
        found.contains("in `cgs` units of LAMMPS, and `si` was told; leave"),
        "{found}"
    );
    let found = read(TWO, "mm,g,s").unwrap_err();
    assert!(found.contains("`0.001 m, 0.001 kg, 1.0 s` was told"), "{found}");
    // the same units in other words, and those of a style without metres
    let own = read(TWO, "cm,g,s").unwrap();
    assert_eq!(own.positions[0], DVec3::new(0.01, 0.02, 0.03));
    let own = read(&TWO.replace("cgs", "lj"), "mm,g,s").unwrap();
    assert_eq!(own.positions[0].x, 0.001);
}
