//! Normal laws: force along the line of centres.

pub mod dashpot;
pub mod hysteresis;
pub mod jkr_curve;
pub mod path;
mod spring_dashpot;
#[cfg(test)]
mod walk;
mod window;

use super::{MaterialPair, PairSize, law_family};
use crate::dimension::Dimension;
use crate::parameters::{Alternatives, ParameterError, ParameterInfo, Values};
use crate::restitution::ContactEnd;

/// What a normal law sees of a contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NormalInput {
    /// Effective radius and mass.
    pub size: PairSize,
    /// Overlap now [m]; negative across a gap.
    pub overlap: f64,
    /// Rate of approach, d(overlap)/dt [m/s].
    pub rate: f64,
    /// Largest change of the overlap within half a step, `|rate| dt / 2` [m]. With 0 the law gives its plain force.
    pub half_window: f64,
}

impl NormalInput {
    /// The contact at one moment, without a window.
    pub fn at(size: PairSize, overlap: f64, rate: f64) -> Self {
        Self {
            size,
            overlap,
            rate,
            half_window: 0.0,
        }
    }
}

/// What a normal law answers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NormalResponse {
    /// Force that does not depend on the rate (elastic, plastic, adhesive), mean over the window [N]; repulsion is
    /// positive.
    pub elastic: f64,
    /// Damping coefficient, mean over the window [N s/m]: the dashpot's force is this times the rate of approach.
    pub damping: f64,
    /// Least total force [N]: minus infinity, or 0 where contact ends at zero force.
    pub least: f64,
    /// Added to the normal force before friction is limited by it [N], not negative: the pull that presses the
    /// surfaces together.
    pub adhesion: f64,
    /// Energy lost over this step other than in the dashpot [J]: plastic work, tear-off.
    pub lost: f64,
}

impl NormalResponse {
    /// No force.
    pub const NOTHING: Self = Self::viscoelastic(0.0, 0.0);

    /// A spring and a dashpot, without adhesion.
    #[inline(always)]
    pub const fn viscoelastic(elastic: f64, damping: f64) -> Self {
        Self {
            elastic,
            damping,
            least: f64::NEG_INFINITY,
            adhesion: 0.0,
            lost: 0.0,
        }
    }

    /// The same, without a pull where contact ends at zero force.
    #[inline(always)]
    pub fn ending_at(mut self, end: ContactEnd) -> Self {
        if end == ContactEnd::ZeroForce {
            self.least = 0.0;
        }
        self
    }
}

/// A normal law.
///
/// `history` holds what the law remembers of a contact, [`Normal::history`] values, all 0 when the contact is new. A
/// step takes it along the path of the overlap to the end of the window; a plain evaluation (no window) takes it
/// straight to `overlap`.
pub trait Normal: Copy + PartialEq + Send + Sync + 'static {
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
    /// Whether the law finds its own kinks and takes its mean over the window near them only, as [`path::follow`] does.
    /// The predictor-corrector hands such a law the whole window, and others a window near the ends of contact alone
    /// ([`Integrator::half_window`](crate::integrator::Integrator::half_window)).
    const FOLLOWS_KINKS: bool = false;

    /// Binds the law to a pair of materials.
    fn new(values: &Values, pair: &MaterialPair) -> Result<Self, Vec<ParameterError>>;
    /// Force and damping over one step.
    fn respond(&self, input: &NormalInput, history: &mut [f64]) -> NormalResponse;
    /// Energy that the contact would give back on its way out of reach, were there no dashpot [J].
    fn energy(&self, size: PairSize, overlap: f64, history: &[f64]) -> f64;
    /// Tangent stiffness `dF/d(overlap)` at an overlap [N/m].
    fn stiffness(&self, size: PairSize, overlap: f64, history: &[f64]) -> f64;
    /// Shortest time scale of a collision that reaches `overlap` [s].
    fn collision_time(&self, size: PairSize, overlap: f64) -> f64;

    /// How many values of [`Normal::HISTORY`] this law uses with its parameters.
    #[inline(always)]
    fn history(&self) -> usize {
        Self::HISTORY.len()
    }

    /// Gap beyond which a contact with this history exerts no force [m]; negative where a plastic dent ends it.
    #[inline(always)]
    fn reach(&self, _size: PairSize, _history: &[f64]) -> f64 {
        0.0
    }

    /// Overlap of a Hertzian contact with the same radius `a` of contact, `a^2/R` [m], not negative: what tangential laws
    /// take their stiffness from.
    #[inline(always)]
    fn bearing_overlap(&self, _size: PairSize, overlap: f64, _history: &[f64]) -> f64 {
        overlap.max(0.0)
    }

    /// Largest reach with any history [m], not negative.
    #[inline(always)]
    fn largest_reach(&self, _size: PairSize) -> f64 {
        0.0
    }

    /// Whether the law can do for bodies of these sizes what its parameters ask; if not, why.
    fn check(&self, _size: PairSize) -> Result<(), String> {
        Ok(())
    }
}

law_family! {
    family "normal", trait Normal,
    /// A normal law bound to a pair of materials.
    enum NormalLaw, visitor NormalVisitor,
    laws {
        linear::Linear,
        hertz_tsuji::HertzTsuji,
        viscoelastic::Viscoelastic,
        dmt::Dmt,
        jkr::Jkr,
        sjkr::Sjkr,
        walton_braun::WaltonBraun,
        thornton_ning::ThorntonNing,
        luding::Luding,
        eepa::Eepa,
        tomas::Tomas,
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
/// for any damping. A force below the least that the law allows is cut there.
#[inline(always)]
pub fn centred_force(response: NormalResponse, rate: f64, previous_force: f64, mass: f64, dt: f64) -> (f64, f64) {
    let half_step = dt / (2.0 * mass);
    let unloaded = rate + previous_force * half_step;
    let corrected = (unloaded - response.elastic * half_step) / (1.0 + response.damping * half_step);
    let force = response.elastic + response.damping * corrected;
    if force < response.least {
        (response.least, unloaded - response.least * half_step)
    } else {
        (force, corrected)
    }
}
