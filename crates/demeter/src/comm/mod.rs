//! How grains meet across the borders of the domain.
//!
//! One process ([`Single`]) meets periodic images only. A contact across a border uses the *difference* of positions
//! plus a shift, never a shifted position, so that both partners see the same bits. Where the box deforms
//! ([`Rates`]), the shifts follow it, and a contact across a border adds the velocity of its shift to that of its grains.
//!
//! Several processes share a run through [`Ranks`]: each knows the grains that are its own, and those near these.

pub(crate) mod deforming;
pub(crate) mod parts;
mod ranks;
pub(crate) mod segment_sums;
mod single;
pub(crate) mod together;
pub(crate) mod tree;

pub(crate) use deforming::{Carry, Deforming};
pub use deforming::{Rates, ShearAxes};
pub use ranks::{Message, Ranks, Traffic};
pub use single::Single;
