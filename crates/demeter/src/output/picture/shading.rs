//! Light: a lamp from above with shadows, light from all sides that neighbours hold back, and a soft highlight.

use super::spheres::{Seen, Sight, Sphere, meet};
use super::together::Drawn;
use glam::DVec3;
use rayon::prelude::*;
use std::collections::BTreeMap;

/// Share of the light that comes from all sides, and from the lamp.
const AMBIENT: f64 = 0.68;
const LAMP: f64 = 0.62;
const HIGHLIGHT: f64 = 0.07;
/// What is left of the lamp in a shadow: a hard shadow would hide the colour.
const IN_SHADOW: f64 = 0.45;
/// How bright a section is beside the surface of its grain.
const SECTION: f64 = 0.65;
/// Neighbours that hold light back, at most; those that matter most are kept.
const MOST_NEIGHBOURS: usize = 20;

/// A linear colour, 1 is white.
pub(super) type Rgb = [f32; 3];

/// What is needed to light a pixel.
pub(super) struct Lighting<'a> {
    spheres: &'a [Sphere],
    sight: Sight<'a>,
    /// Towards the lamp, and up, in the frame of the camera.
    lamp: DVec3,
    up: DVec3,
    /// Neighbours of every sphere that is seen.
    neighbours: Neighbours,
}

impl<'a> Lighting<'a> {
    /// Prepares the light for what is seen.
    pub fn new(drawn: &'a Drawn, sight: Sight<'a>) -> Self {
        let up = sight.camera.turn(DVec3::Z);
        let lamp = (1.1 * up + DVec3::new(-0.4, 0.0, -0.85)).normalize();
        Self {
            spheres: &drawn.spheres,
            sight,
            lamp,
            up,
            neighbours: Neighbours::new(drawn, sight),
        }
    }

    /// Colours all pixels; `albedo` is the colour of every sphere.
    pub fn shade(&self, seen: &[Seen], width: usize, albedo: &[Rgb], background: Rgb) -> Vec<Rgb> {
        let mut colours = vec![background; seen.len()];
        let rows = colours.par_chunks_mut(width).zip(seen.par_chunks(width)).enumerate();
        rows.for_each(|(y, (colours, seen))| {
            for (x, (colour, pixel)) in colours.iter_mut().zip(seen).enumerate() {
                if pixel.is_covered() {
                    *colour = self.pixel(x, y, pixel.sphere as usize, albedo[pixel.sphere as usize]);
                }
            }
        });
        colours
    }

    fn pixel(&self, x: usize, y: usize, index: usize, albedo: Rgb) -> Rgb {
        let sphere = &self.spheres[index];
        let ray = self.sight.camera.ray(x, y);
        let Some(entry) = meet(sphere, self.sight, ray) else {
            return albedo;
        };
        let point = entry.at * ray;
        let normal = entry.section.unwrap_or((point - sphere.centre) / sphere.radius);
        let (open, lit, share) = match entry.section {
            // nothing is left beyond the plane that could hold light back
            Some(_) => (1.0, 1.0, SECTION),
            None => {
                let (open, lit) = self.light_at(point, normal, index);
                (open, lit, 1.0)
            }
        };
        let sky = 0.5 + 0.5 * normal.dot(self.up);
        let ambient = AMBIENT * open * (0.7 + 0.3 * sky);
        let lamp = normal.dot(self.lamp).max(0.0) * lit;
        let view = -ray.normalize();
        let half = (self.lamp + view).normalize();
        let glance = normal.dot(half).max(0.0);
        let glance2 = glance * glance;
        let glance8 = glance2 * glance2 * glance2 * glance2;
        let highlight = HIGHLIGHT * lit * glance8 * glance8 * glance8;
        let diffuse = ambient + LAMP * lamp;
        albedo.map(|c| (share * f64::from(c) * diffuse + highlight).min(1.0) as f32)
    }

    /// How open the sky is at a point, and how much of the lamp reaches it, with respect to the neighbours.
    ///
    /// A sphere of radius r at a distance d covers the share `cos(angle) (r/d)^2` of the light from all sides.
    fn light_at(&self, point: DVec3, normal: DVec3, index: usize) -> (f64, f64) {
        let (mut open, mut lit) = (1.0, 1.0_f64);
        for &neighbour in self.neighbours.of(index) {
            let other = &self.spheres[neighbour as usize];
            let towards = other.centre - point;
            let squared = towards.length_squared().max(other.radius * other.radius);
            let distance = squared.sqrt();
            let cosine = normal.dot(towards) / distance;
            let cover = other.radius * other.radius / squared;
            open *= 1.0 - (0.5 * cosine + 0.25).clamp(0.0, 0.72) * cover;
            lit = lit.min(self.reaches(towards, other.radius));
        }
        (open, IN_SHADOW + (1.0 - IN_SHADOW) * lit)
    }

    /// How much of the lamp, which is a disc, passes a sphere: 1 past its soft rim, 0 inside it.
    fn reaches(&self, towards: DVec3, radius: f64) -> f64 {
        let along = towards.dot(self.lamp);
        if along <= 0.0 {
            return 1.0;
        }
        let miss = (towards.length_squared() - along * along).max(0.0).sqrt();
        let rim = 0.08 * radius + 0.10 * along;
        let share = ((miss - radius + rim) / (2.0 * rim)).clamp(0.0, 1.0);
        share * share * (3.0 - 2.0 * share)
    }
}

/// The spheres around every sphere that is seen, in one list.
struct Neighbours {
    start: Vec<u32>,
    list: Vec<u32>,
}

impl Neighbours {
    fn of(&self, sphere: usize) -> &[u32] {
        &self.list[self.start[sphere] as usize..self.start[sphere + 1] as usize]
    }

    fn new(drawn: &Drawn, sight: Sight) -> Self {
        let spheres = &drawn.spheres;
        let mut is_seen = vec![false; spheres.len()];
        for pixel in drawn.seen.iter().filter(|pixel| pixel.is_covered()) {
            is_seen[pixel.sphere as usize] = true;
        }
        let grid = Grid::new(spheres, |s| holds_light_back(s, sight));
        let lists: Vec<Vec<u32>> = (0..spheres.len())
            .into_par_iter()
            .map(|index| if is_seen[index] { grid.around(index) } else { Vec::new() })
            .collect();
        let mut neighbours = Self {
            start: vec![0],
            list: Vec::new(),
        };
        for list in lists {
            neighbours.list.extend(list);
            // A list has at most MOST_NEIGHBOURS entries, and there are less than 2^27 spheres in a picture.
            neighbours.start.push(neighbours.list.len() as u32);
        }
        neighbours
    }
}

/// Whether a sphere holds light back at all: what is cut away does not.
fn holds_light_back(s: &Sphere, sight: Sight) -> bool {
    s.centre.is_finite() && sight.planes.keep(s.centre)
}

/// A sphere so many times smaller than another holds back nothing of its light that would show.
const SPECK: f64 = 16.0;

/// Distance of a sphere that holds light back from another, where it does.
fn reaches(s: &Sphere, me: &Sphere) -> Option<f64> {
    let distance = s.centre.distance(me.centre);
    (distance < me.radius + 3.0 * s.radius && me.radius <= SPECK * s.radius).then_some(distance)
}

/// Spheres of about one size, sorted by the cell that their centre is in.
struct Class {
    /// Radius of the largest.
    largest: f64,
    /// Cell and index of a sphere, sorted.
    entries: Vec<([i64; 3], u32)>,
}

impl Class {
    fn cell_of(&self, p: DVec3) -> [i64; 3] {
        // The conversion saturates, which only puts far spheres into one cell.
        [p.x, p.y, p.z].map(|x| (x / (4.0 * self.largest)).floor() as i64)
    }

    /// Whether any sphere whose centre may lie within a distance of a place is asked for.
    fn any_within(&self, place: DVec3, distance: f64, mut is_asked_for: impl FnMut(u32) -> bool) -> bool {
        let [lower, upper] = [-distance, distance].map(|d| self.cell_of(place + DVec3::splat(d)));
        let across = |axis: usize| (upper[axis].saturating_sub(lower[axis]) as f64) + 1.0;
        if across(0) * across(1) > self.entries.len() as f64 {
            return self.entries.iter().any(|&(_, sphere)| is_asked_for(sphere));
        }
        (lower[0]..=upper[0]).any(|i| {
            (lower[1]..=upper[1]).any(|j| {
                let from = self.entries.partition_point(|e| e.0 < [i, j, lower[2]]);
                let row = self.entries[from..].iter();
                row.take_while(|e| e.0 <= [i, j, upper[2]])
                    .any(|&(_, sphere)| is_asked_for(sphere))
            })
        })
    }
}

/// Spheres by where they are, those of each size for themselves.
pub(super) struct Grid<'a> {
    spheres: &'a [Sphere],
    classes: Vec<Class>,
}

impl<'a> Grid<'a> {
    /// Those spheres that are wanted.
    pub fn new(spheres: &'a [Sphere], is_wanted: impl Fn(&Sphere) -> bool) -> Self {
        // radii that have the same exponent are within twice each other
        let mut of_size: BTreeMap<u64, Vec<u32>> = BTreeMap::new();
        for (index, sphere) in (0..).zip(spheres) {
            if is_wanted(sphere) && sphere.radius.is_finite() && sphere.radius > 0.0 {
                of_size.entry(sphere.radius.to_bits() >> 52).or_default().push(index);
            }
        }
        let class = |indices: Vec<u32>| {
            let sphere = |index: u32| &spheres[index as usize];
            let radii = indices.iter().map(|&index| sphere(index).radius);
            let mut class = Class {
                largest: radii.fold(0.0, f64::max),
                entries: Vec::new(),
            };
            let place = |index| (class.cell_of(sphere(index).centre), index);
            class.entries = indices.into_iter().map(place).collect();
            class.entries.sort_unstable();
            class
        };
        Self {
            spheres,
            classes: of_size.into_values().map(class).collect(),
        }
    }

    /// Whether a sphere holds light back from any.
    pub fn is_darkened_by(&self, sphere: &Sphere, sight: Sight) -> bool {
        holds_light_back(sphere, sight)
            && self.classes.iter().any(|class| {
                class.any_within(sphere.centre, class.largest + 3.0 * sphere.radius, |me| {
                    reaches(sphere, &self.spheres[me as usize]).is_some()
                })
            })
    }

    /// The spheres that hold most light back from a sphere, by what they cover as seen from its surface.
    fn around(&self, index: usize) -> Vec<u32> {
        let me = &self.spheres[index];
        let mut found: Vec<(f64, u32)> = Vec::new();
        for class in self.classes.iter().filter(|class| me.radius <= SPECK * class.largest) {
            class.any_within(me.centre, me.radius + 3.0 * class.largest, |other| {
                let s = &self.spheres[other as usize];
                if let Some(distance) = reaches(s, me).filter(|_| other as usize != index) {
                    let gap = (distance - me.radius).max(0.5 * s.radius);
                    found.push((s.radius * s.radius / (gap * gap), other));
                }
                false
            });
        }
        found.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
        found.truncate(MOST_NEIGHBOURS);
        found.into_iter().map(|(_, other)| other).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::Rng;

    #[test]
    fn those_that_hold_light_back_are_found_among_all_sizes() {
        let mut random = rand_pcg::Pcg64::new(3, 5);
        let mut share = || (random.next_u64() >> 11) as f64 / (1u64 << 53) as f64;
        let mut spheres: Vec<Sphere> = (0..600)
            .map(|_| Sphere {
                centre: DVec3::new(share(), share(), share()) * 4.0,
                // from 1 down to 1/128
                radius: libm::exp2(-7.0 * share()),
            })
            .collect();
        spheres[17].radius = f64::NAN;
        let grid = Grid::new(&spheres, |s| s.centre.x < 3.5);
        let mut counts = Vec::new();
        for (index, me) in spheres.iter().enumerate() {
            let others = (0u32..).zip(&spheres);
            let mut expected: Vec<(f64, u32)> = others
                .filter(|(other, s)| *other as usize != index && s.centre.x < 3.5)
                .filter_map(|(other, s)| {
                    let gap = (reaches(s, me)? - me.radius).max(0.5 * s.radius);
                    Some((s.radius * s.radius / (gap * gap), other))
                })
                .collect();
            expected.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
            counts.push(expected.len());
            expected.truncate(MOST_NEIGHBOURS);
            let expected: Vec<u32> = expected.into_iter().map(|(_, other)| other).collect();
            assert_eq!(grid.around(index), expected, "of sphere {index}");
        }
        // some have few and some more than are kept
        counts.sort_unstable();
        assert!(
            counts[50] < MOST_NEIGHBOURS && counts[500] > MOST_NEIGHBOURS,
            "{counts:?}"
        );
    }
}
