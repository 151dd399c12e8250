//! Whether grains are stiff enough for how fast they begin.

use super::Scenario;
use super::checks::wall_partners;
use crate::materials::Materials;
use crate::particles::Grains;
use crate::simulation::{FastestImpact, fastest_impact};
use crate::walls::Wall;

/// The impact that the softest contact bears; grains that begin faster are told.
pub(super) fn check(
    scenario: &Scenario,
    (grains, walls): (&Grains, &[Wall]),
    materials: &Materials,
    warnings: &mut Vec<String>,
) -> Option<FastestImpact> {
    let allowed = scenario.simulation.max_overlap;
    let borne = fastest_impact(grains, &wall_partners(scenario, walls), materials, allowed)?;
    let speeds = (0..grains.len()).map(|g| (grains.velocity[g].length(), g));
    let started =
        (speeds.max_by(|a, b| a.0.total_cmp(&b.0))).map(|(speed, g)| (speed, format!("grain {}", grains.id[g])));
    let fed = scenario.feeds.iter().map(|feed| {
        let speed = feed.stream.velocity.length();
        (speed, format!("feed `{}`", feed.name))
    });
    let fastest = started.into_iter().chain(fed).max_by(|a, b| a.0.total_cmp(&b.0));
    if let Some((speed, what)) = fastest.filter(|(speed, _)| *speed > borne.speed) {
        warnings.push(format!(
            "{what} begins with {speed:.3} m/s, and a head-on impact of {:.3} m/s overlaps {} by {allowed} of the smaller radius, which would stop \
             the run: let them be stiffer or slower, or raise `simulation.max_overlap`",
            borne.speed, borne.bodies
        ));
    }
    Some(borne)
}
