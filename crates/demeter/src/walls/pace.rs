//! How fast the own time of a motion passes: it starts and stops smoothly.
//!
//! A motion with a pace happens at its own time `tau` in place of the time `t` since it was told:
//! `d tau/dt = S(t/a) (1 - S((t - b)/c))`, `S(x) = x^2 (3 - 2 x)` between 0 and 1, with the time of starting `a`, the
//! moment `b >= a` at which it begins to stop and the time of stopping `c`. So every velocity of the motion is scaled by
//! `d tau/dt`, smoothly and exactly: a drum comes to its speed, a vibrating plate to its frequency. `tau` is the integral of
//! that in closed form.

use serde::{Deserialize, Serialize};

/// When a motion comes to its speed and when it stops.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Pace {
    /// Time from rest to full speed [s]; 0: at full speed at once.
    pub start_over: f64,
    /// Time after which the motion begins to stop, not before it has its full speed [s]; infinite: never.
    pub stop_after: f64,
    /// Time from full speed to rest [s]; 0: it stops at once.
    pub stop_over: f64,
}

impl Pace {
    /// Full speed from start to end.
    pub const FULL: Pace = Pace {
        start_over: 0.0,
        stop_after: f64::INFINITY,
        stop_over: 0.0,
    };

    /// The motion's own time, and how fast it passes, at a time since the motion was told.
    pub fn own_time(&self, time: f64) -> (f64, f64) {
        if *self == Self::FULL {
            return (time, 1.0);
        }
        let (risen, rate) = if time < self.start_over {
            let share = time / self.start_over;
            (self.start_over * smooth_integral(share), smooth(share))
        } else {
            (time - 0.5 * self.start_over, 1.0)
        };
        let since = time - self.stop_after;
        if since <= 0.0 {
            return (risen, rate);
        }
        let at_stop = self.stop_after - 0.5 * self.start_over;
        if since < self.stop_over {
            let share = since / self.stop_over;
            let lost = self.stop_over * smooth_integral(share);
            (at_stop + since - lost, 1.0 - smooth(share))
        } else {
            (at_stop + 0.5 * self.stop_over, 0.0)
        }
    }

    /// Whether the motion has stopped for good.
    pub fn is_over(&self, time: f64) -> bool {
        time >= self.stop_after + self.stop_over
    }
}

fn smooth(x: f64) -> f64 {
    x * x * (3.0 - 2.0 * x)
}

/// Integral of `smooth` from 0.
fn smooth_integral(x: f64) -> f64 {
    x * x * x * (1.0 - 0.5 * x)
}

#[cfg(test)]
mod tests {
    use super::*;

    const PACE: Pace = Pace {
        start_over: 0.5,
        stop_after: 2.0,
        stop_over: 0.25,
    };

    #[test]
    fn the_rate_is_the_derivative_and_the_area_is_exact() {
        for k in 0..300 {
            let (t, h) = (0.01 * f64::from(k), 1e-6);
            let slope = (PACE.own_time(t + h).0 - PACE.own_time((t - h).max(0.0)).0) / (h + h.min(t));
            assert!((slope - PACE.own_time(t).1).abs() < 2e-5, "{t}: {slope}");
        }
        // a trapezium: from 0.25 to 2.125
        assert_eq!(PACE.own_time(3.0), (1.875, 0.0));
        assert!(PACE.is_over(2.25) && !PACE.is_over(2.2));
    }

    #[test]
    fn full_speed_changes_no_bit_of_the_time() {
        assert_eq!(Pace::FULL.own_time(0.1 + 0.2), (0.1 + 0.2, 1.0));
        assert!(!Pace::FULL.is_over(1e300));
    }

    #[test]
    fn a_start_alone_lags_by_half_of_its_time() {
        let start = Pace {
            start_over: 1.0,
            ..Pace::FULL
        };
        assert_eq!(start.own_time(5.0), (4.5, 1.0));
        assert_eq!(start.own_time(0.0), (0.0, 0.0));
    }
}
