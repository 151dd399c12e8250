//! The contacts of every grain: what they push with, and how that displaces the grain's surface at the others.

use super::bulge::Bounds;
use super::kernels::Kernels;
use crate::contacts::{ContactChunk, Contacts};
use crate::neighbours::Neighbours;
use crate::particles::Grains;
use demeter_physics::contact::multi_contact::{ContactPair, MultiContact, MultiContactVisitor};
use std::ops::Range;
use std::sync::atomic::{AtomicBool, Ordering};

/// Grains handled by one task.
pub(crate) const GRAINS_PER_TASK: usize = 64;

/// Which contact: whether the partner is a wall, the chunk, and the place in it.
#[derive(Clone, Copy, Debug)]
struct ContactPlace(u64);

impl ContactPlace {
    #[inline(always)]
    fn new(wall: bool, chunk: usize, contact: usize) -> Self {
        Self(u64::from(wall) << 63 | (chunk as u64) << 32 | contact as u64)
    }

    /// Its chunk, and its place in it.
    #[inline(always)]
    fn find(self, contacts: &Contacts) -> (&ContactChunk, usize) {
        let wall = self.0 >> 63 == 1;
        let chunks = if wall { &contacts.walls } else { &contacts.pairs };
        (
            &chunks[(self.0 >> 32 & 0x7fff_ffff) as usize],
            (self.0 & 0xffff_ffff) as usize,
        )
    }
}

/// What a contact is to the displacements, seen from its first body.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Source {
    pub(crate) normal: [f64; 3],
    /// Distances of the contact point from both centres [m].
    pub(crate) lever: [f64; 2],
    /// What it keeps clear around it [m].
    pub(crate) clearance: f64,
    /// Force tried now [N].
    pub(crate) force: f64,
    /// Laws that displace the surfaces of both bodies here.
    pub(crate) kernel: [u32; 2],
}

/// One contact, seen from one of its bodies.
#[derive(Clone, Copy, Debug)]
struct Site {
    /// Normal into the grain.
    normal: [f64; 3],
    lever: f64,
    clearance: f64,
    force: f64,
    place: ContactPlace,
    kernel: u32,
    first: bool,
}

/// Contacts of the grains of one task, by grain, in the order of the partner's id.
#[derive(Clone, Debug, Default)]
pub(crate) struct Sites {
    start: Vec<u32>,
    sites: Vec<Site>,
    /// Influences of every site of a grain on those behind it, and of those behind it on it.
    influences: Influences,
    influence_start: Vec<InfluenceStart>,
    displacement: Vec<f64>,
}

/// What the sites of grains tell of them.
pub(crate) struct Told<'a> {
    /// How far their surfaces bulge at most [m].
    pub(crate) bulge: &'a mut [f64],
    /// Largest force on each [N].
    pub(crate) largest_force: &'a mut [f64],
}

/// Influences of pairs of sites of every grain, `(1, 0), (2, 0), (2, 1), ...`.
#[derive(Clone, Debug, Default)]
struct Influences {
    on_later: Vec<f64>,
    /// Only of grains whose influences are not mutual.
    on_earlier: Vec<f64>,
}

/// Pairs evaluated at a time: a loop over columns of fixed length has no branches and is vectorised.
const LANES: usize = 8;

/// Pairs of sites of one grain, as columns.
struct Pairs {
    filled: usize,
    cosine: [f64; LANES],
    earlier_lever: [f64; LANES],
    later_lever: [f64; LANES],
    least_distance_squared: [f64; LANES],
}

/// Where the influences of a grain's sites begin.
#[derive(Clone, Copy, Debug)]
struct InfluenceStart {
    on_later: u32,
    /// `None` where influences are mutual.
    on_earlier: Option<u32>,
}

/// What sites are found from.
#[derive(Clone, Copy)]
pub(crate) struct Scenery<'a> {
    pub(crate) grains: &'a Grains,
    pub(crate) neighbours: &'a Neighbours,
    pub(crate) contacts: &'a Contacts,
    pub(crate) kernels: &'a Kernels,
    pub(crate) bounds: &'a Bounds,
    pub(crate) changes: &'a Changes,
}

/// What has changed at the contacts of a grain since its displacements were found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Change {
    None,
    Force,
    Lever,
}

/// Changes of all grains. They are noted by contact, and by any number of contacts: it does not matter which comes first.
#[derive(Debug, Default)]
pub(crate) struct Changes {
    force: Vec<AtomicBool>,
    lever: Vec<AtomicBool>,
}

impl Changes {
    /// Forgets the changes of some of so many grains.
    pub(crate) fn clear(&mut self, count: usize, some: impl Iterator<Item = usize> + Clone) {
        for flags in [&mut self.force, &mut self.lever] {
            flags.resize_with(count, AtomicBool::default);
            some.clone().for_each(|grain| *flags[grain].get_mut() = false);
        }
    }

    #[inline(always)]
    pub(crate) fn note_force(&self, grain: u32) {
        self.force[grain as usize].store(true, Ordering::Relaxed);
    }

    #[inline(always)]
    pub(crate) fn note_lever(&self, grain: u32) {
        self.lever[grain as usize].store(true, Ordering::Relaxed);
    }

    #[inline(always)]
    pub(crate) fn of(&self, grain: usize) -> Change {
        if self.lever[grain].load(Ordering::Relaxed) {
            Change::Lever
        } else if self.force[grain].load(Ordering::Relaxed) {
            Change::Force
        } else {
            Change::None
        }
    }

    #[inline(always)]
    pub(crate) fn any(&self, grain: u32) -> bool {
        self.of(grain as usize) != Change::None
    }
}

impl Sites {
    #[inline(always)]
    fn range(&self, grain: usize) -> Range<usize> {
        self.start[grain] as usize..self.start[grain + 1] as usize
    }

    /// Gathers the contacts of grains with the forces tried now.
    pub(crate) fn gather(&mut self, of: Range<usize>, from: Scenery<'_>) {
        self.start.clear();
        self.start.push(0);
        self.sites.clear();
        for grain in of {
            for (chunk, slot, first) in from.neighbours.pairs_of(grain) {
                self.take((false, chunk, slot), first, &from.contacts.pairs[chunk]);
            }
            for (chunk, slot) in from.neighbours.wall_pairs_of(grain) {
                self.take((true, chunk, slot), true, &from.contacts.walls[chunk]);
            }
            self.start.push(self.sites.len() as u32);
        }
    }

    /// Takes the contacts of one candidate.
    #[inline(always)]
    fn take(&mut self, (wall, number, slot): (bool, usize, usize), first: bool, chunk: &ContactChunk) {
        for k in chunk.contacts_of(slot) {
            let source = &chunk.coupling.sources[k];
            let (sign, body) = if first { (1.0, 0) } else { (-1.0, 1) };
            self.sites.push(Site {
                normal: source.normal.map(|n| sign * n),
                lever: source.lever[body],
                clearance: source.clearance,
                force: source.force,
                place: ContactPlace::new(wall, number, k),
                kernel: source.kernel[body],
                first,
            });
        }
    }

    /// Finds the influences of the contacts of every grain on each other.
    pub(crate) fn find_influences(&mut self, of: Range<usize>, from: Scenery<'_>) {
        self.influences.on_later.clear();
        self.influences.on_earlier.clear();
        self.influence_start.clear();
        for (grain, radius) in of.map(|g| from.grains.radius(g)).enumerate() {
            let range = self.range(grain);
            let start = InfluenceStart {
                on_later: self.influences.on_later.len() as u32,
                on_earlier: Some(self.influences.on_earlier.len() as u32),
            };
            let start = self.influences.find(start, &self.sites[range], radius, from.kernels);
            self.influence_start.push(start);
        }
    }

    /// Finds the displacements on all grains.
    pub(crate) fn displace(&mut self, of: Range<usize>, from: Scenery<'_>, told: &mut Told<'_>) {
        for (grain, index) in of.enumerate() {
            self.displace_grain(grain, index, from, told);
        }
    }

    /// Finds the displacements anew on grains with contacts whose force or lever has changed.
    pub(crate) fn displace_again(&mut self, of: Range<usize>, from: Scenery<'_>, told: &mut Told<'_>) {
        for (grain, index) in of.enumerate() {
            let change = from.changes.of(index);
            if change == Change::None {
                continue;
            }
            let range = self.range(grain);
            for site in &mut self.sites[range.clone()] {
                let (chunk, k) = site.place.find(from.contacts);
                site.force = chunk.coupling.trial[k];
                site.lever = chunk.coupling.sources[k].lever[usize::from(!site.first)];
            }
            if change == Change::Lever {
                let (start, radius) = (self.influence_start[grain], from.grains.radius(index));
                self.influences.find(start, &self.sites[range], radius, from.kernels);
            }
            self.displace_grain(grain, index, from, told);
        }
    }

    /// Finds the displacements by the forces of a grain's sites and delivers them to the contacts, and finds how far its
    /// surface may bulge.
    #[inline(always)]
    fn displace_grain(&mut self, grain: usize, index: usize, from: Scenery<'_>, told: &mut Told<'_>) {
        let sites = &self.sites[self.range(grain)];
        let start = self.influence_start[grain];
        let on_later = &self.influences.on_later[start.on_later as usize..];
        let on_earlier = match start.on_earlier {
            Some(first) => &self.influences.on_earlier[first as usize..],
            None => on_later,
        };
        self.displacement.clear();
        self.displacement.resize(sites.len(), 0.0);
        let mut pair = 0;
        for later in 1..sites.len() {
            let (before, own) = self.displacement.split_at_mut(later);
            let force = sites[later].force;
            let count = before.len();
            let (onto, back) = (&on_later[pair..pair + count], &on_earlier[pair..pair + count]);
            let mut sum = 0.0;
            for (earlier, displacement) in before.iter_mut().enumerate() {
                sum += onto[earlier] * sites[earlier].force;
                *displacement += back[earlier] * force;
            }
            own[0] = sum;
            pair += count;
        }
        let radius = from.grains.radius(index);
        let mut load = Load::on(radius);
        for (site, displacement) in sites.iter().zip(&self.displacement) {
            load.add(site.force, site.lever);
            let (chunk, k) = site.place.find(from.contacts);
            chunk.coupling.delivered[k].put(usize::from(!site.first), *displacement);
        }
        told.largest_force[grain] = load.largest;
        told.bulge[grain] = from.bounds.bulge(from.grains.material[index], radius, &load);
    }
}

/// What the contacts of a grain come to.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Load {
    pub(crate) push: f64,
    pub(crate) pull: f64,
    pub(crate) largest: f64,
    pub(crate) least_lever: f64,
}

impl Load {
    pub(crate) fn on(radius: f64) -> Self {
        Self {
            push: 0.0,
            pull: 0.0,
            largest: 0.0,
            least_lever: radius,
        }
    }

    #[inline(always)]
    pub(crate) fn add(&mut self, force: f64, lever: f64) {
        self.push += force.max(0.0);
        self.pull -= force.min(0.0);
        self.largest = self.largest.max(force.abs());
        self.least_lever = self.least_lever.min(lever);
    }
}

impl Influences {
    /// Finds the influences of the sites of one grain on each other from `start` on.
    fn find(&mut self, mut start: InfluenceStart, sites: &[Site], radius: f64, kernels: &Kernels) -> InfluenceStart {
        let Some(site) = sites.first() else { return start };
        let count = sites.len() * (sites.len() - 1) / 2;
        let on_later = room(&mut self.on_later, Some(start.on_later), count);
        if sites.iter().all(|s| s.kernel == site.kernel) {
            let law = kernels.law(site.kernel);
            let mutual = law.visit(Uniform {
                sites,
                radius,
                influence: on_later,
                backwards: false,
            });
            if mutual {
                start.on_earlier = None;
                return start;
            }
            let influence = room(&mut self.on_earlier, start.on_earlier, count);
            law.visit(Uniform {
                sites,
                radius,
                influence,
                backwards: true,
            });
            return start;
        }
        let on_earlier = room(&mut self.on_earlier, start.on_earlier, count);
        let mut pair = 0;
        for (count, later) in sites.iter().enumerate() {
            for earlier in &sites[..count] {
                let at = contacts(earlier, later, radius);
                on_later[pair] = kernels.influence(later.kernel, &at);
                on_earlier[pair] = kernels.influence(earlier.kernel, &reversed(&at));
                pair += 1;
            }
        }
        start
    }
}

/// The `count` values from `first` on, which are there or are added at the end.
fn room(values: &mut Vec<f64>, first: Option<u32>, count: usize) -> &mut [f64] {
    let first = first.map_or(values.len(), |first| first as usize);
    if values.len() < first + count {
        values.resize(first + count, 0.0);
    }
    &mut values[first..first + count]
}

/// The earlier site as what displaces, the later as what is displaced.
#[inline(always)]
fn contacts(earlier: &Site, later: &Site, radius: f64) -> ContactPair {
    let (n, m) = (earlier.normal, later.normal);
    ContactPair {
        cosine: n[0] * m[0] + n[1] * m[1] + n[2] * m[2],
        source_lever: earlier.lever,
        target_lever: later.lever,
        least_distance_squared: earlier.clearance * later.clearance,
        radius,
    }
}

#[inline(always)]
fn reversed(at: &ContactPair) -> ContactPair {
    ContactPair {
        source_lever: at.target_lever,
        target_lever: at.source_lever,
        ..*at
    }
}

/// Influences of the sites of a grain on those behind them (or, backwards, before them), where one law holds for all;
/// tells whether they are mutual.
struct Uniform<'a> {
    sites: &'a [Site],
    radius: f64,
    influence: &'a mut [f64],
    backwards: bool,
}

impl MultiContactVisitor for Uniform<'_> {
    type Output = bool;

    fn visit<L: MultiContact>(self, law: &L) -> bool {
        let Self {
            sites,
            radius,
            influence,
            backwards,
        } = self;
        if L::INDEPENDENT {
            influence.fill(0.0);
            return law.is_mutual();
        }
        let mut pairs = Pairs {
            filled: 0,
            cosine: [-1.0; LANES],
            earlier_lever: [radius; LANES],
            later_lever: [radius; LANES],
            least_distance_squared: [radius * radius; LANES],
        };
        let mut done = 0;
        for (count, later) in sites.iter().enumerate() {
            for earlier in &sites[..count] {
                let at = contacts(earlier, later, radius);
                let lane = pairs.filled % LANES;
                pairs.cosine[lane] = at.cosine;
                pairs.earlier_lever[lane] = at.source_lever;
                pairs.later_lever[lane] = at.target_lever;
                pairs.least_distance_squared[lane] = at.least_distance_squared;
                pairs.filled = lane + 1;
                if pairs.filled == LANES {
                    influence[done..done + LANES].copy_from_slice(&pairs.influences(law, radius, backwards));
                    done += LANES;
                    pairs.filled = 0;
                }
            }
        }
        let left = influence.len() - done;
        if left > 0 {
            influence[done..].copy_from_slice(&pairs.influences(law, radius, backwards)[..left]);
        }
        law.is_mutual()
    }
}

impl Pairs {
    #[inline(always)]
    fn influences<L: MultiContact>(&self, law: &L, radius: f64, backwards: bool) -> [f64; LANES] {
        let (source, target) = if backwards {
            (&self.later_lever, &self.earlier_lever)
        } else {
            (&self.earlier_lever, &self.later_lever)
        };
        let mut influence = [0.0; LANES];
        for (lane, influence) in influence.iter_mut().enumerate() {
            *influence = law.influence(&ContactPair {
                cosine: self.cosine[lane],
                source_lever: source[lane],
                target_lever: target[lane],
                least_distance_squared: self.least_distance_squared[lane],
                radius,
            });
        }
        influence
    }
}
