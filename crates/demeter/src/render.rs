//! Pictures of the frames that a run left.

use crate::materials::Material;
use crate::measure::ContactsAt;
pub use crate::output::picture::Cut;
use crate::output::picture::{Image, PictureOptions, colour_range, render_packing, shown_region};
use crate::output::vtp::{PolyData, Values};
use crate::output::{ContactRecord, Frame, FramePart, MATERIAL_NAMES, WALL_NAMES, WallSurface};
use crate::particles::{Grains, Rows};
use crate::results::{ResultsError, Run, TableFile, TableKind};
use glam::{DVec3, Vec3};
use std::str::FromStr;

/// A cut that is not understood.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("`{text}` is no cut; tell what is left out, as `y > 10 mm` or `x < 0 m`")]
pub struct UnknownCut {
    text: String,
}

impl FromStr for Cut {
    type Err = UnknownCut;

    fn from_str(text: &str) -> Result<Self, UnknownCut> {
        let unknown = || UnknownCut {
            text: text.chars().take(60).collect(),
        };
        let (name, rest) = text.split_once(['<', '>']).ok_or_else(unknown)?;
        let axis = ["x", "y", "z"]
            .iter()
            .position(|axis| *axis == name.trim())
            .ok_or_else(unknown)?;
        let quantity = crate::scenario::units::parse(rest).map_err(|_| unknown())?;
        if quantity.dimension != demeter_physics::dimension::Dimension::LENGTH || !quantity.value.is_finite() {
            return Err(unknown());
        }
        Ok(Self {
            axis,
            above: text.contains('>'),
            at: quantity.value,
        })
    }
}

/// A frame of a run, in memory.
#[derive(Clone, Debug, Default)]
pub struct LoadedFrame {
    step: u64,
    time: f64,
    grains: Grains,
    materials: Vec<Material>,
    contacts: Vec<ContactRecord>,
    walls: Vec<(String, Vec<[DVec3; 3]>)>,
    tags: Option<Vec<i32>>,
}

impl LoadedFrame {
    /// Reads the frame of a step.
    pub fn read(run: &Run, step: u64) -> Result<Self, ResultsError> {
        let mut file = run.open_table(TableKind::Grains, step)?;
        let mut frame = Self {
            step: file.step(),
            time: file.time(),
            ..Self::default()
        };
        frame.read_grains(&mut file)?;
        frame.read_contacts(&mut run.open_table(TableKind::Contacts, step)?)?;
        frame.read_walls(&run.table(TableKind::Walls, step)?);
        Ok(frame)
    }

    fn read_grains(&mut self, file: &mut TableFile) -> Result<(), ResultsError> {
        let (ids, materials) = (file.counts("id")?, file.integers("material")?);
        let (radii, masses) = (file.floats("radius", 1)?, file.floats("mass", 1)?);
        let places = file.points()?;
        let (velocities, spins) = (vectors(file, "velocity")?, vectors(file, "angular_velocity")?);
        for (k, place) in places.iter().enumerate() {
            self.grains.id.push(ids[k]);
            self.grains
                .material
                .push(u16::try_from(materials[k]).unwrap_or(u16::MAX));
            self.grains.position.push(*place, radii[k]);
            self.grains.velocity.push(velocities[k], 0.0);
            self.grains.angular_velocity.push(spins[k], 0.0);
        }
        let has_tags = file.names().any(|name| name == "tag");
        self.tags = has_tags.then(|| file.integers("tag")).transpose()?;
        self.grains.load = Rows::zeros(self.grains.len());
        for (k, mass) in masses.into_iter().enumerate() {
            self.grains.set_size(k, radii[k], mass);
        }
        let material = |name: &String| Material {
            name: name.clone(),
            young_modulus: f64::NAN,
            poisson_ratio: f64::NAN,
            density: f64::NAN,
        };
        self.materials = file.texts(MATERIAL_NAMES).iter().map(material).collect();
        Ok(())
    }

    fn read_contacts(&mut self, file: &mut TableFile) -> Result<(), ResultsError> {
        let (id_i, id_j, element) = (file.counts("id_i")?, file.counts("id_j")?, file.counts("element")?);
        let (wall, overlap) = (file.integers("wall")?, file.floats("overlap", 1)?);
        let (position, normal) = (file.points()?, vectors(file, "normal")?);
        let (push, drag) = (vectors(file, "normal_force")?, vectors(file, "tangential_force")?);
        self.contacts = (0..position.len())
            .map(|k| ContactRecord {
                id_i: id_i[k],
                id_j: id_j[k],
                wall: wall[k],
                element: element[k],
                position: position[k],
                normal: normal[k],
                overlap: overlap[k],
                push: push[k].dot(normal[k]) as f32,
                drag: drag[k].as_vec3(),
                torque: Vec3::ZERO,
            })
            .collect();
        Ok(())
    }

    fn read_walls(&mut self, table: &PolyData) {
        let names = table.texts_of(WALL_NAMES);
        self.walls = names.iter().map(|name| (name.clone(), Vec::new())).collect();
        let Some(Values::Int32(walls)) = table.of_cells("wall").map(|array| &array.values) else {
            return;
        };
        for (wall, corners) in walls.iter().zip(table.points.as_chunks::<3>().0) {
            if let Some((_, triangles)) = usize::try_from(*wall).ok().and_then(|k| self.walls.get_mut(k)) {
                triangles.push(*corners);
            }
        }
    }

    /// Draws it.
    pub fn picture(&self, options: &PictureOptions) -> Image {
        self.with_frame(|frame| render_packing(frame, options))
    }

    /// The start and end of the colour bar, in SI, for other frames.
    pub fn colour_range(&self, options: &PictureOptions) -> Option<(f64, f64)> {
        self.with_frame(|frame| colour_range(frame, options))
    }

    /// Whether the cuts leave some of a grain, or there is none to leave.
    pub fn shows_grains(&self, options: &PictureOptions) -> bool {
        let rows = self.grains.position.rows();
        let keeps_some = |cut: &Cut, (centre, radius)| cut.keeps_some(centre, radius);
        let is_shown = |sphere| options.cuts.iter().all(|cut| keeps_some(cut, sphere));
        rows.is_empty() || rows.iter().any(|row| is_shown((row.vector, row.scalar)))
    }

    /// What a picture of it shows: lower and upper corner [m].
    pub fn region(&self, options: &PictureOptions) -> (DVec3, DVec3) {
        self.with_frame(|frame| shown_region(frame, options))
    }

    fn with_frame<T>(&self, look: impl FnOnce(&Frame) -> T) -> T {
        let walls: Vec<WallSurface> = (self.walls.iter())
            .map(|(name, triangles)| WallSurface {
                name,
                triangles: triangles.clone(),
                force: DVec3::ZERO,
                torque: DVec3::ZERO,
                velocities: Vec::new(),
                records: None,
            })
            .collect();
        look(&Frame {
            step: self.step,
            time: self.time,
            grains: &self.grains,
            materials: &self.materials,
            contacts: ContactsAt::List(&self.contacts),
            walls: &walls,
            tags: self.tags.clone(),
            cell: None,
            part: FramePart::default(),
        })
    }
}

fn vectors(file: &mut TableFile, name: &str) -> Result<Vec<DVec3>, ResultsError> {
    let numbers = file.floats(name, 3)?;
    Ok(numbers.as_chunks().0.iter().map(|v| DVec3::from_array(*v)).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cuts_are_told_in_words() {
        let cut: Cut = "y > 10 mm".parse().unwrap();
        assert_eq!(
            cut,
            Cut {
                axis: 1,
                above: true,
                at: 0.01
            }
        );
        let cut: Cut = "x<-1 m".parse().unwrap();
        assert_eq!(
            cut,
            Cut {
                axis: 0,
                above: false,
                at: -1.0
            }
        );
        for wrong in ["", "y", "w > 1 m", "y > 1", "y > 1 kg", "y > mm", "> 1 m"] {
            let found = wrong.parse::<Cut>().unwrap_err().to_string();
            assert!(found.contains("as `y > 10 mm`"), "{found}");
        }
    }
}
