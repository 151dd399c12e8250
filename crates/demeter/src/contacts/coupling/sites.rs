//! The contacts of every grain: what they push with, and how that displaces the grain's surface at the others.

use super::bulge::Bounds;
use super::kernels::Kernels;
use crate::contacts::{CHUNK, ContactChunk, Contacts};
use crate::neighbours::Neighbours;
use crate::particles::Grains;
use demeter_physics::contact::multi_contact::{ContactPair, MultiContact, MultiContactVisitor};
use std::ops::Range;

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
        (&chunks[(self.0 >> 32 & 0x7fff_ffff) as usize], (self.0 & 0xffff_ffff) as usize)
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
    influences: Columns,
    influence_start: Vec<InfluenceStart>,
    displacement: Vec<f64>,
    /// Largest force on every grain [N].
    largest_force: Vec<f64>,
}

/// Pairs of sites of one grain, `(1, 0), (2, 0), (2, 1), ...`, as columns: loops over them have no branches.
#[derive(Clone, Debug, Default)]
struct Columns {
    cosine: Vec<f64>,
    earlier_lever: Vec<f64>,
    later_lever: Vec<f64>,
    least_distance_squared: Vec<f64>,
    on_later: Vec<f64>,
    /// Of no use where all influences are mutual.
    on_earlier: Vec<f64>,
}

/// Where the influences of a grain's sites begin.
#[derive(Clone, Copy, Debug)]
struct InfluenceStart {
    on_later: u32,
    /// `None` where influences are mutual.
    on_earlier: Option<u32>,
}

/// Largest force on a grain [N].
#[inline(always)]
pub(crate) fn largest_force(sites: &[Sites], grain: u32) -> f64 {
    sites[grain as usize / GRAINS_PER_TASK].largest_force[grain as usize % GRAINS_PER_TASK]
}

/// What sites are found from.
#[derive(Clone, Copy)]
pub(crate) struct Scenery<'a> {
    pub(crate) grains: &'a Grains,
    pub(crate) neighbours: &'a Neighbours,
    pub(crate) contacts: &'a Contacts,
    pub(crate) kernels: &'a Kernels,
    pub(crate) bounds: &'a Bounds,
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
            for (pair, first) in from.neighbours.pairs_of(grain) {
                self.take(false, pair, first, &from.contacts.pairs[pair / CHUNK]);
            }
            for pair in from.neighbours.wall_pairs_of(grain) {
                self.take(true, pair, true, &from.contacts.walls[pair / CHUNK]);
            }
            self.start.push(self.sites.len() as u32);
        }
    }

    /// Takes the contacts of one candidate.
    #[inline(always)]
    fn take(&mut self, wall: bool, pair: usize, first: bool, chunk: &ContactChunk) {
        for k in chunk.contacts_of(pair % CHUNK) {
            let source = &chunk.coupling.sources[k];
            let (sign, body) = if first { (1.0, 0) } else { (-1.0, 1) };
            self.sites.push(Site {
                normal: source.normal.map(|n| sign * n),
                lever: source.lever[body],
                clearance: source.clearance,
                force: source.force,
                place: ContactPlace::new(wall, pair / CHUNK, k),
                kernel: source.kernel[body],
                first,
            });
        }
    }

    /// Takes the forces tried now.
    pub(crate) fn take_forces(&mut self, contacts: &Contacts) {
        for site in &mut self.sites {
            let (chunk, k) = site.place.find(contacts);
            site.force = chunk.coupling.trial[k];
        }
    }

    /// Takes the forces and levers of the sources.
    pub(crate) fn take_sources(&mut self, contacts: &Contacts) {
        for site in &mut self.sites {
            let (chunk, k) = site.place.find(contacts);
            let source = &chunk.coupling.sources[k];
            site.lever = source.lever[usize::from(!site.first)];
            site.force = source.force;
        }
    }

    /// Finds the influences of the contacts of every grain on each other.
    pub(crate) fn find_influences(&mut self, of: Range<usize>, from: Scenery<'_>) {
        self.influences.on_later.clear();
        self.influences.on_earlier.clear();
        self.influence_start.clear();
        for (grain, &radius) in from.grains.radius[of].iter().enumerate() {
            let range = self.range(grain);
            let start = self.influences.add(&self.sites[range], radius, from.kernels);
            self.influence_start.push(start);
        }
    }

    /// Finds the displacements by the forces of the sites and delivers them to the contacts, and finds for every grain how
    /// far its surface may bulge.
    pub(crate) fn displace(&mut self, of: Range<usize>, from: Scenery<'_>, bulge: &mut [f64]) {
        self.largest_force.clear();
        for (grain, index) in of.enumerate() {
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
            let mut load = Load::on(from.grains.radius[index]);
            for (site, displacement) in sites.iter().zip(&self.displacement) {
                load.add(site.force, site.lever);
                let (chunk, k) = site.place.find(from.contacts);
                chunk.coupling.delivered[k].put(site.first, *displacement);
            }
            self.largest_force.push(load.largest);
            bulge[grain] = (from.bounds).bulge(from.grains.material[index], from.grains.radius[index], &load);
        }
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

impl Columns {
    /// Adds the influences of the sites of one grain on each other.
    fn add(&mut self, sites: &[Site], radius: f64, kernels: &Kernels) -> InfluenceStart {
        let mut start = InfluenceStart {
            on_later: self.on_later.len() as u32,
            on_earlier: Some(self.on_earlier.len() as u32),
        };
        let Some(site) = sites.first() else { return start };
        self.pair_up(sites);
        if sites.iter().all(|s| s.kernel == site.kernel) {
            let mutual = kernels.law(site.kernel).visit(Influences { columns: self, radius });
            start.on_earlier = start.on_earlier.filter(|_| !mutual);
            return start;
        }
        let mut pair = 0;
        for later in 1..sites.len() {
            for earlier in 0..later {
                let at = self.contacts(pair, radius);
                self.on_later.push(kernels.influence(sites[later].kernel, &at));
                self.on_earlier.push(kernels.influence(sites[earlier].kernel, &reversed(&at)));
                pair += 1;
            }
        }
        start
    }

    fn pair_up(&mut self, sites: &[Site]) {
        self.cosine.clear();
        self.earlier_lever.clear();
        self.later_lever.clear();
        self.least_distance_squared.clear();
        for (count, later) in sites.iter().enumerate() {
            let (n, before) = (later.normal, &sites[..count]);
            let cosine = |s: &Site| n[0] * s.normal[0] + n[1] * s.normal[1] + n[2] * s.normal[2];
            self.cosine.extend(before.iter().map(cosine));
            self.earlier_lever.extend(before.iter().map(|s| s.lever));
            self.later_lever.extend(before.iter().map(|_| later.lever));
            let least = before.iter().map(|s| s.clearance * later.clearance);
            self.least_distance_squared.extend(least);
        }
    }

    /// The earlier site of a pair as what displaces, the later as what is displaced.
    #[inline(always)]
    fn contacts(&self, pair: usize, radius: f64) -> ContactPair {
        ContactPair {
            cosine: self.cosine[pair],
            source_lever: self.earlier_lever[pair],
            target_lever: self.later_lever[pair],
            least_distance_squared: self.least_distance_squared[pair],
            radius,
        }
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

/// Influences of the sites of a grain on each other, where one law holds for all; tells whether they are mutual.
struct Influences<'a> {
    columns: &'a mut Columns,
    radius: f64,
}

impl MultiContactVisitor for Influences<'_> {
    type Output = bool;

    fn visit<L: MultiContact>(self, law: &L) -> bool {
        let Self { columns, radius } = self;
        let count = columns.cosine.len();
        let first = columns.on_later.len();
        columns.on_later.resize(first + count, 0.0);
        let mutual = law.is_mutual();
        if !mutual {
            columns.on_earlier.resize(first + count, 0.0);
        }
        if L::INDEPENDENT {
            return mutual;
        }
        // slices of one length: the loops have no bounds to check
        let (cosine, least) = (&columns.cosine[..count], &columns.least_distance_squared[..count]);
        let (earlier, later) = (&columns.earlier_lever[..count], &columns.later_lever[..count]);
        let pair = |p: usize| ContactPair {
            cosine: cosine[p],
            source_lever: earlier[p],
            target_lever: later[p],
            least_distance_squared: least[p],
            radius,
        };
        for (p, influence) in columns.on_later[first..][..count].iter_mut().enumerate() {
            *influence = law.influence(&pair(p));
        }
        if !mutual {
            for (p, influence) in columns.on_earlier[first..][..count].iter_mut().enumerate() {
                *influence = law.influence(&reversed(&pair(p)));
            }
        }
        mutual
    }
}
