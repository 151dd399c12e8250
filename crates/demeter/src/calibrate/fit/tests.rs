//! Round trips, what cannot be identified, and files that are wrong.

use super::*;
use crate::calibrate::{Engine, collide, sticking};
use crate::scenario::ImpactFile;
use demeter_physics::collision::Sticking;

const BODIES: &str = r#"
[material.mcc]
young_modulus = "6 GPa"
poisson_ratio = 0.3
density = "1500 kg/m^3"
[material.steel]
young_modulus = "210 GPa"
poisson_ratio = 0.3
density = "7800 kg/m^3"
[a]
material = "mcc"
radius = "5 mm"
[b]
material = "steel"
radius = "4 mm"
"#;

/// Bodies of fine powder.
const POWDER: &str = r#"
[material.limestone]
young_modulus = "150 GPa"
poisson_ratio = 0.28
density = "2740 kg/m^3"
[a]
material = "limestone"
radius = "0.6 um"
[b]
material = "limestone"
radius = "0.6 um"
fixed = true
"#;

/// One table of what a law shows at an impact speed.
fn seen(bodies: &str, normal: &str, velocity: f64, what: &[Observable]) -> String {
    let text = format!("{bodies}\n[contact]\nnormal = {{ {normal} }}\n[impact]\nvelocity = \"{velocity:e} m/s\"\n");
    let file = ImpactFile::parse(&text, "known.toml", &[]).unwrap();
    let report = collide(&file, Engine::Reference, 0).unwrap();
    let mut table = format!("[[observation]]\nvelocity = \"{velocity:e} m/s\"\n");
    for observable in what {
        let value = match observable {
            Observable::Restitution => report.restitution,
            Observable::ContactTime => report.contact_time.unwrap(),
            Observable::MaxOverlap => report.max_overlap,
            Observable::MaxForce => report.max_force,
            Observable::StickingVelocity | Observable::PullOffForce => f64::NAN,
        };
        table += &format!("{} = {}\n", observable.name(), written(value, observable.dimension()));
    }
    table
}

fn file(bodies: &str, law: &str, known: &str, unknown: &str, observations: &[String]) -> FitFile {
    let fit = format!("[fit]\nlaw = \"{law}\"\nknown = {{ {known} }}\nunknown = {{ {unknown} }}\n");
    let text = format!("{bodies}\n{fit}\n{}", observations.concat());
    FitFile::parse(&text, "fit.toml", &[]).unwrap_or_else(|faults| panic!("{faults}\n{text}"))
}

fn assert_found(report: &FitReport, expected: &[f64], relative: f64) {
    for (parameter, expected) in report.parameters.iter().zip(expected) {
        let error = (parameter.value / expected - 1.0).abs();
        assert!(
            error < relative,
            "{} is {} for {expected}",
            parameter.name,
            parameter.value
        );
        assert!(
            parameter.identified && parameter.error.is_some() && !parameter.at_bound,
            "{parameter:?}"
        );
    }
    assert_eq!((report.not_identified().count(), report.advice.len()), (0, 0));
    assert_eq!(
        (report.parameters.len(), report.fixed.len()),
        (expected.len(), expected.len())
    );
    assert!(report.worst() < 1e-4 && report.ambiguous.is_none(), "{report:?}");
}

use Observable::{ContactTime, MaxForce, MaxOverlap, Restitution};

/// From typical values on, grains as soft as these never yield, and no slope tells where to go.
#[test]
fn a_free_yield_pressure_is_found_far_below_a_typical_one() {
    let bodies = r#"
[material.soft]
young_modulus = "3 MPa"
poisson_ratio = 0.3
density = "1500 kg/m^3"
[a]
material = "soft"
radius = "2 mm"
[b]
material = "soft"
wall = true
"#;
    let known = "work_of_adhesion = \"0.05 N/m\"";
    let normal = format!("law = \"thornton-ning\", yield_pressure = \"60 kPa\", {known}");
    let impacts = [0.3, 0.6, 1.0].map(|velocity| seen(bodies, &normal, velocity, &[Restitution, MaxForce]));
    let report = fit(&file(
        bodies,
        "thornton-ning",
        known,
        "yield_pressure = \"free\"",
        &impacts,
    ))
    .unwrap();
    assert!((report.parameters[0].value / 60e3 - 1.0).abs() < 1e-3, "{report:?}");
    assert!(report.parameters[0].identified, "{report:?}");
}

#[test]
fn linear_springs_by_closed_form() {
    let normal = "law = \"linear\", stiffness = \"12 kN/m\", restitution = 0.37";
    for second in [ContactTime, MaxOverlap, MaxForce] {
        let seen = [seen(BODIES, normal, 0.7, &[Restitution, second])];
        let report = fit(&file(
            BODIES,
            "linear",
            "",
            "stiffness = \"free\", restitution = \"free\"",
            &seen,
        ))
        .unwrap();
        assert_eq!(report.method, "closed form");
        assert_found(&report, &[12e3, 0.37], 1e-9);
    }
    let seen = [seen(BODIES, normal, 0.7, &[Restitution, ContactTime])];
    let report = fit(&file(
        BODIES,
        "linear",
        "",
        "damping_rate = \"free\", stiffness = \"free\"",
        &seen,
    ))
    .unwrap();
    assert_eq!(report.method, "closed form");
    assert!(report.worst() < 1e-6 && (report.parameters[1].value / 12e3 - 1.0).abs() < 1e-9);
}

#[test]
fn hertzian_springs_by_closed_form_and_by_search() {
    for (end, e) in [("zero-overlap", 0.54), ("zero-force", 0.3)] {
        let known = format!("contact_end = \"{end}\"");
        let normal = format!("law = \"hertz-tsuji\", restitution = {e}, {known}");
        let unknown = "restitution = \"free\", \"material.mcc.young_modulus\" = [\"0.1 GPa\", \"100 GPa\"]";
        let one = [seen(BODIES, &normal, 1.0, &[Restitution, MaxOverlap])];
        let report = fit(&file(BODIES, "hertz-tsuji", &known, unknown, &one)).unwrap();
        assert_eq!(report.method, "closed form");
        assert_found(&report, &[e, 6e9], 1e-8);
        // two impacts go beyond the closed form
        let two = [one[0].clone(), seen(BODIES, &normal, 0.2, &[ContactTime, MaxForce])];
        let report = fit(&file(BODIES, "hertz-tsuji", &known, unknown, &two)).unwrap();
        assert!(report.method.contains("least squares"));
        assert_found(&report, &[e, 6e9], 1e-7);
    }
    let normal = "law = \"hertz-tsuji\", alpha = 0.43";
    // 1/E_eff depends on the steel by a few percent only
    let one = [seen(BODIES, normal, 1.0, &[Restitution, ContactTime])];
    let unknown = "alpha = \"free\", \"material.steel.young_modulus\" = \"free\"";
    let report = fit(&file(BODIES, "hertz-tsuji", "", unknown, &one)).unwrap();
    assert_found(&report, &[0.43, 210e9], 1e-7);
}

#[test]
fn viscoelastic_spheres_by_search() {
    let normal = "law = \"viscoelastic\", dissipation_time = \"0.8 us\"";
    let seen = [
        seen(BODIES, normal, 0.3, &[Restitution]),
        seen(BODIES, normal, 2.0, &[Restitution, ContactTime]),
    ];
    let unknown = "dissipation_time = \"free\", \"material.mcc.young_modulus\" = [\"1 GPa\", \"30 GPa\"]";
    let report = fit(&file(BODIES, "viscoelastic", "", unknown, &seen)).unwrap();
    assert_found(&report, &[0.8e-6, 6e9], 1e-6);
}

#[test]
fn dents_by_search() {
    let normal = "law = \"walton-braun\", loading_stiffness = \"20 kN/m\", unloading_stiffness = \"55 kN/m\"";
    let seen = [seen(BODIES, normal, 0.5, &[Restitution, MaxOverlap])];
    let unknown = "loading_stiffness = \"free\", unloading_stiffness = \"free\"";
    let report = fit(&file(BODIES, "walton-braun", "", unknown, &seen)).unwrap();
    assert_found(&report, &[20e3, 55e3], 1e-6);
}

#[test]
fn adhesion_from_the_speed_below_which_powder_sticks() {
    let known = "separation = \"0.336 nm\", micro_yield_strength = \"300 MPa\", kappa_p = 0.153, tail = \"none\"";
    let normal = format!("law = \"tomas\", adhesion_force = \"2.64 nN\", alpha = 0.2, {known}");
    let text = format!("{POWDER}\n[contact]\nnormal = {{ {normal} }}\n");
    let impact = ImpactFile::parse(&text, "known.toml", &[]).unwrap();
    let point = sticking(&impact, &[0.3e-6]).unwrap()[0];
    let Sticking::Below(speed) = point.sticking else {
        panic!("{point:?}");
    };
    let seen = [
        format!("[[observation]]\nsticking_velocity = \"{speed:e} m/s\"\n"),
        seen(POWDER, &normal, 5.0 * speed, &[Restitution]),
    ];
    let unknown = "adhesion_force = [\"0.1 nN\", \"100 nN\"], alpha = [0.01, 1]";
    let report = fit(&file(POWDER, "tomas", known, unknown, &seen)).unwrap();
    // the speed is bracketed to 1e-7
    assert!((report.parameters[0].value / 2.64e-9 - 1.0).abs() < 1e-4, "{report:?}");
    assert!((report.parameters[1].value / 0.2 - 1.0).abs() < 1e-4, "{report:?}");
    assert_eq!(report.not_identified().count(), 0);
    // a pull alone gives the pull
    let pull = ["[[observation]]\npull_off_force = \"2.64 nN\"\n".to_string()];
    let elastic = "separation = \"0.336 nm\", loading = \"elastic\", alpha = 0.2";
    let report = fit(&file(POWDER, "tomas", elastic, "adhesion_force = \"free\"", &pull)).unwrap();
    assert_found(&report, &[2.64e-9], 1e-6);
}

#[test]
fn a_restitution_alone_tells_nothing_of_the_stiffness() {
    let normal = "law = \"linear\", stiffness = \"12 kN/m\", restitution = 0.37";
    let seen = [seen(BODIES, normal, 0.7, &[Restitution])];
    let report = fit(&file(
        BODIES,
        "linear",
        "",
        "stiffness = \"free\", restitution = \"free\"",
        &seen,
    ))
    .unwrap();
    assert_eq!(report.not_identified().collect::<Vec<_>>(), ["stiffness"]);
    assert!((report.parameters[1].value / 0.37 - 1.0).abs() < 1e-9 && report.parameters[0].error.is_none());
    assert_eq!(report.fixed.len(), 1);
    assert_eq!(report.fixed[0].powers, [("restitution".to_string(), 1.0)]);
    assert_eq!(report.advice.len(), 1);
    let advice = &report.advice[0];
    assert_eq!((advice.observable, advice.velocity), (ContactTime, Some(0.7)));
    assert!((advice.sensitivity - 0.5).abs() < 1e-3);
    assert!(report.singular_values[1] < 1e-9);
}

#[test]
fn one_contact_time_fixes_a_product_of_two_unknowns() {
    let normal = "law = \"linear\", stiffness = \"12 kN/m\", restitution = 0.37";
    let seen = [seen(BODIES, normal, 0.7, &[ContactTime])];
    let unknown = "stiffness = [\"1 kN/m\", \"100 kN/m\"], restitution = [0.05, 0.9]";
    let report = fit(&file(BODIES, "linear", "", unknown, &seen)).unwrap();
    assert_eq!(
        report.not_identified().collect::<Vec<_>>(),
        ["stiffness", "restitution"]
    );
    assert!(report.worst() < 1e-6);
    let [combination] = report.fixed.as_slice() else {
        panic!("{report:?}");
    };
    // T^2 = (m/k) (pi^2 + L^2): k is fixed up to the power -d ln T^2/d ln e of e
    let e = report.parameters[1].value;
    let loss = -libm::log(e);
    let power = 2.0 * loss / (loss * loss + std::f64::consts::PI * std::f64::consts::PI);
    assert_eq!(combination.powers[0], ("stiffness".to_string(), 1.0));
    assert!(
        (combination.powers[1].1 - power).abs() < 1e-4,
        "{combination:?} {power}"
    );
    assert_eq!(report.advice[0].observable, Restitution);
    assert_eq!(report.ambiguous, None);
}

#[test]
fn moduli_and_poisson_ratios_are_never_told_apart_by_normal_impacts() {
    let normal = "law = \"hertz-tsuji\", restitution = 0.6";
    let seen = [
        seen(BODIES, normal, 0.7, &[Restitution, ContactTime]),
        seen(BODIES, normal, 3.0, &[MaxForce]),
    ];
    let unknown = "restitution = \"free\", \"material.mcc.young_modulus\" = [\"1 GPa\", \"30 GPa\"], \
                   \"material.mcc.poisson_ratio\" = [0.1, 0.45]";
    let report = fit(&file(BODIES, "hertz-tsuji", "", unknown, &seen)).unwrap();
    let open: Vec<&str> = report.not_identified().collect();
    assert_eq!(open, ["material.mcc.young_modulus", "material.mcc.poisson_ratio"]);
    assert!((report.parameters[0].value / 0.6 - 1.0).abs() < 1e-6);
    assert!(
        report.advice.is_empty(),
        "no impact tells them apart: {:?}",
        report.advice
    );
}

#[test]
fn errors_weigh_and_come_back() {
    let normal = "law = \"hertz-tsuji\", restitution = 0.6";
    let seen = seen(BODIES, normal, 0.7, &[Restitution, ContactTime]);
    let unknown = "restitution = \"free\", \"material.mcc.young_modulus\" = [\"1 GPa\", \"30 GPa\"]";
    let report = |error: &str| {
        let table = format!("{seen}error = {error}\n");
        fit(&file(BODIES, "hertz-tsuji", "", unknown, &[table])).unwrap()
    };
    let (coarse, fine) = (
        report("0.02"),
        report("{ restitution = 0.006, contact_time = \"1 ns\" }"),
    );
    let error = |report: &FitReport, k: usize| report.parameters[k].error.unwrap();
    assert!((error(&coarse, 0) - 0.02).abs() < 1e-6 && (error(&fine, 0) - 0.01).abs() < 1e-6);
    // T goes as E^(-2/5) of the soft one, nearly
    assert!(error(&coarse, 1) > 0.04 && error(&coarse, 1) < 0.06 && error(&fine, 1) < 0.01);
}

#[test]
fn errors_in_the_unit_of_the_observation_make_means_and_relative_ones_geometric_means() {
    let observed = |restitution: f64, error: &str| {
        format!("[[observation]]\nvelocity = \"1 m/s\"\nrestitution = {restitution}\nerror = {error}\n")
    };
    let found = |errors: [&str; 2], seen: [f64; 2]| {
        let observations: Vec<String> = seen.iter().zip(errors).map(|(e, error)| observed(*e, error)).collect();
        let report = fit(&file(
            BODIES,
            "hertz-tsuji",
            "",
            "restitution = \"free\"",
            &observations,
        ))
        .unwrap();
        let [parameter] = &report.parameters[..] else { panic!() };
        let deviations = [0, 1].map(|k| report.residuals[k].deviation);
        (parameter.value, parameter.error.unwrap(), deviations)
    };
    let near = |a: f64, b: f64| (a / b - 1.0).abs() < 1e-5;
    let told = "{ restitution = 0.05 }";
    let (value, error, deviations) = found([told; 2], [0.1, 0.2]);
    assert!(
        near(value, 0.15) && near(error * value, 0.05 / 2f64.sqrt()),
        "{value} {error}"
    );
    assert!(near(deviations[0], 1.0) && near(deviations[1], -1.0), "{deviations:?}");
    // weights are those of the errors, and a law that does not fit says by how many of them
    let (value, _, deviations) = found(["{ restitution = 0.01 }", "{ restitution = 0.02 }"], [0.1, 0.5]);
    assert!(
        near(value, 0.18) && near(deviations[0], 8.0) && near(deviations[1], -16.0),
        "{value} {deviations:?}"
    );
    let (value, error, deviations) = found(["0.5"; 2], [0.1, 0.2]);
    assert!(
        near(value, 0.02f64.sqrt()) && near(error, 0.5 / 2f64.sqrt()),
        "{value} {error}"
    );
    assert!(near(deviations[0], libm::log(2.0)), "{deviations:?}");
}

#[test]
fn many_observations_fit_the_law_that_made_them_and_no_other() {
    let noise = verdict::tests::noise(1, 24);
    let report = |slant: f64| {
        let seen = noise.iter().enumerate().map(|(k, noise)| {
            let velocity = 0.1 * libm::pow(50.0, k as f64 / 23.0);
            let restitution = 0.6 * libm::pow(velocity, slant) * libm::exp(0.02 * noise);
            format!("[[observation]]\nvelocity = \"{velocity} m/s\"\nrestitution = {restitution}\nerror = 0.02\n")
        });
        let seen: Vec<String> = seen.collect();
        fit(&file(BODIES, "hertz-tsuji", "", "restitution = [0.5, 0.7]", &seen)).unwrap()
    };
    let right = report(0.0);
    assert!(right.fits() && right.degrees_of_freedom() == 23, "{right:?}");
    // a restitution that falls by 11 % over all velocities
    let wrong = report(-0.03);
    assert!(!wrong.fits(), "{wrong:?}");
}

#[test]
fn the_law_is_written_as_a_scenario_reads_it() {
    let normal = "law = \"hertz-tsuji\", restitution = 0.3, contact_end = \"zero-force\"";
    let seen = [seen(BODIES, normal, 1.0, &[Restitution, ContactTime])];
    let unknown = "restitution = \"free\", \"material.mcc.young_modulus\" = \"free\"";
    let report = fit(&file(
        BODIES,
        "hertz-tsuji",
        "contact_end = \"zero-force\"",
        unknown,
        &seen,
    ))
    .unwrap();
    let text = format!(
        "{BODIES}\n[contact]\n{}\n[impact]\nvelocity = \"1 m/s\"\n",
        report.contact
    );
    let impact = ImpactFile::parse(&text, "again.toml", &report.material).unwrap();
    assert!((impact.materials[0].young_modulus / 6e9 - 1.0).abs() < 1e-9);
    let again = collide(&impact, Engine::Reference, 0).unwrap();
    assert!((again.restitution - 0.3).abs() < 1e-9);
}

#[test]
fn what_is_wrong_is_told_with_its_place() {
    let good = format!(
        "{BODIES}\n[fit]\nlaw = \"linear\"\nunknown = {{ stiffness = \"free\", restitution = [0.1, 0.9] }}\n\
         [[observation]]\nvelocity = \"1 m/s\"\nrestitution = 0.5\n"
    );
    assert!(FitFile::parse(&good, "fit.toml", &[]).is_ok());
    let cases = [
        ("fit.law=linaer", "unknown normal law `linaer`"),
        ("fit.unknown={}", "nothing is sought"),
        ("fit.unknown.stiffness=3", "`stiffness` has no bounds"),
        ("fit.unknown.stiffness=[\"1 N/m\"]", "needs two bounds, found 1"),
        (
            "fit.unknown.stiffness=[\"2 N/m\", \"1 N/m\"]",
            "must be below the second",
        ),
        ("fit.unknown.stiffness=[\"0 N/m\", \"1 N/m\"]", "must be above 0"),
        ("fit.unknown.stiffness=[\"1 m\", \"2 m\"]", "must be a stiffness"),
        ("fit.unknown.restitution=[0.5, 1.5]", "at most 1"),
        ("fit.unknown.stifness=free", "law `linear` has no parameter `stifness`"),
        ("fit.unknown.contact_end=free", "is a choice, not a number"),
        (
            "fit.unknown.\"material.mcc.density\"=free",
            "`density` of a material cannot be sought",
        ),
        (
            "fit.unknown.\"material.glass.young_modulus\"=free",
            "unknown material `glass`",
        ),
        ("fit.known={restitution = 0.5}", "known and unknown"),
        ("fit.known={colour = 1}", "unknown key `colour`"),
        ("fit.start=near", "unknown value `near`"),
        ("observation[0].restitution=1.5", "at most 1"),
        ("observation[0].speed=1", "unknown key `speed`"),
        ("observation[0].error=2", "at most 1"),
        ("observation[0].error={max_force = \"1 N\"}", "unknown key `max_force`"),
        ("observation[0].preload=\"1 N\"", "goes with `pull_off_force`"),
        ("observation=[{velocity = \"1 m/s\"}]", "nothing that was measured"),
        ("observation=[{restitution = 0.5}]", "`velocity` is missing"),
        ("observation=[]", "there is no observation"),
        ("b={material = \"mcc\"}", "neither a radius"),
        ("contact={}", "unknown key `contact`"),
    ];
    for (set, message) in cases {
        let faults = FitFile::parse(&good, "fit.toml", &[set.to_string()]).unwrap_err();
        assert!(faults.to_string().contains(message), "{set}: {faults}");
        assert!(faults.list().iter().all(|f| f.line > 0), "{set}: {faults}");
    }
    for table in ["[fit]", "[[observation]]", "[a]"] {
        let text = good.replace(table, "[other]");
        assert!(
            FitFile::parse(&text, "x", &[])
                .unwrap_err()
                .to_string()
                .contains("is missing"),
            "{table}"
        );
    }
    // what only the law knows is told when it is bound
    let lone = FitFile::parse(&good, "fit.toml", &["fit.unknown={restitution = \"free\"}".to_string()]).unwrap();
    let error = fit(&lone).unwrap_err().to_string();
    assert!(error.contains("the stiffness is missing"), "{error}");
}

#[test]
fn a_pull_off_force_tells_the_work_of_adhesion() {
    // 3/2 pi w R with R = 0.3 um
    let force = 1.5 * std::f64::consts::PI * 0.05 * 0.3e-6;
    let pull = [format!("[[observation]]\npull_off_force = \"{force:e} N\"\n")];
    let known = "alpha = 0.1";
    let report = fit(&file(POWDER, "jkr", known, "work_of_adhesion = \"free\"", &pull)).unwrap();
    assert_found(&report, &[0.05], 1e-6);
}

#[test]
fn a_free_work_of_adhesion_of_thornton_and_ning_begins_at_a_typical_one() {
    let seen = ["[[observation]]\npull_off_force = \"1 mN\"\n".to_string()];
    let known = "yield_pressure = \"100 MPa\"";
    let report = fit(&file(
        BODIES,
        "thornton-ning",
        known,
        "work_of_adhesion = \"free\"",
        &seen,
    ))
    .unwrap();
    assert!(report.parameters[0].identified && report.worst() < 1e-3, "{report:?}");
}

#[test]
fn a_law_without_adhesion_is_not_fitted_to_what_only_adhesion_shows() {
    for (law, known, unknown) in [
        ("hertz-tsuji", "", "restitution = \"free\""),
        ("linear", "restitution = 0.5", "stiffness = \"free\""),
        ("jkr", "work_of_adhesion = \"0 N/m\"", "alpha = \"free\""),
    ] {
        for (key, value) in [("sticking_velocity", "1 mm/s"), ("pull_off_force", "1 mN")] {
            let seen = [format!("[[observation]]\n{key} = \"{value}\"\n")];
            let error = fit(&file(BODIES, law, known, unknown, &seen)).unwrap_err().to_string();
            let expected = format!("`{key}` cannot be fitted: law `{law}` has no adhesion with these parameters");
            assert!(error.contains(&expected), "{error}");
        }
    }
}

#[test]
fn the_start_is_told_where_it_makes_a_difference() {
    let seen = ["[[observation]]\npull_off_force = \"10 nN\"\n".to_string()];
    let dmt = |known: &str| fit(&file(POWDER, "dmt", known, "work_of_adhesion = \"free\"", &seen)).unwrap();
    assert_eq!(dmt("alpha = 0.1").start, None);
    let across = dmt("alpha = 0.1, separation = \"0.4 nm\"");
    assert_eq!(across.start, Some(Start::Contact));
    assert_eq!(across.to_json()["start"], "contact");
}

#[test]
fn what_has_an_error_larger_than_itself_is_not_identified() {
    let normal = "law = \"hertz-tsuji\", restitution = 0.6";
    let seen = [seen(BODIES, normal, 0.7, &[Restitution]) + "error = { restitution = 2 }\n"];
    let report = fit(&file(BODIES, "hertz-tsuji", "", "restitution = \"free\"", &seen)).unwrap();
    let found = &report.parameters[0];
    assert!(
        !found.identified && found.error.is_some_and(|error| error > 1.0),
        "{found:?}"
    );
    assert_eq!(report.to_json()["not_identified"][0], "restitution");
}
