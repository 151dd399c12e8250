#![doc = include_str!("hertz_tsuji.md")]

use super::hertz_spring::{HertzSpring, Power};
use super::spring_dashpot::{
    Damping, Dashpot, ENDS, Observed, check_end, contact_end, exactly_one_damping, unit_duration,
};
use super::{Normal, NormalInput, NormalResponse};
use crate::contact::{MaterialPair, PairSize};
use crate::dimension::Dimension;
use crate::lanes::Lanes;
use crate::parameters::{Alternatives, ParameterError, ParameterInfo, Range, Values};
use crate::params;
use crate::restitution::ContactEnd;
use crate::restitution::duration::UNDAMPED;
use crate::restitution::hertz::CRITICAL_ALPHA;
use crate::restitution::inverse::SpringDashpot;

params! {
    /// Parameters of the Hertzian spring-dashpot.
    pub struct HertzTsujiParameters {
        restitution: NONE, profile 0.9, in Range::POSITIVE_SHARE,
            "Coefficient of restitution; a table or a formula makes it depend on the impact speed";
        alpha: NONE, optional 0.1, in Range::NOT_NEGATIVE, "Damping coefficient, in place of the restitution";
        contact_time: TIME, optional 1e-4, in Range::POSITIVE,
            "Duration of a collision at the impact speed, the same for every pair of sizes; in place of the moduli";
        max_overlap: LENGTH, optional 1e-5, in Range::POSITIVE,
            "Largest overlap of a collision at the impact speed, the same for every pair of sizes; in place of the moduli";
        impact_speed: VELOCITY, optional 1.0, in Range::POSITIVE,
            "Impact speed at which `contact_time` or `max_overlap` is seen";
        contact_end: NONE, choice ENDS, "Where contact ends";
    }
}

/// The Hertzian spring-dashpot bound to a pair of materials.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HertzTsuji {
    spring: HertzSpring,
    damping: Damping,
    end: ContactEnd,
}

impl Normal for HertzTsuji {
    const NAME: &'static str = "hertz-tsuji";
    const SUMMARY: &'static str = "Hertzian spring-dashpot (HSD)";
    const DOC: &'static str = include_str!("hertz_tsuji.md");
    const PARAMETERS: &'static [ParameterInfo] = HertzTsujiParameters::TABLE;
    const ALTERNATIVES: &'static [Alternatives] = &[
        Alternatives {
            of: &["contact_time", "max_overlap"],
            with: &["impact_speed"],
        },
        Alternatives {
            of: &["restitution", "alpha"],
            with: &[],
        },
    ];
    const HISTORY: &'static [Dimension] = &[Dimension::NONE];
    const LASTING: usize = 0;

    fn new(values: &Values, pair: &MaterialPair) -> Result<Self, Vec<ParameterError>> {
        let p = HertzTsujiParameters::from_values(values)?;
        let end = contact_end(p.contact_end);
        exactly_one_damping(&p.restitution, &p.alpha, "alpha")?;
        let observed = Observed {
            contact_time: p.contact_time,
            max_overlap: p.max_overlap,
            impact_speed: p.impact_speed,
        };
        let per_mass = observed.stiffness_per_mass(SpringDashpot::Hertz, p.restitution, end)?;
        let damping = match (p.restitution, p.alpha) {
            (Some(restitution), _) => Damping::of(restitution, end),
            (None, alpha) => Damping::Ratio(alpha.unwrap_or(0.0) / CRITICAL_ALPHA),
        };
        let law = Self {
            spring: per_mass.map_or(HertzSpring::of(pair), HertzSpring::PerMass),
            damping,
            end,
        };
        if let Some(alpha) = p.alpha {
            let what = format!("`alpha` {alpha}");
            check_end(alpha / CRITICAL_ALPHA, end, &what, "sqrt(5) = 2.2360679775")
                .map_err(|error| ParameterError::together("alpha", error))?;
        }
        Ok(law)
    }

    const WIDE: bool = true;

    #[inline(always)]
    fn respond(&self, input: &NormalInput, history: &mut [f64]) -> NormalResponse {
        self.respond_wide(input, history)
    }

    #[inline(always)]
    fn respond_wide<L: Lanes>(&self, input: &NormalInput<L>, history: &mut [L]) -> NormalResponse<L> {
        let damping = match self.damping.dashpot(input, CRITICAL_ALPHA, history) {
            Dashpot::Units(number) => self.spring.mean_times(Power::Damping, input, number),
            Dashpot::Known(coefficient) => coefficient,
        };
        let response = NormalResponse::spring_dashpot(input, self.spring.mean(Power::Force, input), damping);
        response.ending_at(self.end)
    }

    #[inline(always)]
    fn energy(&self, size: PairSize, overlap: f64, _history: &[f64]) -> f64 {
        self.spring.energy(size, overlap)
    }

    #[inline(always)]
    fn stiffness(&self, size: PairSize, overlap: f64, history: &[f64]) -> f64 {
        self.stiffness_wide(size, overlap, history)
    }

    #[inline(always)]
    fn stiffness_wide<L: Lanes>(&self, size: PairSize<L>, overlap: L, _history: &[L]) -> L {
        self.spring.tangent(size, overlap)
    }

    fn collision_time(&self, size: PairSize, overlap: f64) -> f64 {
        let speed = self.spring.impact_speed(size, overlap);
        let unit = match self.end {
            // without damping it is shortest
            ContactEnd::ZeroOverlap => UNDAMPED,
            ContactEnd::ZeroForce => {
                let ratio = self.damping.ratio_at(0.0, speed);
                unit_duration(SpringDashpot::Hertz, ratio, self.end).unwrap_or(UNDAMPED)
            }
        };
        unit * self.spring.unit_of_time(size, speed)
    }

    #[inline(always)]
    fn history(&self) -> usize {
        self.damping.history()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::Elastic;
    use crate::parameters::values;
    use approx::assert_relative_eq;

    /// What a collision came to.
    struct Collision {
        duration: f64,
        largest_overlap: f64,
        restitution: f64,
    }

    /// Collision of the law's plain force at impact speed `speed`, integrated with Runge-Kutta in `s`, where `d = u^4`
    /// and `dt = u^3 ds`: this takes the singular start out of the dashpot.
    fn collide(law: &HertzTsuji, size: PairSize, speed: f64) -> Collision {
        let slope = |[u, v, _]: [f64; 3]| {
            let response = law.respond(&NormalInput::at(size, u * u * u * u, v), &mut []);
            let force = response.elastic + response.damping * v;
            [0.25 * v, -u * u * u * force / size.mass, u * u * u]
        };
        let advance = |y: [f64; 3], step: f64| {
            let shifted = |k: [f64; 3], share: f64| std::array::from_fn(|i| y[i] + share * step * k[i]);
            let k1 = slope(y);
            let k2 = slope(shifted(k1, 0.5));
            let k3 = slope(shifted(k2, 0.5));
            let k4 = slope(shifted(k3, 1.0));
            std::array::from_fn(|i| y[i] + step / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]))
        };
        // the state after the step at whose end `component` of the state vanishes
        let end_at_zero = |y: [f64; 3], step: f64, component: usize| {
            let (mut lower, mut upper) = (0.0, step);
            for _ in 0..100 {
                let middle = 0.5 * (lower + upper);
                if advance(y, middle)[component] > 0.0 {
                    lower = middle;
                } else {
                    upper = middle;
                }
            }
            advance(y, lower)
        };
        // u grows to about the fourth root of the largest overlap while s grows to about 4 u / v0
        let overlap = (1.25 * size.mass * speed * speed / law.spring.stiffness(size)).powf(0.4);
        let step = 1e-3 * overlap.powf(0.25) * 4.0 / speed;
        let mut y: [f64; 3] = [0.0, speed, 0.0];
        let mut largest_overlap = 0.0;
        for _ in 0..1_000_000 {
            let next = advance(y, step);
            if y[1] > 0.0 && next[1] <= 0.0 {
                largest_overlap = end_at_zero(y, step, 1)[0].powi(4);
            }
            if next[0] <= 0.0 {
                let [_, v, duration] = end_at_zero(y, step, 0);
                return Collision {
                    duration,
                    largest_overlap,
                    restitution: -v / speed,
                };
            }
            y = next;
        }
        panic!("the bodies never parted");
    }

    fn law(elastic: Elastic, restitution: f64) -> HertzTsuji {
        let pair = MaterialPair { a: elastic, b: elastic };
        HertzTsuji::new(&values(&[("restitution", restitution)]), &pair).unwrap()
    }

    const PERSPEX: Elastic = Elastic {
        young_modulus: 6e9,
        poisson_ratio: 0.3,
    };

    #[test]
    fn duration_and_overlap_of_damped_collisions() {
        // restitution, duration and largest overlap in units of (m/K)^(2/5) v0^(-1/5) and (m v0^2/K)^(2/5), from an
        // independent integration of the equation of Antypov and Elliott, checked to 1e-14
        for (restitution, duration, overlap) in [
            (0.1, 4.861402527, 0.63070503),
            (0.54, 3.477236761, 0.88088633),
            (0.9, 3.253683413, 1.04918396),
        ] {
            for (size, speed) in [(PairSize::new(2.5e-3, 4e-4), 1.0), (PairSize::new(0.3, 70.0), 0.02)] {
                let law = law(PERSPEX, restitution);
                let collision = collide(&law, size, speed);
                let ratio = size.mass / law.spring.stiffness(size);
                let unit_time = ratio.powf(0.4) * speed.powf(-0.2);
                let unit_length = (ratio * speed * speed).powf(0.4);
                assert_relative_eq!(collision.duration / unit_time, duration, max_relative = 1e-8);
                assert_relative_eq!(collision.largest_overlap / unit_length, overlap, max_relative = 2e-8);
                assert_relative_eq!(collision.restitution, restitution, max_relative = 1e-8);
            }
        }
    }

    #[test]
    fn two_spheres_of_the_paper_in_seconds_and_metres() {
        // figure 1 of Antypov and Elliott: d = 1 cm, E = 6 GPa, nu = 0.3, e = 0.54, 1 m/s; density 1500 kg/m^3
        let radius: f64 = 0.005;
        let mass = 1500.0 * 4.0 / 3.0 * std::f64::consts::PI * radius.powi(3);
        let size = PairSize::new(0.5 * radius, 0.5 * mass);
        let collision = collide(&law(PERSPEX, 0.54), size, 1.0);
        assert_relative_eq!(collision.duration, 69.51247874e-6, max_relative = 1e-9);
        assert_relative_eq!(collision.largest_overlap, 17.60955505e-6, max_relative = 1e-9);

        let elastic = law(PERSPEX, 1.0);
        let deepest = collide(&elastic, size, 1.0).largest_overlap;
        assert_relative_eq!(
            elastic.collision_time(size, deepest),
            64.33145691e-6,
            max_relative = 1e-9
        );
    }

    #[test]
    fn undamped_overlap_and_contact_time() {
        let size = PairSize::new(2.5e-3, 4e-4);
        let law = law(PERSPEX, 1.0);
        let (k, speed) = (law.spring.stiffness(size), 0.7);
        let collision = collide(&law, size, speed);
        let overlap = (1.25 * size.mass * speed * speed / k).powf(0.4);
        assert_relative_eq!(collision.largest_overlap, overlap, max_relative = 1e-10);
        let duration = UNDAMPED * (size.mass / k).powf(0.4) * speed.powf(-0.2);
        assert_relative_eq!(collision.duration, duration, max_relative = 1e-10);
    }

    #[test]
    fn force_of_hertz() {
        // a sphere of 10 mm on a rigid half-space, 10 um deep: F = 4/3 E/(1 - nu^2) sqrt(R) d^(3/2)
        let pair = MaterialPair {
            a: PERSPEX,
            b: Elastic {
                young_modulus: 1e300,
                poisson_ratio: 0.0,
            },
        };
        let law = HertzTsuji::new(&values(&[("restitution", 1.0)]), &pair).unwrap();
        let size = PairSize::new(0.01, 1.0);
        let input = NormalInput::at(size, 1e-5, 0.0);
        // 4/3 * 6e9/0.91 * 0.1 * 10^-7.5
        assert_relative_eq!(law.respond(&input, &mut []).elastic, 27.800243166, max_relative = 1e-9);
    }
}
