//! Contacts of a sphere with several edges or corners, from step to step.
//!
//! Whether two of them are one follows from how close they are ([`are_one`](super::are_one)). Were that asked in every step, a sphere that moves past
//! that bound while it overlaps with both would be pushed twice from one step to the next, with energy that comes from nowhere: on the corner of a square
//! hole both edges are overlapped as deeply. So it is asked where an overlap begins, and holds until one ends: two contacts of the step before stay
//! two, also where faces come to be overlapped that lead from the one to the other, and what was overlapped in the step before without a
//! contact of its own goes on as part of the one whose way out leaves the least of it. A contact with an edge goes on at its
//! end, too, though another edge or a face that begins there is closer.

use super::contacts::are_one_up_to;
use crate::walls::SurfaceContact;

/// Cosine of the angle up to which normals may turn away from each other while contacts are still one.
const STILL_ONE: f64 = 0.5;
/// Square of the distance up to which their places may move apart, as share of that of the radius.
const STILL_CLOSE: f64 = 1.0;
/// Cosine of the largest turn of the normal at which a contact, with all that it remembers, goes on at another element.
pub(crate) const SAME_SURFACE: f64 = 0.5;

/// A contact, and which others it is one with: those with the same number.
pub(super) type Part = (usize, SurfaceContact);

/// What a sphere touched in the step before.
pub(crate) struct Before<'a> {
    /// The contacts that acted.
    pub(crate) contacts: &'a [SurfaceContact],
    /// Whether it overlapped there, of a part of the surface.
    pub(crate) was_overlapped: &'a dyn Fn(&SurfaceContact) -> bool,
}

impl Before<'_> {
    /// Nothing.
    pub(crate) const NOTHING: Self = Self {
        contacts: &[],
        was_overlapped: &|_| false,
    };

    /// Whether an element was touched.
    pub(super) fn has(&self, element: u32) -> bool {
        self.contacts.iter().any(|other| other.element == element)
    }

    /// Has parts be one with those they were one with. Their numbers, all below their count, tell so far how close they are.
    pub(super) fn go_on(&self, parts: &mut [Part], radius: f64) {
        if self.contacts.is_empty() || parts.len() < 2 {
            return;
        }
        let (mut next, mut split) = (parts.len(), Vec::new());
        for n in 1..parts.len() {
            let (of, part) = parts[n];
            let were_two = |other: &Part| {
                let are_deep = || (self.was_overlapped)(&part) && (self.was_overlapped)(&other.1);
                other.0 == of && self.has(other.1.element) && (is_at_edge(&other.1, &part) || are_deep())
            };
            if self.has(part.element) && parts[..n].iter().any(were_two) {
                parts[n].0 = next;
                split.push((next, of));
                next += 1;
            }
        }
        // how close they are would have one number
        let together = |number: usize| {
            let of = split.iter().find(|(new, _)| *new == number);
            of.map_or(number, |(_, of)| *of)
        };
        for n in 0..parts.len() {
            let part = parts[n].1;
            let is_known_or_new = self.has(part.element) || !(self.was_overlapped)(&part);
            if is_known_or_new || self.contacts.iter().any(|old| goes_on_at(old, &part, parts)) {
                continue;
            }
            // what is left of the overlap there on the way out of a contact of the step before
            let left_of = |other: &SurfaceContact| {
                let old = self.contacts.iter().find(|old| old.element == other.element);
                old.map_or(f64::INFINITY, |old| {
                    radius - part.distance - (radius - old.distance) * old.normal.dot(part.normal)
                })
            };
            let may_be_one = |(of, other): &Part| match is_at_edge(other, &part) {
                true => are_still_one(other, &part, radius),
                false => together(*of) == together(parts[n].0),
            };
            let known = parts
                .iter()
                .filter(|other| self.has(other.1.element) && may_be_one(other));
            if let Some(&(of, _)) = known.min_by(|(_, a), (_, b)| left_of(a).total_cmp(&left_of(b))) {
                parts[n].0 = of;
            }
        }
    }
}

/// Whether two contacts that were one are still.
pub(crate) fn are_still_one(a: &SurfaceContact, b: &SurfaceContact, radius: f64) -> bool {
    let [a, b] = [a, b].map(|contact| (contact.normal, contact.distance));
    are_one_up_to(STILL_ONE, STILL_CLOSE, a, b, radius)
}

/// Whether a contact of the step before, whose element is touched no more, may go on at a part.
fn goes_on_at(old: &SurfaceContact, part: &SurfaceContact, parts: &[Part]) -> bool {
    old.normal.dot(part.normal) > SAME_SURFACE && parts.iter().all(|(_, other)| other.element != old.element)
}

fn is_at_edge(a: &SurfaceContact, b: &SurfaceContact) -> bool {
    a.is_at_edge || b.is_at_edge
}
