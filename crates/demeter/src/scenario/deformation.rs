//! Tables `[domain.deform]` and `[stage.deform]`: how a periodic box deforms.

use super::AXES;
use super::laws_of_stages::Bound;
use super::quantity::Kind;
use super::reader::TableReader;
use super::{Diagnostics, Scenario};
use crate::comm::ShearAxes;
use crate::particles::Grains;
use crate::simulation::{
    Deformation, DeformationError, Drive, Misfit, Shear, Simulation, StopCondition, StressOf, can_pull,
};
use demeter_physics::dimension::Dimension;
use demeter_physics::integrator::Integrator;
use demeter_physics::parameters::Range;
use glam::DVec3;

/// Reads the table `deform` of another, if it is there.
pub(super) fn deformation(above: &TableReader<'_>) -> Option<Deformation> {
    let table = above.optional("deform")?.table()?;
    let plan = Deformation {
        directions: AXES.map(|axis| drive(&table, axis)),
        isotropic: drive(&table, "isotropic"),
        shear: table.optional("shear").and_then(|i| i.table()).and_then(shear),
        affine: table.optional("affine").is_none_or(|i| i.boolean()),
    };
    table.finish("the deformation of the box");
    Some(plan)
}

/// How a length changes.
fn drive(above: &TableReader<'_>, key: &str) -> Drive {
    let Some(table) = above.optional(key).and_then(|i| i.table()) else {
        return Drive::Fixed;
    };
    let help = "a rate of true strain, `{ strain_rate = \"-0.1 1/s\" }`, negative to compress; or a stress to hold, \
                `{ stress = \"10 kPa\", max_rate = \"1 1/s\" }`";
    let drive = rate_or_stress(&table, "strain_rate", &format!("`{key}`"), help);
    table.finish("what drives a length of the box");
    drive
}

/// A rate, by its key, or a stress with the largest rate.
fn rate_or_stress(table: &TableReader<'_>, rate_key: &str, what: &str, help: &str) -> Drive {
    let rate = table.optional_quantity(rate_key, Kind::NumberRate, Range::FINITE);
    let stress = table.optional_quantity("stress", Kind::Physical(Dimension::PRESSURE), Range::FINITE);
    let drive = match (rate, stress) {
        (Some(rate), None) => Drive::StrainRate(rate),
        (None, Some(target)) => Drive::Stress {
            target,
            max_rate: table.quantity(
                "max_rate",
                Kind::NumberRate,
                Range::POSITIVE,
                "the largest rate of strain, as \"1 1/s\"",
            ),
        },
        _ => {
            let message = format!("{what} needs either `{rate_key}` or `stress`");
            table.fault(message, Some(help.to_string()));
            Drive::Fixed
        }
    };
    // makes the key known for the suggestion on a misspelt one
    if rate.is_some() || stress.is_none() {
        table.optional("max_rate");
    }
    drive
}

fn shear(table: TableReader<'_>) -> Option<Shear> {
    let axis = |key: &str, meaning: &str| table.required(key, meaning).and_then(|i| i.choice(&AXES));
    let flow = axis("flow", "the direction in which images slide, as \"x\"");
    let gradient = axis("gradient", "the direction across which they slide, as \"y\"");
    let help =
        "a rate, `rate = \"10 1/s\"`; or a shear stress to hold, `stress = \"100 Pa\"` with `max_rate = \"100 1/s\"`";
    let drive = rate_or_stress(&table, "rate", "the shear", help);
    table.finish("the shear of the box");
    Some(Shear {
        axes: ShearAxes {
            flow: flow?,
            gradient: gradient?,
        },
        drive,
    })
}

/// Reads the stop conditions of a box that deforms.
pub(super) fn conditions(table: &TableReader<'_>, stop: &mut Vec<StopCondition>) {
    if let Some(told) = table.optional("box_stress").and_then(|i| i.table()) {
        let meaning = "the direction of the stress, as \"x\", or \"mean\" or \"shear\"";
        let direction = told.required("direction", meaning);
        let of = direction.and_then(|i| i.choice(&["x", "y", "z", "mean", "shear"]));
        let pressure = Kind::Physical(Dimension::PRESSURE);
        let above = told.optional_quantity("above", pressure, Range::FINITE);
        let below = told.optional_quantity("below", pressure, Range::FINITE);
        if above.is_some() == below.is_some() {
            told.fault("give either `above` or `below`", None);
        }
        let of = match of {
            Some(axis @ 0..=2) => StressOf::Axis(axis),
            Some(4) => StressOf::Shear,
            _ => StressOf::Mean,
        };
        stop.extend(above.map(|stress| StopCondition::BoxStress {
            of,
            stress,
            falls: false,
        }));
        stop.extend(below.map(|stress| StopCondition::BoxStress {
            of,
            stress,
            falls: true,
        }));
        told.finish("the condition box_stress");
    }
    if let Some(told) = table.optional("box_strain").and_then(|i| i.table()) {
        let axis = told.required("direction", "the direction of the strain, as \"x\"");
        let axis = axis.and_then(|i| i.choice(&AXES)).unwrap_or(0);
        let meaning = "the magnitude of the true strain that ends the stage, as 0.1";
        let strain = told.quantity("strain", Kind::Number, Range::POSITIVE, meaning);
        stop.push(StopCondition::BoxStrain { axis, strain });
        told.finish("the condition box_strain");
    }
    if let Some(shear) = table.optional_quantity("shear_strain", Kind::Number, Range::POSITIVE) {
        stop.push(StopCondition::ShearStrain(shear));
    }
}

/// What a condition on a box that deforms has come to, in words, when it is reached; a stress is found only where it `looks`.
pub(super) fn reached(stop: &StopCondition, sim: &Simulation, looks: bool) -> Option<String> {
    let is_reached = |found: f64, asked: f64| found.abs() >= asked * (1.0 - 1e-12);
    match *stop {
        StopCondition::BoxStress { of, stress, falls } => {
            let state = looks.then(|| sim.box_state())??;
            let (name, found) = match of {
                StressOf::Axis(axis) => (AXES[axis.min(2)], state.stress[axis.min(2)]),
                StressOf::Mean => ("mean", state.pressure()),
                StressOf::Shear => ("shear", state.shear_stress(sim.shear_axes()?)),
            };
            let is_reached = if falls { found <= stress } else { found >= stress };
            is_reached.then(|| format!("the stress of the box ({name}) is {found:.6e} Pa, {stress:e} Pa was asked"))
        }
        StopCondition::BoxStrain { axis, strain } => {
            let found = sim.stage_strain()?.0[axis.min(2)];
            is_reached(found, strain).then(|| format!("the strain of the box is {found:.6}"))
        }
        StopCondition::ShearStrain(strain) => {
            let found = sim.stage_strain()?.1;
            is_reached(found, strain).then(|| format!("the shear strain of the box is {found:.6}"))
        }
        _ => None,
    }
}

impl Scenario {
    /// Deformations of the box with the paths of the tables that tell them.
    pub(super) fn deformations(&self) -> impl Iterator<Item = (String, &Deformation)> {
        let first = self
            .domain
            .deform
            .iter()
            .map(|plan| ("domain.deform".to_string(), plan));
        let of_stages = (self.stages.iter().zip(&self.stage_paths))
            .filter_map(|(stage, path)| Some((format!("{path}.deform"), stage.deformation.as_ref()?)));
        first.chain(of_stages)
    }

    /// Whether the box deforms at any time.
    pub(super) fn deforms(&self) -> bool {
        self.deformations().next().is_some()
    }
}

/// Tells stages that wait for the shear of a box which is not sheared in them.
fn wait_in_vain(scenario: &Scenario, faults: &mut Diagnostics) {
    let mut plan = scenario.domain.deform.as_ref();
    let mut told = std::collections::BTreeSet::new();
    for (stage, path) in scenario.stages.iter().zip(&scenario.stage_paths) {
        plan = stage.deformation.as_ref().or(plan);
        let is_sheared = plan.is_some_and(|plan| plan.shear.is_some());
        let waits = stage.stop.iter().any(|stop| {
            use StopCondition::{BoxStress, ShearStrain};
            matches!(
                stop,
                ShearStrain(_)
                    | BoxStress {
                        of: StressOf::Shear,
                        ..
                    }
            )
        });
        if waits && !is_sheared && told.insert(path) {
            let help = "name a `shear` in the table `deform` of this stage, or of one before that none replaces";
            let message = "the stage waits for a shear strain or shear stress of the box, which is not sheared in it";
            faults.push(&format!("{path}.stop"), message, Some(help.to_string()));
        }
    }
}

/// Tells stresses below 0 of grains that never pull each other.
pub(super) fn check_tensions(scenario: &Scenario, grains: &Grains, laws: &[Bound<'_>], warnings: &mut Vec<String>) {
    let mut told: Vec<(String, f64)> = Vec::new();
    for (path, plan) in scenario.deformations() {
        let keys = AXES.into_iter().chain(["isotropic"]);
        let drives = plan.directions.into_iter().chain([plan.isotropic]);
        for (key, drive) in keys.zip(drives) {
            let path = format!("{path}.{key}.stress");
            match drive {
                // repeats of a stage have one table
                Drive::Stress { target, .. } if target < 0.0 && told.iter().all(|(before, _)| *before != path) => {
                    told.push((path, target));
                }
                _ => {}
            }
        }
    }
    let can_pull = |laws: &Bound<'_>| can_pull(grains, &laws.materials, scenario.simulation.max_overlap);
    if told.is_empty() || laws.iter().any(can_pull) {
        return;
    }
    warnings.extend(told.into_iter().map(|(path, target)| {
        format!(
            "`{path}` is a tension of {:e} Pa, and no law between these grains pulls: the box widens and never has it; tell 0 or more, \
             or take a normal law with adhesion",
            -target
        )
    }));
}

/// Tells stop conditions on a box that never deforms, and what does not go with one that does.
pub(super) fn check(scenario: &Scenario, grains: &Grains, dt: Option<f64>, faults: &mut Diagnostics) {
    if !scenario.deforms() {
        for (stage, path) in scenario.stages.iter().zip(&scenario.stage_paths) {
            let asks = |stop: &StopCondition| {
                use StopCondition::{BoxStrain, BoxStress, ShearStrain};
                matches!(stop, BoxStress { .. } | BoxStrain { .. } | ShearStrain(_))
            };
            if stage.stop.iter().any(asks) {
                let help = "tell how with a table `deform` of the domain or of a stage";
                let message = "the stage waits for a stress or strain of the box, and the box never deforms";
                faults.push(&format!("{path}.stop"), message, Some(help.to_string()));
                return;
            }
        }
        return;
    }
    let misfits = [
        (!scenario.walls.is_empty(), "wall[0]", Misfit::Walls),
        (
            scenario.simulation.gravity != DVec3::ZERO,
            "simulation.gravity",
            Misfit::Gravity,
        ),
        (
            scenario.simulation.integrator == Integrator::Gear,
            "simulation.integrator",
            Misfit::Gear,
        ),
        (!scenario.feeds.is_empty(), "feed[0]", Misfit::Traffic),
        (!scenario.removals.is_empty(), "removal[0]", Misfit::Traffic),
        (
            (0..grains.len()).any(|g| grains.is_fixed(g)),
            "grains",
            Misfit::FixedGrains,
        ),
    ];
    for (_, path, misfit) in misfits.into_iter().filter(|(is_there, ..)| *is_there) {
        faults.push(path, misfit.to_string(), None);
    }
    wait_in_vain(scenario, faults);
    let mut axes = None;
    let mut told = std::collections::BTreeSet::new();
    for (path, plan) in scenario.deformations() {
        // repeats of a stage have one table
        if !told.insert(path.clone()) {
            continue;
        }
        // what a time step has to do with it is told when there is one
        if let Err(error) = plan.check(scenario.domain.periodic, dt.unwrap_or(0.0)) {
            faults.push(&path, error.to_string(), None);
        }
        if let Some(shear) = &plan.shear {
            let first = *axes.get_or_insert(shear.axes);
            if first != shear.axes {
                let error = DeformationError::OtherShear {
                    flow: AXES[first.flow],
                    gradient: AXES[first.gradient],
                };
                faults.push(&format!("{path}.shear"), error.to_string(), None);
            }
        }
    }
}
