use super::*;
use proptest::prelude::*;

#[test]
fn overrides_reach_every_part() {
    let overrides = [
        "grains[0].count=20",
        "wall.box.open=[]",
        "stage.0.duration=2 ms",
        "simulation.skin=\"1 mm\"",
        "output.frames=never",
        "material.glass.density = 2600 kg/m^3",
        "domain.outside=remove",
    ];
    let scenario = parse(settle(), &overrides).unwrap();
    assert!(matches!(
        &scenario.grains[0].source,
        Source::Random {
            amount: Amount::Count(20),
            ..
        }
    ));
    assert!(matches!(&scenario.walls[0].shape, WallShape::Given(Shape::Box { open, .. }) if *open == [false; 6]));
    assert_eq!(scenario.stages[0].stop[0], StopCondition::Duration(2e-3));
    assert_eq!(
        (scenario.simulation.skin, scenario.output.cadence.frames),
        (Some(1e-3), None)
    );
    assert_eq!(
        (scenario.materials[0].density, scenario.domain.outside),
        (2600.0, Outside::Remove)
    );
    assert!(scenario.to_resolved_toml().contains("count = 20"));
    let whole = parse(
        settle(),
        &["grains[0]={ material = \"glass\", source = \"list\", positions = [\"0 0 9 mm\"], diameter = \"2 mm\" }"],
    );
    assert!(matches!(&whole.unwrap().grains[0].source, Source::List { diameters, .. } if *diameters == [2e-3]));
}

#[test]
fn a_bracket_too_many_makes_no_key() {
    for key in [
        "stage[0]]",
        "stage[0]]]",
        "stage.0]",
        "stage[[0]",
        "stage[]",
        "stage]0[",
    ] {
        let faults = parse(settle(), &[&format!("{key}.duration=2 ms")]).unwrap_err();
        let told = faults.render(false);
        assert!(told.contains(&format!("`{key}.duration` is not a key")), "{told}");
    }
}

#[test]
fn a_fault_of_an_override_points_at_its_text() {
    let faults = parse(settle(), &["seed=2", "grains[0].diameter=2 s"]).unwrap_err();
    let fault = &faults.list()[0];
    assert_eq!((fault.source.as_str(), fault.line, fault.column), ("--set", 1, 20));
    assert_eq!(fault.path, "grains[0].diameter");
    let drawn = faults.render(false);
    assert!(
        drawn.contains("grains[0].diameter=2 s\n") && drawn.contains("^^^"),
        "{drawn}"
    );
}

#[test]
fn later_checks_point_at_the_key() {
    let scenario = parse(settle(), &[]).unwrap();
    let mut faults = scenario.diagnostics();
    assert!(faults.is_empty());
    faults.push("stage[0].stop.kinetic_over_elastic", "too small", None);
    faults.push("wall[0].lower", "outside the domain", Some("move it".to_string()));
    faults.push("wall[0].radius", "not written: at its wall", None);
    let after_wall = |text: &str| {
        settle()
            .lines()
            .skip_while(|l| *l != "[[wall]]")
            .position(|l| l.starts_with(text))
    };
    let wall = settle().lines().position(|l| l == "[[wall]]").unwrap() + 1;
    let expected = [
        wall,
        wall + after_wall("lower").unwrap(),
        wall + after_wall("stop").unwrap(),
    ];
    let lines: Vec<usize> = faults.list().iter().map(|f| f.line).collect();
    assert_eq!(lines, expected);
    let span = scenario.origin("material.glass.density").unwrap();
    assert_eq!(&scenario.text[span.bytes], "\"2500 kg/m^3\"");
    assert_eq!(scenario.origin("nothing"), None);
}

#[test]
fn a_fault_is_drawn_with_its_line_and_underlined() {
    let text = settle().replace("poisson_ratio = 0.25", "poisson_ratio = 0.75");
    let faults = parse(&text, &[]).unwrap_err();
    let drawn = faults.render(false);
    let line = text.lines().position(|l| l.contains("0.75")).unwrap() + 1;
    assert!(drawn.contains(&format!("--> case.toml:{line}:17")), "{drawn}");
    assert!(
        drawn.contains("poisson_ratio = 0.75") && drawn.contains("^^^^"),
        "{drawn}"
    );
    let plain = format!("case.toml:{line}:17: `poisson_ratio` is 0.75; it must be above -1 and at most 0.5");
    assert_eq!(faults.to_string(), plain);
}

/// Each looked for its place among all, which took minutes.
#[test]
fn very_many_faults_are_counted_and_take_no_time() {
    let keys: String = (0..100_000).map(|k| format!("k{k} = 1\n")).collect();
    let text = format!("{}[very-many]\n{keys}", settle());
    let flat = format!("{}{keys}", settle());
    let began = std::time::Instant::now();
    assert_eq!(parse(&text, &[]).unwrap_err().count(), 1);
    let faults = parse(&flat, &[]).unwrap_err();
    assert_eq!((faults.list().len(), faults.count()), (100, 100_000));
    let drawn = faults.render(false);
    assert!(
        drawn.ends_with("... and 99900 more faults"),
        "{}",
        &drawn[drawn.len() - 200..]
    );
    assert!(began.elapsed().as_secs() < 30, "{:?}", began.elapsed());
}

#[test]
fn files_that_cannot_be_read_are_told() {
    let folder = tempfile::tempdir().unwrap();
    let message = |path: &Path| Scenario::read(path, &[]).unwrap_err().list()[0].message.clone();
    assert_eq!(message(&folder.path().join("none.toml")), "there is no such file");
    assert_eq!(message(folder.path()), "this is a folder; name the scenario file in it");
    let large = folder.path().join("large.toml");
    std::fs::File::create(&large)
        .unwrap()
        .set_len(MAX_FILE_SIZE + 1)
        .unwrap();
    assert_eq!(message(&large), "the file is larger than 16 MiB");
}

#[test]
fn hostile_texts_are_refused() {
    let deep = [
        format!("a = {}", "[".repeat(100_000)),
        format!("a = {}", "{a=".repeat(100_000)),
        format!("{}a = 1", "a.".repeat(100_000)),
        format!("[{}a]\nb = 1", "a.".repeat(100_000)),
        format!("title = \"{}\"", "x".repeat(1_000_000)),
        format!("title = \"x\"\n{}", "[[stage]]\n".repeat(100_000)),
        format!("[[stage]]\n{}", "x = 1\n".repeat(10_000)),
    ];
    for text in deep {
        assert!(!parse(&text, &[]).unwrap_err().is_empty());
    }
    for set in [
        "",
        "=",
        "a",
        "[0]=1",
        "a..b=1",
        "a[=1",
        "a]=1",
        "\"=1",
        "stage[99999999999999999999]=1",
        "title.x.y=1",
    ] {
        assert!(parse(settle(), &[set]).is_err(), "{set}");
    }
    let path = format!("{}a=1", "a.".repeat(100_000));
    assert!(parse(settle(), &[&path]).is_err());
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    /// Whatever is done to a scenario, it is read or refused with messages that can be drawn.
    #[test]
    fn a_garbled_scenario_never_panics(
        which in 0..TEMPLATES.len(),
        edits in prop::collection::vec((any::<prop::sample::Index>(), 0..6usize, "[ -~é\n]{0,6}"), 1..8),
    ) {
        let mut text: Vec<char> = TEMPLATES[which].2.chars().collect();
        for (at, length, insert) in edits {
            let at = at.index(text.len().max(1)).min(text.len());
            let end = (at + length).min(text.len());
            text.splice(at..end, insert.chars());
        }
        let text: String = text.into_iter().collect();
        if let Err(faults) = parse(&text, &[]) {
            prop_assert!(!faults.render(false).is_empty());
        }
    }

    #[test]
    fn an_override_never_panics(set in "[a-z0-9.\\[\\]=\"é]{0,20}") {
        if let Err(faults) = parse(settle(), &[&set]) {
            prop_assert!(!faults.render(true).is_empty());
        }
    }

    #[test]
    fn a_quantity_never_panics(text in "[0-9a-zA-Z+-.^/()* %°µé]{0,30}") {
        if let Ok(quantity) = units::parse(&text) {
            prop_assert!(quantity.value.is_finite());
        }
    }
}

#[test]
fn motions_that_come_and_go_within_some_steps_are_refused() {
    let told = |motion: &str| {
        let motion = format!("wall.box.motion={{ {motion} }}");
        let scenario = parse(settle(), &["simulation.time_step=1 us", &motion]).unwrap();
        prepare(&scenario).map_or_else(|faults| faults.to_string(), |_| String::new())
    };
    let folder = tempfile::tempdir().unwrap();
    let table = |name: &str, rows: &str| {
        let path = folder.path().join(name);
        std::fs::write(&path, format!("time [us], z [um]\n{rows}")).unwrap();
        format!(
            "table = {{ file = {:?}, at_end = \"repeat\" }}",
            path.display().to_string()
        )
    };
    for (motion, words) in [
        (
            "oscillation = { amplitude = \"0 0 1 nm\", frequency = \"1 MHz\" }",
            "wall `box` oscillates once within 1.0000e-6 s, 1.000 time steps of 1.000e-6 s; at least 20 are needed",
        ),
        (
            "rocking = { point = \"0 0 0 m\", axis = \"y\", amplitude = \"1e-6 deg\", frequency = \"60 kHz\" }",
            "rocks once",
        ),
        (
            "rotation = { point = \"0 0 0 m\", axis = \"z\", angular_velocity = \"4e5 rad/s\" }",
            "turns once",
        ),
        (
            &table("fast.csv", "0, 0\n4, 0.001\n9, 0\n"),
            "goes to and fro by its table within 8",
        ),
    ] {
        let told = told(motion);
        assert!(told.contains(words), "{motion}: {told}");
    }
    for motion in [
        "oscillation = { amplitude = \"0 0 1 nm\", frequency = \"49 kHz\" }",
        "oscillation = { amplitude = \"0 0 0 nm\", frequency = \"1 MHz\" }",
        &table("slow.csv", "0, 0\n12, 0.001\n30, 0\n"),
    ] {
        assert_eq!(told(motion), "", "{motion}");
    }
}

#[test]
fn numbers_without_a_digit_at_a_side_of_the_point_are_written_in_full() {
    for (text, full) in [
        ("x = .5", "0.5"),
        ("x = -.25e3", "-0.25"),
        ("x = 5.", "5.0"),
        ("x = [1, .5]", "0.5"),
    ] {
        let told = parse(text, &[]).unwrap_err().to_string();
        assert!(
            told.contains(&format!("write `{full}`: a point has digits")),
            "{text}: {told}"
        );
    }
    for text in ["x = 1.2.3", "x = .", "x = a.5"] {
        let told = parse(text, &[]).unwrap_err().to_string();
        assert!(
            told.contains("not valid TOML") && !told.contains("write `"),
            "{text}: {told}"
        );
    }
}

#[test]
fn what_is_wrong_with_the_laws_of_many_pairs_is_told_once() {
    let material = |name: &str| {
        format!("material.{name}={{ young_modulus = \"5 MPa\", poisson_ratio = 0.3, density = \"1 g/cm^3\" }}")
    };
    let (clay, sand) = (material("clay"), material("sand"));
    let stray = "contact.normal.impact_speed=\"1 m/s\"";
    let told = |overrides: &[&str]| {
        let faults = parse(settle(), overrides).unwrap_err();
        let messages: Vec<String> = faults.list().iter().map(|fault| fault.message.clone()).collect();
        messages
    };
    let alone = told(&[stray]);
    assert!(
        alone.len() == 1 && alone[0].starts_with("between `glass` and `glass`: "),
        "{alone:?}"
    );
    let of_three = told(&[&clay, &sand, stray]);
    assert_eq!(of_three.len(), 1, "{of_three:?}");
    assert!(
        of_three[0].starts_with("between `glass` and `glass` (and 5 more pairs): "),
        "{of_three:?}"
    );
    // an entry of a pair has a place of its own
    let pair = "contact.pair=[{ between = [\"glass\", \"clay\"], normal = { impact_speed = \"2 m/s\" } }]";
    let with_pair = told(&[&clay, &sand, stray, pair]);
    assert_eq!(with_pair.len(), 2, "{with_pair:?}");
}
