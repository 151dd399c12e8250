//! Start states, made by Demeter and kept in a folder; made again only where their recipe has changed.

use crate::demeter_loop;
use crate::grains::{FIXED, Fault, Grain, State};
use crate::workloads::{FIXED_IN_CHUTE, GLASS, Kind, UNIT};
use demeter::simulation::Simulation;
use demeter_physics::DVec3;
use rand_pcg::Pcg64;
use rand_pcg::rand_core::{Rng, SeedableRng};
use std::fs;
use std::path::Path;

/// Grains of the unit that the columns of W6 repeat.
const COLUMNS: [(&str, [u32; 2]); 4] = [
    ("w6-10k", [1, 1]),
    ("w6-50k", [5, 1]),
    ("w6-200k", [5, 4]),
    ("w6-1m", [10, 10]),
];
/// Most grains of which YADE is given the state.
const MOST_FOR_YADE: usize = 200_000;
/// Edge of the cells by which the grains of a column are ordered [m].
const ORDER_CELL: f64 = 0.01;

/// A run from one state to others.
struct Pass {
    scenario: &'static str,
    overrides: &'static [&'static str],
    density: f64,
    /// Grains with ids up to this are fixed.
    fixed: u32,
    /// After so many further steps the grains are this state.
    legs: &'static [(u64, &'static str)],
    /// Box of these states [m]; of the scenario's domain where there is none.
    bounds: Option<[DVec3; 2]>,
}

const BED: Pass = Pass {
    scenario: include_str!("../../../peers/prepare/bed.toml"),
    overrides: &[],
    density: GLASS,
    fixed: 0,
    legs: &[(4000, "w1dyn"), (12_000, "w1set")],
    bounds: Some([DVec3::ZERO, DVec3::new(0.13, 0.13, 0.25)]),
};
const DRUM: Pass = Pass {
    scenario: include_str!("../../../peers/prepare/drum.toml"),
    overrides: &[],
    density: GLASS,
    fixed: 0,
    legs: &[(26_000, "w3")],
    bounds: None,
};
const SIZES_BOUNDS: Option<[DVec3; 2]> = Some([DVec3::ZERO, DVec3::new(0.0489, 0.0489, 0.10758)]);
const SIZES: [Pass; 2] = [
    Pass {
        scenario: include_str!("../../../peers/prepare/sizes.toml"),
        overrides: &[],
        density: GLASS,
        fixed: 0,
        legs: &[(12_000, "w5-pressed")],
        bounds: SIZES_BOUNDS,
    },
    Pass {
        scenario: Kind::Sizes.scenario(),
        overrides: &["grains[0].file=\"w5-pressed.data\"", "simulation.time_step=\"4 us\""],
        density: GLASS,
        fixed: 0,
        legs: &[(10_000, "w5")],
        bounds: SIZES_BOUNDS,
    },
];
const COLUMN: Pass = Pass {
    scenario: include_str!("../../../peers/prepare/column.toml"),
    overrides: &[],
    density: GLASS,
    fixed: 0,
    legs: &[(14_000, "w6-unit")],
    bounds: None,
};
/// The loose start falls together and swings; after 15 units of time the base bears the weight of the flow.
const CHUTE: Pass = Pass {
    scenario: Kind::Chute.scenario(),
    overrides: &[
        "grains[0].file=\"w2-start-base.data\"",
        "grains[1].file=\"w2-start-flow.data\"",
        "simulation.time_step=\"1 ms\"",
    ],
    density: UNIT,
    fixed: FIXED_IN_CHUTE,
    legs: &[(15_000, "w2")],
    bounds: None,
};

/// The recipe of a state and all that is made with it.
struct Recipe {
    name: &'static str,
    makes: &'static [&'static str],
    passes: &'static [Pass],
}

const RECIPES: [Recipe; 5] = [
    Recipe {
        name: "w1",
        makes: &["w1dyn", "w1set"],
        passes: &[BED],
    },
    Recipe {
        name: "w2",
        makes: &["w2"],
        passes: &[CHUTE],
    },
    Recipe {
        name: "w3",
        makes: &["w3"],
        passes: &[DRUM],
    },
    Recipe {
        name: "w5",
        makes: &["w5"],
        passes: &SIZES,
    },
    Recipe {
        name: "w6",
        makes: &["w6-10k", "w6-50k", "w6-200k", "w6-1m"],
        passes: &[COLUMN],
    },
];

impl Recipe {
    /// What the states depend on; they are made again when it is another than it was.
    fn text(&self) -> String {
        let passes = self
            .passes
            .iter()
            .map(|p| format!("{:?} {:?}\n{}", p.overrides, p.legs, p.scenario));
        let mut version = format!("{}: {:?} {COLUMNS:?}\n", self.name, self.makes);
        if self.name == "w2" {
            let lattice = (BASE, LAYER, FLOWING, LAYERS_APART, LOWEST_LAYER, SURFACE_SPEED, SPREAD);
            version += &format!("{lattice:?}\n");
        }
        version + &passes.collect::<String>()
    }
}

/// Makes the states of this name in a folder, unless they are there.
pub fn ensure(state: &str, folder: &Path) -> Result<(), Fault> {
    let recipe = RECIPES.iter().find(|r| r.makes.contains(&state));
    let recipe = recipe.ok_or_else(|| format!("nothing makes a state `{state}`"))?;
    let note = folder.join(format!("{}.recipe", recipe.name));
    if fs::read_to_string(&note).is_ok_and(|text| text == recipe.text()) {
        return Ok(());
    }
    fs::create_dir_all(folder)?;
    if recipe.name == "w2" {
        write_chute("w2-start-", &chute_start(), folder)?;
    }
    for pass in recipe.passes {
        run(pass, folder)?;
    }
    if recipe.name == "w6" {
        let unit = State::read(&folder.join("w6-unit.data"))?;
        for (name, repeats) in COLUMNS {
            write(name, &repeated(&unit, repeats), folder)?;
        }
    }
    fs::write(note, recipe.text())?;
    Ok(())
}

fn run(pass: &Pass, folder: &Path) -> Result<(), Fault> {
    let overrides: Vec<String> = pass.overrides.iter().map(|o| (*o).to_owned()).collect();
    let mut sim = demeter_loop::simulation(pass.scenario, folder, &overrides, pass.fixed)?;
    for (steps, name) in pass.legs {
        eprintln!(
            "making the state {name}: {steps} steps of {} grains",
            sim.grains().len()
        );
        sim.steps(*steps)?;
        let state = state_of(&sim, pass);
        if *name == "w2" {
            write_chute("w2", &state, folder)?;
        }
        write(name, &state, folder)?;
    }
    Ok(())
}

fn state_of(sim: &Simulation, pass: &Pass) -> State {
    let domain = sim.domain();
    let [lower, mut upper] = pass.bounds.unwrap_or([domain.lower, domain.upper]);
    let grains = demeter_loop::grains(sim);
    if pass.density == UNIT {
        // room for all that the flow may do in a run
        upper.z = (grains.iter().map(|g| g.position.z).fold(0.0, f64::max) + 12.0).ceil();
    }
    State {
        lower,
        upper,
        density: pass.density,
        grains,
    }
}

fn write(name: &str, state: &State, folder: &Path) -> Result<(), Fault> {
    fs::write(folder.join(format!("{name}.data")), state.data_file(name))?;
    if state.grains.len() <= MOST_FOR_YADE {
        fs::write(folder.join(format!("{name}.txt")), state.lines())?;
    }
    Ok(())
}

/// The grains of the chute as two files, since Demeter is told by file which grains are fixed.
fn write_chute(prefix: &str, state: &State, folder: &Path) -> Result<(), Fault> {
    for (name, fixed) in [("base", true), ("flow", false)] {
        let of_name = |g: &&Grain| (g.kind == FIXED) == fixed;
        let part = State {
            // a file of its own has one type only
            grains: state
                .grains
                .iter()
                .filter(of_name)
                .map(|g| Grain { kind: 1, ..*g })
                .collect(),
            ..*state
        };
        fs::write(folder.join(format!("{prefix}{name}.data")), part.data_file(name))?;
    }
    Ok(())
}

/// Columns and rows of fixed grains of the chute, of layers of flowing ones, and number of these.
const BASE: [u32; 2] = [40, 20];
const LAYER: [u32; 2] = [38, 19];
const FLOWING: u32 = 31_200;
/// Distance of the layers, and height of the lowest, in diameters.
const LAYERS_APART: f64 = 1.04;
const LOWEST_LAYER: f64 = 1.8;
/// Speed of the surface at the start, and spread of every velocity, in the units of the chute: near to the steady flow.
const SURFACE_SPEED: f64 = 9.0;
const SPREAD: f64 = 0.3;

/// A rough base of fixed grains and a loose lattice above it that flows with the profile of Bagnold,
/// `1 - (1 - z/h)^(3/2)`.
fn chute_start() -> State {
    let mut random = Pcg64::seed_from_u64(2_026_112_102);
    let mut symmetric = || 2.0 * ((random.next_u64() >> 11) as f64 / (1u64 << 53) as f64) - 1.0;
    let mut shift = |largest: f64| DVec3::new(symmetric(), symmetric(), symmetric()) * largest;
    let (wide, long) = (f64::from(BASE[1]), f64::from(BASE[0]));
    let layers = (FLOWING - 1) / (LAYER[0] * LAYER[1]);
    let height = LOWEST_LAYER + f64::from(layers) * LAYERS_APART;
    let mut grains = Vec::new();
    for k in 0..BASE[0] * BASE[1] {
        let place = DVec3::new(f64::from(k % BASE[0]) + 0.5, f64::from(k / BASE[0]) + 0.5, 0.5);
        // up and down only, so that fixed grains do not overlap
        grains.push((FIXED, place + shift(0.25) * DVec3::Z, DVec3::ZERO));
    }
    for k in 0..FLOWING {
        let (column, row) = (k % LAYER[0], k / LAYER[0] % LAYER[1]);
        let place = DVec3::new(
            f64::from(column) * long / f64::from(LAYER[0]) + 0.5,
            f64::from(row) * wide / f64::from(LAYER[1]) + 0.5,
            f64::from(k / (LAYER[0] * LAYER[1])) * LAYERS_APART + LOWEST_LAYER,
        );
        let place = place + shift(0.02);
        let below_surface = (1.0 - place.z / height).max(0.0);
        let speed = SURFACE_SPEED * (1.0 - below_surface * below_surface.sqrt());
        // uniform, with the deviation asked for
        grains.push((1, place, DVec3::X * speed + shift(SPREAD * 3f64.sqrt())));
    }
    let number = |(k, (kind, position, velocity))| Grain {
        id: k as u32 + 1,
        kind,
        diameter: 1.0,
        position,
        velocity,
        spin: DVec3::ZERO,
    };
    State {
        lower: DVec3::new(0.0, 0.0, -1.0),
        upper: DVec3::new(long, wide, height + 12.0),
        density: UNIT,
        grains: grains.into_iter().enumerate().map(number).collect(),
    }
}

/// A periodic bed repeated along x and y, at rest, its grains ordered by cells, layer by layer.
fn repeated(unit: &State, [along_x, along_y]: [u32; 2]) -> State {
    let size = unit.upper - unit.lower;
    let mut grains = Vec::new();
    for j in 0..along_y {
        for i in 0..along_x {
            let shift = DVec3::new(f64::from(i) * size.x, f64::from(j) * size.y, 0.0);
            grains.extend(unit.grains.iter().map(|g| Grain {
                position: g.position + shift,
                velocity: DVec3::ZERO,
                spin: DVec3::ZERO,
                ..*g
            }));
        }
    }
    let cell = |g: &Grain| {
        let c = (g.position / ORDER_CELL).floor();
        [c.z as i64, c.y as i64, c.x as i64]
    };
    grains.sort_by_cached_key(|g| cell(g));
    for (k, grain) in grains.iter_mut().enumerate() {
        grain.id = k as u32 + 1;
    }
    State {
        lower: unit.lower,
        upper: DVec3::new(
            unit.lower.x + f64::from(along_x) * size.x,
            unit.lower.y + f64::from(along_y) * size.y,
            ((unit.top() + 0.01) * 100.0).ceil() / 100.0,
        ),
        density: unit.density,
        grains,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::judge;
    use crate::workloads::{EngineWalls, WORKLOADS};

    #[test]
    fn every_workload_has_a_recipe_that_makes_its_state() {
        for workload in WORKLOADS {
            assert!(
                RECIPES.iter().any(|r| r.makes.contains(&workload.state)),
                "{}",
                workload.key
            );
        }
        assert!(ensure("w9", Path::new("no/such/folder")).is_err());
    }

    #[test]
    fn a_state_is_written_by_a_run_and_read_back() {
        let folder = tempfile::tempdir().unwrap();
        let pass = Pass {
            overrides: &["grains[0].count=600"],
            legs: &[(40, "first"), (0, "same")],
            ..BED
        };
        run(&pass, folder.path()).unwrap();
        let first = State::read(&folder.path().join("first.data")).unwrap();
        assert_eq!(first.grains.len(), 600);
        assert_eq!(first.upper, DVec3::new(0.13, 0.13, 0.25));
        assert!(
            first
                .grains
                .iter()
                .all(|g| g.velocity.z < 0.3 && g.velocity.length() > 0.0)
        );
        assert_eq!(State::read(&folder.path().join("same.data")).unwrap(), first);
        assert_eq!(
            fs::read_to_string(folder.path().join("first.txt")).unwrap(),
            first.lines()
        );
    }

    #[test]
    fn the_lattices_have_all_their_grains() {
        for (pass, count) in [(&BED, 20_000), (&DRUM, 20_000), (&COLUMN, 10_000)] {
            let sim = demeter_loop::simulation(pass.scenario, Path::new("."), &[], 0).unwrap();
            assert_eq!(sim.grains().len(), count);
        }
    }

    #[test]
    fn a_repeated_bed_has_the_same_contacts_per_grain() {
        let unit = State {
            lower: DVec3::new(0.0, 0.0, -0.01),
            upper: DVec3::new(0.1, 0.1, 0.4),
            ..chute_start()
        };
        let shrunk = |g: &Grain| Grain {
            diameter: 3.2e-3,
            position: g.position * DVec3::new(0.1 / 40.0, 0.1 / 20.0, 0.0025),
            ..*g
        };
        let unit = State {
            grains: unit.grains[800..2000].iter().map(shrunk).collect(),
            ..unit
        };
        let big = repeated(&unit, [3, 2]);
        assert_eq!(big.grains.len(), 7200);
        assert!((big.upper - DVec3::new(0.3, 0.2, big.upper.z)).length() < 1e-12 && big.upper.z > big.top());
        assert!(
            big.grains
                .iter()
                .enumerate()
                .all(|(k, g)| g.id == k as u32 + 1 && g.velocity == DVec3::ZERO)
        );
        let w6 = WORKLOADS.iter().find(|w| w.key == "w6-10k").unwrap();
        let (one, many) = (
            judge(&unit.grains, &w6.scene(&unit, 0, EngineWalls::PLAIN)),
            judge(&big.grains, &w6.scene(&big, 0, EngineWalls::PLAIN)),
        );
        assert!(
            one.contacts > 0.1 && (one.contacts - many.contacts).abs() < 1e-12,
            "{one:?} {many:?}"
        );
    }

    #[test]
    fn the_chute_starts_with_a_base_and_a_flow_that_do_not_overlap_much() {
        let start = chute_start();
        let fixed = start.grains.iter().filter(|g| g.kind == FIXED).count();
        assert_eq!((fixed, start.grains.len()), (FIXED_IN_CHUTE as usize, 32_000));
        assert!(
            start.grains[..fixed]
                .iter()
                .all(|g| g.kind == FIXED && g.id <= FIXED_IN_CHUTE)
        );
        let folder = tempfile::tempdir().unwrap();
        write_chute("x-", &start, folder.path()).unwrap();
        let flow = State::read(&folder.path().join("x-flow.data")).unwrap();
        assert_eq!((flow.grains.len(), flow.grains[0].id), (31_200, 801));
        assert!(flow.grains.iter().all(|g| g.kind == 1 && g.position.z > 1.5));
    }
}
