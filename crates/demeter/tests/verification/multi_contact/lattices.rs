//! Small and regular packings, against the reference.

use super::influence::{MODELS, Model};
use super::reference::Adhesion;
use super::scenes::*;
use crate::cases::{Case, Laws, report};
use demeter::materials::Materials;
use demeter::walls::{Motion, Shape};
use demeter_physics::DVec3;

const POISSON_RATIOS: [f64; 3] = [0.0, 0.3, 0.5];

/// Builds a case for every model and Poisson's ratio, and holds the engine's solution against the reference's.
fn for_all(what: &str, build: impl Fn(Case) -> (Case, Vec<Plane>)) {
    let mut worst = 0.0;
    for model in MODELS {
        for nu in POISSON_RATIOS {
            let (case, planes) = build(case(model, nu));
            worst = f64::max(worst, assert_solved(&started(case), model, &planes));
        }
    }
    report(&format!("forces off the reference, {what}"), worst);
}

/// Adds planes as walls.
fn walled(mut case: Case, planes: Vec<Plane>) -> (Case, Vec<Plane>) {
    for (point, normal) in &planes {
        case.plane(WALLS, *point, *normal);
    }
    (case, planes)
}

#[test]
fn the_reference_gives_the_numbers_of_the_notes() {
    let cubic = [
        0.005_028_314_888_438,
        0.005_532_852_770_098,
        0.006_507_014_915_687,
        0.006_548_552_324_851,
        0.006_823_671_337_114,
    ];
    let face = [
        0.005_028_314_888_438,
        0.006_350_214_654_899,
        0.007_724_501_634_619,
        0.007_819_890_887_979,
        0.008_492_574_020_389,
    ];
    let plates = [
        0.019_876_159_8,
        0.018_011_230_711_8,
        0.023_280_679_544_55,
        0.023_499_437_544_38,
        0.024_068_589_398_26,
    ];
    for (k, model) in MODELS.into_iter().enumerate() {
        // the places are all that is taken from these simulations
        let of = |case: Case, planes: &[Plane]| {
            let sim = case.simulation();
            packing(&sim, model, planes, 0.1, Adhesion::default())
                .solve()
                .unwrap()
                .force
        };
        let sc = of(lattice(case(model, 0.5), 3, DVec3::splat(1.96), &SIMPLE_CUBIC), &[]);
        let edge = DVec3::splat(1.96 * 2f64.sqrt());
        let fcc = of(lattice(case(model, 0.5), 2, edge, &FACE_CENTRED), &[]);
        let mut one = case(model, 0.5);
        one.grain(1.0, DVec3::ZERO, DVec3::ZERO);
        let two = of(one, &[(DVec3::Z * -0.95, DVec3::Z), (DVec3::Z * 0.95, -DVec3::Z)]);
        for (forces, expected) in [(sc, cubic[k]), (fcc, face[k]), (two, plates[k])] {
            for force in forces {
                approx::assert_relative_eq!(force, expected, max_relative = 1e-9);
            }
        }
    }
}

#[test]
fn corrections_of_small_overlaps_fall_with_their_root() {
    // half-space, nu 0.5, face-centred cubic: the figures of the book
    for (overlap, expected) in [(1e-3, 1.054), (1e-2, 1.202)] {
        let force = |model| {
            let edge = DVec3::splat((2.0 - overlap) * 2f64.sqrt());
            let sim = started(lattice(case(model, 0.5), 2, edge, &FACE_CENTRED));
            assert_solved(&sim, model, &[]);
            packing(&sim, model, &[], 0.1, Adhesion::default())
                .solve()
                .unwrap()
                .force[0]
        };
        let ratio = force(MODELS[3]) / force(MODELS[0]);
        report(
            &format!("half-space over independent at an overlap of {overlap} R"),
            ratio,
        );
        assert!((ratio - expected).abs() < 1e-3, "{ratio}");
    }
}

#[test]
fn cubic_lattices_isotropic_and_uniaxial() {
    let uniaxial = |strain: f64| DVec3::new(1.0, 1.0, 1.0 - strain);
    for_all("simple cubic 2 %", |c| {
        (lattice(c, 3, DVec3::splat(1.96), &SIMPLE_CUBIC), vec![])
    });
    for_all("simple cubic, 5 % along z", |c| {
        (lattice(c, 3, 2.000_001 * uniaxial(0.05), &SIMPLE_CUBIC), vec![])
    });
    let face = 2.0 * 2f64.sqrt();
    for_all("face-centred 2 %", |c| {
        (lattice(c, 2, DVec3::splat(0.98 * face), &FACE_CENTRED), vec![])
    });
    for_all("face-centred, 6 % along z", |c| {
        (lattice(c, 2, 1.000_01 * face * uniaxial(0.06), &FACE_CENTRED), vec![])
    });
    let body = 4.0 / 3f64.sqrt();
    for_all("body-centred 3 %", |c| {
        (lattice(c, 3, DVec3::splat(0.97 * body), &BODY_CENTRED), vec![])
    });
    for_all("body-centred, 8 % along z", |c| {
        (lattice(c, 3, body * uniaxial(0.08), &BODY_CENTRED), vec![])
    });
}

#[test]
fn lattices_of_two_sizes() {
    // caesium chloride: eight contacts along the diagonals, and the large grains nearly touch
    let caesium = [([0.0; 3], 1.0), ([0.5; 3], 0.75)];
    let edge = 2.0 * 1.75 / 3f64.sqrt();
    for_all("caesium chloride 3 %", |c| {
        (lattice(c, 3, DVec3::splat(0.97 * edge), &caesium), vec![])
    });
    // rock salt
    let salt: Vec<([f64; 3], f64)> = (0..8u8)
        .map(|k| {
            let place = [k & 1, k >> 1 & 1, k >> 2].map(|b| 0.5 * f64::from(b));
            (place, if k.count_ones() % 2 == 0 { 1.0 } else { 0.55 })
        })
        .collect();
    for_all("rock salt 3 %", |c| {
        (lattice(c, 2, DVec3::splat(0.97 * 3.1), &salt), vec![])
    });
}

#[test]
fn chains_between_plates() {
    let ends = |bottom: f64, top: f64| vec![(DVec3::Z * bottom, DVec3::Z), (DVec3::Z * top, -DVec3::Z)];
    for_all("two plates 10 %", |mut c| {
        c.grain(1.0, DVec3::ZERO, DVec3::ZERO);
        walled(c, ends(-0.9, 0.9))
    });
    for_all("big, small, big", |mut c| {
        for (radius, z) in [(1.0, 0.0), (0.4, 1.36), (1.0, 2.71)] {
            c.grain(radius, DVec3::Z * z, DVec3::ZERO);
        }
        walled(c, ends(-0.96, 3.66))
    });
    for_all("a bent chain between a floor and tilted walls", |mut c| {
        let places = [
            (1.0, DVec3::ZERO),
            (0.6, DVec3::new(0.9, 0.2, 1.25)),
            (0.8, DVec3::new(0.4, 0.9, 2.4)),
        ];
        for (radius, at) in places {
            c.grain(radius, at, DVec3::ZERO);
        }
        let tilted = DVec3::new(0.2, 0.1, -1.0).normalize();
        let side = DVec3::new(-0.9, 0.1, 0.3).normalize();
        let planes = vec![
            (DVec3::Z * -0.95, DVec3::Z),
            (places[2].1 - 0.75 * tilted, tilted),
            (places[1].1 - 0.57 * side, side),
        ];
        walled(c, planes)
    });
}

#[test]
fn two_materials_in_one_chain() {
    for model in MODELS {
        for (nu, other_nu) in [(0.5, 0.0), (0.2, 0.45), (0.0, 0.3)] {
            let mut case = case_of(materials(model, (1.0, nu), (3.0, other_nu), &Laws::hertz(1.0)));
            for (material, radius, z) in [(0, 1.0, 0.0), (2, 0.7, 1.65), (0, 0.9, 3.2)] {
                add(&mut case, material, radius, DVec3::new(0.05 * z, 0.0, z));
            }
            let planes = vec![
                (DVec3::Z * -0.96, DVec3::Z),
                (DVec3::Z * 4.04, -DVec3::Z),
                (DVec3::X * -0.97, DVec3::X),
            ];
            let (case, planes) = walled(case, planes);
            assert_solved(&started(case), model, &planes);
        }
    }
}

/// Two triangles that make a rectangle.
fn rectangle(corner: DVec3, u: DVec3, v: DVec3) -> [[DVec3; 3]; 2] {
    [
        [corner, corner + u, corner + u + v],
        [corner, corner + u + v, corner + v],
    ]
}

#[test]
fn on_meshes() {
    let top = (DVec3::new(0.1, 0.2, 1.9), DVec3::new(0.1, 0.0, -1.0).normalize());
    for_all("a triangle and a tilted plane", |mut c| {
        c.grain(1.0, DVec3::new(0.1, 0.2, 0.94), DVec3::ZERO);
        let triangles = vec![[
            DVec3::new(-9.0, -8.0, 0.0),
            DVec3::new(9.0, -7.0, 0.0),
            DVec3::new(1.0, 9.0, 0.0),
        ]];
        c.wall(WALLS, Shape::Mesh { triangles }, Motion::Rest);
        c.plane(WALLS, top.0, top.1);
        (c, vec![(DVec3::ZERO, DVec3::Z), top])
    });
    let lid = (DVec3::splat(0.96 + 0.95 / 3f64.sqrt()), DVec3::splat(-1.0).normalize());
    for_all("a corner of three faces of a mesh", |mut c| {
        c.grain(1.0, DVec3::new(0.97, 0.96, 0.95), DVec3::ZERO);
        let (x, y, z) = (DVec3::X * 5.0, DVec3::Y * 5.0, DVec3::Z * 5.0);
        let faces = [(x, y), (y, z), (z, x)];
        let triangles = faces
            .into_iter()
            .flat_map(|(u, v)| rectangle(DVec3::ZERO, u, v))
            .collect();
        c.wall(WALLS, Shape::Mesh { triangles }, Motion::Rest);
        c.plane(WALLS, lid.0, lid.1);
        (
            c,
            vec![
                (DVec3::ZERO, DVec3::X),
                (DVec3::ZERO, DVec3::Y),
                (DVec3::ZERO, DVec3::Z),
                lid,
            ],
        )
    });
}

#[test]
fn a_grain_between_six_walls() {
    for_all("six walls 5 %", |mut c| {
        c.grain(1.0, DVec3::ZERO, DVec3::ZERO);
        let normals = [DVec3::X, DVec3::Y, DVec3::Z, -DVec3::X, -DVec3::Y, -DVec3::Z];
        walled(c, normals.into_iter().map(|n| (n * -0.95, n)).collect())
    });
    // in a box that is not a cube all contacts differ
    for_all("six walls, 3 to 7 %", |mut c| {
        c.grain(1.0, DVec3::new(0.0, 0.01, -0.02), DVec3::ZERO);
        let normals = [DVec3::X, DVec3::Y * 0.98, DVec3::Z * 0.97];
        let both = normals.into_iter().flat_map(|n| [n, -n]);
        walled(c, both.map(|n| (n * -0.95, n.normalize())).collect())
    });
}

#[test]
fn every_pair_of_materials_has_its_own_model() {
    let models = [
        Model::HalfSpace(1.2),
        Model::SphereToSphere,
        Model::Independent,
        Model::PointOnSphere,
    ];
    for turn in 0..4 {
        let of = |a: u16, b: u16| models[(turn + usize::from(a + b)) % 4];
        let same = Laws::hertz(1.0);
        let list = materials(Model::Independent, (1.0, 0.3), (2.0, 0.45), &same)
            .list()
            .to_vec();
        let materials = Materials::new(list, |a, b| {
            let mut laws = same.clone();
            laws.0.multi_contact = Some(multi_contact(of(a as u16, b as u16)));
            laws.0
        });
        let mut case = case_of(materials.unwrap());
        for (material, radius, z) in [(0, 1.0, 0.0), (2, 0.7, 1.64), (0, 0.9, 3.2), (0, 0.8, 4.85)] {
            add(&mut case, material, radius, DVec3::new(0.02 * z, 0.0, z));
        }
        let planes = vec![
            (DVec3::Z * -0.96, DVec3::Z),
            (DVec3::Z * 5.6, -DVec3::Z),
            (DVec3::X * -0.82, DVec3::X),
        ];
        let (case, planes) = walled(case, planes);
        let sim = started(case);
        let mut packing = packing(&sim, Model::Independent, &planes, 0.2, Adhesion::default());
        let material = |g: usize| sim.grains().material[g];
        for touch in &mut packing.touches {
            touch.model = of(material(touch.first), touch.second.map_or(WALLS, material));
        }
        assert_solves(&sim, &packing);
    }
}
