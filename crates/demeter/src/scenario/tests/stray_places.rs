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
        format!("[[measure]]\nname = \"m\"\nkind = \"mixing\"\n{corners}\ncells = [2, 2, 2]\nbatch = \"grains 1\"")
    };
    let measure = |kind: &str, told: &str| format!("[[measure]]\nname = \"m\"\nkind = \"{kind}\"\n{told}");
    let level = |height: &str| {
        format!(
            "[[feed]]\nname = \"f\"\nmaterial = \"glass\"\ndiameter = \"1 mm\"\nnumber_rate = \"1e3 1/s\"\n\
             from = {{ shape = \"disc\", center = \"0 0 10 mm\", normal = \"z\", radius = \"4 mm\" }}\n\
             level = {{ point = \"0 0 {height}\", normal = \"z\" }}"
        )
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
            "the grid of measure `m`",
        ),
        (
            measure(
                "profile",
                "lower = \"0 20 0 mm\"\nupper = \"5 30 5 mm\"\naxis = \"z\"\nslices = 4",
            ),
            "the box of measure `m`",
        ),
        (
            measure(
                "field",
                "lower = \"0 60 0 mm\"\nupper = \"5 70 10 mm\"\ncells = [2, 2, 2]\nwidth = \"8 mm\"",
            ),
            "the grid of measure `m`",
        ),
        (
            measure(
                "cylinder-profile",
                "start = \"0 0 50 mm\"\nend = \"0 0 60 mm\"\nradius = \"5 mm\"\nalong = \"radius\"\nbins = 4",
            ),
            "the cylinder of measure `m`",
        ),
        (
            measure("contact-network", "lower = \"0 20 0 mm\"\nupper = \"5 30 5 mm\""),
            "the region of measure `m`",
        ),
        (
            measure(
                "surface-slope",
                "point = \"0 0 0 mm\"\nalong = \"y\"\nup = \"z\"\nbetween = [\"50 mm\", \"60 mm\"]\nbins = 4",
            ),
            "the surface of measure `m`",
        ),
        (level("30 mm"), "what is beyond the `level` of feed `f`"),
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
        // what the kernel reaches counts
        measure(
            "field",
            "lower = \"0 11 0 mm\"\nupper = \"5 21 10 mm\"\ncells = [2, 2, 2]\nwidth = \"8 mm\"",
        ),
        level("15 mm"),
    ] {
        assert_eq!(told(&table), "", "{table}");
    }
}

#[test]
fn a_region_that_a_periodic_side_cuts_is_told() {
    let removal = |region: &str| told(&format!("[[removal]]\nname = \"outlet\"\nregion = {region}"));
    let tag = |region: &str| told(&format!("[[tag]]\nvalue = 1\nregion = {region}"));
    let count = |region: &str| {
        told(&format!(
            "[[measure]]\nname = \"m\"\nkind = \"region-count\"\nregion = {region}"
        ))
    };
    let box_of =
        |x: &str, to: &str| format!("{{ shape = \"box\", lower = \"{x} -20 -9 mm\", upper = \"{to} 20 5 mm\" }}");
    let sphere = "{ shape = \"sphere\", center = \"8 0 9 mm\", radius = \"5 mm\" }";
    let cylinder = "{ shape = \"cylinder\", start = \"-9 0 5 mm\", end = \"-9 0 9 mm\", radius = \"5 mm\" }";
    for (told, whose, side) in [
        (count(sphere), "measure `m`", "x = 1.0000e-2 m, to 1.3000e-2 m"),
        (
            removal(&box_of("-13", "5")),
            "removal `outlet`",
            "x = -1.0000e-2 m, to -1.3000e-2 m",
        ),
        (tag(cylinder), "tag[0]", "x = -1.0000e-2 m, to -1.4000e-2 m"),
    ] {
        let cut = format!("the `region` of {whose} reaches beyond the periodic side at {side}");
        assert!(told.contains(&cut), "{cut}: {told}");
    }
    for told in [
        // only x is periodic; what reaches beyond both sides holds all; rounding is nothing
        count(&box_of("-10", "10")),
        count(&box_of("-12", "12")),
        removal(&box_of("-5", "10.000001")),
        tag("{ shape = \"box\", lower = \"5 -20 -9 mm\", upper = \"30 20 5 mm\", open = [\"+x\"] }"),
        count("{ shape = \"sphere\", center = \"8 0 9 mm\", radius = \"5 mm\", outside = true }"),
        count(&format!("[{sphere}, {}]", box_of("-10", "10"))),
    ] {
        assert_eq!(told, "");
    }
}

#[test]
fn an_index_of_mixing_that_tells_nothing_says_so() {
    let mixing = |corner: &str, kind: &str| {
        told(&format!(
            "[[measure]]\nname = \"m\"\nkind = \"mixing\"\nlower = \"-5 -5 0 mm\"\nupper = \"{corner}\"\ncells = [2, 2, 2]\n{kind}"
        ))
    };
    let wide = "5 5 10 mm";
    assert_eq!(mixing(wide, "batch = \"grains 1\""), "");
    let alone = mixing(wide, "material = \"glass\"");
    assert!(
        alone.contains("measure `m` looks at how grains of `glass` are mixed with all others, and there are no others"),
        "{alone}"
    );
    let fine = mixing("-4 -4 1 mm", "batch = \"grains 1\"");
    assert!(
        fine.contains("the cells of measure `m` are smaller than a grain"),
        "{fine}"
    );
}

#[test]
fn a_stage_that_has_what_it_waits_for_at_the_start_says_so() {
    let told = told("[[stage]]\nname = \"wait\"\nduration = \"1 ms\"\nstop = { grains_at_most = 9 }");
    assert!(
        told.contains("stage `wait` is to end when 9 grains are left, and there are 1 at the start"),
        "{told}"
    );
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
