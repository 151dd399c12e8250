#![doc = include_str!("mindlin_deresiewicz.md")]

use super::{Tangential, TangentialInput, TangentialResponse};
use crate::contact::spring::dashpot;
use crate::contact::{MaterialPair, PairSize};
use crate::dimension::Dimension;
use crate::lanes::{Lanes, Mask, Vector};
use crate::parameters::{ParameterError, ParameterInfo, Range, Values};
use crate::params;
use glam::DVec2;

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

/// The row of springs of one contact per lane.
#[derive(Clone, Copy)]
struct Row<L: Lanes = f64> {
    /// Unit vector in the contact plane along which the forces have their first component; zero while nothing has moved.
    axis: L::Vector,
    /// Unit normal of the plane of the axis; zero before the first touch.
    normal: L::Vector,
    /// Radius of the contact circle [m].
    radius: L,
    /// Width of a cell [m]; 0 before the first touch.
    width: L,
    /// Forces of the cells, from the centre outwards [N].
    forces: [[L; 2]; CELLS],
}

/// Scalar product in the plane.
#[inline(always)]
fn inner<L: Lanes>([ax, ay]: [L; 2], [bx, by]: [L; 2]) -> L {
    ax * bx + ay * by
}

#[inline(always)]
fn scaled<L: Lanes>([x, y]: [L; 2], by: L) -> [L; 2] {
    [x * by, y * by]
}

#[inline(always)]
fn difference<L: Lanes>([ax, ay]: [L; 2], [bx, by]: [L; 2]) -> [L; 2] {
    [ax - bx, ay - by]
}

/// A force cut back to the largest that a cell can carry.
#[inline(always)]
fn held<L: Lanes>(force: [L; 2], limit: L) -> [L; 2] {
    let square = inner(force, force);
    let slips = square.gt(limit * limit);
    if slips.any() {
        scaled(force, L::select(slips, limit / square.sqrt(), L::splat(1.0)))
    } else {
        force
    }
}

/// The vector with length 1, or zero.
#[inline(always)]
fn unit<L: Lanes>(vector: L::Vector) -> L::Vector {
    let length = vector.square().sqrt();
    vector * (L::splat(1.0) / length).keep(length.gt(L::splat(0.0)))
}

impl<L: Lanes> Row<L> {
    #[inline(always)]
    fn read(history: &[L]) -> Self {
        let vector = |at: usize| L::Vector::new(history[at], history[at + 1], history[at + 2]);
        let mut forces = [[L::splat(0.0); 2]; CELLS];
        for (force, pair) in forces.iter_mut().zip(history[FORCES..REMEMBERED].chunks_exact(2)) {
            *force = [pair[0], pair[1]];
        }
        Self {
            axis: vector(AXIS),
            normal: vector(NORMAL),
            radius: history[CONTACT_RADIUS],
            width: history[CELL_WIDTH],
            forces,
        }
    }

    /// Into the history of the contacts that bear a load; others forget.
    #[inline(always)]
    fn write(&self, history: &mut [L], bears: L::Mask) {
        history[AXIS..AXIS + 3].copy_from_slice(&self.axis.components());
        history[NORMAL..NORMAL + 3].copy_from_slice(&self.normal.components());
        history[CONTACT_RADIUS] = self.radius;
        history[CELL_WIDTH] = self.width;
        for (force, pair) in self.forces.iter().zip(history[FORCES..REMEMBERED].chunks_exact_mut(2)) {
            pair.copy_from_slice(force);
        }
        for value in &mut history[..REMEMBERED] {
            *value = value.keep(bears);
        }
    }

    /// How much of a cell lies within a contact of this radius.
    #[inline(always)]
    fn touching(&self, cell: usize, radius: L) -> L {
        (radius - self.width * cell as f64).max(L::splat(0.0)).min(self.width)
    }

    /// Energy stored for a stiffness per length [J].
    #[inline(always)]
    fn energy(&self, modulus: f64) -> L {
        let zero = L::splat(0.0);
        let (mut whole, mut part, mut part_width) = (zero, zero, zero);
        for (cell, force) in self.forces.iter().enumerate() {
            let (width, square) = (self.touching(cell, self.radius), inner(*force, *force));
            let touches_whole = width.ge(self.width);
            whole = whole + square.keep(touches_whole);
            part = part + square.keep(!touches_whole);
            part_width = part_width + width.keep(!touches_whole);
        }
        let whole = (whole / self.width).keep(self.width.gt(zero));
        (whole + (part / part_width).keep(part_width.gt(zero))) * (0.5 / modulus)
    }

    /// Turns the forces with the contact, all alike, so that what they store does not change: by the shortest way from
    /// the old normal to the new one, and by the spin about it.
    #[inline(always)]
    fn carry_along(&mut self, input: &TangentialInput<L>) {
        let (normal, zero) = (input.normal, L::splat(0.0));
        let cosine = self.normal.inner(normal);
        let tilted = self.axis - (self.normal + normal) * (self.axis.inner(normal) / (cosine.max(zero) + 1.0));
        let turned = tilted + normal.outer(tilted) * (input.spin * input.dt);
        // rounding must not add up over many steps
        let turned = unit::<L>(turned - normal * turned.inner(normal));
        let stays = cosine.gt(zero) & self.axis.square().gt(zero);
        self.axis = turned;
        if (!stays).any() {
            // unmoved so far, or turned by a right angle in one step: nothing to keep
            self.axis = turned.or(stays, unit::<L>(input.velocity));
            for force in &mut self.forces {
                *force = [force[0].keep(stays), force[1].keep(stays)];
            }
        }
        self.normal = normal;
    }

    /// Takes a new radius of the contact circle: fits the cells to it and drops the load of what lies outside. What contacts without
    /// a load are left with means nothing.
    #[inline(always)]
    fn resize(&mut self, radius: L, scale: L, bears: L::Mask) {
        let zero = L::splat(0.0);
        // widths are the grain's size over powers of two, so that the step of the first touch does not matter
        self.width = L::select(self.width.gt(zero), self.width, scale / CELLS as f64);
        let largest = self.width * CELLS as f64;
        let misfits = bears & (radius.gt(largest) | (largest * 0.5).ge(radius));
        if misfits.any() {
            for lane in (0..L::COUNT).filter(|lane| misfits.bits() >> lane & 1 == 1) {
                self.fit_cells(lane, radius.as_slice()[lane]);
            }
        }
        for cell in 0..CELLS {
            let (before, now) = (self.touching(cell, self.radius), self.touching(cell, radius));
            let shrinks = before.gt(now);
            if shrinks.any() {
                self.forces[cell] = scaled(self.forces[cell], L::select(shrinks, now / before, L::splat(1.0)));
            }
        }
        self.radius = radius;
    }

    #[inline(never)]
    fn fit_cells(&mut self, lane: usize, radius: f64) {
        let of = |value: &L| value.as_slice()[lane];
        let mut row = Cells {
            radius: of(&self.radius),
            width: of(&self.width),
            forces: self.forces.map(|[x, y]| DVec2::new(of(&x), of(&y))),
        };
        row.fit(radius);
        self.radius.as_mut_slice()[lane] = row.radius;
        self.width.as_mut_slice()[lane] = row.width;
        for ([x, y], force) in self.forces.iter_mut().zip(row.forces) {
            x.as_mut_slice()[lane] = force.x;
            y.as_mut_slice()[lane] = force.y;
        }
    }

    /// Moves the springs by half a step before and after the middle of the step; the sliders hold at each of these
    /// times. Returns the force in the middle.
    #[inline(always)]
    fn shear(&mut self, velocity: [L; 2], dt: f64, modulus: f64, limit: L) -> [L; 2] {
        let (zero, one) = (L::splat(0.0), L::splat(1.0));
        let half = scaled(velocity, L::splat(0.5 * dt * modulus));
        let step = self.width / self.radius;
        let (mut sum, mut within) = ([zero; 2], zero);
        for cell in 0..CELLS {
            let way = scaled(half, self.touching(cell, self.radius));
            let edge = (step * (cell + 1) as f64).min(one);
            let up_to_edge = edge * 0.5 * (L::splat(3.0) - edge * edge);
            let cell_limit = limit * (up_to_edge - within);
            within = up_to_edge;
            let middle = held(difference(self.forces[cell], way), cell_limit);
            sum = [sum[0] + middle[0], sum[1] + middle[1]];
            self.forces[cell] = held(difference(middle, way), cell_limit);
        }
        sum
    }
}

/// The cells of one contact whose radius has outgrown them, or they it.
struct Cells {
    radius: f64,
    width: f64,
    forces: [DVec2; CELLS],
}

impl Cells {
    /// Doubles or halves the cells until all of the contact and more than half of the cells touch.
    fn fit(&mut self, radius: f64) {
        while radius > self.width * CELLS as f64 {
            let old = self.forces;
            self.forces = std::array::from_fn(|cell| match old.get(2 * cell..2 * cell + 2) {
                Some(pair) => pair[0] + pair[1],
                None => DVec2::ZERO,
            });
            self.width *= 2.0;
        }
        while radius <= 0.5 * self.width * CELLS as f64 && self.width > f64::MIN_POSITIVE {
            let half = 0.5 * self.width;
            let old = self.forces;
            self.forces = std::array::from_fn(|cell| {
                let whole = (self.radius - (cell / 2) as f64 * self.width).clamp(0.0, self.width);
                let part = (self.radius - cell as f64 * half).clamp(0.0, half);
                if part > 0.0 {
                    old[cell / 2] * (part / whole)
                } else {
                    DVec2::ZERO
                }
            });
            // what lay beyond the cells that were split has left the contact
            self.radius = self.radius.min(half * CELLS as f64);
            self.width = half;
        }
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

    const WIDE: bool = true;

    #[inline(always)]
    fn respond(&self, input: &TangentialInput, history: &mut [f64]) -> TangentialResponse {
        self.respond_wide(input, history)
    }

    #[inline(always)]
    fn respond_wide<L: Lanes>(&self, input: &TangentialInput<L>, history: &mut [L]) -> TangentialResponse<L> {
        let zero = L::splat(0.0);
        let radius = (input.size.radius * input.overlap.max(zero)).sqrt();
        let bears = radius.gt(zero) & input.normal_force.gt(zero);
        let mut row = Row::read(history);
        let before = row.energy(self.modulus);
        row.carry_along(input);
        row.resize(radius, input.size.radius, bears);
        let across = input.normal.outer(row.axis);
        let velocity = [input.velocity.inner(row.axis), input.velocity.inner(across)];
        let limit = self.limit(input.normal_force);
        let middle = row.shear(velocity, input.dt, self.modulus, limit);
        let damping = dashpot(
            self.parameters.damping_ratio,
            radius * self.modulus,
            input.size.tangential_mass(),
        );
        let load = held(difference(middle, scaled(velocity, damping)), limit);
        row.write(history, bears);
        let lost = -inner(load, velocity) * input.dt - (row.energy(self.modulus) - before);
        let force = row.axis * load[0] + across * load[1];
        TangentialResponse {
            force: force.or(bears, L::Vector::null()),
            dissipated: L::select(bears, lost, before),
        }
    }

    #[inline(always)]
    fn limit<L: Lanes>(&self, normal_force: L) -> L {
        normal_force * self.parameters.friction
    }

    fn damping_ratio(&self) -> f64 {
        self.parameters.damping_ratio
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
    use glam::DVec3;

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
            let size = PairSize::new(2e-3, 1e-4);
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

    /// What a cycle between equal displacements either way loses, over what Mindlin and Deresiewicz (1953) say. `share`: of the displacement
    /// at which all slips.
    fn loss_of_a_cycle(fill: f64, share: f64) -> f64 {
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
        contact.dissipated / (area * LIMIT * slip)
    }

    #[test]
    fn a_cycle_dissipates_what_mindlin_and_deresiewicz_say() {
        // twelve cells at most: the loop is a polygon, and a cycle in which no cell slips has none
        for (share, allowed) in [
            (0.9, 0.99..1.035),
            (0.8, 0.99..1.04),
            (0.5, 0.93..1.12),
            (0.3, 0.68..1.45),
            (0.2, 0.33..1.8),
            (0.1, -1e-9..1.8),
        ] {
            let losses = (51..=100).map(|fill| loss_of_a_cycle(f64::from(fill) / 100.0, share));
            let (mut least, mut most) = (f64::INFINITY, 0.0f64);
            for loss in losses {
                (least, most) = (least.min(loss), most.max(loss));
            }
            println!("cycles to {share} of full slip lose {least:.3} to {most:.3} of what they should");
            assert!(
                allowed.contains(&least) && allowed.contains(&most),
                "{share}: {least} to {most}"
            );
        }
    }

    #[test]
    fn cells_follow_the_size_of_the_contact_at_unchanged_force_or_energy() {
        let mut row = Row::read(&[0.0; REMEMBERED]);
        row.resize(0.9, 1.0, true);
        for (cell, force) in row.forces.iter_mut().enumerate().take(11) {
            *force = [1.0 + cell as f64, -0.5];
        }
        let total = |row: &Row| row.forces.iter().map(|force| DVec2::from_array(*force)).sum::<DVec2>();
        let (force, energy) = (total(&row), row.energy(1.0));
        let mut grown = row;
        grown.resize(3.3, 1.0, true);
        assert!((total(&grown) - force).length() < 1e-14 * force.length());
        assert!(grown.energy(1.0) < energy);
        assert!(grown.width == 4.0 * row.width);
        // finer cells alone change neither
        let mut finer = row;
        finer.radius = 0.5;
        finer.forces[6..].fill([0.0; 2]);
        let (force, energy) = (total(&finer), finer.energy(1.0));
        finer.resize(0.5, 1.0, true);
        assert!((total(&finer) - force).length() < 1e-14 * force.length());
        assert!((finer.energy(1.0) / energy - 1.0).abs() < 1e-14);
        assert!(finer.width == 0.5 * row.width);
    }
}
