//! Tangential laws: friction in the contact plane.

use super::lane_by_lane::{ask, vector_in, vector_of};
use super::spring::Carried;
use super::{MaterialPair, PairSize, law_family};
use crate::dimension::Dimension;
use crate::lanes::Lanes;
use crate::parameters::{Alternatives, ParameterError, ParameterInfo, Values};
use glam::DVec3;

/// What a tangential law sees of a contact.
#[derive(Clone, Copy, Debug)]
pub struct TangentialInput<L: Lanes = f64> {
    /// Effective radius and mass.
    pub size: PairSize<L>,
    /// Overlap of a Hertzian contact with this radius `a` of contact, `a^2/R` [m], not negative; without adhesion the
    /// overlap itself.
    pub overlap: L,
    /// Unit normal, from the second body to the first.
    pub normal: L::Vector,
    /// Velocity of the first body relative to the second at the contact point, in the contact plane [m/s].
    pub velocity: L::Vector,
    /// Mean angular velocity of the two bodies about the normal [1/s].
    pub spin: L,
    /// Normal force that friction is limited by [N], not negative.
    pub normal_force: L,
    /// Time step [s].
    pub dt: f64,
    /// Largest share of the relative speed that a law without memory may remove in this step
    /// ([`Integrator::removable_share`](crate::integrator::Integrator::removable_share)).
    pub removable_share: f64,
}

impl<L: Lanes> TangentialInput<L> {
    /// The contact in one lane.
    #[inline(always)]
    pub fn lane(&self, lane: usize) -> TangentialInput {
        TangentialInput {
            size: self.size.lane(lane),
            normal: vector_in::<L>(&self.normal, lane),
            velocity: vector_in::<L>(&self.velocity, lane),
            spin: self.spin.as_slice()[lane],
            normal_force: self.normal_force.as_slice()[lane],
            overlap: self.overlap.as_slice()[lane],
            dt: self.dt,
            removable_share: self.removable_share,
        }
    }
}

/// What a tangential law answers.
#[derive(Clone, Copy, Debug)]
pub struct TangentialResponse<L: Lanes = f64> {
    /// Force on the first body [N].
    pub force: L::Vector,
    /// Energy dissipated in this step [J].
    pub dissipated: L,
}

impl TangentialResponse {
    /// No force.
    pub const NOTHING: Self = Self {
        force: DVec3::ZERO,
        dissipated: 0.0,
    };
}

impl<L: Lanes> TangentialResponse<L> {
    /// From one answer per lane.
    #[inline(always)]
    pub fn of_lanes(answers: &[TangentialResponse]) -> Self {
        Self {
            force: vector_of::<L>(|k| answers[k].force),
            dissipated: L::from_fn(|k| answers[k].dissipated),
        }
    }
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
    /// Whether [`Tangential::respond_wide`] works on all lanes at once; if not, contacts are taken one by one.
    const WIDE: bool = false;
    /// Whether the first values that it remembers are a load that turns with the contact ([`carry_along`](super::spring::carry_along)).
    const REMEMBERS_A_SPRING: bool = false;

    /// Binds the law to a pair of materials.
    fn new(values: &Values, pair: &MaterialPair) -> Result<Self, Vec<ParameterError>>;
    /// Force over one step; `history` holds as many values as [`Tangential::HISTORY`].
    fn respond(&self, input: &TangentialInput, history: &mut [f64]) -> TangentialResponse;
    /// The same in every lane: `history` holds the lanes of each value in turn.
    #[inline(always)]
    fn respond_wide<L: Lanes>(&self, input: &TangentialInput<L>, history: &mut [L]) -> TangentialResponse<L> {
        let nothing = TangentialResponse::NOTHING;
        let answers = ask(history, nothing, |lane, history| {
            self.respond(&input.lane(lane), history)
        });
        TangentialResponse::of_lanes(&answers)
    }
    /// The same, told how the remembered load is carried along, where that is known already.
    #[inline(always)]
    fn respond_carried<L: Lanes>(
        &self,
        input: &TangentialInput<L>,
        history: &mut [L],
        _carried: Option<Carried<L>>,
    ) -> TangentialResponse<L> {
        self.respond_wide(input, history)
    }
    /// Largest force that friction bears before the contact slides as a whole [N].
    fn limit<L: Lanes>(&self, normal_force: L) -> L;
    /// Share of critical damping of its spring.
    fn damping_ratio(&self) -> f64 {
        0.0
    }
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
