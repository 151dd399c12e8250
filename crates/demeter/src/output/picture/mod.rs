//! A picture of the packing, drawn without a graphics card: spheres coloured by what they feel, walls as thin lines.
//!
//! The same frame gives the same picture on every machine and with any number of threads.

mod camera;
mod colouring;
mod edges;
mod image;
mod shading;
mod spheres;
mod viridis;

pub use colouring::ColourBy;
pub use image::Image;

use super::frame::Frame;
use super::ticks::Ticks;
use camera::{Area, Bounds, Camera};
use colouring::{Colouring, Legend};
use glam::DVec3;
use image::{Font, to_linear};
use shading::{Lighting, Rgb};
use spheres::Sphere;

/// Every pixel is the mean of a square of this many pixels on a side.
const SCALE: usize = 2;
const PAPER: [u8; 3] = [255, 255, 255];
const INK: [u8; 3] = [38, 44, 52];
const FAINT: [u8; 3] = [104, 112, 122];
const LINE: [u8; 3] = [70, 78, 88];

/// How a picture is made.
#[derive(Clone, Debug, PartialEq)]
pub struct PictureOptions {
    /// Text over the picture.
    pub title: String,
    /// What the colours tell.
    pub colour: ColourBy,
    /// Width [pixels], 400 to 8000.
    pub width: usize,
    /// Height [pixels], 300 to 6000.
    pub height: usize,
}

impl Default for PictureOptions {
    fn default() -> Self {
        Self {
            title: String::new(),
            colour: ColourBy::Automatic,
            width: 1200,
            height: 900,
        }
    }
}

/// Draws the grains and walls of a frame.
pub fn render_packing(frame: &Frame, options: &PictureOptions) -> Image {
    let width = options.width.clamp(400, 8000);
    let height = options.height.clamp(300, 6000);
    let colouring = Colouring::new(frame, options.colour);
    let mut image = scene(frame, &colouring, width, height);
    write_titles(&mut image, frame, options);
    if !frame.grains.is_empty() {
        match &colouring.legend {
            Legend::Bar(bar) => draw_bar(&mut image, &colouring.label, bar.high, bar.saturated),
            Legend::Names(names) => draw_names(&mut image, &colouring.label, names),
        }
    }
    image
}

/// The place of the scene in a picture, without title and legend.
fn scene_area(width: usize, height: usize) -> Area {
    let (width, height) = (width as f64, height as f64);
    Area {
        left: 50.0,
        top: 100.0,
        width: width - 50.0 - 190.0,
        height: height - 100.0 - 40.0,
    }
}

fn scene(frame: &Frame, colouring: &Colouring, width: usize, height: usize) -> Image {
    let scale = SCALE as f64;
    let area = scene_area(width, height);
    let area = Area {
        left: scale * area.left,
        top: scale * area.top,
        width: scale * area.width,
        height: scale * area.height,
    };
    let (columns, rows) = (SCALE * width, SCALE * height);
    let camera = Camera::showing(&bounds(frame), &area);
    let grains = frame.grains;
    let spheres: Vec<Sphere> = (grains.position.iter().zip(grains.radii()))
        .map(|(&p, radius)| Sphere {
            centre: camera.local(p),
            radius,
        })
        .collect();
    let seen = spheres::draw(&spheres, &camera, columns, rows);
    let albedo: Vec<Rgb> = colouring.colours.iter().map(|colour| colour.map(to_linear)).collect();
    let paper = PAPER.map(to_linear);
    let mut colours = Lighting::new(&spheres, &seen, &camera).shade(&seen, columns, &albedo, paper);

    let own = |t: &[DVec3; 3]| t.map(|p| camera.local(p));
    let lines: Vec<edges::Line> = (frame.walls.iter())
        .flat_map(|wall| edges::feature_lines(&wall.triangles.iter().map(own).collect::<Vec<_>>()))
        .collect();
    let cover = edges::draw(&lines, &camera, &seen, columns, 0.7 * scale);
    let ink = LINE.map(to_linear);
    // A wall that goes on far beyond the grains must not run through the title and the legend.
    let (first_row, last_column) = (
        (area.top - 20.0 * scale) as usize,
        (area.left + area.width + 20.0 * scale) as usize,
    );
    let pixels = colours.iter_mut().zip(cover).enumerate();
    for (_, (colour, share)) in pixels.filter(|(k, _)| k / columns >= first_row && k % columns <= last_column) {
        (0..3).for_each(|c| colour[c] += share * (ink[c] - colour[c]));
    }
    Image::reduce(&colours, columns, SCALE)
}

/// What the picture shows: all grains, and the walls as far as they are near them.
fn bounds(frame: &Frame) -> Bounds {
    let mut lower = DVec3::INFINITY;
    let mut upper = DVec3::NEG_INFINITY;
    for (&p, r) in frame.grains.position.iter().zip(frame.grains.radii()) {
        if p.is_finite() && r.is_finite() {
            lower = lower.min(p - r);
            upper = upper.max(p + r);
        }
    }
    let corners = || {
        (frame.walls.iter())
            .flat_map(|w| w.triangles.iter().flatten())
            .filter(|p| p.is_finite())
    };
    let (near, far) = if lower.x <= upper.x {
        let margin = 0.8 * (upper - lower).max_element();
        (lower - margin, upper + margin)
    } else {
        (DVec3::NEG_INFINITY, DVec3::INFINITY)
    };
    for &corner in corners() {
        lower = lower.min(corner.clamp(near, far));
        upper = upper.max(corner.clamp(near, far));
    }
    if lower.x > upper.x {
        (lower, upper) = (DVec3::ZERO, DVec3::ONE);
    }
    // A single plane has no thickness: the camera needs some.
    let thickness = (1e-3 * (upper - lower).max_element()).max(f64::MIN_POSITIVE);
    Bounds {
        lower: lower - thickness,
        upper: upper + thickness,
    }
}

fn write_titles(image: &mut Image, frame: &Frame, options: &PictureOptions) {
    let left = 40;
    let title = fitted(&options.title, Font::TITLE, image.width() - 2 * left);
    image.text(left, 28, &title, Font::TITLE, INK);
    let grains = frame.grains.len();
    let noun = if grains == 1 { "grain" } else { "grains" };
    let details = format!("{} {noun}, t = {} s", grouped(grains), short(frame.time));
    image.text(left, 28 + Font::TITLE.height() + 8, &details, Font::TEXT, FAINT);
}

/// The colour bar at the right side, with the quantity above it.
fn draw_bar(image: &mut Image, label: &str, high: f64, saturated: bool) {
    let (width, height) = (image.width(), image.height());
    let (bar_width, bar_height) = (26, height * 55 / 100);
    let (left, top) = (width - 150, height * 26 / 100);
    write_label(image, label, top - 46);
    for row in 0..bar_height {
        let share = 1.0 - (row as f64 + 0.5) / bar_height as f64;
        image.fill(left, top + row, bar_width, 1, colouring::map(share));
    }
    if saturated {
        // A tip over the bar: some grains are above its end.
        for row in 0..14 {
            let inset = bar_width * (14 - row) / 28;
            image.fill(
                left + inset,
                top - 14 + row,
                bar_width - 2 * inset,
                1,
                colouring::map(1.0),
            );
        }
    }
    let ticks = Ticks::inside(0.0, high, 5.0);
    for (value, text) in ticks.values.iter().zip(&ticks.labels) {
        let y = top + ((1.0 - value / high) * bar_height as f64 + 0.5) as usize;
        image.fill(left + bar_width, y.min(top + bar_height - 1), 7, 1, INK);
        image.text(
            left + bar_width + 13,
            y - Font::TEXT.height() / 2,
            text,
            Font::TEXT,
            INK,
        );
    }
}

/// The names of the materials at the right side, each with its colour.
fn draw_names(image: &mut Image, label: &str, names: &[(String, [u8; 3])]) {
    let (left, top) = (image.width() - 180, image.height() * 26 / 100);
    write_label(image, label, top - 46);
    let rows = (image.height() - top) / 32;
    for (k, (name, colour)) in names.iter().take(rows).enumerate() {
        image.fill(left, top + 32 * k, 20, 20, *colour);
        let name = fitted(name, Font::TEXT, 140);
        image.text(left + 30, top + 32 * k, &name, Font::TEXT, INK);
    }
}

fn write_label(image: &mut Image, label: &str, y: usize) {
    let x = image.width().saturating_sub(Font::TEXT.width(label) + 24);
    image.text(x, y, label, Font::TEXT, INK);
}

/// A text, shortened to a width.
fn fitted(text: &str, font: Font, width: usize) -> String {
    let most = width / font.width("M").max(1);
    if text.chars().count() <= most {
        return text.to_owned();
    }
    let kept: String = text.chars().take(most.saturating_sub(3)).collect();
    kept + "..."
}

/// A number with its thousands apart.
fn grouped(number: usize) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (k, digit) in digits.chars().enumerate() {
        if k > 0 && (digits.len() - k).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

/// A number with four digits.
fn short(value: f64) -> String {
    if value != 0.0 && !(1e-3..1e5).contains(&value.abs()) {
        return format!("{value:.3e}");
    }
    let text = format!("{value:.4}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

#[cfg(test)]
mod tests;
