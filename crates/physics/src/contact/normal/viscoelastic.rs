#![doc = include_str!("viscoelastic.md")]

use super::hertz_spring::{HertzSpring, Power};
use super::{Normal, NormalInput, NormalResponse};
use crate::contact::lane_by_lane::{noted, some_new};
use crate::contact::{MaterialPair, PairSize};
use crate::dimension::Dimension;
use crate::lanes::Lanes;
use crate::parameters::{Alternatives, ParameterError, ParameterInfo, Range, Values};
use crate::params;
use crate::restitution::ContactEnd;
use crate::restitution::duration::UNDAMPED;
use crate::restitution::viscoelastic::ViscoelasticCollision;

params! {
    /// Parameters of viscoelastic spheres.
    pub struct ViscoelasticParameters {
        restitution: NONE, usual 0.8, in Range::POSITIVE_SHARE, "Coefficient of restitution at the impact speed";
        impact_speed: VELOCITY, usual 1.0, in Range::POSITIVE, "Impact speed at which the restitution is wanted";
        dissipation_time: TIME, optional 1e-7, in Range::NOT_NEGATIVE,
            "Dissipative constant A of the two solids, in place of the restitution";
        contact_end: NONE, choice ["zero-force", "zero-overlap"], "Where contact ends";
    }
}

/// Damping number up to which collisions are resolved: the restitution is then below 0.05.
const MOST_RESOLVED: f64 = 10.0;

/// Damping as it was asked for.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Damping {
    /// `A` [s].
    Time(f64),
    /// `beta`, and the impact speed [m/s] at which it is to be.
    Number(f64, f64),
}

/// Viscoelastic contact bound to a pair of materials.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Viscoelastic {
    spring: HertzSpring,
    damping: Damping,
    end: ContactEnd,
}

impl Viscoelastic {
    /// `A` of two bodies [s]: `beta / ((3/2) (K/m)^(2/5) v0^(1/5))`.
    fn dissipation_time(&self, size: PairSize) -> f64 {
        match self.damping {
            Damping::Time(time) => time,
            Damping::Number(beta, speed) => {
                let rate = libm::pow(self.spring.stiffness(size) / size.mass, 0.4) * libm::pow(speed, 0.2);
                beta / (1.5 * rate)
            }
        }
    }

    /// The same, remembered by a contact where it takes long to find.
    #[inline(always)]
    fn remembered_time<L: Lanes>(&self, size: PairSize<L>, history: &mut [L]) -> L {
        match self.damping {
            Damping::Time(time) => L::splat(time),
            Damping::Number(0.0, _) => L::splat(0.0),
            Damping::Number(..) => {
                if some_new(history[0]) {
                    history[0] = noted(history[0], |lane| self.dissipation_time(size.lane(lane)));
                }
                history[0]
            }
        }
    }
}

impl Normal for Viscoelastic {
    const NAME: &'static str = "viscoelastic";
    const SUMMARY: &'static str = "viscoelastic spheres (Kuwabara-Kono, Brilliantov): faster impacts lose more";
    const DOC: &'static str = include_str!("viscoelastic.md");
    const PARAMETERS: &'static [ParameterInfo] = ViscoelasticParameters::TABLE;
    const ALTERNATIVES: &'static [Alternatives] = &[Alternatives {
        of: &["restitution", "dissipation_time"],
        with: &["impact_speed"],
    }];
    const HISTORY: &'static [Dimension] = &[Dimension::TIME];
    const LASTING: usize = 0;

    fn new(values: &Values, pair: &MaterialPair) -> Result<Self, Vec<ParameterError>> {
        let p = ViscoelasticParameters::from_values(values)?;
        let refuse = |name: &'static str, message: &str| Err(ParameterError::together(name, message));
        let end = match p.contact_end {
            0 => ContactEnd::ZeroForce,
            _ => ContactEnd::ZeroOverlap,
        };
        let damping = match (p.restitution, p.impact_speed, p.dissipation_time) {
            (None, None, Some(time)) => Damping::Time(time),
            (Some(e), Some(speed), None) => match ViscoelasticCollision::from_restitution(e, end) {
                Ok(collision) => Damping::Number(collision.beta(), speed),
                Err(error) => return refuse("restitution", &error.to_string()),
            },
            (Some(_), _, Some(_)) => {
                return refuse(
                    "restitution",
                    "`restitution` and `dissipation_time` both tell the damping; give one of them",
                );
            }
            (Some(_), None, None) => {
                return refuse(
                    "impact_speed",
                    "`restitution` needs the `impact_speed` at which it is wanted: under this law it depends on the speed",
                );
            }
            (None, _, Some(_)) => {
                return refuse(
                    "impact_speed",
                    "`impact_speed` goes with `restitution`, which is missing",
                );
            }
            (None, _, None) => {
                return refuse(
                    "restitution",
                    "the damping is missing: give `restitution` at an `impact_speed`, or `dissipation_time`",
                );
            }
        };
        Ok(Self {
            spring: HertzSpring::of(pair),
            damping,
            end,
        })
    }

    const WIDE: bool = true;

    #[inline(always)]
    fn respond(&self, input: &NormalInput, history: &mut [f64]) -> NormalResponse {
        self.respond_wide(input, history)
    }

    #[inline(always)]
    fn respond_wide<L: Lanes>(&self, input: &NormalInput<L>, history: &mut [L]) -> NormalResponse<L> {
        let time = self.remembered_time(input.size, history);
        let damping = self.spring.mean(Power::Secant, input) * time * 1.5;
        NormalResponse::spring_dashpot(input, self.spring.mean(Power::Force, input), damping).ending_at(self.end)
    }

    #[inline(always)]
    fn energy(&self, size: PairSize, overlap: f64, _history: &[f64]) -> f64 {
        self.spring.energy(size, overlap)
    }

    #[inline(always)]
    fn stiffness(&self, size: PairSize, overlap: f64, history: &[f64]) -> f64 {
        self.stiffness_wide(size, overlap, history)
    }

    #[inline(always)]
    fn stiffness_wide<L: Lanes>(&self, size: PairSize<L>, overlap: L, _history: &[L]) -> L {
        self.spring.tangent(size, overlap)
    }

    fn collision_time(&self, size: PairSize, overlap: f64) -> f64 {
        let speed = self.spring.impact_speed(size, overlap);
        let unit_of_time = self.spring.unit_of_time(size, speed);
        let unit = match self.end {
            // without damping it is shortest
            ContactEnd::ZeroOverlap => UNDAMPED,
            ContactEnd::ZeroForce => {
                let beta = 1.5 * self.dissipation_time(size) / unit_of_time;
                // stronger damping leaves too little of the speed to need shorter steps
                let collision = ViscoelasticCollision::new(beta.min(MOST_RESOLVED));
                collision.and_then(|c| c.contact_time(self.end)).unwrap_or(UNDAMPED)
            }
        };
        unit * unit_of_time
    }

    #[inline(always)]
    fn history(&self) -> usize {
        match self.damping {
            Damping::Time(_) => 0,
            Damping::Number(..) => 1,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::restitution_of;
    use crate::contact::Elastic;
    use crate::parameters::{Value, values};
    use approx::assert_relative_eq;

    const GLASS: Elastic = Elastic {
        young_modulus: 63e9,
        poisson_ratio: 0.22,
    };

    const SIZE: PairSize = PairSize::new(1e-3, 2e-6);

    fn build(numbers: &[(&str, f64)], end: &str) -> Result<Viscoelastic, Vec<ParameterError>> {
        let mut given = values(numbers);
        given.insert("contact_end".to_string(), Value::from(end));
        Viscoelastic::new(&given, &MaterialPair { a: GLASS, b: GLASS })
    }

    #[test]
    fn the_requested_restitution_is_realised_at_its_speed() {
        for end in ["zero-force", "zero-overlap"] {
            for e in [0.05, 0.3, 0.8, 0.99, 1.0] {
                for size in [SIZE, PairSize::new(0.3, 50.0)] {
                    let law = build(&[("restitution", e), ("impact_speed", 0.4)], end).unwrap();
                    assert_relative_eq!(restitution_of(&law, size, 0.4).unwrap(), e, max_relative = 1e-9);
                }
            }
        }
    }

    #[test]
    fn slower_impacts_lose_less_by_the_law_of_brilliantov() {
        let law = build(&[("dissipation_time", 2e-8)], "zero-overlap").unwrap();
        let k = law.spring.stiffness(SIZE);
        for speed in [1e-4f64, 1e-2, 1.0, 5.0] {
            let beta = 1.5 * 2e-8 * (k / SIZE.mass).powf(0.4) * speed.powf(0.2);
            let expected = ViscoelasticCollision::new(beta).unwrap();
            let expected = expected.restitution(ContactEnd::ZeroOverlap).unwrap();
            assert_relative_eq!(
                restitution_of(&law, SIZE, speed).unwrap(),
                expected,
                max_relative = 1e-9
            );
        }
    }

    #[test]
    fn contradictions_are_refused() {
        let refused = |numbers: &[(&str, f64)], part: &str| {
            let error = build(numbers, "zero-force").unwrap_err()[0].to_string();
            assert!(error.contains(part), "{error}");
        };
        refused(&[], "the damping is missing");
        refused(&[("restitution", 0.5)], "needs the `impact_speed`");
        refused(
            &[("restitution", 0.5), ("dissipation_time", 1e-8)],
            "both tell the damping",
        );
        refused(
            &[("impact_speed", 0.5), ("dissipation_time", 1e-8)],
            "goes with `restitution`",
        );
        refused(&[("restitution", 1e-9), ("impact_speed", 1.0)], "at least 1.32e-5");
    }
}
