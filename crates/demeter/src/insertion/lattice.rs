//! Grains on a lattice.

use super::random::{Purpose, RandomNumbers};
use super::region::Space;
use super::size_distribution::SizeSampler;
use super::spec::LatticeKind;
use super::{MAX_GRAINS, SizedPlace};
use glam::DVec3;
use thiserror::Error;

/// Largest jitter, as share of the spacing.
const MAX_JITTER: f64 = 0.5;
/// Shifts tried for a site before it stays unshifted.
const SHIFTS: u32 = 100;

/// Why a lattice cannot be made.
#[derive(Clone, Debug, PartialEq, Error)]
#[allow(missing_docs)]
pub enum LatticeError {
    #[error("lattice: the spacing is {value} m; it must be positive and finite")]
    Spacing { value: f64 },
    #[error("lattice: the jitter is {value}; allowed are 0 to 0.5 (of the spacing)")]
    Jitter { value: f64 },
    #[error("lattice: the region has about {sites:.0} sites; at most {MAX_GRAINS} are possible; widen the spacing")]
    TooManySites { sites: f64 },
    #[error("lattice: the region holds no site with room for a grain; enlarge it or lower the spacing or the diameter")]
    NoSites,
}

/// What tells one lattice from another.
pub(super) struct Lattice {
    pub(super) kind: LatticeKind,
    pub(super) spacing: f64,
    pub(super) jitter: f64,
    pub(super) count: Option<u32>,
}

/// Edges of the rectangular cell over the distance of nearest neighbours, and its sites as shares of the edges,
/// in layers along z and rows along y.
fn cell(kind: LatticeKind) -> (DVec3, &'static [DVec3]) {
    const fn site(x: f64, y: f64, z: f64) -> DVec3 {
        DVec3::new(x, y, z)
    }
    const SIMPLE: [DVec3; 1] = [site(0.0, 0.0, 0.0)];
    const BCC: [DVec3; 2] = [site(0.0, 0.0, 0.0), site(0.5, 0.5, 0.5)];
    const FCC: [DVec3; 4] = [
        site(0.0, 0.0, 0.0),
        site(0.5, 0.5, 0.0),
        site(0.5, 0.0, 0.5),
        site(0.0, 0.5, 0.5),
    ];
    const HCP: [DVec3; 4] = [
        site(0.0, 0.0, 0.0),
        site(0.5, 0.5, 0.0),
        site(0.5, 1.0 / 6.0, 0.5),
        site(0.0, 2.0 / 3.0, 0.5),
    ];
    match kind {
        LatticeKind::SimpleCubic => (DVec3::ONE, &SIMPLE),
        LatticeKind::Bcc => (DVec3::splat(2.0 / libm::sqrt(3.0)), &BCC),
        LatticeKind::Fcc => (DVec3::splat(libm::sqrt(2.0)), &FCC),
        LatticeKind::Hcp => (DVec3::new(1.0, libm::sqrt(3.0), libm::sqrt(8.0 / 3.0)), &HCP),
    }
}

impl Lattice {
    /// Grains at the sites of a region, layer by layer from the lowest z.
    ///
    /// The first site is half a spacing from the lower sides of the region, so that grains as large as the spacing
    /// touch them; along periodic directions there are whole cells only, so that the lattice does not meet itself.
    /// Sites without room for their grain stay empty, and a shift that would push a grain out is drawn again. Other
    /// grains are not looked at: large grains, large jitter and regions in use can give overlaps.
    pub(super) fn fill(&self, space: &Space, sizes: &SizeSampler, seed: u64) -> Result<Vec<SizedPlace>, LatticeError> {
        self.check()?;
        let (edges, sites) = cell(self.kind);
        let edges = edges * self.spacing;
        let (first, cells) = self.cells(space, edges, sites.len())?;
        let mut draw_size = RandomNumbers::new(seed, Purpose::Sizes);
        let mut draw_shift = RandomNumbers::new(seed, Purpose::Places);
        let most = self.count.unwrap_or(MAX_GRAINS) as usize;
        let mut grains = Vec::new();
        let mut layers: Vec<f64> = sites.iter().map(|s| s.z).collect();
        layers.dedup();
        for kz in 0..cells[2] {
            for layer in &layers {
                for ky in 0..cells[1] {
                    for site in sites.iter().filter(|s| s.z == *layer) {
                        for kx in 0..cells[0] {
                            if grains.len() >= most {
                                return Ok(grains);
                            }
                            let cell = DVec3::new(kx as f64, ky as f64, kz as f64);
                            let radius = 0.5 * sizes.draw(&mut draw_size);
                            let place = space.wrap(first + (cell + *site) * edges);
                            if space.holds(place, radius) {
                                let place = self.shifted(space, place, radius, &mut draw_shift);
                                grains.push((space.settle(place, radius), radius));
                            }
                        }
                    }
                }
            }
        }
        match grains.is_empty() {
            true => Err(LatticeError::NoSites),
            false => Ok(grains),
        }
    }

    fn check(&self) -> Result<(), LatticeError> {
        if !(self.spacing > 0.0 && self.spacing.is_finite()) {
            return Err(LatticeError::Spacing { value: self.spacing });
        }
        if !(0.0..=MAX_JITTER).contains(&self.jitter) {
            return Err(LatticeError::Jitter { value: self.jitter });
        }
        Ok(())
    }

    /// First site and number of cells in each direction.
    fn cells(&self, space: &Space, edges: DVec3, sites: usize) -> Result<(DVec3, [u64; 3]), LatticeError> {
        // So that rounding does not lose the last site of a region that is an exact multiple of the spacing.
        const ROUNDING: f64 = 1e-9;
        let (lower, upper) = space.bounds();
        let first = lower + DVec3::splat(0.5 * self.spacing);
        let cells: [f64; 3] = std::array::from_fn(|k| match space.is_periodic(k) {
            true => ((upper[k] - lower[k]) / edges[k] + ROUNDING).floor(),
            false => ((upper[k] - first[k]) / edges[k] + ROUNDING).floor() + 1.0,
        });
        let cells = cells.map(|n| n.max(0.0));
        let total = cells[0] * cells[1] * cells[2] * sites as f64;
        if total > f64::from(MAX_GRAINS) {
            return Err(LatticeError::TooManySites { sites: total });
        }
        // however long a region is that is too thin
        if total == 0.0 {
            return Err(LatticeError::NoSites);
        }
        Ok((first, cells.map(|n| n as u64)))
    }

    fn shifted(&self, space: &Space, site: DVec3, radius: f64, random: &mut RandomNumbers) -> DVec3 {
        if self.jitter == 0.0 {
            return site;
        }
        let reach = self.jitter * self.spacing;
        (0..SHIFTS)
            .map(|_| {
                let shift = DVec3::new(random.symmetric(), random.symmetric(), random.symmetric());
                space.wrap(site + shift * reach)
            })
            .find(|place| space.holds(*place, radius))
            .unwrap_or(site)
    }
}

#[cfg(test)]
mod tests {
    use super::super::spec::Region;
    use super::*;

    #[test]
    fn a_region_that_is_too_thin_has_no_sites_however_long() {
        let lattice = Lattice {
            kind: LatticeKind::Bcc,
            spacing: 0.3,
            jitter: 0.0,
            count: None,
        };
        let (edges, sites) = cell(lattice.kind);
        for thin in 0..3 {
            let mut upper = DVec3::splat(1e12);
            upper[thin] = 0.1;
            let lower = DVec3::ZERO;
            let space = Space::new(&Region::Box { lower, upper }, None).unwrap();
            let found = lattice.cells(&space, edges * lattice.spacing, sites.len());
            assert_eq!(found, Err(LatticeError::NoSites));
        }
    }
}
