//! Contacts of grains and walls: which parts of a wall every grain touches in this step.

use super::kinematics::Surfaces;
use super::{ContactChunk, Kept, Scene};
use crate::neighbours::WallPair;
use crate::walls::SurfaceContact;
use demeter_physics::contact::PairSize;
use demeter_physics::geometry::contact_sphere_sphere::Contact;
use glam::DVec3;

/// What the grains of a chunk touch.
#[derive(Clone, Debug, Default)]
pub(super) struct Touched {
    /// Parts of walls, one candidate after the other, and where those of each candidate end.
    parts: Vec<SurfaceContact>,
    ends: Vec<u32>,
    /// Contacts of the step before that were taken up: of one candidate.
    taken: Vec<usize>,
    near: NearParts,
}

/// Parts of walls that the grains of a chunk may touch within the next steps: triangles of a mesh, faces of a box, the one part of other
/// shapes. They are looked for anew when grains and walls have moved so far that others may be touched.
#[derive(Clone, Debug, Default)]
struct NearParts {
    /// Parts, one candidate after the other, and where those of each candidate end.
    parts: Vec<u32>,
    ends: Vec<u32>,
    /// The path of the run, with the widest window of a step, up to which they serve [m].
    serves: f64,
}

/// The parts shall serve until the fastest body has gone as far as in so many steps.
const STEPS: f64 = 32.0;

impl NearParts {
    /// Forgets all.
    fn forget(&mut self) {
        self.ends.clear();
    }

    /// Looks for parts anew where these do not serve any more.
    fn renew(&mut self, pairs: &[WallPair], scene: &Scene, window: f64) {
        // what is not a number serves no more
        if self.ends.len() == pairs.len() && scene.path + window <= self.serves {
            return;
        }
        let room = window + STEPS * scene.max_speed * scene.dt;
        self.parts.clear();
        self.ends.clear();
        self.serves = scene.path + room;
        for pair in pairs {
            let (g, wall) = (pair.grain as usize, &scene.walls[pair.wall as usize]);
            // room for the rounding of paths and distances
            let reach = (scene.grains.radius(g) + room) * (1.0 + 1e-9);
            wall.parts_near(scene.grains.position[g], reach, &mut self.parts);
            self.ends.push(self.parts.len() as u32);
        }
    }

    /// Those of a candidate.
    fn of(&self, candidate: usize) -> &[u32] {
        let first = candidate.checked_sub(1).map_or(0, |before| self.ends[before] as usize);
        &self.parts[first..self.ends[candidate] as usize]
    }
}

impl Touched {
    /// Looks at all candidates, whose material pair is `law`, and notes how the walls move where they are touched.
    fn look(&mut self, pairs: &[WallPair], law: u32, surfaces: &mut Surfaces, scene: &Scene) {
        self.parts.clear();
        self.ends.clear();
        surfaces.clear();
        let window = scene.widest_window();
        // where surfaces bulge, or the path of a step is not told, they are asked as a whole
        let lists = !scene.is_coupled() && scene.path.is_finite();
        if lists {
            self.near.renew(pairs, scene, window);
        }
        for (c, pair) in pairs.iter().enumerate() {
            if lists && self.near.of(c).is_empty() {
                self.ends.push(self.parts.len() as u32);
                continue;
            }
            let (g, wall) = (pair.grain as usize, &scene.walls[pair.wall as usize]);
            let (centre, radius) = (scene.grains.position[g], scene.grains.radius(g));
            let bulge = scene.bulge(g);
            let first = self.parts.len();
            let reach = radius + window + bulge;
            if lists {
                wall.contacts_among(self.near.of(c), centre, reach, &mut self.parts);
            } else {
                wall.contacts(centre, reach, &mut self.parts);
            }
            let mut kept = first;
            for k in first..self.parts.len() {
                let part = self.parts[k];
                let foot = centre - part.normal * part.distance;
                let velocity = wall.velocity_at(foot);
                let rate = (velocity - scene.grains.velocity[g]).dot(part.normal);
                if scene.acts(law, || scene.size_at_wall(g), radius - part.distance + bulge, rate) {
                    self.parts[kept] = part;
                    kept += 1;
                    surfaces.push(wall, scene.walls, (foot, velocity), part.normal);
                }
            }
            self.parts.truncate(kept);
            self.ends.push(kept as u32);
        }
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

    /// Whether these are the contacts of the step before.
    fn are(&self, contacts: &Kept) -> bool {
        contacts.start.get(1..) == Some(&self.ends)
            && (self.parts.iter().map(|part| part.element)).eq(contacts.element.iter().copied())
    }
}

impl Scene<'_> {
    fn size_at_wall(&self, grain: usize) -> PairSize {
        PairSize {
            radius: self.grains.radius(grain),
            mass: self.grains.mass[grain],
        }
    }
}

fn geometry(part: &SurfaceContact, radius: f64) -> Contact {
    Contact {
        normal: part.normal,
        overlap: radius - part.distance,
        lever_i: part.distance,
        lever_j: 0.0,
    }
}

impl ContactChunk {
    /// Finds the contacts of a chunk of pairs of grain and wall.
    pub(crate) fn find_walls(&mut self, (pairs, law): (&[WallPair], u32), scene: &Scene) {
        self.begin(scene.walls.len(), law);
        let mut touched = std::mem::take(&mut self.touched);
        touched.look(pairs, law, &mut self.surfaces, scene);
        if touched.are(&self.now) && !scene.is_coupled() {
            for ((contact, part), &g) in self.now.geometry.iter_mut().zip(&touched.parts).zip(&self.i) {
                *contact = geometry(part, scene.grains.radius(g as usize));
            }
        } else {
            self.renew_walls(pairs, &mut touched, scene);
        }
        self.touched = touched;
        for k in 0..self.len() {
            let (g, wall) = (self.i[k] as usize, self.j[k] as usize);
            let (overlap, radius) = (self.now.geometry[k].overlap, scene.grains.radius(g));
            let is_allowed = overlap <= scene.max_overlap * radius;
            if !is_allowed {
                self.watch_overlap(scene, g, overlap / radius, || {
                    format!("wall {}", scene.walls[wall].name)
                });
            }
        }
    }

    /// Takes over what the contacts of the step before remember, where not all of them are still the same.
    fn renew_walls(&mut self, pairs: &[WallPair], touched: &mut Touched, scene: &Scene) {
        std::mem::swap(&mut self.now, &mut self.before);
        self.now.clear();
        self.goes_on.clear();
        self.goes_on.resize(self.before.len(), false);
        self.i.clear();
        self.j.clear();
        let mut taken = std::mem::take(&mut touched.taken);
        for (c, pair) in pairs.iter().enumerate() {
            let (g, parts) = (pair.grain as usize, touched.of(c));
            taken.clear();
            for (k, part) in parts.iter().enumerate() {
                let old = self.before.heir(c, parts, k, &taken);
                taken.extend(old);
                let contact = geometry(part, scene.grains.radius(g));
                self.push(scene.stride, (pair.grain, pair.wall, part.element), contact, old);
                if scene.is_coupled() {
                    let of_wall = self.surfaces.velocity(self.len() - 1);
                    let rate = (of_wall - scene.grains.velocity[g]).dot(part.normal);
                    self.coupling.push(rate, scene.size_at_wall(g), old);
                }
            }
            self.now.start.push(self.now.len() as u32);
        }
        touched.taken = taken;
        if scene.records_walls {
            self.mark_ends(pairs, scene);
        }
        for k in 0..self.before.len() {
            if !self.goes_on[k] {
                self.book_end(k, scene);
            }
        }
    }

    fn push(&mut self, stride: usize, (i, j, element): (u32, u32, u32), contact: Contact, old: Option<usize>) {
        self.i.push(i);
        self.j.push(j);
        self.now.element.push(element);
        self.now.geometry.push(contact);
        match old {
            Some(k) => {
                self.now.push_force(self.before.normal_force[k], DVec3::ZERO);
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

/// Cosine of the largest turn of the normal at which a history passes from one wall element to another.
const SAME_SURFACE: f64 = 0.5;

impl Kept {
    /// The contact of the step before that contact `k` of a grain and a wall continues: the same element, else (a grain
    /// that rolled from one triangle onto the next) the one with the closest normal that no other continues.
    fn heir(&self, candidate: usize, touched: &[SurfaceContact], k: usize, taken: &[usize]) -> Option<usize> {
        let old = self.range(candidate);
        if let Some(same) = old.clone().find(|&o| self.element[o] == touched[k].element) {
            return Some(same);
        }
        old.filter(|o| !taken.contains(o) && touched.iter().all(|s| s.element != self.element[*o]))
            .map(|o| (self.geometry[o].normal.dot(touched[k].normal), o))
            .filter(|(cosine, _)| *cosine > SAME_SURFACE)
            .max_by(|a, b| a.0.total_cmp(&b.0).then(b.1.cmp(&a.1)))
            .map(|(_, o)| o)
    }
}
