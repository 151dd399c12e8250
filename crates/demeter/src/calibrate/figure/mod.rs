//! The figures of the papers whose mathematics Demeter uses, drawn anew and checked on the way.
//!
//! Where a figure has a closed form, lines are the closed form and circles the error-controlled integration of the
//! contact law that a run uses; the largest difference of the two is told. Where it has none, what the law did is
//! compared with the equations of the paper.
//!
//! * D. Antypov and J. A. Elliott, On an analytical solution for the damped Hertzian spring, EPL 94 (2011) 50004
//! * R. Jasevičius, R. Kačianauskas and J. Tomas, Simulation of normal impact of ultrafine adhesive particles (2009)

mod damped_springs;
mod limestone;
mod load_displacement;
mod sticking_speed;
#[cfg(test)]
mod tests;

use super::error::CalibrateError;
use crate::output::Sheet;
use damped_springs::{contact_times, longer_contacts, phase_trajectories};
use demeter_physics::collision::Start;
use load_displacement::{loops, swings};
use std::fmt;
use sticking_speed::sticking_speeds;

/// A figure that can be drawn.
#[derive(Clone, Copy, Debug)]
pub struct FigureInfo {
    /// Its name.
    pub name: &'static str,
    /// What it shows.
    pub title: &'static str,
    draw: fn() -> Result<Drawing, CalibrateError>,
}

/// All figures.
pub const FIGURES: &[FigureInfo] = &[
    FigureInfo {
        name: "antypov-1",
        title: "velocity against overlap in a collision of MCC grains, linear and Hertzian spring-dashpot (fig 1)",
        draw: phase_trajectories,
    },
    FigureInfo {
        name: "antypov-2",
        title: "contact time against impact velocity for several restitutions (fig 2)",
        draw: contact_times,
    },
    FigureInfo {
        name: "antypov-3",
        title: "how much longer damping makes a collision, against the restitution (fig 3)",
        draw: longer_contacts,
    },
    FigureInfo {
        name: "jasevicius-3",
        title: "overlap, velocity and force of limestone grains that stick, against time (fig 3)",
        draw: swings,
    },
    FigureInfo {
        name: "jasevicius-4",
        title: "force against overlap of limestone grains at 2 mm/min and 2 m/min (fig 4)",
        draw: loops,
    },
    FigureInfo {
        name: "jasevicius-5",
        title: "critical sticking velocity against effective radius, elastic and elastic-plastic (fig 5)",
        draw: || sticking_speeds(Start::Contact),
    },
    FigureInfo {
        name: "jasevicius-5-escape",
        title: "the same for grains that come from afar and must escape the van der Waals attraction",
        draw: || sticking_speeds(Start::Far),
    },
];

/// What a figure shows.
#[derive(Clone, Debug)]
struct Drawing {
    sheet: Sheet,
    table: Table,
    checks: Vec<Check>,
}

/// A figure, drawn.
#[derive(Clone, Debug)]
pub struct Figure {
    /// Which one.
    pub info: &'static FigureInfo,
    /// The plots.
    pub sheet: Sheet,
    /// The numbers in them.
    pub table: Table,
    /// What was compared.
    pub checks: Vec<Check>,
}

/// Numbers of a figure.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Table {
    /// Titles of the columns of numbers, with units. Before them stands the name of the curve.
    pub titles: Vec<&'static str>,
    /// Rows: curve and numbers.
    pub rows: Vec<(String, Vec<f64>)>,
}

impl Table {
    fn new(titles: &[&'static str]) -> Self {
        Self {
            titles: titles.to_vec(),
            rows: Vec::new(),
        }
    }

    fn add(&mut self, curve: impl Into<String>, row: &[f64]) {
        self.rows.push((curve.into(), row.to_vec()));
    }

    /// The rows of a curve.
    pub fn curve<'a>(&'a self, name: &'a str) -> impl Iterator<Item = &'a [f64]> {
        let rows = self.rows.iter().filter(move |row| row.0 == name);
        rows.map(|row| row.1.as_slice())
    }
}

/// Two ways to the same numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct Check {
    /// What was compared.
    pub what: String,
    /// The largest difference, over the largest value.
    pub largest: f64,
}

impl fmt::Display for Check {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: largest difference {:.1e}", self.what, self.largest)
    }
}

/// The figure of this name, if there is one.
pub fn find_figure(name: &str) -> Option<&'static FigureInfo> {
    FIGURES.iter().find(|figure| figure.name == name)
}

/// Computes a figure.
pub fn draw_figure(info: &'static FigureInfo) -> Result<Figure, CalibrateError> {
    let Drawing { sheet, table, checks } = (info.draw)()?;
    Ok(Figure {
        info,
        sheet,
        table,
        checks,
    })
}
