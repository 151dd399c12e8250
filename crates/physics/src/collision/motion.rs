//! The motion of two bodies beyond the moment at which they are known to stick.

use super::head_on::{Course, HeadOn, Pair};
use super::outcome::{CollisionError, Tolerance, positive};
use super::record::{Moment, check_moments, moments};
use crate::contact::normal::{Normal, NormalLaw, NormalVisitor};

impl<L: Normal> HeadOn<'_, L> {
    /// So many moments at equal distances in time, from the start through every reversal up to a duration [s], or up to
    /// rest or the end of contact when that comes first.
    pub fn follow(&self, tolerance: &Tolerance, duration: f64, count: usize) -> Result<Vec<Moment>, CollisionError> {
        positive("duration", duration)?;
        check_moments(count)?;
        let pair = Pair {
            law: self.law,
            size: self.size,
        };
        let mut course = Course::new(&pair, self, tolerance)?;
        course.follow(duration)?;
        Ok(moments(&course.records, &pair, count))
    }
}

/// The motion under any law.
struct Follow<'a>(&'a HeadOn<'a, NormalLaw>, &'a Tolerance, f64, usize);

impl NormalVisitor for Follow<'_> {
    type Output = Result<Vec<Moment>, CollisionError>;

    fn visit<L: Normal>(self, law: &L) -> Self::Output {
        let HeadOn { size, speed, start, .. } = *self.0;
        let impact = HeadOn {
            law,
            size,
            speed,
            start,
        };
        impact.follow(self.1, self.2, self.3)
    }
}

impl HeadOn<'_, NormalLaw> {
    /// See the method of the same name for a law that is known.
    pub fn follow(&self, tolerance: &Tolerance, duration: f64, count: usize) -> Result<Vec<Moment>, CollisionError> {
        self.law.visit(Follow(self, tolerance, duration, count))
    }
}

#[cfg(test)]
mod tests {
    use super::super::Start;
    use super::*;
    use crate::contact::normal::hertz_tsuji::HertzTsuji;
    use crate::contact::normal::tomas::Tomas;
    use crate::contact::{Elastic, MaterialPair, PairSize};
    use crate::parameters::values;

    const STONE: Elastic = Elastic {
        young_modulus: 150e9,
        poisson_ratio: 0.28,
    };
    const PAIR: MaterialPair = MaterialPair { a: STONE, b: STONE };
    const SIZE: PairSize = PairSize::new(0.3e-6, 2.479e-15);

    #[test]
    fn bodies_that_stick_swing_to_rest_where_nothing_pushes_or_pulls() {
        let parameters = [
            ("adhesion_force", 2.64e-9),
            ("separation", 0.336e-9),
            ("micro_yield_strength", 300e6),
            ("kappa_p", 0.153),
            ("alpha", 0.2),
        ];
        let law = Tomas::new(&values(&parameters), &PAIR).unwrap();
        let impact = HeadOn {
            law: &law,
            size: SIZE,
            speed: 1e-3,
            start: Start::Contact,
        };
        let tolerance = Tolerance::default();
        let stuck = impact.run(&tolerance).unwrap();
        let moments = impact.follow(&tolerance, 100.0 * stuck.duration, 20_000).unwrap();
        let last = moments[moments.len() - 1];
        // up to the second reversal it is the same motion
        let deepest = moments.iter().map(|m| m.overlap).fold(0.0, f64::max);
        assert!((deepest - stuck.max_overlap).abs() < 1e-4 * stuck.max_overlap);
        let reversals = moments.windows(2).filter(|w| w[0].rate * w[1].rate < 0.0).count();
        assert!(reversals > 20, "{reversals}");
        assert!(
            last.rate.abs() < 1e-6 * impact.speed && last.force.abs() < 1e-5 * 2.64e-9,
            "{last:?}"
        );
        // every swing is smaller than the one before
        let mut turns = moments
            .windows(3)
            .filter(|w| w[1].overlap > w[0].overlap && w[1].overlap >= w[2].overlap);
        let mut before = turns.next().unwrap()[1].overlap;
        for turn in turns {
            assert!(turn[1].overlap < before * (1.0 + 1e-9), "{turn:?}");
            before = turn[1].overlap;
        }
    }

    #[test]
    fn it_ends_with_contact_or_with_the_duration() {
        let law = HertzTsuji::new(&values(&[("restitution", 0.5)]), &PAIR).unwrap();
        let impact = HeadOn {
            law: &law,
            size: SIZE,
            speed: 1.0,
            start: Start::Contact,
        };
        let tolerance = Tolerance::default();
        let whole = impact.run(&tolerance).unwrap();
        let moments = impact.follow(&tolerance, 10.0 * whole.duration, 50).unwrap();
        assert!((moments[49].time - whole.duration).abs() < 1e-9 * whole.duration);
        assert!((moments[49].rate + 0.5).abs() < 1e-9);
        let half = impact.follow(&tolerance, 0.5 * whole.duration, 50).unwrap();
        assert!((half[49].time - 0.5 * whole.duration).abs() < 1e-12 * whole.duration);
        assert!(impact.follow(&tolerance, f64::NAN, 5).is_err());
    }
}
