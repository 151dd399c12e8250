//! The limestone grains of Jasevičius, Kačianauskas and Tomas (2009), and their contact by the paper's equations.
//!
//! The paper prints neither moduli nor density nor the separation: E = 150 GPa, nu = 0.28, 2740 kg/m^3 and 0.336 nm are
//! those of Tomas (2007). A mobile grain of radius 2 R_eff meets an equal one that is held.

use crate::calibrate::CalibrateError;
use demeter_physics::contact::normal::NormalLaw;
use demeter_physics::contact::{Elastic, MaterialPair, PairSize};
use demeter_physics::parameters::{Value, values};
use demeter_physics::root::bracketed;
use std::f64::consts::PI;

const LIMESTONE: Elastic = Elastic {
    young_modulus: 150e9,
    poisson_ratio: 0.28,
};
const PAIR: MaterialPair = MaterialPair {
    a: LIMESTONE,
    b: LIMESTONE,
};
const DENSITY: f64 = 2740.0;
const SEPARATION: f64 = 0.336e-9;
const MICRO_YIELD_STRENGTH: f64 = 300e6;
const KAPPA_A: f64 = 5.0 / 6.0;
const KAPPA_P: f64 = 0.153;
const ADHESION_FORCE: f64 = 2.64e-9;

/// Effective radius that the adhesion force belongs to [m].
pub(super) const RADIUS: f64 = 0.3e-6;

/// Damping coefficients of the paper.
pub(super) const ALPHAS: [f64; 4] = [0.2, 0.3, 0.4, 0.5];

/// Effective radius, and the mass of the grain that moves.
pub(super) fn size(radius: f64) -> PairSize {
    let grain = 2.0 * radius;
    PairSize::new(radius, DENSITY * 4.0 / 3.0 * PI * grain * grain * grain)
}

/// The contact law that a run uses. `tail` is its parameter of this name.
pub(super) fn law(alpha: f64, elastic: bool, tail: &str) -> Result<NormalLaw, CalibrateError> {
    let mut parameters = values(&[
        ("adhesion_force", ADHESION_FORCE),
        ("adhesion_radius", RADIUS),
        ("separation", SEPARATION),
        ("micro_yield_strength", MICRO_YIELD_STRENGTH),
        ("kappa_a", KAPPA_A),
        ("kappa_p", KAPPA_P),
        ("alpha", alpha),
    ]);
    let loading = if elastic { "elastic" } else { "elastic-plastic" };
    for (name, word) in [("tail", tail), ("loading", loading)] {
        parameters.insert(name.to_string(), Value::Text(word.to_string()));
    }
    Ok(NormalLaw::build("tomas", &parameters, &PAIR)?)
}

/// The contact by the equations of the paper, apart from the engine's law.
#[derive(Clone, Copy, Debug)]
pub(super) struct PaperContact {
    /// `K` of eq 4 [N/m^(3/2)].
    pub hertz: f64,
    /// Slope of the yield line of eq 13 [N/m].
    pub yield_slope: f64,
    /// Slope of the adhesion limit of eq 9 [N/m].
    pub limit_slope: f64,
    /// `|F_H0|` [N].
    pub pull: f64,
    /// Mass [kg].
    pub mass: f64,
    alpha: f64,
}

impl PaperContact {
    pub(super) fn new(radius: f64, alpha: f64) -> Self {
        let pressure = PI * radius * MICRO_YIELD_STRENGTH;
        Self {
            hertz: 4.0 / 3.0 * PAIR.effective_modulus() * radius.sqrt(),
            yield_slope: pressure * (KAPPA_A - KAPPA_P),
            limit_slope: pressure * KAPPA_P,
            pull: ADHESION_FORCE * radius / RADIUS,
            mass: size(radius).mass,
            alpha,
        }
    }

    /// Overlap at which the force of eq 3 meets that of eq 13 [m].
    pub(super) fn yield_overlap(&self) -> f64 {
        let root = self.yield_slope / self.hertz;
        root * root
    }

    /// Overlap at which bodies part that were pressed to `deepest` [m].
    pub(super) fn foot(&self, deepest: f64) -> f64 {
        if deepest <= self.yield_overlap() {
            return 0.0;
        }
        let excess = |foot: f64| {
            let elastic = deepest - foot;
            self.hertz * elastic * elastic.sqrt() - self.yield_slope * deepest - self.limit_slope * foot
        };
        bracketed(excess, 0.0, deepest)
    }

    /// Force while in contact, dashpot and all [N], of bodies that have been pressed to `deepest`.
    pub(super) fn force(&self, overlap: f64, rate: f64, deepest: f64) -> f64 {
        if rate > 0.0 && overlap >= deepest && overlap > self.yield_overlap() {
            let dashpot = self.alpha * (self.mass * self.yield_slope).sqrt();
            return self.yield_slope * overlap - self.pull + dashpot * rate;
        }
        let foot = self.foot(deepest);
        let elastic = (overlap - foot).max(0.0);
        let dashpot = self.alpha * (self.mass * self.hertz).sqrt() * elastic.sqrt().sqrt();
        self.hertz * elastic * elastic.sqrt() - self.pull - self.limit_slope * foot + dashpot * rate
    }

    /// Overlap at rest of bodies that have been pressed to `deepest` [m].
    pub(super) fn rest(&self, deepest: f64) -> f64 {
        let foot = self.foot(deepest);
        let root = libm::cbrt((self.pull + self.limit_slope * foot) / self.hertz);
        foot + root * root
    }

    /// Critical sticking velocity without any dashpot [m/s], by energy: the elastic part of the work of loading, from
    /// the first touch to the overlap of parting, is used up by the adhesion. None where the grains part at any speed: the
    /// adhesion alone then draws them no deeper than they can come back from.
    pub(super) fn undamped_sticking_speed(&self) -> Option<f64> {
        let foot_of = |elastic: f64| {
            (self.hertz * elastic * elastic.sqrt() - self.yield_slope * elastic) / (self.yield_slope + self.limit_slope)
        };
        // 2/5 K u^(5/2) = |F_A| u
        let excess = |u: f64| 0.4 * self.hertz * u * u.sqrt() - self.pull - self.limit_slope * foot_of(u);
        let h_y = self.yield_overlap();
        if excess(h_y) >= 0.0 {
            return None;
        }
        let mut deep = 2.0 * h_y;
        while excess(deep) < 0.0 && deep < 1e6 * h_y {
            deep *= 2.0;
        }
        let elastic = bracketed(excess, h_y, deep);
        let deepest = elastic + foot_of(elastic);
        let work = 0.4 * self.hertz * h_y * h_y * h_y.sqrt() + 0.5 * self.yield_slope * (deepest * deepest - h_y * h_y)
            - self.pull * deepest;
        (work > 0.0).then(|| (2.0 * work / self.mass).sqrt())
    }
}
