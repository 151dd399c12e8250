//! How the bodies of contacts move against each other, several contacts at a time.

use super::Scene;
use super::bodies::Bodies;
use super::evaluate::WORD;
use super::meetings::Meeting;
use crate::particles::Grains;
use demeter_physics::contact::PairSize;
use demeter_physics::geometry::contact_sphere_sphere::Contact;
use demeter_physics::lanes::{Index, Lanes, MOST_LANES, Mask, Places, Vector};

/// Numbers of contacts from `k` on as lanes; 0 in lanes beyond the end.
#[inline(always)]
pub(super) fn load_some<L: Lanes>(from: &[f32], k: usize) -> L {
    match from.get(k..k + L::COUNT) {
        Some(all) => L::load_singles(all),
        None => L::load_singles(&last_numbers(from, k)),
    }
}

// the ends of lists are rare: in functions of their own they cost the others nothing

#[cold]
#[inline(never)]
fn last_numbers(from: &[f32], k: usize) -> [f32; MOST_LANES] {
    let mut some = [0.0; MOST_LANES];
    let rest = &from[k..];
    some[..rest.len()].copy_from_slice(rest);
    some
}

/// Puts lanes as the numbers of contacts from `k` on; not those beyond the end.
#[inline(always)]
pub(super) fn store_some<L: Lanes>(lanes: L, to: &mut [f64], k: usize) {
    match to.get_mut(k..k + L::COUNT) {
        Some(all) => lanes.store(all),
        None => put_last(&lanes.to_array(), to, k),
    }
}

/// The same, rounded to numbers of half the precision.
#[inline(always)]
pub(super) fn store_some_singles<L: Lanes>(lanes: L, to: &mut [f32], k: usize) {
    match to.get_mut(k..k + L::COUNT) {
        Some(all) => lanes.store_singles(all),
        None => put_last(&lanes.to_array().map(|number| number as f32), to, k),
    }
}

#[cold]
#[inline(never)]
fn put_last<T: Copy>(numbers: &[T; MOST_LANES], to: &mut [T], k: usize) {
    let rest = &mut to[k..];
    rest.copy_from_slice(&numbers[..rest.len()]);
}

/// Puts what is listed for the lanes from contact `k` on; lanes beyond the end repeat the last contact. An index that is put where it
/// is used is never copied as a whole: to read at once what was written in parts, the processor waits until all of it is in memory.
#[inline(always)]
pub(super) fn put_listed<L: Lanes>(list: &[u32], k: usize, index: &mut Index) {
    match list.get(k..k + L::COUNT) {
        Some(all) => index[..L::COUNT].copy_from_slice(all),
        None => {
            let last = last_listed(list, k);
            index[..L::COUNT].copy_from_slice(&last[..L::COUNT]);
        }
    }
}

/// What is listed from a place on; beyond the end the last.
#[cold]
#[inline(never)]
pub(super) fn last_listed<T: Copy>(list: &[T], k: usize) -> [T; MOST_LANES] {
    std::array::from_fn(|lane| list[(k + lane).min(list.len() - 1)])
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

/// How two bodies in contact move, one contact per lane.
pub(super) struct Motion<L: Lanes> {
    /// Unit vector from the second body to the first.
    pub(super) normal: L::Vector,
    /// Overlap [m].
    pub(super) overlap: L,
    /// Velocity of the first body relative to the second: of the centres, or of a grain's centre and a wall's surface [m/s].
    pub(super) velocity: L::Vector,
    /// Rate of approach [m/s].
    pub(super) rate: L,
    /// Distances of the contact point from the centres [m]; of a wall 0, whose velocity is that of its surface.
    pub(super) levers: [L; 2],
    /// Inverse effective mass along the normal [1/kg].
    pub(super) inverse_mass: L,
    /// Inverse masses across it [1/kg]: walls count as too heavy to give way.
    pub(super) inverse_masses: [L; 2],
    /// Effective radius and mass.
    pub(super) size: PairSize<L>,
}

/// How two bodies in contact turn, one contact per lane.
pub(super) struct Turning<L: Lanes> {
    spins: [L::Vector; 2],
    inverse_inertias: [L; 2],
}

impl<L: Lanes> Turning<L> {
    /// Of rows of tables: angular velocities with the inverse moments of inertia.
    #[inline(always)]
    pub(super) fn of([wx, wy, wz, inverse_inertia]: [L; 4], [sx, sy, sz, other_inertia]: [L; 4]) -> Self {
        Self {
            spins: [L::Vector::new(wx, wy, wz), L::Vector::new(sx, sy, sz)],
            inverse_inertias: [inverse_inertia, other_inertia],
        }
    }

    /// Velocity of the first body relative to the second in the contact plane, at the contact point [m/s].
    #[inline(always)]
    pub(super) fn sliding(&self, motion: &Motion<L>) -> L::Vector {
        let arms = self.spins[0] * motion.levers[0] + self.spins[1] * motion.levers[1];
        motion.velocity + motion.normal * motion.rate - arms.outer(motion.normal)
    }

    /// Mean angular velocity about the normal [1/s].
    #[inline(always)]
    pub(super) fn spin(&self, motion: &Motion<L>) -> L {
        (self.spins[0] + self.spins[1]).inner(motion.normal) * 0.5
    }

    /// Relative angular velocity about the normal [1/s].
    #[inline(always)]
    pub(super) fn twist(&self, motion: &Motion<L>) -> L {
        (self.spins[0] - self.spins[1]).inner(motion.normal)
    }

    /// Relative angular velocity in the contact plane [1/s].
    #[inline(always)]
    pub(super) fn rolling(&self, motion: &Motion<L>) -> L::Vector {
        let rolling = self.spins[0] - self.spins[1];
        rolling - motion.normal * rolling.inner(motion.normal)
    }

    /// Effective moment of inertia of rolling [kg m^2].
    #[inline(always)]
    pub(super) fn rolling_inertia(&self, motion: &Motion<L>) -> L {
        let inverse = about_contact(motion.inverse_masses[0], self.inverse_inertias[0], motion.levers[0])
            + about_contact(motion.inverse_masses[1], self.inverse_inertias[1], motion.levers[1]);
        L::splat(1.0) / inverse
    }
}

/// Effective radius and mass of two grains, with one quotient for both.
#[inline(always)]
fn size_of_pair<L: Lanes>([ri, rj]: [L; 2], [mass_i, mass_j]: [L; 2]) -> PairSize<L> {
    let (radii, inverse) = (ri + rj, mass_i + mass_j);
    let quotient = L::splat(1.0) / (radii * inverse);
    PairSize::new(ri * rj * inverse * quotient, radii * quotient)
}

/// Some contacts as they are in this step.
pub(super) struct Sight<L: Lanes> {
    pub(super) motion: Motion<L>,
    pub(super) turning: Turning<L>,
    /// Lanes that act in this step, as a mask and as bits.
    pub(super) acting: L::Mask,
    pub(super) acts: u32,
    /// Lanes that do not, and may have done so in the step before.
    pub(super) ended: u32,
    /// Lanes that act with too much overlap.
    pub(super) too_deep: u32,
}

/// Where contacts are seen.
pub(super) trait Source {
    /// Whether a chunk has so many of them that it pays to take two registers at a time.
    const ARE_MANY: bool = false;
    /// Whether all laws that many runs have together are compiled as one for them, or `hertz-tsuji` with `mindlin-history` alone.
    const TOGETHER: bool = true;

    /// The contacts from `k` on; those that are not `here` do not act.
    fn look<L: Lanes>(&mut self, k: usize, here: u32) -> Sight<L>;
}

/// Notes which of the contacts from `k` on that are `here` act in this step, a bit each; tells which did in the step before and do no more.
#[inline(always)]
pub(super) fn note_engaged(engaged: &mut [u64], k: usize, here: u32, acts: u32) -> u32 {
    let word = &mut engaged[k / WORD];
    let before = (*word >> (k % WORD)) as u32 & here;
    *word ^= u64::from(before ^ acts) << (k % WORD);
    before & !acts
}

/// Pairs of grains of which some act.
pub(super) struct Approach<'a> {
    meeting: Meeting<'a>,
    bodies: Bodies<'a>,
    /// Which of them acted in the step before, a bit each, and then in this one.
    engaged: &'a mut [u64],
}

impl<'a> Approach<'a> {
    /// Of pairs, and which of them acted.
    pub(super) fn of(bodies: Bodies<'a>, engaged: &'a mut [u64], scene: &'a Scene<'a>) -> Self {
        Self {
            meeting: Meeting::new(scene),
            bodies,
            engaged,
        }
    }
}

impl Source for Approach<'_> {
    const ARE_MANY: bool = true;

    #[inline(always)]
    fn look<L: Lanes>(&mut self, k: usize, here: u32) -> Sight<L> {
        let met = self.meeting.meet::<L>(&self.bodies.lot::<L>(k), here);
        let ended = note_engaged(self.engaged, k, here, met.acts);
        Sight {
            motion: Motion {
                normal: met.normal,
                overlap: met.overlap,
                velocity: met.velocity,
                rate: met.rate,
                levers: met.levers,
                inverse_mass: met.inverse_masses[0] + met.inverse_masses[1],
                inverse_masses: met.inverse_masses,
                size: size_of_pair(met.radii, met.inverse_masses),
            },
            turning: met.turning,
            acting: met.acting,
            acts: met.acts,
            ended,
            too_deep: met.too_deep,
        }
    }
}

/// Pairs of grains whose geometry is known: all of them act.
#[derive(Clone, Copy)]
pub(super) struct Known<'a> {
    pub(super) contacts: &'a [Contact],
    pub(super) grains: &'a Grains,
    pub(super) bodies: Bodies<'a>,
    /// Velocities of all shifts across periodic sides, where the box deforms [m/s].
    pub(super) shift_velocities: Option<&'a [[f64; 4]]>,
}

impl Source for Known<'_> {
    #[inline(always)]
    fn look<L: Lanes>(&mut self, k: usize, here: u32) -> Sight<L> {
        let contacts = Contact::numbers(self.contacts);
        let mut places = places_in_turn::<L>(self.contacts.len(), k, Contact::NUMBERS);
        let lot = self.bodies.lot::<L>(k);
        let [nx, ny, nz, overlap] = L::columns(contacts, &places);
        shift::<L>(&mut places, 2);
        let [_, _, lever_i, lever_j] = L::columns(contacts, &places);
        let tables = self.grains.tables();
        let [[_, _, _, ri], [vx, vy, vz, inverse_mass], spin] = L::fetch(tables, lot.first);
        let [[_, _, _, rj], [ux, uy, uz, other_mass], other_spin] = L::fetch(tables, lot.second);
        let normal = L::Vector::new(nx, ny, nz);
        let mut velocity = L::Vector::new(vx - ux, vy - uy, vz - uz);
        if let Some(velocities) = self.shift_velocities
            && let Some(shifts) = lot.shifts::<L>(velocities)
        {
            velocity = velocity + shifts;
        }
        let inverse_masses = [inverse_mass, other_mass];
        Sight {
            motion: Motion {
                normal,
                overlap,
                velocity,
                rate: -velocity.inner(normal),
                levers: [lever_i, lever_j],
                inverse_mass: inverse_mass + other_mass,
                inverse_masses,
                size: size_of_pair([ri, rj], inverse_masses),
            },
            turning: Turning::of(spin, other_spin),
            acting: L::Mask::of_bits(here),
            acts: here,
            ended: 0,
            too_deep: 0,
        }
    }
}

/// Moves all places.
#[inline(always)]
pub(super) fn shift<L: Lanes>(places: &mut Places, by: usize) {
    let mut lane = 0;
    while lane < L::COUNT {
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
