//! The contact of limestone in Jasevicius, Kacianauskas and Tomas (2009), against numbers computed independently.

mod energy;
mod numbers;
mod sticking;

use super::*;
use crate::contact::Elastic;
use crate::parameters::Value;

/// Assumed by everybody who repeats the paper, which prints neither moduli nor density.
const LIMESTONE: Elastic = Elastic {
    young_modulus: 150e9,
    poisson_ratio: 0.28,
};

/// The separation of the paper's source [m].
const A: f64 = 0.336e-9;

/// A mobile grain of radius 2 R on a fixed one: effective radius R, its own mass.
fn size(radius: f64) -> PairSize {
    let grain = 2.0 * radius;
    PairSize::new(radius, 2740.0 * 4.0 / 3.0 * PI * grain * grain * grain)
}

/// The size most numbers are told for.
fn small() -> PairSize {
    size(0.3e-6)
}

fn values(changed: &[(&str, Value)]) -> Values {
    let mut values = crate::parameters::values(&[
        ("adhesion_force", 2.64e-9),
        ("adhesion_radius", 0.3e-6),
        ("separation", A),
        ("micro_yield_strength", 300e6),
        ("kappa_p", 0.153),
        ("alpha", 0.2),
    ]);
    for (name, value) in changed {
        values.insert((*name).to_string(), value.clone());
    }
    values
}

/// Limestone with some parameters changed.
fn limestone(changed: &[(&str, Value)]) -> Tomas {
    let pair = MaterialPair {
        a: LIMESTONE,
        b: LIMESTONE,
    };
    Tomas::new(&values(changed), &pair).unwrap()
}

/// A contact that is moved by plain evaluations.
struct Contact {
    law: Tomas,
    size: PairSize,
    history: [f64; 3],
}

impl Contact {
    fn new(law: Tomas, size: PairSize) -> Self {
        Self {
            law,
            size,
            history: [0.0; 3],
        }
    }

    fn move_to(&mut self, overlap: f64, rate: f64) -> NormalResponse {
        let input = NormalInput::at(self.size, overlap, rate);
        self.law.respond(&input, &mut self.history)
    }

    /// Force without the dashpot at an overlap, coming from there.
    fn force(&mut self, overlap: f64) -> f64 {
        self.move_to(overlap, 0.0).elastic
    }

    /// What a step would respond, without taking it.
    fn look(&self, overlap: f64, rate: f64) -> NormalResponse {
        let mut history = self.history;
        self.law
            .respond(&NormalInput::at(self.size, overlap, rate), &mut history)
    }

    fn energy(&self, overlap: f64) -> f64 {
        self.law.energy(self.size, overlap, &self.history)
    }
}
