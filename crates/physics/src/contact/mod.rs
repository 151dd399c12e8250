//! Contact laws in families: normal, tangential, rolling, multi-contact.
//!
//! A law is one file and one line in its family's list. It sees a contact through its input struct and never knows
//! whether the partner is a grain, a plane or a triangle. Combinations are values ([`PairLaw`]), never types.
//!
//! **Time-centred response.** A law answers for one step of length `dt` centred on the current time `t`: the engine
//! multiplies its force by `dt`. Normal laws therefore return the *mean* over the path from `t - dt/2` to `t + dt/2`
//! along which the overlap changes at its current rate (see [`normal::NormalInput`]), and springs with history are
//! kept at half steps. At the ends of a contact, where the force has a kink, this takes the error of a collision from
//! first order in `dt`, random with the phase at which steps hit the contact, to second order and smooth.

mod lane_by_lane;
pub mod multi_contact;
pub mod normal;
pub mod rolling;
pub mod slider;
pub mod spring;
pub mod tangential;

#[cfg(test)]
mod conformance;

use crate::dimension::Dimension;
use crate::lanes::Lanes;
use crate::parameters::{Alternatives, ParameterError, ParameterInfo, Range, Values};

/// Elastic constants of one material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Elastic {
    /// Young's modulus [Pa].
    pub young_modulus: f64,
    /// Poisson's ratio.
    pub poisson_ratio: f64,
}

impl Elastic {
    /// Shear modulus `E / (2 (1 + nu))` [Pa].
    pub fn shear_modulus(&self) -> f64 {
        self.young_modulus / (2.0 * (1.0 + self.poisson_ratio))
    }
}

/// The two materials of a contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MaterialPair {
    /// Material of the grain with the lower id.
    pub a: Elastic,
    /// Material of its partner: a grain or a wall.
    pub b: Elastic,
}

impl MaterialPair {
    /// Effective Young's modulus, `1/E = (1 - nu_a^2)/E_a + (1 - nu_b^2)/E_b` [Pa].
    pub fn effective_modulus(&self) -> f64 {
        let compliance = |m: Elastic| (1.0 - m.poisson_ratio * m.poisson_ratio) / m.young_modulus;
        1.0 / (compliance(self.a) + compliance(self.b))
    }

    /// Effective shear modulus of a tangential contact, `1/G = (2 - nu_a)/G_a + (2 - nu_b)/G_b` [Pa]
    /// (Mindlin 1949).
    pub fn effective_shear_modulus(&self) -> f64 {
        let compliance = |m: Elastic| (2.0 - m.poisson_ratio) / m.shear_modulus();
        1.0 / (compliance(self.a) + compliance(self.b))
    }
}

/// Share of the effective mass that moves along the contact plane with the surfaces of solid spheres.
pub const TANGENTIAL_SHARE: f64 = 2.0 / 7.0;

/// Effective size of a contact.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PairSize<L = f64> {
    /// Effective radius, `r_i r_j / (r_i + r_j)`; the grain's radius against a wall [m].
    pub radius: L,
    /// Effective mass, `m_i m_j / (m_i + m_j)`; the grain's mass against a wall, less where the wall gives way [kg].
    pub mass: L,
    /// The mass that a stiffness goes with which is told by a contact time or a largest overlap: the same, but the grain's own against
    /// any wall [kg]. How a wall gives way changes as the normal turns, and a spring whose stiffness changed with it would gain or lose
    /// energy.
    pub spring_mass: L,
}

impl<L: Copy> PairSize<L> {
    /// The size of two grains, or of a grain and a wall that does not give way.
    #[inline(always)]
    pub const fn new(radius: L, mass: L) -> Self {
        Self {
            radius,
            mass,
            spring_mass: mass,
        }
    }
}

impl<L: Lanes> PairSize<L> {
    /// Effective mass of tangential motion at the contact point of spheres that begin to touch,
    /// `1/(1/m + r_i^2/I_i + r_j^2/I_j) = 2/7 m` [kg].
    #[inline(always)]
    pub fn tangential_mass(&self) -> L {
        self.mass * TANGENTIAL_SHARE
    }

    /// The size in one lane.
    #[inline(always)]
    pub fn lane(&self, lane: usize) -> PairSize {
        let one = |numbers: &L| numbers.as_slice()[lane];
        PairSize {
            radius: one(&self.radius),
            mass: one(&self.mass),
            spring_mass: one(&self.spring_mass),
        }
    }
}

/// What the registry tells of a law.
#[derive(Clone, Copy, Debug)]
pub struct LawInfo {
    /// Family: `"normal"`, `"tangential"`, `"rolling"`, `"multi-contact"`.
    pub family: &'static str,
    /// Name in the scenario.
    pub name: &'static str,
    /// One line.
    pub summary: &'static str,
    /// Formula, symbols, source and range of validity, as written at the top of the law's file.
    pub doc: &'static str,
    /// Its parameters.
    pub parameters: &'static [ParameterInfo],
    /// Which of them tell the same thing.
    pub alternatives: &'static [Alternatives],
    /// Number of values that the law remembers per contact.
    pub history: usize,
    /// Dimensions of these values.
    pub history_dimensions: &'static [Dimension],
}

/// Why a law could not be built.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum LawError {
    /// There is no law of this name in the family.
    #[error("unknown {family} law `{name}`; known are {known}")]
    Unknown {
        /// The family.
        family: &'static str,
        /// The name as given.
        name: String,
        /// Comma-separated known names.
        known: String,
    },
    /// Its parameters were refused.
    #[error("law `{law}`: {}", .errors.iter().map(ToString::to_string).collect::<Vec<_>>().join("; "))]
    Parameters {
        /// The law.
        law: &'static str,
        /// Everything that is wrong.
        errors: Vec<ParameterError>,
    },
    /// A material cannot be.
    #[error("material `{name}`: `{what}` is {value}; it must be finite and {allowed}")]
    Material {
        /// The material.
        name: String,
        /// Which of its constants.
        what: &'static str,
        /// Its value.
        value: f64,
        /// What it may be.
        allowed: Range,
    },
}

impl LawError {
    /// Name of the law at fault, or of the material.
    pub fn law(&self) -> &str {
        match self {
            Self::Material { name, .. } => name,
            Self::Unknown { name, .. } => name,
            Self::Parameters { law, .. } => law,
        }
    }
}

/// Declares a family: the enum of its laws, the list of what is known of them, and the reader by name.
macro_rules! law_family {
    (family $family:literal, trait $law_trait:ident, $(#[$doc:meta])* enum $law_enum:ident, visitor $visitor:ident,
     laws { $($module:ident::$law:ident,)* }) => {
        $(pub mod $module;)*
        $(pub use $module::$law;)*

        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub enum $law_enum {
            $(#[doc = concat!("See [`", stringify!($law), "`].")] $law($law),)*
        }

        /// Work to be done with the concrete law inside the enum, so that dispatch happens once for many contacts.
        pub trait $visitor {
            /// What the work gives.
            type Output;
            /// Does the work.
            fn visit<L: $law_trait>(self, law: &L) -> Self::Output;
        }

        $(const _: () = assert!(
            $law::HISTORY.len() <= $crate::contact::lane_by_lane::MOST_HISTORY,
            "a law remembers more values than `MOST_HISTORY` in contact/lane_by_lane.rs"
        );)*

        /// All laws of the family.
        pub const LAWS: &[$crate::contact::LawInfo] = &[
            $($crate::contact::LawInfo {
                family: $family,
                name: $law::NAME,
                summary: $law::SUMMARY,
                doc: $law::DOC,
                parameters: $law::PARAMETERS,
                alternatives: $law::ALTERNATIVES,
                history: $law::HISTORY.len(),
                history_dimensions: $law::HISTORY,
            },)*
        ];

        impl $law_enum {
            /// Builds the law of this name for a pair of materials from its parameters in SI.
            pub fn build(
                name: &str,
                values: &$crate::parameters::Values,
                pair: &$crate::contact::MaterialPair,
            ) -> Result<Self, $crate::contact::LawError> {
                $(if name == $law::NAME {
                    return $law::new(values, pair)
                        .map(Self::$law)
                        .map_err(|errors| $crate::contact::LawError::Parameters { law: $law::NAME, errors });
                })*
                Err($crate::contact::LawError::Unknown {
                    family: $family,
                    name: name.to_string(),
                    known: LAWS.iter().map(|l| format!("`{}`", l.name)).collect::<Vec<_>>().join(", "),
                })
            }

            /// Hands the concrete law to a visitor.
            #[inline(always)]
            pub fn visit<V: $visitor>(&self, visitor: V) -> V::Output {
                match self {
                    $(Self::$law(law) => visitor.visit(law),)*
                }
            }

            /// What the registry knows of this law.
            pub fn info(&self) -> &'static $crate::contact::LawInfo {
                let name = match self {
                    $(Self::$law(_) => $law::NAME,)*
                };
                LAWS.iter().find(|l| l.name == name).unwrap_or(&LAWS[0])
            }
        }
    };
}
pub(crate) use law_family;

/// The laws of every family.
pub fn laws() -> impl Iterator<Item = &'static LawInfo> {
    (normal::LAWS.iter())
        .chain(tangential::LAWS)
        .chain(rolling::LAWS)
        .chain(multi_contact::LAWS)
}

/// A law by name with its parameters in SI, not yet bound to materials.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct LawChoice {
    /// Name of the law.
    pub law: String,
    /// Its parameters.
    pub parameters: Values,
}

/// The laws of one pair of materials.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PairLaw {
    /// Normal law.
    pub normal: normal::NormalLaw,
    /// Tangential law; frictionless when absent.
    pub tangential: Option<tangential::TangentialLaw>,
    /// Rolling law; free rolling when absent.
    pub rolling: Option<rolling::RollingLaw>,
    /// How the surfaces of the first and of the second body are displaced at this contact.
    pub multi_contact: [multi_contact::MultiContactLaw; 2],
}
