//! Columns of the series that are told by name and value.

/// A value in a column.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    /// A number of things.
    Count(u64),
    /// A quantity in SI.
    Number(f64),
}

/// A column of a measure; its title begins with the name of the measure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ToldColumn {
    /// Name of the quantity.
    pub name: &'static str,
    /// Unit; empty for numbers of things.
    pub unit: &'static str,
    /// What it is.
    pub meaning: &'static str,
}

impl ToldColumn {
    pub(crate) const fn new(name: &'static str, unit: &'static str, meaning: &'static str) -> Self {
        Self { name, unit, meaning }
    }

    /// Title in a header: `left glass mass [kg]`.
    pub fn title(&self, measure: &str) -> String {
        match self.unit {
            "" => format!("{measure} {}", self.name),
            unit => format!("{measure} {} [{unit}]", self.name),
        }
    }
}

/// Columns of every feed; their names begin with `feed NAME`.
pub const FEED_COLUMNS: &[ToldColumn] = &[
    ToldColumn::new("grains", "", "grains that came since the start of the run"),
    ToldColumn::new("mass", "kg", "their mass"),
    ToldColumn::new("behind", "kg", "mass that is due by the rate and waits for room"),
];

/// Columns of a domain that removes what leaves it; their names begin with `domain`.
pub const DOMAIN_COLUMNS: &[ToldColumn] = &[
    ToldColumn::new(
        "lost grains",
        "",
        "grains that left the domain and were removed since the start of the run",
    ),
    ToldColumn::new("lost mass", "kg", "their mass"),
];

/// Columns of every removal; their names begin with `removal NAME`. Behind them are those of every material.
pub const REMOVAL_COLUMNS: &[ToldColumn] = &[
    ToldColumn::new("grains", "", "grains that were removed since the start of the run"),
    ToldColumn::new("mass", "kg", "their mass"),
    ToldColumn::new(
        "mean residence",
        "s",
        "mean time that they were in the run; NaN without any",
    ),
];
