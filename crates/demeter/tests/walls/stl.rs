//! STL files, good and hostile.

use demeter::walls::{MeshFileError, read_mesh};
use glam::DVec3;
use std::fs;
use std::path::{Path, PathBuf};
use tempfile::TempDir;

const TETRAHEDRON: [[[f32; 3]; 3]; 4] = [
    [[0.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]],
    [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.5]],
    [[0.0, 0.0, 0.0], [0.0, 0.0, 1.5], [0.0, 1.0, 0.0]],
    [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.5]],
];

fn expected(scale: f64, shift: DVec3) -> Vec<[DVec3; 3]> {
    let corner = |c: [f32; 3]| DVec3::new(f64::from(c[0]), f64::from(c[1]), f64::from(c[2])) * scale + shift;
    TETRAHEDRON.iter().map(|triangle| triangle.map(corner)).collect()
}

fn binary(header: &str) -> Vec<u8> {
    let mut bytes = vec![b' '; 80];
    bytes[..header.len()].copy_from_slice(header.as_bytes());
    bytes.extend((TETRAHEDRON.len() as u32).to_le_bytes());
    for triangle in TETRAHEDRON {
        bytes.extend([0; 12]);
        for value in triangle.as_flattened() {
            bytes.extend(value.to_le_bytes());
        }
        bytes.extend([0; 2]);
    }
    bytes
}

fn ascii() -> String {
    let mut text = String::from("solid four faces\n");
    for triangle in TETRAHEDRON {
        text.push_str("  facet normal 0 0 nan\n    outer loop\n");
        for [x, y, z] in triangle {
            text.push_str(&format!("      vertex {x:e} {y} {z}\n"));
        }
        text.push_str("    endloop\n  endfacet\n");
    }
    text + "endsolid four faces\n"
}

fn write(bytes: &[u8]) -> (TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("shape.stl");
    fs::write(&path, bytes).unwrap();
    (folder, path)
}

fn triangles(path: &Path, scale: f64, shift: DVec3) -> Result<Vec<[DVec3; 3]>, MeshFileError> {
    read_mesh(path, Some(scale), shift).map(|content| content.triangles)
}

fn read(bytes: &[u8]) -> Result<Vec<[DVec3; 3]>, MeshFileError> {
    let (_folder, path) = write(bytes);
    triangles(&path, 1.0, DVec3::ZERO)
}

#[test]
fn reads_binary_whatever_its_header_says() {
    for header in ["exported by hand", "solid but binary", "SOLID", ""] {
        assert_eq!(read(&binary(header)).unwrap(), expected(1.0, DVec3::ZERO), "{header}");
    }
}

#[test]
fn reads_what_another_program_wrote() {
    let vector = |c: [f32; 3]| stl_io::Vector::new(c);
    let mesh: Vec<stl_io::Triangle> = TETRAHEDRON
        .iter()
        .map(|t| stl_io::Triangle {
            normal: vector([0.0; 3]),
            vertices: t.map(vector),
        })
        .collect();
    let mut bytes = Vec::new();
    stl_io::write_stl(&mut bytes, mesh.iter()).unwrap();
    assert_eq!(read(&bytes).unwrap(), expected(1.0, DVec3::ZERO));
}

#[test]
fn reads_ascii_in_any_case_and_line_ending() {
    let text = ascii();
    let twice = format!("{text}\n{text}");
    assert_eq!(read(text.as_bytes()).unwrap(), expected(1.0, DVec3::ZERO));
    assert_eq!(
        read(text.to_uppercase().as_bytes()).unwrap(),
        expected(1.0, DVec3::ZERO)
    );
    assert_eq!(
        read(text.replace('\n', "\r\n").as_bytes()).unwrap(),
        expected(1.0, DVec3::ZERO)
    );
    assert_eq!(read(twice.as_bytes()).unwrap().len(), 8);
}

#[test]
fn scales_then_shifts() {
    let (_folder, path) = write(&binary("mm"));
    let shift = DVec3::new(0.1, 0.2, -0.3);
    assert_eq!(triangles(&path, 1e-3, shift).unwrap(), expected(1e-3, shift));
}

#[test]
fn hostile_files_are_refused_with_the_reason_and_the_path() {
    let good = binary("ok");
    let text = ascii();
    let mut claims_many = good.clone();
    claims_many[80..84].copy_from_slice(&u32::MAX.to_le_bytes());
    let mut nan = good.clone();
    nan[84 + 12..84 + 16].copy_from_slice(&f32::NAN.to_le_bytes());
    let mut infinite = good.clone();
    infinite[84 + 50 + 12..84 + 50 + 16].copy_from_slice(&f32::INFINITY.to_le_bytes());
    let mut none = good[..84].to_vec();
    none[80..84].copy_from_slice(&0u32.to_le_bytes());
    let mut long = good.clone();
    long.push(0);
    let cases: Vec<(&str, Vec<u8>, &str)> = vec![
        ("empty", vec![], "0 bytes"),
        ("short", good[..60].to_vec(), "60 bytes"),
        ("cut short", good[..good.len() - 7].to_vec(), "cut short"),
        ("one byte too many", long, "more lies behind its triangles"),
        ("count of four billion", claims_many, "4294967295 triangles"),
        (
            "cut short with a solid header",
            binary("solid x")[..200].to_vec(),
            "cut short or damaged",
        ),
        ("not a number", nan, "triangle 1 "),
        ("infinite", infinite, "triangle 2 "),
        ("no triangle", none, "no triangle"),
        (
            "ascii without triangles",
            b"solid x\nendsolid x\n".to_vec(),
            "no triangle",
        ),
        (
            "ascii without end",
            text.replace("endsolid four faces\n", "").into_bytes(),
            "before endsolid",
        ),
        ("ascii cut in a facet", text.as_bytes()[..120].to_vec(), ""),
        ("ascii nan", text.replacen("1.5", "nan", 1).into_bytes(), "triangle 2 "),
        (
            "ascii word for a number",
            text.replacen("1.5", "one", 1).into_bytes(),
            "three numbers",
        ),
        (
            "ascii two coordinates",
            b"solid\nfacet normal 0 0 1\nouter loop\nvertex 1 2\n".to_vec(),
            ":4: expected",
        ),
        (
            "ascii four coordinates",
            text.replacen("1.5", "1.5 7", 1).into_bytes(),
            "three numbers",
        ),
        (
            "ascii two corners",
            text.replacen("      vertex 0e0 1 0\n", "", 1).into_bytes(),
            "expected vertex",
        ),
        (
            "text after the end",
            format!("{text}hello\n").into_bytes(),
            "expected `solid`, found `hello`",
        ),
        ("some other text", b"hello\nformat ascii 1.0\n".to_vec(), "23 bytes"),
        (
            "bytes that are no text",
            [b"solid \xff\xfe\nfacet \xff\n".to_vec(), vec![0xff; 200]].concat(),
            ":2: expected",
        ),
    ];
    for (name, bytes, message) in cases {
        let (_folder, path) = write(&bytes);
        let error = triangles(&path, 1.0, DVec3::ZERO).expect_err(name).to_string();
        assert!(error.contains("shape.stl"), "{name}: {error}");
        assert!(error.contains(message), "{name}: `{error}` lacks `{message}`");
    }
}

#[test]
fn every_cut_of_a_file_is_an_error_or_a_whole_file() {
    for bytes in [binary("solid"), binary("x"), ascii().into_bytes()] {
        for end in 0..bytes.len() {
            match read(&bytes[..end]) {
                Err(error) => assert!(error.to_string().contains("shape.stl")),
                Ok(triangles) => {
                    assert_eq!(triangles.len(), 4);
                    assert!(
                        String::from_utf8_lossy(&bytes[..end]).contains("endsolid"),
                        "{end} of {}",
                        bytes.len()
                    );
                }
            }
        }
    }
}

#[test]
fn a_missing_file_and_a_folder_are_told_apart() {
    let folder = tempfile::tempdir().unwrap();
    assert!(matches!(
        triangles(&folder.path().join("none.stl"), 1.0, DVec3::ZERO),
        Err(MeshFileError::Read { .. })
    ));
    assert!(matches!(
        triangles(folder.path(), 1.0, DVec3::ZERO),
        Err(MeshFileError::NotAFile { .. })
    ));
}
