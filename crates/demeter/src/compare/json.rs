//! Comparisons as JSON: what `--json` prints and what Python hands out.

use super::metrics::{Comparison, ContactMisfit, LeftOut};
use super::strokes::Strokes;
use serde_json::{Map, Value, json};

impl Comparison {
    /// The metrics that cannot be told.
    pub fn left_out(&self) -> Vec<(&'static str, LeftOut)> {
        let mut all = Vec::new();
        let mut add = |name, reason: Option<&LeftOut>| all.extend(reason.map(|r| (name, r.clone())));
        add("Rtop", self.rtop.as_ref().err());
        add("errf", self.errf.as_ref().err());
        add("errZ", self.errz.as_ref().err());
        if self.errz.is_ok() {
            let at = self.errz_at.as_ref();
            add("errZ at the threshold", at.and_then(|metric| metric.as_ref().err()));
        }
        add("bhat", self.bhat.as_ref().err());
        all
    }
}

/// Runs beside a reference, all of it but the forces.
pub fn comparisons_to_json(compared: &[(&Strokes, &Comparison)], reference: &Strokes) -> Value {
    let runs = compared.iter().map(|(strokes, comparison)| {
        let misfit =
            |m: &ContactMisfit| json!({ "value": m.misfit.value, "threshold": m.threshold, "levels": m.misfit.levels });
        let reasons: Map<String, Value> = comparison
            .left_out()
            .into_iter()
            .map(|(name, LeftOut(reason))| (name.to_string(), json!(reason)))
            .collect();
        json!({
            "run": strokes.name,
            "cycles": strokes.cycles.map(|c| c.0),
            "discarded": strokes.cycles.map(|c| c.1),
            "rtop": comparison.rtop.as_ref().ok().map(|r| json!({
                "value": r.value, "deviation": r.deviation, "cycles": r.cycles,
                "position": r.position, "reference_force": r.reference,
            })),
            "errf": comparison.errf.as_ref().ok().map(|m| json!({ "value": m.value, "levels": m.levels })),
            "errz": comparison.errz.as_ref().ok().map(misfit),
            "errz_at_threshold": comparison.errz_at.as_ref().and_then(|m| m.as_ref().ok()).map(misfit),
            "bhat": comparison.bhat.as_ref().ok().map(|m| json!({ "value": m.value, "levels": m.levels })),
            "left_out": reasons,
            "remarks": comparison.remarks,
        })
    });
    json!({
        "reference": reference.name,
        "position": reference.position.name(),
        "runs": runs.collect::<Vec<Value>>(),
    })
}
