#![doc = include_str!("independent.md")]

use super::{ContactPair, MultiContact};
use crate::contact::MaterialPair;
use crate::lanes::Lanes;
use crate::parameters::{ParameterError, ParameterInfo, Values};
use crate::params;

params! {
    /// Parameters of independent contacts: none.
    pub struct IndependentParameters {}
}

/// Contacts that do not feel each other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Independent;

impl MultiContact for Independent {
    const NAME: &'static str = "independent";
    const SUMMARY: &'static str = "contacts do not feel each other";
    const DOC: &'static str = include_str!("independent.md");
    const PARAMETERS: &'static [ParameterInfo] = IndependentParameters::TABLE;
    const INDEPENDENT: bool = true;
    const FEELS_LEVERS: bool = false;

    fn new(values: &Values, _pair: &MaterialPair) -> Result<Self, Vec<ParameterError>> {
        IndependentParameters::from_values(values)?;
        Ok(Self)
    }

    #[inline(always)]
    fn influence<L: Lanes>(&self, _contacts: &ContactPair<L>) -> L {
        L::splat(0.0)
    }

    fn largest_bulge(&self, _radius: f64, _least_lever: f64) -> f64 {
        0.0
    }

    fn largest_pull(&self, _radius: f64, _least_distance: f64) -> f64 {
        0.0
    }
}
