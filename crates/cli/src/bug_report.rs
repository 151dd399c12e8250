//! What a panic tells: that it is a defect, and what to send.

use crate::answer::note;

/// Replaces the message of panics.
pub fn install() {
    std::panic::set_hook(Box::new(|panic| {
        let command: Vec<String> = std::env::args_os().map(|a| a.to_string_lossy().into_owned()).collect();
        note(&format!(
            "\n{panic}\n\nThis is a defect of Demeter, not of your scenario. Please report it with the scenario and \
             these lines:\n  demeter {} on {} {}\n  command: {}\nA run folder that was being written is intact up to its \
             latest checkpoint: `demeter resume`.",
            demeter::VERSION,
            std::env::consts::OS,
            std::env::consts::ARCH,
            command.join(" "),
        ));
    }));
}
