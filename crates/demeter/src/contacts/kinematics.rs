//! How the bodies of contacts move against each other, and what contact forces do to both of them: for one block of
//! contacts at a time, as columns.

use super::meetings::{Lot, Meeting, lanes_below};
use super::{Load, Scene};
use crate::particles::Grains;
use crate::walls::Wall;
use demeter_physics::geometry::contact_sphere_sphere::Contact;
use demeter_physics::lanes::{Index, Kernel, Lanes, MOST_LANES, Mask, Places, Vector};

/// Contacts in one block: a whole number of lanes, and few enough that all columns stay in the first cache.
pub(super) const BLOCK: usize = 64;

/// One number per contact of a block.
pub(super) type Column = [f64; BLOCK];

/// The contacts of a block while their laws are evaluated. Aligned, so that lanes lie within lines of the cache.
#[repr(align(64))]
pub(super) struct Block {
    /// Effective radius and mass [m, kg].
    pub(super) radius: Column,
    pub(super) mass: Column,
    pub(super) normal: [Column; 3],
    pub(super) overlap: Column,
    /// Distances of the contact point from both centres [m].
    pub(super) levers: [Column; 2],
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
    /// Bits of the contacts that act; the others have no force.
    pub(super) acts: u64,
}

impl Block {
    pub(super) const EMPTY: Self = Self {
        radius: [0.0; BLOCK],
        mass: [0.0; BLOCK],
        normal: [[0.0; BLOCK]; 3],
        overlap: [0.0; BLOCK],
        levers: [[0.0; BLOCK]; 2],
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
        acts: 0,
    };

    /// Which of the lanes from contact `k` on act.
    #[inline(always)]
    pub(super) fn acting<L: Lanes>(&self, k: usize) -> u32 {
        (self.acts >> k) as u32 & lanes_below(L::COUNT)
    }

    /// Lets a contact that does not act have no force.
    pub(super) fn silence(&mut self, k: usize) {
        self.force[k] = 0.0;
        self.elastic[k] = 0.0;
        self.friction_load[k] = 0.0;
        for column in self.tangential.iter_mut().chain(&mut self.torque).chain(&mut self.loss) {
            column[k] = 0.0;
        }
    }
}

/// Bits of the first contacts of a block.
#[inline(always)]
pub(super) fn first_bits(count: usize) -> u64 {
    if count >= BLOCK { u64::MAX } else { (1 << count) - 1 }
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

/// What is listed for the lanes from contact `k` on; lanes beyond the end repeat the last contact.
#[inline(always)]
pub(super) fn listed<L: Lanes>(list: &[u32], k: usize) -> Index {
    let mut index = [0; MOST_LANES];
    if let Some(list) = list.get(k..k + L::COUNT) {
        index[..L::COUNT].copy_from_slice(list);
    } else {
        let mut lane = 0;
        while lane < L::COUNT {
            index[lane] = list[(k + lane).min(list.len() - 1)];
            lane += 1;
        }
    }
    index
}

/// Places of the lanes from contact `k` on, `width` numbers each; lanes beyond the end repeat the last contact.
#[inline(always)]
pub(super) fn places_in_turn<L: Lanes>(count: usize, k: usize, width: usize) -> Places {
    let mut places = [0; MOST_LANES];
    let mut lane = 0;
    if k + L::COUNT <= count {
        while lane < L::COUNT {
            places[lane] = width * (k + lane);
            lane += 1;
        }
    } else {
        while lane < L::COUNT {
            places[lane] = width * (k + lane).min(count - 1);
            lane += 1;
        }
    }
    places
}

/// The second bodies of the contacts of a block: rows of numbers, and which of them belong to which contact.
#[derive(Clone, Copy)]
pub(super) struct Partners<'a> {
    /// Velocities, with the inverse masses.
    velocity: &'a [[f64; 4]],
    /// Angular velocities, with the inverse moments of inertia.
    spin: &'a [[f64; 4]],
    /// Positions, with the radii; none of walls.
    position: Option<&'a [[f64; 4]]>,
    index: &'a [u32],
}

impl<'a> Partners<'a> {
    /// Grains as second bodies.
    pub(super) fn grains(grains: &'a Grains, j: &'a [u32]) -> Self {
        Self {
            velocity: grains.velocity.table(),
            spin: grains.angular_velocity.table(),
            position: Some(grains.position.table()),
            index: j,
        }
    }

    /// Walls as second bodies.
    pub(super) fn walls(surfaces: &'a Surfaces, count: usize) -> Self {
        Self {
            velocity: &surfaces.velocity,
            spin: &surfaces.spin,
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

/// How two bodies in contact move, one contact per lane.
struct Motion<L: Lanes> {
    /// Unit vector from the second body to the first.
    normal: L::Vector,
    overlap: L,
    /// Velocity of the first body relative to the second: of the centres, or of a grain's centre and a wall's surface.
    velocity: L::Vector,
    /// Rate of approach.
    rate: L,
    /// Distances of the contact point from the centres; of a wall 0, whose velocity is that of its surface.
    levers: [L; 2],
    inverse_masses: [L; 2],
    spins: [L::Vector; 2],
    inverse_inertias: [L; 2],
    /// Effective radius.
    radius: L,
}

impl<L: Lanes> Motion<L> {
    /// Puts what laws ask for into a block, from contact `k` on.
    #[inline(always)]
    fn put(&self, block: &mut Block, k: usize, rolling: bool) {
        assert!(k <= BLOCK - L::COUNT);
        let one = L::splat(1.0);
        let (n, [lever_i, lever_j], [spin_i, spin_j]) = (self.normal, self.levers, self.spins);
        let ([mass_i, mass_j], [inertia_i, inertia_j]) = (self.inverse_masses, self.inverse_inertias);
        let arms = spin_i * lever_i + spin_j * lever_j;
        let inverse = mass_i + mass_j;
        let tangential = inverse + lever_i * lever_i * inertia_i + lever_j * lever_j * inertia_j;
        put_vectors::<L>(n, &mut block.normal, k);
        self.overlap.store(&mut block.overlap[k..]);
        lever_i.store(&mut block.levers[0][k..]);
        lever_j.store(&mut block.levers[1][k..]);
        self.rate.store(&mut block.rate[k..]);
        put_vectors::<L>(self.velocity + n * self.rate - arms.outer(n), &mut block.sliding, k);
        ((spin_i + spin_j).inner(n) * 0.5).store(&mut block.spin[k..]);
        self.radius.store(&mut block.radius[k..]);
        (one / inverse).store(&mut block.mass[k..]);
        (one / tangential).store(&mut block.tangential_mass[k..]);
        if rolling {
            let rolling = spin_i - spin_j;
            put_vectors::<L>(rolling - n * rolling.inner(n), &mut block.rolling, k);
            let inverse = about_contact(mass_i, inertia_i, lever_i) + about_contact(mass_j, inertia_j, lever_j);
            (one / inverse).store(&mut block.rolling_inertia[k..]);
        }
    }
}

/// Overlap, as a share of the radius, of lanes that do not act.
const GENTLE: f64 = 1e-3;

/// Contacts ahead of which the rows of both grains are fetched, as memory is slow.
const AHEAD: usize = 32;

/// Finds which of at most [`BLOCK`] pairs of grains act, and how they move against each other. Tells the first with too much
/// overlap.
pub(super) struct Approach<'a> {
    pub(super) block: &'a mut Block,
    pub(super) scene: &'a Scene<'a>,
    /// How many pairs.
    pub(super) count: usize,
    /// Grains of these pairs and of those that come later.
    pub(super) i: &'a [u32],
    pub(super) j: &'a [u32],
    /// Codes of their shifts across periodic sides; empty where there are none.
    pub(super) shift: &'a [u8],
}

impl Kernel for Approach<'_> {
    type Output = Option<usize>;

    #[inline(always)]
    fn run<L: Lanes>(self) -> Option<usize> {
        let Self {
            block, scene, count, ..
        } = self;
        let meeting = Meeting::new(scene);
        let mut lot = Lot::empty();
        let mut too_deep = None;
        block.acts = 0;
        for k in (0..count).step_by(L::COUNT) {
            let ahead = k + AHEAD..k + AHEAD + L::COUNT;
            if let (Some(first), Some(second)) = (self.i.get(ahead.clone()), self.j.get(ahead)) {
                meeting.prefetch::<L>(first);
                meeting.prefetch::<L>(second);
            }
            lot.first = listed::<L>(&self.i[..count], k);
            lot.second = listed::<L>(&self.j[..count], k);
            if !self.shift.is_empty() {
                lot.put_shifts::<L>(&self.shift[..count], k);
            }
            let met = meeting.meet::<L>(&lot, lanes_below((count - k).min(L::COUNT)));
            if met.acts == 0 {
                continue;
            }
            block.acts |= u64::from(met.acts) << k;
            if met.too_deep != 0 && too_deep.is_none() {
                too_deep = Some(k + met.too_deep.trailing_zeros() as usize);
            }
            let [[wx, wy, wz, inverse_inertia], [sx, sy, sz, other_inertia]] = met.spins;
            let [ri, rj] = met.radii;
            // lanes that do not act look like a gentle contact: no law takes the longer way of one that begins or ends
            let acting = L::Mask::of_bits(met.acts);
            let motion = Motion::<L> {
                normal: met.normal,
                overlap: L::select(acting, met.overlap, ri * GENTLE),
                velocity: met.velocity,
                rate: met.rate.keep(acting),
                levers: met.levers,
                inverse_masses: met.inverse_masses,
                spins: [L::Vector::new(wx, wy, wz), L::Vector::new(sx, sy, sz)],
                inverse_inertias: [inverse_inertia, other_inertia],
                radius: ri * rj / (ri + rj),
            };
            motion.put(block, k, scene.resists_rolling);
        }
        too_deep
    }
}

/// Finds how the bodies of at most [`BLOCK`] contacts move against each other whose geometry is known.
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
        let tables = grains.tables();
        block.acts = first_bits(self.contacts.len());
        for k in (0..self.contacts.len()).step_by(L::COUNT) {
            let mut here = places_in_turn::<L>(self.contacts.len(), k, Contact::NUMBERS);
            let (first, second) = (listed::<L>(self.i, k), listed::<L>(partners.index, k));
            let [nx, ny, nz, overlap] = L::columns(contacts, &here);
            shift(&mut here, 2);
            let [_, _, lever_i, lever_j] = L::columns(contacts, &here);
            let [[_, _, _, ri], [vx, vy, vz, inverse_mass], [wx, wy, wz, inverse_inertia]] = L::fetch(tables, &first);
            let [[ux, uy, uz, other_mass], [sx, sy, sz, other_inertia]] =
                L::fetch([partners.velocity, partners.spin], &second);
            let normal = L::Vector::new(nx, ny, nz);
            let velocity = L::Vector::new(vx - ux, vy - uy, vz - uz);
            let spins = [L::Vector::new(wx, wy, wz), L::Vector::new(sx, sy, sz)];
            let radius = if let Some(position) = partners.position {
                let [[_, _, _, rj]] = L::fetch([position], &second);
                ri * rj / (ri + rj)
            } else {
                ri
            };
            let motion = Motion::<L> {
                normal,
                overlap,
                velocity,
                rate: -velocity.inner(normal),
                levers: [lever_i, lever_j],
                inverse_masses: [inverse_mass, other_mass],
                spins,
                inverse_inertias: [inverse_inertia, other_inertia],
                radius,
            };
            motion.put(block, k, self.rolling);
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
    pub(super) loads: &'a mut [Load],
}

impl Kernel for Write<'_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self) {
        let Self { block, loads } = self;
        for k in (0..loads.len()).step_by(L::COUNT) {
            assert!(k <= BLOCK - L::COUNT);
            let acting = L::Mask::of_bits(block.acting::<L>(k));
            let n: L::Vector = vectors::<L>(&block.normal, k);
            let tangential: L::Vector = vectors::<L>(&block.tangential, k);
            let nothing = L::Vector::null();
            let force = (n * L::load(&block.force[k..]) + tangential).or(acting, nothing);
            let arm = n.outer(tangential).or(acting, nothing);
            let ([fx, fy, fz], [ax, ay, az]) = (force.components(), arm.components());
            let forces = L::rows([fx, fy, fz, L::load(&block.levers[0][k..]).keep(acting)]);
            let arms = L::rows([ax, ay, az, L::load(&block.levers[1][k..]).keep(acting)]);
            let here = k..(k + L::COUNT).min(loads.len());
            let rows = forces.as_ref().iter().zip(arms.as_ref());
            for (load, (force, arm)) in loads[here].iter_mut().zip(rows) {
                load.force = *force;
                load.arm = *arm;
            }
        }
    }
}
