//! Which pairs of grains act on each other in this step: wide distance tests.

use super::Scene;
use crate::neighbours::Pair;
use demeter_physics::contact::PairSize;
use demeter_physics::geometry::contact_sphere_sphere::{Contact, contact_sphere_sphere_wide};
use demeter_physics::lanes::{Kernel, Lanes, MOST_LANES, Mask, Places, Vector};
use glam::DVec3;

/// What looking for contacts fills.
#[derive(Clone, Debug, Default)]
pub(super) struct Found {
    /// Candidates near enough that their rate matters.
    near: Vec<u32>,
    /// Candidates that act, in their order.
    pub(super) candidates: Vec<u32>,
    /// How they meet.
    pub(super) geometry: Vec<Contact>,
    /// The first contact with too much overlap.
    pub(super) too_deep: Option<usize>,
}

/// Finds the contacts of a chunk of pairs.
pub(super) struct FindPairs<'a> {
    pub(super) pairs: &'a [Pair],
    pub(super) scene: &'a Scene<'a>,
    /// Shifts of positions across periodic sides, four numbers per code; empty where there are none.
    pub(super) shifts: &'a [f64],
    pub(super) found: &'a mut Found,
}

/// Pairs of grains, one per lane.
struct Lot {
    /// Places of the rows of both grains.
    first: Places,
    second: Places,
    /// Places of the rows of the shifts.
    shift: Places,
}

impl Lot {
    #[inline(always)]
    fn empty() -> Self {
        Self {
            first: [0; MOST_LANES],
            second: [0; MOST_LANES],
            shift: [0; MOST_LANES],
        }
    }

    #[inline(always)]
    fn put(&mut self, lane: usize, pair: &Pair) {
        self.first[lane] = 4 * pair.i as usize;
        self.second[lane] = 4 * pair.j as usize;
        self.shift[lane] = 4 * usize::from(pair.shift);
    }
}

impl FindPairs<'_> {
    /// Difference of the positions of some pairs, and their radii.
    #[inline(always)]
    fn apart<L: Lanes>(&self, lot: &Lot) -> (L::Vector, L, L) {
        let position = self.scene.grains.position.numbers();
        let [xi, yi, zi, ri] = L::columns(position, &lot.first);
        let [xj, yj, zj, rj] = L::columns(position, &lot.second);
        let mut apart = L::Vector::new(xi - xj, yi - yj, zi - zj);
        if !self.shifts.is_empty() {
            let [x, y, z, _] = L::columns(self.shifts, &lot.shift);
            apart = apart + L::Vector::new(x, y, z);
        }
        (apart, ri, rj)
    }

    /// How far the surfaces of both grains may bulge [m].
    #[inline(always)]
    fn bulges<L: Lanes>(&self, lot: &Lot) -> L {
        let mut bulges = [0.0; MOST_LANES];
        if self.scene.is_coupled() {
            let mut lane = 0;
            while lane < L::COUNT {
                bulges[lane] = self.scene.bulge(lot.first[lane] / 4) + self.scene.bulge(lot.second[lane] / 4);
                lane += 1;
            }
        }
        L::load(&bulges)
    }

    #[inline(always)]
    fn find_near<L: Lanes>(&mut self) {
        self.found.near.clear();
        let (count, window) = (self.pairs.len(), self.scene.widest_window());
        let mut lot = Lot::empty();
        for c in (0..count).step_by(L::COUNT) {
            let mut lane = 0;
            while lane < L::COUNT {
                lot.put(lane, &self.pairs[(c + lane).min(count - 1)]);
                lane += 1;
            }
            let (apart, ri, rj) = self.apart::<L>(&lot);
            let reach = ri + rj + self.bulges::<L>(&lot) + window;
            let mut bits = apart.square().lt(reach * reach).bits() & lanes_below(count - c);
            while bits != 0 {
                self.found.near.push(c as u32 + bits.trailing_zeros());
                bits &= bits - 1;
            }
        }
    }

    /// Whether a law that attracts across a gap acts on a pair that does not touch.
    fn attracts(&self, pair: &Pair, overlap: f64, rate: f64) -> bool {
        let (grains, materials) = (self.scene.grains, self.scene.materials);
        let (i, j) = (pair.i as usize, pair.j as usize);
        let size = || PairSize {
            radius: 1.0 / (1.0 / grains.radius(i) + 1.0 / grains.radius(j)),
            mass: 1.0 / (grains.inverse_mass(i) + grains.inverse_mass(j)),
        };
        let law = materials.pair(grains.material[i], grains.material[j]);
        self.scene.acts(law, size, overlap, rate)
    }

    #[inline(always)]
    fn meet<L: Lanes>(&mut self) {
        let velocity = self.scene.grains.velocity.numbers();
        let near = std::mem::take(&mut self.found.near);
        let mut lot = Lot::empty();
        for n in (0..near.len()).step_by(L::COUNT) {
            let mut lane = 0;
            while lane < L::COUNT {
                lot.put(lane, &self.pairs[near[(n + lane).min(near.len() - 1)] as usize]);
                lane += 1;
            }
            let (apart, ri, rj) = self.apart::<L>(&lot);
            let [x, y, z, overlap, lever_i, lever_j] = contact_sphere_sphere_wide::<L>(apart, ri, rj);
            let [vx, vy, vz, _] = L::columns(velocity, &lot.first);
            let [ux, uy, uz, _] = L::columns(velocity, &lot.second);
            let rate = L::Vector::new(ux - vx, uy - vy, uz - vz).inner(L::Vector::new(x, y, z));
            let bulged = overlap + self.bulges::<L>(&lot);
            let half_window = rate.abs() * (0.5 * self.scene.dt);
            let here = lanes_below((near.len() - n).min(L::COUNT));
            let mut bits = (bulged + half_window).gt(L::splat(0.0)).bits() & here;
            if self.scene.max_reach > 0.0 && bits != here {
                let (bulged, rate) = (bulged.to_array(), rate.to_array());
                let mut apart = here & !bits;
                while apart != 0 {
                    let lane = apart.trailing_zeros() as usize;
                    let pair = &self.pairs[near[n + lane] as usize];
                    bits |= u32::from(self.attracts(pair, bulged[lane], rate[lane])) << lane;
                    apart &= apart - 1;
                }
            }
            let allowed = L::select(ri.lt(rj), ri, rj) * self.scene.max_overlap;
            let too_deep = (!allowed.ge(overlap)).bits() & bits;
            if too_deep != 0 && self.found.too_deep.is_none() {
                let before = bits & ((1 << too_deep.trailing_zeros()) - 1);
                self.found.too_deep = Some(self.found.geometry.len() + before.count_ones() as usize);
            }
            let planes = L::rows([x, y, z, overlap]);
            let (lever_i, lever_j) = (lever_i.to_array(), lever_j.to_array());
            while bits != 0 {
                let lane = bits.trailing_zeros() as usize;
                let [x, y, z, overlap] = planes[lane];
                self.found.candidates.push(near[n + lane]);
                self.found.geometry.push(Contact {
                    normal: DVec3::new(x, y, z),
                    overlap,
                    lever_i: lever_i[lane],
                    lever_j: lever_j[lane],
                });
                bits &= bits - 1;
            }
        }
        self.found.near = near;
    }
}

/// Bits of the lanes below a number.
#[inline(always)]
fn lanes_below(count: usize) -> u32 {
    if count >= 32 { u32::MAX } else { (1 << count) - 1 }
}

impl Kernel for FindPairs<'_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(mut self) {
        self.found.candidates.clear();
        self.found.too_deep = None;
        self.found.geometry.clear();
        if !self.pairs.is_empty() {
            self.find_near::<L>();
            self.meet::<L>();
        }
    }
}
