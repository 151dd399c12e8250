//! Figure 5 of Jasevičius, Kačianauskas and Tomas (2009): the critical sticking velocity against the effective radius.
//!
//! As the paper's figure reads, the velocity is that at first touch and grains are free where the surfaces part
//! (`Start::Contact`). With the attraction across the gap they come from afar and must escape it (`Start::Far`), which
//! takes 5 to 20 times the velocity.

use super::limestone::{ALPHAS, PaperContact, law, size};
use super::{Check, Drawing, Table};
use crate::calibrate::{CalibrateError, log_spaced};
use crate::output::{AxisSpec, Look, Plot, Series, Sheet};
use demeter_physics::collision::{Start, Sticking, Tolerance, sticking_speed_of};
use rayon::prelude::*;

/// Effective radii [m].
const RADII: (f64, f64) = (0.1e-6, 1e-6);
/// Points of a line.
const POINTS: usize = 13;

/// A line of the figure.
#[derive(Clone, Copy)]
pub(super) struct Loading {
    pub alpha: f64,
    pub elastic: bool,
}

impl Loading {
    fn name(self) -> &'static str {
        if self.elastic { "elastic" } else { "elastic-plastic" }
    }

    /// Critical velocities [m/s] at effective radii [m].
    pub fn speeds(self, start: Start, radii: &[f64]) -> Result<Vec<(f64, f64)>, CalibrateError> {
        let tail = if start == Start::Far { "full" } else { "none" };
        let law = law(self.alpha, self.elastic, tail)?;
        let one = |&radius: &f64| match sticking_speed_of(&law, size(radius), start, &Tolerance::default())? {
            Sticking::Below(speed) => Ok((radius, speed)),
            Sticking::Never(_) | Sticking::From { .. } | Sticking::Always(_) => {
                Err(CalibrateError::NoStickingSpeed { radius })
            }
        };
        radii.par_iter().map(one).collect()
    }
}

/// Figure 5.
pub(super) fn sticking_speeds(start: Start) -> Result<Drawing, CalibrateError> {
    let mut table = Table::new(&["alpha_d", "effective radius [m]", "critical sticking velocity [m/s]"]);
    let logarithmic = AxisSpec {
        logarithmic: true,
        range: None,
    };
    let title = match start {
        Start::Contact => "Limestone grains stick below: velocity at first touch",
        Start::Far => "Limestone grains stick below: velocity far away",
    };
    let mut plot = Plot {
        title: title.to_string(),
        x_label: "effective radius [µm]".to_string(),
        y_label: "critical sticking velocity [m/s]".to_string(),
        x: AxisSpec {
            range: Some((0.9 * 1e6 * RADII.0, 1.1 * 1e6 * RADII.1)),
            ..logarithmic
        },
        y: AxisSpec {
            // room for the legend
            range: Some(match start {
                Start::Contact => (3e-5, 0.2),
                Start::Far => (2e-4, 10.0),
            }),
            ..logarithmic
        },
        ..Plot::default()
    };
    let radii = log_spaced(RADII.0, RADII.1, POINTS);
    let mut power: f64 = 0.0;
    for elastic in [false, true] {
        for (colour, alpha) in ALPHAS.into_iter().enumerate() {
            let loading = Loading { alpha, elastic };
            let found = loading.speeds(start, &radii)?;
            for &(radius, speed) in &found {
                table.add(loading.name(), &[alpha, radius, speed]);
                let expected = found[0].1 * libm::pow(radius / RADII.0, -5.0 / 6.0);
                power = power.max(if elastic { (speed / expected - 1.0).abs() } else { 0.0 });
            }
            let look = if elastic { Look::Dashed } else { Look::Line };
            let points = found.iter().map(|p| (1e6 * p.0, p.1)).collect();
            let label = format!("{}, α_d = {alpha}", loading.name());
            plot.series.push(Series::line(label, points).with(look, colour));
        }
    }
    let mut checks = Vec::new();
    if start == Start::Contact {
        checks.push(Check {
            what: "elastic, against the power -5/6 of the radius".to_string(),
            largest: power,
        });
        checks.push(undamped(&radii, &mut table, &mut plot)?);
    }
    Ok(Drawing {
        sheet: Sheet {
            plots: vec![plot],
            columns: 1,
        },
        table,
        checks,
    })
}

/// Without a dashpot energy alone gives the velocity, up to the radius beyond which grains do not stick.
fn undamped(radii: &[f64], table: &mut Table, plot: &mut Plot) -> Result<Check, CalibrateError> {
    let loading = Loading {
        alpha: 0.0,
        elastic: false,
    };
    let by_energy = |radius: f64| PaperContact::new(radius, 0.0).undamped_sticking_speed();
    let small: Vec<f64> = radii.iter().copied().filter(|r| by_energy(*r).is_some()).collect();
    let found = loading.speeds(Start::Contact, &small)?;
    let (mut line, mut largest): (_, f64) = (Vec::new(), 0.0);
    for &(radius, speed) in &found {
        let exact = by_energy(radius).unwrap_or(f64::NAN);
        table.add("elastic-plastic", &[0.0, radius, speed]);
        table.add("elastic-plastic by energy", &[0.0, radius, exact]);
        line.push((1e6 * radius, exact));
        largest = largest.max((speed / exact - 1.0).abs());
    }
    let circles = found.iter().map(|p| (1e6 * p.0, p.1)).collect();
    let name = "elastic-plastic, undamped, by energy";
    plot.series.push(Series::line(name, line).with(Look::Dotted, 7));
    plot.series
        .push(Series::line("integrated", circles).with(Look::Circles, 7));
    Ok(Check {
        what: "elastic-plastic without damping, integrated against the balance of energy".to_string(),
        largest,
    })
}
