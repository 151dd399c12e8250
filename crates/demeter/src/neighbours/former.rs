//! Where grains were when candidates were found.

use crate::comm::deforming::Carry;
use crate::comm::parts::{Listed, Part};
use crate::particles::{Row, Rows, set_aside};
use glam::{DVec3, Vec3};
use rayon::prelude::*;
use serde::{Deserialize, Serialize, Serializer};
use std::ops::Range;

/// Places of grains, each told from that of the first grain of its segment, in singles. They are needed to tell how far grains have come
/// since, and by how much they are rounded is added to that.
#[derive(Clone, Debug, PartialEq, Deserialize)]
pub(crate) struct FormerPlaces {
    per_segment: usize,
    /// Place of the first grain of every segment [m].
    firsts: Vec<DVec3>,
    /// From there to every grain [m].
    offsets: Vec<[f32; 3]>,
}

impl Default for FormerPlaces {
    fn default() -> Self {
        Self::unknown(0, 1)
    }
}

/// What is saved of [`FormerPlaces`].
#[derive(Serialize)]
#[serde(rename = "FormerPlaces")]
pub(super) struct Written<'a, 'b> {
    per_segment: usize,
    firsts: Listed<'a, 'b, DVec3>,
    offsets: Listed<'a, 'b, [f32; 3]>,
}

impl Serialize for FormerPlaces {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.written(&Part::WHOLE).serialize(serializer)
    }
}

/// The farthest that grains have come.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Farthest {
    /// Square of the largest displacement, as it is told by places that are rounded [m^2].
    pub(crate) displacement2: f64,
    /// Square of the largest distance from the first grain of a segment [m^2].
    pub(crate) offset2: f64,
}

impl Farthest {
    fn or(self, other: Self) -> Self {
        Self {
            displacement2: self.displacement2.max(other.displacement2),
            offset2: self.offset2.max(other.offset2),
        }
    }

    /// What no displacement exceeds [m].
    pub(crate) fn bound(&self) -> f64 {
        // rounding changes a vector by at most half of this; the box may have stretched it since
        self.displacement2.sqrt() + f64::from(f32::EPSILON) * self.offset2.sqrt()
    }
}

impl FormerPlaces {
    /// Those of so many grains of which none is known; they take no memory.
    pub(super) fn unknown(grains: usize, per_segment: usize) -> Self {
        Self {
            per_segment,
            firsts: vec![DVec3::ZERO; grains.div_ceil(per_segment)],
            offsets: bytemuck::zeroed_vec(grains),
        }
    }

    /// Notes where the own grains are, whose segments are whole. Those of others are forgotten.
    pub(super) fn note(&mut self, positions: &Rows, own: &Range<usize>, per_segment: usize) {
        let count = positions.len();
        if self.offsets.len() != count || self.per_segment != per_segment || own.len() != count {
            *self = Self::unknown(count, per_segment);
        }
        let segments = self.segments(own);
        self.firsts[segments]
            .par_iter_mut()
            .zip(self.offsets[own.clone()].par_chunks_mut(per_segment))
            .zip(positions.rows()[own.clone()].par_chunks(per_segment))
            .for_each(|((first, offsets), rows)| {
                *first = rows[0].vector;
                for (offset, row) in offsets.iter_mut().zip(rows) {
                    *offset = (row.vector - *first).as_vec3().to_array();
                }
            });
    }

    /// Segments of grains whose segments are whole; none where a process behind all grains has none.
    fn segments(&self, grains: &Range<usize>) -> Range<usize> {
        let first = grains.start.div_ceil(self.per_segment);
        first..grains.end.div_ceil(self.per_segment)
    }

    /// How far the own grains have come that are here now, where space was carried along about a point meanwhile.
    pub(crate) fn farthest(&self, now: &Rows, own: &Range<usize>, (middle, carry): (DVec3, &Carry)) -> Farthest {
        if own.is_empty() {
            return Farthest::default();
        }
        let of_segment = |((first, offsets), rows): ((&DVec3, &[[f32; 3]]), &[Row])| {
            let first = middle + carry.apply(first - middle);
            let all = offsets.iter().zip(rows).map(|(&offset, row)| {
                let offset = Vec3::from_array(offset).as_dvec3();
                let displacement = (row.vector - first) - carry.apply(offset);
                (displacement.length_squared(), offset.length_squared())
            });
            // what is not a number is told as misplaced
            let (displacement2, offset2) = all.fold((0.0f64, 0.0f64), |a, b| (a.0.max(b.0), a.1.max(b.1)));
            Farthest { displacement2, offset2 }
        };
        self.firsts[self.segments(own)]
            .par_iter()
            .zip(self.offsets[own.clone()].par_chunks(self.per_segment))
            .zip(now.rows()[own.clone()].par_chunks(self.per_segment))
            .map(of_segment)
            .reduce(Farthest::default, Farthest::or)
    }

    /// Those of some grains alone, whose segments are whole.
    pub(crate) fn of(&self, grains: Range<usize>) -> Self {
        Self {
            per_segment: self.per_segment,
            firsts: self.firsts[self.segments(&grains)].to_vec(),
            offsets: self.offsets[grains].to_vec(),
        }
    }

    /// These, from a segment on, as those of so many grains of which others are not known.
    pub(crate) fn among(self, segment: usize, count: usize) -> Self {
        let mut all = Self::unknown(count, self.per_segment);
        all.firsts[segment..segment + self.firsts.len()].copy_from_slice(&self.firsts);
        let first = (segment * self.per_segment).min(count);
        all.offsets[first..first + self.offsets.len()].copy_from_slice(&self.offsets);
        all
    }

    /// Adds those of the grains behind these.
    pub(crate) fn append(&mut self, behind: Self) {
        self.per_segment = behind.per_segment;
        self.firsts.extend(behind.firsts);
        self.offsets.extend(behind.offsets);
    }

    /// Number of grains.
    pub(crate) fn len(&self) -> usize {
        self.offsets.len()
    }

    /// Whether these are places of so many grains.
    pub(super) fn fits(&self, grains: usize, per_segment: usize) -> bool {
        per_segment > 0
            && self.per_segment == per_segment
            && self.len() == grains
            && self.firsts.len() == grains.div_ceil(per_segment)
    }

    /// Where a grain was, rounded [m]; nothing of those that came since.
    pub(crate) fn of_grain(&self, grain: usize) -> Option<DVec3> {
        let &offset = self.offsets.get(grain)?;
        Some(self.firsts[grain / self.per_segment] + Vec3::from_array(offset).as_dvec3())
    }

    /// What is saved.
    pub(super) fn written<'a>(&self, part: &Part<'a>) -> Written<'a, '_> {
        Written {
            per_segment: self.per_segment,
            firsts: part.of_segments(&self.firsts),
            offsets: part.of_grains(&self.offsets),
        }
    }

    /// Bytes in use, with so many own grains.
    pub(super) fn bytes(&self, own: usize) -> usize {
        own * size_of::<[f32; 3]>() + set_aside(&self.firsts)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::comm::deforming::Rates;

    /// 1,000 places in a box of 10 m, none of which singles hold.
    fn places() -> Rows {
        let mut places = Rows::default();
        let number = |k: usize| 10.0 * ((k as f64 + 0.3).sqrt() * 7.1).fract();
        (0..1000).for_each(|k| places.push(DVec3::new(number(k), number(k + 1000), number(3 * k)), 1.0));
        places
    }

    fn known(places: &Rows) -> FormerPlaces {
        let mut former = FormerPlaces::default();
        former.note(places, &(0..places.len()), 300);
        former
    }

    const NOT_CARRIED: (DVec3, &Carry) = (DVec3::ZERO, &Carry::NONE);

    #[test]
    fn no_displacement_exceeds_the_bound() {
        let mut places = places();
        let former = known(&places);
        let at_rest = former.farthest(&places, &(0..1000), NOT_CARRIED);
        // the roundings are there, and they are bounded
        assert!(
            at_rest.displacement2 > 0.0
                && at_rest.displacement2 < at_rest.offset2 * (0.5 * f64::from(f32::EPSILON)).powi(2)
        );
        assert!(at_rest.offset2 > 25.0 && at_rest.offset2 < 300.0);
        for (grain, moved) in [(0, 1e-7), (299, 1e-6), (300, 1e-3), (999, 2.0)] {
            places[grain].y += moved;
            let found = former.farthest(&places, &(0..1000), NOT_CARRIED).bound();
            assert!((moved..moved + 1e-5).contains(&found), "{grain} {found}");
        }
    }

    #[test]
    fn what_the_box_carries_along_is_no_displacement() {
        let (middle, before) = (DVec3::new(1.0, 2.0, 3.0), places());
        let former = known(&before);
        let carry = Carry::new(
            &Rates {
                stretching: DVec3::new(0.1, 0.0, -0.03),
                ..Rates::default()
            },
            None,
            1.0,
        );
        let mut now = before.clone();
        now.iter_mut()
            .for_each(|place| *place = middle + carry.apply(*place - middle));
        now[700].z += 0.01;
        let found = former.farthest(&now, &(0..1000), (middle, &carry)).bound();
        assert!((0.01..0.01 + 1e-5).contains(&found), "{found}");
    }

    #[test]
    fn parts_make_the_whole() {
        let places = places();
        let whole = known(&places);
        let mut joined = FormerPlaces::default();
        for some in [0..300, 300..900, 900..1000, 1000..1000] {
            joined.append(whole.of(some));
        }
        assert_eq!(joined, whole);
        assert!(joined.fits(1000, 300) && !joined.fits(999, 300) && !joined.fits(1000, 0));
        // others are nowhere, also where they were known before
        let (mut kept, mut own) = (whole.clone(), FormerPlaces::default());
        kept = kept.of(300..900).among(1, 1000);
        own.note(&places, &(300..900), 300);
        assert_eq!(kept, own);
        assert_eq!(kept.of_grain(0), Some(DVec3::ZERO));
        assert_eq!(kept.of_grain(1000), None);
        assert!((kept.of_grain(450).unwrap() - places[450]).length() < 2e-6);
    }
}
