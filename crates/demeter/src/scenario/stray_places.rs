//! Regions, gates and cells that lie wholly outside of the domain, where no grain ever is.

use super::Scenario;
use super::measures::MeasureKind;
use crate::measure::{Gate, MassFlow, MixingSpace};
use crate::particles::{Zone, ZoneShape};
use glam::DVec3;

/// Corners of a box around a place.
type Bounds = (DVec3, DVec3);

/// Tells them. A domain that deforms, or that nobody told, is not looked at.
pub(super) fn check(scenario: &Scenario, warnings: &mut Vec<String>) {
    let Some(domain) = scenario.domain.bounds.filter(|_| !scenario.deforms()) else {
        return;
    };
    let periodic = scenario.domain.periodic;
    let mut told = Vec::new();
    for measure in &scenario.measures {
        let name = &measure.name;
        if measure.kind.zone().is_some_and(|zone| zone_misses(zone, domain)) {
            told.push(format!("the `region` of measure `{name}`"));
        }
        match &measure.kind {
            MeasureKind::MassFlow(flow) if gate_misses(flow, domain, periodic) => {
                told.push(format!("the gate of measure `{name}`"));
            }
            // every image of the cells counts along periodic sides
            MeasureKind::Mixing(mixing) if are_apart(bounds_of(&mixing.space), domain, periodic) => {
                told.push(format!("the cells of measure `{name}`"));
            }
            _ => {}
        }
    }
    for removal in scenario
        .removals
        .iter()
        .filter(|removal| zone_misses(&removal.zone, domain))
    {
        told.push(format!("the `region` of removal `{}`", removal.name));
    }
    for (index, _) in scenario
        .tags
        .iter()
        .enumerate()
        .filter(|(_, tag)| zone_misses(&tag.zone, domain))
    {
        told.push(format!("the `region` of tag[{index}]"));
    }
    let [lower, upper] = [domain.0, domain.1].map(|corner| format!("{} {} {} m", corner.x, corner.y, corner.z));
    warnings.extend(told.into_iter().map(|what| {
        format!(
            "{what} lies wholly outside of the domain, which reaches from {lower} to {upper}: no grain is ever there"
        )
    }));
}

/// Whether no point of the domain lies in a zone, as one of its parts tells; those that go with walls may come.
fn zone_misses(zone: &Zone, domain: Bounds) -> bool {
    let mut parts = zone.parts.iter().filter(|part| part.wall.is_none() && !part.outside);
    parts.any(|part| match &part.shape {
        ZoneShape::Box { lower, upper } => are_apart((*lower, *upper), domain, [false; 3]),
        ZoneShape::Cylinder { start, end, radius } => are_apart(around_axis(*start, *end, *radius), domain, [false; 3]),
        ZoneShape::Cone {
            start,
            end,
            start_radius,
            end_radius,
        } => are_apart(
            around_axis(*start, *end, start_radius.max(*end_radius)),
            domain,
            [false; 3],
        ),
        ZoneShape::Sphere { center, radius } => are_apart((*center - *radius, *center + *radius), domain, [false; 3]),
        ZoneShape::HalfSpace { point, normal } => heights(*point, *normal, domain).1 <= 0.0,
        ZoneShape::Mesh(interior) => are_apart(interior.bounds(), domain, [false; 3]),
    })
}

/// Whether no way within the domain leads through a gate.
fn gate_misses(flow: &MassFlow, domain: Bounds, periodic: [bool; 3]) -> bool {
    let reach = match flow.gate {
        Gate::Plane => {
            let (lowest, highest) = heights(flow.point, flow.normal, domain);
            let is_crossed = |axis: usize| periodic[axis] && flow.normal[axis] != 0.0;
            return !(0..3).any(is_crossed) && (lowest > 0.0 || highest < 0.0);
        }
        Gate::Disc(radius) => radius * across(flow.normal),
        Gate::Rectangle(half_u, half_v) => half_u.abs() + half_v.abs(),
    };
    are_apart((flow.point - reach, flow.point + reach), domain, periodic)
}

fn bounds_of(space: &MixingSpace) -> Bounds {
    match *space {
        MixingSpace::Box { lower, upper } => (lower, upper),
        MixingSpace::Cylinder { start, end, radius } => around_axis(start, end, radius),
    }
}

/// A box around a cylinder.
fn around_axis(start: DVec3, end: DVec3, radius: f64) -> Bounds {
    let reach = radius * across((end - start).normalize_or_zero());
    (start.min(end) - reach, start.max(end) + reach)
}

/// How far a disc of radius 1 reaches along every axis, by its unit normal.
fn across(normal: DVec3) -> DVec3 {
    (DVec3::ONE - normal * normal).max(DVec3::ZERO).map(libm::sqrt)
}

/// Lowest and highest height of a box above a plane.
fn heights(point: DVec3, normal: DVec3, (lower, upper): Bounds) -> (f64, f64) {
    let (middle, half) = ((lower + upper) * 0.5, (upper - lower) * 0.5);
    let (height, reach) = ((middle - point).dot(normal), half.dot(normal.abs()));
    (height - reach, height + reach)
}

/// Whether two boxes have no point in common, along an axis that is not left out.
fn are_apart(one: Bounds, other: Bounds, left_out: [bool; 3]) -> bool {
    (0..3).any(|k| !left_out[k] && (one.1[k] < other.0[k] || one.0[k] > other.1[k]))
}
