//! How many grains are in a zone, and their mass.

use super::told_first::each_grain;
use super::{Selection, ToldColumn, Value, holds};
use crate::particles::{Origins, Zone};
use crate::simulation::Simulation;

/// Columns of a count.
pub const REGION_COLUMNS: &[ToldColumn] = &[
    ToldColumn::new("grains", "", "number of grains whose centres lie in the region"),
    ToldColumn::new("mass", "kg", "their mass"),
];

/// Columns for every material, behind the others; their names begin with that of the material.
pub const OF_MATERIAL_COLUMNS: &[ToldColumn] = &[
    ToldColumn::new("grains", "", "number of grains of the material"),
    ToldColumn::new("mass", "kg", "their mass"),
];

/// Grains in a zone, by material.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RegionCount {
    /// Where they are counted.
    pub zone: Zone,
    /// Which of them.
    pub selection: Selection,
}

impl RegionCount {
    /// Titles of its columns.
    pub fn titles(&self, name: &str, materials: &[&str]) -> Vec<String> {
        let all = REGION_COLUMNS.iter().map(|c| c.title(name));
        let of_material = |material: &&str| {
            let name = format!("{name} {material}");
            OF_MATERIAL_COLUMNS.iter().map(move |c| c.title(&name))
        };
        all.chain(materials.iter().flat_map(of_material)).collect()
    }

    /// Its values now, in the order of the titles. Masses are summed up in the order of the ids.
    pub fn measure(&self, sim: &Simulation, origins: &Origins) -> Vec<Value> {
        let grains = &sim.grains;
        let is_inside = |g: usize| holds(sim, &self.zone, g) && self.selection.holds(grains, origins, g);
        let mut counts = vec![(0u64, 0.0f64); 1 + sim.materials.list().len()];
        let tell = |g: usize| (grains.material[g], grains.mass(g));
        each_grain(sim, is_inside, tell, |_, (material, mass)| {
            for place in [0, 1 + usize::from(material)] {
                counts[place].0 += 1;
                counts[place].1 += mass;
            }
        });
        let values = counts.into_iter().map(|(n, m)| [Value::Count(n), Value::Number(m)]);
        values.flatten().collect()
    }
}
