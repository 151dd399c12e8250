//! What processes tell each other when candidates are found: boxes around all segments to all, and the places of grains to those
//! who have some near. What never changes of a grain is told the first time that its segment comes near.
//!
//! Whose boxes are near is found by both sides from the same numbers, so that both know what is told.

use super::{Division, Introduced, Segment};
use crate::comm::Message;
use crate::neighbours::{Bounds, BoxesOfClasses, CORNERS, Counts, Extent, Extremes, Reach, SizeClasses, Vicinity};
use crate::particles::{CONSTANTS, Grains};
use crate::simulation::Simulation;
use std::ops::Range;

/// Bytes of the bounds of what a process has.
const BYTES_OF_BOUNDS: usize = 2 * 6 * size_of::<f64>();

/// What the radii of all grains tell: it changes with the grains alone.
#[derive(Clone, Debug, Default)]
pub(super) struct SizesOfAll {
    classes: SizeClasses,
    /// Classes that are among the grains of every segment.
    of_segments: Vec<u32>,
}

/// Classes of some grains: how many are in each with their largest radius, and which are among those of every segment.
type Sizes = (Vec<(usize, f64)>, Vec<u32>);

/// Numbers that tell a place.
const PLACE: usize = 3;

/// The boxes of all segments, and of all of a process.
struct Boxes {
    segments: Vec<BoxesOfClasses>,
    ranks: Vec<BoxesOfClasses>,
}

impl Division {
    /// Learns what the radii of all grains tell; each process calls this.
    pub(super) fn note_sizes(&mut self, grains: &Grains, per_segment: usize) {
        let rows = &grains.position.rows()[self.own.clone()];
        let mut classes = SizeClasses::between(self.fold(Extremes::of(rows), Extremes::join));
        let mut of_segments = Vec::new();
        let mut own = classes.clone();
        own.count(rows);
        let among = rows
            .chunks(per_segment.max(1))
            .map(|rows| classes.among(rows))
            .collect();
        let mine: Sizes = (own.members().to_vec(), among);
        for (members, among) in self.told_by_all(&mine) {
            classes.join(&members);
            of_segments.extend(among);
        }
        self.sizes = SizesOfAll { classes, of_segments };
    }

    /// What is told to all: bounds of the own grains, and boxes around those of every own segment.
    fn tell_boxes(&self, grains: &Grains, per_segment: usize) -> Vec<u8> {
        let rows = &grains.position.rows()[self.own.clone()];
        let mut bytes = Vec::new();
        for Bounds { lower, upper } in [Bounds::of_centres(rows), Bounds::of_grains(rows)] {
            let corners = [lower.to_array(), upper.to_array()];
            bytes.extend_from_slice(bytemuck::cast_slice(&corners));
        }
        for (rows, among) in rows.chunks(per_segment).zip(&self.sizes.of_segments[self.segments()]) {
            let boxes = BoxesOfClasses::around(rows, *among, &self.sizes.classes);
            let numbers: Vec<f32> = boxes.numbers().collect();
            bytes.extend_from_slice(bytemuck::cast_slice(&numbers));
        }
        bytes
    }

    /// What all told: the bounds of all centres, of all grains, and the boxes.
    fn hear_boxes(&self, told: &[Vec<u8>]) -> (Bounds, Bounds, Boxes) {
        let (mut centres, mut surfaces) = (Bounds::NOTHING, Bounds::NOTHING);
        let mut boxes = Boxes {
            segments: Vec::with_capacity(self.sizes.of_segments.len()),
            ranks: Vec::with_capacity(told.len()),
        };
        for (rank, bytes) in told.iter().enumerate() {
            let among = &self.sizes.of_segments[self.cuts[rank]..self.cuts[rank + 1]];
            let count: usize = among.iter().map(|classes| classes.count_ones() as usize).sum();
            if bytes.len() != BYTES_OF_BOUNDS + count * size_of::<[f32; CORNERS]>() {
                self.ranks.give_up("another process has other grains");
            }
            let (bounds, numbers) = bytes.split_at(BYTES_OF_BOUNDS);
            let corners: [[f64; 3]; 4] = bytemuck::pod_read_unaligned(bounds);
            let [a, b, c, d] = corners.map(Into::into);
            centres = centres.join(Bounds { lower: a, upper: b });
            surfaces = surfaces.join(Bounds { lower: c, upper: d });
            let numbers = numbers.chunks_exact(size_of::<[f32; CORNERS]>());
            let numbers: Vec<[f32; CORNERS]> = numbers.map(bytemuck::pod_read_unaligned).collect();
            let (mut numbers, mut all) = (&numbers[..], BoxesOfClasses::default());
            for &classes in among {
                let (own, others) = numbers.split_at(classes.count_ones() as usize);
                let segment = BoxesOfClasses::of_numbers(classes, own);
                all.join(&segment);
                boxes.segments.push(segment);
                numbers = others;
            }
            boxes.ranks.push(all);
        }
        (centres, surfaces, boxes)
    }

    /// Own segments that others have grains near, and those of others near own ones, with the other process.
    fn near_segments(&self, boxes: &Boxes, reach: &Reach) -> Vec<(usize, [Vec<usize>; 2])> {
        let (rank, own) = (self.ranks.rank(), self.segments());
        let mut found = Vec::new();
        for other in (0..self.ranks.count()).filter(|&other| other != rank) {
            let (here, there) = (&boxes.ranks[rank], &boxes.ranks[other]);
            if !reach.joins(here, there) {
                continue;
            }
            let near = |some: Range<usize>, to: &BoxesOfClasses| -> Vec<usize> {
                some.filter(|&s| reach.joins(&boxes.segments[s], to)).collect()
            };
            let mut tell = near(own.clone(), there);
            let mut hear = near(self.cuts[other]..self.cuts[other + 1], here);
            let joins = |one: usize, other: usize| reach.joins(&boxes.segments[one], &boxes.segments[other]);
            let heard: Vec<bool> = hear.iter().map(|&s| tell.iter().any(|&t| joins(t, s))).collect();
            tell.retain(|&t| hear.iter().any(|&s| joins(t, s)));
            let mut heard = heard.into_iter();
            hear.retain(|_| heard.next() == Some(true));
            if !tell.is_empty() {
                found.push((other, [tell, hear]));
            }
        }
        found
    }
}

impl Simulation {
    /// Tells those with grains near own ones the places of these, for a search of all pairs closer than `skin` to touching.
    /// Answers with what is known then; with nothing where all is.
    pub(in crate::simulation) fn share_places(&mut self, skin: f64) -> Option<Vicinity> {
        let division = self.division.as_mut().filter(|division| !division.is_whole)?;
        let (per_segment, count) = (self.neighbours.grains_per_segment(), self.grains.len());
        let told = division.ranks.gather(&division.tell_boxes(&self.grains, per_segment));
        let (centres, surfaces, boxes) = division.hear_boxes(&told);
        let classes = division.sizes.classes.clone();
        let extent = Extent::find(centres, &classes, &self.comm, skin, |within| {
            let own = &self.grains.position.rows()[division.own.clone()];
            division.fold(Counts::of(own.iter().map(|row| row.vector), within), Counts::plus)
        });
        let reach = Reach::new(&classes, extent, &self.comm, skin);
        let near = division.near_segments(&boxes, &reach);
        let grains_of = |segment: usize| segment * per_segment..((segment + 1) * per_segment).min(count);
        let mut messages: Vec<Message> = Vec::with_capacity(near.len());
        let mut known = vec![division.own.clone()];
        for (rank, [tell, hear]) in &near {
            let mut message = Message {
                rank: *rank,
                ..Message::default()
            };
            for &segment in tell {
                let introduced = introduce(&mut division.introduced, *rank, segment, grains_of(segment).len());
                for (grain, is_known) in grains_of(segment).zip(introduced) {
                    message.tell.extend(self.grains.position[grain].to_array());
                    if !std::mem::replace(is_known, true) {
                        message.tell.extend(self.grains.constants(grain));
                    }
                }
            }
            for &segment in hear {
                let introduced = introduce(&mut division.introduced, *rank, segment, grains_of(segment).len());
                let new = introduced.iter().filter(|is_known| !**is_known).count();
                let numbers = PLACE * introduced.len() + CONSTANTS * new;
                message.hear.resize(message.hear.len() + numbers, 0.0);
            }
            messages.push(message);
            known.extend(hear.iter().map(|&s| grains_of(s)));
        }
        division.ranks.exchange(&mut messages, &mut || ());
        for ((rank, [_, hear]), message) in near.iter().zip(&messages) {
            let mut numbers = &message.hear[..];
            for &segment in hear {
                let introduced = introduce(&mut division.introduced, *rank, segment, grains_of(segment).len());
                for (grain, is_known) in grains_of(segment).zip(introduced) {
                    let (place, rest) = numbers.split_at(PLACE);
                    self.grains.position[grain] = glam::DVec3::from_slice(place);
                    numbers = rest;
                    if !std::mem::replace(is_known, true) {
                        let (constants, rest) = numbers.split_at(CONSTANTS);
                        self.grains.set_constants(grain, constants);
                        numbers = rest;
                    }
                }
            }
        }
        Some(Vicinity {
            classes,
            extent,
            surfaces,
            known: joined(known),
        })
    }

    /// Mean radius of all grains [m]; each process calls this.
    pub(in crate::simulation) fn mean_radius(&self) -> f64 {
        let sum = |segment: Segment| segment.grains.map(|grain| self.grains.radius(grain)).sum::<f64>();
        self.sum_of_all(sum) / self.grains.len().max(1) as f64
    }
}

/// Which grains of a segment with so many one process has introduced to another.
fn introduce(introduced: &mut Introduced, other: usize, segment: usize, count: usize) -> &mut [bool] {
    introduced.entry((other, segment)).or_insert_with(|| vec![false; count])
}

/// Stretches by rising indices; those that follow each other as one.
fn joined(mut stretches: Vec<Range<usize>>) -> Vec<Range<usize>> {
    stretches.retain(|stretch| !stretch.is_empty());
    stretches.sort_unstable_by_key(|stretch| stretch.start);
    stretches.dedup_by(|next, before| {
        let follows = next.start == before.end;
        if follows {
            before.end = next.end;
        }
        follows
    });
    stretches
}
