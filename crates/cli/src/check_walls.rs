//! What `demeter check` tells of the walls, in words and as JSON.

use crate::answer::Rows;
use crate::readable::{count, number, things, vector};
use demeter::scenario::{MeshOrigin, Prepared, Scenario, WallReport};
use demeter::walls::leak::{LeakReport, Opening, OpeningKind};
use demeter::walls::mesh::{Inspection, Rim};
use serde_json::{Value, json};

/// Most meshes that are told one by one.
const MOST_MESHES: usize = 20;
/// Most pairs of meshes that are told to pass through each other.
const MOST_MEETINGS: usize = 5;
/// Most rims that are told of a mesh.
const MOST_RIMS: usize = 3;

/// Adds what was found as rows.
pub fn add_rows(scenario: &Scenario, prepared: &Prepared, report: &WallReport, rows: &mut Rows) {
    let walls = scenario.walls.iter().zip(&prepared.setup.walls);
    let meshes = prepared.meshes.iter().zip(&report.meshes);
    let told = walls.zip(meshes).filter_map(|((spec, wall), (origin, found))| {
        let (origin, found) = (origin.as_ref()?, found.as_ref()?);
        Some((spec.name.as_str(), wall, origin, found))
    });
    for (index, (name, wall, origin, found)) in told.enumerate() {
        if index == MOST_MESHES {
            rows.add("meshes", "and more; `--json` tells all");
            break;
        }
        let triangles = wall.mesh().map_or(0, |mesh| mesh.triangles().len());
        let mut words = format!("mesh of {}{}", things(triangles as u64, "triangle"), source(origin));
        if let Some((lower, upper)) = wall.bounds() {
            let [x, y, z] = (upper - lower).to_array().map(number);
            words.push_str(&format!("; {x} x {y} x {z} m, from {} m on", vector(lower.to_array())));
        }
        rows.add(format!("wall {name}"), words);
        findings(found, triangles)
            .into_iter()
            .for_each(|words| rows.add("", words));
    }
    for (k, ([a, b], place)) in report.meetings.iter().take(MOST_MEETINGS).enumerate() {
        let words = format!(
            "`{}` passes through `{}` at {}, as they stand at the start, and they move against each other: is a `shift` right?",
            scenario.walls[*a].name,
            scenario.walls[*b].name,
            vector(place.to_array())
        );
        rows.add(if k == 0 { "crossing" } else { "" }, words);
    }
    match &report.leaks {
        Ok(leaks) => leak_words(leaks, report.smallest)
            .into_iter()
            .enumerate()
            .for_each(|(k, words)| {
                rows.add(if k == 0 { "leak test" } else { "" }, words);
            }),
        Err(why) => rows.add("leak test", format!("not made: {why}")),
    }
}

fn source(origin: &MeshOrigin) -> String {
    let Some(source) = &origin.source else {
        return String::new();
    };
    let polygons = match source.polygons {
        0 => String::new(),
        n => format!(", {} cut into triangles", things(n as u64, "face")),
    };
    format!(" ({}; unit: {}{polygons})", source.format.name(), source.unit)
}

/// What is remarkable about a mesh, with what to do.
fn findings(found: &Inspection, triangles: usize) -> Vec<String> {
    let mut lines = Vec::new();
    let (cracks, rims): (Vec<&Rim>, Vec<&Rim>) = found.rims.iter().partition(|rim| rim.is_crack());
    if rims.is_empty() && cracks.is_empty() {
        lines.push("closed, without holes".to_string());
    }
    if let Some(torn) = &found.torn {
        lines.push(format!(
            "{} torn: {}",
            things(torn.edges as u64, "open edge"),
            torn.remedy()
        ));
    }
    // of what is torn throughout, every triangle may be a hole
    if !rims.is_empty() && found.torn.is_none_or(|torn| torn.left > 0) {
        let some: Vec<String> = rims.iter().take(MOST_RIMS).map(|rim| rim_words(rim)).collect();
        let more = if rims.len() > MOST_RIMS { "; ..." } else { "" };
        lines.push(format!("holes or open ends, {}: {}{more}", rims.len(), some.join("; ")));
    }
    if let Some(crack) = cracks.first() {
        lines.push(format!(
            "{} of no width, the longest {} m long at {}: no grain passes; corners lie on edges of neighbours there",
            things(cracks.len() as u64, "crack"),
            number(0.5 * crack.length),
            vector(crack.centre.to_array())
        ));
    }
    if found.crowded_edges.count > 0 {
        lines.push(format!(
            "{} of more than two triangles, the first at {}: harmless where sheets are joined, else a sign of parts that were not \
             united on export",
            things(found.crowded_edges.count as u64, "edge"),
            vector(found.crowded_edges.first.to_array())
        ));
    }
    if found.disagreeing_edges.count > 0 {
        lines.push(format!(
            "{} whose triangles cannot agree on their front, the first at {}: grains do not feel it, a tool that asks for a \
             volume does",
            things(found.disagreeing_edges.count as u64, "edge"),
            vector(found.disagreeing_edges.first.to_array())
        ));
    }
    let crossings = &found.crossings;
    if crossings.count > 0 {
        let remedy = match found.torn {
            Some(_) => "join first what is torn",
            None => "unite the parts in CAD if the surface inside a wall is not meant",
        };
        lines.push(format!(
            "{} of triangles pass through or lie on one another, the first are {} and {} at {}: grains feel both; {remedy}",
            things(crossings.count as u64, "pair"),
            crossings.first[0],
            crossings.first[1],
            vector(crossings.place.to_array())
        ));
    }
    if crossings.looked_at < triangles {
        lines.push(format!(
            "too many triangles lie in one place: only {} were held against the others",
            count(crossings.looked_at as u64)
        ));
    }
    lines
}

fn rim_words(rim: &Rim) -> String {
    format!(
        "{} m around with {} m^2 at {} (triangle {})",
        number(rim.length),
        number(rim.area),
        vector(rim.centre.to_array()),
        rim.triangle
    )
}

fn leak_words(leaks: &LeakReport, smallest: f64) -> Vec<String> {
    let mut lines = Vec::new();
    let grain = format!("a grain of diameter {} m", number(2.0 * leaks.radius));
    let top = if leaks.open_at_top {
        ", and are open at the top"
    } else {
        ""
    };
    let gets_out = |o: &&Opening| o.kind != OpeningKind::OverRim;
    if leaks.is_tight() {
        lines.push(format!("the walls, as they stand at the start, hold {grain}{top}"));
    } else {
        lines.push(format!("{grain} gets out of the walls as they stand at the start:"));
    }
    lines.extend(
        leaks
            .openings
            .iter()
            .filter(gets_out)
            .map(|o| opening_words(o, smallest)),
    );
    let rim = leaks.openings.iter().find(|o| o.kind == OpeningKind::OverRim);
    if let Some(rim) = rim {
        let place = vector(rim.place.to_array());
        lines.push(format!(
            "over a rim at {place}, once grains are heaped that high: open at the top"
        ));
    } else if leaks.open_at_top && !leaks.is_tight() {
        lines.push("upwards: open at the top".to_string());
    }
    if leaks.more {
        lines.push("and there may be more: close these, or take them as meant, and check again".to_string());
    } else if !leaks.is_tight() {
        lines.push(
            "is that an outlet, all is well; else close it, or correct `unit`, `scale`, `shift` of a mesh".to_string(),
        );
    }
    if leaks.radius > smallest {
        lines.push(format!(
            "limit: the smallest grain has {} m, too little against such large walls; narrower openings were not looked for",
            number(2.0 * smallest)
        ));
    }
    lines
}

fn opening_words(opening: &Opening, smallest: f64) -> String {
    // what is nothing against the grain is nothing
    let place = vector(
        opening
            .place
            .to_array()
            .map(|x| if x.abs() < 1e-3 * smallest { 0.0 } else { x }),
    );
    let width = number(opening.width);
    match opening.kind {
        OpeningKind::AboutGrainSize => format!("perhaps at {place}, about {width} m wide: as wide as the grain"),
        _ => format!("at {place}, about {width} m wide"),
    }
}

/// What was found as JSON.
pub fn to_json(scenario: &Scenario, prepared: &Prepared, report: &WallReport) -> Value {
    let meshes = scenario.walls.iter().zip(&prepared.meshes).zip(&report.meshes);
    let meshes: Vec<Value> = meshes
        .filter_map(|((spec, origin), found)| Some(mesh_json(&spec.name, origin.as_ref()?, found.as_ref()?)))
        .collect();
    let leaks = match &report.leaks {
        Err(why) => json!({ "made": false, "why": why.to_string() }),
        Ok(leaks) => json!({
            "made": true,
            "tight": leaks.is_tight(),
            "diameter": 2.0 * leaks.radius,
            "smallest_diameter": 2.0 * report.smallest,
            "open_at_top": leaks.open_at_top,
            "more": leaks.more,
            "openings": leaks.openings.iter().map(|o| json!({
                "kind": match o.kind {
                    OpeningKind::Leak => "leak",
                    OpeningKind::AboutGrainSize => "about the size of the grain",
                    OpeningKind::OverRim => "over a rim",
                },
                "place": o.place.to_array(),
                "width": o.width,
            })).collect::<Vec<_>>(),
        }),
    };
    let name = |wall: usize| scenario.walls[wall].name.as_str();
    let crossings: Vec<Value> = (report.meetings.iter())
        .map(|([a, b], place)| json!({ "walls": [name(*a), name(*b)], "place": place.to_array() }))
        .collect();
    json!({ "meshes": meshes, "crossings": crossings, "leak_test": leaks })
}

fn mesh_json(name: &str, origin: &MeshOrigin, found: &Inspection) -> Value {
    let repair = &origin.repair;
    json!({
        "wall": name,
        "format": origin.source.as_ref().map(|s| s.format.name()),
        "unit": origin.source.as_ref().map(|s| s.unit.as_str()),
        "triangles": origin.triangles,
        "repair": {
            "without_area": repair.flat.count,
            "twice": repair.twice.count,
            "turned": repair.turned,
            "corners_moved": repair.moved,
            "farthest_move": repair.farthest,
            "weld": repair.tolerance,
        },
        "torn": found.torn.map(|torn| json!({ "edges": torn.edges, "left": torn.left, "weld": torn.weld })),
        "rims": found.rims.iter().map(|rim| json!({
            "edges": rim.edges,
            "length": rim.length,
            "area": rim.area,
            "centre": rim.centre.to_array(),
            "triangle": rim.triangle,
            "crack": rim.is_crack(),
        })).collect::<Vec<_>>(),
        "edges_of_more_than_two": found.crowded_edges.count,
        "disagreeing_edges": found.disagreeing_edges.count,
        "crossings": found.crossings.count,
        "first_crossing": (found.crossings.count > 0).then_some(found.crossings.first),
    })
}
