//! Which sphere is seen in every pixel: splatting with a depth buffer.

use super::camera::Camera;
use super::cut::{Entry, Planes};
use glam::DVec3;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

/// A sphere in the frame of the camera.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub(super) struct Sphere {
    pub centre: DVec3,
    pub radius: f64,
}

/// Rows of pixels that are drawn together.
const BAND: usize = 32;

/// What a pixel sees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Seen {
    /// Distance along the axis; infinite where nothing is seen.
    pub depth: f32,
    /// Index of the sphere.
    pub sphere: u32,
}

impl Seen {
    pub const NOTHING: Self = Self {
        depth: f32::INFINITY,
        sphere: u32::MAX,
    };

    /// Whether anything is seen.
    pub fn is_covered(&self) -> bool {
        self.sphere != u32::MAX
    }
}

/// The pixels a sphere can cover: first and last column, first and last row, ends excluded.
#[derive(Clone, Copy)]
struct Cover {
    sphere: u32,
    columns: (usize, usize),
    rows: (usize, usize),
}

/// From where what is looked at, and what is cut away.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sight<'a> {
    pub camera: &'a Camera,
    pub planes: &'a Planes,
}

/// Draws spheres. The result depends on neither their order nor the number of threads.
pub(super) fn draw(spheres: &[Sphere], sight: Sight, width: usize, height: usize) -> Vec<Seen> {
    let camera = sight.camera;
    let mut covers: Vec<Cover> = (0..)
        .zip(spheres)
        .filter_map(|(index, sphere)| cover(index, sphere, camera, width, height))
        .collect();
    // From front to back, so that most hidden pixels are left at the first comparison.
    let depth = |c: &Cover| spheres[c.sphere as usize].centre.z;
    covers.sort_by(|a, b| depth(a).total_cmp(&depth(b)).then(a.sphere.cmp(&b.sphere)));
    let mut bands = vec![Vec::new(); height.div_ceil(BAND)];
    for cover in covers {
        for band in &mut bands[cover.rows.0 / BAND..cover.rows.1.div_ceil(BAND)] {
            band.push(cover);
        }
    }
    let mut seen = vec![Seen::NOTHING; width * height];
    seen.par_chunks_mut(BAND * width)
        .zip(&bands)
        .enumerate()
        .for_each(|(k, (pixels, covers))| {
            for cover in covers {
                draw_in_band(pixels, k * BAND, width, cover, &spheres[cover.sphere as usize], sight);
            }
        });
    seen
}

/// A rectangle of pixels that holds the image of a sphere, if any of it is in the picture.
fn cover(sphere: u32, s: &Sphere, camera: &Camera, width: usize, height: usize) -> Option<Cover> {
    let near = s.centre.z - s.radius;
    if !(near > 0.0 && s.radius > 0.0 && s.centre.is_finite()) {
        return None;
    }
    // The sphere is inside a cube; its nearer or its farther face bounds the image.
    let range = |c: f64, middle: f64, size: usize| {
        let far = s.centre.z + s.radius;
        let low = ((c - s.radius) / near).min((c - s.radius) / far);
        let high = ((c + s.radius) / near).max((c + s.radius) / far);
        let pixel = |tangent: f64| (middle + camera.focal * tangent).clamp(0.0, size as f64);
        (pixel(low).floor() as usize, pixel(high).ceil() as usize)
    };
    let columns = range(s.centre.x, camera.centre.x, width);
    let rows = range(s.centre.y, camera.centre.y, height);
    (columns.0 < columns.1 && rows.0 < rows.1).then_some(Cover { sphere, columns, rows })
}

fn draw_in_band(pixels: &mut [Seen], first_row: usize, width: usize, cover: &Cover, s: &Sphere, sight: Sight) {
    let rows = pixels.len() / width;
    let from = cover.rows.0.max(first_row);
    let to = cover.rows.1.min(first_row + rows);
    let nearest = (s.centre.z - s.radius) as f32;
    for y in from..to {
        let row = &mut pixels[(y - first_row) * width..][..width];
        for (x, pixel) in (cover.columns.0..).zip(&mut row[cover.columns.0..cover.columns.1]) {
            if pixel.depth <= nearest {
                continue;
            }
            let Some(entry) = meet(s, sight, sight.camera.ray(x, y)) else {
                continue;
            };
            // The ray has length 1 along the axis: its parameter is the depth.
            let depth = entry.at as f32;
            if (depth, cover.sphere) < (pixel.depth, pixel.sphere) {
                *pixel = Seen {
                    depth,
                    sphere: cover.sphere,
                };
            }
        }
    }
}

/// Where a ray enters what is left of a sphere, if it meets it.
pub(super) fn meet(s: &Sphere, sight: Sight, ray: DVec3) -> Option<Entry> {
    let (a, b) = (ray.length_squared(), ray.dot(s.centre));
    let discriminant = b * b - a * (s.centre.length_squared() - s.radius * s.radius);
    if discriminant <= 0.0 {
        return None;
    }
    let reach = discriminant.sqrt();
    sight.planes.enter(ray, (b - reach) / a, (b + reach) / a)
}

#[cfg(test)]
mod tests {
    use super::super::camera::{Area, Bounds, View};
    use super::*;

    fn camera() -> Camera {
        let bounds = Bounds {
            lower: DVec3::splat(-1.0),
            upper: DVec3::splat(1.0),
        };
        let area = Area {
            left: 0.0,
            top: 0.0,
            width: 200.0,
            height: 150.0,
        };
        Camera::showing(&bounds, &area, View::default())
    }

    fn scene(camera: &Camera) -> Vec<Sphere> {
        let at = |k: i32| DVec3::new(f64::from(k % 5) - 2.0, f64::from(k % 7) - 3.0, f64::from(k % 3) - 1.0) * 0.3;
        let sphere = |k| Sphere {
            centre: camera.local(at(k)),
            radius: 0.1 + 0.004 * f64::from(k),
        };
        (0..40).map(sphere).collect()
    }

    #[test]
    fn every_pixel_sees_what_a_search_over_all_spheres_finds() {
        let camera = camera();
        let spheres = scene(&camera);
        let planes = Planes::default();
        let sight = Sight {
            camera: &camera,
            planes: &planes,
        };
        let seen = draw(&spheres, sight, 200, 150);
        let mut covered = 0;
        for (k, pixel) in seen.iter().enumerate() {
            let ray = camera.ray(k % 200, k / 200);
            let nearest = spheres.iter().filter_map(|s| {
                let (a, b) = (ray.length_squared(), ray.dot(s.centre));
                let d = b * b - a * (s.centre.length_squared() - s.radius * s.radius);
                (d > 0.0).then(|| ((b - d.sqrt()) / a) as f32)
            });
            assert_eq!(pixel.depth, nearest.fold(f32::INFINITY, f32::min), "pixel {k}");
            covered += usize::from(pixel.sphere != u32::MAX);
        }
        assert!(covered > 3000, "{covered}");
    }

    #[test]
    fn spheres_that_cannot_be_drawn_are_left_out() {
        let camera = camera();
        let bad = [
            Sphere {
                centre: DVec3::NAN,
                radius: 1.0,
            },
            Sphere {
                centre: DVec3::ZERO,
                radius: 1.0,
            },
            Sphere {
                centre: DVec3::new(0.0, 0.0, 1e300),
                radius: 0.0,
            },
        ];
        let planes = Planes::default();
        let sight = Sight {
            camera: &camera,
            planes: &planes,
        };
        let seen = draw(&bad, sight, 20, 10);
        assert!(seen.iter().all(|pixel| *pixel == Seen::NOTHING));
    }
}
