//! Force chains: a cylinder for every contact, from centre to centre, or to the point where a wall is touched.

use super::colouring::{Bar, map};
use super::image::to_linear;
use super::shading::Rgb;
use crate::output::frame::Frame;
use crate::output::ticks::{round_up, si_prefix};
use crate::particles::ById;
use glam::DVec3;

/// Thickness of the strongest contact, as a share of the mean radius of grains.
const THICKEST: f64 = 0.45;
/// Forces weaker than this share of the strongest that is shown are not drawn.
const WEAKEST: f64 = 0.01;
/// A cylinder is a row of balls, so far apart in their radii that none is seen alone.
const STRIDE: f64 = 0.15;
/// Most balls of one cylinder.
const MOST: usize = 400;
/// Share of the contacts whose force the colour bar covers.
const COVERED: f64 = 0.98;

/// Force chains, ready to be drawn as spheres.
pub(super) struct Chains {
    /// Centres and radii [m].
    pub beads: Vec<(DVec3, f64)>,
    pub albedo: Vec<Rgb>,
    pub label: String,
    pub bar: Bar,
    /// Force at the end of the bar [N].
    pub end: f64,
}

impl Chains {
    /// The chains of a frame; the bar ends at `end` [N], or where most forces do.
    pub fn new(frame: &Frame, end: Option<f64>) -> Self {
        let forces: Vec<f64> = frame.contacts.all().map(|c| c.repulsion().abs()).collect();
        let mut sorted: Vec<f64> = forces.iter().copied().filter(|f| f.is_finite()).collect();
        sorted.sort_by(f64::total_cmp);
        let largest = sorted.last().copied().unwrap_or(0.0);
        let covered = sorted
            .get((COVERED * sorted.len() as f64) as usize)
            .copied()
            .unwrap_or(largest);
        let end = end.filter(|end| *end > 0.0);
        let end = end.unwrap_or_else(|| {
            if covered > f64::MIN_POSITIVE {
                round_up(covered)
            } else {
                1.0
            }
        });
        let (prefix, factor) = si_prefix(end);
        let mut chains = Self {
            beads: Vec::new(),
            albedo: Vec::new(),
            label: format!("normal force [{prefix}N]"),
            bar: Bar {
                low: 0.0,
                high: end / factor,
                saturated: largest > end,
            },
            end,
        };
        chains.add_contacts(frame, &forces);
        chains
    }

    fn add_contacts(&mut self, frame: &Frame, forces: &[f64]) {
        let grains = frame.grains;
        let mean = grains.radii().sum::<f64>() / grains.len().max(1) as f64;
        let by_id = ById::new(&grains.id);
        let place = |id: u32| {
            let index = by_id.find(id)?;
            Some((grains.position[index], grains.radius(index)))
        };
        for (contact, force) in frame.contacts.all().zip(forces) {
            let share = (force / self.end).min(1.0);
            let Some((from, radius)) = place(contact.id_i()) else {
                continue;
            };
            if share.is_nan() || share < WEAKEST {
                continue;
            }
            // across a periodic side the partner is elsewhere: both halves are drawn from their own grain
            let reach = if contact.wall() >= 0 { 0.0 } else { radius };
            let other = if contact.wall() >= 0 {
                None
            } else {
                place(contact.id_j())
            };
            let thickness = THICKEST * mean * share.sqrt();
            match other {
                Some((to, other_radius)) if to.distance(from) < 1.5 * (radius + other_radius) => {
                    self.add_cylinder(from, to, thickness, share);
                }
                Some((to, other_radius)) => {
                    self.add_cylinder(from, from - contact.normal() * reach, thickness, share);
                    self.add_cylinder(to, to + contact.normal() * other_radius, thickness, share);
                }
                None => self.add_cylinder(from, from - contact.normal() * radius, thickness, share),
            }
        }
    }

    fn add_cylinder(&mut self, from: DVec3, to: DVec3, radius: f64, share: f64) {
        let pieces = ((to.distance(from) / (STRIDE * radius)).ceil() as usize).clamp(1, MOST);
        let colour = map(share).map(to_linear);
        for k in 0..=pieces {
            self.beads.push((from.lerp(to, k as f64 / pieces as f64), radius));
            self.albedo.push(colour);
        }
    }
}
