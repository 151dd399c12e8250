//! A sphere on an inclined plane rolls, slides, or is held by rolling resistance as theory says.
//!
//! Gravity is tilted instead of the plane. The sphere starts in its static overlap, so that nothing bounces. Theory of a
//! rigid sphere of radius `r` touching at the distance `l` (`r` less the overlap) from its centre.

use crate::cases::{Case, G, Laws, advance, full, hertz_overlap, law, mass, on_threads, one_material, report};
use demeter::simulation::Simulation;
use demeter_physics::DVec3;
use demeter_physics::contact::LawChoice;

const RADIUS: f64 = 5e-3;
const YOUNG_MODULUS: f64 = 1e9;
const FRICTION: f64 = 0.3;
/// The springs have died away by then; what is left is rounding, the stick of `coulomb`, and the tangential spring.
const TOLERANCE: f64 = 1e-5;

fn mindlin() -> LawChoice {
    law("mindlin-history", &[("friction", FRICTION)])
}

fn linear_history() -> LawChoice {
    law("linear-history", &[("friction", FRICTION), ("stiffness", 1e6)])
}

fn coulomb() -> LawChoice {
    law("coulomb", &[("friction", FRICTION)])
}

/// A sphere at rest on a plane tilted by `angle`; downhill is +x.
fn on_a_slope(laws: &Laws, angle: f64) -> Simulation {
    let mut case = Case::new(one_material(YOUNG_MODULUS, laws));
    let (sin, cos) = (libm::sin(angle), libm::cos(angle));
    let overlap = hertz_overlap(YOUNG_MODULUS, RADIUS, mass(RADIUS) * G * cos);
    case.grain(RADIUS, DVec3::new(0.0, 0.0, RADIUS - overlap), DVec3::ZERO);
    case.plane(0, DVec3::ZERO, DVec3::Z);
    case.gravity = DVec3::new(G * sin, 0.0, -G * cos);
    case.simulation()
}

/// Acceleration downhill, angular acceleration about y, and distance of the centre from the plane.
struct Rates {
    acceleration: f64,
    turning: f64,
    lever: f64,
    slip: f64,
    dt: f64,
}

/// Rates once the springs had time to die away.
fn rates(sim: &mut Simulation) -> Rates {
    rates_after(sim, if full() { 0.05 } else { 0.01 })
}

fn rates_after(sim: &mut Simulation, time: f64) -> Rates {
    advance(sim, time);
    let (t0, v0, w0) = (
        sim.time(),
        sim.grains().velocity[0].x,
        sim.grains().angular_velocity[0].y,
    );
    advance(sim, time);
    let elapsed = sim.time() - t0;
    let (v1, w1, lever) = (
        sim.grains().velocity[0].x,
        sim.grains().angular_velocity[0].y,
        sim.grains().position[0].z,
    );
    Rates {
        acceleration: (v1 - v0) / elapsed,
        turning: (w1 - w0) / elapsed,
        lever,
        slip: v1 - w1 * lever,
        dt: sim.dt(),
    }
}

fn close(what: &str, found: f64, expected: f64, tolerance: f64) {
    let error = (found / expected - 1.0).abs();
    report(what, error);
    assert!(error < tolerance, "{what}: {found}, expected {expected}");
}

/// `1 + I/(m l^2)`.
fn rolling_factor(lever: f64) -> f64 {
    1.0 + 0.4 * (RADIUS / lever) * (RADIUS / lever)
}

#[test]
fn below_the_limit_it_rolls_with_five_sevenths() {
    on_threads(1, || {
        for (name, friction) in [("mindlin", mindlin()), ("linear", linear_history())] {
            // tan(a) = 7/2 mu at 46.4 degrees
            for angle in [0.05, 0.4, 0.75] {
                let r = rates(&mut on_a_slope(&Laws::hertz(0.5).friction(friction.clone()), angle));
                let pull = G * libm::sin(angle);
                let expected = pull / rolling_factor(r.lever);
                close(
                    &format!("{name} rolling at {angle}"),
                    r.acceleration,
                    expected,
                    TOLERANCE,
                );
                close(
                    &format!("{name} turning at {angle}"),
                    r.turning,
                    expected / r.lever,
                    TOLERANCE,
                );
                // the overlap shortens the lever by 1e-4
                close("against 5/7", r.acceleration, 5.0 / 7.0 * pull, 1e-4);
            }
        }
    });
}

#[test]
fn above_the_limit_it_slides() {
    on_threads(1, || {
        for (name, friction) in [
            ("mindlin", mindlin()),
            ("linear", linear_history()),
            ("coulomb", coulomb()),
        ] {
            for angle in [0.85, 1.1, 1.4] {
                let r = rates(&mut on_a_slope(&Laws::hertz(0.5).friction(friction.clone()), angle));
                let (sin, cos) = (libm::sin(angle), libm::cos(angle));
                let expected = G * (sin - FRICTION * cos);
                close(
                    &format!("{name} sliding at {angle}"),
                    r.acceleration,
                    expected,
                    TOLERANCE,
                );
                let turning = 2.5 * FRICTION * G * cos * r.lever / (RADIUS * RADIUS);
                close(&format!("{name} turning at {angle}"), r.turning, turning, TOLERANCE);
                assert!(r.slip > 0.0);
            }
        }
    });
}

/// `coulomb` has no memory: it carries the load of a rolling contact by creeping at `v = F dt/(f m_t)`, with the share
/// `f = 0.16`, `F = 2/7 m g sin(a)` and `m_t = 2/7 m`: `v = g sin(a) dt/f`.
#[test]
fn coulomb_rolls_with_a_creep() {
    on_threads(1, || {
        let angle = 0.4;
        let r = rates(&mut on_a_slope(&Laws::hertz(0.5).friction(coulomb()), angle));
        let pull = G * libm::sin(angle);
        close(
            "coulomb rolling",
            r.acceleration,
            pull / rolling_factor(r.lever),
            TOLERANCE,
        );
        close("coulomb creep", r.slip, pull * r.dt / 0.16, 1e-3);
    });
}

const ROLLING_FRICTION: f64 = 0.1;

/// A sphere held by its rolling resistance swings on the tangential spring, which only its own dashpot damps [s].
const SLOW_DECAY: f64 = 0.1;

#[test]
fn rolling_resistance_slows_rolling() {
    on_threads(1, || {
        for rolling in ["epsd", "constant-torque"] {
            for angle in [0.15, 0.4] {
                let laws = Laws::hertz(0.5).friction(mindlin()).rolling(rolling, ROLLING_FRICTION);
                let r = rates(&mut on_a_slope(&laws, angle));
                let (sin, cos) = (libm::sin(angle), libm::cos(angle));
                // m a = m g sin - F,  I a/l = F l - mu_r r m g cos
                let resistance = ROLLING_FRICTION * RADIUS / r.lever;
                let expected = G * (sin - resistance * cos) / rolling_factor(r.lever);
                close(&format!("{rolling} at {angle}"), r.acceleration, expected, 1e-4);
            }
        }
    });
}

#[test]
fn rolling_resistance_holds_a_sphere_below_its_limit() {
    on_threads(1, || {
        for angle in [0.02, 0.09] {
            let laws = Laws::hertz(0.5).friction(mindlin()).rolling("epsd", ROLLING_FRICTION);
            let mut sim = on_a_slope(&laws, angle);
            let r = rates_after(&mut sim, SLOW_DECAY);
            report(&format!("epsd: speed at {angle}"), sim.grains().velocity[0].length());
            // a free sphere would roll at 1e-3 m/s or more by now
            let free = 5.0 / 7.0 * G * libm::sin(angle) * sim.time();
            assert!(
                sim.grains().velocity[0].length() < 1e-6 * free,
                "{}",
                sim.grains().velocity[0]
            );
            assert!(r.turning.abs() * RADIUS < 1e-6 * G);
            // released at once the spring swings to almost twice its load, and yields when that is above the limit
            if 2.0 * angle > ROLLING_FRICTION {
                continue;
            }
            // the rolling spring, k_r = 9/4 k_n (mu_r r)^2, twists by M/k_r, and the tangential one, k_t/k_n =
            // 2 (1 - nu)/(2 - nu) (Mindlin), gives by F/k_t
            let load = mass(RADIUS) * G * libm::cos(angle);
            let overlap = RADIUS - sim.grains().position[0].z;
            let normal_stiffness = 1.5 * load / overlap;
            let arm = ROLLING_FRICTION * RADIUS;
            let pull = mass(RADIUS) * G * libm::sin(angle);
            let twist = pull * r.lever / (2.25 * normal_stiffness * arm * arm);
            let tangential_stiffness = 2.0 * (1.0 - 0.3) / (2.0 - 0.3) * normal_stiffness;
            let expected = twist * r.lever + pull / tangential_stiffness;
            let travel = sim.grains().position[0].x;
            report("epsd: travel over theory", travel / expected);
            assert!((travel / expected - 1.0).abs() < 1e-3, "{travel} {expected}");
        }
    });
}

/// `constant-torque` has no memory either: it creeps at `w = M dt/(f I)` with `M = m g sin(a) l`, `I = 2/7 (2/5 m r^2 + m l^2)`.
#[test]
fn constant_torque_creeps_below_its_limit() {
    on_threads(1, || {
        let angle = 0.05;
        let laws = Laws::hertz(0.5)
            .friction(mindlin())
            .rolling("constant-torque", ROLLING_FRICTION);
        let mut sim = on_a_slope(&laws, angle);
        let r = rates_after(&mut sim, SLOW_DECAY);
        let creep =
            G * libm::sin(angle) * r.lever * r.dt / (2.0 / 7.0 * 0.064 * (0.4 * RADIUS * RADIUS + r.lever * r.lever));
        close("constant-torque creep", sim.grains().angular_velocity[0].y, creep, 1e-3);
        assert!(r.acceleration.abs() < 1e-6 * G, "{}", r.acceleration);
    });
}
