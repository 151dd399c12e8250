//! A wall that moves freely: mass or inertia, weight, spring, damper and stops on one coordinate.
//!
//! The scheme is that of the grains, velocity Verlet with the velocity predicted for the contact laws: half kick and drift
//! before the forces of a step are known, the correcting kick when they are. The damper acts explicitly in the first half and
//! implicitly in the second, so that it never gains energy.

use super::motion::{FreeMotion, Freedom};
use super::pose::rotation_about;
use glam::DVec3;
use serde::{Deserialize, Serialize};

/// State of a freely moving wall.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct FreeBody {
    motion: FreeMotion,
    /// Way or angle since the motion was told [m or rad].
    pub(super) coordinate: f64,
    /// Its rate; between the two halves of a step, that predicted for its end.
    pub(super) speed: f64,
    /// Rate in the middle of the step [m/s or 1/s].
    half: f64,
    /// Time step whose second half is still to come [s]; 0: none.
    pending: f64,
    /// Load of the grains along the coordinate in the latest step [N or N m].
    load: f64,
    /// Lost in the damper and at the stops in the latest step [J].
    dissipated: f64,
}

impl FreeBody {
    pub(super) fn new(motion: FreeMotion) -> Self {
        Self {
            motion,
            coordinate: 0.0,
            speed: motion.speed,
            half: motion.speed,
            pending: 0.0,
            load: 0.0,
            dissipated: 0.0,
        }
    }

    pub(super) fn motion(&self) -> &FreeMotion {
        &self.motion
    }

    /// First half of a step.
    pub(super) fn advance(&mut self, dt: f64) {
        let m = self.motion;
        let before = self.energy();
        let gain = 0.5 * dt / m.inertia;
        self.half = self.speed + gain * (self.load + self.own_force() - m.damping * self.speed);
        self.coordinate += dt * self.half;
        self.pending = dt;
        let [lower, upper] = m.stops;
        if self.coordinate < lower || self.coordinate > upper {
            self.coordinate = self.coordinate.clamp(lower, upper);
            (self.half, self.speed) = (0.0, 0.0);
            self.dissipated = before - self.energy();
            return;
        }
        self.dissipated = m.damping * self.half * self.half * dt;
        self.speed = self.half + gain * (self.load + self.own_force() - m.damping * self.half);
    }

    /// Second half of a step, with the load of the grains along the coordinate at its end.
    pub(super) fn settle(&mut self, load: f64) {
        self.load = load;
        let gain = 0.5 * self.pending / self.motion.inertia;
        if self.pending > 0.0 {
            let speed = (self.half + gain * (load + self.own_force())) / (1.0 + gain * self.motion.damping);
            self.speed = if self.leaves_its_stops(speed) { 0.0 } else { speed };
        }
        self.pending = 0.0;
    }

    /// Inverse of the mass with which the wall gives way to a push along a direction at a point [1/kg]; 0 where a stop holds it.
    pub(super) fn inverse_mass(&self, point: DVec3, direction: DVec3) -> f64 {
        let lever = match self.motion.freedom {
            Freedom::Slide { axis } => axis.dot(direction),
            Freedom::Hinge { point: hinge, axis, .. } => axis.dot((point - hinge).cross(direction)),
        };
        let [lower, upper] = self.motion.stops;
        let is_held = self.coordinate <= lower && lever < 0.0 || self.coordinate >= upper && lever > 0.0;
        if is_held {
            0.0
        } else {
            lever * lever / self.motion.inertia
        }
    }

    fn leaves_its_stops(&self, speed: f64) -> bool {
        let [lower, upper] = self.motion.stops;
        self.coordinate <= lower && speed < 0.0 || self.coordinate >= upper && speed > 0.0
    }

    /// Force of weight and spring along the coordinate [N or N m].
    fn own_force(&self) -> f64 {
        let m = &self.motion;
        let weight = match m.freedom {
            Freedom::Slide { axis } => axis.dot(m.weight),
            Freedom::Hinge { axis, .. } => axis.dot(self.arm(self.coordinate).cross(m.weight)),
        };
        weight - m.stiffness * self.coordinate
    }

    /// From the hinge to the centre of mass [m].
    fn arm(&self, angle: f64) -> DVec3 {
        match self.motion.freedom {
            Freedom::Slide { .. } => DVec3::ZERO,
            Freedom::Hinge {
                point,
                axis,
                center_of_mass,
            } => rotation_about(axis, angle) * (center_of_mass - point),
        }
    }

    /// Kinetic energy [J].
    pub(super) fn kinetic(&self) -> f64 {
        0.5 * self.motion.inertia * self.speed * self.speed
    }

    /// Kinetic energy, and that of the weight and the spring, 0 where the wall stood when the motion was told [J].
    pub(super) fn energy(&self) -> f64 {
        let (m, q) = (&self.motion, self.coordinate);
        let risen = match m.freedom {
            Freedom::Slide { axis } => axis * q,
            Freedom::Hinge { .. } => self.arm(q) - self.arm(0.0),
        };
        self.kinetic() + 0.5 * m.stiffness * q * q - m.weight.dot(risen)
    }

    /// Lost in the damper and at the stops in the latest step [J].
    pub(super) fn dissipated(&self) -> f64 {
        self.dissipated
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{FRAC_PI_2, PI};

    const FREE: FreeMotion = FreeMotion {
        freedom: Freedom::Slide { axis: DVec3::Z },
        inertia: 2.0,
        weight: DVec3::new(0.0, 0.0, -20.0),
        stiffness: 0.0,
        damping: 0.0,
        speed: 0.0,
        stops: [f64::NEG_INFINITY, f64::INFINITY],
    };

    fn run(motion: FreeMotion, dt: f64, steps: u32) -> (FreeBody, f64) {
        let (mut body, mut lost) = (FreeBody::new(motion), 0.0);
        for _ in 0..steps {
            body.advance(dt);
            body.settle(0.0);
            lost += body.dissipated();
        }
        (body, lost)
    }

    #[test]
    fn a_slide_falls_as_galilei_says() {
        let (body, _) = run(FREE, 1e-3, 1000);
        assert!((body.coordinate + 5.0).abs() < 1e-12, "{}", body.coordinate);
        assert!((body.speed + 10.0).abs() < 1e-12 && body.energy().abs() < 1e-10);
    }

    /// A quarter of the period of a pendulum is the time from its turning point to its lowest.
    #[test]
    fn a_flap_swings_with_the_period_of_a_pendulum() {
        // a uniform plate of length 0.3 m about its edge: I = m L^2/3, centre of mass at L/2; released at 60 degrees
        let (mass, long, g) = (0.5, 0.3, 9.81);
        let start = PI / 3.0;
        let flap = FreeMotion {
            freedom: Freedom::Hinge {
                point: DVec3::ZERO,
                axis: -DVec3::Y,
                center_of_mass: DVec3::new(libm::sin(start), 0.0, -libm::cos(start)) * (0.5 * long),
            },
            inertia: mass * long * long / 3.0,
            weight: DVec3::new(0.0, 0.0, -mass * g),
            ..FREE
        };
        // T = 4 sqrt(I/(m g a)) K(sin(start/2)), K by the arithmetic-geometric mean
        let (mut a, mut b) = (1.0, libm::cos(0.5 * start));
        for _ in 0..6 {
            (a, b) = (0.5 * (a + b), libm::sqrt(a * b));
        }
        let period = 4.0 * libm::sqrt(long / 1.5 / g) * FRAC_PI_2 / a;
        let steps = 20_000;
        let (body, _) = run(flap, period / f64::from(steps), steps);
        // back at the turning point: an error of the period by 1e-6 would show as 1e-11, so look at the speed as well
        assert!(body.coordinate.abs() < 1e-7, "{}", body.coordinate);
        assert!(body.speed.abs() < 1e-5, "{}", body.speed);
        let (body, _) = run(flap, period / f64::from(steps), steps / 4);
        assert!((body.coordinate + start).abs() < 1e-5, "{}", body.coordinate);
        assert!(body.energy().abs() < 1e-6 * body.kinetic());
    }

    #[test]
    fn a_damper_takes_what_the_spring_gives() {
        let damped = FreeMotion {
            stiffness: 800.0,
            damping: 8.0,
            speed: 1.0,
            weight: DVec3::ZERO,
            ..FREE
        };
        let dt = 1e-4;
        let (body, lost) = run(damped, dt, 10_000);
        assert!((lost + body.energy() - 1.0).abs() < 1e-5, "{lost}");
        // x = v/w sin(w t) exp(-d t), d = c/2m = 2, w = sqrt(k/m - d^2)
        let w = libm::sqrt(400.0 - 4.0);
        let exact = libm::sin(w) / w * libm::exp(-2.0);
        assert!((body.coordinate - exact).abs() < 1e-6, "{} {exact}", body.coordinate);
    }

    #[test]
    fn a_stop_holds_and_lets_go() {
        let stopped = FreeMotion {
            stops: [-0.1, 0.2],
            ..FREE
        };
        let (mut body, lost) = run(stopped, 1e-3, 1000);
        assert_eq!((body.coordinate, body.speed), (-0.1, 0.0));
        // the fall through 0.1 m
        assert!(
            (lost - 2.0).abs() < 1e-12 && (lost + body.energy()).abs() < 1e-12,
            "{lost}"
        );
        for _ in 0..100 {
            body.settle(30.0);
            body.advance(1e-3);
        }
        body.settle(30.0);
        assert!(body.coordinate > -0.1 && body.speed > 0.0);
    }
}
