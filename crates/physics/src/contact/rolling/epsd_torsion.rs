#![doc = include_str!("epsd_torsion.md")]

use super::epsd::Epsd;
use super::{Rolling, RollingInput, RollingResponse};
use crate::contact::spring::{Carried, SPRING_HISTORY, advance_spring, spring_energy};
use crate::contact::{MaterialPair, PairSize};
use crate::dimension::Dimension;
use crate::lanes::{Lanes, Vector};
use crate::parameters::{ParameterError, ParameterInfo, Range, Values};
use crate::params;

params! {
    /// Parameters of the elastic-plastic spring-dashpots against rolling and torsion.
    pub struct EpsdTorsionParameters {
        rolling_friction: NONE, required 0.05, in Range::NOT_NEGATIVE, "Coefficient of rolling friction";
        torsion_friction: NONE, required 0.02, in Range::NOT_NEGATIVE, "Coefficient of friction against torsion";
        damping_ratio: NONE, default 0.3, in Range::SHARE,
            "Share of critical damping of both springs";
    }
}

/// The elastic-plastic spring-dashpots against rolling and torsion bound to a pair of materials.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EpsdTorsion {
    rolling: Epsd,
    torsion: Epsd,
}

/// Moment of inertia of a sphere that turns about its centre over that of one that rolls about its surface.
const TURNING: f64 = 2.0 / 7.0;

impl Rolling for EpsdTorsion {
    const NAME: &'static str = "epsd-torsion";
    const SUMMARY: &'static str = "elastic-plastic spring-dashpots against rolling and torsion";
    const DOC: &'static str = include_str!("epsd_torsion.md");
    const PARAMETERS: &'static [ParameterInfo] = EpsdTorsionParameters::TABLE;
    // what rolling remembers, then the torque about the normal and the compliance of its spring
    const HISTORY: &'static [Dimension] = &[
        Dimension::ENERGY,
        Dimension::ENERGY,
        Dimension::ENERGY,
        Dimension::ROLLING_COMPLIANCE,
        Dimension::ENERGY,
        Dimension::ROLLING_COMPLIANCE,
    ];

    fn new(values: &Values, _pair: &MaterialPair) -> Result<Self, Vec<ParameterError>> {
        let p = EpsdTorsionParameters::from_values(values)?;
        let [rolling, torsion] = [p.rolling_friction, p.torsion_friction].map(|c| Epsd::of(c, p.damping_ratio));
        Ok(Self { rolling, torsion })
    }

    const WIDE: bool = true;

    #[inline(always)]
    fn respond(&self, input: &RollingInput, history: &mut [f64]) -> RollingResponse {
        self.respond_wide(input, history)
    }

    #[inline(always)]
    fn respond_wide<L: Lanes>(&self, input: &RollingInput<L>, history: &mut [L]) -> RollingResponse<L> {
        let (of_rolling, of_torsion) = history.split_at_mut(SPRING_HISTORY);
        let rolled = self.rolling.respond_wide(input, of_rolling);
        // a load along the normal is turned by nothing but the normal
        let about = |torque: L| input.normal * torque;
        let [x, y, z] = about(of_torsion[0]).components();
        let mut spring = [x, y, z, of_torsion[1]];
        let carried = Carried::turned(about(of_torsion[0]));
        let turning = input.rolling_inertia * TURNING;
        let rate = about(input.twist);
        let twisted = advance_spring(&self.torsion.driven(input, rate, turning), &mut spring, Some(carried));
        of_torsion[0] = L::Vector::new(spring[0], spring[1], spring[2]).inner(input.normal);
        of_torsion[1] = spring[3];
        RollingResponse {
            torque: rolled.torque + twisted.load,
            dissipated: rolled.dissipated + twisted.dissipated,
        }
    }

    fn damping_ratio(&self) -> f64 {
        self.rolling.damping_ratio()
    }

    #[inline(always)]
    fn energy(&self, history: &[f64]) -> f64 {
        let (of_rolling, of_torsion) = history.split_at(SPRING_HISTORY);
        spring_energy(of_rolling) + spring_energy(&[of_torsion[0], 0.0, 0.0, of_torsion[1]])
    }

    #[inline(always)]
    fn stiffness(&self, size: PairSize, normal_stiffness: f64) -> f64 {
        let [rolling, torsion] = [self.rolling, self.torsion].map(|law| law.stiffness(size, normal_stiffness));
        // as stiff against rolling as gives the same period
        rolling.max(torsion / TURNING)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parameters::Value;
    use glam::DVec3;

    fn law() -> EpsdTorsion {
        let values = [("rolling_friction", 0.1), ("torsion_friction", 0.05)];
        let values: Values = values
            .into_iter()
            .map(|(key, value)| (key.to_string(), Value::Number(value)))
            .collect();
        let steel = crate::contact::Elastic {
            young_modulus: 1e7,
            poisson_ratio: 0.3,
        };
        EpsdTorsion::new(&values, &MaterialPair { a: steel, b: steel }).unwrap()
    }

    fn twisted(twist: f64) -> RollingInput {
        RollingInput {
            size: PairSize::new(1e-3, 1e-5),
            rolling_inertia: 1e-11,
            normal: DVec3::new(0.6, 0.0, 0.8),
            angular_velocity: DVec3::ZERO,
            twist,
            spin: 3.0,
            normal_force: 0.1,
            normal_stiffness: 1e4,
            dt: 1e-6,
            removable_share: 0.5,
        }
    }

    /// A spring while it holds, then a slider: torque against the turn, at most `mu_t R F`.
    #[test]
    fn torsion_is_resisted_up_to_the_limit() {
        let (law, mut history) = (law(), [0.0; 6]);
        let stiffness = 2.25 * 1e4 * (0.05 * 1e-3f64).powi(2);
        let (twist, limit) = (1000.0, 0.05 * 1e-3 * 0.1);
        let (mut dissipated, mut worked) = (0.0, 0.0);
        for step in 1..=400 {
            let input = twisted(twist);
            let response = law.respond(&input, &mut history);
            let along = response.torque.dot(input.normal);
            assert!(
                (response.torque - input.normal * along).length() < 1e-12 * limit,
                "{step}"
            );
            assert!(along < 0.0 && along >= -limit * (1.0 + 1e-12), "{step}: {along}");
            let spring = -(stiffness * twist * 1e-6 * f64::from(step)).min(limit);
            assert!(
                (history[4] - spring).abs() < 1e-9 * limit,
                "{step}: {} {spring}",
                history[4]
            );
            dissipated += response.dissipated;
            worked -= along * twist * 1e-6;
        }
        assert!(history[4] <= -limit * (1.0 - 1e-9), "it never slid");
        let stored = law.energy(&history);
        assert!((stored - 0.5 * limit * limit / stiffness).abs() < 1e-9 * stored);
        assert!(
            (worked - dissipated - stored).abs() < 1e-12 * worked,
            "{worked} {dissipated} {stored}"
        );
    }

    /// Without torsion it is `epsd`, to the bit.
    #[test]
    fn without_torsion_it_is_epsd() {
        let (law, epsd) = (law(), Epsd::of(0.1, 0.3));
        let (mut one, mut other) = ([0.0; 6], [0.0; 4]);
        for step in 0..300 {
            let input = RollingInput {
                angular_velocity: DVec3::Y * (20.0 - 0.1 * f64::from(step)),
                ..twisted(0.0)
            };
            let response = (law.respond(&input, &mut one), epsd.respond(&input, &mut other));
            assert_eq!(response.0.torque, response.1.torque);
            assert_eq!(one[..4], other);
        }
    }
}
