//! Contacts that end where the total force is zero, against the closed forms: raw damping, over-damped, too.

use super::*;
use crate::contact::normal::{Normal, NormalInput, NormalResponse};
use crate::contact::{MaterialPair, PairSize};
use crate::dimension::Dimension;
use crate::parameters::{ParameterError, ParameterInfo, Values};
use approx::assert_relative_eq;

/// Spring and dashpot of unit stiffness that never pull; `ratio` is the damping over the critical one.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Pushing {
    hertz: bool,
    ratio: f64,
}

impl Normal for Pushing {
    const NAME: &'static str = "pushing";
    const SUMMARY: &'static str = "";
    const DOC: &'static str = "";
    const PARAMETERS: &'static [ParameterInfo] = &[];
    const HISTORY: &'static [Dimension] = &[];

    fn new(_: &Values, _: &MaterialPair) -> Result<Self, Vec<ParameterError>> {
        Err(vec![])
    }

    fn respond(&self, input: &NormalInput, _: &mut [f64]) -> NormalResponse {
        let d = input.overlap.max(0.0);
        let (force, share) = if self.hertz {
            (d * d.sqrt(), 5f64.sqrt() * d.sqrt().sqrt())
        } else {
            (d, 2.0)
        };
        NormalResponse {
            least: 0.0,
            ..NormalResponse::spring_dashpot(input, force, share * self.ratio * input.size.mass.sqrt())
        }
    }

    fn energy(&self, size: PairSize, overlap: f64, history: &[f64]) -> f64 {
        let force = self
            .respond(&NormalInput::at(size, overlap, 0.0), &mut history.to_vec())
            .elastic;
        let share = if self.hertz { 0.4 } else { 0.5 };
        share * force * overlap
    }

    fn stiffness(&self, _: PairSize, overlap: f64, _: &[f64]) -> f64 {
        if self.hertz { 1.5 * overlap.max(0.0).sqrt() } else { 1.0 }
    }

    fn collision_time(&self, size: PairSize, _: f64) -> f64 {
        3.0 * size.mass.sqrt()
    }
}

fn run(hertz: bool, ratio: f64) -> Collision {
    let impact = HeadOn {
        law: &Pushing { hertz, ratio },
        size: PairSize::new(1.0, 1.0),
        speed: 1.0,
        start: Start::Contact,
    };
    impact.run(&Tolerance::default()).unwrap()
}

#[test]
fn restitution_and_duration_at_zero_force() {
    for ratio in [0.05, 0.3, 0.9, 1.0, 1.0001, 1.5, 4.0] {
        let (restitution, duration) = if ratio < 1.0 {
            let c = libm::acos(ratio);
            (libm::exp(-2.0 * c * ratio / libm::sin(c)), 2.0 * c / libm::sin(c))
        } else if ratio == 1.0 {
            (libm::exp(-2.0), 2.0)
        } else {
            let n = libm::acosh(ratio);
            (libm::exp(-2.0 * n * ratio / libm::sinh(n)), 2.0 * n / libm::sinh(n))
        };
        for hertz in [false, true] {
            let found = run(hertz, ratio);
            assert_eq!(found.outcome, Outcome::Rebound);
            assert_relative_eq!(found.restitution, restitution, max_relative = 1e-9);
            let energy = found.energy;
            assert!(energy.lost.abs() < 1e-11 && energy.stored_after == 0.0, "{energy:?}");
            assert_relative_eq!(
                energy.viscous,
                0.5 * (1.0 - restitution * restitution),
                max_relative = 1e-9
            );
            if !hertz {
                assert_relative_eq!(found.duration, duration, max_relative = 1e-9);
                // the dashpot jumps to its force at first touch
                assert!(found.max_force >= 2.0 * ratio * (1.0 - 1e-12));
            }
        }
    }
    // reference durations of the Hertzian contact: requested eps 0.1, 0.54, 0.9 of the zero-overlap formula
    for (alpha, restitution, duration) in [
        (1.3218628408, 0.2527293796, 2.53591828),
        (0.4303779787, 0.5826257310, 2.89241253),
        (0.0749495307, 0.9020260687, 3.12510775),
    ] {
        let found = run(true, alpha / 5f64.sqrt());
        assert_relative_eq!(found.restitution, restitution, max_relative = 1e-8);
        assert_relative_eq!(found.duration, duration, max_relative = 1e-8);
    }
}
