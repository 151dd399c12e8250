//! Fabric: which way contacts point, how many grains they hold, and how unequally they carry.
//!
//! With the unit normals `n_c` of the contacts and their normal forces `f_c`
//!
//! ```text
//! F_ab = 1/C sum n_a n_b                      H_ab = sum f n_a n_b / sum f
//! ```
//!
//! (K. Kanatani, Int. J. Eng. Sci. 22 (1984) 149; H weighs by force). The traces are 1. The anisotropy of a fabric is
//! `sqrt(3/2 D:D)` of its deviator `D = F - 1/3`: 0 when no direction is preferred, 1 when all contacts point the same way.
//!
//! **Rattlers** are grains that less than four contacts hold (two in a plane would be three, but one normal force alone never
//! holds a grain). They are taken out one after the other with their contacts, as what they held may rattle then, too.
//! The coordination without rattlers is the mean over the others.
//!
//! The **strong network** (F. Radjai et al., Phys. Rev. Lett. 77 (1996) 274) is made of the contacts that carry more than the
//! mean normal force.

use super::{Selection, ToldColumn, Value, holds};
use crate::contacts::ContactChunk;
use crate::particles::{Origins, Zone};
use crate::simulation::Simulation;
use glam::DVec3;

/// Contacts that hold a grain in space.
const HOLD: u32 = 4;

/// Columns of a fabric.
pub const FABRIC_COLUMNS: &[ToldColumn] = &[
    ToldColumn::new("counted contacts", "", "contacts of which a grain counts"),
    ToldColumn::new(
        "contacts per grain",
        "",
        "mean number of contacts of the grains, those with walls counted",
    ),
    ToldColumn::new("rattlers", "", "share of the grains that less than four contacts hold"),
    ToldColumn::new(
        "contacts per grain without rattlers",
        "",
        "mean number of contacts among the other grains and with walls",
    ),
    ToldColumn::new("fabric xx", "", "mean of the products of the components of the normals"),
    ToldColumn::new("fabric yy", "", "see fabric xx"),
    ToldColumn::new("fabric zz", "", "see fabric xx"),
    ToldColumn::new("fabric xy", "", "see fabric xx"),
    ToldColumn::new("fabric xz", "", "see fabric xx"),
    ToldColumn::new("fabric yz", "", "see fabric xx"),
    ToldColumn::new(
        "fabric anisotropy",
        "",
        "0 when contacts point everywhere alike, 1 when all point along one line",
    ),
    ToldColumn::new("force fabric xx", "", "the same, weighed by the normal force"),
    ToldColumn::new("force fabric yy", "", "see force fabric xx"),
    ToldColumn::new("force fabric zz", "", "see force fabric xx"),
    ToldColumn::new("force fabric xy", "", "see force fabric xx"),
    ToldColumn::new("force fabric xz", "", "see force fabric xx"),
    ToldColumn::new("force fabric yz", "", "see force fabric xx"),
    ToldColumn::new("force fabric anisotropy", "", "anisotropy of the force fabric"),
    ToldColumn::new(
        "strong share",
        "",
        "share of the contacts that carry more than the mean normal force",
    ),
    ToldColumn::new("strong force share", "", "share of the normal force that they carry"),
    ToldColumn::new(
        "friction mobilised",
        "",
        "sum of the tangential forces over the sum of the normal forces",
    ),
];

/// Which contacts a fabric is made of: those of grains that count; of one such grain with a wall or another grain, too.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Fabric {
    /// Grains whose centres lie elsewhere do not count.
    pub zone: Zone,
    /// Which grains count.
    pub selection: Selection,
    /// Contacts with a normal force of smaller magnitude are left out [N].
    pub threshold: f64,
    /// Whether contacts with walls are part of the fabric; they always hold grains.
    pub with_walls: bool,
}

/// A contact that counts.
#[derive(Clone, Copy)]
pub(super) struct Counted {
    pub normal: DVec3,
    /// Normal and tangential force [N].
    pub force: [f64; 2],
    bodies: [Option<usize>; 2],
}

impl Fabric {
    /// Titles of its columns.
    pub fn titles(&self, name: &str) -> Vec<String> {
        FABRIC_COLUMNS.iter().map(|c| c.title(name)).collect()
    }

    /// Its values now, in the order of [`FABRIC_COLUMNS`]; what is a mean over nothing is not a number.
    pub fn measure(&self, sim: &Simulation, origins: &Origins) -> Vec<Value> {
        let counts = self.counting(sim, origins);
        let (all, walls) = self.contacts(sim, &counts);
        let part: &[Counted] = if self.with_walls {
            &all
        } else {
            &all[..all.len() - walls]
        };
        let (coordination, rattlers, without) = coordination(&all, &counts);
        let mut values = vec![Value::Count(part.len() as u64)];
        values.extend([coordination, rattlers, without].map(Value::Number));
        for fabric in [tensor(part, |_| 1.0), tensor(part, |c| c.force[0])] {
            values.extend(fabric.map(Value::Number));
            values.push(Value::Number(anisotropy(&fabric)));
        }
        let sum = |k: usize| part.iter().map(|c| c.force[k]).sum::<f64>();
        let (normal, tangential) = (sum(0), sum(1));
        let mean = normal / part.len() as f64;
        let strong = part.iter().filter(|c| c.force[0] > mean);
        let carried: f64 = strong.clone().map(|c| c.force[0]).sum();
        let share = strong.count() as f64 / part.len() as f64;
        values.extend([share, carried / normal, tangential / normal].map(Value::Number));
        values
    }

    /// Which grains count.
    pub(super) fn counting(&self, sim: &Simulation, origins: &Origins) -> Vec<bool> {
        let counts = |g: usize| holds(sim, &self.zone, g) && self.selection.holds(&sim.grains, origins, g);
        (0..sim.grains.len()).map(counts).collect()
    }

    /// Contacts of grains that count, those with walls last, and how many these are.
    pub(super) fn contacts(&self, sim: &Simulation, counts: &[bool]) -> (Vec<Counted>, usize) {
        let mut all = Vec::new();
        let of = |chunk: &ContactChunk, is_wall: bool, all: &mut Vec<Counted>| {
            let strong = |k: usize| chunk.acts(k) && chunk.normal_force()[k].abs() >= self.threshold;
            for k in (0..chunk.len()).filter(|&k| strong(k)) {
                let i = chunk.i[k] as usize;
                let j = (!is_wall).then(|| chunk.j[k] as usize);
                let bodies = [Some(i), j].map(|body| body.filter(|&g| counts[g]));
                if bodies == [None, None] {
                    continue;
                }
                let normal = sim.contact(chunk, k).normal;
                let along = chunk.normal_force()[k];
                let tangential = chunk.tangential_force(k).length();
                all.push(Counted {
                    normal,
                    force: [along, tangential],
                    bodies,
                });
            }
        };
        sim.contacts.pairs.iter().for_each(|chunk| of(chunk, false, &mut all));
        let pairs = all.len();
        sim.contacts.walls.iter().for_each(|chunk| of(chunk, true, &mut all));
        let walls = all.len() - pairs;
        (all, walls)
    }
}

/// Mean of the products of normals, weighed: xx, yy, zz, xy, xz, yz.
fn tensor(contacts: &[Counted], weight: impl Fn(&Counted) -> f64) -> [f64; 6] {
    let (mut sums, mut whole) = ([0.0; 6], 0.0);
    for contact in contacts {
        let (n, w) = (contact.normal, weight(contact));
        whole += w;
        let products = [n.x * n.x, n.y * n.y, n.z * n.z, n.x * n.y, n.x * n.z, n.y * n.z];
        for (sum, product) in sums.iter_mut().zip(products) {
            *sum += w * product;
        }
    }
    sums.map(|sum| sum / whole)
}

/// `sqrt(3/2 D:D)` of the deviator.
fn anisotropy(f: &[f64; 6]) -> f64 {
    let third = (f[0] + f[1] + f[2]) / 3.0;
    let diagonal: f64 = f[..3].iter().map(|x| (x - third) * (x - third)).sum();
    let others: f64 = f[3..].iter().map(|x| x * x).sum();
    (1.5 * (diagonal + 2.0 * others)).sqrt()
}

/// Mean number of contacts, share of rattlers, and mean number of contacts without them.
fn coordination(contacts: &[Counted], counts: &[bool]) -> (f64, f64, f64) {
    let mut of_grain: Vec<Vec<u32>> = vec![Vec::new(); counts.len()];
    for (k, contact) in contacts.iter().enumerate() {
        for body in contact.bodies.into_iter().flatten() {
            of_grain[body].push(k as u32);
        }
    }
    let grains = counts.iter().filter(|counts| **counts).count();
    let all: usize = of_grain.iter().map(Vec::len).sum();
    let mut left: Vec<u32> = of_grain.iter().map(|list| list.len() as u32).collect();
    let mut is_gone = vec![false; contacts.len()];
    let mut loose: Vec<usize> = (0..counts.len()).filter(|&g| counts[g] && left[g] < HOLD).collect();
    let mut rattles = vec![false; counts.len()];
    loose.iter().for_each(|&g| rattles[g] = true);
    while let Some(g) = loose.pop() {
        for &k in &of_grain[g] {
            if std::mem::replace(&mut is_gone[k as usize], true) {
                continue;
            }
            for body in contacts[k as usize].bodies.into_iter().flatten() {
                left[body] -= 1;
                if left[body] < HOLD && !rattles[body] {
                    rattles[body] = true;
                    loose.push(body);
                }
            }
        }
    }
    let rattlers = rattles.iter().filter(|rattles| **rattles).count();
    let held: u32 = (0..counts.len())
        .filter(|&g| counts[g] && !rattles[g])
        .map(|g| left[g])
        .sum();
    (
        all as f64 / grains as f64,
        rattlers as f64 / grains as f64,
        f64::from(held) / (grains - rattlers) as f64,
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn contact(normal: DVec3, force: f64, bodies: [usize; 2]) -> Counted {
        Counted {
            normal,
            force: [force, 0.0],
            bodies: bodies.map(Some),
        }
    }

    #[test]
    fn fabrics_of_lines_planes_and_lattices_have_known_anisotropies() {
        let along = |normal: DVec3| contact(normal, 2.0, [0, 1]);
        let line = [along(DVec3::Z), along(DVec3::NEG_Z)];
        let fabric = tensor(&line, |_| 1.0);
        assert_eq!(fabric, [0.0, 0.0, 1.0, 0.0, 0.0, 0.0]);
        assert!((anisotropy(&fabric) - 1.0).abs() < 1e-15);
        let plane = [along(DVec3::X), along(DVec3::Y)];
        assert!((anisotropy(&tensor(&plane, |_| 1.0)) - 0.5).abs() < 1e-15);
        let cube = [along(DVec3::X), along(DVec3::Y), along(DVec3::Z)];
        assert!(anisotropy(&tensor(&cube, |_| 1.0)) < 1e-15);
        // the same numbers in a turned frame
        let turned = [along(DVec3::new(0.6, 0.0, 0.8)), along(DVec3::new(0.6, 0.0, 0.8))];
        assert!((anisotropy(&tensor(&turned, |_| 1.0)) - 1.0).abs() < 1e-15);
        let mut weighed = cube;
        weighed[2].force[0] = 1e9;
        assert!(anisotropy(&tensor(&weighed, |c| c.force[0])) > 0.999);
        assert!(anisotropy(&tensor(&[], |_| 1.0)).is_nan());
    }

    #[test]
    fn rattlers_go_with_what_they_held() {
        // a tetrahedron of four with a fifth in the middle: everybody touches all others, four contacts each
        let mut contacts = Vec::new();
        for a in 0..5 {
            for b in a + 1..5 {
                contacts.push(contact(DVec3::X, 1.0, [a, b]));
            }
        }
        // a chain of two hangs on, and one is alone
        contacts.push(contact(DVec3::X, 1.0, [4, 5]));
        contacts.push(contact(DVec3::X, 1.0, [5, 6]));
        let (all, rattlers, without) = coordination(&contacts, &[true; 8]);
        assert_eq!((all, rattlers, without), (3.0, 3.0 / 8.0, 4.0));
        // without one of them the others have three, and all fall
        let counts = [true, true, true, true, false, false, false, false];
        for contact in &mut contacts {
            contact.bodies = contact.bodies.map(|body| body.filter(|&g| counts[g]));
        }
        contacts.retain(|c| c.bodies[0].is_some() && c.bodies[1].is_some());
        let (all, rattlers, without) = coordination(&contacts, &counts);
        assert_eq!((all, rattlers), (3.0, 1.0));
        assert!(without.is_nan());
    }
}
