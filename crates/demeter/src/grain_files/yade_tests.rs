use crate::grain_files::TypeOfGrain;
use crate::grain_files::read::parse;
use glam::DVec3;

#[test]
fn the_formats_of_yade_are_read() {
    let table = parse("#format x_y_z_r\n# comment\n1\t2\t3\t0.5\n\n4\t5\t6\t0.25\n").unwrap();
    assert_eq!(table.positions, [DVec3::new(1.0, 2.0, 3.0), DVec3::new(4.0, 5.0, 6.0)]);
    assert_eq!(
        (table.diameters.as_slice(), table.types, table.ids),
        (&[1.0, 0.5][..], None, None)
    );
    let table = parse("#format id_x_y_z_r_matId\n0 1 2 3 0.5 1\n7 1 2 9 0.5 0\n").unwrap();
    assert_eq!(table.ids, Some(vec![1, 8]));
    assert_eq!(table.types, Some(vec![TypeOfGrain::Number(2), TypeOfGrain::Number(1)]));
    let table = parse("#format x_y_z_r_attrs\n# x y z r speed twist\n1 2 3 0.5 7 8\n").unwrap();
    assert_eq!(
        (table.extras[1].name.as_str(), table.extras[1].values[0]),
        ("twist", 8.0)
    );
    let table = parse("#format x_y_z_r_attrs\n1 2 3 0.5 7 8\n").unwrap();
    assert_eq!(table.extras[0].name, "attribute_1");
}

#[test]
fn wrong_packings_are_refused_with_place() {
    for (text, part) in [
        (
            "#format jointedPM\n1 2 3 4\n",
            "line 1: the format `jointedPM` of YADE is not read; write `x_y_z_r`",
        ),
        ("#format x_y_z_r\n1 2 3\n", "line 2: 3 values where 4 are needed"),
        ("#format x_y_z_r\n1 2 3 -4\n", "line 2, column `r`: `-4` is not allowed"),
        (
            "#format x_y_z_r_matId\n1 2 3 4 -1\n",
            "line 2, column `matId`: `-1` is not allowed",
        ),
        ("#format x_y_z_r\n", "there are no grains in it"),
    ] {
        match parse(text) {
            Ok(table) => panic!("{text} is read as {table:?}"),
            Err(found) => assert!(found.to_string().contains(part), "expected {part}, found {found}"),
        }
    }
}
