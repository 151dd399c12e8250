#![doc = include_str!("walton_braun.md")]

use super::hysteresis::{Attraction, Hysteresis, Memory, Power, PullOff, Unloading};
use super::path::{Branched, KINKS, Point, follow};
use super::{Normal, NormalInput, NormalResponse};
use crate::contact::{MaterialPair, PairSize};
use crate::dimension::Dimension;
use crate::parameters::{ParameterError, ParameterInfo, Range, Values};
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
    spring: Hysteresis,
}

impl WaltonBraun {
    fn memory(&self, history: &[f64]) -> Memory {
        let peak = history.first().copied().unwrap_or(0.0);
        self.spring.at_peak(peak, peak)
    }
}

impl Normal for WaltonBraun {
    const NAME: &'static str = "walton-braun";
    const SUMMARY: &'static str = "stiffer on unloading than on loading (plastic dent), without adhesion";
    const DOC: &'static str = include_str!("walton_braun.md");
    const PARAMETERS: &'static [ParameterInfo] = WaltonBraunParameters::TABLE;
    const HISTORY: &'static [Dimension] = &[Dimension::LENGTH];

    fn new(values: &Values, _pair: &MaterialPair) -> Result<Self, Vec<ParameterError>> {
        let p = WaltonBraunParameters::from_values(values)?;
        let k1 = p.loading_stiffness;
        let unloading = match (p.restitution, p.unloading_stiffness, p.stiffness_growth) {
            (Some(e), None, None) => Unloading::Constant(k1 / (e * e)),
            (None, Some(k2), None) if k2 >= k1 => Unloading::Constant(k2),
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
        Ok(Self {
            spring: Hysteresis {
                loading: k1,
                unloading,
                pull_off: PullOff::None,
                power: Power::Linear,
                pull_off_power: 1.0,
                attraction: Attraction::NONE,
            },
        })
    }

    #[inline]
    fn respond(&self, input: &NormalInput, history: &mut [f64]) -> NormalResponse {
        let (response, memory) = follow(self, input, self.memory(history));
        if let Some(peak) = history.first_mut() {
            *peak = memory.peak;
        }
        response
    }

    fn energy(&self, _size: PairSize, overlap: f64, history: &[f64]) -> f64 {
        self.spring.stored(self.memory(history), overlap)
    }

    fn stiffness(&self, _size: PairSize, overlap: f64, history: &[f64]) -> f64 {
        self.spring.stiffness(self.memory(history), overlap)
    }

    fn collision_time(&self, size: PairSize, overlap: f64) -> f64 {
        PI * (size.mass / self.spring.steepest(overlap)).sqrt()
    }

    fn reach(&self, _size: PairSize, history: &[f64]) -> f64 {
        self.spring.reach(self.memory(history))
    }
}

impl Branched for WaltonBraun {
    type State = Memory;

    #[inline(always)]
    fn advance(&self, _size: PairSize, state: Memory, to: f64) -> Memory {
        self.spring.advance(state, to)
    }

    #[inline(always)]
    fn point(&self, _size: PairSize, state: Memory, overlap: f64, _approaching: bool) -> Point {
        self.spring.point(state, overlap, 0.0)
    }

    #[inline(always)]
    fn stored(&self, _size: PairSize, state: Memory, overlap: f64) -> f64 {
        self.spring.stored(state, overlap)
    }

    #[inline(always)]
    fn kinks(&self, _size: PairSize, state: Memory) -> [f64; KINKS] {
        self.spring.kinks(state)
    }
}
