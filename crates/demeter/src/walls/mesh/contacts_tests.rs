//! Contacts found several triangles at a time are those of the rule, told triangle by triangle.

use super::*;
use crate::walls::{Motion, Shape, Wall};
use demeter_physics::geometry::contact_sphere_triangle::Triangle;
use demeter_physics::lanes::{self, Instructions, Kernel, MOST_LANES, Mask, Vector};
use rand_pcg::Pcg64;
use rand_pcg::rand_core::Rng;

type Corners = Vec<[DVec3; 3]>;

fn share(dice: &mut Pcg64) -> f64 {
    (dice.next_u64() >> 11) as f64 * 2f64.powi(-53)
}

fn point(dice: &mut Pcg64, lower: DVec3, upper: DVec3) -> DVec3 {
    lower + (upper - lower) * DVec3::from_array([0; 3].map(|_| share(dice)))
}

/// The shortest way out of all overlaps of a sphere, and which hold it: of all that up to three of them hold, the shortest that is out of
/// the others.
fn way_out(all: &[SurfaceContact], radius: f64) -> (DVec3, Vec<usize>) {
    let depth = |k: usize| radius - all[k].distance;
    let mut best = (DVec3::INFINITY, Vec::new());
    for pick in (1..1_u32 << all.len()).filter(|pick| pick.count_ones() <= 3) {
        let some: Vec<usize> = (0..all.len()).filter(|k| pick >> k & 1 != 0).collect();
        // no more unknowns than three: those that are missing push nothing
        let mut products = glam::DMat3::IDENTITY;
        let mut depths = DVec3::ZERO;
        for (row, &k) in some.iter().enumerate() {
            depths[row] = depth(k);
            for (column, &l) in some.iter().enumerate() {
                products.col_mut(column)[row] = all[k].normal.dot(all[l].normal);
            }
        }
        let pushes = products.inverse() * depths;
        let way: DVec3 = some.iter().enumerate().map(|(n, &k)| pushes[n] * all[k].normal).sum();
        let is_out = (0..all.len()).all(|k| all[k].normal.dot(way) >= depth(k) - 1e-11);
        let is_held = products.determinant() > 1e-11 && pushes.cmpge(DVec3::splat(-1e-12)).all();
        if is_out && is_held && way.length() < best.0.length() - 1e-13 {
            best = (way, some);
        }
    }
    best
}

/// Those groups of contacts as one that others lead from one to the next, where there is a way out of all, with the faces that this leads into.
fn chained(
    mesh: &Mesh,
    (centre, reach): (DVec3, f64),
    mut groups: Vec<Vec<SurfaceContact>>,
    is_one: impl Fn(&SurfaceContact, &SurfaceContact) -> bool,
) -> Vec<Vec<SurfaceContact>> {
    let mut chains: Vec<Vec<Vec<SurfaceContact>>> = Vec::new();
    while let Some(group) = groups.pop() {
        let is_linked = |chain: &mut Vec<Vec<SurfaceContact>>| {
            let mut pairs = chain.iter().flatten().flat_map(|a| group.iter().map(move |b| (a, b)));
            pairs.any(|(a, b)| is_one(a, b))
        };
        let linked: Vec<_> = chains.extract_if(.., is_linked).flatten().collect();
        chains.push([linked, vec![group]].concat());
    }
    let mut out = Vec::new();
    for chain in chains {
        let mut all: Vec<SurfaceContact> = chain.concat();
        let deepest = all.iter().map(|one| reach - one.distance).fold(0.0, f64::max);
        let mut looked = 0.0;
        let is_out = chain.len() == 1
            || loop {
                let length = way_out(&all, reach).0.length();
                if length > 6.0 * deepest {
                    break false;
                }
                if length <= looked {
                    break true;
                }
                looked = 1.25 * length;
                let mut count = 0;
                while count != all.len() {
                    count = all.len();
                    for triangle in 0..mesh.triangles.len() as u32 {
                        let point = contact_sphere_triangle(&mesh.triangles[triangle as usize], centre);
                        let element = mesh.topology.patch(triangle);
                        if point.feature == Feature::Face
                            && (reach..reach + looked).contains(&point.distance)
                            && all.iter().all(|one| one.element != element)
                            && all.iter().any(|one| one.normal.dot(point.normal) > SAME_DIRECTION)
                        {
                            all.push(SurfaceContact {
                                normal: point.normal,
                                distance: point.distance,
                                element,
                                is_at_edge: false,
                            });
                        }
                    }
                }
            };
        match is_out {
            true => out.push(all),
            false => out.extend(chain),
        }
    }
    out
}

/// The rule as it is told in words: every triangle within reach is judged by all triangles that it meets.
fn by_the_rule(mesh: &Mesh, centre: DVec3, reach: f64) -> Vec<SurfaceContact> {
    let closest = |triangle: u32| contact_sphere_triangle(&mesh.triangles[triangle as usize], centre);
    // each with the distance of the point of its triangle, in whose order they are asked
    let mut found: Vec<(f64, SurfaceContact)> = Vec::new();
    for triangle in 0..mesh.triangles.len() as u32 {
        let point = closest(triangle);
        if point.distance >= reach {
            continue;
        }
        let junction = match point.feature {
            Feature::Face => None,
            Feature::Edge(side) => Some(mesh.topology.edge(triangle, side)),
            Feature::Vertex(corner) => Some(mesh.topology.vertex(triangle, corner)),
        };
        let closer = |other: u32| closest(other).distance < point.distance * (1.0 - SAME_DISTANCE);
        let leaders: Vec<u32> = (junction.iter().flat_map(|junction| junction.triangles))
            .copied()
            .filter(|&other| closer(other))
            .collect();
        if !leaders.is_empty() {
            // the plane of the face is met before the sphere stands over it
            let plane = &mesh.triangles[triangle as usize];
            let side = plane.face_point(centre).normal;
            let is_bottom = |&other: &u32| {
                let above = mesh.triangles[other as usize]
                    .corners()
                    .map(|corner| side.dot(corner - plane.corners()[0]));
                let facing = mesh.triangles[other as usize].face_point(centre).normal;
                let bend = facing.dot(side);
                let there = closest(other);
                let is_ahead = there.normal.dot(point.normal) <= SAME_DIRECTION
                    && plane.face_point(centre).distance >= there.distance;
                is_ahead && above.iter().all(|height| *height > -1e-9) && (0.5..=SAME_DIRECTION).contains(&bend)
            };
            let stands_over = |&other: &u32| closest(other).feature == Feature::Face;
            if leaders.iter().any(stands_over) && leaders.iter().all(is_bottom) {
                let contact = SurfaceContact {
                    normal: side,
                    distance: plane.face_point(centre).distance,
                    element: mesh.topology.patch(triangle),
                    is_at_edge: false,
                };
                found.push((point.distance, contact));
            }
            continue;
        }
        let on_face = junction.as_ref().is_none_or(|junction| junction.flat);
        let place = centre - point.distance * point.normal;
        let is_covered = |other: u32| {
            let on_it = contact_sphere_triangle(&mesh.triangles[other as usize], place);
            closer(other) && on_it.distance <= 1e-3 * reach
        };
        if !on_face && (0..mesh.triangles.len() as u32).any(is_covered) {
            continue;
        }
        let surface = if on_face {
            mesh.triangles[triangle as usize].face_point(centre)
        } else {
            point
        };
        let contact = SurfaceContact {
            normal: surface.normal,
            distance: surface.distance,
            element: junction
                .filter(|_| !on_face)
                .map_or(mesh.topology.patch(triangle), |at| at.key),
            is_at_edge: !on_face,
        };
        found.push((point.distance, contact));
    }
    found.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.element.cmp(&b.1.element)));
    let is_one = |a: &SurfaceContact, b: &SurfaceContact| {
        let cosine = a.normal.dot(b.normal);
        let apart = (a.distance * a.normal).distance(b.distance * b.normal);
        match a.is_at_edge || b.is_at_edge {
            true => cosine > WIDEST && apart < (2.0 * (1.0 - SAME_DIRECTION)).sqrt() * reach,
            false => cosine > SAME_DIRECTION,
        }
    };
    let mut groups = Vec::<Vec<SurfaceContact>>::new();
    for (_, contact) in found {
        if groups.iter().flatten().any(|other| other.element == contact.element) {
            continue;
        }
        match groups.iter().position(|group| is_one(&group[0], &contact)) {
            Some(of) => groups[of].push(contact),
            None => groups.push(vec![contact]),
        }
    }
    let mut kept = Vec::new();
    for mut all in chained(mesh, (centre, reach), groups, is_one) {
        let edges: Vec<bool> = all.iter().map(|part| part.is_at_edge).collect();
        let places: Vec<DVec3> = all.iter().map(|part| centre - part.distance * part.normal).collect();
        let (mut way, mut holding) = way_out(&all, reach);
        for _ in 0..8 {
            // edges are seen again from where the way led
            for k in (0..all.len()).filter(|&k| edges[k]) {
                let meets = |t: &&Triangle| contact_sphere_triangle(t, centre).foot.distance(places[k]) < 1e-9 * reach;
                let seen = mesh
                    .triangles
                    .iter()
                    .filter(meets)
                    .map(|t| contact_sphere_triangle(t, centre + way));
                let seen = seen.min_by(|a, b| a.distance.total_cmp(&b.distance)).unwrap();
                all[k].normal = seen.normal;
                all[k].distance = seen.distance - seen.normal.dot(way);
            }
            (way, holding) = way_out(&all, reach);
        }
        kept.push(match all[..] {
            [alone] => alone,
            _ => SurfaceContact {
                normal: way.normalize(),
                distance: reach - way.length(),
                element: holding.into_iter().map(|k| all[k].element).min().unwrap(),
                is_at_edge: false,
            },
        });
    }
    kept.sort_by_key(|contact| contact.element);
    kept
}

/// Finds the contacts among the triangles that are near.
struct Among<'a> {
    wall: &'a Wall,
    near: &'a [u32],
    centre: DVec3,
    reach: f64,
}

impl Kernel for Among<'_> {
    type Output = Vec<SurfaceContact>;

    #[inline(always)]
    fn run<L: Lanes>(self) -> Self::Output {
        let mut points = Vec::new();
        let [x, y, z] = self.centre.to_array();
        let centre = L::Vector::new(L::splat(x), L::splat(y), L::splat(z));
        for first in (0..self.near.len()).step_by(L::COUNT) {
            let mut triangles = [self.near[first]; MOST_LANES];
            let some = &self.near[first..(first + L::COUNT).min(self.near.len())];
            triangles[..some.len()].copy_from_slice(some);
            let found = self.wall.closest_points::<L>(&triangles, centre);
            let is_within = L::splat(self.reach).gt(found.distance).bits();
            let [x, y, z] = found.normal.components();
            let (rows, features) = (L::rows([x, y, z, found.distance]), found.features());
            for (lane, &triangle) in some.iter().enumerate() {
                let [x, y, z, distance] = rows.as_ref()[lane];
                if is_within >> lane & 1 != 0 {
                    points.push(TrianglePoint {
                        triangle,
                        feature: features.of(lane),
                        normal: DVec3::new(x, y, z),
                        distance,
                    });
                }
            }
        }
        let mut contacts = Vec::new();
        let (place, before) = ((self.centre, self.reach), Before::NOTHING);
        self.wall.contacts_of(&mut points, place, &before, &mut contacts);
        contacts
    }
}

fn sheet(cells: usize, height: impl Fn(f64, f64) -> f64) -> Corners {
    let at = |i: usize, j: usize| {
        let (x, y) = (i as f64 / cells as f64, j as f64 / cells as f64);
        DVec3::new(x, y, height(x, y))
    };
    let mut corners = Vec::new();
    for i in 0..cells {
        for j in 0..cells {
            let (a, b, c, d) = (at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
            corners.push([a, b, c]);
            corners.push([a, c, d]);
        }
    }
    corners
}

/// Meshes with seams, and with convex and concave edges and corners.
fn meshes() -> Vec<Corners> {
    let blocks = |x: f64, y: f64| 0.3 * f64::from(x > 0.4) * f64::from(y > 0.55);
    let bumps = |x: f64, y: f64| 0.08 * libm::sin(9.0 * x) * libm::cos(7.0 * y);
    let roof = |x: f64, y: f64| (x - 0.5).abs().min((y - 0.5).abs());
    let mut twice = sheet(3, roof);
    twice.extend(sheet(2, |_, _| 0.0));
    vec![sheet(9, blocks), sheet(8, bumps), sheet(4, roof), twice]
}

fn same(found: &[SurfaceContact], expected: &[SurfaceContact]) -> bool {
    let mut pairs = found.iter().zip(expected);
    found.len() == expected.len()
        && pairs.all(|(a, b)| {
            a.element == b.element && (a.distance - b.distance).abs() < 1e-13 && (a.normal - b.normal).length() < 1e-11
        })
}

#[test]
fn lanes_find_the_contacts_of_the_rule() {
    let mut dice = Pcg64::new(7, 0);
    let turning = Motion::Rotation {
        point: DVec3::new(0.3, 0.1, 0.0),
        axis: DVec3::new(0.0, 0.6, 0.8),
        angular_velocity: 2.0,
    };
    let (mut counts, mut corner_counts) = ([0; 4], 0);
    for corners in meshes() {
        for is_reversed in [false, true] {
            let mut triangles = corners.clone();
            if is_reversed {
                triangles.reverse();
            }
            let mut walls = Vec::new();
            for motion in [Motion::Rest, turning.clone()] {
                let shape = Shape::Mesh {
                    triangles: triangles.clone(),
                };
                let mut wall = Wall::new("wall", 0, shape, motion).unwrap();
                wall.advance(0.2);
                walls.push(wall);
            }
            for _ in 0..2000 {
                let place = point(&mut dice, DVec3::new(-0.1, -0.1, -0.2), DVec3::new(1.1, 1.1, 0.6));
                let reach = 0.05 + 0.15 * share(&mut dice);
                let mesh = walls[0].mesh().unwrap();
                let expected = by_the_rule(mesh, place, reach);
                let mut one_by_one = Vec::new();
                mesh.contacts(place, (reach, 0.0), &mut one_by_one);
                assert!(same(&one_by_one, &expected), "{place}: {one_by_one:?} {expected:?}");
                counts[expected.len().min(3)] += 1;
                let is_on_face = |contact: &SurfaceContact| (contact.element as usize) < triangles.len();
                corner_counts += expected.iter().filter(|contact| !is_on_face(contact)).count();
                for wall in &walls {
                    let centre = wall.carried(place);
                    let mut expected = Vec::new();
                    wall.contacts(centre, (reach, 0.0), &mut expected);
                    // more of them are near than are within reach, and it does not matter which
                    let mut near = Vec::new();
                    wall.parts_near(
                        centre + 0.02 * DVec3::X,
                        reach + 0.02 + 0.1 * share(&mut dice),
                        &mut near,
                    );
                    let mut first = None;
                    for instructions in Instructions::available() {
                        let among = Among {
                            wall,
                            near: &near,
                            centre,
                            reach,
                        };
                        let found = lanes::run(instructions, among);
                        assert!(same(&found, &expected), "{place}: {found:?} {expected:?}");
                        // where the centre needs no turning, to the last bit
                        assert!(
                            found == expected || !wall.is_at_rest(),
                            "{place}: {found:?} {expected:?}"
                        );
                        assert_eq!(&found, first.get_or_insert(found.clone()), "{instructions:?}");
                    }
                }
            }
        }
    }
    assert!(
        counts.iter().all(|&count| count > 30) && corner_counts > 1000,
        "{counts:?} {corner_counts}"
    );
}

#[test]
fn across_a_gap_the_closest_is_the_contact() {
    let side = |x: f64, distance: f64| SurfaceContact {
        normal: DVec3::new(x, 0.0, 1.0).normalize(),
        distance,
        element: 0,
        is_at_edge: false,
    };
    let (closest, other) = (side(0.1, 1.1), side(-0.1, 1.12));
    let join = |closest| joined(closest, std::iter::once(other), (1.0, &mut Vec::new()), |_, _| None);
    assert_eq!(join(closest), closest);
    // where it is overlapped, all are left on the way out
    let way = join(side(0.1, 0.9));
    assert!(way.distance < 1.0 && way.normal.x > 0.0, "{way:?}");
}
