//! Which model is best, by every metric, here and in the paper.

use super::results::{ModelResult, known};
use super::{Model, Published, Results};

/// A metric of Table I.
#[derive(Clone, Copy, Debug)]
pub struct MetricInfo {
    /// Its name.
    pub name: &'static str,
    /// How far from perfect the published value is.
    published: fn(&Published) -> f64,
    /// How far from perfect ours is; nothing where it cannot be told.
    ours: fn(&ModelResult) -> Option<f64>,
    /// Whether ours needs a stand-in for the measured curves.
    pub needs_curve: bool,
}

/// The metrics of Table I, in its order.
pub const METRICS: [MetricInfo; 4] = [
    MetricInfo {
        name: "Rtop",
        published: |p| (1.0 - p.rtop).abs(),
        ours: |m| Some((1.0 - m.rtop.value).abs()),
        needs_curve: false,
    },
    MetricInfo {
        name: "errf",
        published: |p| p.errf,
        ours: |m| known(&m.stand_in.errf).map(|e| e.value),
        needs_curve: true,
    },
    MetricInfo {
        name: "errZ",
        published: |p| p.errz,
        ours: |m| known(&m.stand_in.errz).map(|e| e.misfit.value),
        needs_curve: true,
    },
    MetricInfo {
        name: "bhat",
        published: |p| p.bhat,
        ours: |m| known(&m.stand_in.bhat).map(|e| e.value),
        needs_curve: true,
    },
];

/// Models from the best to the worst by a metric: ours, and those of the paper. Models of which ours cannot be told are left
/// out of both.
pub fn ranks(results: &Results, metric: &MetricInfo) -> (Vec<Model>, Vec<Model>) {
    let told: Vec<(Model, f64)> = (results.models.iter())
        .filter_map(|result| Some((result.model, (metric.ours)(result)?)))
        .collect();
    let published = told
        .iter()
        .map(|(model, _)| (*model, (metric.published)(&model.published)));
    let sorted = |mut all: Vec<(Model, f64)>| -> Vec<Model> {
        all.sort_by(|a, b| a.1.total_cmp(&b.1));
        all.into_iter().map(|(model, _)| model).collect()
    };
    (sorted(told.clone()), sorted(published.collect()))
}
