//! Waves on a ring of equal grains in a row that press on each other: every mode is known.

use crate::cases::{Case, Laws, law};
use demeter::contacts::Coupling;
use demeter::materials::{Material, Materials};
use demeter::particles::{Domain, Outside};
use demeter::simulation::Simulation;
use demeter_physics::DVec3;
use std::f64::consts::PI;

/// Grains of `E = 1`, `R = 1`, density 1 on the ring.
const COUNT: u32 = 8;
/// Distance of neighbours: a strain of 8 %.
const DISTANCE: f64 = 2.0 * 0.92;
/// Where on the ring the wave has its crests [rad].
const PHASE: f64 = 0.3;

/// A standing wave.
pub struct Wave {
    pub sim: Simulation,
    /// Phase between neighbours [rad].
    number: f64,
    /// Frequency with forces in agreement [rad/s].
    pub omega: f64,
    /// Share of a small change of force that comes back through the displacements.
    pub feedback: f64,
}

impl Wave {
    /// `number` crests around the ring, of a small amplitude.
    pub fn new(number: u32, coupling: Coupling, share: f64) -> Self {
        let number = 2.0 * PI * f64::from(number) / f64::from(COUNT);
        let sim = case(number, coupling, share).simulation();
        // influence of the opposite contact: sphere-to-sphere with theta = 180 degrees
        let influence = 1.5 / (4.0 * PI) * 2.0;
        let stiffness = 4.0 / 3.0 / (2.0 * 0.75) * 0.5f64.sqrt();
        let mut overlap = 2.0 - DISTANCE;
        for _ in 0..1000 {
            overlap = 2.0 - DISTANCE + 2.0 * influence * stiffness * overlap * overlap.sqrt();
        }
        let tangent = 1.5 * stiffness * overlap.sqrt();
        let feedback = 2.0 * influence * tangent * libm::cos(number);
        let coupled = tangent / (1.0 - feedback);
        let omega = 2.0 * libm::sin(0.5 * number) * (coupled / sim.grains().mass(0)).sqrt();
        Self {
            sim,
            number,
            omega,
            feedback,
        }
    }

    /// Energy of the mode, up to a factor.
    fn energy(&self) -> f64 {
        let (grains, mut place, mut speed) = (self.sim.grains(), 0.0, 0.0);
        for (k, id) in grains.id.iter().enumerate() {
            let site = f64::from(id - 1);
            let crest = libm::cos(self.number * site + PHASE);
            let around = f64::from(grains.crossings(k)[0]) * DISTANCE * f64::from(COUNT);
            place += crest * (grains.position[k].x + around - home(site));
            speed += crest * grains.velocity[k].x;
        }
        place * place * self.omega * self.omega + speed * speed
    }

    /// Rate at which the energy of the mode grows over ten periods, as a share of the frequency.
    pub fn growth(&mut self) -> f64 {
        self.sim.start().unwrap();
        let before = self.energy();
        let steps = (20.0 * PI / self.omega / self.sim.dt()).round();
        for _ in 0..steps as u64 {
            self.sim.step().unwrap();
        }
        libm::log(self.energy() / before) / (steps * self.sim.dt() * self.omega)
    }

    /// What the lag of a step makes of that rate: the force acts as `K x - K feedback/(1 - feedback) dt dx/dt`.
    pub fn growth_by_lag(&self) -> f64 {
        self.omega * self.sim.dt() * self.feedback / (1.0 - self.feedback)
    }
}

fn home(site: f64) -> f64 {
    DISTANCE * (site + 0.5)
}

fn case(number: f64, coupling: Coupling, share: f64) -> Case {
    let grains = Material {
        name: "grains".into(),
        young_modulus: 1.0,
        poisson_ratio: 0.5,
        density: 1.0,
    };
    let mut laws = Laws::hertz(1.0);
    laws.0.multi_contact = Some(law("sphere-to-sphere", &[]));
    let mut case = Case::new(Materials::new(vec![grains], |_, _| laws.0.clone()).unwrap());
    case.coupling = coupling;
    case.max_overlap = 0.3;
    case.skin = 0.2;
    case.share = share;
    case.domain = Domain {
        lower: DVec3::new(0.0, -10.0, -10.0),
        upper: DVec3::new(DISTANCE * f64::from(COUNT), 10.0, 10.0),
        periodic: [true, false, false],
        outside: Outside::Stop,
    };
    for site in 0..COUNT {
        let site = f64::from(site);
        let shift = 1e-4 * libm::cos(number * site + PHASE);
        case.grain(1.0, DVec3::X * (home(site) + shift), DVec3::ZERO);
    }
    case
}
