//! What few chunks need.

use std::ops::{Deref, DerefMut};

/// Something that is empty in most chunks, where it takes no room: it is there as soon as it is to be changed.
#[derive(Clone, Debug)]
pub(crate) struct Rare<T>(Option<Box<T>>);

/// What begins empty.
pub(crate) trait Empty: Default + 'static {
    /// It, as it begins.
    fn empty() -> &'static Self;
}

/// Says of a type that it begins empty.
macro_rules! begins_empty {
    ($of:ty) => {
        impl $crate::contacts::rare::Empty for $of {
            fn empty() -> &'static Self {
                static EMPTY: std::sync::LazyLock<$of> = std::sync::LazyLock::new(<$of>::default);
                &EMPTY
            }
        }
    };
}

pub(super) use begins_empty;

impl<T> Default for Rare<T> {
    fn default() -> Self {
        Self(None)
    }
}

impl<T> Rare<T> {
    /// It, where it was changed before.
    pub(crate) fn if_there(&mut self) -> Option<&mut T> {
        self.0.as_deref_mut()
    }

    /// Bytes that are set aside for it, without those of its lists.
    pub(crate) fn bytes(&self) -> usize {
        self.0.as_ref().map_or(0, |_| size_of::<T>())
    }
}

impl<T: Empty> Deref for Rare<T> {
    type Target = T;

    #[inline(always)]
    fn deref(&self) -> &T {
        match &self.0 {
            Some(it) => it,
            None => T::empty(),
        }
    }
}

impl<T: Empty> DerefMut for Rare<T> {
    #[inline(always)]
    fn deref_mut(&mut self) -> &mut T {
        self.0.get_or_insert_default()
    }
}
