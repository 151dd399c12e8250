//! How grains meet across the borders of the domain.
//!
//! One process ([`Single`]) meets periodic images only. A contact across a border uses the *difference* of positions
//! plus a shift, never a shifted position, so that both partners see the same bits.

mod single;

pub use single::Single;
