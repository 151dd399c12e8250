//! The figures against the reference numbers of the papers' mathematics.

use super::*;

fn drawn(name: &str) -> Figure {
    let figure = draw_figure(find_figure(name).unwrap()).unwrap();
    let svg = figure.sheet.to_svg();
    assert!(!svg.contains("NaN") && svg.len() > 5000, "{name}");
    assert!(figure.table.rows.iter().all(|r| r.1.len() == figure.table.titles.len()));
    assert!(figure.table.rows.iter().all(|r| r.1.iter().all(|x| x.is_finite())));
    figure
}

fn close(value: f64, expected: f64, relative: f64) {
    assert!((value / expected - 1.0).abs() < relative, "{value} {expected}");
}

fn largest(figure: &Figure, curve: &str, column: usize) -> f64 {
    figure.table.curve(curve).map(|row| row[column]).fold(0.0, f64::max)
}

fn within(figure: &Figure, bounds: &[f64]) {
    assert_eq!(figure.checks.len(), bounds.len());
    for (check, bound) in figure.checks.iter().zip(bounds) {
        assert!(check.largest < *bound, "{check}");
    }
}

#[test]
fn trajectories_of_mcc() {
    let figure = drawn("antypov-1");
    within(&figure, &[1e-9, 1e-9]);
    for way in ["closed form", "integrated"] {
        let hertz = format!("HSD {way}");
        close(largest(&figure, &hertz, 0), 69.51247874e-6, 1e-9);
        let last = figure.table.curve(&hertz).last().unwrap().to_vec();
        close(last[2], -0.54, 1e-9);
        // circles need not lie at the turning point
        close(largest(&figure, &hertz, 1), 17.60955505e-6, 0.01);
    }
}

#[test]
fn contact_times_fall_as_the_fifth_root_of_the_speed() {
    let figure = drawn("antypov-2");
    within(&figure, &[1e-9, 1e-9]);
    for row in figure.table.curve("HSD integrated") {
        // constants of the reference table
        let unit = 64.33145691e-6 * libm::pow(row[1], -0.2);
        if row[0] == 1.0 {
            close(row[2], unit, 1e-9);
        } else if row[0] == 0.1 {
            close(row[2], unit * 1.510659925, 1e-9);
        }
    }
    let linear: Vec<f64> = figure.table.curve("LSD integrated").map(|row| row[2]).collect();
    close(linear[0], linear[6], 1e-9);
    assert_eq!(linear.len(), 21);
}

#[test]
fn damping_makes_contacts_longer() {
    let figure = drawn("antypov-3");
    within(&figure, &[1e-9, 1e-9]);
    let at = |curve: &str, e: f64| {
        let found = figure.table.curve(curve).find(|row| (row[0] - e).abs() < 1e-9);
        found.unwrap()[1]
    };
    close(at("HSD integrated", 0.1), 1.510659925, 1e-9);
    close(at("HSD exact", 0.54), 1.080536367, 1e-9);
    close(at("HSD exact", 0.9), 1.011068126, 1e-9);
    close(at("HSD fit eq 29", 0.01) / at("HSD exact", 0.01) - 1.0, -0.057, 0.02);
    close(at("LSD eq 25", 0.1), 1.2398, 1e-4);
}

#[test]
fn limestone_grains_swing_to_rest() {
    let figure = drawn("jasevicius-3");
    within(&figure, &[1e-9, 1e-6]);
    assert_eq!(figure.sheet.plots.len(), 3);
    let swings = |alpha: f64| {
        let rates: Vec<f64> = (figure.table.curve("sticking"))
            .filter(|row| row[1] == alpha)
            .map(|row| row[4])
            .collect();
        rates.windows(2).filter(|w| w[0] * w[1] < 0.0).count()
    };
    assert!(swings(0.2) > 8 && swings(0.0) > 8);
    // at first touch the grains feel the adhesion of undented surfaces
    close(figure.table.curve("sticking").next().unwrap()[5], -2.64e-9, 1e-6);
}

#[test]
fn limestone_grains_stick_at_2_mm_per_minute_and_part_at_2_m_per_minute() {
    let figure = drawn("jasevicius-4");
    within(&figure, &[1e-9, 1e-6]);
    for alpha in [0.2, 0.3, 0.4, 0.5] {
        let last = |curve: &str| {
            let rows: Vec<&[f64]> = figure.table.curve(curve).filter(|row| row[1] == alpha).collect();
            rows[rows.len() - 1].to_vec()
        };
        let (stuck, parted) = (last("sticking"), last("detachment"));
        assert!(
            stuck[4].abs() < 1e-9 && stuck[3] > 0.0 && stuck[5].abs() < 1e-14,
            "{stuck:?}"
        );
        assert!(parted[4] < -1e-3, "{parted:?}");
    }
}

#[test]
fn critical_velocities_of_the_contact_criterion() {
    let figure = drawn("jasevicius-5");
    within(&figure, &[1e-6, 1e-6]);
    let at = |curve: &str, alpha: f64, radius: f64| {
        let mut rows = figure.table.curve(curve);
        let found = rows.find(|row| row[0] == alpha && (row[1] / radius - 1.0).abs() < 1e-9);
        found.unwrap()[2]
    };
    for (curve, alpha, fine, coarse) in [
        ("elastic", 0.2, 0.0124316, 0.00182471),
        ("elastic", 0.5, 0.0275025, 0.00403681),
        ("elastic-plastic", 0.2, 0.0401245, 0.00220273),
        ("elastic-plastic", 0.5, 0.106624, 0.00576127),
    ] {
        close(at(curve, alpha, 0.1e-6), fine, 1e-5);
        close(at(curve, alpha, 1e-6), coarse, 1e-5);
    }
    let undamped = |radius: f64| limestone::PaperContact::new(radius, 0.0).undamped_sticking_speed();
    close(undamped(limestone::RADIUS).unwrap(), 5.58799563e-3, 1e-8);
    assert_eq!(undamped(1e-6), None);
}

#[test]
fn critical_velocities_of_the_escape_criterion_are_much_larger() {
    let (contact, escape) = (drawn("jasevicius-5"), drawn("jasevicius-5-escape"));
    for (curve, alpha) in [("elastic", 0.2), ("elastic-plastic", 0.5)] {
        let speeds = |figure: &Figure| -> Vec<f64> {
            let rows = figure.table.curve(curve).filter(|row| row[0] == alpha);
            rows.map(|row| row[2]).collect()
        };
        let (near, far) = (speeds(&contact), speeds(&escape));
        assert!(near.len() == far.len() && near.iter().zip(&far).all(|(n, f)| f > &(2.0 * n)));
    }
    // the reference follows the attraction to infinity, the law to a hundred separations
    for (elastic, alpha, expected) in [
        (true, 0.2, 0.0251078),
        (true, 0.5, 0.0523388),
        (false, 0.2, 0.217490),
        (false, 0.5, 1.095307),
    ] {
        let loading = sticking_speed::Loading { alpha, elastic };
        let found = loading.speeds(Start::Far, &[limestone::RADIUS]).unwrap();
        close(found[0].1, expected, 0.01);
    }
}

#[test]
fn names_are_unique_and_found() {
    for (k, figure) in FIGURES.iter().enumerate() {
        assert!(FIGURES[..k].iter().all(|other| other.name != figure.name));
        assert!(find_figure(figure.name).is_some() && !figure.title.is_empty());
    }
    assert!(find_figure("antypov-9").is_none());
}
