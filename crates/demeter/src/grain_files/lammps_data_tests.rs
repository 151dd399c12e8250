use super::looks_like;
use crate::grain_files::read::parse;
use crate::grain_files::{ReadOptions, TypeOfGrain, Which, read_grain_file};
use glam::DVec3;
use std::path::Path;

const SMALL: &str = "LAMMPS data file via write_data\n\n3 atoms # all\n2 atom types\n\n-1e-1 0.2 xlo xhi\n0 0.2 ylo yhi\n0 0.3 zlo zhi\n\n\
    Atoms # sphere\n\n\
    3 1 0.02 1200 0.05 0.1 0.1 0 0 -1\n\
    1 2 0.03 1100 0.15 0.1 0.1 0 0 0 # big\n\
    2 1 0.01 1200 0.1 0.1 0.2 1 0 0\n\n\
    Velocities\n\n\
    1 0.1 0.2 0.3 0.4 0.5 0.6\n\
    2 0 0 0 0 0 0\n\
    3 1 2 3 4 5 6\n";

fn message(text: &str) -> String {
    match parse(text) {
        Ok(table) => panic!("read as {table:?}"),
        Err(located) => format!("{}: {}", located.location, located.problem),
    }
}

#[test]
fn reads_a_data_file_with_image_flags_and_velocities_by_id() {
    let table = parse(SMALL).unwrap();
    assert_eq!(table.ids, Some(vec![3, 1, 2]));
    let types = [1, 2, 1].map(TypeOfGrain::Number);
    assert_eq!(table.types, Some(types.to_vec()));
    assert_eq!(table.diameters, [0.02, 0.03, 0.01]);
    assert_eq!(table.densities, Some(vec![1200.0, 1100.0, 1200.0]));
    assert_eq!(table.positions[2], DVec3::new(0.1, 0.1, 0.2));
    let velocities = [DVec3::new(1.0, 2.0, 3.0), DVec3::new(0.1, 0.2, 0.3), DVec3::ZERO];
    assert_eq!(table.velocities, Some(velocities.to_vec()));
    assert_eq!(table.angular_velocities.unwrap()[1], DVec3::new(0.4, 0.5, 0.6));
    assert_eq!(
        table.cell.map(|cell| (cell.lower, cell.upper, cell.tilt)),
        Some((DVec3::new(-0.1, 0.0, 0.0), DVec3::new(0.2, 0.2, 0.3), [0.0; 3]))
    );
}

#[test]
fn a_data_file_is_told_by_its_content() {
    assert!(looks_like("any title\n\n 12 atoms\n"));
    assert!(looks_like("LIGGGHTS data file\n"));
    assert!(!looks_like("x y z diameter\n1 2 3 4\n"));
}

#[test]
fn wrong_data_files_are_refused_with_place_and_remedy() {
    let changed = |from: &str, to: &str| {
        assert!(SMALL.contains(from), "{from}");
        SMALL.replacen(from, to, 1)
    };
    let cut = |before: &str| SMALL[..SMALL.find(before).unwrap()].to_owned();
    for (text, part) in [
        (
            cut("2 1 0.01"),
            "section `Atoms` has 2 lines, but the header tells 3 atoms; is the file cut short?",
        ),
        (
            cut("2 0 0 0"),
            "section `Velocities` has 1 lines, but the header tells 3",
        ),
        (
            cut("1 0.2 0.3"),
            "line 18: 2 values where 7 (id vx vy vz wx wy wz) are needed",
        ),
        (cut("Atoms"), "section `Atoms` is missing"),
        (
            changed("3 atoms", "2 atoms"),
            "line 14: section `Atoms` has more lines than the 2 atoms",
        ),
        (
            changed("3 atoms", "4000000000 atoms"),
            "has 3 lines, but the header tells 4000000000",
        ),
        (
            changed("3 atoms", "5000000000 atoms"),
            "line 3: `5000000000` is not allowed",
        ),
        (changed("3 atoms", "3 atoms\n3 atoms"), "`atoms` is told twice"),
        (changed("3 atoms # all\n", ""), "does not tell `atoms`"),
        (changed("0 0.2 ylo yhi\n", ""), "does not tell `ylo yhi`"),
        (
            changed("0 0.2 ylo yhi", "0.2 0 ylo yhi"),
            "the lower side must be below the upper",
        ),
        (
            changed("0 0.2 ylo yhi", "0 0.2 ylo yhi\n1 0 0 avec"),
            "a box told both by its edges (`avec`, ...) and by its sides (`xlo xhi`, ...) is not read",
        ),
        (
            changed("2 atom types", "2 atom types\n4 ellipsoids"),
            "an entry of `ellipsoids` is not read",
        ),
        (
            changed("2 atom types", "2 apples"),
            "`2 apples` is not known in the header",
        ),
        (
            changed("# sphere", "# hybrid sphere tri"),
            "the atom style is `hybrid sphere tri`, and `tri` of it is not known here; known are sphere, granular",
        ),
        (
            changed("0.1 0.1 0 0 -1", "0.1"),
            "line 12: 6 values; an atom of atom_style sphere has 7 (id type diameter density x y z) or 10",
        ),
        (
            changed("0 0 -1", "0 0 0.5"),
            "line 12, column `iz`: `0.5` is not allowed; image flags",
        ),
        (changed("3 1 0.02", "1 1 0.02"), "line 13: id 1 is there twice"),
        (
            changed("3 1 0.02", "3 3 0.02"),
            "column `type`: `3` is not allowed; it is above the `atom types`",
        ),
        (
            changed("3 1 0.02", "3 1 0"),
            "line 12, column `diameter`: `0` is not allowed",
        ),
        (changed("1200", "-1200"), "column `density`: `-1200`"),
        (changed("0.05 0.1", "nan 0.1"), "column `x`: `nan` is not allowed"),
        (
            changed("2 0 0 0 0", "9 0 0 0 0"),
            "line 19, column `id`: there is no atom with id 9",
        ),
        (
            changed("2 0 0 0 0", "1 0 0 0 0"),
            "line 19, column `id`: id 1 is there twice",
        ),
        (
            changed("2 0 0 0 0", "2 0 0 x 0"),
            "line 19, column `vz`: `x` is not a number",
        ),
        (
            changed("Velocities", "Speeds"),
            "line 16: section `Speeds` is not known; read are Atoms and Velocities",
        ),
        (changed("Velocities", "Atoms"), "section `Atoms` is there twice"),
        (
            changed("Atoms # sphere", "Velocities"),
            "line 10: section `Velocities` stands before `Atoms`",
        ),
    ] {
        let found = message(&text);
        assert!(found.contains(part), "expected {part}, found {found}");
    }
}

#[test]
fn a_box_of_any_edges_is_read_as_lammps_writes_it() {
    let sides = "-1e-1 0.2 xlo xhi\n0 0.2 ylo yhi\n0 0.3 zlo zhi\n";
    let edges = "0 0.3 0 avec\n-0.2 0 0 bvec\n0 0.1 0.3 cvec\n0.2 -0.1 0 abc origin\n";
    let cell = parse(&SMALL.replace(sides, edges)).unwrap().cell.unwrap();
    let expected = [
        DVec3::new(0.0, 0.3, 0.0),
        DVec3::new(-0.2, 0.0, 0.0),
        DVec3::new(0.0, 0.1, 0.3),
    ];
    assert_eq!(cell.edges(), expected);
    assert_eq!(cell.lower, DVec3::new(0.2, -0.1, 0.0));
    // without a corner it begins at the origin
    let bare = SMALL.replace(sides, "0.3 0 0 avec\n0 0.3 0 bvec\n0 0 0.3 cvec\n");
    let cell = parse(&bare).unwrap().cell.unwrap();
    assert!(cell.lower == DVec3::ZERO && !cell.is_general());
    for (told, part) in [
        (edges.replace("0 0.1 0.3 cvec\n", ""), "does not tell `cvec`"),
        (
            edges.replace("0 0.1 0.3 cvec", "1 1 0 cvec"),
            "a flat box, whose edges lie in a plane, is not read; tell three",
        ),
        (
            edges.replace("0 0.1 0.3 cvec", "0 0.1 0.3 avec"),
            "`avec` is told twice",
        ),
        (
            edges.replace("0 0.1 0.3 cvec", "0 0.1 cvec"),
            "is not known in the header",
        ),
    ] {
        let found = message(&SMALL.replace(sides, &told));
        assert!(found.contains(part), "expected {part}, found {found}");
    }
}

#[test]
fn files_that_cannot_be_read_are_named() {
    let read = |path: &Path| read_grain_file(path, &ReadOptions::default(), Which::Last);
    let missing = read(Path::new("no/such/file.csv")).unwrap_err().to_string();
    assert!(missing.starts_with("no/such/file.csv: cannot be read: "), "{missing}");
    let folder = tempfile::tempdir().unwrap();
    let found = read(folder.path()).unwrap_err().to_string();
    assert!(
        found.contains("not a regular file") || found.contains("cannot be read"),
        "{found}"
    );
    let path = folder.path().join("bytes.csv");
    std::fs::write(&path, b"x y z diameter\n1 2 \xff 4\n").unwrap();
    let found = read(&path).unwrap_err().to_string();
    assert!(found.contains("is not text (byte 20 is not UTF-8)"), "{found}");
    let path = folder.path().join("huge.csv");
    let file = std::fs::File::create(&path).unwrap();
    // A file with a hole: it takes no room on the disk.
    file.set_len(1 << 34).unwrap();
    let found = read(&path).unwrap_err().to_string();
    assert!(found.contains("line 1: is longer than 1048576 bytes"), "{found}");
}
