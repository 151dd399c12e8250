//! Means over cycles, at the same position in the stroke.

use super::error::CompareError;
use super::forces::{Contacts, Forces};

/// What a level of a stroke is told by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Position {
    /// The strain column of a series.
    Strain,
    /// Way of the plate since the strain was 0, or since the loading began where no strain is told [m].
    Compression,
    /// Time since the start of the stage [s].
    StageTime,
}

impl Position {
    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Strain => "strain",
            Self::Compression => "compression",
            Self::StageTime => "stage time",
        }
    }

    /// Title of a column of it.
    pub fn title(self) -> &'static str {
        match self {
            Self::Strain => "strain",
            Self::Compression => "compression [m]",
            Self::StageTime => "stage time [s]",
        }
    }
}

/// The two halves of a cycle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Phase {
    /// The plate comes.
    Loading,
    /// The plate goes.
    Unloading,
}

impl Phase {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Loading, Self::Unloading];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Loading => "loading",
            Self::Unloading => "unloading",
        }
    }
}

/// A mean over cycles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mean {
    /// The mean.
    pub value: f64,
    /// Standard deviation of the cycles (with `n - 1`), when there are two or more.
    pub deviation: Option<f64>,
    /// Number of cycles.
    pub cycles: usize,
}

impl Mean {
    /// Of some values; not a number when there are none.
    pub fn of(values: &[f64]) -> Self {
        let n = values.len() as f64;
        let value = values.iter().sum::<f64>() / n;
        let squares: f64 = values.iter().map(|x| (x - value) * (x - value)).sum();
        Self {
            value,
            deviation: (values.len() > 1).then(|| (squares / (n - 1.0)).sqrt()),
            cycles: values.len(),
        }
    }

    /// A value of which nothing more is known.
    pub fn single(value: f64) -> Self {
        Self::of(&[value])
    }

    /// Standard error: the deviation over the root of the number of cycles.
    pub fn error(&self) -> Option<f64> {
        self.deviation.map(|d| d / (self.cycles as f64).sqrt())
    }

    /// Between two levels, `weight` of the way from this to the other.
    pub(super) fn between(&self, other: &Self, weight: f64) -> Self {
        let mix = |a: f64, b: f64| (1.0 - weight) * a + weight * b;
        Self {
            value: mix(self.value, other.value),
            deviation: self.deviation.zip(other.deviation).map(|(a, b)| mix(a, b)),
            cycles: self.cycles.min(other.cycles),
        }
    }
}

/// What cycles are on average at one position of a phase.
#[derive(Clone, Debug, PartialEq)]
pub struct Level {
    /// Where in the stroke; the unit is that of the [`Position`].
    pub position: f64,
    /// Force on the plate [N]; none where it was not measured.
    pub force: Option<Mean>,
    /// Contacts per grain as measured; for runs it follows from the contacts.
    pub coordination: Option<f64>,
    /// Contacts by force, where the run has a force distribution.
    pub contacts: Option<Contacts>,
    /// The columns that were asked for beside the force.
    pub also: Vec<Mean>,
}

/// A row of a stroke.
#[derive(Clone, Debug)]
pub(super) struct StrokeRow {
    pub step: u64,
    pub position: f64,
    /// The force, and the columns asked for beside it.
    pub values: Vec<f64>,
}

/// Share of a stroke within which two rows stand at the same position.
pub const SAME: f64 = 1e-6;
/// Share of a stroke by which a position may lie beyond its end and is still taken to be its end.
pub const BEYOND: f64 = 1e-3;

/// The two neighbours of a position among ascending positions, and the way between them. Nothing outside.
pub(super) fn place(positions: impl Fn(usize) -> f64, count: usize, at: f64) -> Option<(usize, usize, f64)> {
    let last = count.checked_sub(1)?;
    let (low, high) = (positions(0), positions(last));
    let stroke = high - low;
    if at < low - BEYOND * stroke || at > high + BEYOND * stroke {
        return None;
    }
    let (mut lower, mut upper) = (0, last);
    while upper - lower > 1 {
        let middle = lower.midpoint(upper);
        if positions(middle) <= at {
            lower = middle;
        } else {
            upper = middle;
        }
    }
    let (a, b) = (positions(lower), positions(upper));
    if at - a <= SAME * stroke {
        return Some((lower, lower, 0.0));
    }
    if b - at <= SAME * stroke {
        return Some((upper, upper, 0.0));
    }
    Some((lower, upper, (at - a) / (b - a)))
}

/// Means of strokes of one phase, rows ascending by position. Levels are the rows of the first stroke; in the others they
/// are found between the two nearest rows.
pub(super) fn average(strokes: &[Vec<StrokeRow>], forces: Option<&Forces>) -> Result<Vec<Level>, CompareError> {
    let Some(first) = strokes.first() else {
        return Ok(Vec::new());
    };
    first.iter().map(|row| level(row, strokes, forces)).collect()
}

fn level(row: &StrokeRow, strokes: &[Vec<StrokeRow>], forces: Option<&Forces>) -> Result<Level, CompareError> {
    let mut samples: Vec<Vec<f64>> = vec![Vec::new(); row.values.len()];
    let mut contacts = forces.map(|f| Contacts::none(&f.bins));
    let places: Vec<_> = (strokes.iter())
        .filter_map(|stroke| Some((stroke, place(|k| stroke[k].position, stroke.len(), row.position)?)))
        .collect();
    let share = 1.0 / places.len() as f64;
    for (stroke, (lower, upper, weight)) in &places {
        let (a, b) = (&stroke[*lower], &stroke[*upper]);
        for (sample, (x, y)) in samples.iter_mut().zip(a.values.iter().zip(&b.values)) {
            sample.push((1.0 - weight) * x + weight * y);
        }
        if let (Some(sum), Some(forces)) = (&mut contacts, forces) {
            sum.add(forces.at(a.step)?, share * (1.0 - weight));
            if *weight > 0.0 {
                sum.add(forces.at(b.step)?, share * weight);
            }
        }
    }
    let mut means = samples.iter().map(|sample| Mean::of(sample));
    Ok(Level {
        position: row.position,
        force: means.next(),
        coordination: None,
        contacts,
        also: means.collect(),
    })
}
