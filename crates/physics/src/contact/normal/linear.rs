#![doc = include_str!("linear.md")]

use super::{Normal, NormalInput, NormalResponse, mean_slope, near_end};
use crate::contact::{MaterialPair, PairSize};
use crate::dimension::Dimension;
use crate::parameters::{ParameterError, ParameterInfo, Range, Values};
use crate::{params, restitution};

params! {
    /// Parameters of the linear spring-dashpot.
    pub struct LinearParameters {
        stiffness: STIFFNESS, typical 1e4, default None, Range::POSITIVE, "Normal stiffness, force per overlap";
        restitution: NONE, typical 0.9, default None, Range::POSITIVE_SHARE,
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
    fn respond(&self, input: &NormalInput) -> NormalResponse {
        let damping = 2.0 * self.damping_ratio * (self.stiffness * input.size.mass).sqrt();
        if near_end(input) {
            NormalResponse {
                elastic: mean_slope(input, |d| 0.5 * self.stiffness * d * d),
                damping: mean_slope(input, |d| damping * d),
            }
        } else if input.overlap > 0.0 {
            NormalResponse {
                elastic: self.stiffness * input.overlap,
                damping,
            }
        } else {
            NormalResponse {
                elastic: 0.0,
                damping: 0.0,
            }
        }
    }

    #[inline(always)]
    fn energy(&self, _size: PairSize, overlap: f64) -> f64 {
        let d = overlap.max(0.0);
        0.5 * self.stiffness * d * d
    }

    #[inline(always)]
    fn stiffness(&self, _size: PairSize, _overlap: f64) -> f64 {
        self.stiffness
    }

    fn collision_time(&self, size: PairSize, _overlap: f64) -> f64 {
        restitution::linear_contact_time(self.stiffness, size.mass, self.restitution)
    }
}
