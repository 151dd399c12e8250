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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::walls::{Motion, Shape, Side};

    #[test]
    fn the_nearest_of_many_is_that_of_all() {
        let mut state = 7u64;
        let mut uniform = || {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1u64 << 53) as f64
        };
        let mut anywhere = || DVec3::new(uniform(), uniform(), uniform());
        let mut shapes = vec![Shape::Plane {
            point: DVec3::Z * -0.1,
            normal: DVec3::Z,
        }];
        for kind in 0..120 {
            let (center, away) = (anywhere(), 0.1 * anywhere() + 0.01);
            shapes.push(match kind % 4 {
                0 => Shape::Cylinder {
                    start: center,
                    end: center + away,
                    radius: 0.02,
                    side: if kind % 8 == 0 { Side::Inside } else { Side::Outside },
                },
                1 => Shape::Disc {
                    center,
                    normal: away.normalize(),
                    radius: 0.03,
                },
                2 => Shape::Mesh {
                    triangles: vec![[center, center + away, center + DVec3::X * 0.1]],
                },
                _ => Shape::Sphere {
                    center,
                    radius: 0.02,
                    side: Side::Outside,
                },
            });
        }
        let walls: Vec<Wall> = (shapes.into_iter().enumerate())
            .map(|(k, shape)| Wall::new(&k.to_string(), 0, shape, Motion::Rest).unwrap())
            .collect();
        let obstacles = Obstacles::new(&walls);
        assert_eq!((obstacles.bounded.len(), obstacles.endless.len()), (90, 31));
        for _ in 0..2000 {
            let point = 1.4 * anywhere() - 0.2;
            let all = walls.iter().map(|wall| wall.clearance(point, f64::MAX));
            let least = all.fold(f64::MAX, f64::min);
            let found = obstacles.clearance(point);
            // inside of a solid one it may be anything that is not free
            assert!(
                found == least || (found <= 0.0 && least <= 0.0),
                "{point}: {found}, not {least}"
            );
        }
    }
}
