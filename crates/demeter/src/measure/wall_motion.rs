//! Columns of walls that move freely or turn.

use super::told::{ToldColumn, Value};
use crate::walls::Wall;

/// Columns of every wall that moves freely or is told to turn in some stage; their names begin with `wall NAME`.
pub const WALL_MOTION_COLUMNS: &[ToldColumn] = &[
    ToldColumn::new("velocity x", "m/s", "velocity of the centroid of its shape"),
    ToldColumn::new("velocity y", "m/s", "see velocity x"),
    ToldColumn::new("velocity z", "m/s", "see velocity x"),
    ToldColumn::new("angular velocity x", "rad/s", "angular velocity of the wall"),
    ToldColumn::new("angular velocity y", "rad/s", "see angular velocity x"),
    ToldColumn::new("angular velocity z", "rad/s", "see angular velocity x"),
    ToldColumn::new(
        "turn x",
        "rad",
        "how it stands turned from its start: the axis times the angle, of half a turn at most",
    ),
    ToldColumn::new("turn y", "rad", "see turn x"),
    ToldColumn::new("turn z", "rad", "see turn x"),
];

/// Values of these columns for some walls.
pub(crate) fn wall_motion_values<'a>(walls: impl Iterator<Item = &'a Wall>) -> Vec<Value> {
    let vectors = |wall: &Wall| {
        [
            wall.velocity_at(wall.origin()),
            wall.angular_velocity(),
            wall.pose().turning(),
        ]
    };
    let numbers = walls.flat_map(vectors).flat_map(|vector| vector.to_array());
    numbers.map(Value::Number).collect()
}
