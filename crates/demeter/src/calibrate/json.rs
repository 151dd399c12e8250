//! What the tools found, as JSON: what `--json` prints and what Python hands out.

use super::CollideReport;
use super::fit::{FitReport, written};
use super::packing::{Answer, Outcome, PackingReport};
use crate::scenario::{Match, PackingFile};
use demeter_physics::collision::Start;
use glam::DVec3;
use serde_json::{Value, json};

impl CollideReport {
    /// The entries of the ledger, those of the start first.
    pub fn energies(&self) -> [(&'static str, f64); 12] {
        let (before, after) = (&self.before, &self.after);
        [
            ("kinetic_before", before.kinetic),
            ("rotational_before", before.rotational),
            ("elastic_before", before.elastic),
            ("kinetic", after.kinetic),
            ("rotational", after.rotational),
            ("elastic", after.elastic),
            ("tangential", after.tangential),
            ("rolling", after.rolling),
            ("viscous_dissipated", after.viscous_dissipated),
            ("plastic_dissipated", after.plastic_dissipated),
            ("friction_dissipated", after.friction_dissipated),
            ("rolling_dissipated", after.rolling_dissipated),
        ]
    }

    /// All of it but the course.
    pub fn to_json(&self) -> Value {
        let mut energy: serde_json::Map<String, Value> = self
            .energies()
            .into_iter()
            .map(|(name, value)| (name.to_string(), json!(value)))
            .collect();
        energy.insert("residual".to_string(), json!(self.after.residual));
        let of = |values: &[DVec3; 2]| json!({ "a": values[0].to_array(), "b": values[1].to_array() });
        json!({
            "restitution": self.restitution,
            "contact_time": self.contact_time,
            "reach": self.reach,
            "max_overlap": self.max_overlap,
            "max_force": self.max_force,
            "outcome": self.outcome.name(),
            "energy": energy,
            "tangential_restitution": self.tangential_restitution,
            "angle_out": self.angle_out,
            "velocity": of(&self.velocity),
            "spin": of(&self.spin),
            "estimated_error": self.estimated_error,
            "time_step": self.time_step,
            "steps": self.steps,
            "method": self.method,
        })
    }
}

impl FitReport {
    /// All of it.
    pub fn to_json(&self) -> Value {
        let parameters = self.parameters.iter().map(|p| {
            json!({
                "name": p.name, "value": p.value, "unit": p.dimension.unit(), "written": written(p.value, p.dimension),
                "identified": p.identified, "relative_error": p.error, "at_bound": p.at_bound,
            })
        });
        let residuals = self.residuals.iter().map(|r| {
            json!({
                "observation": r.observation, "quantity": r.observable.name(), "measured": r.measured,
                "found": r.found, "deviation": r.deviation,
            })
        });
        let fixed = self.fixed.iter().map(|c| {
            let powers: serde_json::Map<String, Value> = c.powers.iter().map(|(n, p)| (n.clone(), json!(p))).collect();
            json!({ "powers": powers, "value": c.value })
        });
        let advice = self
            .advice
            .iter()
            .map(|a| json!({ "measure": a.observable.name(), "velocity": a.velocity, "sensitivity": a.sensitivity }));
        json!({
            "method": self.method,
            "parameters": parameters.collect::<Vec<Value>>(),
            "residuals": residuals.collect::<Vec<Value>>(),
            "not_identified": self.not_identified().collect::<Vec<_>>(),
            "fixed": fixed.collect::<Vec<Value>>(),
            "advice": advice.collect::<Vec<Value>>(),
            "ambiguous": self.ambiguous,
            "fits": self.fits(),
            "chi_square": self.chi_square(),
            "degrees_of_freedom": self.degrees_of_freedom(),
            "singular_values": self.singular_values,
            "contact": self.contact,
            "material": self.material,
            "start": self.start.map(Start::name),
        })
    }
}

impl PackingReport {
    /// All of it; `file` is that of the fit.
    pub fn to_json(&self, file: &PackingFile) -> Value {
        let unknown = &file.unknown;
        let trials = self.trials.iter().map(|trial| {
            let comparison = trial.comparison();
            let rtop = comparison.and_then(|c| c.rtop.as_ref().ok());
            let beyond = match &trial.outcome {
                Outcome::BeyondFold(fault) => Some(fault),
                Outcome::Compared(_) => None,
            };
            json!({
                "value": trial.value, "folder": trial.folder.display().to_string(), "reused": trial.reused,
                "rtop": rtop.map(|r| r.value), "rtop_deviation": rtop.and_then(|r| r.deviation),
                "errf": comparison.and_then(|c| c.errf.as_ref().ok()).map(|m| m.value),
                "beyond_fold": beyond,
            })
        });
        let (found, at_end, bracket, scatter) = match self.answer {
            Answer::Inside { bracket, scatter } => (true, None, Some([bracket.0, bracket.1]), scatter),
            Answer::LowerEnd => (false, Some("lower"), None, None),
            Answer::UpperEnd => (false, Some("upper"), None, None),
            Answer::Nowhere => (false, None, None, None),
        };
        json!({
            "key": unknown.key,
            "unit": unknown.dimension.unit(),
            "match": match file.matched { Match::Top => "top", Match::Curve => "curve" },
            "found": found,
            "value": self.best().filter(|_| found).map(|(trial, _)| trial.value),
            "written": self.best().filter(|_| found).map(|(trial, _)| unknown.written(trial.value)),
            "bracket": bracket,
            "scatter": scatter,
            "at_end": at_end,
            "best": self.best,
            "trials": trials.collect::<Vec<Value>>(),
        })
    }
}
