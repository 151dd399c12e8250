//! Mass, centre of mass and inertia of what a closed surface encloses.

use super::error::WallError;
use super::pose::Pose;
use super::surface::Surface;
use crate::particles::Interior;
use demeter_physics::geometry::Side;
use glam::{DMat3, DVec3};
use serde::{Deserialize, Serialize};
use std::f64::consts::PI;

/// How the mass of a body is told.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum BodyMass {
    /// As numbers.
    Told(MassProperties),
    /// As the density [kg/m^3] of what the surface encloses: of a closed mesh, or a sphere that has the grains outside.
    Density(f64),
}

/// Mass of a body and where it lies.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct MassProperties {
    /// Mass [kg].
    pub mass: f64,
    /// Centre of mass in the world, as the body stands when it is told [m].
    pub center: DVec3,
    /// Tensor of inertia about it, along the axes of the world [kg m^2].
    pub inertia: DMat3,
}

impl BodyMass {
    /// What a body of this mass has that stands so.
    pub(super) fn of(&self, surface: &Surface, origin: DVec3, pose: &Pose) -> Result<MassProperties, WallError> {
        match *self {
            BodyMass::Told(told) => Ok(told),
            BodyMass::Density(density) => Ok(enclosed(surface, density)?.placed(origin, pose)),
        }
    }
}

impl MassProperties {
    /// Those in the wall frame, as the pose places them.
    fn placed(self, origin: DVec3, pose: &Pose) -> Self {
        let turned = DMat3::from_quat(pose.rotation);
        Self {
            center: pose.place(origin, self.center),
            inertia: turned * self.inertia * turned.transpose(),
            ..self
        }
    }

    /// Whether some distribution of mass has them: the moments of its second order, `tr(I)/2 - I`, are those of a mass that is nowhere
    /// negative. There is room for what a user rounds off.
    pub(super) fn are_possible(&self) -> bool {
        let moments = second_moments(&self.inertia);
        let scale = 1e-3 * trace(&moments);
        let m = moments + DMat3::from_diagonal(DVec3::splat(scale));
        // all leading minors of a positive matrix are positive
        let minors = [
            m.x_axis.x,
            m.x_axis.x * m.y_axis.y - m.x_axis.y * m.y_axis.x,
            m.determinant(),
        ];
        scale > 0.0 && minors.iter().all(|minor| *minor > 0.0)
    }
}

/// `tr(M)/2 - M`: integrals of `x_i x_j dm` of a tensor of inertia.
fn second_moments(inertia: &DMat3) -> DMat3 {
    DMat3::from_diagonal(DVec3::splat(0.5 * trace(inertia))) - *inertia
}

/// Mass, centre and inertia of what a surface encloses, in the wall frame.
fn enclosed(surface: &Surface, density: f64) -> Result<MassProperties, WallError> {
    match surface {
        Surface::Mesh(mesh) => {
            let corners = mesh.closed_triangles()?;
            // parts count each for itself, whichever of them are drawn inside out
            let outwards = match Interior::new(&corners) {
                Ok(inside) => inside.outwards(&corners),
                Err(_) => corners,
            };
            within_triangles(outwards.into_iter(), mesh.centroid(), density).ok_or(WallError::NoVolume)
        }
        Surface::Shell(shell) if shell.side == Side::Outside => {
            let mass = density * 4.0 / 3.0 * PI * shell.radius.powi(3);
            Ok(MassProperties {
                mass,
                center: shell.center,
                inertia: DMat3::from_diagonal(DVec3::splat(0.4 * mass * shell.radius * shell.radius)),
            })
        }
        _ => Err(WallError::NotSolid),
    }
}

/// Sums over the tetrahedra between a point and each triangle, whose sign is that of the side on which the point lies; `None` where
/// nothing is enclosed. Of a tetrahedron of volume `V` with corners `0, a, b, c` and `s = a + b + c` the integral of `x` is `V s/4`, that of
/// `x x^T` is `V/20 (a a^T + b b^T + c c^T + s s^T)`.
fn within_triangles(triangles: impl Iterator<Item = [DVec3; 3]>, point: DVec3, density: f64) -> Option<MassProperties> {
    let (mut volume, mut first, mut second) = (0.0, DVec3::ZERO, DMat3::ZERO);
    let mut size = 0.0;
    for corners in triangles {
        let [a, b, c] = corners.map(|corner| corner - point);
        let tetrahedron = a.dot(b.cross(c)) / 6.0;
        let sum = a + b + c;
        volume += tetrahedron;
        size += tetrahedron.abs();
        first += sum * (tetrahedron / 4.0);
        let squares = [a, b, c, sum].map(square).into_iter().sum::<DMat3>();
        second += squares * (tetrahedron / 20.0);
    }
    // a mesh that is drawn inside out is turned round; what rounding leaves of a fold is no volume
    if volume.abs() <= 1e-12 * size || size == 0.0 {
        return None;
    }
    let (volume, first, second) = (volume.abs(), first * volume.signum(), second * volume.signum());
    let mean = first / volume;
    let about_center = (second - square(mean) * volume) * density;
    Some(MassProperties {
        mass: density * volume,
        center: point + mean,
        inertia: DMat3::from_diagonal(DVec3::splat(trace(&about_center))) - about_center,
    })
}

fn trace(matrix: &DMat3) -> f64 {
    matrix.x_axis.x + matrix.y_axis.y + matrix.z_axis.z
}

/// `v v^T`.
fn square(v: DVec3) -> DMat3 {
    DMat3::from_cols(v * v.x, v * v.y, v * v.z)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::particles::boxed;
    use crate::walls::shape::Shape;

    fn near(found: DMat3, exact: DMat3) -> bool {
        let differs = |k: usize| (found.col(k) - exact.col(k)).length();
        (0..3).all(|k| differs(k) < 1e-12 * exact.x_axis.length())
    }

    #[test]
    fn a_brick_has_the_mass_and_inertia_of_a_brick_wherever_it_stands_and_however_it_is_drawn() {
        let (lower, upper) = (DVec3::new(3.0, -1.0, 2.0), DVec3::new(4.0, 1.0, 2.5));
        let size = upper - lower;
        let mass = 2.0 * size.element_product();
        let moment = |a: f64, b: f64| mass * (a * a + b * b) / 12.0;
        let exact = DMat3::from_diagonal(DVec3::new(
            moment(size.y, size.z),
            moment(size.x, size.z),
            moment(size.x, size.y),
        ));
        let outside = boxed(lower, upper);
        let inside: Vec<[DVec3; 3]> = outside.iter().map(|[a, b, c]| [*a, *c, *b]).collect();
        for triangles in [outside, inside] {
            let surface = Surface::new(Shape::Mesh { triangles }).unwrap();
            let found = BodyMass::Density(2.0).of(&surface, DVec3::ZERO, &Pose::START).unwrap();
            assert!((found.mass - mass).abs() < 1e-12 && (found.center - 0.5 * (lower + upper)).length() < 1e-12);
            assert!(near(found.inertia, exact) && found.are_possible());
            // turned by a quarter about z, x and y change places
            let pose = Pose {
                translation: DVec3::X,
                rotation: super::super::pose::rotation_about(DVec3::Z, 0.5 * PI),
            };
            let origin = DVec3::new(3.0, 0.0, 0.0);
            let found = BodyMass::Density(2.0).of(&surface, origin, &pose).unwrap();
            let swapped = DVec3::new(exact.y_axis.y, exact.x_axis.x, exact.z_axis.z);
            assert!(near(found.inertia, DMat3::from_diagonal(swapped)));
            assert!(
                (found.center - DVec3::new(4.0, 0.5, 2.25)).length() < 1e-12,
                "{}",
                found.center
            );
        }
    }

    #[test]
    fn parts_of_a_mesh_add_whichever_way_they_face_and_holes_are_empty() {
        let inside_out = |part: Vec<[DVec3; 3]>| part.into_iter().map(|[a, b, c]| [a, c, b]).collect::<Vec<_>>();
        let cube = |from: DVec3, side: f64| boxed(from, from + side);
        let mass = |triangles: Vec<[DVec3; 3]>| {
            let surface = Surface::new(Shape::Mesh { triangles }).unwrap();
            BodyMass::Density(2.0).of(&surface, DVec3::ZERO, &Pose::START).unwrap()
        };
        let at = DVec3::new(3.0, 0.5, 0.5);
        let apart = mass([cube(DVec3::ZERO, 2.0), inside_out(cube(at, 1.0))].concat());
        assert!((apart.mass - 18.0).abs() < 1e-12, "{}", apart.mass);
        let center = (8.0 * DVec3::ONE + (at + 0.5)) / 9.0;
        assert!((apart.center - center).length() < 1e-12 && apart.are_possible());
        let hollow = mass([inside_out(cube(DVec3::ZERO, 2.0)), cube(DVec3::splat(0.5), 1.0)].concat());
        assert!((hollow.mass - 14.0).abs() < 1e-12, "{}", hollow.mass);
        // what overlaps counts for each of its parts
        let crossing = mass([cube(DVec3::ZERO, 2.0), inside_out(cube(DVec3::ONE, 2.0))].concat());
        assert!((crossing.mass - 32.0).abs() < 1e-12, "{}", crossing.mass);
    }

    #[test]
    fn what_encloses_nothing_has_no_density() {
        let of = |shape| BodyMass::Density(1.0).of(&Surface::new(shape).unwrap(), DVec3::ZERO, &Pose::START);
        let mut open = boxed(DVec3::ZERO, DVec3::ONE);
        open.pop();
        assert!(matches!(of(Shape::Mesh { triangles: open }), Err(WallError::Mesh(_))));
        let sphere = |side| Shape::Sphere {
            center: DVec3::X,
            radius: 2.0,
            side,
        };
        assert_eq!(of(sphere(Side::Inside)), Err(WallError::NotSolid));
        let ball = of(sphere(Side::Outside)).unwrap();
        assert!((ball.mass - 32.0 / 3.0 * PI).abs() < 1e-12 && ball.center == DVec3::X);
    }

    #[test]
    fn no_body_has_one_moment_larger_than_the_two_others() {
        let of = |moments: DVec3, xy: f64| {
            let mut inertia = DMat3::from_diagonal(moments);
            (inertia.x_axis.y, inertia.y_axis.x) = (xy, xy);
            let center = DVec3::ZERO;
            (MassProperties {
                mass: 1.0,
                center,
                inertia,
            })
            .are_possible()
        };
        // a thin plate and a rod lie at the limit
        assert!(of(DVec3::new(1.0, 1.0, 2.0), 0.0) && of(DVec3::new(1.0, 1.0, 0.0), 0.0));
        assert!(!of(DVec3::new(1.0, 1.0, 2.1), 0.0) && !of(DVec3::new(1.0, 1.0, -0.1), 0.0));
        assert!(of(DVec3::ONE, 0.4) && !of(DVec3::ONE, 0.6) && !of(DVec3::ZERO, 0.0));
    }
}
