//! Two bodies against closed forms, and the two ways of computing them against each other.

use super::extrapolate::limit;
use super::flight::Launch;
use super::*;
use crate::scenario::{DEFAULT_MAX_OVERLAP, ImpactFile};
use approx::assert_relative_eq;
use demeter_physics::collision::Outcome;

const MCC: &str = r#"
[material.mcc]
young_modulus = "6 GPa"
poisson_ratio = 0.3
density = "1500 kg/m^3"
[a]
material = "mcc"
radius = "5 mm"
[b]
material = "mcc"
radius = "5 mm"
[contact]
normal = { law = "hertz-tsuji", restitution = 0.54 }
[impact]
velocity = "1 m/s"
"#;

fn file(overrides: &[&str]) -> ImpactFile {
    let overrides: Vec<String> = overrides.iter().map(ToString::to_string).collect();
    match ImpactFile::parse(MCC, "mcc.toml", &overrides) {
        Ok(file) => file,
        Err(faults) => panic!("{}", faults.render(false)),
    }
}

const WALL: &str = "b={material = \"mcc\", wall = true}";
const FRICTION: &str = "contact.tangential={law = \"mindlin-history\", friction = 0.1}";

#[test]
fn figure_one_of_antypov_and_elliott() {
    let found = collide(&file(&[]), Engine::Reference, 11).unwrap();
    assert_eq!(found.outcome, Outcome::Rebound);
    assert_relative_eq!(found.restitution, 0.54, max_relative = 1e-10);
    assert_relative_eq!(found.contact_time.unwrap(), 69.51247874e-6, max_relative = 1e-9);
    assert_relative_eq!(found.max_overlap, 17.60955505e-6, max_relative = 1e-9);
    assert!(found.estimated_error.unwrap() < 1e-8);
    assert_eq!(found.moments.len(), 11);
    // momentum and energy of the two bodies
    assert_relative_eq!(found.velocity[0].z, -0.23, max_relative = 1e-9);
    assert_relative_eq!(found.velocity[1].z, -0.77, max_relative = 1e-9);
    let (before, after) = (found.before, found.after);
    assert_relative_eq!(
        after.kinetic + after.viscous_dissipated,
        before.kinetic,
        max_relative = 1e-10
    );
}

#[test]
fn the_engine_meets_the_reference_in_every_pairing() {
    let pairings: [&[&str]; 4] = [&[], &[WALL], &["b.fixed=true"], &["b.radius=1 mm"]];
    let laws = [
        "contact.normal={law = \"linear\", stiffness = \"1e6 N/m\", restitution = 0.97, contact_end = \"zero-force\"}",
        "contact.normal={law = \"hertz-tsuji\", restitution = 0.995, contact_end = \"zero-force\"}",
        "contact.normal={law = \"viscoelastic\", restitution = 0.99, impact_speed = \"1 m/s\", contact_end = \"zero-force\"}",
        "contact.normal={law = \"hertz-tsuji\", restitution = 0.2}",
        "contact.normal={law = \"linear\", stiffness = \"1e6 N/m\", restitution = 0.7}",
        "contact.normal={law = \"linear\", stiffness = \"1e6 N/m\", restitution = 0.5, contact_end = \"zero-force\"}",
        "contact.normal={law = \"hertz-tsuji\", restitution = 0.3, contact_end = \"zero-force\"}",
    ];
    for pairing in pairings {
        for law in laws {
            let file = file(&[pairing, &[law]].concat());
            let reference = collide(&file, Engine::Reference, 0).unwrap();
            let engine = collide(&file, Engine::Automatic, 0).unwrap();
            let speed = 1.0;
            assert!(
                (engine.restitution - reference.restitution).abs() < 1e-4 * speed,
                "{pairing:?} {law}"
            );
            for (a, b) in [
                (engine.contact_time.unwrap(), reference.contact_time.unwrap()),
                (engine.max_overlap, reference.max_overlap),
                (engine.max_force, reference.max_force),
                (engine.after.viscous_dissipated, reference.after.viscous_dissipated),
            ] {
                assert_relative_eq!(a, b, max_relative = 1e-3);
            }
            for body in 0..2 {
                assert!(
                    (engine.velocity[body] - reference.velocity[body]).length() < 1e-4,
                    "{pairing:?} {law}"
                );
            }
        }
    }
}

#[test]
fn slow_impacts_are_right_or_refused() {
    let at = |speed: &str, engine| collide(&file(&[&format!("impact.velocity={speed} m/s")]), engine, 0);
    for speed in ["1e-15", "1e-20", "1e-24", "1e-30", "1e-50"] {
        let found = at(speed, Engine::Reference).unwrap();
        assert_relative_eq!(found.restitution, 0.54, max_relative = 1e-9);
    }
    for speed in ["1e-100", "1e-160", "1e-300"] {
        let refused = at(speed, Engine::Reference).unwrap_err().to_string();
        assert!(refused.contains("too slow"), "{refused}");
    }
    let refused = at("1e-11", Engine::Automatic).unwrap_err().to_string();
    assert!(refused.contains("rounds their places"), "{refused}");
}

#[test]
fn extrapolation_knows_its_error() {
    for pairing in [&[][..], &[WALL][..]] {
        let file = file(pairing);
        let law = file.law().unwrap();
        let launch = Launch {
            file: &file,
            law: &law,
            speed: 1.0,
            max_overlap: DEFAULT_MAX_OVERLAP,
        };
        let found = limit(&launch).unwrap();
        let exact = collide(&file, Engine::Reference, 0).unwrap();
        assert!(found.error < 1e-5, "{}", found.error);
        let allowed = (10.0 * found.error).max(1e-6);
        let rate = found.flight.velocity[1].z - found.flight.velocity[0].z;
        assert!((-rate - exact.restitution).abs() < allowed, "{rate} {}", found.error);
        assert_relative_eq!(
            found.flight.contact_time,
            exact.contact_time.unwrap(),
            max_relative = allowed
        );
        assert_relative_eq!(found.flight.max_overlap, exact.max_overlap, max_relative = allowed);
    }
}

#[test]
fn oblique_impacts_without_friction_keep_the_tangential_velocity() {
    let found = collide(&file(&[WALL, "impact.angle=40 deg"]), Engine::Reference, 0).unwrap();
    assert_relative_eq!(found.restitution, 0.54, max_relative = 1e-6);
    assert_relative_eq!(found.tangential_restitution.unwrap(), -1.0, max_relative = 1e-9);
    let (sin, cos) = (libm::sin(40f64.to_radians()), libm::cos(40f64.to_radians()));
    assert_relative_eq!(found.angle_out, libm::atan2(sin, 0.54 * cos), max_relative = 1e-6);
    let slower = collide(
        &file(&[WALL, &format!("impact.velocity={cos} m/s")]),
        Engine::Reference,
        0,
    )
    .unwrap();
    assert_relative_eq!(
        found.contact_time.unwrap(),
        slower.contact_time.unwrap(),
        max_relative = 1e-6
    );
}

#[test]
fn gross_sliding_and_spin() {
    // sliding all through the contact: the tangential impulse is mu times the normal one (Walton 1993)
    let elastic = "contact.normal.restitution=1.0";
    for (angle, spin) in [("75 deg", "0 rad/s"), ("0 deg", "400 rad/s")] {
        let set = [
            WALL,
            FRICTION,
            elastic,
            &format!("impact.angle={angle}"),
            &format!("impact.spin_a={spin}"),
        ];
        let found = collide(&file(&set), Engine::Reference, 0).unwrap();
        let degrees: f64 = angle.trim_end_matches(" deg").parse().unwrap();
        let (tangential, normal) = (libm::sin(degrees.to_radians()), libm::cos(degrees.to_radians()));
        let impulse = 0.1 * 2.0 * normal;
        // a spin forward drives the bead forward, sliding brakes one that does not turn
        let sign = if spin == "0 rad/s" { -1.0 } else { 1.0 };
        assert_relative_eq!(found.velocity[0].x, tangential + sign * impulse, max_relative = 1e-4);
        let before = if sign > 0.0 { 400.0 } else { 0.0 };
        // 5/2 of the impulse over the radius, less the overlap that shortens the lever
        assert_relative_eq!(
            found.spin[0].y - before,
            -sign * 2.5 * impulse / 5e-3,
            max_relative = 1e-2
        );
        assert!(found.after.friction_dissipated > 0.0 && found.estimated_error.unwrap() < 1e-4);
        let engine = collide(&file(&set), Engine::Automatic, 0).unwrap();
        assert!((engine.velocity[0] - found.velocity[0]).length() < 1e-3);
    }
}

#[test]
fn curves_follow_the_law() {
    let curve = contact_curve(&file(&["curve={max_overlap = \"8 um\", points = 9}"]))
        .unwrap()
        .points;
    let names: Vec<&str> = curve
        .chunk_by(|a, b| a.branch == b.branch)
        .map(|rows| rows[0].branch.name())
        .collect();
    assert_eq!(names, ["load", "unload", "reload", "pull-off"]);
    let k = 4.0 / 3.0 * 6e9 / (2.0 * 0.91) * 2.5e-3f64.sqrt();
    for point in &curve {
        assert_relative_eq!(
            point.force,
            k * point.overlap * point.overlap.sqrt(),
            max_relative = 1e-13
        );
        assert_relative_eq!(point.stored, 0.4 * point.force * point.overlap, max_relative = 1e-13);
    }
    assert_relative_eq!(curve[8].overlap, 8e-6);
    // unloaded to half of the largest force
    assert_relative_eq!(curve[17].force, 0.5 * curve[8].force, max_relative = 1e-12);
    let forced = contact_curve(&file(&["curve={max_force = \"5 N\", points = 2, reload = false}"]))
        .unwrap()
        .points;
    assert_eq!(forced.len(), 4);
    assert_relative_eq!(forced[1].force, 5.0, max_relative = 1e-12);
    // as deep as the impact goes
    let automatic = contact_curve(&file(&[])).unwrap().points;
    assert_relative_eq!(automatic[199].overlap, 17.60955505e-6, max_relative = 1e-9);
    for (told, words) in [
        ("max_force = \"1e9 N\"", "`max_force` is 1000000000 N"),
        // what is reached is not lost in the rounding of what was asked for
        ("max_force = \"1e30 N\"", "the force is 2.7473e4 N"),
        ("max_overlap = \"1 m\"", "at most the effective radius, 0.0025 m"),
        (
            "max_overlap = \"1 um\", unload_to = \"2 um\"",
            "`unload_to` is 0.000002 m",
        ),
    ] {
        let refused = contact_curve(&file(&[&format!("curve={{{told}}}")]))
            .unwrap_err()
            .to_string();
        assert!(refused.contains(words), "{refused}");
    }
}

/// The curve of a law between a grain of 5 mm, of 0.1 GPa, and a wall.
fn curve_on_a_wall(normal: &str, curve: &str) -> ContactCurve {
    let text = format!(
        "plain_numbers = \"SI\"\n[material.a]\nyoung_modulus = 1e8\npoisson_ratio = 0.3\ndensity = 2500\n\
         [a]\nmaterial = \"a\"\nradius = 0.005\n[b]\nmaterial = \"a\"\nwall = true\n\
         [contact]\nnormal = {{ {normal} }}\n[curve]\n{curve}\n"
    );
    match ImpactFile::parse(&text, "wall.toml", &[]) {
        Ok(file) => contact_curve(&file).unwrap(),
        Err(faults) => panic!("{}", faults.render(false)),
    }
}

#[test]
fn the_largest_pull_is_that_of_the_law_whatever_rows_are_drawn() {
    let k = 4.0 / 3.0 * 1e8 / (2.0 * 0.91) * 0.005f64.sqrt();
    let area = 2.0 * std::f64::consts::PI * 0.005;
    let (k1, k2, kc, depth) = (1e3, 2e3, 500.0, 1e-4);
    let (dent, cohesion) = ((1.0 - k1 / k2) * depth, area * 1e5);
    let luding = format!(
        "law = \"luding\", loading_stiffness = {k1}, unloading_stiffness = {k2}, unloading = \"constant\", \
         plastic_depth = 0.1, adhesion_stiffness = {kc}, damping = 0"
    );
    let laws = [
        // it is largest right behind first touch, a place without a width
        ("law = \"dmt\", work_of_adhesion = 0.5", area * 0.5, 0.0),
        ("law = \"jkr\", work_of_adhesion = 0.5", 0.75 * area * 0.5, f64::NAN),
        (
            "law = \"sjkr\", cohesion_energy_density = 1e5",
            4.0 * cohesion.powi(3) / (27.0 * k * k),
            (2.0 * cohesion / (3.0 * k)).powi(2),
        ),
        (&luding, kc * k2 * dent / (k2 + kc), k2 * dent / (k2 + kc)),
    ];
    for (normal, force, place) in laws {
        for rows in ["points = 2", "points = 20\nreload = false", "points = 200"] {
            let found = curve_on_a_wall(normal, &format!("max_overlap = {depth}\n{rows}"));
            let (pull, overlap) = found.extremes.largest_pull.unwrap();
            assert_relative_eq!(pull, -force, max_relative = 1e-9);
            if place.is_finite() {
                assert_relative_eq!(overlap, place, max_relative = 1e-6);
            }
        }
    }
    let hertz = curve_on_a_wall("law = \"hertz-tsuji\", alpha = 0", "max_overlap = 1e-4");
    assert_eq!(hertz.extremes.largest_pull, None);
}

#[test]
fn contact_ends_where_the_law_ends_and_not_where_the_rows_do() {
    let tomas = "law = \"tomas\", loading = \"elastic\", adhesion_force = 1e-3, kappa_a = 0.7, \
                 separation = 1e-6, alpha = 0";
    let dmt = "law = \"dmt\", work_of_adhesion = 0.5, separation = 1e-6, cutoff = 1e-4";
    let luding = "law = \"luding\", loading_stiffness = 1e3, unloading_stiffness = 2e3, plastic_depth = 0.1, \
                  adhesion_stiffness = 0, damping = 0, attraction_force = 1e-3, attraction_range = 1e-3";
    for (normal, end, deep) in [(tomas, -1e-4, 1e-4), (dmt, -1e-4, 1e-4), (luding, -1e-3, 1e-3)] {
        let cut = curve_on_a_wall(normal, "max_overlap = 2e-5");
        assert_relative_eq!(cut.extremes.end_of_contact, end, max_relative = 1e-12);
        assert_relative_eq!(cut.cut_at().unwrap(), -4e-5, max_relative = 1e-12);
        let whole = curve_on_a_wall(normal, &format!("max_overlap = {deep}"));
        assert_relative_eq!(whole.extremes.end_of_contact, end, max_relative = 1e-12);
        assert_eq!(whole.cut_at(), None);
    }
}

#[test]
fn what_cannot_be_done_is_told() {
    let text = MCC.replace("velocity = \"1 m/s\"", "");
    let file = ImpactFile::parse(&text, "x", &[]).unwrap();
    let message = collide(&file, Engine::Reference, 0).unwrap_err().to_string();
    assert!(message.contains("`velocity` is missing"), "{message}");
    // without a velocity a curve goes to a hundredth of the radius
    let curve = contact_curve(&file).unwrap().points;
    assert_relative_eq!(curve[199].overlap, 0.01 * 2.5e-3, max_relative = 1e-12);
}

#[test]
fn radii_are_spaced_by_equal_ratios() {
    let radii = log_spaced(1e-7, 1e-6, 11);
    assert_eq!((radii.len(), radii[0], radii[10]), (11, 1e-7, 1e-6));
    for pair in radii.windows(2) {
        assert_relative_eq!(pair[1] / pair[0], libm::pow(10.0, 0.1), max_relative = 1e-12);
    }
    assert_eq!(log_spaced(3.0, 3.0, 1), [3.0]);
}

#[test]
fn a_start_far_away_is_blamed_only_where_the_law_acts_across_a_gap() {
    let told = |across_a_gap| {
        let (steps, dt, time) = (5, 1.0, 5.0);
        CalibrateError::Steps {
            steps,
            dt,
            time,
            across_a_gap,
        }
        .to_string()
    };
    assert!(told(true).contains("tell `start = \"contact\"`"));
    assert!(!told(false).contains("start ="));
}
