//! Motions of walls, as `[[wall]]` and `[[stage]]` tell them.

use super::AXES;
use super::document::Value;
use super::grains::existing_file;
use super::quantity::Kind;
use super::reader::{Item, TableReader};
use super::walls::index_of_name;
use crate::walls::{
    AtEnd, BodyMass, BodyMotion, FreeMotion, Freedom, Interpolation, MAX_PARTS, MassProperties, Motion, MotionPart,
    MotionTable, Motions, Pace, read_motion_file,
};
use demeter_physics::dimension::Dimension;
use demeter_physics::parameters::Range;
use glam::{DMat3, DVec3};
use std::path::Path;
use std::sync::Arc;

/// What motions may need to know.
#[derive(Clone, Copy)]
pub(super) struct Frame<'a> {
    /// Names of all walls.
    pub names: &'a [String],
    /// Folder that relative paths start from.
    pub base: &'a Path,
    /// Acceleration of gravity [m/s^2].
    pub gravity: DVec3,
}

const KINDS: [&str; 12] = [
    "velocity",
    "belt",
    "rotation",
    "oscillation",
    "rocking",
    "table",
    "servo",
    "torque_servo",
    "free",
    "hinge",
    "body",
    "with",
];

const LENGTH: Kind = Kind::Physical(Dimension::LENGTH);
const VELOCITY: Kind = Kind::Physical(Dimension::VELOCITY);
const TIME: Kind = Kind::Physical(Dimension::TIME);

fn form() -> Option<String> {
    let kinds = KINDS.map(|kind| format!("`{kind}`"));
    Some(format!(
        "write \"rest\", a table with one of {}, or a list of such tables, which add up",
        kinds.join(", ")
    ))
}

/// Motions: `"rest"`, a table with one key that names the kind of motion, or a list of such tables.
pub(super) fn motions<'a>(item: &Item<'a>, frame: &Frame<'_>) -> Motions {
    match &item.node.value {
        Value::String(word) => {
            if word != "rest" {
                item.fault(format!("unknown motion `{word}`"), form());
            }
            Motions::rest()
        }
        Value::Array(nodes) => {
            if nodes.is_empty() || nodes.len() > MAX_PARTS {
                let message = format!("{} motions are listed; 1 to {MAX_PARTS} add up", nodes.len());
                item.fault(message, form());
            }
            // the keys of a part are those of a motion that stands alone
            let own_keys = |part: Item<'a>| Item { ..part };
            let tables = item.items().into_iter().take(MAX_PARTS);
            let parts = tables.filter_map(|part| {
                let part = own_keys(part);
                motion(&part.table()?, &part, frame)
            });
            Motions { parts: parts.collect() }
        }
        _ => {
            let part = item.table().and_then(|table| motion(&table, item, frame));
            Motions {
                parts: part.into_iter().collect(),
            }
        }
    }
}

/// One motion with its pace.
fn motion(table: &TableReader<'_>, item: &Item<'_>, frame: &Frame<'_>) -> Option<MotionPart> {
    let present = table.present(&KINDS);
    if present.len() != 1 {
        let given = if present.is_empty() {
            "none".to_string()
        } else {
            present.join(" and ")
        };
        item.fault(format!("a motion is of one kind, found {given}"), form());
    }
    let mut read = None;
    for kind in KINDS {
        let Some(told) = table.optional(kind) else { continue };
        read = match kind {
            "velocity" => Some(Motion::Velocity(told.vector(VELOCITY))),
            "belt" => Some(Motion::Belt(told.vector(VELOCITY))),
            "rotation" => told.table().map(rotation),
            "oscillation" => told.table().map(oscillation),
            "rocking" => told.table().map(rocking),
            "table" => told.table().and_then(|t| motion_table(t, &told, frame)),
            "servo" => told.table().map(servo),
            "torque_servo" => told.table().map(torque_servo),
            "free" => told.table().map(|t| free(t, frame)),
            "hinge" => told.table().map(|t| hinge(t, frame)),
            "body" => told.table().map(|t| body(t, frame)),
            _ => {
                let names = frame.names.iter().map(String::as_str);
                Some(Motion::With(index_of_name(&told, &told.text(), names)))
            }
        };
    }
    let pace = pace(table);
    table.refuse_others("a motion");
    read.map(|motion| MotionPart { motion, pace })
}

fn pace(table: &TableReader<'_>) -> Pace {
    let time = |key| table.optional_quantity(key, TIME, Range::NOT_NEGATIVE);
    let (start_over, stop_after, stop_over) = (time("start_over"), time("stop_after"), time("stop_over"));
    let start = start_over.unwrap_or(0.0);
    Pace {
        start_over: start,
        stop_after: match (stop_after, stop_over) {
            (Some(after), _) => after,
            (None, Some(_)) => start,
            (None, None) => f64::INFINITY,
        },
        stop_over: stop_over.unwrap_or(0.0),
    }
}

/// A point of an axis and its direction.
fn axis(table: &TableReader<'_>) -> (DVec3, DVec3) {
    let point = table.point("point", "a point of the axis");
    (point, table.direction("axis", "the direction of the axis, as \"z\""))
}

fn rotation(table: TableReader<'_>) -> Motion {
    let speed = table.required("angular_velocity", "how fast it turns, as \"60 rpm\"");
    let (point, axis) = axis(&table);
    table.finish("a rotation");
    Motion::Rotation {
        point,
        axis,
        angular_velocity: speed.map_or(f64::NAN, |i| i.quantity(Kind::AngularVelocity, Range::FINITE)),
    }
}

/// Frequency and phase of what swings.
fn swing(table: &TableReader<'_>) -> (f64, f64) {
    let frequency = Kind::Physical(Dimension::FREQUENCY);
    let frequency = table.quantity(
        "frequency",
        frequency,
        Range::POSITIVE,
        "cycles per second, as \"50 Hz\"",
    );
    let phase = table.optional_quantity("phase", Kind::Angle, Range::FINITE);
    (frequency, phase.unwrap_or(0.0))
}

fn oscillation(table: TableReader<'_>) -> Motion {
    let amplitude = table.point("amplitude", "the largest displacement, as [\"0 m\", \"0 m\", \"1 mm\"]");
    let (frequency, phase) = swing(&table);
    table.finish("an oscillation");
    Motion::Oscillation {
        amplitude,
        frequency,
        phase,
    }
}

fn rocking(table: TableReader<'_>) -> Motion {
    let amplitude = table.quantity(
        "amplitude",
        Kind::Angle,
        Range::FINITE,
        "the largest angle, as \"5 deg\"",
    );
    let (point, axis) = axis(&table);
    let (frequency, phase) = swing(&table);
    table.finish("a rocking motion");
    Motion::Rocking {
        point,
        axis,
        amplitude,
        frequency,
        phase,
    }
}

fn servo(table: TableReader<'_>) -> Motion {
    let force = Kind::Physical(Dimension::FORCE);
    let motion = Motion::Servo {
        axis: table.direction("axis", "the direction in which the wall pushes the grains, as \"-z\""),
        force: table.quantity("force", force, Range::POSITIVE, "the force to hold, as \"5 N\""),
        max_speed: table.quantity(
            "max_speed",
            VELOCITY,
            Range::POSITIVE,
            "the largest speed, as \"10 mm/s\"",
        ),
    };
    table.finish("a servo");
    motion
}

fn torque_servo(table: TableReader<'_>) -> Motion {
    let (point, axis) = axis(&table);
    let meaning = "the torque to hold, as \"5 N m\"";
    let torque = table.quantity("torque", Kind::Torque, Range::POSITIVE, meaning);
    let meaning = "the largest angular velocity, as \"60 rpm\"";
    let max_speed = table.quantity("max_speed", Kind::AngularVelocity, Range::POSITIVE, meaning);
    table.finish("a torque servo");
    Motion::TorqueServo {
        point,
        axis,
        torque,
        max_speed,
    }
}

/// Two stops of a quantity of a kind; none when they are not told.
fn stops(table: &TableReader<'_>, kind: Kind) -> [f64; 2] {
    let Some(item) = table.optional("stops") else {
        return [f64::NEG_INFINITY, f64::INFINITY];
    };
    let items = item.items();
    match items.as_slice() {
        [lower, upper] => [lower, upper].map(|i| i.quantity(kind, Range::FINITE)),
        _ => {
            if matches!(item.node.value, Value::Array(_)) {
                let message = format!("`stops` are two, the lower and the upper, found {}", items.len());
                item.fault(message, None);
            }
            [f64::NAN; 2]
        }
    }
}

fn mass(table: &TableReader<'_>) -> f64 {
    let kind = Kind::Physical(Dimension::MASS);
    table.quantity("mass", kind, Range::POSITIVE, "the mass of the wall, as \"2 kg\"")
}

fn free(table: TableReader<'_>, frame: &Frame<'_>) -> Motion {
    let mass = mass(&table);
    let optional = |key, kind, range| table.optional_quantity(key, kind, range).unwrap_or(0.0);
    let motion = FreeMotion {
        freedom: Freedom::Slide {
            axis: table.direction("axis", "the direction along which the wall is free, as \"z\""),
        },
        inertia: mass,
        weight: frame.gravity * mass,
        stiffness: optional("spring", Kind::Physical(Dimension::STIFFNESS), Range::NOT_NEGATIVE),
        damping: optional("damper", Kind::Physical(Dimension::DAMPING), Range::NOT_NEGATIVE),
        speed: optional("speed", VELOCITY, Range::FINITE),
        stops: stops(&table, LENGTH),
    };
    table.finish("a free motion");
    Motion::Free(motion)
}

fn hinge(table: TableReader<'_>, frame: &Frame<'_>) -> Motion {
    let mass = mass(&table);
    let (point, axis) = axis(&table);
    let kind = Kind::Physical(Dimension::new(1, 2, 0));
    let meaning = "the moment of inertia about the hinge, as \"0.01 kg m^2\"";
    let inertia = table.quantity("inertia", kind, Range::POSITIVE, meaning);
    let center_of_mass = table.point("center_of_mass", "the centre of mass of the wall");
    let least = mass * axis.cross(center_of_mass - point).length_squared();
    // room for what a user rounds off
    if inertia < 0.999 * least {
        table.fault_at(
            "inertia",
            format!(
                "`inertia` is {inertia} kg m^2, but the mass in its centre alone makes {least:.4e} kg m^2 about the hinge; \
                 no body has less"
            ),
        );
    }
    let optional = |key, kind, range| table.optional_quantity(key, kind, range).unwrap_or(0.0);
    let motion = FreeMotion {
        freedom: Freedom::Hinge {
            point,
            axis,
            center_of_mass,
        },
        inertia,
        weight: frame.gravity * mass,
        stiffness: optional("spring", Kind::TorsionalStiffness, Range::NOT_NEGATIVE),
        damping: optional("damper", Kind::TorsionalDamping, Range::NOT_NEGATIVE),
        speed: optional("angular_velocity", Kind::AngularVelocity, Range::FINITE),
        stops: stops(&table, Kind::Angle),
    };
    table.finish("a hinge");
    Motion::Free(motion)
}

fn body(table: TableReader<'_>, frame: &Frame<'_>) -> Motion {
    let (slides, turns) = (axes(&table, "slides"), axes(&table, "turns"));
    let motion = BodyMotion {
        mass: body_mass(&table, turns != [false; 3]),
        gravity: frame.gravity,
        velocity: table.vector_or_zero("velocity", VELOCITY),
        angular_velocity: table.vector_or_zero("angular_velocity", Kind::AngularVelocity),
        slides,
        turns,
    };
    for (key, told, free) in [
        ("velocity", motion.velocity, slides),
        ("angular_velocity", motion.angular_velocity, turns),
    ] {
        if let Some(axis) = (0..3).find(|&axis| told[axis] != 0.0 && !free[axis]) {
            let held = if key == "velocity" { "slides" } else { "turns" };
            let message = format!(
                "`{key}` has a component along {}, which `{held}` does not name",
                AXES[axis]
            );
            table.fault_at(key, message);
        }
    }
    table.finish("a body");
    Motion::Body(motion)
}

/// Mass, centre of mass and moments of a body, or its density; moments are not asked of one that does not turn.
fn body_mass(table: &TableReader<'_>, turns: bool) -> BodyMass {
    let density = Kind::Physical(Dimension::DENSITY);
    if let Some(density) = table.optional_quantity("density", density, Range::POSITIVE) {
        for key in ["mass", "center_of_mass", "inertia", "products"] {
            if table.optional(key).is_some() {
                table.fault_at(key, format!("`{key}` follows from `density`; tell one of them"));
            }
        }
        return BodyMass::Density(density);
    }
    let inertia = Kind::Physical(Dimension::new(1, 2, 0));
    let meaning = "the mass of the body, or in place of all moments the `density` of a closed mesh";
    let mass = table.quantity("mass", Kind::Physical(Dimension::MASS), Range::POSITIVE, meaning);
    let center = table.point("center_of_mass", "the centre of mass of the body");
    let meaning = "the moments of inertia about x, y and z through the centre of mass, as \"1e-5 1e-5 2e-5 kg m^2\"";
    let moments = if turns || table.has("inertia") {
        table
            .required("inertia", meaning)
            .map_or(DVec3::NAN, |item| item.vector(inertia))
    } else {
        DVec3::ZERO
    };
    let products = table.vector_or_zero("products", inertia);
    let [xy, xz, yz] = products.to_array();
    BodyMass::Told(MassProperties {
        mass,
        center,
        inertia: DMat3::from_cols(
            DVec3::new(moments.x, xy, xz),
            DVec3::new(xy, moments.y, yz),
            DVec3::new(xz, yz, moments.z),
        ),
    })
}

/// Which axes a list names; all of them where there is none.
fn axes(table: &TableReader<'_>, key: &str) -> [bool; 3] {
    let Some(item) = table.optional(key) else {
        return [true; 3];
    };
    let mut named = [false; 3];
    for index in item.items().iter().filter_map(|axis| axis.choice(&AXES)) {
        named[index] = true;
    }
    named
}

fn motion_table(table: TableReader<'_>, item: &Item<'_>, frame: &Frame<'_>) -> Option<Motion> {
    let file = table.required("file", "the path of a file with columns such as `time [s], z [mm]`");
    let path = file.as_ref().map(|file| existing_file(file, frame.base));
    let between = table
        .optional("between")
        .map_or(Some(0), |i| i.choice(&["linear", "smooth"]));
    let at_end = table
        .optional("at_end")
        .map_or(Some(0), |i| i.choice(&["hold", "repeat", "go on"]));
    let turns = table.has("point") || table.has("axis");
    let about = turns.then(|| axis(&table));
    table.finish("a table of motion");
    let (file, path) = (file?, path?);
    if !path.is_file() {
        return None;
    }
    let read = match read_motion_file(&path) {
        Ok(read) => read,
        Err(error) => {
            file.fault(error.to_string(), None);
            return None;
        }
    };
    let interpolation = match (between?, read.are_rates) {
        (0, false) => Interpolation::Linear,
        (_, false) => Interpolation::Smooth,
        (0, true) => Interpolation::Rates,
        (_, true) => {
            let message = "a table of velocities is linear in between; `smooth` is for tables of places";
            item.fault(message, Some("leave `between` out".to_string()));
            return None;
        }
    };
    if read.turns != turns {
        let (message, help) = if turns {
            (
                "there is an axis, but the file has no angle",
                "add a column such as `angle [deg]`",
            )
        } else {
            ("the file tells an angle, but no axis", "give `point` and `axis`")
        };
        item.fault(message, Some(help.to_string()));
        return None;
    }
    let at_end = [AtEnd::Hold, AtEnd::Repeat, AtEnd::GoOn][at_end?];
    match MotionTable::new(read.rows, interpolation, at_end, about) {
        Ok(made) => Some(Motion::Table(Arc::new(made))),
        Err(error) => {
            item.fault(error.to_string(), None);
            None
        }
    }
}
