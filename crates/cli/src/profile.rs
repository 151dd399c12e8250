//! Where the time of a run went, as a table.

use crate::readable::{number, things};
use demeter::simulation::{ProfileReport, Roofline, SharingReport};

/// Phases with time in them, the whole, and how far that is from what the machine can do.
pub fn to_text(profile: &ProfileReport) -> String {
    let line = |name: &str, seconds: f64, share: f64, ns: f64| {
        format!("  {name:<18} {seconds:>10.3} s {:>6.1} % {ns:>16.1}\n", 100.0 * share)
    };
    let particle_steps = profile.particle_steps.max(1) as f64;
    let mut text = format!(
        "where the time went, on {} with {} instructions\n  {:<18} {:>12} {:>8} {:>16}\n",
        things(profile.threads as u64, "thread"),
        profile.instructions,
        "",
        "seconds",
        "share",
        "ns/particle-step"
    );
    for phase in profile.phases.iter().filter(|p| p.seconds > 0.0) {
        text += &line(phase.name, phase.seconds, phase.share, phase.ns_per_particle_step);
    }
    text += &line("all", profile.seconds, 1.0, profile.seconds * 1e9 / particle_steps);
    let rebuilds = things(profile.rebuilds, "rebuild");
    text += &format!("  {rebuilds} of the candidates in {}\n", things(profile.steps, "step"));
    if let Some(effort) = profile.coupling.filter(|effort| effort.solutions > 0) {
        let each = effort.iterations as f64 / effort.solutions as f64;
        let times = things(effort.solutions, "time");
        text += &format!(
            "  the coupled equation was solved {times}, in {} iterations each\n",
            number(each)
        );
    }
    let memory = profile.memory.iter().filter(|part| part.bytes > 0);
    let held: f64 = memory.clone().map(|part| part.bytes_per_grain).sum();
    text += &format!(
        "what the tables hold\n  {:<28} {:>10} {:>12}\n",
        "", "MB", "bytes/grain"
    );
    for part in memory {
        text += &format!(
            "  {:<28} {:>10.1} {:>12.1}\n",
            part.name,
            part.bytes as f64 * 1e-6,
            part.bytes_per_grain
        );
    }
    text += &format!("  {:<28} {:>10} {held:>12.1}\n", "all", "");
    if let Some(sharing) = &profile.sharing {
        text += &with_others(sharing);
    }
    if let Some(roofline) = &profile.roofline {
        text += &against_the_machine(roofline);
    }
    text
}

fn with_others(sharing: &SharingReport) -> String {
    let mut text = format!(
        "shared by {} processes\n  the busiest has {} times the work of the mean; grains were divided {}\n  per grain and step {} bytes \
         went from one process to another, {} of them over borders; {} messages and {} rounds of all per step\n  telling, hearing \
         and waiting took each {} s, the longest {} s\n",
        sharing.ranks,
        number(sharing.imbalance),
        things(sharing.divided, "time"),
        number(sharing.bytes),
        number(sharing.border_bytes),
        number(sharing.messages),
        number(sharing.rounds),
        number(sharing.seconds),
        number(sharing.most_seconds),
    );
    if let (Some(first), Some(others)) = (sharing.memory_of_first, sharing.memory_of_others) {
        let megabytes = |bytes: u64| number((bytes as f64 / 1e6).round());
        text += &format!(
            "  the first process, which writes, had at most {} MB in use, each other at most {} MB\n",
            megabytes(first),
            megabytes(others),
        );
    }
    text
}

fn against_the_machine(roofline: &Roofline) -> String {
    format!(
        "  a particle-step has {} candidates and {} contacts; it must move {} bytes ({} ns at {} GB/s) and needs {} operations \
         ({} ns at {} GFLOP/s)\n  the steps took {} ns: {} times the time that memory alone would need, {} times that of the \
         operations\n",
        number(roofline.candidates_per_grain),
        number(roofline.contacts_per_grain),
        number(roofline.bytes.round()),
        number(roofline.memory_ns),
        number(roofline.machine.bandwidth * 1e-9),
        number(roofline.operations.round()),
        number(roofline.operations_ns),
        number(roofline.machine.operations * 1e-9),
        number(roofline.ns),
        number(roofline.times_memory),
        number(roofline.times_operations),
    )
}
