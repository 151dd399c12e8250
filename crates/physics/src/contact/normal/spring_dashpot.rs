//! What the linear and the Hertzian spring-dashpot share: every way to ask for their stiffness and damping (Antypov &
//! Elliott 2011). Both follow one phase trajectory, which the damping ratio `g` alone decides.

use super::NormalInput;
use crate::contact::lane_by_lane::{noted, some_new};
use crate::lanes::Lanes;
use crate::parameters::{ParameterError, Restitution};
use crate::restitution::hertz::HertzCollision;
use crate::restitution::inverse::{Collision, SpringDashpot};
use crate::restitution::linear::LinearCollision;
use crate::restitution::{ContactEnd, RestitutionError};

/// Words of the parameter `contact_end`, in the order of [`contact_end`].
pub(super) const ENDS: [&str; 2] = ["zero-overlap", "zero-force"];

/// The end of contact that a word of [`ENDS`] means.
pub(super) fn contact_end(place: usize) -> ContactEnd {
    match place {
        0 => ContactEnd::ZeroOverlap,
        _ => ContactEnd::ZeroForce,
    }
}

/// Damping of a contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Damping {
    /// Damping ratio `g`: `gamma/omega0` of the linear spring, `alpha/sqrt(5)` of the Hertzian one.
    Ratio(f64),
    /// Damping rate of the linear spring, `gamma` [1/s].
    Rate(f64),
    /// The ratio that gives the restitution of the impact speed, which is noted when contact begins.
    Profile(Restitution, ContactEnd),
}

/// Coefficient of a dashpot.
pub(super) enum Dashpot<L> {
    /// In units of `sqrt(k m)`.
    Units(L),
    /// [N s/m].
    Known(L),
}

impl Damping {
    /// The damping that realises a restitution.
    pub fn of(restitution: Restitution, end: ContactEnd) -> Self {
        match restitution {
            Restitution::Constant(e) => Self::Ratio(ratio_of(e, end)),
            profile => Self::Profile(profile, end),
        }
    }

    /// Number of history values: of a profile, the damping ratio.
    #[inline(always)]
    pub fn history(&self) -> usize {
        match self {
            Self::Profile(..) => 1,
            _ => 0,
        }
    }

    /// Coefficient of the dashpot, `scale g sqrt(k m) = scale gamma m`: `scale` is 2 for the linear spring, `sqrt(5)` for that of Hertz.
    #[inline(always)]
    pub fn dashpot<L: Lanes>(&self, input: &NormalInput<L>, scale: f64, memory: &mut [L]) -> Dashpot<L> {
        match self {
            Self::Ratio(ratio) => Dashpot::Units(L::splat(ratio * scale)),
            Self::Rate(rate) => Dashpot::Known(input.size.mass * (rate * scale)),
            Self::Profile(restitution, end) => {
                if some_new(memory[0]) {
                    let rate = input.rate;
                    memory[0] = noted(memory[0], |lane| {
                        1.0 + ratio_of(restitution.at(rate.as_slice()[lane].abs()), *end)
                    });
                }
                Dashpot::Units((memory[0] - 1.0) * scale)
            }
        }
    }

    /// Damping ratio at an impact speed [m/s] for the frequency `omega0 = sqrt(k/m)` of the linear spring [1/s].
    pub fn ratio_at(&self, frequency: f64, speed: f64) -> f64 {
        match self {
            Self::Ratio(ratio) => *ratio,
            Self::Rate(rate) => rate / frequency,
            Self::Profile(restitution, end) => ratio_of(restitution.at(speed), *end),
        }
    }
}

/// Damping ratio that realises a restitution; the range of `e` was checked before.
fn ratio_of(restitution: f64, end: ContactEnd) -> f64 {
    LinearCollision::from_restitution(restitution, end).map_or(0.0, |collision| collision.ratio())
}

/// Ways to tell the damping: `restitution`, or a coefficient under the name `other`.
pub(super) fn exactly_one_damping<T, U>(
    restitution: &Option<T>,
    coefficient: &Option<U>,
    name: &str,
) -> Result<(), Vec<ParameterError>> {
    let fault = match (restitution, coefficient) {
        (Some(_), None) | (None, Some(_)) => return Ok(()),
        (None, None) => format!("the damping is missing: give `restitution`, typically 0.9, or `{name}`"),
        (Some(_), Some(_)) => format!("`restitution` and `{name}` both tell the damping; give one of them"),
    };
    Err(ParameterError::together("restitution", fault))
}

/// Stiffness as it was asked for through an observation.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Observed {
    /// Contact time [s].
    pub contact_time: Option<f64>,
    /// Largest overlap [m].
    pub max_overlap: Option<f64>,
    /// Impact speed at which they were observed [m/s].
    pub impact_speed: Option<f64>,
}

impl Observed {
    /// Stiffness over effective mass that gives what was observed: [1/s^2] for the linear spring, [1/(m^(1/2) s^2)] for
    /// the Hertzian one; nothing when nothing was observed.
    pub fn stiffness_per_mass(
        &self,
        law: SpringDashpot,
        restitution: Option<Restitution>,
        end: ContactEnd,
    ) -> Result<Option<f64>, Vec<ParameterError>> {
        let refuse = |name: &'static str, message: &str| Err(ParameterError::together(name, message));
        let named = match (self.contact_time, self.max_overlap) {
            (None, None) if self.impact_speed.is_some() => {
                return refuse(
                    "impact_speed",
                    "`impact_speed` tells at which speed `contact_time` or `max_overlap` was seen; none of them is given",
                );
            }
            (None, None) => return Ok(None),
            (Some(_), Some(_)) => {
                return refuse(
                    "contact_time",
                    "`contact_time` and `max_overlap` both tell the stiffness; give one of them",
                );
            }
            (Some(_), None) => "contact_time",
            (None, Some(_)) => "max_overlap",
        };
        let Some(restitution) = restitution else {
            return refuse(
                named,
                &format!("`{named}` tells the stiffness only together with `restitution`"),
            );
        };
        let constant = matches!(restitution, Restitution::Constant(_));
        let speed = match self.impact_speed {
            Some(speed) => speed,
            // the duration of a linear collision is the same at every speed
            None if law == SpringDashpot::Linear && constant && named == "contact_time" => 1.0,
            None => {
                let message = format!("`{named}` needs the `impact_speed` at which it was seen");
                return refuse(named, &message);
            }
        };
        let collision = Collision {
            law,
            end,
            mass: 1.0,
            speed,
            restitution: restitution.at(speed),
        };
        let found = match (self.contact_time, self.max_overlap) {
            (Some(time), _) => collision.stiffness_of_contact_time(time),
            (_, overlap) => collision.stiffness_of_max_overlap(overlap.unwrap_or(f64::NAN)),
        };
        found
            .map(Some)
            .map_err(|error| ParameterError::together(named, error.to_string()))
    }
}

/// Collisions of a lower restitution than this need no shorter steps: what is left of the speed is too little.
const LEAST_RESOLVED: f64 = 0.01;

/// Duration of a collision with this damping ratio that must be resolved, in the units of its law.
pub(super) fn unit_duration(law: SpringDashpot, ratio: f64, end: ContactEnd) -> Result<f64, RestitutionError> {
    let ratio = ratio.min(ratio_of(LEAST_RESOLVED, end));
    match law {
        SpringDashpot::Linear => LinearCollision::new(ratio)?.contact_time(end),
        SpringDashpot::Hertz => HertzCollision::new(5f64.sqrt() * ratio)?.contact_time(end),
    }
}

/// Refuses a damping ratio at which the overlap never returns to zero, where contact ends there.
pub(super) fn check_end(ratio: f64, end: ContactEnd, what: &str, limit: &str) -> Result<(), String> {
    if end == ContactEnd::ZeroForce || ratio < 1.0 {
        return Ok(());
    }
    Err(format!(
        "{what} is over-damped: the bodies would never part, as contact ends at zero overlap. It must stay below {limit}; \
         or set `contact_end = \"zero-force\"`"
    ))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::{Collision, HeadOn, Start, Tolerance};
    use crate::contact::normal::NormalLaw;
    use crate::contact::{Elastic, LawError, MaterialPair, PairSize};
    use crate::parameters::{Value, Values, values};
    use approx::assert_relative_eq;

    const PAIR: MaterialPair = MaterialPair {
        a: Elastic {
            young_modulus: 6e9,
            poisson_ratio: 0.3,
        },
        b: Elastic {
            young_modulus: 70e9,
            poisson_ratio: 0.2,
        },
    };

    /// A pair of unequal spheres, and a grain on a wall.
    const SIZES: [PairSize; 2] = [PairSize::new(2.5e-7, 3e-16), PairSize::new(0.03, 0.3)];

    fn build(law: &str, numbers: &[(&str, f64)], others: &[(&str, Value)]) -> Result<NormalLaw, LawError> {
        let mut given: Values = values(numbers);
        given.extend(others.iter().map(|(name, value)| ((*name).to_string(), value.clone())));
        NormalLaw::build(law, &given, &PAIR)
    }

    fn collide(law: &NormalLaw, size: PairSize, speed: f64) -> Collision {
        let start = Start::Contact;
        let impact = HeadOn {
            law,
            size,
            speed,
            start,
        };
        impact.run(&Tolerance::default()).unwrap()
    }

    #[test]
    fn what_is_asked_is_seen_in_every_way_of_asking() {
        for law in ["linear", "hertz-tsuji"] {
            for end in ENDS {
                for e in [0.05, 0.1353, 0.3, 0.54, 0.9, 1.0] {
                    for size in SIZES {
                        let end = [("contact_end", Value::from(end))];
                        let at = [("restitution", e), ("impact_speed", 0.7)];
                        let timed = build(law, &[at[0], at[1], ("contact_time", 3e-5)], &end).unwrap();
                        let seen = collide(&timed, size, 0.7);
                        assert_relative_eq!(seen.restitution, e, max_relative = 1e-9);
                        assert_relative_eq!(seen.contact_time().unwrap(), 3e-5, max_relative = 1e-9);
                        let deep = build(law, &[at[0], at[1], ("max_overlap", 2e-8)], &end).unwrap();
                        let seen = collide(&deep, size, 0.7);
                        assert_relative_eq!(seen.restitution, e, max_relative = 1e-9);
                        assert_relative_eq!(seen.max_overlap, 2e-8, max_relative = 1e-9);
                    }
                }
            }
        }
    }

    #[test]
    fn raw_coefficients_and_the_over_damped_limit() {
        let size = SIZES[1];
        // gamma/omega0 = 0.2 and alpha = 0.2 sqrt(5) give one restitution
        let linear = build(
            "linear",
            &[("stiffness", 1e4), ("damping_rate", 0.2 * (1e4f64 / 0.3).sqrt())],
            &[],
        )
        .unwrap();
        let hertz = build("hertz-tsuji", &[("alpha", 0.2 * 5f64.sqrt())], &[]).unwrap();
        let expected = libm::exp(-0.2 * std::f64::consts::PI / 0.96f64.sqrt());
        for law in [linear, hertz] {
            assert_relative_eq!(collide(&law, size, 1.0).restitution, expected, max_relative = 1e-9);
        }
        let error = build("hertz-tsuji", &[("alpha", 2.3)], &[]).unwrap_err().to_string();
        assert!(
            error.contains("sqrt(5) = 2.2360679775") && error.contains("zero-force"),
            "{error}"
        );
        let soft = [("contact_end", Value::from("zero-force"))];
        let over = build("hertz-tsuji", &[("alpha", 2.0 * 5f64.sqrt())], &soft).unwrap();
        // g = 2: e = exp(-2 n g/sqrt(g^2 - 1)), n = arccosh(g)
        let n = libm::acosh(2.0);
        let expected = libm::exp(-4.0 * n / 3f64.sqrt());
        assert_relative_eq!(collide(&over, size, 1.0).restitution, expected, max_relative = 1e-8);
    }

    #[test]
    fn a_profile_is_met_at_every_speed() {
        let table = Value::Table(vec![[0.01, 0.95], [0.1, 0.9], [1.0, 0.7], [10.0, 0.3]]);
        for profile in [table, Value::from("0.8 * exp(-v/20) + 0.1/(1 + v)")] {
            let asked = Restitution::of(&[("restitution".to_string(), profile.clone())].into(), "restitution").unwrap();
            for (law, numbers) in [("linear", &[("stiffness", 1e5)][..]), ("hertz-tsuji", &[])] {
                for end in ENDS {
                    let others = [("restitution", profile.clone()), ("contact_end", Value::from(end))];
                    let law = build(law, numbers, &others).unwrap();
                    for speed in [1e-3, 0.05, 0.1, 0.8, 3.0, 25.0] {
                        let seen = collide(&law, SIZES[1], speed).restitution;
                        assert_relative_eq!(seen, asked.at(speed), max_relative = 1e-9);
                    }
                }
            }
        }
    }

    #[test]
    fn requests_that_contradict_themselves_are_refused() {
        let refused = |law, numbers: &[(&str, f64)], part: &str| {
            let error = build(law, numbers, &[]).unwrap_err().to_string();
            assert!(error.contains(part), "{error}");
        };
        let e = ("restitution", 0.5);
        refused("linear", &[e], "the stiffness is missing");
        refused("linear", &[("stiffness", 1.0)], "the damping is missing");
        refused("linear", &[e, ("stiffness", 1.0), ("contact_time", 1.0)], "given twice");
        refused("linear", &[e, ("max_overlap", 1.0)], "needs the `impact_speed`");
        refused(
            "linear",
            &[("damping_rate", 1.0), ("contact_time", 1.0)],
            "only together with `restitution`",
        );
        refused("hertz-tsuji", &[e, ("alpha", 0.1)], "both tell the damping");
        refused("hertz-tsuji", &[e, ("impact_speed", 0.1)], "none of them is given");
        refused("hertz-tsuji", &[e, ("contact_time", 0.1)], "needs the `impact_speed`");
        let formula = [("restitution", Value::from("1 - 0.1*v"))];
        let error = build("hertz-tsuji", &[], &formula).unwrap_err().to_string();
        assert!(error.contains("restitution"), "{error}");
    }
}
