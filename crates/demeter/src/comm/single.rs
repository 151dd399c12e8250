//! One process: a border is a periodic side.

use super::deforming::{Deforming, Rates, ShearAxes};
use crate::particles::{Domain, Grains, Row};
use glam::DVec3;
use std::ops::Range;

/// Codes of the shifts to the next image in x, y and z.
const NEXT: [usize; 3] = [13 + 9, 13 + 3, 13 + 1];

/// Periodic sides of one process.
#[derive(Clone, Debug)]
pub struct Single {
    domain: Domain,
    shifts: [Row; 27],
    moving: Option<Box<Moving>>,
}

/// A box that deforms, and how fast its images move.
#[derive(Clone, Debug)]
struct Moving {
    deforming: Deforming,
    velocities: [Row; 27],
}

/// How many boxes away an image is, by the code of its shift.
fn digits(code: usize) -> [f64; 3] {
    [code / 9, code / 3 % 3, code % 3].map(|digit| digit as f64 - 1.0)
}

/// Sums of box edges for all codes; nothing along directions that are not periodic.
fn combinations(edges: &[DVec3; 3], periodic: [bool; 3]) -> [Row; 27] {
    let mut sums = [Row::default(); 27];
    for (code, sum) in sums.iter_mut().enumerate() {
        for (axis, digit) in digits(code).into_iter().enumerate() {
            if periodic[axis] && digit != 0.0 {
                sum.vector += edges[axis] * digit;
            }
        }
    }
    sums
}

impl Single {
    /// The borders of a domain.
    pub fn new(domain: Domain) -> Self {
        let size = domain.size();
        let edges = [DVec3::X * size.x, DVec3::Y * size.y, DVec3::Z * size.z];
        let shifts = combinations(&edges, domain.periodic);
        Self {
            domain,
            shifts,
            moving: None,
        }
    }

    /// Shift to add to a difference of positions, by its code.
    #[inline(always)]
    pub fn shift(&self, code: u8) -> DVec3 {
        self.shifts[code as usize].vector
    }

    /// All shifts by their codes; none where no side is periodic.
    #[inline(always)]
    pub fn shifts(&self) -> &[[f64; 4]] {
        if self.domain.periodic.contains(&true) {
            bytemuck::cast_slice(&self.shifts)
        } else {
            &[]
        }
    }

    /// Velocities of all shifts by their codes, to add to a difference of velocities; none where the box keeps its shape.
    #[inline(always)]
    pub fn shift_velocities(&self) -> &[[f64; 4]] {
        match &self.moving {
            Some(moving) => bytemuck::cast_slice(&moving.velocities),
            None => &[],
        }
    }

    /// Difference of two positions, of the second's nearest image: of one that slides where the box is sheared [m].
    pub fn difference(&self, a: DVec3, b: DVec3) -> DVec3 {
        let apart = a - b;
        apart + self.shift(self.nearest_image(apart))
    }

    /// How many boxes away in each direction an image is, by the code of its shift.
    pub(crate) fn boxes(code: u8) -> DVec3 {
        DVec3::from_array(digits(usize::from(code)))
    }

    /// Code of the shift that makes the difference of two positions the shortest.
    #[inline]
    pub fn nearest_image(&self, difference: DVec3) -> u8 {
        let size = self.domain.size();
        let digit = |axis: usize, difference: f64| {
            if !self.domain.periodic[axis] {
                1
            } else if difference > 0.5 * size[axis] {
                0
            } else if difference < -0.5 * size[axis] {
                2
            } else {
                1
            }
        };
        let mut difference = difference;
        if let Some(deforming) = self.deforming()
            && let Some(ShearAxes { flow, gradient }) = deforming.axes()
        {
            difference[flow] += (f64::from(digit(gradient, difference[gradient])) - 1.0) * deforming.offset();
        }
        digit(0, difference.x) * 9 + digit(1, difference.y) * 3 + digit(2, difference.z)
    }

    /// Code of no shift.
    pub const UNSHIFTED: u8 = 13;

    /// Code of the opposite shift.
    #[inline(always)]
    pub fn opposite(code: u8) -> u8 {
        26 - code
    }

    /// Puts every grain back into the periodic box and counts its crossings.
    pub fn wrap(&self, grains: &mut Grains) {
        self.wrap_some(grains, 0..grains.len(), &mut Vec::new());
    }

    /// The same of some grains. Tells those that have gone round more often than is counted.
    pub(crate) fn wrap_some(&self, grains: &mut Grains, some: Range<usize>, uncounted: &mut Vec<usize>) {
        let size = self.domain.size();
        for axis in (0..3).filter(|&k| self.domain.periodic[k]) {
            let positions = grains.position.rows_mut()[some.clone()].iter_mut();
            let loads = &mut grains.load.rows_mut()[some.clone()];
            for ((position, load), grain) in positions.zip(loads).zip(some.clone()) {
                let position = &mut position.vector;
                // one crossing at a time keeps the bits of the ordinary case simple; a lost grain is caught by the watch
                let boxes = self.boxes_beyond(*position, axis);
                if boxes == 0 {
                    continue;
                }
                position[axis] -= size[axis] * f64::from(boxes);
                let mut crossings = load.crossings();
                crossings[axis] += boxes;
                if !load.set_crossings(crossings) {
                    uncounted.push(grain);
                }
            }
        }
    }

    /// On which side of the periodic box a place lies along an axis: 1 beyond its upper end, -1 beyond its lower, 0 within.
    #[inline(always)]
    fn boxes_beyond(&self, place: DVec3, axis: usize) -> i32 {
        i32::from(place[axis] >= self.domain.upper[axis]) - i32::from(place[axis] < self.domain.lower[axis])
    }

    /// Has the images of a box that deforms be those next to it, however far it was sheared.
    pub(crate) fn follow_motion(&mut self) {
        if let Some(moving) = &mut self.moving {
            moving.deforming.unwind(&self.domain);
            self.renew();
        }
    }

    /// Puts some grains back into a box that deforms: each takes the place and the velocity of its image. Forces act on its
    /// velocity for `ahead` [s] beyond the middle of the step. Tells what kinetic energy that brought [J], and the grains that have gone
    /// round more often than is counted.
    pub(crate) fn wrap_moving(
        &self,
        grains: &mut Grains,
        some: Range<usize>,
        ahead: f64,
        uncounted: &mut Vec<usize>,
    ) -> f64 {
        let Some(deforming) = self.deforming() else {
            return 0.0;
        };
        let (edges, velocities) = (deforming.edges(&self.domain), deforming.velocities(&self.domain));
        let sheared = deforming.axes();
        // images slide along the flow: that direction comes after the one that lets them slide
        let axes = match sheared {
            Some(ShearAxes { gradient, .. }) => [gradient, (gradient + 1) % 3, (gradient + 2) % 3],
            None => [0, 1, 2],
        };
        let mut gained = 0.0;
        for g in some {
            let before = grains.crossings(g);
            let (mut place, mut crossings, mut change) = (grains.position[g], before, DVec3::ZERO);
            for axis in axes.into_iter().filter(|&k| self.domain.periodic[k]) {
                let boxes = self.boxes_beyond(place, axis);
                if boxes == 0 {
                    continue;
                }
                place -= edges[axis] * f64::from(boxes);
                change -= velocities[axis] * f64::from(boxes);
                crossings[axis] += boxes;
                if let Some(axes) = sheared.filter(|axes| axes.gradient == axis) {
                    crossings[axes.flow] -= boxes * deforming.turns();
                }
            }
            if crossings != before {
                if !grains.load.rows_mut()[g].set_crossings(crossings) {
                    uncounted.push(g);
                }
                let middle = grains.velocity[g] - grains.force(g) * (ahead * grains.inverse_mass(g));
                gained += grains.mass(g) * (middle + 0.5 * change).dot(change);
                grains.position[g] = place;
                grains.velocity[g] += change;
            }
        }
        gained
    }

    /// Position without the wrapping: where the grain would be in open space.
    #[inline]
    pub fn unwrapped(&self, position: DVec3, image: [i32; 3]) -> DVec3 {
        let size = self.domain.size();
        let mut p = position;
        for axis in 0..3 {
            if image[axis] != 0 {
                p[axis] += f64::from(image[axis]) * size[axis];
            }
        }
        if let Some(deforming) = self.deforming()
            && let Some(ShearAxes { flow, gradient }) = deforming.axes()
        {
            let slid = deforming.offset() + f64::from(deforming.turns()) * size[flow];
            p[flow] += f64::from(image[gradient]) * slid;
        }
        p
    }

    /// The domain.
    pub fn domain(&self) -> &Domain {
        &self.domain
    }

    /// Periodic directions in which a grain and its image differ by nothing but a length of the box.
    pub(crate) fn rings(&self) -> [bool; 3] {
        let mut rings = self.domain.periodic;
        if let Some(axes) = self.slides() {
            rings[axes.gradient] = false;
        }
        rings
    }

    /// Directions of the shear, where images slide.
    pub(crate) fn slides(&self) -> Option<ShearAxes> {
        self.deforming().and_then(Deforming::axes)
    }

    /// An edge of the box: what leads to the next image in a direction [m].
    pub(crate) fn edge(&self, axis: usize) -> DVec3 {
        self.shifts[NEXT[axis]].vector
    }

    /// Velocity of the next image in a direction [m/s].
    pub(crate) fn edge_velocity(&self, axis: usize) -> DVec3 {
        let moving = self.moving.as_ref();
        moving.map_or(DVec3::ZERO, |moving| moving.velocities[NEXT[axis]].vector)
    }

    /// A place put back into the box, across one side of each direction at most.
    pub(crate) fn wrapped(&self, mut place: DVec3) -> DVec3 {
        if let Some(axes) = self.slides() {
            let beyond =
                |k: usize| i8::from(place[k] >= self.domain.upper[k]) - i8::from(place[k] < self.domain.lower[k]);
            place[axes.flow] -= f64::from(beyond(axes.gradient)) * self.edge(axes.gradient)[axes.flow];
        }
        self.domain.wrapped(place)
    }

    /// The box where it deforms.
    pub(crate) fn deforming(&self) -> Option<&Deforming> {
        self.moving.as_ref().map(|moving| &moving.deforming)
    }

    /// Lets the box deform, and its images slide where a shear is told.
    pub(crate) fn begin_to_deform(&mut self, axes: Option<ShearAxes>) {
        let domain = &self.domain;
        let moving = self.moving.get_or_insert_with(|| {
            Box::new(Moving {
                deforming: Deforming::new(domain),
                velocities: [Row::default(); 27],
            })
        });
        if let Some(axes) = axes {
            moving.deforming.set_axes(axes);
        }
    }

    /// Goes on with a box that has deformed.
    pub(crate) fn restore(&mut self, domain: Domain, deforming: Deforming) {
        self.domain = domain;
        self.moving = Some(Box::new(Moving {
            deforming,
            velocities: [Row::default(); 27],
        }));
        self.renew();
    }

    /// Deforms the box by one step, with the rates of this one and of the next.
    pub(crate) fn advance(&mut self, rates: [Rates; 2], dt: f64) {
        if let Some(moving) = &mut self.moving {
            moving.deforming.advance(&mut self.domain, rates, dt);
            self.renew();
        }
    }

    fn renew(&mut self) {
        if let Some(moving) = &mut self.moving {
            let periodic = self.domain.periodic;
            self.shifts = combinations(&moving.deforming.edges(&self.domain), periodic);
            moving.velocities = combinations(&moving.deforming.velocities(&self.domain), periodic);
        }
    }
}
