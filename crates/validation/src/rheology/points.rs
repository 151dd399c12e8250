//! Friction and solid fraction of every stage that shears.

use super::RheologyError;
use demeter::scenario::Scenario;
use std::path::Path;

/// Share of the rows of a stage that are left out at its beginning: the flow is not steady there.
const TRANSIENT: f64 = 0.4;

/// Parts of the rest, whose means tell how sure the mean is.
const BLOCKS: usize = 6;

/// Rows that a stage must have.
const FEWEST_ROWS: usize = 10 * BLOCKS;

/// What the inertial number is made of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Flow {
    /// Mean diameter of the grains [m].
    pub diameter: f64,
    /// Density of their material [kg/m^3].
    pub density: f64,
}

/// A steady flow.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    /// Name of the stage.
    pub stage: String,
    /// Rate of shear [1/s].
    pub rate: f64,
    /// Mean normal stress along the gradient [Pa].
    pub pressure: f64,
    /// Inertial number.
    pub inertial_number: f64,
    /// Shear stress over normal stress, and its standard error.
    pub friction: (f64, f64),
    /// Solid fraction, and its standard error.
    pub solid_fraction: (f64, f64),
    /// Mean number of contacts per grain.
    pub coordination: f64,
    /// Largest residual of the energy books.
    pub residual: f64,
}

/// Mean of values, and the standard error that the means of blocks of them tell.
fn mean(values: &[f64]) -> (f64, f64) {
    let of = |values: &[f64]| values.iter().sum::<f64>() / values.len().max(1) as f64;
    let all = of(values);
    let blocks: Vec<f64> = values.chunks(values.len().div_ceil(BLOCKS).max(1)).map(of).collect();
    let count = blocks.len() as f64;
    let variance = blocks.iter().map(|block| (block - all) * (block - all)).sum::<f64>() / (count - 1.0).max(1.0);
    (all, (variance / count).sqrt())
}

/// Columns that are read.
const COLUMNS: [&str; 7] = [
    "box shear rate [1/s]",
    "box stress yy [Pa]",
    "box stress xy [Pa]",
    "box solid fraction",
    "coordination",
    "energy residual",
    "stage",
];

/// Reads the points of a finished run.
pub fn read_points(scenario: &Scenario, flow: Flow, folder: &Path) -> Result<Vec<Point>, RheologyError> {
    let wrong = |problem: String| RheologyError::Reading {
        folder: folder.to_owned(),
        problem,
    };
    let path = folder.join("series.csv");
    let mut reader = csv::Reader::from_path(&path).map_err(|e| wrong(e.to_string()))?;
    let titles = reader.headers().map_err(|e| wrong(e.to_string()))?.clone();
    let mut places = [0; COLUMNS.len()];
    for (place, title) in places.iter_mut().zip(COLUMNS) {
        let found = titles.iter().position(|t| t == title);
        *place = found.ok_or_else(|| wrong(format!("its series has no column `{title}`")))?;
    }
    let mut rows: Vec<(String, [f64; 6])> = Vec::new();
    for record in reader.records() {
        let record = record.map_err(|e| wrong(e.to_string()))?;
        let cell = |k: usize| record.get(places[k]).unwrap_or_default();
        let mut values = [0.0; 6];
        for (k, value) in values.iter_mut().enumerate() {
            let text = cell(k);
            *value = text
                .parse()
                .map_err(|_| wrong(format!("`{}` is `{text}`, no number", COLUMNS[k])))?;
        }
        rows.push((cell(6).to_string(), values));
    }
    let mut points = Vec::new();
    for stage in scenario
        .stages
        .iter()
        .filter(|s| s.deformation.is_some_and(|d| d.shear.is_some()))
    {
        let of_stage: Vec<&[f64; 6]> = rows
            .iter()
            .filter(|(name, _)| *name == stage.name)
            .map(|(_, v)| v)
            .collect();
        let steady = &of_stage[(of_stage.len() as f64 * TRANSIENT) as usize..];
        if steady.len() < FEWEST_ROWS {
            return Err(wrong(format!(
                "stage `{}` has {} rows after its beginning, {FEWEST_ROWS} are needed",
                stage.name,
                steady.len()
            )));
        }
        let column = |k: usize| -> Vec<f64> { steady.iter().map(|row| row[k]).collect() };
        let (rate, _) = mean(&column(0));
        let (pressure, _) = mean(&column(1));
        let (_, shear_error) = mean(&column(2));
        let (shear, _) = mean(&column(2));
        points.push(Point {
            stage: stage.name.clone(),
            rate,
            pressure,
            inertial_number: rate * flow.diameter * (flow.density / pressure).sqrt(),
            // compression is positive, so a flow along the gradient is resisted by a negative shear stress
            friction: (-shear / pressure, shear_error / pressure),
            solid_fraction: mean(&column(3)),
            coordination: mean(&column(4)).0,
            residual: column(5).iter().map(|r| r.abs()).fold(0.0, f64::max),
        });
    }
    Ok(points)
}

#[cfg(test)]
mod tests {
    use super::mean;

    #[test]
    fn the_error_of_a_mean_is_that_of_its_blocks() {
        let values: Vec<f64> = (0..60).map(|k| f64::from(k / 10 % 2)).collect();
        let (all, error) = mean(&values);
        assert!((all - 0.5).abs() < 1e-12);
        // six blocks of 0, 1, 0, 1, 0, 1
        assert!((error - (0.3f64 / 6.0).sqrt()).abs() < 1e-12, "{error}");
    }
}
