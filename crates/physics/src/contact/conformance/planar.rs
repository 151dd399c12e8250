//! Friction and rolling laws seen as one kind: a load in the contact plane that answers a rate of deformation.

use super::cases::{PAIRS, Random, SIZES, Units, values};
use super::tested;
use crate::contact::normal::HertzTsuji;
use crate::contact::normal::{Normal, NormalInput};
use crate::contact::rolling::{Rolling, RollingInput, RollingLaw, RollingVisitor};
use crate::contact::tangential::{Tangential, TangentialInput, TangentialLaw, TangentialVisitor};
use crate::contact::{LawInfo, MaterialPair, PairSize};
use crate::dimension::Dimension;
use crate::integrator::Integrator;
use glam::{DQuat, DVec3};

/// What drives a law over one step; a velocity and a force for friction, an angular velocity and a torque for rolling.
#[derive(Clone, Copy, Debug)]
pub struct PlanarInput {
    pub size: PairSize,
    pub inertia: f64,
    pub overlap: f64,
    pub normal_stiffness: f64,
    pub normal: DVec3,
    pub rate: DVec3,
    pub spin: f64,
    pub normal_force: f64,
    pub dt: f64,
}

impl PlanarInput {
    /// As friction sees it.
    pub fn friction(&self) -> TangentialInput {
        TangentialInput {
            size: self.size,
            overlap: self.overlap,
            normal: self.normal,
            velocity: self.rate,
            spin: self.spin,
            normal_force: self.normal_force,
            dt: self.dt,
            removable_share: Integrator::VelocityVerlet.removable_share(),
        }
    }

    /// As rolling resistance sees it.
    pub fn rolling(&self) -> RollingInput {
        RollingInput {
            size: self.size,
            rolling_inertia: self.inertia,
            normal: self.normal,
            angular_velocity: self.rate,
            twist: 0.0,
            spin: self.spin,
            normal_force: self.normal_force,
            normal_stiffness: self.normal_stiffness,
            dt: self.dt,
            removable_share: Integrator::VelocityVerlet.removable_share(),
        }
    }
}

/// What a law answers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlanarResponse {
    pub load: DVec3,
    pub dissipated: f64,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PlanarLaw {
    Friction(TangentialLaw),
    Rolling(RollingLaw),
}

impl PlanarLaw {
    fn build(info: &LawInfo, values: &crate::parameters::Values, pair: &MaterialPair) -> Self {
        match info.family {
            "tangential" => Self::Friction(TangentialLaw::build(info.name, values, pair).unwrap()),
            _ => Self::Rolling(RollingLaw::build(info.name, values, pair).unwrap()),
        }
    }
}

struct Respond<'a>(PlanarInput, &'a mut [f64]);

impl TangentialVisitor for Respond<'_> {
    type Output = PlanarResponse;
    fn visit<L: Tangential>(self, law: &L) -> PlanarResponse {
        let response = law.respond(&self.0.friction(), self.1);
        PlanarResponse {
            load: response.force,
            dissipated: response.dissipated,
        }
    }
}

impl RollingVisitor for Respond<'_> {
    type Output = PlanarResponse;
    fn visit<L: Rolling>(self, law: &L) -> PlanarResponse {
        let response = law.respond(&self.0.rolling(), self.1);
        PlanarResponse {
            load: response.torque,
            dissipated: response.dissipated,
        }
    }
}

struct Energy<'a>(&'a [f64]);

impl TangentialVisitor for Energy<'_> {
    type Output = f64;
    fn visit<L: Tangential>(self, law: &L) -> f64 {
        law.energy(self.0)
    }
}

impl RollingVisitor for Energy<'_> {
    type Output = f64;
    fn visit<L: Rolling>(self, law: &L) -> f64 {
        law.energy(self.0)
    }
}

struct Stiffness(PlanarInput);

impl TangentialVisitor for Stiffness {
    type Output = f64;
    fn visit<L: Tangential>(self, law: &L) -> f64 {
        law.stiffness(self.0.size, self.0.overlap)
    }
}

impl RollingVisitor for Stiffness {
    type Output = f64;
    fn visit<L: Rolling>(self, law: &L) -> f64 {
        law.stiffness(self.0.size, self.0.normal_stiffness)
    }
}

/// A law with what it was built from and the contact that it is tested in.
#[derive(Clone, Copy)]
pub struct PlanarCase {
    pub info: &'static LawInfo,
    pub law: PlanarLaw,
    pub pair: MaterialPair,
    pub size: PairSize,
}

impl PlanarCase {
    pub fn is_friction(&self) -> bool {
        matches!(self.law, PlanarLaw::Friction(_))
    }

    pub fn name(&self) -> String {
        format!("{} at radius {} m", self.info.name, self.size.radius)
    }

    /// The same law built anew.
    pub fn rebuilt(&self, replaced: &[(&str, f64)]) -> Self {
        Self {
            law: PlanarLaw::build(self.info, &values(self.info, replaced), &self.pair),
            ..*self
        }
    }

    /// The same law in other units.
    pub fn in_units(&self, units: Units) -> Self {
        let scaled = super::cases::scaled_values(self.info, &values(self.info, &[]), units);
        Self {
            law: PlanarLaw::build(self.info, &scaled, &units.pair(&self.pair)),
            size: units.size(self.size),
            ..*self
        }
    }

    pub fn history(&self) -> Vec<f64> {
        vec![0.0; self.info.history]
    }

    pub fn respond(&self, input: &PlanarInput, history: &mut [f64]) -> PlanarResponse {
        match &self.law {
            PlanarLaw::Friction(law) => law.visit(Respond(*input, history)),
            PlanarLaw::Rolling(law) => law.visit(Respond(*input, history)),
        }
    }

    pub fn energy(&self, history: &[f64]) -> f64 {
        match &self.law {
            PlanarLaw::Friction(law) => law.visit(Energy(history)),
            PlanarLaw::Rolling(law) => law.visit(Energy(history)),
        }
    }

    /// Stiffness in the contact plane; 0 for a law without a spring.
    pub fn stiffness(&self, input: &PlanarInput) -> f64 {
        match &self.law {
            PlanarLaw::Friction(law) => law.visit(Stiffness(*input)),
            PlanarLaw::Rolling(law) => law.visit(Stiffness(*input)),
        }
    }

    /// Largest load that the law's coefficient of friction allows, if it has one.
    pub fn limit(&self, input: &PlanarInput) -> Option<f64> {
        let typical = |name: &str| self.info.parameters.iter().find(|p| p.name == name).map(|p| p.typical);
        if self.is_friction() {
            Some(typical("friction")? * input.normal_force)
        } else {
            Some(typical("rolling_friction")? * self.size.radius * input.normal_force)
        }
    }

    /// A Hertzian contact of this size at rest, `overlap_share` of the radius deep, with steps much shorter than its
    /// period.
    pub fn at_rest(&self, overlap_share: f64) -> PlanarInput {
        let elastic = HertzTsuji::new(&crate::parameters::values(&[("restitution", 1.0)]), &self.pair).unwrap();
        let overlap = overlap_share * self.size.radius;
        let mass = self.size.mass;
        let response = elastic.respond(&NormalInput::at(self.size, overlap, 0.0), &mut []);
        PlanarInput {
            size: self.size,
            inertia: if self.is_friction() {
                self.size.tangential_mass()
            } else {
                1.4 * mass * self.size.radius * self.size.radius
            },
            overlap,
            normal_stiffness: elastic.stiffness(self.size, overlap, &[]),
            normal: DVec3::Z,
            rate: DVec3::ZERO,
            spin: 0.0,
            normal_force: response.elastic,
            dt: 0.01 * elastic.collision_time(self.size, 1e-3 * self.size.radius),
        }
    }

    /// A rate at which this contact reaches its limit in about ten steps.
    pub fn rate_scale(&self, input: &PlanarInput) -> f64 {
        let limit = self.limit(input).unwrap_or(input.normal_force);
        let stiffness = self.stiffness(input);
        if stiffness > 0.0 {
            limit / (10.0 * stiffness * input.dt)
        } else {
            limit * input.dt / input.inertia
        }
    }

    /// A smooth path in the contact plane over `period`, in `steps` steps: sticking, sliding, turning back, while the
    /// overlap comes and goes. `time` is where in the period a step lies.
    pub fn smooth_drive(&self, seed: u64, steps: u32) -> Vec<PlanarInput> {
        let mut random = Random(seed);
        let phases = [0.0; 8].map(|_| random.between(0.0, std::f64::consts::TAU));
        let reference = self.at_rest(1e-3);
        let scale = self.rate_scale(&reference);
        let period = 200.0 * reference.dt;
        (0..steps)
            .map(|step| {
                let time = f64::from(step) / f64::from(steps);
                let wave = |k: usize| libm::sin(std::f64::consts::TAU * (k as f64 + 1.0) * time + phases[k]);
                PlanarInput {
                    rate: DVec3::new(wave(0) + wave(2), wave(1) + 0.5 * wave(3), 0.0) * scale,
                    dt: period / f64::from(steps),
                    ..self.at_rest(1e-3 * (1.0 + 0.4 * wave(4) + 0.3 * wave(5)))
                }
            })
            .collect()
    }

    /// A rough path: as the smooth one, with a normal force that jumps from step to step, a normal that wanders and a
    /// spin about it.
    pub fn rough_drive(&self, seed: u64, steps: u32) -> Vec<PlanarInput> {
        let mut random = Random(!seed);
        let mut tilt = DQuat::IDENTITY;
        let mut drive = self.smooth_drive(seed, steps);
        for input in &mut drive {
            let turn = DVec3::new(random.between(-1.0, 1.0), random.between(-1.0, 1.0), 0.0);
            tilt = crate::integrator::rotate(tilt, turn, 0.02);
            let kick = 10f64.powf(random.between(-1.0, 1.0));
            *input = PlanarInput {
                normal: tilt * input.normal,
                rate: tilt * input.rate * kick,
                spin: random.between(-1.0, 1.0) * 0.02 / input.dt,
                normal_force: input.normal_force * random.between(0.0, 1.5),
                ..*input
            };
        }
        drive
    }
}

/// Dimension of the load, and of the rate that drives it.
pub fn load_and_rate(case: &PlanarCase) -> (Dimension, Dimension) {
    if case.is_friction() {
        (Dimension::FORCE, Dimension::VELOCITY)
    } else {
        (Dimension::ENERGY, Dimension::FREQUENCY)
    }
}

/// Every friction and rolling law for every pair of materials and every size.
pub fn planar_cases(replaced: &[(&str, f64)]) -> Vec<PlanarCase> {
    use crate::contact::{rolling, tangential};
    let mut cases = Vec::new();
    for info in tested(tangential::LAWS).chain(tested(rolling::LAWS)) {
        for pair in PAIRS {
            let law = PlanarLaw::build(info, &values(info, replaced), &pair);
            cases.extend(SIZES.map(|size| PlanarCase { info, law, pair, size }));
        }
    }
    cases
}

/// Those of the cases that have a spring.
pub fn spring_cases(replaced: &[(&str, f64)]) -> Vec<PlanarCase> {
    let mut cases = planar_cases(replaced);
    cases.retain(|case| case.stiffness(&case.at_rest(1e-3)) > 0.0);
    cases
}
