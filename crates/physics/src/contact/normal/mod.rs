//! Normal laws: force along the line of centres.

pub mod dashpot;
mod hertz_spring;
pub mod hysteresis;
pub mod jkr_curve;
pub mod path;
mod spring_dashpot;
#[cfg(test)]
mod walk;
mod window;

use super::{MaterialPair, PairSize, lane_by_lane, law_family};
use crate::dimension::Dimension;
use crate::lanes::{Lanes, Mask};
use crate::parameters::{Alternatives, ParameterError, ParameterInfo, Values};
use crate::restitution::ContactEnd;

/// What a normal law sees of a contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NormalInput<L = f64> {
    /// Effective radius and mass.
    pub size: PairSize<L>,
    /// Overlap now [m]; negative across a gap.
    pub overlap: L,
    /// Rate of approach, d(overlap)/dt [m/s].
    pub rate: L,
    /// Largest change of the overlap within half a step, `|rate| dt / 2` [m]. With 0 the law gives its plain force.
    pub half_window: L,
}

impl<L: Lanes> NormalInput<L> {
    /// The contact in one lane.
    #[inline(always)]
    pub fn lane(&self, lane: usize) -> NormalInput {
        NormalInput {
            size: self.size.lane(lane),
            overlap: self.overlap.as_slice()[lane],
            rate: self.rate.as_slice()[lane],
            half_window: self.half_window.as_slice()[lane],
        }
    }
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
pub struct NormalResponse<L = f64> {
    /// Force that does not depend on the rate (elastic, plastic, adhesive), mean over the window [N]; repulsion is
    /// positive.
    pub elastic: L,
    /// Damping coefficient, mean over the window [N s/m]: the dashpot's force is this times the rate of approach.
    pub damping: L,
    /// Overlap of a Hertzian contact with the same radius `a` of contact, `a^2/R` [m], not negative: what tangential laws take their
    /// stiffness from. The overlap itself but for laws whose area adhesion or yielding changes.
    pub bearing_overlap: L,
    /// Least total force [N]: minus infinity, or 0 where contact ends at zero force.
    pub least: L,
    /// Added to the normal force before friction is limited by it [N], not negative: the pull that presses the
    /// surfaces together.
    pub adhesion: L,
    /// Energy lost over this step other than in the dashpot [J]: plastic work, tear-off.
    pub lost: L,
}

impl NormalResponse {
    /// No force.
    pub const NOTHING: Self = Self {
        elastic: 0.0,
        damping: 0.0,
        bearing_overlap: 0.0,
        least: f64::NEG_INFINITY,
        adhesion: 0.0,
        lost: 0.0,
    };
}

impl<L: Lanes> NormalResponse<L> {
    /// A spring and a dashpot, without adhesion.
    #[inline(always)]
    pub fn spring_dashpot(input: &NormalInput<L>, elastic: L, damping: L) -> Self {
        Self {
            elastic,
            damping,
            bearing_overlap: input.overlap.max(L::splat(0.0)),
            least: L::splat(f64::NEG_INFINITY),
            adhesion: L::splat(0.0),
            lost: L::splat(0.0),
        }
    }

    /// From one answer per lane.
    #[inline(always)]
    pub fn of_lanes(answers: &[NormalResponse]) -> Self {
        Self {
            elastic: L::from_fn(|k| answers[k].elastic),
            damping: L::from_fn(|k| answers[k].damping),
            bearing_overlap: L::from_fn(|k| answers[k].bearing_overlap),
            least: L::from_fn(|k| answers[k].least),
            adhesion: L::from_fn(|k| answers[k].adhesion),
            lost: L::from_fn(|k| answers[k].lost),
        }
    }

    /// The same, without a pull where contact ends at zero force.
    #[inline(always)]
    pub fn ending_at(mut self, end: ContactEnd) -> Self {
        if end == ContactEnd::ZeroForce {
            self.least = L::splat(0.0);
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
    /// How many of them, the first ones, hold with other parameters, too; the others follow from the parameters and are noted anew where
    /// they are 0.
    const LASTING: usize = Self::HISTORY.len();
    /// Whether the law finds its own kinks and takes its mean over the window near them only, as [`path::follow`] does.
    /// The predictor-corrector hands such a law the whole window, and others a window near the ends of contact alone
    /// ([`Integrator::half_window`](crate::integrator::Integrator::half_window)).
    const FOLLOWS_KINKS: bool = false;
    /// Whether [`Normal::respond_wide`] works on all lanes at once; if not, contacts are taken one by one.
    const WIDE: bool = false;

    /// Binds the law to a pair of materials.
    fn new(values: &Values, pair: &MaterialPair) -> Result<Self, Vec<ParameterError>>;
    /// Force and damping over one step.
    fn respond(&self, input: &NormalInput, history: &mut [f64]) -> NormalResponse;
    /// The same in every lane: `history` holds the lanes of each value in turn.
    #[inline(always)]
    fn respond_wide<L: Lanes>(&self, input: &NormalInput<L>, history: &mut [L]) -> NormalResponse<L> {
        let nothing = NormalResponse::NOTHING;
        let answers = lane_by_lane::ask(history, nothing, |lane, history| {
            self.respond(&input.lane(lane), history)
        });
        NormalResponse::of_lanes(&answers)
    }
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

    /// [`Normal::stiffness`] in every lane.
    #[inline(always)]
    fn stiffness_wide<L: Lanes>(&self, size: PairSize<L>, overlap: L, history: &[L]) -> L {
        lane_by_lane::tell(history, |lane, history| {
            self.stiffness(size.lane(lane), overlap.as_slice()[lane], history)
        })
    }

    /// Largest reach with any history [m], not negative.
    #[inline(always)]
    fn largest_reach(&self, _size: PairSize) -> f64 {
        0.0
    }

    /// Brings what a contact remembers in line with this law, where the same law with other parameters wrote it.
    fn adopt(&self, _size: PairSize, history: &mut [f64]) {
        history.iter_mut().skip(Self::LASTING).for_each(|value| *value = 0.0);
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

impl NormalLaw {
    /// The law for bodies of many sizes: it interpolates between sizes where it would solve for a dashpot anew for each. A
    /// restitution asked for is realised within some 1e-6 then.
    #[must_use]
    pub fn for_many_sizes(mut self) -> Self {
        match &mut self {
            Self::Dmt(Dmt { dashpot, .. })
            | Self::Eepa(Eepa { dashpot, .. })
            | Self::Jkr(Jkr { dashpot, .. })
            | Self::Luding(Luding { dashpot, .. })
            | Self::Sjkr(Sjkr { dashpot, .. })
            | Self::ThorntonNing(ThorntonNing { dashpot, .. })
            | Self::Tomas(Tomas { dashpot, .. }) => dashpot.for_many_sizes(),
            _ => (),
        }
        self
    }
}

/// A contact is near its end when the window reaches this share of the overlap: there the mean is taken exactly,
/// elsewhere through the leading term of its expansion.
const WINDOW_SHARE: f64 = 0.25;

/// Whether the mean over the window must be taken exactly.
#[inline(always)]
pub(crate) fn near_end<L: Lanes>(input: &NormalInput<L>) -> L::Mask {
    input.half_window.gt(input.overlap * WINDOW_SHARE)
}

/// Where the window begins and ends, cut to the overlapping part: upper and lower end [m].
#[inline(always)]
fn window<L: Lanes>(input: &NormalInput<L>) -> [L; 2] {
    let (h, zero) = (input.half_window, L::splat(0.0));
    [(input.overlap + h).max(zero), (input.overlap - h).max(zero)]
}

/// Mean over the window of what changes by this much over it.
#[inline(always)]
fn mean_of_change<L: Lanes>(input: &NormalInput<L>, change: L) -> L {
    let h = input.half_window;
    (change / (h * 2.0)).keep(h.gt(L::splat(0.0)))
}

/// Mean slope of a primitive over the window, `(P(d + h) - P(d - h)) / (2 h)`: the mean of its derivative.
#[inline(always)]
pub fn mean_slope(input: &NormalInput, primitive: impl Fn(f64) -> f64) -> f64 {
    let [upper, lower] = window(input);
    mean_of_change(input, primitive(upper) - primitive(lower))
}

/// Largest `c t/m` of the dashpot of a contact in a step. The longest steps that are allowed for constant coefficients come to 0.15.
const MOST_DAMPED: f64 = 0.2;

/// Normal force of one step [N] and the rate of approach that it acts at [m/s].
///
/// The rate handed in is predicted with the force of the step before, `previous_force`. The contact's own change of
/// force since then is put in here, implicitly for the dashpot, over the time `t` of the correcting kick, half a step:
/// `rate' = (rate - (F_el - F_prev) t / m) / (1 + c t / m)`, `F = F_el + c rate'`. With `t = 0` the rate is the true one already.
/// For two bodies alone this is velocity Verlet with the dashpot at the true velocity, to second order, and stable
/// for any damping. A force below the least that the law allows is cut there, and a dashpot whose `c t/m` is above
/// 0.2 gives way: past 1 it would turn the velocity round, and the dashpots of all contacts of a grain add up.
#[inline(always)]
pub fn centred_force<L: Lanes>(
    response: NormalResponse<L>,
    rate: L,
    previous_force: L,
    inverse_mass: L,
    correction: f64,
) -> (L, L) {
    let half_step = inverse_mass * correction;
    let unloaded = rate + previous_force * half_step;
    let mut damping = response.damping;
    let too_strong = (damping * half_step).gt(L::splat(MOST_DAMPED));
    if too_strong.any() {
        damping = L::select(too_strong, L::splat(MOST_DAMPED) / half_step, damping);
    }
    let corrected = (unloaded - response.elastic * half_step) / (damping * half_step + 1.0);
    let force = response.elastic + damping * corrected;
    let cut = force.lt(response.least);
    (
        L::select(cut, response.least, force),
        L::select(cut, unloaded - response.least * half_step, corrected),
    )
}
