//! The metrics of Brodu, Dijksman and Behringer (2015), section IV.

use super::cycles::{BEYOND, Level, Mean, Phase};
use super::strokes::Strokes;

/// A metric, or why it cannot be told.
pub type Metric<T> = Result<T, LeftOut>;

/// Why a metric is left out.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LeftOut(pub String);

fn left_out<T>(reason: impl Into<String>) -> Metric<T> {
    Err(LeftOut(reason.into()))
}

/// Thresholds on the forces of contacts for `errZ` [N].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Thresholds {
    /// Contacts of the run below it are left out, beside the threshold that fits best.
    pub run: Option<f64>,
    /// Contacts of the reference below it are left out, when it is a run.
    pub reference: f64,
}

/// A force of a run beside that of the reference.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pair {
    /// Loading or unloading.
    pub phase: Phase,
    /// Where.
    pub position: f64,
    /// The run.
    pub run: Mean,
    /// The reference.
    pub reference: Mean,
}

/// `Rtop`: the force of the run at the largest compression of the reference over the force of the reference there. Where a run goes on
/// beyond it, the force is that of its loading.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TopRatio {
    /// The ratio.
    pub value: f64,
    /// Standard deviation of the cycles of the run, over the force of the reference.
    pub deviation: Option<f64>,
    /// Number of cycles.
    pub cycles: usize,
    /// The largest compression.
    pub position: f64,
    /// Force of the reference there [N].
    pub reference: f64,
}

/// A root mean square over levels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Misfit {
    /// The root mean square.
    pub value: f64,
    /// Number of levels.
    pub levels: usize,
}

/// `errZ`: root mean square of the difference of contacts per grain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactMisfit {
    /// Threshold on the forces of the run [N].
    pub threshold: f64,
    /// The misfit.
    pub misfit: Misfit,
}

/// A run beside a reference.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    /// Ratio of the forces at the largest compression.
    pub rtop: Metric<TopRatio>,
    /// Root mean square of the difference of the forces over all levels of both phases [N].
    pub errf: Metric<Misfit>,
    /// Root mean square of the difference of contacts per grain, with the threshold that makes it least.
    pub errz: Metric<ContactMisfit>,
    /// The same with the threshold that was told; nothing when none was.
    pub errz_at: Option<Metric<ContactMisfit>>,
    /// `-log <B>` of the distributions of forces between grains, `B = integral sqrt(p q) df`, its mean over all levels.
    pub bhat: Metric<Misfit>,
    /// The forces that were compared.
    pub pairs: Vec<Pair>,
    /// What a reader should know.
    pub remarks: Vec<String>,
}

/// Compares a run with a reference, at the levels of the reference.
pub fn compare(run: &Strokes, reference: &Strokes, thresholds: Thresholds) -> Comparison {
    let mut remarks = Vec::new();
    if let Some(remark) = outside(run, reference) {
        remarks.push(remark);
    }
    let pairs = pairs(run, reference);
    let contacts = ContactLevels::of(run, reference, thresholds.reference);
    let (errz, errz_at) = match &contacts {
        Ok(levels) => (levels.least(), thresholds.run.map(|tau| levels.at(run, tau))),
        Err(reason) => (Err(reason.clone()), thresholds.run.map(|_| Err(reason.clone()))),
    };
    if let Ok(ContactMisfit { threshold, .. }) = errz
        && run.bins.as_ref().and_then(|b| b.edges().last()) == Some(&threshold)
    {
        remarks.push(format!(
            "errZ is least at the upper end of the force bins, {threshold} N; wider bins may fit better"
        ));
    }
    Comparison {
        rtop: rtop(run, reference),
        errf: errf(&pairs),
        errz,
        errz_at,
        bhat: bhat(run, reference, &mut remarks),
        pairs,
        remarks,
    }
}

/// Levels of the reference, with what the run is there.
fn beside<'a>(run: &'a Strokes, reference: &'a Strokes) -> impl Iterator<Item = (Phase, &'a Level, Option<Level>)> {
    Phase::ALL.into_iter().flat_map(move |phase| {
        let levels = reference.levels(phase).iter();
        levels.map(move |level| (phase, level, run.at(phase, level.position)))
    })
}

/// Tells how many levels of the reference the run does not reach.
fn outside(run: &Strokes, reference: &Strokes) -> Option<String> {
    let all = reference.loading.len() + reference.unloading.len();
    let missing = beside(run, reference).filter(|(_, _, level)| level.is_none()).count();
    (missing > 0).then(|| {
        format!("{missing} of {all} levels of the reference lie outside of the strokes of the run and are left out")
    })
}

fn pairs(run: &Strokes, reference: &Strokes) -> Vec<Pair> {
    beside(run, reference)
        .filter_map(|(phase, level, run)| {
            Some(Pair {
                phase,
                position: level.position,
                run: run?.force?,
                reference: level.force?,
            })
        })
        .collect()
}

fn errf(pairs: &[Pair]) -> Metric<Misfit> {
    match root_mean_square(pairs.iter().map(|pair| pair.run.value - pair.reference.value)) {
        Some(misfit) => Ok(misfit),
        None => left_out("the run and the reference have no level in common at which both tell a force"),
    }
}

fn root_mean_square(differences: impl Iterator<Item = f64>) -> Option<Misfit> {
    let (sum, levels) = differences.fold((0.0, 0), |(sum, n), x| (sum + x * x, n + 1));
    (levels > 0).then(|| Misfit {
        value: (sum / levels as f64).sqrt(),
        levels,
    })
}

fn rtop(run: &Strokes, reference: &Strokes) -> Metric<TopRatio> {
    let tops = Phase::ALL.map(|phase| reference.top(phase, |level| level.force.is_some()));
    let Some(top) = highest(tops, reference) else {
        return left_out("the reference tells no force");
    };
    // a run that goes on beyond it unloads there with less than it was loaded with
    let ends = Phase::ALL.map(|phase| run.top(phase, |level| level.force.is_some()));
    let turns_there = highest(ends, run).is_none_or(|end| is_at(top, end, run));
    let mut both: Vec<(Mean, Mean)> = Vec::new();
    for (phase, level) in Phase::ALL.into_iter().zip(tops) {
        if phase == Phase::Unloading && !turns_there && !both.is_empty() {
            continue;
        }
        let Some(level) = level.filter(|level| is_at(level, top, reference)) else {
            continue;
        };
        let here = run.at(phase, level.position).and_then(|found| found.force);
        both.extend(here.zip(level.force));
    }
    let n = both.len() as f64;
    let force = both.iter().map(|(_, reference)| reference.value).sum::<f64>() / n;
    if both.is_empty() {
        let name = run.position.name();
        return left_out(format!(
            "the run does not reach the largest {name} of the reference, {}",
            top.position
        ));
    }
    if force <= 0.0 {
        return left_out(format!(
            "the force of the reference at the top is {force} N, not above 0"
        ));
    }
    // the force at the turn is one and the same in both phases, so that their deviations do not average out
    let deviations: Option<Vec<f64>> = both.iter().map(|(run, _)| run.deviation).collect();
    Ok(TopRatio {
        value: both.iter().map(|(run, _)| run.value).sum::<f64>() / n / force,
        deviation: deviations.map(|d| d.iter().sum::<f64>() / n / force),
        cycles: both.iter().map(|(run, _)| run.cycles).min().unwrap_or(0),
        position: top.position,
        reference: force,
    })
}

/// The level of largest compression of both phases.
fn highest<'a>(tops: [Option<&'a Level>; 2], reference: &Strokes) -> Option<&'a Level> {
    let [loading, unloading] = tops;
    if reference.position == super::Position::StageTime {
        return loading.or(unloading);
    }
    let all = loading.into_iter().chain(unloading);
    all.max_by(|a, b| a.position.total_cmp(&b.position))
}

/// Whether a level is at the top of both phases.
fn is_at(level: &Level, top: &Level, reference: &Strokes) -> bool {
    let positions = || {
        Phase::ALL
            .into_iter()
            .flat_map(|p| reference.levels(p))
            .map(|l| l.position)
    };
    let (low, high) = (
        positions().fold(f64::INFINITY, f64::min),
        positions().fold(f64::NEG_INFINITY, f64::max),
    );
    reference.position == super::Position::StageTime || top.position - level.position <= BEYOND * (high - low)
}

/// Contacts per grain of the run above every edge of the bins, beside those of the reference.
struct ContactLevels {
    edges: Vec<f64>,
    /// The run at a level, and `Z` of the reference there.
    levels: Vec<(Level, f64)>,
}

impl ContactLevels {
    fn of(run: &Strokes, reference: &Strokes, threshold: f64) -> Metric<Self> {
        let Some(bins) = &run.bins else {
            return left_out(
                "the run has no force distribution; its scenario needs a [[measure]] of kind \"force-distribution\"",
            );
        };
        let coordination = |level: &Level| match (&level.contacts, &reference.bins) {
            (Some(contacts), Some(bins)) => contacts.coordination(bins, threshold),
            _ => level.coordination,
        };
        if !(reference.loading.iter().chain(&reference.unloading)).any(|level| coordination(level).is_some()) {
            return left_out(match (&reference.bins, reference.cycles) {
                (Some(_), _) => format!("the bins of the reference end below its threshold of {threshold} N"),
                (None, Some(_)) => "the reference has no force distribution".to_string(),
                (None, None) => "the reference tells no coordination".to_string(),
            });
        }
        let levels: Vec<(Level, f64)> = beside(run, reference)
            .filter_map(|(_, level, found)| {
                let found = found.filter(|f| f.contacts.as_ref().is_some_and(|c| c.grains > 0.0))?;
                Some((found, coordination(level)?))
            })
            .collect();
        if levels.is_empty() {
            return left_out("the run and the reference have no level in common at which both tell contacts");
        }
        Ok(Self {
            edges: bins.edges().to_vec(),
            levels,
        })
    }

    /// The edge of a bin that makes the misfit least; of equal ones the lowest.
    fn least(&self) -> Metric<ContactMisfit> {
        let mut sums = vec![0.0; self.edges.len()];
        for (run, reference) in &self.levels {
            let all = run.contacts.iter().flat_map(|contacts| contacts.coordinations());
            for (sum, z) in sums.iter_mut().zip(all) {
                *sum += (z - reference) * (z - reference);
            }
        }
        let mut least = 0;
        for (k, sum) in sums.iter().enumerate() {
            if *sum < sums[least] {
                least = k;
            }
        }
        let levels = self.levels.len();
        Ok(ContactMisfit {
            threshold: self.edges[least],
            misfit: Misfit {
                value: (sums[least] / levels as f64).sqrt(),
                levels,
            },
        })
    }

    fn at(&self, run: &Strokes, threshold: f64) -> Metric<ContactMisfit> {
        let z = |level: &Level| (level.contacts.as_ref()?).coordination(run.bins.as_ref()?, threshold);
        let differences = self
            .levels
            .iter()
            .filter_map(|(level, reference)| Some(z(level)? - reference));
        match root_mean_square(differences) {
            Some(misfit) => Ok(ContactMisfit { threshold, misfit }),
            None => left_out(format!(
                "the force bins of the run end below the threshold of {threshold} N"
            )),
        }
    }
}

/// Share of contacts above all bins that a reader is told of.
const MANY_ABOVE: f64 = 1e-3;

fn bhat(run: &Strokes, reference: &Strokes, remarks: &mut Vec<String>) -> Metric<Misfit> {
    let (Some(bins), Some(others)) = (&run.bins, &reference.bins) else {
        let which = if run.bins.is_none() { "run" } else { "reference" };
        return left_out(format!("the {which} has no force distribution"));
    };
    if !same(bins.edges(), others.edges()) {
        let told = |edges: &[f64]| format!("{} from {} to {} N", edges.len() - 1, edges[0], edges[edges.len() - 1]);
        return left_out(format!(
            "the bins of the forces differ: the run has {}, the reference {}",
            told(bins.edges()),
            told(others.edges())
        ));
    }
    let both = beside(run, reference).filter_map(|(_, level, run)| Some((run?.contacts?, level.contacts.as_ref()?)));
    let (mut sum, mut levels, mut above) = (0.0, 0, 0.0f64);
    for (run, reference) in both {
        for contacts in [&run, reference] {
            let all: f64 = contacts.pairs.iter().sum();
            above = above.max(contacts.pairs.last().copied().unwrap_or(0.0) / all.max(1.0));
        }
        if let Some(overlap) = run.overlap_of_forces(reference) {
            sum += overlap;
            levels += 1;
        }
    }
    if above > MANY_ABOVE {
        remarks.push(format!(
            "up to {:.1} % of the contacts are above the force bins and count as one bin in bhat; raise `upper`",
            100.0 * above
        ));
    }
    if levels == 0 {
        return left_out("there is no level at which both have contacts between grains");
    }
    if sum <= 0.0 {
        return left_out("the distributions of forces have no force in common: bhat is infinite");
    }
    Ok(Misfit {
        // a mean above 1 is rounding; 0 without a sign
        value: 0.0 - libm::log((sum / f64::from(levels)).min(1.0)),
        levels: levels as usize,
    })
}

/// Whether bins are the same but for the rounding of their titles.
fn same(a: &[f64], b: &[f64]) -> bool {
    let scale = a.iter().fold(0.0, |largest: f64, x| largest.max(x.abs()));
    a.len() == b.len() && a.iter().zip(b).all(|(x, y)| (x - y).abs() <= 1e-9 * scale)
}
