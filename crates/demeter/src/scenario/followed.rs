//! Measures that remember: what they saw between two rows goes into the checkpoint.

use super::Scenario;
use super::measures::MeasureKind;
use crate::contacts::Impact;
use crate::measure::{
    CollisionState, Collisions, Counted, Displacement, DisplacementState, Field, FieldSums, FieldValues, FlowState,
    LOOK_EVERY, MassFlow, Residence, ResidenceState, Value, hear_impacts,
};
use crate::particles::Origins;
use crate::simulation::{Simulation, ends_at};
use serde::{Deserialize, Serialize};

/// What the measures of a scenario remember, each kind in the order of the scenario.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(super) struct FollowedState {
    flows: Vec<FlowState>,
    residences: Vec<ResidenceState>,
    displacements: Vec<DisplacementState>,
    fields: Vec<FieldSums>,
    collisions: Vec<CollisionState>,
    /// Contacts that began since the latest look.
    impacts: Vec<Impact>,
}

/// Measures that remember, and what.
pub(super) struct Followed<'a> {
    flows: Vec<&'a MassFlow>,
    residences: Vec<&'a Residence>,
    displacements: Vec<&'a Displacement>,
    fields: Vec<&'a Field>,
    collisions: Vec<&'a Collisions>,
    state: FollowedState,
}

fn picked<'a, T>(scenario: &'a Scenario, pick: impl Fn(&'a MeasureKind) -> Option<&'a T>) -> Vec<&'a T> {
    scenario.measures.iter().filter_map(|m| pick(&m.kind)).collect()
}

/// Whether a field is sampled after this step.
fn samples(field: &Field, sim: &Simulation) -> bool {
    field
        .sample_every
        .is_some_and(|seconds| sim.step == 0 || ends_at(seconds, sim.dt, sim.step))
}

impl<'a> Followed<'a> {
    /// At the start of a run.
    pub fn begin(scenario: &'a Scenario) -> Self {
        let mut followed = Self::of(scenario);
        followed.state = FollowedState {
            flows: vec![FlowState::default(); followed.flows.len()],
            residences: vec![ResidenceState::default(); followed.residences.len()],
            displacements: vec![DisplacementState::default(); followed.displacements.len()],
            fields: vec![FieldSums::default(); followed.fields.len()],
            collisions: vec![CollisionState::default(); followed.collisions.len()],
            impacts: Vec::new(),
        };
        followed
    }

    /// Goes on from a state; nothing when it belongs to other measures.
    pub fn resume(scenario: &'a Scenario, state: FollowedState) -> Option<Self> {
        let mut followed = Self::of(scenario);
        let fits = state.flows.len() == followed.flows.len()
            && state.residences.len() == followed.residences.len()
            && state.displacements.len() == followed.displacements.len()
            && state.fields.len() == followed.fields.len()
            && state.collisions.len() == followed.collisions.len()
            && followed
                .residences
                .iter()
                .zip(&state.residences)
                .all(|(m, s)| m.fits(s))
            && followed.fields.iter().zip(&state.fields).all(|(m, s)| m.fits(s))
            && (followed.collisions.iter().zip(&state.collisions)).all(|(m, s)| m.fits(s));
        followed.state = state;
        fits.then_some(followed)
    }

    fn of(scenario: &'a Scenario) -> Self {
        Self {
            flows: picked(scenario, |kind| match kind {
                MeasureKind::MassFlow(flow) => Some(flow),
                _ => None,
            }),
            residences: picked(scenario, |kind| match kind {
                MeasureKind::Residence(residence) => Some(residence),
                _ => None,
            }),
            displacements: picked(scenario, |kind| match kind {
                MeasureKind::Displacement(displacement) => Some(displacement),
                _ => None,
            }),
            fields: picked(scenario, |kind| match kind {
                MeasureKind::Field(field) => Some(field),
                _ => None,
            }),
            collisions: picked(scenario, |kind| match kind {
                MeasureKind::Collisions(collisions) => Some(collisions),
                _ => None,
            }),
            state: FollowedState::default(),
        }
    }

    /// What a checkpoint holds.
    pub fn state(&self) -> &FollowedState {
        &self.state
    }

    /// Whether anything is looked at after this step.
    pub fn is_due(&self, sim: &Simulation) -> bool {
        (self.looks_at_grains() || self.hears_impacts()) && sim.step.is_multiple_of(LOOK_EVERY)
            || self.needs_contacts(sim)
    }

    /// Whether contacts that begin are asked for.
    pub fn hears_impacts(&self) -> bool {
        !self.collisions.is_empty()
    }

    /// Keeps which contacts began so far, for the next look. Each process calls this.
    pub fn hear_impacts(&mut self, sim: &mut Simulation) {
        if self.hears_impacts() {
            hear_impacts(sim, &mut self.state.impacts);
        }
    }

    /// Goes on with what was remembered before.
    pub fn remember(&mut self, state: FollowedState) {
        self.state = state;
    }

    /// Whether any measure follows grains.
    pub fn looks_at_grains(&self) -> bool {
        !(self.flows.is_empty() && self.residences.is_empty() && self.displacements.is_empty())
    }

    /// Whether contacts are looked at after this step, and not grains alone.
    pub fn needs_contacts(&self, sim: &Simulation) -> bool {
        self.fields.iter().any(|field| samples(field, sim))
    }

    /// Looks after every step at what is due.
    pub fn watch(&mut self, sim: &mut Simulation, origins: &Origins) {
        if sim.step.is_multiple_of(LOOK_EVERY) {
            self.look(sim, origins);
        }
        for (field, state) in self.fields.iter().zip(&mut self.state.fields) {
            if samples(field, sim) {
                field.sample(sim, origins, state);
            }
        }
    }

    /// Looks where grains are, and which contacts began.
    pub fn look(&mut self, sim: &mut Simulation, origins: &Origins) {
        self.hear_impacts(sim);
        let sim = &*sim;
        let impacts = std::mem::take(&mut self.state.impacts);
        for (collisions, state) in self.collisions.iter().zip(&mut self.state.collisions) {
            collisions.count(&impacts, sim, origins, state);
        }
        for (flow, state) in self.flows.iter().zip(&mut self.state.flows) {
            flow.look(sim, origins, state);
        }
        for (residence, state) in self.residences.iter().zip(&mut self.state.residences) {
            residence.look(sim, origins, state);
        }
        for (displacement, state) in self.displacements.iter().zip(&mut self.state.displacements) {
            displacement.look(sim, state);
        }
    }

    /// Values of the measures that remember, in the order of their kinds, one after the other, after a look.
    pub fn values(&mut self, sim: &Simulation, origins: &Origins) -> FollowedValues {
        let flows = self.flows.iter().zip(&mut self.state.flows);
        let residences = self.residences.iter().zip(&self.state.residences);
        let displacements = self.displacements.iter().zip(&self.state.displacements);
        let collisions = self.collisions.iter().zip(&self.state.collisions);
        FollowedValues {
            flows: flows.map(|(m, s)| m.measure(sim, s)).collect::<Vec<_>>().into_iter(),
            residences: residences
                .map(|(m, s)| m.measure(sim, s))
                .collect::<Vec<_>>()
                .into_iter(),
            displacements: (displacements.map(|(m, s)| m.measure(sim, origins, s)))
                .collect::<Vec<_>>()
                .into_iter(),
            collisions: (collisions.map(|(m, s)| m.measure(s))).collect::<Vec<_>>().into_iter(),
        }
    }

    /// Collisions between grains and with walls by bins of energy; `index` counts the measures of collisions.
    pub fn collision_distribution(&self, index: usize) -> [Counted; 2] {
        match (self.collisions.get(index), self.state.collisions.get(index)) {
            (Some(collisions), Some(state)) => collisions.distribution(state),
            _ => Default::default(),
        }
    }

    /// Mass that left a region by bins of residence time; `index` counts the measures of residence.
    pub fn residence_distribution(&self, index: usize) -> Vec<f64> {
        match (self.residences.get(index), self.state.residences.get(index)) {
            (Some(residence), Some(state)) => residence.distribution(state),
            _ => Vec::new(),
        }
    }

    /// The fields of a measure, `index` counts those; their sums begin anew.
    pub fn take_field(&mut self, index: usize, sim: &Simulation, origins: &Origins) -> Option<FieldValues> {
        let (field, state) = (self.fields.get(index)?, self.state.fields.get_mut(index)?);
        Some(field.take(sim, origins, state))
    }
}

/// Values of a row, by kind.
pub(super) struct FollowedValues {
    pub flows: std::vec::IntoIter<Vec<Value>>,
    pub residences: std::vec::IntoIter<Vec<Value>>,
    pub displacements: std::vec::IntoIter<Vec<Value>>,
    pub collisions: std::vec::IntoIter<Vec<Value>>,
}
