use super::*;
use crate::particles::boxed;

/// What is told of a body of a density, whose inside is a region, too, and whose mesh is these boxes, each with its corners [mm]; one that is
/// mirrored is inside out.
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
closed = true
motion = {{ body = {{ density = "1000 kg/m^3" }} }}
[[measure]]
name = "inside"
kind = "region-count"
region = {{ shape = "mesh", wall = "stone" }}
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

#[test]
fn parts_may_be_drawn_inside_out_and_share_a_face() {
    let told_of = "count what they share";
    let one = [-9.0, -9.0, -9.0, 1.0, 1.0, 1.0];
    let apart = told(&[one, [12.0, 2.0, 2.0, 2.0, 5.0, 5.0]]);
    assert!(!apart.contains(told_of), "{apart}");
    let crossing = told(&[one, [5.0, -5.0, -5.0, -5.0, 5.0, 5.0]]);
    assert!(
        crossing.contains(told_of) && crossing.contains("together would weigh about 1.77e-3 kg"),
        "{crossing}"
    );
    let next = [1.0, -9.0, -9.0, 6.0, 1.0, 1.0];
    let side_by_side = told(&[one, next]);
    assert!(!side_by_side.contains(told_of), "{side_by_side}");
}
