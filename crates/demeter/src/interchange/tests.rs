use super::*;
use crate::grain_files::{Format, Which, read_grain_file};
use crate::results::{Run, TableKind};
use std::fs;

const DATA: &str = "LAMMPS data file, units = si\n\n2 atoms\n2 atom types\n\n0 1 xlo xhi\n0 1 ylo yhi\n0 1 zlo zhi\n\n\
    Atoms # sphere\n\n1 1 0.1 2500 0.2 0.3 0.4\n2 2 0.2 7800 0.5 0.6 0.7\n\nVelocities\n\n1 1 2 3 4 5 6\n2 0 0 0 0 0 0\n";

fn how(target: Target) -> Conversion {
    Conversion {
        reading: ReadOptions::default(),
        frames: Frames::Automatic,
        target,
        writing: WriteOptions::default(),
        density: None,
        type_names: Vec::new(),
        overwrite: false,
    }
}

fn dump(moments: usize) -> String {
    let moment = |k: usize| {
        format!(
            "ITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS pp pp pp\n0 1\n0 1\n0 1\n\
             ITEM: ATOMS id type x y z radius\n1 1 0.{k} 0 0 0.05\n",
            100 * k
        )
    };
    (0..moments).map(moment).collect()
}

#[test]
fn a_data_file_becomes_every_other_format_and_comes_back() {
    let place = tempfile::tempdir().unwrap();
    let input = place.path().join("in.data");
    fs::write(&input, DATA).unwrap();
    let first = read_grain_file(&input, &ReadOptions::default(), Which::Last).unwrap();
    for format in Format::ALL {
        let output = place.path().join(format!("out-{format}"));
        let done = convert(&input, &output, &how(Target::Grains(format))).unwrap();
        assert_eq!((done.moments, done.grains, done.from.as_str()), (1, 2, "lammps-data"));
        let back = read_grain_file(&output, &ReadOptions::default(), Which::Last).unwrap();
        assert_eq!(back.positions, first.positions, "{format}");
        assert_eq!(back.diameters, first.diameters, "{format}");
        assert_eq!(
            done.notes.iter().any(|n| n.contains("ids, velocities")),
            format == Format::Yade,
            "{:?}",
            done.notes
        );
    }
    let error = convert(
        &input,
        &place.path().join("out-csv"),
        &how(Target::Grains(Format::Columns)),
    )
    .unwrap_err();
    assert!(error.to_string().contains("is there already"), "{error}");
    let mut same = how(Target::Grains(Format::LammpsData));
    same.overwrite = true;
    assert!(
        convert(&input, &input, &same)
            .unwrap_err()
            .to_string()
            .contains("is input and output")
    );
}

#[test]
fn moments_without_grains_are_moments() {
    let place = tempfile::tempdir().unwrap();
    let at = |name: &str| place.path().join(name);
    let empty =
        |step: u32| format!("ITEM: TIMESTEP\n{step}\nITEM: NUMBER OF ATOMS\n0\nITEM: ATOMS id type x y z radius\n");
    fs::write(at("in.dump"), [empty(0), dump(1), empty(300)].concat()).unwrap();
    let done = convert(
        &at("in.dump"),
        &at("all.xyz"),
        &how(Target::Grains(Format::ExtendedXyz)),
    )
    .unwrap();
    assert_eq!(done.moments, 3);
    let back = convert(
        &at("all.xyz"),
        &at("back.dump"),
        &how(Target::Grains(Format::LammpsDump)),
    )
    .unwrap();
    assert_eq!((back.moments, back.grains), (3, done.grains));
    let counts = (0..3).map(|number| read_grain_file(&at("back.dump"), &ReadOptions::default(), Which::Number(number)));
    let counts: Vec<Result<usize, String>> = counts
        .map(|table| table.map(|table| table.len()).map_err(|error| error.to_string()))
        .collect();
    assert_eq!(counts[1], Ok(done.grains));
    for number in [0, 2] {
        let told = counts[number].as_ref().unwrap_err();
        assert!(told.contains(&format!("no grains in its moment {number}")), "{told}");
    }
}

#[test]
fn moments_are_chosen_and_a_star_makes_a_file_of_each() {
    let place = tempfile::tempdir().unwrap();
    let input = place.path().join("in.dump");
    fs::write(&input, dump(3)).unwrap();
    let at = |name: &str| place.path().join(name);
    let done = convert(&input, &at("all.xyz.gz"), &how(Target::Grains(Format::ExtendedXyz))).unwrap();
    assert_eq!(done.moments, 3);
    let last = read_grain_file(&at("all.xyz.gz"), &ReadOptions::default(), Which::Last).unwrap();
    assert_eq!((last.step, last.positions[0].x), (Some(200), 0.2));
    let done = convert(&input, &at("last.yade"), &how(Target::Grains(Format::Yade))).unwrap();
    assert_eq!(done.moments, 1);
    let mut all = how(Target::Grains(Format::Yade));
    all.frames = Frames::All;
    let error = convert(&input, &at("each.yade"), &all).unwrap_err().to_string();
    assert!(error.contains("as `each-*.yade`"), "{error}");
    assert!(!at("each.yade").exists() && !at("each.yade.part").exists());
    let done = convert(&input, &at("each-*.yade"), &all).unwrap();
    assert_eq!(
        done.files,
        [at("each-0.yade"), at("each-100.yade"), at("each-200.yade")]
    );
    let mut second = how(Target::Vtp);
    second.frames = Frames::Number(1);
    convert(&input, &at("second.vtp"), &second).unwrap();
    assert!(fs::read(at("second.vtp")).unwrap().starts_with(b"<VTKFile"));
    second.frames = Frames::Number(7);
    let error = convert(&input, &at("none.vtp"), &second).unwrap_err().to_string();
    assert!(error.contains("no moment number 7; there are 3"), "{error}");
}

#[test]
fn what_fails_leaves_no_file() {
    let place = tempfile::tempdir().unwrap();
    let input = place.path().join("in.dump");
    fs::write(&input, dump(2) + "ITEM: TIMESTEP\nten\n").unwrap();
    let output = place.path().join("out.xyz");
    let error = convert(&input, &output, &how(Target::Grains(Format::ExtendedXyz)))
        .unwrap_err()
        .to_string();
    assert!(error.contains("line 22: `ten` is not allowed"), "{error}");
    assert_eq!(fs::read_dir(place.path()).unwrap().count(), 1);
    let error = convert(&input, &output, &how(Target::Grains(Format::LammpsData)))
        .unwrap_err()
        .to_string();
    assert!(error.contains("line 22"), "{error}");
    fs::write(&input, dump(1)).unwrap();
    let error = convert(&input, &output, &how(Target::Grains(Format::LammpsData)))
        .unwrap_err()
        .to_string();
    assert!(error.contains("needs densities"), "{error}");
    let mut dense = how(Target::Grains(Format::LammpsData));
    dense.density = Some(2500.0);
    dense.type_names = vec!["glass".to_owned()];
    let done = convert(&input, &output, &dense).unwrap();
    assert!(done.notes.iter().any(|n| n.contains("1 = glass")), "{:?}", done.notes);
}

/// A box that is sheared and stretched: every frame has the box of its moment, and so has what is made of it.
#[test]
fn boxes_of_a_run_that_deform_are_written_and_read() {
    let place = tempfile::tempdir().unwrap();
    let at = |name: &str| place.path().join(name);
    let run = |name: &str, directions: &str| {
        let text = SHEARED.replace("DIRECTIONS", directions);
        let scenario = crate::scenario::Scenario::parse(&text, "sheared", place.path(), &[]).unwrap();
        let options = crate::scenario::RunOptions::default();
        crate::scenario::run(&scenario, &at(name), options, &mut Quiet).unwrap();
    };
    run("run", "flow = \"x\", gradient = \"z\"");
    for format in [Format::LammpsDump, Format::ExtendedXyz] {
        let output = at(&format!("out-{format}"));
        let done = convert(&at("run"), &output, &how(Target::Grains(format))).unwrap();
        assert!(!done.notes.iter().any(|note| note.contains("box")), "{:?}", done.notes);
        let mut tilts = Vec::new();
        for k in 0..done.moments {
            let table = read_grain_file(&output, &ReadOptions::default(), Which::Number(k)).unwrap();
            let (cell, time) = (table.cell.unwrap(), table.time.unwrap());
            let slid = 20.0 * time * 0.01;
            let expected = slid - (slid / 0.01).round() * 0.01;
            // half a box may be told on either side
            let off = (cell.tilt[1] - expected).abs();
            assert!(
                off.min((off - 0.01).abs()) < 1e-6,
                "{k}: {:?}, not {expected}",
                cell.tilt
            );
            assert!(cell.tilt[0] == 0.0 && cell.tilt[2] == 0.0 && cell.periodic == [true; 3]);
            tilts.push(cell.tilt[1]);
        }
        assert!(
            tilts.len() > 5 && tilts.iter().any(|tilt| tilt.abs() > 1e-3),
            "{tilts:?}"
        );
    }
    // a table of a frame that holds no grains is refused, and frames that are gone are told
    let kinds = Run::open(&at("run")).unwrap();
    let step = kinds.moments().unwrap().last().unwrap().step;
    let contacts = kinds.table_path(TableKind::Contacts, step);
    let error = convert(&contacts, &at("contacts.csv"), &how(Target::Grains(Format::Columns))).unwrap_err();
    assert!(error.to_string().contains("holds contacts, no grains"), "{error}");
    // a data file has one moment, with its tilts
    convert(&at("run"), &at("last.data"), &how(Target::Grains(Format::LammpsData))).unwrap();
    let text = fs::read_to_string(at("last.data")).unwrap();
    assert!(text.lines().any(|line| line.ends_with("xy xz yz")), "{text}");
    fs::remove_file(kinds.table_path(TableKind::Grains, step)).unwrap();
    let done = convert(&at("run"), &at("before.data"), &how(Target::Grains(Format::LammpsData))).unwrap();
    let lacks = format!(
        "1 frame is not whole: files are gone or cut short that the run has written, the last of them of step {step}"
    );
    assert!(done.notes.contains(&lacks), "{:?}", done.notes);
    let collection = at("run").join("grains.pvd");
    let kept = fs::read(&collection).unwrap();
    fs::write(&collection, "").unwrap();
    let error = convert(&at("run"), &at("none.csv"), &how(Target::Grains(Format::Columns))).unwrap_err();
    assert!(error.to_string().contains("grains.pvd` does not name"), "{error}");
    fs::write(&collection, kept).unwrap();
    // sheared along z, the first edge leaves the axis x
    run("other", "flow = \"z\", gradient = \"x\"");
    for (format, told) in [
        (Format::ExtendedXyz, "Lattice="),
        (Format::LammpsDump, "BOX BOUNDS abc origin pp pp pp"),
    ] {
        let output = at(&format!("other-{format}"));
        let done = convert(&at("other"), &output, &how(Target::Grains(format))).unwrap();
        let left_out = done.notes.iter().any(|note| note.contains("left out"));
        assert!(
            !left_out && fs::read_to_string(&output).unwrap().contains(told),
            "{:?}",
            done.notes
        );
        let table = read_grain_file(&output, &ReadOptions::default(), Which::Last).unwrap();
        let (edges, slid) = (table.cell.unwrap().edges(), 20.0 * table.time.unwrap() * 0.01);
        let expected = slid - (slid / 0.01).round() * 0.01;
        assert!(
            (edges[0].z - expected).abs() < 1e-6 && edges[0].y == 0.0,
            "{edges:?}, not {expected}"
        );
        assert!(edges[1].x == 0.0 && edges[2].x == 0.0, "{edges:?}");
    }
}

const SHEARED: &str = r#"
[simulation]
max_overlap = 0.3
[domain]
lower = "0 0 0 mm"
upper = "10 10 10 mm"
periodic = ["x", "y", "z"]
deform = { shear = { DIRECTIONS, rate = "20 1/s" } }
[material.m]
young_modulus = "1 MPa"
poisson_ratio = 0.3
density = "2500 kg/m^3"
[contact]
normal = { law = "hertz-tsuji", restitution = 0.5 }
[[grains]]
material = "m"
source = "random"
region = { shape = "box", lower = "1 1 1 mm", upper = "9 9 9 mm" }
diameter = "1.5 mm"
count = 20
[[stage]]
duration = "60 ms"
[output]
frames = "5 ms"
checkpoints = "never"
picture = false
"#;

struct Quiet;

impl crate::scenario::Observer for Quiet {
    fn progress(&mut self, _: &crate::scenario::Progress) -> bool {
        true
    }

    fn message(&mut self, _: &str) {}
}

#[test]
fn what_the_input_tells_itself_is_not_to_be_told_beside_it() {
    type Change = fn(&mut Conversion);
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| {
        let path = folder.path().join(name);
        std::fs::write(&path, text).unwrap();
        path
    };
    let told = write(
        "told.csv",
        "x [m],y [m],z [m],diameter [mm],density [kg/m^3],material\n0,0,0,1,2500,glass\n",
    );
    let bare = write("bare.csv", "x,y,z,diameter [mm],type\n0,0,0,1,1\n1,0,0,1,2\n");
    let convert_of = |input: &Path, change: Change| {
        let mut how = how(Target::Grains(Format::Columns));
        how.overwrite = true;
        change(&mut how);
        convert(input, &folder.path().join("out.csv"), &how)
    };
    let changes: [(&str, Change); 5] = [
        ("units", |how| how.reading.units = "cgs".parse().ok()),
        ("diameter", |how| how.reading.diameter = Some(5e-3)),
        ("atom_style", |how| how.reading.style = Some("sphere".to_owned())),
        ("--density", |how| how.density = Some(1.0)),
        ("--types", |how| how.type_names = vec!["steel".to_owned()]),
    ];
    for (option, change) in changes {
        let error = convert_of(&told, change).unwrap_err().to_string();
        assert!(
            error.contains(&format!("`{option}` is told and has no effect")),
            "{error}"
        );
    }
    assert!(convert_of(&bare, |how| how.reading.units = "cgs".parse().ok()).is_ok());
    let one = convert_of(&bare, |how| how.type_names = vec!["a".to_owned()]).unwrap();
    assert!(
        one.notes
            .iter()
            .any(|note| note.contains("gives names to types 1 to 1, and the input has types 1 to 2")),
        "{:?}",
        one.notes
    );
    let two = convert_of(&bare, |how| how.type_names = vec!["a".to_owned(), "b".to_owned()]).unwrap();
    assert!(
        two.notes.iter().all(|note| !note.contains("--types")),
        "{:?}",
        two.notes
    );
}

#[test]
fn molecules_and_images_go_from_dump_to_dump_and_are_said_elsewhere() {
    let place = tempfile::tempdir().unwrap();
    let input = place.path().join("in.dump");
    let text = dump(1)
        .replace("radius", "radius mol ix iy iz")
        .replace("0.05", "0.05 42 3 -1 0");
    fs::write(&input, text).unwrap();
    let output = place.path().join("out.dump");
    convert(&input, &output, &how(Target::Grains(Format::LammpsDump))).unwrap();
    let written = fs::read_to_string(&output).unwrap();
    assert!(
        written.contains("radius mol ix iy iz\n") && written.contains(" 42 3 -1 0\n"),
        "{written}"
    );
    let data = convert(
        &input,
        &place.path().join("out.yade"),
        &how(Target::Grains(Format::Yade)),
    )
    .unwrap();
    assert!(
        data.notes.iter().any(|note| note.contains("mol, ix, iy, iz")),
        "{:?}",
        data.notes
    );
}

#[test]
fn moments_without_a_step_are_numbered_where_steps_are_wanted() {
    let place = tempfile::tempdir().unwrap();
    let input = place.path().join("in.xyz");
    let moment = "1\nProperties=pos:R:3:radius:R:1\n0 0 0 1\n";
    fs::write(&input, moment.repeat(3)).unwrap();
    let note = |note: &String| note.contains("the numbers of the moments are written, from 0");
    let output = place.path().join("out.dump");
    let done = convert(&input, &output, &how(Target::Grains(Format::LammpsDump))).unwrap();
    assert_eq!(
        done.notes.iter().filter(|told| note(told)).count(),
        1,
        "{:?}",
        done.notes
    );
    let steps = [0, 1, 2].map(|k| {
        let moment = read_grain_file(&output, &ReadOptions::default(), Which::Number(k));
        moment.unwrap().step.unwrap()
    });
    assert_eq!(steps, [0, 1, 2]);
    fs::write(&input, moment).unwrap();
    let done = convert(
        &input,
        &place.path().join("one.dump"),
        &how(Target::Grains(Format::LammpsDump)),
    )
    .unwrap();
    assert!(!done.notes.iter().any(note), "{:?}", done.notes);
}
