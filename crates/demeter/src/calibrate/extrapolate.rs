//! The engine's scheme with halved time steps, extrapolated until the values no longer change.

use super::error::CalibrateError;
use super::flight::{Flight, Launch};
use crate::scenario::Partner;
use crate::simulation::{Energies, SAFE_SHARE};
use demeter_physics::collision::Outcome;
use glam::DVec3;

/// Estimated error at which the halving ends.
const GOAL: f64 = 1e-7;

/// Most halvings.
const MOST_HALVINGS: u32 = 8;

/// A flight at the limit of no time step.
pub(super) struct Limit {
    pub flight: Flight,
    /// Estimated error: the largest change by the last halving, of speeds over the impact speed, of contact time,
    /// overlap and force over themselves, and of energies over the kinetic one.
    pub error: f64,
    /// Shortest time step [s].
    pub time_step: f64,
}

/// Halves the time step until the values agree. Two sequences are watched, the plain one and the one from which the
/// error of second order is taken; the one that changed less tells.
pub(super) fn limit(launch: &Launch<'_>) -> Result<Limit, CalibrateError> {
    let mut dt = 2.0 * SAFE_SHARE * launch.time_scale()?;
    let mut flight = launch.fly(dt)?;
    let mut plain = Values::of(&flight, launch);
    let mut better: Option<Values> = None;
    let mut found: Option<(Values, f64)> = None;
    for _ in 0..MOST_HALVINGS {
        dt *= 0.5;
        flight = launch.fly(dt)?;
        let finer = Values::of(&flight, launch);
        let extrapolated = finer.combined(&plain, |fine, coarse| fine + (fine - coarse) / 3.0);
        let mut candidates = vec![(finer.clone(), finer.distance(&plain))];
        if let Some(before) = &better {
            candidates.push((extrapolated.clone(), extrapolated.distance(before)));
        }
        for (values, error) in candidates {
            if found.as_ref().is_none_or(|(_, least)| error < *least) {
                found = Some((values, error));
            }
        }
        (plain, better) = (finer, Some(extrapolated));
        if found.as_ref().is_some_and(|(_, error)| *error < GOAL) {
            break;
        }
    }
    let (values, error) = found.unwrap_or((plain, f64::INFINITY));
    values.put_into(&mut flight, launch);
    Ok(Limit {
        flight,
        error,
        time_step: dt,
    })
}

/// The values that are extrapolated, each over its scale.
#[derive(Clone)]
struct Values(Vec<f64>);

/// Energies that change in a collision.
fn energies(of: &mut Energies) -> [&mut f64; 9] {
    [
        &mut of.kinetic,
        &mut of.rotational,
        &mut of.elastic,
        &mut of.tangential,
        &mut of.rolling,
        &mut of.viscous_dissipated,
        &mut of.plastic_dissipated,
        &mut of.friction_dissipated,
        &mut of.rolling_dissipated,
    ]
}

/// Every value with its scale: visited in the same order to read and to write.
fn each(flight: &mut Flight, launch: &Launch<'_>, mut visit: impl FnMut(&mut f64, f64)) {
    let speed = launch.speed;
    let radii = [
        launch.file.a.radius,
        launch.file.b.body().map_or(launch.file.a.radius, |b| b.radius),
    ];
    // a held sphere stands in for one that cannot move
    let bodies = if matches!(launch.file.b, Partner::Free(_)) {
        2
    } else {
        1
    };
    let vectors = flight.velocity.iter_mut().zip(&mut flight.spin).zip(radii);
    for ((velocity, spin), radius) in vectors.take(bodies) {
        let mut vector = |v: &mut DVec3, scale: f64| {
            let mut parts = v.to_array();
            parts.iter_mut().for_each(|part| visit(part, scale));
            *v = DVec3::from_array(parts);
        };
        vector(velocity, speed);
        vector(spin, speed / radius);
    }
    let (time, overlap, force) = (flight.contact_time, flight.max_overlap, flight.max_force);
    if flight.outcome == Outcome::Rebound {
        visit(&mut flight.contact_time, time);
    }
    visit(&mut flight.max_overlap, overlap);
    visit(&mut flight.max_force, force);
    let kinetic = flight.before.kinetic + flight.before.rotational;
    for value in energies(&mut flight.after) {
        visit(value, kinetic);
    }
}

impl Values {
    fn of(flight: &Flight, launch: &Launch<'_>) -> Self {
        let mut values = Vec::with_capacity(32);
        each(&mut flight.clone(), launch, |value, scale| {
            values.push(*value);
            values.push(scale);
        });
        Self(values)
    }

    fn combined(&self, other: &Self, of: impl Fn(f64, f64) -> f64) -> Self {
        let pairs = self.0.chunks_exact(2).zip(other.0.chunks_exact(2));
        Self(pairs.flat_map(|(a, b)| [of(a[0], b[0]), a[1]]).collect())
    }

    /// Largest difference over its scale; infinite when the outcomes differ.
    fn distance(&self, other: &Self) -> f64 {
        if self.0.len() != other.0.len() {
            return f64::INFINITY;
        }
        let pairs = self.0.chunks_exact(2).zip(other.0.chunks_exact(2));
        pairs
            .map(|(a, b)| {
                if a[0] == b[0] {
                    0.0
                } else {
                    ((a[0] - b[0]) / a[1]).abs()
                }
            })
            .fold(0.0, f64::max)
    }

    fn put_into(&self, flight: &mut Flight, launch: &Launch<'_>) {
        let mut values = self.0.chunks_exact(2);
        let mut copy = flight.clone();
        each(&mut copy, launch, |value, _| {
            if let Some(pair) = values.next() {
                *value = pair[0];
            }
        });
        *flight = copy;
    }
}
