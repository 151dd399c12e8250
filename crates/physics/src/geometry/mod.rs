//! Where a sphere touches another sphere or a surface. One file per pair of shapes.
//!
//! The functions for surfaces return the closest [`SurfacePoint`] to the centre of the sphere. They use nothing but
//! addition, multiplication, division and square roots, so they give the same bits on every machine. Lengths are in [m];
//! coordinates up to 1e100 m are safe from overflow.

pub mod contact_sphere_cone;
pub mod contact_sphere_cylinder;
pub mod contact_sphere_disc;
pub mod contact_sphere_plane;
pub mod contact_sphere_rectangle;
pub mod contact_sphere_shell;
pub mod contact_sphere_sphere;
pub mod contact_sphere_triangle;
pub mod surface_point;

pub use surface_point::{AT_END, Feature, Side, SurfacePoint};
