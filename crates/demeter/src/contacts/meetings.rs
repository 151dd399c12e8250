//! How grains meet, and which of them act on each other in this step: several pairs at a time.

use super::Scene;
use super::kinematics::Turning;
use super::near::{FindNear, Sought};
use crate::comm::Single;
use crate::neighbours::{Pair, Pairs};
use demeter_physics::geometry::contact_sphere_sphere::{Contact, Normals, contact_sphere_sphere_wide};
use demeter_physics::lanes::{Index, Kernel, Lanes, MOST_LANES, Mask, Vector};
use glam::DVec3;

/// Pairs of grains, one per lane.
pub(super) struct Lot {
    pub(super) first: Index,
    pub(super) second: Index,
    /// Codes of the shifts across periodic sides, and whether any pair has one.
    pub(super) shift: Index,
    pub(super) is_shifted: bool,
}

impl Lot {
    #[inline(always)]
    pub(super) fn empty() -> Self {
        Self {
            first: [0; MOST_LANES],
            second: [0; MOST_LANES],
            shift: [0; MOST_LANES],
            is_shifted: false,
        }
    }

    #[inline(always)]
    pub(super) fn put(&mut self, lane: usize, pair: &Pair) {
        self.first[lane] = pair.i;
        self.second[lane] = pair.j;
        self.shift[lane] = u32::from(pair.shift);
        self.is_shifted = pair.shift != Single::UNSHIFTED || (lane > 0 && self.is_shifted);
    }

    /// Puts the codes of the shifts of pairs.
    #[inline(always)]
    pub(super) fn put_shifts<L: Lanes>(&mut self, codes: &[u8], k: usize) {
        let (mut differing, mut lane) = (0, 0);
        while lane < L::COUNT {
            let code = codes[(k + lane).min(codes.len() - 1)];
            self.shift[lane] = u32::from(code);
            differing |= code ^ Single::UNSHIFTED;
            lane += 1;
        }
        self.is_shifted = differing != 0;
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
        let [first] = L::fetch([self.tables[0]], &lot.first);
        let [second] = L::fetch([self.tables[0]], &lot.second);
        self.difference(first, second, lot)
    }

    #[inline(always)]
    fn difference<L: Lanes>(&self, [xi, yi, zi, ri]: [L; 4], [xj, yj, zj, rj]: [L; 4], lot: &Lot) -> (L::Vector, L, L) {
        let mut apart = L::Vector::new(xi - xj, yi - yj, zi - zj);
        if lot.is_shifted {
            let [[x, y, z, _]] = L::fetch([self.shifts], &lot.shift);
            apart = apart + L::Vector::new(x, y, z);
        }
        (apart, ri, rj)
    }

    /// Velocity of the first of some pairs against the second, where the box keeps its shape [m/s].
    #[inline(always)]
    pub(super) fn velocity<L: Lanes>(&self, lot: &Lot) -> L::Vector {
        let [[vx, vy, vz, _]] = L::fetch([self.tables[1]], &lot.first);
        let [[ux, uy, uz, _]] = L::fetch([self.tables[1]], &lot.second);
        L::Vector::new(vx - ux, vy - uy, vz - uz)
    }

    /// How far the surfaces of both grains may bulge [m].
    #[inline(always)]
    pub(super) fn bulges<L: Lanes>(&self, lot: &Lot) -> L {
        if !self.scene.is_coupled() {
            return L::splat(0.0);
        }
        let mut bulges = [0.0; MOST_LANES];
        let mut lane = 0;
        while lane < L::COUNT {
            bulges[lane] = self.scene.bulge(lot.first[lane] as usize) + self.scene.bulge(lot.second[lane] as usize);
            lane += 1;
        }
        L::load(&bulges)
    }

    /// How some pairs meet; those that are not `here` do not act.
    #[inline(always)]
    pub(super) fn meet<L: Lanes>(&self, lot: &Lot, here: u32) -> Met<L> {
        let [place_i, [vx, vy, vz, inverse_mass], spin_i] = L::fetch(self.tables, &lot.first);
        let [place_j, [ux, uy, uz, other_mass], spin_j] = L::fetch(self.tables, &lot.second);
        let (apart, ri, rj) = self.difference(place_i, place_j, lot);
        let [x, y, z, overlap, lever_i, lever_j] = contact_sphere_sphere_wide::<L>(apart, ri, rj, self.normals);
        let normal = L::Vector::new(x, y, z);
        let mut velocity = L::Vector::new(vx - ux, vy - uy, vz - uz);
        if lot.is_shifted && !self.shift_velocities.is_empty() {
            let [[x, y, z, _]] = L::fetch([self.shift_velocities], &lot.shift);
            velocity = velocity + L::Vector::new(x, y, z);
        }
        let rate = -velocity.inner(normal);
        let bulged = overlap + self.bulges::<L>(lot);
        let half_window = rate.abs() * (0.5 * self.scene.dt);
        let mut acting = (bulged + half_window).gt(L::splat(0.0)) & L::Mask::of_bits(here);
        let mut acts = acting.bits();
        if self.scene.max_reach > 0.0 && acts != here {
            let bodies = [lot.first, lot.second].map(first_of::<L>);
            acts |= attracted(self.scene, here & !acts, &bodies, [bulged.to_array(), rate.to_array()]);
            acting = L::Mask::of_bits(acts);
        }
        let allowed = L::select(ri.lt(rj), ri, rj) * self.scene.max_overlap;
        Met {
            normal,
            overlap,
            levers: [lever_i, lever_j],
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

/// The indices of the lanes, in an array of their own.
#[inline(always)]
fn first_of<L: Lanes>(index: Index) -> Index {
    let (mut first, mut lane) = ([0; MOST_LANES], 0);
    while lane < L::COUNT {
        first[lane] = index[lane];
        lane += 1;
    }
    first
}

/// On which of some pairs that do not touch a law acts that attracts across a gap; told overlaps and rates. What the loop over contacts
/// keeps in registers is given as copies: a reference to it would put it into memory for good.
#[inline(never)]
fn attracted(scene: &Scene, mut apart: u32, bodies: &[Index; 2], [overlap, rate]: [[f64; MOST_LANES]; 2]) -> u32 {
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
        let mut lot = Lot::empty();
        for n in (0..near.len()).step_by(L::COUNT) {
            let mut lane = 0;
            while lane < L::COUNT {
                lot.put(lane, &pairs.get(usize::from(near[(n + lane).min(near.len() - 1)])));
                lane += 1;
            }
            let met = meeting.meet::<L>(&lot, lanes_below((near.len() - n).min(L::COUNT)));
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
