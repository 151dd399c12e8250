//! What the tables of a run hold in memory.

use super::Simulation;
use serde::Serialize;

/// Memory of one kind of table.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct MemoryPart {
    /// What it is of.
    pub name: &'static str,
    /// Bytes that are set aside, in use or not.
    pub bytes: usize,
    /// The same per grain.
    pub bytes_per_grain: f64,
}

/// Gives memory back to the system that a start has needed and freed: the allocator of glibc keeps some tens of megabytes otherwise.
#[cfg(all(target_os = "linux", target_env = "gnu"))]
#[allow(unsafe_code, reason = "nothing but the allocator can do that")]
pub(crate) fn give_back() {
    // SAFETY: any thread may call it at any time
    unsafe { libc::malloc_trim(0) };
}

/// Other allocators give memory back by themselves.
#[cfg(not(all(target_os = "linux", target_env = "gnu")))]
pub(crate) fn give_back() {}

/// Tables from this size on are had from the system and given back to it [bytes].
#[cfg(all(target_os = "linux", target_env = "gnu"))]
const TABLE: libc::c_int = 1 << 20;

/// Has tables give their memory back when they go, and their zeros take none until something else is written, from now on: the allocator
/// of glibc comes to have tables of up to 32 MB in its heap otherwise, where it keeps what others lie behind, and writes zeros.
#[cfg(all(target_os = "linux", target_env = "gnu"))]
#[allow(unsafe_code, reason = "nothing but the allocator can do that")]
pub(in crate::simulation) fn have_tables_from_the_system() {
    // SAFETY: any thread may call it at any time
    unsafe { libc::mallopt(libc::M_MMAP_THRESHOLD, TABLE) };
}

/// Other allocators have large tables from the system.
#[cfg(not(all(target_os = "linux", target_env = "gnu")))]
pub(in crate::simulation) fn have_tables_from_the_system() {}

impl Simulation {
    /// Memory of the tables that grow with the number of grains and contacts. The program itself and what output and measures need come on
    /// top; a search for candidates takes little more than the loads of the grains, which are put aside as long as it lasts.
    pub fn memory(&self) -> Vec<MemoryPart> {
        let candidates = self.neighbours.bytes(self.own_grains().len());
        let mut contacts = [0; 4];
        for chunk in self.contacts.pairs.iter().chain(&self.contacts.walls) {
            for (sum, bytes) in contacts.iter_mut().zip(chunk.bytes()) {
                *sum += bytes;
            }
        }
        let [bodies, forces, history, other] = contacts;
        let parts = [
            ("grains", self.grains.bytes_of(self.known_grains())),
            ("candidates", candidates),
            ("contacts: bodies", bodies),
            ("contacts: forces", forces),
            ("contacts: history", history),
            ("contacts: other", other),
            ("sums", self.sums.bytes()),
        ];
        let grains = self.grains.len().max(1) as f64;
        let part = |(name, bytes): (_, usize)| MemoryPart {
            name,
            bytes,
            bytes_per_grain: bytes as f64 / grains,
        };
        parts.into_iter().map(part).collect()
    }
}
