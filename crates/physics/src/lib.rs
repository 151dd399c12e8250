//! Formulas of the discrete element method, free of any engine.
//!
//! * [`dimension`] and [`parameters`]: what a law parameter is, its dimension and its allowed range.
//! * [`collision`]: head-on collisions with error control: restitution, contact time, sticking speed.
//! * [`contact`]: contact laws, one file each, in families (normal, tangential, rolling).
//! * [`restitution`]: exact maps between the restitution coefficient and damping.
//! * [`root`]: bracketed roots.
//! * [`geometry`]: where a sphere touches a surface.
//! * [`integrator`]: velocity Verlet and the rotation of a rigid sphere.
//!
//! Every quantity is SI. Nothing here knows of grains in number, neighbours, files or units.
//!
//! The book tells how a law is added (`book/src/adding-a-law.md`), and why contacts are taken over the window of a step
//! (`book/src/time-centred.md`); `cargo xtask book` makes it.

pub mod collision;
pub mod contact;
pub mod dimension;
pub mod geometry;
pub mod integrator;
pub mod lanes;
pub mod parameters;
pub mod restitution;
pub mod root;

pub use glam::{DQuat, DVec3};

/// The examples in the book's chapter on adding a law.
#[cfg(doctest)]
#[doc = include_str!("../../../book/src/adding-a-law.md")]
mod book {}
