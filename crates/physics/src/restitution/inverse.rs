//! From what a collision shows to what a contact law needs, in SI units, and back (Antypov & Elliott 2011, eqs 7, 19-23, 25).
//!
//! With the closed forms of [`linear`](super::linear) and [`hertz`](super::hertz) for a unit collision (`t` contact time,
//! `d` largest overlap, `f` largest force, of the restitution and end of contact at hand):
//!
//! ```text
//! linear:  T = t sqrt(m/k)                  x_max = d v0 sqrt(m/k)          F_max = f v0 sqrt(m k)
//! Hertz:   T = t (m/K)^(2/5) v0^(-1/5)      x_max = d (m v0^2/K)^(2/5)      F_max = f m^(3/5) K^(2/5) v0^(6/5)
//! ```
//!
//! each solved for the stiffness, exactly. Bodies enter by their effective mass and effective radius only, so all of it holds
//! for unequal spheres and (with the mass and radius of the one grain) for a wall.

use super::hertz::HertzCollision;
use super::linear::LinearCollision;
use super::power::PowerScale;
use super::{ContactEnd, RestitutionError, bracketed, positive, share};

/// Which spring-dashpot.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SpringDashpot {
    /// `F = k x + 2 gamma m v`; stiffness in [N/m].
    Linear,
    /// `F = K x^(3/2) + alpha sqrt(m K) x^(1/4) v`; stiffness in [N/m^(3/2)].
    Hertz,
}

/// A head-on collision of which mass, speed and restitution are known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Collision {
    /// Spring-dashpot.
    pub law: SpringDashpot,
    /// When the bodies part.
    pub end: ContactEnd,
    /// Effective mass: `m1 m2/(m1 + m2)`, against a wall that of the grain [kg].
    pub mass: f64,
    /// Impact speed [m/s]. The contact time of a linear collision does not depend on it.
    pub speed: f64,
    /// Coefficient of restitution, in (0, 1].
    pub restitution: f64,
}

/// Contact time, largest overlap and largest force of a collision, in units of [`PowerScale`] or in SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extent {
    /// Contact time [s].
    pub contact_time: f64,
    /// Largest overlap [m].
    pub max_overlap: f64,
    /// Largest total force [N].
    pub max_force: f64,
}

impl SpringDashpot {
    /// Exponent of the overlap in the elastic force.
    pub fn exponent(self) -> f64 {
        match self {
            SpringDashpot::Linear => 1.0,
            SpringDashpot::Hertz => 1.5,
        }
    }

    /// The unit collision with the restitution `e` at the given end of contact.
    fn unit(self, restitution: f64, end: ContactEnd) -> Result<Extent, RestitutionError> {
        Ok(match self {
            SpringDashpot::Linear => {
                let collision = LinearCollision::from_restitution(restitution, end)?;
                Extent {
                    contact_time: collision.contact_time(end)?,
                    max_overlap: collision.max_overlap(),
                    max_force: collision.max_force(),
                }
            }
            SpringDashpot::Hertz => {
                let collision = HertzCollision::from_restitution(restitution, end)?;
                Extent {
                    contact_time: collision.contact_time(end)?,
                    max_overlap: collision.max_overlap(),
                    max_force: collision.max_force(),
                }
            }
        })
    }
}

impl Collision {
    fn checked_unit(&self) -> Result<Extent, RestitutionError> {
        positive("effective mass [kg]", self.mass)?;
        positive("impact speed [m/s]", self.speed)?;
        self.law.unit(self.restitution, self.end)
    }

    /// Contact time, largest overlap and largest force of bodies with the given stiffness [N/m] or [N/m^(3/2)].
    pub fn extent(&self, stiffness: f64) -> Result<Extent, RestitutionError> {
        let unit = self.checked_unit()?;
        let scale = PowerScale {
            exponent: self.law.exponent(),
            mass: self.mass,
            stiffness: positive("stiffness", stiffness)?,
            speed: self.speed,
        };
        Ok(Extent {
            contact_time: positive("contact time [s]", unit.contact_time * scale.time())?,
            max_overlap: positive("largest overlap [m]", unit.max_overlap * scale.length())?,
            max_force: positive("largest force [N]", unit.max_force * scale.force())?,
        })
    }

    /// Stiffness of the bodies whose contact lasts `contact_time` [s]: `k = m (t/T)^2` (eq 7), `K = m (t/T)^(5/2) v0^(-1/2)`.
    pub fn stiffness_of_contact_time(&self, contact_time: f64) -> Result<f64, RestitutionError> {
        let ratio = self.checked_unit()?.contact_time / positive("contact time [s]", contact_time)?;
        found(match self.law {
            SpringDashpot::Linear => self.mass * ratio * ratio,
            SpringDashpot::Hertz => self.mass * ratio * ratio * ratio.sqrt() / self.speed.sqrt(),
        })
    }

    /// Stiffness of the bodies whose largest overlap is `max_overlap` [m]: `k = m (d v0/x_max)^2`,
    /// `K = m v0^2 (d/x_max)^(5/2)` (eqs 19, 21).
    pub fn stiffness_of_max_overlap(&self, max_overlap: f64) -> Result<f64, RestitutionError> {
        let ratio = self.checked_unit()?.max_overlap / positive("largest overlap [m]", max_overlap)?;
        found(match self.law {
            SpringDashpot::Linear => self.mass * (ratio * self.speed) * (ratio * self.speed),
            SpringDashpot::Hertz => self.mass * self.speed * self.speed * ratio * ratio * ratio.sqrt(),
        })
    }

    /// Stiffness of the bodies whose largest force is `max_force` [N]: `k = (F_max/(f v0))^2/m`,
    /// `K = (F_max/f)^(5/2) m^(-3/2) v0^(-3)`.
    pub fn stiffness_of_max_force(&self, max_force: f64) -> Result<f64, RestitutionError> {
        let ratio = positive("largest force [N]", max_force)? / self.checked_unit()?.max_force;
        found(match self.law {
            SpringDashpot::Linear => (ratio / self.speed) * (ratio / self.speed) / self.mass,
            SpringDashpot::Hertz => {
                let per_momentum = ratio / (self.mass * self.speed);
                per_momentum * per_momentum * ratio.sqrt() * self.mass.sqrt() / self.speed
            }
        })
    }
}

/// A stiffness, if numbers can tell it.
fn found(stiffness: f64) -> Result<f64, RestitutionError> {
    positive("stiffness that this takes", stiffness)
}

/// A collision of which time and depth were seen, but not the restitution.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Observed {
    /// Spring-dashpot.
    pub law: SpringDashpot,
    /// When the bodies part.
    pub end: ContactEnd,
    /// Impact speed [m/s].
    pub speed: f64,
    /// Contact time [s].
    pub contact_time: f64,
    /// Largest overlap [m].
    pub max_overlap: f64,
}

impl Observed {
    /// The restitution that goes with it, from `x_max/(v0 T) = d/t`, which falls as the damping grows.
    ///
    /// One exception: where a Hertzian contact ends at zero force, a little damping shortens the contact more than it lessens
    /// the overlap; `d/t` first rises (by less than 0.1 %), and two restitutions near 1 fit. That is told, with both.
    /// Refused too are ratios above those of any restitution, and below that of `e = 1e-300`.
    pub fn restitution(&self) -> Result<f64, RestitutionError> {
        let travelled = positive("impact speed [m/s]", self.speed)? * positive("contact time [s]", self.contact_time)?;
        let ratio = positive("largest overlap [m]", self.max_overlap)? / travelled;
        let ratio_of = |loss: f64| {
            let unit = self.law.unit(libm::exp(-loss), self.end);
            unit.map_or(f64::NAN, |unit| unit.max_overlap / unit.contact_time)
        };
        let rises = self.law == SpringDashpot::Hertz && self.end == ContactEnd::ZeroForce;
        let turn = if rises { largest_of(ratio_of, 0.0, 0.1) } else { 0.0 };
        let (undamped, largest, smallest) = (ratio_of(0.0), ratio_of(turn), ratio_of(MOST_LOSS));
        // an undamped collision observed with rounding
        let ratio = if ratio > largest && ratio <= largest * (1.0 + 1e-12) {
            largest
        } else {
            ratio
        };
        if !(smallest..=largest).contains(&ratio) {
            return Err(RestitutionError::Quantity {
                quantity: "largest overlap by impact speed and contact time",
                value: ratio,
                allowed: match self.law {
                    SpringDashpot::Linear => "at most 1/pi = 0.31831, the undamped linear spring, and not near 0",
                    SpringDashpot::Hertz => "at most about 0.34, the undamped Hertzian spring, and not near 0",
                },
            });
        }
        let between = |low, high| share(libm::exp(-bracketed(|loss| ratio_of(loss) - ratio, low, high)));
        let low = between(turn, MOST_LOSS)?;
        if rises && ratio >= undamped * (1.0 - 1e-12) {
            let high = between(0.0, turn)?;
            return Err(RestitutionError::Ambiguous { ratio, low, high });
        }
        Ok(low)
    }
}

/// Where `f`, which rises and then falls, is largest, by golden section.
fn largest_of(f: impl Fn(f64) -> f64, low: f64, high: f64) -> f64 {
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    let (mut low, mut high) = (low, high);
    for _ in 0..40 {
        let width = GOLDEN * (high - low);
        if f(high - width) < f(low + width) {
            low = high - width;
        } else {
            high = low + width;
        }
    }
    0.5 * (low + high)
}

/// `-ln e` up to which [`Observed::restitution`] looks.
const MOST_LOSS: f64 = 690.0;

/// Stiffness of a Hertzian contact, `K = 4/3 E_eff sqrt(r_eff)` [N/m^(3/2)] (eq 9).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HertzContact {
    /// `1/E_eff = (1 - nu1^2)/E1 + (1 - nu2^2)/E2` [Pa].
    pub effective_modulus: f64,
    /// `r_eff = r1 r2/(r1 + r2)`, against a flat wall that of the grain [m].
    pub effective_radius: f64,
}

impl HertzContact {
    /// `K = 4/3 E_eff sqrt(r_eff)` [N/m^(3/2)].
    pub fn stiffness(&self) -> f64 {
        4.0 / 3.0 * self.effective_modulus * self.effective_radius.sqrt()
    }

    /// The contact of the stiffness `K` [N/m^(3/2)] at the effective radius [m]: `E_eff = 3 K/(4 sqrt(r_eff))`.
    pub fn of_stiffness(stiffness: f64, effective_radius: f64) -> Result<Self, RestitutionError> {
        let stiffness = positive("stiffness [N/m^(3/2)]", stiffness)?;
        let effective_radius = positive("effective radius [m]", effective_radius)?;
        Ok(Self {
            effective_modulus: positive("effective modulus [Pa]", 0.75 * stiffness / effective_radius.sqrt())?,
            effective_radius,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use ContactEnd::{ZeroForce, ZeroOverlap};
    use approx::assert_relative_eq;
    use std::f64::consts::PI;

    const ALL: [(SpringDashpot, ContactEnd); 4] = [
        (SpringDashpot::Linear, ZeroOverlap),
        (SpringDashpot::Linear, ZeroForce),
        (SpringDashpot::Hertz, ZeroOverlap),
        (SpringDashpot::Hertz, ZeroForce),
    ];

    #[test]
    fn the_granule_of_fig_1_from_its_contact_time_and_its_overlap() {
        let (diameter, modulus) = (0.01f64, 6e9 / (1.0 - 0.3 * 0.3) / 2.0);
        let collision = Collision {
            law: SpringDashpot::Hertz,
            end: ZeroOverlap,
            mass: 0.5 * 1500.0 * PI / 6.0 * diameter * diameter * diameter,
            speed: 1.0,
            restitution: 0.54,
        };
        for stiffness in [
            collision.stiffness_of_contact_time(69.51247874e-6).unwrap(),
            collision.stiffness_of_max_overlap(17.60955505e-6).unwrap(),
        ] {
            let contact = HertzContact::of_stiffness(stiffness, 0.25 * diameter).unwrap();
            assert_relative_eq!(contact.effective_modulus, modulus, max_relative = 2e-9);
            assert_relative_eq!(contact.stiffness(), stiffness, max_relative = 1e-15);
        }
        let hertz = Collision {
            restitution: 1.0,
            ..collision
        };
        let stiffness = hertz.stiffness_of_contact_time(64.33145691e-6).unwrap();
        assert_relative_eq!(
            stiffness,
            4.0 / 3.0 * modulus * (0.25 * diameter).sqrt(),
            max_relative = 2e-9
        );
    }

    #[test]
    fn what_a_collision_shows_gives_its_stiffness_back() {
        for (law, end) in ALL {
            for restitution in [1.0, 0.93, 0.4, 0.05] {
                for speed in [1e-3, 0.7, 12.0] {
                    let (mass, stiffness) = (3e-7, 4.2e6);
                    let collision = Collision {
                        law,
                        end,
                        mass,
                        speed,
                        restitution,
                    };
                    let seen = collision.extent(stiffness).unwrap();
                    for found in [
                        collision.stiffness_of_contact_time(seen.contact_time).unwrap(),
                        collision.stiffness_of_max_overlap(seen.max_overlap).unwrap(),
                        collision.stiffness_of_max_force(seen.max_force).unwrap(),
                    ] {
                        assert_relative_eq!(found, stiffness, max_relative = 1e-13);
                    }
                }
            }
        }
    }

    #[test]
    fn time_and_depth_give_the_restitution_back() {
        for (law, end) in ALL {
            for restitution in [1.0, 0.999, 0.8, 0.3, 0.1, 1e-3, 1e-9] {
                let collision = Collision {
                    law,
                    end,
                    mass: 2.0,
                    speed: 0.3,
                    restitution,
                };
                let seen = collision.extent(5e5).unwrap();
                let observed = Observed {
                    law,
                    end,
                    speed: 0.3,
                    contact_time: seen.contact_time,
                    max_overlap: seen.max_overlap,
                };
                match observed.restitution() {
                    Ok(found) => assert_relative_eq!(found, restitution, max_relative = 1e-10),
                    Err(RestitutionError::Ambiguous { low, high, .. }) => {
                        assert_eq!((law, end), (SpringDashpot::Hertz, ZeroForce));
                        assert!(restitution >= 0.99 && low < high, "{restitution}: {low} {high}");
                        let nearest = (low - restitution).abs().min((high - restitution).abs());
                        assert!(nearest < 1e-6, "{restitution}: {low} {high}");
                    }
                    Err(other) => panic!("{restitution}: {other}"),
                }
                let deeper = Observed {
                    max_overlap: 0.35 * 0.3 * seen.contact_time,
                    ..observed
                };
                assert!(deeper.restitution().is_err());
            }
        }
    }

    #[test]
    fn senseless_input_is_refused_by_name() {
        let good = Collision {
            law: SpringDashpot::Hertz,
            end: ZeroForce,
            mass: 1.0,
            speed: 1.0,
            restitution: 0.5,
        };
        let told = |collision: Collision| collision.extent(1.0).unwrap_err().to_string();
        assert!(told(Collision { mass: -1.0, ..good }).contains("mass"));
        assert!(told(Collision { speed: 0.0, ..good }).contains("speed"));
        assert!(
            told(Collision {
                restitution: 1.1,
                ..good
            })
            .contains("1.1")
        );
        assert!(good.extent(f64::NAN).is_err());
        assert!(good.stiffness_of_contact_time(0.0).is_err());
        assert!(good.stiffness_of_max_overlap(-1.0).is_err());
        assert!(good.stiffness_of_max_force(f64::INFINITY).is_err());
        assert!(HertzContact::of_stiffness(1.0, 0.0).is_err());
        assert!(HertzContact::of_stiffness(1e300, 1e-300).is_err());
    }

    #[test]
    fn a_stiffness_beyond_all_numbers_is_refused() {
        for (law, end) in ALL {
            let collision = Collision {
                law,
                end,
                mass: 1.0,
                speed: 1.0,
                restitution: 0.5,
            };
            for seen in [1e-200, 1e200] {
                for found in [
                    collision.stiffness_of_contact_time(seen),
                    collision.stiffness_of_max_overlap(seen),
                    collision.stiffness_of_max_force(seen),
                ] {
                    let told = found.unwrap_err().to_string();
                    assert!(told.contains("stiffness"), "{told}");
                }
            }
        }
    }
}
