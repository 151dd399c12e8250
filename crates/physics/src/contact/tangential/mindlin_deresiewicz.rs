#![doc = include_str!("mindlin_deresiewicz.md")]

use super::{Tangential, TangentialInput, TangentialResponse, dashpot};
use crate::contact::{MaterialPair, PairSize};
use crate::dimension::Dimension;
use crate::parameters::{ParameterError, ParameterInfo, Range, Values};
use crate::params;
use glam::{DVec2, DVec3};

params! {
    /// Parameters of Mindlin-Deresiewicz friction.
    pub struct MindlinDeresiewiczParameters {
        friction: NONE, required 0.3, in Range::NOT_NEGATIVE, "Coefficient of friction";
        damping_ratio: NONE, default 0.0, in Range::SHARE,
            "Share of critical damping of the tangential spring; slip dissipates without it";
    }
}

/// Most cells that touch; even, since two become one when the contact outgrows them.
const CELLS: usize = 12;
/// Where the history holds the direction in the contact plane that the first components of the forces go along.
const AXIS: usize = 0;
/// Where it holds the normal that this direction was in the plane of.
const NORMAL: usize = 3;
/// Where it holds the radius of the contact circle.
const CONTACT_RADIUS: usize = 6;
/// Where it holds the width of a cell.
const CELL_WIDTH: usize = 7;
/// Where the forces of the cells begin.
const FORCES: usize = 8;
const REMEMBERED: usize = FORCES + 2 * CELLS;

const fn remembered() -> [Dimension; REMEMBERED] {
    let mut dimensions = [Dimension::FORCE; REMEMBERED];
    let mut k = 0;
    while k < 3 {
        dimensions[AXIS + k] = Dimension::NONE;
        dimensions[NORMAL + k] = Dimension::NONE;
        k += 1;
    }
    dimensions[CONTACT_RADIUS] = Dimension::LENGTH;
    dimensions[CELL_WIDTH] = Dimension::LENGTH;
    dimensions
}

/// Mindlin-Deresiewicz friction bound to a pair of materials.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MindlinDeresiewicz {
    parameters: MindlinDeresiewiczParameters,
    /// `8 G` [Pa]: stiffness per length of the row.
    modulus: f64,
}

/// The row of springs of one contact.
#[derive(Clone, Copy)]
struct Row {
    /// Unit vector in the contact plane along which the forces have their first component; zero while nothing has moved.
    axis: DVec3,
    /// Unit normal of the plane of the axis; zero before the first touch.
    normal: DVec3,
    /// Radius of the contact circle [m].
    radius: f64,
    /// Width of a cell [m]; 0 before the first touch.
    width: f64,
    /// Forces of the cells, from the centre outwards [N].
    forces: [DVec2; CELLS],
}

/// A force cut back to the largest that a cell can carry.
#[inline(always)]
fn held(force: DVec2, limit: f64) -> DVec2 {
    let square = force.length_squared();
    if square > limit * limit {
        force * (limit / square.sqrt())
    } else {
        force
    }
}

impl Row {
    #[inline(always)]
    fn read(history: &[f64]) -> Self {
        let mut forces = [DVec2::ZERO; CELLS];
        for (force, pair) in forces.iter_mut().zip(history[FORCES..REMEMBERED].chunks_exact(2)) {
            *force = DVec2::new(pair[0], pair[1]);
        }
        Self {
            axis: DVec3::from_slice(&history[AXIS..]),
            normal: DVec3::from_slice(&history[NORMAL..]),
            radius: history[CONTACT_RADIUS],
            width: history[CELL_WIDTH],
            forces,
        }
    }

    #[inline(always)]
    fn write(&self, history: &mut [f64]) {
        history[AXIS..AXIS + 3].copy_from_slice(&self.axis.to_array());
        history[NORMAL..NORMAL + 3].copy_from_slice(&self.normal.to_array());
        history[CONTACT_RADIUS] = self.radius;
        history[CELL_WIDTH] = self.width;
        for (force, pair) in self.forces.iter().zip(history[FORCES..REMEMBERED].chunks_exact_mut(2)) {
            pair.copy_from_slice(&force.to_array());
        }
    }

    /// How much of a cell lies within a contact of this radius.
    #[inline(always)]
    fn touching(&self, cell: usize, radius: f64) -> f64 {
        (radius - cell as f64 * self.width).clamp(0.0, self.width)
    }

    /// How many cells touch; the last of them perhaps in part.
    #[inline(always)]
    fn count(&self) -> usize {
        if self.width > 0.0 {
            ((self.radius / self.width).ceil() as usize).min(CELLS)
        } else {
            0
        }
    }

    /// Energy stored for a stiffness per length [J].
    #[inline(always)]
    fn energy(&self, modulus: f64) -> f64 {
        let count = self.count();
        if count == 0 {
            return 0.0;
        }
        let (last, whole) = (self.forces[count - 1], &self.forces[..count - 1]);
        let sum: f64 = whole.iter().map(|force| force.length_squared()).sum();
        let width = self.touching(count - 1, self.radius);
        let part = if width > 0.0 {
            last.length_squared() / width
        } else {
            0.0
        };
        (sum / self.width + part) / (2.0 * modulus)
    }

    /// Turns the forces with the contact, all alike, so that what they store does not change: by the shortest way from
    /// the old normal to the new one, and by the spin about it.
    #[inline(always)]
    fn carry_along(&mut self, input: &TangentialInput) {
        let normal = input.normal;
        let cosine = self.normal.dot(normal);
        let tilted = self.axis - (self.normal + normal) * (self.axis.dot(normal) / (1.0 + cosine.max(0.0)));
        let turned = tilted + normal.cross(tilted) * (input.spin * input.dt);
        if cosine > 0.0 && self.axis != DVec3::ZERO {
            // rounding must not add up over many steps
            self.axis = (turned - normal * turned.dot(normal)).normalize_or_zero();
        } else {
            // unmoved so far, or turned by a right angle in one step: nothing to keep
            self.forces = [DVec2::ZERO; CELLS];
            self.axis = input.velocity.normalize_or_zero();
        }
        self.normal = normal;
    }

    /// Takes a new radius of the contact circle: fits the cells to it and drops the load of what lies outside.
    #[inline(always)]
    fn resize(&mut self, radius: f64, scale: f64) {
        if self.width == 0.0 {
            // widths are the grain's size over powers of two, so that the step of the first touch does not matter
            self.width = scale / CELLS as f64;
        }
        let largest = self.width * CELLS as f64;
        if radius > largest || radius <= 0.5 * largest {
            self.fit_cells(radius);
        }
        for cell in 0..CELLS {
            let (before, now) = (self.touching(cell, self.radius), self.touching(cell, radius));
            if now < before {
                self.forces[cell] *= now / before;
            }
        }
        self.radius = radius;
    }

    /// Doubles or halves the cells until all of the contact and more than half of the cells touch.
    #[inline(never)]
    fn fit_cells(&mut self, radius: f64) {
        while radius > self.width * CELLS as f64 {
            let old = self.forces;
            self.forces = std::array::from_fn(|cell| match old.get(2 * cell..2 * cell + 2) {
                Some(pair) => pair[0] + pair[1],
                None => DVec2::ZERO,
            });
            self.width *= 2.0;
        }
        while radius <= 0.5 * self.width * CELLS as f64 && self.width > f64::MIN_POSITIVE {
            let (old, half) = (*self, 0.5 * self.width);
            self.forces = std::array::from_fn(|cell| {
                let whole = old.touching(cell / 2, old.radius);
                let part = (old.radius - cell as f64 * half).clamp(0.0, half);
                if part > 0.0 {
                    old.forces[cell / 2] * (part / whole)
                } else {
                    DVec2::ZERO
                }
            });
            // what lay beyond the cells that were split has left the contact
            self.radius = self.radius.min(half * CELLS as f64);
            self.width = half;
        }
    }

    /// Moves the springs by half a step before and after the middle of the step; the sliders hold at each of these
    /// times. Returns the force in the middle.
    #[inline(always)]
    fn shear(&mut self, velocity: DVec2, input: &TangentialInput, modulus: f64, limit: f64) -> DVec2 {
        let half = velocity * (0.5 * input.dt * modulus);
        let share = |x: f64| 0.5 * x * (3.0 - x * x);
        let step = self.width / self.radius;
        let (mut sum, mut inner) = (DVec2::ZERO, 0.0);
        for cell in 0..self.count() {
            let width = self.touching(cell, self.radius);
            let outer = share(((cell + 1) as f64 * step).min(1.0));
            let cell_limit = limit * (outer - inner);
            inner = outer;
            let middle = held(self.forces[cell] - half * width, cell_limit);
            sum += middle;
            self.forces[cell] = held(middle - half * width, cell_limit);
        }
        sum
    }
}

impl Tangential for MindlinDeresiewicz {
    const NAME: &'static str = "mindlin-deresiewicz";
    const SUMMARY: &'static str = "Mindlin friction with partial slip, follows the exact oblique impact";
    const DOC: &'static str = include_str!("mindlin_deresiewicz.md");
    const PARAMETERS: &'static [ParameterInfo] = MindlinDeresiewiczParameters::TABLE;
    const HISTORY: &'static [Dimension] = &remembered();

    fn new(values: &Values, pair: &MaterialPair) -> Result<Self, Vec<ParameterError>> {
        let parameters = MindlinDeresiewiczParameters::from_values(values)?;
        Ok(Self {
            parameters,
            modulus: 8.0 * pair.effective_shear_modulus(),
        })
    }

    #[inline(always)]
    fn respond(&self, input: &TangentialInput, history: &mut [f64]) -> TangentialResponse {
        let radius = (input.size.radius * input.overlap.max(0.0)).sqrt();
        let mut row = Row::read(history);
        let before = row.energy(self.modulus);
        if radius == 0.0 || input.normal_force <= 0.0 {
            history[..REMEMBERED].fill(0.0);
            return TangentialResponse {
                force: DVec3::ZERO,
                dissipated: before,
            };
        }
        row.carry_along(input);
        row.resize(radius, input.size.radius);
        let across = input.normal.cross(row.axis);
        let velocity = DVec2::new(input.velocity.dot(row.axis), input.velocity.dot(across));
        let limit = self.parameters.friction * input.normal_force;
        let middle = row.shear(velocity, input, self.modulus, limit);
        let damping = dashpot(self.parameters.damping_ratio, self.modulus * radius, input.size);
        let load = held(middle - velocity * damping, limit);
        row.write(history);
        let work = -load.dot(velocity) * input.dt;
        TangentialResponse {
            force: row.axis * load.x + across * load.y,
            dissipated: work - (row.energy(self.modulus) - before),
        }
    }

    #[inline(always)]
    fn energy(&self, history: &[f64]) -> f64 {
        Row::read(history).energy(self.modulus)
    }

    #[inline(always)]
    fn stiffness(&self, size: PairSize, overlap: f64) -> f64 {
        self.modulus * (size.radius * overlap.max(0.0)).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::Elastic;

    const FRICTION: f64 = 0.4;
    const NORMAL_FORCE: f64 = 3.0;
    const LIMIT: f64 = FRICTION * NORMAL_FORCE;

    fn law() -> MindlinDeresiewicz {
        let material = Elastic {
            young_modulus: 7e9,
            poisson_ratio: 0.3,
        };
        let pair = MaterialPair {
            a: material,
            b: material,
        };
        MindlinDeresiewicz::new(&crate::parameters::values(&[("friction", FRICTION)]), &pair).unwrap()
    }

    /// Contact under constant normal force, moved along x by small steps.
    struct Sheared {
        law: MindlinDeresiewicz,
        history: [f64; REMEMBERED],
        radius: f64,
        moved: f64,
        dissipated: f64,
    }

    const STEPS: u32 = 2000;

    impl Sheared {
        /// `fill`: contact radius as a share of the largest that the same cells reach.
        fn new(fill: f64) -> Self {
            Self {
                law: law(),
                history: [0.0; REMEMBERED],
                radius: 2e-3 / 64.0 * fill,
                moved: 0.0,
                dissipated: 0.0,
            }
        }

        /// Displacement at which everything slips, `3 mu F_n/(16 G a)`.
        fn slip(&self) -> f64 {
            1.5 * LIMIT / (self.law.modulus * self.radius)
        }

        /// Moves on to a displacement; the force there, against the motion of the first body.
        fn shear_to(&mut self, displacement: f64) -> f64 {
            let size = PairSize {
                radius: 2e-3,
                mass: 1e-4,
            };
            let path = displacement - self.moved;
            let mut input = TangentialInput {
                size,
                overlap: self.radius * self.radius / size.radius,
                normal: DVec3::Z,
                velocity: DVec3::X * path,
                spin: 0.0,
                normal_force: NORMAL_FORCE,
                removable_share: 0.0,
                dt: 1.0 / f64::from(STEPS),
            };
            for _ in 0..STEPS {
                self.dissipated += self.law.respond(&input, &mut self.history).dissipated;
            }
            self.moved = displacement;
            input.velocity = DVec3::ZERO;
            -self.law.respond(&input, &mut self.history).force.x
        }
    }

    #[test]
    fn loading_unloading_and_reloading_follow_mindlin_and_deresiewicz() {
        // Mindlin and Deresiewicz (1953) at constant normal force, with u in units of the displacement of full slip
        let three_halves = |x: f64| libm::pow(x, 1.5);
        let loading = |u: f64| LIMIT * (1.0 - three_halves((1.0 - u).max(0.0)));
        let unloading = |turn: f64, u: f64| loading(turn) - 2.0 * loading(0.5 * (turn - u));
        for fill in [0.51, 0.6, 0.75, 0.9, 1.0] {
            let mut contact = Sheared::new(fill);
            let slip = contact.slip();
            let mut check = |what: &str, u: f64, expected: f64| {
                let force = contact.shear_to(u * slip);
                assert!(
                    (force - expected).abs() < 0.01 * LIMIT,
                    "{what} to {u}, cells filled to {fill}: {force} instead of {expected}"
                );
            };
            for u in [0.2, 0.4, 0.6, 0.8] {
                check("loading", u, loading(u));
            }
            for u in [0.6, 0.2, -0.2, -0.5] {
                check("unloading", u, unloading(0.8, u));
            }
            for u in [-0.3, 0.0, 0.3, 0.6, 0.79] {
                // the branch from -0.5 upwards meets the first one again at 0.8
                check("reloading", u, unloading(0.8, -0.5) + 2.0 * loading(0.5 * (u + 0.5)));
            }
            check("past the turning point", 0.95, loading(0.95));
            check("sliding", 1.5, LIMIT);
        }
    }

    #[test]
    fn a_cycle_dissipates_what_mindlin_and_deresiewicz_say() {
        for fill in [0.51, 0.7, 1.0] {
            for share in [0.5, 0.8] {
                let mut contact = Sheared::new(fill);
                let slip = contact.slip();
                contact.shear_to(share * slip);
                contact.dissipated = 0.0;
                contact.shear_to(-share * slip);
                contact.shear_to(share * slip);
                // The loop lies between two branches 2 f(x/2), f(u) = 1 - (1 - u)^1.5, x from 0 to 2 share.
                // Its area is 8 times the integral of f from 0 to the share, less the triangle's 4 share f(share).
                let left = 1.0 - share;
                let integral = share - 0.4 * (1.0 - left * left * left.sqrt());
                let area = 8.0 * integral - 4.0 * share * (1.0 - left * left.sqrt());
                let expected = area * LIMIT * slip;
                let ratio = contact.dissipated / expected;
                // twelve cells at most: the loop is a polygon
                assert!(
                    (ratio - 1.0).abs() < 0.08,
                    "{ratio} of the loop at {share}, fill {fill}"
                );
            }
        }
    }

    #[test]
    fn cells_follow_the_size_of_the_contact_at_unchanged_force_or_energy() {
        let mut row = Row::read(&[0.0; REMEMBERED]);
        row.resize(0.9, 1.0);
        for (cell, force) in row.forces.iter_mut().enumerate().take(11) {
            *force = DVec2::new(1.0 + cell as f64, -0.5);
        }
        let total = |row: &Row| row.forces.iter().sum::<DVec2>();
        let (force, energy) = (total(&row), row.energy(1.0));
        let mut grown = row;
        grown.resize(3.3, 1.0);
        assert!((total(&grown) - force).length() < 1e-14 * force.length());
        assert!(grown.energy(1.0) < energy);
        assert!(grown.width == 4.0 * row.width);
        // finer cells alone change neither
        let mut finer = row;
        finer.radius = 0.5;
        finer.forces[6..].fill(DVec2::ZERO);
        let (force, energy) = (total(&finer), finer.energy(1.0));
        finer.resize(0.5, 1.0);
        assert!((total(&finer) - force).length() < 1e-14 * force.length());
        assert!((finer.energy(1.0) / energy - 1.0).abs() < 1e-14);
        assert!(finer.width == 0.5 * row.width);
    }
}
