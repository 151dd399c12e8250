//! Pulls displace the other way: two contacts of one grain, solved by hand.

use super::influence::Model;
use super::scenes::*;
use crate::cases::{Laws, law, report};
use demeter::contacts::Coupling;
use demeter::walls::{Motion, Shape};
use demeter_physics::DVec3;
use std::f64::consts::PI;

const WORK: f64 = 1e-3;

/// Effective modulus of a grain of E = 1 and a wall.
fn effective(nu: f64) -> f64 {
    1.0 / ((1.0 - nu * nu) + 0.75e-15)
}

/// Normal force of `dmt` at contact, on a grain of radius 1.
fn dmt(nu: f64, y: f64) -> f64 {
    4.0 / 3.0 * effective(nu) * y * y.sqrt() - 2.0 * PI * WORK
}

/// Force of `jkr` by overlap, on the stable branch: the radius of the area of contact by bisection.
fn jkr(nu: f64, y: f64) -> f64 {
    let e = effective(nu);
    let overlap = |a: f64| a * a - (2.0 * PI * a * WORK / e).sqrt();
    // where the overlap is least
    let a = bisect(libm::cbrt(PI * WORK / (8.0 * e)), 1.0, |a| overlap(a) - y);
    4.0 * e * a * a * a / 3.0 - (8.0 * PI * WORK * e * a * a * a).sqrt()
}

/// Force by Poisson's ratio and overlap.
type ForceAt = fn(f64, f64) -> f64;

/// Where a rising function is zero.
fn bisect(mut low: f64, mut high: f64, f: impl Fn(f64) -> f64) -> f64 {
    assert!(f(low) < 0.0 && f(high) > 0.0);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        *(if f(middle) < 0.0 { &mut low } else { &mut high }) = middle;
    }
    0.5 * (low + high)
}

/// Influence of two contacts of a sphere of radius 1 on each other, by the cosine of their angle, at the lever `l`. By hand:
/// `d = 2 s l`, `n_k.u = -n_c.u = s`.
fn influence(model: Model, nu: f64, cosine: f64, l: f64) -> f64 {
    let s = (0.5 * (1.0 - cosine)).sqrt();
    match model {
        Model::HalfSpace(gamma) => {
            let braces = -s * s + (3.0 - 4.0 * nu) * cosine - (1.0 - 2.0 * nu) * (cosine - s) / (1.0 + s);
            -gamma * (1.0 + nu) / (2.0 * PI * 2.0 * s * l) * braces
        }
        _ => (1.0 + nu) / (4.0 * PI) * (-2.0 * (1.0 - nu) - 2.0 * (1.0 - 2.0 * nu) * s + (7.0 - 8.0 * nu) * s * s) / s,
    }
}

/// A grain on two walls that press or pull with the same force; `cosine` of the angle between the normals.
fn on_two_walls(model: Model, name: &str, nu: f64, cosine: f64, overlap: f64) -> Found {
    let laws = Laws::of(law(name, &[("work_of_adhesion", WORK)]));
    let mut case = case_of(materials(model, (1.0, nu), (1.0, nu), &laws));
    case.grain(1.0, DVec3::ZERO, DVec3::ZERO);
    let (up, aside) = ((0.5 * (1.0 + cosine)).sqrt(), (0.5 * (1.0 - cosine)).sqrt());
    for normal in [DVec3::new(aside, 0.0, up), DVec3::new(-aside, 0.0, up)] {
        case.plane(WALLS, normal * (overlap - 1.0), normal);
    }
    let sim = started(case);
    let both = found(&sim);
    assert_eq!(both.len(), 2);
    approx::assert_relative_eq!(both[0].elastic, both[1].elastic, max_relative = 1e-10);
    both[0]
}

#[test]
fn a_pull_displaces_the_other_way() {
    let laws: [(&str, ForceAt); 2] = [("dmt", dmt), ("jkr", jkr)];
    for model in [Model::HalfSpace(1.0), Model::HalfSpace(1.125), Model::SphereToSphere] {
        for (name, force) in laws {
            for nu in [0.0, 0.3, 0.5] {
                // opposite each other, and side by side
                for cosine in [-1.0, 0.5] {
                    for overlap in [0.004, 0.03, 0.06] {
                        let found = on_two_walls(model, name, nu, cosine, overlap);
                        let a = influence(model, nu, cosine, 1.0 - overlap);
                        let y = bisect(1e-4, 0.3, |y| y - overlap - a * force(nu, y));
                        let expected = force(nu, y);
                        approx::assert_relative_eq!(found.elastic, expected, max_relative = 1e-9 + found.rounding);
                        approx::assert_relative_eq!(found.displacement[0], a * expected, max_relative = 1e-9);
                        let pulls = overlap < 0.01;
                        assert!((expected < 0.0) == pulls);
                        // a pull draws the far side inwards and lifts the surface beside it
                        let outwards = (cosine > 0.0) == pulls;
                        assert_eq!(
                            found.displacement[0] > 0.0,
                            outwards,
                            "{model:?} {name} {nu} {cosine} {overlap}"
                        );
                    }
                }
            }
        }
    }
}

/// A pull that begins with a jump leaves the coupled equation without a solution when it flips others: such a contact lags
/// for a step, and the run goes on.
#[test]
fn pulls_that_begin_with_a_jump_do_not_stop_a_run() {
    for coupling in [Coupling::Lagged, Coupling::default()] {
        for (name, work) in [("jkr", 1e-3), ("jkr", 1e-5), ("dmt", 1e-4)] {
            let laws = Laws::of(law(name, &[("work_of_adhesion", work), ("alpha", 0.3)]));
            let mut case = case_of(materials(Model::HalfSpace(1.0), (1.0, 0.4), (1.0, 0.4), &laws));
            case.coupling = coupling;
            case.grain(1.0, DVec3::Z * 0.9999, DVec3::ZERO);
            case.plane(WALLS, DVec3::ZERO, DVec3::Z);
            let lid = Shape::Plane {
                point: DVec3::Z * 2.0005,
                normal: -DVec3::Z,
            };
            case.wall(WALLS, lid, Motion::Velocity(DVec3::Z * -1e-3));
            let mut sim = case.simulation();
            while sim.walls[1].displacement().z > -4e-3 {
                sim.step().unwrap();
            }
            let forces = found(&sim);
            let jumps = sim.coupling_effort().jumps;
            assert_eq!(forces.len(), 2, "{name} {work} {coupling:?}");
            assert!(forces.iter().all(|f| f.force.is_finite()), "{name} {work} {coupling:?}");
            assert!(jumps < 100, "{name} {work} {coupling:?}: {jumps} contacts lagged");
        }
    }
}

/// Two grains press, a third faces one of them across a gap that the bulge of the press just closes; its pull on touch would draw the bulge
/// back. In between is a share of the pull that leaves the surfaces touching: it grows from nothing to all with the gap.
#[test]
fn a_pull_that_draws_back_the_bulge_that_touched_acts_in_part() {
    let full = 2.0 * PI * 0.004 * 0.5;
    for coupling in [EXACT, Coupling::default()] {
        let mut pulls = vec![];
        for gap in (0..60).map(|k| 0.0105 + 1e-5 * f64::from(k)) {
            let laws = Laws::of(law("dmt", &[("work_of_adhesion", 0.004)]));
            let mut case = case_of(materials(Model::HalfSpace(1.0), (1.0, 0.5), (1.0, 0.5), &laws));
            case.coupling = coupling;
            case.share = 1e-6;
            for y in [0.0, 1.8, -2.0 - gap] {
                case.grain(1.0, DVec3::Y * y, DVec3::ZERO);
            }
            let mut sim = case.simulation();
            sim.start()
                .unwrap_or_else(|fault| panic!("{gap} {coupling:?}: {fault}"));
            for _ in 0..3 {
                sim.step().unwrap_or_else(|fault| panic!("{gap} {coupling:?}: {fault}"));
            }
            let pull = found(&sim).iter().map(|contact| contact.elastic).fold(0.0, f64::min);
            pulls.push(pull / full);
        }
        assert!(pulls[0] < -0.99 && pulls[59] == 0.0, "{coupling:?}");
        let changes = pulls.windows(2).map(|two| two[1] - two[0]);
        let largest = changes.fold(0.0, |most, change| {
            assert!(change > -1e-3, "{coupling:?} {change}");
            f64::max(most, change)
        });
        assert!(
            largest < 0.1,
            "{coupling:?}: from one gap to the next the pull changes by a share of {largest}"
        );
    }
}

/// Largest residual of the books of five grains that collide and stick, with steps of this share of the shortest time scale.
fn residual_of_five(share: f64) -> f64 {
    let laws = Laws::of(law("dmt", &[("work_of_adhesion", 0.004)]));
    let mut case = case_of(materials(Model::HalfSpace(1.0), (1.0, 0.5), (1.0, 0.5), &laws));
    case.coupling = Coupling::Converged { tolerance: 1e-9 };
    case.share = share;
    let grains = [
        (1.0, [0.0, 0.0, 0.0], [0.0, 0.0, 0.0]),
        (1.0, [2.05, 0.1, 0.0], [-0.05, 0.02, 0.0]),
        (0.9, [-2.2, 0.0, 0.1], [0.05, 0.0, 0.03]),
        (1.1, [0.0, 2.1, 0.2], [0.0, -0.06, -0.03]),
        (1.0, [0.1, -2.15, 0.0], [0.03, 0.04, 0.0]),
    ];
    for (radius, place, velocity) in grains {
        case.grain(radius, DVec3::from_array(place), DVec3::from_array(velocity));
    }
    let mut sim = case.simulation();
    let mut largest = 0.0;
    while sim.time() < 20.0 {
        sim.steps(20).unwrap_or_else(|fault| panic!("{share}: {fault}"));
        largest = f64::max(largest, sim.energies().residual.abs());
    }
    largest
}

/// As a pull sets in without a jump where it would draw back the bulge that touched, no energy is lost there, and the books close the
/// better the shorter the step.
#[test]
fn the_books_of_pulls_that_begin_with_a_jump_close_with_the_step() {
    let [coarse, fine] = [1.4e-3, 3.5e-4].map(residual_of_five);
    report("largest residual of five sticky grains", coarse);
    report("largest residual of five sticky grains, a quarter of the step", fine);
    assert!(fine < 0.5 * coarse && fine < 2e-5, "{coarse} {fine}");
}
