//! What a wall that moves freely does under a push.

use super::body::BodyMotion;
use super::error::WallError;
use super::motion::Motions;
use super::motor::Motor;
use super::pose::Pose;
use super::wall::Wall;
use glam::DVec3;

impl Wall {
    /// Whether the wall moves freely.
    #[inline]
    pub(crate) fn is_free(&self) -> bool {
        self.motor.is_free()
    }

    /// Mass of the body that some motion would make of the wall [kg]; `None` where that is not known.
    pub fn body_mass(&self, body: &BodyMotion) -> Option<f64> {
        let mass = body.mass.of(self.described(), self.origin, &self.motor.pose);
        mass.ok().map(|mass| mass.mass)
    }

    /// Whether the wall moves as a rigid body.
    pub(crate) fn is_body(&self) -> bool {
        self.motor.body().is_some()
    }

    /// Inverse of the mass with which a freely moving wall gives way to a push along a direction at a point [1/kg]:
    /// `(a.n)^2/m` of one that slides along `a`, `(a.(r x n))^2/I` of one that turns about a hinge,
    /// `1/m + (r x n).I^-1 (r x n)` of a rigid body; 0 of all others. A wall that
    /// moves with another one gives way as that one does.
    #[inline]
    pub fn inverse_mass_at(&self, point: DVec3, direction: DVec3) -> f64 {
        self.motor.inverse_mass(point, direction)
    }

    /// Least mass with which the wall gives way to a push anywhere [kg]; infinite where it does not move freely.
    pub fn least_mass(&self) -> f64 {
        self.motor.least_mass(self.bounds())
    }

    /// Least mass with which a wall within bounds gives way that moves as this one would with some motions; what is wrong with them.
    pub fn least_mass_with(&self, motions: &Motions, bounds: Option<(DVec3, DVec3)>) -> Result<f64, WallError> {
        let poses = (self.motor.pose, Pose::START);
        let motor = Motor::begun(motions.clone(), self.described(), poses, self.origin)?;
        Ok(motor.least_mass(bounds))
    }

    /// Kinetic energy of a freely moving wall, with that of its weight and spring, 0 where it stood when the motion was told,
    /// but for a speed that it was given [J].
    pub fn energy(&self) -> f64 {
        self.motor.energy()
    }
}
