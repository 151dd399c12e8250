//! The camera: a perspective view, from the front and a little from above unless told, z up, that shows the whole box.

use glam::{DVec2, DVec3};

/// Where one looks from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// Degrees about z from the x axis.
    pub azimuth: f64,
    /// Degrees above the horizon, -90 to 90.
    pub elevation: f64,
}

impl Default for View {
    fn default() -> Self {
        Self {
            azimuth: -62.0,
            elevation: 17.0,
        }
    }
}

/// Half of the opening angle of the wider side of the view, as its tangent: a mild perspective.
const OPENING: f64 = 0.14;

/// An axis-aligned box [m].
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Bounds {
    pub lower: DVec3,
    pub upper: DVec3,
}

impl Bounds {
    pub fn corners(&self) -> [DVec3; 8] {
        std::array::from_fn(|k| {
            let pick = |axis: usize| {
                if k >> axis & 1 == 0 {
                    self.lower[axis]
                } else {
                    self.upper[axis]
                }
            };
            DVec3::new(pick(0), pick(1), pick(2))
        })
    }
}

/// A rectangle of pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Area {
    pub left: f64,
    pub top: f64,
    pub width: f64,
    pub height: f64,
}

/// A perspective camera. In its own frame x points right, y down, z away from it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Camera {
    eye: DVec3,
    right: DVec3,
    down: DVec3,
    forward: DVec3,
    /// Pixels per tangent of the angle.
    pub focal: f64,
    /// Pixel on the axis.
    pub centre: DVec2,
}

impl Camera {
    /// The camera that shows a box as large as an area of the picture allows.
    pub fn showing(bounds: &Bounds, area: &Area, view: View) -> Self {
        let radians = std::f64::consts::PI / 180.0;
        let (sin_azimuth, cos_azimuth) = libm::sincos(view.azimuth * radians);
        let (sin_elevation, cos_elevation) = libm::sincos(view.elevation.clamp(-90.0, 90.0) * radians);
        let forward = -DVec3::new(cos_azimuth * cos_elevation, sin_azimuth * cos_elevation, sin_elevation);
        let right = DVec3::new(-sin_azimuth, cos_azimuth, 0.0);
        let mut camera = Self {
            eye: 0.5 * (bounds.lower + bounds.upper),
            right,
            down: forward.cross(right),
            forward,
            focal: 0.5 * area.width.max(area.height) / OPENING,
            centre: DVec2::new(area.left + 0.5 * area.width, area.top + 0.5 * area.height),
        };
        // With the eye at the centre of the box, the distance at which every corner is inside, then the shift that
        // centres what is seen; a perspective view settles after a few rounds.
        let corners = bounds.corners();
        let half = DVec2::new(area.width, area.height) * (0.5 / camera.focal);
        let mut target = camera.eye;
        for _ in 0..8 {
            camera.eye = target;
            let distance = corners.iter().map(|&corner| {
                let p = camera.local(corner);
                (p.x.abs() / half.x).max(p.y.abs() / half.y) - p.z
            });
            let distance = distance.fold(0.0, f64::max);
            camera.eye = target - distance * forward;
            let (mut low, mut high) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
            for &corner in &corners {
                let at = camera.pixel(camera.local(corner));
                (low, high) = (low.min(at), high.max(at));
            }
            let shift = (0.5 * (low + high) - camera.centre) * (distance / camera.focal);
            target += shift.x * camera.right + shift.y * camera.down;
        }
        camera
    }

    /// A point in the frame of the camera.
    pub fn local(&self, p: DVec3) -> DVec3 {
        let d = p - self.eye;
        DVec3::new(d.dot(self.right), d.dot(self.down), d.dot(self.forward))
    }

    /// A direction in the frame of the camera.
    pub fn turn(&self, d: DVec3) -> DVec3 {
        DVec3::new(d.dot(self.right), d.dot(self.down), d.dot(self.forward))
    }

    /// The pixel where a point in the frame of the camera, in front of it, is seen.
    pub fn pixel(&self, p: DVec3) -> DVec2 {
        self.centre + p.truncate() * (self.focal / p.z)
    }

    /// Direction of the ray through the middle of a pixel, with length 1 along the axis.
    pub fn ray(&self, x: usize, y: usize) -> DVec3 {
        let at = DVec2::new(x as f64 + 0.5, y as f64 + 0.5);
        ((at - self.centre) / self.focal).extend(1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_whole_box_is_seen_and_fills_the_area() {
        let area = Area {
            left: 40.0,
            top: 80.0,
            width: 1000.0,
            height: 700.0,
        };
        for upper in [DVec3::ONE, DVec3::new(10.0, 1.0, 0.1), DVec3::new(0.1, 0.1, 7.0)] {
            let bounds = Bounds {
                lower: -0.3 * upper,
                upper,
            };
            let camera = Camera::showing(&bounds, &area, View::default());
            let pixels = bounds.corners().map(|corner| camera.pixel(camera.local(corner)));
            let low = pixels.iter().fold(DVec2::INFINITY, |a, b| a.min(*b));
            let high = pixels.iter().fold(DVec2::NEG_INFINITY, |a, b| a.max(*b));
            assert!(
                low.x > 38.0 && low.y > 78.0 && high.x < 1042.0 && high.y < 782.0,
                "{low} {high}"
            );
            assert!(high.x - low.x > 900.0 || high.y - low.y > 630.0, "{low} {high}");
        }
    }

    #[test]
    fn the_ray_through_the_pixel_of_a_point_meets_the_point() {
        let bounds = Bounds {
            lower: DVec3::ZERO,
            upper: DVec3::ONE,
        };
        let area = Area {
            left: 0.0,
            top: 0.0,
            width: 400.0,
            height: 300.0,
        };
        let camera = Camera::showing(&bounds, &area, View::default());
        let p = camera.local(DVec3::new(0.2, 0.9, 0.4));
        let at = camera.pixel(p);
        let ray = camera.ray(at.x as usize, at.y as usize);
        assert!((ray * p.z - p).length() < 0.01);
        // z is up, and up is towards smaller rows.
        assert!(camera.turn(DVec3::Z).y < 0.0);
    }
}
