//! Which the contacts of grains are, by grain.

use super::kernels::Kernels;
use super::sites::Scenery;
use crate::contacts::{ContactChunk, Contacts};
use demeter_physics::contact::multi_contact::clearance;
use std::ops::Range;

/// One contact, seen from one of its bodies: whether the partner is a wall, which body it is, the chunk, and the place in it: of the
/// candidate, which stays when others begin or end, or of the contact with a wall.
#[derive(Clone, Copy, Debug)]
pub(super) struct Site(u64);

impl Site {
    #[inline(always)]
    fn new(wall: bool, body: usize, chunk: usize, place: usize) -> Self {
        Self(u64::from(wall) << 63 | (body as u64) << 62 | (chunk as u64) << 32 | place as u64)
    }

    #[inline(always)]
    pub(super) fn body(self) -> usize {
        (self.0 >> 62 & 1) as usize
    }

    /// The chunk, and the place in it.
    #[inline(always)]
    pub(super) fn find(self, contacts: &Contacts) -> (&ContactChunk, usize) {
        let (chunk, place) = ((self.0 >> 32 & 0x3fff_ffff) as usize, (self.0 & 0xffff_ffff) as usize);
        if self.0 >> 63 == 1 {
            (&contacts.walls[chunk], place)
        } else {
            let chunk = &contacts.pairs[chunk];
            (chunk, chunk.now.contact_of(place))
        }
    }
}

/// Contacts of some grains, by grain, in the order of the partner's id.
#[derive(Debug, Default)]
pub(super) struct SiteList {
    pub(super) sites: Vec<Site>,
    /// What every site keeps clear around it, and the radius of its grain [m].
    pub(super) clearances: Vec<f64>,
    pub(super) radii: Vec<f64>,
    /// Laws that displace the surfaces at the sites.
    pub(super) kernels: Vec<u32>,
    /// Where the sites of every grain begin, and their pairs; one more than grains.
    starts: Vec<[u32; 2]>,
    pub(super) laws: Vec<LawOfGrain>,
    /// Pairs of sites of every grain, `(0, 1), (0, 2), (1, 2), ...`.
    pub(super) earlier: Vec<u32>,
    pub(super) later: Vec<u32>,
}

/// The law of all contacts of a grain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum LawOfGrain {
    One { kernel: u32, is_mutual: bool },
    Several,
}

impl SiteList {
    #[inline(always)]
    pub(super) fn sites_of(&self, grains: Range<usize>) -> Range<usize> {
        self.starts[grains.start][0] as usize..self.starts[grains.end][0] as usize
    }

    #[inline(always)]
    pub(super) fn pairs_of(&self, grains: Range<usize>) -> Range<usize> {
        self.starts[grains.start][1] as usize..self.starts[grains.end][1] as usize
    }

    /// Finds the contacts of those of the grains that have others now, told by a bit each, and takes those of the others from the former list.
    pub(super) fn renew(&mut self, of: Range<usize>, outdated: u64, former: &Self, from: Scenery<'_>) {
        self.clear();
        let mut grain = 0;
        while grain < of.len() {
            let rest = outdated >> grain;
            if rest & 1 == 1 {
                self.find(of.start + grain, from);
                grain += 1;
            } else {
                let end = (grain + rest.trailing_zeros() as usize).min(of.len());
                self.take_on(former, grain..end);
                grain = end;
            }
        }
    }

    fn clear(&mut self) {
        self.sites.clear();
        self.clearances.clear();
        self.radii.clear();
        self.kernels.clear();
        self.laws.clear();
        self.earlier.clear();
        self.later.clear();
        self.starts.clear();
        self.starts.push([0; 2]);
    }

    /// Takes the contacts of some grains from another list.
    fn take_on(&mut self, other: &Self, grains: Range<usize>) {
        let (sites, pairs) = (other.sites_of(grains.clone()), other.pairs_of(grains.clone()));
        // how far they move in the lists, also to the front
        let moved = [(self.sites.len(), sites.start), (self.earlier.len(), pairs.start)]
            .map(|(here, there)| (here as u32).wrapping_sub(there as u32));
        self.sites.extend_from_slice(&other.sites[sites.clone()]);
        self.clearances.extend_from_slice(&other.clearances[sites.clone()]);
        self.radii.extend_from_slice(&other.radii[sites.clone()]);
        self.kernels.extend_from_slice(&other.kernels[sites]);
        self.laws.extend_from_slice(&other.laws[grains.clone()]);
        let move_on = |site: &u32| site.wrapping_add(moved[0]);
        self.earlier.extend(other.earlier[pairs.clone()].iter().map(move_on));
        self.later.extend(other.later[pairs].iter().map(move_on));
        let ends = other.starts[grains.start + 1..=grains.end].iter();
        (self.starts).extend(ends.map(|end| [0, 1].map(|k| end[k].wrapping_add(moved[k]))));
    }

    /// Finds the contacts of one more grain.
    fn find(&mut self, grain: usize, from: Scenery<'_>) {
        let first = self.sites.len();
        let radius = from.grains.radius(grain);
        for (chunk, slot, is_first) in from.neighbours.pairs_of(grain) {
            self.take((false, chunk, slot), usize::from(!is_first), radius, from);
        }
        for (chunk, slot) in from.neighbours.wall_pairs_of(grain) {
            self.take((true, chunk, slot), 0, radius, from);
        }
        self.laws.push(LawOfGrain::of(&self.kernels[first..], from.kernels));
        for later in first..self.sites.len() {
            self.earlier.extend(first as u32..later as u32);
            self.later.resize(self.earlier.len(), later as u32);
        }
        self.starts
            .push([self.sites.len(), self.earlier.len()].map(|end| end as u32));
    }

    /// Takes the contacts of one candidate.
    #[inline(always)]
    fn take(&mut self, (wall, number, slot): (bool, usize, usize), body: usize, radius: f64, from: Scenery<'_>) {
        let contacts = if wall {
            &from.contacts.walls
        } else {
            &from.contacts.pairs
        };
        let chunk = &contacts[number];
        for k in chunk.contacts_of(slot) {
            // at a wall the size tells the grain's radius
            let effective = (!wall).then(|| chunk.coupling.size[k].radius);
            let place = if wall { k } else { slot };
            self.sites.push(Site::new(wall, body, number, place));
            self.clearances.push(clearance(radius, effective));
            self.radii.push(radius);
            self.kernels.push(from.kernels.of(chunk.law())[body]);
        }
    }
}

impl LawOfGrain {
    /// Told the laws at all contacts of the grain.
    fn of(laws: &[u32], kernels: &Kernels) -> Self {
        let kernel = laws.first().copied().unwrap_or(0);
        if laws.iter().all(|&law| law == kernel) {
            let is_mutual = kernels.is_mutual(kernel);
            Self::One { kernel, is_mutual }
        } else {
            Self::Several
        }
    }
}
