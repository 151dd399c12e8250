//! Materials, sizes and parameter values that the laws are tested with.

use super::tested;
use crate::contact::normal::{Normal, NormalInput, NormalLaw, NormalResponse, NormalVisitor};
use crate::contact::{Elastic, LawInfo, MaterialPair, PairSize};
use crate::dimension::Dimension;
use crate::parameters::{ParameterKind, Presence, Value, Values};

const fn material(young_modulus: f64, poisson_ratio: f64) -> Elastic {
    Elastic {
        young_modulus,
        poisson_ratio,
    }
}

const STEEL: Elastic = material(210e9, 0.3);
const GLASS: Elastic = material(63e9, 0.22);
const HYDROGEL: Elastic = material(23.3e3, 0.5);
const CORK: Elastic = material(20e6, 0.0);

/// Equal, alike and very unequal partners.
pub const PAIRS: [MaterialPair; 4] = [
    MaterialPair { a: GLASS, b: GLASS },
    MaterialPair { a: GLASS, b: STEEL },
    MaterialPair {
        a: HYDROGEL,
        b: HYDROGEL,
    },
    MaterialPair { a: CORK, b: STEEL },
];

/// From a fine powder to a boulder; the masses are those of equal spheres and of very unequal ones.
pub const SIZES: [PairSize; 3] = [
    PairSize::new(2.5e-6, 8e-14),
    PairSize::new(5e-3, 2e-3),
    PairSize::new(0.7, 3400.0),
];

/// Typical values of the parameters that an example of the law gives, with those of `replaced` that the law has set to other values.
pub fn values(info: &LawInfo, replaced: &[(&str, f64)]) -> Values {
    let mut values: Values = info
        .parameters
        .iter()
        .filter(|p| p.in_example())
        .map(|p| (p.name.to_string(), p.typical.into()))
        .collect();
    for (name, value) in replaced {
        if has_parameter(info, name) {
            values.insert((*name).to_string(), (*value).into());
        }
    }
    values
}

/// Whether the law takes a parameter of this name.
pub fn has_parameter(info: &LawInfo, name: &str) -> bool {
    info.parameters.iter().any(|p| p.name == name)
}

/// The values in units of kilogram, metre and second that are smaller by the factors of `units`.
pub fn scaled_values(info: &LawInfo, values: &Values, units: Units) -> Values {
    let scale = |name: &str| {
        info.parameters
            .iter()
            .find(|p| p.name == name)
            .map_or(1.0, |p| units.of(p.dimension))
    };
    let scaled = |(name, value): (&String, &Value)| match value {
        Value::Number(x) => (name.clone(), Value::Number(x * scale(name))),
        Value::Text(_) | Value::Table(_) => (name.clone(), value.clone()),
    };
    values.iter().map(scaled).collect()
}

/// Factors by which the numbers for a mass, a length and a time grow in other units.
#[derive(Clone, Copy)]
pub struct Units {
    pub mass: f64,
    pub length: f64,
    pub time: f64,
}

/// Numbers without small common powers, so that no wrong exponent can hide.
pub const OTHER_UNITS: Units = Units {
    mass: 3.7,
    length: 0.21,
    time: 5.3,
};

impl Units {
    pub fn of(self, dimension: Dimension) -> f64 {
        dimension.scale(self.mass, self.length, self.time)
    }

    pub fn size(self, size: PairSize) -> PairSize {
        PairSize::new(size.radius * self.length, size.mass * self.mass)
    }

    pub fn pair(self, pair: &MaterialPair) -> MaterialPair {
        let scaled = |m: Elastic| material(m.young_modulus * self.of(Dimension::PRESSURE), m.poisson_ratio);
        MaterialPair {
            a: scaled(pair.a),
            b: scaled(pair.b),
        }
    }
}

/// SplitMix64 (Steele, Lea and Flood 2014): enough randomness for a test, the same on every machine.
pub struct Random(pub u64);

impl Random {
    /// Uniform in `[0, 1)`.
    pub fn share(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 * (0.5 / (1u64 << 52) as f64)
    }

    /// Uniform between two numbers.
    pub fn between(&mut self, lower: f64, upper: f64) -> f64 {
        lower + (upper - lower) * self.share()
    }
}

/// A normal law with what it was built from.
#[derive(Clone, Copy)]
pub struct NormalCase {
    pub info: &'static LawInfo,
    pub law: NormalLaw,
    pub pair: MaterialPair,
    pub size: PairSize,
}

/// More history values than any law has.
pub const MOST_HISTORY: usize = 16;

impl NormalCase {
    /// Response of a contact that has just come to be.
    pub fn respond(&self, overlap: f64, half_window: f64) -> NormalResponse {
        let input = NormalInput {
            size: self.size,
            overlap,
            rate: half_window,
            half_window,
        };
        self.respond_with(&input, &mut [0.0; MOST_HISTORY])
    }

    /// Response of a contact with a history.
    pub fn respond_with(&self, input: &NormalInput, history: &mut [f64]) -> NormalResponse {
        struct Respond<'h>(NormalInput, &'h mut [f64]);
        impl NormalVisitor for Respond<'_> {
            type Output = NormalResponse;
            fn visit<L: Normal>(self, law: &L) -> NormalResponse {
                law.respond(&self.0, &mut self.1[..law.history()])
            }
        }
        self.law.visit(Respond(*input, history))
    }

    /// Whether the law remembers nothing and acts only where the bodies overlap.
    pub fn is_plain(&self) -> bool {
        struct Plain(PairSize);
        impl NormalVisitor for Plain {
            type Output = bool;
            fn visit<L: Normal>(self, law: &L) -> bool {
                law.history() == 0 && law.largest_reach(self.0) == 0.0
            }
        }
        self.law.visit(Plain(self.size))
    }

    pub fn energy(&self, overlap: f64) -> f64 {
        self.energy_with(overlap, &[0.0; MOST_HISTORY])
    }

    pub fn energy_with(&self, overlap: f64, history: &[f64]) -> f64 {
        struct Energy<'h>(PairSize, f64, &'h [f64]);
        impl NormalVisitor for Energy<'_> {
            type Output = f64;
            fn visit<L: Normal>(self, law: &L) -> f64 {
                law.energy(self.0, self.1, &self.2[..law.history()])
            }
        }
        self.law.visit(Energy(self.size, overlap, history))
    }

    pub fn stiffness(&self, overlap: f64) -> f64 {
        self.stiffness_with(overlap, &[0.0; MOST_HISTORY])
    }

    pub fn stiffness_with(&self, overlap: f64, history: &[f64]) -> f64 {
        struct Stiffness<'h>(PairSize, f64, &'h [f64]);
        impl NormalVisitor for Stiffness<'_> {
            type Output = f64;
            fn visit<L: Normal>(self, law: &L) -> f64 {
                law.stiffness(self.0, self.1, &self.2[..law.history()])
            }
        }
        self.law.visit(Stiffness(self.size, overlap, history))
    }

    pub fn reach_with(&self, history: &[f64]) -> f64 {
        struct Reach<'h>(PairSize, &'h [f64]);
        impl NormalVisitor for Reach<'_> {
            type Output = f64;
            fn visit<L: Normal>(self, law: &L) -> f64 {
                law.reach(self.0, &self.1[..law.history()])
            }
        }
        self.law.visit(Reach(self.size, history))
    }

    pub fn largest_reach(&self) -> f64 {
        struct Reach(PairSize);
        impl NormalVisitor for Reach {
            type Output = f64;
            fn visit<L: Normal>(self, law: &L) -> f64 {
                law.largest_reach(self.0)
            }
        }
        self.law.visit(Reach(self.size))
    }

    pub fn collision_time(&self, overlap: f64) -> f64 {
        struct CollisionTime(PairSize, f64);
        impl NormalVisitor for CollisionTime {
            type Output = f64;
            fn visit<L: Normal>(self, law: &L) -> f64 {
                law.collision_time(self.0, self.1)
            }
        }
        self.law.visit(CollisionTime(self.size, overlap))
    }

    /// For messages.
    pub fn name(&self) -> String {
        format!("{} at radius {} m", self.info.name, self.size.radius)
    }
}

/// Every normal law for every pair of materials and every size.
pub fn normal_cases(replaced: &[(&str, f64)]) -> Vec<NormalCase> {
    let mut cases = Vec::new();
    for info in tested(crate::contact::normal::LAWS) {
        for pair in PAIRS {
            let law = NormalLaw::build(info.name, &values(info, replaced), &pair).unwrap();
            cases.extend(SIZES.map(|size| NormalCase { info, law, pair, size }));
        }
    }
    cases
}

/// Those of the cases whose law remembers nothing and acts only where the bodies overlap.
pub fn plain_cases(replaced: &[(&str, f64)]) -> Vec<NormalCase> {
    let mut cases = normal_cases(replaced);
    cases.retain(NormalCase::is_plain);
    cases
}

/// Ways to ask for a law: its example; with each other word of each choice; with each optional parameter beside the
/// example; with each optional parameter in place of the alternatives that the example gives; with two optional
/// parameters. Those that the law refuses, for a pair of the first materials, are left out.
pub fn variants(info: &LawInfo) -> Vec<Values> {
    let example = values(info, &[]);
    let mut required = example.clone();
    for p in info.parameters.iter().filter(|p| p.presence == Presence::Usual) {
        required.remove(p.name);
    }
    let mut asked = vec![example.clone()];
    for p in info.parameters {
        let given: Vec<Value> = match (p.kind, p.presence) {
            (ParameterKind::Choice(words), _) => words[1..].iter().map(|word| (*word).into()).collect(),
            (_, Presence::Optional | Presence::Default(_)) => vec![p.typical.into(), (2.0 * p.typical).into()],
            _ => vec![],
        };
        for value in given {
            for base in [&example, &required] {
                let mut with = base.clone();
                with.insert(p.name.to_string(), value.clone());
                asked.push(with);
            }
        }
    }
    asked.extend(pairs_of_optional(info));
    asked.extend(calibrated(info, 0.3));
    asked.retain(|values| NormalLaw::build(info.name, values, &PAIRS[0]).is_ok());
    asked.dedup();
    asked
}

/// The example with each two of the optional parameters, and with these and each other word of each choice.
fn pairs_of_optional(info: &LawInfo) -> Vec<Values> {
    let optional: Vec<_> = (info.parameters.iter())
        .filter(|p| p.presence == Presence::Optional && p.kind == ParameterKind::Number)
        .collect();
    let mut asked = Vec::new();
    for (k, one) in optional.iter().enumerate() {
        for other in &optional[k + 1..] {
            let both = values(info, &[(one.name, one.typical), (other.name, other.typical)]);
            if NormalLaw::build(info.name, &both, &PAIRS[0]).is_err() {
                continue;
            }
            for p in info.parameters {
                if let ParameterKind::Choice(words) = p.kind {
                    asked.extend(words[1..].iter().map(|word| {
                        let mut with = both.clone();
                        with.insert(p.name.to_string(), (*word).into());
                        with
                    }));
                }
            }
            asked.push(both);
        }
    }
    asked
}

/// Ways to ask for a restitution at the typical impact speed: beside the example of the law, and in place of each of the
/// alternatives that it gives. Those that the law refuses are left out: there is none where the restitution holds at
/// every speed.
pub fn calibrated(info: &LawInfo, restitution: f64) -> Vec<Values> {
    let typical = |p: &crate::parameters::ParameterInfo| (p.name == "impact_speed").then_some(p.typical);
    let Some(speed) = info.parameters.iter().find_map(typical) else {
        return Vec::new();
    };
    let example = values(info, &[("restitution", restitution), ("impact_speed", speed)]);
    let mut asked = vec![example.clone()];
    for p in info.parameters.iter().filter(|p| p.presence == Presence::Usual) {
        let mut without = example.clone();
        if !["restitution", "impact_speed"].contains(&p.name) && without.remove(p.name).is_some() {
            asked.push(without);
        }
    }
    asked.retain(|values| NormalLaw::build(info.name, values, &PAIRS[0]).is_ok());
    asked
}

/// Every variant of every law that remembers something or acts across a gap, for every size (the example for two pairs of
/// materials), and the values that it is built from.
pub fn memory_cases() -> Vec<(NormalCase, Values)> {
    let mut cases = Vec::new();
    for info in tested(crate::contact::normal::LAWS) {
        let example = values(info, &[]);
        for values in variants(info) {
            for pair in [PAIRS[1], PAIRS[3]]
                .into_iter()
                .take(if values == example { 2 } else { 1 })
            {
                let law = NormalLaw::build(info.name, &values, &pair).unwrap();
                for size in SIZES {
                    let case = NormalCase { info, law, pair, size };
                    if !case.is_plain() {
                        cases.push((case, values.clone()));
                    }
                }
            }
        }
    }
    cases
}
