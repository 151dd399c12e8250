//! Laws as a scenario writes them, and as JSON.

use demeter_physics::contact::LawInfo;
use demeter_physics::parameters::{ParameterInfo, ParameterKind, Presence};
use serde_json::{Value, json};

/// A value as the scenario writes it.
pub fn written_value(parameter: &ParameterInfo, value: f64) -> String {
    let number = match value.abs() {
        x if x == 0.0 || (1e-3..1e6).contains(&x) => value.to_string(),
        _ => format!("{value:e}"),
    };
    let unit = parameter.dimension.unit();
    match unit.is_empty() {
        true => number,
        false => format!("\"{number} {unit}\""),
    }
}

/// What a law is called here that other programs and textbooks call by this name, as a sentence.
pub fn called_elsewhere(name: &str) -> Option<String> {
    let plain = name.to_lowercase().replace(['_', ' ', '/'], "-");
    let here = match plain.as_str() {
        "hertz" | "hertzian" => "the normal law `hertz-tsuji`",
        "hertz-mindlin" | "hertz-mindlin-no-slip" | "hertz-history" => {
            "the normal law `hertz-tsuji` with the tangential law `mindlin-history`"
        }
        "hooke" | "hooke-history" | "spring-dashpot" | "linear-spring-dashpot" => {
            "the normal law `linear`, with the tangential law `linear-history` where friction has a spring"
        }
        "mindlin" => "the tangential law `mindlin-history`",
        "cdt" => "the rolling law `constant-torque`",
        _ => return None,
    };
    Some(format!("here that is {here}"))
}

/// A line of a scenario that chooses the law.
pub fn law_example(law: &LawInfo) -> String {
    let shown = law.parameters.iter().filter(|p| p.in_example());
    let given: String = shown
        .map(|p| format!(", {} = {}", p.name, written_value(p, p.typical)))
        .collect();
    format!("{} = {{ law = \"{}\"{given} }}", law_key(law), law.name)
}

/// The family as the scenario writes it.
pub fn law_key(law: &LawInfo) -> String {
    law.family.replace('-', "_")
}

/// All that is known of a law.
pub fn law_to_json(law: &LawInfo) -> Value {
    let finite = |value: f64| value.is_finite().then_some(value);
    let parameter = |p: &ParameterInfo| {
        json!({
            "name": p.name,
            "unit": p.dimension.unit(),
            "quantity": p.dimension.name(),
            "minimum": finite(p.range.lower),
            "minimum_allowed": p.range.lower_allowed,
            "maximum": finite(p.range.upper),
            "maximum_allowed": p.range.upper_allowed,
            "range": p.range.to_string(),
            "default": p.default(),
            "required": p.presence == Presence::Required,
            "may_depend_on_speed": p.kind == ParameterKind::Restitution,
            "choices": match p.kind {
                ParameterKind::Choice(words) => json!(words),
                ParameterKind::Number | ParameterKind::Restitution => Value::Null,
            },
            "typical": p.typical,
            "meaning": p.doc,
        })
    };
    json!({
        "name": law.name,
        "family": law.family,
        "summary": law.summary,
        "doc": law.doc,
        "parameters": law.parameters.iter().map(parameter).collect::<Vec<Value>>(),
        "alternatives": law.alternatives.iter().map(|group| json!({ "of": group.of, "with": group.with }))
            .collect::<Vec<Value>>(),
        "example": law_example(law),
    })
}
