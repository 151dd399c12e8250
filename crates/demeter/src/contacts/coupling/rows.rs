//! What displaces a contact: the influences of the other contacts of its bodies, and the force that follows.

use super::sites::{self, ContactPlace, GrainSites, Sites};
use super::{Scratch, Worst};
use crate::contacts::block::{next_run, normal_window};
use crate::contacts::{ContactChunk, Fault, Kept, Scene};
use demeter_physics::contact::multi_contact::{Body, ContactPair, MultiContact, MultiContactLaw, MultiContactVisitor};
use demeter_physics::contact::normal::{Normal, NormalInput, NormalVisitor};
use demeter_physics::integrator::Integrator;

/// A displaced overlap beyond this multiple of the largest overlap allowed tells that the coupled equation has no
/// solution: at the fold of a regular packing the displacements add twice the overlap.
const LARGEST_DISPLACED: f64 = 3.0;

/// Influences on every contact of a chunk: for contact `k` and body `b` those of `start[2 k + b]..start[2 k + b + 1]`.
#[derive(Clone, Debug, Default)]
pub(crate) struct Rows {
    start: Vec<u32>,
    values: Vec<f64>,
}

/// Where a chunk stands among the others.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ChunkPlace {
    pub(crate) wall: bool,
    pub(crate) chunk: u32,
}

impl ChunkPlace {
    fn contact(self, contact: usize) -> ContactPlace {
        ContactPlace {
            wall: self.wall,
            chunk: self.chunk,
            contact: contact as u32,
        }
    }
}

/// One contact as the target of displacements.
#[derive(Clone, Copy)]
struct Target {
    body: Body,
    place: ContactPlace,
    normal: [f64; 3],
    lever: f64,
    clearance: f64,
    radius: f64,
}

struct Influences<'a> {
    target: Target,
    sources: GrainSites<'a>,
    row: &'a mut Vec<f64>,
}

impl MultiContactVisitor for Influences<'_> {
    type Output = ();

    fn visit<L: MultiContact>(self, law: &L) {
        let (target, sources) = (self.target, self.sources);
        let [x, y, z] = target.normal;
        let count = sources.force.len();
        let first = self.row.len();
        self.row.resize(first + count, 0.0);
        let row = &mut self.row[first..];
        if L::INDEPENDENT {
            return;
        }
        // slices of one length: the loop has no bounds to check
        let [nx, ny, nz] = sources.normal.map(|n| &n[..count]);
        let (lever, clearance) = (&sources.lever[..count], &sources.clearance[..count]);
        for s in 0..count {
            row[s] = law.influence(
                target.body,
                &ContactPair {
                    cosine: x * nx[s] + y * ny[s] + z * nz[s],
                    source_lever: lever[s],
                    target_lever: target.lever,
                    least_distance_squared: target.clearance * clearance[s],
                    radius: target.radius,
                },
            );
        }
        if let Some(own) = sources.place.iter().position(|place| *place == target.place) {
            row[own] = 0.0;
        }
    }
}

/// Appends the influences on a contact of the other contacts of one of its bodies.
fn influences(law: &MultiContactLaw, target: Target, sources: GrainSites<'_>, row: &mut Vec<f64>) {
    law.visit(Influences { target, sources, row });
}

#[inline(always)]
fn displacement(row: &[f64], force: &[f64]) -> f64 {
    row.iter().zip(force).map(|(influence, force)| influence * force).sum()
}

/// Elastic forces of a run of contacts of one material pair, at the displaced overlaps.
struct Elastic<'a> {
    dt: f64,
    integrator: Integrator,
    stride: usize,
    overlap: &'a [f64],
    rate: &'a [f64],
    size: &'a [demeter_physics::contact::PairSize],
    history: &'a [f64],
    memory: &'a mut Vec<f64>,
    answer: &'a mut [f64],
}

impl NormalVisitor for Elastic<'_> {
    type Output = ();

    fn visit<L: Normal>(self, law: &L) {
        let remembered = law.history();
        self.memory.resize(remembered, 0.0);
        for (k, answer) in self.answer.iter_mut().enumerate() {
            let (overlap, rate) = (self.overlap[k], self.rate[k]);
            let input = NormalInput {
                size: self.size[k],
                overlap,
                rate,
                half_window: normal_window::<L>(self.integrator, overlap, rate, self.dt),
            };
            self.memory
                .copy_from_slice(&self.history[k * self.stride..][..remembered]);
            *answer = law.respond(&input, self.memory).elastic;
        }
    }
}

impl ContactChunk {
    /// Target of displacements on one of the bodies of a contact.
    fn target(&self, k: usize, at: ChunkPlace, first: bool, scene: &Scene) -> Target {
        let contact = &self.now.geometry[k];
        let (grain, normal, body) = if first {
            (self.i[k], contact.normal, Body::First)
        } else {
            (self.j[k], -contact.normal, Body::Second)
        };
        let radius = scene.grains.radius[grain as usize];
        let size = (!at.wall).then(|| self.coupling.size[k].radius);
        Target {
            body,
            place: at.contact(k),
            normal: normal.to_array(),
            lever: sites::lever(self, k, at.wall, first),
            clearance: demeter_physics::contact::multi_contact::clearance(radius, size),
            radius,
        }
    }

    /// Finds the influences on all contacts, with the levers of the displacements found latest.
    pub(crate) fn find_influences(&mut self, at: ChunkPlace, scene: &Scene, sites: &[Sites]) {
        let mut rows = std::mem::take(&mut self.coupling.rows);
        rows.start.clear();
        rows.start.push(0);
        rows.values.clear();
        self.coupling.lever_shift.clear();
        for k in 0..self.len() {
            let law = &scene.materials.law(self.now.pair[k]).multi_contact;
            for first in [true, false] {
                if first || !at.wall {
                    let grain = if first { self.i[k] } else { self.j[k] };
                    let sources = sites::of_grain(sites, grain as usize);
                    influences(law, self.target(k, at, first, scene), sources, &mut rows.values);
                }
                rows.start.push(rows.values.len() as u32);
            }
            self.coupling.lever_shift.push(self.now.coupling[k].lever_shift());
        }
        self.coupling.rows = rows;
    }

    /// Displacements by the forces of the sites, and the elastic forces that the laws answer with.
    pub(crate) fn answer(&mut self, at: ChunkPlace, scene: &Scene, sites: &[Sites]) {
        let Self {
            now, coupling, i, j, ..
        } = self;
        coupling.overlap.clear();
        coupling.worst = Worst::default();
        coupling.lever_change = 0.0;
        coupling.answer.resize(now.len(), 0.0);
        for k in 0..now.len() {
            let mut largest_radius_share = 1.0 / scene.grains.radius[i[k] as usize];
            now.coupling[k].displacement[0] = coupling.rows.displacement(k, 0, sites::of_grain(sites, i[k] as usize));
            if !at.wall {
                let other = j[k] as usize;
                now.coupling[k].displacement[1] = coupling.rows.displacement(k, 1, sites::of_grain(sites, other));
                largest_radius_share = largest_radius_share.max(1.0 / scene.grains.radius[other]);
                let change = (now.coupling[k].lever_shift() - coupling.lever_shift[k]).abs();
                coupling.lever_change = coupling.lever_change.max(change * largest_radius_share);
            }
            coupling.overlap.push(now.geometry[k].overlap + now.coupling[k].sum());
        }
        coupling.find_forces(now, scene);
        for k in 0..now.len() {
            let deviation = (coupling.answer[k] - coupling.trial[k]).abs();
            if deviation == 0.0 {
                continue;
            }
            let mut largest = sites::of_grain(sites, i[k] as usize).largest_force();
            if !at.wall {
                largest = largest.max(sites::of_grain(sites, j[k] as usize).largest_force());
            }
            // where all forces were 0 so far, nothing is known yet
            let share = deviation / largest.max(coupling.answer[k].abs());
            if share.is_nan() || share > coupling.worst.share {
                coupling.worst = Worst { share, contact: k };
            }
        }
    }

    /// Displacements by the forces of the sites, without keeping the influences.
    pub(crate) fn displace(&mut self, at: ChunkPlace, scene: &Scene, sites: &[Sites]) {
        let mut row = std::mem::take(&mut self.coupling.rows.values);
        for k in 0..self.len() {
            let law = &scene.materials.law(self.now.pair[k]).multi_contact;
            let mut found = [0.0; 2];
            for (body, found) in found.iter_mut().enumerate().take(if at.wall { 1 } else { 2 }) {
                let grain = if body == 0 { self.i[k] } else { self.j[k] };
                let sources = sites::of_grain(sites, grain as usize);
                row.clear();
                influences(law, self.target(k, at, body == 0, scene), sources, &mut row);
                *found = displacement(&row, sources.force);
            }
            self.now.coupling[k].displacement = found;
        }
        self.coupling.rows.values = row;
    }

    /// Puts the displacements into the geometry that the laws see, and watches that they stay within reason.
    pub(crate) fn deform(&mut self, at: ChunkPlace, scene: &Scene) {
        for k in 0..self.len() {
            let coupled = self.now.coupling[k];
            let contact = &mut self.now.geometry[k];
            let undisplaced = contact.overlap;
            contact.overlap += coupled.sum();
            if !at.wall {
                let shift = coupled.lever_shift();
                contact.lever_i += shift;
                contact.lever_j -= shift;
            }
            let radius = scene.smaller_radius(self.i[k], (!at.wall).then_some(self.j[k]));
            let share = contact.overlap / radius;
            if (share.is_nan() || share > LARGEST_DISPLACED * scene.max_overlap) && self.fault.is_none() {
                self.fault = Some(self.beyond_fold(k, at, scene, undisplaced));
            }
        }
    }

    /// The fault of a contact whose coupled equation has no solution; `overlap` is that of the undisplaced spheres [m].
    pub(crate) fn beyond_fold(&self, k: usize, at: ChunkPlace, scene: &Scene, overlap: f64) -> Fault {
        let (grain, other) = (self.i[k] as usize, self.j[k] as usize);
        let coupled = &self.now.coupling[k];
        let radius = scene.smaller_radius(self.i[k], (!at.wall).then_some(self.j[k]));
        let across = match at.wall {
            true => scene.grains.radius[grain],
            false => scene.grains.radius[grain] + scene.grains.radius[other],
        };
        Fault::BeyondFold {
            step: scene.step,
            id: scene.grains.id[grain],
            position: scene.grains.position[grain],
            partner: match at.wall {
                true => format!("wall {}", scene.walls[other].name),
                false => format!("grain {}", scene.grains.id[other]),
            },
            strain: overlap / across,
            displacement_share: coupled.sum() / radius,
        }
    }
}

impl Rows {
    #[inline(always)]
    fn displacement(&self, k: usize, body: usize, sources: GrainSites<'_>) -> f64 {
        let row = self.start[2 * k + body] as usize..self.start[2 * k + body + 1] as usize;
        displacement(&self.values[row], sources.force)
    }
}

impl GrainSites<'_> {
    #[inline(always)]
    fn largest_force(&self) -> f64 {
        self.force
            .iter()
            .fold(0.0, |largest, force| f64::max(largest, force.abs()))
    }
}

impl Scratch {
    /// Elastic forces at the displaced overlaps, with what the contacts remember from the step before.
    fn find_forces(&mut self, now: &Kept, scene: &Scene) {
        let mut run = 0..0;
        while run.end < now.len() {
            run = next_run(&now.pair, run.end);
            let law = scene.materials.law(now.pair[run.start]);
            law.normal.visit(Elastic {
                dt: scene.dt,
                integrator: scene.integrator,
                stride: scene.stride,
                overlap: &self.overlap[run.clone()],
                rate: &self.rate[run.clone()],
                size: &self.size[run.clone()],
                history: &now.history[run.start * scene.stride..run.end * scene.stride],
                memory: &mut self.memory,
                answer: &mut self.answer[run.clone()],
            });
        }
    }
}
