//! Several plots in one picture.

use super::{HEIGHT, Plot, WIDTH, document, put};
use crate::checkpoint::{Durability, write_atomically};
use crate::output::OutputError;
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
        let columns = self.columns.clamp(1, self.plots.len().max(1));
        let rows = self.plots.len().div_ceil(columns);
        let mut svg = document(WIDTH * columns as f64, HEIGHT * rows as f64);
        for (k, plot) in self.plots.iter().enumerate() {
            let (left, top) = (WIDTH * (k % columns) as f64, HEIGHT * (k / columns) as f64);
            put(&mut svg, format_args!("<g transform=\"translate({left} {top})\">"));
            plot.draw(&mut svg);
            svg.push_str("</g>\n");
        }
        svg.push_str("</svg>\n");
        svg
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
