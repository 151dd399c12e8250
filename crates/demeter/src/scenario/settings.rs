//! Tables `[simulation]`, `[domain]` and `[output]`.

use super::quantity::Kind;
use super::reader::{Item, TableReader};
use super::stages::wall_of;
use super::walls::WallSpec;
use crate::contacts::Coupling;
use crate::measure::StrainGauge;
use crate::particles::Outside;
use crate::simulation::{Cadence, Deformation};
use demeter_physics::dimension::Dimension;
use demeter_physics::integrator::Integrator;
use demeter_physics::parameters::Range;
use glam::DVec3;

/// How the time step is chosen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TimeStep {
    /// The share of the shortest time scale of the laws in use that is safe.
    Auto,
    /// The longest that is accepted without being asked for as unsafe.
    Longest,
    /// This share of the shortest time scale.
    Share(f64),
    /// This step [s].
    Fixed(f64),
}

/// Table `[simulation]`.
#[derive(Clone, Debug, PartialEq)]
pub struct SimulationSpec {
    /// How the time step is chosen.
    pub time_step: TimeStep,
    /// How the equations of motion are integrated.
    pub integrator: Integrator,
    /// How contacts that feel each other are treated.
    pub coupling: Coupling,
    /// Whether a step above the safe one is accepted.
    pub allow_unsafe_time_step: bool,
    /// Whether it is followed how grains turn; a predictor-corrector always does.
    pub orientations: bool,
    /// Acceleration of gravity [m/s^2].
    pub gravity: DVec3,
    /// Largest overlap as a share of the smaller radius: beyond it the run stops; the automatic step is safe up to it.
    pub max_overlap: f64,
    /// Extra distance at which pairs become candidates [m]; follows the motion when absent.
    pub skin: Option<f64>,
}

/// Largest overlap when the scenario names none, as a share of the smaller radius.
pub const DEFAULT_MAX_OVERLAP: f64 = 0.05;

impl Default for SimulationSpec {
    fn default() -> Self {
        Self {
            time_step: TimeStep::Auto,
            integrator: Integrator::default(),
            coupling: Coupling::default(),
            allow_unsafe_time_step: false,
            orientations: false,
            gravity: DVec3::ZERO,
            max_overlap: DEFAULT_MAX_OVERLAP,
            skin: None,
        }
    }
}

pub(super) fn simulation(root: &TableReader<'_>) -> SimulationSpec {
    let mut spec = SimulationSpec::default();
    let Some(table) = root.optional("simulation").and_then(|i| i.table()) else {
        return spec;
    };
    if let Some(item) = table.optional("time_step") {
        spec.time_step = time_step(&item);
    }
    if let Some(item) = table.optional("integrator")
        && let Some(index) = item.choice(&["velocity-verlet", "gear"])
    {
        spec.integrator = [Integrator::VelocityVerlet, Integrator::Gear][index];
    }
    spec.allow_unsafe_time_step = table.optional("allow_unsafe_time_step").is_some_and(|i| i.boolean());
    spec.orientations = table.optional("orientations").is_some_and(|i| i.boolean());
    spec.gravity = table.vector_or_zero("gravity", Kind::Physical(Dimension::ACCELERATION));
    if let Some(share) = table.optional_quantity("max_overlap", Kind::Number, Range::POSITIVE_SHARE) {
        spec.max_overlap = share;
    }
    spec.coupling = coupling(&table);
    spec.skin = table.optional_quantity("skin", Kind::Physical(Dimension::LENGTH), Range::POSITIVE);
    table.finish("[simulation]");
    spec
}

/// Tolerance of the coupled equation: below it rounding decides.
const TOLERANCE: Range = Range::new(1e-13, true, 1e-2, true);

/// How contacts that feel each other are treated.
fn coupling(table: &TableReader<'_>) -> Coupling {
    let scheme = table
        .optional("coupling")
        .and_then(|i| i.choice(&["converged", "lagged"]));
    let tolerance = table.optional_quantity("coupling_tolerance", Kind::Number, TOLERANCE);
    if scheme == Some(1) && tolerance.is_some() {
        let help = "leave it out, or set `coupling = \"converged\"`";
        table.fault(
            "`coupling_tolerance` belongs to converged coupling",
            Some(help.to_string()),
        );
    }
    match (scheme, tolerance) {
        (Some(1), _) => Coupling::Lagged,
        (_, Some(tolerance)) => Coupling::Converged { tolerance },
        _ => Coupling::default(),
    }
}

/// A time step as a share of the shortest time scale.
const SHARE: Range = Range::new(1e-9, true, 1.0, true);

fn time_step(item: &Item<'_>) -> TimeStep {
    let super::document::Value::String(text) = &item.node.value else {
        return TimeStep::Fixed(item.quantity(Kind::Physical(Dimension::TIME), Range::POSITIVE));
    };
    if let Some(share) = share(text) {
        if !SHARE.contains(share) {
            item.fault(
                format!("`time_step` is {text}; as a share of the shortest time scale it must be {SHARE}"),
                None,
            );
        }
        return TimeStep::Share(share);
    }
    match text.as_str() {
        "auto" => TimeStep::Auto,
        "longest" => TimeStep::Longest,
        _ if !text.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c)) => {
            item.fault(
                format!("`time_step` must be \"auto\", \"longest\", a share of the shortest time scale or a time, found `{text}`"),
                Some("write it as \"auto\", \"1/50\" or \"1e-5 s\"".to_string()),
            );
            TimeStep::Auto
        }
        _ => TimeStep::Fixed(item.quantity(Kind::Physical(Dimension::TIME), Range::POSITIVE)),
    }
}

/// The value of a text like `1/50`.
fn share(text: &str) -> Option<f64> {
    let (one, number) = text.split_once('/')?;
    let [one, number] = [one, number].map(|part| part.trim().parse::<f64>().ok());
    Some(one? / number?)
}

/// Table `[domain]`.
#[derive(Clone, Debug, PartialEq)]
pub struct DomainSpec {
    /// Lower and upper corner [m]; the bounds of walls and grains, enlarged, when absent.
    pub bounds: Option<(DVec3, DVec3)>,
    /// Periodic directions; none without bounds.
    pub periodic: [bool; 3],
    /// What happens to a grain that leaves.
    pub outside: Outside,
    /// How the periodic box deforms from the start of the run on.
    pub deform: Option<Deformation>,
}

impl Default for DomainSpec {
    fn default() -> Self {
        Self {
            bounds: None,
            periodic: [false; 3],
            outside: Outside::Stop,
            deform: None,
        }
    }
}

pub(super) fn domain(root: &TableReader<'_>) -> DomainSpec {
    let mut spec = DomainSpec::default();
    let Some(table) = root.optional("domain").and_then(|i| i.table()) else {
        return spec;
    };
    if let Some(item) = table.optional("periodic") {
        for axis in item.items() {
            if let Some(index) = axis.choice(&["x", "y", "z"]) {
                if spec.periodic[index] {
                    axis.fault("this direction is named twice", None);
                }
                spec.periodic[index] = true;
            }
        }
    }
    if table.has("lower") || table.has("upper") || spec.periodic.contains(&true) {
        spec.bounds = Some(table.corners());
    } else {
        // makes both keys known for the suggestion on a misspelt one
        table.optional("lower");
        table.optional("upper");
    }
    if let Some(item) = table.optional("outside")
        && let Some(index) = item.choice(&["stop", "remove"])
    {
        spec.outside = [Outside::Stop, Outside::Remove][index];
    }
    spec.deform = super::deformation::deformation(&table);
    table.finish("[domain]");
    spec
}

/// A plot of the report: columns of the series.
#[derive(Clone, Debug, PartialEq)]
pub struct PlotSpec {
    /// Title.
    pub name: String,
    /// Column along x.
    pub x: String,
    /// Columns along y.
    pub y: Vec<String>,
}

/// Table `[output]`.
#[derive(Clone, Debug, PartialEq)]
pub struct OutputSpec {
    /// How often things are written in stages that do not say otherwise. `None`: never, or not known because no
    /// duration is told.
    pub cadence: Cadence,
    /// Whether the report shows a picture of the last state.
    pub picture: bool,
    /// Whether the run ends with a report for browsers.
    pub report: bool,
    /// Plots beside those that every run has.
    pub plots: Vec<PlotSpec>,
    /// The wall whose displacement tells the strain of the packing.
    pub strain: Option<StrainGauge>,
}

/// Rows of the series that the automatic cadence aims at over the whole run.
pub const AUTOMATIC_ROWS: f64 = 1000.0;
/// Frames that the automatic cadence aims at over the whole run.
pub const AUTOMATIC_FRAMES: f64 = 100.0;
/// Checkpoints that the automatic cadence aims at over the whole run.
pub const AUTOMATIC_CHECKPOINTS: f64 = 10.0;
/// Most plots.
const MAX_PLOTS: usize = 100;

/// How often one thing is written, as told.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Interval {
    Auto,
    Never,
    Every(f64),
}

/// Intervals of series, frames and checkpoints, as told; `None` where nothing was told.
pub(super) type Intervals = [Option<Interval>; 3];

pub(super) fn intervals(table: &TableReader<'_>) -> Intervals {
    ["series", "frames", "checkpoints"].map(|key| table.optional(key).map(|item| interval(&item)))
}

fn interval(item: &Item<'_>) -> Interval {
    match &item.node.value {
        super::document::Value::String(text) if text == "auto" => Interval::Auto,
        super::document::Value::String(text) if text == "never" => Interval::Never,
        super::document::Value::String(text) if text.starts_with(|c: char| c.is_alphabetic()) => {
            item.fault(
                format!("`{}` must be a time, \"auto\" or \"never\", found `{text}`", item.name),
                Some("write it as \"10 ms\"".to_string()),
            );
            Interval::Never
        }
        _ => Interval::Every(item.quantity(Kind::Physical(Dimension::TIME), Range::POSITIVE)),
    }
}

/// Turns what was told into seconds; `duration` is the sum of the durations of all stages [s].
pub(super) fn cadence(told: Intervals, duration: f64) -> Cadence {
    let resolve = |interval: Option<Interval>, pieces: f64| match interval {
        Some(Interval::Never) => None,
        Some(Interval::Every(seconds)) => Some(seconds),
        Some(Interval::Auto) | None => (duration > 0.0).then_some(duration / pieces),
    };
    Cadence {
        series: resolve(told[0], AUTOMATIC_ROWS),
        frames: resolve(told[1], AUTOMATIC_FRAMES),
        checkpoints: resolve(told[2], AUTOMATIC_CHECKPOINTS),
    }
}

/// What `[output]` told, before the durations of the stages are known.
#[derive(Default)]
pub(super) struct OutputTold {
    pub intervals: Intervals,
    pub no_picture: bool,
    pub no_report: bool,
    pub plots: Vec<PlotSpec>,
    pub strain: Option<StrainGauge>,
}

pub(super) fn output(root: &TableReader<'_>, walls: &[WallSpec]) -> OutputTold {
    let mut told = OutputTold::default();
    let Some(table) = root.optional("output").and_then(|i| i.table()) else {
        return told;
    };
    told.intervals = intervals(&table);
    told.no_picture = table.optional("picture").is_some_and(|i| !i.boolean());
    told.no_report = table.optional("report").is_some_and(|i| !i.boolean());
    told.strain = table
        .optional("strain")
        .and_then(|i| i.table())
        .map(|t| strain_gauge(t, walls));
    if let Some(item) = table.optional("plots") {
        let plots = item.items();
        if plots.len() > MAX_PLOTS {
            item.fault(format!("{} plots are too many; at most {MAX_PLOTS}", plots.len()), None);
        }
        told.plots = plots
            .iter()
            .take(MAX_PLOTS)
            .filter_map(|i| i.table())
            .map(plot)
            .collect();
    }
    table.finish("[output]");
    told
}

fn strain_gauge(table: TableReader<'_>, walls: &[WallSpec]) -> StrainGauge {
    let length = Kind::Physical(Dimension::LENGTH);
    let gauge = StrainGauge {
        wall: wall_of(&table, walls),
        direction: table.direction("direction", "the direction along which the wall compresses the packing"),
        from: table.optional_quantity("from", length, Range::FINITE).unwrap_or(0.0),
        length: table.quantity(
            "length",
            length,
            Range::POSITIVE,
            "the length of the packing at strain 0",
        ),
    };
    table.finish("output.strain");
    gauge
}

fn plot(table: TableReader<'_>) -> PlotSpec {
    let x = table.required("x", "the column of the series along x, as \"time\"");
    let x = x.map_or_else(String::new, |i| i.label());
    let y = match table.required("y", "the column of the series along y, or a list of columns") {
        None => Vec::new(),
        Some(item) => match &item.node.value {
            super::document::Value::Array(_) => item.items().iter().map(|i| i.label()).collect(),
            _ => vec![item.label()],
        },
    };
    let name = table.optional("name");
    let name = name.map_or_else(|| format!("{} over {x}", y.join(", ")), |i| i.label());
    table.finish("a plot");
    PlotSpec { name, x, y }
}
