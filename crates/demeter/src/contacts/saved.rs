//! Contacts as a checkpoint holds them: chunk by chunk in the order of the candidates, which tell the bodies and the law.

use super::coupling::Coupled;
use super::told::Told;
use super::{ContactChunk, Contacts, WORD};
use crate::comm::together::Together;
use crate::neighbours::Neighbours;
use demeter_physics::geometry::contact_sphere_sphere::Contact;
use serde::ser::{SerializeSeq, SerializeTuple};
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::fmt::{Debug, Formatter};
use std::ops::Range;

/// Contacts of a chunk of candidates.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(crate) struct SavedChunk {
    /// Number of contacts of every candidate that has any, behind its number.
    of_candidates: Vec<(u16, u32)>,
    /// Element of the wall that is touched; empty between grains.
    element: Vec<u32>,
    geometry: Vec<Contact>,
    engaged: Vec<u64>,
    normal_force: Vec<f32>,
    tangential: Vec<[f32; 3]>,
    rolling: Vec<[f32; 3]>,
    history: Vec<f64>,
    coupling: Vec<Coupled>,
}

/// What contacts of a chunk are.
#[derive(Clone, Copy)]
struct Kind {
    are_walls: bool,
    are_coupled: bool,
    /// History values per contact.
    stride: usize,
}

impl SavedChunk {
    fn of(chunk: &ContactChunk) -> Self {
        let (now, count) = (&chunk.now, chunk.len());
        let of_candidates = now.of_candidates();
        Self {
            of_candidates: of_candidates
                .map(|(c, contacts)| (c as u16, contacts.len() as u32))
                .collect(),
            element: now.element.clone(),
            geometry: now.geometry.clone(),
            engaged: chunk.engaged.clone(),
            normal_force: now.normal_force.clone(),
            tangential: now.tangential.singles(count),
            rolling: if chunk.rolling.is_empty() {
                Vec::new()
            } else {
                chunk.rolling.singles(count)
            },
            history: now.history.clone(),
            coupling: now.coupling.clone(),
        }
    }

    /// The chunk, told the bodies of its candidates; nothing where the numbers contradict each other.
    fn restored(self, law: u32, bodies: &[(u32, u32)], of: Kind) -> Option<ContactChunk> {
        let count = self.normal_force.len();
        let mut chunk = ContactChunk::default();
        chunk.forget();
        chunk.law = law;
        let mut of_candidates = self.of_candidates.into_iter().peekable();
        for (slot, &(i, j)) in bodies.iter().enumerate() {
            if let Some((_, contacts)) = of_candidates.next_if(|(candidate, _)| usize::from(*candidate) == slot) {
                let (contacts, before) = (contacts as usize, chunk.len());
                if contacts == 0 || contacts > count - before || !of.are_walls && contacts > 1 {
                    return None;
                }
                chunk.i.resize(before + contacts, i);
                chunk.j.resize(before + contacts, j);
                chunk.now.normal_force.resize(before + contacts, 0.0);
            }
            chunk.end_candidate(slot, of.are_walls);
        }
        let where_any = |is_there: bool| if is_there { count } else { 0 };
        let fits = of_candidates.next().is_none()
            && chunk.len() == count
            && self.element.len() == where_any(of.are_walls)
            && self.coupling.len() == where_any(of.are_coupled)
            && (self.geometry.len() == count || self.geometry.is_empty() && !of.are_walls && !of.are_coupled)
            && self.tangential.len() == count
            && self.history.len() == count * of.stride
            && (self.rolling.is_empty() || self.rolling.len() == count)
            && (self.engaged.is_empty() || self.engaged.len() == count.div_ceil(WORD));
        if !fits {
            return None;
        }
        let now = &mut chunk.now;
        (now.element, now.geometry, now.normal_force) = (self.element, self.geometry, self.normal_force);
        (now.history, now.coupling) = (self.history, self.coupling);
        now.tangential = Told::of_singles(&self.tangential);
        (chunk.engaged, chunk.rolling) = (self.engaged, Told::of_singles(&self.rolling));
        Some(chunk)
    }
}

/// Contacts of a run, as a checkpoint holds them.
#[derive(Clone)]
pub(crate) enum SavedContacts<'a> {
    /// Those of a run, each chunk made as it is written.
    Present(PresentContacts<'a>),
    /// Those that were read, between grains and with walls.
    Read([Vec<SavedChunk>; 2]),
}

/// Contacts of a run.
#[derive(Clone)]
pub(crate) struct PresentContacts<'a> {
    /// The own chunks, between grains and with walls.
    own: [&'a [ContactChunk]; 2],
    /// Who has the others.
    together: Together<'a>,
    /// Number of all chunks of both kinds, and of all contacts.
    chunks: [usize; 2],
    count: usize,
}

impl<'a> SavedContacts<'a> {
    /// Those in some chunks, between grains and with walls; other processes have the others.
    pub(crate) fn of(contacts: &'a Contacts, [pairs, walls]: [Range<usize>; 2], together: Together<'a>) -> Self {
        let own = [&contacts.pairs[pairs], &contacts.walls[walls]];
        let count: usize = own.into_iter().flatten().map(ContactChunk::len).sum();
        let [pairs, walls, count] = together.counts([own[0].len(), own[1].len(), count].map(|count| count as u64));
        Self::Present(PresentContacts {
            own,
            together,
            chunks: [pairs as usize, walls as usize],
            count: count as usize,
        })
    }

    /// Number of contacts.
    pub(crate) fn len(&self) -> usize {
        match self {
            Self::Present(present) => present.count,
            Self::Read(chunks) => chunks.iter().flatten().map(|chunk| chunk.normal_force.len()).sum(),
        }
    }

    /// The chunks for candidates, as if a step had just ended with them: all that can be asked of a contact after a step can be asked
    /// now. Nothing where they do not fit the candidates.
    pub(crate) fn restored(
        self,
        neighbours: &Neighbours,
        stride: usize,
        are_coupled: bool,
    ) -> Option<[Vec<ContactChunk>; 2]> {
        let kind = |are_walls| Kind {
            are_walls,
            are_coupled,
            stride,
        };
        let [pairs, walls] = match self {
            Self::Read(chunks) => chunks,
            Self::Present(present) => present.own.map(|chunks| chunks.iter().map(SavedChunk::of).collect()),
        };
        if pairs.len() != neighbours.chunks() || walls.len() != neighbours.wall_chunks() {
            return None;
        }
        let mut bodies = Vec::new();
        let pairs = pairs.into_iter().enumerate().map(|(number, chunk)| {
            let (candidates, law) = neighbours.chunk(number);
            bodies.clear();
            bodies.extend(candidates.iter().map(|pair| (pair.i, pair.j)));
            chunk.restored(law, &bodies, kind(false))
        });
        let pairs = pairs.collect::<Option<_>>()?;
        let walls = walls.into_iter().enumerate().map(|(number, chunk)| {
            let (candidates, law) = neighbours.wall_chunk(number);
            bodies.clear();
            bodies.extend(candidates.iter().map(|pair| (pair.grain, pair.wall)));
            chunk.restored(law, &bodies, kind(true))
        });
        Some([pairs, walls.collect::<Option<_>>()?])
    }
}

impl Debug for SavedContacts<'_> {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> std::fmt::Result {
        let mut list = formatter.debug_list();
        match self {
            Self::Present(present) => list.entries(present.own.into_iter().flatten().map(SavedChunk::of)),
            Self::Read(chunks) => list.entries(chunks.iter().flatten()),
        };
        list.finish()
    }
}

/// Chunks that several processes have together.
struct Chunks<'a> {
    own: &'a [ContactChunk],
    together: Together<'a>,
    count: usize,
}

impl Serialize for Chunks<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut list = serializer.serialize_seq(Some(self.count))?;
        let mut all = self.together.joined(self.own.iter().map(SavedChunk::of));
        all.try_for_each(|chunk| list.serialize_element(&chunk))?;
        list.end()
    }
}

impl Serialize for SavedContacts<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Present(PresentContacts {
                own, together, chunks, ..
            }) => {
                let mut both = serializer.serialize_tuple(own.len())?;
                for (&own, &count) in own.iter().zip(chunks) {
                    let together = *together;
                    both.serialize_element(&Chunks { own, together, count })?;
                }
                both.end()
            }
            Self::Read(chunks) => chunks.serialize(serializer),
        }
    }
}

impl<'de> Deserialize<'de> for SavedContacts<'_> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Ok(Self::Read(Deserialize::deserialize(deserializer)?))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BODIES: [(u32, u32); 4] = [(5, 9), (5, 2), (7, 2), (8, 9)];

    fn kind(are_walls: bool) -> Kind {
        Kind {
            are_walls,
            are_coupled: false,
            stride: 2,
        }
    }

    /// Three contacts of some candidates.
    fn saved(are_walls: bool) -> SavedChunk {
        SavedChunk {
            of_candidates: if are_walls {
                vec![(1, 2), (3, 1)]
            } else {
                vec![(0, 1), (1, 1), (3, 1)]
            },
            element: if are_walls { vec![4, 6, 0] } else { Vec::new() },
            geometry: if are_walls {
                vec![bytemuck::Zeroable::zeroed(); 3]
            } else {
                Vec::new()
            },
            normal_force: vec![1.0, 2.0, 3.0],
            tangential: vec![[0.5, 0.0, 1.0]; 3],
            rolling: vec![[0.0, 2.0, 0.0]; 3],
            history: vec![1.0, 2.0, 3.0, 4.0, 5.0, 6.0],
            engaged: vec![0b101],
            ..SavedChunk::default()
        }
    }

    #[test]
    fn a_chunk_comes_back_as_it_was() {
        for are_walls in [false, true] {
            let chunk = saved(are_walls).restored(3, &BODIES, kind(are_walls)).unwrap();
            let bodies: Vec<_> = chunk.i.iter().copied().zip(chunk.j.iter().copied()).collect();
            let expected = if are_walls {
                [BODIES[1], BODIES[1], BODIES[3]]
            } else {
                [BODIES[0], BODIES[1], BODIES[3]]
            };
            assert_eq!(bodies, expected);
            let of_each: Vec<usize> = (0..4).map(|c| chunk.contacts_of(c).len()).collect();
            assert_eq!(of_each, if are_walls { [0, 2, 0, 1] } else { [1, 1, 0, 1] });
            let again = format!("{:?}", SavedChunk::of(&chunk));
            assert_eq!(again, format!("{:?}", saved(are_walls)));
        }
    }

    #[test]
    fn contradictions_are_seen() {
        let changes: [fn(&mut SavedChunk); 13] = [
            |chunk| chunk.of_candidates[1].0 = 4,
            |chunk| chunk.of_candidates[1].0 = 0,
            |chunk| chunk.of_candidates[0].0 = u16::MAX,
            |chunk| chunk.of_candidates[0].1 = 0,
            |chunk| chunk.of_candidates[0].1 = u32::MAX,
            |chunk| chunk.of_candidates.truncate(1),
            |chunk| chunk.element.push(0),
            |chunk| chunk.normal_force.truncate(2),
            |chunk| chunk.tangential.truncate(2),
            |chunk| chunk.rolling.truncate(2),
            |chunk| chunk.history.truncate(2),
            |chunk| chunk.engaged.push(0),
            |chunk| chunk.coupling.push(Coupled::default()),
        ];
        for are_walls in [false, true] {
            for (number, change) in changes.iter().enumerate() {
                let mut chunk = saved(are_walls);
                change(&mut chunk);
                assert!(chunk.restored(3, &BODIES, kind(are_walls)).is_none(), "change {number}");
            }
        }
        let mut flat = saved(true);
        flat.geometry.clear();
        assert!(flat.restored(3, &BODIES, kind(true)).is_none());
        let coupled = Kind {
            are_coupled: true,
            ..kind(false)
        };
        assert!(saved(false).restored(3, &BODIES, coupled).is_none());
        let mut twice = saved(false);
        twice.of_candidates = vec![(0, 2), (3, 1)];
        assert!(twice.restored(3, &BODIES, kind(false)).is_none());
    }
}
