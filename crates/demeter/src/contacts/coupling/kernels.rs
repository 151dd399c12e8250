//! The multi-contact laws in use, each once.

use crate::materials::Materials;
use demeter_physics::contact::multi_contact::{ContactPair, MultiContact, MultiContactLaw, MultiContactVisitor};

/// The laws, and which of them displaces either body of every material pair.
#[derive(Clone, Debug, Default)]
pub(crate) struct Kernels {
    laws: Vec<MultiContactLaw>,
    of_pair: Vec<[u32; 2]>,
}

impl Kernels {
    pub(crate) fn new(materials: &Materials) -> Self {
        let mut kernels = Self::default();
        let count = materials.list().len() as u16;
        for pair in (0..count).flat_map(|a| (0..count).map(move |b| (a, b))) {
            let laws = materials.law(materials.pair(pair.0, pair.1)).multi_contact;
            let places = laws.map(|law| place_of(&mut kernels.laws, law));
            kernels.of_pair.push(places);
        }
        kernels
    }

    /// Displacement at a contact per force at another [m/N].
    pub(crate) fn influence(&self, kernel: u32, contacts: &ContactPair) -> f64 {
        struct Influence<'a>(&'a ContactPair);
        impl MultiContactVisitor for Influence<'_> {
            type Output = f64;
            fn visit<L: MultiContact>(self, law: &L) -> f64 {
                law.influence(self.0)
            }
        }
        self.law(kernel).visit(Influence(contacts))
    }

    /// The laws that displace the surfaces of both bodies at a contact of a material pair.
    #[inline(always)]
    pub(crate) fn of(&self, pair: u32) -> [u32; 2] {
        self.of_pair[pair as usize]
    }

    #[inline(always)]
    pub(crate) fn law(&self, kernel: u32) -> &MultiContactLaw {
        &self.laws[kernel as usize]
    }

    /// Whether any two contacts displace each other alike, to the bit.
    pub(crate) fn is_mutual(&self, kernel: u32) -> bool {
        struct Asks;
        impl MultiContactVisitor for Asks {
            type Output = bool;
            fn visit<L: MultiContact>(self, law: &L) -> bool {
                law.is_mutual()
            }
        }
        self.law(kernel).visit(Asks)
    }

    /// Whether influences depend on the levers.
    pub(crate) fn feel_levers(&self) -> bool {
        struct Asks;
        impl MultiContactVisitor for Asks {
            type Output = bool;
            fn visit<L: MultiContact>(self, _law: &L) -> bool {
                L::FEELS_LEVERS
            }
        }
        self.laws.iter().any(|law| law.visit(Asks))
    }
}

/// Place of a law in the list, at whose end it is put when it is new.
fn place_of(laws: &mut Vec<MultiContactLaw>, law: MultiContactLaw) -> u32 {
    let place = laws.iter().position(|known| *known == law).unwrap_or_else(|| {
        laws.push(law);
        laws.len() - 1
    });
    place as u32
}
