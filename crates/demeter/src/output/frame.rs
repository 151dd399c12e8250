//! What is written of one moment.

use crate::comm::together::Together;
use crate::materials::Material;
use crate::measure::{ContactAt, ContactsAt};
use crate::particles::{ById, Grains};
use crate::walls::ElementRecord;
use glam::{DVec3, Vec3};
use std::f64::consts::PI;
use std::ops::{AddAssign, Range};

/// A contact as it is written. Forces and torque are in single precision, as the tables of contacts hold them: a frame has many of these.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ContactRecord {
    /// Id of the first grain.
    pub id_i: u32,
    /// Id of the second grain; 0 for a wall.
    pub id_j: u32,
    /// Index of the wall; -1 between grains.
    pub wall: i32,
    /// Which element of the wall is touched (triangle of a mesh, face of a box), as loads and wear are recorded; 0 otherwise.
    pub element: u32,
    /// Contact point [m].
    pub position: DVec3,
    /// Unit normal, from `j` or the wall towards `i`.
    pub normal: DVec3,
    /// Overlap [m].
    pub overlap: f64,
    /// Normal force, repulsion positive [N].
    pub push: f32,
    /// Tangential force on grain `i` [N].
    pub drag: Vec3,
    /// Rolling torque on grain `i` [N m].
    pub torque: Vec3,
}

/// A wall as it is written and drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct WallSurface<'a> {
    /// Name in the scenario.
    pub name: &'a str,
    /// Its surface where it stands now, as triangles [m].
    pub triangles: Vec<[DVec3; 3]>,
    /// Force of the grains on it [N].
    pub force: DVec3,
    /// Torque of the grains on it about the origin of its pose [N m].
    pub torque: DVec3,
    /// Velocity of the surface in the middle of every triangle, that of a belt included [m/s].
    pub velocities: Vec<DVec3>,
    /// What was recorded on the element that every triangle draws; `None` where nothing is recorded.
    pub records: Option<Vec<ElementRecord>>,
}

/// The domain of a run at one moment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrameBox {
    /// Lower corner [m].
    pub corner: DVec3,
    /// What leads from the corner along its sides; across a periodic side, from a grain to its image [m].
    pub edges: [DVec3; 3],
    /// Which directions are periodic.
    pub periodic: [bool; 3],
}

/// What a process has of a frame; all of it unless told.
#[derive(Clone, Debug)]
pub(crate) struct FramePart<'a> {
    /// Who has the rest.
    pub together: Together<'a>,
    /// Its own grains.
    pub grains: Range<usize>,
}

impl Default for FramePart<'_> {
    fn default() -> Self {
        Self {
            together: Together::ALONE,
            grains: 0..usize::MAX,
        }
    }
}

/// One moment of a run.
#[derive(Clone, Debug)]
pub struct Frame<'a> {
    /// Steps done.
    pub step: u64,
    /// Simulated time [s].
    pub time: f64,
    /// All grains.
    pub grains: &'a Grains,
    /// Materials, by index.
    pub materials: &'a [Material],
    /// All contacts that own grains are in.
    pub contacts: ContactsAt<'a>,
    /// All walls.
    pub walls: &'a [WallSurface<'a>],
    /// Tags of the own grains; nothing where none has a tag.
    pub tags: Option<Vec<i32>>,
    /// The domain, where one is told.
    pub cell: Option<FrameBox>,
    pub(crate) part: FramePart<'a>,
}

impl ContactRecord {
    /// Normal force, repulsion positive [N].
    pub fn repulsion(&self) -> f64 {
        self.push.into()
    }

    /// Tangential force on grain `i` [N].
    pub fn tangential_force(&self) -> DVec3 {
        self.drag.as_dvec3()
    }

    /// Rolling torque on grain `i` [N m].
    pub fn rolling_torque(&self) -> DVec3 {
        self.torque.as_dvec3()
    }
}

impl Frame<'_> {
    /// Own grains.
    pub(crate) fn own(&self) -> Range<usize> {
        let (grains, part) = (self.grains.len(), &self.part.grains);
        part.start.min(grains)..part.end.min(grains)
    }

    /// Number of the contacts of every own grain that act, walls counted.
    pub fn coordination(&self) -> Vec<u32> {
        self.sums(|_, _| 1)
    }

    /// Sum of the magnitudes of the normal forces on every own grain [N].
    pub fn contact_force(&self) -> Vec<f64> {
        self.sums(|contact, _| contact.repulsion().abs())
    }

    /// Mean normal stress of every own grain, compression positive [Pa].
    ///
    /// Of a grain of volume `V` it is `sum(f_n l) / (3 V)` over its contacts, with the normal force
    /// `f_n` (repulsion positive) and the distance `l` from the centre to the contact: `r - overlap / 2` between grains,
    /// `r - overlap` at a wall. It is the mean over the grain's volume of a third of the trace of the stress (J. Weber,
    /// Bulletin de Liaison des Ponts et Chaussees 20, 1966); friction, which is perpendicular to `l`, gives nothing to it.
    pub fn mean_normal_stress(&self) -> Vec<f64> {
        let mut stress = self.sums(|contact, grain| {
            let depth = match contact.wall() < 0 {
                true => 0.5 * contact.overlap(),
                false => contact.overlap(),
            };
            contact.repulsion() * (self.grains.radius(grain) - depth)
        });
        for (stress, grain) in stress.iter_mut().zip(self.own()) {
            let r = self.grains.radius(grain);
            *stress /= 4.0 * PI * r * r * r;
        }
        stress
    }

    /// Sums over the contacts of every own grain, in their order, of what a contact gives to a grain.
    fn sums<T: AddAssign + Clone + Default>(&self, of: impl Fn(ContactAt<'_>, usize) -> T) -> Vec<T> {
        let own = self.own();
        // contacts of a list know ids alone
        let by_id = matches!(self.contacts, ContactsAt::List(_)).then(|| ById::new(&self.grains.id[own.clone()]));
        let find = |id| Some(own.start + by_id.as_ref()?.find(id)?);
        let mut sums = vec![T::default(); own.len()];
        for contact in self.contacts.all() {
            for grain in contact.grains(find).into_iter().flatten().filter(|g| own.contains(g)) {
                sums[grain - own.start] += of(contact, grain);
            }
        }
        sums
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::particles::NewGrain;
    use approx::assert_relative_eq;

    #[test]
    fn stress_and_force_count_every_contact_of_a_grain() {
        // grain 7 (r = 2) rests on wall 0 and carries grain 3 (r = 1)
        let mut grains = Grains::default();
        for (id, radius, z) in [(7, 2.0, 1.9), (3, 1.0, 4.7)] {
            grains.push(
                id,
                &NewGrain {
                    material: 0,
                    radius,
                    density: 1.0,
                    position: DVec3::new(0.0, 0.0, z),
                    velocity: DVec3::ZERO,
                    angular_velocity: DVec3::ZERO,
                    fixed: false,
                },
            );
        }
        let contact = |id_i, id_j, wall, overlap, force| ContactRecord {
            id_i,
            id_j,
            wall,
            normal: DVec3::Z,
            overlap,
            push: force,
            drag: Vec3::X,
            ..ContactRecord::default()
        };
        let frame = Frame {
            step: 0,
            time: 0.0,
            grains: &grains,
            materials: &[],
            contacts: ContactsAt::List(&[contact(3, 7, -1, 0.2, 10.0), contact(7, 0, 0, 0.1, 30.0)]),
            walls: &[],
            tags: None,
            cell: None,
            part: FramePart::default(),
        };
        assert_eq!(frame.coordination(), [2, 1]);
        assert_eq!(frame.contact_force(), [40.0, 10.0]);
        let stress = frame.mean_normal_stress();
        let volume = |r: f64| 4.0 / 3.0 * PI * r.powi(3);
        let expected = (10.0 * 1.9 + 30.0 * 1.9) / (3.0 * volume(2.0));
        assert_relative_eq!(stress[0], expected, max_relative = 1e-14);
        assert_relative_eq!(stress[1], 10.0 * 0.9 / (3.0 * volume(1.0)), max_relative = 1e-14);
    }
}
