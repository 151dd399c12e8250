//! Mesh files of every format, as they come: good ones are read, bad ones are refused with file and reason, and nothing
//! that is read makes the repair or the inspection fail.

use demeter::walls::{Mesh, MeshFileContent, MeshFileError, MeshFormat, read_mesh};
use glam::DVec3;
use rand_pcg::Pcg64;
use rand_pcg::rand_core::Rng;
use std::fs;

const VERTICES: [[f32; 3]; 5] = [
    [0.0, 0.0, 0.0],
    [1.0, 0.0, 0.0],
    [1.0, 1.0, 0.0],
    [0.0, 1.0, 0.0],
    [0.5, 0.5, 1.5],
];
/// A pyramid on a square.
const FACES: [&[u32]; 5] = [&[0, 3, 2, 1], &[0, 1, 4], &[1, 2, 4], &[2, 3, 4], &[3, 0, 4]];

fn read(name: &str, bytes: &[u8]) -> Result<MeshFileContent, MeshFileError> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(name);
    fs::write(&path, bytes).unwrap();
    read_mesh(&path, None, DVec3::ZERO)
}

fn obj() -> String {
    let mut text = "# a pyramid\nmtllib none.mtl\no pyramid\n".to_string();
    for [x, y, z] in VERTICES {
        text.push_str(&format!("v {x} {y} {z}\n"));
    }
    text.push_str("vn 0 0 1\ns off\n");
    for face in FACES {
        let corners: Vec<String> = face.iter().map(|k| format!("{}//1", k + 1)).collect();
        text.push_str(&format!("f {}\n", corners.join(" ")));
    }
    text
}

fn ply_header(format: &str) -> String {
    format!(
        "ply\nformat {format} 1.0\ncomment a pyramid\nelement vertex 5\nproperty float x\nproperty float y\n\
         property float z\nproperty uchar red\nelement face 5\nproperty list uchar int vertex_indices\nend_header\n"
    )
}

fn ply_text() -> String {
    let mut text = ply_header("ascii");
    for [x, y, z] in VERTICES {
        text.push_str(&format!("{x} {y} {z} 255\n"));
    }
    for face in FACES {
        let corners: Vec<String> = face.iter().map(u32::to_string).collect();
        text.push_str(&format!("{} {}\n", face.len(), corners.join(" ")));
    }
    text
}

fn ply_binary(big: bool) -> Vec<u8> {
    let format = if big {
        "binary_big_endian"
    } else {
        "binary_little_endian"
    };
    let mut bytes = ply_header(format).into_bytes();
    let mut push = |mut low_first: Vec<u8>| {
        if big {
            low_first.reverse();
        }
        bytes.extend(low_first);
    };
    for vertex in VERTICES {
        vertex.iter().for_each(|value| push(value.to_le_bytes().to_vec()));
        push(vec![255]);
    }
    for face in FACES {
        push(vec![face.len() as u8]);
        face.iter().for_each(|index| push(index.to_le_bytes().to_vec()));
    }
    bytes
}

/// The six triangles of the pyramid, the square cut as a fan.
fn pyramid() -> Vec<[DVec3; 3]> {
    let at = |k: u32| DVec3::from_array(VERTICES[k as usize].map(f64::from));
    let fan = |face: &&[u32]| -> Vec<[DVec3; 3]> {
        let pairs = face.windows(2).skip(1);
        pairs.map(|pair| [at(face[0]), at(pair[0]), at(pair[1])]).collect()
    };
    FACES.iter().flat_map(fan).collect()
}

fn list(header: &str) -> String {
    let mut text = header.to_string();
    for triangle in pyramid() {
        let numbers: Vec<String> = triangle
            .iter()
            .flat_map(|c| c.to_array())
            .map(|x| x.to_string())
            .collect();
        text.push_str(&format!("{}\n", numbers.join("\t")));
    }
    text
}

fn stl_text() -> String {
    let mut text = "solid pyramid\n".to_string();
    for triangle in pyramid() {
        text.push_str("facet normal 0 0 0\nouter loop\n");
        triangle
            .iter()
            .for_each(|c| text.push_str(&format!("vertex {} {} {}\n", c.x, c.y, c.z)));
        text.push_str("endloop\nendfacet\n");
    }
    text + "endsolid\n"
}

fn stl_binary() -> Vec<u8> {
    let mut bytes = vec![b' '; 80];
    bytes.extend((pyramid().len() as u32).to_le_bytes());
    for triangle in pyramid() {
        bytes.extend([0; 12]);
        for value in triangle.iter().flat_map(|corner| corner.to_array()) {
            bytes.extend((value as f32).to_le_bytes());
        }
        bytes.extend([0; 2]);
    }
    bytes
}

#[test]
fn strips_of_triangles_are_read() {
    let header = "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty float z\n\
                  element tristrips 1\nproperty list int int vertex_indices\nend_header\n";
    let vertices = [[0, 0], [1, 0], [0, 1], [1, 1], [0, 2], [1, 2]];
    let lines: String = vertices.iter().map(|[x, y]| format!("{x} {y} 0\n")).collect();
    let place = tempfile::tempdir().unwrap();
    let path = place.path().join("strips.ply");
    let read = |strips: &str| {
        std::fs::write(&path, format!("{header}{lines}{strips}\n")).unwrap();
        read_mesh(&path, None, DVec3::ZERO).map(|content| content.triangles)
    };
    let whole = read("6 0 1 2 3 4 5").unwrap();
    assert_eq!(whole.len(), 4);
    for [a, b, c] in &whole {
        // all turn the same way, and each is half of a square
        assert_eq!((*b - *a).cross(*c - *a), DVec3::Z);
    }
    // two strips in one list, and two that are joined by triangles without area
    let [first, second] = [read("4 0 1 2 3").unwrap(), read("4 2 3 4 5").unwrap()];
    let both = [first, second].concat();
    assert_eq!(both, whole);
    assert_eq!(read("9 0 1 2 3 -1 2 3 4 5").unwrap(), whole);
    assert_eq!(read("10 0 1 2 3 3 2 2 3 4 5").unwrap(), whole);
    let wrong = read("4 0 1 2 6").unwrap_err().to_string();
    assert!(wrong.contains("names vertex 6"), "{wrong}");
    let wrong = read("4 0 1 2 -2").unwrap_err().to_string();
    assert!(wrong.contains("names vertex -2"), "{wrong}");
}

/// A good file of every format.
fn good() -> Vec<(&'static str, Vec<u8>, MeshFormat)> {
    vec![
        ("a.stl", stl_text().into_bytes(), MeshFormat::StlAscii),
        ("b.stl", stl_binary(), MeshFormat::StlBinary),
        ("a.obj", obj().into_bytes(), MeshFormat::Obj),
        ("a.ply", ply_text().into_bytes(), MeshFormat::PlyAscii),
        ("b.ply", ply_binary(false), MeshFormat::PlyLittleEndian),
        ("c.ply", ply_binary(true), MeshFormat::PlyBigEndian),
        (
            "a.txt",
            list("x1[m] y1[m] z1[m] x2[m] y2[m] z2[m] x3[m] y3[m] z3[m]\n").into_bytes(),
            MeshFormat::TriangleList,
        ),
    ]
}

#[test]
fn every_format_gives_the_same_triangles_whatever_its_name() {
    for (name, bytes, format) in good() {
        for name in [name, "no-extension", "wrong.dat", "wrong.stl"] {
            let content = read(name, &bytes).unwrap();
            assert_eq!((content.format, &content.triangles), (format, &pyramid()), "{name}");
        }
        if ![
            MeshFormat::StlBinary,
            MeshFormat::PlyLittleEndian,
            MeshFormat::PlyBigEndian,
        ]
        .contains(&format)
        {
            let text = String::from_utf8(bytes).unwrap();
            for ends in ["\r\n", "\r"] {
                assert_eq!(
                    read(name, text.replace('\n', ends).as_bytes()).unwrap().triangles,
                    pyramid(),
                    "{name}"
                );
            }
            // every other line with another end, and a mark of UTF-8 at the start
            let mixed: String = text
                .lines()
                .enumerate()
                .map(|(k, l)| l.to_string() + ["\n", "\r\n"][k % 2])
                .collect();
            assert_eq!(read(name, mixed.as_bytes()).unwrap().triangles, pyramid(), "{name}");
            if format == MeshFormat::StlAscii {
                // white space is free in this format
                for blank in [" ", "\t "] {
                    let one_line = text.replace('\n', blank);
                    assert_eq!(read(name, one_line.as_bytes()).unwrap().triangles, pyramid(), "{name}");
                }
            }
            let marked = [b"\xef\xbb\xbf", text.as_bytes()].concat();
            assert_eq!(read(name, &marked).unwrap().triangles, pyramid(), "{name}");
        }
    }
}

#[test]
fn the_unit_that_a_list_names_holds_unless_the_scenario_tells_one() {
    let text = list("a[mm] b[mm] c[mm]\n");
    let content = read("walls.txt", text.as_bytes()).unwrap();
    assert_eq!(content.told_unit, Some(("mm", 1e-3)));
    assert_eq!(
        content.triangles[1][2],
        DVec3::from_array(VERTICES[1].map(f64::from)) * 1e-3
    );
    for header in [
        "x1 [in],y1 [in],z1 [in]",
        "x1 [in] y1 (in) z1 [in]",
        "# x1 [in]; y1 [ in ]",
        "\"x1 [in]\",y1 [in],",
    ] {
        let content = read("walls.txt", list(&format!("{header}\n")).as_bytes()).unwrap();
        assert_eq!(content.told_unit, Some(("in", 0.0254)), "{header}");
    }
    for (header, part) in [
        (
            "x1[furlong] y1[furlong]",
            "walls.txt:1: unit `furlong` is not known here; allowed: m, cm, mm",
        ),
        ("x1[kg],y1[kg]", "unit `kg` is not known"),
        ("a[mm] b[m]", "name `mm` for some columns and `m` for others"),
        ("a [mm],b,c", "name `mm` for some columns and no unit for others"),
        ("a,b (mm),c", "name no unit for some columns and `mm` for others"),
    ] {
        let found = read("walls.txt", list(&format!("{header}\n")).as_bytes())
            .unwrap_err()
            .to_string();
        assert!(found.contains(part), "expected {part}, found {found}");
    }
    assert_eq!(read("walls.txt", list("").as_bytes()).unwrap().triangles, pyramid());
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("walls.txt");
    fs::write(&path, text).unwrap();
    let told = read_mesh(&path, Some(1.0), DVec3::X).unwrap();
    assert_eq!(told.triangles[0][0], DVec3::X);
}

#[test]
fn obj_counts_back_from_the_end_joins_lines_and_cuts_concave_faces() {
    let back = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\n";
    assert_eq!(read("a.obj", back.as_bytes()).unwrap().triangles[0][1], DVec3::X);
    let joined = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 \\\n 3\n";
    assert_eq!(read("a.obj", joined.as_bytes()).unwrap().triangles.len(), 1);
    let later = "f 1 2 3\nv 0 0 0\nv 1 0 0 0.5\nv 0 1 0 1 0 0\n";
    assert_eq!(read("a.obj", later.as_bytes()).unwrap().triangles.len(), 1);
    let arrow = "v 0 0 0\nv 2 1 0\nv 0 2 0\nv 0.5 1 0\nf 1 2 3 4\n";
    let content = read("a.obj", arrow.as_bytes()).unwrap();
    let area: f64 = content
        .triangles
        .iter()
        .map(|[a, b, c]| 0.5 * (*b - *a).cross(*c - *a).length())
        .sum();
    assert_eq!((content.triangles.len(), content.polygons, content.twisted), (2, 1, 0));
    assert!((area - 1.5).abs() < 1e-12);
}

/// A change to a good text: what is replaced, by what, and a piece of the message that must come.
type Change = (&'static str, &'static str, &'static str);

#[test]
fn comments_are_passed_over() {
    let stl = format!(
        "# by hand\n\n{}",
        stl_text().replace("outer loop\n", "outer loop\n # of three\n")
    );
    let obj = obj()
        .replace("//1\n", "//1 # a face\n")
        .replace(" 1.5\n", " 1.5 # the top\n");
    for (name, text) in [("a.stl", stl), ("a.obj", obj)] {
        assert!(text.matches('#').count() > 5, "{text}");
        assert_eq!(read(name, text.as_bytes()).unwrap().triangles, pyramid(), "{name}");
    }
}

#[test]
fn what_is_no_mesh_is_told_by_its_kind() {
    let wide: Vec<u8> = ("\u{feff}".to_string() + &stl_text())
        .encode_utf16()
        .flat_map(u16::to_le_bytes)
        .collect();
    let mut gzip = b"\x1f\x8b\x08".to_vec();
    gzip.resize(400, 7);
    for (bytes, what) in [
        (wide, "text in UTF-16, which is not read; save it as plain text"),
        (gzip, "compressed by gzip, which is not read; unpack it"),
        (b"PK\x03\x04 and more".to_vec(), "a ZIP archive"),
        (b"\xef\xbb\xbf<!DOCTYPE html><html>".to_vec(), "a page of the web"),
        (b"ISO-10303-21;\nHEADER;".to_vec(), "a STEP file"),
        (b"version https://git-lfs.github.com/spec/v1\n".to_vec(), "git lfs pull"),
    ] {
        for name in ["a.stl", "a.obj", "a.ply", "a.txt", "none"] {
            let told = read(name, &bytes).unwrap_err().to_string();
            assert!(told.contains(name) && told.contains(what), "{told}");
        }
    }
    // text that no format fits is not taken for a damaged binary file
    let told = read("a.stl", "a mesh, some day\n".repeat(20).as_bytes())
        .unwrap_err()
        .to_string();
    assert!(told.contains("in none of the formats"), "{told}");
}

const OBJ_CHANGES: [Change; 16] = [
    ("f 1//1", "f 9//1", "names vertex 9;"),
    ("f 1//1", "f 0//1", "names vertex 0"),
    ("f 1//1", "f -9//1", "names vertex -9"),
    ("f 1//1", "f x//1", "counted from 1"),
    ("f 1//1", "f 99999999999999999999", "counted from 1"),
    ("f 1//1", "f 9223372036854775807", "names vertex"),
    ("f 1//1 2//1 5//1", "f 1 2", "has 2 corners"),
    ("f 1//1 2//1 5//1", "f", "has 0 corners"),
    ("v 0.5 0.5 1.5", "v 0.5 0.5", "three numbers"),
    ("v 0.5 0.5 1.5", "v 0.5 0.5 one", "three numbers"),
    ("v 0.5 0.5 1.5", "v 0.5 0.5 nan", "must be finite"),
    ("v 0.5 0.5 1.5", "v 0.5 0.5 1e999", "must be finite"),
    ("v 0.5 0.5 1.5", "v", "three numbers"),
    ("s off", "hello world", "a line of an OBJ file"),
    ("s off", "curv 0 1 1 2", "free-form"),
    ("s off", "\u{0}\u{1}\u{2}", "a line of an OBJ file"),
];

const PLY_CHANGES: [Change; 27] = [
    ("format ascii 1.0\n", "", "before a line `format"),
    ("format ascii", "format morse", "`format` ascii"),
    ("element vertex 5", "element vertex 4000000000", "4000000000 entries"),
    (
        "element vertex 5",
        "element vertex 18446744073709551615",
        "18446744073709551615 entries",
    ),
    ("element vertex 5", "element vertex -5", "a whole number"),
    ("element vertex 5", "element vertex many", "a whole number"),
    ("element vertex 5", "element vertex 6", ""),
    ("element vertex 5", "element vertex 4", ""),
    ("element vertex 5", "element vertex 0", ""),
    ("element face 5", "element face 6", "before all"),
    ("element face 5", "element face 4", "follow after"),
    ("element face 5", "element face 0", "follow after"),
    ("element face 5", "element face 4294967296", "entries"),
    (
        "element vertex 5",
        "element nothing 99999999\nelement vertex 5",
        "entries",
    ),
    (
        "property float x",
        "property float w",
        "has the properties `w`, `y`, `z`, `red`, and needs `x`, `y` and `z`",
    ),
    ("property float x", "property long x", "a type and a name"),
    ("property float x", "property list float int x", "a type and a name"),
    (
        "property list uchar int vertex_indices",
        "property list uchar int corners",
        "vertex_indices",
    ),
    ("element vertex 5\n", "", "an `element` before"),
    ("end_header\n", "", "a line of a PLY header"),
    ("4 0 3 2 1", "4 0 3 2 7", "names vertex 7"),
    ("4 0 3 2 1", "4 0 3 2 -1", "names vertex -1; the file has 5 vertices"),
    ("4 0 3 2 1", "4 0 3 2 0.5", "names vertex 0.5"),
    ("4 0 3 2 1", "4000000 0 3 2 1", "before all"),
    ("4 0 3 2 1", "-4 0 3 2 1", "would have -4 entries"),
    ("4 0 3 2 1", "4 0 3 2 one", "`one` is none"),
    ("0.5 0.5 1.5 255", "0.5 0.5 nan 255", "must be finite"),
];

const LIST_CHANGES: [Change; 8] = [
    ("1.5\n", "\n", "nine numbers"),
    ("1.5\n", "1.5 1.5\n", "nine numbers"),
    ("1.5\n", "one\n", "nine numbers"),
    ("1.5\n", "nan\n", "must be finite"),
    ("1.5\n", "1e400\n", "must be finite"),
    ("1.5\n", "1.5\nthe end\n", "nine numbers"),
    ("1.5\n", "1,5\n", "nine numbers"),
    ("1.5\n", "1.5\u{0}\n", "nine numbers"),
];

const STL_CHANGES: [Change; 9] = [
    ("vertex 0.5 0.5 1.5", "vertex 0.5 0.5", "three numbers"),
    ("vertex 0.5 0.5 1.5", "vertex 0.5 0.5 inf", "must be finite"),
    ("vertex 0.5 0.5 1.5", "vertex 0.5 0.5 1e30", "(0.5, 0.5, 1e30) m"),
    ("vertex 0.5 0.5 1.5", "vertex 0.5 0,5 1.5", "three numbers"),
    ("vertex 0.5 0.5 1.5\n", "", "expected vertex"),
    ("endloop\n", "", "expected endloop"),
    ("facet normal 0 0 0", "face", "`facet normal`"),
    ("endsolid", "", "before endsolid"),
    ("endsolid", "endsolid\nendsolid", "expected `solid`"),
];

fn bad() -> Vec<(String, &'static str, Vec<u8>, &'static str)> {
    let mut cases = Vec::new();
    let texts = [
        ("a.obj", obj(), &OBJ_CHANGES[..]),
        ("a.ply", ply_text(), &PLY_CHANGES),
        ("a.txt", list("nine columns\n"), &LIST_CHANGES),
        ("a.stl", stl_text(), &STL_CHANGES),
    ];
    for (name, text, changes) in texts {
        for (from, to, message) in changes {
            assert!(text.contains(from), "{name}: {from}");
            cases.push((
                format!("{name}: `{from}` -> `{to}`"),
                name,
                text.replacen(from, to, 1).into_bytes(),
                *message,
            ));
        }
    }
    let mut add = |name: &'static str, what: &str, bytes: Vec<u8>, message| {
        cases.push((format!("{name}: {what}"), name, bytes, message));
    };
    for name in ["a.stl", "a.obj", "a.ply", "a.txt", "a.step", "none"] {
        add(name, "empty", vec![], "");
        add(name, "blank", b" \n\t\r\n \n".to_vec(), "");
        add(name, "zeros", vec![0; 100_000], "");
        add(
            name,
            "another language",
            "Wände ohne Ende\nund mehr\n".repeat(50).into_bytes(),
            "",
        );
        add(
            name,
            "a picture",
            [b"\x89PNG\r\n\x1a\n".to_vec(), vec![0x7f; 3000]].concat(),
            "",
        );
        add(
            name,
            "UTF-16",
            "solid x".encode_utf16().flat_map(u16::to_le_bytes).collect(),
            "",
        );
    }
    add(
        "a.obj",
        "vertices only",
        b"v 0 0 0\nv 1 0 0\nv 0 1 0\n".to_vec(),
        "no triangle",
    );
    add("a.txt", "header only", b"x y z\n".to_vec(), "");
    add(
        "a.ply",
        "no elements",
        b"ply\nformat ascii 1.0\nend_header\n".to_vec(),
        "no triangle",
    );
    for big in [false, true] {
        let bytes = ply_binary(big);
        let header = bytes.windows(11).position(|w| w == b"end_header\n").unwrap() + 11;
        add(
            "b.ply",
            "cut in the vertices",
            bytes[..header + 30].to_vec(),
            "entries of `vertex`",
        );
        add(
            "b.ply",
            "cut in the faces",
            bytes[..bytes.len() - 3].to_vec(),
            "before all",
        );
        add(
            "b.ply",
            "too long",
            [bytes.clone(), vec![7; 20]].concat(),
            "20 bytes follow",
        );
        let mut wrong = bytes.clone();
        let last = wrong.len() - 4;
        wrong[last..].copy_from_slice(&[0x7f; 4]);
        add("b.ply", "an index out of range", wrong, "names vertex 2139062143");
        let mut endless = bytes.clone();
        endless[header + 5 * 13] = 255;
        add("b.ply", "a face of 255 corners", endless, "before all");
        let mut nan = bytes.clone();
        nan[header..header + 4].copy_from_slice(&[0xff; 4]);
        add("b.ply", "not a number", nan, "must be finite");
    }
    cases
}

#[test]
fn a_hundred_bad_files_are_refused_with_the_reason_and_the_path() {
    let cases = bad();
    assert!(cases.len() >= 100, "{}", cases.len());
    for (what, name, bytes, message) in cases {
        let error = match read(name, &bytes) {
            Ok(content) => panic!("{what}: gave {} triangles", content.triangles.len()),
            Err(error) => error.to_string(),
        };
        assert!(
            error.contains(name) && error.contains(message),
            "{what}: `{error}` lacks `{message}`"
        );
        assert!(error.len() < 700, "{what}: {error}");
    }
}

/// What is read can be repaired, or tells why not; what is repaired can be a wall and be inspected.
fn use_it(triangles: &[[DVec3; 3]]) {
    if let Ok((repaired, _)) = Mesh::repair(triangles, None) {
        let mesh = Mesh::new(&repaired).unwrap();
        let found = mesh.inspect();
        assert!(found.crossings.looked_at <= repaired.len());
        mesh.distance(DVec3::ONE, f64::INFINITY);
    }
}

#[test]
fn damaged_files_never_panic() {
    let mut dice = Pcg64::new(5, 0);
    for (name, bytes, _) in good() {
        for _ in 0..400 {
            let mut damaged = bytes.clone();
            for _ in 0..1 + dice.next_u64() % 4 {
                let at = dice.next_u64() as usize % damaged.len();
                match dice.next_u64() % 4 {
                    0 => damaged[at] = dice.next_u64() as u8,
                    1 => damaged[at] ^= 1 << (dice.next_u64() % 8),
                    2 => damaged.truncate(at.max(1)),
                    _ => {
                        let piece = damaged[at..(at + 20).min(damaged.len())].to_vec();
                        damaged.extend(piece);
                    }
                }
            }
            match read(name, &damaged) {
                Ok(content) => use_it(&content.triangles),
                Err(error) => assert!(error.to_string().contains(name)),
            }
        }
    }
}

#[test]
fn numbers_that_a_file_may_hold_are_repaired_or_refused() {
    let p = |x: f64, y: f64| DVec3::new(x, y, 0.0);
    for size in [1e-300, 1e-40, 1e-9, 1.0, 1e12, 1e99] {
        let mut triangles = vec![[p(0.0, 0.0), p(size, 0.0), p(0.0, size)]];
        use_it(&triangles);
        triangles.push([p(size, 0.0), p(size, size), p(0.0, size)]);
        triangles.push([p(0.0, 0.0), p(1e-300, 0.0), p(0.0, 1e-300)]);
        triangles.push([p(0.0, 0.0), p(size, 0.0), p(0.5 * size, size * 1e-14)]);
        triangles.push([p(size, 0.0); 3]);
        use_it(&triangles);
    }
    let huge = [[p(0.0, 0.0), p(1e200, 0.0), p(0.0, 1.0)]];
    assert!(Mesh::repair(&huge, None).unwrap_err().to_string().contains("1e100"));
    assert!(
        Mesh::repair(&[[p(1.0, 1.0); 3]], None)
            .unwrap_err()
            .to_string()
            .contains("zero area")
    );
}
