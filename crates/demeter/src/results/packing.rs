//! A frame as columns: what is drawn of it, and what its grains and contacts are like.

use super::error::ResultsError;
use super::poly_data::TableFile;
use super::run::{Run, TableKind};
use crate::output::{MATERIAL_NAMES, WALL_NAMES};
use glam::DVec3;
use std::f64::consts::PI;

/// A frame, as columns.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Packing {
    /// Steps done.
    pub step: u64,
    /// Simulated time [s].
    pub time: f64,
    /// The grains.
    pub grains: PackedGrains,
    /// The contacts that act.
    pub contacts: PackedContacts,
    /// The walls.
    pub walls: Vec<PackedWall>,
}

/// Grains, as columns.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PackedGrains {
    /// Ids, which never change.
    pub id: Vec<u32>,
    /// Centres [m].
    pub position: Vec<DVec3>,
    /// Radii [m].
    pub radius: Vec<f64>,
    /// Speeds [m/s].
    pub speed: Vec<f64>,
    /// Indices of the materials.
    pub material: Vec<i32>,
    /// Names of the materials.
    pub materials: Vec<String>,
    /// Contacts that act, walls counted.
    pub coordination: Vec<u32>,
    /// Tags; nothing where no grain has one.
    pub tag: Option<Vec<i32>>,
    /// Sum of the magnitudes of the normal forces on the grain [N].
    pub force: Vec<f64>,
    /// Mean normal stress [Pa].
    pub pressure: Vec<f64>,
}

/// Contacts, as columns.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PackedContacts {
    /// Id of the first grain.
    pub id_i: Vec<u32>,
    /// Id of the second grain; 0 where it is a wall.
    pub id_j: Vec<u32>,
    /// Index of the wall; -1 between grains.
    pub wall: Vec<i32>,
    /// Contact points [m].
    pub point: Vec<DVec3>,
    /// Unit normals, towards the first grain.
    pub direction: Vec<DVec3>,
    /// Overlaps [m].
    pub overlap: Vec<f64>,
    /// Normal forces, repulsion positive [N].
    pub normal: Vec<f64>,
    /// Magnitudes of the forces [N].
    pub total: Vec<f64>,
}

/// A wall.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PackedWall {
    /// Its index.
    pub index: i32,
    /// Its name in the scenario.
    pub name: String,
    /// Its surface [m].
    pub triangles: Vec<[DVec3; 3]>,
}

/// What grains can be coloured by.
#[derive(Clone, Debug, PartialEq)]
pub struct Scalar<'p> {
    /// Its name.
    pub name: &'static str,
    /// Its unit; empty for what has none.
    pub unit: &'static str,
    /// What it is, where the name does not say it.
    pub meaning: &'static str,
    /// A value for every grain.
    pub values: Vec<f64>,
    /// Names of the categories, where it is one: value `k` is called `names[k]`.
    pub names: Option<&'p [String]>,
    /// Whether its values are whole numbers that stand for something.
    pub is_label: bool,
}

impl Packing {
    /// Reads the frame of a step.
    pub fn read(run: &Run, step: u64) -> Result<Self, ResultsError> {
        let mut packing = Self::read_grains(run, step)?;
        let mut table = run.open_table(TableKind::Contacts, step)?;
        packing.contacts.point = table.points()?;
        packing.contacts.total = table.floats("force_magnitude", 1)?;
        Ok(packing)
    }

    /// Reads the frame of a step, but not where its contacts are and how large their total forces: that is half of a frame.
    pub fn read_grains(run: &Run, step: u64) -> Result<Self, ResultsError> {
        let mut grains = run.open_table(TableKind::Grains, step)?;
        let mut packing = Self {
            step,
            time: grains.time(),
            grains: read_grains(&mut grains)?,
            contacts: read_contacts(&mut run.open_table(TableKind::Contacts, step)?)?,
            walls: read_walls(&mut run.open_table(TableKind::Walls, step)?)?,
        };
        packing.sum_over_contacts();
        Ok(packing)
    }

    /// Reads the latest frame that is whole; nothing where there is none.
    pub fn latest(run: &Run) -> Result<Option<Self>, ResultsError> {
        let last = run.moments()?.last().copied();
        last.map(|moment| Self::read(run, moment.step)).transpose()
    }

    /// Reads only the walls of the frame of a step.
    pub fn walls_at(run: &Run, step: u64) -> Result<Vec<PackedWall>, ResultsError> {
        read_walls(&mut run.open_table(TableKind::Walls, step)?)
    }

    /// Forces and stresses of grains.
    ///
    /// The mean normal stress of a grain of volume `V` is `sum(f_n l) / (3 V)` over its contacts, with the normal force
    /// `f_n` (repulsion positive) and the distance `l` from the centre to the contact: `r - overlap / 2` between grains,
    /// `r - overlap` at a wall. It is the mean over the grain's volume of a third of the trace of the stress (J. Weber,
    /// Bulletin de Liaison des Ponts et Chaussees 20, 1966); friction, which is perpendicular to `l`, gives nothing to it.
    fn sum_over_contacts(&mut self) {
        let by_id = ById::new(&self.grains.id);
        let n = self.grains.id.len();
        let (mut force, mut virial) = (vec![0.0; n], vec![0.0; n]);
        let c = &self.contacts;
        for k in 0..c.id_i.len() {
            let (ids, depth): (&[u32], f64) = match c.wall[k] < 0 {
                true => (&[c.id_i[k], c.id_j[k]], 0.5 * c.overlap[k]),
                false => (&[c.id_i[k]], c.overlap[k]),
            };
            for at in ids.iter().filter_map(|id| by_id.find(*id)) {
                force[at] += c.normal[k].abs();
                virial[at] += c.normal[k] * (self.grains.radius[at] - depth);
            }
        }
        let volume = |r: f64| 4.0 / 3.0 * PI * r * r * r;
        let radii = self.grains.radius.iter();
        self.grains.pressure = virial
            .iter()
            .zip(radii)
            .map(|(sum, r)| sum / (3.0 * volume(*r)))
            .collect();
        self.grains.force = force;
    }

    /// The overlap of every contact as a share of the smaller radius.
    pub fn relative_overlaps(&self) -> Vec<f64> {
        let by_id = ById::new(&self.grains.id);
        let c = &self.contacts;
        let radius = |id: u32| by_id.find(id).map_or(f64::NAN, |at| self.grains.radius[at]);
        let smaller = |k: usize| match c.wall[k] < 0 {
            true => radius(c.id_i[k]).min(radius(c.id_j[k])),
            false => radius(c.id_i[k]),
        };
        (0..c.id_i.len()).map(|k| c.overlap[k] / smaller(k)).collect()
    }

    /// From where to where the force of every contact is drawn [m]: from the centre of the first grain to that of the second,
    /// where its image is when the contact goes through a side of a periodic box, or to the point on the wall.
    pub fn ends(&self) -> Vec<[DVec3; 2]> {
        let by_id = ById::new(&self.grains.id);
        let (g, c) = (&self.grains, &self.contacts);
        let ends = |k: usize| {
            let Some(i) = by_id.find(c.id_i[k]) else {
                return [c.point[k]; 2];
            };
            let from = g.position[i];
            match by_id.find(c.id_j[k]).filter(|_| c.wall[k] < 0) {
                Some(j) => [from, from - (g.radius[i] + g.radius[j] - c.overlap[k]) * c.direction[k]],
                None => [from, c.point[k]],
            }
        };
        (0..c.id_i.len()).map(ends).collect()
    }

    /// What the grains can be coloured by.
    pub fn scalars(&self) -> Vec<Scalar<'_>> {
        let g = &self.grains;
        let plain = |name, unit, meaning, values| Scalar {
            name,
            unit,
            meaning,
            values,
            names: None,
            is_label: false,
        };
        let whole = |values: &[i32]| values.iter().map(|k| f64::from(*k)).collect();
        let force = "sum of the magnitudes of the normal forces on the grain";
        let stress = "of the grain, from its contacts; compression positive";
        let coordination = g.coordination.iter().map(|z| f64::from(*z)).collect();
        let mut scalars = vec![
            plain("contact force", "N", force, g.force.clone()),
            plain("speed", "m/s", "", g.speed.clone()),
            plain("mean normal stress", "Pa", stress, g.pressure.clone()),
            plain("coordination", "", "contacts that act, walls counted", coordination),
            plain("radius", "m", "", g.radius.clone()),
            Scalar {
                names: Some(&g.materials),
                is_label: true,
                ..plain("material", "", "", whole(&g.material))
            },
        ];
        if let Some(tag) = &g.tag {
            scalars.push(Scalar {
                is_label: true,
                ..plain("tag", "", "", whole(tag))
            });
        }
        scalars
    }
}

/// Finds grains by their ids.
enum ById {
    /// Places, from 1, by id; 0 where no grain has it.
    Listed(Vec<usize>),
    /// Ids and places in order, where few of many ids are there.
    Sorted(Vec<(u32, usize)>),
}

impl ById {
    fn new(ids: &[u32]) -> Self {
        let largest = ids.iter().copied().max().unwrap_or(0) as usize;
        if largest / 8 <= ids.len() {
            let mut places = vec![0; largest + 1];
            for (id, place) in ids.iter().zip(1..) {
                places[*id as usize] = place;
            }
            return Self::Listed(places);
        }
        let mut by_id: Vec<(u32, usize)> = ids.iter().copied().zip(0..).collect();
        by_id.sort_unstable();
        Self::Sorted(by_id)
    }

    fn find(&self, id: u32) -> Option<usize> {
        match self {
            Self::Listed(places) => places.get(id as usize)?.checked_sub(1),
            Self::Sorted(by_id) => {
                let at = by_id.binary_search_by_key(&id, |&(id, _)| id);
                at.ok().map(|at| by_id[at].1)
            }
        }
    }
}

fn vectors(numbers: &[f64]) -> impl Iterator<Item = DVec3> {
    numbers.as_chunks().0.iter().map(|v| DVec3::from_array(*v))
}

fn read_grains(table: &mut TableFile) -> Result<PackedGrains, ResultsError> {
    let velocity = table.floats("velocity", 3)?;
    let has_tags = table.names().any(|name| name == "tag");
    Ok(PackedGrains {
        id: table.counts("id")?,
        position: table.points()?,
        radius: table.floats("radius", 1)?,
        speed: vectors(&velocity).map(DVec3::length).collect(),
        material: table.integers("material")?,
        materials: table.texts(MATERIAL_NAMES).to_vec(),
        coordination: table.counts("coordination")?,
        tag: has_tags.then(|| table.integers("tag")).transpose()?,
        ..PackedGrains::default()
    })
}

fn read_contacts(table: &mut TableFile) -> Result<PackedContacts, ResultsError> {
    let direction: Vec<DVec3> = vectors(&table.floats("normal", 3)?).collect();
    let force = table.floats("normal_force", 3)?;
    Ok(PackedContacts {
        id_i: table.counts("id_i")?,
        id_j: table.counts("id_j")?,
        wall: table.integers("wall")?,
        overlap: table.floats("overlap", 1)?,
        normal: direction.iter().zip(vectors(&force)).map(|(n, f)| n.dot(f)).collect(),
        direction,
        ..PackedContacts::default()
    })
}

fn read_walls(table: &mut TableFile) -> Result<Vec<PackedWall>, ResultsError> {
    let (points, index) = (table.points()?, table.integers("wall")?);
    let names = table.texts(WALL_NAMES);
    let mut walls: Vec<PackedWall> = Vec::new();
    for (triangle, index) in points.as_chunks::<3>().0.iter().zip(index) {
        if walls.last().is_none_or(|wall| wall.index != index) {
            let name = usize::try_from(index).ok().and_then(|k| names.get(k));
            walls.push(PackedWall {
                index,
                name: name.cloned().unwrap_or_else(|| format!("wall {index}")),
                triangles: Vec::new(),
            });
        }
        if let Some(wall) = walls.last_mut() {
            wall.triangles.push(*triangle);
        }
    }
    Ok(walls)
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Grain 7 (r = 2) rests on wall 0 and carries grain 3 (r = 1).
    fn two_grains() -> Packing {
        let mut packing = Packing {
            grains: PackedGrains {
                id: vec![7, 3],
                position: vec![DVec3::new(0.0, 0.0, 1.9), DVec3::new(0.0, 0.0, 4.7)],
                radius: vec![2.0, 1.0],
                ..PackedGrains::default()
            },
            contacts: PackedContacts {
                id_i: vec![3, 7],
                id_j: vec![7, 0],
                wall: vec![-1, 0],
                point: vec![DVec3::new(0.0, 0.0, 3.8), DVec3::ZERO],
                direction: vec![DVec3::Z; 2],
                overlap: vec![0.2, 0.1],
                normal: vec![10.0, 30.0],
                ..PackedContacts::default()
            },
            ..Packing::default()
        };
        packing.sum_over_contacts();
        packing
    }

    #[test]
    fn stress_and_force_count_every_contact_of_a_grain() {
        let packing = two_grains();
        assert_eq!(packing.grains.force, [40.0, 10.0]);
        let volume = |r: f64| 4.0 / 3.0 * PI * r.powi(3);
        let expected = (10.0 * 1.9 + 30.0 * 1.9) / (3.0 * volume(2.0));
        assert_relative_eq!(packing.grains.pressure[0], expected, max_relative = 1e-14);
        assert_relative_eq!(
            packing.grains.pressure[1],
            10.0 * 0.9 / (3.0 * volume(1.0)),
            max_relative = 1e-14
        );
    }

    #[test]
    fn grains_are_found_among_many_and_among_few_ids() {
        for ids in [vec![3, 1, 2, 0], vec![7, 4_000_000_000, 3]] {
            let by_id = ById::new(&ids);
            for (place, id) in ids.iter().enumerate() {
                assert_eq!(by_id.find(*id), Some(place));
            }
            assert_eq!((by_id.find(5), by_id.find(u32::MAX)), (None, None));
        }
        assert_eq!(ById::new(&[]).find(0), None);
    }

    #[test]
    fn overlaps_are_shares_of_the_smaller_radius() {
        assert_eq!(two_grains().relative_overlaps(), [0.2, 0.05]);
    }

    #[test]
    fn forces_are_drawn_from_centre_to_centre_or_wall() {
        let mut packing = two_grains();
        let [pair, wall] = packing.ends()[..] else { panic!() };
        assert_relative_eq!(pair[1].z, 1.9, max_relative = 1e-14);
        assert_eq!((pair[0].z, wall), (4.7, [DVec3::new(0.0, 0.0, 1.9), DVec3::ZERO]));
        // a partner beyond the side of a periodic box is drawn where its image is
        packing.grains.position[0].z += 100.0;
        assert_relative_eq!(packing.ends()[0][1].z, 1.9, max_relative = 1e-14);
        assert_eq!(packing.scalars().len(), 6);
    }
}
