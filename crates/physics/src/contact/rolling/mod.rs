//! Rolling laws: a torque against rolling, and perhaps against torsion.

use super::lane_by_lane::{ask, vector_in, vector_of};
use super::{MaterialPair, PairSize, law_family};
use crate::dimension::Dimension;
use crate::lanes::Lanes;
use crate::parameters::{Alternatives, ParameterError, ParameterInfo, Values};
use glam::DVec3;

/// What a rolling law sees of a contact.
#[derive(Clone, Copy, Debug)]
pub struct RollingInput<L: Lanes = f64> {
    /// Effective radius and mass.
    pub size: PairSize<L>,
    /// Effective moment of inertia of rolling about the contact point,
    /// `1/(1/(I_i + m_i l_i^2) + 1/(I_j + m_j l_j^2))` [kg m^2].
    pub rolling_inertia: L,
    /// Unit normal, from the second body to the first.
    pub normal: L::Vector,
    /// Angular velocity of the first body relative to the second, in the contact plane [1/s].
    pub angular_velocity: L::Vector,
    /// Angular velocity of the first body relative to the second, about the normal [1/s].
    pub twist: L,
    /// Mean angular velocity of the two bodies about the normal [1/s].
    pub spin: L,
    /// Normal force that the torque is limited by [N], not negative.
    pub normal_force: L,
    /// Tangent stiffness of the normal law at this overlap [N/m].
    pub normal_stiffness: L,
    /// Time step [s].
    pub dt: f64,
    /// Largest share of the relative speed that a law without memory may remove in this step
    /// ([`Integrator::removable_share`](crate::integrator::Integrator::removable_share)).
    pub removable_share: f64,
}

impl<L: Lanes> RollingInput<L> {
    /// The contact in one lane.
    #[inline(always)]
    pub fn lane(&self, lane: usize) -> RollingInput {
        RollingInput {
            size: self.size.lane(lane),
            rolling_inertia: self.rolling_inertia.as_slice()[lane],
            normal: vector_in::<L>(&self.normal, lane),
            angular_velocity: vector_in::<L>(&self.angular_velocity, lane),
            twist: self.twist.as_slice()[lane],
            spin: self.spin.as_slice()[lane],
            normal_force: self.normal_force.as_slice()[lane],
            normal_stiffness: self.normal_stiffness.as_slice()[lane],
            dt: self.dt,
            removable_share: self.removable_share,
        }
    }
}

/// What a rolling law answers.
#[derive(Clone, Copy, Debug)]
pub struct RollingResponse<L: Lanes = f64> {
    /// Torque on the first body [N m]; the second takes the opposite.
    pub torque: L::Vector,
    /// Energy dissipated in this step [J].
    pub dissipated: L,
}

impl RollingResponse {
    /// No torque.
    pub const NOTHING: Self = Self {
        torque: DVec3::ZERO,
        dissipated: 0.0,
    };
}

impl<L: Lanes> RollingResponse<L> {
    /// From one answer per lane.
    #[inline(always)]
    pub fn of_lanes(answers: &[RollingResponse]) -> Self {
        Self {
            torque: vector_of::<L>(|k| answers[k].torque),
            dissipated: L::from_fn(|k| answers[k].dissipated),
        }
    }
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
    /// Whether [`Rolling::respond_wide`] works on all lanes at once; if not, contacts are taken one by one.
    const WIDE: bool = false;

    /// Binds the law to a pair of materials.
    fn new(values: &Values, pair: &MaterialPair) -> Result<Self, Vec<ParameterError>>;
    /// Torque over one step; `history` holds as many values as [`Rolling::HISTORY`].
    fn respond(&self, input: &RollingInput, history: &mut [f64]) -> RollingResponse;
    /// The same in every lane: `history` holds the lanes of each value in turn.
    #[inline(always)]
    fn respond_wide<L: Lanes>(&self, input: &RollingInput<L>, history: &mut [L]) -> RollingResponse<L> {
        let nothing = RollingResponse::NOTHING;
        let answers = ask(history, nothing, |lane, history| {
            self.respond(&input.lane(lane), history)
        });
        RollingResponse::of_lanes(&answers)
    }
    /// Share of critical damping of its spring.
    fn damping_ratio(&self) -> f64 {
        0.0
    }
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
        epsd_torsion::EpsdTorsion,
    }
}
