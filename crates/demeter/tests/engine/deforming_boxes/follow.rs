//! What follows the box as it deforms: gates, and lattices whose contacts feel each other.

use super::*;
use demeter::measure::{FlowState, Gate, MassFlow, Selection, Value};
use demeter::particles::Origins;

/// A grain that goes out at a sliding side comes in elsewhere at the other: that is no way through a gate between both places.
#[test]
fn a_jump_across_a_sliding_side_is_no_flow() {
    let mut case = Case::new(one_material(5e6, &smooth(0.5)));
    periodic(&mut case, 20.0 * RADIUS);
    case.skin = 0.2 * RADIUS;
    let (rate, offset) = (50.0, 1.5 * RADIUS);
    let time = offset / (rate * 20.0 * RADIUS);
    let start = DVec3::new(10.75, 15.0, 10.0) * RADIUS;
    case.grain(RADIUS, start, DVec3::Y * (5.0 * RADIUS / time));
    let mut sim = case.simulation();
    sim.deform(Deformation {
        affine: false,
        ..shear(0, 1, Drive::StrainRate(rate))
    })
    .unwrap();
    let gate = |x: f64| MassFlow {
        point: DVec3::new(x, 10.0, 10.0) * RADIUS,
        normal: DVec3::X,
        gate: Gate::Plane,
        selection: Selection::default(),
    };
    // the second gate lies where the grain goes afterwards, with the flow of its new place
    let gates = [gate(10.0), gate(8.5)];
    let mut states = [FlowState::default(), FlowState::default()];
    let mut largest_jump = 0.0f64;
    while sim.time() < 2.5 * time {
        let before = sim.grains().position[0];
        sim.step().unwrap();
        largest_jump = largest_jump.max((sim.grains().position[0] - before).x.abs());
        for (gate, state) in gates.iter().zip(&mut states) {
            gate.look(&sim, &Origins::default(), state);
        }
    }
    assert!((largest_jump / offset - 1.0).abs() < 0.05, "{largest_jump}");
    let counts = [0, 1].map(|k| match gates[k].measure(&sim, &mut states[k])[..] {
        [Value::Count(forward), _, Value::Count(backward), ..] => [forward, backward],
        _ => panic!("no counts"),
    });
    assert_eq!(counts, [[0, 0], [0, 1]]);
}

/// A lattice whose contacts feel each other, squeezed with its box, bears at every moment what it bears at rest in a box of that
/// size (which `verification::multi_contact` holds against exact values); it is brought there from where no grain touches.
#[test]
fn a_lattice_squeezed_with_its_box_bears_what_it_bears_at_rest() {
    let laws = Laws::hertz(1.0).multi_contact("half-space", &[]);
    let lattice = |edge: f64| {
        let mut case = Case::new(one_material(5e6, &laws));
        periodic(&mut case, 3.0 * edge);
        case.max_overlap = 0.3;
        case.skin = 0.1 * RADIUS;
        for k in 0..27 {
            let at = DVec3::new(f64::from(k % 3), f64::from(k / 3 % 3), f64::from(k / 9));
            case.grain(RADIUS, (at + 0.1) * edge, DVec3::ZERO);
        }
        case.simulation()
    };
    let force = |sim: &Simulation| {
        let chunks = sim.contacts.pairs.iter();
        let forces: Vec<f64> = chunks.flat_map(|c| c.coupling().iter().map(|c| c.elastic)).collect();
        let (least, most) = forces
            .iter()
            .fold((f64::INFINITY, 0.0f64), |(a, b), f| (a.min(*f), b.max(*f)));
        assert!(
            forces.len() == 81 && most - least < 1e-9 * most,
            "{} {least} {most}",
            forces.len()
        );
        most
    };
    let mut sim = lattice(2.0005 * RADIUS);
    let steps = 4000;
    sim.deform(isotropic(Drive::StrainRate(-0.02 / (f64::from(steps) * sim.dt()))))
        .unwrap();
    let mut worst = 0.0f64;
    for step in 1..=steps {
        sim.step().unwrap();
        if step % 1000 == 0 {
            let mut rest = lattice(sim.domain().size().x / 3.0);
            rest.start().unwrap();
            worst = worst.max((force(&sim) / force(&rest) - 1.0).abs());
        }
    }
    report("largest deviation of the force", worst);
    assert!(worst < 1e-5, "{worst}");
    // the lattice follows the flow: nothing moves beyond it
    let (kinetic, speed) = sim.beyond_flow().unwrap();
    let energies = sim.energies();
    assert!(kinetic < 1e-6 * energies.kinetic, "{kinetic} {}", energies.kinetic);
    let rate = sim.box_state().unwrap().strain_rate.x;
    assert!(speed < 1e-3 * rate.abs() * RADIUS, "{speed}");
}

/// A packing that sticks is pressed, let go of all load, held under a tension that it bears, and drawn out with sides that are free.
#[test]
fn a_sticky_packing_is_let_go_and_pulled() {
    let sticky = Laws::of(law("jkr", &[("work_of_adhesion", 0.5), ("alpha", 0.3)]))
        .friction(law("mindlin-history", &[("friction", 0.5)]));
    let mut setup = gas(&sticky, 6, 0.35, 0.05, 0.1);
    setup.materials = one_material(2e6, &sticky);
    let mut sim = Simulation::new(setup);
    let hold = |target| Drive::Stress { target, max_rate: 2.0 };
    let mut residual = 0.0f64;
    sim.deform(isotropic(Drive::StrainRate(-10.0))).unwrap();
    while sim.box_state().unwrap().pressure() < 500.0 {
        residual = residual.max(run(&mut sim, 100));
    }
    for target in [0.0, -10.0] {
        sim.deform(isotropic(hold(target))).unwrap();
        residual = residual.max(run(&mut sim, 30_000));
        let found = sim.box_state().unwrap().pressure();
        report("stress that is held [Pa]", found);
        assert!((found - target).abs() < 3.0, "{found} in place of {target}");
    }
    let before = sim.box_state().unwrap().strain.z;
    sim.deform(Deformation {
        directions: [hold(0.0), hold(0.0), Drive::StrainRate(0.2)],
        ..Deformation::default()
    })
    .unwrap();
    residual = residual.max(run(&mut sim, 30_000));
    let state = sim.box_state().unwrap();
    report("stress along the pull [Pa]", state.stress[2]);
    assert!(state.strain.z > before && state.stress[2] < -10.0, "{state:?}");
    assert!(state.stress[0].abs() < 5.0 && state.stress[1].abs() < 5.0, "{state:?}");
    assert!(residual < 1e-3, "{residual}");
}
