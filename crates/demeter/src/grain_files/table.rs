//! What a file tells of grains at one moment.

use glam::DVec3;
use std::collections::BTreeMap;

/// Name of the column of tags.
pub(super) const TAG: &str = "tag";

/// Grains of one moment, in SI units.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct GrainTable {
    /// Ids, all different, at least 1.
    pub ids: Option<Vec<u32>>,
    /// Types or materials.
    pub types: Option<Vec<TypeOfGrain>>,
    /// Names that [`TypeOfGrain::Name`] points to.
    pub type_names: Vec<String>,
    /// Centres [m].
    pub positions: Vec<DVec3>,
    /// Diameters [m].
    pub diameters: Vec<f64>,
    /// Densities [kg/m^3].
    pub densities: Option<Vec<f64>>,
    /// Velocities [m/s].
    pub velocities: Option<Vec<DVec3>>,
    /// Angular velocities [1/s].
    pub angular_velocities: Option<Vec<DVec3>>,
    /// Forces [N].
    pub forces: Option<Vec<DVec3>>,
    /// Torques [N m].
    pub torques: Option<Vec<DVec3>>,
    /// Other columns, in the unit of the file.
    pub extras: Vec<Extra>,
    /// The box of the file.
    pub cell: Option<Cell>,
    /// Steps done.
    pub step: Option<u64>,
    /// Simulated time [s].
    pub time: Option<f64>,
}

/// How a file names the material of a grain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TypeOfGrain {
    /// A type number, from 1.
    Number(u32),
    /// A name: index into [`GrainTable::type_names`].
    Name(u32),
}

/// A column that only some codes know.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Extra {
    /// Its name, without blanks.
    pub name: String,
    /// Its unit; empty when none is known.
    pub unit: String,
    /// One value per grain.
    pub values: Vec<f64>,
}

/// A box: edges `(lx, ay, az)`, `(xy, ly, bz)` and `(xz, yz, lz)` from its lower corner.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Cell {
    /// Lower corner [m].
    pub lower: DVec3,
    /// Upper corner of the box that is not tilted: `lower + (lx, ly, lz)` [m].
    pub upper: DVec3,
    /// `xy`, `xz`, `yz` [m].
    pub tilt: [f64; 3],
    /// `ay`, `az`, `bz` [m]: 0 in a box that lies as most codes want it, see [`is_general`](Self::is_general).
    pub rise: [f64; 3],
    /// Which directions are periodic.
    pub periodic: [bool; 3],
}

impl Cell {
    /// The box of three edges from a corner [m], all of whose sides are open; nothing when it is flat.
    pub(crate) fn of_edges(edges: [DVec3; 3], corner: DVec3) -> Option<Self> {
        let [a, b, c] = edges;
        let size = edges.iter().map(|edge| edge.abs().max_element()).fold(0.0, f64::max);
        let rise = [a.y, a.z, b.z];
        // digits that others rounded turn no box
        let is_straight = rise.iter().all(|value| value.abs() <= 1e-9 * size);
        let volume = a.cross(b).dot(c);
        (volume.abs() > 1e-12 * a.length() * b.length() * c.length()).then_some(Self {
            lower: corner,
            upper: corner + DVec3::new(a.x, b.y, c.z),
            tilt: [b.x, c.x, c.y],
            rise: if is_straight { [0.0; 3] } else { rise },
            periodic: [false; 3],
        })
    }

    /// The same box, scaled about the origin and shifted.
    pub(crate) fn placed(&self, scale: f64, shift: DVec3) -> Self {
        Self {
            lower: self.lower * scale + shift,
            upper: self.upper * scale + shift,
            tilt: self.tilt.map(|tilt| tilt * scale),
            rise: self.rise.map(|rise| rise * scale),
            periodic: self.periodic,
        }
    }

    /// Whether its edges are not those of a box along x, y and z.
    pub fn is_tilted(&self) -> bool {
        self.tilt != [0.0; 3] || self.is_general()
    }

    /// Whether it lies otherwise than most codes want it: the first edge along x, the second in the plane of x and y, all to the
    /// side where coordinates grow.
    pub fn is_general(&self) -> bool {
        self.rise != [0.0; 3] || self.upper.cmplt(self.lower).any()
    }

    /// The three edges [m].
    pub fn edges(&self) -> [DVec3; 3] {
        let length = self.upper - self.lower;
        let [xy, xz, yz] = self.tilt;
        let [ay, az, bz] = self.rise;
        [
            DVec3::new(length.x, ay, az),
            DVec3::new(xy, length.y, bz),
            DVec3::new(xz, yz, length.z),
        ]
    }

    /// The same box, and the same images, by edges that follow each other as thumb, forefinger and middle finger of the right hand:
    /// corner and edges [m].
    pub(super) fn right_handed(&self) -> (DVec3, [DVec3; 3]) {
        let [a, b, c] = self.edges();
        match a.cross(b).dot(c) < 0.0 {
            true => (self.lower + c, [a, b, -c]),
            false => (self.lower, [a, b, c]),
        }
    }

    /// How far the corners lie beyond `lower` and `upper` along x and y, as dumps count it [m].
    pub(super) fn overhang(&self) -> [[f64; 2]; 2] {
        let [xy, xz, yz] = self.tilt;
        let over_x = [0.0, xy, xz, xy + xz];
        let ends = |values: &[f64]| {
            [
                values.iter().copied().fold(f64::INFINITY, f64::min),
                values.iter().copied().fold(f64::NEG_INFINITY, f64::max),
            ]
        };
        [ends(&over_x), ends(&[0.0, yz])]
    }
}

impl GrainTable {
    /// Number of grains.
    pub fn len(&self) -> usize {
        self.positions.len()
    }

    /// Whether there is no grain.
    pub fn is_empty(&self) -> bool {
        self.positions.is_empty()
    }

    /// The id of a grain; its place, from 1, when the file tells none.
    pub fn id(&self, grain: usize) -> u32 {
        // A table has less than 2^32 grains.
        self.ids.as_ref().map_or(grain as u32 + 1, |ids| ids[grain])
    }

    /// Type numbers, from 1: those of the file; names get numbers above the largest of them, in order.
    pub fn type_numbers(&self) -> Vec<u32> {
        let Some(types) = &self.types else {
            return vec![1; self.len()];
        };
        let base = self.largest_number();
        let number = |kind: &TypeOfGrain| match *kind {
            TypeOfGrain::Number(number) => number,
            TypeOfGrain::Name(index) => base.saturating_add(index).saturating_add(1),
        };
        types.iter().map(number).collect()
    }

    /// The largest type number that is no name's.
    pub(super) fn largest_number(&self) -> u32 {
        let numbers = self.types.iter().flatten().filter_map(|kind| match *kind {
            TypeOfGrain::Number(number) => Some(number),
            TypeOfGrain::Name(_) => None,
        });
        numbers.max().unwrap_or(0)
    }

    /// How many types there are, those that no grain has among them: of a wall, or of grains that come later.
    pub(super) fn number_of_types(&self) -> u32 {
        (self.largest_number() + self.type_names.len() as u32).max(1)
    }

    /// Gives names to type numbers: `names[k]` to type `k + 1`. Numbers beyond stay.
    pub fn name_types(&mut self, names: &[String]) {
        let types = self
            .types
            .get_or_insert_with(|| vec![TypeOfGrain::Number(1); self.positions.len()]);
        let first = self.type_names.len() as u32;
        let mut used = false;
        for kind in types {
            if let TypeOfGrain::Number(number @ 1..) = *kind
                && (number as usize) <= names.len()
            {
                *kind = TypeOfGrain::Name(first + number - 1);
                used = true;
            }
        }
        if used {
            self.type_names.extend_from_slice(names);
        }
    }

    /// Gives names to the types that have labels; others are named by their number.
    pub(super) fn label_types(&mut self, labels: &BTreeMap<u32, String>) {
        let Some(last) = labels.keys().next_back() else { return };
        let name = |number| labels.get(&number).cloned().unwrap_or_else(|| number.to_string());
        let names: Vec<String> = (1..=*last).map(name).collect();
        self.name_types(&names);
    }

    /// Tags of the grains, when they were read as those of a run.
    pub fn tags(&self) -> Option<Vec<i32>> {
        let tags = self.extras.iter().find(|extra| extra.name == TAG)?;
        // exact: checked when they were read
        Some(tags.values.iter().map(|tag| *tag as i32).collect())
    }

    /// Mass of a grain [kg], when the file tells densities.
    pub fn mass(&self, grain: usize) -> Option<f64> {
        let radius = 0.5 * self.diameters[grain];
        let volume = 4.0 / 3.0 * std::f64::consts::PI * radius * radius * radius;
        self.densities.as_ref().map(|densities| densities[grain] * volume)
    }
}
