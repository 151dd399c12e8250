//! Oblique and spinning impacts, set up as tests 4 to 8 of Chung and Ooi, Granular Matter 13 (2011) 643.
//!
//! Their series are not used here. The answers are our own: momentum and angular momentum turn the velocity that the
//! surfaces have on each other after the impact into velocities and spins of both bodies, and that velocity is known
//!
//! * exactly in gross sliding, as of rigid bodies: the tangential impulse is `mu` times the normal one;
//! * from Maw, Barber and Fawcett's solution where the contact sticks for a part of the time.

use crate::oblique::impact;
use crate::oblique::maw;

use crate::cases::{Laws, full, law, on_threads, report};
use demeter::materials::Material;
use demeter_physics::DVec3;
use impact::{Approach, Body, of_spheres, on_wall};
use maw::Impact;

/// Material of the spheres with its friction and restitution.
#[derive(Clone, Copy)]
struct Surface {
    name: &'static str,
    young_modulus: f64,
    poisson_ratio: f64,
    density: f64,
    friction: f64,
    restitution: f64,
}

const ALUMINIUM_OXIDE: Surface = Surface {
    name: "aluminium oxide",
    young_modulus: 380e9,
    poisson_ratio: 0.23,
    density: 4000.0,
    friction: 0.092,
    restitution: 0.98,
};

const ALUMINIUM_ALLOY: Surface = Surface {
    name: "aluminium alloy",
    young_modulus: 70e9,
    poisson_ratio: 0.33,
    density: 2700.0,
    friction: 0.18,
    restitution: 1.0,
};

const STEEL: Surface = Surface {
    name: "steel",
    young_modulus: 208e9,
    poisson_ratio: 0.3,
    density: 7850.0,
    friction: 0.3,
    restitution: 1.0,
};

const POLYETHYLENE: Surface = Surface {
    name: "polyethylene",
    young_modulus: 1e9,
    poisson_ratio: 0.4,
    density: 1400.0,
    friction: 0.3,
    restitution: 1.0,
};

/// The soda-lime glass that Kharaz et al., Powder Technol. 120 (2001) 281, shot their spheres of aluminium oxide at.
const GLASS_ANVIL: (f64, f64) = (70e9, 0.25);

impl Surface {
    fn material(&self) -> Material {
        Material {
            name: self.name.into(),
            young_modulus: self.young_modulus,
            poisson_ratio: self.poisson_ratio,
            density: self.density,
        }
    }

    fn mass(&self, radius: f64) -> f64 {
        self.density * 4.0 / 3.0 * std::f64::consts::PI * radius * radius * radius
    }
}

/// What a sphere hits.
#[derive(Clone, Copy)]
enum Target {
    /// A plane below, with Young's modulus and Poisson's ratio.
    Plane(f64, f64),
    /// Another sphere below, of the same material.
    Sphere(Body),
}

const RIGID: Target = Target::Plane(1e18, 0.3);

/// A set-up: the sphere comes from above, along -z.
struct Shot {
    surface: Surface,
    body: Body,
    target: Target,
}

impl Shot {
    /// Velocity of the sphere's surface over the target's, where they touch.
    fn surface_velocity(&self, bodies: (Body, Option<Body>)) -> DVec3 {
        let below = bodies.1.map_or(DVec3::ZERO, |body| body.surface_velocity(DVec3::Z));
        bodies.0.surface_velocity(-DVec3::Z) - below
    }

    fn before(&self) -> (Body, Option<Body>) {
        match self.target {
            Target::Plane(..) => (self.body, None),
            Target::Sphere(other) => (self.body, Some(other)),
        }
    }

    /// Young's modulus and Poisson's ratio of both bodies.
    fn elastic(&self) -> [(f64, f64); 2] {
        let constants = (self.surface.young_modulus, self.surface.poisson_ratio);
        match self.target {
            Target::Plane(young_modulus, poisson_ratio) => [constants, (young_modulus, poisson_ratio)],
            Target::Sphere(_) => [constants; 2],
        }
    }

    /// The normal motion.
    fn approach(&self) -> Approach {
        let mass = |body: Body| self.surface.mass(body.radius);
        let of_pair = |a: f64, b: f64| a * b / (a + b);
        let (mass, radius) = match self.target {
            Target::Plane(..) => (mass(self.body), self.body.radius),
            Target::Sphere(other) => (
                of_pair(mass(self.body), mass(other)),
                of_pair(self.body.radius, other.radius),
            ),
        };
        let compliance: f64 = self.elastic().iter().map(|(e, nu)| (1.0 - nu * nu) / e).sum();
        Approach {
            mass,
            radius,
            modulus: 1.0 / compliance,
            speed: -self.surface_velocity(self.before()).z,
        }
    }

    fn laws(&self, name: &str) -> Laws {
        let mut choice = law(name, &[("friction", self.surface.friction)]);
        if name == "linear-history" {
            let stiffness = self.kappa() * self.approach().matched_stiffness();
            choice.parameters.insert("stiffness".into(), stiffness.into());
        }
        Laws::hertz(self.surface.restitution).friction(choice)
    }

    /// `k_t/k_n` of the pair (Mindlin 1949).
    fn kappa(&self) -> f64 {
        let [constants, partner] = self.elastic();
        let normal = |(e, nu): (f64, f64)| (1.0 - nu * nu) / e;
        let tangential = |(e, nu): (f64, f64)| (2.0 - nu) * 2.0 * (1.0 + nu) / e;
        4.0 * (normal(constants) + normal(partner)) / (tangential(constants) + tangential(partner))
    }

    /// Non-dimensional angle of incidence.
    fn incidence(&self) -> f64 {
        let v = self.surface_velocity(self.before());
        self.kappa() * v.x.abs() / (self.surface.friction * -v.z)
    }

    /// Whether the contact slides from its first moment to its last; `e < 1` makes the sliding end no earlier.
    fn slides(&self) -> bool {
        self.incidence() > 7.0 * self.kappa() - 1.0
    }

    /// Bodies after the impact, from the impulse.
    fn expected(&self) -> (Body, Option<Body>) {
        let (surface, v) = (&self.surface, self.surface_velocity(self.before()));
        let Approach {
            mass: reduced, speed, ..
        } = self.approach();
        let normal = reduced * (1.0 + surface.restitution) * speed;
        let tangential = if v.x == 0.0 {
            0.0
        } else if self.slides() {
            -surface.friction * normal * v.x.signum()
        } else {
            let (annuli, steps) = if full() { (48, 1200) } else { (20, 500) };
            let reference = Impact::of_stiffness_ratio(self.kappa(), annuli, steps);
            let left = reference.reflection(self.incidence()) * surface.friction * speed / self.kappa();
            // 2/7: solid spheres turn, too, when they are pushed at their surface
            2.0 / 7.0 * reduced * (left * v.x.signum() - v.x)
        };
        let impulse = DVec3::new(tangential, 0.0, normal);
        let (above, below) = self.before();
        let push = |body: Body, impulse: DVec3, arm: DVec3| {
            let mass = surface.mass(body.radius);
            Body {
                velocity: body.velocity + impulse / mass,
                spin: body.spin + (arm * body.radius).cross(impulse) / (0.4 * mass * body.radius * body.radius),
                ..body
            }
        };
        (
            push(above, impulse, -DVec3::Z),
            below.map(|body| push(body, -impulse, DVec3::Z)),
        )
    }

    fn measured(&self, law_name: &str) -> (Body, Option<Body>) {
        let laws = self.laws(law_name);
        match self.target {
            Target::Plane(young_modulus, poisson_ratio) => {
                let wall = Material {
                    name: "plane".into(),
                    young_modulus,
                    poisson_ratio,
                    density: 7000.0,
                };
                (on_wall(self.surface.material(), wall, &laws, self.body), None)
            }
            Target::Sphere(other) => {
                let [above, below] = of_spheres(self.surface.material(), &laws, [self.body, other]);
                (above, Some(below))
            }
        }
    }

    /// Largest error of a velocity, or of a spin times its radius, over the relative speed of the surfaces.
    fn error(&self, law_name: &str) -> f64 {
        let scale = self.surface_velocity(self.before()).length();
        let (expected, measured) = (self.expected(), self.measured(law_name));
        let of = |a: Body, b: Body| {
            let spin = (a.spin - b.spin).length() * a.radius;
            (a.velocity - b.velocity).length().max(spin) / scale
        };
        let other = expected.1.zip(measured.1).map_or(0.0, |(a, b)| of(a, b));
        of(expected.0, measured.0).max(other)
    }

    /// Partial slip follows all of the range. Every law follows where a rigid body slides to the end, too: `coulomb`
    /// knows no springs that push the surface back, and stops it at rest.
    fn check(&self, label: &str) {
        let label = format!("{label}, {}, psi_1 {:.2}", self.surface.name, self.incidence());
        let bound = if self.slides() { SLIDING } else { STICKING };
        let all = self.incidence() > 7.0 * self.kappa();
        for info in demeter_physics::contact::tangential::LAWS {
            if all || info.name == "mindlin-deresiewicz" {
                let error = self.error(info.name);
                let what = if self.slides() { "sliding" } else { "sticking" };
                report(&format!("{label}, {what}, {}", info.name), error);
                assert!(error < bound, "{label}, {}: {error}", info.name);
            }
        }
    }
}

/// Overlaps of up to 4e-3 of the radius shorten the lever of friction, and turn the line of centres of two spheres.
const SLIDING: f64 = 5e-3;
/// 2.5/3.5 of an error of 0.03 in the velocity of the surfaces.
const STICKING: f64 = 0.0214;

fn body(radius: f64, velocity: DVec3, spin: f64) -> Body {
    Body {
        radius,
        velocity,
        spin: DVec3::Y * spin,
    }
}

fn angles() -> Vec<f64> {
    let step = if full() { 2.5 } else { 10.0 };
    (0..=(80.0 / step) as u32)
        .map(|k| (5.0 + step * f64::from(k)).to_radians())
        .collect()
}

/// From far below to far above the ratio of velocities at which sliding lasts through the impact.
fn ratios() -> Vec<f64> {
    let count = if full() { 24 } else { 8 };
    (0..=count)
        .map(|k| 0.05 * libm::pow(200.0, f64::from(k) / f64::from(count)))
        .collect()
}

#[test]
fn test_4_a_sphere_at_different_angles() {
    on_threads(1, || {
        let anvil = Target::Plane(GLASS_ANVIL.0, GLASS_ANVIL.1);
        for (surface, target) in [
            (ALUMINIUM_OXIDE, RIGID),
            (ALUMINIUM_OXIDE, anvil),
            (ALUMINIUM_ALLOY, RIGID),
        ] {
            for angle in angles() {
                let velocity = DVec3::new(libm::sin(angle), 0.0, -libm::cos(angle)) * 3.9;
                let shot = Shot {
                    surface,
                    body: body(2.5e-3, velocity, 0.0),
                    target,
                };
                shot.check(&format!("test 4, {:.1} degrees", angle.to_degrees()));
            }
        }
    });
}

#[test]
fn test_5_a_sphere_at_constant_normal_velocity() {
    on_threads(1, || {
        for surface in [STEEL, POLYETHYLENE] {
            for ratio in ratios() {
                let shot = Shot {
                    surface,
                    body: body(1e-2, DVec3::new(ratio, 0.0, -1.0) * 0.2, 0.0),
                    target: RIGID,
                };
                shot.check("test 5");
            }
        }
    });
}

#[test]
fn test_6_a_spinning_sphere_on_a_plane() {
    on_threads(1, || {
        for surface in [ALUMINIUM_ALLOY, POLYETHYLENE] {
            for ratio in ratios() {
                for sign in [1.0, -1.0] {
                    let shot = Shot {
                        surface,
                        body: body(0.1, DVec3::Z * -0.2, sign * ratio * 0.2 / 0.1),
                        target: RIGID,
                    };
                    shot.check("test 6");
                }
            }
        }
    });
}

#[test]
fn test_7_two_equal_spheres_that_spin_alike_and_against_each_other() {
    on_threads(1, || {
        for surface in [ALUMINIUM_ALLOY, POLYETHYLENE] {
            for ratio in ratios() {
                let spin = 0.5 * ratio * 0.2 / 0.1;
                let pair = |other: f64| Shot {
                    surface,
                    body: body(0.1, DVec3::Z * -0.1, spin),
                    target: Target::Sphere(body(0.1, DVec3::Z * 0.1, other)),
                };
                pair(spin).check("test 7");
                // like cogwheels: the surfaces move together and friction does nothing
                let meshing = pair(-spin);
                let (above, below) = meshing.measured("mindlin-deresiewicz");
                assert!(meshing.surface_velocity(meshing.before()).x == 0.0);
                for (body, sign) in [(above, 1.0), (below.unwrap(), -1.0)] {
                    assert!(body.velocity.x.abs() < 1e-12, "{body:?}");
                    assert!((body.spin.y - sign * spin).abs() < 1e-9 * spin, "{body:?}");
                }
            }
        }
    });
}

#[test]
fn test_8_two_different_spheres_with_different_spins() {
    on_threads(1, || {
        for surface in [ALUMINIUM_ALLOY, POLYETHYLENE] {
            for ratio in ratios() {
                for (size, share) in [(2.0, 0.0), (5.0, 0.0), (2.0, 0.4)] {
                    // the surfaces move at `ratio` times the approach; the larger one has its share of that
                    let (small, large) = (0.1, 0.1 * size);
                    let speed = ratio * 0.2;
                    let shot = Shot {
                        surface,
                        body: body(small, DVec3::Z * -0.15, (1.0 - share) * speed / small),
                        target: Target::Sphere(body(large, DVec3::Z * 0.05, share * speed / large)),
                    };
                    shot.check(&format!("test 8, sizes 1:{size}, share {share}"));
                }
            }
        }
    });
}
