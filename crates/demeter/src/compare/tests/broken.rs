//! Files that are wrong, by chance or on purpose.

use super::*;
use proptest::prelude::*;

/// What reading a series says.
fn refusal(series: &str, reading: &Reading, position: Option<Position>) -> String {
    let place = tempfile::tempdir().unwrap();
    let folder = folder(&place, "run", series);
    read_run(&folder, reading, position).unwrap_err().to_string()
}

#[test]
fn a_series_that_does_not_fit_is_refused_with_the_remedy() {
    let (series, _) = Made::default().texts();
    let told = |load: &str, force: &str| Reading {
        load: load.to_string(),
        force: force.to_string(),
        ..Reading::default()
    };
    let cases: [(String, Reading, Option<Position>, &str); 9] = [
        (
            series.clone(),
            told("squeez", "wall top force z"),
            None,
            "no stage `squeez`, which was told as the loading stage; \
            its stages are `lower`, `squeeze`, `release`",
        ),
        (
            series.replace("release", "let go"),
            Reading::default(),
            None,
            "no stage `release`",
        ),
        (
            series.clone(),
            told("squeeze", "wall top force x"),
            None,
            "no column `wall top force x`; did you mean `wall top force z`?",
        ),
        (
            series.clone(),
            discarding(3),
            None,
            "holds 3 cycles, and the first 3 are to be discarded",
        ),
        (
            series.replace("strain", "other"),
            Reading::default(),
            Some(Position::Strain),
            "tells no strain",
        ),
        (
            series.clone(),
            told("squeeze", "mean force"),
            Some(Position::Compression),
            "`mean force` is not the force of a wall",
        ),
        (
            series.replace(",0.1,1.0,", ",0.01,1.0,"),
            Reading::default(),
            None,
            "stage `squeeze 1`: the strain turns back from 0.05 to 0.01",
        ),
        (
            series.replace("release 2", "release 1"),
            told("squeeze", "nothing"),
            None,
            "no column `nothing`; there are `step`",
        ),
        (
            series.replace("squeeze 2", "release 9"),
            Reading::default(),
            None,
            "both unload after `squeeze 1`",
        ),
    ];
    for (series, reading, position, expected) in cases {
        let found = refusal(&series, &reading, position);
        assert!(found.contains(expected), "{found}\n{expected}");
    }
    let place = tempfile::tempdir().unwrap();
    let error = read_run(place.path(), &Reading::default(), None).unwrap_err();
    assert!(error.to_string().contains("not the folder of a Demeter run"), "{error}");
}

#[test]
fn a_plate_at_rest_makes_no_stroke() {
    let reading = Reading {
        load: "lower".to_string(),
        unload: None,
        ..Reading::default()
    };
    let text = format!("{SERIES}0,0.0,lower,0.0,0.1,1.0,0.0,0.0\n1,0.1,lower,0.1,0.1,1.0,0.0,0.0\n");
    assert!(refusal(&text, &reading, None).contains("1 rows at different strains are too few"));
}

#[test]
fn values_outside_of_the_cycles_may_be_anything() {
    let (series, _) = Made::default().texts();
    let place = tempfile::tempdir().unwrap();
    let odd = series.replacen(",-0.06,", ",NaN,", 1);
    assert_ne!(odd, series);
    let read = read_run(&folder(&place, "odd", &odd), &Reading::default(), None);
    assert_eq!(read.unwrap().loading.len(), 5);
    let odd = series.replacen(",0.05,", ",NaN,", 1);
    let error = refusal(&odd, &Reading::default(), None);
    assert!(
        error.contains("line 4, column `strain`: `NaN` is not a finite number"),
        "{error}"
    );
}

fn with_forces(change: impl Fn(String) -> String, name: &str, told: Option<&str>) -> Result<Strokes, CompareError> {
    let made = Made {
        contacts: Some(|_| ([4, 3, 2, 1, 0], [1; 5])),
        ..Made::default()
    };
    let place = tempfile::tempdir().unwrap();
    let folder = made.write(&place, "run");
    std::fs::write(folder.join("distributions").join(name), change(made.texts().1)).unwrap();
    let reading = Reading {
        distribution: told.map(String::from),
        ..Reading::default()
    };
    read_run(&folder, &reading, None)
}

#[test]
fn distributions_that_do_not_fit_are_refused() {
    let same = |text: String| text;
    assert!(with_forces(same, "forces.csv", Some("forces")).unwrap().bins.is_some());
    assert!(with_forces(same, "other.csv", Some("other")).is_ok());
    let refused =
        |change: &dyn Fn(String) -> String, name: &str, told| with_forces(change, name, told).unwrap_err().to_string();
    let several = refused(&same, "other.csv", None);
    assert!(
        several.contains("2 force distributions, `forces`, `other`: tell which"),
        "{several}"
    );
    assert!(refused(&same, "forces.csv", Some("force")).contains("no force distribution `force`; there are `forces`"));
    let cut = |text: String| text[..text.len() / 2].to_string();
    assert!(refused(&cut, "forces.csv", None).contains("of which the series has a row"));
    let unordered = |text: String| text.replacen("0.001", "0.005", 1);
    assert!(refused(&unordered, "forces.csv", None).contains("do not ascend"));
    let title = |text: String| text.replacen(",0.001 [N],", ",weak,", 1);
    assert!(refused(&title, "forces.csv", None).contains("the column `weak`"));
    let between = |text: String| text.replace("walls", "wall");
    assert!(refused(&between, "forces.csv", None).contains("`wall` is not `grains` or `walls`"));
    let header = |text: String| text.replacen("between", "among", 1);
    assert!(refused(&header, "forces.csv", None).contains("not a force distribution"));
}

#[test]
fn measured_curves_that_do_not_fit_are_refused() {
    for (text, expected) in [
        ("strain,loading force\n0,1\n", "unknown column `loading force`"),
        ("strain,compression [m],loading force [N]\n0,0,1\n", "it has both"),
        ("loading force [N]\n1\n", "it has neither"),
        (
            "strain,loading force [N],loading force [N]\n0,1,2\n",
            "the column `loading force [N]` is there twice",
        ),
        (
            "strain,loading force [N]\n0,1\n0,2\n",
            "two values of loading at a strain of 0",
        ),
        ("strain,loading force [N]\n0,\n", "it holds no values"),
        (
            "strain,loading force [N]\n0,one\n",
            "line 2, column `loading force [N]`: `one` is not a finite number",
        ),
        (
            "strain,loading force [N]\n0,1,2\n",
            "line 2 has 3 cells, the header has 2",
        ),
    ] {
        let found = measured(text).unwrap_err().to_string();
        assert!(found.contains(expected), "{found}\n{expected}");
    }
    let curve = measured("# by hand\ncompression [m], loading force [N]\n0.01, 2\n").unwrap();
    assert_eq!((curve.position, curve.loading.len()), (Position::Compression, 1));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn nothing_that_is_read_panics(cuts in prop::collection::vec((0..4000usize, prop::num::u8::ANY), 0..20), end in 0..6000usize) {
        let made = Made { contacts: Some(|_| ([4, 3, 2, 1, 0], [1; 5])), ..Made::default() };
        let (series, forces) = made.texts();
        let broken = |text: String| {
            let mut bytes = text.into_bytes();
            for (at, byte) in &cuts {
                if let Some(place) = bytes.get_mut(*at) {
                    *place = *byte;
                }
            }
            bytes.truncate(end);
            bytes
        };
        let place = tempfile::tempdir().unwrap();
        let folder = made.write(&place, "run");
        for position in [None, Some(Position::Compression)] {
            std::fs::write(folder.join("distributions/forces.csv"), broken(forces.clone())).unwrap();
            let _ = read_run(&folder, &Reading::default(), position);
            std::fs::write(folder.join("series.csv"), broken(series.clone())).unwrap();
            if let Ok(strokes) = read_run(&folder, &Reading::default(), position) {
                let _ = compare(&strokes, &strokes, Thresholds::default());
            }
            std::fs::write(folder.join("series.csv"), &series).unwrap();
        }
        let path = folder.join("measured.csv");
        std::fs::write(&path, broken("strain,loading force [N]\n0,1\n0.1,2\n".to_string())).unwrap();
        let _ = read_measured(&path);
    }
}
