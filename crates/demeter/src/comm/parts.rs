//! What consists of lists of all grains and segments, written by those who have parts of it together.

use super::together::Together;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::borrow::Cow;
use std::fmt::{Debug, Formatter};
use std::ops::{Deref, Range};

/// What a process has of lists that all have together: its own grains, and their segments.
#[derive(Clone, Debug)]
pub(crate) struct Part<'a> {
    pub(crate) together: Together<'a>,
    pub(crate) grains: Range<usize>,
    pub(crate) segments: Range<usize>,
}

impl Part<'_> {
    /// All.
    pub(crate) const WHOLE: Self = Self {
        together: Together::ALONE,
        grains: 0..usize::MAX,
        segments: 0..usize::MAX,
    };

    /// Nothing: every list is empty.
    pub(crate) const NOTHING: Self = Self {
        together: Together::ALONE,
        grains: 0..0,
        segments: 0..0,
    };
}

impl<'a> Part<'a> {
    /// A list of all grains, to be written; of others its rows are not looked at.
    pub(crate) fn of_grains<'b, T>(&self, list: &'b [T]) -> Listed<'a, 'b, T> {
        self.listed(list, &self.grains)
    }

    /// The same of all segments.
    pub(crate) fn of_segments<'b, T>(&self, list: &'b [T]) -> Listed<'a, 'b, T> {
        self.listed(list, &self.segments)
    }

    fn listed<'b, T>(&self, list: &'b [T], own: &Range<usize>) -> Listed<'a, 'b, T> {
        let all = list.len();
        let own = &list[own.start.min(all)..own.end.min(all)];
        Listed {
            together: self.together,
            own,
            length: if self.together.is_alone() { own.len() } else { all },
        }
    }
}

/// What consists of lists of all grains and segments.
pub(crate) trait InParts: Clone {
    /// All of it, to be written together with those who have the other parts.
    fn in_parts<'a>(&'a self, part: &'a Part<'_>) -> impl Serialize + 'a;
}

/// Something that all have together, as a checkpoint holds it.
#[derive(Clone)]
pub(crate) struct Saved<'a, T: Clone> {
    value: Cow<'a, T>,
    part: Part<'a>,
}

impl<'a, T: Clone> Saved<'a, T> {
    pub(crate) fn new(value: Cow<'a, T>, part: &Part<'a>) -> Self {
        let part = part.clone();
        Self { value, part }
    }

    pub(crate) fn into_owned(self) -> T {
        self.value.into_owned()
    }
}

impl<T: Clone + Debug> Debug for Saved<'_, T> {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> std::fmt::Result {
        self.value.fmt(formatter)
    }
}

impl<T: Clone> Deref for Saved<'_, T> {
    type Target = T;

    fn deref(&self) -> &T {
        &self.value
    }
}

impl<T: InParts> Serialize for Saved<'_, T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.value.in_parts(&self.part).serialize(serializer)
    }
}

impl<'de, T: Clone + Deserialize<'de>> Deserialize<'de> for Saved<'_, T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let value = T::deserialize(deserializer)?;
        Ok(Self::new(Cow::Owned(value), &Part::WHOLE))
    }
}

/// A list that all have together.
pub(crate) struct Listed<'a, 'b, T> {
    together: Together<'a>,
    own: &'b [T],
    length: usize,
}

impl<T: Serialize + DeserializeOwned> Serialize for Listed<'_, '_, T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.together.write(self.own, self.length, serializer)
    }
}
