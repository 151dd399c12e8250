//! Figures 3 and 4 of Jasevičius, Kačianauskas and Tomas (2009): limestone grains that stick, and loops of force
//! against overlap.
//!
//! The captions of fig 4 are swapped in the paper: grains stick at 2 mm/min and part at 2 m/min, as its text says.

use super::limestone::{ALPHAS, PaperContact, RADIUS, law, size};
use super::{Check, Drawing, Table};
use crate::calibrate::CalibrateError;
use crate::output::{Look, Plot, Series, Sheet};
use demeter_physics::collision::{HeadOn, Moment, Start, Tolerance};

/// 2 mm/min [m/s].
const SLOW: f64 = 2e-3 / 60.0;
/// 2 m/min [m/s].
const FAST: f64 = 2.0 / 60.0;

/// How long fig 3 goes on [s].
const SWINGS: f64 = 120e-9;
/// By then even the weakest dashpot has brought the grains of fig 4 to rest [s].
const REST: f64 = 600e-9;
/// Rows of a curve.
const ROWS: usize = 3001;

/// Whether grains are followed beyond their second reversal, and for how long [s].
#[derive(Clone, Copy)]
enum Until {
    Parted,
    Time(f64),
}

/// The course of an impact, its largest overlap, and the largest difference from the paper's equations.
struct Course {
    moments: Vec<Moment>,
    deepest: f64,
    difference: f64,
    paper: PaperContact,
}

fn course(alpha: f64, speed: f64, until: Until) -> Result<Course, CalibrateError> {
    let impact = HeadOn {
        law: &law(alpha, false, "none")?,
        size: size(RADIUS),
        speed,
        start: Start::Contact,
    };
    let tolerance = Tolerance::default();
    let (found, mut moments) = impact.run_recorded(&tolerance, ROWS)?;
    if let Until::Time(time) = until {
        moments = impact.follow(&tolerance, time, ROWS)?;
    }
    let paper = PaperContact::new(RADIUS, alpha);
    let mut turned = false;
    let (mut difference, mut largest): (f64, f64) = (0.0, 0.0);
    for moment in &moments {
        turned |= moment.rate <= 0.0;
        let before = if turned {
            found.max_overlap
        } else {
            moment.overlap.max(paper.yield_overlap())
        };
        // where contact ends the fourth root of the elastic part would magnify rounding
        if moment.overlap - paper.foot(before) < 1e-9 * before {
            continue;
        }
        let force = paper.force(moment.overlap, moment.rate, before);
        largest = largest.max(force.abs());
        difference = difference.max((force - moment.force).abs());
    }
    Ok(Course {
        moments,
        deepest: found.max_overlap,
        difference: difference / largest,
        paper,
    })
}

/// Where grains rest, by the equations of the paper, against where they came to rest.
fn rest_difference(course: &Course) -> f64 {
    let rest = course.paper.rest(course.deepest);
    course.moments.last().map_or(1.0, |m| (m.overlap / rest - 1.0).abs())
}

fn plot(title: &str, x_label: &str, y_label: &str) -> Plot {
    Plot {
        title: title.to_string(),
        x_label: x_label.to_string(),
        y_label: y_label.to_string(),
        ..Plot::default()
    }
}

const TITLES: [&str; 6] = [
    "impact velocity [m/s]",
    "alpha_d",
    "time [s]",
    "overlap [m]",
    "velocity [m/s]",
    "force [N]",
];

/// Figure 3.
pub(super) fn swings() -> Result<Drawing, CalibrateError> {
    let mut table = Table::new(&TITLES);
    let time = "time [ns]";
    let mut plots = vec![
        plot(
            "Limestone grains that stick, R_eff = 0.3 µm, 2 mm/min",
            time,
            "overlap [pm]",
        ),
        plot("", time, "velocity of approach [mm/s]"),
        plot("", time, "normal force [nN]"),
    ];
    let (mut checks, mut force): (_, f64) = (Vec::new(), 0.0);
    for (colour, alpha, look) in [(0, 0.2, Look::Line), (7, 0.0, Look::Dotted)] {
        let course = course(alpha, SLOW, Until::Time(SWINGS))?;
        for m in &course.moments {
            table.add("sticking", &[SLOW, alpha, m.time, m.overlap, m.rate, m.force]);
        }
        let of = |value: fn(&Moment) -> f64| course.moments.iter().map(|m| (1e9 * m.time, value(m))).collect();
        let shown: [Vec<(f64, f64)>; 3] = [of(|m| 1e12 * m.overlap), of(|m| 1e3 * m.rate), of(|m| 1e9 * m.force)];
        for (plot, points) in plots.iter_mut().zip(shown) {
            let name = format!("α_d = {alpha}");
            plot.series.push(Series::line(name, points).with(look, colour));
        }
        force = force.max(course.difference);
    }
    let equilibrium = rest_difference(&course(ALPHAS[0], SLOW, Until::Time(REST))?);
    checks.push(Check {
        what: "force on the way, against eqs 3, 7, 9 and 13".to_string(),
        largest: force,
    });
    checks.push(Check {
        what: "overlap at rest, against that at which the force of the paper is zero".to_string(),
        largest: equilibrium,
    });
    Ok(Drawing {
        sheet: Sheet { plots, columns: 1 },
        table,
        checks,
    })
}

/// Figure 4.
pub(super) fn loops() -> Result<Drawing, CalibrateError> {
    let mut table = Table::new(&TITLES);
    let mut plots = vec![
        plot(
            "v0 = 2 mm/min: grains stick (limestone, R_eff = 0.3 µm)",
            "overlap [pm]",
            "normal force [nN]",
        ),
        plot(
            "v0 = 2 m/min: grains part (limestone, R_eff = 0.3 µm)",
            "overlap [nm]",
            "normal force [nN]",
        ),
    ];
    let (mut force, mut rest): (f64, f64) = (0.0, 0.0);
    for (colour, alpha) in ALPHAS.into_iter().enumerate() {
        let slow = course(alpha, SLOW, Until::Time(REST))?;
        let fast = course(alpha, FAST, Until::Parted)?;
        let shown = [("sticking", SLOW, &slow, 1e12), ("detachment", FAST, &fast, 1e9)];
        for (plot, (curve, speed, course, unit)) in plots.iter_mut().zip(shown) {
            for m in &course.moments {
                table.add(curve, &[speed, alpha, m.time, m.overlap, m.rate, m.force]);
            }
            let points = course.moments.iter().map(|m| (unit * m.overlap, 1e9 * m.force));
            let series = Series::line(format!("α_d = {alpha}"), points.collect());
            plot.series.push(series.with(Look::Line, colour));
            force = force.max(course.difference);
        }
        rest = rest.max(rest_difference(&slow));
    }
    let checks = vec![
        Check {
            what: "force on the way, against eqs 3, 7, 9 and 13".to_string(),
            largest: force,
        },
        Check {
            what: "overlap at rest, against that at which the force of the paper is zero".to_string(),
            largest: rest,
        },
    ];
    Ok(Drawing {
        sheet: Sheet { plots, columns: 2 },
        table,
        checks,
    })
}
