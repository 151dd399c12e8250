//! The schemas against the files of the project, by a validator that is not ours.

use super::*;
use crate::scenario::{Scenario, TEMPLATES};
use jsonschema::Validator;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

fn project() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// The validator of a kind of file, which takes longer to make than to read most files.
fn validator(of: FileKind) -> &'static Validator {
    static MADE: [OnceLock<Validator>; FileKind::ALL.len()] = [const { OnceLock::new() }; FileKind::ALL.len()];
    let index = FileKind::ALL.iter().position(|kind| *kind == of).unwrap();
    MADE[index].get_or_init(|| jsonschema::draft7::new(&schema(of)).unwrap())
}

fn read(path: &Path) -> Value {
    toml::from_str(&std::fs::read_to_string(path).unwrap()).unwrap()
}

/// What kind of file a tree is.
fn kind(tree: &Value) -> FileKind {
    let has = |key: &str| tree.get(key).is_some();
    match () {
        () if has("packing") => FileKind::PackingFit,
        () if has("fit") => FileKind::Fit,
        () if has("a") => FileKind::TwoBodies,
        () => FileKind::Scenario,
    }
}

fn toml_files(folder: &Path, found: &mut Vec<PathBuf>) {
    for path in std::fs::read_dir(folder).unwrap().map(|f| f.unwrap().path()) {
        if path.is_dir() {
            toml_files(&path, found);
        } else if path.extension().is_some_and(|e| e == "toml")
            && !["Cargo.toml", "instructions.toml"]
                .iter()
                .any(|other| path.ends_with(other))
        {
            found.push(path);
        }
    }
}

/// All files of the project that its readers accept.
fn good_files() -> Vec<(String, Value)> {
    let mut paths = Vec::new();
    for folder in ["scenarios/good", "examples", "validation", "benches"] {
        toml_files(&project().join(folder), &mut paths);
    }
    let files = paths.iter().map(|path| (path.display().to_string(), read(path)));
    let templates = TEMPLATES
        .iter()
        .map(|(name, _, text)| (format!("template {name}"), toml::from_str(text).unwrap()));
    files.chain(templates).collect()
}

/// Paths of all values in a tree, as JSON pointers.
fn pointers(tree: &Value, at: &str, found: &mut Vec<String>) {
    found.push(at.to_string());
    match tree {
        Value::Object(fields) => {
            for (key, value) in fields {
                let key = key.replace('~', "~0").replace('/', "~1");
                pointers(value, &format!("{at}/{key}"), found);
            }
        }
        Value::Array(items) => {
            for (index, value) in items.iter().enumerate() {
                pointers(value, &format!("{at}/{index}"), found);
            }
        }
        _ => {}
    }
}

#[test]
fn the_schemas_are_schemas_without_holes() {
    for of in FileKind::ALL {
        let schema = schema(of);
        assert!(jsonschema::draft7::meta::is_valid(&schema), "{of:?}");
        for section in of.sections() {
            for row in &section.rows {
                for form in &row.value {
                    assert!(
                        !format!("{form:?}").contains("Unreadable"),
                        "{}.{}: {form:?}",
                        section.name,
                        row.key
                    );
                }
            }
        }
    }
}

#[test]
fn every_good_file_is_valid() {
    let files = good_files();
    assert!(files.len() > 40, "only {} files were found", files.len());
    for (name, tree) in files {
        let validator = validator(kind(&tree));
        let faults: Vec<String> = validator
            .iter_errors(&tree)
            .map(|e| format!("{}: {e}", e.instance_path()))
            .collect();
        assert!(faults.is_empty(), "{name}: {}", faults.join("\n"));
    }
}

/// Every table refuses a key that it does not know; every value one of another type.
#[test]
fn unknown_keys_and_wrong_types_are_refused() {
    for (name, tree) in good_files() {
        let validator = validator(kind(&tree));
        let mut places = Vec::new();
        pointers(&tree, "", &mut places);
        // long lists of grains hold the same again and again
        for place in places.iter().take(3000) {
            let mut changed = tree.clone();
            let value = changed.pointer_mut(place).unwrap();
            match value {
                Value::Object(fields) => {
                    fields.insert("of_no_meaning".to_string(), json!(1));
                }
                Value::Bool(_) | Value::Number(_) => *value = json!({ "of": "no meaning" }),
                _ => *value = json!(true),
            }
            assert!(
                !validator.is_valid(&changed),
                "{name}: {place} = {:?}",
                changed.pointer(place)
            );
        }
    }
}

/// A key that the schema misses is one that the reader misses, too.
#[test]
fn a_missing_key_is_missed_by_both() {
    let validator = validator(FileKind::Scenario);
    let base = project().join("scenarios/good");
    let mut missed = 0;
    for (name, tree) in good_files()
        .into_iter()
        .filter(|(name, _)| name.contains("scenarios/good"))
    {
        let mut places = Vec::new();
        pointers(&tree, "", &mut places);
        for place in places.iter().filter(|place| !place.is_empty()).take(1000) {
            let (above, key) = place.rsplit_once('/').unwrap();
            let mut changed = tree.clone();
            let Some(Value::Object(fields)) = changed.pointer_mut(above) else {
                continue;
            };
            fields.remove(key);
            if validator.is_valid(&changed) {
                continue;
            }
            missed += 1;
            let text = toml::to_string(&changed).unwrap();
            let read = Scenario::parse(&text, "case.toml", &base, &[]);
            assert!(read.is_err(), "{name}: the schema misses {place}, the reader does not");
        }
    }
    assert!(missed > 300, "only {missed} missing keys were told");
}

/// The first lines of a bad scenario tell what is wrong with it. Unknown keys, types and words are for the schema to see.
#[test]
fn bad_scenarios_are_refused_as_far_as_a_schema_can() {
    let validator = validator(FileKind::Scenario);
    let mut paths = Vec::new();
    toml_files(&project().join("scenarios/bad"), &mut paths);
    let mut refused = 0;
    for path in paths {
        let Ok(text) = std::fs::read_to_string(&path) else {
            continue;
        };
        let Ok(tree) = toml::from_str::<Value>(&text) else {
            continue;
        };
        // keys of an override
        if text.contains("# set: ") {
            continue;
        }
        let told = text
            .lines()
            .take_while(|line| line.starts_with('#'))
            .collect::<String>();
        let for_schemas = [
            "unknown key",
            "unknown value",
            " must be a text",
            "must be a number, found",
            "with a unit, found",
        ];
        let is_refused = !validator.is_valid(&tree);
        refused += usize::from(is_refused);
        if for_schemas.iter().any(|words| told.contains(words)) {
            assert!(is_refused, "{}: {told}", path.display());
        }
    }
    assert!(refused > 60, "only {refused} were refused");
}

#[test]
fn quantities_are_checked_for_their_units() {
    let validator = validator(FileKind::Scenario);
    let with = |pointer: &str, value: Value| {
        let mut tree = read(&project().join("scenarios/good/every_motion.toml"));
        *tree.pointer_mut(pointer).unwrap() = value;
        validator.is_valid(&tree)
    };
    let name =
        toml::from_str::<Value>(&std::fs::read_to_string(project().join("scenarios/good/every_motion.toml")).unwrap())
            .unwrap()["material"]
            .as_object()
            .unwrap()
            .keys()
            .next()
            .unwrap()
            .clone();
    let density = format!("/material/{name}/density");
    let modulus = format!("/material/{name}/young_modulus");
    for good in [
        "2500 kg/m^3",
        "2.5 g/cm^3",
        "1e3kg/m³",
        "+2.5 t/m^3",
        "2.5 g cm^-3",
        "2 lb/(ft in^2)",
        "2.5 kg m^-1.5/m^1.5",
    ] {
        assert!(with(&density, json!(good)), "{good}");
    }
    for bad in ["2500", "2500 kg", "2500 kg/", "2500 kq/m^3", "m 5", ""] {
        assert!(!with(&density, json!(bad)), "{bad}");
    }
    for good in ["5 MPa", "5e6 Pa", "5 N/mm^2", "700 psi", "1 kbar", "5e6 J/m^3"] {
        assert!(with(&modulus, json!(good)), "{good}");
    }
    for bad in ["5 mm", "5 s", "5 MPA", "5"] {
        assert!(!with(&modulus, json!(bad)), "{bad}");
    }
    assert!(!with(&modulus, json!(5e6)));
}

/// Numbers from a row that is the same in every run.
struct Row(u64);

impl Row {
    fn below(&mut self, limit: usize) -> usize {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % limit.max(1)
    }
}

/// The good scenarios in their folder, with what the reader says to a changed one.
fn good_scenarios() -> Vec<(String, Value)> {
    let all = good_files().into_iter();
    all.filter(|(name, tree)| name.contains("scenarios/good") && kind(tree) == FileKind::Scenario)
        .collect()
}

fn parse(tree: &Value) -> Result<Scenario, String> {
    let base = project().join("scenarios/good");
    let text = toml::to_string(tree).map_err(|error| error.to_string())?;
    Scenario::parse(&text, "case.toml", &base, &[]).map_err(|faults| faults.to_string())
}

/// The paths of all texts that are quantities, with their values in SI.
fn quantities_in(tree: &Value) -> Vec<(String, Value)> {
    let mut places = Vec::new();
    pointers(tree, "", &mut places);
    let number = |text: &str| {
        let read = crate::scenario::units::parse(text).ok()?;
        read.has_unit.then_some(read.value)
    };
    let quantity = |place: &String| {
        let text = tree.pointer(place)?.as_str()?;
        let words: Vec<&str> = text.split_whitespace().collect();
        let is_vector = words.len() > 3 && words[..3].iter().all(|word| word.parse::<f64>().is_ok());
        let value = if is_vector {
            let unit = words[3..].join(" ");
            json!([0, 1, 2].map(|k| number(&format!("{} {unit}", words[k]))))
        } else {
            json!(number(text)?)
        };
        Some((place.clone(), value))
    };
    places.iter().filter_map(quantity).collect()
}

/// A plain number in place of every quantity, one at a time: both refuse it without `plain_numbers`, and both take it with.
#[test]
fn plain_numbers_are_taken_where_the_file_says_so() {
    let validator = validator(FileKind::Scenario);
    let (mut refused, mut taken) = (0, 0);
    for (name, tree) in good_scenarios() {
        for (place, value) in quantities_in(&tree) {
            let mut changed = tree.clone();
            *changed.pointer_mut(&place).unwrap() = value.clone();
            let without = parse(&changed);
            if without.as_ref().is_err_and(|faults| faults.contains("with a unit")) {
                refused += 1;
                // what a column holds no schema knows
                let is_known = !place.contains("/stop/column/");
                assert!(
                    !is_known || !validator.is_valid(&changed),
                    "{name}: {place} = {value} has no unit"
                );
            }
            assert!(
                without.is_err() || validator.is_valid(&changed),
                "{name}: {place} = {value}"
            );
            changed["plain_numbers"] = json!("SI");
            let faults: Vec<String> = validator.iter_errors(&changed).map(|e| e.to_string()).collect();
            assert!(faults.is_empty(), "{name}: {place} = {value}: {}", faults.join("\n"));
            taken += usize::from(parse(&changed).is_ok());
        }
        let mut all = tree.clone();
        for (place, value) in quantities_in(&tree) {
            *all.pointer_mut(&place).unwrap() = value;
        }
        all["plain_numbers"] = json!("SI");
        let faults: Vec<String> = validator.iter_errors(&all).map(|e| e.to_string()).collect();
        assert!(faults.is_empty(), "{name}: {}", faults.join("\n"));
    }
    assert!(refused > 400 && taken > 400, "only {refused} refused, {taken} taken");
}

/// Parts of the other files, put in place of others: what the reader takes, the schema takes, too.
#[test]
fn no_scenario_is_refused_that_the_reader_takes() {
    let validator = validator(FileKind::Scenario);
    let mut row = Row(7);
    let (mut taken, mut refused) = (0, 0);
    let good = good_scenarios();
    let parts: Vec<Value> = good
        .iter()
        .flat_map(|(_, tree)| {
            let mut places = Vec::new();
            pointers(tree, "", &mut places);
            places.into_iter().filter_map(|place| tree.pointer(&place).cloned())
        })
        .filter(|part| part.to_string().len() < 300)
        .collect();
    for (name, tree) in &good {
        let mut places = Vec::new();
        pointers(tree, "", &mut places);
        for _ in 0..150 {
            let place = &places[row.below(places.len())];
            let mut changed = tree.clone();
            let Some(value) = changed.pointer_mut(place).filter(|_| !place.is_empty()) else {
                continue;
            };
            let numbers = [0.0, 1.0, 0.5, -2.0];
            match (value, row.below(3)) {
                (value, 0) => *value = parts[row.below(parts.len())].clone(),
                (Value::Array(items), _) if !items.is_empty() => {
                    let item = items[row.below(items.len())].clone();
                    items.push(item);
                }
                (value, _) => *value = json!(numbers[row.below(numbers.len())]),
            }
            if row.below(4) == 0 {
                changed["plain_numbers"] = json!("SI");
            }
            if parse(&changed).is_err() {
                refused += 1;
                continue;
            }
            taken += 1;
            let faults: Vec<String> = validator.iter_errors(&changed).map(|e| e.to_string()).collect();
            assert!(faults.is_empty(), "{name}: {place}: {}", faults.join("\n"));
        }
    }
    assert!(taken > 150 && refused > 1000, "{taken} were taken, {refused} refused");
}

#[test]
fn a_stage_that_holds_stages_has_no_keys_of_its_own() {
    let validator = validator(FileKind::Scenario);
    let mut tree = read(&project().join("scenarios/good/every_motion.toml"));
    let ends = json!({ "duration": "1 ms" });
    let section = FileKind::Scenario
        .sections()
        .into_iter()
        .find(|s| s.name == "stage[]")
        .unwrap();
    for row in &section.rows {
        tree["stage"] = json!([{ "stage": [ends] }]);
        assert!(validator.is_valid(&tree) && parse(&tree).is_ok());
        let value = match row.key.as_str() {
            "name" => json!("both"),
            "repeat" => json!(2),
            "stage" => continue,
            "duration" => json!("1 s"),
            "steps" => json!(5),
            "absent" | "feeds" | "removals" => json!([]),
            _ => json!({}),
        };
        tree["stage"][0][&row.key] = value;
        let is_taken = ["name", "repeat"].contains(&row.key.as_str());
        assert_eq!(validator.is_valid(&tree), is_taken, "{}", row.key);
        assert_eq!(parse(&tree).is_ok(), is_taken, "{}", row.key);
    }
}
