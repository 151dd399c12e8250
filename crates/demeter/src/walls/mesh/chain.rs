//! Which contacts are one since others lead from one to the next.
//!
//! A sphere that nearly fills a tube, a cone or a cup of facets overlaps with many of them, each in nearly the direction of the next, the
//! first and the last in others. Were those far from the deepest contacts of their own, their number would change with what is the deepest,
//! and the energy with it, and a damped collision be damped by each. The places where a sphere is free of all faces of a hollow are a convex
//! set; the way to the nearest of them ([`bend`](super::bend)) changes without a jump while faces come and go, as those that begin are left
//! on it, and those that it leads into count before they are overlapped. So it is on the rim of a round hole, of whose edges each is close to the
//! next.

use super::bend::{Overlap, WayOut};
use super::contacts::{SAME_DIRECTION, are_one};
use super::lasting::Part;
use crate::walls::SurfaceContact;
use glam::DVec3;

/// The longest way out of a chain, as multiple of its deepest overlap, that of a cone that narrows by 10 degrees: in what grips a sphere from
/// opposite sides there is none.
const LONGEST: f64 = 6.0;
/// Faces are looked for within so many times the length of a way out, and so often while it becomes longer.
const AHEAD: f64 = 1.25;
const MOST_LOOKS: usize = 4;

/// Contacts that hang together.
#[derive(Debug, Default)]
pub(super) struct Chains {
    /// For every contact the first of those that it hangs together with.
    first: Vec<usize>,
    /// For those the depth of the deepest part [m].
    depth: Vec<f64>,
    /// Parts, each with the contact that it is one of.
    links: Vec<Part>,
    /// Those that are left on the way out of the contact that they are a part of.
    spare: Vec<Part>,
    /// Faces that a way out may lead into.
    ahead: Vec<SurfaceContact>,
}

impl Chains {
    /// Begins with some contacts.
    pub(super) fn begin(&mut self, contacts: &[SurfaceContact], radius: f64) {
        self.first.clear();
        self.depth.clear();
        self.links.clear();
        self.spare.clear();
        for contact in contacts {
            self.add(contact, radius);
        }
    }

    /// Another contact, not nearer than those before.
    pub(super) fn add(&mut self, contact: &SurfaceContact, radius: f64) {
        let number = self.first.len();
        self.first.push(number);
        self.depth.push(radius - contact.distance);
        self.join(number, contact, radius);
    }

    /// A part of a contact that is left on the way out of it.
    pub(super) fn lead(&mut self, of: usize, part: SurfaceContact, radius: f64) {
        self.join(of, &part, radius);
        self.spare.push((of, part));
    }

    /// A part of a contact: has it hang together with all that have parts which are one with it, unless it is not overlapped and both are.
    pub(super) fn join(&mut self, of: usize, part: &SurfaceContact, radius: f64) {
        let depth = radius - part.distance;
        for &(other, _) in self.links.iter().filter(|(_, other)| are_one(other, part, radius)) {
            let (one, other) = (self.first[of], self.first[other]);
            let (kept, gone) = (one.min(other), one.max(other));
            if depth <= 0.0 && self.depth[kept].min(self.depth[gone]) > 0.0 {
                continue;
            }
            for first in self.first.iter_mut().filter(|first| **first == gone) {
                *first = kept;
            }
            self.depth[kept] = self.depth[kept].max(self.depth[gone]);
        }
        self.links.push((of, *part));
    }

    /// Gives all parts that hang together one number, in place of those of their contacts, where there is a way out of all; the closest come
    /// first. Faces further away that this way would lead into are appended; `faces_within` finds those within a distance of the centre.
    pub(super) fn number(
        &mut self,
        parts: &mut Vec<Part>,
        (radius, overlaps): (f64, &mut Vec<Overlap>),
        faces_within: impl Fn(f64, &mut Vec<SurfaceContact>),
    ) {
        for first in 0..self.first.len() {
            if self.first.iter().filter(|of| **of == first).count() < 2 {
                continue;
            }
            overlaps.clear();
            let count = parts.len();
            // on the way out of all more may be left of them than on that of one contact
            for &(of, spare) in &self.spare {
                if self.first[of] == first && parts.iter().all(|(_, part)| part.element != spare.element) {
                    parts.push((of, spare));
                }
            }
            let is_of = |first_of: &[usize], part: &Part| first_of.get(part.0) == Some(&first);
            let own = parts.iter().filter(|part| is_of(&self.first, part));
            overlaps.extend(own.map(|(_, contact)| Overlap::of(contact, radius)));
            if self.is_out(first, parts, (radius, overlaps), &faces_within) {
                let own = parts.iter_mut().filter(|part| is_of(&self.first, part));
                own.for_each(|part| part.0 = first);
            } else {
                parts.truncate(count);
            }
        }
    }

    /// Whether there is a way out of some overlaps and all that it leads into, which is appended to them and to `parts`.
    fn is_out(
        &mut self,
        first: usize,
        parts: &mut Vec<Part>,
        (radius, overlaps): (f64, &mut Vec<Overlap>),
        faces_within: &impl Fn(f64, &mut Vec<SurfaceContact>),
    ) -> bool {
        if overlaps.iter().all(|overlap| overlap.depth <= 0.0) {
            return true;
        }
        let mut looked = 0.0;
        for _ in 0..MOST_LOOKS {
            let out = WayOut::of(overlaps);
            if !out.leads_out_of(overlaps, LONGEST) {
                return false;
            }
            let length = out.way.length();
            if length <= looked {
                return true;
            }
            looked = AHEAD * length;
            self.ahead.clear();
            faces_within(radius + looked, &mut self.ahead);
            (self.ahead).sort_unstable_by(|a, b| a.distance.total_cmp(&b.distance).then(a.element.cmp(&b.element)));
            // those that others lead to; what is overlapped is known
            let mut known = usize::MAX;
            while known != overlaps.len() {
                known = overlaps.len();
                for face in self.ahead.iter().filter(|face| face.distance >= radius) {
                    let is_near = |normal: DVec3| normal.dot(face.normal) > SAME_DIRECTION;
                    let mut links = self.links.iter().filter(|(of, _)| self.first[*of] == first);
                    let is_new = parts.iter().all(|(_, part)| part.element != face.element);
                    if is_new
                        && (links.any(|link| is_near(link.1.normal)) || overlaps.iter().any(|one| is_near(one.normal)))
                    {
                        overlaps.push(Overlap::of(face, radius));
                        parts.push((first, *face));
                    }
                }
            }
        }
        true
    }
}
