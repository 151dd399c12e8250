//! What is asked of the laws of a material pair beside their forces.

use crate::materials::Materials;
use demeter_physics::contact::normal::{Normal, NormalVisitor};
use demeter_physics::contact::rolling::{Rolling, RollingVisitor};
use demeter_physics::contact::tangential::{Tangential, TangentialVisitor};
use demeter_physics::contact::{PairLaw, PairSize};

/// Number of history values of the normal law of a pair; they come first.
pub(super) fn normal_history(law: &PairLaw) -> usize {
    struct Length;
    impl NormalVisitor for Length {
        type Output = usize;
        fn visit<L: Normal>(self, law: &L) -> usize {
            law.history()
        }
    }
    law.normal.visit(Length)
}

/// Number of history values of the tangential law; they come next, then those of the rolling law.
pub(super) fn tangential_history(law: &PairLaw) -> usize {
    law.tangential.map_or(0, |t| t.info().history)
}

/// Names of the normal, the tangential and the rolling law of a pair as far as contacts remember something for them, and how many values.
pub fn memories(law: &PairLaw) -> [Option<(&'static str, usize)>; 3] {
    let normal = Some((law.normal.info().name, normal_history(law)));
    let others = [law.tangential.map(|law| law.info()), law.rolling.map(|law| law.info())];
    let [tangential, rolling] = others.map(|law| law.map(|law| (law.name, law.history)));
    [normal, tangential, rolling].map(|law| law.filter(|(_, values)| *values > 0))
}

/// Number of history values of the laws of one pair.
pub fn history_length(law: &PairLaw) -> usize {
    normal_history(law) + tangential_history(law) + law.rolling.map_or(0, |r| r.info().history)
}

/// Largest number of history values of any pair.
pub fn stride(materials: &Materials) -> usize {
    let count = materials.list().len() as u16;
    let pairs = (0..count).flat_map(|a| (0..count).map(move |b| (a, b)));
    pairs
        .map(|(a, b)| history_length(materials.law(materials.pair(a, b))))
        .max()
        .unwrap_or(0)
}

/// Whether some pair resists rolling.
pub fn resists_rolling(materials: &Materials) -> bool {
    let count = materials.list().len() as u16;
    let mut pairs = (0..count).flat_map(|a| (0..count).map(move |b| (a, b)));
    pairs.any(|(a, b)| materials.law(materials.pair(a, b)).rolling.is_some())
}

/// Energy stored in the tangential and in the rolling spring of a contact with this history [J].
pub fn spring_energies(law: &PairLaw, history: &[f64]) -> (f64, f64) {
    struct Stored<'a>(&'a [f64]);
    impl TangentialVisitor for Stored<'_> {
        type Output = f64;
        fn visit<L: Tangential>(self, law: &L) -> f64 {
            law.energy(&self.0[..L::HISTORY.len()])
        }
    }
    impl RollingVisitor for Stored<'_> {
        type Output = f64;
        fn visit<L: Rolling>(self, law: &L) -> f64 {
            law.energy(&self.0[..L::HISTORY.len()])
        }
    }
    let tangential = &history[normal_history(law)..];
    let rolling = &tangential[tangential_history(law)..];
    (
        law.tangential.map_or(0.0, |t| t.visit(Stored(tangential))),
        law.rolling.map_or(0.0, |r| r.visit(Stored(rolling))),
    )
}

/// Largest force that friction bears before a contact slides as a whole [N].
pub fn friction_limit(law: &PairLaw, load: f64) -> f64 {
    struct Limit(f64);
    impl TangentialVisitor for Limit {
        type Output = f64;
        fn visit<L: Tangential>(self, law: &L) -> f64 {
            law.limit(self.0)
        }
    }
    law.tangential.map_or(0.0, |t| t.visit(Limit(load)))
}

/// Energy stored by the normal law of a contact between bodies of these sizes [J].
pub fn normal_energy(law: &PairLaw, size: PairSize, overlap: f64, history: &[f64]) -> f64 {
    struct Stored<'a>(PairSize, f64, &'a [f64]);
    impl NormalVisitor for Stored<'_> {
        type Output = f64;
        fn visit<L: Normal>(self, law: &L) -> f64 {
            law.energy(self.0, self.1, &self.2[..law.history()])
        }
    }
    law.normal.visit(Stored(size, overlap, history))
}

/// Brings what a contact of these sizes remembers in line with a law whose parameters were others when it was written.
pub fn adopt(law: &PairLaw, size: PairSize, history: &mut [f64]) {
    struct Adopt<'a>(PairSize, &'a mut [f64]);
    impl NormalVisitor for Adopt<'_> {
        type Output = ();
        fn visit<L: Normal>(self, law: &L) {
            law.adopt(self.0, &mut self.1[..law.history()]);
        }
    }
    law.normal.visit(Adopt(size, history));
}

/// Largest gap across which the normal law acts between bodies of these sizes [m].
pub fn largest_reach(law: &PairLaw, size: PairSize) -> f64 {
    struct Reach(PairSize);
    impl NormalVisitor for Reach {
        type Output = f64;
        fn visit<L: Normal>(self, law: &L) -> f64 {
            law.largest_reach(self.0)
        }
    }
    law.normal.visit(Reach(size))
}
