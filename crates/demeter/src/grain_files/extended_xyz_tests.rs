use crate::grain_files::read::{parse, parse_as};
use crate::grain_files::{ReadOptions, TypeOfGrain};
use glam::DVec3;

#[test]
fn properties_box_and_time_are_read_as_ovito_writes_them() {
    let text = "2\nLattice=\"10 0 0 0 20 0 1 0 30\" Origin=\"-1 -2 -3\" pbc=\"T F T\" flag \
        Properties=species:S:1:pos:R:3:Velocity:R:3:radius:R:1:id:I:1:orientation:R:4:note:S:1:c:R:2 Time=0.25 Timestep=7\n\
        glass 1 2 3 4 5 6 0.5 9 0 0 0 1 hello 7 8\nsteel 0 0 0 0 0 0 1 8 0 0 0 1 you 9 10\n";
    let table = parse(text).unwrap();
    assert_eq!(table.types, Some(vec![TypeOfGrain::Name(0), TypeOfGrain::Name(1)]));
    assert_eq!(table.positions[0], DVec3::new(1.0, 2.0, 3.0));
    assert_eq!(table.velocities.as_ref().unwrap()[0], DVec3::new(4.0, 5.0, 6.0));
    assert_eq!((table.diameters[1], table.ids.as_ref().unwrap()[0]), (2.0, 9));
    let names: Vec<&str> = table.extras.iter().map(|extra| extra.name.as_str()).collect();
    assert_eq!(
        names,
        [
            "orientation_x",
            "orientation_y",
            "orientation_z",
            "orientation_w",
            "c_1",
            "c_2"
        ]
    );
    let cell = table.cell.unwrap();
    assert_eq!(
        (cell.lower, cell.upper),
        (DVec3::new(-1.0, -2.0, -3.0), DVec3::new(9.0, 18.0, 27.0))
    );
    assert_eq!((cell.tilt, cell.periodic), ([0.0, 1.0, 0.0], [true, false, true]));
    assert_eq!((table.time, table.step), (Some(0.25), Some(7)));
}

#[test]
fn plain_files_need_a_size() {
    let text = "1\nany words\nH 1 2 3\n";
    assert!(parse(text).unwrap_err().to_string().contains("tells no sizes"));
    let options = ReadOptions {
        diameter: Some(1e-3),
        ..ReadOptions::default()
    };
    assert_eq!(parse_as(text, &options).unwrap().diameters, [1e-3]);
}

#[test]
fn wrong_files_are_refused_with_place_and_remedy() {
    for (text, part) in [
        (
            "2\nProperties=pos:R:3:radius:R:1\n0 0 0 1\n",
            "line 2: 1 rows where 2 are told",
        ),
        (
            "1\nProperties=pos:R:3:radius:R:1\n0 0 0\n",
            "line 3: 3 values where 4 are needed",
        ),
        (
            "1\nProperties=pos:R:3:radius:R:1\n0 x 0 1\n",
            "line 3, column `pos_2`: `x` is not a number",
        ),
        (
            "1\nProperties=pos:R:3:radius\n0 0 0 1\n",
            "line 2: `pos:R:3:radius` stands where Properties=NAME:KIND:COUNT",
        ),
        ("1\nProperties=pos:Q:3\n0 0 0\n", "stands where Properties"),
        ("1\nProperties=pos:R:99999999999\n0 0 0\n", "stands where Properties"),
        ("1\nProperties=radius:R:1\n1\n", "column `pos` is missing"),
        (
            "1\nProperties=pos:R:3:pos:R:3:radius:R:1\n0 0 0 1 1 1 1\n",
            "line 2: `pos_1` is told twice",
        ),
        (
            "1\nProperties=pos:R:3:radius:R:1:radius:R:1\n0 0 0 1 2\n",
            "line 2: `radius` is told twice",
        ),
        (
            "1\nProperties=pos:R:3:radius:R:1:diameter:R:1\n0 0 0 1 2\n",
            "line 2: `diameter` is told twice (also as `radius`)",
        ),
        (
            "1\nLattice=\"1 2\" Properties=pos:R:3:radius:R:1\n0 0 0 1\n",
            "line 2: `1 2` stands where Lattice",
        ),
        (
            "1\nProperties=pos:R:3:radius:R:1 Time=soon\n0 0 0 1\n",
            "line 2: `soon` is not a number",
        ),
    ] {
        match parse(text) {
            Ok(table) => panic!("{text} is read as {table:?}"),
            Err(found) => assert!(found.to_string().contains(part), "expected {part}, found {found}"),
        }
    }
}
