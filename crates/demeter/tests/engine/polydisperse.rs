//! Powders of sizes 1:100 whose laws attract across gaps: no partner is missed, no memory lost, however often the candidates are
//! found anew.

use crate::cases::{Case, Laws, law, one_material, report};
use demeter::particles::{Domain, Outside};
use demeter::simulation::{Deformation, Drive, Setup, Simulation, Skin};
use demeter_physics::DVec3;
use std::collections::{BTreeMap, BTreeSet};

/// Radii of the smallest and the largest grains.
const SMALL: f64 = 1e-5;
const LARGE: f64 = 100.0 * SMALL;
const EDGE: f64 = 5.0 * LARGE;

/// Laws that attract: across a gap by van der Waals forces, by the neck of a contact until it tears, or with a dent.
fn laws() -> [(&'static str, Laws); 4] {
    let friction = || law("linear-history", &[("friction", 0.5), ("stiffness", 1.0)]);
    let tomas = law(
        "tomas",
        &[
            ("adhesion_force", 2e-7),
            ("adhesion_radius", 0.5 * SMALL),
            ("separation", 0.01 * SMALL),
            ("range", 30.0),
            ("micro_yield_strength", 1e5),
            ("kappa_p", 0.15),
            ("alpha", 0.3),
        ],
    );
    let surface = |name: &str| law(name, &[("work_of_adhesion", 5e-3), ("alpha", 0.3)]);
    let dense = law("sjkr", &[("cohesion_energy_density", 2e4), ("alpha", 0.3)]);
    [
        ("tomas", Laws::of(tomas).friction(friction())),
        ("jkr", Laws::of(surface("jkr")).friction(friction())),
        ("dmt", Laws::of(surface("dmt")).friction(friction())),
        ("sjkr", Laws::of(dense).friction(friction())),
    ]
}

/// Small grains in a shell around a few that are a hundred times as large, and some of sizes between, falling upon them: across
/// the sides of the box, too.
fn powder(laws: &Laws, skin: Skin) -> Setup {
    let mut case = Case::new(one_material(1e6, laws));
    case.domain = Domain {
        lower: DVec3::ZERO,
        upper: DVec3::splat(EDGE),
        periodic: [true; 3],
        outside: Outside::Stop,
    };
    let mut state = 4711u64;
    let mut uniform = move || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1u64 << 53) as f64
    };
    let centres = [
        DVec3::new(0.3 * LARGE, 0.5 * EDGE, 0.5 * EDGE),
        DVec3::new(0.6 * EDGE, 0.2 * EDGE, 0.6 * EDGE),
    ];
    let mut placed: Vec<(DVec3, f64)> = centres.iter().map(|&centre| (centre, LARGE)).collect();
    for centre in centres {
        let mut left = 300;
        while left > 0 {
            let direction = 2.0 * DVec3::new(uniform(), uniform(), uniform()) - 1.0;
            let radius = SMALL * libm::pow(12.0, uniform() * uniform());
            let place = centre + direction.normalize_or_zero() * (LARGE + radius * (1.002 + 0.4 * uniform()));
            let place = case.domain.wrapped(place);
            let is_free = placed
                .iter()
                .all(|(other, r)| case.domain.difference(place, *other).length() > 1.001 * (r + radius));
            if is_free && direction.length() < 1.0 {
                placed.push((place, radius));
                left -= 1;
            }
        }
    }
    for (k, &(place, radius)) in placed.iter().enumerate() {
        let (centre, speed) = match k {
            0 | 1 => (place, 0.0),
            _ => (centres[usize::from(k >= 302)], 0.1),
        };
        let inwards = case.domain.difference(centre, place).normalize_or_zero();
        let aside = DVec3::new(uniform(), uniform(), uniform()) - 0.5;
        case.grain(radius, place, speed * (inwards + 0.5 * aside));
    }
    case.max_overlap = 0.4;
    Setup { skin, ..case.setup() }
}

/// Ids of the pairs whose laws were asked in the latest step.
fn engaged(sim: &Simulation) -> BTreeSet<(u32, u32)> {
    let mut pairs = BTreeSet::new();
    for chunk in &sim.contacts.pairs {
        for k in (0..chunk.len()).filter(|&k| chunk.is_engaged(k)) {
            let ids = [chunk.i[k], chunk.j[k]].map(|g| sim.grains().id[g as usize]);
            pairs.insert((ids[0].min(ids[1]), ids[0].max(ids[1])));
        }
    }
    pairs
}

/// Asserts that all pairs closer than `reach` were asked, and tells how many there are.
fn compare_with_all_pairs(sim: &Simulation, name: &str, reach: f64) -> usize {
    let (grains, asked) = (sim.grains(), engaged(sim));
    let mut close = 0;
    for i in 0..grains.len() {
        for j in i + 1..grains.len() {
            let apart = sim.domain().difference(grains.position[i], grains.position[j]).length();
            if apart < grains.radius(i) + grains.radius(j) + reach {
                close += 1;
                let ids = (grains.id[i].min(grains.id[j]), grains.id[i].max(grains.id[j]));
                assert!(
                    asked.contains(&ids),
                    "{name}, step {}: {ids:?} at {apart:e} is missing",
                    sim.step
                );
            }
        }
    }
    close
}

fn tomas_reach(name: &str, sim: &Simulation) -> f64 {
    // only this law attracts surfaces that have never touched
    if name == "tomas" {
        0.99 * sim.largest_reach()
    } else {
        0.0
    }
}

#[test]
fn no_partner_within_reach_is_missed() {
    for (name, laws) in laws() {
        for deforms in [false, true] {
            let mut sim = Simulation::new(powder(&laws, Skin::Fixed(0.002 * SMALL)));
            if deforms {
                sim.deform(Deformation {
                    directions: [Drive::Fixed, Drive::StrainRate(-40.0), Drive::StrainRate(20.0)],
                    ..Deformation::default()
                })
                .unwrap();
            }
            let mut close = 0;
            for step in 1..=4000 {
                sim.step().unwrap();
                if step % 50 == 0 {
                    close += compare_with_all_pairs(&sim, name, tomas_reach(name, &sim));
                }
            }
            report(&format!("{name}: rebuilds"), sim.rebuilds() as f64);
            assert!(
                close > 1000 && sim.rebuilds() > 50,
                "{name}: {close} pairs, {} rebuilds",
                sim.rebuilds()
            );
        }
    }
}

/// A run whose candidates are found anew all the time has the bits of one that finds them once: no contact and no memory of
/// one is lost at a rebuild.
#[test]
fn rebuilds_change_no_bit() {
    for (name, laws) in laws() {
        let run = |skin: f64| {
            let mut sim = Simulation::new(powder(&laws, Skin::Fixed(skin)));
            sim.leave_order();
            for _ in 0..4000 {
                sim.step().unwrap();
            }
            let all = sim.contacts.carry(sim.grains());
            let carried: Vec<_> = all.iter().filter(|contact| contact.is_engaged).collect();
            let held = carried.iter().filter(|c| c.history.iter().any(|&h| h != 0.0)).count();
            let grains: BTreeMap<u32, String> = (0..sim.grains().len())
                .map(|g| {
                    let (velocity, spin) = (sim.grains().velocity[g], sim.grains().angular_velocity[g]);
                    (sim.grains().id[g], format!("{velocity:?} {spin:?}"))
                })
                .collect();
            (grains, format!("{carried:?}"), held, sim.rebuilds())
        };
        let (often, rarely) = (run(0.002 * SMALL), run(8.0 * SMALL));
        report(&format!("{name}: contacts that remember"), often.2 as f64);
        assert!(
            often.3 > 5 * rarely.3 && often.3 > 50,
            "{name}: {} and {} rebuilds",
            often.3,
            rarely.3
        );
        assert!(often.2 > 30, "{name}: only {} contacts remember something", often.2);
        assert!(often.1 == rarely.1, "{name}: contacts differ");
        assert!(often.0 == rarely.0, "{name}: grains differ");
    }
}
