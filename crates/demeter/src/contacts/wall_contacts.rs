//! Contacts of grains and walls: which parts of a wall every grain may touch in this step.

use super::coupling::{Coupled, Scratch};
use super::look_again::LookAgain;
use super::near::Reach;
use super::near_triangles::{NearTriangles, Within};
use super::rare::begins_empty;
use super::{ContactChunk, Kept, Scene, is_set};
use crate::neighbours::WallPair;
use crate::walls::{Before, SAME_SURFACE, SurfaceContact};
use demeter_physics::contact::PairSize;
use demeter_physics::geometry::contact_sphere_sphere::Contact;
use demeter_physics::lanes;
use glam::DVec3;

/// A grain moves by no more than so many times what its speed tells in a step.
const ANY_MOTION: f64 = 2.0;

/// Room for the rounding of paths and distances.
const ROUNDING: f64 = 1.0 + 1e-9;

/// What the grains of a chunk touch.
#[derive(Clone, Debug, Default)]
pub(super) struct Touched {
    /// Parts of walls, one candidate after the other, and where those of each candidate end.
    parts: Vec<SurfaceContact>,
    ends: Vec<u32>,
    /// Contacts of the step before that acted: of one candidate.
    acted: Vec<SurfaceContact>,
    /// Contacts of the step before that were taken up: of one candidate.
    taken: Vec<usize>,
    /// Which of the contacts of the step before were engaged, a bit each.
    engaged: Vec<u64>,
    /// Candidates some of whose triangles do nothing because another wall pushes there.
    pushed: Vec<usize>,
    /// Contacts of the step before which ended so, and their grains.
    orphans: Vec<(usize, u32)>,
    near: NearParts,
    within: Within,
}

begins_empty!(Touched);

/// Parts of walls that the grains of a chunk may touch within the next steps: triangles of a mesh, faces of a box, the one part of other
/// shapes. They are looked for anew when grains and walls have moved so far that others may be touched.
#[derive(Clone, Debug, Default)]
struct NearParts {
    /// Faces and single parts, one candidate after the other, and where those of each candidate end.
    parts: Vec<u32>,
    ends: Vec<u32>,
    triangles: NearTriangles,
    /// Whether some walls are meshes, on which contacts come and go while the parts serve.
    has_meshes: bool,
}

impl NearParts {
    /// Forgets all.
    fn forget(&mut self) {
        self.ends.clear();
    }

    /// Looks for parts so far beyond touching [m].
    fn renew(&mut self, pairs: &[WallPair], reach: f64, scene: &Scene, within: &mut Within) {
        self.parts.clear();
        self.ends.clear();
        self.triangles.clear();
        self.has_meshes = false;
        for (c, pair) in pairs.iter().enumerate() {
            let (g, wall) = (pair.grain as usize, &scene.walls[pair.wall as usize]);
            let reach = (scene.grains.radius(g) + reach) * ROUNDING;
            let centre = scene.grains.position[g];
            if wall.mesh().is_some() {
                (self.triangles).extend(c, pair, |triangles| wall.parts_near(centre, reach, triangles));
                self.has_meshes = true;
            } else {
                wall.parts_near(centre, reach, &mut self.parts);
            }
            self.ends.push(self.parts.len() as u32);
        }
        if self.has_meshes {
            self.triangles.find((reach, ROUNDING), scene, within);
            self.triangles.keep(within, pairs);
        }
    }

    /// Faces and single parts of a candidate.
    fn of(&self, candidate: usize) -> &[u32] {
        let first = candidate.checked_sub(1).map_or(0, |before| self.ends[before] as usize);
        &self.parts[first..self.ends[candidate] as usize]
    }
}

impl Touched {
    fn clear(&mut self) {
        self.parts.clear();
        self.ends.clear();
    }

    /// Looks at all candidates: at triangles within the window of a step, at other parts where they come into a new table. Those of an
    /// older one stay as they were in the step before.
    fn look(&mut self, pairs: &[WallPair], reach: Reach, (contacts, engaged): (&Kept, &[u64]), scene: &Scene) {
        self.clear();
        let mut pushed = std::mem::take(&mut self.pushed);
        pushed.clear();
        if self.near.has_meshes {
            self.near.triangles.find((reach.window, 1.0), scene, &mut self.within);
        }
        for (c, pair) in pairs.iter().enumerate() {
            let (g, wall) = (pair.grain as usize, &scene.walls[pair.wall as usize]);
            if wall.mesh().is_some() {
                let points = self.within.next_of(c);
                if !points.is_empty() {
                    let first = self.parts.len();
                    let (centre, radius) = (scene.grains.position[g], scene.grains.radius(g));
                    let acted = contacts.range(c).filter(|&k| is_set(engaged, k));
                    self.acted.clear();
                    self.acted.extend(acted.map(|k| contacts.at_wall(k)));
                    let before = Before {
                        contacts: &self.acted,
                        was_overlapped: &|part| scene.was_overlapped(pair, part),
                    };
                    wall.contacts_of(points, (centre, radius), &before, &mut self.parts);
                    self.retain_from(first, |part| {
                        let is_pushed = scene.is_pushed_by_another(g, pair.wall as usize, part);
                        pushed.extend(is_pushed.then_some(c));
                        !is_pushed
                    });
                }
            } else if reach.is_new {
                let parts = self.near.of(c).iter();
                let contacts = parts.filter_map(|&part| scene.contact_with(g, (pair.wall, part), reach.window));
                self.parts.extend(contacts);
            } else {
                self.parts.extend(contacts.range(c).map(|k| contacts.at_wall(k)));
            }
            self.ends.push(self.parts.len() as u32);
        }
        self.pushed = pushed;
    }

    /// Looks at all candidates, whose material pair is `law`, for what is touched where contacts feel each other.
    fn look_for_coupled(&mut self, pairs: &[WallPair], law: u32, scene: &Scene) {
        self.clear();
        let window = scene.widest_window();
        for pair in pairs {
            let (g, wall) = (pair.grain as usize, &scene.walls[pair.wall as usize]);
            let (centre, radius) = (scene.grains.position[g], scene.grains.radius(g));
            let bulge = scene.bulge(g);
            let first = self.parts.len();
            // where surfaces bulge, walls are asked as a whole
            wall.contacts(centre, (radius + bulge, window), &mut self.parts);
            self.retain_from(first, |part| {
                let overlap = radius - part.distance + bulge;
                scene.acts(law, || scene.size_at_wall(g), overlap, scene.rate_at_wall(pair, part))
                    && !scene.is_pushed_by_another(g, pair.wall as usize, part)
            });
            self.ends.push(self.parts.len() as u32);
        }
    }

    /// Keeps of the parts from one on those that are wanted.
    fn retain_from(&mut self, first: usize, mut is_wanted: impl FnMut(&SurfaceContact) -> bool) {
        let mut kept = first;
        for k in first..self.parts.len() {
            if is_wanted(&self.parts[k]) {
                self.parts[kept] = self.parts[k];
                kept += 1;
            }
        }
        self.parts.truncate(kept);
    }

    /// Forgets what was near.
    pub(super) fn forget(&mut self) {
        self.near.forget();
    }

    /// Parts that a candidate touches.
    fn of(&self, candidate: usize) -> &[SurfaceContact] {
        let first = candidate.checked_sub(1).map_or(0, |before| self.ends[before] as usize);
        &self.parts[first..self.ends[candidate] as usize]
    }

    /// All parts, each with the candidate that touches it.
    fn each<'a>(&'a self, pairs: &'a [WallPair]) -> impl Iterator<Item = (&'a WallPair, &'a SurfaceContact)> + Clone {
        let candidates = pairs.iter().enumerate();
        candidates.flat_map(|(c, pair)| self.of(c).iter().map(move |part| (pair, part)))
    }

    /// Whether these are the contacts of the step before.
    fn are(&self, contacts: &Kept) -> bool {
        contacts.start.get(1..) == Some(&self.ends)
            && (self.parts.iter().map(|part| part.element)).eq(contacts.element.iter().copied())
    }
}

impl Scene<'_> {
    pub(super) fn size_at_wall(&self, grain: usize) -> PairSize {
        // no grain that meets a wall is fixed
        PairSize::new(self.grains.radius(grain), 1.0 / self.grains.inverse_mass(grain))
    }

    /// How a grain meets an element of a wall that is no mesh, as [`Wall::contact_with`](crate::walls::Wall::contact_with) tells it: as far
    /// away as to do nothing where another wall pushes it.
    #[inline]
    pub(super) fn contact_with(
        &self,
        grain: usize,
        (wall, element): (u32, u32),
        window: f64,
    ) -> Option<SurfaceContact> {
        let (wall, reach) = (wall as usize, self.grains.radius(grain) + window);
        let mut part = self.walls[wall].contact_with(element, self.grains.position[grain], reach)?;
        if self.is_pushed_by_another(grain, wall, &part) {
            part.distance = 2.0 * reach;
        }
        Some(part)
    }

    /// Rate at which a grain approaches a part of a wall [m/s].
    fn rate_at_wall(&self, pair: &WallPair, part: &SurfaceContact) -> f64 {
        let (g, wall) = (pair.grain as usize, &self.walls[pair.wall as usize]);
        let of_wall = wall.velocity_at(self.grains.position[g] - part.normal * part.distance);
        (of_wall - self.grains.velocity[g]).dot(part.normal)
    }
}

impl Scene<'_> {
    /// Whether a grain overlapped with a part of a wall in the step before.
    pub(super) fn was_overlapped(&self, pair: &WallPair, part: &SurfaceContact) -> bool {
        let moved = self.rate_at_wall(pair, part).abs() * self.dt;
        self.grains.radius(pair.grain as usize) - part.distance > ANY_MOTION * moved
    }
}

pub(super) fn geometry(part: &SurfaceContact, radius: f64) -> Contact {
    Contact {
        normal: part.normal,
        overlap: radius - part.distance,
        lever_i: part.distance,
        lever_j: 0.0,
    }
}

impl ContactChunk {
    /// Finds how the grains of a chunk meet the parts of walls in the table, which reaches as told.
    pub(crate) fn meet_walls(&mut self, (pairs, law): (&[WallPair], u32), reach: Reach, scene: &Scene) {
        self.begin(scene.walls.len(), law);
        let mut touched = std::mem::take(&mut self.touched);
        if reach.is_new || touched.near.ends.len() != pairs.len() {
            let Touched { near, within, .. } = &mut *touched;
            near.renew(pairs, reach.distance, scene, within);
        }
        let has_meshes = touched.near.has_meshes;
        if reach.is_new || has_meshes {
            touched.look(pairs, reach, (&self.now, &self.engaged), scene);
            self.touch(pairs, &mut touched, scene);
        }
        if !reach.is_new {
            let look = LookAgain {
                scene,
                window: reach.window,
                beside_meshes: has_meshes,
                i: &self.i,
                j: &self.j,
                element: &self.now.element,
                contacts: &mut self.now.geometry,
            };
            lanes::run(scene.instructions, look);
        }
        if scene.walls.len() > 1 {
            self.join_at_seams(reach.window, scene);
        }
        self.hand_over_at_seams(&mut touched.orphans, scene);
        self.touched = touched;
    }

    /// Finds the contacts of a chunk of pairs of grain and wall that feel each other.
    pub(crate) fn find_walls(&mut self, (pairs, law): (&[WallPair], u32), scene: &Scene) {
        self.begin(scene.walls.len(), law);
        let mut touched = std::mem::take(&mut self.touched);
        touched.look_for_coupled(pairs, law, scene);
        self.is_renewed = !touched.are(&self.now);
        self.touch(pairs, &mut touched, scene);
        let of_contacts = touched.each(pairs);
        let rates = of_contacts.clone().map(|(pair, part)| scene.rate_at_wall(pair, part));
        let Scratch { rate, size, .. } = &mut *self.coupling;
        rate.clear();
        rate.extend(rates);
        size.clear();
        size.extend(of_contacts.map(|(pair, _)| scene.size_at_wall(pair.grain as usize)));
        self.now.coupling.resize(self.len(), Coupled::default());
        self.touched = touched;
        for k in 0..self.len() {
            let (overlap, radius) = (self.now.geometry[k].overlap, scene.grains.radius(self.i[k] as usize));
            let is_allowed = overlap <= scene.max_overlap * radius;
            if !is_allowed {
                self.note_overlap_at_wall(k, overlap, scene);
            }
        }
    }

    /// Has the contacts be those that were found.
    fn touch(&mut self, pairs: &[WallPair], touched: &mut Touched, scene: &Scene) {
        if !touched.are(&self.now) {
            return self.renew_walls(pairs, touched, scene);
        }
        for ((contact, part), &g) in self.now.geometry.iter_mut().zip(&touched.parts).zip(&self.i) {
            *contact = geometry(part, scene.grains.radius(g as usize));
        }
    }

    /// Takes over what the contacts of the step before remember, where not all of them are still the same.
    fn renew_walls(&mut self, pairs: &[WallPair], touched: &mut Touched, scene: &Scene) {
        std::mem::swap(&mut self.now, &mut *self.before);
        self.now.clear();
        let engaged = std::mem::replace(&mut self.engaged, std::mem::take(&mut touched.engaged));
        self.engaged.clear();
        self.goes_on.clear();
        self.goes_on.resize(self.before.len(), false);
        self.i.clear();
        self.j.clear();
        let mut taken = std::mem::take(&mut touched.taken);
        for (c, pair) in pairs.iter().enumerate() {
            let (g, parts) = (pair.grain as usize, touched.of(c));
            taken.clear();
            for (k, part) in parts.iter().enumerate() {
                let old = self
                    .before
                    .heir(c, parts, k, |old| is_set(&engaged, old) && !taken.contains(&old));
                taken.extend(old);
                let contact = geometry(part, scene.grains.radius(g));
                self.push(scene.stride, (pair.grain, pair.wall, part.element), contact, old);
                if scene.is_coupled() {
                    let remembered = old.and_then(|old| self.before.coupling.get(old));
                    self.now.coupling.push(remembered.copied().unwrap_or_default());
                } else {
                    // so that one that does not act any more is ended
                    self.note_engaged(old.is_some_and(|old| is_set(&engaged, old)));
                }
            }
            self.now.start.push(self.now.len() as u32);
        }
        if scene.records_walls {
            self.mark_ends(pairs, scene);
        }
        for (c, pair) in pairs.iter().enumerate() {
            for k in self.before.range(c) {
                if self.goes_on[k] {
                    continue;
                }
                if !scene.is_coupled() && is_set(&engaged, k) && touched.pushed.contains(&c) {
                    touched.orphans.push((k, pair.grain));
                } else {
                    self.book_end(k, scene);
                }
            }
        }
        (touched.taken, touched.engaged) = (taken, engaged);
    }

    fn push(&mut self, stride: usize, (i, j, element): (u32, u32, u32), contact: Contact, old: Option<usize>) {
        self.i.push(i);
        self.j.push(j);
        self.now.element.push(element);
        self.now.geometry.push(contact);
        match old {
            Some(k) => {
                self.now.push_force(f64::from(self.before.normal_force[k]), DVec3::ZERO);
                self.now
                    .history
                    .extend_from_slice(&self.before.history[k * stride..(k + 1) * stride]);
                self.goes_on[k] = true;
            }
            None => {
                self.now.push_force(0.0, DVec3::ZERO);
                self.now.history.resize(self.now.history.len() + stride, 0.0);
            }
        }
    }
}

impl Kept {
    /// The part of a wall in a contact.
    pub(super) fn at_wall(&self, contact: usize) -> SurfaceContact {
        let geometry = &self.geometry[contact];
        SurfaceContact {
            normal: geometry.normal,
            distance: geometry.lever_i,
            element: self.element[contact],
            // asked anew in every look
            is_at_edge: false,
        }
    }

    /// The contact of the step before that contact `k` of a grain and a wall continues: the same element, else (a grain
    /// that rolled from one triangle onto the next) the one with the closest normal of those that are free for it.
    fn heir(
        &self,
        candidate: usize,
        touched: &[SurfaceContact],
        k: usize,
        is_free: impl Fn(usize) -> bool,
    ) -> Option<usize> {
        let old = self.range(candidate);
        if let Some(same) = old.clone().find(|&o| self.element[o] == touched[k].element) {
            return Some(same);
        }
        old.filter(|&o| is_free(o) && touched.iter().all(|s| s.element != self.element[o]))
            .map(|o| (self.geometry[o].normal.dot(touched[k].normal), o))
            .filter(|(cosine, _)| *cosine > SAME_SURFACE)
            .max_by(|a, b| a.0.total_cmp(&b.0).then(b.1.cmp(&a.1)))
            .map(|(_, o)| o)
    }
}
