#![doc = include_str!("luding.md")]

use super::dashpot::Dashpot;
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
    /// Parameters of the law of Luding.
    pub struct LudingParameters {
        loading_stiffness: STIFFNESS, required 1e4, in Range::POSITIVE, "Stiffness of plastic loading, k1";
        unloading_stiffness: STIFFNESS, required 5e4, in Range::POSITIVE,
            "Largest stiffness of unloading and reloading, at least that of loading";
        adhesion_stiffness: STIFFNESS, required 1e4, in Range::NOT_NEGATIVE,
            "Stiffness of the line along which surfaces part, kc; 0 without adhesion";
        plastic_depth: NONE, usual 0.05, in Range::POSITIVE,
            "Dent of a fully loaded contact over twice the effective radius, phi_f; needed unless `unloading` is \"constant\"";
        unloading: NONE, choice ["variable", "constant"],
            "Whether the unloading stiffness grows with the largest overlap, or is the largest always";
        damping: DAMPING, optional 0.01, in Range::NOT_NEGATIVE,
            "Coefficient of the dashpot, gamma; instead of `restitution` with `impact_speed`. Without any there is none";
        restitution: NONE, optional 0.2, in Range::POSITIVE_SHARE,
            "Coefficient of restitution of an impact at `impact_speed`, with yielding and adhesion";
        impact_speed: VELOCITY, optional 1.0, in Range::POSITIVE, "Speed at which `restitution` is realised";
        attraction_force: FORCE, optional 1e-4, in Range::NOT_NEGATIVE,
            "Constant attraction of surfaces that touch, f_a; none without it";
        attraction_range: LENGTH, optional 1e-6, in Range::NOT_NEGATIVE,
            "Gap over which the attraction falls to zero; with 0 it ends at touching";
        attraction: NONE, choice ["reversible", "irreversible"],
            "Whether the attraction reaches across the gap always, or only once the surfaces have touched";
    }
}

/// The law of Luding.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Luding {
    loading: f64,
    unloading: f64,
    adhesion: f64,
    plastic_depth: f64,
    constant: bool,
    attraction: Attraction,
    /// Dashpot that is the same for every contact [N s/m].
    damping: f64,
    /// Dashpot in units of `sqrt(m k1)`.
    pub(super) dashpot: Dashpot,
}

const CONSTANT: usize = 1;
const IRREVERSIBLE: usize = 1;

/// Values that are remembered beside the dashpot's.
const REMEMBERED: usize = 2;

impl Luding {
    #[inline(always)]
    fn spring<L: Lanes>(&self, size: PairSize<L>) -> Hysteresis<L> {
        let rise = self.unloading - self.loading;
        let unloading = if self.constant || rise == 0.0 {
            Unloading::of_lines(self.loading, self.unloading).in_lanes()
        } else {
            let deepest = size.radius * (self.unloading / rise * self.plastic_depth * 2.0);
            Unloading::Growing {
                growth: L::splat(rise) / deepest,
                deepest,
            }
        };
        Hysteresis {
            loading: L::splat(self.loading),
            unloading,
            pull_off: if self.adhesion > 0.0 {
                PullOff::Stiffness(L::splat(self.adhesion))
            } else {
                PullOff::None
            },
            power: Power::Linear,
            pull_off_power: 1.0,
            attraction: self.attraction,
            damping: L::splat(self.damping),
        }
    }

    /// The loop of this size, and the memory of a contact.
    #[inline(always)]
    fn bound<L: Lanes>(&self, size: PairSize<L>, history: &[L]) -> (Hysteresis<L>, Memory<L>) {
        let spring = self.spring(size);
        let memory = spring.at_peak(history[0], history[1]);
        (spring, memory)
    }

    fn with(&self, dashpot: Dashpot) -> Self {
        Self { dashpot, ..*self }
    }
}

impl Normal for Luding {
    const NAME: &'static str = "luding";
    const SUMMARY: &'static str = "plastic and adhesive linear spring (Luding 2008), stiffer the deeper it was loaded";
    const DOC: &'static str = include_str!("luding.md");
    const PARAMETERS: &'static [ParameterInfo] = LudingParameters::TABLE;
    const ALTERNATIVES: &'static [Alternatives] = &[Alternatives {
        of: &["restitution", "damping"],
        with: &["impact_speed"],
    }];
    const HISTORY: &'static [Dimension] = &[Dimension::LENGTH, Dimension::LENGTH, Dimension::NONE];
    const LASTING: usize = REMEMBERED;
    const FOLLOWS_KINKS: bool = true;

    fn new(values: &Values, _pair: &MaterialPair) -> Result<Self, Vec<ParameterError>> {
        let p = LudingParameters::from_values(values)?;
        if p.unloading_stiffness < p.loading_stiffness {
            let message = format!(
                "`unloading_stiffness` is {} N/m, below `loading_stiffness`, {} N/m: the contact would give more energy \
                 than it took",
                p.unloading_stiffness, p.loading_stiffness
            );
            return Err(ParameterError::together("unloading_stiffness", message));
        }
        let constant = p.unloading == CONSTANT;
        if p.plastic_depth.is_none() && !constant {
            let message = "`plastic_depth` is missing: the dent of a fully loaded contact over twice the effective radius. Give it, or set \
                           `unloading = \"constant\"`";
            return Err(ParameterError::together("plastic_depth", message));
        }
        let force = p.attraction_force.unwrap_or(0.0);
        if p.attraction == IRREVERSIBLE && force == 0.0 {
            let message = "`attraction` tells when `attraction_force` begins, which is missing or 0";
            return Err(ParameterError::together("attraction", message));
        }
        let range = p.attraction_range.unwrap_or(0.0);
        if range > 0.0 && force == 0.0 {
            let message = "`attraction_range` tells how far `attraction_force` reaches, which is missing or 0";
            return Err(ParameterError::together("attraction_range", message));
        }
        let (damping, dashpot) = match Dashpot::read("damping", p.damping, p.restitution, p.impact_speed)? {
            Dashpot::Coefficient(damping) => (damping, Dashpot::Coefficient(0.0)),
            realised => (0.0, realised),
        };
        Ok(Self {
            loading: p.loading_stiffness,
            unloading: p.unloading_stiffness,
            adhesion: p.adhesion_stiffness,
            plastic_depth: p.plastic_depth.unwrap_or(f64::INFINITY),
            constant,
            attraction: Attraction {
                force,
                range,
                before_touch: p.attraction != IRREVERSIBLE,
            },
            damping,
            dashpot,
        })
    }

    const WIDE: bool = true;

    #[inline(always)]
    fn respond(&self, input: &NormalInput, history: &mut [f64]) -> NormalResponse {
        self.respond_wide(input, history)
    }

    #[inline(always)]
    fn respond_wide<L: Lanes>(&self, input: &NormalInput<L>, history: &mut [L]) -> NormalResponse<L> {
        let size = input.size;
        let (memory, own) = history.split_at_mut(REMEMBERED);
        let coefficient = self.dashpot.coefficient(size, own, |dashpot| self.with(dashpot));
        let (mut spring, state) = self.bound(size, memory);
        spring.damping = spring.damping + coefficient * (size.mass * self.loading).sqrt();
        let (response, next) = follow(&spring, input, state);
        (memory[0], memory[1]) = (next.peak, next.largest);
        response
    }

    fn energy(&self, size: PairSize, overlap: f64, history: &[f64]) -> f64 {
        let (spring, memory) = self.bound(size, history);
        spring.energy(memory, overlap)
    }

    fn stiffness(&self, size: PairSize, overlap: f64, history: &[f64]) -> f64 {
        self.stiffness_wide(size, overlap, history)
    }

    #[inline(always)]
    fn stiffness_wide<L: Lanes>(&self, size: PairSize<L>, overlap: L, history: &[L]) -> L {
        let (spring, memory) = self.bound(size, history);
        spring.stiffness(memory, overlap)
    }

    fn collision_time(&self, size: PairSize, overlap: f64) -> f64 {
        PI * (size.mass / self.spring(size).steepest(overlap)).sqrt()
    }

    #[inline(always)]
    fn history(&self) -> usize {
        REMEMBERED + self.dashpot.history()
    }

    fn reach(&self, size: PairSize, history: &[f64]) -> f64 {
        let (spring, memory) = self.bound(size, history);
        spring.reach(memory)
    }

    fn largest_reach(&self, _size: PairSize) -> f64 {
        self.attraction.range
    }

    fn check(&self, size: PairSize) -> Result<(), String> {
        self.dashpot.check(size, |dashpot| self.with(dashpot))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::{Collision, HeadOn, Outcome, Start, Tolerance};
    use crate::contact::Elastic;
    use crate::parameters::{Value, values};
    use approx::assert_relative_eq;

    const ANY: Elastic = Elastic {
        young_modulus: 1e9,
        poisson_ratio: 0.3,
    };
    const SIZE: PairSize = PairSize::new(1e-3, 2e-5);
    const K1: f64 = 1e4;
    const K2: f64 = 5e4;
    /// `K2/(K2 - k1) phi_f 2 R` with `phi_f = 0.05`.
    const LIMIT: f64 = 1.25e-4;

    fn law(adhesion: f64, more: &[(&str, Value)]) -> Luding {
        let mut given = values(&[
            ("loading_stiffness", K1),
            ("unloading_stiffness", K2),
            ("adhesion_stiffness", adhesion),
            ("plastic_depth", 0.05),
        ]);
        given.extend(more.iter().map(|(name, value)| ((*name).to_string(), value.clone())));
        Luding::new(&given, &MaterialPair { a: ANY, b: ANY }).unwrap()
    }

    fn collide(law: &Luding, speed: f64) -> Collision {
        let impact = HeadOn {
            law,
            size: SIZE,
            speed,
            start: Start::Far,
        };
        impact.run(&Tolerance::default()).unwrap()
    }

    fn walk(law: &Luding, places: &[(f64, f64)]) -> [f64; 3] {
        let mut history = [0.0; 3];
        for &(overlap, force) in places {
            let found = law.respond(&NormalInput::at(SIZE, overlap, 0.0), &mut history).elastic;
            assert_relative_eq!(found, force, max_relative = 1e-12, epsilon = 1e-15);
        }
        history
    }

    #[test]
    fn the_curve_of_loading_unloading_pull_off_and_reloading() {
        // at half of D* k2 is (k1 + K2)/2 = 3e4: the dent is 2/3 of D
        let d = 0.5 * LIMIT;
        let tear = 2e4 / 4e4 * d;
        let history = walk(
            &law(1e4, &[]),
            &[
                (0.3 * d, 0.3 * K1 * d),
                (d, K1 * d),
                (0.9 * d, 3e4 * (0.9 - 2.0 / 3.0) * d),
                (2.0 / 3.0 * d, 0.0),
                (tear, -1e4 * tear),
                (0.9 * d, 3e4 * (0.9 - 2.0 / 3.0) * d),
                (0.3 * d, -1e4 * 0.3 * d),
            ],
        );
        // the line back begins here: k2(D) (x - p(D)) = -kc x with k2 of the new D
        let (peak, x) = (history[0], 0.3 * d);
        let k2 = K1 + (K2 - K1) * peak / LIMIT;
        assert_relative_eq!(k2 * x - (k2 - K1) * peak, -1e4 * x, max_relative = 1e-12);
        assert!(peak < d);
        assert_relative_eq!(history[1], d, max_relative = 1e-15);
    }

    #[test]
    fn beyond_the_limit_the_contact_is_elastic() {
        let dent = 0.8 * LIMIT;
        assert_relative_eq!(dent, 0.05 * 2.0 * SIZE.radius, max_relative = 1e-12);
        walk(
            &law(0.0, &[]),
            &[
                (LIMIT, K1 * LIMIT),
                (2.0 * LIMIT, K2 * (2.0 * LIMIT - dent)),
                (0.9 * LIMIT, K2 * 0.1 * LIMIT),
                (0.5 * LIMIT, 0.0),
                (1.5 * LIMIT, K2 * (1.5 * LIMIT - dent)),
            ],
        );
        let constant = law(0.0, &[("unloading", "constant".into())]);
        walk(
            &constant,
            &[(2.0 * LIMIT, 2.0 * K1 * LIMIT), (1.8 * LIMIT, K2 * 0.2 * LIMIT)],
        );
    }

    /// Square of the restitution of an impact that loads up to `depth`, below the limit (Singh et al.).
    fn returned(kc: f64, depth: f64) -> f64 {
        let k2 = K1 + (K2 - K1) * depth / LIMIT;
        K1 / k2 - kc * (k2 - K1) * (k2 - K1) / (K1 * k2 * (k2 + kc))
    }

    #[test]
    fn restitution_without_a_dashpot() {
        for kc in [0.0, 2e3] {
            for share in [1e-3, 0.1, 0.5, 0.99] {
                let depth = share * LIMIT;
                let found = collide(&law(kc, &[]), depth * (K1 / SIZE.mass).sqrt());
                assert_relative_eq!(found.max_overlap, depth, max_relative = 1e-10);
                assert_relative_eq!(found.restitution, returned(kc, depth).sqrt(), max_relative = 1e-9);
            }
            // beyond the limit the loss is that of the limit
            let lost = 0.5 * K1 * LIMIT * LIMIT * (1.0 - returned(kc, LIMIT));
            for speed in [5.0, 20.0] {
                let expected = (1.0 - 2.0 * lost / (SIZE.mass * speed * speed)).sqrt();
                assert_relative_eq!(collide(&law(kc, &[]), speed).restitution, expected, max_relative = 1e-9);
            }
        }
    }

    #[test]
    fn cohesive_bodies_stick_between_two_speeds() {
        // returned = 0 at k2/k1 = 2 + k1/kc; and where the kinetic energy is the loss of the limit
        let kc = 1e4;
        let law = law(kc, &[]);
        let slow = (1.0 + K1 / kc) * K1 / (K2 - K1) * LIMIT * (K1 / SIZE.mass).sqrt();
        let lost = 0.5 * K1 * LIMIT * LIMIT * (1.0 - returned(kc, LIMIT));
        let fast = (2.0 * lost / SIZE.mass).sqrt();
        assert!(slow < fast);
        for (speed, outcome) in [
            (0.1 * slow, Outcome::Rebound),
            (slow * (1.0 - 1e-6), Outcome::Rebound),
            (slow * (1.0 + 1e-6), Outcome::Stick),
            (0.5 * (slow + fast), Outcome::Stick),
            (fast * (1.0 - 1e-6), Outcome::Stick),
            (fast * (1.0 + 1e-6), Outcome::Rebound),
        ] {
            assert_eq!(collide(&law, speed).outcome, outcome, "at {speed} m/s");
        }
    }

    #[test]
    fn attraction_that_begins_with_the_first_touch_costs_its_well() {
        let (force, range, speed) = (0.05, 1e-5, 0.5);
        for (word, lost) in [("reversible", 0.0), ("irreversible", 0.5 * force * range)] {
            let elastic = Luding {
                unloading: K1,
                ..law(
                    0.0,
                    &[
                        ("attraction_force", force.into()),
                        ("attraction_range", range.into()),
                        ("attraction", word.into()),
                    ],
                )
            };
            let found = collide(&elastic, speed);
            let expected = (1.0 - 2.0 * lost / (SIZE.mass * speed * speed)).sqrt();
            assert_relative_eq!(found.restitution, expected, max_relative = 1e-9);
        }
    }

    #[test]
    fn friction_is_limited_by_the_force_above_the_pull_off_line() {
        let law = law(1e4, &[]);
        let mut history = [0.0; 3];
        law.respond(&NormalInput::at(SIZE, 1e-4, 1.0), &mut history);
        for overlap in [8e-5, 1e-5] {
            let response = law.respond(&NormalInput::at(SIZE, overlap, -1.0), &mut history);
            assert_relative_eq!(response.adhesion, 1e4 * overlap, max_relative = 1e-12);
        }
        // on the line itself nothing is left
        let response = law.respond(&NormalInput::at(SIZE, 1e-6, -1.0), &mut history);
        assert_relative_eq!(response.elastic + response.adhesion, 0.0, epsilon = 1e-15);
    }

    #[test]
    fn what_has_no_effect_is_refused_and_what_is_not_needed_left_out() {
        let mut told = values(&[
            ("loading_stiffness", K1),
            ("unloading_stiffness", 2.0 * K1),
            ("adhesion_stiffness", K1),
        ]);
        let refused = |told: &Values| Luding::new(told, &MaterialPair { a: ANY, b: ANY }).unwrap_err()[0].to_string();
        assert!(
            refused(&told).contains("`plastic_depth` is missing"),
            "{}",
            refused(&told)
        );
        told.insert("unloading".into(), "constant".into());
        assert!(Luding::new(&told, &MaterialPair { a: ANY, b: ANY }).is_ok());
        told.insert("attraction".into(), "irreversible".into());
        assert!(refused(&told).contains("`attraction_force`"), "{}", refused(&told));
    }
}
