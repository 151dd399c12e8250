//! Walls as obstacles, the nearest of many found without asking all.

use super::super::hierarchy::Hierarchy;
use super::super::wall::Wall;
use glam::DVec3;

/// Walls, those with ends in a hierarchy.
pub(super) struct Obstacles<'a> {
    /// Whose clearance is not their distance, or who go on for ever.
    endless: Vec<&'a Wall>,
    bounded: Vec<&'a Wall>,
    /// Of those that are bounded, if any are.
    hierarchy: Option<Hierarchy>,
}

impl<'a> Obstacles<'a> {
    pub(super) fn new(walls: &'a [Wall]) -> Self {
        let (mut endless, mut bounded, mut boxes) = (Vec::new(), Vec::new(), Vec::new());
        for wall in walls.iter().filter(|wall| wall.is_present()) {
            match wall.clearance_bounds() {
                Some(around) => {
                    bounded.push(wall);
                    boxes.push(around);
                }
                None => endless.push(wall),
            }
        }
        let middles: Vec<DVec3> = boxes.iter().map(|(lower, upper)| 0.5 * (lower + upper)).collect();
        let hierarchy = (!boxes.is_empty()).then(|| Hierarchy::new(&middles, |wall| boxes[wall as usize]));
        Self {
            endless,
            bounded,
            hierarchy,
        }
    }

    /// Radius of the largest grain that touches none of them at a point; negative behind a one-sided wall [m].
    pub(super) fn clearance(&self, point: DVec3) -> f64 {
        let asked = self.endless.iter();
        let least = asked.fold(f64::MAX, |least, wall| wall.clearance(point, least).min(least));
        match &self.hierarchy {
            // behind a one-sided wall nothing is nearer
            Some(hierarchy) if least > 0.0 => hierarchy.least_distance(point, least, |wall, least| {
                self.bounded[wall as usize].clearance(point, least)
            }),
            _ => least,
        }
    }
}
