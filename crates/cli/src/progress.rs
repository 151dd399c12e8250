//! What a user sees while a run goes on: a bar on a terminal, lines elsewhere.

use crate::answer::note;
use crate::interrupt::Interrupt;
use crate::readable::{count, number, wait};
use demeter::scenario::{Observer, Progress};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::IsTerminal;
use std::time::Duration;

/// Time between two lines where there is no terminal [s].
const LINE_INTERVAL: f64 = 5.0;

/// Share of the latest report in the smoothed speed.
const SMOOTHING: f64 = 0.15;

/// Shows a run to the user and tells it when to end.
pub struct Watch {
    interrupt: Interrupt,
    bar: Option<ProgressBar>,
    speed: Speed,
    next_line: f64,
    /// Whether it was told that the run ends: processes that share it ask several times until all have heard.
    end_is_told: bool,
}

impl Watch {
    /// Watches a run; a bar is drawn when standard error is a terminal.
    pub fn new(interrupt: Interrupt) -> Self {
        Self {
            interrupt,
            bar: std::io::stderr().is_terminal().then(bar),
            speed: Speed::default(),
            next_line: LINE_INTERVAL,
            end_is_told: false,
        }
    }

    /// Removes the bar.
    pub fn end(&self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}

/// A bar on standard error.
pub fn bar() -> ProgressBar {
    let bar = ProgressBar::with_draw_target(Some(1), ProgressDrawTarget::stderr());
    let template = "{bar:24} {percent:>3} %  {msg}";
    // The template is a constant; were it wrong, the plain bar would do.
    bar.set_style(ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar()));
    bar
}

impl Observer for Watch {
    fn progress(&mut self, progress: &Progress) -> bool {
        self.speed.update(progress);
        let text = describe(progress, self.speed.steps_per_second);
        match &self.bar {
            Some(bar) => {
                bar.set_length(progress.steps.max(1));
                bar.set_position(progress.step);
                bar.set_message(text);
            }
            None if progress.elapsed >= self.next_line => {
                self.next_line = progress.elapsed + LINE_INTERVAL;
                let percent = 100.0 * progress.step as f64 / progress.steps.max(1) as f64;
                note(&format!("{percent:3.0} %  {text}"));
            }
            None => {}
        }
        if !self.interrupt.is_asked() {
            return true;
        }
        if !std::mem::replace(&mut self.end_is_told, true) {
            self.message("interrupted: writing a checkpoint; interrupt again to end at once");
        }
        false
    }

    fn interval(&self) -> Duration {
        self.interrupt.interval()
    }

    fn message(&mut self, text: &str) {
        self.interrupt.steps_begin();
        match &self.bar {
            Some(bar) => bar.suspend(|| note(text)),
            None => note(text),
        }
    }
}

fn describe(progress: &Progress, steps_per_second: f64) -> String {
    let (stage, stages) = progress.stage_of;
    let left = progress.steps.saturating_sub(progress.step) as f64 / steps_per_second;
    format!(
        "stage {stage}/{stages} {}, {} s, {} grains, {} particle-steps/s, at most {} left",
        progress.stage,
        number(progress.time),
        count(progress.grains as u64),
        number(steps_per_second * progress.grains as f64),
        wait(left),
    )
}

/// Steps per second, smoothed, since the cost of a step changes with the number of contacts.
#[derive(Default)]
struct Speed {
    steps_per_second: f64,
    steps: u64,
    elapsed: f64,
}

impl Speed {
    fn update(&mut self, progress: &Progress) {
        let seconds = progress.elapsed - self.elapsed;
        if seconds <= 0.0 {
            return;
        }
        let latest = progress.steps_here.saturating_sub(self.steps) as f64 / seconds;
        self.steps_per_second = match self.steps {
            0 => latest,
            _ => SMOOTHING * latest + (1.0 - SMOOTHING) * self.steps_per_second,
        };
        (self.steps, self.elapsed) = (progress.steps_here, progress.elapsed);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn progress(step: u64, elapsed: f64) -> Progress<'static> {
        Progress {
            stage: "settle",
            stage_of: (1, 3),
            step,
            steps: 1000,
            time: 0.25,
            grains: 500,
            elapsed,
            steps_here: step,
        }
    }

    #[test]
    fn the_time_left_follows_the_speed() {
        let mut speed = Speed::default();
        speed.update(&progress(100, 1.0));
        speed.update(&progress(200, 2.0));
        let text = describe(&progress(200, 2.0), speed.steps_per_second);
        assert_eq!(
            text,
            "stage 1/3 settle, 0.25 s, 500 grains, 50000 particle-steps/s, at most 8.0 s left"
        );
    }

    #[test]
    fn a_run_without_steps_tells_no_nonsense() {
        let text = describe(&progress(0, 0.0), Speed::default().steps_per_second);
        assert!(text.ends_with("at most very long left"), "{text}");
    }
}
