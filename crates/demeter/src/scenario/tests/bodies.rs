use super::*;
use crate::particles::boxed;

/// What is told of a body of a density whose mesh is these boxes, each with its corners [mm].
fn told(boxes: &[[f64; 6]]) -> String {
    let corner = |c: glam::DVec3| format!("\"{} {} {} mm\"", c.x, c.y, c.z);
    let triangles: Vec<String> = (boxes.iter())
        .flat_map(|[x, y, z, u, v, w]| boxed(dvec3(*x, *y, *z), dvec3(*u, *v, *w)))
        .map(|triangle| format!("[{}]", triangle.map(corner).join(", ")))
        .collect();
    let text = format!(
        r#"
[domain]
lower = "-20 -20 -20 mm"
upper = "20 20 20 mm"
{ONE_GRAIN}
[[wall]]
name = "stone"
material = "glass"
shape = "mesh"
triangles = [{}]
motion = {{ body = {{ density = "1000 kg/m^3" }} }}
[[stage]]
steps = 2
"#,
        triangles.join(", ")
    );
    prepare(&parse(&text, &[]).unwrap()).unwrap().warnings.join("\n")
}

#[test]
fn parts_that_overlap_are_told_to_count_twice() {
    let told_of = "mass and moments of inertia, which follow from `density`, count what they share";
    let two = told(&[[-9.0, -9.0, -9.0, 1.0, 1.0, 1.0], [-5.0, -5.0, -5.0, 5.0, 5.0, 5.0]]);
    // twice a cubic centimetre less 6 mm cubed
    assert!(
        two.contains(told_of) && two.contains("together would weigh about 1.77e-3 kg"),
        "{two}"
    );
    let apart = told(&[[-9.0, -9.0, -9.0, -5.0, -5.0, -5.0], [-4.0, -4.0, -4.0, 5.0, 5.0, 5.0]]);
    assert!(!apart.contains(told_of), "{apart}");
}
