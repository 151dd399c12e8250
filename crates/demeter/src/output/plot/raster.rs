//! A plot as pixels, for PNG: lines by tiny-skia, letters from the same typeface as pictures.

use super::canvas::{Anchor, Canvas, Label, Letters, Pen};
use super::{CIRCLE, Look};
use crate::output::picture::{Font, Image};
use tiny_skia::{Color, LineCap, LineJoin, Paint, PathBuilder, Pixmap, Rect, Stroke, StrokeDash, Transform};

/// Pixels of the picture for one of the plot: letters come out as large as in SVG.
const SCALE: f32 = 1.5;
/// How far a power stands above its line [pixels of the picture].
const RAISED: usize = 8;

/// A picture that is being drawn.
pub(super) struct Raster {
    pixels: Pixmap,
    /// Where the plot begins [pixels of the plot].
    origin: (f64, f64),
    /// Texts, which are written over everything else.
    texts: Vec<((f64, f64), Label, Letters)>,
}

impl Raster {
    /// A white picture; nothing when it would be too large or has no extent.
    pub fn new(width: f64, height: f64) -> Option<Self> {
        let mut pixels = Pixmap::new((width * f64::from(SCALE)) as u32, (height * f64::from(SCALE)) as u32)?;
        pixels.fill(Color::WHITE);
        Some(Self {
            pixels,
            origin: (0.0, 0.0),
            texts: Vec::new(),
        })
    }

    /// Draws what follows with this origin.
    pub fn shift(&mut self, left: f64, top: f64) {
        self.origin = (left, top);
    }

    /// The picture.
    pub fn finish(self) -> Image {
        let opaque = self.pixels.pixels().iter().map(|p| [p.red(), p.green(), p.blue()]);
        let mut image = Image::of_pixels(self.pixels.width() as usize, opaque.collect());
        for (at, label, letters) in &self.texts {
            write(&mut image, *at, label, *letters);
        }
        image
    }

    fn point(&self, at: (f64, f64)) -> (f32, f32) {
        // Pixels of a picture fit an f32.
        (
            (at.0 + self.origin.0) as f32 * SCALE,
            (at.1 + self.origin.1) as f32 * SCALE,
        )
    }

    fn stroke(&mut self, path: PathBuilder, colour: &str, width: f64, look: Look) {
        let Some(path) = path.finish() else { return };
        let dashes = match look {
            Look::Dashed => StrokeDash::new(vec![9.0 * SCALE, 6.0 * SCALE], 0.0),
            Look::Dotted => StrokeDash::new(vec![1.0 * SCALE, 5.0 * SCALE], 0.0),
            Look::Line | Look::Circles => None,
        };
        let stroke = Stroke {
            width: width as f32 * SCALE,
            line_cap: LineCap::Round,
            line_join: LineJoin::Round,
            dash: dashes,
            ..Stroke::default()
        };
        self.pixels
            .stroke_path(&path, &paint(colour, 1.0), &stroke, Transform::identity(), None);
    }
}

fn paint(colour: &str, opacity: f32) -> Paint<'static> {
    let [red, green, blue] = rgb(colour);
    let mut paint = Paint {
        anti_alias: true,
        ..Paint::default()
    };
    paint.set_color_rgba8(red, green, blue, (opacity * 255.0) as u8);
    paint
}

/// The bytes of `#rrggbb`; black for anything else.
fn rgb(colour: &str) -> [u8; 3] {
    let byte = |k: usize| colour.get(k..k + 2).and_then(|text| u8::from_str_radix(text, 16).ok());
    [1, 3, 5].map(|k| byte(k).unwrap_or(0))
}

impl Canvas for Raster {
    fn rule(&mut self, from: (f64, f64), to: (f64, f64), colour: &'static str) {
        self.lines(
            &[vec![from, to]],
            Pen {
                colour,
                width: 1.0,
                look: Look::Line,
            },
        );
    }

    fn lines(&mut self, lines: &[Vec<(f64, f64)>], pen: Pen) {
        let mut path = PathBuilder::new();
        for line in lines {
            for (k, at) in line.iter().enumerate() {
                let (x, y) = self.point(*at);
                if k == 0 {
                    path.move_to(x, y);
                } else {
                    path.line_to(x, y);
                }
            }
            if let [only] = line[..] {
                // a point alone is a dot
                let (x, y) = self.point(only);
                path.line_to(x + 0.01, y);
            }
        }
        self.stroke(path, pen.colour, pen.width, pen.look);
    }

    fn circles(&mut self, centres: &[(f64, f64)], pen: Pen) {
        let mut path = PathBuilder::new();
        for at in centres {
            let (x, y) = self.point(*at);
            path.push_circle(x, y, CIRCLE as f32 * SCALE);
        }
        self.stroke(path, pen.colour, pen.width, pen.look);
    }

    fn card(&mut self, [left, top, width, height]: [f64; 4]) {
        let (x, y) = self.point((left, top));
        let Some(rect) = Rect::from_xywh(x, y, width as f32 * SCALE, height as f32 * SCALE) else {
            return;
        };
        self.pixels
            .fill_rect(rect, &paint("#ffffff", 0.85), Transform::identity(), None);
        let mut rim = PathBuilder::new();
        rim.push_rect(rect);
        self.stroke(rim, "#d5d9dd", 1.0, Look::Line);
    }

    fn text(&mut self, at: (f64, f64), label: &Label, letters: Letters) {
        let at = (at.0 + self.origin.0, at.1 + self.origin.1);
        self.texts.push((at, label.clone(), letters));
    }
}

/// Writes a text with its baseline at a place of the plot.
fn write(image: &mut Image, (x, y): (f64, f64), label: &Label, letters: Letters) {
    let font = if letters.title { Font::TITLE } else { Font::TEXT };
    let power = label.power.as_deref().unwrap_or_default();
    let (width, raised) = (font.width(&label.text), Font::TEXT.width(power));
    let scale = f64::from(SCALE);
    let back = match letters.anchor {
        Anchor::Start => 0.0,
        Anchor::Middle => 0.5 * (width + raised) as f64,
        Anchor::End => (width + raised) as f64,
    };
    // the letters of a line stand on about four fifths of its height
    let above = 0.8 * font.height() as f64;
    if letters.upwards {
        let mut turned = Image::of_pixels(
            width + raised,
            vec![[255; 3]; (width + raised) * (font.height() + RAISED)],
        );
        turned.text(0, RAISED, &label.text, font, super::INK);
        turned.text(width, 0, power, Font::TEXT, super::INK);
        let left = (x * scale - above - RAISED as f64).max(0.0) as usize;
        let bottom = (y * scale + back) as usize;
        image.stamp_upwards(&turned, left, bottom);
        return;
    }
    let (left, top) = (
        (x * scale - back).max(0.0) as usize,
        (y * scale - above).max(0.0) as usize,
    );
    image.text(left, top, &label.text, font, super::INK);
    image.text(left + width, top.saturating_sub(RAISED), power, Font::TEXT, super::INK);
}
