//! Whether grains are stiff enough for how fast they begin, and springs soft enough for how grains give way.

use super::Scenario;
use super::checks::wall_partners;
use crate::materials::Materials;
use crate::particles::Grains;
use crate::simulation::{FastestImpact, fastest_impact, too_stiff};
use crate::walls::Wall;

/// Tells springs of a given stiffness that have no force where the contacts of a grain feel each other.
pub(super) fn check_stiffness(
    scenario: &Scenario,
    (grains, walls): (&Grains, &[Wall]),
    materials: &Materials,
    warnings: &mut Vec<String>,
) {
    if !materials.are_coupled() {
        return;
    }
    let partners = wall_partners(scenario, walls);
    if let Some(found) = too_stiff(grains, &partners, materials, scenario.simulation.max_overlap) {
        warnings.push(format!(
            "contacts of {} have a stiffness of {:.3e} N/m, and by `contact.multi_contact` a grain of this `young_modulus` gives way by more \
             than such a contact is pressed from {:.3e} N/m on: between two of them on opposite sides there is no force that fits, and \
             the run ends; take a softer spring, a larger `young_modulus`, or a law whose stiffness follows from it, as `hertz-tsuji`",
            found.bodies, found.stiffness, found.allowed
        ));
    }
}

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
