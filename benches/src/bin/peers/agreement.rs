//! Whether two engines did the same physics.

use crate::analysis::Physics;
use crate::workloads::Kind;
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

/// The tolerance of a workload; `damps_otherwise` for a peer whose dashpots are others. Reasons are in `benches/README.md`.
pub fn tolerance(kind: Kind, damps_otherwise: bool) -> Tolerance {
    let same = match kind {
        Kind::Bed | Kind::Column | Kind::Sizes => Tolerance {
            kinetic: 0.1,
            contacts: 0.01,
            force: 0.02,
        },
        Kind::Chute => Tolerance {
            kinetic: 0.01,
            contacts: 0.02,
            force: 0.05,
        },
        Kind::Drum => Tolerance {
            kinetic: 0.02,
            contacts: 0.02,
            force: 0.05,
        },
        Kind::Plate => Tolerance {
            kinetic: 0.05,
            contacts: 0.01,
            force: 0.05,
        },
    };
    if damps_otherwise {
        Tolerance {
            kinetic: same.kinetic.max(0.5),
            force: same.force.max(0.1),
            ..same
        }
    } else {
        same
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
        let tolerance = tolerance(Kind::Bed, false);
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
        for kind in [
            Kind::Bed,
            Kind::Column,
            Kind::Chute,
            Kind::Drum,
            Kind::Plate,
            Kind::Sizes,
        ] {
            let (same, other) = (tolerance(kind, false), tolerance(kind, true));
            assert!(other.kinetic >= same.kinetic && other.force >= same.force && other.contacts == same.contacts);
        }
    }
}
