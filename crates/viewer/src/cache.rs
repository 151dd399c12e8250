//! Answers that are kept, within a bound; the one that was not asked for the longest goes first.

use bytes::Bytes;
use std::collections::BTreeMap;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::SystemTime;

/// What an answer is known by: its kind and step, and when the file behind it was written.
pub(crate) type Key = (&'static str, u64, Option<SystemTime>);

/// Answers by their keys.
#[derive(Debug)]
pub(crate) struct Cache {
    allowed: usize,
    used: usize,
    clock: u64,
    answers: BTreeMap<Key, (u64, Bytes)>,
}

impl Cache {
    /// A cache of at most so many bytes.
    pub fn new(allowed: usize) -> Self {
        Self {
            allowed,
            used: 0,
            clock: 0,
            answers: BTreeMap::new(),
        }
    }

    /// An answer, if it is kept.
    pub fn get(&mut self, key: &Key) -> Option<Bytes> {
        self.clock += 1;
        let (asked, bytes) = self.answers.get_mut(key)?;
        *asked = self.clock;
        Some(bytes.clone())
    }

    /// Keeps an answer, unless it is larger than all that may be kept.
    pub fn put(&mut self, key: Key, bytes: Bytes) {
        if bytes.len() > self.allowed {
            return;
        }
        self.clock += 1;
        self.used += bytes.len();
        if let Some((_, old)) = self.answers.insert(key, (self.clock, bytes)) {
            self.used -= old.len();
        }
        while self.used > self.allowed {
            let oldest = self
                .answers
                .iter()
                .min_by_key(|(_, (asked, _))| *asked)
                .map(|(key, _)| *key);
            let Some((_, old)) = oldest.and_then(|key| self.answers.remove(&key)) else {
                return;
            };
            self.used -= old.len();
        }
    }
}

/// What a thread that panicked left is still whole: every change is made in one piece.
pub(crate) fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_one_not_asked_for_the_longest_goes_first() {
        let mut cache = Cache::new(100);
        let key = |step| ("frame", step, None);
        for step in 0..3 {
            cache.put(key(step), Bytes::from(vec![step as u8; 40]));
            assert!(cache.get(&key(0)).is_some(), "{step}");
        }
        assert!(cache.get(&key(1)).is_none() && cache.get(&key(2)).is_some());
        assert_eq!(cache.used, 80);
        cache.put(key(2), Bytes::from(vec![9; 20]));
        assert_eq!((cache.used, cache.get(&key(2)).unwrap()[0]), (60, 9));
        cache.put(key(7), Bytes::from(vec![0; 101]));
        assert!(cache.get(&key(7)).is_none() && cache.get(&key(0)).is_some());
    }
}
