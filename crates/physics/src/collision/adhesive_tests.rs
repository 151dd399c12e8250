//! Collisions that stick, yield and pull: a model of the contact of Jasevičius, Kačianauskas and Tomas (2009), as far
//! as point forces go, against numbers computed independently.

use super::*;
use crate::contact::normal::{Normal, NormalInput, NormalResponse};
use crate::contact::{MaterialPair, PairSize};
use crate::dimension::Dimension;
use crate::parameters::{ParameterError, ParameterInfo, Values};
use approx::assert_relative_eq;
use std::f64::consts::PI;

/// Limestone on limestone; `yields` is false for the elastic variant, `tail` false for the contact criterion.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Limestone {
    alpha: f64,
    yields: bool,
    tail: bool,
}

/// Stiffnesses for one size: K, k_pl, k_p, h_Y, F_H0.
struct Stiffness(f64, f64, f64, f64, f64);

/// Distance of closest approach [m].
const A: f64 = 0.336e-9;

fn stiffness(radius: f64) -> Stiffness {
    let modulus = 150e9 / (2.0 * (1.0 - 0.28 * 0.28));
    let k = 4.0 / 3.0 * modulus * radius.sqrt();
    let (yield_pressure, area, pressure) = (300e6, 5.0 / 6.0, 0.153);
    let k_pl = PI * radius * yield_pressure * (area - pressure);
    let k_p = PI * radius * yield_pressure * pressure;
    Stiffness(k, k_pl, k_p, (k_pl / k) * (k_pl / k), -2.64e-9 * radius / 0.3e-6)
}

impl Limestone {
    /// h_U and h_A of a contact.
    fn unloading(&self, radius: f64, deepest: f64) -> (f64, f64) {
        let Stiffness(k, k_pl, k_p, h_y, _) = stiffness(radius);
        if !self.yields {
            return (f64::INFINITY, 0.0);
        }
        let h_u = deepest.max(h_y);
        let mut z = h_u.sqrt();
        for _ in 0..100 {
            let f = k * z * z * z + k_p * z * z - (k_pl + k_p) * h_u;
            z -= f / (3.0 * k * z * z + 2.0 * k_p * z);
        }
        (h_u, if deepest > h_y { h_u - z * z } else { 0.0 })
    }
}

impl Normal for Limestone {
    const NAME: &'static str = "limestone";
    const SUMMARY: &'static str = "";
    const DOC: &'static str = "";
    const PARAMETERS: &'static [ParameterInfo] = &[];
    const HISTORY: &'static [Dimension] = &[Dimension::LENGTH];

    fn new(_: &Values, _: &MaterialPair) -> Result<Self, Vec<ParameterError>> {
        Err(vec![])
    }

    fn respond(&self, input: &NormalInput, history: &mut [f64]) -> NormalResponse {
        let Stiffness(k, k_pl, k_p, _, f_h0) = stiffness(input.size.radius);
        let h = input.overlap;
        let (h_u, mut h_a) = self.unloading(input.size.radius, history[0]);
        let mass = input.size.mass;
        if self.yields && h >= h_u {
            history[0] = h;
            if input.rate > 0.0 {
                return NormalResponse::spring_dashpot(input, f_h0 + k_pl * h, self.alpha * (mass * k_pl).sqrt());
            }
            h_a = self.unloading(input.size.radius, h).1;
        }
        if h >= h_a {
            let d = h - h_a;
            let elastic = f_h0 - k_p * h_a + k * d * d.sqrt();
            NormalResponse::spring_dashpot(input, elastic, self.alpha * (mass * k).sqrt() * d.sqrt().sqrt())
        } else {
            let share = A / (A + h_a - h);
            NormalResponse::spring_dashpot(input, share * share * (f_h0 - k_p * h_a * share), 0.0)
        }
    }

    fn energy(&self, size: PairSize, overlap: f64, history: &[f64]) -> f64 {
        let Stiffness(k, _, k_p, _, f_h0) = stiffness(size.radius);
        let h_a = self.unloading(size.radius, history[0]).1;
        let d = overlap - h_a;
        let share = A / (A - d.min(0.0));
        let far = |share: f64| f_h0 * A * share - 0.5 * k_p * h_a * A * share * share;
        let far = if self.tail {
            far(share) - far(1.0 / (1.0 + 1e6))
        } else {
            0.0
        };
        let near = d.max(0.0);
        far + (f_h0 - k_p * h_a) * near + 0.4 * k * near * near * near.sqrt()
    }

    fn stiffness(&self, size: PairSize, overlap: f64, _: &[f64]) -> f64 {
        1.5 * stiffness(size.radius).0 * overlap.max(0.0).sqrt()
    }

    fn collision_time(&self, size: PairSize, overlap: f64) -> f64 {
        3.0 * (size.mass / self.stiffness(size, overlap, &[])).sqrt()
    }

    fn reach(&self, size: PairSize, history: &[f64]) -> f64 {
        let h_a = self.unloading(size.radius, history[0]).1;
        if self.tail { 1e6 * A - h_a } else { -h_a }
    }

    fn largest_reach(&self, _: PairSize) -> f64 {
        if self.tail { 1e6 * A } else { 0.0 }
    }
}

/// A mobile grain of radius 2R on a fixed one.
fn size(radius: f64) -> PairSize {
    let grain = 2.0 * radius;
    PairSize::new(radius, 2740.0 * 4.0 / 3.0 * PI * grain * grain * grain)
}

fn critical(law: Limestone, radius: f64, start: Start) -> f64 {
    match sticking_speed(&law, size(radius), start, &Tolerance::default()).unwrap() {
        Sticking::Below(speed) => speed,
        other => panic!("{other:?}"),
    }
}

#[test]
fn critical_sticking_speeds() {
    // radius [um], tail, yields, alpha, speed [m/s]: the table of reference numbers, six digits
    let cases = [
        (0.1, false, false, 0.2, 0.0124316),
        (0.1, false, false, 0.5, 0.0275025),
        (0.1, false, true, 0.2, 0.0401245),
        (0.1, false, true, 0.5, 0.106624),
        (1.0, false, false, 0.2, 0.00182471),
        (1.0, false, true, 0.5, 0.00576127),
        (0.3, true, false, 0.2, 0.0251078),
        (0.3, true, false, 0.5, 0.0523388),
        (0.3, true, true, 0.2, 0.217490),
        (0.3, true, true, 0.5, 1.095307),
    ];
    for (radius, tail, yields, alpha, expected) in cases {
        let law = Limestone { alpha, yields, tail };
        let start = if tail { Start::Far } else { Start::Contact };
        assert_relative_eq!(critical(law, 1e-6 * radius, start), expected, max_relative = 4e-6);
    }
    // without a dashpot, by the balance of energies
    let law = Limestone {
        alpha: 0.0,
        yields: true,
        tail: false,
    };
    assert_relative_eq!(
        critical(law, 0.3e-6, Start::Contact),
        5.58799563e-3,
        max_relative = 1e-6
    );
}

#[test]
fn elastic_sticking_scales_as_the_power_minus_five_sixths() {
    for (alpha, factor) in [(0.2, 1.36168109), (0.5, 3.01244962)] {
        for radius in [0.05e-6, 0.7e-6] {
            let law = Limestone {
                alpha,
                yields: false,
                tail: false,
            };
            let Stiffness(k, _, _, _, f_h0) = stiffness(radius);
            let h0 = libm::pow(-f_h0 / k, 2.0 / 3.0);
            let unit = (-f_h0 * h0 / size(radius).mass).sqrt();
            assert_relative_eq!(
                critical(law, radius, Start::Contact),
                factor * unit,
                max_relative = 2e-7
            );
        }
    }
}

#[test]
fn slow_limestone_sticks_and_fast_limestone_parts() {
    for alpha in [0.2, 0.3, 0.4, 0.5] {
        let law = Limestone {
            alpha,
            yields: true,
            tail: false,
        };
        let run = |speed: f64| {
            let impact = HeadOn {
                law: &law,
                size: size(0.3e-6),
                speed,
                start: Start::Contact,
            };
            impact.run(&Tolerance::default()).unwrap()
        };
        let (slow, fast) = (run(2e-3 / 60.0), run(2.0 / 60.0));
        assert_eq!(
            (slow.outcome, slow.restitution, slow.contact_time()),
            (Outcome::Stick, 0.0, None)
        );
        assert_eq!(fast.outcome, Outcome::Rebound);
        assert!(fast.restitution > 0.0 && fast.energy.lost > 0.0 && fast.energy.viscous > 0.0);
        assert!(fast.steps < 2000, "{}", fast.steps);
    }
}

#[test]
fn without_losses_the_speed_comes_back_from_the_attraction() {
    let law = Limestone {
        alpha: 0.0,
        yields: false,
        tail: true,
    };
    for speed in [1e-4, 1e-2, 1.0] {
        let impact = HeadOn {
            law: &law,
            size: size(0.3e-6),
            speed,
            start: Start::Far,
        };
        let found = impact.run(&Tolerance::default()).unwrap();
        assert_relative_eq!(found.restitution, 1.0, max_relative = 1e-7);
        // what the attraction gives on the way in: the books close to its rounding
        let well = law.energy(size(0.3e-6), 0.0, &[0.0]).abs();
        assert!(
            found.energy.lost.abs() < 1e-11 * well.max(found.energy.kinetic_before),
            "{found:?}"
        );
    }
}
