//! A frame as columns: what is drawn of it, and what its grains and contacts are like.

use super::error::ResultsError;
use super::poly_data::TableFile;
use super::run::{Run, TableKind};
use crate::output::{MATERIAL_NAMES, WALL_NAMES};
use crate::particles::ById;
use glam::DVec3;

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
    /// Magnitudes of the angular velocities [rad/s].
    pub spin: Vec<f64>,
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
    /// Magnitude of the sum of all forces on the grain [N].
    pub total_force: Vec<f64>,
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
        Ok(Self {
            contacts: read_contacts(&mut run.open_table(TableKind::Contacts, step)?)?,
            ..Self::read_grains(run, step)?
        })
    }

    /// Reads the frame of a step, but not its contacts, which are most of it.
    pub fn read_grains(run: &Run, step: u64) -> Result<Self, ResultsError> {
        let mut grains = run.open_table(TableKind::Grains, step)?;
        Ok(Self {
            step,
            time: grains.time(),
            grains: read_grains(&mut grains)?,
            contacts: PackedContacts::default(),
            walls: Self::walls_at(run, step)?,
        })
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
            plain("spin", "rad/s", "magnitude of the angular velocity", g.spin.clone()),
            plain("mean normal stress", "Pa", stress, g.pressure.clone()),
            plain("coordination", "", "contacts that act, walls counted", coordination),
            plain("radius", "m", "", g.radius.clone()),
            plain(
                "total force",
                "N",
                "magnitude of the sum of all forces on the grain",
                g.total_force.clone(),
            ),
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

fn vectors(numbers: &[f64]) -> impl Iterator<Item = DVec3> {
    numbers.as_chunks().0.iter().map(|v| DVec3::from_array(*v))
}

fn read_grains(table: &mut TableFile) -> Result<PackedGrains, ResultsError> {
    let mut magnitudes =
        |name| -> Result<Vec<f64>, ResultsError> { Ok(vectors(&table.floats(name, 3)?).map(DVec3::length).collect()) };
    let (speed, spin) = (magnitudes("velocity")?, magnitudes("angular_velocity")?);
    let total_force = magnitudes("force")?;
    let has_tags = table.names().any(|name| name == "tag");
    Ok(PackedGrains {
        id: table.counts("id")?,
        position: table.points()?,
        radius: table.floats("radius", 1)?,
        speed,
        spin,
        material: table.integers("material")?,
        materials: table.texts(MATERIAL_NAMES).to_vec(),
        coordination: table.counts("coordination")?,
        tag: has_tags.then(|| table.integers("tag")).transpose()?,
        force: table.floats("contact_force", 1)?,
        total_force,
        pressure: table.floats("mean_normal_stress", 1)?,
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
        point: table.points()?,
        total: table.floats("force_magnitude", 1)?,
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
        Packing {
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
        }
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
        assert_eq!(packing.scalars().len(), 8);
    }
}
