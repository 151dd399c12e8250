//! `demeter laws`.

use crate::answer::{Rows, answer, answer_json};
use crate::arguments::LawsArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::suggestion::did_you_mean;
use demeter::materials::{called_elsewhere, law_example, law_to_json, written_value};
use demeter_physics::contact::{LawInfo, laws as all_laws};
use demeter_physics::parameters::{ParameterInfo, ParameterKind, Presence};
use serde_json::{Value, json};

/// Lists the laws, or explains one.
pub fn laws(arguments: &LawsArguments) -> Result<Exit, Failure> {
    let Some(name) = &arguments.name else {
        if arguments.json {
            answer_json(&json!({ "laws": all_laws().map(law_to_json).collect::<Vec<Value>>() }))?;
        } else {
            answer(&list())?;
        }
        return Ok(Exit::Finished);
    };
    let found: Vec<&LawInfo> = all_laws().filter(|law| law.name == name).collect();
    if found.is_empty() {
        let hint = match called_elsewhere(name) {
            Some(here) => format!(": {here}."),
            None => format!(".{}", did_you_mean(name, all_laws().map(|law| law.name))),
        };
        let message = format!("there is no law `{name}`{hint} `demeter laws` lists all.");
        return Err(Failure::wrong(message));
    }
    if arguments.json {
        answer_json(&json!({ "laws": found.into_iter().map(law_to_json).collect::<Vec<Value>>() }))?;
    } else {
        let texts: Vec<String> = found.into_iter().map(explain).collect();
        answer(&texts.join("\n"))?;
    }
    Ok(Exit::Finished)
}

fn list() -> String {
    let mut text = String::new();
    let mut families: Vec<&str> = all_laws().map(|law| law.family).collect();
    families.dedup();
    for family in families {
        let mut rows = Rows::default();
        for law in all_laws().filter(|law| law.family == family) {
            rows.add(law.name, law.summary);
        }
        text.push_str(&format!("{family}\n{}\n", rows.lines()));
    }
    text.push_str("`demeter laws NAME` explains one.\n");
    text
}

fn explain(law: &LawInfo) -> String {
    let mut rows = Rows::default();
    for parameter in law.parameters {
        rows.add(parameter.name, format!("{}: {}", parameter.doc, allowed(parameter)));
    }
    let parameters = if law.parameters.is_empty() {
        "  none\n".to_string()
    } else {
        rows.lines()
    };
    format!(
        "{}: {} ({} law)\n\n{}\n\nParameters\n{parameters}\nExample\n  [contact]\n  {}\n",
        law.name,
        law.summary,
        law.family,
        law.doc.trim(),
        law_example(law)
    )
}

/// What a parameter may be, and what stands in for it.
fn allowed(parameter: &ParameterInfo) -> String {
    if let ParameterKind::Choice(words) = parameter.kind {
        let words: Vec<String> = words.iter().map(|w| format!("\"{w}\"")).collect();
        return format!("{}; the first when not given", words.join(" or "));
    }
    let unit = parameter.dimension.unit();
    let kind = if parameter.kind == ParameterKind::Restitution {
        "a number, rows [speed, restitution], or a formula in v".to_string()
    } else if unit.is_empty() {
        "pure number".to_string()
    } else {
        format!("in {unit}")
    };
    let typical = written_value(parameter, parameter.typical);
    let stand_in = match parameter.presence {
        Presence::Required => format!("must be given, typically {typical}"),
        Presence::Usual => format!("the usual one of several alternatives, typically {typical}"),
        Presence::Optional => format!("may be given, typically {typical}"),
        Presence::Default(_) => format!("{typical} when not given"),
    };
    format!("{kind}, {}; {stand_in}", parameter.range)
}

#[cfg(test)]
mod tests {
    use super::*;
    use demeter::materials::law_key;
    use demeter::scenario::{Scenario, template};
    use std::path::Path;

    /// Every example line, put into a scenario, is accepted by the reader and builds the law.
    #[test]
    fn every_example_runs() {
        let text = template("settle").unwrap();
        for law in all_laws() {
            let start = format!("{} = {{ law", law_key(law));
            let mut replaced: Vec<String> = (text.lines())
                .filter(|line| !line.starts_with(&start))
                .map(str::to_string)
                .collect();
            let contact = replaced.iter().position(|line| line == "[contact]").unwrap();
            replaced.insert(contact + 1, law_example(law));
            let replaced = replaced.join("\n");
            let scenario = match Scenario::parse(&replaced, law.name, Path::new(""), &["grains[0].count=1".to_string()])
            {
                Ok(scenario) => scenario,
                Err(faults) => panic!("{}", faults.render(false)),
            };
            if let Err(faults) = demeter::scenario::prepare(&scenario) {
                panic!("{}", faults.render(false));
            }
        }
    }

    #[test]
    fn the_explanation_names_every_parameter() {
        for law in all_laws() {
            let text = explain(law);
            for parameter in law.parameters {
                assert!(text.contains(parameter.name) && text.contains(parameter.doc), "{text}");
            }
        }
    }
}
