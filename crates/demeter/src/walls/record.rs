//! What is recorded on every element of a wall: loads between two frames, and wear since the start.
//!
//! An element is a triangle of a mesh, a face of a box, or the whole of any other shape. In a step of `dt`, with the normal
//! force `N` and the tangential force `T` of a contact:
//!
//! * loads: `F dt`, `N dt` and `T dt` are summed; over the time since the last frame and the area they are the mean force, the
//!   *pressure*, and the *shear stress* (the magnitude of the mean of `T` over the area, in the frame of the wall: what changes its
//!   direction cancels)
//! * *impact energy* `E`: what the normal law lost, in dashpots and by plastic work or tear-off
//! * *sliding energy* `W`: what friction lost, with what its spring still held when the contact ended
//! * *slid load* `sum N ds`: the normal force times the way slid, `ds = dW/|T|`, while `|T|` is all that friction bears: what a contact
//!   loses that sticks, in the dashpot beside its spring, is no sliding
//! * worn volume `k_s sum N ds + k_i E`, and over the area of the element the *depth of wear*
//!
//! The first term is J. F. Archard, Journal of Applied Physics 24 (1953) 981, eq. 7: the volume worn is `K N s/H` with the wear
//! coefficient `K` and the hardness `H` of the softer body, so `k_s = K/H`. The second is the deformation wear of J. G. A. Bitter,
//! Wear 6 (1963) 5, eq. 9: the energy lost in impacts over the energy that removes a unit of volume, `k_i = 1/epsilon`. Rolling
//! resistance is not counted. The geometry does not wear off: depths must stay small against the grains.

use glam::DVec3;
use serde::{Deserialize, Serialize};

/// What is to be recorded.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Recording {
    /// Whether loads are shown in frames.
    pub stress: bool,
    /// Whether wear is shown in frames and in the series.
    pub wear: Option<WearCoefficients>,
}

impl Recording {
    /// Whether anything is recorded.
    pub fn is_on(&self) -> bool {
        self.stress || self.wear.is_some()
    }
}

/// Volume worn per energy [m^3/J].
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct WearCoefficients {
    /// Per normal force and way slid: Archard's `K/H`.
    pub sliding: f64,
    /// Per energy lost in impacts.
    pub impact: f64,
}

/// What one contact did to an element in a step.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Mark {
    /// Index of the wall.
    pub(crate) wall: u32,
    pub(crate) element: u32,
    /// Normal force, positive where the grain presses [N].
    pub(crate) normal_force: f64,
    /// Unit vector from the wall to the grain.
    pub(crate) normal: DVec3,
    /// Tangential force on the wall [N].
    pub(crate) tangential: DVec3,
    /// Lost by the normal law and by friction [J].
    pub(crate) impact: f64,
    pub(crate) sliding: f64,
    /// What bears the friction times the way slid, while the contact slides as a whole [N m].
    pub(crate) slid_load: f64,
}

/// Sums on one element.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
struct Sums {
    /// Force on the element times time since the last frame [N s].
    impulse: DVec3,
    pressing: f64,
    /// In the frame of the wall, so that what drags at a turning liner from the same side adds up.
    shearing: DVec3,
    /// Energies since the start [J].
    impact: f64,
    sliding: f64,
    /// Normal force times way slid since the start [N m].
    slid_load: f64,
}

/// What was recorded on a wall.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Record {
    pub(super) recording: Recording,
    /// Time since the last frame [s].
    time: f64,
    elements: Vec<Sums>,
}

/// What was recorded on an element, as it is written.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ElementRecord {
    /// Mean force of the grains since the last frame [N].
    pub force: DVec3,
    /// Mean normal force over the area, compression positive [Pa]; 0 on infinite planes.
    pub pressure: f64,
    /// Magnitude of the mean tangential force over the area [Pa]; 0 on infinite planes.
    pub shear_stress: f64,
    /// Lost in impacts since the start [J].
    pub impact_energy: f64,
    /// Lost by friction since the start [J].
    pub sliding_energy: f64,
    /// Volume worn since the start [m^3].
    pub worn_volume: f64,
    /// Worn volume over the area [m]; 0 on infinite planes.
    pub wear_depth: f64,
}

impl ElementRecord {
    /// What of it lies on a share of the area.
    pub(crate) fn shared(&self, share: f64) -> Self {
        ElementRecord {
            force: self.force * share,
            impact_energy: self.impact_energy * share,
            sliding_energy: self.sliding_energy * share,
            worn_volume: self.worn_volume * share,
            ..*self
        }
    }
}

impl Record {
    pub(super) fn new(recording: Recording, elements: usize) -> Self {
        Self {
            recording,
            time: 0.0,
            elements: vec![Sums::default(); elements],
        }
    }

    /// Takes over what was recorded before; tells whether it was on as many elements.
    pub(super) fn go_on_from(&mut self, saved: &Self) -> bool {
        let fits = self.len() == saved.len();
        if fits {
            self.time = saved.time;
            self.elements.clone_from(&saved.elements);
        }
        fits
    }

    pub(super) fn len(&self) -> usize {
        self.elements.len()
    }

    /// Adds what a contact did in a step of `dt` [s]; `turn` turns a direction of the world into the wall frame.
    pub(super) fn add(&mut self, mark: &Mark, dt: f64, turn: impl Fn(DVec3) -> DVec3) {
        let Some(sums) = self.elements.get_mut(mark.element as usize) else {
            return;
        };
        sums.impulse += (mark.tangential - mark.normal * mark.normal_force) * dt;
        sums.pressing += mark.normal_force * dt;
        sums.shearing += turn(mark.tangential) * dt;
        sums.impact += mark.impact;
        sums.sliding += mark.sliding;
        sums.slid_load += mark.slid_load;
    }

    pub(super) fn pass(&mut self, dt: f64) {
        self.time += dt;
    }

    /// Begins to average loads anew.
    pub(super) fn begin_interval(&mut self) {
        self.time = 0.0;
        for sums in &mut self.elements {
            *sums = Sums {
                impact: sums.impact,
                sliding: sums.sliding,
                slid_load: sums.slid_load,
                ..Sums::default()
            };
        }
    }

    /// What was recorded on an element of an area [m^2].
    pub(super) fn of(&self, element: usize, area: f64) -> ElementRecord {
        let Some(sums) = self.elements.get(element) else {
            return ElementRecord::default();
        };
        let share = if self.time > 0.0 { 1.0 / self.time } else { 0.0 };
        let wear = self.recording.wear.unwrap_or_default();
        let worn_volume = wear.sliding * sums.slid_load + wear.impact * sums.impact;
        ElementRecord {
            force: sums.impulse * share,
            pressure: sums.pressing * share / area,
            shear_stress: sums.shearing.length() * share / area,
            impact_energy: sums.impact,
            sliding_energy: sums.sliding,
            worn_volume,
            wear_depth: worn_volume / area,
        }
    }

    /// Energies lost in impacts and by friction [J] and volume worn [m^3] on all elements.
    pub(super) fn totals(&self) -> [f64; 3] {
        let mut totals = [0.0; 3];
        for element in 0..self.len() {
            let of = self.of(element, f64::INFINITY);
            for (total, part) in totals
                .iter_mut()
                .zip([of.impact_energy, of.sliding_energy, of.worn_volume])
            {
                *total += part;
            }
        }
        totals
    }
}
