//! The secret in the address of the page: who does not know the address is told nothing.
//!
//! Every user of a machine reaches 127.0.0.1, so the path of every request begins with a key that only whoever started the
//! viewer has been told. A cookie would go to the servers of others at 127.0.0.1, too: the port does not count for cookies.

use std::fmt::{self, Display, Formatter};
use std::sync::{Mutex, PoisonError};

/// Random bytes of a key.
const LENGTH: usize = 20;

/// A random secret, written in the digits of base 16.
#[derive(Clone, PartialEq, Eq)]
pub(crate) struct Key(String);

impl Key {
    /// A new one.
    pub fn new() -> Result<Self, getrandom::Error> {
        let mut bytes = [0; LENGTH];
        getrandom::fill(&mut bytes)?;
        Ok(Self(bytes.iter().map(|byte| format!("{byte:02x}")).collect()))
    }

    /// Whether a text is this key; takes as long for every text of its length.
    fn is(&self, text: &str) -> bool {
        let differences = self.0.bytes().zip(text.bytes()).fold(0, |sum, (a, b)| sum | (a ^ b));
        text.len() == self.0.len() && differences == 0
    }
}

impl Display for Key {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl fmt::Debug for Key {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        f.write_str("Key(…)")
    }
}

/// What lets a request in.
#[derive(Debug)]
pub(crate) struct Door {
    key: Key,
    /// A key that opens once. Programs that open a browser show its address to everybody in the list of processes; who reads
    /// it there comes too late.
    once: Mutex<Option<Key>>,
}

/// Where a path leads.
#[derive(Debug, PartialEq, Eq)]
pub(crate) enum Way<'p> {
    /// To what stands behind the key, which begins with `/`.
    In(&'p str),
    /// To the page, whose path this is.
    Page(String),
    /// Nowhere.
    Closed,
}

impl Door {
    /// A door with new keys.
    pub fn new() -> Result<Self, getrandom::Error> {
        Ok(Self {
            key: Key::new()?,
            once: Mutex::new(Some(Key::new()?)),
        })
    }

    /// The path of the page.
    pub fn path(&self) -> String {
        format!("/{}/", self.key)
    }

    /// A path that leads to the page once; that of the page when it was used.
    pub fn path_once(&self) -> String {
        let once = self.once.lock().unwrap_or_else(PoisonError::into_inner);
        once.as_ref().map_or_else(|| self.path(), |key| format!("/{key}/"))
    }

    /// Where a path leads.
    pub fn way<'p>(&self, path: &'p str) -> Way<'p> {
        let path = path.strip_prefix('/').unwrap_or_default();
        let end = path.find('/').unwrap_or(path.len());
        let (key, rest) = path.split_at(end);
        if self.key.is(key) {
            return if rest.is_empty() {
                Way::Page(self.path())
            } else {
                Way::In(rest)
            };
        }
        let mut once = self.once.lock().unwrap_or_else(PoisonError::into_inner);
        if once.as_ref().is_some_and(|once| once.is(key)) && rest.len() < 2 {
            *once = None;
            return Way::Page(self.path());
        }
        Way::Closed
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_the_key_opens() {
        let door = Door::new().unwrap();
        let page = door.path();
        let key = page.trim_matches('/').to_string();
        assert_eq!(key.len(), 2 * LENGTH);
        assert!(key.bytes().all(|b| b.is_ascii_hexdigit()));
        assert_eq!(door.way(&page), Way::In("/"));
        assert_eq!(door.way(&format!("/{key}/api/frame/10")), Way::In("/api/frame/10"));
        assert_eq!(door.way(&format!("/{key}")), Way::Page(page.clone()));
        let other = Door::new().unwrap().path();
        assert_ne!(other, page);
        let short = &key[..key.len() - 1];
        for path in [
            "",
            "/",
            "//",
            "/api/state",
            &other,
            &format!("/{short}/"),
            &format!("/{key}0/"),
            &format!("//{key}/"),
            &key,
        ] {
            assert_eq!(door.way(path), Way::Closed, "{path}");
        }
        assert!(!format!("{door:?}").contains(&key));
    }

    #[test]
    fn a_key_for_once_opens_once() {
        let door = Door::new().unwrap();
        let once = door.path_once();
        assert_ne!(once, door.path());
        // it opens the page and nothing else
        assert_eq!(door.way(&format!("{once}api/state")), Way::Closed);
        assert_eq!(door.way(&once), Way::Page(door.path()));
        assert_eq!(door.way(&once), Way::Closed);
        assert_eq!(door.path_once(), door.path());
    }
}
