//! Rows of values, each of which is one grain: what all formats share.

use super::error::{FileProblem, Located};
use super::numbers::{check_ids, density, diameter, not_allowed, number, shown, tag, whole};
use super::read::ReadOptions;
use super::table::{Cell, Extra, GrainTable, TAG, TypeOfGrain};
use glam::DVec3;
use std::collections::BTreeMap;

/// Most names of materials that a file may use.
const MOST_NAMES: usize = 65_536;
/// Columns among the `extras` whose values are whole numbers.
pub(super) const WHOLE: [&str; 4] = ["mol", "ix", "iy", "iz"];
/// Most columns of a file.
pub(super) const MOST_COLUMNS: usize = 1000;

/// What a column tells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Quantity {
    Id,
    Position(usize),
    /// Share of the box, from 0 to 1.
    ScaledPosition(usize),
    /// Diameter, or radius when doubled.
    Size {
        is_radius: bool,
    },
    Type,
    /// Label of the type whose number another column tells.
    Label,
    Density,
    Mass,
    Velocity(usize),
    AngularVelocity(usize),
    Force(usize),
    Torque(usize),
    /// Index into [`GrainTable::extras`].
    Extra(usize),
    /// The same, of a column of tags that grains of a run take over.
    Tag(usize),
    /// The same, of times that a grain went through a periodic side.
    Image(usize),
    /// Not looked at.
    Skipped,
}

impl Quantity {
    /// A column that is no quantity of a packing, which gets a place among the `extras`.
    pub fn extra(name: &str, unit: &str, options: &ReadOptions, extras: &mut Vec<(String, String)>) -> Self {
        extras.push((name.to_owned(), unit.to_owned()));
        let index = extras.len() - 1;
        if name == TAG && !options.extra_columns {
            Self::Tag(index)
        } else {
            Self::Extra(index)
        }
    }

    /// Whether both tell the same.
    pub fn is_same(self, other: Self) -> bool {
        let axis = |quantity| match quantity {
            Self::Position(axis) | Self::ScaledPosition(axis) => Some(axis),
            _ => None,
        };
        (self == other && self != Self::Skipped)
            || matches!(
                (self, other),
                (Self::Size { .. }, Self::Size { .. }) | (Self::Tag(_), Self::Tag(_))
            )
            || (axis(self).is_some() && axis(self) == axis(other))
    }
}

/// A column of a file.
#[derive(Clone, Debug)]
pub(super) struct Column {
    pub name: String,
    pub quantity: Quantity,
    /// The unit of the file in SI.
    pub factor: f64,
}

impl Column {
    pub fn new(name: &str, quantity: Quantity, factor: f64) -> Self {
        Self {
            name: name.to_owned(),
            quantity,
            factor,
        }
    }
}

/// Collects the rows of one moment.
pub(super) struct Rows<'a> {
    columns: &'a [Column],
    table: GrainTable,
    masses: Vec<f64>,
    lines: Vec<u32>,
    names: BTreeMap<String, u32>,
    /// Label of the row.
    label: Option<String>,
    labels: BTreeMap<u32, String>,
}

impl<'a> Rows<'a> {
    /// Nothing yet; `extras` are names and units of the columns of [`Quantity::Extra`].
    pub fn new(columns: &'a [Column], extras: &[(String, String)]) -> Self {
        let has = |of: fn(&Quantity) -> bool| columns.iter().any(|c| of(&c.quantity));
        let extra = |(name, unit): &(String, String)| Extra {
            name: name.clone(),
            unit: unit.clone(),
            values: Vec::new(),
        };
        Self {
            columns,
            table: GrainTable {
                ids: has(|q| matches!(q, Quantity::Id)).then(Vec::new),
                types: has(|q| matches!(q, Quantity::Type)).then(Vec::new),
                densities: has(|q| matches!(q, Quantity::Density)).then(Vec::new),
                velocities: has(|q| matches!(q, Quantity::Velocity(_))).then(Vec::new),
                angular_velocities: has(|q| matches!(q, Quantity::AngularVelocity(_))).then(Vec::new),
                forces: has(|q| matches!(q, Quantity::Force(_))).then(Vec::new),
                torques: has(|q| matches!(q, Quantity::Torque(_))).then(Vec::new),
                extras: extras.iter().map(extra).collect(),
                ..GrainTable::default()
            },
            masses: Vec::new(),
            lines: Vec::new(),
            names: BTreeMap::new(),
            label: None,
            labels: BTreeMap::new(),
        }
    }

    /// Number of rows so far.
    pub fn len(&self) -> usize {
        self.table.positions.len()
    }

    /// The type of the last row.
    pub fn last_type(&self) -> Option<TypeOfGrain> {
        self.table.types.as_ref()?.last().copied()
    }

    /// Reads a row; an error leaves the rows unusable.
    pub fn read<'t>(&mut self, line: usize, words: impl Iterator<Item = &'t str> + Clone) -> Result<(), Located> {
        let table = &mut self.table;
        table.positions.push(DVec3::ZERO);
        for values in [
            &mut table.velocities,
            &mut table.angular_velocities,
            &mut table.forces,
            &mut table.torques,
        ] {
            push(values, DVec3::ZERO);
        }
        let columns = self.columns;
        let mut left = words.clone();
        for column in columns {
            let Some(text) = left.next() else {
                return Err(self.wrong_count(line, words));
            };
            self.read_value(column, text)
                .map_err(|problem| problem.at(line, Some(&column.name)))?;
        }
        if left.next().is_some() {
            return Err(self.wrong_count(line, words));
        }
        if let (Some(label), Some(TypeOfGrain::Number(number))) = (self.label.take(), self.last_type()) {
            add_label(&mut self.labels, number, &label).map_err(|problem| problem.at(line, None))?;
        }
        self.lines.push(u32::try_from(line).unwrap_or(u32::MAX));
        Ok(())
    }

    fn wrong_count<'t>(&self, line: usize, words: impl Iterator<Item = &'t str>) -> Located {
        let (found, expected) = (words.take(MOST_COLUMNS).count(), self.columns.len().to_string());
        FileProblem::ValueCount { found, expected }.at(line, None)
    }

    fn read_value(&mut self, column: &Column, text: &str) -> Result<(), FileProblem> {
        let table = &mut self.table;
        let scaled = || number(text).map(|value| value * column.factor);
        let set = |values: Option<&mut Vec<DVec3>>, axis: usize, value: f64| {
            if let Some(last) = values.and_then(|v| v.last_mut()) {
                last[axis] = value;
            }
        };
        match column.quantity {
            Quantity::Id => push(&mut table.ids, whole(text)?),
            Quantity::Position(axis) | Quantity::ScaledPosition(axis) => {
                set(Some(&mut table.positions), axis, scaled()?);
            }
            Quantity::Size { is_radius } => {
                let value = scaled()? * if is_radius { 2.0 } else { 1.0 };
                table.diameters.push(diameter(value, text)?);
            }
            Quantity::Density => push(&mut table.densities, density(scaled()?, text)?),
            Quantity::Mass => match scaled()? {
                mass if mass > 0.0 => self.masses.push(mass),
                _ => return Err(not_allowed(text, "a mass must be positive")),
            },
            Quantity::Velocity(axis) => set(table.velocities.as_mut(), axis, scaled()?),
            Quantity::AngularVelocity(axis) => set(table.angular_velocities.as_mut(), axis, scaled()?),
            Quantity::Force(axis) => set(table.forces.as_mut(), axis, scaled()?),
            Quantity::Torque(axis) => set(table.torques.as_mut(), axis, scaled()?),
            Quantity::Extra(index) => {
                let value: f64 = text
                    .parse()
                    .map_err(|_| FileProblem::NotANumber { text: shown(text) })?;
                table.extras[index].values.push(value);
            }
            Quantity::Tag(index) => table.extras[index].values.push(f64::from(tag(text)?)),
            Quantity::Image(index) => {
                let flag = (text.parse::<i32>()).map_err(|_| not_allowed(text, "image flags are whole numbers"))?;
                table.extras[index].values.push(f64::from(flag));
            }
            Quantity::Skipped => {}
            Quantity::Label => self.label = Some(text.to_owned()),
            Quantity::Type => {
                let kind = self.read_type(text)?;
                push(&mut self.table.types, kind);
            }
        }
        Ok(())
    }

    fn read_type(&mut self, text: &str) -> Result<TypeOfGrain, FileProblem> {
        if text.starts_with(|c: char| c.is_ascii_digit() || c == '-' || c == '+') {
            return whole(text).map(TypeOfGrain::Number);
        }
        if let Some(index) = self.names.get(text) {
            return Ok(TypeOfGrain::Name(*index));
        }
        if text.is_empty() || self.table.type_names.len() >= MOST_NAMES {
            return Err(not_allowed(
                text,
                "allowed are type numbers or at most 65536 names of materials",
            ));
        }
        let index = self.table.type_names.len() as u32;
        self.table.type_names.push(text.to_owned());
        self.names.insert(text.to_owned(), index);
        Ok(TypeOfGrain::Name(index))
    }

    /// The table. `size` is the diameter of grains of a file that tells none [m]; `cell` its box.
    pub fn finish(self, size: Option<f64>, cell: Option<Cell>) -> Result<GrainTable, Located> {
        match self.table.positions.is_empty() {
            true => Err(FileProblem::NoGrains.into()),
            false => self.finish_moment(size, cell),
        }
    }

    /// The same, of one moment of several, which may have no grains.
    pub fn finish_moment(mut self, size: Option<f64>, cell: Option<Cell>) -> Result<GrainTable, Located> {
        if let Some(ids) = &self.table.ids {
            check_ids(ids, |grain| self.lines[grain] as usize)?;
        }
        if self.table.diameters.is_empty() && !self.table.positions.is_empty() {
            let size = size.ok_or(FileProblem::NoSizes)?;
            self.table.diameters = vec![diameter(size, &format!("{size:?} m"))?; self.table.positions.len()];
        }
        self.table.label_types(&self.labels);
        self.unscale(cell)?;
        self.weigh()?;
        self.table.cell = cell;
        Ok(self.table)
    }

    /// Makes places of shares of the box.
    fn unscale(&mut self, cell: Option<Cell>) -> Result<(), Located> {
        let shares = [0, 1, 2].map(|axis| {
            let is_scaled = |c: &&Column| c.quantity == Quantity::ScaledPosition(axis);
            self.columns.iter().any(|c| is_scaled(&c))
        });
        if shares == [false; 3] {
            return Ok(());
        }
        let cell = cell.ok_or(FileProblem::Expected {
            found: "nothing".to_owned(),
            expected: "a box, since places are told as shares of it,",
        })?;
        let (edges, length) = (cell.edges(), cell.upper - cell.lower);
        for position in &mut self.table.positions {
            *position = match shares {
                [true, true, true] => {
                    cell.lower + position.x * edges[0] + position.y * edges[1] + position.z * edges[2]
                }
                _ if cell.is_tilted() => {
                    return Err(FileProblem::NotRead {
                        what: "a tilted box with only some places as shares of it".to_owned(),
                        remedy: "dump `xs ys zs` or `x y z`",
                    }
                    .into());
                }
                _ => DVec3::from_array([0, 1, 2].map(|k| match shares[k] {
                    true => cell.lower[k] + position[k] * length[k],
                    false => position[k],
                })),
            };
        }
        Ok(())
    }

    /// Makes densities of masses; where the file tells both, they must agree.
    fn weigh(&mut self) -> Result<(), Located> {
        if self.masses.is_empty() {
            return Ok(());
        }
        if let Some(densities) = &self.table.densities {
            let told = self.masses.iter().zip(densities).zip(&self.table.diameters);
            for (k, ((mass, density), diameter)) in told.enumerate() {
                let of_mass = density_of(*mass, 0.5 * diameter);
                if (of_mass / density - 1.0).abs() > ROUNDED {
                    let problem = FileProblem::MassAgainstDensity {
                        mass: *mass,
                        of_mass,
                        density: *density,
                    };
                    return Err(problem.at(self.lines[k] as usize, Some("mass")));
                }
            }
            return Ok(());
        }
        let mut densities = Vec::with_capacity(self.masses.len());
        for (k, mass) in self.masses.iter().enumerate() {
            let value = density_of(*mass, 0.5 * self.table.diameters[k]);
            let text = format!("density {value:?} kg/m^3, of mass and size");
            let line = self.lines[k] as usize;
            densities.push(density(value, &text).map_err(|problem| problem.at(line, Some("mass")))?);
        }
        self.table.densities = Some(densities);
        Ok(())
    }
}

/// Notes the label of a type, of which there is one.
pub(super) fn add_label(labels: &mut BTreeMap<u32, String>, number: u32, label: &str) -> Result<(), FileProblem> {
    if number as usize > MOST_NAMES {
        return Err(not_allowed(&number.to_string(), "labels are read of types 1 to 65536"));
    }
    let known = labels.entry(number).or_insert_with(|| label.to_owned());
    match known == label {
        true => Ok(()),
        false => Err(FileProblem::TwoLabels {
            number,
            labels: [shown(known), shown(label)],
        }),
    }
}

/// How far a mass may be from that of its size and density: files hold few digits.
const ROUNDED: f64 = 0.02;

/// Density of a sphere [kg/m^3], to 15 digits: what a division of rounded numbers gives back.
pub fn density_of(mass: f64, radius: f64) -> f64 {
    let value = mass / (4.0 / 3.0 * std::f64::consts::PI * radius * radius * radius);
    format!("{value:.14e}").parse().unwrap_or(value)
}

fn push<T>(values: &mut Option<Vec<T>>, value: T) {
    if let Some(values) = values {
        values.push(value);
    }
}
