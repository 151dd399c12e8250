//! Figures 1 to 3 of Antypov and Elliott (2011): linear (LSD) and Hertzian (HSD) spring-dashpot.
//!
//! Two spheres of microcrystalline cellulose, d = 1 cm, E = 6 GPa, nu = 0.3, 1500 kg/m^3 (not told in the paper) and
//! restitution 0.54 meet at 1 m/s. The linear spring has the stiffness 2/3 E_eff d, for which both have the same
//! trajectory but for the scale of the overlap (eq 19).

use super::{Check, Drawing, Table};
use crate::calibrate::{CalibrateError, log_spaced};
use crate::output::{AxisSpec, Look, Plot, Series, Sheet};
use demeter_physics::collision::{HeadOn, Moment, Start, Tolerance};
use demeter_physics::contact::normal::NormalLaw;
use demeter_physics::contact::{Elastic, MaterialPair, PairSize};
use demeter_physics::parameters::values;
use demeter_physics::restitution::ContactEnd::ZeroOverlap;
use demeter_physics::restitution::duration::{contact_time_first_order, contact_time_quadratic, ratio_at_zero_overlap};
use demeter_physics::restitution::hertz::HertzCollision;
use demeter_physics::restitution::inverse::{Collision, SpringDashpot};
use demeter_physics::restitution::linear::{LinearCollision, PhasePoint};
use demeter_physics::restitution::power::PowerScale;
use demeter_physics::root::bracketed;
use std::f64::consts::PI;

const DIAMETER: f64 = 0.01;
const DENSITY: f64 = 1500.0;
const MCC: Elastic = Elastic {
    young_modulus: 6e9,
    poisson_ratio: 0.3,
};
const PAIR: MaterialPair = MaterialPair { a: MCC, b: MCC };
const RESTITUTION: f64 = 0.54;
const SPEED: f64 = 1.0;

/// Half of the mass of a grain, and a quarter of its diameter.
fn size() -> PairSize {
    PairSize::new(
        0.25 * DIAMETER,
        0.5 * DENSITY * PI / 6.0 * DIAMETER * DIAMETER * DIAMETER,
    )
}

/// Stiffness of a spring-dashpot [N/m] or [N/m^(3/2)].
fn stiffness(spring: SpringDashpot) -> f64 {
    let modulus = PAIR.effective_modulus();
    match spring {
        SpringDashpot::Linear => 2.0 / 3.0 * modulus * DIAMETER,
        SpringDashpot::Hertz => 4.0 / 3.0 * modulus * size().radius.sqrt(),
    }
}

fn scale(spring: SpringDashpot, speed: f64) -> PowerScale {
    PowerScale {
        exponent: spring.exponent(),
        mass: size().mass,
        stiffness: stiffness(spring),
        speed,
    }
}

/// The contact law that a run uses.
fn law(spring: SpringDashpot, restitution: f64) -> Result<NormalLaw, CalibrateError> {
    let parameters = match spring {
        SpringDashpot::Linear => values(&[("stiffness", stiffness(spring)), ("restitution", restitution)]),
        SpringDashpot::Hertz => values(&[("restitution", restitution)]),
    };
    let name = match spring {
        SpringDashpot::Linear => "linear",
        SpringDashpot::Hertz => "hertz-tsuji",
    };
    Ok(NormalLaw::build(name, &parameters, &PAIR)?)
}

/// A collision of that law, integrated: contact time, and so many moments.
fn integrated(
    spring: SpringDashpot,
    restitution: f64,
    speed: f64,
    count: usize,
) -> Result<(f64, Vec<Moment>), CalibrateError> {
    let impact = HeadOn {
        law: &law(spring, restitution)?,
        size: size(),
        speed,
        start: Start::Contact,
    };
    let (found, moments) = impact.run_recorded(&Tolerance::default(), count)?;
    Ok((found.duration, moments))
}

fn abbreviation(spring: SpringDashpot) -> &'static str {
    match spring {
        SpringDashpot::Linear => "LSD",
        SpringDashpot::Hertz => "HSD",
    }
}

const SPRINGS: [SpringDashpot; 2] = [SpringDashpot::Linear, SpringDashpot::Hertz];

/// The closed form of the trajectory.
enum Closed {
    Linear(LinearCollision),
    Hertz(HertzCollision),
}

impl Closed {
    fn of(spring: SpringDashpot) -> Result<Self, CalibrateError> {
        Ok(match spring {
            SpringDashpot::Linear => Self::Linear(LinearCollision::from_restitution(RESTITUTION, ZeroOverlap)?),
            SpringDashpot::Hertz => Self::Hertz(HertzCollision::from_restitution(RESTITUTION, ZeroOverlap)?),
        })
    }

    fn at(&self, phase: f64) -> PhasePoint {
        match self {
            Self::Linear(linear) => linear.at(phase),
            Self::Hertz(hertz) => hertz.at(phase),
        }
    }

    fn end_phase(&self) -> Result<f64, CalibrateError> {
        Ok(match self {
            Self::Linear(linear) => linear.end_phase(ZeroOverlap)?,
            Self::Hertz(hertz) => hertz.end_phase(ZeroOverlap)?,
        })
    }
}

/// Points of a line, and circles on it.
const LINE: u32 = 301;
const CIRCLES: usize = 31;

/// Figure 1.
pub(super) fn phase_trajectories() -> Result<Drawing, CalibrateError> {
    let mut table = Table::new(&["time [s]", "overlap [m]", "velocity [m/s]", "force [N]"]);
    let mut plot = Plot {
        title: format!("Collision of two 1 cm grains of MCC, restitution {RESTITUTION}"),
        x_label: "overlap [µm]".to_string(),
        y_label: "velocity of approach [m/s]".to_string(),
        ..Plot::default()
    };
    let mut checks = Vec::new();
    for (k, spring) in SPRINGS.into_iter().enumerate() {
        let (closed, scale, name) = (Closed::of(spring)?, scale(spring, SPEED), abbreviation(spring));
        let last = closed.end_phase()?;
        let line: Vec<[f64; 4]> = (0..LINE)
            .map(|point| last * f64::from(point) / f64::from(LINE - 1))
            .map(|phase| in_si(closed.at(phase), &scale))
            .collect();
        let (duration, moments) = integrated(spring, RESTITUTION, SPEED, CIRCLES)?;
        let mut largest: f64 = 0.0;
        let depth = line.iter().map(|p| p[1]).fold(0.0, f64::max);
        for moment in &moments {
            let early = |phase: f64| closed.at(phase).time * scale.time() - moment.time;
            let phase = if moment.time >= duration {
                last
            } else if moment.time > 0.0 {
                bracketed(early, 0.0, last)
            } else {
                0.0
            };
            let exact = in_si(closed.at(phase), &scale);
            largest = largest.max((exact[1] - moment.overlap).abs() / depth);
            largest = largest.max((exact[2] - moment.rate).abs() / SPEED);
        }
        let closed_name = format!("{name} closed form");
        for point in &line {
            table.add(&closed_name, point);
        }
        for m in &moments {
            table.add(format!("{name} integrated"), &[m.time, m.overlap, m.rate, m.force]);
        }
        let look = [Look::Line, Look::Dashed][k];
        let points = line.iter().map(|p| (1e6 * p[1], p[2])).collect();
        plot.series.push(Series::line(name, points).with(look, k));
        let circles = moments.iter().map(|m| (1e6 * m.overlap, m.rate)).collect();
        let label = if k == 0 { "" } else { "integrated" };
        plot.series.push(Series::line(label, circles).with(Look::Circles, k));
        checks.push(Check {
            what: format!("{name}, overlap and velocity, integrated against eqs 5, 6 and 19"),
            largest,
        });
    }
    Ok(alone(plot, table, checks))
}

/// Time, overlap, velocity and force.
fn in_si(point: PhasePoint, scale: &PowerScale) -> [f64; 4] {
    [
        point.time * scale.time(),
        point.overlap * scale.length(),
        point.speed * scale.speed,
        point.force * scale.force(),
    ]
}

fn alone(plot: Plot, table: Table, checks: Vec<Check>) -> Drawing {
    Drawing {
        sheet: Sheet {
            plots: vec![plot],
            columns: 1,
        },
        table,
        checks,
    }
}

/// Restitutions of figure 2.
const RESTITUTIONS: [f64; 3] = [1.0, 0.1, 0.01];

/// Impact speeds of figure 2 [m/s].
const SPEEDS: (f64, f64) = (1e-2, 10.0);

/// Figure 2.
pub(super) fn contact_times() -> Result<Drawing, CalibrateError> {
    let mut table = Table::new(&["restitution", "impact velocity [m/s]", "contact time [s]"]);
    let logarithmic = AxisSpec {
        logarithmic: true,
        range: None,
    };
    let mut plot = Plot {
        title: "Contact time of two 1 cm grains of MCC".to_string(),
        x_label: "impact velocity [m/s]".to_string(),
        y_label: "contact time [µs]".to_string(),
        x: logarithmic,
        y: AxisSpec {
            range: Some((10.0, 1000.0)),
            ..logarithmic
        },
        ..Plot::default()
    };
    let mut checks = Vec::new();
    for spring in SPRINGS {
        let name = abbreviation(spring);
        let mut largest: f64 = 0.0;
        for (colour, restitution) in RESTITUTIONS.into_iter().enumerate() {
            let exact = |speed: f64| -> Result<f64, CalibrateError> {
                let collision = Collision {
                    law: spring,
                    end: ZeroOverlap,
                    mass: size().mass,
                    speed,
                    restitution,
                };
                Ok(collision.extent(stiffness(spring))?.contact_time)
            };
            let mut line = Vec::new();
            for speed in log_spaced(SPEEDS.0, SPEEDS.1, 25) {
                let time = exact(speed)?;
                table.add(format!("{name} closed form"), &[restitution, speed, time]);
                line.push((speed, 1e6 * time));
            }
            let mut circles = Vec::new();
            for speed in log_spaced(SPEEDS.0, SPEEDS.1, 7) {
                let (time, _) = integrated(spring, restitution, speed, 0)?;
                largest = largest.max((time / exact(speed)? - 1.0).abs());
                table.add(format!("{name} integrated"), &[restitution, speed, time]);
                circles.push((speed, 1e6 * time));
            }
            let look = match spring {
                SpringDashpot::Linear => Look::Dashed,
                SpringDashpot::Hertz => Look::Line,
            };
            let label = format!("{name}, restitution {restitution}");
            plot.series.push(Series::line(label, line).with(look, colour));
            plot.series.push(Series::line("", circles).with(Look::Circles, colour));
        }
        checks.push(Check {
            what: format!("{name}, contact time, integrated against the closed form"),
            largest,
        });
    }
    Ok(alone(plot, table, checks))
}

/// Figure 3.
pub(super) fn longer_contacts() -> Result<Drawing, CalibrateError> {
    let mut table = Table::new(&["restitution", "contact time over that at restitution 1"]);
    let mut plot = Plot {
        title: "Contact time against that without damping".to_string(),
        x_label: "restitution".to_string(),
        y_label: "contact time, relative".to_string(),
        x: AxisSpec {
            logarithmic: false,
            range: Some((0.0, 1.0)),
        },
        y: AxisSpec {
            logarithmic: false,
            range: Some((0.9, 2.8)),
        },
        ..Plot::default()
    };
    let linear = |e: f64| {
        let loss = libm::log(e);
        (loss * loss + PI * PI).sqrt() / PI
    };
    type Ratio<'a> = &'a dyn Fn(f64) -> f64;
    let curves: [(&str, Ratio<'_>, Look, usize); 4] = [
        ("HSD exact", &ratio_at_zero_overlap, Look::Line, 1),
        ("HSD fit eq 29", &contact_time_quadratic, Look::Dotted, 3),
        ("HSD first order eq 28", &contact_time_first_order, Look::Dotted, 7),
        ("LSD eq 25", &linear, Look::Dashed, 0),
    ];
    for (name, ratio, look, colour) in curves {
        let steep = (5..50).map(|k| 0.002 * f64::from(k));
        let restitutions = steep.chain((10..=100).map(|k| 0.01 * f64::from(k)));
        let line: Vec<(f64, f64)> = restitutions.map(|e| (e, ratio(e))).collect();
        for &(e, value) in &line {
            table.add(name, &[e, value]);
        }
        plot.series.push(Series::line(name, line).with(look, colour));
    }
    let mut checks = Vec::new();
    for (spring, ratio, colour) in [
        (SpringDashpot::Hertz, &ratio_at_zero_overlap as Ratio<'_>, 1),
        (SpringDashpot::Linear, &linear, 0),
    ] {
        let name = abbreviation(spring);
        let (undamped, _) = integrated(spring, 1.0, SPEED, 0)?;
        let (mut circles, mut largest): (_, f64) = (Vec::new(), 0.0);
        for k in 0..=20 {
            let e = if k == 0 { 0.01 } else { 0.05 * f64::from(k) };
            let value = integrated(spring, e, SPEED, 0)?.0 / undamped;
            largest = largest.max((value / ratio(e) - 1.0).abs());
            table.add(format!("{name} integrated"), &[e, value]);
            circles.push((e, value));
        }
        let label = if colour == 1 { "integrated" } else { "" };
        plot.series
            .push(Series::line(label, circles).with(Look::Circles, colour));
        checks.push(Check {
            what: format!("{name}, contact time, integrated against the closed form"),
            largest,
        });
    }
    Ok(alone(plot, table, checks))
}
