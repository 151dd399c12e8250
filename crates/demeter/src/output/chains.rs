//! Force chains: one `.vtp` file of lines for every frame, and a collection of them.

use super::collection::Collection;
use super::error::OutputError;
use super::folder::RunFolder;
use super::vtk_file::{NewArray, NewPolyData};
use super::vtp::Cells;
use crate::measure::ChainLinks;

/// Writes the force chains of a measure.
#[derive(Debug)]
pub struct ChainWriter {
    folder: RunFolder,
    collection: Collection,
}

impl ChainWriter {
    /// Starts without files, or goes on after a step; tells what is gone, as warnings.
    pub fn open(folder: &RunFolder, measure: &str, after: Option<u64>) -> Result<(Self, Vec<String>), OutputError> {
        let mut collection = Collection::of_chains(folder, measure);
        let warnings = collection.open(folder, after)?;
        let writer = Self {
            folder: folder.clone(),
            collection,
        };
        Ok((writer, warnings))
    }

    /// Writes the lines of a moment. Of several processes that have them together the first does; others [`tell`](tell_chains) it.
    pub fn write(&mut self, (step, time): (u64, f64), links: &ChainLinks<'_>) -> Result<(), OutputError> {
        let path = self.collection.file_path(step);
        let data = poly_data((step, time), links);
        self.folder.write_with(&path, |file| data.write(file))?;
        self.collection.add(step, time);
        self.collection.save(&self.folder)
    }
}

/// Tells the first process the own lines, as it writes them.
pub fn tell_chains(links: &ChainLinks<'_>) {
    poly_data((0, 0.0), links).pass();
}

fn poly_data<'a>((step, time): (u64, f64), links: &'a ChainLinks<'_>) -> NewPolyData<'a> {
    let count = links.count();
    NewPolyData {
        step,
        time,
        texts: Vec::new(),
        fields: Vec::new(),
        count: 2 * count,
        points: Box::new(links.each(|link| [link.from, link.to]).flatten()),
        cells: Cells::Lines(vec![2; count]),
        point_data: Vec::new(),
        cell_data: vec![
            NewArray::counts("id_i", links.each(|link| link.ids[0])),
            NewArray::counts("id_j", links.each(|link| link.ids[1])),
            NewArray::integers("wall", links.each(|link| link.wall)),
            NewArray::vectors("force", links.each(|link| link.force)),
            NewArray::scalars("normal_force", links.each(|link| link.normal_force)),
            NewArray::scalars("force_magnitude", links.each(|link| link.force.length())),
            NewArray::integers("strong", links.each(|link| i32::from(link.is_strong))),
        ],
    }
}
