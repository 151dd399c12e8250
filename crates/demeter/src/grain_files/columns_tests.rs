use crate::grain_files::read::parse;
use crate::grain_files::read::parse_as;
use crate::grain_files::{ReadOptions, TypeOfGrain};
use glam::DVec3;
use proptest::prelude::*;

fn message(text: &str) -> String {
    match parse(text) {
        Ok(table) => panic!("read as {table:?}"),
        Err(located) => format!("{}: {}", located.location, located.problem),
    }
}

#[test]
fn reads_comma_separated_columns_with_units_in_any_order() {
    let text = "\u{feff}# measured\r\nmaterial, diameter [mm], X (cm), y, z [\u{b5}m], id, density [g/cm^3], vx [mm/s], vy, vz\r\n\
                glass, 2, 1, 0.5, 250, 7, 2.5, 4, 5, 6\r\n\r\n# a comment\n\"steel\",1,2,3,4,3,7.8,0,0,-1e-3\n";
    let table = parse(text).unwrap();
    assert_eq!(table.ids, Some(vec![7, 3]));
    assert_eq!(table.types, Some(vec![TypeOfGrain::Name(0), TypeOfGrain::Name(1)]));
    assert_eq!(table.type_names, ["glass", "steel"]);
    assert_eq!(table.diameters, [2.0 * 1e-3, 1e-3]);
    assert_eq!(table.positions[0], DVec3::new(1e-2, 0.5, 250.0 * 1e-6));
    assert_eq!(table.densities, Some(vec![2500.0, 7800.0]));
    assert_eq!(
        table.velocities,
        Some(vec![DVec3::new(4.0 * 1e-3, 5.0, 6.0), DVec3::new(0.0, 0.0, -1e-3)])
    );
    assert_eq!(table.angular_velocities, None);
}

#[test]
fn a_mass_beside_a_density_must_agree_with_it() {
    // 4.18879 mg at a radius of 1 mm and 1000 kg/m^3
    let table = |mass: &str| format!("x,y,z,radius [mm],mass [mg],density\n0,0,0,1,4.19,1000\n1,0,0,1,{mass},1000\n");
    assert_eq!(parse(&table("4.18")).unwrap().densities, Some(vec![1000.0; 2]));
    let told = message(&table("4190"));
    assert!(
        told.contains("line 3") && told.contains("`mass`") && told.contains("1.00029e6 kg/m^3"),
        "{told}"
    );
}

#[test]
fn reads_blanks_tabs_and_semicolons_and_radii() {
    for text in [
        "x [mm] y [mm]  z [mm] radius [mm] type wx wy wz\n1  2 3\t4 5 6 7 8\n",
        "x [mm]\ty [mm]\tz [mm]\tradius [mm]\ttype\twx\twy\twz\n1\t2\t3\t4\t5\t6\t7\t8",
        "x[mm];y[mm];z[mm];radius[mm];type;wx;wy [1/s];wz [rad/s]\n1;2;3;4;5;6;7;8",
    ] {
        let table = parse(text).unwrap();
        assert_eq!(table.positions, [DVec3::new(1e-3, 2.0 * 1e-3, 3.0 * 1e-3)]);
        assert_eq!(table.diameters, [4.0 * 1e-3 * 2.0]);
        assert_eq!(table.types, Some(vec![TypeOfGrain::Number(5)]));
        assert_eq!(table.angular_velocities, Some(vec![DVec3::new(6.0, 7.0, 8.0)]));
        assert_eq!(table.ids, None);
    }
}

#[test]
fn units_that_are_told_hold_for_titles_that_name_none() {
    let options = ReadOptions {
        units: Some("mm,g,ms".parse().unwrap()),
        ..ReadOptions::default()
    };
    let text = "x,y [m],z,diameter,density,vx,vy,vz [m/s],wx,wy,wz\n1,2,3,4,5,6,7,8,9,10,11\n";
    let table = parse_as(text, &options).unwrap();
    assert_eq!(table.positions, [DVec3::new(1e-3, 2.0, 3.0 * 1e-3)]);
    assert_eq!(table.diameters, [4.0 * 1e-3]);
    let near = |found: f64, expected: f64| (found / expected - 1.0).abs() < 1e-14;
    assert!(near(table.densities.unwrap()[0], 5e6));
    assert_eq!(table.velocities, Some(vec![DVec3::new(6.0, 7.0, 8.0)]));
    assert!(near(table.angular_velocities.unwrap()[0].x, 9e3));
}

#[test]
fn columns_of_the_frames_of_a_run_are_read_over() {
    let table = parse("x,y,z,diameter,coordination,orientation_x\n1,2,3,4,5,7\n").unwrap();
    assert_eq!((table.len(), table.extras.len()), (1, 0));
}

#[test]
fn wrong_tables_are_refused_with_place_and_remedy() {
    for (text, part) in [
        ("", "no grains"),
        ("# only a comment\n", "no grains"),
        ("x y z diameter\n", "no grains"),
        (
            "1 2 3 4\n",
            "line 1: a grain is on every line after the header, but this line starts with `1`",
        ),
        (
            "x y z diametre\n1 2 3 4",
            "`diametre` is not a known column; known are id, x, y, z, diameter, radius",
        ),
        ("x y diameter\n1 2 3", "column `z` is missing"),
        ("x y z\n1 2 3", "column `diameter` is missing"),
        ("x y z diameter vx vz\n", "column `vy` is missing"),
        ("x y z diameter tag tag\n", "`tag` is told twice"),
        (
            "x y z diameter tag\n1 2 3 4 7\n1 2 3 4 1.5\n",
            "line 3, column `tag`: `1.5` is not allowed; tags are whole numbers from -2147483648",
        ),
        (
            "x y z diameter tag\n1 2 3 4 1e30\n",
            "column `tag`: `1e30` is not allowed",
        ),
        ("x y z x diameter\n", "`x` is told twice"),
        ("x y z radius diameter\n", "`diameter` is told twice (also as `radius`)"),
        (
            "x y z type material diameter\n",
            "`material` is told twice (also as `type`)",
        ),
        (
            "x [inch] y z diameter\n",
            "unit `inch` is not known here; allowed: m, cm, mm, um",
        ),
        ("id [mm] x y z diameter\n", "allowed: none for `id`"),
        ("vx [mm]\n", "allowed: m/s, cm/s, mm/s"),
        (
            "# c\nx y z diameter\n1 2 3 4\n1 2 3\n",
            "line 4: 3 values where 4 are needed",
        ),
        ("x,y,z,diameter\n1,2,,4\n", "line 2, column `z`: `` is not a number"),
        (
            "x y z diameter\n1 2 3 4\n1 b 3 4\n",
            "line 3, column `y`: `b` is not a number",
        ),
        (
            "x y z diameter\nNaN 2 3 4\n",
            "line 2, column `x`: `NaN` is not allowed",
        ),
        ("x y z diameter\n1 1e999 3 4\n", "column `y`: `1e999` is not allowed"),
        ("x y z diameter\n1 1e13 3 4\n", "magnitude up to 1e12"),
        (
            "x y z diameter\n1 2 3 -4\n",
            "column `diameter`: `-4` is not allowed; allowed are diameters from 1e-12 m",
        ),
        (
            "x y z diameter density\n1 2 3 4 0\n",
            "column `density`: `0` is not allowed",
        ),
        (
            "id x y z diameter\n0 1 2 3 4\n",
            "column `id`: `0` is not allowed; allowed are whole numbers from 1 to 4294967295",
        ),
        ("id x y z diameter\n4294967296 1 2 3 4\n", "column `id`: `4294967296`"),
        ("id x y z diameter\n1.5 1 2 3 4\n", "column `id`: `1.5`"),
        (
            "id x y z diameter\n5 1 2 3 4\n6 1 2 3 4\n5 2 2 3 4\n",
            "line 4: id 5 is there twice",
        ),
        ("type x y z diameter\n-1 1 2 3 4\n", "column `type`: `-1`"),
    ] {
        let found = message(text);
        assert!(found.contains(part), "{text:?}: {found}");
    }
}

fn hostile_text() -> impl Strategy<Value = String> {
    let word = prop_oneof![
        Just("x"),
        Just("y"),
        Just("z"),
        Just("diameter"),
        Just("id"),
        Just("vx"),
        Just("type"),
        Just("[mm]"),
        Just("["),
        Just(","),
        Just(";"),
        Just("\t"),
        Just("\n"),
        Just(" "),
        Just("#"),
        Just("\""),
        Just("1"),
        Just("-1"),
        Just("1e400"),
        Just("nan"),
        Just("atoms"),
        Just("2 atoms\n"),
        Just("Atoms"),
        Just("Atoms # sphere\n"),
        Just("Velocities\n"),
        Just("0 1 xlo xhi\n"),
        Just("1 1 0.1 1 0 0 0\n"),
        Just("2 1 0.1 1 0 0 0 0 0 0\n"),
        Just("\u{b5}"),
        Just("\u{feff}"),
        Just("x y z diameter\n"),
        Just("1 2 3 4\n"),
        Just("title\n"),
        Just("4294967296"),
    ];
    proptest::collection::vec(word, 0..60).prop_map(|words| words.concat())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn no_text_makes_the_readers_panic(text in hostile_text(), other in any::<String>()) {
        for text in [&text, &other] {
            let _ = parse(text);
            for format in crate::grain_files::Format::ALL {
                let options = ReadOptions { format: Some(format), ..ReadOptions::default() };
                let _ = parse_as(text, &options);
            }
            if let Ok(table) = parse(text) {
                prop_assert!(table.positions.len() == table.diameters.len() && !table.positions.is_empty());
                prop_assert!(table.types.is_none_or(|t| t.len() == table.positions.len()));
                prop_assert!(table.ids.is_none_or(|i| i.len() == table.positions.len()));
            }
        }
    }

    #[test]
    fn written_tables_are_read_back_to_the_bit(
        rows in proptest::collection::vec((-1e3..1e3f64, -1e-3..1e-3f64, any::<i16>(), 1e-6..1.0f64), 1..20)
    ) {
        let mut text = "x y z diameter\n".to_owned();
        for (x, y, z, d) in &rows {
            text += &format!("{x:e} {y} {z} {d}\n");
        }
        let table = parse(&text).unwrap();
        for (k, (x, y, z, d)) in rows.iter().enumerate() {
            prop_assert_eq!(table.positions[k], DVec3::new(*x, *y, f64::from(*z)));
            prop_assert_eq!(table.diameters[k], *d);
        }
    }
}
