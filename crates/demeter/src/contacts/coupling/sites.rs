//! The contacts of every grain: what they push with, and how that displaces the grain's surface at the others.

use super::bulge::Bounds;
use super::kernels::Kernels;
use crate::contacts::{CHUNK, ContactChunk, Contacts};
use crate::neighbours::Neighbours;
use crate::particles::Grains;
use demeter_physics::contact::multi_contact::{
    ContactPair, MultiContact, MultiContactLaw, MultiContactVisitor, clearance,
};
use std::ops::Range;

/// Grains handled by one task.
pub(crate) const GRAINS_PER_TASK: usize = 64;

/// Which contact: whether the partner is a wall, the chunk, and the place in it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct ContactPlace(u64);

impl ContactPlace {
    #[inline(always)]
    pub(crate) fn new(wall: bool, chunk: usize, contact: usize) -> Self {
        Self(u64::from(wall) << 63 | (chunk as u64) << 32 | contact as u64)
    }

    /// Its chunk, and its place in it.
    #[inline(always)]
    fn find(self, contacts: &Contacts) -> (&ContactChunk, usize) {
        let chunks = if self.is_wall() {
            &contacts.walls
        } else {
            &contacts.pairs
        };
        (
            &chunks[(self.0 >> 32 & 0x7fff_ffff) as usize],
            (self.0 & 0xffff_ffff) as usize,
        )
    }

    #[inline(always)]
    fn is_wall(self) -> bool {
        self.0 >> 63 == 1
    }
}

/// One contact, seen from one of its bodies.
#[derive(Clone, Copy, Debug)]
struct Site {
    place: ContactPlace,
    /// Law that displaces the body's surface here.
    kernel: u32,
    first: bool,
    /// Normal into the grain.
    normal: [f64; 3],
    lever: f64,
    clearance: f64,
    force: f64,
}

/// Contacts of the grains of one task, by grain, in the order of the partner's id.
#[derive(Clone, Debug, Default)]
pub(crate) struct Sites {
    start: Vec<u32>,
    sites: Vec<Site>,
    /// Influences of the sites of a grain on each other, a row per displaced site.
    influence: Vec<f64>,
    influence_start: Vec<u32>,
    /// Largest force on every grain [N].
    largest_force: Vec<f64>,
    local: Local,
}

/// The sites of one grain as columns.
#[derive(Clone, Debug, Default)]
struct Local {
    normal: [Vec<f64>; 3],
    lever: Vec<f64>,
    clearance: Vec<f64>,
    pairs: Vec<ContactPair>,
    mutual: Vec<f64>,
}

impl Local {
    /// Adds the pairs of a site with those before it.
    fn pair_up(&mut self, target: usize, radius: f64) {
        let normal = [0, 1, 2].map(|axis| self.normal[axis][target]);
        let (target_lever, target_clearance) = (self.lever[target], self.clearance[target]);
        for source in 0..target {
            let cosine = normal[0] * self.normal[0][source]
                + normal[1] * self.normal[1][source]
                + normal[2] * self.normal[2][source];
            self.pairs.push(ContactPair {
                cosine,
                source_lever: self.lever[source],
                target_lever,
                least_distance_squared: target_clearance * self.clearance[source],
                radius,
            });
        }
    }

    fn take(&mut self, sites: &[Site]) {
        for (axis, column) in self.normal.iter_mut().enumerate() {
            column.clear();
            column.extend(sites.iter().map(|s| s.normal[axis]));
        }
        self.lever.clear();
        self.lever.extend(sites.iter().map(|s| s.lever));
        self.clearance.clear();
        self.clearance.extend(sites.iter().map(|s| s.clearance));
    }
}

/// Largest force on a grain [N].
#[inline(always)]
pub(crate) fn largest_force(sites: &[Sites], grain: u32) -> f64 {
    sites[grain as usize / GRAINS_PER_TASK].largest_force[grain as usize % GRAINS_PER_TASK]
}

/// What sites are gathered from.
#[derive(Clone, Copy)]
pub(crate) struct Source<'a> {
    pub(crate) grains: &'a Grains,
    pub(crate) neighbours: &'a Neighbours,
    pub(crate) contacts: &'a Contacts,
    pub(crate) kernels: &'a Kernels,
}

impl Sites {
    #[inline(always)]
    fn range(&self, grain: usize) -> Range<usize> {
        self.start[grain] as usize..self.start[grain + 1] as usize
    }

    /// Gathers the contacts of grains with the forces tried now.
    pub(crate) fn gather(&mut self, of: Range<usize>, from: Source<'_>) {
        self.start.clear();
        self.start.push(0);
        self.sites.clear();
        for grain in of {
            let radius = from.grains.radius[grain];
            for (pair, first) in from.neighbours.pairs_of(grain) {
                self.take(
                    false,
                    pair,
                    first,
                    radius,
                    &from.contacts.pairs[pair / CHUNK],
                    from.kernels,
                );
            }
            for pair in from.neighbours.wall_pairs_of(grain) {
                self.take(
                    true,
                    pair,
                    true,
                    radius,
                    &from.contacts.walls[pair / CHUNK],
                    from.kernels,
                );
            }
            self.start.push(self.sites.len() as u32);
        }
    }

    /// Takes the contacts of one candidate.
    #[inline(always)]
    fn take(&mut self, wall: bool, pair: usize, first: bool, radius: f64, chunk: &ContactChunk, kernels: &Kernels) {
        for k in chunk.contacts_of(pair % CHUNK) {
            let normal = chunk.now.geometry[k].normal;
            let effective = (!wall).then(|| chunk.coupling.size[k].radius);
            self.sites.push(Site {
                place: ContactPlace::new(wall, pair / CHUNK, k),
                kernel: kernels.of(chunk.now.pair[k], first),
                first,
                normal: if first { normal } else { -normal }.to_array(),
                lever: lever(chunk, k, wall, first),
                clearance: clearance(radius, effective),
                force: chunk.coupling.trial[k],
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

    /// Takes the levers that follow from the displacements found now.
    pub(crate) fn take_levers(&mut self, contacts: &Contacts) {
        for site in &mut self.sites {
            let (chunk, k) = site.place.find(contacts);
            site.lever = lever(chunk, k, site.place.is_wall(), site.first);
        }
    }

    /// Finds the influences of the contacts of every grain on each other.
    pub(crate) fn find_influences(&mut self, of: Range<usize>, from: Source<'_>) {
        self.influence.clear();
        self.influence_start.clear();
        for (grain, radius) in from.grains.radius[of].iter().enumerate() {
            self.influence_start.push(self.influence.len() as u32);
            let range = self.range(grain);
            let sites = &self.sites[range];
            self.local.take(sites);
            let first = self.influence.len();
            self.influence.resize(first + sites.len() * sites.len(), 0.0);
            let rows = &mut self.influence[first..];
            let same = sites.iter().all(|s| s.kernel == sites[0].kernel);
            if let (Some(site), true) = (sites.first(), same) {
                let (local, radius) = (&mut self.local, *radius);
                from.kernels.law(site.kernel).visit(AllRows { local, radius, rows });
            } else {
                for (target, site) in sites.iter().enumerate() {
                    let row = &mut rows[target * sites.len()..][..sites.len()];
                    one_row(from.kernels.law(site.kernel), &self.local, *radius, target, row);
                }
            }
        }
    }

    /// Finds the displacements by the forces of the sites and delivers them to the contacts, and finds for every grain how far
    /// its surface may bulge.
    pub(crate) fn displace(
        &mut self,
        of: Range<usize>,
        grains: &Grains,
        contacts: &Contacts,
        bounds: &Bounds,
        bulge: &mut [f64],
    ) {
        self.largest_force.clear();
        for (grain, index) in of.enumerate() {
            let sites = &self.sites[self.range(grain)];
            let rows = &self.influence[self.influence_start[grain] as usize..];
            for (target, displaced) in sites.iter().enumerate() {
                let row = &rows[target * sites.len()..][..sites.len()];
                let parts = row.iter().zip(sites).map(|(influence, site)| influence * site.force);
                let (chunk, k) = displaced.place.find(contacts);
                chunk.coupling.delivered[k].put(displaced.first, parts.sum());
            }
            let mut load = Load::on(grains.radius[index]);
            sites.iter().for_each(|site| load.add(site.force, site.lever));
            self.largest_force.push(load.largest);
            bulge[grain] = bounds.bulge(grains.material[index], grains.radius[index], &load);
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

/// Influences of all sites of a grain on each other, where one law holds for all.
struct AllRows<'a> {
    local: &'a mut Local,
    radius: f64,
    rows: &'a mut [f64],
}

impl MultiContactVisitor for AllRows<'_> {
    type Output = ();

    fn visit<L: MultiContact>(self, law: &L) {
        let Self { local, radius, rows } = self;
        let count = local.lever.len();
        if L::INDEPENDENT {
            return;
        }
        if !law.is_mutual() {
            for target in 0..count {
                row_of(law, local, radius, target, &mut rows[target * count..][..count]);
                rows[target * count + target] = 0.0;
            }
            return;
        }
        local.pairs.clear();
        for target in 1..count {
            local.pair_up(target, radius);
        }
        local.mutual.clear();
        local.mutual.extend(local.pairs.iter().map(|pair| law.influence(pair)));
        let mut found = local.mutual.iter();
        for target in 1..count {
            for (source, influence) in (0..target).zip(&mut found) {
                rows[target * count + source] = *influence;
                rows[source * count + target] = *influence;
            }
        }
    }
}

/// Influences of the first sites of a grain on one of them.
#[inline(always)]
fn row_of<L: MultiContact>(law: &L, local: &Local, radius: f64, target: usize, row: &mut [f64]) {
    // slices of one length: the loop has no bounds to check
    let count = row.len();
    let [x, y, z] = [0, 1, 2].map(|axis| &local.normal[axis][..count]);
    let (lever, clearance) = (&local.lever[..count], &local.clearance[..count]);
    let [tx, ty, tz] = [0, 1, 2].map(|axis| local.normal[axis][target]);
    let (target_lever, target_clearance) = (local.lever[target], local.clearance[target]);
    for s in 0..count {
        row[s] = law.influence(&ContactPair {
            cosine: tx * x[s] + ty * y[s] + tz * z[s],
            source_lever: lever[s],
            target_lever,
            least_distance_squared: target_clearance * clearance[s],
            radius,
        });
    }
}

/// Influences of all sites of a grain on one of them.
fn one_row(law: &MultiContactLaw, local: &Local, radius: f64, target: usize, row: &mut [f64]) {
    struct Row<'a>(&'a Local, f64, usize, &'a mut [f64]);
    impl MultiContactVisitor for Row<'_> {
        type Output = ();
        fn visit<L: MultiContact>(self, law: &L) {
            let Self(local, radius, target, row) = self;
            if !L::INDEPENDENT {
                row_of(law, local, radius, target, row);
                row[target] = 0.0;
            }
        }
    }
    law.visit(Row(local, radius, target, row));
}

/// Distance of a contact point from the centre of one of its bodies, with the displacements found latest [m].
#[inline(always)]
fn lever(chunk: &ContactChunk, k: usize, wall: bool, first: bool) -> f64 {
    let contact = &chunk.now.geometry[k];
    // at a wall it is the foot of the perpendicular
    let shift = if wall { 0.0 } else { chunk.coupling.lever_shift[k] };
    if first {
        contact.lever_i + shift
    } else {
        contact.lever_j - shift
    }
}
