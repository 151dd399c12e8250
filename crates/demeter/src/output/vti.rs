//! Images of VTK (`.vti`): arrays of the cells of a regular grid.

use super::vtk_file::{ENCODING, NewArray, Writer, in_memory};
use glam::DVec3;
use std::io;

/// A `.vti` file.
pub(super) struct ImageData<'a> {
    /// Steps done.
    pub step: u64,
    /// Simulated time [s].
    pub time: f64,
    /// Lower corner of the grid [m].
    pub lower: DVec3,
    /// Sizes of a cell [m].
    pub spacing: DVec3,
    /// Cells in each direction.
    pub cells: [usize; 3],
    /// Arrays of the cells, x fastest.
    pub cell_data: Vec<NewArray<'a>>,
}

impl ImageData<'_> {
    /// The bytes of the file.
    pub fn encode(self) -> io::Result<Vec<u8>> {
        let mut file = Writer::default();
        let [x, y, z] = self.cells;
        let extent = format!("0 {x} 0 {y} 0 {z}");
        let numbers = |v: DVec3| format!("{:?} {:?} {:?}", v.x, v.y, v.z);
        file.line(&format!("<VTKFile type=\"ImageData\" version=\"1.0\" {ENCODING}>"));
        file.line(&format!(
            "<ImageData WholeExtent=\"{extent}\" Origin=\"{}\" Spacing=\"{}\">",
            numbers(self.lower),
            numbers(self.spacing)
        ));
        file.field_data((self.step, self.time), &[], &[]);
        file.line(&format!("<Piece Extent=\"{extent}\">\n<PointData>\n</PointData>"));
        let count = x * y * z;
        file.arrays("CellData", self.cell_data.into_iter().map(|array| (count, array)));
        file.line("</Piece>\n</ImageData>");
        in_memory(|out| file.finish(out))
    }
}
