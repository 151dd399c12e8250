//! Frames for ParaView, PyVista and OVITO: one `.vtp` file each for grains, contacts and walls, and collections that
//! tell the time of every file.
//!
//! | file | one element is | arrays |
//! |---|---|---|
//! | `grains` | a point at the centre of a grain | `id`, `material`, `radius` and `diameter` [m], `mass` [kg], `velocity` [m/s], `angular_velocity` [1/s], `force` [N], `torque` [N m], `coordination` (contacts that act, walls counted), `contact_force` [N] (sum of the magnitudes of their normal forces), `mean_normal_stress` [Pa] (from them, compression positive), `orientation` (quaternion x, y, z, w) where it is followed, `tag` where grains have tags |
//! | `contacts` | a point at the contact, of those that act: their normal force is not 0 | `id_i`, `id_j` (0: wall), `wall` (-1: none), `element`, `normal` (towards i), `overlap` [m], `normal_force`, `tangential_force` and their vector sum `force` [N], all on i, rounded to single precision, `normal_force_magnitude`, `force_magnitude` [N], `rolling_torque` [N m] |
//! | `walls` | a triangle of the surface | `wall` (index), `force` [N] and `torque` [N m] of the grains on the whole wall, `velocity` [m/s] of the surface in the middle of the triangle; where a wall records loads or wear, of the element (triangle of a mesh, face of a box, else all of the wall) `mean_force` [N], `pressure` and `shear_stress` [Pa], means since the last frame; what adds up is shared out over the triangles of an element; `impact_energy` and `sliding_energy` [J], `worn_volume` [m^3] and `wear_depth` [m] since the start |
//!
//! Every file carries `TimeValue` [s] and `step`; `grains` the names of the materials and, where there is a domain, `box` (its lower corner
//! and three edges [m], as they are at that moment) and `box_periodic`; `walls` the names of
//! the walls; `contacts` the mean magnitude of the normal forces `mean_normal_force` [N].

use super::collection::Collection;
use super::error::OutputError;
use super::folder::RunFolder;
use super::frame::{Frame, FrameBox, WallSurface};
use super::vtk_file::{NewArray, NewPolyData};
use super::vtp::{Array, Cells, Values};
use crate::measure::{ContactAt, SomeContacts};
use crate::particles::{Load, Rows};
use crate::walls::ElementRecord;
use glam::DVec3;
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::path::{Path, PathBuf};

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
    /// All files that every frame changes.
    pub fn files(folder: &RunFolder) -> Vec<PathBuf> {
        KINDS.map(|kind| folder.frame_collection(kind)).to_vec()
    }

    /// Starts with no frame.
    pub fn create(folder: &RunFolder) -> Result<Self, OutputError> {
        Self::open(folder, None).map(|(writer, _)| writer)
    }

    /// Starts with no frame, or goes on after a step: later frames are taken out of the collections and their files removed. Tells
    /// the frames that are in no collection, and those that are gone, as warnings.
    pub fn open(folder: &RunFolder, after: Option<u64>) -> Result<(Self, Vec<String>), OutputError> {
        let mut collections = KINDS.map(|kind| Collection::new(folder, kind));
        let mut warnings = Vec::new();
        for collection in &mut collections {
            warnings.extend(collection.open(folder, after)?);
        }
        let writer = Self {
            folder: folder.clone(),
            collections,
        };
        Ok((writer, warnings))
    }

    /// Writes a frame. A frame of the same step is replaced. Where several processes have parts of it, the others tell theirs.
    pub fn write(&mut self, frame: &Frame) -> Result<(), OutputError> {
        let [of_grains, of_contacts, of_walls] = self.collections.each_ref().map(|c| c.file_path(frame.step));
        let put = |path: &Path, data: NewPolyData<'_>| self.folder.write_with(path, |file| data.write(file));
        // what one file needs goes before the next is made
        put(&of_grains, grains(frame))?;
        put(&of_contacts, contacts(frame))?;
        put(&of_walls, walls(frame, &records(frame)))?;
        // The collections come last, so that none names a file that is not there.
        for collection in &mut self.collections {
            collection.add(frame.step, frame.time);
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

/// Tells the first process the own part of a frame that it writes.
pub(crate) fn tell(frame: &Frame) {
    grains(frame).pass();
    contacts(frame).pass();
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
fn grains<'a>(frame: &'a Frame) -> NewPolyData<'a> {
    let (g, own, all) = (frame.grains, frame.own(), frame.part.together);
    let vectors = |name, of: &'a Rows| {
        let own = of.rows()[own.clone()].iter();
        NewArray::vectors(name, all.joined(own.map(|row| row.vector)))
    };
    let loads = |name, part: fn(&Load) -> DVec3| {
        let own = g.load.rows()[own.clone()].iter();
        NewArray::vectors(name, all.joined(own.map(part)))
    };
    let radii = || g.position.rows()[own.clone()].iter().map(|row| row.scalar);
    let materials = g.material[own.clone()].iter().map(|m| i32::from(*m));
    let mut point_data = vec![
        NewArray::counts("id", all.joined(g.id[own.clone()].iter().copied())),
        NewArray::integers("material", all.joined(materials)),
        NewArray::scalars("radius", all.joined(radii())),
        NewArray::scalars("diameter", all.joined(radii().map(|r| 2.0 * r))),
        NewArray::scalars("mass", all.joined(g.load.rows()[own.clone()].iter().map(Load::mass))),
        vectors("velocity", &g.velocity),
        vectors("angular_velocity", &g.angular_velocity),
        loads("force", Load::force),
        loads("torque", Load::torque),
        // each is found when it is written
        NewArray::counts("coordination", all.joined(later(|| frame.coordination()))),
        NewArray::scalars("contact_force", all.joined(later(|| frame.contact_force()))),
        NewArray::scalars("mean_normal_stress", all.joined(later(|| frame.mean_normal_stress()))),
    ];
    if let Some(orientation) = &g.orientation {
        let turned = orientation[own.clone()].iter().map(|q| q.to_array());
        point_data.push(NewArray::rows("orientation", all.joined(turned)));
    }
    if let Some(tags) = &frame.tags {
        point_data.push(NewArray::integers("tag", all.joined(tags.iter().copied())));
    }
    NewPolyData {
        step: frame.step,
        time: frame.time,
        texts: vec![(
            MATERIAL_NAMES.into(),
            frame.materials.iter().map(|m| m.name.clone()).collect(),
        )],
        fields: frame.cell.iter().flat_map(box_fields).collect(),
        count: g.len(),
        points: Box::new(all.joined(g.position.rows()[own].iter().map(|row| row.vector))),
        cells: Cells::Vertices,
        point_data,
        cell_data: Vec::new(),
    }
}

/// Values that are found when the first is asked for.
fn later<'a, T: 'a>(find: impl FnOnce() -> Vec<T> + 'a) -> impl Iterator<Item = T> + 'a {
    std::iter::once_with(find).flatten()
}

/// The table of the contacts.
fn contacts<'a>(frame: &'a Frame) -> NewPolyData<'a> {
    let own = frame.contacts.pairs().chain(frame.contacts.with_walls());
    let count = frame.part.together.count(own.count());
    let sum: f64 = together(frame, |k| k.repulsion().abs()).sum();
    let mean = sum / count.max(1) as f64;
    let scalars = |name, value: fn(ContactAt<'a>) -> f64| NewArray::scalars(name, together(frame, value));
    let vectors = |name, value: fn(ContactAt<'a>) -> DVec3| NewArray::vectors(name, together(frame, value));
    let counts = |name, value: fn(ContactAt<'a>) -> u32| NewArray::counts(name, together(frame, value));
    NewPolyData {
        step: frame.step,
        time: frame.time,
        texts: Vec::new(),
        fields: vec![Array::scalars(MEAN_NORMAL_FORCE, [mean])],
        count,
        points: Box::new(together(frame, ContactAt::position)),
        cells: Cells::Vertices,
        point_data: vec![
            counts("id_i", ContactAt::id_i),
            counts("id_j", ContactAt::id_j),
            NewArray::integers("wall", together(frame, ContactAt::wall)),
            counts("element", ContactAt::element),
            vectors("normal", ContactAt::normal),
            scalars("overlap", ContactAt::overlap),
            vectors("normal_force", ContactAt::normal_force),
            vectors("tangential_force", ContactAt::tangential_force),
            vectors("force", ContactAt::force),
            scalars("normal_force_magnitude", |k| k.repulsion().abs()),
            scalars("force_magnitude", |k| k.force().length()),
            vectors("rolling_torque", ContactAt::rolling_torque),
        ],
        cell_data: Vec::new(),
    }
}

/// Something of all contacts of all processes: of those between grains, then of those with walls.
fn together<'a, T>(frame: &'a Frame, value: fn(ContactAt<'a>) -> T) -> impl Iterator<Item = T> + 'a
where
    T: Serialize + DeserializeOwned + 'a,
{
    let (all, contacts) = (frame.part.together, frame.contacts);
    let told = move |some: SomeContacts<'a>| all.joined(some.map(value));
    told(contacts.pairs()).chain(told(contacts.with_walls()))
}

/// The table of the walls.
fn walls<'a>(frame: &'a Frame, records: &'a Option<Vec<ElementRecord>>) -> NewPolyData<'a> {
    let walls = frame.walls;
    let cells = || {
        (0..)
            .zip(walls)
            .flat_map(|(index, wall)| wall.triangles.iter().map(move |t| (index, wall, t)))
    };
    let vectors =
        |name, value: fn(&WallSurface) -> DVec3| NewArray::vectors(name, cells().map(move |(_, wall, _)| value(wall)));
    let mut cell_data = vec![
        NewArray::integers("wall", cells().map(|(index, _, _)| index)),
        vectors("force", |wall| wall.force),
        vectors("torque", |wall| wall.torque),
        NewArray::vectors(
            "velocity",
            walls.iter().flat_map(|wall| wall.velocities.iter().copied()),
        ),
    ];
    if let Some(records) = records {
        let scalars = |name, value: fn(&ElementRecord) -> f64| NewArray::scalars(name, records.iter().map(value));
        cell_data.extend([
            NewArray::vectors("mean_force", records.iter().map(|r| r.force)),
            scalars("pressure", |r| r.pressure),
            scalars("shear_stress", |r| r.shear_stress),
            scalars("impact_energy", |r| r.impact_energy),
            scalars("sliding_energy", |r| r.sliding_energy),
            scalars("worn_volume", |r| r.worn_volume),
            scalars("wear_depth", |r| r.wear_depth),
        ]);
    }
    NewPolyData {
        step: frame.step,
        time: frame.time,
        texts: vec![(WALL_NAMES.into(), walls.iter().map(|w| w.name.to_owned()).collect())],
        fields: Vec::new(),
        count: 3 * walls.iter().map(|wall| wall.triangles.len()).sum::<usize>(),
        points: Box::new(cells().flat_map(|(_, _, triangle)| *triangle)),
        cells: Cells::Triangles,
        point_data: Vec::new(),
        cell_data,
    }
}

/// What was recorded on the elements of walls, where anything is recorded; 0 on walls that record nothing.
fn records(frame: &Frame) -> Option<Vec<ElementRecord>> {
    frame.walls.iter().find(|wall| wall.records.is_some())?;
    let mut all = Vec::new();
    for wall in frame.walls {
        let recorded = wall.records.iter().flatten().copied();
        let rest = std::iter::repeat(ElementRecord::default());
        all.extend(recorded.chain(rest).take(wall.triangles.len()));
    }
    Some(all)
}
