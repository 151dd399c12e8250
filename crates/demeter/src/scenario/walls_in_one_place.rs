//! Walls that lie in one place, where a grain is pushed by each of them: unless they are of one material and contacts are independent
//! (`contacts/seams.rs`).

use crate::particles::{Domain, Grains};
use crate::walls::{SurfaceContact, Wall};
use glam::DVec3;
use std::iter;

/// Most triangles of all walls whose middles are looked at, and the least of a wall.
const MOST_PLACES: usize = 1 << 14;
const FEWEST_PLACES: usize = 64;

/// Two surfaces are one where their distances from a grain differ by less than this share of its radius, and the cosine of the angle between
/// them is larger.
const SAME_DISTANCE: f64 = 1e-2;
const SAME_DIRECTION: f64 = 0.99;

/// Tells which walls push a grain twice.
pub(super) fn check(
    (walls, are_coupled): (&[Wall], bool),
    grains: &Grains,
    domain: &Domain,
    warnings: &mut Vec<String>,
) {
    let smallest = grains.radii().fold(f64::INFINITY, f64::min);
    let mut told: Vec<(usize, usize)> = Vec::new();
    for (a, wall) in walls.iter().enumerate() {
        let triangles = wall.triangles(domain.lower, domain.upper);
        let most = (MOST_PLACES / walls.len()).max(FEWEST_PLACES);
        for triangle in triangles.iter().step_by(triangles.len().div_ceil(most).max(1)) {
            let probe = Probe::on(triangle, smallest);
            for (b, other) in walls.iter().enumerate() {
                let pair = (a.min(b), a.max(b));
                let are_one = wall.material == other.material && !are_coupled;
                if a == b || are_one || told.contains(&pair) || !other.near(probe.middle, probe.radius + probe.size) {
                    continue;
                }
                let touched = probe.touching(wall);
                let Some((centre, contact)) = touched.into_iter().find(|there| lies_there(other, there, probe.radius))
                else {
                    continue;
                };
                told.push(pair);
                warnings.push(format!(
                    "walls `{}` and `{}` lie in one place at {}: a grain there is pushed by both, as by a wall that is twice as stiff, \
                     and rebounds with another restitution than was asked. Leave out of one of them what belongs to the other, or make both of one material and contacts independent",
                    walls[pair.0].name,
                    walls[pair.1].name,
                    centre - contact.normal * contact.distance
                ));
            }
        }
    }
}

/// A sphere that is held to a triangle of a wall. It is no larger than the triangle, nor than that is wide: of a fine mesh it meets few.
struct Probe {
    middle: DVec3,
    normal: DVec3,
    /// How far the triangle reaches from its middle [m].
    size: f64,
    /// Of the sphere [m].
    radius: f64,
}

impl Probe {
    fn on(triangle: &[DVec3; 3], grain: f64) -> Self {
        let [a, b, c] = *triangle;
        let middle = (a + b + c) / 3.0;
        let size = a.distance(middle).max(b.distance(middle)).max(c.distance(middle));
        let across = (b - a).cross(c - a);
        let longest = a.distance(b).max(b.distance(c)).max(c.distance(a));
        Self {
            middle,
            normal: across.normalize_or_zero(),
            size,
            radius: grain.min(across.length() / longest),
        }
    }

    /// Centres at which it touches the wall beside the middle of the triangle, from either side, each with the contact.
    fn touching(&self, wall: &Wall) -> Vec<(DVec3, SurfaceContact)> {
        let face = |centre: DVec3, reach: f64| {
            let mut parts = Vec::new();
            wall.contacts(centre, (reach, 0.0), &mut parts);
            let face = parts.into_iter().filter(|part| !part.is_at_edge && part.distance > 0.0);
            face.min_by(|a, b| a.distance.total_cmp(&b.distance))
        };
        let beside = [1.0, -1.0].map(|side| {
            // the triangle is flat, the wall may be round
            let farther = wall.mesh().is_none().then_some(self.size + self.radius);
            let (near, part) = (iter::once(0.5 * self.radius).chain(farther)).find_map(|height| {
                let near = self.middle + self.normal * (side * height);
                face(near, 4.0 * height).map(|part| (near, part))
            })?;
            let centre = near - part.normal * (part.distance - 0.9 * self.radius);
            Some((centre, face(centre, self.radius)?))
        });
        beside.into_iter().flatten().collect()
    }
}

/// Whether a grain with its centre at a place touches a wall as it touches another one.
fn lies_there(wall: &Wall, (centre, contact): &(DVec3, SurfaceContact), radius: f64) -> bool {
    let mut parts = Vec::new();
    if wall.near(*centre, radius) {
        wall.contacts(*centre, (radius, 0.0), &mut parts);
    }
    let is_same = |part: &SurfaceContact| {
        !part.is_at_edge
            && (part.distance - contact.distance).abs() < SAME_DISTANCE * radius
            && part.normal.dot(contact.normal) > SAME_DIRECTION
    };
    parts.iter().any(is_same)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::particles::{NewGrain, Outside};
    use crate::walls::{Motion, Shape, Side};

    /// Which of some walls are said to lie in one place, by their numbers.
    fn told(shapes: Vec<Shape>) -> Vec<String> {
        told_of(shapes, 1, false)
    }

    fn told_of(shapes: Vec<Shape>, other_material: u16, are_coupled: bool) -> Vec<String> {
        let walls: Vec<Wall> = (shapes.into_iter().enumerate())
            .map(|(k, shape)| Wall::new(&k.to_string(), k as u16 * other_material, shape, Motion::Rest).unwrap())
            .collect();
        let mut grains = Grains::default();
        grains.push(
            1,
            &NewGrain {
                fixed: false,
                material: 0,
                radius: 1e-3,
                density: 1000.0,
                position: DVec3::ZERO,
                velocity: DVec3::ZERO,
                angular_velocity: DVec3::ZERO,
            },
        );
        let domain = Domain {
            lower: DVec3::splat(-0.1),
            upper: DVec3::splat(0.1),
            periodic: [false; 3],
            outside: Outside::Stop,
        };
        let mut warnings = Vec::new();
        check((&walls, are_coupled), &grains, &domain, &mut warnings);
        let names = |warning: &String| warning.split(" lie in").next().unwrap_or_default().to_owned();
        warnings.iter().map(names).collect()
    }

    fn cylinder(radius: f64) -> Shape {
        Shape::Cylinder {
            start: DVec3::Z * -0.05,
            end: DVec3::Z * 0.05,
            radius,
            side: Side::Inside,
        }
    }

    fn rectangle(center: DVec3, half_u: DVec3, half_v: DVec3) -> Shape {
        Shape::Rectangle { center, half_u, half_v }
    }

    #[test]
    fn a_surface_that_is_there_twice_is_told() {
        let (x, y, z) = (DVec3::X * 0.05, DVec3::Y * 0.05, DVec3::Z * 0.05);
        let floor = Shape::Plane {
            point: -z,
            normal: DVec3::Z,
        };
        let bin = Shape::Box {
            lower: DVec3::splat(-0.05),
            upper: DVec3::splat(0.05),
            open: [false; 6],
        };
        assert_eq!(told(vec![floor.clone(), bin.clone()]), ["walls `0` and `1`"]);
        let twice = vec![cylinder(0.04), cylinder(0.04)];
        assert_eq!(told(twice.clone()), ["walls `0` and `1`"]);
        assert_eq!(told_of(twice.clone(), 0, true), ["walls `0` and `1`"]);
        assert_eq!(told_of(twice, 0, false), [""; 0]);
        // a part of a large one
        let mesh = Shape::Mesh {
            triangles: vec![[-z, x * 0.1 - z, y * 0.1 - z]],
        };
        assert_eq!(
            told(vec![bin, mesh, rectangle(y, x, z)]),
            ["walls `0` and `2`", "walls `0` and `1`"]
        );
    }

    /// Or it meets all slivers beside its own.
    #[test]
    fn a_sphere_is_no_larger_than_its_triangle_is_wide() {
        let sliver = [DVec3::ZERO, DVec3::X, DVec3::new(1.0, 1e-3, 0.0)];
        assert!(Probe::on(&sliver, 0.1).radius <= 1e-3);
        let wide = [DVec3::ZERO, DVec3::X, DVec3::Y];
        assert_eq!(Probe::on(&wide, 0.1).radius, 0.1);
    }

    #[test]
    fn walls_that_meet_or_cross_are_not_told() {
        let (x, y, z) = (DVec3::X * 0.05, DVec3::Y * 0.05, DVec3::Z * 0.05);
        let plane = |point: DVec3, normal| Shape::Plane { point, normal };
        let walls = vec![
            plane(-z, DVec3::Z),
            cylinder(0.04),
            cylinder(0.045),
            rectangle(DVec3::ZERO, 0.6 * x, 0.6 * y),
            rectangle(1.2 * x, 0.6 * x, 0.6 * y),
            rectangle(DVec3::ZERO, y, z),
            Shape::Disc {
                center: DVec3::Z * 0.0501,
                normal: DVec3::Z,
                radius: 0.04,
            },
        ];
        assert_eq!(told(walls), [""; 0]);
    }
}
