//! Two bodies in the engine: they come, touch, and part or stick.

use super::error::CalibrateError;
use crate::contacts::laws::normal_energy;
use crate::contacts::{ContactChunk, Coupling};
use crate::materials::{Material, Materials};
use crate::particles::{Domain, Grains, NewGrain, Outside};
use crate::scenario::{ImpactFile, Partner};
use crate::simulation::{Energies, Setup, Simulation, Skin, WallPartner, shortest_time_scale};
use crate::walls::{Motion, Shape, Wall};
use demeter_physics::collision::{Moment, Outcome, Start};
use demeter_physics::contact::normal::{Normal, NormalInput, NormalVisitor};
use demeter_physics::contact::{PairLaw, PairSize};
use demeter_physics::integrator::Integrator;
use glam::DVec3;

/// A held sphere is so much heavier than the one that moves.
const HELD: f64 = 1e12;

/// The bodies start this many steps before they first feel each other.
const RUN_UP: f64 = 2.5;

/// Distance beyond touching at which bodies become candidates, as a share of the smaller radius.
const SKIN_SHARE: f64 = 0.2;

/// The largest overlap of bodies that part is at least so many times the rounding of their places.
const ABOVE_ROUNDING: f64 = 1e5;

/// Most steps of one flight.
const MAX_STEPS: u64 = 5_000_000;

/// Two bodies on their way, and what became of them.
#[derive(Clone, Debug)]
pub(super) struct Flight {
    pub outcome: Outcome,
    /// Time from the first to the last force [s].
    pub contact_time: f64,
    pub max_overlap: f64,
    pub max_force: f64,
    /// Velocities and spins of both bodies at the end; those of a wall are zero.
    pub velocity: [DVec3; 2],
    pub spin: [DVec3; 2],
    pub before: Energies,
    pub after: Energies,
    pub steps: u64,
    /// Every step in contact.
    pub moments: Vec<Moment>,
}

/// Velocity of the first body of an impact.
pub(super) fn impact_velocity(file: &ImpactFile, speed: f64) -> DVec3 {
    let angle = file.impact.angle;
    DVec3::new(libm::sin(angle), 0.0, -libm::cos(angle)) * speed
}

/// What a flight is made of.
pub(super) struct Launch<'a> {
    pub file: &'a ImpactFile,
    pub law: &'a PairLaw,
    /// Relative speed [m/s].
    pub speed: f64,
    /// Largest overlap, as share of the smaller radius.
    pub max_overlap: f64,
}

impl Launch<'_> {
    fn smaller_radius(&self) -> f64 {
        let a = self.file.a.radius;
        self.file.b.body().map_or(a, |b| a.min(b.radius))
    }

    fn size(&self) -> PairSize {
        self.file.size()
    }

    /// Shortest time scale of the laws [s].
    pub fn time_scale(&self) -> Result<f64, CalibrateError> {
        let (materials, grains, walls) = self.bodies(0.0)?;
        let walls: Vec<WallPartner> = walls.iter().map(WallPartner::of).collect();
        Ok(shortest_time_scale(&grains, &walls, &materials, self.max_overlap)?.time)
    }

    /// Gap across which bodies feel each other that have not touched yet [m].
    pub(super) fn reach(&self) -> f64 {
        let new = vec![0.0; self.law.normal.info().history];
        reach(self.law, self.size(), &new)
    }

    /// Where the law first acts, as a gap [m], and the speed to have there.
    fn start(&self, dt: f64) -> (f64, f64) {
        let size = self.size();
        let normal_speed = self.speed * libm::cos(self.file.impact.angle);
        let run_up = RUN_UP * dt * normal_speed;
        let new = vec![0.0; self.law.normal.info().history];
        match self.file.impact.start {
            Start::Far => (reach(self.law, size, &new) + run_up, self.speed),
            Start::Contact => {
                // an attraction across the gap must have brought it to the speed asked for when they touch
                let stored = |overlap: f64| normal_energy(self.law, size, overlap, &new);
                let gained = 2.0 * (stored(-run_up) - stored(0.0)) / size.mass;
                let squared = self.speed * self.speed - gained;
                if squared > 0.25 * self.speed * self.speed {
                    (run_up, squared.sqrt())
                } else {
                    (0.0, self.speed)
                }
            }
        }
    }

    fn bodies(&self, dt: f64) -> Result<(Materials, Grains, Vec<Wall>), CalibrateError> {
        let file = self.file;
        let mut list: Vec<Material> = file.materials.clone();
        let held = list.len();
        let original = |index: usize| {
            if index == held {
                usize::from(file.b.material())
            } else {
                index
            }
        };
        if let Partner::Fixed(body) = file.b {
            let mut material = list[usize::from(body.material)].clone();
            material.density *= HELD * (file.a.mass / body.mass).max(1.0);
            list.push(material);
        }
        let materials = Materials::new(list, |a, b| file.contact.choice(original(a), original(b)))
            .map_err(|error| file.refused("contact", error.to_string()))?;
        let (gap, speed) = self.start(dt);
        let velocity = impact_velocity(file, speed);
        let mut grains = Grains::default();
        let touching = DVec3::Z * (file.a.radius + file.b.body().map_or(0.0, |b| b.radius));
        let before = if velocity.z < 0.0 {
            velocity * (gap / velocity.z)
        } else {
            DVec3::Z * gap
        };
        let mut add = |id: u32, material: u16, radius: f64, position: DVec3, velocity: DVec3, spin: DVec3| {
            let density = materials.list()[usize::from(material)].density;
            let grain = NewGrain {
                fixed: false,
                material,
                radius,
                density,
                position,
                velocity,
                angular_velocity: spin,
            };
            grains.push(id, &grain);
        };
        let (spin_a, spin_b) = (file.impact.spin_a, file.impact.spin_b);
        // `velocity.z` is negative: the step back along the path is `velocity` times a negative time
        add(1, file.a.material, file.a.radius, touching + before, velocity, spin_a);
        let mut walls = Vec::new();
        match file.b {
            Partner::Free(b) => add(2, b.material, b.radius, DVec3::ZERO, DVec3::ZERO, spin_b),
            Partner::Fixed(b) => add(2, held as u16, b.radius, DVec3::ZERO, DVec3::ZERO, spin_b),
            Partner::Wall(material) => {
                let shape = Shape::Plane {
                    point: DVec3::ZERO,
                    normal: DVec3::Z,
                };
                let wall = Wall::new("b", material, shape, Motion::Rest);
                walls.push(wall.map_err(|error| file.refused("b", error.to_string()))?);
            }
        }
        Ok((materials, grains, walls))
    }

    /// Lets the bodies fly at this time step.
    pub fn fly(&self, dt: f64) -> Result<Flight, CalibrateError> {
        let (materials, grains, walls) = self.bodies(dt)?;
        let far = 1e3 * (grains.position[0].length() + self.file.a.radius);
        let mut sim = Simulation::new(Setup {
            grains,
            walls,
            materials,
            domain: Domain {
                lower: DVec3::splat(-far),
                upper: DVec3::splat(far),
                periodic: [false; 3],
                outside: Outside::Stop,
            },
            gravity: DVec3::ZERO,
            dt,
            skin: Skin::Fixed(SKIN_SHARE * self.smaller_radius()),
            max_overlap: self.max_overlap,
            integrator: Integrator::default(),
            coupling: Coupling::default(),
        });
        sim.start()?;
        let before = sim.energies();
        let mut track = Track::default();
        let outcome = loop {
            sim.step()?;
            if let Some(outcome) = track.watch(self, &sim) {
                break outcome;
            }
            if sim.step >= MAX_STEPS {
                let (steps, time) = (sim.step, sim.time());
                let across_a_gap = self.reach() > 0.0 && self.file.impact.start == Start::Far;
                return Err(CalibrateError::Steps {
                    steps,
                    dt,
                    time,
                    across_a_gap,
                });
            }
        };
        let mut after = sim.energies();
        let grains = &sim.grains;
        let of = |values: &crate::particles::Rows, id: u32| {
            let index = grains.id.iter().position(|i| *i == id);
            index.map_or(DVec3::ZERO, |k| values[k])
        };
        let velocity = [1, 2].map(|id| of(&grains.velocity, id));
        let spin = [1, 2].map(|id| of(&grains.angular_velocity, id));
        let (max_overlap, max_force) = track.largest();
        let rounding = f64::EPSILON * (self.file.a.radius + self.file.b.body().map_or(0.0, |b| b.radius));
        if outcome == Outcome::Rebound && max_overlap < ABOVE_ROUNDING * rounding {
            let overlap = max_overlap;
            return Err(CalibrateError::Rounding { overlap, rounding });
        }
        let mut before = before;
        if let Partner::Fixed(_) = self.file.b {
            // the rest energy of a spin that is held is none of the collision's
            let held = grains
                .id
                .iter()
                .position(|i| *i == 2)
                .map_or(0.0, |k| grains.inertia(k));
            before.rotational -= 0.5 * held * self.file.impact.spin_b.length_squared();
            after.rotational -= 0.5 * held * spin[1].length_squared();
        }
        Ok(Flight {
            outcome,
            contact_time: track.contact_time(self),
            max_overlap,
            max_force,
            velocity,
            spin,
            before,
            after,
            steps: sim.step,
            moments: track.moments,
        })
    }
}

/// Gap beyond which a contact with this history exerts no force [m].
fn reach(law: &PairLaw, size: PairSize, history: &[f64]) -> f64 {
    struct Reach<'a>(PairSize, &'a [f64]);
    impl NormalVisitor for Reach<'_> {
        type Output = f64;
        fn visit<L: Normal>(self, law: &L) -> f64 {
            law.reach(self.0, &self.1[..law.history()])
        }
    }
    law.normal.visit(Reach(size, history))
}

/// By how much the total force is above the least that the law allows [N].
struct BeyondLeast<'a>(&'a NormalInput, &'a [f64]);

impl NormalVisitor for BeyondLeast<'_> {
    type Output = f64;
    fn visit<L: Normal>(self, law: &L) -> f64 {
        let response = law.respond(self.0, &mut self.1[..law.history()].to_vec());
        response.elastic + response.damping * self.0.rate - response.least
    }
}

/// The steps of a flight.
#[derive(Default)]
struct Track {
    /// Steps from the last one before the first force to the first one after the last.
    moments: Vec<Moment>,
    /// What the normal law remembers at every moment.
    histories: Vec<Vec<f64>>,
    touched: bool,
    separating: bool,
}

impl Track {
    /// Notes a step; the outcome when there is one.
    fn watch(&mut self, launch: &Launch<'_>, sim: &Simulation) -> Option<Outcome> {
        let index = |id: u32| sim.grains.id.iter().position(|i| *i == id);
        let a = index(1)?;
        let (overlap, rate) = match index(2) {
            Some(b) => {
                let separation = sim.grains.position[a] - sim.grains.position[b];
                let distance = separation.length();
                let velocity = sim.grains.velocity[a] - sim.grains.velocity[b];
                let overlap = sim.grains.radius(a) + sim.grains.radius(b) - distance;
                (overlap, -velocity.dot(separation) / distance)
            }
            None => (
                sim.grains.radius(a) - sim.grains.position[a].z,
                -sim.grains.velocity[a].z,
            ),
        };
        let stride = sim.contacts.stride;
        let chunks = || sim.contacts.pairs.iter().chain(&sim.contacts.walls);
        let active: Option<&ContactChunk> = chunks().find(|chunk| chunk.engaged() > 0);
        let force = active.map_or(0.0, |chunk| chunk.normal_force(0));
        let history = active.map_or_else(
            || vec![0.0; launch.law.normal.info().history],
            |chunk| chunk.history(0, stride).to_vec(),
        );
        let moment = Moment {
            time: sim.time(),
            overlap,
            rate,
            force,
        };
        if force == 0.0 && !self.touched {
            self.moments.clear();
            self.histories.clear();
        }
        self.moments.push(moment);
        self.histories.push(history);
        self.touched |= force != 0.0;
        if !self.touched {
            return None;
        }
        if active.is_none() && rate < 0.0 {
            return Some(Outcome::Rebound);
        }
        if rate < 0.0 {
            self.separating = true;
        } else if self.separating && active.is_some() {
            return Some(Outcome::Stick);
        }
        None
    }

    /// Largest overlap and force, between steps by parabolas.
    fn largest(&self) -> (f64, f64) {
        let values = |of: fn(&Moment) -> f64| self.moments.iter().map(of).collect::<Vec<f64>>();
        (peak(&values(|m| m.overlap)), peak(&values(|m| m.force)))
    }

    /// Time from the first to the last force, between steps by the path of the overlap.
    fn contact_time(&self, launch: &Launch<'_>) -> f64 {
        let (moments, size) = (&self.moments, launch.size());
        let Some(last) = moments.iter().rposition(|m| m.force != 0.0) else {
            return 0.0;
        };
        let begin = match launch.file.impact.start {
            Start::Contact => 0.0,
            Start::Far => -reach(launch.law, size, &self.histories[0]),
        };
        let start = crossing(moments, |overlap, _| overlap - begin, 1.0).unwrap_or(moments[0].time);
        // the step of the last force may have let go already
        let history = &self.histories[last.saturating_sub(1)];
        let end = -reach(launch.law, size, history);
        let room = |overlap: f64, rate: f64| {
            let input = NormalInput::at(size, overlap, rate);
            let beyond_least = launch.law.normal.visit(BeyondLeast(&input, history));
            beyond_least.min(overlap - end)
        };
        let stop = crossing(moments, room, -1.0).unwrap_or(moments[last].time);
        stop - start
    }
}

/// Largest of equally spaced values, between them by a parabola.
fn peak(values: &[f64]) -> f64 {
    let Some(k) = (0..values.len()).max_by(|&a, &b| values[a].total_cmp(&values[b])) else {
        return 0.0;
    };
    if k == 0 || k + 1 == values.len() {
        return values[k];
    }
    let (left, middle, right) = (values[k - 1], values[k], values[k + 1]);
    let (slope, bend) = (0.5 * (right - left), left - 2.0 * middle + right);
    if bend < 0.0 {
        middle - 0.5 * slope * slope / bend
    } else {
        middle
    }
}

/// Time at which a value of overlap and rate passes zero: the first time upwards, the last time downwards. Between steps the overlap is a
/// cubic.
fn crossing(moments: &[Moment], value: impl Fn(f64, f64) -> f64, direction: f64) -> Option<f64> {
    let of = |moment: &Moment| value(moment.overlap, moment.rate);
    let passes = |pair: &&[Moment]| direction * of(&pair[0]) <= 0.0 && direction * of(&pair[1]) > 0.0;
    let pair = if direction > 0.0 {
        moments.windows(2).find(passes)?
    } else {
        moments.windows(2).rfind(passes)?
    };
    let (one, two) = (pair[0], pair[1]);
    let dt = two.time - one.time;
    let between = |s: f64| {
        let (p, q) = (s * s * (3.0 - 2.0 * s), s * (1.0 - s));
        let overlap = one.overlap * (1.0 - p) + two.overlap * p + dt * q * (one.rate * (1.0 - s) - two.rate * s);
        value(overlap, one.rate * (1.0 - s) + two.rate * s)
    };
    let place = demeter_physics::collision::ode::locate(between, (0.0, of(&one)), (1.0, of(&two)));
    Some(one.time + place * dt)
}
