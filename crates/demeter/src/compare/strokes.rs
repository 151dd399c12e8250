//! Averaged strokes, of a run or measured, and what they are at any position.

use super::cycles::{Level, Phase, Position, place};
use super::forces::Bins;

/// Loading and unloading of a packing, averaged over cycles.
#[derive(Clone, Debug, PartialEq)]
pub struct Strokes {
    /// Folder of the run, or name of the file.
    pub name: String,
    /// What the levels are told by.
    pub position: Position,
    /// Levels of loading, ascending by position.
    pub loading: Vec<Level>,
    /// Levels of unloading, ascending by position.
    pub unloading: Vec<Level>,
    /// Bins of the force distributions, where there are any.
    pub bins: Option<Bins>,
    /// Titles of the columns that were averaged beside the force.
    pub also: Vec<String>,
    /// Number of cycles that were kept and discarded; none of a measured curve.
    pub cycles: Option<(usize, usize)>,
}

impl Strokes {
    /// Levels of a phase.
    pub fn levels(&self, phase: Phase) -> &[Level] {
        match phase {
            Phase::Loading => &self.loading,
            Phase::Unloading => &self.unloading,
        }
    }

    /// The level of largest compression among those of a phase for which something holds.
    pub(super) fn top(&self, phase: Phase, of: impl Fn(&Level) -> bool) -> Option<&Level> {
        let mut levels = self.levels(phase).iter().filter(|level| of(level));
        // the time of unloading starts at the top
        if self.position == Position::StageTime && phase == Phase::Unloading {
            levels.next()
        } else {
            levels.next_back()
        }
    }

    /// What the strokes are at a position between levels, linearly; nothing outside of the stroke.
    pub fn at(&self, phase: Phase, position: f64) -> Option<Level> {
        let levels = self.levels(phase);
        let (lower, upper, weight) = place(|k| levels[k].position, levels.len(), position)?;
        let (a, b) = (&levels[lower], &levels[upper]);
        let mix = |x: f64, y: f64| (1.0 - weight) * x + weight * y;
        Some(Level {
            position,
            force: a.force.zip(b.force).map(|(a, b)| a.between(&b, weight)),
            coordination: a.coordination.zip(b.coordination).map(|(a, b)| mix(a, b)),
            contacts: (a.contacts.as_ref().zip(b.contacts.as_ref())).map(|(a, b)| a.between(b, weight)),
            also: a.also.iter().zip(&b.also).map(|(a, b)| a.between(b, weight)).collect(),
        })
    }
}
