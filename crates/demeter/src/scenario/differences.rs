//! What two texts of a scenario have otherwise, in few words.

/// Most lines, or values, that are told of a difference.
const MOST_TOLD: usize = 5;

/// The first ones, and how many more there are.
pub(crate) fn shortened(texts: &[String]) -> Vec<String> {
    let mut shown: Vec<String> = texts.iter().take(MOST_TOLD).cloned().collect();
    if texts.len() > MOST_TOLD {
        shown.push(format!("... ({} more)", texts.len() - MOST_TOLD));
    }
    shown
}

/// Lines between those with which both texts begin and end; nothing where both are the same.
pub(crate) fn line_differences(was: &str, is: &str) -> Option<String> {
    if was == is {
        return None;
    }
    let (was, is): (Vec<&str>, Vec<&str>) = (was.lines().collect(), is.lines().collect());
    let same = was.iter().zip(&is).take_while(|(a, b)| a == b).count();
    let (was, is) = (&was[same..], &is[same..]);
    let same = was
        .iter()
        .rev()
        .zip(is.iter().rev())
        .take_while(|(a, b)| a == b)
        .count();
    let middle = |lines: &[&str]| -> Vec<String> {
        let lines = lines[..lines.len() - same].iter().filter(|line| !line.is_empty());
        shortened(&lines.map(ToString::to_string).collect::<Vec<_>>())
    };
    let quoted = |lines: Vec<String>| match lines.is_empty() {
        true => "nothing".to_string(),
        false => format!("`{}`", lines.join(" | ")),
    };
    Some(format!(
        "the scenario tells {} in place of {}",
        quoted(middle(is)),
        quoted(middle(was))
    ))
}
