//! How the bodies of contacts move against each other, and what contact forces do to both of them: for one block of
//! contacts at a time, as columns.

use super::Load;
use crate::particles::{Grains, Row};
use crate::walls::Wall;
use demeter_physics::geometry::contact_sphere_sphere::Contact;
use demeter_physics::lanes::{Kernel, Lanes, Vector};
use glam::DVec3;

/// Contacts in one block: a whole number of lanes, and few enough that all columns stay in the first cache.
pub(super) const BLOCK: usize = 64;

/// One number per contact of a block.
pub(super) type Column = [f64; BLOCK];

/// The contacts of a block while their laws are evaluated.
pub(super) struct Block {
    /// Effective radius and mass [m, kg].
    pub(super) radius: Column,
    pub(super) mass: Column,
    pub(super) normal: [Column; 3],
    pub(super) overlap: Column,
    /// Rate of approach [m/s].
    pub(super) rate: Column,
    /// Velocity of the first body relative to the second in the contact plane [m/s].
    pub(super) sliding: [Column; 3],
    /// Mean angular velocity about the normal [1/s].
    pub(super) spin: Column,
    /// Effective mass of tangential motion [kg].
    pub(super) tangential_mass: Column,
    /// Relative angular velocity in the contact plane [1/s], and the effective moment of inertia of rolling [kg m^2].
    pub(super) rolling: [Column; 3],
    pub(super) rolling_inertia: Column,
    /// Normal force, before and after the laws were asked [N].
    pub(super) force: Column,
    /// Its part that does not depend on the rate [N].
    pub(super) elastic: Column,
    /// Normal force that friction and rolling resistance are limited by: with the pull of adhesion, not negative [N].
    pub(super) friction_load: Column,
    /// Overlap of Hertzian contacts of the same area [m].
    pub(super) bearing_overlap: Column,
    /// Force on the first body in the contact plane [N], and torque of the rolling law [N m].
    pub(super) tangential: [Column; 3],
    pub(super) torque: [Column; 3],
    /// Energy that each contact took out of the motion in this step [J], by law family in turn.
    pub(super) loss: [Column; 2],
}

impl Block {
    pub(super) const EMPTY: Self = Self {
        radius: [0.0; BLOCK],
        mass: [0.0; BLOCK],
        normal: [[0.0; BLOCK]; 3],
        overlap: [0.0; BLOCK],
        rate: [0.0; BLOCK],
        sliding: [[0.0; BLOCK]; 3],
        spin: [0.0; BLOCK],
        tangential_mass: [0.0; BLOCK],
        rolling: [[0.0; BLOCK]; 3],
        rolling_inertia: [0.0; BLOCK],
        force: [0.0; BLOCK],
        elastic: [0.0; BLOCK],
        friction_load: [0.0; BLOCK],
        bearing_overlap: [0.0; BLOCK],
        tangential: [[0.0; BLOCK]; 3],
        torque: [[0.0; BLOCK]; 3],
        loss: [[0.0; BLOCK]; 2],
    };
}

/// Three columns as vectors, from contact `k` on.
#[inline(always)]
pub(super) fn vectors<L: Lanes>(columns: &[Column; 3], k: usize) -> L::Vector {
    L::Vector::new(
        L::load(&columns[0][k..]),
        L::load(&columns[1][k..]),
        L::load(&columns[2][k..]),
    )
}

/// Puts vectors into three columns, from contact `k` on.
#[inline(always)]
pub(super) fn put_vectors<L: Lanes>(vectors: L::Vector, columns: &mut [Column; 3], k: usize) {
    for (component, column) in vectors.components().into_iter().zip(columns) {
        component.store(&mut column[k..]);
    }
}

/// The second bodies of the contacts of a block.
pub(super) trait Partners {
    /// Velocity, with the inverse mass.
    fn velocity(&self, k: usize) -> &[f64; 4];
    /// Angular velocity, with the inverse moment of inertia.
    fn spin(&self, k: usize) -> &[f64; 4];
    /// Effective radius of contacts whose first bodies have these radii, from contact `k` on.
    fn effective_radius<L: Lanes>(&self, first: L, at: impl Fn(usize) -> usize) -> L;
}

/// Grains as second bodies.
pub(super) struct Others<'a> {
    pub(super) grains: &'a Grains,
    pub(super) j: &'a [u32],
}

impl Partners for Others<'_> {
    #[inline(always)]
    fn velocity(&self, k: usize) -> &[f64; 4] {
        self.grains.velocity.rows()[self.j[k] as usize].as_array()
    }

    #[inline(always)]
    fn spin(&self, k: usize) -> &[f64; 4] {
        self.grains.angular_velocity.rows()[self.j[k] as usize].as_array()
    }

    #[inline(always)]
    fn effective_radius<L: Lanes>(&self, first: L, at: impl Fn(usize) -> usize) -> L {
        let second = L::from_fn(|lane| self.grains.position.scalar(self.j[at(lane)] as usize));
        first * second / (first + second)
    }
}

/// Walls as second bodies: how their surfaces move at the contacts.
pub(super) struct Surfaces {
    velocity: [Row; BLOCK],
    spin: [Row; BLOCK],
}

impl Surfaces {
    /// Of contacts of grains with walls.
    pub(super) fn new(contacts: &[Contact], i: &[u32], j: &[u32], grains: &Grains, walls: &[Wall]) -> Self {
        let still = Row {
            vector: DVec3::ZERO,
            scalar: 0.0,
        };
        let (mut velocity, mut spin) = ([still; BLOCK], [still; BLOCK]);
        for (k, contact) in contacts.iter().enumerate() {
            let wall = &walls[j[k] as usize];
            let point = grains.position[i[k] as usize] - contact.normal * contact.lever_i;
            velocity[k].vector = wall.velocity_at(point);
            spin[k].vector = wall.angular_velocity();
        }
        Self { velocity, spin }
    }
}

impl Partners for Surfaces {
    #[inline(always)]
    fn velocity(&self, k: usize) -> &[f64; 4] {
        self.velocity[k].as_array()
    }

    #[inline(always)]
    fn spin(&self, k: usize) -> &[f64; 4] {
        self.spin[k].as_array()
    }

    #[inline(always)]
    fn effective_radius<L: Lanes>(&self, first: L, _at: impl Fn(usize) -> usize) -> L {
        first
    }
}

/// Finds how the bodies of at most [`BLOCK`] contacts move against each other.
pub(super) struct Gather<'a, P> {
    pub(super) block: &'a mut Block,
    pub(super) contacts: &'a [Contact],
    pub(super) grains: &'a Grains,
    pub(super) i: &'a [u32],
    pub(super) partners: &'a P,
    /// Whether some law resists rolling.
    pub(super) rolling: bool,
}

impl<P: Partners> Kernel for Gather<'_, P> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self) {
        let (block, grains) = (self.block, self.grains);
        let last = self.contacts.len() - 1;
        for k in (0..self.contacts.len()).step_by(L::COUNT) {
            // lanes beyond the end repeat the last contact
            let at = |lane: usize| (k + lane).min(last);
            let first = |lane: usize| self.i[at(lane)] as usize;
            let [nx, ny, nz, overlap] = L::columns(|lane| self.contacts[at(lane)].plane());
            let [_, _, lever_i, lever_j] = L::columns(|lane| self.contacts[at(lane)].levers());
            let [vx, vy, vz, inverse_mass] = L::columns(|lane| grains.velocity.rows()[first(lane)].as_array());
            let [wx, wy, wz, inverse_inertia] =
                L::columns(|lane| grains.angular_velocity.rows()[first(lane)].as_array());
            let [ux, uy, uz, other_mass] = L::columns(|lane| self.partners.velocity(at(lane)));
            let [sx, sy, sz, other_inertia] = L::columns(|lane| self.partners.spin(at(lane)));
            let n = L::Vector::new(nx, ny, nz);
            let (omega_i, omega_j) = (L::Vector::new(wx, wy, wz), L::Vector::new(sx, sy, sz));
            let arms = omega_i * lever_i + omega_j * lever_j;
            // a wall's velocity is that of its surface already, so its lever is 0
            let velocity = L::Vector::new(vx - ux, vy - uy, vz - uz) - arms.outer(n);
            let rate = -velocity.inner(n);
            let radius = L::from_fn(|lane| grains.position.scalar(first(lane)));
            let inverse = inverse_mass + other_mass;
            let tangential = inverse + lever_i * lever_i * inverse_inertia + lever_j * lever_j * other_inertia;
            let one = L::splat(1.0);
            put_vectors::<L>(n, &mut block.normal, k);
            overlap.store(&mut block.overlap[k..]);
            rate.store(&mut block.rate[k..]);
            put_vectors::<L>(velocity + n * rate, &mut block.sliding, k);
            ((omega_i + omega_j).inner(n) * 0.5).store(&mut block.spin[k..]);
            self.partners.effective_radius(radius, at).store(&mut block.radius[k..]);
            (one / inverse).store(&mut block.mass[k..]);
            (one / tangential).store(&mut block.tangential_mass[k..]);
            if self.rolling {
                let rolling = omega_i - omega_j;
                put_vectors::<L>(rolling - n * rolling.inner(n), &mut block.rolling, k);
                let inverse = about_contact(inverse_mass, inverse_inertia, lever_i)
                    + about_contact(other_mass, other_inertia, lever_j);
                (one / inverse).store(&mut block.rolling_inertia[k..]);
            }
        }
    }
}

/// Inverse moment of inertia about a point at a distance from the centre, `1/(I + m l^2)` [1/(kg m^2)]; 0 of a body that
/// does not move.
#[inline(always)]
fn about_contact<L: Lanes>(inverse_mass: L, inverse_inertia: L, lever: L) -> L {
    let product = inverse_mass * inverse_inertia;
    (product / (inverse_mass + lever * lever * inverse_inertia)).keep(product.gt(L::splat(0.0)))
}

/// Writes down what the forces of a block do to both bodies.
pub(super) struct Write<'a> {
    pub(super) block: &'a Block,
    pub(super) contacts: &'a [Contact],
    pub(super) loads: &'a mut [Load],
}

impl Kernel for Write<'_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self) {
        let last = self.contacts.len() - 1;
        for k in (0..self.contacts.len()).step_by(L::COUNT) {
            let at = |lane: usize| (k + lane).min(last);
            let [_, _, lever_i, lever_j] = L::columns(|lane| self.contacts[at(lane)].levers());
            let n: L::Vector = vectors::<L>(&self.block.normal, k);
            let tangential: L::Vector = vectors::<L>(&self.block.tangential, k);
            let [fx, fy, fz] = (n * L::load(&self.block.force[k..]) + tangential).components();
            let [ax, ay, az] = n.outer(tangential).components();
            let count = L::COUNT.min(self.loads.len() - k);
            L::rows([fx, fy, fz, lever_i], |lane, row| {
                if lane < count {
                    self.loads[k + lane].force = row;
                }
            });
            L::rows([ax, ay, az, lever_j], |lane, row| {
                if lane < count {
                    self.loads[k + lane].arm = row;
                }
            });
        }
    }
}
