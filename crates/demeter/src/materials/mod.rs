//! Materials and the contact laws of every pair of them.

mod law_list;

pub use law_list::{called_elsewhere, law_example, law_key, law_to_json, written_value};

use demeter_physics::contact::multi_contact::{Independent, MultiContactLaw};
use demeter_physics::contact::normal::NormalLaw;
use demeter_physics::contact::rolling::RollingLaw;
use demeter_physics::contact::tangential::TangentialLaw;
use demeter_physics::contact::{Elastic, LawChoice, LawError, MaterialPair, PairLaw};
use demeter_physics::parameters::Range;
use serde::{Deserialize, Serialize};

/// Poisson's ratio of a stable isotropic solid: `-1 < nu <= 1/2`.
pub(crate) const POISSON: Range = Range::new(-1.0, false, 0.5, true);

/// A material.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Material {
    /// Name in the scenario.
    pub name: String,
    /// Young's modulus [Pa].
    pub young_modulus: f64,
    /// Poisson's ratio.
    pub poisson_ratio: f64,
    /// Mass density [kg/m^3].
    pub density: f64,
}

impl Material {
    /// Refuses constants that no body has.
    fn check(&self) -> Result<(), LawError> {
        let constants = [
            ("young_modulus", self.young_modulus, Range::POSITIVE),
            ("poisson_ratio", self.poisson_ratio, POISSON),
            ("density", self.density, Range::POSITIVE),
        ];
        match constants
            .into_iter()
            .find(|(_, value, allowed)| !allowed.contains(*value))
        {
            None => Ok(()),
            Some((what, value, allowed)) => Err(LawError::Material {
                name: self.name.clone(),
                what,
                value,
                allowed,
            }),
        }
    }

    /// The elastic constants.
    pub fn elastic(&self) -> Elastic {
        Elastic {
            young_modulus: self.young_modulus,
            poisson_ratio: self.poisson_ratio,
        }
    }
}

/// The laws chosen for a pair of materials, by name.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PairChoice {
    /// Normal law.
    pub normal: LawChoice,
    /// Tangential law; frictionless when absent.
    pub tangential: Option<LawChoice>,
    /// Rolling law; free rolling when absent.
    pub rolling: Option<LawChoice>,
    /// Multi-contact law; independent contacts when absent.
    pub multi_contact: Option<LawChoice>,
}

impl PairChoice {
    /// Binds the laws to two materials.
    pub fn bind(&self, a: &Material, b: &Material) -> Result<PairLaw, LawError> {
        let pair = MaterialPair {
            a: a.elastic(),
            b: b.elastic(),
        };
        Ok(PairLaw {
            normal: NormalLaw::build(&self.normal.law, &self.normal.parameters, &pair)?,
            tangential: (self.tangential.as_ref())
                .map(|c| TangentialLaw::build(&c.law, &c.parameters, &pair))
                .transpose()?,
            rolling: self
                .rolling
                .as_ref()
                .map(|c| RollingLaw::build(&c.law, &c.parameters, &pair))
                .transpose()?,
            multi_contact: [self.displaced(a)?, self.displaced(b)?],
        })
    }

    /// The law by which the surface of a grain is displaced: bound to its material alone, so that equal laws are equal.
    fn displaced(&self, grain: &Material) -> Result<MultiContactLaw, LawError> {
        let (a, b) = (grain.elastic(), grain.elastic());
        self.multi_contact
            .as_ref()
            .map_or(Ok(MultiContactLaw::Independent(Independent)), |c| {
                MultiContactLaw::build(&c.law, &c.parameters, &MaterialPair { a, b })
            })
    }
}

/// All materials with the laws of every pair.
#[derive(Clone, Debug, PartialEq)]
pub struct Materials {
    list: Vec<Material>,
    laws: Vec<PairLaw>,
}

impl Materials {
    /// Binds the laws of every pair; `choice(a, b)` is asked once for every pair with `a <= b`.
    pub fn new(list: Vec<Material>, choice: impl Fn(usize, usize) -> PairChoice) -> Result<Self, LawError> {
        list.iter().try_for_each(Material::check)?;
        let n = list.len();
        let mut laws = Vec::with_capacity(n * n);
        for a in 0..n {
            for b in 0..n {
                laws.push(choice(a.min(b), a.max(b)).bind(&list[a], &list[b])?);
            }
        }
        Ok(Self { list, laws })
    }

    /// The same for grains of many sizes ([`NormalLaw::for_many_sizes`]).
    #[must_use]
    pub fn for_many_sizes(mut self) -> Self {
        for law in &mut self.laws {
            law.normal = law.normal.for_many_sizes();
        }
        self
    }

    /// Whether the contacts of some grain feel each other.
    pub fn are_coupled(&self) -> bool {
        let independent = MultiContactLaw::Independent(Independent);
        self.laws
            .iter()
            .flat_map(|law| law.multi_contact)
            .any(|law| law != independent)
    }

    /// Laws of all pairs.
    pub fn laws(&self) -> &[PairLaw] {
        &self.laws
    }

    /// The materials in the order of their indices.
    pub fn list(&self) -> &[Material] {
        &self.list
    }

    /// Index of the pair `(a, b)`, for [`Materials::law`].
    #[inline(always)]
    pub fn pair(&self, a: u16, b: u16) -> u32 {
        u32::from(a) * self.list.len() as u32 + u32::from(b)
    }

    /// Laws of a pair.
    #[inline(always)]
    pub fn law(&self, pair: u32) -> &PairLaw {
        &self.laws[pair as usize]
    }
}
