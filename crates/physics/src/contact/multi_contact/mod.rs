//! Multi-contact laws: how the force at one contact of a grain moves the grain's surface at another.
//!
//! `displacement at c = influence(k -> c) F_k`, positive where the surface moves outwards, so that the overlap at `c`
//! grows. `F_k` is the elastic force at `k` with its sign: a pull displaces the other way. The normals point into the
//! grain, the contact points lie at `-lever * normal` from its centre, so the geometry of two contacts is the cosine of
//! the angle between their normals and the two levers.
//!
//! The model is told by the law of the contact that is displaced. Walls are not displaced.

use super::{Elastic, MaterialPair, law_family};
use crate::dimension::Dimension;
use crate::lanes::Lanes;
use crate::parameters::{Alternatives, ParameterError, ParameterInfo, Values};

/// Two contacts of one grain; of several grains with [`Lanes`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactPair<L = f64> {
    /// Cosine of the angle between the inward normals.
    pub cosine: L,
    /// Distance of the contact point whose force displaces from the grain's centre [m].
    pub source_lever: L,
    /// Distance of the contact point that is displaced from the grain's centre [m].
    pub target_lever: L,
    /// Square of the distance of the contact points below which the influence no longer grows: the product of the
    /// [`clearance`] of both contacts [m^2].
    pub least_distance_squared: L,
    /// Radius of the grain [m].
    pub radius: L,
}

impl<L: Copy> ContactPair<L> {
    /// The same with what displaces and what is displaced exchanged.
    #[inline(always)]
    pub fn reversed(&self) -> Self {
        Self {
            source_lever: self.target_lever,
            target_lever: self.source_lever,
            ..*self
        }
    }
}

/// What a contact keeps clear around it [m]: see [`ContactPair::least_distance_squared`]. `effective_radius` is that of the
/// contact of two grains; a wall tells `None`.
///
/// A point force displaces its own place without bound, so two contacts may not come too close. Two partners that touch
/// the grain and each other have contact points `2 sqrt(a b)` apart, where `a` and `b` are the effective radii of their
/// contacts with the grain; the least distance is half of that. Nothing real comes as close, unless the partners pass
/// through each other. A wall counts as a quarter of the grain's radius, which two walls reach when they meet at less than
/// 14 degrees from flat.
#[inline(always)]
pub fn clearance(radius: f64, effective_radius: Option<f64>) -> f64 {
    effective_radius.unwrap_or(0.25 * radius)
}

/// A multi-contact law.
pub trait MultiContact: Copy + PartialEq + Send + Sync + 'static {
    /// Name in the scenario.
    const NAME: &'static str;
    /// One line.
    const SUMMARY: &'static str;
    /// The documentation at the top of its file.
    const DOC: &'static str;
    /// Its parameters.
    const PARAMETERS: &'static [ParameterInfo];
    /// Which of them tell the same thing.
    const ALTERNATIVES: &'static [Alternatives] = &[];
    /// What it remembers per contact: nothing.
    const HISTORY: &'static [Dimension] = &[];
    /// Whether contacts do not feel each other.
    const INDEPENDENT: bool = false;
    /// Whether the levers matter. If not, the influences of a grain's contacts do not depend on the displacements.
    const FEELS_LEVERS: bool;

    /// Binds the law to a pair of materials: `pair.a` is that of the displaced grain.
    fn new(values: &Values, pair: &MaterialPair) -> Result<Self, Vec<ParameterError>>;

    /// Whether any two contacts displace each other alike, to the bit.
    #[inline(always)]
    fn is_mutual(&self) -> bool {
        !Self::FEELS_LEVERS
    }

    /// Outward displacement of the grain's surface at a contact per force at another of its contacts [m/N].
    fn influence<L: Lanes>(&self, contacts: &ContactPair<L>) -> L;

    /// Largest outward displacement anywhere on a grain per compressive force on it [m/N]: no contact point lies closer to
    /// the centre than `least_lever`.
    fn largest_bulge(&self, radius: f64, least_lever: f64) -> f64;

    /// Largest outward displacement anywhere on a grain per pull on it [m/N], with contact points no closer than
    /// `least_distance`.
    fn largest_pull(&self, radius: f64, least_distance: f64) -> f64;
}

law_family! {
    family "multi-contact", trait MultiContact,
    /// A multi-contact law bound to a pair of materials.
    enum MultiContactLaw, visitor MultiContactVisitor,
    laws {
        independent::Independent,
        half_space::HalfSpace,
        sphere_to_sphere::SphereToSphere,
        point_on_sphere::PointOnSphere,
    }
}

/// The material of the displaced grain, as the laws use it.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Material {
    /// `(1 + nu)/(2 pi E)` [1/Pa].
    compliance: f64,
    poisson_ratio: f64,
}

impl Material {
    fn new(pair: &MaterialPair) -> Self {
        let Elastic {
            young_modulus,
            poisson_ratio,
        } = pair.a;
        Self {
            compliance: (1.0 + poisson_ratio) / (2.0 * std::f64::consts::PI * young_modulus),
            poisson_ratio,
        }
    }

    /// `(1 + nu)/(2 pi E)` [1/Pa] and `nu`.
    #[inline(always)]
    fn terms(&self) -> (f64, f64) {
        (self.compliance, self.poisson_ratio)
    }
}
