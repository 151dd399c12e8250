//! Several plots in one picture.

use super::{HEIGHT, Plot, Raster, Svg, WIDTH};
use crate::checkpoint::{Durability, write_atomically};
use crate::output::OutputError;
use crate::output::picture::Image;
use std::path::Path;

/// Plots in one picture, row by row.
#[derive(Clone, Debug, PartialEq)]
pub struct Sheet {
    /// The plots.
    pub plots: Vec<Plot>,
    /// Plots beside each other.
    pub columns: usize,
}

impl Sheet {
    /// The picture as an SVG document.
    pub fn to_svg(&self) -> String {
        let (width, height) = self.size();
        let mut svg = Svg::new(width, height);
        for (plot, (left, top)) in self.plots.iter().zip(self.places()) {
            svg.begin_shift(left, top);
            plot.draw(&mut svg);
            svg.end_shift();
        }
        svg.finish()
    }

    /// The picture as pixels, half as many again on a side as the SVG has.
    pub fn to_image(&self) -> Image {
        let (width, height) = self.size();
        let Some(mut raster) = Raster::new(width, height) else {
            return Image::of_pixels(0, Vec::new());
        };
        for (plot, (left, top)) in self.plots.iter().zip(self.places()) {
            raster.shift(left, top);
            plot.draw(&mut raster);
        }
        raster.finish()
    }

    fn columns(&self) -> usize {
        self.columns.clamp(1, self.plots.len().max(1))
    }

    fn size(&self) -> (f64, f64) {
        let rows = self.plots.len().div_ceil(self.columns());
        (WIDTH * self.columns() as f64, HEIGHT * rows as f64)
    }

    /// Upper left corners of the plots.
    fn places(&self) -> impl Iterator<Item = (f64, f64)> {
        let columns = self.columns();
        (0..self.plots.len()).map(move |k| (WIDTH * (k % columns) as f64, HEIGHT * (k / columns) as f64))
    }

    /// Writes the picture as an SVG file, whole or not at all.
    pub fn write_svg(&self, path: &Path) -> Result<(), OutputError> {
        write_atomically(path, self.to_svg().as_bytes(), Durability::Kill).map_err(OutputError::io("write", path))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn plots_stand_row_by_row() {
        let plots = ["one", "two", "three"].map(|title| Plot {
            title: title.to_owned(),
            ..Plot::default()
        });
        let svg = Sheet {
            plots: plots.to_vec(),
            columns: 2,
        }
        .to_svg();
        assert!(svg.contains("width=\"1680\" height=\"1120\""));
        for place in ["translate(0 0)", "translate(840 0)", "translate(0 560)"] {
            assert_eq!(svg.matches(place).count(), 1, "{place}");
        }
        assert!(svg.contains(">three<") && svg.trim_end().ends_with("</svg>"));
    }
}
