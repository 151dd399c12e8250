//! Laws asked for several contacts at a time give the bits that they give for one, with the instructions of every processor.

use super::cases::{NormalCase, PAIRS, Random, SIZES, variants};
use super::planar::{PlanarCase, PlanarInput, PlanarLaw, planar_cases};
use super::tested;
use crate::contact::lane_by_lane::{MOST_HISTORY, vector_of};
use crate::contact::normal::{self, Normal, NormalInput, NormalLaw, NormalVisitor};
use crate::contact::rolling::{Rolling, RollingInput, RollingVisitor};
use crate::contact::tangential::{Tangential, TangentialInput, TangentialVisitor};
use crate::contact::{LawInfo, PairSize};
use crate::lanes::{Instructions, Kernel, Lanes, MOST_LANES, run, run_on_two};
use crate::parameters::Values;

/// Contacts that are asked together.
const CONTACTS: usize = 2 * MOST_LANES;

/// Steps that they are taken along.
const STEPS: usize = 60;

/// What each contact remembers.
type Histories = [[f64; MOST_HISTORY]; CONTACTS];

/// Everything that a law answers for one contact.
type Answer = Vec<f64>;

/// Instructions, and how many registers are taken at a time, if there are enough.
type Registers = (Instructions, usize);

/// Takes blocks of contacts through a law: one by one, or with these registers.
struct Ask<'a, I> {
    registers: Option<Registers>,
    inputs: &'a [I],
    histories: &'a mut Histories,
}

/// A law that is asked for the lanes of one block.
trait AskLanes<I> {
    /// How many values it remembers.
    fn remembered(&self) -> usize;
    /// What it answers for one contact, asked on its own.
    fn one(&self, input: &I, history: &mut [f64]) -> Answer;
    /// What it answers for contacts that fill the lanes: each of its values in every lane.
    fn wide<L: Lanes>(&self, inputs: &[I], history: &mut [L]) -> Vec<L>;
}

struct Blocks<'a, A, I> {
    law: &'a A,
    inputs: &'a [I],
    histories: &'a mut Histories,
}

impl<A: AskLanes<I>, I> Kernel for Blocks<'_, A, I> {
    type Output = Vec<Answer>;

    #[inline(always)]
    fn run<L: Lanes>(self) -> Vec<Answer> {
        let mut answers = Vec::new();
        for (inputs, histories) in self.inputs.chunks(L::COUNT).zip(self.histories.chunks_mut(L::COUNT)) {
            let mut history: Vec<L> = (0..self.law.remembered())
                .map(|value| L::from_fn(|lane| histories[lane][value]))
                .collect();
            let answer = self.law.wide(inputs, &mut history);
            for (lane, memory) in histories.iter_mut().enumerate() {
                for (value, wide) in memory.iter_mut().zip(&history) {
                    *value = wide.to_array()[lane];
                }
                answers.push(answer.iter().map(|wide| wide.to_array()[lane]).collect());
            }
        }
        answers
    }
}

impl<I> Ask<'_, I> {
    fn ask<A: AskLanes<I>>(self, law: &A) -> Vec<Answer> {
        let Self {
            registers,
            inputs,
            histories,
        } = self;
        match registers {
            Some((instructions, 2)) => run_on_two(instructions, Blocks { law, inputs, histories }),
            Some((instructions, _)) => run(instructions, Blocks { law, inputs, histories }),
            None => (inputs.iter().zip(histories))
                .map(|(input, history)| law.one(input, &mut history[..law.remembered()]))
                .collect(),
        }
    }
}

struct OfNormal<'a, N>(&'a N);

impl<N: Normal> AskLanes<NormalInput> for OfNormal<'_, N> {
    fn remembered(&self) -> usize {
        self.0.history()
    }

    fn one(&self, input: &NormalInput, history: &mut [f64]) -> Answer {
        let response = self.0.respond(input, history);
        vec![
            response.elastic,
            response.damping,
            response.least,
            response.adhesion,
            response.lost,
            response.bearing_overlap,
            self.0.stiffness(input.size, input.overlap, history),
        ]
    }

    #[inline(always)]
    fn wide<L: Lanes>(&self, inputs: &[NormalInput], history: &mut [L]) -> Vec<L> {
        let input = NormalInput {
            size: size_of(|k| inputs[k].size),
            overlap: L::from_fn(|k| inputs[k].overlap),
            rate: L::from_fn(|k| inputs[k].rate),
            half_window: L::from_fn(|k| inputs[k].half_window),
        };
        let response = self.0.respond_wide(&input, history);
        vec![
            response.elastic,
            response.damping,
            response.least,
            response.adhesion,
            response.lost,
            response.bearing_overlap,
            self.0.stiffness_wide(input.size, input.overlap, history),
        ]
    }
}

struct OfTangential<'a, T>(&'a T);

impl<T: Tangential> AskLanes<PlanarInput> for OfTangential<'_, T> {
    fn remembered(&self) -> usize {
        T::HISTORY.len()
    }

    fn one(&self, input: &PlanarInput, history: &mut [f64]) -> Answer {
        let response = self.0.respond(&input.friction(), history);
        [response.force.to_array().as_slice(), &[response.dissipated]].concat()
    }

    #[inline(always)]
    fn wide<L: Lanes>(&self, inputs: &[PlanarInput], history: &mut [L]) -> Vec<L> {
        use crate::lanes::Vector;
        let first = inputs[0].friction();
        let input = TangentialInput {
            size: size_of(|k| inputs[k].size),
            overlap: L::from_fn(|k| inputs[k].overlap),
            normal: vector_of::<L>(|k| inputs[k].normal),
            velocity: vector_of::<L>(|k| inputs[k].rate),
            spin: L::from_fn(|k| inputs[k].spin),
            normal_force: L::from_fn(|k| inputs[k].normal_force),
            dt: first.dt,
            removable_share: first.removable_share,
        };
        let response = self.0.respond_wide(&input, history);
        [response.force.components().as_slice(), &[response.dissipated]].concat()
    }
}

struct OfRolling<'a, R>(&'a R);

impl<R: Rolling> AskLanes<PlanarInput> for OfRolling<'_, R> {
    fn remembered(&self) -> usize {
        R::HISTORY.len()
    }

    fn one(&self, input: &PlanarInput, history: &mut [f64]) -> Answer {
        let input = RollingInput {
            twist: input.spin,
            ..input.rolling()
        };
        let response = self.0.respond(&input, history);
        [response.torque.to_array().as_slice(), &[response.dissipated]].concat()
    }

    #[inline(always)]
    fn wide<L: Lanes>(&self, inputs: &[PlanarInput], history: &mut [L]) -> Vec<L> {
        use crate::lanes::Vector;
        let first = inputs[0].rolling();
        let input = RollingInput {
            size: size_of(|k| inputs[k].size),
            rolling_inertia: L::from_fn(|k| inputs[k].inertia),
            normal: vector_of::<L>(|k| inputs[k].normal),
            angular_velocity: vector_of::<L>(|k| inputs[k].rate),
            twist: L::from_fn(|k| inputs[k].spin),
            spin: L::from_fn(|k| inputs[k].spin),
            normal_force: L::from_fn(|k| inputs[k].normal_force),
            normal_stiffness: L::from_fn(|k| inputs[k].normal_stiffness),
            dt: first.dt,
            removable_share: first.removable_share,
        };
        let response = self.0.respond_wide(&input, history);
        [response.torque.components().as_slice(), &[response.dissipated]].concat()
    }
}

fn size_of<L: Lanes>(lane: impl Fn(usize) -> PairSize) -> PairSize<L> {
    PairSize::new(L::from_fn(|k| lane(k).radius), L::from_fn(|k| lane(k).mass))
}

impl NormalVisitor for Ask<'_, NormalInput> {
    type Output = Vec<Answer>;
    fn visit<N: Normal>(self, law: &N) -> Vec<Answer> {
        self.ask(&OfNormal(law))
    }
}

impl TangentialVisitor for Ask<'_, PlanarInput> {
    type Output = Vec<Answer>;
    fn visit<T: Tangential>(self, law: &T) -> Vec<Answer> {
        self.ask(&OfTangential(law))
    }
}

impl RollingVisitor for Ask<'_, PlanarInput> {
    type Output = Vec<Answer>;
    fn visit<R: Rolling>(self, law: &R) -> Vec<Answer> {
        self.ask(&OfRolling(law))
    }
}

/// Which of the numbers that are none comes out is not told by IEEE 754.
fn bits(values: &[f64]) -> Vec<u64> {
    let one = |x: &f64| if x.is_nan() { u64::MAX } else { x.to_bits() };
    values.iter().map(one).collect()
}

/// Takes contacts along their steps, one by one and with all instructions; a contact is new where `fresh` tells.
fn compare<I>(name: &str, drive: &[Vec<I>], fresh: &[Vec<bool>], ask: impl Fn(Ask<I>) -> Vec<Answer>) {
    let start = || [[0.0; MOST_HISTORY]; CONTACTS];
    let mut single = start();
    let mut wide: Vec<_> = (Instructions::available().into_iter())
        .map(|instructions| ((instructions, 1), start()))
        .chain([((Instructions::widest(), 2), start())])
        .collect();
    for (step, (inputs, fresh)) in drive.iter().zip(fresh).enumerate() {
        for histories in wide.iter_mut().map(|(_, h)| h).chain([&mut single]) {
            for (history, _) in histories.iter_mut().zip(fresh).filter(|(_, fresh)| **fresh) {
                *history = [0.0; MOST_HISTORY];
            }
        }
        let expected = ask(Ask {
            registers: None,
            inputs,
            histories: &mut single,
        });
        for (registers, histories) in &mut wide {
            let found = ask(Ask {
                registers: Some(*registers),
                inputs,
                histories,
            });
            assert_eq!(found.len(), CONTACTS);
            for contact in 0..CONTACTS {
                let (instructions, count) = (registers.0.name(), registers.1);
                let at = format!("{name}, {count} of {instructions}, step {step}, contact {contact}");
                let (found, expected) = (&found[contact], &expected[contact]);
                assert_eq!(bits(found), bits(expected), "{at}: {found:?} for {expected:?}");
                let (found, expected) = (&histories[contact], &single[contact]);
                assert_eq!(
                    bits(found),
                    bits(expected),
                    "{at}: remembers {found:?} for {expected:?}"
                );
            }
        }
    }
}

/// Which contacts are new in which step: all in the first.
fn births(random: &mut Random) -> Vec<Vec<bool>> {
    (0..STEPS)
        .map(|step| (0..CONTACTS).map(|_| step == 0 || random.share() < 0.05).collect())
        .collect()
}

/// Whether nothing is there: lanes that are left over are filled with zeros.
fn is_padding(step: usize, contact: usize) -> bool {
    contact % MOST_LANES == MOST_LANES - 1 && step.is_multiple_of(3)
}

/// A contact that is anywhere from far apart to deeply pressed, moving slowly or fast.
fn anywhere(random: &mut Random, size: PairSize) -> NormalInput {
    let depth = size.radius * libm::pow(10.0, random.between(-9.0, -1.0));
    let overlap = match (random.share() * 8.0) as u32 {
        0 => 0.0,
        1 | 2 => -depth,
        _ => depth,
    };
    let half_window = match (random.share() * 4.0) as u32 {
        0 => 0.0,
        1 => overlap.abs() * random.share(),
        _ => depth * libm::pow(10.0, random.between(-6.0, 1.0)),
    };
    let direction = if random.share() < 0.5 { 1.0 } else { -1.0 };
    NormalInput {
        size,
        overlap,
        rate: 1e4 * half_window * direction,
        half_window,
    }
}

fn compare_normal(info: &'static LawInfo, values: &Values, seed: u64) {
    let pair = PAIRS[1 + 2 * (seed % 2) as usize];
    let law = NormalLaw::build(info.name, values, &pair).unwrap();
    let mut random = Random(seed);
    let sizes: Vec<_> = (0..CONTACTS)
        .map(|_| SIZES[(random.share() * SIZES.len() as f64) as usize])
        .collect();
    let drive: Vec<Vec<_>> = (0..STEPS)
        .map(|step| {
            let input = |contact: usize| match is_padding(step, contact) {
                true => NormalInput::at(PairSize::default(), 0.0, 0.0),
                false => anywhere(&mut random, sizes[contact]),
            };
            (0..CONTACTS).map(input).collect()
        })
        .collect();
    let fresh = births(&mut random);
    let size = sizes[0];
    let name = NormalCase { info, law, pair, size }.name();
    compare(&format!("{name}, {values:?}"), &drive, &fresh, |ask| law.visit(ask));
}

/// Runs a test with a stack for lanes that a build without optimisation keeps in memory.
fn on_large_stack(test: impl FnOnce() + Send + 'static) {
    let thread = std::thread::Builder::new().stack_size(64 << 20).spawn(test).unwrap();
    if let Err(panic) = thread.join() {
        std::panic::resume_unwind(panic);
    }
}

#[test]
fn normal_laws_give_every_lane_the_bits_of_one_contact() {
    on_large_stack(|| {
        for info in tested(normal::LAWS) {
            for (seed, values) in variants(info).into_iter().enumerate() {
                compare_normal(info, &values, seed as u64);
            }
        }
    });
}

/// Paths of many contacts of a case; rates, loads and contacts are missing here and there.
fn planar_drive(case: &PlanarCase, random: &mut Random) -> Vec<Vec<PlanarInput>> {
    let paths: Vec<_> = (0..CONTACTS as u64)
        .map(|seed| case.rough_drive(seed, STEPS as u32))
        .collect();
    let nothing = PlanarInput {
        size: PairSize::default(),
        inertia: 0.0,
        overlap: 0.0,
        normal_stiffness: 0.0,
        normal: glam::DVec3::ZERO,
        rate: glam::DVec3::ZERO,
        spin: 0.0,
        normal_force: 0.0,
        ..paths[0][0]
    };
    let mut at = |step: usize, contact: usize| {
        let input = paths[contact][step];
        match (random.share() * 10.0) as u32 {
            _ if is_padding(step, contact) => nothing,
            0 => PlanarInput {
                rate: glam::DVec3::ZERO,
                ..input
            },
            1 => PlanarInput {
                normal_force: 0.0,
                ..input
            },
            2 => PlanarInput {
                overlap: 0.0,
                normal_stiffness: 0.0,
                ..input
            },
            _ => input,
        }
    };
    (0..STEPS)
        .map(|step| (0..CONTACTS).map(|contact| at(step, contact)).collect())
        .collect()
}

#[test]
fn friction_and_rolling_laws_give_every_lane_the_bits_of_one_contact() {
    on_large_stack(|| {
        for (seed, case) in planar_cases(&[]).into_iter().enumerate() {
            let mut random = Random(seed as u64);
            let drive = planar_drive(&case, &mut random);
            let fresh = births(&mut random);
            compare(&case.name(), &drive, &fresh, |ask| match &case.law {
                PlanarLaw::Friction(law) => law.visit(ask),
                PlanarLaw::Rolling(law) => law.visit(ask),
            });
        }
    });
}
