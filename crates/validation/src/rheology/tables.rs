//! The series as a table and as figures, beside what was measured.

use super::{Point, RheologyError};
use demeter::output::{Look, Plot, Series};
use std::fmt::Write as _;
use std::path::Path;

/// Friction of glass beads at an inertial number, `mu_s + (mu_2 - mu_s)/(I_0/I + 1)` with `mu_s = tan(20.9 deg)`,
/// `mu_2 = tan(32.76 deg)` and `I_0 = 0.279` (Jop, Forterre and Pouliquen, Nature 441, 727, 2006).
pub fn glass_beads(inertial_number: f64) -> f64 {
    let (slow, fast, middle) = (0.382, 0.643, 0.279);
    slow + (fast - slow) / (middle / inertial_number + 1.0)
}

/// Writes `rheology.csv`, `friction.svg` and `solid-fraction.svg` into a folder, and tells the table in Markdown.
pub fn write_tables(points: &[Point], out: &Path) -> Result<String, RheologyError> {
    std::fs::create_dir_all(out).map_err(RheologyError::io(out))?;
    let mut csv = String::from(
        "inertial number,friction,error of friction,glass beads,solid fraction,error of solid fraction,coordination,\
         pressure [Pa],shear rate [1/s],energy residual\n",
    );
    let mut table = String::from(
        "| I | mu | mu of glass beads | solid fraction | coordination | largest residual |\n|---|---|---|---|---|---|\n",
    );
    for p in points {
        let ((mu, mu_error), (phi, phi_error)) = (p.friction, p.solid_fraction);
        let beads = glass_beads(p.inertial_number);
        // writing to a String cannot fail
        let _ = writeln!(
            csv,
            "{:?},{mu:?},{mu_error:?},{beads:?},{phi:?},{phi_error:?},{:?},{:?},{:?},{:?}",
            p.inertial_number, p.coordination, p.pressure, p.rate, p.residual
        );
        let _ = writeln!(
            table,
            "| {:.2e} | {mu:.3} ± {mu_error:.3} | {beads:.3} | {phi:.3} ± {phi_error:.3} | {:.2} | {:.0e} |",
            p.inertial_number, p.coordination, p.residual
        );
    }
    let path = out.join("rheology.csv");
    std::fs::write(&path, csv).map_err(RheologyError::io(&path))?;
    // every tenth of a decade from 1e-3 to 1
    let decades: Vec<f64> = (0..=30).map(|k| f64::from(k) * 0.1 - 3.0).collect();
    let beads = decades.iter().map(|&x| (x, glass_beads(10f64.powf(x)))).collect();
    let over_inertia = |value: fn(&Point) -> f64| -> Vec<(f64, f64)> {
        points.iter().map(|p| (p.inertial_number.log10(), value(p))).collect()
    };
    let friction = Plot {
        title: "Friction of a flow at constant pressure".to_string(),
        x_label: "log10 of the inertial number".to_string(),
        y_label: "shear stress / pressure".to_string(),
        series: vec![
            Series::line("Demeter", over_inertia(|p| p.friction.0)).with(Look::Circles, 0),
            Series::line("glass beads (Jop et al. 2006)", beads).with(Look::Line, 1),
        ],
        ..Plot::default()
    };
    friction.write_svg(&out.join("friction.svg"))?;
    let fraction = Plot {
        title: "Solid fraction of a flow at constant pressure".to_string(),
        x_label: "log10 of the inertial number".to_string(),
        y_label: "solid fraction".to_string(),
        series: vec![Series::line("Demeter", over_inertia(|p| p.solid_fraction.0)).with(Look::Circles, 0)],
        ..Plot::default()
    };
    fraction.write_svg(&out.join("solid-fraction.svg"))?;
    Ok(table)
}

#[cfg(test)]
mod tests {
    use super::glass_beads;

    #[test]
    fn the_law_of_glass_beads_goes_from_its_slow_to_its_fast_limit() {
        assert!((glass_beads(1e-9) - 0.382).abs() < 1e-6);
        assert!((glass_beads(1e9) - 0.643).abs() < 1e-6);
        assert!((glass_beads(0.279) - 0.5 * (0.382 + 0.643)).abs() < 1e-12);
    }
}
