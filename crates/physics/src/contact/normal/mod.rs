//! Normal laws: force along the line of centres.

use super::{MaterialPair, PairSize, law_family};
use crate::dimension::Dimension;
use crate::parameters::{ParameterError, ParameterInfo, Values};

/// What a normal law sees of a contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NormalInput {
    /// Effective radius and mass.
    pub size: PairSize,
    /// Overlap now [m]; negative across a gap.
    pub overlap: f64,
    /// Largest change of the overlap within half a step, `|rate| dt / 2` [m]. With 0 the law gives its plain force.
    pub half_window: f64,
}

/// What a normal law answers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NormalResponse {
    /// Elastic force, mean over the window [N]; repulsion is positive.
    pub elastic: f64,
    /// Damping coefficient, mean over the window [N s/m]: the dashpot's force is this times the rate of approach.
    pub damping: f64,
}

/// A normal law.
pub trait Normal: Copy + Send + Sync {
    /// Name in the scenario.
    const NAME: &'static str;
    /// One line.
    const SUMMARY: &'static str;
    /// The documentation at the top of its file.
    const DOC: &'static str;
    /// Its parameters.
    const PARAMETERS: &'static [ParameterInfo];
    /// Dimensions of the values that it remembers per contact.
    const HISTORY: &'static [Dimension];

    /// Binds the law to a pair of materials.
    fn new(values: &Values, pair: &MaterialPair) -> Result<Self, Vec<ParameterError>>;
    /// Force and damping over one step.
    fn respond(&self, input: &NormalInput) -> NormalResponse;
    /// Energy stored at an overlap [J].
    fn energy(&self, size: PairSize, overlap: f64) -> f64;
    /// Tangent stiffness `dF/d(overlap)` at an overlap [N/m].
    fn stiffness(&self, size: PairSize, overlap: f64) -> f64;
    /// Shortest time of a collision that reaches `overlap` [s].
    fn collision_time(&self, size: PairSize, overlap: f64) -> f64;
}

law_family! {
    family "normal", trait Normal,
    /// A normal law bound to a pair of materials.
    enum NormalLaw, visitor NormalVisitor,
    laws {
        linear::Linear,
        hertz_tsuji::HertzTsuji,
    }
}

/// A contact is near its end when the window reaches this share of the overlap: there the mean is taken exactly,
/// elsewhere through the leading term of its expansion.
const WINDOW_SHARE: f64 = 0.25;

/// Whether the mean over the window must be taken exactly.
#[inline(always)]
pub(crate) fn near_end(input: &NormalInput) -> bool {
    input.half_window > WINDOW_SHARE * input.overlap
}

/// Mean slope of a primitive over the window, `(P(d + h) - P(d - h)) / (2 h)`: the mean of its derivative.
#[inline(always)]
pub(crate) fn mean_slope(input: &NormalInput, primitive: impl Fn(f64) -> f64) -> f64 {
    let h = input.half_window;
    if h > 0.0 {
        let upper = primitive((input.overlap + h).max(0.0));
        let lower = primitive((input.overlap - h).max(0.0));
        (upper - lower) / (2.0 * h)
    } else {
        0.0
    }
}

/// Normal force of one step [N] and the rate of approach that it acts at [m/s].
///
/// The rate handed in is predicted with the force of the step before, `previous_force`. The contact's own change of
/// force since then is put in here, implicitly for the dashpot:
/// `rate' = (rate - (F_el - F_prev) dt / (2 m)) / (1 + c dt / (2 m))`, `F = F_el + c rate'`.
/// For two bodies alone this is velocity Verlet with the dashpot at the true velocity, to second order, and stable
/// for any damping.
#[inline(always)]
pub fn centred_force(response: NormalResponse, rate: f64, previous_force: f64, mass: f64, dt: f64) -> (f64, f64) {
    let half_step = dt / (2.0 * mass);
    let corrected = (rate - (response.elastic - previous_force) * half_step) / (1.0 + response.damping * half_step);
    (response.elastic + response.damping * corrected, corrected)
}
