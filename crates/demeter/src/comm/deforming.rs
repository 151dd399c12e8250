//! How a periodic box deforms: its edges grow or shrink, and one layer of images slides over another (Lees and Edwards,
//! J. Phys. C 5 (1972) 1921).
//!
//! The edges of the box are the vectors that lead from a grain to its images. They follow a velocity gradient: the
//! rates of stretching along the three axes, and one rate of shear. The shear lets the images across the sides of its
//! gradient direction slide along its flow direction; the box itself stays upright, and an offset tells how far they slid.
//! The middle of the box rests.

use crate::particles::Domain;
use glam::{DMat3, DVec3};
use serde::{Deserialize, Serialize};

/// Directions of a simple shear, as numbers of axes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct ShearAxes {
    /// Direction of the flow.
    pub flow: usize,
    /// Direction along which the velocity of the flow changes.
    pub gradient: usize,
}

/// Velocity gradient of a box.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Rates {
    /// Rates of true strain along the axes, `(dL/dt)/L`: negative where the box shrinks [1/s].
    pub stretching: DVec3,
    /// Rate of shear: change of the velocity of the flow along the gradient direction [1/s].
    pub shear: f64,
}

impl Rates {
    /// What has to be added to another gradient to make this one.
    pub(crate) fn beyond(&self, other: &Self) -> Self {
        Self {
            stretching: self.stretching - other.stretching,
            shear: self.shear - other.shear,
        }
    }

    /// Mean of this gradient and another.
    pub(crate) fn mean(&self, other: &Self) -> Self {
        Self {
            stretching: 0.5 * (self.stretching + other.stretching),
            shear: 0.5 * (self.shear + other.shear),
        }
    }
}

/// A linear map that deforms space about a point: stretching, and a slip of the flow direction.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Carry {
    growth: DVec3,
    slip: f64,
    axes: Option<ShearAxes>,
}

impl Carry {
    /// No deformation.
    pub(crate) const NONE: Self = Self {
        growth: DVec3::ONE,
        slip: 0.0,
        axes: None,
    };

    /// What a velocity gradient does over a time, centred in it: `x' - x = dt G (x + x')/2`.
    pub(crate) fn new(rates: &Rates, axes: Option<ShearAxes>, dt: f64) -> Self {
        let half = rates.stretching * (0.5 * dt);
        let growth = (DVec3::ONE + half) / (DVec3::ONE - half);
        let slip = axes.map_or(0.0, |ShearAxes { flow, gradient }| {
            0.5 * dt * rates.shear * (1.0 + growth[gradient]) / (1.0 - half[flow])
        });
        Self { growth, slip, axes }
    }

    /// Where a vector is carried to.
    #[inline(always)]
    pub(crate) fn apply(&self, x: DVec3) -> DVec3 {
        let mut carried = self.growth * x;
        if let Some(ShearAxes { flow, gradient }) = self.axes {
            carried[flow] += self.slip * x[gradient];
        }
        carried
    }

    /// This map and then another.
    pub(crate) fn then(&self, next: &Self) -> Self {
        let axes = next.axes.or(self.axes);
        let slip = axes.map_or(0.0, |ShearAxes { flow, gradient }| {
            next.growth[flow] * self.slip + next.slip * self.growth[gradient]
        });
        Self {
            growth: self.growth * next.growth,
            slip,
            axes,
        }
    }

    /// What no vector changes more than, as a share of its length.
    pub(crate) fn strain(&self) -> f64 {
        (self.growth - DVec3::ONE).abs().max_element() + self.slip.abs()
    }
}

/// A periodic box that deforms.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Deforming {
    /// The point that rests [m].
    pub(crate) middle: DVec3,
    axes: Option<ShearAxes>,
    /// How far the images above slid along the flow, but for whole boxes [m].
    offset: f64,
    /// Whole boxes that they slid.
    turns: i32,
    /// Velocity gradient of the latest step.
    rates: Rates,
    /// Velocity gradient at this moment: the mean of those of the steps before and after it.
    now: Rates,
    /// How the latest step deformed the box, and how long it was [s].
    pub(crate) carry: Carry,
    dt: f64,
    /// What the edges of the box changed by in the latest step [m].
    changes: [DVec3; 3],
}

impl Deforming {
    pub(super) fn new(domain: &Domain) -> Self {
        Self {
            middle: 0.5 * (domain.lower + domain.upper),
            axes: None,
            offset: 0.0,
            turns: 0,
            rates: Rates::default(),
            now: Rates::default(),
            carry: Carry::NONE,
            dt: 0.0,
            changes: [DVec3::ZERO; 3],
        }
    }

    /// The edges of the box: what leads to the next image in each direction [m].
    pub(super) fn edges(&self, domain: &Domain) -> [DVec3; 3] {
        let size = domain.size();
        let mut edges = [DVec3::X * size.x, DVec3::Y * size.y, DVec3::Z * size.z];
        if let Some(ShearAxes { flow, gradient }) = self.axes {
            edges[gradient][flow] = self.offset;
        }
        edges
    }

    /// Directions of the shear, if images slide.
    pub(crate) fn axes(&self) -> Option<ShearAxes> {
        self.axes
    }

    /// How far images slid along the flow, but for whole boxes [m].
    pub(crate) fn offset(&self) -> f64 {
        self.offset
    }

    /// Whole boxes that images slid.
    pub(super) fn turns(&self) -> i32 {
        self.turns
    }

    /// Velocity gradient of the latest step.
    pub(crate) fn rates(&self) -> Rates {
        self.rates
    }

    /// Velocity gradient at this moment.
    pub(crate) fn now(&self) -> Rates {
        self.now
    }

    /// Largest ratio of the speed of the affine flow to the distance from the middle, at most [1/s].
    pub(crate) fn steepness(&self) -> f64 {
        let of = |rates: &Rates| rates.stretching.abs().max_element() + rates.shear.abs();
        of(&self.rates).max(of(&self.now))
    }

    /// What the edges of the box changed by in the latest step [m].
    pub(crate) fn changes(&self) -> [DVec3; 3] {
        self.changes
    }

    /// Velocities of the images that the edges lead to, at this moment [m/s]: those of the latest step, whose middle is half a
    /// step back, and what they change until now.
    pub(super) fn velocities(&self, domain: &Domain) -> [DVec3; 3] {
        let per_time = if self.dt > 0.0 { 1.0 / self.dt } else { 0.0 };
        let edges = self.edges(domain);
        let change = self.second_half();
        [0, 1, 2].map(|k| self.changes[k] * per_time + change * edges[k])
    }

    /// What the gradient of the affine flow, with that of its acceleration, adds up to from the beginning of a step with these rates to
    /// its middle, where it was `now` before [1/s].
    pub(crate) fn first_half(&self, rates: &Rates, dt: f64) -> DMat3 {
        let gradient = self.gradient(rates);
        self.gradient(&rates.beyond(&self.now)) + gradient * gradient * (0.5 * dt)
    }

    /// What it adds up to from the middle of the latest step until now [1/s].
    pub(crate) fn second_half(&self) -> DMat3 {
        let gradient = self.gradient(&self.rates);
        self.gradient(&self.now.beyond(&self.rates)) + gradient * gradient * (0.5 * self.dt)
    }

    /// Velocity gradient of the affine flow [1/s]: times a place relative to the middle it is the velocity there.
    pub(crate) fn gradient(&self, rates: &Rates) -> DMat3 {
        let mut gradient = DMat3::from_diagonal(rates.stretching);
        if let Some(ShearAxes { flow, gradient: across }) = self.axes {
            gradient.col_mut(across)[flow] += rates.shear;
        }
        gradient
    }

    pub(super) fn set_axes(&mut self, axes: ShearAxes) {
        self.axes = Some(axes);
    }

    /// Deforms the box by one step, with the rates of this one and of the next.
    pub(super) fn advance(&mut self, domain: &mut Domain, [rates, next]: [Rates; 2], dt: f64) {
        let before = self.edges(domain);
        let carry = Carry::new(&rates, self.axes, dt);
        for axis in (0..3).filter(|&k| rates.stretching[k] != 0.0) {
            let half = 0.5 * domain.size()[axis] * carry.growth[axis];
            domain.lower[axis] = self.middle[axis] - half;
            domain.upper[axis] = self.middle[axis] + half;
        }
        if let Some(ShearAxes { flow, gradient }) = self.axes {
            self.offset = carry.growth[flow] * self.offset + carry.slip * before[gradient][gradient];
        }
        (self.rates, self.carry, self.dt) = (rates, carry, dt);
        self.now = rates.mean(&next);
        let after = self.edges(domain);
        self.changes = [0, 1, 2].map(|k| after[k] - before[k]);
    }

    /// Takes whole boxes out of the offset.
    pub(super) fn unwind(&mut self, domain: &Domain) {
        let Some(ShearAxes { flow, gradient }) = self.axes else {
            return;
        };
        let length = domain.size()[flow];
        let boxes = (self.offset / length).round();
        if boxes != 0.0 {
            self.offset -= boxes * length;
            self.turns += boxes as i32;
            let change = self.changes[flow];
            self.changes[gradient] -= change * boxes;
        }
    }

    /// Whether its numbers are possible, as they are unless a file was tampered with.
    pub(crate) fn is_sound(&self) -> bool {
        let is_axis = |axes: &ShearAxes| axes.flow < 3 && axes.gradient < 3 && axes.flow != axes.gradient;
        let vectors = [
            self.middle,
            self.rates.stretching,
            self.now.stretching,
            self.carry.growth,
        ];
        self.axes.as_ref().is_none_or(is_axis)
            && self.carry.axes.as_ref().is_none_or(is_axis)
            && vectors.iter().chain(&self.changes).all(|v| v.is_finite())
            && [self.offset, self.rates.shear, self.now.shear, self.carry.slip, self.dt]
                .iter()
                .all(|x| x.is_finite())
    }
}
