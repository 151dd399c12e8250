use super::*;

/// What is told of a measure, a removal or a tag in a domain of 20 mm that is periodic along x.
fn told(table: &str) -> String {
    let text = format!(
        r#"
[domain]
lower = "-10 -10 0 mm"
upper = "10 10 20 mm"
periodic = ["x"]
{ONE_GRAIN}
{table}
[[stage]]
duration = "0.1 s"
"#
    );
    prepare(&parse(&text, &[]).unwrap()).unwrap().warnings.join("\n")
}

#[test]
fn places_outside_of_the_domain_are_told() {
    let removal = |region: &str| format!("[[removal]]\nname = \"outlet\"\nregion = {region}");
    let count = |region: &str| format!("[[measure]]\nname = \"m\"\nkind = \"region-count\"\nregion = {region}");
    let flow = |gate: &str| format!("[[measure]]\nname = \"m\"\nkind = \"mass-flow\"\ngate = {gate}");
    let mixing = |corners: &str| {
        format!("[[measure]]\nname = \"m\"\nkind = \"mixing\"\n{corners}\ncells = [2, 2, 2]\nmaterial = \"glass\"")
    };
    let box_from =
        |lower: &str, upper: &str| format!("{{ shape = \"box\", lower = \"{lower}\", upper = \"{upper}\" }}");
    for (table, what) in [
        (
            removal(&box_from("-1 -1 -9 mm", "1 1 -1 mm")),
            "the `region` of removal `outlet`",
        ),
        (
            removal("{ shape = \"half-space\", point = \"0 0 -1 mm\", normal = \"-z\" }"),
            "the `region` of removal",
        ),
        (
            count("{ shape = \"sphere\", center = \"0 0 40 mm\", radius = \"5 mm\" }"),
            "the `region` of measure `m`",
        ),
        (
            count("{ shape = \"cylinder\", start = \"20 0 5 mm\", end = \"20 0 9 mm\", radius = \"5 mm\" }"),
            "the `region` of measure `m`",
        ),
        (
            format!("[[tag]]\nvalue = 1\nregion = {}", box_from("0 0 21 mm", "1 1 22 mm")),
            "the `region` of tag[0]",
        ),
        (
            flow("{ shape = \"plane\", point = \"0 0 30 mm\", normal = \"z\" }"),
            "the gate of measure `m`",
        ),
        (
            flow("{ shape = \"disc\", center = \"0 0 30 mm\", normal = \"z\", radius = \"99 mm\" }"),
            "the gate of measure `m`",
        ),
        (
            mixing("lower = \"0 20 0 mm\"\nupper = \"5 30 5 mm\""),
            "the cells of measure `m`",
        ),
    ] {
        let told = told(&table);
        assert!(
            told.contains(what) && told.contains("lies wholly outside of the domain"),
            "{table}: {told}"
        );
    }
    for table in [
        removal(&box_from("-1 -1 -9 mm", "1 1 1 mm")),
        // all but a part that lies outside is everywhere
        count("{ shape = \"sphere\", center = \"0 0 40 mm\", radius = \"5 mm\", outside = true }"),
        flow("{ shape = \"disc\", center = \"0 0 30 mm\", normal = \"x\", radius = \"11 mm\" }"),
        // an image of the cells lies in the domain
        mixing("lower = \"20 0 0 mm\"\nupper = \"25 5 5 mm\""),
    ] {
        assert_eq!(told(&table), "", "{table}");
    }
}

#[test]
fn displacements_from_after_the_end_are_told() {
    let from = |time: &str| {
        told(&format!(
            "[[measure]]\nname = \"m\"\nkind = \"displacement\"\nfrom = \"{time}\""
        ))
    };
    assert_eq!(from("0.05 s"), "");
    assert!(
        from("1 s").contains("measure `m` counts displacements from 1 s on"),
        "{}",
        from("1 s")
    );
}
