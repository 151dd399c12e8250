use super::*;
use crate::materials::Material;
use crate::output::{ContactRecord, WallSurface};
use crate::particles::{Grains, NewGrain};

fn grains(count: u32) -> Grains {
    let mut grains = Grains::default();
    for id in 1..=count {
        let k = f64::from(id);
        grains.push(
            id,
            &NewGrain {
                fixed: false,
                material: (id % 2) as u16,
                radius: 0.01,
                density: 1000.0,
                position: DVec3::new(0.02 * k, 0.005 * k, 0.01),
                velocity: DVec3::new(0.0, 0.0, 0.1 * k),
                angular_velocity: DVec3::ZERO,
            },
        );
    }
    grains
}

fn materials() -> Vec<Material> {
    ["glass", "a material with a name too long for the legend"]
        .map(|name| Material {
            name: name.to_owned(),
            young_modulus: 1e6,
            poisson_ratio: 0.3,
            density: 1000.0,
        })
        .to_vec()
}

fn contact(id_i: u32, id_j: u32, force: f64) -> ContactRecord {
    ContactRecord {
        id_i,
        id_j,
        wall: -1,
        element: 0,
        position: DVec3::ZERO,
        normal: DVec3::X,
        overlap: 1e-4,
        normal_force: DVec3::new(-force, 0.0, 0.0),
        tangential_force: DVec3::ZERO,
        rolling_torque: DVec3::ZERO,
    }
}

fn picture(grains: &Grains, contacts: &[ContactRecord], walls: &[WallSurface], colour: ColourBy) -> Image {
    let frame = Frame {
        step: 3,
        time: 0.25,
        grains,
        materials: &materials(),
        contacts,
        walls,
        tags: None,
        cell: None,
    };
    let options = PictureOptions {
        title: "Grains in a row ".repeat(9),
        colour,
        width: 600,
        height: 450,
        ..PictureOptions::default()
    };
    render_packing(&frame, &options)
}

/// Number of pixels in the place of the scene that are not white.
fn drawn(image: &Image) -> usize {
    let area = scene_area(image.width(), image.height());
    let inside = |k: usize| {
        let (x, y) = ((k % image.width()) as f64, (k / image.width()) as f64);
        x >= area.left && x < area.left + area.width && y >= area.top && y < area.top + area.height
    };
    let pixels = image.pixels().iter().enumerate();
    pixels.filter(|&(k, pixel)| inside(k) && *pixel != PAPER).count()
}

#[test]
fn the_same_frame_gives_the_same_picture_on_any_number_of_threads() {
    let grains = grains(40);
    let contacts: Vec<ContactRecord> = (1..40).map(|k| contact(k, k + 1, f64::from(k))).collect();
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| picture(&grains, &contacts, &[], ColourBy::ContactForce))
    };
    let image = on(1);
    assert!(image == on(3));
    assert!(drawn(&image) > 2500, "{}", drawn(&image));
}

#[test]
fn every_quantity_can_be_drawn_and_looks_different() {
    let grains = grains(12);
    let contacts = [contact(1, 2, 1.0), contact(2, 3, 3.0), contact(3, 4, 2.0)];
    let kinds = [
        ColourBy::ContactForce,
        ColourBy::Speed,
        ColourBy::Diameter,
        ColourBy::Coordination,
        ColourBy::Material,
    ];
    let images = kinds.map(|colour| picture(&grains, &contacts, &[], colour));
    for (k, image) in images.iter().enumerate() {
        assert!(images[..k].iter().all(|other| other != image), "{:?}", kinds[k]);
    }
    assert!(picture(&grains, &contacts, &[], ColourBy::Automatic) == images[0]);
    assert!(picture(&grains, &[], &[], ColourBy::Automatic) == images[2]);
}

#[test]
fn no_grain_no_wall_is_a_picture_too() {
    let image = picture(&Grains::default(), &[], &[], ColourBy::Automatic);
    assert_eq!((image.width(), image.height()), (600, 450));
    assert_eq!(drawn(&image), 0);
}

#[test]
fn a_wall_alone_is_drawn_as_its_rim() {
    let corner = |x: f64, y: f64| DVec3::new(x, y, 0.0);
    let (a, b, c, d) = (corner(0.0, 0.0), corner(1.0, 0.0), corner(1.0, 1.0), corner(0.0, 1.0));
    let wall = WallSurface {
        name: "floor",
        triangles: vec![[a, b, c], [a, c, d]],
        force: DVec3::ZERO,
        torque: DVec3::ZERO,
        velocity: DVec3::ZERO,
        records: None,
    };
    let count = drawn(&picture(&Grains::default(), &[], &[wall], ColourBy::Automatic));
    assert!((500..6000).contains(&count), "{count}");
}

#[test]
fn a_state_that_blew_up_is_drawn_as_far_as_it_can_be() {
    let mut grains = grains(12);
    grains.position[3] = DVec3::NAN;
    grains.position.set_scalar(4, f64::INFINITY);
    grains.velocity[5] = DVec3::INFINITY;
    let image = picture(&grains, &[contact(1, 2, f64::NAN)], &[], ColourBy::Speed);
    assert!(drawn(&image) > 500);
}

#[test]
fn numbers_are_written_for_people() {
    assert_eq!(grouped(1_234_567), "1,234,567");
    assert_eq!(grouped(514), "514");
    assert_eq!(
        (short(1.25), short(0.0), short(2e-7)),
        ("1.25".into(), "0".into(), "2.000e-7".into())
    );
}
