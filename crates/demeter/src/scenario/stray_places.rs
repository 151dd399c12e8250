//! Regions, gates and grids that lie wholly outside of the domain, where no grain ever is, and regions that a periodic side cuts.

use super::Scenario;
use super::measures::MeasureKind;
use crate::measure::{Gate, MassFlow, MixingSpace};
use crate::particles::{Zone, ZoneShape};
use crate::walls::Wall;
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
    for (zone, whose) in zones(scenario) {
        if zone_misses(zone, domain) {
            told.push(format!("the `region` of {whose}"));
        } else {
            warnings.extend(
                (0..3)
                    .filter(|k| periodic[*k])
                    .filter_map(|axis| cut(zone, &whose, domain, axis)),
            );
        }
    }
    for measure in &scenario.measures {
        if let Some(part) = part_that_misses(&measure.kind, domain, periodic) {
            told.push(format!("the {part} of measure `{}`", measure.name));
        }
    }
    for feed in &scenario.feeds {
        if let Some((point, normal)) = feed.end.level
            && plane_misses(point, normal, domain, periodic, |_, highest| highest <= 0.0)
        {
            told.push(format!("what is beyond the `level` of feed `{}`", feed.name));
        }
    }
    let [lower, upper] = [domain.0, domain.1].map(|corner| format!("{} {} {} m", corner.x, corner.y, corner.z));
    warnings.extend(told.into_iter().map(|what| {
        format!(
            "{what} lies wholly outside of the domain, which reaches from {lower} to {upper}: no grain is ever there"
        )
    }));
}

/// All regions in which a grain is when its centre is in the box, and whose each is.
fn zones(scenario: &Scenario) -> Vec<(&Zone, String)> {
    let measures = scenario.measures.iter();
    let of_measures = measures.filter_map(|m| Some((m.kind.zone()?, format!("measure `{}`", m.name))));
    let of_removals = scenario
        .removals
        .iter()
        .map(|r| (&r.zone, format!("removal `{}`", r.name)));
    let tags = scenario.tags.iter().enumerate();
    let of_tags = tags.map(|(index, tag)| (&tag.zone, format!("tag[{index}]")));
    of_measures.chain(of_removals).chain(of_tags).collect()
}

/// What to tell of a zone that ends beyond one periodic side and not beyond the other: what reaches beyond both, or without end, is cut on
/// purpose.
fn cut(zone: &Zone, whose: &str, domain: Bounds, axis: usize) -> Option<String> {
    let (lower, upper) = around_zone(zone);
    let (from, to) = (domain.0[axis], domain.1[axis]);
    let rounding = Wall::SAME_LENGTH * (to - from);
    let is_beyond = [lower[axis] < from - rounding, upper[axis] > to + rounding];
    let (side, end) = match is_beyond {
        [true, false] => (from, lower[axis]),
        [false, true] => (to, upper[axis]),
        _ => return None,
    };
    end.is_finite().then(|| {
        let name = ["x", "y", "z"][axis];
        format!(
            "the `region` of {whose} reaches beyond the periodic side at {name} = {side:.4e} m, to {end:.4e} m: what of it lies there counts \
             nothing, for a grain counts where it is in the box. Let it end at the side, and tell what is beyond as a second region, \
             {:.4e} m away at the other side",
            to - from
        )
    })
}

/// A box around what all parts of a zone have in common, those that go with walls and outsides left aside.
fn around_zone(zone: &Zone) -> Bounds {
    let parts = zone.parts.iter().filter(|part| part.wall.is_none() && !part.outside);
    let everywhere = (DVec3::NEG_INFINITY, DVec3::INFINITY);
    parts.fold(everywhere, |all, part| {
        let (lower, upper) = around(&part.shape).unwrap_or(everywhere);
        (all.0.max(lower), all.1.min(upper))
    })
}

/// The part of a measure that no grain of the domain comes to, beside its region. Along periodic sides every image counts.
fn part_that_misses(kind: &MeasureKind, domain: Bounds, periodic: [bool; 3]) -> Option<&'static str> {
    let (part, misses) = match kind {
        MeasureKind::MassFlow(flow) => ("gate", gate_misses(flow, domain, periodic)),
        MeasureKind::Mixing(mixing) => ("grid", are_apart(bounds_of(&mixing.space), domain, periodic)),
        MeasureKind::Profile(profile) => ("box", are_apart((profile.lower, profile.upper), domain, periodic)),
        MeasureKind::CylinderProfile(profile) => {
            let cylinder = around_axis(profile.start, profile.end, profile.radius);
            ("cylinder", are_apart(cylinder, domain, periodic))
        }
        MeasureKind::Field(field) => {
            let (lower, upper) = field.corners?;
            let reach = DVec3::splat(field.kernel.reach());
            ("grid", are_apart((lower - reach, upper + reach), domain, periodic))
        }
        MeasureKind::ContactNetwork(network) => ("region", are_apart(network.region?, domain, periodic)),
        MeasureKind::Slope(slope) => {
            let (from, to) = slope.between;
            let is_apart = |lowest: f64, highest: f64| highest < from || lowest > to;
            (
                "surface",
                plane_misses(slope.point, slope.along?, domain, periodic, is_apart),
            )
        }
        _ => return None,
    };
    misses.then_some(part)
}

/// Whether the heights of the domain above a plane, the lowest and the highest, are such that no grain is looked at; along periodic sides
/// every image counts.
fn plane_misses(
    point: DVec3,
    normal: DVec3,
    domain: Bounds,
    periodic: [bool; 3],
    misses: impl Fn(f64, f64) -> bool,
) -> bool {
    let (lowest, highest) = heights(point, normal, domain);
    !(0..3).any(|axis| periodic[axis] && normal[axis] != 0.0) && misses(lowest, highest)
}

/// Whether no point of the domain lies in a zone, as one of its parts tells; those that go with walls may come.
fn zone_misses(zone: &Zone, domain: Bounds) -> bool {
    let mut parts = zone.parts.iter().filter(|part| part.wall.is_none() && !part.outside);
    parts.any(|part| match &part.shape {
        ZoneShape::HalfSpace { point, normal } => heights(*point, *normal, domain).1 <= 0.0,
        shape => around(shape).is_some_and(|bounds| are_apart(bounds, domain, [false; 3])),
    })
}

/// A box around a shape; a half-space has none.
fn around(shape: &ZoneShape) -> Option<Bounds> {
    Some(match shape {
        ZoneShape::Box { lower, upper } => (*lower, *upper),
        ZoneShape::Cylinder { start, end, radius } => around_axis(*start, *end, *radius),
        ZoneShape::Cone {
            start,
            end,
            start_radius,
            end_radius,
        } => around_axis(*start, *end, start_radius.max(*end_radius)),
        ZoneShape::Sphere { center, radius } => (*center - *radius, *center + *radius),
        ZoneShape::Mesh(interior) => interior.bounds(),
        ZoneShape::HalfSpace { .. } => return None,
    })
}

/// Whether no way within the domain leads through a gate.
fn gate_misses(flow: &MassFlow, domain: Bounds, periodic: [bool; 3]) -> bool {
    let reach = match flow.gate {
        Gate::Plane => {
            let is_beside = |lowest: f64, highest: f64| lowest > 0.0 || highest < 0.0;
            return plane_misses(flow.point, flow.normal, domain, periodic, is_beside);
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
