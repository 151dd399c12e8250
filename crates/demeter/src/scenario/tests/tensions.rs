//! Boxes that are to hold a tension.

use super::*;

fn warnings(stress: &str, normal: &str) -> String {
    let text = format!(
        r#"
[domain]
lower = "0 0 0 mm"
upper = "20 20 20 mm"
periodic = ["x", "y", "z"]
{ONE_GRAIN}
[[stage]]
duration = "0.1 s"
repeat = 2
[stage.deform]
y = {{ stress = "{stress}", max_rate = "1 1/s" }}
"#
    );
    let text = text.replace("{ law = \"hertz-tsuji\", restitution = 0.7 }", normal);
    prepare(&parse(&text, &[]).unwrap()).unwrap().warnings.join("\n")
}

#[test]
fn a_tension_of_grains_that_never_pull_is_told_once() {
    let hertz = "{ law = \"hertz-tsuji\", restitution = 0.7 }";
    let told = warnings("-100 Pa", hertz);
    assert_eq!(told.matches("is a tension of 1e2 Pa, and no law").count(), 1, "{told}");
    assert!(told.contains("`stage[0].deform.y.stress` is"), "{told}");
    let linear = "{ law = \"linear\", stiffness = \"1 kN/m\", restitution = 0.7 }";
    assert!(warnings("-100 Pa", linear).contains("is a tension"));
    for (stress, normal) in [
        ("0 Pa", hertz),
        ("100 Pa", hertz),
        (
            "-100 Pa",
            "{ law = \"jkr\", work_of_adhesion = \"0.1 J/m^2\", alpha = 0.2 }",
        ),
        (
            "-100 Pa",
            "{ law = \"sjkr\", cohesion_energy_density = \"2 kJ/m^3\", area = \"hertz\" }",
        ),
    ] {
        let told = warnings(stress, normal);
        assert!(!told.contains("tension"), "{stress} {normal}: {told}");
    }
}
