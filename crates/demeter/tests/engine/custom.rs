//! Custom forces, custom motions of walls, changes from outside, and runs in the hands of a caller.

use demeter::contacts::Fault;
use demeter::materials::{Material, Materials, PairChoice};
use demeter::measure::{Moment, StrainGauge, measure};
use demeter::scenario::{LiveRun, Observer, Pause, Progress, RunEnd, RunOptions, Scenario, Until};
use demeter::simulation::{CustomForce, CustomMotion, ForceMoment, GrainLoads, Simulation};
use demeter::walls::Motion;
use demeter_physics::contact::LawChoice;
use demeter_physics::parameters::Values;
use glam::DVec3;
use std::f64::consts::TAU;
use std::path::Path;

/// Grains that settle in a box with a plate above them.
const BED: &str = r#"
[simulation]
gravity = "0 0 -9.81 m/s^2"
max_overlap = 0.2

[material.glass]
young_modulus = "1 MPa"
poisson_ratio = 0.25
density = "2500 kg/m^3"

[contact]
normal = { law = "hertz-tsuji", restitution = 0.7 }
tangential = { law = "mindlin-history", friction = 0.4 }

[[grains]]
material = "glass"
source = "random"
count = 60
diameter = "4 mm"
region = { shape = "box", lower = "0 0 0 mm", upper = "20 20 60 mm" }

[[wall]]
name = "box"
shape = "box"
lower = ["0 mm", "0 mm", "0 mm"]
upper = ["20 mm", "20 mm", "80 mm"]
material = "glass"

[[wall]]
name = "plate"
shape = "plane"
point = ["0 mm", "0 mm", "70 mm"]
normal = "-z"
material = "glass"

[[stage]]
name = "settle"
duration = "20 ms"

[[stage]]
name = "press"
duration = "20 ms"
motion = { plate = { velocity = ["0 m/s", "0 m/s", "-0.4 m/s"] } }

[output]
series = "5 ms"
"#;

struct Silent;

impl Observer for Silent {
    fn progress(&mut self, _progress: &Progress) -> bool {
        true
    }

    fn message(&mut self, _text: &str) {}
}

fn live_with(overrides: &[&str], threads: usize, folder: Option<&Path>) -> LiveRun {
    let overrides: Vec<String> = overrides.iter().map(|o| (*o).to_string()).collect();
    let scenario = match Scenario::parse(BED, "bed", Path::new(""), &overrides) {
        Ok(scenario) => scenario,
        Err(faults) => panic!("{}", faults.render(false)),
    };
    let options = RunOptions {
        threads: Some(threads),
        ..RunOptions::default()
    };
    LiveRun::new(scenario, folder, options, &mut Silent).unwrap_or_else(|e| panic!("{e:?}"))
}

fn live(threads: usize) -> LiveRun {
    live_with(&[], threads, None)
}

fn steps(run: &mut LiveRun, count: u64) -> Pause {
    let step = Some(run.with_simulation(|sim| sim.step) + count);
    let until = Until {
        step,
        beyond: true,
        ..Until::default()
    };
    run.advance(&until, &mut Silent).unwrap()
}

fn state(run: &LiveRun) -> (u64, Vec<u32>, Vec<DVec3>, Vec<DVec3>) {
    run.with_simulation(|sim| {
        let grains = sim.grains();
        let vectors = |rows: &demeter::particles::Rows| rows.iter().copied().collect();
        (
            sim.step,
            grains.id.clone(),
            vectors(&grains.position),
            vectors(&grains.velocity),
        )
    })
}

fn residual(run: &mut LiveRun) -> f64 {
    run.change(|sim: &mut Simulation| sim.energies()).residual.abs()
}

/// Holds every grain with a spring to the axis of the box, and drags and turns it.
struct Trap;

impl CustomForce for Trap {
    fn loads(&mut self, moment: &ForceMoment, loads: &mut GrainLoads) -> Result<(), String> {
        let grains = moment.grains;
        for g in 0..grains.len() {
            let away = grains.position[g] - DVec3::new(0.01, 0.01, grains.position[g].z);
            loads.force[g] = -2.0 * away - 1e-3 * grains.velocity[g];
            loads.torque[g] = DVec3::Z * (1e-7 * (moment.time * 500.0).cos());
        }
        Ok(())
    }
}

/// Refuses once, at a step.
struct FailsAt(u64);

impl CustomForce for FailsAt {
    fn loads(&mut self, moment: &ForceMoment, loads: &mut GrainLoads) -> Result<(), String> {
        loads.force.fill(DVec3::new(0.0, 0.0, 1e-4));
        if moment.step == self.0 {
            return Err("no answer today".to_string());
        }
        Ok(())
    }
}

#[test]
fn pauses_change_no_bit() {
    let mut whole = live(1);
    let end = whole.advance(&Until::default(), &mut Silent).unwrap();
    assert_eq!(end, Pause::End(RunEnd::Finished));
    let mut pieces = live(2);
    let pause = pieces.advance(
        &Until {
            stage: true,
            ..Until::default()
        },
        &mut Silent,
    );
    assert_eq!(pause.unwrap(), Pause::Stage);
    assert_eq!(pieces.stage(), Some(1));
    while pieces.stage().is_some() {
        steps(&mut pieces, 7);
    }
    let last = state(&whole).0;
    let beyond = state(&pieces).0 - last;
    steps(&mut whole, beyond);
    assert_eq!(state(&whole), state(&pieces));
    let rows = |run: &LiveRun| run.with_series(|series| format!("{:?}", series.columns())).unwrap();
    assert_eq!(rows(&whole), rows(&pieces));
}

#[test]
fn looks_leave_no_trace_in_rows() {
    let measures = r#"measure = [
        { name = "gate", kind = "mass-flow", gate = { shape = "plane", point = "0 0 20 mm", normal = "-z" } },
        { name = "stay", kind = "residence", region = { shape = "box", lower = "0 0 0 mm", upper = "20 20 20 mm" } },
        { name = "hits", kind = "collisions", material = "glass" },
    ]"#
    .replace('\n', "");
    let rows = |looks: bool| {
        let mut run = live_with(&[&measures], 1, None);
        while run.stage().is_some() {
            steps(&mut run, 7);
            if looks {
                run.present();
                assert!(run.energies().residual.is_finite());
            }
        }
        run.with_series(|series| format!("{:?}", series.columns())).unwrap()
    };
    assert_eq!(rows(true), rows(false));
}

#[test]
fn the_work_of_a_custom_force_closes_the_ledger_on_any_threads() {
    let runs = [1, 2].map(|threads| {
        // the trap squeezes grains by up to a fifth
        let mut run = live_with(&["simulation.max_overlap=0.3"], threads, None);
        run.change(|sim| sim.add_force(Box::new(Trap)));
        assert_eq!(steps(&mut run, 6000), Pause::Step);
        run.change(Simulation::clear_forces);
        assert_eq!(steps(&mut run, 500), Pause::Step);
        assert!(residual(&mut run) < 2e-4, "{}", residual(&mut run));
        let work = run.change(|sim| sim.energies()).custom_work;
        assert!(work.abs() > 1e-6, "{work}");
        run
    });
    assert_eq!(state(&runs[0]), state(&runs[1]));
}

#[test]
fn a_grain_in_a_harmonic_trap_swings_as_it_must() {
    let mut run = live_with(&["grains[0].count=1", "simulation.gravity=\"0 0 0 m/s^2\""], 1, None);
    let start = DVec3::new(0.013, 0.01, 0.03);
    run.change(|sim| sim.set_positions(&[start])).unwrap();
    struct Spring;
    impl CustomForce for Spring {
        fn loads(&mut self, moment: &ForceMoment, loads: &mut GrainLoads) -> Result<(), String> {
            loads.force[0] = -5.0 * (moment.grains.position[0] - DVec3::new(0.01, 0.01, 0.03));
            Ok(())
        }
    }
    run.change(|sim| sim.add_force(Box::new(Spring)));
    let (mass, dt) = run.with_simulation(|sim| (sim.grains().mass(0), sim.dt()));
    let frequency = (5.0f64 / mass).sqrt();
    for _ in 0..20 {
        steps(&mut run, 100);
        let (x, t) = run.with_simulation(|sim| (sim.grains().position[0].x, sim.time()));
        let exact = 0.01 + 0.003 * (frequency * t).cos();
        assert!((x - exact).abs() < 1e-2 * (frequency * dt) * 0.003, "{x} {exact}");
    }
    // the trapezium of the power misses the energy by the square of the step
    assert!(residual(&mut run) < (frequency * dt).powi(2), "{}", residual(&mut run));
}

#[test]
fn a_force_that_fails_leaves_a_whole_step() {
    let mut failing = live(1);
    failing.change(|sim| sim.add_force(Box::new(FailsAt(300))));
    let pause = steps(&mut failing, 1000);
    let Pause::End(RunEnd::Fault(Fault::Custom { step: 300, reason, .. })) = pause else {
        panic!("{pause:?}");
    };
    assert!(reason.contains("no answer today"));
    assert!(failing.end().is_none());
    steps(&mut failing, 700);
    // the loads of the step before were the same: nothing shows
    let mut sound = live(1);
    sound.change(|sim| sim.add_force(Box::new(FailsAt(u64::MAX))));
    steps(&mut sound, 1000);
    assert_eq!(state(&failing), state(&sound));
    struct Wrong;
    impl CustomForce for Wrong {
        fn loads(&mut self, _: &ForceMoment, loads: &mut GrainLoads) -> Result<(), String> {
            loads.force[3].x = f64::NAN;
            Ok(())
        }
    }
    sound.change(|sim| sim.add_force(Box::new(Wrong)));
    let text = format!("{:?}", steps(&mut sound, 1));
    assert!(text.contains("not finite"), "{text}");
}

/// A run whose first stage lasts, so that no other takes the plate back.
fn still() -> LiveRun {
    live_with(&["stage[0].duration=\"1 s\""], 1, None)
}

/// The plate, moved by a function after a while.
fn moved(motion: CustomMotion) -> LiveRun {
    let mut run = still();
    steps(&mut run, 1000);
    run.change(|sim| sim.drive_wall(1, motion)).unwrap();
    steps(&mut run, 4000);
    run
}

#[test]
fn a_wall_follows_a_function_as_it_follows_a_motion() {
    let told = |motion: Motion| {
        let mut run = still();
        steps(&mut run, 1000);
        run.change(|sim| sim.set_wall_motion(1, motion.into())).unwrap();
        steps(&mut run, 4000);
        run
    };
    let velocity = DVec3::new(0.0, 0.0, -0.5);
    let t0 = live(1).with_simulation(|sim| 1000.0 * sim.dt());
    let mut by_motion = told(Motion::Velocity(velocity));
    let mut by_velocity = moved(CustomMotion::Velocity(Box::new(move |_| Ok(velocity))));
    let mut by_place = moved(CustomMotion::Place(Box::new(move |t| Ok(velocity * (3.0 + t)))));
    let plate = |run: &LiveRun| run.with_simulation(|sim| sim.walls[1].displacement().z);
    for run in [&by_velocity, &by_place] {
        assert!((plate(run) - plate(&by_motion)).abs() < 1e-12);
    }
    for run in [&mut by_motion, &mut by_velocity, &mut by_place] {
        assert!(residual(run) < 1e-3, "{}", residual(run));
    }
    let swing = told(Motion::Oscillation {
        amplitude: DVec3::Z * 0.02,
        frequency: 20.0,
        phase: 0.0,
    });
    let mut by_place = moved(CustomMotion::Place(Box::new(move |t| {
        Ok(DVec3::Z * (0.02 * (TAU * 20.0 * (t - t0)).sin()))
    })));
    assert!((plate(&by_place) - plate(&swing)).abs() < 1e-12);
    let speed = |run: &LiveRun| run.with_simulation(|sim| sim.walls[1].velocity_at(DVec3::ZERO).z);
    assert!((speed(&by_place) - speed(&swing)).abs() < 1e-4 * 0.02 * TAU * 20.0);
    assert!(residual(&mut by_place) < 1e-3);
}

#[test]
fn a_wall_turns_by_a_function() {
    let (point, axis) = (DVec3::new(0.01, 0.01, 0.0), DVec3::Z);
    let turned = moved(CustomMotion::AngularVelocity {
        point,
        axis,
        rate: Box::new(|_| Ok(3.0)),
    });
    let by_angle = moved(CustomMotion::Angle {
        point,
        axis,
        angle: Box::new(|t| Ok(1.0 + 3.0 * t)),
    });
    let pose = |run: &LiveRun| run.with_simulation(|sim| (sim.walls[1].pose(), sim.walls[1].angular_velocity().z));
    let ((first, rate), (second, other)) = (pose(&turned), pose(&by_angle));
    assert!(first.rotation.angle_between(second.rotation) < 1e-7);
    assert!(
        (rate - 3.0).abs() < 1e-12 && (other - 3.0).abs() < 1e-6,
        "{rate} {other}"
    );
}

#[test]
fn a_stage_that_tells_a_motion_takes_the_wall_back() {
    let mut run = live(1);
    run.change(|sim| sim.drive_wall(1, CustomMotion::Velocity(Box::new(|_| Ok(DVec3::X)))))
        .unwrap();
    run.advance(&Until::default(), &mut Silent).unwrap();
    let velocity = run.with_simulation(|sim| sim.walls[1].velocity_at(DVec3::ZERO));
    assert_eq!(velocity, DVec3::new(0.0, 0.0, -0.4));
}

#[test]
fn a_motion_without_an_answer_is_refused_and_one_that_loses_it_rests() {
    let mut run = live(1);
    let refused = run.change(|sim| sim.drive_wall(1, CustomMotion::Velocity(Box::new(|_| Err("none".to_string())))));
    assert!(refused.unwrap_err().to_string().contains("`plate`: none"));
    let fails = move |t: f64| {
        if t > 0.01 {
            Err("out of paper".to_string())
        } else {
            Ok(DVec3::X)
        }
    };
    run.change(|sim| sim.drive_wall(1, CustomMotion::Velocity(Box::new(fails))))
        .unwrap();
    let text = format!("{:?}", steps(&mut run, 100_000));
    assert!(text.contains("out of paper"), "{text}");
    let velocity = run.with_simulation(|sim| sim.walls[1].velocity_at(DVec3::ZERO));
    assert_eq!(velocity, DVec3::ZERO);
}

#[test]
fn changes_from_outside_are_booked() {
    let mut run = live(1);
    steps(&mut run, 5000);
    for round in 0..50 {
        steps(&mut run, 20);
        let turned: Vec<DVec3> = state(&run).3.iter().map(|v| DVec3::new(v.y, v.x, 0.9 * v.z)).collect();
        run.change(|sim| sim.set_velocities(&turned)).unwrap();
        let spins = run.with_simulation(|sim| {
            sim.grains()
                .angular_velocity
                .iter()
                .map(|w| *w * 0.5)
                .collect::<Vec<_>>()
        });
        run.change(|sim| sim.set_angular_velocities(&spins)).unwrap();
        if round % 10 == 0 {
            let moved: Vec<DVec3> = state(&run).2.iter().map(|p| *p + DVec3::Z * 1e-5).collect();
            run.change(|sim| sim.set_positions(&moved)).unwrap();
        }
    }
    assert!(residual(&mut run) < 2e-3, "{}", residual(&mut run));
    let all: Vec<DVec3> = state(&run).2;
    let error = run.change(|sim| sim.set_positions(&all[1..])).unwrap_err();
    assert!(error.to_string().contains("59 vectors for 60 grains"), "{error}");
    let mut one = all.clone();
    one[0] = one[1];
    let error = run.change(|sim| sim.set_positions(&one)).unwrap_err();
    assert!(error.to_string().contains("overlaps"), "{error}");
}

#[test]
fn what_a_program_tells_wrongly_is_refused() {
    let mut run = live(1);
    let motion = || CustomMotion::Velocity(Box::new(|_| Ok(DVec3::X)));
    let absent = run.change(|sim| sim.drive_wall(9, motion())).unwrap_err().to_string();
    assert!(absent.contains("there is no wall 9: 2 walls"), "{absent}");
    let absent = run
        .change(|sim| sim.set_wall_motion(2, Motion::Rest.into()))
        .unwrap_err();
    assert!(absent.to_string().contains("there is no wall 2"), "{absent}");
    for dt in [0.0, -1e-6, f64::NAN, f64::INFINITY] {
        let refused = run.change(|sim| sim.set_dt(dt)).unwrap_err().to_string();
        assert!(refused.contains("must be finite and above 0"), "{refused}");
    }
    let list = run.with_simulation(|sim| sim.materials.list().to_vec());
    let bound = |change: &dyn Fn(&mut Material)| {
        let mut list = list.clone();
        change(&mut list[0]);
        // refused before any law is asked
        let normal = LawChoice {
            law: "none".to_string(),
            parameters: Values::default(),
        };
        let laws = PairChoice {
            normal,
            tangential: None,
            rolling: None,
            multi_contact: None,
        };
        Materials::new(list, |_, _| laws.clone()).map(drop)
    };
    type Change = fn(&mut Material);
    let wrong: [(Change, &str); 5] = [
        (|m| m.young_modulus = f64::NAN, "`young_modulus` is NaN"),
        (|m| m.young_modulus = 0.0, "`young_modulus` is 0"),
        (|m| m.poisson_ratio = 2.0, "`poisson_ratio` is 2"),
        (|m| m.poisson_ratio = -1.0, "`poisson_ratio` is -1"),
        (|m| m.density = -1.0, "`density` is -1"),
    ];
    for (change, what) in wrong {
        let refused = bound(&change).unwrap_err().to_string();
        assert!(
            refused.contains("material `glass`") && refused.contains(what),
            "{refused}"
        );
    }
}

#[test]
fn a_run_of_a_wrong_scenario_tells_what_is_wrong() {
    let overrides = ["simulation.time_step=\"1 s\"".to_string()];
    let scenario = Scenario::parse(BED, "bed", Path::new(""), &overrides).unwrap();
    let error = LiveRun::new(scenario, None, RunOptions::default(), &mut Silent).unwrap_err();
    let told = error.to_string();
    assert!(
        told.contains("the time step is unsafe") && told.contains("use \"auto\""),
        "{told}"
    );
}

#[test]
fn no_threads_are_refused() {
    let scenario = Scenario::parse(BED, "bed", Path::new(""), &[]).unwrap();
    let options = RunOptions {
        threads: Some(0),
        ..RunOptions::default()
    };
    let error = LiveRun::new(scenario, None, options, &mut Silent).unwrap_err();
    assert!(error.to_string().contains("a run needs at least 1"), "{error}");
}

#[test]
fn a_gauge_of_a_wall_that_is_not_there_tells_no_strain() {
    let mut run = live(1);
    let mut strain = |wall| {
        let gauge = StrainGauge {
            wall,
            direction: DVec3::Z,
            from: 0.0,
            length: 1.0,
        };
        run.change(|sim| measure(sim, Moment::default(), Some(&gauge)).strain)
    };
    assert_eq!((strain(1), strain(2)), (Some(0.0), None));
}

#[test]
fn the_summary_tells_a_time_step_that_a_program_set() {
    let mut run = live_with(&["stage=[{name=\"short\",steps=60}]"], 1, None);
    steps(&mut run, 20);
    let dt = run.with_simulation(Simulation::dt);
    run.change(|sim| sim.set_dt(0.5 * dt)).unwrap();
    run.advance(&Until::default(), &mut Silent).unwrap();
    let (_, summary) = run.end().unwrap();
    assert_eq!(summary.time_step, 0.5 * dt);
    let told = &summary.time_step_reason;
    assert!(
        told.starts_with("set in the run") && told.ends_with("from step 20 on"),
        "{told}"
    );
}

#[test]
fn grains_that_are_put_beyond_a_periodic_side_have_crossed_it() {
    let periodic = [
        r#"domain={lower="0 0 0 mm",upper="20 20 80 mm",periodic=["x","y"]}"#,
        r#"measure=[{name="way",kind="displacement"}]"#,
        r#"wall=[{name="floor",shape="plane",point="0 0 0 mm",normal="+z",material="glass"},{name="plate",shape="plane",point="0 0 79 mm",normal="-z",material="glass"}]"#,
    ];
    let mut run = live_with(&periodic, 1, None);
    steps(&mut run, 100);
    let unwrapped = |run: &LiveRun| -> Vec<DVec3> {
        let size = DVec3::new(0.02, 0.02, 0.08);
        run.with_simulation(|sim| {
            let grains = sim.grains();
            let turns = |g: usize| DVec3::from_array(grains.crossings(g).map(f64::from));
            let mut all: Vec<_> = (0..grains.len())
                .map(|g| (grains.id[g], grains.position[g] + turns(g) * size))
                .collect();
            all.sort_by_key(|(id, _)| *id);
            all.into_iter().map(|(_, place)| place).collect()
        })
    };
    // beyond both sides, and round the box three times
    for shift in [DVec3::new(0.007, -0.009, 0.0), DVec3::new(0.0, 0.061, 0.0)] {
        let before = unwrapped(&run);
        let moved: Vec<DVec3> = state(&run).2.iter().map(|p| *p + shift).collect();
        run.change(|sim| sim.set_positions(&moved)).unwrap();
        for (now, before) in unwrapped(&run).iter().zip(before) {
            assert!((*now - before - shift).length() < 1e-12, "{now} {before}");
        }
    }
    let far: Vec<DVec3> = state(&run).2.iter().map(|p| *p + DVec3::X * 1e6).collect();
    let error = run.change(|sim| sim.set_positions(&far)).unwrap_err();
    assert!(error.to_string().contains("went round the periodic box"), "{error}");
}

#[test]
fn a_run_goes_on_from_a_checkpoint_with_its_custom_force_to_the_same_bits() {
    let place = tempfile::tempdir().unwrap();
    let folder = place.path().join("run");
    let mut run = live(1);
    run.change(|sim| sim.add_force(Box::new(Trap)));
    steps(&mut run, 777);
    assert!(run.checkpoint(None, false).unwrap_err().to_string().contains("folder"));
    run.checkpoint(Some(&folder), false).unwrap();
    let there = run.checkpoint(Some(&folder), false).unwrap_err().to_string();
    assert!(there.contains("overwrite"), "{there}");
    run.checkpoint(Some(&folder), true).unwrap();
    steps(&mut run, 500);
    #[derive(Default)]
    struct Messages(Vec<String>);
    impl Observer for Messages {
        fn progress(&mut self, _progress: &Progress) -> bool {
            true
        }
        fn message(&mut self, text: &str) {
            self.0.push(text.to_string());
        }
    }
    let mut told = Messages::default();
    let mut resumed = LiveRun::resume(&folder, RunOptions::default(), &mut told).unwrap();
    assert!(told.0.iter().any(|text| text.contains("custom force")), "{:?}", told.0);
    resumed.change(|sim| sim.add_force(Box::new(Trap)));
    steps(&mut resumed, 500);
    assert_eq!(state(&run), state(&resumed));
    let energies = [&mut run, &mut resumed].map(|run| run.change(|sim| sim.energies()));
    assert_eq!(energies[0], energies[1]);
}

#[test]
fn a_run_with_a_folder_writes_as_one_from_the_command_line() {
    let place = tempfile::tempdir().unwrap();
    let (one, other) = (place.path().join("one"), place.path().join("other"));
    let scenario = Scenario::parse(BED, "bed", Path::new(""), &[]).unwrap();
    demeter::scenario::run(&scenario, &one, RunOptions::default(), &mut Silent).unwrap();
    let mut run = live_with(&[], 2, Some(&other));
    while run.stage().is_some() {
        steps(&mut run, 501);
    }
    assert_eq!(run.end().unwrap().0, RunEnd::Finished);
    let read = |folder: &Path, name: &str| std::fs::read_to_string(folder.join(name)).unwrap();
    for name in ["series.csv", "scenario.toml", "grains.pvd"] {
        assert_eq!(read(&one, name), read(&other, name), "{name}");
    }
    assert!(read(&other, "summary.json").contains("all stages are done"));
}
