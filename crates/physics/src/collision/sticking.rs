//! The critical sticking speed: below it two bodies stick, above it they part.

use super::head_on::HeadOn;
use super::outcome::{Collision, CollisionError, Outcome, Start, Tolerance};
use crate::contact::PairSize;
use crate::contact::normal::{Normal, NormalLaw, NormalVisitor};

/// What is known of the speeds at which two bodies stick.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Sticking {
    /// They stick below this speed [m/s].
    Below(f64),
    /// They part at every speed, down to the one told [m/s].
    Never(f64),
    /// They stick at every speed, up to the one told [m/s], at which they would overlap by their effective radius.
    Always(f64),
}

/// Relative width to which the critical speed is bracketed.
pub const BRACKET: f64 = 1e-7;

/// Factor between the speeds that are tried in search of a bracket.
const STRIDE: f64 = 4.0;

/// Bodies that part at this share of the first speed tried, or of the largest speed on the way, part at every speed: below it, rounding
/// decides. What attracts may make them so fast that the energy they began with is lost in the rounding of that on the way.
const NOTHING: f64 = 1e-7;

/// The range of speeds that is searched, as power of [`STRIDE`] below and above the first one tried.
const MOST_STRIDES: i32 = 40;

/// Critical sticking speed of two bodies under a law by name; see [`sticking_speed`].
pub fn sticking_speed_of(
    law: &NormalLaw,
    size: PairSize,
    start: Start,
    tolerance: &Tolerance,
) -> Result<Sticking, CollisionError> {
    struct Search<'a>(PairSize, Start, &'a Tolerance);
    impl NormalVisitor for Search<'_> {
        type Output = Result<Sticking, CollisionError>;
        fn visit<L: Normal>(self, law: &L) -> Self::Output {
            sticking_speed(law, self.0, self.1, self.2)
        }
    }
    law.visit(Search(size, start, tolerance))
}

/// Critical sticking speed of two bodies. Where there are several, as laws whose force jumps may have, it is one of
/// them.
pub fn sticking_speed<L: Normal>(
    law: &L,
    size: PairSize,
    start: Start,
    tolerance: &Tolerance,
) -> Result<Sticking, CollisionError> {
    let collide = |speed: f64| {
        let impact = HeadOn {
            law,
            size,
            speed,
            start,
        };
        impact.run(tolerance)
    };
    let sticks = |collision: &Collision| collision.outcome == Outcome::Stick;
    // the speed that makes a dent of a millionth of the radius in the time scale of such a collision
    let overlap = 1e-6 * size.radius;
    let first = overlap / law.collision_time(size, overlap);
    let mut speed = first;
    let mut collision = collide(speed)?;
    let stuck_first = sticks(&collision);
    let (mut stuck, mut parted) = (speed, speed);
    for stride in 0.. {
        let next = if stuck_first { speed * STRIDE } else { speed / STRIDE };
        if !stuck_first && next < NOTHING * first.max(collision.max_speed) {
            return Ok(Sticking::Never(speed));
        }
        collision = collide(next)?;
        if sticks(&collision) != stuck_first {
            (stuck, parted) = if stuck_first { (speed, next) } else { (next, speed) };
            break;
        }
        speed = next;
        if stuck_first && (collision.max_overlap > size.radius || stride == MOST_STRIDES) {
            return Ok(Sticking::Always(speed));
        }
    }
    while parted > stuck * (1.0 + BRACKET) {
        let middle = (stuck * parted).sqrt();
        if sticks(&collide(middle)?) {
            stuck = middle;
        } else {
            parted = middle;
        }
    }
    Ok(Sticking::Below((stuck * parted).sqrt()))
}
