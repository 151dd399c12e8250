//! Contact laws, several contacts at a time: from how the bodies move to what the contacts do to them, without leaving the
//! registers in between.

use super::asking::{Lot, Press, Pressed, Roll, Rub, Span, Stiffness};
use super::kinematics::{Motion, Sight, Source, load_some, store_some_singles};
use super::laws::{friction_limit, normal_history, spring_energies, tangential_history};
use super::meetings::{lanes_below, next_lane};
use super::sum::{Loads, Sink};
use super::together::Laws;
use super::told::Told;
use super::{EIGHT, Tally};
use demeter_physics::contact::PairLaw;
use demeter_physics::contact::rolling::RollingInput;
use demeter_physics::contact::tangential::{TangentialInput, TangentialResponse};
use demeter_physics::integrator::Integrator;
use demeter_physics::lanes::{Kernel, Lanes, MOST_LANES, Mask, Vector};
use std::ops::Range;

/// What the contacts of a chunk know, and what comes out of a step.
pub(super) struct Answers<'a> {
    /// Normal force of every contact, of the step before and then of this one, rounded to single precision [N]. A step needs that of the
    /// one before only to take back what it did to velocities that are foreseen, which singles tell, too.
    pub(super) normal_force: &'a mut [f32],
    /// What all of their laws remember, `stride` values per contact.
    pub(super) history: &'a mut [f64],
    pub(super) stride: usize,
    /// Force in the contact plane on the first body [N].
    pub(super) tangential: &'a mut Told,
    /// Torque of the rolling law on the first body [N m]; empty where no law resists rolling.
    pub(super) torques: &'a mut Told,
    /// What every contact loses, nothing yet; empty where nobody asks.
    pub(super) losses: &'a mut [Lost],
    /// Normal force that does not depend on the rate [N]; empty where nobody asks.
    pub(super) elastic: &'a mut [f64],
}

/// Asks the laws of one material pair about contacts.
pub(super) struct Respond<'a, S, K, W> {
    pub(super) source: S,
    pub(super) sink: &'a mut K,
    /// The laws as they are asked.
    pub(super) laws: W,
    pub(super) law: &'a PairLaw,
    pub(super) span: Span,
    pub(super) integrator: Integrator,
    pub(super) answers: Answers<'a>,
}

impl<'a, S, K> Respond<'a, S, K, ()> {
    /// The same with laws.
    pub(super) fn with<W: Laws>(self, laws: W) -> Respond<'a, S, K, W> {
        let Self {
            source,
            sink,
            laws: (),
            law,
            span,
            integrator,
            answers,
        } = self;
        Respond {
            source,
            sink,
            laws,
            law,
            span,
            integrator,
            answers,
        }
    }
}

/// Sums over contacts, in an order that no number of lanes changes.
#[repr(align(64))]
struct Losses([[f64; EIGHT]; 4]);

impl Losses {
    /// Adds what the contacts from `k` on lose.
    #[inline(always)]
    fn add<L: Lanes>(&mut self, kind: usize, k: usize, lost: L) {
        let sums = &mut self.0[kind][k % EIGHT..];
        let mut which = 0;
        while which < L::REGISTERS {
            (L::Register::load(sums) + lost.register(which)).store(sums);
            which += 1;
        }
    }

    fn sum(&self, kind: usize) -> f64 {
        self.0[kind].iter().sum()
    }
}

const VISCOUS: usize = 0;
const PLASTIC: usize = 1;
const FRICTION: usize = 2;
const ROLLING: usize = 3;

/// Has contacts that acted before forget what they did, and books what their springs still held.
#[inline(never)]
fn end(
    (history, stride, losses): (&mut [f64], usize, &mut [Lost]),
    (k, mut ended): (usize, u32),
    (law, booked): (&PairLaw, &mut Tally),
) {
    while let Some(lane) = next_lane(&mut ended) {
        let first = (k + lane) * stride;
        let history = &mut history[first..first + stride];
        // a zero with a sign is forgotten, too: whether one is left must not depend on which contacts are asked together
        if history.iter().any(|&value| value.to_bits() != 0) {
            booked.book_end(history, law);
            if let Some(lost) = losses.get_mut(k + lane) {
                lost.friction += spring_energies(law, history).0;
            }
            history.fill(0.0);
        }
    }
}

/// Notes the first contact with too much overlap.
#[cold]
#[inline(never)]
fn note_first(too_deep: &mut Option<(usize, f64)>, k: usize, deep: u32, overlaps: [f64; MOST_LANES]) {
    let lane = deep.trailing_zeros() as usize;
    too_deep.get_or_insert((k + lane, overlaps[lane]));
}

impl<S: Source, K: Sink, W: Laws> Kernel for Respond<'_, S, K, W> {
    /// What was lost, and the first contact with too much overlap.
    type Output = (Tally, Option<(usize, f64)>);

    #[inline(always)]
    fn run<L: Lanes>(self) -> Self::Output {
        let Self {
            mut source,
            sink,
            laws,
            law,
            span,
            integrator,
            mut answers,
        } = self;
        let dt = span.dt;
        let count = answers.normal_force.len();
        let (normal_length, tangential_length) = (normal_history(law), tangential_history(law));
        let mut losses = Losses([[0.0; EIGHT]; 4]);
        let mut booked = Tally::default();
        let mut too_deep = None;
        let nothing = L::Vector::null();
        for k in (0..count).step_by(L::COUNT) {
            let until = (k + L::COUNT).min(count);
            let here = lanes_below(until - k);
            let Sight {
                motion,
                turning,
                acting,
                acts,
                ended,
                too_deep: deep,
            } = source.look::<L>(k, here);
            // these are rare; which lanes act is not, and cannot be foretold: nothing branches on that
            if ended != 0 {
                let remembered = (&mut *answers.history, answers.stride, &mut *answers.losses);
                end(remembered, (k, ended), (law, &mut booked));
            }
            if acts == 0 {
                answers.silence::<L>(k..until);
                sink.put_nothing::<L>(k);
                continue;
            }
            if deep != 0 {
                note_first(&mut too_deep, k, deep, motion.overlap.to_array());
            }
            let rows = k * answers.stride..until * answers.stride;
            let mut lot = Lot {
                acting: acts,
                span,
                integrator,
                rows: &mut answers.history[rows],
                stride: answers.stride,
                first: 0,
            };
            // lanes that do not act look like a gentle contact at rest: no law takes the longer way of one that begins or ends
            let gentle = motion.size.radius * GENTLE;
            // which lanes overlap is known before which act, and mostly they are the same
            let overlaps = motion.overlap.gt(L::splat(0.0)) & L::Mask::of_bits(here);
            let mut overlap = L::select(overlaps, motion.overlap, gentle);
            if overlaps.bits() != acts {
                overlap = L::select(acting, motion.overlap, gentle);
            }
            let motion = Motion {
                overlap,
                rate: motion.rate.keep(acting),
                ..motion
            };
            let size = motion.size;
            let spin = turning.spin(&motion);
            lot.first = normal_length;
            let ahead = laws.ahead(&lot, motion.normal, spin * dt);
            lot.first = 0;
            let pressed = laws.press(Press {
                lot: &mut lot,
                size,
                inverse_mass: motion.inverse_mass,
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
            if laws.rubs() {
                lot.first = normal_length;
                rubbed = laws.rub(Rub {
                    lot: &mut lot,
                    input: TangentialInput {
                        size,
                        overlap: pressed.bearing_overlap,
                        normal: motion.normal,
                        velocity: turning.sliding(&motion).or(acting, nothing),
                        spin,
                        normal_force: pressed.friction_load,
                        dt,
                        removable_share: integrator.removable_share(),
                    },
                    ahead,
                });
                losses.add(FRICTION, k, rubbed.dissipated.keep(acting));
            }
            let mut rolling_torque = nothing;
            if laws.rolls() {
                lot.first = 0;
                let normal_stiffness = laws.stiffness(Stiffness {
                    lot: &mut lot,
                    size,
                    overlap: motion.overlap,
                });
                lot.first = normal_length + tangential_length;
                let rolled = laws.roll(Roll {
                    lot: &mut lot,
                    input: RollingInput {
                        size,
                        rolling_inertia: turning.rolling_inertia(&motion),
                        normal: motion.normal,
                        angular_velocity: turning.rolling(&motion).or(acting, nothing),
                        twist: turning.twist(&motion).keep(acting),
                        spin,
                        normal_force: pressed.friction_load,
                        normal_stiffness,
                        dt,
                        removable_share: integrator.removable_share(),
                    },
                });
                losses.add(ROLLING, k, rolled.dissipated.keep(acting));
                rolling_torque = rolled.torque.or(acting, nothing);
                answers.torques.put_lanes::<L>(k, rolling_torque);
            }
            store_some_singles(force, answers.normal_force, k);
            answers.tell::<L>(k..until, &pressed, &rubbed, acting, law);
            let tangential = rubbed.force.or(acting, nothing);
            answers.tangential.put_lanes::<L>(k, tangential);
            let arm = motion.normal.outer(tangential);
            let mut loads = Loads::<L> {
                force: motion.normal * force + tangential,
                first_torque: arm * -motion.levers[0],
                second_torque: arm * motion.levers[1],
            };
            if laws.rolls() {
                loads.first_torque = loads.first_torque + rolling_torque;
                loads.second_torque = loads.second_torque + rolling_torque;
            }
            let mut which = 0;
            while which < L::REGISTERS {
                let first = k + which * L::Register::COUNT;
                if first < count {
                    sink.put::<L::Register>(first, &loads.register(which));
                }
                which += 1;
            }
        }
        booked.viscous += losses.sum(VISCOUS);
        booked.plastic += losses.sum(PLASTIC);
        booked.friction += losses.sum(FRICTION);
        booked.rolling += losses.sum(ROLLING);
        (booked, too_deep)
    }
}

/// What a contact lost in a step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Lost {
    /// By its normal law [J].
    pub(super) normal: f64,
    /// By friction [J].
    pub(super) friction: f64,
    /// What bore the friction, adhesion included, times the way slid, where it slid as a whole [N m].
    pub(super) slid_load: f64,
}

/// A contact slides as a whole under at least this share of what friction bears: forces of the parts of a contact (`mindlin-deresiewicz`)
/// lag behind a direction that turns, each by itself.
const SLIDING: f64 = 0.99;

/// Overlap, as a share of the effective radius, of lanes that do not act.
const GENTLE: f64 = 1e-3;

impl Answers<'_> {
    /// Lets some contacts have no force.
    #[inline(always)]
    fn silence<L: Lanes>(&mut self, places: Range<usize>) {
        self.normal_force[places.clone()].fill(0.0);
        self.tangential.put_lanes::<L>(places.start, L::Vector::null());
        self.torques.put_lanes::<L>(places.start, L::Vector::null());
        if let Some(elastic) = self.elastic.get_mut(places) {
            elastic.fill(0.0);
        }
    }

    /// Tells what is asked beside forces of some contacts.
    #[inline(always)]
    fn tell<L: Lanes>(
        &mut self,
        places: Range<usize>,
        pressed: &Pressed<L>,
        rubbed: &TangentialResponse<L>,
        acting: L::Mask,
        law: &PairLaw,
    ) {
        if self.losses.is_empty() && self.elastic.is_empty() {
            return;
        }
        if !self.losses.is_empty() {
            let lost = [
                (pressed.viscous + pressed.lost).keep(acting).to_array(),
                rubbed.dissipated.keep(acting).to_array(),
                rubbed.force.square().sqrt().keep(acting).to_array(),
                pressed.friction_load.to_array(),
            ];
            tell_losses(&mut self.losses[places.clone()], &lost, law);
        }
        if let Some(elastic) = self.elastic.get_mut(places) {
            let all = pressed.elastic.keep(acting).to_array();
            elastic.copy_from_slice(&all[..elastic.len()]);
        }
    }
}

/// Tells what contacts lose, told what by their normal laws and by friction, and their tangential forces and what bears them.
#[inline(never)]
fn tell_losses(losses: &mut [Lost], [normal, friction, force, load]: &[[f64; MOST_LANES]; 4], law: &PairLaw) {
    for (lane, told) in losses.iter_mut().enumerate() {
        told.normal += normal[lane];
        told.friction += friction[lane];
        let slides = force[lane] > 0.0 && force[lane] >= SLIDING * friction_limit(law, load[lane]);
        told.slid_load = if slides {
            load[lane] * friction[lane] / force[lane]
        } else {
            0.0
        };
    }
}
