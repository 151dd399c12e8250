//! The finished image: pixels, text, rectangles, PNG.

use super::shading::Rgb;
use crate::checkpoint::{Durability, write_atomically};
use crate::output::OutputError;
use noto_sans_mono_bitmap::{FontWeight, RasterHeight, get_raster, get_raster_width};
use std::path::Path;

/// An image, row by row from the top.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Image {
    width: usize,
    pixels: Vec<[u8; 3]>,
}

/// A typeface.
#[derive(Clone, Copy)]
pub(crate) struct Font {
    weight: FontWeight,
    size: RasterHeight,
}

impl Font {
    pub const TITLE: Self = Self {
        weight: FontWeight::Bold,
        size: RasterHeight::Size24,
    };
    pub const TEXT: Self = Self {
        weight: FontWeight::Regular,
        size: RasterHeight::Size20,
    };

    /// Width of a text [pixels].
    pub fn width(self, text: &str) -> usize {
        text.chars().count() * get_raster_width(self.weight, self.size)
    }

    /// Height of a line [pixels].
    pub fn height(self) -> usize {
        self.size.val()
    }
}

impl Image {
    /// Averages every square of `scale * scale` linear colours into a pixel.
    pub(super) fn reduce(colours: &[Rgb], width: usize, scale: usize) -> Self {
        let curve = to_srgb_table();
        let small = width / scale;
        let height = colours.len() / width / scale;
        let weight = 1.0 / (scale * scale) as f32;
        let mut pixels = Vec::with_capacity(small * height);
        for (y, x) in (0..height).flat_map(|y| (0..small).map(move |x| (y, x))) {
            let mut sum = [0.0_f32; 3];
            for row in 0..scale {
                let start = (y * scale + row) * width + x * scale;
                for colour in &colours[start..start + scale] {
                    (0..3).for_each(|c| sum[c] += colour[c]);
                }
            }
            pixels.push(sum.map(|s| curve[((s * weight).clamp(0.0, 1.0) * (curve.len() - 1) as f32 + 0.5) as usize]));
        }
        Self { width: small, pixels }
    }

    /// An image of pixels that are there, row by row from the top.
    pub(crate) fn of_pixels(width: usize, pixels: Vec<[u8; 3]>) -> Self {
        Self { width, pixels }
    }

    /// Lays another image over this one, turned to run upwards, where that one is darker; its lower left corner is at
    /// a pixel.
    pub(crate) fn stamp_upwards(&mut self, other: &Self, left: usize, bottom: usize) {
        for (k, colour) in other.pixels.iter().enumerate() {
            let (along, down) = (k % other.width, k / other.width);
            let (x, Some(y)) = (left + down, bottom.checked_sub(along)) else {
                continue;
            };
            if x < self.width
                && let Some(pixel) = self.pixels.get_mut(y * self.width + x)
            {
                for (old, new) in pixel.iter_mut().zip(colour) {
                    *old = (*old).min(*new);
                }
            }
        }
    }

    /// Width [pixels].
    pub fn width(&self) -> usize {
        self.width
    }

    /// Height [pixels].
    pub fn height(&self) -> usize {
        self.pixels.len().checked_div(self.width).unwrap_or(0)
    }

    /// sRGB colours, row by row from the top.
    pub fn pixels(&self) -> &[[u8; 3]] {
        &self.pixels
    }

    /// Lays a colour over a pixel; `share` is of 255.
    fn blend(&mut self, x: usize, y: usize, colour: [u8; 3], share: u8) {
        if x >= self.width {
            return;
        }
        if let Some(pixel) = self.pixels.get_mut(y * self.width + x) {
            let share = u32::from(share);
            for (old, new) in pixel.iter_mut().zip(colour) {
                // A weighted mean of two bytes is a byte.
                *old = ((u32::from(*old) * (255 - share) + u32::from(new) * share + 127) / 255) as u8;
            }
        }
    }

    /// Fills a rectangle.
    pub(super) fn fill(&mut self, x: usize, y: usize, width: usize, height: usize, colour: [u8; 3]) {
        for (y, x) in (y..y + height).flat_map(|y| (x..x + width).map(move |x| (y, x))) {
            self.blend(x, y, colour, 255);
        }
    }

    /// Writes a text with its upper left corner at a pixel; what has no place in the image is left out.
    pub(crate) fn text(&mut self, x: usize, y: usize, text: &str, font: Font, colour: [u8; 3]) {
        let advance = get_raster_width(font.weight, font.size);
        for (k, letter) in text.chars().enumerate() {
            let raster = get_raster(letter, font.weight, font.size).or_else(|| get_raster('?', font.weight, font.size));
            for (row, line) in raster.iter().flat_map(|raster| raster.rows().enumerate()) {
                for (column, &share) in line.iter().enumerate() {
                    self.blend(x + k * advance + column, y + row, colour, share);
                }
            }
        }
    }

    /// The image as a PNG file.
    pub fn to_png(&self) -> Result<Vec<u8>, png::EncodingError> {
        let mut bytes = Vec::new();
        // Images are made here, with sides far below 2^32.
        let mut encoder = png::Encoder::new(&mut bytes, self.width as u32, self.height() as u32);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
        let mut writer = encoder.write_header()?;
        writer.write_image_data(self.pixels.as_flattened())?;
        writer.finish()?;
        Ok(bytes)
    }

    /// Writes the image as a PNG file, whole or not at all.
    pub fn write_png(&self, path: &Path) -> Result<(), OutputError> {
        let bytes = self.to_png().map_err(|e| OutputError::encode(path, &e))?;
        write_atomically(path, &bytes, Durability::Kill).map_err(OutputError::io("write", path))
    }
}

/// sRGB byte to linear light (IEC 61966-2-1).
pub(super) fn to_linear(byte: u8) -> f32 {
    let c = f64::from(byte) / 255.0;
    let linear = if c <= 0.04045 {
        c / 12.92
    } else {
        libm::pow((c + 0.055) / 1.055, 2.4)
    };
    linear as f32
}

/// Linear light to sRGB bytes, at equal steps from 0 to 1.
fn to_srgb_table() -> Vec<u8> {
    const STEPS: usize = 4096;
    let byte = |k: usize| {
        let linear = k as f64 / (STEPS - 1) as f64;
        let c = if linear <= 0.003_130_8 {
            12.92 * linear
        } else {
            1.055 * libm::pow(linear, 1.0 / 2.4) - 0.055
        };
        (255.0 * c + 0.5) as u8
    };
    (0..STEPS).map(byte).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_survive_the_way_through_linear_light() {
        for byte in 30..=255 {
            let linear = to_linear(byte);
            let image = Image::reduce(&[[linear; 3]; 4], 2, 2);
            assert!(image.pixels()[0][0].abs_diff(byte) <= 1, "{byte}");
        }
    }

    #[test]
    fn a_png_reads_back() {
        let mut image = Image::reduce(&[[1.0; 3]; 64 * 32], 64, 1);
        image.text(2, 4, "5 µN", Font::TEXT, [0, 0, 0]);
        image.fill(60, 30, 10, 10, [200, 0, 0]);
        let bytes = image.to_png().unwrap();
        let mut reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().unwrap();
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        reader.next_frame(&mut pixels).unwrap();
        assert_eq!(pixels, image.pixels().as_flattened());
        assert_eq!((reader.info().width, reader.info().height), (64, 32));
        assert!(image.pixels().iter().any(|p| p[0] < 60));
        assert_eq!(image.pixels()[64 * 32 - 1], [200, 0, 0]);
    }
}
