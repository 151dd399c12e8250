//! Oblique elastic impact: what each tangential law makes of it, against the exact solution.

pub mod impact;
pub mod maw;

use crate::cases::{Laws, full, law, on_threads, report};
use demeter::materials::Material;
use demeter_physics::DVec3;
use demeter_physics::contact::LawChoice;
use impact::{Approach, Body, of_spheres, on_wall};
use maw::Impact;

const FRICTION: f64 = 0.3;
const RADIUS: f64 = 5e-3;
/// Normal approach speed [m/s]: overlaps of some 4e-4 of the radius.
const SPEED: f64 = 0.1;
const DENSITY: f64 = 2500.0;
const YOUNG_MODULUS: f64 = 70e9;
const POISSON_RATIOS: [f64; 4] = [0.0, 0.1, 0.3, 0.5];

/// Non-dimensional angles of incidence: from nearly normal impact to gross sliding, beyond `4 chi - 1 = 6` at `nu = 0`.
fn angles() -> Vec<f64> {
    if full() {
        let steps = 48;
        let ratio = |k: i32| f64::from(k) / f64::from(steps);
        (0..=steps).map(|k| 0.05 * libm::pow(160.0, ratio(k))).collect()
    } else {
        vec![0.05, 0.1, 0.2, 0.5, 0.9, 1.3, 2.0, 3.0, 4.0, 5.0, 8.0]
    }
}

fn exact(poisson_ratio: f64) -> Impact {
    let (annuli, steps) = if full() { (48, 1200) } else { (20, 500) };
    Impact::of_solid_spheres(poisson_ratio, annuli, steps)
}

// The reference itself.

#[test]
fn the_reference_slides_throughout_beyond_four_chi_less_one() {
    // Maw, Barber and Fawcett (1976): the impulse is mu times that of the normal force, psi_2 = psi_1 - 4 chi
    for poisson_ratio in POISSON_RATIOS {
        let reference = Impact::of_solid_spheres(poisson_ratio, 20, 500);
        let boundary = 4.0 * reference.chi() - 1.0;
        let departure = |incidence: f64| reference.reflection(incidence) - (incidence - 4.0 * reference.chi());
        for beyond in [0.05, 0.5, 3.0] {
            let error = departure(boundary + beyond);
            assert!(error.abs() < 1e-4, "{poisson_ratio}: {error:e} at {beyond} beyond");
        }
        // before it, some of the contact sticks at the end
        assert!(departure(boundary - 0.3) > 1e-3, "{poisson_ratio}");
    }
}

#[test]
fn the_reference_converges_with_the_number_of_annuli() {
    for poisson_ratio in [0.0, 0.3, 0.5] {
        for incidence in [0.05, 0.2, 0.8, 1.2, 2.0, 3.5] {
            let restitution = |annuli: usize| {
                Impact::of_solid_spheres(poisson_ratio, annuli, 25 * annuli).reflection(incidence) / -incidence
            };
            let (coarse, middle, fine) = (restitution(12), restitution(24), restitution(48));
            let label = format!("nu {poisson_ratio}, psi {incidence}: {coarse} {middle} {fine}");
            assert!((coarse - fine).abs() < 8e-3, "{label}");
            assert!((middle - fine).abs() < 3e-3, "{label}");
        }
    }
}

#[test]
fn the_reference_has_the_features_that_were_published() {
    // Maw, Barber and Fawcett (1976): a sphere at nu = 0.3 has chi = 1.44; the curve has its minimum while the contact
    // still sticks for a part of the time, and psi_2 = -1 where gross sliding begins
    let sphere = Impact::of_solid_spheres(0.3, 20, 500);
    assert!((sphere.chi() - 1.44).abs() < 5e-3);
    let start = 4.0 * sphere.chi() - 1.0;
    assert!((sphere.reflection(start) + 1.0).abs() < 1e-3);
    let lowest = (10..80)
        .map(|k| 0.1 * f64::from(k))
        .min_by(|&a, &b| sphere.reflection(a).total_cmp(&sphere.reflection(b)))
        .unwrap();
    assert!(lowest > 3.0 && lowest < start, "lowest at {lowest}");
    assert!(sphere.reflection(lowest) < -1.4);
    // Maw, Barber and Fawcett, Mech. Res. Commun. 4 (1977) 17: a disc cut from a sphere at nu = 0.28 has chi = 1.2558,
    // and psi_2 is negative at small psi_1, against the prediction of a rigid body
    let disc = Impact::of_disc(0.28, 20, 500);
    assert!((disc.chi() - 1.2558).abs() < 1e-4);
    for incidence in [0.1, 0.3, 0.6, 1.0] {
        let reflected = disc.reflection(incidence);
        assert!(reflected < 0.0, "{reflected} at {incidence}");
    }
}

#[test]
fn the_reference_never_gives_energy() {
    for poisson_ratio in POISSON_RATIOS {
        let reference = Impact::of_solid_spheres(poisson_ratio, 20, 500);
        for incidence in [0.02, 0.1, 0.5, 1.0, 2.0, 4.0] {
            let share = reference.reflection(incidence) / incidence;
            assert!(share.abs() < 1.0, "{poisson_ratio}, {incidence}: {share}");
        }
    }
}

// The laws.

fn material(poisson_ratio: f64) -> Material {
    Material {
        name: format!("nu {poisson_ratio}"),
        young_modulus: YOUNG_MODULUS,
        poisson_ratio,
        density: DENSITY,
    }
}

#[derive(Clone, Copy, PartialEq, Debug)]
enum Partner {
    Wall,
    Grain,
}

/// Ratio of tangential to normal stiffness of a Hertz-Mindlin contact of equal materials.
fn kappa(poisson_ratio: f64) -> f64 {
    2.0 * (1.0 - poisson_ratio) / (2.0 - poisson_ratio)
}

/// Tangential restitution of the points that touch, in the engine.
fn restitution(choice: &LawChoice, poisson_ratio: f64, incidence: f64, partner: Partner, speed: f64) -> f64 {
    let tangential = incidence * FRICTION / kappa(poisson_ratio) * speed;
    let laws = Laws::hertz(1.0).friction(choice.clone());
    let body = |share: f64| Body {
        radius: RADIUS,
        velocity: DVec3::new(tangential, 0.0, -speed) * share,
        spin: DVec3::ZERO,
    };
    let material = material(poisson_ratio);
    let left = match partner {
        Partner::Wall => on_wall(material.clone(), material, &laws, body(1.0)).surface_velocity(-DVec3::Z),
        Partner::Grain => {
            let [above, below] = of_spheres(material, &laws, [body(0.5), body(-0.5)]);
            above.surface_velocity(-DVec3::Z) - below.surface_velocity(DVec3::Z)
        }
    };
    -left.x / tangential
}

/// Stiffness of a spring that keeps the ratio `kappa` to a linear normal spring of the same contact time as Hertz.
fn matched_stiffness(poisson_ratio: f64, partner: Partner) -> f64 {
    let sphere = DENSITY * 4.0 / 3.0 * std::f64::consts::PI * RADIUS * RADIUS * RADIUS;
    let share = match partner {
        Partner::Wall => 1.0,
        Partner::Grain => 0.5,
    };
    let approach = Approach {
        mass: share * sphere,
        radius: share * RADIUS,
        modulus: YOUNG_MODULUS / (2.0 * (1.0 - poisson_ratio * poisson_ratio)),
        speed: SPEED,
    };
    kappa(poisson_ratio) * approach.matched_stiffness()
}

/// A law as it is measured, with the error that it may make: of the restitution, at any angle and any `nu`.
struct Measured {
    label: &'static str,
    law: &'static str,
    damping_ratio: Option<f64>,
    /// The worst error lies between these.
    worst: (f64, f64),
}

const MEASURED: &[Measured] = &[
    Measured {
        label: "mindlin-deresiewicz",
        law: "mindlin-deresiewicz",
        damping_ratio: None,
        worst: (0.0, 0.03),
    },
    Measured {
        label: "mindlin-history, undamped",
        law: "mindlin-history",
        damping_ratio: Some(0.0),
        worst: (0.4, 0.5),
    },
    Measured {
        label: "mindlin-history, damping_ratio 0.1",
        law: "mindlin-history",
        damping_ratio: Some(0.1),
        worst: (0.4, 0.5),
    },
    Measured {
        label: "linear-history, undamped",
        law: "linear-history",
        damping_ratio: Some(0.0),
        worst: (0.45, 0.55),
    },
    Measured {
        label: "coulomb",
        law: "coulomb",
        damping_ratio: None,
        worst: (0.55, 0.65),
    },
];

impl Measured {
    fn choice(&self, poisson_ratio: f64, partner: Partner) -> LawChoice {
        let mut choice = law(self.law, &[("friction", FRICTION)]);
        if let Some(damping_ratio) = self.damping_ratio {
            choice.parameters.insert("damping_ratio".into(), damping_ratio.into());
        }
        if self.law == "linear-history" {
            let stiffness = matched_stiffness(poisson_ratio, partner);
            choice.parameters.insert("stiffness".into(), stiffness.into());
        }
        choice
    }
}

/// Largest error at one Poisson's ratio, over angles and partners, and where it lies.
fn worst_error(measured: &Measured, poisson_ratio: f64, expected: &[(f64, f64)], speed: f64) -> (f64, String) {
    let mut worst = (0.0f64, String::new());
    for partner in [Partner::Wall, Partner::Grain] {
        let choice = measured.choice(poisson_ratio, partner);
        for (incidence, expected) in expected {
            let error = restitution(&choice, poisson_ratio, *incidence, partner, speed) - expected;
            if error.abs() > worst.0.abs() {
                let place = format!("nu {poisson_ratio}, psi_1 {incidence:.3}, {partner:?}, {speed:.3} m/s");
                worst = (error, format!("{}: {place}, exact {expected:.3}", measured.label));
            }
        }
    }
    worst
}

/// Angles with the exact restitution at each.
fn exact_restitution(poisson_ratio: f64) -> Vec<(f64, f64)> {
    let reference = exact(poisson_ratio);
    angles()
        .into_iter()
        .map(|incidence| (incidence, -reference.reflection(incidence) / incidence))
        .collect()
}

#[test]
fn every_law_against_the_exact_impact() {
    on_threads(1, || {
        let mut worst = vec![0.0f64; MEASURED.len()];
        for poisson_ratio in POISSON_RATIOS {
            let expected = exact_restitution(poisson_ratio);
            for (measured, worst) in MEASURED.iter().zip(&mut worst) {
                let (error, place) = worst_error(measured, poisson_ratio, &expected, SPEED);
                report(&place, error);
                assert!(error.abs() <= measured.worst.1, "{place}: {error}");
                *worst = worst.max(error.abs());
            }
        }
        for (measured, worst) in MEASURED.iter().zip(worst) {
            // a law that follows better than the book says has changed, and the book is wrong
            assert!(worst >= measured.worst.0, "{}: only {worst}", measured.label);
        }
    });
    for info in demeter_physics::contact::tangential::LAWS {
        assert!(
            MEASURED.iter().any(|measured| measured.law == info.name),
            "{} is not measured",
            info.name
        );
    }
}

/// The cells of `mindlin-deresiewicz` follow the radius of the contact by powers of two: speeds that give radii in
/// between, and none may be worse than 0.03.
#[test]
fn partial_slip_at_any_size_of_the_contact() {
    on_threads(1, || {
        let count = if full() { 16 } else { 5 };
        for poisson_ratio in [0.0, 0.05, 0.2, 0.3, 0.4, 0.5] {
            let expected = exact_restitution(poisson_ratio);
            for k in 0..count {
                // a ~ v^0.4
                let speed = SPEED * libm::pow(2.0, 2.5 * f64::from(k) / f64::from(count));
                let (error, place) = worst_error(&MEASURED[0], poisson_ratio, &expected, speed);
                report(&place, error);
                assert!(error.abs() < 0.03, "{place}: {error}");
            }
        }
    });
}
