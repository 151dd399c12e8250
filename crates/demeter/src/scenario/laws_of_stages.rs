//! Contact laws that stages tell in place of those of `[contact]`.

use super::{ContactSpec, Diagnostics, Scenario};
use crate::contacts::laws::memories;
use crate::materials::Materials;
use demeter_physics::contact::LawError;

/// Laws bound to the materials, and where they were told.
pub(super) struct Bound<'s> {
    pub spec: &'s ContactSpec,
    pub materials: Materials,
}

/// The laws of all stages; those that the run begins with come first. Nothing, with a fault, where some cannot be.
pub(super) fn bind<'s>(scenario: &'s Scenario, faults: &mut Diagnostics) -> Option<Vec<Bound<'s>>> {
    let bind = |spec| materials(scenario, spec, faults).map(|materials| Bound { spec, materials });
    scenario.contacts().into_iter().map(bind).collect()
}

/// Materials with such laws; nothing, with a fault, where they cannot be.
pub(super) fn materials(scenario: &Scenario, spec: &ContactSpec, faults: &mut Diagnostics) -> Option<Materials> {
    match Materials::new(scenario.materials.clone(), |a, b| spec.choice(a, b)) {
        Ok(materials) => Some(materials.for_many_sizes()),
        Err(error) => {
            let help = match &error {
                LawError::Unknown { .. } => Some("`demeter laws` lists all laws".to_string()),
                LawError::Material { .. } => None,
                LawError::Parameters { law, .. } => Some(format!("`demeter laws {law}` tells its parameters")),
            };
            faults.push(spec.table(), error.to_string(), help);
            None
        }
    }
}

/// Two materials whose contacts would remember something else than before, and the names of what they would and did.
pub(super) struct OtherMemory {
    pub pair: String,
    pub is: String,
    pub was: String,
}

/// The first pair whose laws remember something else than those of the same pair did.
pub(super) fn other_memory(is: &Materials, was: &Materials) -> Option<OtherMemory> {
    let materials = is.list();
    let count = materials.len() as u16;
    let mut pairs = (0..count).flat_map(|a| (a..count).map(move |b| (a, b)));
    pairs.find_map(|(a, b)| {
        let pair = is.pair(a, b);
        let (is, was) = (memories(is.law(pair)), memories(was.law(pair)));
        let [one, other] = [a, b].map(|m| materials[usize::from(m)].name.as_str());
        (is != was).then(|| OtherMemory {
            pair: format!("`{one}` and `{other}`"),
            is: names(is),
            was: names(was),
        })
    })
}

fn names(laws: [Option<(&str, usize)>; 3]) -> String {
    let names: Vec<String> = (laws.into_iter().flatten())
        .map(|(name, _)| format!("`{name}`"))
        .collect();
    if names.is_empty() {
        "none".to_string()
    } else {
        names.join(", ")
    }
}

/// Refuses laws of a stage that cannot follow those before.
pub(super) fn check(scenario: &Scenario, faults: &mut Diagnostics) {
    if scenario.stage_contacts.is_empty() {
        return;
    }
    let Some(all) = bind(scenario, faults) else { return };
    let Some((first, later)) = all.split_first() else {
        return;
    };
    for told in later {
        if let Some(OtherMemory { pair, is, was }) = other_memory(&told.materials, &first.materials) {
            let message = format!(
                "contacts of {pair} go on with what they remember, which would be that of {is} after that of {was}: laws that remember \
                 something must be the same in all stages"
            );
            let help = "tell the law from the beginning, with a friction of 0 or a pull of 0 until it is to act";
            faults.push(told.spec.table(), message, Some(help.to_string()));
        }
    }
}
