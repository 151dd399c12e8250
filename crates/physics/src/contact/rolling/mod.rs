//! Rolling laws: a torque against rolling.

use super::{MaterialPair, PairSize, law_family};
use crate::dimension::Dimension;
use crate::parameters::{Alternatives, ParameterError, ParameterInfo, Values};
use glam::DVec3;

/// What a rolling law sees of a contact.
#[derive(Clone, Copy, Debug)]
pub struct RollingInput {
    /// Effective radius and mass.
    pub size: PairSize,
    /// Effective moment of inertia of rolling about the contact point,
    /// `1/(1/(I_i + m_i l_i^2) + 1/(I_j + m_j l_j^2))` [kg m^2].
    pub rolling_inertia: f64,
    /// Unit normal, from the second body to the first.
    pub normal: DVec3,
    /// Angular velocity of the first body relative to the second, in the contact plane [1/s].
    pub angular_velocity: DVec3,
    /// Mean angular velocity of the two bodies about the normal [1/s].
    pub spin: f64,
    /// Normal force that the torque is limited by [N], not negative.
    pub normal_force: f64,
    /// Tangent stiffness of the normal law at this overlap [N/m].
    pub normal_stiffness: f64,
    /// Time step [s].
    pub dt: f64,
    /// Largest share of the relative speed that a law without memory may remove in this step
    /// ([`Integrator::removable_share`](crate::integrator::Integrator::removable_share)).
    pub removable_share: f64,
}

/// What a rolling law answers.
#[derive(Clone, Copy, Debug)]
pub struct RollingResponse {
    /// Torque on the first body [N m]; the second takes the opposite.
    pub torque: DVec3,
    /// Energy dissipated in this step [J].
    pub dissipated: f64,
}

/// A rolling law.
pub trait Rolling: Copy + Send + Sync {
    /// Name in the scenario.
    const NAME: &'static str;
    /// One line.
    const SUMMARY: &'static str;
    /// The documentation at the top of its file.
    const DOC: &'static str;
    /// Its parameters.
    const PARAMETERS: &'static [ParameterInfo];
    /// Which of them tell the same thing.
    const ALTERNATIVES: &'static [Alternatives] = &[];
    /// Dimensions of the values that it remembers per contact.
    const HISTORY: &'static [Dimension];

    /// Binds the law to a pair of materials.
    fn new(values: &Values, pair: &MaterialPair) -> Result<Self, Vec<ParameterError>>;
    /// Torque over one step; `history` holds as many values as [`Rolling::HISTORY`].
    fn respond(&self, input: &RollingInput, history: &mut [f64]) -> RollingResponse;
    /// Energy stored with this history [J].
    fn energy(&self, history: &[f64]) -> f64;
    /// Rolling stiffness [N m] at a tangent normal stiffness; 0 for a law without a spring.
    fn stiffness(&self, size: PairSize, normal_stiffness: f64) -> f64;
}

law_family! {
    family "rolling", trait Rolling,
    /// A rolling law bound to a pair of materials.
    enum RollingLaw, visitor RollingVisitor,
    laws {
        constant_torque::ConstantTorque,
        epsd::Epsd,
    }
}
