//! Contact points lie on the deformed surfaces.

use super::influence::{MODELS, Model};
use super::reference::Adhesion;
use super::scenes::*;
use crate::cases::{Laws, law, report};
use demeter::simulation::Simulation;
use demeter_physics::DVec3;

const RADII: [f64; 2] = [1.0, 0.5];

fn planes() -> Vec<Plane> {
    vec![
        (DVec3::Z * -0.93, DVec3::Z),
        (DVec3::X * -0.94, DVec3::X),
        (DVec3::X * 0.95, -DVec3::X),
        (DVec3::Z * 1.91, -DVec3::Z),
    ]
}

/// A big grain pressed from four sides, one of them a small grain under a lid; both spin about x.
fn spinning(model: Model, spins: [f64; 2]) -> Simulation {
    let material = (1.0, 0.4);
    let laws = Laws::hertz(1.0).friction(law("coulomb", &[("friction", 0.3)]));
    let mut case = case_of(materials(model, material, material, &laws));
    for ((radius, z), spin) in RADII.into_iter().zip([0.0, 1.43]).zip(spins) {
        case.spinning_grain(radius, DVec3::Z * z, DVec3::ZERO, DVec3::X * spin);
    }
    for (point, normal) in planes() {
        case.plane(WALLS, point, normal);
    }
    started(case)
}

/// Force on the lower grain across the contact of both.
fn force(sim: &Simulation) -> DVec3 {
    let chunk = &sim.contacts.pairs[0];
    assert_eq!(chunk.len(), 1);
    chunk.force(0, sim.contact(chunk, 0).normal)
}

#[test]
fn torque_is_lever_times_force() {
    for model in MODELS {
        let sim = spinning(model, [0.3, 0.1]);
        assert_solved(&sim, model, &planes());
        let mut torque = vec![DVec3::ZERO; 2];
        for (wall, chunks) in [(false, &sim.contacts.pairs), (true, &sim.contacts.walls)] {
            for chunk in chunks {
                for k in 0..chunk.len() {
                    let contact = sim.contact(chunk, k);
                    let normal = contact.normal;
                    let force = chunk.force(k, normal);
                    assert_eq!(chunk.rolling_torque(k), DVec3::ZERO);
                    let of_first = (normal * -contact.lever_i).cross(force);
                    torque[chunk.i[k] as usize] += of_first;
                    if !wall {
                        let of_second = (normal * contact.lever_j).cross(-force);
                        torque[chunk.j[k] as usize] += of_second;
                        assert!(of_first.length() > 1e-4 && of_second.length() > 1e-4);
                    }
                }
            }
        }
        for (load, expected) in sim.grains().load.rows().iter().zip(torque) {
            let found = load.torque();
            // forces in the plane are told in singles
            let allowed = 2.0 * f64::from(f32::EPSILON) * expected.length();
            assert!((found - expected).length() < allowed, "{found} {expected}");
        }
    }
}

#[test]
fn levers_reach_to_the_middle_of_the_displaced_overlap() {
    for model in MODELS {
        let sim = spinning(model, [0.0; 2]);
        let packing = packing(&sim, model, &planes(), 0.2, Adhesion::default());
        let solution = packing.solve().unwrap();
        let pair = packing.touches.iter().position(|t| t.second.is_some()).unwrap();
        let (shift, d) = (solution.shift[pair], packing.touches[pair].distance);
        let contact = sim.contact(&sim.contacts.pairs[0], 0);
        // the formula of the notes, not that of the helper
        let first = 0.5 * (d + (RADII[0] + shift[0]) - (RADII[1] + shift[1]));
        approx::assert_relative_eq!(contact.lever_i, first, max_relative = 1e-11);
        approx::assert_relative_eq!(contact.lever_j, d - first, max_relative = 1e-11);
        let moved = first - 0.5 * (d + RADII[0] - RADII[1]);
        report(&format!("lever moved, {model:?}"), moved);
        assert!(model == Model::Independent || moved.abs() > 1e-4);
        for contact in found(&sim).iter().filter(|f| f.second.is_none()) {
            let at = sim.grains().position[contact.first];
            let away = |p: &Plane| (at - p.0).dot(p.1);
            let same = |p: &&Plane| (p.1 - contact.normal).length() < 1e-9;
            let distance = planes().iter().filter(same).map(away).fold(f64::INFINITY, f64::min);
            approx::assert_relative_eq!(contact.levers[0], distance, max_relative = 1e-14);
        }
    }
}

#[test]
fn spins_that_fit_the_displaced_levers_do_not_slide() {
    for model in MODELS {
        let sim = spinning(model, [0.0; 2]);
        let contact = sim.contact(&sim.contacts.pairs[0], 0);
        let across = |spins: [f64; 2]| {
            let force = force(&spinning(model, spins));
            force.reject_from_normalized(DVec3::Z).length()
        };
        let rolling = [1e-3, -1e-3 * contact.lever_i / contact.lever_j];
        let shift = 0.5 * (contact.lever_i + contact.lever_j - 1.43);
        assert!(shift.abs() < 1e-14);
        let undisplaced = 0.5 * (1.43 + RADII[0] - RADII[1]);
        let sliding = [1e-3, -1e-3 * undisplaced / (1.43 - undisplaced)];
        let (none, some) = (across(rolling), across(sliding));
        assert!(
            none < 1e-9 * force(&spinning(model, rolling)).length(),
            "{model:?} {none:e}"
        );
        assert!(
            model == Model::Independent || some > 1e6 * none,
            "{model:?} {some:e} {none:e}"
        );
    }
}
