//! The contacts of every grain: what they push with, and how that displaces the grain's surface at the others.
//!
//! Which contacts these are stays as it is until a contact of the grain comes or goes, or candidates are found anew; what is known of them
//! is gathered in every step.

use super::bulge::Bounds;
use super::kernels::Kernels;
use super::site_list::{LawOfGrain, SiteList};
use crate::contacts::Contacts;
use crate::contacts::kinematics::{put_listed, store_some};
use crate::neighbours::Neighbours;
use crate::particles::Grains;
use demeter_physics::contact::multi_contact::{ContactPair, MultiContact, MultiContactVisitor};
use demeter_physics::lanes::{self, Instructions, Kernel, Lanes, MOST_LANES};
use std::cell::RefCell;
use std::ops::Range;
use std::sync::atomic::{AtomicU8, AtomicU64, Ordering};

/// Grains handled by one task, as many as a word has bits.
pub(crate) const GRAINS_PER_TASK: usize = u64::BITS as usize;

/// What a contact is to the displacements, seen from either body: the normal into the body, and beside it the distance of the contact
/// point from its centre [m].
pub(crate) type Source = [[f64; 4]; 2];

/// Contacts of the grains of one task.
#[derive(Debug)]
pub(crate) struct Sites {
    /// The grains that have other contacts now, a bit each.
    outdated: AtomicU64,
    list: SiteList,
    now: AtSites,
}

impl Default for Sites {
    /// None is known.
    fn default() -> Self {
        Self {
            outdated: AtomicU64::new(u64::MAX),
            list: SiteList::default(),
            now: AtSites::default(),
        }
    }
}

/// Sites that are found in memory before what lies there is fetched: contacts are far from each other, and a processor waits for many at a
/// time where nothing but fetching stands between them.
const AT_ONCE: usize = 32;

/// What is found at sites in a step.
#[derive(Debug, Default)]
struct AtSites {
    /// Normals and levers of all sites, and the forces tried now [N].
    rows: Vec<[f64; 4]>,
    forces: Vec<f64>,
    /// Influences of the earlier site of every pair on the later, and of the later on the earlier where they are not mutual [m/N].
    on_later: Vec<f64>,
    on_earlier: Vec<f64>,
}

thread_local! {
    /// Where a thread keeps that of the task at hand, which stays in its caches from task to task.
    static WORKSPACE: RefCell<AtSites> = RefCell::default();
    /// The list of a task before some of its grains had other contacts.
    static FORMER: RefCell<SiteList> = RefCell::default();
}

/// What the sites of grains tell of them.
pub(crate) struct Told<'a> {
    /// How far their surfaces bulge at most [m].
    pub(crate) bulge: &'a mut [f64],
    /// Largest force on each [N].
    pub(crate) largest_force: &'a mut [f64],
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
    pub(crate) instructions: Instructions,
}

/// Changes at the contacts of all grains since their displacements were found: of a force, or of a lever. They are noted by contact, and by
/// any number of contacts: it does not matter which comes first. Forces and levers are never noted in the same pass.
#[derive(Debug, Default)]
pub(crate) struct Changes(Vec<AtomicU8>);

const FORCE: u8 = 1;
const LEVER: u8 = 2;

impl Changes {
    /// Forgets the changes of some of so many grains.
    pub(crate) fn clear(&mut self, count: usize, some: impl Iterator<Item = usize>) {
        self.0.resize_with(count, AtomicU8::default);
        some.for_each(|grain| *self.0[grain].get_mut() = 0);
    }

    #[inline(always)]
    pub(crate) fn note_force(&self, grain: u32) {
        if !self.any(grain) {
            self.0[grain as usize].store(FORCE, Ordering::Relaxed);
        }
    }

    #[inline(always)]
    pub(crate) fn note_lever(&self, grain: u32) {
        self.0[grain as usize].store(LEVER, Ordering::Relaxed);
    }

    #[inline(always)]
    pub(crate) fn any(&self, grain: u32) -> bool {
        self.of(grain as usize) != 0
    }

    #[inline(always)]
    fn of(&self, grain: usize) -> u8 {
        self.0[grain].load(Ordering::Relaxed)
    }
}

impl Sites {
    /// Notes that all grains have other contacts.
    pub(crate) fn outdate(&self) {
        self.outdated.store(u64::MAX, Ordering::Relaxed);
    }

    /// Notes that one of the grains has.
    pub(crate) fn outdate_grain(&self, grain: usize) {
        self.outdated.fetch_or(1 << grain, Ordering::Relaxed);
    }

    /// Gathers the contacts of grains with the forces tried now, finds their influences on each other, and the displacements. The
    /// displacements cannot be found again where what is found at the sites is not kept.
    pub(crate) fn work(&mut self, of: Range<usize>, is_kept: bool, from: Scenery<'_>, told: &mut Told<'_>) {
        if is_kept {
            return self.gather_and_displace(of, from, told);
        }
        WORKSPACE.with_borrow_mut(|workspace| {
            std::mem::swap(&mut self.now, workspace);
            self.gather_and_displace(of, from, told);
            std::mem::swap(&mut self.now, workspace);
        });
    }

    fn gather_and_displace(&mut self, of: Range<usize>, from: Scenery<'_>, told: &mut Told<'_>) {
        let outdated = std::mem::take(self.outdated.get_mut());
        if outdated != 0 {
            FORMER.with_borrow_mut(|former| {
                std::mem::swap(&mut self.list, former);
                self.list.renew(of.clone(), outdated, former, from);
            });
        }
        let count = self.list.sites.len();
        self.now.rows.resize(count, [0.0; 4]);
        self.now.forces.resize(count, 0.0);
        self.gather_all(from);
        self.find_influences(from);
        for (grain, index) in of.enumerate() {
            self.displace_grain(grain, index, from, told);
        }
    }

    /// Gathers the forces tried at all sites, and where they are.
    fn gather_all(&mut self, from: Scenery<'_>) {
        let AtSites { rows, forces, .. } = &mut self.now;
        let lots = rows.chunks_mut(AT_ONCE).zip(forces.chunks_mut(AT_ONCE));
        for (sites, (rows, forces)) in self.list.sites.chunks(AT_ONCE).zip(lots) {
            let mut places = [(&0.0, &[0.0; 4]); AT_ONCE];
            for (place, site) in places.iter_mut().zip(sites) {
                let (chunk, k) = site.find(from.contacts);
                *place = (&chunk.coupling.trial[k], &chunk.coupling.sources[k][site.body()]);
            }
            for (force, (trial, _)) in forces.iter_mut().zip(&places) {
                *force = **trial;
            }
            for (row, (_, source)) in rows.iter_mut().zip(&places) {
                *row = **source;
            }
        }
    }

    /// Gathers them at the sites of one grain, which are too few for that.
    #[inline(always)]
    fn gather_of(&mut self, grain: usize, with_rows: bool, from: Scenery<'_>) {
        let some = self.list.sites_of(grain..grain + 1);
        let (sites, rows) = (&self.list.sites[some.clone()], &mut self.now.rows[some.clone()]);
        let places = sites.iter().zip(rows).zip(&mut self.now.forces[some]);
        for ((site, row), force) in places {
            let (chunk, k) = site.find(from.contacts);
            *force = chunk.coupling.trial[k];
            if with_rows {
                *row = chunk.coupling.sources[k][site.body()];
            }
        }
    }

    /// Finds the influences of the contacts of every grain on each other.
    fn find_influences(&mut self, from: Scenery<'_>) {
        let pairs = self.list.earlier.len();
        self.now.on_later.resize(pairs, 0.0);
        self.now.on_earlier.resize(pairs, 0.0);
        let mut first = 0;
        let count = self.list.laws.len();
        while first < count {
            // grains behind each other of one law are one piece of work
            let law = self.list.laws[first];
            let others = self.list.laws[first..].iter().position(|&other| other != law);
            let end = others.map_or(count, |others| first + others);
            self.find_influences_of(first..end, law, from);
            first = end;
        }
    }

    fn find_influences_of(&mut self, grains: Range<usize>, law: LawOfGrain, from: Scenery<'_>) {
        let list = &self.list;
        let some = list.pairs_of(grains);
        let AtSites {
            rows,
            on_later,
            on_earlier,
            ..
        } = &mut self.now;
        let (on_later, on_earlier) = (&mut on_later[some.clone()], &mut on_earlier[some.clone()]);
        let pairs = Pairs {
            earlier: &list.earlier[some.clone()],
            later: &list.later[some],
            rows,
            clearances: &list.clearances,
            radii: &list.radii,
        };
        match law {
            LawOfGrain::One { kernel, is_mutual } => from.kernels.law(kernel).visit(Influences {
                pairs,
                on_later,
                on_earlier: (!is_mutual).then_some(on_earlier),
                instructions: from.instructions,
            }),
            LawOfGrain::Several => {
                for pair in 0..on_later.len() {
                    let at = pairs.contacts::<f64>(pair);
                    let [earlier, later] =
                        [pairs.earlier, pairs.later].map(|column| list.kernels[column[pair] as usize]);
                    on_later[pair] = from.kernels.influence(later, &at);
                    on_earlier[pair] = from.kernels.influence(earlier, &at.reversed());
                }
            }
        }
    }

    /// Finds the displacements anew on grains with contacts whose force or lever has changed.
    pub(crate) fn displace_again(&mut self, of: Range<usize>, from: Scenery<'_>, told: &mut Told<'_>) {
        let changed = of
            .enumerate()
            .map(|(grain, index)| (grain, index, from.changes.of(index)));
        let changed = changed.filter(|&(_, _, change)| change != 0);
        // contacts are far from each other in memory: those of all grains are asked for before any is needed
        for (grain, _, change) in changed.clone() {
            self.gather_of(grain, change == LEVER, from);
        }
        for (grain, index, change) in changed {
            if change == LEVER {
                self.find_influences_of(grain..grain + 1, self.list.laws[grain], from);
            }
            self.displace_grain(grain, index, from, told);
        }
    }

    /// Finds the displacements by the forces of a grain's sites and delivers them to the contacts, and finds how far its
    /// surface may bulge.
    #[inline(always)]
    fn displace_grain(&mut self, grain: usize, index: usize, from: Scenery<'_>, told: &mut Told<'_>) {
        let (own, pairs) = (
            self.list.sites_of(grain..grain + 1),
            self.list.pairs_of(grain..grain + 1),
        );
        let AtSites {
            rows,
            forces,
            on_later,
            on_earlier,
        } = &self.now;
        let (sites, rows, forces) = (&self.list.sites[own.clone()], &rows[own.clone()], &forces[own]);
        let on_later = &on_later[pairs.clone()];
        let on_earlier = match self.list.laws[grain] {
            LawOfGrain::One { is_mutual: true, .. } => on_later,
            _ => &on_earlier[pairs],
        };
        let radius = from.grains.radius(index);
        let mut load = Load::on(radius);
        // the first of its pairs with earlier sites, and then with each later one
        let mut first = 0;
        for (place, (site, row)) in sites.iter().zip(rows).enumerate() {
            let (earlier, later) = (&forces[..place], &forces[place + 1..]);
            let by_earlier = on_later[first..first + place].iter().zip(earlier);
            let mut displacement = by_earlier.fold(0.0, |sum, (influence, force)| sum + influence * force);
            first += place;
            let mut pair = first + place;
            for (force, pairs) in later.iter().zip(place + 1..) {
                displacement += on_earlier[pair] * force;
                pair += pairs;
            }
            load.add(forces[place], row[3]);
            let (chunk, k) = site.find(from.contacts);
            chunk.coupling.delivered[k].put(site.body(), displacement);
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

/// Some pairs of sites.
#[derive(Clone, Copy)]
struct Pairs<'a> {
    earlier: &'a [u32],
    later: &'a [u32],
    /// Of all sites.
    rows: &'a [[f64; 4]],
    clearances: &'a [f64],
    radii: &'a [f64],
}

impl Pairs<'_> {
    /// The earlier site as what displaces, the later as what is displaced, of the pairs from one on.
    #[inline(always)]
    fn contacts<L: Lanes>(&self, pair: usize) -> ContactPair<L> {
        let [mut earlier, mut later] = [[0; MOST_LANES]; 2];
        put_listed::<L>(self.earlier, pair, &mut earlier);
        put_listed::<L>(self.later, pair, &mut later);
        let [[nx, ny, nz, source_lever]] = L::fetch([self.rows], &earlier);
        let [[mx, my, mz, target_lever]] = L::fetch([self.rows], &later);
        let [mut one, mut other] = [[0; MOST_LANES]; 2];
        let mut lane = 0;
        while lane < L::COUNT {
            (one[lane], other[lane]) = (earlier[lane] as usize, later[lane] as usize);
            lane += 1;
        }
        ContactPair {
            cosine: nx * mx + ny * my + nz * mz,
            source_lever,
            target_lever,
            least_distance_squared: L::gather(self.clearances, &one) * L::gather(self.clearances, &other),
            radius: L::gather(self.radii, &other),
        }
    }
}

/// Finds the influences of some pairs of sites on each other, where one law holds for all.
struct Influences<'a> {
    pairs: Pairs<'a>,
    on_later: &'a mut [f64],
    /// Nothing where influences are mutual.
    on_earlier: Option<&'a mut [f64]>,
    instructions: Instructions,
}

impl MultiContactVisitor for Influences<'_> {
    type Output = ();

    fn visit<W: MultiContact>(self, law: &W) {
        if W::INDEPENDENT {
            self.on_later.fill(0.0);
            self.on_earlier.into_iter().for_each(|influences| influences.fill(0.0));
        } else {
            lanes::run(self.instructions, OfLaw(self, law));
        }
    }
}

/// The same with the law.
struct OfLaw<'a, 'l, W>(Influences<'a>, &'l W);

impl<W: MultiContact> Kernel for OfLaw<'_, '_, W> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self) {
        let Self(influences, law) = self;
        let Influences {
            pairs,
            on_later,
            mut on_earlier,
            ..
        } = influences;
        for pair in (0..pairs.earlier.len()).step_by(L::COUNT) {
            let at = pairs.contacts::<L>(pair);
            store_some(law.influence(&at), on_later, pair);
            if let Some(on_earlier) = &mut on_earlier {
                store_some(law.influence(&at.reversed()), on_earlier, pair);
            }
        }
    }
}
