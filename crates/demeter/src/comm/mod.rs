//! How grains meet across the borders of the domain.
//!
//! One process ([`Single`]) meets periodic images only. A contact across a border uses the *difference* of positions
//! plus a shift, never a shifted position, so that both partners see the same bits. Where the box deforms
//! ([`Rates`]), the shifts follow it, and a contact across a border adds the velocity of its shift to that of its grains.

mod deforming;
mod single;

pub(crate) use deforming::{Carry, Deforming};
pub use deforming::{Rates, ShearAxes};
pub use single::Single;
