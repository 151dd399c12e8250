//! Tables `[[stage]]`: the protocol, with repeats unrolled.

use super::column_stops;
use super::deformation::{self, deformation};
use super::document::{Value, join};
use super::feeds::{FeedSpec, RemovalSpec, chosen, index_of};
use super::materials::{ContactSpec, contact_of_stage};
use super::motions::{Frame, motions};
use super::quantity::Kind;
use super::reader::{Item, TableReader};
use super::settings::{Intervals, cadence, intervals};
use super::walls::{WallSpec, wall_index};
use crate::materials::Material;
use crate::simulation::{Cadence, Deformation, Stage, StopCondition};
use crate::walls::Motions;
use demeter_physics::dimension::Dimension;
use demeter_physics::parameters::Range;
use glam::DVec3;
use std::cell::Cell;
use std::collections::BTreeSet;
use std::path::Path;

/// Most stages after unrolling.
pub const MAX_STAGES: usize = 10_000;
/// Most repeats of one stage.
pub const MAX_REPEAT: i64 = 10_000;
/// Deepest nesting of stages.
const MAX_NESTING: usize = 8;
/// Most contact laws, of all pairs of materials, that stages tell.
const MAX_LAWS: usize = 100_000;
/// Most steps of a stage.
const MAX_STEPS: i64 = 1_000_000_000_000_000;

/// A stage as told, before unrolling.
struct Told {
    name: String,
    path: String,
    repeat: usize,
    content: Content,
}

enum Content {
    Group(Vec<Told>),
    Single(Box<Single>),
}

struct Single {
    stop: Vec<StopCondition>,
    columns: Vec<column_stops::Told>,
    motions: Vec<(usize, Motions)>,
    absent: Option<Vec<usize>>,
    feeds: Option<Vec<usize>>,
    removals: Option<Vec<usize>>,
    deformation: Option<Deformation>,
    gravity: Option<DVec3>,
    contact: Option<ContactSpec>,
    intervals: Intervals,
}

/// What stages may name.
#[derive(Clone, Copy)]
pub(super) struct Cast<'a> {
    pub walls: &'a [WallSpec],
    pub feeds: &'a [FeedSpec],
    pub removals: &'a [RemovalSpec],
    /// Folder that relative paths start from.
    pub base: &'a Path,
    /// Acceleration of gravity [m/s^2].
    pub gravity: DVec3,
    pub materials: &'a [Material],
    /// Contact laws of stages that tell none.
    pub contact: &'a ContactSpec,
    /// How many of pairs stages have told.
    pub laws_told: &'a Cell<usize>,
}

/// The stages in order, each with the path of the table that told it, and the resolved cadence of the whole run.
pub(super) struct Protocol {
    pub stages: Vec<Stage>,
    pub paths: Vec<String>,
    /// Conditions on columns that are read once these are known, each with the path of the stage.
    pub columns: Vec<(String, column_stops::Told)>,
    /// The contact laws that stages tell.
    pub contacts: Vec<ContactSpec>,
    pub cadence: Cadence,
}

pub(super) fn protocol(root: &TableReader<'_>, cast: Cast<'_>, told: Intervals) -> Protocol {
    let mut protocol = Protocol {
        stages: Vec::new(),
        paths: Vec::new(),
        columns: Vec::new(),
        contacts: Vec::new(),
        cadence: cadence(told, 0.0),
    };
    let meaning = "at least one table [[stage]] with a `duration`";
    let Some(item) = root.required("stage", meaning) else {
        return protocol;
    };
    let stages = group(&item, "stage", "stage", cast, 1);
    let count = unrolled(&stages);
    if count > MAX_STAGES {
        item.fault(
            format!("the protocol has {count} stages when unrolled; at most {MAX_STAGES} are allowed"),
            None,
        );
        return protocol;
    }
    let duration = total_duration(&stages);
    protocol.cadence = cadence(told, duration);
    let context = root.context;
    unroll(&stages, "", &mut |stage, name| {
        let Content::Single(single) = &stage.content else {
            return;
        };
        let own: Intervals = std::array::from_fn(|k| single.intervals[k].or(told[k]));
        if !single.columns.is_empty() && !protocol.paths.contains(&stage.path) {
            let told = single.columns.iter().map(|told| (stage.path.clone(), told.clone()));
            protocol.columns.extend(told);
        }
        let contact = single.contact.as_ref().map(|contact| {
            let known = protocol
                .contacts
                .iter()
                .position(|known| known.table() == contact.table());
            known.unwrap_or_else(|| {
                protocol.contacts.push(contact.clone());
                protocol.contacts.len() - 1
            })
        });
        protocol.paths.push(stage.path.clone());
        protocol.stages.push(Stage {
            name,
            stop: single.stop.clone(),
            motions: single.motions.clone(),
            absent: single.absent.clone(),
            feeds: single.feeds.clone(),
            removals: single.removals.clone(),
            deformation: single.deformation,
            gravity: single.gravity,
            contact,
            cadence: cadence(own, duration),
        });
    });
    let mut names = BTreeSet::new();
    for (stage, path) in protocol.stages.iter().zip(&protocol.paths) {
        if !names.insert(stage.name.as_str()) {
            let help = "give the stages different names; repeats are numbered, as `squeeze 2`";
            let message = format!("two stages are named `{}`", stage.name);
            context.fault(&join(path, "name"), message, Some(help.to_string()));
            break;
        }
    }
    protocol
}

/// Reads a list of stages.
fn group(item: &Item<'_>, header: &str, label: &str, cast: Cast<'_>, depth: usize) -> Vec<Told> {
    if depth > MAX_NESTING {
        item.fault(format!("stages are nested more than {MAX_NESTING} deep"), None);
        return Vec::new();
    }
    let tables = item.tables(header);
    if tables.is_empty() && matches!(&item.node.value, Value::Array(nodes) if nodes.is_empty()) {
        item.fault("the list of stages is empty", None);
    }
    if tables.len() > MAX_STAGES {
        item.fault(
            format!("{} stages are too many; at most {MAX_STAGES}", tables.len()),
            None,
        );
    }
    let numbered = tables.into_iter().take(MAX_STAGES).enumerate();
    numbered
        .map(|(index, table)| stage(table, header, &format!("{label} {}", index + 1), cast, depth))
        .collect()
}

fn stage(table: TableReader<'_>, header: &str, default_name: &str, cast: Cast<'_>, depth: usize) -> Told {
    let path = table.path.clone();
    let name = table
        .optional("name")
        .map_or_else(|| default_name.to_string(), |i| i.label());
    let repeat = table.optional("repeat").map_or(1, |i| i.integer(1, MAX_REPEAT)) as usize;
    let content = match table.optional("stage") {
        Some(nested) => {
            let stages = group(&nested, &format!("{header}.stage"), &name, cast, depth + 1);
            table.finish("a stage that holds stages; wall motion, output and ends belong to the stages in it");
            Content::Group(stages)
        }
        None => single(table, cast),
    };
    Told {
        name,
        path,
        repeat,
        content,
    }
}

fn single(table: TableReader<'_>, cast: Cast<'_>) -> Content {
    let (mut stop, mut columns) = (Vec::new(), Vec::new());
    let duration = table.optional_quantity("duration", Kind::Physical(Dimension::TIME), Range::POSITIVE);
    stop.extend(duration.map(StopCondition::Duration));
    let steps = table.optional("steps").map(|i| i.integer(1, MAX_STEPS) as u64);
    stop.extend(steps.map(StopCondition::Steps));
    if stop.is_empty() {
        let help = "give `duration` or `steps`; conditions in `stop` may end the stage earlier";
        table.fault("the stage has no end", Some(help.to_string()));
    }
    if let Some(item) = table.optional("stop") {
        match &item.node.value {
            Value::Array(_) => (item.items().iter()).for_each(|i| columns.extend(conditions(i, cast, &mut stop))),
            _ => columns.extend(conditions(&item, cast, &mut stop)),
        }
    }
    let mut told_motions = Vec::new();
    if let Some(told) = table.optional("motion").and_then(|i| i.table()) {
        let names: Vec<String> = cast.walls.iter().map(|w| w.name.clone()).collect();
        let frame = Frame {
            names: &names,
            base: cast.base,
            gravity: cast.gravity,
        };
        for item in told.named() {
            told_motions.push((wall_index(&item, &item.name, cast.walls), motions(&item, &frame)));
        }
        told.finish("the motion of a stage");
    }
    let wall_names = cast.walls.iter().map(|w| w.name.as_str());
    let absent = table.optional("absent").map(|i| chosen(&i, "wall", wall_names));
    let feed_names = cast.feeds.iter().map(|f| f.name.as_str());
    let feeds = table.optional("feeds").map(|i| chosen(&i, "feed", feed_names));
    let removal_names = cast.removals.iter().map(|r| r.name.as_str());
    let removals = table.optional("removals").map(|i| chosen(&i, "removal", removal_names));
    let deformation = deformation(&table);
    let acceleration = Kind::Physical(Dimension::ACCELERATION);
    let gravity = table.optional("gravity").map(|i| i.vector(acceleration));
    let contact = table.optional("contact").and_then(|item| contact(&item, cast));
    let output = table.optional("output").and_then(|i| i.table());
    let intervals = output.map_or([None; 3], |output| {
        let read = intervals(&output);
        output.finish("the output of a stage");
        read
    });
    table.finish("a stage");
    Content::Single(Box::new(Single {
        stop,
        columns,
        motions: told_motions,
        absent,
        feeds,
        removals,
        deformation,
        gravity,
        contact,
        intervals,
    }))
}

/// Contact laws of a stage; nothing, with a fault, where stages tell too many.
fn contact(item: &Item<'_>, cast: Cast<'_>) -> Option<ContactSpec> {
    let told = item.table()?;
    let all = cast.laws_told.get() + 1 + cast.contact.pairs.len();
    if all > MAX_LAWS {
        item.fault(
            format!("stages tell the contact laws of more than {MAX_LAWS} pairs of materials, each stage with `contact` those of all entries of `[[contact.pair]]`"),
            Some("let stages repeat, or give fewer pairs laws of their own".to_string()),
        );
        return None;
    }
    cast.laws_told.set(all);
    Some(contact_of_stage(&told, cast.contact, cast.materials))
}

/// Reads the conditions of a table `stop`; that on a column is not complete yet.
fn conditions(item: &Item<'_>, cast: Cast<'_>, stop: &mut Vec<StopCondition>) -> Option<column_stops::Told> {
    let walls = cast.walls;
    let table = item.table()?;
    let before = stop.len();
    if let Some(share) = table.optional_quantity("kinetic_over_elastic", Kind::Number, Range::POSITIVE) {
        stop.push(StopCondition::KineticOverElastic(share));
    }
    if let Some(told) = table.optional("wall_force").and_then(|i| i.table()) {
        stop.push(StopCondition::WallForce {
            walls: walls_of(&told, walls),
            direction: told
                .direction("direction", "along which the force on the walls is measured, as \"z\"")
                .to_array(),
            above: told.quantity(
                "above",
                Kind::Physical(Dimension::FORCE),
                Range::POSITIVE,
                "the force that ends the stage, as \"5 N\"",
            ),
        });
        told.finish("the condition wall_force");
    }
    if let Some(told) = table.optional("wall_travel").and_then(|i| i.table()) {
        stop.push(StopCondition::WallTravel {
            wall: wall_of(&told, walls),
            distance: told.length("distance", "the way of the wall that ends the stage, as \"30 mm\""),
        });
        told.finish("the condition wall_travel");
    }
    if let Some(told) = table.optional("strain").and_then(|i| i.table()) {
        stop.push(StopCondition::Strain {
            wall: wall_of(&told, walls),
            length: told.length("length", "the length that the way of the wall is divided by"),
            strain: told.quantity(
                "strain",
                Kind::Number,
                Range::POSITIVE,
                "the strain that ends the stage, as 0.1",
            ),
        });
        told.finish("the condition strain");
    }
    deformation::conditions(&table, stop);
    if let Some(item) = table.optional("motion_done") {
        let names = walls.iter().map(|w| w.name.as_str());
        stop.extend(index_of(&item, "wall", names).map(StopCondition::MotionDone));
    }
    if let Some(item) = table.optional("feed_done") {
        let names = cast.feeds.iter().map(|f| f.name.as_str());
        stop.extend(index_of(&item, "feed", names).map(StopCondition::FeedDone));
    }
    if let Some(item) = table.optional("grains_at_most") {
        stop.push(StopCondition::GrainsAtMost(item.integer(0, MAX_STEPS) as u64));
    }
    let column = table.optional("column").and_then(|i| i.table());
    let column = column.map(|told| column_stops::column_stop(told, stop));
    table.finish("the stop conditions");
    if stop.len() == before && matches!(&item.node.value, Value::Table(entries) if entries.is_empty()) {
        item.fault("there is no stop condition in `stop`", None);
    }
    column
}

/// One wall, or a list of some.
pub(super) fn walls_of(table: &TableReader<'_>, walls: &[WallSpec]) -> Vec<usize> {
    let Some(item) = table.required("wall", "the name of the wall, or a list of names") else {
        return Vec::new();
    };
    if !matches!(item.node.value, Value::Array(_)) {
        return vec![wall_named(&item, walls)];
    }
    if item.items().is_empty() {
        item.fault("there is no wall in `wall`", Some("name one at least".to_string()));
    }
    chosen(&item, "wall", walls.iter().map(|w| w.name.as_str()))
}

pub(super) fn wall_of(table: &TableReader<'_>, walls: &[WallSpec]) -> usize {
    let item = table.required("wall", "the name of the wall");
    item.map_or(0, |item| wall_named(&item, walls))
}

fn wall_named(item: &Item<'_>, walls: &[WallSpec]) -> usize {
    index_of(item, "wall", walls.iter().map(|w| w.name.as_str())).unwrap_or(0)
}

/// Number of stages when unrolled.
fn unrolled(stages: &[Told]) -> usize {
    stages.iter().fold(0, |sum: usize, stage| {
        let inside = match &stage.content {
            Content::Group(stages) => unrolled(stages),
            Content::Single(_) => 1,
        };
        sum.saturating_add(inside.saturating_mul(stage.repeat))
    })
}

/// Sum of the durations of all stages when unrolled [s].
fn total_duration(stages: &[Told]) -> f64 {
    let one = |stage: &Told| match &stage.content {
        Content::Group(stages) => total_duration(stages),
        Content::Single(single) => single
            .stop
            .iter()
            .find_map(|s| match s {
                StopCondition::Duration(seconds) => Some(*seconds),
                _ => None,
            })
            .unwrap_or(0.0),
    };
    stages.iter().map(|s| one(s) * s.repeat as f64).sum()
}

/// Hands every stage to `take` in order with its unrolled name: `squeeze 2`; `squeeze 2.3` is the third repeat of a
/// stage within the second repeat of its group.
fn unroll(stages: &[Told], suffix: &str, take: &mut impl FnMut(&Told, String)) {
    for stage in stages {
        for turn in 1..=stage.repeat {
            let suffix = match (stage.repeat, suffix) {
                (1, outer) => outer.to_string(),
                (_, "") => turn.to_string(),
                (_, outer) => format!("{outer}.{turn}"),
            };
            match &stage.content {
                Content::Group(inside) => unroll(inside, &suffix, take),
                Content::Single(_) if suffix.is_empty() => take(stage, stage.name.clone()),
                Content::Single(_) => take(stage, format!("{} {suffix}", stage.name)),
            }
        }
    }
}
