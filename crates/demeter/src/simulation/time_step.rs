//! The time step: a stated share of the shortest time scale of the laws in use.

use crate::contacts::laws;
use crate::materials::Materials;
use crate::particles::Grains;
use crate::walls::{FreeMotion, Wall};
use demeter_physics::contact::normal::{Normal, NormalInput, NormalVisitor};
use demeter_physics::contact::rolling::{Rolling, RollingVisitor};
use demeter_physics::contact::spring::dashpot;
use demeter_physics::contact::tangential::{Tangential, TangentialVisitor};
use demeter_physics::contact::{PairLaw, PairSize};
use demeter_physics::integrator::Integrator;
use std::f64::consts::PI;

/// The automatic time step is this share of the shortest time scale: the energy of an elastic gas is then kept within 1e-6
/// (`verification::elastic_gas`).
pub const SAFE_SHARE: f64 = 0.005;

/// Head-on restitution is met within this at the automatic time step; the error grows with the square of the step
/// (`verification::longer_steps`).
pub const RESTITUTION_ERROR: f64 = 3e-5;

/// Above this share of the shortest time scale a time step is refused unless the scenario says it wants it.
///
/// The predictor-corrector is stable only as long as no motion decays by more than 0.163 of itself per step: a bed of
/// linear grains of restitution 0.05 comes to rest at 0.01 and explodes at 0.02 (`verification::gear`).
pub fn unsafe_share(integrator: Integrator) -> f64 {
    match integrator {
        Integrator::VelocityVerlet => 0.05,
        Integrator::Gear => 0.01,
    }
}

/// A time scale and where it comes from.
#[derive(Clone, Debug, PartialEq)]
pub struct TimeScale {
    /// Time [s].
    pub time: f64,
    /// In words: `"collision of two grains of glass (hertz-tsuji) at an overlap of 0.05 r"`.
    pub origin: String,
    /// What the springs against sliding and rolling bear where grains have many neighbours.
    pub springs: Bearable,
}

/// The longest time step that some springs bear.
#[derive(Clone, Debug, PartialEq)]
pub struct Bearable {
    /// Time step [s]; infinite without springs.
    pub step: f64,
    /// Which springs, in words.
    pub origin: String,
}

/// What a time step is beside those that are safe.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// It is not above the automatic one.
    Safe,
    /// It is stable, and less exact, as [`TimeScale::cost`] tells.
    Long,
    /// It is refused unless a scenario says that it wants it.
    Unsafe,
}

impl TimeScale {
    /// A time step [s] beside this scale, in words.
    pub fn beside(&self, dt: f64) -> String {
        let share = if dt < self.time {
            format!("1/{:.0} of", self.time / dt)
        } else {
            format!("{:.3} times", dt / self.time)
        };
        let Bearable { step, origin } = &self.springs;
        let springs = if dt > step * (1.0 - 1e-9) {
            format!("; where grains have many neighbours, {origin} bear {step:.4e} s at most")
        } else {
            String::new()
        };
        format!(
            "{dt:.4e} s, {share} the shortest time scale, {:.4e} s: {}{springs}",
            self.time, self.origin
        )
    }

    /// The automatic time step [s]: [`SAFE_SHARE`] of the time scale, or what the springs bear.
    pub fn automatic(&self) -> f64 {
        (SAFE_SHARE * self.time).min(self.springs.step)
    }

    /// What a time step [s] above the automatic one costs, in words.
    pub fn cost(&self, dt: f64, integrator: Integrator) -> String {
        let automatic = self.automatic();
        let times = dt / automatic;
        let cost = if self.judge(dt, integrator) == Verdict::Unsafe {
            "it may be unstable".to_string()
        } else {
            let errors = times * times;
            format!(
                "errors of collisions and of the energy are about {errors:.1} times as large, and head-on restitution is met within {:.1e}",
                RESTITUTION_ERROR * errors
            )
        };
        format!(
            "{times:.3} times the automatic one ({automatic:.4e} s): {cost}; {}",
            self.beside(dt)
        )
    }

    /// The longest time step that is not refused [s].
    pub fn largest(&self, integrator: Integrator) -> f64 {
        (unsafe_share(integrator) * self.time).min(self.springs.step)
    }

    /// Judges a time step; what it is by rounding alone does not count.
    pub fn judge(&self, dt: f64, integrator: Integrator) -> Verdict {
        let above = |limit: f64| dt > limit * (1.0 + 1e-9);
        if above(self.largest(integrator)) {
            Verdict::Unsafe
        } else if above(self.automatic()) {
            Verdict::Long
        } else {
            Verdict::Safe
        }
    }

    /// The shorter of both times, and the springs that bear the shorter step.
    pub(crate) fn or_shorter(mut self, other: Self) -> Self {
        if other.springs.step < self.springs.step {
            self.springs = other.springs;
        }
        // a scale that is not a number must win, so that it is told
        let is_longer = other.time >= self.time;
        if !is_longer {
            (self.time, self.origin) = (other.time, other.origin);
        }
        self
    }

    fn if_usable(self) -> Result<Self, TimeStepError> {
        let dt = self.automatic();
        if self.time.is_finite() && dt > 0.0 && dt.is_normal() {
            return Ok(self);
        }
        let Self { time, origin, springs } = self;
        if springs.step < SAFE_SHARE * time {
            let Bearable { step, origin } = springs;
            return Err(TimeStepError::NothingBorne { step, origin });
        }
        Err(TimeStepError::Unusable { time, origin })
    }
}

/// Why there is no automatic time step.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum TimeStepError {
    /// The step is no positive number.
    #[error("a time step of {dt} s is none; it must be finite and above 0")]
    NotPositive {
        /// The step [s].
        dt: f64,
    },
    /// There is no contact whose time scale could be asked.
    #[error("an automatic time step needs grains: there is none, so give `time_step` a value such as \"1e-5 s\"")]
    NoGrains,
    /// The time scale is not a usable number.
    #[error(
        "the shortest time scale, {origin}, is {time} s, which is no usable number: check the moduli, stiffnesses, masses and \
         radii of these bodies"
    )]
    Unusable {
        /// The time scale [s].
        time: f64,
        /// Where it comes from.
        origin: String,
    },
    /// The time step that springs bear is not a usable number.
    #[error(
        "{origin} bear a time step of {step} s at most, which is no usable number: check the moduli, stiffnesses, masses and radii of \
         these bodies"
    )]
    NothingBorne {
        /// The time step [s].
        step: f64,
        /// Which springs.
        origin: String,
    },
}

/// A wall as far as time scales go.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WallPartner {
    /// Its material.
    pub material: u16,
    /// Least mass with which it gives way to a push [kg]; infinite where it does not.
    pub mass: f64,
}

impl WallPartner {
    /// A wall as it moves now; one that moves with another is not told by it.
    pub fn of(wall: &Wall) -> Self {
        Self {
            material: wall.material,
            mass: wall.least_mass(),
        }
    }
}

/// What a grain touches.
#[derive(Clone, Copy)]
pub(super) enum Partner {
    Grain(Representative),
    Wall { mass: f64 },
}

/// A grain as far as time scales go.
#[derive(Clone, Copy)]
pub(super) struct Representative {
    pub(super) radius: f64,
    mass: f64,
    inertia: f64,
}

/// Shortest time scale of all laws between the materials in use, at overlaps up to `max_overlap` of the smaller
/// radius.
pub fn shortest_time_scale(
    grains: &Grains,
    walls: &[WallPartner],
    materials: &Materials,
    max_overlap: f64,
) -> Result<TimeScale, TimeStepError> {
    let mut shortest: Option<TimeScale> = None;
    each_contact(grains, walls, materials, |pair, one, other| {
        let scale = of_contact(materials, pair, one, other, max_overlap);
        shortest = Some(match shortest.take() {
            None => scale,
            Some(known) => known.or_shorter(scale),
        });
    });
    shortest.ok_or(TimeStepError::NoGrains)?.if_usable()
}

/// The shorter of a time scale and those of the springs and dampers of a wall that moves freely.
pub fn with_free_wall(scale: TimeScale, wall: &str, free: &FreeMotion) -> Result<TimeScale, TimeStepError> {
    let scales = [
        (
            2.0 * PI * (free.inertia / free.stiffness).sqrt(),
            "oscillation",
            "spring",
        ),
        // a damper that is critical to a spring decays within half of its period by this measure
        (2.0 * PI * free.inertia / free.damping, "decay", "damper"),
    ];
    let strengths = [free.stiffness, free.damping];
    let of_wall = scales
        .into_iter()
        .zip(strengths)
        .filter(|(_, strength)| *strength > 0.0);
    of_wall
        .map(|(scale, _)| scale)
        .try_fold(scale, |shortest, (time, what, part)| {
            if time >= shortest.time {
                return Ok(shortest);
            }
            let origin = format!("{what} of wall `{wall}` on its {part}");
            TimeScale {
                time,
                origin,
                ..shortest
            }
            .if_usable()
        })
}

/// Largest gap across which any law acts between the bodies in use [m].
pub(crate) fn largest_reach(grains: &Grains, walls: &[WallPartner], materials: &Materials) -> f64 {
    let mut largest = 0.0f64;
    each_contact(grains, walls, materials, |(a, b), one, other| {
        let law = materials.law(materials.pair(a, b));
        largest = largest.max(laws::largest_reach(law, pair_size(one, other)));
    });
    largest
}

/// What the laws refuse to do for the sizes in use, as `(material, material, why)`.
pub fn refusals(grains: &Grains, walls: &[WallPartner], materials: &Materials) -> Vec<(u16, u16, String)> {
    struct Check(PairSize);
    impl NormalVisitor for Check {
        type Output = Result<(), String>;
        fn visit<L: Normal>(self, law: &L) -> Self::Output {
            law.check(self.0)
        }
    }
    let mut refused: Vec<(u16, u16, String)> = Vec::new();
    each_contact(grains, walls, materials, |(a, b), one, other| {
        let (a, b) = (a.min(b), a.max(b));
        let law = materials.law(materials.pair(a, b));
        if let Err(why) = law.normal.visit(Check(pair_size(one, other)))
            && refused.iter().all(|r| (r.0, r.1) != (a, b))
        {
            refused.push((a, b, why));
        }
    });
    refused
}

/// Visits contacts between all materials in use, of grains of extreme sizes and masses, and with the walls.
pub(super) fn each_contact(
    grains: &Grains,
    walls: &[WallPartner],
    materials: &Materials,
    mut visit: impl FnMut((u16, u16), Representative, Partner),
) {
    let count = materials.list().len() as u16;
    let used: Vec<(u16, Vec<Representative>)> = (0..count)
        .map(|m| (m, representatives(grains, m)))
        .filter(|(_, r)| !r.is_empty())
        .collect();
    for (k, (a, grains_a)) in used.iter().enumerate() {
        for (b, grains_b) in &used[k..] {
            for one in grains_a {
                for other in grains_b {
                    visit((*a, *b), *one, Partner::Grain(*other));
                }
            }
        }
        for wall in walls {
            for one in grains_a {
                visit((*a, wall.material), *one, Partner::Wall { mass: wall.mass });
            }
        }
    }
}

/// Effective radius and mass.
pub(super) fn pair_size(one: Representative, other: Partner) -> PairSize {
    let (radius, mass) = match other {
        Partner::Grain(other) => (other.radius, other.mass),
        Partner::Wall { mass } => (f64::INFINITY, mass),
    };
    let pair = PairSize::new(
        1.0 / (1.0 / one.radius + 1.0 / radius),
        1.0 / (1.0 / one.mass + 1.0 / mass),
    );
    match other {
        Partner::Grain(_) => pair,
        Partner::Wall { .. } => PairSize {
            spring_mass: one.mass,
            ..pair
        },
    }
}

/// The smallest and the largest grain of a material, and the lightest.
fn representatives(grains: &Grains, material: u16) -> Vec<Representative> {
    let of = |g: usize| Representative {
        radius: grains.radius(g),
        mass: grains.mass(g),
        inertia: grains.inertia(g),
    };
    let members = || (0..grains.len()).filter(|&g| grains.material[g] == material);
    let smallest = members().min_by(|&a, &b| grains.radius(a).total_cmp(&grains.radius(b)));
    let largest = members().max_by(|&a, &b| grains.radius(a).total_cmp(&grains.radius(b)));
    let lightest = members().min_by(|&a, &b| grains.mass(a).total_cmp(&grains.mass(b)));
    [smallest, largest, lightest].into_iter().flatten().map(of).collect()
}

fn of_contact(
    materials: &Materials,
    (a, b): (u16, u16),
    one: Representative,
    other: Partner,
    max_overlap: f64,
) -> TimeScale {
    let law = materials.law(materials.pair(a, b));
    let size = pair_size(one, other);
    let rolling = |g: Representative| 1.0 / (g.inertia + g.mass * g.radius * g.radius);
    let (rolling_of_other, turning_of_other) = match other {
        Partner::Grain(other) => (rolling(other), 1.0 / other.inertia),
        Partner::Wall { .. } => (0.0, 0.0),
    };
    let overlap = max_overlap * smaller_radius(one, other);
    let inertia = Inertia {
        rolling: 1.0 / (rolling(one) + rolling_of_other),
        turning: 1.0 / (1.0 / one.inertia + turning_of_other),
    };
    let (time, what, springs) = time_scale(law, size, inertia, overlap);
    let bodies = in_words(materials, (a, b), other);
    TimeScale {
        time,
        origin: format!("{what} of {bodies} at an overlap of {max_overlap} r"),
        springs: Bearable {
            step: springs.step,
            origin: format!("{} between {bodies}", springs.origin),
        },
    }
}

/// The smaller radius of two grains, or that of a grain at a wall [m].
pub(super) fn smaller_radius(one: Representative, other: Partner) -> f64 {
    match other {
        Partner::Grain(other) => one.radius.min(other.radius),
        Partner::Wall { .. } => one.radius,
    }
}

/// Two bodies of materials in words.
pub(super) fn in_words(materials: &Materials, (a, b): (u16, u16), other: Partner) -> String {
    let name = |m: u16| materials.list()[m as usize].name.as_str();
    match other {
        Partner::Grain(_) if a == b => format!("two grains of `{}`", name(a)),
        Partner::Grain(_) => format!("a grain of `{}` and one of `{}`", name(a), name(b)),
        Partner::Wall { mass } if mass.is_finite() => {
            let (grain, wall) = (name(a), name(b));
            format!("a grain of `{grain}` and a wall of `{wall}` that gives way as {mass:.3e} kg do")
        }
        Partner::Wall { .. } => format!("a grain of `{}` and a wall of `{}`", name(a), name(b)),
    }
}

/// Effective moments of inertia of two bodies: that roll on each other, and that turn about centres that stay.
#[derive(Clone, Copy)]
struct Inertia {
    rolling: f64,
    turning: f64,
}

/// Shortest time scale of the laws of one contact [s], what it is, and what its springs bear.
fn time_scale(law: &PairLaw, size: PairSize, inertia: Inertia, overlap: f64) -> (f64, String, Bearable) {
    let mut springs = Bearable {
        step: f64::INFINITY,
        origin: String::new(),
    };
    let mut bear = |step: f64, law: &str| {
        if step < springs.step {
            let origin = format!("the springs of `{law}`");
            springs = Bearable { step, origin };
        }
    };
    let period = |inertia: f64, stiffness: f64| 2.0 * PI * (inertia / stiffness).sqrt();
    let collision = law.normal.visit(CollisionTime(size, overlap));
    let mut shortest = (collision, format!("collision (`{}`)", law.normal.info().name));
    let mut consider = |time: f64, what: String| {
        if time < shortest.0 {
            shortest = (time, what);
        }
    };
    let coefficient = law.normal.visit(Dashpot(size, overlap));
    if coefficient > 0.0 {
        consider(
            DASHPOTS * size.mass / coefficient,
            format!("decay in the dashpot (`{}`)", law.normal.info().name),
        );
    }
    if let Some(friction) = law.tangential {
        let (stiffness, mass) = (friction.visit(Stiffness(size, overlap)), size.tangential_mass());
        let name = friction.info().name;
        consider(period(mass, stiffness), format!("tangential oscillation (`{name}`)"));
        let damping = dashpot(friction.visit(DampingRatio), stiffness, mass);
        bear(
            longest_borne(SLIDING * stiffness / mass, SLIDING * damping / mass),
            name,
        );
    }
    if let Some(resistance) = law.rolling {
        let normal_stiffness = law.normal.visit(Stiffness(size, overlap));
        let stiffness = resistance.visit(Stiffness(size, normal_stiffness));
        let name = resistance.info().name;
        let Inertia { rolling, turning } = inertia;
        consider(period(rolling, stiffness), format!("rolling oscillation (`{name}`)"));
        let damping = dashpot(resistance.visit(DampingRatio), stiffness, rolling);
        bear(
            longest_borne(ROLLING * stiffness / turning, ROLLING * damping / turning),
            name,
        );
    }
    (shortest.0, shortest.1, springs)
}

/// Time scale of a dashpot over `m/c`. With the longest time step that is allowed, a twentieth of it, `x = c dt/(2 m)` is 0.15. Contacts
/// are damped one by one, and the velocity of a grain among twelve that move against it takes a factor `1 - 8 x/(1 + x)` per step.
const DASHPOTS: f64 = 6.0;

/// Stiffness over inertia of twelve neighbours that all turn alike, or against each other, over that of one contact: `12 (2/3) (2 R)^2 k`
/// over `2/5 m R^2`, and `k` over `m/7`, as the tangential mass of two spheres is.
const SLIDING: f64 = 40.0 / 7.0;

/// The same of springs against rolling, of grains that all turn against their neighbours: `12 (2/3) 2 k` over `I`, and `k` over `I/2`.
const ROLLING: f64 = 8.0;

/// Longest time step `t` at which springs with dashpots are stable [s].
///
/// Rates are foreseen with the forces of the step before. With `W = stiffness/inertia t^2` and `L = damping/inertia t`
/// their oscillation is stable up to `L = 1`; without dashpots it grows by `0.14 W^2` per step, of which dashpots take
/// `L/2`. What has none may grow by 5e-5.
fn longest_borne(stiffness_over_inertia: f64, damping_over_inertia: f64) -> f64 {
    let (frequency, decay) = (stiffness_over_inertia.sqrt(), damping_over_inertia);
    let outweighed = libm::cbrt(2.5 * decay / (stiffness_over_inertia * stiffness_over_inertia));
    let held = outweighed.max(0.14 / frequency).min(1.0 / frequency);
    held.min(0.9 / decay)
}

/// Share of critical damping of a spring.
struct DampingRatio;

impl TangentialVisitor for DampingRatio {
    type Output = f64;
    fn visit<L: Tangential>(self, law: &L) -> f64 {
        law.damping_ratio()
    }
}

impl RollingVisitor for DampingRatio {
    type Output = f64;
    fn visit<L: Rolling>(self, law: &L) -> f64 {
        law.damping_ratio()
    }
}

/// Coefficient of the dashpot of a slow contact at an overlap [N s/m].
struct Dashpot(PairSize, f64);

impl NormalVisitor for Dashpot {
    type Output = f64;
    fn visit<L: Normal>(self, law: &L) -> f64 {
        let Self(size, overlap) = self;
        // of a contact that has just come to be
        law.respond(&NormalInput::at(size, overlap, 0.0), &mut vec![0.0; law.history()])
            .damping
    }
}

struct CollisionTime(PairSize, f64);

impl NormalVisitor for CollisionTime {
    type Output = f64;
    fn visit<L: Normal>(self, law: &L) -> f64 {
        law.collision_time(self.0, self.1)
    }
}

/// Stiffness at an overlap; for rolling laws, at a normal stiffness.
struct Stiffness(PairSize, f64);

impl NormalVisitor for Stiffness {
    type Output = f64;
    fn visit<L: Normal>(self, law: &L) -> f64 {
        // of a contact that has just come to be
        law.stiffness(self.0, self.1, &vec![0.0; law.history()])
    }
}

impl TangentialVisitor for Stiffness {
    type Output = f64;
    fn visit<L: Tangential>(self, law: &L) -> f64 {
        law.stiffness(self.0, self.1)
    }
}

impl RollingVisitor for Stiffness {
    type Output = f64;
    fn visit<L: Rolling>(self, law: &L) -> f64 {
        law.stiffness(self.0, self.1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Largest of what an oscillation with foreseen rates comes to, from a deformation of 1, in so many steps.
    fn reaches(stiffness: f64, damping: f64, dt: f64, steps: usize) -> f64 {
        let (mut deformation, mut velocity, mut force, mut largest) = (1.0f64, 0.0, 0.0, 0.0f64);
        for _ in 0..steps {
            let foreseen = velocity + 0.5 * dt * force;
            force = -stiffness * (deformation + 0.5 * dt * foreseen) - damping * foreseen;
            deformation += dt * foreseen;
            velocity += dt * force;
            largest = largest.max(deformation.abs());
        }
        largest
    }

    #[test]
    fn springs_hold_still_up_to_the_step_that_they_are_said_to_bear() {
        let stiffness = 3.0f64;
        for ratio in [0.001, 0.01, 0.03, 0.1, 0.3, 0.5, 1.0, 3.0] {
            let damping = 2.0 * ratio * stiffness.sqrt();
            let dt = longest_borne(stiffness, damping);
            let borne = reaches(stiffness, damping, dt, 20_000);
            assert!(borne < 1.3, "{ratio}: {borne}");
            let beyond = reaches(stiffness, damping, 2.0 * dt, 20_000);
            assert!(beyond > 10.0, "{ratio}: {beyond}");
        }
        let dt = longest_borne(stiffness, 0.0);
        assert!(reaches(stiffness, 0.0, dt, 2000) < 1.2);
        assert_eq!(longest_borne(0.0, 0.0), f64::INFINITY);
    }
}
