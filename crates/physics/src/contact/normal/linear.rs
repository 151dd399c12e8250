#![doc = include_str!("linear.md")]

use super::spring_dashpot::{
    Damping, Dashpot, ENDS, Observed, check_end, contact_end, exactly_one_damping, unit_duration,
};
use super::window::{contact_share, mean_overlap};
use super::{Normal, NormalInput, NormalResponse};
use crate::contact::{MaterialPair, PairSize};
use crate::dimension::Dimension;
use crate::lanes::Lanes;
use crate::parameters::{Alternatives, ParameterError, ParameterInfo, Range, Values};
use crate::params;
use crate::restitution::ContactEnd;
use crate::restitution::inverse::SpringDashpot;
use std::f64::consts::PI;

params! {
    /// Parameters of the linear spring-dashpot.
    pub struct LinearParameters {
        stiffness: STIFFNESS, usual 1e4, in Range::POSITIVE, "Normal stiffness, force per overlap";
        contact_time: TIME, optional 1e-4, in Range::POSITIVE,
            "Duration of a collision, the same for every pair of sizes; in place of the stiffness";
        max_overlap: LENGTH, optional 1e-5, in Range::POSITIVE,
            "Largest overlap of a collision at the impact speed, the same for every pair of sizes; in place of the stiffness";
        impact_speed: VELOCITY, optional 1.0, in Range::POSITIVE,
            "Impact speed at which `max_overlap` or `contact_time` is seen";
        restitution: NONE, profile 0.9, in Range::POSITIVE_SHARE,
            "Coefficient of restitution; a table or a formula makes it depend on the impact speed";
        damping_rate: FREQUENCY, optional 100.0, in Range::NOT_NEGATIVE,
            "Damping rate gamma, in place of the restitution";
        contact_end: NONE, choice ENDS, "Where contact ends";
    }
}

/// The linear spring-dashpot bound to a pair of materials.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Linear {
    /// Part of the stiffness that does not depend on the bodies [N/m].
    stiffness: f64,
    /// Stiffness per effective mass [1/s^2].
    per_mass: f64,
    damping: Damping,
    end: ContactEnd,
}

impl Linear {
    #[inline(always)]
    fn k<L: Lanes>(&self, size: PairSize<L>) -> L {
        size.spring_mass * self.per_mass + self.stiffness
    }
}

impl Normal for Linear {
    const NAME: &'static str = "linear";
    const SUMMARY: &'static str = "linear spring-dashpot (LSD)";
    const DOC: &'static str = include_str!("linear.md");
    const PARAMETERS: &'static [ParameterInfo] = LinearParameters::TABLE;
    const ALTERNATIVES: &'static [Alternatives] = &[
        Alternatives {
            of: &["stiffness", "contact_time", "max_overlap"],
            with: &["impact_speed"],
        },
        Alternatives {
            of: &["restitution", "damping_rate"],
            with: &[],
        },
    ];
    const HISTORY: &'static [Dimension] = &[Dimension::NONE];
    const LASTING: usize = 0;

    fn new(values: &Values, _pair: &MaterialPair) -> Result<Self, Vec<ParameterError>> {
        let p = LinearParameters::from_values(values)?;
        let end = contact_end(p.contact_end);
        exactly_one_damping(&p.restitution, &p.damping_rate, "damping_rate")?;
        let observed = Observed {
            contact_time: p.contact_time,
            max_overlap: p.max_overlap,
            impact_speed: p.impact_speed,
        };
        let per_mass = observed.stiffness_per_mass(SpringDashpot::Linear, p.restitution, end)?;
        let (stiffness, per_mass) = match (p.stiffness, per_mass) {
            (Some(stiffness), None) => (stiffness, 0.0),
            (None, Some(per_mass)) => (0.0, per_mass),
            (None, None) => {
                let message = "the stiffness is missing: give `stiffness`, `contact_time`, or `max_overlap` at an \
                               `impact_speed`";
                return Err(ParameterError::together("stiffness", message));
            }
            (Some(_), Some(_)) => {
                let message = "`stiffness` is given twice: as itself and through `contact_time` or `max_overlap`";
                return Err(ParameterError::together("stiffness", message));
            }
        };
        let damping = match (p.restitution, p.damping_rate) {
            (Some(restitution), _) => Damping::of(restitution, end),
            (None, rate) => Damping::Rate(rate.unwrap_or(0.0)),
        };
        Ok(Self {
            stiffness,
            per_mass,
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
        let k = self.k(input.size);
        let damping = match self.damping.dashpot(input, 2.0, history) {
            Dashpot::Units(number) => (k * input.size.mass).sqrt() * number,
            Dashpot::Known(coefficient) => coefficient,
        };
        let response = NormalResponse::spring_dashpot(input, k * mean_overlap(input), damping * contact_share(input));
        response.ending_at(self.end)
    }

    #[inline(always)]
    fn energy(&self, size: PairSize, overlap: f64, _history: &[f64]) -> f64 {
        let d = overlap.max(0.0);
        0.5 * self.k(size) * d * d
    }

    #[inline(always)]
    fn stiffness(&self, size: PairSize, overlap: f64, history: &[f64]) -> f64 {
        self.stiffness_wide(size, overlap, history)
    }

    #[inline(always)]
    fn stiffness_wide<L: Lanes>(&self, size: PairSize<L>, _overlap: L, _history: &[L]) -> L {
        self.k(size)
    }

    fn collision_time(&self, size: PairSize, overlap: f64) -> f64 {
        let frequency = (self.k(size) / size.mass).sqrt();
        let ratio = self.damping.ratio_at(frequency, overlap * frequency);
        unit_duration(SpringDashpot::Linear, ratio, self.end).unwrap_or(PI) / frequency
    }

    #[inline(always)]
    fn history(&self) -> usize {
        self.damping.history()
    }

    fn check(&self, size: PairSize) -> Result<(), String> {
        let frequency = (self.k(size) / size.mass).sqrt();
        match self.damping {
            Damping::Rate(rate) => {
                let what = format!("`damping_rate` {rate} 1/s");
                let limit = format!("sqrt(k/m), {frequency} 1/s for an effective mass of {} kg", size.mass);
                check_end(rate / frequency, self.end, &what, &limit)
            }
            _ => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::Elastic;
    use approx::assert_relative_eq;

    const ANY: Elastic = Elastic {
        young_modulus: 1e9,
        poisson_ratio: 0.3,
    };

    /// Duration, largest overlap and restitution of a collision at the impact speed 1, integrated with Runge-Kutta.
    fn collide(law: &Linear, size: PairSize) -> [f64; 3] {
        let slope = |[d, v]: [f64; 2]| {
            // the law ends at zero overlap; the last step looks a little beyond it
            let input = NormalInput::at(size, d.abs().max(f64::MIN_POSITIVE), v);
            let response = law.respond(&input, &mut []);
            [v, -(response.elastic.copysign(d) + response.damping * v) / size.mass]
        };
        let advance = |y: [f64; 2], dt: f64| {
            let shifted = |k: [f64; 2], share: f64| std::array::from_fn(|i| y[i] + share * dt * k[i]);
            let k1 = slope(y);
            let k2 = slope(shifted(k1, 0.5));
            let k3 = slope(shifted(k2, 0.5));
            let k4 = slope(shifted(k3, 1.0));
            std::array::from_fn(|i| y[i] + dt / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]))
        };
        let end_at_zero = |y: [f64; 2], dt: f64, component: usize| {
            let (mut lower, mut upper) = (0.0, dt);
            for _ in 0..100 {
                let middle = 0.5 * (lower + upper);
                if advance(y, middle)[component] > 0.0 {
                    lower = middle;
                } else {
                    upper = middle;
                }
            }
            (lower, advance(y, lower))
        };
        let dt = 1e-3 * (size.mass / law.stiffness).sqrt();
        let (mut y, mut steps, mut largest): ([f64; 2], u32, f64) = ([0.0, 1.0], 0, 0.0);
        while steps < 1_000_000 {
            let next = advance(y, dt);
            if y[1] > 0.0 && next[1] <= 0.0 {
                largest = end_at_zero(y, dt, 1).1[0];
            }
            if next[0] <= 0.0 {
                let (rest, end) = end_at_zero(y, dt, 0);
                return [f64::from(steps) * dt + rest, largest, -end[1]];
            }
            y = next;
            steps += 1;
        }
        panic!("the bodies never parted");
    }

    #[test]
    fn duration_overlap_and_restitution_of_damped_collisions() {
        for restitution in [0.05, 0.1, 0.54, 0.9, 1.0] {
            for (stiffness, mass) in [(1e4, 2e-3), (37.0, 5.0)] {
                let values = [("stiffness", stiffness), ("restitution", restitution)];
                let law = Linear::new(&crate::parameters::values(&values), &MaterialPair { a: ANY, b: ANY }).unwrap();
                let size = PairSize::new(1e-3, mass);
                let [duration, overlap, e] = collide(&law, size);
                // eqs 7 and 21 of Antypov and Elliott
                let l = -libm::log(restitution);
                let g = l / (l * l + std::f64::consts::PI * std::f64::consts::PI).sqrt();
                let w = (1.0 - g * g).sqrt();
                let unit_time = (mass / stiffness).sqrt();
                let expected = unit_time * libm::exp(-(g / w) * libm::atan2(w, g));
                assert_relative_eq!(overlap, expected, max_relative = 1e-9);
                assert_relative_eq!(duration, unit_time * std::f64::consts::PI / w, max_relative = 1e-9);
                assert_relative_eq!(duration, law.collision_time(size, overlap), max_relative = 1e-9);
                assert_relative_eq!(e, restitution, max_relative = 1e-9);
            }
        }
    }
}
