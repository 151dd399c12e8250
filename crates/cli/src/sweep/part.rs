//! One run of a sweep in this process: a task of a job array, or a child of `demeter sweep`.

use crate::answer::{answer, answer_json, note};
use crate::arguments::SweepArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::interrupt::Interrupt;
use crate::progress::Watch;
use demeter::scenario::{Observer, Progress, RunOptions};
use demeter::sweep::{Carried, End, SweepFolder, carry_out as carry};
use serde_json::json;
use std::io::{Read, Write};
use std::path::Path;
use std::time::Duration;

/// Carries out one run.
pub fn carry_out(arguments: &SweepArguments, root: &Path, index: usize) -> Result<Exit, Failure> {
    let interrupt = Interrupt::listen();
    let folder = SweepFolder::open(root)?;
    folder.check_index(index)?;
    let options = RunOptions {
        threads: Some(usize::from(arguments.threads)),
        ..RunOptions::default()
    };
    if arguments.as_part {
        end_with_standard_input(&interrupt);
        let mut reporter = Reporter { interrupt };
        return Ok(exit_of(&carry(
            &folder,
            index,
            arguments.retry_failed,
            options,
            &mut reporter,
        )?));
    }
    let _held = folder.join()?;
    note(&format!("run {index}: {}", folder.plan.describe(index)));
    let mut watch = Watch::new(interrupt);
    let carried = carry(&folder, index, arguments.retry_failed, options, &mut watch);
    watch.end();
    let carried = carried?;
    let exit = exit_of(&carried);
    let (end, message) = match &carried {
        Carried::Ended(outcome) => (outcome.end.name(), outcome.message.as_str()),
        Carried::Interrupted => (
            "interrupted",
            "a checkpoint was written; the same command goes on from it",
        ),
    };
    let shown = folder.run_folder(index).display().to_string();
    if arguments.json {
        answer_json(&json!({
            "index": index, "name": folder.plan.runs[index].name, "folder": shown, "end": end, "message": message,
            "exit_code": exit as u8,
        }))?;
    } else {
        answer(&format!("{end}: {message}\n  results  {shown}\n"))?;
        if exit == Exit::Fault || exit == Exit::InputOutput {
            note("--retry-failed tries it again");
        }
    }
    Ok(exit)
}

fn exit_of(carried: &Carried) -> Exit {
    match carried {
        Carried::Interrupted => Exit::Interrupted,
        Carried::Ended(outcome) => match outcome.end {
            End::Finished => Exit::Finished,
            End::Fault => Exit::Fault,
            End::Error | End::Crash => Exit::InputOutput,
        },
    }
}

/// Asks the run to end when the process that holds the other end of standard input ends, or lets go of it.
fn end_with_standard_input(interrupt: &Interrupt) {
    let interrupt = interrupt.clone();
    std::thread::spawn(move || {
        let mut rest = [0; 64];
        let mut input = std::io::stdin().lock();
        while matches!(input.read(&mut rest), Ok(1..)) {}
        interrupt.ask();
    });
}

/// Tells the process that started this one how far the run is.
struct Reporter {
    interrupt: Interrupt,
}

impl Observer for Reporter {
    fn progress(&mut self, progress: &Progress) -> bool {
        let line = json!({ "step": progress.step, "steps": progress.steps });
        let mut out = std::io::stdout().lock();
        let heard = writeln!(out, "{line}").and_then(|()| out.flush()).is_ok();
        heard && !self.interrupt.is_asked()
    }

    fn interval(&self) -> Duration {
        self.interrupt.interval()
    }

    fn message(&mut self, text: &str) {
        self.interrupt.steps_begin();
        note(text);
    }
}
