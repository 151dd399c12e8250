//! What is written is read back, and damage never does harm.

use super::lines::Lines;
use super::read::{parse, parse_as};
use super::*;
use glam::DVec3;
use proptest::prelude::*;

fn written(tables: &[&GrainTable], format: Format, options: WriteOptions) -> String {
    let mut writer = GrainWriter::new(Vec::new(), format, options).unwrap();
    for table in tables {
        writer.write(table).unwrap();
    }
    String::from_utf8(writer.finish().unwrap()).unwrap()
}

fn read_back(text: &str, format: Format) -> GrainTable {
    let found = Format::of_text(&Lines::of(text).start().unwrap());
    let same = |name: &str| name.replace("liggghts", "lammps");
    assert_eq!(same(found.name()), same(format.name()));
    parse_as(
        text,
        &ReadOptions {
            format: Some(format),
            extra_columns: true,
            ..ReadOptions::default()
        },
    )
    .unwrap()
}

fn vectors(count: usize, seed: f64) -> Vec<DVec3> {
    let value = |k: usize| libm::sin(seed + 1.7 * k as f64) * libm::pow(10.0, (k % 7) as f64 - 5.0);
    (0..count)
        .map(|k| DVec3::new(value(3 * k), value(3 * k + 1), value(3 * k + 2)))
        .collect()
}

fn table(count: usize, seed: f64) -> GrainTable {
    GrainTable {
        ids: Some((1..=count as u32).rev().collect()),
        types: Some((0..count).map(|k| TypeOfGrain::Name((k % 2) as u32)).collect()),
        type_names: vec!["glass".to_owned(), "steel".to_owned()],
        positions: vectors(count, seed),
        diameters: (0..count)
            .map(|k| 1e-3 * (1.0 + libm::cos(seed + k as f64).abs()))
            .collect(),
        densities: Some((0..count).map(|k| 2500.0 + seed * k as f64 / 3.0).collect()),
        velocities: Some(vectors(count, seed + 1.0)),
        angular_velocities: Some(vectors(count, seed + 2.0)),
        forces: Some(vectors(count, seed + 3.0)),
        torques: Some(vectors(count, seed + 4.0)),
        extras: vec![Extra {
            name: "coordination".to_owned(),
            unit: String::new(),
            values: vec![6.0; count],
        }],
        cell: Some(Cell {
            lower: DVec3::splat(-2.0),
            upper: DVec3::splat(3.0),
            tilt: [0.0; 3],
            rise: [0.0; 3],
            periodic: [true, false, true],
        }),
        step: Some(12_345),
        time: Some(0.1 * seed),
    }
}

fn numbered(table: &GrainTable) -> Option<Vec<TypeOfGrain>> {
    Some(table.type_numbers().into_iter().map(TypeOfGrain::Number).collect())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn every_format_reads_back_what_it_carries_to_the_bit(count in 2..20usize, seed in 0.0..100.0f64) {
        let table = table(count, seed);
        for format in Format::ALL {
            let text = written(&[&table], format, WriteOptions::default());
            let back = read_back(&text, format);
            prop_assert_eq!(&back.positions, &table.positions);
            prop_assert_eq!(&back.diameters, &table.diameters);
            if format == Format::Yade {
                prop_assert_eq!(&back.types, &numbered(&table));
                continue;
            }
            prop_assert_eq!(&back.ids, &table.ids);
            prop_assert_eq!(&back.densities, &table.densities);
            prop_assert_eq!(&back.velocities, &table.velocities);
            prop_assert_eq!(&back.angular_velocities, &table.angular_velocities);
            match format {
                Format::Columns | Format::ExtendedXyz => prop_assert_eq!(&back.types, &table.types),
                _ => prop_assert_eq!(&back.types, &numbered(&table)),
            }
            if format != Format::LammpsData && format != Format::LiggghtsData {
                prop_assert_eq!(&back.forces, &table.forces);
                prop_assert_eq!(&back.torques, &table.torques);
                prop_assert_eq!(&back.extras[0].values, &table.extras[0].values);
            }
        }
    }

    /// Edges, tilts and sums of them are rounded once.
    #[test]
    fn tilted_boxes_read_back_to_the_last_digits(
        xy in -2.0..2.0f64, xz in -2.0..2.0f64, yz in -2.0..2.0f64, low in -1e3..1e3f64,
    ) {
        let mut table = table(3, 1.0);
        table.cell = Some(Cell {
            lower: DVec3::splat(low),
            upper: DVec3::new(low + 5.0, low + 6.0, low + 7.0),
            tilt: [xy, xz, yz],
            rise: [0.0; 3],
            periodic: [true; 3],
        });
        for format in [Format::LammpsData, Format::LammpsDump, Format::LiggghtsDump, Format::ExtendedXyz] {
            let back = read_back(&written(&[&table], format, WriteOptions::default()), format).cell.unwrap();
            let cell = table.cell.unwrap();
            prop_assert_eq!(back.tilt, cell.tilt);
            prop_assert!((back.lower - cell.lower).abs().max_element() <= 1e-12 * 1e3, "{:?}", back);
            prop_assert!((back.upper - cell.upper).abs().max_element() <= 1e-12 * 1e3, "{:?}", back);
        }
    }

    /// Boxes with edges in any direction, of the right or the left hand, and their images.
    #[test]
    fn boxes_of_any_edges_read_back(edges in proptest::array::uniform9(-2.0..2.0f64), low in -10.0..10.0f64) {
        let [a, b, c] = [0, 3, 6].map(|k| DVec3::from_slice(&edges[k..k + 3]));
        prop_assume!(a.cross(b).dot(c).abs() > 1e-3);
        let mut table = table(3, 1.0);
        table.cell = Cell::of_edges([a, b, c], DVec3::splat(low));
        let near = |one: DVec3, other: DVec3| (one - other).abs().max_element() < 1e-14 * 20.0;
        for format in [Format::LammpsData, Format::LammpsDump, Format::ExtendedXyz] {
            let back = read_back(&written(&[&table], format, WriteOptions::default()), format).cell.unwrap();
            let [x, y, z] = back.edges();
            prop_assert!(near(a, x) && near(b, y), "{:?}", back);
            // an edge of the left hand is told from its other end
            let turned = format != Format::ExtendedXyz && a.cross(b).dot(c) < 0.0;
            let (corner, third) = if turned { (DVec3::splat(low) + c, -c) } else { (DVec3::splat(low), c) };
            prop_assert!(near(third, z) && near(corner, back.lower), "{:?}", back);
        }
        for format in [Format::LiggghtsData, Format::LiggghtsDump] {
            let back = read_back(&written(&[&table], format, WriteOptions::default()), format).cell.unwrap();
            prop_assert!(!back.is_general() && back.periodic == [false; 3]);
            prop_assert!(losses(&table, format).join("\n").contains("the smallest one around all grains is written"));
        }
        prop_assert!(losses(&table, Format::LammpsData).join("\n").contains("17 April 2024"));
    }

    #[test]
    fn damaged_files_of_every_format_do_no_harm(
        bytes in proptest::collection::vec(any::<u8>(), 1..30), at in 0.0..1.0f64, length in 0..60usize, cut in any::<bool>(),
    ) {
        let table = table(5, 2.0);
        for format in Format::ALL {
            let mut damaged = written(&[&table], format, WriteOptions::default()).into_bytes();
            let at = (at * damaged.len() as f64) as usize;
            if cut {
                damaged.drain(at..(at + length).min(damaged.len()));
            } else {
                for (place, byte) in damaged[at..].iter_mut().zip(&bytes) {
                    *place = byte & 0x7f;
                }
            }
            let Ok(text) = String::from_utf8(damaged) else { continue };
            match parse_as(&text, &ReadOptions { format: Some(format), ..ReadOptions::default() }) {
                Ok(back) => prop_assert_eq!(back.positions.len(), back.diameters.len()),
                Err(error) => prop_assert!(!error.problem.to_string().is_empty()),
            }
            let _ = parse(&text);
        }
    }
}

#[test]
fn several_moments_are_written_and_read_one_by_one() {
    let (first, second) = (table(3, 1.0), table(4, 2.0));
    let folder = tempfile::tempdir().unwrap();
    for format in [Format::LammpsDump, Format::LiggghtsDump, Format::ExtendedXyz] {
        let path = folder.path().join("moments");
        std::fs::write(&path, written(&[&first, &second], format, WriteOptions::default())).unwrap();
        let mut file = GrainFile::open(&path, &ReadOptions::default()).unwrap();
        assert_eq!(file.next_frame().unwrap().unwrap().positions, first.positions);
        let back = file.next_frame().unwrap().unwrap();
        assert_eq!(back.positions, second.positions);
        assert_eq!(back.step, second.step);
        assert_eq!(
            back.time,
            if format == Format::LiggghtsDump {
                None
            } else {
                second.time
            }
        );
        assert_eq!(back.cell, second.cell);
        assert!(file.next_frame().unwrap().is_none());
    }
    let mut writer = GrainWriter::new(Vec::new(), Format::Yade, WriteOptions::default()).unwrap();
    writer.write(&first).unwrap();
    assert!(
        writer
            .write(&second)
            .unwrap_err()
            .to_string()
            .contains("yade holds one moment")
    );
}

#[test]
fn columns_are_chosen_by_name() {
    let table = table(2, 1.0);
    let options = |names: &[&str]| WriteOptions {
        columns: Some(names.iter().map(|n| (*n).to_owned()).collect()),
        ..WriteOptions::default()
    };
    let text = written(
        &[&table],
        Format::Columns,
        options(&["x", "y", "z", "radius", "coordination"]),
    );
    assert!(
        text.starts_with("x [m],y [m],z [m],radius [m],coordination\n"),
        "{text}"
    );
    let text = written(
        &[&table],
        Format::LammpsDump,
        options(&["id", "material", "x", "y", "z", "radius", "wx"]),
    );
    assert!(text.contains("ITEM: ATOMS id type x y z radius omegax\n2 1 "), "{text}");
    let text = written(
        &[&table],
        Format::ExtendedXyz,
        options(&["x", "y", "z", "diameter", "vz"]),
    );
    assert!(text.contains("Properties=pos:R:3:diameter:R:1:vz:R:1 "), "{text}");
    let mut writer = GrainWriter::new(Vec::new(), Format::Columns, options(&["x", "speed"])).unwrap();
    let found = writer.write(&table).unwrap_err().to_string();
    assert!(found.contains("no column `speed`; there are id, x, y, z"), "{found}");
    let mut writer = GrainWriter::new(Vec::new(), Format::Columns, options(&["id", "id", "x"])).unwrap();
    let found = writer.write(&table).unwrap_err().to_string();
    assert!(found.contains("`id` is asked for twice"), "{found}");
    assert!(
        GrainWriter::new(Vec::new(), Format::Yade, options(&["x"]))
            .unwrap_err()
            .to_string()
            .contains("fixed")
    );
}

#[test]
fn losses_are_told() {
    let table = table(2, 1.0);
    let told = |format| losses(&table, format).join("\n");
    assert!(told(Format::Yade).contains("left out, yade does not carry it: ids, velocities, "));
    assert!(told(Format::Yade).contains("names of materials: yade has numbers, 0 = glass, 1 = steel"));
    assert!(told(Format::LammpsData).contains("periodic sides"));
    assert!(told(Format::LammpsData).contains(", coordination"));
    assert!(
        told(Format::LiggghtsDump).contains("does not carry it: time")
            && !told(Format::LammpsDump).contains("carry it: time")
    );
    assert_eq!(told(Format::ExtendedXyz), "");
    assert_eq!(
        told(Format::Columns),
        "left out, csv does not carry it: time, step, box"
    );
    let bare = GrainTable {
        densities: None,
        cell: None,
        ..table.clone()
    };
    assert!(
        losses(&bare, Format::LammpsData)
            .join("\n")
            .contains("the smallest one around all grains")
    );
    let mut writer = GrainWriter::new(Vec::new(), Format::LammpsData, WriteOptions::default()).unwrap();
    assert!(writer.write(&bare).unwrap_err().to_string().contains("needs densities"));
}

#[test]
fn names_of_materials_stay_different_without_blanks() {
    let table = GrainTable {
        type_names: ["a b", "a_b", "a\tb"].map(str::to_owned).to_vec(),
        types: Some((0..3).map(TypeOfGrain::Name).collect()),
        ..table(3, 1.0)
    };
    let text = written(&[&table], Format::ExtendedXyz, WriteOptions::default());
    let back = read_back(&text, Format::ExtendedXyz);
    assert_eq!(back.type_names, ["a_b_2", "a_b", "a_b_3"]);
    assert_eq!(back.types, table.types);
    assert_eq!(
        losses(&table, Format::ExtendedXyz),
        ["names of materials: xyz has no blanks in them, `a b` becomes `a_b_2`, `a\tb` becomes `a_b_3`"]
    );
}

#[test]
fn a_data_file_has_a_type_for_a_material_of_walls_alone() {
    let table = GrainTable {
        types: Some(vec![TypeOfGrain::Name(0); 2]),
        ..table(2, 1.0)
    };
    let text = written(&[&table], Format::LiggghtsData, WriteOptions::default());
    assert!(text.contains("\n2 atom types\n"), "{text}");
}

#[test]
fn types_get_names() {
    let mut table = GrainTable {
        types: Some(vec![
            TypeOfGrain::Number(2),
            TypeOfGrain::Number(1),
            TypeOfGrain::Number(3),
        ]),
        positions: vec![DVec3::ZERO; 3],
        diameters: vec![1.0; 3],
        ..GrainTable::default()
    };
    table.name_types(&["glass".to_owned(), "steel".to_owned()]);
    let types = [TypeOfGrain::Name(1), TypeOfGrain::Name(0), TypeOfGrain::Number(3)];
    assert_eq!(table.types, Some(types.to_vec()));
    assert_eq!(table.type_numbers(), [5, 4, 3]);
}

#[test]
fn data_files_of_other_styles_are_read() {
    let text = "LAMMPS data file via write_data, version 2 Aug 2023, timestep = 40, units = cgs\n\n2 atoms\n1 atom types\n3 bonds\n\n\
        0 10 xlo xhi\n0 10 ylo yhi\n0 10 zlo zhi\n1 0 0 xy xz yz\n\nMasses\n\n1 2.0\n\nPair Coeffs # granular\n\n1 hertz\n\n\
        Atoms # hybrid sphere bond\n\n1 1 1 2 3 0.5 2.5 7 0 0 0\n2 1 4 5 6 0.5 2.5 8 0 0 0\n\n\
        Velocities\n\n1 1 0 0 2 0 0\n2 0 0 0 0 0 0\n\nBonds\n\n1 1 1 2\n";
    let table = parse(text).unwrap();
    assert_eq!(table.positions[0], DVec3::new(0.01, 0.02, 0.03));
    assert_eq!((table.diameters[0], table.step), (0.005, Some(40)));
    assert!((table.densities.unwrap()[0] - 2500.0).abs() < 1e-9);
    assert_eq!(
        (table.extras[0].name.as_str(), table.extras[0].values[1]),
        ("molecule", 8.0)
    );
    assert_eq!(table.angular_velocities.unwrap()[0].x, 2.0);
    assert_eq!(table.cell.unwrap().tilt, [0.01, 0.0, 0.0]);
    let plain = text
        .replace("# hybrid sphere bond", "")
        .replace(" 0.5 2.5 7 0 0 0", "")
        .replace(" 0.5 2.5 8 0 0 0", "");
    let found = parse(&plain).unwrap_err().to_string();
    assert!(
        found.contains("5 values; an atom of atom_style sphere has 7"),
        "{found}"
    );
    let options = ReadOptions {
        style: Some("atomic".to_owned()),
        diameter: Some(1e-3),
        ..ReadOptions::default()
    };
    let found = parse_as(&plain, &options).unwrap_err().to_string();
    assert!(found.contains("7 values where 4 (id vx vy vz) are needed"), "{found}");
}
