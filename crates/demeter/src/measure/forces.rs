//! How often contacts carry which normal force.

use super::told_first::{Acting, each, own_pairs, own_with_walls};
use crate::simulation::Simulation;

/// Most bins of a distribution.
pub const MAX_BINS: usize = 100_000;

/// Digits to which the edges of bins are rounded, so that `6 x 0.5 mN` is 0.003 and not 0.0030000000000000005.
const EDGE_DIGITS: usize = 12;

/// Share of a bin by which rounding may miss the upper end.
const AT_THE_END: f64 = 1e-6;

/// Why no bins can be made.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum BinsError {
    /// A value that is not a number, or a bin without width.
    #[error("bins from {lower} N to {upper} N, each {bin} N wide: they must be finite, and the width above 0")]
    NotFinite {
        /// Lower end of the first bin [N].
        lower: f64,
        /// Upper end of the last bin [N].
        upper: f64,
        /// Width [N].
        bin: f64,
    },
    /// The ends are not in order.
    #[error("the bins begin at {lower} N and end at {upper} N; they must end above their beginning")]
    Reversed {
        /// Lower end of the first bin [N].
        lower: f64,
        /// Upper end of the last bin [N].
        upper: f64,
    },
    /// No bin ends at the upper end.
    #[error(
        "bins of {bin} N from {lower} N do not end at {upper} N, but at {before} N and {after} N: give one of these, or a width \
         that divides the distance"
    )]
    NotWhole {
        /// Lower end of the first bin [N].
        lower: f64,
        /// Upper end of the last bin [N].
        upper: f64,
        /// Width [N].
        bin: f64,
        /// Where a bin ends next to it, but for the lower end [N].
        before: f64,
        /// Where the bin behind that one ends [N].
        after: f64,
    },
    /// Too many.
    #[error(
        "{count:.3e} bins of {bin} N from {lower} N to {upper} N are too many; at most {MAX_BINS} are allowed, so make them wider"
    )]
    TooMany {
        /// How many they would be.
        count: f64,
        /// Lower end of the first bin [N].
        lower: f64,
        /// Upper end of the last bin [N].
        upper: f64,
        /// Width [N].
        bin: f64,
    },
    /// The edges of a bin are the same number.
    #[error(
        "bins of {bin:e} N at forces up to {largest} N have edges that 12 digits do not tell apart; make them wider"
    )]
    TooNarrow {
        /// Largest magnitude of an end [N].
        largest: f64,
        /// Width [N].
        bin: f64,
    },
}

/// Bins of equal width for the normal forces of contacts.
#[derive(Clone, Debug, PartialEq)]
pub struct ForceDistribution {
    /// Lower edge of every bin and the upper edge of the last [N].
    edges: Vec<f64>,
}

/// Normal forces of one kind of contacts, counted by bins.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ForceHistogram {
    /// Contacts that act; those below the first bin, too, which are in no bin.
    pub contacts: u64,
    /// Sum of their normal forces, repulsion positive [N].
    pub sum: f64,
    /// Contacts in every bin; the lower edge belongs to a bin, the upper one to the next.
    pub counts: Vec<u64>,
    /// Contacts at the upper edge of the last bin and above.
    pub above: u64,
}

impl ForceDistribution {
    /// Bins of a width from `lower` to `upper` [N], which the width must divide. Edges are rounded to 12 digits.
    pub fn new(lower: f64, upper: f64, bin: f64) -> Result<Self, BinsError> {
        if !(lower.is_finite() && upper.is_finite() && bin.is_finite() && bin > 0.0) {
            return Err(BinsError::NotFinite { lower, upper, bin });
        }
        if upper <= lower {
            return Err(BinsError::Reversed { lower, upper });
        }
        let bins = (upper - lower) / bin;
        let count = bins.round().max(1.0);
        if count > MAX_BINS as f64 {
            return Err(BinsError::TooMany {
                count,
                lower,
                upper,
                bin,
            });
        }
        let edge = |k: f64| rounded(lower + k * bin);
        let edges: Vec<f64> = (0..=count as u32).map(|k| edge(f64::from(k))).collect();
        if edges.windows(2).any(|pair| pair[0] >= pair[1]) || edges.iter().any(|e| !e.is_finite()) {
            let largest = lower.abs().max(upper.abs());
            return Err(BinsError::TooNarrow { largest, bin });
        }
        if (bins - count).abs() > AT_THE_END {
            let whole = bins.floor().max(1.0);
            return Err(BinsError::NotWhole {
                lower,
                upper,
                bin,
                before: edge(whole),
                after: edge(whole + 1.0),
            });
        }
        Ok(Self { edges })
    }

    /// Lower edge of every bin and the upper edge of the last [N].
    pub fn edges(&self) -> &[f64] {
        &self.edges
    }

    /// Counts the contacts between grains and those with walls.
    pub fn measure(&self, sim: &Simulation) -> [ForceHistogram; 2] {
        let [mut grains, mut walls] = [(); 2].map(|()| self.empty());
        let force = |contact: Acting<'_>| contact.normal_force();
        each(sim, own_pairs(sim).map(force), |force| self.add(&mut grains, force));
        each(sim, own_with_walls(sim).map(force), |force| self.add(&mut walls, force));
        [grains, walls]
    }

    /// Counts forces [N].
    pub fn count(&self, forces: impl IntoIterator<Item = f64>) -> ForceHistogram {
        let mut histogram = self.empty();
        forces.into_iter().for_each(|force| self.add(&mut histogram, force));
        histogram
    }

    fn empty(&self) -> ForceHistogram {
        ForceHistogram {
            counts: vec![0; self.edges.len() - 1],
            ..ForceHistogram::default()
        }
    }

    fn add(&self, histogram: &mut ForceHistogram, force: f64) {
        histogram.contacts += 1;
        histogram.sum += force;
        // edges at or below the force
        match self.edges.partition_point(|edge| *edge <= force) {
            0 => {}
            above if above >= self.edges.len() => histogram.above += 1,
            bin => histogram.counts[bin - 1] += 1,
        }
    }
}

/// A number to [`EDGE_DIGITS`] digits.
pub(super) fn rounded(x: f64) -> f64 {
    format!("{x:.*e}", EDGE_DIGITS - 1).parse().unwrap_or(x)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_force_is_in_the_bin_that_its_title_says() {
        let bins = ForceDistribution::new(0.0, 0.3, 0.0005).unwrap();
        assert_eq!(bins.edges().len(), 601);
        for (k, &edge) in bins.edges().iter().enumerate() {
            let decimal: f64 = format!("{}e-4", 5 * k).parse().unwrap();
            assert_eq!(edge.to_bits(), decimal.to_bits(), "edge {k}");
            if k < 600 {
                assert_eq!(bins.count([edge]).counts[k], 1);
            }
            if k > 0 {
                assert_eq!(bins.count([edge.next_down()]).counts[k - 1], 1);
            }
        }
        let all = bins.count([0.0001, 0.0006, 0.00069, 0.3, 7.0, -0.1]);
        assert_eq!((all.contacts, all.above), (6, 2));
        assert_eq!(all.counts[..2], [1, 2]);
        assert_eq!(all.counts.iter().sum::<u64>(), 3, "what pulls is in no bin");
        assert!((all.sum - 7.20139).abs() < 1e-14);
        let none = bins.count([]);
        assert_eq!((none.contacts, none.sum.to_bits(), none.above), (0, 0, 0));
    }

    #[test]
    fn bins_may_begin_below_zero() {
        let bins = ForceDistribution::new(-1e-3, 2e-3, 1e-3).unwrap();
        assert_eq!(bins.edges(), [-1e-3, 0.0, 1e-3, 2e-3]);
        assert_eq!(bins.count([-1e-3, -1e-4, 1.9e-3]).counts, [2, 0, 1]);
    }

    #[test]
    fn the_last_bin_ends_at_the_upper_end() {
        let refused = |lower, upper, bin| ForceDistribution::new(lower, upper, bin).unwrap_err();
        for (upper, ends) in [
            (1.0, "0.9 N and 1.2 N"),
            (1e-9, "0.3 N and 0.6 N"),
            (0.29, "0.3 N and 0.6 N"),
        ] {
            let told = refused(0.0, upper, 0.3).to_string();
            assert!(told.contains(ends), "{told}");
        }
        // far from zero and narrow: the quotient is off by rounding
        for (lower, upper, bin, count) in [(1000.0, 1001.0, 1e-5, 100_000), (0.1, 0.7, 0.2, 3), (0.0, 1.0, 0.1, 10)] {
            let bins = ForceDistribution::new(lower, upper, bin).unwrap();
            assert_eq!((bins.edges().len(), bins.edges()[count]), (count + 1, upper));
        }
    }

    #[test]
    fn bins_that_make_no_sense_are_refused() {
        let refused = |lower, upper, bin| ForceDistribution::new(lower, upper, bin).unwrap_err();
        assert!(matches!(refused(0.0, 1.0, 0.0), BinsError::NotFinite { .. }));
        assert!(matches!(refused(0.0, f64::NAN, 1.0), BinsError::NotFinite { .. }));
        assert!(matches!(refused(1.0, 1.0, 1.0), BinsError::Reversed { .. }));
        assert!(matches!(refused(0.0, 1.0, 9.9e-6), BinsError::TooMany { .. }));
        assert!(matches!(refused(-1e308, 1e308, 1e307), BinsError::TooMany { .. }));
        assert!(matches!(refused(1.0, 1.0 + 1e-10, 1e-14), BinsError::TooNarrow { .. }));
        assert_eq!(
            ForceDistribution::new(0.0, 1.0, 1e-5).unwrap().edges().len(),
            MAX_BINS + 1
        );
    }
}
