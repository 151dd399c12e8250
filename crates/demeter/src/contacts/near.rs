//! Candidates that may touch within the next steps.
//!
//! The table of contacts holds those candidates that are nearer than a reach beyond touching. They are looked for anew when
//! grains have moved so far that a candidate which is not in the table might act; until then nothing but the table is read.
//!
//! Between grains it is foreseen for some steps how each pair approaches as it does now: two grains at a distance `r` whose velocities
//! against each other are `u` are no nearer than `r + t min(u.r/r, 0)` after a time `t` (a straight way is no shorter than along the
//! normal), less what changes of `u` bring. Half a kick of a grain is at most `K` in a step, so in the `s`th step after the table was made `u`
//! differs by at most `A(s) = K(0) + 2 (K(1) + ... + K(s))` of both grains from what it was then, and the way by the sum of `A dt`: that, not the way
//! itself, uses up the reach. Pairs that move together need no reach, however fast they are.

use super::Scene;
use super::meetings::{Meeting, PickedPairs, lanes_below};
use crate::comm::parts::{InParts, Listed, Part};
use crate::neighbours::Pairs;
use demeter_physics::lanes::{Kernel, Lanes, Mask, Vector};
use serde::{Deserialize, Serialize};
use std::ops::Range;

/// A table shall serve for so many steps.
const STEPS: f64 = 24.0;

/// The same where it is foreseen how pairs approach.
const STEPS_AHEAD: f64 = 48.0;

/// Looking for contacts costs as much as this share of those that come into the table with a reach of the mean radius: between grains,
/// and with walls, of which each part is looked at alone.
const SEARCH: [f64; 2] = [0.05, 2.0];

/// By how much kicks may grow while a table serves.
const GROWTH: f64 = 1.2;

/// Half kicks that are foreseen are rounded to singles, and may be larger by this factor.
const SINGLES: f64 = 1.0 + f32::EPSILON as f64;

/// The least and the most that the reach goes beyond what acts in one step, as shares of the mean radius.
const ROOM: (f64, f64) = (1e-5, 0.1);

/// Rounding of places may bring two grains nearer by this share of the mean radius in a step.
const ROUNDING: f64 = 1e-12;

/// How far the table of contacts of a segment reaches.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
struct NearTable {
    /// Distance beyond touching of the candidates in the table [m].
    reach: f64,
    /// How much nearer two grains can have come since [m], beyond what was foreseen.
    approached: f64,
    /// Steps for which it is still foreseen how pairs approach; none where it is not.
    ahead: Option<u32>,
    /// By how much velocities of two grains against each other can have changed since [m/s].
    changed: f64,
}

/// How bodies of a segment may move against each other in a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Approach {
    /// How much nearer two came at most [m].
    pub(crate) nearer: f64,
    /// Distance beyond touching at which they may act [m].
    pub(crate) window: f64,
    /// The half kicks of both that ended the step before, in size [m/s]; infinite where the approach of pairs is not to be foreseen.
    pub(crate) kick: f64,
}

impl Approach {
    /// That of bodies of whose approach no more is known than these bounds [m].
    pub(crate) fn at_most(nearer: f64, window: f64) -> Self {
        Self {
            nearer,
            window,
            kick: f64::INFINITY,
        }
    }
}

/// With which distances to look for contacts.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Sought {
    /// Distance beyond touching [m].
    pub(crate) reach: f64,
    /// For how long pairs are foreseen to approach as they do now [s].
    pub(crate) time: f64,
}

impl NearTable {
    /// A table that does not serve.
    const NONE: Self = Self {
        reach: 0.0,
        approached: f64::INFINITY,
        ahead: None,
        changed: 0.0,
    };

    /// Notes a step of some length [s]. Tells with which distances to look for contacts where the table does not serve any more: some
    /// candidate outside of it may be as near as the window.
    fn advance(&mut self, approach: Approach, dt: f64, search: f64, mean_radius: f64) -> Option<Sought> {
        let Approach { nearer, window, kick } = approach;
        let kick = kick * SINGLES;
        let is_over = self.ahead == Some(0);
        if let Some(ahead) = &mut self.ahead {
            *ahead = ahead.saturating_sub(1);
            self.changed += 2.0 * kick;
            self.approached += self.changed * dt;
        } else {
            self.approached += nearer;
        }
        self.approached += ROUNDING * mean_radius;
        // not a number serves no more
        if !is_over && self.approached + window <= self.reach {
            return None;
        }
        let (least, most) = (ROOM.0 * mean_radius, ROOM.1 * mean_radius);
        // a step costs `search nearer/room + room/mean_radius`: least where both are the same
        let best = (STEPS * nearer).min((search * nearer * mean_radius).sqrt());
        // where motion is not bounded, the table serves for one step
        let room = if best.is_finite() { best } else { 0.0 };
        let by_way = room.clamp(least, most);
        // the same with `search/steps`, where kicks use up more from step to step
        let change = 2.0 * kick * dt;
        let steps = libm::cbrt(search * mean_radius / (GROWTH * change))
            .clamp(1.0, STEPS_AHEAD)
            .floor();
        let by_kicks = (GROWTH * change * (0.5 * steps * steps + steps)).max(least);
        let cost = |steps: f64, room: f64| search / steps + room / mean_radius;
        let is_foreseen = cost(steps, by_kicks) < cost(by_way / nearer, by_way);
        self.ahead = is_foreseen.then_some(steps as u32);
        self.reach = window + if is_foreseen { by_kicks } else { by_way };
        (self.approached, self.changed) = (0.0, kick);
        Some(Sought {
            reach: self.reach,
            time: if is_foreseen { steps * dt } else { 0.0 },
        })
    }
}

/// The tables of contacts of a segment: between grains, and with walls.
type TwoTables = [NearTable; 2];

/// How far the tables of contacts reach in every segment: where grains move together they need not reach as far as where they meet.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct NearTables {
    of_segments: Vec<TwoTables>,
    /// Mean radius of the grains [m].
    mean_radius: f64,
    /// How they serve in this step.
    #[serde(skip)]
    in_step: Vec<[InStep; 2]>,
}

/// How a table serves in a step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct InStep {
    /// With which distances to look for contacts; none where the table serves.
    sought: Option<Sought>,
    /// Distance beyond touching at which bodies may act [m].
    window: f64,
}

/// How far a table of contacts with walls reaches.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Reach {
    /// Distance beyond touching [m].
    pub(crate) distance: f64,
    /// Whether it reaches so far from this step on.
    pub(crate) is_new: bool,
    /// Distance beyond touching at which bodies may act in this step [m].
    pub(crate) window: f64,
}

/// What is saved of [`NearTables`].
#[derive(Serialize)]
#[serde(rename = "NearTables")]
struct Written<'a, 'b> {
    of_segments: Listed<'a, 'b, TwoTables>,
    mean_radius: f64,
}

impl InParts for NearTables {
    fn in_parts<'a>(&'a self, part: &'a Part<'_>) -> impl Serialize + 'a {
        Written {
            of_segments: part.of_segments(&self.of_segments),
            mean_radius: self.mean_radius,
        }
    }
}

impl NearTables {
    /// Notes a step of some length [s]. `approach` tells of a segment how grains moved against each other, and against walls. The others
    /// have no tables here.
    pub(crate) fn advance(&mut self, segments: Range<usize>, dt: f64, approach: impl Fn(usize) -> [Approach; 2]) {
        (self.in_step).resize(self.of_segments.len(), Default::default());
        for segment in segments {
            let approach = approach(segment);
            for (kind, (&approach, search)) in approach.iter().zip(SEARCH).enumerate() {
                self.in_step[segment][kind] = InStep {
                    sought: self.of_segments[segment][kind].advance(approach, dt, search, self.mean_radius),
                    window: approach.window,
                };
            }
        }
    }

    /// The tables that a restart needs.
    pub(crate) fn saved(&self) -> Self {
        self.of_segments(0..self.of_segments.len())
    }

    /// The tables of some segments.
    pub(crate) fn of_segments(&self, segments: Range<usize>) -> Self {
        Self {
            of_segments: self.of_segments[segments].to_vec(),
            mean_radius: self.mean_radius,
            in_step: Vec::new(),
        }
    }

    /// The tables of segments that follow each other.
    pub(crate) fn joined(parts: Vec<Self>) -> Self {
        Self {
            mean_radius: parts.first().map_or(0.0, |part| part.mean_radius),
            of_segments: parts.into_iter().flat_map(|part| part.of_segments).collect(),
            in_step: Vec::new(),
        }
    }

    /// With which distances to look for the contacts of a segment in this step; none where its table serves.
    #[inline(always)]
    pub(crate) fn sought(&self, segment: usize) -> Option<Sought> {
        self.in_step[segment][0].sought
    }

    /// How far the contacts of a segment with walls reach.
    #[inline(always)]
    pub(crate) fn at_walls(&self, segment: usize) -> Reach {
        let InStep { sought, window } = self.in_step[segment][1];
        Reach {
            distance: self.of_segments[segment][1].reach,
            is_new: sought.is_some(),
            window,
        }
    }

    /// Has the contacts looked for in the next step, as velocities were changed otherwise than by kicks.
    pub(crate) fn look_anew(&mut self) {
        self.of_segments.fill([NearTable::NONE; 2]);
    }

    /// Has the contacts looked for in the next step, among new candidates.
    pub(crate) fn forget(&mut self, segments: usize, mean_radius: f64) {
        self.of_segments.clear();
        self.of_segments.resize(segments, [NearTable::NONE; 2]);
        self.mean_radius = mean_radius;
    }

    /// Whether there are as many as segments, and the numbers are possible, as they are unless a file was tampered with.
    pub(crate) fn are_sound(&self, segments: usize) -> bool {
        let is_sound = |table: &NearTable| table.reach >= 0.0 && table.approached >= 0.0 && table.changed >= 0.0;
        self.of_segments.len() == segments && self.mean_radius >= 0.0 && self.of_segments.iter().flatten().all(is_sound)
    }
}

/// Finds the candidates of a chunk that are nearer than a reach beyond touching, or will be.
pub(super) struct FindNear<'a> {
    pub(super) pairs: Pairs<'a>,
    pub(super) scene: &'a Scene<'a>,
    /// Distances beyond touching, and beyond what the surfaces may bulge.
    pub(super) sought: Sought,
    pub(super) near: &'a mut Vec<u16>,
}

impl Kernel for FindNear<'_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self) {
        let Self {
            pairs, near, sought, ..
        } = self;
        let meeting = Meeting::new(self.scene);
        let count = pairs.len();
        near.resize(count + L::COUNT, 0);
        let mut found = 0;
        let mut picked = PickedPairs::default();
        for c in (0..count).step_by(L::COUNT) {
            let mut lane = 0;
            while lane < L::COUNT {
                picked.put(lane, &pairs.get((c + lane).min(count - 1)));
                lane += 1;
            }
            let lot = picked.lot::<L>();
            let (apart, ri, rj) = meeting.apart::<L>(&lot);
            let reach = ri + rj + meeting.bulges::<L>(&lot) + sought.reach;
            let mut square = apart.square();
            if sought.time > 0.0 {
                // `r + t w < d` makes `r^2 + 2 t w r < d^2`, as `2 d r <= d^2 + r^2`
                let closing = meeting.velocity::<L>(&lot).inner(apart).min(L::splat(0.0));
                square = square + closing * (2.0 * sought.time);
            }
            let bits = square.lt(reach * reach).bits() & lanes_below(count - c);
            // every lane is written, and counted only where it is near: which are cannot be foretold
            let mut lane = 0;
            while lane < L::COUNT {
                near[found] = (c + lane) as u16;
                found += (bits >> lane & 1) as usize;
                lane += 1;
            }
        }
        near.truncate(found);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    #[test]
    fn tables_of_grains_that_move_together_are_narrow_and_serve_long() {
        let mut tables = NearTables::default();
        tables.forget(3, 1.0);
        // segments whose grains come nearer by so much in a step
        let nearer = [1e-3, 1e-6, 0.0];
        let mut looked = [0u32; 3];
        for step in 0..1000 {
            let before = tables.clone();
            tables.advance(0..3, 1.0, |segment| {
                [Approach::at_most(nearer[segment], 0.5 * nearer[segment]); 2]
            });
            for segment in 0..3 {
                let Some(Sought { reach, .. }) = tables.sought(segment) else {
                    // nobody outside has come as near as to act
                    let (table, was) = (&tables.of_segments[segment][0], &before.of_segments[segment][0]);
                    assert!(table.reach == was.reach && table.approached + 0.5 * nearer[segment] <= table.reach);
                    continue;
                };
                assert!(
                    reach > 0.5 * nearer[segment],
                    "{reach} of segment {segment} in step {step}"
                );
                looked[segment] += 1;
            }
        }
        // fast ones as often as looking is worth it, others after so many steps
        assert!(
            (80..130).contains(&looked[0]) && (35..50).contains(&looked[1]) && looked[2] == 1,
            "{looked:?}"
        );
        let reach = |segment: usize| tables.of_segments[segment][0].reach;
        assert!(reach(1) < 0.1 * reach(0) && reach(2) < reach(1));
        // motion that is not bounded
        tables.advance(1..2, 1.0, |_| [Approach::at_most(f64::INFINITY, 0.1); 2]);
        tables.advance(1..2, 1.0, |_| [Approach::at_most(f64::NAN, 0.1); 2]);
        assert!(
            tables.sought(1).is_some_and(|sought| sought.reach > 0.1) && tables.are_sound(3) && !tables.are_sound(2)
        );
    }
    /// Numbers in [-1, 1), always the same.
    struct Numbers(u64);

    impl Numbers {
        fn next(&mut self) -> f64 {
            self.0 = self
                .0
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
        }

        fn vector(&mut self) -> DVec3 {
            DVec3::from_array([(); 3].map(|()| self.next()))
        }
    }

    #[test]
    fn who_is_not_in_a_table_that_is_foreseen_does_not_act() {
        const PAIRS: usize = 3000;
        let (mut numbers, dt, radius) = (Numbers(7), 1e-3, 0.5);
        let (mut served, mut left_out, mut looked) = (0, 0, 0);
        for (speed, largest_kick) in [(1.0, 1e-3), (1.0, 3e-2), (0.05, 1e-4), (2.0, 0.0)] {
            // place and velocity of the first against the second: as in the table, and in the middle of the latest step
            let mut pairs: Vec<_> = (0..PAIRS)
                .map(|_| {
                    let place = numbers.vector().normalize() * (1.0 + 0.05 * numbers.next().abs());
                    let middle = numbers.vector() * speed;
                    (place, middle, middle)
                })
                .collect();
            let mut kick_before = vec![DVec3::ZERO; PAIRS];
            let mut table = NearTable::NONE;
            let mut is_in = vec![false; PAIRS];
            for _ in 0..200 {
                // half kicks at the end of the step before; the velocity in the table is that of the middle and one of them more
                let kick = kick_before.iter().map(|kick| kick.length()).fold(0.0, f64::max);
                let fastest = pairs
                    .iter()
                    .map(|pair| pair.2.length().max(pair.1.length()))
                    .fold(0.0, f64::max);
                let approach = Approach {
                    nearer: fastest * dt,
                    window: 0.5 * fastest * dt,
                    kick,
                };
                let sought = table.advance(approach, dt, SEARCH[0], radius);
                for (k, &(place, velocity, _)) in pairs.iter().enumerate() {
                    let gap = place.length() - 2.0 * radius;
                    if let Some(sought) = sought {
                        let closing = velocity.dot(place).min(0.0) * 2.0 * sought.time;
                        let reach = 2.0 * radius + sought.reach;
                        is_in[k] = place.length_squared() + closing < reach * reach;
                    }
                    let rate = -velocity.dot(place) / place.length();
                    assert!(
                        is_in[k] || gap - 0.5 * dt * rate.abs() > 0.0,
                        "pair {k} at {gap} approaches with {rate}"
                    );
                    left_out += usize::from(!is_in[k]);
                }
                looked += usize::from(sought.is_some());
                served += usize::from(sought.is_none() && table.ahead.is_some());
                for (pair, before) in pairs.iter_mut().zip(&mut kick_before) {
                    let kick = numbers.vector() * (largest_kick / 3f64.sqrt());
                    let middle = pair.2 + kick * 2.0;
                    *pair = (pair.0 + middle * dt, middle + kick, middle);
                    *before = kick;
                }
            }
        }
        // most pairs are left out, and most steps look at none of them
        assert!(
            left_out > 100 * PAIRS && served > 300 && looked < 400,
            "{left_out} {served} {looked}"
        );
    }
}
