//! One collision of two bodies.

use super::error::CalibrateError;
use super::extrapolate::limit;
use super::flight::{Flight, Launch, impact_velocity};
use crate::scenario::{DEFAULT_MAX_OVERLAP, ImpactFile};
use crate::simulation::{Energies, SAFE_SHARE};
pub use demeter_physics::collision::Moment;
use demeter_physics::collision::{Collision, HeadOn, Outcome, Tolerance};
use demeter_physics::contact::PairLaw;
use glam::DVec3;

/// How a collision is computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Engine {
    /// To reference precision: head-on with error control; oblique by extrapolation of the engine's steps.
    Reference,
    /// As the engine computes it in a run, with its automatic time step.
    Automatic,
}

/// What became of two bodies.
#[derive(Clone, Debug)]
pub struct CollideReport {
    /// How it was computed, in words.
    pub method: String,
    /// Rebound or stick.
    pub outcome: Outcome,
    /// Normal speed after over that before, along the normal at first touch; 0 after sticking.
    pub restitution: f64,
    /// Reversed tangential velocity of the surfaces after over that before; absent when there was none before.
    pub tangential_restitution: Option<f64>,
    /// Time to the last force from the first, or from first touch where the velocity is told there [s]; absent after sticking.
    pub contact_time: Option<f64>,
    /// Gap across which the bodies feel each other before they touch [m]: then the contact time holds more than the touch.
    pub reach: f64,
    /// Largest overlap [m].
    pub max_overlap: f64,
    /// Largest normal force [N].
    pub max_force: f64,
    /// Angle of the relative velocity after the collision from the normal [rad], negative when it went back.
    pub angle_out: f64,
    /// Velocity of the two bodies after [m/s].
    pub velocity: [DVec3; 2],
    /// Spin of the two bodies after [1/s].
    pub spin: [DVec3; 2],
    /// Energies before.
    pub before: Energies,
    /// Energies after, with what was dissipated.
    pub after: Energies,
    /// Estimated relative error; absent where the engine's own step was used.
    pub estimated_error: Option<f64>,
    /// Time step [s], where there is one.
    pub time_step: Option<f64>,
    /// Steps.
    pub steps: u64,
    /// The course of the collision.
    pub moments: Vec<Moment>,
}

/// Collides the bodies of a file. `moments` is the number of rows of the course, or the largest where it has a row for each step.
pub fn collide(file: &ImpactFile, engine: Engine, moments: usize) -> Result<CollideReport, CalibrateError> {
    let mut report = collide_to_the_end(file, engine, moments)?;
    thin_out(&mut report.moments, moments);
    Ok(report)
}

/// Leaves so many of a list, at equal distances, the first and the last among them.
fn thin_out<T: Copy>(list: &mut Vec<T>, most: usize) {
    let last = list.len().saturating_sub(1);
    if list.len() > most {
        *list = (0..most)
            .map(|k| list[k * last / most.saturating_sub(1).max(1)])
            .collect();
    }
}

fn collide_to_the_end(file: &ImpactFile, engine: Engine, moments: usize) -> Result<CollideReport, CalibrateError> {
    let Some(speed) = file.impact.velocity else {
        let message = "`velocity` is missing: the speed of the impact, as velocity = \"1 m/s\" in [impact]";
        return Err(file.refused("impact", message).into());
    };
    let law = file.law()?;
    let launch = Launch {
        file,
        law: &law,
        speed,
        max_overlap: DEFAULT_MAX_OVERLAP,
    };
    match engine {
        Engine::Reference if is_head_on(file, &law) => head_on(&launch, moments),
        Engine::Reference => {
            let launch = Launch {
                max_overlap: expected_overlap(file, &law, speed)?,
                ..launch
            };
            let limit = limit(&launch)?;
            let mut report = told(&launch, limit.flight);
            report.method = "the engine's steps, halved and extrapolated".to_string();
            report.estimated_error = Some(limit.error);
            report.time_step = Some(limit.time_step);
            Ok(report)
        }
        Engine::Automatic => {
            let dt = SAFE_SHARE * launch.time_scale()?;
            let mut report = told(&launch, launch.fly(dt)?);
            report.method = "the engine with its automatic time step".to_string();
            report.time_step = Some(dt);
            Ok(report)
        }
    }
}

/// Whether only the normal law acts.
fn is_head_on(file: &ImpactFile, law: &PairLaw) -> bool {
    let impact = &file.impact;
    let still = impact.spin_a == DVec3::ZERO && impact.spin_b == DVec3::ZERO;
    impact.angle == 0.0 && (still || (law.tangential.is_none() && law.rolling.is_none()))
}

/// Margin over the overlap of the head-on part of an impact.
const MARGIN: f64 = 1.2;

/// Largest overlap to be expected, as share of the smaller radius.
fn expected_overlap(file: &ImpactFile, law: &PairLaw, speed: f64) -> Result<f64, CalibrateError> {
    let impact = HeadOn {
        law: &law.normal,
        size: file.size(),
        speed: speed * libm::cos(file.impact.angle),
        start: file.impact.start,
    };
    let overlap = impact.run(&Tolerance::default())?.max_overlap;
    let smaller = file.b.body().map_or(file.a.radius, |b| b.radius.min(file.a.radius));
    Ok(MARGIN * overlap / smaller)
}

fn head_on(launch: &Launch<'_>, moments: usize) -> Result<CollideReport, CalibrateError> {
    let Launch { file, law, speed, .. } = *launch;
    let size = file.size();
    let impact = HeadOn {
        law: &law.normal,
        size,
        speed,
        start: file.impact.start,
    };
    let (found, moments) = impact.run_recorded(&Tolerance::default(), moments)?;
    let coarse = Tolerance {
        relative: 1e2 * Tolerance::default().relative,
        ..Tolerance::default()
    };
    let check = impact.run(&coarse)?;
    let impulse = size.mass * speed * (1.0 + found.restitution);
    let [mass_a, mass_b] = [Some(file.a.mass), file.b.free_mass()];
    let push = |mass: Option<f64>, direction: f64| DVec3::Z * mass.map_or(0.0, |m| direction * impulse / m);
    let velocity = [impact_velocity(file, speed) + push(mass_a, 1.0), push(mass_b, -1.0)];
    let (before, after) = ledger(file, speed, &found);
    Ok(CollideReport {
        method: "head-on, error-controlled".to_string(),
        outcome: found.outcome,
        restitution: found.restitution,
        tangential_restitution: None,
        contact_time: found.contact_time(),
        reach: launch.reach(),
        max_overlap: found.max_overlap,
        max_force: found.max_force,
        angle_out: 0.0,
        velocity,
        spin: [file.impact.spin_a, file.impact.spin_b],
        before,
        after,
        estimated_error: Some(difference(&found, &check)),
        time_step: None,
        steps: found.steps as u64,
        moments,
    })
}

/// How much a hundredfold tolerance changes a collision: more than its error.
fn difference(found: &Collision, coarse: &Collision) -> f64 {
    if found.outcome != coarse.outcome {
        return 1.0;
    }
    let pairs = [
        (found.restitution, coarse.restitution),
        (found.max_overlap, coarse.max_overlap),
        (found.max_force, coarse.max_force),
        (
            found.contact_time().unwrap_or(1.0),
            coarse.contact_time().unwrap_or(1.0),
        ),
    ];
    let relative = |(a, b): (f64, f64)| if a == b { 0.0 } else { ((a - b) / a).abs() };
    pairs.map(relative).into_iter().fold(0.0, f64::max)
}

/// Losses below this share of the energy that passed through the contact are errors of the integration.
const UNEXPLAINED: f64 = 1e-10;

/// The energies of a head-on collision in the frame in which the second body was at rest.
fn ledger(file: &ImpactFile, speed: f64, found: &Collision) -> (Energies, Energies) {
    let energy = &found.energy;
    let rotational = |body: Option<f64>, spin: DVec3| body.map_or(0.0, |inertia| 0.5 * inertia * spin.length_squared());
    let free = file.b.free_mass().and(file.b.body()).map(|b| b.inertia());
    let rotational = rotational(Some(file.a.inertia()), file.impact.spin_a) + rotational(free, file.impact.spin_b);
    // the motion of the centre of mass goes on
    let common = 0.5 * file.a.mass * speed * speed - energy.kinetic_before;
    let before = Energies {
        kinetic: energy.kinetic_before + common,
        rotational,
        elastic: energy.stored_before,
        ..Energies::default()
    };
    // what the integration cannot tell from its own error is told as residual
    let passed = energy.kinetic_before + energy.stored_before.abs() + energy.viscous;
    let (plastic, residual) = if energy.lost.abs() > UNEXPLAINED * passed {
        (energy.lost, 0.0)
    } else {
        (0.0, energy.lost / passed)
    };
    let after = Energies {
        kinetic: energy.kinetic_after + common,
        rotational,
        elastic: energy.stored_after,
        viscous_dissipated: energy.viscous,
        plastic_dissipated: plastic,
        residual,
        ..Energies::default()
    };
    (before, after)
}

/// What a flight in the engine tells.
fn told(launch: &Launch<'_>, flight: Flight) -> CollideReport {
    let file = launch.file;
    let start = impact_velocity(file, launch.speed);
    let relative = flight.velocity[0] - flight.velocity[1];
    let radius_b = file.b.body().map_or(0.0, |b| b.radius);
    let surface = |velocity: DVec3, spin: [DVec3; 2]| {
        let arms = spin[0] * file.a.radius + spin[1] * radius_b;
        let at_contact = velocity - arms.cross(DVec3::Z);
        at_contact - DVec3::Z * at_contact.z
    };
    let before = surface(start, [file.impact.spin_a, file.impact.spin_b]);
    let after = surface(relative, flight.spin);
    let slid = before.length_squared() > 0.0;
    let rebound = flight.outcome == Outcome::Rebound;
    CollideReport {
        method: String::new(),
        outcome: flight.outcome,
        restitution: if rebound { -relative.z / start.z } else { 0.0 },
        tangential_restitution: slid.then(|| -after.dot(before) / before.length_squared()),
        contact_time: rebound.then_some(flight.contact_time),
        reach: launch.reach(),
        max_overlap: flight.max_overlap,
        max_force: flight.max_force,
        angle_out: libm::atan2(relative.x, relative.z),
        velocity: flight.velocity,
        spin: flight.spin,
        before: flight.before,
        after: flight.after,
        estimated_error: None,
        time_step: None,
        steps: flight.steps,
        moments: flight.moments,
    }
}
