//! What the model does not cover stops the run and names the grain; nothing goes on with numbers that are not numbers.

use crate::cases::beds::{bed_with, fill};
use crate::cases::{Case, Laws, on_threads, one_material};
use demeter::contacts::{Departure, Fault};
use demeter::particles::{Domain, Outside};
use demeter::simulation::Simulation;
use demeter::walls::{Motion, Shape};
use demeter_physics::DVec3;
use demeter_physics::integrator::Integrator;

/// Steps until the first fault; panics when none comes.
fn first_fault(sim: &mut Simulation, most: u64, case: &str) -> Fault {
    for _ in 0..most {
        if let Err(fault) = sim.step() {
            return fault;
        }
    }
    panic!("{case}: no fault in {most} steps: {:?}", sim.energies());
}

#[test]
fn a_grain_shot_out_of_an_open_box_is_named() {
    let mut case = Case::new(one_material(1e8, &Laws::hertz(0.9)));
    case.grain(1e-3, DVec3::new(0.1, 0.1, 0.1), DVec3::ZERO);
    case.grain(1e-3, DVec3::new(0.2, 0.2, 0.2), DVec3::new(0.0, 0.0, 50.0));
    let shape = Shape::Box {
        lower: DVec3::ZERO,
        upper: DVec3::splat(0.5),
        open: [false, false, false, false, false, true],
    };
    case.wall(0, shape, Motion::Rest);
    let mut sim = case.simulation();
    let expected_step = (0.8 / 50.0 / sim.dt()) as u64 + 1;
    match first_fault(&mut sim, 10_000_000, "open box") {
        Fault::Outside { departure, .. } => {
            let Departure { step, id, position, .. } = departure;
            assert_eq!(id, 2);
            assert!(
                step.abs_diff(expected_step) <= 1 && step == sim.step,
                "{step}, {expected_step}"
            );
            assert!((position - DVec3::new(0.2, 0.2, 1.0)).length() < 1e-4, "{position}");
        }
        other => panic!("{other}"),
    }
}

#[test]
fn a_grain_that_would_jump_over_another_ends_the_run() {
    let flying = |share: f64| {
        let mut case = Case::new(one_material(1e8, &Laws::hertz(0.9)));
        case.grain(1e-3, DVec3::ZERO, DVec3::ZERO);
        // fast enough to be before the other in one step and behind it in the next
        case.grain(1e-3, DVec3::X * -0.01, DVec3::ZERO);
        let mut setup = case.setup();
        setup.grains.velocity[1] = DVec3::X * (share * 1e-3 / setup.dt);
        Simulation::new(setup)
    };
    match first_fault(&mut flying(5.0), 10, "jump") {
        Fault::Jump { id, way, radius, .. } => {
            assert_eq!(id, 2);
            assert!((way / radius - 5.0).abs() < 1e-9, "{way}");
        }
        other => panic!("{other}"),
    }
    // a speed whose square is no number any more
    let fault = first_fault(&mut flying(1e158), 10, "far too fast");
    assert!(matches!(fault, Fault::Jump { id: 2, .. }), "{fault}");
    // one that is slower overlaps with it on the way, which ends the run as well
    let fault = first_fault(&mut flying(0.9), 100, "no jump");
    assert!(matches!(fault, Fault::Overlap { .. }), "{fault}");
}

/// It was removed as one that left the domain, through a closed floor.
#[test]
fn a_grain_that_jumps_out_of_the_domain_ends_the_run() {
    let mut case = Case::new(one_material(1e8, &Laws::hertz(0.9)));
    case.domain = Domain {
        lower: DVec3::splat(-5e-3),
        upper: DVec3::splat(5e-3),
        periodic: [false; 3],
        outside: Outside::Remove,
    };
    let floor = Shape::Plane {
        point: DVec3::ZERO,
        normal: DVec3::Z,
    };
    case.wall(0, floor, Motion::Rest);
    case.grain(1e-3, DVec3::Z * 2e-3, DVec3::ZERO);
    let mut setup = case.setup();
    setup.gravity = DVec3::Z * (-0.02 / (setup.dt * setup.dt));
    let fault = first_fault(&mut Simulation::new(setup), 10, "through the floor");
    assert!(matches!(fault, Fault::Jump { step: 1, id: 1, .. }), "{fault}");
}

#[test]
fn a_fault_tells_its_cause_and_a_remedy() {
    let mut case = Case::new(one_material(1e8, &Laws::hertz(0.9)));
    case.grain(1e-3, DVec3::new(0.0, 0.0, 0.99), DVec3::new(0.0, 0.0, 50.0));
    let text = first_fault(&mut case.simulation(), 1_000_000, "").to_string();
    for part in ["step ", "grain 1", "Cause:", "Remedy:", "outside = \"remove\""] {
        assert!(text.contains(part), "`{part}` is missing: {text}");
    }
    // softer or slower grains would not help one that comes beside a box
    let mut case = Case::new(one_material(1e8, &Laws::hertz(0.9)));
    let shape = Shape::Box {
        lower: DVec3::ZERO,
        upper: DVec3::splat(0.5),
        open: [false, false, false, false, false, true],
    };
    case.wall(0, shape, Motion::Rest);
    case.grain(1e-3, DVec3::new(0.6, 0.2, 0.502), DVec3::Z * -1.0);
    let text = first_fault(&mut case.simulation(), 1_000_000, "beside").to_string();
    for part in ["centre is behind the wall", "take rectangles"] {
        assert!(text.contains(part), "`{part}` is missing: {text}");
    }
}

#[test]
fn what_leaves_an_open_domain_is_removed_and_booked() {
    let mut case = Case::new(one_material(1e8, &Laws::hertz(0.9)));
    case.domain.outside = Outside::Remove;
    case.gravity = DVec3::new(0.0, 0.0, -9.0);
    let v = DVec3::new(0.0, 50.0, 0.0);
    case.spinning_grain(1e-3, DVec3::new(0.0, 0.99, 0.5), v, DVec3::X * 100.0);
    case.grain(1e-3, DVec3::ZERO, DVec3::ZERO);
    let (m, i) = (case.grains.mass(0), case.grains.inertia(0));
    let mut sim = case.simulation();
    for _ in 0..1_000 {
        sim.step().unwrap();
    }
    assert_eq!(sim.grains().id, [2]);
    assert_eq!(sim.books.removed_grains, 1);
    let e = sim.energies();
    let carried = 0.5 * m * 2500.0 + 0.5 * i * 1e4 + m * 9.0 * 0.5;
    assert!((e.removed / carried - 1.0).abs() < 1e-6, "{} {carried}", e.removed);
    assert!(e.residual.abs() < 1e-9, "{}", e.residual);
}

/// Far above the safe time step, contacts or places break; the run must say so, soon.
#[test]
fn an_absurd_time_step_is_a_fault() {
    for integrator in [Integrator::VelocityVerlet, Integrator::Gear] {
        an_absurd_time_step_faults(integrator);
    }
}

fn an_absurd_time_step_faults(integrator: Integrator) {
    for name in ["settling", "drum", "servo", "shear", "moving walls", "squeezing"] {
        for factor in [1e3, 1e4, 1e5, 1e10, 1e100, 1e300] {
            let fault = on_threads(1, || {
                let mut setup = bed_with(integrator, name, 60);
                setup.dt *= factor;
                first_fault(&mut Simulation::new(setup), 20_000, &format!("{name} {factor}"))
            });
            assert!((1..=60).contains(&fault.grain()), "{name}, {factor}: {fault}");
        }
    }
}

/// A gas in a fully periodic box cannot leave it, but an absurd step throws a grain farther than a box.
#[test]
fn an_absurd_time_step_in_a_periodic_box_is_a_fault() {
    for factor in [1e6, 1e20, 1e200, 1e306] {
        let mut case = Case::new(one_material(1e8, &Laws::hertz(0.9)));
        case.domain.lower = DVec3::ZERO;
        case.domain.upper = DVec3::splat(0.03);
        case.domain.periodic = [true; 3];
        let upper = case.domain.upper;
        fill(&mut case, DVec3::ZERO, upper, 50, 0.5);
        let mut setup = case.setup();
        setup.dt *= factor;
        let fault = on_threads(1, || {
            first_fault(&mut Simulation::new(setup), 1_000, &format!("{factor}"))
        });
        assert!((1..=50).contains(&fault.grain()), "{factor}: {fault}");
    }
}

/// A value that is not a number is caught at the first step, in every kind of box, even when the grain touches nothing.
#[test]
fn not_a_number_is_caught_at_once() {
    type Spoil = fn(&mut demeter::particles::Grains, f64);
    let spoils: [(&str, Spoil); 3] = [
        ("position", |g, x| g.position[1].y = x),
        ("velocity", |g, x| g.velocity[1].y = x),
        ("angular velocity", |g, x| g.angular_velocity[1].y = x),
    ];
    for (what, spoil) in spoils {
        for value in [f64::NAN, f64::INFINITY] {
            for periodic in [[false; 3], [true, true, false], [true; 3]] {
                let mut case = Case::new(one_material(1e8, &Laws::hertz(0.9)));
                case.domain.periodic = periodic;
                for k in 0..3 {
                    case.grain(1e-3, DVec3::X * (0.1 * f64::from(k)), DVec3::ZERO);
                }
                let mut setup = case.setup();
                spoil(&mut setup.grains, value);
                let mut sim = Simulation::new(setup);
                let result = sim.start().and_then(|()| sim.step());
                match result {
                    Err(Fault::NotFinite { id: 2, step, .. }) => assert!(step <= 1),
                    other => panic!("{what} {value}, periodic {periodic:?}: {other:?}"),
                }
            }
        }
    }
}
