//! Places and velocities that are changed from outside, between two steps.

use super::time_step::largest_reach;
use super::{Simulation, WallPartner};
use crate::contacts::Fault;
use crate::contacts::laws;
use crate::materials::Materials;
use crate::particles::{HigherDerivatives, MOST_CROSSINGS, can_be_counted};
use glam::DVec3;
use std::mem;

/// Forces at new places are found with a step that is so much shorter, in which springs hardly move.
const SHORT_STEP: f64 = 1e-3;

/// Why grains cannot be changed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ChangeError {
    /// Not one vector per grain.
    #[error("{found} vectors for {grains} grains: one for each is needed")]
    Length {
        /// Vectors given.
        found: usize,
        /// Grains.
        grains: usize,
    },
    /// A component is not finite.
    #[error("the {what} of grain {id} would be {value}, which is not finite")]
    NotFinite {
        /// What.
        what: &'static str,
        /// Id of the grain.
        id: u32,
        /// The value given.
        value: DVec3,
    },
    /// The box deforms.
    #[error("grains cannot be put elsewhere while the periodic box deforms")]
    Deforms,
    /// Another gravity that cannot be.
    #[error("a gravity of {value} m/s^2 cannot act here; it must be {allowed}")]
    Gravity {
        /// The value given [m/s^2].
        value: DVec3,
        /// What it must be.
        allowed: &'static str,
    },
    /// The new state is one that the model does not cover.
    #[error(transparent)]
    Fault(#[from] Fault),
}

impl Simulation {
    /// Gives all grains other velocities [m/s], by index; those that are fixed keep theirs. The change of kinetic energy is booked as work of
    /// custom forces.
    pub fn set_velocities(&mut self, velocities: &[DVec3]) -> Result<(), ChangeError> {
        self.check_change("velocity", velocities)?;
        self.change(|sim| {
            for (grain, new) in velocities.iter().enumerate() {
                if !sim.grains.is_fixed(grain) {
                    sim.grains.velocity[grain] = *new;
                }
            }
            Ok(())
        })
    }

    /// Gives all grains other angular velocities [1/s], by index; those that are fixed keep theirs. The change of energy is booked as work
    /// of custom forces.
    pub fn set_angular_velocities(&mut self, velocities: &[DVec3]) -> Result<(), ChangeError> {
        self.check_change("angular velocity", velocities)?;
        self.change(|sim| {
            for (grain, new) in velocities.iter().enumerate() {
                if !sim.grains.is_fixed(grain) {
                    sim.grains.angular_velocity[grain] = *new;
                }
            }
            Ok(())
        })
    }

    /// Puts all grains elsewhere [m], by index. A place beyond a periodic side is that of its image in the box, and the grain has crossed that
    /// side, as displacements tell. Candidates and forces are found anew; contacts that last keep what they remember; the change of energy is booked as work of custom forces. The grains may lie in
    /// another order in memory afterwards.
    /// Nothing changes where a grain would have crossed periodic sides more often than is counted. After any other fault the grains are at the new
    /// places, and no forces that belong there are known: put them elsewhere before the next step, which need not find that fault again.
    pub fn set_positions(&mut self, positions: &[DVec3]) -> Result<(), ChangeError> {
        self.check_change("position", positions)?;
        if self.deforms() {
            return Err(ChangeError::Deforms);
        }
        let domain = *self.domain();
        let brought_back = |grain: usize| {
            let (new, crossed) = (positions[grain], self.grains.crossings(grain));
            let place = domain.brought_back(new);
            let boxes = ((new - place) / domain.size()).round().to_array();
            let crossings: [i32; 3] = [0, 1, 2].map(|k| crossed[k].saturating_add(boxes[k] as i32));
            (place, crossings)
        };
        let places: Vec<(DVec3, [i32; 3])> = (0..positions.len()).map(brought_back).collect();
        if let Some(grain) = places.iter().position(|(_, crossings)| !can_be_counted(crossings)) {
            return Err(ChangeError::Fault(Fault::CrossedTooOften {
                step: self.step,
                id: self.grains.id[grain],
                position: positions[grain],
                most: MOST_CROSSINGS,
            }));
        }
        self.change(|sim| {
            for (grain, (place, crossings)) in places.into_iter().enumerate() {
                let is_counted = sim.grains.load.rows_mut()[grain].set_crossings(crossings);
                debug_assert!(is_counted, "looked at before");
                sim.grains.position[grain] = place;
            }
            if sim.is_started() {
                sim.find_forces_anew()?;
            }
            Ok(())
        })
    }

    /// Lets other laws act from now on, which remember what those before did and displace surfaces as they did; no other reaches farther, as
    /// [`Simulation::expect`] was told. The change of energy is booked as custom work.
    pub(crate) fn follow_other_laws(&mut self, materials: Materials) -> Result<(), Fault> {
        if self.materials == materials {
            return Ok(());
        }
        let before = self.present_energy();
        self.resists_rolling = laws::resists_rolling(&materials);
        let was = mem::replace(&mut self.materials, materials);
        self.find_forces_of_other_laws(&was)?;
        self.book_change_since(before);
        Ok(())
    }

    /// Has contacts looked for as far as such laws reach, too.
    pub(crate) fn reach_as_far_as<'m>(&mut self, laws: impl Iterator<Item = &'m Materials>) {
        let walls: Vec<WallPartner> = self.walls.iter().map(WallPartner::of).collect();
        let reaches = laws.map(|laws| largest_reach(&self.grains, &walls, laws));
        self.max_reach = reaches.fold(self.max_reach, f64::max);
    }

    /// Lets the laws act that it has now in place of others, under which contacts began and candidates were found.
    pub(crate) fn find_forces_of_other_laws(&mut self, was: &Materials) -> Result<(), Fault> {
        self.hear_corrected_places();
        self.grains.higher.fill(HigherDerivatives::default());
        self.near.look_anew();
        if self.is_started() {
            self.let_contacts_adopt_laws(was);
            self.find_forces_anew()
        } else {
            Ok(())
        }
    }

    fn let_contacts_adopt_laws(&mut self, was: &Materials) {
        let mut contacts = mem::take(&mut self.contacts);
        let stride = contacts.stride;
        for (chunks, wall) in [(&mut contacts.pairs, false), (&mut contacts.walls, true)] {
            for chunk in chunks {
                let [law, former] = [&self.materials, was].map(|laws| laws.law(chunk.law()));
                let is_other = law.normal != former.normal;
                for k in (0..chunk.len()).filter(|_| is_other) {
                    let size = self.pair_size(chunk.i[k] as usize, (!wall).then(|| chunk.j[k] as usize));
                    laws::adopt(law, size, chunk.history_mut(k, stride));
                }
            }
        }
        self.contacts = contacts;
    }

    /// Books what the energy became by other laws, another gravity or other walls, as work from outside; `before`: what it was [J].
    pub(crate) fn book_change_since(&mut self, before: f64) {
        if self.is_started() {
            let after = self.present_energy();
            self.books.intervene(after - before);
        }
    }

    /// Lets another gravity act on all grains [m/s^2]; walls that move freely keep their weight. The change of energy is booked as work of
    /// custom forces.
    pub fn set_gravity(&mut self, gravity: DVec3) -> Result<(), ChangeError> {
        let refused = |allowed| ChangeError::Gravity {
            value: gravity,
            allowed,
        };
        if !gravity.is_finite() {
            return Err(refused("finite"));
        }
        if self.deforms() && gravity != DVec3::ZERO {
            return Err(refused("0, as the periodic box deforms"));
        }
        let before = self.mechanical_energies().gravitational;
        let change = gravity - self.gravity;
        let acts_otherwise = self.is_started() && change != DVec3::ZERO;
        if acts_otherwise {
            // half a step is still to come of the forces that were found last
            let own = self.own_grains();
            for load in &mut self.grains.load.rows_mut()[own] {
                load.put(load.force() + change * load.mass(), load.torque());
            }
            self.grains.higher.fill(HigherDerivatives::default());
        }
        self.gravity = gravity;
        if acts_otherwise {
            let after = self.mechanical_energies().gravitational;
            self.books.turn_gravity(after - before);
        }
        Ok(())
    }

    fn find_forces_anew(&mut self) -> Result<(), Fault> {
        let dt = self.dt;
        self.dt = SHORT_STEP * dt;
        // once to let springs give way at once that bear more than they may now, and once for the power of what then acts
        let found = self.find_first_forces().and_then(|()| self.find_first_forces());
        self.books.go_on_with(self.step_tally(), 1.0 / SHORT_STEP);
        self.dt = dt;
        found
    }

    fn check_change(&self, what: &'static str, values: &[DVec3]) -> Result<(), ChangeError> {
        let grains = self.grains.len();
        if values.len() != grains {
            let found = values.len();
            return Err(ChangeError::Length { found, grains });
        }
        match values.iter().zip(&self.grains.id).find(|(value, _)| !value.is_finite()) {
            None => Ok(()),
            Some((&value, &id)) => Err(ChangeError::NotFinite { what, id, value }),
        }
    }

    /// Changes grains and books what that did.
    fn change(&mut self, work: impl FnOnce(&mut Self) -> Result<(), Fault>) -> Result<(), ChangeError> {
        let before = self.present_energy();
        let done = work(self);
        // what was remembered of the motion belongs to the one before
        self.grains.higher.fill(HigherDerivatives::default());
        self.near.look_anew();
        self.book_custom(0.0);
        self.book_change_since(before);
        Ok(done?)
    }
}
