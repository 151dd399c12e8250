//! Springs of a given stiffness between grains whose contacts feel each other.

use super::*;

fn warnings(normal: &str, multi_contact: &str) -> String {
    let text = format!(
        r#"
[simulation]
max_overlap = 0.5
[material.gel]
young_modulus = "1 MPa"
poisson_ratio = 0.4
density = "1000 kg/m^3"
[contact]
normal = {normal}
{multi_contact}
[[grains]]
material = "gel"
source = "list"
positions = ["0 0 0 mm"]
diameter = "10 mm"
[[wall]]
name = "below"
material = "gel"
shape = "plane"
point = "0 0 -5 mm"
normal = "z"
[[stage]]
steps = 2
"#
    );
    prepare(&parse(&text, &[]).unwrap()).unwrap().warnings.join("\n")
}

#[test]
fn springs_that_no_coupled_force_fits_are_told() {
    let linear = |stiffness: &str| format!("{{ law = \"linear\", stiffness = \"{stiffness}\", restitution = 1 }}");
    let half_space = "multi_contact = { law = \"half-space\", prefactor = 1.0 }";
    let told = warnings(&linear("1e5 N/m"), half_space);
    // `2 pi E d/((1 + nu)(3 - 2 nu))`
    assert!(
        told.contains("a stiffness of 1.000e5 N/m") && told.contains("from 2.040e4 N/m on"),
        "{told}"
    );
    let hertz = "{ law = \"hertz-tsuji\", restitution = 0.5 }";
    for (normal, multi_contact) in [
        (linear("2e4 N/m"), half_space),
        (linear("1e5 N/m"), ""),
        (hertz.to_string(), half_space),
    ] {
        let told = warnings(&normal, multi_contact);
        assert!(!told.contains("a stiffness of"), "{normal} {multi_contact}: {told}");
    }
}
