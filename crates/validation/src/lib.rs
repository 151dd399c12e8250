//! Experiments of the literature, simulated anew and compared with what was measured.
//!
//! [`hydrogel`]: 514 hydrogel grains that a plate squeezes (Brodu, Dijksman and Behringer, Phys. Rev. E 91, 032201, 2015),
//! with each of the five contact models of the paper. `validation/hydrogel/README.md` tells the results.

pub mod hydrogel;
