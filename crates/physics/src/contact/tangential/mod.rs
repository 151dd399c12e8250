//! Tangential laws: friction in the contact plane.

use super::{MaterialPair, PairSize, law_family};
use crate::dimension::Dimension;
use crate::lanes::{Lanes, MOST_LANES, Vector};
use crate::parameters::{Alternatives, ParameterError, ParameterInfo, Values};
use glam::DVec3;

/// What a tangential law sees of a contact.
#[derive(Clone, Copy, Debug)]
pub struct TangentialInput<L: Lanes = f64> {
    /// Effective radius and mass.
    pub size: PairSize<L>,
    /// Effective mass of tangential motion at the contact point, `1/(1/m + l_i^2/I_i + l_j^2/I_j)` [kg].
    pub tangential_mass: L,
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

/// What a tangential law answers.
#[derive(Clone, Copy, Debug)]
pub struct TangentialResponse<L: Lanes = f64> {
    /// Force on the first body [N].
    pub force: L::Vector,
    /// Energy dissipated in this step [J].
    pub dissipated: L,
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

    /// Binds the law to a pair of materials.
    fn new(values: &Values, pair: &MaterialPair) -> Result<Self, Vec<ParameterError>>;
    /// Force over one step; `history` holds as many values as [`Tangential::HISTORY`].
    fn respond(&self, input: &TangentialInput, history: &mut [f64]) -> TangentialResponse;
    /// The same in every lane: `history` holds the lanes of each value in turn.
    #[inline(always)]
    fn respond_wide<L: Lanes>(&self, input: &TangentialInput<L>, history: &mut [L]) -> TangentialResponse<L> {
        lane_by_lane(input, history, |input, history| self.respond(input, history))
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

/// Coefficient of a dashpot with this share of critical damping [N s/m].
#[inline(always)]
fn dashpot<L: Lanes>(damping_ratio: f64, stiffness: L, mass: L) -> L {
    (stiffness * mass).sqrt() * (2.0 * damping_ratio)
}

/// More values than any tangential law remembers.
const MOST_HISTORY: usize = 64;

/// Asks a law that is written for one contact in every lane.
#[inline(always)]
fn lane_by_lane<L: Lanes>(
    input: &TangentialInput<L>,
    history: &mut [L],
    law: impl Fn(&TangentialInput, &mut [f64]) -> TangentialResponse,
) -> TangentialResponse<L> {
    let vector = |v: L::Vector, lane: usize| DVec3::from_array(v.components().map(|c| c.to_array()[lane]));
    let (mut force, mut dissipated) = ([[0.0; MOST_LANES]; 3], [0.0; MOST_LANES]);
    let mut memory = [0.0; MOST_HISTORY];
    for lane in 0..L::COUNT {
        let one = |value: L| value.to_array()[lane];
        let memory = &mut memory[..history.len()];
        for (one, value) in memory.iter_mut().zip(&*history) {
            *one = value.to_array()[lane];
        }
        let answer = law(
            &TangentialInput {
                size: input.size.lane(lane),
                tangential_mass: one(input.tangential_mass),
                overlap: one(input.overlap),
                normal: vector(input.normal, lane),
                velocity: vector(input.velocity, lane),
                spin: one(input.spin),
                normal_force: one(input.normal_force),
                dt: input.dt,
                removable_share: input.removable_share,
            },
            memory,
        );
        for (value, changed) in history.iter_mut().zip(memory) {
            let mut lanes = value.to_array();
            lanes[lane] = *changed;
            *value = L::load(&lanes);
        }
        for (axis, component) in answer.force.to_array().into_iter().enumerate() {
            force[axis][lane] = component;
        }
        dissipated[lane] = answer.dissipated;
    }
    TangentialResponse {
        force: L::Vector::new(L::load(&force[0]), L::load(&force[1]), L::load(&force[2])),
        dissipated: L::load(&dissipated),
    }
}
