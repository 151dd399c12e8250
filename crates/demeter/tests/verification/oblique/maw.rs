//! The exact elastic oblique impact of a sphere: Maw, Barber and Fawcett, Wear 38 (1976) 101 and J. Lubric. Technol. 103
//! (1981) 74. Written for the tests alone, and in another way than any contact law of the library: as a boundary value
//! problem of the half-space, with tractions over the contact circle.
//!
//! * The normal force is that of Hertz; friction does not change it.
//! * The tangential traction is a sum of `sqrt(1 - r^2/a_i^2)` over circles of radius `a_i`; the displacement of the
//!   surface due to each is known in closed form (Johnson, Contact Mechanics (1985), section 7.1 and eq. 3.41-3.42, with
//!   the average over the directions that Maw et al. take).
//! * At one point per annulus the traction is either `mu p` (slip) or such that the surfaces have not moved on each other
//!   (stick). Which of the two holds is found anew at each time, from the sign of the slip and the size of the traction.
//! * Everything depends on two numbers only (both bodies of the same material, or one of them rigid):
//!   `psi = kappa/mu v_t/v_n` and `chi = kappa/2 (1 + 1/K^2)`, `kappa = k_t/k_n = 2 (1 - nu)/(2 - nu)`, `K^2 = 2/5`.

use std::f64::consts::PI;

/// The impact in units in which effective modulus, radius, mass, approach speed and friction are 1.
pub struct Impact {
    /// `k_t/k_n`.
    kappa: f64,
    /// Inverse of the mass of tangential motion over that of normal motion: 7/2 for solid spheres.
    mobility: f64,
    /// Number of annuli at largest compression.
    annuli: usize,
    /// Time steps per contact.
    steps: usize,
}

/// Whether a point of the surface sticks or slips, and which way its traction points.
#[derive(Clone, Copy, PartialEq)]
enum State {
    Stick,
    Slip(f64),
}

/// The surface over the impact.
struct Surface {
    /// Where the traction is prescribed.
    points: Vec<f64>,
    width: f64,
    /// How far the bodies have moved on each other at each point since they were apart.
    slid: Vec<f64>,
    states: Vec<State>,
}

/// Displacement at `r` of the traction `sqrt(1 - r^2/a^2)`, for a modulus `k_t/(2 a)`.
fn displacement(modulus: f64, a: f64, r: f64) -> f64 {
    let square = 2.0 * a * a - r * r;
    if r <= a {
        PI * square / (4.0 * modulus * a)
    } else {
        (square * libm::asin(a / r) + a * (r * r - a * a).sqrt()) / (2.0 * modulus * a)
    }
}

/// `sqrt(1 - r^2/a^2)` inside the circle.
fn traction(a: f64, r: f64) -> f64 {
    (1.0 - r * r / (a * a)).max(0.0).sqrt()
}

/// Solves a dense linear system by elimination with row exchange; the matrix carries the right-hand side as its last
/// column.
fn solve(mut rows: Vec<Vec<f64>>) -> Vec<f64> {
    let n = rows.len();
    for column in 0..n {
        let pivot = (column..n)
            .max_by(|&a, &b| rows[a][column].abs().total_cmp(&rows[b][column].abs()))
            .unwrap_or(column);
        rows.swap(column, pivot);
        let (above, below) = rows.split_at_mut(column + 1);
        let pivot_row = &above[column];
        for row in below {
            let factor = row[column] / pivot_row[column];
            if factor != 0.0 {
                for (value, subtracted) in row[column..].iter_mut().zip(&pivot_row[column..]) {
                    *value -= factor * subtracted;
                }
            }
        }
    }
    let mut solution = vec![0.0; n];
    for row in (0..n).rev() {
        let known: f64 = (row + 1..n).map(|k| rows[row][k] * solution[k]).sum();
        solution[row] = (rows[row][n] - known) / rows[row][row];
    }
    solution
}

impl Surface {
    fn new(largest_radius: f64, annuli: usize) -> Self {
        let width = largest_radius / annuli as f64;
        Self {
            points: (0..=annuli).map(|j| (j as f64 + 0.5) * width).collect(),
            width,
            slid: vec![0.0; annuli + 1],
            states: vec![State::Stick; annuli + 1],
        }
    }

    /// Tangential force at a contact radius `a` and a displacement `shift` of the bodies far from the contact.
    fn force(&mut self, modulus: f64, a: f64, shift: f64) -> f64 {
        let touching = self.points.iter().filter(|&&r| r < a).count();
        let mut radii: Vec<f64> = (1..=touching).map(|i| i as f64 * self.width).collect();
        if let Some(last) = radii.last_mut() {
            *last = a;
        }
        // Hertz: p_0 = 2 a E/(pi R)
        let limit = |r: f64| 2.0 * a / PI * traction(a, r);
        for state in &mut self.states[touching..] {
            *state = State::Stick;
        }
        let mut strengths = vec![];
        for _ in 0..4 * touching {
            strengths = solve(self.equations(modulus, &radii, shift, &limit));
            if !self.revise(modulus, &radii, &strengths, shift, &limit) {
                break;
            }
        }
        for (j, &r) in self.points.iter().enumerate() {
            if j >= touching || self.states[j] != State::Stick {
                self.slid[j] = shift - sum(&radii, &strengths, |radius| displacement(modulus, radius, r));
            }
        }
        sum(&radii, &strengths, |radius| 2.0 / 3.0 * PI * radius * radius)
    }

    /// One equation per touching point.
    fn equations(&self, modulus: f64, radii: &[f64], shift: f64, limit: &impl Fn(f64) -> f64) -> Vec<Vec<f64>> {
        let row = |j: usize| {
            let r = self.points[j];
            let (mut row, right): (Vec<f64>, f64) = match self.states[j] {
                State::Stick => (
                    radii.iter().map(|&a| displacement(modulus, a, r)).collect(),
                    shift - self.slid[j],
                ),
                State::Slip(sign) => (radii.iter().map(|&a| traction(a, r)).collect(), sign * limit(r)),
            };
            row.push(right);
            row
        };
        (0..radii.len()).map(row).collect()
    }

    /// Lets points slip whose traction is too large, and stick whose slip is against their traction; tells whether any did.
    fn revise(
        &mut self,
        modulus: f64,
        radii: &[f64],
        strengths: &[f64],
        shift: f64,
        limit: &impl Fn(f64) -> f64,
    ) -> bool {
        let mut revised = false;
        for j in 0..radii.len() {
            let r = self.points[j];
            let next = match self.states[j] {
                State::Stick => {
                    let carried = sum(radii, strengths, |a| traction(a, r));
                    if carried.abs() > limit(r) * (1.0 + 1e-9) {
                        State::Slip(carried.signum())
                    } else {
                        State::Stick
                    }
                }
                State::Slip(sign) => {
                    let slid = shift - sum(radii, strengths, |a| displacement(modulus, a, r));
                    if (slid - self.slid[j]) * sign < 0.0 {
                        State::Stick
                    } else {
                        State::Slip(sign)
                    }
                }
            };
            revised |= next != self.states[j];
            self.states[j] = next;
        }
        revised
    }
}

fn sum(radii: &[f64], strengths: &[f64], value: impl Fn(f64) -> f64) -> f64 {
    radii
        .iter()
        .zip(strengths)
        .map(|(&a, strength)| strength * value(a))
        .sum()
}

impl Impact {
    /// A solid sphere on a half-space, or two solid spheres, of one material.
    pub fn of_solid_spheres(poisson_ratio: f64, annuli: usize, steps: usize) -> Self {
        Self::of_stiffness_ratio(2.0 * (1.0 - poisson_ratio) / (2.0 - poisson_ratio), annuli, steps)
    }

    /// Solid spheres of a ratio `k_t/k_n`. Bodies of different materials: friction is taken to change the normal
    /// pressure no more than between equal ones.
    pub fn of_stiffness_ratio(kappa: f64, annuli: usize, steps: usize) -> Self {
        Self {
            kappa,
            mobility: 3.5,
            annuli,
            steps,
        }
    }

    /// A disc cut from a sphere along a diameter, on a half-space: `K^2 = 1/2`.
    pub fn of_disc(poisson_ratio: f64, annuli: usize, steps: usize) -> Self {
        Self {
            mobility: 3.0,
            ..Self::of_solid_spheres(poisson_ratio, annuli, steps)
        }
    }

    /// `chi` of Maw et al.
    pub fn chi(&self) -> f64 {
        0.5 * self.kappa * self.mobility
    }

    /// Non-dimensional angle of reflection `psi_2` at an angle of incidence `psi_1`; the tangential restitution is
    /// `-psi_2/psi_1`.
    pub fn reflection(&self, incidence: f64) -> f64 {
        // Hertz: F = 4/3 d^1.5, d_max = (15/16)^0.4, t = 2.94 d_max
        let deepest = libm::pow(15.0 / 16.0, 0.4);
        let dt = 2.943_275 * deepest / self.steps as f64;
        let mut surface = Surface::new(deepest.sqrt(), self.annuli);
        let (mut overlap, mut approach) = (0.0f64, 1.0f64);
        let (mut shift, mut sliding) = (0.0f64, incidence / self.kappa);
        let (mut normal_force, mut friction) = (0.0, 0.0);
        loop {
            approach -= 0.5 * dt * normal_force;
            sliding -= 0.5 * dt * friction * self.mobility;
            overlap += dt * approach;
            shift += dt * sliding;
            if overlap <= 0.0 {
                return sliding * self.kappa;
            }
            normal_force = 4.0 / 3.0 * overlap * overlap.sqrt();
            friction = surface.force(self.kappa, overlap.sqrt(), shift);
            approach -= 0.5 * dt * normal_force;
            sliding -= 0.5 * dt * friction * self.mobility;
        }
    }
}
