//! What two texts of a scenario have otherwise, in few words.

use similar::{Algorithm, DiffTag, capture_diff_slices};

/// Most lines, values or places, that are told of a difference.
const MOST_TOLD: usize = 5;

/// The first ones, and how many more there are.
pub(crate) fn shortened(texts: &[String]) -> Vec<String> {
    let mut shown: Vec<String> = texts.iter().take(MOST_TOLD).cloned().collect();
    if texts.len() > MOST_TOLD {
        shown.push(format!("... ({} more)", texts.len() - MOST_TOLD));
    }
    shown
}

/// Lines that are others, place by place; nothing where all are the same.
pub(crate) fn line_differences(was: &str, is: &str) -> Option<String> {
    let [was, is] = [was, is].map(|text| text.lines().filter(|line| !line.is_empty()).collect::<Vec<_>>());
    let quoted = |lines: &[&str]| match lines {
        [] => "nothing".to_string(),
        _ => {
            let lines: Vec<String> = lines.iter().map(ToString::to_string).collect();
            format!("`{}`", shortened(&lines).join(" | "))
        }
    };
    let places = capture_diff_slices(Algorithm::Myers, &was, &is);
    let others = places.iter().filter(|place| place.tag() != DiffTag::Equal);
    let told: Vec<String> = others
        .map(|place| {
            let (is, was) = (quoted(&is[place.new_range()]), quoted(&was[place.old_range()]));
            format!("{is} in place of {was}")
        })
        .collect();
    (!told.is_empty()).then(|| format!("the scenario tells {}", shortened(&told).join(", ")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_place_is_told_and_what_is_the_same_is_not() {
        let was = "a = 1\nb = 2\n\nc = 3\nd = 4\ne = 5";
        assert_eq!(line_differences(was, &was.replace("\n\n", "\n")), None);
        assert_eq!(
            line_differences(was, "a = 7\nb = 2\nc = 3\nd = 4\nx = 1\ny = 2").unwrap(),
            "the scenario tells `a = 7` in place of `a = 1`, `x = 1 | y = 2` in place of `e = 5`"
        );
        assert_eq!(
            line_differences(was, "b = 2\nc = 3\nz = 0\nd = 4\ne = 5").unwrap(),
            "the scenario tells nothing in place of `a = 1`, `z = 0` in place of nothing"
        );
        let many: String = (0..20).map(|k| format!("k = {k}\n")).collect();
        assert!(line_differences("", &many).unwrap().contains("k = 4 | ... (15 more)"));
        let every: String = (0..20).map(|k| format!("same\nk = {k}\n")).collect();
        let told = line_differences(&every, &every.replace("k = ", "l = ")).unwrap();
        assert!(told.ends_with("`l = 4` in place of `k = 4`, ... (15 more)"), "{told}");
    }
}
