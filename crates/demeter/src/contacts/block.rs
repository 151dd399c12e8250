//! Contact laws, family by family, over blocks of contacts that stay in the cache.
//!
//! A block gathers the kinematics of its contacts, runs the normal, tangential and rolling laws over runs of contacts
//! of one material pair (one dispatch per run), and writes forces and torques.

use super::kinematics::{
    Approach, BLOCK, Block, Column, Gather, Partners, Surfaces, Write, first_bits, put_vectors, shift, vectors,
};
use super::laws::{normal_history, tangential_history};
use super::meetings::lanes_below;
use super::{ContactChunk, Load, Scene, Tally};
use demeter_physics::contact::normal::{Normal, NormalInput, NormalVisitor, centred_force};
use demeter_physics::contact::rolling::{Rolling, RollingInput, RollingVisitor};
use demeter_physics::contact::tangential::{Tangential, TangentialInput, TangentialVisitor};
use demeter_physics::contact::{PairLaw, PairSize};
use demeter_physics::integrator::Integrator;
use demeter_physics::lanes::{self, Instructions, Kernel, Lanes, MOST_LANES, Mask, Vector};
use std::ops::Range;

/// The most values that a law which works on all lanes remembers.
const MOST_WIDE_HISTORY: usize = 16;

/// The laws' view of a block of contacts of one material pair.
struct Run<'a> {
    dt: f64,
    integrator: Integrator,
    instructions: Instructions,
    law: &'a PairLaw,
    block: &'a mut Block,
    count: usize,
    /// History of all laws, and its length per contact.
    history: &'a mut [f64],
    stride: usize,
}

/// Half of the path of the overlap over which a normal law takes its mean [m].
#[inline(always)]
pub(crate) fn normal_window<N: Normal, L: Lanes>(integrator: Integrator, overlap: L, rate: L, dt: f64) -> L {
    if N::FOLLOWS_KINKS {
        rate.abs() * (0.5 * dt)
    } else {
        integrator.half_window(overlap, rate, dt)
    }
}

/// Where a law finds what it remembers.
struct Memory<'a> {
    /// History of all contacts of the block.
    values: &'a mut [f64],
    /// Values per contact.
    stride: usize,
    /// The first of this law.
    first: usize,
    /// How many there are of this law.
    length: usize,
}

impl Memory<'_> {
    /// What one contact remembers.
    #[inline(always)]
    fn of(&mut self, k: usize) -> &mut [f64] {
        let first = k * self.stride + self.first;
        &mut self.values[first..first + self.length]
    }

    /// What the contacts from `k` on remember, as lanes; those that do not act repeat one that does, so that no law takes
    /// them for new.
    #[inline(always)]
    fn load<L: Lanes>(&self, k: usize, acting: u32) -> [L; MOST_WIDE_HISTORY] {
        let mut lanes = [L::splat(0.0); MOST_WIDE_HISTORY];
        let first = self.stride * k + self.first;
        let one = first + self.stride * acting.trailing_zeros() as usize;
        let is_acting = L::Mask::of_bits(acting);
        let mut value = 0;
        if self.holds::<L>(k) {
            while value + 4 <= self.length {
                let mut columns = L::strided(self.values, first + value, self.stride);
                if acting != lanes_below(L::COUNT) {
                    let mut column = 0;
                    while column < 4 {
                        let other = L::splat(self.values[one + value + column]);
                        columns[column] = L::select(is_acting, columns[column], other);
                        column += 1;
                    }
                }
                lanes[value..value + 4].copy_from_slice(&columns);
                value += 4;
            }
        }
        let mut places = [0; MOST_LANES];
        let mut lane = 0;
        while lane < L::COUNT {
            let here = first + self.stride * lane;
            places[lane] = value + if acting >> lane & 1 != 0 { here } else { one };
            lane += 1;
        }
        while value < self.length {
            lanes[value] = L::gather(self.values, &places);
            shift(&mut places, 1);
            value += 1;
        }
        lanes
    }

    /// Whether there are as many contacts from `k` on as lanes.
    #[inline(always)]
    fn holds<L: Lanes>(&self, k: usize) -> bool {
        (k + L::COUNT) * self.stride <= self.values.len()
    }

    /// Puts back what the contacts from `k` on that act remember; the others remember nothing.
    #[inline(always)]
    fn store<L: Lanes>(&mut self, lanes: &[L; MOST_WIDE_HISTORY], k: usize, acting: u32) {
        let first = self.stride * k + self.first;
        let is_acting = L::Mask::of_bits(acting);
        let mut value = 0;
        if self.holds::<L>(k) {
            while value + 4 <= self.length {
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
        while value < self.length {
            let numbers = lanes[value].to_array();
            for (lane, number) in numbers.into_iter().enumerate() {
                if acting >> lane & 1 != 0 {
                    self.values[first + self.stride * lane + value] = number;
                }
            }
            value += 1;
        }
    }
}

/// One law asked for its answers over a block.
trait Pass {
    /// Whether the law works on all lanes at once.
    const WIDE: bool;
    /// Asks for the answers from contact `k` on.
    fn ask<L: Lanes>(&self, block: &mut Block, k: usize, history: &mut [L]);
}

/// A pass over the contacts of a block, with what its law remembers of them.
struct Over<'a, P> {
    pass: P,
    block: &'a mut Block,
    count: usize,
    memory: Memory<'a>,
}

/// More values than any law remembers.
const MOST_HISTORY: usize = 64;

impl<P: Pass> Over<'_, P> {
    /// One contact after the other.
    fn one_by_one(mut self) {
        let mut history = [0.0; MOST_HISTORY];
        let history = &mut history[..self.memory.length];
        for k in 0..self.count {
            if self.block.acts >> k & 1 == 0 {
                self.block.silence(k);
                continue;
            }
            history.copy_from_slice(self.memory.of(k));
            self.pass.ask::<f64>(self.block, k, history);
            self.memory.of(k).copy_from_slice(history);
        }
    }
}

impl<P: Pass> Kernel for Over<'_, P> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(mut self) {
        for k in (0..self.count).step_by(L::COUNT) {
            assert!(k <= BLOCK - L::COUNT);
            let acting = self.block.acting::<L>(k);
            if acting == 0 {
                (k..k + L::COUNT).for_each(|k| self.block.silence(k));
                continue;
            }
            let mut history = self.memory.load::<L>(k, acting);
            self.pass.ask(self.block, k, &mut history[..self.memory.length]);
            self.memory.store(&history, k, acting);
        }
    }
}

impl Run<'_> {
    /// Asks a law that remembers `length` values, from `first` on among those of its contact.
    fn ask<P: Pass>(&mut self, pass: P, first: usize, length: usize) {
        let over = Over {
            pass,
            block: self.block,
            count: self.count,
            memory: Memory {
                values: self.history,
                stride: self.stride,
                first,
                length,
            },
        };
        if P::WIDE {
            lanes::run(self.instructions, over);
        } else {
            over.one_by_one();
        }
    }
}

/// Effective sizes from contact `k` on.
#[inline(always)]
fn sizes<L: Lanes>(block: &Block, k: usize) -> PairSize<L> {
    PairSize {
        radius: L::load(&block.radius[k..]),
        mass: L::load(&block.mass[k..]),
    }
}

/// Normal forces with one law.
struct NormalForces<'a, N> {
    law: &'a N,
    dt: f64,
    integrator: Integrator,
}

impl<N: Normal> Pass for NormalForces<'_, N> {
    const WIDE: bool = N::WIDE;

    #[inline(always)]
    fn ask<L: Lanes>(&self, block: &mut Block, k: usize, history: &mut [L]) {
        let (law, dt) = (self.law, self.dt);
        let acting = L::Mask::of_bits(block.acting::<L>(k));
        let size = sizes::<L>(block, k);
        let (overlap, rate) = (L::load(&block.overlap[k..]), L::load(&block.rate[k..]));
        let input = NormalInput {
            size,
            overlap,
            rate,
            half_window: normal_window::<N, L>(self.integrator, overlap, rate, dt),
        };
        let response = law.respond_wide(&input, history);
        let (force, rate) = match self.integrator {
            Integrator::VelocityVerlet => centred_force(response, rate, L::load(&block.force[k..]), size.mass, dt),
            // the predicted rate is of high order already
            Integrator::Gear => ((response.elastic + response.damping * rate).max(response.least), rate),
        };
        force.keep(acting).store(&mut block.force[k..]);
        response.elastic.keep(acting).store(&mut block.elastic[k..]);
        (force + response.adhesion)
            .max(L::splat(0.0))
            .store(&mut block.friction_load[k..]);
        law.bearing_overlap_wide(size, overlap, history)
            .store(&mut block.bearing_overlap[k..]);
        // where the force is cut at its least, the spring relaxes into the dashpot without pulling
        let viscous = (force - response.elastic) * rate * dt;
        viscous.keep(acting).store(&mut block.loss[0][k..]);
        response.lost.keep(acting).store(&mut block.loss[1][k..]);
    }
}

struct NormalPass<'r, 'a>(&'r mut Run<'a>);

impl NormalVisitor for NormalPass<'_, '_> {
    type Output = ();

    fn visit<N: Normal>(self, law: &N) {
        let (dt, integrator) = (self.0.dt, self.0.integrator);
        self.0.ask(NormalForces { law, dt, integrator }, 0, law.history());
    }
}

/// Friction with one law.
struct Friction<'a, T> {
    law: &'a T,
    dt: f64,
    removable_share: f64,
}

impl<T: Tangential> Pass for Friction<'_, T> {
    const WIDE: bool = T::WIDE;

    #[inline(always)]
    fn ask<L: Lanes>(&self, block: &mut Block, k: usize, history: &mut [L]) {
        let input = TangentialInput {
            size: sizes::<L>(block, k),
            tangential_mass: L::load(&block.tangential_mass[k..]),
            overlap: L::load(&block.bearing_overlap[k..]),
            normal: vectors::<L>(&block.normal, k),
            velocity: vectors::<L>(&block.sliding, k),
            spin: L::load(&block.spin[k..]),
            normal_force: L::load(&block.friction_load[k..]),
            dt: self.dt,
            removable_share: self.removable_share,
        };
        let response = self.law.respond_wide(&input, history);
        let acting = L::Mask::of_bits(block.acting::<L>(k));
        put_vectors::<L>(response.force.or(acting, L::Vector::null()), &mut block.tangential, k);
        response.dissipated.keep(acting).store(&mut block.loss[0][k..]);
    }
}

struct TangentialPass<'r, 'a>(&'r mut Run<'a>);

impl TangentialVisitor for TangentialPass<'_, '_> {
    type Output = ();

    fn visit<T: Tangential>(self, law: &T) {
        let friction = Friction {
            law,
            dt: self.0.dt,
            removable_share: self.0.integrator.removable_share(),
        };
        self.0.ask(friction, normal_history(self.0.law), T::HISTORY.len());
    }
}

/// Rolling resistance with one law.
struct Resistance<'a, R> {
    law: &'a R,
    dt: f64,
    removable_share: f64,
    normal_stiffness: Column,
}

impl<R: Rolling> Pass for Resistance<'_, R> {
    const WIDE: bool = R::WIDE;

    #[inline(always)]
    fn ask<L: Lanes>(&self, block: &mut Block, k: usize, history: &mut [L]) {
        let input = RollingInput {
            size: sizes::<L>(block, k),
            rolling_inertia: L::load(&block.rolling_inertia[k..]),
            normal: vectors::<L>(&block.normal, k),
            angular_velocity: vectors::<L>(&block.rolling, k),
            spin: L::load(&block.spin[k..]),
            normal_force: L::load(&block.friction_load[k..]),
            normal_stiffness: L::load(&self.normal_stiffness[k..]),
            dt: self.dt,
            removable_share: self.removable_share,
        };
        let response = self.law.respond_wide(&input, history);
        let acting = L::Mask::of_bits(block.acting::<L>(k));
        put_vectors::<L>(response.torque.or(acting, L::Vector::null()), &mut block.torque, k);
        response.dissipated.keep(acting).store(&mut block.loss[0][k..]);
    }
}

struct RollingPass<'r, 'a>(&'r mut Run<'a>, Column);

impl RollingVisitor for RollingPass<'_, '_> {
    type Output = ();

    fn visit<R: Rolling>(self, law: &R) {
        let Self(run, normal_stiffness) = self;
        let resistance = Resistance {
            law,
            dt: run.dt,
            removable_share: run.integrator.removable_share(),
            normal_stiffness,
        };
        let first = normal_history(run.law) + tangential_history(run.law);
        run.ask(resistance, first, R::HISTORY.len());
    }
}

struct StiffnessPass<'r, 'a>(&'r Run<'a>);

impl NormalVisitor for StiffnessPass<'_, '_> {
    type Output = Column;

    fn visit<N: Normal>(self, law: &N) -> Column {
        let mut stiffness = [0.0; BLOCK];
        let (run, remembered) = (self.0, law.history());
        for (k, out) in stiffness.iter_mut().enumerate().take(run.count) {
            if run.block.acts >> k & 1 == 0 {
                continue;
            }
            let history = &run.history[k * run.stride..][..remembered];
            let size = PairSize {
                radius: run.block.radius[k],
                mass: run.block.mass[k],
            };
            // an attraction that fades with the gap has a negative slope: no spring against rolling is made of that
            *out = law.stiffness(size, run.block.overlap[k], history).max(0.0);
        }
        stiffness
    }
}

/// Sum in an order that no number of lanes changes.
fn sum(values: &[f64]) -> f64 {
    let mut sums = [0.0; MOST_LANES];
    for values in values.chunks(MOST_LANES) {
        for (sum, value) in sums.iter_mut().zip(values) {
            *sum += value;
        }
    }
    sums.iter().sum()
}

/// Runs the laws over the contacts of a block.
///
/// `losses`: where to put what every contact loses, by its normal law and by friction; empty where nobody asks.
fn run_laws(mut run: Run, tally: &mut Tally, losses: &mut [[f64; 2]]) {
    let (law, count) = (run.law, run.count);
    law.normal.visit(NormalPass(&mut run));
    tally.viscous += sum(&run.block.loss[0][..count]);
    tally.plastic += sum(&run.block.loss[1][..count]);
    for (k, lost) in losses.iter_mut().enumerate() {
        *lost = [run.block.loss[0][k] + run.block.loss[1][k], 0.0];
    }
    if let Some(friction) = &law.tangential {
        friction.visit(TangentialPass(&mut run));
        tally.friction += sum(&run.block.loss[0][..count]);
        for (k, lost) in losses.iter_mut().enumerate() {
            lost[1] = run.block.loss[0][k];
        }
    } else {
        run.block.tangential = [[0.0; BLOCK]; 3];
    }
    if let Some(resistance) = &law.rolling {
        let stiffness = law.normal.visit(StiffnessPass(&run));
        resistance.visit(RollingPass(&mut run, stiffness));
        tally.rolling += sum(&run.block.loss[0][..count]);
    } else {
        run.block.torque = [[0.0; BLOCK]; 3];
    }
}

impl ContactChunk {
    /// Finds which contacts between grains act in this step, and evaluates their laws.
    pub(crate) fn meet_pairs(&mut self, scene: &Scene) {
        self.evaluate(scene, |chunk, contacts, block| {
            let approach = Approach {
                block,
                scene,
                count: contacts.len(),
                i: &chunk.i[contacts.start..],
                j: &chunk.j[contacts.start..],
                shift: chunk.shift.get(contacts.start..).unwrap_or_default(),
            };
            let too_deep = lanes::run(scene.instructions, approach);
            if let Some(k) = too_deep {
                chunk.note_overlap(contacts.start + k, block.overlap[k], scene);
            }
            chunk.engaged.resize(contacts.start / BLOCK + 1, 0);
            chunk.engaged[contacts.start / BLOCK] = block.acts;
            let mut idle = !block.acts & first_bits(contacts.len());
            while idle != 0 {
                chunk.end(contacts.start + idle.trailing_zeros() as usize, scene);
                idle &= idle - 1;
            }
        });
    }

    /// Evaluates the laws of all contacts between grains whose geometry is known.
    pub(crate) fn evaluate_pairs(&mut self, scene: &Scene) {
        self.evaluate(scene, |chunk, contacts, block| {
            let partners = Partners::grains(scene.grains, &chunk.j[contacts.clone()]);
            chunk.gather(contacts, partners, block, scene);
        });
    }

    /// Evaluates the laws of all contacts with walls, and sums up what the walls feel.
    pub(crate) fn evaluate_walls(&mut self, scene: &Scene) {
        if scene.records_walls {
            self.losses.clear();
            self.losses.resize(self.len(), [0.0; 2]);
        }
        self.evaluate(scene, |chunk, contacts, block| {
            let (i, j) = (&chunk.i[contacts.clone()], &chunk.j[contacts.clone()]);
            let geometry = &chunk.now.geometry[contacts.clone()];
            let surfaces = Surfaces::new(geometry, i, j, scene.grains, scene.walls);
            let partners = Partners::walls(&surfaces, contacts.len());
            chunk.gather(contacts, partners, block, scene);
        });
        for k in 0..self.len() {
            let wall = &scene.walls[self.j[k] as usize];
            let contact = &self.now.geometry[k];
            let point = scene.grains.position[self.i[k] as usize] - contact.normal * contact.lever_i;
            let (force, torque) = (-self.force(k), self.torque_j(k));
            self.tally.wall_work -=
                scene.dt * (force.dot(wall.velocity_at(point)) + torque.dot(wall.angular_velocity()));
            let load = &mut self.wall_load[self.j[k] as usize];
            load.0 += force;
            load.1 += (point - wall.origin()).cross(force) + torque;
        }
        if scene.records_walls {
            self.mark_walls(scene);
        }
    }

    fn gather(&self, contacts: Range<usize>, partners: Partners, block: &mut Block, scene: &Scene) {
        let gather = Gather {
            block,
            contacts: &self.now.geometry[contacts.clone()],
            grains: scene.grains,
            i: &self.i[contacts],
            partners,
            rolling: scene.resists_rolling,
        };
        lanes::run(scene.instructions, gather);
    }

    /// Has what will be known of some contacts fetched, as memory is slow.
    fn prefetch(&self, contacts: Range<usize>, stride: usize) {
        lanes::prefetch_all(&self.now.history[contacts.start * stride..contacts.end * stride]);
        lanes::prefetch_all(&self.now.normal_force[contacts.clone()]);
        lanes::prefetch_all(&self.load[contacts.start + 1..contacts.end + 1]);
    }

    fn evaluate(&mut self, scene: &Scene, gather: impl Fn(&mut Self, Range<usize>, &mut Block)) {
        let count = self.len();
        self.load.resize(count + 1, Load::default());
        self.load[0] = Load::default();
        if scene.resists_rolling {
            self.rolling.resize(count + 1, [0.0; 4]);
        }
        let mut block = Block::EMPTY;
        let mut first = 0;
        while first < count {
            let contacts = first..(first + BLOCK).min(count);
            self.prefetch(contacts.end..(contacts.end + BLOCK).min(count), scene.stride);
            gather(self, contacts.clone(), &mut block);
            let length = contacts.len();
            block.force[..length].copy_from_slice(&self.now.normal_force[contacts.clone()]);
            let laws = Run {
                dt: scene.dt,
                integrator: scene.integrator,
                instructions: scene.instructions,
                law: scene.materials.law(self.law),
                block: &mut block,
                count: length,
                history: &mut self.now.history[contacts.start * scene.stride..contacts.end * scene.stride],
                stride: scene.stride,
            };
            let losses = self.losses.get_mut(contacts.clone()).unwrap_or_default();
            run_laws(laws, &mut self.tally, losses);
            self.now.normal_force[contacts.clone()].copy_from_slice(&block.force[..length]);
            let write = Write {
                block: &block,
                loads: &mut self.load[contacts.start + 1..contacts.end + 1],
            };
            lanes::run(scene.instructions, write);
            if scene.resists_rolling {
                let [x, y, z] = &block.torque;
                for (k, torque) in self.rolling[contacts.start + 1..contacts.end + 1]
                    .iter_mut()
                    .enumerate()
                {
                    *torque = [x[k], y[k], z[k], 0.0];
                }
            }
            if scene.is_coupled() {
                self.remember_coupling(first, &block.elastic[..length], scene);
            }
            first = contacts.end;
        }
    }
}
