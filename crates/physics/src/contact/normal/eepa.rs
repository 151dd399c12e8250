#![doc = include_str!("eepa.md")]

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
    /// Parameters of the Edinburgh elasto-plastic adhesive contact.
    pub struct EepaParameters {
        plasticity_ratio: NONE, required 0.5, in Range::new(0.0, true, 1.0, false),
            "Contact plasticity ratio, lambda_p = 1 - k1/k2: 0 is elastic";
        surface_energy: SURFACE_ENERGY, required 0.5, in Range::NOT_NEGATIVE,
            "Energy per area that gives the largest pull of a dent, Delta gamma";
        pull_off_force: FORCE, optional 1e-4, in Range::NOT_NEGATIVE,
            "Constant attraction of surfaces that touch, f0 (the papers count it negative); none without it";
        exponent: NONE, choice ["hertz", "linear"],
            "Exponent of loading and unloading: 3/2 with k1 = 4/3 E sqrt(R), or 1 with k1 = 2 E R";
        adhesion_exponent: NONE, default 1.5, in Range::new(1.0, true, 100.0, true),
            "Exponent of the line along which surfaces part, chi";
        alpha: NONE, optional 0.1, in Range::NOT_NEGATIVE,
            "Coefficient of the dashpot; instead of `restitution` with `impact_speed`. Without any there is none";
        restitution: NONE, optional 0.3, in Range::POSITIVE_SHARE,
            "Coefficient of restitution of an impact at `impact_speed`, with yielding and adhesion";
        impact_speed: VELOCITY, optional 1.0, in Range::POSITIVE, "Speed at which `restitution` is realised";
    }
}

/// The Edinburgh elasto-plastic adhesive law bound to a pair of materials.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Eepa {
    /// Effective modulus [Pa].
    modulus: f64,
    plasticity_ratio: f64,
    surface_energy: f64,
    pull_off_force: f64,
    /// Dent over peak.
    dent: f64,
    power: Power,
    adhesion_exponent: f64,
    /// Dashpot in units of `sqrt(m k1)`.
    pub(super) dashpot: Dashpot,
}

/// Values that are remembered beside the dashpot's.
const REMEMBERED: usize = 3;

impl Eepa {
    #[inline(always)]
    fn spring<L: Lanes>(&self, size: PairSize<L>) -> Hysteresis<L> {
        let loading = match self.power {
            Power::Hertz => size.radius.sqrt() * (4.0 / 3.0 * self.modulus),
            Power::Linear => size.radius * (2.0 * self.modulus),
        };
        Hysteresis {
            loading,
            unloading: Unloading::Constant {
                stiffness: loading / (1.0 - self.plasticity_ratio),
                kept: self.plasticity_ratio,
                dent: self.dent,
            },
            pull_off: if self.surface_energy > 0.0 && self.plasticity_ratio > 0.0 {
                // 3/2 pi Delta gamma a, a = sqrt(2 R p)
                let share = (size.radius * 2.0).sqrt() * (1.5 * PI * self.surface_energy);
                PullOff::Dent { share }
            } else {
                PullOff::None
            },
            power: self.power,
            pull_off_power: self.adhesion_exponent,
            attraction: Attraction {
                force: self.pull_off_force,
                ..Attraction::NONE
            },
            damping: L::splat(0.0),
        }
    }

    /// The loop of this size, and the memory of a contact.
    #[inline(always)]
    fn bound<L: Lanes>(&self, size: PairSize<L>, history: &[L]) -> (Hysteresis<L>, Memory<L>) {
        let spring = self.spring(size);
        let memory = spring.recall(history[0], history[1], history[2]);
        (spring, memory)
    }

    fn with(&self, dashpot: Dashpot) -> Self {
        Self { dashpot, ..*self }
    }
}

impl Normal for Eepa {
    const NAME: &'static str = "eepa";
    const SUMMARY: &'static str = "Edinburgh elasto-plastic adhesive contact: a dent that holds the surfaces together";
    const DOC: &'static str = include_str!("eepa.md");
    const PARAMETERS: &'static [ParameterInfo] = EepaParameters::TABLE;
    const ALTERNATIVES: &'static [Alternatives] = &[Alternatives {
        of: &["restitution", "alpha"],
        with: &["impact_speed"],
    }];
    const HISTORY: &'static [Dimension] = &[Dimension::LENGTH, Dimension::LENGTH, Dimension::LENGTH, Dimension::NONE];
    const LASTING: usize = REMEMBERED;
    const FOLLOWS_KINKS: bool = true;

    fn new(values: &Values, pair: &MaterialPair) -> Result<Self, Vec<ParameterError>> {
        let p = EepaParameters::from_values(values)?;
        if p.surface_energy == 0.0 && values.contains_key("adhesion_exponent") {
            let message = "`adhesion_exponent` shapes the pull of `surface_energy`, which is 0: leave it out";
            return Err(ParameterError::together("adhesion_exponent", message));
        }
        let power = if p.exponent == 0 { Power::Hertz } else { Power::Linear };
        Ok(Self {
            modulus: pair.effective_modulus(),
            plasticity_ratio: p.plasticity_ratio,
            surface_energy: p.surface_energy,
            pull_off_force: p.pull_off_force.unwrap_or(0.0),
            dent: libm::pow(p.plasticity_ratio, 1.0 / power.exponent()),
            power,
            adhesion_exponent: p.adhesion_exponent,
            dashpot: Dashpot::read("alpha", p.alpha, p.restitution, p.impact_speed)?,
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
        let alpha = self.dashpot.coefficient(size, own, |dashpot| self.with(dashpot));
        let (mut spring, state) = self.bound(size, memory);
        spring.damping = alpha * (size.mass * spring.loading).sqrt();
        let (response, next) = follow(&spring, input, state);
        (memory[0], memory[1], memory[2]) = (next.peak, next.tear, next.largest);
        response
    }

    /// The dent stays; where it tears follows from the parameters.
    fn adopt(&self, size: PairSize, history: &mut [f64]) {
        let (memory, dashpot) = history.split_at_mut(REMEMBERED);
        memory[1] = self.spring(size).at_peak(memory[0], memory[2]).tear;
        dashpot.fill(0.0);
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

    fn check(&self, size: PairSize) -> Result<(), String> {
        self.dashpot.check(size, |dashpot| self.with(dashpot))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::{HeadOn, Start, Tolerance};
    use crate::contact::Elastic;
    use crate::contact::normal::{HertzTsuji, Luding};
    use crate::parameters::{Value, values};
    use approx::assert_relative_eq;

    const SOFT: Elastic = Elastic {
        young_modulus: 1e7,
        poisson_ratio: 0.3,
    };
    const PAIR: MaterialPair = MaterialPair { a: SOFT, b: SOFT };
    const SIZE: PairSize = PairSize::new(1e-3, 2e-5);

    fn law(plasticity_ratio: f64, surface_energy: f64, more: &[(&str, Value)]) -> Eepa {
        let mut given = values(&[
            ("plasticity_ratio", plasticity_ratio),
            ("surface_energy", surface_energy),
        ]);
        given.extend(more.iter().map(|(name, value)| ((*name).to_string(), value.clone())));
        Eepa::new(&given, &PAIR).unwrap()
    }

    fn force(law: &Eepa, overlap: f64, history: &mut [f64]) -> f64 {
        law.respond(&NormalInput::at(SIZE, overlap, 0.0), history).elastic
    }

    #[test]
    fn the_curve_of_loading_unloading_and_pull_off() {
        for (word, n, chi, f0) in [
            ("hertz", 1.5, 1.5, 0.0),
            ("hertz", 1.5, 4.0, 3e-4),
            ("linear", 1.0, 2.0, 1e-4),
        ] {
            let law = law(
                0.6,
                1.0,
                &[
                    ("exponent", word.into()),
                    ("adhesion_exponent", chi.into()),
                    ("pull_off_force", f0.into()),
                ],
            );
            let modulus = PAIR.effective_modulus();
            let k1 = if n == 1.5 {
                4.0 / 3.0 * modulus * SIZE.radius.sqrt()
            } else {
                2.0 * modulus * SIZE.radius
            };
            let k2 = k1 / 0.4;
            let d: f64 = 4e-5;
            let mut history = [0.0; 4];
            assert_relative_eq!(
                force(&law, 0.5 * d, &mut history),
                k1 * (0.5 * d).powf(n) - f0,
                max_relative = 1e-12
            );
            assert_relative_eq!(force(&law, d, &mut history), k1 * d.powf(n) - f0, max_relative = 1e-12);
            let dent = 0.6f64.powf(1.0 / n) * d;
            let line = |x: f64| k2 * (x.powf(n) - dent.powf(n)) - f0;
            assert_relative_eq!(force(&law, 0.9 * d, &mut history), line(0.9 * d), max_relative = 1e-12);
            // the pull of the dent, at the overlap where the unloading line reaches it
            let pull = 1.5 * PI * (2.0 * SIZE.radius * dent).sqrt();
            let tear = (dent.powf(n) - pull / k2).powf(1.0 / n);
            assert!(tear > 0.5 * dent, "the pull of this test is not free");
            assert_relative_eq!(force(&law, tear, &mut history), -pull - f0, max_relative = 1e-10);
            let x = 0.4 * tear;
            let on_the_way_out = -pull * (x / tear).powf(chi) - f0;
            assert_relative_eq!(force(&law, x, &mut history), on_the_way_out, max_relative = 1e-10);
            // back along an unloading line of the same stiffness, to the loading line
            let up = on_the_way_out + k2 * ((1.2 * x).powf(n) - x.powf(n));
            assert_relative_eq!(force(&law, 1.2 * x, &mut history), up, max_relative = 1e-10);
            assert_relative_eq!(
                force(&law, 0.95 * d, &mut history),
                k1 * (0.95 * d).powf(n) - f0,
                max_relative = 1e-12
            );
            assert_eq!(force(&law, 0.0, &mut history), 0.0);
        }
    }

    #[test]
    fn a_pull_that_a_small_dent_cannot_carry_is_that_at_half_the_dent() {
        for (word, n) in [("hertz", 1.5f64), ("linear", 1.0)] {
            let law = law(0.5, 1e4, &[("exponent", word.into())]);
            let spring = law.spring(SIZE);
            let mut history = [0.0; 4];
            force(&law, 1e-5, &mut history);
            let dent = 0.5f64.powf(1.0 / n) * 1e-5;
            let least = -2.0 * spring.loading * dent.powf(n) * (1.0 - 0.5f64.powf(n));
            assert_relative_eq!(force(&law, 0.5 * dent, &mut history), least, max_relative = 1e-12);
            assert!(force(&law, 0.49 * dent, &mut history) > least);
        }
    }

    #[test]
    fn linear_with_linear_adhesion_is_the_law_of_luding() {
        let law = law(
            0.6,
            0.02,
            &[("exponent", "linear".into()), ("adhesion_exponent", 1.0.into())],
        );
        let spring = law.spring(SIZE);
        let mut history = [0.0; 4];
        force(&law, 3e-5, &mut history);
        let twin = values(&[
            ("loading_stiffness", spring.loading),
            ("unloading_stiffness", spring.loading / 0.4),
            ("adhesion_stiffness", spring.at_peak(3e-5, 3e-5).pull_off),
            ("plastic_depth", 0.1),
        ]);
        let mut twin = twin;
        twin.insert("unloading".to_string(), "constant".into());
        let twin = Luding::new(&twin, &PAIR).unwrap();
        let mut memory = [0.0; 3];
        for overlap in [3e-5, 2e-5, 1.5e-5, 4e-6, 1e-5, 2.9e-5, 1e-6] {
            let input = NormalInput::at(SIZE, overlap, 0.0);
            let (a, b) = (law.respond(&input, &mut history), twin.respond(&input, &mut memory));
            assert_relative_eq!(a.elastic, b.elastic, max_relative = 1e-10, epsilon = 1e-15);
            assert_relative_eq!(a.adhesion, b.adhesion, max_relative = 1e-10);
            let stored = [law.energy(SIZE, overlap, &history), twin.energy(SIZE, overlap, &memory)];
            assert_relative_eq!(stored[0], stored[1], max_relative = 1e-9);
        }
    }

    #[test]
    fn restitution_of_the_dent_alone() {
        for ratio in [0.0, 0.2, 0.7, 0.95] {
            for (word, n) in [("hertz", 1.5f64), ("linear", 1.0)] {
                let law = law(ratio, 0.0, &[("exponent", word.into())]);
                let impact = HeadOn {
                    law: &law,
                    size: SIZE,
                    speed: 0.3,
                    start: Start::Contact,
                };
                let found = impact.run(&Tolerance::default()).unwrap();
                // k2 times the integral of x^n - p^n from p to D, over k1 D^(n+1)/(n+1)
                let dent = ratio.powf(1.0 / n);
                let back = 1.0 - dent.powf(n + 1.0) - (n + 1.0) * ratio * (1.0 - dent);
                let expected = (back / (1.0 - ratio)).sqrt();
                assert_relative_eq!(found.restitution, expected, max_relative = 1e-9);
                if ratio == 0.0 && n == 1.5 {
                    let hertz = HertzTsuji::new(&values(&[("restitution", 1.0)]), &PAIR).unwrap();
                    let input = NormalInput::at(SIZE, 1e-5, 0.0);
                    let expected = hertz.respond(&input, &mut []).elastic;
                    assert_relative_eq!(force(&law, 1e-5, &mut [0.0; 4]), expected, max_relative = 1e-12);
                }
            }
        }
    }

    #[test]
    fn loading_never_gives_energy_whatever_the_exponents() {
        for ratio in [0.05, 0.5, 0.95] {
            for word in ["hertz", "linear"] {
                for chi in [1.0, 1.5, 5.0, 20.0] {
                    for surface_energy in [1e-3, 0.1, 10.0] {
                        let law = law(
                            ratio,
                            surface_energy,
                            &[("exponent", word.into()), ("adhesion_exponent", chi.into())],
                        );
                        let spring = law.spring(SIZE);
                        let n = spring.power.exponent();
                        let lost = |d: f64| {
                            let work = spring.loading * d.powf(n + 1.0) / (n + 1.0);
                            work - spring.energy(spring.at_peak(d, d), d)
                        };
                        let mut before = 0.0;
                        for step in 0..200 {
                            let now = lost(1e-9 * 1.06f64.powi(step));
                            assert!(
                                now >= before,
                                "{word}, {ratio}, {chi}, {surface_energy}: {now} after {before}"
                            );
                            before = now;
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn an_exponent_of_no_adhesion_is_refused() {
        let mut told = values(&[("plasticity_ratio", 0.5), ("surface_energy", 0.0)]);
        assert!(Eepa::new(&told, &PAIR).is_ok());
        told.insert("adhesion_exponent".into(), 2.0.into());
        let refused = Eepa::new(&told, &PAIR).unwrap_err()[0].to_string();
        assert!(refused.contains("`surface_energy`, which is 0"), "{refused}");
    }
}
