use super::*;

const BELOW: &str = r#"region = { shape = "half-space", point = "0 0 -10 mm", normal = "-z" }"#;

/// What is told of a measure, a removal or a tag with some conditions, where there is a ball of 2 mm and a feed of balls of 3 to 5 mm.
fn told(table: &str) -> String {
    let text = format!(
        r#"
{ONE_GRAIN}

[material.ore]
young_modulus = "1 MPa"
poisson_ratio = 0.25
density = "2500 kg/m^3"

[material.liner]
young_modulus = "1 MPa"
poisson_ratio = 0.25
density = "2500 kg/m^3"

[[wall]]
name = "floor"
material = "liner"
shape = "plane"
point = "0 0 0 mm"
normal = "z"

[[feed]]
name = "stream"
material = "glass"
diameter = {{ distribution = "uniform", lower = "3 mm", upper = "5 mm" }}
from = {{ shape = "disc", center = "0 0 100 mm", normal = "z", radius = "20 mm" }}
count = 10

{table}

[[stage]]
duration = "0.1 s"
"#
    );
    prepare(&parse(&text, &[]).unwrap()).unwrap().warnings.join("\n")
}

/// What is told where there are two balls and no feed, one of them with a tag.
fn told_without_feed(table: &str) -> Result<String, String> {
    let text = format!(
        "{ONE_GRAIN}\n[[grains]]\nmaterial = \"glass\"\nsource = \"list\"\npositions = [\"0 0 50 mm\"]\n\
         diameter = \"2 mm\"\ntag = 3\n{table}\n[[stage]]\nduration = \"0.1 s\"\n"
    );
    let prepared = prepare(&parse(&text, &[]).unwrap());
    prepared
        .map(|prepared| prepared.warnings.join("\n"))
        .map_err(|faults| faults.render(false))
}

#[test]
fn ids_and_tags_that_no_grain_has_are_told() {
    let count = |conditions: &str| format!("[[measure]]\nname = \"counted\"\nkind = \"region-count\"\n{conditions}");
    for fine in ["ids = [1, 2]", "tag = 3", "tag = 0"] {
        assert_eq!(told_without_feed(&count(fine)).unwrap(), "", "{fine}");
    }
    let later = format!("{}\n[[tag]]\nvalue = 9\nat = \"50 ms\"\n", count("tag = 9"));
    assert_eq!(told_without_feed(&later).unwrap(), "");
    // grains that come get ids, too
    assert_eq!(told(&count("ids = [100]")), "");
    for (table, words) in [
        (
            count("ids = [2, 100]"),
            "measure `counted` means a grain with the id 100, which none has: the 2 grains have ids from 1 to 2",
        ),
        (
            format!("[[removal]]\nname = \"outlet\"\nids = [3, 4]\n{BELOW}"),
            "removal `outlet` means grains with 2 ids that none has, as 3",
        ),
        (
            count("tag = 9"),
            "measure `counted` means grains with the tag 9, which none has and no [[tag]] gives. Grains have the tags 0, 3;",
        ),
    ] {
        let told = told_without_feed(&table).unwrap();
        assert!(told.contains(words), "{told}");
    }
    for conditions in ["ids = [0]", "ids = [0, 1]"] {
        let told = told_without_feed(&count(conditions)).unwrap_err();
        assert!(told.contains("no grain has the id 0"), "{told}");
    }
}

#[test]
fn what_means_grains_that_are_not_there_is_told() {
    let count = |conditions: &str| format!("[[measure]]\nname = \"counted\"\nkind = \"collisions\"\n{conditions}");
    for conditions in [
        "",
        "material = \"glass\"\npartner = \"liner\"",
        // between the sizes of the feed
        "coarser_than = \"3.9 mm\"\nfiner_than = \"4 mm\"",
        "finer_than = \"2.1 mm\"",
    ] {
        assert_eq!(told(&count(conditions)), "", "{conditions}");
    }
    for (table, words) in [
        (
            count("material = \"ore\""),
            "measure `counted` means grains of `ore`, and there are none, at the start or from a feed. Grains are of `glass`, 2.0000e-3 to",
        ),
        (
            count("partner = \"ore\""),
            "measure `counted` counts collisions with `ore`, of which no grain and no wall is",
        ),
        (
            count("material = \"glass\"\nfiner_than = \"2 mm\""),
            "means grains of `glass` finer than 2.0000e-3 m, and",
        ),
        (
            format!("[[removal]]\nname = \"outlet\"\nmaterial = \"liner\"\n{BELOW}"),
            "removal `outlet` means grains of `liner`",
        ),
        (
            "[[tag]]\nvalue = 1\ncoarser_than = \"6 mm\"".to_string(),
            "tag[0] means grains coarser than 6.0000e-3 m",
        ),
    ] {
        let told = told(&table);
        assert!(told.contains(words), "{told}");
    }
}
