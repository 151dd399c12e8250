#![doc = include_str!("walton_braun.md")]

use super::hysteresis::{Attraction, Hysteresis, Memory, Power, PullOff, Unloading};
use super::path::follow;
use super::{Normal, NormalInput, NormalResponse};
use crate::contact::{MaterialPair, PairSize};
use crate::dimension::Dimension;
use crate::lanes::Lanes;
use crate::parameters::{Alternatives, ParameterError, ParameterInfo, Range, Values};
use crate::params;
use std::f64::consts::PI;

params! {
    /// Parameters of the law of Walton and Braun.
    pub struct WaltonBraunParameters {
        loading_stiffness: STIFFNESS, required 1e4, in Range::POSITIVE, "Stiffness of first loading, force per overlap";
        restitution: NONE, usual 0.8, in Range::POSITIVE_SHARE,
            "Coefficient of restitution, the same at every impact speed; gives the unloading stiffness";
        unloading_stiffness: STIFFNESS, optional 1.6e4, in Range::POSITIVE,
            "Stiffness of unloading and reloading, at least that of loading; in place of the restitution";
        stiffness_growth: PER_LENGTH, optional 1e4, in Range::NOT_NEGATIVE,
            "Growth of the unloading stiffness with the largest force; in place of the restitution";
    }
}

/// The law of Walton and Braun.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WaltonBraun {
    loading: f64,
    unloading: Unloading,
}

impl WaltonBraun {
    /// The loop, and the memory of contacts.
    #[inline(always)]
    fn bound<L: Lanes>(&self, history: &[L]) -> (Hysteresis<L>, Memory<L>) {
        let spring = Hysteresis {
            loading: L::splat(self.loading),
            unloading: self.unloading.in_lanes(),
            pull_off: PullOff::None,
            power: Power::Linear,
            pull_off_power: 1.0,
            attraction: Attraction::NONE,
            damping: L::splat(0.0),
        };
        (spring, spring.at_peak(history[0], history[0]))
    }
}

impl Normal for WaltonBraun {
    const NAME: &'static str = "walton-braun";
    const SUMMARY: &'static str = "stiffer on unloading than on loading (plastic dent), without adhesion";
    const DOC: &'static str = include_str!("walton_braun.md");
    const PARAMETERS: &'static [ParameterInfo] = WaltonBraunParameters::TABLE;
    const ALTERNATIVES: &'static [Alternatives] = &[Alternatives {
        of: &["restitution", "unloading_stiffness", "stiffness_growth"],
        with: &[],
    }];
    const HISTORY: &'static [Dimension] = &[Dimension::LENGTH];
    const FOLLOWS_KINKS: bool = true;

    fn new(values: &Values, _pair: &MaterialPair) -> Result<Self, Vec<ParameterError>> {
        let p = WaltonBraunParameters::from_values(values)?;
        let k1 = p.loading_stiffness;
        let unloading = match (p.restitution, p.unloading_stiffness, p.stiffness_growth) {
            (Some(e), None, None) => Unloading::of_lines(k1, k1 / (e * e)),
            (None, Some(k2), None) if k2 >= k1 => Unloading::of_lines(k1, k2),
            (None, Some(k2), None) => {
                let message = format!(
                    "`unloading_stiffness` is {k2} N/m, below `loading_stiffness`, {k1} N/m: the contact would give more \
                     energy than it took"
                );
                return Err(ParameterError::together("unloading_stiffness", message));
            }
            (None, None, Some(growth)) => Unloading::Growing {
                growth: growth * k1,
                deepest: f64::INFINITY,
            },
            _ => {
                let message = "give one of `restitution`, `unloading_stiffness` and `stiffness_growth`";
                return Err(ParameterError::together("restitution", message));
            }
        };
        Ok(Self { loading: k1, unloading })
    }

    const WIDE: bool = true;

    #[inline(always)]
    fn respond(&self, input: &NormalInput, history: &mut [f64]) -> NormalResponse {
        self.respond_wide(input, history)
    }

    #[inline(always)]
    fn respond_wide<L: Lanes>(&self, input: &NormalInput<L>, history: &mut [L]) -> NormalResponse<L> {
        let (spring, memory) = self.bound(history);
        let (response, next) = follow(&spring, input, memory);
        history[0] = next.peak;
        response
    }

    fn energy(&self, _size: PairSize, overlap: f64, history: &[f64]) -> f64 {
        let (spring, memory) = self.bound(history);
        spring.energy(memory, overlap)
    }

    fn stiffness(&self, size: PairSize, overlap: f64, history: &[f64]) -> f64 {
        self.stiffness_wide(size, overlap, history)
    }

    #[inline(always)]
    fn stiffness_wide<L: Lanes>(&self, _size: PairSize<L>, overlap: L, history: &[L]) -> L {
        let (spring, memory) = self.bound(history);
        spring.stiffness(memory, overlap)
    }

    fn collision_time(&self, size: PairSize, overlap: f64) -> f64 {
        let (spring, _) = self.bound(&[0.0]);
        PI * (size.mass / spring.steepest(overlap)).sqrt()
    }

    fn reach(&self, _size: PairSize, history: &[f64]) -> f64 {
        let (spring, memory) = self.bound(history);
        spring.reach(memory)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::{Collision, HeadOn, Start, Tolerance};
    use crate::contact::Elastic;
    use crate::parameters::values;
    use approx::assert_relative_eq;

    const ANY: Elastic = Elastic {
        young_modulus: 1e9,
        poisson_ratio: 0.3,
    };

    fn law(pairs: &[(&str, f64)]) -> Result<WaltonBraun, Vec<ParameterError>> {
        WaltonBraun::new(&values(pairs), &MaterialPair { a: ANY, b: ANY })
    }

    fn collide(law: &WaltonBraun, mass: f64, speed: f64) -> Collision {
        let size = PairSize::new(1e-2, mass);
        let impact = HeadOn {
            law,
            size,
            speed,
            start: Start::Contact,
        };
        impact.run(&Tolerance::default()).unwrap()
    }

    #[test]
    fn the_curve_of_loading_unloading_and_reloading() {
        let law = law(&[("loading_stiffness", 1e4), ("unloading_stiffness", 4e4)]).unwrap();
        let size = PairSize::new(1e-2, 1e-3);
        let mut history = [0.0];
        // overlap and force: up to 1 um the loading line; down the line of 4e4 N/m to the dent at 0.75 um; up again
        for (overlap, force) in [
            (0.5e-6, 5e-3),
            (1e-6, 10e-3),
            (0.9e-6, 6e-3),
            (0.8e-6, 2e-3),
            (0.75e-6, 0.0),
            (0.1e-6, 0.0),
            (0.8e-6, 2e-3),
            (1e-6, 10e-3),
            (1.2e-6, 12e-3),
            (0.9e-6, 0.0),
            (1.0e-6, 4e-3),
        ] {
            let found = law.respond(&NormalInput::at(size, overlap, 0.0), &mut history).elastic;
            assert_relative_eq!(found, force, max_relative = 1e-12, epsilon = 1e-16);
        }
        assert_relative_eq!(law.reach(size, &history), -0.9e-6, max_relative = 1e-12);
    }

    #[test]
    fn windows_as_short_as_the_rounding_of_the_overlap_give_the_plain_force() {
        let law = law(&[("loading_stiffness", 1e4), ("unloading_stiffness", 4e4)]).unwrap();
        let (overlap, size) = (0.7e-6, PairSize::default());
        let digit = overlap * f64::EPSILON;
        for half_window in [1e-3, 0.3, 0.6, 1.3, 10.3].map(|share| share * digit) {
            for rate in [1.0, -1.0] {
                let input = NormalInput {
                    size,
                    overlap,
                    rate,
                    half_window,
                };
                let response = law.respond(&input, &mut [overlap]);
                assert_relative_eq!(response.elastic, 1e4 * overlap, max_relative = 1e-13);
            }
        }
    }

    #[test]
    fn constant_restitution() {
        for e in [0.05, 0.3, 0.8, 1.0] {
            for (mass, speed) in [(1e-4, 1e-3), (1e-4, 3.0), (20.0, 0.1)] {
                let law = law(&[("loading_stiffness", 2e5), ("restitution", e)]).unwrap();
                let found = collide(&law, mass, speed);
                assert_relative_eq!(found.restitution, e, max_relative = 1e-10);
                let depth = speed * (mass / 2e5).sqrt();
                assert_relative_eq!(found.max_overlap, depth, max_relative = 1e-10);
                // 1/2 k1 D^2 (1 - k1/k2)
                let lost = 0.5 * 2e5 * depth * depth * (1.0 - e * e);
                assert_relative_eq!(
                    found.energy.lost,
                    lost,
                    max_relative = 1e-9,
                    epsilon = 1e-11 * found.energy.kinetic_before
                );
                // a quarter of each period
                let time = 0.5 * PI * (mass / 2e5).sqrt() * (1.0 + e);
                assert_relative_eq!(found.duration, time, max_relative = 1e-9);
            }
        }
    }

    #[test]
    fn restitution_falls_with_the_speed_where_the_stiffness_grows() {
        for (growth, mass, speed) in [(1e4, 1e-4, 0.1), (1e4, 1e-4, 5.0), (300.0, 2.0, 0.5), (0.0, 1.0, 1.0)] {
            let law = law(&[("loading_stiffness", 2e5), ("stiffness_growth", growth)]).unwrap();
            // sqrt(w/(S v + w)), Walton and Braun
            let frequency = f64::sqrt(2e5 / mass);
            let expected = (frequency / (growth * speed + frequency)).sqrt();
            assert_relative_eq!(collide(&law, mass, speed).restitution, expected, max_relative = 1e-10);
        }
    }

    #[test]
    fn parameters_that_exclude_each_other_are_refused() {
        let told = |pairs: &[(&str, f64)]| law(pairs).unwrap_err()[0].to_string();
        let k1 = ("loading_stiffness", 1e4);
        assert!(told(&[k1]).contains("give one of"));
        assert!(told(&[k1, ("restitution", 0.5), ("stiffness_growth", 1.0)]).contains("give one of"));
        assert!(told(&[k1, ("unloading_stiffness", 9e3)]).contains("more energy than it took"));
    }
}
