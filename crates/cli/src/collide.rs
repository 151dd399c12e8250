//! `demeter collide`.

use crate::answer::{Rows, answer, answer_json, note};
use crate::arguments::CollideArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::plot::write as write_plot;
use crate::readable::{number, vector};
use crate::table::{Cell, check_outputs, write_csv};
use demeter::calibrate::{CollideReport, Engine, collide as run};
use demeter::output::{Plot, Series};
use demeter::scenario::{DEFAULT_MAX_OVERLAP, ImpactFile};
use demeter_physics::collision::Start;

/// Rows of the course of a collision.
const MOMENTS: usize = 501;

/// Collides two bodies and tells what became of them.
pub fn collide(arguments: &CollideArguments) -> Result<Exit, Failure> {
    check_outputs(
        &arguments.file,
        arguments.csv.as_deref(),
        arguments.plot.as_deref(),
        arguments.overwrite,
    )?;
    let file = ImpactFile::read(&arguments.file, &arguments.set)?;
    let engine = if arguments.engine {
        Engine::Automatic
    } else {
        Engine::Reference
    };
    let wanted = arguments.csv.is_some() || arguments.plot.is_some();
    let report = run(&file, engine, if wanted { MOMENTS } else { 0 })?;
    let smaller = file.b.body().map_or(file.a.radius, |b| b.radius.min(file.a.radius));
    let share = report.max_overlap / smaller;
    if share > DEFAULT_MAX_OVERLAP {
        note(&format!(
            "warning: the bodies overlap by {} of the smaller radius; the laws hold for small overlaps, and a run stops at {DEFAULT_MAX_OVERLAP} \
             unless it is told otherwise (`simulation.max_overlap`)",
            number(share)
        ));
    }
    if let Some(path) = &arguments.csv {
        let rows = report.moments.iter();
        let rows = rows.map(|m| [m.time, m.overlap, m.rate, m.force].map(Cell::Number).into());
        write_csv(path, &["time [s]", "overlap [m]", "rate [m/s]", "force [N]"], rows)?;
    }
    if let Some(path) = &arguments.plot {
        write_plot(&plot(&file, &report), path)?;
    }
    if arguments.json {
        answer_json(&report.to_json())?;
    } else {
        answer(&to_text(&report, file.impact.start))?;
    }
    Ok(Exit::Finished)
}

fn plot(file: &ImpactFile, report: &CollideReport) -> Plot {
    let points = report.moments.iter().map(|m| (m.overlap, m.force)).collect();
    Plot {
        title: format!("{}: {}", file.name, report.outcome.name()),
        x_label: "overlap [m]".to_string(),
        y_label: "normal force [N]".to_string(),
        series: vec![Series::line("normal force", points)],
        ..Plot::default()
    }
}

fn to_text(report: &CollideReport, start: Start) -> String {
    let mut rows = Rows::default();
    let absent = "none: they never part";
    rows.add("outcome", report.outcome.name());
    rows.add("restitution", number(report.restitution));
    if let Some(tangential) = report.tangential_restitution {
        rows.add("tangential restitution", number(tangential));
        rows.add("angle out", format!("{} deg", number(report.angle_out.to_degrees())));
    }
    // with an attraction across the gap the bodies feel each other for longer than they touch
    let of_what = match (report.reach > 0.0, start) {
        (false, _) => "",
        (true, Start::Far) => ", from the first pull across the gap to the last",
        (true, Start::Contact) => ", from first touch to the last pull across the gap",
    };
    let time = report.contact_time.map(|t| format!("{} s{of_what}", number(t)));
    rows.add("contact time", time.unwrap_or_else(|| absent.to_string()));
    rows.add("largest overlap", format!("{} m", number(report.max_overlap)));
    rows.add("largest force", format!("{} N", number(report.max_force)));
    for (body, k) in [("a", 0), ("b", 1)] {
        rows.add(
            format!("velocity of {body}"),
            format!("{} m/s", vector(report.velocity[k].to_array())),
        );
        if report.spin[k].length_squared() > 0.0 {
            rows.add(
                format!("spin of {body}"),
                format!("{} rad/s", vector(report.spin[k].to_array())),
            );
        }
    }
    for (name, value) in report.energies() {
        if value != 0.0 {
            rows.add(name.replace('_', " "), format!("{} J", number(value)));
        }
    }
    if let Some(error) = report.estimated_error {
        rows.add("estimated error", format!("{error:.1e}"));
    }
    if let Some(dt) = report.time_step {
        rows.add("time step", format!("{} s", number(dt)));
    }
    format!("{}\n{}", report.method, rows.lines())
}
