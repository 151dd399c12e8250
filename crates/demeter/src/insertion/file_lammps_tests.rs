use super::*;
use crate::insertion::grain_file;
use crate::insertion::{Inserted, Insertion, InsertionError, Source, insert, read_grain_file};
use crate::materials::Material;
use proptest::prelude::*;
use std::path::{Path, PathBuf};

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
    match grain_file::parse(text) {
        Ok(table) => panic!("read as {table:?}"),
        Err(located) => format!("{}: {}", located.location, located.problem),
    }
}

#[test]
fn reads_a_data_file_with_image_flags_and_velocities_by_id() {
    let table = grain_file::parse(SMALL).unwrap();
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
        table.bounds,
        Some((DVec3::new(-0.1, 0.0, 0.0), DVec3::new(0.2, 0.2, 0.3)))
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
            changed("0 0.2 ylo yhi", "0 0.2 ylo yhi\n0 0 0 xy xz yz"),
            "a triclinic box is not read",
        ),
        (
            changed("2 atom types", "2 atom types\n4 bonds"),
            "an entry of `bonds` is not read",
        ),
        (
            changed("2 atom types", "2 apples"),
            "`2 apples` is not known in the header",
        ),
        (
            changed("# sphere", "# hybrid sphere dipole"),
            "the atom style is `hybrid sphere dipole`; only sphere is read",
        ),
        (
            changed("0.1 0.1 0 0 -1", "0.1"),
            "line 12: 6 values; an atom of atom_style sphere has 7",
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
            changed("Velocities", "Masses"),
            "line 16: section `Masses` is not read; known are Atoms and Velocities",
        ),
        (changed("Velocities", "Atoms"), "section `Atoms` is there twice"),
        (changed("Atoms # sphere", "Velocities"), "section `Atoms` is missing"),
    ] {
        let found = message(&text);
        assert!(found.contains(part), "expected {part}, found {found}");
    }
}

fn materials() -> Vec<Material> {
    let material = |name: &str, density| Material {
        name: name.to_owned(),
        young_modulus: 1e7,
        poisson_ratio: 0.3,
        density,
    };
    vec![material("glass", 2500.0), material("steel", 7800.0)]
}

fn from_file(path: &Path) -> Insertion {
    Insertion {
        fixed: false,
        name: "measured".to_owned(),
        material: 1,
        types: Vec::new(),
        source: Source::File {
            path: path.to_owned(),
            keep_velocities: true,
            density: None,
            scale: 1.0,
            shift: DVec3::ZERO,
        },
        velocity: DVec3::ZERO,
        velocity_deviation: 0.0,
        angular_velocity: DVec3::ZERO,
        tag: 0,
        seed: 1,
    }
}

fn insert_text(text: &[u8], change: impl Fn(&mut Insertion)) -> Result<Inserted, InsertionError> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("grains.txt");
    std::fs::write(&path, text).unwrap();
    let mut description = from_file(&path);
    change(&mut description);
    insert(&description, &materials(), &[], None)
}

#[test]
fn grains_of_a_file_take_the_settings_of_the_insertion() {
    let made = insert_text(SMALL.as_bytes(), |description| {
        description.types = vec![0, 1];
        description.velocity = DVec3::X;
        description.source = match &description.source {
            Source::File { path, .. } => Source::File {
                path: path.clone(),
                keep_velocities: true,
                density: None,
                scale: 0.5,
                shift: DVec3::Z,
            },
            other => other.clone(),
        };
    })
    .unwrap();
    assert_eq!(made.ids, Some(vec![3, 1, 2]));
    let grain = made.grains[1];
    assert_eq!((grain.material, grain.radius, grain.density), (1, 0.0075, 1100.0));
    assert_eq!(grain.position, DVec3::new(0.075, 0.05, 1.05));
    assert_eq!(grain.velocity, DVec3::new(1.05, 0.1, 0.15));
    assert_eq!(grain.angular_velocity, DVec3::new(0.4, 0.5, 0.6));
    assert_eq!(made.grains[0].material, 0);
}

#[test]
fn velocities_are_dropped_and_densities_replaced_when_asked() {
    let made = insert_text(SMALL.as_bytes(), |description| {
        if let Source::File {
            keep_velocities,
            density,
            ..
        } = &mut description.source
        {
            (*keep_velocities, *density) = (false, Some(900.0));
        }
    })
    .unwrap();
    for grain in made.grains {
        assert_eq!(
            (grain.velocity, grain.angular_velocity, grain.density),
            (DVec3::ZERO, DVec3::ZERO, 900.0)
        );
        assert_eq!(grain.material, 1);
    }
}

#[test]
fn materials_are_found_by_name_and_type() {
    let names = b"x y z diameter material\n0 0 0 1 steel\n2 0 0 1 glass\n";
    let made = insert_text(names, |_| {}).unwrap();
    assert_eq!(
        made.grains.iter().map(|g| (g.material, g.density)).collect::<Vec<_>>(),
        [(1, 7800.0), (0, 2500.0)]
    );
    assert_eq!(made.ids, None);
    let message = |text: &[u8], types: &[u16]| insert_text(text, |i| i.types = types.to_vec()).unwrap_err().to_string();
    let found = message(b"x y z diameter material\n0 0 0 1 wood\n", &[]);
    assert!(
        found.contains("material `wood` does not exist; known are glass, steel"),
        "{found}"
    );
    let found = message(SMALL.as_bytes(), &[0]);
    assert!(
        found.contains("grain 2 is of type 2, but the insertion gives materials for types 1 to 1"),
        "{found}"
    );
}

#[test]
fn files_that_cannot_be_read_are_named() {
    let missing = read_grain_file(Path::new("no/such/file.csv")).unwrap_err().to_string();
    assert!(missing.starts_with("no/such/file.csv: cannot be read: "), "{missing}");
    let folder = tempfile::tempdir().unwrap();
    let found = read_grain_file(folder.path()).unwrap_err().to_string();
    assert!(
        found.contains("not a regular file") || found.contains("cannot be read"),
        "{found}"
    );
    let found = insert_text(b"x y z diameter\n1 2 \xff 4\n", |_| {})
        .unwrap_err()
        .to_string();
    assert!(found.contains("is not text (byte 20 is not UTF-8)"), "{found}");
    let path = folder.path().join("huge.csv");
    let file = std::fs::File::create(&path).unwrap();
    // A file with a hole: it takes no room on the disk.
    file.set_len(crate::insertion::MAX_FILE_BYTES + 1).unwrap();
    let found = read_grain_file(&path).unwrap_err().to_string();
    assert!(found.contains("larger than 1073741824 bytes"), "{found}");
}

#[test]
fn wrong_settings_of_a_file_are_refused() {
    let message = |new_scale: f64, new_shift: DVec3, new_density: Option<f64>| {
        let made = insert_text(SMALL.as_bytes(), |description| {
            if let Source::File {
                scale, shift, density, ..
            } = &mut description.source
            {
                (*scale, *shift, *density) = (new_scale, new_shift, new_density);
            }
        });
        made.unwrap_err().to_string()
    };
    assert!(message(-1.0, DVec3::ZERO, None).contains("the scale is -1"));
    assert!(message(1e-11, DVec3::ZERO, None).contains("(grain 1, scaled)"));
    assert!(message(1.0, DVec3::NAN, None).contains("shift is NaN"));
    assert!(message(1.0, DVec3::ZERO, Some(0.0)).contains("the density is 0"));
}

#[test]
fn the_measured_hydrogel_packing_is_read() {
    // Lies beside a checkout of the project on the machines that have the data; nothing to do elsewhere.
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let path: PathBuf = root.join("../shared/data/hydrogel514/grains.data");
    if !path.exists() {
        return;
    }
    let made = insert(&from_file(&path), &materials(), &[], None).unwrap();
    assert_eq!(made.grains.len(), 514);
    let ids: Vec<u32> = (1..=514).collect();
    assert_eq!(made.ids, Some(ids));
    let mean = made.grains.iter().map(|g| 2.0 * g.radius).sum::<f64>() / 514.0;
    assert!((mean - 0.02149).abs() < 0.5e-5, "{mean}");
    assert!(
        made.grains
            .iter()
            .all(|g| g.density == 11.5 && g.velocity.length() < 0.01)
    );
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(500))]

    #[test]
    fn no_bytes_make_the_reader_panic(
        bytes in proptest::collection::vec(any::<u8>(), 0..300), at in 0..SMALL.len(), length in 0..40usize,
    ) {
        let _ = insert_text(&bytes, |_| {});
        // A good file with a part overwritten or lost.
        let mut damaged = SMALL.as_bytes().to_vec();
        for (place, byte) in damaged[at..].iter_mut().zip(bytes.iter().take(length)) {
            *place = byte & 0x7f;
        }
        let _ = insert_text(&damaged, |_| {});
        damaged.drain(at..(at + length).min(SMALL.len()));
        let _ = insert_text(&damaged, |_| {});
    }
}
