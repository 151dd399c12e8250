//! Units of files that tell none themselves: the unit styles of LAMMPS that are made of metres, kilograms and seconds
//! (<https://docs.lammps.org/units.html>), or any three.

use serde::{Deserialize, Serialize};
use std::fmt;
use std::str::FromStr;

/// Units of length, mass and time, in SI; all others follow from them.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct FileUnits {
    /// Length [m].
    pub length: f64,
    /// Mass [kg].
    pub mass: f64,
    /// Time [s].
    pub time: f64,
}

impl FileUnits {
    /// Metres, kilograms, seconds.
    pub const SI: Self = Self {
        length: 1.0,
        mass: 1.0,
        time: 1.0,
    };

    /// The unit styles of LAMMPS that can be told in SI.
    pub const STYLES: [(&'static str, Self); 4] = [
        ("si", Self::SI),
        (
            "cgs",
            Self {
                length: 1e-2,
                mass: 1e-3,
                time: 1.0,
            },
        ),
        (
            "micro",
            Self {
                length: 1e-6,
                mass: 1e-15,
                time: 1e-6,
            },
        ),
        (
            "nano",
            Self {
                length: 1e-9,
                mass: 1e-21,
                time: 1e-9,
            },
        ),
    ];

    /// The units of a style of LAMMPS.
    pub fn style(name: &str) -> Option<Self> {
        Self::STYLES
            .iter()
            .find(|(known, _)| *known == name)
            .map(|(_, units)| *units)
    }

    /// Whether both are the same units, however they were told.
    pub(super) fn are(&self, others: &Self) -> bool {
        let pairs = [
            (self.length, others.length),
            (self.mass, others.mass),
            (self.time, others.time),
        ];
        pairs.iter().all(|(one, other)| (one / other - 1.0).abs() < 1e-9)
    }

    pub(super) fn velocity(&self) -> f64 {
        self.length / self.time
    }

    pub(super) fn rate(&self) -> f64 {
        1.0 / self.time
    }

    pub(super) fn density(&self) -> f64 {
        self.mass / (self.length * self.length * self.length)
    }

    pub(super) fn force(&self) -> f64 {
        self.mass * self.length / (self.time * self.time)
    }

    pub(super) fn torque(&self) -> f64 {
        self.force() * self.length
    }
}

/// Units that are not understood.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "`{text}` is no set of units; allowed are `si`, `cgs`, `micro`, `nano` (the unit styles of LAMMPS), or the units of length, mass \
     and time, as `mm,g,ms` or `0.5 mm,2 g,1 ms`"
)]
pub struct UnknownUnits {
    text: String,
}

const LENGTHS: [(&str, f64); 7] = [
    ("m", 1.0),
    ("cm", 1e-2),
    ("mm", 1e-3),
    ("um", 1e-6),
    ("\u{b5}m", 1e-6),
    ("\u{3bc}m", 1e-6),
    ("nm", 1e-9),
];
const MASSES: [(&str, f64); 6] = [
    ("kg", 1.0),
    ("g", 1e-3),
    ("mg", 1e-6),
    ("ug", 1e-9),
    ("t", 1e3),
    ("pg", 1e-15),
];
const TIMES: [(&str, f64); 5] = [("s", 1.0), ("ms", 1e-3), ("us", 1e-6), ("\u{b5}s", 1e-6), ("ns", 1e-9)];

impl FromStr for FileUnits {
    type Err = UnknownUnits;

    fn from_str(text: &str) -> Result<Self, UnknownUnits> {
        if let Some(units) = Self::style(text.trim()) {
            return Ok(units);
        }
        let unknown = || UnknownUnits {
            text: super::numbers::shown(text),
        };
        let parts: Vec<&str> = text.split(',').collect();
        let [length, mass, time] = parts[..] else {
            return Err(unknown());
        };
        let read = |text: &str, units: &[(&str, f64)]| -> Option<f64> {
            let text = text.trim();
            let unit = text
                .rfind(|c: char| !c.is_alphabetic())
                .map_or(text, |at| &text[at + 1..]);
            let number = text.strip_suffix(unit)?.trim();
            let factor = units.iter().find(|(name, _)| *name == unit)?.1;
            let number: f64 = if number.is_empty() { 1.0 } else { number.parse().ok()? };
            (number * factor > 1e-30 && number * factor < 1e30).then_some(number * factor)
        };
        Ok(Self {
            length: read(length, &LENGTHS).ok_or_else(unknown)?,
            mass: read(mass, &MASSES).ok_or_else(unknown)?,
            time: read(time, &TIMES).ok_or_else(unknown)?,
        })
    }
}

impl fmt::Display for FileUnits {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match Self::STYLES.iter().find(|(_, units)| units == self) {
            Some((name, _)) => f.write_str(name),
            None => write!(f, "{:?} m, {:?} kg, {:?} s", self.length, self.mass, self.time),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn styles_and_triples_are_read() {
        assert_eq!("si".parse(), Ok(FileUnits::SI));
        let cgs: FileUnits = "cgs".parse().unwrap();
        assert!((cgs.density() - 1e3).abs() < 1e-9 && (cgs.force() - 1e-5).abs() < 1e-20);
        assert!(("micro".parse::<FileUnits>().unwrap().density() - 1e3).abs() < 1e-9);
        assert!(("nano".parse::<FileUnits>().unwrap().force() - 1e-12).abs() < 1e-24);
        let own: FileUnits = "0.5 mm, 2g,1e-1 ms".parse().unwrap();
        assert_eq!((own.length, own.mass, own.time), (0.5e-3, 2e-3, 0.1 * 1e-3));
        assert_eq!("mm,g,ms".parse::<FileUnits>().unwrap().velocity(), 1.0);
        for wrong in [
            "",
            "lj",
            "mm,g",
            "mm,g,ms,A",
            "g,mm,ms",
            "-1 mm,g,s",
            "0 mm,g,s",
            "nan m,g,s",
            "1e400 m,g,s",
            ",,",
        ] {
            let found = wrong.parse::<FileUnits>().unwrap_err().to_string();
            assert!(found.contains("allowed are `si`"), "{found}");
        }
    }
}
