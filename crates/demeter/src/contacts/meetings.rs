//! How grains meet, and which of them act on each other in this step: several pairs at a time.

use super::Scene;
use super::kinematics::Turning;
use super::near::{FindNear, Sought};
use crate::comm::Single;
use crate::neighbours::{Pair, Pairs};
use demeter_physics::geometry::contact_sphere_sphere::{Contact, Normals, Touch, contact_sphere_sphere_wide};
use demeter_physics::lanes::{Index, Kernel, Lanes, MOST_LANES, Mask, Vector};
use glam::DVec3;

/// Pairs of grains, one per lane.
pub(super) struct Lot<'a> {
    pub(super) first: &'a [u32],
    pub(super) second: &'a [u32],
    /// Codes of the shifts across periodic sides; empty where there are none.
    pub(super) shift: &'a [u8],
}

impl Lot<'_> {
    /// Whether any pair is shifted.
    #[inline(always)]
    fn is_shifted(&self) -> bool {
        let (mut differing, mut lane) = (0, 0);
        while lane < self.shift.len() {
            differing |= self.shift[lane] ^ Single::UNSHIFTED;
            lane += 1;
        }
        differing != 0
    }

    /// The shifts of the pairs in a table of all shifts, if any pair is shifted.
    #[inline(always)]
    pub(super) fn shifts<L: Lanes>(&self, table: &[[f64; 4]]) -> Option<L::Vector> {
        if !self.is_shifted() {
            return None;
        }
        let (mut index, mut lane) = ([0; MOST_LANES], 0);
        while lane < L::COUNT {
            index[lane] = u32::from(self.shift[lane]);
            lane += 1;
        }
        let [[x, y, z, _]] = L::fetch([table], &index);
        Some(L::Vector::new(x, y, z))
    }
}

/// Pairs that are put together one by one.
#[derive(Default)]
pub(super) struct PickedPairs {
    first: Index,
    second: Index,
    shift: [u8; MOST_LANES],
}

impl PickedPairs {
    #[inline(always)]
    pub(super) fn put(&mut self, lane: usize, pair: &Pair) {
        self.first[lane] = pair.i;
        self.second[lane] = pair.j;
        self.shift[lane] = pair.shift;
    }

    #[inline(always)]
    pub(super) fn lot<L: Lanes>(&self) -> Lot<'_> {
        Lot {
            first: &self.first[..L::COUNT],
            second: &self.second[..L::COUNT],
            shift: &self.shift[..L::COUNT],
        }
    }
}

/// How two grains meet, one pair per lane.
pub(super) struct Met<L: Lanes> {
    /// Unit vector from the second to the first.
    pub(super) normal: L::Vector,
    /// Overlap [m].
    pub(super) overlap: L,
    /// Distances of the contact point from both centres [m].
    pub(super) levers: [L; 2],
    /// Radii [m].
    pub(super) radii: [L; 2],
    /// Velocity of the first centre relative to the second [m/s].
    pub(super) velocity: L::Vector,
    /// Inverse masses [1/kg].
    pub(super) inverse_masses: [L; 2],
    /// Rate of approach [m/s].
    pub(super) rate: L,
    /// How they turn.
    pub(super) turning: Turning<L>,
    /// Lanes that act in this step, as a mask and as bits.
    pub(super) acting: L::Mask,
    pub(super) acts: u32,
    /// Those of them with too much overlap.
    pub(super) too_deep: u32,
}

/// What is needed to tell how grains meet.
#[derive(Clone, Copy)]
pub(super) struct Meeting<'a> {
    scene: &'a Scene<'a>,
    normals: Normals,
    /// Positions, velocities, and angular velocities with the inverse moments of inertia.
    tables: [&'a [[f64; 4]]; 3],
    /// Shifts of positions across periodic sides; empty where there are none.
    shifts: &'a [[f64; 4]],
    /// Velocities of these shifts; empty where the box keeps its shape.
    shift_velocities: &'a [[f64; 4]],
}

impl<'a> Meeting<'a> {
    pub(super) fn new(scene: &'a Scene<'a>) -> Self {
        let is_coupled = scene.is_coupled();
        Self {
            scene,
            normals: if is_coupled {
                Normals::Quotients
            } else {
                Normals::Inverse
            },
            tables: scene.grains.tables(),
            shifts: scene.comm.shifts(),
            shift_velocities: scene.comm.shift_velocities(),
        }
    }

    /// Difference of the positions of some pairs, and their radii.
    #[inline(always)]
    pub(super) fn apart<L: Lanes>(&self, lot: &Lot) -> (L::Vector, L, L) {
        let [first] = L::fetch([self.tables[0]], lot.first);
        let [second] = L::fetch([self.tables[0]], lot.second);
        self.difference(first, second, lot)
    }

    #[inline(always)]
    fn difference<L: Lanes>(&self, [xi, yi, zi, ri]: [L; 4], [xj, yj, zj, rj]: [L; 4], lot: &Lot) -> (L::Vector, L, L) {
        let mut apart = L::Vector::new(xi - xj, yi - yj, zi - zj);
        if let Some(shifts) = lot.shifts::<L>(self.shifts) {
            apart = apart + shifts;
        }
        (apart, ri, rj)
    }

    /// Velocity of the first of some pairs against the second, where the box keeps its shape [m/s].
    #[inline(always)]
    pub(super) fn velocity<L: Lanes>(&self, lot: &Lot) -> L::Vector {
        let [[vx, vy, vz, _]] = L::fetch([self.tables[1]], lot.first);
        let [[ux, uy, uz, _]] = L::fetch([self.tables[1]], lot.second);
        L::Vector::new(vx - ux, vy - uy, vz - uz)
    }

    /// How far the surfaces of both grains may bulge [m].
    #[inline(always)]
    pub(super) fn bulges<L: Lanes>(&self, lot: &Lot) -> L {
        if !self.scene.is_coupled() {
            return L::splat(0.0);
        }
        L::load(&bulges(self.scene, lot.first, lot.second))
    }

    /// How some pairs meet; those that are not `here` do not act.
    #[inline(always)]
    pub(super) fn meet<L: Lanes>(&self, lot: &Lot, here: u32) -> Met<L> {
        let [place_i, [vx, vy, vz, inverse_mass], spin_i] = L::fetch(self.tables, lot.first);
        let [place_j, [ux, uy, uz, other_mass], spin_j] = L::fetch(self.tables, lot.second);
        let (apart, ri, rj) = self.difference(place_i, place_j, lot);
        let mut velocity = L::Vector::new(vx - ux, vy - uy, vz - uz);
        if !self.shift_velocities.is_empty()
            && let Some(shifts) = lot.shifts::<L>(self.shift_velocities)
        {
            velocity = velocity + shifts;
        }
        let Touch {
            normal,
            overlap,
            levers,
            rate,
        } = contact_sphere_sphere_wide::<L>(apart, velocity, [ri, rj], self.normals);
        let bulged = overlap + self.bulges::<L>(lot);
        let half_window = rate.abs() * (0.5 * self.scene.dt);
        let mut acting = (bulged + half_window).gt(L::splat(0.0)) & L::Mask::of_bits(here);
        let mut acts = acting.bits();
        if self.scene.max_reach > 0.0 && acts != here {
            acts |= attracted(
                self.scene,
                here & !acts,
                [lot.first, lot.second],
                [bulged.to_array(), rate.to_array()],
            );
            acting = L::Mask::of_bits(acts);
        }
        let allowed = ri.min(rj) * self.scene.max_overlap;
        Met {
            normal,
            overlap,
            levers,
            radii: [ri, rj],
            velocity,
            inverse_masses: [inverse_mass, other_mass],
            rate,
            turning: Turning::of(spin_i, spin_j),
            acting,
            acts,
            too_deep: (!allowed.ge(overlap)).bits() & acts,
        }
    }
}

/// How far the surfaces of both grains of some pairs may bulge [m].
#[inline(never)]
fn bulges(scene: &Scene, first: &[u32], second: &[u32]) -> [f64; MOST_LANES] {
    let mut bulges = [0.0; MOST_LANES];
    for (bulge, (&i, &j)) in bulges.iter_mut().zip(first.iter().zip(second)) {
        *bulge = scene.bulge(i as usize) + scene.bulge(j as usize);
    }
    bulges
}

/// On which of some pairs that do not touch a law acts that attracts across a gap; told overlaps and rates. What the loop over contacts
/// keeps in registers is given as copies: a reference to it would put it into memory for good.
#[inline(never)]
fn attracted(scene: &Scene, mut apart: u32, bodies: [&[u32]; 2], [overlap, rate]: [[f64; MOST_LANES]; 2]) -> u32 {
    let (grains, materials) = (scene.grains, scene.materials);
    let mut acts = 0;
    while let Some(lane) = next_lane(&mut apart) {
        let [i, j] = bodies.map(|of| of[lane] as usize);
        let law = materials.pair(grains.material[i], grains.material[j]);
        acts |= u32::from(scene.acts(law, || scene.size_of_pair(i, j), overlap[lane], rate[lane])) << lane;
    }
    acts
}

/// Bits of the lanes below a number.
#[inline(always)]
pub(super) fn lanes_below(count: usize) -> u32 {
    if count >= 32 { u32::MAX } else { (1 << count) - 1 }
}

/// The next lane that is set, which is no longer set then.
#[inline(always)]
pub(super) fn next_lane(bits: &mut u32) -> Option<usize> {
    if *bits == 0 {
        return None;
    }
    let lane = bits.trailing_zeros() as usize;
    *bits &= *bits - 1;
    Some(lane)
}

/// What looking for contacts fills.
#[derive(Debug, Default)]
pub(super) struct Found {
    /// Candidates near enough that their rate matters.
    pub(super) near: Vec<u16>,
    /// Candidates that act, in their order.
    pub(super) candidates: Vec<u16>,
    /// How they meet.
    pub(super) geometry: Vec<Contact>,
    /// Rates of approach [m/s].
    pub(super) rate: Vec<f64>,
    /// Which contacts of the step before acted, a bit each.
    pub(super) acted: Vec<u64>,
    /// The first contact with too much overlap.
    pub(super) too_deep: Option<usize>,
}

/// Finds the pairs of a chunk that act on each other, where contacts feel each other.
pub(super) struct FindPairs<'a> {
    pub(super) pairs: Pairs<'a>,
    pub(super) scene: &'a Scene<'a>,
    pub(super) found: &'a mut Found,
}

impl Kernel for FindPairs<'_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self) {
        let Self { pairs, scene, found } = self;
        let Found {
            near,
            candidates,
            geometry,
            rate,
            too_deep,
            ..
        } = found;
        candidates.clear();
        geometry.clear();
        rate.clear();
        *too_deep = None;
        let find = FindNear {
            pairs,
            scene,
            sought: Sought {
                reach: scene.widest_window(),
                time: 0.0,
            },
            near,
        };
        find.run::<L>();
        let meeting = Meeting::new(scene);
        let mut picked = PickedPairs::default();
        for n in (0..near.len()).step_by(L::COUNT) {
            let mut lane = 0;
            while lane < L::COUNT {
                picked.put(lane, &pairs.get(usize::from(near[(n + lane).min(near.len() - 1)])));
                lane += 1;
            }
            let met = meeting.meet::<L>(&picked.lot::<L>(), lanes_below((near.len() - n).min(L::COUNT)));
            let mut bits = met.acts;
            if met.too_deep != 0 && too_deep.is_none() {
                let before = bits & ((1 << met.too_deep.trailing_zeros()) - 1);
                *too_deep = Some(geometry.len() + before.count_ones() as usize);
            }
            let [x, y, z] = met.normal.components();
            let planes = L::rows([x, y, z, met.overlap]);
            let [lever_i, lever_j] = met.levers;
            let (lever_i, lever_j, rates) = (lever_i.to_array(), lever_j.to_array(), met.rate.to_array());
            while bits != 0 {
                let lane = bits.trailing_zeros() as usize;
                let [x, y, z, overlap] = planes.as_ref()[lane];
                candidates.push(near[n + lane]);
                geometry.push(Contact {
                    normal: DVec3::new(x, y, z),
                    overlap,
                    lever_i: lever_i[lane],
                    lever_j: lever_j[lane],
                });
                rate.push(rates[lane]);
                bits &= bits - 1;
            }
        }
    }
}
