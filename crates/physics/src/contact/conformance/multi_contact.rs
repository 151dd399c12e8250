//! Multi-contact laws, one by one: bounds, symmetry, dimensions, what they depend on.

use super::cases::{OTHER_UNITS, PAIRS, Random, has_parameter, scaled_values, values};
use crate::contact::multi_contact::{ContactPair, LAWS, MultiContact, MultiContactLaw, MultiContactVisitor, clearance};
use crate::contact::{Elastic, LawInfo, MaterialPair};
use crate::dimension::Dimension;
use crate::parameters::Values;

/// A law with what it was built from.
#[derive(Clone, Copy)]
pub struct MultiContactCase {
    pub info: &'static LawInfo,
    pub law: MultiContactLaw,
    pub pair: MaterialPair,
}

/// What a law says of itself.
struct Traits {
    independent: bool,
    feels_levers: bool,
    mutual: bool,
}

impl MultiContactCase {
    pub fn new(info: &'static LawInfo, values: &Values, pair: MaterialPair) -> Self {
        let law = MultiContactLaw::build(info.name, values, &pair).unwrap();
        Self { info, law, pair }
    }

    pub fn influence(&self, at: &ContactPair) -> f64 {
        struct Influence<'a>(&'a ContactPair);
        impl MultiContactVisitor for Influence<'_> {
            type Output = f64;
            fn visit<L: MultiContact>(self, law: &L) -> f64 {
                law.influence(self.0)
            }
        }
        self.law.visit(Influence(at))
    }

    /// Largest bulge and largest pull for contact points like these.
    fn bounds(&self, at: &ContactPair) -> (f64, f64) {
        struct Bounds<'a>(&'a ContactPair);
        impl MultiContactVisitor for Bounds<'_> {
            type Output = (f64, f64);
            fn visit<L: MultiContact>(self, law: &L) -> (f64, f64) {
                let Self(at) = self;
                let least_lever = at.source_lever.min(at.target_lever);
                (
                    law.largest_bulge(at.radius, least_lever),
                    law.largest_pull(at.radius, at.least_distance_squared.sqrt()),
                )
            }
        }
        self.law.visit(Bounds(at))
    }

    fn traits(&self) -> Traits {
        struct Tell;
        impl MultiContactVisitor for Tell {
            type Output = Traits;
            fn visit<L: MultiContact>(self, law: &L) -> Traits {
                Traits {
                    independent: L::INDEPENDENT,
                    feels_levers: L::FEELS_LEVERS,
                    mutual: law.is_mutual(),
                }
            }
        }
        self.law.visit(Tell)
    }

    /// For messages.
    fn name(&self) -> &'static str {
        self.info.name
    }
}

/// Poisson's ratios from the end of what is possible to the other.
const POISSON_RATIOS: [f64; 7] = [-0.999, -0.6, -0.2, 0.0, 0.25, 0.4, 0.5];

fn same(material: Elastic) -> MaterialPair {
    MaterialPair {
        a: material,
        b: material,
    }
}

/// Every law for every pair of materials and for pairs of every Poisson's ratio.
fn cases() -> Vec<MultiContactCase> {
    let ratios = (0..POISSON_RATIOS.len()).map(|k| MaterialPair {
        a: Elastic {
            young_modulus: 3e4,
            poisson_ratio: POISSON_RATIOS[k],
        },
        b: Elastic {
            young_modulus: 7e6,
            poisson_ratio: POISSON_RATIOS[POISSON_RATIOS.len() - 1 - k],
        },
    });
    let swapped = PAIRS.into_iter().map(|pair| MaterialPair { a: pair.b, b: pair.a });
    let pairs: Vec<MaterialPair> = PAIRS.into_iter().chain(swapped).chain(ratios).collect();
    (LAWS.iter())
        .flat_map(|info| (pairs.iter()).map(|pair| MultiContactCase::new(info, &values(info, &[]), *pair)))
        .collect()
}

/// Two contacts of a grain with levers down to 0.7 of its radius, of partners of very unequal sizes or walls.
fn contacts(random: &mut Random) -> ContactPair {
    let radius = libm::exp(random.between(-14.0, 1.0));
    let clear = |random: &mut Random| {
        let partner = radius * libm::exp(random.between(-4.0, 4.0));
        let wall = random.share() < 0.3;
        clearance(radius, (!wall).then_some(radius * partner / (radius + partner)))
    };
    let least_distance_squared = clear(random) * clear(random);
    // as many at small angles as at large ones
    let half_sine = random.share();
    ContactPair {
        cosine: 1.0 - 2.0 * half_sine * half_sine,
        source_lever: radius * random.between(0.7, 1.1),
        target_lever: radius * random.between(0.7, 1.1),
        least_distance_squared,
        radius,
    }
}

/// Checks many contacts for every law.
fn each_contact(check: impl Fn(&MultiContactCase, ContactPair)) {
    for (seed, case) in cases().iter().enumerate() {
        let mut random = Random(seed as u64);
        for _ in 0..500 {
            let at = contacts(&mut random);
            check(case, at);
        }
    }
}

/// The size that the influences of a grain have.
fn scale(case: &MultiContactCase, radius: f64) -> f64 {
    1.0 / (case.pair.a.young_modulus * radius)
}

#[track_caller]
fn assert_close(case: &MultiContactCase, at: &ContactPair, value: f64, expected: f64, tolerance: f64) {
    assert!(
        (value - expected).abs() <= tolerance,
        "{} between {:?}: {value:e}, expected {expected:e} at {at:?}",
        case.name(),
        case.pair
    );
}

#[test]
fn no_displacement_is_beyond_the_bounds() {
    each_contact(|case, at| {
        let influence = case.influence(&at);
        let (bulge, pull) = case.bounds(&at);
        let at_most = 1.0 + 1e-12;
        assert!(
            influence <= bulge * at_most && -influence <= pull * at_most,
            "{} between {:?}: {influence:e} outside -{pull:e} .. {bulge:e} at {at:?}",
            case.name(),
            case.pair
        );
    });
}

#[test]
fn contacts_that_coincide_displace_each_other_by_a_finite_amount() {
    each_contact(|case, at| {
        for cosine in [1.0, 1.0 + 1e-15, 1.0 - 1e-15, -1.0 - 1e-15] {
            for target_lever in [at.source_lever, at.target_lever] {
                let at = ContactPair {
                    cosine,
                    target_lever,
                    ..at
                };
                let (bulge, pull) = case.bounds(&at);
                let influence = case.influence(&at);
                assert!(
                    influence.is_finite() && influence <= bulge * (1.0 + 1e-12) && -influence <= pull * (1.0 + 1e-12),
                    "{} between {:?}: {influence:e} at {at:?}",
                    case.name(),
                    case.pair
                );
            }
        }
    });
}

#[test]
fn displacements_do_not_jump_with_the_angle() {
    each_contact(|case, at| {
        let step = 1e-9;
        let near = ContactPair {
            cosine: at.cosine - step,
            ..at
        };
        let change = case.influence(&near) - case.influence(&at);
        // the slope of 1/d by the cosine is at most that of the least distance, cubed
        let closest = at.least_distance_squared.sqrt() / at.radius;
        let steepest = 20.0 / (closest * closest * closest) * scale(case, at.radius);
        assert_close(
            case,
            &at,
            change,
            0.0,
            step * steepest + 1e-9 / closest * scale(case, at.radius),
        );
    });
}

#[test]
fn displacement_is_inverse_to_the_modulus() {
    const FACTOR: f64 = 3.7;
    let softer = |m: Elastic| Elastic {
        young_modulus: m.young_modulus / FACTOR,
        ..m
    };
    each_contact(|case, at| {
        let pair = MaterialPair {
            a: softer(case.pair.a),
            b: softer(case.pair.b),
        };
        let soft = MultiContactCase::new(case.info, &values(case.info, &[]), pair);
        let expected = FACTOR * case.influence(&at);
        assert_close(case, &at, soft.influence(&at), expected, 1e-14 * expected.abs());
    });
}

#[test]
fn displacement_scales_as_the_dimensions() {
    let units = OTHER_UNITS;
    let factor = units.of(Dimension::LENGTH) / units.of(Dimension::FORCE);
    each_contact(|case, at| {
        let values = scaled_values(case.info, &values(case.info, &[]), units);
        let other = MultiContactCase::new(case.info, &values, units.pair(&case.pair));
        let at_other = ContactPair {
            cosine: at.cosine,
            source_lever: at.source_lever * units.length,
            target_lever: at.target_lever * units.length,
            least_distance_squared: at.least_distance_squared * units.length * units.length,
            radius: at.radius * units.length,
        };
        let expected = factor * case.influence(&at);
        let tolerance = 1e-12 * factor * case.bounds(&at).1;
        assert_close(case, &at, other.influence(&at_other), expected, tolerance);
        let (now, then) = (other.bounds(&at_other), case.bounds(&at));
        assert_close(case, &at, now.0, factor * then.0, 1e-12 * now.0);
        assert_close(case, &at, now.1, factor * then.1, 1e-12 * now.1);
    });
}

#[test]
fn the_material_of_the_partner_does_not_matter() {
    each_contact(|case, at| {
        let alone = MultiContactCase::new(case.info, &values(case.info, &[]), same(case.pair.a));
        assert_eq!(alone.influence(&at), case.influence(&at), "{}", case.name());
        assert_eq!(alone.bounds(&at), case.bounds(&at), "{}", case.name());
    });
}

#[test]
fn a_law_that_calls_itself_mutual_is_to_the_bit() {
    each_contact(|case, at| {
        let back = ContactPair {
            source_lever: at.target_lever,
            target_lever: at.source_lever,
            ..at
        };
        if case.traits().mutual {
            assert_eq!(case.influence(&at), case.influence(&back), "{} at {at:?}", case.name());
        }
    });
    assert!(
        cases().iter().any(|case| !case.traits().mutual),
        "the half-space is not mutual below nu = 0.5"
    );
}

/// Betti's theorem. It is exact for a sphere and for a half-space; contact points at different depths leave a share of
/// the difference.
#[test]
fn two_contacts_displace_each_other_alike() {
    each_contact(|case, at| {
        for apart in [1e-12, 1e-6, 1e-3, 0.05] {
            let at = ContactPair {
                target_lever: at.source_lever * (1.0 + apart),
                ..at
            };
            let back = ContactPair {
                source_lever: at.target_lever,
                target_lever: at.source_lever,
                ..at
            };
            let (there, back) = (case.influence(&at), case.influence(&back));
            let size = there.abs().max(scale(case, at.radius));
            let levers = if case.traits().feels_levers { apart } else { 0.0 };
            assert_close(
                case,
                &at,
                there,
                back,
                (3.0 * levers / at.least_distance_squared.sqrt() * at.radius + 1e-12) * size,
            );
        }
    });
}

#[test]
fn a_law_says_whether_it_feels_levers_and_other_contacts() {
    for case in cases() {
        let mut random = Random(7);
        let (mut felt, mut acted) = (false, false);
        for _ in 0..100 {
            let at = contacts(&mut random);
            let influence = case.influence(&at);
            acted |= influence != 0.0;
            for (from, to) in [(0.9, 1.0), (1.0, 0.9), (1.03, 1.03)] {
                let moved = ContactPair {
                    source_lever: from * at.source_lever,
                    target_lever: to * at.target_lever,
                    ..at
                };
                felt |= case.influence(&moved) != influence;
            }
        }
        assert_eq!(felt, case.traits().feels_levers, "{}", case.name());
        assert_eq!(acted, !case.traits().independent, "{}", case.name());
    }
}

#[test]
fn exactly_one_law_is_independent() {
    let independent: Vec<&str> = (LAWS.iter())
        .map(|info| MultiContactCase::new(info, &values(info, &[]), PAIRS[0]))
        .filter(|case| case.traits().independent)
        .map(|case| case.name())
        .collect();
    assert_eq!(independent, ["independent"]);
}

#[test]
fn a_prefactor_scales_displacements_and_bounds() {
    let mut seen = 0;
    each_contact(|case, at| {
        if !has_parameter(case.info, "prefactor") {
            return;
        }
        let with =
            |prefactor| MultiContactCase::new(case.info, &values(case.info, &[("prefactor", prefactor)]), case.pair);
        let one = with(1.0);
        for factor in [0.0, 1.125, 2.0] {
            let scaled = with(factor);
            let expected = factor * one.influence(&at);
            assert_close(case, &at, scaled.influence(&at), expected, 1e-14 * expected.abs());
            let (now, then) = (scaled.bounds(&at), one.bounds(&at));
            assert_close(case, &at, now.0, factor * then.0, 1e-14 * now.0);
            assert_close(case, &at, now.1, factor * then.1, 1e-14 * now.1);
        }
    });
    for info in LAWS {
        seen += usize::from(has_parameter(info, "prefactor"));
    }
    assert!(seen > 0, "no law has a prefactor");
}
