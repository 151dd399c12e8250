//! Parameters of damped springs by closed form (Antypov and Elliott 2011, eqs 7, 17, 19-23), where one impact shows the
//! restitution and one thing more.

use super::model::size_of;
use crate::scenario::{FitFile, Observable, Observation, Target};
use demeter_physics::collision::Start;
use demeter_physics::parameters::Value;
use demeter_physics::restitution::ContactEnd;
use demeter_physics::restitution::hertz::HertzCollision;
use demeter_physics::restitution::inverse::{Collision, SpringDashpot};
use demeter_physics::restitution::linear::LinearCollision;

/// Values of the unknowns; nothing where the closed form does not apply.
pub(super) fn exact(file: &FitFile) -> Option<Vec<f64>> {
    let law = match file.law.name {
        "linear" => SpringDashpot::Linear,
        "hertz-tsuji" => SpringDashpot::Hertz,
        _ => return None,
    };
    let [observation] = file.observations.as_slice() else {
        return None;
    };
    if file.start != Start::Contact || observation.measured.len() > 2 {
        return None;
    }
    let end = match file.known.get("contact_end") {
        None => ContactEnd::ZeroOverlap,
        Some(Value::Text(word)) if word == "zero-overlap" => ContactEnd::ZeroOverlap,
        Some(Value::Text(word)) if word == "zero-force" => ContactEnd::ZeroForce,
        Some(_) => return None,
    };
    let collision = Collision {
        law,
        end,
        mass: size_of(&observation.a, &observation.b).mass,
        speed: observation.velocity?,
        restitution: value(observation, Observable::Restitution)?,
    };
    let stiffness = stiffness(&collision, observation);
    let damping = |name: &str| damping(&collision, name, stiffness);
    let found = |target: Target| match target {
        Target::Parameter("stiffness") => stiffness,
        Target::Parameter(name) => damping(name),
        Target::YoungModulus(index) if law == SpringDashpot::Hertz => young_modulus(file, index, stiffness?),
        Target::YoungModulus(_) | Target::PoissonRatio(_) => None,
    };
    let values: Option<Vec<f64>> = file.unknown.iter().map(|u| found(u.target)).collect();
    let within = |values: &Vec<f64>| {
        let pairs = values.iter().zip(&file.unknown);
        pairs.into_iter().all(|(x, u)| *x >= u.last.0 && *x <= u.last.1)
    };
    // as many unknowns as observations, or the closed form would leave some of them out of account
    values.filter(|v| v.len() == observation.measured.len() && within(v))
}

fn value(observation: &Observation, observable: Observable) -> Option<f64> {
    let seen = observation.measured.iter().find(|m| m.observable == observable)?;
    Some(seen.value)
}

fn stiffness(collision: &Collision, observation: &Observation) -> Option<f64> {
    let of = |observable| value(observation, observable);
    if let Some(time) = of(Observable::ContactTime) {
        return collision.stiffness_of_contact_time(time).ok();
    }
    if let Some(overlap) = of(Observable::MaxOverlap) {
        return collision.stiffness_of_max_overlap(overlap).ok();
    }
    collision.stiffness_of_max_force(of(Observable::MaxForce)?).ok()
}

fn damping(collision: &Collision, name: &str, stiffness: Option<f64>) -> Option<f64> {
    let restitution = collision.restitution;
    match name {
        "restitution" => Some(restitution),
        "alpha" => Some(
            HertzCollision::from_restitution(restitution, collision.end)
                .ok()?
                .alpha(),
        ),
        "damping_rate" => {
            let ratio = LinearCollision::from_restitution(restitution, collision.end)
                .ok()?
                .ratio();
            Some(ratio * (stiffness? / collision.mass).sqrt())
        }
        _ => None,
    }
}

/// Young's modulus of a material, of which one body or both are made: `3 K/(4 sqrt(R)) = E_eff`.
fn young_modulus(file: &FitFile, index: usize, stiffness: f64) -> Option<f64> {
    let radius = size_of(&file.observations[0].a, &file.observations[0].b).radius;
    let mut compliance = radius.sqrt() / (0.75 * stiffness);
    let mut unknown = 0.0;
    for material in [file.a.material, file.b.material()] {
        let material = usize::from(material);
        let constants = &file.materials[material];
        let factor = 1.0 - constants.poisson_ratio * constants.poisson_ratio;
        if material == index {
            unknown += factor;
        } else {
            compliance -= factor / constants.young_modulus;
        }
    }
    (compliance > 0.0 && unknown > 0.0).then(|| unknown / compliance)
}
