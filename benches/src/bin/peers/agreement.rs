//! Whether two engines did the same physics.

use crate::analysis::Physics;
use serde::Serialize;

/// How far a peer may lie from Demeter, as shares of what Demeter found.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Tolerance {
    /// Of the kinetic energy.
    pub kinetic: f64,
    /// Of the contacts per grain.
    pub contacts: f64,
    /// Of the force on the bearing surface.
    pub force: f64,
    /// Of the kinetic energy, where the dashpots of the peer are others.
    pub kinetic_with_other_dashpots: f64,
}

/// Deviations of a peer from Demeter, as shares of what Demeter found, and whether they are tolerated.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Deviation {
    /// Of the kinetic energy.
    pub kinetic: f64,
    /// Of the contacts per grain.
    pub contacts: f64,
    /// Of the force on the bearing surface.
    pub force: f64,
    /// Whether all are within the tolerance.
    pub agrees: bool,
}

/// A bed at rest: the energy is what the jolt of the start leaves, a hundred-thousandth of that of a fall.
pub const AT_REST: Tolerance = Tolerance {
    kinetic: 0.1,
    contacts: 0.01,
    force: 0.03,
    kinetic_with_other_dashpots: 1.0,
};
/// The same with small grains, which rest on overlaps of nanometres that open and close.
pub const AT_REST_SMALL: Tolerance = Tolerance {
    contacts: 0.05,
    ..AT_REST
};
/// Grains that fall and hit each other: contacts are short, so their number and the load of the floor fluctuate.
pub const COLLAPSING: Tolerance = Tolerance {
    kinetic: 0.01,
    contacts: 0.03,
    force: 0.1,
    kinetic_with_other_dashpots: 0.03,
};
/// Dense flow: short and lasting contacts.
pub const FLOWING: Tolerance = Tolerance {
    kinetic: 0.01,
    contacts: 0.05,
    force: 0.05,
    kinetic_with_other_dashpots: 0.03,
};
/// A bed that is squeezed: the packing rearranges, each engine's in its own way.
pub const SQUEEZED: Tolerance = Tolerance {
    kinetic: 0.05,
    contacts: 0.01,
    force: 0.05,
    kinetic_with_other_dashpots: 0.15,
};

impl Tolerance {
    /// That of a peer whose dashpots are others: energies differ by what they dissipate.
    pub fn with_other_dashpots(self) -> Self {
        Self {
            kinetic: self.kinetic_with_other_dashpots,
            force: 2.0 * self.force,
            ..self
        }
    }
}

/// Compares what a peer found with what Demeter found.
pub fn compare(demeter: &Physics, peer: &Physics, tolerance: &Tolerance) -> Deviation {
    let share = |ours: f64, theirs: f64| (theirs - ours) / ours;
    let (kinetic, contacts) = (
        share(demeter.kinetic, peer.kinetic),
        share(demeter.contacts, peer.contacts),
    );
    let force = share(demeter.force, peer.force);
    // nothing agrees with what is not a number
    let within = |deviation: f64, most: f64| deviation.abs() <= most;
    Deviation {
        kinetic,
        contacts,
        force,
        agrees: within(kinetic, tolerance.kinetic)
            && within(contacts, tolerance.contacts)
            && within(force, tolerance.force),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const OURS: Physics = Physics {
        kinetic: 2.0,
        contacts: 2.5,
        force: 40.0,
    };

    #[test]
    fn each_quantity_can_disagree() {
        let tolerance = AT_REST;
        assert!(compare(&OURS, &OURS, &tolerance).agrees);
        let off = 1.001;
        let cases = [
            Physics {
                kinetic: 2.0 * (1.0 + off * tolerance.kinetic),
                ..OURS
            },
            Physics {
                contacts: 2.5 * (1.0 - off * tolerance.contacts),
                ..OURS
            },
            Physics {
                force: 40.0 * (1.0 + off * tolerance.force),
                ..OURS
            },
            Physics {
                kinetic: f64::NAN,
                ..OURS
            },
        ];
        for peer in cases {
            assert!(!compare(&OURS, &peer, &tolerance).agrees, "{peer:?}");
        }
        let near = compare(&OURS, &Physics { kinetic: 2.1, ..OURS }, &tolerance);
        assert!(near.agrees && (near.kinetic - 0.05).abs() < 1e-12);
    }

    #[test]
    fn other_dashpots_widen_what_depends_on_them() {
        for same in [AT_REST, AT_REST_SMALL, COLLAPSING, FLOWING, SQUEEZED] {
            let other = same.with_other_dashpots();
            assert!(other.kinetic > same.kinetic && other.force > same.force && other.contacts == same.contacts);
        }
    }
}
