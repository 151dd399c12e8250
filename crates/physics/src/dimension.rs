//! Physical dimensions as exponents of kilogram, metre and second, whole ones or halves.

use std::fmt;

/// Exponents of mass, length and time. Angles and shares are dimensionless.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Dimension {
    /// Twice the exponents of kilogram, metre and second.
    halves: [i8; 3],
}

impl Dimension {
    /// A dimension from its three exponents.
    pub const fn new(mass: i8, length: i8, time: i8) -> Self {
        Self::of_halves([2 * mass, 2 * length, 2 * time])
    }

    /// A dimension from twice the exponents of kilogram, metre and second.
    pub const fn of_halves(halves: [i8; 3]) -> Self {
        Self { halves }
    }

    /// Twice the exponents of kilogram, metre and second.
    pub const fn halves(self) -> [i8; 3] {
        self.halves
    }

    /// Factor by which a value of this dimension changes when kilogram, metre and second are rescaled.
    pub fn scale(self, mass: f64, length: f64, time: f64) -> f64 {
        let whole = |base: f64, exponent: u8| (0..exponent).fold(1.0, |p, _| p * base);
        let power = |base: f64, halves: u8| whole(base, halves / 2) * whole(base.sqrt(), halves % 2);
        let signed = |base: f64, halves: i8| {
            let power = power(base, halves.unsigned_abs());
            if halves < 0 { 1.0 / power } else { power }
        };
        let [of_mass, of_length, of_time] = self.halves;
        signed(mass, of_mass) * signed(length, of_length) * signed(time, of_time)
    }
}

macro_rules! dimensions {
    ($($(#[$doc:meta])* $name:ident = $value:expr, $words:literal, $unit:literal;)*) => {
        impl Dimension {
            $($(#[$doc])* pub const $name: Self = $value;)*

            /// Name of the quantity, for messages: `"length"`; the SI unit when it has no name of its own.
            pub fn name(self) -> String {
                $(if self == Self::$name { return $words.to_string(); })*
                format!("quantity in {self}")
            }

            /// SI unit as the scenario writes it: `"Pa"`.
            pub fn unit(self) -> String {
                $(if self == Self::$name { return $unit.to_string(); })*
                let mut parts = Vec::new();
                for (symbol, halves) in ["kg", "m", "s"].into_iter().zip(self.halves) {
                    match halves {
                        0 => {}
                        2 => parts.push(symbol.to_string()),
                        _ => parts.push(format!("{symbol}^{}", f64::from(halves) / 2.0)),
                    }
                }
                parts.join(" ")
            }
        }
    };
}

dimensions! {
    /// Pure number, share or ratio.
    NONE = Self::new(0, 0, 0), "pure number", "";
    /// Length [m].
    LENGTH = Self::new(0, 1, 0), "length", "m";
    /// Inverse length [1/m].
    PER_LENGTH = Self::new(0, -1, 0), "inverse length", "1/m";
    /// Area [m^2].
    AREA = Self::new(0, 2, 0), "area", "m^2";
    /// Volume [m^3].
    VOLUME = Self::new(0, 3, 0), "volume", "m^3";
    /// Time [s].
    TIME = Self::new(0, 0, 1), "time", "s";
    /// Frequency or angular velocity [1/s].
    FREQUENCY = Self::new(0, 0, -1), "frequency or angular velocity", "1/s";
    /// Mass [kg].
    MASS = Self::new(1, 0, 0), "mass", "kg";
    /// Velocity [m/s].
    VELOCITY = Self::new(0, 1, -1), "velocity", "m/s";
    /// Acceleration [m/s^2].
    ACCELERATION = Self::new(0, 1, -2), "acceleration", "m/s^2";
    /// Force [N].
    FORCE = Self::new(1, 1, -2), "force", "N";
    /// Energy or torque [J].
    ENERGY = Self::new(1, 2, -2), "energy or torque", "J";
    /// Pressure or elastic modulus [Pa].
    PRESSURE = Self::new(1, -1, -2), "pressure or modulus", "Pa";
    /// Inverse of a pressure [1/Pa].
    INVERSE_PRESSURE = Self::new(-1, 1, 2), "inverse pressure", "1/Pa";
    /// Mass density [kg/m^3].
    DENSITY = Self::new(1, -3, 0), "density", "kg/m^3";
    /// Stiffness [N/m].
    STIFFNESS = Self::new(1, 0, -2), "stiffness or surface energy", "N/m";
    /// Stiffness of a Hertzian contact [N/m^1.5].
    HERTZ_STIFFNESS = Self::of_halves([2, -1, -4]), "stiffness of a Hertzian contact", "N/m^1.5";
    /// Compliance [m/N].
    COMPLIANCE = Self::new(-1, 0, 2), "compliance", "m/N";
    /// Compliance of rolling, angle per torque [1/(N m)].
    ROLLING_COMPLIANCE = Self::new(-1, -2, 2), "rolling compliance", "1/J";
    /// Damping coefficient of a linear dashpot [N s/m].
    DAMPING = Self::new(1, 0, -1), "damping coefficient", "N s/m";
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

    #[test]
    fn half_exponents_scale_by_roots() {
        // 1 N/m^1.5 = 1 kg m^-0.5 s^-2
        let scale = Dimension::HERTZ_STIFFNESS.scale(1e3, 1e4, 10.0);
        assert!((scale - 0.1).abs() < 1e-15);
        assert_eq!(Dimension::HERTZ_STIFFNESS.unit(), "N/m^1.5");
        assert_eq!(Dimension::of_halves([0, 1, -3]).to_string(), "m^0.5 s^-1.5");
    }
}
