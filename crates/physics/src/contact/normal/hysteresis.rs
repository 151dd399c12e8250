//! A spring that yields: the loop of loading, unloading, reloading and pull-off that hysteretic laws share.
//!
//! ```text
//! loading        k1 d^n                    where the overlap is the largest so far, D
//! unloading      k2 (d^n - p^n)            p^n = (1 - k1/k2) D^n: the dent; also the way back to D
//! pull-off       -ka d^chi                 below the overlap t at which the unloading line meets it
//! attraction     -f                        added wherever the surfaces touch; beyond, it falls to 0 over a range
//! ```
//!
//! **Memory.** A contact that turns round on the pull-off line goes back up along an unloading line that starts there:
//! `D` falls with the overlap, so that the line through the place meets the loading line at the new `D`. Where `k2`
//! depends on `D`, the new `D` is the one whose own `k2` does so. The pull-off stiffness stays that of the deepest dent.
//!
//! **Energy.** What is stored is the work that the way out of reach gives back, which is a function of the overlap and
//! the memory. It is continuous at every change of line, and grows along the loading line by less than the work done
//! there (`k2 >= k1`), so that no cycle gives energy.

use super::path::{Branched, KINKS, Point};
use crate::contact::PairSize;

/// Exponent of the overlap in the loading and unloading lines.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Power {
    /// `n = 1`.
    Linear,
    /// `n = 3/2`.
    Hertz,
}

impl Power {
    /// The exponent.
    #[inline(always)]
    pub fn exponent(self) -> f64 {
        match self {
            Self::Linear => 1.0,
            Self::Hertz => 1.5,
        }
    }

    /// `d^n`.
    #[inline(always)]
    pub fn of(self, d: f64) -> f64 {
        match self {
            Self::Linear => d,
            Self::Hertz => d * d.sqrt(),
        }
    }

    /// The overlap whose power is `x`.
    #[inline(always)]
    fn root(self, x: f64) -> f64 {
        match self {
            Self::Linear => x,
            Self::Hertz => {
                let third = libm::cbrt(x);
                third * third
            }
        }
    }

    /// `d^(n-1)`.
    #[inline(always)]
    fn slope(self, d: f64) -> f64 {
        match self {
            Self::Linear => 1.0,
            Self::Hertz => d.sqrt(),
        }
    }
}

/// Stiffness of the unloading line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Unloading {
    /// The same always.
    Constant(f64),
    /// `k1 + growth D` (linear lines, with a constant pull-off stiffness and `chi = 1`), up to `D = deepest`, beyond
    /// which the contact is elastic.
    Growing {
        /// Growth of the stiffness with the largest overlap.
        growth: f64,
        /// Largest plastic overlap [m].
        deepest: f64,
    },
}

/// What holds the surfaces together while they part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PullOff {
    /// Nothing: the contact ends at its dent.
    None,
    /// A line of this stiffness.
    Stiffness(f64),
    /// A line through the largest pull `share sqrt(p)` that a dent `p` can carry; where the unloading line would reach
    /// that pull at less than half the dent only, the pull there.
    Dent {
        /// Pull over the root of the dent [N/m^(1/2)].
        share: f64,
    },
}

/// Attraction of constant force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Attraction {
    /// Force in contact [N], not negative.
    pub force: f64,
    /// Gap over which it falls to zero [m]; with 0 it ends at touching.
    pub range: f64,
    /// Whether it acts across the gap before the first touch, too.
    pub before_touch: bool,
}

impl Attraction {
    /// No attraction.
    pub const NONE: Self = Self {
        force: 0.0,
        range: 0.0,
        before_touch: false,
    };
}

/// The loop of one contact of known size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hysteresis {
    /// Stiffness of the loading line.
    pub loading: f64,
    /// Stiffness of the unloading line, at least that of the loading line.
    pub unloading: Unloading,
    /// Pull-off line.
    pub pull_off: PullOff,
    /// Exponent of loading and unloading.
    pub power: Power,
    /// Exponent of the pull-off line, at least 1.
    pub pull_off_power: f64,
    /// Constant attraction.
    pub attraction: Attraction,
    /// Dashpot of surfaces that touch: this coefficient, times `d^(1/4)` for a Hertzian spring.
    pub damping: f64,
}

/// What a contact remembers.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Memory {
    /// Overlap at which the unloading line meets the loading line [m].
    pub peak: f64,
    /// Overlap at which the unloading line meets the pull-off line; the dent where there is none [m].
    pub tear: f64,
    /// Largest peak so far [m].
    pub largest: f64,
    /// Stiffness of the pull-off line, which follows from the largest peak.
    pub pull_off: f64,
}

/// Steps of Newton's method, which comes down to the root from above.
const MOST_ITERATIONS: u32 = 100;

impl Hysteresis {
    /// Stiffness of the unloading line.
    #[inline(always)]
    pub fn unloading(&self, peak: f64) -> f64 {
        match self.unloading {
            Unloading::Constant(k2) => k2,
            Unloading::Growing { growth, .. } => self.loading + growth * peak,
        }
    }

    /// Largest overlap at which the contact yields [m].
    #[inline(always)]
    fn deepest(&self) -> f64 {
        match self.unloading {
            Unloading::Constant(_) => f64::INFINITY,
            Unloading::Growing { deepest, .. } => deepest,
        }
    }

    /// `p^n` of the dent.
    #[inline(always)]
    fn dent_power(&self, peak: f64) -> f64 {
        (1.0 - self.loading / self.unloading(peak)) * self.power.of(peak)
    }

    /// Overlap at which an unloading contact without adhesion is free of force [m].
    #[inline(always)]
    pub fn dent(&self, peak: f64) -> f64 {
        self.power.root(self.dent_power(peak))
    }

    /// `d^chi`.
    #[inline(always)]
    fn pull_off_power(&self, d: f64) -> f64 {
        // the exponents in use need no logarithm, which would be half of the time of the law
        match self.pull_off_power {
            1.0 => d,
            1.5 => d * d.sqrt(),
            2.0 => d * d,
            other => libm::pow(d, other),
        }
    }

    /// Pull that the deepest dent can carry [N], and the overlap at which it does [m].
    fn largest_pull(&self, largest: f64, share: f64) -> (f64, f64) {
        let k2 = self.unloading(largest);
        let dent_power = self.dent_power(largest);
        let dent = self.power.root(dent_power);
        let at_half = k2 * (dent_power - self.power.of(0.5 * dent));
        let wanted = share * dent.sqrt();
        if wanted < at_half {
            (wanted, self.power.root(dent_power - wanted / k2))
        } else {
            (at_half, 0.5 * dent)
        }
    }

    /// Largest overlap at which the dent can just carry its pull, at half its depth [m].
    #[inline(always)]
    fn free_pull(&self, share: f64) -> f64 {
        let k2 = self.unloading(0.0);
        // p^(n - 1/2)
        let half = share / (k2 * (1.0 - self.power.of(0.5)));
        let dent = match self.power {
            Power::Linear => half * half,
            Power::Hertz => half,
        };
        self.power.root(self.power.of(dent) / (1.0 - self.loading / k2))
    }

    /// Stiffness of the pull-off line, and where it meets the unloading line of the deepest dent when that is known at once.
    #[inline(always)]
    fn pull_off(&self, largest: f64) -> (f64, Option<f64>) {
        match self.pull_off {
            PullOff::None => (0.0, None),
            PullOff::Stiffness(ka) => (ka, None),
            PullOff::Dent { share } => {
                let (pull, place) = self.largest_pull(largest, share);
                let stiffness = if place > 0.0 {
                    pull / self.pull_off_power(place)
                } else {
                    0.0
                };
                (stiffness, Some(place))
            }
        }
    }

    /// Memory of a contact from what is kept of it.
    #[inline(always)]
    pub fn recall(&self, peak: f64, tear: f64, largest: f64) -> Memory {
        Memory {
            peak,
            tear,
            largest,
            pull_off: self.pull_off(largest).0,
        }
    }

    /// Memory of a contact at a peak.
    pub fn at_peak(&self, peak: f64, largest: f64) -> Memory {
        let largest = largest.max(peak);
        let k2 = self.unloading(peak);
        let (ka, place) = self.pull_off(largest);
        let tear = match place {
            Some(place) if peak == largest => place,
            _ if self.pull_off == PullOff::None => self.dent(peak),
            _ if self.power == Power::Linear && self.pull_off_power == 1.0 => (k2 - self.loading) * peak / (k2 + ka),
            _ => self.crossing(k2, self.dent_power(peak), ka),
        };
        Memory {
            peak,
            tear,
            largest,
            pull_off: ka,
        }
    }

    /// Where the unloading line meets the pull-off line, `k2 (x^n - p^n) + ka x^chi = 0`.
    fn crossing(&self, k2: f64, dent_power: f64, ka: f64) -> f64 {
        let (n, chi) = (self.power.exponent(), self.pull_off_power);
        let mut x = self.power.root(dent_power);
        for _ in 0..MOST_ITERATIONS {
            if x <= 0.0 {
                return 0.0;
            }
            let pull = ka * self.pull_off_power(x);
            let slope = n * k2 * self.power.slope(x) + chi * pull / x;
            let next = x - (k2 * (self.power.of(x) - dent_power) + pull) / slope;
            // a convex increasing function: every step goes down until rounding stops it
            if next >= x {
                return x;
            }
            x = next;
        }
        x
    }

    /// Peak of the unloading line that meets the pull-off line at an overlap.
    fn peak_of_tear(&self, tear: f64, ka: f64) -> f64 {
        match self.unloading {
            Unloading::Constant(k2) => {
                let power = self.power.of(tear) + ka / k2 * self.pull_off_power(tear);
                self.power.root(power / (1.0 - self.loading / k2))
            }
            // growth D^2 - growth t D - (k1 + ka) t = 0
            Unloading::Growing { growth, .. } => {
                let half = 0.5 * tear;
                half + (half * half + (self.loading + ka) * tear / growth).sqrt()
            }
        }
    }

    /// Whether the constant attraction acts.
    #[inline(always)]
    fn attracts(&self, memory: Memory) -> bool {
        self.attraction.force > 0.0 && (self.attraction.before_touch || memory.largest > 0.0)
    }

    /// Damping coefficient in contact [N s/m].
    #[inline(always)]
    fn damping_at(&self, overlap: f64) -> f64 {
        match self.power {
            Power::Linear => self.damping,
            Power::Hertz => self.damping * overlap.sqrt().sqrt(),
        }
    }

    /// Energy that the way out of reach gives back [J].
    pub fn energy(&self, memory: Memory, overlap: f64) -> f64 {
        // the size is in the stiffnesses
        self.stored(PairSize::default(), memory, overlap)
    }

    /// Overlap below which the surfaces do not touch [m].
    #[inline(always)]
    pub fn end(&self, memory: Memory) -> f64 {
        if self.pull_off == PullOff::None && self.attraction.force == 0.0 {
            memory.tear
        } else {
            0.0
        }
    }

    /// Gap beyond which no force acts [m].
    #[inline(always)]
    pub fn reach(&self, memory: Memory) -> f64 {
        if self.attracts(memory) {
            self.attraction.range
        } else {
            -self.end(memory)
        }
    }

    /// Steepest slope of the force at an overlap [N/m].
    #[inline(always)]
    pub fn stiffness(&self, memory: Memory, overlap: f64) -> f64 {
        let d = overlap.max(0.0);
        let peak = memory.peak.max(d.min(self.deepest()));
        self.power.exponent() * self.unloading(peak) * self.power.slope(d)
    }

    /// Steepest slope of the force on any path up to an overlap [N/m].
    pub fn steepest(&self, overlap: f64) -> f64 {
        let n = self.power.exponent();
        let peak = overlap.min(self.deepest());
        let k2 = self.unloading(peak);
        let unloading = n * k2 * self.power.slope(overlap);
        let pull_off = match self.pull_off {
            PullOff::None => 0.0,
            PullOff::Stiffness(ka) => ka,
            // at the tear, at half the dent at the least, where the pull is below `k2 p^n (1 - 2^-n)`
            PullOff::Dent { .. } => {
                let half = 1.0 - self.power.of(0.5);
                2.0 * self.pull_off_power * half * k2 * self.power.slope(self.dent(peak))
            }
        };
        let Attraction { force, range, .. } = self.attraction;
        let attraction = if range > 0.0 { force / range } else { 0.0 };
        unloading.max(pull_off).max(attraction)
    }
}

impl Branched for Hysteresis {
    type State = Memory;

    #[inline]
    fn advance(&self, _size: PairSize, memory: Memory, to: f64) -> Memory {
        if to > memory.peak {
            let peak = to.min(self.deepest());
            if peak > memory.peak {
                return self.at_peak(peak, memory.largest);
            }
        } else if to < memory.tear && self.pull_off != PullOff::None {
            let tear = to.max(0.0);
            return Memory {
                peak: self.peak_of_tear(tear, memory.pull_off).min(memory.peak),
                tear,
                ..memory
            };
        }
        memory
    }

    #[inline]
    fn point(&self, _size: PairSize, memory: Memory, overlap: f64, _approaching: bool) -> Point {
        let Attraction { force, range, .. } = self.attraction;
        if overlap <= 0.0 {
            let share = if self.attracts(memory) && overlap > -range {
                1.0 + overlap / range
            } else {
                0.0
            };
            return Point {
                elastic: -force * share,
                ..Point::default()
            };
        }
        let pull = memory.pull_off * self.pull_off_power(overlap);
        let spring = if overlap >= memory.tear {
            self.unloading(memory.peak) * (self.power.of(overlap) - self.dent_power(memory.peak))
        } else {
            -pull
        };
        let touching = overlap > self.end(memory);
        Point {
            elastic: spring - force,
            damping: if touching { self.damping_at(overlap) } else { 0.0 },
            adhesion: if touching { pull + force } else { 0.0 },
        }
    }

    #[inline]
    fn stored(&self, _size: PairSize, memory: Memory, overlap: f64) -> f64 {
        let Attraction { force, range, .. } = self.attraction;
        let attracted = if self.attracts(memory) {
            let gap = (range + overlap.min(0.0)).max(0.0);
            let beyond = if range > 0.0 { 0.5 * gap * gap / range } else { 0.0 };
            -force * (beyond + overlap.max(0.0))
        } else {
            0.0
        };
        if overlap <= 0.0 {
            return attracted;
        }
        let parted = overlap.min(memory.tear);
        let pull_off = -memory.pull_off * self.pull_off_power(parted) * parted / (self.pull_off_power + 1.0);
        if overlap <= memory.tear {
            return attracted + pull_off;
        }
        let primitive = |d: f64| {
            let n = self.power.exponent();
            (self.power.of(d) / (n + 1.0) - self.dent_power(memory.peak)) * d
        };
        let spring = self.unloading(memory.peak) * (primitive(overlap) - primitive(memory.tear));
        attracted + pull_off + spring
    }

    #[inline(always)]
    fn kinks(&self, _size: PairSize, memory: Memory) -> [f64; KINKS] {
        let other = match self.pull_off {
            PullOff::Dent { share } => self.free_pull(share),
            _ if self.attraction.range > 0.0 => -self.attraction.range,
            _ => self.deepest(),
        };
        [other, 0.0, memory.tear, memory.peak]
    }
}
