//! Contacts that begin, where somebody asks how fast bodies meet.

use super::Scene;
use super::evaluate::WORD;
use super::kinematics::Source;
use glam::DVec3;
use serde::{Deserialize, Serialize};

/// A contact that begins.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Impact {
    /// The step in which it does.
    pub step: u64,
    /// Whether the second body is a wall.
    pub with_wall: bool,
    pub bodies: [Struck; 2],
    /// Contact point [m].
    pub place: DVec3,
    /// Energies of the relative motion along the normal and in the contact plane, `m v^2 / 2` with the effective mass [J].
    pub energies: [f64; 2],
}

/// A body of a contact that begins.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Struck {
    /// Id of the grain, or index of the wall.
    pub id: u32,
    pub material: u16,
    /// Diameter of a grain [m]; that of a wall is infinite.
    pub diameter: f64,
}

impl Impact {
    /// By what impacts are sorted: the same on any number of processes.
    pub(crate) fn order(&self) -> (u64, bool, u32, u32) {
        let [one, other] = self.bodies;
        (self.step, self.with_wall, one.id, other.id)
    }
}

impl Struck {
    fn grain(scene: &Scene, g: u32) -> Self {
        let (grains, g) = (scene.grains, g as usize);
        Self {
            id: grains.id[g],
            material: grains.material[g],
            diameter: 2.0 * grains.radius(g),
        }
    }

    fn wall(scene: &Scene, wall: u32) -> Self {
        Self {
            id: wall,
            material: scene.walls[wall as usize].material,
            diameter: f64::INFINITY,
        }
    }
}

/// Which contacts act now and did not before, told by their bits.
pub(super) fn begun(before: &[u64], now: &[u64]) -> Vec<usize> {
    let words = now.iter().enumerate();
    let new = words.map(|(k, word)| (k * WORD, word & !before.get(k).copied().unwrap_or(0)));
    new.filter(|(_, bits)| *bits != 0)
        .flat_map(|(first, bits)| {
            (0..WORD)
                .filter(move |bit| bits >> bit & 1 != 0)
                .map(move |bit| first + bit)
        })
        .collect()
}

/// Tells of contacts that begin. A source that notes which contacts act finds what it has noted before.
pub(super) fn tell(
    mut source: impl Source,
    begun: &[usize],
    (i, j): (&[u32], &[u32]),
    with_wall: bool,
    scene: &Scene,
    told: &mut Vec<Impact>,
) {
    for &k in begun {
        let seen = source.look::<f64>(k, 1);
        let motion = &seen.motion;
        let energy = |speed2: f64| 0.5 * motion.size.mass * speed2;
        let second = match with_wall {
            true => Struck::wall(scene, j[k]),
            false => Struck::grain(scene, j[k]),
        };
        told.push(Impact {
            step: scene.step,
            with_wall,
            bodies: [Struck::grain(scene, i[k]), second],
            place: scene.grains.position[i[k] as usize] - motion.normal * motion.levers[0],
            energies: [
                energy(motion.rate * motion.rate),
                energy(seen.turning.sliding(motion).length_squared()),
            ],
        });
    }
}
