#![doc = include_str!("hertz_tsuji.md")]

use super::{Normal, NormalInput, NormalResponse, mean_slope, near_end};
use crate::contact::{MaterialPair, PairSize};
use crate::dimension::Dimension;
use crate::parameters::{ParameterError, ParameterInfo, Range, Values};
use crate::{params, restitution};

params! {
    /// Parameters of the Hertzian spring-dashpot.
    pub struct HertzTsujiParameters {
        restitution: NONE, typical 0.9, default None, Range::POSITIVE_SHARE,
            "Coefficient of restitution, the same at every impact speed";
    }
}

/// Contact time of an undamped Hertzian collision in units of `(m/K)^(2/5) v0^(-1/5)`:
/// `4/5 (5/4)^(2/5) sqrt(pi) Gamma(2/5) / Gamma(9/10)`.
pub const HERTZ_CONTACT_TIME: f64 = 3.218_065_459_719_043_5;

/// The Hertzian spring-dashpot bound to a pair of materials.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HertzTsuji {
    /// `4/3 E` [Pa].
    modulus: f64,
    alpha: f64,
}

impl HertzTsuji {
    /// `K = 4/3 E sqrt(R)` [N/m^(3/2)].
    #[inline(always)]
    fn hertz_stiffness(&self, size: PairSize) -> f64 {
        self.modulus * size.radius.sqrt()
    }
}

impl Normal for HertzTsuji {
    const NAME: &'static str = "hertz-tsuji";
    const SUMMARY: &'static str = "Hertzian spring-dashpot (HSD), damping from restitution";
    const DOC: &'static str = include_str!("hertz_tsuji.md");
    const PARAMETERS: &'static [ParameterInfo] = HertzTsujiParameters::TABLE;
    const HISTORY: &'static [Dimension] = &[];

    fn new(values: &Values, pair: &MaterialPair) -> Result<Self, Vec<ParameterError>> {
        let p = HertzTsujiParameters::from_values(values)?;
        Ok(Self {
            modulus: 4.0 / 3.0 * pair.effective_modulus(),
            alpha: restitution::hertz_damping(p.restitution),
        })
    }

    #[inline(always)]
    fn respond(&self, input: &NormalInput) -> NormalResponse {
        let k = self.hertz_stiffness(input.size);
        let dashpot = self.alpha * (input.size.mass * k).sqrt();
        if near_end(input) {
            NormalResponse {
                elastic: mean_slope(input, |d| 0.4 * k * d * d * d.sqrt()),
                damping: mean_slope(input, |d| 0.8 * dashpot * d * d.sqrt().sqrt()),
            }
        } else if input.overlap > 0.0 {
            // means over the window to second order: f + f'' h^2/6 with f = d^(3/2) and d^(1/4)
            let root = input.overlap.sqrt();
            let share = input.half_window / input.overlap;
            let share2 = share * share;
            NormalResponse {
                elastic: k * input.overlap * root * (1.0 + share2 / 8.0),
                damping: dashpot * root.sqrt() * (1.0 - share2 / 32.0),
            }
        } else {
            NormalResponse {
                elastic: 0.0,
                damping: 0.0,
            }
        }
    }

    #[inline(always)]
    fn energy(&self, size: PairSize, overlap: f64) -> f64 {
        let d = overlap.max(0.0);
        0.4 * self.hertz_stiffness(size) * d * d * d.sqrt()
    }

    #[inline(always)]
    fn stiffness(&self, size: PairSize, overlap: f64) -> f64 {
        1.5 * self.hertz_stiffness(size) * overlap.max(0.0).sqrt()
    }

    fn collision_time(&self, size: PairSize, overlap: f64) -> f64 {
        // undamped, which is the shortest: T = c (m/K)^(2/5) v0^(-1/5) with v0 from 1/2 m v0^2 = 2/5 K d^(5/2)
        let ratio = size.mass / self.hertz_stiffness(size);
        let v0 = (0.8 / ratio * overlap * overlap * overlap.sqrt()).sqrt();
        HERTZ_CONTACT_TIME * libm::pow(ratio, 0.4) * libm::pow(v0, -0.2)
    }
}
