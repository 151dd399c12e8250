//! Distributions of contact forces: histograms of a run's contacts over bins of force, by step.

use super::error::CompareError;
use crate::output::distribution::{ABOVE, COLUMNS};
use crate::results::ResultsError;
use crate::results::rows::{Table, column_name};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// Largest file of distributions that is read [bytes].
const MAX_SIZE: u64 = 8 << 30;
/// Largest number of counts that are kept.
const MAX_COUNTS: usize = 1 << 27;
/// Share of a bin within which a threshold is taken to stand at its edge: both are rounded.
const AT_THE_EDGE: f64 = 1e-9;

/// Bins of force: the edges, ascending [N].
#[derive(Clone, Debug, PartialEq)]
pub struct Bins(Vec<f64>);

impl Bins {
    /// Bins between ascending edges [N]; nothing when there are fewer than two, or they do not ascend.
    pub fn new(edges: Vec<f64>) -> Option<Self> {
        let ascending = edges.windows(2).all(|w| w[0] < w[1]);
        (edges.len() > 1 && ascending && edges.iter().all(|e| e.is_finite())).then_some(Self(edges))
    }

    /// The edges, one more than there are bins [N].
    pub fn edges(&self) -> &[f64] {
        &self.0
    }

    /// Number of bins.
    pub fn count(&self) -> usize {
        self.0.len() - 1
    }

    /// Bin that a threshold stands in, and the share of that bin above the threshold.
    fn place(&self, threshold: f64) -> Option<(usize, f64)> {
        let edges = &self.0;
        let (lowest, highest) = (edges[0], edges[self.count()]);
        let slack = AT_THE_EDGE * (highest - lowest);
        if threshold <= lowest {
            return Some((0, 1.0));
        }
        if threshold >= highest {
            return (threshold <= highest + slack).then_some((self.count(), 1.0));
        }
        let bin = edges.partition_point(|edge| *edge <= threshold) - 1;
        let above = (edges[bin + 1] - threshold) / (edges[bin + 1] - edges[bin]);
        if above < AT_THE_EDGE {
            return Some((bin + 1, 1.0));
        }
        Some((bin, if above > 1.0 - AT_THE_EDGE { 1.0 } else { above }))
    }
}

/// Contacts of a packing, counted by force; a mean over cycles, so that counts need not be whole.
#[derive(Clone, Debug, PartialEq)]
pub struct Contacts {
    /// Number of grains.
    pub grains: f64,
    /// Contacts between grains in every bin, and last those above all bins.
    pub pairs: Vec<f64>,
    /// Contacts with walls, alike.
    pub walls: Vec<f64>,
}

impl Contacts {
    /// No contacts of no grains.
    pub(super) fn none(bins: &Bins) -> Self {
        Self {
            grains: 0.0,
            pairs: vec![0.0; bins.count() + 1],
            walls: vec![0.0; bins.count() + 1],
        }
    }

    /// Adds others with a weight.
    pub(super) fn add(&mut self, other: &CountedContacts, weight: f64) {
        self.grains += weight * f64::from(other.grains);
        let add = |to: &mut [f64], from: &[u32]| {
            for (sum, count) in to.iter_mut().zip(from) {
                *sum += weight * f64::from(*count);
            }
        };
        add(&mut self.pairs, &other.pairs);
        add(&mut self.walls, &other.walls);
    }

    /// Those between two states, `weight` of the way from this to the other.
    pub(super) fn between(&self, other: &Self, weight: f64) -> Self {
        let mix = |a: f64, b: f64| (1.0 - weight) * a + weight * b;
        let all = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| mix(*a, *b)).collect();
        Self {
            grains: mix(self.grains, other.grains),
            pairs: all(&self.pairs, &other.pairs),
            walls: all(&self.walls, &other.walls),
        }
    }

    /// Mean number of contacts per grain, `Z = (2 pairs + wall contacts)/grains`, when contacts weaker than the
    /// threshold [N] are left out. Within a bin the contacts are taken to be spread evenly. Nothing without grains, and
    /// for a threshold above all bins.
    pub fn coordination(&self, bins: &Bins, threshold: f64) -> Option<f64> {
        let (bin, share) = bins.place(threshold)?;
        let above = |counts: &[f64]| {
            let first = counts.get(bin).copied().unwrap_or(0.0);
            share * first + counts.iter().skip(bin + 1).sum::<f64>()
        };
        (self.grains > 0.0).then(|| (2.0 * above(&self.pairs) + above(&self.walls)) / self.grains)
    }

    /// `Z` above every edge.
    pub(super) fn coordinations(&self) -> Vec<f64> {
        let mut sum = 0.0;
        let mut all: Vec<f64> = (self.pairs.iter().zip(&self.walls).rev())
            .map(|(pairs, walls)| {
                sum += 2.0 * pairs + walls;
                sum / self.grains
            })
            .collect();
        all.reverse();
        all
    }

    /// `B = integral sqrt(p q) df` over the densities `p`, `q` of the forces between grains (Brodu, Dijksman and Behringer
    /// 2015, section IV), the contacts above all bins as one more bin. Nothing where one of them has no contact.
    pub fn overlap_of_forces(&self, other: &Self) -> Option<f64> {
        let (all, all_other) = (self.pairs.iter().sum::<f64>(), other.pairs.iter().sum::<f64>());
        let common: f64 = (self.pairs.iter().zip(&other.pairs)).map(|(a, b)| (a * b).sqrt()).sum();
        (all > 0.0 && all_other > 0.0).then(|| common / (all * all_other).sqrt())
    }
}

/// Contacts of one row.
#[derive(Clone, Debug)]
pub(super) struct CountedContacts {
    grains: u32,
    pairs: Vec<u32>,
    walls: Vec<u32>,
}

/// Distributions of a run.
#[derive(Debug)]
pub(super) struct Forces {
    pub path: PathBuf,
    pub bins: Bins,
    rows: BTreeMap<u64, CountedContacts>,
}

impl Forces {
    /// Reads the distributions of these steps; nothing when the run has none and none was named.
    pub fn read(folder: &Path, name: Option<&str>, steps: &BTreeSet<u64>) -> Result<Option<Self>, CompareError> {
        let Some(path) = find(folder, name)? else {
            return Ok(None);
        };
        let mut table = Table::open(&path, MAX_SIZE, true)?;
        let bins = bins(&table)?;
        let (grains, between) = (table.required("grains")?, table.required("between")?);
        let mut rows: BTreeMap<u64, CountedContacts> = BTreeMap::new();
        while let Some(row) = table.next()? {
            let step: u64 = row.count(0)?;
            if !steps.contains(&step) {
                continue;
            }
            let told = match row.text(between) {
                "grains" => 0,
                "walls" => 1,
                _ => return Err(row.fault(between, "`grains` or `walls`").into()),
            };
            let count = |column| row.count::<u32>(column);
            let counts: Vec<u32> = (COLUMNS.len()..COLUMNS.len() + bins.count() + 1)
                .map(count)
                .collect::<Result<_, _>>()?;
            let grains = count(grains)?;
            let entry = rows.entry(step).or_insert_with(|| CountedContacts {
                grains,
                pairs: Vec::new(),
                walls: Vec::new(),
            });
            *(if told == 0 { &mut entry.pairs } else { &mut entry.walls }) = counts;
            if rows.len().saturating_mul(2 * (bins.count() + 1)) > MAX_COUNTS {
                let allowed = MAX_COUNTS;
                return Err(CompareError::TooManyCounts { path, allowed });
            }
        }
        let whole = |row: &CountedContacts| !row.pairs.is_empty() && !row.walls.is_empty();
        if let Some(step) = steps.iter().find(|step| !rows.get(step).is_some_and(whole)) {
            return Err(CompareError::NoRow { path, step: *step });
        }
        Ok(Some(Self { path, bins, rows }))
    }

    /// Contacts at a step that was asked for.
    pub fn at(&self, step: u64) -> Result<&CountedContacts, CompareError> {
        self.rows.get(&step).ok_or_else(|| CompareError::NoRow {
            path: self.path.clone(),
            step,
        })
    }
}

/// The file of distributions, by name or the only one.
fn find(folder: &Path, name: Option<&str>) -> Result<Option<PathBuf>, CompareError> {
    let place = folder.join("distributions");
    let mut files: Vec<PathBuf> = match std::fs::read_dir(&place) {
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => Vec::new(),
        entries => (entries.map_err(ResultsError::io(&place))?)
            .map(|entry| entry.map(|e| e.path()))
            .collect::<Result<_, _>>()
            .map_err(ResultsError::io(&place))?,
    };
    files.retain(|path| path.extension().is_some_and(|e| e == "csv"));
    files.sort();
    let stem = |path: &PathBuf| path.file_stem().map(|s| s.to_string_lossy().into_owned());
    let names: Vec<String> = files.iter().filter_map(stem).map(|n| format!("`{n}`")).collect();
    let refuse = |problem: String| CompareError::Distribution {
        folder: folder.to_owned(),
        problem,
    };
    let Some(name) = name else {
        return match files.as_slice() {
            [] | [_] => Ok(files.pop()),
            _ => Err(refuse(format!(
                "holds {} force distributions, {}: tell which with `--distribution NAME`",
                files.len(),
                names.join(", ")
            ))),
        };
    };
    match files.iter().find(|path| stem(path).is_some_and(|s| s == name)) {
        Some(path) => Ok(Some(path.clone())),
        None if names.is_empty() => Err(refuse(format!(
            "holds no force distribution `{name}`: the scenario needs a [[measure]] of kind \"force-distribution\""
        ))),
        None => Err(refuse(format!(
            "holds no force distribution `{name}`; there are {}",
            names.join(", ")
        ))),
    }
}

/// The bins, from the titles of the columns: every count is under the lower edge of its bin.
fn bins(table: &Table) -> Result<Bins, ResultsError> {
    let refuse = |problem: String| ResultsError::Table {
        path: table.path().to_owned(),
        problem,
    };
    let header = table.header();
    let begins = header.len() > COLUMNS.len() + 1 && header.iter().zip(COLUMNS).all(|(title, first)| title == first);
    if !begins || header.last().is_none_or(|last| last != ABOVE) {
        let columns = COLUMNS.join(",");
        return Err(refuse(format!(
            "not a force distribution: its columns must be `{columns}`, lower edges of bins as `0.001 [N]`, `{ABOVE}`"
        )));
    }
    let titles = &header[COLUMNS.len()..header.len() - 1];
    let mut edges = Vec::with_capacity(titles.len() + 1);
    for title in titles {
        let edge = column_name(title).parse().map_err(|_| {
            let shown: String = title.chars().take(40).collect();
            refuse(format!(
                "the column `{shown}` should be titled by the lower edge of its bin, as `0.001 [N]`"
            ))
        })?;
        edges.push(edge);
    }
    // the last bin is as wide as the one before it
    let width = match edges.as_slice() {
        [.., a, b] => b - a,
        _ => return Err(refuse("one bin is too few; at least 2 are needed".to_string())),
    };
    edges.push(edges[edges.len() - 1] + width);
    Bins::new(edges).ok_or_else(|| refuse("the edges of the bins do not ascend".to_string()))
}
