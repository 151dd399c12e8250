//! How the bodies of contacts move against each other, and what contact forces do to both of them: for one block of
//! contacts at a time, as columns.

use super::Load;
use crate::particles::Grains;
use crate::walls::Wall;
use demeter_physics::geometry::contact_sphere_sphere::Contact;
use demeter_physics::lanes::{Kernel, Lanes, MOST_LANES, Places, Vector};

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
    let [x, y, z] = vectors.components();
    x.store(&mut columns[0][k..]);
    y.store(&mut columns[1][k..]);
    z.store(&mut columns[2][k..]);
}

/// Places of the lanes from contact `k` on, `width` numbers each; lanes beyond the end repeat the last contact.
#[inline(always)]
pub(super) fn places<L: Lanes>(index: &[u32], k: usize, width: usize) -> Places {
    let mut places = [0; MOST_LANES];
    let last = index.len() - 1;
    let mut lane = 0;
    while lane < L::COUNT {
        places[lane] = width * index[(k + lane).min(last)] as usize;
        lane += 1;
    }
    places
}

/// The same where contacts follow each other.
#[inline(always)]
pub(super) fn places_in_turn<L: Lanes>(count: usize, k: usize, width: usize) -> Places {
    let mut places = [0; MOST_LANES];
    let mut lane = 0;
    while lane < L::COUNT {
        places[lane] = width * (k + lane).min(count - 1);
        lane += 1;
    }
    places
}

/// The second bodies of the contacts of a block: rows of numbers, and which of them belong to which contact.
#[derive(Clone, Copy)]
pub(super) struct Partners<'a> {
    /// Velocities, with the inverse masses.
    velocity: &'a [f64],
    /// Angular velocities, with the inverse moments of inertia.
    spin: &'a [f64],
    /// Positions, with the radii; none of walls.
    position: Option<&'a [f64]>,
    index: &'a [u32],
}

impl<'a> Partners<'a> {
    /// Grains as second bodies.
    pub(super) fn grains(grains: &'a Grains, j: &'a [u32]) -> Self {
        Self {
            velocity: grains.velocity.numbers(),
            spin: grains.angular_velocity.numbers(),
            position: Some(grains.position.numbers()),
            index: j,
        }
    }

    /// Walls as second bodies.
    pub(super) fn walls(surfaces: &'a Surfaces, count: usize) -> Self {
        Self {
            velocity: surfaces.velocity.as_flattened(),
            spin: surfaces.spin.as_flattened(),
            position: None,
            index: &IN_TURN[..count],
        }
    }
}

const IN_TURN: [u32; BLOCK] = {
    let mut index = [0; BLOCK];
    let mut k = 0;
    while k < BLOCK {
        index[k] = k as u32;
        k += 1;
    }
    index
};

/// How the surfaces of walls move at the contacts of a block.
pub(super) struct Surfaces {
    velocity: [[f64; 4]; BLOCK],
    spin: [[f64; 4]; BLOCK],
}

impl Surfaces {
    /// Of contacts of grains with walls.
    pub(super) fn new(contacts: &[Contact], i: &[u32], j: &[u32], grains: &Grains, walls: &[Wall]) -> Self {
        let (mut velocity, mut spin) = ([[0.0; 4]; BLOCK], [[0.0; 4]; BLOCK]);
        for (k, contact) in contacts.iter().enumerate() {
            let wall = &walls[j[k] as usize];
            let point = grains.position[i[k] as usize] - contact.normal * contact.lever_i;
            velocity[k] = wall.velocity_at(point).extend(0.0).to_array();
            spin[k] = wall.angular_velocity().extend(0.0).to_array();
        }
        Self { velocity, spin }
    }
}

/// Finds how the bodies of at most [`BLOCK`] contacts move against each other.
pub(super) struct Gather<'a> {
    pub(super) block: &'a mut Block,
    pub(super) contacts: &'a [Contact],
    pub(super) grains: &'a Grains,
    pub(super) i: &'a [u32],
    pub(super) partners: Partners<'a>,
    /// Whether some law resists rolling.
    pub(super) rolling: bool,
}

impl Kernel for Gather<'_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self) {
        let Self {
            block,
            grains,
            partners,
            ..
        } = self;
        let contacts = Contact::numbers(self.contacts);
        let (velocity, spin) = (grains.velocity.numbers(), grains.angular_velocity.numbers());
        let one = L::splat(1.0);
        for k in (0..self.contacts.len()).step_by(L::COUNT) {
            let mut here = places_in_turn::<L>(self.contacts.len(), k, Contact::NUMBERS);
            let (first, second) = (places::<L>(self.i, k, 4), places::<L>(partners.index, k, 4));
            let [nx, ny, nz, overlap] = L::columns(contacts, &here);
            shift(&mut here, 2);
            let [_, _, lever_i, lever_j] = L::columns(contacts, &here);
            let [vx, vy, vz, inverse_mass] = L::columns(velocity, &first);
            let [wx, wy, wz, inverse_inertia] = L::columns(spin, &first);
            let [ux, uy, uz, other_mass] = L::columns(partners.velocity, &second);
            let [sx, sy, sz, other_inertia] = L::columns(partners.spin, &second);
            let n = L::Vector::new(nx, ny, nz);
            let (omega_i, omega_j) = (L::Vector::new(wx, wy, wz), L::Vector::new(sx, sy, sz));
            let arms = omega_i * lever_i + omega_j * lever_j;
            // a wall's velocity is that of its surface already, so its lever is 0
            let velocity = L::Vector::new(vx - ux, vy - uy, vz - uz) - arms.outer(n);
            let rate = -velocity.inner(n);
            let inverse = inverse_mass + other_mass;
            let tangential = inverse + lever_i * lever_i * inverse_inertia + lever_j * lever_j * other_inertia;
            put_vectors::<L>(n, &mut block.normal, k);
            overlap.store(&mut block.overlap[k..]);
            rate.store(&mut block.rate[k..]);
            put_vectors::<L>(velocity + n * rate, &mut block.sliding, k);
            ((omega_i + omega_j).inner(n) * 0.5).store(&mut block.spin[k..]);
            (one / inverse).store(&mut block.mass[k..]);
            (one / tangential).store(&mut block.tangential_mass[k..]);
            if self.rolling {
                let rolling = omega_i - omega_j;
                put_vectors::<L>(rolling - n * rolling.inner(n), &mut block.rolling, k);
                let inverse = about_contact(inverse_mass, inverse_inertia, lever_i)
                    + about_contact(other_mass, other_inertia, lever_j);
                (one / inverse).store(&mut block.rolling_inertia[k..]);
            }
            let mut radii = first;
            shift(&mut radii, 3);
            let radius = L::gather(grains.position.numbers(), &radii);
            let effective = if let Some(position) = partners.position {
                let mut radii = second;
                shift(&mut radii, 3);
                let other = L::gather(position, &radii);
                radius * other / (radius + other)
            } else {
                radius
            };
            effective.store(&mut block.radius[k..]);
        }
    }
}

/// Moves all places.
#[inline(always)]
pub(super) fn shift(places: &mut Places, by: usize) {
    let mut lane = 0;
    while lane < MOST_LANES {
        places[lane] += by;
        lane += 1;
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
        let contacts = Contact::numbers(self.contacts);
        for k in (0..self.contacts.len()).step_by(L::COUNT) {
            let mut here = places_in_turn::<L>(self.contacts.len(), k, Contact::NUMBERS);
            shift(&mut here, 2);
            let [_, _, lever_i, lever_j] = L::columns(contacts, &here);
            let n: L::Vector = vectors::<L>(&self.block.normal, k);
            let tangential: L::Vector = vectors::<L>(&self.block.tangential, k);
            let [fx, fy, fz] = (n * L::load(&self.block.force[k..]) + tangential).components();
            let [ax, ay, az] = n.outer(tangential).components();
            let forces = L::rows([fx, fy, fz, lever_i]);
            let arms = L::rows([ax, ay, az, lever_j]);
            let here = k..(k + L::COUNT).min(self.loads.len());
            for (lane, load) in self.loads[here].iter_mut().enumerate() {
                load.force = forces[lane];
                load.arm = arms[lane];
            }
        }
    }
}
