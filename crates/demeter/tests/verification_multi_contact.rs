//! Contacts that feel each other, against exact solutions of the coupled equation in small symmetric cases
//! (`verification/README.md`).
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests")]

mod cases;

use approx::assert_relative_eq;
use cases::{Case, Laws, law, report};
use demeter::contacts::{Coupling, Fault};
use demeter::materials::{Material, Materials};
use demeter::particles::{Domain, Outside};
use demeter::simulation::Simulation;
use demeter_physics::DVec3;

/// Models by name and prefactor, with the column of the tables.
const MODELS: [(&str, f64); 4] = [
    ("independent", 1.0),
    ("sphere-to-sphere", 1.0),
    ("half-space", 1.0),
    ("half-space", 1.125),
];

const EXACT: Coupling = Coupling::Converged { tolerance: 1e-12 };

/// Grains of E = 1 and R = 1, and walls a thousand million times stiffer.
fn materials(model: (&str, f64), poisson_ratio: f64) -> Materials {
    let of = |name: &str, young_modulus: f64, poisson_ratio: f64| Material {
        name: name.into(),
        young_modulus,
        poisson_ratio,
        density: 1.0,
    };
    let mut laws = Laws::hertz(1.0);
    let prefactor: &[(&str, f64)] = if model.0 == "half-space" {
        &[("prefactor", model.1)]
    } else {
        &[]
    };
    laws.0.multi_contact = Some(law(model.0, prefactor));
    let list = vec![of("grains", 1.0, poisson_ratio), of("walls", 1e15, 0.5)];
    Materials::new(list, |_, _| laws.0.clone()).unwrap()
}

fn case(model: (&str, f64), poisson_ratio: f64) -> Case {
    let mut case = Case::new(materials(model, poisson_ratio));
    case.coupling = EXACT;
    case.max_overlap = 0.5;
    case.skin = 0.2;
    case.domain = Domain {
        lower: DVec3::splat(-10.0),
        upper: DVec3::splat(10.0),
        periodic: [false; 3],
        outside: Outside::Stop,
    };
    case
}

/// A lattice of `cells` cells of edge `edge` along every side, with these places in the cell, periodic.
fn lattice(mut case: Case, cells: u32, edge: DVec3, places: &[[f64; 3]]) -> Case {
    case.domain.lower = DVec3::ZERO;
    case.domain.upper = edge * f64::from(cells);
    case.domain.periodic = [true; 3];
    for cell in 0..cells * cells * cells {
        let corner = [cell % cells, cell / cells % cells, cell / cells / cells].map(f64::from);
        for place in places {
            let at = DVec3::from_array(std::array::from_fn(|k| corner[k] + place[k] + 0.25)) * edge;
            case.grain(1.0, at, DVec3::ZERO);
        }
    }
    case
}

const SIMPLE_CUBIC: [[f64; 3]; 1] = [[0.0; 3]];
const FACE_CENTRED: [[f64; 3]; 4] = [[0.0; 3], [0.0, 0.5, 0.5], [0.5, 0.0, 0.5], [0.5, 0.5, 0.0]];

fn face_centred(case: Case, cells: u32, strain: f64) -> Case {
    let edge = 2.0 * 2f64.sqrt() * (1.0 - strain);
    lattice(case, cells, DVec3::splat(edge), &FACE_CENTRED)
}

/// Normal forces of all contacts that push, with the normals.
fn forces(sim: &Simulation) -> Vec<(DVec3, f64)> {
    let chunks = sim.contacts.pairs.iter().chain(&sim.contacts.walls);
    let all = chunks.flat_map(|chunk| chunk.geometry().iter().zip(chunk.normal_force()));
    all.filter(|(_, force)| **force != 0.0)
        .map(|(contact, force)| (contact.normal, *force))
        .collect()
}

fn started(case: Case) -> Simulation {
    let mut sim = case.simulation();
    sim.start().unwrap();
    sim
}

/// All contacts carry one force.
fn assert_all(sim: &Simulation, contacts: usize, expected: f64) {
    let forces = forces(sim);
    assert_eq!(forces.len(), contacts);
    for (_, force) in forces {
        assert_relative_eq!(force, expected, max_relative = 1e-9);
    }
}

#[test]
fn one_grain_between_two_plates() {
    let expected = [
        0.0198761598,
        0.023_280_679_544_55,
        0.023_499_437_544_38,
        0.024_068_589_398_26,
    ];
    for (model, expected) in MODELS.into_iter().zip(expected) {
        let mut case = case(model, 0.5);
        case.grain(1.0, DVec3::ZERO, DVec3::ZERO);
        case.plane(1, DVec3::Z * -0.95, DVec3::Z);
        case.plane(1, DVec3::Z * 0.95, -DVec3::Z);
        assert_all(&started(case), 2, expected);
    }
}

#[test]
fn six_equal_contacts() {
    let expected = [
        0.0198761598,
        0.031_720_275_718_43,
        0.032_894_144_319_76,
        0.036_401_587_823_18,
    ];
    for (model, expected) in MODELS.into_iter().zip(expected) {
        let mut case = case(model, 0.5);
        case.grain(1.0, DVec3::ZERO, DVec3::ZERO);
        for normal in [DVec3::X, DVec3::Y, DVec3::Z] {
            case.plane(1, normal * -0.95, normal);
            case.plane(1, normal * 0.95, -normal);
        }
        assert_all(&started(case), 6, expected);
    }
}

#[test]
fn lattices_under_isotropic_strain() {
    let cubic = [
        0.005_028_314_888_438,
        0.006_507_014_915_687,
        0.006_548_552_324_851,
        0.006_823_671_337_114,
    ];
    let face = [
        0.005_028_314_888_438,
        0.007_724_501_634_619,
        0.007_819_890_887_979,
        0.008_492_574_020_389,
    ];
    for (k, model) in MODELS.into_iter().enumerate() {
        let edge = DVec3::splat(2.0 * 0.98);
        let sim = started(lattice(case(model, 0.5), 3, edge, &SIMPLE_CUBIC));
        assert_all(&sim, 3 * 27, cubic[k]);
        let sim = started(face_centred(case(model, 0.5), 2, 0.02));
        assert_all(&sim, 6 * 32, face[k]);
    }
}

#[test]
fn side_contacts_are_born_from_bulging() {
    let expected = [
        (0.0, 0.0198761598),
        (0.000_474_115_882_3, 0.023_399_173_074_7),
        (0.000_499_139_136_5, 0.023_628_861_952_7),
        (0.000_629_677_356_4, 0.024_258_631_567_9),
    ];
    for (model, (side, axial)) in MODELS.into_iter().zip(expected) {
        // held a rounding error apart, so that no side contact touches by itself
        let edge = DVec3::new(2.0 + 1e-14, 2.0 + 1e-14, 2.0 * 0.95);
        let sim = started(lattice(case(model, 0.5), 3, edge, &SIMPLE_CUBIC));
        let forces = forces(&sim);
        assert_eq!(forces.len(), if side > 0.0 { 81 } else { 27 });
        for (normal, force) in forces {
            let expected = if normal.z.abs() > 0.5 { axial } else { side };
            assert_relative_eq!(force, expected, max_relative = 2e-9);
        }
    }
}

#[test]
fn beyond_the_fold_there_is_a_clear_error() {
    for (gamma, fold) in [(1.0, 0.0567), (1.125, 0.0458)] {
        let at = |strain: f64| {
            let mut sim = face_centred(case(("half-space", gamma), 0.5), 2, strain).simulation();
            sim.start().map(|()| forces(&sim)[0].1)
        };
        let last = at(fold - 1e-4).unwrap();
        report(&format!("force at the fold, gamma {gamma}"), last);
        let fault = at(fold + 2e-4).unwrap_err();
        assert!(matches!(fault, Fault::BeyondFold { .. }), "{fault}");
        assert!(fault.to_string().contains("lower `prefactor`"), "{fault}");
    }
}
