//! Collisions integrated step by step, a check that shares no formula with what it checks.
//!
//! With `x = u^4` and `dt = u^3 ds` every law below is smooth in `u`, from first touch to the end of contact, so that the
//! classical Runge-Kutta rule keeps its order. The step is halved until the result stays.

use super::ContactEnd;

/// A contact law in units of the collision: `x'' = -force(x, x')`, `x(0) = 0`, `x'(0) = 1`.
#[derive(Clone, Copy, Debug)]
pub(super) enum Law {
    Linear { ratio: f64 },
    Hertz { alpha: f64 },
    Viscoelastic { beta: f64 },
    Power { exponent: f64 },
}

impl Law {
    /// Total force at the overlap `u^4`.
    fn force(self, u: f64, v: f64) -> f64 {
        match self {
            Law::Linear { ratio } => u * u * u * u + 2.0 * ratio * v,
            Law::Hertz { alpha } => u * (u * u * u * u * u + alpha * v),
            Law::Viscoelastic { beta } => u * u * (u * u * u * u + beta * v),
            Law::Power { exponent } => libm::pow(u.max(0.0), 4.0 * exponent),
        }
    }
}

/// What one integration finds.
#[derive(Clone, Copy, Debug)]
pub(super) struct Found {
    pub restitution: f64,
    pub contact_time: f64,
    pub max_overlap: f64,
    pub max_force: f64,
}

/// `(time, u, speed)`.
type State = [f64; 3];

fn slope(law: Law, [_, u, v]: State) -> State {
    let pace = u * u * u;
    [pace, 0.25 * v, -pace * law.force(u, v)]
}

fn step(law: Law, state: State, h: f64) -> State {
    let add = |a: State, b: State, factor: f64| -> State { std::array::from_fn(|i| a[i] + factor * b[i]) };
    let k1 = slope(law, state);
    let k2 = slope(law, add(state, k1, 0.5 * h));
    let k3 = slope(law, add(state, k2, 0.5 * h));
    let k4 = slope(law, add(state, k3, h));
    std::array::from_fn(|i| state[i] + h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]))
}

/// The state at which `past` becomes true within one step of `h` from `state`, by halving.
fn event(law: Law, state: State, h: f64, past: impl Fn(State) -> bool) -> State {
    let (mut low, mut high) = (0.0, h);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if past(step(law, state, middle)) {
            high = middle;
        } else {
            low = middle;
        }
    }
    step(law, state, 0.5 * (low + high))
}

fn with_step(law: Law, end: ContactEnd, h: f64) -> Found {
    let mut state = [0.0, 0.0, 1.0];
    let (mut max_overlap, mut max_force) = (0.0, law.force(0.0, 1.0));
    let over = |[_, u, v]: State| match end {
        ContactEnd::ZeroOverlap => u < 0.0,
        ContactEnd::ZeroForce => v < 0.0 && (u <= 0.0 || law.force(u, v) < 0.0),
    };
    for _ in 0..20_000_000 {
        let next = step(law, state, h);
        if state[2] >= 0.0 && next[2] < 0.0 {
            let [_, u, _] = event(law, state, h, |s| s[2] < 0.0);
            max_overlap = u * u * u * u;
        }
        if over(next) {
            let [contact_time, _, v] = event(law, state, h, over);
            return Found {
                restitution: -v,
                contact_time,
                max_overlap,
                max_force,
            };
        }
        max_force = max_force.max(law.force(next[1], next[2]));
        state = next;
    }
    panic!("{law:?} never reaches {end:?}");
}

/// One collision, to about 1e-12 (the largest force to 1e-7: it is the largest at a step).
pub(super) fn brute_force(law: Law, end: ContactEnd) -> Found {
    let mut h = 4e-3;
    let mut last = with_step(law, end, h);
    for _ in 0..6 {
        h *= 0.5;
        let next = with_step(law, end, h);
        let change = (next.restitution - last.restitution).abs() / next.restitution
            + (next.contact_time - last.contact_time).abs() / next.contact_time;
        last = next;
        if change < 2e-12 {
            break;
        }
    }
    last
}
