//! Head-on collision of two bodies under a normal law, `m x'' = -F`, with error control and located events.
//!
//! A step of an explicit Runge-Kutta method of order 8 ends exactly where the bodies turn round and where contact
//! ends. Within a step the law answers from what it remembered at the start of the step; an accepted step makes it
//! remember the end. The singular start of a Hertzian contact (a dashpot that grows as the fourth root of the
//! overlap), and forces that jump where a law changes its branch, are met by steps as short as they need.

use super::ode;
use super::outcome::{Collision, CollisionEnergy, CollisionError, Outcome, Start, Tolerance, check_size, positive};
use super::record::{Held, MAX_HISTORY, Moment, Record, State, check_moments, largest_force, moments};
use crate::contact::PairSize;
use crate::contact::normal::{Normal, NormalInput, NormalLaw, NormalResponse, NormalVisitor};

/// A head-on collision to be computed.
#[derive(Clone, Copy, Debug)]
pub struct HeadOn<'a, L> {
    /// Normal law.
    pub law: &'a L,
    /// Effective radius and mass.
    pub size: PairSize,
    /// Relative speed at the start [m/s].
    pub speed: f64,
    /// Where the speed is given.
    pub start: Start,
}

/// Restitution of a head-on collision that starts at first touch, to the default tolerance; 0 when the bodies stick.
pub fn restitution_of<L: Normal>(law: &L, size: PairSize, speed: f64) -> Result<f64, CollisionError> {
    let start = Start::Contact;
    let impact = HeadOn {
        law,
        size,
        speed,
        start,
    };
    Ok(impact.run(&Tolerance::default())?.restitution)
}

impl<L: Normal> HeadOn<'_, L> {
    /// Computes the collision.
    pub fn run(&self, tolerance: &Tolerance) -> Result<Collision, CollisionError> {
        Ok(self.run_recorded(tolerance, 0)?.0)
    }

    /// Computes the collision, with so many moments at equal distances in time (none for 0).
    pub fn run_recorded(
        &self,
        tolerance: &Tolerance,
        count: usize,
    ) -> Result<(Collision, Vec<Moment>), CollisionError> {
        let pair = Pair {
            law: self.law,
            size: self.size,
        };
        check_moments(count)?;
        let mut course = Course::new(&pair, self, tolerance)?;
        let outcome = course.finish()?;
        let recorded = match count {
            0 => Vec::new(),
            _ => moments(&course.records, &pair, count),
        };
        Ok((course.told(outcome), recorded))
    }
}

/// A collision under any law.
struct Run<'a>(&'a HeadOn<'a, NormalLaw>, &'a Tolerance, usize);

impl NormalVisitor for Run<'_> {
    type Output = Result<(Collision, Vec<Moment>), CollisionError>;

    fn visit<L: Normal>(self, law: &L) -> Self::Output {
        let HeadOn { size, speed, start, .. } = *self.0;
        let impact = HeadOn {
            law,
            size,
            speed,
            start,
        };
        impact.run_recorded(self.1, self.2)
    }
}

impl HeadOn<'_, NormalLaw> {
    /// Computes the collision.
    pub fn run(&self, tolerance: &Tolerance) -> Result<Collision, CollisionError> {
        Ok(self.run_recorded(tolerance, 0)?.0)
    }

    /// Computes the collision, with so many moments at equal distances in time (none for 0).
    pub fn run_recorded(
        &self,
        tolerance: &Tolerance,
        count: usize,
    ) -> Result<(Collision, Vec<Moment>), CollisionError> {
        self.law.visit(Run(self, tolerance, count))
    }
}

/// Two bodies and their law.
pub(super) struct Pair<'a, L> {
    pub law: &'a L,
    pub size: PairSize,
}

/// Overlap that stands for none, as share of the radius: the limit of a force that jumps at first touch.
const TOUCH: f64 = 1e-60;

/// Most of the energy of an impact that may be stored where it begins.
const STORED_AT_START: f64 = 1e-12;

impl<L: Normal> Pair<'_, L> {
    fn respond(&self, held: &Held, overlap: f64, rate: f64) -> (NormalResponse, [f64; MAX_HISTORY]) {
        let mut history = held.history;
        let input = NormalInput::at(self.size, overlap.max(held.floor), rate);
        let response = self.law.respond(&input, &mut history[..L::HISTORY.len()]);
        (response, history)
    }

    /// Total force [N].
    pub fn total(&self, held: &Held, overlap: f64, rate: f64) -> f64 {
        let response = self.respond(held, overlap, rate).0;
        response.elastic + response.damping * rate
    }

    /// Derivative of the state.
    pub fn rates(&self, held: &Held, &[overlap, rate, _]: &State) -> State {
        let response = self.respond(held, overlap, rate).0;
        let dashpot = response.damping * rate;
        [rate, -(response.elastic + dashpot) / self.size.mass, dashpot * rate]
    }

    /// What the law holds after a straight move to an overlap.
    fn hold(&self, before: &Held, overlap: f64, rate: f64) -> Held {
        let (response, history) = self.respond(before, overlap, rate);
        let end = -self.law.reach(self.size, &history[..L::HISTORY.len()]);
        Held {
            history,
            end,
            floor: self.just_inside(end),
            least: response.least,
        }
    }

    /// What the law holds of a contact that is new.
    fn new_contact(&self) -> Held {
        let history = [0.0; MAX_HISTORY];
        let end = -self.law.reach(self.size, &history[..L::HISTORY.len()]);
        Held {
            history,
            end,
            floor: self.just_inside(end),
            least: f64::NEG_INFINITY,
        }
    }

    /// An overlap beyond an end by as little as makes a difference.
    fn just_inside(&self, end: f64) -> f64 {
        end + (4.0 * f64::EPSILON * end.abs()).max(TOUCH * self.size.radius)
    }

    fn stored(&self, held: &Held, overlap: f64) -> f64 {
        self.law.energy(self.size, overlap, &held.history[..L::HISTORY.len()])
    }
}

/// What a step ended on.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Event {
    /// The rate of approach is zero.
    Reversal,
    /// The bodies are out of reach, or the force is the least that the law allows.
    End,
}

/// A restitution above 1 by as little is rounding.
const ROUNDING: f64 = 1e-11;

fn without_gain(restitution: f64) -> f64 {
    if restitution > 1.0 && restitution < 1.0 + ROUNDING {
        1.0
    } else {
        restitution
    }
}

/// Below this share of the largest speed and force so far the bodies are at rest.
const REST: f64 = 1e-10;

/// A collision on its way.
pub(super) struct Course<'p, 'a, L> {
    pair: &'p Pair<'a, L>,
    tolerance: Tolerance,
    speed: f64,
    stored_before: f64,
    time: f64,
    state: State,
    held: Held,
    /// 1 while approaching, -1 while separating.
    direction: f64,
    /// Length of the next step [s].
    next: f64,
    largest_speed: f64,
    largest_force: f64,
    max_overlap: f64,
    steps: usize,
    pub(super) records: Vec<Record>,
}

impl<'p, 'a, L: Normal> Course<'p, 'a, L> {
    pub(super) fn new(
        pair: &'p Pair<'a, L>,
        impact: &HeadOn<'_, L>,
        tolerance: &Tolerance,
    ) -> Result<Self, CollisionError> {
        const {
            assert!(
                L::HISTORY.len() <= MAX_HISTORY,
                "a normal law remembers more than is kept here"
            )
        };
        let size = impact.size;
        check_size(size)?;
        positive("speed", impact.speed)?;
        let tolerance = tolerance.checked()?;
        let held = pair.new_contact();
        let overlap = match impact.start {
            Start::Contact => held.floor.max(TOUCH * size.radius),
            Start::Far => held.floor,
        };
        if !overlap.is_finite() {
            return Err(CollisionError::Endless { reach: -held.end });
        }
        let scales = [
            size.radius / impact.speed,
            pair.law.collision_time(size, 1e-3 * size.radius),
        ];
        let shortest = scales.into_iter().filter(|t| t.is_finite() && *t > 0.0);
        let state = [overlap, impact.speed, 0.0];
        let stored_before = pair.stored(&held, if impact.start == Start::Contact { 0.0 } else { held.end });
        let energy = 0.5 * size.mass * impact.speed * impact.speed;
        // an attraction across a gap makes any speed one that can be told
        let pushes = held.end == 0.0 && pair.stored(&held, overlap) - stored_before > STORED_AT_START * energy;
        if pushes || energy < f64::MIN_POSITIVE / tolerance.relative {
            let speed = impact.speed;
            return Err(CollisionError::TooSlow { speed, energy });
        }
        // a law that notes the impact speed must see it
        let held = pair.hold(&held, overlap, impact.speed);
        Ok(Self {
            pair,
            tolerance,
            speed: impact.speed,
            stored_before,
            time: 0.0,
            state,
            held,
            direction: 1.0,
            next: 1e-3 * shortest.fold(f64::INFINITY, f64::min),
            largest_speed: impact.speed,
            largest_force: 0.0,
            max_overlap: overlap,
            steps: 0,
            records: Vec::with_capacity(128),
        })
    }

    /// Goes through every reversal, up to a time, rest or the end of contact.
    pub(super) fn follow(&mut self, until: f64) -> Result<(), CollisionError> {
        while self.steps < self.tolerance.max_steps {
            self.steps += 1;
            self.next = self.next.min(until - self.time);
            let Some((length, end, event)) = self.try_step()? else {
                continue;
            };
            self.accept(length, end, event);
            // what is left of the time is below its rounding
            if event == Some(Event::End) || self.is_at_rest() || until - self.time <= 1e-12 * until {
                return Ok(());
            }
            if event == Some(Event::Reversal) {
                if self.force() == 0.0 {
                    return Ok(());
                }
                self.direction = -self.direction;
            }
        }
        Err(self.endless())
    }

    fn finish(&mut self) -> Result<Outcome, CollisionError> {
        while self.steps < self.tolerance.max_steps {
            self.steps += 1;
            let Some((length, end, event)) = self.try_step()? else {
                continue;
            };
            self.accept(length, end, event);
            match event {
                Some(Event::End) => return Ok(Outcome::Rebound),
                Some(Event::Reversal) if self.direction < 0.0 => return Ok(Outcome::Stick),
                Some(Event::Reversal) => {
                    if self.force() == 0.0 {
                        return Ok(Outcome::Stick);
                    }
                    self.direction = -1.0;
                }
                None if self.is_at_rest() => return Ok(Outcome::Stick),
                None => {}
            }
        }
        Err(self.endless())
    }

    fn endless(&self) -> CollisionError {
        CollisionError::Steps {
            steps: self.steps,
            time: self.time,
            overlap: self.state[0],
            rate: self.state[1],
        }
    }

    fn force(&self) -> f64 {
        self.pair.total(&self.held, self.state[0], self.state[1])
    }

    fn is_at_rest(&self) -> bool {
        self.state[1].abs() <= REST * self.largest_speed && self.force().abs() <= REST * self.largest_force
    }

    /// One trial; nothing when it must be done again with a shorter step.
    fn try_step(&mut self) -> Result<Option<(f64, State, Option<Event>)>, CollisionError> {
        let (pair, held, state, relative) = (self.pair, self.held, self.state, self.tolerance.relative);
        let h = self.next;
        let speed = self.largest_speed;
        let allowed = [
            relative * self.max_overlap.max(state[0].abs()).max(speed * h),
            relative * speed,
            relative * 0.5 * pair.size.mass * speed * speed,
        ];
        let trial = |h: f64| ode::step(|y| pair.rates(&held, y), &state, h, &allowed);
        // a step as short as the rounding of the time cannot be made better
        let shortest = 4.0 * f64::EPSILON * self.time;
        let mut length = h;
        let mut tried = trial(h);
        if tried.error > 1.0 && h > shortest {
            return self.shorten(h, tried.error);
        }
        let mut event = None;
        let approach = |y: &State| self.direction * y[1];
        if approach(&tried.end) <= 0.0 {
            if state[1] == 0.0 {
                // it left the reversal that it starts from and came back to another
                self.next = 0.25 * h;
                return Ok(None);
            }
            length = ode::locate(
                |h| approach(&trial(h).end),
                (0.0, approach(&state)),
                (h, approach(&tried.end)),
            );
            tried = trial(length);
            tried.end[1] = 0.0;
            event = Some(Event::Reversal);
        }
        if self.direction < 0.0 {
            let room = |y: &State| {
                let force = if held.least.is_finite() {
                    pair.total(&held, y[0], y[1]) - held.least
                } else {
                    f64::INFINITY
                };
                let distance = y[0] - held.end;
                // both are zero at their end; only the sign and the zero matter
                if force <= 0.0 {
                    force
                } else if distance <= 0.0 {
                    distance
                } else {
                    force.min(distance)
                }
            };
            if room(&tried.end) <= 0.0 {
                length = ode::locate(|h| room(&trial(h).end), (0.0, room(&state)), (length, room(&tried.end)));
                tried = trial(length);
                event = Some(Event::End);
            }
        }
        if tried.error > 1.0 && length > shortest {
            return self.shorten(length, tried.error);
        }
        let growth = if event.is_some() {
            1.0
        } else {
            ode::step_factor(tried.error)
        };
        self.next = growth * h.max(f64::MIN_POSITIVE);
        Ok(Some((length, tried.end, event)))
    }

    fn shorten<T>(&mut self, h: f64, error: f64) -> Result<Option<T>, CollisionError> {
        self.next = h * ode::step_factor(error).min(0.8);
        if self.next > 0.0 {
            return Ok(None);
        }
        Err(CollisionError::NotFinite {
            overlap: self.state[0],
            rate: self.state[1],
        })
    }

    fn accept(&mut self, length: f64, end: State, event: Option<Event>) {
        let force = self.force();
        self.records.push(Record {
            time: self.time,
            length,
            state: self.state,
            held: self.held,
            force,
        });
        self.time += length;
        self.state = end;
        if event == Some(Event::End) && self.held.least.is_infinite() {
            self.state[0] = self.held.end;
        }
        self.held = self.pair.hold(&self.held, end[0], end[1]);
        self.largest_speed = self.largest_speed.max(end[1].abs());
        self.largest_force = self.largest_force.max(force.abs());
        self.max_overlap = self.max_overlap.max(end[0]);
    }

    fn told(&self, outcome: Outcome) -> Collision {
        let [overlap, rate, viscous] = self.state;
        let kinetic = |speed: f64| 0.5 * self.pair.size.mass * speed * speed;
        let stored = self.pair.stored(&self.held, overlap);
        let (stored_after, relaxed) = match outcome {
            Outcome::Stick => (stored, 0.0),
            Outcome::Rebound if self.held.least.is_infinite() => (0.0, 0.0),
            // where contact ends at zero force the spring relaxes against the dashpot alone
            Outcome::Rebound => (0.0, stored),
        };
        let mut energy = CollisionEnergy {
            kinetic_before: kinetic(self.speed),
            kinetic_after: kinetic(rate),
            viscous: viscous + relaxed,
            lost: 0.0,
            stored_before: self.stored_before,
            stored_after,
        };
        energy.lost = energy.kinetic_before + energy.stored_before
            - (energy.kinetic_after + energy.stored_after + energy.viscous);
        Collision {
            outcome,
            restitution: match outcome {
                Outcome::Rebound => without_gain(-rate / self.speed),
                Outcome::Stick => 0.0,
            },
            duration: self.time,
            max_overlap: self.max_overlap,
            max_force: largest_force(&self.records, self.pair).max(self.force()),
            max_speed: self.largest_speed,
            final_overlap: overlap,
            energy,
            steps: self.steps,
        }
    }
}
