//! Physical dimensions as integer exponents of kilogram, metre and second.

use std::fmt;

/// Exponents of mass, length and time. Angles and shares are dimensionless.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Dimension {
    /// Exponent of the kilogram.
    pub mass: i8,
    /// Exponent of the metre.
    pub length: i8,
    /// Exponent of the second.
    pub time: i8,
}

impl Dimension {
    /// A dimension from its three exponents.
    pub const fn new(mass: i8, length: i8, time: i8) -> Self {
        Self { mass, length, time }
    }

    /// Factor by which a value of this dimension changes when kilogram, metre and second are rescaled.
    pub fn scale(self, mass: f64, length: f64, time: f64) -> f64 {
        let power = |base: f64, exponent: i8| (0..exponent.unsigned_abs()).fold(1.0, |p, _| p * base);
        let signed = |base: f64, e: i8| if e < 0 { 1.0 / power(base, e) } else { power(base, e) };
        signed(mass, self.mass) * signed(length, self.length) * signed(time, self.time)
    }
}

macro_rules! dimensions {
    ($($(#[$doc:meta])* $name:ident = ($m:literal, $l:literal, $t:literal), $words:literal, $unit:literal;)*) => {
        impl Dimension {
            $($(#[$doc])* pub const $name: Self = Self::new($m, $l, $t);)*

            /// Name of the quantity, for messages: `"length"`; the SI unit when it has no name of its own.
            pub fn name(self) -> String {
                $(if self == Self::$name { return $words.to_string(); })*
                format!("quantity in {self}")
            }

            /// SI unit as the scenario writes it: `"Pa"`.
            pub fn unit(self) -> String {
                $(if self == Self::$name { return $unit.to_string(); })*
                let mut parts = Vec::new();
                for (symbol, exponent) in [("kg", self.mass), ("m", self.length), ("s", self.time)] {
                    match exponent {
                        0 => {}
                        1 => parts.push(symbol.to_string()),
                        e => parts.push(format!("{symbol}^{e}")),
                    }
                }
                parts.join(" ")
            }
        }
    };
}

dimensions! {
    /// Pure number, share or ratio.
    NONE = (0, 0, 0), "pure number", "";
    /// Length [m].
    LENGTH = (0, 1, 0), "length", "m";
    /// Inverse length [1/m].
    PER_LENGTH = (0, -1, 0), "inverse length", "1/m";
    /// Area [m^2].
    AREA = (0, 2, 0), "area", "m^2";
    /// Volume [m^3].
    VOLUME = (0, 3, 0), "volume", "m^3";
    /// Time [s].
    TIME = (0, 0, 1), "time", "s";
    /// Frequency or angular velocity [1/s].
    FREQUENCY = (0, 0, -1), "frequency or angular velocity", "1/s";
    /// Mass [kg].
    MASS = (1, 0, 0), "mass", "kg";
    /// Velocity [m/s].
    VELOCITY = (0, 1, -1), "velocity", "m/s";
    /// Acceleration [m/s^2].
    ACCELERATION = (0, 1, -2), "acceleration", "m/s^2";
    /// Force [N].
    FORCE = (1, 1, -2), "force", "N";
    /// Energy or torque [J].
    ENERGY = (1, 2, -2), "energy or torque", "J";
    /// Pressure or elastic modulus [Pa].
    PRESSURE = (1, -1, -2), "pressure or modulus", "Pa";
    /// Inverse of a pressure [1/Pa].
    INVERSE_PRESSURE = (-1, 1, 2), "inverse pressure", "1/Pa";
    /// Mass density [kg/m^3].
    DENSITY = (1, -3, 0), "density", "kg/m^3";
    /// Stiffness [N/m].
    STIFFNESS = (1, 0, -2), "stiffness or surface energy", "N/m";
    /// Compliance [m/N].
    COMPLIANCE = (-1, 0, 2), "compliance", "m/N";
    /// Compliance of rolling, angle per torque [1/(N m)].
    ROLLING_COMPLIANCE = (-1, -2, 2), "rolling compliance", "1/J";
    /// Damping coefficient of a linear dashpot [N s/m].
    DAMPING = (1, 0, -1), "damping coefficient", "N s/m";
}

impl Dimension {
    /// Surface energy or work of adhesion [J/m^2], which is [N/m].
    pub const SURFACE_ENERGY: Self = Self::STIFFNESS;
}

impl fmt::Display for Dimension {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let unit = self.unit();
        f.write_str(if unit.is_empty() { "1" } else { &unit })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_newton_scales_as_its_exponents() {
        // 1 N = 1 kg m/s^2; in gram, centimetre and minute it counts 1e3 * 1e2 * 3600
        let scale = Dimension::FORCE.scale(1e3, 1e2, 1.0 / 60.0);
        assert!((scale - 3.6e8).abs() < 1e-6 * scale);
        assert_eq!(Dimension::FORCE.unit(), "N");
        assert_eq!(Dimension::new(2, 1, 0).to_string(), "kg^2 m");
    }
}
