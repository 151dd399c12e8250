//! Tags that a file of grains tells.

use super::super::*;

/// A file of grains with these tags, in a batch with more keys.
fn prepared(told: [&str; 2], more: &str) -> Result<Prepared, String> {
    let folder = tempfile::tempdir().unwrap();
    let rows = format!(
        "x [mm],y,z,diameter [mm],tag\n0,0,0,2,{}\n4,0,0,2,{}\n",
        told[0], told[1]
    );
    std::fs::write(folder.path().join("grains.csv"), rows).unwrap();
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
source = "file"
file = "grains.csv"
{more}
[[stage]]
duration = "0.1 s"
"#
    );
    let scenario = Scenario::parse(&text, "tags.toml", folder.path(), &[]).map_err(|faults| faults.to_string())?;
    prepare(&scenario).map_err(|faults| faults.to_string())
}

fn tags(told: [&str; 2], more: &str) -> Result<[i32; 2], String> {
    prepared(told, more).map(|prepared| [1, 2].map(|id| prepared.origins.tag(id)))
}

#[test]
fn measures_may_ask_for_the_tags_of_a_file() {
    let measure = "[[measure]]\nname = \"some\"\nkind = \"region-count\"\ntag = ";
    let warnings = |tag: &str| prepared(["7", "-3"], &format!("{measure}{tag}")).unwrap().warnings;
    assert!(warnings("7").is_empty(), "{:?}", warnings("7"));
    let found = warnings("9").join("\n");
    assert!(
        found.contains("the tag 9, which none has") && found.contains("-3, 0, 7"),
        "{found}"
    );
}

#[test]
fn grains_keep_the_tags_of_their_file_unless_the_batch_tells_one() {
    assert_eq!(tags(["7", "-3.0"], ""), Ok([7, -3]));
    assert_eq!(tags(["7", "-3"], "tag = 5"), Ok([5, 5]));
    assert_eq!(tags(["7", "-3"], "tag = 0"), Ok([0, 0]));
    let found = tags(["7", "1e30"], "").unwrap_err();
    assert!(found.contains("line 3, column `tag`: `1e30` is not allowed"), "{found}");
}
