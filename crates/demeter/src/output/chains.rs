//! Force chains: one `.vtp` file of lines for every frame, and a collection of them.

use super::collection::Collection;
use super::error::OutputError;
use super::folder::RunFolder;
use super::vtp::{Array, Cells, PolyData, Values};
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
        let ids = |k: usize| Values::UInt32(links.iter().map(|link| link.ids[k]).collect());
        let walls = links.iter().map(|link| link.wall).collect();
        let strong = links.iter().map(|link| i32::from(link.is_strong)).collect();
        let data = PolyData {
            step,
            time,
            texts: Vec::new(),
            fields: Vec::new(),
            points: links.iter().flat_map(|link| [link.from, link.to]).collect(),
            cells: Cells::Lines(vec![2; links.len()]),
            point_data: Vec::new(),
            cell_data: vec![
                Array::new("id_i", 1, ids(0)),
                Array::new("id_j", 1, ids(1)),
                Array::new("wall", 1, Values::Int32(walls)),
                Array::vectors("force", links.iter().map(|link| &link.force)),
                Array::scalars("normal_force", links.iter().map(|link| link.normal_force)),
                Array::scalars("force_magnitude", links.iter().map(|link| link.force.length())),
                Array::new("strong", 1, Values::Int32(strong)),
            ],
        };
        let bytes = data.encode().map_err(|e| OutputError::encode(&path, &e))?;
        self.folder.write(&path, &bytes)?;
        self.collection.add(step, time);
        self.collection.save(&self.folder)
    }
}
