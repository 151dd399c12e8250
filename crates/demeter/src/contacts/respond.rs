//! Contact laws, several contacts at a time: from how the bodies move to what the contacts do to them, without leaving the
//! registers in between.

use super::kinematics::{Motion, Sight, Source, load_some, store_some};
use super::laws::{normal_history, tangential_history};
use super::meetings::lanes_below;
use super::sum::Sink;
use super::{EightVectors, Tally};
use demeter_physics::contact::normal::{Normal, NormalInput, NormalVisitor, centred_force};
use demeter_physics::contact::rolling::{Rolling, RollingInput, RollingResponse, RollingVisitor};
use demeter_physics::contact::tangential::{Tangential, TangentialInput, TangentialResponse, TangentialVisitor};
use demeter_physics::contact::{PairLaw, PairSize};
use demeter_physics::integrator::Integrator;
use demeter_physics::lanes::{Kernel, Lanes, MOST_LANES, Mask, Vector};

/// The most values that a law which works on all lanes remembers.
const MOST_WIDE_HISTORY: usize = 16;

/// Half of the path of the overlap over which a normal law takes its mean [m].
#[inline(always)]
pub(crate) fn normal_window<N: Normal, L: Lanes>(integrator: Integrator, overlap: L, rate: L, dt: f64) -> L {
    if N::FOLLOWS_KINKS {
        rate.abs() * (0.5 * dt)
    } else {
        integrator.half_window(overlap, rate, dt)
    }
}

/// What the contacts of a chunk know, and what comes out of a step.
pub(super) struct Answers<'a> {
    /// Normal force of every contact, of the step before and then of this one [N].
    pub(super) normal_force: &'a mut [f64],
    /// What all of their laws remember, `stride` values per contact.
    pub(super) history: &'a mut [f64],
    pub(super) stride: usize,
    /// Force in the contact plane on the first body [N].
    pub(super) tangential: &'a mut [EightVectors],
    /// Torque of the rolling law on the first body [N m]; empty where no law resists rolling.
    pub(super) torques: &'a mut [[f64; 4]],
    /// What every contact loses, by its normal law and by friction [J]; empty where nobody asks.
    pub(super) losses: &'a mut [[f64; 2]],
    /// Normal force that does not depend on the rate [N]; empty where nobody asks.
    pub(super) elastic: &'a mut [f64],
}

/// Asks the laws of one material pair about contacts.
pub(super) struct Respond<'a, S, K> {
    pub(super) source: S,
    pub(super) sink: &'a mut K,
    pub(super) law: &'a PairLaw,
    pub(super) dt: f64,
    pub(super) integrator: Integrator,
    pub(super) answers: Answers<'a>,
}

/// Sums over contacts, in an order that no number of lanes changes.
#[repr(align(64))]
struct Losses([[f64; MOST_LANES]; 4]);

impl Losses {
    /// Adds what the contacts from `k` on lose.
    #[inline(always)]
    fn add<L: Lanes>(&mut self, kind: usize, k: usize, lost: L) {
        let sums = &mut self.0[kind][k % MOST_LANES..];
        (L::load(sums) + lost).store(sums);
    }

    fn sum(&self, kind: usize) -> f64 {
        self.0[kind].iter().sum()
    }
}

const VISCOUS: usize = 0;
const PLASTIC: usize = 1;
const FRICTION: usize = 2;
const ROLLING: usize = 3;

/// Some contacts from `k` on, one per lane; which of them act; and where the values of one of their laws lie.
struct Lot<'a> {
    k: usize,
    acting: u32,
    dt: f64,
    integrator: Integrator,
    values: &'a mut [f64],
    stride: usize,
    first: usize,
}

impl Lot<'_> {
    /// What one contact remembers.
    #[inline(always)]
    fn memory(&mut self, lane: usize, length: usize) -> &mut [f64] {
        let first = (self.k + lane) * self.stride + self.first;
        &mut self.values[first..first + length]
    }

    /// Whether there are as many contacts from `k` on as lanes.
    #[inline(always)]
    fn is_whole<L: Lanes>(&self) -> bool {
        (self.k + L::COUNT) * self.stride <= self.values.len()
    }

    /// What the contacts remember, as lanes, where there are four or more; fewer values of those that do not act repeat those of
    /// one that does, so that no law takes them for new.
    #[inline(always)]
    fn recall<L: Lanes>(&self, length: usize) -> [L; MOST_WIDE_HISTORY] {
        let mut lanes = [L::splat(0.0); MOST_WIDE_HISTORY];
        let first = self.stride * self.k + self.first;
        let mut value = 0;
        if self.is_whole::<L>() {
            while value + 4 <= length {
                let columns = L::strided(self.values, first + value, self.stride);
                lanes[value..value + 4].copy_from_slice(&columns);
                value += 4;
            }
        }
        while value < length {
            lanes[value] = L::load(&self.values_of_all(value, L::COUNT));
            value += 1;
        }
        lanes
    }

    /// One value of all contacts; those that do not act repeat that of one that does.
    #[inline(never)]
    fn values_of_all(&self, value: usize, count: usize) -> [f64; MOST_LANES] {
        let first = self.stride * self.k + self.first + value;
        let mut all = [self.values[first + self.stride * self.acting.trailing_zeros() as usize]; MOST_LANES];
        for (lane, one) in all.iter_mut().enumerate().take(count) {
            if self.acting >> lane & 1 != 0 {
                *one = self.values[first + self.stride * lane];
            }
        }
        all
    }

    /// Puts back what the contacts remember that act; the others remember nothing.
    #[inline(always)]
    fn remember<L: Lanes>(&mut self, lanes: &[L; MOST_WIDE_HISTORY], length: usize) {
        let first = self.stride * self.k + self.first;
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
                L::put_strided(columns, self.values, first + value, self.stride);
                value += 4;
            }
        }
        while value < length {
            self.put_value(value, &lanes[value].to_array());
            value += 1;
        }
    }

    /// Puts back one value of the contacts that act.
    #[inline(never)]
    fn put_value(&mut self, value: usize, numbers: &[f64; MOST_LANES]) {
        let first = self.stride * self.k + self.first + value;
        let mut acting = self.acting;
        while let Some(lane) = next_lane(&mut acting) {
            self.values[first + self.stride * lane] = numbers[lane];
        }
    }
}

/// The next lane that is set.
#[inline(always)]
fn next_lane(bits: &mut u32) -> Option<usize> {
    if *bits == 0 {
        return None;
    }
    let lane = bits.trailing_zeros() as usize;
    *bits &= *bits - 1;
    Some(lane)
}

/// What a normal law makes of some contacts.
struct Pressed<L> {
    /// Normal force [N], and its part that does not depend on the rate.
    force: L,
    elastic: L,
    /// Normal force that friction and rolling resistance are limited by: with the pull of adhesion, not negative [N].
    friction_load: L,
    /// Overlap of Hertzian contacts of the same area [m].
    bearing_overlap: L,
    /// Lost in the dashpot, and otherwise [J].
    viscous: L,
    lost: L,
}

/// Normal forces.
struct Press<'l, 'a, L: Lanes> {
    lot: &'l mut Lot<'a>,
    size: PairSize<L>,
    /// Inverse effective mass [1/kg].
    inverse_mass: L,
    overlap: L,
    rate: L,
    /// Normal force of the step before [N].
    previous: L,
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
        let dt = lot.dt;
        let length = law.history();
        let input = NormalInput {
            size,
            overlap,
            rate,
            half_window: normal_window::<N, L>(lot.integrator, overlap, rate, dt),
        };
        let (response, bearing_overlap) = if N::WIDE {
            let mut history = lot.recall::<L>(length);
            let response = law.respond_wide(&input, &mut history[..length]);
            let bearing_overlap = law.bearing_overlap_wide(size, overlap, &history[..length]);
            lot.remember(&history, length);
            (response, bearing_overlap)
        } else {
            press_one_by_one(law, &input, lot)
        };
        let (force, rate) = match lot.integrator {
            Integrator::VelocityVerlet => centred_force(response, rate, previous, inverse_mass, dt),
            // the predicted rate is of high order already
            Integrator::Gear => ((response.elastic + response.damping * rate).max(response.least), rate),
        };
        Pressed {
            force,
            elastic: response.elastic,
            friction_load: (force + response.adhesion).max(L::splat(0.0)),
            bearing_overlap,
            // where the force is cut at its least, the spring relaxes into the dashpot without pulling
            viscous: (force - response.elastic) * rate * dt,
            lost: response.lost,
        }
    }
}

/// Asks a normal law about one contact after the other.
#[inline(never)]
fn press_one_by_one<N: Normal, L: Lanes>(
    law: &N,
    input: &NormalInput<L>,
    lot: &mut Lot,
) -> (demeter_physics::contact::normal::NormalResponse<L>, L) {
    use demeter_physics::contact::normal::NormalResponse;
    let (mut answers, mut bearing) = ([NormalResponse::NOTHING; MOST_LANES], [0.0; MOST_LANES]);
    let mut acting = lot.acting;
    while let Some(lane) = next_lane(&mut acting) {
        let (one, memory) = (input.lane(lane), lot.memory(lane, law.history()));
        answers[lane] = law.respond(&one, memory);
        bearing[lane] = law.bearing_overlap(one.size, one.overlap, memory);
    }
    (NormalResponse::of_lanes(&answers), L::load(&bearing))
}

/// Friction.
struct Rub<'l, 'a, L: Lanes> {
    lot: &'l mut Lot<'a>,
    input: TangentialInput<L>,
}

impl<L: Lanes> TangentialVisitor for Rub<'_, '_, L> {
    type Output = TangentialResponse<L>;

    #[inline(always)]
    fn visit<T: Tangential>(self, law: &T) -> TangentialResponse<L> {
        let Self { lot, input } = self;
        if T::WIDE {
            let length = T::HISTORY.len();
            let mut history = lot.recall::<L>(length);
            let response = law.respond_wide(&input, &mut history[..length]);
            lot.remember(&history, length);
            response
        } else {
            rub_one_by_one(law, &input, lot)
        }
    }
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
struct Stiffness<'l, 'a, L: Lanes> {
    lot: &'l mut Lot<'a>,
    size: PairSize<L>,
    overlap: L,
}

impl<L: Lanes> NormalVisitor for Stiffness<'_, '_, L> {
    type Output = L;

    #[inline(always)]
    fn visit<N: Normal>(self, law: &N) -> L {
        let Self { lot, size, overlap } = self;
        let length = law.history();
        let stiffness = if N::WIDE {
            let history = lot.recall::<L>(length);
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
struct Roll<'l, 'a, L: Lanes> {
    lot: &'l mut Lot<'a>,
    input: RollingInput<L>,
}

impl<L: Lanes> RollingVisitor for Roll<'_, '_, L> {
    type Output = RollingResponse<L>;

    #[inline(always)]
    fn visit<R: Rolling>(self, law: &R) -> RollingResponse<L> {
        let Self { lot, input } = self;
        if R::WIDE {
            let length = R::HISTORY.len();
            let mut history = lot.recall::<L>(length);
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

/// Has contacts that acted before forget what they did, and books what their springs still held.
#[inline(never)]
fn end(answers: &mut Answers, k: usize, mut ended: u32, law: &PairLaw, booked: &mut Tally) {
    while let Some(lane) = next_lane(&mut ended) {
        let first = (k + lane) * answers.stride;
        let history = &mut answers.history[first..first + answers.stride];
        if history.iter().any(|&value| value != 0.0) {
            booked.book_end(history, law);
            history.fill(0.0);
        }
    }
}

impl<S: Source, K: Sink> Kernel for Respond<'_, S, K> {
    /// What was lost, and the first contact with too much overlap.
    type Output = (Tally, Option<(usize, f64)>);

    #[inline(always)]
    fn run<L: Lanes>(self) -> Self::Output {
        let Self {
            mut source,
            sink,
            law,
            dt,
            integrator,
            mut answers,
        } = self;
        let count = answers.normal_force.len();
        let (normal_length, tangential_length) = (normal_history(law), tangential_history(law));
        let mut losses = Losses([[0.0; MOST_LANES]; 4]);
        let mut booked = Tally::default();
        let mut too_deep = None;
        let resists_rolling = !answers.torques.is_empty();
        let nothing = L::Vector::null();
        let no_rows = L::rows([L::splat(0.0); 4]);
        for k in (0..count).step_by(L::COUNT) {
            let here = lanes_below((count - k).min(L::COUNT));
            let Sight {
                motion,
                acts,
                ended,
                too_deep: deep,
            } = source.look::<L>(k, here);
            // these are rare; which lanes act is not, and cannot be foretold: nothing branches on that
            if ended != 0 {
                end(&mut answers, k, ended, law, &mut booked);
            }
            if acts == 0 {
                answers.silence::<L>(k, count);
                sink.put::<L>(k, &no_rows, &no_rows, resists_rolling.then_some(&no_rows));
                continue;
            }
            if deep != 0 && too_deep.is_none() {
                let lane = deep.trailing_zeros() as usize;
                too_deep = Some((k + lane, motion.overlap.to_array()[lane]));
            }
            let acting = L::Mask::of_bits(acts);
            let mut lot = Lot {
                k,
                acting: acts,
                dt,
                integrator,
                values: &mut *answers.history,
                stride: answers.stride,
                first: 0,
            };
            // lanes that do not act look like a gentle contact at rest: no law takes the longer way of one that begins or ends
            let motion = Motion {
                overlap: L::select(acting, motion.overlap, motion.size.radius * GENTLE),
                rate: motion.rate.keep(acting),
                ..motion
            };
            let size = motion.size;
            let pressed = law.normal.visit(Press {
                lot: &mut lot,
                size,
                inverse_mass: motion.inverse_mass(),
                overlap: motion.overlap,
                rate: motion.rate,
                previous: load_some(answers.normal_force, k),
            });
            let force = pressed.force.keep(acting);
            losses.add(VISCOUS, k, pressed.viscous.keep(acting));
            losses.add(PLASTIC, k, pressed.lost.keep(acting));
            let mut rubbed = TangentialResponse {
                force: nothing,
                dissipated: L::splat(0.0),
            };
            if let Some(friction) = &law.tangential {
                lot.first = normal_length;
                rubbed = friction.visit(Rub {
                    lot: &mut lot,
                    input: TangentialInput {
                        size,
                        tangential_mass: motion.tangential_mass(),
                        overlap: pressed.bearing_overlap,
                        normal: motion.normal,
                        velocity: motion.sliding().or(acting, nothing),
                        spin: motion.spin(),
                        normal_force: pressed.friction_load,
                        dt,
                        removable_share: integrator.removable_share(),
                    },
                });
                losses.add(FRICTION, k, rubbed.dissipated.keep(acting));
            }
            let mut torques = no_rows;
            if let Some(resistance) = &law.rolling {
                lot.first = 0;
                let normal_stiffness = law.normal.visit(Stiffness {
                    lot: &mut lot,
                    size,
                    overlap: motion.overlap,
                });
                lot.first = normal_length + tangential_length;
                let rolled = resistance.visit(Roll {
                    lot: &mut lot,
                    input: RollingInput {
                        size,
                        rolling_inertia: motion.rolling_inertia(),
                        normal: motion.normal,
                        angular_velocity: motion.rolling().or(acting, nothing),
                        spin: motion.spin(),
                        normal_force: pressed.friction_load,
                        normal_stiffness,
                        dt,
                        removable_share: integrator.removable_share(),
                    },
                });
                losses.add(ROLLING, k, rolled.dissipated.keep(acting));
                let [x, y, z] = rolled.torque.or(acting, nothing).components();
                torques = L::rows([x, y, z, L::splat(0.0)]);
                let places = k..(k + L::COUNT).min(count);
                for (torque, row) in answers.torques[places].iter_mut().zip(torques.as_ref()) {
                    *torque = *row;
                }
            }
            store_some(force, answers.normal_force, k);
            answers.tell::<L>(k, count, &pressed, &rubbed, acting);
            let tangential = rubbed.force.or(acting, nothing);
            answers.put_tangential::<L>(k, tangential);
            let total = motion.normal * force + tangential;
            let arm = motion.normal.outer(tangential);
            let ([fx, fy, fz], [ax, ay, az]) = (total.components(), arm.components());
            let forces = L::rows([fx, fy, fz, motion.levers[0].keep(acting)]);
            let arms = L::rows([ax, ay, az, motion.levers[1].keep(acting)]);
            sink.put::<L>(k, &forces, &arms, resists_rolling.then_some(&torques));
        }
        booked.viscous += losses.sum(VISCOUS);
        booked.plastic += losses.sum(PLASTIC);
        booked.friction += losses.sum(FRICTION);
        booked.rolling += losses.sum(ROLLING);
        (booked, too_deep)
    }
}

/// Overlap, as a share of the effective radius, of lanes that do not act.
const GENTLE: f64 = 1e-3;

impl Answers<'_> {
    /// Lets the contacts from `k` on have no force.
    #[inline(always)]
    fn silence<L: Lanes>(&mut self, k: usize, count: usize) {
        let places = k..(k + L::COUNT).min(count);
        self.normal_force[places.clone()].fill(0.0);
        self.put_tangential::<L>(k, L::Vector::null());
        if let Some(torques) = self.torques.get_mut(places.clone()) {
            torques.fill([0.0; 4]);
        }
        if let Some(losses) = self.losses.get_mut(places.clone()) {
            losses.fill([0.0; 2]);
        }
        if let Some(elastic) = self.elastic.get_mut(places) {
            elastic.fill(0.0);
        }
    }

    /// Puts the tangential forces of the contacts from `k` on.
    #[inline(always)]
    fn put_tangential<L: Lanes>(&mut self, k: usize, tangential: L::Vector) {
        let [x, y, z] = &mut self.tangential[k / MOST_LANES];
        let components = tangential.components();
        components[0].store(&mut x[k % MOST_LANES..]);
        components[1].store(&mut y[k % MOST_LANES..]);
        components[2].store(&mut z[k % MOST_LANES..]);
    }

    /// Tells what is asked beside forces of the contacts from `k` on.
    #[inline(always)]
    fn tell<L: Lanes>(
        &mut self,
        k: usize,
        count: usize,
        pressed: &Pressed<L>,
        rubbed: &TangentialResponse<L>,
        acting: L::Mask,
    ) {
        if self.losses.is_empty() && self.elastic.is_empty() {
            return;
        }
        let places = k..(k + L::COUNT).min(count);
        if let Some(losses) = self.losses.get_mut(places.clone()) {
            let normal = (pressed.viscous + pressed.lost).keep(acting).to_array();
            let friction = rubbed.dissipated.keep(acting).to_array();
            for (told, (normal, friction)) in losses.iter_mut().zip(normal.iter().zip(friction)) {
                *told = [*normal, friction];
            }
        }
        if let Some(elastic) = self.elastic.get_mut(places) {
            let all = pressed.elastic.keep(acting).to_array();
            elastic.copy_from_slice(&all[..elastic.len()]);
        }
    }
}
