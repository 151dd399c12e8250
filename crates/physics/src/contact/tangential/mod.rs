//! Tangential laws: friction in the contact plane.

use super::{MaterialPair, PairSize, law_family};
use crate::dimension::Dimension;
use crate::parameters::{Alternatives, ParameterError, ParameterInfo, Values};
use glam::DVec3;

/// What a tangential law sees of a contact.
#[derive(Clone, Copy, Debug)]
pub struct TangentialInput {
    /// Effective radius and mass.
    pub size: PairSize,
    /// Effective mass of tangential motion at the contact point, `1/(1/m + l_i^2/I_i + l_j^2/I_j)` [kg].
    pub tangential_mass: f64,
    /// Overlap of a Hertzian contact with this radius `a` of contact, `a^2/R` [m], not negative; without adhesion the
    /// overlap itself.
    pub overlap: f64,
    /// Unit normal, from the second body to the first.
    pub normal: DVec3,
    /// Velocity of the first body relative to the second at the contact point, in the contact plane [m/s].
    pub velocity: DVec3,
    /// Mean angular velocity of the two bodies about the normal [1/s].
    pub spin: f64,
    /// Normal force that friction is limited by [N], not negative.
    pub normal_force: f64,
    /// Time step [s].
    pub dt: f64,
    /// Largest share of the relative speed that a law without memory may remove in this step
    /// ([`Integrator::removable_share`](crate::integrator::Integrator::removable_share)).
    pub removable_share: f64,
}

/// What a tangential law answers.
#[derive(Clone, Copy, Debug)]
pub struct TangentialResponse {
    /// Force on the first body [N].
    pub force: DVec3,
    /// Energy dissipated in this step [J].
    pub dissipated: f64,
}

/// A tangential law.
pub trait Tangential: Copy + Send + Sync {
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
    /// Force over one step; `history` holds as many values as [`Tangential::HISTORY`].
    fn respond(&self, input: &TangentialInput, history: &mut [f64]) -> TangentialResponse;
    /// Energy stored with this history [J].
    fn energy(&self, history: &[f64]) -> f64;
    /// Tangential stiffness at an overlap [N/m]; 0 for a law without a spring.
    fn stiffness(&self, size: PairSize, overlap: f64) -> f64;
}

law_family! {
    family "tangential", trait Tangential,
    /// A tangential law bound to a pair of materials.
    enum TangentialLaw, visitor TangentialVisitor,
    laws {
        coulomb::Coulomb,
        linear_history::LinearHistory,
        mindlin_history::MindlinHistory,
        mindlin_deresiewicz::MindlinDeresiewicz,
    }
}

/// Coefficient of a dashpot with this share of critical damping [N s/m].
#[inline(always)]
fn dashpot(damping_ratio: f64, stiffness: f64, mass: f64) -> f64 {
    2.0 * damping_ratio * (stiffness * mass).sqrt()
}
