//! Experiments of the literature, simulated anew and compared with what was measured.
//!
//! [`hydrogel`]: 514 hydrogel grains that a plate squeezes (Brodu, Dijksman and Behringer, Phys. Rev. E 91, 032201, 2015),
//! with each of the five contact models of the paper. `validation/hydrogel/README.md` tells the results.
//!
//! [`dosta`]: the cross-code benchmark of Dosta et al. (Computer Physics Communications 296, 109066, 2024): a ball that falls
//! into a bed, a turning drum, a silo. `validation/dosta/README.md` tells the results.
//!
//! [`rheology`]: spheres sheared at a constant pressure, from fast to slow: the friction of dense granular flow (Jop, Forterre and
//! Pouliquen, Nature 441, 727, 2006). `validation/rheology/README.md` tells the results.
//!
//! [`bulk`]: laws of bulk solids that every engine must give: Beverloo, Janssen, the angle of repose. `validation/bulk/README.md`
//! tells the results.

pub mod bulk;
pub mod dosta;
mod folder;
pub mod hydrogel;
pub mod rheology;
mod runs;

pub use runs::{Job, JobError, Tell, carry_out_all};
