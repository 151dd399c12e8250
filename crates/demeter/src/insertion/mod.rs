//! Where grains come from: files, lattices, random packings, size distributions.

mod spec;

pub use spec::{Amount, Basis, Insertion, LatticeKind, Region, SizeDistribution, Source};
