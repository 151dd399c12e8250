//! Profiles and mixing indices across periodic sides: every image counts, nothing is lost at a side.

use crate::cases::{Case, Laws, one_material};
use demeter::measure::{Along, CylinderProfile, Mixing, MixingSpace, Profile, Selection, Value};
use demeter::particles::{Domain, Origins, Outside};
use demeter::simulation::Simulation;
use demeter_physics::DVec3;
use std::f64::consts::PI;

const RADIUS: f64 = 1e-3;
const SIDE: usize = 4;
const SPACING: f64 = 2.5e-3;
const LENGTH: f64 = SIDE as f64 * SPACING;

/// Grains of a simple cubic lattice in a periodic box, shifted so that its layers stick out of some sides and lie in the middle of others.
/// Every second one along x has an odd id.
fn lattice() -> Simulation {
    let mut case = Case::new(one_material(1e7, &Laws::hertz(0.5)));
    case.domain = Domain {
        lower: DVec3::ZERO,
        upper: DVec3::splat(LENGTH),
        periodic: [true; 3],
        outside: Outside::Stop,
    };
    for k in 0..SIDE.pow(3) {
        let at = DVec3::from_array([k % SIDE, k / SIDE % SIDE, k / SIDE / SIDE].map(|i| i as f64 * SPACING));
        let shift = DVec3::new(0.1, 0.3, 0.5) * SPACING;
        case.grain(RADIUS, at + shift, DVec3::X * (k % SIDE) as f64);
    }
    case.simulation()
}

fn solid_fraction() -> f64 {
    SIDE.pow(3) as f64 * 4.0 / 3.0 * PI * RADIUS.powi(3) / LENGTH.powi(3)
}

fn close(found: f64, expected: f64, tolerance: f64, what: &str) {
    assert!(
        (found / expected - 1.0).abs() < tolerance,
        "{what}: {found}, not {expected}"
    );
}

#[test]
fn a_profile_counts_what_reaches_in_across_periodic_sides() {
    let sim = lattice();
    for axis in 0..3 {
        // the whole box, one that reaches across a side, and two boxes side by side
        for (from, to) in [(0.0, 1.0), (-0.4, 0.6), (0.3, 2.3)] {
            let (mut lower, mut upper) = (DVec3::ZERO, DVec3::splat(LENGTH));
            (lower[axis], upper[axis]) = (from * LENGTH, to * LENGTH);
            for slices in [1, 5] {
                let selection = Selection::default();
                let profile = Profile {
                    lower,
                    upper,
                    axis,
                    slices,
                    selection,
                };
                let told = profile.measure(&sim, &Origins::default());
                let label = format!("axis {axis}, {from} to {to}, {slices} slices");
                let mean = told.iter().map(|slice| slice.packing_fraction).sum::<f64>() / f64::from(slices);
                close(mean, solid_fraction(), 1e-12, &label);
                let grains: u64 = told.iter().map(|slice| slice.grains).sum();
                let boxes = (to - from).round() as u64;
                assert_eq!(grains, boxes * SIDE.pow(3) as u64, "{label}");
            }
        }
    }
}

#[test]
fn a_cylinder_profile_is_the_same_wherever_it_begins_on_a_periodic_axis() {
    let sim = lattice();
    let fraction = |from: f64, along, bins| {
        let across = DVec3::new(0.0, 0.95, 0.05) * LENGTH;
        let start = across + DVec3::X * (from * LENGTH);
        let profile = CylinderProfile {
            start,
            end: start + DVec3::X * LENGTH,
            radius: 0.3 * LENGTH,
            along,
            bins,
            selection: Selection::default(),
        };
        let told = profile.measure(&sim, &Origins::default());
        (
            told.iter().map(|ring| ring.packing_fraction).sum::<f64>() / f64::from(bins),
            told.iter().map(|ring| ring.grains).sum::<u64>(),
        )
    };
    let (whole, grains) = fraction(0.05, Along::Radius, 1);
    assert!(grains > 10 && (0.2..0.4).contains(&whole), "{grains} {whole}");
    for from in [-0.25, 0.0, 0.4, 0.9] {
        let (found, counted) = fraction(from, Along::Axis, 4);
        close(found, whole, 2e-3, &format!("from {from}"));
        assert_eq!(counted, grains, "from {from}");
    }
}

#[test]
fn mixing_looks_at_images_in_cells_beyond_a_periodic_side() {
    let sim = lattice();
    let index = |from: f64| {
        let mixing = Mixing {
            space: MixingSpace::Box {
                lower: DVec3::splat(from * LENGTH),
                upper: DVec3::splat((from + 1.0) * LENGTH),
            },
            cells: [4, 1, 1],
            selection: Selection {
                ids: (1..=64).step_by(2).collect(),
                ..Selection::default()
            },
        };
        mixing.measure(&sim, &Origins::default())
    };
    for from in [0.0, 0.5, -1.25] {
        // layers of one kind each
        let told = index(from);
        assert!(
            matches!(told[0], Value::Number(lacey) if lacey.abs() < 1e-12),
            "{from}: {told:?}"
        );
        assert!(
            matches!(told[1], Value::Number(share) if share == 0.5),
            "{from}: {told:?}"
        );
        assert!(matches!(told[2], Value::Count(4)), "{from}: {told:?}");
    }
}
