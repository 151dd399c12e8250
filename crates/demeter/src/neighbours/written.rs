//! Tables of candidates as they are written, where one process has them all and where several share them.

use super::packed::PackedPair;
use super::table::{Segment, Table};
use super::{Neighbours, SearchEffort, WallPair, former};
use crate::comm::parts::{InParts, Listed, Part};
use crate::walls::Pose;
use serde::{Serialize, Serializer};

/// What is saved of [`Neighbours`].
#[derive(Serialize)]
#[serde(rename = "Neighbours")]
struct Written<'a, 'b> {
    pairs: WrittenPairs<'a, 'b>,
    walls: WrittenTable<'a, 'b, WallPair>,
    effort: SearchEffort,
    total: usize,
    former: former::Written<'a, 'b>,
    wall_reference: &'b [Pose],
}

/// What is saved of a [`PairTable`](super::pairs::PairTable).
#[derive(Serialize)]
#[serde(rename = "PairTable")]
struct WrittenPairs<'a, 'b> {
    table: WrittenTable<'a, 'b, PackedPair>,
    per_segment: usize,
}

/// What is saved of a [`Table`].
#[derive(Serialize)]
#[serde(rename = "Table", bound = "Listed<'a, 'b, Segment<C>>: Serialize")]
struct WrittenTable<'a, 'b, C> {
    segments: Listed<'a, 'b, Segment<C>>,
}

fn table<'a, 'b, C>(of: &'b Table<C>, part: &Part<'a>) -> WrittenTable<'a, 'b, C> {
    let segments = part.of_segments(&of.segments);
    WrittenTable { segments }
}

impl InParts for Neighbours {
    fn in_parts<'a>(&'a self, part: &'a Part<'_>) -> impl Serialize + 'a {
        Written {
            pairs: WrittenPairs {
                table: table(&self.pairs.table, part),
                per_segment: self.pairs.per_segment,
            },
            walls: table(&self.walls, part),
            effort: self.effort,
            total: self.total,
            former: self.former.written(part),
            wall_reference: &self.wall_reference,
        }
    }
}

impl Serialize for Neighbours {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.in_parts(&Part::WHOLE).serialize(serializer)
    }
}
