#![doc = include_str!("linear.md")]

use super::{Normal, NormalInput, NormalResponse, mean_slope, near_end};
use crate::contact::{MaterialPair, PairSize};
use crate::dimension::Dimension;
use crate::parameters::{ParameterError, ParameterInfo, Range, Values};
use crate::{params, restitution};

params! {
    /// Parameters of the linear spring-dashpot.
    pub struct LinearParameters {
        stiffness: STIFFNESS, required 1e4, in Range::POSITIVE, "Normal stiffness, force per overlap";
        restitution: NONE, required 0.9, in Range::POSITIVE_SHARE,
            "Coefficient of restitution, the same at every impact speed";
    }
}

/// The linear spring-dashpot bound to a pair of materials.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Linear {
    stiffness: f64,
    restitution: f64,
    damping_ratio: f64,
}

impl Normal for Linear {
    const NAME: &'static str = "linear";
    const SUMMARY: &'static str = "linear spring-dashpot (LSD), damping from restitution";
    const DOC: &'static str = include_str!("linear.md");
    const PARAMETERS: &'static [ParameterInfo] = LinearParameters::TABLE;
    const HISTORY: &'static [Dimension] = &[];

    fn new(values: &Values, _pair: &MaterialPair) -> Result<Self, Vec<ParameterError>> {
        let p = LinearParameters::from_values(values)?;
        Ok(Self {
            stiffness: p.stiffness,
            restitution: p.restitution,
            damping_ratio: restitution::damping_ratio(p.restitution),
        })
    }

    #[inline(always)]
    fn respond(&self, input: &NormalInput, _history: &mut [f64]) -> NormalResponse {
        let damping = 2.0 * self.damping_ratio * (self.stiffness * input.size.mass).sqrt();
        if near_end(input) {
            NormalResponse::viscoelastic(
                mean_slope(input, |d| 0.5 * self.stiffness * d * d),
                mean_slope(input, |d| damping * d),
            )
        } else if input.overlap > 0.0 {
            NormalResponse::viscoelastic(self.stiffness * input.overlap, damping)
        } else {
            NormalResponse::NOTHING
        }
    }

    #[inline(always)]
    fn energy(&self, _size: PairSize, overlap: f64, _history: &[f64]) -> f64 {
        let d = overlap.max(0.0);
        0.5 * self.stiffness * d * d
    }

    #[inline(always)]
    fn stiffness(&self, _size: PairSize, _overlap: f64, _history: &[f64]) -> f64 {
        self.stiffness
    }

    fn collision_time(&self, size: PairSize, _overlap: f64) -> f64 {
        restitution::linear_contact_time(self.stiffness, size.mass, self.restitution)
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
                let size = PairSize { radius: 1e-3, mass };
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
