//! Force chains: one `.vtp` file of lines for every frame, and a collection of them.

use super::collection::Collection;
use super::error::OutputError;
use super::folder::RunFolder;
use super::vtk_file::{NewArray, NewPolyData};
use super::vtp::Cells;
use crate::measure::ChainLink;

/// Writes the force chains of a measure.
#[derive(Debug)]
pub struct ChainWriter {
    folder: RunFolder,
    collection: Collection,
}

impl ChainWriter {
    /// Starts without files, or goes on after a step.
    pub fn open(folder: &RunFolder, measure: &str, after: Option<u64>) -> Result<Self, OutputError> {
        let mut collection = Collection::of_chains(folder, measure);
        match after {
            None => collection.save(folder)?,
            Some(step) => {
                collection.load()?;
                collection.cut(folder, step)?;
            }
        }
        Ok(Self {
            folder: folder.clone(),
            collection,
        })
    }

    /// Writes the lines of a moment.
    pub fn write(&mut self, (step, time): (u64, f64), links: &[ChainLink]) -> Result<(), OutputError> {
        let path = self.collection.file_path(step);
        let data = NewPolyData {
            step,
            time,
            texts: Vec::new(),
            fields: Vec::new(),
            count: 2 * links.len(),
            points: Box::new(links.iter().flat_map(|link| [link.from, link.to])),
            cells: Cells::Lines(vec![2; links.len()]),
            point_data: Vec::new(),
            cell_data: vec![
                NewArray::counts("id_i", links.iter().map(|link| link.ids[0])),
                NewArray::counts("id_j", links.iter().map(|link| link.ids[1])),
                NewArray::integers("wall", links.iter().map(|link| link.wall)),
                NewArray::vectors("force", links.iter().map(|link| link.force)),
                NewArray::scalars("normal_force", links.iter().map(|link| link.normal_force)),
                NewArray::scalars("force_magnitude", links.iter().map(|link| link.force.length())),
                NewArray::integers("strong", links.iter().map(|link| i32::from(link.is_strong))),
            ],
        };
        self.folder.write_with(&path, |file| data.write(file))?;
        self.collection.add(step, time);
        self.collection.save(&self.folder)
    }
}
