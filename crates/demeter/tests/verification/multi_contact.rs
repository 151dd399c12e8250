//! Contacts that feel each other: solutions of the coupled equation against exact values and against an independent
//! solver; contacts that are born from bulging; contacts that must not be missed; levers; the fold
//! (`verification/README.md`).

mod adhesion;
mod all_pairs;
mod births;
mod fold;
mod fold_in_a_run;
mod influence;
mod lattices;
mod levers;
mod packings;
mod reference;
mod scenes;

use approx::assert_relative_eq;
use demeter::simulation::Simulation;
use demeter_physics::DVec3;
use influence::MODELS;
use scenes::{FACE_CENTRED, SIMPLE_CUBIC, case, found, lattice, started};

/// All contacts carry one force.
fn assert_all(sim: &Simulation, contacts: usize, expected: f64) {
    let mut forces = found(sim);
    forces.retain(|f| f.force != 0.0);
    assert_eq!(forces.len(), contacts);
    for found in forces {
        assert_relative_eq!(found.elastic, expected, max_relative = 1e-9 + found.rounding);
    }
}

#[test]
fn one_grain_between_two_plates() {
    let expected = [
        0.0198761598,
        0.018_011_230_711_8,
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
        0.023_266_862_441_23,
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
        0.005_532_852_770_098,
        0.006_507_014_915_687,
        0.006_548_552_324_851,
        0.006_823_671_337_114,
    ];
    let face = [
        0.005_028_314_888_438,
        0.006_350_214_654_899,
        0.007_724_501_634_619,
        0.007_819_890_887_979,
        0.008_492_574_020_389,
    ];
    for (k, model) in MODELS.into_iter().enumerate() {
        let edge = DVec3::splat(2.0 * 0.98);
        let sim = started(lattice(case(model, 0.5), 3, edge, &SIMPLE_CUBIC));
        assert_all(&sim, 3 * 27, cubic[k]);
        let sim = started(lattice(case(model, 0.5), 2, edge * 2f64.sqrt(), &FACE_CENTRED));
        assert_all(&sim, 6 * 32, face[k]);
    }
}

#[test]
fn side_contacts_are_born_from_bulging() {
    let expected = [
        (0.0, 0.0198761598),
        (0.000_410_389_570_2, 0.018_100_361_277_1),
        (0.000_474_115_882_3, 0.023_399_173_074_7),
        (0.000_499_139_136_5, 0.023_628_861_952_7),
        (0.000_629_677_356_4, 0.024_258_631_567_9),
    ];
    for (model, (side, axial)) in MODELS.into_iter().zip(expected) {
        // held a rounding error apart, so that no side contact touches by itself
        let edge = DVec3::new(2.0 + 1e-14, 2.0 + 1e-14, 2.0 * 0.95);
        let sim = started(lattice(case(model, 0.5), 3, edge, &SIMPLE_CUBIC));
        let mut forces = found(&sim);
        forces.retain(|f| f.force != 0.0);
        assert_eq!(forces.len(), if side > 0.0 { 81 } else { 27 });
        for found in forces {
            let expected = if found.normal.z.abs() > 0.5 { axial } else { side };
            assert_relative_eq!(found.elastic, expected, max_relative = 2e-9 + found.rounding);
        }
    }
}
