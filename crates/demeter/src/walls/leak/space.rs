//! The space in which the centre of a grain may be: how far it is from walls, from openings that were found before, and
//! from the height above which nothing is looked for.

use super::super::surface::Surface;
use super::super::wall::Wall;
use super::obstacles::Obstacles;
use demeter_physics::geometry::surface_point::perpendicular;
use glam::{DVec2, DVec3};
use std::f64::consts::TAU;
use std::rc::Rc;

/// Share of a direction along `up` from which on it points upwards: 14 degrees above the horizontal.
const UPWARDS: f64 = 0.25;
/// Most steps towards the point of a hull that is closest to another.
const MOST_STEPS: usize = 100;
/// Cosine from which on a plane counts as one of the axes.
const ALONG_AXIS: f64 = 0.999_999;

/// Directions in which it is looked how far an opening goes.
const RAYS: u32 = 32;
/// Clearance at the rim of an opening, in radii of the grain and at most in halves of that of the opening, and the least step towards it.
const AT_RIM: f64 = 0.5;
const RIM_STEP: f64 = 0.1;

/// A polygon that closes an opening that was found.
#[derive(Clone, Debug)]
pub(super) struct Plug {
    center: DVec3,
    /// Unit vector across the opening, and two in its plane.
    normal: DVec3,
    axes: [DVec3; 2],
    corners: Vec<DVec2>,
    /// Largest distance of a corner from the middle [m].
    radius: f64,
}

impl Plug {
    /// Over all of the opening that is seen from the middle of its narrowest place, at most as far as told.
    pub(super) fn over(space: &Space<'_>, center: DVec3, normal: DVec3, farthest: f64) -> Self {
        let u = perpendicular(normal);
        let axes = [u, normal.cross(u)];
        let rim = AT_RIM * space.radius.min(space.clearance_of_walls(center));
        let corners = (0..RAYS).map(|k| {
            let angle = TAU * f64::from(k) / f64::from(RAYS);
            let direction = DVec2::new(libm::cos(angle), libm::sin(angle));
            let along = axes[0] * direction.x + axes[1] * direction.y;
            let mut way = 0.0;
            while way < farthest {
                let clearance = space.clearance_of_walls(center + along * way);
                if clearance < rim {
                    break;
                }
                way += (0.5 * clearance).max(RIM_STEP * space.radius);
            }
            direction * way.min(farthest)
        });
        let corners: Vec<DVec2> = corners.collect();
        Plug {
            center,
            normal,
            axes,
            radius: corners.iter().map(|corner| corner.length()).fold(0.0, f64::max),
            corners,
        }
    }

    pub(super) fn shifted(&self, by: DVec3) -> Self {
        Plug {
            center: self.center + by,
            ..self.clone()
        }
    }

    /// Distance of a point, or what is told where that is less [m].
    pub(super) fn distance(&self, point: DVec3, most: f64) -> f64 {
        let from_center = point - self.center;
        let least = most.max(0.0) + self.radius;
        if from_center.length_squared() > least * least {
            return most;
        }
        let height = from_center.dot(self.normal);
        let flat = DVec2::new(from_center.dot(self.axes[0]), from_center.dot(self.axes[1]));
        let ends = self.corners.iter().zip(self.corners.iter().cycle().skip(1));
        let mut is_inside = false;
        let mut beside = f64::INFINITY;
        for (&from, &to) in ends {
            // the middle sees every side from within
            let is_between = from.perp_dot(flat) >= 0.0 && flat.perp_dot(to) >= 0.0 && from.perp_dot(to) > 0.0;
            is_inside |= is_between && (to - from).perp_dot(flat - from) >= 0.0;
            let side = to - from;
            let share = ((flat - from).dot(side) / side.length_squared().max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
            beside = beside.min(flat.distance(from + side * share));
        }
        most.min(DVec2::new(height, if is_inside { 0.0 } else { beside }).length())
    }
}

/// Walls as obstacles for the centre of a grain.
pub(super) struct Space<'a> {
    walls: &'a [Wall],
    obstacles: Rc<Obstacles<'a>>,
    /// Radius of the grain [m].
    pub(super) radius: f64,
    /// Against gravity; zero without gravity.
    pub(super) up: DVec3,
    /// Highest centre that is looked at, along `up` [m].
    pub(super) cap: f64,
    pub(super) plugs: Vec<Plug>,
    /// Periodic axes, each with its lower and upper side [m].
    pub(super) periodic: Vec<(usize, f64, f64)>,
    /// Corners of triangles that draw the finite walls [m].
    outline: Vec<DVec3>,
    /// Their area [m^2].
    pub(super) area: f64,
}

impl<'a> Space<'a> {
    pub(super) fn new(walls: &'a [Wall], radius: f64, gravity: DVec3) -> Self {
        let mut outline = Vec::new();
        let mut area = 0.0;
        for wall in walls {
            let Some((lower, upper)) = wall.bounds() else { continue };
            for [a, b, c] in wall.triangles(lower, upper) {
                area += 0.5 * (b - a).cross(c - a).length();
                outline.extend([a, b, c]);
            }
        }
        Space {
            walls,
            obstacles: Rc::new(Obstacles::new(walls)),
            radius,
            up: -gravity.normalize_or_zero(),
            cap: f64::INFINITY,
            plugs: Vec::new(),
            periodic: Vec::new(),
            outline,
            area,
        }
    }

    /// The same walls and plugs, for a closer look.
    pub(super) fn again(&self) -> Space<'a> {
        Space {
            walls: self.walls,
            obstacles: Rc::clone(&self.obstacles),
            radius: self.radius,
            up: self.up,
            cap: self.cap,
            plugs: self.plugs.clone(),
            periodic: self.periodic.clone(),
            outline: Vec::new(),
            area: 0.0,
        }
    }

    /// Height of a point [m].
    pub(super) fn height(&self, point: DVec3) -> f64 {
        point.dot(self.up)
    }

    /// Height of the highest point of the finite walls, or without such walls of the highest level plane; `None` where there is
    /// neither, or no gravity.
    pub(super) fn top(&self) -> Option<f64> {
        let heights = self.outline.iter().map(|&point| self.height(point));
        let highest = heights.reduce(f64::max).or_else(|| self.highest_level_plane());
        highest.filter(|_| self.up != DVec3::ZERO)
    }

    fn highest_level_plane(&self) -> Option<f64> {
        let level = self.walls.iter().filter(|wall| match wall.surface() {
            Surface::Plane(plane) => wall.pose().turn(plane.normal).dot(self.up) > ALONG_AXIS,
            _ => false,
        });
        level.map(|wall| self.height(wall.origin())).reduce(f64::max)
    }

    /// Whether all walls go on for ever.
    pub(super) fn is_endless(&self) -> bool {
        self.outline.is_empty()
    }

    /// Radius of the largest grain that touches nothing at a point; negative behind a one-sided wall [m].
    pub(super) fn clearance(&self, point: DVec3) -> f64 {
        let point = self.put_back(point);
        let mut least = self.obstacles.clearance(point);
        for plug in &self.plugs {
            least = plug.distance(point, least);
        }
        least
    }

    /// The same without what closes openings that were found [m].
    pub(super) fn clearance_of_walls(&self, point: DVec3) -> f64 {
        self.obstacles.clearance(self.put_back(point))
    }

    /// Whether a grain half as large gets straight from one point to another.
    pub(super) fn is_clear(&self, from: DVec3, to: DVec3) -> bool {
        let length = from.distance(to);
        let mut way = 0.0;
        while way <= length {
            let clearance = self.clearance_of_walls(from + (to - from) * (way / length.max(f64::MIN_POSITIVE)));
            if clearance < 0.5 * self.radius {
                return false;
            }
            way += clearance;
        }
        true
    }

    /// The place of a point in the periodic box: walls are not repeated beyond its sides.
    pub(super) fn put_back(&self, mut point: DVec3) -> DVec3 {
        for &(axis, lower, upper) in &self.periodic {
            if !(lower..upper).contains(&point[axis]) {
                point[axis] = lower + (point[axis] - lower).rem_euclid(upper - lower);
            }
        }
        point
    }

    /// What the cap leaves of a clearance; nothing above it.
    pub(super) fn below_cap(&self, clearance: f64, point: DVec3) -> f64 {
        let below = self.cap - self.height(point);
        if below < 0.0 {
            f64::MIN
        } else {
            clearance.min(below + self.radius)
        }
    }

    /// The box around the finite walls, the points given, and the planes that stand along an axis; `None` without any.
    pub(super) fn bounds(&self, points: &[DVec3]) -> Option<(DVec3, DVec3)> {
        let finite = self.walls.iter().filter_map(Wall::bounds);
        let around = finite.chain(points.iter().map(|&p| (p - self.radius, p + self.radius)));
        let (mut lower, mut upper) = around.reduce(|(lower, upper), (l, u)| (lower.min(l), upper.max(u)))?;
        for wall in self.walls {
            let Surface::Plane(plane) = wall.surface() else {
                continue;
            };
            let normal = wall.pose().turn(plane.normal);
            let axis = (0..3).find(|&k| normal[k].abs() > ALONG_AXIS);
            if let Some(axis) = axis {
                let at = wall.origin()[axis];
                lower[axis] = lower[axis].min(at);
                upper[axis] = upper[axis].max(at);
            }
        }
        Some((lower, upper))
    }

    /// Whether a point is above the convex hull of the finite walls: a grain there left upwards.
    ///
    /// The closest point of the hull is approached as by E. G. Gilbert, SIAM J. Control 4 (1966) 61.
    pub(super) fn is_above_walls(&self, point: DVec3) -> bool {
        let Some(&first) = self.outline.first() else {
            return false;
        };
        let mut closest = first - point;
        for _ in 0..MOST_STEPS {
            let lowest = self.outline.iter().map(|&corner| corner - point);
            let least = lowest.min_by(|a, b| a.dot(closest).total_cmp(&b.dot(closest)));
            let Some(support) = least else { return false };
            let gap = closest.length_squared() - support.dot(closest);
            if support.dot(closest) > 0.0 && -self.height(closest) >= UPWARDS * closest.length() {
                return true;
            }
            if gap <= 1e-9 * closest.length_squared() {
                return false;
            }
            let towards = support - closest;
            let share = (gap / towards.length_squared()).clamp(0.0, 1.0);
            closest += towards * share;
        }
        false
    }
}
