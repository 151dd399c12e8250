//! What a law with given parameters would show where something was measured.

use crate::calibrate::CalibrateError;
use crate::calibrate::pull::{largest_pull, press};
use crate::materials::Material;
use crate::scenario::{Body, FitFile, Observable, Observation, Partner, Target, pair_size};
use demeter_physics::collision::ode::locate;
use demeter_physics::collision::{Collision, HeadOn, Outcome, Tolerance, sticking_speed_of};
use demeter_physics::contact::normal::{Normal, NormalLaw, NormalVisitor};
use demeter_physics::contact::{MaterialPair, PairSize};

/// Integration of a trial; a contact that creeps apart for longer is given up.
const TOLERANCE: Tolerance = Tolerance {
    relative: 1e-13,
    max_steps: 20_000,
};

/// A critical velocity is bracketed to 1e-7 only, by many collisions.
const STICKING_TOLERANCE: Tolerance = Tolerance {
    relative: 1e-10,
    ..TOLERANCE
};

/// What bodies that stick show of a rebound, so that a search can tell nearer from farther.
const NO_REBOUND: f64 = 1e-6;

/// Parameters to observations.
#[derive(Clone, Copy, Debug)]
pub(super) struct Model<'a> {
    pub file: &'a FitFile,
}

impl Model<'_> {
    /// The materials with these values of the unknowns.
    pub fn materials(&self, values: &[f64]) -> Vec<Material> {
        let mut materials = self.file.materials.clone();
        for (unknown, &value) in self.file.unknown.iter().zip(values) {
            match unknown.target {
                Target::YoungModulus(index) => materials[index].young_modulus = value,
                Target::PoissonRatio(index) => materials[index].poisson_ratio = value,
                Target::Parameter(_) => {}
            }
        }
        materials
    }

    /// The law with these values of the unknowns.
    pub fn law(&self, values: &[f64]) -> Result<NormalLaw, CalibrateError> {
        let materials = self.materials(values);
        let mut parameters = self.file.known.clone();
        for (unknown, &value) in self.file.unknown.iter().zip(values) {
            if let Target::Parameter(name) = unknown.target {
                parameters.insert(name.to_string(), value.into());
            }
        }
        let elastic = |body: u16| materials[usize::from(body)].elastic();
        let pair = MaterialPair {
            a: elastic(self.file.a.material),
            b: elastic(self.file.b.material()),
        };
        Ok(NormalLaw::build(self.file.law.name, &parameters, &pair)?)
    }

    /// Logarithms of everything that was measured, in the order of the file.
    pub fn logarithms(&self, values: &[f64]) -> Result<Vec<f64>, CalibrateError> {
        let law = self.law(values)?;
        let mut logarithms = Vec::new();
        for observation in &self.file.observations {
            let mut scene = Scene::new(self, &law, observation)?;
            for measured in &observation.measured {
                let value = scene.observe(measured.observable)?;
                logarithms.push(libm::log(value.max(f64::MIN_POSITIVE)));
            }
        }
        Ok(logarithms)
    }
}

/// Depth of a dent after which bodies are pulled apart to see whether anything holds them, over the effective radius.
const DEEP: f64 = 1e-2;
/// A pull below this share of the force at that depth is rounding.
const NO_PULL: f64 = 1e-14;

/// Whether a law pulls bodies of these sizes together, before or after a load.
struct Adhesion(PairSize);

impl NormalVisitor for Adhesion {
    type Output = bool;

    fn visit<L: Normal>(self, law: &L) -> bool {
        let (size, depth) = (self.0, DEEP * self.0.radius);
        let mut loaded = vec![0.0; L::HISTORY.len()];
        let touching = press(law, size, &mut loaded, TOUCH * size.radius, f64::MIN_POSITIVE);
        let least = NO_PULL * press(law, size, &mut loaded, depth, f64::MIN_POSITIVE).abs();
        let end = -law.reach(size, &loaded);
        -touching > least || largest_pull(law, size, &loaded, (depth, end)).force > least
    }
}

/// Whether the bodies of an observation attract each other under a law.
pub(super) fn adheres(law: &NormalLaw, observation: &Observation) -> bool {
    law.visit(Adhesion(size_of(&observation.a, &observation.b)))
}

/// Whether a law acts across a gap between bodies that have not touched yet.
pub(super) fn acts_across_a_gap(law: &NormalLaw, size: PairSize) -> bool {
    law.visit(Untouched(size)) > 0.0
}

struct Untouched(PairSize);

impl NormalVisitor for Untouched {
    type Output = f64;

    fn visit<L: Normal>(self, law: &L) -> f64 {
        law.reach(self.0, &vec![0.0; L::HISTORY.len()])
    }
}

/// Two bodies and what was done to them.
pub(super) struct Scene<'a> {
    law: &'a NormalLaw,
    size: PairSize,
    observation: &'a Observation,
    start: demeter_physics::collision::Start,
    collision: Option<Collision>,
}

impl<'a> Scene<'a> {
    pub fn new(model: &Model<'_>, law: &'a NormalLaw, observation: &'a Observation) -> Result<Self, CalibrateError> {
        let size = size_of(&observation.a, &observation.b);
        law.visit(Check(size)).map_err(CalibrateError::Refused)?;
        Ok(Self {
            law,
            size,
            observation,
            start: model.file.start,
            collision: None,
        })
    }

    fn collision(&mut self) -> Result<Collision, CalibrateError> {
        if let Some(known) = self.collision {
            return Ok(known);
        }
        let impact = HeadOn {
            law: self.law,
            size: self.size,
            speed: self.observation.velocity.unwrap_or(f64::NAN),
            start: self.start,
        };
        let found = impact.run(&TOLERANCE)?;
        self.collision = Some(found);
        Ok(found)
    }

    /// What is seen; something very small where there is nothing of the kind.
    pub fn observe(&mut self, observable: Observable) -> Result<f64, CalibrateError> {
        Ok(match observable {
            Observable::Restitution => self.collision()?.restitution.max(NO_REBOUND),
            Observable::ContactTime => {
                let found = self.collision()?;
                match found.outcome {
                    Outcome::Rebound => found.duration,
                    Outcome::Stick => found.duration / NO_REBOUND,
                }
            }
            Observable::MaxOverlap => self.collision()?.max_overlap,
            Observable::MaxForce => self.collision()?.max_force,
            Observable::StickingVelocity => {
                sticking_speed_of(self.law, self.size, self.start, &STICKING_TOLERANCE)?.below()
            }
            Observable::PullOffForce => self.law.visit(PullOff(self.size, self.observation.preload)),
        })
    }
}

/// Effective radius and mass of the bodies of an observation.
pub(super) fn size_of(a: &Body, b: &Partner) -> PairSize {
    pair_size(a, b)
}

struct Check(PairSize);

impl NormalVisitor for Check {
    type Output = Result<(), String>;
    fn visit<L: Normal>(self, law: &L) -> Self::Output {
        law.check(self.0)
    }
}

/// Largest pull of two bodies that are slowly pulled apart after a load.
struct PullOff(PairSize, Option<f64>);

/// Overlap of a mere touch, over the effective radius.
const TOUCH: f64 = 1e-12;
impl NormalVisitor for PullOff {
    type Output = f64;

    fn visit<L: Normal>(self, law: &L) -> f64 {
        let Self(size, preload) = self;
        let load = |history: &mut [f64], overlap: f64| press(law, size, history, overlap, f64::MIN_POSITIVE);
        let touched = || {
            let mut history = vec![0.0; L::HISTORY.len()];
            load(&mut history, TOUCH * size.radius);
            history
        };
        let depth = match preload {
            None => TOUCH * size.radius,
            Some(force) => {
                let excess = |overlap: f64| load(&mut touched(), overlap) - force;
                if excess(size.radius) > 0.0 {
                    locate(&excess, (0.0, -force), (size.radius, excess(size.radius)))
                } else {
                    size.radius
                }
            }
        };
        let mut loaded = touched();
        load(&mut loaded, depth);
        // a law without adhesion ends at zero; one with a dent ends before; one with a tail far beyond
        let end = -law.reach(size, &loaded);
        largest_pull(law, size, &loaded, (depth, end)).force
    }
}
