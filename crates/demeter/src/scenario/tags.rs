//! Tables `[[tag]]`: tags that grains are given while the run goes on.

use super::quantity::Kind;
use super::reader::TableReader;
use super::zones::{Named, region, selection, tag_value};
use crate::measure::{Selection, holds};
use crate::particles::{Origins, Zone};
use crate::simulation::{Simulation, ends_at};
use demeter_physics::dimension::Dimension;
use demeter_physics::parameters::Range;

/// Most tables.
pub const MAX_TAGS: usize = 1000;

/// A table `[[tag]]`.
#[derive(Clone, Debug, PartialEq)]
pub struct TagSpec {
    /// The tag.
    pub value: i32,
    /// When grains get it first [s].
    pub at: f64,
    /// Time after which they are looked at again [s]; absent: once.
    pub every: Option<f64>,
    /// Where they must be.
    pub zone: Zone,
    /// Which of them.
    pub selection: Selection,
}

const TIME: Kind = Kind::Physical(Dimension::TIME);

pub(super) fn tags(root: &TableReader<'_>, named: &Named<'_>) -> Vec<TagSpec> {
    let Some(item) = root.optional("tag") else {
        return Vec::new();
    };
    let tables = item.tables("tag");
    if tables.len() > MAX_TAGS {
        let message = format!("{} tables [[tag]] are too many; at most {MAX_TAGS}", tables.len());
        item.fault(message, None);
    }
    let read = |table: TableReader<'_>| {
        let value = table.required("value", "the tag, a whole number as 1");
        let tag = TagSpec {
            value: value.map_or(0, |i| tag_value(&i)),
            at: table.optional_quantity("at", TIME, Range::NOT_NEGATIVE).unwrap_or(0.0),
            every: table.optional_quantity("every", TIME, Range::POSITIVE),
            zone: table.optional("region").map(|i| region(&i, named)).unwrap_or_default(),
            selection: selection(&table, named),
        };
        table.finish("a tag");
        tag
    };
    tables.into_iter().take(MAX_TAGS).map(read).collect()
}

impl TagSpec {
    /// Whether the first time at which grains get the tag is over.
    pub(super) fn is_over(&self, sim: &Simulation) -> bool {
        self.first_step(sim) < sim.step
    }

    fn first_step(&self, sim: &Simulation) -> u64 {
        (self.at / sim.dt).round() as u64
    }

    /// Whether grains get the tag between the latest step and the next.
    pub(super) fn is_due(&self, sim: &Simulation) -> bool {
        let Some(since) = sim.step.checked_sub(self.first_step(sim)) else {
            return false;
        };
        match self.every {
            None => since == 0,
            Some(seconds) => since == 0 || ends_at(seconds, sim.dt, since),
        }
    }

    /// Gives the tag when it is due. Each process tells which of its own grains get it and had another.
    pub(super) fn apply(&self, sim: &Simulation, origins: &mut Origins) {
        if !self.is_due(sim) {
            return;
        }
        let gets_it = |g: &usize| holds(sim, &self.zone, *g) && self.selection.holds(&sim.grains, origins, *g);
        let ids = sim.own_grains().filter(gets_it).map(|g| sim.grains.id[g]);
        let others = ids.filter(|id| origins.tag(*id) != self.value).collect();
        for id in sim.of_all_segments::<u32>(others) {
            origins.set_tag(id, self.value);
        }
    }
}
