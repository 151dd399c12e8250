//! What sharing a run takes.

use crate::comm::Traffic;
use crate::simulation::Simulation;
use serde::Serialize;

/// What sharing a run takes: the sums and the extremes of all processes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct SharingReport {
    /// Number of processes.
    pub ranks: usize,
    /// Work of the busiest process over the mean, since grains were divided or candidates found last.
    pub imbalance: f64,
    /// How often the grains were divided.
    pub divided: u64,
    /// Bytes over borders, from one process to another, per grain and step.
    pub border_bytes: f64,
    /// The same with what is told to all, and to the process that writes.
    pub bytes: f64,
    /// Messages over borders, per process and step.
    pub messages: f64,
    /// Things told to all, per process and step.
    pub rounds: f64,
    /// Time that processes spent on telling, hearing and waiting for others: the mean [s].
    pub seconds: f64,
    /// The same of the process that spent the most [s].
    pub most_seconds: f64,
    /// The most memory that the first process had in use, which writes [bytes]; nothing where the system does not tell.
    pub memory_of_first: Option<u64>,
    /// The same of the one of the others that had the most in use.
    pub memory_of_others: Option<u64>,
}

/// How a shared run went, as one process sees it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sharing {
    /// Number of processes.
    pub ranks: usize,
    /// What this process told others.
    pub traffic: Traffic,
    /// Work of the busiest process over the mean.
    pub imbalance: f64,
    /// How often the grains were divided.
    pub divided: u64,
}

impl Simulation {
    /// How the run is shared with other processes; `None` where it is not.
    pub fn sharing(&self) -> Option<Sharing> {
        self.division.as_ref().map(|division| Sharing {
            ranks: division.ranks.count(),
            traffic: division.ranks.traffic(),
            imbalance: division.imbalance,
            divided: division.divided,
        })
    }

    /// What sharing took in so many steps, with so many grains in all of them together; each process calls this.
    pub(in crate::simulation) fn sharing_of_all(&self, steps: u64, particle_steps: u64) -> Option<SharingReport> {
        let division = self.division.as_ref()?;
        let Sharing {
            ranks,
            traffic,
            imbalance,
            divided,
        } = self.sharing()?;
        let nanoseconds = (traffic.seconds * 1e9) as u64;
        let mine = [
            traffic.messages,
            traffic.bytes,
            traffic.rounds,
            traffic.round_bytes,
            traffic.joined_bytes,
            traffic.gathered_bytes,
            nanoseconds,
        ];
        let ([messages, bytes, rounds, round_bytes, joined, gathered, all], [.., most]) = division.counts(mine);
        let memory = (division.ranks).gather_even(&most_in_use().unwrap_or_default().to_le_bytes());
        let mut memory = memory.chunks_exact(size_of::<u64>()).map(bytemuck::pod_read_unaligned);
        let is_told = |bytes: &u64| *bytes > 0;
        let per_process = |count: u64| count as f64 / (ranks as f64 * steps.max(1) as f64);
        let per_grain = |bytes: u64| bytes as f64 / particle_steps.max(1) as f64;
        Some(SharingReport {
            ranks,
            imbalance,
            divided,
            border_bytes: per_grain(bytes),
            bytes: per_grain(bytes + round_bytes * (ranks as u64 - 1) + joined + gathered),
            messages: per_process(messages),
            rounds: per_process(rounds),
            seconds: all as f64 * 1e-9 / ranks as f64,
            most_seconds: most as f64 * 1e-9,
            memory_of_first: memory.next().filter(is_told),
            memory_of_others: memory.max().filter(is_told),
        })
    }
}

/// The most memory that this process had in use so far [bytes], as Linux tells it.
fn most_in_use() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    let kilobytes: u64 = line.trim().strip_suffix(" kB")?.parse().ok()?;
    Some(1024 * kilobytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    #[cfg(target_os = "linux")]
    fn linux_tells_the_memory_in_use() {
        let memory = vec![1u8; 64 << 20];
        let most = most_in_use().expect("a number");
        assert!(most > memory.len() as u64, "{most}");
    }
}
