//! Slope of the surface of a packing: the angle of repose of a heap, or of the bed in a drum.
//!
//! The grains are sorted into bins by their distance along a direction, or from an axis, and every bin is cut across into
//! cells that are as wide as the bin. The surface in a cell is as high as the highest point of its grains, and in a bin as high
//! as the mean over its cells, where these points lie in the mean. So every height is the highest of as many grains, near the axis of a heap and far from it; the highest
//! of whole rings would lie the higher the longer the ring, and make a heap look flatter. Grains without any contact are in flight
//! and do not count. The straight line that fits these heights best (least squares over the bins that hold
//! grains) tells the angle, and how far the heights are from it.

use super::told_first::each_in_order;
use super::{Selection, ToldColumn, Value, contact_counts, holds};
use crate::particles::{Origins, Zone};
use crate::simulation::Simulation;
use glam::DVec3;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::f64::consts::PI;

/// Columns of a slope.
pub const SLOPE_COLUMNS: &[ToldColumn] = &[
    ToldColumn::new(
        "angle",
        "deg",
        "angle between the surface and the horizontal, positive where it falls along the direction or away from the axis",
    ),
    ToldColumn::new(
        "deviation",
        "m",
        "root of the mean square of the heights' distance from the straight line",
    ),
    ToldColumn::new("bins", "", "bins that hold grains; the angle needs two"),
];

/// Where the surface is looked at.
#[derive(Clone, Debug, PartialEq)]
pub struct Slope {
    /// Where distances are counted from; a point of the axis of a heap [m].
    pub point: DVec3,
    /// Unit vector, horizontal, along which distances are counted; nothing for a heap, where they are counted from the axis.
    pub along: Option<DVec3>,
    /// Unit vector upwards.
    pub up: DVec3,
    /// Distances between which the surface is looked at [m].
    pub between: (f64, f64),
    /// Number of bins.
    pub bins: u32,
    /// Grains elsewhere do not count.
    pub zone: Zone,
    /// Which grains count.
    pub selection: Selection,
}

/// The highest point of the grains in a cell.
#[derive(Clone, Copy, Serialize, Deserialize)]
struct Top {
    /// How high it lies [m].
    height: f64,
    /// At which distance [m].
    distance: f64,
}

/// The highest points of all cells that hold grains, by bin and cell.
type Highest = BTreeMap<(u32, i64), Top>;

/// Notes a point of a cell.
fn rise(highest: &mut Highest, cell: (u32, i64), top: Top) {
    let highest = highest.entry(cell).or_insert(top);
    if top.height > highest.height {
        *highest = top;
    }
}

impl Slope {
    /// Titles of its columns.
    pub fn titles(&self, name: &str) -> Vec<String> {
        SLOPE_COLUMNS.iter().map(|c| c.title(name)).collect()
    }

    /// Its values now, in the order of [`SLOPE_COLUMNS`].
    pub fn measure(&self, sim: &Simulation, origins: &Origins) -> Vec<Value> {
        let grains = &sim.grains;
        let contacts = contact_counts(sim);
        let counts =
            |g: &usize| contacts[*g] > 0 && holds(sim, &self.zone, *g) && self.selection.holds(grains, origins, *g);
        let tell = |g: usize| {
            let sphere = Some(g)
                .filter(counts)
                .map(|g| (sim.comm.wrapped(grains.position[g]), grains.radius(g)));
            sphere.and_then(|(centre, radius)| self.top(centre, radius))
        };
        let mut highest = Highest::new();
        each_in_order(sim, tell, |(cell, top)| rise(&mut highest, cell, top));
        let (angle, deviation, bins) = self.fit(highest);
        vec![Value::Number(angle), Value::Number(deviation), Value::Count(bins)]
    }

    /// The cell of a bin across the distance: a strip, or a sector of a ring of a mean radius.
    fn cell(&self, outwards: DVec3, middle: f64, width: f64) -> i64 {
        match self.along {
            Some(along) => (outwards.dot(self.up.cross(along)) / width).floor() as i64,
            None => {
                let first = self.up.any_orthonormal_vector();
                let angle = libm::atan2(outwards.dot(self.up.cross(first)), outwards.dot(first));
                let sectors = (2.0 * PI * middle / width).round().max(1.0);
                (((angle / (2.0 * PI) + 0.5) * sectors) as i64).min(sectors as i64 - 1)
            }
        }
    }

    /// Width of a bin [m].
    fn width(&self) -> f64 {
        (self.between.1 - self.between.0) / f64::from(self.bins)
    }

    /// The bin and the cell in it that a sphere lies in, and its highest point.
    fn top(&self, centre: DVec3, radius: f64) -> Option<((u32, i64), Top)> {
        let ((from, to), width) = (self.between, self.width());
        let away = centre - self.point;
        let height = away.dot(self.up);
        let outwards = away - self.up * height;
        let distance = match self.along {
            Some(along) => away.dot(along),
            None => outwards.length(),
        };
        (distance >= from && distance < to).then(|| {
            let bin = (((distance - from) / width) as u32).min(self.bins - 1);
            let middle = from + (f64::from(bin) + 0.5) * width;
            let top = Top {
                height: height + radius,
                distance,
            };
            ((bin, self.cell(outwards, middle, width)), top)
        })
    }

    /// Angle [deg], deviation [m] and number of bins, of a surface.
    fn fit(&self, highest: Highest) -> (f64, f64, u64) {
        let mut sums = vec![(0.0, 0.0, 0.0); self.bins as usize];
        for ((bin, _), top) in highest {
            let (distance, height, cells) = &mut sums[bin as usize];
            *distance += top.distance;
            *height += top.height;
            *cells += 1.0;
        }
        let points: Vec<(f64, f64)> = (sums.iter())
            .filter(|(.., cells)| *cells > 0.0)
            .map(|(distance, height, cells)| (distance / cells, height / cells))
            .collect();
        let count = points.len() as f64;
        if points.len() < 2 {
            return (f64::NAN, f64::NAN, points.len() as u64);
        }
        let mean = |value: &dyn Fn(&(f64, f64)) -> f64| points.iter().map(value).sum::<f64>() / count;
        let (x, h) = (mean(&|p| p.0), mean(&|p| p.1));
        let slope = mean(&|p| (p.0 - x) * (p.1 - h)) / mean(&|p| (p.0 - x) * (p.0 - x));
        let square = mean(&|p| {
            let off = p.1 - h - slope * (p.0 - x);
            off * off
        });
        let angle = libm::atan(-slope) * (180.0 / std::f64::consts::PI);
        (angle, square.sqrt(), points.len() as u64)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::dvec3;

    impl Slope {
        /// Of spheres.
        fn fit_to(&self, spheres: impl Iterator<Item = (DVec3, f64)>) -> (f64, f64, u64) {
            let mut highest = Highest::new();
            let tops = spheres.filter_map(|(centre, radius)| self.top(centre, radius));
            tops.for_each(|(cell, top)| rise(&mut highest, cell, top));
            self.fit(highest)
        }
    }

    fn slope(along: Option<DVec3>) -> Slope {
        Slope {
            point: dvec3(0.1, 0.2, 0.0),
            along,
            up: DVec3::Z,
            between: (0.05, 1.0),
            bins: 19,
            zone: Zone::default(),
            selection: Selection::default(),
        }
    }

    /// Spheres below a surface.
    fn below(height: impl Fn(f64, f64) -> f64) -> Vec<(DVec3, f64)> {
        let mut spheres = Vec::new();
        for a in -100..=100 {
            for b in -100..=100 {
                let (x, y) = (0.1 + 0.01 * f64::from(a), 0.2 + 0.01 * f64::from(b));
                for depth in [0.01, 0.1] {
                    spheres.push((dvec3(x, y, height(x, y) - depth), 0.01));
                }
            }
        }
        spheres
    }

    #[test]
    fn a_cone_and_a_plane_have_their_angles() {
        let cone = below(|x, y| 0.8 - 0.5 * libm::hypot(x - 0.1, y - 0.2));
        let (angle, deviation, bins) = slope(None).fit_to(cone.into_iter());
        // 26.565 degrees; the highest grain of a bin lies at its inner edge, the same in every bin but for the lattice
        assert!((angle - 26.565).abs() < 0.2, "{angle}");
        assert!(deviation < 0.003 && bins == 19, "{deviation}, {bins}");
        let plane = || below(|x, _| 0.3 * x).into_iter();
        let (angle, deviation, _) = slope(Some(DVec3::X)).fit_to(plane());
        assert!(
            (angle + 16.699).abs() < 0.05 && deviation < 1e-3,
            "{angle}, {deviation}"
        );
        assert!((slope(Some(DVec3::Y)).fit_to(plane()).0).abs() < 1e-9);
    }

    /// Rows that bins as wide as nearly a row cut at ever other places.
    #[test]
    fn regular_rows_have_their_angle_whatever_the_bins() {
        let steep = libm::tan(20f64.to_radians());
        let rows = (0..40).map(|k| 0.1 + 0.042 * f64::from(k));
        let spheres = rows.map(|x| (dvec3(x, 0.2, -steep * x), 0.02));
        let mut slope = slope(Some(DVec3::X));
        slope.between = (0.0, 0.6);
        slope.bins = 15;
        let (angle, deviation, _) = slope.fit_to(spheres);
        assert!((angle - 20.0).abs() < 1e-9 && deviation < 1e-9, "{angle} {deviation}");
    }

    #[test]
    fn without_two_bins_there_is_no_angle() {
        let (angle, _, bins) = slope(None).fit_to(std::iter::once((dvec3(0.3, 0.2, 0.0), 0.1)));
        assert!(angle.is_nan() && bins == 1);
        assert_eq!(slope(None).fit_to(std::iter::empty()).2, 0);
    }

    /// Random spheres of two sizes below a surface, 2 m wide.
    fn poured(height: impl Fn(f64, f64) -> f64) -> Vec<(DVec3, f64)> {
        let mut x = 5u64;
        let mut next = move || {
            x = x
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (x >> 11) as f64 / (1u64 << 53) as f64
        };
        let mut spheres = Vec::new();
        while spheres.len() < 60_000 {
            let radius = if next() < 0.5 { 0.008 } else { 0.012 };
            let place = dvec3(2.0 * next() - 0.9, 2.0 * next() - 0.8, next());
            if place.z + radius < height(place.x, place.y) {
                spheres.push((place, radius));
            }
        }
        spheres
    }

    #[test]
    fn a_poured_heap_and_an_inclined_bed_have_their_angles_to_half_a_degree() {
        for degrees in [15.0_f64, 25.0, 35.0] {
            let steep = libm::tan(degrees.to_radians());
            let heap = poured(|x, y| 0.9 - steep * libm::hypot(x - 0.1, y - 0.2));
            let mut heap_slope = slope(None);
            heap_slope.between = (0.1, 0.9);
            heap_slope.bins = 16;
            let (angle, deviation, bins) = heap_slope.fit_to(heap.into_iter());
            assert!((angle - degrees).abs() < 0.5 && bins == 16, "{degrees}: {angle}");
            assert!(deviation < 0.02, "{deviation}");
            let bed = poured(|x, _| 0.5 + 0.5 * steep * (x - 0.1));
            let told = libm::atan(-0.5 * steep).to_degrees();
            let (angle, ..) = slope(Some(DVec3::X)).fit_to(bed.into_iter());
            assert!((angle - told).abs() < 0.5, "{told}: {angle}");
        }
    }
}
