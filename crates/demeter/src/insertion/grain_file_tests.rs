use crate::grain_files::{FileUnits, ReadOptions, Which};
use crate::insertion::{Inserted, Insertion, InsertionError, Source, insert};
use crate::materials::Material;
use glam::DVec3;
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
            reading: ReadOptions::default(),
            which: Which::Last,
        },
        velocity: DVec3::ZERO,
        velocity_deviation: 0.0,
        angular_velocity: DVec3::ZERO,
        tag: None,
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
fn tags_of_a_file_are_those_of_its_grains() {
    let tags = |text: &str| insert_text(text.as_bytes(), |_| {}).unwrap().tags;
    assert_eq!(tags("x,y,z,diameter,tag\n0,0,0,1,7.0\n2,0,0,1,-3\n"), Some(vec![7, -3]));
    assert_eq!(tags("x,y,z,diameter\n0,0,0,1\n"), None);
    assert_eq!(
        tags("1\nProperties=pos:R:3:radius:R:1:tag:I:1\n0 0 0 1 5\n"),
        Some(vec![5])
    );
    let dump = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\n";
    assert_eq!(
        tags(&format!("{dump}ITEM: ATOMS x y z radius tag\n0 0 0 1 6\n")),
        Some(vec![6])
    );
}

#[test]
fn numbers_that_are_names_of_materials_are_these() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("grains.csv");
    std::fs::write(&path, "x,y,z,diameter,material\n0,0,0,1,2\n2,0,0,1,1\n4,0,0,1,3\n").unwrap();
    let mut numbered = materials();
    for (material, name) in numbered.iter_mut().zip(["2", "1"]) {
        material.name = name.to_string();
    }
    let found = |materials: &[Material]| {
        let inserted = insert(&from_file(&path), materials, &[], None).unwrap();
        inserted.grains.iter().map(|grain| grain.material).collect::<Vec<u16>>()
    };
    // that of the insertion where there is none of this name
    assert_eq!(found(&numbered), [0, 1, 1]);
    assert_eq!(found(&materials()), [1, 1, 1]);
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
                reading: ReadOptions::default(),
                which: Which::Last,
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

/// The file tells its units, so that a factor for them would act twice.
#[test]
fn a_scale_on_top_of_units_that_the_file_names_is_refused() {
    let scaled = |named: &str, told: Option<FileUnits>, factor: f64| {
        let text = SMALL.replace("write_data", &format!("write_data, units = {named}"));
        insert_text(text.as_bytes(), |description| {
            if let Source::File { scale, reading, .. } = &mut description.source {
                (*scale, reading.units) = (factor, told);
            }
        })
    };
    let found = scaled("micro", None, 1e-6).unwrap_err().to_string();
    assert!(
        found.contains("the file is in `micro` units") && found.contains("tell `units = \"micro\"` beside it"),
        "{found}"
    );
    assert!(scaled("micro", None, 1.0).is_ok() && scaled("si", None, 0.5).is_ok());
    let both = scaled("micro", FileUnits::style("micro"), 0.5).unwrap();
    assert!((both.grains[1].radius - 0.0075e-6).abs() < 1e-20);
}

#[test]
fn labels_of_types_name_materials_unless_those_are_told() {
    let labels = "Atom Type Labels\n\n1 glass\n2 steel\n\n    Atoms # sphere";
    let data = SMALL.replace("Atoms # sphere", labels);
    let materials = |text: &str, types: &[u16]| {
        let made = insert_text(text.as_bytes(), |description| description.types = types.to_vec());
        made.map(|made| made.grains.iter().map(|grain| grain.material).collect::<Vec<u16>>())
    };
    assert_eq!(materials(&data, &[]).unwrap(), [0, 1, 0]);
    assert_eq!(materials(&data, &[1, 0]).unwrap(), [1, 0, 1]);
    // a label that no grain has needs no material
    let more = data.replace("2 steel", "2 steel\n3 wood");
    assert_eq!(materials(&more, &[]).unwrap(), [0, 1, 0]);
    let wood = materials(&data.replace("2 steel", "2 wood"), &[])
        .unwrap_err()
        .to_string();
    assert!(wood.contains("material `wood` does not exist"), "{wood}");
}

#[test]
fn a_restart_file_is_told_as_such() {
    let starts: [(&[u8], &str); 2] = [
        (b"LammpS RestartT\0\x01\0\0\0", "LAMMPS"),
        (b"\0\0\0\0\x5a\0\0\0Version LIGGGHTS-PUBLIC 3.8.0", "LIGGGHTS"),
    ];
    for (start, code) in starts {
        let found = insert_text(start, |_| {}).unwrap_err().to_string();
        assert!(
            found.contains(&format!("a binary restart file of {code}")) && found.contains("write_data"),
            "{found}"
        );
    }
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
