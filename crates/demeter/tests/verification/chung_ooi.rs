//! Normal impacts of Chung and Ooi (2011), tests 1 to 3: against the exact solution of Hertz, against the published
//! curves (digitised), and the requested restitution.

use crate::cases;

use crate::cases::{Case, Laws, on_threads, report};
use demeter::materials::{Material, Materials};
use demeter::particles::NewGrain;
use demeter_physics::DVec3;
use demeter_physics::restitution::duration::UNDAMPED;
use std::f64::consts::PI;

/// Asked of the engine at the automatic time step.
const TOLERANCE: f64 = 1e-3;

/// Young's modulus [Pa], Poisson's ratio, density [kg/m^3].
type Solid = (f64, f64, f64);

const GLASS: Solid = (48e9, 0.2, 2800.0);
const LIMESTONE: Solid = (20e9, 0.25, 2500.0);
const ALUMINIUM_ALLOY: Solid = (70e9, 0.3, 2699.0);
const MAGNESIUM_ALLOY: Solid = (40e9, 0.35, 1800.0);
const ALUMINIUM_OXIDE: Solid = (380e9, 0.23, 4000.0);
const CAST_IRON: Solid = (100e9, 0.25, 7000.0);

/// A plane so stiff that only the sphere gives way.
const RIGID: Solid = (1e18, 0.25, 1000.0);

fn materials(solids: [Solid; 2], restitution: f64) -> Materials {
    let list = solids.map(|(young_modulus, poisson_ratio, density)| Material {
        name: format!("{young_modulus} Pa"),
        young_modulus,
        poisson_ratio,
        density,
    });
    Materials::new(list.to_vec(), |_, _| Laws::hertz(restitution).0).unwrap()
}

/// What a collision showed, with its course as `(time, overlap, force)`.
struct Seen {
    course: Vec<[f64; 3]>,
    restitution: f64,
}

impl Seen {
    fn max_overlap(&self) -> f64 {
        self.course.iter().map(|c| c[1]).fold(0.0, f64::max)
    }

    fn max_force(&self) -> f64 {
        self.course.iter().map(|c| c[2]).fold(0.0, f64::max)
    }

    /// From first touch to parting, both between two steps: where the line through the last overlaps meets zero.
    fn contact_time(&self) -> f64 {
        let crossing = |a: [f64; 3], b: [f64; 3]| a[0] - a[1] * (b[0] - a[0]) / (b[1] - a[1]);
        let end = self.course.len() - 1;
        crossing(self.course[end - 1], self.course[end]) - crossing(self.course[0], self.course[1])
    }

    /// Force at a time since first touch.
    fn force_at(&self, time: f64) -> f64 {
        let first = self.course[0][0]
            - self.course[0][1] / (self.course[1][1] - self.course[0][1]) * (self.course[1][0] - self.course[0][0]);
        let after = self
            .course
            .partition_point(|c| c[0] - first < time)
            .clamp(1, self.course.len() - 1);
        let [a, b] = [self.course[after - 1], self.course[after]];
        a[2] + (b[2] - a[2]) * (time + first - a[0]) / (b[0] - a[0])
    }
}

/// Two equal spheres that meet at `speed` each, or one that meets a rigid plane.
fn collide(solid: Solid, radius: f64, speed: f64, plane: bool, restitution: f64) -> Seen {
    let mut case = Case::new(materials([solid, RIGID], restitution));
    case.skin = 0.1 * radius;
    let mut add = |z: f64, v: f64| {
        let grain = NewGrain {
            fixed: false,
            material: 0,
            radius,
            density: solid.2,
            position: DVec3::Z * z,
            velocity: DVec3::Z * v,
            angular_velocity: DVec3::ZERO,
        };
        let id = case.grains.len() as u32 + 1;
        case.grains.push(id, &grain);
    };
    add(radius * (1.0 + 1e-4), -speed);
    if !plane {
        add(-radius * (1.0 + 1e-4), speed);
    } else {
        case.plane(1, DVec3::ZERO, DVec3::Z);
    }
    let mut sim = case.simulation();
    let mut course = Vec::new();
    for _ in 0..100_000 {
        sim.step().unwrap();
        let chunks = || sim.contacts.pairs.iter().chain(&sim.contacts.walls);
        let touching = chunks().find(|chunk| chunk.engaged() > 0);
        if let Some(chunk) = touching {
            course.push([sim.time(), sim.contact(chunk, 0).overlap, chunk.normal_force(0)]);
        } else if !course.is_empty() {
            let restitution = sim.grains().velocity[cases::index(&sim, 1)].z / speed;
            return Seen { course, restitution };
        }
    }
    panic!("the bodies never parted");
}

/// Exact contact time, largest overlap and force of Hertz for an effective modulus, radius and mass.
fn hertz(modulus: f64, radius: f64, mass: f64, speed: f64) -> [f64; 3] {
    let k = 4.0 / 3.0 * modulus * radius.sqrt();
    let overlap = libm::pow(1.25 * mass * speed * speed / k, 0.4);
    let time = UNDAMPED * libm::pow(mass / k, 0.4) * libm::pow(speed, -0.2);
    [time, overlap, k * overlap * overlap.sqrt()]
}

fn sphere_mass((_, _, density): Solid, radius: f64) -> f64 {
    density * 4.0 / 3.0 * PI * radius * radius * radius
}

#[track_caller]
fn assert_exact(label: &str, seen: &Seen, exact: [f64; 3]) {
    let found = [seen.contact_time(), seen.max_overlap(), seen.max_force()];
    for (what, (found, exact)) in ["contact time", "largest overlap", "largest force"]
        .iter()
        .zip(found.iter().zip(exact))
    {
        let error = found / exact - 1.0;
        report(&format!("{label}, {what}, relative error"), error);
        assert!(error.abs() < TOLERANCE, "{label}: {what} {found:e}, exact {exact:e}");
    }
    assert!(
        (seen.restitution - 1.0).abs() < 1e-6,
        "{label}: restitution {}",
        seen.restitution
    );
}

/// Mean of the differences from published points `(us, kN)`, over the largest force.
fn scatter(seen: &Seen, points: &[[f64; 2]]) -> f64 {
    let sum: f64 = points
        .iter()
        .map(|[us, kn]| (seen.force_at(us * 1e-6) - kn * 1e3).abs())
        .sum();
    sum / points.len() as f64 / seen.max_force()
}

#[test]
fn test_1_elastic_impact_of_two_equal_spheres() {
    on_threads(1, || {
        for (label, solid) in [("glass", GLASS), ("limestone", LIMESTONE)] {
            let seen = collide(solid, 0.01, 10.0, false, 1.0);
            let modulus = 0.5 * solid.0 / (1.0 - solid.1 * solid.1);
            assert_exact(
                label,
                &seen,
                hertz(modulus, 0.005, 0.5 * sphere_mass(solid, 0.01), 20.0),
            );
            if label == "glass" {
                // graph 2 of the paper, as digitised for Kratos
                let published = [
                    [3.875598, 1.519553],
                    [8.4689, 4.804469],
                    [12.631579, 7.888268],
                    [16.507177, 9.96648],
                    [20.454545, 10.703911],
                    [25.191388, 9.47486],
                    [29.138756, 7.039106],
                    [33.373206, 3.821229],
                    [37.177033, 1.273743],
                ];
                let scatter = scatter(&seen, &published);
                report("glass, published curve, mean difference over largest force", scatter);
                assert!(scatter < 0.02, "published curve: {scatter}");
            }
        }
    });
}

#[test]
fn test_2_elastic_impact_on_a_rigid_plane() {
    on_threads(1, || {
        for (label, solid) in [
            ("aluminium alloy", ALUMINIUM_ALLOY),
            ("magnesium alloy", MAGNESIUM_ALLOY),
        ] {
            let seen = collide(solid, 0.1, 0.2, true, 1.0);
            let modulus = solid.0 / (1.0 - solid.1 * solid.1);
            assert_exact(label, &seen, hertz(modulus, 0.1, sphere_mass(solid, 0.1), 0.2));
            if label == "aluminium alloy" {
                let published = [
                    [84.846031, 2.212292],
                    [169.573791, 5.893515],
                    [246.610276, 9.100378],
                    [318.921365, 10.99664],
                    [372.998656, 11.356695],
                    [445.549018, 10.281199],
                    [539.544701, 6.854815],
                    [620.995435, 3.236695],
                    [694.636623, 0.613146],
                ];
                let scatter = scatter(&seen, &published);
                report(
                    "aluminium alloy, published curve, mean difference over largest force",
                    scatter,
                );
                assert!(scatter < 0.02, "published curve: {scatter}");
            }
        }
    });
}

#[test]
fn test_3_restitution_is_the_requested_one() {
    on_threads(1, || {
        let mut largest = 0.0f64;
        for solid in [ALUMINIUM_OXIDE, CAST_IRON] {
            // the published 0 stands for the smallest that can be asked for
            for e in [0.01, 0.2, 0.4, 0.6, 0.8, 1.0] {
                let found = collide(solid, 0.0025, 3.9, true, e).restitution;
                largest = largest.max((found - e).abs());
                assert!((found - e).abs() < TOLERANCE, "e {e}: {found}");
            }
        }
        report("largest error of the restitution", largest);
    });
}
