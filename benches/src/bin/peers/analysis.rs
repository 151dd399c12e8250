//! What grains at rest in one moment tell: energy, contacts, force on a wall. One function for all engines, which see
//! positions, radii and velocities only.

use crate::grains::{FIXED, Grain};
use demeter_physics::DVec3;

/// A surface that bears grains.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Bearing {
    /// A plane across z, grains on the side of `up` (1 above, -1 below).
    Level {
        /// Height [m].
        z: f64,
        /// On which side the grains are.
        up: f64,
    },
    /// The inside of a cylinder about the axis y.
    CylinderAboutY {
        /// Its radius [m].
        radius: f64,
    },
    /// The inside of a prism about the axis y, whose first edge lies along x before it has turned.
    PrismAboutY {
        /// Distance of its faces from the axis [m].
        apothem: f64,
        /// Number of its faces.
        faces: usize,
        /// Angle by which it has turned about y.
        turned: f64,
    },
    /// The fixed grains; the force is its component across them, along z.
    FixedGrains,
}

/// Elastic part of the normal law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Spring {
    /// Hertz, with `E/(1 - nu^2)` of the material of all bodies [Pa].
    Hertz {
        /// The modulus [Pa].
        plane_strain_modulus: f64,
    },
    /// Linear, with its stiffness [N/m].
    Linear {
        /// The stiffness [N/m].
        stiffness: f64,
    },
}

impl Spring {
    /// Force at an overlap, with the effective radius [N].
    fn force(self, overlap: f64, radius: f64) -> f64 {
        match self {
            // two bodies of one material: E* is half of E/(1 - nu^2)
            Self::Hertz { plane_strain_modulus } => {
                4.0 / 3.0 * (0.5 * plane_strain_modulus) * (radius * overlap).sqrt() * overlap
            }
            Self::Linear { stiffness } => stiffness * overlap,
        }
    }
}

/// What is needed to judge grains.
#[derive(Clone, Copy, Debug)]
pub struct Scene {
    /// Length of a periodic box [m]; infinite where it is not periodic.
    pub period: DVec3,
    /// Mass density [kg/m^3].
    pub density: f64,
    /// Elastic law.
    pub spring: Spring,
    /// The surface whose load is told.
    pub bearing: Bearing,
    /// Stiffness of a contact with a wall over that of two bodies of one material, one of them flat.
    pub wall_stiffness: f64,
}

/// What is compared.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Physics {
    /// Kinetic energy, translation and rotation [J].
    pub kinetic: f64,
    /// Contacts between grains, each once, over the number of free grains.
    pub contacts: f64,
    /// Elastic force on the bearing surface [N].
    pub force: f64,
}

/// Judges the grains of one moment.
pub fn judge(grains: &[Grain], scene: &Scene) -> Physics {
    let free = grains.iter().filter(|g| g.kind != FIXED);
    let kinetic = free.clone().map(|g| kinetic(g, scene.density)).sum();
    let (mut pairs, mut borne) = (0u64, 0.0);
    for_each_contact(grains, scene.period, |a, b, apart, overlap| {
        pairs += 1;
        if (a.kind == FIXED) != (b.kind == FIXED) && scene.bearing == Bearing::FixedGrains {
            let radius = 0.5 * a.diameter * b.diameter / (a.diameter + b.diameter);
            borne += scene.spring.force(overlap, radius) * apart.z.abs() / apart.length();
        }
    });
    for grain in free.clone() {
        let overlap = 0.5 * grain.diameter - distance(scene.bearing, grain.position);
        if overlap > 0.0 {
            borne += scene.wall_stiffness * scene.spring.force(overlap, 0.5 * grain.diameter);
        }
    }
    Physics {
        kinetic,
        contacts: pairs as f64 / free.count() as f64,
        force: borne,
    }
}

fn kinetic(grain: &Grain, density: f64) -> f64 {
    let r = 0.5 * grain.diameter;
    let mass = 4.0 / 3.0 * std::f64::consts::PI * density * r * r * r;
    0.5 * mass * (grain.velocity.length_squared() + 0.4 * r * r * grain.spin.length_squared())
}

/// Distance of a centre from a surface [m].
fn distance(bearing: Bearing, p: DVec3) -> f64 {
    match bearing {
        Bearing::Level { z, up } => up * (p.z - z),
        Bearing::CylinderAboutY { radius } => radius - (p.x * p.x + p.z * p.z).sqrt(),
        Bearing::PrismAboutY { apothem, faces, turned } => {
            let face = std::f64::consts::TAU / faces as f64;
            // about y, x turns away from z; the angle here runs from x to z
            let along = (p.z.atan2(p.x) + turned).rem_euclid(face) - 0.5 * face;
            apothem - (p.x * p.x + p.z * p.z).sqrt() * along.cos()
        }
        Bearing::FixedGrains => f64::INFINITY,
    }
}

/// Hands over every pair of grains that overlap, not both fixed: the vector between the centres and the overlap [m].
fn for_each_contact(grains: &[Grain], period: DVec3, mut found: impl FnMut(&Grain, &Grain, DVec3, f64)) {
    let cells = Cells::new(grains, period);
    for (at, a) in grains.iter().enumerate() {
        cells.for_each_near(a.position, |other| {
            let b = &grains[other];
            if other <= at || (a.kind == FIXED && b.kind == FIXED) {
                return;
            }
            let apart = nearest_image(a.position - b.position, period);
            let overlap = 0.5 * (a.diameter + b.diameter) - apart.length();
            if overlap > 0.0 {
                found(a, b, apart, overlap);
            }
        });
    }
}

fn nearest_image(d: DVec3, period: DVec3) -> DVec3 {
    let along = |x: f64, size: f64| {
        if size.is_finite() {
            x - size * (x / size).round()
        } else {
            x
        }
    };
    DVec3::new(along(d.x, period.x), along(d.y, period.y), along(d.z, period.z))
}

/// Grains in cells no smaller than the largest diameter.
struct Cells {
    lower: DVec3,
    size: DVec3,
    count: [i64; 3],
    periodic: [bool; 3],
    /// Grains of cell `c`: `grains[start[c]..start[c + 1]]`.
    start: Vec<usize>,
    grains: Vec<usize>,
}

/// Fewer cells than this along an axis: a cell would be its own neighbour twice across the period.
const LEAST_PERIODIC: i64 = 3;
/// At most this many cells along an axis, so that a grain flown away does not ask for all memory.
const MOST: f64 = 200.0;

impl Cells {
    fn new(grains: &[Grain], period: DVec3) -> Self {
        let largest = grains.iter().map(|g| g.diameter).fold(0.0, f64::max);
        let (mut lower, mut upper) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        for g in grains {
            (lower, upper) = (lower.min(g.position), upper.max(g.position));
        }
        let (mut size, mut count, mut periodic) = (DVec3::ONE, [1; 3], [false; 3]);
        for axis in 0..3 {
            let length = if period[axis].is_finite() {
                period[axis]
            } else {
                upper[axis] - lower[axis]
            };
            count[axis] = (length / largest).floor().clamp(1.0, MOST) as i64;
            periodic[axis] = period[axis].is_finite() && count[axis] >= LEAST_PERIODIC;
            if period[axis].is_finite() && !periodic[axis] {
                count[axis] = 1;
            }
            size[axis] = (length / count[axis] as f64).max(largest);
        }
        let mut cells = Self {
            lower,
            size,
            count,
            periodic,
            start: Vec::new(),
            grains: Vec::new(),
        };
        let cell_of: Vec<usize> = grains.iter().map(|g| cells.index(cells.of(g.position))).collect();
        let mut start = vec![0; (count[0] * count[1] * count[2]) as usize + 1];
        for &cell in &cell_of {
            start[cell + 1] += 1;
        }
        for cell in 1..start.len() {
            start[cell] += start[cell - 1];
        }
        let mut next = start.clone();
        cells.grains = vec![0; grains.len()];
        for (grain, &cell) in cell_of.iter().enumerate() {
            cells.grains[next[cell]] = grain;
            next[cell] += 1;
        }
        cells.start = start;
        cells
    }

    fn of(&self, p: DVec3) -> [i64; 3] {
        let mut cell = [0; 3];
        for axis in 0..3 {
            let along = ((p[axis] - self.lower[axis]) / self.size[axis]).floor() as i64;
            cell[axis] = if self.periodic[axis] {
                along.rem_euclid(self.count[axis])
            } else {
                along.clamp(0, self.count[axis] - 1)
            };
        }
        cell
    }

    fn index(&self, cell: [i64; 3]) -> usize {
        ((cell[2] * self.count[1] + cell[1]) * self.count[0] + cell[0]) as usize
    }

    /// Cells along one axis that hold what is near to a cell.
    fn around(&self, axis: usize, at: i64) -> impl Iterator<Item = i64> + Clone + use<> {
        let (count, periodic) = (self.count[axis], self.periodic[axis]);
        (at - 1..=at + 1)
            .filter(move |c| periodic || (0..count).contains(c))
            .map(move |c| c.rem_euclid(count))
    }

    fn for_each_near(&self, p: DVec3, mut found: impl FnMut(usize)) {
        let [x, y, z] = self.of(p);
        for cz in self.around(2, z) {
            for cy in self.around(1, y) {
                for cx in self.around(0, x) {
                    let cell = self.index([cx, cy, cz]);
                    self.grains[self.start[cell]..self.start[cell + 1]]
                        .iter()
                        .for_each(|&grain| found(grain));
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand_pcg::Pcg64;
    use rand_pcg::rand_core::{Rng, SeedableRng};

    fn grain(position: DVec3, diameter: f64, kind: u8) -> Grain {
        Grain {
            id: 1,
            kind,
            diameter,
            position,
            velocity: DVec3::ZERO,
            spin: DVec3::ZERO,
        }
    }

    const OPEN: Scene = Scene {
        period: DVec3::INFINITY,
        density: 1.0,
        spring: Spring::Linear { stiffness: 10.0 },
        bearing: Bearing::Level { z: 0.0, up: 1.0 },
        wall_stiffness: 1.0,
    };

    fn pairs(grains: &[Grain], period: DVec3) -> usize {
        let mut count = 0;
        for_each_contact(grains, period, |_, _, _, _| count += 1);
        count
    }

    #[test]
    fn contacts_are_those_of_all_pairs() {
        let mut random = Pcg64::seed_from_u64(3);
        for period in [
            DVec3::INFINITY,
            DVec3::new(1.0, 1.0, f64::INFINITY),
            DVec3::new(0.15, 1.0, f64::INFINITY),
        ] {
            let box_size = DVec3::new(period.x.min(1.0), 1.0, 1.0);
            let grains: Vec<Grain> = (0..600)
                .map(|k| {
                    let mut unit = || (random.next_u64() >> 11) as f64 / (1u64 << 53) as f64;
                    let place = DVec3::new(unit(), unit(), unit()) * box_size;
                    grain(place, 0.01 + 0.06 * unit(), if k % 7 == 0 { FIXED } else { 1 })
                })
                .collect();
            let mut expected = 0;
            for (i, a) in grains.iter().enumerate() {
                for b in &grains[..i] {
                    let apart = nearest_image(a.position - b.position, period).length();
                    let touches = apart < 0.5 * (a.diameter + b.diameter);
                    expected += usize::from(touches && !(a.kind == FIXED && b.kind == FIXED));
                }
            }
            assert!(expected > 50, "{expected}");
            assert_eq!(pairs(&grains, period), expected, "{period}");
        }
    }

    #[test]
    fn a_grain_far_away_does_not_ask_for_all_memory() {
        let near = [grain(DVec3::ZERO, 1e-3, 1), grain(DVec3::X * 0.9e-3, 1e-3, 1)];
        let all = [near[0], near[1], grain(DVec3::splat(1e9), 1e-3, 1)];
        assert_eq!(pairs(&all, DVec3::INFINITY), 1);
    }

    #[test]
    fn energy_counts_translation_and_rotation_of_free_grains() {
        let mut moving = grain(DVec3::ZERO, 2.0, 1);
        moving.velocity = DVec3::X * 3.0;
        moving.spin = DVec3::Y * 2.0;
        let mut fixed = moving;
        fixed.kind = FIXED;
        fixed.position = DVec3::X * 100.0;
        let mass = 4.0 / 3.0 * std::f64::consts::PI;
        let found = judge(&[moving, fixed], &OPEN).kinetic;
        approx(found, mass * (0.5 * 9.0 + 0.5 * 0.4 * 4.0));
    }

    fn approx(found: f64, expected: f64) {
        assert!(
            (found - expected).abs() < 1e-12 * expected.abs(),
            "{found} is not {expected}"
        );
    }

    #[test]
    fn walls_bear_what_overlaps_them() {
        let floor = [grain(DVec3::Z * 0.9, 2.0, 1), grain(DVec3::new(9.0, 0.0, 1.1), 2.0, 1)];
        approx(judge(&floor, &OPEN).force, 10.0 * (1.0 - 0.9));
        let plate = Scene {
            bearing: Bearing::Level { z: 2.0, up: -1.0 },
            ..OPEN
        };
        approx(judge(&floor, &plate).force, 10.0 * (1.0 - (2.0 - 1.1)));
        let stiffer = Scene {
            wall_stiffness: 1.3,
            ..plate
        };
        approx(judge(&floor, &stiffer).force, 1.3 * judge(&floor, &plate).force);
        let drum = Scene {
            bearing: Bearing::CylinderAboutY { radius: 5.0 },
            spring: Spring::Hertz {
                plane_strain_modulus: 1e3,
            },
            ..OPEN
        };
        let inside = [grain(DVec3::new(3.0, 50.0, -3.0), 2.0, 1)];
        let overlap = 1.0 - (5.0 - 18f64.sqrt());
        approx(judge(&inside, &drum).force, 4.0 / 3.0 * 500.0 * overlap.powf(1.5));
    }

    #[test]
    fn a_prism_bears_with_its_turned_faces() {
        let square = |turned| Bearing::PrismAboutY {
            apothem: 2.0,
            faces: 4,
            turned,
        };
        // edges at 0, 90 degrees...: faces at 45 degrees
        let (on_x, askew) = (DVec3::X * 1.5, DVec3::new(1.0, 7.0, 1.0));
        approx(distance(square(0.0), on_x), 2.0 - 1.5 / 2f64.sqrt());
        approx(distance(square(0.0), askew), 2.0 - 2f64.sqrt());
        // turned by 30 degrees about y, the face at 45 degrees from x to z is at 15
        let sixth = std::f64::consts::FRAC_PI_6;
        let quarter = std::f64::consts::FRAC_PI_4;
        let turned = demeter_physics::DVec3::new((quarter - sixth).cos(), 0.0, (quarter - sixth).sin());
        approx(distance(square(sixth), turned), 1.0);
        // many faces are a cylinder
        let many = Bearing::PrismAboutY {
            apothem: 5.0,
            faces: 100_000,
            turned: 0.1,
        };
        let p = DVec3::new(-2.0, 0.0, 3.0);
        let round = distance(Bearing::CylinderAboutY { radius: 5.0 }, p);
        assert!((distance(many, p) - round).abs() < 1e-8);
    }

    #[test]
    fn fixed_grains_bear_along_z_and_do_not_touch_each_other() {
        let scene = Scene {
            bearing: Bearing::FixedGrains,
            ..OPEN
        };
        let base = [grain(DVec3::ZERO, 1.0, FIXED), grain(DVec3::X * 0.5, 1.0, FIXED)];
        let above = grain(DVec3::new(-0.3, 0.0, 0.4), 1.0, 1);
        let physics = judge(&[base[0], base[1], above], &scene);
        approx(physics.contacts, 2.0);
        let (near, far) = (1.0 - 0.5, 1.0 - 0.8f64.hypot(0.4));
        approx(physics.force, 10.0 * (near * 0.4 / 0.5 + far * 0.4 / 0.8f64.hypot(0.4)));
    }
}
