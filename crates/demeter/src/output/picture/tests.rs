use super::*;
use crate::materials::Material;
use crate::measure::ContactsAt;
use crate::output::{ContactRecord, FramePart, WallSurface};
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

fn contact(id_i: u32, id_j: u32, force: f32) -> ContactRecord {
    ContactRecord {
        id_i,
        id_j,
        wall: -1,
        normal: DVec3::X,
        overlap: 1e-4,
        push: -force,
        ..ContactRecord::default()
    }
}

fn picture(grains: &Grains, contacts: &[ContactRecord], walls: &[WallSurface], colour: ColourBy) -> Image {
    tagged_picture(None, grains, contacts, walls, colour)
}

fn tagged_picture(
    tags: Option<Vec<i32>>,
    grains: &Grains,
    contacts: &[ContactRecord],
    walls: &[WallSurface],
    colour: ColourBy,
) -> Image {
    let frame = Frame {
        step: 3,
        time: 0.25,
        grains,
        materials: &materials(),
        contacts: ContactsAt::List(contacts),
        walls,
        tags,
        cell: None,
        part: FramePart::default(),
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
    let contacts: Vec<ContactRecord> = (1..40).map(|k| contact(k, k + 1, k as f32)).collect();
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
fn grains_are_drawn_by_their_tags() {
    let grains = grains(12);
    let of = |tags: Option<Vec<i32>>| tagged_picture(tags, &grains, &[], &[], ColourBy::Tag);
    let alternating = of(Some((0..12).map(|k| k % 2).collect()));
    assert!(of(None) == of(Some(vec![0; 12])));
    assert!(alternating != of(None) && alternating != of(Some(vec![1; 12])));
    // tags may be any whole numbers
    of(Some([i32::MIN, -1, i32::MAX].repeat(4)));
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
        velocities: Vec::new(),
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
    let image = picture(&grains, &[contact(1, 2, f32::NAN)], &[], ColourBy::Speed);
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

/// Looked at along y: balls at places, with what cuts leave of them, and what is seen of the scene.
fn cut_picture(balls: &[(DVec3, f64)], walls: &[WallSurface], cuts: &[Cut]) -> Image {
    let mut grains = Grains::default();
    for (id, (position, radius)) in (1..).zip(balls) {
        grains.push(
            id,
            &NewGrain {
                fixed: false,
                material: 0,
                radius: *radius,
                density: 1000.0,
                position: *position,
                velocity: DVec3::ZERO,
                angular_velocity: DVec3::ZERO,
            },
        );
    }
    let frame = Frame {
        step: 0,
        time: 0.0,
        grains: &grains,
        materials: &materials(),
        contacts: ContactsAt::List(&[]),
        walls,
        tags: None,
        cell: None,
        part: FramePart::default(),
    };
    let options = PictureOptions {
        colour: ColourBy::Material,
        width: 600,
        height: 600,
        view: View {
            azimuth: -90.0,
            elevation: 0.0,
        },
        region: Some((DVec3::splat(-1.2), DVec3::splat(1.2))),
        cuts: cuts.to_vec(),
        ..PictureOptions::default()
    };
    render_packing(&frame, &options)
}

/// Cuts away what is in front of a plane.
fn front_of(at: f64) -> Cut {
    Cut {
        axis: 1,
        above: false,
        at,
    }
}

#[test]
fn a_cut_sphere_shows_its_section() {
    let ball = [(DVec3::ZERO, 1.0)];
    let whole = drawn(&cut_picture(&ball, &[], &[])) as f64;
    // the disc at 0.6 of the radius has 0.8 of it; the eye is so far away that the region fits into the picture
    let eye = 1.2 / (0.14 * 360.0 / 460.0) + 1.2;
    let disc = |at: f64| (0.8 / (eye + at)).powi(2) * (eye * eye - 1.0);
    let behind = drawn(&cut_picture(&ball, &[], &[front_of(0.6)])) as f64;
    assert!((behind / whole / disc(0.6) - 1.0).abs() < 0.01, "{behind} of {whole}");
    let image = cut_picture(&ball, &[], &[front_of(-0.6)]);
    assert!((drawn(&image) as f64 / whole - 1.0).abs() < 1e-3);
    let area = scene_area(600, 600);
    let middle = (area.top + 0.5 * area.height) as usize * 600 + (area.left + 0.5 * area.width) as usize;
    let uncut = cut_picture(&ball, &[], &[]);
    let section = image.pixels().iter().zip(uncut.pixels()).filter(|(a, b)| a != b);
    let share = section.count() as f64 / whole / disc(-0.6);
    assert!((share - 1.0).abs() < 0.01, "{share}");
    let blue = |image: &Image| image.pixels()[middle][2];
    assert!(blue(&uncut) > blue(&image), "a section is darker");
    assert_eq!(drawn(&cut_picture(&ball, &[], &[front_of(1.01)])), 0);
}

#[test]
fn what_is_cut_away_hides_and_shades_nothing() {
    let rear = (DVec3::new(0.0, 0.8, 0.0), 0.4);
    let front = (DVec3::new(0.1, -0.8, 0.2), 0.35);
    let both = cut_picture(&[rear, front], &[], &[front_of(0.0)]);
    let alone = cut_picture(&[rear], &[], &[]);
    let area = scene_area(600, 600);
    let inside = |k: usize| k / 600 >= area.top as usize && ((k % 600) as f64) < area.left + area.width;
    let differ = (0..360_000).filter(|k| inside(*k) && both.pixels()[*k] != alone.pixels()[*k]);
    assert_eq!(differ.count(), 0);
    // cut by two planes a quarter is left
    let whole = drawn(&cut_picture(&[(DVec3::ZERO, 1.0)], &[], &[])) as f64;
    let cuts = [
        Cut {
            axis: 0,
            above: true,
            at: 0.0,
        },
        Cut {
            axis: 2,
            above: true,
            at: 0.0,
        },
    ];
    let quarter = drawn(&cut_picture(&[(DVec3::ZERO, 1.0)], &[], &cuts)) as f64;
    assert!((quarter / whole - 0.25).abs() < 0.01, "{quarter} of {whole}");
}

#[test]
fn walls_are_cut_like_grains() {
    let corner = |x: f64, z: f64| DVec3::new(x, 0.0, z);
    let (a, b, c, d) = (
        corner(-1.0, -1.0),
        corner(1.0, -1.0),
        corner(1.0, 1.0),
        corner(-1.0, 1.0),
    );
    let wall = || WallSurface {
        name: "pane",
        triangles: vec![[a, b, c], [a, c, d]],
        force: DVec3::ZERO,
        torque: DVec3::ZERO,
        velocities: Vec::new(),
        records: None,
    };
    let whole = drawn(&cut_picture(&[], &[wall()], &[])) as f64;
    let right = Cut {
        axis: 0,
        above: false,
        at: 0.0,
    };
    let half = drawn(&cut_picture(&[], &[wall()], &[right])) as f64;
    // of the rim one side and two halves are left
    assert!((half / whole - 0.5).abs() < 0.02, "{half} of {whole}");
    assert_eq!(drawn(&cut_picture(&[], &[wall()], &[front_of(0.1)])), 0);
}
