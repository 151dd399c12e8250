//! The cases of the benchmark.

use super::DostaError;

/// What is simulated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A steel ball falls into a bed.
    Penetration,
    /// Two kinds of grains turn in a drum.
    Drum,
    /// A silo is filled and emptied.
    Silo(Orifice),
}

/// The two silos.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Orifice {
    /// Radius 20 mm.
    Small,
    /// Radius 30 mm.
    Large,
}

/// A case.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Case {
    /// Name: `silo-small-m1`.
    pub name: &'static str,
    /// What is simulated.
    pub kind: Kind,
    /// Scenario in `validation/dosta`.
    pub scenario: &'static str,
    /// Published files, in the folder of the data: walls, and grains where there are any.
    pub files: &'static [&'static str],
    /// Changes of the scenario.
    pub set: &'static [&'static str],
    /// Number of the stage that the time of the case is counted in: the last.
    pub last_stage: usize,
}

const M2: &str = "feed.filling.material=\"m2\"";
const STEP_M2: &str = "simulation.time_step=\"2e-6 s\"";
const COVER: &str = "wall.cover.center=\"0 0 -55.4222 mm\"";
const COVER_RADIUS: &str = "wall.cover.radius=\"31 mm\"";
const BELOW: &str = "removal.below.region.point=\"0 0 -75.4222 mm\"";
const LEFT: &str = "measure.left.region.point=\"0 0 -55.4222 mm\"";
const GATE: &str = "measure.orifice.gate.point=\"0 0 -55.4222 mm\"";

const fn penetration(name: &'static str, files: &'static [&'static str]) -> Case {
    Case {
        name,
        kind: Kind::Penetration,
        scenario: "penetration.toml",
        files,
        set: &[],
        last_stage: 0,
    }
}

const fn silo(
    name: &'static str,
    orifice: Orifice,
    files: &'static [&'static str],
    set: &'static [&'static str],
) -> Case {
    Case {
        name,
        kind: Kind::Silo(orifice),
        scenario: "silo.toml",
        files,
        set,
        last_stage: 2,
    }
}

/// All cases.
pub const CASES: [Case; 7] = [
    penetration(
        "penetration-25k",
        &["penetration/walls.txt", "penetration/particles-25k.txt"],
    ),
    penetration(
        "penetration-50k",
        &["penetration/walls.txt", "penetration/particles-50k.txt"],
    ),
    Case {
        name: "drum",
        kind: Kind::Drum,
        scenario: "drum.toml",
        files: &["drum/walls.txt", "drum/particles.txt"],
        set: &[],
        last_stage: 0,
    },
    silo("silo-small-m1", Orifice::Small, &["silo/walls-small.txt"], &[]),
    silo(
        "silo-small-m2",
        Orifice::Small,
        &["silo/walls-small.txt"],
        &[M2, STEP_M2],
    ),
    silo(
        "silo-large-m1",
        Orifice::Large,
        &["silo/walls-large.txt"],
        &[COVER, COVER_RADIUS, BELOW, LEFT, GATE],
    ),
    silo(
        "silo-large-m2",
        Orifice::Large,
        &["silo/walls-large.txt"],
        &[COVER, COVER_RADIUS, BELOW, LEFT, GATE, M2, STEP_M2],
    ),
];

/// The case of a name.
pub fn find_case(name: &str) -> Result<&'static Case, DostaError> {
    let unknown = || DostaError::UnknownCase { name: name.to_owned() };
    CASES.iter().find(|case| case.name == name).ok_or_else(unknown)
}
