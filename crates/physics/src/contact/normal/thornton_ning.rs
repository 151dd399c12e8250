#![doc = include_str!("thornton_ning.md")]

use super::dashpot::Dashpot;
use super::jkr_curve::{JkrCurve, adhesion_length_root};
use super::path::{Branched, KINKS, Point, follow};
use super::{Normal, NormalInput, NormalResponse};
use crate::contact::{MaterialPair, PairSize};
use crate::dimension::Dimension;
use crate::parameters::{Alternatives, ParameterError, ParameterInfo, Range, Values};
use crate::params;
use std::f64::consts::PI;

params! {
    /// Parameters of the adhesive elastic-plastic contact of Thornton and Ning.
    pub struct ThorntonNingParameters {
        yield_pressure: PRESSURE, required 1e9, in Range::POSITIVE,
            "Largest pressure that the contact can carry, about 1.6 to 2.8 times the yield stress";
        work_of_adhesion: SURFACE_ENERGY, default 0.0, in Range::NOT_NEGATIVE,
            "Energy per area that it takes to part the surfaces, twice the surface energy of equal ones";
        alpha: NONE, optional 0.1, in Range::NOT_NEGATIVE, "Coefficient of the dashpot; none without it";
        restitution: NONE, optional 0.3, in Range::POSITIVE_SHARE,
            "Coefficient of restitution of an impact at `impact_speed`, adhesion and yield included";
        impact_speed: VELOCITY, optional 1.0, in Range::POSITIVE, "Speed at which `restitution` is wanted";
    }
}

/// The contact of Thornton and Ning bound to a pair of materials.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ThorntonNing {
    /// Effective modulus [Pa].
    modulus: f64,
    yield_pressure: f64,
    work_of_adhesion: f64,
    /// `sqrt(2 pi w/E)` [m^(1/2)].
    adhesion: f64,
    dashpot: Dashpot,
}

/// What a contact remembers, with what follows from it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ThorntonNingState {
    /// Curve of the undeformed sphere.
    virgin: JkrCurve,
    /// Root of the contact radius at yield [m^(1/2)].
    yield_root: f64,
    /// Root of the largest contact radius after yield; that at yield before [m^(1/2)].
    deepest: f64,
    /// Overlap at `deepest` [m].
    top: f64,
    /// Curve of unloading and reloading.
    curve: JkrCurve,
    touched: bool,
}

impl ThorntonNing {
    fn virgin(&self, size: PairSize) -> JkrCurve {
        JkrCurve::new(self.modulus, size.radius, self.adhesion, 0.0)
    }

    /// Root of the contact radius at which the pressure in the middle reaches the limit,
    /// `E/(pi R) (2 z^2 - 4 z_c^3/z) = p_y`: by Newton's method from above, where the cubic is convex.
    fn yield_root(&self, virgin: &JkrCurve) -> f64 {
        let square = 0.5 * PI * virgin.radius() * self.yield_pressure / self.modulus;
        let least = virgin.least_root();
        let cube = 2.0 * least * least * least;
        let mut z = square.sqrt() + libm::cbrt(cube);
        for _ in 0..MOST_STEPS {
            let next = z - (z * (z * z - square) - cube) / (3.0 * z * z - square);
            if next >= z {
                break;
            }
            z = next;
        }
        z
    }

    /// Force on the plastic line [N]: the pressure is cut at the limit.
    fn plastic_force(&self, virgin: &JkrCurve, yield_root: f64, root: f64) -> f64 {
        let square = yield_root * yield_root;
        let squares = root * root + square;
        let beyond = (root - yield_root) * (root + yield_root) * squares;
        virgin.force(yield_root) + PI * self.yield_pressure * beyond
            - 2.0 * square * self.modulus * self.adhesion * (root - yield_root)
    }

    /// The state of a contact whose radius has grown to the square of `root`.
    fn yielded(&self, before: ThorntonNingState, root: f64) -> ThorntonNingState {
        let ThorntonNingState { virgin, yield_root, .. } = before;
        let cube = root * root * root;
        let force = self.plastic_force(&virgin, yield_root, root);
        let elastic = force + 2.0 * self.modulus * self.adhesion * cube;
        let radius = (4.0 / 3.0 * self.modulus * cube * cube / elastic).max(virgin.radius());
        let origin = cube * root * (1.0 / virgin.radius() - 1.0 / radius);
        ThorntonNingState {
            deepest: root,
            top: virgin.overlap(root),
            curve: JkrCurve::new(self.modulus, radius, self.adhesion, origin),
            ..before
        }
    }

    fn state(&self, size: PairSize, history: &[f64]) -> ThorntonNingState {
        let virgin = self.virgin(size);
        let yield_root = self.yield_root(&virgin);
        let fresh = ThorntonNingState {
            virgin,
            yield_root,
            deepest: yield_root,
            top: virgin.overlap(yield_root),
            curve: virgin,
            touched: history[1] != 0.0,
        };
        if history[0] > 0.0 {
            self.yielded(fresh, history[0].sqrt().max(yield_root))
        } else {
            fresh
        }
    }

    fn alpha(&self) -> f64 {
        match self.dashpot {
            Dashpot::Coefficient(alpha) => alpha,
            Dashpot::Realised { .. } => 0.0,
        }
    }

    fn with(&self, dashpot: Dashpot) -> Self {
        Self { dashpot, ..*self }
    }
}

impl ThorntonNingState {
    /// Overlap at which the surfaces, apart, touch: at the bottom of the dent, or where it would deepen.
    fn touch(&self) -> f64 {
        if self.deepest > self.yield_root {
            self.curve.origin().min(self.top)
        } else {
            0.0
        }
    }
}

/// Most steps of Newton's method.
const MOST_STEPS: usize = 60;

impl Branched for ThorntonNing {
    type State = ThorntonNingState;

    fn advance(&self, _size: PairSize, state: ThorntonNingState, to: f64) -> ThorntonNingState {
        let touched = if state.touched {
            to >= state.curve.tear_off()
        } else {
            to >= state.touch()
        };
        let state = ThorntonNingState { touched, ..state };
        if touched && to > state.top {
            let root = state.virgin.root(to);
            if root > state.deepest {
                return self.yielded(state, root);
            }
        }
        state
    }

    fn point(&self, size: PairSize, state: ThorntonNingState, overlap: f64, _approaching: bool) -> Point {
        if !state.touched {
            return Point::default();
        }
        // on the plastic line the curve of unloading begins at this very place
        let root = state.curve.root(overlap);
        Point {
            elastic: state.curve.force(root),
            damping: self.alpha() * (4.0 / 3.0 * self.modulus * size.mass).sqrt() * root,
            adhesion: 3.0 * PI * self.work_of_adhesion * state.curve.radius(),
        }
    }

    fn stored(&self, _size: PairSize, state: ThorntonNingState, overlap: f64) -> f64 {
        if state.touched {
            state.curve.energy(state.curve.root(overlap))
        } else {
            0.0
        }
    }

    fn kinks(&self, _size: PairSize, state: ThorntonNingState) -> [f64; KINKS] {
        let end = if state.touched {
            state.curve.tear_off()
        } else {
            state.touch()
        };
        [end, state.top, f64::NAN, f64::NAN]
    }
}

impl Normal for ThorntonNing {
    const NAME: &'static str = "thornton-ning";
    const SUMMARY: &'static str = "adhesive elastic-plastic contact of Thornton and Ning: yield at a limiting pressure";
    const DOC: &'static str = include_str!("thornton_ning.md");
    const PARAMETERS: &'static [ParameterInfo] = ThorntonNingParameters::TABLE;
    const ALTERNATIVES: &'static [Alternatives] = &[Alternatives {
        of: &["restitution", "alpha"],
        with: &["impact_speed"],
    }];
    /// Largest contact radius after yield; 1 while the surfaces hold each other; the dashpot's own.
    const HISTORY: &'static [Dimension] = &[Dimension::LENGTH, Dimension::NONE, Dimension::NONE];
    const FOLLOWS_KINKS: bool = true;

    fn new(values: &Values, pair: &MaterialPair) -> Result<Self, Vec<ParameterError>> {
        let p = ThorntonNingParameters::from_values(values)?;
        let modulus = pair.effective_modulus();
        Ok(Self {
            modulus,
            yield_pressure: p.yield_pressure,
            work_of_adhesion: p.work_of_adhesion,
            adhesion: adhesion_length_root(p.work_of_adhesion, modulus),
            dashpot: Dashpot::read("alpha", p.alpha, p.restitution, p.impact_speed)?,
        })
    }

    fn respond(&self, input: &NormalInput, history: &mut [f64]) -> NormalResponse {
        let state = self.state(input.size, history);
        let alpha = self
            .dashpot
            .coefficient(input.size, &mut history[2..], |d| self.with(d));
        let law = self.with(Dashpot::Coefficient(alpha));
        let (response, next) = follow(&law, input, state);
        if next.deepest > state.deepest {
            history[0] = next.deepest * next.deepest;
        }
        history[1] = f64::from(u8::from(next.touched));
        response
    }

    fn energy(&self, size: PairSize, overlap: f64, history: &[f64]) -> f64 {
        self.stored(size, self.state(size, history), overlap)
    }

    fn stiffness(&self, size: PairSize, overlap: f64, history: &[f64]) -> f64 {
        let state = self.advance(size, self.state(size, history), overlap);
        if state.touched {
            state.curve.stiffness(state.curve.root(overlap))
        } else {
            0.0
        }
    }

    fn collision_time(&self, size: PairSize, overlap: f64) -> f64 {
        // without yield, which makes a contact softer
        self.virgin(size).collision_time(overlap, size.mass)
    }

    #[inline(always)]
    fn history(&self) -> usize {
        2 + self.dashpot.history()
    }

    fn reach(&self, size: PairSize, history: &[f64]) -> f64 {
        let state = self.state(size, history);
        if state.touched {
            -state.curve.tear_off()
        } else {
            -state.touch()
        }
    }

    fn bearing_overlap(&self, size: PairSize, overlap: f64, history: &[f64]) -> f64 {
        let state = self.state(size, history);
        if !state.touched {
            return 0.0;
        }
        let root = state.curve.root(overlap);
        let contact_radius = root * root;
        contact_radius * contact_radius / size.radius
    }

    fn largest_reach(&self, size: PairSize) -> f64 {
        // a dent moves the tear-off towards overlap by more than the flatter surface moves it away
        self.virgin(size).tear_off_distance()
    }

    fn check(&self, size: PairSize) -> Result<(), String> {
        self.dashpot.check(size, |d| self.with(d))
    }
}

#[cfg(test)]
mod tests;
