//! What every registered law must do, tested by walking the registry: nobody writes these tests for a new law.
//!
//! * [`registry`]: names, documentation, declared ranges
//! * [`normal_laws`]: energy, stiffness, gaps, the mean over the window, cycles, dimensions
//! * [`memory_laws`]: the same for laws with memory, and for those that act across a gap, along random paths
//! * [`collisions`]: restitution and energy of head-on collisions in the engine's own scheme
//! * [`planar_laws`]: bound, direction, symmetries, dimensions, history of friction and rolling laws
//! * [`planar_energy`]: what friction and rolling laws store, return and dissipate
//! * [`wide_laws`]: the same bits for several contacts at a time as for one
//! * [`multi_contact`]: bounds, symmetry, dimensions of multi-contact laws, what they depend on
//! * [`coupled_contacts`]: their exact forces in symmetric packings
//!
//! `DEMETER_LAW=NAME` asks the laws of this name alone.

pub(crate) mod cases;
mod collisions;
mod coupled_contacts;
mod memory_laws;
mod multi_contact;
mod normal_laws;
mod planar;
mod planar_energy;
mod planar_laws;
mod registry;
mod wide_laws;

use super::LawInfo;

/// Those of a family's laws that are tested.
fn tested(laws: &'static [LawInfo]) -> impl Iterator<Item = &'static LawInfo> {
    let alone = std::env::var("DEMETER_LAW").ok();
    if let Some(name) = &alone {
        assert!(super::laws().any(|info| info.name == name), "no law is called `{name}`");
    }
    laws.iter()
        .filter(move |info| alone.as_ref().is_none_or(|name| name == info.name))
}
