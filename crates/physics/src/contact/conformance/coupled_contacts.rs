//! The coupled equation in symmetric packings at rest, solved here without the engine.
//!
//! All contacts of such a packing lie at known places, so that `F_c = K_c (overlap_c + sum influence F_k)^(3/2)` is a small
//! system with constant influences. `E = 1`, grains of radius 1.

use super::cases::values;
use super::multi_contact::MultiContactCase;
use crate::contact::multi_contact::{ContactPair, LAWS};
use crate::contact::{Elastic, MaterialPair};
use crate::root::bracketed;
use glam::DVec3;

/// A contact of a grain in a symmetric packing.
#[derive(Clone, Copy)]
struct Contact {
    /// From the grain to its partner.
    direction: DVec3,
    overlap: f64,
    /// Distance of the contact point from the centre.
    lever: f64,
    /// A stiff wall, which is not displaced; else a grain that is displaced as this one.
    wall: bool,
}

impl Contact {
    /// With a stiff wall.
    fn wall(direction: DVec3, compression: f64) -> Self {
        Self {
            direction,
            overlap: compression,
            lever: 1.0 - compression,
            wall: true,
        }
    }

    /// With a grain alike; the contact point lies midway by symmetry.
    fn grain(direction: DVec3, compression: f64) -> Self {
        Self {
            overlap: 2.0 * compression,
            wall: false,
            ..Self::wall(direction, compression)
        }
    }

    /// Hertz' factor of `overlap^(3/2)`.
    fn stiffness(&self, poisson_ratio: f64) -> f64 {
        let modulus = 1.0 / (1.0 - poisson_ratio * poisson_ratio);
        let (modulus, radius) = if self.wall {
            (modulus, 1.0)
        } else {
            (0.5 * modulus, 0.5)
        };
        4.0 / 3.0 * modulus * f64::sqrt(radius)
    }

    fn sides(&self) -> f64 {
        if self.wall { 1.0 } else { 2.0 }
    }
}

const AXES: [DVec3; 6] = [DVec3::X, DVec3::NEG_X, DVec3::Y, DVec3::NEG_Y, DVec3::Z, DVec3::NEG_Z];

fn two_plates(q: f64) -> Vec<Contact> {
    [DVec3::Z, DVec3::NEG_Z].map(|n| Contact::wall(n, q)).to_vec()
}

fn cube(q: f64) -> Vec<Contact> {
    AXES.map(|n| Contact::wall(n, q)).to_vec()
}

fn simple_cubic(q: f64) -> Vec<Contact> {
    AXES.map(|n| Contact::grain(n, q)).to_vec()
}

/// Compressed along z; the neighbours along x and y just touch.
fn uniaxial(q: f64) -> Vec<Contact> {
    AXES.map(|n| Contact::grain(n, q * n.z.abs())).to_vec()
}

fn face_centred_cubic(q: f64) -> Vec<Contact> {
    let mut contacts = Vec::new();
    for a in [1.0, -1.0] {
        for b in [1.0, -1.0] {
            for n in [DVec3::new(a, b, 0.0), DVec3::new(a, 0.0, b), DVec3::new(0.0, a, b)] {
                contacts.push(Contact::grain(n.normalize(), q));
            }
        }
    }
    contacts
}

fn law(name: &str, prefactor: f64, poisson_ratio: f64) -> MultiContactCase {
    let info = LAWS.iter().find(|l| l.name == name).unwrap();
    let m = Elastic {
        young_modulus: 1.0,
        poisson_ratio,
    };
    let pair = MaterialPair { a: m, b: m };
    MultiContactCase::new(info, &values(info, &[("prefactor", prefactor)]), pair)
}

/// The models of the table, with their prefactors.
const MODELS: [(&str, f64); 5] = [
    ("independent", 1.0),
    ("point-on-sphere", 1.0),
    ("sphere-to-sphere", 1.0),
    ("half-space", 1.0),
    ("half-space", 1.125),
];

/// Displacement of one grain's surface at a contact per force at another.
fn influence(law: &MultiContactCase, from: &Contact, to: &Contact) -> f64 {
    let at = ContactPair {
        cosine: from.direction.dot(to.direction),
        source_lever: from.lever,
        target_lever: to.lever,
        least_distance_squared: 0.25,
        radius: 1.0,
    };
    law.influence(&at)
}

/// Forces in balance with the displacements, or none where they grow without end.
fn solve(law: &MultiContactCase, contacts: &[Contact]) -> Option<Vec<f64>> {
    let nu = law.pair.a.poisson_ratio;
    let mut forces = vec![0.0; contacts.len()];
    for _ in 0..100_000 {
        let displaced = |c: usize| -> f64 {
            let others = (0..contacts.len()).filter(|k| *k != c);
            others
                .map(|k| influence(law, &contacts[k], &contacts[c]) * forces[k])
                .sum()
        };
        let next: Vec<f64> = (contacts.iter().enumerate())
            .map(|(c, contact)| {
                let overlap = (contact.overlap + contact.sides() * displaced(c)).max(0.0);
                contact.stiffness(nu) * overlap * overlap.sqrt()
            })
            .collect();
        let change = next.iter().zip(&forces).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        forces = next;
        if change < 1e-15 {
            return Some(forces);
        }
        if forces[0] > 10.0 {
            break;
        }
    }
    None
}

#[track_caller]
fn assert_forces(contacts: &[Contact], which: usize, expected: [f64; 5]) {
    for ((name, prefactor), expected) in MODELS.into_iter().zip(expected) {
        let forces = solve(&law(name, prefactor, 0.5), contacts).unwrap();
        let found = forces[which];
        let shown = format!("{name} {prefactor}: {found}, expected {expected}");
        assert!((found - expected).abs() <= 1e-9 * expected.max(0.01), "{shown}");
    }
}

/// Two plates, a cube of six, simple cubic, face-centred cubic.
#[test]
fn equal_contacts() {
    let half_space = [0.023_499_437_544_38, 0.024_068_589_398_26];
    assert_forces(
        &two_plates(0.05),
        1,
        [
            0.019_876_159_8,
            0.018_011_230_711_8,
            0.023_280_679_544_55,
            half_space[0],
            half_space[1],
        ],
    );
    let half_space = [0.032_894_144_319_76, 0.036_401_587_823_18];
    assert_forces(
        &cube(0.05),
        3,
        [
            0.019_876_159_8,
            0.023_266_862_441_23,
            0.031_720_275_718_43,
            half_space[0],
            half_space[1],
        ],
    );
    let independent = 0.005_028_314_888_438;
    let half_space = [0.006_548_552_324_851, 0.006_823_671_337_114];
    assert_forces(
        &simple_cubic(0.02),
        5,
        [
            independent,
            0.005_532_852_770_098,
            0.006_507_014_915_687,
            half_space[0],
            half_space[1],
        ],
    );
    let half_space = [0.007_819_890_887_979, 0.008_492_574_020_389];
    assert_forces(
        &face_centred_cubic(0.02),
        7,
        [
            independent,
            0.006_350_214_654_899,
            0.007_724_501_634_619,
            half_space[0],
            half_space[1],
        ],
    );
}

/// Neighbours that just touch are pressed by the bulge alone.
#[test]
fn contacts_by_bulging() {
    let packing = uniaxial(0.05);
    let side = [
        0.0,
        0.000_410_389_570_2,
        0.000_474_115_882_3,
        0.000_499_139_136_5,
        0.000_629_677_356_4,
    ];
    assert_forces(&packing, 0, side);
    assert_forces(&packing, 2, side);
    let top = [
        0.019_876_159_8,
        0.018_100_361_277_1,
        0.023_399_173_074_7,
        0.023_628_861_952_7,
        0.024_258_631_567_9,
    ];
    assert_forces(&packing, 4, top);
}

/// Two grains side by side between plates, 0.01 apart: their bulges meet midway.
#[test]
fn bulges_meet() {
    let law = law("half-space", 1.0, 0.5);
    let squeezed = |q: f64| {
        let plates = two_plates(q);
        let force = solve(&law, &plates).unwrap()[0];
        let side = Contact {
            lever: 1.005,
            ..Contact::grain(DVec3::X, 0.0)
        };
        let influences = plates.iter().map(|plate| influence(&law, plate, &side));
        influences.sum::<f64>() * force
    };
    let meet = bracketed(|q| squeezed(q) - 0.005, 0.05, 0.06);
    assert!((meet - 0.056_885_741_3).abs() < 1e-10, "{meet}");
}

/// Compression at which equal contacts lose their balance: with `F = K y^3` and `overlap = y^2 - b K y^3` at the top of
/// the latter, `4/(27 b^2 K^2)`.
fn fold(law: &MultiContactCase, packing: fn(f64) -> Vec<Contact>) -> f64 {
    let excess = |q: f64| {
        let contacts = packing(q);
        let sum: f64 = contacts[1..].iter().map(|k| influence(law, k, &contacts[0])).sum();
        let slope = contacts[0].sides() * sum * contacts[0].stiffness(0.5);
        contacts[0].overlap - 4.0 / (27.0 * slope * slope)
    };
    bracketed(excess, 0.01, 0.6)
}

#[test]
fn there_is_no_balance_beyond_the_fold() {
    for (packing, one, more, digit) in [
        (face_centred_cubic as fn(f64) -> Vec<Contact>, 0.0567, 0.0458, 1e-4),
        (simple_cubic, 0.111, 0.092, 1e-3),
        (two_plates, 0.349, 0.310, 1e-3),
    ] {
        for (prefactor, expected) in [(1.0, one), (1.125, more)] {
            let law = law("half-space", prefactor, 0.5);
            let found = fold(&law, packing);
            assert!((found - expected).abs() <= 0.5 * digit, "{found}, expected {expected}");
            assert!(solve(&law, &packing(0.999 * found)).is_some());
            assert!(solve(&law, &packing(1.001 * found)).is_none());
        }
    }
}
