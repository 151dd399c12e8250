//! Where the time of a run went: the parts make up the whole.

use crate::cases::beds::bed;
use crate::cases::on_threads;
use demeter::simulation::{ProfileReport, Simulation};
use std::time::Instant;

const STEPS: u64 = 400;

fn profile(name: &str, threads: usize) -> (ProfileReport, f64, u64) {
    on_threads(threads, || {
        let mut sim = Simulation::new(bed(name, 300));
        sim.start().unwrap();
        assert!(sim.profile().is_none(), "nobody asked for a profile");
        let (begun, rebuilds) = (Instant::now(), sim.rebuilds());
        sim.profile_from_now();
        for _ in 0..STEPS {
            sim.step().unwrap();
        }
        let rebuilds = sim.rebuilds() - rebuilds;
        let seconds = begun.elapsed().as_secs_f64();
        (sim.profile().unwrap(), seconds, rebuilds)
    })
}

fn seconds_of(report: &ProfileReport, name: &str) -> f64 {
    report.phases.iter().find(|p| p.name == name).unwrap().seconds
}

#[test]
fn the_phases_add_up_to_the_whole() {
    for (name, threads) in [("settling", 1), ("drum", 2), ("squeezed", 1)] {
        let (report, seconds, rebuilds) = profile(name, threads);
        assert_eq!(
            (report.steps, report.rebuilds, report.threads),
            (STEPS, rebuilds, threads)
        );
        assert_eq!(report.particle_steps, STEPS * 300, "{name}");
        assert!(
            report.seconds > 0.0 && report.seconds <= seconds,
            "{name}: {} {seconds}",
            report.seconds
        );
        assert!(
            report
                .phases
                .iter()
                .all(|p| p.seconds >= 0.0 && p.ns_per_particle_step >= 0.0),
            "{report:?}"
        );
        let sum: f64 = report.phases.iter().map(|p| p.seconds).sum();
        let shares: f64 = report.phases.iter().map(|p| p.share).sum();
        assert!(
            (sum / report.seconds - 1.0).abs() < 1e-6,
            "{name}: {sum} of {} s",
            report.seconds
        );
        assert!((shares - 1.0).abs() < 1e-6, "{name}: {shares}");
        for phase in ["walls", "sums and kick alone", "sums, kick and drift", "books"] {
            assert!(seconds_of(&report, phase) > 0.0, "{name}: {phase}");
        }
        let coupled = name == "squeezed";
        assert_eq!(seconds_of(&report, "coupled contacts") > 0.0, coupled, "{name}");
        assert_eq!(seconds_of(&report, "narrow phase") > 0.0, !coupled, "{name}");
        assert_eq!(seconds_of(&report, "laws") > 0.0, !coupled, "{name}");
    }
}

#[test]
fn the_roofline_is_that_of_the_work() {
    let (report, ..) = profile("squeezed", 1);
    let roofline = report.roofline.unwrap();
    assert!(
        roofline.contacts_per_grain > 1.0 && roofline.candidates_per_grain > 1.0,
        "{roofline:?}"
    );
    assert!(roofline.bytes > 660.0 && roofline.operations > 110.0, "{roofline:?}");
    assert!(
        roofline.machine.bandwidth > 0.0 && roofline.machine.operations > 0.0,
        "{roofline:?}"
    );
    let memory = roofline.bytes / roofline.machine.bandwidth * 1e9;
    assert!(
        (roofline.times_memory * memory / roofline.ns - 1.0).abs() < 1e-12,
        "{roofline:?}"
    );
    // what is written is outside of the steps
    assert!(
        roofline.ns > 0.0 && roofline.ns <= report.seconds * 1e9 / report.particle_steps as f64,
        "{roofline:?}"
    );
}

#[test]
fn a_profile_without_steps_has_no_roofline() {
    let mut sim = Simulation::new(bed("settling", 30));
    sim.profile_from_now();
    let report = sim.profile().unwrap();
    assert!(report.roofline.is_none() && report.particle_steps == 0, "{report:?}");
}

#[test]
fn the_memory_that_is_told_holds_the_tables_and_little_more() {
    let mut sim = Simulation::new(bed("shear", 300));
    for _ in 0..STEPS {
        sim.step().unwrap();
    }
    let memory = sim.memory();
    let bytes = |name: &str| memory.iter().find(|part| part.name == name).unwrap().bytes;
    // three rows of 32 bytes, load and half kick of 96, mass, image, id and material
    assert!(bytes("grains") >= sim.grains().len() * (6 * 32 + 8 + 12 + 4 + 2));
    let of_contacts = |chunks: &[demeter::contacts::ContactChunk]| chunks.iter().map(|c| c.len()).sum::<usize>();
    let contacts = of_contacts(&sim.contacts.pairs) + of_contacts(&sim.contacts.walls);
    let history = contacts * sim.contacts.stride * 8;
    assert!(contacts > 20 && history > 0, "{contacts} contacts, {history} bytes");
    // in small tables some places are set aside beside those in use, and contacts with walls are kept twice
    assert!(bytes("contacts: history") >= history && bytes("contacts: history") < 4 * history);
    for part in &memory {
        assert_eq!(
            part.bytes_per_grain,
            part.bytes as f64 / sim.grains().len() as f64,
            "{}",
            part.name
        );
    }
}
