//! How grains meet the same parts of walls as in the step before, several at a time.

use super::Scene;
use super::kinematics::put_listed;
use super::meetings::{lanes_below, next_lane};
use super::wall_contacts::geometry;
use crate::walls::PlacedPart;
use demeter_physics::geometry::contact_sphere_sphere::Contact;
use demeter_physics::lanes::{Index, Kernel, Lanes, MOST_LANES, Mask, Vector};
use glam::DVec3;

/// Looks at contacts with walls.
pub(super) struct LookAgain<'a> {
    pub(super) scene: &'a Scene<'a>,
    /// Grains, walls and their elements.
    pub(super) i: &'a [u32],
    pub(super) j: &'a [u32],
    pub(super) element: &'a [u32],
    /// Distance beyond touching at which bodies may act in this step [m].
    pub(super) window: f64,
    /// Whether there are contacts with meshes among them, which are left alone.
    pub(super) beside_meshes: bool,
    pub(super) contacts: &'a mut [Contact],
}

/// A part of a wall, and where it stands if grains can be held to it several at a time.
type Part = ((u32, u32), Option<PlacedPart>);

impl LookAgain<'_> {
    fn place(&self, (wall, element): (u32, u32)) -> Part {
        ((wall, element), self.scene.walls[wall as usize].placed_part(element))
    }

    /// Lanes whose wall is not a mesh, among some.
    #[inline(always)]
    fn off_meshes<L: Lanes>(&self, walls: &Index, among: u32) -> u32 {
        if !self.beside_meshes {
            return among;
        }
        let (mut off, mut lane) = (0, 0);
        while lane < L::COUNT {
            off |= u32::from(self.scene.walls[walls[lane] as usize].mesh().is_none()) << lane;
            lane += 1;
        }
        off & among
    }

    /// Looks at a contact alone.
    #[inline(never)]
    fn look_alone(&mut self, k: usize) {
        let g = self.i[k] as usize;
        let found = (self.scene).contact_with(g, (self.j[k], self.element[k]), self.window);
        if let Some(part) = found {
            self.contacts[k] = geometry(&part, self.scene.grains.radius(g));
        }
    }
}

/// Lanes with the same part as one, among some.
#[inline(always)]
fn with_same<L: Lanes>(walls: &Index, elements: &Index, one: usize, among: u32) -> u32 {
    let (mut same, mut lane) = (0, 0);
    while lane < L::COUNT {
        same |= u32::from(walls[lane] == walls[one] && elements[lane] == elements[one]) << lane;
        lane += 1;
    }
    same & among
}

impl Kernel for LookAgain<'_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(mut self) {
        let count = self.contacts.len();
        let [positions, ..] = self.scene.grains.tables();
        let mut part: Part = ((u32::MAX, u32::MAX), None);
        for k in (0..count).step_by(L::COUNT) {
            let [mut grains, mut walls, mut elements] = [[0; MOST_LANES]; 3];
            put_listed::<L>(self.i, k, &mut grains);
            put_listed::<L>(self.j, k, &mut walls);
            put_listed::<L>(self.element, k, &mut elements);
            let here = self.off_meshes::<L>(&walls, lanes_below((count - k).min(L::COUNT)));
            if here == 0 {
                continue;
            }
            let [[x, y, z, radius]] = L::fetch([positions], &grains);
            let (mut normal, mut distance) = (L::Vector::null(), L::splat(0.0));
            let (mut left, mut told) = (here, 0);
            while left != 0 {
                let one = left.trailing_zeros() as usize;
                let same = with_same::<L>(&walls, &elements, one, left);
                left &= !same;
                let which = (walls[one], elements[one]);
                if part.0 != which {
                    part = self.place(which);
                }
                let Some(placed) = &part.1 else { continue };
                let found = placed.closest::<L>(L::Vector::new(x, y, z), radius + self.window);
                let mask = L::Mask::of_bits(found.told & same);
                normal = found.normal.or(mask, normal);
                distance = L::select(mask, found.distance, distance);
                told |= found.told & same;
            }
            let [nx, ny, nz] = normal.components();
            let rows = L::rows([nx, ny, nz, radius - distance]);
            let levers = distance.to_array();
            let end = (k + L::COUNT).min(count);
            for (lane, contact) in self.contacts[k..end].iter_mut().enumerate() {
                if here >> lane & 1 == 0 {
                    continue;
                }
                let [x, y, z, overlap] = rows.as_ref()[lane];
                *contact = Contact {
                    normal: DVec3::new(x, y, z),
                    overlap,
                    lever_i: levers[lane],
                    lever_j: 0.0,
                };
            }
            let mut alone = here & !told;
            while let Some(lane) = next_lane(&mut alone) {
                self.look_alone(k + lane);
            }
        }
    }
}
