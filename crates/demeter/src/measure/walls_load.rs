//! What several walls bear together, about one point and one axis: the load on a mixer's shaft, or on a whole vessel.

use super::{ToldColumn, Value};
use crate::simulation::Simulation;
use glam::DVec3;

/// Columns of a load. The torque is about [`WallsLoad::point`].
pub const WALLS_LOAD_COLUMNS: &[ToldColumn] = &[
    ToldColumn::new("force x", "N", "force of the grains on the walls"),
    ToldColumn::new("force y", "N", "see force x"),
    ToldColumn::new("force z", "N", "see force x"),
    ToldColumn::new("torque x", "N m", "torque of the grains on the walls about the point"),
    ToldColumn::new("torque y", "N m", "see torque x"),
    ToldColumn::new("torque z", "N m", "see torque x"),
    ToldColumn::new("power", "W", "rate of the work of the walls on the grains"),
    ToldColumn::new(
        "work",
        "J",
        "work of the walls on the grains since the start of the run",
    ),
];

/// Columns that follow those of a load where an axis is told.
pub const AXIAL_COLUMNS: &[ToldColumn] = &[
    ToldColumn::new("axial force", "N", "force of the grains along the axis"),
    ToldColumn::new(
        "axial torque",
        "N m",
        "torque of the grains about the axis, right-handed",
    ),
];

/// Walls whose loads are summed up.
#[derive(Clone, Debug, PartialEq)]
pub struct WallsLoad {
    /// Indices of the walls.
    pub walls: Vec<usize>,
    /// Point that torques are about, and that the axis passes through [m].
    pub point: DVec3,
    /// Unit vector of the axis, where there is one.
    pub axis: Option<DVec3>,
}

impl WallsLoad {
    /// Titles of its columns.
    pub fn titles(&self, name: &str) -> Vec<String> {
        let axial: &[ToldColumn] = if self.axis.is_some() { AXIAL_COLUMNS } else { &[] };
        let columns = WALLS_LOAD_COLUMNS.iter().chain(axial);
        columns.map(|column| column.title(name)).collect()
    }

    /// Its values now, in the order of the titles: `F = sum F_w`, `T = sum T_w + (o_w - p) x F_w`, with `o_w` the point that the torque `T_w`
    /// of wall `w` is about and `p` the point of this load.
    pub fn measure(&self, sim: &Simulation) -> Vec<Value> {
        let (mut force, mut torque, mut power, mut work) = (DVec3::ZERO, DVec3::ZERO, 0.0, 0.0);
        for wall in self.walls.iter().map(|&wall| &sim.walls[wall]) {
            let (of_wall, about_origin) = wall.load();
            force += of_wall;
            torque += about_origin + (wall.origin() - self.point).cross(of_wall);
            power += wall.power();
            work += wall.work().work;
        }
        let axial = self.axis.map(|axis| [force.dot(axis), torque.dot(axis)]);
        let vectors = [force, torque].into_iter().flat_map(|v| v.to_array());
        let numbers = vectors.chain([power, work]);
        numbers.chain(axial.into_iter().flatten()).map(Value::Number).collect()
    }
}
