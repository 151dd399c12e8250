//! Laws that many runs have together: compiled as one, so that what is known of one is at hand for the other, and nothing is chosen
//! within the loop over contacts, which takes two registers at a time if there are enough. All others are chosen by every lot of contacts.

use super::Tally;
use super::asking::{Ahead, Lot, Press, Pressed, Roll, Rub, Stiffness};
use super::kinematics::Source;
use super::respond::Respond;
use super::sum::Sink;
use demeter_physics::contact::PairLaw;
use demeter_physics::contact::normal::{Normal, NormalLaw, NormalVisitor};
use demeter_physics::contact::rolling::{Rolling, RollingLaw, RollingResponse, RollingVisitor};
use demeter_physics::contact::tangential::{Tangential, TangentialLaw, TangentialResponse, TangentialVisitor};
use demeter_physics::lanes::{Instructions, Lanes, Vector};
#[cfg(not(test))]
use demeter_physics::lanes::{run, run_on_two};
#[cfg(test)]
use portably::{run, run_on_two};

/// The laws of a material pair, as contacts ask them.
pub(super) trait Laws: Copy {
    /// Whether there is friction.
    fn rubs(self) -> bool;
    /// Whether rolling is resisted.
    fn rolls(self) -> bool;
    /// Normal forces.
    fn press<L: Lanes>(self, ask: Press<L>) -> Pressed<L>;
    /// What is known of friction before the normal force is, told the normal and by which angle the contact turns about it; perhaps
    /// nothing.
    #[inline(always)]
    fn ahead<L: Lanes>(self, _lot: &Lot, _normal: L::Vector, _spin_angle: L) -> Option<Ahead<L>> {
        None
    }
    /// Friction; no force where there is none.
    fn rub<L: Lanes>(self, ask: Rub<L>) -> TangentialResponse<L>;
    /// Tangent stiffness of the normal law.
    fn stiffness<L: Lanes>(self, ask: Stiffness<L>) -> L;
    /// Resistance to rolling; no torque where there is none.
    fn roll<L: Lanes>(self, ask: Roll<L>) -> RollingResponse<L>;
}

impl Laws for &PairLaw {
    #[inline(always)]
    fn rubs(self) -> bool {
        self.tangential.is_some()
    }

    #[inline(always)]
    fn rolls(self) -> bool {
        self.rolling.is_some()
    }

    #[inline(always)]
    fn press<L: Lanes>(self, ask: Press<L>) -> Pressed<L> {
        self.normal.visit(ask)
    }

    #[inline(always)]
    fn rub<L: Lanes>(self, ask: Rub<L>) -> TangentialResponse<L> {
        match &self.tangential {
            Some(law) => law.visit(ask),
            None => TangentialResponse {
                force: L::Vector::null(),
                dissipated: L::splat(0.0),
            },
        }
    }

    #[inline(always)]
    fn stiffness<L: Lanes>(self, ask: Stiffness<L>) -> L {
        self.normal.visit(ask)
    }

    #[inline(always)]
    fn roll<L: Lanes>(self, ask: Roll<L>) -> RollingResponse<L> {
        match &self.rolling {
            Some(law) => law.visit(ask),
            None => ().roll(ask),
        }
    }
}

/// What resists rolling: a law, or nothing.
trait Resists: Copy {
    /// Whether anything does.
    const ROLLS: bool;
    /// Resistance to rolling; no torque where there is none.
    fn roll<L: Lanes>(self, ask: Roll<L>) -> RollingResponse<L>;
}

impl Resists for () {
    const ROLLS: bool = false;

    #[inline(always)]
    fn roll<L: Lanes>(self, _ask: Roll<L>) -> RollingResponse<L> {
        RollingResponse {
            torque: L::Vector::null(),
            dissipated: L::splat(0.0),
        }
    }
}

impl<R: Rolling> Resists for &R {
    const ROLLS: bool = true;

    #[inline(always)]
    fn roll<L: Lanes>(self, ask: Roll<L>) -> RollingResponse<L> {
        RollingVisitor::visit(ask, self)
    }
}

/// A normal law, friction, and what resists rolling.
struct Bound<'a, N, T, R>(&'a N, &'a T, R);

impl<N, T, R: Copy> Clone for Bound<'_, N, T, R> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<N, T, R: Copy> Copy for Bound<'_, N, T, R> {}

impl<N: Normal, T: Tangential, R: Resists> Laws for Bound<'_, N, T, R> {
    #[inline(always)]
    fn rubs(self) -> bool {
        true
    }

    #[inline(always)]
    fn rolls(self) -> bool {
        R::ROLLS
    }

    #[inline(always)]
    fn press<L: Lanes>(self, ask: Press<L>) -> Pressed<L> {
        NormalVisitor::visit(ask, self.0)
    }

    #[inline(always)]
    fn ahead<L: Lanes>(self, lot: &Lot, normal: L::Vector, spin_angle: L) -> Option<Ahead<L>> {
        Ahead::of::<T>(lot, normal, spin_angle)
    }

    #[inline(always)]
    fn rub<L: Lanes>(self, ask: Rub<L>) -> TangentialResponse<L> {
        TangentialVisitor::visit(ask, self.1)
    }

    #[inline(always)]
    fn stiffness<L: Lanes>(self, ask: Stiffness<L>) -> L {
        NormalVisitor::visit(ask, self.0)
    }

    #[inline(always)]
    fn roll<L: Lanes>(self, ask: Roll<L>) -> RollingResponse<L> {
        self.2.roll(ask)
    }
}

/// Asks laws that run together.
fn run_bound<S: Source, K: Sink, W: Laws>(
    instructions: Instructions,
    respond: Respond<S, K, W>,
) -> (Tally, Option<(usize, f64)>) {
    if S::ARE_MANY {
        run_on_two(instructions, respond)
    } else {
        run(instructions, respond)
    }
}

/// Asks the laws of a material pair about contacts: what was lost, and the first contact with too much overlap.
pub(super) fn ask<S: Source, K: Sink>(
    instructions: Instructions,
    respond: Respond<S, K, ()>,
) -> (Tally, Option<(usize, f64)>) {
    let law = respond.law;
    use NormalLaw::{HertzTsuji, Linear};
    use RollingLaw::{ConstantTorque, Epsd};
    use TangentialLaw::{Coulomb, LinearHistory, MindlinHistory};
    if let (HertzTsuji(n), Some(MindlinHistory(t)), None) = (&law.normal, &law.tangential, &law.rolling) {
        return run_bound(instructions, respond.with(Bound(n, t, ())));
    }
    if S::TOGETHER {
        match (&law.normal, &law.tangential, &law.rolling) {
            (HertzTsuji(n), Some(Coulomb(t)), None) => return run_bound(instructions, respond.with(Bound(n, t, ()))),
            (Linear(n), Some(LinearHistory(t)), None) => return run_bound(instructions, respond.with(Bound(n, t, ()))),
            (Linear(n), Some(Coulomb(t)), None) => return run_bound(instructions, respond.with(Bound(n, t, ()))),
            // a register at a time: two were not measured with three laws
            (HertzTsuji(n), Some(MindlinHistory(t)), Some(Epsd(r))) if S::ARE_MANY => {
                return run(instructions, respond.with(Bound(n, t, r)));
            }
            (HertzTsuji(n), Some(MindlinHistory(t)), Some(ConstantTorque(r))) if S::ARE_MANY => {
                return run(instructions, respond.with(Bound(n, t, r)));
            }
            _ => {}
        }
    }
    run(instructions, respond.with(law))
}

/// Tests within the crate ask laws portably: all laws for all instructions take minutes to compile. `tests/invariants` and the conformance
/// tests of the laws have the same bits from all instructions.
#[cfg(test)]
mod portably {
    pub use demeter_physics::lanes::{Instructions, Kernel};
    pub use run as run_on_two;

    pub fn run<K: Kernel>(_: Instructions, kernel: K) -> K::Output {
        kernel.run::<f64>()
    }
}
