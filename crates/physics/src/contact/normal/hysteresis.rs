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
use crate::lanes::{Lanes, Mask, cube_root};

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
    pub fn of<L: Lanes>(self, d: L) -> L {
        match self {
            Self::Linear => d,
            Self::Hertz => d * d.sqrt(),
        }
    }

    /// The overlap whose power is `x`.
    #[inline(always)]
    fn root<L: Lanes>(self, x: L) -> L {
        match self {
            Self::Linear => x,
            Self::Hertz => {
                let third = cube_root(x);
                third * third
            }
        }
    }

    /// `d^(n-1)`.
    #[inline(always)]
    fn slope<L: Lanes>(self, d: L) -> L {
        match self {
            Self::Linear => L::splat(1.0),
            Self::Hertz => d.sqrt(),
        }
    }
}

/// Stiffness of the unloading line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Unloading<L = f64> {
    /// The same always.
    Constant {
        /// Stiffness.
        stiffness: L,
        /// What the loop keeps of the loading line, `1 - k1/k2`.
        kept: f64,
        /// Dent over peak, which is that to the power `1/n`.
        dent: f64,
    },
    /// `k1 + growth D` (linear lines, with a constant pull-off stiffness and `chi = 1`), up to `D = deepest`, beyond
    /// which the contact is elastic.
    Growing {
        /// Growth of the stiffness with the largest overlap.
        growth: L,
        /// Largest plastic overlap [m].
        deepest: L,
    },
}

impl Unloading {
    /// The same in every lane.
    #[inline(always)]
    pub fn in_lanes<L: Lanes>(self) -> Unloading<L> {
        match self {
            Self::Constant { stiffness, kept, dent } => Unloading::Constant {
                stiffness: L::splat(stiffness),
                kept,
                dent,
            },
            Self::Growing { growth, deepest } => Unloading::Growing {
                growth: L::splat(growth),
                deepest: L::splat(deepest),
            },
        }
    }

    /// A constant stiffness of linear lines.
    pub fn of_lines(loading: f64, stiffness: f64) -> Self {
        let kept = 1.0 - loading / stiffness;
        Self::Constant {
            stiffness,
            kept,
            dent: kept,
        }
    }
}

/// What holds the surfaces together while they part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PullOff<L = f64> {
    /// Nothing: the contact ends at its dent.
    None,
    /// A line of this stiffness.
    Stiffness(L),
    /// A line through the largest pull `share sqrt(p)` that a dent `p` can carry; where the unloading line would reach
    /// that pull at less than half the dent only, the pull there.
    Dent {
        /// Pull over the root of the dent [N/m^(1/2)].
        share: L,
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

/// The loop of contacts of known sizes, one per lane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hysteresis<L = f64> {
    /// Stiffness of the loading line.
    pub loading: L,
    /// Stiffness of the unloading line, at least that of the loading line.
    pub unloading: Unloading<L>,
    /// Pull-off line.
    pub pull_off: PullOff<L>,
    /// Exponent of loading and unloading.
    pub power: Power,
    /// Exponent of the pull-off line, at least 1.
    pub pull_off_power: f64,
    /// Constant attraction.
    pub attraction: Attraction,
    /// Dashpot of surfaces that touch: this coefficient, times `d^(1/4)` for a Hertzian spring.
    pub damping: L,
}

/// What a contact remembers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Memory<L = f64> {
    /// Overlap at which the unloading line meets the loading line [m].
    pub peak: L,
    /// Overlap at which the unloading line meets the pull-off line; the dent where there is none [m].
    pub tear: L,
    /// Largest peak so far [m].
    pub largest: L,
    /// Stiffness of the pull-off line, which follows from the largest peak.
    pub pull_off: L,
}

/// Steps of Newton's method, which comes down to the root from above.
const MOST_ITERATIONS: u32 = 100;

impl<L: Lanes> Hysteresis<L> {
    /// Stiffness of the unloading line.
    #[inline(always)]
    pub fn unloading(&self, peak: L) -> L {
        match self.unloading {
            Unloading::Constant { stiffness, .. } => stiffness,
            Unloading::Growing { growth, .. } => self.loading + growth * peak,
        }
    }

    /// Largest overlap at which the contact yields [m].
    #[inline(always)]
    fn deepest(&self) -> L {
        match self.unloading {
            Unloading::Constant { .. } => L::splat(f64::INFINITY),
            Unloading::Growing { deepest, .. } => deepest,
        }
    }

    /// `p^n` of the dent.
    #[inline(always)]
    fn dent_power(&self, peak: L) -> L {
        let power = self.power.of(peak);
        match self.unloading {
            Unloading::Constant { kept, .. } => power * kept,
            Unloading::Growing { .. } => (L::splat(1.0) - self.loading / self.unloading(peak)) * power,
        }
    }

    /// Overlap at which an unloading contact without adhesion is free of force [m].
    #[inline(always)]
    pub fn dent(&self, peak: L) -> L {
        match self.unloading {
            Unloading::Constant { dent, .. } => peak * dent,
            // its lines are linear
            Unloading::Growing { .. } => self.dent_power(peak),
        }
    }

    /// `d^chi`.
    #[inline(always)]
    fn pull_off_power(&self, d: L) -> L {
        // the exponents in use need no logarithm, which would be half of the time of the law
        match self.pull_off_power {
            1.0 => d,
            1.5 => d * d.sqrt(),
            2.0 => d * d,
            other => {
                let mut power = d;
                for one in power.as_mut_slice() {
                    *one = libm::pow(*one, other);
                }
                power
            }
        }
    }

    /// Pull that the deepest dent can carry [N], and whether that is the whole that it wants to.
    #[inline(always)]
    fn largest_pull(&self, largest: L, share: L) -> (L, L::Mask) {
        let dent = self.dent(largest);
        let at_half = self.unloading(largest) * (self.dent_power(largest) - self.power.of(dent * 0.5));
        let wanted = share * dent.sqrt();
        (at_half.min(wanted), at_half.gt(wanted))
    }

    /// Overlap at which the unloading line of the deepest dent reaches the largest pull [m].
    #[inline(always)]
    fn place_of_pull(&self, largest: L, (pull, is_free): (L, L::Mask)) -> L {
        let half = self.dent(largest) * 0.5;
        if is_free.any() {
            let place = self
                .power
                .root(self.dent_power(largest) - pull / self.unloading(largest));
            L::select(is_free, place, half)
        } else {
            half
        }
    }

    /// Stiffness of the pull-off line through the largest pull.
    #[inline(always)]
    fn through(&self, pull: L, place: L) -> L {
        (pull / self.pull_off_power(place)).keep(place.gt(L::splat(0.0)))
    }

    /// Stiffness of the pull-off line of a deepest dent, and where it meets the unloading line from there [m].
    #[inline(always)]
    fn of_deepest(&self, largest: L, share: L) -> (L, L) {
        let pull = self.largest_pull(largest, share);
        let place = self.place_of_pull(largest, pull);
        (self.through(pull.0, place), place)
    }

    /// Memory of a contact from what is kept of it.
    #[inline(always)]
    pub fn recall(&self, peak: L, tear: L, largest: L) -> Memory<L> {
        let pull_off = match self.pull_off {
            PullOff::None => L::splat(0.0),
            PullOff::Stiffness(ka) => ka,
            PullOff::Dent { share } => {
                let pull = self.largest_pull(largest, share);
                let was_deeper = largest.gt(peak);
                let mut place = tear;
                if was_deeper.any() {
                    place = L::select(was_deeper, self.place_of_pull(largest, pull), place);
                }
                self.through(pull.0, place)
            }
        };
        Memory {
            peak,
            tear,
            largest,
            pull_off,
        }
    }

    /// Memory of a contact at a peak.
    #[inline(always)]
    pub fn at_peak(&self, peak: L, largest: L) -> Memory<L> {
        let largest = largest.max(peak);
        let k2 = self.unloading(peak);
        let (tear, pull_off) = match self.pull_off {
            PullOff::None => (self.dent(peak), L::splat(0.0)),
            PullOff::Stiffness(ka) => (self.meeting(k2, peak, ka), ka),
            PullOff::Dent { share } => {
                let (ka, place) = self.of_deepest(largest, share);
                let was_deeper = largest.gt(peak);
                let tear = if was_deeper.any() {
                    L::select(was_deeper, self.meeting(k2, peak, ka), place)
                } else {
                    place
                };
                (tear, ka)
            }
        };
        Memory {
            peak,
            tear,
            largest,
            pull_off,
        }
    }

    /// Where the unloading line from a peak meets the pull-off line [m].
    #[inline(always)]
    fn meeting(&self, k2: L, peak: L, ka: L) -> L {
        if self.power == Power::Linear && self.pull_off_power == 1.0 {
            (k2 - self.loading) * peak / (k2 + ka)
        } else {
            self.crossing(k2, peak, ka)
        }
    }

    /// Where the unloading line meets the pull-off line, `k2 (x^n - p^n) + ka x^chi = 0`.
    #[inline(always)]
    fn crossing(&self, k2: L, peak: L, ka: L) -> L {
        let (n, chi) = (self.power.exponent(), self.pull_off_power);
        let zero = L::splat(0.0);
        let dent_power = self.dent_power(peak);
        let mut x = self.dent(peak);
        let mut falls = x.gt(zero);
        for _ in 0..MOST_ITERATIONS {
            if !falls.any() {
                break;
            }
            let pull = ka * self.pull_off_power(x);
            let slope = k2 * self.power.slope(x) * n + pull * chi / x;
            let next = x - (k2 * (self.power.of(x) - dent_power) + pull) / slope;
            // a convex increasing function: every step goes down until rounding stops it
            falls = falls & x.gt(next) & next.gt(zero);
            x = L::select(falls, next, x);
        }
        x
    }

    /// Peak of the unloading line that meets the pull-off line at an overlap.
    #[inline(always)]
    fn peak_of_tear(&self, tear: L, ka: L) -> L {
        match self.unloading {
            Unloading::Constant { stiffness, kept, .. } => {
                let power = self.power.of(tear) + ka / stiffness * self.pull_off_power(tear);
                self.power.root(power / kept)
            }
            // growth D^2 - growth t D - (k1 + ka) t = 0
            Unloading::Growing { growth, .. } => {
                let half = tear * 0.5;
                half + (half * half + (self.loading + ka) * tear / growth).sqrt()
            }
        }
    }

    /// Where the constant attraction acts.
    #[inline(always)]
    fn attracts(&self, memory: Memory<L>) -> L::Mask {
        if self.attraction.force > 0.0 && !self.attraction.before_touch {
            memory.largest.gt(L::splat(0.0))
        } else {
            L::splat(self.attraction.force).gt(L::splat(0.0))
        }
    }

    /// Damping coefficient in contact [N s/m].
    #[inline(always)]
    fn damping_at(&self, overlap: L) -> L {
        match self.power {
            Power::Linear => self.damping,
            Power::Hertz => self.damping * overlap.sqrt().sqrt(),
        }
    }

    /// Overlap below which the surfaces do not touch [m].
    #[inline(always)]
    pub fn end(&self, memory: Memory<L>) -> L {
        if matches!(self.pull_off, PullOff::None) && self.attraction.force == 0.0 {
            memory.tear
        } else {
            L::splat(0.0)
        }
    }

    /// Steepest slope of the force at an overlap [N/m].
    #[inline(always)]
    pub fn stiffness(&self, memory: Memory<L>, overlap: L) -> L {
        let d = overlap.max(L::splat(0.0));
        let peak = memory.peak.max(d.min(self.deepest()));
        self.unloading(peak) * self.power.slope(d) * self.power.exponent()
    }
}

impl Hysteresis {
    /// Energy that the way out of reach gives back [J].
    pub fn energy(&self, memory: Memory, overlap: f64) -> f64 {
        // the size is in the stiffnesses
        self.stored(PairSize::default(), memory, overlap)
    }

    /// Gap beyond which no force acts [m].
    pub fn reach(&self, memory: Memory) -> f64 {
        if self.attracts(memory) {
            self.attraction.range
        } else {
            -self.end(memory)
        }
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

impl<L: Lanes> Branched<L> for Hysteresis<L> {
    type State = Memory<L>;

    #[inline(always)]
    fn advance(&self, _size: PairSize<L>, memory: Memory<L>, to: L) -> Memory<L> {
        let beyond = to.gt(memory.peak);
        let peak = to.min(self.deepest()).max(memory.peak);
        let yields = peak.gt(memory.peak);
        let mut next = memory;
        if yields.any() {
            // where nothing yields no lane may ask for a meeting that is searched for
            let largest = L::select(yields, memory.largest, peak);
            next = Self::select(yields, self.at_peak(peak, largest), next);
        }
        if !matches!(self.pull_off, PullOff::None) {
            let parts = !beyond & memory.tear.gt(to);
            if parts.any() {
                let tear = to.max(L::splat(0.0));
                let peak = self.peak_of_tear(tear, memory.pull_off).min(memory.peak);
                next = Self::select(parts, Memory { peak, tear, ..memory }, next);
            }
        }
        next
    }

    #[inline(always)]
    fn point(&self, _size: PairSize<L>, memory: Memory<L>, overlap: L, _approaching: L::Mask) -> Point<L> {
        self.point_on(memory, overlap, L::Mask::of_bits(0))
    }

    #[inline(always)]
    fn bent(&self) -> usize {
        // the second place is the tear, below which a high power falls steeply
        if self.pull_off_power > 2.0 { 2 } else { 1 }
    }

    /// On the loading line the force asks for no tear, which takes long to find, nor for the pull-off line, which only friction hears of
    /// there and which changes little but in the first steps.
    #[inline(always)]
    fn between(
        &self,
        _size: PairSize<L>,
        (from, to): (Memory<L>, Memory<L>),
        overlap: L,
        _approaching: L::Mask,
    ) -> Point<L> {
        let yields = overlap.gt(from.peak) & to.peak.gt(from.peak);
        let mut pull_off = (from.pull_off + to.pull_off) * 0.5;
        if let PullOff::Dent { share } = self.pull_off {
            let grows = yields & to.largest.gt(from.largest * 1.5);
            if grows.any() {
                pull_off = L::select(grows, self.of_deepest(overlap, share).0, pull_off);
            }
        }
        let memory = Memory {
            largest: to.largest,
            pull_off,
            ..from
        };
        self.point_on(memory, overlap, yields)
    }

    #[inline(always)]
    fn stored(&self, _size: PairSize<L>, memory: Memory<L>, overlap: L) -> L {
        let Attraction { force, range, .. } = self.attraction;
        let zero = L::splat(0.0);
        let mut attracted = zero;
        if force > 0.0 {
            let gap = (overlap.min(zero) + range).max(zero);
            let beyond = if range > 0.0 { gap * gap * (0.5 / range) } else { zero };
            attracted = ((beyond + overlap.max(zero)) * -force).keep(self.attracts(memory));
        }
        let parted = overlap.min(memory.tear).max(zero);
        let pull_off = memory.pull_off * self.pull_off_power(parted) * parted / -(self.pull_off_power + 1.0);
        let beyond = overlap.max(memory.tear);
        let dent_power = self.dent_power(memory.peak);
        let spring = self.unloading(memory.peak)
            * (self.primitive(dent_power, beyond) - self.primitive(dent_power, memory.tear));
        attracted + (pull_off + spring.keep(overlap.gt(memory.tear))).keep(overlap.gt(zero))
    }

    #[inline(always)]
    fn kinks(&self, _size: PairSize<L>, memory: Memory<L>) -> [L; KINKS] {
        let other = if self.attraction.range > 0.0 {
            L::splat(-self.attraction.range)
        } else {
            self.deepest()
        };
        [L::splat(0.0), memory.tear, memory.peak, other]
    }

    #[inline(always)]
    fn select(mask: L::Mask, yes: Memory<L>, no: Memory<L>) -> Memory<L> {
        Memory {
            peak: L::select(mask, yes.peak, no.peak),
            tear: L::select(mask, yes.tear, no.tear),
            largest: L::select(mask, yes.largest, no.largest),
            pull_off: L::select(mask, yes.pull_off, no.pull_off),
        }
    }

    #[inline(always)]
    fn differ(one: Memory<L>, other: Memory<L>) -> L::Mask {
        let [peak, tear] = [[one.peak, other.peak], [one.tear, other.tear]];
        // the largest peak and what follows from it change with the peak only
        peak[0].gt(peak[1]) | peak[1].gt(peak[0]) | tear[0].gt(tear[1]) | tear[1].gt(tear[0])
    }
}

impl<L: Lanes> Hysteresis<L> {
    /// Force of a contact with this memory, or on the loading line where it `yields`.
    #[inline(always)]
    fn point_on(&self, memory: Memory<L>, overlap: L, yields: L::Mask) -> Point<L> {
        let Attraction { force, range, .. } = self.attraction;
        let zero = L::splat(0.0);
        let inside = overlap.gt(zero);
        let pull = memory.pull_off * self.pull_off_power(overlap);
        let power = self.power.of(overlap);
        let line = self.unloading(memory.peak) * (power - self.dent_power(memory.peak));
        let spring = L::select(overlap.ge(memory.tear), line, -pull);
        let spring = L::select(yields, self.loading * power, spring);
        let touching = inside & overlap.gt(self.end(memory));
        let mut attracted = zero;
        if force > 0.0 {
            let within = self.attracts(memory) & overlap.gt(L::splat(-range));
            let across = (overlap / range + 1.0).keep(within);
            attracted = L::select(inside, L::splat(force), across * force);
        }
        Point {
            elastic: spring.keep(inside) - attracted,
            damping: self.damping_at(overlap).keep(touching),
            adhesion: (pull + force).keep(touching),
        }
    }

    /// Integral of `x^n - p^n` over the overlap.
    #[inline(always)]
    fn primitive(&self, dent_power: L, d: L) -> L {
        (self.power.of(d) / (self.power.exponent() + 1.0) - dent_power) * d
    }
}
