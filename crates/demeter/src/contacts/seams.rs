//! Where separate walls meet: there a grain is pushed by one of them, as by one surface.
//!
//! A wall that a grain touches at an edge does nothing when that place lies on another wall, too, and that one is nearer to the centre.
//! So a grain on the seam of two plates, or beside the rim at which a cylinder ends on a cone, rebounds as it does from a plate or a
//! cone alone. Within a mesh its [triangles](crate::walls::Mesh) follow the same rule. Of walls that are as near, one pushes that is not
//! touched at an edge, else the first.
//!
//! What is left of contacts with walls of one material is joined where it would be one contact on a mesh: in a hollow, at a low step, where
//! walls lie in one place. A contact that so ends at one wall goes on at the other with all that it remembers. Where contacts feel each
//! other neither is done.

use super::wall_contacts::geometry;
use super::{ContactChunk, Scene, WORD, is_set};
use crate::neighbours::WallPair;
use crate::walls::{Overlap, SAME_SURFACE, SurfaceContact, Wall, are_one, are_still_one, joined};
use glam::DVec3;
use std::cell::RefCell;
use std::ops::Range;

/// Within so many radii of the grain two walls meet: more than what single precision makes of coordinates in mesh files.
const MEETS: f64 = 1e-3;

/// Distances that are the same to so many radii are the same.
const SAME: f64 = 1e-9;

/// Distance, whether that is to an edge, and the number of the wall: the same whichever wall is asked, so that of walls that meet one
/// pushes always.
type Rank = (f64, bool, usize);

thread_local! {
    static PARTS: RefCell<Vec<SurfaceContact>> = RefCell::default();
}

impl Scene<'_> {
    /// Whether a grain is pushed by another wall where it touches this one.
    #[inline]
    pub(super) fn is_pushed_by_another(&self, grain: usize, wall: usize, part: &SurfaceContact) -> bool {
        part.is_at_edge && self.walls.len() > 1 && self.is_on_a_nearer(grain, wall, part)
    }

    fn is_on_a_nearer(&self, grain: usize, wall: usize, part: &SurfaceContact) -> bool {
        let (centre, radius) = (self.grains.position[grain], self.grains.radius(grain));
        let place = centre - part.normal * part.distance;
        let meets = |other: &Wall| other.clearance(place, 2.0 * MEETS * radius).abs() <= MEETS * radius;
        let others = (self.walls.iter().enumerate()).filter(|(k, other)| *k != wall && meets(other));
        let mut own: Option<Rank> = None;
        for (k, _) in others {
            let beyond = part.distance + MEETS * radius - radius;
            let rank = |k: usize, element| self.rank(k, element, centre, (radius, beyond));
            let own = own.get_or_insert_with(|| rank(wall, Some(part.element)).unwrap_or((f64::INFINITY, true, wall)));
            if rank(k, None).is_some_and(|rank| rank < *own) {
                return true;
            }
        }
        false
    }

    /// Rank of an element of a wall, or of that of its elements which comes first, of all that a sphere of a radius touches or is so near.
    fn rank(&self, wall: usize, element: Option<u32>, centre: DVec3, (radius, beyond): (f64, f64)) -> Option<Rank> {
        PARTS.with_borrow_mut(|parts| {
            parts.clear();
            self.walls[wall].contacts(centre, (radius, beyond), parts);
            (parts.iter())
                .filter(|part| element.is_none_or(|element| part.element == element))
                .map(|part| ((part.distance / (SAME * radius)).round(), part.is_at_edge, wall))
                .min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)))
        })
    }
}

/// A contact of a grain by its number in the chunk, and the one, by its place among those of the grain, of which it is a part.
type Beside = (usize, SurfaceContact, Option<usize>);

thread_local! {
    static OF_GRAIN: RefCell<(Vec<Beside>, Vec<Overlap>)> = RefCell::default();
}

impl ContactChunk {
    /// Makes one of contacts of a grain with separate walls that would be one on a mesh ([`are_one`]): the others are as far away as to do
    /// nothing.
    pub(super) fn join_at_seams(&mut self, window: f64, scene: &Scene) {
        let mut first = 0;
        while first < self.len() {
            let grain = self.i[first];
            let count = self.i[first..].iter().take_while(|&&other| other == grain).count();
            if count > 1 {
                OF_GRAIN.with_borrow_mut(|(parts, overlaps)| {
                    self.join_of_grain(first..first + count, window, scene, (parts, overlaps));
                });
            }
            first += count;
        }
    }

    fn join_of_grain(
        &mut self,
        of: Range<usize>,
        window: f64,
        scene: &Scene,
        (parts, overlaps): (&mut Vec<Beside>, &mut Vec<Overlap>),
    ) {
        let grain = self.i[of.start] as usize;
        let (centre, radius) = (scene.grains.position[grain], scene.grains.radius(grain));
        let reach = radius + window;
        let near = of.filter(|&k| self.now.geometry[k].lever_i <= reach);
        parts.clear();
        parts.extend(near.map(|k| (k, self.now.at_wall(k), None)));
        let is_beside = |(k, part, _): &Beside| {
            let is_other =
                |(l, other, _): &Beside| self.j[*k] != self.j[*l] && part.normal.dot(other.normal) > SAME_SURFACE;
            parts.iter().any(is_other)
        };
        if !parts.iter().any(is_beside) {
            return;
        }
        for (k, part, _) in parts.iter_mut() {
            let wall = &scene.walls[self.j[*k] as usize];
            part.is_at_edge = match wall.mesh() {
                Some(mesh) => part.element as usize >= mesh.triangles().len(),
                None => (wall.contact_with(part.element, centre, reach)).is_some_and(|found| found.is_at_edge),
            };
        }
        // of those as close, walls come in their order
        parts.sort_by(|(_, a, _), (_, b, _)| a.distance.total_cmp(&b.distance));
        for n in 1..parts.len() {
            let (k, part, _) = parts[n];
            parts[n].2 = parts[..n].iter().position(|(l, other, of)| {
                of.is_none() && self.j[*l] != self.j[k] && self.go_on_as_one((*l, other), (k, &part), parts, scene)
            });
        }
        for n in 0..parts.len() {
            let (k, mut part, of) = parts[n];
            let mut others = parts.iter().filter(|(.., of)| *of == Some(n)).peekable();
            if of.is_some() {
                part.distance = 2.0 * reach;
            } else if others.peek().is_some() {
                let all = std::iter::once(&parts[n]).chain(others.clone());
                let seen = |which: usize, way| {
                    let (k, part, _) = all.clone().nth(which)?;
                    let found = scene.walls[self.j[*k] as usize].contact_with(part.element, centre + way, reach)?;
                    Some((found.distance, found.normal))
                };
                part = joined(part, others.map(|(_, part, _)| *part), (radius, &mut *overlaps), seen);
            } else {
                continue;
            }
            self.now.geometry[k] = geometry(&part, radius);
        }
    }

    /// Whether two contacts of a grain, each with its number, are one: as they were in the step before, where it overlapped with both, else as
    /// [`are_one`] tells. `parts` are all that are near.
    fn go_on_as_one(
        &self,
        (k, a): (usize, &SurfaceContact),
        (l, b): (usize, &SurfaceContact),
        parts: &[Beside],
        scene: &Scene,
    ) -> bool {
        let radius = scene.grains.radius(self.i[k] as usize);
        let acted = |contact: usize| is_set(&self.engaged, contact);
        let (unknown, part) = match (acted(k), acted(l)) {
            (true, true) => return false,
            (true, false) => (l, b),
            (false, true) => (k, a),
            (false, false) => return are_one(a, b, radius),
        };
        let pair = WallPair {
            grain: self.i[unknown],
            wall: self.j[unknown],
        };
        // a contact with another wall that is left may go on here
        let may_go_on = |old: usize| {
            acted(old)
                && self.now.geometry[old].normal.dot(part.normal) > SAME_SURFACE
                && parts.iter().all(|(near, ..)| *near != old)
        };
        let first = self.i.partition_point(|&other| other < pair.grain);
        let mut own = (first..self.len()).take_while(|&old| self.i[old] == pair.grain);
        if scene.was_overlapped(&pair, part) && !own.any(may_go_on) {
            are_still_one(a, b, radius)
        } else {
            are_one(a, b, radius)
        }
    }

    /// Has contacts go on at the walls that push now where walls meet, with all that they remember: those of the table that another wall
    /// does without from now on, and `orphans` of the step before that are in it no more, each with its grain.
    ///
    /// A chunk holds all walls near a grain with which it has the same laws.
    pub(super) fn hand_over_at_seams(&mut self, orphans: &mut Vec<(usize, u32)>, scene: &Scene) {
        let stride = scene.stride;
        for (old, grain) in orphans.drain(..) {
            let normal = self.before.geometry[old].normal;
            match self.pushing_now(grain, normal) {
                Some(new) => {
                    let history = self.before.history_of(old, stride);
                    self.now.history[new * stride..(new + 1) * stride].copy_from_slice(history);
                    self.now.normal_force[new] = self.before.normal_force[old];
                    self.set_engaged(new, true);
                }
                None => self.book_end(old, scene),
            }
        }
        if scene.walls.len() < 2 {
            return;
        }
        for word in 0..self.engaged.len() {
            let mut left = self.engaged[word];
            while left != 0 {
                let old = word * WORD + left.trailing_zeros() as usize;
                left &= left - 1;
                let (grain, contact) = (self.i[old], self.now.geometry[old]);
                // as far away as what another wall does without
                if contact.overlap >= -scene.grains.radius(grain as usize) {
                    continue;
                }
                if let Some(new) = self.pushing_now(grain, contact.normal) {
                    let places = old * stride..(old + 1) * stride;
                    self.now.history.copy_within(places.clone(), new * stride);
                    self.now.history[places].fill(0.0);
                    self.now.normal_force[new] = std::mem::take(&mut self.now.normal_force[old]);
                    self.set_engaged(new, true);
                    self.set_engaged(old, false);
                }
            }
        }
    }

    /// Of the contacts of a grain that did not act in the step before and have nearly some normal, the deepest.
    fn pushing_now(&self, grain: u32, normal: DVec3) -> Option<usize> {
        let first = self.i.partition_point(|&other| other < grain);
        let own = (first..self.len()).take_while(|&k| self.i[k] == grain);
        let is_free = |k: &usize| !is_set(&self.engaged, *k) && self.now.geometry[*k].normal.dot(normal) > SAME_SURFACE;
        let overlap = |k: &usize| self.now.geometry[*k].overlap;
        own.filter(is_free)
            .max_by(|a, b| overlap(a).total_cmp(&overlap(b)).then(b.cmp(a)))
    }

    fn set_engaged(&mut self, contact: usize, is_engaged: bool) {
        let (word, bit) = (&mut self.engaged[contact / WORD], 1 << (contact % WORD));
        if is_engaged {
            *word |= bit;
        } else {
            *word &= !bit;
        }
    }
}
