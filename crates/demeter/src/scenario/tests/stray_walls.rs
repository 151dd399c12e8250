use super::super::stray_walls::StrayWalls;
use super::*;
use crate::walls::Wall;

const BOX: &str = r#"
[domain]
lower = "0 0 0 mm"
upper = "20 20 20 mm"
periodic = ["x"]

[[stage]]
name = "first"
duration = "0.1 s"

[[stage]]
name = "second"
duration = "0.1 s"
"#;

fn plate(x: f64, half: f64, z: f64, motion: &str) -> String {
    format!(
        "{BOX}{ONE_GRAIN}\n[[wall]]\nname = \"plate\"\nmaterial = \"glass\"\nshape = \"rectangle\"\ncenter = \"{x} 10 {z} mm\"\n\
         half_u = \"{half} 0 0 mm\"\nhalf_v = \"0 3 0 mm\"\nmotion = {motion}\n"
    )
}

#[test]
fn walls_outside_of_the_domain_and_those_that_will_leave_it_are_told() {
    let told = |x: f64, half: f64, z: f64, motion: &str| {
        let scenario = parse(&plate(x, half, z, motion), &[]).unwrap();
        prepare(&scenario).unwrap().warnings.join("\n")
    };
    let along = |mm_per_s: f64| format!("{{ velocity = \"{mm_per_s} 0 0 mm/s\" }}");
    let up = "{ velocity = \"0 0 100 mm/s\" }";
    for (x, half, z, motion) in [
        (10.0, 3.0, 2.0, "\"rest\"".to_string()),
        // within reach of the grains
        (10.0, 3.0, -0.5, "\"rest\"".to_string()),
        // 15 of 20 mm along the periodic direction
        (10.0, 10.0, 2.0, along(74.0)),
        // it comes in
        (10.0, 3.0, -10.0, up.to_string()),
        (10.0, 3.0, 2.0, "{ velocity = \"0 0 90 mm/s\" }".to_string()),
    ] {
        assert_eq!(told(x, half, z, &motion), "", "{motion}");
    }
    for (x, half, z, motion, words) in [
        (
            10.0,
            3.0,
            -1.5,
            "\"rest\"",
            "wall `plate` lies wholly outside of the domain, from -0.001500 m to -0.001500 m along z",
        ),
        (
            31.5,
            3.0,
            2.0,
            "\"rest\"",
            "along x, where the domain reaches from 0.000000 m to 0.020000 m: no grain feels it there",
        ),
        (10.0, 10.0, 2.0, along(80.0).as_str(), "goes astray: at 1.8"),
        (10.0, 3.0, 2.0, up, "e-1 s it lies wholly outside of the domain"),
    ] {
        let told = told(x, half, z, motion);
        assert!(told.contains(words), "{told}");
    }
    // a condition may end the stage long before
    let scenario = parse(
        &plate(10.0, 3.0, 2.0, up),
        &["stage[0].stop={ kinetic_over_elastic = 1e-3 }"],
    )
    .unwrap();
    assert!(prepare(&scenario).unwrap().warnings.is_empty());
    // of what grains move nothing is foreseen
    let slide = "{ free = { axis = \"z\", mass = \"1 g\", speed = \"1 m/s\" } }";
    assert_eq!(told(10.0, 3.0, 2.0, slide), "");
}

#[test]
fn a_wall_that_leaves_is_told_once_and_again_when_it_left_again() {
    let up_and_down = "{ oscillation = { amplitude = \"0 0 40 mm\", frequency = \"1 Hz\" } }";
    let scenario = parse(&plate(10.0, 3.0, 2.0, up_and_down), &[]).unwrap();
    let setup = prepare(&scenario).unwrap().setup;
    let (mut walls, domain, grains) = (setup.walls, setup.domain, setup.grains);
    let mut stray = StrayWalls::of(&walls, &domain, &grains);
    let mut news = Vec::new();
    for _ in 0..200 {
        walls.iter_mut().for_each(|wall: &mut Wall| wall.advance(0.01));
        news.extend(stray.news(&walls, &domain, &grains));
    }
    assert_eq!(news.len(), 4, "{news:?}");
    assert!(
        news[0].starts_with("warning: wall `plate` lies wholly outside"),
        "{news:?}"
    );
}

/// A body that turns is felt on its side of a periodic box alone; one that slides also across it.
#[test]
fn a_body_that_comes_to_a_periodic_side_is_told() {
    let news = |turns: &str| {
        let body = format!(
            "{{ body = {{ mass = \"1 g\", center_of_mass = \"10 10 2 mm\", inertia = \"1e-9 1e-9 2e-9 kg m^2\", {turns} \
             velocity = \"1 0 0 m/s\", slides = [\"x\"] }} }}"
        );
        let setup = prepare(&parse(&plate(10.0, 3.0, 2.0, &body), &[]).unwrap())
            .unwrap()
            .setup;
        let (mut walls, domain, grains) = (setup.walls, setup.domain, setup.grains);
        let mut stray = StrayWalls::of(&walls, &domain, &grains);
        let mut news = Vec::new();
        // by 8 mm
        for _ in 0..8 {
            walls.iter_mut().for_each(|wall: &mut Wall| wall.advance(1e-3));
            news.extend(stray.news(&walls, &domain, &grains));
        }
        news
    };
    assert_eq!(news("turns = [],"), Vec::<String>::new());
    let told = news("");
    assert!(
        told.len() == 1 && told[0].contains("a grain's radius of the periodic sides along x"),
        "{told:?}"
    );
}
