//! "Did you mean ...?"

/// The name most like the one given, if any is alike.
pub fn suggestion<'a>(given: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let given = given.to_lowercase();
    let near = |name: &&str| strsim::jaro_winkler(&given, name) > 0.75 || (given.len() > 2 && name.contains(&given));
    let likeness = |name: &&str| strsim::jaro_winkler(&given, name);
    known
        .into_iter()
        .filter(near)
        .max_by(|a, b| likeness(a).total_cmp(&likeness(b)))
}

/// The sentence, or nothing.
pub fn did_you_mean<'a>(given: &str, known: impl IntoIterator<Item = &'a str>) -> String {
    suggestion(given, known).map_or_else(String::new, |name| format!(" Did you mean `{name}`?"))
}
