//! A run gives the same bits on any number of processes that share it.

use crate::cases::beds::{BEDS, bed_with};
use crate::cases::ranks::on_ranks;
use crate::cases::{full, on_threads};
use demeter::comm::Ranks;
use demeter::contacts::Fault;
use demeter::measure::{Moment, contact_records, measure};
use demeter::simulation::{ChangeError, Deformation, Drive, Setup, Sharing, Simulation, Skin};
use demeter::walls::Wall;
use demeter_physics::integrator::Integrator;

/// What a run comes to.
#[derive(Debug, PartialEq)]
struct Outcome {
    state: Vec<u8>,
    series: String,
    contacts: String,
    /// What a checkpoint holds.
    saved: String,
    /// The same as the first process writes it, which hears it piece by piece; nothing at others.
    written: Option<Vec<u8>>,
}

fn written(sim: &Simulation) -> Option<Vec<u8>> {
    let written = postcard::to_stdvec(&sim.state()).unwrap();
    sim.is_first_process().then_some(written)
}

fn run(setup: Setup, steps: u64, ranks: Option<Box<dyn Ranks>>) -> Result<(Outcome, Option<Sharing>), Fault> {
    let skin = Skin::Tuned(setup.skin.first());
    let mut sim = Simulation::new(Setup { skin, ..setup });
    if let Some(ranks) = ranks {
        sim.share(ranks);
    }
    let mut series = String::new();
    for step in 0..steps {
        sim.step()?;
        if step % 10 == 0 {
            series += &format!("{:?}\n", measure(&mut sim, Moment::default(), None));
            series += &format!("{:?}\n", sim.box_state());
            written(&sim);
        }
        if step == steps / 2 {
            put_elsewhere(&mut sim);
        }
        // as a later stage does, when no process knows all grains
        if step == steps / 3 && sim.deforms() {
            let faster = Drive::StrainRate(-2.0);
            let directions = [faster, Drive::Fixed, Drive::Fixed];
            sim.deform(Deformation {
                directions,
                ..Deformation::default()
            })
            .unwrap();
        }
    }
    let written = written(&sim);
    sim.make_whole();
    let walls: Vec<_> = sim.walls.iter().map(Wall::state).collect();
    let outcome = Outcome {
        state: postcard::to_stdvec(&(sim.grains(), &walls, sim.skin(), sim.rebuilds())).unwrap(),
        contacts: format!("{:?}", contact_records(&sim)),
        saved: format!("{:?}", sim.state()),
        series,
        written,
    };
    Ok((outcome, sim.sharing().filter(|_| sim.shares_nothing().is_none())))
}

/// Puts all grains where they are: candidates are found anew by every process for all, and divided then without a search.
fn put_elsewhere(sim: &mut Simulation) {
    sim.make_whole();
    let places: Vec<_> = sim.grains().position.iter().copied().collect();
    match sim.set_positions(&places) {
        Ok(()) | Err(ChangeError::Deforms) => {}
        Err(error) => panic!("{error}"),
    }
}

fn compare(integrator: Integrator, all_ranks: &[usize]) {
    let (count, steps) = if full() { (5000, 3_000) } else { (2000, 60) };
    for name in BEDS {
        let alone = on_threads(1, || run(bed_with(integrator, name, count), steps, None).unwrap().0);
        for &ranks in all_ranks {
            let shared = on_ranks(ranks, |rank| {
                on_threads(1, || run(bed_with(integrator, name, count), steps, Some(rank)).unwrap())
            });
            for (rank, (outcome, sharing)) in shared.into_iter().enumerate() {
                let what = format!("{name}: rank {rank} of {ranks}");
                assert!(
                    sharing.is_none_or(|sharing| sharing.divided > 0),
                    "{what} shared nothing"
                );
                assert!(outcome.series == alone.series, "{what}: the series differs");
                assert!(outcome.contacts == alone.contacts, "{what}: the contacts differ");
                assert!(outcome.state == alone.state, "{what}: the state differs");
                assert_same(&what, &outcome.saved, &alone.saved);
                if rank == 0 {
                    assert!(outcome.written == alone.written, "{what}: what is written differs");
                }
            }
        }
    }
}

#[test]
fn ranks_do_not_change_a_bit() {
    compare(Integrator::VelocityVerlet, &[2, 3]);
}

#[test]
fn ranks_do_not_change_a_bit_with_gear() {
    compare(Integrator::Gear, &[2]);
}

/// Compares all bits, as every `f64` is written with all its digits; shows the first place that differs.
fn assert_same(what: &str, one: &str, other: &str) {
    let both = one.bytes().zip(other.bytes());
    if let Some(at) = both.into_iter().position(|(a, b)| a != b) {
        let from = at.saturating_sub(300);
        let shown = |text: &str| text.get(from..(at + 100).min(text.len())).map(str::to_string);
        panic!("{what}: the checkpoint differs\n{:?}\n{:?}", shown(one), shown(other));
    }
    assert_eq!(one.len(), other.len(), "{what}");
}
