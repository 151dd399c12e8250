//! Periodic boxes that deform: images that move, work from the sides, control of stress.

mod bits;
mod follow;
mod shear_stress;

use crate::cases::{Case, Laws, full, index, law, one_material, report};
use demeter::comm::ShearAxes;
use demeter::contacts::Fault;
use demeter::particles::{Domain, Outside};
use demeter::simulation::{Deformation, DeformationError, Drive, Misfit, Setup, Shear, Simulation, Skin};
use demeter_physics::DVec3;

const RADIUS: f64 = 1e-3;
const STIFFNESS: f64 = 2e3;

/// Numbers in -1..1 that are always the same.
fn symmetric(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed;
    move || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }
}

fn periodic(case: &mut Case, edge: f64) {
    case.domain = Domain {
        lower: DVec3::splat(0.0),
        upper: DVec3::splat(edge),
        periodic: [true; 3],
        outside: Outside::Stop,
    };
}

fn rough() -> Laws {
    Laws::linear(STIFFNESS, 0.6).friction(law(
        "linear-history",
        &[("friction", 0.5), ("stiffness", 0.3 * STIFFNESS)],
    ))
}

/// The same where the contacts of a grain feel each other.
fn rough_and_soft() -> Laws {
    rough().multi_contact("half-space", &[])
}

fn smooth(restitution: f64) -> Laws {
    Laws::linear(STIFFNESS, restitution)
}

/// `edge^3` grains of slightly different sizes near the places of a cubic lattice, that fill a periodic cube to a share.
fn gas(laws: &Laws, edge: u32, fraction: f64, speed: f64, spread: f64) -> Setup {
    let mut case = Case::new(one_material(5e6, laws));
    let cell = RADIUS * libm::cbrt(4.0 / 3.0 * std::f64::consts::PI / fraction);
    periodic(&mut case, cell * f64::from(edge));
    let mut random = symmetric(99);
    let mut vector = || DVec3::new(random(), random(), random());
    let free = 0.49 * (cell - 2.0 * RADIUS * (1.0 + spread)).max(0.0);
    for k in 0..edge * edge * edge {
        let at = DVec3::new(
            f64::from(k % edge),
            f64::from(k / edge % edge),
            f64::from(k / edge / edge),
        );
        let place = (at + 0.5) * cell + vector() * free;
        let radius = RADIUS * (1.0 + spread * vector().x);
        case.spinning_grain(radius, place, vector() * speed, vector() * (speed / RADIUS));
    }
    let grains = &mut case.grains;
    let momentum: DVec3 = grains.velocity.iter().zip(grains.masses()).map(|(v, m)| *v * m).sum();
    let mass: f64 = grains.masses().sum();
    grains.velocity.iter_mut().for_each(|v| *v -= momentum / mass);
    case.skin = 0.2 * RADIUS;
    case.max_overlap = 0.3;
    let setup = case.setup();
    Setup {
        skin: Skin::Tuned(setup.skin.first()),
        ..setup
    }
}

fn shear(flow: usize, gradient: usize, drive: Drive) -> Deformation {
    Deformation {
        shear: Some(Shear {
            axes: ShearAxes { flow, gradient },
            drive,
        }),
        ..Deformation::default()
    }
}

fn isotropic(drive: Drive) -> Deformation {
    Deformation {
        isotropic: drive,
        ..Deformation::default()
    }
}

fn run(sim: &mut Simulation, steps: u64) -> f64 {
    let mut residual = 0.0f64;
    for step in 0..steps {
        sim.step().unwrap();
        if step % 50 == 0 {
            residual = residual.max(sim.energies().residual.abs());
        }
    }
    residual
}

/// Two grains that meet across a side whose images slide move as in open space with a partner that moves as the image does.
#[test]
fn a_contact_across_a_sliding_side_is_that_with_a_moving_partner() {
    let (edge, rate) = (20.0 * RADIUS, 40.0);
    let slides = DVec3::X * (rate * edge);
    let (low, high) = (
        DVec3::new(9.0, 1.5, 10.2) * RADIUS,
        DVec3::new(10.2, 18.9, 10.0) * RADIUS,
    );
    let (v_low, v_high) = (DVec3::new(0.1, -0.6, 0.0), DVec3::new(-0.2, 0.3, 0.1));
    let spin = DVec3::new(20.0, -30.0, 40.0);
    let build = |is_open: bool| {
        let mut case = Case::new(one_material(5e6, &rough()));
        periodic(&mut case, edge);
        case.spinning_grain(RADIUS, low, v_low, spin);
        if is_open {
            case.domain.periodic = [false; 3];
            case.domain.lower = DVec3::splat(-edge);
            // the image below of the one above: it moves back along the flow
            case.spinning_grain(1.2 * RADIUS, high - DVec3::Y * edge, v_high - slides, -spin);
        } else {
            case.spinning_grain(1.2 * RADIUS, high, v_high, -spin);
        }
        case.max_overlap = 0.3;
        case.share = 1e-3;
        case.simulation()
    };
    let (mut open, mut sheared) = (build(true), build(false));
    sheared
        .deform(Deformation {
            affine: false,
            ..shear(0, 1, Drive::StrainRate(rate))
        })
        .unwrap();
    let mut touched = 0;
    let mut largest = 0.0f64;
    for _ in 0..4000 {
        open.step().unwrap();
        sheared.step().unwrap();
        touched += u32::from(open.contacts.acting_pairs() > 0);
        assert_eq!(open.contacts.acting_pairs(), sheared.contacts.acting_pairs());
        for id in [1, 2] {
            let (a, b) = (index(&open, id), index(&sheared, id));
            // the upper grain counts in the frame of its image below, until it passes the side and becomes that
            let boxes = i32::from(id == 2) - sheared.grains().crossings(b)[1];
            let other = sheared.grains().velocity[b] - slides * f64::from(boxes);
            largest = largest.max((open.grains().velocity[a] - other).length());
            largest = largest
                .max((open.grains().angular_velocity[a] - sheared.grains().angular_velocity[b]).length() * RADIUS);
        }
    }
    report("largest difference of velocities [m/s]", largest);
    assert!(touched > 50 && largest < 1e-9, "{touched} {largest}");
}

/// An elastic head-on collision across a shrinking side: the grains approach with the speed of the side on top.
#[test]
fn a_collision_across_a_shrinking_side_takes_up_its_speed() {
    let edge = 20.0 * RADIUS;
    let mut case = Case::new(one_material(5e6, &smooth(1.0)));
    periodic(&mut case, edge);
    let at = |x: f64| DVec3::new(x, 10.0, 10.0) * RADIUS;
    case.grain(RADIUS, at(1.05), DVec3::ZERO);
    case.grain(RADIUS, at(18.95), DVec3::ZERO);
    case.max_overlap = 0.3;
    case.share = 1e-3;
    let mut sim = case.simulation();
    let rate = -5.0;
    sim.deform(Deformation {
        directions: [Drive::StrainRate(rate), Drive::Fixed, Drive::Fixed],
        affine: false,
        ..Deformation::default()
    })
    .unwrap();
    let (mut touched, mut parted) = (false, None);
    for _ in 0..40_000 {
        sim.step().unwrap();
        let touches = sim.contacts.acting_pairs() > 0;
        touched |= touches;
        if touched && !touches {
            parted = Some(sim.grains().velocity[index(&sim, 1)].x - sim.grains().velocity[index(&sim, 2)].x);
            break;
        }
    }
    // the side came with the speed `rate L`; in its frame an elastic collision turns the approach round
    let length = sim.box_state().unwrap().lengths.x;
    let expected = -2.0 * rate * length;
    let parted = parted.unwrap();
    report("speed of parting over twice that of the side", parted / expected);
    assert!((parted / expected - 1.0).abs() < 2e-3, "{parted} {expected}");
    let energies = sim.energies();
    assert!(
        energies.boundary_work > 0.0 && energies.residual.abs() < 1e-4,
        "{energies:?}"
    );
}

/// Momentum beyond the affine flow is conserved; total momentum is no such thing where images move.
#[test]
fn momentum_beyond_the_flow_is_conserved() {
    let mut sim = Simulation::new(gas(&rough(), 6, 0.35, 0.3, 0.1));
    sim.deform(shear(0, 1, Drive::StrainRate(60.0))).unwrap();
    let mut largest = 0.0f64;
    for step in 0..20_000 {
        sim.step().unwrap();
        if step % 100 == 0 {
            let state = sim.box_state().unwrap();
            let middle = 0.5 * (sim.domain().lower + sim.domain().upper);
            let (mut sum, mut all) = (DVec3::ZERO, 0.0);
            for g in 0..sim.grains().len() {
                let flow = DVec3::X * (state.shear_rate * (sim.grains().position[g].y - middle.y));
                let beyond = sim.grains().velocity[g] - flow;
                sum += beyond * sim.grains().mass(g);
                all += beyond.length() * sim.grains().mass(g);
            }
            largest = largest.max(sum.length() / all);
        }
    }
    report("momentum beyond the flow, as a share", largest);
    assert!(
        (0..sim.grains().len()).any(|g| sim.grains().crossings(g)[1] != 0),
        "no grain passed a sliding side"
    );
    assert!(largest < 1e-6, "{largest}");
}

/// A stress is a flux of momentum beside that of the whole: a box whose grains drift, which a shear turns into ever faster drift,
/// feels what one at rest does.
#[test]
fn the_drift_of_all_grains_together_is_no_stress() {
    let run = |drift: DVec3| {
        let mut setup = gas(&smooth(0.9), 4, 0.3, 0.3, 0.1);
        setup.grains.velocity.iter_mut().for_each(|v| *v += drift);
        let mut sim = Simulation::new(setup);
        sim.deform(shear(0, 1, Drive::StrainRate(60.0))).unwrap();
        for _ in 0..400 {
            sim.step().unwrap();
        }
        (sim.box_state().unwrap(), sim.beyond_flow().unwrap())
    };
    let (rest, motion) = run(DVec3::ZERO);
    let (drifting, motion_of_drifting) = run(DVec3::new(2.0, 5.0, -3.0));
    let differ = (rest.stress.iter().zip(&drifting.stress)).map(|(a, b)| (a - b).abs() / rest.pressure());
    let largest = differ.fold(0.0, f64::max);
    report("stress of the drift over the pressure", largest);
    assert!(rest.kinetic_stress[0] > 0.1 * rest.pressure(), "{rest:?}");
    assert!(largest < 1e-9, "{rest:?} {drifting:?}");
    for (a, b) in [(motion.0, motion_of_drifting.0), (motion.1, motion_of_drifting.1)] {
        assert!((a / b - 1.0).abs() < 1e-9, "{a} {b}");
    }
}

/// Where a run is cut into boxes changes nothing: grains moved along the gradient, with the flow of their new places, feel
/// the same.
#[test]
fn the_place_of_the_sides_does_not_matter() {
    [rough(), rough_and_soft()].iter().for_each(hold_in_boxes_cut_elsewhere);
}

fn hold_in_boxes_cut_elsewhere(laws: &Laws) {
    let build = |moved: f64| {
        let mut setup = gas(laws, 6, 0.5, 0.2, 0.1);
        let (lower, upper) = (setup.domain.lower, setup.domain.upper);
        for place in setup.grains.position.iter_mut() {
            place.y += moved;
            if place.y >= upper.y {
                place.y -= upper.y - lower.y;
            }
        }
        let mut sim = Simulation::new(setup);
        sim.deform(shear(0, 1, Drive::StrainRate(80.0))).unwrap();
        sim
    };
    let (mut one, mut other) = (build(0.0), build(4.3 * RADIUS));
    let mut largest = 0.0f64;
    for _ in 0..400 {
        one.step().unwrap();
        other.step().unwrap();
        let (a, b) = (one.box_state().unwrap(), other.box_state().unwrap());
        for (x, y) in a.stress.iter().zip(b.stress) {
            largest = largest.max((x - y).abs() / a.pressure().abs().max(1e-9));
        }
    }
    assert!(one.contacts.acting_pairs() > 50);
    report("largest difference of the stress, as a share", largest);
    assert!(largest < 1e-6, "{largest}");
}

/// A steady shear flow has a linear profile, whether it begins with one or not.
#[test]
fn a_sheared_gas_has_a_linear_profile() {
    let rate = 100.0;
    let mut sim = Simulation::new(gas(&rough(), 8, 0.5, 0.1, 0.15));
    sim.deform(shear(0, 2, Drive::StrainRate(rate))).unwrap();
    let steps = (3.0 / rate / sim.dt()) as u64;
    let residual = run(&mut sim, steps);
    const BINS: usize = 8;
    let (mut sum, mut count) = ([0.0; BINS], [0.0; BINS]);
    let edge = sim.domain().size().z;
    let between = (0.05 / rate / sim.dt()) as u64;
    for _ in 0..60 {
        run(&mut sim, between);
        for g in 0..sim.grains().len() {
            let share = (sim.grains().position[g].z / edge).clamp(0.0, 0.999_999);
            let bin = (share * BINS as f64) as usize;
            sum[bin] += sim.grains().velocity[g].x - rate * (sim.grains().position[g].z - 0.5 * edge);
            count[bin] += 1.0;
        }
    }
    let worst = (0..BINS)
        .map(|b| (sum[b] / count[b]).abs() / (rate * edge))
        .fold(0.0, f64::max);
    report(
        "largest deviation of the profile, as a share of the speed across",
        worst,
    );
    report("largest residual of the shear", residual);
    assert!(worst < 0.04, "{worst}");
    assert!(residual < 1e-3, "{residual}");
    let state = sim.box_state().unwrap();
    assert!(
        state.stress[4] < 0.0,
        "the stress must resist the shear: {:?}",
        state.stress
    );
    assert!(sim.energies().boundary_work > 0.0);
}

/// All pairs of grains and images that overlap are in the table, whatever the offset.
#[test]
fn no_contact_across_a_moving_side_is_missed() {
    for (flow, gradient) in [(0, 1), (2, 0), (1, 2)] {
        let mut sim = Simulation::new(gas(&rough(), 6, 0.35, 0.3, 0.3));
        sim.deform(shear(flow, gradient, Drive::StrainRate(150.0))).unwrap();
        let (mut looked, mut across) = (0, 0);
        for step in 0..3000 {
            sim.step().unwrap();
            if step % 50 == 0 {
                let (all, beyond) = compare_with_all_pairs(&sim, flow, gradient);
                looked += all;
                across += beyond;
            }
        }
        assert!(looked > 2000 && across > 80, "{looked} {across}");
        assert!(sim.rebuilds() > 15, "{}", sim.rebuilds());
    }
}

/// Compares the engaged contacts with all pairs that overlap. Tells how many there are, and how many across the sliding side.
fn compare_with_all_pairs(sim: &Simulation, flow: usize, gradient: usize) -> (usize, usize) {
    let state = sim.box_state().unwrap();
    let (grains, size) = (sim.grains(), state.lengths);
    let mut edges = [DVec3::X * size.x, DVec3::Y * size.y, DVec3::Z * size.z];
    edges[gradient][flow] = state.shear_strain * size[gradient] % size[flow];
    let mut engaged = std::collections::BTreeSet::new();
    for chunk in &sim.contacts.pairs {
        for k in (0..chunk.len()).filter(|&k| chunk.is_engaged(k)) {
            engaged.insert((chunk.i[k].min(chunk.j[k]), chunk.i[k].max(chunk.j[k])));
        }
    }
    let (mut found, mut across) = (0, 0);
    for i in 0..grains.len() {
        for j in i + 1..grains.len() {
            let touch = grains.radius(i) + grains.radius(j);
            for code in 0..45 {
                let boxes = [code % 5 - 2, code / 5 % 3 - 1, code / 15 - 1].map(f64::from);
                let mut apart = grains.position[i] - grains.position[j] + edges[flow] * boxes[0];
                apart += edges[gradient] * boxes[1] + edges[3 - flow - gradient] * boxes[2];
                if apart.length() < touch {
                    found += 1;
                    across += usize::from(boxes[1] != 0.0);
                    let pair = (i as u32, j as u32);
                    assert!(
                        engaged.contains(&pair),
                        "step {}: {pair:?} by {boxes:?} is missing",
                        sim.step
                    );
                }
            }
        }
    }
    (found, across)
}

/// A frictionless packing that is compressed at a stress comes to rest at it, jammed at random close packing.
#[test]
fn a_frictionless_packing_jams_at_random_close_packing() {
    let mut sim = Simulation::new(gas(&smooth(0.3), if full() { 10 } else { 6 }, 0.3, 0.2, 0.0));
    let target = 1e-4 * STIFFNESS / RADIUS;
    sim.deform(isotropic(Drive::Stress { target, max_rate: 30.0 })).unwrap();
    let steps = (0.2 / sim.dt()) as u64;
    let mut residual = run(&mut sim, steps);
    let mut quiet = 0;
    for _ in 0..200 {
        residual = residual.max(run(&mut sim, 500));
        let (energies, state) = (sim.energies(), sim.box_state().unwrap());
        quiet = if energies.kinetic < 1e-4 * energies.elastic && (state.pressure() / target - 1.0).abs() < 1e-3 {
            quiet + 1
        } else {
            0
        };
        if quiet > 3 {
            break;
        }
    }
    let state = sim.box_state().unwrap();
    report("solid fraction", state.solid_fraction);
    report("stress over its target", state.pressure() / target);
    report("largest residual", residual);
    assert!(
        (state.pressure() / target - 1.0).abs() < 1e-2,
        "{}",
        state.pressure() / target
    );
    assert!((0.60..0.67).contains(&state.solid_fraction), "{}", state.solid_fraction);
    assert!(residual < 1e-3, "{residual}");
}

/// Triaxial: two stresses held while the third direction is compressed; and without the affine term.
#[test]
fn stresses_are_held_while_another_direction_is_strained() {
    for affine in [true, false] {
        let mut sim = Simulation::new(gas(&rough(), 6, 0.5, 0.05, 0.15));
        let target = 1e-3 * STIFFNESS / RADIUS;
        let hold = Drive::Stress { target, max_rate: 20.0 };
        sim.deform(Deformation {
            affine,
            ..isotropic(hold)
        })
        .unwrap();
        let mut residual = run(&mut sim, 30_000);
        let before = sim.box_state().unwrap();
        assert!(
            (before.pressure() / target - 1.0).abs() < 0.02,
            "{affine}: {}",
            before.pressure() / target
        );
        let rate = -1.0;
        sim.deform(Deformation {
            directions: [hold, hold, Drive::StrainRate(rate)],
            affine,
            ..Deformation::default()
        })
        .unwrap();
        let steps = (0.05 / sim.dt()) as u64;
        let (mut sums, mut count) = ([0.0; 3], 0.0);
        for _ in 0..steps / 50 {
            residual = residual.max(run(&mut sim, 50));
            let stress = sim.box_state().unwrap().stress;
            sums.iter_mut().zip(stress).for_each(|(sum, s)| *sum += s);
            count += 1.0;
        }
        let after = sim.box_state().unwrap();
        let strained = after.strain.z - before.strain.z;
        assert!(
            (strained / (rate * sim.dt() * (steps / 50 * 50) as f64) - 1.0).abs() < 1e-6,
            "{strained}"
        );
        let [x, y, z] = sums.map(|s| s / count / target);
        report("mean stress over its target, along x", x);
        report("mean stress over its target, along z", z);
        report("largest residual", residual);
        assert!((x - 1.0).abs() < 0.05 && (y - 1.0).abs() < 0.05, "{affine}: {x} {y}");
        assert!(z > 1.2, "{affine}: the compressed direction bears more: {z}");
        assert!(residual < 1e-3, "{affine}: {residual}");
    }
}

/// Normal stress along the gradient [Pa].
const PRESSURE: f64 = 1e-3 * STIFFNESS / RADIUS;

/// Shear at a constant normal stress along the gradient.
fn sheared_at_constant_stress(laws: &Laws, edge: u32, drive: Drive) -> Simulation {
    let mut sim = Simulation::new(gas(laws, edge, 0.52, 0.1, 0.15));
    sim.deform(plan_at_constant_stress(drive)).unwrap();
    sim
}

fn plan_at_constant_stress(drive: Drive) -> Deformation {
    let mut plan = shear(0, 1, drive);
    plan.directions[1] = Drive::Stress {
        target: PRESSURE,
        max_rate: 20.0,
    };
    plan
}

#[test]
fn shear_at_constant_stress_holds_the_stress_and_its_books() {
    [rough(), rough_and_soft()].iter().for_each(hold_the_books);
}

fn hold_the_books(laws: &Laws) {
    let mut sim = sheared_at_constant_stress(laws, 7, Drive::StrainRate(50.0));
    let mut residual = run(&mut sim, 12_000);
    let (mut normal, mut shear_stress) = (0.0, 0.0);
    for _ in 0..150 {
        residual = residual.max(run(&mut sim, 50));
        let stress = sim.box_state().unwrap().stress;
        normal += stress[1] / 150.0;
        shear_stress -= stress[3] / 150.0;
    }
    report("normal stress over its target", normal / PRESSURE);
    report("friction of the flow", shear_stress / normal);
    report("largest residual", residual);
    assert!((normal / PRESSURE - 1.0).abs() < 0.05, "{}", normal / PRESSURE);
    assert!(
        (0.2..0.9).contains(&(shear_stress / normal)),
        "{}",
        shear_stress / normal
    );
    assert!(residual < 1e-3, "{residual}");
}

/// A box that is shrunk without end stops with a fault that names it.
#[test]
fn a_box_that_is_too_small_is_a_fault() {
    let mut case = Case::new(one_material(5e6, &smooth(0.5)));
    periodic(&mut case, 20.0 * RADIUS);
    case.grain(RADIUS, DVec3::splat(10.0 * RADIUS), DVec3::ZERO);
    case.skin = 0.2 * RADIUS;
    let mut sim = case.simulation();
    sim.deform(isotropic(Drive::StrainRate(-50.0))).unwrap();
    let fault = (0..1_000_000).find_map(|_| sim.step().err()).unwrap();
    assert!(
        matches!(&fault, Fault::BoxTooSmall { direction, .. } if direction == "x"),
        "{fault}"
    );
    assert!(sim.domain().size().x > 4.0 * RADIUS);
}

#[test]
fn what_does_not_go_with_a_deforming_box_is_refused() {
    let plan = isotropic(Drive::StrainRate(-1.0));
    let mut case = Case::new(one_material(5e6, &smooth(0.5)));
    case.grain(RADIUS, DVec3::ZERO, DVec3::ZERO);
    let not_periodic = case.simulation().deform(plan);
    assert_eq!(not_periodic, Err(DeformationError::NotPeriodic { direction: "x" }));
    let refused = |change: fn(&mut Case), plan: Deformation| {
        let mut case = Case::new(one_material(5e6, &smooth(0.5)));
        periodic(&mut case, 20.0 * RADIUS);
        case.grain(RADIUS, DVec3::splat(10.0 * RADIUS), DVec3::ZERO);
        change(&mut case);
        case.simulation().deform(plan).unwrap_err()
    };
    let wall = refused(|case| case.plane(0, DVec3::ZERO, DVec3::Z), plan);
    assert_eq!(wall, DeformationError::With(Misfit::Walls));
    let gravity = refused(|case| case.gravity = DVec3::Z, plan);
    assert_eq!(gravity, DeformationError::With(Misfit::Gravity));
    let fast = refused(|_| (), isotropic(Drive::StrainRate(-1e9)));
    assert!(matches!(fast, DeformationError::TooFast { .. }), "{fast}");
    let flat = refused(|_| (), shear(1, 1, Drive::StrainRate(1.0)));
    assert_eq!(flat, DeformationError::NoPlane { direction: "y" });
    let pull = refused(
        |_| (),
        isotropic(Drive::Stress {
            target: f64::NAN,
            max_rate: 1.0,
        }),
    );
    assert!(matches!(pull, DeformationError::Value { .. }), "{pull}");
    let mut sim = Simulation::new(gas(&smooth(0.5), 4, 0.1, 0.0, 0.0));
    sim.deform(shear(0, 1, Drive::StrainRate(1.0))).unwrap();
    let other = sim.deform(shear(0, 2, Drive::StrainRate(1.0)));
    assert_eq!(
        other,
        Err(DeformationError::OtherShear {
            flow: "x",
            gradient: "y"
        })
    );
}
