//! Frames for ParaView, PyVista and OVITO: one `.vtp` file each for grains, contacts and walls, and collections that
//! tell the time of every file.
//!
//! | file | one element is | arrays |
//! |---|---|---|
//! | `grains` | a point at the centre of a grain | `id`, `material`, `radius` and `diameter` [m], `mass` [kg], `velocity` [m/s], `angular_velocity` [1/s], `orientation` (quaternion x, y, z, w), `force` [N], `torque` [N m], `coordination` (contacts that act, walls counted), `contact_force` [N] (sum of the magnitudes of their normal forces), `mean_normal_stress` [Pa] (from them, compression positive), `tag` where grains have tags |
//! | `contacts` | a point at the contact, of those that act: their normal force is not 0 | `id_i`, `id_j` (0: wall), `wall` (-1: none), `element`, `normal` (towards i), `overlap` [m], `normal_force`, `tangential_force` and their vector sum `force` [N], all on i, `normal_force_magnitude`, `force_magnitude` [N], `rolling_torque` [N m] |
//! | `walls` | a triangle of the surface | `wall` (index), `force` [N] and `torque` [N m] of the grains on the whole wall, `velocity` [m/s]; where a wall records loads or wear, of the element (triangle of a mesh, face of a box, else all of the wall) `mean_force` [N], `pressure` and `shear_stress` [Pa], means since the last frame; `impact_energy` and `sliding_energy` [J] and `wear_depth` [m] since the start |
//!
//! Every file carries `TimeValue` [s] and `step`; `grains` the names of the materials and, where there is a domain, `box` (its lower corner
//! and three edges [m], as they are at that moment) and `box_periodic`; `walls` the names of
//! the walls; `contacts` the mean magnitude of the normal forces `mean_normal_force` [N].

use super::collection::Collection;
use super::error::OutputError;
use super::folder::RunFolder;
use super::frame::{Frame, FrameBox};
use super::vtp::{Array, Cells, PolyData, Values};
use crate::walls::ElementRecord;
use glam::DVec3;

/// Writes frames into the folder of a run.
#[derive(Debug)]
pub struct FrameWriter {
    folder: RunFolder,
    collections: [Collection; 3],
}

/// What the three files of a frame are called.
pub(crate) const KINDS: [&str; 3] = ["grains", "contacts", "walls"];
/// Name of the texts that a file of grains carries.
pub const MATERIAL_NAMES: &str = "material_names";
/// Name of the box that a file of grains carries: its lower corner, then its three edges [m].
pub const BOX: &str = "box";
/// Name of the flags that tell which sides of the box are periodic.
pub const BOX_PERIODIC: &str = "box_periodic";
/// Name of the mean magnitude of the normal forces that a file of contacts carries [N].
pub const MEAN_NORMAL_FORCE: &str = "mean_normal_force";
/// Name of the texts that a file of walls carries.
pub const WALL_NAMES: &str = "wall_names";

impl FrameWriter {
    /// Starts with no frame.
    pub fn create(folder: &RunFolder) -> Result<Self, OutputError> {
        let collections = KINDS.map(|kind| Collection::new(folder, kind));
        for collection in &collections {
            collection.save(folder)?;
        }
        Ok(Self {
            folder: folder.clone(),
            collections,
        })
    }

    /// Goes on after a step: later frames are taken out of the collections and their files removed.
    pub fn resume(folder: &RunFolder, step: u64) -> Result<Self, OutputError> {
        let mut collections = KINDS.map(|kind| Collection::new(folder, kind));
        for collection in &mut collections {
            collection.load()?;
            collection.cut(folder, step)?;
        }
        Ok(Self {
            folder: folder.clone(),
            collections,
        })
    }

    /// Writes a frame. A frame of the same step is replaced.
    pub fn write(&mut self, frame: &Frame) -> Result<(), OutputError> {
        let files = [grains(frame), contacts(frame), walls(frame)];
        for (collection, data) in self.collections.iter_mut().zip(files) {
            let path = collection.file_path(frame.step);
            let bytes = data.encode().map_err(|e| OutputError::encode(&path, &e))?;
            self.folder.write(&path, &bytes)?;
            collection.add(frame.step, frame.time);
        }
        // The collections come last, so that none names a file that is not there.
        for collection in &self.collections {
            collection.save(&self.folder)?;
        }
        Ok(())
    }

    /// Number of frames.
    pub fn len(&self) -> usize {
        self.collections[0].len()
    }

    /// Whether there is no frame yet.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

/// A box as arrays of the whole file.
pub(crate) fn box_fields(cell: &FrameBox) -> [Array; 2] {
    let rows = std::iter::once(&cell.corner).chain(&cell.edges);
    let periodic = cell.periodic.iter().map(|periodic| i32::from(*periodic)).collect();
    [
        Array::vectors(BOX, rows),
        Array::new(BOX_PERIODIC, 1, Values::Int32(periodic)),
    ]
}

/// The table of the grains.
pub(crate) fn grains(frame: &Frame) -> PolyData {
    let g = frame.grains;
    let sums = frame.contact_sums();
    let materials = g.material.iter().map(|&m| i32::from(m)).collect();
    let orientations = g.orientation.iter().flat_map(|q| q.to_array()).collect();
    let mut point_data = vec![
        Array::new("id", 1, Values::UInt32(g.id.clone())),
        Array::new("material", 1, Values::Int32(materials)),
        Array::scalars("radius", g.radii()),
        Array::scalars("diameter", g.radii().map(|r| 2.0 * r)),
        Array::scalars("mass", g.mass.iter().copied()),
        Array::vectors("velocity", g.velocity.iter()),
        Array::vectors("angular_velocity", g.angular_velocity.iter()),
        Array::new("orientation", 4, Values::Float64(orientations)),
        Array::vectors("force", g.force.iter()),
        Array::vectors("torque", g.torque.iter()),
        Array::new("coordination", 1, Values::UInt32(sums.coordination)),
        Array::scalars("contact_force", sums.force),
        Array::scalars("mean_normal_stress", sums.stress),
    ];
    if let Some(tags) = &frame.tags {
        point_data.push(Array::new("tag", 1, Values::Int32(tags.clone())));
    }
    PolyData {
        step: frame.step,
        time: frame.time,
        texts: vec![(
            MATERIAL_NAMES.into(),
            frame.materials.iter().map(|m| m.name.clone()).collect(),
        )],
        fields: frame.cell.iter().flat_map(box_fields).collect(),
        points: g.position.iter().copied().collect(),
        cells: Cells::Vertices,
        point_data,
        cell_data: Vec::new(),
    }
}

/// The table of the contacts.
pub(crate) fn contacts(frame: &Frame) -> PolyData {
    let c = frame.contacts;
    let forces: Vec<DVec3> = c.iter().map(|k| k.normal_force + k.tangential_force).collect();
    let sum: f64 = c.iter().map(|k| k.repulsion().abs()).sum();
    let mean = sum / c.len().max(1) as f64;
    PolyData {
        step: frame.step,
        time: frame.time,
        texts: Vec::new(),
        fields: vec![Array::scalars(MEAN_NORMAL_FORCE, [mean])],
        points: c.iter().map(|k| k.position).collect(),
        cells: Cells::Vertices,
        point_data: vec![
            Array::new("id_i", 1, Values::UInt32(c.iter().map(|k| k.id_i).collect())),
            Array::new("id_j", 1, Values::UInt32(c.iter().map(|k| k.id_j).collect())),
            Array::new("wall", 1, Values::Int32(c.iter().map(|k| k.wall).collect())),
            Array::new("element", 1, Values::UInt32(c.iter().map(|k| k.element).collect())),
            Array::vectors("normal", c.iter().map(|k| &k.normal)),
            Array::scalars("overlap", c.iter().map(|k| k.overlap)),
            Array::vectors("normal_force", c.iter().map(|k| &k.normal_force)),
            Array::vectors("tangential_force", c.iter().map(|k| &k.tangential_force)),
            Array::vectors("force", &forces),
            Array::scalars("normal_force_magnitude", c.iter().map(|k| k.normal_force.length())),
            Array::scalars("force_magnitude", forces.iter().map(|f| f.length())),
            Array::vectors("rolling_torque", c.iter().map(|k| &k.rolling_torque)),
        ],
        cell_data: Vec::new(),
    }
}

/// The table of the walls.
pub(crate) fn walls(frame: &Frame) -> PolyData {
    let cells = || {
        (0..)
            .zip(frame.walls)
            .flat_map(|(index, wall)| wall.triangles.iter().map(move |t| (index, wall, t)))
    };
    let mut cell_data = vec![
        Array::new("wall", 1, Values::Int32(cells().map(|(index, _, _)| index).collect())),
        Array::vectors("force", cells().map(|(_, wall, _)| &wall.force)),
        Array::vectors("torque", cells().map(|(_, wall, _)| &wall.torque)),
        Array::vectors("velocity", cells().map(|(_, wall, _)| &wall.velocity)),
    ];
    if frame.walls.iter().any(|wall| wall.records.is_some()) {
        cell_data.extend(records(frame));
    }
    PolyData {
        step: frame.step,
        time: frame.time,
        texts: vec![(
            WALL_NAMES.into(),
            frame.walls.iter().map(|w| w.name.to_owned()).collect(),
        )],
        fields: Vec::new(),
        points: cells().flat_map(|(_, _, triangle)| *triangle).collect(),
        cells: Cells::Triangles,
        point_data: Vec::new(),
        cell_data,
    }
}

/// What was recorded on the elements of walls; 0 on walls that record nothing.
fn records(frame: &Frame) -> [Array; 6] {
    let mut all: Vec<ElementRecord> = Vec::new();
    for wall in frame.walls {
        let recorded = wall.records.iter().flatten().copied();
        let rest = std::iter::repeat(ElementRecord::default());
        all.extend(recorded.chain(rest).take(wall.triangles.len()));
    }
    let scalars = |name, value: fn(&ElementRecord) -> f64| Array::scalars(name, all.iter().map(value));
    [
        Array::vectors("mean_force", all.iter().map(|r| &r.force)),
        scalars("pressure", |r| r.pressure),
        scalars("shear_stress", |r| r.shear_stress),
        scalars("impact_energy", |r| r.impact_energy),
        scalars("sliding_energy", |r| r.sliding_energy),
        scalars("wear_depth", |r| r.wear_depth),
    ]
}
