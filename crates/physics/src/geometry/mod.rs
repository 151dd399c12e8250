//! Where a sphere touches another sphere or a surface. One file per pair of shapes.

pub mod contact_sphere_sphere;
