//! The fold, beyond which the coupled equation has no solution.

use super::influence::{Ball, Model, Place};
use super::packings::disordered;
use super::scenes::*;
use crate::cases::{Case, Laws, law, on_threads, report};
use demeter::contacts::{Coupling, Fault};
use demeter::simulation::Simulation;
use demeter::walls::{Motion, Shape};
use demeter_physics::DVec3;

/// A packing in which all contacts carry one force.
#[derive(Clone, Copy)]
struct Regular {
    name: &'static str,
    /// Whether the partners are grains.
    grains: bool,
    build: fn(Case, f64) -> Case,
    /// Normals of the contacts of one grain.
    normals: fn() -> Vec<DVec3>,
    /// Compression at the fold in per cent, as published in three digits, for the prefactors 1 and 1.125.
    published: [f64; 2],
}

fn cubic_normals() -> Vec<DVec3> {
    vec![DVec3::X, DVec3::Y, DVec3::Z, -DVec3::X, -DVec3::Y, -DVec3::Z]
}

fn face_normals() -> Vec<DVec3> {
    let signs = [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)];
    let of = |(a, b): (f64, f64)| [DVec3::new(a, b, 0.0), DVec3::new(a, 0.0, b), DVec3::new(0.0, a, b)];
    signs.into_iter().flat_map(of).map(DVec3::normalize).collect()
}

const REGULAR: [Regular; 3] = [
    Regular {
        name: "simple cubic",
        grains: true,
        build: |c, q| lattice(c, 3, DVec3::splat(2.0 * (1.0 - q)), &SIMPLE_CUBIC),
        normals: cubic_normals,
        published: [11.1, 9.2],
    },
    Regular {
        name: "face-centred",
        grains: true,
        build: |c, q| lattice(c, 2, DVec3::splat(2.0 * 2f64.sqrt() * (1.0 - q)), &FACE_CENTRED),
        normals: face_normals,
        published: [5.67, 4.58],
    },
    Regular {
        name: "two plates",
        grains: false,
        build: |mut c, q| {
            c.grain(1.0, DVec3::ZERO, DVec3::ZERO);
            c.plane(WALLS, DVec3::Z * (q - 1.0), DVec3::Z);
            c.plane(WALLS, DVec3::Z * (1.0 - q), -DVec3::Z);
            c
        },
        normals: || vec![DVec3::Z, -DVec3::Z],
        published: [34.9, 31.0],
    },
];

impl Regular {
    /// Overlap per compression, stiffness of a contact, and displacement per force, at nu = 0.5.
    fn at(&self, gamma: f64, q: f64) -> (f64, f64, f64) {
        let ball = Ball {
            centre: DVec3::ZERO,
            radius: 1.0,
            young_modulus: 1.0,
            poisson_ratio: 0.5,
        };
        let normals = (self.normals)();
        let place = |normal: DVec3| Place { normal, lever: 1.0 - q };
        let to = place(normals[0]);
        let others = normals[1..]
            .iter()
            .map(|n| Model::HalfSpace(gamma).influence(&ball, place(*n), to));
        let sum: f64 = others.sum();
        let compliance = 0.75;
        match self.grains {
            true => (2.0, 4.0 / 3.0 / (2.0 * compliance) * 0.5f64.sqrt(), 2.0 * sum),
            false => (1.0, 4.0 / 3.0 / (compliance + 0.75e-15), sum),
        }
    }

    /// Largest overlap for which `y - b K y^(3/2)` still reaches it.
    fn beyond(&self, gamma: f64, q: f64) -> f64 {
        let (overlap, stiffness, b) = self.at(gamma, q);
        overlap * q - 4.0 / (27.0 * b * b * stiffness * stiffness)
    }

    fn fold(&self, gamma: f64) -> f64 {
        let (mut low, mut high) = (0.0, 0.6);
        for _ in 0..100 {
            let q = 0.5 * (low + high);
            *(if self.beyond(gamma, q) < 0.0 {
                &mut low
            } else {
                &mut high
            }) = q;
        }
        low
    }

    /// Force of every contact short of the fold: the lower root of `y - b K y^(3/2) = overlap`.
    fn force(&self, gamma: f64, q: f64) -> f64 {
        let (overlap, stiffness, b) = self.at(gamma, q);
        let steepness = b * stiffness;
        let (mut low, mut high) = (0.0, 4.0 / (9.0 * steepness * steepness));
        for _ in 0..200 {
            let y: f64 = 0.5 * (low + high);
            *(if y - steepness * y * y.sqrt() < overlap * q {
                &mut low
            } else {
                &mut high
            }) = y;
        }
        stiffness * low * low.sqrt()
    }
}

#[test]
fn the_fold_is_where_it_must_be() {
    for regular in REGULAR {
        for (gamma, published) in [1.0, 1.125].into_iter().zip(regular.published) {
            let fold = regular.fold(gamma);
            report(&format!("fold of {}, gamma {gamma}", regular.name), fold);
            let digit = if published < 9.0 { 0.01 } else { 0.1 };
            assert!(
                (100.0 * fold - published).abs() <= 0.5 * digit + 1e-3,
                "{} {gamma} {fold}",
                regular.name
            );
            for (coupling, accuracy) in [(EXACT, 1e-8), (Coupling::default(), 1e-3)] {
                let at = |q: f64| {
                    let mut case = (regular.build)(case(Model::HalfSpace(gamma), 0.5), q);
                    case.coupling = coupling;
                    let mut sim = case.simulation();
                    sim.start().map(|()| sim)
                };
                let below = 0.999 * fold;
                let sim = at(below).unwrap_or_else(|fault| panic!("{} {gamma}: {fault}", regular.name));
                let expected = regular.force(gamma, below);
                for contact in found(&sim).iter().filter(|f| f.force != 0.0) {
                    approx::assert_relative_eq!(contact.elastic, expected, max_relative = accuracy);
                }
                stays(sim, &regular);
                let fault = at(1.001 * fold).unwrap_err();
                assert_told(&fault, &regular, 1.001 * fold);
            }
        }
    }
}

/// Forces are mixed in search of a solution and may pull then; a law that never does has no jump that could excuse it.
#[test]
fn no_state_beyond_the_fold_is_taken_for_a_solution() {
    for regular in REGULAR {
        for gamma in [1.0, 1.125] {
            let fold = regular.fold(gamma);
            for thousandths in 1..=40 {
                let q = (1.0 + 1e-3 * f64::from(thousandths)) * fold;
                let mut case = (regular.build)(case(Model::HalfSpace(gamma), 0.5), q);
                case.coupling = EXACT;
                let fault = case.simulation().start().unwrap_err();
                assert_told(&fault, &regular, q);
            }
        }
    }
}

/// Where a run stops the forces of the step before displace, so that energies and overlaps belong together.
#[test]
fn the_books_close_where_a_run_stops_at_the_fold() {
    let mut case = case(Model::HalfSpace(1.0), 0.5);
    case.coupling = Coupling::default();
    // what the last step displaces too little is of the order of its length
    case.share = 1e-4;
    case.grain(1.0, DVec3::ZERO, DVec3::ZERO);
    for normal in [DVec3::Z, -DVec3::Z] {
        let plate = Shape::Plane {
            point: normal * -0.67,
            normal,
        };
        case.wall(WALLS, plate, Motion::Velocity(normal * 0.1));
    }
    let mut sim = case.simulation();
    let (mut before, mut after) = (0.0, sim.step());
    while after.is_ok() {
        before = sim.energies().elastic;
        after = sim.step();
    }
    assert!(matches!(after, Err(Fault::BeyondFold { .. })), "{after:?}");
    let energies = sim.energies();
    report("residual where a run stops at the fold", energies.residual);
    assert!(energies.residual.abs() < 1e-4, "{energies:?}");
    approx::assert_relative_eq!(energies.elastic, before, max_relative = 1e-2);
}

/// A packing that begins this near to the fold goes on as it began.
fn stays(mut sim: Simulation, regular: &Regular) {
    let began: Vec<f64> = found(&sim).iter().map(|contact| contact.elastic).collect();
    for _ in 0..5 {
        sim.step().unwrap_or_else(|fault| panic!("{}: {fault}", regular.name));
        for (contact, began) in found(&sim).iter().zip(&began) {
            approx::assert_relative_eq!(contact.elastic, *began, max_relative = 2e-2);
        }
    }
}

/// Laws that follow a path answer with the rounding of their integrals, which no iteration gets below.
#[test]
fn a_tolerance_near_rounding_is_no_fold() {
    on_threads(1, || {
        let choice = law("walton-braun", &[("loading_stiffness", 0.2), ("restitution", 0.5)]);
        let material = (1.0, 0.35);
        let mut case = case_of(materials(Model::HalfSpace(1.0), material, material, &Laws::of(choice)));
        assert_eq!(case.coupling, Coupling::Converged { tolerance: 1e-12 });
        let (balls, _) = disordered(14, 1.02, 0.66, 3);
        for (radius, place) in balls {
            case.grain(radius, place, DVec3::ZERO);
        }
        let mut sim = case.simulation();
        for _ in 0..20 {
            sim.step().unwrap();
        }
        assert!(found(&sim).iter().filter(|contact| contact.force > 0.0).count() > 14);
    });
}

/// The fault names grain, partner, strain and remedy.
fn assert_told(fault: &Fault, regular: &Regular, q: f64) {
    let Fault::BeyondFold {
        id,
        partner,
        strain,
        displacement_share,
        ..
    } = fault
    else {
        panic!("{}: {fault}", regular.name)
    };
    approx::assert_relative_eq!(*strain, q, max_relative = 1e-12);
    assert!(*displacement_share > 0.1 * q, "{fault}");
    let told = fault.to_string();
    for part in [
        format!("grain {id} "),
        partner.clone(),
        format!("{q:.4}"),
        "Remedy: compress less, lower `prefactor`".into(),
    ] {
        assert!(told.contains(&part), "{part}: {told}");
    }
    let kind = if regular.grains { "grain " } else { "wall " };
    assert!(partner.starts_with(kind) && partner != &format!("grain {id}"), "{told}");
}
