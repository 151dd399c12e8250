//! Fields on a grid by coarse graining: density, velocity, stress, ...
//!
//! Every grain is spread over space by a kernel `W` with an integral of 1, and every contact force along its branch
//! (I. Goldhirsch, Granular Matter 12 (2010) 239; at walls T. Weinhart et al., Granular Matter 14 (2012) 289). At a point `x`
//!
//! ```text
//! density         rho   = sum m_i W(x - r_i)
//! momentum        j     = sum m_i v_i W(x - r_i)             velocity V = j/rho
//! kinetic stress        = sum m_i (v_i - V)(v_i - V) W(x - r_i)
//! contact stress        = sum F_ij l_ij integral_0^1 W(x - r_j - s l_ij) ds
//! traction        t     = sum F_iw W(x - c_iw)
//! ```
//!
//! with the force `F_ij` on grain `i` from `j` and the branch `l_ij = r_i - r_j`; of a contact with a wall the branch begins at
//! the contact point `c_iw`. Compression is positive, as everywhere. These fields obey the balances of mass and momentum
//! exactly: `d rho/dt + div j = 0` and `dj/dt + div(rho V V + stress) = rho g + t`. The integral along the branch is exact
//! ([`KernelIn::along`]).
//!
//! **What is not counted** (grains outside of the region or of another kind) is like a wall: forces from it are part of the
//! traction, and the branch begins at the contact point.
//!
//! **Grid.** Fields are told at the centres of the cells. Over a direction with one cell they are means over the box instead:
//! the kernel is then that of the other directions, grains count whose centres lie between the sides, and of a branch
//! the part that does. So one row of cells is a profile, one layer a map, and a single cell tells the mean over
//! the box with sums that are exact to rounding. Where the kernel is no narrower than two cells, the sum over the
//! cells of a field times their volume is its integral to about 1e-3 (Lucy 1e-3, Gauss cut at 3 widths 3e-3; at 5 widths 1e-5).

mod deposit;
mod kernel;

pub use deposit::SUMS;
pub use kernel::{Kernel, KernelIn, KernelShape, LARGEST_CUT, LEAST_CUT};

use super::images::Periods;
use super::told_first::{Acting, counting, each_contact, each_in_order};
use super::{Selection, contact_counts, holds};
use crate::particles::{Origins, Zone};
use crate::simulation::Simulation;
use deposit::{Branch, CONTACTS, FLUX, Grid, Load, MASS, MOMENTUM, NUMBER, Point, SOLID, STRESS, Spread, TRACTION};
use glam::DVec3;
use serde::{Deserialize, Serialize};

/// Points or branches that are added to the cells at once.
const AT_ONCE: usize = 1 << 16;

/// Most cells of a grid.
pub const MAX_FIELD_CELLS: u64 = 2_000_000;

/// Fields on a grid.
#[derive(Clone, Debug, PartialEq)]
pub struct Field {
    /// Corners of the grid's box [m]; the domain when absent.
    pub corners: Option<(DVec3, DVec3)>,
    /// Cells in each direction; one cell: the mean over the direction.
    pub cells: [u32; 3],
    /// The kernel.
    pub kernel: Kernel,
    /// Grains whose centres lie elsewhere do not count.
    pub zone: Zone,
    /// Which grains count.
    pub selection: Selection,
    /// Time between two states that are averaged [s]; absent: the fields of the moment at which they are written.
    pub sample_every: Option<f64>,
}

/// Sums over the states since fields were written.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct FieldSums {
    /// Number of states.
    pub samples: u64,
    /// The numbers of every cell, one after the other; empty before the first state.
    sums: Vec<f64>,
}

/// Fields of one moment, or their mean over several.
#[derive(Clone, Debug, PartialEq)]
pub struct FieldValues {
    /// Lower corner of the grid [m].
    pub lower: DVec3,
    /// Upper corner [m].
    pub upper: DVec3,
    /// Cells in each direction.
    pub cells: [usize; 3],
    /// States that were averaged.
    pub samples: u64,
    /// What is told of every cell, x fastest.
    pub of_cells: Vec<CellValues>,
}

/// What is told of a cell. What is divided by a density is not a number where there is none.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CellValues {
    /// Number density [1/m^3].
    pub number_density: f64,
    /// Mass per volume [kg/m^3].
    pub density: f64,
    /// Volume of grains per volume.
    pub solid_fraction: f64,
    /// Momentum per volume [kg/(m^2 s)].
    pub momentum: DVec3,
    /// Velocity, momentum over mass [m/s].
    pub velocity: DVec3,
    /// A third of the mean square by mass of the deviation from the velocity [m^2/s^2].
    pub granular_temperature: f64,
    /// Contacts that act per grain.
    pub coordination: f64,
    /// Kinetic stress: xx, xy, xz, yx, ... [Pa].
    pub kinetic_stress: [f64; 9],
    /// Contact stress, the force first: xx, xy, xz, yx, ... [Pa].
    pub contact_stress: [f64; 9],
    /// Force per volume from walls and what is not counted [N/m^3].
    pub traction: DVec3,
}

impl CellValues {
    /// A third of the trace of both stresses [Pa].
    pub fn pressure(&self) -> f64 {
        let trace = |s: &[f64; 9]| s[0] + s[4] + s[8];
        (trace(&self.kinetic_stress) + trace(&self.contact_stress)) / 3.0
    }

    fn of(sums: &[f64; SUMS]) -> Self {
        let vector = |at: usize| DVec3::new(sums[at], sums[at + 1], sums[at + 2]);
        let (density, momentum) = (sums[MASS], vector(MOMENTUM));
        let velocity = momentum / density;
        let mean = |a: usize, b: usize, at: usize| match density > 0.0 {
            true => sums[FLUX + at] - momentum[a] * velocity[b],
            false => 0.0,
        };
        let [xx, yy, zz] = [mean(0, 0, 0), mean(1, 1, 1), mean(2, 2, 2)].map(|square| square.max(0.0));
        let [xy, xz, yz] = [mean(0, 1, 3), mean(0, 2, 4), mean(1, 2, 5)];
        Self {
            number_density: sums[NUMBER],
            density,
            solid_fraction: sums[SOLID],
            momentum,
            velocity,
            granular_temperature: (xx + yy + zz) / (3.0 * density),
            coordination: sums[CONTACTS] / sums[NUMBER],
            kinetic_stress: [xx, xy, xz, xy, yy, yz, xz, yz, zz],
            contact_stress: std::array::from_fn(|k| sums[STRESS + k]),
            traction: vector(TRACTION),
        }
    }
}

impl Field {
    fn grid(&self, sim: &Simulation) -> Grid {
        let (lower, upper) = self.corners.unwrap_or((sim.domain().lower, sim.domain().upper));
        Grid {
            lower,
            upper,
            cells: self.cells.map(|n| n as usize),
        }
    }

    /// Adds the present state to sums. Where processes share the run each calls this, and the first alone has the sums.
    pub fn sample(&self, sim: &Simulation, origins: &Origins, state: &mut FieldSums) {
        let grid = self.grid(sim);
        let is_first = sim.together().is_first();
        let mut sampling = Sampling {
            spread: Spread {
                periods: Periods::of(sim),
                ..Spread::default()
            },
            kernel: self.kernel.in_dimensions(grid.dimensions()),
            cells: vec![[0.0; SUMS]; if is_first { grid.len() } else { 0 }],
            grid,
        };
        self.each_branch(sim, origins, |told| sampling.add_branch(told));
        self.each_grain(sim, origins, |grain| sampling.add_point(grain));
        sampling.deposit();
        state.sums.resize(sampling.cells.len() * SUMS, 0.0);
        state.samples += 1;
        for (sum, add) in state.sums.iter_mut().zip(sampling.cells.as_flattened()) {
            *sum += add;
        }
    }

    /// The mean over all states of the sums, or the present state when there is none; the sums begin anew.
    pub fn take(&self, sim: &Simulation, origins: &Origins, state: &mut FieldSums) -> FieldValues {
        if state.samples == 0 {
            self.sample(sim, origins, state);
        }
        let grid = self.grid(sim);
        let state = std::mem::take(state);
        let share = 1.0 / state.samples as f64;
        let (cells, _) = state.sums.as_chunks::<SUMS>();
        let of_cells = cells.iter().map(|sums| CellValues::of(&sums.map(|sum| sum * share)));
        FieldValues {
            lower: grid.lower,
            upper: grid.upper,
            cells: grid.cells,
            samples: state.samples,
            of_cells: of_cells.collect(),
        }
    }

    /// Whether sums of a checkpoint are sums of this grid.
    pub fn fits(&self, state: &FieldSums) -> bool {
        let cells: usize = self.cells.iter().map(|n| *n as usize).product();
        state.sums.len() == if state.samples == 0 { 0 } else { cells * SUMS }
    }

    /// What contacts spread, those between grains first, in the order of the tables.
    fn each_branch(&self, sim: &Simulation, origins: &Origins, look: impl FnMut(ToldBranch)) {
        let counts = counting(sim, &self.zone, &self.selection, origins);
        let tell = |contact: Acting<'_>| {
            let counts = contact.grains().map(|grain| grain.is_some_and(|g| counts[g]));
            ToldBranch::of(sim, contact, counts)
        };
        each_contact(sim, tell, look);
    }

    /// What grains spread, in their order.
    fn each_grain(&self, sim: &Simulation, origins: &Origins, look: impl FnMut(Point)) {
        let (grains, contacts) = (&sim.grains, contact_counts(sim));
        let tell = |g: usize| {
            let counts = holds(sim, &self.zone, g) && self.selection.holds(grains, origins, g);
            let r = grains.radius(g);
            counts.then(|| Point {
                place: grains.position[g],
                load: Load::Grain {
                    mass: grains.mass(g),
                    solid: 4.0 / 3.0 * std::f64::consts::PI * r * r * r,
                    contacts: f64::from(contacts[g]),
                    velocity: grains.velocity[g],
                },
            })
        };
        each_in_order(sim, tell, look);
    }
}

/// What a contact spreads.
#[derive(Serialize, Deserialize)]
struct ToldBranch {
    branch: Branch,
    /// Whether it begins where what does not count acts on what does.
    is_half: bool,
}

impl ToldBranch {
    /// Of a contact of bodies that count or do not; nothing where neither does.
    fn of(sim: &Simulation, acting: Acting<'_>, counts: [bool; 2]) -> Option<Self> {
        if counts == [false, false] {
            return None;
        }
        let contact = acting.contact(sim);
        let centre = sim.grains.position[acting.chunk.i[acting.place] as usize];
        let force = acting.chunk.force(acting.place, contact.normal);
        let (lever_i, lever_j) = (contact.lever_i, contact.lever_j);
        let half = |side: f64, lever: f64| Branch {
            from: centre - contact.normal * lever_i,
            branch: contact.normal * (side * lever),
            force: force * side,
        };
        let branch = match counts {
            [true, true] => {
                let branch = contact.normal * (lever_i + lever_j);
                let from = centre - branch;
                Branch { from, branch, force }
            }
            [true, false] => half(1.0, lever_i),
            [false, _] => half(-1.0, lever_j),
        };
        let is_half = counts != [true, true];
        Some(Self { branch, is_half })
    }
}

/// Share of its way to the centre of a grain by which the force of a wall acts on this side of it, so that a grid that ends at walls has what
/// all of them do.
const INWARD: f64 = 1e-9;

/// Points and branches that wait to be added to cells, some at a time.
struct Sampling {
    grid: Grid,
    kernel: KernelIn,
    spread: Spread,
    cells: Vec<[f64; SUMS]>,
}

impl Sampling {
    fn add_branch(&mut self, told: ToldBranch) {
        self.spread.branches.push(told.branch);
        if told.is_half {
            self.add_point(Point {
                place: told.branch.from + told.branch.branch * INWARD,
                load: Load::Force(told.branch.force),
            });
        } else {
            self.deposit_if_many();
        }
    }

    fn add_point(&mut self, point: Point) {
        self.spread.points.push(point);
        self.deposit_if_many();
    }

    fn deposit_if_many(&mut self) {
        if self.spread.points.len().max(self.spread.branches.len()) >= AT_ONCE {
            self.deposit();
        }
    }

    /// Adds what waits. The sums of grains, of branches and of forces are others, and each kind comes in its order: so the bits are
    /// those of all at once.
    fn deposit(&mut self) {
        self.grid.spread(&self.spread, &self.kernel, &mut self.cells);
        self.spread.points.clear();
        self.spread.branches.clear();
    }
}

/// What leads to the next image along a periodic direction [m].
pub(super) fn period(sim: &Simulation, axis: usize) -> Option<DVec3> {
    sim.domain().periodic[axis].then(|| sim.comm.edge(axis))
}

#[cfg(test)]
mod tests;
