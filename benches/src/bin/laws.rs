//! What a contact law costs per contact: asked for one contact after the other, and for as many as the registers hold.
//!
//! A block of contacts is asked again and again, forth and back; told is the fastest of the rounds. The first block is in
//! lasting contact: deep, slow, sticking. In the second one every other contact is at a limit: friction and rolling laws slide
//! forth and back, and normal laws see contact begin or end within the step.
#![allow(clippy::print_stdout, reason = "a benchmark prints its table")]

use clap::Parser;
use demeter_physics::DVec3;
use demeter_physics::contact::normal::{self, HertzTsuji, Normal, NormalInput, NormalLaw, NormalVisitor};
use demeter_physics::contact::rolling::{self, Rolling, RollingInput, RollingLaw, RollingVisitor};
use demeter_physics::contact::tangential::{self, Tangential, TangentialInput, TangentialLaw, TangentialVisitor};
use demeter_physics::contact::{Elastic, LawInfo, MaterialPair, PairSize};
use demeter_physics::lanes::{Instructions, Kernel, Lanes, Vector, run};
use demeter_physics::parameters::{Values, values};
use rand::Rng;
use std::error::Error;
use std::hint::black_box;
use std::time::Instant;

/// Contacts in a block.
const CONTACTS: usize = 1024;

/// At least as many values as any law remembers.
const MOST_HISTORY: usize = 32;

/// Values that a law answers for a contact.
const ANSWERS: usize = 5;

const GLASS: Elastic = Elastic {
    young_modulus: 63e9,
    poisson_ratio: 0.22,
};

const PAIR: MaterialPair = MaterialPair { a: GLASS, b: GLASS };

/// Time step [s].
const DT: f64 = 1e-7;

/// Share of the relative speed that a law without memory may remove in a step.
const REMOVABLE_SHARE: f64 = 0.2;

#[derive(Parser)]
struct Arguments {
    /// Rounds, of which the fastest is told.
    #[arg(long, default_value_t = 9)]
    rounds: usize,
    /// Times that a block is asked in one round.
    #[arg(long, default_value_t = 500)]
    repeats: usize,
    /// Only laws whose name contains this.
    #[arg(long, default_value = "")]
    only: String,
}

fn main() -> Result<(), Box<dyn Error + Send + Sync>> {
    let arguments = Arguments::parse();
    let instructions = Instructions::available();
    let names: Vec<_> = instructions.iter().map(|i| i.name()).collect();
    println!(
        "| law | contacts | one by one | {} | one by one over {} |",
        names.join(" | "),
        names[0]
    );
    println!("|---|---|---|{}---|", "---|".repeat(names.len()));
    let laws = normal::LAWS.iter().chain(tangential::LAWS).chain(rolling::LAWS);
    for info in laws.filter(|info| info.name.contains(&arguments.only)) {
        for at_limits in [false, true] {
            let bench = Bench {
                arguments: &arguments,
                instructions: &instructions,
                info,
                at_limits,
            };
            let given = example(info);
            match info.family {
                "normal" => NormalLaw::build(info.name, &given, &PAIR)?.visit(bench),
                "tangential" => TangentialLaw::build(info.name, &given, &PAIR)?.visit(bench),
                _ => RollingLaw::build(info.name, &given, &PAIR)?.visit(bench),
            }
        }
    }
    Ok(())
}

/// Typical values of the parameters that an example of the law gives.
fn example(info: &LawInfo) -> Values {
    let typical: Vec<_> = (info.parameters.iter())
        .filter(|p| p.in_example())
        .map(|p| (p.name, p.typical))
        .collect();
    values(&typical)
}

/// Contacts side by side, column by column.
#[derive(Clone, Default)]
struct Block {
    radius: Vec<f64>,
    mass: Vec<f64>,
    inertia: Vec<f64>,
    overlap: Vec<f64>,
    rate: Vec<f64>,
    half_window: Vec<f64>,
    stiffness: Vec<f64>,
    force: Vec<f64>,
    spin: Vec<f64>,
    normal: [Vec<f64>; 3],
    motion: [Vec<f64>; 3],
}

impl Block {
    #[inline(always)]
    fn size<L: Lanes>(&self, at: usize) -> PairSize<L> {
        PairSize::new(L::load(&self.radius[at..]), L::load(&self.mass[at..]))
    }

    #[inline(always)]
    fn normal_input<L: Lanes>(&self, at: usize) -> NormalInput<L> {
        NormalInput {
            size: self.size(at),
            overlap: L::load(&self.overlap[at..]),
            rate: L::load(&self.rate[at..]),
            half_window: L::load(&self.half_window[at..]),
        }
    }

    #[inline(always)]
    fn tangential_input<L: Lanes>(&self, at: usize) -> TangentialInput<L> {
        TangentialInput {
            size: self.size(at),
            overlap: L::load(&self.overlap[at..]),
            normal: vector::<L>(&self.normal, at),
            velocity: vector::<L>(&self.motion, at),
            spin: L::load(&self.spin[at..]),
            normal_force: L::load(&self.force[at..]),
            dt: DT,
            removable_share: REMOVABLE_SHARE,
        }
    }

    #[inline(always)]
    fn rolling_input<L: Lanes>(&self, at: usize) -> RollingInput<L> {
        RollingInput {
            size: self.size(at),
            rolling_inertia: L::load(&self.inertia[at..]),
            normal: vector::<L>(&self.normal, at),
            angular_velocity: vector::<L>(&self.motion, at),
            twist: L::load(&self.spin[at..]),
            spin: L::load(&self.spin[at..]),
            normal_force: L::load(&self.force[at..]),
            normal_stiffness: L::load(&self.stiffness[at..]),
            dt: DT,
            removable_share: REMOVABLE_SHARE,
        }
    }

    /// The same contacts, moving the other way.
    fn back(&self) -> Self {
        let mut back = self.clone();
        for value in back.rate.iter_mut().chain(back.motion.iter_mut().flatten()) {
            *value = -*value;
        }
        back
    }
}

#[inline(always)]
fn vector<L: Lanes>(columns: &[Vec<f64>; 3], at: usize) -> L::Vector {
    let [x, y, z] = columns;
    L::Vector::new(L::load(&x[at..]), L::load(&y[at..]), L::load(&z[at..]))
}

/// A law under test.
trait Subject {
    fn remembered(&self) -> usize;
    fn one(&self, block: &Block, at: usize, history: &mut [f64]) -> [f64; ANSWERS];
    fn wide<L: Lanes>(&self, block: &Block, at: usize, history: &mut [L]) -> [L; ANSWERS];
    /// Stiffness of its spring in the contact plane, if it has one.
    fn spring(&self, _size: PairSize, _overlap: f64, _normal_stiffness: f64) -> f64 {
        0.0
    }
}

struct OfNormal<'a, N>(&'a N);

impl<N: Normal> Subject for OfNormal<'_, N> {
    fn remembered(&self) -> usize {
        self.0.history()
    }

    #[inline(always)]
    fn one(&self, block: &Block, at: usize, history: &mut [f64]) -> [f64; ANSWERS] {
        let r = self.0.respond(&block.normal_input(at), history);
        [r.elastic, r.damping, r.least, r.adhesion, r.lost]
    }

    #[inline(always)]
    fn wide<L: Lanes>(&self, block: &Block, at: usize, history: &mut [L]) -> [L; ANSWERS] {
        let r = self.0.respond_wide(&block.normal_input(at), history);
        [r.elastic, r.damping, r.least, r.adhesion, r.lost]
    }
}

struct OfTangential<'a, T>(&'a T);

impl<T: Tangential> Subject for OfTangential<'_, T> {
    fn remembered(&self) -> usize {
        T::HISTORY.len()
    }

    #[inline(always)]
    fn one(&self, block: &Block, at: usize, history: &mut [f64]) -> [f64; ANSWERS] {
        let r = self.0.respond(&block.tangential_input(at), history);
        [r.force.x, r.force.y, r.force.z, r.dissipated, 0.0]
    }

    #[inline(always)]
    fn wide<L: Lanes>(&self, block: &Block, at: usize, history: &mut [L]) -> [L; ANSWERS] {
        let r = self.0.respond_wide(&block.tangential_input(at), history);
        let [x, y, z] = r.force.components();
        [x, y, z, r.dissipated, L::splat(0.0)]
    }

    fn spring(&self, size: PairSize, overlap: f64, _normal_stiffness: f64) -> f64 {
        self.0.stiffness(size, overlap)
    }
}

struct OfRolling<'a, R>(&'a R);

impl<R: Rolling> Subject for OfRolling<'_, R> {
    fn remembered(&self) -> usize {
        R::HISTORY.len()
    }

    #[inline(always)]
    fn one(&self, block: &Block, at: usize, history: &mut [f64]) -> [f64; ANSWERS] {
        let r = self.0.respond(&block.rolling_input(at), history);
        [r.torque.x, r.torque.y, r.torque.z, r.dissipated, 0.0]
    }

    #[inline(always)]
    fn wide<L: Lanes>(&self, block: &Block, at: usize, history: &mut [L]) -> [L; ANSWERS] {
        let r = self.0.respond_wide(&block.rolling_input(at), history);
        let [x, y, z] = r.torque.components();
        [x, y, z, r.dissipated, L::splat(0.0)]
    }

    fn spring(&self, size: PairSize, _overlap: f64, normal_stiffness: f64) -> f64 {
        self.0.stiffness(size, normal_stiffness)
    }
}

/// Contacts for a law, every other of them at a limit if asked.
fn contacts(subject: &impl Subject, info: &LawInfo, at_limits: bool) -> Block {
    let elastic = HertzTsuji::new(&values(&[("restitution", 1.0)]), &PAIR);
    let mut random = rand_pcg::Pcg64::new(1, 2);
    let mut share = || (random.next_u64() >> 11) as f64 / (1u64 << 53) as f64;
    let mut block = Block::default();
    let typical = |name: &str| info.parameters.iter().find(|p| p.name == name).map(|p| p.typical);
    for k in 0..CONTACTS {
        let limited = at_limits && k % 2 == 0;
        let radius = 1e-3 * (0.5 + share());
        let size = PairSize::new(radius, 2500.0 * 4.0 * radius * radius * radius);
        let overlap = radius * 1e-4 * (0.5 + share());
        let (force, stiffness) = elastic.as_ref().map_or((1.0, 1e6), |law| {
            let response = law.respond(&NormalInput::at(size, overlap, 0.0), &mut []);
            (response.elastic, law.stiffness(size, overlap, &[]))
        });
        let half_window = overlap * if limited { 0.5 + share() } else { 1e-4 };
        let normal = DVec3::new(share() - 0.5, share() - 0.5, 0.6).normalize();
        let across = normal.cross(DVec3::new(share(), share(), -share())).normalize();
        let (inertia, limit) = match typical("rolling_friction") {
            Some(friction) => (1.4 * size.mass * radius * radius, friction * radius * force),
            None => (2.0 / 7.0 * size.mass, typical("friction").unwrap_or(0.0) * force),
        };
        let spring = subject.spring(size, overlap, stiffness);
        let per_rate = if spring > 0.0 { spring * DT } else { inertia / DT };
        let motion = across * (limit / per_rate * if limited { 10.0 } else { 1e-3 });
        block.radius.push(size.radius);
        block.mass.push(size.mass);
        block.inertia.push(inertia);
        block
            .overlap
            .push(if limited && k % 4 == 0 { -overlap } else { overlap });
        block.rate.push(2.0 * half_window / DT);
        block.half_window.push(half_window);
        block.stiffness.push(stiffness);
        block.force.push(force);
        block.spin.push(share() - 0.5);
        for axis in 0..3 {
            block.normal[axis].push(normal[axis]);
            block.motion[axis].push(motion[axis]);
        }
    }
    if info.family != "normal" {
        block.overlap.iter_mut().for_each(|overlap| *overlap = overlap.abs());
    }
    block
}

/// Columns of what is remembered, and of the answers.
struct Table {
    history: Vec<Vec<f64>>,
    answers: [Vec<f64>; ANSWERS],
}

impl Table {
    fn new(remembered: usize) -> Self {
        Self {
            history: vec![vec![0.0; CONTACTS]; if remembered > 4 { MOST_HISTORY } else { remembered }],
            answers: std::array::from_fn(|_| vec![0.0; CONTACTS]),
        }
    }
}

/// Asks all contacts of a block once.
struct Pass<'a, S> {
    subject: &'a S,
    block: &'a Block,
    table: &'a mut Table,
}

impl<S: Subject> Pass<'_, S> {
    #[inline(always)]
    fn asked_wide<L: Lanes, const HISTORY: usize>(self) {
        for at in (0..CONTACTS).step_by(L::COUNT) {
            let mut history = [L::splat(0.0); HISTORY];
            for (value, column) in history.iter_mut().zip(&self.table.history[..HISTORY]) {
                *value = L::load(&column[at..]);
            }
            let answers = self.subject.wide(self.block, at, &mut history);
            for (value, column) in history.iter().zip(&mut self.table.history[..HISTORY]) {
                value.store(&mut column[at..]);
            }
            for (value, column) in answers.into_iter().zip(&mut self.table.answers) {
                value.store(&mut column[at..]);
            }
        }
    }

    /// Asks for one contact after the other, each with its memory in one piece.
    #[inline(never)]
    fn one_by_one(self, memory: &mut [f64]) {
        let remembered = memory.len() / CONTACTS;
        for at in 0..CONTACTS {
            let history = &mut memory[at * remembered..][..remembered];
            let answers = self.subject.one(self.block, at, history);
            for (value, column) in answers.iter().zip(&mut self.table.answers) {
                column[at] = *value;
            }
        }
    }
}

impl<S: Subject> Kernel for Pass<'_, S> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self) {
        // as many as the law remembers, so that they stay in registers
        match self.table.history.len() {
            0 => self.asked_wide::<L, 0>(),
            1 => self.asked_wide::<L, 1>(),
            2 => self.asked_wide::<L, 2>(),
            3 => self.asked_wide::<L, 3>(),
            4 => self.asked_wide::<L, 4>(),
            _ => self.asked_wide::<L, MOST_HISTORY>(),
        }
    }
}

struct Bench<'a> {
    arguments: &'a Arguments,
    instructions: &'a [Instructions],
    info: &'a LawInfo,
    at_limits: bool,
}

impl Bench<'_> {
    fn measure(&self, subject: &impl Subject) {
        let forth = contacts(subject, self.info, self.at_limits);
        let blocks = [forth.back(), forth];
        let remembered = subject.remembered();
        let mut table = Table::new(remembered);
        let mut memory = vec![0.0; CONTACTS * remembered];
        let one_by_one = self.fastest(&blocks, |block| {
            let table = &mut table;
            Pass { subject, block, table }.one_by_one(&mut memory);
            black_box(&*table);
        });
        let wide: Vec<f64> = (self.instructions.iter())
            .map(|&instructions| {
                let mut table = Table::new(remembered);
                self.fastest(&blocks, |block| {
                    let table = &mut table;
                    run(instructions, Pass { subject, block, table });
                    black_box(&*table);
                })
            })
            .collect();
        let told: Vec<_> = wide.iter().map(|time| format!("{time:.1}")).collect();
        println!(
            "| `{}` | {} | {one_by_one:.1} | {} | {:.1} |",
            self.info.name,
            if self.at_limits { "half at limits" } else { "lasting" },
            told.join(" | "),
            one_by_one / wide[0],
        );
    }

    /// Time per contact of the fastest round [ns].
    fn fastest(&self, blocks: &[Block; 2], mut pass: impl FnMut(&Block)) -> f64 {
        let mut best = f64::INFINITY;
        for _ in 0..self.arguments.rounds {
            let begun = Instant::now();
            for repeat in 0..self.arguments.repeats {
                pass(black_box(&blocks[repeat % 2]));
            }
            let time = begun.elapsed().as_secs_f64() / (self.arguments.repeats * CONTACTS) as f64;
            best = best.min(time * 1e9);
        }
        best
    }
}

impl NormalVisitor for Bench<'_> {
    type Output = ();
    fn visit<N: Normal>(self, law: &N) {
        self.measure(&OfNormal(law));
    }
}

impl TangentialVisitor for Bench<'_> {
    type Output = ();
    fn visit<T: Tangential>(self, law: &T) {
        self.measure(&OfTangential(law));
    }
}

impl RollingVisitor for Bench<'_> {
    type Output = ();
    fn visit<R: Rolling>(self, law: &R) {
        self.measure(&OfRolling(law));
    }
}
