//! Fabric: which way contacts point, how many grains they hold, and how unequally they carry.
//!
//! With the unit normals `n_c` of the contacts and their normal forces `f_c`
//!
//! ```text
//! F_ab = sum g n_a n_b / sum g                H_ab = sum g |f| n_a n_b / sum g |f|
//! ```
//!
//! with `g` the number of grains of the contact that count, one or two: the mean over the grains. At the border of a region contacts between a grain inside
//! and one outside count once, and those of two inside twice, as each grain counts its own; without that a layer would seem to have contacts across its borders most. One with a wall counts once
//! (K. Kanatani, Int. J. Eng. Sci. 22 (1984) 149; H weighs by force, whichever way it acts, for in a packing that sticks pushes and pulls
//! cancel). The traces are 1. The anisotropy of a fabric is
//! `sqrt(3/2 D:D)` of its deviator `D = F - 1/3`: 0 when no direction is preferred, 1 when all contacts point the same way.
//!
//! **Rattlers** are grains that fewer contacts hold than are needed: four without friction, two with it, which then carry a grain between them;
//! one with friction counts for two without where a grain has both
//! (C. Thornton, Géotechnique 50 (2000) 43, leaves out grains with none and with one). They are taken out one after the other with their
//! contacts, as what they held may rattle then, too. Grains that hang on others by adhesion count like those that rest on them. The coordination without rattlers is the mean over the others.
//!
//! The **strong network** (F. Radjai et al., Phys. Rev. Lett. 77 (1996) 274) is made of the contacts that carry more than the
//! mean magnitude of the normal force.

use super::told_first::{Acting, counting, each_contact};
use super::{Selection, ToldColumn, Value};
use crate::contacts::laws::friction_limit;
use crate::particles::{Origins, Zone};
use crate::simulation::Simulation;
use demeter_physics::contact::PairLaw;
use glam::DVec3;
use serde::{Deserialize, Serialize};

/// Contacts that hold a grain in space by their normal forces alone.
const HOLD: u32 = 4;
/// For how many of these a contact counts that bears friction: two hold a grain.
const BY_FRICTION: u32 = 2;

/// Columns of a fabric.
pub const FABRIC_COLUMNS: &[ToldColumn] = &[
    ToldColumn::new("counted contacts", "", "contacts of which a grain counts"),
    ToldColumn::new(
        "contacts per grain",
        "",
        "mean number of contacts of the grains, those with walls counted whatever `with_walls` says",
    ),
    ToldColumn::new(
        "rattlers",
        "",
        "share of the grains that less than four contacts hold; one that bears friction counts for two",
    ),
    ToldColumn::new(
        "contacts per grain without rattlers",
        "",
        "mean number of contacts among the other grains and with walls, whatever `with_walls` says",
    ),
    ToldColumn::new(
        "fabric xx",
        "",
        "mean of the products of the components of the normals over the contacts of every grain",
    ),
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
    ToldColumn::new(
        "force fabric xx",
        "",
        "the same, weighed by the magnitude of the normal force",
    ),
    ToldColumn::new("force fabric yy", "", "see force fabric xx"),
    ToldColumn::new("force fabric zz", "", "see force fabric xx"),
    ToldColumn::new("force fabric xy", "", "see force fabric xx"),
    ToldColumn::new("force fabric xz", "", "see force fabric xx"),
    ToldColumn::new("force fabric yz", "", "see force fabric xx"),
    ToldColumn::new("force fabric anisotropy", "", "anisotropy of the force fabric"),
    ToldColumn::new(
        "strong share",
        "",
        "share of the contacts that carry more than the mean magnitude of the normal force",
    ),
    ToldColumn::new(
        "strong force share",
        "",
        "share of the sum of these magnitudes that they carry",
    ),
    ToldColumn::new(
        "friction mobilised",
        "",
        "sum of the magnitudes of the tangential forces over that of the normal forces",
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
#[derive(Clone, Copy, Serialize, Deserialize)]
pub(super) struct Counted {
    pub normal: DVec3,
    /// Normal and tangential force [N].
    pub force: [f64; 2],
    pub with_wall: bool,
    bodies: Bodies,
    bears_friction: bool,
}

impl Counted {
    /// For how many contacts without friction it counts where grains are held.
    fn holds(&self) -> u32 {
        if self.bears_friction { BY_FRICTION } else { 1 }
    }

    /// How many of its grains count.
    pub(super) fn weight(&self) -> f64 {
        grains_of(&self.bodies).count() as f64
    }
}

/// Grains of a contact that count.
type Bodies = [Option<u32>; 2];

fn grains_of(bodies: &Bodies) -> impl Iterator<Item = usize> + '_ {
    bodies.iter().flatten().map(|g| *g as usize)
}

impl Fabric {
    /// Titles of its columns.
    pub fn titles(&self, name: &str) -> Vec<String> {
        FABRIC_COLUMNS.iter().map(|c| c.title(name)).collect()
    }

    /// Its values now, in the order of [`FABRIC_COLUMNS`]; what is a mean over nothing is not a number.
    pub fn measure(&self, sim: &Simulation, origins: &Origins) -> Vec<Value> {
        let counts = counting(sim, &self.zone, &self.selection, origins);
        let mut holding: Vec<(Bodies, u32)> = Vec::new();
        let mut fabrics = [Tensor::default(); 2];
        // one by one, as those that carry more than the mean are found when it is known
        let (mut forces, mut tangential) = (Vec::new(), 0.0);
        self.each_contact(sim, &counts, |contact| {
            holding.push((contact.bodies, contact.holds()));
            if self.with_walls || !contact.with_wall {
                fabrics[0].add(contact.normal, contact.weight());
                fabrics[1].add(contact.normal, contact.weight() * contact.force[0].abs());
                forces.push(contact.force[0].abs());
                tangential += contact.force[1];
            }
        });
        let own = sim.own_grains().filter(|&g| counts[g]).count();
        let grains = sim.together().count(own);
        let (coordination, rattlers, without) = coordination(&holding, grains, counts.len());
        let mut values = vec![Value::Count(forces.len() as u64)];
        values.extend([coordination, rattlers, without].map(Value::Number));
        for fabric in fabrics.map(|fabric| fabric.mean()) {
            values.extend(fabric.map(Value::Number));
            values.push(Value::Number(anisotropy(&fabric)));
        }
        let normal: f64 = forces.iter().sum();
        let mean = normal / forces.len() as f64;
        let strong = forces.iter().filter(|force| **force > mean);
        // a sum of nothing is -0
        let carried = strong.clone().fold(0.0, |sum, force| sum + force);
        let share = strong.count() as f64 / forces.len() as f64;
        values.extend([share, carried / normal, tangential / normal].map(Value::Number));
        values
    }

    /// Contacts of grains that count, those with walls last: the first process is told of all.
    pub(super) fn each_contact(&self, sim: &Simulation, counts: &[bool], look: impl FnMut(Counted)) {
        let bears_friction = |law: &PairLaw| friction_limit(law, 1.0) > 0.0;
        let bear_friction: Vec<bool> = sim.materials.laws().iter().map(bears_friction).collect();
        let tell = |contact: Acting<'_>| {
            let bodies = contact
                .grains()
                .map(|grain| grain.filter(|&g| counts[g]).map(|g| g as u32));
            let along = contact.normal_force();
            (bodies != [None, None] && along.abs() >= self.threshold).then(|| Counted {
                normal: contact.contact(sim).normal,
                force: [along, contact.chunk.tangential_force(contact.place).length()],
                with_wall: contact.with_wall,
                bodies,
                bears_friction: bear_friction[contact.chunk.law() as usize],
            })
        };
        each_contact(sim, tell, look);
    }
}

/// Mean of the products of the components of normals, weighed: xx, yy, zz, xy, xz, yz.
#[derive(Clone, Copy, Default)]
struct Tensor {
    sums: [f64; 6],
    weight: f64,
}

impl Tensor {
    fn add(&mut self, n: DVec3, weight: f64) {
        self.weight += weight;
        let products = [n.x * n.x, n.y * n.y, n.z * n.z, n.x * n.y, n.x * n.z, n.y * n.z];
        for (sum, product) in self.sums.iter_mut().zip(products) {
            *sum += weight * product;
        }
    }

    fn mean(&self) -> [f64; 6] {
        self.sums.map(|sum| sum / self.weight)
    }
}

/// `sqrt(3/2 D:D)` of the deviator.
fn anisotropy(f: &[f64; 6]) -> f64 {
    let third = (f[0] + f[1] + f[2]) / 3.0;
    let diagonal: f64 = f[..3].iter().map(|x| (x - third) * (x - third)).sum();
    let others: f64 = f[3..].iter().map(|x| x * x).sum();
    (1.5 * (diagonal + 2.0 * others)).sqrt()
}

/// Mean number of contacts, share of rattlers, which less than four contacts hold, and mean number of contacts without them, of so many
/// `grains` that count among `all`. A contact tells for how many it counts.
fn coordination(contacts: &[(Bodies, u32)], grains: usize, all: usize) -> (f64, f64, f64) {
    // the contacts of grain g are those between starts g and g + 1
    let mut starts = vec![0u32; all + 1];
    let bodies = || contacts.iter().map(|(bodies, _)| bodies);
    bodies().flat_map(grains_of).for_each(|g| starts[g + 1] += 1);
    for g in 0..all {
        starts[g + 1] += starts[g];
    }
    let ends = starts[all];
    let (mut of_grains, mut filled) = (vec![0u32; ends as usize], starts.clone());
    let mut holds = vec![0u32; all];
    for (k, (bodies, counts_for)) in contacts.iter().enumerate() {
        for g in grains_of(bodies) {
            holds[g] += counts_for;
            of_grains[filled[g] as usize] = k as u32;
            filled[g] += 1;
        }
    }
    let mut left: Vec<u32> = starts.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let mut is_gone = vec![false; contacts.len()];
    // a grain without any contact rattles
    let mut rattles: Vec<bool> = holds.iter().map(|count| *count < HOLD).collect();
    let mut loose: Vec<usize> = (0..all).filter(|&g| rattles[g] && left[g] > 0).collect();
    while let Some(g) = loose.pop() {
        for &k in &of_grains[starts[g] as usize..starts[g + 1] as usize] {
            if std::mem::replace(&mut is_gone[k as usize], true) {
                continue;
            }
            let (bodies, counts_for) = &contacts[k as usize];
            for body in grains_of(bodies) {
                left[body] -= 1;
                holds[body] -= counts_for;
                if holds[body] < HOLD && !rattles[body] {
                    rattles[body] = true;
                    loose.push(body);
                }
            }
        }
    }
    let still = (0..all).filter(|&g| !rattles[g]);
    let (stay, held) = still.fold((0, 0), |(count, sum), g| (count + 1, sum + left[g]));
    (
        f64::from(ends) / grains as f64,
        (grains - stay) as f64 / grains as f64,
        f64::from(held) / stay as f64,
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tensor(contacts: &[(DVec3, f64)]) -> [f64; 6] {
        let mut tensor = Tensor::default();
        contacts.iter().for_each(|&(normal, weight)| tensor.add(normal, weight));
        tensor.mean()
    }

    #[test]
    fn fabrics_of_lines_planes_and_lattices_have_known_anisotropies() {
        let line = [(DVec3::Z, 1.0), (DVec3::NEG_Z, 1.0)];
        let fabric = tensor(&line);
        assert_eq!(fabric, [0.0, 0.0, 1.0, 0.0, 0.0, 0.0]);
        assert!((anisotropy(&fabric) - 1.0).abs() < 1e-15);
        let plane = [(DVec3::X, 1.0), (DVec3::Y, 1.0)];
        assert!((anisotropy(&tensor(&plane)) - 0.5).abs() < 1e-15);
        let cube = [(DVec3::X, 1.0), (DVec3::Y, 1.0), (DVec3::Z, 1.0)];
        assert!(anisotropy(&tensor(&cube)) < 1e-15);
        // the same numbers in a turned frame
        let turned = [(DVec3::new(0.6, 0.0, 0.8), 2.0); 2];
        assert!((anisotropy(&tensor(&turned)) - 1.0).abs() < 1e-15);
        let mut weighed = cube;
        weighed[2].1 = 1e9;
        assert!(anisotropy(&tensor(&weighed)) > 0.999);
        assert!(anisotropy(&tensor(&[])).is_nan());
    }

    #[test]
    fn rattlers_go_with_what_they_held() {
        // a tetrahedron of four with a fifth in the middle: everybody touches all others, four contacts each
        let of = |contacts: &[Bodies], counts_for: u32, grains, all| {
            let holding: Vec<(Bodies, u32)> = contacts.iter().map(|bodies| (*bodies, counts_for)).collect();
            coordination(&holding, grains, all)
        };
        let mut contacts = Vec::new();
        for a in 0..5 {
            for b in a + 1..5 {
                contacts.push([a, b].map(Some));
            }
        }
        // a chain of two hangs on, and one is alone
        contacts.push([4, 5].map(Some));
        contacts.push([5, 6].map(Some));
        assert_eq!(of(&contacts, 1, 8, 8), (3.0, 3.0 / 8.0, 4.0));
        // friction holds five as well; the chain goes all the same, from its end
        assert_eq!(of(&contacts, BY_FRICTION, 8, 8), (3.0, 3.0 / 8.0, 4.0));
        // without one of them the others have three, and all fall
        contacts.retain(|bodies| bodies.iter().flatten().all(|&g| g < 4));
        let (all, rattlers, without) = of(&contacts, 1, 4, 8);
        assert_eq!((all, rattlers), (3.0, 1.0));
        assert!(without.is_nan());
        // unless friction holds them
        assert_eq!(of(&contacts, BY_FRICTION, 4, 8), (3.0, 0.0, 3.0));
        // or where one contact of each of them bears friction: with a wall
        let mut holding: Vec<(Bodies, u32)> = contacts.iter().map(|bodies| (*bodies, 1)).collect();
        assert_eq!(coordination(&holding, 4, 8).1, 1.0);
        holding.extend((0..4).map(|g| ([Some(g), None], BY_FRICTION)));
        assert_eq!(coordination(&holding, 4, 8), (4.0, 0.0, 4.0));
        // friction elsewhere holds nobody
        holding.truncate(contacts.len());
        holding.push(([Some(7), None], BY_FRICTION));
        assert_eq!(coordination(&holding, 5, 8).1, 1.0);
    }
}
