//! The critical sticking speed: below it two bodies stick, above it they part.

use super::head_on::HeadOn;
use super::outcome::{Collision, CollisionError, Outcome, Start, Tolerance, check_size};
use crate::contact::PairSize;
use crate::contact::normal::{Normal, NormalLaw, NormalVisitor};

/// What is known of the speeds at which two bodies stick.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Sticking {
    /// They stick below this speed [m/s].
    Below(f64),
    /// They part at every speed that was tried, from the one told [m/s] to that at which they would overlap by their effective radius.
    Never(f64),
    /// They part at low speeds, down to one [m/s], and stick from another on, up to some higher one.
    From {
        /// The lowest speed that was tried [m/s].
        parting: f64,
        /// The speed at which sticking begins [m/s].
        speed: f64,
    },
    /// They stick at every speed, up to the one told [m/s], at which they would overlap by their effective radius.
    Always(f64),
}

impl Sticking {
    /// The speed below which they stick [m/s]; where there is none, the lowest or highest that was tried.
    pub fn below(self) -> f64 {
        match self {
            Self::Below(speed) | Self::Never(speed) | Self::Always(speed) | Self::From { parting: speed, .. } => speed,
        }
    }
}

/// Relative width to which the critical speed is bracketed.
pub const BRACKET: f64 = 1e-7;

/// Factor between the speeds that are tried in search of a bracket.
const STRIDE: f64 = 4.0;

/// Factor between the speeds at which sticking is looked for above those at which bodies part.
const UPWARDS: f64 = 1.5;

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
/// them. Where they part at low speeds, speeds above are tried in strides of a factor 1.5: laws whose adhesion grows with the dent
/// may have a range of speeds at which they stick.
pub fn sticking_speed<L: Normal>(
    law: &L,
    size: PairSize,
    start: Start,
    tolerance: &Tolerance,
) -> Result<Sticking, CollisionError> {
    check_size(size)?;
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
    let mut strides = 0;
    let (stuck, parted) = loop {
        let next = if stuck_first { speed * STRIDE } else { speed / STRIDE };
        if !stuck_first && next < NOTHING * first.max(collision.max_speed) {
            let parting = speed;
            let Some((last_parting, sticking)) = first_sticking(first, size.radius, collide)? else {
                return Ok(Sticking::Never(parting));
            };
            let speed = narrow(last_parting, sticking, |speed| Ok(!sticks(&collide(speed)?)))?;
            return Ok(Sticking::From { parting, speed });
        }
        collision = collide(next)?;
        if sticks(&collision) != stuck_first {
            break if stuck_first { (speed, next) } else { (next, speed) };
        }
        speed = next;
        if stuck_first && (collision.max_overlap > size.radius || strides == MOST_STRIDES) {
            return Ok(Sticking::Always(speed));
        }
        strides += 1;
    };
    narrow(stuck, parted, |speed| Ok(sticks(&collide(speed)?))).map(Sticking::Below)
}

/// A speed at which bodies part and the next one that was tried, at which they stick, from a first speed on to that at which they overlap by
/// so much.
fn first_sticking(
    first: f64,
    most: f64,
    collide: impl Fn(f64) -> Result<Collision, CollisionError>,
) -> Result<Option<(f64, f64)>, CollisionError> {
    let mut parting = first;
    for _ in 0..MOST_STRIDES {
        let next = parting * UPWARDS;
        let collision = collide(next)?;
        if collision.outcome == Outcome::Stick {
            return Ok(Some((parting, next)));
        }
        if collision.max_overlap > most {
            break;
        }
        parting = next;
    }
    Ok(None)
}

/// The speed between a lower one, at which something holds, and a higher one, at which it does not.
fn narrow(
    mut lower: f64,
    mut higher: f64,
    holds: impl Fn(f64) -> Result<bool, CollisionError>,
) -> Result<f64, CollisionError> {
    while higher > lower * (1.0 + BRACKET) {
        let middle = (lower * higher).sqrt();
        if holds(middle)? {
            lower = middle;
        } else {
            higher = middle;
        }
    }
    Ok((lower * higher).sqrt())
}
