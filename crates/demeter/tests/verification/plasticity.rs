//! Plastic and plastic-adhesive contacts in the engine: restitution, dents that last, books.

use crate::cases;

use crate::cases::{Case, Laws, advance, law, mass, on_threads, one_material, report, run_until_parted};
use demeter::simulation::Simulation;
use demeter::walls::{Motion, Shape};
use demeter_physics::DVec3;
use demeter_physics::contact::LawChoice;
use std::f64::consts::TAU;

/// What the issue asks of the engine.
const TOLERANCE: f64 = 1e-3;
const YOUNG_MODULUS: f64 = 1e8;
const RADIUS: f64 = 1e-3;
const K1: f64 = 2e4;
const K2: f64 = 1e5;

fn luding(adhesion: f64, more: &[(&str, f64)]) -> LawChoice {
    let mut given = vec![
        ("loading_stiffness", K1),
        ("unloading_stiffness", K2),
        ("adhesion_stiffness", adhesion),
        ("plastic_depth", 0.05),
    ];
    given.extend(more);
    law("luding", &given)
}

/// A partner of a grain of radius [`RADIUS`]: a grain of this radius, or a flat surface.
#[derive(Clone, Copy, Debug)]
enum Partner {
    Grain(f64),
    Plane,
    Mesh,
}

const PARTNERS: [Partner; 4] = [
    Partner::Grain(RADIUS),
    Partner::Grain(4.0 * RADIUS),
    Partner::Plane,
    Partner::Mesh,
];

impl Partner {
    /// Effective radius and mass.
    fn size(self) -> (f64, f64) {
        let m = mass(RADIUS);
        match self {
            Self::Grain(r) => (1.0 / (1.0 / RADIUS + 1.0 / r), 1.0 / (1.0 / m + 1.0 / mass(r))),
            _ => (RADIUS, m),
        }
    }
}

/// Restitution of a head-on collision; `phase` is where within a step the surfaces touch first. The surfaces count as
/// parted when the engine keeps no contact.
fn collide(choice: &LawChoice, partner: Partner, speed: f64, phase: f64) -> f64 {
    let mut case = Case::new(one_material(YOUNG_MODULUS, &Laws::of(choice.clone())));
    let v = DVec3::new(0.0, 0.0, -speed);
    case.grain(RADIUS, DVec3::new(0.0, 0.0, RADIUS), v);
    match partner {
        Partner::Grain(r) => {
            case.grain(r, DVec3::new(0.0, 0.0, -r), DVec3::ZERO);
        }
        Partner::Plane => case.plane(0, DVec3::ZERO, DVec3::Z),
        Partner::Mesh => {
            let a = 0.1;
            let triangle = [DVec3::new(-a, -a, 0.0), DVec3::new(a, -a, 0.0), DVec3::new(0.0, a, 0.0)];
            let triangles = vec![triangle];
            case.wall(0, Shape::Mesh { triangles }, Motion::Rest);
        }
    }
    case.max_overlap = 0.1;
    let mut setup = case.setup();
    setup.grains.position[0].z += speed * setup.dt * (5.0 + phase);
    let mut sim = Simulation::new(setup);
    run_until_parted(&mut sim);
    let residual = sim.energies().residual.abs();
    assert!(residual < TOLERANCE, "{choice:?}, {partner:?}: residual {residual}");
    let partner_speed = if let Partner::Grain(_) = partner {
        sim.grains().velocity[cases::index(&sim, 2)].z
    } else {
        0.0
    };
    (sim.grains().velocity[cases::index(&sim, 1)].z - partner_speed) / speed
}

/// Compares collisions with what is expected of effective radius, effective mass and speed.
fn check(name: &str, choice: &LawChoice, speeds: &[f64], expected: impl Fn(f64, f64, f64) -> f64 + Sync) {
    on_threads(1, || {
        let mut largest = 0.0f64;
        for partner in PARTNERS {
            for &speed in speeds {
                for phase in [0.0, 0.37, 0.81] {
                    let (radius, m) = partner.size();
                    let expected = expected(radius, m, speed);
                    let found = collide(choice, partner, speed, phase);
                    largest = largest.max((found - expected).abs());
                    assert!(
                        (found - expected).abs() < TOLERANCE,
                        "{name}, {partner:?}, {speed} m/s: {found} instead of {expected}"
                    );
                }
            }
        }
        report(&format!("largest error of {name}"), largest);
    });
}

#[test]
fn walton_braun_realises_its_restitution() {
    for e in [0.2, 0.6, 0.95] {
        let choice = law("walton-braun", &[("loading_stiffness", K1), ("restitution", e)]);
        check("walton-braun", &choice, &[0.02, 0.5], |_, _, _| e);
    }
    let growth = 3e4;
    let choice = law(
        "walton-braun",
        &[("loading_stiffness", K1), ("stiffness_growth", growth)],
    );
    check("walton-braun with growth", &choice, &[0.02, 0.5], |_, m, v| {
        1.0 / (1.0 + growth * v * (m / K1).sqrt()).sqrt()
    });
}

#[test]
fn luding_realises_the_restitution_of_its_lines() {
    for kc in [0.0, 4e3] {
        check("luding", &luding(kc, &[]), &[0.05, 0.4], |radius, m, v| {
            let limit = K2 / (K2 - K1) * 0.05 * 2.0 * radius;
            let depth = v * (m / K1).sqrt();
            assert!(depth < limit);
            let k2 = K1 + (K2 - K1) * depth / limit;
            (K1 / k2 - kc * (k2 - K1) * (k2 - K1) / (K1 * k2 * (k2 + kc))).sqrt()
        });
    }
}

#[test]
fn a_requested_restitution_is_realised_beside_plastic_and_adhesive_losses() {
    let (e, speed) = (0.5, 0.2);
    let request = [("restitution", e), ("impact_speed", speed)];
    check("luding on request", &luding(4e3, &request), &[speed], |_, _, _| e);
    let mut eepa = vec![("plasticity_ratio", 0.3), ("surface_energy", 0.02)];
    eepa.extend(request);
    check("eepa on request", &law("eepa", &eepa), &[speed], |_, _, _| e);
}

#[test]
fn eepa_realises_the_restitution_of_its_dent() {
    for ratio in [0.0, 0.4, 0.8] {
        let choice = law("eepa", &[("plasticity_ratio", ratio), ("surface_energy", 0.0)]);
        check("eepa", &choice, &[0.05, 0.3], |_, _, _| {
            let dent = libm::pow(ratio, 2.0 / 3.0);
            let back = 1.0 - dent * dent * dent.sqrt() - 2.5 * ratio * (1.0 - dent);
            (back / (1.0 - ratio)).sqrt()
        });
    }
}

/// A grain between a floor and a plate, both of which swing: the gap between them closes slowly and opens again while it
/// swings faster, so that the contacts are loaded, unloaded and reloaded without parting.
fn squeezed(choice: LawChoice, depth: f64, time: f64) -> Simulation {
    let mut case = Case::new(one_material(YOUNG_MODULUS, &Laws::of(choice)));
    case.grain(RADIUS, DVec3::new(0.0, 0.0, RADIUS), DVec3::ZERO);
    let half = 0.05;
    for (z, amplitude, frequency, phase) in [
        // displacement A (sin(w t + phase) - sin(phase)): the plate goes down and comes back, the floor swings about it
        (2.0 * RADIUS, DVec3::Z * depth, 0.5 / time, 0.25 * TAU),
        (0.0, DVec3::Z * 0.35 * depth, 3.5 / time, 0.0),
    ] {
        let shape = Shape::Rectangle {
            center: DVec3::Z * z,
            half_u: DVec3::X * half,
            half_v: DVec3::Y * half,
        };
        let motion = Motion::Oscillation {
            amplitude,
            frequency,
            phase,
        };
        case.wall(0, shape, motion);
    }
    case.simulation()
}

#[test]
fn a_dent_lasts_through_unloading_and_reloading() {
    on_threads(1, || {
        let choice = law(
            "walton-braun",
            &[("loading_stiffness", K1), ("unloading_stiffness", K2)],
        );
        let (depth, time) = (1e-5, 0.2);
        let mut sim = squeezed(choice, depth, time);
        // 1/2 k1 D^2 (1 - k1/k2) of each contact that has been
        let plastic = |peak: f64| 0.5 * K1 * peak * peak * (1.0 - K1 / K2);
        let (mut deepest, mut latest, mut lost) = ([0.0f64; 2], [0.0f64; 2], 0.0);
        let (mut unloaded, mut reloaded, mut largest) = (0, 0, 0.0f64);
        for _ in 0..(time / sim.dt()) as u64 {
            sim.step().unwrap();
            let (contacts, grain) = (&sim.contacts.walls, sim.grains().position[0]);
            for wall in 0..2 {
                // in the dent it touches without force: it is in the table, but does not act
                let mut found = contacts.iter().flat_map(|chunk| {
                    let here = (0..chunk.len()).filter(|&k| chunk.j[k] as usize == wall && chunk.is_engaged(k));
                    here.map(|k| (sim.contact(chunk, k), chunk.normal_force(k)))
                });
                let Some((contact, force)) = found.next() else {
                    // they parted: the next contact is a new one
                    lost += plastic(deepest[wall]);
                    (deepest[wall], latest[wall]) = (0.0, 0.0);
                    continue;
                };
                let d = contact.overlap;
                let peak = deepest[wall].max(d);
                let dent = (1.0 - K1 / K2) * peak;
                let expected = if d >= peak { K1 * d } else { (K2 * (d - dent)).max(0.0) };
                // beside a change of line the force is its mean over the step
                let rate =
                    sim.grains().velocity[0] - sim.walls[wall].velocity_at(grain - contact.normal * contact.lever_i);
                let window = rate.length() * sim.dt() + (d - latest[wall]).abs();
                let error = (force - expected).abs();
                assert!(
                    error <= K2 * window + 1e-7 * K2 * depth,
                    "wall {wall}: {force} N at {d} m after {peak} m, expected {expected} N"
                );
                if [0.0, dent, peak].iter().all(|kink| (d - kink).abs() > 2.0 * window) {
                    largest = largest.max(error / (K1 * depth));
                }
                unloaded += u32::from(d < peak - 0.05 * depth && d > dent && d < latest[wall]);
                reloaded += u32::from(d < peak - 0.05 * depth && d > dent && d > latest[wall]);
                (deepest[wall], latest[wall]) = (peak, d);
            }
        }
        lost += deepest.map(plastic).iter().sum::<f64>();
        assert!(
            unloaded > 100 && reloaded > 100,
            "{unloaded} steps of unloading, {reloaded} of reloading"
        );
        report("error of the force away from changes of line", largest);
        // a window ends a little beyond the place where the overlap turns round: the dent is that much deeper
        assert!(largest < 1e-6, "{largest}");
        let e = sim.energies();
        report("error of the plastic work", e.plastic_dissipated / lost - 1.0);
        assert!(
            (e.plastic_dissipated / lost - 1.0).abs() < TOLERANCE,
            "{} J instead of {lost}",
            e.plastic_dissipated
        );
        assert!(e.residual.abs() < TOLERANCE, "residual {}", e.residual);
    });
}

/// A packing of plastic grains, dropped and left to settle.
fn packing(choice: LawChoice) -> Simulation {
    let laws = Laws::of(choice).friction(law("linear-history", &[("friction", 0.4), ("stiffness", 5e3)]));
    let mut case = Case::new(one_material(YOUNG_MODULUS, &laws));
    let a = 14.0 * cases::beds::RADIUS;
    cases::beds::fill(&mut case, DVec3::ZERO, DVec3::splat(a), 80, 0.2);
    let walls = Shape::Box {
        lower: DVec3::ZERO,
        upper: DVec3::splat(a),
        open: [false; 6],
    };
    case.wall(0, walls, Motion::Rest);
    case.gravity = DVec3::new(0.0, 0.0, -cases::G);
    case.skin = 0.2 * cases::beds::RADIUS;
    case.max_overlap = 0.4;
    case.simulation()
}

#[test]
fn the_books_of_many_plastic_grains_close() {
    let eepa = [("plasticity_ratio", 0.5), ("surface_energy", 0.5), ("alpha", 0.2)];
    for (name, choice) in [
        (
            "walton-braun",
            law("walton-braun", &[("loading_stiffness", K1), ("restitution", 0.5)]),
        ),
        ("luding", luding(4e3, &[("damping", 0.01)])),
        ("eepa", law("eepa", &eepa)),
    ] {
        on_threads(1, || {
            let mut sim = packing(choice);
            let start = sim.energies().present();
            let mut largest = 0.0f64;
            for _ in 0..20 {
                advance(&mut sim, 2e-3);
                largest = largest.max(sim.energies().residual.abs());
            }
            let e = sim.energies();
            report(&format!("largest residual of {name}"), largest);
            assert!(largest < TOLERANCE, "{name}: residual {largest}");
            assert!(e.plastic_dissipated > 0.05 * start, "{name}: nothing yielded: {e:?}");
        });
    }
}
