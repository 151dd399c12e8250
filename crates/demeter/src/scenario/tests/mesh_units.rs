//! Meshes drawn in millimetres of which nobody says so.

use super::super::*;

/// A box of 40 x 30 x 50 as OBJ, in units that the file does not tell.
const BOX: &str = "v 0 0 0\nv 40 0 0\nv 40 30 0\nv 0 30 0\nv 0 0 50\nv 40 0 50\nv 40 30 50\nv 0 30 50\n\
    f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

/// A scenario of a few grains of 2 mm beside a file `box.obj`.
fn prepared(more: &str) -> Result<Vec<String>, String> {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("box.obj"), BOX).unwrap();
    let text = format!(
        r#"
[material.glass]
young_modulus = "5 MPa"
poisson_ratio = 0.25
density = "2500 kg/m^3"
[contact]
normal = {{ law = "hertz-tsuji", restitution = 0.5 }}
[[grains]]
material = "glass"
source = "list"
positions = ["10 10 10 mm", "20 20 30 mm"]
diameter = "2 mm"
{more}
[[stage]]
duration = "0.1 s"
"#
    );
    let scenario = Scenario::parse(&text, "units.toml", folder.path(), &[]).map_err(|faults| faults.to_string())?;
    prepare(&scenario)
        .map(|prepared| prepared.warnings)
        .map_err(|faults| faults.to_string())
}

#[test]
fn regions_and_inlets_of_meshes_in_millimetres_are_doubted() {
    let region = |unit: &str| format!("{{ shape = \"mesh\", file = \"box.obj\"{unit} }}");
    let kinds = |unit: &str| {
        let region = region(unit);
        [
            (
                "removal[0].region",
                format!("[[removal]]\nname = \"out\"\nregion = {region}\n"),
            ),
            (
                "tag[0].region",
                format!("[[tag]]\nvalue = 1\nat = \"0 s\"\nregion = {region}\n"),
            ),
            (
                "feed[0].from",
                format!(
                    "[[feed]]\nname = \"in\"\nmaterial = \"glass\"\ndiameter = \"2 mm\"\nnumber_rate = \"100 1/s\"\n\
                     velocity = \"0 0 -1 m/s\"\nfrom = {region}\n"
                ),
            ),
        ]
    };
    for (path, table) in kinds("") {
        let warnings = prepared(&table).unwrap();
        let doubt = warnings.iter().find(|text| text.starts_with(path));
        let doubt = doubt.unwrap_or_else(|| panic!("{path}: {warnings:?}"));
        assert!(doubt.contains("`unit = \"mm\"`, and it is 0.0707 m"), "{doubt}");
    }
    for (path, table) in kinds(", unit = \"mm\"").into_iter().chain(kinds(", unit = \"m\"")) {
        let warnings = prepared(&table).unwrap();
        assert!(
            !warnings.iter().any(|text| text.contains("no `unit`")),
            "{path}: {warnings:?}"
        );
    }
}

#[test]
fn a_mesh_smaller_than_a_grain_is_doubted_whoever_told_its_unit() {
    let warnings = |unit: &str| {
        prepared(&format!(
            "[[wall]]\nname = \"drum\"\nmaterial = \"glass\"\nshape = \"mesh\"\nfile = \"box.obj\"\nunit = \"{unit}\"\n"
        ))
        .unwrap()
    };
    let told = warnings("um").join("\n");
    assert!(
        told.contains("wall `drum`: the mesh is 4.0000e-5 x 3.0000e-5 x 5.0000e-5 m, smaller than the largest grain of 2.0000e-3 m"),
        "{told}"
    );
    assert_eq!(warnings("mm"), Vec::<String>::new());
}

#[test]
fn a_turning_mesh_in_millimetres_is_told_beside_its_speed() {
    let drum = |unit: &str| {
        prepared(&format!(
            "[[wall]]\nname = \"drum\"\nmaterial = \"glass\"\nshape = \"mesh\"\nfile = \"box.obj\"\n{unit}\
             motion = {{ rotation = {{ point = \"20 15 25 mm\", axis = \"y\", angular_velocity = \"60 rad/s\" }} }}\n"
        ))
    };
    let fault = drum("").unwrap_err();
    assert!(
        fault.contains("wall `drum` moves at up to") && fault.contains("`unit = \"mm\"`"),
        "{fault}"
    );
    let fault = drum("unit = \"m\"\n").unwrap_err();
    assert!(
        fault.contains("slow it down") && !fault.contains("no `unit`"),
        "{fault}"
    );
    assert_eq!(drum("unit = \"mm\"\n").unwrap(), Vec::<String>::new());
}
