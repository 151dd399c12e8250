//! What was measured, and the tables made of it.

use crate::agreement::{Deviation, Tolerance};
use crate::analysis::Physics;
use crate::engines::Loop;
use serde::Serialize;

/// One run.
#[derive(Clone, Debug, Serialize)]
pub struct Sample {
    /// Round, from 0.
    pub round: usize,
    /// What the engine told of its loop.
    pub measured: Loop,
    /// Largest memory of the whole run [bytes].
    pub peak: Option<u64>,
    /// Cores busy with other programs.
    pub others: Option<f64>,
}

/// All runs of one engine on one workload with one number of threads.
#[derive(Clone, Debug, Serialize)]
pub struct Series {
    /// Name of the engine.
    pub engine: String,
    /// Threads or ranks.
    pub threads: usize,
    /// The runs.
    pub samples: Vec<Sample>,
    /// Why there are no more.
    pub fault: Option<String>,
    /// What its grains told at the end.
    pub physics: Option<Physics>,
    /// How that differs from Demeter's.
    pub deviation: Option<Deviation>,
    /// How far it may differ.
    pub tolerance: Tolerance,
}

/// One workload.
#[derive(Clone, Debug, Serialize)]
pub struct Outcome {
    /// How it is asked for.
    pub key: String,
    /// Its title.
    pub title: String,
    /// Grains.
    pub grains: usize,
    /// Steps of the loop.
    pub steps: u64,
    /// What the surface is whose load is compared.
    pub bearing: &'static str,
    /// Engine by engine, Demeter first.
    pub series: Vec<Series>,
}

/// Everything.
#[derive(Clone, Debug, Serialize)]
pub struct Report {
    /// The machine: its processor.
    pub machine: String,
    /// Version of Demeter.
    pub demeter: String,
    /// Workload by workload.
    pub outcomes: Vec<Outcome>,
}

/// Median, smallest and largest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spread {
    /// Median; the mean of the middle two for an even number.
    pub median: f64,
    /// Smallest.
    pub least: f64,
    /// Largest.
    pub most: f64,
}

impl Spread {
    /// Of some values; nothing of none.
    pub fn of(values: &[f64]) -> Option<Self> {
        let mut sorted = values.to_vec();
        sorted.sort_unstable_by(f64::total_cmp);
        let half = sorted.len() / 2;
        let upper = *sorted.get(half)?;
        let median = if sorted.len().is_multiple_of(2) {
            0.5 * (sorted[half - 1] + upper)
        } else {
            upper
        };
        Some(Self {
            median,
            least: sorted[0],
            most: sorted[sorted.len() - 1],
        })
    }

    fn shown(self, digits: usize) -> String {
        let Self { median, least, most } = self;
        format!("{median:.digits$} ({least:.digits$}-{most:.digits$})")
    }
}

impl Sample {
    /// Million particle-steps in a second of one core; by the clock where the engine did not tell its processor time.
    fn per_core(&self, threads: usize) -> f64 {
        let m = &self.measured;
        m.grains as f64 * m.steps as f64 / m.cpu.unwrap_or(m.seconds * threads as f64) * 1e-6
    }

    /// Million particle-steps in a second on the clock.
    fn by_clock(&self) -> f64 {
        let m = &self.measured;
        m.grains as f64 * m.steps as f64 / m.seconds * 1e-6
    }
}

impl Series {
    /// Ratios, round by round, of what two series have.
    fn ratios(&self, other: &Self, of: impl Fn(&Sample, &Series) -> f64) -> Vec<f64> {
        let pair = |ours: &Sample| {
            let theirs = other.samples.iter().find(|s| s.round == ours.round)?;
            Some(of(ours, self) / of(theirs, other))
        };
        self.samples.iter().filter_map(pair).collect()
    }

    fn spread(&self, of: impl Fn(&Sample) -> f64) -> Option<Spread> {
        Spread::of(&self.samples.iter().map(of).collect::<Vec<_>>())
    }

    /// Smallest of the peaks: a run that also wrote its grains needed more [bytes].
    fn peak(&self) -> Option<u64> {
        self.samples.iter().filter_map(|s| s.peak).min()
    }

    fn loop_peak(&self) -> Option<u64> {
        self.samples.iter().filter_map(|s| s.measured.memory).min()
    }
}

fn or_dash(text: Option<String>) -> String {
    text.unwrap_or_else(|| "—".into())
}

impl Report {
    /// All tables.
    pub fn markdown(&self) -> String {
        let head = format!("Demeter {} on {}.\n\n", self.demeter, self.machine);
        head + &self.speed() + "\n" + &self.physics() + "\n" + &self.memory()
    }

    fn speed(&self) -> String {
        let mut text = String::from(
            "| workload | engine | threads | M particle-steps/s per core, median (min-max) | Demeter / it | by the clock | \
             second thread | candidates found | bytes per grain, program and all | other load |\n\
             |---|---|---|---|---|---|---|---|---|---|\n",
        );
        for outcome in &self.outcomes {
            for series in &outcome.series {
                text += &outcome.speed_row(series);
            }
        }
        text
    }

    fn physics(&self) -> String {
        let mut text = String::from(
            "| workload | engine | kinetic energy [J] | contacts per grain | force [N] on | deviations (tolerated) | same physics |\n\
             |---|---|---|---|---|---|---|\n",
        );
        for outcome in &self.outcomes {
            for series in &outcome.series {
                let Some(p) = series.physics else { continue };
                let verdict = series
                    .deviation
                    .map(|d| if d.agrees { "yes" } else { "**no**" }.to_owned());
                let deviations = series.deviation.map(|d| {
                    let t = series.tolerance;
                    let one = |by: f64, most: f64| format!("{:+.2} % ({:.0} %)", 100.0 * by, 100.0 * most);
                    let all = [
                        one(d.kinetic, t.kinetic),
                        one(d.contacts, t.contacts),
                        one(d.force, t.force),
                    ];
                    all.join(", ")
                });
                text += &format!(
                    "| {} | {} | {:.4e} | {:.4} | {:.4} on the {} | {} | {} |\n",
                    outcome.title,
                    series.engine,
                    p.kinetic,
                    p.contacts,
                    p.force,
                    outcome.bearing,
                    or_dash(deviations),
                    or_dash(verdict),
                );
            }
        }
        text
    }

    /// Marginal memory between the smallest and the largest bed of W6 that an engine ran.
    fn memory(&self) -> String {
        let mut text = String::from(
            "| engine | W6, from-to grains | bytes per grain more: peak of the run | peak of the loop |\n|---|---|---|---|\n",
        );
        let columns: Vec<&Outcome> = self.outcomes.iter().filter(|o| o.key.starts_with("w6")).collect();
        let mut engines: Vec<&str> = Vec::new();
        for series in columns.iter().flat_map(|o| &o.series).filter(|s| s.threads == 1) {
            if !engines.contains(&series.engine.as_str()) {
                engines.push(&series.engine);
            }
        }
        for engine in engines {
            let of = |o: &&Outcome| {
                let series = o.series.iter().find(|s| s.engine == engine && s.threads == 1)?;
                (!series.samples.is_empty()).then_some((o.grains, series.peak(), series.loop_peak()))
            };
            let sizes: Vec<_> = columns.iter().filter_map(of).collect();
            let (Some(small), Some(large)) = (sizes.first(), sizes.last()) else {
                continue;
            };
            if small.0 == large.0 {
                continue;
            }
            let more = |less: Option<u64>, much: Option<u64>| {
                let bytes = much? as f64 - less? as f64;
                Some(format!("{:.0}", bytes / (large.0 - small.0) as f64))
            };
            text += &format!(
                "| {engine} | {}-{} | {} | {} |\n",
                small.0,
                large.0,
                or_dash(more(small.1, large.1)),
                or_dash(more(small.2, large.2)),
            );
        }
        text
    }
}

impl Outcome {
    fn speed_row(&self, series: &Series) -> String {
        let same_threads = |s: &&Series| s.engine == "Demeter" && s.threads == series.threads;
        let demeter = self
            .series
            .iter()
            .find(same_threads)
            .filter(|_| series.engine != "Demeter");
        // by processor time on one thread, by the clock on more, where waiting counts
        let rate = |s: &Sample, of: &Series| if of.threads == 1 { s.per_core(1) } else { s.by_clock() };
        let ratio = demeter.and_then(|d| Spread::of(&d.ratios(series, rate)));
        let alone = self.series.iter().find(|s| s.engine == series.engine && s.threads == 1);
        let gain = alone.filter(|_| series.threads > 1);
        let gain = gain.and_then(|a| Spread::of(&series.ratios(a, |s, _| s.by_clock())));
        let known = series.samples.iter().all(|s| s.measured.cpu.is_some());
        let note = if known { "" } else { " by the clock" };
        let per_core = series.spread(|s| s.per_core(series.threads)).map(|s| s.shown(2) + note);
        let builds = series.samples.first().and_then(|s| s.measured.builds);
        let per_grain = series
            .peak()
            .map(|bytes| format!("{:.0}", bytes as f64 / self.grains as f64));
        format!(
            "| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |\n",
            self.title,
            series.engine,
            series.threads,
            series
                .fault
                .as_ref()
                .map_or_else(|| or_dash(per_core), |_| "**failed**".into()),
            or_dash(ratio.map(|s| s.shown(2))),
            or_dash(series.spread(Sample::by_clock).map(|s| s.shown(2))),
            or_dash(gain.map(|s| s.shown(2))),
            or_dash(builds.map(|b| b.to_string())),
            or_dash(per_grain),
            or_dash(
                Spread::of(&series.samples.iter().filter_map(|s| s.others).collect::<Vec<_>>())
                    .map(|s| format!("{:.2}", s.median))
            ),
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::agreement::{AT_REST, compare};

    fn sample(round: usize, cpu: f64, peak: u64, grains: usize) -> Sample {
        Sample {
            round,
            measured: Loop {
                seconds: 2.0 * cpu,
                cpu: Some(cpu),
                steps: 1000,
                grains,
                builds: Some(3),
                memory: Some(peak / 2),
            },
            peak: Some(peak),
            others: Some(0.5),
        }
    }

    fn series(engine: &str, threads: usize, samples: Vec<Sample>) -> Series {
        let physics = Physics {
            kinetic: 1.0,
            contacts: 2.0,
            force: if engine == "Demeter" { 3.0 } else { 3.3 },
        };
        let demeter = Physics { force: 3.0, ..physics };
        Series {
            engine: engine.into(),
            threads,
            samples,
            fault: None,
            physics: Some(physics),
            deviation: (engine != "Demeter").then(|| compare(&demeter, &physics, &AT_REST)),
            tolerance: AT_REST,
        }
    }

    fn report() -> Report {
        let of = |key: &str, grains: usize, peak: u64| Outcome {
            key: key.into(),
            title: key.to_uppercase(),
            grains,
            steps: 1000,
            bearing: "floor",
            series: vec![
                series(
                    "Demeter",
                    1,
                    vec![
                        sample(0, 1.0, peak, grains),
                        sample(1, 1.1, peak + 7, grains),
                        sample(2, 0.9, peak, grains),
                    ],
                ),
                series(
                    "Demeter",
                    2,
                    vec![sample(0, 1.0, peak, grains)].into_iter().map(faster).collect(),
                ),
                series(
                    "LIGGGHTS",
                    1,
                    vec![sample(2, 1.8, 3 * peak, grains), sample(0, 3.0, 3 * peak, grains)],
                ),
            ],
        };
        Report {
            machine: "a machine".into(),
            demeter: "1".into(),
            outcomes: vec![of("w6-10k", 10_000, 10_000_000), of("w6-50k", 50_000, 30_000_000)],
        }
    }

    fn faster(mut sample: Sample) -> Sample {
        sample.measured.seconds /= 1.9;
        sample
    }

    #[test]
    fn medians_and_their_range() {
        let found = Spread::of(&[3.0, 1.0, 2.0]).unwrap();
        assert_eq!((found.median, found.least, found.most), (2.0, 1.0, 3.0));
        assert_eq!(Spread::of(&[4.0, 1.0]).unwrap().median, 2.5);
        assert!(Spread::of(&[]).is_none());
    }

    #[test]
    fn ratios_are_paired_by_round() {
        let text = report().speed();
        // rounds 0 and 2: 3.0/1.0 and 1.8/0.9
        assert!(
            text.contains("| W6-10K | LIGGGHTS | 1 | 4.44 (3.33-5.56) | 2.50 (2.00-3.00) | 2.22 (1.67-2.78) |"),
            "{text}"
        );
        assert!(text.contains("| W6-10K | Demeter | 2 | 10.00 (10.00-10.00) | — | 9.50 (9.50-9.50) | 1.90 (1.90-1.90) | 3 | 1000 | 0.50 |"), "{text}");
    }

    #[test]
    fn disagreement_is_told() {
        let text = report().physics();
        assert!(
            text.contains("| W6-10K | Demeter | 1.0000e0 | 2.0000 | 3.0000 on the floor | — | — |"),
            "{text}"
        );
        assert!(
            text.contains("+0.00 % (10 %), +0.00 % (1 %), +10.00 % (3 %) | **no** |"),
            "{text}"
        );
    }

    #[test]
    fn memory_is_what_more_grains_need() {
        let text = report().memory();
        assert!(text.contains("| Demeter | 10000-50000 | 500 | 250 |"), "{text}");
        assert!(text.contains("| LIGGGHTS | 10000-50000 | 1500 | 750 |"), "{text}");
    }

    #[test]
    fn a_failure_is_told_in_its_row() {
        let mut report = report();
        report.outcomes[0].series[2].fault = Some("it crashed".into());
        report.outcomes[0].series[2].samples.clear();
        assert!(
            report
                .markdown()
                .contains("| W6-10K | LIGGGHTS | 1 | **failed** | — | — |"),
            "{}",
            report.markdown()
        );
    }
}
