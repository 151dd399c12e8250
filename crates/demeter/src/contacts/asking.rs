//! The laws of one family after the other, asked about some contacts at a time.

use super::meetings::next_lane;
use demeter_physics::contact::PairSize;
use demeter_physics::contact::normal::{Normal, NormalInput, NormalResponse, NormalVisitor, centred_force};
use demeter_physics::contact::rolling::{Rolling, RollingInput, RollingResponse, RollingVisitor};
use demeter_physics::contact::spring::{Carried, carry_along};
use demeter_physics::contact::tangential::{Tangential, TangentialInput, TangentialResponse, TangentialVisitor};
use demeter_physics::integrator::Integrator;
use demeter_physics::lanes::{Lanes, MOST_LANES, Mask};

/// The most values that a law which works on all lanes remembers, and as many as others do not exceed: to set more of them to 0 than a
/// law needs would take longer than some laws.
const MOST_WIDE_HISTORY: usize = 32;
const MANY: usize = 16;
const FEW: usize = 4;

/// When forces act that are found at a moment, as velocity Verlet has it: from half a step before it to half a step after it, and those
/// of the start from then on.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Span {
    /// A whole step [s].
    pub(super) dt: f64,
    /// From the moment to the middle of the time in which they act [s].
    ahead: f64,
    /// In which they correct velocities that were predicted [s].
    correction: f64,
}

impl Span {
    /// At the end of a step.
    pub(crate) fn of_step(dt: f64) -> Self {
        Self {
            dt,
            ahead: 0.0,
            correction: 0.5 * dt,
        }
    }

    /// Before any step, or after velocities were told anew.
    pub(crate) fn of_start(dt: f64, integrator: Integrator) -> Self {
        match integrator {
            Integrator::VelocityVerlet => Self {
                dt,
                ahead: 0.25 * dt,
                correction: 0.0,
            },
            Integrator::Gear => Self::of_step(dt),
        }
    }

    /// What a normal law is told of contacts whose overlap is this at the moment [m], with their rate of approach [m/s].
    #[inline(always)]
    pub(crate) fn normal_input<N: Normal, L: Lanes>(
        self,
        integrator: Integrator,
        size: PairSize<L>,
        overlap: L,
        rate: L,
    ) -> NormalInput<L> {
        let half_window = if N::FOLLOWS_KINKS {
            rate.abs() * (0.5 * self.dt)
        } else {
            integrator.half_window(overlap, rate, self.dt)
        };
        let mut input = NormalInput {
            size,
            overlap,
            rate,
            half_window,
        };
        if self.ahead > 0.0 {
            // of contacts that begin or end in the step, what lies before the start does not count; elsewhere the mean is the force now
            let begins = half_window.gt(overlap.abs());
            input.overlap = overlap + (rate * self.ahead).keep(begins);
            input.half_window = L::select(begins, half_window * 0.5, half_window);
        }
        input
    }
}

/// Some contacts, one per lane; which of them act; and where the values of one of their laws lie.
pub(super) struct Lot<'a> {
    pub(super) acting: u32,
    pub(super) span: Span,
    pub(super) integrator: Integrator,
    /// What their laws remember, a row of `stride` values each.
    pub(super) rows: &'a mut [f64],
    pub(super) stride: usize,
    pub(super) first: usize,
}

impl Lot<'_> {
    /// What one contact remembers.
    #[inline(always)]
    fn memory(&mut self, lane: usize, length: usize) -> &mut [f64] {
        let first = lane * self.stride + self.first;
        &mut self.rows[first..first + length]
    }

    /// Whether there are as many contacts as lanes.
    #[inline(always)]
    fn is_whole<L: Lanes>(&self) -> bool {
        L::COUNT * self.stride <= self.rows.len()
    }

    /// Where in a row the four values begin that hold those which are left over behind fours, if a row has four: they go back to
    /// some before them, and are followed by those of other laws where there are fewer.
    #[inline(always)]
    fn left_over(&self, length: usize) -> Option<usize> {
        let last = self.stride.checked_sub(4)?;
        Some((self.first + length.saturating_sub(4)).min(last))
    }

    /// What the contacts remember, as lanes: values by fours as they are, also of contacts that do not act, whose answers do not
    /// count. The values left over repeat, there, those of a contact that acts: so that no law that notes a value takes them
    /// for new.
    #[inline(always)]
    fn recall<L: Lanes, const MOST: usize>(&self, length: usize) -> [L; MOST] {
        let mut lanes = [L::splat(0.0); MOST];
        let mut value = 0;
        if self.is_whole::<L>() {
            while value + 4 <= length {
                let columns = L::strided(self.rows, self.first + value, self.stride);
                lanes[value..value + 4].copy_from_slice(&columns);
                value += 4;
            }
            if value < length
                && let Some(place) = self.left_over(length)
            {
                let columns = L::strided(self.rows, place, self.stride);
                let is_acting = L::Mask::of_bits(self.acting);
                let acts = self.first + self.stride * self.acting.trailing_zeros() as usize;
                while value < length {
                    let repeated = L::splat(self.rows[acts + value]);
                    lanes[value] = L::select(is_acting, columns[self.first + value - place], repeated);
                    value += 1;
                }
            }
        }
        while value < length {
            lanes[value] = L::load(&one_value(
                self.rows,
                (self.first + value, self.stride),
                self.acting,
                L::COUNT,
            ));
            value += 1;
        }
        lanes
    }

    /// Puts back what the contacts remember that act; the others remember nothing.
    #[inline(always)]
    fn remember<L: Lanes>(&mut self, lanes: &[L], length: usize) {
        let is_acting = L::Mask::of_bits(self.acting);
        let mut value = 0;
        if self.is_whole::<L>() {
            while value + 4 <= length {
                let columns = [
                    lanes[value].keep(is_acting),
                    lanes[value + 1].keep(is_acting),
                    lanes[value + 2].keep(is_acting),
                    lanes[value + 3].keep(is_acting),
                ];
                L::put_strided(columns, self.rows, self.first + value, self.stride);
                value += 4;
            }
            if value < length
                && let Some(place) = self.left_over(length)
            {
                let mut columns = L::strided(self.rows, place, self.stride);
                let mut own = place.max(self.first);
                while own < (self.first + length).min(place + 4) {
                    columns[own - place] = lanes[own - self.first].keep(is_acting);
                    own += 1;
                }
                L::put_strided(columns, self.rows, place, self.stride);
                return;
            }
        }
        while value < length {
            put_one_value(
                self.rows,
                (self.first + value, self.stride),
                self.acting,
                &lanes[value].to_array(),
            );
            value += 1;
        }
    }
}

/// One value of some contacts, told where that of the first lies and how far apart they are; those that do not act repeat that of one that
/// does.
#[inline(never)]
fn one_value(values: &[f64], (first, stride): (usize, usize), acting: u32, count: usize) -> [f64; MOST_LANES] {
    let mut all = [values[first + stride * acting.trailing_zeros() as usize]; MOST_LANES];
    for (lane, one) in all.iter_mut().enumerate().take(count) {
        if acting >> lane & 1 != 0 {
            *one = values[first + stride * lane];
        }
    }
    all
}

/// Puts back one value of the contacts that act.
#[inline(never)]
fn put_one_value(values: &mut [f64], (first, stride): (usize, usize), mut acting: u32, numbers: &[f64; MOST_LANES]) {
    while let Some(lane) = next_lane(&mut acting) {
        values[first + stride * lane] = numbers[lane];
    }
}

/// What a normal law makes of some contacts.
pub(super) struct Pressed<L> {
    /// Normal force [N], and its part that does not depend on the rate.
    pub(super) force: L,
    pub(super) elastic: L,
    /// Normal force that friction and rolling resistance are limited by: with the pull of adhesion, not negative [N].
    pub(super) friction_load: L,
    /// Overlap of Hertzian contacts of the same area [m].
    pub(super) bearing_overlap: L,
    /// Lost in the dashpot, and otherwise [J].
    pub(super) viscous: L,
    pub(super) lost: L,
}

/// Normal forces.
pub(super) struct Press<'l, 'a, L: Lanes> {
    pub(super) lot: &'l mut Lot<'a>,
    pub(super) size: PairSize<L>,
    /// Inverse effective mass [1/kg].
    pub(super) inverse_mass: L,
    pub(super) overlap: L,
    pub(super) rate: L,
    /// Normal force of the step before [N].
    pub(super) previous: L,
}

impl<L: Lanes> NormalVisitor for Press<'_, '_, L> {
    type Output = Pressed<L>;

    #[inline(always)]
    fn visit<N: Normal>(self, law: &N) -> Pressed<L> {
        let Self {
            lot,
            size,
            inverse_mass,
            overlap,
            rate,
            previous,
        } = self;
        let span = lot.span;
        let input = span.normal_input::<N, L>(lot.integrator, size, overlap, rate);
        const { assert!(!N::WIDE || N::HISTORY.len() <= MANY) };
        let response = if !N::WIDE {
            press_one_by_one(law, &input, lot)
        } else if N::HISTORY.len() <= FEW {
            press_together::<N, L, FEW>(law, &input, lot)
        } else {
            press_together::<N, L, MANY>(law, &input, lot)
        };
        let (force, rate) = match lot.integrator {
            Integrator::VelocityVerlet => centred_force(response, rate, previous, inverse_mass, span.correction),
            // the predicted rate is of high order already
            Integrator::Gear => ((response.elastic + response.damping * rate).max(response.least), rate),
        };
        Pressed {
            force,
            elastic: response.elastic,
            friction_load: (force + response.adhesion).max(L::splat(0.0)),
            bearing_overlap: response.bearing_overlap,
            // where the force is cut at its least, the spring relaxes into the dashpot without pulling
            viscous: (force - response.elastic) * rate * span.dt,
            lost: response.lost,
        }
    }
}

/// Asks a normal law about all contacts.
#[inline(always)]
fn press_together<N: Normal, L: Lanes, const MOST: usize>(
    law: &N,
    input: &NormalInput<L>,
    lot: &mut Lot,
) -> NormalResponse<L> {
    let length = law.history();
    let mut history = lot.recall::<L, MOST>(length);
    let response = law.respond_wide(input, &mut history[..length]);
    lot.remember(&history, length);
    response
}

/// Asks a normal law about one contact after the other.
#[inline(never)]
fn press_one_by_one<N: Normal, L: Lanes>(law: &N, input: &NormalInput<L>, lot: &mut Lot) -> NormalResponse<L> {
    let mut answers = [NormalResponse::NOTHING; MOST_LANES];
    let mut acting = lot.acting;
    while let Some(lane) = next_lane(&mut acting) {
        answers[lane] = law.respond(&input.lane(lane), lot.memory(lane, law.history()));
    }
    NormalResponse::of_lanes(&answers)
}

/// What friction remembers, and the load among it as it is carried along: both are known before the normal force is.
pub(super) struct Ahead<L: Lanes> {
    memory: [L; MANY],
    carried: Carried<L>,
}

impl<L: Lanes> Ahead<L> {
    /// Of a law; nothing where it remembers no such load.
    #[inline(always)]
    pub(super) fn of<T: Tangential>(lot: &Lot, normal: L::Vector, spin_angle: L) -> Option<Self> {
        const { assert!(!T::REMEMBERS_A_SPRING || T::HISTORY.len() <= MANY) };
        if !(T::REMEMBERS_A_SPRING && T::WIDE) {
            return None;
        }
        let memory = lot.recall::<L, MANY>(T::HISTORY.len());
        Some(Self {
            memory,
            carried: carry_along(&memory, normal, spin_angle),
        })
    }
}

/// Friction.
pub(super) struct Rub<'l, 'a, L: Lanes> {
    pub(super) lot: &'l mut Lot<'a>,
    pub(super) input: TangentialInput<L>,
    pub(super) ahead: Option<Ahead<L>>,
}

impl<L: Lanes> TangentialVisitor for Rub<'_, '_, L> {
    type Output = TangentialResponse<L>;

    #[inline(always)]
    fn visit<T: Tangential>(self, law: &T) -> TangentialResponse<L> {
        let Self { lot, input, ahead } = self;
        let length = T::HISTORY.len();
        const { assert!(!T::WIDE || T::HISTORY.len() <= MOST_WIDE_HISTORY) };
        if let Some(Ahead { mut memory, carried }) = ahead {
            let response = law.respond_carried(&input, &mut memory[..length], Some(carried));
            lot.remember(&memory, length);
            response
        } else if !T::WIDE {
            rub_one_by_one(law, &input, lot)
        } else if length <= MANY {
            rub_together::<T, L, MANY>(law, &input, lot)
        } else {
            rub_together::<T, L, MOST_WIDE_HISTORY>(law, &input, lot)
        }
    }
}

/// Asks a tangential law about all contacts.
#[inline(always)]
fn rub_together<T: Tangential, L: Lanes, const MOST: usize>(
    law: &T,
    input: &TangentialInput<L>,
    lot: &mut Lot,
) -> TangentialResponse<L> {
    let length = T::HISTORY.len();
    let mut history = lot.recall::<L, MOST>(length);
    let response = law.respond_wide(input, &mut history[..length]);
    lot.remember(&history, length);
    response
}

/// Asks a tangential law about one contact after the other.
#[inline(never)]
fn rub_one_by_one<T: Tangential, L: Lanes>(
    law: &T,
    input: &TangentialInput<L>,
    lot: &mut Lot,
) -> TangentialResponse<L> {
    let mut answers = [TangentialResponse::NOTHING; MOST_LANES];
    let mut acting = lot.acting;
    while let Some(lane) = next_lane(&mut acting) {
        answers[lane] = law.respond(&input.lane(lane), lot.memory(lane, T::HISTORY.len()));
    }
    TangentialResponse::of_lanes(&answers)
}

/// Tangent stiffness of normal laws, that of no negative slope.
pub(super) struct Stiffness<'l, 'a, L: Lanes> {
    pub(super) lot: &'l mut Lot<'a>,
    pub(super) size: PairSize<L>,
    pub(super) overlap: L,
}

impl<L: Lanes> NormalVisitor for Stiffness<'_, '_, L> {
    type Output = L;

    #[inline(always)]
    fn visit<N: Normal>(self, law: &N) -> L {
        let Self { lot, size, overlap } = self;
        let length = law.history();
        let stiffness = if N::WIDE {
            let history = lot.recall::<L, MANY>(length);
            law.stiffness_wide(size, overlap, &history[..length])
        } else {
            stiffness_one_by_one(law, size, overlap, lot)
        };
        // an attraction that fades with the gap has a negative slope: no spring against rolling is made of that
        stiffness.max(L::splat(0.0))
    }
}

#[inline(never)]
fn stiffness_one_by_one<N: Normal, L: Lanes>(law: &N, size: PairSize<L>, overlap: L, lot: &mut Lot) -> L {
    let mut stiffness = [0.0; MOST_LANES];
    let mut acting = lot.acting;
    while let Some(lane) = next_lane(&mut acting) {
        let memory = lot.memory(lane, law.history());
        stiffness[lane] = law.stiffness(size.lane(lane), overlap.as_slice()[lane], memory);
    }
    L::load(&stiffness)
}

/// Rolling resistance.
pub(super) struct Roll<'l, 'a, L: Lanes> {
    pub(super) lot: &'l mut Lot<'a>,
    pub(super) input: RollingInput<L>,
}

impl<L: Lanes> RollingVisitor for Roll<'_, '_, L> {
    type Output = RollingResponse<L>;

    #[inline(always)]
    fn visit<R: Rolling>(self, law: &R) -> RollingResponse<L> {
        let Self { lot, input } = self;
        const { assert!(!R::WIDE || R::HISTORY.len() <= MANY) };
        if R::WIDE {
            let length = R::HISTORY.len();
            let mut history = lot.recall::<L, MANY>(length);
            let response = law.respond_wide(&input, &mut history[..length]);
            lot.remember(&history, length);
            response
        } else {
            roll_one_by_one(law, &input, lot)
        }
    }
}

/// Asks a rolling law about one contact after the other.
#[inline(never)]
fn roll_one_by_one<R: Rolling, L: Lanes>(law: &R, input: &RollingInput<L>, lot: &mut Lot) -> RollingResponse<L> {
    let mut answers = [RollingResponse::NOTHING; MOST_LANES];
    let mut acting = lot.acting;
    while let Some(lane) = next_lane(&mut acting) {
        answers[lane] = law.respond(&input.lane(lane), lot.memory(lane, R::HISTORY.len()));
    }
    RollingResponse::of_lanes(&answers)
}
