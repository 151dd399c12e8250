//! Dashpots of laws that lose or hold back energy in other ways, too: adhesive, plastic, or with a damping whose effect
//! depends on the speed. No closed form tells which coefficient gives which restitution, so it is solved for.

mod between_sizes;

use super::Normal;
use crate::collision::{CollisionError, HeadOn, Start, Tolerance};
use crate::contact::PairSize;
use crate::contact::lane_by_lane::{noted, some_new};
use crate::lanes::Lanes;
use crate::parameters::ParameterError;
use crate::restitution::hertz_damping;
use crate::root::between;
use std::any::Any;
use std::cell::RefCell;
use std::collections::HashMap;

/// A dashpot as it was asked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Dashpot {
    /// Its coefficient, in the law's own dimensionless measure.
    Coefficient(f64),
    /// What it shall do, together with everything else in the law: the restitution of a head-on impact at this speed
    /// [m/s], told where the bodies first feel each other.
    Realised {
        /// Coefficient of restitution.
        restitution: f64,
        /// Impact speed [m/s].
        speed: f64,
        /// Whether coefficients may be interpolated between sizes for which they were solved.
        between_sizes: bool,
    },
}

/// Why a coefficient could not be found.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum DashpotError {
    /// The law loses more than was asked even without a dashpot.
    #[error(
        "`restitution` {requested} at an `impact_speed` of {speed} m/s is out of reach for bodies of effective radius {:e} m \
         and mass {:.4e} kg: {}; ask for {}a higher speed, or lower the adhesion or the plasticity",
        size.radius, size.mass, most(*largest), if *largest > 0.0 { "less, or for " } else { "" }
    )]
    OutOfReach {
        /// Restitution asked for.
        requested: f64,
        /// Impact speed [m/s].
        speed: f64,
        /// Largest restitution that can be had: without a dashpot. 0: the bodies stick.
        largest: f64,
        /// Effective radius and mass.
        size: PairSize,
    },
    /// No dashpot loses as much as was asked.
    #[error(
        "`restitution` {requested} at an `impact_speed` of {speed} m/s asks for more damping than the law can give"
    )]
    TooLow {
        /// Restitution asked for.
        requested: f64,
        /// Impact speed [m/s].
        speed: f64,
    },
    /// A collision could not be computed.
    #[error("the dashpot for the requested `restitution` cannot be found: {0}")]
    Collision(#[from] CollisionError),
}

fn most(largest: f64) -> String {
    if largest > 0.0 {
        format!("the law gives {largest:.6} at most, without any dashpot")
    } else {
        "they stick even without a dashpot".to_string()
    }
}

/// Error allowed in the square of the restitution.
const ACCURACY: f64 = 1e-9;

/// Tolerance of the collisions that are computed on the way.
const TOLERANCE: Tolerance = Tolerance {
    relative: 1e-10,
    max_steps: 100_000,
};

/// A coefficient beyond which more damping makes no difference.
const LARGEST: f64 = 1e4;

/// Most coefficients that a thread keeps in a table.
const REMEMBERED: usize = 1 << 18;

/// Most laws of which a thread keeps coefficients.
const LAWS: usize = 16;

/// Coefficients by the bits of effective radius and mass; nothing where what is asked is out of reach.
type OfSize = HashMap<(u64, u64), Option<f64>>;

/// Coefficients of one law.
struct Solved {
    law: Box<dyn Any>,
    /// Of sizes that were asked about, and of those between which it is interpolated.
    asked: OfSize,
    on_grid: OfSize,
}

thread_local! {
    /// Coefficients are pure functions of law and size: remembering them changes no bit.
    static SOLVED: RefCell<Vec<Solved>> = const { RefCell::new(Vec::new()) };
}

impl Dashpot {
    /// Reads the alternatives: a coefficient (its parameter is called `name`), or `restitution` with `impact_speed`.
    /// Without any of them there is no dashpot.
    pub fn read(
        name: &'static str,
        coefficient: Option<f64>,
        restitution: Option<f64>,
        impact_speed: Option<f64>,
    ) -> Result<Self, Vec<ParameterError>> {
        let refuse = |message: String| Err(ParameterError::together("restitution", message));
        match (coefficient, restitution, impact_speed) {
            (Some(_), Some(_), _) => refuse(format!(
                "`restitution` and `{name}` both tell the damping; give one of them"
            )),
            (_, Some(_), None) => refuse(
                "`restitution` needs the `impact_speed` at which it is wanted: under this law it depends on the speed"
                    .to_string(),
            ),
            (_, None, Some(_)) => refuse("`impact_speed` goes with `restitution`, which is missing".to_string()),
            (_, Some(restitution), Some(speed)) => Ok(Self::Realised {
                restitution,
                speed,
                between_sizes: false,
            }),
            (coefficient, None, None) => Ok(Self::Coefficient(coefficient.unwrap_or(0.0))),
        }
    }

    /// The same for bodies of many sizes: what is asked is realised within some 1e-6 instead of 1e-9, and most new sizes take no
    /// longer than sizes that were solved for.
    pub fn for_many_sizes(&mut self) {
        if let Self::Realised { between_sizes, .. } = self {
            *between_sizes = true;
        }
    }

    /// Number of history values that the dashpot needs; they are the law's last.
    #[inline(always)]
    pub fn history(&self) -> usize {
        match self {
            Self::Coefficient(_) => 0,
            Self::Realised { .. } => 1,
        }
    }

    /// Coefficient for a contact. `memory` is the dashpot's own part of its history; `with` gives the law with a known
    /// coefficient. Solved when the contact is new. Where the request is out of reach, which [`Dashpot::check`] tells
    /// beforehand, and for bodies of no mass, there is no damping.
    #[inline(always)]
    pub fn coefficient<L: Lanes, N: Normal>(&self, size: PairSize<L>, memory: &mut [L], with: impl Fn(Self) -> N) -> L {
        match self {
            Self::Coefficient(coefficient) => L::splat(*coefficient),
            Self::Realised { .. } => {
                if some_new(memory[0]) {
                    memory[0] = noted(memory[0], |lane| 1.0 + self.of_size(size.lane(lane), &with));
                }
                memory[0] - 1.0
            }
        }
    }

    /// Whether bodies of these sizes can do what is asked.
    pub fn check<L: Normal>(&self, size: PairSize, with: impl Fn(Self) -> L) -> Result<(), String> {
        self.solve(size, with).map(|_| ()).map_err(|error| error.to_string())
    }

    #[cold]
    fn of_size<L: Normal>(&self, size: PairSize, with: impl Fn(Self) -> L) -> f64 {
        if size.mass <= 0.0 {
            return 0.0;
        }
        let law = with(*self);
        let solve = |size| self.solve(size, &with).ok();
        let found = remembered(
            &law,
            |of| &mut of.asked,
            size,
            || match self {
                Self::Realised {
                    between_sizes: true, ..
                } => {
                    let on_grid = |there| remembered(&law, |of| &mut of.on_grid, there, || solve(there));
                    between_sizes::interpolated(size, on_grid).or_else(|| solve(size))
                }
                _ => solve(size),
            },
        );
        found.unwrap_or(0.0)
    }

    /// The coefficient that realises what is asked.
    pub fn solve<L: Normal>(&self, size: PairSize, with: impl Fn(Self) -> L) -> Result<f64, DashpotError> {
        let (requested, speed) = match *self {
            Self::Coefficient(coefficient) => return Ok(coefficient),
            Self::Realised { restitution, speed, .. } => (restitution, speed),
        };
        // the energy that comes back varies more evenly than the speed does
        let surplus = |coefficient: f64| -> Result<f64, DashpotError> {
            let law = with(Self::Coefficient(coefficient));
            let start = Start::Far;
            let impact = HeadOn {
                law: &law,
                size,
                speed,
                start,
            };
            let e = impact.run(&TOLERANCE)?.restitution;
            Ok(e * e - requested * requested)
        };
        let undamped = surplus(0.0)?;
        if undamped.abs() <= ACCURACY {
            return Ok(0.0);
        }
        if undamped < 0.0 {
            return Err(DashpotError::OutOfReach {
                requested,
                speed,
                largest: (undamped + requested * requested).max(0.0).sqrt(),
                size,
            });
        }
        let guess = hertz_damping(requested).max(0.01);
        let mut low = (0.0, undamped);
        let mut high = (guess, surplus(guess)?);
        while high.1 > 0.0 {
            if high.0 > LARGEST {
                return Err(DashpotError::TooLow { requested, speed });
            }
            low = high;
            let next = 1.5 * high.0;
            high = (next, surplus(next)?);
        }
        between(surplus, (low, high), ACCURACY)
    }
}

/// What is known of a size, or is found and then known.
fn remembered<L: Normal>(
    law: &L,
    table: impl Fn(&mut Solved) -> &mut OfSize,
    size: PairSize,
    find: impl FnOnce() -> Option<f64>,
) -> Option<f64> {
    let key = (size.radius.to_bits(), size.mass.to_bits());
    let same = |solved: &Solved| solved.law.downcast_ref::<L>() == Some(law);
    let known = SOLVED.with_borrow_mut(|all| {
        let solved = all.iter_mut().find(|solved| same(solved))?;
        table(solved).get(&key).copied()
    });
    known.unwrap_or_else(|| {
        let found = find();
        SOLVED.with_borrow_mut(|all| {
            let place = all.iter().position(same).unwrap_or_else(|| {
                if all.len() == LAWS {
                    all.remove(0);
                }
                all.push(Solved {
                    law: Box::new(*law),
                    asked: HashMap::new(),
                    on_grid: HashMap::new(),
                });
                all.len() - 1
            });
            let of_size = table(&mut all[place]);
            if of_size.len() == REMEMBERED {
                of_size.clear();
            }
            of_size.insert(key, found);
        });
        found
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::restitution_of;
    use crate::contact::MaterialPair;
    use crate::contact::normal::{NormalInput, NormalResponse};
    use crate::dimension::Dimension;
    use crate::parameters::{ParameterInfo, Values};
    use crate::restitution::hertz_damping;
    use approx::assert_relative_eq;

    /// `K d^(3/2) + c sqrt(m K) d^(1/4) v`, with a share of the spring missing on the way out, as plastic laws have it.
    #[derive(Clone, Copy, Debug, PartialEq)]
    struct Toy {
        k: f64,
        returned: f64,
        dashpot: Dashpot,
    }

    impl Normal for Toy {
        const NAME: &'static str = "toy";
        const SUMMARY: &'static str = "";
        const DOC: &'static str = "";
        const PARAMETERS: &'static [ParameterInfo] = &[];
        const HISTORY: &'static [Dimension] = &[Dimension::NONE];

        fn new(_: &Values, _: &MaterialPair) -> Result<Self, Vec<ParameterError>> {
            Err(Vec::new())
        }

        fn respond(&self, input: &NormalInput, history: &mut [f64]) -> NormalResponse {
            let d = input.overlap.max(0.0);
            let c = self
                .dashpot
                .coefficient(input.size, history, |dashpot| Self { dashpot, ..*self });
            let k = if input.rate > 0.0 {
                self.k
            } else {
                self.returned * self.k
            };
            NormalResponse::spring_dashpot(
                input,
                k * d * d.sqrt(),
                c * (input.size.mass * self.k).sqrt() * d.sqrt().sqrt(),
            )
        }

        fn energy(&self, _: PairSize, overlap: f64, _: &[f64]) -> f64 {
            0.4 * self.returned * self.k * overlap.max(0.0).powi(2) * overlap.max(0.0).sqrt()
        }

        fn stiffness(&self, _: PairSize, overlap: f64, _: &[f64]) -> f64 {
            1.5 * self.k * overlap.max(0.0).sqrt()
        }

        fn collision_time(&self, size: PairSize, overlap: f64) -> f64 {
            3.0 * (size.mass / (self.k * overlap.sqrt())).sqrt()
        }

        fn history(&self) -> usize {
            self.dashpot.history()
        }
    }

    const SIZE: PairSize = PairSize::new(2e-3, 3e-4);

    fn toy(returned: f64, restitution: f64, speed: f64) -> Toy {
        Toy {
            k: 5e8,
            returned,
            dashpot: Dashpot::read("alpha", None, Some(restitution), Some(speed)).unwrap(),
        }
    }

    fn solve(toy: Toy) -> Result<f64, DashpotError> {
        toy.dashpot.solve(SIZE, |dashpot| Toy { dashpot, ..toy })
    }

    #[test]
    fn the_closed_form_of_tsuji_is_found_at_any_speed() {
        for e in [0.01, 0.1, 0.54, 0.9, 0.999, 1.0] {
            for speed in [1e-6, 1.0, 300.0] {
                let coefficient = solve(toy(1.0, e, speed)).unwrap();
                assert_relative_eq!(coefficient, hertz_damping(e), epsilon = 1e-8, max_relative = 1e-7);
            }
        }
    }

    #[test]
    fn what_is_asked_is_realised_beside_other_losses_and_kept_in_the_history() {
        for e in [0.05, 0.4, 0.69] {
            let law = toy(0.5, e, 2.0);
            assert_relative_eq!(restitution_of(&law, SIZE, 2.0).unwrap(), e, max_relative = 1e-8);
            let mut history = [0.0];
            law.respond(&NormalInput::at(SIZE, 1e-6, 1.0), &mut history);
            assert_eq!(history[0], 1.0 + solve(law).unwrap());
            assert_eq!(law.dashpot.check(SIZE, |dashpot| Toy { dashpot, ..law }), Ok(()));
        }
    }

    #[test]
    fn between_sizes_what_is_asked_is_realised_too() {
        let exact = toy(0.5, 0.4, 2.0);
        let mut law = exact;
        law.dashpot.for_many_sizes();
        // restitution does not depend on the size, so that each coefficient is the same
        let remembered = law.dashpot.of_size(SIZE, |dashpot| Toy { dashpot, ..law });
        assert_relative_eq!(remembered, solve(exact).unwrap(), max_relative = 1e-8);
        assert_relative_eq!(restitution_of(&law, SIZE, 2.0).unwrap(), 0.4, max_relative = 1e-8);
        // out of reach: no damping
        let mut law = toy(0.5, 0.8, 2.0);
        law.dashpot.for_many_sizes();
        assert_eq!(law.dashpot.of_size(SIZE, |dashpot| Toy { dashpot, ..law }), 0.0);
    }

    #[test]
    fn the_largest_value_within_reach_is_told() {
        // half of the energy comes back: e is sqrt(0.5) at most
        let law = toy(0.5, 0.8, 2.0);
        let DashpotError::OutOfReach { largest, .. } = solve(law).unwrap_err() else {
            panic!("not out of reach");
        };
        assert_relative_eq!(largest, 0.5f64.sqrt(), max_relative = 1e-9);
        let told = law.dashpot.check(SIZE, |dashpot| Toy { dashpot, ..law }).unwrap_err();
        assert!(told.contains("the law gives 0.707107 at most"), "{told}");
    }

    #[test]
    fn alternatives_are_read() {
        let told = |a, b, c| match Dashpot::read("alpha", a, b, c) {
            Ok(dashpot) => format!("{dashpot:?}"),
            Err(errors) => errors[0].to_string(),
        };
        assert_eq!(told(None, None, None), "Coefficient(0.0)");
        assert_eq!(told(Some(0.3), None, None), "Coefficient(0.3)");
        assert_eq!(
            told(None, Some(0.5), Some(1.0)),
            "Realised { restitution: 0.5, speed: 1.0, between_sizes: false }"
        );
        assert!(told(Some(0.3), Some(0.5), Some(1.0)).contains("both tell the damping"));
        assert!(told(None, Some(0.5), None).contains("needs the `impact_speed`"));
        assert!(told(None, None, Some(0.5)).contains("goes with `restitution`"));
    }
}
